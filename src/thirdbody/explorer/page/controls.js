// Sliders, fields and choices of all inputs.

import {
  START,
  axes,
  content,
  defaultInputs,
  fromUnit,
  inputNamed,
  isAllowed,
  setCondition,
  setInputs,
  state,
  toUnit,
} from "./state.js";
import { inputWords, letterOf, unitOf, wordOf } from "./names.js";
import { numberIn, readable, significant } from "./text.js";

const STEPS = 1000; // of a slider
// engineering units of inputs that are given in SI
const SHOWN_IN = { Pa: ["GPa", 1e9], m: ["µm", 1e-6], m2: ["mm²", 1e-6], "s m-2": ["s m⁻²", 1], 1: ["", 1] };
const PRINTED = ["published", "deduced", "assumed"];

const updates = [];
export const updateControls = () => updates.forEach((update) => update());

export function makeControls(form) {
  form.addEventListener("submit", (event) => event.preventDefault());
  const conditions = group(form, "Conditions");
  axes.forEach((axis) => conditions.append(conditionControl(axis)));
  const interpretations = group(form, "Interpretation of the paper");
  interpretations.append(presetControl());
  const named = Object.entries(content.inputs);
  for (const [name, { allowed }] of named) if (allowed) interpretations.append(wordControl(name));
  const unprinted = group(form, "Inputs that the paper does not print", true);
  const printed = group(form, "Materials, film and ball");
  printed.parentNode.open = false;
  for (const [name, entry] of named) {
    if (!entry.allowed) (PRINTED.includes(entry.source) && !entry.bounds ? printed : unprinted).append(numberControl(name));
  }
  updateControls();
}

function group(form, title, open = true) {
  const details = document.createElement("details");
  details.open = open;
  details.append(Object.assign(document.createElement("summary"), { textContent: title }));
  const inside = document.createElement("div");
  details.append(inside);
  form.append(details);
  return inside;
}

// A slider with a number beside it; `axis` maps values to [0, 1] and back, `shown` to the field's unit.
function rangeControl({ id, label, hint, axis, value, original, set, marks, shown }) {
  const control = document.createElement("div");
  control.className = "control";
  control.innerHTML = `
    <label for="${id}"></label>
    <input type="text" inputmode="decimal" id="${id}">
    <button type="button" class="back" title="back to the default">↺</button>
    <div class="slider"><span class="range"></span><span class="default"></span><input type="range" min="0" max="${STEPS}"></div>`;
  const [field, slider, back] = ["input[type=text]", "input[type=range]", ".back"].map((each) => control.querySelector(each));
  control.querySelector("label").innerHTML = label;
  control.title = hint;
  slider.setAttribute("aria-label", `${control.querySelector("label").textContent}, slider`);
  back.setAttribute("aria-label", `default of ${control.querySelector("label").textContent}`);
  const percent = (part) => `calc(8px + (100% - 16px) * ${Math.min(Math.max(part, 0), 1)})`;
  const [low, high] = marks.map(axis.to);
  Object.assign(control.querySelector(".range").style, { left: percent(low), right: percent(1 - high) });
  control.querySelector(".default").style.left = percent(axis.to(original));
  slider.addEventListener("input", () => set(axis.from(slider.value / STEPS)));
  field.addEventListener("change", () => {
    const given = shown.from(numberIn(field.value));
    const allowed = set(given);
    field.setCustomValidity(allowed ? "" : hint);
    if (!allowed) field.reportValidity();
  });
  back.addEventListener("click", () => set(undefined));
  updates.push(() => {
    const now = value();
    slider.value = Math.round(STEPS * Math.min(Math.max(axis.to(now ?? original), 0), 1));
    slider.setAttribute("aria-valuetext", `${readable(shown.to(now ?? original))} ${shown.unit}`);
    if (document.activeElement !== field || field.validity.valid) {
      field.value = significant(shown.to(now ?? original), 5);
      field.setCustomValidity("");
    }
    control.classList.toggle("changed", now !== undefined);
  });
  return control;
}

const linear = (low, high) => ({ to: (value) => (value - low) / (high - low), from: (part) => low + (high - low) * part });
const logarithmic = (low, high) => ({
  to: (value) => Math.log(Math.max(value, low) / low) / Math.log(high / low),
  from: (part) => low * (high / low) ** part,
});
const roundTo = (value, digits) => Number(value.toPrecision(digits));

