// A camera that orbits its target, +z up: what app/camera.py computes.

const NEAR = 0.05, FAR = 100;

function cameraPosition({azimuth, elevation, distance, target}) {
  const towards = direction((90 - elevation) * RADIANS, azimuth * RADIANS);
  return target.map((x, i) => x + distance * towards[i]);
}

// From the world to the picture; `wide` is the lens with which a picture of 16:9 is filled.
function viewProjection({azimuth, elevation, distance, target, wide, field_of_view: usual}, aspect) {
  const scale = Math.min(1, aspect) / Math.tan((aspect > 1.7 && wide || usual) * RADIANS / 2);
  const depth = (FAR + NEAR) / (NEAR - FAR), lift = 2 * FAR * NEAR / (NEAR - FAR);
  return new DOMMatrix([scale / aspect, 0, 0, 0, 0, scale, 0, 0, 0, 0, depth, -1, 0, 0, lift, 0])
    .translate(0, 0, -distance).rotateAxisAngle(1, 0, 0, elevation - 90).rotateAxisAngle(0, 0, 1, -90 - azimuth)
    .translate(...target.map(x => -x));
}

// Where a point lies in a picture of this size: x, y in pixels from the top left, and w (behind the eye: w <= 0).
function project(matrix, [x, y, z], wide, high) {
  const seen = matrix.transformPoint({x, y, z});
  return [wide * (0.5 + 0.5 * seen.x / seen.w), high * (0.5 - 0.5 * seen.y / seen.w), seen.w];
}
