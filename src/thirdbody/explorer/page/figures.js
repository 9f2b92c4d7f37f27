// The figures of the paper as specs of charts, with what the user chose in place of their conditions.

import { conditionAxes, content, state } from "./state.js";
import { currentEngine, defaultEngine, DRY_TWO_BODY } from "./engine.js";
import { turningPointBetween, turningWindow } from "./curves.js";
import { DIAMOND, axisFor, ink, isDark, mineColour, shade } from "./chart.js";
import { curvesOf, referencesOf } from "./judge.js";
import { measuredPoints } from "./measured.js";
import { VARIABLES, conditionWord, valueText, wordOf } from "./names.js";
import { readable } from "./text.js";

const WINDOW_HEIGHT = 0.5; // at which the ends of a window are drawn
const GHOST_STEP = 3; // of the points of a thin line, one is drawn
const OVER_TWO_BODY = "total_contact_area_over_two_body";
const DASHED = "5 3";
const DOTTED = "1.5 2.5";

// verdicts as they were last judged, by the ids of statements
export const verdicts = new Map(content.claims.map(({ id, verdict, measured }) => [id, { verdict, measured }]));

// a spec of a chart; what is not given is empty
export const specOf = (given) => ({
  ...{ letter: "", newtonsPerLoad: null, lines: [], ghosts: [], ranges: [], printed: [] },
  ...{ stars: [], measured: [], locus: false, areas: [], borders: [] },
  ...given,
});

const isTwoBody = (condition) => condition.particle_diameter * condition.particle_density === 0;
const ratioOf = (condition) => Number((condition.particle_diameter / condition.roughness).toPrecision(6));
const distinct = (values) => d3.sort(new Set(values));
const isSame = (a, b) =>
  conditionAxes.every(({ name }) => Math.abs(a[name] - b[name]) <= 1e-9 * Math.abs(b[name]));

// The condition that distinguishes the curves of a figure, and its levels.
function parameterOf(figure) {
  const bodies = figure.curves.filter((condition) => !isTwoBody(condition));
  const levels = (pick) => distinct(bodies.map(pick)).filter((level) => level > 0);
  const found = conditionAxes.map(({ name }) => ({ name, levels: levels((each) => each[name]) }));
  const best = d3.greatest(found, ({ levels: { length } }) => length);
  const ratios = levels(ratioOf);
  return best.name === "particle_diameter" && ratios.length < best.levels.length
    ? { name: "diameter_ratio", levels: ratios }
    : best;
}

// A figure's curves at the chosen conditions, with notes on what was chosen. A condition that all
// curves have in common is replaced; the one that distinguishes them gets additional curves.
function figureCurves(figure, parameter) {
  const bodies = figure.curves.filter((condition) => !isTwoBody(condition));
  const notes = [];
  let changed = Object.keys(state.inputs).length > 0;
  let curves = figure.curves.map((condition, place) => ({ condition, places: [place], mine: false }));
  for (const { name } of conditionAxes.filter((axis) => axis.name in state.conditions)) {
    const value = state.conditions[name];
    const [level, ...others] = distinct(bodies.map((each) => each[name])).filter((each) => each > 0);
    if (name === parameter.name) {
      notes.push(`added: curves at ${conditionWord(name, value)}`);
    } else if (others.length) {
      notes.push(`${wordOf(name).toLowerCase()} stays: the figure compares several`);
    } else {
      const isKept = (condition) =>
        (isTwoBody(condition) && name.startsWith("particle")) || (level && condition[name] !== level);
      const replaced = (condition) => (isKept(condition) ? condition : { ...condition, [name]: value });
      curves = curves.map((curve) => ({ ...curve, condition: replaced(curve.condition) }));
      notes.push(`drawn at ${conditionWord(name, value)}`);
      changed = true;
    }
  }
  if (parameter.name in state.conditions) {
    const moved = curves
      .filter(({ condition }) => !isTwoBody(condition))
      .map(({ condition, places }) => {
        const value = state.conditions[parameter.name];
        return { condition: { ...condition, [parameter.name]: value }, places };
      });
    const groups = d3.group(moved, ({ condition }) => JSON.stringify(condition));
    for (const group of groups.values()) {
      const places = group.flatMap((curve) => curve.places);
      curves.push({ condition: group[0].condition, places, mine: true });
    }
  }
  return { curves, notes, changed };
}

// Colour, dashes and marker of a curve, as in the figures of the workflow.
function styleOf(parameter, condition, mine, comparesMedia) {
  if (mine) return { color: mineColour() };
  const dry = condition.viscosity === 0;
  if (isTwoBody(condition)) return { color: isDark() ? "#98a2ad" : "#6d7681", dash: dry ? DOTTED : null };
  const level = parameter.name === "diameter_ratio" ? ratioOf(condition) : condition[parameter.name];
  if (level === 0) return { color: ink(), dash: DASHED };
  const rank = parameter.levels.indexOf(level);
  const { length } = parameter.levels;
  const color = shade(length > 1 ? rank / (length - 1) : 0.3);
  return comparesMedia && dry ? { color, dash: DASHED } : { color, marker: rank };
}