function conditionControl(axis) {
  const { name } = axis;
  const ends = axis.range.map((end) => fromUnit(name, end));
  const log = name === "load" || name === "particle_density";
  // a little beyond the paper's range, which is marked
  const seen = log ? logarithmic(ends[0] / 4, ends[1] * 4) : linear(0, 1.3 * ends[1]);
  if (name === "roughness") Object.assign(seen, linear(0.3 * ends[0], 1.3 * ends[1]));
  const from = seen.from;
  seen.from = (part) => fromUnit(name, roundTo(toUnit(name, from(part)), 3));
  return rangeControl({
    id: `condition-${name}`,
    label: `${wordOf(name)} <i>${letterOf(name)}</i> [${unitOf(axis) || "1"}]`,
    hint: `${wordOf(name)}: the paper has ${axis.range.map((end) => readable(end)).join(" to ")} ${unitOf(axis)}${name === "viscosity" ? ", 0 is dry" : ""}`,
    axis: seen,
    original: START[name],
    value: () => state.conditions[name],
    set(value) {
      if (value !== undefined && !isAllowed(axis, toUnit(name, value))) return false;
      setCondition(name, value);
      return true;
    },
    marks: ends,
    shown: { to: (value) => toUnit(name, value), from: (value) => fromUnit(name, value), unit: unitOf(axis) },
  });
}

function numberControl(name) {
  const { bounds, scale, symbol, unit, source, least, most } = content.inputs[name];
  const [text, factor] = SHOWN_IN[unit] ?? [unit, 1];
  const original = defaultInputs[name];
  const ends = bounds ?? (original > 0 ? [Math.max(original / 4, least), Math.min(original * 4, most)] : [0, Math.min(1, most)]);
  const log = scale === "logarithmic" || (!bounds && original > 0);
  const seen = log ? logarithmic(...ends) : linear(...ends);
  const from = seen.from;
  seen.from = (part) => Math.min(Math.max(roundTo(from(part), 4), least), most);
  const control = rangeControl({
    id: `input-${name}`,
    label: `${inputWords(name)} <i>${symbol ?? ""}</i>${text ? ` [${text}]` : ""}`,
    hint: `${inputWords(name)} (${source}): ${readable(least / factor)} to ${readable(most / factor)} ${text}`,
    axis: seen,
    original,
    value: () => state.inputs[name],
    set(value) {
      const found = value === undefined ? undefined : inputNamed(name, String(value));
      if (value !== undefined && found === undefined) return false;
      setInputs({ [name]: found });
      return true;
    },
    marks: bounds ?? ends,
    shown: { to: (value) => value / factor, from: (value) => value * factor, unit: text },
  });
  return control;
}

// Controls that choose a word: the interpretation of one place of the paper.
function choiceControl({ id, label, hint, options, value, changed, set }) {
  const control = document.createElement("div");
  control.className = "control wide";
  control.title = hint;
  control.innerHTML = `<label for="${id}"></label><select id="${id}"></select>
    <button type="button" class="back" title="back to the default">↺</button>`;
  control.querySelector("label").textContent = label;
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
  const text = { true: "above, scatter less", as_rough: "above, as rough", false: "at the mean plane" };
  return choiceControl({
    id: `input-${name}`,
    label: inputWords(name),
    hint: `${inputWords(name)} (${source}): one interpretation of the paper`,
    options: allowed.map((word) => [String(word), text[word] ?? String(word).replaceAll("_", " ")]),
    value: () => String(state.inputs[name] ?? defaultInputs[name]),
    changed: () => state.inputs[name] !== undefined,
    set: (word) => setInputs({ [name]: word === undefined ? undefined : inputNamed(name, word) }),
  });
}

const isChosen = (values) =>
  Object.entries(values).every(([name, value]) => (state.inputs[name] ?? defaultInputs[name]) === value);

// All inputs of a calibrated interpretation at once.
function presetControl() {
  const { interpretations, interpretation } = content;
  const chosen = () => Object.keys(interpretations).find((name) => isChosen(interpretations[name])) ?? "";
  return choiceControl({
    id: "interpretation",
    label: "Calibrated inputs",
    hint: "All unprinted inputs as calibrated under one interpretation",
    options: [["", "my own"], ...Object.keys(interpretations).map((name) => [name, name.replaceAll("_", " ")])],
    value: chosen,
    changed: () => chosen() !== interpretation && Object.keys(state.inputs).length > 0,
    set(name) {
      const cleared = Object.fromEntries(Object.keys(state.inputs).map((each) => [each, undefined]));
      setInputs({ ...cleared, ...(name === undefined ? {} : (interpretations[name] ?? {})) });
    },
  });
}
