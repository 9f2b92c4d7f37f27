// This draws one panel: axes, curves and marks. It reads what is under the pointer or the arrow keys.

import { content } from "./content.js";
import { VARIABLES, numberText } from "./names.js";
import { escaped, plain, powerOfTen, readable, typeset, typesetInDrawing } from "./text.js";

// Markers and colours are those of the figures of the workflow: every second marker is hollow, colours go from dark to light.
const MARKERS = [
  [d3.symbolCircle, 0], [d3.symbolSquare, 0], [d3.symbolTriangle, 0], [d3.symbolTriangle, 180],
  [d3.symbolCross, 0], [d3.symbolCross, 45], [d3.symbolTriangle, 90],
];
const [LIGHT, DARK] = [[0.05, 0.59], [0.35, 1]]; // ends of the shades, each with enough contrast
const STEPS = 60; // shades between the ends
const SHAPES = {
  star: d3.symbol(d3.symbolStar, 24)(),
  slight: d3.symbol(d3.symbolStar, 24)(),
  printed: d3.symbol(d3.symbolDiamond2, 77)(),
  doubt: d3.symbol(d3.symbolTimes, 28)(),
  cross: d3.symbol(d3.symbolCross, 110)(),
  computed: "M0,-4.6L4,-2.3V2.3L0,4.6L-4,2.3V-2.3Z",
};
const MARKERS_PER_CURVE = 5;
const NEAR = 40; // pixels within which the pointer finds a point
const MARGIN = { left: 58, right: 14, top: 12, bottom: 40 };
const LINE = 12; // height of a name
const SAME = 4; // height between ends of curves that have one name
const [LEADER, GAP] = [10, 6]; // from the end of a curve to its name, and beyond the name
const MOST_NAMES = 12; // at ends of curves
const MOST_ROOM = 0.5; // of names, in widths of a panel; longer ones are left to the key
const BRACKET = 14; // height of a bracket above a panel
const ZONE_NAMES = 36; // width of the names of zones beside a panel
const NEWTON_AXIS = 24; // its height above a panel
// by how many curves, and by how many points, a key moves
const MOVES = {
  ...{ ArrowUp: [-1, 0], ArrowDown: [1, 0], ArrowLeft: [0, -1], ArrowRight: [0, 1] },
  ...{ Home: [0, -Infinity], End: [0, Infinity] },
};

// A curve at one of several levels of a condition has a colour and a marker. Colours differ in lightness too.
// Between strong levels, others are thin and have no marker.
export function levelStyle(level, levels, strong) {
  if (level === 0) return { color: "var(--ink)" };
  const color = shadeAt(levels.length > 1 ? levels.indexOf(level) / (levels.length - 1) : 0.3);
  return strong.includes(level) ? { color, marker: strong.indexOf(level) } : { color, thin: true };
}
export const THIN = { color: "var(--shade-30)", thin: true }; // of several levels

// Shades are colours of the style, since the light and the dark page have their own.
const SHADE = d3.range(STEPS + 1);
const shadeAt = (part) => `var(--shade-${Math.round(part * STEPS)})`;
const shadesOf = (ends) =>
  SHADE.map((step) => `--shade-${step}: ${d3.interpolateViridis(d3.interpolate(...ends)(step / STEPS))};`).join(" ");
d3.select("#shades").text(
  `:root { ${shadesOf(LIGHT)} } @media screen and (prefers-color-scheme: dark) { :root { ${shadesOf(DARK)} } }`,
);

const classOf = (kind, { faded, chosen }) => `class="${kind}${faded ? " faded" : ""}${chosen ? " chosen" : ""}"`;

const kindOf = ({ dry, thin, mine }) => `line${dry ? " dry" : ""}${thin ? " thin" : ""}${mine ? " mine" : ""}`;

// A mark of one kind at a place of the drawing.
const shapeOf = (kind, x, y, { color = "", ...look } = {}) =>
  `<path ${classOf(kind, look)} d="${SHAPES[kind]}" stroke="${color}" transform="translate(${x},${y})"/>`;

