// The map of modes and regimes over two conditions, with the line of the turning points.

import { axes, currentPoint, state } from "./state.js";
import { currentEngine, inSlices, placeAlong } from "./engine.js";
import { shownRange } from "./axes.js";
import { boundary, turningPointBetween } from "./curves.js";
import { LIMITS } from "./model.js";
import { drawAxes, frameOf, isDark, sizeIn, svgIn } from "./chart.js";
import { MODE_TEXT, conditionWord, wordOf } from "./names.js";

const SIZE = 64; // places along each axis
const STEPS = 7; // of the search for a border between two places
const PLACES = d3.range(SIZE);
const FILLS = {
  light: ["#eef1f4", "#cfe0f0", "#f6dfc2", "#efc0a5"],
  dark: ["#1a2129", "#1c3a55", "#51401f", "#6b3420"],
};
const fills = () => FILLS[isDark() ? "dark" : "light"];
let running = 0;

// Calls `done` with the map when it is computed, unless another is asked for in between.
export function mapView(done) {
  const mine = ++running;
  inSlices(mapSteps(done), () => mine === running);
}

// Places are counted from 0 to SIZE - 1 along both axes; between them, fractions are conditions too.
function* mapSteps(done) {
  const [engine, point, x, y] = [currentEngine(), currentPoint(), state.map_x, state.map_y];
  const ends = Object.fromEntries([x, y].map((name) => [name, shownRange(name, point)]));
  const valueAt = (name, place) => placeAlong(name, ends[name], place / (SIZE - 1));
  const pointAt = (i, j) => ({ ...point, [x]: valueAt(x, i), [y]: valueAt(y, j) });
  const stateAt = (i, j) => engine.state(pointAt(i, j));
  const turningAt = ({ load, ...condition }) => {
    const found = turningPointBetween(engine.contact(condition), ...engine.loads);
    return found && { load: found.normal_load, isAbove: found.normal_load > load };
  };

  const cells = [];
  for (const [j, i] of d3.cross(PLACES, PLACES)) {
    cells.push(stateAt(i, j));
    yield;
  }
  const borders = {};
  const tests = {
    twoBody: ({ mode }) => mode === 0,
    hybrid: ({ mode }) => mode >= 2,
    particles: ({ mode }) => mode === 3,
    unsolved: ({ mode }) => mode < 0,
    boundary: ({ regime }) => (regime < 0 ? null : regime === 0),
    full_film: ({ regime }) => (regime < 0 ? null : regime === 2),
  };
  for (const [name, test] of Object.entries(tests)) {
    borders[name] = yield* borderOf(cells.map(test), (i, j) => test(stateAt(i, j)));
  }

  let turning;
  if (x === "load" || y === "load") {
    const other = x === "load" ? y : x;
    const line = [];
    for (const place of PLACES) {
      const value = valueAt(other, place);
      const load = turningAt({ ...point, [other]: value })?.load ?? NaN;
      line.push(x === "load" ? [load, value] : [value, load]);
      yield;
    }
    turning = { line };
  } else {
    const isAbove = [];
    for (const [j, i] of d3.cross(PLACES, PLACES)) {
      isAbove.push(turningAt(pointAt(i, j))?.isAbove ?? null);
      yield;
    }
    turning = { rings: yield* borderOf(isAbove, (i, j) => turningAt(pointAt(i, j))?.isAbove) };
  }
  const [columns, rows] = [x, y].map((name) => PLACES.map((place) => valueAt(name, place)));
  done({ x, y, columns, rows, cells, point, borders, turning });
}

// Rings around the cells where a test is true; each corner is [i, j, whether it is on a border].
// D3 finds between which cells the border runs, a search finds where. There is no border at the edge of
// the map, and none beside cells for which the test is null.
function* borderOf(results, testAt) {
  const contours = d3.contours().size([SIZE, SIZE]).smooth(false);
  const { coordinates } = contours.contour(results.map(Number), 0.5);
  const rings = [];
  for (const ring of coordinates.flat()) {
    const corners = [];
    for (const [a, b] of ring) {
      corners.push(cornerAt(a - 0.5, b - 0.5, results, testAt));
      yield;
    }
    rings.push(corners);
  }
  return rings;
}

function cornerAt(i, j, results, testAt) {
  const ends = [Math.floor, Math.ceil].map((round) => [round(i), round(j)]);
  const isInside = ([a, b]) => results[b * SIZE + a];
  const isOnMap = ends.flat().every((place) => place >= 0 && place < SIZE);
  if (!isOnMap || ends.some((end) => isInside(end) === null)) return [i, j, false];
  const [inner, outer] = isInside(ends[0]) ? ends : [...ends].reverse();
  const at = (part) => [0, 1].map((k) => inner[k] + part * (outer[k] - inner[k]));
  return [...at(boundary((part) => testAt(...at(part)), 0, 1, STEPS)), true];
}

