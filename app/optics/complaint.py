"""Where Blinn-Phong and the physics of a surface part: five cases, each as a share of light or of a width.

`complaint` 0: guessed coefficients of red plastic, all that comes back; 1: the mirror of plastic; 2: gold, in the blue;
3: an exponent doubled, the width left; 4: a white rough mirror in a furnace.
"""

import numpy as np

from app.optics.blinn_phong import albedo_blinn_phong_limit
from app.optics.interface import reflected_share
from app.optics.materials import material_share
from app.optics.phong import half_width_phong

_PLASTIC, _GOLD, _BLUE = 1.5, 5, 2
_GUESS = 0.8 + 0.5  # k_d + k_s
_BODY = 0.8  # of the light that enters, this comes out again


def _select(complaint, *values):
    complaint, values = np.asarray(complaint), np.broadcast_arrays(*values)
    return np.select([complaint == i for i in range(4)], values[:4], values[4])[()]


def complaint_model(complaint, theta):
    """What Blinn-Phong gives, with coefficients that fit straight on.

    0.8 + 0.5; f0 of plastic; f0 of gold, blue; half_width_phong(200) / half_width_phong(100); cos^2 theta

    complaint (...) 0 .. 4, theta (...) rad, 0 .. pi/2. Returns (...). Errors: none. Source: deck, Need for a
    Physically-based Reflectance Model; The Importance of Being Normalized (1).
    """
    theta = np.asarray(theta, float)
    return _select(complaint, _GUESS + 0 * theta, reflected_share(0 * theta, _PLASTIC),
                   material_share(0 * theta, _GOLD, _BLUE), half_width_phong(200.0) / half_width_phong(100.0),
                   albedo_blinn_phong_limit(theta))


def complaint_truth(complaint, theta):
    """What the physics of the surface gives.

    F + 0.8 (1 - F) and F of plastic, by Fresnel; F of gold, blue; 1/2; 1

    complaint (...) 0 .. 4, theta (...) rad, 0 .. pi/2. Returns (...) 0 .. 1. Errors: those of f_material for gold; that
    8 tenths of what enters plastic come out is set, at every angle. Source: Fresnel 1823; deck, Fresnel Term (1).
    """
    theta = np.asarray(theta, float)
    f = reflected_share(theta, _PLASTIC)
    return _select(complaint, f + _BODY * (1 - f), f, material_share(theta, _GOLD, _BLUE), 0.5, 1.0)
