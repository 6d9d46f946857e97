"""A step in a notebook: what Jupyter's own display protocol gets, loaded in a real browser as a notebook embeds it."""

import os
from html.parser import HTMLParser

import pytest

from app.notebook import show
from app.problem import Usage
from app.state import parse
from tests.browser import CHROMIUM, chromium, opened

STATE = "solid_angle/patch?distance=2.5&tilt=30"


class Frame(HTMLParser):
    """The attributes of the one iframe."""

    def __init__(self, text: str):
        super().__init__()
        self.found: list[dict] = []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        assert tag == "iframe"
        self.found.append(dict(attributes))


def test_it_is_one_sandboxed_frame_with_the_whole_page():
    page = show(STATE, height=500)
    frame, = Frame(page._repr_html_()).found
    assert frame["srcdoc"] == page.html and frame["sandbox"] == "allow-scripts" and "height: 500px" in frame["style"]
    assert page.html.startswith("<!DOCTYPE html>") and "Content-Security-Policy" in page.html
    assert page._mime_() == ("text/html", page._repr_html_()) and repr(page) == f"show('{STATE}')"


def test_what_is_no_state_is_a_sentence():
    with pytest.raises(Usage, match=r"Did you mean fresnel/schlick"):
        show("fresnel/schlik")
    with pytest.raises(Usage, match="there is no value f0"):
        show("fresnel/schlick?f0=0.04")


@pytest.mark.skipif(not CHROMIUM and not os.environ.get("CI"), reason="needs Chromium")
def test_a_notebooks_cell_draws_it_at_its_state(tmp_path):
    """As a notebook does: the HTML of the cell in a page of its own, the frame sandboxed."""
    path = tmp_path / "notebook.html"
    path.write_text(f"<!DOCTYPE html><meta charset=utf-8><body><p>a cell</p>{show(STATE)._repr_html_()}", "utf-8")
    with chromium() as browser, opened(browser, path, (900, 700)) as (tab, heard):
        frame = tab.frames[1]
        frame.wait_for_function("() => +document.documentElement.dataset.drawn > 0", timeout=30_000)
        values = frame.evaluate("() => window.halfway.values")
        wanted = parse(STATE).values
        assert values["distance"] == pytest.approx(wanted["distance"], rel=1e-6)
        assert values["tilt"] == pytest.approx(wanted["tilt"], rel=1e-6)
        assert frame.evaluate("() => document.getElementById('numbers').textContent").strip()
        assert not heard.said and [url for url in heard.asked if not url.startswith(("file:", "data:", "about:"))] == []
