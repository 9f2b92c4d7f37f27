// The page: tabs, what is drawn, and what changes with the state.

import { axes, change, content, currentPoint, defaultInputs, fromFragment, onChange, reset, state, toFragment } from "./state.js";
import { makeControls, newtonsText, updateControls } from "./controls.js";
import { figureView } from "./figures.js";
import { axesView } from "./axes.js";
import { mapKey, mapView } from "./map.js";
import { drawSection, sectionKey } from "./section.js";
import { chartIn, markerShape, widthIn } from "./chart.js";
import { forgetMeasured, readMeasured } from "./measured.js";
import { showPoint } from "./point.js";
import { judgeAll, judgedUnder, makeStatements, showStatements } from "./statements.js";
import { csvOf, csvOfMap, save, svgOf } from "./download.js";
import { MODE_TEXT, REGIME_TEXT, VARIABLES, statusText } from "./names.js";
import { conditionWord, letterOf, numberText, plainSymbol, wordOf } from "./names.js";
import { modelOf } from "./model.js";
import { turningPointUnder } from "./engine.js";
import { escaped, readable } from "./text.js";

const $ = (id) => document.getElementById(id);
const CAPTIONS = {
  axes: "The heavy curve is at your conditions; move the sliders, or choose other variables above.",
  map:
    "Colours: contact mode, by the limits 0.05 and 0.95 of A_sa,t*. Blue lines: limits of lubrication regimes. " +
    "Heavy line: turning points of the contact area. The cross is at your conditions.",
  section:
    "Surfaces and particles are drawn at random, always the same, from the distributions that the model assumes, " +
    "at the separation that it finds.",
};
const statements = { filter: $("filter"), list: $("claims"), tally: $("tally") };
let charts = [];
let shown = null; // what can be downloaded

// --- values under the pointer ---

function showTooltip({ spec: { x, y, rows }, label, point, at, event }) {
  const tooltip = $("tooltip");
  const { state: found } = point;
  const isSolved = found?.mode >= 0;
  const more = rows && isSolved ? ["particle_contact_area_ratio", "solid_load_fraction"] : []; // on a map
  const texts = [
    valueText(x.name, point.x) + (x.name === "load" ? ` (${readable(found.normal_load)} N)` : ""),
    valueText(y.name, point.y),
    ...more.map((name) => valueText(name, found[name])),
    isSolved ? `${MODE_TEXT[found.mode]}, ${REGIME_TEXT[found.regime]} lubrication` : "",
    found ? statusText(found.status) : "",
  ].filter(Boolean);
  tooltip.innerHTML = `<b>${escaped(label)}</b>${texts.map((text) => `<div>${escaped(text)}</div>`).join("")}`;
  tooltip.hidden = false;
  const { offsetWidth: width, offsetHeight: height } = tooltip;
  const left = at[0] + 16 + width > innerWidth ? at[0] - width - 16 : at[0] + 16;
  tooltip.style.left = `${Math.max(left, 4)}px`;
  tooltip.style.top = `${Math.max(Math.min(at[1] + 12, innerHeight - height - 4), 4)}px`;
  if (event.type === "keydown") $("live").textContent = [label, ...texts].join(", ");
}

const valueText = (name, value) => `${plainSymbol(VARIABLES[name].symbol)} = ${numberText(name, value)}`;

const hideTooltip = () => {
  $("tooltip").hidden = true;
};

// --- drawing ---

function drawCharts(view, name) {
  const { specs, key } = view;
  const parent = $("charts");
  if (charts.length !== specs.length || parent.dataset.kind !== state.view) {
    parent.replaceChildren();
    parent.dataset.kind = state.view;
    charts = specs.map(() => chartIn(parent, { onRead: showTooltip, onLeave: hideTooltip }));
  }
  const widths = charts.map(({ figure }) => widthIn(figure)); // before any of them changes
  specs.forEach((spec, i) => charts[i].update(spec, widths[i]));
  shown = { csv: () => csvOf(specs), name };
  showKey(key);
  return view;
}

// The key: an entry has a text and a colour with dashes and marker, or a fill.
function showKey(entries) {
  const html = entries.map(({ text, color, fill, dash, marker }) => {
    const line = color ? `<path d="M0,7H30" stroke="${color}" stroke-width="2.2" stroke-dasharray="${dash ?? "none"}"/>` : "";
    const box = fill ? `<rect x="4" y="1" width="22" height="12" fill="${fill}" stroke="var(--soft)"/>` : "";
    const shape = marker === undefined ? "" : markerShape(marker, 40);
    const mark = `<path d="${shape}" fill="${color}" transform="translate(15,7)"/>`;
    const drawing = `<svg width="30" height="14" aria-hidden="true">${line}${box}${mark}</svg>`;
    return `<span class="entry">${drawing}<span>${escaped(text)}</span></span>`;
  });
  $("key").innerHTML = html.join("");
}

// Each draws a view, and returns its heading, notes and, if it has its own, its caption.
const VIEWS = {
  figures: () => drawCharts(figureView(), state.figure),
  axes: () => drawCharts(axesView(), "thirdbody"),
  map() {
    if ($("charts").dataset.kind !== "map") {
      $("charts").replaceChildren("Solving all points of the map …");
      $("key").replaceChildren();
      charts = [];
      shown = null;
    }
    $("charts").dataset.kind = "map";
    mapView((spec) => {
      if (state.view !== "map") return;
      drawCharts({ specs: [spec], key: mapKey() }, "map");
      shown.csv = () => csvOfMap(spec);
      $("charts").dataset.done = toFragment();
      showToolbar();
    });
    const point = currentPoint();
    const others = axes.filter(({ name }) => name !== state.map_x && name !== state.map_y);
    const notes = others.map(({ name }) => conditionWord(name, point[name]));
    return { heading: "Map of modes and regimes", notes };
  },
  section() {
    $("charts").dataset.kind = "section";
    const notes = [drawSection($("charts"))];
    showKey(sectionKey());
    shown = { csv: null, name: "section" };
    return { heading: "The interface at your conditions", notes };
  },
};

