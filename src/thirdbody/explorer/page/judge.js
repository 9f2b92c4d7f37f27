// Whether the paper's statements hold under the inputs at hand: the checks of thirdbody.study.checks,
// each on curves of the page's own model.  Kinds of statements are explained in config/claims.yaml.

import { LIMITS } from "./model.js";
import { PROMINENCE, curveOf, summitOf, turningWindow } from "./curves.js";
import { significant } from "./text.js";

const LOADS = 240; // on a curve
const WINDOW_DENSITY = 1e11; // eta_a [m-2] for which the paper gives its windows
const BOUND_TOLERANCE = 0.02; // of a ratio that bounds a range of loads: a line's width
const BEND = 0.1; // by how much a slope has fallen at a bend that a reader sees
const SATURATED = 1e-12; // nearer to 0 or 1, a ratio has lost the digits that tell its odds
const TINY = 1e-300;

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
const WINDOW = { window_low: 0, window_high: 1 };
const BETWEEN_CURVES = ["total_contact_area_reversal_load", "bend_load", "bend_load_over_mixed_load"];
const CURVE_QUANTITIES = [
  ...["load", "solid_load", "solid_load_fraction", "particle_contact_area_ratio"],
  ...["total_contact_area", "total_contact_area_slope", "film_thickness"],
];

const log = (values) => values.map((value) => Math.log(Math.max(value, TINY)));
const most = (values) => values.reduce((a, b) => (b > a || Number.isNaN(b) ? b : a), -Infinity);
const least = (values) => -most(values.map((value) => -value));
const placeOfMost = (values) => values.findIndex((v) => Number.isNaN(v) || v === most(values));
const difference = (a, b) => a.map((value, i) => value - b[i]);

class NotReached extends Error {
  constructor(shortfall) {
    super("not reached");
    this.shortfall = shortfall;
  }
}

// --- evidence: curves, turning points and windows, each found when first asked for ---

class Course {
  constructor(states) {
    for (const name of Object.keys(states[0])) this[name] = states.map((state) => state[name]);
    this.solid_load = this.load.map((load, i) => load * this.solid_load_fraction[i]);
    this.lnLoad = this.load.map(Math.log);
    this.kept = new Map();
  }

  get total_contact_area_slope() {
    return gradient(log(this.total_contact_area), this.lnLoad);
  }

  // values to interpolate between, as logarithms where all are positive
  samples(name) {
    if (!this.kept.has(name)) {
      const values = this[name];
      const logarithmic = values.every((value) => value > 0);
      this.kept.set(name, [logarithmic ? values.map(Math.log) : values, logarithmic]);
    }
    return this.kept.get(name);
  }

  // the quantity where the quantity `against` has the values x
  at(name, x, against = "load") {
    if (name === against) return x;
    const known = against === "load" ? this.lnLoad : this[against].map(Math.log);
    const [values, logarithmic] = this.samples(name);
    return x.map((value) => {
      const found = interpolated(Math.log(value), known, values);
      return logarithmic ? Math.exp(found) : found;
    });
  }
}

// by the rule of numpy.gradient for uneven steps
function gradient(y, x) {
  return y.map((_, i) => {
    if (i === 0) return (y[1] - y[0]) / (x[1] - x[0]);
    if (i === y.length - 1) return (y[i] - y[i - 1]) / (x[i] - x[i - 1]);
    const [h, k] = [x[i] - x[i - 1], x[i + 1] - x[i]];
    return (h * h * y[i + 1] + (k * k - h * h) * y[i] - k * k * y[i - 1]) / (h * k * (h + k));
  });
}

function interpolated(x, known, values) {
  const rising = known[0] < known[known.length - 1];
  let [low, high] = [0, known.length - 1];
  const [first, last] = rising ? [known[0], known[high]] : [known[high], known[0]];
  const margin = 1e-12 * Math.max(Math.abs(first), Math.abs(last));
  if (!(x >= first - margin && x <= last + margin)) return NaN;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (known[middle] <= x === rising) low = middle;
    else high = middle;
  }
  const share = (x - known[low]) / (known[high] - known[low]);
  return values[low] + Math.min(Math.max(share, 0), 1) * (values[high] - values[low]);
}

