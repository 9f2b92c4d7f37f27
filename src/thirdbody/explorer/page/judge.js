// Whether the paper's statements hold under the inputs of the page: the checks of
// thirdbody.study.kinds, on curves of the page's own model. config/claims.yaml explains the kinds.

import { LIMITS, remembered } from "./model.js";
import { PROMINENCE, turningWindow } from "./curves.js";

const WINDOW_DENSITY = 1e11; // eta_a [m-2] for which the paper gives its windows
const BEND = 0.1; // by how much a slope has fallen at a visible bend
const MARGIN = 1e-12; // relative, of the ends between which values are interpolated
const TINY = 1e-300; // least argument of a logarithm

const STATES = {
  boundary: ["solid_load_fraction", LIMITS.boundary, Infinity],
  mixed: ["solid_load_fraction", LIMITS.full_film, LIMITS.boundary],
  full_film: ["solid_load_fraction", -Infinity, LIMITS.full_film],
  particle_surface: ["particle_contact_area_ratio", LIMITS.particle, Infinity],
  hybrid: ["particle_contact_area_ratio", LIMITS.surface, LIMITS.particle],
  surface_surface: ["particle_contact_area_ratio", -Infinity, LIMITS.surface],
};
const TURNING_POINT = {
  turning_point_load: (point) => point.load,
  turning_point_ratio: (point) => point.particle_contact_area_ratio,
  turning_point_solid_load_fraction: (point) => point.solid_load_fraction,
  turning_point_solid_load: (point) => point.solid_load_fraction * point.load,
};
const log = (values) => values.map((value) => Math.log(Math.max(value, TINY)));
const negated = (values) => values.map((value) => -value);
const most = (values) => Math.max(...values); // NaN if one is
const least = (values) => Math.min(...values);
const difference = (a, b) => a.map((value, i) => value - b[i]);

const NOT_REACHED = new Error("no load of the curve is within the bounds of the statement");

// Variables along a curve, as arrays.
class Course {
  constructor(states) {
    for (const name of Object.keys(states[0])) this[name] = states.map((state) => state[name]);
    this.solid_load = this.load.map((load, i) => load * this.solid_load_fraction[i]);
  }

  // between the neighbours of each point, whose steps are equal
  get total_contact_area_slope() {
    const [x, y] = [this.load.map(Math.log), log(this.total_contact_area)];
    return y.map((_, i) => {
      const [before, after] = [Math.max(i - 1, 0), Math.min(i + 1, y.length - 1)];
      return (y[after] - y[before]) / (x[after] - x[before]);
    });
  }

  // The variable `name` where the variable `against` has the values x, NaN beyond the curve.
  // Logarithms are interpolated where all values are positive.
  at(name, x, against = "load") {
    if (name === against) return x;
    const known = this[against].map(Math.log);
    const logarithmic = this[name].every((value) => value > 0);
    const values = logarithmic ? this[name].map(Math.log) : this[name];
    const scale = d3.scaleLinear(known, values).clamp(true);
    const [low, high] = d3.extent(known);
    const margin = MARGIN * Math.max(Math.abs(low), Math.abs(high));
    return x.map((value) => {
      const place = Math.log(value);
      if (!(place >= low - margin && place <= high + margin)) return NaN;
      return logarithmic ? Math.exp(scale(place)) : scale(place);
    });
  }
}

// What statements are judged on: curves, turning points and windows, each found when first asked for.
export const evidenceOf = (engine) => ({
  newtonsPerLoad: engine.newtonsPerLoad,
  curve: remembered((condition) => new Course(engine.curve(condition).states)),
  turningPoint: (condition) => engine.curve(condition).peak,
  window: remembered((roughness) => turningWindow(engine.model, roughness, WINDOW_DENSITY, ...engine.loads)),
});

// The verdict on a statement, `holds`, `fails` or why it is neither, with the `numbers` that were compared
// and their `distance` from the statement in tolerances.
export function judge(claim, evidence) {
  const { curves, references } = claim;
  const { numbers = [], distance, tested } = measure(claim, evidence);
  // of any curve, the one that agrees best must have a turning point
  const nearest = claim.any_curve ? d3.leastIndex(numbers, (number) => fromPublished(claim, [number])) : -1;
  const judged = nearest >= 0 ? [curves[nearest]] : curves;
  const points = claim.source === "turning_point" ? [...judged, ...references].map(evidence.turningPoint) : [];
  const turns = points.every(({ prominence }) => prominence >= PROMINENCE);
  const found = { numbers, distance: turns ? distance : NaN };
  if (claim.aside) return { ...found, verdict: "contradicted by the paper itself" };
  if (!tested) return { ...found, verdict: "not tested" };
  return { ...found, verdict: found.distance <= 1 ? "holds" : "fails" };
}

