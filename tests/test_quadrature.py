"""The Gauss-Legendre rule of the twins: against 30 digits, and on the polynomials it is exact for."""

import mpmath as mp
import numpy as np
import pytest

from app.quadrature import gauss_legendre


@pytest.mark.parametrize("count", [1, 2, 3, 8, 24, 40])
def test_nodes_and_weights(count):
    """numpy's own weights are off by up to 2e-15, these by 3e-16."""
    nodes, weights = gauss_legendre(count)
    with mp.workdps(30):
        for node, weight in zip(nodes, weights, strict=True):
            x = mp.findroot(lambda x: mp.legendre(count, x), 2 * mp.mpf(node) - 1)
            slope = count * (mp.legendre(count - 1, x) - x * mp.legendre(count, x)) / (1 - x * x)
            assert abs(node - (x + 1) / 2) < 2e-16
            assert abs(weight - 1 / ((1 - x * x) * slope**2)) < 3e-16


@pytest.mark.parametrize("count", [1, 2, 4, 8, 12, 32])
def test_it_is_exact_to_its_degree_and_no_further(count):
    nodes, weights = gauss_legendre(count)
    for degree in (0, 1, count, 2 * count - 1):
        assert np.sum(weights * nodes**degree) == pytest.approx(1 / (degree + 1), rel=1e-14)
    if count < 12:  # beyond, the next power is too small to be told from rounding
        assert np.sum(weights * nodes ** (2 * count)) * (2 * count + 1) < 1 - 1e-9
