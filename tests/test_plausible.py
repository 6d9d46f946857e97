"""Plausible shading: a body under a coat by second ways, and the numbers of the optics reference."""

import re

import numpy as np
import pytest
from scipy.integrate import dblquad

from app.badges import check
from app.catalog import step
from app.furnace import albedo
from app.gpu.stage import Stage
from app.gpu.stage_text import Source
from app.optics import twin
from app.optics.spherical import direction
from app.optics.three_lamps import LAMPS

N = np.array([0.0, 0.0, 1.0])


# --- diffuse under Fresnel -------------------------------------------------------------------------------------------
@pytest.mark.parametrize(("coupling", "share"), [(0, 1.648), (1, 1.588), (2, 1.563), (3, 1.000)])
def test_what_a_white_body_under_a_coat_sends_back_at_85_degrees(coupling, share):
    """Optics reference, D13."""
    assert float(twin("albedo_coated")(np.radians(85), 1.0, 0.04, coupling)) == pytest.approx(share, abs=5e-4)


@pytest.mark.parametrize("coupling", range(4))
@pytest.mark.parametrize("theta_v", [0.0, 0.6, 1.3])
def test_the_bodys_share_is_the_integral_of_its_brdf(coupling, theta_v):
    v = direction(theta_v, 0.0)

    def f(phi, theta):
        l = direction(theta, phi)
        share = twin("body_share")(l[2], v[2], 0.5 * np.linalg.norm(l + v), 0.17, coupling)
        return 0.7 / np.pi * float(share) * np.cos(theta) * np.sin(theta)

    total, _ = dblquad(f, 0, np.pi / 2, 0, np.pi, epsabs=1e-9)
    assert float(twin("albedo_body")(theta_v, 0.7, 0.17, coupling)) == pytest.approx(2 * total, abs=1e-8)


def test_a_smooth_coat_over_white_gives_back_all_at_any_angle():
    theta = np.radians([0, 20, 45, 70, 85, 89])[:, None]
    assert np.allclose(twin("albedo_coated")(theta, 1.0, np.array([0.0, 0.04, 0.5, 0.9]), 3), 1, rtol=0, atol=1e-14)


@pytest.mark.parametrize("f0", [0.02, 0.17])
def test_a_nearly_smooth_coat_in_the_furnace_is_a_smooth_one(f0):
    theta = np.radians([0.0, 30.0, 60.0])
    for coupling in range(4):
        got, _ = albedo(lambda n, l, v: twin("brdf_coated")(n, l, v, 0.8, 0.01, f0, coupling), theta)  # noqa: B023
        assert np.allclose(got, twin("albedo_coated")(theta, 0.8, f0, coupling), atol=5e-4)


def test_how_much_too_much_a_rough_coat_over_white_gives_back():
    """The honesty of plausible_shading/energy: up to 1.005, near 55 degrees, and less than all at grazing."""
    theta = np.radians([0.0, 45.0, 52.0, 55.0, 58.0, 65.0, 85.0])
    found = np.array([albedo(lambda n, l, v: twin("brdf_coated")(n, l, v, 1.0, m, f0, 3), theta)[0]  # noqa: B023
                      for m in (0.1, 0.15, 0.2, 0.25, 0.4) for f0 in (0.0, 0.04)])
    most = np.unravel_index(np.argmax(found), found.shape)
    assert 1.004 < found[most] < 1.005 and theta[most[1]] in np.radians([52.0, 55.0, 58.0])
    assert np.all(found[:, -1] < 0.9)


def test_only_the_coupling_in_and_out_passes_all_badges():
    def failed(coupling):
        badges = check(lambda n, l, v: twin("brdf_coated")(n, l, v, 1.0, 0.02, 0.04, coupling))
        return {name for name, badge in badges.items() if not badge.ok}

    assert [failed(k) for k in range(4)] == [{"energy"}, {"energy"}, {"energy", "reciprocal"}, set()]