// What a check finds, and whether the loads suffice for it.
function measure(claim, evidence) {
  try {
    return { ...CHECKS[claim.kind](claim, evidence), tested: isWithinTheLoads(claim, evidence) };
  } catch (error) {
    if (error !== NOT_REACHED) throw error;
    return { distance: Infinity, tested: claim.must_be_reached };
  }
}

// A load beyond the last one is known to be larger, and no more.
function isWithinTheLoads(claim, evidence) {
  if (claim.quantity !== "load" && !(claim.quantity in BETWEEN_CURVES)) return true;
  const end = evidence.curve(claim.curves[0]).load.at(-1);
  if (claim.quantity === "bend_load_over_mixed_load") {
    return most([...bendLoads(claim, evidence), ...mixedLoads(claim, evidence)]) < end;
  }
  const loads = scalars(claim, evidence);
  const beyond = loads.map((load) => load >= end);
  if (claim.along) return !d3.pairs(beyond).some(([a, b]) => a && b);
  if (claim.kind === "reach") return beyond.includes(false);
  if (claim.published === null || !beyond.includes(true)) return !beyond.includes(true);
  return fromPublished(claim, loads.map((load) => Math.min(load, end))) > 1;
}

// For each kind of statement a check, which gives the distance in tolerances and the numbers compared
const CHECKS = {
  value(claim, evidence) {
    const numbers = scalars(claim, evidence);
    const each = numbers.map((value) => fromPublished(claim, [value]));
    return { numbers, distance: claim.any_curve ? least(each) : fromPublished(claim, numbers) };
  },
  reach(claim, evidence) {
    const numbers = scalars(claim, evidence);
    const sign = claim.extreme === "minimum" ? 1 : -1;
    const lacks = numbers.map((value) => Math.max(sign * (value - claim.published), 0));
    return { numbers, distance: most(lacks) / claim.tolerance };
  },
  span(claim, evidence) {
    const [low, high] = d3.extent(courses(claim, evidence)[0]);
    const nearest = claim.published.map((value) => Math.min(Math.max(value, low), high));
    return { numbers: [low, high], distance: fromPublished(claim, nearest) };
  },
  window(claim, evidence) {
    const numbers = claim.curves.flatMap(({ roughness }) => evidence.window(roughness));
    return { numbers, distance: fromPublished(claim, numbers) };
  },
  ordering(claim, evidence) {
    const sign = claim.direction === "decreasing" ? -1 : 1;
    const found = gaps(claim, evidence).map((gap) => gap.map((value) => sign * value));
    const against = -least(found.map(least));
    const apart = least(found.map(most));
    return { distance: most([against, 2 * claim.step - apart]) / claim.step };
  },
  coincidence(claim, evidence) {
    return { distance: most(gaps(claim, evidence).flat().map(Math.abs)) / claim.step };
  },
  trend: checkCourse,
  absence: checkCourse,
  regime_sequence: checkSequence,
  mode_sequence: checkSequence,
};

function checkCourse(claim, evidence) {
  const numbers = claim.along === "curves" ? scalars(claim, evidence) : [];
  const found = numbers.length ? [numbers] : courses(claim, evidence);
  const miss = COURSES[claim.direction || claim.kind];
  const misses = found.map((course) => miss(claim.relative ? log(course) : course, claim.step));
  return { numbers, distance: most(misses) / claim.step };
}

function checkSequence(claim, evidence) {
  const misses = claim.curves.map((curve) => sequenceMiss(claim, evidence.curve(curve)));
  return { distance: (claim.any_curve ? least(misses) : most(misses)) / claim.step };
}

// Distance of numbers from the published ones in tolerances; the largest counts.
function fromPublished(claim, values) {
  const published = [claim.published].flat();
  const distances = values.map((value, i) => {
    const wanted = published[i % published.length];
    if (wanted === null || Number.isNaN(value)) return NaN;
    if (!claim.relative) return Math.abs(value - wanted) / claim.tolerance;
    const ratio = Math.max(value / wanted, TINY);
    const size = claim.tolerance;
    const [low, high] = claim.tolerance_kind === "factor" ? [1 / size, size] : [1 - size, 1 + size];
    return Math.log(ratio) / Math.log(ratio < 1 ? low : high);
  });
  return most(distances);
}

