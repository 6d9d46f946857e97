// Quantities below each other, the factor between them, and the balance as a bar.

class LedgerPlot {
  constructor(plot, page, figure) { Object.assign(this, {plot, page, figure}); }

  draw(values) {
    const {plot: {columns, balance, unit}, page, figure} = this, cells = all("output", figure).values();
    for (const column of columns) {
      const sizes = page.twins.numbers(column.map(({term}) => term), values);
      column.forEach(({over, by, unit: of}, i) => {
        const factor = sizes[i] / sizes[i - 1], known = sizes[i - 1] && Number.isFinite(factor);
        const words = over ? `÷ ${three(1 / factor)} ${by}` : `× ${three(factor)} ${by}`;
        if (i) cells.next().value.textContent = known ? words : "";
        cells.next().value.textContent = written(sizes[i], of);
      });
    }
    if (!balance.length) return "";
    const [emitted, received, escaped] = page.twins.numbers(balance, values);
    figure.querySelector(".balance i").style.width = `${100 * within(received / emitted || 0, 0, 1)}%`;
    return `received ${three(received)} + escaped ${three(escaped)} = ${three(emitted)} ${unit}`;
  }
}