// What statements are judged on; the same question is answered once.
export function evidenceOf(model, newtons) {
  const [low, high] = newtons.map((force) => force / model.newtonsPerLoad);
  const kept = new Map();
  const once = (kind, key, make) => {
    const name = `${kind} ${key}`;
    if (!kept.has(name)) kept.set(name, make());
    return kept.get(name);
  };
  const key = (condition) => Object.values(condition).join(" ");
  const states = (condition) =>
    once("states", key(condition), () => curveOf(model.contact(condition), low, high, LOADS));
  return {
    model,
    curve: (condition) => once("curve", key(condition), () => new Course(states(condition))),
    turningPoint: (condition) =>
      once("turning point", key(condition), () => {
        const found = summitOf(model.contact(condition), states(condition));
        const none = { load: NaN, particle_contact_area_ratio: NaN, solid_load_fraction: NaN };
        return found && found.prominence > 0 ? found : { ...none, prominence: NaN };
      }),
    window: (roughness) =>
      once("window", roughness, () => turningWindow(model, roughness, WINDOW_DENSITY, low, high)),
  };
}

// --- judging ---

// Conditions of the curves of a statement [SI]; `changes` replace what it names once for all curves.
// What it says of dry or of two-body contact, a condition of 0, it says of no other.
export function conditionsOf(claim, axes, changes = {}) {
  const given = axes.map((axis) => {
    const values = [claim.conditions[axis.key]].flat();
    const mine = changes[axis.name];
    return values.length === 1 && values[0] > 0 && mine !== undefined ? [mine] : values.map((v) => v * axis.scale);
  });
  const count = Math.max(...given.map((values) => values.length));
  return Array.from({ length: count }, (_, i) =>
    Object.fromEntries(axes.map((axis, k) => [axis.name, tidy(given[k][i % given[k].length])])),
  );
}

const tidy = (value) => Number(value.toPrecision(12)); // as equal decimals are equal conditions

function referencesOf(claim, curves, axes) {
  if (!claim.reference) return [];
  const changed = axes.filter((axis) => axis.key in claim.reference);
  const changes = changed.map((axis) => [axis.name, tidy(claim.reference[axis.key] * axis.scale)]);
  return curves.map((curve) => ({ ...curve, ...Object.fromEntries(changes) }));
}

// The verdict on a statement: `holds`, `fails`, or why it is neither, and what was measured.
export function judge(claim, evidence, axes, changes) {
  const curves = conditionsOf(claim, axes, changes);
  const given = { ...claim, curves, references: referencesOf(claim, curves, axes) };
  given.step = claim.relative ? Math.log1p(claim.tolerance) : claim.tolerance;
  const source = sourceOf(claim);
  let measured;
  let distance;
  let tested;
  try {
    [measured, distance] = CHECKS[claim.kind](given, evidence);
    tested = isWithinTheLoads(given, evidence);
  } catch (error) {
    if (!(error instanceof NotReached)) throw error;
    tested = Boolean(claim.must_be_reached);
    distance = Infinity;
    measured = `not reached, by ${significant(error.shortfall, 3)}`;
  }
  if (source === "turning point") {
    const asked = [...curves, ...given.references];
    const prominence = least(asked.map((each) => evidence.turningPoint(each).prominence));
    if (!(prominence >= PROMINENCE)) {
      measured += Number.isNaN(prominence) ? "" : `; stands out by ${significant(prominence, 2)}`;
      distance = NaN;
    }
  }
  const verdict =
    claim.aside ? "contradicted by the paper itself"
    : !tested ? "not tested"
    : distance <= 1 ? "holds"
    : "fails";
  return { verdict, measured };
}

function sourceOf(claim) {
  if (claim.kind === "window" || claim.quantity in WINDOW) return "window";
  return claim.quantity in TURNING_POINT ? "turning point" : "curve";
}

