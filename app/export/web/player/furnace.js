// How much of an even light a model sends on in each direction, summed as app/furnace.py does: a first look finds where
// the light is, then tiles of the square (s, t) about a pole are cut into four where that changes something. Values are
// float32 and tiles fewer: at most 0.0015 of the albedo from the desktop's (tests/test_page_badges.py).

const POLES = ["eye", "halfway", "mirror"], GRAZING = 1.54, SMOOTH = 2e-5, SURE = 2e-4, WIDE = 0.1, TILES = 600;
const ROUNDS = [["eye", 5, 5e-5], ["mirror", 1, 2e-6], ["halfway", 5, 5e-5], ["mirror", 5, 5e-5]]; // how deep and fine
const sum = numbers => numbers.reduce((a, b) => a + b, 0);
const topmost = numbers => numbers.reduce((best, x, i) => x > numbers[best] ? i : best, 0);
const cut = ({s, t, high, ...cell}) =>
  times(4, i => ({...cell, s: s + (i & 1) * high / 2, t: t + (i >> 1) * high / 2, high: high / 2}));

// Pairs of directions at the nodes of cells, and n.l dw of each: the grids of app/hemisphere.py.
function pairs(cells, nodes) {
  const count = cells.length * nodes.length, share = new Float64Array(count);
  const l = new Float32Array(3 * count), v = new Float32Array(3 * count);
  let i = 0;
  for (const {eye, pole, width, around, s, t, high} of cells) {
    const at = pole === "halfway" ? NORMAL : pole === "eye" ? eye : [-eye[0], 0, eye[2]], [right, up] = across(at);
    for (const [x, y, weight] of nodes) {
      const turn = around * (s + high * x), way = mix(right, Math.cos(turn), up, Math.sin(turn));
      const stretch = Math.asinh(Math.atan2(at[2], -way[2]) / width);
      const angle = width * Math.sinh((t + high * y) * stretch);
      let d = mix(at, Math.cos(angle), way, Math.sin(angle));
      let size = 2 * Math.PI * Math.sin(angle) * stretch * Math.hypot(width, angle);
      if (pole === "halfway") {
        const both = d[0] * eye[0] + d[2] * eye[2];
        size *= 4 * Math.max(both, 0);
        d = mix(d, 2 * both, eye, -1);
      }
      l.set(d, 3 * i);
      v.set(eye, 3 * i);
      share[i++] = Math.max(d[2], 0) * size * weight * high * high;
    }
  }
  return {l, v, share};
}

class Furnace {
  constructor({along, around, tile, narrowest, part}) {
    const first = along.flatMap(([y, w]) => times(around, i => [(i + 0.5) / around, y, w / around]));
    Object.assign(this, {along, around, first, narrowest, part});
    this.tile = tile.flatMap(([y, a]) => tile.map(([x, b]) => [x, y, a * b]));
  }

  // The whole square about each pole for each angle of the eye.
  looks(views, poles) {
    const whole = {width: this.narrowest, around: 2 * Math.PI, s: 0, t: 0, high: 1};
    return views.flatMap(theta => poles.map(pole => ({...whole, theta, eye: direction(theta), pole})));
  }

  // The light of each node of each cell; what is no number counts nothing.
  async light(f, cells, nodes) {
    const {l, v, share} = pairs(cells, nodes), found = cells.length ? await f({l, v}) : [], n = nodes.length;
    return cells.map((_, c) => share.subarray(n * c, n * c + n).map((x, i) => x * found[n * c + i] || 0));
  }

  // How near to its pole (rad) a first look finds the first thousandth of the light.
  width(light) {
    const rings = this.along.map((_, i) => sum(light.subarray(this.around * i, this.around * (i + 1)).map(Math.abs)));
    const wanted = this.part * sum(rings), t = i => i < 0 ? this.along[0][0] : this.along[i][0];
    let below = 0, i = 0;
    while (i < rings.length - 1 && below + rings[i] < wanted) below += rings[i++];
    const at = wanted ? t(i - 1) + (t(i) - t(i - 1)) * (wanted - below) / rings[i] : 1;
    return within(this.narrowest * Math.sinh(at * Math.asinh(Math.PI / 2 / this.narrowest)), 1e-6, 1);
  }

  // Whether the two sides of the plane of incidence get the same: then one of them is enough.
  even(light) {
    const n = this.around, most = Math.max(...light.map(Math.abs));
    return light.every((x, i) => Math.abs(x - light[i - i % n + n - 1 - i % n]) <= 1e-4 * most);
  }

  // int f n.l dw at each angle of the eye: {theta, value, error}. Of two that are not sure the one that promises more.
  async albedo(f, views) {
    const first = this.looks(views, POLES), light = await this.light(f, first, this.first);
    const around = light.every(one => this.even(one)) ? Math.PI : 2 * Math.PI;
    const looks = first.map((look, i) => ({...look, around, width: this.width(light[i]), seen: sum(light[i])}));
    const best = views.map((theta, i) => ({theta, value: 0, error: Infinity, looks: looks.slice(3 * i, 3 * i + 3)}));
    for (const [pole, deepest, enough] of ROUNDS) {
      const wanted = best.map(one => ({one, look: one.looks[POLES.indexOf(pole)]})).filter(({one, look}) => {
        const [eye, halfway, mirror] = one.looks.map(({width}) => width), back = eye < 0.3 * Math.min(halfway, mirror);
        const sure = one.error <= SURE * Math.max(1, look.seen) && look.seen <= 1.15 * one.value + 0.01;
        const edge = pole === "halfway" && one.theta > GRAZING && halfway > WIDE; // its grid ends beyond the horizon
        return back === (pole === "eye") && !sure && !edge;
      });
      const found = await this.tiles(f, wanted.map(({look}) => look), deepest, enough);
      found.forEach(({value, error}, i) => {
        const {one, look} = wanted[i], smooth = error < SMOOTH * Math.max(1, look.seen);
        if (deepest > 1 ? value - error > one.value - one.error : smooth) Object.assign(one, {value, error});
      });
    }
    return best;
  }

  // The integrals by tiles, each cut into four where that changes more than enough, and estimates of their errors.
  async tiles(f, looks, deepest, enough) {
    const totals = looks.map(() => ({value: 0, error: 0}));
    let cells = looks.flatMap((look, i) => {
      const n = look.theta > GRAZING ? 8 : 3, high = 1 / n;
      return times(n * n, k => ({...look, total: totals[i], s: k % n * high, t: Math.floor(k / n) * high, high}));
    });
    let whole = (await this.light(f, cells, this.tile)).map(sum);
    for (let depth = 0; cells.length; depth++) {
      const parts = cells.flatMap(cut), each = (await this.light(f, parts, this.tile)).map(sum);
      const all = cells.map((_, i) => sum(each.slice(4 * i, 4 * i + 4)));
      const change = all.map((x, i) => Math.abs(x - whole[i])), most = [...change].sort((a, b) => b - a)[TILES] || 0;
      const least = depth < deepest ? Math.max(enough, most) : Infinity;
      cells.forEach(({total}, i) => {
        if (change[i] > least) return;
        total.value += all[i];
        total.error += change[i];
      });
      [cells, whole] = [parts, each].map(list => list.filter((_, k) => change[k >> 2] > least));
    }
    return totals;
  }
}
