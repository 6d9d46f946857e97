"""Facet distributions side by side: Gauss, the normalised cosine lobe, Beckmann and GGX, equally wide at one m.

`ndf` says which: 0 Gauss, 1 Blinn-Phong, 2 Beckmann, 3 GGX.
"""

import numpy as np
from numpy import pi

from app.optics.beckmann import (
    SMOOTHEST,
    _dot,
    d_beckmann,
    d_beckmann_acos_naive,
    d_beckmann_naive,
    d_beckmann_slope,
    exponent_from_m,
    slope_squared,
)
from app.optics.distribution import _cosine_power
from app.optics.ggx import d_ggx_slope
from app.quadrature import gauss_legendre

_NODES, _WEIGHTS = gauss_legendre(40)


def gauss_constant(m):
    """What makes Gauss's bell a facet distribution: the constant with which its integral with the cosine is 1.

    1 / (2 pi int_0^(pi/2) e^(-a^2 / m^2) cos a sin a da), near 1 / (pi m^2) for small m

    m (...) width in rad. Returns (...) 1/sr. Errors: none; m below 1e-5 is taken as 1e-5. Source: the integral, by 40
    Gauss-Legendre nodes; Blinn 1977 and Cook and Torrance 1982 leave the constant open.
    """
    m = np.maximum(np.asarray(m, float), SMOOTHEST)[..., None]
    end = np.minimum(0.5 * pi, 6.2 * m)
    a = end * _NODES
    return 1 / (pi * np.sum(_WEIGHTS * end * np.exp(-((a / m) ** 2)) * np.sin(2 * a), -1))


def d_gauss_slope(slope2, m):
    """Gauss's bell over the angle, as a facet distribution.

    c e^(-a^2 / m^2), a = atan(sqrt(slope2)), c = gauss_constant(m)

    slope2 >= 0 (...), m (...) width in rad. Returns (...) 1/sr. Errors: none; m below 1e-5 is taken as 1e-5.
    Source: deck, Distribution Term (1); Blinn 1977, with its own constant.
    """
    x = np.arctan(np.sqrt(slope2)) / np.maximum(np.asarray(m, float), SMOOTHEST)
    return gauss_constant(m) * np.exp(-x * x)


def d_gauss(n, h, m):
    """Gauss's bell over the angle between n and h, as a facet distribution; 0 where n.h <= 0.

    c e^(-a^2 / m^2), c = gauss_constant(m)

    n, h (..., 3) of any length, m (...) width in rad. Returns (...) 1/sr. Errors: none; m below 1e-5 is taken as 1e-5.
    Source: deck, Distribution Term (1); Blinn 1977, with its own constant.
    """
    return np.where(_dot(n, h) > 0, d_gauss_slope(slope_squared(n, h), m), 0.0)[()]


def d_blinn_phong_slope(slope2, exponent):
    """The cosine lobe as a facet distribution, of a facet's slope.

    (n + 2) / (2 pi) cos^n a, cos a = 1 / sqrt(1 + slope2), n = exponent

    slope2 >= 0 (...), exponent >= 0 (...). Returns (...) 1/sr. Errors: none.
    Source: deck, Distribution Term (1); the constant is the integral in closed form.
    """
    slope2, n = np.asarray(slope2, float), np.asarray(exponent, float)
    cosine = 1 / np.sqrt(1 + slope2)
    root = _cosine_power(cosine, slope2 / (1 + slope2) / (1 + cosine), 0.5 * n)
    return (n + 2) / (2 * pi) * root * root


def d_blinn_phong(n, h, exponent):
    """The cosine lobe as a facet distribution, its own constant and not that of the BRDF; 0 where n.h <= 0.

    (n + 2) / (2 pi) (n.h)^n, n = exponent

    n, h (..., 3) of any length, exponent >= 0 (...). Returns (...) 1/sr. Errors: none.
    Source: deck, Distribution Term (1); the constant is the integral in closed form.
    """
    return np.where(_dot(n, h) > 0, d_blinn_phong_slope(slope_squared(n, h), exponent), 0.0)[()]


def d_slope(ndf, slope2, m):
    """One of the four distributions, of a facet's slope.

    Gauss and GGX with width m, Beckmann with RMS slope m, the cosine lobe with exponent 2 / m^2 - 2

    ndf (...) int, slope2 >= 0 (...), m (...) at most 1 for the cosine lobe. Returns (...) 1/sr. Errors: none.
    Source: deck, Distribution Term (1); GGX: Walter et al. 2007.
    """
    ndf = np.asarray(ndf)
    lobe = d_blinn_phong_slope(slope2, exponent_from_m(np.minimum(m, 1.0)))
    return np.select([ndf == 0, ndf == 1, ndf == 2], [d_gauss_slope(slope2, m), lobe, d_beckmann_slope(slope2, m)],
                     d_ggx_slope(slope2, m))[()]


def d_at(ndf, theta_h, m):
    """One of the four distributions at an angle between n and h.

    d_slope(ndf, tan^2 theta_h, m)

    ndf (...) int, theta_h (...) rad, m (...). Returns (...) 1/sr. Errors: none. Source: deck, Distribution Term (1).
    """
    theta_h = np.asarray(theta_h, float)
    return d_slope(ndf, (np.sin(theta_h) / np.maximum(np.cos(theta_h), 1e-9)) ** 2, m)


