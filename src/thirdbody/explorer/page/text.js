// Numbers and symbols as text.

const SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹";
export const powerOfTen = (exponent) =>
  `10${String(exponent).replace("-", "⁻").replace(/\d/g, (digit) => SUPERSCRIPTS[digit])}`;

// text inside of markup
export const escaped = (text) => text.replace(/[&<>"]/g, (sign) => `&#${sign.charCodeAt(0)};`);

// The number that a person types, with a decimal point or comma; NaN where it is none, or where a comma
// may stand before thousands: 1,000.
export function numberIn(text) {
  const plain = text.replace(/[\s'’]/g, "").replaceAll("−", "-").replace(/(?:[×·*]|(?<=\d)x)10\^?/, "e");
  if (plain === "" || /^-?[1-9]\d{0,2},\d{3}$/.test(plain)) return NaN;
  return Number(plain.includes(".") ? plain : plain.replace(",", "."));
}

// a number with so many significant digits, as Python's format `g` gives it
export function significant(value, digits) {
  if (Number.isNaN(value)) return "nan";
  if (!Number.isFinite(value)) return value > 0 ? "inf" : "-inf";
  if (value === 0) return "0";
  const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
  if (exponent >= -4 && exponent < digits) return String(Number(value.toPrecision(digits)));
  return `${Number(mantissa)}e${exponent[0]}${exponent.slice(1).padStart(2, "0")}`;
}

// the same for readers: 3.27×10⁻⁶
export function readable(value, digits = 4) {
  if (Number.isNaN(value)) return "–";
  const [mantissa, exponent] = significant(value, digits).split("e");
  if (exponent === undefined) return mantissa.replace("-", "−");
  const power = powerOfTen(Number(exponent));
  return mantissa === "1" ? power : `${mantissa}×${power}`;
}
