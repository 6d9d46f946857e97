"""Grids over the hemisphere above a surface whose normal is +z. Polar about any direction, denser towards it, they
end exactly at the horizon: for lobes that are drawn (glsl/display/lobe.glsl is the same grid) and integrated."""

import numpy as np

NORMAL = np.array([0.0, 0.0, 1.0])


def frame(pole) -> tuple[np.ndarray, np.ndarray]:
    """Two unit vectors (..., 3) across a unit vector (..., 3) with z >= 0 and across each other (Duff et al. 2017)."""
    x, y, z = np.moveaxis(np.asarray(pole, float), -1, 0)
    k = -1 / (1 + np.maximum(z, 0))
    return np.stack([1 + x * x * k, x * y * k, -x], -1), np.stack([x * y * k, 1 + y * y * k, -y], -1)


def rim(pole, way) -> np.ndarray:
    """How far (rad) the horizon is from the pole, on the great circle that leaves it along the unit vector `way`."""
    return np.arctan2(np.maximum(np.asarray(pole)[..., 2], 0), -np.asarray(way)[..., 2])


def around(pole, s, t, width) -> tuple[np.ndarray, np.ndarray]:
    """Directions (..., 3), and the solid angle of each per unit of the square (s, t).

    s goes once around the pole (..., 3), t along great circles to the horizon, by width sinh(c t): steps grow with the
    distance from the pole once that is more than `width` (..., rad).
    """
    across, along = frame(pole)
    turn = 2 * np.pi * np.asarray(s)[..., None]
    way = across * np.cos(turn) + along * np.sin(turn)
    stretch = np.arcsinh(rim(pole, way) / width)
    angle = width * np.sinh(t * stretch)
    d = pole * np.cos(angle)[..., None] + way * np.sin(angle)[..., None]
    return d, 2 * np.pi * np.sin(angle) * stretch * np.hypot(width, angle)


def apart(p, q) -> np.ndarray:
    """The angle between unit vectors, also a tiny one (Kahan 2006)."""
    return 2 * np.arctan2(np.linalg.norm(p - q, axis=-1), np.linalg.norm(p + q, axis=-1))


def halves(v, s, t, width) -> tuple[np.ndarray, np.ndarray]:
    """The same grid about the normal, of halfway vectors h: directions l = 2 (v.h) h - v, and their solid angle, which
    is 0 for those below the horizon and those that v sees from behind."""
    stretch = np.arcsinh(0.5 * np.pi / width)
    angle = width * np.sinh(t * stretch)
    turn = 2 * np.pi * np.asarray(s)
    h = np.stack([np.sin(angle) * np.cos(turn), np.sin(angle) * np.sin(turn), np.cos(angle) + 0 * turn], -1)
    v_dot_h = v[..., 0] * h[..., 0] + v[..., 1] * h[..., 1] + v[..., 2] * h[..., 2]
    d = 2 * v_dot_h[..., None] * h - v
    size = 8 * np.pi * np.sin(angle) * stretch * np.hypot(width, angle) * v_dot_h
    return d, np.where((d[..., 2] > 0) & (v_dot_h > 0), size, 0.0)
