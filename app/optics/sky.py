"""The reflectance equation under a sky that is made up: blue, a hazy sun, a dark tree. n is +z."""

import numpy as np
from numpy import pi

from app.hemisphere import NORMAL
from app.optics.phong import brdf_phong
from app.optics.solid_angle import solid_angle_cell
from app.optics.spherical import direction, light_direction, view_direction
from app.quadrature import gauss_legendre

_TREE = np.array([-0.48, 0.86, 0.173205081])
_U, _W = gauss_legendre(24)
_Z, _ZW = np.concatenate([0.5 * _U, 0.5 + 0.5 * _U]), 0.5 * np.concatenate([_W, _W])
_TURN = (np.arange(96) + 0.5) * pi / 48


def sky_radiance(l, to_sun, zenith_radiance, sun_radiance):
    """The radiance that comes from a direction: blue and brighter towards the horizon, a glow around the sun, a tree.

    (zenith_radiance (1 + 3/2 (1 - l_z)^2) + sun_radiance ((1 + l.s) / 2)^128) (1 - 0.94 ((1 + l.t) / 2)^64)
    and 0 from below the horizon

    l, to_sun (..., 3) unit, s being to_sun and t the tree's direction; zenith_radiance, sun_radiance (...)
    W/(m^2 sr). Returns (...) W/(m^2 sr). Errors: none. Source: made up, for deck, BRDF - The Reflectance Equation (3).
    """
    l = np.asarray(l, float)
    glow = (0.5 + 0.5 * np.sum(l * to_sun, -1)) ** 128
    tree = (0.5 + 0.5 * (l @ _TREE)) ** 64
    sky = np.asarray(zenith_radiance, float) * (1 + 1.5 * (1 - l[..., 2]) ** 2)
    value = (sky + np.asarray(sun_radiance, float) * glow) * (1 - 0.94 * tree)
    return np.where(l[..., 2] > 0, value, 0.0)[()]


def reflected_part(l, to_sun, v, zenith_radiance, sun_radiance, k_d, k_s, exponent):
    """What stands under the integral of the reflectance equation: how much one direction gives to the eye.

    brdf_phong(n, l, v, k_d, k_s, exponent) sky_radiance(l, to_sun, zenith_radiance, sun_radiance) max(0, l_z)

    l, to_sun, v (..., 3) unit, zenith_radiance, sun_radiance (...) W/(m^2 sr), k_d, k_s (...) shares,
    exponent (...) >= 0. Returns (...) W/(m^2 sr) per sr. Errors: none.
    Source: deck, BRDF - The Reflectance Equation (3).
    """
    l = np.asarray(l, float)
    f = brdf_phong(NORMAL, l, v, k_d, k_s, exponent)
    return f * sky_radiance(l, to_sun, zenith_radiance, sun_radiance) * np.maximum(l[..., 2], 0)


def reflected_radiance_sum(tile_rows, theta_l, phi, theta_v, zenith_radiance, sun_radiance, k_d, k_s, exponent):
    """The radiance to the eye as a sum over tiles of the sky, `tile_rows` from the pole to the horizon, 4 times as many
    around: f, L_i and the cosine are taken at a tile's middle, its solid angle is exact.

    sum over the tiles of reflected_part(l_ij, ...) solid_angle_cell(theta_i, d, d), d = pi / (2 tile_rows)

    tile_rows (...) int >= 1, theta_l, phi the sun and theta_v the eye (...) rad, zenith_radiance, sun_radiance (...)
    W/(m^2 sr), k_d, k_s (...) shares, exponent (...) >= 0. Returns (...) W/(m^2 sr). Errors: large while a tile is
    wider than the sun or the lobe, then as tile_rows^-2. Source: deck, BRDF - The Reflectance Equation (3).
    """
    args = np.broadcast_arrays(tile_rows, theta_l, phi, theta_v, zenith_radiance, sun_radiance, k_d, k_s, exponent)
    rows, *column = (np.asarray(a)[..., None] for a in args)
    to_sun, v, rest = light_direction(*column[:2]), view_direction(column[2]), column[3:]
    high, j = 0.5 * pi / rows, np.arange(4 * int(rows.max()))
    total = np.zeros(args[0].shape)
    for i in range(int(rows.max())):
        theta = (i + 0.5) * high
        part = reflected_part(direction(theta, (j + 0.5) * high), to_sun, v, *rest)
        row = np.sum(np.where((i < rows) & (j < 4 * rows), part, 0.0), -1)
        total += row * solid_angle_cell(theta, high, high)[..., 0]
    return total[()]


def reflected_radiance(theta_l, phi, theta_v, zenith_radiance, sun_radiance, k_d, k_s, exponent):
    """The radiance that a patch sends to the eye: the reflectance equation.

    int f L_i cos theta_i dw_i by twice 24 Gauss-Legendre nodes in cos theta_i and 96 even ones in azimuth

    theta_l, phi the sun and theta_v the eye (...) rad, zenith_radiance, sun_radiance (...) W/(m^2 sr),
    k_d, k_s (...) shares, exponent (...) >= 0. Returns (...) W/(m^2 sr). Errors: below 1e-10 for exponents from 5 to
    100, 5e-8 at 200; a narrower lobe slips through the nodes. Source: deck, BRDF - The Reflectance Equation (3).
    """
    args = np.broadcast_arrays(theta_l, phi, theta_v, zenith_radiance, sun_radiance, k_d, k_s, exponent)
    column = [np.asarray(a, float)[..., None] for a in args]
    to_sun, v, rest = light_direction(*column[:2]), view_direction(column[2]), column[3:]
    total = np.zeros(args[0].shape)
    for z, weight in zip(_Z, _ZW, strict=True):
        l = direction(np.arccos(z), _TURN)
        total += weight * np.sum(reflected_part(l, to_sun, v, *rest), -1)
    return (total * pi / 48)[()]


def sun_share(theta_l, phi, theta_v, zenith_radiance, sun_radiance, k_d, k_s, exponent):
    """How much of the radiance to the eye comes from the sun's glow.

    reflected_radiance of the sun alone, zenith_radiance = 0, over reflected_radiance

    The arguments of reflected_radiance. Returns (...) 0 .. 1; 0 where nothing is reflected. Errors: none.
    Source: the reflectance equation is linear in L_i, deck, The BRDF (3).
    """
    whole = reflected_radiance(theta_l, phi, theta_v, zenith_radiance, sun_radiance, k_d, k_s, exponent)
    sun = reflected_radiance(theta_l, phi, theta_v, 0.0, sun_radiance, k_d, k_s, exponent)
    return np.where(whole > 0, sun / np.where(whole > 0, whole, 1), 0.0)[()]
