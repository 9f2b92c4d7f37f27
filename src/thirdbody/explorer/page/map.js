// The map of regimes and modes over two conditions, with the line of the turning points.

import { axes, currentPoint, state, toUnit } from "./state.js";
import { currentEngine, placesAlong } from "./engine.js";
import { shownRange } from "./axes.js";
import { turningPointBetween } from "./curves.js";
import { LIMITS } from "./model.js";
import { isDark } from "./figures.js";
import { conditionWord, letterOf, unitOf, wordOf } from "./names.js";
import { readable } from "./text.js";

const SIZE = 64; // places along each axis
const SLICE = 12; // milliseconds of work before the page may answer
const FARTHEST = 4.6; // of logits: a border next to 0 or 1 runs smoothly between cells
const FILLS = {
  light: ["#eef1f4", "#cfe0f0", "#f6dfc2", "#efc0a5"],
  dark: ["#1a2129", "#1c3a55", "#51401f", "#6b3420"],
};
const NAMES = ["two-body", "surface-surface", "hybrid", "particle-surface"];

const logit = (share) => Math.max(Math.min(Math.log(share / (1 - share)), FARTHEST), -FARTHEST);
let running = 0;

// States over both axes, in slices; calls `done` unless another map is asked for in between.
export function mapView(done) {
  const mine = ++running;
  const engine = currentEngine();
  const point = currentPoint();
  const [x, y] = [state.map_x, state.map_y];
  const [columns, rows] = [x, y].map((name) => placesAlong(name, shownRange(name, point), SIZE));
  const [cells, turning] = [[], []];
  const overLoad = x === "load" || y === "load";
  const at = (index) => ({ ...point, [x]: columns[index % SIZE], [y]: rows[Math.floor(index / SIZE)] });
  // where the load is an axis, a turning point for each place along the other; else how far the load is
  // from that of the turning point, at each cell
  const [other, places] = x === "load" ? [y, rows] : [x, columns];
  const count = overLoad ? SIZE : SIZE * SIZE;
  const work = () => {
    if (mine !== running) return;
    const start = performance.now();
    while (performance.now() - start < SLICE && turning.length < count) {
      if (cells.length < SIZE * SIZE) {
        cells.push(engine.state(at(cells.length)));
      } else {
        const where = overLoad ? { ...point, [other]: places[turning.length] } : at(turning.length);
        const { load, ...condition } = where;
        const found = turningPointBetween(engine.contact(condition), ...engine.loads);
        const newtons = found ? found.normal_load : NaN;
        const pair = x === "load" ? [newtons, where[other]] : [where[other], newtons];
        turning.push(overLoad ? pair : Math.log(newtons / load));
      }
    }
    if (turning.length < count) setTimeout(work);
    else done({ x, y, columns, rows, cells, point, turning });
  };
  work();
}

// Pieces of the line on which values over all cells are zero; where one is not a number there is none.
function zeroLine(values, place) {
  const pieces = [];
  for (let j = 0; j + 1 < SIZE; j++) {
    for (let i = 0; i + 1 < SIZE; i++) {
      const corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
      const here = corners.map(([a, b]) => values[b * SIZE + a]);
      if (here.some(Number.isNaN)) continue;
      const crossings = corners.flatMap(([a, b], k) => {
        const next = (k + 1) % 4;
        if (here[k] > 0 === here[next] > 0) return [];
        const share = here[k] / (here[k] - here[next]);
        return [place(a + share * (corners[next][0] - a), b + share * (corners[next][1] - b))];
      });
      for (let k = 0; k + 1 < crossings.length; k += 2) pieces.push(`M${crossings[k]}L${crossings[k + 1]}`);
    }
  }
  return pieces.join("");
}

