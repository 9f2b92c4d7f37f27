// What the page shows, and its text in the fragment of the address: whatever differs from the default.

import { numberIn, significant } from "./text.js";

export const content = JSON.parse(document.getElementById("content").textContent);
export const axes = content.axes; // load, then the four conditions of a curve
export const conditionAxes = axes.slice(1);
export const defaultInputs = Object.fromEntries(
  Object.entries(content.inputs).map(([name, { value }]) => [name, value]),
);

// conditions of the point that is shown where none are chosen; the load in newtons, else SI
export const START = {
  load: 10,
  viscosity: 90e-6,
  particle_diameter: 500e-9,
  roughness: 300e-9,
  particle_density: 1e11,
};
const PLAIN = {
  view: "figures",
  figure: (content.figures.find(({ name }) => name === "fig11") ?? content.figures[0]).name,
  x: "load",
  y: "particle_contact_area_ratio",
  by: "particle_diameter",
  map_x: "load",
  map_y: "particle_diameter",
  x_scale: "auto",
  y_scale: "auto",
  area: "own",
  claim: "",
  show: "here",
};

const fresh = () => ({ ...PLAIN, conditions: {}, inputs: {} });
export const state = fresh();
const listeners = [];
export const onChange = (listener) => listeners.push(listener);

// Change what is shown: `what` has fields of the state.
export function change(what) {
  Object.assign(state, what);
  listeners.forEach((listener) => listener(state));
}

export function setCondition(name, value) {
  const conditions = { ...state.conditions };
  if (value === undefined) delete conditions[name];
  else conditions[name] = value;
  change({ conditions });
}

export function setInputs(values) {
  const inputs = { ...state.inputs, ...values };
  for (const name of Object.keys(inputs)) {
    if (inputs[name] === undefined || inputs[name] === defaultInputs[name]) delete inputs[name];
  }
  change({ inputs });
}

export const reset = () => change(fresh());
export const currentInputs = () => ({ ...defaultInputs, ...state.inputs });
export const currentPoint = () => ({ ...START, ...state.conditions });

const axisNamed = (name) => axes.find((axis) => axis.name === name);
export const toUnit = (name, value) => (name === "load" ? value : value / axisNamed(name).scale);
export const fromUnit = (name, value) =>
  name === "load" ? value : Number((value * axisNamed(name).scale).toPrecision(12));

export function toFragment() {
  const given = new URLSearchParams();
  for (const name of Object.keys(PLAIN)) if (state[name] !== PLAIN[name]) given.set(name, state[name]);
  for (const [name, value] of Object.entries(state.conditions)) {
    given.set(axisNamed(name).key, significant(toUnit(name, value), 12));
  }
  for (const [name, value] of Object.entries(state.inputs)) given.set(name, String(value));
  return given.toString();
}

// What a fragment says; what it says wrongly is left out.
export function fromFragment(text) {
  const found = fresh();
  const plusKept = text.replace(/^#/, "").replaceAll("+", "%2B"); // that of 1e+12, no space
  for (const [name, word] of new URLSearchParams(plusKept)) {
    const axis = axes.find(({ key }) => key === name);
    const number = numberIn(word);
    if (name in PLAIN) found[name] = word;
    else if (axis && isAllowed(axis, number)) found.conditions[axis.name] = fromUnit(axis.name, number);
    else if (name in defaultInputs) {
      const value = inputNamed(name, word);
      if (value !== undefined && value !== defaultInputs[name]) found.inputs[name] = value;
    }
  }
  for (const name of Object.keys(PLAIN)) if (!isKnown(name, found[name])) found[name] = PLAIN[name];
  change(found);
}

const quantities = Object.keys(content.quantities);
const names = axes.map(({ name }) => name);
const KNOWN = {
  view: ["figures", "axes", "map", "section"],
  figure: content.figures.map(({ name }) => name),
  x: [...names, ...quantities],
  y: quantities,
  by: names,
  map_x: names,
  map_y: names,
  x_scale: ["auto", "log", "linear"],
  y_scale: ["auto", "log", "linear"],
  area: ["own", "over_two_body"],
  claim: ["", ...content.claims.map(({ id }) => id)],
  show: ["here", "all", "fails", "changed"],
};
const isKnown = (name, word) => KNOWN[name].includes(word);

export function isAllowed({ name }, value) {
  const positive = name === "load" || name === "roughness";
  return Number.isFinite(value) && (positive ? value > 0 : value >= 0);
}

// The value of an input that a word stands for; undefined if it is not allowed.
export function inputNamed(name, word) {
  const { allowed, least, most } = content.inputs[name];
  if (allowed) return allowed.find((each) => String(each) === word);
  const value = numberIn(word);
  return value >= least && value <= most ? value : undefined;
}
