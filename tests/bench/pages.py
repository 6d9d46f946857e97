"""A page in headless Chromium with software GL: from its address to the first picture, from a slider to the picture."""

import tempfile
from pathlib import Path

from app import catalog
from app.export.web.command import export
from app.export.web.page import file_of
from tests.bench.rows import Row, in_turn
from tests.browser import chromium, opened, settle

SIZE = (1280, 720)
STEPS = ("solid_angle/cone", "brdfs/phong", "fresnel/schlick", "lights/area_sampled", "plausible_shading/board")
FIRST = """new MutationObserver((_, me) => {  // of the task that drew: its picture can still be read, and is waited for
    if (!document.documentElement.dataset.pictured) return;
    me.disconnect();
    const gl = document.querySelector("#picture").getContext("webgl2");
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    window.pictured = performance.now();
}).observe(document, {subtree: true, childList: true, attributes: true});"""
PICTURED = """new Promise(done => {  // wait_for_function would ask the page for eval
    const look = () => window.pictured ? done(window.pictured) : setTimeout(look, 20);
    look();
})"""
MOVE = """share => {
    const page = halfway, gl = page.gpu.gl, start = performance.now();
    const spec = page.content.values.find(one => !one.choices.length && typeof one.default === "number");
    page.change({[spec.name]: fromSlider(share, spec)});
    page.draw();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    return performance.now() - start;
}"""


def pages(rounds: int = 5) -> list[Row]:
    """The first page is the reference; ms."""
    with tempfile.TemporaryDirectory() as folder, chromium() as browser:
        for id in STEPS:
            export(catalog.step(id), Path(folder), poster=False)

        def first(id: str) -> float:
            with opened(browser, Path(folder) / file_of(id), SIZE, FIRST) as (tab, _):
                return tab.evaluate(PICTURED)

        found = in_turn({f"{id}, first picture": lambda id=id: first(id) for id in STEPS}, rounds,
                        asked={f"{id}, first picture": 700.0 for id in STEPS})
        for id in STEPS:
            with opened(browser, Path(folder) / file_of(id), SIZE) as (tab, _):
                settle(tab)
                row = Row(f"{id}, slider to picture", "ms", asked=50.0)
                row.samples += [tab.evaluate(MOVE, 0.3 + 0.02 * i) for i in range(3 * rounds)][rounds:]
                row.ratio = row.middle / (found[len(STEPS)].middle if len(found) > len(STEPS) else row.middle)
                found.append(row)
        return found
