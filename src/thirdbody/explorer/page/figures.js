// The figures of the paper as specs of charts, with what was chosen in place of their conditions.

import { conditionAxes, content, state } from "./state.js";
import { currentEngine, defaultEngine } from "./engine.js";
import { turningPointBetween, turningWindow } from "./curves.js";
import { described, domainOf, isLog } from "./chart.js";
import { conditionsOf } from "./judge.js";
import { VARIABLES, conditionWord, valueText, wordOf } from "./names.js";
import { readable } from "./text.js";

const WINDOW_HEIGHT = 0.5; // of the ends of a window, which have no height of their own
const GHOST_STEP = 3;
const OVER_TWO_BODY = "total_contact_area_over_two_body";

export const isDark = () => document.documentElement.dataset.theme === "dark";
export const ink = () => (isDark() ? "#e4e8ed" : "#1b222c");
// colours of an ordered parameter: their lightness tells the order in grey too
export const shade = (share) =>
  d3.interpolateViridis(isDark() ? 0.28 + 0.72 * share : 0.86 * share);
export const mineColour = () => (isDark() ? "#ff9d5c" : "#c4460a");

const isTwoBody = (condition) => condition.particle_diameter * condition.particle_density === 0;
const ratioOf = (condition) => Number((condition.particle_diameter / condition.roughness).toPrecision(6));
const distinct = (values) => [...new Set(values)].sort((a, b) => a - b);

// What tells the curves of a figure apart, and its levels.
export function parameterOf(figure) {
  const bodies = figure.curves.filter((condition) => !isTwoBody(condition));
  const levels = (pick) => distinct(bodies.map(pick)).filter((level) => level > 0);
  const found = conditionAxes.map(({ name }) => ({ name, levels: levels((each) => each[name]) }));
  found.sort((a, b) => b.levels.length - a.levels.length);
  const ratios = levels(ratioOf);
  const [best] = found;
  if (best.name === "particle_diameter" && ratios.length < best.levels.length) {
    return { name: "diameter_ratio", levels: ratios };
  }
  return best;
}

export const levelOf = (parameter, condition) =>
  parameter.name === "diameter_ratio" ? ratioOf(condition) : condition[parameter.name];

// A figure's curves with the chosen conditions, and what is to be said of that.
export function figureCurves(figure) {
  const parameter = parameterOf(figure);
  const notes = [];
  let changed = Object.keys(state.inputs).length > 0;
  let curves = figure.curves.map((condition, place) => ({ condition, place, mine: false }));
  const added = [];
  for (const { name } of conditionAxes) {
    const value = state.conditions[name];
    if (value === undefined) continue;
    const bodies = figure.curves.filter((each) => !isTwoBody(each));
    const levels = distinct(bodies.map((each) => each[name])).filter((level) => level > 0);
    const text = conditionWord(name, value);
    if (name === parameter.name) {
      added.push([name, value]);
      notes.push(`added: curves at ${text}`);
    } else if (levels.length <= 1) {
      const replaced = (condition) =>
        isTwoBody(condition) && name.startsWith("particle")
          ? condition
          : levels.length === 0 || condition[name] === levels[0]
            ? { ...condition, [name]: value }
            : condition;
      curves = curves.map((curve) => ({ ...curve, condition: replaced(curve.condition) }));
      notes.push(`drawn at ${text}`);
      changed = true;
    } else {
      notes.push(`${wordOf(name).toLowerCase()} stays: the figure compares several`);
    }
  }
  for (const [name, value] of added) {
    const others = new Map();
    for (const curve of curves.filter(({ condition }) => !isTwoBody(condition))) {
      const condition = { ...curve.condition, [name]: value };
      const key = JSON.stringify(condition);
      const same = others.get(key) ?? { condition, places: [], mine: true };
      same.places.push(curve.place);
      others.set(key, same);
    }
    curves.push(...others.values());
  }
  return { parameter, curves, notes, changed };
}

