// The map of modes and regimes over two conditions, with the line of the turning points.

import { currentPoint, state } from "./state.js";
import { currentEngine, inSlices, placeAlong } from "./engine.js";
import { shownRange } from "./axes.js";
import { boundary, turningPointBetween } from "./curves.js";
import { specOf } from "./figures.js";
import { LIMITS } from "./model.js";
import { CROSS, isDark } from "./chart.js";
import { MODE_TEXT, wordOf } from "./names.js";

const SIZE = 64; // places along each axis
const STEPS = 7; // of the search for a border between two places
const PLACES = d3.range(SIZE);
const FILLS = {
  light: ["#eef1f4", "#cfe0f0", "#f6dfc2", "#efc0a5"],
  dark: ["#1a2129", "#1c3a55", "#51401f", "#6b3420"],
};
const [BOUNDARY_DASH, FULL_FILM_DASH] = ["7 3", "2 3"];
const TESTS = {
  all: () => true,
  twoBody: ({ mode }) => mode === 0,
  hybrid: ({ mode }) => mode >= 2,
  particles: ({ mode }) => mode === 3,
  unsolved: ({ mode }) => mode < 0,
  boundary: ({ regime }) => (regime < 0 ? null : regime === 0),
  full_film: ({ regime }) => (regime < 0 ? null : regime === 2),
};
const fills = () => FILLS[isDark() ? "dark" : "light"];
let running = 0;

// Calls `done` with the spec of the map when it is computed, unless another is asked for in between.
export function mapView(done) {
  const mine = ++running;
  inSlices(mapSteps(done), () => mine === running);
}

// Places are counted from 0 to SIZE - 1 along both axes; between them, fractions are conditions too.
function* mapSteps(done) {
  const [engine, point, x, y] = [currentEngine(), currentPoint(), state.map_x, state.map_y];
  const ends = Object.fromEntries([x, y].map((name) => [name, shownRange(name, point)]));
  const valueAt = (name, place) => placeAlong(name, ends[name], Math.min(Math.max(place / (SIZE - 1), 0), 1));
  const pointAt = (i, j) => ({ ...point, [x]: valueAt(x, i), [y]: valueAt(y, j) });
  const stateAt = (i, j) => engine.state(pointAt(i, j));
  const turningAt = ({ load, ...condition }) => {
    const found = turningPointBetween(engine.contact(condition), ...engine.loads);
    return found && { load: found.normal_load, isAbove: found.normal_load > load };
  };
  const over = (at) => ({ x: at[x], y: at[y] });
  function* ringsOf(results, testAt) {
    const rings = yield* borderOf(results, testAt);
    return rings.map((ring) => ring.map(([i, j, onBorder]) => ({ ...over(pointAt(i, j)), onBorder })));
  }

  const cells = [];
  for (const [j, i] of d3.cross(PLACES, PLACES)) {
    cells.push(stateAt(i, j));
    yield;
  }
  const borders = {};
  for (const [name, test] of Object.entries(TESTS)) {
    borders[name] = yield* ringsOf(cells.map(test), (i, j) => test(stateAt(i, j)));
  }
  const turning = [];
  const turns = [];
  if (x === "load" || y === "load") {
    for (const place of PLACES) {
      const at = pointAt(place, place);
      const load = turningAt(at)?.load ?? NaN;
      const isShown = load >= ends.load[0] && load <= ends.load[1];
      turning.push({ ...over({ ...at, load }), onBorder: isShown });
      yield;
    }
    turns.push(turning);
  } else {
    for (const [j, i] of d3.cross(PLACES, PLACES)) {
      turning.push(turningAt(pointAt(i, j))?.isAbove ?? null);
      yield;
    }
    turns.push(...(yield* ringsOf(turning, (i, j) => turningAt(pointAt(i, j))?.isAbove)));
  }
  const rows = PLACES.map((j) => ({
    label: "",
    points: PLACES.map((i) => ({ ...over(pointAt(i, j)), state: cells[j * SIZE + i] })),
  }));
  done(mapSpec({ x, y, ends, point, borders, turns, cells, rows: rows.reverse() }));
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

function mapSpec({ x, y, ends, point, borders, turns, cells, rows }) {
  const [twoBody, surfaces, hybrid, particles] = fills();
  const axisOver = (name) => ({
    name: name === "load" ? "normal_load" : name,
    log: name === "load" || name === "particle_density",
    domain: ends[name],
  });
  return specOf({
    title: `Contact mode and lubrication regime over ${wordOf(x).toLowerCase()} and ${wordOf(y).toLowerCase()}`,
    description: described(cells, x, y),
    x: axisOver(x),
    y: axisOver(y),
    areas: [
      { rings: borders.all, fill: surfaces },
      { rings: borders.hybrid, fill: hybrid },
      { rings: borders.particles, fill: particles },
      { rings: borders.twoBody, fill: twoBody },
      { rings: borders.unsolved, fill: "var(--paper)" },
    ],
    borders: [
      { rings: borders.boundary, kind: "regime", dash: BOUNDARY_DASH },
      { rings: borders.full_film, kind: "regime", dash: FULL_FILM_DASH },
      { rings: turns, kind: "turning", dash: "none" },
    ],
    stars: [{ x: point[x], y: point[y], color: "var(--ink)", symbol: CROSS }],
    rows,
  });
}

// What the colours and lines of the map mean.
export const mapKey = () => [
  ...MODE_TEXT.map((text, i) => ({ text, fill: fills()[i] })),
  { text: `boundary to mixed, L_s = ${LIMITS.boundary}`, color: "var(--accent)", dash: BOUNDARY_DASH },
  { text: `mixed to full film, L_s = ${LIMITS.full_film}`, color: "var(--accent)", dash: FULL_FILM_DASH },
  { text: "turning points of the contact area", color: "var(--fails)" },
];

function described(cells, x, y) {
  const count = (mode) => cells.filter((cell) => cell.mode === mode).length;
  const parts = MODE_TEXT.map((text, mode) => `${text} in ${Math.round((100 * count(mode)) / cells.length)} % of the map`);
  return `Over ${wordOf(x)} and ${wordOf(y)}: ${parts.join(", ")}.`;
}
