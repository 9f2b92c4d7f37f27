// Any variable against any condition or variable, for several values of another condition.

import { axes } from "./content.js";
import { currentPoint, state } from "./state.js";
import { currentEngine, placesAlong } from "./engine.js";
import { keyOfMarks, levelStyle } from "./chart.js";
import { curvesSpec, starsOf } from "./figures.js";
import { VARIABLES, conditionWord, conditionWords } from "./names.js";

const COUNT = 150; // points on a curve along a condition
const LEVELS = {
  load: [0.1, 1, 10, 30, 80],
  viscosity: [0, 25e-6, 50e-6, 70e-6, 90e-6, 120e-6, 150e-6],
  particle_diameter: [0, 100e-9, 200e-9, 300e-9, 500e-9, 700e-9, 1000e-9],
  roughness: [100e-9, 200e-9, 300e-9, 400e-9, 500e-9],
  particle_density: [0, 1e10, 1e11, 5e11, 1e12, 5e12],
};

// The spec of the chart, and the conditions that its curves have in common.
export function axesView() {
  const engine = currentEngine();
  const point = currentPoint();
  const { x, y, by } = state;
  const along = axes.some(({ name }) => name === x) ? x : "load";
  const others = LEVELS[by].filter((level) => Math.abs(level - point[by]) > 1e-9 * point[by]);
  const levels = by === along ? [point[by]] : d3.sort([...others, point[by]]);
  const lines = levels.map((level) => ({
    label: by === along ? conditionWords(point, "load", along).join(", ") : conditionWord(by, level),
    ...curveAlong(along, x, y, { ...point, [by]: level }, engine),
    ...(level === point[by] ? { color: "var(--mine)", mine: true } : levelStyle(level, levels)),
  }));
  const turns = along === "load" && y === "particle_contact_area_ratio";
  const heading = `${VARIABLES[y].words} over ${VARIABLES[x].words.toLowerCase()}`;
  const stars = turns ? starsOf(x, y, lines, engine) : [];
  const here = [x === "load" ? point.load / engine.newtonsPerLoad : point[x]].filter(Number.isFinite);
  const spec = curvesSpec({ title: heading, x, y, lines, stars, here }, engine);
  const key = lines.map((line) => ({ ...line, text: line.mine ? `${line.label} (yours)` : line.label }));
  return { specs: [spec], key: [...key, ...keyOfMarks([spec])], notes: conditionWords(point, along, by), heading };
}

// The points of a curve over the load, or along a condition.
function curveAlong(along, x, y, point, engine) {
  const { load, ...condition } = point;
  if (along === "load") {
    const { turningPoint } = engine.curve(condition);
    return { condition, turningPoint, points: engine.points({ x, y, condition }) };
  }
  return { condition, points: engine.pointsAlong(x, y, point, placesAlong(x, point, COUNT)) };
}
