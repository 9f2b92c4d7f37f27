// The model at the inputs that are chosen, and its curves, each computed once.

import { axes, defaultInputs } from "./content.js";
import { modelOf, remembered } from "./model.js";
import { PROMINENCE, curveOf, highestMaximum } from "./curves.js";
import { scaleFor } from "./names.js";
import { currentInputs, memberInputs } from "./state.js";

const SLICE = 12; // milliseconds
const ENGINES = 70; // sets of inputs: those of the ensemble, and the last that were chosen
const OVER_TWO_BODY = "total_contact_area_over_two_body";
const DRY_TWO_BODY = { viscosity: 0, particle_diameter: 0, particle_density: 0 };

export const engineOf = remembered((inputs) => {
  const model = modelOf(inputs);
  const { newtonsPerLoad } = model;
  const loads = axes[0].range.map((force) => force / newtonsPerLoad); // first and last F_t* of curves
  const contact = remembered(model.contact);
  const curve = remembered((condition) => {
    const states = curveOf(contact(condition), ...loads);
    const peak = highestMaximum(contact(condition), states.map(({ separation }) => separation));
    return { condition, states, peak, turningPoint: peak.prominence >= PROMINENCE ? peak : undefined };
  });
  // A_t* of dry contact without particles on the same surface
  const twoBodyArea = remembered(
    ({ roughness, load }) => contact({ ...DRY_TWO_BODY, roughness }).solve(load).total_contact_area,
    5000,
  );
  // two variables of a state at a condition
  const pointOf = (x, y, found, condition) => {
    const relative = () => found.total_contact_area / twoBodyArea({ roughness: condition.roughness, load: found.load });
    const valueOf = (name) => (name === OVER_TWO_BODY ? relative() : (condition[name] ?? found[name]));
    return { x: valueOf(x), y: valueOf(y), state: found };
  };
  // the points of a line over the load
  const points = remembered(({ x, y, condition }) => curve(condition).states.map((found) => pointOf(x, y, found, condition)));
  // the state at all five conditions, the load in newtons
  const state = ({ load, ...condition }) => contact(condition).solve(load / newtonsPerLoad);
  return { inputs, model, newtonsPerLoad, loads, contact, curve, points, pointOf, state };
}, ENGINES);

export const defaultEngine = () => engineOf(defaultInputs);
export const currentEngine = () => engineOf(currentInputs());
export const memberEngines = () => memberInputs().map((inputs) => engineOf(inputs));

// The paper's range of a condition, and the chosen value if it is outside.
export function shownRange(name, point) {
  const { range, scale } = axes.find((axis) => axis.name === name);
  const [low, high] = range.map((end) => end * scale);
  const first = { viscosity: 1e-6, particle_diameter: 10e-9 }[name] ?? low; // Eq. 7 means no thinner film
  return [Math.min(first, point[name] || first), Math.max(high, point[name])];
}

// Values of a condition along that range.
export function placesAlong(name, point, count) {
  const scale = scaleFor(name).domain(shownRange(name, point)).range([0, count - 1]);
  return d3.range(count).map((place) => scale.invert(place));
}

// Run the steps of a generator as long as they are wanted. They run in slices, between which the page answers; on paper
// they run at once. Until they are done, the element that they fill is busy.
const waiting = new Map();
export function inSlices(element, steps, isWanted, pause = 0) {
  element.setAttribute("aria-busy", "true");
  waiting.set(element, { steps, isWanted });
  const isMine = () => waiting.get(element)?.steps === steps;
  function slice() {
    if (!isMine()) return;
    const start = performance.now();
    while (isWanted() && performance.now() - start < SLICE) {
      if (!steps.next().done) continue;
      if (isMine()) finish(element); // the last step may have asked for others
      return;
    }
    if (isWanted()) setTimeout(slice, 0);
    else finish(element);
  }
  setTimeout(slice, pause);
}

function finish(element) {
  waiting.delete(element);
  element.removeAttribute("aria-busy");
}

export function finishAll() {
  for (const [element, { steps, isWanted }] of [...waiting]) {
    while (isWanted() && !steps.next().done);
    finish(element);
  }
}
