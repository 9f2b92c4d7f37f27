// The page: tabs, what is drawn, and what changes with the state.

import { axes, change, content, currentPoint, defaultInputs, fromFragment, onChange, reset, state, toFragment } from "./state.js";
import { makeControls, updateControls } from "./controls.js";
import { figureView, verdicts } from "./figures.js";
import { axesView } from "./axes.js";
import { drawMap, mapKey, mapView } from "./map.js";
import { drawSection, sectionKey } from "./section.js";
import { chartIn } from "./chart.js";
import { showPoint } from "./point.js";
import { judgeAll, judgedUnder, makeStatements, showStatements } from "./statements.js";
import { csvOf, csvOfMap, saveCsv, saveSvg, svgOf } from "./download.js";
import { MODE_TEXT, REGIME_TEXT, VARIABLES, conditionWord, letterOf, numberText, plainSymbol, statusText, wordOf } from "./names.js";
import { modelOf } from "./model.js";
import { turningPointBetween } from "./curves.js";
import { readable } from "./text.js";

const $ = (id) => document.getElementById(id);
const TABS = { figures: "Figures", axes: "Any axes", map: "Map", section: "Cut" };
const statements = { filter: $("filter"), list: $("claims"), tally: $("tally") };
let charts = [];
let shown = null; // what can be downloaded

// --- reading a chart ---

function showReading({ at, label, rows, event }) {
  const tooltip = $("tooltip");
  tooltip.replaceChildren(Object.assign(document.createElement("b"), { textContent: label }));
  for (const row of rows) tooltip.append(Object.assign(document.createElement("div"), { textContent: row }));
  tooltip.hidden = false;
  const { offsetWidth: width, offsetHeight: height } = tooltip;
  const left = at[0] + 16 + width > innerWidth ? at[0] - width - 16 : at[0] + 16;
  tooltip.style.left = `${Math.max(left, 4)}px`;
  tooltip.style.top = `${Math.max(Math.min(at[1] + 12, innerHeight - height - 4), 4)}px`;
  if (event.type === "keydown") $("live").textContent = [label, ...rows].join(", ");
}

const hideReading = () => {
  $("tooltip").hidden = true;
};

const stateRows = (found) =>
  !found || found.mode < 0
    ? [found ? statusText(found.status) : ""].filter(Boolean)
    : [`${MODE_TEXT[found.mode]}, ${REGIME_TEXT[found.regime]} lubrication`, statusText(found.status)].filter(Boolean);

function readChart({ chart, line, point, at, event }) {
  const { x, y } = chart.spec;
  const value = (name, number) => `${plainSymbol(VARIABLES[name].symbol)} = ${numberText(name, number)}`;
  const newtons = x.name === "load" ? ` (${readable(point.state.normal_load)} N)` : "";
  showReading({ at, event, label: line.label, rows: [value(x.name, point.x) + newtons, value(y.name, point.y), ...stateRows(point.state)] });
}

function readMap({ label, cell, at, event }) {
  const names = ["particle_contact_area_ratio", "solid_load_fraction"];
  const rows = names.map((name) => `${plainSymbol(VARIABLES[name].symbol)} = ${numberText(name, cell[name])}`);
  showReading({ at, event, label, rows: cell.mode < 0 ? stateRows(cell) : [...rows, ...stateRows(cell)] });
}

// --- drawing ---

function drawCharts(view) {
  const parent = $("charts");
  if (charts.length !== view.specs.length || parent.dataset.kind !== "charts") {
    parent.replaceChildren();
    parent.dataset.kind = "charts";
    charts = view.specs.map(() => chartIn(parent, { onRead: readChart, onLeave: hideReading }));
  }
  const rooms = charts.map((chart) => chart.room());
  view.specs.forEach((spec, i) => charts[i].update(spec, rooms[i]));
  shown = { csv: () => csvOf(view.specs), name: state.view === "figures" ? state.figure : "thirdbody" };
  showKey(view.key.map(({ label, color, dash, marker, mine }) => ({ text: mine ? `${label} (yours)` : label, stroke: color, dash, marker })), view.parameter);
}

const MARKERS = [d3.symbolCircle, d3.symbolSquare, d3.symbolTriangle, d3.symbolDiamond, d3.symbolCross, d3.symbolWye];

