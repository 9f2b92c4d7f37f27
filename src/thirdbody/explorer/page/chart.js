// One panel: axes, curves and marks, and what is under the pointer or the arrow keys.

import { VARIABLES, numberText, plainSymbol } from "./names.js";
import { escaped, powerOfTen, readable } from "./text.js";

const MARKERS = [
  ...[d3.symbolCircle, d3.symbolSquare, d3.symbolTriangle],
  ...[d3.symbolDiamond, d3.symbolCross, d3.symbolWye],
];
export const markerShape = (rank, size) => d3.symbol(MARKERS[rank % MARKERS.length], size)();
const STAR = d3.symbol(d3.symbolStar, 90)();
const DOUBT = d3.symbol(d3.symbolTimes, 28)();
export const DIAMOND = d3.symbol(d3.symbolDiamond, 60)();
export const CROSS = d3.symbol(d3.symbolCross, 110)();
export const DASHED = "5 3";
const MARKERS_PER_CURVE = 5;
const NEAR = 40; // pixels within which the pointer finds a point
const MARGIN = { left: 58, right: 14, top: 12, bottom: 40 };
const NEWTON_AXIS = 24; // its height above a panel
// by how many curves, and by how many points, a key moves
const MOVES = {
  ...{ ArrowUp: [-1, 0], ArrowDown: [1, 0], ArrowLeft: [0, -1], ArrowRight: [0, 1] },
  ...{ Home: [0, -Infinity], End: [0, Infinity] },
};

// Colour, which differs in lightness too, and marker of a curve at one of several levels of a condition.
export function levelStyle(level, levels) {
  if (level === 0) return { color: "var(--ink)", dash: DASHED };
  const rank = levels.indexOf(level);
  const part = levels.length > 1 ? rank / (levels.length - 1) : 0.3;
  const isDark = document.documentElement.dataset.theme === "dark";
  return { color: d3.interpolateViridis(isDark ? 0.28 + 0.72 * part : 0.86 * part), marker: rank };
}

export const widthIn = (element) => Math.max(element.clientWidth, 220);
const held = (value, low, high) => Math.min(Math.max(value, low), high);

// An axis for a variable: logarithmic or not, as asked for or as usual, with its ends around values.
export function axisFor(name, scale, values) {
  const log = scale === "auto" ? VARIABLES[name].log : scale === "log";
  return { name, log, domain: domainOf(VARIABLES[name], log, values) };
}

function domainOf({ fraction }, log, values) {
  const [low = 0.1, high = 1] = d3.extent(values.filter((value) => canShow({ log }, value)));
  if (log) {
    const lowest = Math.max(low, high * 1e-12);
    const margin = Math.max((high / lowest) ** 0.02, 1.02);
    return [lowest / margin, high * margin];
  }
  const top = high > 0 && high < 0.5 ? 1.08 * high : 1;
  if (fraction) return [-0.04 * top, 1.06 * top];
  const margin = 0.04 * (high - low || Math.abs(high) || 1);
  return [low - margin, high + margin];
}

const canShow = (axis, value) => Number.isFinite(value) && (!axis.log || value > 0);
const scaleOf = ({ log, domain }) => (log ? d3.scaleLog() : d3.scaleLinear()).domain(domain);

// Draw both axes and the grid; above, the load in newtons where `newtonsPerLoad` is given.
function drawAxes(group, { x: { name: xName }, y: { name: yName }, newtonsPerLoad }, { x, y }) {
  const [[left, right], [bottom, top]] = [x.range(), y.range()];
  const [width, height] = [right - left, bottom - top];
  const [across, upwards] = [left + width / 2, top + height / 2];
  group.html("");
  const below = drawAxis(group, d3.axisBottom(x), xName, [0, bottom], width, `translate(${across},${bottom + 34})`);
  const beside = drawAxis(group, d3.axisLeft(y), yName, [left, 0], height, `translate(13,${upwards}) rotate(-90)`);
  below.clone().attr("class", "grid").attr("y2", -height);
  beside.clone().attr("class", "grid").attr("x2", width);
  if (!newtonsPerLoad) return;
  const newtons = x.copy().domain(x.domain().map((end) => end * newtonsPerLoad));
  drawAxis(group, d3.axisTop(newtons), "normal_load", [0, top], width, `translate(${across},${top - NEWTON_AXIS})`);
}

