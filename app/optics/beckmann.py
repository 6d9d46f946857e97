"""Beckmann's distribution of facets: in the deck's two forms, which lose their digits, and in one that does not.

A facet distribution D is a density per steradian: D cos a dw is the share of the surface's area, seen from above,
whose facets point into dw, so its integral with the cosine is 1. `slope2` is the square of a facet's slope, tan^2 of
the angle a between n and h. `h` need not be of unit length: l + v is better than its direction.
"""

import numpy as np
from numpy import pi

STEEPEST = 1e18  # slope2 of a facet on edge
SMOOTHEST = 1e-5  # a smaller m or width is taken as this: a mirror to two seconds of arc


def _dot(a, b):
    a, b = np.asarray(a, float), np.asarray(b, float)  # three sums are faster than np.sum over so short an axis
    return a[..., 0] * b[..., 0] + a[..., 1] * b[..., 1] + a[..., 2] * b[..., 2]


def slope_squared(n, h):
    """The square of the slope of a facet with normal h on a surface with normal n.

    tan^2 a = |n x h|^2 / (n.h)^2; 1e18 where the facet stands on edge or looks away

    n, h (..., 3), of any length. Returns (...). Errors: none. Source: deck, Distribution Term (3), without
    1 - cos^2 a; Lagrange's identity.
    """
    n, h = np.broadcast_arrays(np.asarray(n, float), np.asarray(h, float))
    across, along = np.cross(n, h), _dot(n, h)
    towards = along > 0
    slope2 = _dot(across, across) / np.where(towards, along, 1) ** 2
    return np.where(towards, np.minimum(slope2, STEEPEST), STEEPEST)[()]


def d_beckmann_slope(slope2, m):
    """Beckmann's distribution of a facet's slope.

    e^(-t / m^2) (1 + t)^2 / (pi m^2), t = slope2; the exponential is split so that no factor leaves the range of floats

    slope2 >= 0 (...), m (...) RMS slope. Returns (...) 1/sr. Errors: none; m below 1e-5 is taken as 1e-5.
    Source: deck, Distribution Term (2) and (3); Beckmann and Spizzichino 1963.
    """
    slope2, m = np.asarray(slope2, float), np.maximum(np.asarray(m, float), SMOOTHEST)
    root = np.exp(-0.5 * slope2 / m / m) * (1 + slope2)
    return root / (pi * m * m) * root


def d_beckmann(n, h, m):
    """Beckmann's distribution of facets, stable for every m.

    e^(-tan^2 a / m^2) / (pi m^2 cos^4 a), tan^2 a from the cross product; 0 where n.h <= 0

    n, h (..., 3) of any length, m (...) RMS slope. Returns (...) 1/sr. Errors: none; m below 1e-5 is taken as 1e-5.
    Source: deck, Distribution Term (2) and (3); Beckmann and Spizzichino 1963.
    """
    return np.where(_dot(n, h) > 0, d_beckmann_slope(slope_squared(n, h), m), 0.0)[()]


def d_beckmann_naive(n, h, m):
    """Beckmann's distribution in the deck's fast form, with dot products only: 1 - cos^2 a cancels for small a.

    tan^2 a = (1 - cos^2 a) / cos^2 a, cos a = n.h

    n, h (..., 3) of unit length, m (...) RMS slope. Returns (...) 1/sr. Errors: none.
    Source: deck, Distribution Term (3).
    """
    c, m = _dot(n, h), np.maximum(np.asarray(m, float), SMOOTHEST)
    towards = c > 0
    c2 = np.where(towards, c, 1) ** 2
    return np.where(towards, np.exp(np.minimum(-(1 - c2) / c2 / m**2, 80.0)) / (pi * m**2 * c2 * c2), 0.0)[()]


def d_beckmann_acos_naive(n, h, m):
    """Beckmann's distribution in the deck's expensive form, with an arc cosine and a tangent.

    e^(-tan^2 a / m^2) / (pi m^2 cos^4 a), a = acos(n.h)

    n, h (..., 3) of unit length, m (...) RMS slope. Returns (...) 1/sr. Errors: none.
    Source: deck, Distribution Term (2).
    """
    c, m = _dot(n, h), np.maximum(np.asarray(m, float), SMOOTHEST)
    towards = c > 0
    a = np.arccos(np.clip(np.where(towards, c, 1), -1, 1))
    return np.where(towards, np.exp(-(np.tan(a) / m) ** 2) / (pi * m**2 * np.cos(a) ** 4), 0.0)[()]


