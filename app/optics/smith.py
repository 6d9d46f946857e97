"""Smith's masking and shadowing: what blocks a facet of a surface whose heights at different places are independent.

Lambda is what is hidden per what is seen: a share 1 / (1 + Lambda) of the facets is seen, whichever way they face.
`m` is the RMS slope of Beckmann's surface, `alpha` the width of GGX; `slope` is either times tan(theta). A cosine below
1e-30 counts as 1e-30.
"""

import math

import numpy as np

_ERFC = np.frompyfunc(math.erfc, 1, 1)


def _slope(cosine, width):
    """width tan(theta)."""
    c = np.clip(np.asarray(cosine, float), 1e-30, 1.0)
    return np.asarray(width, float) * np.sqrt((1 - c) * (1 + c)) / c


def lambda_beckmann_slope(slope):
    """Smith's Lambda of a Gaussian surface, from the slope of its facets over that of the direction.

    e^(-a^2) / (2 a sqrt(pi)) - erfc(a) / 2, a = 1 / slope; from a = 2 on, where that cancels,
    e^(-a^2) / (2 sqrt(pi)) r / (a (a + r)) with the continued fraction r = 1/2 / (a + 1 / (a + 3/2 / (a + ...)))

    slope (...) >= 0: m tan theta. Returns (...) >= 0. Errors: none seen beyond rounding.
    Source: Smith 1967; Walter et al. 2007; the fraction is Laplace's (Abramowitz & Stegun 7.1.14).
    """
    x = np.asarray(slope, float)
    found = np.where(np.isnan(x), x, 0.0)  # below 1 / 27.4 e^(-a^2) is 0
    near, far = x > 0.5, (x > 1 / 27.4) & (x <= 0.5)
    a = 1 / x[near]
    found[near] = np.exp(-a * a) / (2 * math.sqrt(math.pi) * a) - np.asarray(_ERFC(a), float) / 2
    a = 1 / x[far]
    r = np.zeros_like(a)
    for k in range(80, 0, -1):
        r = 0.5 * k / (a + r)
    found[far] = np.exp(-a * a) / (2 * math.sqrt(math.pi)) * r / (a * (a + r))
    return found[()]


def lambda_beckmann_slope_naive(slope):
    """Smith's Lambda of a quotient read upside down: a = m tan theta in place of 1 / (m tan theta).

    (1 - 1.259 a + 0.396 a^2) / (3.535 a + 2.181 a^2) for a < 1.6, else 0, with a = max(slope, 1e-6)

    slope (...) >= 0. Returns (...) >= 0: large where nothing blocks, and none at grazing. Errors: all of it but at
    slope 1. Source: Walter et al. 2007, the fit, misread.
    """
    a = np.maximum(np.asarray(slope, float), 1e-6)
    return np.where(a < 1.6, (1 - 1.259 * a + 0.396 * a * a) / (3.535 * a + 2.181 * a * a), 0.0)[()]


def lambda_beckmann(n_dot_v, m):
    """Smith's Lambda of a Gaussian surface: the hidden part of the facets over the seen part.

    lambda_beckmann_slope(m tan theta), tan theta = sqrt((1 - n_dot_v) (1 + n_dot_v)) / n_dot_v

    n_dot_v (...) 0 .. 1, m (...) > 0. Returns (...) >= 0. Errors: none. Source: Smith 1967; Walter et al. 2007.
    """
    return lambda_beckmann_slope(_slope(n_dot_v, m))


def lambda_ggx_slope(slope):
    """Smith's Lambda of the GGX surface, from its width times the tangent of the direction's angle.

    (sqrt(1 + slope^2) - 1) / 2 = slope^2 / (2 (1 + sqrt(1 + slope^2)))

    slope (...) >= 0: alpha tan theta. Returns (...) >= 0. Errors: none. Source: Walter et al. 2007; Heitz 2014.
    """
    x = np.asarray(slope, float)
    return 0.5 * x * (x / (1 + np.hypot(1, x)))


