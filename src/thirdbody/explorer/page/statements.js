// The paper's statements with their verdicts under the inputs and conditions of the page.

import { change, conditionAxes, content, state } from "./state.js";
import { currentEngine, engineOf, inSlices } from "./engine.js";
import { evidenceOf, judge, replacedConditions } from "./judge.js";
import { verdicts } from "./figures.js";
import { spaced, valueText, wordOf } from "./names.js";
import { escaped, readable, typeset } from "./text.js";

const [list, tally] = ["claims", "tally"].map((id) => document.getElementById(id));
const PAUSE = 150; // milliseconds without a move, after which statements are judged
const GLYPHS = { holds: "✓", fails: "✗" };
const original = new Map(verdicts);
let judged = ""; // the inputs and conditions that verdicts are, or will be, for
let finished = false;

const figureOf = ({ part }) => part.replace(/^Figure (\d+)$/, (_, number) => `fig${number.padStart(2, "0")}`);
const isHere = (claim) => figureOf(claim) === state.figure;
const verdictOf = ({ id }) => verdicts.get(id).verdict;
const verdictBefore = ({ id }) => original.get(id).verdict;
const FILTERS = {
  here: isHere,
  all: () => true,
  fails: (claim) => verdictOf(claim) === "fails",
  changed: (claim) => verdictOf(claim) !== verdictBefore(claim),
};
export const SHOWN = { here: "of the chosen figure", all: "all", fails: "that fail", changed: "changed by your inputs" };

export function makeStatements() {
  list.addEventListener("click", (event) => {
    const id = event.target.closest("button")?.dataset.claim;
    if (id === undefined) return;
    const figure = figureOf(content.claims.find((claim) => claim.id === id));
    const isDrawn = content.figures.some(({ name }) => name === figure);
    if (state.claim === id) change({ claim: "" });
    else change({ claim: id, ...(isDrawn ? { view: "figures", figure } : {}) });
  });
}

// Judge all statements again, those in view first; calls `done` when all are judged.
export function judgeAll(done) {
  const key = JSON.stringify([state.inputs, state.conditions]);
  if (key === judged) return finished ? done() : undefined;
  judged = key;
  finished = false;
  function* steps(changes) {
    const evidence = evidenceOf(currentEngine());
    const isDefault = key === JSON.stringify([{}, {}]);
    for (const claim of d3.sort(content.claims, (each) => !isHere(each))) {
      verdicts.set(claim.id, isDefault ? original.get(claim.id) : judge(claim, evidence, changes));
      yield;
    }
    finished = true;
    done();
  }
  return setTimeout(inSlices, PAUSE, steps(state.conditions), () => key === judged);
}

// Verdicts on all statements under any inputs, by their ids.
export function judgedUnder(inputs) {
  const evidence = evidenceOf(engineOf(inputs));
  return Object.fromEntries(content.claims.map((claim) => [claim.id, judge(claim, evidence)]));
}

export function showStatements() {
  const { show, view, figure, claim } = state;
  const key = JSON.stringify([show, view, figure, claim, judged, [...verdicts.values()]]);
  if (key === list.dataset.shown) return;
  list.dataset.shown = key;
  const shown = content.claims.filter(FILTERS[show]);
  const count = (claims, word) => claims.filter((each) => verdictOf(each) === word).length;
  const counts = (claims) => `${count(claims, "holds")} hold, ${count(claims, "fails")} fail`;
  const chosen = conditionAxes.filter(({ name }) => name in state.conditions).map(({ name }) => wordOf(name).toLowerCase());
  const note = chosen.length ? ` Statements for one ${chosen.join(" or ")} are judged at yours.` : "";
  const ofAll = `of all ${content.claims.length}: ${counts(content.claims)}`;
  tally.textContent = `${shown.length} statements: ${counts(shown)} (${ofAll}).${note}`;
  list.innerHTML = shown.map(item).join("");
}

// The conditions that replace those of the paper, as text.
function replacedText(claim) {
  const replaced = Object.entries(replacedConditions(claim, state.conditions));
  return replaced.map(([name, value]) => valueText(name, value)).join(", ");
}

// The verdict in words. At other conditions than the paper's it is not one on the paper.
function verdictText(claim) {
  const verdict = verdictOf(claim);
  const conditions = replacedText(claim);
  if (conditions && verdict === "holds") return `would hold at ${conditions}`;
  if (conditions && verdict === "fails") return `would not hold at ${conditions}`;
  return verdict === verdictBefore(claim) ? verdict : `${verdict}, ${verdictBefore(claim)} by default`;
}

function item(claim) {
  const verdict = verdictOf(claim);
  const chosen = state.claim === claim.id;
  const changed = verdict === verdictBefore(claim) ? "" : "changed";
  const place = `${claim.place.replace(", section 3.3", "")} — ${verdictText(claim)}`;
  return `<li><button type="button" data-claim="${claim.id}" aria-pressed="${chosen}" class="${verdict} ${changed}">
    <span class="glyph" aria-hidden="true">${GLYPHS[verdict] ?? "·"}</span>
    <span>${typeset(claim.statement)} <span class="place">${typeset(place)}</span></span></button>
    ${chosen ? details(claim) : ""}</li>`;
}

function details(claim) {
  const { measured, numbers, distance } = verdicts.get(claim.id);
  const size = readable(claim.tolerance_kind === "relative" ? 100 * claim.tolerance : claim.tolerance);
  const tolerance = { relative: `${size} %`, factor: `a factor of ${size}`, absolute: size }[claim.tolerance_kind];
  const conditions = replacedText(claim);
  const lines = [
    measured && `Computed: ${measured}`,
    numbers?.length && `Computed: ${numbers.map((value) => readable(value)).join(", ")}`,
    Number.isFinite(distance) && `Distance from the statement: ${readable(Math.max(distance, 0), 2)} tolerances`,
    claim.published !== null && `Printed: ${printedText([claim.published].flat())}`,
    `Tolerance: ${tolerance}, ${claim.reason}`,
    conditions && `Judged at ${conditions}, not at the paper's conditions.`,
  ];
  const paragraphs = lines.filter(Boolean).map((line) => `<p>${typeset(line)}</p>`);
  return `<div class="more"><blockquote>${escaped(claim.quote)}</blockquote>${paragraphs.join("")}</div>`;
}

const printedText = (published) =>
  typeof published[0] === "string" ? published.map(spaced).join(", then ") : published.map((each) => readable(each)).join(" to ");
