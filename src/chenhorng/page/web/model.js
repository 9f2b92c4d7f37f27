// The equations of Chen & Horng (2024), doi:10.3389/fmech.2024.1390335, at a given separation d, and
// `solve`, which finds d for a given load. All of the page's numbers come from here.
//
// For given particles and surface, d gives everything: the load F_s of the solids and the contact areas
// (Eqs. 2-6), and the load F_f of the film by Eq. 7, solved for it. SI units; loads are over A_n E_ss,
// areas over A_n. `inputs` has the names of config/inputs.yaml, `condition` has viscosity,
// particle_diameter, roughness, particle_density.

import { content } from "./content.js";

const NODES = content.quadrature; // nodes and weights on the interval from 0 to 1
const NEGLIGIBLE = 40; // exp(-40) of the largest weight is nothing in float64
const FARTHEST = 60; // t from which on summits carry nothing in float64
const NEAREST = -8; // t of surfaces that cut across each other's mean planes
const LOWEST = -9; // alpha below which sizes add nothing to a moment in float64
const SUMMIT_STEP = 1 / 32; // of tables in t, for errors below 1e-9
const SIZE_STEP = 1 / 256; // of tables in alpha
const ROOT_TOLERANCE = 1e-13; // of d
const ROUNDED = 1e-8; // of a load, between that of a film and that in the film's formula
const THICKEST = 0.01; // H_c of what is still a film between two bodies
const FILM_COUNTS = 1e-3; // L_f below which the film does not matter

export const LIMITS = { boundary: 0.9, full_film: 0.03, particle: 0.95, surface: 0.05 };

// A function that keeps its results, up to `most` of them.
export function remembered(find, most = 600) {
  const kept = new Map();
  return (asked) => {
    const key = JSON.stringify(asked);
    if (!kept.has(key)) {
      if (kept.size >= most) kept.clear();
      kept.set(key, find(asked));
    }
    return kept.get(key);
  };
}

// Smooth functions as cubic pieces between nodes from `first` to `last`. A node is computed when it is first needed.
// `exact(x)` gives value and slope of each function. The result gives the value of the function at place `which`.
function tabulated(exact, { step, first, last }) {
  const nodes = Array(Math.ceil((last - first) / step) + 2);
  const node = (index) => (nodes[index] ??= exact(first + index * step));
  return (x, which = 0) => {
    const place = (x - first) / step;
    const index = Math.floor(place);
    const [low, high] = [node(index), node(index + 1)];
    const [value, slope] = [low[which], step * low[which + 1]];
    const rise = high[which] - value;
    const u = place - index;
    const bend = (slope - rise) * (1 - u) + (rise - step * high[which + 1]) * u;
    return value + u * (rise + (1 - u) * bend);
  };
}

// The factor of elastic particles in Eqs. 4 and 5.
function elasticFactor(inputs) {
  const lower = inputs.hardness_surface_1 / inputs.elastic_modulus_particle;
  const upper = inputs.hardness_surface_2 / inputs.elastic_modulus_surfaces;
  return 2.25 * Math.PI ** 2 * (lower ** 2 + upper ** 2);
}

// Whether elastic particles carry no more than plastic ones, so that one separation balances a load.
export const areHard = (inputs) => elasticFactor(inputs) <= 1;

function surfaceOf(inputs, roughness) {
  const scale = roughness / inputs.reference_roughness;
  const parameter = inputs.summit_parameter * scale ** inputs.summit_parameter_exponent;
  const radius = inputs.summit_radius * scale ** inputs.summit_radius_exponent;
  const density = parameter / (radius * roughness);
  const deviation = inputs.summit_deviation_ratio * roughness;
  const offset = inputs.summit_offset_ratio * scale ** -inputs.summit_parameter_exponent * roughness; // as McCool
  return { roughness, density, radius, deviation, offset };
}

// ln F_ss* and ln(A_ss/A_n) over t = (d - y_s)/sigma_s: eta_s times the integrals of Eq. 6 (left) over
// all heights above d, of the asperity of Zhao, Maietta & Chang (2000) at the interference w sigma_s,
// which yields first at w1 and is fully plastic from w2 on. The largest weight of a summit is left
// out of the integrals and enters as a logarithm.
function summitsOf(inputs, surface) {
  const softer = Math.min(inputs.hardness_surface_1, inputs.hardness_surface_2);
  const hardness = softer / inputs.elastic_modulus_surfaces;
  const radius = surface.radius / surface.deviation;
  const k = inputs.yield_pressure_ratio;
  const w1 = (0.75 * Math.PI * k * hardness) ** 2 * radius;
  const w2 = w1 * inputs.plastic_interference_ratio;
  const density = (surface.density * surface.deviation ** 2) / Math.sqrt(2 * Math.PI);
  return summitTable({ hardness, radius, k, w1, w2, density });
}

