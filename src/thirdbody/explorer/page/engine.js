// The model at the inputs that are chosen, and every curve of it once.

import { modelOf } from "./model.js";
import { curveOf, turningPointOf } from "./curves.js";
import { axes, currentInputs, defaultInputs } from "./state.js";

const MOST_KEPT = 600; // curves
const NEWTONS = axes[0].range;

class Engine {
  constructor(inputs) {
    this.inputs = inputs;
    this.model = modelOf(inputs);
    this.contacts = new Map();
    this.curves = new Map();
  }

  get newtonsPerLoad() {
    return this.model.newtonsPerLoad;
  }

  // first and last load F_t* of curves
  get loads() {
    return NEWTONS.map((force) => force / this.newtonsPerLoad);
  }

  contact(condition) {
    return kept(this.contacts, keyOf(condition), () => this.model.contact(condition));
  }

  curve(condition) {
    return kept(this.curves, keyOf(condition), () => {
      const contact = this.contact(condition);
      const states = curveOf(contact, ...this.loads);
      return { condition, states, turningPoint: turningPointOf(contact, states) };
    });
  }

  // the state at all five conditions, the load in newtons
  state({ load, ...condition }) {
    return this.contact(condition).solve(load / this.newtonsPerLoad);
  }

  // what dry contact without particles has on the same surface, at the loads of a curve
  twoBodyArea(condition) {
    const dry = { viscosity: 0, particle_diameter: 0, particle_density: 0 };
    return this.curve({ ...condition, ...dry }).states.map((state) => state.total_contact_area);
  }
}

const keyOf = ({ viscosity, particle_diameter, roughness, particle_density }) =>
  `${viscosity} ${particle_diameter} ${roughness} ${particle_density}`;

function kept(all, key, make) {
  if (!all.has(key)) {
    if (all.size > MOST_KEPT) all.clear();
    all.set(key, make());
  }
  return all.get(key);
}

let engine = null;
let engineKey = "";
export const defaultEngine = new Engine(defaultInputs);

// The engine of the inputs that are chosen now.
export function currentEngine() {
  const inputs = currentInputs();
  const key = JSON.stringify(inputs);
  if (key !== engineKey) {
    engine = key === JSON.stringify(defaultInputs) ? defaultEngine : new Engine(inputs);
    engineKey = key;
  }
  return engine;
}

// Values along an axis between two ends [SI; the load in newtons], evenly seen.
export function placesAlong(name, [low, high], count) {
  const log = name === "load" || name === "particle_density";
  const share = (i) => i / (count - 1);
  return Array.from({ length: count }, (_, i) =>
    log ? low * (high / low) ** share(i) : low + (high - low) * share(i),
  );
}