// The quantity of a statement as one number for each curve.
function scalars(claim, evidence) {
  const { quantity } = claim;
  if (quantity in BETWEEN_CURVES) return BETWEEN_CURVES[quantity](claim, evidence);
  if (quantity === "departure_sharpness") return departureSharpness(claim, evidence);
  if (claim.source === "turning_point") {
    const pick = (curve) => TURNING_POINT[quantity](evidence.turningPoint(curve));
    const [values, references] = [claim.curves.map(pick), claim.references.map(pick)];
    return references.length ? values.map((value, i) => value / references[i] - 1) : values;
  }
  if (claim.source === "window") {
    const end = quantity === "window_low" ? 0 : 1;
    return claim.curves.map(({ roughness }) => evidence.window(roughness)[end]);
  }
  return courses(claim, evidence).map(claim.extreme === "maximum" ? most : least);
}

// The quantity along each curve, or its relative change from the reference.
function courses(claim, evidence) {
  if (!claim.references.length) return claim.curves.map((curve) => table(claim, evidence, [curve])[1][0]);
  return claim.curves.map((curve, i) => {
    const [reference, values] = table(claim, evidence, [claim.references[i], curve])[1];
    return values.map((value, k) => value / reference[k] - 1);
  });
}

// By how much each curve is above its reference, or above the curve before it.
function gaps(claim, evidence) {
  const groups = claim.references.length ? d3.zip(claim.references, claim.curves) : [claim.curves];
  return groups.flatMap((group) => {
    const values = table(claim, evidence, group)[1].map((row) => (claim.relative ? log(row) : row));
    return d3.pairs(values, (below, above) => difference(above, below));
  });
}

// Loads at which two curves part or cross.
const BETWEEN_CURVES = {
  // load above which the areas increase from curve to curve
  total_contact_area_reversal_load(claim, evidence) {
    const [loads, areas] = table(claim, evidence, claim.curves, "total_contact_area");
    const falling = d3.reverse(loads);
    const rises = d3.pairs(areas.map(log), (below, above) => d3.reverse(difference(above, below)));
    return [most(rises.map((gap) => firstFall(falling, gap)))];
  },
  bend_load: bendLoads,
  bend_load_over_mixed_load(claim, evidence) {
    const mixed = mixedLoads(claim, evidence);
    return bendLoads(claim, evidence).map((load, i) => load / mixed[i]);
  },
};

// Loads at which the slope of the area has fallen below that of the reference.
function bendLoads(claim, evidence) {
  return claim.curves.map((each, i) => {
    const curve = evidence.curve(each);
    const reference = evidence.curve(claim.references[i]).at("total_contact_area_slope", curve.load);
    const fall = difference(reference, curve.total_contact_area_slope);
    return firstFall(curve.load, fall.map((value) => BEND - value));
  });
}

function mixedLoads(claim, evidence) {
  return claim.curves.map((each) => {
    const { load, solid_load_fraction: fraction } = evidence.curve(each);
    return firstFall(load, log(fraction.map((value) => value / LIMITS.boundary)));
  });
}

// How suddenly H_c leaves that of the reference: the greatest change of the slope of the logarithm of
// their ratio within a tenth of a decade, over the greatest slope.
function departureSharpness(claim, evidence) {
  return claim.curves.map((each, i) => {
    const { load, film_thickness: film } = evidence.curve(each);
    const reference = evidence.curve(claim.references[i]).at("film_thickness", load);
    const points = d3.zip(load.map(Math.log), log(film.map((value, k) => value / reference[k])));
    const slopes = d3.pairs(points, ([x, y], [nextX, nextY]) => (nextY - y) / (nextX - x));
    const middles = d3.pairs(points, ([x], [nextX]) => (x + nextX) / 2);
    const slopeAt = d3.scaleLinear(middles, slopes).clamp(true);
    const changes = middles.map((place, k) => slopeAt(place + 0.1 * Math.LN10) - slopes[k]);
    return most(changes) / Math.max(most(slopes), TINY);
  });
}

// Abscissa and quantity of some curves, where the statement refers to them.
function table(claim, evidence, group, quantity = claim.quantity) {
  const curves = group.map(evidence.curve);
  const bounded = claim.references.length ? curves.slice(1) : curves;
  let x = loadsOf(claim, curves, bounded, evidence);
  if (claim.against !== "load") {
    const spans = curves.map((curve) => d3.extent(curve[claim.against]));
    const [low, high] = [most(spans.map((span) => span[0])), least(spans.map((span) => span[1]))];
    const asked = curves.at(-1).at(claim.against, x);
    x = asked.map((value) => Math.min(Math.max(value, low), high));
  }
  return [x, curves.map((curve) => curve.at(quantity, x, claim.against))];
}

