// A plot that stands in space: a scene of its own (app/export/web/space.py) on a canvas of its own.

class SpacePlot {
  constructor(plot, page) {
    const canvas = element("canvas", {role: "img", "aria-label": plot.title});
    Object.assign(this, {plot, page, canvas, gpu: new Gpu(canvas), camera: {...plot.scene.camera}});
    this.words = element("div", {class: "words"});
    this.data = values => page.data(values);
    this.stage = new Stage(this.gpu, plot.scene, this.data);
    page.guard(canvas, this.gpu, () => this.stage);
    if (plot.what !== "slice") page.turning(canvas, () => this.camera, camera => { this.camera = camera; });
    if (plot.lobes) this.models = new Models(plot.lobes, plot.over || "v", page.twins);
  }

  draw(box, values, fine) {
    if (this.canvas.parentNode !== box) box.replaceChildren(this.canvas, this.words);
    if (this.gpu.lost) return [[], ""];
    const [legend, note, uniforms] = this[this.plot.what](values), {page} = this;
    const given = {...values, towards_l: vector("l", values), towards_v: vector("v", values), ...uniforms};
    page.fit(this.canvas);
    this.stage.aim(this.camera);
    page.name(this.words, this.canvas, this.stage, given);
    this.stage.draw(given, page.theme, fine);
    return [legend, note];
  }

  figure(values) {
    const {plot, page} = this, areas = plot.areas.map(({label, ink}) => [label, page.theme.css[ink], "area"]);
    if (!plot.heights.length) return [areas, "", {}];
    const found = page.twins.all(plot.heights.map(({term, cells: [across, up]}) => {
      const s = [], t = [];
      for (let i = 0; i <= across; i++) for (let j = 0; j <= up; j++) s.push(i / across), t.push(j / up);
      return [term, values, {s, t}, s.length];
    })).flatMap(f => [...f]).filter(Number.isFinite);
    const most = found.reduce((a, b) => Math.max(a, b), 0), least = found.reduce((a, b) => Math.min(a, b), 0);
    if (!this.range || most > this.range[1] || most < 0.3 * this.range[1] || least < this.range[0])
      this.range = [least < 0 ? -nice(-least) : 0, most > 0 ? nice(most) : 1];
    return [areas, `${plot.label}: dark ${tickText(this.range[0])} to bright ${tickText(this.range[1])}`, {figure_range: this.range}];
  }

  faces(values) {
    const {triangles} = this.page.data(values).triangles, n = triangles.length / 9, corners = [[], [], []];
    for (let i = 0; i < 9 * n; i++) corners[Math.floor(i / 3) % 3].push(triangles[i] - values.eye[i % 3]);
    const [a, b, c] = corners, term = {function: "solid_angle_triangle_signed", args: ["a", "b", "c"]};
    const sizes = this.page.twins.over(term, values, {a, b, c}, n).map(Math.abs).filter(Number.isFinite).sort();
    const most = sizes[Math.floor(0.9 * (sizes.length - 1))];
    if (most > 0 && !(most <= this.limit && most >= 0.3 * this.limit)) this.limit = nice(most);
    const limit = this.limit || 1, css = this.page.theme.css;
    return [[["from outside, −", css.n, "area"], ["from inside, +", css.r, "area"]],
            `sr of a face; the colours end at ±${tickText(limit)}`, {face_limit: limit}];
  }

  lobes(values) {
    const {models} = this, peaks = models.peaks(values), {picked} = models.vectors(values);
    models.fit(peaks.map(({most}) => [most]), values);
    const numbers = models.over(values, this.plot.lobes.map(() => [picked])).map(f => f[0]);
    return [models.legend(numbers, values, this.page.theme.css).map(([text, colour]) => [text, colour, "area"]), models.ring(values),
            {lobe_peak: peaks.flatMap(({peak}) => peak), lobe_width: peaks.map(({width}) => width < 0.4 ? width : 10),
             lobe_top: models.top, lobe_decades: models.log ? models.decades : 0}];
  }

  slice(values) {
    const one = this.plot.lobes[Math.min(values.model || 0, this.plot.lobes.length - 1)], l = [], v = [];
    for (let i = 0; i < 48; i++) for (let j = 0; j < 38; j++) { // nearer to grazing a model may grow without end
      const h = Math.PI / 2 * ((i + 0.5) / 48) ** 2, d = Math.PI / 2 * (j + 0.5) / 48;
      l.push(Math.sin(h) * Math.cos(d), Math.sin(d), Math.cos(h) * Math.cos(d));
      v.push(Math.sin(h) * Math.cos(d), -Math.sin(d), Math.cos(h) * Math.cos(d));
    }
    const f = this.page.twins.over(one.term, values, {l, v}, l.length / 3).filter(Number.isFinite), most = f.reduce((a, b) => Math.max(a, b), 0);
    const top = most > 0 ? 10 ** Math.ceil(Math.log10(most) - 1e-9) : 1;
    return [[[one.label, one.colour || this.page.theme.css[one.ink], "area"]],
            `θ_h to the right, θ_d upwards, φ_d = 90°; dark ${tickText(top * 1e-4)} to bright ${tickText(top)} /sr`, {slice_top: top}];
  }
}
