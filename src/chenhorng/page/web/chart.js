// This draws one panel: axes, curves and marks. It reads what is under the pointer or the arrow keys.

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
  star: d3.symbol(d3.symbolStar, 90)(),
  slight: d3.symbol(d3.symbolStar, 60)(),
  printed: d3.symbol(d3.symbolDiamond2, 60)(),
  doubt: d3.symbol(d3.symbolTimes, 28)(),
  cross: d3.symbol(d3.symbolCross, 110)(),
  computed: "M0,-6L5.2,-3V3L0,6L-5.2,3V-3Z",
};
const MARKERS_PER_CURVE = 5;
const NEAR = 40; // pixels within which the pointer finds a point
const MARGIN = { left: 58, right: 14, top: 12, bottom: 40 };
const LETTER = 6; // width of a letter of a name
const LINE = 11; // its height
const SAME = 4; // height between ends of curves that have one name
const LEADER = 10; // width of the line from an end to its name
const MOST_NAMES = 12; // at ends of curves
const WITH_NAMES = 360; // width from which a panel has them
const ZONE_NAMES = 36; // width of the names of zones beside a panel
const NEWTON_AXIS = 24; // its height above a panel
// by how many curves, and by how many points, a key moves
const MOVES = {
  ...{ ArrowUp: [-1, 0], ArrowDown: [1, 0], ArrowLeft: [0, -1], ArrowRight: [0, 1] },
  ...{ Home: [0, -Infinity], End: [0, Infinity] },
};

// A curve at one of several levels of a condition has a colour and a marker. Colours differ in lightness too.
export function levelStyle(level, levels) {
  if (level === 0) return { color: "var(--ink)" };
  const rank = levels.indexOf(level);
  const part = levels.length > 1 ? rank / (levels.length - 1) : 0.3;
  return { color: shadeAt(part), marker: rank };
}

// Shades are colours of the style, since the light and the dark page have their own.
const SHADE = d3.range(STEPS + 1);
const shadeAt = (part) => `var(--shade-${Math.round(part * STEPS)})`;
const shadesOf = (ends) =>
  SHADE.map((step) => `--shade-${step}: ${d3.interpolateViridis(d3.interpolate(...ends)(step / STEPS))};`).join(" ");
d3.select("#shades").text(
  `:root { ${shadesOf(LIGHT)} } @media screen and (prefers-color-scheme: dark) { :root { ${shadesOf(DARK)} } }`,
);

const classOf = (kind, { faded, chosen }) => `class="${kind}${faded ? " faded" : ""}${chosen ? " chosen" : ""}"`;

const kindOf = ({ dry, mine }) => `line${dry ? " dry" : ""}${mine ? " mine" : ""}`;

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
export function sampleOf({ fill, dry, mine, mark, marker, hasEnds, isUpright, ...given }) {
  const { kind = fill ? "area" : kindOf({ dry, mine }), ...look } = given;
  if (fill) return `<rect class="${kind}" x="4" y="1" width="22" height="12" fill="${fill}"/>`;
  const line = look.color ? `<path class="${kind}" d="${isUpright ? "M15,0V14" : "M1,7H29"}${hasEnds ? "M1,1v12M29,1v12" : ""}" ${strokeOf(look)}/>` : "";
  const symbol = marker === undefined ? "" : markerOf(marker, 15, 7, { color: look.color });
  return line + symbol + (mark ? shapeOf(mark, 15, 7, { color: "var(--ink)" }) : "");
}

// Entries of the key for what charts show beside their curves, by the lists of a spec.
const KEY = {
  stars: { text: "turning point (TPCA)", mark: "star" },
  slight: { text: "peak that rises by less than 0.02", mark: "slight" },
  locus: { text: "locus of turning points", color: "var(--turning)", kind: "locus" },
  printed: { text: "printed, with tolerance", mark: "printed", color: "var(--ink)", kind: "tolerance" },
  computed: { text: "bend or crossing, computed", mark: "computed" },
  levels: { text: "printed, between the strokes", color: "var(--ink)", kind: "level", hasEnds: true },
  windows: { text: "computed limits of turning points", color: "var(--accent)", kind: "window", isUpright: true },
  limits: { text: "printed, without height (dotted: of all surfaces), tolerance in grey", color: "var(--ink)", kind: "limit", isUpright: true },
  ranges: { text: "range of the ensemble", fill: "var(--range)" },
  ghosts: { text: "the paper's conditions and the calibrated inputs", color: "var(--ghost)", kind: "ghost" },
  here: { text: "at your conditions", color: "var(--accent)", kind: "here", isUpright: true },
  doubts: { text: "with a remark", mark: "doubt" },
};

