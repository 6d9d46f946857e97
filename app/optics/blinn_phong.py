"""The Blinn model: a highlight around the normal, in the angle of the halfway vector h; as printed and as a BRDF.

n, l, v are unit vectors: the normal, to the light, to the eye. A `shading_` function gives L_o / L_i, with whatever
cosines the formula was printed with; a `brdf_` function is in 1/sr, without the cosine, 0 unless n.l > 0 and n.v > 0.
"""

import numpy as np
from numpy import pi

from app.optics.distribution import _cosine_power
from app.optics.phong import _dot, _facing, _pieces, cosine_lobe, half_width_phong


def halfway(l, v):
    """The unit vector halfway between two directions; there is none between opposite ones.

    (l + v) / |l + v|; 0 for l = -v

    l, v (..., 3) unit. Returns (..., 3). Errors: none. Source: Blinn 1977; deck, The Blinn Model (2).
    """
    s = np.asarray(l, float) + np.asarray(v, float)
    size = np.sqrt(_dot(s, s))[..., None]
    return np.where(size > 0, s / np.where(size > 0, size, 1), 0.0)


def halfway_cosine(n, l, v):
    """The cosine of the angle between the normal and the vector halfway between two directions.

    n.s / |s|, s = l |v| + v |l|; 0 where s is

    n (..., 3) unit, l, v (..., 3) of any length. Returns (...) -1 .. 1. Errors: none; says little near 1, where
    lobe_blinn takes |n - h| instead. Source: Blinn 1977; deck, The Blinn Model (1).
    """
    l, v = np.asarray(l, float), np.asarray(v, float)
    s = l * np.sqrt(_dot(v, v))[..., None] + v * np.sqrt(_dot(l, l))[..., None]
    size = np.sqrt(_dot(s, s))
    return np.where(size > 0, _dot(n, s) / np.where(size > 0, size, 1), 0.0)[()]


def lobe_blinn(n, l, v, exponent):
    """The highlight of the Blinn model, 1 where the normal lies halfway between light and eye.

    (n.h)^exponent; 0 where n.h <= 0. From |n - h|^2 / 2 = 1 - n.h, which keeps its digits near the normal

    n, l, v (..., 3) unit, exponent >= 0 (...). Returns (...) 0 .. 1. Errors: none. Source: Blinn 1977; deck, The Blinn
    Model (1).
    """
    n, h = np.asarray(n, float), halfway(l, v)
    return _cosine_power(_dot(n, h), 0.5 * _dot(n - h, n - h), exponent)[()]


def lobe_blinn_naive(n, l, v, exponent):
    """lobe_blinn from n.h itself: the power of a number next to 1.

    max(0, n.h)^exponent

    n, l, v (..., 3) unit, exponent >= 0 (...). Returns (...) 0 .. 1. Errors: rounding n.h costs u times the exponent.
    Source: deck, The Blinn Model (1).
    """
    n_dot_h = _dot(n, halfway(l, v))
    return np.where(n_dot_h > 0, np.maximum(n_dot_h, 0.0) ** exponent, 0.0)[()]


def shading_blinn_phong(n, l, v, k_d, k_s, exponent):
    """The Blinn-Phong model as printed: what share of the light's L_i becomes L_o. It is no BRDF times a cosine.

    k_d n.l + k_s (n.h)^exponent where n.l > 0, else 0

    n, l, v (..., 3) unit, k_d, k_s, exponent (...). Returns (...) L_o / L_i. Errors: none. Source: Blinn 1977; deck,
    The Blinn Model (1).
    """
    n_dot_l = _dot(n, l)
    return np.where(n_dot_l > 0, k_d * n_dot_l + k_s * lobe_blinn(n, l, v, exponent), 0.0)[()]


def brdf_blinn_phong_printed(n, l, v, k_d, k_s, exponent):
    """The BRDF that the printed model amounts to: unbounded at the horizon, not reciprocal, its k_d without 1/pi.

    shading_blinn_phong / n.l = k_d + k_s (n.h)^exponent / n.l

    n, l, v (..., 3) unit, k_d, k_s, exponent (...). Returns (...) 1/sr; grows without end as n.l goes to 0. Errors:
    none. Source: deck, Is the Phong-Blinn Model Realistic?
    """
    n_dot_l = np.where(_facing(n, l, v), _dot(n, l), np.inf)
    return np.where(np.isinf(n_dot_l), 0.0, k_d + k_s * lobe_blinn(n, l, v, exponent) / n_dot_l)[()]


def normalisation_blinn_phong(exponent):
    """The factor f_n that makes a Blinn highlight give back all the light, seen along the normal.

    1 / int (n.h)^e n.l dw_l at v = n = (e + 2)(e + 4) / (8 pi (e + 2^(-e/2))), e = exponent

    exponent >= 0 (...). Returns (...) 1/sr. Errors: none; it is exact at v = n, elsewhere the highlight gives back
    less. Source: deck, Blinn-Phong BRDF (1).
    """
    e = np.asarray(exponent, float)
    return (e + 2) * (e + 4) / (8 * pi * (e + np.exp2(-0.5 * e)))


