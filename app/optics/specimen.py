"""Surfaces made up to show what a BRDF is, and what it must not be."""

import numpy as np
from numpy import pi

from app.hemisphere import NORMAL
from app.optics.lambert import brdf_lambert
from app.optics.phong import brdf_phong
from app.optics.sky import _TURN, _U, _W, _Z, _ZW
from app.optics.spherical import direction, direction_phi, direction_theta, view_direction

_PAINT = np.array([0.62, 0.16, 0.10])


def brdf_paint(n, l, v, channel, k_s, exponent):
    """Red paint under a clear varnish: a coloured diffuse part and a white highlight.

    (1 - k_s) rho_c / pi + k_s (exponent + 2) / (2 pi) (r.v)^exponent, rho = 0.62, 0.16, 0.10 for red, green, blue

    n, l, v (..., 3) unit, channel (...) int, k_s (...) share, exponent (...) >= 0. Returns (...) 1/sr. Errors: none.
    Source: made up, for deck, The BRDF (2).
    """
    body = brdf_lambert(n, l, v, _PAINT[channel])
    return (1 - np.asarray(k_s, float)) * body + brdf_phong(n, l, v, 0.0, k_s, exponent)


def brdf_flawed(n, l, v, radiance, flaw, k_d, k_s, exponent):
    """A diffuse part and a highlight, as brdf_phong, times the incoming radiance; with one of five flaws.

    L (body + gloss), gloss = brdf_phong(n, l, v, 0, k_s, exponent), body = k_d / pi, and by flaw 1: body - k_d,
    2: body (1 - (1 - n.l)^2), 3: k_d, 4: min(1, L (body + gloss)), 5: body (1 + cos(azimuth of l from v) / 2)

    n, l, v (..., 3) unit, radiance (...) W/(m^2 sr), flaw (...) int, k_d, k_s (...) shares, exponent (...) >= 0.
    Returns (...) W/(m^2 sr) per sr. Errors: flaw 5 is NaN where l or v stands on n, on purpose. Source: made up, for
    deck, The BRDF (3).
    """
    n, l, v = (np.asarray(x, float) for x in (n, l, v))
    n_dot_l, n_dot_v = np.sum(n * l, -1), np.sum(n * v, -1)
    flaw, k_d = np.asarray(flaw), np.asarray(k_d, float)
    a, b = l - n_dot_l[..., None] * n, v - n_dot_v[..., None] * n
    with np.errstate(invalid="ignore"):
        turned = np.sum(a * b, -1) / np.sqrt(np.sum(a * a, -1) * np.sum(b * b, -1))
    away = 1 - n_dot_l
    bodies = k_d / pi - k_d, k_d / pi * (1 - away * away), k_d + 0 * away, k_d / pi * (1 + 0.5 * turned)
    body = np.select([flaw == 1, flaw == 2, flaw == 3, flaw == 5], bodies, k_d / pi)
    value = radiance * (body + brdf_phong(n, l, v, 0.0, k_s, exponent))
    value = np.where(flaw == 4, np.minimum(value, 1.0), value)
    return np.where((n_dot_l > 0) & (n_dot_v > 0), value, 0.0)[()]


def ratio_flawed(n, l, v, radiance, flaw, k_d, k_s, exponent):
    """brdf_flawed over the incoming radiance: of a BRDF it is the same for every radiance, flaw 4 is none.

    brdf_flawed(...) / L

    The arguments of brdf_flawed. Returns (...) 1/sr. Errors: those of brdf_flawed. Source: deck, The BRDF (1).
    """
    return brdf_flawed(n, l, v, radiance, flaw, k_d, k_s, exponent) / np.asarray(radiance, float)


def hemisphere_meter(theta_v, radiance, flaw, k_d, k_s, exponent, weight):
    """The BRDF with its flaw, integrated over all directions of the light: with the cosine it is the albedo.

    int f dw, and with weight 1 int f cos theta dw, f = brdf_flawed(...) / radiance; the nodes of reflected_radiance

    theta_v (...) rad, radiance (...) W/(m^2 sr), flaw, weight (...) int, k_d, k_s (...) shares, exponent (...) >= 0.
    Returns (...). Errors: 1e-10 for exponents from 5 to 100, up to 1e-3 where flaw 4 cuts the highlight off.
    Source: deck, The BRDF (3), which prints it without the cosine.
    """
    args = np.broadcast_arrays(theta_v, radiance, flaw, k_d, k_s, exponent, weight)
    column = [np.asarray(a)[..., None] for a in args]
    v, total = view_direction(column[0]), np.zeros(args[0].shape)
    for z, dz in zip(_Z, _ZW, strict=True):
        row = np.sum(brdf_flawed(NORMAL, direction(np.arccos(z), _TURN), v, *column[1:6]), -1)
        total += dz * np.where(args[6] == 1, z, 1.0) * row
    return (total * pi / 48 / args[1])[()]


def paint_measured(theta_l, phi, theta_v, half_angle, channel, k_s, exponent):
    """brdf_paint as it is measured: the radiance to the eye over the irradiance, with a round lamp of some size.

    int f cos dw / int cos dw over the cone of half_angle about the light's direction, what is below the horizon cut off

    theta_l, phi, theta_v (...) rad, half_angle (...) rad > 0, channel (...) int, k_s (...) share, exponent (...) >= 0.
    Returns (...) 1/sr. Errors: 1e-12 where the horizon does not cut the cone, else 1e-2. As an estimate of f itself its
    error is that of a mean over the cone. Source: deck, The BRDF (1).
    """
    theta_l, phi, theta_v, half_angle, channel, k_s, exponent = (
        np.asarray(x)[..., None, None] for x in np.broadcast_arrays(
            theta_l, phi, theta_v, half_angle, channel, k_s, exponent))
    x, w = _U[:, None], _W[:, None]
    turn = (np.arange(32) + 0.5) * pi / 16
    l, a, b = direction(theta_l, phi), direction_theta(theta_l, phi), direction_phi(phi)
    q = (2 * np.sin(0.5 * half_angle) ** 2 * x)[..., None]
    d = l - q * l + np.sqrt(q * (2 - q)) * (np.cos(turn)[:, None] * a + np.sin(turn)[:, None] * b)
    cosine = w * np.maximum(d[..., 2], 0)
    part = cosine * brdf_paint(NORMAL, d, view_direction(theta_v), channel, k_s, exponent)
    return (np.sum(part, (-1, -2)) / np.sum(cosine, (-1, -2)))[()]
