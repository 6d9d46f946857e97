"""The board as a step: its name, its scene, its numbers and plots, whatever the models are."""

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from app import camera as orbit
from app import optics, shader
from app.badges import of_model
from app.board import factors
from app.board.board_step import MOST, id_of, name_of, words_of
from app.board.course_model import PREFIX, names
from app.board.merl import coordinates, directions
from app.board.models import opened
from app.board.terms import LUMINANCE, function, packed
from app.board.terms import badges as judged
from app.brush import angles_of, tangent_azimuth
from app.catalog import step
from app.export.still import data
from app.gpu.evaluate import evaluate
from app.gpu.pick import pick
from app.gpu.stage import Stage
from app.gpu.stage_text import Source, programs
from app.hemisphere import NORMAL, frame
from app.lesson import Camera
from app.optics.spherical import direction, light_direction, view_direction
from app.problem import Problem, Usage
from app.readouts import numbers
from app.state import defaults, parse, write
from app.terms import evaluate as term_value
from app.theme import THEMES
from tests.test_board_report import TINTED

DARK = THEMES["dark"]


def write_file(folder, name: str, text: str = TINTED) -> str:
    path = folder / name
    path.write_text(text)
    return str(path)


def values_of(found, **given) -> dict:
    values = defaults(found) | given
    return values | data(found, values)


# --- its name --------------------------------------------------------------------------------------------------------
def test_words_survive_their_way_through_a_name():
    words = [("cook_torrance", True), ("/a b/ü+?&-.brdf", False), (r"C:\x\y.brdf", True), ("-odd.brdf", True)]
    assert words_of(name_of(words)) == words


def test_a_board_is_a_step_and_a_state_like_any_other(tmp_path):
    path = write_file(tmp_path, "a file+one.brdf")
    found = step(id_of(["cook_torrance", path]))
    assert step(found.id) is found, "made once, as long as the file is the same"
    state = parse(f"{found.id}?theta_l=60&model0_m=0.2&model1_tint=0.1,0.2,0.3&model1_twice=yes&model=a-file-one")
    assert state.values["model1_tint"] == (0.1, 0.2, 0.3) and state.values["model1_twice"] == 1
    assert state.values["model"] == 1 and state.values["theta_l"] == pytest.approx(math.radians(60))
    assert parse(write(found, state.values, state.view)) == state
    with pytest.raises(Usage, match="model0_n"):
        parse(f"{found.id}?model0_n=1")
    write_file(tmp_path, "a file+one.brdf", TINTED.replace("float n 0 4 1", "float n 0 4 3"))
    assert step(found.id).values["model1_n"].default == 3, "a file that has changed is read again"


def test_the_first_ones_are_on_and_a_broken_one_is_told():
    found = step(id_of(["lambert", "phong", "ggx", "eon", "blinn_phong", "lambret"]))
    assert [one.on for one in found.entries] == [True] * MOST + [False] * 2, "and no more"
    assert "lambret" in found.entries[-1].fault and len(found.step.models) == MOST
    with pytest.raises(Usage, match="no model lambret"):
        step("board/lambret")


def test_a_file_that_cannot_be_drawn_takes_no_place(tmp_path):
    broken = [write_file(tmp_path, f"x{i}.brdf", "analytic") for i in range(MOST)]
    found = step(id_of([*broken, "lambert", "ggx"]))
    assert [one.on for one in found.entries] == [False] * MOST + [True] * 2
    assert all(one.fault for one in found.entries[:MOST])


def test_what_was_set_stays_when_a_model_comes_or_goes():
    before, after = step("board/lambert+ggx"), step("board/phong+ggx+-lambert")
    values = defaults(before) | {"model0_rho": 0.1, "model1_alpha": 0.2, "theta_l": 1.0}
    kept = after.carried(before, values)
    assert kept["model1_alpha"] == 0.2 and kept["theta_l"] == 1.0
    assert "model0_k_d" not in kept and "model2_rho" not in kept
    again = step("board/ggx+lambert").carried(before, values)
    assert again["model0_alpha"] == 0.2 and again["model1_rho"] == 0.1


