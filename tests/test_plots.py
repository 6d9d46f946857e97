"""Plots: what the pictures show, and the process that draws them."""

import math
import os
import subprocess
import sys
import threading
from dataclasses import replace

import numpy as np
import pytest

from app.lesson import Camera, Curve, Curves, Faces, Figure, ImageSlice, Lobes, Model, Sheet, Slice, Term
from app.plots import PlotDied, PlotProcess, picture
from app.plots.dashes import along, dashed
from app.plots.look import Look
from app.plots.models import Scale, lit
from app.plots.roles import colour_of
from app.plots.sweep import Sweep, linear_frame
from app.plots.ticks import Axis, linear_ticks, nice, number
from app.plots.words import Entry, header, wrapped
from app.problem import Problem
from app.spoken import axis_title, plain
from app.terms import evaluate
from app.theme import THEMES, colour, rgb

DARK, LIGHT, PROJECTOR = THEMES["dark"], THEMES["light"], THEMES["projector"]
SIZE = (420, 420)
PATCH = {"theta": 0.7, "phi": 0.4, "distance": 2.0, "tilt": 0.3, "width": 0.8, "half_angle": 0.6}
AGAINST = Curves("Against distance", "distance", (
    Curve("exact", Term("solid_angle_patch")),
    Curve("small", Term("solid_angle_patch_small"), role="estimate"),
    Curve("textbook", Term("solid_angle_patch_small", {"width": 1.1}), role="printed")), "sr", "log")
NUSSELT = Figure("The Nusselt analogue", (
    Sheet("patch", Term("patch_point"), colour="l", cells=(8, 8)),
    Sheet("on the dome", Term("patch_point"), onto="sphere", cells=(8, 8)),
    Sheet("on the disk", Term("patch_point"), onto="disk", colour="v", cells=(8, 8))),
    dome="hemisphere", disk=True, camera=Camera(distance=7.5, target=(0.2, 0.1, 0.45)))
FACES = Faces("Each face")
TETRAHEDRON = np.array([(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)]) * 0.6
TETRAHEDRON = TETRAHEDRON[np.array([(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)])]
EYE = {"eye": (0.0, 0.0, 0.0)}


@pytest.fixture(scope="module")
def plots():
    with PlotProcess(SIZE, DARK) as process:
        yield process


def drawn(plots, plot, values, **more):
    plots.request(plot, values, size=more.pop("size", SIZE), theme=more.pop("theme", DARK), **more)
    found = plots.wait(120)
    assert found is not None, "no picture within two minutes"
    assert not found.error, found.error
    return found.image


def near(image, wanted, within=10):
    """Which pixels have a colour."""
    return np.abs(image.astype(int) - np.round(255 * np.array(wanted))).max(-1) <= within


CASES = [(AGAINST, PATCH, None), (NUSSELT, PATCH, None), (FACES, EYE, TETRAHEDRON)]


@pytest.mark.parametrize("theme", THEMES.values(), ids=list(THEMES))
@pytest.mark.parametrize("size", [(360, 360), (420, 600), (800, 600)], ids=str)
@pytest.mark.parametrize(("plot", "values", "mesh"), CASES, ids=["curves", "figure", "faces"])
def test_a_picture_is_filled_and_nothing_is_cut(plots, plot, values, mesh, size, theme):
    image = drawn(plots, plot, values, size=size, theme=theme, triangles=mesh)
    assert image.shape == (size[1], size[0], 3)
    assert image.dtype == np.uint8
    ground = near(image, rgb(theme.background), 0)
    assert 0.3 < ground.mean() < 0.97, "empty, or covered"
    for edge in (ground[:2], ground[-2:], ground[:, :2], ground[:, -2:]):
        assert edge.all(), "something is cut by the picture's edge"
    assert near(image, rgb(theme.foreground)).any()


