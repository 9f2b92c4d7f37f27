// The page has tabs. This draws what a tab shows, and draws it again when the state changes.

import { content, defaultInputs } from "./content.js";
import { CHOICES, change, changedInputs, currentInputs, currentPoint, memberInputs } from "./state.js";
import { fromFragment, onChange, state, toFragment } from "./state.js";
import { makeControls, updateControls } from "./controls.js";
import { figureView } from "./figures.js";
import { mapTitle, mapView } from "./map.js";
import { chartIn, sampleOf } from "./chart.js";
import { showPoint, unusual } from "./point.js";
import { SHOWN, showStatements } from "./statements.js";
import { csvOf, save, svgOf } from "./download.js";
import { VARIABLES, conditionWords, numberText, stateText, statusText, wordOf } from "./names.js";
import { definition, rangeSteps } from "./ranges.js";
import { engineOf, finishAll, inSlices } from "./engine.js";
import { escaped, plain, readable, typeset } from "./text.js";

const $ = (id) => document.getElementById(id);
const CAPTIONS = {
  map: `Colours: contact mode, by the limits 0.05 and 0.95 of A_sa,t*; a full film has none. The line of the turning
    points ends where no maximum of A_sa,t* stands out by 0.02 within these loads.`,
};
const PAPER = "680px"; // width of a page between its margins
const PAUSE = 150; // milliseconds without a move, after which ranges are computed
let charts = [];
let shown = []; // the specs of charts of curves

function showTooltip({ spec: { x, y, rows }, label, point, at, event }) {
  const tooltip = $("tooltip");
  const { state: found } = point;
  const isSolved = found?.mode >= 0;
  const more = rows && isSolved ? ["particle_contact_area_ratio", "solid_load_fraction"] : []; // on a map
  const texts = [
    valueText(x.name, point.x) + (x.name === "load" ? ` (${readable(found.normal_load)} N)` : ""),
    valueText(y.name, point.y),
    ...more.map((name) => valueText(name, found[name])),
    isSolved ? stateText(found) : "",
    found ? statusText(found.status) : "",
  ].filter(Boolean);
  tooltip.innerHTML = `<b>${typeset(label)}</b>${texts.map((text) => `<div>${typeset(text)}</div>`).join("")}`;
  tooltip.hidden = false;
  const { offsetWidth: width, offsetHeight: height } = tooltip;
  tooltip.style.left = `${Math.max(Math.min(at[0] + 16, innerWidth - width - 4), 4)}px`;
  tooltip.style.top = `${Math.max(Math.min(at[1] + 12, innerHeight - height - 4), 4)}px`;
  if (event.type === "keydown") $("live").textContent = plain([label, ...texts].filter(Boolean).join(", "));
}

const valueText = (name, value) => `${VARIABLES[name].symbol} = ${numberText(name, value)}`;

const hideTooltip = () => $("tooltip").setAttribute("hidden", "");

function drawCharts(specs) {
  const parent = $("charts");
  if (charts.length !== specs.length) {
    parent.replaceChildren();
    charts = specs.map(() => chartIn(parent, { onRead: showTooltip, onLeave: hideTooltip }));
  }
  return specs.flatMap((spec, i) => charts[i](spec));
}

function showKey(entries) {
  const html = entries.map((entry) => {
    const drawing = `<svg class="chart" width="30" height="14" aria-hidden="true">${sampleOf(entry)}</svg>`;
    return `<span class="entry" data-text="${escaped(entry.text)}">${drawing}<span>${typeset(entry.text)}</span></span>`;
  });
  $("key").innerHTML = html.join("");
}

// Each view gives its heading and notes. It gives the specs of its charts and their key, or draws them itself.
const VIEWS = {
  figures: figureView,
  map() {
    if (!charts.length) $("charts").replaceChildren("Solving all points of the map …");
    mapView($("charts"), (spec, key) => {
      showKey([...drawCharts([spec]), ...key]);
      showChoices();
    });
    const notes = conditionWords(currentPoint(), state.map_x, state.map_y);
    return { heading: mapTitle(), notes };
  },
};

// The paper leaves open what newtons are.
const newtonsText = () =>
  "In newtons F_t = F_t* A_n E_ss. The paper does not print A_n, the nominal area of the contact; " +
  `it is ${readable(currentInputs().apparent_area * 1e6, 3)} mm² here, one of the inputs.`;

