// The badges of models at the page's values: what app/badges.py asks of float64 twins, asked of the GLSL twins while
// nothing moves, of the same pairs of directions and with the same limits.

const finite = Number.isFinite, KEPT = {ok: true, worst: 0, at: {}};

// What was found at a pair of directions; their angles in rad.
function badge(ok, worst, [l, v]) {
  const [theta_l, theta_v] = [l, v].map(([x, y, z]) => Math.atan2(Math.hypot(x, y), z));
  const phi = theta_l && theta_v ? Math.atan2(l[1], l[0]) - Math.atan2(v[1], v[0]) : 0, turn = 2 * Math.PI;
  return {ok, worst: finite(worst) ? worst : null, at: {theta_l, theta_v, phi: phi - turn * Math.round(phi / turn)}};
}

class Badges {
  constructor(page) {
    const {badges, rules} = page.content, rows = all(".badges");
    Object.assign(this, {page, rules, run: 0, furnace: new Furnace(rules)});
    this.models = badges.map((one, i) => ({...one, row: rows[i], judged: this.key(one, page.defaults())}));
  }

  key({depends}, values) { return JSON.stringify(depends.map(name => values[name])); }

  // Something moves: what is under way ends here, and what was found at other values is old.
  moved() {
    this.run++;
    for (const one of this.models) one.row.classList.toggle("old", this.key(one, this.page.values) !== one.judged);
  }

  // At rest: one model after the other, in pieces between which the page does what else it has to.
  async judge() {
    const run = ++this.run, values = {...this.page.values}, wanted = () => run === this.run && !this.page.gpu.lost;
    for (const one of this.models.filter(each => this.key(each, values) !== each.judged)) {
      const found = await this.check(one, this.asking(one, values, wanted));
      one.judged = this.key(one, values);
      one.row.classList.remove("old");
      all("span", one.row).forEach((word, i) => {
        const {name, short} = one.found[i], {ok} = found[name], title = this.told(name, found[name]);
        Object.assign(word, {title, className: ok ? "kept" : "broken", textContent: `${ok ? "✓" : "✗"} ${short}`});
      });
    }
  }

  // A model as a function of pairs of directions, which answers as long as somebody wants to know.
  asking({term, shading}, values, wanted) {
    return async ({l, v}, radiance = 1) => {
      await new Promise(go => setTimeout(() => { if (wanted()) go(); }));
      const f = this.page.twins.over(term, values, {l, v, radiance}, l.length / 3), z = i => l[3 * i + 2];
      return shading ? f.map((x, i) => z(i) > 0 ? x / z(i) : 0 * x) : f;
    };
  }

  async check({linear}, f) {
    const looks = POLES.flatMap(pole => this.furnace.looks(this.rules.views, [pole]));
    const {l, v} = pairs(looks, this.furnace.first), at = i => [l, v].map(d => [...d.subarray(3 * i, 3 * i + 3)]);
    const usual = times(l.length / 3, at).filter(([[, , z]]) => z > 0), every = [...usual, ...this.corners()];
    const ask = (list, ...more) => f(this.packed(list), ...more);
    const value = await ask(every), swap = this.reciprocal(usual, value, await ask(usual.map(([l, v]) => [v, l])));
    const least = topmost(Array.from(value, x => Number.isNaN(x) ? -Infinity : -x));
    const bad = value.findIndex(x => !finite(x));
    const most = bad < 0 ? topmost(value.map(Math.abs)) : bad;
    const dark = value.subarray(0, usual.length).every(finite) ? null : await this.dark(f);
    return {non_negative: badge(value[least] >= 0, value[least], every[least]), reciprocal: swap,
            energy: dark || await this.energy(f, swap.ok), finite: badge(bad < 0, Math.abs(value[most]), every[most]),
            linear: linear ? await this.linear(usual.filter((_, i) => i % 7 === 0), ask) : KEPT};
  }

  packed(list) {
    return {l: Float32Array.from(list.flatMap(([l]) => l)), v: Float32Array.from(list.flatMap(([, v]) => v))};
  }

