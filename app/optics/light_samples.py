"""Points (s, t) of the unit square for samples of a light: fixed, random, stratified, Sobol, Gauss-Legendre."""

import numpy as np

from app.quadrature import gauss_legendre

_RULE_AT, _RULE_WEIGHT = (np.concatenate(parts) for parts in zip(*map(gauss_legendre, (1, 2, 4, 8)), strict=True))
_GOLDEN, _STEP = np.uint32(2654435769), np.uint32(747796405)


def _uint(x):
    return np.asarray(x).astype(np.int64).astype(np.uint32)


def random_number(index, seed):
    """A number that looks random: the same for the same index and seed, on every machine.

    pcg hash of 747796405 index + 2654435769 seed + 2891336453 in 32-bit integers; its upper 24 bits over 2^24

    index, seed (...) int. Returns (...) in [0, 1). Errors: none, both arithmetics are exact.
    Source: Jarzynski and Olano 2020, Hash Functions for GPU Rendering, pcg.
    """
    with np.errstate(over="ignore"):
        state = _uint(index) * _STEP + _uint(seed) * _GOLDEN + np.uint32(2891336453)
        word = ((state >> ((state >> np.uint32(28)) + np.uint32(4))) ^ state) * np.uint32(277803737)
    return (((word >> np.uint32(22)) ^ word) >> np.uint32(8)) / 2.0**24


def _cell(index, level):
    rows = np.left_shift(1, level)
    return np.stack(np.broadcast_arrays(index % rows, index // rows), -1), np.asarray(rows, float)[..., None]


def grid_sample(index, level):
    """The middle of a cell of the unit square, cut into 2^level x 2^level.

    ((index mod rows) + 1/2, (index div rows) + 1/2) / rows, rows = 2^level

    index, level (...) int. Returns (..., 2). Errors: none. Source: deck, Light Contribution of Area Lights (1).
    """
    cell, rows = _cell(np.asarray(index), level)
    return (cell + 0.5) / rows


def random_sample(index, seed):
    """A point anywhere in the unit square.

    (random_number(2 index), random_number(2 index + 1))

    index, seed (...) int. Returns (..., 2). Errors: none. Source: deck, Light Contribution of Area Lights (1).
    """
    index = np.asarray(index)
    return np.stack(np.broadcast_arrays(random_number(2 * index, seed), random_number(2 * index + 1, seed)), -1)


def stratified_sample(index, level, seed):
    """A point anywhere in its own cell of the unit square, cut into 2^level x 2^level.

    (cell + random_sample) / 2^level

    index, level, seed (...) int. Returns (..., 2). Errors: none. Source: Cook, Porter, Carpenter 1984 (jittering).
    """
    cell, rows = _cell(np.asarray(index), level)
    return (cell + random_sample(index, seed)) / rows


def sobol_sample(index, seed):
    """A point of Sobol's first two dimensions, a (0,2)-sequence: every 4^k points put one into each of 2^k x 2^k cells.

    The bits of index reversed, and the same through the direction numbers v_(j+1) = v_j xor (v_j >> 1); all
    exclusive-or a number made of the seed, which keeps the property. 24 bits are kept.

    index, seed (...) int. Returns (..., 2) in [0, 1). Errors: none; seed 0 is the sequence as it is.
    Source: Kollig and Keller 2002, Efficient Multidimensional Sampling.
    """
    index, seed = np.broadcast_arrays(_uint(index), _uint(seed))
    x, y = np.zeros_like(index), np.zeros_like(index)
    v = np.uint32(1 << 31)
    for j in range(17):  # indices below 2^17
        odd = (index >> np.uint32(j)) & np.uint32(1)
        x = x ^ odd * np.uint32(1 << (31 - j))
        y = y ^ odd * v
        v = v ^ (v >> np.uint32(1))
    with np.errstate(over="ignore"):
        flip = seed * _GOLDEN
        flipped = x ^ flip, y ^ (flip * _STEP)
    return np.stack([word >> np.uint32(8) for word in flipped], -1) / 2.0**24


def gauss_sample(index, level):
    """A point of a Gauss-Legendre product rule on the unit square, and its weight.

    1, 2, 4 or 8 points a side at level 0 to 3; beyond, cells with 8 x 8 points each

    index, level (...) int. Returns (..., 3): s, t, weight; the weights of a level sum to 1. Errors: none.
    Source: Abramowitz and Stegun 1964, 25.4.30.
    """
    rows = np.left_shift(1, level)
    order = np.minimum(rows, 8)
    i, j = np.broadcast_arrays(index % rows, index // rows)
    cells = np.asarray(rows // order, float)
    at, place = zip(*((order - 1 + k % order, k // order) for k in (i, j)), strict=True)
    s, t = ((p + _RULE_AT[a]) / cells for p, a in zip(place, at, strict=True))
    return np.stack([s, t, _RULE_WEIGHT[at[0]] * _RULE_WEIGHT[at[1]] / cells**2], -1)