def facet_area(ndf, m, rows, cosines):
    """The area of all facets over the area of the surface: as it is seen from above, near 1, or the facets' own.

    sum over rings of equal height in the angle of 2 pi D(a) cos^k a sin a da, k = cosines: 1 from above, 0 their own

    ndf (...) int, m (...), rows (...) int, cosines (...) int 0 or 1. Returns (...). Errors: none.
    Source: deck, Distribution Term (1): "it is a normalized term".
    """
    *_, d, weight = _rings(ndf, m, rows, cosines)
    return np.sum(d * weight, -1)


def _rings(ndf, m, rows, cosines):
    """ndf, angle, m, D and weight of each ring."""
    ndf, m, rows, cosines = (np.asarray(x)[..., None] for x in (ndf, m, rows, cosines))
    i = np.arange(int(np.max(rows, initial=1)))
    da = 0.5 * pi / rows
    a = np.where(i < rows, (i + 0.5) * da, 0.0)
    weight = np.where(i < rows, 2 * pi * np.sin(a) * np.where(cosines == 1, np.cos(a), 1) * da, 0.0)
    return ndf, a, m, d_at(ndf, a, m), weight


def facet_area_of_lobe(m):
    """What the BRDF's constant f_n would make of the cosine lobe as a facet distribution: too little area.

    f_n 2 pi / (n + 2), f_n = (n + 2)(n + 4) / (8 pi (n + 2^(-n/2))), n = 2 / m^2 - 2

    m (...) at most 1. Returns (...), from 1 down to near 1/4. Errors: none; m below 1e-5 is taken as 1e-5.
    Source: deck, Blinn-Phong BRDF (1) in the place of Distribution Term (1).
    """
    n = exponent_from_m(np.minimum(m, 1.0))
    return 0.25 * (n + 4) / (n + np.exp2(-0.5 * n))


def d_lean(ndf, slope_ratio, m):
    """One of the four distributions at a slope given in units of m, where a lobe of any width looks the same.

    d_slope(ndf, (slope_ratio m)^2, m)

    ndf (...) int, slope_ratio (...), m (...). Returns (...) 1/sr. Errors: none. Source: deck, Distribution Term (1).
    """
    return d_slope(ndf, (np.asarray(slope_ratio, float) * m) ** 2, m)


def leaning(slope_ratio, m):
    """The normal of a facet whose slope is given in units of m, n being +z.

    (x, 0, 1) / sqrt(1 + x^2), x = slope_ratio m

    slope_ratio (...), m (...). Returns (..., 3). Errors: none; m below 1e-5 is taken as 1e-5. Source: tan a = x.
    """
    x = np.asarray(slope_ratio, float) * np.maximum(np.asarray(m, float), SMOOTHEST)
    return np.stack([x, np.zeros_like(x), np.ones_like(x)], -1) / np.sqrt(1 + x * x)[..., None]


def d_beside(slope_ratio, m):
    """Beckmann's distribution at a slope given in units of m, through the vectors n = +z and h, as a shader has them.

    d_beckmann(n, h, m), h = leaning(slope_ratio, m)

    slope_ratio (...), m (...). Returns (...) 1/sr. Errors: none; m below 1e-5 is taken as 1e-5.
    Source: deck, Distribution Term (3).
    """
    return d_beckmann(np.array([0.0, 0.0, 1.0]), leaning(slope_ratio, m), m)


def d_beside_naive(slope_ratio, m):
    """The same by the deck's fast form, which takes 1 - cos^2 a.

    d_beckmann_naive(n, h, m), h = leaning(slope_ratio, m)

    slope_ratio (...), m (...). Returns (...) 1/sr. Errors: none in float64. Source: deck, Distribution Term (3).
    """
    return d_beckmann_naive(np.array([0.0, 0.0, 1.0]), leaning(slope_ratio, m), m)


def d_beside_acos_naive(slope_ratio, m):
    """The same by the deck's expensive form, with an arc cosine and a tangent.

    d_beckmann_acos_naive(n, h, m), h = leaning(slope_ratio, m)

    slope_ratio (...), m (...). Returns (...) 1/sr. Errors: none in float64. Source: deck, Distribution Term (2).
    """
    return d_beckmann_acos_naive(np.array([0.0, 0.0, 1.0]), leaning(slope_ratio, m), m)


def cosine_steps(slope_ratio, m):
    """How many float32 numbers there are between 1 and the cosine of a facet whose slope is given in units of m.

    2^24 (1 - cos a) = 2^24 t / (1 + t + sqrt(1 + t)), t = (slope_ratio m)^2

    slope_ratio (...), m (...). Returns (...), while the cosine is above 1/2. Errors: none.
    Source: IEEE 754: below 1 the numbers are 2^-24 apart.
    """
    t = (np.asarray(slope_ratio, float) * m) ** 2
    return 2.0**24 * t / (1 + t + np.sqrt(1 + t))