function labelOf({ name }, condition) {
  const medium = valueText("viscosity", condition.viscosity);
  if (isTwoBody(condition)) return `two-body, ${medium}`;
  if (name === "viscosity") return conditionWord(name, condition.viscosity);
  const level = name === "diameter_ratio" ? `xₐ/σ = ${readable(ratioOf(condition), 3)}` : conditionWord(name, condition[name]);
  return `${level}, ${medium}`;
}

// Points of a curve: two variables, and the state that they belong to.
export function pointsOf(xName, yName, curve, engine) {
  const [x, y] = [xName, yName].map((name) => {
    if (name === OVER_TWO_BODY) {
      const reference = engine.twoBodyArea(curve.condition);
      return curve.states.map((each, i) => each.total_contact_area / reference[i]);
    }
    return curve.states.map((each) => curve.condition[name] ?? each[name]);
  });
  return curve.states.map((each, i) => ({ x: x[i], y: y[i], state: each }));
}

// Whether the chosen statement refers to a curve.
function emphasis(claim, condition) {
  if (!claim) return {};
  const named = curvesOf(claim, state.conditions);
  const chosen = [...named, ...referencesOf(claim, named)].some((each) => isSame(each, condition));
  return { chosen, faded: !chosen };
}

export const yName = (name) =>
  name === "total_contact_area" && state.area === "over_two_body" ? OVER_TWO_BODY : name;

// Specs of the panels of the figure that is shown, and the entries of their key.
export function figureView() {
  const figure = content.figures.find(({ name }) => name === state.figure);
  const engine = currentEngine();
  const parameter = parameterOf(figure);
  const { curves, notes, changed } = figureCurves(figure, parameter);
  const hasOil = figure.curves.some(({ viscosity }) => viscosity > 0);
  const comparesMedia = hasOil && curves.some(({ condition }) => condition.viscosity === 0);
  const asked = content.claims.find(({ id }) => id === state.claim);
  const claim = curves.some(({ condition }) => emphasis(asked, condition).chosen) ? asked : undefined;
  const drawn = curves.map((curve) => ({
    ...curve,
    ...engine.curve(curve.condition),
    ...styleOf(parameter, curve.condition, curve.mine, comparesMedia),
    ...emphasis(claim, curve.condition),
    label: labelOf(parameter, curve.condition),
  }));
  // dry curves are drawn above lubricated ones, which show in the gaps of their dashes
  const layer = ({ dash, mine, chosen }) => (dash ? 1 : 0) + (mine ? 2 : 0) + (chosen ? 4 : 0);
  const layered = d3.sort(drawn, layer);
  const windows = figure.panels.filter(({ x }) => x === "diameter_ratio");
  const specs = figure.panels.map((panel) => {
    if (windows.includes(panel)) return windowSpec(figure, panel, engine, windows.indexOf(panel), claim);
    const mine = layered.filter(({ places }) => places.some((place) => panel.curves.includes(place)));
    return curveSpec(panel, mine, engine, { claim, changed, paper: figure.curves });
  });
  if (changed) notes.push("thin grey: the paper's conditions with the calibrated inputs");
  const key = keyEntries(drawn, parameter, comparesMedia);
  return { specs, key, notes, heading: figure.title, caption: figure.caption };
}

function curveSpec(panel, curves, engine, { claim, changed, paper }) {
  const [x, y] = [panel.x, yName(panel.y)];
  const lines = curves.map((curve) => ({ ...curve, points: pointsOf(x, y, curve, engine) }));
  const ghosts = changed
    ? panel.curves.map((place) => thinned(pointsOf(x, y, defaultEngine.curve(paper[place]), defaultEngine)))
    : [];
  const asDrawn = y === panel.y;
  const printed = asDrawn ? printedMarks(panel, claim, curves) : [];
  const turns = panel.y === "particle_contact_area_ratio" || (panel.turning_points && asDrawn);
  const measured = measuredPoints(x, y, curves, engine);
  const points = [...lines.flatMap((line) => line.points), ...ghosts.flat(), ...measured];
  const marked = printed.flatMap(({ at, ends }) => [at, ...ends]);
  const markedY = VARIABLES[y].fraction ? [] : marked.map((at) => at[1]);
  const { load } = state.conditions;
  return specOf({
    letter: panel.letter,
    title: VARIABLES[y].words + sharedRoughness(curves),
    x: axisFor(x, state.x_scale, [...points.map((point) => point.x), ...marked.map((at) => at[0])]),
    y: axisFor(y, state.y_scale, [...points.map((point) => point.y), ...markedY]),
    newtonsPerLoad: x === "load" ? engine.newtonsPerLoad : null,
    lines,
    ghosts,
    ranges: asDrawn && !changed ? rangesOf(panel, curves) : [],
    printed,
    stars: turns ? starsOf(curves, x, y, engine) : [],
    locus: panel.locus,
    measured,
    here: x === "load" && load ? load / engine.newtonsPerLoad : undefined,
  });
}