// A load beyond the last one is known to be larger, and no more.
function isWithinTheLoads(claim, evidence) {
  if (claim.quantity !== "load" && !BETWEEN_CURVES.includes(claim.quantity)) return true;
  const loads = evidence.curve(claim.curves[0]).load;
  const last = loads[loads.length - 1];
  if (claim.quantity === "bend_load_over_mixed_load") {
    return most([...bendLoads(claim, evidence), ...mixedLoads(claim, evidence)]) < last;
  }
  const found = scalars(claim, evidence);
  const beyond = found.map((load) => load >= last);
  if (claim.along) return !beyond.some((each, i) => i > 0 && each && beyond[i - 1]);
  if (claim.kind === "reach") return beyond.includes(false);
  if (claim.published == null || !beyond.includes(true)) return !beyond.includes(true);
  return againstPublished(claim, found.map((load) => Math.min(load, last)), "")[1] > 1;
}

// --- one check for each kind of statement: what was measured, and its distance in tolerances ---

const CHECKS = {
  value(claim, evidence) {
    const values = scalars(claim, evidence);
    const text = shown(claim, evidence, values);
    if (!claim.any_curve) return againstPublished(claim, values, text);
    return [text, least(values.map((value) => againstPublished(claim, [value], "")[1]))];
  },
  reach(claim, evidence) {
    const values = scalars(claim, evidence);
    const sign = claim.extreme === "minimum" ? 1 : -1;
    const lacks = values.map((value) => Math.max(sign * (value - claim.published), 0));
    return [shown(claim, evidence, values), most(lacks) / claim.tolerance];
  },
  span(claim, evidence) {
    const curve = evidence.curve(claim.curves[0]);
    const [course] = courses(claim, evidence);
    const [low, high] = [least(course), most(course)];
    const nearest = claim.published.map((value) => Math.min(Math.max(value, low), high));
    const newtons = claim.published.map((value) =>
      significant(interpolate(value, course, curve.load) * evidence.model.newtonsPerLoad, 3),
    );
    const ends = [low, high].map((value) => significant(value, 4)).join(" to ");
    const text = `${ends}; nearest to the printed ends at ${newtons.map((each) => `${each} N`).join(" and ")}`;
    return againstPublished(claim, nearest, text);
  },
  window(claim, evidence) {
    const windows = claim.curves.map((each) => evidence.window(each.roughness));
    const text = windows.map(([low, high]) => `${low.toFixed(3)} to ${high.toFixed(3)}`).join(", ");
    return againstPublished(claim, windows.flat(), text);
  },
  ordering(claim, evidence) {
    const sign = claim.direction === "decreasing" ? -1 : 1;
    const found = gaps(claim, evidence).map((gap) => gap.map((value) => sign * value));
    const against = -least(found.map(least));
    const apart = least(found.map(most));
    const [wrong, right] = [Math.max(against, 0), apart].map((value) => significant(value, 3));
    const text = `against the order by ${wrong}, apart by ${right}`;
    return [text, most([against, 2 * claim.step - apart]) / claim.step];
  },
  coincidence(claim, evidence) {
    const widest = most(gaps(claim, evidence).map((gap) => most(gap.map(Math.abs))));
    return [`apart by ${significant(widest, 3)} at most`, widest / claim.step];
  },
  trend: checkCourse,
  absence: checkCourse,
  regime_sequence: checkSequence,
  mode_sequence: checkSequence,
};

function checkCourse(claim, evidence) {
  const alongCurves = claim.along === "curves";
  const found = alongCurves ? [scalars(claim, evidence)] : courses(claim, evidence);
  const miss = COURSES[claim.direction || claim.kind];
  const misses = found.map((course) => miss(claim.relative ? log(course) : course, claim.step));
  const worst = placeOfMost(misses);
  const course = found[worst];
  const [first, last, low, high] = [course[0], course[course.length - 1], least(course), most(course)]
    .map((value) => significant(value, 4));
  const text = `${first} to ${last} within ${low} and ${high}`;
  return [alongCurves ? shown(claim, evidence, course) : text, misses[worst] / claim.step];
}

function checkSequence(claim, evidence) {
  const curves = claim.curves.map(evidence.curve);
  const misses = curves.map((curve) => sequenceMiss(claim, curve));
  const chosen = claim.any_curve ? misses.indexOf(least(misses)) : placeOfMost(misses);
  return [visited(claim, curves[chosen]), misses[chosen] / claim.step];
}