function markerOf(rank, x, y, { color, ...look }) {
  const [symbol, turn] = MARKERS[rank % MARKERS.length];
  const fill = rank % 2 ? "var(--paper)" : color;
  return `<path ${classOf("marker", look)} d="${d3.symbol(symbol, 34)()}" fill="${fill}" stroke="${color}"
    transform="translate(${x},${y}) rotate(${turn})"/>`;
}

const strokeOf = ({ color, dash }) => `stroke="${color}"${dash ? ` stroke-dasharray="${dash}"` : ""}`;

// The drawing of an entry of the key: a fill, or a line of a kind with a marker or a mark on it.
export function sampleOf({ fill, dry, thin, mine, mark, marker, hasEnds, ...given }) {
  const { kind = fill ? "area" : kindOf({ dry, thin, mine }), ...look } = given;
  if (fill) return `<rect class="${kind}" x="4" y="1" width="22" height="12" fill="${fill}"/>`;
  const line = look.color ? `<path class="${kind}" d="M1,7H29${hasEnds ? "M1,1v12M29,1v12" : ""}" ${strokeOf(look)}/>` : "";
  const symbol = marker === undefined ? "" : markerOf(marker, 15, 7, { color: look.color });
  return line + symbol + (mark ? shapeOf(mark, 15, 7, { color: "var(--ink)" }) : "");
}

// Entries of the key for what charts show beside their curves, by the lists of a spec; figures have the same words.
const KEY = {
  stars: { mark: "star" },
  slight: { mark: "slight" },
  locus: { color: "var(--turning)", kind: "locus" },
  printed: { mark: "printed", color: "var(--ink)", kind: "tolerance" },
  computed: { mark: "computed" },
  levels: { color: "var(--ink)", kind: "level", hasEnds: true },
  windows: { color: "var(--accent)", kind: "window" },
  limits: { color: "var(--ink)", kind: "limit" },
  ofAll: { color: "var(--ink)", kind: "limit all" },
  strips: { fill: "var(--tolerance)", kind: "strip" },
  ranges: { fill: "var(--range)" },
  ghosts: { text: "the paper's conditions and the calibrated inputs", color: "var(--ghost)", kind: "ghost" },
  here: { text: "at your conditions", color: "var(--accent)", kind: "here" },
  doubts: { text: "with a remark", mark: "doubt" },
};

export function keyOfMarks(specs) {
  const shown = Object.keys(KEY).filter((kind) => specs.some((spec) => spec[kind].length));
  const zones = new Set(specs.flatMap(({ y }) => VARIABLES[y.name].shaded ?? []));
  const shaded = zones.size ? [{ text: `shaded: ${[...zones].join(", or ")}`, fill: "var(--zone)" }] : [];
  return [...shown.map((kind) => ({ text: content.marks[kind], ...KEY[kind] })), ...shaded];
}

// A spec of a chart; what is not given is empty.
export function specOf({ lines = [], ...given }) {
  const { limits = [], ofAll = [], levels = [] } = given;
  const empty = [...Object.keys(KEY), "areas", "borders", "brackets", "crosses", "fills", "names"].map((name) => [name, []]);
  const doubts = lines.flatMap(({ points }) => points.filter(({ state }) => state && state.status !== "converged"));
  const toleranced = [...limits, ...ofAll, ...levels].filter((each) => each.is_tolerance_drawn);
  const strips = [...new Map(toleranced.map(({ ends }) => [String(ends), ends])).values()]; // of several curves one
  return { letter: "", ...Object.fromEntries(empty), ...given, lines, doubts, strips };
}

const pen = document.createElement("canvas").getContext("2d");
// The width of the widest of some texts in a drawing.
export function widthOf(texts) {
  pen.font = `11px ${getComputedStyle(document.body).fontFamily}`;
  return d3.max(texts, (text) => pen.measureText(text).width);
}

const widthIn = (element) => Math.max(element.clientWidth, 220);
const held = (value, low, high) => Math.min(Math.max(value, low), high);

// An axis around values of a variable. The scale is the one asked for, or the usual one. The axis of a fraction is
// logarithmic if it has a `least` value, where it begins.
export function axisFor(name, scale, values, least = 0) {
  const log = scale === "auto" ? VARIABLES[name].log || least > 0 : scale === "log";
  const domain = log && least && VARIABLES[name].fraction ? [least, 1.3] : domainOf(VARIABLES[name], log, values);
  return { name, log, domain };
}