export function drawMap(parent, found, { onRead, onLeave }) {
  const { x, y, columns, rows, cells, point, borders, turning } = found;
  const { em, width } = sizeIn(parent);
  const height = Math.min(Math.max(0.62 * width, 260 * em), 620 * em);
  const figure = d3.select(parent).html("").append("figure");
  const title = `Contact mode and lubrication regime over ${wordOf(x).toLowerCase()} and ${wordOf(y).toLowerCase()}`;
  figure.append("figcaption").text(title);
  const svg = svgIn(figure, "map").attr("viewBox", `0 0 ${width} ${height}`).attr("aria-label", title);
  svg.append("desc").text(described(found));
  const spec = { x: axisOver(x, columns), y: axisOver(y, rows) };
  const frame = frameOf(spec, { em, width, height });
  const { left, right, top, bottom } = frame;

  const scales = [[left, right], [bottom, top]].map((range) => d3.scaleLinear([0, SIZE - 1], range).clamp(true));
  const line = d3.line(([i]) => scales[0](i), ([, j]) => scales[1](j)).digits(1);
  const area = (rings, fill) => `<path class="area" d="${rings.map((ring) => `${line(ring)}Z`).join("")}" fill="${fill}"/>`;
  const border = (rings) => rings.map((ring) => line.defined((corner) => corner[2])(ring)).join("");
  const isOnMap = ([a, b]) => a >= columns[0] && b >= rows[0] && a <= columns[SIZE - 1] && b <= rows[SIZE - 1];
  const turns = d3.line(([a]) => frame.x(a), ([, b]) => frame.y(b)).defined(isOnMap);
  const [twoBody, surfaces, hybrid, particles] = fills();
  svg.append("g").html(
    `<rect x="${left}" y="${top}" width="${right - left}" height="${bottom - top}" fill="${surfaces}"/>` +
      area(borders.hybrid, hybrid) +
      area(borders.particles, particles) +
      area(borders.twoBody, twoBody) +
      area(borders.unsolved, "var(--paper)") +
      `<path class="regime" d="${border(borders.boundary)}" stroke-dasharray="7 3"/>` +
      `<path class="regime" d="${border(borders.full_film)}" stroke-dasharray="2 3"/>` +
      `<path class="turning" d="${turning.line ? turns(turning.line) : border(turning.rings)}"/>`,
  );
  drawAxes(svg.append("g"), spec, frame, em);
  svg.select("path.grid").remove();
  if (isOnMap([point[x], point[y]])) {
    const place = `translate(${frame.x(point[x])},${frame.y(point[y])}) rotate(45)`;
    const cross = svg.append("path").attr("class", "star").attr("transform", place);
    cross.attr("d", d3.symbol(d3.symbolCross, 110 * em)()).append("title").text("your conditions");
  }

  const cursor = svg.append("circle").attr("class", "dot").attr("r", 5).attr("visibility", "hidden");
  let place = [SIZE >> 1, SIZE >> 1];
  const moveTo = (event, places) => {
    place = places.map((each) => Math.min(Math.max(Math.round(each), 0), SIZE - 1));
    const [i, j] = place;
    const at = [frame.x(columns[i]), frame.y(rows[j])];
    cursor.attr("cx", at[0]).attr("cy", at[1]).attr("visibility", "visible");
    const box = svg.node().getBoundingClientRect();
    const label = `${conditionWord(x, columns[i])}, ${conditionWord(y, rows[j])}`;
    onRead({ label, cell: cells[j * SIZE + i], at: [box.left + at[0], box.top + at[1]], event });
  };
  const leave = () => {
    cursor.attr("visibility", "hidden");
    onLeave();
  };
  svg.on("pointermove", (event) => {
    const [a, b] = d3.pointer(event, svg.node());
    moveTo(event, [scales[0].invert(a), scales[1].invert(b)]);
  });
  svg.on("pointerleave", leave).on("blur", leave);
  svg.on("keydown", (event) => {
    const move = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (!move) return;
    event.preventDefault();
    moveTo(event, place.map((each, k) => each + move[k]));
  });
}

const axisOver = (name, places) => ({
  name: name === "load" ? "normal_load" : name,
  log: name === "load" || name === "particle_density",
  domain: d3.extent(places),
});

// What the colours and lines of the map mean.
export const mapKey = () => [
  ...MODE_TEXT.map((text, i) => ({ text, fill: fills()[i] })),
  { text: `boundary to mixed, L_s = ${LIMITS.boundary}`, color: "var(--accent)", dash: "7 3" },
  { text: `mixed to full film, L_s = ${LIMITS.full_film}`, color: "var(--accent)", dash: "2 3" },
  { text: "turning points of the contact area", color: "var(--fails)" },
];

function described({ cells, x, y }) {
  const percent = (mode) => Math.round((100 * cells.filter((cell) => cell.mode === mode).length) / cells.length);
  const parts = MODE_TEXT.map((text, mode) => [text, percent(mode)]).filter(([, part]) => part > 0);
  return `Over ${wordOf(x)} and ${wordOf(y)}: ${parts.map(([text, part]) => `${text} in ${part} % of the map`).join(", ")}.`;
}
