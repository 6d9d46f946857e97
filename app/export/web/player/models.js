// The lobes of models, values from their GLSL twins: where they peak, how wide, how long they are drawn.

const NORMAL = [0, 0, 1];
const mix = (a, x, b, y) => a.map((_, i) => x * a[i] + y * b[i]);
const largest = numbers => numbers.reduce((a, x) => Number.isFinite(x) && x > a ? x : a, 0);

// Two unit vectors across a third (Duff et al. 2017).
function across([x, y, z]) {
  const k = -1 / (1 + Math.max(z, 0));
  return [[1 + x * x * k, x * y * k, -x], [x * y * k, 1 + y * y * k, -y]];
}

// Directions over the hemisphere, dense towards a pole: the grid of app/hemisphere.py.
function around(pole, rings = 24, spokes = 16, width = 2e-4) {
  const [right, up] = across(pole);
  return times(spokes, j => {
    const turn = 2 * Math.PI * j / spokes, way = mix(right, Math.cos(turn), up, Math.sin(turn));
    const stretch = Math.asinh(Math.atan2(Math.max(pole[2], 0), -way[2]) / width);
    const angles = times(rings, i => width * Math.sinh((i + 0.5) / rings * stretch));
    return angles.map(angle => mix(pole, Math.cos(angle), way, Math.sin(angle)));
  }).flat();
}

class Models {
  constructor({lobes, over = "v"}, page, figure) {
    Object.assign(this, {lobes, swept: over, page, cells: all(".legend output", figure)});
    Object.assign(this, {top: 0, log: false, decades: 4});
  }

  vectors(values) {
    const l = vector("l", values), v = vector("v", values);
    return this.swept === "v" ? {still: l, picked: v} : {still: v, picked: l};
  }

  // Values of each lobe over its own directions (arrays of vectors); times n.l where the step asks for it.
  over(values, directions) {
    const times = values.lobe_scale === 1, {still} = this.vectors(values);
    const found = this.page.twins.all(this.lobes.map(({term}, i) =>
      [term, values, {[this.swept]: Float32Array.from(directions[i].flat())}, directions[i].length]));
    return this.lobes.map(({shading}, i) => found[i].map((f, k) =>
      times && !shading ? f * Math.max((this.swept === "v" ? still : directions[i][k])[2], 0) : f));
  }

  // The direction of each lobe's largest value, a little above the horizon, and how wide (rad) it is there.
  peaks(values) {
    const {still} = this.vectors(values), mirror = [-still[0], -still[1], still[2]];
    const cosine = h => h[0] * still[0] + h[1] * still[1] + h[2] * still[2];
    const halfway = around(NORMAL).map(h => mix(h, 2 * cosine(h), still, -1));
    const tried = [NORMAL, mirror, still, ...around(mirror), ...around(still), ...halfway].filter(d => d[2] >= 1e-3);
    const best = this.over(values, this.lobes.map(() => tried)).map(f => {
      const most = largest(f);
      return {most, peak: tried[Math.max(0, f.indexOf(most))]};
    });
    const away = times(41, i => 1e-5 * 1e5 ** (i / 40));
    const near = this.over(values, best.map(({peak}) => away.flatMap(a => across(peak).flatMap(way =>
      [a, -a].map(angle => mix(peak, Math.cos(angle), way, Math.sin(angle)))))));
    return best.map(({peak, most}, i) => {
      const first = near[i].findIndex(f => !(f >= 0.5 * most)), width = away[first < 0 ? 40 : Math.floor(first / 4)];
      if (peak[2] >= 0.03 || width < 0.05) return {peak, width, most};
      const long = Math.hypot(peak[0], peak[1], 0.03);
      return {peak: [peak[0], peak[1], 0.03].map(x => x / long), width: Math.max(width, 0.03), most};
    });
  }

  // The scale holds the largest of all values of the lobes, and keeps still until it is left or far too wide.
  fit(values, lobes) {
    const peaks = lobes.map(largest), most = Math.max(...peaks), log = values.lobe_scale === 2;
    const before = log === this.log ? this.top : 0;
    const ten = 10 ** Math.ceil(Math.log10(most) - 1e-9);
    this.top = !log || !(most > 0) ? held(before, most) : most <= before && most >= 0.3 * before ? before : ten;
    this.log = log;
    this.decades = Math.min(...peaks.filter(x => x > 0), this.top) < this.top * 1e-3 ? 8 : 4;
  }

  // How long a value is drawn: 0 to 1.
  length(f) {
    const share = Number.isFinite(f) ? Math.max(f, 0) / this.top : 0;
    return this.log ? within(1 + Math.log10(Math.max(share, 1e-30)) / this.decades, 0, 1) : share;
  }

  unit(one, values) { return one.shading || values.lobe_scale === 1 ? "" : "/sr"; }

  ring(values) {
    const steps = !this.log ? "in quarters" : this.decades === 4 ? "each a tenth" : "each a hundredth";
    return `outer ring ${withUnit(tickText(this.top), this.unit(this.lobes[0], values)).trim()}, ${steps}`;
  }

  // The value of each lobe in the picked direction, told in the legend too.
  picked(values) {
    const {picked} = this.vectors(values), found = this.over(values, this.lobes.map(() => [picked])).map(f => f[0]);
    found.forEach((f, i) => { this.cells[i].textContent = written(f, this.unit(this.lobes[i], values)); });
    return found;
  }
}
