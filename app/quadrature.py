"""Rules of quadrature on [0, 1]: Gauss-Legendre to the last digit (numpy's own come with all of its polynomials, 25 ms
at start), and one whose every other node is a rule of its own."""

from functools import cache
from math import pi

import numpy as np


@cache
def gauss_legendre(count: int) -> tuple[np.ndarray, np.ndarray]:
    """Nodes and weights, (count,) each: exact for polynomials up to degree 2 count - 1. Newton on the recurrence.

    The lower half of the nodes y in [0, 1] is found from (-1)^k P_k(2 y - 1) = 1 + a sum of steps that carry y as a
    factor, so that a node near 0 has all its digits; the upper half mirrors it.
    """
    y = np.sin(0.5 * pi * (np.arange((count + 1) // 2) + 0.75) / (count + 0.5)) ** 2
    for _ in range(6):
        value, step = np.ones_like(y), np.zeros_like(y)
        for k in range(count):
            step = (k * step - 2 * (2 * k + 1) * y * value) / (k + 1)
            value = value + step
        slope = 0.5 * count * (step - 2 * y * value) / (y * (1 - y))  # the last step is P_n less P_(n-1)
        y = y - value / slope
    half = 1 / (y * (1 - y) * slope**2)
    mirrored = slice(None, None, -1) if count % 2 == 0 else slice(-2, None, -1)
    nodes, weights = np.append(y, 1 - y[mirrored]), np.append(half, half[mirrored])
    weights = weights / weights.sum()
    nodes.flags.writeable = weights.flags.writeable = False
    return nodes, weights


@cache
def nested(count: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Fejer's second rule (1933): nodes, weights, and the weights of every other node alone, (count,) each, count odd.

    y_k = sin^2(k pi / 2 (count + 1)), w_k = (2 sin t_k / (count + 1)) sum_j sin(j t_k) / j over odd j <= count, with
    t_k = k pi / (count + 1): exact for polynomials up to degree count - 1; the ends are no nodes.
    """
    def weights(count: int) -> np.ndarray:
        t, j = np.arange(1, count + 1) * pi / (count + 1), np.arange(1, count + 1, 2)
        return 2 * np.sin(t) / (count + 1) * (np.sin(np.outer(t, j)) / j).sum(-1)

    nodes = np.sin(0.5 * pi * np.arange(1, count + 1) / (count + 1)) ** 2
    every_other = np.zeros(count)
    every_other[1::2] = weights(count // 2)
    return nodes, weights(count), every_other
