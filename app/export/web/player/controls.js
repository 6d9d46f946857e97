// What the hand works beside the picture: sliders, fields and choices, buttons, breaks and the question.

function working(page) {
  const on = (id, kind, act) => $(id).addEventListener(kind, act, true), {values, specs} = page;
  const take = ({target}) => {
    const {name} = target, k = [...document.getElementsByName(name)].indexOf(target);
    page.change({[name]: asked(specs.get(name), target, k, values[name])});
  };
  for (const id of ["few", "more"]) {
    on(id, "input", event => event.target.type === "range" && take(event));
    on(id, "change", event => event.target.type === "range" || take(event));
    on(id, "dblclick", ({target: {type, name}}) => type === "range" && page.change({[name]: specs.get(name).default}));
  }
  on("reset", "click", () => {
    Object.assign(page.stage.camera, page.content.scene.camera);
    page.change(page.defaults());
  });
  on("theme", "click", () => {
    page.restyle({dark: "light", light: "projector", projector: "dark"}[document.documentElement.dataset.theme]);
    page.schedule();
  });
  on("copy", "click", async () => {
    try {
      await navigator.clipboard.writeText(new URL(page.link(), location).href);
      $("copy").textContent = "Copied";
    } catch { // a sandbox has no clipboard
      $("copy").textContent = page.state() || "first values";
    }
  });
  all("#tabs button").forEach((tab, i) => tab.addEventListener("click", () => {
    page.shown = i;
    page.schedule();
  }));
  for (const box of all(".break input")) box.addEventListener("change", () => breaking(page, box));
  const sized = new ResizeObserver(() => page.frames && page.schedule()); // it speaks up at the beginning too
  for (const id of ["picture", "plots"]) sized.observe($(id));
}

// Naive forms in the place of stable ones, at the values where that shows; unchecked, the stable ones again.
function breaking(page, box) {
  for (const other of all(".break input")) other.checked &&= other === box;
  const {breaks, scene, readouts} = page.content, whole = {scene, readouts, put: {}, sets: {}, told: ""};
  const now = box.checked ? breaks[box.value] : whole;
  Object.assign(page, {readouts: now.readouts, put: now.put});
  page.stage.scene = now.scene;
  page.stage.begin();
  for (const row of all("#numbers > div")) row.hidden = row.dataset.broken !== (box.checked ? box.value : "");
  $("broken").textContent = now.told;
  page.change(now.sets);
}

// How each guess does was found when the page was made.
function questioning(page) {
  const {ask, ask: {unit, verdicts, ending, sets}} = page.content, slider = $("guess");
  const tell = () => { $("guessed").textContent = written(fromSlider(+slider.value, ask), unit); };
  slider?.addEventListener("input", tell);
  if (slider) tell();
  $("reveal").addEventListener("click", () => {
    const picked = document.querySelector("#ask input:checked");
    const which = slider ? Math.round(slider.value / slider.step) : picked ? +picked.value : verdicts.length - 1;
    $("verdict").textContent = verdicts[which] + ending;
    $("told").hidden = false;
    page.change(sets);
  });
}
