"""The deck's three formulas of the geometry term in one groove, seen along it: leans are angles from n in that plane.

`facet` is the lean of the facet's normal, which is h.
"""

import numpy as np

from app.optics.vgroove import g_masking


def _cosines(facet, lean):
    return np.cos(facet), np.cos(lean), np.cos(np.asarray(facet, float) - lean)


def groove_masking(facet, lean_v):
    """The share of a facet that the eye sees, by the formula of masking.

    g_masking(cos facet, cos lean_v, cos(facet - lean_v))

    facet, lean_v (...) rad. Returns (...) 0 .. 1. Errors: none. Source: deck, Geometric Term (2).
    """
    return g_masking(*_cosines(facet, lean_v))


def groove_intercept_printed(facet, lean_v):
    """G_intercept as the deck prints it by itself: above 1 where nothing is hidden.

    2 cos facet cos lean_v / cos(facet - lean_v); 0 for an eye behind the facet

    facet, lean_v (...) rad. Returns (...) >= 0. Errors: none. Source: deck, Geometric Term (2).
    """
    n_dot_h, n_dot_v, v_dot_h = _cosines(facet, lean_v)
    facing = v_dot_h > 0
    return np.where(facing, 2 * n_dot_h * n_dot_v / np.where(facing, v_dot_h, 1), 0.0)[()]


def groove_shadowing(facet, lean_l):
    """The share of a facet that the light reaches, by the formula of shadowing: groove_masking of the light's lean.

    g_masking(cos facet, cos lean_l, cos(facet - lean_l))

    facet, lean_l (...) rad. Returns (...) 0 .. 1. Errors: none. Source: deck, Geometric Term (3).
    """
    return g_masking(*_cosines(facet, lean_l))
