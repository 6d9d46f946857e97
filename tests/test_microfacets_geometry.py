"""Grooves: the closed forms against counted rays and against Blinn's formula in three dimensions."""

import numpy as np
import pytest

from app.optics import twin

RNG = np.random.default_rng(5)


def directions(count: int) -> np.ndarray:
    """(count, 3): unit vectors of the upper hemisphere."""
    d = RNG.normal(size=(count, 3))
    d[:, 2] = np.abs(d[:, 2])
    return d / np.linalg.norm(d, axis=-1, keepdims=True)


# --- one groove ------------------------------------------------------------------------------------------------------
def test_what_is_hidden_is_what_rays_count():
    facet, lean, other = RNG.uniform(-1.4, 1.4, (3, 300))
    samples = 500
    hidden, counted = twin("groove_hidden")(facet, lean), twin("groove_hidden_counted")(facet, lean, samples)
    assert np.max(np.abs(hidden - counted)) <= 1 / samples and np.ptp(counted) == 1
    part = (hidden > 0.1) & (hidden < 0.9)
    assert np.count_nonzero(part) > 20, "the comparison would say nothing"
    opened, both = twin("groove_open")(facet, lean, other), twin("groove_open_counted")(facet, lean, other, samples)
    assert np.max(np.abs(opened - both)) <= 1 / samples


def test_both_hidden_parts_begin_in_the_valley():
    facet, light, eye = RNG.uniform(-1.4, 1.4, (3, 300))
    hidden = twin("groove_hidden")
    assert np.allclose(twin("groove_open")(facet, light, eye), 1 - np.maximum(hidden(facet, light), hidden(facet, eye)))
    assert np.array_equal(twin("groove_open")(facet, light, eye), twin("groove_open")(facet, eye, light))
    assert np.allclose(hidden(facet, light), hidden(-facet, -light), atol=1e-15)


@pytest.mark.parametrize("count", [500])
def test_directions_off_the_groove_are_seen_along_it(count):
    """The closed form in the plane is Blinn's formula with three-dimensional vectors; rays say so too."""
    n, light, v = np.array([0.0, 0.0, 1.0]), directions(count), directions(count)
    h = (light + v) / np.linalg.norm(light + v, axis=-1, keepdims=True)
    formula = np.minimum(1, 2 * h[:, 2] * np.minimum(light[:, 2], v[:, 2]) / np.sum(v * h, -1))
    facet = twin("facet_lean")(n, h)
    lean_l, lean_v = (twin("groove_lean")(n, h, d) for d in (light, v))
    assert np.allclose(twin("groove_open")(facet, lean_l, lean_v), formula, rtol=1e-10, atol=1e-12)
    assert np.max(np.abs(twin("groove_open_counted")(facet, lean_l, lean_v, 400) - formula)) <= 1 / 400
    assert np.count_nonzero(formula < 0.9) > count // 10


def test_a_flat_plate_hides_nothing():
    up = np.array([0.0, 0.0, 1.0])
    assert twin("facet_lean")(up, up) == 0 and twin("groove_lean")(up, up, directions(1)[0]) == 0
    assert np.all(twin("groove_hidden")(0.0, np.linspace(-1.57, 1.57, 9)) == 0)
    assert np.all(twin("groove_hidden_counted")(0.0, np.linspace(-1.57, 1.57, 9), 50) == 0)


@pytest.mark.parametrize("facet", [0.2, 0.785, 1.3])
def test_what_a_diffuse_facet_sends_to_the_other(facet):
    """Rays from points of the facet, even in the sine of the angle: what a diffuse facet shines, along the groove."""
    t, u = np.meshgrid((np.arange(400) + 0.5) / 400, 2 * (np.arange(400) + 0.5) / 400 - 1)
    blocked = twin("groove_blocked")(facet, t, np.arcsin(u) + facet)
    assert np.mean(blocked) == pytest.approx(twin("groove_exchange")(facet), abs=4e-3)


# --- many facets -----------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("m", [0.05, 0.3, 1.0])
def test_facets_have_the_rms_slope_they_are_made_for(m):
    """Seen from above they are equally large: the mean square of their slopes is m^2, and they lean nowhere."""
    normals = twin("facet_normal")(np.arange(10000), m, 10000)
    slopes = normals[:, :2] / normals[:, 2:]
    assert np.mean(np.sum(slopes**2, -1)) == pytest.approx(m * m, rel=1e-3)
    assert np.max(np.abs(np.mean(slopes, 0))) < 1e-3 * m
    assert np.allclose(np.linalg.norm(normals, axis=-1), 1)


def beckmann(angle, m):
    return np.exp(-((np.tan(angle) / m) ** 2)) / (np.pi * m * m * np.cos(angle) ** 4)


