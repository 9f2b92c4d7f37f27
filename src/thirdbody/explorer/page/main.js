// The page: tabs, what is drawn, and what changes with the state.

import { CHOICES, change, content, currentInputs, currentPoint, defaultInputs } from "./state.js";
import { fromFragment, onChange, reset, state, toFragment } from "./state.js";
import { makeControls, updateControls } from "./controls.js";
import { figureView } from "./figures.js";
import { axesView } from "./axes.js";
import { MAP_KEY, mapView } from "./map.js";
import { SECTION_KEY, drawSection } from "./section.js";
import { chartIn, sampleOf, widthIn } from "./chart.js";
import { forgetMeasured, readMeasured } from "./measured.js";
import { showPoint, unusual } from "./point.js";
import { judgeAll, judgedUnder, makeStatements, showStatements } from "./statements.js";
import { csvOf, csvOfMap, save, svgOf } from "./download.js";
import { VARIABLES, conditionWords, numberText, stateText, statusText, wordOf } from "./names.js";
import { engineOf } from "./engine.js";
import { escaped, plain, readable, typeset } from "./text.js";

const $ = (id) => document.getElementById(id);
const CAPTIONS = {
  axes: "The heavy curve is at your conditions; move the sliders, or choose other variables above.",
  map: "Colours: contact mode, by the limits 0.05 and 0.95 of A_sa,t*; a full film has none.",
  section: `Surfaces and particles are drawn at random, always the same, from the distributions that the model
    assumes, at the separation that it finds, as in Figures 1 and 2. Particles may be smaller than the gap in
    which they carry load, where the elastic zone h_e of Eqs. 4 and 5 is wide.`,
};
let charts = [];
let csv = null; // gives the numbers that are shown, if there are any

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
  const left = at[0] + 16 + width > innerWidth ? at[0] - width - 16 : at[0] + 16;
  tooltip.style.left = `${Math.max(left, 4)}px`;
  tooltip.style.top = `${Math.max(Math.min(at[1] + 12, innerHeight - height - 4), 4)}px`;
  if (event.type === "keydown") $("live").textContent = plain([label, ...texts].join(", "));
}

const valueText = (name, value) => `${VARIABLES[name].symbol} = ${numberText(name, value)}`;

const hideTooltip = () => $("tooltip").setAttribute("hidden", "");

function drawCharts(specs) {
  const parent = $("charts");
  if (charts.length !== specs.length) {
    parent.replaceChildren();
    charts = specs.map(() => chartIn(parent, { onRead: showTooltip, onLeave: hideTooltip }));
  }
  const widths = charts.map(({ figure }) => widthIn(figure)); // before any of them changes
  specs.forEach((spec, i) => charts[i].update(spec, widths[i]));
}

function showKey(entries) {
  const html = entries.map((entry) => {
    const drawing = `<svg class="chart" width="30" height="14" aria-hidden="true">${sampleOf(entry)}</svg>`;
    return `<span class="entry" data-text="${escaped(entry.text)}">${drawing}<span>${typeset(entry.text)}</span></span>`;
  });
  $("key").innerHTML = html.join("");
}

// Each gives the heading, notes and key of a view, and the specs of its charts, or draws it.
const VIEWS = {
  figures: figureView,
  axes: axesView,
  map() {
    if (!charts.length) $("charts").replaceChildren("Solving all points of the map …");
    mapView((spec) => {
      if (state.view !== "map") return;
      drawCharts([spec]);
      csv = () => csvOfMap(spec);
      $("charts").dataset.done = toFragment();
      showToolbar();
    });
    const notes = conditionWords(currentPoint(), state.map_x, state.map_y);
    return { heading: "Map of modes and regimes", notes, key: MAP_KEY };
  },
  section: () => ({ heading: "The interface at your conditions", notes: [drawSection($("charts"))], key: SECTION_KEY }),
};

// What newtons are: the paper leaves it open.
const newtonsText = () =>
  "In newtons F_t = F_t* A_n E_ss. The paper does not print A_n, the apparent area of the contact; " +
  `it is ${readable(currentInputs().apparent_area * 1e6, 3)} mm² here, one of the inputs.`;

function draw() {
  hideTooltip();
  if ($("charts").dataset.kind !== state.view) {
    $("charts").dataset.kind = state.view;
    $("charts").replaceChildren();
    charts = [];
    csv = null;
  }
  const { heading, notes, key, specs, caption = CAPTIONS[state.view] } = VIEWS[state.view]();
  if (specs) {
    drawCharts(specs);
    csv = () => csvOf(specs);
  }
  showKey(key);
  const hasNewtons = state.view === "map" || specs?.some(({ newtonsPerLoad }) => newtonsPerLoad);
  $("heading").innerHTML = typeset(heading);
  $("notes").innerHTML = typeset([...unusual(), ...notes].join("; "));
  $("caption").innerHTML = typeset(hasNewtons ? `${caption} ${newtonsText()}` : caption);
}

