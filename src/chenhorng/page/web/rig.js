// Materials, speed and oil: the inputs and the viscosity that follow from them, as from `thirdbody bearing`.

import { content, defaultInputs } from "./content.js";

const { materials, oils, temperature_C: temperatures, oil_viscosity_cSt: viscosities } = content.rig;
const ZERO = 273.15; // K
export const BODIES = ["ball", "flat", "particle"];
export const MATERIALS = [...new Set(materials.map(({ ball }) => ball))];
export const GRADES = Object.keys(oils);

// The inputs that follow from a combination of materials; undefined for particles softer than a surface.
export const materialInputs = (chosen) => materials.find((each) => BODIES.every((body) => each[body] === chosen[body]))?.inputs;

// The inputs that follow from materials, ball radius and, if it is given, speed; U over the viscosity is
// rho u/(E_ss R_x) (below Eq. 8).
export function rigInputs(chosen, { ball_radius: radius = defaultInputs.ball_radius }) {
  const found = { ...materialInputs(chosen) };
  const { elastic_modulus_surfaces: modulus, speed_per_viscosity: kept } = { ...defaultInputs, ...found };
  const { speed_m_per_s: speed, oil_density_kg_per_m3: density } = chosen;
  if (speed !== undefined) found.speed_per_viscosity = (density * speed) / (modulus * radius);
  else if (radius !== defaultInputs.ball_radius) found.speed_per_viscosity = (kept * defaultInputs.ball_radius) / radius;
  return found;
}

// The speed [m/s] that inputs stand for with an oil of this density [kg/m3].
export const speedOf = ({ speed_per_viscosity: ratio, elastic_modulus_surfaces: modulus, ball_radius: radius }, density) =>
  (ratio * modulus * radius) / density;

// Kinematic viscosity [cSt] of a grade at a temperature [C] by the line of ASTM D341 through that at 40 and at
// 100 C; undefined where it is no line.
export function oilViscosity(grade, temperature) {
  const [thick, thin] = oils[grade].map((viscosity) => Math.log10(Math.log10(viscosity + 0.7)));
  const distance = (other) => Math.log10((other + ZERO) / (40 + ZERO));
  const viscosity = 10 ** (10 ** (thick + ((thin - thick) * distance(temperature)) / distance(100))) - 0.7;
  const isLine = temperature >= temperatures[0] && temperature <= temperatures[1];
  return isLine && viscosity >= viscosities[0] && viscosity <= viscosities[1] ? viscosity : undefined;
}
