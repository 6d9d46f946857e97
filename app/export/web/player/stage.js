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
    this.given = {...values, ...this.data(values), view_projection: this.matrix, viewport: gpu.size,
                  camera_position: cameraPosition(this.camera), palette: theme.palette, background: theme.linear,
                  colormap_stops: theme.stops, dot_size: (2 + this.line) * (dots ? dots.size : 1)};
    for (const program of this.pictured(values)) gpu.use(program, this.given);
    gpu.gl.clearColor(...theme.srgb, 1);
    gpu[fine ? "fine" : "coarse"](() => this.paint());
  }

  // Of the last picture, as it was drawn: pixels that are not a number, infinite, negative.
  faults() {
    this.gpu.gl.clearColor(0, 0, 0, 0);
    return this.gpu.faults(() => this.paint());
  }

  // Opaque surfaces, then dots and marks, then what one looks through.
  paint() {
    const {gpu, gpu: {gl}, scene: {surfaces, marks, dots}} = this;
    gl.depthMask(true);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.disable(gl.BLEND);
    surfaces.forEach((surface, i) => surface.opacity >= 1 && this.surface(surface, i));
    gl.enable(gl.BLEND);
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    if (dots) {
      gpu.use(this.uses.dots, {});
      gl.drawArrays(gl.POINTS, 0, typeof dots.count === "string" ? Math.round(this.given[dots.count]) : dots.count);
    }
    marks.forEach((mark, i) => this.mark(mark, i));
    gl.depthMask(false);
    surfaces.forEach((surface, i) => surface.opacity >= 1 || this.surface(surface, i));
    gl.depthMask(true);
  }

  surface({mesh, cells, opacity}, i) {
    const data = this.given.triangles;
    this.gpu.use(this.uses[mesh ? "mesh" : "surface"], {surface: i, opacity});
    if (mesh) this.gpu.triangles(data, () => data.corners);
    else this.gpu.triangles(`grid ${cells}`, () => grid(cells, (s, t) => [s, t]));
  }

  mark(mark, i) {
    const width = this.line * mark.width, tip = mark.tip > 0;
    const steps = mark.line === 0 && mark.tip !== 1 ? 0 : mark.segments === 1 ? 1 : 16;
    this.gpu.use(this.uses.mark, {mark: i, measure_steps: steps, length_steps: mark.tip === 1 ? steps : 0,
                                  mark_colour: mark.colour, dash: mark.line, tip: mark.tip, line_width: width,
                                  tip_size: mark.tip_size * width});
    this.gpu.triangles(`pen ${mark.segments} ${tip}`, () => pen(mark.segments, tip));
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

const fours = numbers => Array.from({length: numbers.length / 4}, (_, i) => numbers.subarray(4 * i, 4 * i + 4));

// Triangles over a grid of cells, with `corner` where s and t go from 0 to 1.
function grid([across, up], corner) {
  const corners = [], indices = [];
  for (let j = 0; j <= up; j++) for (let i = 0; i <= across; i++) corners.push(corner(i / across, j / up));
  for (let j = 0; j < up; j++) {
    for (let i = 0; i < across; i++) {
      const a = j * (across + 1) + i, d = a + across + 1;
      indices.push(a, a + 1, d + 1, a, d + 1, d);
    }
  }
  return [corners, indices];
}

// A line of some pieces, and perhaps the square its tip is drawn in.
function pen(segments, tip) {
  const [line, pieces] = grid([segments, 1], (t, side) => [t, 2 * side - 1, 0]);
  const [square, halves] = tip ? grid([1, 1], (s, t) => [s, 2 * t - 1, 1]) : [[], []];
  return [[...line, ...square], [...pieces, ...halves.map(k => k + line.length)]];
}
