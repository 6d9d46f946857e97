// The page of a step: its values, sliders, drags, words, question, address and messages.
//
// A page in a frame is spoken to with postMessage, and answers the window that asked:
//   {halfway: "set", state: "tilt=30&view=-50,22,6"}  sets what is named, as a link in the prose does
//   {halfway: "get"}        -> {halfway: "state", step, state, values, numbers}
//   {halfway: "snapshot"}   -> {halfway: "snapshot", step, state, png: "data:image/png;base64,..."}
// Unasked it tells its parent {halfway: "ready"} once, {halfway: "state", ...} after a change, {halfway: "escape"}.

const bytes = text => Uint8Array.from(atob(text), c => c.charCodeAt(0));
const numbers = (Kind, text) => new Kind(bytes(text).buffer);
const $ = id => document.getElementById(id);

class Page {
  constructor(content) {
    this.content = content;
    this.specs = new Map(content.values.map(spec => [spec.name, spec]));
    this.canvas = $("picture");
    this.camera = {...content.scene.camera};
    this.values = this.defaults();
    this.restyle(["dark", "light", "projector"].find(name => location.hash.includes(name)) ||
                 (matchMedia("(prefers-color-scheme: light)").matches ? "light" : "dark"));
    for (const [mode, word] of [["scene-only", "scene"], ["scene-bare", "scene-bare"]])
      document.documentElement.classList.toggle(mode, location.hash.includes(word));
    this.gpu = new Gpu(this.canvas);
    this.stage = new Stage(this.gpu, content.scene, values => this.data(values));
    this.twins = new Twins(this.gpu, content.twins, values => this.data(values));
    this.guard(this.canvas, this.gpu, () => this.stage);
    this.turning(this.canvas, () => this.camera, camera => { this.camera = camera; });
    this.badges = typeof Badges === "function" ? new Badges(this) : null;
    this.controls();
    this.handles();
    this.question();
    this.tabs();
    this.breaking();
    this.set(location.search.slice(1) || content.begin || ""); // a page in srcdoc has no address
    this.listen();
    this.draw();
    if (parent !== window) parent.postMessage({halfway: "ready", step: content.step}, "*");
  }

  defaults() { return Object.fromEntries(this.content.values.map(({name, default: value}) => [name, value])); }

  // --- constant data: meshes and tables, as the values choose them ---------------------------------------------------
  data(values) {
    const {meshes, tables} = this.content, found = {};
    if (meshes.length) Object.assign(found, mesh(meshes[values.shape || 0]));
    for (const {uniform, choice, files} of tables) found[uniform] = table(files[values[choice] || 0]);
    return found;
  }

  // --- drawing ---------------------------------------------------------------------------------------------------------
  fit(canvas, share = 1) {
    const scale = share * Math.min(devicePixelRatio || 1, 2), wide = Math.round(canvas.clientWidth * scale), high = Math.round(canvas.clientHeight * scale);
    if (wide && high && (canvas.width !== wide || canvas.height !== high)) Object.assign(canvas, {width: wide, height: high});
    return scale;
  }

  // Words first: their answer waits for what was drawn before. Where that is long, a moving picture has half the rows.
  picture(fine) {
    const scale = this.fit(this.canvas, fine || !this.heavy ? 1 : 0.5), start = performance.now();
    this.stage.aim(this.camera);
    this.name($("words"), this.canvas, this.stage, this.values);
    this.late = performance.now() - start > 50 ? (this.late || 0) + 1 : 0;
    this.heavy ||= this.late > 3;
    this.stage.draw(this.values, this.theme, fine, Math.max(1, scale * 0.8));
  }

  schedule() {
    this.waiting ||= requestAnimationFrame(() => { this.waiting = 0; this.draw(); });
  }

  // The picture at once and with hard edges; its numbers and plot as soon as it is shown; soft edges when nothing moves.
  draw() {
    if (this.gpu.lost) return;
    this.picture(false);
    clearTimeout(this.resting);
    this.after ||= setTimeout(() => {
      this.after = 0;
      this.tell();
      this.plotted(false);
      this.resting = setTimeout(() => this.rest(), 250);
      document.documentElement.dataset.drawn = this.frames = (this.frames || 0) + 1;
      if (this.frames === 1) setTimeout(typeset);
    }, this.frames ? 0 : 50); // the first picture is seen before the programs of numbers are compiled
  }

