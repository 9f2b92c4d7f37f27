// Sliders, fields and choices of all conditions and inputs.

import {
  START,
  axes,
  content,
  currentInputs,
  defaultInputs,
  fromUnit,
  inputNamed,
  isAllowed,
  setCondition,
  setInputs,
  state,
  toUnit,
} from "./state.js";
import { inputWords, letterOf, spaced, unitOf, wordOf } from "./names.js";
import { numberIn, readable, significant } from "./text.js";

const STEPS = 1000; // of a slider
const BACK = '<button type="button" class="back" title="back to the default">↺</button>';
// engineering units of inputs that are given in SI
const SHOWN_IN = { Pa: ["GPa", 1e9], m: ["µm", 1e-6], m2: ["mm²", 1e-6], "s m-2": ["s m⁻²", 1], 1: ["", 1] };
const PRINTED = ["published", "deduced", "assumed"];
const OFFSETS = { true: "above, scatter less", as_rough: "above, as rough", false: "at the mean plane" };

const updates = [];
export const updateControls = () => updates.forEach((update) => update());

export function makeControls(form) {
  form.addEventListener("submit", (event) => event.preventDefault());
  const conditions = group(form, "Conditions");
  conditions.append(...axes.map(conditionControl), newtonsNote());
  const named = Object.entries(content.inputs);
  const words = named.filter(([, { allowed }]) => allowed).map(([name]) => wordControl(name));
  group(form, "Interpretation of the paper").append(presetControl(), ...words);
  const numbers = d3.group(
    named.filter(([, { allowed }]) => !allowed),
    ([, { source, bounds }]) => PRINTED.includes(source) && !bounds,
  );
  const controls = (isPrinted) => (numbers.get(isPrinted) ?? []).map(([name]) => numberControl(name));
  group(form, "Inputs that the paper does not print").append(...controls(false));
  group(form, "Materials, film and ball", false).append(...controls(true));
  updateControls();
}

function group(form, title, open = true) {
  const details = Object.assign(document.createElement("details"), { open });
  details.innerHTML = `<summary>${title}</summary><div></div>`;
  form.append(details);
  return details.querySelector("div");
}

// What newtons are, which the paper leaves open.
function newtonsNote() {
  const note = Object.assign(document.createElement("p"), { className: "note", id: "newtons" });
  updates.push(() => {
    const area = readable(currentInputs().apparent_area * 1e6, 3);
    note.textContent =
      `In newtons Fₜ = Fₜ* Aₙ E_ss. The paper does not print Aₙ, the apparent area of the contact; ` +
      `it is ${area} mm² here, one of the inputs below.`;
  });
  return note;
}

// A slider with a field beside it. `axis` maps values to [0, 1] and back, `shown` to the unit of the
// field; `note` gives the range.
function rangeControl({ id, label, hint, note, axis, value, original, set, shown }) {
  const control = Object.assign(document.createElement("div"), { className: "control", title: hint });
  control.innerHTML = `
    <label for="${id}">${label}</label>
    <input type="text" inputmode="decimal" id="${id}">${BACK}
    <div class="slider"><input type="range" min="0" max="${STEPS}"></div>
    <small class="note">${note}</small>`;
  const [field, slider, back] = ["[type=text]", "[type=range]", ".back"].map((each) => control.querySelector(each));
  const words = control.querySelector("label").textContent;
  slider.setAttribute("aria-label", `${words}, slider`);
  back.setAttribute("aria-label", `default of ${words}`);
  slider.addEventListener("input", () => set(axis.from(slider.value / STEPS)));
  field.addEventListener("change", () => {
    const allowed = set(shown.from(numberIn(field.value)));
    field.setCustomValidity(allowed ? "" : hint);
    if (!allowed) field.reportValidity();
  });
  back.addEventListener("click", () => set(undefined));
  updates.push(() => {
    const now = value() ?? original;
    slider.value = Math.round(STEPS * Math.min(Math.max(axis.to(now), 0), 1));
    slider.setAttribute("aria-valuetext", `${readable(shown.to(now))} ${shown.unit}`);
    if (document.activeElement !== field || field.validity.valid) {
      field.value = significant(shown.to(now), 5);
      field.setCustomValidity("");
    }
    control.classList.toggle("changed", value() !== undefined);
  });
  return control;
}

// Maps between the values of a slider and [0, 1].
function sliderAxis(log, [low, high], rounded) {
  const scale = (log ? d3.scaleLog() : d3.scaleLinear()).domain([low, high]);
  return {
    to: (value) => scale(log ? Math.max(value, low) : value),
    from: (part) => rounded(scale.invert(part)),
  };
}

const roundTo = (value, digits) => Number(value.toPrecision(digits));
const rangeText = (ends) => ends.map((end) => readable(end)).join(" to ");