let asked = 0;
let addressing = 0;
function render() {
  asked = 0;
  draw();
  updateControls();
  showToolbar();
  showTabs();
  showPoint($("point"));
  showStatements();
  judgeAll(() => {
    showStatements();
    $("claims").dataset.judged = toFragment();
    if (state.view === "figures" && state.claim) draw();
  });
  clearTimeout(addressing);
  // browsers limit how often the address changes
  addressing = setTimeout(() => history.replaceState(null, "", `#${toFragment()}`), 100);
}

function ask() {
  $("claims").dataset.judged = "not yet";
  asked ||= requestAnimationFrame(render);
}

const tabs = [...$("tabs").children];
tabs.forEach((tab, i) => {
  tab.addEventListener("click", () => change({ view: tab.dataset.view }));
  tab.addEventListener("keydown", ({ key }) => {
    const move = { ArrowLeft: -1, ArrowRight: 1 }[key];
    if (!move) return;
    const next = tabs.at((i + move) % tabs.length);
    next.focus();
    next.click();
  });
});

function showTabs() {
  for (const tab of tabs) {
    const isShown = tab.dataset.view === state.view;
    tab.setAttribute("aria-selected", isShown);
    tab.tabIndex = isShown ? 0 : -1;
  }
  $("view").setAttribute("aria-labelledby", `tab-${state.view}`);
}

const FIGURES = Object.fromEntries(content.figures.map(({ name, title }) => [name, title.split(". ")[0]]));
const SCALES = { auto: "as usual", log: "logarithmic", linear: "linear" };
const TEXTS = { ...FIGURES, ...SCALES, own: "as it is", over_two_body: "over dry two-body" };
for (const select of $("toolbar").querySelectorAll("select")) {
  const text = (value) => TEXTS[value] ?? wordOf(value);
  select.replaceChildren(...CHOICES[select.id].map((value) => new Option(text(value), value)));
}

$("toolbar").addEventListener("change", ({ target: { id, value } }) =>
  change(id === "figure" ? { figure: value, claim: "" } : { [id]: value }),
);
const shownName = () => (state.view === "figures" ? state.figure : state.view);
$("save-csv").addEventListener("click", () => save(`${shownName()}.csv`, "text/csv", csv()));
$("save-svg").addEventListener("click", () => {
  const [figures, entries] = [$("charts").querySelectorAll("figure"), $("key").querySelectorAll(".entry")];
  save(`${shownName()}.svg`, "image/svg+xml", svgOf([...figures], [...entries]));
});

function showToolbar() {
  for (const label of $("toolbar").querySelectorAll("label")) {
    label.hidden = !label.dataset.views.split(" ").includes(state.view);
    const select = label.querySelector("select");
    select.value = state[select.id];
  }
  $("save-csv").disabled = !csv;
  $("save-svg").disabled = !$("charts").querySelector("svg");
}

async function addMeasured([file]) {
  if (!file) return;
  $("measured-text").textContent = readMeasured(file.name, await file.arrayBuffer());
  $("measured").hidden = false;
  ask();
}
$("add-data").addEventListener("click", () => $("file").click());
$("file").addEventListener("change", () => addMeasured($("file").files));
$("forget").addEventListener("click", () => {
  forgetMeasured();
  $("measured").hidden = true;
  $("file").value = "";
  ask();
});
addEventListener("dragover", (event) => event.preventDefault());
addEventListener("drop", (event) => {
  event.preventDefault();
  addMeasured(event.dataTransfer.files);
});

const prefersDark = matchMedia("(prefers-color-scheme: dark)");
function setTheme() {
  const wish = $("theme").value;
  const dark = wish === "auto" ? prefersDark.matches : wish === "dark";
  document.documentElement.dataset.theme = dark ? "dark" : "light";
  if (charts.length) ask();
}
$("theme").addEventListener("change", setTheme);
prefersDark.addEventListener("change", setTheme);
addEventListener("beforeprint", () => {
  document.documentElement.dataset.theme = "light";
  draw();
});
addEventListener("afterprint", setTheme);
$("reset").addEventListener("click", reset);
addEventListener("hashchange", () => fromFragment(location.hash));
addEventListener("resize", ask);

// a page that was saved as it stood has them already
for (const id of ["controls", "filter", "charts"]) $(id).replaceChildren();
$("measured").hidden = true;
if (innerWidth <= 780) document.querySelectorAll("aside .pane").forEach((pane) => (pane.open = false));
setTheme();
makeControls($("controls"));
makeStatements();
onChange(ask);
fromFragment(location.hash);
// To compute with the page in the console or in a test: inputs and conditions in SI, load F_t*.
globalThis.thirdbody = {
  inputs: defaultInputs,
  solve: (inputs, condition, load) => engineOf(inputs).contact(condition).solve(load),
  turningPoint: (inputs, condition) => engineOf(inputs).curve(condition).turningPoint ?? null,
  judge: judgedUnder,
};
