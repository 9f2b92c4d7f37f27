// A cut through the interface as in Figures 1 and 2: both surfaces, particles and film at the solved separation.

import { currentInputs, currentPoint } from "./state.js";
import { currentEngine } from "./engine.js";
import { widthIn } from "./chart.js";
import { FULL_FILM, conditionWords, numberText, stateText, valueText } from "./names.js";
import { escaped, plain } from "./text.js";

const SEED = 0.20240507; // the day on which the paper appeared
const POINTS = 500;
const LENGTH = 40e-6; // of the cut [m]
const STRETCH = 8; // of heights over lengths; particles are drawn round
const STEP = LENGTH / (POINTS - 1);
const MOST = 30; // particles drawn
const TOUCHING = 0.35; // where summits touch, as a part of the length
const RIGHT = [0.6, 0.88]; // between which parts a particle carries load, in modes in which they do
const [ABOVE, BELOW] = [0.25e-6, 0.75e-6]; // heights of the solids above and below the surfaces [m]
const BAR = 4e-6; // of the scale along the cut [m]

// A Gaussian profile of unit variance with the autocorrelation exp(-x^2/2 length^2).
function profile(length, normal) {
  const reach = Math.min(Math.floor((3 * length) / STEP), 400);
  const kernel = d3.range(-reach, reach + 1).map((k) => Math.exp(-(((k * STEP) / length) ** 2)));
  const norm = Math.sqrt(d3.sum(kernel, (k) => k * k));
  const noise = Array.from({ length: POINTS + 2 * reach }, normal);
  return d3.range(POINTS).map((i) => d3.sum(kernel, (k, n) => k * noise[i + n]) / norm);
}

// Heights of both surfaces. Where summits touch, a Gaussian process that passes a given height is a draw and
// its regression on the difference there; above a high level d it rises by sigma^2/d on average.
function surfacesOf(sigma, length, d, touching, normal) {
  const each = sigma / Math.SQRT2; // both are equally rough
  const [low, high] = [profile(length, normal), profile(length, normal)];
  const place = Math.round(TOUCHING * POINTS);
  const missing = touching ? Math.max(d + sigma ** 2 / Math.max(d, sigma) - each * (low[place] - high[place]), 0) : 0;
  const rise = (i) => 0.5 * missing * Math.exp(-0.5 * (((i - place) * STEP) / length) ** 2);
  return { lower: low.map((z, i) => each * z + rise(i)), upper: high.map((z, i) => each * z + d - rise(i)) };
}