def d_beckmann_printed(theta_h, m):
    """Beckmann's distribution as our copy of the deck prints it the second time: without the minus sign.

    e^(+tan^2 a / m^2) / (pi m^2 cos^4 a); the exponent is held at 80, where the curve has left every page

    theta_h (...) rad below pi/2, m (...) RMS slope. Returns (...) 1/sr. Errors: none.
    Source: deck, Distribution Term (3).
    """
    theta_h, m = np.asarray(theta_h, float), np.maximum(np.asarray(m, float), SMOOTHEST)
    c = np.maximum(np.cos(theta_h), 1e-4)
    tangent = np.sin(theta_h) / c
    return np.exp(np.minimum((tangent / m) ** 2, 80.0)) / (pi * m**2 * c**4)


def beckmann_tail(theta_h, m):
    """The share of a Beckmann surface, seen from above, whose facets are turned by more than an angle.

    e^(-tan^2 a / m^2)

    theta_h (...) rad, m (...) RMS slope. Returns (...). Errors: none; m below 1e-5 is taken as 1e-5.
    Source: the integral of D cos a over the angles beyond, in closed form.
    """
    theta_h, m = np.asarray(theta_h, float), np.maximum(np.asarray(m, float), SMOOTHEST)
    return np.exp(-(np.sin(theta_h) / np.maximum(np.cos(theta_h), 1e-9) / m) ** 2)


def beckmann_within(theta_h, m):
    """The share of a Beckmann surface, seen from above, whose facets are turned by less than an angle; 1 in all.

    1 - e^(-tan^2 a / m^2)

    theta_h (...) rad, m (...) RMS slope. Returns (...). Errors: none; m below 1e-5 is taken as 1e-5.
    Source: the integral of D cos a up to the angle, in closed form.
    """
    theta_h, m = np.asarray(theta_h, float), np.maximum(np.asarray(m, float), SMOOTHEST)
    return -np.expm1(-(np.sin(theta_h) / np.maximum(np.cos(theta_h), 1e-9) / m) ** 2)


def exponent_from_m(m):
    """The exponent of the cosine lobe that is as wide as Beckmann's.

    2 / m^2 - 2

    m (...) RMS slope, at most 1. Returns (...). Errors: none; m below 1e-5 is taken as 1e-5.
    Source: Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces.
    """
    m = np.maximum(np.asarray(m, float), SMOOTHEST)
    return 2 * ((1 - m) / m) * ((1 + m) / m)


def m_from_exponent(exponent):
    """The RMS slope of the Beckmann distribution that is as wide as a cosine lobe.

    sqrt(2 / (exponent + 2))

    exponent >= 0 (...). Returns (...). Errors: none. Source: Walter et al. 2007, solved for m.
    """
    return np.sqrt(2 / (np.asarray(exponent, float) + 2))


def sample_beckmann(xi_1, xi_2, m):
    """A facet normal drawn from Beckmann's distribution, n being +z: as likely as its share of the area, D cos a.

    tan^2 a = -m^2 log(1 - xi_1), azimuth 2 pi xi_2

    xi_1, xi_2 (...) in [0, 1), m (...) RMS slope. Returns (..., 3). Errors: none; xi_1 = 1 is taken as just below it.
    Source: Walter et al. 2007, by inverting 1 - e^(-tan^2 a / m^2).
    """
    t, s, m = np.broadcast_arrays(*(np.asarray(x, float) for x in (xi_1, xi_2, m)))
    slope = np.maximum(m, SMOOTHEST) * np.sqrt(-np.log1p(-np.minimum(t, 1 - 2.0**-24)))
    h = np.stack([slope * np.cos(2 * pi * s), slope * np.sin(2 * pi * s), np.ones_like(slope)], -1)
    return h / np.sqrt(1 + slope**2)[..., None]


def pdf_beckmann(n, l, v, m):
    """How likely a direction l is when v is mirrored by a facet of Beckmann's distribution.

    D (n.h) / (4 l.h); 0 for facets that look away

    n, l, v (..., 3) unit, m (...) RMS slope. Returns (...) 1/sr of l. Errors: none. Source: Walter et al. 2007.
    """
    return _of_mirrored(n, l, v, lambda h: d_beckmann(n, h, m))


def _of_mirrored(n, l, v, density):
    """D (n.h) / (4 l.h) with h = (l + v) / |l + v|: both dot products from the sum."""
    both = np.asarray(l, float) + np.asarray(v, float)
    squared, along = _dot(both, both), _dot(n, both)
    seen = along > 0
    return np.where(seen, density(both) * along / np.where(seen, 2 * squared, 1), 0.0)[()]
