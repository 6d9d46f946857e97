"""Emission distributions f_e(omega): which share of its flux a lamp sends in each direction."""

import numpy as np
from numpy import pi

from app.optics.spherical import direction


def _cosine_power(cosine, below, exponent):
    above = cosine > 0
    log = np.where(below < 0.5, np.log1p(-np.minimum(below, 0.5)), np.log(np.where(above, cosine, 1)))
    return np.where(above, np.exp(np.maximum(exponent * log, -700)), 0.0)


def emission(distribution, exponent, theta):
    """The emission distribution f_e of a lamp, normalised: its integral over all directions is 1.

    distribution 0, constant: 1 / (4 pi); 1, cosine: cos theta / pi; 2: (n + 1) / (2 pi) cos^n theta, n = exponent.
    1 and 2 send nothing beyond theta = pi/2.

    distribution (...) int, exponent >= 0 (...), theta (...) rad from the lamp's axis. Returns (...) 1/sr.
    Errors: none. Source: deck, Lighting Distribution (1); the constants are the integrals in closed form.
    """
    distribution, theta = np.asarray(distribution), np.asarray(theta, float)
    n = np.where(distribution == 1, 1.0, exponent)
    cosine = np.where(theta < 0.5 * pi, np.cos(theta), 0.0)
    lobe = (n + 1) / (2 * pi) * _cosine_power(cosine, 2 * np.sin(0.5 * theta) ** 2, n)
    return np.where(distribution == 0, 0.25 / pi, lobe)[()]


def radiant_intensity_of(radiant_flux, distribution, exponent, theta):
    """The radiant intensity of a lamp of a given flux in a direction.

    I = Phi f_e(theta)

    radiant_flux (...) W, distribution (...) int, exponent (...), theta (...) rad. Returns (...) W/sr; 0 for flux 0,
    negative for a negative flux, which is shown as a fault. Errors: none. Source: deck, Lighting Distribution (1).
    """
    return np.asarray(radiant_flux, float) * emission(distribution, exponent, theta)


def radiant_flux_of(radiant_intensity, exponent):
    """The flux of a lamp whose intensity is I cos^n(theta), from its intensity on the axis.

    2 pi I / (n + 1)

    radiant_intensity (...) W/sr, exponent >= 0 (...). Returns (...) W. Errors: none.
    Source: deck, Units for Lighting - Candela (the flux is the integral of the intensity), in closed form.
    """
    return 2 * pi * np.asarray(radiant_intensity, float) / (np.asarray(exponent, float) + 1)


def irradiance_distribution(radiant_flux, distribution, exponent, height, offset):
    """The irradiance on the floor from a lamp that looks straight down from a height, at an offset from below it.

    Phi f_e(theta) cos theta / d^2, tan theta = offset / height, d^2 = height^2 + offset^2

    radiant_flux (...) W, distribution (...) int, exponent (...), height > 0, offset >= 0 (...) m. Returns (...) W/m^2.
    Errors: none. Source: deck, Lighting Distribution (3) and Plausible Shading - Measuring Light.
    """
    height, offset, distribution = np.asarray(height, float), np.asarray(offset, float), np.asarray(distribution)
    d, n = np.hypot(height, offset), np.where(distribution == 0, 0.0, np.where(distribution == 1, 1.0, exponent))
    share = np.where(distribution == 0, 0.5, n + 1) / (2 * pi)
    share = share * _cosine_power(height / d, offset / d * (offset / (d + height)), n)
    return radiant_flux / d * share * (height / d) / d


def photometric_solid(distribution, exponent, s, t):
    """The photometric solid of a lamp looking down: each direction drawn out in proportion to its f_e.

    2 f_e(theta) e(theta, phi), theta = pi t from straight down, phi = 2 pi s; 2 m stand for 1/sr

    distribution (...) int, exponent (...), s, t (...) in [0, 1]. Returns (..., 3) m. Errors: none.
    Source: deck, Lighting Distribution (2).
    """
    theta = pi * np.asarray(t, float)
    outward = direction(theta, 2 * pi * np.asarray(s, float)) * np.array([1, 1, -1])
    return 2 * emission(distribution, exponent, theta)[..., None] * outward
