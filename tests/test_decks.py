"""Pages as frames of a real reveal.js deck (which Quarto's decks are too): keys, states, contexts, what is hidden."""

import os
import shutil
from pathlib import Path

import pytest

from app.catalog import step
from app.export.web.command import export
from app.export.web.page import file_of
from tests.browser import CHROMIUM, opened

pytestmark = pytest.mark.skipif(not CHROMIUM and not os.environ.get("CI"), reason="needs Chromium")
REVEAL = Path(__file__).with_name("reveal")  # reveal.js 6.0.2, MIT
CONE, MODEL = "solid_angle/cone", "fresnel/angle"
DECK = """<!DOCTYPE html><html><head><meta charset="utf-8"><link rel="stylesheet" href="reveal.css"></head>
<body><div class="reveal"><div class="slides">{slides}</div></div><script src="reveal.js"></script>
<script>const heard = []; addEventListener("message", ({{data, source}}) => data.halfway && heard.push(data));
Reveal.initialize({{transition: "none"}});
const frame = () => Reveal.getCurrentSlide().querySelector("iframe");
const ask = data => frame().contentWindow.postMessage(data, "*");</script></body></html>"""
FRAME = ('<section><iframe sandbox="allow-scripts" data-src="{page}?{state}#scene" width="700" height="500"{more}>'
         "</iframe></section>")

COUNT = """() => {
    const {gl} = halfway.gpu;
    window.drawings = 0;
    for (const name of ["drawArrays", "drawElements", "drawArraysInstanced"]) {
        const own = gl[name].bind(gl);
        gl[name] = (...all) => { window.drawings++; own(...all); };
    }
}"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    found = tmp_path_factory.mktemp("deck")
    for id in (CONE, MODEL):
        export(step(id), found, poster=False)
    for name in ("reveal.js", "reveal.css"):
        shutil.copy(REVEAL / name, found)
    return found


def deck(folder, slides: list[str]) -> Path:
    path = folder / "deck.html"
    path.write_text(DECK.format(slides="".join(slides)), "utf-8")
    return path


def framed(id: str, state: str = "", more: str = "") -> str:
    return FRAME.format(page=file_of(id), state=state, more=more)


def ready(tab, step: str) -> None:
    tab.wait_for_function("step => heard.some(one => one.halfway === 'ready' && one.step === step)", arg=step)


def state(tab, step: str = CONE) -> str:
    """What the page of the slide that is shown says its state is; the page before it may still be speaking."""
    tab.evaluate("() => { heard.length = 0; ask({halfway: 'get'}); }")
    tab.wait_for_function("step => heard.some(one => one.halfway === 'state' && one.step === step)", arg=step)
    return tab.evaluate("step => heard.find(one => one.halfway === 'state' && one.step === step).state", step)


def slide(tab) -> int:
    return tab.evaluate("Reveal.getIndices().h")


def test_keys_move_slides_and_come_back_with_escape(folder, browser):
    path = deck(folder, ["<section>A</section>", framed(CONE, "half_angle=30"), "<section>B</section>"])
    with opened(browser, path, (960, 700)) as (tab, heard):
        tab.keyboard.press("ArrowRight")
        ready(tab, CONE)
        assert slide(tab) == 1 and state(tab) == "half_angle=30"
        page = tab.frame_locator("iframe")
        page.locator("#value-half_angle").focus()
        tab.keyboard.press("ArrowRight")  # the slider's, while it has the keyboard
        tab.wait_for_function("() => heard.some(one => one.halfway === 'state' && one.state !== 'half_angle=30')")
        assert slide(tab) == 1
        tab.keyboard.press("Escape")
        tab.wait_for_function("() => heard.some(one => one.halfway === 'escape')")
        tab.wait_for_function("() => document.activeElement.tagName !== 'IFRAME'")
        tab.keyboard.press("ArrowRight")
        assert slide(tab) == 2 and not tab.evaluate("Reveal.isOverview()")
        tab.keyboard.press("ArrowLeft")
        page.locator("#value-half_angle").focus()
        tab.keyboard.press("PageDown")  # a clicker moves the deck from wherever it is pressed
        tab.wait_for_function("() => Reveal.getIndices().h === 2")
    assert heard.said == []


def test_a_slide_that_comes_back_shows_what_was_set(folder, browser):
    """Its frame was dropped; one at another address, and one reloaded with the deck, is as the deck has it."""
    path = deck(folder, [framed(CONE, "half_angle=30"), framed(MODEL), framed(CONE, "half_angle=50")])
    with opened(browser, path, (960, 700)) as (tab, heard):
        ready(tab, CONE)
        tab.evaluate("ask({halfway: 'set', state: 'half_angle=12&view=-50,22,6'})")
        tab.wait_for_function("() => heard.some(one => one.state?.includes('half_angle=12'))")
        tab.keyboard.press("ArrowRight")
        ready(tab, MODEL)
        assert tab.evaluate("document.querySelectorAll('iframe[src]').length") == 1
        tab.evaluate("heard.length = 0")
        tab.keyboard.press("ArrowLeft")
        ready(tab, CONE)
        assert state(tab) == "half_angle=12&view=-50,22,6"
        tab.keyboard.press("ArrowRight")
        tab.keyboard.press("ArrowRight")
        ready(tab, CONE)
        assert state(tab) == "half_angle=50"
        tab.reload()
        tab.evaluate("Reveal.slide(0)")
        ready(tab, CONE)
        assert state(tab) == "half_angle=30"
    assert heard.said == []


def test_hidden_slides_draw_nothing_and_hold_few_contexts(folder, browser):
    """A page that the deck keeps alive beside the slide (data-preload) does not draw; thirty lose no context."""
    slides = [framed(CONE, "half_angle=20", " data-preload"), "<section>A</section>"]
    path = deck(folder, [*slides, *[framed(CONE, f"half_angle={10 + i}") for i in range(28)]])
    with opened(browser, path, (700, 500)) as (tab, heard):
        ready(tab, CONE)
        tab.evaluate("ask({halfway: 'set', state: 'half_angle=33'})")
        tab.wait_for_function("() => heard.some(one => one.state === 'half_angle=33')")
        first = tab.frames[1]
        tab.keyboard.press("ArrowRight")
        first.evaluate(COUNT)
        tab.wait_for_timeout(500)
        assert first.evaluate("drawings") == 0
        for _ in range(28):
            tab.evaluate("heard.length = 0")
            tab.keyboard.press("ArrowRight")
            ready(tab, CONE)
            assert tab.evaluate("document.querySelectorAll('iframe[src]').length") <= 2
        tab.evaluate("() => { heard.length = 0; Reveal.slide(0); }")
        ready(tab, CONE)
        assert state(tab) == "half_angle=33"
    assert heard.said == []  # "Too many active WebGL contexts" would be