export function drawMap(parent, found, { onRead, onLeave }) {
  const { x, y, columns, rows, cells, point, turning } = found;
  const em = parseFloat(getComputedStyle(document.documentElement).fontSize) / 14;
  const width = Math.max(parent.clientWidth, 240);
  const height = Math.min(Math.max(0.62 * width, 260 * em), 620 * em);
  const [left, right, top, bottom] = [64 * em, width - 16 * em, 12 * em, height - 44 * em];
  const fills = FILLS[isDark() ? "dark" : "light"];
  const figure = d3.select(parent).html("").append("figure");
  const title = `Contact mode and lubrication regime over ${wordOf(x).toLowerCase()} and ${wordOf(y).toLowerCase()}`;
  figure.append("figcaption").text(title);
  const svg = figure
    .append("svg")
    .attr("class", "chart map")
    .attr("xmlns", "http://www.w3.org/2000/svg")
    .attr("viewBox", `0 0 ${width} ${height}`)
    .attr("width", width)
    .attr("height", height)
    .attr("tabindex", 0)
    .attr("role", "application")
    .attr("aria-roledescription", "map; arrow keys read it")
    .attr("aria-label", title);
  svg.append("desc").text(mapWords(found));
  const [sx, sy] = [scale(x, columns, [left, right]), scale(y, rows, [bottom, top])];
  svg.append("rect").attr("x", left).attr("y", top).attr("width", right - left).attr("height", bottom - top).attr("fill", fills[1]);
  const within = (value) => Math.min(Math.max(value, 0), SIZE - 1) / (SIZE - 1);
  const pixel = (i, j) => [left + (right - left) * within(i), bottom - (bottom - top) * within(j)];
  // in contours a cell's value stands in its middle
  const line = d3.geoPath(
    d3.geoTransform({
      point(a, b) {
        this.stream.point(...pixel(a - 0.5, b - 0.5));
      },
    }),
  );
  const contour = (values, level) => d3.contours().size([SIZE, SIZE]).contour(values, level);
  const twoBody = cells.map((cell) => (cell.mode === 0 ? 1 : 0));
  const modes = cells.map((cell) => logit(cell.particle_contact_area_ratio));
  const regimes = cells.map((cell) => logit(cell.solid_load_fraction));
  const unsolved = cells.map((cell) => (cell.mode < 0 ? 1 : 0));
  const areas = [
    [modes, logit(LIMITS.surface), fills[2]],
    [modes, logit(LIMITS.particle), fills[3]],
    [twoBody, 0.5, fills[0]],
    [unsolved, 0.5, "var(--paper)"],
  ];
  for (const [values, level, fill] of areas) {
    svg.append("path").attr("d", line(contour(values, level))).attr("fill", fill).attr("stroke", "var(--soft)").attr("stroke-width", 0.8);
  }
  const borders = [
    [LIMITS.boundary, "7 3"],
    [LIMITS.full_film, "2 3"],
  ];
  for (const [limit, dash] of borders) {
    svg
      .append("path")
      .attr("class", "regime")
      .attr("d", edges(contour(regimes, logit(limit)), line))
      .attr("fill", "none")
      .attr("stroke", "var(--accent)")
      .attr("stroke-width", 1.8 * em)
      .attr("stroke-dasharray", dash);
  }
  const path = Array.isArray(turning[0])
    ? d3.line(([a]) => sx(a), ([, b]) => sy(b)).defined(([a, b]) => inside(a, columns) && inside(b, rows))(turning)
    : zeroLine(turning, (i, j) => pixel(i, j).map((value) => value.toFixed(1)));
  svg.append("path").attr("class", "turning").attr("d", path).attr("fill", "none").attr("stroke", "var(--fails)").attr("stroke-width", 2.4 * em);
  drawAxes(svg, [left, right, top, bottom], sx, sy, x, y, em);
  if (inside(point[x], columns) && inside(point[y], rows)) {
    svg.append("path").attr("d", d3.symbol(d3.symbolCross, 110 * em)()).attr("transform", `translate(${sx(point[x])},${sy(point[y])}) rotate(45)`).attr("fill", "var(--ink)").attr("stroke", "var(--paper)").append("title").text("your conditions");
  }
  const cursor = svg.append("circle").attr("class", "dot").attr("r", 5).attr("visibility", "hidden");
  let place = [SIZE >> 1, SIZE >> 1];
  const read = (event) => {
    const [i, j] = place;
    const at = [sx(columns[i]), sy(rows[j])];
    cursor.attr("cx", at[0]).attr("cy", at[1]).attr("visibility", "visible");
    const box = svg.node().getBoundingClientRect();
    const label = `${conditionWord(x, columns[i])}, ${conditionWord(y, rows[j])}`;
    onRead({ label, cell: cells[j * SIZE + i], at: [box.left + at[0], box.top + at[1]], event });
  };
  const leave = () => {
    cursor.attr("visibility", "hidden");
    onLeave();
  };
  const clamp = (value) => Math.min(Math.max(value, 0), SIZE - 1);
  svg.on("pointermove", (event) => {
    const [px, py] = d3.pointer(event, svg.node());
    place = [((px - left) / (right - left)) * (SIZE - 1), ((bottom - py) / (bottom - top)) * (SIZE - 1)].map((v) => clamp(Math.round(v)));
    read(event);
  });
  svg.on("pointerleave", leave).on("blur", leave);
  svg.on("keydown", (event) => {
    const move = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (!move) return;
    event.preventDefault();
    place = place.map((value, k) => clamp(value + move[k]));
    read(event);
  });
  return { svg: svg.node(), figure: figure.node(), fills };
}