# --- its scene -------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("name", names())
def test_every_model_of_the_course_is_the_same_in_the_scene_as_its_twin(name):
    found = step(f"board/{name}")
    values, model = values_of(found), found.shown[0].model
    rng = np.random.default_rng(3)
    l, v = (direction(np.arccos(rng.uniform(0.2, 1, 40)), rng.uniform(-3, 3, 40)) for _ in "lv")
    x, y = frame(np.broadcast_to(NORMAL, l.shape))
    text = found.step.scene.glsl.partition('#include "display/board.glsl"')[0]
    text += "\nvec3 of_first(vec3 n, vec3 l, vec3 v, vec3 x, vec3 y) { return reflected(0, n, l, v, x, y); }"
    uniforms = {key: value for key, value in values.items() if isinstance(value, int | float | tuple)}
    got = evaluate("of_first", {"n": NORMAL, "l": l, "v": v, "x": x, "y": y}, text, uniforms=uniforms)
    want = model.rgb(NORMAL, l, v)
    np.testing.assert_allclose(got, want, rtol=2e-3, atol=1e-5)


@pytest.mark.parametrize("name", sorted(factors.OF))
def test_the_factors_make_the_model(name):
    found = step(f"board/{name}")
    for angles in ({}, {"theta_l": 0.2, "theta_v": 1.2, "phi": 2.5}, {"theta_l": 1.3, "theta_v": 1.1, "phi": 3.0}):
        values = values_of(found, **angles)
        d, g, f, low, whole = (number.value for number in numbers(found.step, values))
        assert whole == pytest.approx(d * g * f / low, rel=1e-9)
        same = optics.twin(PREFIX + name)(NORMAL, light_direction(values["theta_l"], values["phi"]),
                                          view_direction(values["theta_v"]), *values["model0__values"])
        assert whole == pytest.approx(float(same), rel=1e-9)


def test_a_file_has_f_only(tmp_path):
    found = step(id_of([write_file(tmp_path, "flat.brdf")]))
    assert [r.label for r in found.step.readouts] == ["f"] and not found.shown[0].factors
    values = values_of(found, model0_tint=(0.2, 0.4, 0.6), model0_twice=1)
    assert numbers(found.step, values)[0].value == pytest.approx(
        2 * (0.2126 * 0.2 + 0.7152 * 0.4 + 0.0722 * 0.6) / math.pi, rel=1e-5)


@pytest.mark.parametrize("web", [False, True])
def test_any_company_compiles(tmp_path, web):
    """Two files of the same text and a model of the course: their names do not meet."""
    same = [write_file(tmp_path, name) for name in ("one.brdf", "two.brdf")]
    found = step(id_of([*same, "cook_torrance"]))
    texts = programs(found.step.scene, header=shader.WEB if web else shader.DESKTOP)
    assert "mesh" in texts and "surface" in texts and "probe" in texts


def drawn(ctx, found, values: dict, size=(240, 220)) -> tuple[np.ndarray, object]:
    stage = Stage(ctx, Source(found.step.scene, found.file_name, found.glsl_line), values.get("triangles"))
    try:
        stage.draw(values, found.step.scene.camera, size, DARK)
        return stage.picture.pixels().astype(int), stage.picture.faults()
    finally:
        stage.release()


def test_a_sphere_is_lit_as_the_formula_says(ctx, tmp_path):
    """The large ball's middle: E n.l f, the eye straight above it."""
    found = step(id_of([write_file(tmp_path, "grey.brdf", TINTED.replace("1 .5 .25", ".5 .5 .5"))]))
    values = values_of(found, theta_v=0.0, theta_l=1.0, light=1.0, lobe_top=1e6, turned=0.0)
    stage = Stage(ctx, Source(found.step.scene, "the board"), values["triangles"])
    try:
        stage.draw(values, found.step.scene.camera, (400, 400), DARK)
        x, y, _ = orbit.project(stage.probes(values)[1, :3], stage.matrix)
        hit = pick(stage, values, found.step.scene.camera, DARK, (x, y))
    finally:
        stage.release()
    assert hit.surface == "ball: grey"
    assert hit.radiance[0] == pytest.approx(0.5 / math.pi * math.cos(1.0) + 0.02, rel=1e-3)


