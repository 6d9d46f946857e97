"""Ten materials by both models of the course: Cook-Torrance, and a Blinn-Phong that is as wide and as bright head-on.

`material` is a row of the deck's tables (see materials). Insulators have one red body under their mirror; metals none.
"""

import numpy as np

from app.optics.beckmann import exponent_from_m
from app.optics.blinn_phong import brdf_blinn_phong
from app.optics.coat import body_coupled
from app.optics.cook_torrance import _l_dot_h, cook_torrance_dg
from app.optics.materials import INSULATORS, _channel, f_material
from app.optics.phong import _dot, _facing

_BODY = np.array([0.55, 0.05, 0.04])


def matter_body(material, channel):
    """The share that a material's body gives back, in one channel: insulators are red here, metals have none.

    0.55, 0.05, 0.04; 0 for a metal

    material, channel (...) integers. Returns (...). Errors: none. Source: ours; deck, Plausible Shading - BRDFs.
    """
    return np.where(np.asarray(material) < INSULATORS, _BODY[np.asarray(channel)], 0.0)[()]


def _share(l_dot_h, material, channel):
    c, material, channel = np.broadcast_arrays(np.asarray(l_dot_h, float), material, channel)
    return np.clip(_channel(f_material(c, material), channel), 0.0, 1.0)[()]


def brdf_matter(n, l, v, m, material, channel):
    """A material by Cook-Torrance, with its measured Fresnel term, over a body that gets what is left.

    cook_torrance_dg f_material + body_coupled; F of a metal cut to 0 .. 1; 0 unless n.l > 0 and n.v > 0

    n, l, v (..., 3) unit, m (...) RMS slope, material, channel (...) integers. Returns (...) 1/sr. Errors: those of
    f_material. Source: deck, Cook Torrance - Comparison (1), (2); Cook and Torrance 1982.
    """
    mirror = cook_torrance_dg(n, l, v, m) * _share(np.minimum(_l_dot_h(l, v), 1.0), material, channel)
    body = body_coupled(_dot(n, l), _dot(n, v), matter_body(material, channel), _share(1.0, material, channel))
    return (mirror + np.where(_facing(n, l, v), body, 0.0))[()]


def brdf_matter_blinn(n, l, v, m, material, channel):
    """The same material by Blinn-Phong: its highlight has the width of m and takes its colour head-on.

    brdf_blinn_phong, k_s = f_material(1), k_d = matter_body (1 - k_s), exponent 2 / m^2 - 2

    n, l, v (..., 3) unit, m (...) RMS slope up to 1, material, channel (...) integers. Returns (...) 1/sr. Errors:
    those of f_material. Source: deck, Cook Torrance - Comparison (1), (2); Blinn-Phong BRDF (2).
    """
    k_s = _share(1.0, material, channel)
    k_d = matter_body(material, channel) * (1 - k_s)
    return brdf_blinn_phong(n, l, v, k_d, k_s, exponent_from_m(np.minimum(m, 1.0)))


def gain_cook_torrance(theta_d, material, channel):
    """How many times brighter the middle of a highlight is than head-on, the lamp being as far aside as the eye.

    F(theta_d) / (F(0) cos theta_d): D is at its peak, G is 1, and 1 / (n.l n.v) outgrows n.l

    theta_d (...) rad below pi/2, from the normal; material, channel (...) integers. Returns (...). Errors: those of
    f_material. Source: deck, The Cook - Torrance Model (2).
    """
    c = np.cos(np.asarray(theta_d, float))
    return _share(c, material, channel) / (_share(1.0, material, channel) * c)


def gain_blinn_phong(theta_d):
    """The same of the Blinn-Phong BRDF, whatever the material.

    cos theta_d: the lobe stays, n.l shrinks

    theta_d (...) rad. Returns (...). Errors: none. Source: deck, Blinn-Phong BRDF (2).
    """
    return np.cos(np.asarray(theta_d, float))