function conditionControl(axis) {
  const { name, range } = axis;
  const [low, high] = range.map((end) => fromUnit(name, end));
  const log = name === "load" || name === "particle_density";
  // a little beyond the paper's range
  const first = log ? low / 4 : name === "roughness" ? 0.3 * low : 0;
  const rounded = (value) => fromUnit(name, roundTo(toUnit(name, value), 3));
  const dry = name === "viscosity" ? ", 0 is dry" : "";
  const note = `the paper: ${rangeText(range)} ${unitOf(name)}${dry}`;
  return rangeControl({
    id: `condition-${name}`,
    label: `${wordOf(name)} <i>${letterOf(name)}</i> [${unitOf(name)}]`,
    hint: `${wordOf(name)} in ${note}`,
    note,
    axis: sliderAxis(log, [first, log ? 4 * high : 1.3 * high], rounded),
    original: START[name],
    value: () => state.conditions[name],
    set(value) {
      if (value !== undefined && !isAllowed(axis, toUnit(name, value))) return false;
      setCondition(name, value);
      return true;
    },
    shown: { to: (value) => toUnit(name, value), from: (value) => fromUnit(name, value), unit: unitOf(name) },
  });
}

function numberControl(name) {
  const { bounds, scale, symbol, unit, source, least, most } = content.inputs[name];
  const [text, factor] = SHOWN_IN[unit] ?? [unit, 1];
  const original = defaultInputs[name];
  const near = original > 0 ? [Math.max(original / 4, least), Math.min(original * 4, most)] : [0, Math.min(1, most)];
  const ends = bounds ?? near;
  const log = scale === "logarithmic" || (!bounds && original > 0);
  const rounded = (value) => Math.min(Math.max(roundTo(value, 4), least), most);
  const shownRange = (values) => rangeText(values.map((value) => value / factor));
  return rangeControl({
    id: `input-${name}`,
    label: `${inputWords(name)} <i>${symbol}</i>${text ? ` [${text}]` : ""}`,
    hint: `${inputWords(name)} (${source}): ${shownRange([least, most])} ${text}`,
    note: bounds ? `searched ${shownRange(bounds)}; ${ensembleText(name, shownRange)}` : source,
    axis: sliderAxis(log, ends, rounded),
    original,
    value: () => state.inputs[name],
    set(value) {
      const found = value === undefined ? undefined : inputNamed(name, String(value));
      if (value !== undefined && found === undefined) return false;
      setInputs({ [name]: found });
      return true;
    },
    shown: { to: (value) => value / factor, from: (value) => value * factor, unit: text },
  });
}

// Which values the members of the ensemble have.
function ensembleText(name, shownRange) {
  const [low, high] = d3.extent([defaultInputs, ...content.ensemble], (member) => member[name]);
  return low === high ? "one value in the ensemble" : `ensemble ${shownRange([low, high])}`;
}

// A list of words to choose from.
function choiceControl({ id, label, hint, options, value, changed, set }) {
  const control = Object.assign(document.createElement("div"), { className: "control wide", title: hint });
  control.innerHTML = `<label for="${id}">${label}</label><select id="${id}"></select>${BACK}`;
  const [select, back] = ["select", ".back"].map((each) => control.querySelector(each));
  for (const [word, text] of options) select.append(new Option(text, word));
  select.addEventListener("change", () => set(select.value));
  back.addEventListener("click", () => set(undefined));
  back.setAttribute("aria-label", `default of ${label}`);
  updates.push(() => {
    select.value = value();
    control.classList.toggle("changed", changed());
  });
  return control;
}

function wordControl(name) {
  const { allowed, source } = content.inputs[name];
  return choiceControl({
    id: `input-${name}`,
    label: inputWords(name),
    hint: `${inputWords(name)} (${source}): one interpretation of the paper`,
    options: allowed.map((word) => [String(word), OFFSETS[word] ?? spaced(word)]),
    value: () => String(currentInputs()[name]),
    changed: () => state.inputs[name] !== undefined,
    set: (word) => setInputs({ [name]: word === undefined ? undefined : inputNamed(name, word) }),
  });
}

// All inputs of a calibrated interpretation at once.
function presetControl() {
  const { interpretations, interpretation } = content;
  const isChosen = (name) =>
    Object.entries(interpretations[name]).every(([input, value]) => currentInputs()[input] === value);
  const chosen = () => Object.keys(interpretations).find(isChosen) ?? "";
  return choiceControl({
    id: "interpretation",
    label: "Calibrated inputs",
    hint: "All unprinted inputs as calibrated under one interpretation",
    options: [["", "your own"], ...Object.keys(interpretations).map((name) => [name, spaced(name)])],
    value: chosen,
    changed: () => chosen() !== interpretation && Object.keys(state.inputs).length > 0,
    set(name) {
      const cleared = Object.fromEntries(Object.keys(state.inputs).map((each) => [each, undefined]));
      setInputs({ ...cleared, ...interpretations[name] });
    },
  });
}
