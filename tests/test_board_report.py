"""The board as a picture: plots call any model by its word, spheres are lit as they should be, and it is whole."""

import os

import numpy as np
import pytest
from PIL import Image

from app import plots
from app.__main__ import main
from app.board.coated import Coated
from app.board.course_model import CourseModel
from app.board.fit import Fit
from app.board.models import opened
from app.board.terms import ANGLES, LUMINANCE, WEIGHTS, packed, unpacked
from app.export.board_report import MOST, VALUES, chosen, letters, listing, report, shown, together
from app.export.board_words import lines
from app.export.ink import Ink
from app.export.lit_sphere import FILL, LIGHT, sphere
from app.lesson import Curve, Curves, ImageSlice, Model, Term
from app.optics import arguments, twin
from app.optics.colour import linear_to_srgb
from app.optics.cook_torrance import albedo_cook_torrance
from app.optics.spherical import direction
from app.plots.models import Lit
from app.plots.sweep import Swept, cut
from app.problem import Problem, Usage
from app.theme import THEMES

TINTED = """analytic
::begin parameters
float n 0 4 1
color tint 1 .5 .25
bool twice 0
::end parameters
::begin shader
vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { return (twice ? 2. : 1.) * n * tint / 3.14159265; }
::end shader
"""
N = np.array([0.0, 0.0, 1.0])
L, V = direction(0.6, 2.0), direction(0.3, 0.0)


@pytest.fixture
def tinted(tmp_path):
    path = tmp_path / "tinted.brdf"
    path.write_text(TINTED)
    return path


# --- a model as a term -----------------------------------------------------------------------------------------------
def test_a_model_of_the_course_is_its_twin():
    f = twin("board:cook_torrance")
    assert arguments("board:cook_torrance") == ("n", "l", "v", "channel", "values")
    assert f(N, L, V, 0, (0.4, 0.2)) == twin("brdf_cook_torrance")(N, L, V, 0.4, 0.2)
    assert f(N, L, V, LUMINANCE, (0.4, 0.2)) == pytest.approx(f(N, L, V, 2, (0.4, 0.2)), rel=1e-12)


def test_a_file_is_its_glsl(tinted):
    f, values = twin(f"board:{tinted}"), (0.5, 1.0, 0.5, 0.25, 1.0)
    found = [f(N, L, V, channel, values) for channel in (0, 1, 2, LUMINANCE)]
    np.testing.assert_allclose(found, np.array([1, 0.5, 0.25, WEIGHTS @ [1, 0.5, 0.25]]) / np.pi, rtol=1e-6)


def test_a_file_that_has_changed_is_read_again(tinted):
    values = (1.0, 1.0, 0.5, 0.25, 0.0)
    before = twin(f"board:{tinted}")(N, L, V, 0, values)
    tinted.write_text(TINTED.replace("2. : 1.", "2. : .5"))
    os.utime(tinted, ns=(1, 1))
    assert twin(f"board:{tinted}")(N, L, V, 0, values) == pytest.approx(before / 2)


def test_what_a_plot_keeps_goes_when_the_file_changes(tinted):
    """A drawing computes a lobe anew when its key is another one."""
    one = Lit(Model("x", Term(f"board:{tinted}", {"values": (1.0, 1.0, 0.5, 0.25, 0.0), "channel": 0})), VALUES, "v")
    before = one.key
    assert one.key == before
    tinted.write_text(TINTED.replace("2. : 1.", "2. : .5"))
    os.utime(tinted, ns=(1, 1))
    assert one.key != before and one.key[-1] != before[-1]


def test_values_are_packed_and_unpacked(tinted):
    model = opened(str(tinted))
    values = {"n": 0.5, "tint": (0.1, 0.2, 0.3), "twice": True}
    numbers = packed(model.parameters, values)
    assert numbers == (0.5, 0.1, 0.2, 0.3, 1.0) and unpacked(model.parameters, numbers) == values
    assert packed(model.parameters, {}) == (1.0, 1.0, 0.5, 0.25, 0.0)
    assert listing(values) == "n 0.5, tint 0.1 0.2 0.3, twice yes"


def test_the_albedo_of_a_model():
    found = twin("albedo:cook_torrance")(ANGLES, 0, (0.3, 0.9))
    np.testing.assert_allclose(found, albedo_cook_torrance(ANGLES, 0.3, 0.9), atol=1e-3)
    between = np.radians(np.linspace(0, 85, 200))
    np.testing.assert_allclose(twin("albedo:lambert")(between, 0, (0.5,)), 0.5, atol=1e-5)
    off = twin("albedo:cook_torrance")(between, 0, (0.3, 0.04)) - albedo_cook_torrance(between, 0.3, 0.04)
    assert abs(off).max() < 1e-3


