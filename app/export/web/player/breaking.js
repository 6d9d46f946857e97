// "Break it": naive forms in the place of stable ones, at the values where that shows; unchecked, the stable again.
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
