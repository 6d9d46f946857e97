"""Gauss-Legendre rules on [0, 1], to the last digit: numpy's own come with all of its polynomials, 25 ms at start."""

from functools import cache
from math import pi

import numpy as np


@cache
def gauss_legendre(count: int) -> tuple[np.ndarray, np.ndarray]:
    """Nodes and weights, (count,) each: exact for polynomials up to degree 2 count - 1. Newton on the recurrence."""
    x = -np.cos(pi * (np.arange(count) + 0.75) / (count + 0.5))
    for _ in range(6):
        before, now = np.ones(count), x
        for k in range(2, count + 1):
            before, now = now, ((2 * k - 1) * x * now - (k - 1) * before) / k
        slope = count * (before - x * now) / ((1 - x) * (1 + x))
        x = x - now / slope
    weights = 1 / ((1 - x) * (1 + x) * slope**2)
    nodes, weights = 0.5 * (x + 1), weights / weights.sum()
    nodes.flags.writeable = weights.flags.writeable = False
    return nodes, weights
