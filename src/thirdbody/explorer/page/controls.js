// Sliders, fields and choices of all conditions and inputs.

import { axes, change, content, currentInputs, currentPoint, defaultInputs, state } from "./state.js";
import { fromUnit, inputNamed, isAllowed, setCondition, setInputs, toUnit } from "./state.js";
import { VARIABLES, inputWords, letterOf, scaleFor, spaced, unitOf, wordOf } from "./names.js";
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
  const names = d3.group(Object.keys(content.inputs), kindOf);
  const controls = (kind, control) => (names.get(kind) ?? []).map(control);
  group(form, "Conditions", axes.map(conditionControl));
  group(form, "Interpretation of the paper", [presetControl(), ...controls("word", wordControl)]);
  group(form, "Inputs that the paper does not print", controls("unknown", numberControl));
  group(form, "Materials, film and ball", controls("printed", numberControl), false);
  updateControls();
}

function kindOf(name) {
  const { allowed, bounds, source } = content.inputs[name];
  if (allowed) return "word";
  return PRINTED.includes(source) && !bounds ? "printed" : "unknown";
}

function group(form, title, controls, open = true) {
  const details = d3.select(form).append("details").property("open", open);
  details.append("summary").text(title);
  details.node().append(...controls);
}

// A control with a button that goes back to the default, where it has been changed.
function controlOf({ id, label, hint, changed, back }, markup) {
  const control = d3.create("div").attr("class", "control").attr("title", hint);
  control.html(`<label for="${id}">${label}</label>${markup}`);
  control.select(".back").attr("aria-label", `default of ${control.select("label").text()}`).on("click", back);
  updates.push(() => control.classed("changed", changed()));
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
  const [field, slider] = control.selectAll("input").nodes();
  scale.range([0, STEPS]).clamp(true);
  slider.setAttribute("aria-label", `${control.select("label").text()}, slider`);
  slider.addEventListener("input", () => set(Number(scale.invert(slider.value).toPrecision(digits))));
  field.addEventListener("change", () => {
    field.setCustomValidity(set(numberIn(field.value)) ? "" : given.hint);
    field.reportValidity();
  });
  updates.push(() => {
    slider.value = Math.round(scale(value()));
    slider.setAttribute("aria-valuetext", `${readable(value())} ${unit}`);
    if (document.activeElement === field && !field.validity.valid) return;
    field.value = significant(value(), 5);
    field.setCustomValidity("");
  });
  return control.node();
}

const rangeText = (ends, factor = 1) => ends.map((end) => readable(end / factor)).join(" to ");

function conditionControl({ name, range: [low, high] }) {
  // a little beyond the paper's range
  const ends = VARIABLES[name].log ? [low / 4, 4 * high] : [0.3 * low, 1.3 * high];
  const dry = name === "viscosity" ? ", 0 is dry" : "";
  const note = `the paper: ${rangeText([low, high])} ${unitOf(name)}${dry}`;
  return rangeControl({
    id: `condition-${name}`,
    label: `${wordOf(name)} <i>${letterOf(name)}</i> [${unitOf(name)}]`,
    hint: `${wordOf(name)} in ${note}`,
    note,
    unit: unitOf(name),
    scale: scaleFor(name).domain(ends),
    digits: 3,
    value: () => toUnit(name, currentPoint()[name]),
    changed: () => name in state.conditions,
    set(value) {
      if (isAllowed(name, value)) setCondition(name, fromUnit(name, value));
      return isAllowed(name, value);
    },
    back: () => setCondition(name, undefined),
  });
}

// What controls of all inputs have in common.
const inputControl = (name) => ({
  id: `input-${name}`,
  changed: () => name in state.inputs,
  back: () => setInputs({ [name]: undefined }),
});

function numberControl(name) {
  const { bounds, scale, symbol, unit, source, least, most } = content.inputs[name];
  const [text, factor] = SHOWN_IN[unit] ?? [unit, 1];
  const original = defaultInputs[name];
  const near = original > 0 ? [Math.max(original / 4, least), Math.min(original * 4, most)] : [0, Math.min(1, most)];
  const log = scale === "logarithmic" || (!bounds && original > 0);
  return rangeControl({
    ...inputControl(name),
    label: `${inputWords(name)} <i>${symbol}</i>${text ? ` [${text}]` : ""}`,
    hint: `${inputWords(name)} (${source}): ${rangeText([least, most], factor)} ${text}`,
    note: bounds ? `searched ${rangeText(bounds, factor)}; ${ensembleText(name, factor)}` : source,
    unit: text,
    scale: (log ? d3.scaleLog() : d3.scaleLinear()).domain((bounds ?? near).map((end) => end / factor)),
    digits: 4,
    value: () => currentInputs()[name] / factor,
    set(value) {
      const found = inputNamed(name, (value * factor).toPrecision(12));
      if (found !== undefined) setInputs({ [name]: found });
      return found !== undefined;
    },
  });
}

// Which values the members of the ensemble have.
function ensembleText(name, factor) {
  const [low, high] = d3.extent([defaultInputs, ...content.ensemble], (member) => member[name]);
  return low === high ? "one value in the ensemble" : `ensemble ${rangeText([low, high], factor)}`;
}

// A list of words to choose from.
function choiceControl({ options, value, set, ...given }) {
  const control = controlOf(given, `<select id="${given.id}"></select>${BACK}`).classed("wide", true);
  const select = control.select("select").on("change", (event) => set(event.target.value));
  select.node().append(...options.map(([word, text]) => new Option(text, word)));
  updates.push(() => select.property("value", value()));
  return control.node();
}

function wordControl(name) {
  const { allowed, source } = content.inputs[name];
  return choiceControl({
    ...inputControl(name),
    label: inputWords(name),
    hint: `${inputWords(name)} (${source}): one interpretation of the paper`,
    options: allowed.map((word) => [word, OFFSETS[word] ?? spaced(word)]),
    value: () => currentInputs()[name],
    set: (word) => setInputs({ [name]: inputNamed(name, word) }),
  });
}

// All inputs of a calibrated interpretation at once.
function presetControl() {
  const { interpretations, interpretation } = content;
  const isChosen = ([, inputs]) => Object.entries(inputs).every(([name, value]) => currentInputs()[name] === value);
  const chosen = () => Object.entries(interpretations).find(isChosen)?.[0] ?? "";
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