@pytest.mark.parametrize("theme", THEMES.values(), ids=list(THEMES))
def test_curves_and_sheets_have_the_colours_of_the_grammar(plots, theme):
    curves = drawn(plots, AGAINST, PATCH, theme=theme)
    assert all(near(curves, colour(role, theme)).sum() > 30 for role in ("exact", "estimate", "printed"))
    figure = drawn(plots, NUSSELT, PATCH, theme=theme)
    assert near(figure[:120], colour("v", theme)).sum() > 30, "the legend's green"
    lit = figure[120:].astype(int)
    assert ((lit[..., 1] > lit[..., 0] + 60) & (lit[..., 1] > lit[..., 2] + 15)).sum() > 100, "the sheet on the disk"


def test_the_dot_moves_along_a_frame_that_keeps_still(plots):
    """The present value changes the dot and its line, and nothing else."""
    first, second = (drawn(plots, AGAINST, {**PATCH, "distance": d}) for d in (1.0, 3.0))
    changed = np.any(first != second, -1)
    columns, head = np.flatnonzero(changed.any(0)), 70
    assert columns.size
    assert not changed[:head].any()
    assert not changed[-20:].any()
    left, right = columns[columns < 210], columns[columns >= 210]
    assert left.size and right.size
    assert np.ptp(left) < 30 and np.ptp(right) < 30, "only the two places of the dot"


def test_other_values_change_the_curves_but_not_the_frame(plots):
    first, second = (drawn(plots, AGAINST, {**PATCH, "tilt": t}) for t in (0.3, 0.5))
    changed = np.any(first != second, -1)
    assert changed.sum() > 300
    assert not changed[:70].any()
    assert not changed[-45:].any(), "the ticks of the horizontal axis"
    assert not changed[:, :25].any(), "the ticks of the vertical axis"


def test_a_figure_keeps_its_dome_and_follows_values_and_camera(plots):
    first, second = (drawn(plots, NUSSELT, {**PATCH, "theta": t}) for t in (0.7, 0.8))
    changed = np.any(first != second, -1)
    assert 300 < changed.sum() < 0.4 * changed.size
    assert not changed[:70].any()
    turned = drawn(plots, NUSSELT, {**PATCH, "theta": 0.8}, camera=Camera(azimuth=40, distance=7.5))
    assert np.any(turned != second, -1).sum() > 5000


@pytest.mark.parametrize("size", [(64, 64), (300, 100), (100, 300)], ids=str)
def test_a_plot_with_no_place_between_its_words_is_drawn_larger(plots, size):
    image = drawn(plots, AGAINST, PATCH, size=size, theme=PROJECTOR)  # raises what could not be drawn
    assert all(have >= want for have, want in zip(image.shape[:2], size[::-1], strict=True))
    assert near(image, colour("printed", PROJECTOR)).any()


def test_the_words_at_ticks_cast_no_shadows(plots):
    """VTK's own words have a faint row below them at some sizes: their texture comes round again."""
    against = replace(AGAINST, error=True, y_scale="log")
    for size in ((478, 514), (490, 514), (491, 516)):
        image = drawn(plots, against, PATCH, size=size, theme=LIGHT)
        margin = image[int(0.2 * size[1]):int(0.85 * size[1]), :42]
        inked = ~near(margin, rgb(LIGHT.background), 0).all(axis=1)
        starts = np.flatnonzero(np.diff(np.r_[False, inked]) & inked)
        assert len(starts) >= 3, "no words"
        for start in starts:
            end = start + int(np.argmin(np.r_[inked[start:], False]))
            assert margin[start:end].min() < 110, f"a shadow in the rows from {start} to {end}"


def test_the_same_wish_gives_the_same_picture(plots):
    for plot, values, mesh in CASES:
        first, second = (drawn(plots, plot, values, triangles=mesh) for _ in range(2))
        assert (first == second).all()


def test_a_coarse_picture_is_the_fine_one_with_rougher_edges(plots):
    fine, coarse = (drawn(plots, NUSSELT, PATCH, fine=f).astype(int) for f in (True, False))
    assert 0 < np.abs(fine - coarse).mean() < 6


