"""Break it: the naive form takes the stable one's place, it shows, and everything can be put right."""

import math
from dataclasses import replace

import numpy as np
import pytest

from app import catalog, shader
from app.__main__ import main
from app.breaking import broken, faults, values_of
from app.export.still import data
from app.gpu.evaluate import evaluate
from app.gpu.stage import Stage
from app.gpu.stage_text import Source, programs
from app.lesson import Break, Curves, Term
from app.problem import Usage
from app.readouts import numbers
from app.session import Session
from app.state import defaults
from app.swapping import calling, without_body
from app.terms import evaluate as evaluated
from app.theme import THEMES

BROKEN = [(found, i) for found in catalog.steps() for i in range(len(found.step.breaks))]
every_break = pytest.mark.parametrize(("found", "which"), BROKEN, ids=lambda x: getattr(x, "id", str(x)))


def drawn(found, values, ctx):
    more = values | data(found, values)
    stage = Stage(ctx, Source(found.step.scene, found.file_name, found.glsl_line), more.get("triangles"))
    try:
        stage.draw(more, found.step.scene.camera, (192, 144), THEMES["dark"], fine=False)
        return stage.picture.pixels().astype(int), stage.picture.faults()
    finally:
        stage.release()


OFF = {  # how much of the number each break loses at least; NaN: all of it
    "solid_angle/patch": 2.0, "radiometry/inverse_square": 0.05, "lights/positional": math.inf, "lights/spot": 1.0,
    "lights/area_units": 0.1, "brdfs/phong": math.nan, "brdfs/blinn_phong_brdf": 2.7, "microfacets/beckmann_only": 250,
    "fresnel/inside": math.nan, "fresnel/materials": 0.99, "geometry_term/smith": 100,
    "plausible_shading/scale": 40,
}


@every_break
def test_a_break_shows_in_the_picture(found, which, ctx):
    """At the same values the sound step is another picture, and has no fault."""
    values = defaults(found) | values_of(found, found.step.breaks[which])
    (sound, none), (bad, some) = (drawn(one, values, ctx) for one in (found, broken(found, which)))
    assert not none
    changed = np.mean(np.abs(bad - sound).max(-1) > 24)
    assert changed > 0.02 or some, f"only {changed:.2%} of the picture changes"


@every_break
def test_a_break_tells_by_how_much(found, which, ctx):
    """Its number is off by no less than it is said to be; the stable form is right in float32 at the same values."""
    one = found.step.breaks[which]
    values = defaults(found) | values_of(found, one) | data(found, defaults(found))
    exact, bad = numbers(broken(found, which).step, values, ctx)
    stable = float(evaluated(one.term, values, "float32", ctx=ctx))
    assert math.isclose(stable, exact.value, rel_tol=1e-5, abs_tol=1e-6)
    least = OFF[found.id]
    if math.isnan(least):
        assert math.isnan(bad.value) and "not a number" in bad.text
    elif exact.value == 0:
        assert abs(bad.value) > 1 and "off by" in bad.error_text
    else:
        assert abs(bad.error) >= least


@every_break
def test_a_break_is_whole(found, which):
    one, made = found.step.breaks[which], broken(found, which)
    assert faults(found) == [] and len(one.label) <= 40 and 40 <= len(one.told.split()) <= 62
    compiled = {name for pair in programs(made.step.scene).values() for part in pair if part for name in part.kept}
    shown = {curve.term.function for plot in found.step.plots if isinstance(plot, Curves) for curve in plot.curves}
    assert set(one.functions.values()) & compiled, "the scene draws what is broken"
    for stable, naive in one.functions.items():
        assert naive in compiled or stable in shown | {one.term.function}, f"nothing here uses {stable}"
    already = {name for pair in programs(found.step.scene).values() for part in pair if part for name in part.kept}
    assert not set(one.functions.values()) & already, "the sound step shows it already"
    for name, value in values_of(found, one).items():
        spec = made.values[name]
        assert spec.low * (1 - 1e-6) <= value <= spec.high * (1 + 1e-6), f"the slider of {name} reaches {value}"
    assert list(made.values) == list(found.values) and dict(found.values) == catalog.step(found.id).values


