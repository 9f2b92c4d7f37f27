// The figures of the paper as specs of charts, with what the user chose in place of their conditions.

import { conditionAxes, content } from "./content.js";
import { chosenConditions, isCalibrated, state } from "./state.js";
import { currentEngine, defaultEngine } from "./engine.js";
import { turningPointBetween, turningWindow } from "./curves.js";
import { outlineOf } from "./ranges.js";
import { THIN, axisFor, keyOfMarks, levelStyle, specOf } from "./chart.js";
import { VARIABLES, conditionWord, letterOf, ofCondition, valueText, withUnit } from "./names.js";
import { readable } from "./text.js";

// dry contact beside lubricated contact, as in the figures of the workflow
const DRY = { dash: "5 2.5", dry: true };

const isTwoBody = (condition) => condition.particle_diameter * condition.particle_density === 0;
const ratioOf = (condition) => Number((condition.particle_diameter / condition.roughness).toPrecision(6));
const levelOf = (name, condition) => (name === "diameter_ratio" ? ratioOf(condition) : condition[name]);
const distinct = (values) => d3.sort(new Set(values));
const isSame = (a, b) =>
  conditionAxes.every(({ name }) => Math.abs(a[name] - b[name]) <= 1e-9 * Math.abs(b[name]));

// The values of a condition on the curves of a figure that have particles and, if it is one, oil.
function levelsOf(figure, name, isWanted = () => true) {
  const bodies = figure.curves.filter((condition, place) => !isTwoBody(condition) && isWanted(place));
  return distinct(bodies.map((condition) => levelOf(name, condition))).filter((level) => level > 0);
}

// The condition that distinguishes the curves of a figure, its levels, and those of them that are strong.
function parameterOf(figure) {
  const names = ["diameter_ratio", ...conditionAxes.map(({ name }) => name)];
  const [ratios, ...found] = names.map((name) => ({ name, levels: levelsOf(figure, name) }));
  const best = d3.greatest(found, ({ levels }) => levels.length);
  const chosen = best.name === "particle_diameter" && ratios.levels.length < best.levels.length ? ratios : best;
  const thin = new Set(figure.panels.flatMap(({ hairlines }) => hairlines));
  return { ...chosen, strong: levelsOf(figure, chosen.name, (place) => !thin.has(place)) };
}

// A figure's curves at the chosen conditions. A chosen condition replaces one that all curves have in common. For the
// one that distinguishes them it adds curves.
function figureCurves(figure, parameter) {
  let curves = figure.curves.map((condition, place) => ({ condition, places: [place], mine: false }));
  const conditions = chosenConditions();
  for (const [name, value] of Object.entries(conditions)) {
    if (name === "load" || name === parameter.name) continue;
    const [level, ...others] = levelsOf(figure, name);
    if (others.length) continue; // the figure compares several
    const isKept = (condition) =>
      (isTwoBody(condition) && name.startsWith("particle")) || (level && condition[name] !== level);
    const replaced = (condition) => (isKept(condition) ? condition : { ...condition, [name]: value });
    curves = curves.map((curve) => ({ ...curve, condition: replaced(curve.condition) }));
  }
  if (parameter.name in conditions) {
    const value = conditions[parameter.name];
    const bodies = curves.filter(({ condition }) => !isTwoBody(condition));
    const moved = bodies.map((curve) => ({ ...curve, condition: { ...curve.condition, [parameter.name]: value } }));
    for (const group of d3.group(moved, ({ condition }) => JSON.stringify(condition)).values()) {
      curves.push({ condition: group[0].condition, places: group.flatMap(({ places }) => places), mine: true });
    }
  }
  return curves;
}

// What curves with particles have in common, in words: "σ = 300 nm".
function sharedWords(curves) {
  const bodies = curves.map(({ condition }) => condition).filter((condition) => !isTwoBody(condition));
  const shared = conditionAxes.filter(({ name }) => distinct(bodies.map((condition) => condition[name])).length === 1);
  return shared.map(({ name }) => conditionWord(name, bodies[0][name]));
}

// Whether moving a condition changes the figure that is shown.
export function isFree(name) {
  const figure = content.figures.find((each) => each.name === state.figure);
  return parameterOf(figure).name === name || levelsOf(figure, name).length < 2;
}

// Which panels of the figure that is shown have the conditions of a point, where others have not: "panel A".
export function panelsOf(point) {
  const { curves, panels } = content.figures.find(({ name }) => name === state.figure);
  const compared = panels.filter(({ x }) => x !== "diameter_ratio");
  const own = compared.filter((panel) => panel.curves.some((place) => isSame(curves[place], point)));
  if (state.view !== "figures" || !own.length || own.length === compared.length) return "";
  return `panel${own.length > 1 ? "s" : ""} ${own.map(({ letter }) => letter).join(" and ")}`;
}