// What the colours and lines of the map mean.
export function mapKey(fills) {
  const area = (fill, text) => ({ text, fill });
  return [
    ...NAMES.map((name, i) => area(fills[i], name)),
    { text: "L_s = 0.90: boundary to mixed", stroke: "var(--accent)", dash: "7 3" },
    { text: "L_s = 0.03: mixed to full film", stroke: "var(--accent)", dash: "2 3" },
    { text: "turning points of the contact area", stroke: "var(--fails)" },
  ];
}

const inside = (value, places) => value >= places[0] * (1 - 1e-9) && value <= places[places.length - 1] * (1 + 1e-9);

function scale(name, places, range) {
  const ends = [places[0], places[places.length - 1]];
  return (name === "load" || name === "particle_density" ? d3.scaleLog() : d3.scaleLinear()).domain(ends).range(range);
}

// A contour without the edge of the map, which closes it.
function edges(found, path) {
  const isEdge = ([a, b]) => a <= 0.5 || b <= 0.5 || a >= SIZE - 0.5 || b >= SIZE - 0.5;
  const parts = found.coordinates.flat().flatMap((ring) => {
    const lines = [[]];
    for (const at of ring) {
      if (isEdge(at) && lines[lines.length - 1].length && isEdge(lines[lines.length - 1].slice(-1)[0])) {
        lines.push([at]);
      } else lines[lines.length - 1].push(at);
    }
    return lines.filter((each) => each.length > 1);
  });
  return path({ type: "MultiLineString", coordinates: parts });
}

function drawAxes(svg, [left, right, top, bottom], sx, sy, x, y, em) {
  const text = (name) => (value) => (name === "load" && !isRound(value) ? "" : readable(toUnit(name, value), 4));
  const isRound = (value) => Math.abs(Math.log10(value) - Math.round(Math.log10(value))) < 1e-9;
  const parts = [
    [d3.axisBottom(sx).ticks(7).tickFormat(text(x)), `translate(0,${bottom})`],
    [d3.axisLeft(sy).ticks(7).tickFormat(text(y)), `translate(${left},0)`],
  ];
  for (const [axis, place] of parts) svg.append("g").attr("class", "axis").attr("transform", place).call(axis.tickSizeOuter(0));
  const label = (name) => {
    const unit = unitOf(axes.find((axis) => axis.name === name));
    return `${wordOf(name)} ${letterOf(name)} (${unit})`;
  };
  svg.append("text").attr("class", "label").attr("text-anchor", "middle").attr("x", 0.5 * (left + right)).attr("y", bottom + 36 * em).text(label(x));
  svg.append("text").attr("class", "label").attr("text-anchor", "middle").attr("transform", `translate(${14 * em},${0.5 * (top + bottom)}) rotate(-90)`).text(label(y));
}

function mapWords({ cells, x, y }) {
  const share = (mode) => Math.round((100 * cells.filter((cell) => cell.mode === mode).length) / cells.length);
  const parts = NAMES.map((name, mode) => [name, share(mode)]).filter(([, part]) => part > 0);
  return `Over ${wordOf(x)} and ${wordOf(y)}: ${parts.map(([name, part]) => `${name} in ${part} % of the map`).join(", ")}.`;
}
