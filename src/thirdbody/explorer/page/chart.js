// One panel: axes, curves, bands, marks; what is under the pointer or the keys.

import { VARIABLES, axisTitle, numberText, plainSymbol, symbolParts } from "./names.js";
import { powerOfTen, readable } from "./text.js";

const STAR = d3.symbol(d3.symbolStar, 90)();
const DIAMOND = d3.symbol(d3.symbolDiamond, 60)();
const MARKERS = [
  d3.symbolCircle,
  d3.symbolSquare,
  d3.symbolTriangle,
  d3.symbolDiamond,
  d3.symbolCross,
  d3.symbolWye,
].map((type) => d3.symbol(type, 34)());
const MARKERS_PER_CURVE = 5;
const NEAR = 40; // pixels from which the pointer reads a curve
const GRID_TICKS = 6;

export const isLog = (name, wish) => (wish === "auto" ? VARIABLES[name].log : wish === "log");

// Ends of an axis around values.
export function domainOf(name, values, log) {
  const { share } = VARIABLES[name];
  const known = values.filter((value) => Number.isFinite(value) && (!log || value > 0));
  if (!known.length) return share ? [0, 1] : log ? [0.1, 1] : [0, 1];
  let [low, high] = d3.extent(known);
  if (log) {
    low = Math.max(low, high * 1e-12);
    const margin = Math.max((high / low) ** 0.02, 1.02);
    return [low / margin, high * margin];
  }
  if (share) {
    const top = high > 0 && high < 0.5 ? 1.08 * high : 1;
    return [-0.04 * top, 1.06 * top];
  }
  const margin = 0.04 * (high - low || Math.abs(high) || 1);
  return [low - margin, high + margin];
}

