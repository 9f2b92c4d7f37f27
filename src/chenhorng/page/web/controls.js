// Sliders, fields and choices of all conditions and inputs.

import { axes, content, defaultInputs } from "./content.js";
import { BODIES, GRADES, MATERIALS, materialInputs, oilViscosity, speedOf } from "./rig.js";
import { NUMBERS, change, currentInputs, currentPoint, isDefault, state, toDefault } from "./state.js";
import { areHard } from "./model.js";
import { conditionFrom, inputNamed, memberInputs, numberNamed, setCondition, setInputs, toUnit } from "./state.js";
import { isFree } from "./figures.js";
import { VARIABLES, capital, inputWords, letterOf, scaleFor, spaced, unitOf, wordOf } from "./names.js";
import { numberIn, readable, significant, typeset, typesetSymbol } from "./text.js";

const STEPS = 1000; // of a slider
const BACK = '<button type="button" class="back" title="back to the default">↺</button>';
// engineering units of inputs that are given in SI, from the largest on
const SHOWN_IN = {
  ...{ Pa: [["GPa", 1e9]], m2: [["mm²", 1e-6]], "s m-2": [["s m⁻²", 1]], 1: [["", 1]] },
  m: [["mm", 1e-3], ["µm", 1e-6], ["nm", 1e-9]],
};
const SOFTENS = /^(elastic_modulus|hardness_surface)_/;
const RADIUS = "ball_radius"; // stands beside the materials
const PRINTED = ["published", "deduced", "assumed"];

const updates = [];
export const updateControls = () => updates.forEach((update) => update());

export function makeControls(form) {
  form.addEventListener("submit", (event) => event.preventDefault());
  const names = d3.group(Object.keys(content.inputs), kindOf);
  const controls = (kind, control) => (names.get(kind) ?? []).map(control);
  group(form, "Conditions", axes.map(conditionControl));
  group(form, "Ball, flat, particles and oil", rigControls());
  group(form, "Interpretation of the paper", controls("word", wordControl));
  group(form, "Inputs that the paper does not print", controls("unknown", numberControl));
  group(form, "Printed inputs of the equations", controls("printed", numberControl), false);
  updates.push(showRefused);
  updateControls();
}

// While results are those of the last valid values, a line above them says what is refused, and why.
function showRefused() {
  const fields = d3.selectAll('#controls [aria-invalid="true"]').nodes();
  const reasons = fields.map((field) => `${field.labels[0].textContent}: ${field.parentNode.querySelector(".note").textContent}.`);
  d3.select("#refused").text(reasons.length ? `Shown: results of the last valid values. ${reasons.join(" ")}` : "");
}

function kindOf(name) {
  const { allowed, bounds, source } = content.inputs[name];
  if (name === RADIUS) return "rig";
  if (allowed) return "word";
  return PRINTED.includes(source) && !bounds ? "printed" : "unknown";
}

function group(form, title, controls, open = true) {
  const details = d3.select(form).append("details").property("open", open);
  details.append("summary").text(title);
  details.node().append(...controls);
}

// A control has a button that goes back to the default. It shows once the control has been changed.
function controlOf({ id, label, hint, changed, choose }, markup) {
  const control = d3.create("div").attr("class", "control").attr("title", hint);
  control.html(`<label for="${id}">${label}</label>${markup}`);
  const back = control.select(".back").on("click", () => choose(undefined));
  back.attr("aria-label", `default of ${control.select("label").text()}`);
  updates.push(() => control.classed("changed", changed()));
  return control;
}

