// Drawings as SVG: lines, words, and a frame with a grid and numbers at it.

function svg(name, attributes, ...children) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

// Through points [x, y], broken where a number is not finite.
function line(points, attributes) {
  const ok = points.map(point => point.every(Number.isFinite));
  const path = points.map(([x, y], i) => ok[i] ? `${ok[i - 1] ? "L" : "M"}${x.toFixed(2)} ${y.toFixed(2)}` : "");
  return svg("path", {d: path.join(""), fill: "none", ...attributes});
}

const words = (x, y, text, anchor = "middle", attributes = {}) =>
  svg("text", {x, y, "text-anchor": anchor, "dominant-baseline": "central", ...attributes}, text);
const dot = ([cx, cy], colour) => svg("circle", {cx, cy, r: 6, style: `fill:${colour}`, class: "now"});

// An empty drawing that fills its box.
function drawing(box, title) {
  const wide = Math.max(box.clientWidth, 200), high = Math.max(box.clientHeight, 150);
  const picture = svg("svg", {viewBox: `0 0 ${wide} ${high}`, role: "img", "aria-label": title});
  box.replaceChildren(picture);
  return {picture, wide, high};
}

// One with axes {low, high, log, degrees, whole, title}; `at` says where a point of theirs lies.
function graph(box, title, across, up) {
  const {picture, wide, high} = drawing(box, title), left = 56, right = 16, top = 8, below = 42;
  const at = (x, y) => [left + (wide - left - right) * place(x, across),
                        high - below - (high - top - below) * place(y, up)];
  for (const y of ticks(up, high / 42))
    picture.append(line([at(across.low, y), at(across.high, y)], {class: "grid"}),
                   words(left - 6, at(across.low, y)[1], tickText(y), "end"));
  for (const x of ticks(across, wide / 72))
    picture.append(line([at(x, up.low), at(x, up.high)], {class: "grid"}),
                   words(at(x, up.low)[0], high - below + 13, tickText(x)));
  picture.append(words((left + wide - right) / 2, high - 8, across.title));
  return {picture, at};
}

// Round numbers along an axis, about `most` of them.
function ticks({low, high, log, degrees, whole}, most) {
  const from = log ? Math.log10(low) : low, to = log ? Math.log10(high) : high, wide = to - from;
  const rough = wide / most, scale = 10 ** Math.floor(Math.log10(rough));
  const steps = degrees && wide >= 40 ? [10, 15, 30, 45, 90, 180] : [1, 2, 5, 10].map(m => m * scale);
  const step = Math.max(whole || log ? 1 : 0, steps.find(x => x >= rough * 0.999) || 180);
  const found = [], between = log && wide < 1.8 ? [1, 2, 5] : [1];
  for (let k = Math.floor(from / step); k <= to / step + 1e-6; k++)
    found.push(...(log ? between.map(m => m * 10 ** (k * step)) : [+(k * step).toPrecision(12)]));
  return found.filter(x => Math.abs(place(x, {low, high, log}) - 0.5) < 0.5 + 1e-6);
}
