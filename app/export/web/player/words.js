// Numbers as a person reads them, values as sliders and links have them: as app/readouts.py, typed.py and handles.py do.

const SUPERSCRIPTS = {"-": "⁻", ...Object.fromEntries([..."⁰¹²³⁴⁵⁶⁷⁸⁹"].map((mark, i) => [i, mark]))};
const power = exponent => "10" + [...String(exponent)].map(c => SUPERSCRIPTS[c]).join("");
const minus = text => text.replace(/-/g, "−");

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

const withUnit = (text, unit) => text + (unit === "" || unit === "°" ? "" : " ") + unit;
const written = (value, unit) => Number.isFinite(value) ? withUnit(three(value), unit) : three(value);

// The error of a float32 number against the exact one, in words.
function errorWords(value, exact, unit) {
  if (!Number.isFinite(value) || !Number.isFinite(exact)) return "";
  if (exact === 0) return value === 0 ? "exact to rounding" : `off by ${written(value, unit)}`;
  const error = (value - exact) / exact, size = Math.abs(error), percent = 100 * error;
  if (size <= 2 ** -23) return "exact to rounding";
  if (size < 5e-4) return minus(error.toExponential(0));
  if (size >= 100) return `${three(size)} times too ${error > 0 ? "much" : "little"}`;
  return minus((percent > 0 ? "+" : "") + percent.toFixed(size >= 0.0995 ? 0 : size >= 0.00995 ? 1 : 2)) + " %";
}

// Six significant digits, as a link has them.
const digits = value => String(Number(value.toPrecision(6)));
const slug = text => (text.toLowerCase().match(/[a-z0-9]+/g) || []).join("-");
const list = value => Array.isArray(value) ? value : [value];

const toSlider = (value, {low, high, log}) =>
  log ? Math.log(Math.max(value, low) / low) / Math.log(high / low) : (value - low) / (high - low);

function fromSlider(place, {low, high, log, whole}) {
  const at = Math.min(Math.max(place, 0), 1);
  const value = at === 1 ? high : log ? low * (high / low) ** at : low + at * (high - low);
  return whole ? Math.round(value) : value;
}

function shownText(spec, value) {
  if (spec.choices.length) return slug(spec.choices[value] || "") || digits(value);
  return list(value).map(x => digits(spec.angle ? x / RADIANS : x)).join(",");
}

// A value typed in screen units, within its range; null if it is none.
function entered(spec, text) {
  const word = spec.choices.findIndex(choice => slug(choice) === slug(text));
  if (word >= 0 && slug(text)) return word;
  const parts = text.split(",").map(part => {
    const [, number, unit] = /^\s*(.*?)\s*(deg|rad|°)?\s*$/.exec(part.replace("−", "-"));
    const value = number === "" ? NaN : Number(number) * (spec.angle && unit !== "rad" ? RADIANS : 1);
    return spec.whole ? Math.round(value) : Math.min(Math.max(value, spec.low), spec.high);
  });
  if (parts.length !== list(spec.default).length || !parts.every(x => Number.isFinite(x) && x >= spec.low && x <= spec.high))
    return null;
  return Array.isArray(spec.default) ? parts : parts[0];
}

// The values for which a handle's point lies nearest to the pixel `to`: damped least squares (Levenberg, Marquardt).
// at(places) -> pixel of the point; places run from 0 to 1 as the sliders do.
function nearest(place, to, at) {
  let here = at(place), damping = 1e-3;
  for (let round = 0; round < 8; round++) {
    const miss = [to[0] - here[0], to[1] - here[1]];
    if (Math.hypot(...miss) < 0.25) break;
    const slopes = place.map((x, i) => {
      const nudge = x > 0.5 ? -1e-3 : 1e-3, there = at(place.map((y, j) => i === j ? y + nudge : y));
      return [(there[0] - here[0]) / nudge, (there[1] - here[1]) / nudge];
    });
    const normal = slopes.map(a => slopes.map(b => a[0] * b[0] + a[1] * b[1]));
    const weight = normal.reduce((sum, row, i) => sum + row[i], 0) / place.length, before = place;
    for (; damping < 1e3 && place === before; damping *= 10) { // too bold: a shorter step
      const step = solve(normal.map((row, i) => row.map((x, j) => x + (i === j ? damping * weight + 1e-9 : 0))),
                         slopes.map(a => a[0] * miss[0] + a[1] * miss[1]));
      const short = Math.min(1, 0.25 / Math.max(1e-12, ...step.map(Math.abs)));
      const trial = place.map((x, i) => Math.min(Math.max(x + short * step[i], 0), 1)), there = at(trial);
      if (Math.hypot(to[0] - there[0], to[1] - there[1]) < Math.hypot(...miss)) {
        [place, here] = [trial, there];
        damping /= 100;
      }
    }
    if (place === before) break;
  }
  return place;
}

// A small system of linear equations, by elimination.
function solve(matrix, right) {
  const rows = matrix.map((row, i) => [...row, right[i]]), n = rows.length;
  for (let i = 0; i < n; i++) {
    for (let j = 0; j < n; j++) {
      const share = i === j ? 0 : rows[j][i] / rows[i][i];
      if (share) rows[j] = rows[j].map((x, k) => x - share * rows[i][k]);
    }
  }
  return rows.map((row, i) => row[n] / row[i]);
}
