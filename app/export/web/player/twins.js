// The lesson's terms {function, args} at given values, from the GLSL twins that the page carries.

class Twins {
  constructor(gpu, twins, data) { Object.assign(this, {gpu, twins, data}); }

  // Many terms at once: [term, values, swept, count] each; what is swept is a typed array with a value for each point.
  all(wanted) { return this.gpu.points(wanted.map(one => this.task(...one))); }

  over(term, values, swept, count) { return this.all([[term, values, swept, count]])[0]; }

  numbers(terms, values) { return this.all(terms.map(term => [term, values])).map(([x]) => x); }

  task(term, values, swept = {}, count = 1) {
    const {text, args, returns} = this.twins[term.function], known = {...values, ...this.data(values), ...swept};
    const inputs = [], uniforms = {};
    args.forEach(({name, type, fixed}, i) => {
      const key = term.args[i], value = typeof key !== "string" ? key : key in known ? known[key] : vector(key, values);
      if (!fixed) inputs.push({name: `in_${name}`, type, value});
      else uniforms[`in_${name}`] = Array.isArray(value) ? value.flat() : value;
    });
    return {program: this.gpu.program(text), uniforms, inputs, count, returns};
  }
}

const direction = (theta, phi = 0) =>
  [Math.sin(theta) * Math.cos(phi), Math.sin(theta) * Math.sin(phi), Math.cos(theta)];

// The unit vectors n, l, v and h are no values: they follow from the angles theta_l, theta_v and phi.
function vector(name, values) {
  const {theta_l = 0, theta_v = 0, phi = 0} = values;
  const l = direction(theta_l, phi), v = direction(theta_v), h = l.map((x, i) => x + v[i]);
  return {n: [0, 0, 1], l, v, h: h.map(x => x / Math.hypot(...h))}[name];
}