  rest() {
    if (this.gpu.lost || this.waiting || this.after) return;
    this.picture(true);
    const found = this.stage.faults(this.values).map((count, i) => count ? `${count} pixels ${["not a number", "infinite", "negative"][i]}` : "");
    $("faults").textContent = found.filter(Boolean).join(", ");
    if (this.content.plots[this.shown].kind === "space") this.plotted(true);
    this.badges?.judge();
    const state = this.state();
    if (state === this.told) return;
    this.told = state;
    try { history.replaceState(null, "", this.link()); } catch { /* a frame without an address */ }
    $("said").textContent = this.numbers.map(({label, text}) => `${label} ${text}`).join(", "); // for screen readers, at rest
    if (parent !== window) parent.postMessage(this.report("state"), "*");
  }

  link() { return `${location.pathname}${this.state().replace(/^(?=.)/, "?")}${location.hash}`; }

  // Words and handles at their points, inside the picture.
  name(box, canvas, stage, values) {
    const {probes, anchors} = stage.places(values), {labels, handles} = stage.scene;
    const wide = canvas.clientWidth, high = canvas.clientHeight, made = [];
    const put = (text, ink, point, beside) => {
      const [x, y, w] = project(stage.matrix, point);
      if (!(w > 0 && x > -0.05 && x < 1.05 && y > -0.05 && y < 1.05)) return;
      const word = element("span", {}, text), away = [(x - 0.5) * wide, (y - 0.5) * high], long = Math.hypot(...away) || 1;
      word.style.color = this.theme.css[ink];
      made.push([word, x * wide, y * high, long > 8 ? away.map(a => a / long) : [0, -1], beside]);
    };
    for (const {text, probe, ink} of labels) put(text, ink, probes[probe], 0);
    for (const [mark, point] of anchors) put(mark.label, mark.ink, point, mark.tip ? 14 : 6);
    box.replaceChildren(...made.map(([word]) => word));
    const taken = [];
    for (const [word, x, y, away, gap] of made) {
      const w = word.offsetWidth, h = word.offsetHeight;
      let left = x + (gap ? away[0] * (gap + w / 2) : 0) - w / 2, top = y + (gap ? away[1] * (gap + h / 2) : 0) - h / 2;
      left = Math.min(Math.max(left, 4), wide - w - 4);
      top = Math.min(Math.max(top, 4), high - h - 4);
      for (const [l, t, r] of taken) if (left < r && left + w > l && Math.abs(top - t) < h) top = top >= t ? t + h : t - h;
      taken.push([left, top, left + w]);
      word.style.transform = `translate(${left}px, ${top}px)`;
    }
    if (stage !== this.stage) return;
    handles.forEach(({probe}, i) => {
      const [x, y, w] = project(stage.matrix, probes[probe]);
      this.grips[i].hidden = !(w > 0);
      this.grips[i].style.transform = `translate(${x * wide}px, ${y * high}px)`;
    });
  }

  tell() {
    const {readouts} = this.content, found = this.twins.all(readouts.map(({term}) => [term, this.values]));
    const value = found.map(([x], i) => Math.abs(x) <= readouts[i].nothing ? 0 : x), exact = new Map(readouts.map(({label}, i) => [label, value[i]]));
    this.numbers = readouts.map(({label, unit, against, absent, role}, i) => ({
      label, role, unit, value: value[i], text: absent && Number.isNaN(value[i]) ? absent : written(value[i], unit),
      error: against ? errorWords(value[i], exact.get(against), unit) : ""}));
    $("numbers").replaceChildren(...this.numbers.map(({label, role, text, error, unit, value: x}) =>
      element("div", {class: role}, element("dt", {}, label), element("dd", {title: `${x} ${unit} (float32)`}, text, element("small", {}, error)))));
    this.badges?.moved();
  }

  // --- plots -----------------------------------------------------------------------------------------------------------
  tabs() {
    const {plots} = this.content;
    this.plots = plots.map(() => null);
    this.shown = 0;
    const tabs = [...document.querySelectorAll("#tabs button")];
    tabs.forEach((tab, i) => tab.addEventListener("click", () => {
      this.shown = i;
      tabs.forEach((one, k) => one.setAttribute("aria-pressed", String(k === i)));
      this.schedule();
    }));
  }

  plotted(fine) {
    const plot = this.content.plots[this.shown], still = $(`still-${this.shown}`);
    for (const one of document.querySelectorAll("img.still")) one.hidden = one !== still;
    $("plot-title").textContent = plot.title;
    $("plot").hidden = plot.kind === "still";
    $("plot").className = plot.kind;
    const made = plot.kind === "still" ? null : this.plots[this.shown] ||= new KINDS[plot.kind](plot, this);
    const [legend, note] = made ? made.draw($("plot"), this.values, fine) : [[], plot.note];
    $("legend").replaceChildren(...legend.map(([text, colour, dash]) => {
      const sample = svg("svg", {viewBox: "0 0 30 10", "aria-hidden": "true"}, dash === "area" ? svg("circle", {cx: 15, cy: 5, r: 4.5, fill: colour}) :
        line([[2, 5], [28, 5]], stroke({dash}, colour)));
      return element("li", {}, sample, text);
    }));
    $("plot-note").textContent = note;
  }