// Colour, dashes and marker of a curve, as in the figures of the workflow.
function styleOf({ name, levels, strong }, condition, mine, hasOil) {
  const dry = hasOil && condition.viscosity === 0;
  if (mine) return { color: "var(--mine)", ...(dry && DRY) };
  if (dry && isTwoBody(condition)) return { color: "var(--ink)", ...DRY, dash: "1.5 2.5" };
  if (isTwoBody(condition) && name !== "viscosity") return { color: "var(--ink)" };
  const { thin, ...look } = levelStyle(levelOf(name, condition), levels, strong);
  return dry ? { color: "var(--ink)", thin, ...DRY } : { ...look, thin };
}

function labelOf({ name }, condition) {
  const medium = valueText("viscosity", condition.viscosity);
  if (isTwoBody(condition)) return `${name === "viscosity" ? "two-body" : "none (two-body)"}, ${medium}`;
  if (name === "viscosity") return conditionWord(name, condition.viscosity);
  return `${levelsText(name, [levelOf(name, condition)])}, ${medium}`;
}

// Levels of the parameter: "x_a = 100, 200 nm".
function levelsText(name, levels) {
  if (name === "diameter_ratio") return `x_a/σ = ${levels.map((level) => readable(level, 3)).join(", ")}`;
  const shown = levels.map((level) => readable(level * (VARIABLES[name].factor ?? 1)));
  return `${letterOf(name)} = ${withUnit(ofCondition(name), shown.join(", "))}`;
}

// The short name at the end of a curve, as in the figures of the workflow.
function nameOf({ name }, condition) {
  if (isTwoBody(condition)) return name === "viscosity" ? "two-body" : "none";
  if (name === "viscosity" && condition.viscosity === 0) return "dry";
  return readable(levelOf(name, condition) * (VARIABLES[name].factor ?? 1), 3);
}

// Whether the chosen statement refers to a curve, by its conditions in the paper.
function emphasis(statement, { places, mine }, paper) {
  if (!statement) return {};
  const named = [...statement.curves, ...statement.references];
  const chosen = !mine && named.some((each) => places.some((place) => isSame(each, paper[place])));
  return { chosen, faded: !chosen };
}

// Specs of the panels of the figure that is shown, and the entries of their key.
export function figureView() {
  const figure = content.figures.find(({ name }) => name === state.figure);
  const engine = currentEngine();
  const parameter = parameterOf(figure);
  const curves = figureCurves(figure, parameter);
  const hasOil = figure.curves.some(({ viscosity }) => viscosity > 0);
  const comparesMedia = hasOil && curves.some(({ condition }) => condition.viscosity === 0);
  const asked = content.statements.find(({ id }) => id === state.statement);
  const statement = curves.some((curve) => emphasis(asked, curve, figure.curves).chosen) ? asked : undefined;
  const drawn = curves.map((curve) => ({
    ...curve,
    ...engine.curve(curve.condition),
    ...styleOf(parameter, curve.condition, curve.mine, hasOil),
    ...emphasis(statement, curve, figure.curves),
    label: labelOf(parameter, curve.condition),
    name: nameOf(parameter, curve.condition),
  }));
  const notes = sharedWords(drawn);
  // lubricated curves are seen between the dashes of dry ones
  const layered = d3.sort(drawn, ({ dry, mine, chosen }) => (dry ? 1 : 0) + (mine ? 2 : 0) + (chosen ? 4 : 0));
  const windows = figure.panels.filter(({ x }) => x === "diameter_ratio");
  const specs = figure.panels.map((panel) => {
    if (windows.includes(panel)) return windowSpec(figure, panel, engine, windows.indexOf(panel));
    const shown = layered.filter(({ places }) => places.some((place) => panel.curves.includes(place)));
    const own = sharedWords(shown).filter((word) => !notes.includes(word));
    return panelSpec(panel, shown, engine, { statement, own, figure });
  });
  const key = [...keyEntries(drawn, parameter, comparesMedia), ...keyOfMarks(specs)];
  return { specs, key, notes, heading: figure.title, caption: captionOf(figure) };
}

// The caption says what curves show at the paper's conditions with the calibrated inputs; at others it says so.
function captionOf({ caption }) {
  const isMoved = Object.keys(chosenConditions()).some((name) => name !== "load");
  return isCalibrated() && !isMoved ? caption : `At the conditions of the paper, with the calibrated inputs: ${caption}`;
}

