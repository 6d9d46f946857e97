"""Facet distributions and the Cook-Torrance BRDF: identities, second ways, limits, and the deck's slips measured."""

import numpy as np
import pytest
from scipy.integrate import quad

from app import shader
from app.badges import check
from app.gpu.evaluate import evaluate
from app.optics import twin
from app.optics.spherical import direction

N = np.array([0.0, 0.0, 1.0])
BRDFS = {"brdf_cook_torrance": 4, "brdf_cook_torrance_printed": np.pi, "brdf_cook_torrance_smith": 4, "brdf_ggx": 4}


def pairs(count: int = 4000):
    rng = np.random.default_rng(5)
    theta = np.arccos(rng.uniform(0, 1, (2, count)))
    return direction(theta[0], rng.uniform(-np.pi, np.pi, count)), direction(theta[1], 0.0)


@pytest.mark.parametrize("ndf", range(4))
@pytest.mark.parametrize("m", [1.0, 0.5, 0.1, 0.01, 1e-4])
def test_every_distribution_covers_the_plate_once(ndf, m):
    """int D cos a dw = 2 pi int D s / (1 + s^2)^2 ds, s = tan a = m x."""
    def density(x):
        return 2 * np.pi * m * m * x * twin("d_lean")(ndf, x, m) / (1 + (m * x) ** 2) ** 2

    total = sum(quad(density, *ends, epsabs=1e-12, limit=200)[0] for ends in ((0, 3), (3, 40), (40, np.inf)))
    assert total == pytest.approx(1, abs=1e-8)


def test_the_rings_find_what_theory_says():
    area = twin("facet_area")
    assert area(np.arange(4), 0.3, 4000, 1) == pytest.approx(np.ones(4), abs=1e-4)
    assert float(area(2, 0.5, 9000, 0)) == pytest.approx(1.113, abs=5e-4)  # the facets' own area
    assert float(area(2, 1.0, 9000, 0)) == pytest.approx(1.379, abs=5e-4)
    assert float(twin("facet_area_of_lobe")(np.sqrt(2 / 12))) == pytest.approx(0.349, abs=5e-4)  # exponent 10
    assert float(twin("facet_area_of_lobe")(np.sqrt(2 / 102))) == pytest.approx(0.260, abs=5e-4)  # exponent 100


def test_the_lobes_are_equally_wide():
    m = np.geomspace(1e-4, 1, 9)
    assert np.allclose(twin("m_from_exponent")(twin("exponent_from_m")(m)), m, rtol=1e-12)
    small = twin("d_lean")(np.arange(3)[:, None], np.array([0.0, 0.5, 1.0, 2.0]), 1e-3) * np.pi * 1e-6
    assert np.allclose(small, np.exp(-np.array([0.0, 0.25, 1.0, 4.0])), rtol=1e-4)
    tail, ggx = twin("d_lean")(np.array([2, 3]), 4.0, 0.1)
    assert ggx > 1e4 * tail


@pytest.mark.parametrize(("m", "least"), [(1e-2, 1e-4), (1e-3, 1e-2), (1e-4, 0.5)])
def test_the_printed_forms_lose_their_digits_in_float32(m, least, ctx):
    args = {"slope_ratio": np.linspace(0.3, 2.0, 200), "m": m}
    exact = twin("d_beside")(**args)
    off = {name: np.max(np.abs(evaluate(name, args, ctx=ctx) / exact - 1))
           for name in ("d_beside", "d_beside_naive", "d_beside_acos_naive")}
    assert off["d_beside"] < 2e-6
    assert min(off["d_beside_naive"], off["d_beside_acos_naive"]) > least


def test_the_lost_minus():
    right, printed = (float(twin(f)(*args)) for f, args in (
        ("d_at", (2, np.radians(10), 0.1)), ("d_beckmann_printed", (np.radians(10), 0.1))))
    assert right == pytest.approx(1.51, abs=0.005) and printed == pytest.approx(758, abs=0.5)