function draw() {
  hideTooltip();
  if ($("charts").dataset.kind !== state.view) {
    $("charts").dataset.kind = state.view;
    $("charts").replaceChildren();
    charts = [];
    showKey([]);
  }
  const { heading, notes, key, specs, caption = CAPTIONS[state.view] ?? "" } = VIEWS[state.view]();
  if (specs) drawCharts((shown = specs));
  const ranged = specs?.flatMap((spec) => spec.ranged ?? []) ?? [];
  if (ranged.length) inSlices($("charts"), rangeSteps(ranged, draw), () => state.view === "figures", PAUSE);
  if (key) showKey(key);
  $("heading").innerHTML = typeset(heading);
  $("definition").textContent = definition();
  $("notes").innerHTML = [...unusual().map((text) => `<strong>${typeset(text)}</strong>`), ...notes.map(typeset)].join("; ");
  $("caption").innerHTML = typeset(`${caption} ${newtonsText()}`);
  $("damaged").textContent = state.damage;
}

let asked = 0;
let addressing = 0;
function render() {
  asked = 0;
  draw();
  updateControls();
  showChoices();
  showPoint($("point"));
  showStatements();
  document.body.dataset.shown = toFragment();
  clearTimeout(addressing);
  // browsers limit how often the address changes
  addressing = setTimeout(() => history.replaceState(null, "", `#${toFragment()}`), 100);
}

function ask() {
  delete document.body.dataset.shown;
  asked ||= requestAnimationFrame(render);
}

const FIGURES = Object.fromEntries(content.figures.map(({ name, part }) => [name, part]));
const TEXTS = { ...FIGURES, ...SHOWN, auto: "as usual", log: "logarithmic", linear: "linear" };
for (const select of document.querySelectorAll("select[name]")) {
  const text = (value) => TEXTS[value] ?? wordOf(value);
  select.replaceChildren(...CHOICES[select.name].map((value) => new Option(text(value), value)));
}

document.addEventListener("change", ({ target: { name, value } }) => {
  if (name in CHOICES) change(name === "figure" ? { figure: value, statement: "" } : { [name]: value });
});
const shownName = () => (state.view === "figures" ? state.figure : state.view);
$("save-csv").addEventListener("click", () => save(`${shownName()}.csv`, "text/csv", csvOf(shown)));
$("save-svg").addEventListener("click", () => save(`${shownName()}.svg`, "image/svg+xml", svgOf($("charts"), $("key"))));

function showChoices() {
  for (const each of document.querySelectorAll("input[name], select[name]")) {
    if (each.type === "radio") each.checked = each.value === state.view;
    else each.value = state[each.name];
  }
  document.querySelector("[name=show] [value=here]").textContent = `of ${FIGURES[state.figure]}`;
  for (const each of document.querySelectorAll("[data-views]")) {
    each.hidden = !each.dataset.views.split(" ").includes(state.view);
  }
  $("save-svg").disabled = !$("charts").querySelector("svg");
}

document.querySelector(".skip").addEventListener("click", (event) => {
  event.preventDefault(); // the fragment of the address is the state
  $("view").focus();
});
$("reset").addEventListener("click", () => fromFragment("")); // also where the address does not change
addEventListener("hashchange", () => fromFragment(location.hash));
addEventListener("resize", () => requestAnimationFrame(draw));
// On paper charts are about as wide as they were drawn, so that their texts keep their size.
function drawWithin(width) {
  $("drawing").style.width = width;
  draw();
}
addEventListener("beforeprint", () => {
  drawWithin(PAPER);
  finishAll();
});
addEventListener("afterprint", () => drawWithin(""));


// a page that was saved as it stood has them already
for (const id of ["controls", "charts"]) $(id).replaceChildren();
if (innerWidth <= 780) document.querySelectorAll("aside .pane").forEach((pane) => (pane.open = false));
makeControls($("controls"));
onChange(ask);
fromFragment(location.hash);
// To compute with the page in the console or in a test: inputs and conditions in SI, load F_t*.
globalThis.thirdbody = {
  inputs: defaultInputs,
  changed: changedInputs,
  members: memberInputs,
  solve: (inputs, condition, load) => engineOf(inputs).contact(condition).solve(load),
  turningPoint: (inputs, condition) => engineOf(inputs).curve(condition).turningPoint ?? null,
};