// A slider has a field beside it. Values are in the unit of the field. `scale` maps them to the steps of the slider.
// `note` is the range, as a text or a function. `read` gives a value in SI, or undefined if it is not allowed.
function rangeControl({ words, symbol, unit, scale, digits, note, value, read, ...given }) {
  const label = `${typeset(words)} ${typesetSymbol(symbol)}${unit && ` [${unit}]`}`;
  const control = controlOf(
    { label, ...given },
    `<input type="range" min="0" max="${STEPS}">
    <input type="text" inputmode="decimal" id="${given.id}" aria-describedby="${given.id}-note">${BACK}
    <small class="note" id="${given.id}-note"></small>`,
  );
  const [slider, field] = control.selectAll("input").nodes();
  function tell(error) {
    field.setAttribute("aria-invalid", Boolean(error));
    const text = error || (note instanceof Function ? note() : note);
    control.select(".note").attr("role", error ? "alert" : null).text(text);
  }
  scale.range([0, STEPS]).clamp(true);
  slider.setAttribute("aria-label", `${control.select("label").text()}, slider`);
  slider.addEventListener("input", () => given.choose(read(Number(scale.invert(slider.value).toPrecision(digits)))));
  field.addEventListener("change", () => {
    const found = read(numberIn(field.value));
    tell(found === undefined && errorIn(field.value, given.hint));
    showRefused();
    if (found !== undefined) given.choose(found);
  });
  updates.push(() => {
    slider.value = Math.round(scale(value()));
    slider.setAttribute("aria-valuetext", `${readable(value())} ${unit}`);
    if (document.activeElement === field && field.ariaInvalid === "true") return;
    field.value = significant(value(), 5);
    tell("");
  });
  return control.node();
}

const errorIn = (text, allowed) =>
  Number.isNaN(numberIn(text))
    ? `“${text}” is not a number such as 1.5, 1000 or 1e11; allowed: ${allowed}`
    : `${text} is out of range; allowed: ${allowed}`;

const rangeText = (ends, factor = 1) => ends.map((end) => readable(end / factor)).join(" to ");

function conditionControl({ name, range: [low, high] }) {
  // a little beyond the paper's range
  const ends = VARIABLES[name].log ? [low / 4, 4 * high] : [0.3 * low, 1.3 * high];
  const dry = name === "viscosity" ? ", 0 is dry" : "";
  const note = `the paper: ${rangeText([low, high])} ${unitOf(name)}${dry}`;
  const control = rangeControl({
    id: `condition-${name}`,
    words: wordOf(name),
    symbol: letterOf(name),
    unit: unitOf(name),
    hint: `${name === "load" || name === "roughness" ? "more than 0" : "0 or more"} ${unitOf(name)}; ${note}`,
    note,
    scale: scaleFor(name).domain(ends),
    digits: 3,
    value: () => toUnit(name, currentPoint()[name]),
    changed: () => name in state.conditions || (name === "viscosity" && state.oil_grade !== ""),
    read: (value) => conditionFrom(name, value),
    choose: (value) => setCondition(name, value),
  });
  updates.push(() => (control.hidden = name !== "load" && isUnused(name)));
  return control;
}

// Whether a condition changes nothing that is shown.
const isUnused = (name) => state.view === "figures" && !isFree(name);

// Materials, size and speed of the bodies in contact, and the oil.
function rigControls() {
  const oil = oilControl();
  const temperature = rigNumber("temperature_C", {
    ...{ words: "Oil temperature", symbol: "T", unit: "°C", note: "gives the viscosity above" },
    scale: d3.scaleLinear([20, 150]),
    read: (value) => (oilViscosity(state.oil_grade, value) ? value : undefined),
  });
  updates.push(() => {
    oil.hidden = isUnused("viscosity");
    temperature.hidden = isUnused("viscosity") || !state.oil_grade;
  });
  return [
    ...BODIES.map(materialControl),
    numberControl(RADIUS),
    rigNumber("speed_m_per_s", {
      ...{ words: "Entrainment speed", symbol: "u", unit: "m/s", note: "(u₁ + u₂)/2, with the oil density below" },
      scale: d3.scaleLog([0.05, 50]),
      value: () => speedOf(currentInputs(), state.oil_density_kg_per_m3),
    }),
    rigNumber("oil_density_kg_per_m3", {
      ...{ words: "Oil density", symbol: "ρ", unit: "kg/m³", note: "mineral oils: 850 to 900" },
      scale: d3.scaleLinear([700, 1100]),
    }),
    oil,
    temperature,
  ];
}