// A chart in an element: `room` measures its place, `update` draws a spec there, `spec` is what it shows.
export function chartIn(parent, { onRead, onLeave }) {
  const figure = d3.select(parent).append("figure");
  const title = figure.append("figcaption");
  const svg = figure
    .append("svg")
    .attr("class", "chart")
    .attr("xmlns", "http://www.w3.org/2000/svg")
    .attr("tabindex", 0)
    .attr("role", "application")
    .attr("aria-roledescription", "chart; arrow keys read it");
  const description = svg.append("desc");
  const clipId = `clip-${Math.random().toString(36).slice(2)}`;
  const clip = svg.append("clipPath").attr("id", clipId).append("rect");
  const layer = Object.fromEntries(
    ["grid", "limits", "axes"].map((name) => [name, svg.append("g")]),
  );
  const inside = svg.append("g").attr("clip-path", `url(#${clipId})`);
  for (const name of ["bands", "ghosts", "lines", "markers", "doubts", "here", "printed", "stars", "cursor"]) {
    layer[name] = inside.append("g");
  }
  layer.zones = svg.append("g"); // names above the curves
  const chart = { figure: figure.node(), svg: svg.node(), spec: null, room, update, clear };
  let scales = null;
  let framed = ""; // what the axes that are drawn belong to
  let dressed = ""; // and the look of the lines
  let place = { line: 0, point: 0 };

  // apart from `update`: measured between changes, each chart would lay the whole page out
  function room() {
    const em = parseFloat(getComputedStyle(document.documentElement).fontSize) / 14;
    return { em, width: Math.max(svg.node().parentNode.clientWidth, 220) };
  }

  function update(spec, { em, width }) {
    chart.spec = spec;
    const height = Math.round(Math.min(Math.max(0.68 * width, 220 * em), Math.max(430 * em, 0.37 * innerHeight)));
    const margin = { left: 58 * em, right: 14 * em, top: (spec.top ? 36 : 12) * em, bottom: 40 * em };
    const [left, right, top, bottom] = [margin.left, width - margin.right, margin.top, height - margin.bottom];
    svg.attr("viewBox", `0 0 ${width} ${height}`).attr("width", width).attr("height", height);
    svg.attr("aria-label", spec.title);
    description.text(spec.description);
    title.html("").append("b").text(spec.letter);
    title.append("span").text(spec.title);
    clip.attr("x", left).attr("y", top).attr("width", right - left).attr("height", bottom - top);
    const x = scaleOf(spec.x).range([left, right]);
    const y = scaleOf(spec.y).range([bottom, top]);
    scales = { x, y, left, right, top, bottom };
    const frame = JSON.stringify([width, em, spec.x, spec.y, spec.top]);
    if (frame !== framed) {
      drawAxes(spec, em);
      drawZones(spec);
      framed = frame;
    }
    const inX = (value) => x(value);
    const inY = (value) => y(value);
    const path = d3
      .line(
        (point) => inX(point.x),
        (point) => inY(point.y),
      )
      .defined((point) => canShow(spec.x, point.x) && canShow(spec.y, point.y))
      .digits(1);
    const area = d3.line(([a]) => inX(a), ([, b]) => inY(b));
    layer.bands
      .selectAll("path")
      .data(spec.bands)
      .join("path")
      .attr("d", (band) => area(band.points.map(([a, b]) => [a, held(spec.y, b)])))
      .attr("fill", (band) => band.color)
      .attr("fill-opacity", (band) => (band.faded ? 0.03 : 0.1));
    const ghosts = spec.ghosts.map(path).join("");
    layer.ghosts.selectAll("path").data([ghosts]).join("path").attr("class", "ghost").attr("d", ghosts);
    const lines = layer.lines.selectAll("path").data(spec.lines).join("path");
    lines.attr("d", (line) => path(line.points));
    const marks = placesOfMarkers(spec);
    const markers = layer.markers.selectAll("path").data(marks).join("path");
    markers.attr("transform", ({ point }) => `translate(${inX(point.x)},${inY(point.y)}) scale(${em})`);
    const look = JSON.stringify([em, marks.length, spec.lines.map(({ points, turningPoint, states, ...rest }) => rest)]);
    if (look !== dressed) dress(lines, markers, em);
    dressed = look;
    const doubts = spec.lines.flatMap(({ points }) => points.filter(isInDoubt));
    const crosses = doubts.filter((point) => canShow(spec.x, point.x) && canShow(spec.y, point.y));
    const cross = ({ x: a, y: b }) => `M${inX(a) - 3},${inY(b) - 3}l6,6m-6,0l6,-6`;
    layer.doubts.selectAll("path").data([crosses.map(cross).join("")]).join("path").attr("class", "doubt").attr("d", (d) => d);
    drawMarks(spec, inX, inY, em);
    layer.here
      .selectAll("line")
      .data(spec.here && canShow(spec.x, spec.here) ? [spec.here] : [])
      .join("line")
      .attr("class", "here")
      .attr("x1", inX)
      .attr("x2", inX)
      .attr("y1", top)
      .attr("y2", bottom);
    clear();
  }

  // the look of lines and markers, which stays while they move
  function dress(lines, markers, em) {
    lines
      .attr("class", (line) => `line${line.faded ? " faded" : ""}${line.chosen ? " chosen" : ""}`)
      .attr("stroke", (line) => line.color)
      .attr("stroke-width", (line) => (line.chosen ? 2.8 : (line.width ?? 1.6)) * em)
      .attr("stroke-dasharray", (line) => line.dash ?? null)
      .attr("data-label", (line) => line.label);
    markers
      .attr("class", ({ line }) => (line.faded ? "faded" : null))
      .attr("d", ({ line }) => MARKERS[line.marker % MARKERS.length])
      .attr("fill", ({ line }) => line.color);
  }

  function drawAxes(spec, em) {
    const { x, y, left, right, top, bottom } = scales;
    const [ticksX, ticksY] = [spec.x, spec.y].map((axis) => (axis.log ? null : axis));
    const bottomAxis = axisWith(d3.axisBottom(x), spec.x, ticksX, right - left);
    const leftAxis = axisWith(d3.axisLeft(y), spec.y, ticksY, bottom - top);
    // one path, as many elements are slow to lay out
    const small = [
      ...minorTicks(spec.x).map((value) => `M${x(value)},${bottom}v4`),
      ...minorTicks(spec.y).map((value) => `M${left},${y(value)}h-4`),
    ];
    const parts = [
      ["axis", `translate(0,${bottom})`, bottomAxis],
      ["axis", `translate(${left},0)`, leftAxis],
    ];
    if (spec.top) {
      const newtons = x.copy().domain(x.domain().map((end) => end * spec.top));
      parts.push(["axis", `translate(0,${top})`, axisWith(d3.axisTop(newtons), { name: "newtons", log: true }, null, right - left)]);
      const values = minorTicks({ log: spec.x.log, domain: newtons.domain() });
      small.push(...values.map((value) => `M${newtons(value)},${top}v-4`));
    }
    layer.axes
      .selectAll("g.axis")
      .data(parts)
      .join("g")
      .attr("class", "axis")
      .attr("transform", (part) => part[1])
      .each(function (part) {
        d3.select(this).call(part[2]);
      });
    layer.axes.selectAll("path.minor").data([small.join("")]).join("path").attr("class", "minor").attr("d", (path) => path);
    layer.grid
      .selectAll("g.grid")
      .data([
        [`translate(0,${bottom})`, d3.axisBottom(x).tickSize(top - bottom), ticksX],
        [`translate(${left},0)`, d3.axisLeft(y).tickSize(left - right), ticksY],
      ])
      .join("g")
      .attr("class", "grid")
      .attr("transform", (part) => part[0])
      .each(function ([, axis, linear]) {
        const values = linear ? null : decades(axis.scale().domain());
        d3.select(this).call(axis.tickFormat("").ticks(GRID_TICKS).tickValues(values)).select(".domain").remove();
      });
    const labels = [
      [axisTitle(spec.x.name), 0.5 * (left + right), bottom + 34 * em, 0],
      [axisTitle(spec.y.name), 13 * em, 0.5 * (top + bottom), -90],
    ];
    if (spec.top) labels.push([{ symbol: "Fₜ", unit: "N" }, 0.5 * (left + right), top - 24 * em, 0]);
    layer.axes
      .selectAll("text.label")
      .data(labels)
      .join("text")
      .attr("class", "label")
      .attr("text-anchor", "middle")
      .attr("transform", ([, a, b, turn]) => `translate(${a},${b}) rotate(${turn})`)
      .each(function ([label]) {
        writeSymbol(d3.select(this), label);
      });
  }

  function drawZones(spec) {
    const { y, left, right } = scales;
    const { limits = [], zones = [] } = VARIABLES[spec.y.name];
    const [low, high] = y.domain();
    const shown = limits.filter((limit) => limit > low && limit < high && canShow(spec.y, limit));
    layer.limits
      .selectAll("line")
      .data(shown)
      .join("line")
      .attr("class", "limit")
      .attr("x1", left)
      .attr("x2", right)
      .attr("y1", y)
      .attr("y2", y);
    const edges = [low, ...limits, high];
    const names = zones
      .map((zone, i) => [zone, Math.max(edges[i], low), Math.min(edges[i + 1], high)])
      .filter(([, from, to]) => to > from && Math.abs(y(to) - y(from)) > 5);
    layer.zones
      .selectAll("text")
      .data(names)
      .join("text")
      .attr("class", "zone")
      .attr("text-anchor", "end")
      .attr("x", right - 4)
      .attr("y", ([, from, to]) => 0.5 * (y(from) + y(to)))
      .attr("dy", "0.32em")
      .text(([zone]) => zone);
  }

  // Markers tell curves apart without colour: a few on each, at places of its own.
  function placesOfMarkers(spec) {
    const marked = spec.lines.filter((line) => line.marker !== undefined);
    return marked.flatMap((line, rank) => {
      const step = line.points.length / MARKERS_PER_CURVE;
      const first = step * ((rank + 0.5) / marked.length);
      return Array.from({ length: MARKERS_PER_CURVE }, (_, i) => line.points[Math.floor(first + i * step)])
        .filter((point) => point && canShow(spec.x, point.x) && canShow(spec.y, point.y))
        .map((point) => ({ line, point }));
    });
  }

  function drawMarks(spec, inX, inY, em) {
    const marks = layer.printed
      .selectAll("g")
      .data(spec.printed)
      .join((enter) => {
        const group = enter.append("g");
        group.append("line");
        group.append("rect");
        group.append("title");
        return group;
      })
      .attr("class", (mark) => (mark.faded ? "faded" : null))
      .attr("data-claim", (mark) => mark.id);
    const half = (mark) => (mark.chosen ? 6 : 3.6) * em;
    marks
      .select("line")
      .attr("stroke", (mark) => mark.color)
      .attr("stroke-width", (mark) => (mark.chosen ? 3 : 1.4) * em)
      .attr("x1", (mark) => inX(mark.ends[0][0]))
      .attr("x2", (mark) => inX(mark.ends[1][0]))
      .attr("y1", (mark) => inY(held(spec.y, mark.ends[0][1])))
      .attr("y2", (mark) => inY(held(spec.y, mark.ends[1][1])));
    marks
      .select("rect")
      .attr("class", "printed")
      .attr("stroke", (mark) => mark.color)
      .attr("x", (mark) => inX(mark.at[0]) - half(mark))
      .attr("y", (mark) => inY(mark.at[1]) - half(mark))
      .attr("width", (mark) => 2 * half(mark))
      .attr("height", (mark) => 2 * half(mark));
    marks.select("title").text((mark) => `printed in the paper: ${mark.text}`);
    const stars = spec.stars.filter((star) => canShow(spec.x, star.x) && canShow(spec.y, star.y));
    const locus = spec.locus && stars.length > 1 ? [d3.line((s) => inX(s.x), (s) => inY(s.y))(stars)] : [];
    layer.stars
      .selectAll("path.locus")
      .data(locus)
      .join("path")
      .attr("class", "locus")
      .attr("d", (path) => path)
      .attr("fill", "none")
      .attr("stroke", "var(--ink)")
      .attr("stroke-width", 1.6 * em)
      .attr("stroke-dasharray", "7 3");
    layer.stars
      .selectAll("path.star")
      .data([...stars, ...spec.diamonds])
      .join("path")
      .attr("class", (star) => (star.faded ? "star faded" : "star"))
      .attr("d", (star) => (star.diamond ? DIAMOND : STAR))
      .attr("fill", (star) => star.color ?? "var(--ink)")
      .attr("stroke", "var(--paper)")
      .attr("stroke-width", 0.8)
      .attr("transform", (star) => `translate(${inX(star.x)},${inY(star.y)}) scale(${em})`);
  }

  // --- reading ---

  function read(line, index, event) {
    const point = line.points[index];
    const { x, y, left, right, top, bottom } = scales;
    const [px, py] = [x(point.x), y(point.y)];
    layer.cursor
      .selectAll("line")
      .data([
        [px, px, top, bottom],
        [left, right, py, py],
      ])
      .join("line")
      .attr("class", "cursor")
      .attr("x1", (ends) => ends[0])
      .attr("x2", (ends) => ends[1])
      .attr("y1", (ends) => ends[2])
      .attr("y2", (ends) => ends[3]);
    layer.cursor.selectAll("circle").data([0]).join("circle").attr("class", "dot").attr("cx", px).attr("cy", py).attr("r", 4.5);
    const box = svg.node().getBoundingClientRect();
    onRead({ chart, line, point, at: [box.left + px, box.top + py], event });
  }

  function clear() {
    layer.cursor.selectAll("*").remove();
  }

  const shownPoint = (point) => canShow(chart.spec.x, point.x) && canShow(chart.spec.y, point.y);

  svg.on("pointermove", (event) => {
    const [px, py] = d3.pointer(event, svg.node());
    let best = { far: NEAR };
    chart.spec.lines.forEach((line, number) => {
      line.points.forEach((point, index) => {
        if (!shownPoint(point)) return;
        const far = Math.hypot(scales.x(point.x) - px, scales.y(point.y) - py);
        if (far < best.far) best = { far, line: number, point: index };
      });
    });
    if (best.line === undefined) return leave();
    place = best;
    read(chart.spec.lines[best.line], best.point, event);
  });
  const leave = () => {
    clear();
    onLeave();
  };
  svg.on("pointerleave", leave).on("blur", leave);
  svg.on("keydown", (event) => {
    const { lines } = chart.spec;
    const move = { ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowUp: [-1, 0], ArrowDown: [1, 0], Home: [0, -1e6], End: [0, 1e6] }[event.key];
    if (event.key === "Escape") return leave();
    if (!move || !lines.length) return;
    event.preventDefault();
    place.line = (Math.min(place.line, lines.length - 1) + move[0] + lines.length) % lines.length;
    const line = lines[place.line];
    const known = line.points.map((_, i) => i).filter((i) => shownPoint(line.points[i]));
    if (!known.length) return;
    const rank = d3.bisectLeft(known, place.point) + (event.shiftKey ? 10 : 1) * move[1];
    place.point = known[Math.min(Math.max(rank, 0), known.length - 1)];
    read(line, place.point, event);
  });
  return chart;
}

