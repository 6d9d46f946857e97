"""What blocks light in a V-groove: masking before the eye, shadowing from the light, and the smaller of the two shares.

A facet of normal h is one side of a symmetric groove; the other side stands in the way. All arguments are cosines.
"""

import numpy as np


def _shares(n_dot_h, *cosines, l_dot_h):
    """The products of the formula, none below 0, and l_dot_h: arrays of one shape."""
    arrays = np.broadcast_arrays(*(np.maximum(np.asarray(x, float), 0) for x in (n_dot_h, *cosines, l_dot_h)))
    return [2 * arrays[0] * x for x in arrays[1:-1]], arrays[-1]


def _least(shares, l_dot_h):
    least = np.minimum.reduce([l_dot_h, *shares])
    return np.where(l_dot_h > 0, least / np.where(l_dot_h > 0, l_dot_h, 1), 0.0)[()]


def g_masking(n_dot_h, n_dot_v, l_dot_h):
    """The share of a facet that the eye sees past the other side of its groove: G_intercept, at most 1.

    min(1, 2 n_dot_h n_dot_v / l_dot_h), in which l_dot_h = v.h

    n_dot_h, n_dot_v, l_dot_h (...) 0 .. 1. Returns (...) 0 .. 1; 0 where l_dot_h = 0. Errors: none.
    Source: Torrance & Sparrow 1967; deck, Geometric Term (2).
    """
    return _least(*_shares(n_dot_h, n_dot_v, l_dot_h=l_dot_h))


def g_shadowing(n_dot_h, n_dot_l, l_dot_h):
    """The share of a facet that the light reaches past the other side of its groove: G_shadow, at most 1.

    min(1, 2 n_dot_h n_dot_l / l_dot_h): masking with the light in the eye's place

    n_dot_h, n_dot_l, l_dot_h (...) 0 .. 1. Returns (...) 0 .. 1; 0 where l_dot_h = 0. Errors: none.
    Source: Torrance & Sparrow 1967; deck, Geometric Term (3).
    """
    return _least(*_shares(n_dot_h, n_dot_l, l_dot_h=l_dot_h))


def g_vgroove(n_dot_h, n_dot_v, n_dot_l, l_dot_h):
    """The share of a facet that is both lit and seen: the geometry term of the Cook-Torrance model.

    min(1, 2 n_dot_h n_dot_v / l_dot_h, 2 n_dot_h n_dot_l / l_dot_h)
    = min(l_dot_h, 2 n_dot_h n_dot_v, 2 n_dot_h n_dot_l) / l_dot_h

    n_dot_h, n_dot_v, n_dot_l, l_dot_h (...) 0 .. 1. Returns (...) 0 .. 1; 0 where l_dot_h = 0. Errors: none.
    Source: Torrance & Sparrow 1967; Blinn 1977; deck, Geometric Term (3).
    """
    return _least(*_shares(n_dot_h, n_dot_v, n_dot_l, l_dot_h=l_dot_h))


def g_branch(n_dot_h, n_dot_v, n_dot_l, l_dot_h):
    """Which of the three terms is the least: 0 nothing blocks, 1 masking, 2 shadowing.

    0 where l_dot_h <= both products; else 1 where n_dot_v <= n_dot_l, 2 where not

    n_dot_h, n_dot_v, n_dot_l, l_dot_h (...) 0 .. 1. Returns (...) 0, 1 or 2. Errors: none.
    Source: deck, Geometric Term (3).
    """
    (masking, shadowing), l_dot_h = _shares(n_dot_h, n_dot_v, n_dot_l, l_dot_h=l_dot_h)
    return np.where(l_dot_h <= np.minimum(masking, shadowing), 0.0, np.where(masking <= shadowing, 1.0, 2.0))[()]