def normalisation_short(exponent, summand):
    """The short cuts for normalisation_blinn_phong that programs take.

    (exponent + summand) / (8 pi); summands in use: 8, 6, 2

    exponent >= 0, summand (...). Returns (...) 1/sr. Errors: against the exact factor at exponents 1, 10, 100: 8 gives
    +2.4, +7.5, +1.8 %, 6 gives -20, -4.5, -0.1 %, 2 gives -66, -28, -3.8 %. Source: Akenine-Moller et al. 2008,
    Real-Time Rendering (8); Giesen 2009, Derivation of Phong and Blinn-Phong BRDF normalization factors.
    """
    return (np.asarray(exponent, float) + summand) / (8 * pi)


def normalisation_short_share(exponent, summand):
    """What comes back along the normal with a short cut, k_s = 1: its factor over the exact one.

    normalisation_short / normalisation_blinn_phong

    exponent >= 0, summand (...). Returns (...); beyond 1 energy is made. Errors: none. Source: see normalisation_short.
    """
    return normalisation_short(exponent, summand) / normalisation_blinn_phong(exponent)


def brdf_blinn_phong(n, l, v, k_d, k_s, exponent):
    """The complete Blinn-Phong BRDF: reciprocal, and with k_d + k_s <= 1 it gives back no more than it gets.

    k_d / pi + k_s (e + 2)(e + 4) / (8 pi (e + 2^(-e/2))) (n.h)^e, e = exponent

    n, l, v (..., 3) unit, k_d, k_s, exponent (...). Returns (...) 1/sr. Errors: none. Source: deck, Blinn-Phong
    BRDF (2).
    """
    lobe = normalisation_blinn_phong(exponent) * lobe_blinn(n, l, v, exponent)
    return np.where(_facing(n, l, v), k_d / pi + k_s * lobe, 0.0)[()]


def _flux(theta_v, exponent, sign):
    """lobe_flux_blinn for sign -1; for 1 the sum of the sizes of its terms."""
    theta, e = np.broadcast_arrays(np.asarray(theta_v, float), np.asarray(exponent, float))
    top = (0.25 * pi + 0.5 * theta)[..., None]
    edge, wide = np.abs(0.5 * pi - top), 1 / np.sqrt(e[..., None] + 2)
    ends = [0 * top, edge, np.array([1, 3, 6, 10]) * wide, top - np.array([30, 4, 0]) * edge]
    a, w = _pieces(np.clip(np.concatenate(ends, -1), 0, top))
    theta, e = theta[..., None], e[..., None]
    n_dot_v = np.cos(theta)
    big_a, big_b = n_dot_v * np.cos(a), np.sin(theta) * np.sin(a)
    inner = np.clip((n_dot_v / (2 * np.cos(a)) - big_a) / np.where(big_b > 0, big_b, 1e-300), -1, 1)
    turned, sine = np.arccos(inner), np.sqrt((1 - inner) * (1 + inner))
    i1 = big_a * turned + big_b * sine
    i2 = big_a * (i1 + big_b * sine) + 0.5 * big_b * big_b * (turned + sine * inner)
    return np.sum(w * 8 * np.sin(a) * cosine_lobe(a, e) * (2 * np.cos(a) * i2 + sign * n_dot_v * i1), -1)


def lobe_flux_blinn(theta_v, exponent):
    """The flux under a Blinn highlight of height 1: over all l, together with the cosine.

    int (n.h)^e n.l dw_l = int 8 sin a cos^e a (2 cos a I2 - n.v I1) da, a = angle of h in [0, (pi/2 + theta_v) / 2],
    A = cos a cos theta_v, B = sin a sin theta_v, u = A + B cos phi = l.h: I1, I2 = int u, u^2 dphi from 0 to phi_0,
    where u = n.v / (2 cos a), the light on the horizon

    theta_v (...) rad, 0 .. pi/2, exponent >= 0 (...). Returns (...) sr. Errors: about 1e-13. Source: l.h dw_h =
    dw_l / 4 (Torrance and Sparrow 1967), the azimuth in closed form, Gauss-Legendre in a.
    """
    return _flux(theta_v, exponent, -1)


def albedo_blinn_phong(theta_v, exponent):
    """The share of the light that the Blinn-Phong BRDF with k_d = 0, k_s = 1 gives back: 1 only at the normal.

    normalisation_blinn_phong lobe_flux_blinn; for large exponents cos^2 theta_v

    theta_v (...) rad, 0 .. pi/2, exponent >= 0 (...). Returns (...) 0 .. 1. Errors: about 1e-13.
    Source: deck, Blinn-Phong BRDF (1) and The Importance of Being Normalized (1).
    """
    return normalisation_blinn_phong(exponent) * lobe_flux_blinn(theta_v, exponent)


