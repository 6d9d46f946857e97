"""The distribution GGX, beyond the deck: a narrow peak with long tails, measured on real glass and metal."""

import numpy as np
from numpy import pi

from app.optics.beckmann import SMOOTHEST, _dot, _of_mirrored, slope_squared


def d_ggx_slope(slope2, alpha):
    """The distribution GGX of a facet's slope.

    k^2 / pi, k = (1 + t) / (alpha + t / alpha), t = slope2

    slope2 >= 0 (...), alpha (...) its width. Returns (...) 1/sr. Errors: none; alpha below 1e-5 is taken as 1e-5.
    Source: Trowbridge and Reitz 1975; Walter et al. 2007.
    """
    slope2, alpha = np.asarray(slope2, float), np.maximum(np.asarray(alpha, float), SMOOTHEST)
    return ((1 + slope2) / (alpha + slope2 / alpha)) ** 2 / pi


def d_ggx(n, h, alpha):
    """The distribution GGX of facets; 0 where n.h <= 0.

    alpha^2 / (pi (cos^2 a (alpha^2 - 1) + 1)^2), from tan^2 a

    n, h (..., 3) of any length, alpha (...) its width. Returns (...) 1/sr. Errors: none; alpha below 1e-5 is taken as
    1e-5. Source: Trowbridge and Reitz 1975; Walter et al. 2007.
    """
    return np.where(_dot(n, h) > 0, d_ggx_slope(slope_squared(n, h), alpha), 0.0)[()]


def sample_ggx(xi_1, xi_2, alpha):
    """A facet normal drawn from GGX, n being +z: as likely as its share of the area, D cos a.

    tan^2 a = alpha^2 xi_1 / (1 - xi_1), azimuth 2 pi xi_2

    xi_1, xi_2 (...) in [0, 1), alpha (...) its width. Returns (..., 3). Errors: none; xi_1 = 1 is taken as just
    below it. Source: Walter et al. 2007.
    """
    t, s, alpha = np.broadcast_arrays(*(np.asarray(x, float) for x in (xi_1, xi_2, alpha)))
    t = np.minimum(t, 1 - 2.0**-24)
    rise, run = np.maximum(alpha, SMOOTHEST) * np.sqrt(t), np.sqrt(1 - t)
    h = np.stack([rise * np.cos(2 * pi * s), rise * np.sin(2 * pi * s), run], -1)
    return h / np.hypot(rise, run)[..., None]


def pdf_ggx(n, l, v, alpha):
    """How likely a direction l is when v is mirrored by a facet of the distribution GGX.

    D (n.h) / (4 l.h); 0 for facets that look away

    n, l, v (..., 3) unit, alpha (...) its width. Returns (...) 1/sr of l. Errors: none. Source: Walter et al. 2007.
    """
    return _of_mirrored(n, l, v, lambda h: d_ggx(n, h, alpha))
