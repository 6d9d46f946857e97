// The page of a step: its values, picture, numbers and plots.

const $ = id => document.getElementById(id);
const all = (selector, within = document) => [...within.querySelectorAll(selector)];
const FAULTS = ["not a number", "infinite", "negative"];

class Page {
  constructor(content) {
    const data = values => this.data(values);
    this.content = content;
    this.specs = new Map(content.values.map(spec => [spec.name, spec]));
    this.values = this.defaults();
    this.canvas = $("picture");
    this.gpu = new Gpu(this.canvas);
    this.stage = new Stage(this.gpu, content.scene, data);
    this.twins = new Twins(this.gpu, content.twins, data);
    this.kept = new Kept(content.step);
    this.set(this.kept.state ?? (location.search.slice(1) || content.begin || "")); // a page in srcdoc has no address
    this.stage.pictured(this.values); // the programs of the picture compile while the rest is made
    Object.assign(this, {readouts: content.readouts, shown: 0, put: {}, drawn: [], grips: all(".grip")});
    this.restyle(["dark", "light", "projector"].find(name => location.hash.includes(name)) ||
                 (matchMedia("(prefers-color-scheme: light)").matches ? "light" : "dark"));
    this.guard(this.canvas, this.stage);
    this.grips.forEach((grip, i) => grabbing(grip, content.scene.handles[i], this));
    turning(this.canvas, this.stage.camera, () => this.schedule());
    this.badges = typeof Badges === "function" ? new Badges(this) : null;
    working(this);
    questioning(this);
    conversing(this);
    this.draw();
  }

  // --- values --------------------------------------------------------------------------------------------------------
  defaults() { return Object.fromEntries(this.content.values.map(({name, default: value}) => [name, value])); }

  // Constant data, as the values choose them: meshes and tables.
  data(values) {
    const {meshes, tables} = this.content, found = meshes.length ? {...mesh(meshes[values.shape || 0])} : {};
    for (const {uniform, choice, files} of tables) found[uniform] = files[values[choice] || 0];
    return found;
  }

  change(some) {
    Object.assign(this.values, some);
    for (const spec of this.content.values) show(spec, this.values[spec.name]);
    this.schedule();
  }

  // "tilt=30&view=-50,22,6": what it names is set, the rest stays; what cannot be read is left.
  set(text) {
    const found = {};
    for (const [name, value] of new URLSearchParams(text.replace(/\+/g, "%2B"))) {
      const spec = this.specs.get(name), read = spec ? entered(spec, value) : null, view = value.split(",").map(Number);
      if (read !== null) found[name] = read;
      if (name !== "view" || view.length !== 3 || !view.every(Number.isFinite)) continue;
      const [azimuth, elevation, distance] = [view[0], within(view[1], -90, 90), within(view[2], 0.1, 50)];
      Object.assign(this.stage.camera, {azimuth, elevation, distance});
    }
    this.change(found);
  }

  // What differs from the first values and view, as a link has it.
  state() {
    const view = ({azimuth, elevation, distance}) => [azimuth, elevation, distance].map(digits).join();
    const parts = this.content.values.map(spec =>
      [spec.name, typed(spec, this.values[spec.name]), typed(spec, spec.default)]);
    parts.push(["view", view(this.stage.camera), view(this.content.scene.camera)]);
    return parts.filter(([, now, first]) => now !== first).map(([name, now]) => `${name}=${now}`).join("&");
  }

  link() { return `${location.pathname}${this.state().replace(/^(?=.)/, "?")}${location.hash}`; }

  restyle(name) {
    this.theme = this.content.themes[name];
    document.documentElement.dataset.theme = name;
  }

  // --- drawing -------------------------------------------------------------------------------------------------------
  schedule() { this.waiting ||= requestAnimationFrame(() => this.draw()); }

  // The picture at once and with hard edges; its numbers and plot once it is shown; soft edges when nothing moves.
  draw() {
    cancelAnimationFrame(this.waiting);
    this.waiting = 0;
    if (this.gpu.lost) return;
    this.picture(false);
    clearTimeout(this.resting);
    this.badges?.moved();
    const seen = this.frames ? setTimeout : act => requestAnimationFrame(() => setTimeout(act));
    this.after ||= seen(() => {
      this.after = 0;
      if (!this.frames) this.name();
      this.tell();
      this.plot(false);
      this.resting = setTimeout(() => this.rest(), 250);
      this.frames = (this.frames || 0) + 1;
      document.documentElement.dataset.drawn = this.frames;
      if (this.frames > 1) return;
      post({halfway: "ready", step: this.content.step});
      setTimeout(() => window.typeset?.()); // where formulas are
    });
  }

