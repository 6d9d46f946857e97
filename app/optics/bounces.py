"""Light that meets a second facet: D and G alone lose it. How much that is, and what of it comes back.

Facets are Beckmann's in V-grooves; a roughness above 1 is taken as 1, a cosine below 0.01 as 0.01.
"""

import numpy as np
from numpy import pi

from app.optics.beckmann import SMOOTHEST
from app.optics.fresnel import f_average_dielectric
from app.optics.materials import INSULATORS, f_material, material_eta
from app.quadrature import gauss_legendre

_NODES, _WEIGHTS = gauss_legendre(12)


def _between(near, wide, low, high):
    """The azimuths 0 .. pi at which near + wide cos phi lies between two values: how many, and int cos phi."""
    first = np.arccos(np.clip((np.maximum(high, low) - near) / wide, -1, 1))
    last = np.arccos(np.clip((low - near) / wide, -1, 1))
    return last - first, np.sin(last) - np.sin(first)


def facets_lost(n_dot_v, m):
    """The share of the light that meets a second facet, of facets that mirror all: 1 - albedo_cook_torrance, F = 1.

    int D (G1 - G) u dw_h / n.v, u = v.h. With a = n.h n.v and c = n.h it is (G1 - G) u = min(u, 2a) - max(0, 4 c^2 u -
    2a), straight pieces of u, so the azimuth is in closed form; nothing cancels

    n_dot_v (...) 0 .. 1, m (...). Returns (...) 0 .. 1. Errors: 12 tilts, 0.0045 for m up to 0.5, 0.006 up
    to 1, above n.v = 0.01.
    Source: derived for this course from Heitz 2014, the weak white furnace.
    """
    mu, rough = np.broadcast_arrays(np.clip(n_dot_v, 0.01, 1), np.clip(m, SMOOTHEST, 1))
    mu, rough = mu[..., None], rough[..., None]
    x = 3 * _NODES
    slope = rough * x
    c = 1 / np.sqrt(1 + slope * slope)
    a, wide = c * mu, np.maximum(slope * c * np.sqrt((1 - mu) * (1 + mu)), 1e-30)
    lit, k = 0.5 * a / (c * c), 4 * c * c - 1
    steep = k <= 1
    end = np.where(steep, 2 * a, 2 * a / np.where(steep, 1, k))

    def piece(low, high, constant, by_u):
        length, cosine = _between(a, wide, low, high)
        return (constant + by_u * a) * length + by_u * wide * cosine

    lost = piece(0 * a, np.minimum(lit, 2 * a), 0, 1) + piece(lit, end, 2 * a, -k)
    lost += np.where(steep, piece(2 * a, lit, 2 * a, 0), 0)
    lost += np.where(steep, piece(np.maximum(lit, 2 * a), a / (c * c), 4 * a, -(k + 1)), 0)
    return (6 / pi * np.sum(_WEIGHTS * x * np.exp(-x * x) / c * lost, -1) / mu[..., 0])[()]


def _lost_terms(n_dot_v, m):
    """What rounding costs: pieces of the azimuth as large as the slope, over a cosine that may be small."""
    return 1 / np.clip(n_dot_v, 0.01, 1) + 0 * m


def facets_lost_average(m):
    """facets_lost of diffuse light, over the cosine-weighted hemisphere.

    m^2 (0.50765469 - 0.09646055 m + 0.10227136 m^2 - 0.35423716 m^3 + 0.17643248 m^4)

    m (...). Returns (...) 0 .. 0.34. Errors: a fit to 2 int (1 - albedo_cook_torrance) mu dmu, 6e-5.
    Source: fitted here.
    """
    x = np.clip(m, SMOOTHEST, 1)
    return x * x * (0.50765469 + x * (-0.09646055 + x * (0.10227136 + x * (-0.35423716 + x * 0.17643248))))


