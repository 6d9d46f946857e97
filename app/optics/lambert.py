"""The diffuse BRDF: light scattered evenly, so that the surface looks the same from every side."""

import numpy as np


def brdf_lambert(n, l, v, rho):
    """The BRDF of an ideally diffuse surface.

    rho / pi, and 0 where the light or the eye is below the surface

    n, l, v (..., 3) unit vectors, rho (...) albedo 0 .. 1. Returns (...) 1/sr. Errors: none; rho beyond 1 makes light.
    Source: deck, Diffuse BRDF - Lambertian Surfaces (2); Lambert 1760, Photometria.
    """
    return np.where(_above(n, l) & _above(n, v), np.asarray(rho, float) / np.pi, 0.0)[()]


def _above(n, direction):
    return np.sum(np.asarray(n, float) * np.asarray(direction, float), -1) > 0
