// One WebGL2 context: programs from the course's own GLSL, and its functions as functions of arrays.

const HOW = {antialias: false}; // soft edges are ours, so that a moving picture can do without
const EMPTY = "#version 300 es\nprecision highp float;\nvoid main() {}\n";
const WIDTH = {int: 1, float: 1, vec2: 2, vec3: 3, vec4: 4};
const TRIANGLES = 256; // in a row of a mesh's texture, as in app/gpu/evaluate.py

class Gpu {
  constructor(canvas) {
    this.gl = canvas.getContext("webgl2", HOW);
    this.begin();
  }

  // What a context holds; called again when a lost one comes back.
  begin() {
    this.programs = new Map();
    this.textures = new Map();
    this.points = null;
    this.targets = {};
  }

  get lost() { return this.gl.isContextLost(); }

  program(vertex, fragment) {
    const key = vertex + fragment;
    if (!this.programs.has(key)) {
      const gl = this.gl, program = gl.createProgram();
      for (const [type, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment || EMPTY]]) {
        const shader = gl.createShader(type);
        gl.shaderSource(shader, text);
        gl.compileShader(shader);
        gl.attachShader(program, shader);
      }
      if (!fragment) gl.transformFeedbackVaryings(program, ["value"], gl.INTERLEAVED_ATTRIBS);
      gl.linkProgram(program);
      this.programs.set(key, {program, uniforms: null}); // asked about when first used: they compile side by side
    }
    return this.programs.get(key);
  }

  use(one) {
    const gl = this.gl;
    if (!one.uniforms) {
      if (!gl.getProgramParameter(one.program, gl.LINK_STATUS) && !this.lost) {
        const said = gl.getAttachedShaders(one.program).map(shader => gl.getShaderInfoLog(shader)).join(" ");
        throw new Error(`a program of this page does not link: ${said} ${gl.getProgramInfoLog(one.program)}`);
      }
      one.uniforms = new Map();
      const count = gl.getProgramParameter(one.program, gl.ACTIVE_UNIFORMS) || 0;
      for (let i = 0; i < count; i++) {
        const {name, type} = gl.getActiveUniform(one.program, i);
        one.uniforms.set(name.replace("[0]", ""), {type, at: gl.getUniformLocation(one.program, name)});
      }
    }
    gl.useProgram(one.program);
    return one;
  }

  // Set the uniforms a program has among the given ones; a Data becomes a texture.
  give(one, values) {
    const gl = this.gl;
    let unit = 0;
    for (const [name, {type, at}] of one.uniforms) {
      let value = values[name];
      if (value === undefined) continue;
      if (type === gl.SAMPLER_2D) {
        gl.activeTexture(gl.TEXTURE0 + unit);
        gl.bindTexture(gl.TEXTURE_2D, this.texture(value));
        gl.uniform1i(at, unit++);
        continue;
      }
      if (typeof value === "number") value = [value];
      if (type === gl.INT) gl.uniform1iv(at, value);
      else if (type === gl.FLOAT) gl.uniform1fv(at, value);
      else if (type === gl.FLOAT_VEC2) gl.uniform2fv(at, value);
      else if (type === gl.FLOAT_VEC3) gl.uniform3fv(at, value);
      else if (type === gl.FLOAT_VEC4) gl.uniform4fv(at, value);
      else if (type === gl.FLOAT_MAT4) gl.uniformMatrix4fv(at, false, value);
    }
  }

  // Constant numbers to be read by texelFetch: a table {rows, columns, numbers}, or a mesh {triangles}.
  texture(data) {
    if (!this.textures.has(data)) {
      const gl = this.gl, texture = gl.createTexture();
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
      gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
      if (data.triangles) {
        const rows = Math.max(1, Math.ceil(data.triangles.length / (9 * TRIANGLES)));
        const filled = new Float32Array(rows * TRIANGLES * 9).fill(1); // triangles of no area subtend nothing
        filled.set(data.triangles);
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGB32F, 3 * TRIANGLES, rows, 0, gl.RGB, gl.FLOAT, filled);
      } else if (data.picture) {
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, data.columns, data.rows, 0, gl.RGBA, gl.UNSIGNED_BYTE, bytes(data.picture));
      } else {
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.R32F, data.columns, data.rows, 0, gl.RED, gl.FLOAT, data.numbers);
      }
      this.textures.set(data, texture);
    }
    return this.textures.get(data);
  }

  // Draw into the canvas, through a picture of four samples a pixel when `fine`; the drawing is `paint`.
  into(fine, paint) {
    const gl = this.gl, size = [0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight];
    gl.bindFramebuffer(gl.FRAMEBUFFER, fine ? this.target(4, 1) : null);
    gl.viewport(...size);
    paint();
    if (fine) {
      gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, null);
      gl.blitFramebuffer(...size, ...size, gl.COLOR_BUFFER_BIT, gl.NEAREST);
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  // How many pixels are not a number, infinite, negative: every program of pixels writes that beside the colour.
  faults(paint) {
    const gl = this.gl, wide = gl.drawingBufferWidth, high = gl.drawingBufferHeight, seen = new Uint8Array(4 * wide * high), found = [0, 0, 0];
    this.target(0, 2);
    gl.drawBuffers([gl.COLOR_ATTACHMENT0, gl.COLOR_ATTACHMENT1]);
    gl.viewport(0, 0, wide, high);
    paint();
    gl.readBuffer(gl.COLOR_ATTACHMENT1);
    gl.readPixels(0, 0, wide, high, gl.RGBA, gl.UNSIGNED_BYTE, seen);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    seen.forEach((x, i) => { if (x && i % 4 < 3) found[i % 4]++; });
    return found;
  }

  // Bind a picture of our own, as large as the canvas: with some samples a pixel, and so many colours.
  target(samples, colours) {
    const gl = this.gl, wide = gl.drawingBufferWidth, high = gl.drawingBufferHeight, key = `${samples} ${colours}`, size = `${wide} ${high}`;
    const kept = this.targets[key] ||= {frame: gl.createFramebuffer(), parts: []};
    gl.bindFramebuffer(gl.FRAMEBUFFER, kept.frame);
    if (kept.size === size) return kept.frame;
    for (const part of kept.parts) gl.deleteRenderbuffer(part);
    const wanted = [[gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT], [gl.RGBA8, gl.COLOR_ATTACHMENT0], [gl.RGBA8, gl.COLOR_ATTACHMENT1]];
    kept.parts = wanted.slice(0, 1 + colours).map(([format, where]) => {
      const part = gl.createRenderbuffer();
      gl.bindRenderbuffer(gl.RENDERBUFFER, part);
      gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, format, wide, high);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, where, gl.RENDERBUFFER, part);
      return part;
    });
    kept.size = size;
    return kept.frame;
  }

  // The float32 numbers that points of programs without pixels give: tasks are {program, uniforms, inputs, count, width}.
  // All of them are read back at once, because waiting for the answer is what takes the time.
  transform(tasks) {
    const gl = this.gl, starts = [];
    let size = 0;
    for (const task of tasks) {
      starts.push(size);
      size += 4 * (task.width || 4) * task.count;
    }
    if (!this.points) this.points = {feedback: gl.createTransformFeedback(), out: gl.createBuffer(), size: 0};
    const {feedback, out} = this.points;
    if (this.points.size < size) {
      gl.bindBuffer(gl.TRANSFORM_FEEDBACK_BUFFER, out);
      gl.bufferData(gl.TRANSFORM_FEEDBACK_BUFFER, size, gl.STREAM_READ);
      gl.bindBuffer(gl.TRANSFORM_FEEDBACK_BUFFER, null);
      this.points.size = size;
    }
    gl.enable(gl.RASTERIZER_DISCARD);
    gl.bindTransformFeedback(gl.TRANSFORM_FEEDBACK, feedback);
    gl.bindVertexArray(null);
    const made = [];
    tasks.forEach((task, i) => {
      const one = this.use(task.program);
      this.give(one, task.uniforms || {});
      const enabled = this.inputs(one, task.inputs || [], task.count, made);
      gl.bindBufferRange(gl.TRANSFORM_FEEDBACK_BUFFER, 0, out, starts[i], 4 * (task.width || 4) * task.count);
      gl.beginTransformFeedback(gl.POINTS);
      gl.drawArrays(gl.POINTS, 0, task.count);
      gl.endTransformFeedback();
      for (const at of enabled) gl.disableVertexAttribArray(at);
    });
    gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, null);
    gl.bindTransformFeedback(gl.TRANSFORM_FEEDBACK, null);
    gl.disable(gl.RASTERIZER_DISCARD);
    const found = new ArrayBuffer(size);
    gl.bindBuffer(gl.COPY_READ_BUFFER, out);
    gl.getBufferSubData(gl.COPY_READ_BUFFER, 0, new Uint8Array(found));
    gl.bindBuffer(gl.COPY_READ_BUFFER, null);
    for (const buffer of made) gl.deleteBuffer(buffer);
    return tasks.map((task, i) => {
      const Kind = task.whole ? Int32Array : Float32Array;
      return new Kind(found, starts[i], (task.width || 4) * task.count);
    });
  }

  // Arguments: one value for all points, or an array with one for each.
  inputs(one, inputs, count, made) {
    const gl = this.gl, enabled = [];
    for (const {name, type, value} of inputs) {
      const at = gl.getAttribLocation(one.program, name), width = WIDTH[type];
      if (at < 0) continue;
      const list = typeof value === "number" ? [value] : value;
      if (list.length === width) {
        gl.disableVertexAttribArray(at);
        if (type === "int") gl.vertexAttribI4i(at, list[0], 0, 0, 0);
        else gl.vertexAttrib4f(at, list[0], list[1] || 0, list[2] || 0, list[3] || 0);
        continue;
      }
      const buffer = gl.createBuffer();
      made.push(buffer);
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.bufferData(gl.ARRAY_BUFFER, type === "int" ? Int32Array.from(list) : Float32Array.from(list), gl.STREAM_DRAW);
      gl.enableVertexAttribArray(at);
      if (type === "int") gl.vertexAttribIPointer(at, 1, gl.INT, 0, 0);
      else gl.vertexAttribPointer(at, width, gl.FLOAT, false, 0, 0);
      enabled.push(at);
    }
    return enabled;
  }
}