export function keyOfMarks(specs) {
  const shown = Object.keys(KEY).filter((kind) => specs.some((spec) => spec[kind].length));
  const zones = new Set(specs.flatMap(({ y }) => VARIABLES[y.name].shaded ?? []));
  const shaded = zones.size ? [{ text: `shaded: ${[...zones].join(", or ")}`, fill: "var(--zone)" }] : [];
  return [...shown.map((kind) => KEY[kind]), ...shaded];
}

// A spec of a chart; what is not given is empty.
export function specOf({ lines = [], ...given }) {
  const empty = [...Object.keys(KEY), "areas", "borders", "crosses", "names"].map((name) => [name, []]);
  const doubts = lines.flatMap(({ points }) => points.filter(({ state }) => state && state.status !== "converged"));
  return { letter: "", ...Object.fromEntries(empty), ...given, lines, doubts };
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

function titleMarkup(name) {
  const { symbol, unit } = VARIABLES[name];
  return typesetInDrawing(unit ? `${symbol} (${unit})` : symbol);
}

// A chart in an element; returns the function that draws a spec.
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
    const [top, bottom] = [MARGIN.top + (spec.newtonsPerLoad ? NEWTON_AXIS : 0), height - MARGIN.bottom];
    const y = scaleOf(spec.y).range([bottom, top]);
    rows = (spec.rows ?? spec.lines).map((row) => ({ ...row, points: row.points.filter(isShownIn(spec)) }));
    const ends = width < WITH_NAMES ? [] : endsOf(rows, y);
    const beside = ends.length && LEADER + LETTER / 2 + LETTER * d3.max(ends, ({ text }) => text.length);
    const [left, right] = [MARGIN.left, width - beside - (VARIABLES[spec.y.name].zones ? ZONE_NAMES : MARGIN.right)];
    scales = { x: scaleOf(spec.x).range([left, right]), y };
    svg.attr("viewBox", `0 0 ${width} ${height}`).attr("width", width).attr("height", height);
    svg.attr("aria-label", plain(spec.title));
    description.text(spec.description ?? described(spec, rows));
    title.html(`<b>${spec.letter}</b><span>${typeset(spec.title)}</span>`);
    figure.attr("data-title", `${spec.letter}  ${spec.title}`.trim());
    clip.attr("x", left).attr("y", top).attr("width", right - left).attr("height", bottom - top);
    drawAxes(axes, spec, scales);
    marks.html(marksOf(spec, scales));
    const names = spec.names.map((name) => nameOf(name, scales));
    crosses.html([...names, ...spec.crosses.map(({ x, y }) => shapeOf("cross", scales.x(x), scales.y(y)))].join("")); // whole at the edges
    zones.html(zonesOf(spec, scales, beside) + namesOfEnds(ends, right, bottom));
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

// Ends of curves that coincide form a group with one name. The highest comes first. Where there are too many, the key says more.
function endsOf(rows, toY) {
  const named = rows.filter(({ name, points }) => name && points.length).map(({ points, ...row }, rank) => ({ ...row, rank, y: toY(points.at(-1).y) }));
  const groups = [];
  for (const end of d3.sort(named, ({ y }) => y)) {
    if (groups.length && end.y - groups.at(-1)[0].y < SAME) groups.at(-1).push(end);
    else groups.push([end]);
  }
  if (groups.length < 2 || groups.length > MOST_NAMES) return [];
  return groups.map((group) => {
    const names = [...new Set(d3.sort(group, ({ rank }) => rank).map(({ name }) => name))];
    const colors = new Set(group.map(({ color }) => color));
    const text = names.length < 3 ? names.join(", ") : `${names[0]} … ${names.at(-1)}`;
    return { y: group[0].y, text, color: colors.size > 1 ? "var(--ink)" : group[0].color };
  });
}

// Names stand right of a panel, as near to the ends as lines of text allow: at the mean of pushing all up and all down.
function namesOfEnds(ends, right, lowest) {
  const apart = ends.map(({ y }, i) => y - LINE * i);
  return ends.map(({ y, text, color }, i) => {
    const middle = 0.5 * (d3.max(apart.slice(0, i + 1)) + d3.min(apart.slice(i)));
    const at = Math.min(middle, lowest - LINE * (ends.length - 1)) + LINE * i;
    return `<path class="leader" d="M${right},${y.toFixed(1)}L${right + LEADER - 2},${at.toFixed(1)}"/>
      <text class="end" x="${right + LEADER}" y="${at.toFixed(1)}" dy="0.32em" style="fill: ${color}">${text}</text>`;
  }).join("");
}

// The name of a region, in lines, around a place.
function nameOf({ x, y, lines }, { x: toX, y: toY }) {
  const [left, right] = toX.range();
  const half = 0.5 * LETTER * d3.max(lines, ({ length }) => length);
  const at = `x="${held(toX(x), left + half, right - half)}"`;
  const spans = lines.map((line, i) => `<tspan ${at} dy="${i ? 1.2 : 0.95 - 0.6 * lines.length}em">${line}</tspan>`);
  return `<text class="name" ${at} y="${toY(y)}">${spans.join("")}</text>`;
}

const isShownIn = (spec) => (point) => canShow(spec.x, point.x) && canShow(spec.y, point.y);

// Ranges, curves and marks of a panel, as SVG.
function marksOf(spec, { x: toX, y: toY }) {
  const inX = (value) => toX(value).toFixed(1);
  const inY = (value) => toY(spec.y.log ? Math.max(value, spec.y.domain[0] * 1e-3) : value).toFixed(1);
  const [across, upwards] = [toX.range(), toY.range()];
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
  const allowed = spec.limits.map(({ ends: [[low], [high]] }) => `<path fill="var(--zone)" d="M${inX(low)},${upwards.join("V")}H${inX(high)}V${upwards[0]}"/>`);
  const limits = spec.limits.map(({ kind, at: [x] }) => upright(kind)(x));
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
    const diamond = mark.isBar ? "" : shape("printed")({ ...mark, x: mark.at[0], y: mark.at[1] });
    return `<g>${bar(mark)}${diamond}<title>printed in the paper: ${escaped(mark.text)}</title></g>`;
  });
  const stars = spec.stars.filter(isShown);
  const locus = `<path class="locus" d="${path(spec.locus) ?? ""}"/>`;
  const curves = [areas, borders, ranges, allowed, limits, spec.windows.map(upright("window")), ghosts, lines, levels];
  const marks = [
    ...markersOf(spec.lines).filter(isShown).map(({ rank, x, y, ...look }) => markerOf(rank, inX(x), inY(y), look)),
    ...spec.doubts.filter(isShown).map(({ x, y }) => shape("doubt")({ x, y })),
    ...spec.slight.filter(isShown).map(shape("slight")),
  ];
  return [...curves, spec.levels.map(bar), spec.here.map(upright("here")), locus, marks, printed, spec.computed.map(shape("computed")), stars.map(shape("star"))].flat().join("");
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

