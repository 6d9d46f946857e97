"""The Cook-Torrance BRDF: which facets mirror (D), which are not blocked (G), how much they mirror (F).

`l` and `v` are unit vectors to the light and to the eye, h = (l + v) / |l + v|. D is Beckmann's, G that of V-grooves, F
Schlick's. With s = l + v everything is a quotient of s.s and n.s = n.l + n.v, so h is never normalised and nothing is
divided by a cosine that may be small:

    G / (n.l n.v) = 1 / (high max(low, s.s / (4 n.s))), low and high being the smaller and larger of n.l and n.v
"""

import numpy as np
from numpy import pi

from app.optics.beckmann import SMOOTHEST, _dot, d_beckmann
from app.optics.fresnel import f_schlick
from app.optics.spherical import direction
from app.quadrature import gauss_legendre

_FARTHEST = 6.5  # of tan a / m: e^(-42) lies beyond


def cook_torrance_dg(n, l, v, m):
    """The Cook-Torrance BRDF of facets that mirror all: D and G without F, to be multiplied by F per channel.

    D G / (4 n.l n.v); 0 unless n.l > 0 and n.v > 0

    n, l, v (..., 3) unit, m (...) RMS slope. Returns (...) 1/sr. Errors: none; m below 1e-5 is taken as 1e-5.
    Source: deck, The Cook - Torrance Model (2), with 1/4 for 1/pi: dw_l = 4 l.h dw_h.
    """
    n_dot_l, n_dot_v = _dot(n, l), _dot(n, v)
    s = np.asarray(l, float) + np.asarray(v, float)
    low, high = np.minimum(n_dot_l, n_dot_v), np.maximum(n_dot_l, n_dot_v)
    lit = low > 0
    high = np.where(lit, high, 1)
    blocked = np.maximum(low, 0.25 * _dot(s, s) / np.where(lit, low + high, 1))
    return np.where(lit, d_beckmann(n, s, m) / (4 * high * np.where(lit, blocked, 1)), 0.0)[()]


def _l_dot_h(l, v):
    s = np.asarray(l, float) + np.asarray(v, float)
    return 0.5 * np.sqrt(_dot(s, s))


def brdf_cook_torrance(n, l, v, m, f0):
    """The Cook-Torrance BRDF, energy-consistent.

    D G F / (4 n.l n.v); 0 unless n.l > 0 and n.v > 0

    n, l, v (..., 3) unit, m (...) RMS slope, f0 (...) share mirrored head-on. Returns (...) 1/sr.
    Errors: none; m below 1e-5 is taken as 1e-5. Source: deck, The Cook - Torrance Model (2), with 1/4 for 1/pi;
    Cook and Torrance 1982.
    """
    return cook_torrance_dg(n, l, v, m) * f_schlick(_l_dot_h(l, v), f0)


def brdf_cook_torrance_printed(n, l, v, m, f0):
    """The Cook-Torrance BRDF as the deck prints it: 4 / pi = 1.27 times too much light.

    D G F / (pi n.l n.v); 0 unless n.l > 0 and n.v > 0

    n, l, v (..., 3) unit, m (...) RMS slope, f0 (...) share mirrored head-on. Returns (...) 1/sr.
    Errors: none; m below 1e-5 is taken as 1e-5. Source: deck, The Cook - Torrance Model (2).
    """
    return 4 / pi * brdf_cook_torrance(n, l, v, m, f0)


def _directions(theta_l, theta_v, phi):
    """n, l, v from angles: the eye in the xz-plane."""
    return np.array([0.0, 0.0, 1.0]), direction(theta_l, phi), direction(theta_v, 0.0)


def cook_torrance_at(theta_l, theta_v, phi, m, f0):
    """The Cook-Torrance BRDF at angles.

    brdf_cook_torrance of n = +z, v = direction(theta_v, 0), l = direction(theta_l, phi)

    theta_l, theta_v, phi (...) rad, phi = pi on the mirror's side, m (...), f0 (...). Returns (...) 1/sr.
    Errors: none; m below 1e-5 is taken as 1e-5. Source: deck, The Cook - Torrance Model (2).
    """
    return brdf_cook_torrance(*_directions(theta_l, theta_v, phi), m, f0)


def cook_torrance_printed_at(theta_l, theta_v, phi, m, f0):
    """The Cook-Torrance BRDF as printed, at angles.

    brdf_cook_torrance_printed of n = +z, v = direction(theta_v, 0), l = direction(theta_l, phi)

    theta_l, theta_v, phi (...) rad, phi = pi on the mirror's side, m (...), f0 (...). Returns (...) 1/sr.
    Errors: none; m below 1e-5 is taken as 1e-5. Source: deck, The Cook - Torrance Model (2).
    """
    return brdf_cook_torrance_printed(*_directions(theta_l, theta_v, phi), m, f0)