// Colour, dashes and marker of a curve, as in the figures of the paper's recomputation.
export function styleOf(parameter, condition, mine, comparesMedia) {
  if (mine) return { color: mineColour(), width: 2.6 };
  const dry = condition.viscosity === 0;
  const level = levelOf(parameter, condition);
  const dash = comparesMedia && dry ? (isTwoBody(condition) ? "1.5 2.5" : "5 3") : null;
  if (isTwoBody(condition)) return { color: isDark() ? "#98a2ad" : "#6d7681", dash: dry ? "1.5 2.5" : null };
  if (level === 0) return { color: ink(), dash: dash ?? "5 3" };
  const rank = parameter.levels.indexOf(level);
  const color = shade(parameter.levels.length > 1 ? rank / (parameter.levels.length - 1) : 0.3);
  return dash ? { color, dash } : { color, marker: rank };
}

// A variable along a curve, the same for points and lines.
export function valuesOf(name, curve, engine) {
  if (name === OVER_TWO_BODY) {
    const reference = engine.twoBodyArea(curve.condition);
    return curve.states.map((each, i) => each.total_contact_area / reference[i]);
  }
  if (name in curve.condition) return curve.states.map(() => curve.condition[name]);
  return curve.states.map((each) => each[name]);
}

export function pointsOf(xName, yName, curve, engine) {
  const [x, y] = [valuesOf(xName, curve, engine), valuesOf(yName, curve, engine)];
  return curve.states.map((each, i) => ({ x: x[i], y: y[i], state: each }));
}

export const chosenClaim = () => content.claims.find(({ id }) => id === state.claim);

const same = (a, b) => conditionAxes.every(({ name }) => Math.abs(a[name] - b[name]) <= 1e-9 * Math.abs(b[name]));

// How a curve stands to the statement that is chosen: spoken of or not.
export function standing(claim, condition) {
  if (!claim) return {};
  const spoken = conditionsOf(claim, conditionAxes, state.conditions);
  const reference = claim.reference ?? {};
  const held = spoken.map((each) => ({
    ...each,
    ...Object.fromEntries(
      conditionAxes.filter(({ key }) => key in reference).map(({ name, key, scale }) => [name, reference[key] * scale]),
    ),
  }));
  const chosen = [...spoken, ...held].some((each) => same(each, condition));
  return { chosen, faded: !chosen };
}

export const yName = (name) =>
  name === "total_contact_area" && state.area === "over_two_body" ? OVER_TWO_BODY : name;

// Specs of the panels of the figure that is shown, and the entries of their key.
export function figureView() {
  const figure = content.figures.find(({ name }) => name === state.figure);
  const engine = currentEngine();
  const { parameter, curves, notes, changed } = figureCurves(figure);
  const wet = figure.curves.some(({ viscosity }) => viscosity > 0);
  const comparesMedia = wet && curves.some(({ condition }) => condition.viscosity === 0);
  const claim = chosenClaim();
  const spoken = claim && curves.some(({ condition }) => standing(claim, condition).chosen) ? claim : undefined;
  const drawn = curves.map((curve) => ({
    ...curve,
    ...engine.curve(curve.condition),
    ...styleOf(parameter, curve.condition, curve.mine, comparesMedia),
    ...standing(spoken, curve.condition),
    label: labelOf(parameter, curve.condition),
  }));
  // dry curves lie on lubricated ones, which show in the gaps of their dashes; chosen ones on all
  const layered = [...drawn].sort((a, b) => rank(a) - rank(b));
  let surface = 0;
  const specs = figure.panels.map((panel) => {
    const mine = layered.filter(({ place, places }) =>
      places ? places.some((each) => panel.curves.includes(each)) : panel.curves.includes(place),
    );
    if (panel.x === "diameter_ratio") return windowSpec(figure, panel, engine, surface++, spoken);
    return curveSpec(panel, mine, engine, { claim: spoken, changed, curves: figure.curves });
  });
  if (changed) notes.push("thin grey: as the paper's conditions and the calibrated inputs have it");
  return { specs, notes, figure, key: keyEntries(drawn, parameter, comparesMedia), parameter };
}