def test_faces_are_coloured_by_the_side_that_is_seen(plots):
    """From inside all faces are positive (orange), and some are negative (blue) from outside."""
    def blue(eye):
        image = drawn(plots, FACES, {"eye": eye}, triangles=TETRAHEDRON)[40:-80].astype(int)
        return ((image[..., 2] > image[..., 0] + 40) & (image[..., 2] > image[..., 1] + 20)).sum()

    assert blue((0.0, 0.0, 0.0)) < 50
    assert blue((0.0, -2.0, 0.5)) > 1000


def test_a_sheet_can_be_coloured_by_a_height(plots):
    sheet = Sheet("patch", Term("patch_point"), height=Term("solid_angle_cone", {"half_angle": "s"}),
                  height_label="sr of a cone", cells=(12, 12))
    heights = Figure("Coloured", (sheet,), camera=Camera(distance=9, target=(0.8, 0.4, 1.3)))
    image = drawn(plots, heights, PATCH)
    assert near(image, (0.2670, 0.0049, 0.3294)).any(), "the scale begins with viridis' violet"
    assert len(np.unique(image[60:-60].reshape(-1, 3), axis=0)) > 100


GAPS = Curves("With gaps", "half_angle", (
    Curve("exact", Term("solid_angle_cone")),
    Curve("broken", Term("solid_angle_rectangle_naive", {"width": "half_angle", "depth": 1.0, "distance": 0.0}),
          role="estimate")), "sr")


def test_what_is_not_finite_is_counted_and_marked(plots):
    sweep = Sweep(GAPS, {})
    broken = sweep.run(PATCH)[1]
    assert broken.not_finite.all()
    image = drawn(plots, GAPS, PATCH)
    assert near(image, (1.0, 0.18, 0.82), 2).sum() > 50, "magenta crosses"
    assert near(image, rgb("#FF4FD8"), 2).sum() > 100, "the box of the notice"


def test_curves_that_are_0_everywhere_are_told_in_one_sentence():
    """A logarithmic axis has nothing to show of them; a lamp below the floor makes all of a step's curves so."""
    from app.plots.roles import nothing_in, notices_of

    plot = Curves("Below the floor", "distance", tuple(
        Curve(name, Term("irradiance_positional", {"radiant_intensity": 1.0, "theta": theta, "source_radius": 0.01}))
        for name, theta in (("from behind", 2.0), ("also", 2.5), ("ahead", 0.1))), "", y_scale="log")
    drawn = Sweep(plot, {}).run({"distance": 1.0})
    assert nothing_in(drawn) == ["2 of 3 curves are 0 everywhere"] and not any(map(notices_of, drawn))
    assert nothing_in(drawn[1:]) == ["“also” is 0 everywhere"] and nothing_in(drawn[2:]) == []


def test_a_mesh_face_that_is_not_finite_is_told(plots):
    image = drawn(plots, FACES, {"eye": (math.nan, 0.0, 0.0)}, triangles=TETRAHEDRON)
    assert near(image, rgb("#FF4FD8"), 2).sum() > 100


def test_errors_are_taken_against_the_exact_curve():
    plot = Curves("Errors", "half_angle", (
        Curve("exact", Term("solid_angle_cone")), Curve("naive", Term("solid_angle_cone_naive"), role="printed")),
        "relative error", error=True, x_scale="log")
    sweep = Sweep(plot, {"half_angle": (1e-9, 1.0)})
    (naive,) = sweep.run({"half_angle": 1e-9})
    assert naive.curve.label == "naive"
    assert naive.now == 1.0, "2 pi (1 - cos 1e-9) is 0 in float64: all is lost"
    assert naive.y[0] == 1.0
    assert np.median(naive.y[-60:]) < 1e-13
    assert naive.y.min() >= 1e-17
    frame = sweep.framed([naive])
    assert (frame.low, frame.high) == (1e-17, 1.0)
    with pytest.raises(Problem, match="no exact curve"):
        Sweep(Curves("Errors", "half_angle", plot.curves[1:], "", error=True), {})


