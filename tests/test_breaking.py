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
from app.lesson import Break
from app.problem import Usage
from app.readouts import numbers
from app.session import Session
from app.state import defaults
from app.swapping import calling, without_body
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


@every_break
def test_a_break_shows_in_the_picture(found, which, ctx):
    """At the same values the sound step is another picture, and has no fault."""
    values = defaults(found) | values_of(found, found.step.breaks[which])
    (sound, none), (bad, some) = (drawn(one, values, ctx) for one in (found, broken(found, which)))
    assert not none
    changed = np.mean(np.abs(bad - sound).max(-1) > 24)
    assert changed > 0.004 or some, f"only {changed:.2%} of the picture changes"


@every_break
def test_a_break_is_whole(found, which):
    one = found.step.breaks[which]
    assert faults(found) == [] and len(one.label) <= 40 and 12 <= len(one.told.split()) <= 60
    compiled = {name for pair in programs(broken(found, which).step.scene).values() for part in pair if part
                for name in part.kept}
    told = {readout.term.function for readout in found.step.readouts}
    assert set(one.functions.values()) & compiled, "the scene draws what is broken"
    for stable, naive in one.functions.items():
        assert naive in compiled or stable in told, f"nothing here uses {stable}"
    before, after = ([n.value for n in numbers(one_step.step, values)]
                     for one_step in (found, broken(found, which))
                     for values in [defaults(found) | values_of(found, one) | data(found, defaults(found))])
    for readout, was, now in zip(found.step.readouts, before, after, strict=True):
        if readout.role == "exact" or readout.term.function not in one.functions:
            assert was == now or math.isnan(was)
        else:
            assert was != now, "the number is the broken one's"


def test_some_steps_can_be_broken():
    assert len(BROKEN) >= 5 and {found.loaded.number for found, _ in BROKEN} >= {1, 3, 5, 6}


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
    found = catalog.step("solid_angle/cone")
    for one, sentence in ((Break("x", {"solid_angle_cone": "no_such"}, {}, ""), "there is no function no_such"),
                          (Break("x", {"solid_angle_cone": "d_beckmann_naive"}, {}, ""), "not take the arguments"),
                          (Break("x", {}, {"half_angle": 400.0}, ""), "half_angle"),
                          (Break("x", {}, {"nothing": 1.0}, ""), "no value 'nothing'")):
        assert sentence in faults(replace(found, step=replace(found.step, breaks=(one,))))[0][1]


def test_a_session_breaks_and_mends():
    session = Session("solid_angle/cone?half_angle=20")
    before, revision = dict(session.values), session.revision
    session.break_it()
    assert session.broken is session.steps[session.place].step.breaks[0]
    assert math.isclose(session.values["half_angle"], math.radians(0.01)) and session.revision > revision
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
    assert session.broken is None and session.values["half_angle"] == session.current.values["half_angle"].default
    with pytest.raises(Usage, match="nothing to break"):
        Session("solid_angle/patch").break_it()
    session.freeze()
    with pytest.raises(Usage):
        session.break_it()
    assert session.broken is None


def test_a_still_of_a_broken_step(tmp_path, capsys):
    sound, bad = tmp_path / "a.png", tmp_path / "b.png"
    words = ["render", "fresnel/inside", "--size", "320x240", "-o"]
    assert main([*words, str(sound)]) == 0 and main([*words, str(bad), "--broken"]) == 0
    assert sound.read_bytes() != bad.read_bytes()
    assert main([*words, str(bad), "--broken", "7"]) == 2
    assert "Snell" in capsys.readouterr().err
