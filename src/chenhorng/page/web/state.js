// The state is what the page shows. The fragment of the address says where it differs from the default.

import { axes, content, defaultInputs } from "./content.js";
import { conditioned } from "./conditioning.js";
import { areHard, remembered } from "./model.js";
import { GRADES, MATERIALS, materialInputs, oilViscosity, rigInputs } from "./rig.js";
import { numberIn, significant } from "./text.js";

// conditions of the point that is shown where none are chosen; the load in newtons, else SI
const USUAL = { load: 10, viscosity: 90e-6, particle_diameter: 500e-9, roughness: 300e-9, particle_density: 1e11 };
const ABSENT = 100; // how far from the usual a curve without oil or particles is, in logarithms

// What can be chosen, and its default
const names = axes.map(({ name }) => name);
const figures = content.figures.map(({ name }) => name);
export const CHOICES = {
  view: ["map", "figures"],
  figure: figures,
  map_x: names,
  map_y: names,
  x_scale: ["auto", "log", "linear"],
  y_scale: ["auto", "log", "linear"],
  statement: ["", ...content.statements.map(({ id }) => id)],
  show: ["here", "all", "fails"],
  ball: MATERIALS,
  flat: MATERIALS,
  particle: MATERIALS,
  oil_grade: ["", ...GRADES],
};
// Numbers that can be chosen, with bounds and default; the speed is by default that of the inputs
export const NUMBERS = {
  speed_m_per_s: { bounds: content.rig.speed_m_per_s },
  oil_density_kg_per_m3: { bounds: content.rig.oil_density_kg_per_m3, usual: content.rig.usual_density },
  temperature_C: { bounds: content.rig.temperature_C, usual: 40 },
};
const DEFAULTS = {
  ...Object.fromEntries(Object.entries(CHOICES).map(([name, [first]]) => [name, first])),
  ...Object.fromEntries(Object.entries(NUMBERS).map(([name, { usual }]) => [name, usual])),
  map_y: "particle_diameter",
  figure: figures.find((name) => name === "fig11") ?? figures[0],
};
// and what is wrong with the link that was opened
const fresh = () => ({ ...DEFAULTS, conditions: {}, inputs: {}, damage: "" });
export const state = fresh();
const listeners = [];
export const onChange = (listener) => listeners.push(listener);

// Change what is shown: `what` has fields of the state.
export function change(what) {
  Object.assign(state, { damage: "" }, what);
  listeners.forEach((listener) => listener());
}
export const isDefault = (name) => state[name] === DEFAULTS[name];
export const toDefault = (...names) => change(Object.fromEntries(names.map((name) => [name, DEFAULTS[name]])));

// Values that are chosen and differ from the calibrated inputs.
function chosen(values) {
  const entries = Object.entries(values);
  return Object.fromEntries(entries.filter(([name, value]) => value !== undefined && value !== defaultInputs[name]));
}
export function setCondition(name, value) {
  const oil = name === "viscosity" ? { oil_grade: DEFAULTS.oil_grade } : {};
  change({ conditions: chosen({ ...state.conditions, [name]: value }), ...oil });
}
export const setInputs = (values) => change({ inputs: chosen({ ...state.inputs, ...values }) });

// All that the reader has changed is known: each member of the ensemble has it. The calibrated inputs follow.
export const changedInputs = () => chosen({ ...rigInputs(state, state.inputs), ...state.inputs });
const members = content.ensemble.map((member) => ({ ...defaultInputs, ...member }));
const membersWith = remembered((given) => conditioned(members, given));
export const memberInputs = () => membersWith(changedInputs());
// the first member is the best one
export const currentInputs = () => memberInputs()[0] ?? { ...defaultInputs, ...changedInputs() };

// The conditions that are chosen; the viscosity may be that of an oil.
export function chosenConditions() {
  const { oil_grade: grade, temperature_C: temperature, conditions } = state;
  return grade ? { ...conditions, viscosity: 1e-6 * oilViscosity(grade, temperature) } : conditions;
}
export const currentPoint = () => ({ ...startOf(state.figure), ...chosenConditions() });

// Whether the inputs are calibrated ones.
export const isCalibrated = () => Object.keys(changedInputs()).length === 0;

// The conditions of a curve in the first panel of a figure: the one nearest to the usual conditions.
function startOf(figure) {
  const { curves, panels: [{ curves: places }] } = content.figures.find(({ name }) => name === figure);
  const { load, ...usual } = USUAL;
  const far = (curve) => ([name, value]) => (curve[name] > 0 ? Math.abs(Math.log(curve[name] / value)) : ABSENT);
  return { load, ...d3.least(places.map((place) => curves[place]), (curve) => d3.sum(Object.entries(usual), far(curve))) };
}

