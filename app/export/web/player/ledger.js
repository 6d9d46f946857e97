// Quantities below each other, the factor between them, and the balance as a bar.

class LedgerPlot {
  constructor(plot, page) { Object.assign(this, {plot, page}); }

  draw(box, values) {
    const {plot, page} = this, columns = plot.columns.map(column => page.twins.all(column.map(({term}) => [term, values])));
    box.replaceChildren(element("div", {class: "columns"}, ...plot.columns.map((column, i) => element("ol", {}, ...column.flatMap((row, j) => {
      const value = columns[i][j][0], before = j ? columns[i][j - 1][0] : 0, factor = value / before;
      const by = row.over ? `÷ ${three(1 / factor)} ${row.by}` : `× ${three(factor)} ${row.by}`;
      const step = element("span", {class: "factor"}, before && Number.isFinite(factor) ? `${by} ${row.how}` : row.how);
      return [element("li", {}, ...(j ? [step] : []), element("span", {}, row.label), element("b", {}, written(value, row.unit)))];
    })))));
    if (!plot.balance.length) return [[], ""];
    const [emitted, received, escaped] = page.twins.all(plot.balance.map(term => [term, values])).map(found => found[0]);
    const meter = element("div", {class: "balance"}, element("i"));
    meter.firstChild.style.width = `${100 * Math.min(1, Math.max(0, received / emitted || 0))}%`;
    box.append(meter);
    return [[], `received ${three(received)} + escaped ${three(escaped)} = ${three(emitted)} ${plot.unit}`];
  }
}
