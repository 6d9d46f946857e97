"""The course's index in a real browser: pages come alive where one looks, few at a time, and none is lost."""

import os

import pytest

from app.catalog import steps
from app.export.web import index
from app.export.web.command import export
from tests.browser import CHROMIUM, DRAWN, chromium, opened

pytestmark = pytest.mark.skipif(not CHROMIUM and not os.environ.get("CI"), reason="needs Chromium")
THIRTY = list(steps())[:30]
ALIVE = 8  # contexts at most: four frames of up to two; Chromium loses the oldest of more than 16
COUNTED = """window.contexts = 0;
const own = HTMLCanvasElement.prototype.getContext;
HTMLCanvasElement.prototype.getContext = function (...all) {
    const found = own.apply(this, all);
    if (found && !this.counted) contexts++;
    this.counted = true;
    return found;
};"""
WATCH = """() => {
    window.drew = new Set();
    addEventListener("message", ({data, source}) => {
        const frame = [...document.querySelectorAll("iframe")].find(one => one.contentWindow === source);
        if (frame && data.halfway === "ready") drew.add(frame.closest("article").id);
    });
}"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    found = tmp_path_factory.mktemp("course")
    for one in THIRTY:
        export(one, found, poster=False)
    (found / "index.html").write_text(index.page(THIRTY, posters=False), encoding="utf-8")
    return found


def test_thirty_steps_are_seen_and_no_context_is_lost(folder):
    assert CHROMIUM, "CI must have Chromium"
    with chromium() as browser, opened(browser, folder / "index.html", (1280, 720), COUNTED) as (tab, heard):
        tab.evaluate(WATCH)
        alive = []
        for i in range(0, 30, 2):
            tab.evaluate("i => document.querySelectorAll('article')[i].scrollIntoView({block: 'center'})", i)
            tab.wait_for_function("i => drew.has(document.querySelectorAll('article')[i].id)", arg=i)
            alive.append(sum(frame.evaluate("window.contexts") for frame in tab.frames[1:]))
            if i % 8 == 0:
                ready = [one.content_frame() for one in tab.query_selector_all("iframe.ready")]
                assert ready and all(frame.evaluate(DRAWN) > 40 for frame in ready)
        assert tab.evaluate("drew.size") >= 20 and max(alive) <= ALIVE  # more than 16 came and went
    assert heard.said == []  # "Too many active WebGL contexts" would be


def test_the_search_finds_steps_by_what_they_say(folder):
    with chromium() as browser, opened(browser, folder / "index.html", (1280, 720)) as (tab, heard):
        tab.locator("#search").fill("solid angle cone")
        shown = tab.evaluate("[...document.querySelectorAll('article:not([hidden])')].map(one => one.id)")
        assert "card-solid_angle-cone" in shown and len(shown) < 20
        assert tab.locator("#hits").inner_text() == f"{len(shown)} of 30 steps"
    assert heard.said == []
