"""The balance of a patch, the reflectance equation under a sky, Lambert, and the specimens, each by a second way."""

import numpy as np
import pytest
from numpy import pi
from scipy.integrate import quad

from app.badges import check
from app.furnace import albedo
from app.hemisphere import around
from app.optics.lambert import brdf_lambert
from app.optics.phong import albedo_phong
from app.optics.projected_solid_angle import projected_solid_angle_cone
from app.optics.punctual import irradiance_directional
from app.optics.reflectance import (
    cosine_sum,
    exitance_leaving,
    exitance_reflected,
    exitance_scattered,
    irradiance_absorbed,
)
from app.optics.sky import reflected_part, reflected_radiance, reflected_radiance_sum, sky_radiance, sun_share
from app.optics.specimen import brdf_flawed, brdf_paint, hemisphere_meter, paint_measured, ratio_flawed
from app.optics.spherical import direction, light_direction, view_direction

UP = np.array([0.0, 0.0, 1.0])
RNG = np.random.default_rng(4)


def test_what_arrives_is_reflected_scattered_or_absorbed():
    k_d, k_s, facing, theta = RNG.uniform(0, (1, 1, 1000, 1.5), (50, 4)).T
    leaves = exitance_reflected(k_s, facing, theta) + exitance_scattered(k_d, facing, theta)
    assert exitance_leaving(k_d, k_s, facing, theta) == pytest.approx(leaves, rel=1e-14)
    arrives = irradiance_directional(facing, theta)
    assert leaves + irradiance_absorbed(k_d, k_s, facing, theta) == pytest.approx(arrives, rel=1e-13)
    assert irradiance_absorbed(0.7, 0.6, 100.0, 0.0) == pytest.approx(-30), "more promised than arrived"


# --- Lambert ---------------------------------------------------------------------------------------------------------
def test_the_constant_of_a_white_matt_surface_is_one_over_pi():
    value, _ = albedo(lambda n, l, v: brdf_lambert(n, l, v, 1.0), [0.0, 0.7, 1.2])
    assert value == pytest.approx(1, abs=1e-7)
    assert hemisphere_meter(0.3, 1.0, 0, 1.0, 0.0, 20.0, np.array([1, 0])) == pytest.approx([1, 2], rel=1e-13)


@pytest.mark.parametrize(("l", "v"), [((0.6, 0, -0.8), UP), (UP, (0.6, 0, -0.8)), ((1.0, 0, 0), UP), (UP, (1.0, 0, 0))])
def test_nothing_below_the_horizon_is_lit_or_seen(l, v):
    assert brdf_lambert(UP, l, v, 0.5) == 0


@pytest.mark.parametrize("half_angle", [0.01, 0.6, pi / 2])
def test_the_tiles_sum_to_the_closed_form(half_angle):
    rows = np.array([1, 2, 3, 6, 24])
    closed = pi * np.sin(half_angle) ** 2 / np.cos(half_angle / (2 * rows))
    assert cosine_sum(rows, half_angle) == pytest.approx(closed, rel=1e-14)
    off = cosine_sum(rows, half_angle) / projected_solid_angle_cone(half_angle) - 1
    assert off[-2] / off[-1] == pytest.approx(16, rel=0.01), "four times the rows, a sixteenth of the error"


# --- the reflectance equation ----------------------------------------------------------------------------------------
SCENES = [(np.radians(theta_l), np.radians(phi), np.radians(theta_v), 1.0, 25.0, 0.2, 0.7, exponent)
          for theta_l, phi, theta_v, exponent in ((55, 150, 35, 40.0), (80, 90, 30, 40.0), (85, 180, 84, 100.0),
                                                  (0, 0, 0, 60.0), (30, -60, 60, 5.0))]


