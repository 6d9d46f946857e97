// The lobes of models cut by the plane of n and the still direction.

class SlicePlot {
  constructor(plot, page, figure) {
    Object.assign(this, {plot, box: figure.querySelector(".drawing"), models: new Models(plot, page, figure)});
  }

  draw(values) {
    const {plot, models} = this, {still, picked} = models.vectors(values);
    const [x, y] = [still.map(a => -a), picked, [1, 0]].find(([a, b]) => Math.hypot(a, b) > 1e-6);
    const side = [x / Math.hypot(x, y), y / Math.hypot(x, y)];
    const angle = d => Math.atan2(d[0] * side[0] + d[1] * side[1], d[2]);
    const angles = models.peaks(values).map(({peak}) => this.angles(angle(peak)));
    const curves = models.over(values, angles.map(some =>
      some.map(a => [side[0] * Math.sin(a), side[1] * Math.sin(a), Math.cos(a)])));
    const now = models.picked(values), here = angle(picked), there = angle(still);
    const inPlane = Math.abs(picked[1] * side[0] - picked[0] * side[1]) < Math.sin(0.5 * RADIANS);
    models.fit(values, curves);
    const {picture, at} = plot.polar ? this.polar() : this.graph();
    const arrow = (name, a, mark = name) => picture.append(
      line([at(a, 0), at(a, 0.9)], {style: `stroke:var(--${name})`, "stroke-dasharray": name === "r" ? "2 4" : ""}),
      words(...at(a, 0.96), mark, "middle", {style: `fill:var(--${name})`, class: "halo"}));
    arrow(plot.over === "v" ? "l" : "v", there);
    if (plot.polar) {
      arrow("n", 0);
      arrow("r", -there, inPlane && Math.abs(here + there) < 0.1 ? "" : "r");
    }
    if (inPlane) arrow(plot.over, here);
    plot.lobes.forEach(({style}, i) =>
      picture.append(line(angles[i].map((a, k) => at(a, models.length(curves[i][k]))), {style})));
    if (inPlane) plot.lobes.forEach(({colour}, i) => picture.append(dot(at(here, models.length(now[i])), colour)));
    const beside = inPlane ? "" : `the ${plot.over === "v" ? "eye" : "light"} stands beside this plane`;
    return [plot.polar ? models.ring(values) : "", beside].filter(Boolean).join("; ");
  }

  // Where a lobe is asked for, in rising order: everywhere, and densely about its peak.
  angles(peak) {
    const near = times(90, i => 1e-6 * 1e6 ** (i / 89)), rim = Math.PI / 2 - 1e-3;
    const found = [...times(181, i => (i / 90 - 1) * rim), peak, ...near.flatMap(x => [peak + x, peak - x])];
    return found.map(a => within(a, -rim, rim)).sort((a, b) => a - b);
  }

  polar() {
    const {picture, wide, high} = drawing(this.box, this.plot.title), radius = Math.min(0.5 * wide - 30, high - 44);
    const at = (a, r) => [wide / 2 + radius * r * Math.sin(a), (high + radius) / 2 + 6 - radius * r * Math.cos(a)];
    for (const r of [0.25, 0.5, 0.75, 1])
      picture.append(line(times(91, i => at((i / 45 - 1) * Math.PI / 2, r)), {class: "grid"}));
    for (let d = -90; d <= 90; d += 30)
      picture.append(line([at(0, 0), at(d * RADIANS, 1)], {class: "grid"}),
                     words(...at(d * RADIANS, 1 + 16 / radius), `${Math.abs(d)}°`));
    return {picture, at};
  }

  graph() {
    const {top, log, decades} = this.models, up = {low: log ? top * 10 ** -decades : 0, high: top, log};
    const across = {low: -90, high: 90, degrees: true, title: this.plot.axis};
    const {picture, at} = graph(this.box, this.plot.title, across, up);
    return {picture, at: (a, share) => at(a / RADIANS, log ? top * 10 ** (decades * (share - 1)) : top * share)};
  }
}
