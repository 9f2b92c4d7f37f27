// The state at the chosen conditions, and where the contact mode changes from there.

import { axes, content } from "./content.js";
import { currentInputs, currentPoint, memberInputs } from "./state.js";
import { currentEngine, inSlices, memberEngines, placesAlong } from "./engine.js";
import { rangeOf } from "./ranges.js";
import { modeChanges } from "./curves.js";
import { panelsOf } from "./figures.js";
import { REGIME_TEXT, VARIABLES, conditionWord, conditionWords } from "./names.js";
import { FULL_FILM, modeText, notable, numberText, ofCondition, statusText, valueText, withUnit, wordOf } from "./names.js";
import { escaped, plain, readable, typeset } from "./text.js";

const DIGITS = 3; // of numbers without an ensemble
const MOST_DIGITS = 4; // of numbers with one
const SOLVED = content.quantities.filter((name) => name !== "surface_contact_area_ratio");
const VALUES = [...SOLVED, "nominal_area", "nominal_pressure", "hertz_area", "hertz_pressure"];
const ROUNDED = 1e-9; // of an end of the paper's range
const PAUSE = 120; // milliseconds without a move, after which ranges and changes are computed
let shownFor = "";

export function showPoint(parent) {
  const engine = currentEngine();
  const point = currentPoint();
  const panels = panelsOf(point);
  const key = JSON.stringify([point, panels, currentInputs()]);
  if (key === shownFor) return;
  shownFor = key;
  const found = valuesAt(engine, point);
  const words = [
    ["Contact mode", found.regime === FULL_FILM ? "" : modeText(found)],
    ["Lubrication", found.status === "outside_film_formula" ? "" : REGIME_TEXT[found.regime]],
    ["Status", statusText(found.status)],
  ].filter(([, text]) => text);
  const values = VALUES.map((name) => [labelOf(name), numberText(name, found[name], DIGITS), ""]);
  const waiting = axes.map(({ name }) => [wordOf(name), "…"]);
  parent.innerHTML =
    table(`At ${conditionWords(point).join(", ")}${panels && `, as in ${panels}`}`, [...words, ...values], memberInputs().length ? "range of the ensemble" : "") +
    table("Contact mode as one condition changes", waiting) +
    `<p>${typeset(sizesText(engine, point))}</p>`;
  const [answer, changes] = parent.querySelectorAll("tbody");
  // members and modes may need other surfaces, which take a moment
  function* fill() {
    const members = [];
    for (const each of memberEngines()) {
      members.push(valuesAt(each, point));
      yield;
    }
    VALUES.forEach((name, i) => {
      const cells = answer.rows[words.length + i].querySelectorAll("td");
      textsWithRange(name, found, members).forEach((text, place) => (cells[place].innerHTML = typeset(text)));
    });
    for (const [i, { name }] of axes.entries()) {
      changes.rows[i].querySelector("td").innerHTML = typeset(changesText(name, point, engine));
      yield;
    }
  }
  inSlices(parent, fill(), () => shownFor === key, PAUSE);
}

// The state of a point, with the nominal area and pressure and those of the smooth ball on a flat (Hertz).
function valuesAt(engine, point) {
  const { apparent_area: area } = engine.inputs;
  const nominal = { nominal_area: area, nominal_pressure: point.load / area };
  return { ...engine.state(point), ...nominal, ...hertzOf(engine.inputs, point.load) };
}

function hertzOf({ ball_radius: radius, elastic_modulus_surfaces: modulus }, load) {
  const area = Math.PI * ((0.75 * load * radius) / modulus) ** (2 / 3);
  return { hertz_area: area, hertz_pressure: load / area };
}

const labelOf = (name) => `${VARIABLES[name].words}, ${VARIABLES[name].symbol}`;

// The value of a variable, and its range if the members differ.
function textsWithRange(name, found, members) {
  const [low, high] = rangeOf(members.map((member) => notable(name, member[name])));
  if (!(high > low)) return [numberText(name, found[name], DIGITS)];
  const [value, ...range] = supported(name, [found[name], low, high]);
  return [withUnit(name, value), withUnit(name, ...new Set(range))];
}

// A value and the ends of its range as text, to the second digit of their difference.
function supported(name, values) {
  const shown = values.map((value) => value * (VARIABLES[name].factor ?? 1));
  const placeOf = (value) => Math.floor(Math.log10(value)); // of the first digit
  const last = Math.max(placeOf(shown[2] - shown[1]) - 1, placeOf(shown[2]) - MOST_DIGITS + 1);
  return shown.map((value) => readable(value, Math.max(placeOf(value) - last + 1, 1), ""));
}

// What the paper does not have, and what no real interface has.
export function unusual() {
  const point = currentPoint();
  const found = axes.map(({ name, range, scale }) => {
    const [low, high] = range.map((end) => end * scale);
    const value = point[name];
    if (value === 0 || (value >= low * (1 - ROUNDED) && value <= high * (1 + ROUNDED))) return "";
    const ends = withUnit(ofCondition(name), ...range.map((end) => readable(end)));
    return `${wordOf(name).toLowerCase()} ${valueText(name, value)}: the paper has ${ends}`;
  });
  const { inputs } = currentEngine();
  const { hertz_pressure: pressure } = hertzOf(inputs, point.load);
  const softer = Math.min(inputs.hardness_surface_1, inputs.hardness_surface_2);
  if (pressure > softer) {
    const texts = [pressure, softer].map((value) => numberText("hertz_pressure", value, DIGITS));
    found.push(`mean Hertz pressure ${texts[0]}: above the hardness of the softer surface, ${texts[1]}`);
  }
  if (inputs.apparent_area > Math.PI * inputs.ball_radius ** 2) found.push("A_n is larger than the cross-section of the ball");
  return found.filter(Boolean);
}

// What the particles of a size x_a are like.
function sizesText(engine, { load, ...condition }) {
  const contact = engine.contact(condition);
  if (contact.twoBody) return "";
  const text = (length) => numberText("separation", length, DIGITS);
  const { mean, largest } = contact.sizes;
  const scale = conditionWord("particle_diameter", condition.particle_diameter);
  return (
    `The particle size ${scale} is a label: the mean of the sizes is ${text(mean)}, the largest, X_max, ` +
    `${text(largest)}; particles carry load where the separation is below ${text(contact.reach)}.`
  );
}

// Where the contact mode changes along a condition.
function changesText(name, point, engine) {
  const stateAt = (value) => engine.state({ ...point, [name]: value });
  const count = name === "roughness" ? 24 : 60;
  const changes = modeChanges(stateAt, placesAlong(name, point, count));
  if (!changes.length) {
    const text = modeText(stateAt(point[name]));
    return text ? `${text} throughout` : "no solution";
  }
  const parts = changes.map(({ at, to }) => `${to} from ${valueText(name, at, DIGITS)}`);
  return [changes[0].from, ...parts].join(", ");
}

function table(title, rows, heading = "") {
  const cells = (texts) => texts.map((text) => `<td>${typeset(text)}</td>`).join("");
  const lines = rows.map(([name, ...texts]) => `<tr><th scope="row">${typeset(name)}</th>${cells(texts)}</tr>`);
  const head = heading && `<thead><tr><td></td><td></td><th scope="col">${heading}</th></tr></thead>`;
  return `<div class="frame" tabindex="0" role="group" aria-label="${escaped(plain(title))}"><table><caption>${typeset(title)}</caption>${head}<tbody>${lines.join("")}</tbody></table></div>`;
}
