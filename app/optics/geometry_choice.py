"""The same surface with a geometry term of one's choice: 0 none, 1 V-groove, 2 Smith separable, 3 Smith correlated.

`m` is the RMS slope of Beckmann's facets; a number of another term is none of the others', and counts as 3.
"""

import numpy as np

from app.optics.beckmann import d_beckmann
from app.optics.cook_torrance import albedo_cook_torrance
from app.optics.fresnel import f_schlick
from app.optics.geometry_term import half_cosines
from app.optics.smith import g_smith_correlated, g_smith_separable
from app.optics.vgroove import g_vgroove
from app.optics.weak_furnace import albedo_smith, albedo_without_g


def geometry_term(n_dot_h, n_dot_v, n_dot_l, l_dot_h, m, geometry):
    """The share of the facets that is lit and seen, by the chosen geometry term.

    1, g_vgroove, g_smith_separable or g_smith_correlated

    n_dot_h, n_dot_v, n_dot_l, l_dot_h (...) 0 .. 1, m (...) > 0, geometry (...) 0 .. 3. Returns (...) 0 .. 1.
    Errors: those of the term. Source: Torrance & Sparrow 1967; Smith 1967; Heitz 2014.
    """
    cosines = np.broadcast_arrays(*(np.asarray(x, float) for x in (n_dot_h, n_dot_v, n_dot_l, l_dot_h, m)))
    which = np.broadcast_to(np.asarray(geometry), np.broadcast_shapes(np.shape(geometry), cosines[0].shape))
    _, n_dot_v, n_dot_l, _, m = cosines
    terms = {0: lambda: np.ones_like(m), 1: lambda: g_vgroove(*cosines[:4]),
             2: lambda: g_smith_separable(n_dot_v, n_dot_l, m), 3: lambda: g_smith_correlated(n_dot_v, n_dot_l, m)}
    which = np.where(np.isin(which, range(3)), which, 3)
    found = np.zeros(which.shape)
    for k in np.unique(which):  # only those that are asked for: Smith's terms take long
        found = np.where(which == k, terms[int(k)](), found)
    return found[()]


def geometry_at(theta_l, theta_v, phi, m, geometry):
    """The share of the facets that is lit and seen, at angles.

    geometry_term of half_cosines

    theta_l, theta_v, phi (...) rad, phi = pi on the mirror's side, m (...) > 0, geometry (...) 0 .. 3.
    Returns (...) 0 .. 1. Errors: those of the term. Source: as geometry_term.
    """
    c = half_cosines(theta_l, theta_v, phi)
    return geometry_term(c[..., 0], c[..., 1], c[..., 2], c[..., 3], m, geometry)


def brdf_geometry(n, l, v, m, f0, geometry):
    """The Cook-Torrance BRDF with the chosen geometry term.

    D G F / (4 n.l n.v), D Beckmann's, F Schlick's; 0 unless n.l > 0 and n.v > 0

    n, l, v (..., 3) unit, m (...) RMS slope, f0 (...) share mirrored head-on, geometry (...) 0 .. 3.
    Returns (...) 1/sr; without G it passes every bound at grazing. Errors: none.
    Source: deck, Geometric Term (1), with 1/4 for 1/pi.
    """
    n, l, v = (np.asarray(x, float) for x in (n, l, v))
    s = l + v
    size = np.sqrt(np.sum(s * s, -1))
    n_dot_l, n_dot_v, n_dot_s = np.sum(n * l, -1), np.sum(n * v, -1), np.sum(n * s, -1)
    lit = np.minimum(n_dot_l, n_dot_v) > 0
    size = np.where(lit, size, 1)
    g = geometry_term(n_dot_s / size, n_dot_v, n_dot_l, 0.5 * size, m, geometry)
    below = np.where(lit, n_dot_l * n_dot_v, 1)
    return np.where(lit, d_beckmann(n, s, m) * g / (4 * below) * f_schlick(0.5 * size, f0), 0.0)[()]


def albedo_geometry(theta_v, m, geometry):
    """The share of the light that comes back when every facet mirrors all, by the chosen geometry term.

    int D G / (4 n.l n.v) n.l dw_l: albedo_without_g, albedo_cook_torrance with f0 = 1, or albedo_smith

    theta_v (...) rad, m (...) > 0, geometry (...) 0 .. 3. Returns (...); without G above 1 at grazing.
    Errors: below 1e-5. Source: derived for this course; Heitz 2014.
    """
    theta_v, m, geometry = np.broadcast_arrays(*(np.asarray(x, float) for x in (theta_v, m, geometry)))
    kinds = [lambda: albedo_without_g(theta_v, m), lambda: albedo_cook_torrance(theta_v, m, 1.0),
             lambda: albedo_smith(theta_v, m, 2), lambda: albedo_smith(theta_v, m, 3)]
    value = np.zeros(theta_v.shape)
    for k, albedo in enumerate(kinds):
        if np.any(geometry == k):
            value = np.where(geometry == k, albedo(), value)
    return value[()]