const thinned = (points) => points.filter((_, i) => i % GHOST_STEP === 0 || i === points.length - 1);

// the roughness of all curves of a panel, where they have one in common
function sharedRoughness(curves) {
  const [sigma, ...others] = distinct(curves.filter(({ mine }) => !mine).map(({ condition }) => condition.roughness));
  return others.length ? "" : `, σ = ${valueText("roughness", sigma)}`;
}

function printedMarks(panel, claim, curves) {
  return panel.printed.map((mark) => {
    const stated = content.claims.find(({ id }) => id === mark.id);
    const chosen = claim?.id === mark.id;
    const curve = curves.find(({ condition }) => isSame(stated.curves[0], condition));
    return {
      ...mark,
      chosen,
      faded: Boolean(claim) && !chosen,
      color: chosen ? mineColour() : (curve?.color ?? ink()),
      text: `${stated.statement} (${verdicts.get(mark.id).verdict})`,
    };
  });
}

const rangesOf = (panel, curves) =>
  curves
    .filter(({ mine, places: [place] }) => !mine && panel.ranges[place])
    .map(({ places: [place], color, faded }) => ({ points: panel.ranges[place], color, faded }));

function starsOf(curves, x, y, engine) {
  const turning = curves.filter(({ turningPoint }) => turningPoint);
  return turning.map(({ turningPoint, color, condition, faded }) => {
    const found = { x: turningPoint[x], y: turningPoint[y], color, faded };
    if (y !== OVER_TWO_BODY) return found;
    const reference = engine.state({ ...condition, ...DRY_TWO_BODY, load: turningPoint.normal_load });
    return { ...found, y: turningPoint.total_contact_area / reference.total_contact_area };
  });
}

// Where turning points occur over x_a/sigma, on one of the surfaces that the figure compares.
function windowSpec(figure, panel, engine, surface, claim) {
  const sigmas = distinct(figure.curves.map(({ roughness }) => roughness));
  const { viscosity = 0, particle_density = 1e11, roughness: chosen } = state.conditions;
  const roughness = chosen !== undefined && sigmas.length === 1 ? chosen : sigmas[surface];
  const label = `σ = ${valueText("roughness", roughness)}`;
  const points = d3.range(0.3, 2.0001, 0.05).map((ratio) => {
    const condition = { viscosity, roughness, particle_density, particle_diameter: ratio * roughness };
    const found = turningPointBetween(engine.model.contact(condition), ...engine.loads);
    return { x: ratio, y: found?.particle_contact_area_ratio ?? NaN, state: found };
  });
  const ends = viscosity === 0 ? turningWindow(engine.model, roughness, particle_density, ...engine.loads) : [];
  const diamonds = ends.map((x) => ({ x, y: WINDOW_HEIGHT, symbol: DIAMOND, color: mineColour() }));
  return specOf({
    letter: panel.letter,
    title: `${VARIABLES[panel.y].words}, ${label}`,
    x: { name: panel.x, log: false, domain: [0.3, 2] },
    y: { name: panel.y, log: false, domain: [-0.04, 1.06] },
    lines: [{ label, color: ink(), points }],
    printed: printedMarks(panel, claim, []),
    stars: [...points.map(({ x, y }) => ({ x, y, color: ink() })), ...diamonds],
  });
}

// One entry for each level of the parameter; where dashes distinguish dry and lubricated contact, one
// for each of these.
function keyEntries(drawn, parameter, comparesMedia) {
  const byDashes = comparesMedia && parameter.name !== "viscosity";
  const shown = drawn.filter(({ condition }) => !byDashes || condition.viscosity > 0 || isTwoBody(condition));
  const named = shown.map((curve) => {
    const text = isTwoBody(curve.condition) ? curve.label : curve.label.split(", ")[0];
    return { ...curve, text: curve.mine ? `${text} (yours)` : text };
  });
  const entries = [...d3.rollup(named, ([first]) => first, ({ text }) => text).values()];
  if (!byDashes) return entries;
  const oil = drawn.find(({ condition }) => condition.viscosity > 0).condition.viscosity;
  return [
    ...entries,
    { text: valueText("viscosity", oil), color: ink() },
    { text: "dry", color: ink(), dash: DASHED },
  ];
}