// Draw an axis and its title; returns the lines of the ticks that have a label.
function drawAxis(group, axis, name, at, length, titleAt) {
  const scale = axis.scale();
  const { factor } = VARIABLES[name];
  const inPowers = scale.base && !factor && name !== "normal_load";
  const label = inPowers ? powerText : (value) => readable(value * (factor ?? 1));
  axis.ticks(scale.base ? 10 : Math.min(length / 55, 6)).tickSizeOuter(0);
  axis.tickFormat(scale.base ? scale.tickFormat(3, label) : label);
  const title = group.append("text").attr("class", "label").attr("text-anchor", "middle");
  title.attr("transform", titleAt).html(titleMarkup(name));
  const drawn = group.append("g").attr("class", "axis").attr("transform", `translate(${at})`).call(axis);
  return drawn.selectAll(".tick").filter((_, i, ticks) => ticks[i].textContent).select("line");
}

function powerText(value) {
  const power = Math.log10(value);
  return Math.abs(power - Math.round(power)) < 1e-9 ? powerOfTen(Math.round(power)) : readable(value);
}

// "A_sa,t*" as a letter, its index, and what follows, with the unit
function titleMarkup(name) {
  const { symbol, unit } = VARIABLES[name];
  const [, letter, below, above] = symbol.match(/^([^_]+)_?([\w,]*)(\*?)$/);
  const low = below && `<tspan dy="0.3em" font-size="0.8em">${below}</tspan>`;
  const rest = above + (unit ? ` (${unit})` : "");
  return `<tspan font-style="italic">${letter}</tspan>${low}<tspan${below && ' dy="-0.3em"'}>${rest}</tspan>`;
}

// A chart in an element. `update` draws a spec in a place of the given width.
export function chartIn(parent, { onRead, onLeave }) {
  const figure = d3.select(parent).append("figure");
  const title = figure.append("figcaption");
  const svg = figure.append("svg").attr("class", "chart").attr("xmlns", "http://www.w3.org/2000/svg");
  svg.attr("tabindex", 0).attr("role", "application").attr("aria-roledescription", "chart; arrow keys read it");
  const description = svg.append("desc");
  const clipId = `clip-${Math.random().toString(36).slice(2)}`;
  const clip = svg.append("clipPath").attr("id", clipId).append("rect");
  const axes = svg.append("g");
  const marks = svg.append("g").attr("clip-path", `url(#${clipId})`);
  const zones = svg.append("g"); // names above the curves
  const cursor = svg.append("g");
  let spec = null;
  let scales = null;
  let rows = []; // what can be read: the points of curves, or the cells of a map
  let place = { row: 0, point: 0 };

  function update(given, width) {
    spec = given;
    const height = Math.round(held(0.68 * width, 220, Math.max(430, 0.37 * innerHeight)));
    const [left, right] = [MARGIN.left, width - MARGIN.right];
    const [top, bottom] = [MARGIN.top + (spec.newtonsPerLoad ? NEWTON_AXIS : 0), height - MARGIN.bottom];
    scales = { x: scaleOf(spec.x).range([left, right]), y: scaleOf(spec.y).range([bottom, top]) };
    rows = (spec.rows ?? spec.lines).map((row) => ({ ...row, points: row.points.filter(isShownIn(spec)) }));
    svg.attr("viewBox", `0 0 ${width} ${height}`).attr("width", width).attr("height", height);
    svg.attr("aria-label", spec.title);
    description.text(spec.description ?? described(spec, rows));
    title.html("").append("b").text(spec.letter);
    title.append("span").text(spec.title);
    clip.attr("x", left).attr("y", top).attr("width", right - left).attr("height", bottom - top);
    drawAxes(axes, spec, scales);
    marks.html(marksOf(spec, scales));
    zones.html(zonesOf(spec, scales));
    cursor.html("");
  }

  function read(event) {
    const row = rows[place.row];
    const point = row.points[place.point];
    const [x, y] = [scales.x(point.x), scales.y(point.y)];
    const [[left, right], [bottom, top]] = [scales.x.range(), scales.y.range()];
    const cross = `M${x},${top}V${bottom}M${left},${y}H${right}`;
    cursor.html(`<path class="cursor" d="${cross}"/><circle class="dot" cx="${x}" cy="${y}" r="4.5"/>`);
    const box = svg.node().getBoundingClientRect();
    onRead({ spec, label: row.label, point, at: [box.left + x, box.top + y], event });
  }

  function leave() {
    cursor.html("");
    onLeave();
  }

  svg.on("pointermove", (event) => {
    const places = rows.flatMap(({ points }, row) => points.map(({ x, y }, point) => ({ row, point, x, y })));
    const tree = d3.quadtree(places, ({ x }) => scales.x(x), ({ y }) => scales.y(y));
    const found = tree.find(...d3.pointer(event, svg.node()), NEAR);
    if (!found) return leave();
    place = found;
    return read(event);
  });
  svg.on("pointerleave", leave).on("blur", leave);
  svg.on("keydown", (event) => {
    if (event.key === "Escape") leave();
    const move = MOVES[event.key];
    if (!move || !rows.length) return;
    event.preventDefault();
    const row = (Math.min(place.row, rows.length - 1) + move[0] + rows.length) % rows.length;
    place = { row, point: held(place.point + move[1], 0, rows[row].points.length - 1) };
    if (rows[row].points.length) read(event);
  });
  return { figure: figure.node(), update };
}

