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


def gauss_node(index, level):
    """A point of a Gauss-Legendre rule on [0, 1], and its weight.

    1, 2, 4 or 8 points at level 0 to 3; beyond, cells with 8 points each

    index (...) int < 2^level, level (...) int. Returns (..., 2); the weights of a level sum to 1. Errors: none.
    Source: Abramowitz and Stegun 1964, 25.4.30.
    """
    rows = np.left_shift(1, level)
    order = np.minimum(rows, 8)
    i, cells = order - 1 + np.asarray(index) % order, np.asarray(rows // order, float)
    return np.stack([(np.asarray(index) // order + _RULE_AT[i]) / cells, _RULE_WEIGHT[i] / cells], -1)


def gauss_sample(index, level):
    """A point of a Gauss-Legendre product rule on the unit square, and its weight.

    (a, b, weight_a weight_b) of gauss_node at index mod 2^level and index div 2^level

    index, level (...) int. Returns (..., 3): s, t, weight; the weights of a level sum to 1. Errors: none.
    Source: Abramowitz and Stegun 1964, 25.4.30.
    """
    index, level = np.broadcast_arrays(index, level)
    rows = np.left_shift(1, level)
    a, b = gauss_node(index % rows, level), gauss_node(index // rows, level)
    return np.stack([a[..., 0], b[..., 0], a[..., 1] * b[..., 1]], -1)


def spread_sample(sampling, level, seed, index):
    """A sample on the unit square, of one of the kinds whose samples all weigh the same.

    0 grid_sample, 1 random_sample, 2 stratified_sample, 3 and more sobol_sample

    sampling, level, seed, index (...) int, index < 4^level. Returns (..., 2). Errors: none.
    Source: deck, Light Contribution of Area Lights (1).
    """
    sampling, level, seed, index = np.broadcast_arrays(sampling, level, seed, index)
    kinds = {0: lambda: grid_sample(index, level), 1: lambda: random_sample(index, seed),
             2: lambda: stratified_sample(index, level, seed), 3: lambda: sobol_sample(index, seed)}
    at = np.zeros((*index.shape, 2))
    for kind in set(np.minimum(sampling, 3).ravel().tolist()):
        at = np.where((np.minimum(sampling, 3) == kind)[..., None], kinds[kind](), at)
    return at


def light_sample(sampling, level, seed, index):
    """A sample on the unit square and its weight, of one of six kinds.

    0 to 4 spread_sample, of weight 1; 5 gauss_sample

    sampling, level, seed, index (...) int, index < 4^level. Returns (..., 3): s, t, weight; the weights of a level sum
    to 4^level. Errors: none. Source: deck, Light Contribution of Area Lights (1).
    """
    sampling, level, seed, index = np.broadcast_arrays(sampling, level, seed, index)
    plain = np.concatenate([spread_sample(sampling, level, seed, index), np.ones((*index.shape, 1))], -1)
    scale = np.stack([np.ones(level.shape), np.ones(level.shape), 4.0**level], -1)
    return np.where((sampling == 5)[..., None], gauss_sample(index, level) * scale, plain)


def concentric_disk(s, t):
    """The point of the unit disk for a point of the unit square: squares become rings, areas stay in proportion.

    a = 2 s - 1, b = 2 t - 1; |a| > |b|: radius a, angle pi/4 b/a; else radius b, angle pi/2 - pi/4 a/b

    s, t (...) in [0, 1]. Returns (..., 2). Errors: none. Source: Shirley and Chiu 1997, A Low Distortion Map Between
    Disk and Square.
    """
    a, b = np.broadcast_arrays(2 * np.asarray(s, float) - 1, 2 * np.asarray(t, float) - 1)
    wide = np.abs(a) > np.abs(b)
    r, other = np.where(wide, a, b), np.where(wide, b, a)
    angle = np.pi / 4 * other / np.where(r == 0, 1, r)
    near, far = r * np.cos(angle), r * np.sin(angle)
    return np.stack([np.where(wide, near, far), np.where(wide, far, near)], -1)