@pytest.mark.parametrize("scene", SCENES)
def test_the_integral_over_another_grid(scene):
    """Polar about the eye's mirror direction, ending at the horizon along its great circles."""
    theta_l, phi, theta_v, *rest = scene
    x, w = np.polynomial.legendre.leggauss(300)
    s, t = np.meshgrid((np.arange(600) + 0.5) / 600, 0.5 * (x + 1))
    l, size = around(light_direction(theta_v, pi), s, t, 0.3)
    part = reflected_part(l, light_direction(theta_l, phi), view_direction(theta_v), *rest)
    exact = np.sum(0.5 * w[:, None] * size * part) / 600
    assert reflected_radiance(*scene) == pytest.approx(exact, rel=1e-5 if theta_v > 1.4 else 1e-8)


@pytest.mark.parametrize("scene", SCENES[:2])
def test_the_sum_over_the_tiles_goes_to_the_integral(scene):
    off = reflected_radiance_sum(np.array([16, 32]), *scene) / reflected_radiance(*scene) - 1
    assert off[0] / off[1] == pytest.approx(4, rel=0.05), "second order"
    assert abs(off[1]) < 1e-4


def test_one_tile_of_the_sum_is_what_stands_under_the_integral():
    scene = SCENES[0]
    l = direction(np.full(4, pi / 4), (np.arange(4) + 0.5) * pi / 2)
    parts = reflected_part(l, light_direction(*scene[:2]), view_direction(scene[2]), *scene[3:])
    assert reflected_radiance_sum(1, *scene) == pytest.approx(parts.sum() * pi / 2, rel=1e-14), "a quarter of 2 pi each"


def test_light_adds_up():
    theta_l, phi, theta_v, zenith, sun, *matter = SCENES[0]
    both = reflected_radiance(*SCENES[0])
    alone = [reflected_radiance(theta_l, phi, theta_v, z, s, *matter) for z, s in ((zenith, 0.0), (0.0, sun))]
    assert sum(alone) == pytest.approx(both, rel=1e-14)
    assert sun_share(*SCENES[0]) == pytest.approx(alone[1] / both, rel=1e-14)
    assert sun_share(theta_l, phi, theta_v, 0.0, 0.0, *matter) == 0, "no light, no share of it"


def test_the_sky_is_a_sky():
    sun = light_direction(1.0, 2.0)
    tree = (0.5 + 0.5 * sun @ (-0.48, 0.86, 0.03**0.5)) ** 64
    assert sky_radiance(sun, sun, 0.0, 25.0) == pytest.approx(25 * (1 - 0.94 * tree), rel=1e-7)
    assert sky_radiance(-sun, sun, 1.0, 25.0) == 0
    wide = 2 * np.arccos(0.5 ** (1 / 256))  # ((1 + cos a) / 2)^128 = cos^256(a / 2)
    assert np.degrees(2 * wide) == pytest.approx(17, abs=0.5), "degrees across at half its height, as the lesson says"


# --- specimens -------------------------------------------------------------------------------------------------------
def share(flaw, theta_v, exponent, weight, k_d=0.6, k_s=0.3, radiance=1.0):
    return hemisphere_meter(theta_v, radiance, flaw, k_d, k_s, exponent, weight)


@pytest.mark.parametrize("theta_v", [0.0, 0.6, 1.3])
def test_the_meter_with_the_cosine_is_the_albedo(theta_v):
    gloss = 0.3 * albedo_phong(theta_v, 20.0)
    loss = 2 * quad(lambda mu: (1 - (1 - mu) ** 2) * mu, 0, 1)[0]
    for flaw, body in ((0, 0.6), (1, 0.6 - 0.6 * pi), (2, 0.6 * loss), (3, 0.6 * pi)):
        assert share(flaw, theta_v, 20.0, 1) == pytest.approx(body + gloss, rel=1e-9)
    assert share(5, 0.6, 20.0, 1) == pytest.approx(share(0, 0.6, 20.0, 1), rel=1e-12), "its azimuth averages out"