def test_float32_curves_are_the_glsl_twins(plots):
    """They are drawn beside VTK in one process, and both contexts live."""
    plot = Curves("Errors", "half_angle", (
        Curve("exact", Term("solid_angle_cone")),
        Curve("stable", Term("solid_angle_cone"), role="estimate", precision="float32"),
        Curve("naive", Term("solid_angle_cone_naive"), role="printed", precision="float32")), "error", error=True)
    for k in range(3):
        image = drawn(plots, plot, {"half_angle": 1e-3 * (k + 1)}, ranges={"half_angle": (1e-5, 1.0)})
        assert near(image, colour("estimate", DARK)).sum() > 300
        drawn(plots, NUSSELT, PATCH)


def test_the_vertical_axis_waits_before_it_changes():
    plot = Curves("Linear", "tilt", (Curve("exact", Term("solid_angle_patch")),), "sr")
    sweep = Sweep(plot, {})
    frames = [sweep.framed(sweep.run({**PATCH, "distance": d})) for d in (2.0, 2.2, 3.0, 5.0, 2.0)]
    assert frames[0] == frames[1] == frames[2]
    assert frames[3].high < frames[2].high
    assert frames[4] == frames[0]


def test_only_what_changed_is_evaluated_again():
    sweep = Sweep(AGAINST, {})
    sweep.run(PATCH)
    kept = sweep.kept[0][1]
    sweep.run({**PATCH, "distance": 3.0})
    assert sweep.kept[0][1] is kept
    sweep.run({**PATCH, "tilt": 0.5})
    assert sweep.kept[0][1] is not kept


@pytest.mark.parametrize(("low", "high", "log", "most", "labels"), [
    (0, 180, False, 7, ["0", "30", "60", "90", "120", "150", "180"]),
    (-90, 90, False, 4, ["−90", "−45", "0", "45", "90"]),
    (0.5, 5, True, 6, ["0.5", "1", "2", "5"]),
    (1e-7, 10, True, 5, ["10⁻⁶", "10⁻⁴", "10⁻²", "10⁰"]),
    (0.1, 1000, True, 6, ["0.1", "1", "10", "100", "1000"]),
    (0, 3e-5, False, 4, ["0", "10⁻⁵", "2·10⁻⁵", "3·10⁻⁵"]),
])
def test_ticks_are_round_numbers(low, high, log, most, labels):
    positions, found = Axis(low, high, log, degrees=high in (180, 90)).ticks(most)
    assert found == labels
    assert len(positions) == len(found)


def test_numbers_and_symbols_in_words():
    assert [number(x) for x in (0, -0.25, 1e5, -2e-7)] == ["0", "−0.25", "10⁵", "−2·10⁻⁷"]
    assert plain(r"\Delta\theta") == "Δθ"
    assert plain("r_0") == "r₀"
    assert plain(r"\theta_v") == "θv"
    assert axis_title("theta_v") == "eye's angle θv in °"
    assert axis_title("n_dot_l") == "n·l"
    assert axis_title("half_angle") == "half angle θ in °"
    assert axis_title("distance") == "distance r in m"
    assert nice(0.31) == pytest.approx(0.4)
    assert linear_ticks(1.0, 1.0, 5) == [1.0]


def test_an_axis_ends_where_the_curves_end():
    """A share that reaches 1 has an axis to 1; gold's 1.034 one to 1.2."""
    assert [linear_frame(np.array([0.0, most])).high for most in (1.0, 1.0346, 0.31)] == pytest.approx([1.0, 1.2, 0.4])
    assert (linear_frame(np.array([-1.0, 2.0])).low, linear_frame(np.array([-3.0, -1.0])).low) == (-1.0, -3.0)