def lambda_ggx(n_dot_v, alpha):
    """Smith's Lambda of the GGX surface: the hidden part of the facets over the seen part.

    lambda_ggx_slope(alpha tan theta), tan theta = sqrt((1 - n_dot_v) (1 + n_dot_v)) / n_dot_v

    n_dot_v (...) 0 .. 1, alpha (...) > 0. Returns (...) >= 0. Errors: none. Source: Walter et al. 2007; Heitz 2014.
    """
    return lambda_ggx_slope(_slope(n_dot_v, alpha))


def g1_beckmann(n_dot_v, m):
    """The share of the facets of a Gaussian surface that is seen from a direction.

    1 / (1 + lambda_beckmann)

    n_dot_v (...) 0 .. 1, m (...) > 0. Returns (...) 0 .. 1. Errors: none. Source: Smith 1967.
    """
    return 1 / (1 + lambda_beckmann(n_dot_v, m))


def g1_ggx(n_dot_v, alpha):
    """The share of the facets of a GGX surface that is seen from a direction.

    1 / (1 + lambda_ggx)

    n_dot_v (...) 0 .. 1, alpha (...) > 0. Returns (...) 0 .. 1. Errors: none. Source: Walter et al. 2007.
    """
    return 1 / (1 + lambda_ggx(n_dot_v, alpha))


def g1_beckmann_rational(n_dot_v, m):
    """The usual quick fit of g1_beckmann.

    (3.535 a + 2.181 a^2) / (1 + 2.276 a + 2.577 a^2), a = 1 / (m tan theta); 1 from a = 1.6 on

    n_dot_v (...) 0 .. 1, m (...) > 0. Returns (...) 0 .. 1.00006. Errors: a fit, off by up to .0031 (a = 1.34); it
    passes 1 just below a = 1.6. Source: Walter et al. 2007, equation 27.
    """
    x = _slope(n_dot_v, m)  # above and below divided by a^2
    return np.where(1.6 * x <= 1, 1.0, (3.535 * x + 2.181) / (x * (x + 2.276) + 2.577))[()]


def g_smith_separable(n_dot_v, n_dot_l, m):
    """Smith's geometry term as if being lit and being seen had nothing to do with each other.

    g1_beckmann(n_dot_v) g1_beckmann(n_dot_l)

    n_dot_v, n_dot_l (...) 0 .. 1, m (...) > 0. Returns (...) 0 .. 1. Errors: too little; high facets are both.
    Source: Smith 1967; Walter et al. 2007.
    """
    return g1_beckmann(n_dot_v, m) * g1_beckmann(n_dot_l, m)


def g_smith_correlated(n_dot_v, n_dot_l, m):
    """Smith's geometry term in which a facet that lies high is both lit and seen more often.

    1 / (1 + lambda_beckmann(n_dot_v) + lambda_beckmann(n_dot_l))

    n_dot_v, n_dot_l (...) 0 .. 1, m (...) > 0. Returns (...) 0 .. 1. Errors: none. Source: Heitz 2014.
    """
    return 1 / (1 + lambda_beckmann(n_dot_v, m) + lambda_beckmann(n_dot_l, m))


def g_smith_separable_ggx(n_dot_v, n_dot_l, alpha):
    """g_smith_separable of the GGX surface.

    g1_ggx(n_dot_v) g1_ggx(n_dot_l)

    n_dot_v, n_dot_l (...) 0 .. 1, alpha (...) > 0. Returns (...) 0 .. 1. Errors: as g_smith_separable.
    Source: Walter et al. 2007.
    """
    return g1_ggx(n_dot_v, alpha) * g1_ggx(n_dot_l, alpha)


def g_smith_correlated_ggx(n_dot_v, n_dot_l, alpha):
    """g_smith_correlated of the GGX surface.

    1 / (1 + lambda_ggx(n_dot_v) + lambda_ggx(n_dot_l))

    n_dot_v, n_dot_l (...) 0 .. 1, alpha (...) > 0. Returns (...) 0 .. 1. Errors: none. Source: Heitz 2014.
    """
    return 1 / (1 + lambda_ggx(n_dot_v, alpha) + lambda_ggx(n_dot_l, alpha))
