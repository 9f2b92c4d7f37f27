// One panel: axes, curves and marks, and what is under the pointer or the arrow keys.

import { VARIABLES, numberText, plainSymbol, symbolParts } from "./names.js";
import { escaped, powerOfTen, readable } from "./text.js";

export const MARKERS = [
  d3.symbolCircle,
  d3.symbolSquare,
  d3.symbolTriangle,
  d3.symbolDiamond,
  d3.symbolCross,
  d3.symbolWye,
];
const STAR = d3.symbol(d3.symbolStar, 90)();
export const DIAMOND = d3.symbol(d3.symbolDiamond, 60)();
export const CROSS = d3.symbol(d3.symbolCross, 110)();
const MARKERS_PER_CURVE = 5;
const NEAR = 40; // pixels within which the pointer finds a point
const TICKS = 6;

export const isDark = () => document.documentElement.dataset.theme === "dark";
export const ink = () => (isDark() ? "#e4e8ed" : "#1b222c");
export const mineColour = () => (isDark() ? "#ff9d5c" : "#c4460a");
// colours of an ordered parameter, which differ in lightness too
export const shade = (part) => d3.interpolateViridis(isDark() ? 0.28 + 0.72 * part : 0.86 * part);

// --- axes ---

// An axis for a variable: logarithmic or not, as asked for or as usual, with its ends around values.
export function axisFor(name, scale, values) {
  const log = scale === "auto" ? VARIABLES[name].log : scale === "log";
  return { name, log, domain: domainOf(VARIABLES[name], log, values) };
}

function domainOf({ fraction }, log, values) {
  const [low, high] = d3.extent(values.filter((value) => Number.isFinite(value) && (!log || value > 0)));
  if (low === undefined) return log ? [0.1, 1] : [0, 1];
  if (log) {
    const lowest = Math.max(low, high * 1e-12);
    const margin = Math.max((high / lowest) ** 0.02, 1.02);
    return [lowest / margin, high * margin];
  }
  if (fraction) {
    const top = high > 0 && high < 0.5 ? 1.08 * high : 1;
    return [-0.04 * top, 1.06 * top];
  }
  const margin = 0.04 * (high - low || Math.abs(high) || 1);
  return [low - margin, high + margin];
}

const canShow = (axis, value) => Number.isFinite(value) && (!axis.log || value > 0);
const scaleOf = ({ log, domain }) => (log ? d3.scaleLog() : d3.scaleLinear()).domain(domain);

// The size of a drawing in an element; `em` is the size of its text over the usual one.
export function sizeIn(element) {
  const em = parseFloat(getComputedStyle(document.documentElement).fontSize) / 14;
  return { em, width: Math.max(element.clientWidth, 220) };
}

// Scales of a panel and the pixels at its four sides.
function frameOf({ x, y, newtonsPerLoad }, { em, width, height }) {
  const [left, right] = [58 * em, width - 14 * em];
  const [top, bottom] = [(newtonsPerLoad ? 36 : 12) * em, height - 40 * em];
  const scales = { x: scaleOf(x).range([left, right]), y: scaleOf(y).range([bottom, top]) };
  return { ...scales, left, right, top, bottom };
}

// Draw both axes and the grid; above, the load in newtons where `newtonsPerLoad` is given.
function drawAxes(group, spec, frame, em) {
  const { x, y, left, right, top, bottom } = frame;
  const middle = [0.5 * (left + right), 0.5 * (top + bottom)];
  const [across, upwards] = [ticksOf(x, spec.x.log, right - left), ticksOf(y, spec.y.log, bottom - top)];
  const grid = [
    ...across.map((value) => `M${x(value)},${top}V${bottom}`),
    ...upwards.map((value) => `M${left},${y(value)}H${right}`),
  ];
  const small = [
    ...minorTicks(x, spec.x.log).map((at) => `M${at},${bottom}v4`),
    ...minorTicks(y, spec.y.log).map((at) => `M${left},${at}h-4`),
  ];
  const axes = [
    [d3.axisBottom(x).tickValues(across), spec.x.name, [0, bottom], [middle[0], bottom + 34 * em, 0]],
    [d3.axisLeft(y).tickValues(upwards), spec.y.name, [left, 0], [13 * em, middle[1], -90]],
  ];
  if (spec.newtonsPerLoad) {
    const newtons = x.copy().domain(x.domain().map((end) => end * spec.newtonsPerLoad));
    const values = ticksOf(newtons, spec.x.log, right - left);
    axes.push([d3.axisTop(newtons).tickValues(values), "normal_load", [0, top], [middle[0], top - 24 * em, 0]]);
    small.push(...minorTicks(newtons, spec.x.log).map((at) => `M${at},${top}v-4`));
  }
  const labels = axes.map(([, name, , [a, b, turn]]) => {
    const place = `transform="translate(${a},${b}) rotate(${turn})" text-anchor="middle"`;
    return `<text class="label" ${place}>${titleMarkup(name)}</text>`;
  });
  group.html(`<path class="grid" d="${grid.join("")}"/><path class="minor" d="${small.join("")}"/>${labels.join("")}`);
  for (const [axis, name, place] of axes) {
    const inPowers = axis.scale().base && name !== "normal_load";
    const drawn = axis.tickFormat((value) => tickText(name, value, inPowers)).tickSizeOuter(0);
    group.append("g").attr("class", "axis").attr("transform", `translate(${place})`).call(drawn);
  }
}

