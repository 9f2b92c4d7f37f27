// Measured values from a CSV file, which are drawn over the curves.

import { axes, conditionAxes, content } from "./state.js";
import { VARIABLES, ofCondition, spaced } from "./names.js";
import { numberIn } from "./text.js";

// headings of a file, such as "load [N]", and their variables; units are those of the page
const NAMES = [...axes.map(({ name }) => name), ...content.quantities].filter((name) => name !== "film_thickness");
const COLUMNS = Object.fromEntries(NAMES.map((name) => [headingOf(name), ofCondition(name)]));
export const FORMS = `A table of numbers as CSV in UTF-8, with at least two of these headings:
  ${Object.keys(COLUMNS).join(", ")}. The command thirdbody compare reads other units and forms.`;

let rows = []; // values in SI by the names of variables

function headingOf(name) {
  const { unit } = VARIABLES[ofCondition(name)];
  return spaced(name) + (unit ? ` [${unit.normalize("NFKC").replace("−", "-")}]` : "");
}

// Read a table; returns a line that says what was read, or why nothing was.
export function readMeasured(file, text) {
  rows = [];
  const separator = text.includes(";") ? ";" : ",";
  const table = d3.dsvFormat(separator).parse(text.replace(/^#.*\n/gm, ""));
  const used = table.columns.filter((heading) => heading in COLUMNS);
  if (new Set(used).size < Math.max(used.length, 2)) return `${file} is not read. ${FORMS}`;
  const cells = table.flatMap((row) => used.map((heading) => row[heading])).filter((cell) => /\d|inf/i.test(cell));
  const [comma, point] = [",", "."].map((sign) => cells.some((cell) => cell.includes(sign)));
  if (comma && point) return `${file} is not read: it has decimal commas and decimal points`;
  const wrong = cells.find((cell) => !Number.isFinite(numberIn(cell)));
  if (wrong) return `${file} is not read: “${wrong}” is no number`;
  const valueIn = (row, heading) => numberIn(row[heading]) / (VARIABLES[COLUMNS[heading]].factor ?? 1);
  rows = table.map((row) => Object.fromEntries(used.map((heading) => [COLUMNS[heading], valueIn(row, heading)])));
  const others = table.columns.filter((heading) => !used.includes(heading));
  return `${file}: ${rows.length} rows of ${used.join(", ")}` + (others.length ? `; not read: ${others.join(", ")}` : "");
}

export const forgetMeasured = () => (rows = []);

// Points of the table that a panel can show, in the colour of the curve at their conditions.
export function measuredPoints(x, y, curves, { newtonsPerLoad }) {
  const isAt = (row, condition) =>
    conditionAxes.every(({ name }) => !(name in row) || Math.abs(row[name] - condition[name]) <= 1e-6 * row[name]);
  return rows
    .map((row) => ({ load: row.normal_load / newtonsPerLoad, ...row }))
    .filter((row) => Number.isFinite(row[x]) && Number.isFinite(row[y]))
    .map((row) => {
      const curve = curves.find(({ condition }) => isAt(row, condition));
      return { x: row[x], y: row[y], color: curve?.color ?? "var(--ink)" };
    });
}
