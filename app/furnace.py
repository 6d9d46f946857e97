"""A white furnace: how much of an even light a surface sends on in each direction, for any reflectance.

The integral over the hemisphere is a product rule (Gauss-Legendre along great circles, even steps around) on grids that
are denser towards a pole: the mirror direction, the eye (light sent back), and, on halfway vectors, the normal. A first
look through all three, down to 1e-5 rad, finds where the light is, and so how fine each grid must be at its pole. If
the first is not sure, the one counts that promises the most: its sum less the difference of its two resolutions, for a
grid that is too coarse misses light. What it cannot find: a lobe narrower than about 3 degrees that
stands elsewhere, one narrower than 1e-5 rad, and parts with less than a thousandth of the light.
"""

from collections.abc import Callable
from functools import cache, lru_cache

import numpy as np

from app.hemisphere import NORMAL, around, halves
from app.optics.spherical import direction
from app.quadrature import gauss_legendre

Reflect = Callable[[np.ndarray, np.ndarray, np.ndarray], np.ndarray]  # f(n, l, v) in 1/sr, vectors (..., 3)
POLES = ("mirror", "halfway", "eye")
FIRST, COARSE, FINE = (32, 16), (32, 48), (48, 64)  # nodes along and around
NARROWEST, PART = 2e-5, 1e-3  # rad; the share of the light that lies within the width of a grid
SURE, GRAZING = 2e-4, 1.3  # an error small enough if the first look of the other grid has not seen more; not beyond


@cache
def rule(along: int, around: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """s, t and weights of a product rule on the unit square, t first."""
    nodes, weights = gauss_legendre(along)
    s, t = np.meshgrid((np.arange(around) + 0.5) / around, nodes)
    return s.ravel(), t.ravel(), np.repeat(weights, around) / around


def grid(pole: str, theta_v: np.ndarray, width, size: tuple[int, int]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """v (angles, 1, 3), directions l (angles, nodes, 3) and their weights, of an integral over solid angle."""
    v = direction(theta_v, 0.0)[:, None, :]
    s, t, weight = rule(*size)
    width = np.broadcast_to(width, theta_v.shape)[:, None]
    if pole == "halfway":
        l, per_node = halves(v, s, t, width)
    else:
        l, per_node = around(v * (-1, -1, 1) if pole == "mirror" else v, s, t, width)
    return v, l, weight * per_node


@lru_cache(16)
def first_look(theta_v: tuple[float, ...]) -> dict[str, tuple[np.ndarray, np.ndarray, np.ndarray]]:
    """The grids of the first look: the same for every reflectance."""
    return {pole: grid(pole, np.array(theta_v), NARROWEST, FIRST) for pole in POLES}


def reflected(reflect: Reflect, v: np.ndarray, l: np.ndarray, weight: np.ndarray) -> np.ndarray:
    """The light of each node (angles, nodes): f n.l dw; what is not finite counts nothing here."""
    with np.errstate(all="ignore"):
        f = np.broadcast_to(np.asarray(reflect(NORMAL, l, v), float), l.shape[:-1])
    return np.where((weight > 0) & np.isfinite(f), f * np.maximum(l[..., 2], 0) * weight, 0.0)


def widths(light: np.ndarray) -> np.ndarray:
    """How near to its pole (rad) a first look finds the first thousandth of the light, for each angle."""
    rings = np.abs(light).reshape(len(light), *FIRST).sum(-1).cumsum(-1)
    t = rule(*FIRST)[1].reshape(FIRST)[:, 0]
    found = [np.interp(PART, ring / ring[-1], t) if 0 < ring[-1] < np.inf else 1.0 for ring in rings]
    return np.clip(NARROWEST * np.sinh(np.array(found) * np.arcsinh(0.5 * np.pi / NARROWEST)), 1e-6, 1.0)


def albedo(reflect: Reflect, theta_v) -> tuple[np.ndarray, np.ndarray]:
    """int f n.l dw over the hemisphere at each angle theta_v (angles,) of the eye, and an estimate of its error."""
    with np.errstate(over="ignore", invalid="ignore"):  # sums beyond the largest float are infinite
        return summed(reflect, theta_v)


def summed(reflect: Reflect, theta_v) -> tuple[np.ndarray, np.ndarray]:
    theta_v = np.atleast_1d(np.asarray(theta_v, float))
    first = {pole: reflected(reflect, *nodes) for pole, nodes in first_look(tuple(theta_v.tolist())).items()}
    width = {pole: widths(light) for pole, light in first.items()}
    value, error = np.zeros(len(theta_v)), np.full(len(theta_v), np.inf)
    back = width["eye"] < 0.3 * np.minimum(width["mirror"], width["halfway"])
    for pole, here in (("eye", back), ("mirror", ~back), ("halfway", ~back)):
        seen = first[pole].sum(-1)
        at = np.flatnonzero(here & ((error > SURE) | (theta_v > GRAZING) | (seen > 1.15 * value + 0.01)))
        if not at.size:
            continue
        coarse, fine = (reflected(reflect, *grid(pole, theta_v[at], width[pole][at], size)).sum(-1)
                        for size in (COARSE, FINE))
        off = np.where(np.isfinite(fine), np.abs(fine - coarse), 0)
        better = fine - off > value[at] - error[at]
        value[at[better]], error[at[better]] = fine[better], off[better]
    return value, error
