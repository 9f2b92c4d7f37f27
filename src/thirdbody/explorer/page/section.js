// A cut through the interface, true to scale: both surfaces, particles and film at a solved separation.

import { currentInputs, currentPoint } from "./state.js";
import { currentEngine } from "./engine.js";
import { MODE_TEXT, REGIME_TEXT, conditionText, valueText } from "./names.js";
import { readable } from "./text.js";

const SEED = 20240507; // the day on which the paper appeared
const POINTS = 700;
const LENGTH = 10e-6; // of the cut [m]
const MOST = 60; // particles drawn
const TOUCHING = 210; // the point at which summits touch, in modes where they do

// random numbers between 0 and 1 that are the same each time: mulberry32
function randomOf(seed) {
  let a = seed;
  return () => {
    a = (a + 0x6d2b79f5) | 0;
    let t = Math.imul(a ^ (a >>> 15), 1 | a);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}
const normalOf = (random) => d3.randomNormal.source(random)(0, 1);

// A Gaussian profile of unit variance with the autocorrelation exp(-x^2/2 length^2).
function profile(length, normal) {
  const step = LENGTH / (POINTS - 1);
  const reach = Math.min(Math.floor((3 * length) / step), 400);
  const kernel = d3.range(-reach, reach + 1).map((k) => Math.exp(-(((k * step) / length) ** 2)));
  const norm = Math.sqrt(d3.sum(kernel, (k) => k * k));
  const noise = Array.from({ length: POINTS + 2 * reach }, normal);
  return d3.range(POINTS).map((i) => d3.sum(kernel, (k, n) => k * noise[i + n]) / norm);
}

// What is added to the lower surface, and taken from the upper one, where summits are to touch: a
// Gaussian process that passes a given height there is a draw and its regression on the difference;
// beyond a high level d it rises sigma^2/d on average.
function riseAt(place, drawn, d, roughness, length) {
  const missing = Math.max(d + roughness ** 2 / Math.max(d, roughness) - drawn, 0);
  const step = LENGTH / (POINTS - 1);
  return (i) => 0.5 * missing * Math.exp(-0.5 * (((i - place) * step) / length) ** 2);
}

// Sizes of particles, from the interpretation of their distribution: a draw between X_min and X_max.
function sizeOf(inputs, diameter, normal) {
  const mean = inputs.size_distribution === "uncentred" ? 0 : inputs.mean_ratio;
  for (let trial = 0; trial < 500; trial++) {
    const alpha = normal();
    const size = mean + inputs.spread_ratio * alpha;
    if (size > 0 && alpha < inputs.truncation) return size * diameter;
  }
  return diameter;
}

// The section at the chosen conditions: heights, particles at rest or held, and the state.
export function sectionOf() {
  const [engine, inputs, point] = [currentEngine(), currentInputs(), currentPoint()];
  const found = engine.state(point);
  if (Number.isNaN(found.separation)) return { found, point };
  const condition = { ...point };
  delete condition.load;
  const contact = engine.contact(condition);
  // Nayak (1971): such a surface has 1/(2 pi sqrt(3) l^2) summits per area
  const length = 1 / Math.sqrt(2 * Math.PI * Math.sqrt(3) * contact.surface.density);
  const normal = normalOf(randomOf(SEED));
  const each = point.roughness / Math.SQRT2; // both surfaces are equally rough
  const [low, high] = [profile(length, normal), profile(length, normal)];
  const { separation: d } = found;
  const rise = riseAt(TOUCHING, each * (low[TOUCHING] - high[TOUCHING]), d, point.roughness, length);
  const touch = found.mode < 3 ? 1 : 0; // else the cut meets no summits
  const lower = low.map((value, i) => each * value + touch * rise(i));
  const upper = high.map((value, i) => each * value + d - touch * rise(i));
  const touches = lower.map((value, i) => value > upper[i]);
  touches.forEach((each, i) => {
    if (each) lower[i] = upper[i] = 0.5 * (lower[i] + upper[i]);
  });
  const count = contact.twoBody ? 0 : Math.min(Math.round(LENGTH * Math.sqrt(point.particle_density)), MOST);
  const placed = randomOf(SEED + 1);
  const drawn = normalOf(randomOf(SEED + 2));
  const plane = inputs.particle_plane === "summit" ? contact.surface.offset : 0;
  const depth = inputs.elastic_limits === "printed" ? inputs.elastic_depth_ratio * point.particle_diameter : 0;
  const particles = d3.range(count).map((i) => {
    const place = ((i + 0.15 + 0.7 * placed()) / count) * LENGTH;
    return settled(place, sizeOf(inputs, point.particle_diameter, drawn), lower, upper, plane + depth);
  });
  return { found, point, lower, upper, touches, particles };
}

// A particle at rest on the lower surface, or held where the gap is narrower; it bears load where the
// gap exceeds it by no more than the elastic zone reaches.
function settled(place, diameter, lower, upper, reach) {
  const radius = 0.5 * diameter;
  const step = LENGTH / (POINTS - 1);
  const middle = Math.min(Math.round(place / step), POINTS - 1);
  let [rests, hangs] = [lower[middle] + radius, upper[middle] - radius];
  for (let i = Math.max(Math.ceil((place - radius) / step), 0); i < POINTS && i * step < place + radius; i++) {
    const half = Math.sqrt(Math.max(radius ** 2 - (i * step - place) ** 2, 0));
    rests = Math.max(rests, lower[i] + half);
    hangs = Math.min(hangs, upper[i] - half);
  }
  return { place, radius, height: Math.min(rests, 0.5 * (rests + hangs)), bears: rests + reach > hangs };
}

export function drawSection(parent) {
  const { found, point, lower, upper, touches, particles } = sectionOf();
  const figure = d3.select(parent).html("").append("figure");
  figure.append("figcaption").text("The interface cut across, true to scale");
  const em = parseFloat(getComputedStyle(document.documentElement).fontSize) / 14;
  const width = Math.max(parent.clientWidth, 240);
  const svg = figure.append("svg").attr("class", "chart section").attr("xmlns", "http://www.w3.org/2000/svg").attr("role", "img");
  if (!lower) {
    svg.attr("viewBox", `0 0 ${width} 60`).append("text").attr("x", 10).attr("y", 30).text("No separation balances the load at these conditions.");
    return { svg: svg.node(), figure: figure.node() };
  }
  const scale = width / LENGTH;
  const [bottom, top] = [d3.min(lower) - 0.35e-6, d3.max(upper) + 0.35e-6];
  const height = Math.max((top - bottom) * scale, 60) + 34 * em;
  const ground = (top - bottom) * scale;
  svg.attr("viewBox", `0 0 ${width} ${height}`).attr("width", width).attr("height", height);
  const x = (i) => (i / (POINTS - 1)) * width;
  const y = (value) => (top - value) * scale;
  const area = d3.area().x((_, i) => x(i));
  const bears = particles.filter((particle) => particle.bears).length;
  const contacts = touches.filter((touch, i) => touch && !touches[i - 1]).length;
  const words =
    `${conditionText(point)} under ${valueText("load", point.load)}: ${MODE_TEXT[found.mode]} mode, ` +
    `${REGIME_TEXT[found.regime]} lubrication, separation ${readable(found.separation * 1e9, 4)} nm; ` +
    `this cut meets ${contacts} contact${contacts === 1 ? "" : "s"} of summits, and ${bears} of ${particles.length} particles that bear load.`;
  svg.attr("aria-label", words);
  svg.append("title").text(words);
  const layers = [
    ["film", area.y0((_, i) => y(lower[i])).y1((_, i) => y(upper[i]))(lower), point.viscosity > 0 ? "var(--oil)" : "var(--paper)"],
    ["lower", area.y0(ground).y1((_, i) => y(lower[i]))(lower), "var(--solid)"],
    ["upper", area.y0(0).y1((_, i) => y(upper[i]))(upper), "var(--solid)"],
  ];
  for (const [name, path, fill] of layers) svg.append("path").attr("class", name).attr("d", path).attr("fill", fill);
  svg
    .selectAll("circle")
    .data(particles)
    .join("circle")
    .attr("cx", ({ place }) => place * scale)
    .attr("cy", ({ height: at }) => y(at))
    .attr("r", ({ radius }) => radius * scale)
    .attr("fill", ({ bears: does }) => (does ? "var(--fails)" : "var(--paper)"))
    .attr("stroke", "var(--ink)")
    .attr("stroke-width", 1.2);
  const touching = d3.line((_, i) => x(i), (value) => y(value)).defined((_, i) => touches[i]);
  svg.append("path").attr("class", "touch").attr("d", touching(lower)).attr("fill", "none").attr("stroke", "var(--holds)").attr("stroke-width", 4 * em);
  for (const level of [0, found.separation]) {
    svg.append("line").attr("x1", 0).attr("x2", width).attr("y1", y(level)).attr("y2", y(level)).attr("stroke", "var(--ink)").attr("stroke-dasharray", "6 4").attr("stroke-width", 0.9);
  }
  const bar = svg.append("g").attr("transform", `translate(${10 * em},${ground + 14 * em})`);
  bar.append("path").attr("d", `M0,-4V4M0,0H${1e-6 * scale}M${1e-6 * scale},-4V4`).attr("stroke", "var(--ink)").attr("fill", "none");
  bar.append("text").attr("x", 1e-6 * scale + 6 * em).attr("dy", "0.32em").text("1 µm, in height as in length; dashed: mean planes, d apart");
  return { svg: svg.node(), figure: figure.node(), words };
}

export const sectionKey = () => [
  { text: "surfaces", fill: "var(--solid)" },
  { text: "film", fill: "var(--oil)" },
  { text: "particle that bears load", fill: "var(--fails)" },
  { text: "particle that rests", fill: "var(--paper)" },
  { text: "contact of summits", stroke: "var(--holds)" },
];
