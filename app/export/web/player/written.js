// Numbers as a person reads them: the words of app/readouts.py.

const SUPERSCRIPTS = {"-": "⁻", ...Object.fromEntries([..."⁰¹²³⁴⁵⁶⁷⁸⁹"].map((mark, i) => [i, mark]))};
const power = exponent => "10" + [...String(exponent)].map(c => SUPERSCRIPTS[c]).join("");
const minus = text => text.replace(/-/g, "−");
const withUnit = (text, unit) => text + (unit === "" || unit === "°" ? "" : " ") + unit;
const written = (value, unit) => Number.isFinite(value) ? withUnit(three(value), unit) : three(value);

// Three significant digits: 0.682, 12.6, 185 000, 6.80·10⁻⁵.
function three(value) {
  if (Number.isNaN(value)) return "not a number";
  if (!Number.isFinite(value)) return value > 0 ? "infinite" : "minus infinite";
  if (value === 0) return "0";
  const [mantissa, e] = value.toExponential(2).split("e"), exponent = +e;
  if (exponent < -3 || exponent >= 6) return `${minus(mantissa)}·${power(exponent)}`;
  const text = (+value.toExponential(2)).toFixed(Math.max(0, 2 - exponent));
  return minus(exponent > 3 ? text.replace(/\B(?=(\d{3})+$)/g, "\u202f") : text);
}

// The error of a float32 number against the exact one, in words.
function errorWords(value, exact, unit) {
  if (!Number.isFinite(value) || !Number.isFinite(exact)) return "";
  if (value === exact) return "exact to rounding";
  if (exact === 0) return `off by ${written(value, unit)}`;
  const error = (value - exact) / exact, size = Math.abs(error), percent = 100 * error;
  if (size <= 2 ** -23) return "exact to rounding";
  if (size < 5e-4) return minus(error.toExponential(0));
  if (size >= 100) return `${three(size)} times too ${error > 0 ? "much" : "little"}`;
  return minus((percent > 0 ? "+" : "") + percent.toFixed(size >= 0.0995 ? 0 : size >= 0.00995 ? 1 : 2)) + " %";
}
