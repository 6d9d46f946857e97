"""Does a geometry term lose light, or make some? Sums over all facets of a Beckmann surface that mirrors everything.

A facet tilted by a has the share D cos a dw_h of the plate's area; x = tan a / m, so that D cos a sin a da dphi is
2 x e^(-x^2) dx dphi / 2 pi. `geometry`: 0 none, 1 V-groove, 2 Smith separable, 3 Smith correlated. An angle theta_v
whose cosine is below 1e-7 counts as one with 1e-7.
"""

import numpy as np
from numpy import pi

from app.optics.smith import g1_beckmann_rational, g_smith_correlated, g_smith_separable, lambda_beckmann_slope
from app.quadrature import gauss_legendre

_NODES, _WEIGHTS = gauss_legendre(12)
_LEAST = 1e-7


def capped_tangent(theta):
    """The tangent of an angle whose cosine is at least 1e-7.

    sin theta / max(1e-7, cos theta)

    theta (...) rad. Returns (...). Errors: none. Source: trigonometry.
    """
    return np.sin(theta) / np.maximum(np.cos(np.asarray(theta, float)), _LEAST)


def _tilts(bend, end):
    """Nodes x and weights (..., 72) of int .. dx from 0 to the end, at most 6.5, cut at 1.5, 3 and the bend."""
    bend, end = (np.asarray(x, float)[..., None] for x in np.broadcast_arrays(bend, end))
    edges = np.array([0.0, 0.0, 1.5, 1.5, 3.0, 3.0, 6.5])
    edges = edges + np.zeros_like(bend)
    for k in (1, 3, 5):
        edges[..., k] = np.clip(bend[..., 0], edges[..., k - 1], edges[..., k + 1])
    edges = np.minimum(edges, end)
    low, wide = edges[..., :-1, None], np.diff(edges)[..., None]
    psi = 0.5 * pi * _NODES
    x, weight = low + wide * np.sin(psi) ** 2, pi * wide * _WEIGHTS * np.sin(psi) * np.cos(psi)
    return x.reshape(*x.shape[:-2], -1), weight.reshape(*x.shape[:-2], -1)


def all_azimuths(steep):
    """The area that facets of one tilt show to the eye if nothing blocks, over their share of what the plate shows.

    int max(0, v.h) dphi / (2 pi cos a cos theta_v) = 1 + (sqrt(s^2 - 1) - acos(1 / s)) / pi for s > 1, else 1

    steep s (...) = tan a tan theta_v. Returns (...) >= 1. Errors: none. Source: derived for this course.
    """
    s = np.maximum(steep, 1)
    k = 1 / s
    side = np.sqrt((1 - k) * (1 + k))
    return (1 - np.arctan2(side, k) / pi + s * side / pi)[()]


def furnace_ring(theta_h, theta_v, m, geometry):
    """The area that the facets of one tilt show to the eye, over their share of the plate's area as it is seen.

    int G1 max(0, v.h) dphi / (2 pi cos theta_h cos theta_v); the whole plate shows 1. V-grooves: max(0, min(v.h,
    2 n.h n.v)) instead of G1 max(0, v.h), which makes 1 for every tilt; Smith: G1 is the same for all facets

    theta_h, theta_v (...) rad, m (...), geometry (...) 0 .. 3. Returns (...). Errors: none.
    Source: Heitz 2014, the weak white furnace; the integral over the azimuth derived for this course.
    """
    geometry = np.asarray(geometry)
    seen = 1 / (1 + lambda_beckmann_slope(m * capped_tangent(theta_v)))
    every = all_azimuths(capped_tangent(theta_h) * capped_tangent(theta_v))
    return np.where(geometry == 1, 1.0, every * np.where(geometry == 0, 1.0, seen))[()]


def weak_furnace(theta_v, m, geometry):
    """The area that all facets show to the eye over the plate's as it is seen: 1 where nothing appears or vanishes.

    int D G1 max(0, v.h) dw_h / n.v = int 2 x e^(-x^2) furnace_ring dx, x = tan theta_h / m

    theta_v (...) rad, m (...) > 0, geometry (...) 0 .. 3. Returns (...). Errors: below 1e-6; 12 Gauss-Legendre nodes
    for each piece of x between its bends. Source: Heitz 2014.
    """
    theta_v, m, geometry = np.broadcast_arrays(*(np.asarray(x, float) for x in (theta_v, m, geometry)))
    slope = m * capped_tangent(theta_v)
    x, weight = _tilts(1 / np.maximum(slope, 1e-30), 6.5)
    every = np.sum(weight * 2 * x * np.exp(-x * x) * all_azimuths(slope[..., None] * x), -1)
    groove = np.sum(weight * 2 * x * np.exp(-x * x), -1)
    return np.select([geometry == 0, geometry == 1], [every, groove], every / (1 + lambda_beckmann_slope(slope)))[()]


