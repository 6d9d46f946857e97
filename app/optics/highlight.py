"""The four highlights of the course by the angles of light and eye: Phong and Blinn, each as printed and as a BRDF.

`model` 0: Phong as printed, 1: Phong as a BRDF, 2: Blinn-Phong as printed, 3: Blinn-Phong as a BRDF.
"""

import numpy as np
from numpy import pi

from app.hemisphere import NORMAL
from app.optics.blinn_phong import (
    albedo_blinn_phong,
    brdf_blinn_phong,
    brdf_blinn_phong_printed,
    lobe_flux_blinn,
    normalisation_blinn_phong,
    shading_blinn_phong,
)
from app.optics.phong import (
    albedo_phong,
    brdf_phong,
    brdf_phong_printed,
    lobe_flux_phong,
    normalisation_phong,
    shading_phong,
)
from app.optics.spherical import light_direction, view_direction


def _select(model, *values):
    return np.select([np.asarray(model) == i for i in range(3)], values[:3], values[3])[()]


def highlight_brdf(model, theta_l, theta_v, phi, k_d, k_s, exponent):
    """The BRDF of a highlight; of a printed formula the BRDF that it amounts to.

    brdf_phong_printed, brdf_phong, brdf_blinn_phong_printed or brdf_blinn_phong at n = +z, l = light_direction(theta_l,
    phi), v = view_direction(theta_v)

    model (...) 0 .. 3; theta_l, theta_v, phi (...) rad; k_d, k_s, exponent (...). Returns (...) 1/sr. Errors: none.
    Source: deck, The Phong Model (1), The Blinn Model (1), Blinn-Phong BRDF (2).
    """
    args = NORMAL, light_direction(theta_l, phi), view_direction(theta_v), k_d, k_s, exponent
    return _select(model, *(f(*args) for f in (brdf_phong_printed, brdf_phong, brdf_blinn_phong_printed,
                                               brdf_blinn_phong)))


def highlight_share(model, theta_l, theta_v, phi, k_d, k_s, exponent):
    """The radiance towards the eye over the irradiance on a surface that faces the light.

    shading_phong and shading_blinn_phong as printed; the BRDFs times n.l

    model (...) 0 .. 3; theta_l, theta_v, phi (...) rad; k_d, k_s, exponent (...). Returns (...) 1/sr. Errors: none.
    Source: deck, The Phong Model (1), BRDF - The Reflectance Equation (3).
    """
    args = NORMAL, light_direction(theta_l, phi), view_direction(theta_v), k_d, k_s, exponent
    cosine = np.cos(np.asarray(theta_l, float))
    return _select(model, shading_phong(*args), brdf_phong(*args) * cosine, shading_blinn_phong(*args),
                   brdf_blinn_phong(*args) * cosine)


def highlight_peak(model, k_d, k_s, exponent):
    """The largest value of highlight_brdf for light along the normal.

    k_d + k_s as printed; k_d / pi + k_s times the normalisation of the BRDF

    model (...) 0 .. 3; k_d, k_s, exponent (...). Returns (...) 1/sr. Errors: none. Source: as for highlight_brdf.
    """
    phong, blinn = normalisation_phong(exponent), normalisation_blinn_phong(exponent)
    return _select(model, k_d + k_s, k_d / pi + k_s * phong, k_d + k_s, k_d / pi + k_s * blinn)


def highlight_flux(model, theta_l, k_d, k_s, exponent):
    """What leaves the surface in all directions over what arrives at it: beyond 1 energy is made.

    pi k_d + k_s lobe_flux / cos theta_l as printed; k_d + k_s albedo of the BRDF

    model (...) 0 .. 3; theta_l (...) rad below pi/2; k_d, k_s, exponent (...). Returns (...). Errors: those of
    lobe_flux_phong and lobe_flux_blinn. Source: deck, The Importance of Being Normalized (1).
    """
    over = 1 / np.cos(np.asarray(theta_l, float))
    return _select(model, pi * k_d + k_s * over * lobe_flux_phong(theta_l, exponent),
                   k_d + k_s * albedo_phong(theta_l, exponent),
                   pi * k_d + k_s * over * lobe_flux_blinn(theta_l, exponent),
                   k_d + k_s * albedo_blinn_phong(theta_l, exponent))