const summitTable = remembered(({ hardness, radius, k, w1, w2, density }) => {
  const area = (w) => {
    const u = Math.min(Math.max((w - w1) / (w2 - w1), 0), 1);
    return Math.PI * radius * w * (1 - 2 * u ** 3 + 3 * u ** 2);
  };
  const load = (w, itsArea) => {
    if (w <= w1) return (4 / 3) * Math.sqrt(radius) * w ** 1.5;
    if (w >= w2) return itsArea * hardness;
    return itsArea * hardness * (1 - (1 - k) * (Math.log(w2 / w) / Math.log(w2 / w1)));
  };

  function exact(t) {
    const root = Math.sqrt(2 * NEGLIGIBLE);
    const reach = t > 0 ? (2 * NEGLIGIBLE) / (t + Math.hypot(t, root)) : root - t;
    let [loads, areas, fartherLoads, fartherAreas] = [0, 0, 0, 0];
    const edges = [0, w1, w2, Infinity].map((edge) => Math.sqrt(Math.min(edge, reach)));
    for (const [start, end] of d3.pairs(edges)) {
      for (const [node, weight] of end > start ? NODES : []) {
        const r = start + (end - start) * node; // w = r^2 makes the power of 3/2 smooth
        const w = r * r;
        const phi = Math.exp(-w * (t + 0.5 * w) - 0.5 * Math.min(t, 0) ** 2);
        const itsArea = area(w);
        const measure = phi * 2 * r * weight * (end - start);
        loads += load(w, itsArea) * measure;
        areas += itsArea * measure;
        fartherLoads += load(w, itsArea) * measure * w;
        fartherAreas += itsArea * measure * w;
      }
    }
    const log = (sum) => Math.log(density * sum) - 0.5 * Math.max(t, 0) ** 2;
    return [log(loads), -t - fartherLoads / loads, log(areas), -t - fartherAreas / areas];
  }
  return tabulated(exact, { step: SUMMIT_STEP, first: NEAREST, last: FARTHEST });
}, 200);

// phi_a of Eq. 6, over x_a: m and S, and the least alpha = (x - m)/S.
function sizesOf({ mean_ratio: mean, spread_ratio: spread }) {
  return { mean, spread, least: Math.max(-mean / spread, LOWEST) };
}

const normal = (alpha) => Math.exp(-0.5 * alpha ** 2) / Math.sqrt(2 * Math.PI);
const integral = (f, low, high) => (high - low) * d3.sum(NODES, ([node, weight]) => weight * f(low + (high - low) * node));

// I(x, X_max)/x_a^2 over alpha: the integral of x^2 phi_a in Eqs. 4 and 5.
function momentTable({ truncation: most }, { mean, spread, least }) {
  const density = (alpha) => (mean + spread * alpha) ** 2 * normal(alpha);
  const moment = (alpha) => integral(density, alpha, most);
  // counted from the largest size, where it vanishes and needs its digits
  const exact = (below) => [moment(most - below), density(most - below)];
  const table = tabulated(exact, { step: SIZE_STEP, first: 0, last: most - least });
  const all = moment(least);
  return (alpha) => (alpha >= most ? 0 : alpha <= least ? all : table(most - alpha));
}

// Mean of alpha over all particles, whose sizes are m + alpha x_a spread_ratio.
const meanOf = ({ truncation: most }, { least }) => (normal(least) - normal(most)) / integral(normal, least, most);