def test_a_curve_may_have_its_own_colour(plots):
    look = Look(THEMES["projector"], (420, 420))
    cone = Curve("cone", Term("solid_angle_cone"))
    assert colour_of(cone, look) == look.colour("exact") != colour_of(replace(cone, colour="#C99A1E"), look)
    assert np.allclose(colour_of(replace(cone, colour="#C99A1E"), replace(look, theme=THEMES["light"])), rgb("#C99A1E"))


def test_a_legend_wraps_into_the_width():
    from app.plots.look import Look

    look = Look(PROJECTOR, (360, 360))
    strip = header(look, "A title that is much too long for one line of a small picture",
                   [Entry("circle", (0, 0, 1), "a label with many words that needs more than a single line")] * 3)
    assert strip.shape[1] == 360
    assert near(strip[:, -3:], (1, 1, 1), 0).all()
    assert wrapped(look, "x" * 200, 24, 300)[0] != "x" * 200


def test_request_and_poll_return_at_once_and_the_latest_wish_wins():
    came = threading.Event()
    with PlotProcess(SIZE, DARK, on_picture=came.set) as plots:
        assert plots.poll() is None
        wishes = [plots.request(AGAINST, {**PATCH, "distance": 1 + k / 100}) for k in range(100)]
        assert came.wait(60)
        shown = []
        while not shown or shown[-1].wish.number != wishes[-1]:
            found = plots.wait(60)
            assert found is not None
            shown.append(found)
        assert len(shown) < 5, "most wishes were forgotten"
        assert shown[-1].wish.values["distance"] == 1.99
        assert plots.poll() is None, "a picture is given once"
        assert plots.idle
        if hasattr(os, "getpriority"):  # a window's picture goes first
            assert os.getpriority(os.PRIO_PROCESS, plots.child.pid) > os.getpriority(os.PRIO_PROCESS, 0)


def test_a_failing_drawing_is_a_message_and_not_a_death(plots):
    missing = Curves("A mistyped curve", "distance", (Curve("exact", Term("solid_angel_patch")),), "sr")
    plots.request(missing, PATCH, size=SIZE, theme=DARK)
    found = plots.wait(60)
    assert "solid_angle_patch" in found.error, "it says what was meant"
    assert found.image.shape == (420, 420, 3)
    assert near(found.image, rgb("#FF4FD8"), 2).sum() > 100
    plots.request(FACES, EYE, triangles=None)
    assert "needs a mesh" in plots.wait(60).error
    drawn(plots, AGAINST, PATCH)


def test_a_dead_process_says_so_and_starts_again():
    with PlotProcess(SIZE, DARK) as plots:
        before = drawn(plots, FACES, EYE, triangles=TETRAHEDRON)
        plots.child.kill()
        plots.child.wait()
        plots.request(FACES, EYE, triangles=TETRAHEDRON)
        with pytest.raises(PlotDied, match=r"has ended \((signal|exit code)"):
            plots.wait(60)
        assert plots.poll() is None, "it is told once"
        plots.restart()
        after = plots.wait(60)
        assert (after.image == before).all(), "the last wish, mesh and all, is drawn again"


def test_a_death_while_idle_is_told_at_the_next_wish_or_never_hangs():
    plots = PlotProcess(SIZE, DARK)
    plots.child.kill()
    plots.child.wait()
    plots.close()
    plots.close()


def test_closing_leaves_no_process_and_no_pipe():
    plots = PlotProcess(SIZE, DARK)
    drawn(plots, AGAINST, PATCH)
    child, thread = plots.child, plots.thread
    plots.request(AGAINST, {**PATCH, "tilt": 0.4})
    plots.close()
    assert child.returncode is not None
    assert not thread.is_alive()
    assert child.stdin.closed and child.stdout.closed and plots.words.closed


