// A cut through the interface, true to scale: both surfaces, particles and film at the solved separation.

import { currentInputs, currentPoint } from "./state.js";
import { currentEngine } from "./engine.js";
import { widthIn } from "./chart.js";
import { MODE_TEXT, REGIME_TEXT, conditionWords, valueText } from "./names.js";

const SEED = 0.20240507; // the day on which the paper appeared
const POINTS = 700;
const LENGTH = 10e-6; // of the cut [m]
const STEP = LENGTH / (POINTS - 1);
const MOST = 60; // particles drawn
const TOUCHING = 210; // the point at which summits touch, in modes where they do
const MARGIN = 0.35e-6; // of the solids above and below the surfaces [m]

// numbers drawn by chance, always the same
const uniformOf = (place) => d3.randomLcg(SEED + place);
const normalOf = (place) => d3.randomNormal.source(uniformOf(place))(0, 1);

// A Gaussian profile of unit variance with the autocorrelation exp(-x^2/2 length^2).
function profile(length, normal) {
  const reach = Math.min(Math.floor((3 * length) / STEP), 400);
  const kernel = d3.range(-reach, reach + 1).map((k) => Math.exp(-(((k * STEP) / length) ** 2)));
  const norm = Math.sqrt(d3.sum(kernel, (k) => k * k));
  const noise = Array.from({ length: POINTS + 2 * reach }, normal);
  return d3.range(POINTS).map((i) => d3.sum(kernel, (k, n) => k * noise[i + n]) / norm);
}

// What is added to the lower surface and taken from the upper one where summits are to touch: a
// Gaussian process that passes a given height is a draw and its regression on the difference there;
// above a high level d it rises by sigma^2/d on average.
function riseAt(drawn, d, roughness, length) {
  const missing = Math.max(d + roughness ** 2 / Math.max(d, roughness) - drawn, 0);
  return (i) => 0.5 * missing * Math.exp(-0.5 * (((i - TOUCHING) * STEP) / length) ** 2);
}

// A size drawn from the distribution of the particles.
function sizeOf(inputs, diameter, normal) {
  const mean = inputs.size_distribution === "uncentred" ? 0 : inputs.mean_ratio;
  for (let trial = 0; trial < 500; trial++) {
    const alpha = normal();
    const size = mean + inputs.spread_ratio * alpha;
    if (size > 0 && alpha < inputs.truncation) return size * diameter;
  }
  return diameter;
}

// The state at the chosen conditions, heights of both surfaces, and particles at rest or held.
function sectionOf() {
  const [engine, inputs, point] = [currentEngine(), currentInputs(), currentPoint()];
  const found = engine.state(point);
  if (Number.isNaN(found.separation)) return { found, point };
  const { load, ...condition } = point;
  const { surface, twoBody } = engine.contact(condition);
  // Nayak (1971): such a surface has 1/(2 pi sqrt(3) l^2) summits per area
  const length = 1 / Math.sqrt(2 * Math.PI * Math.sqrt(3) * surface.density);
  const normal = normalOf(0);
  const sigma = point.roughness / Math.SQRT2; // both surfaces are equally rough
  const [low, high] = [profile(length, normal), profile(length, normal)];
  const d = found.separation;
  const meets = found.mode < 3; // in particle-surface mode the cut meets no summits
  const rise = meets ? riseAt(sigma * (low[TOUCHING] - high[TOUCHING]), d, point.roughness, length) : () => 0;
  const lower = low.map((value, i) => sigma * value + rise(i));
  const upper = high.map((value, i) => sigma * value + d - rise(i));
  const touches = lower.map((value, i) => value > upper[i]);
  touches.forEach((isTouching, i) => {
    if (isTouching) lower[i] = upper[i] = 0.5 * (lower[i] + upper[i]);
  });
  const count = twoBody ? 0 : Math.min(Math.round(LENGTH * Math.sqrt(point.particle_density)), MOST);
  const [random, drawn] = [uniformOf(0.1), normalOf(0.2)];
  const plane = inputs.particle_plane === "summit" ? surface.offset : 0;
  const depth = inputs.elastic_limits === "printed" ? inputs.elastic_depth_ratio * point.particle_diameter : 0;
  const particles = d3.range(count).map((i) => {
    const place = ((i + 0.15 + 0.7 * random()) / count) * LENGTH;
    return settled(place, sizeOf(inputs, point.particle_diameter, drawn), lower, upper, plane + depth);
  });
  return { found, point, lower, upper, touches, particles };
}