// Eq. 7: H_c = smooth film and what roughness adds, each as logarithm over ln W (Eq. 8).
function filmOf(inputs, viscosity, roughness) {
  const kappa = inputs.ellipticity;
  const lnU = Math.log(inputs.speed_per_viscosity * viscosity);
  const lnG = Math.log(inputs.material_parameter);
  const a = -0.045 * kappa ** 0.18;
  const b = a - 0.133;
  const rise = 0.663 * kappa ** 0.025;
  // all but W of the smooth film, and of what roughness adds
  const shape = Math.log(3.672 * (1 - 0.573 * Math.exp(-0.74 * kappa)));
  const smooth = shape + rise * lnU + 0.502 * kappa ** 0.064 * lnG;
  const asperities = 1.248 * Math.log(roughness / inputs.ball_radius) + 0.119 * Math.log(inputs.hardness_parameter);
  const rough = smooth + Math.log(0.025 * kappa ** 0.081) + asperities - 0.884 * lnU - 0.977 * lnG;
  const thickness = (lnW) => Math.exp(smooth + a * lnW) + Math.exp(rough + b * lnW);
  const softer = Math.min(inputs.hardness_surface_1, inputs.hardness_surface_2);
  const pressed = (softer * inputs.apparent_area) / inputs.elastic_modulus_surfaces;
  const greatest = Math.log(pressed / inputs.ball_radius ** 2); // ln W
  return {
    thickness,
    // ln W under which the film is as thick as H_c
    loadParameter(target) {
      const y = Math.log(target);
      let lnW = Math.max((y - smooth) / a, (y - rough) / b); // where one term has the value alone
      for (let step = 0; step < 7; step++) {
        const [first, second] = [Math.exp(smooth + a * lnW), Math.exp(rough + b * lnW)];
        lnW -= ((Math.log(first + second) - y) * (first + second)) / (a * first + b * second); // Newton
      }
      return lnW;
    },
    // whether H_c rises with viscosity, as that of any oil does: dH_c/dU > 0; and the softer surface is as
    // hard as the mean pressure of the load
    isMeaningful: (lnW) => lnW > (Math.log(rise / (0.884 - rise)) + smooth - rough) / -0.133 && lnW <= greatest,
  };
}

// W of Eq. 8 has the load of the film, or the total load as printed. `total` is F_t* at a separation where
// solids carry one load and the film in W another (Eq. 1). `fractions` are L_s and L_f (Eq. 9). `inW` is the
// load in W.
const FILM_LOADS = {
  fluid: {
    total: (solid, film) => solid + film,
    fractions: (solid, film) => [solid / (solid + film), film / (solid + film)],
    inW: (load, fraction) => load * fraction,
  },
  total: {
    total: (solid, film) => Math.max(solid, film),
    // a film that is thinner than that of the load carries nothing
    fractions: (solid, film, load) => (film > (1 - ROUNDED) * load ? [solid / load, 1 - solid / load] : [1, 0]),
    inW: (load) => load,
  },
};

