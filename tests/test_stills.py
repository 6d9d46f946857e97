"""Stills and the gallery: what is on the pictures, what they say about themselves, what goes wrong in one sentence."""

import io
import json
import os
import re
import subprocess
import sys
import tomllib
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from PIL import Image

from app import VERSION, console, files
from app.catalog import LoadedStep, chapters, step, steps
from app.export import corners, gallery, ink, labels, target
from app.export.png import png
from app.export.shooting import framed, reach, shot
from app.export.still import data, file_of, run, still
from app.export.strip import strip
from app.gpu.stage import Stage
from app.gpu.stage_text import Source
from app.lesson import Mark, Scene, Surface
from app.paths import ROOT
from app.problem import Problem, Usage
from app.readouts import numbers
from app.state import View, defaults, parse, write
from app.theme import THEMES

DARK = THEMES["dark"]
PATCH = step("solid_angle/patch")
STEPS = pytest.mark.parametrize("found", steps(), ids=lambda found: found.id)
SIZE = (320, 240)


def values_of(found: LoadedStep) -> dict:
    values = defaults(found)
    return values | data(found, values)


def options(tmp_path: Path, **given) -> SimpleNamespace:
    first = {"step": "solid_angle/patch", "output": tmp_path / "x.png", "size": "320x240", "set": [], "view": None,
             "theme": None, "mesh": None}
    return SimpleNamespace(**first | given)


# --- the picture -----------------------------------------------------------------------------------------------------
NOWHERE = 1e3  # so high is the label of a line that is not in the picture (display/line_label.glsl)


@STEPS
def test_a_scene_is_not_empty_and_every_word_is_inside_and_apart(found, ctx):
    values, size, pen = values_of(found), (640, 420), ink.Ink(DARK, (640, 420))
    stage = Stage(ctx, Source(found.step.scene, found.file_name, found.glsl_line), values.get("triangles"))
    stage.draw(values, framed(stage, values, size, DARK), size, DARK)
    picture, said = Image.fromarray(np.ascontiguousarray(stage.picture.pixels())), labels.words(stage, values)
    there = {one.text for one in found.step.scene.labels if stage.probes(values)[one.probe, 2] < NOWHERE}
    stage.release()
    assert np.count_nonzero(np.ptp(np.asarray(picture), axis=2) > 20) > 500  # colours, not grey on grey
    assert {word.text for word in said} == there | {m.label for m in found.step.scene.marks if m.label}
    placed = labels.place(said, labels.Clutter(picture, pen.colour("background")), pen, size, [])
    for i, one in enumerate(placed):
        left, top, right, bottom = one.box
        assert 0 <= left < right <= size[0] and 0 <= top < bottom <= size[1]
        assert all(labels.share(one.box, other.box) < 0.1 for other in placed[:i])
    before = np.asarray(picture).astype(int)
    labels.draw_words(picture, placed, pen)
    changed = np.abs(np.asarray(picture).astype(int) - before).max(-1) > 60
    for one in placed:
        left, top, right, bottom = (round(side) for side in one.box)
        assert changed[top:bottom, left:right].any()


@pytest.mark.parametrize("theme", THEMES)
@pytest.mark.parametrize("size", [(64, 64), (320, 240), (241, 517), (1280, 720)])
def test_the_size_is_exact_in_every_theme(theme, size, ctx):
    picture = still(PATCH, defaults(PATCH), None, size, THEMES[theme])
    assert picture.size == size
    assert len(picture.getcolors(size[0] * size[1])) > 20


def test_both_shows_both_parts_and_a_strip(ctx):
    size = (900, 500)
    picture = np.asarray(still(PATCH, defaults(PATCH), None, size, DARK, "both")).astype(int)
    assert picture.shape == (500, 900, 3)
    back = np.array(ink.Ink(DARK, size).colour("background"))
    for half in (picture[:380, :450], picture[:380, 450:]):
        assert np.count_nonzero(np.abs(half - back).max(-1) > 60) > 800
    assert (picture[-4:, 100] == ink.Ink(DARK, size).colour("panel")).all()


