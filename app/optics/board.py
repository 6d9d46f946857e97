"""The factors of the Cook-Torrance model one after the other, at angles: what the board shows of a picked point.

theta_l and theta_v from the normal, phi the light's azimuth from the eye's; phi = pi on the mirror's side.
"""

import numpy as np

from app.optics.facets import d_halfway
from app.optics.fresnel import f_schlick
from app.optics.geometry_term import half_cosines, vgroove_at


def schlick_at(theta_l, theta_v, phi, f0):
    """The share that the facets towards h mirror.

    f_schlick(l.h, f0)

    theta_l, theta_v, phi (...) rad, f0 (...). Returns (...) 0 .. 1. Errors: those of Schlick's fit.
    Source: deck, Fresnel Term (1).
    """
    return f_schlick(half_cosines(theta_l, theta_v, phi)[..., 3], f0)


def dg_at(theta_l, theta_v, phi, m):
    """The facets that mirror l into v and are not blocked.

    D(h) G, Beckmann's D and the G of V-grooves

    theta_l, theta_v, phi (...) rad, m (...) RMS slope. Returns (...) 1/sr. Errors: none.
    Source: deck, Geometric Term (1).
    """
    return d_halfway(theta_l, theta_v, phi, m) * vgroove_at(theta_l, theta_v, phi)


def dgf_at(theta_l, theta_v, phi, m, f0):
    """The same, times what they mirror: the numerator of the Cook-Torrance model.

    D(h) G F

    theta_l, theta_v, phi (...) rad, m (...) RMS slope, f0 (...). Returns (...) 1/sr. Errors: none.
    Source: deck, The Cook - Torrance Model (2).
    """
    return dg_at(theta_l, theta_v, phi, m) * schlick_at(theta_l, theta_v, phi, f0)


def mirror_gain(theta, f0):
    """How much larger the mirror part is when light and eye both stand at an angle, opposite each other, than head-on.

    F(theta) / (f0 cos^2 theta): D is the same, G is 1

    theta (...) rad, below 90 degrees, f0 (...) above 0. Returns (...). Errors: none. Source: deck, The Cook - Torrance
    Model (2): the denominator, and Fresnel Term (1).
    """
    cosine = np.cos(np.asarray(theta, float))
    return f_schlick(cosine, f0) / (np.asarray(f0, float) * cosine**2)


def denominator(n_dot_l, n_dot_v):
    """What D G F is divided by: light and eye see the facets at a slant.

    4 (n.l)(n.v)

    n_dot_l, n_dot_v (...) 0 .. 1. Returns (...). Errors: none. Source: deck, The Cook - Torrance Model (2), with 1/4
    for the printed 1/pi.
    """
    return 4 * np.asarray(n_dot_l, float) * np.asarray(n_dot_v, float)


def denominator_printed(n_dot_l, n_dot_v):
    """What D G F is divided by in print.

    pi (n.l)(n.v)

    n_dot_l, n_dot_v (...) 0 .. 1. Returns (...). Errors: none. Source: deck, The Cook - Torrance Model (2).
    """
    return np.pi * np.asarray(n_dot_l, float) * np.asarray(n_dot_v, float)
