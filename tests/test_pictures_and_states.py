"""Pictures that bring their state back, and curves as SVG and PDF with the words of the picture."""

import io
import xml.etree.ElementTree as ET

import numpy as np
import pytest
from PIL import Image, PngImagePlugin

from app import __main__ as cli
from app.catalog import step, steps
from app.lesson import Slice
from app.picture_state import KEY, state_in, state_of
from app.plots import vector
from app.plots.sweep import Sweep
from app.problem import Usage
from app.state import defaults
from app.theme import THEMES
from tests.window import drive, frames

STATE = "solid_angle/patch?distance=2.5&tilt=30&view=-20,30,5"


@pytest.fixture
def still(tmp_path):
    path = tmp_path / "still.png"
    assert cli.main(["render", STATE, "-o", str(path), "--size", "160x120"]) == 0
    return path


def test_a_still_brings_its_state_back(still, tmp_path, monkeypatch, capsys):
    assert state_in(still) == STATE == Image.open(io.BytesIO(still.read_bytes())).text[KEY]
    seen = []
    monkeypatch.setattr(cli, "has_display", lambda: True)
    monkeypatch.setattr("app.viewer.run", lambda options: seen.append(options.state))
    assert cli.main(["show", str(still)]) == 0 and seen == [STATE]
    bare = tmp_path / "bare.png"
    Image.new("RGB", (4, 4)).save(bare)
    assert cli.main(["show", str(bare)]) == 2
    assert "bare.png carries no state; a PNG of `halfway render`" in capsys.readouterr().err
    assert cli.main(["show", str(tmp_path / "none.png")]) == 2 and "cannot be read" in capsys.readouterr().err


def test_other_writers_text_is_read_and_other_pictures_have_none(tmp_path):
    words = PngImagePlugin.PngInfo()
    words.add_text(KEY, STATE)
    Image.new("RGB", (4, 4)).save(tmp_path / "a.png", pnginfo=words)
    assert state_in(tmp_path / "a.png") == STATE
    (tmp_path / "b.png").write_bytes((tmp_path / "a.png").read_bytes()[:40])
    Image.new("RGB", (4, 4)).save(tmp_path / "c.jpg")
    assert (state_in(tmp_path / "b.png"), state_in(tmp_path / "c.jpg")) == ("", "")
    with pytest.raises(Usage, match="carries no state"):
        state_of(str(tmp_path / "c.jpg"))


def test_dropped_on_the_window_it_brings_its_state_back(still, tmp_path, monkeypatch):
    monkeypatch.setenv("HALFWAY_DATA", str(tmp_path / "data"))

    def test(engine, window):
        window.dropped.append(str(still))
        frames(engine)
        assert window.session.state == STATE

    drive(test, "fresnel/schlick")


# --- curves as vectors -----------------------------------------------------------------------------------------------
SVG = "{http://www.w3.org/2000/svg}"
CURVES = step("fresnel/schlick")


def svg(found, number: int = 0, theme: str = "dark") -> ET.Element:
    data = vector.drawing(found.step.plots[number], defaults(found), (700, 500), THEMES[theme], {}, "svg", "the state")
    assert data == vector.drawing(found.step.plots[number], defaults(found), (700, 500), THEMES[theme], {}, "svg",
                                  "the state"), "the same bytes twice"
    return ET.fromstring(data)


def test_an_svg_has_the_pictures_words_as_text_and_its_colours():
    plot = CURVES.step.plots[0]
    root = svg(CURVES)
    words = [" ".join("".join(one.itertext()).split()) for one in root.iter(f"{SVG}text")]
    for wanted in (plot.title, *(curve.label for curve in plot.curves if not (plot.error and curve.role == "exact"))):
        assert wanted in words
    sweep = Sweep(plot, {})
    assert set(sweep.axis.ticks(8)[1]) & set(words), "ticks are those of the picture"
    assert THEMES["dark"].background.lower() in ET.tostring(root, "unicode")


def test_an_svgs_line_goes_where_the_numbers_go():
    """The points of the drawn path, mapped back through two ticks, are the curve's own."""
    plot, found = CURVES.step.plots[0], CURVES
    root, sweep = svg(found), Sweep(CURVES.step.plots[0], {})
    drawn = sweep.run(defaults(found))
    frame = sweep.framed(drawn)
    paths = [np.array([[float(x) for x in point.split()] for point in one.get("d").replace("\n", " ").replace(
        "M", "L").split("L")[1:]]) for one in root.iter(f"{SVG}path") if one.get("d", "").count("L") > 40]
    assert paths, plot.title
    longest = max(paths, key=len)
    y = frame.place(drawn[0].y)
    rise = np.corrcoef(np.interp(longest[:, 0], np.linspace(*longest[[0, -1], 0], len(y)), y), longest[:, 1])[0, 1]
    assert rise < -0.999  # y of an SVG goes down


@pytest.mark.parametrize("kind", ["polar", "graph"])
def test_slices_are_drawn_too(kind):
    found, number = next((found, i) for found in steps() for i, plot in enumerate(found.step.plots)
                         if isinstance(plot, Slice) and (plot.kind == "polar") == (kind == "polar"))
    words = ["".join(one.itertext()) for one in svg(found, number, "light").iter(f"{SVG}text")]
    assert found.step.plots[number].title in words and "90°" in words
    for model in found.step.plots[number].models:
        assert any(word.startswith(model.label) for word in words)


def test_a_pdf_is_a_pdf_and_the_command_writes_both(tmp_path, capsys):
    for ending in ("svg", "pdf"):
        path = str(tmp_path / f"a.{ending}")
        assert cli.main(["render", CURVES.id, "-o", path, "--view", "plot", "--size", "400x300"]) == 0
    assert (tmp_path / "a.pdf").read_bytes().startswith(b"%PDF-")
    import pypdfium2

    with pypdfium2.PdfDocument(tmp_path / "a.pdf") as document:
        page = document[0]
        assert CURVES.step.plots[0].title.split()[0] in page.get_textpage().get_text_bounded()
    assert cli.main(["render", CURVES.id, "-o", str(tmp_path / "b.svg")]) == 2
    assert "b.svg can hold curves only; add --view plot, or write a .png." in capsys.readouterr().err
    assert cli.main(["render", "solid_angle/patch", "-o", str(tmp_path / "b.svg"), "--view", "plot"]) in (0, 2)
