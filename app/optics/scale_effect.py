"""The scale effect: bumps too small for a pixel belong into the roughness; slope variances add.

A bumpy mirror has facets of RMS slope `m` on bumps whose slope along either axis is normal with deviation `bump_slope`.
Seen from afar a pixel shows the mean over many bumps. The lamp stands where the ball as a whole mirrors it (h = n),
and a bump with the slope s then shows D of the angle atan s. All bumps count as large as they look from above.
"""

import numpy as np
from numpy import pi

from app.optics.beckmann import SMOOTHEST, d_beckmann_slope, exponent_from_m
from app.optics.facets import facet_normal
from app.optics.ndf import d_blinn_phong_slope
from app.quadrature import gauss_legendre

PIXELS = 600.0  # across the ball, where a formula needs to know
_NODES, _WEIGHTS = gauss_legendre(24)


def _variances(m, bump_slope):
    """m^2 of the facets and 2 sigma^2 of the bumps: mean squares of slopes."""
    return np.maximum(np.asarray(m, float), SMOOTHEST) ** 2, 2 * np.asarray(bump_slope, float) ** 2


def m_effective(m, bump_slope):
    """The roughness of a bumpy surface whose bumps are too small to be seen.

    sqrt(m^2 + 2 sigma^2)

    m (...) RMS slope of the facets, bump_slope sigma (...) of the bumps along one axis. Returns (...). Errors: none.
    Source: Olano and Baker 2010, LEAN Mapping; deck, Plausible Shading - The Scale Effect.
    """
    return np.hypot(np.asarray(m, float), np.sqrt(2) * np.asarray(bump_slope, float))


def bump_kept(bumps):
    """The share of its slope that a bump still shows when pixels average over it; the ball is 600 pixels wide.

    e^(-(pi p)^2 / 6), p = bumps / 600 per pixel: a wave, seen through a Gaussian as wide as a square pixel

    bumps (...) side by side across the ball. Returns (...) 0 .. 1. Errors: a square pixel itself has sin(pi p) / pi p.
    Source: the Fourier transform of a Gaussian of variance 1/12 of a pixel.
    """
    return np.exp(-((pi * np.asarray(bumps, float) / PIXELS) ** 2) / 6)


def m_pixel(m, bump_slope, bumps):
    """The roughness that a pixel must use: the part of the bumps it shows stays a normal, the rest is roughness.

    sqrt(m^2 + 2 sigma^2 (1 - k^2)), k = bump_kept(bumps)

    m (...), bump_slope sigma (...), bumps (...) across a ball 600 pixels wide. Returns (...). Errors: none.
    Source: Olano and Baker 2010, LEAN Mapping; slope variances add.
    """
    return m_effective(m, bump_slope * np.sqrt(-np.expm1(-((pi * np.asarray(bumps, float) / PIXELS) ** 2) / 3)))


def _narrowed(m, bump_slope):
    """m^2 + S and q = m^2 S / (m^2 + S), S = 2 sigma^2: the mean square slope of the bumps that D still lights."""
    facets, slopes = _variances(m, bump_slope)
    return facets + slopes, facets / (facets + slopes) * slopes


def d_bumps(m, bump_slope):
    """The peak of the highlight of a bumpy mirror seen from afar: D, averaged over all bumps.

    int_0^inf D(t) e^(-t / S) dt / S = (1 + 2 q + 2 q^2) / (pi (m^2 + S)), t = tan^2 a, S = 2 sigma^2,
    q = m^2 S / (m^2 + S)

    m (...), bump_slope sigma (...). Returns (...) 1/sr. Errors: none; m below 1e-5 is taken as 1e-5.
    Source: derived for this course: a polynomial times an exponential.
    """
    both, q = _narrowed(m, bump_slope)
    return (1 + 2 * q * (1 + q)) / (pi * both)


def d_bumps_counted(theta_h, m, bump_slope, facets):
    """The highlight of a bumpy mirror seen from afar, by counting: the mean of D over that many bumps.

    mean over i of D(angle of facet_normal(i, sqrt(2) sigma, facets) with h), h at theta_h from the ball's normal

    theta_h (...) rad, m (...), bump_slope sigma (...), facets (...) >= 1. Returns (...) 1/sr.
    Errors: about 1 / facets. Source: a count; deck, Plausible Shading - The Scale Effect.
    """
    given = np.broadcast_arrays(*(np.asarray(x, float) for x in (theta_h, m, bump_slope, facets)))
    means = []
    for angle, slope, sigma, count in zip(*(g.ravel() for g in given), strict=True):
        n = facet_normal(np.arange(int(count)), np.sqrt(2) * sigma, int(count))
        s, c = np.sin(angle), np.cos(angle)
        along = n[:, 0] * s + n[:, 2] * c
        across = (n[:, 0] * c - n[:, 2] * s) ** 2 + n[:, 1] ** 2
        d = d_beckmann_slope(across / np.where(along > 0, along, 1) ** 2, slope)
        means.append(np.mean(np.where(along > 0, d, 0)))
    return np.reshape(np.array(means), given[0].shape)[()]


def d_filtered(theta_h, m, bump_slope):
    """The same highlight by one evaluation: Beckmann's D with the roughness of facets and bumps together.

    D(tan^2 theta_h, sqrt(m^2 + 2 sigma^2))

    theta_h (...) rad, m (...), bump_slope sigma (...). Returns (...) 1/sr. Errors: relative, at the peak, filter_error.
    Source: Olano and Baker 2010, LEAN Mapping.
    """
    return d_beckmann_slope(bumps_slope2(theta_h), m_effective(m, bump_slope))


