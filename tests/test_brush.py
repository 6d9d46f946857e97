"""Picking a point: the angles that make a normal the picked one, and what a scene draws there."""

import math

import numpy as np
import pytest

from app import camera as orbit
from app.brush import angles_of, facing, picked_frame
from app.catalog import step
from app.gpu.context import context
from app.gpu.evaluate import evaluate
from app.gpu.pick import pick
from app.gpu.stage import Stage
from app.gpu.stage_text import Source
from app.lesson import Camera
from app.meshes import built_in
from app.optics.spherical import light_direction
from app.state import defaults
from app.theme import THEMES

CAMERA = Camera(azimuth=-62, elevation=24, distance=40)
VALUES = {"theta_l": 0.7, "theta_v": 0.5, "phi": -2.0, "turned": 0.3}
GLSL = """
#include "display/brush.glsl"
vec3 normal_of(float theta_v, float turned) { return picked_frame(theta_v, turned)[2]; }
vec3 light_of(float theta_l, float theta_v, float phi, float turned) {
    return picked_light(theta_l, theta_v, phi, turned);
}
"""


def test_the_two_languages_mean_the_same_angles():
    rng = np.random.default_rng(1)
    for theta_l, theta_v, phi, turned in rng.uniform((0, 0, -3, -3), (1.5, 1.5, 3, 3), (6, 4)):
        frame, uniforms = picked_frame(CAMERA, theta_v, turned), {"camera_position": tuple(orbit.position(CAMERA))}
        assert np.allclose(frame.T @ frame, np.eye(3)) and np.linalg.det(frame) == pytest.approx(1)
        given = {"theta_v": theta_v, "turned": turned}
        assert np.allclose(evaluate("normal_of", given, GLSL, uniforms=uniforms), frame[:, 2], atol=1e-6)
        found = evaluate("light_of", given | {"theta_l": theta_l, "phi": phi}, GLSL, uniforms=uniforms)
        assert np.allclose(found, frame @ light_direction(theta_l, phi), atol=1e-6)


def test_light_and_eye_stay_where_they_are():
    light = light_direction(VALUES["theta_l"], VALUES["phi"])
    light = picked_frame(CAMERA, VALUES["theta_v"], VALUES["turned"]) @ light
    eye = facing(CAMERA)[0]
    rng = np.random.default_rng(2)
    seen = 0
    for way in rng.normal(size=(40, 3)):
        n = way / np.linalg.norm(way)
        at = angles_of(n, CAMERA, VALUES)
        assert (at is None) == (n @ light <= 0 or n @ eye <= 0)
        if at is None:
            continue
        seen += 1
        frame = picked_frame(CAMERA, at["theta_v"], at["turned"])
        assert np.allclose(frame[:, 2], n)
        assert np.allclose(frame @ light_direction(at["theta_l"], at["phi"]), light)
        assert math.cos(at["theta_v"]) == pytest.approx(n @ eye) and math.cos(at["theta_l"]) == pytest.approx(n @ light)
    assert seen > 5


def test_the_normal_towards_the_eye_keeps_its_turn():
    at = angles_of(facing(CAMERA)[0], CAMERA, VALUES)
    assert at["theta_v"] == pytest.approx(0, abs=1e-7) and at["turned"] == VALUES["turned"]


def test_a_click_on_the_object_picks_the_normal_it_is_lit_by():
    """Also a face of the knot is shaded by its smooth normal, and the ball by the true sphere's."""
    found = step("plausible_shading/board")
    values, camera = defaults(found), found.step.scene.camera
    stage = Stage(context(), Source(found.step.scene, found.file_name, found.glsl_line), built_in("knot").triangles)
    try:
        stage.draw(values, camera, (320, 240), THEMES["dark"])
        eye, up, aside = facing(camera)
        picked = picked_frame(camera, values["theta_v"], values["turned"])[:, 2]
        middle = -0.86 * aside - 0.58 * up
        on_ball = pick(stage, values, camera, THEMES["dark"], orbit.project(middle + 0.92 * picked, stage.matrix)[:2])
        assert on_ball.surface == "ball" and np.allclose(on_ball.normal, picked, atol=5e-3)
        at = [(x, y) for x in np.linspace(0.5, 1, 24) for y in np.linspace(0, 0.6, 24)]
        hits = [hit for one in at if (hit := pick(stage, values, camera, THEMES["dark"], one))]
        assert any(hit.surface == "object" for hit in hits)
        for hit in hits:
            assert np.linalg.norm(hit.normal) == pytest.approx(1, abs=1e-3)
            assert np.array(hit.normal) @ eye > -0.2
    finally:
        stage.release()