function againstPublished(claim, measured, text) {
  const published = [claim.published].flat();
  const distances = measured.map((value, i) => {
    const wanted = published[i % published.length];
    if (wanted == null) return NaN;
    if (!claim.relative) return Math.abs(value - wanted) / claim.tolerance;
    const ratio = Number.isNaN(value) ? NaN : Math.max(value / wanted, TINY);
    return Math.log(ratio) / Math.log1p(ratio < 1 ? -claim.tolerance : claim.tolerance);
  });
  return [text, most(distances)];
}

// --- measuring ---

function scalars(claim, evidence) {
  if (claim.quantity === "total_contact_area_reversal_load") return [reversalLoad(claim, evidence)];
  if (claim.quantity === "bend_load") return bendLoads(claim, evidence);
  if (claim.quantity === "bend_load_over_mixed_load") {
    const mixed = mixedLoads(claim, evidence);
    return bendLoads(claim, evidence).map((load, i) => load / mixed[i]);
  }
  if (claim.quantity === "departure_sharpness") return departureSharpness(claim, evidence);
  const source = sourceOf(claim);
  if (source === "turning point") {
    const pick = TURNING_POINT[claim.quantity];
    const values = claim.curves.map((each) => pick(evidence.turningPoint(each)));
    const references = claim.references.map((each) => pick(evidence.turningPoint(each)));
    return references.length ? values.map((value, i) => value / references[i] - 1) : values;
  }
  if (source === "window") {
    return claim.curves.map((each) => evidence.window(each.roughness)[WINDOW[claim.quantity]]);
  }
  return courses(claim, evidence).map(claim.extreme === "maximum" ? most : least);
}

function courses(claim, evidence) {
  if (!claim.references.length) {
    return claim.curves.map((each) => table(claim, evidence, [each])[1][0]);
  }
  return claim.curves.map((each, i) => {
    const [reference, curve] = table(claim, evidence, [claim.references[i], each])[1];
    return curve.map((value, k) => value / reference[k] - 1);
  });
}

function gaps(claim, evidence) {
  const groups = claim.references.length
    ? claim.curves.map((each, i) => [claim.references[i], each])
    : [claim.curves];
  return groups.flatMap((group) => {
    const values = table(claim, evidence, group)[1].map((row) => (claim.relative ? log(row) : row));
    return values.slice(1).map((row, i) => difference(row, values[i]));
  });
}

function reversalLoad(claim, evidence) {
  const [loads, areas] = table(claim, evidence, claim.curves, "total_contact_area");
  const logs = areas.map(log);
  const rises = logs.slice(1).map((row, i) => difference(row, logs[i]).reverse());
  return most(rises.map((gap) => firstFall([...loads].reverse(), gap)));
}

function bendLoads(claim, evidence) {
  return claim.curves.map((each, i) => {
    const curve = evidence.curve(each);
    const reference = evidence.curve(claim.references[i]);
    const lead = reference.at("total_contact_area_slope", curve.load);
    const slope = curve.total_contact_area_slope;
    return firstFall(curve.load, slope.map((value, k) => BEND - (lead[k] - value)));
  });
}

function mixedLoads(claim, evidence) {
  return claim.curves.map((each) => {
    const curve = evidence.curve(each);
    return firstFall(curve.load, log(curve.solid_load_fraction.map((v) => v / LIMITS.boundary)));
  });
}

// How suddenly H_c leaves that of the reference: the greatest change of the slope of the logarithm of
// their ratio within a tenth of a decade, over the greatest slope.
function departureSharpness(claim, evidence) {
  return claim.curves.map((each, i) => {
    const wet = evidence.curve(each);
    const dry = evidence.curve(claim.references[i]).at("film_thickness", wet.load);
    const ratios = log(wet.film_thickness.map((value, k) => value / dry[k]));
    const places = wet.load.map(Math.log);
    const slopes = ratios.slice(1).map((value, k) => (value - ratios[k]) / (places[k + 1] - places[k]));
    const middles = places.slice(1).map((value, k) => (value + places[k]) / 2);
    const changes = middles.map(
      (place, k) => interpolate(place + 0.1 * Math.log(10), middles, slopes) - slopes[k],
    );
    return most(changes) / Math.max(most(slopes), TINY);
  });
}

