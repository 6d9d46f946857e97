"""Projected solid angles: each direction weighted by its cosine with the normal +z, the horizon cut off.

This is the irradiance a source of radiance 1 gives to a surface at the origin.
"""

import numpy as np
from numpy import pi

from app.optics.solid_angle_flat import _dot
from app.quadrature import gauss_legendre

_AT, _WEIGHT = gauss_legendre(8)


def projected_solid_angle_cone(half_angle):
    """The projected solid angle of a cone of directions about the normal.

    pi sin^2(half_angle); beyond half_angle = pi/2 the rest lies below the horizon and the value stays pi

    half_angle (...) rad. Returns (...) sr. Errors: none. Source: deck, Basic Concepts.
    """
    return pi * np.sin(np.minimum(np.asarray(half_angle, float), 0.5 * pi)) ** 2


def projected_solid_angle_sphere(radius, distance, theta):
    """The projected solid angle of a sphere whose centre is `distance` away at the angle theta from the normal.

    s = radius / distance, mu = cos theta. Above the horizon (mu >= s) pi mu s^2, as a point light; below (mu <= -s) 0;
    cut by it z = sqrt((s^2 - mu^2) / (1 - s^2)): s^2 z - (z - atan z) + mu s^2 atan2(z, -mu)

    radius, distance (...) m, theta (...) rad. Returns (...) sr; pi from inside, pi (1 + mu) / 2 on the surface.
    Errors: up to 4e-5 in float32 where nearly all of it is below the horizon.
    Source: Snyder 1969, Radiant interchange configuration factors for spherical and conical surfaces, rearranged.
    """
    radius, distance, theta = np.broadcast_arrays(*(np.asarray(x, float) for x in (radius, distance, theta)))
    outside = distance > radius
    far = np.where(outside, distance, 2 * radius)
    s, mu = radius / far, np.cos(theta)
    z = far * np.sqrt(np.maximum(0, (s - mu) * (s + mu)) / ((far - radius) * (far + radius)))
    cut = s * s * z - _z_minus_atan(z) + mu * s * s * np.arctan2(z, -mu)
    value = np.where(mu >= s, pi * mu * s * s, np.where(mu <= -s, 0.0, cut))
    return np.where(outside, value, np.where(distance < radius, pi, 0.5 * pi * (1 + mu)))[()]


def _z_minus_atan(z):
    x, tail = z * z, np.zeros_like(z)
    for n in range(21, 1, -2):  # z^3/3 - z^5/5 + ...
        tail = 1 / n - x * tail
    return np.where(z < 0.15, z * x * tail, z - np.arctan(z))


def projected_solid_angle_sphere_naive(radius, distance, theta):
    """The projected solid angle of a sphere in the printed form, which cancels where the horizon cuts a far sphere.

    h = distance / radius, g = sqrt(h^2 - 1), where it is cut:
    pi/2 - asin(g / (h sin theta)) + (cos theta acos(-g cot theta) - g sqrt(1 - h^2 cos^2 theta)) / h^2

    radius, distance (...) m, theta (...) rad. Returns (...) sr. Errors: float32 4e-3 at h = 10, 3000 % at 100.
    Source: Snyder 1969, as printed in Howell's catalogue.
    """
    radius, distance, theta = np.broadcast_arrays(*(np.asarray(x, float) for x in (radius, distance, theta)))
    h, mu, sine = np.maximum(1.0, distance / radius), np.cos(theta), np.maximum(np.sin(theta), 1e-300)
    g = np.sqrt(h * h - 1)
    rise = np.arcsin(np.minimum(1, g / (h * sine)))
    turn = np.arccos(np.clip(-g * mu / sine, -1, 1))
    cut = 0.5 * pi - rise + (mu * turn - g * np.sqrt(np.maximum(0, 1 - h * h * mu * mu))) / (h * h)
    value = np.where(h * mu >= 1, pi * mu / (h * h), np.where(h * mu <= -1, 0.0, cut))
    return np.where(distance < radius, pi, value)[()]


def projected_solid_angle_disk(radius, height, offset):
    """The projected solid angle of a disk parallel to the surface, `height` above it, its axis offset sideways.

    z = height^2 + offset^2 - radius^2, s = sqrt(z^2 + 4 radius^2 height^2):
    2 pi radius^2 height^2 / (s (s + z)) for z > 0, else pi/2 (s - z) / s

    radius > 0, height > 0, offset >= 0 (...) m. Returns (...) sr. Errors: none.
    Source: Howell, catalogue of configuration factors, B-12, multiplied out.
    """
    radius, height, offset = (np.asarray(x, float) for x in (radius, height, offset))
    z = height * height + (offset - radius) * (offset + radius)
    s = np.hypot(z, 2 * radius * height)
    far = 2 * pi * (radius * height / s) * (radius * height / (s + np.maximum(z, 0)))
    return np.where(z > 0, far, 0.5 * pi * (s - z) / s)[()]


def projected_solid_angle_disk_naive(radius, height, offset):
    """The projected solid angle of a parallel disk in the printed form, which cancels for a far disk.

    pi/2 (1 - (height^2 + offset^2 - radius^2) / sqrt((height^2 + offset^2 + radius^2)^2 - 4 offset^2 radius^2))

    radius, height > 0, offset (...) m. Returns (...) sr. Errors: float32 1 % at height 100 radius.
    Source: Howell, catalogue of configuration factors, B-12.
    """
    r2, h2, o2 = (np.asarray(x, float) ** 2 for x in (radius, height, offset))
    return 0.5 * pi * (1 - (h2 + o2 - r2) / np.sqrt((h2 + o2 + r2) ** 2 - 4 * o2 * r2))


