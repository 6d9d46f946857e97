"""A step in a notebook: a real one is executed, and what its cell puts out is loaded in a real browser."""

import os
from html.parser import HTMLParser

import nbformat
import pytest
from nbclient import NotebookClient

from app.catalog import step
from app.notebook import show
from app.problem import Usage
from app.state import defaults, parse
from tests.browser import CHROMIUM, DRAWN, chromium, opened

STATE = "fresnel/schlick?material=copper&theta=60"
STRICT = ("<meta http-equiv=Content-Security-Policy content=\"default-src 'none'; style-src 'unsafe-inline'; "
          "script-src 'unsafe-inline'; img-src data:; font-src data:\">")


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


def executed(cell: str, folder):
    """What a real kernel puts out for a cell, after the notebook with it has been saved and read again."""
    book = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(cell)])
    NotebookClient(book, timeout=120, allow_errors=True, resources={"metadata": {"path": str(folder)}}).execute()
    nbformat.write(book, folder / "lesson.ipynb")
    output, = nbformat.read(folder / "lesson.ipynb", as_version=4).cells[0].outputs
    return output


def test_a_mistake_in_a_cell_is_one_sentence(tmp_path):
    output = executed("from app.notebook import show\nshow('fresnel/schlick?theta=600')", tmp_path)
    assert output.output_type == "error" and output.ename == "Usage"
    said, = output.traceback
    assert said.startswith("halfway: theta=600") and "90" in said and "\n" not in said


@pytest.mark.skipif(not CHROMIUM and not os.environ.get("CI"), reason="needs Chromium")
def test_an_executed_notebook_shows_the_step_at_its_state(tmp_path):
    """The cell's HTML in a page of its own, under rules as strict as VS Code's: nothing comes from anywhere."""
    output = executed(f"from app.notebook import show\nshow({STATE!r})", tmp_path).data
    assert output["text/plain"] == f"show('{STATE}')"
    frame, = Frame(output["text/html"]).found
    assert frame["sandbox"] == "allow-scripts" and "src" not in frame  # a state of its own origin, and no address
    path = tmp_path / "notebook.html"
    path.write_text(f"<!DOCTYPE html><meta charset=utf-8>{STRICT}<body><p>a cell</p>{output['text/html']}", "utf-8")
    with chromium() as browser, opened(browser, path, (900, 700)) as (tab, heard):
        frame = tab.frames[1]
        frame.wait_for_function("() => +document.documentElement.dataset.drawn > 0")
        values, wanted = frame.evaluate("() => window.halfway.values"), parse(STATE).values
        assert values["material"] == wanted["material"] and values["theta"] == pytest.approx(wanted["theta"], rel=1e-6)
        assert values["theta"] != defaults(step(parse(STATE).step))["theta"]
        frame.wait_for_function(f"() => ({DRAWN})() > 60")  # a busy driver may still compile
        assert frame.evaluate("() => document.getElementById('numbers').textContent").strip()
        assert not heard.said and [url for url in heard.asked if not url.startswith(("file:", "data:", "about:"))] == []