const rank = ({ dash, mine, chosen }) => (dash ? 1 : 0) + (mine ? 2 : 0) + (chosen ? 4 : 0);

export function labelOf(parameter, condition) {
  const name = parameter.name === "diameter_ratio" ? "" : parameter.name;
  const plain = name ? conditionWord(name, condition[name]) : `xₐ/σ = ${readable(ratioOf(condition), 3)}`;
  if (isTwoBody(condition)) return `two-body, ${condition.viscosity ? valueText("viscosity", condition.viscosity) : "dry"}`;
  return name === "viscosity" ? plain : `${plain}, ${valueText("viscosity", condition.viscosity)}`;
}

function curveSpec(panel, curves, engine, { claim, changed, curves: paper }) {
  const [x, y] = [panel.x, yName(panel.y)];
  const [xLog, yLog] = [isLog(x, state.x_scale), isLog(y, state.y_scale)];
  const lines = curves.map((curve) => ({ ...curve, points: pointsOf(x, y, curve, engine) }));
  const ghosts = changed
    ? panel.curves.map((place) => some(pointsOf(x, y, defaultEngine.curve(paper[place]), defaultEngine)))
    : [];
  const asDrawn = y === panel.y;
  const printed = asDrawn ? panel.printed.map((mark) => ({ ...mark, ...printedStyle(mark, claim, curves) })) : [];
  const bands = asDrawn && !changed ? bandsOf(panel, curves, claim) : [];
  const stars = panel.turning_points && asDrawn || panel.y === "particle_contact_area_ratio"
    ? starsOf(curves, x, y, engine)
    : [];
  const shownLoads = [state.conditions.load].filter(Boolean).map((load) => load / engine.newtonsPerLoad);
  const all = (pick) => [
    ...lines.flatMap((line) => line.points.map(pick)),
    ...ghosts.flatMap((points) => points.map(pick)),
  ];
  const marked = printed.flatMap(({ at, ends }) => [at, ...ends]);
  const spec = {
    letter: panel.letter,
    title: VARIABLES[y].words + titleEnd(panel, curves),
    x: { name: x, log: xLog, domain: domainOf(x, [...all((point) => point.x), ...marked.map((at) => at[0])], xLog) },
    y: { name: y, log: yLog, domain: domainOf(y, [...all((point) => point.y), ...(VARIABLES[y].share ? [] : marked.map((at) => at[1]))], yLog) },
    top: x === "load" ? engine.newtonsPerLoad : null,
    lines,
    ghosts,
    bands,
    printed,
    stars,
    locus: panel.locus,
    diamonds: [],
    here: x === "load" ? shownLoads[0] : undefined,
  };
  spec.description = described(spec);
  return spec;
}

// enough of a curve for a thin line
const some = (points) => points.filter((_, i) => i % GHOST_STEP === 0 || i === points.length - 1);

// conditions that the curves of a panel share and those of the figure do not
function titleEnd(panel, curves) {
  const sigmas = distinct(curves.filter(({ mine }) => !mine).map(({ condition }) => condition.roughness));
  return sigmas.length === 1 ? `, σ = ${valueText("roughness", sigmas[0])}` : "";
}

function printedStyle(mark, claim, curves) {
  const of = content.claims.find(({ id }) => id === mark.id);
  const chosen = claim?.id === mark.id;
  const verdict = verdicts.get(mark.id)?.verdict;
  const spoken = conditionsOf(of, conditionAxes)[0];
  const curve = curves.find(({ condition }) => same(spoken, condition));
  return {
    chosen,
    faded: Boolean(claim) && !chosen,
    color: chosen ? mineColour() : (curve?.color ?? ink()),
    text: `${of.statement} ${verdict ? `(${verdict})` : ""}`,
  };
}

