"""The geometry term: identities, limits, and second ways to every number the twins of chapter 7 give."""

import numpy as np
import pytest
from scipy import integrate

from app.optics import smith, vgroove, weak_furnace
from app.optics.geometry_term import branch_at, half_cosines, masking_at, shadowing_at, vgroove_at

RNG = np.random.default_rng(7)
ANGLES = RNG.uniform(0, [np.pi / 2, np.pi / 2, np.pi], (4000, 3)).T  # theta_l, theta_v, phi
SLOPES = (0.1, 0.3, 0.5, 1.0)


def test_half_cosines_are_those_of_the_vectors():
    theta_l, theta_v, phi = ANGLES
    light = np.stack([np.sin(theta_l) * np.cos(phi), np.sin(theta_l) * np.sin(phi), np.cos(theta_l)], -1)
    eye = np.stack([np.sin(theta_v), 0 * theta_v, np.cos(theta_v)], -1)
    h = (light + eye) / np.linalg.norm(light + eye, axis=-1, keepdims=True)
    wanted = np.stack([h[:, 2], eye[:, 2], light[:, 2], np.sum(light * h, -1)], -1)
    np.testing.assert_allclose(half_cosines(theta_l, theta_v, phi), wanted, atol=1e-14)


def test_the_minimum_is_of_its_two_parts_and_reciprocal():
    theta_l, theta_v, phi = ANGLES
    masking, shadowing, g = masking_at(*ANGLES), shadowing_at(*ANGLES), vgroove_at(*ANGLES)
    np.testing.assert_array_equal(g, np.minimum(masking, shadowing))
    np.testing.assert_allclose(masking, shadowing_at(theta_v, theta_l, phi), rtol=1e-13)
    np.testing.assert_allclose(g, vgroove_at(theta_v, theta_l, phi), rtol=1e-13)
    assert np.all((g >= 0) & (g <= 1))


def test_the_branch_is_the_least():
    branch = branch_at(*ANGLES)
    least = np.argmin([np.ones(4000), masking_at(*ANGLES), shadowing_at(*ANGLES)], 0)
    np.testing.assert_array_equal(branch, least)
    assert set(branch) == {0, 1, 2}


def test_a_groove_seen_from_the_side_by_plane_geometry():
    """In the plane of the groove: the line of sight over the other ridge cuts the facet; no formula of G."""
    for tilt in np.radians((20.0, 35.0, 50.0, 70.0)):
        for theta in np.radians((10.0, 40.0, 65.0, 80.0)):
            h, v = np.array([np.sin(tilt), np.cos(tilt)]), np.array([np.sin(theta), np.cos(theta)])
            if h @ v <= 0:
                continue
            own, other = np.array([-np.cos(tilt), np.sin(tilt)]), np.array([np.cos(tilt), np.sin(tilt)])  # its ridges
            t = np.linalg.solve(np.stack([own, -v], 1), other)[0]  # other + s v = t own, the valley is the origin
            seen = 1 - np.clip(t, 0, 1)
            assert float(vgroove.g_masking(h[1], v[1], h @ v)) == pytest.approx(seen, abs=1e-12)


def test_extremes_are_defined():
    ends = np.array([0.0, 1e-300, 1e-30, 1e-6, 0.5, 1.0])
    grid = np.meshgrid(ends, ends, ends, ends)
    for function in (vgroove.g_vgroove, vgroove.g_branch):
        assert np.all(np.isfinite(function(*grid)))
    for width in (1e-5, 1.0, 10.0):
        for function in (smith.lambda_beckmann, smith.lambda_ggx, smith.g1_beckmann, smith.g1_ggx,
                         smith.g1_beckmann_rational):
            assert np.all(np.isfinite(function(ends, width))) and np.all(function(ends, width) >= 0)
    assert smith.g1_beckmann(0.0, 0.3) == pytest.approx(0, abs=1e-28) and smith.g1_beckmann(1.0, 0.3) == 1


@pytest.mark.parametrize("a", [0.05, 0.3, 1.0, 1.9, 2.1, 4.0, 12.0])
def test_lambda_is_what_is_hidden_over_what_is_seen(a):
    """The definition: the mean of the slopes beyond the direction's, over the direction's slope (Smith 1967)."""
    def beyond(u):
        return (u - a) * np.exp(-u * u) / np.sqrt(np.pi)

    wanted = integrate.quad(beyond, a, a + 8, epsabs=0, epsrel=1e-12)[0] / a
    assert float(smith.lambda_beckmann_slope(1 / a)) == pytest.approx(wanted, rel=1e-10)


