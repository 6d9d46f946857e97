"""Directions and points on the unit sphere."""

import numpy as np


def direction(theta, phi):
    """The unit vector with polar angle theta from +z and azimuth phi from +x towards +y.

    (sin theta cos phi, sin theta sin phi, cos theta)

    theta, phi (...) rad. Returns (..., 3). Errors: none. Source: deck, Solid Angles.
    """
    theta, phi = np.broadcast_arrays(np.asarray(theta, float), np.asarray(phi, float))
    return np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], -1)


def direction_theta(theta, phi):
    """The unit vector along which theta grows: at phi 0 it points from the pole down to the base plane.

    (cos theta cos phi, cos theta sin phi, -sin theta)

    theta, phi (...) rad. Returns (..., 3). Errors: none. Source: deck, Solid Angles.
    """
    theta, phi = np.broadcast_arrays(np.asarray(theta, float), np.asarray(phi, float))
    return np.stack([np.cos(theta) * np.cos(phi), np.cos(theta) * np.sin(phi), -np.sin(theta)], -1)


def direction_phi(phi):
    """The horizontal unit vector along which phi grows.

    (-sin phi, cos phi, 0)

    phi (...) rad. Returns (..., 3). Errors: none. Source: deck, Solid Angles.
    """
    phi = np.asarray(phi, float)
    return np.stack([-np.sin(phi), np.cos(phi), np.zeros_like(phi)], -1)


def light_direction(theta_l, phi):
    """The unit vector l to the light, n being +z; the eye stands at azimuth 0, its mirror side is phi = pi.

    direction(theta_l, phi)

    theta_l, phi (...) rad. Returns (..., 3). Errors: none. Source: deck, The BRDF (2).
    """
    return direction(theta_l, phi)


def view_direction(theta_v):
    """The unit vector v to the eye, n being +z: in the half plane of +x.

    direction(theta_v, 0)

    theta_v (...) rad. Returns (..., 3). Errors: none. Source: deck, The BRDF (2).
    """
    return direction(theta_v, 0.0)


def light_and_view(theta_l, theta_v, phi):
    """l + v, which points along the halfway vector: nothing is lost where the two lie on opposite sides.

    x: 2 cos((theta_v + theta_l) / 2) sin((theta_v - theta_l) / 2) + 2 sin theta_l cos^2(phi / 2)

    theta_l, theta_v, phi (...) rad. Returns (..., 3). Errors: none. Source: sums of sines as products.
    """
    theta_l, theta_v, phi = np.broadcast_arrays(*(np.asarray(x, float) for x in (theta_l, theta_v, phi)))
    aside = np.cos(0.5 * (theta_v + theta_l)) * np.sin(0.5 * (theta_v - theta_l))
    x = 2 * (aside + np.sin(theta_l) * np.cos(0.5 * phi) ** 2)
    return np.stack([x, np.sin(theta_l) * np.sin(phi), np.cos(theta_l) + np.cos(theta_v)], -1)


def fibonacci_direction(index, samples):
    """Direction number `index` of `samples` directions spread evenly over the whole sphere.

    z = 1 - (2 index + 1) / samples, phi = 2 pi frac(index / 1.618...), the golden turn as 2654435769 / 2^32

    index (...) 0 .. samples - 1, samples (...) >= 1, integers. Returns (..., 3). Errors: none.
    Source: Swinbank and Purser 2006, Fibonacci grids: a novel approach to global modelling.
    """
    index, samples = np.broadcast_arrays(np.asarray(index, np.int64), np.asarray(samples, np.int64))
    turn = ((index * 2654435769 + 2**31) % 2**32 - 2**31) / 2**32  # -1/2 .. 1/2
    above, below = 2 * index + 1.0, 2 * (samples - index) - 1.0  # samples (1 - z), samples (1 + z)
    r, phi = np.sqrt(above * below) / samples, 2 * np.pi * turn
    return np.stack([r * np.cos(phi), r * np.sin(phi), 0.5 * (below - above) / samples], -1)


def fibonacci_direction_naive(index, samples):
    """Direction number `index` of `samples` directions in equal steps of the polar angle: crowded at the poles.

    theta = pi (2 index + 1) / (2 samples), phi as in fibonacci_direction

    index (...) 0 .. samples - 1, samples (...) >= 1, integers. Returns (..., 3). Errors: sin theta is missing, so a
    place at theta gets 2 / (pi sin theta) times its share. Source: deck, Solid Angles, dw = sin theta dtheta dphi.
    """
    index, samples = np.broadcast_arrays(np.asarray(index, np.int64), np.asarray(samples, np.int64))
    turn = ((index * 2654435769 + 2**31) % 2**32 - 2**31) / 2**32
    return direction(np.pi * (2 * index + 1) / (2 * samples), 2 * np.pi * turn)


def sphere_point(s, t):
    """A point of the unit sphere: s goes once around, t from the pole +z to the pole -z.

    direction(pi t, 2 pi s)

    s, t (...) in [0, 1]. Returns (..., 3). Errors: none. Source: deck, Solid Angles.
    """
    return direction(np.pi * np.asarray(t, float), 2 * np.pi * np.asarray(s, float))


def cap_point(half_angle, s, t):
    """A point of the cap that a cone about +z cuts out of the unit sphere: s goes around, t from the pole to the rim.

    direction(half_angle t, 2 pi s)

    half_angle (...) rad, s, t (...) in [0, 1]. Returns (..., 3). Errors: none. Source: deck, Solid Angles.
    """
    return direction(np.asarray(half_angle, float) * np.asarray(t, float), 2 * np.pi * np.asarray(s, float))
