// Twins against a swept value, as app/plots/curves.py draws them.

class CurvesPlot {
  constructor(plot, page, figure) {
    Object.assign(this, {plot, page, box: figure.querySelector(".drawing"), x: numbers(Float64Array, plot.x)});
    this.exact = plot.exact_values && [...numbers(Float64Array, plot.exact_values)];
  }

  draw(values) {
    const {plot, x, page} = this, shown = page.specs.get(plot.sweep).angle ? v => v / RADIANS : v => v;
    const curves = plot.error ? this.errors(this.curves(values)) : this.curves(values);
    const up = this.frame(curves), {picture, at} = graph(this.box, `${plot.title}: ${plot.y_label}`, plot.axis, up);
    const now = shown(values[plot.sweep]), slack = 1e-9 * (up.high - up.low);
    const seen = y => y >= up.low - slack && y <= up.high + slack ? y : NaN;
    picture.append(line([at(now, up.low), at(now, up.high)], {class: "here"}));
    const points = one => Array.from(x, (v, i) => at(shown(v), seen(one.y[i])));
    picture.append(...curves.map(one => line(points(one), {style: one.style})));
    const known = curves.filter(one => seen(one.now) === one.now);
    picture.append(...known.map(one => dot(at(now, one.now), one.colour)));
    const bad = Math.max(0, ...curves.map(one => one.y.filter(y => !Number.isFinite(y)).length));
    return bad ? ` · ${bad} points are not finite and not drawn.` : "";
  }

  // Each with its y over the sweep and its y now.
  curves(values) {
    const {plot: {curves, sweep}, x, page} = this;
    const found = page.twins.all(curves.flatMap(({term}) => [[term, values, {[sweep]: x}, x.length], [term, values]]));
    return curves.map((curve, i) => ({...curve, y: [...found[2 * i]], now: found[2 * i + 1][0]}));
  }

  // Their relative errors against the exact one.
  errors(curves) {
    const exact = curves[this.plot.exact], {floor} = this.plot;
    if (this.exact) Object.assign(exact, {y: this.exact, now: NaN});
    const error = (y, e) => y === e ? floor : Math.max(Math.abs((y - e) / e), floor);
    return curves.filter(one => one !== exact).map(one =>
      ({...one, y: one.y.map((y, i) => error(y, exact.y[i])), now: error(one.now, exact.now)}));
  }

  // The vertical axis keeps still until a curve leaves it or has shrunk to a fraction of it.
  frame(curves) {
    const {log, error} = this.plot, before = this.up;
    const seen = curves.flatMap(one => one.y).filter(y => Number.isFinite(y) && (!log || y > 0));
    const least = seen.reduce((a, b) => Math.min(a, b), seen[0] ?? 1);
    const most = seen.reduce((a, b) => Math.max(a, b), least);
    let low = least < 0 ? -nice(-least) : 0, high = most > 0 ? nice(most) : low < 0 ? 0 : 1;
    if (log) {
      low = 10 ** Math.floor(Math.log10(least));
      high = Math.max(10 ** Math.ceil(Math.log10(most)), error ? 1 : 0);
      if (high === low) high *= 10;
    }
    const span = axis => log ? Math.log(axis.high / axis.low) : axis.high - axis.low, fresh = {low, high, log};
    if (!before || least < before.low || most > before.high || span(fresh) < 0.3 * span(before)) this.up = fresh;
    return this.up;
  }
}