def test_ggx_lambda_by_the_difference():
    slope = np.geomspace(0.1, 100, 50)
    np.testing.assert_allclose(smith.lambda_ggx_slope(slope), (np.sqrt(1 + slope**2) - 1) / 2, rtol=1e-12)


def test_the_rational_fit_is_as_good_as_it_says():
    a = np.geomspace(0.01, 10, 20000)
    cosine, m = 1 / np.sqrt(2), 1 / a  # tan theta = 1
    off = smith.g1_beckmann_rational(cosine, m) - smith.g1_beckmann(cosine, m)
    assert np.abs(off).max() == pytest.approx(3.1e-3, abs=1e-4)
    assert a[np.argmax(np.abs(off))] == pytest.approx(1.34, abs=0.03)
    assert smith.g1_beckmann_rational(cosine, m).max() == pytest.approx(1 + 6e-5, abs=1e-5)


def test_correlated_smith_is_never_below_separable_nor_above_either_part():
    n_dot_v, n_dot_l = RNG.uniform(0, 1, (2, 2000))
    for m in SLOPES:
        separable, correlated = (g(n_dot_v, n_dot_l, m) for g in (smith.g_smith_separable, smith.g_smith_correlated))
        least = np.minimum(smith.g1_beckmann(n_dot_v, m), smith.g1_beckmann(n_dot_l, m))
        assert np.all(separable <= correlated * (1 + 1e-14)) and np.all(correlated <= least * (1 + 1e-14))


def facets(theta_v: float, m: float, what, cells: int = 600) -> float:
    """int D what dw_h by plain midpoints over slope and azimuth of h: no closed form, no piece of the twins."""
    x, phi = np.meshgrid((np.arange(cells) + 0.5) * 6 / cells, (np.arange(cells) + 0.5) * np.pi / cells)
    tilt = np.arctan(m * x)
    n_dot_h, v_dot_h = np.cos(tilt), (np.cos(tilt) * np.cos(theta_v) + np.sin(tilt) * np.sin(theta_v) * np.cos(phi))
    share = 2 * x * np.exp(-x * x) / np.pi / n_dot_h  # D dw_h, phi from 0 to pi counted twice
    return float(np.sum(share * what(n_dot_h, v_dot_h)) * 6 / cells * np.pi / cells)


@pytest.mark.parametrize("m", SLOPES)
@pytest.mark.parametrize("theta_v", [0.5, 1.0, 1.5])
def test_the_weak_white_furnace(theta_v, m):
    """V-grooves and Smith show just the plate's area, without G they show more: by sums that know no closed form."""
    n_dot_v = np.cos(theta_v)
    g1 = (lambda n_dot_h, v_dot_h: 1.0, lambda n_dot_h, v_dot_h: vgroove.g_masking(n_dot_h, n_dot_v, v_dot_h),
          lambda n_dot_h, v_dot_h: smith.g1_beckmann(n_dot_v, m))
    seen = [facets(theta_v, m, lambda a, b, g=g: g(a, b) * np.maximum(b, 0)) for g in g1]
    for geometry, area in enumerate(seen):
        assert float(weak_furnace.weak_furnace(theta_v, m, geometry)) == pytest.approx(area / n_dot_v, rel=3e-4)
        assert geometry == 0 or area / n_dot_v == pytest.approx(1, rel=3e-4)
    assert float(weak_furnace.weak_furnace(theta_v, m, 0)) == pytest.approx(
        1 + float(smith.lambda_beckmann(n_dot_v, m)), rel=1e-7)