// Powers of ten on a logarithmic axis of some decades; else what D3 proposes.
function ticksOf(scale, log, length) {
  const count = Math.max(Math.min(TICKS, length / 55), 2);
  if (!log) return scale.ticks(count);
  const [first, last] = scale.domain().map(Math.log10);
  const powers = d3.ticks(first, last, 8).filter(Number.isInteger);
  return powers.length > 1 ? powers.map((exponent) => 10 ** exponent) : scale.ticks(5);
}

// Places of ticks at twofold to ninefold powers of ten, unless these are too many.
function minorTicks(scale, log) {
  const values = log ? scale.ticks() : [];
  return values.length < 70 ? values.map((value) => scale(value)) : [];
}

function tickText(name, value, inPowers) {
  const { factor = 1, percent } = VARIABLES[name];
  const power = Math.log10(value);
  if (inPowers && Math.abs(power - Math.round(power)) < 1e-9) return powerOfTen(Math.round(power));
  return readable(value * (percent ? 100 : factor), 4);
}

function titleMarkup(name) {
  const { symbol, percent, unit = percent ? "%" : "" } = VARIABLES[name];
  const [letter, below, above] = symbolParts(symbol);
  const low = below && `<tspan dy="0.3em" font-size="0.8em">${below}</tspan>`;
  const rest = above + (unit ? ` (${unit})` : "");
  return `<tspan font-style="italic">${letter}</tspan>${low}<tspan${below && ' dy="-0.3em"'}>${rest}</tspan>`;
}

// --- a panel ---

// A chart in an element. `update` draws a spec in a place of the given size; `spec` is what it shows.
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
  const chart = { figure: figure.node(), spec: null, update };
  let frame = null;
  let place = { line: 0, point: 0 };

  function update(spec, { em, width }) {
    chart.spec = spec;
    const most = Math.max(430 * em, 0.37 * innerHeight);
    const height = Math.round(Math.min(Math.max(0.68 * width, 220 * em), most));
    frame = frameOf(spec, { em, width, height });
    const { left, right, top, bottom } = frame;
    svg.attr("viewBox", `0 0 ${width} ${height}`).attr("width", width).attr("height", height);
    svg.attr("aria-label", spec.title);
    description.text(spec.description ?? described(spec));
    title.html("").append("b").text(spec.letter);
    title.append("span").text(spec.title);
    clip.attr("x", left).attr("y", top).attr("width", right - left).attr("height", bottom - top);
    drawAxes(axes, spec, frame, em);
    marks.html(marksOf(spec, frame, em));
    zones.html(zonesOf(spec, frame));
    cursor.html("");
  }

  // what can be read: the points of curves, or the cells of a map
  const rows = () => chart.spec.rows ?? chart.spec.lines;
  const isShown = (point) => canShow(chart.spec.x, point.x) && canShow(chart.spec.y, point.y);

  function read(event) {
    const line = rows()[place.line];
    const point = line.points[place.point];
    const [x, y] = [frame.x(point.x), frame.y(point.y)];
    const cross = `M${x},${frame.top}V${frame.bottom}M${frame.left},${y}H${frame.right}`;
    cursor.html(`<path class="cursor" d="${cross}"/><circle class="dot" cx="${x}" cy="${y}" r="4.5"/>`);
    const box = svg.node().getBoundingClientRect();
    onRead({ spec: chart.spec, line, point, at: [box.left + x, box.top + y], event });
  }

  function leave() {
    cursor.html("");
    onLeave();
  }

  svg.on("pointermove", (event) => {
    const [x, y] = d3.pointer(event, svg.node());
    const found = rows().flatMap((line, number) =>
      line.points.map((point, index) => {
        const far = isShown(point) ? Math.hypot(frame.x(point.x) - x, frame.y(point.y) - y) : Infinity;
        return { far, line: number, point: index };
      }),
    );
    const nearest = d3.least(found, ({ far }) => far);
    if (!(nearest?.far < NEAR)) return leave();
    place = nearest;
    return read(event);
  });
  svg.on("pointerleave", leave).on("blur", leave);
  svg.on("keydown", (event) => {
    const lines = rows();
    if (event.key === "Escape") return leave();
    const move = MOVES[event.key];
    if (!move || !lines.length) return undefined;
    event.preventDefault();
    place.line = (Math.min(place.line, lines.length - 1) + move[0] + lines.length) % lines.length;
    const { points } = lines[place.line];
    const known = d3.range(points.length).filter((i) => isShown(points[i]));
    if (!known.length) return undefined;
    const rank = d3.bisectLeft(known, place.point) + (event.shiftKey ? 10 : 1) * move[1];
    place.point = known[Math.min(Math.max(rank, 0), known.length - 1)];
    return read(event);
  });
  return chart;
}