// A size drawn from the distribution of the particles.
function sizeOf(inputs, diameter, normal) {
  for (let trial = 0; trial < 500; trial++) {
    const alpha = normal();
    const size = inputs.mean_ratio + inputs.spread_ratio * alpha;
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
  const touching = found.mode < 3 && found.regime < FULL_FILM;
  const random = d3.randomLcg(SEED);
  const normal = d3.randomNormal.source(random)(0, 1);
  const count = twoBody ? 0 : Math.min(Math.round(LENGTH * Math.sqrt(point.particle_density)), MOST);
  const plane = inputs.particle_plane === "summit" ? surface.offset : 0;
  const least = found.separation - plane - inputs.elastic_depth_ratio * point.particle_diameter; // size that reaches into h_e
  const { lower, upper } = surfacesOf(point.roughness, length, found.separation, touching, normal);
  const touches = lower.map((value, i) => value > upper[i]);
  touches.forEach((isTouching, i) => {
    if (isTouching) lower[i] = upper[i] = 0.5 * (lower[i] + upper[i]);
  });
  const gap = (i) => upper[i] - lower[i];
  const narrowest = d3.least(d3.range(Math.round(RIGHT[0] * POINTS), Math.round(RIGHT[1] * POINTS)), gap);
  const particles = d3.range(count).map((i) => {
    const place = ((i + 0.15 + 0.7 * random()) / count) * LENGTH;
    const size = sizeOf(inputs, point.particle_diameter, normal);
    if (i || found.mode < 2 || found.regime === FULL_FILM) return settled(place, size, lower, upper, least);
    // one that carries load
    return settled(narrowest * STEP, Math.max(size, 1.001 * Math.min(gap(narrowest), least)), lower, upper, least);
  });
  return { found, point, lower, upper, touches, particles: apart(particles, touches) };
}

// Those of the particles that can be drawn without overlaps, and beside contacts of summits.
function apart(particles, touches) {
  const shown = [];
  for (const each of particles) {
    const isClear = ({ place, radius }) => Math.abs(place - each.place) > STRETCH * (radius + each.radius);
    if (!touches[Math.round(each.place / STEP)] && shown.every(isClear)) shown.push(each);
  }
  return shown;
}

// A particle at rest on the lower surface, or held where the gap is narrower. It carries load there, and
// from the least size on that reaches into the elastic zone.
function settled(place, diameter, lower, upper, least) {
  const radius = 0.5 * diameter;
  const away = (i) => Math.abs(i * STEP - place);
  const near = d3.range(POINTS).filter((i) => away(i) < Math.max(radius, STEP));
  const half = (i) => Math.sqrt(Math.max(radius ** 2 - away(i) ** 2, 0));
  const rests = d3.max(near, (i) => lower[i] + half(i));
  const hangs = d3.min(near, (i) => upper[i] - half(i));
  const height = Math.min(rests, 0.5 * (rests + hangs));
  const ceiling = d3.max(upper, (z, i) => (away(i) < STRETCH * radius ? z : undefined));
  return { place, radius, height, ceiling, carries: rests > hangs || diameter > least };
}

// What the cut shows, in words.
function wordsOf({ found, point, touches, particles }) {
  const carrying = particles.filter(({ carries }) => carries).length;
  const contacts = touches.filter((isTouching, i) => isTouching && !touches[i - 1]).length;
  return (
    `${conditionWords(point, "load").join(", ")} under ${valueText("load", point.load)}: ${stateText(found)}, ` +
    `separation ${numberText("separation", found.separation, 3)}; this cut meets ` +
    `${contacts} contact${contacts === 1 ? "" : "s"} of summits, and ` +
    (particles.length ? `${carrying} of ${particles.length} particles carry load.` : "no particles.")
  );
}

// Draw the cut; returns what it shows in words.
export function drawSection(parent) {
  const section = sectionOf();
  if (!section.lower) {
    parent.replaceChildren();
    return "No separation balances the load at these conditions.";
  }
  const words = wordsOf(section);
  const title = `The interface cut across, heights stretched ${STRETCH} times, particles drawn round`;
  const figure = d3.select(parent).html("").append("figure").attr("data-title", title);
  figure.append("figcaption").text(title);
  const svg = figure.append("svg").attr("class", "chart section").attr("xmlns", "http://www.w3.org/2000/svg").attr("role", "img");
  const width = widthIn(parent);
  const [drawing, height] = drawingOf(section, width / LENGTH);
  svg.attr("viewBox", `0 0 ${width} ${height}`).attr("width", width).attr("height", height);
  svg.html(`<title>${escaped(plain(words))}</title>${drawing}`);
  return words;
}

// The drawing as SVG at a scale [pixels/m], and its height.
function drawingOf({ found, point, lower, upper, touches, particles }, scale) {
  const [top, ground] = [d3.max(upper) + ABOVE, d3.min(lower) - BELOW];
  const [x, y] = [(i) => i * STEP * scale, (value) => (top - value) * scale * STRETCH];
  const between = (from, to) => d3.area((_, i) => x(i), (_, i) => y(from(i)), (_, i) => y(to(i))).digits(1)(lower);
  const [low, high] = [(i) => lower[i], (i) => upper[i]];
  const zones = particles.map(({ place, radius, height, ceiling, carries }) => {
    const [left, deep] = [(place - radius * STRETCH) * scale, y(height + radius) - y(ceiling)];
    return carries && deep > 0 ? `<rect class="elastic" x="${left}" y="${y(ceiling)}" width="${2 * radius * STRETCH * scale}" height="${deep}"/>` : "";
  });
  const balls = particles.map(({ place, radius, height, carries }) => {
    return `<circle class="${carries ? "carries" : "free"}" cx="${place * scale}" cy="${y(height)}" r="${radius * STRETCH * scale}"/>`;
  });
  const touching = d3.line((_, i) => x(i), y).defined((_, i) => touches[i])(lower) ?? "";
  const planes = [0, found.separation].map((level) => `<line class="plane" x2="${x(POINTS - 1)}" y1="${y(level)}" y2="${y(level)}"/>`);
  const [bar, foot] = [BAR * scale, y(ground) - 10]; // as far upwards, and smaller by the stretch
  const drawing = `
    <path d="${between(low, high)}" fill="${point.viscosity > 0 ? "var(--lubricant)" : "var(--paper)"}"/>
    ${zones.join("")}
    <path class="solid" d="${between(high, () => top)}" fill="var(--surface-1)"/>
    <path class="solid" d="${between(() => ground, low)}" fill="var(--surface-2)"/>
    ${planes.join("")}
    ${balls.join("")}
    <path class="touch" d="${touching}"/>
    <path class="bar" d="M10,${foot - bar}V${foot}H${10 + bar}"/>
    <text x="16" y="${foot - bar + 8}">${numberText("separation", BAR / STRETCH)}</text>
    <text x="${16 + bar}" y="${foot}">${numberText("separation", BAR)}; dashed: mean planes</text>`;
  return [drawing, y(ground)];
}

export const sectionKey = () => (currentPoint().viscosity > 0 ? KEY : KEY.filter(({ text }) => text !== "lubricant"));
const KEY = [
  { text: "surface 1", fill: "var(--surface-1)" },
  { text: "surface 2", fill: "var(--surface-2)" },
  { text: "lubricant", fill: "var(--lubricant)" },
  { text: "particle that carries load", fill: "var(--carries)", kind: "carries" },
  { text: "free particle", fill: "var(--free)", kind: "free" },
  { text: "contact of summits", color: "var(--turning)", kind: "touch" },
  { text: "elastic zone h_e", fill: "var(--turning)", kind: "elastic" },
];