def test_the_strip_has_the_numbers_where_there_is_room():
    found, pen = numbers(PATCH.step, defaults(PATCH)), ink.Ink(DARK, (1280, 720))
    wide = strip(1280, 240, "A title", PATCH.id, found, pen)
    narrow = strip(500, 400, "A title", PATCH.id, found, pen)
    title = strip(300, 75, "A title", PATCH.id, found, pen)
    assert wide and narrow and title and narrow.height > wide.height and title.height <= 75
    assert strip(300, 10, "A title", PATCH.id, found, pen) is None


def test_a_view_of_the_users_own_is_not_framed_anew(ctx):
    near = replace(View.of(PATCH.step.scene.camera), distance=4.0)
    far = replace(near, distance=14.0)
    pictures = [np.asarray(shot(PATCH, defaults(PATCH), view, SIZE, DARK, small=True)) for view in (near, far)]
    lit = [np.count_nonzero(picture.max(-1) > 60) for picture in pictures]
    assert lit[0] > 3 * lit[1]


@pytest.mark.parametrize("state", ["", "?distance=4", "?distance=0.5&width=2", "?distance=5&width=0.05"])
def test_a_scene_fills_its_picture_and_is_not_cut_off(state, ctx):
    values = parse(PATCH.id + state).values
    stage = Stage(ctx, Source(PATCH.step.scene, PATCH.file_name, PATCH.glsl_line))
    stage.draw(values, framed(stage, values, (420, 280), DARK), (420, 280), DARK)
    assert 0.6 < reach(stage, DARK) < 0.97
    stage.release()


def test_a_words_box_is_beside_what_is_taken():
    plain = Image.new("RGB", (200, 100), (0, 0, 0))
    pen = ink.Ink(DARK, (200, 100))
    word = labels.Word("word", (100.0, 50.0), "n", ((1.0, 0.0),))
    clutter = labels.Clutter(plain, (0, 0, 0))
    (free,) = labels.place([word], clutter, pen, plain.size, [])
    (moved,) = labels.place([word], clutter, pen, plain.size, [(100.0, 0.0, 200.0, 100.0)])
    assert free.box[0] > 100 and moved.box[2] <= 101


def test_an_exponent_is_raised_and_shorter():
    assert ink.length("6.80e-5 sr", 20) < ink.length("6.80·10−5 sr", 20)
    short = ink.fitted("a long sentence", 16, 60)
    assert short.endswith("…") and ink.length(short, 16) <= 60


def test_the_legend_names_the_marks_whose_letter_is_no_word():
    marks = (Mark("normal", colour="n", tip="arrow", label="n"), Mark("eye", label="eye"), Mark("one", label="1 rad"))
    assert [entry.words for entry in corners.entries(Scene("", marks=marks))] == ["n  normal"]
    own = Scene("", marks=marks, legend=(("n", "up"), ("l", "patch")))
    assert [(e.words, e.mark is not None) for e in corners.entries(own)] == [("up", True), ("patch", False)]


# --- faults ----------------------------------------------------------------------------------------------------------
BROKEN = Scene("""
uniform float tilt;
vec3 surface_point(int surface, vec2 s) {
    return vec3(4.0 * s.x - 2.0, 0.0, 4.0 * s.y - 2.0);
}
vec3 shade(Surface s) {
    return s.st.x < 0.5 ? vec3(sqrt(-1.0 - tilt * tilt)) : vec3(0.4);
}
""", surfaces=(Surface("wall", cells=(2, 2)),))
BROKEN_STEP = LoadedStep(PATCH.loaded, replace(PATCH.step, scene=replace(BROKEN, camera=replace(
    PATCH.step.scene.camera, azimuth=-90.0, elevation=0.0, target=(0.0, 0.0, 0.0)))), 0)