@pytest.mark.parametrize("m", [0.2, 0.5])
def test_the_counted_distribution_is_beckmanns(m):
    angle = np.linspace(0, 0.6, 20)
    counted = twin("d_counted")(angle, m, 0.02, 10000)
    expected = np.array([np.mean(beckmann(np.maximum(a + np.linspace(-0.02, 0.02, 9), 0), m)) for a in angle])
    assert np.max(np.abs(counted - expected)) < 0.03 * expected.max()


@pytest.mark.parametrize(("theta_l", "theta_v"), [(0.5, 0.5), (0.9, 0.4), (0.2, 1.0)])
def test_the_facets_lit_are_those_the_distribution_says(theta_l, theta_v):
    m, half_angle = 0.3, 0.04
    angle = abs(theta_l - theta_v) / 2
    expected = 10000 * beckmann(angle, m) * np.cos(angle) * 2 * np.pi * (1 - np.cos(half_angle))
    assert twin("facets_lit")(theta_l, theta_v, np.pi, m, half_angle, 10000) == pytest.approx(expected, rel=0.06)


def test_every_place_has_a_facet_of_its_own():
    index = twin("facet_index")(np.arange(10000), 10000)
    assert np.array_equal(np.sort(index), np.arange(10000))


# --- rough diffuse surfaces ------------------------------------------------------------------------------------------
NODES, WEIGHTS = np.polynomial.legendre.leggauss(48)


def albedo(brdf: str, theta_v: float, *parameters) -> float:
    """int f n.l dw by Gauss-Legendre in mu and phi, cut where the formulas bend: phi = pi/2 and theta_l = theta_v."""
    total, mu_v = 0.0, np.cos(theta_v)
    for low, high in ((0.0, mu_v), (mu_v, 1.0)):
        mu = low + (high - low) * (0.5 * (NODES + 1)) ** 2
        mu_weight = WEIGHTS * (high - low) * 0.5 * (NODES + 1)
        for start in (0.0, np.pi / 2):
            phi = start + np.pi / 4 * (NODES + 1)
            value = twin(brdf)(np.arccos(mu)[:, None], theta_v, phi[None, :], *parameters)
            total += 2 * np.sum(value * (mu * mu_weight)[:, None] * (WEIGHTS * np.pi / 4)[None, :])
    return total


@pytest.mark.parametrize("theta_v", [0.3, 0.8, 1.4])
def test_albedos_in_closed_form_are_the_integrals(theta_v):
    mu = np.cos(theta_v)
    for rho, sigma in ((1.0, 0.5), (0.3, 1.2)):
        assert twin("albedo_oren_nayar")(mu, rho, sigma) == pytest.approx(
            albedo("brdf_oren_nayar_at", theta_v, rho, sigma), rel=1e-4)
    for rho, r in ((1.0, 1.0), (0.8, 0.5), (0.1, 0.9)):
        assert twin("albedo_eon")(mu, rho, r) == pytest.approx(albedo("brdf_eon_at", theta_v, rho, r), rel=1e-4)


def test_eon_keeps_all_light_and_oren_nayar_does_not():
    mu, r = np.meshgrid(np.linspace(0, 1, 41), np.linspace(0, 1, 21))
    assert np.allclose(twin("albedo_eon")(mu, 1.0, r), 1, rtol=0, atol=1e-15)
    assert np.max(twin("albedo_oren_nayar")(mu, 1.0, 1.0)) < 0.84
    assert twin("albedo_oren_nayar")(0.0, 1.0, 0.2) == pytest.approx(1.0151, abs=1e-4), "it makes light at the horizon"
    assert twin("albedo_oren_nayar")(0.5, 0.7, 0.0) == twin("albedo_eon")(0.5, 0.7, 0.0) == 0.7


@pytest.mark.parametrize(("brdf", "parameters"), [("brdf_oren_nayar", (0.8, 0.6)), ("brdf_eon", (0.8, 0.9))])
def test_rough_diffuse_models_are_reciprocal_and_never_negative(brdf, parameters):
    n, light, v = np.array([0.0, 0.0, 1.0]), directions(2000), directions(2000)
    value, swapped = twin(brdf)(n, light, v, *parameters), twin(brdf)(n, v, light, *parameters)
    assert np.allclose(value, swapped, rtol=1e-12, atol=0) and np.min(value) > 0
    assert np.all(twin(brdf)(n, light * np.array([1, 1, -1]), v, *parameters) == 0)
    smooth = twin(brdf)(n, light, v, parameters[0], 0.0)
    assert np.allclose(smooth, 0.8 / np.pi, rtol=1e-14)