def weak_furnace_rational(theta_v, m):
    """The same with the usual quick fit of Smith's masking: a little light is lost, or made.

    g1_beckmann_rational weak_furnace(geometry = 0)

    theta_v (...) rad, m (...) > 0. Returns (...). Errors: below 1e-6. Source: Walter et al. 2007; Heitz 2014.
    """
    n_dot_v = np.maximum(np.cos(np.asarray(theta_v, float)), _LEAST)
    return g1_beckmann_rational(n_dot_v, m) * weak_furnace(theta_v, m, 0)


def sinking_azimuth(steep, tangent):
    """The azimuth of h from which on l is below the horizon, from 0 to pi, and its sine.

    cos phi = (steep^2 - 1) / (2 steep tangent), clamped

    steep = tan a, tangent = tan theta_v (...) >= 0. Returns (..., 2). Errors: none. Source: n.l = 2 l.h n.h - n.v.
    """
    steep, tangent = np.broadcast_arrays(np.asarray(steep, float), np.asarray(tangent, float))
    top, below = (steep - 1) * (steep + 1), 2 * steep * tangent
    k = np.clip(np.where(below > 0, top / np.where(below > 0, below, 1), np.sign(top)), -1, 1)
    side = np.sqrt((1 - k) * (1 + k))
    return np.stack([np.arctan2(side, k), side], -1)


def albedo_without_g(theta_v, m):
    """The share of the light that a Cook-Torrance surface reflects when nothing is blocked and every facet mirrors all.

    int D / (4 n.l n.v) n.l dw_l = int 2 x e^(-x^2) (phi + tan a tan theta_v sin phi) / pi dx, x = tan a / m, up to the
    azimuth at which l sinks below the horizon, cos phi = (tan^2 a - 1) / (2 tan a tan theta_v)

    theta_v (...) rad, m (...) > 0. Returns (...); far above 1 at grazing. Errors: below 1e-6. Source: derived for
    this course from the deck's Cook-Torrance model, with 1/4 for 1/pi.
    """
    theta_v, m = np.broadcast_arrays(*(np.asarray(x, float) for x in (theta_v, m)))
    t = capped_tangent(theta_v)
    first, last = _cuts(t)
    x, weight = _tilts(first / np.maximum(m, 1e-30), last / np.maximum(m, 1e-30))
    steep = m[..., None] * x
    phi, side = np.moveaxis(sinking_azimuth(steep, t[..., None]), -1, 0)
    return np.sum(weight * 2 * x * np.exp(-x * x) * (phi + steep * t[..., None] * side), -1) / pi


def _cuts(t):
    """tan(45 degrees -+ theta_v / 2): the tilts from which some, and no, azimuths mirror above the horizon."""
    half = t + np.sqrt(1 + t * t)
    return 1 / half, half


def albedo_smith(theta_v, m, geometry):
    """The share of the light that a Cook-Torrance surface with Smith's G reflects when every facet mirrors all.

    int D G / (4 n.l n.v) n.l dw_l = int 2 x e^(-x^2) / pi int G (1 + tan a tan theta_v cos phi) dphi dx, as in
    albedo_without_g, 12 nodes in phi; n.l = n.v (2 cos^2 a (1 + tan a tan theta_v cos phi) - 1)

    theta_v (...) rad, m (...) > 0, geometry (...) 3 correlated, else separable. Returns (...) 0 .. 1.
    Errors: below 1e-5. Source: Walter et al. 2007; Heitz 2014.
    """
    theta_v, m, geometry = np.broadcast_arrays(*(np.asarray(x, float) for x in (theta_v, m, geometry)))
    t = capped_tangent(theta_v)
    first, last = _cuts(t)
    x, weight = _tilts(first / np.maximum(m, 1e-30), last / np.maximum(m, 1e-30))
    steep = (m[..., None] * x)[..., None]
    phi = sinking_azimuth(steep, t[..., None, None])[..., 0]
    lit = 1 + steep * t[..., None, None] * np.cos(phi * _NODES)
    n_dot_v = np.maximum(np.cos(theta_v), _LEAST)[..., None, None]
    n_dot_l = np.clip(n_dot_v * (2 * lit / (1 + steep * steep) - 1), 0, 1)
    both = np.broadcast_arrays(n_dot_v, n_dot_l, m[..., None, None])
    g = np.where(geometry[..., None, None] == 3, g_smith_correlated(*both), g_smith_separable(*both))
    inner = np.sum(phi * _WEIGHTS * g * lit, -1)
    return np.sum(weight * 2 * x * np.exp(-x * x) * inner, -1) / pi
