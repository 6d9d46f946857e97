"""Radiometry and photometry by identities and by second methods; the room against followed rays and pyrender."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import dblquad, quad

from app.gpu.evaluate import evaluate
from app.optics import twin
from app.optics.photometry import C_1, C_2, K_CD, K_M, STEFAN, V_LAMBDA, WIEN
from app.quantities import TABLE

RNG = np.random.default_rng(3)
CLOSE = {"rel": 1e-12}


def test_the_constants_follow_from_those_of_nature():
    from scipy.constants import Boltzmann as k
    from scipy.constants import c, h

    assert pytest.approx(2 * h * c * c * 1e36, **CLOSE) == C_1  # m^4 to nm^4
    assert pytest.approx(h * c / k * 1e9, **CLOSE) == C_2
    assert pytest.approx(2 * np.pi**5 * k**4 / (15 * h**3 * c**2), **CLOSE) == STEFAN
    assert pytest.approx(C_2 / 4.965114231744276, rel=1e-10) == WIEN
    assert K_CD == 683 and K_M == 683.002


# --- chapter 2, radiometry -------------------------------------------------------------------------------------------
def test_the_whole_sky_gives_pi_l():
    assert twin("irradiance_cap")(2.0, np.pi / 2) == pytest.approx(2 * np.pi, **CLOSE)
    assert twin("irradiance_piece")(0, 2.0, np.pi / 2, 1.0) == pytest.approx(2 * np.pi, **CLOSE)
    assert twin("irradiance_without_cosine")(2.0, np.pi / 2) == pytest.approx(4 * np.pi, **CLOSE)


def counted(lit) -> float:
    """int cos theta dw over the lit part of the upper hemisphere, by the midpoint rule."""
    theta, phi = np.meshgrid((np.arange(1500) + 0.5) / 1500 * np.pi / 2, (np.arange(1500) + 0.5) / 1500 * 2 * np.pi)
    d = np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], -1)
    cell = np.pi / 2 / 1500 * 2 * np.pi / 1500
    return float(np.sum(lit(d) * d[..., 2] * np.sin(theta)) * cell)


@pytest.mark.parametrize("theta", [0.0, 0.7, 1.4])
def test_pieces_of_sky_are_what_counting_says(theta):
    opening, centre = 0.35, twin("direction")(theta, 0.0)
    sun = counted(lambda d: d @ centre >= np.cos(opening))
    assert twin("irradiance_piece")(1, 1.0, opening, theta) == pytest.approx(sun, rel=2e-3)
    window = counted(lambda d: twin("meets_patch")(d, theta, 0.0, 1.0, 0.0, 2 * np.sin(opening)))
    assert twin("irradiance_piece")(2, 1.0, opening, theta) == pytest.approx(window, rel=2e-3)


def test_a_sphere_obeys_the_inverse_square_exactly():
    radius = RNG.uniform(0.05, 1.0, 200)
    distance = radius * RNG.uniform(1.0001, 50, 200)
    sphere = twin("irradiance_sphere")(7.0, radius, distance, 0.0)
    rule = twin("irradiance_round_far")(7.0, radius, distance)
    assert np.allclose(sphere, rule, rtol=1e-14, atol=0)
    assert np.allclose(rule, twin("irradiance_point")(7 * np.pi * radius**2, distance, 0.0), rtol=1e-14, atol=0)


def test_a_disk_exceeds_it_by_the_rule_of_five():
    radius, distance = RNG.uniform(0.05, 1.0, 200), RNG.uniform(0.1, 20, 200)
    disk = twin("irradiance_disk")(1.0, radius, distance, 0.0)
    excess = twin("irradiance_round_far")(1.0, radius, distance) / disk - 1
    assert np.allclose(excess, twin("inverse_square_excess")(radius, distance), rtol=1e-9, atol=1e-14)
    assert twin("inverse_square_excess")(0.5, 5.0) == pytest.approx(0.01)  # five diameters
    assert twin("inverse_square_excess")(0.5, 2.5) == pytest.approx(0.04)  # five radii


def test_nothing_gives_more_than_pi_l_and_the_point_gives_anything():
    near = np.array([1e-3, 1e-6])
    assert np.all(twin("irradiance_disk")(1.0, 1.0, near, 0.0) <= np.pi)
    assert twin("irradiance_sphere")(1.0, 1.0, 1.0, 0.0) <= np.pi
    assert twin("irradiance_point")(1.0, 0.0, 0.0) == np.inf
    assert twin("irradiance_point")(1.0, 1.0, 2.0) == 0, "from below comes nothing, never less"
    assert twin("irradiance_point")(1.0, 1e-20, 0.0) == pytest.approx(1e40)


def test_the_flux_of_a_flat_lamp_is_the_integral_of_its_intensity():
    for half in (0.2, 1.0, np.pi / 2):
        integral, _ = quad(lambda a: twin("radiant_intensity_lambert")(5.0, a) * 2 * np.pi * np.sin(a), 0, half)
        assert twin("radiant_flux_lambert_cone")(5.0, half) == pytest.approx(integral, rel=1e-10)
        mean = twin("radiant_intensity_cone")(integral, half)
        assert twin("radiant_intensity_lambert_cone")(5.0, half) == pytest.approx(mean, rel=1e-10)
    assert twin("radiant_intensity_lambert_cone")(5.0, 0.0) == pytest.approx(5 / np.pi)
    assert twin("radiant_flux_lambert_cone")(5.0, 3.0) == pytest.approx(5.0)


def test_the_sensor_reads_the_walls_radiance_however_it_is_turned():
    theta, half = RNG.uniform(0, 1.0, 100), RNG.uniform(0.01, 0.5, 100)
    read = twin("radiance_sensor")(100.0, 1e-4, half, theta)
    assert np.allclose(read, 100 * np.cos(half / 2) ** 2, rtol=1e-12)
    assert np.allclose(twin("radiance_sensor_projected")(100.0, 1e-4, half, theta), 100, rtol=1e-14)
    far = twin("radiance_twice_as_far")(half, RNG.uniform(0.1, 100, 100))
    assert np.allclose(far, 1, rtol=1e-14)
    assert twin("radiance_sensor_projected")(100.0, 1e-4, 0.1, 3.0) == 0, "the opening is behind the sensor"


def test_a_matt_surface_sends_out_what_it_says():
    rho, irradiance = 0.8, 500.0
    out, _ = dblquad(lambda theta, phi: twin("intensity_per_area_lambert")(rho, irradiance, theta) * np.sin(theta),
                     0, 2 * np.pi, 0, np.pi / 2)
    sent = twin("radiant_exitance_reflected")(rho, irradiance)
    assert out == pytest.approx(sent, rel=1e-10)
    assert sent + twin("radiant_exitance_absorbed")(rho, irradiance) == pytest.approx(irradiance, rel=1e-15)
    assert twin("radiant_exitance_lambert")(twin("radiance_lambert")(rho, irradiance)) == pytest.approx(sent)


def test_energy_is_the_integral_of_flux():
    flux = twin("radiant_flux_mean")(60.0, 0.4)
    for time in (0.1, 0.4, 2.0):
        integral, _ = quad(lambda t: flux * (t < 0.4), 0, time, points=[0.4] if time > 0.4 else None)
        assert twin("radiant_energy_emitted")(60.0, 0.4, time) == pytest.approx(integral, rel=1e-8)
    assert twin("radiant_energy_emitted")(60.0, 0.4, -1.0) == 0


# --- photometry ------------------------------------------------------------------------------------------------------
def test_the_table_of_v():
    assert len(V_LAMBDA) == 81 and V_LAMBDA.max() == 1 and twin("luminous_efficiency")(555.0) == 1
    assert 5 * V_LAMBDA.sum() == pytest.approx(106.857, abs=2e-3)  # CIE 018: the integral, in nm
    assert twin("luminous_efficiency")(557.5) == pytest.approx((1 + 0.995) / 2)
    assert np.all(twin("luminous_efficiency")(np.array([300.0, 379.9, 780.1, 2000.0])) == 0)
    assert twin("luminous_efficacy_monochromatic")(555.0) == K_M
    assert twin("luminous_efficiency")(555.17) * K_M == pytest.approx(683, rel=3e-4)  # 540 THz in vacuum


def test_the_decks_bulb():
    flux = twin("luminous_flux_source")(100.0, 30.0)
    assert flux == 3000
    assert twin("luminous_intensity_isotropic")(flux) == pytest.approx(238.73241463784300365, **CLOSE)
    assert twin("illuminance_isotropic")(flux, 2.5, 0.0) == pytest.approx(38.197186342054880585, **CLOSE)
    assert twin("luminous_flux_radiated")(1.0, 683.0) == 683 != K_M
    assert twin("radiant_intensity_540thz")(683.0) == 1


def test_a_black_body():
    for temperature in (1500.0, 2856.0, 6500.0):
        whole, _ = quad(lambda nm, t=temperature: twin("planck_radiance")(nm, t), 30, 3e5, limit=800,
                        points=[WIEN / temperature, 5e3, 3e4])
        assert whole == pytest.approx(STEFAN / np.pi * temperature**4, rel=2e-4)
        nm = np.linspace(0.8, 1.2, 4001) * WIEN / temperature
        assert nm[np.argmax(twin("planck_radiance")(nm, temperature))] == pytest.approx(WIEN / temperature, rel=2e-4)
    long = twin("planck_radiance")(1e9, 6000.0)
    assert long == pytest.approx(C_1 / C_2 * 6000 / 1e36, rel=2e-6)  # Rayleigh and Jeans: 2 c k T / wavelength^4


def test_what_black_bodies_are_worth():
    temperature = np.arange(5500.0, 7600.0, 10.0)
    worth = twin("luminous_efficacy_planck")(temperature)
    assert worth.max() == pytest.approx(95.4, abs=0.1) and temperature[worth.argmax()] == pytest.approx(6620, abs=40)
    fine, _ = quad(lambda nm: twin("luminous_efficiency")(nm) * twin("planck_radiance")(nm, 6600.0), 380, 780,
                   limit=500, points=np.arange(385, 780, 5))
    assert twin("luminous_efficacy_planck")(6600.0) == pytest.approx(
        K_M * fine / (STEFAN / np.pi * 6600.0**4), rel=1e-4)
    band = twin("luminous_efficacy_band")(5800.0, 400.0, 700.0)
    assert band == pytest.approx(251, abs=0.5), "Murphy 2012"
    kinks = np.arange(405, 700, 5)
    seen, whole = (quad(lambda nm, weigh=weigh: weigh(nm) * twin("planck_radiance")(nm, 5800.0), 400, 700, limit=500,
                        points=kinks)[0] for weigh in (twin("luminous_efficiency"), np.ones_like))
    assert band == pytest.approx(K_M * seen / whole, rel=1e-4)
    assert twin("luminous_efficacy_planck")(2700.0) == pytest.approx(12.4, abs=0.1)  # a filament, all in all


def test_two_wavelengths_of_a_black_body():
    nm, other, temperature = (RNG.uniform(low, high, 300) for low, high in ((380, 2000), (380, 780), (800, 2e4)))
    quotient = twin("planck_radiance")(nm, temperature) / twin("planck_radiance")(other, temperature)
    assert np.allclose(twin("planck_relative")(nm, other, temperature), quotient, rtol=1e-12, atol=0)


def test_lamps():
    worth = twin("luminous_efficacy_lamp")
    assert worth(2, 3000.0) == pytest.approx(K_M * 106.857 / 400, rel=1e-4)
    assert 300 < worth(1, 3000.0) < 370 and worth(1, 3000.0) == worth(1, 9000.0)
    assert worth(0, 3000.0) == twin("luminous_efficacy_planck")(3000.0)
    nm = np.arange(380.0, 781.0)
    for lamp in (0, 1, 2):
        for temperature in (1000.0, 4000.0, 20000.0):
            assert twin("lamp_spectrum")(lamp, nm, temperature).max() == pytest.approx(1, abs=0.01)


def test_srgb_goes_there_and_back():
    x = np.linspace(0, 1, 1001)
    back = twin("srgb_to_linear")(twin("linear_to_srgb")(x))
    assert np.allclose(back, x, rtol=2e-6, atol=0)  # at the joint the standard's two pieces differ
    assert np.all(np.diff(twin("linear_to_srgb")(x)) > 0)


def test_the_pictures_srgb_needs_no_power():
    """glsl/display takes a cubic in the fourth root: less than a tenth of a step of 8 bits from the twin."""
    x = np.concatenate([np.linspace(0, 1, 20001), np.geomspace(1e-6, 1, 5000), [0.0031308, 0.00313081]])
    text = '#include "display/srgb.glsl"\nfloat shown(float x) { return srgb_from_linear(vec3(x)).y; }'
    shown = evaluate("shown", {"x": x}, text)
    assert np.max(np.abs(255 * (shown - twin("linear_to_srgb")(x)))) < 0.06
    assert shown[0] == 0 and abs(shown[20000] - 1) < 3e-4


# --- what local shading leaves out -----------------------------------------------------------------------------------
ROOM = {"lamp_x": 1.7, "lamp_height": 1.6, "radiant_intensity": 20.0}
BALL, RADIUS = np.array([1.1, 0.0, 0.5]), 0.3


def hits(start, towards):
    """Whether rays of unit direction meet the ball, and how far away: a second way to see past it."""
    to = BALL - start
    along = np.sum(to * towards, -1)
    inside = RADIUS**2 - (np.sum(to * to, -1) - along**2)
    return np.where((inside > 0) & (along > 0), along - np.sqrt(np.maximum(inside, 0)), np.inf)


def followed(from_wall: float, along_wall: float, rho: float, count: int = 400_000) -> float:
    """The wall's light at a point of the floor, by random rays with the cosine's density from the point."""
    u, v = RNG.random((2, count))
    d = np.stack([np.sqrt(u) * np.cos(2 * np.pi * v), np.sqrt(u) * np.sin(2 * np.pi * v), np.sqrt(1 - u)], -1)
    point, lamp = np.array([from_wall, along_wall, 0.0]), np.array([ROOM["lamp_x"], 0.0, ROOM["lamp_height"]])
    reach = np.where(d[:, 0] < 0, -point[0] / np.minimum(d[:, 0], -1e-300), np.inf)
    met = point + np.where(np.isfinite(reach), reach, 0)[:, None] * d
    on_wall = np.isfinite(reach) & (np.abs(met[:, 1]) <= 1) & (met[:, 2] <= 2) & (hits(point, d) > reach)
    way = lamp - met
    far = np.linalg.norm(way, axis=-1)
    lit = hits(met, way / far[:, None]) > far
    return float(np.mean(on_wall * lit * rho * ROOM["radiant_intensity"] * way[:, 0] / far**3))


@pytest.mark.parametrize("place", [(0.3, 0.0), (0.75, 0.0), (0.9, 0.4), (1.6, -0.7)])
def test_the_walls_light_is_what_followed_rays_say(place):
    rays = followed(*place, 0.8)
    cells = twin("irradiance_floor_bounced")(from_wall=place[0], along_wall=place[1], rho=0.8, **ROOM)
    assert cells == pytest.approx(rays, rel=0.02)


def test_a_finer_wall_changes_what_the_docstring_says(monkeypatch):
    from app.optics import room

    x, y = np.meshgrid([0.2, 0.3, 0.5, 0.9, 1.6, 2.4], [0.0, 0.4, 1.0])
    for lamp_x, lamp_height in ((1.75, 1.6), (2.2, 1.1), (0.6, 2.0)):
        lamp = {"lamp_x": lamp_x, "lamp_height": lamp_height, "radiant_intensity": 20.0}
        monkeypatch.setattr(room, "CELLS", 10)
        coarse = room.irradiance_floor_bounced(x, y, rho=0.8, **lamp)
        monkeypatch.setattr(room, "CELLS", 80)
        fine = room.irradiance_floor_bounced(x, y, rho=0.8, **lamp)
        assert np.all(np.abs(coarse - fine) < 0.02 * room.irradiance_floor_local(x, y, **lamp))


def test_the_shadow_is_the_balls():
    x, y = np.meshgrid(np.linspace(0.1, 2.4, 60), np.linspace(-1, 1, 60))
    local, shadowed = (twin(f"irradiance_floor_{kind}")(x, y, **ROOM) for kind in ("local", "shadowed"))
    points = np.stack([x, y, 0 * x], -1)
    way = np.array([ROOM["lamp_x"], 0.0, ROOM["lamp_height"]]) - points
    far = np.linalg.norm(way, axis=-1)
    blocked = hits(points, way / far[..., None]) < far
    assert np.array_equal(shadowed, np.where(blocked, 0, local)) and 0.03 < blocked.mean() < 0.2
    straight = twin("irradiance_point")(20.0, far, np.arccos(ROOM["lamp_height"] / far))
    assert np.allclose(local, straight, rtol=1e-12)


def test_the_second_renderer_is_local_too():
    """pyrender lights the floor as irradiance_floor_local does, and casts no shadow where the ball stands between."""
    from app.lesson import Camera
    from app.reference import Light, Shot, linear, render

    square = np.array([[[0, -1, 0], [2.4, -1, 0], [2.4, 1, 0]], [[0, -1, 0], [2.4, 1, 0], [0, 1, 0]]], float)
    above = square * [0.1, 0.1, 1] + [BALL[0] - 0.12, 0.0, BALL[2]]  # a shade where the ball is, seen edge-on from afar
    lamp = Light("point", (ROOM["lamp_x"], 0.0, ROOM["lamp_height"]), ROOM["radiant_intensity"] / 4)
    view = Camera(azimuth=-90, elevation=89.9, distance=8, target=(1.2, 0.0, 0.0), field_of_view=18.0)
    pictures = [render(Shot(mesh, light=lamp, camera=view, size=(96, 96)))[0]
                for mesh in (square, np.concatenate([square, above]))]
    plain, blocked = (linear(picture.rgb)[..., 0] for picture in pictures)
    shadow = twin("irradiance_floor_shadowed")(0.7, 0.0, **ROOM)
    assert shadow == 0, "the ball's shadow lies at 0.7 m"
    half = 8 * np.tan(np.radians(9.0))
    column = round((0.7 - 1.2 + half) / (2 * half) * 96)
    assert blocked[48, column] == pytest.approx(plain[48, column], rel=0.02), "no shadow there"
    row = plain[48, [round((x - 1.2 + half) / (2 * half) * 96) for x in (0.6, 1.2, 1.8)]]
    ours = twin("irradiance_floor_local")(np.array([0.6, 1.2, 1.8]), 0.0, **ROOM)
    assert row / row[1] == pytest.approx(ours / ours[1], rel=0.06)


def test_the_second_renderer_casts_the_same_shadow():
    """pyrender's spot light has a shadow map: with and without it, floor and ball, against our twins pixel by pixel."""
    from app.lesson import Camera
    from app.meshes import built_in
    from app.reference import Light, Shot, linear, render

    lamp = np.array([ROOM["lamp_x"], 0.0, ROOM["lamp_height"]])
    floor = np.array([[[0, -1, 0], [2.4, -1, 0], [2.4, 1, 0]], [[0, -1, 0], [2.4, 1, 0], [0, 1, 0]]], float)
    mesh = np.concatenate([floor, BALL + RADIUS * np.asarray(built_in("sphere").triangles)])
    spot = Light("spot", tuple(lamp), ROOM["radiant_intensity"] / 4, to=(0.9, 0.0, 0.0), half_angle=0.6)
    view = Camera(azimuth=-90, elevation=89.9, distance=8, target=(0.9, 0.0, 0.0), field_of_view=10.0)
    size = 192
    shot = Shot(mesh, light=spot, camera=view, size=(size, size), two_sided=False)
    without, shaded = render(shot, replace(shot, shadows=True))
    half = 8 * np.tan(np.radians(5.0)) * ((np.arange(size) + 0.5) / size * 2 - 1)
    x, y = np.meshgrid(0.9 + half, -half)
    way = np.stack([x, y, 0 * x], -1) - lamp
    axis = np.array([0.9, 0.0, 0.0]) - lamp
    cosine = way @ axis / np.linalg.norm(way, axis=-1) / np.linalg.norm(axis)
    seen = (without.depth > 7.9) & (np.abs(y) < 0.95) & (x > 0.05) & (cosine > np.cos(0.55))
    plain, dark = (linear(picture.rgb)[..., 0] for picture in (without, shaded))
    theirs, ours = dark < 0.5 * plain, twin("irradiance_floor_shadowed")(x, y, **ROOM) == 0
    assert seen.sum() > 8000 and 0.1 < ours[seen].mean() < 0.5
    assert np.mean(theirs[seen] != ours[seen]) < 0.01, "they differ at the shadow's rim only"
    ratio = (plain / twin("irradiance_floor_local")(x, y, **ROOM))[seen]
    assert np.mean(np.abs(ratio / np.median(ratio) - 1) > 0.06) < 0.005, "and without it, as our local picture"


def test_a_closed_room_adds_up():
    """In a sphere each reflection spreads the light evenly: the sum of all of them, step by step."""
    light, total = 1.0, 0.0
    for _ in range(400):
        total += light
        light *= 0.8
    assert twin("interreflection_gain")(0.8) == pytest.approx(total, rel=1e-12) == pytest.approx(5)


def test_each_new_quantity_says_what_it_is():
    for name in ("radiant_flux", "radiance", "luminous_flux", "wavelength", "temperature", "from_wall"):
        q = TABLE[name]
        assert q.symbol and q.unit and q.words and q.low < q.high
