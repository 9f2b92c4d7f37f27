// The statements of the paper have verdicts. The workflow has judged them for the calibrated inputs, and with each
// departure from the print taken back.

import { content } from "./content.js";
import { change, isCalibrated, state } from "./state.js";
import { capital } from "./names.js";
import { readable, typeset } from "./text.js";

const [list, tally, counted] = ["claims", "tally", "counts"].map((id) => document.getElementById(id));
const GLYPHS = { holds: "✓", fails: "✗" };
const UNJUDGED = "Your inputs are not judged. The verdicts are those of the calibrated inputs.";

const figureOf = ({ part }) => content.figures.find((figure) => figure.part === part)?.name;
const FILTERS = {
  here: (statement) => figureOf(statement) === state.figure,
  all: () => true,
  fails: ({ verdict }) => verdict === "fails",
};
export const SHOWN = { here: "of the figure", all: "all", fails: "that fail" };

list.addEventListener("click", (event) => {
  const id = event.target.closest("button")?.dataset.statement;
  if (id === undefined) return;
  const figure = figureOf(content.statements.find((statement) => statement.id === id));
  if (state.statement === id) change({ statement: "" });
  else change({ statement: id, ...(figure ? { view: "figures", figure } : {}) });
});

export function showStatements() {
  const { show, view, figure, statement } = state;
  const key = JSON.stringify([show, view, figure, statement, isCalibrated()]);
  if (key === list.dataset.shown) return;
  list.dataset.shown = key;
  const shown = content.statements.filter(FILTERS[show]);
  const numbers = d3.rollup(shown, ({ length }) => length, ({ verdict }) => verdict);
  const counts = [...numbers].map(([verdict, count]) => `${count} ${verdict.replace(/s$/, "")}`); // 3 hold
  tally.innerHTML = isCalibrated()
    ? `Of ${shown.length} shown: ${d3.sort(counts, (text) => -parseInt(text)).join(", ")}.`
    : `<strong>${UNJUDGED}</strong>`;
  counted.textContent = isCalibrated()
    ? `${content.held} of ${content.judged} distinct statements hold. ${content.counts}`
    : "";
  list.classList.toggle("unjudged", !isCalibrated());
  list.innerHTML = shown.map(item).join("");
}

function item(statement) {
  const { verdict } = statement;
  const chosen = state.statement === statement.id;
  const place = `${statement.place.replace(", section 3.3", "")} — ${verdict}`;
  return `<li><button type="button" data-statement="${statement.id}" aria-pressed="${chosen}" class="${verdict}">
    <span class="glyph" aria-hidden="true">${GLYPHS[verdict] ?? ""}</span>
    <span>${typeset(statement.statement)} <span class="place">${typeset(place)}</span></span></button>
    ${chosen ? details(statement) : ""}</li>`;
}

function details(statement) {
  const { quote, finding, tolerance, tolerance_kind: kind, reason } = statement;
  const size = readable(kind === "relative" ? 100 * tolerance : tolerance);
  const allowed = { relative: `${size} %`, factor: `a factor of ${size}`, absolute: size }[kind];
  const limits = `Tolerance: ${allowed}, ${reason}`;
  // what was found was found for the calibrated inputs
  const lines = isCalibrated() ? [`Found: ${finding}`, limits, ...verdictsTakenBack(statement)] : [limits];
  const paragraphs = lines.map((line) => `<p>${typeset(line)}</p>`);
  return `<div class="more"><blockquote>${typeset(quote)}</blockquote>${paragraphs.join("")}</div>`;
}

// Which departures from the print change the verdict when they are taken back.
function verdictsTakenBack({ verdict, taken_back: takenBack }) {
  const changed = Object.entries(takenBack).filter(([, other]) => other !== verdict);
  const groups = d3.groups(changed, ([, other]) => other);
  return groups.map(([other, names]) => `${capital(other)} if: ${names.map(([name]) => name).join("; ")}`);
}