  // --- values ----------------------------------------------------------------------------------------------------------
  controls() {
    this.rows = [];
    for (const spec of this.content.values) {
      const parts = list(spec.default), name = `value-${spec.name}`;
      const row = element("div", {class: "row", title: `${spec.words}; at first ${shownText(spec, spec.default)} ${spec.unit}`});
      if (spec.choices.length) {
        const radios = spec.choices.slice(spec.low, spec.high + 1).map((text, i) => {
          const radio = element("input", {type: "radio", name, value: i + spec.low});
          radio.addEventListener("change", () => this.change({[spec.name]: i + spec.low}));
          return element("label", {}, radio, text);
        });
        row.append(element("span", {id: name}, spec.label), element("div", {class: "choices", role: "radiogroup", "aria-labelledby": name}, ...radios));
        this.rows.push(() => radios.forEach((label, i) => { label.firstChild.checked = this.values[spec.name] === i + spec.low; }));
      } else {
        const sliders = parts.map((_, k) => {
          const slider = element("input", {type: "range", min: 0, max: 1, step: spec.whole && !spec.log ? 1 / (spec.high - spec.low) : 0.001,
            name: spec.name, id: k ? `${name}-${k}` : name, "aria-label": parts.length > 1 ? `${spec.label} ${"xyz"[k]}` : spec.label});
          slider.addEventListener("input", () => {
            const now = [...list(this.values[spec.name])];
            now[k] = fromSlider(+slider.value, spec);
            this.change({[spec.name]: parts.length > 1 ? now : now[0]});
          });
          slider.addEventListener("dblclick", () => this.change({[spec.name]: spec.default}));
          return slider;
        });
        const field = element("input", {type: "text", inputmode: "decimal", size: 7, "aria-label": `${spec.label} in ${spec.unit || "numbers"}`});
        field.addEventListener("change", () => {
          const value = entered(spec, field.value);
          this.change(value === null ? {} : {[spec.name]: value});
        });
        row.append(element("label", {for: name}, spec.label), element("div", {class: "sliders"}, ...sliders), element("span", {class: "typed"}, field, spec.unit));
        this.rows.push(() => {
          list(this.values[spec.name]).forEach((x, k) => {
            sliders[k].value = toSlider(x, spec);
            sliders[k].setAttribute("aria-valuetext", withUnit(digits(+(spec.angle ? x / RADIANS : x).toPrecision(4)), spec.unit));
          });
          if (document.activeElement !== field) field.value = list(this.values[spec.name]).map(x => digits(+(spec.angle ? x / RADIANS : x).toPrecision(4))).join(", ");
        });
      }
      $(spec.more ? "more" : "few").append(row);
    }
    $("more").hidden = !this.content.values.some(spec => spec.more);
    this.change({});
  }

  change(some) {
    Object.assign(this.values, some);
    for (const row of this.rows) row();
    this.schedule();
  }

  // "tilt=30&view=-50,22,6": what it names is set, the rest stays; what cannot be read is left.
  set(text) {
    const found = {};
    for (const [name, value] of new URLSearchParams(text.replace(/\+/g, "%2B"))) {
      const view = name === "view" && value.split(",").map(Number);
      if (view && view.length === 3 && view.every(Number.isFinite)) {
        const [azimuth, elevation, distance] = view;
        Object.assign(this.camera, {azimuth, elevation: Math.min(Math.max(elevation, -90), 90), distance: Math.min(Math.max(distance, 0.1), 50)});
      }
      const read = this.specs.has(name) ? entered(this.specs.get(name), value) : null;
      if (read !== null) found[name] = read;
    }
    this.change(found);
  }

  state() {
    const first = this.content.scene.camera, view = ({azimuth, elevation, distance}) => [azimuth, elevation, distance].map(digits).join(",");
    const parts = this.content.values.map(spec => [spec.name, shownText(spec, this.values[spec.name]), shownText(spec, spec.default)])
      .filter(([, now, before]) => now !== before).map(([name, now]) => `${name}=${now}`);
    if (view(this.camera) !== view(first)) parts.push(`view=${view(this.camera)}`);
    return parts.join("&");
  }

