// The paper's statements with their verdicts under the inputs at hand.

import { axes, change, conditionAxes, content, state } from "./state.js";
import { currentEngine } from "./engine.js";
import { conditionsOf, evidenceOf, judge } from "./judge.js";
import { verdicts } from "./figures.js";
import { modelOf } from "./model.js";
import { wordOf } from "./names.js";
import { readable } from "./text.js";

const SLICE = 12; // milliseconds of work before the page may answer
const PAUSE = 150; // milliseconds without a move, after which statements are judged
const GLYPHS = { holds: "✓", fails: "✗" };
const FILTERS = { here: "of this figure", all: "all", fails: "that fail", changed: "changed by your inputs" };
const original = new Map(content.claims.map(({ id, verdict }) => [id, verdict]));
const figureOf = ({ part }) => {
  const found = part.match(/^Figure (\d+)$/);
  return found ? `fig${found[1].padStart(2, "0")}` : "";
};
let running = 0;
let judged = "";
let finished = false;

export function makeStatements({ filter, list }) {
  for (const [word, text] of Object.entries(FILTERS)) filter.append(new Option(text, word));
  filter.addEventListener("change", () => change({ show: filter.value }));
  list.addEventListener("click", (event) => {
    const id = event.target.closest("button")?.dataset.claim;
    if (id === undefined) return;
    const claim = content.claims.find((each) => each.id === id);
    if (state.claim === id) return change({ claim: "" });
    const figure = figureOf(claim);
    const known = content.figures.some(({ name }) => name === figure);
    change({ claim: id, ...(known ? { view: "figures", figure } : {}) });
  });
}

// Judge all statements anew, in slices, those in view first; calls `done` when all are.
export function judgeAll(done) {
  const key = JSON.stringify([state.inputs, state.conditions]);
  if (key === judged) return finished ? done() : undefined;
  judged = key;
  finished = false;
  const mine = ++running;
  const changes = { ...state.conditions };
  delete changes.load;
  if (key === JSON.stringify([{}, {}])) {
    for (const { id, verdict, measured } of content.claims) verdicts.set(id, { verdict, measured });
    finished = true;
    return done();
  }
  const evidence = evidenceOf(currentEngine().model, axes[0].range);
  const waiting = [...content.claims].sort((a, b) => isHere(b) - isHere(a));
  const work = () => {
    if (mine !== running) return undefined;
    const start = performance.now();
    while (waiting.length && performance.now() - start < SLICE) {
      const claim = waiting.shift();
      verdicts.set(claim.id, judge(claim, evidence, conditionAxes, changes));
    }
    if (waiting.length) return setTimeout(work);
    finished = true;
    return done();
  };
  setTimeout(work, PAUSE);
}

// Verdicts on all statements under any inputs, by their ids.
export function judgedUnder(inputs) {
  const evidence = evidenceOf(modelOf(inputs), axes[0].range);
  return Object.fromEntries(
    content.claims.map((claim) => [claim.id, judge(claim, evidence, conditionAxes)]),
  );
}

const isHere = (claim) => state.view !== "figures" || figureOf(claim) === state.figure;

const SHOWN = {
  here: isHere,
  all: () => true,
  fails: ({ id }) => verdicts.get(id).verdict === "fails",
  changed: ({ id }) => verdicts.get(id).verdict !== original.get(id),
};

export function showStatements({ filter, list, tally }) {
  const { show, view, figure, claim } = state;
  const key = JSON.stringify([show, view, figure, claim, judged, [...verdicts.values()]]);
  if (key === list.dataset.shown) return;
  list.dataset.shown = key;
  filter.value = show;
  const shown = content.claims.filter(SHOWN[state.show]);
  const count = (word, claims) => claims.filter(({ id }) => verdicts.get(id).verdict === word).length;
  const [holds, fails] = ["holds", "fails"].map((word) => count(word, shown));
  const all = ["holds", "fails"].map((word) => count(word, content.claims));
  const chosen = conditionAxes.filter(({ name }) => name in state.conditions).map(({ name }) => wordOf(name).toLowerCase());
  const how = chosen.length ? ` Those that name one ${chosen.join(" or ")} are judged at yours.` : "";
  tally.textContent = `${shown.length} statements: ${holds} hold, ${fails} fail (of all ${content.claims.length}: ${all[0]} hold, ${all[1]} fail).${how}`;
  list.replaceChildren(...shown.map(item));
}

function item(claim) {
  const { verdict, measured } = verdicts.get(claim.id);
  const before = original.get(claim.id);
  const chosen = state.claim === claim.id;
  const li = document.createElement("li");
  const button = document.createElement("button");
  button.type = "button";
  button.dataset.claim = claim.id;
  button.setAttribute("aria-pressed", chosen);
  button.className = `${verdict.split(" ")[0]}${verdict === before ? "" : " changed"}`;
  const changed = verdict === before ? "" : `, ${before} by default`;
  button.innerHTML = `<span class="glyph" aria-hidden="true">${GLYPHS[verdict] ?? "·"}</span><span><span class="text"></span> <span class="place"></span></span>`;
  button.querySelector(".text").textContent = claim.statement;
  button.querySelector(".place").textContent = `${claim.place.replace(", section 3.3", "")} — ${verdict}${changed}`;
  li.append(button);
  if (chosen) li.append(more(claim, measured));
  return li;
}

function more(claim, measured) {
  const box = document.createElement("div");
  box.className = "more";
  const quote = document.createElement("blockquote");
  quote.textContent = claim.quote;
  const tolerance = claim.relative ? `${readable(100 * claim.tolerance)} %` : readable(claim.tolerance);
  const lines = [
    `Computed: ${measured || "nothing"}`,
    claim.published == null ? "" : `Printed: ${printed(claim.published)}`,
    `Tolerance: ${tolerance}, ${claim.reason}`,
    replaced(claim),
  ];
  box.append(quote, ...lines.filter(Boolean).map((text) => Object.assign(document.createElement("p"), { textContent: text })));
  return box;
}

const printed = (published) =>
  [published].flat().map((each) => (typeof each === "number" ? readable(each) : each.replaceAll("_", " "))).join(typeof published[0] === "string" ? ", then " : " to ");

// which of the chosen conditions the statement is judged at
function replaced(claim) {
  const plain = conditionsOf(claim, conditionAxes);
  const mine = conditionsOf(claim, conditionAxes, state.conditions);
  const names = conditionAxes.filter(({ name }) => plain.some((each, i) => !Object.is(each[name], mine[i][name])));
  return names.length ? `Judged at your ${names.map(({ name }) => name.replaceAll("_", " ")).join(" and ")}, not at the paper's.` : "";
}
