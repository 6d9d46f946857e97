// Twins against a swept value, as app/plots/curves.py draws them.

class CurvesPlot {
  constructor(plot, page) {
    Object.assign(this, {plot, page, x: numbers(Float64Array, plot.x)});
    this.exact = plot.exact_values && numbers(Float64Array, plot.exact_values);
    const used = {};
    for (const curve of plot.curves) {
      const kinds = DASHES[curve.role];
      curve.dash = kinds[(used[curve.role] = (used[curve.role] ?? -1) + 1) % kinds.length];
    }
  }

  colour(curve) { return curve.colour || this.page.theme.css[curve.role]; }

  draw(box, values) {
    const {plot, x, page} = this, shown = page.specs.get(plot.sweep).angle ? v => v / RADIANS : v => v;
    const wanted = plot.curves.flatMap(({term}) => [[term, values, {[plot.sweep]: x}, x.length], [term, values]]);
    const found = page.twins.all(wanted);
    let curves = plot.curves.map((curve, i) => ({...curve, y: [...found[2 * i]], now: found[2 * i + 1][0]}));
    if (plot.error) {
      const exact = curves[plot.exact];
      if (this.exact) exact.y = [...this.exact];
      const error = (y, e) => y === e ? plot.floor : Math.max(Math.abs((y - e) / e), plot.floor);
      curves = curves.filter(one => one !== exact).map(one =>
        ({...one, y: one.y.map((y, i) => error(y, exact.y[i])), now: this.exact ? NaN : error(one.now, exact.now)}));
    }
    const wide = Math.max(box.clientWidth, 200), high = Math.max(box.clientHeight, 150);
    const {low, high: end, log} = plot.axis, [bottom, top] = this.frame(curves);
    const left = 56, right = 16, up = 8, down = 24 + 18, ink = page.theme.css;
    const px = v => left + (wide - left - right) * place(v, low, end, log);
    const py = y => high - down - (high - up - down) * place(y, bottom, top, plot.log);
    const picture = svg("svg", {viewBox: `0 0 ${wide} ${high}`, role: "img", "aria-label": `${plot.title}: ${plot.y_label}`});
    for (const y of plot.log ? logTicks(bottom, top, high / 40) : linearTicks(bottom, top, high / 45))
      picture.append(line([[left, py(y)], [wide - right, py(y)]], {class: "grid"}), words(left - 6, py(y), tickText(y), "end"));
    for (const v of log ? logTicks(low, end, wide / 70) : linearTicks(low, end, wide / 75, plot.axis))
      picture.append(line([[px(v), up], [px(v), high - down]], {class: "grid"}), words(px(v), high - down + 13, tickText(v)));
    const now = shown(values[plot.sweep]);
    picture.append(words((left + wide - right) / 2, high - 8, plot.axis.title),
                   line([[px(now), up], [px(now), high - down]], {stroke: ink.quiet, "stroke-width": 1}));
    const frame = y => y >= bottom - 1e-9 * (top - bottom) && y <= top + 1e-9 * (top - bottom) ? py(y) : NaN;
    for (const one of curves) picture.append(line([...x].map((v, i) => [px(shown(v)), frame(one.y[i])]), stroke(one, this.colour(one))));
    for (const one of curves)
      if (Number.isFinite(frame(one.now))) picture.append(svg("circle", {cx: px(now), cy: py(one.now), r: 6, fill: this.colour(one), stroke: ink.background, "stroke-width": 1.5}));
    box.replaceChildren(picture);
    const bad = Math.max(0, ...curves.map(one => one.y.filter(y => !Number.isFinite(y)).length));
    return [curves.map(one => [one.label, this.colour(one), one.dash]), [plot.y_label + (plot.error ? `, 0 drawn at ${tickText(plot.floor)}` : ""),
      bad ? `${bad} points are not finite and not drawn.` : "", plot.note || ""].filter(Boolean).join(" · ")];
  }

  // The vertical axis keeps still until a curve leaves it or has shrunk to a fraction of it.
  frame(curves) {
    const {log, error} = this.plot;
    const seen = curves.flatMap(one => one.y).filter(y => Number.isFinite(y) && (!log || y > 0));
    const [least, most] = [seen.reduce((a, b) => Math.min(a, b), Infinity), seen.reduce((a, b) => Math.max(a, b), -Infinity)];
    let fresh = log ? [10 ** Math.floor(Math.log10(least)), 10 ** Math.max(Math.ceil(Math.log10(most)), error ? 0 : -300)] :
      [least < 0 ? -nice(-least) : 0, most > 0 ? nice(most) : least < 0 ? 0 : 1];
    if (log && !(fresh[1] > fresh[0])) fresh = seen.length ? [fresh[0], 10 * fresh[0]] : [0.1, 10];
    const span = ([a, b]) => log ? Math.log(b / a) : b - a, held = this.held;
    if (!held || least < held[0] || most > held[1] || span(fresh) < 0.3 * span(held)) this.held = fresh;
    return this.held;
  }
}
