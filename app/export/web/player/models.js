// The lobes of models, values from their GLSL twins: where they peak, how wide, how long they are drawn.

const NORMAL = [0, 0, 1];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const mix = (a, x, b, y) => a.map((_, i) => x * a[i] + y * b[i]);

function frame([x, y, z]) { // two unit vectors across a third (Duff et al. 2017)
  const k = -1 / (1 + Math.max(z, 0));
  return [[1 + x * x * k, x * y * k, -x], [x * y * k, 1 + y * y * k, -y]];
}

// Directions over the hemisphere, dense towards a pole: the grid of app/hemisphere.py.
function around(pole, rings, spokes, width) {
  const [across, along] = frame(pole), found = [];
  for (let j = 0; j < spokes; j++) {
    const turn = 2 * Math.PI * j / spokes, way = mix(across, Math.cos(turn), along, Math.sin(turn));
    const stretch = Math.asinh(Math.atan2(Math.max(pole[2], 0), -way[2]) / width);
    for (let i = 0; i < rings; i++) {
      const angle = width * Math.sinh((i + 0.5) / rings * stretch);
      found.push(mix(pole, Math.cos(angle), way, Math.sin(angle)));
    }
  }
  return found;
}

class Models {
  constructor(lobes, over, twins) { Object.assign(this, {lobes, over_: over, twins, top: 0, log: false, decades: 4}); }

  vectors(values) {
    const l = vector("l", values), v = vector("v", values);
    return this.over_ === "v" ? {still: l, picked: v} : {still: v, picked: l};
  }

  // Values of each lobe over its own directions (arrays of vectors); times n.l where the step asks for it.
  over(values, directions) {
    const times = values.lobe_scale === 1, {still} = this.vectors(values);
    const found = this.twins.all(this.lobes.map(({term}, i) =>
      [term, values, {[this.over_]: Float32Array.from(directions[i].flat())}, directions[i].length]));
    return this.lobes.map(({shading}, i) => found[i].map((f, k) =>
      times && !shading ? f * Math.max((this.over_ === "v" ? still : directions[i][k])[2], 0) : f));
  }

  // The direction of each lobe's largest value, a little above the horizon, and how wide (rad) it is there.
  peaks(values) {
    const {still} = this.vectors(values), mirror = [-still[0], -still[1], still[2]];
    const halfway = around(NORMAL, 24, 16, 2e-4).map(h => mix(h, 2 * dot(still, h), still, -1)).filter(d => d[2] > 0);
    const tried = [NORMAL, mirror, still, ...around(mirror, 24, 16, 2e-4), ...around(still, 24, 16, 2e-4), ...halfway];
    const best = this.over(values, this.lobes.map(() => tried)).map(f => {
      let at = 0;
      f.forEach((x, i) => { if (tried[i][2] >= 1e-3 && Number.isFinite(x) && (x > f[at] || !Number.isFinite(f[at]))) at = i; });
      return {peak: tried[at], most: Number.isFinite(f[at]) ? Math.max(f[at], 0) : 0};
    });
    const away = Array.from({length: 41}, (_, i) => 1e-5 * 1e5 ** (i / 40));
    const ways = best.map(({peak}) => frame(peak).flatMap(way => [way, way.map(x => -x)]));
    const near = this.over(values, best.map(({peak}, i) => ways[i].flatMap(way => away.map(a => mix(peak, Math.cos(a), way, Math.sin(a))))));
    return best.map(({peak, most}, i) => {
      let first = 40;
      near[i].forEach((f, k) => { if (!(f >= 0.5 * most)) first = Math.min(first, k % 41); });
      const width = away[first];
      if (peak[2] >= 0.03 || width < 0.05) return {peak, width, most};
      const pole = [peak[0], peak[1], 0.03], long = Math.hypot(...pole);
      return {peak: pole.map(x => x / long), width: Math.max(width, 0.03), most};
    });
  }

  // The scale holds the largest of all values, and keeps still until it is left or far too wide.
  fit(values_, values) {
    const peaks = values_.map(f => f.reduce((a, x) => Number.isFinite(x) && x > a ? x : a, 0)), most = Math.max(...peaks);
    const log = values.lobe_scale === 2;
    if (log !== this.log || most > this.top || most < 0.3 * this.top)
      this.top = !(most > 0) ? 1 : log ? 10 ** Math.ceil(Math.log10(most) - 1e-9) : nice(most);
    this.log = log;
    this.decades = Math.min(...peaks.filter(x => x > 0), this.top) < this.top * 1e-3 ? 8 : 4;
  }

  length(f) {
    const share = Number.isFinite(f) ? Math.max(f, 0) / this.top : 0;
    return this.log ? Math.min(Math.max(1 + Math.log10(Math.max(share, 1e-30)) / this.decades, 0), 1) : share;
  }

  unit(one, values) { return one.shading || values.lobe_scale === 1 ? "" : "/sr"; }

  ring(values) {
    const steps = !this.log ? "in quarters" : this.decades === 4 ? "each a tenth" : "each a hundredth";
    return `outer ring ${tickText(this.top)}${withUnit("", this.unit(this.lobes[0], values))}, ${steps}`;
  }

  legend(numbers, values, ink) {
    return this.lobes.map((one, i) => [`${one.label}  ${written(numbers[i], this.unit(one, values))}`, one.colour || ink[one.ink], one.dash || ""]);
  }
}