const MOVES = {
  ArrowLeft: [0, -1],
  ArrowRight: [0, 1],
  ArrowUp: [-1, 0],
  ArrowDown: [1, 0],
  Home: [0, -1e6],
  End: [0, 1e6],
};

// Ranges, curves and marks of a panel, as SVG.
function marksOf(spec, frame, em) {
  const inX = (value) => frame.x(value).toFixed(1);
  const inY = (value) => frame.y(value).toFixed(1);
  const heldY = (value) => inY(spec.y.log ? Math.max(value, spec.y.domain[0] * 1e-3) : value);
  const isShown = (point) => canShow(spec.x, point.x) && canShow(spec.y, point.y);
  const line = () => d3.line(({ x }) => frame.x(x), ({ y }) => frame.y(y)).digits(1);
  const path = line().defined(isShown);
  const border = line().defined(({ onBorder }) => onBorder);
  const classOf = ({ faded, chosen }) => (faded ? " faded" : "") + (chosen ? " chosen" : "");
  const shape = (mark, d, kind) => {
    const place = `translate(${inX(mark.x)},${inY(mark.y)}) scale(${em})`;
    return `<path class="${kind}${classOf(mark)}" d="${d}" fill="${mark.color}" transform="${place}"/>`;
  };

  const areas = spec.areas.map(({ rings, fill }) => {
    const outline = rings.map((ring) => `${path(ring)}Z`).join("");
    return `<path class="area" d="${outline}" fill="${fill}"/>`;
  });
  const borders = spec.borders.map(({ rings, kind, dash }) => {
    const outline = rings.map((ring) => border(ring) ?? "").join("");
    return `<path class="${kind}" d="${outline}" stroke-dasharray="${dash}"/>`;
  });
  const ranges = spec.ranges.map(({ points, color, faded }) => {
    const outline = points.map(([x, y]) => `${inX(x)},${heldY(y)}`).join("L");
    return `<path d="M${outline}" fill="${color}" fill-opacity="${faded ? 0.03 : 0.1}"/>`;
  });
  const ghosts = `<path class="ghost" d="${spec.ghosts.map(path).join("")}"/>`;
  const lines = spec.lines.map((curve) => {
    const width = (curve.chosen ? 2.8 : curve.mine ? 2.6 : 1.6) * em;
    const dash = curve.dash ? `stroke-dasharray="${curve.dash}"` : "";
    const look = `stroke="${curve.color}" stroke-width="${width}" ${dash}`;
    const label = `data-label="${escaped(curve.label)}"`;
    return `<path class="line${classOf(curve)}" ${label} d="${path(curve.points)}" ${look}/>`;
  });
  const markers = markersOf(spec.lines).filter(isShown).map((mark) => shape(mark, mark.shape, "marker"));
  const doubts = spec.lines
    .flatMap(({ points }) => points.filter((point) => isShown(point) && isDoubtful(point)))
    .map(({ x, y }) => `M${frame.x(x) - 3},${frame.y(y) - 3}l6,6m-6,0l6,-6`);
  const here = canShow(spec.x, spec.here)
    ? `<line class="here" x1="${inX(spec.here)}" x2="${inX(spec.here)}" y1="${frame.top}" y2="${frame.bottom}"/>`
    : "";
  const measured = spec.measured
    .filter(isShown)
    .map(({ x, y, color }) => `<circle class="measured" cx="${inX(x)}" cy="${inY(y)}" r="${3.6 * em}" stroke="${color}"/>`);
  const printed = spec.printed.map(({ id, at, ends, color, chosen, faded, text }) => {
    const half = (chosen ? 6 : 3.6) * em;
    const [from, to] = ends.map(([x, y]) => `${inX(x)},${heldY(y)}`);
    const look = `stroke="${color}" stroke-width="${(chosen ? 3 : 1.4) * em}"`;
    const box = `x="${frame.x(at[0]) - half}" y="${frame.y(at[1]) - half}" width="${2 * half}" height="${2 * half}"`;
    return `<g class="${faded ? "faded" : ""}" data-claim="${id}"><path d="M${from}L${to}" ${look}/>
      <rect class="printed" stroke="${color}" ${box}/><title>printed in the paper: ${escaped(text)}</title></g>`;
  });
  const stars = spec.stars.filter(isShown);
  const locus = spec.locus && stars.length > 1 ? `<path class="locus" d="${path(stars)}"/>` : "";
  return [
    ...areas,
    ...borders,
    ...ranges,
    ghosts,
    ...lines,
    `<g>${markers.join("")}</g>`,
    `<path class="doubt" d="${doubts.join("")}"/>`,
    here,
    ...measured,
    ...printed,
    locus,
    ...stars.map((star) => shape(star, star.symbol ?? STAR, "star")),
  ].join("");
}

