// The model at the inputs that are chosen, and its curves, each computed once.

import { modelOf, remembered } from "./model.js";
import { curveOf, turningPointOf } from "./curves.js";
import { axes, content, currentInputs, defaultInputs } from "./state.js";

const SLICE = 12; // milliseconds
const NEWTONS = axes[0].range;
export const DRY_TWO_BODY = { viscosity: 0, particle_diameter: 0, particle_density: 0 };

export function engineOf(inputs) {
  const model = modelOf(inputs);
  const { newtonsPerLoad } = model;
  const loads = NEWTONS.map((force) => force / newtonsPerLoad); // first and last F_t* of curves
  const contact = remembered(model.contact);
  const curve = remembered((condition) => {
    const states = curveOf(contact(condition), ...loads);
    return { condition, states, turningPoint: turningPointOf(contact(condition), states) };
  });
  return {
    model,
    newtonsPerLoad,
    loads,
    contact,
    curve,
    // the state at all five conditions, the load in newtons
    state: ({ load, ...condition }) => contact(condition).solve(load / newtonsPerLoad),
    // A_t* of dry contact without particles on the same surface, at the loads of a curve
    twoBodyArea: (condition) =>
      curve({ ...condition, ...DRY_TWO_BODY }).states.map((each) => each.total_contact_area),
  };
}

const engineFor = remembered(engineOf, 20);
export const defaultEngine = engineOf(defaultInputs);
export const currentEngine = () => {
  const inputs = currentInputs();
  return JSON.stringify(inputs) === JSON.stringify(defaultInputs) ? defaultEngine : engineFor(inputs);
};
let members = null;
export function ensembleEngines() {
  members ??= content.ensemble.map((member) => engineOf({ ...defaultInputs, ...member }));
  return members;
}

// A value along an axis, at a part from 0 to 1 of the way between two ends [SI; the load in newtons].
export function placeAlong(name, [low, high], part) {
  const log = name === "load" || name === "particle_density";
  return log ? low * (high / low) ** part : low + (high - low) * part;
}

export const placesAlong = (name, ends, count) =>
  d3.range(count).map((i) => placeAlong(name, ends, i / (count - 1)));

// Run the steps of a generator in slices, between which the page answers, as long as they are wanted.
export function inSlices(steps, isWanted) {
  if (!isWanted()) return;
  const start = performance.now();
  while (performance.now() - start < SLICE) if (steps.next().done) return;
  setTimeout(inSlices, 0, steps, isWanted);
}