// Linear interpolation in a table whose abscissa rises or falls; its ends beyond them.
function interpolate(x, abscissa, ordinate) {
  const falls = abscissa[0] > abscissa[abscissa.length - 1];
  const [xs, ys] = falls ? [[...abscissa].reverse(), [...ordinate].reverse()] : [abscissa, ordinate];
  const right = xs.findIndex((each) => each >= x);
  if (right <= 0) return right < 0 ? ys[ys.length - 1] : ys[0];
  const share = (x - xs[right - 1]) / (xs[right] - xs[right - 1]);
  return ys[right - 1] + share * (ys[right] - ys[right - 1]);
}

// Abscissa and quantity of some curves, where the statement speaks of them.
function table(claim, evidence, group, quantity = claim.quantity) {
  const curves = group.map(evidence.curve);
  const bounded = claim.references.length ? curves.slice(1) : curves;
  let x = loadsOf(claim, curves, bounded, evidence.model);
  const against = claim.against || "load";
  if (against !== "load") {
    const spans = curves.map((curve) => curve[against]);
    const [low, high] = [most(spans.map(least)), least(spans.map(most))];
    x = curves[curves.length - 1].at(against, x);
    x = x.map((value) => Math.min(Math.max(value, low), high));
  }
  return [x, curves.map((curve) => curve.at(quantity, x, against))];
}

// The loads that a statement speaks of: the one that it names, or all within its bounds.
function loadsOf(claim, curves, bounded, model) {
  const limits = claim.conditions;
  const grid = curves[curves.length - 1];
  if ("load" in limits) return [limits.load];
  const named = CURVE_QUANTITIES.find((name) => name in limits);
  if (named) {
    const excess = log(grid[named]).map((value) => value - Math.log(limits[named]));
    return [firstFall(grid.load, excess)];
  }
  const ends = curves.map((curve) => [curve.load[0], curve.load[curve.load.length - 1]]);
  const heaviest = (limits.load_max_N ?? Infinity) / model.newtonsPerLoad;
  const low = Math.max(limits.load_min ?? 0, ...ends.map(([first]) => first));
  const high = Math.min(limits.load_max ?? heaviest, ...ends.map(([, last]) => last));
  if (!(low < high)) throw new NotReached(Math.log(low / high));
  const loads = [low, ...grid.load.filter((load) => load > low && load < high), high];
  const shortfalls = CURVE_QUANTITIES.flatMap((name) =>
    [["_min", 1], ["_max", -1]].flatMap(([end, sign]) =>
      `${name}${end}` in limits && name !== "load"
        ? bounded.map((curve) =>
            curve.at(name, loads).map((value) => sign * (limits[`${name}${end}`] - value)),
          )
        : [],
    ),
  );
  if (!shortfalls.length) return loads;
  const shortfall = loads.map((_, i) => most(shortfalls.map((row) => row[i])));
  if (least(shortfall) > 0) throw new NotReached(least(shortfall));
  return loads.filter((_, i) => !(shortfall[i] > 0));
}

// Where values first fall to zero; continued by their last slope, for a decade at most.
function firstFall(loads, values) {
  if (!(values[0] > 0)) return values[0] <= 0 ? loads[0] : NaN;
  const fallen = values.findIndex((value) => !(value > 0));
  const right = fallen < 0 ? values.length - 1 : fallen;
  const step = Math.log(loads[right] / loads[right - 1]);
  const fall = Math.max(values[right - 1] - values[right], TINY);
  const advance = Math.min(values[right - 1] / fall, Math.log(10) / Math.abs(step));
  return loads[right - 1] * Math.exp(advance * step);
}

// --- by how much a course of values misses what its name says ---

const lowestYet = (values) => {
  let low = Infinity;
  return values.map((value) => (low = Math.min(low, value)));
};
const highestYet = (values) => lowestYet(values.map((value) => -value)).map((value) => -value);

function riseMiss(values, step) {
  const relapse = most(difference(highestYet(values), values));
  return most([relapse, 2 * step - (values[values.length - 1] - values[0])]);
}

