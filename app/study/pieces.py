"""The way to an albedo that serves as its exact value: Gauss points around the lobe's axis, cut where integrands bend.

The tilt is cut at the lobe's width times powers of three and where the horizon comes in; the azimuth where the light
sinks below the horizon, and where V-grooves begin to block. Between the cuts all is smooth.
"""

import numpy as np
from numpy import pi

from app.quadrature import gauss_legendre
from app.study.integrals import Integral

POWERS = 3.0 ** np.arange(-1, 10)  # of the width
FLOOR = 1e-3  # below which glTF lets no cosine fall
Pair = tuple[np.ndarray, np.ndarray]


def by_pieces(integral: Integral, nodes: int) -> float:
    """int f n.l dw_l of an integrand that is the same on both sides of the plane of incidence.

    Halfway vectors tilted by a: dw_l = 4 l.h sin a da dphi, a up to 45 degrees + theta_v / 2; or directions around the
    mirror direction: dw_l = sin a da dphi, a up to 90 degrees + theta_v; phi from 0 to pi, twice.
    """
    halves = integral.study.about == "halfway"
    theta, v = integral.theta_v, integral.v
    low, high = tilts(theta, integral.wide, halves)
    a, weight = (x.ravel() for x in ended(low, high, nodes))
    s, c = np.sin(a), np.cos(a)
    edges = azimuths(s, c, theta, halves)
    phi, turn = ended(edges[:-1], edges[1:], nodes)  # (pieces, tilts, nodes)
    seen = np.nonzero(turn)
    phi, sine, cosine = phi[seen], s[seen[1]], c[seen[1]]
    if halves:
        h = np.stack([sine * np.cos(phi), sine * np.sin(phi), cosine], -1)
        l, scale = 2 * (h @ v)[:, None] * h - v, 4 * (h @ v)
    else:
        up = cosine * np.cos(theta) + sine * np.sin(theta) * np.cos(phi)
        along = sine * np.cos(theta) * np.cos(phi) - cosine * np.sin(theta)
        l, scale = np.stack([along, sine * np.sin(phi), up], -1), np.ones_like(phi)
    share = 2 * weight[seen[1]] * turn[seen] * sine * scale * np.maximum(l[:, 2], 0)
    return float(share @ integral.above(l))


def ended(low: np.ndarray, high: np.ndarray, nodes: int) -> Pair:
    """Nodes and weights (..., nodes) of pieces; dense at both ends, where roots begin."""
    x, w = gauss_legendre(nodes)
    wide = np.maximum(high - low, 0)[..., None]
    return low[..., None] + wide * np.sin(0.5 * pi * x) ** 2, 0.5 * pi * w * wide * np.sin(pi * x)


def tilts(theta: float, wide: float, halves: bool) -> Pair:
    """Where the pieces of the tilt begin and end."""
    quarter = 0.25 * pi
    end = quarter + theta / 2 if halves else 2 * quarter + theta
    bends = (quarter - theta / 2, 2 * quarter - theta, theta, (2 * quarter - theta) / 3, (2 * quarter + theta) / 3,
             quarter, 2 * quarter, end - FLOOR / 2, quarter - theta / 2 - FLOOR / 2, 1.5 * wide, *(wide * POWERS))
    edges = np.unique(np.clip([0.0, *bends, end], 0.0, end))
    edges = edges[np.append(True, np.diff(edges) > 1e-12 * end)]
    return edges[:-1], edges[1:]


def azimuths(s: np.ndarray, c: np.ndarray, theta: float, halves: bool) -> np.ndarray:
    """The ends (pieces + 1, N) of the pieces of the azimuth for each tilt: by u = l.h; the horizon is the last."""
    n_dot_v, side = np.cos(theta), np.maximum(s * np.sin(theta), 1e-300)
    if not halves:
        return np.stack([0 * s, np.arccos(np.clip(-c * n_dot_v / side, -1, 1))])
    below = 4 * c * c - 1
    bends = (0.5 * n_dot_v / c, 0.5 * (n_dot_v + FLOOR) / c, n_dot_v / c, 2 * c * n_dot_v,
             2 * c * n_dot_v / np.where(below > 0, below, 1))
    phi = np.arccos(np.clip((np.stack(bends) - c * n_dot_v) / side, -1, 1))
    return np.concatenate([0 * s[None], np.sort(np.minimum(phi[1:], phi[0]), 0), phi[:1]])
