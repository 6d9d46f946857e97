"""Rough mirrors beyond the deck: Smith's geometry term with lit and seen heights correlated, under Beckmann and GGX."""

import numpy as np
from numpy import pi

from app.optics.beckmann import SMOOTHEST, _dot, d_beckmann
from app.optics.cook_torrance import _directions, _l_dot_h
from app.optics.fresnel import f_schlick
from app.optics.ggx import d_ggx
from app.optics.smith import lambda_beckmann, lambda_ggx, lambda_ggx_slope
from app.quadrature import gauss_legendre

_NODES, _WEIGHTS = gauss_legendre(40)


def _correlated(n, l, v, d, hidden, width):
    """D G / (4 n.l n.v), G = 1 / (1 + Lambda_l + Lambda_v)."""
    n_dot_l, n_dot_v = _dot(n, l), _dot(n, v)
    lit = np.minimum(n_dot_l, n_dot_v) > 0
    n_dot_l, n_dot_v = (np.where(lit, c, 1.0) for c in (n_dot_l, n_dot_v))
    width = np.maximum(np.asarray(width, float), SMOOTHEST)
    h = np.asarray(l, float) + np.asarray(v, float)
    open_ = 1 + hidden(n_dot_l, width) + hidden(n_dot_v, width)
    return np.where(lit, d(n, h, width) / (4 * n_dot_l * open_ * n_dot_v), 0.0)[()]


def brdf_cook_torrance_smith(n, l, v, m, f0):
    """The Cook-Torrance BRDF with Smith's geometry term: heights that both the light and the eye prefer.

    D G F / (4 n.l n.v), D Beckmann, G = 1 / (1 + Lambda_l + Lambda_v), F Schlick; 0 unless n.l > 0 and n.v > 0

    n, l, v (..., 3) unit, m (...) RMS slope, f0 (...) share mirrored head-on. Returns (...) 1/sr.
    Errors: none; m below 1e-5 is taken as 1e-5. Source: Heitz 2014, Understanding the Masking-Shadowing Function.
    """
    return _correlated(n, l, v, d_beckmann, lambda_beckmann, m) * f_schlick(_l_dot_h(l, v), f0)


def brdf_ggx(n, l, v, alpha, f0):
    """The BRDF of facets of the distribution GGX with Smith's geometry term, as renderers have it today.

    D G F / (4 n.l n.v), G = 1 / (1 + Lambda_l + Lambda_v), F Schlick; 0 unless n.l > 0 and n.v > 0

    n, l, v (..., 3) unit, alpha (...) width, f0 (...) share mirrored head-on. Returns (...) 1/sr.
    Errors: none; alpha below 1e-5 is taken as 1e-5. Source: Walter et al. 2007; Heitz 2014.
    """
    return _correlated(n, l, v, d_ggx, lambda_ggx, alpha) * f_schlick(_l_dot_h(l, v), f0)


def cook_torrance_smith_at(theta_l, theta_v, phi, m, f0):
    """The Cook-Torrance BRDF with Smith's geometry term, at angles.

    brdf_cook_torrance_smith of n = +z, v = direction(theta_v, 0), l = direction(theta_l, phi)

    theta_l, theta_v, phi (...) rad, phi = pi on the mirror's side, m (...), f0 (...). Returns (...) 1/sr.
    Errors: none; m below 1e-5 is taken as 1e-5. Source: Heitz 2014.
    """
    return brdf_cook_torrance_smith(*_directions(theta_l, theta_v, phi), m, f0)


def albedo_ggx(theta_v, alpha, f0):
    """The share of the light that brdf_ggx reflects, by the eye's angle.

    int D G F u / (4 n.v) 4 dw_h over the half-vectors whose light is above the surface, u = l.h

    theta_v (...) rad below pi/2, alpha (...) from 0.01 up, f0 (...). Returns (...). Errors: none; 1e-14 for
    alpha >= 0.1. Source: Gauss-Legendre over tan a / alpha, in pieces, and over the azimuth up to the horizon.
    """
    shape = np.broadcast_shapes(*map(np.shape, (theta_v, alpha, f0)))
    t, alpha, f0 = (np.broadcast_to(np.asarray(x, float), shape)[..., None, None, None] for x in (theta_v, alpha, f0))
    alpha, n_dot_v = np.maximum(alpha, SMOOTHEST), np.maximum(np.cos(t), 1e-7)
    bends = [np.tan(np.maximum(0.25 * pi + side * t / 2, 0)) / alpha for side in (-1, 1)]
    edges = np.sort(np.concatenate([*(np.minimum(np.full_like(t, 3.0**k), bends[1]) for k in range(-1, 9)),
                                    np.zeros_like(t), *(np.minimum(bend, 1e9) for bend in bends)], -1), -1)
    low, wide = edges[..., :-1], np.diff(edges, axis=-1)
    low, wide = (np.moveaxis(x, -1, -3) for x in (low, wide))  # pieces, tilts, azimuths
    psi, turn = 0.5 * pi * _NODES[:, None], 0.5 * pi * _NODES
    x = low + wide * np.sin(psi) ** 2
    per_tilt = 0.5 * pi * _WEIGHTS[:, None] * wide * np.sin(2 * psi)
    c = 1 / np.sqrt(1 + (alpha * x) ** 2)
    a, b = c * n_dot_v, np.maximum(alpha * x * c * np.sin(t), 1e-300)
    end = np.arccos(np.clip((0.5 * n_dot_v / c - a) / b, -1, 1))
    u = a + b * np.cos(end * np.sin(turn) ** 2)
    per_turn = 0.5 * pi * _WEIGHTS * end * np.sin(2 * turn)
    n_dot_l = np.clip(2 * u * c - n_dot_v, 1e-30, 1.0)
    g = 1 / (1 + lambda_ggx(n_dot_l, alpha) + lambda_ggx_slope(alpha * np.sin(t) / n_dot_v))
    d = 2 * x / (pi * (1 + x * x) ** 2)  # D cos a dw_h
    total = per_tilt * per_turn * d * g * np.maximum(u, 0) * f_schlick(u, f0) / (c * n_dot_v)
    return np.sum(total, (-1, -2, -3))[()]
