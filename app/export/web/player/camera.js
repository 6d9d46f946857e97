// A camera that orbits its target, +z up: what app/camera.py computes.

const NEAR = 0.05, FAR = 100;

function cameraPosition({azimuth, elevation, distance, target: [x, y, z]}) {
  const a = azimuth * RADIANS, e = elevation * RADIANS, out = distance * Math.cos(e);
  return [x + out * Math.cos(a), y + out * Math.sin(a), z + distance * Math.sin(e)];
}

// From the world to the picture, column by column; `wide` is the lens with which a picture of 16:9 is filled.
function viewProjection(camera, aspect) {
  const eye = cameraPosition(camera), a = camera.azimuth * RADIANS;
  const forward = camera.target.map((x, i) => (x - eye[i]) / camera.distance);
  const side = [-Math.sin(a), Math.cos(a), 0];
  const up = [side[1] * forward[2], -side[0] * forward[2], side[0] * forward[1] - side[1] * forward[0]];
  const lens = aspect > 1.7 && camera.wide || camera.field_of_view;
  const scale = Math.min(1, aspect) / Math.tan(lens * RADIANS / 2);
  const along = p => p[0] * eye[0] + p[1] * eye[1] + p[2] * eye[2];
  const depth = (FAR + NEAR) / (NEAR - FAR), lift = 2 * FAR * NEAR / (NEAR - FAR);
  const columns = [0, 1, 2].map(i => [side[i], up[i], -forward[i], 0]);
  columns.push([-along(side), -along(up), along(forward), lift]);
  return columns.flatMap(([x, y, z, more]) => [x * scale / aspect, y * scale, z * depth + more, -z]);
}

// Where a point lies in a picture of this size: x, y in pixels from the top left, and w (behind the eye: w <= 0).
function project(matrix, [x, y, z], wide, high) {
  const [cx, cy, , w] = [0, 1, 2, 3].map(i => matrix[i] * x + matrix[4 + i] * y + matrix[8 + i] * z + matrix[12 + i]);
  return [wide * (0.5 + 0.5 * cx / w), high * (0.5 - 0.5 * cy / w), w];
}
