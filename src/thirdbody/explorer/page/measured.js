// Measured values from a CSV file, which are drawn over the curves.

import { conditionAxes, content } from "./state.js";
import { VARIABLES, spaced } from "./names.js";
import { numberIn } from "./text.js";

const LENGTH = { nm: 1e-9, um: 1e-6, "μm": 1e-6, mm: 1e-3, m: 1 };
const NUMBER = { "": 1, 1: 1, "-": 1, "%": 0.01 };
const MISSING = /^(?!.*inf)\D*$/i; // cells without a measurement have no digits
// "load [N]", "load (N)" or "load / N"
const HEADING = /^(.*?)(?:\s*[[(]\s*(.*?)\s*[)\]]|\s*\/\s*([^/]+?))?\s*$/;
// Headings, variables, and units in SI. The same heading can stand for two variables.
const COLUMNS = [
  ["load", "normal_load", { N: 1, mN: 1e-3, kN: 1e3 }],
  ["load", "load", { 1: 1 }],
  ["viscosity", "viscosity", { cSt: 1e-6, "mm2/s": 1e-6, "m2/s": 1 }],
  ["particle diameter", "particle_diameter", LENGTH],
  ["particle size", "particle_diameter", LENGTH],
  ["roughness", "roughness", LENGTH],
  ["particle density", "particle_density", { "m-2": 1, "1/m2": 1, "mm-2": 1e6, "1/mm2": 1e6 }],
  ["separation", "separation", LENGTH],
  ["film thickness", "separation", LENGTH],
  ["film thickness", "film_thickness", NUMBER],
  ...content.quantities.filter((name) => /area|fraction/.test(name)).map((name) => [spaced(name), name, NUMBER]),
];

let rows = []; // values in SI by the names of variables

// The variable of a heading such as "load [N]" and the size of its unit; undefined if no heading is called so.
function columnOf(heading) {
  const [, words, inBrackets, afterSlash] = heading.match(HEADING);
  const unit = (inBrackets ?? afterSlash ?? "").normalize("NFKC").replaceAll("^", ""); // mm² and mm^2 as mm2, the micro sign as μ
  const name = words.trim().toLowerCase().replaceAll("_", " ").replace(/^normal /, "");
  const known = COLUMNS.filter(([each]) => each === name);
  const column = known.find(([, , units]) => Object.hasOwn(units, unit));
  if (column) return { name: column[1], size: column[2][unit] };
  if (!known.length) return undefined;
  const allowed = known.flatMap(([, , units]) => Object.keys(units)).filter(Boolean);
  throw new Error(`“${heading}”: the unit is one of ${allowed.join(", ")}`);
}

// The text of a file in UTF-8, or as spreadsheets write it: in UTF-16 or in the code page of Windows.
function textOf(bytes) {
  if (new Uint8Array(bytes.slice(0, 2)).join() === "255,254") return new TextDecoder("utf-16le").decode(bytes);
  const text = new TextDecoder().decode(bytes);
  return text.includes("\uFFFD") ? new TextDecoder("windows-1252").decode(bytes) : text;
}

// Whether the first row below headings without units has those units.
const areUnits = (headings, cells) =>
  !headings.some((heading) => /[[(/]/.test(heading)) &&
  !cells.some((cell) => /\d/.test(cell)) &&
  cells.some((cell) => !["", "-"].includes(cell.trim()));
const withUnits = (headings, units) => headings.map((heading, place) => `${heading} [${(units[place] ?? "").trim()}]`);

// Read a table; returns a line that says what was read, or why nothing was.
export function readMeasured(file, bytes) {
  const written = textOf(bytes).split(/\r\n?|\n/).filter((line) => line.trim() && !line.startsWith("#"));
  const separator = [";", "\t"].find((each) => written[0]?.includes(each)) ?? ",";
  const text = written.join("\n").replaceAll(`${separator} "`, `${separator}"`);
  const [headings = [], ...lines] = d3.dsvFormat(separator).parseRows(text);
  try {
    const named = areUnits(headings, lines[0] ?? []) ? withUnits(headings, lines.shift()) : headings;
    const columns = named.map((heading, place) => ({ heading, place, ...columnOf(heading.trim()) }));
    const [used, ignored] = [columns.filter(({ name }) => name), columns.filter(({ name }) => !name)];
    if (used.length < 2) throw new Error("needs two columns such as “load [N]” and “solid load fraction [%]”");
    const twice = used.find(({ name }, place) => used.slice(0, place).some((each) => each.name === name));
    if (twice) throw new Error(`has more than one column of ${VARIABLES[twice.name].words.toLowerCase()}`);
    const valueIn = (cells) => ({ name, place, size }) => [name, numberIn(cells[place] ?? "") * size];
    const texts = lines.flatMap((cells) => used.map(({ place }) => (cells[place] ?? "").trim()).filter((text) => !MISSING.test(text)));
    const [comma, point] = [",", "."].map((sign) => texts.some((text) => text.includes(sign)));
    if (comma && point) throw new Error("has decimal commas and decimal points");
    const wrong = texts.find((text) => !Number.isFinite(numberIn(text)));
    if (wrong) throw new Error(`“${wrong}” is no number`);
    rows = lines.map((cells) => Object.fromEntries(used.map(valueIn(cells))));
    const words = used.map(({ name }) => VARIABLES[name].words.toLowerCase());
    const rest = ignored.length ? `; not read: ${ignored.map(({ heading }) => heading).join(", ")}` : "";
    return `${file}: ${rows.length} rows of ${words.join(", ")}${rest}`;
  } catch (error) {
    return `${file}: ${error.message}`;
  }
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
