// Any variable against any condition or variable, for several values of another condition.

import { axes, currentPoint, state } from "./state.js";
import { currentEngine, placesAlong } from "./engine.js";
import { described, domainOf, isLog } from "./chart.js";
import { ink, mineColour, pointsOf, shade, yName } from "./figures.js";
import { changesAlong } from "./curves.js";
import { MODE_TEXT, VARIABLES, conditionText, conditionWord, valueText } from "./names.js";

const COUNT = 120; // points on a curve
const LEVELS = {
  load: [0.1, 1, 10, 30, 80],
  viscosity: [0, 25e-6, 50e-6, 70e-6, 90e-6, 120e-6, 150e-6],
  particle_diameter: [0, 100e-9, 200e-9, 300e-9, 500e-9, 700e-9, 1000e-9],
  roughness: [100e-9, 200e-9, 300e-9, 400e-9, 500e-9],
  particle_density: [0, 1e10, 1e11, 5e11, 1e12, 5e12],
};
const isAxis = (name) => axes.some((axis) => axis.name === name);
const close = (a, b) => Math.abs(a - b) <= 1e-9 * Math.abs(b);

// The spec of the chart, and the conditions that its curves have in common.
export function axesView() {
  const engine = currentEngine();
  const point = currentPoint();
  const [x, y, by] = [state.x, yName(state.y), state.by];
  const along = isAxis(x) ? x : "load";
  const own = by === along ? [point[by]] : [...LEVELS[by].filter((level) => !close(level, point[by])), point[by]];
  const levels = own.sort((a, b) => a - b);
  const lines = levels.map((level, rank) => {
    const mine = close(level, point[by]);
    const condition = { ...point, [by]: level };
    const curve = curveAlong(along, condition, engine);
    const color = mine ? mineColour() : level === 0 ? ink() : shade(rank / Math.max(levels.length - 1, 1));
    return {
      label: by === along ? conditionText(point, [along]) : conditionWord(by, level),
      points: curve.points(x, y),
      turningPoint: curve.turningPoint,
      color,
      mine,
      width: mine ? 2.6 : 1.6,
      ...(mine || level === 0 ? { dash: level === 0 && !mine ? "5 3" : undefined } : { marker: rank }),
    };
  });
  const [xLog, yLog] = [isLog(x, state.x_scale), isLog(y, state.y_scale)];
  const all = (pick) => lines.flatMap((line) => line.points.map(pick));
  const spec = {
    letter: "",
    title: `${VARIABLES[y].words} over ${VARIABLES[x].words.toLowerCase()}`,
    x: { name: x, log: xLog, domain: domainOf(x, all((each) => each.x), xLog) },
    y: { name: y, log: yLog, domain: domainOf(y, all((each) => each.y), yLog) },
    top: x === "load" ? engine.newtonsPerLoad : null,
    lines,
    ghosts: [],
    bands: [],
    printed: [],
    stars:
      along === "load" && VARIABLES[y].symbol === "A_sa,t*" && x in (lines[0].points[0]?.state ?? {})
        ? lines.filter(({ turningPoint }) => turningPoint).map(({ turningPoint, color }) => ({ x: turningPoint[x], y: turningPoint[y], color }))
        : [],
    locus: false,
    diamonds: [],
    here: isAxis(x) ? (x === "load" ? point.load / engine.newtonsPerLoad : point[x]) : undefined,
  };
  spec.description = described(spec);
  const shared = axes.map(({ name }) => name).filter((name) => name !== along && name !== by);
  const notes = shared.map((name) => conditionWord(name, point[name]));
  return { specs: [spec], notes, key: lines, parameter: { name: by } };
}

// States along an axis at conditions of a point; over the load they are a curve.
function curveAlong(name, point, engine) {
  const condition = { ...point };
  delete condition.load;
  if (name === "load") {
    const curve = engine.curve(condition);
    return { turningPoint: curve.turningPoint, points: (x, y) => pointsOf(x, y, curve, engine) };
  }
  const places = placesAlong(name, shownRange(name, point), COUNT);
  const states = places.map((place) => engine.state({ ...point, [name]: place }));
  const reference = { viscosity: 0, particle_diameter: 0, particle_density: 0 };
  const value = (which, i) => {
    if (which === name) return places[i];
    if (which === "total_contact_area_over_two_body") {
      const at = { ...point, [name]: places[i], ...reference };
      return states[i].total_contact_area / engine.state(at).total_contact_area;
    }
    return which in point && which !== "load" ? point[which] : states[i][which];
  };
  return {
    turningPoint: null,
    points: (x, y) => states.map((each, i) => ({ x: value(x, i), y: value(y, i), state: each })),
  };
}

// The paper's range of a condition, and that of the point if it lies outside.
export function shownRange(name, point) {
  const { range } = axes.find((axis) => axis.name === name);
  const ends = range.map((end) => (name === "load" ? end : end * axes.find((axis) => axis.name === name).scale));
  if (name === "viscosity") ends[0] = 1e-6; // thinner films are outside of what Eq. 7 means
  if (name === "particle_diameter") ends[0] = 10e-9;
  return [Math.min(ends[0], point[name] || ends[0]), Math.max(ends[1], point[name])];
}

// Where the interface at a point changes its mode along each axis, as text.
export function changesOf(name, point, engine) {
  const stateAt = (place) => engine.state({ ...point, [name]: place });
  const changes = changesAlong(stateAt, placesAlong(name, shownRange(name, point), name === "roughness" ? 24 : 60), "mode");
  if (!changes.length) {
    const { mode } = stateAt(point[name]);
    return mode < 0 ? "no solution" : `${MODE_TEXT[mode]} throughout`;
  }
  const parts = changes.map(({ at, to }) => `${MODE_TEXT[to]} from ${valueText(name, at)}`);
  return [`${MODE_TEXT[changes[0].from]}`, ...parts].join(", ");
}
