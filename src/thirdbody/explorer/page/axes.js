// Any variable against any condition or variable, for several values of another condition.

import { axes, axisNamed, currentPoint, state } from "./state.js";
import { DRY_TWO_BODY, currentEngine, placesAlong } from "./engine.js";
import { axisFor, ink, mineColour, shade } from "./chart.js";
import { pointsOf, specOf, yName } from "./figures.js";
import { measuredPoints } from "./measured.js";
import { VARIABLES, conditionText, conditionWord } from "./names.js";

const COUNT = 120; // points on a curve
const LEVELS = {
  load: [0.1, 1, 10, 30, 80],
  viscosity: [0, 25e-6, 50e-6, 70e-6, 90e-6, 120e-6, 150e-6],
  particle_diameter: [0, 100e-9, 200e-9, 300e-9, 500e-9, 700e-9, 1000e-9],
  roughness: [100e-9, 200e-9, 300e-9, 400e-9, 500e-9],
  particle_density: [0, 1e10, 1e11, 5e11, 1e12, 5e12],
};
const isAxis = (name) => axes.some((axis) => axis.name === name);

// The spec of the chart, and the conditions that its curves have in common.
export function axesView() {
  const engine = currentEngine();
  const point = currentPoint();
  const [x, y, by] = [state.x, yName(state.y), state.by];
  const along = isAxis(x) ? x : "load";
  const mine = point[by];
  const others = LEVELS[by].filter((level) => Math.abs(level - mine) > 1e-9 * mine);
  const levels = by === along ? [mine] : d3.sort([...others, mine]);
  const lines = levels.map((level, rank) => {
    const { load, ...condition } = { ...point, [by]: level };
    const curve = along === "load" ? engine.curve(condition) : null;
    return {
      label: by === along ? conditionText(point, [along]) : conditionWord(by, level),
      condition,
      points: curve ? pointsOf(x, y, curve, engine) : pointsAlong(x, y, { load, ...condition }, engine),
      turningPoint: curve?.turningPoint,
      ...styleOf(level, rank, levels.length, level === mine),
    };
  });
  const measured = measuredPoints(x, y, lines, engine);
  const points = [...lines.flatMap((line) => line.points), ...measured];
  const turns = along === "load" && y === "particle_contact_area_ratio";
  const spec = specOf({
    title: `${VARIABLES[y].words} over ${VARIABLES[x].words.toLowerCase()}`,
    x: axisFor(x, state.x_scale, points.map((each) => each.x)),
    y: axisFor(y, state.y_scale, points.map((each) => each.y)),
    newtonsPerLoad: x === "load" ? engine.newtonsPerLoad : null,
    lines,
    measured,
    stars: lines
      .filter(({ turningPoint }) => turns && turningPoint)
      .map(({ turningPoint, color }) => ({ x: turningPoint[x], y: turningPoint[y], color })),
    here: x === "load" ? point.load / engine.newtonsPerLoad : point[x],
  });
  const shared = axes.filter(({ name }) => name !== along && name !== by);
  const notes = shared.map(({ name }) => conditionWord(name, point[name]));
  const key = lines.map((line) => ({ ...line, text: line.mine ? `${line.label} (yours)` : line.label }));
  return { specs: [spec], key, notes, heading: spec.title };
}

function styleOf(level, rank, count, mine) {
  if (mine) return { color: mineColour(), mine };
  if (level === 0) return { color: ink(), dash: "5 3" };
  return { color: shade(rank / Math.max(count - 1, 1)), marker: rank };
}

// Points along a condition other than the load.
function pointsAlong(x, y, point, engine) {
  return placesAlong(x, shownRange(x, point), COUNT).map((place) => {
    const at = { ...point, [x]: place };
    const found = engine.state(at);
    if (y !== "total_contact_area_over_two_body") return { x: place, y: found[y], state: found };
    const reference = engine.state({ ...at, ...DRY_TWO_BODY });
    return { x: place, y: found.total_contact_area / reference.total_contact_area, state: found };
  });
}

// The paper's range of a condition, and the chosen value if it is outside.
export function shownRange(name, point) {
  const { range, scale } = axisNamed(name);
  const [low, high] = range.map((end) => end * scale);
  const first = { viscosity: 1e-6, particle_diameter: 10e-9 }[name] ?? low; // Eq. 7 means no thinner film
  return [Math.min(first, point[name] || first), Math.max(high, point[name])];
}