function panelSpec(panel, curves, engine, { statement, own, figure: { curves: paper } }) {
  const { x, y, letter, locus, least } = panel;
  const ofPaper = curves.filter(({ mine }) => !mine);
  const isMoved = ({ condition, places: [place] }) => !isSame(condition, paper[place]);
  const changed = !isCalibrated() || ofPaper.some(isMoved);
  const before = changed ? panel.curves.map((place) => paper[place]) : [];
  const [printed, levels, limits] = [panel.printed, panel.levels, panel.limits].map((marks) => marksOf(marks, statement, curves, paper));
  const isRanged = ({ mine, places }) => mine || places.some((place) => panel.ranged.includes(place));
  const ranged = x === "load" ? curves.filter(isRanged) : [];
  const ranges = ranged.map(({ condition, ...look }) => ({ ...look, points: outlineOf(condition, y) }));
  const stars = y === "particle_contact_area_ratio" || panel.turning_points ? starsOf(x, y, curves, engine) : [];
  const spec = {
    letter,
    title: titleOf(x, y, ...own),
    ...{ x, y, least, printed, stars },
    locus: locus ? stars : [],
    computed: changed ? [] : panel.computed.map(({ at: [atX, atY] }) => ({ x: atX, y: atY })),
    lines: curves.map((curve) => ({ ...curve, points: engine.points({ x, y, condition: curve.condition }) })),
    ghosts: before.map((condition) => defaultEngine().points({ x, y, condition })),
    ranges: ranges.filter(({ points }) => points),
    ranged: ranged.map(({ condition }) => condition),
    levels,
    ...alongX(limits),
    slight: stars.length && x === "load" && y === "particle_contact_area_ratio" ? slightOf(x, y, curves, engine, least) : [],
    here: x === "load" ? hereOn(engine) : [],
  };
  // a logarithmic axis leaves out ends far below the curves, in a full film
  const lowest = VARIABLES[y].log ? d3.min(spec.lines.flatMap(({ points }) => points.map((point) => point.y))) : -Infinity;
  const outlines = outlinesIn(`${state.figure} ${letter}`, ranges).filter((point) => point[1] >= lowest);
  const ends = [...printed, ...levels].flatMap((mark) => mark.ends);
  return curvesSpec(spec, engine, [...ends, ...outlines]);
}

// The chosen load F_t*, if it is one of those of the curves.
function hereOn({ loads: [first, last], newtonsPerLoad }) {
  const load = state.conditions.load / newtonsPerLoad;
  return load >= first && load <= last ? [load] : [];
}

// The points of the ranges of a panel that its axis shows. Until these are computed, the points of before stay, so
// that the axis does not move.
const lastOutlines = new Map();
function outlinesIn(panel, ranges) {
  const isKnown = ranges.every(({ points }) => points);
  if (isKnown) lastOutlines.set(panel, ranges.flatMap(({ points }) => points));
  return lastOutlines.get(panel) ?? [];
}

// Numbers printed along x alone, with the names of their curves; both ends of a range have one in a bracket.
function alongX(lines) {
  const ranges = [...d3.group(lines, ({ id }) => id).values()].filter(({ length }) => length === 2);
  return {
    limits: lines.map((line) => (ranges.flat().includes(line) ? { ...line, name: "" } : line)),
    brackets: ranges.flatMap(([one, other]) => bracketOver([one.at[0], other.at[0]], `printed for ${one.name}`, one.color)),
  };
}

const bracketOver = (ends, text, color = "var(--ink)") => (ends.length === 2 ? [{ ends: d3.sort(ends), text, color }] : []);

// The title of a panel of y over x, with what it has alone, and whether the paper has it.
function titleOf(x, y, ...own) {
  const { words, symbol } = VARIABLES[x];
  const over = words.includes("load") || x === "diameter_ratio" ? "" : ` over ${symbol}`;
  return [[VARIABLES[y].words + over, ...own].join(", "), content.remarks[y]].filter(Boolean).join(" ");
}

// The spec of a chart of curves, whose axes also show some places [x, y].
function curvesSpec({ x, y, least, lines, ghosts = [], ...given }, engine, marked = []) {
  const points = [...lines.flatMap((line) => line.points), ...ghosts.flat()];
  return specOf({
    x: axisFor(x, state.x_scale, [...points.map((point) => point.x), ...marked.map((at) => at[0])]),
    y: axisFor(y, state.y_scale, [...points.map((point) => point.y), ...marked.map((at) => at[1])], least),
    newtonsPerLoad: x === "load" ? engine.newtonsPerLoad : null,
    ...{ lines, ghosts, ...given },
  });
}

