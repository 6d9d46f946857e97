// How much of an even light a model sends on in each direction, as app/furnace.py sums it: a first look finds where the
// light is, then tiles of the square (s, t) about a pole are cut into four where that changes something. Of float32
// values and on fewer tiles: within 0.001 of the desktop's (tests/test_page_badges.py).

const POLES = ["eye", "halfway", "mirror"], GRAZING = 1.54, SMOOTH = 2e-5, SURE = 2e-4, DEEPEST = 5, CHANGE = 5e-5, TILES = 600;
const direction = (theta, phi = 0) => [Math.sin(theta) * Math.cos(phi), Math.sin(theta) * Math.sin(phi), Math.cos(theta)];
const topmost = list => list.reduce((best, x, i) => x > list[best] ? i : best, 0);
const sum = list => list.reduce((a, b) => a + b, 0);
const cut = ({s, t, high, ...cell}) => [0, 1, 2, 3].map(i =>
  ({...cell, s: s + (i & 1) * high / 2, t: t + (i >> 1) * high / 2, high: high / 2}));

// Pairs of directions at the nodes of cells, and n.l dw of each: the grids of app/hemisphere.py.
function pairs(cells, nodes) {
  const count = cells.length * nodes.length, l = new Float32Array(3 * count), v = l.slice(), share = new Float64Array(count);
  let i = 0;
  for (const {eye, pole, width, around, s, t, high} of cells) {
    const at = pole === "halfway" ? NORMAL : pole === "eye" ? eye : [-eye[0], 0, eye[2]], [right, up] = across(at);
    for (const [x, y, weight] of nodes) {
      const turn = around * (s + high * x), way = mix(right, Math.cos(turn), up, Math.sin(turn));
      const stretch = Math.asinh(Math.atan2(at[2], -way[2]) / width), angle = width * Math.sinh((t + high * y) * stretch);
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
    const first = along.flatMap(([y, w]) => Array.from({length: around}, (_, i) => [(i + 0.5) / around, y, w / around]));
    Object.assign(this, {along, around, first, narrowest, part});
    this.tile = tile.flatMap(([y, a]) => tile.map(([x, b]) => [x, y, a * b]));
  }

  looks(views, poles) {
    return views.flatMap(theta => poles.map(pole => ({theta, eye: direction(theta), pole, width: this.narrowest, around: 2 * Math.PI, s: 0, t: 0, high: 1})));
  }

  // The light of each node of each cell; what is no number counts nothing.
  async light(f, cells, nodes) {
    const asked = pairs(cells, nodes), found = cells.length ? await f(asked) : [], n = nodes.length;
    return cells.map((_, c) => asked.share.subarray(n * c, n * c + n).map((x, i) => x * found[n * c + i] || 0));
  }

  // How near to its pole (rad) a first look finds the first thousandth of the light.
  width(light) {
    const rings = this.along.map((_, i) => sum(light.subarray(this.around * i, this.around * (i + 1)).map(Math.abs)));
    const wanted = this.part * sum(rings);
    let below = 0, i = 0;
    while (i < rings.length - 1 && below + rings[i] < wanted) below += rings[i++];
    const t = i => this.along[i][0], at = !wanted ? 1 : i ? t(i - 1) + (t(i) - t(i - 1)) * (wanted - below) / rings[i] : t(0);
    return Math.min(Math.max(this.narrowest * Math.sinh(at * Math.asinh(Math.PI / 2 / this.narrowest)), 1e-6), 1);
  }

  // Whether the two sides of the plane of incidence get the same.
  even(light) {
    const n = this.around, most = Math.max(...light.map(Math.abs));
    return light.every((x, i) => Math.abs(x - light[i - i % n + n - 1 - i % n]) <= 1e-4 * most);
  }

  // int f n.l dw at each angle of the eye: {theta, value, error}. Of two that are not sure the one that promises more.
  async albedo(f, views) {
    const looks = this.looks(views, POLES), light = await this.light(f, looks, this.first), seen = light.map(sum);
    const widths = light.map(one => this.width(one)), around = light.every(one => this.even(one)) ? Math.PI : 2 * Math.PI;
    const best = views.map(theta => ({theta, value: 0, error: Infinity}));
    for (const [pole, deepest, least] of [["eye", DEEPEST, CHANGE], ["mirror", 1, SMOOTH / 10], ["halfway", DEEPEST, CHANGE], ["mirror", DEEPEST, CHANGE]]) {
      const wanted = looks.map((look, i) => ({...look, around, width: widths[i], view: Math.floor(i / 3), seen: seen[i]})).filter(look => {
        const [eye, halfway, mirror] = widths.slice(3 * look.view), back = eye < 0.3 * Math.min(mirror, halfway), {value, error} = best[look.view];
        return look.pole === pole && back === (pole === "eye") && (error > SURE * Math.max(1, look.seen) || look.seen > 1.15 * value + 0.01);
      });
      (await this.tiles(f, wanted, deepest, least)).forEach((total, k) => {
        const {view, seen} = wanted[k], {value, error} = best[view];
        if (deepest > 1 ? total.value - total.error > value - error : total.error < SMOOTH * Math.max(1, seen)) Object.assign(best[view], total);
      });
    }
    return best;
  }

  // The integrals by tiles, each cut into four where that changes it, and estimates of their errors.
  async tiles(f, looks, deepest, enough) {
    const totals = looks.map(() => ({value: 0, error: 0}));
    let cells = looks.flatMap((look, i) => {
      const n = look.theta > GRAZING ? 8 : 3;
      return Array.from({length: n * n}, (_, k) => ({...look, total: totals[i], s: k % n / n, t: Math.floor(k / n) / n, high: 1 / n}));
    });
    let whole = (await this.light(f, cells, this.tile)).map(sum);
    for (let depth = 0; cells.length; depth++) {
      const parts = cells.flatMap(cut), each = (await this.light(f, parts, this.tile)).map(sum);
      const all = cells.map((_, i) => sum(each.slice(4 * i, 4 * i + 4))), change = all.map((x, i) => Math.abs(x - whole[i]));
      const least = depth < deepest ? Math.max(enough, [...change].sort((a, b) => b - a)[TILES] || 0) : Infinity;
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
