"""A camera that orbits its target: matrices for OpenGL, in float64. n = +z is up."""

import math

import numpy as np

from app.lesson import Camera

NEAR, FAR = 0.05, 100.0


def position(camera: Camera) -> np.ndarray:
    a, e = math.radians(camera.azimuth), math.radians(camera.elevation)
    away = np.array([math.cos(e) * math.cos(a), math.cos(e) * math.sin(a), math.sin(e)])
    return np.asarray(camera.target) + camera.distance * away


def view_projection(camera: Camera, aspect: float) -> np.ndarray:
    """4x4, world to clip space. A picture taller than wide keeps the horizontal field of view instead."""
    a = math.radians(camera.azimuth)
    eye = position(camera)
    forward = np.asarray(camera.target) - eye
    forward /= np.linalg.norm(forward)
    side = np.array([-math.sin(a), math.cos(a), 0.0])  # never degenerate, also straight from above
    up = np.cross(side, forward)
    view = np.eye(4)
    view[:3, :3] = [side, up, -forward]
    view[:3, 3] = -view[:3, :3] @ eye
    scale = 1 / math.tan(math.radians(camera.field_of_view) / 2) * min(1.0, aspect)
    depth, lift = (FAR + NEAR) / (NEAR - FAR), 2 * FAR * NEAR / (NEAR - FAR)
    return np.array([[scale / aspect, 0, 0, 0], [0, scale, 0, 0], [0, 0, depth, lift], [0, 0, -1, 0]]) @ view


def project(points: np.ndarray, matrix: np.ndarray) -> np.ndarray:
    """World points (..., 3) to the picture: x, y in [0, 1] from the top left, and w (behind the eye: w <= 0)."""
    clip = np.concatenate([points, np.ones((*points.shape[:-1], 1))], -1) @ matrix.T
    w = clip[..., 3]
    safe = np.where(np.abs(w) < 1e-9, 1e-9, w)
    return np.stack([0.5 + 0.5 * clip[..., 0] / safe, 0.5 - 0.5 * clip[..., 1] / safe, w], -1)
