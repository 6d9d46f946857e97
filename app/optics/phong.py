"""The Phong model: a highlight around the mirror direction r, as printed in 1975 and as a BRDF.

n, l, v are unit vectors: the normal, to the light, to the eye; exponent is the tightness of the highlight. A `shading_`
function gives L_o / L_i, with whatever cosines the formula was printed with; a `brdf_` function is in 1/sr, without the
cosine, and 0 unless n.l > 0 and n.v > 0.
"""

import numpy as np
from numpy import pi

from app.optics.distribution import _cosine_power
from app.quadrature import gauss_legendre

_U, _W = gauss_legendre(32)
_TURN = 0.5 * pi * _U  # psi in [0, pi/2]; sin^2 psi crowds the nodes at both ends
_AT, _WEIGHT = np.sin(_TURN) ** 2, _W * np.sin(2 * _TURN)
_WEIGHT /= np.sum(_WEIGHT)


def _dot(a, b):
    a, b = np.asarray(a, float), np.asarray(b, float)  # three sums are faster than np.sum over so short an axis
    return a[..., 0] * b[..., 0] + a[..., 1] * b[..., 1] + a[..., 2] * b[..., 2]


def _pieces(ends):
    """Nodes and weights (..., pieces * 32) between the ends (..., pieces + 1)."""
    ends = np.sort(ends, -1)
    low, size = ends[..., :-1, None], np.diff(ends)[..., None]
    x, w = low + size * _AT, size * _WEIGHT
    return x.reshape(*x.shape[:-2], -1), w.reshape(*w.shape[:-2], -1)


def _facing(n, l, v):
    return (_dot(n, l) > 0) & (_dot(n, v) > 0)


def reflection_vector(n, l):
    """The mirror direction of the light: l and r make the same angle with n, in one plane.

    r = 2 n (n.l) - l

    n, l (..., 3) unit. Returns (..., 3), unit. Errors: none. Source: deck, Phong Model: The Reflection Vector.
    """
    return 2 * _dot(n, l)[..., None] * np.asarray(n, float) - np.asarray(l, float)


def mirror_cosine(n, l, v):
    """The cosine of the angle between the mirror direction and the eye.

    r.v / (|r| |v|), r = 2 n (n.l) - l

    n (..., 3) unit, l, v (..., 3) of any length but 0. Returns (...) -1 .. 1. Errors: none; says little near 1, where
    lobe_phong takes |r - v| instead. Source: deck, The Phong Model for Specular BRDF (1).
    """
    r = reflection_vector(n, l)
    return _dot(r, v) / np.sqrt(_dot(r, r) * _dot(v, v))


def cosine_lobe(theta, exponent):
    """The shape of a highlight: a power of the cosine of an angle.

    cos^exponent theta = exp(exponent log1p(-2 sin^2(theta / 2))); 0 from 90 degrees on

    theta (...) rad, exponent >= 0 (...). Returns (...) 0 .. 1. Errors: none, to exponents of 1e7; 0 is below 1e-304.
    Source: deck, The Phong Model for Specular BRDF (3).
    """
    theta, exponent = np.asarray(theta, float), np.asarray(exponent, float)
    cosine = np.where(np.abs(theta) < 0.5 * pi, np.cos(theta), 0.0)
    return _cosine_power(cosine, 2 * np.sin(0.5 * theta) ** 2, exponent)[()]


def lobe_phong(n, l, v, exponent):
    """The highlight of the Phong model, 1 where the eye stands in the mirror direction.

    (r.v)^exponent; 0 where r.v <= 0. From |r - v|^2 / 2 = 1 - r.v, which keeps its digits near the mirror direction

    n, l, v (..., 3) unit, exponent >= 0 (...). Returns (...) 0 .. 1. Errors: none. Source: Phong 1975; deck, The Phong
    Model for Specular BRDF (1).
    """
    r, v = reflection_vector(n, l), np.asarray(v, float)
    return _cosine_power(_dot(r, v), 0.5 * _dot(r - v, r - v), exponent)[()]


def lobe_phong_naive(n, l, v, exponent):
    """lobe_phong from r.v itself: the power of a number next to 1, or of one below 0, which is none.

    (r.v)^exponent

    n, l, v (..., 3) unit, exponent >= 0 (...). Returns (...) 0 .. 1; NaN where r.v < 0, for GLSL has no power there.
    Errors: rounding r.v costs u times the exponent. Source: deck, The Phong Model for Specular BRDF (1).
    """
    r_dot_v = _dot(reflection_vector(n, l), v)
    return np.where(r_dot_v >= 0, np.maximum(r_dot_v, 0.0) ** exponent, np.nan)[()]


def shading_phong(n, l, v, k_d, k_s, exponent):
    """The Phong model as printed: what share of the light's L_i becomes L_o. It is no BRDF times a cosine.

    k_d n.l + k_s (r.v)^exponent where n.l > 0, else 0

    n, l, v (..., 3) unit, k_d, k_s, exponent (...). Returns (...) L_o / L_i. Errors: none. Source: Phong 1975; deck,
    The Phong Model for Specular BRDF (1).
    """
    n_dot_l = _dot(n, l)
    return np.where(n_dot_l > 0, k_d * n_dot_l + k_s * lobe_phong(n, l, v, exponent), 0.0)[()]


