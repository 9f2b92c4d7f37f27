// The paper's statements with their verdicts under the inputs and conditions of the page.

import { change, content, state } from "./state.js";
import { currentEngine, engineOf, inSlices } from "./engine.js";
import { evidenceOf, judge } from "./judge.js";
import { verdicts } from "./figures.js";
import { spaced } from "./names.js";
import { readable, typeset } from "./text.js";

const [list, tally] = ["claims", "tally"].map((id) => document.getElementById(id));
const PAUSE = 150; // milliseconds without a move, after which statements are judged
const GLYPHS = { holds: "✓", fails: "✗" };
let judged = "{}"; // the inputs that verdicts are, or will be, for
let finished = true;

const figureOf = ({ part }) => content.figures.find((figure) => figure.part === part)?.name;
const isHere = (claim) => figureOf(claim) === state.figure;
const verdictOf = ({ id }) => verdicts.get(id).verdict;
const FILTERS = {
  here: isHere,
  all: () => true,
  fails: (claim) => verdictOf(claim) === "fails",
  changed: (claim) => verdictOf(claim) !== claim.verdict,
};
export const SHOWN = { here: "of the chosen figure", all: "all", fails: "that fail", changed: "changed by your inputs" };

list.addEventListener("click", (event) => {
  const id = event.target.closest("button")?.dataset.claim;
  if (id === undefined) return;
  const figure = figureOf(content.claims.find((claim) => claim.id === id));
  if (state.claim === id) change({ claim: "" });
  else change({ claim: id, ...(figure ? { view: "figures", figure } : {}) });
});

// Judge all statements again, those in view first; calls `done` when all are judged.
export function judgeAll(done) {
  const key = JSON.stringify(state.inputs);
  if (key === judged) return finished ? done() : undefined;
  judged = key;
  finished = false;
  function* steps() {
    const evidence = evidenceOf(currentEngine());
    for (const claim of d3.sort(content.claims, (each) => !isHere(each))) {
      verdicts.set(claim.id, key === "{}" ? claim : judge(claim, evidence));
      yield;
    }
    finished = true;
    done();
  }
  return setTimeout(inSlices, PAUSE, steps(), () => key === judged);
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
  const place = show === "here" ? content.figures.find(({ name }) => name === figure).part : "Shown";
  const numbers = d3.rollup(shown, ({ length }) => length, verdictOf);
  const words = [...numbers].map(([verdict, count]) => `${count} ${verdict.replace(/s$/, "")}`); // 3 hold
  tally.textContent = `${place}, ${shown.length} statements: ${d3.sort(words, (word) => -parseInt(word)).join(", ")}.
    Repeats counted once, ${heldOnce(shown)}; of the whole paper ${heldOnce(content.claims)}. Judged at the paper's conditions.`;
  list.innerHTML = shown.map(item).join("");
}

// How many hold of those that hold or fail. Of statements that repeat each other one counts, and holds if all do.
function heldOnce(claims) {
  const judged = claims.filter((claim) => verdictOf(claim) in GLYPHS);
  const allHold = (cluster) => cluster.every((claim) => verdictOf(claim) === "holds");
  const held = d3.rollup(judged, allHold, (claim) => claim.counted_as);
  return `${d3.sum(held.values())} of ${held.size} hold`;
}

function item(claim) {
  const verdict = verdictOf(claim);
  const chosen = state.claim === claim.id;
  const changed = verdict === claim.verdict ? "" : "changed";
  const words = changed ? `${verdict}, ${claim.verdict} by default` : verdict;
  const place = `${claim.place.replace(", section 3.3", "")} — ${words}`;
  return `<li><button type="button" data-claim="${claim.id}" aria-pressed="${chosen}" class="${verdict} ${changed}">
    <span class="glyph" aria-hidden="true">${GLYPHS[verdict] ?? "·"}</span>
    <span>${typeset(claim.statement)} <span class="place">${typeset(place)}</span></span></button>
    ${chosen ? details(claim) : ""}</li>`;
}

function details(claim) {
  const { measured, numbers, distance } = verdicts.get(claim.id);
  const size = readable(claim.tolerance_kind === "relative" ? 100 * claim.tolerance : claim.tolerance);
  const tolerance = { relative: `${size} %`, factor: `a factor of ${size}`, absolute: size }[claim.tolerance_kind];
  const lines = [
    measured && `Computed: ${measured}`,
    numbers?.length && `Computed: ${numbers.map((value) => readable(value)).join(", ")}`,
    Number.isFinite(distance) && `Distance from the statement: ${readable(Math.max(distance, 0), 2)} tolerances`,
    claim.published !== null && `Printed: ${printedText([claim.published].flat())}`,
    `Tolerance: ${tolerance}, ${claim.reason}`,
  ];
  const paragraphs = lines.filter(Boolean).map((line) => `<p>${typeset(line)}</p>`);
  return `<div class="more"><blockquote>${typeset(claim.quote)}</blockquote>${paragraphs.join("")}</div>`;
}

const printedText = (published) =>
  typeof published[0] === "string" ? published.map(spaced).join(", then ") : published.map((each) => readable(each)).join(" to ");