function rigNumber(name, given) {
  return rangeControl({
    id: `rig-${name}`,
    hint: `${rangeText(NUMBERS[name].bounds)} ${given.unit}; ${given.note}`,
    digits: 3,
    value: () => state[name],
    changed: () => !isDefault(name),
    read: (value) => numberNamed(name, value),
    choose: (value) => (value === undefined ? toDefault(name) : change({ [name]: value })),
    ...given,
  });
}

function materialControl(body) {
  const control = choiceControl({
    id: `rig-${body}`,
    label: capital(body),
    hint: `Material of the ${body}: moduli, hardness, G, V and U follow, as in thirdbody bearing; particles are as hard as the surfaces or harder`,
    options: MATERIALS.map((name) => [name, name]),
    value: () => state[body],
    changed: () => !isDefault(body),
    choose: (name) => (name === undefined ? toDefault(body) : change({ [body]: name })),
  });
  updates.push(() => {
    for (const option of control.querySelectorAll("option")) option.disabled = !materialInputs({ ...state, [body]: option.value });
  });
  return control;
}

function oilControl() {
  const isHot = (grade) => grade && !oilViscosity(grade, state.temperature_C);
  return choiceControl({
    id: "rig-oil_grade",
    label: "Oil",
    hint: "The oil's viscosity at its temperature, by ASTM D341; viscosity index 95",
    options: [["", "of the viscosity above"], ...GRADES.map((grade) => [grade, `ISO VG ${grade}, index 95`])],
    value: () => state.oil_grade,
    changed: () => !isDefault("oil_grade"),
    choose: (grade) => change({ oil_grade: grade ?? "", ...(isHot(grade) && { temperature_C: NUMBERS.temperature_C.usual }) }),
  });
}

// What controls of all inputs have in common.
const inputControl = (name) => ({
  id: `input-${name}`,
  changed: () => name in state.inputs,
  choose: (value) => setInputs({ [name]: value }),
});

function numberControl(name) {
  const { bounds, scale, symbol, unit, source, least, most } = content.inputs[name];
  const [text, factor] = SHOWN_IN[unit].find(([, size]) => defaultInputs[name] >= size) ?? SHOWN_IN[unit].at(-1);
  const near = [Math.max(defaultInputs[name] / 4, least), Math.min(defaultInputs[name] * 4, most)];
  const log = scale === "logarithmic" || !bounds;
  return rangeControl({
    ...inputControl(name),
    words: inputWords(name),
    symbol,
    unit: text,
    hint: `${rangeText([least, most], factor)} ${text} (${source})${SOFTENS.test(name) ? ", with an elastic factor of at most 1" : ""}`,
    note: () => (bounds ? `searched ${rangeText(bounds, factor)}; ${ensembleText(name, factor)}` : source),
    scale: (log ? d3.scaleLog() : d3.scaleLinear()).domain((bounds ?? near).map((end) => end / factor)),
    digits: 4,
    value: () => currentInputs()[name] / factor,
    read(value) {
      const found = inputNamed(name, (value * factor).toPrecision(12));
      return found !== undefined && areHard({ ...currentInputs(), [name]: found }) ? found : undefined;
    },
  });
}

// Which values the members of the ensemble have.
function ensembleText(name, factor) {
  const [low, high] = d3.extent(memberInputs(), (member) => member[name]);
  return low === high ? "known" : `ensemble ${rangeText([low, high], factor)}`;
}

// A list of words to choose from.
function choiceControl({ options, value, ...given }) {
  const control = controlOf(given, `<select id="${given.id}"></select>${BACK}`);
  const select = control.select("select").on("change", (event) => given.choose(event.target.value));
  select.node().append(...options.map(([word, text]) => new Option(text, word)));
  updates.push(() => select.property("value", value()));
  return control.node();
}

function wordControl(name) {
  const { allowed, source } = content.inputs[name];
  return choiceControl({
    ...inputControl(name),
    label: inputWords(name),
    hint: `${inputWords(name)} (${source}): one interpretation of the paper`,
    options: allowed.map((word) => [word, spaced(word)]),
    value: () => currentInputs()[name],
    choose: (word) => setInputs({ [name]: word && inputNamed(name, word) }),
  });
}