def test_every_view_and_every_choice_is_another_picture_without_faults(ctx):
    found = step("board/paint+cook_torrance")
    values = values_of(found)
    stage = Stage(ctx, Source(found.step.scene, found.file_name, found.glsl_line), values["triangles"])

    def picture(**given) -> np.ndarray:
        stage.draw(values | given, found.step.scene.camera, (150, 140), DARK)
        assert not stage.picture.faults(), given
        return stage.picture.pixels().astype(int)

    try:
        views = [picture(shows=view, model=1) for view in range(14)]
        for one, other in pairwise(views):
            assert np.abs(one - other).max() > 20
        first = picture()
        for given in ({"stands": 1}, {"model": 1}, {"lobe_scale": 2}, {"lobe_scale": 1}, {"board_channel": 0},
                      {"lobe_top": 0.01}, {"theta_l": 1.56, "theta_v": 1.56}):
            assert np.abs(picture(**given) - first).max() > 20, given
    finally:
        stage.release()


@pytest.mark.parametrize("stands", [0, 1])
def test_what_is_not_seen_is_not_drawn(ctx, stands):
    """The picture is that of a scene that draws all of it."""
    found = step("board/lambert+cook_torrance")
    values = values_of(found, stands=stands)
    whole = replace(found.step.scene, surfaces=tuple(replace(s, where=None) for s in found.step.scene.surfaces))
    pictures = []
    for scene in (found.step.scene, whole):
        stage = Stage(ctx, Source(scene, "the board"), values["triangles"], values)
        stage.draw(values, scene.camera, (240, 220), DARK)
        pictures.append(stage.picture.pixels())
        drawn_ones = {int(name.split()[1]) for _, name in stage.arrays if name.startswith("surface")}
        hidden = {i for i, s in enumerate(scene.surfaces) if s.where and s.where[1] != stands}
        assert drawn_ones == set(range(len(scene.surfaces))) - hidden and bool(hidden) == (scene is not whole)
        stage.release()
    assert np.array_equal(*pictures)


def test_what_is_no_number_is_seen(ctx, tmp_path):
    text = TINTED.replace("return (twice", "return sqrt(dot(L, V) - 0.9) * (twice")
    _, faults = drawn(ctx, found := step(id_of([write_file(tmp_path, "nan.brdf", text)])), values_of(found))
    assert faults.nan > 100


# --- its terms -------------------------------------------------------------------------------------------------------
def test_the_halfway_angles_are_those_of_the_directions():
    found = step("board/ggx")
    for theta_l, theta_v, phi in ((0.7, 0.3, 2.0), (1.2, 1.3, -3.0), (0.4, 0.4, 0.0), (0.5, 0.5, math.pi)):
        values = values_of(found, theta_l=theta_l, theta_v=theta_v, phi=phi)
        l, v = light_direction(theta_l, phi), view_direction(theta_v)
        theta_h, theta_d, _ = coordinates(NORMAL, l, v)
        assert values["theta_h"] == pytest.approx(float(theta_h), abs=1e-9)
        assert values["theta_d"] == pytest.approx(float(theta_d), abs=1e-9)
        back_l, back_v = directions(values["theta_h"], values["theta_d"], values["phi_d"])
        assert back_l @ back_v == pytest.approx(l @ v) and back_l[2] == pytest.approx(l[2])
        assert back_v[2] == pytest.approx(v[2])
        entry = found.shown[0]
        f = float(term_value(entry.term(), values))
        assert term_value(entry.term("half"), values) == pytest.approx(f, rel=1e-6)


def test_below_the_horizon_a_half_is_nothing():
    half = function("half:lambert")
    assert half(1.5, 1.0, 0.0, LUMINANCE, (0.5,)) == 0 and half(0.1, 0.2, 1.0, LUMINANCE, (0.5,)) > 0


def test_the_badges_of_a_step_are_the_models_own(tmp_path):
    """The worst channel, by the tolerance of float32: at the parameters that are set."""
    found = step(id_of([write_file(tmp_path, "tinted.brdf")]))
    values = values_of(found, model0_n=2.0)
    badges = of_model(found.step.models[0], values)
    model = opened(found.shown[0].word)
    assert badges == model.badges({"n": 2.0, "tint": (1.0, 0.5, 0.25), "twice": False})
    assert not badges["energy"].ok and badges["energy"].worst == pytest.approx(2, rel=1e-3) and badges["reciprocal"].ok
    assert judged(f"board:{found.shown[0].word}", packed(model.parameters, {}))["energy"].ok