  // --- the hand --------------------------------------------------------------------------------------------------------
  turning(canvas, camera, turn) {
    const to = change => { turn({...camera(), ...change}); this.schedule(); };
    canvas.addEventListener("pointerdown", down => {
      const {azimuth, elevation} = camera();
      canvas.setPointerCapture(down.pointerId);
      canvas.onpointermove = move => to({
        azimuth: ((azimuth - 0.35 * (move.clientX - down.clientX) + 540) % 360 + 360) % 360 - 180,
        elevation: Math.min(Math.max(elevation + 0.35 * (move.clientY - down.clientY), -90), 90)});
      canvas.onpointerup = canvas.onpointercancel = () => { canvas.onpointermove = null; };
    });
    canvas.addEventListener("wheel", wheel => { // a frame in a deck or a phone's page must still scroll
      if (document.activeElement !== canvas && !wheel.ctrlKey) return;
      wheel.preventDefault();
      to({distance: Math.min(Math.max(camera().distance * 1.001 ** wheel.deltaY, 0.1), 50)});
    }, {passive: false});
  }

  handles() {
    this.grips = this.content.scene.handles.map(handle => {
      const grip = element("i", {class: "grip", title: handle.name});
      const specs = handle.values.flatMap(name => list(this.specs.get(name).default).map((_, k) => [this.specs.get(name), k]));
      const at = places => {
        const values = {...this.values};
        places.forEach((place, i) => {
          const [spec, k] = specs[i], x = fromSlider(place, spec);
          if (Array.isArray(spec.default)) values[spec.name] = values[spec.name].map((y, j) => j === k ? x : y);
          else values[spec.name] = x;
        });
        return values;
      };
      grip.addEventListener("pointerdown", down => {
        grip.setPointerCapture(down.pointerId);
        grip.onpointermove = move => {
          const {left, top, width, height} = this.canvas.getBoundingClientRect(), to = [move.clientX - left, move.clientY - top];
          const start = specs.map(([spec, k]) => toSlider(list(this.values[spec.name])[k], spec));
          const found = at(nearest(start, to, places => {
            const [x, y] = project(this.stage.matrix, this.stage.probe(handle.probe, at(places)));
            return [x * width, y * height];
          }));
          this.change(Object.fromEntries(handle.values.map(name => [name, found[name]])));
        };
        grip.onpointerup = grip.onpointercancel = () => { grip.onpointermove = null; };
      });
      return grip;
    });
    $("grips").append(...this.grips);
  }

  // --- the question ----------------------------------------------------------------------------------------------------
  question() {
    const {ask} = this.content, spec = {...ask, whole: false}, slider = $("guess");
    const guess = () => fromSlider(+slider.value, spec), tell = () => { $("guessed").textContent = written(guess(), ask.unit); };
    if (slider) {
      slider.addEventListener("input", tell);
      tell();
    }
    $("reveal").addEventListener("click", () => {
      const picked = document.querySelector("#ask input[type=radio]:checked"), truth = this.twins.number(ask.truth, {...ask.values});
      $("verdict").textContent = verdict(ask, truth, slider ? guess() : null, picked && +picked.value);
      $("told").hidden = false;
      if (ask.sets) this.change({...ask.values});
    });
  }

  // Naive forms in the place of stable ones, at the values where that shows; unchecked, the stable ones again.
  breaking() {
    const {scene, readouts, plots, breaks} = this.content, whole = {scene, readouts, plots, sets: {}, told: ""};
    const boxes = [...document.querySelectorAll(".break input")];
    for (const box of boxes) box.addEventListener("change", () => {
      for (const other of boxes) other.checked &&= other === box;
      const one = box.checked ? breaks[box.value] : whole;
      Object.assign(this.content, {scene: one.scene, readouts: one.readouts, plots: one.plots});
      this.stage = new Stage(this.gpu, one.scene, values => this.data(values));
      this.plots = this.plots.map((made, i) => one.plots[i].kind === "curves" ? null : made);
      $("broken").textContent = one.told;
      this.change(one.sets);
    });
  }

  // --- theme, address, messages ------------------------------------------------------------------------------------------
  restyle(name) {
    this.themeName = name;
    this.theme = this.content.themes[name];
    document.documentElement.dataset.theme = name;
    for (const [word, colour] of Object.entries(this.theme.css)) document.documentElement.style.setProperty(`--${word}`, colour);
  }

  report(kind) {
    this.tell();
    const read = Object.fromEntries(this.numbers.map(({label, value}) => [label, value]));
    return {halfway: kind, step: this.content.step, state: this.state(), values: {...this.values}, numbers: read};
  }