// The loads that a statement refers to: the one that it names, or all within its bounds.
function loadsOf(claim, curves, bounded, { newtonsPerLoad }) {
  const { load, load_min = 0, load_max_N = Infinity, load_max, ...others } = claim.limits;
  if (load !== undefined) return [load];
  const grid = curves.at(-1);
  const limits = Object.entries(others).map(([key, limit]) => {
    const [, name, end] = key.match(/^(.*?)(_min|_max)?$/);
    return { name, end, limit };
  });
  const level = limits.find(({ end }) => !end);
  if (level) {
    const excess = log(grid[level.name]).map((value) => value - Math.log(level.limit));
    return [firstFall(grid.load, excess)];
  }
  const low = most([load_min, ...curves.map((curve) => curve.load[0])]);
  const heaviest = load_max ?? load_max_N / newtonsPerLoad;
  const high = least([heaviest, ...curves.map((curve) => curve.load.at(-1))]);
  if (!(low < high)) throw NOT_REACHED;
  const loads = [low, ...grid.load.filter((each) => each > low && each < high), high];
  if (!limits.length) return loads;
  const shortfalls = d3.cross(limits, bounded, ({ name, end, limit }, curve) => {
    const sign = end === "_min" ? 1 : -1;
    return curve.at(name, loads).map((value) => sign * (limit - value));
  });
  const shortfall = d3.transpose(shortfalls).map(most);
  if (least(shortfall) > 0) throw NOT_REACHED;
  return loads.filter((_, i) => !(shortfall[i] > 0));
}

// Load at which values first fall to zero; they are continued by their last slope, for a decade at most.
function firstFall(loads, values) {
  if (!(values[0] > 0)) return values[0] <= 0 ? loads[0] : NaN;
  const fallen = values.findIndex((value) => !(value > 0));
  const right = fallen < 0 ? values.length - 1 : fallen;
  const step = Math.log(loads[right] / loads[right - 1]);
  const fall = Math.max(values[right - 1] - values[right], TINY);
  const advance = Math.min(values[right - 1] / fall, Math.LN10 / Math.abs(step));
  return loads[right - 1] * Math.exp(advance * step);
}

// The least, or the most, of the values up to each.
function running(pick, values) {
  let found = values[0];
  return values.map((value) => {
    found = pick(found, value);
    return found;
  });
}

function riseMiss(values, step) {
  const relapse = most(difference(running(Math.max, values), values));
  return most([relapse, 2 * step - (values.at(-1) - values[0])]);
}

// Height of the most prominent maximum above the lowest values on its two sides.
function peakHeight(values) {
  const left = running(Math.min, values);
  const right = d3.reverse(running(Math.min, d3.reverse(values)));
  return most(values.map((value, i) => value - Math.max(left[i], right[i])));
}

const peakMiss = (values, step) => 2 * step - peakHeight(values);

// By how much a course of values misses what its name says.
const COURSES = {
  increasing: riseMiss,
  decreasing: (values, step) => riseMiss(negated(values), step),
  constant: (values) => most(values) - least(values),
  rising_then_falling: peakMiss,
  falling_then_rising: (values, step) => peakMiss(negated(values), step),
  increasing_at_each_step: (values, step) => 2 * step - least(d3.pairs(values, (a, b) => b - a)),
  absence: peakHeight,
};

// How far a curve leaves the published states. Its points are divided among the steps in turn, each
// with at least one point; the division with the least miss counts. Each step must also be met.
function sequenceMiss(claim, curve) {
  const excursions = claim.published.map((step) => excursion(curve, step));
  if (excursions.flat().some(Number.isNaN)) return NaN;
  const required = claim.open_end ? excursions.slice(0, -1) : excursions;
  const unmet = Math.max(most(required.map(least)) + claim.tolerance, 0);
  const reached = claim.published.map(() => Infinity); // least miss so far with the point in this step
  curve.load.forEach((_, point) => {
    let come = point === 0 ? -Infinity : Infinity;
    for (let step = 0; step < reached.length; step++) {
      const stay = reached[step];
      reached[step] = Math.max(Math.min(stay, come), excursions[step][point], 0);
      come = stay;
    }
  });
  return Math.max(least(reached.slice(claim.open_end ? -2 : -1)), unmet);
}

// How far each point is outside a step, which names alternatives: "mixed hybrid or full_film".
function excursion(curve, step) {
  const outside = (name, i) => {
    const [quantity, low, high] = STATES[name];
    return Math.max(low - curve[quantity][i], curve[quantity][i] - high);
  };
  const alternatives = step.split(" or ").map((alternative) => alternative.split(" "));
  return curve.load.map((_, i) =>
    least(alternatives.map((names) => most(names.map((name) => outside(name, i))))),
  );
}
