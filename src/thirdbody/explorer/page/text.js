// Numbers and symbols as text.

const SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹";
export const powerOfTen = (exponent) =>
  `10${String(exponent).replace("-", "⁻").replace(/\d/g, (digit) => SUPERSCRIPTS[digit])}`;

// text inside of markup
export const escaped = (text) => text.replace(/[&<>"]/g, (sign) => `&#${sign.charCodeAt(0)};`);

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

// the same for readers: 3.27×10⁻⁶
export function readable(value, digits = 4) {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  if (size === 0 || (size >= 1e-4 && size < 10 ** digits)) return d3.format(`.${digits}~r`)(value);
  const [mantissa, exponent] = d3.format(`.${digits - 1}~e`)(value).split("e");
  const power = powerOfTen(Number(exponent));
  return mantissa === "1" ? power : `${mantissa}×${power}`;
}