// SVG of the modes or regimes: the middle one is shaded, and all have their names beside the panel.
function zonesOf(spec, { x: toX, y: toY }, beside) {
  const { limits, zones = [] } = VARIABLES[spec.y.name];
  if (!limits) return "";
  const [[left, right], [low, high]] = [toX.range(), spec.y.domain];
  const edges = [low, ...limits, high].map((edge) => toY(held(edge, low, high)));
  const shade = `<rect fill="var(--zone)" x="${left}" y="${edges[2]}" width="${right - left}" height="${edges[1] - edges[2]}"/>`;
  const names = zones.map((zone, i) => {
    if (edges[i] - edges[i + 1] < 9) return "";
    return `<text class="zone" x="${right + beside + 4}" y="${(edges[i] + edges[i + 1]) / 2}" dy="0.32em">${zone}</text>`;
  });
  return [shade, ...names].join("");
}

// What a chart shows, in words, for those who do not see it.
function described({ stars, printed, levels, limits, x, y }, rows) {
  if (!rows.length) return "Nothing can be drawn at these conditions.";
  const { words, symbol } = VARIABLES[y.name];
  const ends = rows.map(({ label, points }) => {
    if (!points.length) return `${label}: no values`;
    const [first, last] = [points[0], points.at(-1)].map((point) => numberText(y.name, point.y, 2));
    return `${label} runs from ${first} to ${last}`;
  });
  const across = d3.extent(rows.flatMap(({ points }) => points), (point) => point.x).map((end) => numberText(x.name, end, 2));
  const what = `${words}, ${plain(symbol)}, over ${VARIABLES[x.name].words.toLowerCase()} from ${across.join(" to ")}`;
  const counts = { "turning points": stars, "numbers printed in the paper": [...printed, ...levels, ...limits] };
  const marks = Object.entries(counts).filter(([, { length }]) => length).map(([name, { length }]) => `${length} ${name}`);
  return [what, ...ends, ...marks].join("; ");
}