def test_the_share_let_through_keeps_its_digits_at_grazing():
    assert float(twin("passed_share")(1e-9, 0.04)) == pytest.approx(0.96 * 5e-9, rel=1e-7)
    c = np.linspace(0, 1, 50)
    assert np.allclose(twin("passed_share")(c, 0.2), 1 - twin("f_schlick")(c, 0.2), atol=1e-15)


def test_the_fit_that_the_second_ball_is_drawn_with():
    theta = np.linspace(0, np.pi / 2, 91)
    c = np.cos(theta)
    fit = re.search(r"halfway_lost\(float c\) { return (.*?); }", step("plausible_shading/energy").step.scene.glsl)[1]
    off = 0.83 * (1 - eval(fit, {"c": c})) - twin("albedo_body")(theta, 1.0, 0.17, 1)
    assert 1e-5 < np.max(abs(off)) < 2e-4


# --- from the lamp to the pixel --------------------------------------------------------------------------------------
def test_exposure_by_the_sensors_own_numbers():
    """f/8 and 1/125 s at ISO 100 are EV 13: a luminance that gives the sensor 0.78 lx s through the lens fills it."""
    ev = np.log2(8.0**2 * 125)
    luminance = 0.78 / (0.65 / 8.0**2 / 125)
    assert float(twin("luminance_white")(ev)) == pytest.approx(luminance, rel=1e-12)
    assert float(twin("exposed_luminance")(luminance, ev)) == pytest.approx(1, rel=1e-12)
    assert float(twin("exposed_luminance")(luminance, ev + 1)) == pytest.approx(0.5, rel=1e-12)


def test_a_meter_puts_the_mean_at_a_tenth_of_the_sensor():
    mean = np.array([0.1, 25.0, 4000.0])
    assert np.allclose(twin("exposed_luminance")(mean, twin("exposure_value")(mean)), 12.5 / 120, rtol=1e-12)
    assert float(twin("exposure_value")(12.5 / 100 * 2**15)) == pytest.approx(15, abs=1e-12)


@pytest.mark.parametrize("curve", range(3))
def test_a_tone_curve_rises_from_black_to_white_and_never_beyond(curve):
    x = np.concatenate([[0.0], np.geomspace(1e-6, 1e6, 2000)])
    y = twin("tone_curve")(x, curve)
    assert y[0] == 0 and np.all(np.diff(y) >= 0) and y[-1] == pytest.approx(1, abs=1e-6) and y.max() <= 1
    at_one = {0: 1.0, 1: 0.5, 2: 2.54 / 3.16}
    assert float(twin("tone_curve")(1.0, curve)) == pytest.approx(at_one[curve], rel=1e-12)


def test_the_cards_number_is_what_its_stops_give():
    flux, distance, rho, ev = 800.0, 0.8, 0.8, 5.0
    luminance = rho * flux / (4 * np.pi * distance**2) / np.pi
    share = luminance / (1.2 * 2**ev)
    assert float(twin("card_exposed")(flux, distance, rho, ev)) == pytest.approx(share, rel=1e-12)
    assert float(twin("card_stored")(flux, distance, rho, ev, 0)) == pytest.approx(
        255 * (1.055 * share ** (1 / 2.4) - 0.055), rel=1e-12)
    assert float(twin("stored_number")(0.18)) == pytest.approx(117.6, abs=0.05)


# --- three lamps -----------------------------------------------------------------------------------------------------
def test_a_globe_by_its_luminance_gives_what_its_intensity_gives():
    at = {"luminous_flux": 800.0, "from_wall": np.array([0.1, 1.2, 2.4]), "along_wall": np.array([0.3, 0.0, -1.0])}
    exact = twin("lamps_illuminance")(**at)
    assert np.allclose(twin("lamps_illuminance_by_area")(**at, source_radius=0.2), exact, rtol=1e-12)
    points = sum(flux / (4 * np.pi) * place[2] / np.linalg.norm(place - [1.2, 0.0, 0.0]) ** 3
                 for flux, place in zip((800, 600, 250), LAMPS, strict=True))
    assert float(exact[1]) == pytest.approx(points, rel=1e-12)


