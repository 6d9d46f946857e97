"""What light does at a differential patch: the balance of its energy, and the reflectance equation."""

import numpy as np

from app.optics.punctual import irradiance_directional
from app.optics.solid_angle import solid_angle_cell


def exitance_reflected(k_s, irradiance_facing, theta_l):
    """The flux per area that a surface reflects, as a mirror or a gloss does.

    k_s irradiance_facing cos theta_l

    k_s (...) share, irradiance_facing (...) W/m^2, theta_l (...) rad. Returns (...) W/m^2. Errors: none.
    Source: deck, The Reflectance Equation (1).
    """
    return np.asarray(k_s, float) * irradiance_directional(irradiance_facing, theta_l)


def exitance_scattered(k_d, irradiance_facing, theta_l):
    """The flux per area that comes out again after it was scattered below the surface.

    k_d irradiance_facing cos theta_l

    k_d (...) share, irradiance_facing (...) W/m^2, theta_l (...) rad. Returns (...) W/m^2. Errors: none.
    Source: deck, The Reflectance Equation (1).
    """
    return np.asarray(k_d, float) * irradiance_directional(irradiance_facing, theta_l)


def exitance_leaving(k_d, k_s, irradiance_facing, theta_l):
    """All the flux per area that leaves: reflected and scattered, and not what is absorbed.

    (k_d + k_s) irradiance_facing cos theta_l

    k_d, k_s (...) shares, irradiance_facing (...) W/m^2, theta_l (...) rad. Returns (...) W/m^2. Errors: none;
    k_d + k_s beyond 1 makes light. Source: deck, The Reflectance Equation (1), which lists the absorbed as leaving.
    """
    return (np.asarray(k_d, float) + k_s) * irradiance_directional(irradiance_facing, theta_l)


def irradiance_absorbed(k_d, k_s, irradiance_facing, theta_l):
    """The flux per area that stays as heat: what arrives less what leaves.

    (1 - k_d - k_s) irradiance_facing cos theta_l

    k_d, k_s (...) shares, irradiance_facing (...) W/m^2, theta_l (...) rad. Returns (...) W/m^2, below 0 where
    k_d + k_s is beyond 1. Errors: cancels near k_d + k_s = 1. Source: deck, The Reflectance Equation (1).
    """
    return ((1 - np.asarray(k_d, float)) - k_s) * irradiance_directional(irradiance_facing, theta_l)


def cosine_sum(tile_rows, half_angle):
    """The projected solid angle of a cap about the normal as a sum over tiles: rows of equal height in angle.

    sum over the rows of cos(theta_i) solid_angle_cell(theta_i, half_angle / tile_rows, 2 pi)
    = pi sin^2(half_angle) / cos(half_angle / (2 tile_rows)); a tile below the horizon counts 0

    tile_rows (...) int >= 1, half_angle (...) rad. Returns (...) sr. Errors: (half_angle / tile_rows)^2 / 8 too much,
    the cosine being that of a tile's middle. Source: deck, Diffuse BRDF - Lambertian Surfaces (1).
    """
    rows, half_angle = np.asarray(tile_rows)[..., None], np.asarray(half_angle, float)[..., None]
    i = np.arange(int(rows.max()))
    high = half_angle / rows
    theta = (i + 0.5) * high
    cells = np.maximum(np.cos(theta), 0) * solid_angle_cell(theta, high, 2 * np.pi)
    return np.sum(np.where(i < rows, cells, 0.0), -1)[()]