WITHOUT_VTK = """
import sys
from app.lesson import Curve, Curves, Term
from app.plots import PlotProcess
from app.theme import THEMES
with PlotProcess((200, 200), THEMES["dark"]) as plots:
    plots.request(Curves("", "tilt", (Curve("exact", Term("solid_angle_patch")),), "sr"),
                  {"distance": 2.0, "width": 1.0, "tilt": 0.0})
    assert plots.wait(60).image.shape == (200, 200, 3)
    print(sorted(name for name in ("pyvista", "vtk", "vtkmodules", "matplotlib", "PIL") if name in sys.modules))
"""


def test_the_window_s_process_never_loads_vtk():
    """Run as text, without a guard for __main__: nothing is imported twice."""
    command = [sys.executable, "-W", "error", "-c", WITHOUT_VTK]
    found = subprocess.run(command, capture_output=True, text=True, check=False)
    assert found.returncode == 0, found.stderr
    assert found.stdout.strip() == "[]"
    assert found.stderr == ""


ORPHAN = """
import os, sys, time
from app.plots import PlotProcess
from app.theme import THEMES
plots = PlotProcess((200, 200), THEMES["dark"])
print(plots.child.pid, flush=True)
time.sleep(600)
"""


def test_the_child_ends_when_its_parent_is_killed():
    import psutil

    with subprocess.Popen([sys.executable, "-c", ORPHAN], stdout=subprocess.PIPE, text=True) as parent:
        child = psutil.Process(int(parent.stdout.readline()))
        parent.kill()
        parent.wait()
        _gone, alive = psutil.wait_procs([child], timeout=60)
    assert not alive


def test_a_still_is_drawn_in_the_kept_process():
    first = picture(AGAINST, PATCH, (300, 240), LIGHT)
    assert first.shape == (240, 300, 3)
    assert (picture(AGAINST, PATCH, (300, 240), LIGHT) == first).all()
    near_by = picture(AGAINST, {**PATCH, "distance": 1.0, "width": 2.0}, (300, 240), LIGHT)
    assert (near_by != first).any()
    assert (picture(AGAINST, PATCH, (300, 240), LIGHT) == first).all(), "whatever was drawn before"
    assert (picture(AGAINST, PATCH, (300, 240), LIGHT, steady=True) == first).all()
    with pytest.raises(Problem, match="Mistyped"):
        picture(Curves("Mistyped", "distance", (Curve("", Term("nothing")),), "sr"), PATCH, (300, 240), LIGHT)


@pytest.mark.parametrize("style", ["solid", "dashed", "dashdot", "dotted"])
def test_dashes_lie_on_the_line_and_leave_gaps(style):
    x = np.linspace(0, 200, 41)
    y = np.where(x == 100, np.nan, 50.0)
    at, ends = dashed(np.column_stack([x, y]), style, 2.0)
    cut_x, cut_y = along(x, at, ends), along(y, at, ends)
    assert np.isnan(cut_x).sum() == ends.sum() >= (2 if style == "solid" else 10)
    seen = cut_x[~np.isnan(cut_x)]
    assert (np.diff(seen) >= 0).all()
    assert not ((seen > 95.001) & (seen < 104.999)).any(), "no dash crosses what is not finite"
    assert (cut_y[~np.isnan(cut_x)] == 50).all()


# --- lobes -----------------------------------------------------------------------------------------------------------
MATT = Model("matt", Term("brdf_lambert", {"rho": 0.8}), "d")
LIGHT_AND_EYE = {"theta_l": 0.7, "theta_v": 0.5, "phi": math.pi}
LOBES = Lobes("A lobe", (MATT, Model("darker", Term("brdf_lambert", {"rho": 0.4}), "printed")))


SLICES = [LOBES, Slice("In the plane", LOBES.models), Slice("Against the angle", LOBES.models, kind="angle"),
          ImageSlice("In its own angles", LOBES.models)]


