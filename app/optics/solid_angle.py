"""Solid angles of what is round: cones, spheres, disks, and cells of the sphere."""

import numpy as np
from numpy import pi


def solid_angle_cone(half_angle):
    """The solid angle of a cone of directions.

    4 pi sin^2(half_angle / 2)

    half_angle (...) rad, 0 .. pi. Returns (...) sr. Errors: none; a few roundings. Source: deck, Solid Angles.
    """
    return 4 * pi * np.sin(0.5 * np.asarray(half_angle, float)) ** 2


def solid_angle_cone_naive(half_angle):
    """The solid angle of a cone in the textbook form, which cancels for a narrow cone.

    2 pi (1 - cos half_angle)

    half_angle (...) rad. Returns (...) sr. Errors: float32 7 % at 1e-3 rad, 100 % at 1e-4. Source: deck, Solid Angles.
    """
    return 2 * pi * (1 - np.cos(np.asarray(half_angle, float)))


def solid_angle_sphere(radius, distance):
    """The solid angle of a sphere whose centre is at a distance.

    s = radius / distance, q = sqrt((distance - radius) (distance + radius)) / distance: 2 pi s^2 / (1 + q)

    radius, distance (...) m. Returns (...) sr; 4 pi from inside, 2 pi on the surface. Errors: none.
    Source: deck, Solid Angles.
    """
    radius, distance = np.broadcast_arrays(np.asarray(radius, float), np.asarray(distance, float))
    inside = distance < radius
    far = np.where(inside, radius, distance)
    s, q = radius / far, np.sqrt((far - radius) * (far + radius)) / far
    return np.where(inside, 4 * pi, 2 * pi * s * s / (1 + q))[()]


def solid_angle_sphere_naive(radius, distance):
    """The solid angle of a sphere in the textbook form, which cancels for a far sphere.

    2 pi (1 - sqrt(1 - (radius / distance)^2))

    radius, distance (...) m. Returns (...) sr. Errors: float32 1e-3 at distance 100 radius, 10 % at 1000.
    Source: deck, Solid Angles.
    """
    radius, distance = np.broadcast_arrays(np.asarray(radius, float), np.asarray(distance, float))
    inside = distance < radius
    s = radius / np.where(inside, radius, distance)
    return np.where(inside, 4 * pi, 2 * pi * (1 - np.sqrt(1 - s * s)))[()]


def solid_angle_disk_on_axis(radius, height):
    """The solid angle of a disk seen from a point of its axis.

    q = sqrt(height^2 + radius^2): 2 pi (radius / q) (radius / (q + height))

    radius > 0, height (...) m. Returns (...) sr; 2 pi at height 0. Errors: none. Source: deck, Solid Angles.
    """
    radius, height = np.asarray(radius, float), np.abs(np.asarray(height, float))
    q = np.hypot(height, radius)
    return 2 * pi * (radius / q) * (radius / (q + height))


def solid_angle_disk_on_axis_naive(radius, height):
    """The solid angle of a disk on its axis in the textbook form, which cancels for a far disk.

    2 pi (1 - height / sqrt(height^2 + radius^2))

    radius > 0, height (...) m. Returns (...) sr. Errors: float32 14 % at height 1000 radius.
    Source: deck, Solid Angles.
    """
    radius, height = np.asarray(radius, float), np.abs(np.asarray(height, float))
    return 2 * pi * (1 - height / np.hypot(height, radius))


def solid_angle_disk(radius, height, offset):
    """The solid angle of a disk seen from a point at a height over its plane, offset sideways from its axis.

    Near: 2 pi [offset < radius] - 2 height / R (K(k^2) + q Pi(c^2, k^2)), R^2 = height^2 + (radius + offset)^2,
    k^2 = 4 radius offset / R^2, q = (radius - offset) / (radius + offset), c^2 = 1 - q^2; K and Pi in one integral.
    Beyond two radii, where this cancels: 2 pi sum_k (-1)^(k+1) (2k-1)!!/(2k)!! (radius / d)^2k P_(2k-1)(height / d),
    d^2 = height^2 + offset^2.

    radius > 0, height, offset >= 0 (...) m. Returns (...) sr; at height 0: 2 pi inside, pi on the rim, 0 outside.
    Errors: none; cancels by at most a factor of 10 at two radii. Sources: Paxton 1959, Solid Angle Calculation for a
    Circular Disk; Bulirsch 1969 for the integral; the potential of a double layer for the series.
    """
    radius, height, offset = np.broadcast_arrays(*(np.asarray(x, float) for x in (radius, height, offset)))
    height = np.abs(height)
    value = np.where(height == 0, pi * (1 + np.sign(radius - offset)), 0.0)
    far = np.hypot(height, offset) > 2 * radius
    near = ~far & (height > 0)
    value[far] = _disk_far(radius[far], height[far], offset[far])
    value[near] = _disk_near(radius[near], height[near], offset[near])
    return value[()]