// verdicts as they were last judged, by the ids of statements
export const verdicts = new Map(content.claims.map(({ id, verdict, measured }) => [id, { verdict, measured }]));

function bandsOf(panel, curves, claim) {
  return curves
    .filter(({ place }) => panel.bands[place])
    .map(({ place, color, faded }) => ({ points: panel.bands[place], color, faded: Boolean(claim) && faded }));
}

function starsOf(curves, x, y, engine) {
  return curves
    .filter(({ turningPoint }) => turningPoint)
    .map(({ turningPoint, color, condition, faded }) => {
      const reference = y === OVER_TWO_BODY && engine.state({ ...condition, viscosity: 0, particle_diameter: 0, particle_density: 0, load: turningPoint.normal_load });
      const at = y === OVER_TWO_BODY ? turningPoint.total_contact_area / reference.total_contact_area : turningPoint[y];
      return { x: turningPoint[x], y: at, color, faded };
    });
}

function windowSpec(figure, panel, engine, surface, claim) {
  const sigmas = distinct(figure.curves.map(({ roughness }) => roughness));
  const roughness = state.conditions.roughness !== undefined && sigmas.length === 1 ? state.conditions.roughness : sigmas[surface];
  const { viscosity = 0, particle_density: density = 1e11 } = state.conditions;
  const ratios = d3.range(0.3, 2.0001, 0.05);
  const lines = [
    {
      label: `σ = ${valueText("roughness", roughness)}`,
      color: ink(),
      points: ratios.map((ratio) => {
        const condition = { viscosity, roughness, particle_density: density, particle_diameter: ratio * roughness };
        const found = turningPointBetween(engine.model.contact(condition), ...engine.loads);
        return { x: ratio, y: found?.particle_contact_area_ratio ?? NaN, state: found };
      }),
    },
  ];
  const ends = viscosity === 0 ? turningWindow(engine.model, roughness, density, ...engine.loads) : [];
  const printed = panel.printed.map((mark) => ({ ...mark, ...printedStyle(mark, claim, []) }));
  const spec = {
    letter: panel.letter,
    title: `${VARIABLES[panel.y].words}, σ = ${valueText("roughness", roughness)}`,
    x: { name: panel.x, log: false, domain: [0.3, 2] },
    y: { name: panel.y, log: false, domain: [-0.04, 1.06] },
    top: null,
    lines,
    ghosts: [],
    bands: [],
    printed,
    stars: lines[0].points.filter(({ y }) => Number.isFinite(y)).map(({ x, y }) => ({ x, y, color: ink() })),
    locus: false,
    diamonds: ends.filter(Number.isFinite).map((x) => ({ x, y: WINDOW_HEIGHT, diamond: true, color: mineColour() })),
  };
  spec.description = described(spec);
  return spec;
}

// One entry for each level, whatever else its curves differ in; where dry and lubricated contact differ by their dashes, one for either.
function keyEntries(drawn, parameter, comparesMedia) {
  const entries = new Map();
  const byDashes = comparesMedia && parameter.name !== "viscosity";
  for (const curve of drawn) {
    const { condition, color, dash, marker, mine, label } = curve;
    const isDry = condition.viscosity === 0;
    if (byDashes && isDry && !isTwoBody(condition)) continue;
    const text = isTwoBody(condition) ? label : label.split(", ")[0];
    if (!entries.has(text)) entries.set(text, { label: text, color, dash, marker, mine });
  }
  if (byDashes) {
    const oil = drawn.find(({ condition }) => condition.viscosity > 0);
    const media = [[valueText("viscosity", oil.condition.viscosity), null], ["dry", "5 3"]];
    for (const [label, dash] of media) entries.set(label, { label, color: ink(), dash });
  }
  return [...entries.values()];
}