def test_faults_are_counted_and_said(ctx, monkeypatch):
    told = []
    monkeypatch.setattr("app.export.shooting.notice", lambda picture, faults, pen: told.append(faults) or [])
    quiet = np.asarray(shot(BROKEN_STEP, defaults(PATCH), None, SIZE, DARK)).astype(int)
    monkeypatch.undo()
    loud = np.asarray(shot(BROKEN_STEP, defaults(PATCH), None, SIZE, DARK)).astype(int)
    back = np.array(ink.Ink(DARK, SIZE).colour("background"))
    wall = np.count_nonzero(np.abs(quiet - back).max(-1) > 12)
    (faults,) = told
    assert (faults.inf, faults.negative) == (0, 0) and faults.nan == pytest.approx(wall / 2, rel=0.05)
    assert np.abs(loud - quiet)[:60, :200].max() > 60  # the notice, in the upper left corner
    assert not corners.notice(Image.new("RGB", SIZE), replace(faults, nan=0), ink.Ink(DARK, SIZE))


# --- the file --------------------------------------------------------------------------------------------------------
def test_a_file_says_how_it_can_be_opened_again(tmp_path, ctx):
    assert run(options(tmp_path, set=["distance=3", "tilt=10"], theme="light")) == 0
    with Image.open(tmp_path / "x.png") as picture:
        text = picture.text
    state = parse(text["halfway:state"])
    assert text["halfway:state"] == "solid_angle/patch?distance=3&tilt=10"
    assert state.values["distance"] == 3.0 and text["Title"] == PATCH.step.title
    assert text["Software"].startswith("Halfway ") and [p.name for p in tmp_path.iterdir()] == ["x.png"]


def test_a_state_string_and_its_view_are_taken(tmp_path, ctx):
    given = "solid_angle/patch?distance=4&view=10,30,9"
    run(options(tmp_path, step=given))
    with Image.open(tmp_path / "x.png") as picture:
        assert picture.text["halfway:state"] == given


def test_the_same_still_is_the_same_file(tmp_path, ctx):
    values = defaults(PATCH)
    first, second = (file_of(still(PATCH, values, None, SIZE), PATCH, write(PATCH, values)) for _ in range(2))
    assert first == second


@pytest.mark.parametrize(("given", "words"), [
    ({"size": "0x0"}, "64 to 8192"), ({"size": "100000x1"}, "64 to 8192"), ({"size": "abc"}, "like 1280x720"),
    ({"size": "-5x5"}, "like 1280x720"), ({"output": "x.jpg"}, ".png"), ({"output": "/nowhere/all/x.png"}, "no folder"),
    ({"view": "plots"}, "Did you mean plot"), ({"theme": "drak"}, "Did you mean dark"), ({"set": ["tlt=3"]}, "tilt"),
    ({"step": "solid_angle/pach"}, "patch"), ({"mesh": "cube.stl"}, "no mesh"), ({"set": ["tilt=1e9"]}, "tilt"),
])
def test_what_is_wrong_is_said_in_one_sentence(given, words, tmp_path):
    with pytest.raises(Usage, match=re.escape(words)) as problem:
        run(options(tmp_path, **given))
    assert "\n" not in str(problem.value) and not list(tmp_path.iterdir())


def test_a_place_that_takes_no_file(tmp_path, monkeypatch):
    def full(*args, **kwargs):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(files.os, "replace", full)
    with pytest.raises(Problem, match=r"x\.png cannot be written: no space"):
        target.write(tmp_path / "x.png", b"whole")
    assert not list(tmp_path.iterdir())
    with pytest.raises(Usage, match="is a folder"):
        (tmp_path / "y.png").mkdir()
        target.picture_path(tmp_path / "y.png")
    (tmp_path / "file").write_text("")
    with pytest.raises(Problem, match="cannot be made"):
        target.make_folder(tmp_path / "file" / "below")


