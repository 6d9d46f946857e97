"""Only what depends on a changed value is done again: counted, for pictures, plots and numbers."""

import re
from functools import partial

import numpy as np
import pytest

from app import needs, readouts
from app.catalog import step, steps
from app.gpu.stage import Stage
from app.gpu.stage_text import Source, programs
from app.lesson import Scene, Surface, Term
from app.paths import ROOT
from app.readouts import numbers
from app.state import View, defaults
from app.theme import THEMES
from app.viewer.scene_panel import ScenePanel
from tests.window import drive, frames, until


def test_a_terms_values_are_its_arguments():
    assert needs.of_term(Term("solid_angle_cone")) >= {"half_angle"}
    assert needs.of_term(Term("solid_angle_cone", {"half_angle": 0.3})) == needs.of_term(Term("solid_angle_cone",
                                                                                              {"half_angle": 0.5}))
    assert "tilt" in needs.of_term(Term("solid_angle_cone", {"half_angle": "tilt"}))
    assert {"theta_l", "theta_v", "phi", "rho"} <= needs.of_term(Term("brdf_oren_nayar"))


@pytest.mark.parametrize("found", steps(), ids=lambda found: found.id)
def test_no_value_of_a_step_is_without_use(found):
    """A slider that neither the scene, nor a plot, nor a number, nor data reads would be a lie."""
    scene = found.step.scene
    used = needs.drawn(scene, programs(scene)) | {"shape"}
    used = used.union(*map(needs.plotted, found.step.plots), *map(needs.of_term, needs.terms(found.step.readouts)))
    assert set(found.values) <= used


def test_what_plots_read_beside_their_terms_is_known():
    """Names that app/plots looks up itself; another one belongs into needs.plotted first."""
    looked_up = {name for path in (ROOT / "app" / "plots").glob("*.py")
                 for name in re.findall(r"""values(?:\.get\(|\[)"(\w+)\"""", path.read_text("utf-8"))}
    known = {"lobe_scale", "model", "channel", "eye"}
    assert looked_up <= known, "a plot reads a value that nobody hands to it"
    lobes = next(plot for found in steps() for plot in found.step.plots if type(plot).__name__ == "Lobes")
    assert {"lobe_scale", "channel", "theta_l", "theta_v", "phi"} <= needs.plotted(lobes)


@pytest.mark.parametrize("name", ["solid_angle/patch", "lights/ies", "radiometry/inverse_square"])
def test_a_scene_looks_the_same_with_what_it_needs(name, ctx):
    from app.export.still import data

    found = step(name)
    values = {**defaults(found), **data(found, defaults(found))}
    stage = Stage(ctx, Source(found.step.scene), values.get("triangles"))
    pictures = []
    for given in (values, needs.only(values, needs.drawn(found.step.scene, stage.own.texts.programs(None)))):
        stage.draw(given, found.step.scene.camera, (120, 90), THEMES["dark"])
        pictures.append(stage.picture.pixels().copy())
    stage.release()
    assert np.array_equal(*pictures) and pictures[0].std() > 5


def test_another_choice_needs_other_values(ctx):
    """A picture is drawn again for a value that it reads at what is chosen now, and for no other."""
    glsl = ("uniform int kind;\nuniform float width;\nuniform float radius;\n"
            "vec3 surface_point(int surface, vec2 s) { return vec3((kind == 0 ? width : radius) * s, 0.0); }\n"
            "vec3 shade(Surface s) { return vec3(0.5); }")
    panel = ScenePanel(None)
    panel.stage = stage = Stage(ctx, Source(Scene(glsl, surfaces=(Surface("square"),), decided=("kind",))))

    def shown(**values: float) -> tuple:
        stage.decide(values)
        return panel.shown(values, (64, 48), View(0, 0, 4), THEMES["dark"])

    for kind, reads, other in ((0, "width", "radius"), (1, "radius", "width"), (0, "width", "radius")):
        now = {"kind": kind, "width": 1.0, "radius": 1.0}
        assert shown(**now | {other: 2.0}) == shown(**now) != shown(**now | {reads: 2.0})
    stage.release()


def test_only_the_numbers_that_change_are_computed_again(monkeypatch):
    found, known, counted = step("solid_angle/patch"), {}, []
    real = readouts.measured
    monkeypatch.setattr(readouts, "measured", lambda readout, *rest: counted.append(readout.label) or
                        real(readout, *rest))
    values = defaults(found)
    first = numbers(found.step, values, None, known)
    assert len(counted) == len(found.step.readouts)
    counted.clear()
    assert numbers(found.step, values, None, known) == first and counted == []
    again = numbers(found.step, {**values, "samples": values["samples"] + 1}, None, known)
    assert counted == ["counted"] and again[0] == first[0]
    counted.clear()
    numbers(found.step, {**values, "tilt": 0.3}, None, known)
    assert len(counted) == len(found.step.readouts)


def settled(window) -> bool:
    return window.scene.is_fine and window.plot.texture is not None and not window.plot.waiting


def test_a_slider_of_the_scene_costs_no_plot_and_the_other_way_round():
    """Counted in the running window: chapter 1's points are the scene's alone, chapter 2's power the plot's alone."""
    def counts(window) -> tuple[int, int]:
        return window.scene.frames_drawn, window.plot.process.count

    def moved(engine, window, name: str, value: float) -> tuple[int, int]:
        until(engine, window, partial(settled, window))
        frames(engine, 6)
        until(engine, window, partial(settled, window))
        drawn, wished = counts(window)
        window.jobs.append(partial(window.set_value, name, value))
        frames(engine, 12)
        until(engine, window, partial(settled, window))
        return counts(window)[0] - drawn, counts(window)[1] - wished

    def test(engine, window):
        window.go("solid_angle/patch")
        pictures, plots = moved(engine, window, "samples", window.session.values["samples"] + 100)
        assert pictures >= 1 and plots == 0
        window.go("radiometry/radiant_intensity")
        pictures, plots = moved(engine, window, "radiant_flux", window.session.values["radiant_flux"] * 1.25)
        assert pictures == 0 and plots >= 1

    drive(test)
