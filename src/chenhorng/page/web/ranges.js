// Ranges over the ensemble of the calibrated inputs.

import { content } from "./content.js";
import { capital } from "./names.js";
import { currentInputs, memberInputs } from "./state.js";
import { currentEngine, memberEngines } from "./engine.js";
import { curveOf } from "./curves.js";

const ENDS = [0.05, 0.95]; // quantiles at the ends of a range
const LOADS = 60; // on its outline
const KEPT = 40; // curves

export function definition() {
  const { length } = memberInputs();
  if (!length) return "";
  return `${capital(content.range)}; here of ${length} sets. What you change is known: all sets have it, and their other calibrated inputs follow.`;
}

// Both ends of the range of values, without those that are not solved.
export const rangeOf = (values) => ENDS.map((end) => d3.quantile(values, end));

// The states of all members along curves, at loads F_t*; by what was changed and the condition
const solved = new Map();
const keyOf = (condition) => JSON.stringify([currentInputs(), condition]);

// The outline of the range of y along a curve, as points [x, y]; undefined until the members are solved.
export function outlineOf(condition, y) {
  const members = solved.get(keyOf(condition));
  if (!members) return undefined;
  const engines = memberEngines();
  const ends = d3.transpose(members).map((states) => {
    const [low, high] = rangeOf(states.map((state, place) => engines[place].pointOf("load", y, state, condition).y));
    return { load: states[0].load, low, high };
  });
  const known = ends.filter(({ low }) => low !== undefined);
  return [...known.map(({ load, low }) => [load, low]), ...d3.reverse(known).map(({ load, high }) => [load, high])];
}

// Solve the members along the curves at some conditions, in steps, and call `done`.
export function* rangeSteps(conditions, done) {
  const { loads } = currentEngine();
  const missing = new Map(conditions.map((condition) => [keyOf(condition), condition]));
  for (const key of solved.keys()) missing.delete(key);
  if (!missing.size || !memberInputs().length) return;
  if (solved.size > KEPT) solved.clear();
  for (const [key, condition] of missing) {
    const members = [];
    for (const { contact } of memberEngines()) {
      members.push(curveOf(contact(condition), ...loads, LOADS));
      yield;
    }
    solved.set(key, members);
  }
  done();
}
