// The map of modes and regimes over two conditions, with the line of the turning points.

import { currentPoint, state } from "./state.js";
import { currentEngine, inSlices, shownRange } from "./engine.js";
import { boundary, turningPointBetween } from "./curves.js";
import { specOf } from "./chart.js";
import { remembered } from "./model.js";
import { FULL_FILM, MODE_TEXT, REGIME_TEXT, VARIABLES, ofCondition, scaleFor, valueText, wordOf } from "./names.js";

const SIZE = 64; // places along each axis, counted from 0; between them, fractions are conditions too
const STEPS = 7; // of the search for a border between two places
const PLACES = d3.range(SIZE);
const CELLS = d3.cross(PLACES, PLACES, (j, i) => [i, j]);
const AROUND = d3.cross(d3.range(-2, 3), d3.range(-1, 2)); // a name is wider than high
const LEAST_ROOM = 2; // of a name, in such steps around it
const FILLS = ["var(--ground)", "var(--surfaces)", "var(--hybrid)", "var(--particles)"]; // by mode
// Each layer encloses some states. Beside states for which this is NaN there is no border.
const AREAS = [
  { fill: FILLS[1], encloses: () => true },
  { fill: FILLS[2], encloses: ({ mode }) => mode >= 2 },
  { fill: FILLS[3], encloses: ({ mode }) => mode === 3 },
  { fill: FILLS[0], encloses: ({ mode }) => mode === 0 },
  { fill: "var(--lubricant)", encloses: ({ regime }) => regime === FULL_FILM },
  { fill: "var(--paper)", encloses: ({ mode }) => mode < 0 },
];
const BORDERS = [{ kind: "regime", encloses: ({ regime }) => (regime < 0 ? NaN : regime === 0) }];

export const mapTitle = () =>
  `Contact mode and lubrication regime over ${wordOf(state.map_x).toLowerCase()} and ${wordOf(state.map_y).toLowerCase()}`;

// Compute the map, then call `done` with its spec and the entries of its key, unless another map is wanted by then.
export const mapView = (element, done) => inSlices(element, mapSteps(done), () => state.view === "map");

function* mapSteps(done) {
  const [engine, point, x, y] = [currentEngine(), currentPoint(), state.map_x, state.map_y];
  const scaleOver = (name) => scaleFor(name).domain(shownRange(name, point)).range([0, SIZE - 1]).clamp(true);
  const [xScale, yScale] = [scaleOver(x), scaleOver(y)];
  const pointAt = ([i, j]) => ({ ...point, [x]: xScale.invert(i), [y]: yScale.invert(j) });
  const stateAt = (place) => engine.state(pointAt(place));
  const cornerAt = ([i, j, onBorder]) => ({ x: xScale.invert(i), y: yScale.invert(j), onBorder });
  const turningLoad = remembered((condition) => {
    const found = turningPointBetween(engine.contact(condition), ...engine.loads);
    return found?.normal_load ?? NaN;
  }, CELLS.length);

  const cells = [];
  for (const cell of CELLS) {
    cells.push(stateAt(cell));
    yield;
  }
  const layers = [];
  for (const { encloses, ...look } of [...AREAS, ...BORDERS]) {
    const rings = [];
    for (const ring of ringsAround(cells.map(encloses), 0.5)) {
      rings.push(ring.map((corner) => cornerAt(refined(corner, (place) => encloses(stateAt(place))))));
      yield;
    }
    layers.push({ ...look, rings });
  }
  const above = []; // by how much the turning point of each cell is above its load, in logarithms
  for (const cell of CELLS) {
    const { load, ...condition } = pointAt(cell);
    above.push(Math.log(turningLoad(condition) / load));
    yield;
  }
  const turns = ringsAround(above, 0).map((ring) => ring.map(cornerAt));
  const [names, unnamed] = [[], []];
  for (const [text, of] of d3.group(d3.range(cells.length), (k) => nameOf(cells[k]))) {
    const place = roomIn(of);
    if (place) names.push({ ...cornerAt(place), lines: text.split(", ") });
    else unnamed.push({ text, fill: fillOf(cells[of[0]]) });
    yield;
  }
  const axisOver = (name, scale) => ({ name: ofCondition(name), log: VARIABLES[name].log, domain: scale.domain() });
  const rangeOf = (name, scale) =>
    `${wordOf(name).toLowerCase()} from ${scale.domain().map((end) => valueText(name, end, 2)).join(" to ")}`;
  const share = (isIt) => `${Math.round((100 * cells.filter(isIt).length) / cells.length)} % of the map`;
  const parts = MODE_TEXT.map((text, mode) => `${text} in ${share((cell) => cell.mode === mode && cell.regime !== FULL_FILM)}`);
  const film = `full film in ${share(({ regime }) => regime === FULL_FILM)}`;
  const points = CELLS.map((cell, k) => ({ ...cornerAt(cell), state: cells[k] }));
  const spec = specOf({
    title: mapTitle(),
    description: `Over ${rangeOf(x, xScale)} and ${rangeOf(y, yScale)}: ${[...parts, film].join(", ")}.`,
    x: axisOver(x, xScale),
    y: axisOver(y, yScale),
    areas: layers.slice(0, AREAS.length),
    borders: [...layers.slice(AREAS.length), { kind: "turning", rings: turns }],
    crosses: [{ x: point[x], y: point[y] }],
    names,
    rows: PLACES.map((j) => ({ label: "", points: points.slice(j * SIZE, (j + 1) * SIZE) })).reverse(),
  });
  done(spec, [...unnamed, ...LINES_KEY.filter(({ kind }) => kind !== "turning" || turns.length)]);
}

