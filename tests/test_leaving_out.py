"""What a scene leaves out: proven by its texts, measured beside a shader that has everything on."""

import json
import re
from dataclasses import replace

import numpy as np
import pytest

from app import __main__ as cli
from app import inspect_all, shader
from app.catalog import step, steps
from app.cost import Cost, cost, held
from app.everything import FEATURES, EverythingOn, features
from app.gpu.stage import Stage
from app.gpu.stage_text import Source, programs
from app.inspection import inspect, unread
from app.leaving import decisions, lean
from app.leaving import faults as leaving_faults
from app.lesson import LeaveOut
from app.optics.cook_torrance import cook_torrance_dg
from app.optics.leave_out import cook_torrance_open, cook_torrance_open_error
from app.session import Session
from app.state import defaults
from app.theme import THEMES
from tests import small_lesson

CONE = step("solid_angle/cone")


def test_the_yardstick_colours_the_same_pixels(ctx):
    """Its vertices are the scene's, so what is drawn on is the same; what is there is another colour."""
    found, pictures, covered = step("lights/positional"), [], []
    for kind in (Stage, EverythingOn):
        stage = kind(ctx, Source(found.step.scene))
        stage.draw(defaults(found), found.step.scene.camera, (96, 96), THEMES["dark"], fine=False)
        assert not stage.picture.faults()
        pictures.append(stage.picture.pixels().astype(int))
        drawn = stage.picture.target(("picture", "faults"), False).read(components=4, attachment=1)
        covered.append(np.frombuffer(drawn, "u1").reshape(96, 96, 4)[..., 3] > 0)  # opaque surfaces write there
        stage.release()
    assert np.array_equal(*covered) and 0.2 < covered[0].mean() < 1
    assert np.abs(pictures[0] - pictures[1]).max() > 40


def test_every_feature_of_the_yardstick_is_in_it(ctx):
    """A feature counts as left out only if the yardstick itself has it: something of its files is compiled there."""
    stage = EverythingOn(ctx, Source(CONE.step.scene))
    files = set(stage.own.texts.programs(("surface",))["surface"][1].files)
    stage.release()
    for name, of in FEATURES.items():
        assert any(f"glsl/optics/{file}.glsl" in files for file in of), name


def test_a_scene_has_the_features_it_compiles():
    assert features(CONE.step.scene) == ()
    assert features(step("lights/spot").step.scene) == ("a light at a point", "a cone of light")
    scene = CONE.step.scene
    unused = replace(scene, glsl='#include "optics/spot.glsl"\n' + scene.glsl)
    assert features(unused) == (), "an included file of which nothing is used is no feature"


def test_cost_counts_what_is_there(ctx):
    found = step("solid_angle/mesh")
    row = inspect_all.row(found)
    assert row.cost["vertices"] == sum(row.found.vertices.values()) > 1000 and row.cost["texels"] > 0
    assert row.cost["compile_ms"] > 0 and row.cost["frame_ms"] > 0
    assert row.left_out == tuple(FEATURES), "the mesh of chapter 1 has no light"
    small = Cost(1, 0, 0, 0, 1.0, 3.0, 1.0, 6.0)
    assert small.ratio == 0.5


def test_memory_is_what_is_held(ctx):
    stage = Stage(ctx, Source(CONE.step.scene))
    empty, texels = held(stage)
    stage.draw(defaults(CONE), CONE.step.scene.camera, (256, 256), THEMES["dark"], fine=False, counted=False)
    assert texels == 0 and held(stage)[0] - empty == 256 * 256 * 8 // 1024  # colour and depth
    stage.release()


def test_cost_leaves_the_context_as_it_was(ctx):
    before = ctx.extra
    cost(CONE, defaults(CONE), rounds=1)
    assert ctx.extra is before


