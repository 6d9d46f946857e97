// Words beside their points in a picture, inside it and clear of each other.

// Returns where all named points of the stage lie: [x, y, w], in pixels of the box.
function label(box, stage, values) {
  const {clientWidth: wide, clientHeight: high} = box;
  const points = stage.places(values).map(point => project(stage.matrix, point, wide, high));
  const inside = ([x, y, w]) => w > 0 && Math.abs(x / wide - 0.5) < 0.55 && Math.abs(y / high - 0.5) < 0.55;
  const words = stage.scene.words.filter(({at}) => inside(points[at]));
  box.replaceChildren(...words.map(({text: textContent, ink}) =>
    Object.assign(document.createElement("span"), {textContent, className: `ink-${ink}`})));
  const taken = [];
  words.forEach(({at, gap}, i) => {
    const [x, y] = points[at], away = [x - wide / 2, y - high / 2], long = Math.hypot(...away);
    const {offsetWidth: w, offsetHeight: h, style} = box.children[i];
    const [right, down] = !gap ? [0, 0] : long > 8 ? away.map(a => a / long) : [0, -1];
    const left = within(x + right * (gap + w / 2) - w / 2, 4, wide - w - 4);
    let top = within(y + down * (gap + h / 2) - h / 2, 4, high - h - 4);
    for (const [l, t, r] of taken)
      if (left < r && left + w > l && Math.abs(top - t) < h) top = top >= t ? t + h : t - h;
    taken.push([left, top, left + w]);
    style.transform = `translate(${left}px, ${top}px)`;
  });
  return points;
}