  snapshot() {
    this.picture(true); // a drawing buffer lives until the end of this task
    return this.canvas.toDataURL("image/png");
  }

  guard(canvas, gpu, stage) {
    canvas.addEventListener("webglcontextlost", event => {
      event.preventDefault();
      $("scene").classList.add("lost");
    });
    canvas.addEventListener("webglcontextrestored", () => {
      for (const one of [gpu, stage()]) one.begin();
      $("scene").classList.remove("lost");
      this.schedule();
    });
  }

  listen() {
    new ResizeObserver(() => this.schedule()).observe(this.canvas);
    new ResizeObserver(() => this.schedule()).observe($("plot"));
    $("reset").addEventListener("click", () => { this.camera = {...this.content.scene.camera}; this.change(this.defaults()); });
    $("copy").addEventListener("click", () => (navigator.clipboard ? navigator.clipboard.writeText(new URL(this.link(), location).href) : Promise.reject())
      .then(() => { $("copy").textContent = "Copied"; }, () => { $("copy").textContent = this.state() || "first values"; })); // a sandbox has no clipboard
    $("theme").addEventListener("click", () => {
      this.restyle({dark: "light", light: "projector", projector: "dark"}[this.themeName]);
      this.schedule();
    });
    document.addEventListener("click", event => {
      const link = event.target.closest("a[href^='?']");
      if (!link) return;
      event.preventDefault();
      this.set(link.getAttribute("href").slice(1));
    });
    document.addEventListener("keydown", event => {
      if (event.key !== "Escape") return;
      document.activeElement.blur();
      if (parent === window) return;
      parent.postMessage({halfway: "escape"}, "*");
      parent.focus(); // a deck gets its keys back
    });
    addEventListener("message", event => {
      const asked = event.data && event.data.halfway, answer = data => event.source.postMessage(data, "*");
      if (asked === "set") this.set(String(event.data.state || "").replace(/^.*\?/, ""));
      else if (asked === "get") answer(this.report("state"));
      else if (asked === "snapshot") answer({halfway: "snapshot", step: this.content.step, state: this.state(), png: this.snapshot()});
    });
  }
}

function table(one) {
  if (typeof one.numbers === "string") one.numbers = numbers(Float32Array, one.numbers);
  return one;
}

// How a guess did, kindly: the words of app/prediction.py.
function verdict(ask, truth, guess, choice) {
  const rad = ask.unit.startsWith("rad "), quantity = x => withUnit(digits(+x.toPrecision(3)), ask.unit);
  if (guess === null) {
    const right = ask.choices.find(({low, high}) => low <= truth && truth <= high);
    const told = rad ? `${digits(+(truth / RADIANS).toPrecision(3))}${ask.unit.replace("rad", "°")}` : quantity(truth);
    if (choice !== null && right === ask.choices[choice]) return `That is it: ${told}.`;
    return `It is ${told}${right ? `: “${right.text}”.` : "."}`;
  }
  const off = Math.abs(guess - truth) / (Math.abs(truth) || ask.high - ask.low || 1), by = guess > truth ? "high" : "low";
  const told = `: ${quantity(guess)} guessed, ${quantity(truth)} true.`;
  if (off <= 0.02) return `You are there${told}`;
  if (off <= 0.5) return `${off <= 0.1 ? "Very close" : "On the way"}, ${Math.round(100 * off)}% too ${by}${told}`;
  if (truth === 0 || guess / truth <= 0) return `Worth a second look${told}`;
  const [times, way] = Math.abs(guess) > Math.abs(truth) ? [guess / truth, "large"] : [truth / guess, "small"];
  return `Worth a second look, ${digits(+times.toPrecision(3))} times too ${way}${told}`;
}

// The formulas, once the picture stands.
function typeset() {
  if (typeof katex === "undefined") return;
  for (const one of document.querySelectorAll(".tex"))
    katex.render(one.textContent, one, {displayMode: one.dataset.display === "yes", throwOnError: false, trust: ({command}) => command === "\\htmlClass", strict: false});
}

function begin() {
  const content = JSON.parse($("content").textContent), whole = parts => parts.map(i => content.glsl[i]).join("");
  for (const {programs} of [content, ...content.breaks].flatMap(one => [one, ...one.plots]).flatMap(({scene}) => scene || []))
    for (const name in programs) programs[name] = programs[name].map(whole);
  for (const name in content.twins) content.twins[name].text = whole(content.twins[name].text);
  if ($("picture").getContext("webgl2", HOW)) window.halfway = new Page(content);
  else {
    document.documentElement.classList.add("still-only");
    typeset();
  }
}
begin();