// The model under some inputs; what conditions have in common is computed once.
export function modelOf(inputs) {
  const sizes = sizesOf(inputs);
  const moment = momentTable(inputs, sizes);
  const meanSize = meanOf(inputs, sizes);
  const factor = elasticFactor(inputs);
  const wRatio = inputs.apparent_area / inputs.ball_radius ** 2; // W/F*
  const hardness = inputs.hardness_surface_1 + inputs.hardness_surface_2;
  const pressure = inputs.hardness_surface_1 / inputs.elastic_modulus_surfaces; // F_sa/A_sa
  const filmLoad = FILM_LOADS[inputs.film_load];

  // The interface of a condition: `at` gives the state at a separation d, `solve` finds d for a load.
  function contact({ viscosity, particle_diameter: diameter, roughness, particle_density: density }) {
    const surface = surfaceOf(inputs, roughness);
    const summits = summitsOf(inputs, surface);
    const twoBody = !(diameter ** 2 * density > 0);
    const film = viscosity > 0 ? filmOf(inputs, viscosity, roughness) : null;
    const [mean, spread] = [sizes.mean * diameter, sizes.spread * diameter];
    const plane = mean + (inputs.particle_plane === "summit" ? surface.offset : 0);
    const depth = (inputs.elastic_depth_ratio * diameter) / spread; // h_e/S
    const covering = ((Math.PI * inputs.participation) / hardness) * density * diameter ** 2;
    const bare = Math.max(1 - covering * inputs.hardness_surface_1 * moment(-Infinity), 0); // in Eq. 4
    const isCovered = bare <= Number.EPSILON;
    const reach = twoBody ? 0 : plane + (inputs.truncation + depth) * spread;

    function solids(d) {
      const t = (d - surface.offset) / surface.deviation;
      const summitLoad = t < FARTHEST ? Math.exp(summits(t, 0)) : 0;
      const summitArea = t < FARTHEST ? Math.exp(summits(t, 2)) : 0;
      if (twoBody) return { load: summitLoad, particles: 0, summits: summitArea };
      const alpha = (d - plane) / spread;
      const plastic = moment(alpha); // I(d, X_max)
      const touching = (1 - factor) * plastic + factor * moment(alpha - depth);
      const particles = covering * inputs.hardness_surface_2 * touching;
      const covered = covering * inputs.hardness_surface_1 * plastic;
      return {
        load: summitLoad * bare + pressure * particles, // Eqs. 2 and 4
        particles, // A_sa of Eq. 5
        summits: summitArea * Math.max(1 - covered, 0), // A_ss-sa of Eq. 5
      };
    }

    // F_f* under which the film is d thick (Eqs. 7 and 8)
    const filmLoadAt = (d) => Math.exp(film.loadParameter(d / inputs.ball_radius)) / wRatio;

    // Total load F_t* at which the surfaces are d apart (Eq. 1)
    function loadAt(d) {
      const solid = solids(d).load;
      return film ? filmLoad.total(solid, filmLoadAt(d)) : solid;
    }

    // All variables at a separation d that balances the load F_t*.
    function state(d, load) {
      const solid = solids(d);
      const total = solid.particles + solid.summits; // Eq. 3
      const fractions = film ? filmLoad.fractions(solid.load, filmLoadAt(d), load) : [1, 0];
      const ratio = twoBody ? 0 : solid.particles / total;
      const found = {
        load,
        normal_load: load * inputs.apparent_area * inputs.elastic_modulus_surfaces,
        total_contact_area: total,
        particle_contact_area_ratio: ratio, // Eq. 10
        surface_contact_area_ratio: solid.summits / total, // Eq. 10
        solid_load_fraction: fractions[0], // Eq. 9
        fluid_load_fraction: fractions[1],
        separation: d,
        film_thickness: d / inputs.ball_radius, // Eq. 7
        regime: fractions[0] > LIMITS.boundary ? 0 : fractions[0] < LIMITS.full_film ? 2 : 1,
        mode: twoBody ? 0 : ratio > LIMITS.particle ? 3 : ratio < LIMITS.surface ? 1 : 2,
      };
      found.status = statusOf(found);
      return found.status === "coverage_exceeded" ? nothing(load, found.status) : found;
    }

    function statusOf(found) {
      if (isCovered) return "coverage_exceeded";
      if (found.total_contact_area > 1) return "area_exceeded";
      if (film && found.fluid_load_fraction > FILM_COUNTS) {
        const lnW = Math.log(filmLoad.inW(found.load, found.fluid_load_fraction) * wRatio);
        if (found.film_thickness > THICKEST || !film.isMeaningful(lnW)) return "outside_film_formula";
      }
      return "converged";
    }

    // The state under a load F_t*, searched for between `near` and `far` first, where these are given.
    function solve(load, far, near) {
      if (isCovered) return nothing(load, "coverage_exceeded");
      let low = film ? inputs.ball_radius * film.thickness(Math.log(load * wRatio)) : 0;
      const excess = (d) => Math.log(loadAt(d) / load);
      if (!film && excess(0) < 0) return nothing(load, "load_exceeded");
      const held = film && inputs.film_load === "total" && solids(low).load < load;
      if (held || excess(low) <= 0) return state(low, load); // the film carries all
      let high = far > low ? far : Math.max(2 * low, surface.deviation);
      if (near > low && near < high && excess(near) > 0) low = near;
      while (excess(high) > 0) {
        low = high;
        high *= 1.5;
      }
      return state(rootOf(excess, low, high), load);
    }

    const ownSizes = { mean: mean + meanSize * spread, largest: mean + inputs.truncation * spread }; // [m]
    return { at: state, loadAt, solids, solve, twoBody, surface, reach, sizes: ownSizes };
  }

  return { inputs, contact, newtonsPerLoad: inputs.apparent_area * inputs.elastic_modulus_surfaces };
}

const NO_VALUES = Object.fromEntries(content.quantities.map((name) => [name, NaN]));
const nothing = (load, status) => ({ ...NO_VALUES, load, regime: -1, mode: -1, status });

// Where a function changes its sign between two places: Chandrupatla (1997), Adv. Eng. Softw. 28:145.
function rootOf(f, low, high) {
  let [a, b, c] = [low, high, high];
  let [fa, fb] = [f(a), f(b)];
  let fc = fb;
  let part = 0.5;
  for (let step = 0; step < 200 && fa !== 0 && fb !== 0; step++) {
    const trial = a + part * (b - a);
    const value = f(trial);
    const isSame = value > 0 === fa > 0;
    [b, fb, c, fc] = isSame ? [b, fb, a, fa] : [a, fa, b, fb];
    [a, fa] = [trial, value];
    const best = Math.abs(fa) < Math.abs(fb) ? a : b;
    const least = (ROOT_TOLERANCE * Math.abs(best)) / Math.abs(b - a);
    if (least > 0.5) return best;
    const place = (a - b) / (c - b);
    const level = (fa - fb) / (fc - fb);
    const bends = level * level < place && (1 - level) ** 2 < 1 - place;
    const ahead = (fa / (fb - fa)) * (fc / (fb - fc)) + ((c - a) / (b - a)) * (fa / (fc - fa)) * (fb / (fc - fb));
    part = bends ? Math.min(Math.max(ahead, least), 1 - least) : 0.5;
  }
  return fa === 0 ? a : b;
}
