// Handles: a value is pulled so that its point stays under the pointer.

// A handle of the page's scene, as the places of its values' sliders.
function grabbing(grip, handle, page) {
  const specs = handle.values.map(name => page.specs.get(name));
  const valuesAt = places => {
    const left = [...places], take = spec => left.splice(0, list(spec.default).length).map(x => fromSlider(x, spec));
    return Object.fromEntries(specs.map(spec => [spec.name, shaped(spec, take(spec))]));
  };
  pulling(grip, () => move => {
    const {left, top, width, height} = page.canvas.getBoundingClientRect();
    const pixels = many => page.stage.probes(many.map(places => ({...page.values, ...valuesAt(places)})))
      .map(points => project(page.stage.matrix, points[handle.probe], width, height));
    const places = specs.flatMap(spec => list(page.values[spec.name]).map(x => place(x, spec)));
    page.change(valuesAt(nearest(places, [move.clientX - left, move.clientY - top], pixels)));
  });
}

// The places, each 0 to 1, for which a point lies nearest to the pixel `to`, by damped least squares (Levenberg,
// Marquardt): of four steps the best. `pixels` gives the point's pixel for each of many lists of places.
function nearest(places, to, pixels) {
  const off = ([x, y]) => Math.hypot(to[0] - x, to[1] - y);
  let [here] = pixels([places]);
  for (let round = 0; round < 8 && off(here) >= 0.25; round++) {
    const nudges = places.map(x => x > 0.5 ? -1e-3 : 1e-3);
    const nudged = pixels(nudges.map((by, i) => places.map((x, k) => i === k ? x + by : x)));
    const slopes = nudged.map(([x, y], i) => [(x - here[0]) / nudges[i], (y - here[1]) / nudges[i]]);
    const [x, y] = [to[0] - here[0], to[1] - here[1]];
    const tried = [1e-4, 1e-2, 1, 100].map(damping => stepped(places, slopes, x, y, damping));
    const found = pixels(tried), best = found.reduce((a, pixel, i) => off(pixel) < off(found[a]) ? i : a, 0);
    if (!(off(found[best]) < off(here))) break;
    [places, here] = [tried[best], found[best]];
  }
  return places;
}

// One step: J'(JJ' + d)⁻¹ miss, which is (J'J + d)⁻¹J' miss with only two unknowns, as a pixel has two coordinates.
function stepped(places, slopes, x, y, damping) {
  const sum = (i, k) => slopes.reduce((total, slope) => total + slope[i] * slope[k], 0);
  const more = damping * (sum(0, 0) + sum(1, 1)) + 1e-9, a = sum(0, 0) + more, b = sum(0, 1), c = sum(1, 1) + more;
  const steps = slopes.map(([u, v]) => (u * (c * x - b * y) + v * (a * y - b * x)) / (a * c - b * b));
  const short = Math.min(1, 0.25 / Math.max(1e-12, ...steps.map(Math.abs)));
  return places.map((at, i) => within(at + short * steps[i], 0, 1));
}
