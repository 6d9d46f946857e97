// The badges of models at the page's values: what app/badges.py asks of float64 twins, asked of the GLSL twins while
// nothing moves, of the same pairs of directions and with the same limits.

const finite = Number.isFinite;
const angle = d => Math.atan2(Math.hypot(d[0], d[1]), d[2]);
const KEPT = {ok: true, worst: 0, at: {}};

function badge(ok, worst, [l, v]) {
  const theta_l = angle(l), theta_v = angle(v), phi = theta_l && theta_v ? Math.atan2(l[1], l[0]) - Math.atan2(v[1], v[0]) : 0;
  return {ok, worst: finite(worst) ? worst : null, at: {theta_l, theta_v, phi: phi - 2 * Math.PI * Math.round(phi / (2 * Math.PI))}};
}

class Badges {
  constructor(page) {
    const {badges, rules} = page.content, rows = document.querySelectorAll(".badges");
    Object.assign(this, {page, rules, run: 0, furnace: new Furnace(rules)});
    this.models = badges.map((model, i) => ({...model, row: rows[i], judged: this.key(model, page.defaults())}));
  }

  key({depends}, values) { return JSON.stringify(depends.map(name => values[name])); }

  // Something moves: what is under way ends here, and what was found at other values is old.
  moved() {
    this.run++;
    for (const one of this.models) one.row.classList.toggle("old", this.key(one, this.page.values) !== one.judged);
  }

  // At rest: one model after the other, in pieces between which the page does what else it has to.
  async judge() {
    const run = ++this.run, values = {...this.page.values};
    for (const one of this.models.filter(each => this.key(each, values) !== each.judged)) {
      const found = await this.check(one, this.asking(one, values, () => run === this.run && !this.page.gpu.lost));
      one.judged = this.key(one, values);
      one.row.classList.remove("old");
      one.row.querySelectorAll("span").forEach((word, i) => {
        const {name, short} = one.found[i], {ok} = found[name], textContent = `${ok ? "✓" : "✗"} ${short}`;
        Object.assign(word, {className: ok ? "kept" : "broken", title: this.told(name, found[name]), textContent});
      });
    }
  }

  // A model as a function of pairs of directions that answers as long as somebody wants to know.
  asking({term, shading}, values, wanted) {
    return async ({l, v}, radiance = 1) => {
      await new Promise(go => setTimeout(() => { if (wanted()) go(); }));
      const f = this.page.twins.over(term, values, {l, v, radiance}, l.length / 3);
      return shading ? f.map((x, i) => l[3 * i + 2] > 0 ? x / l[3 * i + 2] : 0 * x) : f;
    };
  }

  async check({linear}, f) {
    const usual = this.usual(), every = [...usual, ...this.corners()];
    const flat = list => ({l: Float32Array.from(list.flatMap(([l]) => l)), v: Float32Array.from(list.flatMap(([, v]) => v))});
    const {l, v} = flat(usual), value = await f(flat(every)), swapped = await f({l: v, v: l});
    const low = topmost(Array.from(value, x => Number.isNaN(x) ? -Infinity : -x)), bad = value.findIndex(x => !finite(x));
    const high = bad < 0 ? topmost(value.map(Math.abs)) : bad, reciprocal = this.reciprocal(usual, value, swapped);
    const dark = value.subarray(0, usual.length).every(finite) ? null : await this.dark(f);
    return {non_negative: badge(value[low] >= 0, value[low], every[low]), reciprocal,
            energy: dark || await this.energy(f, reciprocal.ok), finite: badge(bad < 0, Math.abs(value[high]), every[high]),
            linear: linear ? await this.linear(usual.filter((_, i) => i % 7 === 0), flat, f) : KEPT};
  }

  usual() {
    const looks = POLES.flatMap(pole => this.furnace.looks(this.rules.views, [pole])), {l, v} = pairs(looks, this.furnace.first), found = [];
    for (let i = 0; i < l.length; i += 3) if (l[i + 2] > 0) found.push([[...l.subarray(i, i + 3)], [...v.subarray(i, i + 3)]]);
    return found;
  }

