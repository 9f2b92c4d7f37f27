// What holds at the chosen conditions, and where the contact mode changes from there.

import { axes, currentPoint, state } from "./state.js";
import { currentEngine } from "./engine.js";
import { changesOf } from "./axes.js";
import { MODE_TEXT, REGIME_TEXT, VARIABLES, conditionWord, numberText, plainSymbol, statusText, wordOf } from "./names.js";

const VALUES = [
  ...["particle_contact_area_ratio", "total_contact_area", "solid_load_fraction", "fluid_load_fraction"],
  ...["separation", "film_thickness"],
];
let shownFor = "";

export function showPoint(parent) {
  const engine = currentEngine();
  const point = currentPoint();
  const key = JSON.stringify([point, state.inputs]);
  if (key === shownFor) return;
  shownFor = key;
  const found = engine.state(point);
  const rows = VALUES.map((name) => [`${VARIABLES[name].words}, ${plainSymbol(VARIABLES[name].symbol)}`, numberText(name, found[name])]);
  const words = found.mode < 0 ? [] : [["Contact mode", MODE_TEXT[found.mode]], ["Lubrication", REGIME_TEXT[found.regime]]];
  if (found.status !== "converged") words.push(["Status", statusText(found.status)]);
  const conditions = axes.map(({ name }) => conditionWord(name, point[name])).join(", ");
  const first = table(`At ${conditions}`, [...words, ...rows]);
  const second = table("Contact mode as one condition changes", axes.map(({ name }) => [wordOf(name), "…"]));
  parent.replaceChildren(first, second);
  // the second table may need other surfaces, which take a moment
  const cells = [...second.querySelectorAll("td")];
  const fill = (i) => {
    if (shownFor !== key || i >= axes.length) return;
    cells[i].textContent = changesOf(axes[i].name, point, engine);
    setTimeout(fill, 0, i + 1);
  };
  setTimeout(fill, 120, 0);
}

function table(title, rows) {
  const made = document.createElement("table");
  made.createCaption().textContent = title;
  for (const [name, text] of rows) {
    const row = made.insertRow();
    row.append(Object.assign(document.createElement("th"), { textContent: name, scope: "row" }));
    row.insertCell().textContent = text;
  }
  return made;
}

