// What conditions and variables are called, their units as shown, and their usual scales.

import { axes, axisNamed, conditionAxes, content, toUnit } from "./state.js";
import { LIMITS, NO_SUMMITS } from "./model.js";
import { readable } from "./text.js";

const UNITS = { "m-2": "m⁻²" };
export const unitOf = (name) => UNITS[axisNamed(name).unit] ?? axisNamed(name).unit;

const WORDS = {
  load: "Normal load",
  viscosity: "Oil viscosity",
  particle_diameter: "Particle size",
  roughness: "Roughness",
  particle_density: "Particle density",
};
const LETTERS = { ...Object.fromEntries(axes.map(({ name, sign }) => [name, sign])), load: "Fₜ" };
export const wordOf = (name) => WORDS[name];
export const letterOf = (name) => LETTERS[name];

// a value of a condition [SI; the load in newtons] with its unit
export const valueText = (name, value) =>
  name === "viscosity" && value === 0 ? "dry" : `${readable(toUnit(name, value), 4)} ${unitOf(name)}`;

// the same with its letter: "ν = 90 cSt", or "dry"
export const conditionWord = (name, value) =>
  name === "viscosity" && value === 0 ? "dry" : `${letterOf(name)} = ${valueText(name, value)}`;

export const conditionText = (condition, without = []) =>
  conditionAxes
    .filter(({ name }) => !without.includes(name))
    .map(({ name }) => conditionWord(name, condition[name]))
    .join(", ");

const FRACTION = { fraction: true, log: false };
const MODES = { limits: [LIMITS.surface, LIMITS.particle], zones: ["s-s", "hybrid", "p-s"] };
const REGIMES = { limits: [LIMITS.full_film, LIMITS.boundary], zones: ["full film", "mixed", "boundary"] };

// Every variable that an axis of a chart can show: its symbol, its words, its unit and its scale.
export const VARIABLES = {
  total_contact_area: { symbol: "Aₜ*", words: "Real contact area", log: true },
  particle_contact_area_ratio: { symbol: "A_sa,t*", words: "Contact area ratio of particles", ...FRACTION, ...MODES },
  surface_contact_area_ratio: { symbol: "A_ss,t*", words: "Contact area ratio of surfaces", ...FRACTION },
  solid_load_fraction: { symbol: "L_s", words: "Load fraction of the solids", ...FRACTION, ...REGIMES, percent: true },
  fluid_load_fraction: { symbol: "L_f", words: "Load fraction of the film", ...FRACTION, percent: true },
  separation: { symbol: "d", words: "Separation", unit: "nm", factor: 1e9, log: false },
  film_thickness: { symbol: "H_c", words: "Film thickness over ball radius", unit: "10⁻⁴", factor: 1e4, log: false },
  total_contact_area_over_two_body: { symbol: "Aₜ*", words: "Area over that of dry two-body contact", log: false },
  load: { symbol: "Fₜ*", words: "Dimensionless normal load", log: true },
  normal_load: { symbol: "Fₜ", words: "Normal load", unit: "N", log: true },
  viscosity: { symbol: "ν", words: "Oil viscosity", unit: "cSt", factor: 1e6, log: false },
  particle_diameter: { symbol: "xₐ", words: "Particle size", unit: "nm", factor: 1e9, log: false },
  roughness: { symbol: "σ", words: "Roughness", unit: "nm", factor: 1e9, log: false },
  particle_density: { symbol: "ηₐ", words: "Particle density", unit: "m⁻²", log: true },
  diameter_ratio: { symbol: "xₐ/σ", words: "Particle size over roughness", log: false },
  turning_point_ratio: { symbol: "A_sa,t*", words: "Where turning points occur", ...FRACTION, ...MODES },
};

// "A_sa,t*" as parts of a text: the letter, its index, and what follows
export function symbolParts(symbol) {
  const found = symbol.match(/^(.+?)_([\w,]+)(\*?)$/);
  return found ? found.slice(1) : [symbol, "", ""];
}
export const plainSymbol = (symbol) => symbol.replace("_", "");

export function numberText(name, value) {
  const { factor = 1, unit = "", percent } = VARIABLES[name];
  if (percent) return `${readable(100 * value)} %`;
  if (unit === "10⁻⁴") return readable(value);
  return `${readable(value * factor)} ${unit}`.trim();
}

export const spaced = (word) => word.replaceAll("_", " ");
export const MODE_TEXT = ["two-body", "surface-surface", "hybrid", "particle-surface"];
export const REGIME_TEXT = ["boundary", "mixed", "full film"];
const MEANINGS = {
  ...content.statuses,
  [NO_SUMMITS]: "the summit parameter leaves no variance to the summits of this surface",
};
export const statusText = (status) => (status === "converged" ? "" : `${spaced(status)}: ${MEANINGS[status]}`);
export const inputWords = (name) => spaced(name[0].toUpperCase() + name.slice(1));