// Numbers that the paper prints, in the colours of their curves; those of several curves are black.
function marksOf(marks, statement, curves, paper) {
  return marks.map((mark) => {
    const chosen = statement?.id === mark.id;
    const isOwn = ({ mine, places }) => !mine && places.some((place) => isSame(mark.curve, paper[place]));
    const curve = mark.curve && curves.find(isOwn);
    return {
      ...mark,
      chosen,
      faded: Boolean(statement) && !chosen,
      name: curve?.name ?? "",
      color: chosen ? "var(--mine)" : (curve?.color ?? "var(--ink)"),
      text: content.statements.find(({ id }) => id === mark.id).statement,
    };
  });
}

// The turning points of curves, and their maxima that do not count; without `least`, those near zero are left out.
const starsOf = (x, y, curves, engine) => pointsAt(({ turningPoint }) => turningPoint, x, y, curves, engine);
function slightOf(x, y, curves, engine, least) {
  const { least_rise: rise, from_zero: share } = content.slight;
  const highest = d3.max(curves, ({ states }) => d3.max(states, (state) => state[y]));
  const isSlight = ({ turningPoint, peak }) => !turningPoint && peak.prominence >= rise && (least > 0 || peak[y] > share * highest);
  return pointsAt((curve) => isSlight(curve) && curve.peak, x, y, curves, engine);
}
const pointsAt = (find, x, y, curves, engine) =>
  curves.filter(find).map((curve) => ({ ...engine.pointOf(x, y, find(curve), curve.condition), faded: curve.faded }));

// Where turning points occur over x_a/sigma, on one of the surfaces that the figure compares.
function windowSpec(figure, panel, engine, surface) {
  const sigmas = distinct(figure.curves.map(({ roughness }) => roughness));
  const { viscosity = 0, particle_density = 1e11, roughness: chosen } = chosenConditions();
  const roughness = chosen !== undefined && sigmas.length === 1 ? chosen : sigmas[surface];
  const label = `σ = ${valueText("roughness", roughness)}`;
  const sizes = distinct(figure.curves.map(ratioOf));
  const points = sizes.map((ratio) => {
    const condition = { viscosity, roughness, particle_density, particle_diameter: ratio * roughness };
    const found = turningPointBetween(engine.model.contact(condition), ...engine.loads);
    return { x: ratio, y: found?.particle_contact_area_ratio ?? NaN, state: found };
  });
  const ends = viscosity === 0 ? turningWindow(engine.model, roughness, particle_density, ...engine.loads) : [];
  const windows = ends.filter(Number.isFinite);
  const isOwn = ({ id }) => id.startsWith(figure.name);
  const stars = points.filter(({ y }) => Number.isFinite(y));
  // panels of several surfaces have the same axis
  const printed = figure.panels.filter(({ x }) => x === panel.x).flatMap(({ limits }) => limits.flatMap(({ ends }) => ends.map(([end]) => end)));
  const [limits, ofAll] = [panel.limits.filter(isOwn), panel.limits.filter((mark) => !isOwn(mark))];
  return specOf({
    letter: panel.letter,
    title: titleOf(panel.x, panel.y, label),
    x: axisFor(panel.x, "linear", [...stars.map(({ x }) => x), ...windows, ...printed]),
    y: { name: panel.y, log: false, domain: [-0.08, 1.08] },
    lines: [{ label, color: "none", points }],
    ...{ windows, limits, ofAll },
    brackets: [
      ...bracketOver(windows, "computed", "var(--accent)"),
      ...bracketOver(limits.map(({ at: [x] }) => x), "printed"),
      ...bracketOver(ofAll.map(({ at: [x] }) => x), "printed for all"),
    ],
    stars,
  });
}

// Each level of the parameter has an entry. Where dashes distinguish dry and lubricated contact, each of these has
// one too.
function keyEntries(drawn, { name, levels, strong }, comparesMedia) {
  const byDashes = comparesMedia && name !== "viscosity";
  const shown = drawn.filter(({ condition }) => !byDashes || condition.viscosity > 0 || isTwoBody(condition));
  const named = shown.map((curve) => {
    if (curve.thin) return { ...THIN, text: levelsText(name, levels.filter((level) => !strong.includes(level))) };
    const text = isTwoBody(curve.condition) ? curve.label : curve.label.split(", ")[0];
    return { ...curve, text: curve.mine ? `${text} (yours)` : text };
  });
  const entries = [...d3.group(named, ({ text }) => text).values()].map(([first]) => first);
  if (!byDashes) return entries;
  const oil = drawn.find(({ condition }) => condition.viscosity > 0).condition.viscosity;
  return [
    ...entries,
    { text: valueText("viscosity", oil), color: "var(--soft)" },
    { text: "dry", color: "var(--ink)", ...DRY },
  ];
}