const isShownIn = (spec) => (point) => canShow(spec.x, point.x) && canShow(spec.y, point.y);

// Ranges, curves and marks of a panel, as SVG.
function marksOf(spec, { x: toX, y: toY }) {
  const inX = (value) => toX(value).toFixed(1);
  const inY = (value) => toY(spec.y.log ? Math.max(value, spec.y.domain[0] * 1e-3) : value).toFixed(1);
  const isShown = isShownIn(spec);
  const path = d3.line(({ x }) => toX(x), ({ y }) => toY(y)).digits(1).defined(isShown);
  const classOf = (kind, { faded, chosen }) => `class="${kind}${faded ? " faded" : ""}${chosen ? " chosen" : ""}"`;
  const shape = (kind) => (mark) => {
    const place = `translate(${inX(mark.x)},${inY(mark.y)})`;
    return `<path ${classOf(kind, mark)} d="${mark.symbol}" fill="${mark.color}" transform="${place}"/>`;
  };

  const areas = spec.areas.map(({ rings, fill }) => `<path class="area" d="${rings.map(path).join("")}" fill="${fill}"/>`);
  const border = d3.line(({ x }) => toX(x), ({ y }) => toY(y)).digits(1).defined(({ onBorder }) => onBorder);
  const borders = spec.borders.map(({ rings, kind, dash }) => {
    return `<path class="${kind}" d="${rings.map(border).join("")}" stroke-dasharray="${dash}"/>`;
  });
  const ranges = spec.ranges.map(({ points, color, faded }) => {
    const outline = points.map(([x, y]) => `${inX(x)},${inY(y)}`).join("L");
    return `<path d="M${outline}" fill="${color}" fill-opacity="${faded ? 0.03 : 0.1}"/>`;
  });
  const ghosts = `<path class="ghost" d="${spec.ghosts.map(path).join("")}"/>`;
  const lines = spec.lines.map((curve) => {
    const width = curve.chosen ? 2.8 : curve.mine ? 2.6 : 1.6;
    const dash = curve.dash ? `stroke-dasharray="${curve.dash}"` : "";
    const look = `stroke="${curve.color}" stroke-width="${width}" ${dash}`;
    return `<path ${classOf("line", curve)} data-label="${escaped(curve.label)}" d="${path(curve.points) ?? ""}" ${look}/>`;
  });
  const markers = markersOf(spec.lines).filter(isShown).map(shape("marker"));
  const isDoubtful = (point) => isShown(point) && point.state && point.state.status !== "converged";
  const doubtful = spec.lines.flatMap(({ points }) => points.filter(isDoubtful));
  const doubts = doubtful.map(({ x, y }) => shape("doubt")({ x, y, symbol: DOUBT, color: "none" }));
  const here = canShow(spec.x, spec.here) ? `<path class="here" d="M${inX(spec.here)},${toY.range().join("V")}"/>` : "";
  const measured = spec.measured.filter(isShown).map(({ x, y, color }) => {
    return `<circle class="measured" cx="${inX(x)}" cy="${inY(y)}" r="3.6" stroke="${color}"/>`;
  });
  const printed = spec.printed.map((mark) => {
    const { at, ends, color, chosen, text } = mark;
    const half = chosen ? 6 : 3.6;
    const [from, to] = ends.map(([x, y]) => `${inX(x)},${inY(y)}`);
    const box = `x="${toX(at[0]) - half}" y="${toY(at[1]) - half}" width="${2 * half}" height="${2 * half}"`;
    return `<g ${classOf("mark", mark)} stroke="${color}"><path d="M${from}L${to}" stroke-width="${chosen ? 3 : 1.4}"/>
      <rect class="printed" ${box}/><title>printed in the paper: ${escaped(text)}</title></g>`;
  });
  const stars = spec.stars.filter(isShown);
  const locus = spec.locus && stars.length ? `<path class="locus" d="${path(stars)}"/>` : "";
  const shapes = stars.map((star) => shape("star")({ symbol: STAR, ...star }));
  const curves = [areas, borders, ranges, ghosts, lines, "<g>", markers, "</g>"];
  return [...curves, doubts, here, measured, printed, locus, shapes].flat().join("");
}

