"""Points of a rectangle spread evenly in solid angle: as many in each direction as it takes up there."""

import numpy as np


def strip_angle(x, y0, y1, distance):
    """The solid angle of the rectangle from 0 to x and y0 to y1 in the plane z = distance, negative for x < 0.

    asin(k1 w) - asin(k0 w), k = y / sqrt(y^2 + distance^2), w = x / sqrt(x^2 + distance^2), as one arctangent

    x, y0 <= y1, distance > 0 (...) m. Returns (...) sr. Errors: none.
    Source: Urena, Fajardo, King 2013, An Area-Preserving Parametrization for Spherical Rectangles, rearranged.
    """
    x, y0, y1, distance = (np.asarray(v, float) for v in (x, y0, y1, distance))
    r0, r1, r = (np.hypot(v, distance) for v in (y0, y1, x))
    k0, k1, w, c0, c1, c = y0 / r0, y1 / r1, x / r, distance / r0, distance / r1, distance / r
    q0, q1 = np.hypot(c, w * c0), np.hypot(c, w * c1)
    same = y0 * y1 > 0
    square = c0**2 * (y1 - y0) * ((y1 + y0) / r1**2)
    rise = np.where(same, square / np.where(same, k1 * q0 + k0 * q1, 1), k1 * q0 - k0 * q1)
    return np.arctan2(w * rise, q0 * q1 + k0 * k1 * w * w)


def strip_end(strip, y0, y1, distance):
    """The x at which strip_angle has a given value: its inverse.

    k = y / sqrt(y^2 + distance^2), w = sin a / sqrt((k1 - k0)^2 + 4 k0 k1 sin^2(a/2)), or with k0 and k1 of two signs
    the same as sin a / sqrt((k1 + k0)^2 - 4 k0 k1 cos^2(a/2)): x = distance w / sqrt(1 - w^2)

    strip a (...) sr, y0 < y1, distance > 0 (...) m. Returns (...) m. Errors: u (x / distance)^2, from 1 - w^2.
    Source: Urena, Fajardo, King 2013, An Area-Preserving Parametrization for Spherical Rectangles, its differences
    multiplied out (the printed form loses rectangles below 3e-4 sr in float32).
    """
    a, y0, y1, distance = (np.asarray(v, float) for v in (strip, y0, y1, distance))
    r0, r1 = np.hypot(y0, distance), np.hypot(y1, distance)
    k0, k1 = y0 / r0, y1 / r1
    less = (distance / r0) ** 2 * (y1 - y0) * ((y1 + y0) / r1**2) / (np.abs(k1) + np.abs(k0))  # |k1| - |k0|
    h = np.where(k0 * k1 > 0, np.sin(0.5 * a), np.cos(0.5 * a))
    w = np.sin(a) / np.sqrt(less**2 + 4 * np.abs(k0 * k1) * h**2)
    return distance * w / np.sqrt(np.maximum((1 - w) * (1 + w), 1e-300))


def strip_across(x, y0, y1, distance, t):
    """The y at a given x, even in solid angle: the sine of its latitude runs evenly from y0 to y1 with t.

    d^2 = x^2 + distance^2, v = (1-t) y0 / sqrt(y0^2 + d^2) + t y1 / sqrt(y1^2 + d^2): d v / sqrt((1 - v) (1 + v)),
    1 - v and 1 + v taken between those of the ends

    x, y0 <= y1, distance > 0 (...) m, t (...) in [0, 1]. Returns (...) m. Errors: none.
    Source: Urena, Fajardo, King 2013, An Area-Preserving Parametrization for Spherical Rectangles, rearranged.
    """
    x, y0, y1, distance, t = (np.asarray(v, float) for v in (x, y0, y1, distance, t))
    d = np.hypot(x, distance)
    e0, e1 = np.hypot(y0, d), np.hypot(y1, d)
    below = (1 - t) * _below_one(y0, e0, d) + t * _below_one(y1, e1, d)
    above = (1 - t) * _below_one(-y0, e0, d) + t * _below_one(-y1, e1, d)
    return np.clip(d * ((1 - t) * y0 / e0 + t * y1 / e1) / np.sqrt(below * above), y0, y1)


def _below_one(y, e, d):
    """1 - y / e, e^2 = y^2 + d^2."""
    return np.where(y > 0, d / e * (d / (e + np.maximum(y, 0))), 1 - y / e)


def spherical_rectangle_point(x0, x1, y0, y1, distance, s, t):
    """The point (s, t) of a rectangle in the plane z = distance, seen from the origin, even in solid angle.

    x = strip_end((1-s) strip_angle(x0) + s strip_angle(x1)), y = strip_across(x); density 1 / its solid angle

    x0 < x1, y0 < y1, distance > 0 (...) m, s, t (...) in [0, 1]. Returns (..., 3) m. Errors: u (x / distance)^2.
    Source: Urena, Fajardo, King 2013, An Area-Preserving Parametrization for Spherical Rectangles.
    """
    x0, x1, y0, y1, distance, s, t = np.broadcast_arrays(
        *(np.asarray(v, float) for v in (x0, x1, y0, y1, distance, s, t)))
    strip = (1 - s) * strip_angle(x0, y0, y1, distance) + s * strip_angle(x1, y0, y1, distance)
    x = np.clip(strip_end(strip, y0, y1, distance), x0, x1)
    return np.stack([x, strip_across(x, y0, y1, distance, t), distance], -1)