  // Pairs at which formulas break: along n, grazing, on and below the horizon, l = v and l = -v.
  corners() {
    const {extremes, turns} = this.rules, flat = turns.map(phi => [Math.cos(phi), Math.sin(phi), 0]);
    const usual = extremes.flatMap(b => extremes.flatMap(a => turns.map(phi => [direction(a, phi), direction(b)])));
    return [...usual, ...usual.flatMap(([, v]) => [[v, v], [v.map(x => -x), v]]),
            ...flat.flatMap(d => [[d, d], [d, NORMAL], [NORMAL, d]])];
  }

  // Looked for where something is reflected: a thousandth of the largest value weighs as much.
  reciprocal(list, value, swapped) {
    const {seen, same} = this.rules, high = list.map(([l, v]) => l[2] > seen && v[2] > seen);
    const odd = high.findIndex((is, i) => is && finite(value[i]) !== finite(swapped[i]));
    const size = (is, i) => is && finite(value[i]) ? Math.max(Math.abs(value[i]), Math.abs(swapped[i])) : -1;
    const most = high.map(size), top = most[topmost(most)];
    if (odd >= 0 || top < 0) return badge(false, null, list[Math.max(odd, 0)]);
    const off = most.map((x, i) => x > 0 ? Math.abs(value[i] - swapped[i]) / (x + 1e-3 * top) : 0), i = topmost(off);
    return off[i] ? badge(off[i] <= same, Math.abs(value[i] - swapped[i]) / most[i], list[i]) : KEPT;
  }

  // An albedo that is no number: too much of an even light meets an f that is not finite.
  async dark(f) {
    const {rules: {views, part}, furnace: {first}} = this, looks = this.furnace.looks(views, ["mirror"]);
    const {l, v, share} = pairs(looks, first), found = await f({l, v}), n = first.length;
    const lost = views.map((_, k) => {
      const here = share.subarray(n * k, n * k + n);
      return sum(here.map((x, i) => finite(found[n * k + i]) ? 0 : x)) / sum(here);
    });
    const i = topmost(lost);
    return lost[i] > part ? {ok: false, worst: null, at: {theta_v: views[i]}} : null;
  }

  async energy(f, isReciprocal) {
    const found = await this.most(f, "theta_v");
    if (isReciprocal || !found.ok) return found;
    const other = await this.most(({l, v}) => f({l: v, v: l}), "theta_l");
    return other.ok ? found : other;
  }

  // The largest albedo over the angles of a first look, then over some more beside it; of equal ones the first.
  async most(f, name) {
    const {views, limit} = this.rules, sure = ({value, error}) => value - error;
    const first = await this.furnace.albedo(f, views), i = topmost(first.map(sure)), end = i % (views.length - 1) === 0;
    const beside = end ? [] : [0.25, 0.5, 0.75].map(x => views[i - 1] + x * (views[i + 1] - views[i - 1]));
    const every = [...first, ...await this.furnace.albedo(f, beside)].sort((a, b) => a.theta - b.theta);
    const best = every.find(one => sure(one) >= Math.max(...every.map(sure)) - 4e-4);
    return {ok: sure(best) <= limit, worst: best.value, at: {[name]: best.theta}};
  }

  async linear(list, ask) {
    const {radiances, same} = this.rules, found = [];
    for (const x of radiances) found.push((await ask(list, x)).map(y => y / x));
    const each = list.map((_, i) => found.map(one => one[i])), known = each.map(one => one.filter(finite).length);
    const odd = known.findIndex(count => count > 0 && count < radiances.length);
    if (odd >= 0 || !known.some(Boolean)) return badge(false, null, list[Math.max(odd, 0)]);
    const off = each.map(one => (Math.max(...one) - Math.min(...one)) / Math.max(...one.map(Math.abs)) || 0);
    return badge(off[topmost(off)] <= same, off[topmost(off)], list[topmost(off)]);
  }

  told(name, {ok, worst, at}) {
    const {told, unknown, names} = this.rules, percent = (100 * worst).toFixed(0);
    const parts = Object.entries(at).map(([key, x]) => `${names[key]} ${digits(+(x / RADIANS).toPrecision(4))}°`);
    const where = parts.length ? `, at ${parts.join(", ")}` : "";
    if (worst === null && !ok && unknown[name]) return `${unknown[name]}${where}.`;
    return told[name][+!ok].replace("{worst}", three(worst)).replace("{percent}", percent).replace("{at}", where);
  }
}
