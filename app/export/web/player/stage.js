// Plays a scene: the constant arrays and programs of app/gpu/stage_text.py, drawn as app/gpu/stage.py draws them.

class Stage {
  constructor(gpu, scene, data) {
    Object.assign(this, {gpu, scene, data, camera: {...scene.camera}, matrix: null});
    this.begin();
  }

  // What hangs on the context; called again when a lost one comes back.
  begin() { this.made = new Map(); }

  // A program at these values: what is decided when it is compiled is a constant in the place of `uniform int kind;`.
  program(name, values) {
    const {decided, programs} = this.scene, key = [name, ...decided.map(one => values[one])].join();
    if (!this.made.has(key)) {
      const constant = (text, one) => text.replace(`uniform int ${one};`, `const int ${one} = ${values[one]};`);
      this.made.set(key, this.gpu.program(...programs[name].map(text => decided.reduce(constant, text))));
    }
    return this.made.get(key);
  }

  // Those of the picture; asked for before the first is used, they compile side by side.
  pictured(values) {
    const names = ["surface", "mesh", "dots", "mark"].filter(name => name in this.scene.programs);
    this.uses = Object.fromEntries(names.map(name => [name, this.program(name, values)]));
    return Object.values(this.uses);
  }

  // As many pixels as the canvas has on the screen, or a share of them, seen by the camera; how many to a CSS pixel.
  aim(share = 1) {
    const {canvas} = this.gpu.gl, scale = share * Math.min(devicePixelRatio || 1, 2);
    const width = Math.round(canvas.clientWidth * scale), height = Math.round(canvas.clientHeight * scale);
    if (width && height && (canvas.width !== width || canvas.height !== height)) Object.assign(canvas, {width, height});
    this.matrix = viewProjection(this.camera, canvas.width / canvas.height);
    return scale;
  }

  draw(values, theme, fine = true, lineScale = 1) {
    const {gpu, scene: {dots}} = this;
    this.line = theme.line * Math.max(0.75, Math.min(...gpu.size) / 620) * lineScale;
    this.given = {...values, ...this.data(values), view_projection: this.matrix.toFloat32Array(), viewport: gpu.size,
                  camera_position: cameraPosition(this.camera), palette: theme.palette, background: theme.linear,
                  colormap_stops: theme.stops, dot_size: (2 + this.line) * (dots ? dots.size : 1)};
    for (const program of this.pictured(values)) gpu.use(program, this.given);
    gpu.gl.clearColor(...theme.srgb, 1);
    if (fine) gpu.fine(() => this.paint());
    else this.paint();
  }

  // Of the last picture, as it was drawn: pixels that are not a number, infinite, negative.
  faults() {
    this.gpu.gl.clearColor(0, 0, 0, 0);
    return this.gpu.faults(() => this.paint());
  }

  // Opaque surfaces, then dots and marks, then what one looks through.
  paint() {
    const {gpu, gpu: {gl}, scene: {surfaces, marks, dots}} = this;
    gl.viewport(0, 0, ...gpu.size);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.disable(gl.BLEND);
    for (const one of surfaces.filter(({opacity}) => opacity >= 1)) this.surface(one);
    gl.enable(gl.BLEND);
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    if (dots) {
      gpu.use(this.uses.dots, {});
      gl.drawArrays(gl.POINTS, 0, typeof dots.count === "string" ? Math.round(this.given[dots.count]) : dots.count);
    }
    for (const one of marks) this.mark(one);
    gl.depthMask(false);
    for (const one of surfaces.filter(({opacity}) => opacity < 1)) this.surface(one);
    gl.depthMask(true);
  }

  surface({mesh, cells, ...uniforms}) {
    const data = this.given.triangles;
    this.gpu.use(this.uses[mesh ? "mesh" : "surface"], uniforms);
    if (mesh) this.gpu.triangles(data, () => data.corners);
    else this.gpu.triangles(`grid ${cells}`, () => grid(cells, (s, t) => [s, t]));
  }

  mark({segments, width, tip_size, ...uniforms}) {
    const line = this.line * width, tip = uniforms.tip > 0;
    this.gpu.use(this.uses.mark, {...uniforms, line_width: line, tip_size: tip_size * line});
    this.gpu.triangles(`pen ${segments} ${tip}`, () => pen(segments, tip));
  }

  // Where named marks and then probes stand, in the world.
  places(values) {
    const {named, probes} = this.scene, tasks = named.map(one => this.task("anchor", {...values, ...one}, 1));
    if (probes) tasks.push(this.task("probe", values, probes));
    return this.gpu.points(tasks).flatMap(fours);
  }

  // Where the probes alone stand, at many values at once.
  probes(many) {
    return this.gpu.points(many.map(values => this.task("probe", values, this.scene.probes))).map(fours);
  }

  task(name, values, count) {
    const uniforms = {...values, ...this.data(values)};
    return {program: this.program(name, values), uniforms, inputs: [], count, returns: "vec4"};
  }
}

const fours = numbers => times(numbers.length / 4, i => numbers.subarray(4 * i, 4 * i + 4));

// Triangles over a grid of cells, with `corner` where s and t go from 0 to 1.
function grid([across, up], corner) {
  const wide = across + 1, cell = a => [a, a + 1, a + wide + 1, a, a + wide + 1, a + wide];
  const corners = times(wide * (up + 1), k => corner(k % wide / across, Math.floor(k / wide) / up));
  return [corners, times(across * up, k => cell(k + Math.floor(k / across))).flat()];
}

// A line of some pieces, and perhaps the square its tip is drawn in.
function pen(segments, tip) {
  const [line, pieces] = grid([segments, 1], (t, side) => [t, 2 * side - 1, 0]);
  const [square, halves] = tip ? grid([1, 1], (s, t) => [s, 2 * t - 1, 1]) : [[], []];
  return [[...line, ...square], [...pieces, ...halves.map(k => k + line.length)]];
}