def bounced_share(f_average, m):
    """Of the light that meets a second facet, the share that leaves in the end.

    F^2 E (1 + F (1 - E) + ...) = F^2 E / (1 - F (1 - E)), F = f_average, E = 1 - facets_lost_average

    f_average (...) 0 .. 1, m (...). Returns (...) 0 .. 1; all of it for F = 1. Errors: every bounce is taken for
    diffuse light. Source: Kulla and Conty 2017, Revisiting Physically Based Shading at Imageworks.
    """
    f, lost = np.clip(f_average, 0, 1), facets_lost_average(m)
    return f * f * (1 - lost) / (1 - f * lost)


_MU, _MU_WEIGHTS = gauss_legendre(24)
_METALS = np.minimum([2 * (_MU_WEIGHTS * _MU) @ f_material(_MU, i) for i in range(INSULATORS, 10)], 1)


def f_material_average(material):
    """The share of diffuse light that a row of the deck's tables reflects, in linear sRGB.

    2 int f_material mu dmu, no channel above 1

    material (...) 0 .. 9, integers. Returns (..., 3). Errors: those of f_material; gold's red is 1.02 and taken as 1.
    Source: Walsh 1926 for insulators; 24 angles for metals.
    """
    material = np.asarray(material)
    clear = f_average_dielectric(material_eta(np.minimum(material, INSULATORS - 1)))
    metal = _METALS[np.maximum(material - INSULATORS, 0)]
    return np.where((material < INSULATORS)[..., None], np.asarray(clear)[..., None], metal)


def bounced_light(n_dot_l, n_dot_v, m, material, irradiance_facing, radiance):
    """The radiance that leaves after two or more facets, of a lamp and of an even room.

    share (1 - E(v)) (E_lamp n.l (1 - E(l)) / (pi (1 - E_avg)) + L_room): reciprocal, and 1 - E in even light if F = 1

    n_dot_l (...) 0 where the lamp is below, n_dot_v (...), m (...), material (...) int, irradiance_facing (...) W/m^2
    of the lamp, radiance (...) W/(m^2 sr) of the room. Returns (..., 3) W/(m^2 sr). Errors: those of facets_lost, and a
    lobe as wide as a matt one. Source: Kulla and Conty 2017; Kelemen and Szirmay-Kalos 2001.
    """
    f = np.moveaxis(f_material_average(material), -1, 0)
    share = np.stack(np.broadcast_arrays(*(bounced_share(x, m) for x in f)), -1)
    n_dot_l = np.asarray(n_dot_l, float)
    lamp = irradiance_facing * np.maximum(n_dot_l, 0) * facets_lost(n_dot_l, m) / (pi * facets_lost_average(m))
    return share * (facets_lost(n_dot_v, m) * (lamp + radiance))[..., None]


def _bounced_terms(n_dot_l, n_dot_v, m, material, irradiance_facing, radiance):
    """What rounding costs: the lamp's side and the eye's are rounded."""
    sides = facets_lost(n_dot_v, m) * _lost_terms(n_dot_l, m) + facets_lost(n_dot_l, m) * _lost_terms(n_dot_v, m)
    return irradiance_facing * n_dot_l * sides / (pi * facets_lost_average(m)) + radiance * _lost_terms(n_dot_v, m)


def bounced_light_none(n_dot_l, n_dot_v, m, material, irradiance_facing, radiance):
    """The same as if light that meets a second facet were lost.

    0

    The arguments of bounced_light. Returns (..., 3), 0. Errors: bounced_light_error.
    Source: Cook and Torrance 1982.
    """
    given = np.broadcast_shapes(*map(np.shape, (n_dot_l, n_dot_v, m, material, irradiance_facing, radiance)))
    return np.zeros((*given, 3))


def bounced_light_error(material, m):
    """The largest share of the light that a second facet sends back: what a scene loses that leaves it out.

    max facets_lost over n.v = 1/32 .. 1, times bounced_share of the strongest channel

    material (...) int, m (...). Returns (...) 0 .. 1. Errors: 32 angles. Source: measured here.
    """
    m = np.asarray(m, float)
    lost = np.max(facets_lost(np.arange(1, 33) / 32, m[..., None]), -1)
    return (lost * bounced_share(np.max(f_material_average(material), -1), m))[()]