def test_a_lamps_lumens_are_all_there():
    """The illuminance of an endless floor, summed, is half of what a lamp sends out."""
    total, _ = dblquad(lambda q, turn: q * float(twin("lamp_illuminance")(
        1, 0.0, LAMPS[1][0] + q * np.cos(turn), LAMPS[1][1] + q * np.sin(turn))), 0, 2 * np.pi, 0, np.inf, epsrel=1e-6)
    assert total == pytest.approx(300, rel=1e-4)


def test_i_over_r_squared_is_no_radiance():
    assert float(twin("luminance_over_inverse_square")(0.1, 1.0)) == pytest.approx(31.8, abs=0.05)  # D5
    ratio = twin("lamp_luminance")(0, 800.0, 0.1) / twin("lamp_inverse_square")(0, 800.0, *LAMPS[0][:2])
    assert float(ratio) == pytest.approx(float(twin("luminance_over_inverse_square")(0.1, LAMPS[0][2])), rel=1e-12)


# --- two models of ten materials -------------------------------------------------------------------------------------
@pytest.mark.parametrize("m", [0.05, 0.4])
@pytest.mark.parametrize("material", [2, 5, 8])
def test_a_highlights_gain_is_that_of_the_brdfs(material, m):
    theta = np.array([0.0, 0.5, 1.0, 1.3])
    l, v, c = direction(theta, np.pi), direction(theta, 0.0), np.cos(theta)
    f0, rho = float(twin("f_material")(1.0, material)[1]), float(twin("matter_body")(material, 1))
    for brdf, body, gain in (
            ("brdf_matter", twin("body_coupled")(c, c, rho, f0), twin("gain_cook_torrance")(theta, material, 1)),
            ("brdf_matter_blinn", rho * (1 - f0) / np.pi, twin("gain_blinn_phong")(theta))):
        mirrored = (twin(brdf)(N, l, v, m, material, 1) - body) * c
        assert np.allclose(mirrored / mirrored[0], gain, rtol=1e-9)


@pytest.mark.parametrize("material", range(10))
def test_both_models_of_a_material_keep_their_balance(material):
    for brdf in ("brdf_matter", "brdf_matter_blinn"):
        badges = check(lambda n, l, v: twin(brdf)(n, l, v, 0.15, material, 0))  # noqa: B023
        assert all(badge.ok for badge in badges.values()), (brdf, badges)


def test_both_highlights_are_alike_head_on():
    peaks = [float(twin(brdf)(N, N, N, 0.1, 5, 2)) for brdf in ("brdf_matter", "brdf_matter_blinn")]
    assert peaks[0] == pytest.approx(peaks[1], rel=0.03)


@pytest.mark.parametrize("theta_d", [0.0, 5.0, 62.0, 80.0])
def test_the_lamp_of_the_vases_stands_where_the_numbers_say(ctx, theta_d):
    """Light and eye are theta_d from the halfway vector, as the first view has it."""
    scene = step("plausible_shading/compare").step.scene
    stage = Stage(ctx, Source(scene, "compare"))
    stage_values = {"theta_d": np.radians(theta_d), "m": 0.2, "material": 7}
    lamp = np.asarray(stage.probes(stage_values))[0, :3] - [0.0, 0.0, 2.42]
    stage.release()
    up = np.radians(scene.camera.elevation)
    eye = np.array([0.0, -np.cos(up), np.sin(up)])
    assert np.linalg.norm(lamp) == pytest.approx(1.4, rel=1e-5)
    assert np.degrees(np.arccos(np.clip(lamp @ eye / 1.4, -1, 1))) == pytest.approx(2 * theta_d, abs=0.1)