@pytest.mark.parametrize("theme", THEMES.values(), ids=list(THEMES))
@pytest.mark.parametrize("plot", SLICES, ids=lambda plot: plot.title)
def test_plots_of_models_are_filled_and_nothing_is_cut(plots, plot, theme):
    for size in ((360, 360), (420, 600), (800, 600)):
        image = drawn(plots, plot, LIGHT_AND_EYE, size=size, theme=theme)
        assert image.shape == (size[1], size[0], 3)
        ground = near(image, rgb(theme.background), 0)
        assert 0.2 < ground.mean() < 0.98, "empty, or covered"
        for edge in (ground[:2], ground[-2:], ground[:, :2], ground[:, -2:]):
            assert edge.all(), "something is cut by the picture's edge"
        names = ("d",) if isinstance(plot, ImageSlice) else ("l", "v", "d", "printed")
        assert all(near(image, colour(name, theme)).sum() > 25 for name in names)


def test_lobes_follow_light_eye_and_arguments(plots):
    for plot in SLICES[:3]:
        first = drawn(plots, plot, LIGHT_AND_EYE)
        for name, value in (("theta_l", 0.9), ("theta_v", 0.8)):
            assert np.any(first != drawn(plots, plot, LIGHT_AND_EYE | {name: value}), -1).sum() > 200, name
        assert (first == drawn(plots, plot, LIGHT_AND_EYE)).all()


@pytest.mark.parametrize("exponent", [1.0, 100.0, 1e4, 1e7])
def test_a_lobe_is_found_however_narrow_it_is(exponent):
    """The peak is on the grid, half of the cells are where it is more than nothing, and its number is the readout's."""
    phong = Model("Phong", Term("brdf_phong", {"k_d": 0.0, "k_s": 1.0}))
    for theta_l, phi in ((0.0, 0.0), (0.7, math.pi), (1.2, 2.0), (1.5, math.pi)):
        values = {"theta_l": theta_l, "theta_v": 0.5, "phi": phi, "exponent": exponent}
        (one,) = lit((phong,), values, "v")
        d, f = one.lobe(64, 128)
        assert f.max() == pytest.approx((exponent + 2) / (2 * math.pi), rel=2e-3)
        assert (f > 0.01 * f.max()).mean() > 0.1
        assert one.number == float(evaluate(phong.term, values)), "the readout of the same twin"
        assert np.abs(np.linalg.norm(d, axis=-1) - 1).max() < 1e-5


def test_a_scale_keeps_still_and_shows_lobes_of_all_sizes():
    scale = Scale()
    scale.fit([np.array([3.7]), np.array([0.3])], 0)
    assert scale.top == 4.0
    scale.fit([np.array([2.0])], 0)
    assert scale.top == 4.0, "still wide enough"
    scale.fit([np.array([0.9])], 0)
    assert scale.top == 1.0
    scale.fit([np.array([1e6]), np.array([0.3]), np.array([np.nan, np.inf])], 2)
    assert (scale.top, scale.decades) == (1e6, 8)
    assert scale.length([1e6, 1e2, 0.3, -1.0, 0.0]) == pytest.approx([1, 0.5, 1 + math.log10(3e-7) / 8, 0, 0])


def test_a_pair_outside_the_plane_of_a_slice_is_told(plots):
    inside, beside = (drawn(plots, SLICES[1], LIGHT_AND_EYE | {"phi": phi}) for phi in (math.pi, 2.0))
    words = [near(image[-90:], rgb(DARK.quiet), 40).sum() for image in (inside, beside)]
    assert words[1] > 1.5 * words[0], "a longer line below the plot"
    assert not near(beside, rgb("#FF4FD8"), 2).any(), "and no fault's box over it"


def test_long_names_of_models_are_written_smaller(plots):
    long = Lobes("Long", (replace(MATT, label="a matt surface with a long name"),))
    image = drawn(plots, long, LIGHT_AND_EYE, size=(345, 345), theme=PROJECTOR)
    assert near(image, rgb(PROJECTOR.background), 0)[:, -3:].all()
    row = near(image[-40:], rgb(PROJECTOR.foreground), 40).any(0)
    assert np.flatnonzero(row).max() > 250, "the number at the end is there"