def _tilts(theta_v, m, count):
    """Nodes and weights of x = tan a / m from 0 to 6.5, in pieces between the tilts a at which the integrand bends."""
    nodes, weights = gauss_legendre(count)
    t, quarter = np.asarray(theta_v, float), 0.25 * pi
    bends = [quarter - t / 2, quarter + t / 2, 2 * quarter - t, t, (2 * quarter - t) / 3, (2 * quarter + t) / 3,
             np.full_like(t, quarter)]
    with np.errstate(over="ignore"):
        cuts = np.minimum(np.tan(np.minimum(bends, 1.5707963)) / m, _FARTHEST)
    ends = [np.full_like(t, x) for x in (0.0, 1.5, 3.0, _FARTHEST)]
    edges = np.moveaxis(np.sort(np.concatenate([ends, np.maximum(cuts, 0)]), 0), 0, -1)
    if edges.ndim == 1:
        edges = np.unique(edges)
    low, wide = edges[..., :-1, None], np.diff(edges)[..., None]
    psi = 0.5 * pi * nodes
    x = low + wide * np.sin(psi) ** 2
    weight = 0.5 * pi * weights * wide * np.sin(2 * psi)
    return (y.reshape(*edges.shape[:-1], -1) for y in (x, weight))


def albedo_cook_torrance(theta_v, m, f0):
    """The share of the light that the Cook-Torrance BRDF reflects, by the eye's angle.

    int f n.l dw_l = int 2 x e^(-x^2) J / (pi cos a n.v) dx, x = tan a / m, J = int G u F dphi from 0 to pi, u = l.h:
    G u is made of at most three straight pieces of u, and F is a polynomial of it, so J is in closed form

    theta_v (...) rad below pi/2, m (...) RMS slope, f0 (...). Returns (...), at most 1. Errors: rounding over n.v; m
    below 1e-5 is taken as 1e-5. Source: derived for this course; 24 Gauss-Legendre nodes for each piece of x
    between its bends.
    """
    return _albedo(theta_v, m, f0, 24)[0]


def _albedo(theta_v, m, f0, count):
    """The same by `count` nodes for each piece, and how many nodes that were in all."""
    shape = np.broadcast_shapes(*map(np.shape, (theta_v, m, f0)))
    t, m, f0 = (np.broadcast_to(np.asarray(x, float), shape) for x in (theta_v, m, f0))
    m = np.maximum(m, SMOOTHEST)
    x, weight = (y.reshape(t.size, -1) for y in _tilts(t, m, count))
    rows, nodes = np.nonzero(weight)  # about half of the pieces are empty
    x, weight, t, m, f0 = x[rows, nodes], weight[rows, nodes], t.ravel()[rows], m.ravel()[rows], f0.ravel()[rows]
    n_dot_v = np.maximum(np.cos(t), 1e-7)  # the closed form cancels by 1 over this
    slope = m * x
    c = 1 / np.sqrt(1 + slope * slope)
    share = weight * 2 * x * np.exp(-x * x) * _turned(c, slope * c, n_dot_v, np.sin(t), f0) / (pi * c * n_dot_v)
    return np.bincount(rows, share, np.prod(shape, dtype=int)).reshape(shape)[()], len(rows)


def albedo_cook_torrance_printed(theta_v, m, f0):
    """The share of the light that the Cook-Torrance BRDF as printed reflects: it can be more than all.

    4 / pi albedo_cook_torrance

    theta_v (...) rad below pi/2, m (...) RMS slope, f0 (...). Returns (...), up to 1.27. Errors: none; m below 1e-5 is
    taken as 1e-5. Source: deck, The Cook - Torrance Model (2).
    """
    return 4 / pi * albedo_cook_torrance(theta_v, m, f0)


def _turned(c, s, n_dot_v, sine, f0):
    """J: G u F over the facet's azimuth from 0 to pi; the facet's tilt has cosine c and sine s."""
    a, b = c * n_dot_v, np.maximum(s * sine, 1e-300)
    steep = 4 * c * c * n_dot_v
    flat = 2 * c * c > 1
    upper = 2 * c * n_dot_v
    rises = np.where(flat, upper / np.where(flat, 4 * c * c - 1, 1), n_dot_v / c)  # where 4 c^2 u - 2 c n.v ends
    falls = np.where(flat, upper, rises)  # where u ends
    phi = np.arccos(np.clip((np.stack([0.5 * n_dot_v / c, rises, falls]) - a) / b, -1, 1))
    moments = _moments(np.concatenate([phi, np.zeros_like(phi[:1])]))
    pieces = moments[:, :-1] - moments[:, 1:]  # (power of cos phi, piece)
    slope = np.stack([4 * c * c, np.ones_like(c), np.zeros_like(c)])
    shift = np.stack([-0.5 * steep / c, np.zeros_like(c), upper])
    head, turn = slope * a + shift, slope * b  # G u = head + turn cos phi
    one = np.sum(head * pieces[0] + turn * pieces[1], 0)
    if np.all(f0 == 1):
        return one
    fifth, below, factor = 0.0, 1 - a, 1.0  # (1 - u)^5 = (below - b cos phi)^5, by Horner's rule in `below`
    for k, ways in enumerate((1, 5, 10, 10, 5, 1)):
        fifth = fifth * below + ways * factor * np.sum(head * pieces[k] + turn * pieces[k + 1], 0)
        factor = factor * -b
    return f0 * one + (1 - f0) * fifth


def _moments(phi):
    """int_0^phi cos^k for k from 0 to 6."""
    sine, cosine = np.sin(phi), np.cos(phi)
    found, power = [phi, sine], sine
    for k in range(2, 7):
        power = power * cosine
        found.append(power / k + (k - 1) / k * found[k - 2])
    return np.stack(found)
