// Values as sliders, fields and links have them: what app/typed.py reads and writes.

const RADIANS = Math.PI / 180;
const digits = value => String(Number(value.toPrecision(6))); // as a link has them
const times = (count, make) => Array.from({length: count}, (_, i) => make(i));
const list = value => Array.isArray(value) || ArrayBuffer.isView(value) ? value : [value];
const within = (x, low, high) => Math.min(Math.max(x, low), high);
const shaped = (spec, numbers) => Array.isArray(spec.default) ? numbers : numbers[0];

// Where a value lies between low and high: 0 to 1.
const place = (value, {low, high, log}) =>
  log ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low);

function fromSlider(at, {low, high, log, whole}) {
  const value = at >= 1 ? high : log ? low * (high / low) ** at : low + at * (high - low);
  return whole ? Math.round(value) : value;
}

// In screen units, as a link and a field have it.
function typed(spec, value, show = digits) {
  return spec.choices[value] || list(value).map(x => show(spec.angle ? x / RADIANS : x)).join(",");
}

// What was typed, within its range; null if it is no value.
function entered(spec, text) {
  const word = spec.choices.indexOf(text.trim().toLowerCase());
  if (word >= Math.max(0, spec.low) && word <= spec.high) return word;
  const numbers = text.split(",").map(part => {
    const [, number, unit] = /^\s*(.*?)\s*(deg|rad|°)?\s*$/.exec(part.replace("−", "-"));
    const value = number === "" ? NaN : Number(number) * (spec.angle && unit !== "rad" ? RADIANS : 1);
    return spec.whole ? Math.round(value) : within(value, spec.low, spec.high);
  });
  const fits = numbers.length === list(spec.default).length && numbers.every(x => x >= spec.low && x <= spec.high);
  return fits ? shaped(spec, numbers) : null;
}

// The value that a slider, field or radio button asks for; `k` is the slider's number among those of the value.
function asked(spec, input, k, now) {
  if (input.type === "radio") return +input.value;
  if (input.type === "text") return entered(spec, input.value) ?? now;
  return shaped(spec, list(now).map((x, i) => i === k ? fromSlider(+input.value, spec) : x));
}

// Put a value into its controls: sliders and their field, or radio buttons.
function show(spec, value) {
  const short = x => digits(+x.toPrecision(4));
  document.getElementsByName(spec.name).forEach((input, k) => {
    if (input.type === "radio") input.checked = +input.value === value;
    else if (input.type === "text") {
      if (input !== document.activeElement) input.value = typed(spec, value, short).replace(/,/g, ", ");
    } else {
      input.value = place(list(value)[k], spec);
      input.setAttribute("aria-valuetext", withUnit(typed(spec, list(value)[k], short), spec.unit));
    }
  });
}