@pytest.mark.parametrize("name", ["board:lambret", "colour:lambert", "board:/none/x.brdf"])
def test_a_name_that_means_nothing_is_a_problem(name):
    with pytest.raises(Problem):
        twin(name)


def test_the_plots_process_calls_a_users_file(tinted):
    """The curve of a file is drawn as that of the twin it equals, up to what float32 may move."""
    term = Term(f"board:{tinted}", {"values": (1.0, 0.5, 0.5, 0.5, 0.0), "channel": 0})
    same = Term("brdf_lambert", {"rho": 0.5})
    pictures = [plots.picture(Curves("f", "theta_v", (Curve("f", one),), "1/sr"),
                              {"theta_l": 0.5, "theta_v": 0.5, "phi": 1.0}, (360, 300), THEMES["dark"],
                              {"theta_v": (0.0, 1.5)}) for one in (term, same)]
    np.testing.assert_allclose(*(picture.astype(int) for picture in pictures), rtol=0, atol=1)
    assert len(np.unique(pictures[0].reshape(-1, 3), axis=0)) > 10


@pytest.mark.parametrize("m", [0.01, 0.03, 0.1, 0.3, 1.0])
def test_albedo_curves_against_the_semi_analytic_one(m):
    """Over a fine sweep, so that what lies between the computed angles counts too; V-grooves have bends all over."""
    theta = np.radians(np.linspace(0, 89.9, 400))
    off = np.abs(twin("albedo:cook_torrance")(theta, 0, (m, 1.0)) - albedo_cook_torrance(theta, m, 1.0))
    assert off[theta < np.radians(88)].max() < 1.5e-4 and off.max() < 8e-4


def test_a_curve_that_leaves_its_axis_is_cut_with_a_word():
    plot = Curves("c", "theta_v", (Curve("calm", Term("brdf_lambert_at")),), "share", most=2.0)
    y = np.array([0.5, 1.0, 3.0, 12.6, np.nan, 1.9])
    one = cut(Swept(plot.curves[0], y, 12.6, ~np.isfinite(y)), 2.0)
    np.testing.assert_array_equal(one.y, [0.5, 1.0, 2.0, np.nan, np.nan, 1.9])
    assert one.cut == 12.6 and np.isnan(one.now) and one.cut > 2
    same = Swept(plot.curves[0], y[:2], 1.0, np.zeros(2, bool))
    assert cut(same, 2.0) is same


# --- the sphere ------------------------------------------------------------------------------------------------------
def pixel(picture: Image.Image, n: np.ndarray) -> np.ndarray:
    side = picture.width
    return np.asarray(picture)[int((1 - FILL * n[1]) * side / 2), int((1 + FILL * n[0]) * side / 2)]


def test_a_white_matte_sphere_is_white_where_it_faces_the_light():
    light = LIGHT / np.linalg.norm(LIGHT)
    picture = sphere(CourseModel("lambert"), {"rho": 0.5}, 256, (20, 30, 40))
    assert abs(pixel(picture, light).astype(int) - round(255 * float(linear_to_srgb(0.5)))).max() <= 1
    assert abs(pixel(picture, N).astype(int) - round(255 * float(linear_to_srgb(0.5 * light[2])))).max() <= 1
    assert pixel(picture, -light).max() == 0  # its projection lies on the dark side
    assert tuple(np.asarray(picture)[0, 0]) == (20, 30, 40)


def test_what_is_not_finite_is_magenta(tinted):
    tinted.write_text(TINTED.replace("n * tint", "sqrt(n - 2.) * tint"))
    picture = sphere(opened(str(tinted)), {"n": 1.0}, 64, (0, 0, 0))
    np.testing.assert_allclose(pixel(picture, N), [255, 46, 209], atol=1)


def test_an_image_slice_has_a_hole_where_there_is_no_number(tinted):
    """Here above theta_d = 60 degrees: a third of the picture is empty."""
    painted = []
    for factor in ("1.", "sqrt(dot(L, normalize(L + V)) - .5)", "sqrt(-1. - dot(L, L))"):
        tinted.write_text(TINTED.replace("n * tint", f"{factor} * tint"))
        model = Model("x", Term(f"board:{tinted}", {"values": (1.0, 1.0, 0.5, 0.25, 0.0), "channel": 0}))
        picture = plots.picture(ImageSlice("", (model,)), VALUES, (400, 400), THEMES["light"])
        painted.append(int((picture[:, 360] != picture[0, 0]).any(-1).sum()))
    whole, part, none = painted
    assert whole - none > 150 and (whole - part) / (whole - none) == pytest.approx(1 / 3, abs=0.02)