function domainOf({ fraction }, log, values) {
  const [low = 0.1, high = 1] = d3.extent(values.filter((value) => canShow({ log }, value)));
  if (log) {
    const lowest = Math.max(low, high * 1e-12);
    const margin = Math.max((high / lowest) ** 0.02, 1.02);
    return [lowest / margin, high * margin];
  }
  const top = high > 0 && high < 0.5 ? 1.08 * high : 1;
  if (fraction) return [-0.08 * top, 1.08 * top];
  const margin = 0.04 * (high - low || Math.abs(high) || 1);
  return [low - margin, high + margin];
}

const canShow = (axis, value) => Number.isFinite(value) && (!axis.log || value > 0);
const scaleOf = ({ log, domain }) => (log ? d3.scaleLog() : d3.scaleLinear()).domain(domain);

// Draw both axes and the grid; above, the load in newtons where `newtonsPerLoad` is given. The room of names has neither
// ticks nor grid.
function drawAxes(group, { x: { name: xName, domain }, y: { name: yName }, newtonsPerLoad }, { x, y }) {
  const [[left, right], [bottom, top]] = [x.range(), y.range()];
  const [width, height] = [right - left, bottom - top];
  const [across, upwards] = [left + width / 2, top + height / 2];
  group.html("");
  const below = drawAxis(group, d3.axisBottom(x), xName, domain, [0, bottom], width, `translate(${across},${bottom + 34})`);
  const beside = drawAxis(group, d3.axisLeft(y), yName, y.domain(), [left, 0], height, `translate(13,${upwards}) rotate(-90)`);
  const [from, to] = domain.map((end) => x(end) - left);
  below.clone().attr("class", "grid").attr("y2", -height);
  beside.clone().attr("class", "grid").attr("x1", from).attr("x2", to);
  if (!newtonsPerLoad) return;
  const inNewtons = (ends) => ends.map((end) => end * newtonsPerLoad);
  const newtons = x.copy().domain(inNewtons(x.domain()));
  drawAxis(group, d3.axisTop(newtons), "normal_load", inNewtons(domain), [0, top], width, `translate(${across},${top - NEWTON_AXIS})`);
}