@pytest.mark.parametrize("m", [1.0, 0.3, 0.05])
def test_the_brdf_is_its_three_factors(m):
    l, v = pairs()
    s = l + v
    h = s / np.linalg.norm(s, axis=-1, keepdims=True)
    n_dot_l, n_dot_v, n_dot_h, l_dot_h = l[:, 2], v[:, 2], h[:, 2], np.sum(l * h, -1)
    d, f = twin("d_beckmann")(N, h, m), twin("f_schlick")(l_dot_h, 0.3)
    product = d * twin("g_vgroove")(n_dot_h, n_dot_v, n_dot_l, l_dot_h) * f / (4 * n_dot_l * n_dot_v)
    assert np.allclose(twin("brdf_cook_torrance")(N, l, v, m, 0.3), product, rtol=1e-9, atol=1e-300)
    assert np.allclose(twin("cook_torrance_dg")(N, l, v, m) * f, product, rtol=1e-9, atol=1e-300)
    smith = d * twin("g_smith_correlated")(n_dot_v, n_dot_l, m) * f / (4 * n_dot_l * n_dot_v)
    assert np.allclose(twin("brdf_cook_torrance_smith")(N, l, v, m, 0.3), smith, rtol=1e-9, atol=1e-300)
    ggx = twin("d_ggx")(N, h, m) * twin("g_smith_correlated_ggx")(n_dot_v, n_dot_l, m) * f / (4 * n_dot_l * n_dot_v)
    assert np.allclose(twin("brdf_ggx")(N, l, v, m, 0.3), ggx, rtol=1e-9, atol=1e-300)


@pytest.mark.parametrize("name", BRDFS)
def test_a_brdf_is_reciprocal_and_dark_below_the_horizon(name):
    l, v = pairs()
    f = twin(name)
    assert np.allclose(f(N, l, v, 0.4, 0.2), f(N, v, l, 0.4, 0.2), rtol=1e-13, atol=0)
    down = np.array([1, 1, -1])
    assert not np.any(f(N, l * down, v, 0.4, 0.2)) and not np.any(f(N, l, v * down, 0.4, 0.2))
    turn = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    assert np.allclose(f(N, l @ turn, v @ turn, 0.4, 0.2), f(N, l, v, 0.4, 0.2), rtol=1e-13)


@pytest.mark.parametrize("name", BRDFS)
def test_extremes_are_finite_in_both_arithmetics(name, ctx):
    cosine = np.array([0.0, 1e-30, 1e-7, 1e-3, 0.3, 1 - 1e-7, 1.0])
    theta = np.arccos(cosine)
    l = direction(theta[:, None, None, None], np.array([0.0, 1.0, np.pi])[:, None, None])
    v = direction(theta[:, None], 0.0)
    m = np.array([0.0, 1e-9, 1e-5, 1e-3, 1.0, 10.0])
    width = "alpha" if name == "brdf_ggx" else "m"
    for some_l in (l, -v, v):
        for f0 in (0.0, 0.04, 1.0):
            value = twin(name)(N, some_l, v, m, f0)
            assert np.all(np.isfinite(value)) and np.all(value >= 0)
            here = evaluate(name, {"n": N, "l": some_l, "v": v, width: m, "f0": f0}, ctx=ctx)
            assert np.all(here >= 0) and not np.any(np.isnan(here))
            assert np.all(np.isfinite(here) | (value > 1e37))


