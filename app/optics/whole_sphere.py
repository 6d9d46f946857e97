"""Shares of the whole sphere: how many, how much is left, how often around (deck, slide Solid Angles: 4 pi)."""

import numpy as np

from app.optics.solid_angle import solid_angle_cone
from app.optics.solid_angle_flat import solid_angle_mesh


def plane_angle(half_angle):
    """An angle of the circle that opens to both sides of its axis.

    2 half_angle

    half_angle: rad. Returns rad. Source: deck, slide Basic Concepts.
    """
    return 2 * np.asarray(half_angle, float)


def cones_in_the_sphere(half_angle):
    """How many cones would fill all directions, by area (round cones leave gaps: this many is a lower bound).

    4 pi / solid_angle_cone(half_angle)

    half_angle: rad, > 0 (0 gives inf). Returns a number. Source: deck, slide Solid Angles: omega_sphere = 4 pi.
    """
    with np.errstate(divide="ignore"):
        return 4 * np.pi / solid_angle_cone(half_angle)


def sphere_less_cone(half_angle):
    """What a sphere around one takes up when a round hole of this half angle is cut into it.

    4 pi - solid_angle_cone(half_angle) = solid_angle_cone(pi - half_angle)

    half_angle: rad. Returns sr. Source: deck, slide Solid Angles.
    """
    return solid_angle_cone(np.pi - np.asarray(half_angle, float))


def digits_after_cancellation(size, distance):
    """Decimal digits float32 has left after subtracting terms of size one whose difference is (size / distance)^2.

    max(0, log10(2^24 (size / distance)^2))

    size, distance: m. Returns digits; a rule of thumb for the printed triangle formula, whose error it brackets.
    Source: Goldberg 1991, What Every Computer Scientist Should Know About Floating-Point Arithmetic.
    """
    ratio = np.asarray(size, float) / np.asarray(distance, float)
    with np.errstate(divide="ignore"):
        return np.maximum(0, np.log10(2.0**24 * ratio**2))


def winding_number(triangles, eye):
    """How often a mesh goes around the eye: 1 inside a closed one, 0 outside, between when it is open.

    solid_angle_mesh(triangles, eye) / (4 pi)

    triangles: (faces, 3, 3), m, counter-clockwise from outside; eye: (..., 3), m. Returns a number.
    Source: Jacobson, Kavan and Sorkine-Hornung 2013.
    """
    return solid_angle_mesh(triangles, eye) / (4 * np.pi)