function showKey(entries) {
  const html = entries.map(({ stroke, fill, dash, marker }) => {
    const line = stroke ? `<path d="M0,7H30" stroke="${stroke}" stroke-width="2.2" stroke-dasharray="${dash ?? ""}"/>` : "";
    const box = fill ? `<rect x="4" y="1" width="22" height="12" fill="${fill}" stroke="var(--soft)"/>` : "";
    const mark = marker === undefined ? "" : `<path d="${d3.symbol(MARKERS[marker % MARKERS.length], 40)()}" fill="${stroke}" transform="translate(15,7)"/>`;
    return `<span class="entry"><svg width="30" height="14" aria-hidden="true">${line}${box}${mark}</svg><span></span></span>`;
  });
  $("key").innerHTML = html.join("");
  $("key").querySelectorAll(".entry > span").forEach((span, i) => {
    span.textContent = entries[i].text;
  });
}

const CAPTIONS = {
  axes: () => "The curve of your conditions is drawn heavy; move the sliders, or choose other variables above.",
  map: () =>
    "Colours: contact mode (A_sa,t* of 0.05 and 0.95); blue lines: lubrication regime (L_s of 0.90 and 0.03); the heavy line joins the turning points of the contact area. The cross is at your conditions.",
  section: () =>
    "Surfaces and particles are drawn by chance, always the same, from the distributions that the model assumes, at the separation that it finds.",
};

const VIEWS = {
  figures() {
    const view = figureView();
    drawCharts(view);
    $("heading").textContent = view.figure.title;
    $("notes").textContent = view.notes.join("; ");
    $("caption").textContent = view.figure.caption;
  },
  axes() {
    const view = axesView();
    drawCharts(view);
    $("heading").textContent = view.specs[0].title;
    $("notes").textContent = view.notes.join(", ");
  },
  map() {
    $("heading").textContent = "Map of modes and regimes";
    const { map_x: x, map_y: y } = state;
    const point = currentPoint();
    const held = axes.map(({ name }) => name).filter((name) => name !== x && name !== y);
    $("notes").textContent = held.map((name) => conditionWord(name, point[name])).join(", ");
    if ($("charts").dataset.kind !== "map") {
      $("charts").replaceChildren("Solving all points of the map …");
      $("key").replaceChildren();
      shown = null;
    }
    $("charts").dataset.kind = "map";
    mapView((found) => {
      if (state.view !== "map") return;
      const drawn = drawMap($("charts"), found, { onRead: readMap, onLeave: hideReading });
      showKey(mapKey(drawn.fills));
      shown = { csv: () => csvOfMap(found), name: "map" };
      $("charts").dataset.done = toFragment();
      showToolbar();
    });
  },
  section() {
    $("heading").textContent = "The interface at your conditions";
    $("charts").dataset.kind = "section";
    const { words = "No separation balances the load." } = drawSection($("charts"));
    $("notes").textContent = words;
    showKey(sectionKey());
    shown = { csv: null, name: "section" };
  },
};

let asked = false;
let addressing = 0;
export function draw() {
  const start = performance.now();
  hideReading();
  VIEWS[state.view]();
  if (CAPTIONS[state.view]) $("caption").textContent = CAPTIONS[state.view]();
  $("view").dataset.milliseconds = (performance.now() - start).toFixed(1);
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
  addressing = setTimeout(showAddress, 100); // browsers count how often it changes
}

function showAddress() {
  const fragment = toFragment();
  if (location.hash.slice(1) !== fragment) history.replaceState(null, "", `#${fragment}`);
}

const ask = () => {
  $("claims").dataset.judged = "not yet";
  if (asked) return;
  asked = true;
  requestAnimationFrame(render);
};

// --- tabs and toolbar ---

function makeTabs() {
  for (const [view, text] of Object.entries(TABS)) {
    const button = Object.assign(document.createElement("button"), { type: "button", textContent: text, id: `tab-${view}` });
    button.setAttribute("role", "tab");
    button.setAttribute("aria-controls", "view");
    button.addEventListener("click", () => change({ view }));
    $("tabs").append(button);
  }
  $("tabs").addEventListener("keydown", (event) => {
    const move = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (!move) return;
    const names = Object.keys(TABS);
    const view = names[(names.indexOf(state.view) + move + names.length) % names.length];
    change({ view });
    $(`tab-${view}`).focus();
  });
}

function showTabs() {
  for (const view of Object.keys(TABS)) {
    const button = $(`tab-${view}`);
    button.setAttribute("aria-selected", view === state.view);
    button.tabIndex = view === state.view ? 0 : -1;
    if (view === state.view) $("view").setAttribute("aria-labelledby", button.id);
  }
}

