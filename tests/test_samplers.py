"""Samplers draw what their densities say: chi-squared, by the directions and, for narrow lobes, by the facets."""

import numpy as np
import pytest
from scipy import stats

from app.optics import twin
from app.optics.spherical import direction

COUNT = 100_000
NODES, WEIGHTS = np.polynomial.legendre.leggauss(12)
WIDTHS = 1.0, 0.3, 0.1, 0.01, 1e-4
FACETS = {  # a sampler of facets, its distribution of the slope, the density of the mirrored light
    "sample_beckmann": ("d_beckmann_slope", "pdf_beckmann"),
    "sample_ggx": ("d_ggx_slope", "pdf_ggx"),
}
CASES = [(name, width) for name in FACETS for width in WIDTHS]
LIGHT = [(name, width, theta) for name in FACETS for width in (1.0, 0.3, 0.1) for theta in (0.0, 0.8, 1.3)]
LOBES = 0.0, 5.0, 80.0, 3000.0, 1e7  # exponents
LEVEL = 1 - (1 - 0.01) ** (1 / (len(CASES) + len(LIGHT) + 8))  # Sidak: 1 in 100 for all of them


def chi_squared(found: np.ndarray, expected: np.ndarray) -> float:
    """The chance of a deviation as large as this one; bins that expect fewer than 5 are put together."""
    found, expected = found.ravel(), expected.ravel()
    small = expected < 5
    found = np.append(found[~small], found[small].sum())
    expected = np.append(expected[~small], expected[small].sum())
    if expected[-1] < 5:
        found, expected = np.append(found[:-2], found[-2:].sum()), np.append(expected[:-2], expected[-2:].sum())
    return float(stats.chi2.sf(np.sum((found - expected) ** 2 / expected), len(expected) - 1))


def random(seed: int) -> tuple[np.ndarray, np.ndarray]:
    xi_1, xi_2 = np.random.default_rng(seed).random((2, COUNT))
    return xi_1, xi_2


def by_facets(h: np.ndarray, distribution, width: float) -> float:
    """Bins in x = tan a / width and the azimuth: a lobe of any width fills them. The integral of D cos a in each."""
    edges = np.concatenate([np.linspace(0, 2.4, 13), [3, 5, 9, 1e9]])
    x, turn = np.hypot(h[:, 0], h[:, 1]) / h[:, 2] / width, np.arctan2(h[:, 1], h[:, 0]) % (2 * np.pi)
    found = np.histogram2d(x, turn, [edges, np.linspace(0, 2 * np.pi, 13)])[0]
    middle = 0.5 * (edges[1:-1] + edges[:-2])[:, None] + 0.5 * np.diff(edges[:-1])[:, None] * NODES
    slope = middle * width
    density = 2 * np.pi * slope * width * distribution(slope**2, width) / (1 + slope**2) ** 2
    share = np.sum(0.5 * np.diff(edges[:-1])[:, None] * WEIGHTS * density, -1)
    expected = np.append(share, 1 - share.sum())[:, None] * COUNT * np.full(12, 1 / 12)
    return chi_squared(found, expected)


def by_light(h: np.ndarray, density, theta_v: float) -> float:
    """10 x 20 bins of the light that v sees mirrored (Nori's), and one for what goes below the horizon."""
    n, v = np.array([0.0, 0.0, 1.0]), direction(theta_v, 0.0)
    seen = 2 * np.sum(h * v, -1, keepdims=True) * h - v
    seen = seen[(seen[:, 2] > 0) & (np.sum(h * v, -1) > 0)]
    turn = np.arctan2(seen[:, 1], seen[:, 0]) % (2 * np.pi)
    cosines, turns = np.linspace(0, 1, 11), np.linspace(0, 2 * np.pi, 21)
    found = np.histogram2d(seen[:, 2], turn, [cosines, turns])[0]
    fine = 3  # cells of a bin
    c, w_c = cells(0, 1, 10 * fine)
    p, w_p = cells(0, 2 * np.pi, 20 * fine)
    value = density(n, direction(np.arccos(c)[:, None], p), v) * w_c[:, None] * w_p
    per = 12 * fine
    expected = COUNT * value.reshape(10, per, 20, per).sum((1, 3))
    outside = COUNT - expected.sum()
    return chi_squared(np.append(found, COUNT - found.sum()), np.append(expected, outside))


def cells(low: float, high: float, count: int) -> tuple[np.ndarray, np.ndarray]:
    half = 0.5 * (high - low) / count
    middle = low + half * (2 * np.arange(count) + 1)
    return (middle[:, None] + half * NODES).ravel(), np.tile(half * WEIGHTS, count)


@pytest.mark.parametrize(("name", "width"), CASES)
def test_facets_are_drawn_as_their_distribution_says(name, width):
    h = twin(name)(*random(1), width)
    assert np.allclose(np.linalg.norm(h, axis=-1), 1)
    assert by_facets(h, twin(FACETS[name][0]), width) > LEVEL


@pytest.mark.parametrize(("name", "width", "theta_v"), LIGHT)
def test_light_is_drawn_as_its_density_says(name, width, theta_v):
    density = twin(FACETS[name][1])
    assert by_light(twin(name)(*random(2), width), lambda n, l, v: density(n, l, v, width), theta_v) > LEVEL


@pytest.mark.parametrize("exponent", LOBES)
def test_facets_of_the_cosine_lobe(exponent):
    h, lobe = twin("sample_blinn_phong")(*random(1), exponent), twin("d_blinn_phong_slope")
    assert by_facets(h, lambda slope2, _: lobe(slope2, exponent), np.sqrt(2 / (exponent + 2))) > LEVEL


@pytest.mark.parametrize(("exponent", "theta_v"), [(0.0, 0.4), (5.0, 1.2), (80.0, 0.8)])
def test_light_of_the_cosine_lobe(exponent, theta_v):
    h, density = twin("sample_blinn_phong")(*random(2), exponent), twin("pdf_blinn_phong")
    assert by_light(h, lambda n, l, v: density(n, l, v, exponent), theta_v) > LEVEL


WRONG = {  # a mistake in a sampler
    "no root": lambda xi_1, xi_2, m: slanted(-m * m * np.log1p(-xi_1), xi_2),
    "3 % too wide": lambda xi_1, xi_2, m: twin("sample_beckmann")(xi_1, xi_2, 1.03 * m),
    "half of the turn": lambda xi_1, xi_2, m: twin("sample_beckmann")(xi_1, 0.5 * xi_2, m),
    "D without the cosine": lambda xi_1, xi_2, m: slanted(m * np.sqrt(-np.log1p(-xi_1)) * (1 + 0.2 * xi_1), xi_2),
    "the other distribution": twin("sample_ggx"),
}


def slanted(slope, xi_2):
    h = np.stack([slope * np.cos(2 * np.pi * xi_2), slope * np.sin(2 * np.pi * xi_2), np.ones_like(slope)], -1)
    return h / np.linalg.norm(h, axis=-1, keepdims=True)


@pytest.mark.parametrize("mistake", WRONG)
def test_a_wrong_sampler_is_found(mistake):
    h = WRONG[mistake](*random(3), 0.3)
    assert by_facets(h, twin("d_beckmann_slope"), 0.3) < 1e-6
    assert by_light(h, lambda n, l, v: twin("pdf_beckmann")(n, l, v, 0.3), 0.8) < 1e-6
    assert by_facets(WRONG["3 % too wide"](*random(3), 1e-4), twin("d_beckmann_slope"), 1e-4) < 1e-6