const isInDoubt = ({ state }) => state && state.status !== "converged";
const canShow = (axis, value) => Number.isFinite(value) && (!axis.log || value > 0);
const held = (axis, value) => (axis.log ? Math.max(value, axis.domain[0] * 1e-3) : value);

const scaleOf = ({ log, domain }) => (log ? d3.scaleLog() : d3.scaleLinear()).domain(domain);

function decades([low, high]) {
  const [first, last] = [Math.ceil(Math.log10(low)), Math.floor(Math.log10(high))];
  const step = Math.ceil((last - first + 1) / 9);
  return d3.range(first, last + 1, step).map((exponent) => 10 ** exponent);
}

// Ticks: powers of ten on a logarithmic axis, in the unit of the variable on a linear one.
function axisWith(axis, { name, log }, linear, length) {
  const { factor = 1, percent } = VARIABLES[name] ?? {};
  if (!log) {
    const shown = (value) => readable(value * (percent ? 100 : factor), 4);
    return axis.ticks(Math.max(Math.min(GRID_TICKS, length / 55), 2)).tickFormat(shown).tickSizeOuter(0);
  }
  const major = decades(axis.scale().domain());
  const plain = name === "newtons";
  const few = major.length < 2;
  const text = (value) =>
    few || (plain && value > 1e-4 && value < 1e5) ? readable(value, 3) : powerOfTen(Math.round(Math.log10(value)));
  return axis.tickValues(few ? axis.scale().ticks(5) : major).tickFormat(text).tickSizeOuter(0);
}