  // Words first: their answer waits for what was drawn before. Where that is long, a moving picture has half the rows.
  // The very first picture does without: it would wait for their programs.
  picture(fine) {
    const scale = this.stage.aim(fine || !this.heavy ? 1 : 0.5), start = performance.now();
    if (this.frames) this.name();
    this.late = performance.now() - start > 50 ? (this.late || 0) + 1 : 0;
    this.heavy ||= this.late > 3;
    this.stage.draw(this.values, this.theme, fine, Math.max(1, scale * 0.8));
    document.documentElement.dataset.pictured = "yes";
  }

  // Words and handles at their points.
  name() {
    const points = label($("words"), this.stage, this.values);
    this.grips.forEach((grip, i) => {
      const [x, y, w] = points[this.stage.scene.handles[i].at];
      grip.hidden = !(w > 0);
      grip.style.transform = `translate(${x}px, ${y}px)`;
    });
  }

  tell() {
    const {readouts, values} = this, found = this.twins.numbers(readouts.map(({term}) => term), values);
    this.numbers = readouts.map(({label, unit, absent, nothing}, i) => {
      const value = Math.abs(found[i]) <= nothing ? 0 : found[i];
      return {label, value, text: absent && Number.isNaN(value) ? absent : written(value, unit)};
    });
    all("#numbers > :not([hidden]) dd").forEach((cell, i) => {
      const {unit, against} = readouts[i], {text, value} = this.numbers[i], [number, error] = cell.children;
      cell.title = `${value} ${unit} (float32)`;
      number.textContent = text;
      error.textContent = against < 0 ? "" : errorWords(value, this.numbers[against].value, unit);
    });
  }

  // The plot that is shown, or what a break puts in its place.
  plot(fine) {
    const at = this.put[this.shown] ?? this.shown, plot = this.content.plots[at], figure = $(`plot-${at}`);
    for (const one of all("figure")) one.hidden = one !== figure;
    all("#tabs button").forEach((tab, i) => tab.setAttribute("aria-pressed", String(i === this.shown)));
    if (!(plot.kind in KINDS)) return;
    this.drawn[at] ||= new KINDS[plot.kind](plot, this, figure);
    figure.querySelector("figcaption span").textContent = this.drawn[at].draw(this.values, fine);
  }

  rest() {
    if (this.gpu.lost || this.waiting || this.after) return;
    this.picture(true);
    const found = this.stage.faults().map((count, i) => count ? `${count} pixels ${FAULTS[i]}` : "");
    $("faults").textContent = found.filter(Boolean).join(", ");
    if (this.content.plots[this.shown].kind === "space") this.plot(true);
    this.badges?.judge();
    const state = this.state();
    if (state === this.told) return;
    this.told = state;
    this.kept.state = state;
    try { history.replaceState(null, "", this.link()); } catch { /* a frame without an address */ }
    $("said").textContent = this.numbers.map(({label, text}) => `${label} ${text}`).join(", "); // for screen readers
    post(this.report());
  }

  // A canvas whose context is lost, and comes back.
  guard(canvas, stage) {
    canvas.addEventListener("webglcontextlost", event => {
      event.preventDefault();
      $("scene").classList.add("lost");
    });
    canvas.addEventListener("webglcontextrestored", () => {
      stage.gpu.begin();
      stage.begin();
      $("scene").classList.remove("lost");
      this.schedule();
    });
  }

  // --- what others are told ------------------------------------------------------------------------------------------
  report() {
    this.tell();
    const {content: {step}, values} = this, read = this.numbers.map(({label, value}) => [label, value]);
    return {halfway: "state", step, state: this.state(), values: {...values}, numbers: Object.fromEntries(read)};
  }

  snapshot() {
    this.picture(true); // a drawing buffer lives until the end of this task
    return {halfway: "snapshot", step: this.content.step, state: this.state(), png: this.canvas.toDataURL("image/png")};
  }
}
