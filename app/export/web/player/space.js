// A plot that stands in space: a scene of its own (app/export/web/space.py) on a canvas of its own.

class SpacePlot {
  constructor(plot, page, figure) {
    const [canvas] = all("canvas", figure), stage = new Stage(new Gpu(canvas), plot.scene, values => page.data(values));
    Object.assign(this, {plot, page, stage, words: figure.querySelector(".words"), camera: stage.camera});
    page.guard(canvas, stage);
    if (plot.what !== "slice") turning(canvas, stage.camera, () => page.schedule());
    if (plot.what === "lobes") this.models = new Models(plot, page, figure);
  }

  draw(values, fine) {
    if (this.stage.gpu.lost) return "";
    const [note, uniforms] = this[this.plot.what](values);
    const given = {...values, towards_l: vector("l", values), towards_v: vector("v", values), ...uniforms};
    this.stage.aim();
    label(this.words, this.stage, given);
    this.stage.draw(given, this.page.theme, fine);
    return note;
  }

  figure(values) {
    const {plot: {heights, label}, page} = this;
    if (!heights.length) return ["", {}];
    const found = page.twins.all(heights.map(({term, cells}) => {
      const [corners] = grid(cells, (s, t) => [s, t]);
      const [s, t] = [0, 1].map(k => Float32Array.from(corners, at => at[k]));
      return [term, values, {s, t}, s.length];
    })).flatMap(f => [...f].filter(Number.isFinite));
    const least = found.reduce((a, b) => Math.min(a, b), 0);
    this.high = held(this.high, largest(found));
    this.low = least < (this.low || 0) ? -nice(-least) : this.low || 0;
    const note = `${label}: dark ${tickText(this.low)} to bright ${tickText(this.high)}`;
    return [note, {figure_range: [this.low, this.high]}];
  }

  faces(values) {
    const {twins} = this.page, [points] = this.page.data(values).triangles.corners;
    const [a, b, c] = [0, 1, 2].map(k => points.filter((_, i) => i % 3 === k))
      .map(corners => Float32Array.from(corners.flatMap(point => point.map((x, j) => x - values.eye[j]))));
    const term = {function: "solid_angle_triangle_signed", args: ["a", "b", "c"]};
    const sizes = twins.over(term, values, {a, b, c}, points.length / 3).map(Math.abs).filter(Number.isFinite).sort();
    this.limit = held(this.limit, sizes[Math.floor(0.9 * (sizes.length - 1))]);
    return [`sr of a face; the colours end at ±${tickText(this.limit)}`, {face_limit: this.limit}];
  }

  lobes(values) {
    const {models} = this, peaks = models.peaks(values);
    models.fit(values, peaks.map(({most}) => [most]));
    models.picked(values);
    return [models.ring(values), {
      lobe_peak: peaks.flatMap(({peak}) => peak), lobe_width: peaks.map(({width}) => width < 0.4 ? width : 10),
      lobe_top: models.top, lobe_decades: models.log ? models.decades : 0}];
  }

  slice(values) {
    const {lobes} = this.plot, {term, label} = lobes[Math.min(values.model || 0, lobes.length - 1)], l = [], v = [];
    for (let i = 0; i < 48; i++) {
      const h = Math.PI / 2 * ((i + 0.5) / 48) ** 2;
      for (let j = 0; j < 38; j++) { // nearer to grazing a model may grow without end
        const d = Math.PI / 2 * (j + 0.5) / 48, x = Math.sin(h) * Math.cos(d), z = Math.cos(h) * Math.cos(d);
        l.push(x, Math.sin(d), z);
        v.push(x, -Math.sin(d), z);
      }
    }
    const swept = {l: Float32Array.from(l), v: Float32Array.from(v)};
    const most = largest(this.page.twins.over(term, values, swept, l.length / 3));
    const top = most > 0 ? 10 ** Math.ceil(Math.log10(most) - 1e-9) : 1;
    return [`${label}: dark ${tickText(top * 1e-4)} to bright ${tickText(top)} /sr`, {slice_top: top}];
  }
}