function choice(id, label, options, views) {
  const made = document.createElement("label");
  made.append(`${label} `);
  const select = Object.assign(document.createElement("select"), { id });
  for (const [word, text] of options) select.append(new Option(text, word));
  select.addEventListener("change", () => change({ [id]: select.value, ...(id === "figure" ? { claim: "" } : {}) }));
  made.append(select);
  made.dataset.views = views;
  return made;
}

function makeToolbar() {
  const quantities = Object.keys(content.quantities).map((name) => [name, `${VARIABLES[name].words} ${plainSymbol(VARIABLES[name].symbol)}`]);
  const conditions = axes.map(({ name }) => [name, `${wordOf(name)} ${letterOf(name)}`]);
  const scales = [["auto", "as usual"], ["log", "logarithmic"], ["linear", "linear"]];
  const figures = content.figures.map(({ name, title }) => [name, title.split(". ")[0]]);
  $("toolbar").append(
    choice("figure", "Show", figures, "figures"),
    choice("y", "Show", quantities, "axes"),
    choice("x", "over", [...conditions, ...quantities], "axes"),
    choice("by", "for several values of", conditions, "axes"),
    choice("map_x", "Across", conditions, "map"),
    choice("map_y", "upwards", conditions, "map"),
    choice("x_scale", "x scale", scales, "figures axes"),
    choice("y_scale", "y scale", scales, "figures axes"),
    choice("area", "Aₜ*", [["own", "as it is"], ["over_two_body", "over dry two-body"]], "figures axes"),
  );
  const push = Object.assign(document.createElement("span"), { className: "push" });
  const buttons = [
    ["csv", "CSV", () => saveCsv(shown.name, shown.csv())],
    ["svg", "SVG", () => saveSvg(shown.name, svgOf(...[$("charts").querySelectorAll("figure"), $("key").querySelectorAll(".entry")].map((found) => [...found])))],
  ];
  for (const [id, text, act] of buttons) {
    const button = Object.assign(document.createElement("button"), { type: "button", id: `save-${id}`, textContent: text, title: `Download what is shown as ${text}` });
    button.addEventListener("click", act);
    push.append(button);
  }
  $("toolbar").append(push);
}

function showToolbar() {
  for (const label of $("toolbar").querySelectorAll("label")) {
    label.hidden = !label.dataset.views.split(" ").includes(state.view);
    const select = label.querySelector("select");
    select.value = state[select.id];
  }
  $("save-csv").disabled = !shown?.csv;
  $("save-svg").disabled = !shown;
}

// --- theme, link, print ---

const prefersDark = matchMedia("(prefers-color-scheme: dark)");
function setTheme() {
  const wish = $("theme").value;
  const dark = wish === "auto" ? prefersDark.matches : wish === "dark";
  document.documentElement.dataset.theme = dark ? "dark" : "light";
}
$("theme").addEventListener("change", () => {
  setTheme();
  ask();
});
prefersDark.addEventListener("change", () => {
  setTheme();
  ask();
});
addEventListener("beforeprint", () => {
  document.documentElement.dataset.theme = "light";
  draw();
});
addEventListener("afterprint", () => {
  setTheme();
  draw();
});
$("copy-link").addEventListener("click", async () => {
  const link = `${location.href.split("#")[0]}#${toFragment()}`;
  try {
    await navigator.clipboard.writeText(link);
    $("live").textContent = $("copy-link").textContent = "Link copied";
  } catch {
    prompt("The link that restores this page:", link); // where a browser keeps its clipboard to itself
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
for (const id of ["tabs", "toolbar", "controls", "filter", "charts"]) $(id).replaceChildren();
if (innerWidth <= 780) document.querySelectorAll("#inputs .pane, #statements .pane").forEach((pane) => (pane.open = false));
setTheme();
makeTabs();
makeToolbar();
makeControls($("controls"));
makeStatements(statements);
onChange(ask);
fromFragment(location.hash);
// For whoever wants to compute with the page, in the console or in a test: inputs and conditions in SI,
// load F_t*.
globalThis.thirdbody = {
  inputs: defaultInputs,
  solve: (inputs, condition, load) => modelOf(inputs).contact(condition).solve(load),
  turningPoint: (inputs, condition) => {
    const model = modelOf(inputs);
    const loads = axes[0].range.map((force) => force / model.newtonsPerLoad);
    return turningPointBetween(model.contact(condition), ...loads);
  },
  judge: judgedUnder,
};