// A particle at rest on the lower surface, or held where the gap is narrower. It carries load where the
// gap exceeds it by no more than the reach of the elastic zone.
function settled(place, diameter, lower, upper, reach) {
  const radius = 0.5 * diameter;
  const away = (i) => Math.abs(i * STEP - place);
  const near = d3.range(POINTS).filter((i) => away(i) < Math.max(radius, STEP));
  const half = (i) => Math.sqrt(Math.max(radius ** 2 - away(i) ** 2, 0));
  const rests = d3.max(near, (i) => lower[i] + half(i));
  const hangs = d3.min(near, (i) => upper[i] - half(i));
  return { place, radius, height: Math.min(rests, 0.5 * (rests + hangs)), carries: rests + reach > hangs };
}

// Draw the cut; returns what it shows in words.
export function drawSection(parent) {
  const { found, point, lower, upper, touches, particles } = sectionOf();
  if (!lower) {
    parent.replaceChildren();
    return "No separation balances the load at these conditions.";
  }
  const figure = d3.select(parent).html("").append("figure");
  figure.append("figcaption").text("The interface cut across, true to scale");
  const svg = figure.append("svg").attr("class", "chart section").attr("xmlns", "http://www.w3.org/2000/svg").attr("role", "img");
  const width = widthIn(parent);
  const scale = width / LENGTH;
  const [top, ground] = [d3.max(upper) + MARGIN, d3.min(lower) - MARGIN];
  const depth = (top - ground) * scale;
  const [x, y] = [(i) => i * STEP * scale, (value) => (top - value) * scale];
  const carrying = particles.filter((particle) => particle.carries).length;
  const contacts = touches.filter((isTouching, i) => isTouching && !touches[i - 1]).length;
  const words =
    `${conditionWords(point, "load").join(", ")} under ${valueText("load", point.load)}: ${MODE_TEXT[found.mode]} mode, ` +
    `${REGIME_TEXT[found.regime]} lubrication, separation ${valueText("separation", found.separation)}; this cut meets ` +
    `${contacts} contact${contacts === 1 ? "" : "s"} of summits, and ${carrying} of ${particles.length} particles carry load.`;
  const between = (from, to) => d3.area((_, i) => x(i), (_, i) => y(from(i)), (_, i) => y(to(i))).digits(1)(lower);
  const [low, high] = [(i) => lower[i], (i) => upper[i]];
  const balls = particles.map(({ place, radius, height, carries }) => {
    const fill = carries ? "var(--fails)" : "var(--paper)";
    return `<circle cx="${place * scale}" cy="${y(height)}" r="${radius * scale}" fill="${fill}" stroke="var(--ink)"/>`;
  });
  const touching = d3.line((_, i) => x(i), y).defined((_, i) => touches[i])(lower) ?? "";
  const planes = [0, found.separation].map((level) => `<line x2="${width}" y1="${y(level)}" y2="${y(level)}"/>`);
  const micron = 1e-6 * scale;
  svg.attr("viewBox", `0 0 ${width} ${depth + 34}`).attr("width", width).attr("height", depth + 34).attr("aria-label", words);
  svg.html(`<title>${words}</title>
    <path d="${between(low, high)}" fill="${point.viscosity > 0 ? "var(--oil)" : "var(--paper)"}"/>
    <path d="${between(() => ground, low)}${between(high, () => top)}" fill="var(--solid)"/>
    ${balls.join("")}
    <path class="touch" d="${touching}"/>
    ${planes.join("")}
    <g transform="translate(10,${depth + 14})"><path d="M0,-4V4M0,0H${micron}M${micron},-4V4"/>
      <text x="${micron + 6}" dy="0.32em">1 µm both ways; dashed: mean planes</text></g>`);
  return words;
}

export const SECTION_KEY = [
  { text: "surfaces", fill: "var(--solid)" },
  { text: "film", fill: "var(--oil)" },
  { text: "particle that carries load", fill: "var(--fails)" },
  { text: "particle that carries none", fill: "var(--paper)" },
  { text: "contact of summits", color: "var(--holds)" },
];
