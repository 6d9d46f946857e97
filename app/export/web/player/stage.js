// Plays a scene: the constant arrays and programs of app/gpu/stage_text.py, drawn as app/gpu/stage.py draws them.

const NEAR = 0.05, FAR = 100;
const RADIANS = Math.PI / 180;

// A camera that orbits its target, +z up: what app/camera.py computes. The matrix is column by column.
function cameraPosition({azimuth, elevation, distance, target}) {
  const a = azimuth * RADIANS, e = elevation * RADIANS;
  return [target[0] + distance * Math.cos(e) * Math.cos(a), target[1] + distance * Math.cos(e) * Math.sin(a),
          target[2] + distance * Math.sin(e)];
}

function viewProjection(camera, aspect) {
  const eye = cameraPosition(camera), a = camera.azimuth * RADIANS;
  const forward = camera.target.map((x, i) => (x - eye[i]) / camera.distance);
  const side = [-Math.sin(a), Math.cos(a), 0];
  const up = [side[1] * forward[2], -side[0] * forward[2], side[0] * forward[1] - side[1] * forward[0]];
  const scale = Math.min(1, aspect) / Math.tan(camera.field_of_view * RADIANS / 2);
  const dot = p => p[0] * eye[0] + p[1] * eye[1] + p[2] * eye[2];
  const depth = (FAR + NEAR) / (NEAR - FAR), lift = 2 * FAR * NEAR / (NEAR - FAR), found = [];
  for (let i = 0; i < 4; i++) {
    const [x, y, z] = i < 3 ? [side[i], up[i], -forward[i]] : [-dot(side), -dot(up), dot(forward)];
    found.push(x * scale / aspect, y * scale, z * depth + (i < 3 ? 0 : lift), -z);
  }
  return found;
}

// Where a point lies in the picture: x, y from 0 to 1 from the top left, and w (behind the eye: w <= 0).
function project(matrix, [x, y, z]) {
  const [cx, cy, , w] = [0, 1, 2, 3].map(i => matrix[i] * x + matrix[4 + i] * y + matrix[8 + i] * z + matrix[12 + i]);
  return [0.5 + 0.5 * cx / w, 0.5 - 0.5 * cy / w, w];
}

class Stage {
  constructor(gpu, scene, data) {
    Object.assign(this, {gpu, scene, data, matrix: null, camera: scene.camera});
    this.begin();
  }

  begin() {
    this.arrays = new Map();
    this.uses = {};
    for (const [name, [vertex, fragment]] of Object.entries(this.scene.programs))
      this.uses[name] = this.gpu.program(vertex, fragment);
  }