def brdf_phong_printed(n, l, v, k_d, k_s, exponent):
    """The BRDF that the printed Phong model amounts to: unbounded at the horizon, not reciprocal, k_d without 1/pi.

    shading_phong / n.l = k_d + k_s (r.v)^exponent / n.l

    n, l, v (..., 3) unit, k_d, k_s, exponent (...). Returns (...) 1/sr; grows without end as n.l goes to 0. Errors:
    none. Source: Lewis 1994, Making shaders more physically plausible; deck, The Phong Model for Specular BRDF (1).
    """
    n_dot_l = np.where(_facing(n, l, v), _dot(n, l), np.inf)
    return np.where(np.isinf(n_dot_l), 0.0, k_d + k_s * lobe_phong(n, l, v, exponent) / n_dot_l)[()]


def normalisation_phong(exponent):
    """The factor that makes a power of a cosine integrate to 1 together with one cosine more.

    1 / int cos^exponent theta cos theta dw = (exponent + 2) / (2 pi): of (r.v)^exponent at v = n, and of (n.h)^exponent
    as a distribution of facets

    exponent >= 0 (...). Returns (...) 1/sr. Errors: none. Source: Lafortune and Willems 1994, Using the modified Phong
    reflectance model; deck, Is the Phong-Blinn Model Realistic?
    """
    return (np.asarray(exponent, float) + 2) / (2 * pi)


def brdf_phong(n, l, v, k_d, k_s, exponent):
    """The Phong model as a BRDF: reciprocal, and with k_d + k_s <= 1 it gives back no more than it gets.

    k_d / pi + k_s (exponent + 2) / (2 pi) (r.v)^exponent

    n, l, v (..., 3) unit, k_d, k_s, exponent (...). Returns (...) 1/sr. Errors: none. Source: Lafortune and Willems
    1994, Using the modified Phong reflectance model.
    """
    lobe = normalisation_phong(exponent) * lobe_phong(n, l, v, exponent)
    return np.where(_facing(n, l, v), k_d / pi + k_s * lobe, 0.0)[()]


def lobe_flux_phong(theta_v, exponent):
    """The flux under a Phong highlight of height 1: over all l, together with the cosine.

    int (r.v)^exponent n.l dw_l = int 2 cos^e a sin a (A phi_0 + B sin phi_0) da over a in [0, pi/2] from v,
    A = cos theta_v cos a, B = sin theta_v sin a, cos phi_0 = -A / B cut to [-1, 1]

    theta_v (...) rad, 0 .. pi/2, exponent >= 0 (...). Returns (...) sr. Errors: about 1e-13. Source: Arvo 1995,
    Applications of irradiance tensors (there for whole exponents); the azimuth in closed form, Gauss-Legendre in a.
    """
    theta, e = np.broadcast_arrays(np.asarray(theta_v, float), np.asarray(exponent, float))
    steps = np.array([1, 3, 6, 10]) / np.sqrt(e[..., None] + 1)
    ends = [0 * theta[..., None], (0.5 * pi - theta)[..., None], steps, 0 * theta[..., None] + 0.5 * pi]
    a, w = _pieces(np.clip(np.concatenate(ends, -1), 0, 0.5 * pi))
    theta, e = theta[..., None], e[..., None]
    big_a, big_b = np.cos(theta) * np.cos(a), np.sin(theta) * np.sin(a)
    turned = np.arccos(np.clip(-big_a / np.where(big_b > 0, big_b, 1e-300), -1, 1))
    inside = big_a * turned + big_b * np.sin(turned)
    return np.sum(2 * w * cosine_lobe(a, e) * np.sin(a) * inside, -1)


def albedo_phong(theta_v, exponent):
    """The share of the light that the Phong BRDF with k_d = 0, k_s = 1 gives back: 1 only at the normal.

    normalisation_phong lobe_flux_phong; for large exponents cos theta_v

    theta_v (...) rad, 0 .. pi/2, exponent >= 0 (...). Returns (...) 0 .. 1. Errors: those of lobe_flux_phong.
    Source: Lafortune and Willems 1994.
    """
    return normalisation_phong(exponent) * lobe_flux_phong(theta_v, exponent)


def half_width_phong(exponent):
    """How far from the mirror direction a Phong highlight has half its height.

    arccos 2^(-1 / exponent), as 2 atan2(sqrt(1 - c), sqrt(1 + c)), c = 2^(-1 / exponent)

    exponent >= 0 (...). Returns (...) rad, pi/2 at 0. Errors: none. Source: the definition of a width, deck, The Phong
    Model for Specular BRDF (3).
    """
    exponent = np.asarray(exponent, float)
    below = -np.expm1(-np.log(2) / np.maximum(exponent, 1e-300))
    return 2 * np.arctan2(np.sqrt(below), np.sqrt(2 - below))
