"""The metallic-roughness model of glTF as pyrender draws it, our second renderer: in float64, term by term.

`roughness` is what a file stores: pyrender keeps it from 0.04 to 1 and squares it for the width alpha of GGX.
`base_colour` is one channel, linear. Nothing is quite black: n.l and |n.v| stay above 0.001.
"""

import numpy as np
from numpy import pi

from app.optics.beckmann import slope_squared
from app.optics.coat import brdf_coated
from app.optics.fresnel import f_schlick
from app.optics.ggx import d_ggx_slope

DIELECTRIC, LEAST = 0.04, 0.001  # F0 of what is no metal, and the least roughness; the least cosine
COPPER = np.array([0.95, 0.50, 0.28])  # the base colour of the lesson's file


def alpha_gltf(roughness):
    """The width of GGX that a file's roughness means.

    clamp(roughness, 0.04, 1)^2

    roughness (...) 0 .. 1. Returns (...) 0.0016 .. 1. Errors: none. Source: pyrender, mesh.frag; glTF 2.0, appendix B.
    """
    return np.clip(np.asarray(roughness, float), DIELECTRIC, 1.0) ** 2


def roughness_gltf(m):
    """The roughness to store for facets of RMS slope m, so that highlights have the same peak: alpha = m.

    clamp(sqrt(m), 0.04, 1): Beckmann's and GGX's D are 1 / (pi m^2) where a facet lies flat

    m (...) > 0. Returns (...) 0.04 .. 1. Errors: none; alpha_gltf undoes it for m from 0.0016 to 1.
    Source: Walter et al. 2007; glTF 2.0, appendix B.
    """
    return np.clip(np.sqrt(np.asarray(m, float)), DIELECTRIC, 1.0)


def g_gltf(n_dot_l, n_dot_v, roughness):
    """How much of the facets is lit and seen, by pyrender: Schlick's fit to Smith, light and eye apart.

    nl / (nl (1 - k) + k) nv / (nv (1 - k) + k), k = (roughness + 1)^2 / 8, cosines and roughness as in shading_gltf

    n_dot_l, n_dot_v (...), roughness (...) 0 .. 1. Returns (...) 0 .. 1. Errors: none. As masking of GGX it is a fit:
    k is not alpha / 2, and even a mirror (k = 1/8) loses light. Source: Schlick 1994; Karis 2013; pyrender, mesh.frag.
    """
    nl, nv = np.clip(n_dot_l, LEAST, 1.0), np.clip(np.abs(n_dot_v), LEAST, 1.0)
    k = (np.clip(np.asarray(roughness, float), DIELECTRIC, 1.0) + 1) ** 2 / 8
    return nl / (nl * (1 - k) + k) * (nv / (nv * (1 - k) + k))


def _value(n, l, v, base_colour, metallic, roughness):
    """f with its raised cosines, and n.l, raised too."""
    n, l, v = (np.asarray(x, float) for x in (n, l, v))
    n_dot_l, n_dot_v, s = np.sum(n * l, -1), np.sum(n * v, -1), l + v
    nl, nv = np.clip(n_dot_l, LEAST, 1.0), np.clip(np.abs(n_dot_v), LEAST, 1.0)
    metallic, colour = np.clip(np.asarray(metallic, float), 0.0, 1.0), np.asarray(base_colour, float)
    f0 = DIELECTRIC * (1 - metallic) + colour * metallic
    fresnel = f_schlick(0.5 * np.sqrt(np.sum(s * s, -1)), f0)
    along = np.sum(n * s, -1)
    d = d_ggx_slope(slope_squared(n, s), alpha_gltf(roughness))
    d = np.where(along > 0, d, alpha_gltf(roughness) ** 2 / pi)  # facets on edge: n.h counts as 0
    body = (1 - fresnel) * (1 - DIELECTRIC) * (1 - metallic) * colour / pi
    return body + fresnel * g_gltf(n_dot_l, n_dot_v, roughness) * d / (4 * nl * nv + 0.001), nl, n_dot_l, n_dot_v


def shading_gltf(n, l, v, base_colour, metallic, roughness):
    """What pyrender shows of a material under one light: the radiance over the light's irradiance, facing it.

    max(n.l, 0.001) ((1 - F) 0.96 (1 - metallic) colour / pi + D G F / (4 n.l n.v + 0.001)); D of GGX, alpha_gltf wide,
    G g_gltf, F Schlick's from 0.04 (1 - metallic) + colour metallic; no cosine counts below 0.001, n.v by its size

    n, l, v (..., 3) unit, base_colour (...) one channel, linear, metallic (...) 0 .. 1, roughness (...) 0 .. 1.
    Returns (...). Errors: none; pyrender's own D loses digits in float32 below a roughness of 0.2.
    Source: pyrender, mesh.frag; Khronos, glTF 2.0.
    """
    f, nl, _, _ = _value(n, l, v, base_colour, metallic, roughness)
    return nl * f


def brdf_gltf(n, l, v, base_colour, metallic, roughness):
    """The same as a BRDF: without the light that comes from below.

    shading_gltf / n.l; 0 unless n.l > 0 and n.v > 0

    n, l, v (..., 3) unit, base_colour (...) one channel, linear, metallic (...) 0 .. 1, roughness (...) 0 .. 1.
    Returns (...) 1/sr. Errors: none. Source: pyrender, mesh.frag; Khronos, glTF 2.0.
    """
    f, _, n_dot_l, n_dot_v = _value(n, l, v, base_colour, metallic, roughness)
    return np.where((n_dot_l > 0) & (n_dot_v > 0), f, 0.0)[()]


def brdf_file(n, l, v, metallic, roughness, mapped, channel):
    """A glTF file's copper, or copper paint, drawn by us: by our own models, or by glTF's as pyrender has it.

    mapped 0, 1: brdf_coated with m = roughness or roughness^2, rho = 0.96 (1 - metallic) colour,
    f0 = 0.04 (1 - metallic) + metallic colour, light coupled in and out; 2: brdf_gltf; colour = 0.95, 0.50, 0.28

    n, l, v (..., 3) unit, metallic (...) 0 .. 1, roughness (...) 0 .. 1, at least 0.04, mapped (...) 0, 1 or 2,
    channel (...) 0, 1 or 2. Returns (...) 1/sr. Errors: none. Source: as brdf_coated and brdf_gltf.
    """
    colour, metal = COPPER[np.asarray(channel)], np.clip(np.asarray(metallic, float), 0.0, 1.0)
    alpha, mapped = alpha_gltf(roughness), np.asarray(mapped)
    m = np.where(mapped == 0, np.sqrt(alpha), alpha)
    f0 = DIELECTRIC * (1 - metal) + colour * metal
    ours = brdf_coated(n, l, v, (1 - DIELECTRIC) * (1 - metal) * colour, m, f0, 3)
    return np.where(mapped == 2, brdf_gltf(n, l, v, colour, metal, roughness), ours)[()]


def peak_lost(roughness):
    """How many times too dim the middle of a highlight gets if a file's roughness is taken for m.

    D(0) of m = roughness^2 over D(0) of m = roughness: 1 / roughness^2

    roughness (...) 0 .. 1, at least 0.04. Returns (...) 1 .. 625. Errors: none. Source: deck, Distribution Term (2);
    glTF 2.0, appendix B.
    """
    return 1 / alpha_gltf(roughness)
