// Numbers and symbols as text.

const SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹";
export const powerOfTen = (exponent) =>
  `10${String(exponent).replace("-", "⁻").replace(/\d/g, (digit) => SUPERSCRIPTS[digit])}`;

// text inside of markup
export const escaped = (text) => text.replace(/[&<>"]/g, (sign) => `&#${sign.charCodeAt(0)};`);

// Texts with symbols such as A_sa,t* and powers such as 3e-6 as markup: a letter, its index, and a power.
const SYMBOL = /(?<!\w)(\p{L})_(\w+(?:,t)?)|[νσ]|(?<![\w'’])d(?!\w)/gu;
const POWER = /(?<=\d)e([-+]?\d+)/g;
const LETTERS = { eta: "η", sigma: "σ", omega: "ω", kappa: "κ", phi: "φ", nu: "ν", ₐ: "_a", ₜ: "_t" };
const LETTER = /(?<![a-z])(?:eta|sigma|omega|kappa|phi|nu)(?![a-z])|[ₐₜ]/g;
export const lettered = (text) => text.replace(LETTER, (word) => LETTERS[word]);
const typesetter = (letterIn, indexIn) => (text) =>
  lettered(escaped(text))
    .replace(SYMBOL, (found, letter = found, index) => letterIn(letter) + (index ? indexIn(index) : ""))
    .replace(POWER, (_, exponent) => `×${powerOfTen(Number(exponent))}`);
export const typeset = typesetter((letter) => `<i>${letter}</i>`, (index) => `<sub>${index}</sub>`);
export const typesetInDrawing = typesetter(
  (letter) => `<tspan font-style="italic">${letter}</tspan>`,
  (index) => `<tspan dy="0.3em" font-size="0.8em">${index}</tspan><tspan dy="-0.24em">\u200b</tspan>`,
);
export const plain = (text) => text.replace(SYMBOL, (found, letter = found, index = "") => letter + index);

// The number that a person types, with a decimal point or comma; NaN where it is none, or where a comma
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
  const power = powerOfTen(Number(exponent));
  return mantissa === "1" ? power : `${mantissa}×${power}`;
}
