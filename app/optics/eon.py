"""EON, the energy-conserving Oren-Nayar model: light that one facet scatters onto another comes back.

The first bounce is Fujii's smooth form of Oren and Nayar's (FON), whose albedo has a closed form; a second lobe returns
what it loses. `roughness` goes from 0, Lambert, to 1.
"""

import numpy as np
from numpy import pi

from app.optics.oren_nayar import _cosines
from app.optics.spherical import light_direction, view_direction

C1, C2 = 1 / 2 - 2 / (3 * pi), 2 / 3 - 28 / (15 * pi)


def fon_loss(n_dot_v):
    """What the first bounce loses, 1 - E, but for its factor K r / pi: without a difference of nearly equal terms.

    pi C1 mu^2 / (1 + S) + S asin mu + S^2 mu - 2/3 S mu (1 + S + S^2) / (1 + S), mu = n.v, S = sqrt(1 - mu^2)

    n_dot_v (...) 0 .. 1. Returns (...): 0 at grazing light, pi C1 head-on. Errors: none.
    Source: Portsmouth, Kutz and Hill 2025, rearranged.
    """
    mu = np.minimum(np.asarray(n_dot_v, float), 1)
    s = np.sqrt((1 - mu) * (1 + mu))
    steep = pi * C1 * mu * mu / (1 + s) + s * np.arctan2(mu, s) + s * s * mu
    return steep - 2 / 3 * s * mu * (1 + s + s * s) / (1 + s)


def albedo_fon(n_dot_v, roughness):
    """The albedo of the first bounce, for facets that absorb nothing.

    K (1 + r g / pi), K = 1 / (1 + C1 r), g = S (acos mu - S mu) + 2/3 (S mu (1 + S + S^2) / (1 + S) - S),
    mu = n.v, S = sqrt(1 - mu^2), C1 = 1/2 - 2 / (3 pi)

    n_dot_v (...) 0 .. 1, roughness (...) r, 0 .. 1. Returns (...). Errors: none.
    Source: Portsmouth, Kutz and Hill 2025, EON: A practical energy-preserving rough diffuse BRDF.
    """
    r = np.asarray(roughness, float)
    return 1 - r / (1 + C1 * r) * fon_loss(n_dot_v) / pi


def albedo_eon(n_dot_v, rho, roughness):
    """The albedo of EON: 1 where the facets absorb nothing.

    rho E + rho_ms (1 - E), E = albedo_fon, rho_ms = eon_rho_again

    n_dot_v (...) 0 .. 1, rho (...), roughness (...) r. Returns (...). Errors: none.
    Source: Portsmouth, Kutz and Hill 2025.
    """
    first = albedo_fon(n_dot_v, roughness)
    return rho * first + eon_rho_again(rho, roughness) * (1 - first)


def eon_rho_again(rho, roughness):
    """The share of the light lost by the first bounce that comes out after more of them.

    rho^2 Ebar / (1 - rho (1 - Ebar)), Ebar = K (1 + C2 r), C2 = 2/3 - 28 / (15 pi), the mean albedo of the first bounce

    rho (...) 0 .. 1, roughness (...) r, 0 .. 1. Returns (...): 1 for rho = 1. Errors: none.
    Source: Portsmouth, Kutz and Hill 2025.
    """
    rho, roughness = np.asarray(rho, float), np.asarray(roughness, float)
    lost = roughness * (C1 - C2) / (1 + C1 * roughness)  # 1 - Ebar
    return rho * rho * (1 - lost) / (1 - rho * lost)


def brdf_eon(n, l, v, rho, roughness):
    """The BRDF of a rough diffuse surface that loses no light between its facets.

    rho / pi K (1 + r s / t) + rho_ms / pi (1 - E(n.l)) (1 - E(n.v)) / (1 - Ebar), s = l.v - (n.l)(n.v),
    t = max(n.l, n.v) where s > 0, else 1; K, E, Ebar, rho_ms as in albedo_eon; 0 unless n.l > 0 and n.v > 0.
    The second term is rho_ms / pi K r d(n.l) d(n.v) / (pi^2 (C1 - C2)), d = fon_loss: no difference, and r may be 0

    n, l, v (..., 3) unit vectors, rho (...) albedo of a facet, roughness (...) r, 0 .. 1. Returns (...) 1/sr.
    Errors: none. Source: Portsmouth, Kutz and Hill 2025.
    """
    n_dot_l, n_dot_v, s = _cosines(n, l, v)
    above = (n_dot_l > 0) & (n_dot_v > 0)
    n_dot_l, n_dot_v = (np.where(above, x, 1.0) for x in (n_dot_l, n_dot_v))
    r = np.asarray(roughness, float)
    first = rho * (1 + r * s / np.where(s > 0, np.maximum(n_dot_l, n_dot_v), 1))
    again = eon_rho_again(rho, r) * r * fon_loss(n_dot_l) * fon_loss(n_dot_v) / (pi * pi * (C1 - C2))
    return np.where(above, (first + again) / (pi * (1 + C1 * r)), 0.0)[()]


def brdf_eon_at(theta_l, theta_v, phi, rho, roughness):
    """brdf_eon at angles.

    n = +z, l = light_direction(theta_l, phi), v = view_direction(theta_v)

    theta_l, theta_v, phi (...) rad, rho, roughness (...). Returns (...) 1/sr. Errors: none.
    Source: Portsmouth, Kutz and Hill 2025.
    """
    return brdf_eon(np.array([0.0, 0.0, 1.0]), light_direction(theta_l, phi), view_direction(theta_v), rho, roughness)
