// The built-in meshes, by the formulas of app/shapes.py in float64, and their normals, as app/mesh_edges.py has them.

const TURN = 2 * Math.PI;
const unit = p => p.map(x => x / Math.hypot(...p));
const plus = (a, b, share = 1) => a.map((x, i) => x + share * b[i]);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

// Two triangles between each two neighbours of rows that close to rings; the corners are numbered row by row.
function quads(rows, around) {
  const pair = (i, j) => {
    const a = i * around + j, d = i * around + (j + 1) % around;
    return [[a, a + around, d + around], [a, d + around, d]];
  };
  return times(rows, i => times(around, j => pair(i, j)).flat()).flat();
}

function icosphere(splits) {
  const g = (1 + Math.sqrt(5)) / 2, corners = [[-1, g, 0], [1, g, 0], [-1, -g, 0], [1, -g, 0], [0, -1, g], [0, 1, g],
    [0, -1, -g], [0, 1, -g], [g, 0, -1], [g, 0, 1], [-g, 0, -1], [-g, 0, 1]];
  let faces = [[0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11], [1, 5, 9], [5, 11, 4], [11, 10, 2],
    [10, 7, 6], [7, 1, 8], [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8], [3, 8, 9], [4, 9, 5], [2, 4, 11], [6, 2, 10],
    [8, 6, 7], [9, 8, 1]];
  const middles = {};
  const middle = (i, j) => middles[[Math.min(i, j), Math.max(i, j)]] ??=
    corners.push(plus(corners[i], corners[j]).map(x => x / 2)) - 1;
  while (splits--)
    faces = faces.flatMap(([a, b, c]) => {
      const [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
      return [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]];
    });
  return [corners.map(unit), faces];
}

function trefoil(along, around) {
  const big = 0.64, small = 0.36;
  const normal = t => [Math.cos(3 * t) * Math.cos(2 * t), Math.cos(3 * t) * Math.sin(2 * t), Math.sin(3 * t)];
  const centre = t => plus([big * Math.cos(2 * t), big * Math.sin(2 * t), 0], normal(t), small);
  const tangent = t => {
    const c = Math.cos(2 * t), s = Math.sin(2 * t), turn = 2 * (big + small * Math.cos(3 * t));
    const out = -3 * small * Math.sin(3 * t);
    return [-turn * s + out * c, turn * c + out * s, 3 * small * Math.cos(3 * t)];
  };
  const fine = times(4001, i => TURN * i / 4000), path = [0];
  for (let i = 1; i < fine.length; i++)
    path.push(path[i - 1] + Math.hypot(...plus(centre(fine[i]), centre(fine[i - 1]), -1)));
  let at = 0;
  const corners = times(along, i => { // equal steps of length
    const wanted = i / along * path.at(-1);
    while (path[at + 1] < wanted) at++;
    const t = fine[at] + (wanted - path[at]) / (path[at + 1] - path[at]) * (fine[at + 1] - fine[at]);
    const up = normal(t), side = cross(up, unit(tangent(t)));
    return times(around, j => TURN * j / around).map(a =>
      plus(plus(centre(t), up, 0.19 * Math.cos(a)), side, 0.19 * Math.sin(a)));
  }).flat();
  return [corners, quads(along, around).map(face => face.map(corner => corner % corners.length))];
}

function bowl(bands, around) {
  const rim = 50 * RADIANS, last = (bands - 1) * around;
  const corners = times(bands * around, k => {
    const theta = rim + (Math.PI - rim) * Math.floor(k / around) / bands, phi = TURN * (k % around) / around;
    return [Math.sin(theta) * Math.cos(phi), Math.sin(theta) * Math.sin(phi), Math.cos(theta)];
  });
  const pole = times(around, j => [last + j, last + around, last + (j + 1) % around]);
  return [[...corners, [0, 0, -1]], [...quads(bands - 1, around), ...pole]];
}

function cube(side) {
  const corners = times(8, i => [i >> 2, i >> 1 & 1, i & 1].map(x => (x - 0.5) * side));
  const sides = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];
  return [corners, sides.flatMap(([a, b, c, d]) => [[a, b, c], [a, c, d]])];
}

// A unit normal for each corner of each face: the mean of the faces there that are about as steep, each by its area.
function cornerNormals(corners, faces) {
  const flat = faces.map(([a, b, c]) => cross(plus(corners[b], corners[a], -1), plus(corners[c], corners[a], -1)));
  const steep = flat.map(unit), meet = corners.map(() => []);
  faces.forEach((face, f) => face.forEach(corner => meet[corner].push(f)));
  const alike = (f, other) => f === other || steep[f].reduce((sum, x, i) => sum + x * steep[other][i], 0) > 0.7;
  return faces.flatMap((face, f) => face.map(corner => unit(meet[corner].filter(other => alike(f, other))
    .reduce((sum, other) => plus(sum, flat[other]), [0, 0, 0]))));
}

const SHAPES = {sphere: () => icosphere(4), knot: () => trefoil(168, 20), bowl: () => bowl(40, 96),
                cube: () => cube(1.5)};
const made = {};

// As a stage draws it: [points of all triangles, in order], and the texture a twin reads, as in app/gpu/evaluate.py.
function packed(points) {
  const columns = 768, rows = Math.ceil(points.length / columns);
  const filled = new Float32Array(3 * columns * rows).fill(1); // triangles of no area subtend nothing
  filled.set(points.flat());
  return {format: "RGB32F", columns, rows, numbers: filled, corners: [points, points.map((_, i) => i)]};
}

function mesh(name) {
  if (!made[name]) {
    const [corners, faces] = SHAPES[name]();
    made[name] = {triangles: packed(faces.flatMap(face => face.map(corner => corners[corner]))),
                  normals: packed(cornerNormals(corners, faces))};
  }
  return made[name];
}