def albedo_blinn_phong_limit(theta_v):
    """albedo_blinn_phong for an exponent without end.

    cos^2 theta_v

    theta_v (...) rad. Returns (...) 0 .. 1. Errors: none. Source: lobe_flux_blinn with all h at n: n.l and l.h are n.v.
    """
    return np.cos(np.asarray(theta_v, float)) ** 2


def brdf_blinn_phong_as_wide(n, l, v, k_d, k_s, exponent):
    """The Blinn-Phong BRDF whose highlight is as wide, in the plane of incidence, as the Phong one's of this exponent.

    brdf_blinn_phong with blinn_exponent(exponent)

    n, l, v (..., 3) unit, k_d, k_s, exponent (...). Returns (...) 1/sr. Errors: none. Source: deck, Blinn-Phong
    BRDF (2); Fisher and Woo 1994.
    """
    return brdf_blinn_phong(n, l, v, k_d, k_s, blinn_exponent(exponent))


def half_width_blinn(exponent):
    """How far from the mirror direction a Blinn highlight has half its height, in the plane of incidence.

    2 arccos 2^(-1 / exponent): the halfway vector turns half as far as the eye

    exponent >= 0 (...). Returns (...) rad. Errors: none. Source: Fisher and Woo 1994, R.E versus N.H specular
    highlights.
    """
    return 2 * half_width_phong(exponent)


def blinn_exponent(exponent):
    """The Blinn exponent whose highlight is as wide, in the plane of incidence, as the Phong one's of this exponent.

    half_width_blinn(e) = half_width_phong(exponent): e = 2 log 2 / -log((1 + 2^(-1 / exponent)) / 2), about 4 exponent

    exponent >= 0 (...). Returns (...). Errors: none; 4 times the exponent plus log 2 for large ones.
    Source: Fisher and Woo 1994, R.E versus N.H specular highlights.
    """
    below = -np.expm1(-np.log(2) / np.maximum(np.asarray(exponent, float), 1e-300))
    return 2 * np.log(2) / -np.log1p(-0.5 * below)


def blinn_exponent_short(exponent):
    """The rule of thumb for blinn_exponent.

    4 exponent

    exponent >= 0 (...). Returns (...). Errors: too small by log 2 for large exponents: -17 % at 1, -1.7 % at 10.
    Source: Fisher and Woo 1994, R.E versus N.H specular highlights.
    """
    return 4 * np.asarray(exponent, float)


def highlight_stretch(theta_v):
    """How many times longer than wide a tight Blinn highlight is, seen at the mirror angle; a Phong highlight is round.

    1 / cos theta_v: in the plane of incidence h turns half as far as the eye, across it 1 / (2 cos theta_v) times

    theta_v (...) rad, 0 .. pi/2. Returns (...) >= 1. Errors: the limit of large exponents. Source: Ngan, Durand and
    Matusik 2005, Experimental analysis of BRDF models.
    """
    return 1 / np.cos(np.asarray(theta_v, float))


def sample_blinn_phong(xi_1, xi_2, exponent):
    """A facet normal drawn from the cosine lobe, n being +z: as likely as its share of the area, D cos a.

    log n.h = log(1 - xi_1) / (e + 2), azimuth 2 pi xi_2, e = exponent

    xi_1, xi_2 (...) in [0, 1), exponent >= 0 (...). Returns (..., 3). Errors: none; xi_1 = 1 is taken as just below it.
    Source: Walter 2005, Notes on the Ward BRDF; the inverse of 1 - (n.h)^(e + 2).
    """
    log = np.log1p(-np.minimum(xi_1, 1 - 2.0**-24)) / (np.asarray(exponent, float) + 2)
    turn = 2 * pi * np.asarray(xi_2, float)
    cosine, sine, turn = np.broadcast_arrays(np.exp(log), np.sqrt(-np.expm1(2 * log)), turn)
    return np.stack([sine * np.cos(turn), sine * np.sin(turn), cosine], -1)


def pdf_blinn_phong(n, l, v, exponent):
    """The density of the light that v sees mirrored in a facet of sample_blinn_phong.

    (e + 2) / (2 pi) (n.h)^(e + 1) / (4 l.h); 0 where n.h <= 0

    n, l, v (..., 3) unit, exponent >= 0 (...). Returns (...) 1/sr. Errors: none. Source: Walter 2005, Notes on the Ward
    BRDF.
    """
    h, e = halfway(l, v), np.asarray(exponent, float)
    l_dot_h = _dot(l, h)
    value = (e + 2) / (2 * pi) * lobe_blinn(n, l, v, e + 1) / (4 * np.where(l_dot_h > 0, l_dot_h, 1))
    return np.where(l_dot_h > 0, value, 0.0)[()]
