// The hand: it turns a camera, and pulls a handle so that its point stays under the pointer.

// Whatever is pulled: `begin` gives what follows the pointer.
function pulling(thing, begin) {
  thing.addEventListener("pointerdown", down => {
    thing.setPointerCapture(down.pointerId);
    thing.onpointermove = begin(down);
    thing.onpointerup = thing.onpointercancel = () => { thing.onpointermove = null; };
  });
}

function turning(canvas, camera, redraw) {
  pulling(canvas, down => {
    const {azimuth, elevation} = camera;
    return move => {
      camera.azimuth = ((azimuth - 0.35 * (move.clientX - down.clientX) + 540) % 360 + 360) % 360 - 180;
      camera.elevation = within(elevation + 0.35 * (move.clientY - down.clientY), -90, 90);
      redraw();
    };
  });
  canvas.addEventListener("wheel", wheel => { // a frame in a deck or a phone's page must still scroll
    if (document.activeElement !== canvas && !wheel.ctrlKey) return;
    wheel.preventDefault();
    camera.distance = within(camera.distance * 1.001 ** wheel.deltaY, 0.1, 50);
    redraw();
  }, {passive: false});
}

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

// The places, each 0 to 1, for which a point lies nearest to the pixel `to`: the best of a grid around them, which
// shrinks. `pixels` gives the point's pixel for each of many lists of places.
function nearest(places, to, pixels) {
  for (let width = 0.25; width > 1e-4; width /= 2) {
    let tried = [[]];
    for (const at of places)
      tried = tried.flatMap(some => [0, -0.5, 0.5, -1, 1].map(by => [...some, within(at + by * width, 0, 1)]));
    const off = pixels(tried).map(([x, y]) => Math.hypot(to[0] - x, to[1] - y));
    places = tried[off.indexOf(Math.min(...off))];
  }
  return places;
}