def bumps_slope2(theta_h):
    """The squared slope of a bump that mirrors the lamp, by the angle between the ball's normal and h.

    tan^2 theta_h

    theta_h (...) rad. Returns (...). Errors: none; the cosine is at least 1e-9. Source: h is the bump's normal.
    """
    theta_h = np.asarray(theta_h, float)
    return (np.sin(theta_h) / np.maximum(np.cos(theta_h), 1e-9)) ** 2


def d_unfiltered(theta_h, m):
    """The same highlight if the bumps are forgotten: Beckmann's D of the facets alone.

    D(tan^2 theta_h, m)

    theta_h (...) rad, m (...). Returns (...) 1/sr. Errors: none. Source: deck, Distribution Term (2).
    """
    return d_beckmann_slope(bumps_slope2(theta_h), m)


def normal_shortfall(bump_slope):
    """By how much the mean of the bumps' normals is shorter than 1.

    1 - int_0^inf e^(-u) / sqrt(1 + S u) du, S = 2 sigma^2, as the mean of t / (w (1 + w)), t = S u, w = sqrt(1 + t)

    bump_slope sigma (...). Returns (...) 0 .. 1. Errors: 1e-14. Source: Toksvig 2005; 24 Gauss-Legendre nodes for each
    of three pieces of x, u = x^2, up to 6.5.
    """
    slopes = 2 * np.asarray(bump_slope, float)[..., None] ** 2
    total = 0.0
    for low, high in ((0.0, 1.5), (1.5, 3.0), (3.0, 6.5)):
        x = low + (high - low) * _NODES
        t = slopes * x * x
        w = np.sqrt(1 + t)
        total = total + (high - low) * np.sum(_WEIGHTS * 2 * x * np.exp(-x * x) * t / (w * (1 + w)), -1)
    return total


def d_toksvig(theta_h, m, bump_slope):
    """The same highlight by Toksvig's rule: a cosine lobe whose exponent the mean normal's length lowers.

    (e' + 2) / (2 pi) cos^e' theta_h, e' = e L / (L + e (1 - L)), e = 2 / m^2 - 2, L = 1 - normal_shortfall(sigma)

    theta_h (...) rad, m (...) at most 1, bump_slope sigma (...). Returns (...) 1/sr. Errors: none; larger m count as 1.
    Source: Toksvig 2005, Mipmapping Normal Maps.
    """
    e, short = exponent_from_m(np.minimum(m, 1.0)), normal_shortfall(bump_slope)
    length = 1 - short
    return d_blinn_phong_slope(bumps_slope2(theta_h), e * length / (length + e * short))


def aliasing_error(m, bump_slope):
    """The error of a pixel that looks at one bump instead of all: root mean square, relative, at the peak.

    sqrt(E[D^2] / E[D]^2 - 1); E[D^2] = (1 + 4 p + 12 p^2 + 24 p^3 + 24 p^4) / (pi^2 m^2 (m^2 + 2 S)),
    p = m^2 S / (m^2 + 2 S), S = 2 sigma^2, taken apart so that nothing cancels for small bumps

    m (...), bump_slope sigma (...). Returns (...), 0 without bumps. Errors: none; m below 1e-5 is taken as 1e-5.
    Source: derived for this course, as d_bumps.
    """
    facets, slopes = _variances(m, bump_slope)
    _, q = _narrowed(m, bump_slope)
    p = facets / (facets + 2 * slopes) * slopes
    less = q / (facets + 2 * slopes) * slopes  # q - p
    mean = (1 + 2 * q * (1 + q)) ** 2
    square = 1 + p * (4 + p * (12 + p * (24 + p * 24)))
    rest = -4 * less + (12 * p * p - 8 * q * q) + (24 * p**3 - 8 * q**3) + (24 * p**4 - 4 * q**4)
    spread = slopes / facets * (slopes / (facets + 2 * slopes))
    return np.sqrt(np.maximum((spread * square + rest) / mean, 0.0))


def sampling_error(samples, m, bump_slope):
    """The error of a pixel that looks at some random bumps: root mean square, relative, at the peak.

    aliasing_error / sqrt(samples)

    samples (...) >= 1, m (...), bump_slope sigma (...). Returns (...). Errors: none.
    Source: the variance of a mean.
    """
    return aliasing_error(m, bump_slope) / np.sqrt(np.asarray(samples, float))


def filter_error(m, bump_slope):
    """What the one evaluation with m_effective misses at the peak: always a little too dark.

    1 - d_filtered(0) / d_bumps = (2 q + 2 q^2) / (1 + 2 q + 2 q^2), q = m^2 S / (m^2 + S), S = 2 sigma^2

    m (...), bump_slope sigma (...). Returns (...) 0 .. 1. Errors: none. Source: derived for this course.
    """
    _, q = _narrowed(m, bump_slope)
    more = 2 * q * (1 + q)
    return more / (1 + more)


def samples_worth(m, bump_slope):
    """How many random samples of a pixel are as good as the one evaluation with m_effective.

    (aliasing_error / filter_error)^2

    m (...), bump_slope sigma (...) > 0. Returns (...). Errors: none. Source: sampling_error = filter_error.
    """
    return (aliasing_error(m, bump_slope) / filter_error(m, bump_slope)) ** 2