def test_a_scene_loads_neither_the_window_nor_vtk(tmp_path):
    code = ("import sys; from app.__main__ import main; code = main(sys.argv[1:]); import json; "
            "print(json.dumps([code, sorted({name.partition('.')[0] for name in sys.modules})]))")
    child = subprocess.run([sys.executable, "-c", code, "render", "solid_angle/mesh", "-o", str(tmp_path / "x.png"),
                            "--size", "160x120"], capture_output=True, text=True, cwd=ROOT, timeout=60, check=True)
    code, loaded = json.loads(child.stdout.splitlines()[-1])
    assert code == 0 and not {"imgui_bundle", "pyvista", "vtkmodules", "trimesh", "matplotlib", "rich"} & set(loaded)


# --- the gallery -----------------------------------------------------------------------------------------------------
class Reader(HTMLParser):
    """Reads a page and refuses what is not nested well."""

    VOID = frozenset({"meta", "img", "br", "source", "link", "hr"})

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.tags: list[tuple[str, dict]] = []
        self.text: list[str] = []

    def handle_starttag(self, tag, attrs):
        self.tags.append((tag, dict(attrs)))
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open and self.open.pop() == tag, f"</{tag}> without its partner"

    def handle_data(self, data):
        self.text.append(data)


def read(folder: Path) -> Reader:
    reader = Reader()
    reader.feed((folder / "index.html").read_text(encoding="utf-8"))
    reader.close()
    assert not reader.open
    return reader


def few(*names: str, **changes):
    """The first chapter with some of its steps."""
    loaded = chapters()[0]
    chosen = tuple(replace(s, **changes.get(s.name, {})) for s in loaded.chapter.steps if s.name in names)
    return (replace(loaded, chapter=replace(loaded.chapter, steps=chosen)),)