def test_the_picture_is_seen_from_far_away():
    assert step("board/ggx").step.scene.camera == Camera(azimuth=-62, elevation=24, distance=40, field_of_view=5.3)


def test_without_a_model_there_is_no_board(tmp_path):
    path = write_file(tmp_path, "bad.brdf", "analytic\n")
    with pytest.raises(Problem, match=r"bad\.brdf has no ::begin shader"):
        step(id_of([path]))
    with pytest.raises(Usage, match="without a model"):
        step("board/")
    with pytest.raises(Usage, match="off"):
        step("board/-lambert")


# --- a model that asks how the surface is turned ---------------------------------------------------------------------
BRUSHED = """analytic
::begin shader
vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {
    vec3 h = normalize(L + V);
    float across = dot(h, X) / 0.1, along = dot(h, Y) / 0.6;
    return vec3(1., .5, .25) * (0.02 + exp(-across * across - along * along) + 0.3 * dot(cross(X, Y), N) * dot(V, X));
}
::end shader
"""


@pytest.mark.parametrize("angles", [{}, {"theta_v": 1.1, "turned": 2.0}, {"theta_v": 0.4, "turned": -2.6, "phi": 1.0},
                                    {"theta_v": 0.0, "turned": 0.3, "phi": 2.0}])
def test_x_is_the_same_on_balls_lobes_curves_and_numbers(ctx, tmp_path, angles):
    """One pixel of the ball, the lobe that stands there, and all that is evaluated for it."""
    found = step(id_of([write_file(tmp_path, "brushed.brdf", BRUSHED)]))
    values = values_of(found, light=1.0, lobe_top=1e6, board_channel=0, theta_l=0.5, **angles)
    f = numbers(found.step, values)[0].value
    stage, camera = Stage(ctx, Source(found.step.scene, "the board"), values["triangles"]), found.step.scene.camera
    try:
        stage.draw(values, camera, (600, 600), DARK)
        x, y, _ = orbit.project(stage.probes(values)[1, :3], stage.matrix)
        hit = pick(stage, values, camera, DARK, (x, y))
    finally:
        stage.release()
    assert hit.surface == "ball: brushed"
    assert hit.radiance[0] == pytest.approx(f * math.cos(0.5) + 0.02, rel=2e-3)
    there = angles_of(np.array(hit.normal), camera, values)  # to the last digit: the normal of that pixel is picked
    assert there["turned"] == pytest.approx(values["turned"], abs=0.1) or values["theta_v"] < 0.1
    values = values_of(found, **(values | there))
    assert hit.radiance[0] == pytest.approx(
        numbers(found.step, values)[0].value * math.cos(there["theta_l"]) + 0.02, rel=1e-4)
    f, one = numbers(found.step, values)[0].value, found.shown[0]
    text = found.step.scene.glsl + "\nfloat of_lobe(vec3 d) { return lobe_value(0, d); }"
    uniforms = {key: value for key, value in values.items() if isinstance(value, int | float)}
    source = {t.name: shader.Source(t.text, t.file, t.first) for t in found.step.scene.texts}
    eye = view_direction(values["theta_v"])
    lobe = evaluate("of_lobe", {"d": eye}, text, overrides=source, uniforms=uniforms)
    assert float(lobe) == pytest.approx(f, rel=1e-4)
    assert float(term_value(one.term("half"), values)) == pytest.approx(f, rel=1e-4)


def test_the_same_file_turned_is_another_albedo(tmp_path):
    """Albedo and badges: X across the eye's plane is not X along it; the ball of a report has the board's X."""
    path = write_file(tmp_path, "brushed.brdf", BRUSHED)
    found = step(id_of([path]))
    shares = [float(term_value(found.shown[0].term("albedo"), values_of(found, theta_v=1.0, turned=turned)))
              for turned in (-math.pi / 2, 0.0)]
    assert abs(shares[0] / shares[1] - 1) > 0.2
    model = opened(path)
    assert model.is_anisotropic and not opened(write_file(tmp_path, "plain.brdf")).is_anisotropic
    values = values_of(found)
    for badge in judged(f"board:{path}", values["model0__values"]).values():
        at = values | badge.at
        assert not badge.at or math.isclose(tangent_azimuth(at["theta_v"], at["turned"]), 0.0, abs_tol=1e-9)
