"""A ball seen from far away, as the Moon is: radiance along the middle of its disk, over what a white card there sends.

The eye looks along -z; the light comes from the angle `phase` to the right of the eye, (sin phase, 0, cos phase).
"""

import numpy as np
from numpy import pi

from app.optics.eon import brdf_eon
from app.optics.lambert import brdf_lambert
from app.optics.oren_nayar import brdf_oren_nayar
from app.optics.spherical import direction

TO_EYE = np.array([0.0, 0.0, 1.0])


def disk_normal(disk_x):
    """The normal of a ball at a place of its disk: the middle faces the eye, the rim is seen along.

    (x, 0, sqrt(1 - x^2)), x = disk_x

    disk_x (...) -1 .. 1. Returns (..., 3). Errors: none. Source: a sphere.
    """
    x = np.clip(np.asarray(disk_x, float), -1, 1)
    return np.stack([x, np.zeros_like(x), np.sqrt((1 - x) * (1 + x))], -1)


def disk_lambert(disk_x, phase, rho):
    """The radiance of a Lambertian ball at a place of its disk, relative to a white card that faces the light.

    pi f max(0, n.l), f = brdf_lambert

    disk_x (...) -1 .. 1, phase (...) rad, rho (...). Returns (...). Errors: none. Source: Lambert 1760, Photometria.
    """
    n, l = disk_normal(disk_x), direction(phase, 0.0)
    return pi * brdf_lambert(n, l, TO_EYE, rho) * np.maximum(0, np.sum(n * l, -1))


def disk_oren_nayar(disk_x, phase, rho, sigma):
    """The radiance of Oren and Nayar's ball at a place of its disk, relative to a white card that faces the light.

    pi f max(0, n.l), f = brdf_oren_nayar

    disk_x (...) -1 .. 1, phase (...) rad, rho (...), sigma (...) rad. Returns (...). Errors: those of brdf_oren_nayar.
    Source: Oren and Nayar 1994, who render the Moon so.
    """
    n, l = disk_normal(disk_x), direction(phase, 0.0)
    return pi * brdf_oren_nayar(n, l, TO_EYE, rho, sigma) * np.maximum(0, np.sum(n * l, -1))


def disk_eon(disk_x, phase, rho, roughness):
    """The radiance of an EON ball at a place of its disk, relative to a white card that faces the light.

    pi f max(0, n.l), f = brdf_eon

    disk_x (...) -1 .. 1, phase (...) rad, rho, roughness (...). Returns (...). Errors: none.
    Source: Portsmouth, Kutz and Hill 2025.
    """
    n, l = disk_normal(disk_x), direction(phase, 0.0)
    return pi * brdf_eon(n, l, TO_EYE, rho, roughness) * np.maximum(0, np.sum(n * l, -1))


def rim_oren_nayar(disk_x, phase, sigma):
    """What a place of the disk of Oren and Nayar's ball sends, over what the middle of the disk sends.

    disk_oren_nayar(disk_x) / disk_oren_nayar(0)

    disk_x (...) -1 .. 1, phase (...) rad, within pi/2, sigma (...) rad. Returns (...).
    Errors: those of brdf_oren_nayar. Source: Oren and Nayar 1994.
    """
    return disk_oren_nayar(disk_x, phase, 1.0, sigma) / disk_oren_nayar(0.0, phase, 1.0, sigma)