@pytest.mark.parametrize("tilt", [0.1, 0.7, 1.2])
def test_in_grooves_every_tilt_shows_its_share(tilt):
    phi = (np.arange(20000) + 0.5) * np.pi / 20000
    for theta_v in (0.3, 1.0, 1.5):
        n_dot_v, n_dot_h = np.cos(theta_v), np.cos(tilt)
        v_dot_h = n_dot_h * n_dot_v + np.sin(tilt) * np.sin(theta_v) * np.cos(phi)
        every = np.mean(np.maximum(v_dot_h, 0)) / (n_dot_h * n_dot_v)
        groove = np.mean(vgroove.g_masking(n_dot_h, n_dot_v, v_dot_h) * np.maximum(v_dot_h, 0)) / (n_dot_h * n_dot_v)
        assert groove == pytest.approx(1, abs=1e-6)
        assert float(weak_furnace.furnace_ring(tilt, theta_v, 0.5, 0)) == pytest.approx(every, abs=1e-6)


@pytest.mark.parametrize(("m", "albedo"), [(0.3, 1.53), (0.5, 2.15), (1.0, 3.73)])
def test_without_g_more_light_comes_than_went(m, albedo):
    """optics.md, the last lines of section 1."""
    assert float(weak_furnace.albedo_without_g(np.radians(85), m)) == pytest.approx(albedo, abs=0.005)


@pytest.mark.parametrize("m", SLOPES)
@pytest.mark.parametrize("theta_v", [0.0, 0.5, 1.2, 1.5])
def test_albedos_by_plain_sums(theta_v, m):
    n_dot_v = np.cos(theta_v)

    def of(g):
        def what(n_dot_h, v_dot_h):
            n_dot_l = 2 * v_dot_h * n_dot_h - n_dot_v
            return np.where(n_dot_l > 0, v_dot_h * g(np.maximum(n_dot_l, 0)), 0) / n_dot_v
        return facets(theta_v, m, what)

    assert float(weak_furnace.albedo_without_g(theta_v, m)) == pytest.approx(of(np.ones_like), rel=2e-3)
    for geometry, g in ((2, smith.g_smith_separable), (3, smith.g_smith_correlated)):
        wanted = of(lambda n_dot_l, g=g: g(n_dot_v, n_dot_l, m))
        assert float(weak_furnace.albedo_smith(theta_v, m, geometry)) == pytest.approx(wanted, rel=2e-3)


def test_smith_albedos_of_the_reference():
    """optics.md, section 6: Beckmann, m = 1, 85 degrees."""
    assert float(weak_furnace.albedo_smith(np.radians(85), 1.0, 2)) == pytest.approx(0.9055, abs=6e-5)
    assert float(weak_furnace.albedo_smith(np.radians(85), 1.0, 3)) == pytest.approx(0.9587, abs=6e-5)


@pytest.mark.parametrize("geometry", range(4))
def test_the_albedo_is_the_integral_of_the_brdf(geometry):
    """A lobe with any geometry term, summed over the hemisphere in l itself."""
    from app.optics.geometry_choice import albedo_geometry, brdf_geometry
    from app.optics.spherical import direction

    mu, phi = np.meshgrid((np.arange(800) + 0.5) / 800, (np.arange(400) + 0.5) * np.pi / 400)
    light = direction(np.arccos(mu), phi)
    for theta_v, m in ((0.4, 0.5), (1.2, 0.5), (1.4, 1.0)):
        f = brdf_geometry(np.array([0.0, 0.0, 1.0]), light, direction(theta_v, 0.0), m, 1.0, geometry)
        albedo = float(np.sum(f * mu) * 2 * np.pi / mu.size)
        assert float(albedo_geometry(theta_v, m, geometry)) == pytest.approx(albedo, rel=2e-3)


def test_the_chosen_term_is_the_named_one():
    from app.optics.cook_torrance import brdf_cook_torrance
    from app.optics.geometry_choice import brdf_geometry, geometry_at
    from app.optics.spherical import direction

    theta_l, theta_v, phi = ANGLES
    n, light, eye = np.array([0.0, 0.0, 1.0]), direction(theta_l, phi), direction(theta_v, 0.0)
    np.testing.assert_allclose(brdf_geometry(n, light, eye, 0.4, 0.04, 1), brdf_cook_torrance(n, light, eye, 0.4, 0.04),
                               rtol=1e-9)
    without = brdf_geometry(n, light, eye, 0.4, 0.04, 0)
    for geometry in (1, 2, 3):
        shared = geometry_at(theta_l, theta_v, phi, 0.4, geometry)
        np.testing.assert_allclose(brdf_geometry(n, light, eye, 0.4, 0.04, geometry), without * shared, rtol=1e-9)
