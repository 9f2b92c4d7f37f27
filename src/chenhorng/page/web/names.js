// Names, units and usual scales of conditions and variables. They come from the library; charts add what only they
// need.

import { axes, content } from "./content.js";
import { LIMITS } from "./model.js";
import { lettered, readable } from "./text.js";

const FRACTION = { fraction: true };
const MODES = { limits: [LIMITS.surface, LIMITS.particle], zones: ["s-s", "hybrid", "p-s"], shaded: "hybrid mode" };
const REGIMES = {
  limits: [LIMITS.full_film, LIMITS.boundary],
  ...{ zones: ["F.L.", "M.L.", "B.L."], shaded: "mixed lubrication (M.L.)" },
};

const DRAWN = {
  particle_contact_area_ratio: { ...FRACTION, ...MODES },
  surface_contact_area_ratio: FRACTION,
  solid_load_fraction: { ...FRACTION, ...REGIMES },
  fluid_load_fraction: FRACTION,
  turning_point_ratio: { ...FRACTION, ...MODES, shaded: undefined }, // tolerances are shaded there
  particle_density: { log: true },
};
const NOMINAL = {
  nominal_area: { symbol: "A_n", words: "Nominal area, an input", unit: "mm²", factor: 1e6 },
  nominal_pressure: { symbol: "F_t/A_n", words: "Nominal pressure", unit: "MPa", factor: 1e-6 },
  hertz_area: { symbol: "A_H", words: "Hertz area of the smooth ball", unit: "mm²", factor: 1e6 },
  hertz_pressure: { symbol: "F_t/A_H", words: "Mean Hertz pressure", unit: "MPa", factor: 1e-6 },
};

// Every variable that is shown has a symbol, words, a scale and a unit. In this unit a value is `factor` times that
// in SI.
const entries = Object.entries(content.variables).map(([name, given]) => {
  const symbol = lettered(given.symbol);
  return [name, { ...given, symbol, ...DRAWN[name] }];
});
export const VARIABLES = { ...Object.fromEntries(entries), ...NOMINAL };

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
// a capital letter at the beginning of a word, not of a symbol
export const capital = (text) => text.replace(/^[a-z](?![a-z]*_)/, (letter) => letter.toUpperCase());
export const inputWords = (name) => capital(content.inputs[name].description);
