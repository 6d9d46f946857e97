// One WebGL2 context: programs of the course's own GLSL, their uniforms, constant textures, pictures and points.

const HOW = {antialias: false}; // soft edges are ours, so that a moving picture can do without
const NO_PIXELS = "#version 300 es\nprecision highp float;\nvoid main() {}\n";
const CORNERS = ["stage_position", "stage_corner"]; // what programs of the stage read, all at place 0
const WIDTH = {int: 1, float: 1, vec2: 2, vec3: 3, vec4: 4};

class Gpu {
  constructor(canvas) {
    this.gl = canvas.getContext("webgl2", HOW);
    this.begin();
  }

  // What a context holds; called again when a lost one comes back.
  begin() {
    Object.assign(this, {programs: new Map(), textures: new Map(), arrays: new Map(), inputs: []});
    this.answers = this.gl.createBuffer();
  }

  get lost() { return this.gl.isContextLost(); }

  get size() { return [this.gl.drawingBufferWidth, this.gl.drawingBufferHeight]; }

  // --- programs ------------------------------------------------------------------------------------------------------
  // A program with its uniforms, which are asked for when it is first used: until then programs compile side by side.
  program(vertex, fragment = NO_PIXELS) {
    const key = fragment === NO_PIXELS ? vertex : vertex + fragment; // a sum of texts is hashed anew each time
    if (!this.programs.has(key)) {
      const {gl} = this, program = gl.createProgram();
      for (const [type, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
        const shader = gl.createShader(type);
        gl.shaderSource(shader, text);
        gl.compileShader(shader);
        gl.attachShader(program, shader);
      }
      for (const name of CORNERS) gl.bindAttribLocation(program, 0, name);
      if (fragment === NO_PIXELS) gl.transformFeedbackVaryings(program, ["value"], gl.INTERLEAVED_ATTRIBS);
      gl.linkProgram(program);
      this.programs.set(key, {program, uniforms: null});
    }
    return this.programs.get(key);
  }

  // Make a program the current one, and set its uniforms among these values.
  use(one, values) {
    const {gl} = this;
    one.uniforms ||= this.uniforms(one.program);
    gl.useProgram(one.program);
    for (const [name, set] of one.uniforms) if (values[name] !== undefined) set(values[name]);
  }

  uniforms(program) {
    const {gl} = this, found = new Map();
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !this.lost) {
      const said = gl.getAttachedShaders(program).map(shader => gl.getShaderInfoLog(shader)).join(" ");
      throw new Error(`a program of this page does not link: ${said} ${gl.getProgramInfoLog(program)}`);
    }
    const count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) || 0; // none of a lost one
    for (let i = 0; i < count; i++) {
      const {name, type} = gl.getActiveUniform(program, i);
      found.set(name.replace("[0]", ""), this.setter(type, gl.getUniformLocation(program, name)));
    }
    return found;
  }

  setter(type, at) {
    const {gl} = this;
    if (type === gl.SAMPLER_2D) return data => gl.uniform1i(at, this.texture(data));
    if (type === gl.FLOAT_MAT4) return value => gl.uniformMatrix4fv(at, false, value);
    const how = {[gl.INT]: "uniform1iv", [gl.FLOAT]: "uniform1fv", [gl.FLOAT_VEC2]: "uniform2fv",
                 [gl.FLOAT_VEC3]: "uniform3fv", [gl.FLOAT_VEC4]: "uniform4fv"}[type];
    return value => gl[how](at, list(value));
  }

  // The unit where constant numbers {format, columns, rows, numbers} can be fetched: each has one of its own for good.
  texture(data) {
    if (!this.textures.has(data)) {
      const {gl} = this, unit = this.textures.size;
      const [form, type] = {R32F: [gl.RED, gl.FLOAT], RGB32F: [gl.RGB, gl.FLOAT],
                            RGBA8: [gl.RGBA, gl.UNSIGNED_BYTE]}[data.format];
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl[data.format], data.columns, data.rows, 0, form, type, data.numbers);
      this.textures.set(data, unit);
    }
    return this.textures.get(data);
  }

  // --- pictures ------------------------------------------------------------------------------------------------------
  // Draw triangles of [corners, indices into them]; what `make` makes is kept under its key.
  triangles(key, make) {
    const {gl} = this;
    if (!this.arrays.has(key)) {
      const [corners, indices] = make(), array = gl.createVertexArray();
      gl.bindVertexArray(array);
      gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
      gl.bufferData(gl.ARRAY_BUFFER, Float32Array.from(corners.flat()), gl.STATIC_DRAW);
      gl.enableVertexAttribArray(0);
      gl.vertexAttribPointer(0, corners[0].length, gl.FLOAT, false, 0, 0);
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, Uint32Array.from(indices), gl.STATIC_DRAW);
      this.arrays.set(key, {array, count: indices.length});
    }
    const {array, count} = this.arrays.get(key);
    gl.bindVertexArray(array);
    gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 0);
    gl.bindVertexArray(null);
  }

  // What `paint` draws, on the canvas through four samples a pixel.
  fine(paint) {
    const {gl} = this, all = [0, 0, ...this.size];
    this.aside(4, 1, () => {
      paint();
      gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, null);
      gl.blitFramebuffer(...all, ...all, gl.COLOR_BUFFER_BIT, gl.NEAREST);
    });
  }

  // How many pixels are not a number, infinite, negative: every program of pixels writes that beside the colour.
  faults(paint) {
    const {gl, size: [wide, high]} = this, seen = new Uint8Array(4 * wide * high), found = [0, 0, 0];
    this.aside(0, 2, () => {
      gl.drawBuffers([gl.COLOR_ATTACHMENT0, gl.COLOR_ATTACHMENT1]);
      paint();
      gl.readBuffer(gl.COLOR_ATTACHMENT1);
      gl.readPixels(0, 0, wide, high, gl.RGBA, gl.UNSIGNED_BYTE, seen);
    });
    seen.forEach((x, i) => { if (x && i % 4 < 3) found[i % 4]++; });
    return found;
  }

  // Do `work` in a picture of its own, as large as the canvas: with some samples a pixel, and so many colours.
  aside(samples, colours, work) {
    const {gl, size} = this, frame = gl.createFramebuffer();
    const places = [gl.DEPTH_ATTACHMENT, gl.COLOR_ATTACHMENT0, gl.COLOR_ATTACHMENT1].slice(0, 1 + colours);
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    const parts = places.map(place => {
      const part = gl.createRenderbuffer(), format = place === gl.DEPTH_ATTACHMENT ? gl.DEPTH_COMPONENT24 : gl.RGBA8;
      gl.bindRenderbuffer(gl.RENDERBUFFER, part);
      gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, format, ...size);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, place, gl.RENDERBUFFER, part);
      return part;
    });
    work();
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.deleteFramebuffer(frame);
    for (const part of parts) gl.deleteRenderbuffer(part);
  }

  // --- points --------------------------------------------------------------------------------------------------------
  // The numbers that programs without pixels give at points: tasks are {program, uniforms, inputs, count, returns}.
  // All of them are read back at once, because waiting for the answer is what takes the time.
  points(tasks) {
    const {gl, answers} = this, starts = [0];
    for (const {count, returns} of tasks) starts.push(starts.at(-1) + 4 * count * WIDTH[returns]);
    const found = new ArrayBuffer(starts.at(-1));
    if (!tasks.length) return [];
    gl.bindBuffer(gl.TRANSFORM_FEEDBACK_BUFFER, answers);
    gl.bufferData(gl.TRANSFORM_FEEDBACK_BUFFER, found.byteLength, gl.STREAM_READ);
    gl.enable(gl.RASTERIZER_DISCARD);
    tasks.forEach(({program, uniforms, inputs, count}, i) => {
      this.use(program, uniforms);
      for (const one of inputs) this.input(program.program, one);
      gl.bindBufferRange(gl.TRANSFORM_FEEDBACK_BUFFER, 0, answers, starts[i], starts[i + 1] - starts[i]);
      gl.beginTransformFeedback(gl.POINTS);
      gl.drawArrays(gl.POINTS, 0, count);
      gl.endTransformFeedback();
    });
    gl.disable(gl.RASTERIZER_DISCARD);
    gl.getBufferSubData(gl.TRANSFORM_FEEDBACK_BUFFER, 0, new Uint8Array(found));
    return tasks.map(({count, returns}, i) =>
      new (returns === "int" ? Int32Array : Float32Array)(found, starts[i], count * WIDTH[returns]));
  }

  // An argument: one value for all points, or a typed array with one for each.
  input(program, {name, type, value}) {
    const {gl} = this, at = gl.getAttribLocation(program, name), whole = type === "int";
    if (at < 0) return;
    if (!ArrayBuffer.isView(value)) {
      gl.disableVertexAttribArray(at);
      gl[whole ? "vertexAttribI4iv" : "vertexAttrib4fv"](at, [...list(value), 0, 0, 0].slice(0, 4));
      return;
    }
    gl.bindBuffer(gl.ARRAY_BUFFER, this.inputs[at] ||= gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, whole ? Int32Array.from(value) : Float32Array.from(value), gl.STREAM_DRAW);
    gl.enableVertexAttribArray(at);
    if (whole) gl.vertexAttribIPointer(at, 1, gl.INT, 0, 0);
    else gl.vertexAttribPointer(at, WIDTH[type], gl.FLOAT, false, 0, 0);
  }
}