// Draw an axis, with ticks from `low` to `high`, and its title; returns the lines of the ticks that have a label.
function drawAxis(group, axis, name, [low, high], at, length, titleAt) {
  const scale = axis.scale();
  const { factor } = VARIABLES[name];
  const inPowers = scale.base && !factor && name !== "normal_load";
  const label = inPowers ? powerText : (value) => readable(value * (factor ?? 1));
  const ticks = scale.ticks(scale.base ? 10 : Math.min(length / 55, 6));
  axis.tickValues(ticks.filter((tick) => tick >= low && tick <= high)).tickSizeOuter(0);
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

function titleMarkup(name) {
  const { symbol, unit } = VARIABLES[name];
  return typesetInDrawing(unit ? `${symbol} (${unit})` : symbol);
}

// A chart in an element; returns the function that draws a spec. If a name does not fit, this returns the fills
// of areas, for the key.
export function chartIn(parent, { onRead, onLeave }) {
  const figure = d3.select(parent).append("figure");
  const title = figure.append("figcaption");
  const svg = figure.append("svg").attr("class", "chart").attr("xmlns", "http://www.w3.org/2000/svg");
  svg.attr("tabindex", 0).attr("role", "application").attr("aria-roledescription", "chart; arrow keys read it");
  const description = svg.append("desc");
  const clipId = `clip-${Math.random().toString(36).slice(2)}`;
  const clip = svg.append("clipPath").attr("id", clipId).append("rect");
  const zones = svg.append("g");
  const axes = svg.append("g");
  const marks = svg.append("g").attr("clip-path", `url(#${clipId})`);
  const [crosses, cursor] = [svg.append("g"), svg.append("g")];
  let spec = null;
  let scales = null;
  let rows = []; // what can be read: the points of curves, or the cells of a map
  let place = { row: 0, point: 0 };

  function update(given) {
    spec = given;
    const width = widthIn(figure.node());
    const height = Math.round(held(0.68 * width, 220, Math.max(430, 0.37 * innerHeight)));
    const above = (spec.newtonsPerLoad ? NEWTON_AXIS : 0) + BRACKET * spec.brackets.length;
    const [top, bottom] = [MARGIN.top + above, height - MARGIN.bottom];
    const y = scaleOf(spec.y).range([bottom, top]);
    rows = (spec.rows ?? spec.lines).map((row) => ({ ...row, points: row.points.filter(isShownIn(spec)) }));
    const [left, right] = [MARGIN.left, width - (VARIABLES[spec.y.name].zones ? ZONE_NAMES : MARGIN.right)];
    const { ends, atLeft, room } = spec.x.name === "load" ? namesOf(rows, y, right - left) : NAMELESS;
    // names stand within the frame, whose axis becomes longer by their room
    const beside = scaleOf(spec.x).range(atLeft ? [left + room, right] : [left, right - room]);
    scales = { x: beside.copy().domain([left, right].map((end) => beside.invert(end))).range([left, right]), y };
    svg.attr("viewBox", `0 0 ${width} ${height}`).attr("width", width).attr("height", height);
    svg.attr("aria-label", plain(spec.title));
    description.text(spec.description ?? described(spec, rows));
    title.html(`<b>${spec.letter}</b><span>${typeset(spec.title)}</span>`);
    figure.attr("data-title", `${spec.letter}  ${spec.title}`.trim());
    clip.attr("x", left).attr("y", top).attr("width", right - left).attr("height", bottom - top);
    drawAxes(axes, spec, scales);
    marks.html(marksOf(spec, scales));
    const names = spec.names.map((name) => nameIn(name, scales));
    const whole = spec.crosses.map(({ x, y }) => shapeOf("cross", scales.x(x), scales.y(y))); // at the edges
    const outside = [...namesOfEnds(ends, atLeft, spec, scales), ...bracketsOf(spec, scales), ...namesOfLimits(spec, scales)];
    crosses.html([...names, ...outside, ...whole].join(""));
    zones.html(zonesOf(spec, scales));
    cursor.html("");
    return names.every(Boolean) ? [] : spec.fills;
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

  // a finger reads the point that it taps, which stays until another is tapped
  svg.on("pointermove pointerdown", (event) => {
    const places = rows.flatMap(({ points }, row) => points.map(({ x, y }, point) => ({ row, point, x, y })));
    const tree = d3.quadtree(places, ({ x }) => scales.x(x), ({ y }) => scales.y(y));
    const found = tree.find(...d3.pointer(event, svg.node()), NEAR);
    if (!found) return leave();
    place = found;
    return read(event);
  });
  svg.on("pointerleave", ({ pointerType }) => pointerType === "touch" || leave()).on("blur", leave);
  svg.on("keydown", (event) => {
    if (event.key === "Escape") leave();
    const move = MOVES[event.key];
    if (!move || !rows.length) return;
    event.preventDefault();
    const row = (Math.min(place.row, rows.length - 1) + move[0] + rows.length) % rows.length;
    place = { row, point: held(place.point + move[1], 0, rows[row].points.length - 1) };
    if (rows[row].points.length) read(event);
  });
  return update;
}

// Names at the ends of curves, on the side with more ends apart, and the room that they need. Thin curves have a name
// where there is room.
const NAMELESS = { ends: [], atLeft: false, room: 0 };
function namesOf(rows, toY, width) {
  const named = rows.filter(({ name, points }) => name && points.length);
  const [thin, strong] = [true, false].map((isThin) => named.filter((row) => Boolean(row.thin) === isThin));
  const [left, right] = [0, -1].map((end) => groupsAt(end, strong, toY));
  const atLeft = left.length > right.length;
  const groups = atLeft ? left : right;
  const most = Math.min(MOST_NAMES, Math.floor(Math.abs(toY.range()[1] - toY.range()[0]) / LINE));
  if (groups.length < 2 || groups.length > most) return NAMELESS;
  for (const group of groupsAt(atLeft ? 0 : -1, thin, toY)) {
    if (groups.flat().every(({ y }) => Math.abs(y - group[0].y) > LINE)) groups.push(group);
  }
  const dry = strong.filter((row) => row.dry);
  const ends = d3.sort(groups, ([{ y }]) => y).map((group) => endOf(group, dry, strong));
  const room = LEADER + widthOf(ends.map(({ text }) => text)) + GAP;
  return room > MOST_ROOM * width ? NAMELESS : { ends, atLeft, room };
}

// Curves that follow each other and whose ends coincide form a group, which has one name, from the highest on. Dry curves form
// their own.
function groupsAt(end, rows, toY) {
  const [bottom, top] = toY.range();
  const ends = rows.map(({ points, ...row }) => {
    const { x, y } = points.at(end);
    return { ...row, x, y: held(toY(y), top, bottom) };
  });
  const groups = [];
  for (const one of d3.sort(ends, ({ y }) => y)) {
    const group = groups.find(([{ y, dry }]) => one.y - y < SAME && one.dry === dry);
    if (group) group.push(one);
    else groups.push([one]);
  }
  return groups.flatMap((group) => runsOf(group, ends));
}

// A group in the order of the rows, apart where others of their medium lie between them.
function runsOf(group, ends) {
  const runs = [[]];
  for (const one of ends.filter(({ dry }) => dry === group[0].dry)) {
    if (group.includes(one)) runs.at(-1).push(one);
    else if (runs.at(-1).length) runs.push([]);
  }
  return runs.filter(({ length }) => length);
}

// The text and colour of a group: black names are of dry contact, and those of several curves are grey.
function endOf(group, dry, strong) {
  const [{ x, y, dry: isDry }] = group;
  const names = [...new Set(group.map(({ name }) => name))];
  const colors = new Set(group.map(({ color }) => color));
  const isOne = colors.size === 1 && (isDry || group[0].color !== "var(--ink)");
  let text = names.length < 3 ? names.join(", ") : `${names[0]} … ${names.at(-1)}`;
  if (isDry && dry.length < strong.length && !/^(dry|two-body)/.test(text)) {
    text = dry.every(({ label }) => group.some((row) => row.label === label)) ? "dry" : `dry ${text}`;
  }
  return { x, y, text, color: isOne ? group[0].color : "var(--soft)" };
}

// Names stand as near to the ends as lines of text allow: at the mean of pushing all up and all down.
function namesOfEnds(ends, atLeft, { x: { domain } }, { x: toX, y: toY }) {
  const [bottom, top] = toY.range();
  const apart = ends.map(({ y }, i) => y - LINE * i);
  const side = atLeft ? -1 : 1;
  const name = toX(domain[atLeft ? 0 : 1]) + LEADER * side;
  const lowest = Math.max(bottom - LINE * (ends.length - 0.4), top + 0.6 * LINE);
  return ends.map(({ x, y, text, color }, i) => {
    const middle = 0.5 * (d3.max(apart.slice(0, i + 1)) + d3.min(apart.slice(i)));
    const at = (held(middle, top + 0.6 * LINE, lowest) + LINE * i).toFixed(1);
    return `<path class="leader" d="M${toX(x).toFixed(1)},${y.toFixed(1)}L${(name - 2 * side).toFixed(1)},${at}"/>
      <text class="end" x="${name.toFixed(1)}" y="${at}" dy="0.32em" text-anchor="${atLeft ? "end" : "start"}" style="fill: ${color}">${text}</text>`;
  });
}

// Brackets above a panel over both ends of a range along x, with its name; the narrowest is the lowest.
function bracketsOf({ brackets }, { x: toX, y: toY }) {
  const top = toY.range()[1];
  return d3.sort(brackets, ({ ends: [low, high] }) => high - low).map(({ ends, text, color }, i) => {
    const [[left, right], height] = [ends.map(toX), top - BRACKET * (i + 0.7)];
    const [middle, half] = [(left + right) / 2, Math.min(widthOf([text]) / 2 + 3, (right - left) / 2)];
    return `<path class="leader" d="M${left},${top}V${height}H${middle - half}M${middle + half},${height}H${right}V${top}" style="stroke: ${color}"/>
      <text class="bracket" x="${middle}" y="${height}" dy="0.32em" style="fill: ${color}">${text}</text>`;
  });
}

// Names of curves at the foot of numbers along x: of the first at its left, of others at the right.
function namesOfLimits({ limits }, { x: toX, y: toY }) {
  return limits.filter(({ name }) => name).map(({ name, ends: [[low], [high]], color }, i) => {
    const [x, anchor] = i ? [toX(high) + 3, "start"] : [toX(low) - 3, "end"];
    return `<text class="foot" x="${x}" y="${toY.range()[0] - 6}" text-anchor="${anchor}" style="fill: ${color}">${name}</text>`;
  });
}

// The name of a region, in two lines or in one, where it fits; "" if it does not.
function nameIn({ text, placeFor }, { x: toX, y: toY }) {
  const [[left, right], [bottom, top]] = [toX.range(), toY.range()];
  for (const lines of [text.split(", "), [text]]) {
    const size = [widthOf(lines) + GAP, 1.2 * LINE * lines.length + GAP];
    const place = placeFor(size[0] / (right - left), size[1] / (bottom - top));
    if (!place) continue;
    const at = `x="${toX(place.x)}"`;
    const spans = lines.map((line, i) => `<tspan ${at} dy="${i ? 1.2 : 0.95 - 0.6 * lines.length}em">${line}</tspan>`);
    return `<text class="name" ${at} y="${toY(place.y)}">${spans.join("")}</text>`;
  }
  return "";
}

const isShownIn = (spec) => (point) => canShow(spec.x, point.x) && canShow(spec.y, point.y);

// Ranges, curves and marks of a panel, as SVG.
function marksOf(spec, { x: toX, y: toY }) {
  const inX = (value) => toX(value).toFixed(1);
  const inY = (value) => toY(spec.y.log ? Math.max(value, spec.y.domain[0] * 1e-3) : value).toFixed(1);
  const [across, upwards] = [spec.x.domain.map(inX), toY.range()];
  const isShown = isShownIn(spec);
  const path = d3.line(({ x }) => toX(x), ({ y }) => toY(y)).digits(1).defined(isShown);
  const shape = (kind) => (mark) => shapeOf(kind, inX(mark.x), inY(mark.y), mark);
  const upright = (kind) => (x) => `<path class="${kind}" d="M${inX(x)},${upwards.join("V")}"/>`;

  const areas = spec.areas.map(({ rings, fill }) => `<path class="area" d="${rings.map(path).join("")}" fill="${fill}"/>`);
  const border = d3.line(({ x }) => toX(x), ({ y }) => toY(y)).digits(1).defined(({ onBorder }) => onBorder);
  const borders = spec.borders.map(({ rings, kind }) => `<path class="${kind}" d="${rings.map(border).join("")}"/>`);
  const ranges = spec.ranges.map(({ points, color, faded }) => {
    const outline = points.map(([x, y]) => `${inX(x)},${inY(Math.max(y, spec.y.domain[0]))}`).join("L");
    const under = faded ? "" : `<path fill="var(--paper)" d="M${outline}"/>`; // several may overlap
    return `${under}<path ${classOf("range", { faded })} d="M${outline}" fill="${color}" stroke="${color}"/>`;
  });
  const strips = spec.strips.map(([[left, low], [right, high]]) => {
    const [from, to] = left === right ? across : [left, right].map(inX);
    const [bottom, top] = low === null ? upwards : [low, high].map(inY);
    return `<path class="strip" d="M${from},${bottom}V${top}H${to}V${bottom}Z"/>`;
  });
  const limit = (kind) => ({ at: [x], color = "var(--ink)", ...look }) => `<path ${classOf(kind, look)} d="M${inX(x)},${upwards.join("V")}" stroke="${color}"/>`;
  const limits = [...spec.limits.map(limit("limit")), ...spec.ofAll.map(limit("limit all"))];
  const ghosts = `<path class="ghost" d="${spec.ghosts.map(path).join("")}"/>`;
  const levels = spec.levels.map((level) => `<path ${classOf("level", level)} d="${across.map((end) => `M${end},${inY(level.at[1])}m0,-6v12`).join("")}M${across[0]},${inY(level.at[1])}H${across[1]}" stroke="${level.color}"/>`);
  const lines = spec.lines.map((curve) => {
    return `<path ${classOf(kindOf(curve), curve)} data-label="${escaped(curve.label)}" d="${path(curve.points) ?? ""}" ${strokeOf(curve)}/>`;
  });
  const bar = (mark) => {
    const ends = mark.ends.map(([x, y]) => `${inX(x)},${inY(y)}`);
    return `<path ${classOf("tolerance", mark)} d="M${ends.join("L")}" stroke="${mark.color}"/>`;
  };
  const printed = spec.printed.map((mark) => {
    const drawn = [
      mark.chosen || mark.is_tolerance_drawn ? bar(mark) : "",
      mark.chosen || mark.is_point_drawn ? shape("printed")({ ...mark, x: mark.at[0], y: mark.at[1] }) : "",
    ].join("");
    return drawn && `<g>${drawn}<title>printed in the paper: ${escaped(mark.text)}</title></g>`;
  });
  const stars = spec.stars.filter(isShown);
  const locus = `<path class="locus" d="${path(spec.locus) ?? ""}"/>`;
  const curves = [areas, borders, strips, ranges, limits, spec.windows.map(upright("window")), ghosts, lines, levels];
  const marks = [
    ...markersOf(spec.lines).filter(isShown).map(({ rank, x, y, ...look }) => markerOf(rank, inX(x), inY(y), look)),
    ...spec.doubts.filter(isShown).map(({ x, y }) => shape("doubt")({ x, y })),
    ...spec.slight.filter(isShown).map(shape("slight")),
  ];
  return [...curves, spec.here.map(upright("here")), locus, marks, printed, spec.computed.map(shape("computed")), stars.map(shape("star"))].flat().join("");
}

// Markers distinguish curves without colour. Each curve has a few, at places of its own.
function markersOf(lines) {
  const marked = lines.filter((line) => line.marker !== undefined);
  return marked.flatMap(({ points, color, faded, marker }, rank) => {
    const step = points.length / MARKERS_PER_CURVE;
    const first = (step * (rank + 0.5)) / marked.length;
    const places = d3.range(first, points.length, step).map((place) => points[Math.floor(place)]);
    return places.map(({ x, y }) => ({ x, y, color, faded, rank: marker }));
  });
}

// SVG of the modes or regimes: the middle one may be shaded, and all have their names beside the panel.
function zonesOf(spec, { x: toX, y: toY }) {
  const { limits, zones, shaded } = VARIABLES[spec.y.name];
  if (!limits) return "";
  const [[left, right], [low, high]] = [toX.range(), spec.y.domain];
  const edges = [low, ...limits, high].map((edge) => toY(held(edge, low, high)));
  const shade = shaded ? `<rect fill="var(--zone)" x="${left}" y="${edges[2]}" width="${right - left}" height="${edges[1] - edges[2]}"/>` : "";
  const names = zones.map((zone, i) => {
    if (edges[i] - edges[i + 1] < 9) return "";
    return `<text class="zone" x="${right + 4}" y="${(edges[i] + edges[i + 1]) / 2}" dy="0.32em">${zone}</text>`;
  });
  return [shade, ...names].join("");
}

// What a chart shows, in words, for those who do not see it.
function described({ stars, printed, levels, limits, ofAll, x, y }, rows) {
  if (!rows.length) return "Nothing can be drawn at these conditions.";
  const { words, symbol } = VARIABLES[y.name];
  const ends = rows.map(({ label, points }) => {
    if (!points.length) return `${label}: no values`;
    const [first, last] = [points[0], points.at(-1)].map((point) => numberText(y.name, point.y, 2));
    return `${label} runs from ${first} to ${last}`;
  });
  const across = d3.extent(rows.flatMap(({ points }) => points), (point) => point.x).map((end) => numberText(x.name, end, 2));
  const what = `${words}, ${plain(symbol)}, over ${VARIABLES[x.name].words.toLowerCase()} from ${across.join(" to ")}`;
  const counts = { "turning points": stars, "numbers printed in the paper": [...printed, ...levels, ...limits, ...ofAll] };
  const marks = Object.entries(counts).filter(([, { length }]) => length).map(([name, { length }]) => `${length} ${name}`);
  return [what, ...ends, ...marks].join("; ");
}