function peakHeight(values) {
  const left = difference(values, lowestYet(values));
  const right = difference(values, lowestYet([...values].reverse()).reverse());
  return most(left.map((value, i) => Math.min(value, right[i])));
}

function peakMiss(values, step) {
  const free = values.filter((v) => Math.abs(v) > SATURATED && Math.abs(v) < 1 - SATURATED);
  const odds = free.map((v) => Math.sign(v) * Math.log(Math.abs(v) / (1 - Math.abs(v))));
  let lack = -Math.log(SATURATED);
  if (odds.length > 2) {
    const changes = odds.slice(1).map((value, i) => (value - odds[i]) * odds.length);
    const climb = highestYet(changes);
    const drop = highestYet(changes.map((value) => -value).reverse()).reverse();
    const turns = changes.slice(1).map((_, i) => Math.min(climb[i], drop[i + 1]));
    lack = Math.max(-most(turns), 0);
  }
  return (2 + lack) * step - peakHeight(values);
}

const opposite = (values) => values.map((value) => -value);
const COURSES = {
  increasing: riseMiss,
  decreasing: (values, step) => riseMiss(opposite(values), step),
  constant: (values) => most(values) - least(values),
  rising_then_falling: peakMiss,
  falling_then_rising: (values, step) => peakMiss(opposite(values), step),
  increasing_at_each_step: (values, step) =>
    2 * step - least(values.slice(1).map((value, i) => value - values[i])),
  absence: peakHeight,
};

// How far a curve leaves the published states, passed in turn: points are divided among the steps in
// turn, and the division with the least miss counts.  Each step must also be met by a point.
function sequenceMiss(claim, curve) {
  const excursions = claim.published.map((step) => excursion(curve, step));
  if (excursions.flat().some(Number.isNaN)) return NaN;
  const required = claim.open_end ? excursions.slice(0, -1) : excursions;
  const unmet = Math.max(most(required.map(least)) + claim.tolerance, 0);
  let enter = -Infinity;
  const reached = claim.published.map(() => Infinity);
  for (let point = 0; point < curve.load.length; point++) {
    let come = enter;
    for (let step = 0; step < reached.length; step++) {
      const stay = reached[step];
      reached[step] = Math.max(Math.min(stay, come), excursions[step][point], 0);
      come = stay;
    }
    enter = Infinity;
  }
  return Math.max(least(claim.open_end ? reached.slice(-2) : reached.slice(-1)), unmet);
}

function excursion(curve, step) {
  const alternatives = step.split(" or ").map((alternative) =>
    curve.load.map((_, i) =>
      most(
        alternative.split(" ").flatMap((name) => {
          const [quantity, low, high] = STATES[name];
          return [low - curve[quantity][i], curve[quantity][i] - high];
        }),
      ),
    ),
  );
  return curve.load.map((_, i) => least(alternatives.map((row) => row[i])));
}

// The states that a curve passes: regimes, modes or both, as the statement names them.
function visited(claim, curve) {
  const named = claim.published.flatMap((step) => step.replaceAll(" or ", " ").split(" "));
  const families = new Set(named.map((name) => STATES[name][0]));
  const asked = Object.entries(STATES).filter(([, [quantity]]) => families.has(quantity));
  const passed = curve.load.map((_, i) =>
    asked
      .filter(([, [quantity, low, high]]) => curve[quantity][i] > low && curve[quantity][i] <= high)
      .map(([name]) => name)
      .join(" "),
  );
  return passed.filter((state, i) => i === 0 || state !== passed[i - 1]).join(" > ").trim();
}

// Numbers as text; a load beyond those computed is shown as `> last` or `< first`.
function shown(claim, evidence, values) {
  const isLoad = ["load", "bend_load", BETWEEN_CURVES[0]].includes(claim.quantity);
  const loads = evidence.curve(claim.curves[0]).load;
  const [first, last] = [loads[0], loads[loads.length - 1]];
  return values
    .map((value) => {
      if (isLoad && value >= last) return `> ${significant(last, 4)}`;
      if (isLoad && value <= first) return `< ${significant(first, 4)}`;
      return significant(value, 4);
    })
    .join(", ");
}