  corners() {
    const {extremes, turns} = this.rules, flat = turns.map(phi => [Math.cos(phi), Math.sin(phi), 0]);
    const all = extremes.flatMap(b => extremes.flatMap(a => turns.map(phi => [direction(a, phi), direction(b)])));
    return [...all, ...all.map(([, v]) => [v, v]), ...all.map(([, v]) => [v.map(x => -x), v]),
            ...flat.flatMap(d => [[d, d], [d, NORMAL], [NORMAL, d]])];
  }

  // Looked for where something is reflected: a thousandth of the largest value weighs as much.
  reciprocal(list, value, swapped) {
    const {seen, same} = this.rules, high = list.map(([l, v]) => l[2] > seen && v[2] > seen);
    const odd = high.findIndex((is, i) => is && finite(value[i]) !== finite(swapped[i]));
    const most = high.map((is, i) => is && finite(value[i]) ? Math.max(Math.abs(value[i]), Math.abs(swapped[i])) : -1), top = most[topmost(most)];
    if (odd >= 0 || top < 0) return badge(false, null, list[Math.max(odd, 0)]);
    const off = most.map((x, i) => x > 0 ? Math.abs(value[i] - swapped[i]) / (x + 1e-3 * top) : 0), i = topmost(off);
    return off[i] ? badge(off[i] <= same, Math.abs(value[i] - swapped[i]) / most[i], list[i]) : KEPT;
  }

  // An albedo that is no number: too much of an even light meets an f that is not finite.
  async dark(f) {
    const {views, part} = this.rules, asked = pairs(this.furnace.looks(views, ["mirror"]), this.furnace.first), found = await f(asked);
    const all = views.map(() => 0), lost = views.map(() => 0), n = this.furnace.first.length;
    asked.share.forEach((share, i) => {
      all[Math.floor(i / n)] += share;
      if (!finite(found[i])) lost[Math.floor(i / n)] += share;
    });
    const i = topmost(lost.map((x, k) => x / all[k]));
    return lost[i] / all[i] > part ? {ok: false, worst: null, at: {theta_v: views[i]}} : null;
  }

  async energy(f, isReciprocal) {
    const found = await this.most(f, "theta_v");
    if (isReciprocal || !found.ok) return found;
    const other = await this.most(({l, v}) => f({l: v, v: l}), "theta_l");
    return other.ok ? found : other;
  }

  // The largest albedo over the angles of a first look, then over some more beside it; of equal ones the first.
  async most(f, name) {
    const {views, limit} = this.rules, first = await this.furnace.albedo(f, views), sure = ({value, error}) => value - error;
    const i = topmost(first.map(sure)), [low, high] = [views[i - 1], views[i + 1]];
    const more = i > 0 && i < views.length - 1 ? [0.25, 0.5, 0.75].map(x => low + x * (high - low)) : [];
    const all = [...first, ...await this.furnace.albedo(f, more)].sort((a, b) => a.theta - b.theta), top = Math.max(...all.map(sure));
    const best = all.find(one => sure(one) >= top - 4e-4);
    return {ok: sure(best) <= limit, worst: best.value, at: {[name]: best.theta}};
  }

  async linear(list, flat, f) {
    const {radiances, same} = this.rules, found = [];
    for (const x of radiances) found.push((await f(flat(list), x)).map(y => y / x));
    const each = list.map((_, i) => found.map(one => one[i])), known = each.map(one => one.filter(finite).length);
    const odd = known.findIndex(count => count > 0 && count < radiances.length);
    if (odd >= 0 || !known.some(Boolean)) return badge(false, null, list[Math.max(odd, 0)]);
    const off = each.map(one => (Math.max(...one) - Math.min(...one)) / Math.max(...one.map(Math.abs)) || 0), i = topmost(off);
    return badge(off[i] <= same, off[i], list[i]);
  }

  told(name, {ok, worst, at}) {
    const {told, unknown, names} = this.rules;
    const parts = Object.entries(at).map(([name, x]) => `${names[name]} ${digits(+(x / RADIANS).toPrecision(4))}°`);
    const where = parts.length ? `, at ${parts.join(", ")}` : "";
    if (worst === null && !ok && unknown[name]) return `${unknown[name]}${where}.`;
    const percent = (100 * worst).toFixed(0);
    return told[name][+!ok].replace("{worst}", three(worst)).replace("{percent}", percent).replace("{at}", where);
  }
}
