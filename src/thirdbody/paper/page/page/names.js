// What conditions and variables are called, their units as shown, and their usual scales.

import { axes, content } from "./content.js";
import { LIMITS } from "./model.js";
import { readable } from "./text.js";

const FRACTION = { fraction: true, log: false };
const PERCENT = { ...FRACTION, unit: "%", factor: 100 };
const MODES = { limits: [LIMITS.surface, LIMITS.particle], zones: ["s-s", "hybrid", "p-s"], shaded: "hybrid mode" };
const REGIMES = {
  limits: [LIMITS.full_film, LIMITS.boundary],
  ...{ zones: ["F.L.", "M.L.", "B.L."], shaded: "mixed lubrication (M.L.)" },
};

// Every variable that an axis of a chart can show: its symbol, its words, its scale, and its unit, in
// which it is shown as `factor` times the value in SI.
export const VARIABLES = {
  total_contact_area: { symbol: "A_t*", words: "Real contact area", log: true },
  particle_contact_area_ratio: { symbol: "A_sa,t*", words: "Contact area ratio of particles", ...FRACTION, ...MODES },
  surface_contact_area_ratio: { symbol: "A_ss,t*", words: "Contact area ratio of surfaces", ...FRACTION },
  solid_load_fraction: { symbol: "L_s", words: "Load percentage of solid", ...PERCENT, ...REGIMES },
  fluid_load_fraction: { symbol: "L_f", words: "Load percentage of fluid", ...PERCENT },
  separation: { symbol: "d", words: "Separation", unit: "nm", factor: 1e9, log: false },
  film_thickness: { symbol: "H_c", words: "Film thickness", unit: "10⁻⁴", factor: 1e4, log: false },
  total_contact_area_over_two_body: { symbol: "A_t* over dry two-body", words: "Area over that of dry two-body contact", log: false },
  load: { symbol: "F_t*", words: "Dimensionless normal load", log: true },
  normal_load: { symbol: "F_t", words: "Normal load", unit: "N", log: true },
  viscosity: { symbol: "ν", words: "Viscosity", unit: "cSt", factor: 1e6, log: false },
  particle_diameter: { symbol: "x_a", words: "Particle diameter", unit: "nm", factor: 1e9, log: false },
  roughness: { symbol: "σ", words: "Roughness", unit: "nm", factor: 1e9, log: false },
  particle_density: { symbol: "η_a", words: "Particle density", unit: "m⁻²", log: true },
  diameter_ratio: { symbol: "x_a/σ", words: "Particle diameter over roughness", log: false },
  turning_point_ratio: { symbol: "A_sa,t*", words: "Where turning points occur", ...FRACTION },
};

export const scaleFor = (name) => (VARIABLES[name].log ? d3.scaleLog() : d3.scaleLinear());

// a number, or the ends of a range, with the unit
export function withUnit(name, ...texts) {
  const { unit = "" } = VARIABLES[name];
  const range = texts.join(" to ");
  if (!unit.startsWith("10")) return `${range} ${unit}`.trim();
  return texts.length > 1 ? `(${range})×${unit}` : `${range}×${unit}`;
}

// a value, or 0 if it is negligible: in a full film hardly anything touches
export const notable = (name, value) => (Math.abs(value) < 1e-12 && content.quantities.includes(name) ? 0 : value);
export const numberText = (name, value, digits) =>
  Number.isFinite(value) ? withUnit(name, readable(notable(name, value) * (VARIABLES[name].factor ?? 1), digits)) : "–";

// The variable of a condition: the load of a point is that in newtons.
export const ofCondition = (name) => (name === "load" ? "normal_load" : name);
export const wordOf = (name) => VARIABLES[ofCondition(name)].words;
export const letterOf = (name) => VARIABLES[ofCondition(name)].symbol;
export const unitOf = (name) => VARIABLES[ofCondition(name)].unit;

// a value with its unit
export const valueText = (name, value, digits) =>
  name === "viscosity" && value === 0 ? "dry" : numberText(ofCondition(name), value, digits);

// the same with its letter: "ν = 90 cSt", or "dry"
export const conditionWord = (name, value) =>
  name === "viscosity" && value === 0 ? "dry" : `${letterOf(name)} = ${valueText(name, value)}`;

// those of a point, without some
export const conditionWords = (point, ...without) =>
  axes.filter(({ name }) => !without.includes(name)).map(({ name }) => conditionWord(name, point[name]));

export const spaced = (word) => word.replaceAll("_", " ");
export const MODE_TEXT = ["two-body", "surface-surface", "hybrid", "particle-surface"];
export const REGIME_TEXT = ["boundary", "mixed", "full film"];
export const FULL_FILM = 2; // in which hardly anything touches: it has no contact mode
export const modeText = ({ mode, regime }) => (regime === FULL_FILM ? "full film" : MODE_TEXT[mode]);
export const stateText = ({ mode, regime }) =>
  regime === FULL_FILM ? "full film" : `${MODE_TEXT[mode]} mode, ${REGIME_TEXT[regime]} lubrication`;
export const statusText = (status) => (status === "converged" ? "" : `${spaced(status)}: ${content.statuses[status]}`);
export const inputWords = (name) => spaced(name[0].toUpperCase() + name.slice(1));
