"""Points of the unit square, and their weights: random, in cells, spread evenly, of a Gauss rule.

Each takes how many are wanted and a seed, and returns (N, 2) points with weights (N,) that sum to 1; N is near what was
asked for. One dimension is the first column alone, where `line` has another way to it.
"""

from collections.abc import Callable
from functools import cache
from math import isqrt

import numpy as np

from app.quadrature import gauss_legendre

Points = tuple[np.ndarray, np.ndarray]
GOLDEN = 0.5 * (5**0.5 - 1)
FURTHEST = 170  # Laguerre's weights are below 1e-290 beyond


def even(points: np.ndarray) -> Points:
    return points, np.full(len(points), 1 / len(points))


def random(count: int, seed: int) -> Points:
    return even(np.random.default_rng(seed).random((count, 2)))


def jittered(count: int, seed: int) -> Points:
    """One anywhere in each of k x k cells (Cook, Porter, Carpenter 1984)."""
    k = max(1, isqrt(count))
    cell = np.stack(np.meshgrid(np.arange(k), np.arange(k), indexing="ij"), -1).reshape(-1, 2)
    return even((cell + np.random.default_rng(seed).random((k * k, 2))) / k)


def sobol(count: int, seed: int) -> Points:
    """Owen-scrambled Sobol points; the count becomes a power of two."""
    from scipy.stats import qmc

    power = max(0, round(np.log2(count)))
    return even(qmc.Sobol(2, scramble=True, rng=seed).random_base2(power))


def fibonacci(count: int, seed: int) -> Points:
    i = np.arange(count)
    return even(np.stack([(i + 0.5) / count, (i * GOLDEN) % 1], -1))


def gauss(count: int, seed: int) -> Points:
    """Gauss-Legendre along the first side, even steps along the second, which goes around: k x k."""
    return across(*gauss_legendre(max(1, isqrt(count))))


def tiles(rows: int, seed: int) -> Points:
    """The middles of tiles: this many along the first side, four times as many around."""
    s, t = np.meshgrid((np.arange(rows) + 0.5) / rows, (np.arange(4 * rows) + 0.5) / (4 * rows), indexing="ij")
    return even(np.stack([s, t], -1).reshape(-1, 2))


def laguerre(count: int, seed: int) -> Points:
    """Gauss-Laguerre for a lobe e^-t with t = -log(1 - xi_1), even steps around: at least 8, and twice the nodes."""
    return across(*laguerre_rule(max(1, min(FURTHEST, round((count / 2) ** 0.5)))))


@cache
def laguerre_rule(count: int) -> Points:
    from scipy.special import roots_laguerre

    t, weights = roots_laguerre(count)
    return -np.expm1(-t), weights / weights.sum()


def across(nodes: np.ndarray, weights: np.ndarray) -> Points:
    """A rule along the first side times as many even steps along the second (at least 8)."""
    steps = max(8, len(nodes))  # a quarter off, so that both sides of a symmetric lobe are not the same points twice
    s, t = np.meshgrid(nodes, (np.arange(steps) + 0.25) / steps, indexing="ij")
    return np.stack([s, t], -1).reshape(-1, 2), np.repeat(weights / steps, steps)


# --- on a line ---------------------------------------------------------------------------------------------------
def line_random(count: int, seed: int) -> Points:
    return random(count, seed)


def line_jittered(count: int, seed: int) -> Points:
    place = np.arange(count) + np.random.default_rng(seed).random(count)
    return even(np.stack([place, place], -1) / count)


def line_middles(count: int, seed: int) -> Points:
    place = (np.arange(count) + 0.5) / count
    return even(np.stack([place, place], -1))


def line_gauss(count: int, seed: int) -> Points:
    nodes, weights = gauss_legendre(count)
    return np.stack([nodes, nodes], -1), weights


def line_segments(count: int, seed: int, pieces: int = 80) -> Points:
    """Gauss-Legendre in each of the 80 steps of 5 nm between 380 and 780 nm in which V is straight."""
    nodes, weights = gauss_legendre(max(1, count // pieces))
    place = ((np.arange(pieces)[:, None] + nodes) / pieces).ravel()
    return np.stack([place, place], -1), np.tile(weights / pieces, pieces)


SQUARE: dict[str, Callable[[int, int], Points]] = {
    "random": random, "jittered": jittered, "sobol": sobol, "fibonacci": fibonacci, "gauss": gauss,
    "laguerre": laguerre, "tiles": tiles}
LINE: dict[str, Callable[[int, int], Points]] = {
    "random": line_random, "jittered": line_jittered, "middles": line_middles, "gauss": line_gauss,
    "segments": line_segments}
RANDOM = {"random", "jittered", "sobol"}  # differ from seed to seed