# --- the report ------------------------------------------------------------------------------------------------------
def test_one_model_of_colour_has_three_lobes_and_several_have_one_each(tinted):
    alone, several = shown([str(tinted)]), shown([str(tinted), "lambert"])
    assert [len(plot.curves) for plot in together(alone) if isinstance(plot, Curves)] == [3]
    assert "channel" not in together(alone)[0].models[0].term.args
    assert [one.term.args["channel"] for one in together(several)[0].models] == [LUMINANCE, 0]
    assert [one.colour for one in several] == ["estimate", "f"]


def test_lobes_of_very_different_size_are_logarithmic():
    assert chosen(shown(["lambert", "oren_nayar"]))["lobe_scale"] == 0
    assert chosen(shown(["lambert", "cook_torrance"]))["lobe_scale"] == 0
    assert chosen(shown(["oren_nayar", "coated"]))["lobe_scale"] == 0
    bright = shown(["oren_nayar", "cook_torrance"])
    bright[1].values.update(m=0.05, f0=1.0)
    assert chosen(bright)["lobe_scale"] == 2


def test_what_is_said_has_room(tinted):
    ink = Ink(THEMES["projector"], (1600, 720))
    tinted.write_text(TINTED.replace("tint /", "tint * dot(N, L) / V.z /"))
    one = shown([str(tinted)])[0]
    for room in (250.0, 400.0, 900.0):
        said = lines(one.label, one.colour, one.about, one.model.badges(), room, ink)
        assert [line.ok for line in said if line.ok is not None] == [True, False, False, True]
        picture = Image.new("RGB", (1000, 60 * len(said)), ink.colour("background"))
        from PIL import ImageDraw

        for i, line in enumerate(said):
            line.write(picture, ImageDraw.Draw(picture), (4, 60 * i + 40), ink)
        drawn = np.asarray(picture)
        assert (drawn[:, round(room) + 8:] == drawn[0, 0]).all()  # nothing beyond
    assert any("θ_v" in line.text + line.beside for line in said)


def test_small_plots_have_small_letters():
    assert letters(24, 140) == 10 and letters(16, 420) == pytest.approx(18.4) and letters(16, 840) == pytest.approx(9.2)


@pytest.mark.parametrize(("theme", "size"), [("dark", (1600, 1000)), ("projector", (1600, 1000))])
def test_the_whole_board(tinted, theme, size):
    near = Fit(0.2, (0.1, 0.2, 0.3), (0.04, 0.04, 0.04), 0.0, (0.0, 0.0, 0.0))
    models = shown([str(tinted), "lambert", "cook_torrance", "coated"])
    assert Coated("x", near).parameters[0].default == 0.2
    picture = report(models, size, THEMES[theme])
    assert picture.size == size
    drawn, ink = np.asarray(picture).astype(int), Ink(THEMES[theme], size)
    for one in models:  # each in its colour, in each of the three plots and in its column
        hits = (abs(drawn - ink.colour(one.colour)).max(-1) < 3)[90:]
        across = np.flatnonzero(hits[:330].any(0)) / size[0]
        assert all(((across > i / 3) & (across < (i + 1) / 3)).any() for i in range(3)), one.label
        i = models.index(one)
        assert hits[400:, i * size[0] // 4:(i + 1) * size[0] // 4].any(), one.label
    border = np.concatenate([drawn[:3].reshape(-1, 3), drawn[-3:].reshape(-1, 3), drawn[:, -3:].reshape(-1, 3)])
    assert (border == ink.colour("background")).all()  # nothing runs over the edge


def test_the_command_writes_it(tinted, tmp_path, capsys):
    out = tmp_path / "report.png"
    assert main(["board", str(tinted), "-o", str(out), "--size", "800x500", "--theme", "light"]) == 0
    with Image.open(out) as picture:
        assert picture.size == (800, 500)
    assert "tinted" in capsys.readouterr().out
    assert main(["board", "lambert", "-o", str(tmp_path / "report.jpg")]) == 2
    with pytest.raises(Usage):
        opened("lambret")


def test_a_folder_of_many_is_drawn_in_part_and_parameters_can_be_set(tinted, tmp_path, capsys):
    folder = tmp_path / "many"
    folder.mkdir()
    for i in range(MOST + 1):
        (folder / f"m{i}.brdf").write_text(tinted.read_text())
    (folder / "broken.brdf").write_text("analytic")
    out = tmp_path / "many.png"
    assert main(["board", str(folder), "-o", str(out), "--size", "400x250", "--set", "n=0.25"]) == 0
    said = capsys.readouterr()
    assert out.exists() and "first 4 of 5 models" in said.err and "broken.brdf has no ::begin shader" in said.err
    assert all(f"m{i}" in said.out for i in range(MOST + 1)), "each has its verdict"