def test_a_varying_or_an_attribute_nobody_reads_is_a_fault():
    vertex, fragment = programs(CONE.step.scene)["surface"]
    assert unread("surface", vertex, fragment) == ()
    more = "in vec3 stage_position;\nin vec3 stage_idle;"
    idle = replace(vertex, text=vertex.text.replace("in vec3 stage_position;", more)
                   .replace("out vec4 v_value;", "out vec4 v_value;\nout vec2 v_idle;"))
    assert unread("surface", idle, fragment) == ("the attribute stage_idle of the pass surface is not read.",
                                                 "the varying v_idle of the pass surface is not read.")


def test_all_is_told_and_a_fault_fails(tmp_path, monkeypatch, capsys):
    found = steps(small_lesson.write(tmp_path))
    monkeypatch.setattr(inspect_all, "steps", lambda: found)
    assert cli.main(["inspect", "--all"]) == 0
    out = capsys.readouterr().out
    assert "Nothing lies about" in out and f"{len(found)} of {len(found)} steps" in out
    assert cli.main(["inspect", "--all", "--json"]) == 0
    rows = json.loads(capsys.readouterr().out)
    assert [row["step"] for row in rows] == [one.id for one in found]
    assert all(row["cost"]["ratio"] > 0 and row["faults"] == [] for row in rows)
    (tmp_path / "broken").mkdir()
    broken = small_lesson.write(tmp_path / "broken", ("uniform float half_angle;",
                                                      "uniform float half_angle;\nuniform float tilt;"))
    idle = steps(broken)
    monkeypatch.setattr(inspect_all, "steps", lambda: idle)
    assert cli.main(["inspect", "--all"]) == 1
    assert "the uniform tilt is declared and not used" in capsys.readouterr().out


@pytest.mark.parametrize("words", [["inspect"], ["inspect", "solid_angle/cone", "--all"]])
def test_a_step_or_all(words, capsys):
    assert cli.main(words) == 2 and "wants a step, or --all" in capsys.readouterr().err


# --- what a scene decides --------------------------------------------------------------------------------------------
LAMPS = step("lights/area_exact")
FAR = {"panel_width": 0.27, "light_height": 3.0}


def picture(found, values, ctx):
    stage = Stage(ctx, Source(found.step.scene))
    stage.draw(values, found.step.scene.camera, (128, 96), THEMES["dark"], fine=False)
    assert not stage.picture.faults()
    pixels = stage.picture.pixels().astype(int)
    stage.release()
    return pixels


def test_a_lamp_is_a_point_where_that_is_exact_enough():
    samples, size = decisions(LAMPS, defaults(LAMPS))
    assert samples.is_out and samples.error == 0 and "exact to rounding" in samples.words
    assert not size.is_out and size.error > 0.4 and "needed" in size.words and "43 %" in size.words
    _, far = decisions(LAMPS, defaults(LAMPS) | FAR)
    assert far.is_out and 0.001 < far.error < far.of.limit and "0.57 %" in far.words


def test_a_person_decides_otherwise_and_is_told_what_it_costs():
    _, size = decisions(LAMPS, defaults(LAMPS), {"the lamps' size": True})
    assert size.is_out and size.by_hand and "above the 1.0 % it accepts" in size.words
    _, size = decisions(LAMPS, defaults(LAMPS) | FAR, {"the lamps' size": False})
    assert not size.is_out and "kept by hand" in size.words


def test_what_is_left_out_changes_the_picture_by_no_more_than_is_said(ctx):
    near, far = defaults(LAMPS), defaults(LAMPS) | FAR
    for values, is_out, low, high in ((far, True, 0, 2), (near, True, 40, 255), (near, False, 0, 0)):
        made = decisions(LAMPS, values, {"the lamps' size": is_out})
        off = np.abs(picture(lean(LAMPS, made), values, ctx) - picture(LAMPS, values, ctx))
        assert low <= off.max() <= high, (values, is_out)


