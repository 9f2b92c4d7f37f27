// The map of modes and regimes over two conditions, with the line of the turning points.

import { currentPoint, state } from "./state.js";
import { currentEngine, inSlices, shownRange } from "./engine.js";
import { boundary, turningPointBetween } from "./curves.js";
import { specOf } from "./chart.js";
import { LIMITS, remembered } from "./model.js";
import { FULL_FILM, MODE_TEXT, REGIME_TEXT, VARIABLES, modeText, ofCondition, scaleFor, valueText, wordOf } from "./names.js";

const SIZE = 64; // places along each axis, counted from 0; between them, fractions are conditions too
const STEPS = 7; // of the search for a border between two places
const PLACES = d3.range(SIZE);
const CELLS = d3.cross(PLACES, PLACES, (j, i) => [i, j]);
const BESIDE = 2; // places beside a line or a mark, on which no name stands
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
  const turns = ringsAround(above, 0);
  const marked = [[xScale(point[x]), yScale(point[y])], ...turns.flat().filter(([, , onBorder]) => onBorder)];
  const isFree = (k) => !marked.some((place) => place.slice(0, 2).every((each, axis) => Math.abs(each - CELLS[k][axis]) < BESIDE));
  const names = [];
  for (const [text, region] of d3.group(d3.range(cells.length), (k) => nameOf(cells[k]))) {
    const fitting = placesIn(region.filter(isFree));
    const placeFor = (width, height) => {
      const place = fitting(width, height);
      return place && cornerAt(place);
    };
    const [first] = region;
    names.push({ text, placeFor, fill: fillOf(cells[first]), mode: modeNameOf(cells[first]) });
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
    borders: [...layers.slice(AREAS.length), { kind: "turning", rings: turns.map((ring) => ring.map(cornerAt)) }],
    crosses: [{ x: point[x], y: point[y] }],
    names,
    fills: [...new Map(names.map(({ fill, mode }) => [fill, { fill, text: mode }])).values()],
    rows: PLACES.map((j) => ({ label: "", points: points.slice(j * SIZE, (j + 1) * SIZE) })).reverse(),
  });
  const isDrawn = ({ kind }) => spec.borders.every((border) => border.kind !== kind || border.rings.flat().some(({ onBorder }) => onBorder));
  done(spec, LINES_KEY.filter(isDrawn));
}

const modeNameOf = (cell) => (cell.mode < 0 ? "no solution" : modeText(cell));
const nameOf = (cell) =>
  cell.mode < 0 || cell.regime === FULL_FILM ? modeNameOf(cell) : `${modeNameOf(cell)}, ${REGIME_TEXT[cell.regime]}`;

const fillOf = (cell) => AREAS.findLast(({ encloses }) => encloses(cell)).fill;

// A function of the width and height of a box, in those of the map: the cell of a region, numbers of cells, around which
// the box has the most room; undefined if it does not fit.
function placesIn(region) {
  const sums = CELLS.map(() => 0); // of cells of the region, up to each cell
  const sumTo = (i, j) => (i < 0 || j < 0 ? 0 : sums[i + SIZE * j]);
  const inside = new Set(region);
  CELLS.forEach(([i, j], k) => (sums[k] = inside.has(k) + sumTo(i - 1, j) + sumTo(i, j - 1) - sumTo(i - 1, j - 1)));
  const hasRoom = ([i, j], [a, b]) => {
    if (i < a || j < b || i + a >= SIZE || j + b >= SIZE) return false;
    const [low, high] = [j - b - 1, j + b].map((row) => sumTo(i + a, row) - sumTo(i - a - 1, row));
    return high - low === (2 * a + 1) * (2 * b + 1);
  };
  return (width, height) => {
    let found = [];
    for (let more = 0; ; more += 1) {
      const half = [width, height].map((size) => Math.ceil((size * (SIZE - 1)) / 2) + more);
      const fitting = region.filter((k) => hasRoom(CELLS[k], half));
      if (!fitting.length) return CELLS[found[found.length >> 1]];
      found = fitting;
    }
  };
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
  {
    text: `boundary or mixed lubrication: L_s = ${valueText("solid_load_fraction", LIMITS.boundary)}`,
    ...{ color: "var(--accent)", kind: "regime" },
  },
  { text: "turning points of the contact area", color: "var(--turning)", kind: "turning" },
  { text: "your conditions", mark: "cross" },
];