def test_the_meter_without_the_cosine():
    for exponent in (5.0, 20.0, 60.0):
        lobe = (exponent + 2) / (exponent + 1)  # (n + 2) / (2 pi) int cos^n dw
        assert share(0, 0.0, exponent, 0) == pytest.approx(2 * 0.6 + 0.3 * lobe, rel=1e-12)


RED = {  # a flaw: the badge it breaks, its worst value
    0: None, 1: ("non_negative", 0.6 / pi - 0.6), 2: ("reciprocal", None), 3: ("energy", 0.6 * pi + 0.3),
    4: ("linear", None), 5: ("finite", None),
}
ALSO = {5: ["energy"]}  # where f is no number for any light, no albedo is one


@pytest.mark.parametrize("flaw", RED)
def test_each_flaw_breaks_its_badge(flaw):
    found = check(lambda n, l, v, radiance: brdf_flawed(n, l, v, radiance, flaw, 0.6, 0.3, 20.0), of_radiance=True)
    red = ALSO.get(flaw, []) + ([RED[flaw][0]] if RED[flaw] else [])
    assert [name for name, badge in found.items() if not badge.ok] == red
    if RED[flaw] and RED[flaw][1] is not None:
        assert found[RED[flaw][0]].worst == pytest.approx(RED[flaw][1], rel=1e-3)


def test_only_a_clamp_asks_how_bright_it_is():
    pair = light_direction(0.5, pi), view_direction(0.5)
    one, ten = (ratio_flawed(UP, *pair, x, np.arange(6), 0.6, 0.3, 20.0) for x in (1.0, 10.0))
    assert np.flatnonzero(~np.isclose(one, ten, rtol=1e-12)).tolist() == [4]
    assert ten[4] == pytest.approx(0.1), "cut off at 1"


def test_no_azimuth_no_number():
    l = light_direction(1.0, 2.0)
    for pair in ((UP, l), (l, UP), (UP, UP)):
        assert np.isnan(brdf_flawed(UP, *pair, 1.0, 5, 0.6, 0.3, 20.0))
        assert np.isfinite(brdf_flawed(UP, *pair, 1.0, 0, 0.6, 0.3, 20.0))


def test_paint_is_sound_and_red():
    for channel in range(3):
        found = check(lambda n, l, v, c=channel: brdf_paint(n, l, v, c, 0.15, 36.0))
        assert all(badge.ok for badge in found.values())
    l, v = light_direction(0.5, 1.0), view_direction(0.8)
    red, green, blue = brdf_paint(UP, l, v, np.arange(3), 0.15, 36.0)
    assert red > green > blue > 0
    assert (red - green) == pytest.approx(0.85 * (0.62 - 0.16) / pi, rel=1e-12), "the varnish is white"


def test_a_measured_brdf_is_the_brdf_as_the_lamp_shrinks():
    theta_l, phi, theta_v = 0.8, 2.8, 0.6
    f = brdf_paint(UP, light_direction(theta_l, phi), view_direction(theta_v), 0, 0.15, 36.0)
    off = paint_measured(theta_l, phi, theta_v, np.array([0.04, 0.02, 0.01]), 0, 0.15, 36.0) / f - 1
    assert off[:2] / off[1:] == pytest.approx(4, rel=0.02), "half the lamp, a quarter of the error"
    assert abs(off[2]) < 2e-3
    matt = paint_measured(theta_l, phi, theta_v, 0.4, 1, 0.0, 36.0)
    assert matt == pytest.approx(0.16 / pi, rel=1e-12), "with any lamp"


def test_a_wide_lamp_on_the_normal_is_the_meter():
    """A lamp that is the whole sky: the albedo over pi."""
    whole = paint_measured(0.0, 0.0, 0.5, pi / 2, 0, 0.15, 20.0)
    assert whole * pi == pytest.approx(0.85 * 0.62 + 0.15 * albedo_phong(0.5, 20.0), rel=1e-6)
