// Curves over the load, their turning points, and where states change.

import { modeText } from "./names.js";

export const PROMINENCE = 0.02; // by how much A_sa,t* stands out at a turning point, on both sides
const LOADS = 240; // on a curve
const SEPARATIONS = 60; // between which a maximum is searched for
const RATIOS = d3.range(111).map((i) => 0.3 + (2.2 * i) / 110); // x_a/sigma at which curves may turn

// The states along a curve at loads F_t* from `low` to `high`, evenly spaced in logarithms.
// The two states before give the separations between which the next is searched for first.
export function curveOf(contact, low, high, count = LOADS) {
  const states = [];
  for (let i = 0; i < count; i++) {
    const [before, last] = [states[i - 2], states[i - 1]];
    const near = before && 3 * last.separation - 2 * before.separation;
    states.push(contact.solve(low * (high / low) ** (i / (count - 1)), last?.separation, near));
  }
  return states;
}

// The state at the most prominent interior maximum of A_sa,t*, with its `prominence`, which is 0 without one.
// A_sa,t* depends on the separation alone: `separations` fall.
export function highestMaximum(contact, separations) {
  const ratioAt = (d) => {
    const { particles, summits } = contact.solids(d);
    return particles / (particles + summits);
  };
  const ratios = separations.map(ratioAt);
  const isPeak = (i) => ratios[i] > ratios[i - 1] && ratios[i] >= ratios[i + 1];
  const peaks = d3.range(1, ratios.length - 1).filter(isPeak).map((i) => {
    const d = maximum(ratioAt, separations[i + 1], separations[i - 1]);
    const lowest = Math.max(Math.min(...ratios.slice(0, i)), Math.min(...ratios.slice(i + 1)));
    return { d, prominence: ratioAt(d) - lowest };
  });
  const best = d3.greatest(peaks, ({ prominence }) => prominence);
  if (contact.twoBody || !(best?.prominence > 0)) return { prominence: 0 };
  return { ...contact.at(best.d, contact.loadAt(best.d)), prominence: best.prominence };
}

// The turning point of the contact area between two loads F_t*: a maximum that stands out enough.
export function turningPointBetween(contact, low, high) {
  const [far, near] = [low, high].map((load) => contact.solve(load).separation);
  const step = (near - far) / (SEPARATIONS - 1);
  const peak = highestMaximum(contact, d3.range(SEPARATIONS).map((i) => far + step * i));
  return peak.prominence >= PROMINENCE ? peak : undefined;
}

// The place of the maximum of a function that has one. The search cuts off thirds.
function maximum(f, low, high) {
  for (let step = 0; step < 50; step++) {
    const third = (high - low) / 3;
    if (f(low + third) < f(high - third)) low += third;
    else high -= third;
  }
  return 0.5 * (low + high);
}

// Ends of the range of x_a/sigma within which dry curves turn, [NaN, NaN] where none does.
export function turningWindow(model, roughness, density, low, high) {
  const turns = (ratio) => {
    const condition = { viscosity: 0, roughness, particle_density: density };
    const contact = model.contact({ ...condition, particle_diameter: ratio * roughness });
    return turningPointBetween(contact, low, high) !== undefined;
  };
  const inside = d3.range(RATIOS.length).filter((i) => turns(RATIOS[i]));
  if (!inside.length) return [NaN, NaN];
  const rows = d3.groups(inside, (i, rank) => i - rank); // of ratios that follow one another
  const [, longest] = d3.greatest(rows, ([, row]) => row.length);
  const [first, last] = d3.extent(longest);
  const end = (inner, outer) => boundary(turns, RATIOS[inner], RATIOS[outer] ?? RATIOS[inner], 14);
  return [end(first, first - 1), end(last, last + 1)];
}

// One place satisfies a condition and another does not: this finds where that changes.
export function boundary(isInside, inside, outside, steps = 30) {
  let [low, high] = [inside, outside];
  for (let step = 0; step < steps; step++) {
    const middle = 0.5 * (low + high);
    if (isInside(middle)) low = middle;
    else high = middle;
  }
  return 0.5 * (low + high);
}

// Places at which the mode, or the full film without one, changes: where, from what, to what.
export function modeChanges(stateAt, places) {
  const modes = places.map((place) => modeText(stateAt(place)));
  return d3.range(1, places.length).flatMap((i) => {
    const [from, to] = [modes[i - 1], modes[i]];
    if (from === to || !from || !to) return [];
    const at = boundary((place) => modeText(stateAt(place)) === from, places[i - 1], places[i]);
    return [{ at, from, to }];
  });
}
