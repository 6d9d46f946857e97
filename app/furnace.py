"""A white furnace: how much of an even light a surface sends on in each direction, for any reflectance.

The integral over the hemisphere is taken on grids that are denser towards a pole: the mirror direction, the eye (light
sent back), and, on halfway vectors, the normal. A first look through all three, down to 1e-5 rad, finds where the light
is, and so how fine each grid must be at its pole. A product rule gives all digits where nothing bends; elsewhere the
grid is cut into tiles, and those again into four where that changes something. Of two grids that are not sure the one
counts that promises the more, for a grid that is too coarse misses light.

Held against the semi-analytic albedo of V-grooves for m from 0.01 to 1: within 1.3e-4 up to 89 degrees, 8e-4 beyond.
What it cannot find: a lobe narrower than about 3 degrees that stands elsewhere, one narrower than 1e-5 rad, and parts
with less than a thousandth of the light.
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
SMOOTH = 2e-6  # where the two agree to this nothing bends; elsewhere tiles:
TILES, MANY, ORDER, ENOUGH, DEEPEST, MOST = 3, 10, 5, 5e-6, 5, 3000  # MANY: near the horizon, where bends are thin
NARROWEST, PART = 2e-5, 1e-3  # rad; the share of the light that lies within the width of a grid
SURE, GRAZING = 2e-4, 1.54  # an error small enough if the first look of the other grid has not seen more; not beyond


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
    round_about = 0.5 if is_even(first["mirror"]) else 1.0
    value, error = np.zeros(len(theta_v)), np.full(len(theta_v), np.inf)
    back = width["eye"] < 0.3 * np.minimum(width["mirror"], width["halfway"])

    def take(at: np.ndarray, fine: np.ndarray, off: np.ndarray) -> None:
        """Of two that differ the one that promises more, for a grid that is too coarse misses light."""
        better = fine - off > value[at] - error[at]
        value[at[better]], error[at[better]] = fine[better], off[better]

    for pole, here in (("eye", back), ("mirror", ~back)):  # at once to the last digits, if nothing bends
        if (at := np.flatnonzero(here)).size:
            coarse, fine = (product(reflect, pole, theta_v[at], width[pole][at], size, round_about)
                            for size in (COARSE, FINE))
            off = np.where(np.isfinite(fine), np.abs(fine - coarse), 0)
            even = (off <= SMOOTH * np.maximum(1.0, first[pole].sum(-1)[at])) | (theta_v[at] > GRAZING)
            take(at[even], fine[even], off[even])
    smooth = SMOOTH
    for pole, here in (("eye", back), ("halfway", ~back), ("mirror", ~back)):
        seen = first[pole].sum(-1)
        sure = (error <= smooth * np.maximum(1.0, seen)) & ((theta_v <= GRAZING) | (smooth < SURE))
        todo = here & (~sure | (seen > 1.15 * value + 0.01))
        for tiles, ones in ((TILES, todo & (theta_v <= GRAZING)), (MANY, todo & (theta_v > GRAZING))):
            if (at := np.flatnonzero(ones)).size:
                size = np.maximum(1.0, seen[at])
                take(at, *refined(reflect, pole, theta_v[at], width[pole][at], size, round_about, tiles))
        smooth = SURE if pole == "halfway" else smooth
    return value, error


def is_even(light: np.ndarray) -> bool:
    """Whether the two sides of the plane of incidence get the same: then one of them is enough."""
    rings = light.reshape(len(light), *FIRST)
    return bool(np.abs(rings - rings[..., ::-1]).max() <= 1e-5 * np.abs(rings).max())


def product(reflect: Reflect, pole: str, theta_v: np.ndarray, width: np.ndarray, size: tuple[int, int],
            round_about: float) -> np.ndarray:
    """The integral by one product rule over all of the square: to the last digits where nothing bends."""
    v, l, weight = grid(pole, theta_v, width, size)
    if round_about < 1:
        half = (rule(*size)[0] < 0.5).nonzero()[0]
        l, weight = l[:, half], 2 * weight[:, half]
    return reflected(reflect, v, l, weight).sum(-1)


def refined(reflect: Reflect, pole: str, theta_v: np.ndarray, width: np.ndarray, size: np.ndarray,
            round_about: float, tiles: int) -> tuple[np.ndarray, np.ndarray]:
    """The integral at each angle and an estimate of its error: tiles of the square (s, t), each cut into four where
    that changes more than ENOUGH of `size`, until it does not."""
    v, (x, y, weight) = direction(theta_v, 0.0)[:, None, :], rule_of_a_tile()

    def sums(at, s, t, high):
        """Of the tiles of this size whose lower corner is (s, t)."""
        s, t = round_about * (s[:, None] + high * x), t[:, None] + high * y
        eye, wide = v[at], width[at, None]
        l, per_node = halves(eye, s, t, wide) if pole == "halfway" else around(
            eye * (-1, -1, 1) if pole == "mirror" else eye, s, t, wide)
        return reflected(reflect, eye, l, high * high * weight * per_node).sum(-1)

    corners = np.arange(tiles) / tiles
    at = np.repeat(np.arange(len(theta_v)), tiles * tiles)
    s, t = np.tile(np.repeat(corners, tiles), len(theta_v)), np.tile(corners, len(theta_v) * tiles)
    high = 1 / tiles
    whole = sums(at, s, t, high)
    value, error = np.zeros(len(theta_v)), np.zeros(len(theta_v))
    for depth in range(DEEPEST + 1):
        high = high / 2
        four = [(s + i * high, t + j * high) for i in (0, 1) for j in (0, 1)]
        parts = np.stack([sums(at, *corner, high) for corner in four])
        change = np.abs(parts.sum(0) - whole)
        change = np.where(np.isfinite(change), change, 0.0)
        again = change > ENOUGH * size[at] if depth < DEEPEST else np.zeros(len(at), bool)
        if again.sum() > MOST:
            again = change >= np.sort(change)[-MOST]
        np.add.at(value, at[~again], parts.sum(0)[~again])
        np.add.at(error, at[~again], change[~again])
        if not again.any():
            break
        s, t = (np.concatenate([corner[k][again] for corner in four]) for k in (0, 1))
        at, whole = np.tile(at[again], 4), parts[:, again].ravel()
    return value, error


@cache
def rule_of_a_tile() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    nodes, weights = gauss_legendre(ORDER)
    x, y = np.meshgrid(nodes, nodes)
    return x.ravel(), y.ravel(), np.outer(weights, weights).ravel()
