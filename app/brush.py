"""Picking a point of a scene whose light and eye are far away: the angles that make a normal the picked one, while
light and eye stay where they are. What the angles mean is glsl/display/brush.glsl."""

import math

import numpy as np

from app import camera as orbit
from app.lesson import Camera
from app.optics.spherical import light_direction

ANGLES = "theta_l", "theta_v", "phi", "turned"


def facing(camera: Camera) -> np.ndarray:
    """Rows: to the eye, upwards and to the right, of someone who looks at the middle of the scene."""
    eye = orbit.position(camera)
    eye = eye / np.linalg.norm(eye)
    up = np.array([0.0, 0.0, 1.0]) - eye[2] * eye
    up = up / np.linalg.norm(up)
    return np.stack([eye, up, np.cross(up, eye)])


def picked_frame(camera: Camera, theta_v: float, turned: float) -> np.ndarray:
    """Columns: across the picked normal towards the eye, right-handed with it, and the normal."""
    eye, up, aside = facing(camera)
    side = math.cos(turned) * up + math.sin(turned) * aside
    n = math.cos(theta_v) * eye + math.sin(theta_v) * side
    x = math.sin(theta_v) * eye - math.cos(theta_v) * side
    return np.stack([x, np.cross(n, x), n], -1)


def tangent_azimuth(theta_v: float, turned: float) -> float:
    """The azimuth (rad), from the eye's, of X at the picked point: X runs along growing azimuth about the picture's
    upward direction, as on every ball and object of the board (`ball_tangent` of glsl/display/brush.glsl)."""
    return math.atan2(math.cos(theta_v) * math.cos(turned), -math.sin(turned))


def angles_of(normal, camera: Camera, values: dict) -> dict[str, float] | None:
    """The angles (rad) at which this unit normal is the picked one; None where the light does not reach it.

    `values` has the angles of the normal that is picked now.
    """
    n = np.asarray(normal, float) / np.linalg.norm(normal)
    light = light_direction(values["theta_l"], values["phi"])
    light = picked_frame(camera, values["theta_v"], values["turned"]) @ light
    eye, up, aside = facing(camera)
    if n @ light <= 0 or n @ eye <= 0:
        return None
    theta_v = math.atan2(math.hypot(n @ up, n @ aside), n @ eye)
    turned = math.atan2(n @ aside, n @ up) if theta_v > 1e-6 else values["turned"]
    x, y, z = light @ picked_frame(camera, theta_v, turned)
    return dict(zip(ANGLES, (math.atan2(math.hypot(x, y), z), theta_v, math.atan2(y, x), turned), strict=True))