def projected_solid_angle_polygon(corners, corner_count):
    """The projected solid angle of a plane polygon without crossings, seen from the origin, cut at the horizon z = 0.

    |sum over edges (p, q) of (c.z / |c|) atan2(|c|, p.q)| / 2, c = p x (q - p). This sum cancels for a small polygon:
    there the integral of z |N.a| / r^4 over a fan of triangles, N = (b - a) x (c - a), with 8 x 8 Gauss points each.

    corners (..., n, 3) m, corner_count (...) <= n. Returns (...) sr. Errors: of the sum about 20 u times the sum of
    |terms| over the result, large for a long sliver only. Source: Lambert 1760, Photometria.
    """
    p = _above_horizon(corners, corner_count)
    near = np.min(np.sqrt(_dot(p, p)), -1)
    across = p - p[..., :1, :]
    small = np.max(np.sqrt(_dot(across, across)), -1) < 0.25 * near
    value = np.asarray(np.where(small, 0.0, np.abs(_contour(p))))
    value[small] = np.abs(_quadrature(p[small]))
    return value[()]


def _above_horizon(corners, corner_count):
    """The polygon cut at z = 0: each edge leaves its start and its crossing, a point below repeats the one before."""
    p = np.asarray(corners, float)
    index = np.minimum(np.arange(p.shape[-2]), np.asarray(corner_count)[..., None] - 1)
    p, index = np.broadcast_arrays(p, index[..., None])
    p = np.take_along_axis(p, index, -2)
    q = np.roll(p, -1, -2)
    up, crosses = p[..., 2] >= 0, (p[..., 2] >= 0) != (q[..., 2] >= 0)
    rise = np.where(crosses, q[..., 2] - p[..., 2], 1.0)[..., None]
    cut = (p * q[..., 2:] - q * p[..., 2:]) / rise
    cut[..., 2] = 0
    points = np.stack([p, cut], -2).reshape(*p.shape[:-2], -1, 3)
    keep = np.stack([up, crosses], -1).reshape(*up.shape[:-1], -1)
    places = np.arange(keep.shape[-1])
    latest = np.maximum.accumulate(np.where(keep, places, -1), -1)
    latest = np.where(latest < 0, np.max(np.where(keep, places, -1), -1, keepdims=True), latest)
    points = np.take_along_axis(points, np.maximum(latest, 0)[..., None], -2)
    return np.where(keep.any(-1)[..., None, None], points, 1.0)  # all below: one point, which has no extent


def _contour(p):
    q = np.roll(p, -1, -2)
    c = np.cross(p, q - p)
    size = np.sqrt(_dot(c, c))
    return 0.5 * np.sum(c[..., 2] / np.where(size > 0, size, 1) * np.arctan2(size, _dot(p, q)), -1)


def _quadrature(p):
    a, b, c = p[..., :1, :], p[..., 1:-1, :] - p[..., :1, :], p[..., 2:, :] - p[..., 1:-1, :]
    total = np.zeros(b.shape[:-1])
    for u, weight_u in zip(_AT, _WEIGHT, strict=True):
        for v, weight_v in zip(_AT, _WEIGHT, strict=True):
            point = a + u * (b + v * c)
            total += weight_u * weight_v * u * point[..., 2] / _dot(point, point) ** 2
    return np.sum(total * _dot(a, np.cross(b, c)), -1)


def projected_solid_angle_rectangle(x0, x1, y0, y1, distance):
    """The projected solid angle of the rectangle x0 .. x1, y0 .. y1 in the plane z = distance, parallel to the surface.

    Where the normal meets it, the sum over its corners of (x/p atan(y/p) + y/q atan(x/q)) / 2 with
    p^2 = x^2 + distance^2, q^2 = y^2 + distance^2; elsewhere that sum cancels, and it is taken as a polygon.

    x0 <= x1, y0 <= y1, distance > 0 (...) m. Returns (...) sr. Errors: those of projected_solid_angle_polygon.
    Source: Howell, catalogue of configuration factors, B-3.
    """
    x0, x1, y0, y1, d = np.broadcast_arrays(*(np.asarray(x, float) for x in (x0, x1, y0, y1, distance)))
    corners = sum(_corner(np.abs(x), np.abs(y), d) for x in (x0, x1) for y in (y0, y1))
    polygon = np.stack([np.stack([x, y, d], -1) for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))], -2)
    return np.where((x0 * x1 <= 0) & (y0 * y1 <= 0), corners, projected_solid_angle_polygon(polygon, 4))[()]


def _corner(x, y, distance):
    p, q = np.hypot(x, distance), np.hypot(y, distance)
    return 0.5 * (x / p * np.arctan2(y, p) + y / q * np.arctan2(x, q))


def projected_solid_angle_wall(distance, width, height):
    """The projected solid angle of a wall standing on the surface's plane, one lower corner straight ahead.

    The rectangle x = distance, y in 0 .. width, z in 0 .. height; b^2 = distance^2 + height^2,
    k = height^2 / (b + distance): (k/b atan(width / distance) + distance/b atan(width k / (distance b + width^2))) / 2

    distance, width, height (...) m. Returns (...) sr. Errors: none; the printed difference of two arctangents loses all
    digits of a low wall. Source: Howell, catalogue of configuration factors, B-4, rearranged.
    """
    distance, width, height = (np.asarray(x, float) for x in (distance, width, height))
    b = np.hypot(distance, height)
    k = height * height / (b + distance)
    rest = np.arctan2(width * k, distance * b + width * width)
    return 0.5 * (k / b * np.arctan2(width, distance) + distance / b * rest)