def test_every_chapter_can_be_broken():
    assert {found.loaded.number for found, _ in BROKEN} == set(range(1, 9))
    assert set(OFF) == {found.id for found, _ in BROKEN} and len(BROKEN) >= 10


def test_a_swapped_function_calls_the_other_everywhere(ctx):
    include, signature = shader.catalogue()["solid_angle_cone"]
    text = without_body(shader.read(include), signature)
    assert len(text.split("\n")) == len(shader.read(include).split("\n")), "lines keep their numbers"
    own = {include: shader.Source(text, include)}
    caller = f'#include "{include}"\nfloat caller(float half_angle) {{ return solid_angle_cone(half_angle); }}\n'
    args = {"half_angle": np.array([1e-4])}
    assert evaluate("caller", args, text=caller, ctx=ctx) > 0
    behind = caller + calling(signature, "solid_angle_cone_naive")
    assert evaluate("caller", args, text=behind, ctx=ctx, overrides=own) == 0


def test_a_wrong_break_is_told():
    found, told = catalog.step("solid_angle/cone"), ("", "", Term("solid_angle_cone"))
    for one, sentence in ((Break("x", {"solid_angle_cone": "no_such"}, {}, *told), "there is no function no_such"),
                          (Break("x", {"solid_angle_cone": "d_beckmann_naive"}, {}, *told), "not take the arguments"),
                          (Break("x", {}, {"half_angle": 400.0}, *told), "half_angle"),
                          (Break("x", {}, {"nothing": 1.0}, *told), "no value 'nothing'"),
                          (Break("x", {}, {}, *told), "solid_angle_cone, its number, is not broken")):
        assert sentence in faults(replace(found, step=replace(found.step, breaks=(one,))))[0][1]


def test_a_session_breaks_and_mends():
    session = Session("solid_angle/patch?theta=20")
    before, revision = dict(session.values), session.revision
    session.break_it()
    assert session.broken is session.steps[session.place].step.breaks[0]
    assert math.isclose(session.values["theta"], math.radians(6)) and session.revision > revision
    assert session.current.step.scene.texts
    session.break_it()
    assert session.broken is None and session.values == before and not session.current.step.scene.texts
    session.break_it()
    session.next()
    assert session.broken is None
    session.previous()
    assert session.values == before, "one comes back to a sound step, at its values"
    session.break_it()
    session.reset()
    assert session.broken is None and session.values["theta"] == session.current.values["theta"].default
    with pytest.raises(Usage, match="nothing to break"):
        Session("solid_angle/cone").break_it()
    session.freeze()
    with pytest.raises(Usage):
        session.break_it()
    assert session.broken is None


@every_break
def test_what_a_break_puts_aside_cannot_be_edited(found, which):
    """An exercise on it, or a text of one's own, stays open beside the broken scene."""
    session = Session(found.id)
    functions = set(found.step.breaks[which].functions)
    for name in functions & set(session.functions):
        session.type(name, session.text(name) + "\n// mine")
    session.run(session.texts)
    session.break_it(which)
    assert not functions & set(session.functions)
    assert all(known.signature.name == name for name, known in session.functions.items())
    assert isinstance(session.edited, dict), "and what runs of it is nothing that values carry"


def test_a_still_of_a_broken_step(tmp_path, capsys):
    sound, bad = tmp_path / "a.png", tmp_path / "b.png"
    words = ["render", "fresnel/inside", "--size", "320x240", "-o"]
    assert main([*words, str(sound)]) == 0 and main([*words, str(bad), "--broken"]) == 0
    assert sound.read_bytes() != bad.read_bytes()
    assert main([*words, str(bad), "--broken", "7"]) == 2
    assert "Snell" in capsys.readouterr().err
