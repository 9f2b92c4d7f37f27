// What is shown as a file: numbers as CSV, drawings as SVG.

import { typesetInDrawing } from "./text.js";

const INLINED = [
  ...["fill", "fill-opacity", "stroke", "stroke-opacity", "stroke-width", "stroke-dasharray", "opacity"],
  ...["font-size", "font-family", "font-style", "text-anchor"],
];
const GAP = 24; // above each drawing, for its title, and between entries of the key
const ENTRY = 260; // width of an entry of the key

export function save(name, type, text) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

// The points of all charts: columns as those of the CSV files beside the figures.
export function csvOf(specs) {
  const rows = specs.flatMap(({ letter, x, y, lines, printed, levels, limits, ofAll, stars }) => {
    const row = (label, point) => [letter, label, x.name, point.x, y.name, Number.isNaN(point.y) ? "" : point.y];
    return [
      ...lines.flatMap(({ label, points }) => points.map((point) => row(label, point))),
      ...stars.map((star) => row("turning points", star)),
      ...[...printed, ...levels, ...limits, ...ofAll].map(({ id, at }) => row(`printed; ${id}`, { x: at[0], y: at[1] })),
    ];
  });
  return d3.csvFormatRows([["panel", "curve", "x_name", "x", "y_name", "y"], ...rows]) + "\n";
}

// A copy of a drawing at a place, which keeps its look without the style of the page.
function copyOf(svg, x, y) {
  const copy = svg.cloneNode(true);
  const originals = [svg, ...svg.querySelectorAll("*")];
  [copy, ...copy.querySelectorAll("*")].forEach((element, i) => {
    const style = getComputedStyle(originals[i]);
    for (const property of INLINED) element.style.setProperty(property, style.getPropertyValue(property));
  });
  return d3.select(copy).attr("x", x).attr("y", y).node();
}

// All drawings in one, two side by side, with the entries of their key below.
export function svgOf(charts, key) {
  const [figures, entries] = [[...charts.querySelectorAll("figure")], [...key.children]];
  const style = getComputedStyle(document.documentElement);
  const drawings = figures.map((figure) => figure.querySelector("svg"));
  const columns = Math.min(figures.length, 2);
  const cellWidth = d3.max(drawings, ({ viewBox }) => viewBox.baseVal.width);
  const cellHeight = d3.max(drawings, ({ viewBox }) => viewBox.baseVal.height) + GAP;
  const width = columns * cellWidth;
  const inRow = Math.max(Math.floor(width / ENTRY), 1);
  const keyTop = Math.ceil(figures.length / columns) * cellHeight + GAP / 2;
  const height = keyTop + GAP * Math.ceil(entries.length / inRow);
  const svg = d3.create("svg:svg").attr("viewBox", `0 0 ${width} ${height}`).attr("width", width).attr("height", height);
  svg.append("title").text(drawings.map((drawing) => drawing.querySelector("desc, title").textContent).join(" "));
  svg.append("rect").attr("width", "100%").attr("height", "100%").attr("fill", style.getPropertyValue("--paper"));
  svg.attr("font-family", "sans-serif").attr("font-size", 13);
  const color = style.getPropertyValue("--ink");
  const write = (x, y, text) => svg.append("text").attr("x", x).attr("y", y).attr("fill", color).html(typesetInDrawing(text));
  figures.forEach((figure, i) => {
    const [x, y] = [(i % columns) * cellWidth, Math.floor(i / columns) * cellHeight];
    write(x + 10, y + 16, figure.dataset.title);
    svg.append(() => copyOf(drawings[i], x, y + GAP));
  });
  entries.forEach((entry, i) => {
    const [x, y] = [10 + (i % inRow) * ENTRY, keyTop + GAP * Math.floor(i / inRow)];
    svg.append(() => copyOf(entry.querySelector("svg"), x, y));
    write(x + 38, y + 11, entry.dataset.text);
  });
  return new XMLSerializer().serializeToString(svg.node());
}
