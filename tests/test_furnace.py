"""The white furnace's sums: every model of the course to 1e-4, against far finer ones and against other methods."""

import numpy as np
import pytest

from app import furnace
from app.board.terms import ANGLES
from app.furnace import albedo
from app.hemisphere import NORMAL
from app.optics import twin
from app.optics.cook_torrance import albedo_cook_torrance
from app.optics.spherical import direction
from app.quadrature import gauss_legendre, nested
from app.tiles import first_tiles

NEAR = 1e-4
SOME = ANGLES[np.array([0, 3, 8, 14, 20, 27, 33, 39, 43, 44])]  # 0 to 89.9 degrees


def of(name: str, *args):
    return lambda n, l, v: twin(name)(n, l, v, *args)


WIDE = {
    "Lambert": of("brdf_lambert", 0.8), "flawed, shipped": of("brdf_flawed", 1.0, 4, 0.5, 0.5, 4.0),
    **{f"Oren-Nayar {s}": of("brdf_oren_nayar", 0.8, s) for s in (0.1, 0.5, 1.0)},
    "EON": of("brdf_eon", 0.8, 0.5), "Phong 4": of("brdf_phong", 0.3, 0.7, 4.0),
    "Blinn 4": of("brdf_blinn_phong", 0.0, 1.0, 4.0), "Blinn as printed": of("brdf_blinn_phong_printed", 0.5, 0.5, 4.0),
    "GGX 1": of("brdf_ggx", 1.0, 0.95), "Smith 1": of("brdf_cook_torrance_smith", 1.0, 0.95),
}
MODELS = WIDE | {
    **{f"Phong {n:g}": of("brdf_phong", 0.0, 1.0, n) for n in (1.0, 30.0, 1e3, 1e5)},
    **{f"Cook-Torrance {m}": of("brdf_cook_torrance", m, 0.95) for m in (0.01, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1.0)},
    **{f"as printed {m}": of("brdf_cook_torrance_printed", m, 0.95) for m in (0.05, 0.3, 1.0)},
    **{f"GGX {m}": of("brdf_ggx", m, 0.95) for m in (0.01, 0.3)}, "Blinn 100": of("brdf_blinn_phong", 0.0, 1.0, 100.0),
    "Smith 0.05": of("brdf_cook_torrance_smith", 0.05, 0.95), "coated": of("brdf_coated", 0.8, 0.3, 0.04, 3),
}


@pytest.mark.parametrize("name", MODELS)
def test_an_albedo_is_known_to_1e_4_and_its_error_is_told(name, monkeypatch):
    """Smaller tiles with more nodes, cut until next to nothing changes."""
    value, error = albedo(MODELS[name], SOME)
    for constant, finer in {"NODES": 15, "ENOUGH": 2e-8, "DEEPEST": 9, "MOST": 20_000, "BY_CHANCE": 0.0}.items():
        monkeypatch.setattr(furnace, constant, finer)
    wanted, off = albedo(MODELS[name], SOME)
    assert off.max() < 2e-5
    assert np.abs(value - wanted).max() < NEAR
    assert np.all(np.abs(value - wanted) < 2 * error + off) and error.max() < NEAR


@pytest.mark.parametrize("m", [0.01, 0.03, 0.1, 0.3, 1.0])
def test_v_grooves_have_the_semi_analytic_albedo(m):
    value, _ = albedo(of("brdf_cook_torrance", m, 1.0), ANGLES)
    np.testing.assert_allclose(value, albedo_cook_torrance(ANGLES, m, 1.0), atol=NEAR)


@pytest.mark.parametrize("name", WIDE)
def test_a_plain_grid_says_the_same_of_wide_lobes(name):
    """No stretching and no tiles: Gauss-Legendre in the height and the turn of l, up to 85 degrees."""
    theta = np.radians((0, 30, 60, 75, 85))
    value, _ = albedo(WIDE[name], theta)
    x, w = gauss_legendre(400)
    height, turn = np.meshgrid(x**2, np.pi * x, indexing="ij")  # dense towards the horizon
    l = np.stack([np.sqrt(1 - height**2) * np.cos(turn), np.sqrt(1 - height**2) * np.sin(turn), height], -1)
    weight = np.outer(2 * x * w, 2 * np.pi * w) * height
    plain = [np.sum(weight * WIDE[name](NORMAL, l, direction(t, 0.0))) for t in theta]
    np.testing.assert_allclose(value, plain, atol=NEAR)


def test_a_lobe_that_leans_aside_is_summed_on_both_hands():
    def aside(n, l, v):
        return np.maximum(0.0, l @ np.array([0.48, 0.6, 0.64])) ** 8

    value, _ = albedo(aside, [0.3])
    x, w = gauss_legendre(200)
    height, turn = np.meshgrid(x, 2 * np.pi * x, indexing="ij")
    l = np.stack([np.sqrt(1 - height**2) * np.cos(turn), np.sqrt(1 - height**2) * np.sin(turn), height], -1)
    plain = np.sum(np.outer(w, 2 * np.pi * w) * height * aside(NORMAL, l, NORMAL))
    assert value[0] == pytest.approx(plain, abs=1e-6)


@pytest.mark.parametrize("both_sides", [False, True])
def test_the_first_tiles_and_their_cuts_are_the_hemisphere(both_sides):
    """Solid angle and irradiance of an even light, however the tiles are cut."""
    theta = np.array([0.0, 1e-3, 0.7, 1.57])
    tiles = first_tiles(theta, both_sides)
    tiles = tiles.cut(np.stack([tiles.s + 0.1, tiles.t + 0.1]))
    nodes, weights, _ = nested(21)
    l, per_tile = tiles.directions(theta, np.full((2, 4), 0.3), nodes)
    share = per_tile * np.outer(weights, weights).ravel() * (1 if both_sides else 2)
    np.testing.assert_allclose(np.linalg.norm(l, axis=-1), 1, rtol=1e-14)
    np.testing.assert_allclose(np.bincount(tiles.at, share.sum(-1)), 2 * np.pi, rtol=1e-10)
    np.testing.assert_allclose(np.bincount(tiles.at, (share * l[..., 2]).sum(-1)), np.pi, rtol=1e-10)


@pytest.mark.parametrize("count", [3, 7, 11, 15])
def test_a_rule_and_every_other_node_of_it_are_exact_for_polynomials(count):
    nodes, fine, coarse = nested(count)
    for power in range(count):
        assert fine @ nodes**power == pytest.approx(1 / (power + 1), rel=1e-13)
        if power < count // 2:
            assert coarse @ nodes**power == pytest.approx(1 / (power + 1), rel=1e-13)
    assert fine @ nodes ** (count + 1) != pytest.approx(1 / (count + 2), rel=1e-13) and not coarse[::2].any()