const axisNamed = (name) => axes.find((axis) => axis.name === name);
export const toUnit = (name, value) => value / axisNamed(name).scale;

export function toFragment() {
  const given = new URLSearchParams();
  for (const name of Object.keys(CHOICES)) if (name !== "view" && !isDefault(name)) given.set(name, state[name]);
  if (state.view !== viewOf(given)) given.set("view", state.view);
  for (const name of Object.keys(NUMBERS)) if (!isDefault(name)) given.set(name, significant(state[name], 12));
  for (const [name, value] of Object.entries(state.conditions)) {
    given.set(axisNamed(name).key, significant(toUnit(name, value), 12));
  }
  for (const [name, value] of Object.entries(state.inputs)) given.set(name, String(value));
  const text = given.toString().replaceAll("+", "%20"); // a plus would be read as one
  return text && `sum=${sumOf(given)}&${text}`;
}

// The view of a link that names none: the figure, if it names one.
const viewOf = (given) => (given.has("figure") ? "figures" : DEFAULTS.view);

// A link has a sum of what it says and of the default from which it differs. If the link was cut, or made with other
// inputs, the sum is another.
function sumOf(given) {
  const signs = [...JSON.stringify(defaultInputs), ...given.toString()];
  return signs.reduce((sum, sign) => (Math.imul(31, sum) + sign.codePointAt(0)) >>> 0, 7).toString(36);
}

// Show what a fragment says. If it says anything that is not known or not allowed, show the default and say so.
export function fromFragment(text) {
  try {
    change(stateIn(text.replace(/^#/, "")));
  } catch (error) {
    if (!(error instanceof RangeError)) throw error;
    change({ ...fresh(), damage: `This link is damaged, or of another version: ${error.message}. Shown: the default.` });
  }
}

function stateIn(text) {
  const wanted = fresh();
  const plusKept = text.replaceAll("+", "%2B"); // that of 1e+12 is not a space
  const given = new URLSearchParams(plusKept);
  if (plusKept.startsWith("sum=")) { // a link that a person wrote has none
    const sum = given.get("sum");
    given.delete("sum");
    if (sum !== sumOf(given)) throw new RangeError("it was cut or changed, or made with other default inputs");
  }
  const entries = [...given];
  for (const [place, [name, word]] of entries.entries()) {
    const axis = axes.find(({ key }) => key === name);
    const isRepeated = entries.findIndex(([other]) => other === name) < place;
    const value = isRepeated ? undefined : readAs(name, axis, word);
    if (value === undefined) throw new RangeError(`${name}=${word}`);
    if (axis) wanted.conditions[axis.name] = value;
    else if (Object.hasOwn(content.inputs, name)) wanted.inputs[name] = value;
    else wanted[name] = value;
  }
  if (!given.has("view")) wanted.view = viewOf(given);
  wanted.conditions = chosen(wanted.conditions);
  wanted.inputs = chosen(wanted.inputs);
  if (!materialInputs(wanted)) throw new RangeError(`particle=${wanted.particle}, which is softer than a surface`);
  if (!areHard({ ...defaultInputs, ...rigInputs(wanted, wanted.inputs), ...wanted.inputs })) throw new RangeError("particles that are too soft");
  const { oil_grade: grade, temperature_C: temperature } = wanted;
  if (grade && !oilViscosity(grade, temperature)) throw new RangeError(`oil_grade=${grade} at temperature_C=${temperature}`);
  return wanted;
}

// The value of a name in a fragment; undefined if the name is unknown or the word is not allowed.
function readAs(name, axis, word) {
  if (axis) return conditionFrom(axis.name, numberIn(word));
  if (Object.hasOwn(NUMBERS, name)) return numberNamed(name, numberIn(word));
  if (Object.hasOwn(CHOICES, name)) return CHOICES[name].find((choice) => choice === word);
  return Object.hasOwn(content.inputs, name) ? inputNamed(name, word) : undefined;
}

// A condition in SI, the load in newtons, from a value in its unit; undefined if it is not allowed.
export function conditionFrom(name, value) {
  const isPositive = name === "load" || name === "roughness" ? value > 0 : value >= 0;
  return isPositive && value < Infinity ? Number((value * axisNamed(name).scale).toPrecision(12)) : undefined;
}

// A number in its unit; undefined if it is not allowed.
export function numberNamed(name, value) {
  const [least, most] = NUMBERS[name].bounds;
  return value >= least && value <= most ? value : undefined;
}

// The value of an input that a word stands for; undefined if it is not allowed.
export function inputNamed(name, word) {
  const { allowed, least, most } = content.inputs[name];
  if (allowed) return allowed.find((each) => String(each) === word);
  const value = numberIn(word);
  return value >= least && value <= most ? value : undefined;
}
