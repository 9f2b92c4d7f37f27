// Numbers and symbols as text.

const SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹";
const raised = (exponent) =>
  String(exponent).replace("-", "⁻").replace(/\d/g, (digit) => SUPERSCRIPTS[digit]);

// The number that a person types, with a decimal point or comma; NaN where it is none, or where a comma
// may stand before thousands: 1,000.
export function numberIn(text) {
  const plain = text.replace(/[\s'’]/g, "").replaceAll("−", "-").replace(/(?:[×·*]|(?<=\d)x)10\^?/, "e");
  if (plain === "" || /^-?[1-9]\d{0,2},\d{3}$/.test(plain)) return NaN;
  return Number(plain.includes(".") ? plain : plain.replace(",", "."));
}

// so many significant digits, as Python's format `g` gives them
export function significant(value, digits) {
  if (Number.isNaN(value)) return "nan";
  if (!Number.isFinite(value)) return value > 0 ? "inf" : "-inf";
  if (value === 0) return "0";
  const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
  if (Number(exponent) >= -4 && Number(exponent) < digits) {
    return String(Number(value.toPrecision(digits)));
  }
  const sign = exponent[0] === "-" ? "-" : "+";
  return `${Number(mantissa)}e${sign}${exponent.slice(1).padStart(2, "0")}`;
}

// the same for readers: 3.27×10⁻⁶
export function readable(value, digits = 4) {
  const text = significant(value, digits);
  if (text === "nan") return "–";
  const [mantissa, exponent] = text.split("e");
  if (exponent === undefined) return text.replace("-", "−");
  const power = `10${raised(Number(exponent))}`;
  return mantissa === "1" ? power : `${mantissa}×${power}`;
}

export const powerOfTen = (exponent) => `10${raised(exponent)}`;