function nameOf({ mode, regime }) {
  if (mode < 0) return "no solution";
  return regime === FULL_FILM ? "full film" : `${MODE_TEXT[mode]}, ${REGIME_TEXT[regime]}`;
}

const fillOf = (cell) => AREAS.findLast(({ encloses }) => encloses(cell)).fill;

// The cell of a region, numbers of cells, that has the most room for a name; undefined if there is too little room.
function roomIn(region) {
  let [kept, room] = [new Set(region), 0];
  for (;;) {
    const isInside = ([i, j]) => AROUND.every(([a, b]) => i + a >= 0 && i + a < SIZE && kept.has(i + a + SIZE * (j + b)));
    const inner = [...kept].filter((k) => isInside(CELLS[k]));
    if (!inner.length) break;
    [kept, room] = [new Set(inner), room + 1];
  }
  return room < LEAST_ROOM ? undefined : CELLS[[...kept][kept.size >> 1]];
}

// Rings around the cells whose value is at least `level`; each corner is [i, j, whether it is on a border].
// There is no border at the edge of the map, and none beside NaN, where D3 puts the corner on a cell.
function ringsAround(values, level) {
  const { coordinates } = d3.contours().size([SIZE, SIZE]).contour(values.map(Number), level);
  return coordinates.flat().map((ring) =>
    ring.map(([a, b]) => {
      const place = [a - 0.5, b - 0.5];
      const isOnMap = place.every((each) => each >= 0 && each <= SIZE - 1);
      return [...place, isOnMap && !place.every(Number.isInteger)];
    }),
  );
}

// A corner of a ring lies between two cells. This moves it to where the states of the ring begin.
function refined([i, j, onBorder], isEnclosed) {
  if (!onBorder) return [i, j, false];
  const cells = [Math.floor, Math.ceil].map((round) => [round(i), round(j)]);
  const [inner, outer] = isEnclosed(cells[0]) ? cells : d3.reverse(cells);
  const between = (part) => [0, 1].map((k) => inner[k] + part * (outer[k] - inner[k]));
  return [...between(boundary((part) => isEnclosed(between(part)), 0, 1, STEPS)), true];
}

// What the lines of the map mean; its regions have names.
const LINES_KEY = [
  { text: "turning points of the contact area", color: "var(--turning)", kind: "turning" },
  { text: "your conditions", mark: "cross" },
];