let asked = false;
let addressing = 0;
function draw() {
  hideTooltip();
  const { heading, notes, specs = [], caption = CAPTIONS[state.view] } = VIEWS[state.view]();
  const hasNewtons = state.view === "map" || specs.some(({ newtonsPerLoad }) => newtonsPerLoad);
  $("heading").textContent = heading;
  $("notes").textContent = notes.join("; ");
  $("caption").textContent = hasNewtons ? `${caption} ${newtonsText()}` : caption;
}

function render() {
  asked = false;
  draw();
  updateControls();
  showToolbar();
  showTabs();
  showPoint($("point"));
  showStatements(statements);
  judgeAll(() => {
    showStatements(statements);
    $("claims").dataset.judged = toFragment();
    if (state.view === "figures" && state.claim) draw();
  });
  clearTimeout(addressing);
  addressing = setTimeout(showAddress, 100); // browsers limit how often it changes
}

function showAddress() {
  const fragment = toFragment();
  if (location.hash.slice(1) !== fragment) history.replaceState(null, "", `#${fragment}`);
}

function ask() {
  $("claims").dataset.judged = "not yet";
  if (asked) return;
  asked = true;
  requestAnimationFrame(render);
}

// --- tabs and toolbar ---

const tabs = [...$("tabs").children];
$("tabs").addEventListener("click", ({ target }) => target.dataset.view && change({ view: target.dataset.view }));
$("tabs").addEventListener("keydown", (event) => {
  const move = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
  if (!move) return;
  const tab = tabs[(tabs.indexOf(event.target) + move + tabs.length) % tabs.length];
  change({ view: tab.dataset.view });
  tab.focus();
});

function showTabs() {
  for (const tab of tabs) {
    const isShown = tab.dataset.view === state.view;
    tab.setAttribute("aria-selected", isShown);
    tab.tabIndex = isShown ? 0 : -1;
  }
  $("view").setAttribute("aria-labelledby", `tab-${state.view}`);
}

function fillToolbar() {
  const quantities = content.quantities.map((name) => [`${VARIABLES[name].words} ${plainSymbol(VARIABLES[name].symbol)}`, name]);
  const conditions = axes.map(({ name }) => [`${wordOf(name)} ${letterOf(name)}`, name]);
  const figures = content.figures.map(({ name, title }) => [title.split(". ")[0], name]);
  const options = { figure: figures, y: quantities, x: [...conditions, ...quantities] };
  for (const id of ["by", "map_x", "map_y"]) options[id] = conditions;
  for (const [id, texts] of Object.entries(options)) $(id).replaceChildren(...texts.map((each) => new Option(...each)));
}

$("toolbar").addEventListener("change", ({ target: { id, value } }) =>
  change(id === "figure" ? { figure: value, claim: "" } : { [id]: value }),
);
$("save-csv").addEventListener("click", () => save(`${shown.name}.csv`, "text/csv", shown.csv()));
$("save-svg").addEventListener("click", () => {
  const parts = [$("charts").querySelectorAll("figure"), $("key").querySelectorAll(".entry")];
  save(`${shown.name}.svg`, "image/svg+xml", svgOf(...parts.map((found) => [...found])));
});

function showToolbar() {
  for (const label of $("toolbar").querySelectorAll("label")) {
    label.hidden = !label.dataset.views.split(" ").includes(state.view);
    const select = label.querySelector("select");
    select.value = state[select.id];
  }
  $("save-csv").disabled = !shown?.csv;
  $("save-svg").disabled = !shown;
}

// --- measured values ---

async function addMeasured([file]) {
  if (!file) return;
  $("measured-text").textContent = readMeasured(file.name, await file.text());
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

// --- theme, link, print ---

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
$("copy-link").addEventListener("click", async () => {
  const link = `${location.href.split("#")[0]}#${toFragment()}`;
  try {
    await navigator.clipboard.writeText(link);
    $("live").textContent = $("copy-link").textContent = "Link copied";
  } catch {
    prompt("The link that restores this page:", link); // where the clipboard is not allowed
  }
  setTimeout(() => {
    $("copy-link").textContent = "Copy link";
  }, 1500);
});
$("reset").addEventListener("click", reset);
addEventListener("hashchange", () => {
  if (location.hash.slice(1) !== toFragment()) fromFragment(location.hash);
});
let width = innerWidth;
addEventListener("resize", () => {
  if (innerWidth === width) return;
  width = innerWidth;
  ask();
});

// a page that was saved as it stood has them already
for (const id of ["controls", "filter", "charts"]) $(id).replaceChildren();
$("measured").hidden = true;
if (innerWidth <= 780) document.querySelectorAll("aside .pane").forEach((pane) => (pane.open = false));
setTheme();
fillToolbar();
makeControls($("controls"));
makeStatements(statements);
onChange(ask);
fromFragment(location.hash);
// To compute with the page in the console or in a test: inputs and conditions in SI, load F_t*.
globalThis.thirdbody = {
  inputs: defaultInputs,
  solve: (inputs, condition, load) => modelOf(inputs).contact(condition).solve(load),
  turningPoint: turningPointUnder,
  judge: judgedUnder,
};
