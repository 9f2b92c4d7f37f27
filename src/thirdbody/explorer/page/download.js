// What is shown as a file: numbers as CSV, drawings as SVG.

const INLINED = ["fill", "stroke", "stroke-width", "stroke-dasharray", "opacity", "fill-opacity", "font-size", "font-family", "font-style", "paint-order"];
const GAP = 24;
const ENTRY = 260; // width of an entry of the key

function save(name, type, text) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type }));
  link.download = name;
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

const field = (value) => {
  const text = typeof value === "number" ? (Number.isNaN(value) ? "" : String(value)) : String(value);
  return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
};

// The points of all charts: columns as those of the CSV files beside the figures.
export function csvOf(specs) {
  const rows = [["panel", "curve", "x_name", "x", "y_name", "y"]];
  for (const { letter, x, y, lines, printed, stars } of specs) {
    const add = (label, points) => points.forEach((point) => rows.push([letter, label, x.name, point.x, y.name, point.y]));
    lines.forEach((line) => add(line.label, line.points));
    add("turning points", stars);
    printed.forEach((mark) => add(`printed; ${mark.id}`, [{ x: mark.at[0], y: mark.at[1] }]));
  }
  return rows.map((row) => row.map(field).join(",")).join("\n") + "\n";
}

export function csvOfMap({ x, y, columns, rows, cells }) {
  const names = Object.keys(cells.find((cell) => cell.mode >= 0) ?? cells[0]);
  const own = names.filter((name) => name !== x && name !== y);
  const lines = cells.map((cell, index) => {
    const place = [columns[index % columns.length], rows[Math.floor(index / columns.length)]];
    return [...place, ...own.map((name) => cell[name] ?? "")];
  });
  return [[x === "load" ? "load_N" : x, y === "load" ? "load_N" : y, ...own], ...lines].map((row) => row.map(field).join(",")).join("\n") + "\n";
}

export const saveCsv = (name, text) => save(`${name}.csv`, "text/csv", text);

const SVG = "http://www.w3.org/2000/svg";

function element(name, attributes, text = "") {
  const made = document.createElementNS(SVG, name);
  Object.entries(attributes).forEach(([key, value]) => made.setAttribute(key, value));
  made.textContent = text;
  return made;
}

// A copy of a drawing that keeps its look without the style of the page.
function copyOf(svg) {
  const copy = svg.cloneNode(true);
  const originals = [svg, ...svg.querySelectorAll("*")];
  [copy, ...copy.querySelectorAll("*")].forEach((each, i) => {
    const style = getComputedStyle(originals[i]);
    for (const property of INLINED) each.style.setProperty(property, style.getPropertyValue(property));
  });
  return copy;
}

// All drawings in one, two side by side, with the entries of their key below.
export function svgOf(figures, entries) {
  const sizes = figures.map((figure) => figure.querySelector("svg").viewBox.baseVal);
  const columns = figures.length > 1 ? 2 : 1;
  const width = Math.max(...sizes.map((size) => size.width));
  const height = Math.max(...sizes.map((size) => size.height)) + GAP;
  const inRow = Math.max(Math.floor((columns * width) / ENTRY), 1);
  const drawn = Math.ceil(figures.length / columns) * height;
  const total = [columns * width, drawn + GAP * (Math.ceil(entries.length / inRow) + 0.5)];
  const whole = element("svg", { xmlns: SVG, viewBox: `0 0 ${total.join(" ")}`, width: total[0], height: total[1] });
  const root = getComputedStyle(document.documentElement);
  const font = { "font-family": "sans-serif", "font-size": 13, fill: root.getPropertyValue("--ink") };
  whole.append(element("rect", { width: "100%", height: "100%", fill: root.getPropertyValue("--paper") }));
  figures.forEach((figure, i) => {
    const [x, y] = [(i % columns) * width, Math.floor(i / columns) * height];
    const parts = [...figure.querySelector("figcaption").childNodes].map((node) => node.textContent);
    const copy = copyOf(figure.querySelector("svg"));
    Object.entries({ x, y: y + GAP, width: sizes[i].width, height: sizes[i].height }).forEach(([name, value]) => copy.setAttribute(name, value));
    whole.append(element("text", { x: x + 10, y: y + 16, ...font }, parts.filter(Boolean).join("  ")), copy);
  });
  entries.forEach((entry, i) => {
    const [x, y] = [10 + (i % inRow) * ENTRY, drawn + GAP * (Math.floor(i / inRow) + 0.5)];
    const copy = copyOf(entry.querySelector("svg"));
    Object.entries({ x, y }).forEach(([name, value]) => copy.setAttribute(name, value));
    whole.append(copy, element("text", { x: x + 38, y: y + 11, ...font }, entry.textContent.trim()));
  });
  return new XMLSerializer().serializeToString(whole);
}

export const saveSvg = (name, text) => save(`${name}.svg`, "image/svg+xml", text);
