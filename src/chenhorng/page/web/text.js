// Numbers and symbols as text. The library tells how a symbol is found in a text, and how HTML writes it.

import { content } from "./content.js";

const { html, symbol, in_text, in_symbol, power, word, below, tight, greek, superscripts } = content.symbols;
const all = (...sources) => new RegExp(sources.join("|"), "gu");
export const powerOfTen = (exponent) => `10${String(exponent).replace(/./g, (sign) => superscripts["-0123456789".indexOf(sign)])}`;
const scientific = (factor, exponent) => (factor === "1" ? "" : `${factor}×`) + powerOfTen(Number(exponent));

// text inside of markup
export const escaped = (text) => text.replace(/[&<>"]/g, (sign) => `&#${sign.charCodeAt(0)};`);

// A form such as <sub>{}</sub> with texts in the places of its braces.
const filled = (form, ...texts) => texts.reduce((text, each) => text.replace("{}", () => each), form);

// Texts have symbols such as A_sa,t* and powers such as 3e-6. Markup has a letter, its index, and a power.
export const lettered = (text) =>
  text.replace(all(word), (name) => greek[name]).replace(all(below), (index) => `_${index.normalize("NFKC")}`);
const typesetter = (form, single = in_text) => (text) =>
  lettered(escaped(text))
    .replace(all(symbol, single), (_, letter, index, alone) => filled(form.symbol, letter ?? alone, index ? filled(form.below, index) : "", ""))
    .replace(all(power), (_, factor, sign, digits) => scientific(factor, sign + digits))
    .replace(all(tight), "\u00a0");
export const typeset = typesetter(html);
export const typesetSymbol = typesetter(html, in_symbol); // any single letter is a symbol
export const typesetInDrawing = typesetter({
  symbol: '<tspan font-style="italic">{}</tspan>{}{}',
  below: '<tspan dy="0.3em" font-size="0.8em">{}</tspan><tspan dy="-0.24em">\u200b</tspan>',
});
export const plain = (text) => text.replace(all(symbol), "$1$2");

// The number that a person types, with a decimal point or comma. What is no number gives NaN, and so does a comma that
// may stand before thousands: 1,000.
export function numberIn(text) {
  const raised = text.replace(/(?<=10)[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+/, (power) => `^${power.normalize("NFKC")}`); // 10¹¹
  const signs = raised.replace(/[\s'’]/g, "").replaceAll("−", "-");
  const plain = signs.replace(/(?:[×·*]|(?<=\d)x)10\^?/, "e").replace(/^10\^/, "1e");
  if (plain === "" || /^-?[1-9]\d{0,2},\d{3}$/.test(plain)) return NaN;
  return Number(plain.includes(".") ? plain : plain.replace(",", "."));
}

// a number with so many significant digits, as it is typed: 1.5e+12
export const significant = (value, digits) => d3.format(`.${digits}~g`)(value);

// the same for readers: 3.27×10⁻⁶; `trim` leaves out zeros at the end
export function readable(value, digits = 4, trim = "~") {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  if (size === 0 || (size >= 1e-4 && size < 10 ** Math.max(digits, 4))) return d3.format(`.${digits}${trim}r`)(value);
  const [mantissa, exponent] = d3.format(`.${digits - 1}${trim}e`)(value).split("e");
  return scientific(mantissa, exponent);
}