@pytest.fixture(scope="module")
def made(tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("gallery")
    assert gallery.gallery(folder, found=few("angle", "mesh"), scale=0.2) == 0
    return folder


def test_the_gallery_has_every_picture_and_nothing_from_elsewhere(made):
    reader, text = read(made), (made / "index.html").read_text(encoding="utf-8")
    files = [attrs["src"] for tag, attrs in reader.tags if tag == "img" and not attrs["src"].startswith("data:")]
    assert len(files) == len(set(files)) == 2 * 2 + 4 + 2
    for file in files:
        with Image.open(made / file) as picture:
            assert parse(picture.text["halfway:state"]).step.startswith("solid_angle/")
    assert "http:" not in text and "https:" not in text and "//" not in re.sub(r"data:[\w+/=;,]+", "", text)
    assert all(attrs.get("alt") for tag, attrs in reader.tags if tag == "img")


def test_the_page_says_all_that_a_step_says(made):
    reader = read(made)
    text = " ".join(" ".join(reader.text).split())
    for one in few("angle", "mesh")[0].chapter.steps:
        for said in (one.title, one.idea, one.honesty, one.ask.question, one.ask.told, *one.sources, *one.slides):
            assert " ".join(said.split()) in text
    kinds = [tag for tag, _ in reader.tags]
    assert kinds.count("details") == 4 and kinds.count("section") == 2
    assert "solid_angle/angle" in text and "1.10 sr" in text


def test_formulas_are_pictures_with_their_latex(made):
    drawn = [attrs for tag, attrs in read(made).tags if tag == "img" and attrs["src"].startswith("data:")]
    words = [attrs["alt"] for attrs in drawn]
    assert r"\omega = \frac{{A'}}{r^2}" in words and not any("colour" in word for word in words)
    assert all("vertical-align" in attrs["style"] for attrs in drawn)


def test_links_lead_to_pictures_of_their_state(made):
    reader = read(made)
    ids = {attrs["id"] for _, attrs in reader.tags if "id" in attrs}
    places = [attrs["href"] for tag, attrs in reader.tags if tag == "a"]
    assert len(places) == 2 + 4 + 2 and all(place.startswith("#") and place[1:] in ids for place in places)


def test_a_broken_step_is_listed_and_the_others_are_made(tmp_path, capsys):
    angle = step("solid_angle/angle").step
    scene = replace(angle.scene, glsl=angle.scene.glsl.replace("mix(", "mixed(", 1))
    found = few("angle", "cone", angle={"scene": scene, "title": "<b>&"})
    assert gallery.gallery(tmp_path, found=found, scale=0.2) == 1
    text = (tmp_path / "index.html").read_text(encoding="utf-8")
    read(tmp_path)
    assert "This step is not complete" in text and "mixed" in text and "&lt;b&gt;&amp;" in text and "<b>&" not in text
    assert (tmp_path / "pictures" / "solid_angle-cone-scene.png").is_file()
    assert (tmp_path / "pictures" / "solid_angle-angle-plot.png").is_file()  # the plot of the broken scene is whole
    assert "solid_angle/angle" in capsys.readouterr().err


def test_what_is_done_stays_when_it_is_stopped(tmp_path, monkeypatch, capsys):
    calls = []

    def once(found, *rest):
        if calls:
            raise KeyboardInterrupt
        calls.append(found.id)
        return gallery.Shown(found)

    monkeypatch.setattr(gallery, "rendered", once)
    assert gallery.gallery(tmp_path, found=few("angle", "cone")) == 1
    read(tmp_path)
    assert "1 of 2 steps" in capsys.readouterr().out


def test_without_opengl_the_gallery_says_so_once_and_at_once(tmp_path):
    """Seven steps without a picture each, and a process of plots that dies for each, would take minutes."""
    nowhere = {"__EGL_VENDOR_LIBRARY_FILENAMES": "/nonexistent", "LIBGL_DRIVERS_PATH": "/nonexistent"}
    clean = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    done = subprocess.run([sys.executable, "-m", "app"], cwd=ROOT, capture_output=True, text=True, timeout=60,
                          check=False, env=clean | nowhere | {gallery.VARIABLE: str(tmp_path / "new")})
    said = done.stderr.strip().splitlines()
    assert done.returncode == 1 and len(said) == 1 and "`halfway doctor`" in said[0], done.stderr


def test_the_folder_is_named_by_the_option_or_the_environment(tmp_path, monkeypatch):
    asked = []
    monkeypatch.setattr(gallery, "gallery", lambda folder, theme, mesh, ies: asked.append((folder, theme.name)) or 0)
    monkeypatch.setenv(gallery.VARIABLE, str(tmp_path / "a"))
    assert gallery.run(SimpleNamespace(theme="")) == 0
    assert gallery.run(SimpleNamespace(theme="light", output=tmp_path / "b")) == 0
    assert asked == [(tmp_path / "a", "dark"), (tmp_path / "b", "light")]
    with pytest.raises(Usage, match="Did you mean dark"):
        gallery.run(SimpleNamespace(theme="darc"))


def test_the_bar_counts_the_steps_on_a_terminal(monkeypatch):
    class Terminal(io.StringIO):
        def isatty(self) -> bool:
            return True

    out = Terminal()
    monkeypatch.setattr(sys, "stderr", out)
    with console.progress(2) as tell:
        for done, title in enumerate(("one", "two", "")):
            tell(done, title)
    assert "2/2" in out.getvalue()


# --- the file --------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("size", [(1, 1), (1, 7), (64, 3), (257, 130)])
def test_a_png_is_read_back_as_it_was(size):
    """By another reader than ours: every pixel, and what stands in its text chunks, in any script."""
    pixels = np.random.default_rng(3).integers(0, 256, (*size[::-1], 3), np.uint8)
    words = {"Title": "Schlick’s fit, θ = 82°", "halfway:state": "fresnel/schlick?theta=82"}
    found = Image.open(io.BytesIO(png(Image.fromarray(pixels), words)))
    found.load()
    np.testing.assert_array_equal(np.asarray(found), pixels)
    assert (found.mode, found.text) == ("RGB", words)


def test_the_version_is_the_projects():
    assert tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["version"] == VERSION
