// Sliders, fields and choices of all conditions and inputs.

import { axes, change, content, currentInputs, currentPoint, defaultInputs, state } from "./state.js";
import { fromUnit, inputNamed, isAllowed, setCondition, setInputs, toUnit } from "./state.js";
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

// What newtons are: the paper leaves it open.
export function newtonsText() {
  const area = readable(currentInputs().apparent_area * 1e6, 3);
  return (
    `In newtons Fₜ = Fₜ* Aₙ E_ss. The paper does not print Aₙ, the apparent area of the contact; ` +
    `it is ${area} mm² here, one of the inputs.`
  );
}

function newtonsNote() {
  const note = Object.assign(document.createElement("p"), { className: "note" });
  updates.push(() => {
    note.textContent = newtonsText();
  });
  return note;
}

// A control with a button that goes back to the default, where it has been changed.
function controlOf({ id, label, hint, changed, back }, markup) {
  const control = Object.assign(document.createElement("div"), { className: "control", title: hint });
  control.innerHTML = `<label for="${id}">${label}</label>${markup}`;
  const button = control.querySelector(".back");
  button.setAttribute("aria-label", `default of ${control.querySelector("label").textContent}`);
  button.addEventListener("click", back);
  updates.push(() => control.classList.toggle("changed", changed()));
  return control;
}

// A slider with a field beside it. Values are in the unit of the field; `scale` maps them to the slider's
// steps, and `note` gives the range. `set` returns whether a value is allowed.
function rangeControl({ scale, digits, note, unit, value, set, ...given }) {
  const control = controlOf(
    given,
    `<input type="text" inputmode="decimal" id="${given.id}">${BACK}
    <div class="slider"><input type="range" min="0" max="${STEPS}"></div>
    <small class="note">${note}</small>`,
  );
  const [field, slider] = ["[type=text]", "[type=range]"].map((each) => control.querySelector(each));
  scale.range([0, STEPS]).clamp(true);
  slider.setAttribute("aria-label", `${control.querySelector("label").textContent}, slider`);
  slider.addEventListener("input", () => set(rounded(scale.invert(slider.value), digits)));
  field.addEventListener("change", () => {
    const allowed = set(numberIn(field.value));
    field.setCustomValidity(allowed ? "" : given.hint);
    if (!allowed) field.reportValidity();
  });
  updates.push(() => {
    slider.value = Math.round(scale(value()));
    slider.setAttribute("aria-valuetext", `${readable(value())} ${unit}`);
    if (document.activeElement === field && !field.validity.valid) return;
    field.value = significant(value(), 5);
    field.setCustomValidity("");
  });
  return control;
}

const rounded = (value, digits) => Number(value.toPrecision(digits));
const rangeText = (ends) => ends.map((end) => readable(end)).join(" to ");

function conditionControl(axis) {
  const { name, range } = axis;
  const [low, high] = range;
  const log = name === "load" || name === "particle_density";
  // a little beyond the paper's range
  const first = name === "roughness" ? 0.3 * low : 0;
  const dry = name === "viscosity" ? ", 0 is dry" : "";
  const note = `the paper: ${rangeText(range)} ${unitOf(name)}${dry}`;
  return rangeControl({
    id: `condition-${name}`,
    label: `${wordOf(name)} <i>${letterOf(name)}</i> [${unitOf(name)}]`,
    hint: `${wordOf(name)} in ${note}`,
    note,
    unit: unitOf(name),
    scale: log ? d3.scaleLog().domain([low / 4, 4 * high]) : d3.scaleLinear().domain([first, 1.3 * high]),
    digits: 3,
    value: () => toUnit(name, currentPoint()[name]),
    changed: () => name in state.conditions,
    set(value) {
      if (isAllowed(axis, value)) setCondition(name, fromUnit(name, value));
      return isAllowed(axis, value);
    },
    back: () => setCondition(name, undefined),
  });
}

function numberControl(name) {
  const { bounds, scale, symbol, unit, source, least, most } = content.inputs[name];
  const [text, factor] = SHOWN_IN[unit] ?? [unit, 1];
  const original = defaultInputs[name];
  const near = original > 0 ? [Math.max(original / 4, least), Math.min(original * 4, most)] : [0, Math.min(1, most)];
  const log = scale === "logarithmic" || (!bounds && original > 0);
  const ends = (bounds ?? near).map((end) => end / factor);
  const shownRange = (values) => rangeText(values.map((value) => value / factor));
  return rangeControl({
    id: `input-${name}`,
    label: `${inputWords(name)} <i>${symbol}</i>${text ? ` [${text}]` : ""}`,
    hint: `${inputWords(name)} (${source}): ${shownRange([least, most])} ${text}`,
    note: bounds ? `searched ${shownRange(bounds)}; ${ensembleText(name, shownRange)}` : source,
    unit: text,
    scale: (log ? d3.scaleLog() : d3.scaleLinear()).domain(ends),
    digits: 4,
    value: () => currentInputs()[name] / factor,
    changed: () => name in state.inputs,
    set(value) {
      const found = inputNamed(name, String(rounded(value * factor, 12)));
      if (found !== undefined) setInputs({ [name]: found });
      return found !== undefined;
    },
    back: () => setInputs({ [name]: undefined }),
  });
}

// Which values the members of the ensemble have.
function ensembleText(name, shownRange) {
  const [low, high] = d3.extent([defaultInputs, ...content.ensemble], (member) => member[name]);
  return low === high ? "one value in the ensemble" : `ensemble ${shownRange([low, high])}`;
}

// A list of words to choose from.
function choiceControl({ options, value, set, ...given }) {
  const control = controlOf(given, `<select id="${given.id}"></select>${BACK}`);
  control.classList.add("wide");
  const select = control.querySelector("select");
  select.append(...options.map(([word, text]) => new Option(text, word)));
  select.addEventListener("change", () => set(select.value));
  updates.push(() => {
    select.value = value();
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
    changed: () => name in state.inputs,
    set: (word) => setInputs({ [name]: inputNamed(name, word) }),
    back: () => setInputs({ [name]: undefined }),
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
      change({ inputs: {} });
      setInputs(interpretations[name] ?? {});
    },
    back: () => change({ inputs: {} }),
  });
}