const isDoubtful = ({ state }) => state && state.status !== "converged";

// Markers distinguish curves without colour: a few on each, at places that differ from curve to curve.
function markersOf(lines) {
  const marked = lines.filter(({ marker }) => marker !== undefined);
  return marked.flatMap(({ points, marker, color, faded }, rank) => {
    const step = points.length / MARKERS_PER_CURVE;
    const first = (step * (rank + 0.5)) / marked.length;
    const shape = d3.symbol(MARKERS[marker % MARKERS.length], 34)();
    const places = d3.range(MARKERS_PER_CURVE).map((i) => points[Math.floor(first + i * step)]);
    return places.map(({ x, y }) => ({ x, y, color, faded, shape }));
  });
}

// The limits of modes or regimes and the names between them, as SVG.
function zonesOf(spec, { y, left, right }) {
  const { limits = [], zones = [] } = VARIABLES[spec.y.name];
  const [low, high] = spec.y.domain;
  const inside = limits.filter((limit) => limit > low && limit < high && canShow(spec.y, limit));
  const lines = inside.map((limit) => `<path class="limit" d="M${left},${y(limit)}H${right}"/>`);
  const edges = [low, ...limits, high].map((edge) => y(Math.min(Math.max(edge, low), high)));
  const names = zones.map((zone, i) => {
    if (edges[i] - edges[i + 1] < 5) return "";
    const middle = 0.5 * (edges[i] + edges[i + 1]);
    return `<text class="zone" text-anchor="end" x="${right - 4}" y="${middle}" dy="0.32em">${zone}</text>`;
  });
  return [...lines, ...names].join("");
}

// What a chart shows, in words, for those who do not see it.
function described({ lines, stars, printed, measured, x, y }) {
  if (!lines.length) return "Nothing can be drawn at these conditions.";
  const { words, symbol } = VARIABLES[y.name];
  const ends = lines.slice(0, 12).map(({ label, points }) => {
    const known = points.filter((point) => canShow(x, point.x) && canShow(y, point.y));
    if (!known.length) return `${label}: no values`;
    const [first, last] = [known[0], known[known.length - 1]].map((point) => numberText(y.name, point.y));
    return `${label} runs from ${first} to ${last}`;
  });
  return [
    `${lines.length} curves of ${words} ${plainSymbol(symbol)} over ${VARIABLES[x.name].words}`,
    ...ends,
    lines.length > 12 ? `and ${lines.length - 12} more` : "",
    stars.length ? `${stars.length} turning points` : "",
    printed.length ? `${printed.length} numbers printed in the paper` : "",
    measured.length ? `${measured.length} points of your file` : "",
  ]
    .filter(Boolean)
    .join("; ");
}
