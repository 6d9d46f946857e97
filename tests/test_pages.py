"""Exported pages in a real browser: they load alone, show the desktop's picture and the desktop's numbers, and can be
dragged, framed, asked, broken and mended."""

import base64
import gzip
import io
import json
import os
import re
from dataclasses import replace

import numpy as np
import pytest
from PIL import Image

from app.catalog import step, steps
from app.export.still import data
from app.export.web import math
from app.export.web.command import export, wanted
from app.export.web.content import content
from app.export.web.page import file_of
from app.gpu.evaluate import evaluate
from app.gpu.stage import Stage
from app.gpu.stage_text import Source
from app.lesson import Camera
from app.problem import Usage
from app.state import View, defaults, parse, write
from app.terms import bound
from app.theme import THEMES
from app.tolerance import FACTOR, ratio
from tests.browser import CHROMIUM, chromium, opened, settle
from tests.test_twins import COUNTED, NAIVE

pytestmark = pytest.mark.skipif(not CHROMIUM and not os.environ.get("CI"), reason="needs Chromium")
PATCH = "solid_angle/patch"
LARGEST, ZIPPED = 900_000, 420_000  # bytes of a page
SMALL = (160, 120)
SEE = f"""() => {{
    const page = window.halfway, gl = page.gpu.gl;
    page.canvas.style.cssText = "width: {SMALL[0]}px; height: {SMALL[1]}px; min-height: 0";
    page.picture(false);
    const pixels = new Uint8Array({4 * SMALL[0] * SMALL[1]});
    gl.readPixels(0, 0, {SMALL[0]}, {SMALL[1]}, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    page.canvas.style.cssText = "";
    return btoa(String.fromCharCode(...pixels.subarray(0, 40000)) + String.fromCharCode(...pixels.subarray(40000)));
}}"""
MOVE = """() => {
    const moved = {picture: false, numbers: false}, page = window.halfway, see = """ + SEE + """;
    const told = () => { page.tell(); return document.getElementById("numbers").textContent; };
    const before = [see(), told()];
    for (const slider of document.querySelectorAll(".rows input[type=range]")) {
        slider.value = +slider.value > 0.5 ? +slider.value - 0.31 : +slider.value + 0.31;
        slider.dispatchEvent(new Event("input"));
        moved.picture ||= see() !== before[0];
        moved.numbers ||= told() !== before[1];
    }
    return moved;
}"""
FONTS = """() => {
    const kept = new Set([...document.fonts].filter(font => font.family.startsWith("KaTeX")).map(f => f.family));
    const asked = [...document.querySelectorAll(".katex-html span")].map(one => getComputedStyle(one).fontFamily)
        .map(name => name.split(",")[0].trim()).filter(name => name.startsWith("KaTeX"));
    return {missing: asked.filter(name => !kept.has(name)), set: document.querySelectorAll(".katex-html").length,
            wrong: document.querySelectorAll(".katex-error").length};
}"""


@pytest.fixture(scope="module")
def browser():
    assert CHROMIUM, "CI must have Chromium"
    with chromium() as found:
        yield found


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    found = tmp_path_factory.mktemp("pages")
    for one in steps():
        export(one, found, poster=False)
    return found


def pixels(text: str) -> np.ndarray:
    return np.frombuffer(base64.b64decode(text), np.uint8).reshape(SMALL[1], SMALL[0], 4)[::-1, :, :3].astype(int)


def desktop(found, values: dict, ctx) -> np.ndarray:
    stage = Stage(ctx, Source(found.step.scene, found.file_name, found.glsl_line), values.get("triangles"))
    try:
        stage.draw(values, found.step.scene.camera, SMALL, THEMES["dark"], fine=False)
        return stage.pixels().astype(int)
    finally:
        stage.release()


def away_from_edges(picture: np.ndarray) -> np.ndarray:
    """Pixels whose neighbours are much like them: where a silhouette or a line runs through, rounding decides."""
    padded = np.pad(picture, ((1, 1), (1, 1), (0, 0)), "edge")
    around = [padded[1 + y:1 + y + SMALL[1], 1 + x:1 + x + SMALL[0]] for y in (-1, 0, 1) for x in (-1, 0, 1)]
    return np.ptp(np.array(around), axis=0).max(-1) <= 24


@pytest.mark.parametrize("found", steps(), ids=lambda found: found.id)
def test_a_page_is_the_step(found, folder, browser, ctx):
    """It loads without a word and without a request, within its size; its picture and numbers are the desktop's; a
    slider moves both; its formulas have their fonts."""
    path = folder / file_of(found.id)
    raw = path.read_bytes()
    assert len(raw) <= LARGEST and len(gzip.compress(raw)) <= ZIPPED
    with opened(browser, path) as (tab, heard):
        settle(tab)
        seen, told = pixels(tab.evaluate(SEE)), tab.evaluate("halfway.report('state')")
        moved, fonts = tab.evaluate(MOVE), tab.evaluate(FONTS)
    assert heard.said == [] and heard.asked == [path.absolute().as_uri()]
    assert moved == {"picture": True, "numbers": True}
    assert fonts["missing"] == [] and fonts["wrong"] == 0
    assert fonts["set"] == raw.count(b'class="tex"')
    values = defaults(found)
    values |= data(found, values)
    for readout in found.step.readouts:
        same_number(readout.term, values, told["numbers"][readout.label], ctx)
    theirs = desktop(found, values, ctx)
    calm = away_from_edges(theirs)
    assert calm.mean() > 0.4
    off = np.abs(seen - theirs).max(-1)[calm]
    print(found.id, off.max(), np.count_nonzero(off > 2))
    assert off.max() <= 2


def same_number(term, values: dict, got: float, ctx) -> None:
    """The page's number is the GLSL twin's: within its tolerance of float64, or beside the desktop's float32."""
    args = {name: np.asarray(x).astype("f4").astype(float) if np.asarray(x).dtype.kind == "f" else x
            for name, x in bound(term, values).items()}
    got = np.nan if got is None else got
    if term.function in {*NAIVE, *COUNTED}:
        np.testing.assert_allclose(got, evaluate(term.function, args, ctx=ctx), rtol=1e-4)
        return
    value = np.asarray(evaluate(term.function, args, ctx=ctx), float)
    if np.isnan(value):
        assert np.isnan(got)
        return
    found = ratio(term.function, args, got)
    print(term.function, float(found))
    assert found <= FACTOR, (term.function, got, float(value), float(found))