@pytest.mark.parametrize("theta_v", [0.0, 0.5, 1.0, 1.4])
@pytest.mark.parametrize("m", [1.0, 0.3])
def test_albedos_are_the_integral_over_light(theta_v, m):
    """A product rule over the directions of l; creases of G cost it the fifth digit."""
    t, weight = (0.5 * (x + shift) for x, shift in zip(np.polynomial.legendre.leggauss(300), (1, 0), strict=True))
    mu, phi = t * t, np.pi * t
    l = direction(np.arccos(mu)[:, None], phi)
    measure = (weight * 2 * t * mu)[:, None] * (2 * np.pi * weight)
    for brdf, oracle in (("brdf_cook_torrance", "albedo_cook_torrance"), ("brdf_ggx", "albedo_ggx")):
        for f0 in (1.0, 0.04):
            total = np.sum(twin(brdf)(N, l, direction(theta_v, 0.0), m, f0) * measure)
            assert float(twin(oracle)(theta_v, m, f0)) == pytest.approx(total, rel=1e-4)


def test_the_albedo_of_ggx_head_on_in_closed_form():
    """1 - ln 2 at alpha = 1, where G is 2 / (1 + 1 / n.l) and all is elementary."""
    assert float(twin("albedo_ggx")(0.0, 1.0, 1.0)) == pytest.approx(1 - np.log(2), rel=1e-13)


def test_the_albedo_in_numbers():
    """Three values of the design's own derivation; arrays agree with single values; polished is 1."""
    albedo = twin("albedo_cook_torrance")
    for args, value in (((0.7, 0.4, 1.0), 0.919767901032), ((0.7, 0.4, 0.04), 0.039608415130),
                        ((1.2, 0.15, 0.04), 0.130085906108)):
        assert float(albedo(*args)) == pytest.approx(value, abs=1e-12)
    theta, m = np.meshgrid(np.linspace(0, 1.55, 7), [1.0, 0.3, 0.01])
    assert np.allclose(albedo(theta, m, 0.5), np.vectorize(albedo)(theta, m, 0.5), rtol=1e-13)
    assert np.allclose(albedo(np.linspace(0, 1.396, 9), 1e-4, 1.0), 1, atol=1e-12)


def test_the_right_form_keeps_the_light_and_the_printed_one_makes_some():
    theta, m = np.meshgrid(np.linspace(0, np.pi / 2, 60), [10, 3, 1, 0.8, 0.5, 0.3, 0.1, 0.03, 0.01, 1e-3, 1e-4])
    assert np.max(twin("albedo_cook_torrance")(theta, m, 1.0)) <= 1 + 2e-9
    printed = twin("albedo_cook_torrance_printed")(theta, m, 1.0)
    assert np.all(np.max(printed[1:], -1) > 1) and np.max(printed) < 1.2733
    assert float(twin("albedo_cook_torrance_printed")(np.radians(60), 0.3, 1.0)) == pytest.approx(1.1774, abs=5e-5)


@pytest.mark.parametrize(("name", "m", "energy", "ok"), [
    ("brdf_cook_torrance", 0.1, 1.0, True), ("brdf_cook_torrance", 1.0, 1.0, True),
    ("brdf_cook_torrance_printed", 0.1, 1.2732, False), ("brdf_cook_torrance_printed", 1.0, 1.273, False),
    ("brdf_cook_torrance_smith", 0.3, 1.0, True), ("brdf_ggx", 0.3, 0.984, True)])
def test_badges_are_green_and_red_where_theory_says(name, m, energy, ok):
    badges = check(lambda n, l, v: twin(name)(n, l, v, m, 1.0))
    assert {key: badge.ok for key, badge in badges.items()} == {
        "non_negative": True, "reciprocal": True, "energy": ok, "finite": True, "linear": True}
    assert badges["energy"].worst == pytest.approx(energy, abs=1e-2)


def test_the_pictures_furnace_is_within_two_hundredths(ctx):
    theta, m = np.meshgrid(np.linspace(0, 1.45, 20), [0.05, 0.2, 0.4, 0.7, 1.0])
    got = evaluate("furnace_beckmann", {"n_dot_v": np.cos(theta), "m": m}, shader.read("display/furnace.glsl"), ctx)
    assert np.max(np.abs(got - twin("albedo_cook_torrance")(theta, m, 1.0))) < 0.02
