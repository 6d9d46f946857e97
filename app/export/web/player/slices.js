// A model's lobe cut by the plane of n and the still direction.
class SlicePlot {
  constructor(plot, page) {
    Object.assign(this, {plot, page, models: new Models(plot.lobes, plot.over, page.twins)});
    plot.lobes.forEach((one, i) => { one.dash = ["", "9 5", "10 4 2 4", "2 5"][i % 4]; });
  }

  draw(box, values) {
    const {plot, page, models} = this, {still, picked} = models.vectors(values), ink = page.theme.css;
    const flat = Math.hypot(still[0], still[1]) > 1e-6 ? [-still[0], -still[1]] : Math.hypot(picked[0], picked[1]) > 1e-6 ? picked : [1, 0];
    const side = [flat[0] / Math.hypot(flat[0], flat[1]), flat[1] / Math.hypot(flat[0], flat[1])];
    const angle = d => Math.atan2(d[0] * side[0] + d[1] * side[1], d[2]), way = a => [side[0] * Math.sin(a), side[1] * Math.sin(a), Math.cos(a)];
    const peaks = models.peaks(values), rim = Math.PI / 2 - 1e-3;
    const angles = peaks.map(({peak}) => {
      const near = Array.from({length: 90}, (_, i) => 1e-6 * 1e6 ** (i / 89)), at = angle(peak);
      const all = [...Array.from({length: 181}, (_, i) => (i / 90 - 1) * Math.PI / 2), at, ...near.flatMap(x => [at + x, at - x])];
      return all.map(a => Math.min(Math.max(a, -rim), rim)).sort((a, b) => a - b);
    });
    const curves = models.over(values, angles.map(all => all.map(way)));
    const numbers = models.over(values, plot.lobes.map(() => [picked])).map(f => f[0]);
    models.fit(curves, values);
    const inPlane = Math.abs(picked[0] * -side[1] + picked[1] * side[0]) < Math.sin(0.5 * RADIANS);
    const wide = Math.max(box.clientWidth, 200), high = Math.max(box.clientHeight, 150);
    const picture = svg("svg", {viewBox: `0 0 ${wide} ${high}`, role: "img", "aria-label": plot.title});
    const at = plot.polar ? this.polar(picture, wide, high) : this.graph(picture, wide, high);
    const [own, other] = plot.over === "v" ? ["v", "l"] : ["l", "v"];
    for (const [name, a] of [[other, angle(still)], ...(plot.polar ? [["n", 0], ["r", -angle(still)]] : []), ...(inPlane ? [[own, angle(picked)]] : [])])
      picture.append(line([at(a, 0), at(a, 0.9)], {stroke: ink[name], "stroke-dasharray": name === "r" ? "2 4" : ""}),
                     words(...at(a, 0.96), name === "r" && inPlane && Math.abs(angle(picked) + angle(still)) < 0.1 ? "" : name, "middle", {fill: ink[name], class: "halo"}));
    plot.lobes.forEach((one, i) => picture.append(line(angles[i].map((a, k) => at(a, models.length(curves[i][k]))), stroke(one, one.colour || ink[one.ink]))));
    if (inPlane) plot.lobes.forEach((one, i) => {
      const [cx, cy] = at(angle(picked), models.length(numbers[i]));
      picture.append(svg("circle", {cx, cy, r: 5.5, fill: one.colour || ink[one.ink], stroke: ink.background, "stroke-width": 1.5}));
    });
    box.replaceChildren(picture);
    const who = plot.over === "v" ? "eye" : "light";
    return [models.legend(numbers, values, ink), `${plot.polar ? models.ring(values) : `angle of the ${who}, mirror side > 0`}${inPlane ? "" : `; the ${who} stands beside this plane`}`];
  }

  polar(picture, wide, high) {
    const radius = Math.min(0.5 * wide - 30, high - 44), x = wide / 2, y = (high + radius) / 2 + 6;
    const at = (a, r) => [x + radius * r * Math.sin(a), y - radius * r * Math.cos(a)];
    const arc = Array.from({length: 91}, (_, i) => (i / 45 - 1) * Math.PI / 2);
    for (const r of [0.25, 0.5, 0.75, 1]) picture.append(line(arc.map(a => at(a, r)), {class: "grid"}));
    for (let d = -90; d <= 90; d += 30)
      picture.append(line([at(0, 0), at(d * RADIANS, 1)], {class: "grid"}), words(...at(d * RADIANS, 1 + 16 / radius), `${Math.abs(d)}°`));
    return at;
  }

  graph(picture, wide, high) {
    const left = 56, right = 16, down = 26, up = 8, {top, log, decades} = this.models;
    const at = (a, r) => [left + (wide - left - right) * (a / Math.PI + 0.5), high - down - (high - up - down) * r];
    for (const y of log ? logTicks(top * 10 ** -decades, top, high / 40) : linearTicks(0, top, high / 45)) {
      const r = this.models.length(y);
      picture.append(line([at(-Math.PI / 2, r), at(Math.PI / 2, r)], {class: "grid"}), words(left - 6, at(0, r)[1], tickText(y), "end"));
    }
    for (let d = -90; d <= 90; d += 30)
      picture.append(line([at(d * RADIANS, 0), at(d * RADIANS, 1)], {class: "grid"}), words(at(d * RADIANS, 0)[0], high - 12, minus(`${d}°`)));
    return at;
  }
}
