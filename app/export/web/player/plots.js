// Curves and slices as SVG, ledgers as tables; every number comes from the GLSL twins.

const SVG = "http://www.w3.org/2000/svg";
const DASHES = {exact: ["", "9 5", "2 5"], printed: ["10 4 2 4", "2 5", "9 5"], estimate: ["0 8", "5 5", "0 5", "9 4 0 4"]};

function element(name, attributes = {}, ...children) {
  const made = attributes.xmlns ? document.createElementNS(SVG, name) : document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) if (key !== "xmlns") made.setAttribute(key, value);
  made.append(...children);
  return made;
}
const svg = (name, attributes, ...children) => element(name, {xmlns: SVG, ...attributes}, ...children);
const line = (points, attributes) => { // broken where a number is not finite
  let pen = "M";
  const path = points.map(([x, y]) => {
    const ok = Number.isFinite(x) && Number.isFinite(y), text = ok ? `${pen}${x.toFixed(2)} ${y.toFixed(2)}` : "";
    pen = ok ? "L" : "M";
    return text;
  });
  return svg("path", {d: path.join(""), fill: "none", "stroke-width": 2, ...attributes});
};
const words = (x, y, text, anchor = "middle", attributes = {}) =>
  svg("text", {x, y, "text-anchor": anchor, "dominant-baseline": "central", ...attributes}, text);
const stroke = (curve, colour) => ({stroke: colour, "stroke-dasharray": curve.dash, "stroke-linecap": /^0/.test(curve.dash) ?
  "round" : "butt", "stroke-width": /^0/.test(curve.dash) ? 4.5 : 2.2});

function nice(value) { // the next round number upwards
  const scale = 10 ** Math.floor(Math.log10(value));
  return [1, 1.2, 1.5, 2, 3, 4, 5, 6, 8, 10, 20].map(m => m * scale).find(x => x >= value * (1 - 1e-12));
}

function tickText(value) {
  if (value === 0) return "0";
  const exponent = Math.floor(Math.log10(Math.abs(value)) + 1e-9);
  if (exponent > -4 && exponent < 5) return minus(digits(value));
  const mantissa = digits(+(value / 10 ** exponent).toPrecision(4));
  return minus(mantissa === "1" ? "" : `${mantissa}·`) + power(exponent);
}

// Round numbers within [low, high], about `most` of them.
function linearTicks(low, high, most, {degrees, whole} = {}) {
  const rough = (high - low) / most, scale = 10 ** Math.floor(Math.log10(rough));
  let steps = [1, 2, 5, 10, 20].map(m => m * scale);
  if (degrees && high - low >= 40) steps = [10, 15, 30, 45, 90, 180];
  if (whole) steps = steps.map(step => Math.max(1, step));
  const step = steps.find(x => x >= rough * 0.999) || steps.at(-1), found = [];
  for (let k = Math.ceil(low / step - 1e-6); k <= Math.floor(high / step + 1e-6); k++) found.push(+(k * step).toPrecision(12));
  return found;
}

function logTicks(low, high, most) {
  const [a, b] = [Math.log10(low), Math.log10(high)], found = [];
  if (b - a < 1.8)
    for (let k = Math.floor(a); k <= b; k++) for (const m of [1, 2, 5]) found.push(m * 10 ** k);
  else
    for (let k = Math.ceil(a - 1e-9), n = Math.max(1, Math.ceil((b - a + 1) / most)); k <= b + 1e-9; k++) if (k % n === 0) found.push(10 ** k);
  return found.filter(x => x >= low * (1 - 1e-9) && x <= high * (1 + 1e-9));
}
const place = (value, low, high, log) => log ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low);