def test_the_64_samples_are_there_when_they_are_wanted(ctx):
    values = defaults(LAMPS)
    made = decisions(LAMPS, values, {"64 samples of a lamp": False})
    kept = {name for pair in programs(lean(LAMPS, made).step.scene).values() for part in pair if part
            for name in part.kept}
    assert "irradiance_light_64" in kept and "irradiance_outline" not in kept
    off = np.abs(picture(lean(LAMPS, made), values, ctx) - picture(LAMPS, values, ctx)).max(-1)
    assert off.max() > 2 and np.mean(off) < 6, "noise, and little of it"


VASES = step("plausible_shading/compare")


def compiled(found) -> set[str]:
    return {name for pair in programs(found.step.scene).values() for part in pair if part for name in part.kept}


def decided(found, values, label):
    return next(one for one in decisions(found, values) if one.of.label == label)


@pytest.mark.parametrize(("material", "is_out"), [(6, True), (7, True), (8, False), (9, False)])
def test_wavelengths_are_summed_only_where_the_fit_is_off(material, is_out):
    values = defaults(VASES) | {"material": material}
    assert decided(VASES, values, "the twelve wavelengths of F").is_out == is_out
    kept = compiled(lean(VASES, decisions(VASES, values)))
    assert ("metal_index" in kept) != is_out and ("f_material_schlick" in kept) == is_out


OPEN = "G in the lamp's light"


def test_g_is_left_out_exactly_where_its_error_is_below_the_bound():
    """By bisection over the lamp's angle: G is out on one side of the edge, in on the other; rougher is sooner."""
    edges = []
    for m in (0.08, 0.15, 0.3):
        low, high = 0.0, np.radians(80.0)
        for _ in range(40):
            middle = 0.5 * (low + high)
            if decided(VASES, defaults(VASES) | {"m": m, "theta_d": middle}, OPEN).is_out:
                low = middle
            else:
                high = middle
        one = decided(VASES, defaults(VASES) | {"m": m, "theta_d": low}, OPEN)
        assert one.is_out and np.isclose(one.error, one.of.limit, rtol=1e-6) and one.error <= one.of.limit
        edges.append(low)
    assert np.all(np.diff(edges) < 0) and np.radians(60) < edges[0] and edges[-1] < np.radians(25)


def test_the_error_of_no_g_is_the_largest_of_many_normals():
    """Against normals of the whole hemisphere, where the twin looks along one plane only; and the eye 4 degrees off."""
    rng, m = np.random.default_rng(3), 0.2
    normals = rng.normal(size=(400_000, 3))
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    for theta_d in np.radians([30.0, 45.0, 62.0]):
        at = theta_d + 0.07
        v, l = np.array([np.sin(at), 0, np.cos(at)]), np.array([-np.sin(at), 0, np.cos(at)])
        n = normals[(normals @ v > 0.01) & (normals @ l > 0.01)]
        light, open_ = (f(n, l, v, m) * (n @ l) for f in (cook_torrance_dg, cook_torrance_open))
        found, said = np.max(open_ - light) / np.max(light), cook_torrance_open_error(theta_d, m)
        assert 0.5 * said < found < 1.01 * said


@pytest.mark.parametrize(("degrees", "low", "high"), [(20.0, 0, 1), (37.0, 0, 1), (75.0, 30, 255)])
def test_without_g_the_picture_is_off_by_no_more_than_is_said(degrees, low, high, ctx):
    values = defaults(VASES) | {"theta_d": np.radians(degrees)}
    pictures = [picture(lean(VASES, decisions(VASES, values, {OPEN: is_out})), values, ctx) for is_out in (True, False)]
    assert low <= np.abs(pictures[0] - pictures[1]).max() <= high
    assert decided(VASES, values, OPEN).is_out == (high == 1)


def test_without_g_there_is_less_to_do():
    """A pixel does without a dot product, a sum and a comparison; and the panel says what that costs."""
    values, work = defaults(VASES) | {"theta_d": 0.2}, []
    for is_out, name in ((True, "cook_torrance_open"), (False, "cook_torrance_dg")):
        assert name in compiled(lean(VASES, decisions(VASES, values, {OPEN: is_out})))
        text = shader.read(shader.catalogue()[name][0]).split(f"float {name}(")[1].split("\n}")[0]
        work.append(len(re.findall(r"dot\(|m(?:in|ax)\(| [-+*/] ", text)))
    assert work[0] < work[1]
    said = decided(VASES, values, OPEN).words
    assert "left out. All facets open, at most" in said and "of the highlight off" in said