  // The vertex array that feeds a program with a geometry: corners of `width` numbers, perhaps with indices.
  array(use, key, attribute, width, make) {
    const gl = this.gpu.gl, name = `${use} ${key}`;
    if (!this.arrays.has(name)) {
      const {corners, indices} = make(), array = gl.createVertexArray();
      gl.bindVertexArray(array);
      gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
      gl.bufferData(gl.ARRAY_BUFFER, corners, gl.STATIC_DRAW);
      const at = gl.getAttribLocation(this.uses[use].program, attribute);
      if (at >= 0) {
        gl.enableVertexAttribArray(at);
        gl.vertexAttribPointer(at, width, gl.FLOAT, false, 0, 0);
      }
      if (indices) {
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
        gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.STATIC_DRAW);
      }
      this.arrays.set(name, {array, count: indices ? indices.length : corners.length / width, indexed: !!indices});
    }
    return this.arrays.get(name);
  }

  render(made) {
    const gl = this.gpu.gl;
    gl.bindVertexArray(made.array);
    if (made.indexed) gl.drawElements(gl.TRIANGLES, made.count, gl.UNSIGNED_INT, 0);
    else gl.drawArrays(gl.TRIANGLES, 0, made.count);
  }

  // From where the picture is seen; words and drags follow the same matrix.
  aim(camera) {
    const {drawingBufferWidth: wide, drawingBufferHeight: high} = this.gpu.gl;
    Object.assign(this, {camera, matrix: viewProjection(camera, wide / high)});
  }

  draw(values, theme, fine = true, lineScale = 1) {
    const gl = this.gpu.gl, {dots} = this.scene, size = [gl.drawingBufferWidth, gl.drawingBufferHeight];
    this.line = theme.line * Math.max(0.75, Math.min(...size) / 620) * lineScale;
    this.given = {...values, ...this.data(values), view_projection: this.matrix, viewport: size,
                  camera_position: cameraPosition(this.camera), palette: theme.palette, background: theme.linear,
                  colormap_stops: theme.stops, dot_size: (2 + this.line) * (dots ? dots.size : 1)};
    for (const [name, use] of Object.entries(this.uses))
      if (name !== "probe" && name !== "anchor") this.gpu.give(this.gpu.use(use), this.given);
    gl.clearColor(...theme.srgb, 1);
    this.gpu.into(fine, () => this.paint(values));
  }

  // Of the last picture, as it was drawn: pixels that are not a number, infinite, negative.
  faults(values) {
    this.gpu.gl.clearColor(0, 0, 0, 0);
    return this.gpu.faults(() => this.paint(values));
  }

  // Opaque surfaces, then dots and marks, then what one looks through.
  paint(values) {
    const gl = this.gpu.gl, {surfaces, marks, dots} = this.scene;
    gl.depthMask(true);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.disable(gl.BLEND);
    surfaces.forEach((surface, i) => surface.opacity >= 1 && this.surface(surface, i));
    gl.enable(gl.BLEND);
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    if (dots) {
      this.gpu.give(this.gpu.use(this.uses.dots), this.data(values));
      gl.bindVertexArray(null);
      gl.drawArrays(gl.POINTS, 0, typeof dots.count === "string" ? Math.round(values[dots.count]) : dots.count);
    }
    marks.forEach((mark, i) => this.mark(mark, i));
    gl.depthMask(false);
    surfaces.forEach((surface, i) => surface.opacity >= 1 || this.surface(surface, i));
    gl.depthMask(true);
    gl.bindVertexArray(null);
  }

  surface(surface, i) {
    const name = surface.mesh ? "mesh" : "surface", use = this.gpu.use(this.uses[name]);
    this.gpu.give(use, {...this.data(this.given), surface: i, opacity: surface.opacity});
    if (surface.mesh) {
      const {triangles} = this.given.triangles;
      this.render(this.array(name, `mesh ${triangles.length} ${triangles[0]}`, "stage_position", 3,
                             () => ({corners: triangles})));
    } else {
      this.render(this.array(name, `grid ${surface.cells}`, "stage_st", 2, () => grid(surface.cells)));
    }
  }

  mark(mark, i) {
    const use = this.gpu.use(this.uses.mark), width = this.line * mark.width;
    const steps = mark.line === 0 && mark.tip !== 1 ? 0 : mark.segments === 1 ? 1 : 16;
    this.gpu.give(use, {...this.data(this.given), mark: i, measure_steps: steps, length_steps: mark.tip === 1 ? steps : 0,
                        mark_colour: mark.colour, dash: mark.line, tip: mark.tip, line_width: width,
                        tip_size: mark.tip_size * width});
    this.render(this.array("mark", `pen ${mark.segments} ${mark.tip > 0}`, "stage_corner", 3,
                           () => pen(mark.segments, mark.tip > 0)));
  }

  // Where words and handles stand, in the world: {probes, anchors}; all of them come back in one reading.
  places(values) {
    const {labels, handles, marks} = this.scene, uniforms = {...values, ...this.data(values)};
    const last = Math.max(-1, ...labels.map(one => one.probe), ...handles.map(one => one.probe));
    const tasks = last < 0 ? [] : [{program: this.uses.probe, uniforms, count: last + 1}];
    const named = marks.map((mark, i) => [mark, i]).filter(([mark]) => mark.label);
    for (const [mark, i] of named)
      tasks.push({program: this.uses.anchor, uniforms: {...uniforms, mark: i, mark_t: mark.label_at}, count: 1});
    const found = tasks.length ? this.gpu.transform(tasks) : [];
    const probes = last < 0 ? [] : Array.from({length: last + 1}, (_, i) => found[0].slice(4 * i, 4 * i + 3));
    return {probes, anchors: named.map(([mark], i) => [mark, found[i + (last < 0 ? 0 : 1)].slice(0, 3)])};
  }

  probe(i, values) {
    const uniforms = {...values, ...this.data(values)};
    return this.gpu.transform([{program: this.uses.probe, uniforms, count: i + 1}])[0].slice(4 * i, 4 * i + 3);
  }
}

// Corners of a grid over the unit square and its triangles.
function grid([across, up]) {
  const corners = new Float32Array(2 * (across + 1) * (up + 1)), indices = new Uint32Array(6 * across * up);
  let at = 0;
  for (let j = 0; j <= up; j++) for (let i = 0; i <= across; i++) corners.set([i / across, j / up], 2 * (j * (across + 1) + i));
  for (let j = 0; j < up; j++) {
    for (let i = 0; i < across; i++, at += 6) {
      const a = j * (across + 1) + i, d = a + across + 1;
      indices.set([a, a + 1, d + 1, a, d + 1, d], at);
    }
  }
  return {corners, indices};
}

// Corners of a line of some pieces, and of the square its tip is drawn in.
function pen(segments, tip) {
  const corners = [], indices = [];
  for (let i = 0; i <= segments; i++) corners.push(i / segments, -1, 0, i / segments, 1, 0);
  for (let i = 0; i < segments; i++) indices.push(...[0, 1, 3, 0, 3, 2].map(k => 2 * i + k));
  if (tip) {
    corners.push(0, -1, 1, 1, -1, 1, 1, 1, 1, 0, 1, 1);
    indices.push(...[0, 1, 2, 0, 2, 3].map(k => 2 * (segments + 1) + k));
  }
  return {corners: new Float32Array(corners), indices: new Uint32Array(indices)};
}
