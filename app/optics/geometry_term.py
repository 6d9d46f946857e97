"""The geometry term at angles: theta_v and theta_l from the normal, phi from the eye's azimuth to the light's.

phi = 180 degrees is the mirror side. What vgroove and smith say of cosines, for curves, readouts and stored values.
"""

import numpy as np

from app.optics.smith import lambda_beckmann_slope, lambda_ggx_slope
from app.optics.spherical import light_and_view
from app.optics.vgroove import g_branch, g_masking, g_shadowing, g_vgroove


def _cosine(theta):
    return np.maximum(np.cos(np.asarray(theta, float)), 0.0)


def _tangent(theta):
    return np.sin(theta) / np.maximum(np.cos(np.asarray(theta, float)), 1e-30)


def half_cosines(theta_l, theta_v, phi):
    """The four cosines of the geometry term: n.h, n.v, n.l and l.h.

    S = l + v: S_z / |S|, cos theta_v, cos theta_l, |S| / 2; n.h is 1 where S = 0. No cosine is below 0.

    theta_l, theta_v, phi (...) rad. Returns (..., 4). Errors: none. Source: deck, The Blinn Model.
    """
    theta_l, theta_v, phi = np.broadcast_arrays(*(np.asarray(x, float) for x in (theta_l, theta_v, phi)))
    s = light_and_view(theta_l, theta_v, phi)
    size = np.sqrt(np.sum(s * s, -1))
    n_dot_h = np.where(size > 0, np.maximum(s[..., 2], 0) / np.where(size > 0, size, 1), 1.0)
    return np.stack([n_dot_h, _cosine(theta_v), _cosine(theta_l), 0.5 * size], -1)


def masking_at(theta_l, theta_v, phi):
    """The share of the facets towards h that the eye sees, in V-grooves.

    g_masking of half_cosines

    theta_l, theta_v, phi (...) rad. Returns (...) 0 .. 1. Errors: none. Source: deck, Geometric Term (2).
    """
    c = half_cosines(theta_l, theta_v, phi)
    return g_masking(c[..., 0], c[..., 1], c[..., 3])


def shadowing_at(theta_l, theta_v, phi):
    """The share of the facets towards h that the light reaches, in V-grooves.

    g_shadowing of half_cosines

    theta_l, theta_v, phi (...) rad. Returns (...) 0 .. 1. Errors: none. Source: deck, Geometric Term (3).
    """
    c = half_cosines(theta_l, theta_v, phi)
    return g_shadowing(c[..., 0], c[..., 2], c[..., 3])


def vgroove_at(theta_l, theta_v, phi):
    """The share of the facets towards h that is lit and seen, in V-grooves.

    g_vgroove of half_cosines

    theta_l, theta_v, phi (...) rad. Returns (...) 0 .. 1. Errors: none. Source: deck, Geometric Term (3).
    """
    c = half_cosines(theta_l, theta_v, phi)
    return g_vgroove(c[..., 0], c[..., 1], c[..., 2], c[..., 3])


def branch_at(theta_l, theta_v, phi):
    """Which term of the V-groove's minimum is the least: 0 nothing blocks, 1 masking, 2 shadowing.

    g_branch of half_cosines

    theta_l, theta_v, phi (...) rad. Returns (...) 0, 1 or 2. Errors: none. Source: deck, Geometric Term (3).
    """
    c = half_cosines(theta_l, theta_v, phi)
    return g_branch(c[..., 0], c[..., 1], c[..., 2], c[..., 3])


def crease_gap(theta_l, theta_v, phi):
    """How far the least of the three terms of the V-groove's minimum lies below the next: 0 on a crease.

    the two smallest of 1, 2 n.h n.v / l.h and 2 n.h n.l / l.h, their difference

    theta_l, theta_v, phi (...) rad. Returns (...) >= 0; where l.h = 0 it is 1. Errors: none.
    Source: deck, Geometric Term (3).
    """
    n_dot_h, n_dot_v, n_dot_l, l_dot_h = np.moveaxis(half_cosines(theta_l, theta_v, phi), -1, 0)
    towards = l_dot_h > 0
    both = 2 * n_dot_h / np.where(towards, l_dot_h, 1) * np.stack([n_dot_v, n_dot_l])
    terms = np.sort(np.concatenate([np.where(towards, both, 0), np.ones_like(both[:1])]), 0)
    return np.where(towards, terms[1] - terms[0], 1.0)[()]


def lambda_beckmann_at(theta_v, m):
    """Smith's Lambda of a Gaussian surface at an angle.

    lambda_beckmann_slope(m tan theta_v)

    theta_v (...) rad, m (...) > 0. Returns (...) >= 0. Errors: none. Source: Smith 1967.
    """
    return lambda_beckmann_slope(m * _tangent(theta_v))


def lambda_ggx_at(theta_v, alpha):
    """Smith's Lambda of a GGX surface at an angle.

    lambda_ggx_slope(alpha tan theta_v)

    theta_v (...) rad, alpha (...) > 0. Returns (...) >= 0. Errors: none. Source: Walter et al. 2007.
    """
    return lambda_ggx_slope(alpha * _tangent(theta_v))


def g1_beckmann_at(theta_v, m):
    """The share of a Gaussian surface's facets that is seen at an angle.

    1 / (1 + lambda_beckmann_at)

    theta_v (...) rad, m (...) > 0. Returns (...) 0 .. 1. Errors: none. Source: Smith 1967.
    """
    return 1 / (1 + lambda_beckmann_at(theta_v, m))


def smith_separable_at(theta_l, theta_v, m):
    """Smith's geometry term at angles, lit and seen as if independent.

    g1_beckmann_at(theta_v) g1_beckmann_at(theta_l)

    theta_l, theta_v (...) rad, m (...) > 0. Returns (...) 0 .. 1. Errors: as g_smith_separable. Source: Smith 1967.
    """
    return g1_beckmann_at(theta_v, m) * g1_beckmann_at(theta_l, m)


def smith_correlated_at(theta_l, theta_v, m):
    """Smith's geometry term at angles, with heights that both the light and the eye prefer.

    1 / (1 + lambda_beckmann_at(theta_v) + lambda_beckmann_at(theta_l))

    theta_l, theta_v (...) rad, m (...) > 0. Returns (...) 0 .. 1. Errors: none. Source: Heitz 2014.
    """
    return 1 / (1 + lambda_beckmann_at(theta_v, m) + lambda_beckmann_at(theta_l, m))