// The unit vectors n, l, v and h are no values: they follow from the angles theta_l, theta_v and phi.
function vector(name, values) {
  const {theta_l = 0, theta_v = 0, phi = 0} = values;
  if (name === "n") return [0, 0, 1];
  if (name === "l") return [Math.sin(theta_l) * Math.cos(phi), Math.sin(theta_l) * Math.sin(phi), Math.cos(theta_l)];
  if (name === "v") return [Math.sin(theta_v), 0, Math.cos(theta_v)];
  const l = vector("l", values), v = vector("v", values), h = l.map((x, i) => x + v[i]), long = Math.hypot(...h);
  return h.map(x => x / long);
}

// The lesson's terms {function, args} at given values, from the GLSL twins the page carries.
class Twins {
  constructor(gpu, twins, data) { Object.assign(this, {gpu, twins, data}); }

  task(term, values, swept = {}, count = 1) {
    const twin = this.twins[term.function];
    const found = term.args.map(key => typeof key !== "string" ? key : key in swept ? swept[key] :
      key in values ? values[key] : key in this.data(values) ? this.data(values)[key] : vector(key, values));
    const inputs = [], uniforms = {};
    twin.args.forEach(({name, type, fixed}, i) => {
      if (!fixed) inputs.push({name: `in_${name}`, type, value: found[i]});
      else uniforms[`in_${name}`] = type === "sampler2D" ? found[i] : found[i].flat();
    });
    return {program: this.gpu.program(twin.text), uniforms, inputs, count, width: WIDTH[twin.returns],
            whole: twin.returns === "int"};
  }

  // Many terms at once: [term, values, swept, count] each.
  all(wanted) {
    return wanted.length ? this.gpu.transform(wanted.map(one => this.task(...one))) : [];
  }

  over(term, values, swept, count) { return this.all([[term, values, swept, count]])[0]; }

  number(term, values) { return this.over(term, values, {}, 1)[0]; }
}