// Markers distinguish curves without colour: a few on each, at places that differ from curve to curve.
function markersOf(lines) {
  const marked = lines.filter((line) => line.marker !== undefined);
  return marked.flatMap(({ points, color, faded, ...line }, rank) => {
    const step = points.length / MARKERS_PER_CURVE;
    const first = (step * (rank + 0.5)) / marked.length;
    const places = d3.range(first, points.length, step).map((place) => points[Math.floor(place)]);
    return places.map(({ x, y }) => ({ x, y, color, faded, symbol: markerShape(line.marker, 34) }));
  });
}

// The limits of modes or regimes and the names between them, as SVG.
function zonesOf(spec, { x: toX, y: toY }) {
  const { limits = [], zones = [] } = VARIABLES[spec.y.name];
  const [[left, right], [low, high]] = [toX.range(), spec.y.domain];
  const inside = limits.filter((limit) => limit > low && limit < high);
  const lines = inside.map((limit) => `<path class="limit" d="M${left},${toY(limit)}H${right}"/>`);
  const edges = [low, ...limits, high].map((edge) => toY(held(edge, low, high)));
  const names = zones.map((zone, i) => {
    if (edges[i] - edges[i + 1] < 5) return "";
    return `<text class="zone" text-anchor="end" x="${right - 4}" y="${(edges[i] + edges[i + 1]) / 2}" dy="0.32em">${zone}</text>`;
  });
  return [...lines, ...names].join("");
}

// What a chart shows, in words, for those who do not see it.
function described({ stars, printed, measured, x, y }, rows) {
  if (!rows.length) return "Nothing can be drawn at these conditions.";
  const { words, symbol } = VARIABLES[y.name];
  const ends = rows.map(({ label, points }) => {
    if (!points.length) return `${label}: no values`;
    const [first, last] = [points[0], points.at(-1)].map((point) => numberText(y.name, point.y));
    return `${label} runs from ${first} to ${last}`;
  });
  const what = `${rows.length} curves of ${words} ${plainSymbol(symbol)} over ${VARIABLES[x.name].words}`;
  const counts = { "turning points": stars, "numbers printed in the paper": printed, "points of your file": measured };
  const marks = Object.entries(counts).filter(([, { length }]) => length).map(([name, { length }]) => `${length} ${name}`);
  return [what, ...ends, ...marks].join("; ");
}