TWICE = "second bounces"


@pytest.mark.parametrize(("material", "is_out"), [(0, True), (2, True), (4, True), (5, False), (7, False), (8, False)])
def test_second_bounces_are_left_out_of_what_is_no_metal(material, is_out):
    """Light is lost from water as from gold; of what is lost, an insulator mirrors little twice."""
    for m in (0.08, 0.2, 0.5):
        one = decided(VASES, defaults(VASES) | {"material": material, "m": m}, TWICE)
        assert one.is_out == is_out and (one.error < 0.006 if is_out else one.error > 0.015)


def test_second_bounces_go_exactly_where_their_error_is_below_the_bound():
    low, high = 0.1, 1.0  # of a rough diamond
    for _ in range(40):
        middle = 0.5 * (low + high)
        one = decided(VASES, defaults(VASES) | {"material": 4, "m": middle}, TWICE)
        low, high = (middle, high) if one.is_out else (low, middle)
    one = decided(VASES, defaults(VASES) | {"material": 4, "m": low}, TWICE)
    assert one.is_out and np.isclose(one.error, one.of.limit, rtol=1e-6) and 0.5 < low < 0.9


@pytest.mark.parametrize(("material", "low", "high"), [(2, 0, 2), (7, 20, 60)])
def test_without_second_bounces_the_picture_is_off_by_what_is_said(material, low, high, ctx):
    """0.13 % of the light of plastic is at most 2 of 255; 11 % of copper's is seen."""
    values = defaults(VASES) | {"material": material, "m": 0.5, "theta_d": np.radians(30.0)}
    scenes = [lean(VASES, decisions(VASES, values, {TWICE: is_out})) for is_out in (True, False)]
    once, twice = (picture(scene, values, ctx) for scene in scenes)
    assert np.all(twice >= once) and low <= np.max(twice - once) <= high


def test_without_second_bounces_there_is_less_to_compile():
    values = defaults(VASES) | {"material": 2}
    without, with_them = (compiled(lean(VASES, decisions(VASES, values, {TWICE: is_out}))) for is_out in (True, False))
    gone = {"facets_lost", "facets_lost_average", "bounced_share", "f_material_average", "azimuths_between"}
    assert gone <= with_them - without and len(without) < len(with_them)
    assert without - with_them == {"bounced_light_none"}


def test_the_same_decision_is_the_same_scene():
    one, other = (lean(LAMPS, decisions(LAMPS, defaults(LAMPS) | FAR | {"light_x": x})) for x in (0.0, 0.1))
    assert one is other and one is not LAMPS and lean(CONE, ()) is CONE


def test_a_wrong_leave_out_is_told():
    for one, sentence in ((LeaveOut("x", 0.0, 1e-3, "y", {"irradiance_light": "no_such"}), "no function no_such"),
                          (LeaveOut("x", 0.0, 1e-3, "y"), "changes no function"),
                          (LeaveOut("x", 0.0, -1.0, "y", {"irradiance_light": "irradiance_light_64"}), "below 0")):
        wrong = replace(LAMPS, step=replace(LAMPS.step, leave_outs=(one,)))
        assert any(sentence in fault for _, fault in leaving_faults(wrong)), sentence


def test_a_session_keeps_what_was_decided():
    session = Session("lights/area_exact")
    before = session.revision
    session.decide("the lamps' size", True)
    assert session.visit.decided == {"the lamps' size": True} and session.revision > before
    session.go("lights/spot")
    session.go("lights/area_exact")
    assert session.visit.decided == {"the lamps' size": True}
    session.decide("the lamps' size", None)
    assert session.visit.decided == {}


def test_inspect_without_opengl_is_pure_text():
    assert inspect(CONE).faults == ()
