// Curves over the load, their turning points, and what lies between: all from the model's script.

export const PROMINENCE = 0.02; // by how much A_sa,t* stands out at a turning point, on both sides
const SEPARATIONS = 60; // between which turning points are looked for

export const logSpaced = (low, high, count) =>
  Array.from({ length: count }, (_, i) => low * (high / low) ** (i / (count - 1)));

// The states along a curve, at `count` evenly spaced loads F_t* from `low` to `high`.  Each is sought
// where the two before it lead to.
export function curveOf(contact, low, high, count = 80) {
  const states = [];
  for (const load of logSpaced(low, high, count)) {
    const [before, last] = [states[states.length - 2], states[states.length - 1]];
    const near = last && before && 3 * last.separation - 2 * before.separation;
    states.push(contact.solve(load, last?.separation, near));
  }
  return states;
}

const ratioOf = (contact, d) => {
  const { particles, summits } = contact.solids(d);
  return particles / (particles + summits);
};

// The interior maximum of A_sa,t* between falling separations that stands out most, with its
// `prominence`; null where there is none.  A_sa,t* depends on d alone: the maximum is found over d, and
// its load follows.
export function summitBetween(contact, separations) {
  if (contact.twoBody) return null;
  const ratios = separations.map((d) => ratioOf(contact, d));
  let best = null;
  for (let i = 1; i < ratios.length - 1; i++) {
    if (!(ratios[i] > ratios[i - 1] && ratios[i] >= ratios[i + 1])) continue;
    const d = maximum((x) => ratioOf(contact, x), separations[i + 1], separations[i - 1]);
    const ratio = ratioOf(contact, d);
    const sides = [ratios.slice(0, i), ratios.slice(i + 1)].map((side) => ratio - Math.min(...side));
    const prominence = Math.min(...sides);
    if (!best || prominence > best.prominence) best = { d, prominence };
  }
  return best && { ...contact.at(best.d, contact.loadAt(best.d)), prominence: best.prominence };
}

const separationsOf = (states) => states.map(({ separation }) => separation);
export const summitOf = (contact, states) => summitBetween(contact, separationsOf(states));

// The turning point of the contact area, or null: a maximum that stands out enough.
export function turningPointOf(contact, states) {
  const found = summitOf(contact, states);
  return found && found.prominence >= PROMINENCE ? found : null;
}

// The same between two loads, from the separations at both and others in between.
function summitOfLoads(contact, low, high) {
  const [far, near] = [contact.solve(low).separation, contact.solve(high).separation];
  if (Number.isNaN(near)) return null;
  const step = (near - far) / (SEPARATIONS - 1);
  return summitBetween(contact, Array.from({ length: SEPARATIONS }, (_, i) => far + step * i));
}

export function turningPointBetween(contact, low, high) {
  const found = summitOfLoads(contact, low, high);
  return found && found.prominence >= PROMINENCE ? found : null;
}

// Where a function with one maximum has it, by golden sections.
function maximum(f, low, high) {
  const golden = (Math.sqrt(5) - 1) / 2;
  let [a, b] = [high - golden * (high - low), low + golden * (high - low)];
  let [fa, fb] = [f(a), f(b)];
  for (let step = 0; step < 40; step++) {
    if (fa > fb) {
      [high, b, fb] = [b, a, fa];
      a = high - golden * (high - low);
      fa = f(a);
    } else {
      [low, a, fa] = [a, b, fb];
      b = low + golden * (high - low);
      fb = f(b);
    }
  }
  return 0.5 * (low + high);
}

// Ends of the range of x_a/sigma between which dry curves turn, [NaN, NaN] where none does.
export function turningWindow(model, roughness, density, low, high) {
  const margin = (ratio) => {
    const condition = { viscosity: 0, roughness, particle_density: density };
    const contact = model.contact({ ...condition, particle_diameter: ratio * roughness });
    const found = summitOfLoads(contact, low, high);
    return (found ? Math.sqrt(Math.max(found.prominence, 0)) : 0) - Math.sqrt(PROMINENCE);
  };
  const ratios = Array.from({ length: 111 }, (_, i) => 0.3 + (2.2 * i) / 110);
  const margins = ratios.map(margin);
  let [start, stop] = [-1, -2];
  for (let i = 0; i < ratios.length; i++) {
    if (!(margins[i] > 0)) continue;
    let end = i;
    while (margins[end + 1] > 0) end++;
    if (end - i > stop - start) [start, stop] = [i, end];
    i = end;
  }
  if (start < 0) return [NaN, NaN];
  const refined = (inner, outer) =>
    ratios[outer] === undefined ? ratios[inner] : bisected(margin, ratios[inner], ratios[outer]);
  return [refined(start, start - 1), refined(stop, stop + 1)];
}

function bisected(f, inside, outside) {
  for (let step = 0; step < 14; step++) {
    const middle = 0.5 * (inside + outside);
    if (f(middle) > 0) inside = middle;
    else outside = middle;
  }
  return 0.5 * (inside + outside);
}

// Where a state changes its regime or mode along an axis: at which value, from what, to what.
// `stateAt(value)` gives the state; `places` are increasing, and changes are found between them.
export function changesAlong(stateAt, places, flag) {
  const states = places.map(stateAt);
  const changes = [];
  for (let i = 1; i < states.length; i++) {
    const [before, after] = [states[i - 1][flag], states[i][flag]];
    if (before === after || before < 0 || after < 0) continue;
    const excess = (place) => (stateAt(place)[flag] === before ? 1 : -1);
    let [low, high] = [places[i - 1], places[i]];
    for (let step = 0; step < 30; step++) {
      const middle = 0.5 * (low + high);
      if (excess(middle) > 0) low = middle;
      else high = middle;
    }
    changes.push({ at: 0.5 * (low + high), from: before, to: after });
  }
  return changes;
}