// small ticks of a logarithmic axis: twofold to ninefold powers of ten, unless there are many
function minorTicks({ log, domain: [low, high] }) {
  const count = log ? decades([low, high]).length : 0;
  if (count < 2 || count > 7) return [];
  const powers = d3.range(Math.floor(Math.log10(low)), Math.ceil(Math.log10(high)));
  return powers
    .flatMap((exponent) => d3.range(2, 10).map((digit) => digit * 10 ** exponent))
    .filter((value) => value > low && value < high);
}

function writeSymbol(text, { symbol, unit }) {
  const [letter, below, above] = symbolParts(symbol);
  text.text("").append("tspan").attr("font-style", "italic").text(letter);
  if (below) text.append("tspan").attr("dy", "0.3em").attr("font-size", "0.8em").text(below);
  if (above) text.append("tspan").attr("dy", below ? "-0.3em" : null).text(above);
  if (unit) text.append("tspan").attr("dy", below && !above ? "-0.3em" : null).text(` (${unit})`);
}

// What a chart shows, in words, for those who do not see it.
export function described({ lines, stars, printed, x, y }) {
  if (!lines.length) return "Nothing can be drawn at these conditions.";
  const ends = lines.slice(0, 12).map((line) => {
    const known = line.points.filter((point) => canShow(x, point.x) && canShow(y, point.y));
    if (!known.length) return `${line.label}: no values`;
    const [first, last] = [known[0], known[known.length - 1]];
    return `${line.label} runs from ${numberText(y.name, first.y)} to ${numberText(y.name, last.y)}`;
  });
  const more = lines.length > 12 ? [`and ${lines.length - 12} more`] : [];
  const counts = [`${lines.length} curves of ${VARIABLES[y.name].words} ${plainSymbol(VARIABLES[y.name].symbol)} over ${VARIABLES[x.name].words}`];
  const extras = [
    stars.length ? `${stars.length} turning points` : "",
    printed.length ? `${printed.length} numbers printed in the paper` : "",
  ].filter(Boolean);
  return [...counts, ...ends, ...more, ...extras].join("; ");
}
