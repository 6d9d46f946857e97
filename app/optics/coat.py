"""A matt body under a clear coat: what the Fresnel term leaves for the body, coupled in four ways.

`coupling` 0: none, body and mirror are added up; 1: the body times 1 - F(l.h); 2: times 1 - F(n.l), on the way in;
3: on the way in and on the way out, and what the way out throws back comes once more. F is Schlick's; a number of
another coupling is none of theirs, and counts as 3.
"""

import numpy as np
from numpy import pi

from app.optics.cook_torrance import _l_dot_h, brdf_cook_torrance
from app.optics.fresnel import f_average_schlick
from app.optics.phong import _dot, _facing
from app.quadrature import gauss_legendre

_NODES, _WEIGHTS = gauss_legendre(24)


def passed_share(l_dot_h, f0):
    """The share of the light that goes through the coat: what Schlick's fit does not reflect.

    (1 - f0) (1 - x^5), c = l_dot_h, x = 1 - c, as (1 - f0) c (1 + x + x^2 + x^3 + x^4), where nothing cancels

    l_dot_h (...), below 0 as at 0; f0 (...) 0 .. 1. Returns (...) 0 .. 1. Errors: those of the fit.
    Source: Schlick 1994.
    """
    c = np.maximum(np.asarray(l_dot_h, float), 0.0)
    x = 1 - c
    return (1 - np.asarray(f0, float)) * c * (1 + x * (1 + x * (1 + x * (1 + x))))


def body_coupled(n_dot_l, n_dot_v, rho, f0):
    """The BRDF of a matt body under a smooth coat: reciprocal, and with the coat's mirror all comes back for rho = 1.

    rho (1 - F(n.l)) (1 - F(n.v)) / (pi (1 - F_avg)), F_avg = f0 + (1 - f0) / 21

    n_dot_l, n_dot_v (...) cosines, rho (...), f0 (...) below 1. Returns (...) 1/sr. Errors: rho below 1
    counts all bounces under the coat together. Source: Shirley et al. 1997; Kelemen and Szirmay-Kalos 2001.
    """
    through = passed_share(n_dot_l, f0) * passed_share(n_dot_v, 0.0)
    return (np.asarray(rho, float) * through / (pi * (20 / 21)))[()]


def body_share(n_dot_l, n_dot_v, l_dot_h, f0, coupling):
    """What a coupling leaves of the body's rho / pi.

    1; 1 - F(l.h); 1 - F(n.l); (1 - F(n.l)) (1 - F(n.v)) / (1 - F_avg)

    n_dot_l, n_dot_v, l_dot_h (...) cosines, f0 (...) below 1, coupling (...) 0 .. 3. Returns (...), the last up to
    1.05 (1 - f0). Errors: none. Source: deck, Plausible Shading - BRDFs; see body_coupled.
    """
    ways = np.broadcast_arrays(np.ones_like(passed_share(n_dot_l, f0)), passed_share(l_dot_h, f0),
                               passed_share(n_dot_l, f0), pi * body_coupled(n_dot_l, n_dot_v, 1.0, f0),
                               np.asarray(coupling, float))
    return np.select([ways[4] == k for k in range(3)], ways[:3], ways[3])[()]


def brdf_coated(n, l, v, rho, m, f0, coupling):
    """Cook-Torrance over a matt body: the mirror of a coat with the slope m and the body under it.

    brdf_cook_torrance + rho / pi body_share; 0 unless n.l > 0 and n.v > 0

    n, l, v (..., 3) unit, rho (...), m (...) RMS slope, f0 (...) below 1, coupling (...) 0 .. 3. Returns (...) 1/sr.
    Errors: none; the body sees the coat as smooth. Source: deck, Plausible Shading - BRDFs.
    """
    share = body_share(_dot(n, l), _dot(n, v), _l_dot_h(l, v), f0, coupling)
    body = np.where(_facing(n, l, v), np.asarray(rho, float) * share / pi, 0.0)
    return (brdf_cook_torrance(n, l, v, m, f0) + body)[()]


def albedo_body(theta_v, rho, f0, coupling):
    """The share of the light that the body gives back, by the eye's angle.

    rho; rho / pi int (1 - F(cos g / 2)) J sin g dg; rho (1 - F_avg); rho (1 - F(n.v)). g is the angle between light and
    eye, l.h = cos g / 2, and J = 2 (A psi + B sin psi) the cosine n.l = A + B cos, A = cos g n.v and
    B = sin g sin theta_v, over the azimuths up to psi at which the light is above the surface

    theta_v (...) rad, 0 .. pi/2, rho (...), f0 (...) below 1, coupling (...) 0 .. 3. Returns (...). Errors: none.
    Source: derived for this course; 24 Gauss-Legendre nodes for each of three pieces.
    """
    t, rho, f0, which = np.broadcast_arrays(*(np.asarray(x, float) for x in (theta_v, rho, f0, coupling)))
    ways = [np.ones_like(t), _halfway_body(t, f0) if np.any(which == 1) else t, 1 - f_average_schlick(f0)]
    return (rho * np.select([which == k for k in range(3)], ways, passed_share(np.cos(t), f0)))[()]


def _halfway_body(t, f0):
    """int (1 - F(l.h)) n.l dw_l / pi: from g = 0 to where the light may be below the surface, and on to where it is."""
    t, f0 = t[..., None, None], f0[..., None, None]
    low = np.concatenate([np.zeros_like(t), 0.5 * pi - t, np.full_like(t, 0.5 * pi)], -2)
    wide = np.concatenate([0.5 * pi - t, t, t], -2)
    turn = 0.5 * pi * _NODES
    g = low + wide * np.sin(turn) ** 2
    weight = 0.5 * pi * _WEIGHTS * wide * np.sin(2 * turn)
    a, b = np.cos(g) * np.cos(t), np.maximum(np.sin(g) * np.sin(t), 1e-300)
    psi = np.arccos(np.clip(-a / b, -1, 1))
    got = 2 * (a * psi + b * np.sin(psi))
    return np.sum(weight * passed_share(np.cos(0.5 * g), f0) * got * np.sin(g), (-1, -2)) / pi


def albedo_coated(theta_v, rho, f0, coupling):
    """The share of the light that a body under a smooth coat gives back: the coat's mirror and the body.

    F(n.v) + albedo_body

    theta_v (...) rad, 0 .. pi/2, rho (...), f0 (...) below 1, coupling (...) 0 .. 3. Returns (...); above 1 light is
    made. Errors: none. Source: optics reference, D13.
    """
    f0 = np.asarray(f0, float)
    less = 2 * np.sin(0.5 * np.asarray(theta_v, float)) ** 2  # 1 - n.v
    return (f0 + (1 - f0) * np.minimum(less, 1) ** 5 + albedo_body(theta_v, rho, f0, coupling))[()]
