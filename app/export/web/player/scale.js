// The scales of plots: round numbers, ends that keep still, and how a number is written at an axis.

// As many digits as it needs.
function tickText(value) {
  if (value === 0) return "0";
  const exponent = Math.floor(Math.log10(Math.abs(value)) + 1e-9);
  if (exponent > -4 && exponent < 5) return minus(digits(value));
  const mantissa = digits(+(value / 10 ** exponent).toPrecision(4));
  return minus(mantissa === "1" ? "" : `${mantissa}·`) + power(exponent);
}

function nice(value) { // the next round number upwards
  const scale = 10 ** Math.floor(Math.log10(value));
  return [1, 1.2, 1.5, 2, 3, 4, 5, 6, 8, 10].map(m => m * scale).find(x => x >= value * (1 - 1e-12));
}

// The end of a scale: it keeps still until it is passed, or far too wide.
const held = (end, most) => !(most > 0) ? end || 1 : most <= end && most >= 0.3 * end ? end : nice(most);
