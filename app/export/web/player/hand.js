// The hand: it pulls things, and turns a camera.

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