def _disk_near(radius, height, offset):
    reach, inner = np.hypot(height, radius + offset), radius - offset
    k_c, rim = np.hypot(height, inner) / reach, inner == 0
    q = inner / (radius + offset)
    root_p, a, b = (np.where(rim, 1.0, x) for x in (np.abs(q), 1 + q, q + q * q))
    integral = _complete_elliptic(k_c, root_p, a, b)
    return pi * (1 + np.sign(inner)) - 2 * height / reach * integral


def _disk_far(radius, height, offset):
    d = np.hypot(height, offset)
    c, x = height / d, (radius / d) ** 2
    total, scale, before, legendre = np.zeros_like(c), 0.5 * x, np.ones_like(c), c
    for n in range(2, 56, 2):  # (1/4)^27 = 5e-17
        total += scale * legendre
        scale = -scale * x * (n + 1) / (n + 2)
        before = ((2 * n - 1) * c * legendre - (n - 1) * before) / n
        legendre = ((2 * n + 1) * c * before - n * legendre) / (n + 1)
    return 2 * pi * total


def _complete_elliptic(k_c, root_p, a, b):
    """The integral of (a cos^2 + b sin^2) / ((cos^2 + p sin^2) sqrt(cos^2 + k_c^2 sin^2)) over 0 .. pi/2.

    Source: Bulirsch 1969, Numerical calculation of elliptic integrals and elliptic functions III, cel.
    """
    e, m, p, q = np.abs(k_c), np.ones_like(k_c), root_p, np.abs(k_c)
    b = b / p
    for _ in range(20):
        a, g, b = a + b / p, e / p, 2 * (b + a * e / p)
        p = p + g
        before, m = m, m + q
        if np.all(np.abs(before - q) <= 1e-8 * before):
            break
        q = 2 * np.sqrt(e)
        e = q * m
    return 0.5 * pi * (b + a * m) / (m * (m + p))


def solid_angle_cell(theta, d_theta, d_phi):
    """The solid angle of the cell of the sphere centred at theta, from theta - d_theta / 2 to theta + d_theta / 2.

    2 sin(theta) sin(d_theta / 2) d_phi

    theta, d_theta, d_phi (...) rad, the cell between the poles. Returns (...) sr. Errors: none.
    Source: deck, Solid Angles, integrated.
    """
    theta, d_theta, d_phi = (np.asarray(x, float) for x in (theta, d_theta, d_phi))
    return 2 * np.sin(theta) * np.sin(0.5 * d_theta) * d_phi


def solid_angle_cell_differential(theta, d_theta, d_phi):
    """The solid angle of a small cell of the sphere at theta.

    sin(theta) d_theta d_phi

    theta, d_theta, d_phi (...) rad. Returns (...) sr. Errors: too large by d_theta^2 / 24. Source: deck, Solid Angles.
    """
    theta, d_theta, d_phi = (np.asarray(x, float) for x in (theta, d_theta, d_phi))
    return np.sin(theta) * d_theta * d_phi


def solid_angle_cells(rows):
    """The whole sphere as the sum of sin(theta) d_theta d_phi over rows x 2 rows cells, theta at their centres.

    2 pi (pi / rows) sum over i of sin((i + 1/2) pi / rows) = 4 pi x / sin(x), x = pi / (2 rows)

    rows (...) >= 1. Returns (...) sr. Errors: too large by pi^2 / (24 rows^2). Source: deck, Solid Angles.
    """
    half_step = 0.5 * pi / np.asarray(rows, float)
    return 4 * pi * half_step / np.sin(half_step)
