"""Lights: identities, limits, second ways, and how fast sampled estimates converge to the closed form."""

from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import dblquad, quad

from app import catalog
from app.gpu.evaluate import evaluate
from app.grade.live import verdicts
from app.inspection import inspect
from app.optics import (
    area_light,
    distribution,
    light_samples,
    light_shape,
    punctual,
    shape_samples,
    spherical_rectangle,
    spot,
)
from app.optics import filter as filters
from app.optics.solid_angle_flat import solid_angle_rectangle_off_axis
from app.tolerance import FACTOR, ratio

PANEL = {"light_shape": 0, "radiance": 10.0, "light_x": 0.2, "light_y": 0.1, "light_height": 0.6, "panel_width": 1.4,
         "panel_depth": 0.9, "panel_tilt": -0.3}
FLAT = PANEL | {"light_x": 0.0, "light_y": 0.0, "light_height": 0.5, "panel_width": 2.0, "panel_depth": 2.0,
                "panel_tilt": 0.0}
HERE = (0.1, -0.4, 0.0)
KINDS = {"grid": 0, "random": 1, "stratified": 2, "Sobol": 3, "Sobol in solid angle": 4, "Gauss in solid angle": 5}


# --- punctual --------------------------------------------------------------------------------------------------------
def test_a_point_light_where_it_meets_the_surface():
    assert punctual.irradiance_positional(1.0, 0.0, 0.0, 0.0) == np.inf, "the formula as it is"
    assert punctual.irradiance_positional(1.0, 0.0, 0.0, 0.1) == pytest.approx(100.0), "no closer than the radius"
    assert punctual.irradiance_at((1, 2, 0), (0, 0, 1), (1, 2, 0), 5.0, 0.1) == 0.0, "no direction, nothing"
    assert np.all(punctual.direction_to_light((1, 2, 3), (1, 2, 3)) == 0.0)


def test_behind_the_surface_there_is_no_light():
    assert punctual.irradiance_at((0, 0, 0), (0, 0, 1), (0.3, 0.1, -1.0), 5.0, 0.01) == 0.0
    assert punctual.irradiance_positional(5.0, 1.0, 2.0, 0.01) == 0.0
    assert punctual.irradiance_directional(5.0, 2.0) == 0.0


def test_flux_zero_and_negative():
    """Nothing for nothing; what is negative stays so, and the stage marks it."""
    assert distribution.radiant_intensity_of(0.0, 2, 4.0, 0.3) == 0.0
    assert distribution.radiant_intensity_of(-2.0, 1, 1.0, 0.3) < 0
    assert spot.spot_intensity(0.0, 0.2, 0.4) == 0.0 and spot.spot_intensity(-1.0, 0.2, 0.4) < 0
    assert light_shape.light_radiance(0, -1.0, 0, 1.0, 1.0) < 0


def test_lights_without_area():
    assert area_light.radiance_sphere(1.0, 0.0) == np.inf
    assert np.all(light_shape.light_radiance(0, 1.0, np.arange(4), 0.0, 1.0) == np.inf)
    flat = PANEL | {"panel_width": 0.0}
    assert light_shape.irradiance_light(**flat, position=HERE) == 0.0
    for kind in KINDS.values():
        assert shape_samples.irradiance_light_sampled(**flat, position=HERE, sampling=kind, level=2, seed=1) == 0.0


def test_a_lamp_in_the_floor_is_cut_at_the_horizon():
    inside = area_light.irradiance_sphere_light(3.0, 0.5, 0.2, 1.0)
    assert inside == pytest.approx(3.0 * np.pi), "from inside it is everywhere"
    upright = PANEL | {"panel_tilt": -np.pi / 2, "light_height": 0.0, "light_y": 1.0}
    above = upright | {"light_height": PANEL["panel_depth"] / 4, "panel_depth": PANEL["panel_depth"] / 2}
    cut, whole = (light_shape.irradiance_light(**panel, position=HERE) for panel in (upright, above))
    assert cut == pytest.approx(whole, rel=1e-12), "only the upper half counts"
    assert light_shape.irradiance_light(**upright | {"light_height": -1.0}, position=HERE) == 0.0


def test_directional_is_the_limit_of_positional():
    distance = 10.0 ** np.arange(1, 8)
    near = punctual.irradiance_at((0, 0, 0), (0, 0, 1), np.stack([0 * distance, 0 * distance, distance], -1),
                                  7.0 * distance**2, 0.01)
    far = punctual.irradiance_at((2, 0, 0), (0, 0, 1), np.stack([0 * distance, 0 * distance, distance], -1),
                                 7.0 * distance**2, 0.01)
    assert near == pytest.approx(np.full(7, punctual.irradiance_directional(7.0, 0.0)))
    lost = punctual.falloff_error(distance, 2.0)
    assert lost[:3] == pytest.approx((1 - far / near)[:3], rel=1e-9)
    assert lost / punctual.falloff_error_far(distance, 2.0) == pytest.approx(1.0, abs=0.06)


def test_the_window_ends_smoothly_and_keeps_half_at_one_metre():
    assert punctual.windowed_falloff(1.0, 1e4) == pytest.approx(0.5)
    assert punctual.windowed_falloff([10.0, 11.0], 10.0) == pytest.approx([0, 0])
    assert punctual.windowed_falloff(10 - 1e-4, 10.0) < 1e-10, "with its slope"


# --- distributions and spots -----------------------------------------------------------------------------------------
@pytest.mark.parametrize(("kind", "exponent"), [(0, 1.0), (1, 1.0), (2, 0.0), (2, 3.5), (2, 40.0)])
def test_a_distribution_sums_to_one(kind, exponent):
    total, _ = quad(lambda a: 2 * np.pi * np.sin(a) * distribution.emission(kind, exponent, a), 0, np.pi,
                    points=[np.pi / 2], epsabs=1e-12)
    assert total == pytest.approx(1.0, abs=1e-10)
    assert distribution.radiant_flux_of(distribution.emission(2, exponent, 0.0), exponent) == pytest.approx(1.0)


def test_irradiance_of_a_distribution_by_the_other_way():
    for offset in (0.0, 0.7, 3.0):
        theta = np.arctan2(offset, 1.3)
        intensity = distribution.radiant_intensity_of(20.0, 2, 5.0, theta)
        way = punctual.irradiance_at((offset, 0, 0), (0, 0, 1), (0, 0, 1.3), intensity, 1e-6)
        assert distribution.irradiance_distribution(20.0, 2, 5.0, 1.3, offset) == pytest.approx(way, rel=1e-13)


@pytest.mark.parametrize(("hotspot", "falloff"), [(0.3, 0.5), (0.01, 1.2), (0.4, 0.4), (0.6, 0.4)])
@pytest.mark.parametrize("shape", [spot.spot_linear, spot.spot_smooth])
def test_the_flux_of_a_spot(shape, hotspot, falloff):
    """Linear and smooth have the same; H = F and H > F are the cone of F."""
    total, _ = quad(lambda a: 2 * np.pi * np.sin(a) * shape(a, hotspot, falloff), 0, 1.5, points=[hotspot, falloff])
    assert spot.spot_flux(1.0, hotspot, falloff) == pytest.approx(total, rel=1e-8)
    assert spot.spot_flux(spot.spot_intensity(12.0, hotspot, falloff), hotspot, falloff) == pytest.approx(12.0)


def test_a_hard_edge():
    for hotspot in (0.4, 0.9):
        assert spot.spot_linear([0.0, 0.39, 0.4, 0.41], hotspot, 0.4).tolist() == [1, 1, 1, 0]
        assert spot.spot_smooth([0.39, 0.41], hotspot, 0.4).tolist() == [1, 0]
    assert spot.spot_linear_cos(np.cos([0.39, 0.41]), 0.4, 0.4).tolist() == [1, 0]


def test_the_spot_by_angle_and_by_cosine():
    angle = np.linspace(0, 3, 301)
    assert spot.spot_linear_cos(np.cos(angle), 0.3, 0.5) == pytest.approx(spot.spot_linear(angle, 0.3, 0.5), abs=1e-13)


def test_the_printed_spot_makes_negative_light():
    """D4 of the optics reference: -0.64 at 35 degrees, -1.36 at 40."""
    hotspot, falloff, printed = np.radians([20.0, 30.0, 90.0])
    found = spot.spot_as_printed(np.radians([10, 25, 35, 40, 100]), hotspot, falloff, printed)
    assert found[2:4] == pytest.approx([-0.64, -1.36], abs=0.01)
    assert found[0] == 1 and found[4] == 0
    assert found[1] == pytest.approx(spot.spot_linear(np.radians(25), hotspot, falloff))


def test_three_ways_to_misread_the_spot():
    """D4 of the optics reference: 3.8 times the flux by full angles; no light with the other sign."""
    hotspot, falloff = np.radians([20.0, 30.0])
    flux = [spot.spot_read_flux(100.0, hotspot, falloff, reading) for reading in range(3)]
    assert flux[0] == pytest.approx(61, abs=0.5) and flux[1] / flux[0] == pytest.approx(3.8, abs=0.05) and flux[2] == 0
    ahead = np.linspace(0, np.pi / 2, 91)
    for edge in (0, 1):
        assert np.all(spot.spot_read(ahead, hotspot, falloff, 0.9, edge, 2) == 0)
        assert spot.spot_read(np.pi, hotspot, falloff, 0.9, edge, 2) == 1, "it is behind the lamp"
    assert np.all(spot.spot_read(ahead, hotspot, falloff, np.pi / 2, 2, 2) == 0), "none to a right angle"
    assert np.all(spot.spot_read(ahead[20:], hotspot, falloff, np.radians(170.0), 2, 2) < 0), "beyond: negative light"
    for reading, wide in ((0, 1.0), (1, 2.0)):
        def ring(a, reading=reading):
            return 200 * np.pi * np.sin(a) * spot.spot_read(a, hotspot, falloff, 0.9, 0, reading)

        total, _ = quad(ring, 0, 1.5, points=[wide * hotspot, wide * falloff])
        assert total == pytest.approx(flux[reading], rel=1e-8)


# --- area lights -----------------------------------------------------------------------------------------------------
def by_area(position, cosine: bool = True) -> float:
    panel = {k: v for k, v in PANEL.items() if k not in ("radiance", "light_shape")}
    out = np.array([0, np.sin(PANEL["panel_tilt"]), -np.cos(PANEL["panel_tilt"])])

    def share(t, s):
        way = area_light.panel_point(**panel, s=s, t=t) - position
        r = np.sqrt(way @ way)
        return way[2] / r * (-(out @ way) / r if cosine else 1.0) / r**2

    return PANEL["radiance"] * PANEL["panel_width"] * PANEL["panel_depth"] * dblquad(share, 0, 1, 0, 1, epsabs=1e-11)[0]


@pytest.mark.parametrize("position", [HERE, (0.0, 0.0, 0.0), (1.5, 1.0, 0.0)])
def test_the_panel_by_area_integration(position):
    exact = light_shape.irradiance_light(**PANEL, position=position)
    assert exact == pytest.approx(by_area(np.array(position)), rel=1e-8)


@pytest.mark.parametrize("kind", range(4))
def test_flux_radiance_and_exitance_convert(kind):
    """Any one of the three gives the others, and back; the flux is the radiance over area and half space."""
    size = {"light_shape": kind, "panel_width": 2.0, "panel_depth": 3.0}
    number = light_shape.light_flux, light_shape.light_exitance, light_shape.light_radiance
    flux, exitance, radiance = (f(0, 12.0, **size) for f in number)
    for given, amount in enumerate((flux, exitance, radiance)):
        assert [f(given, amount, **size) for f in number] == pytest.approx([12.0, exitance, radiance], rel=1e-15)
    area = {0: 6.0, 1: np.pi, 2: 4 * np.pi, 3: 0.68 * 6.0}[kind]
    assert light_shape.light_area(**size) == pytest.approx(area)
    half_space, _ = quad(lambda a: 2 * np.pi * np.sin(a) * np.cos(a), 0, np.pi / 2)
    assert flux == pytest.approx(radiance * area * half_space)
    if kind == 2:
        assert radiance == pytest.approx(area_light.radiance_sphere(12.0, 1.0))


def test_the_pentagon_has_the_area_it_is_said_to_have():
    x, y = area_light.outline_at(5, np.arange(6)).T
    assert np.sum(x[:-1] * y[1:] - x[1:] * y[:-1]) / 2 == pytest.approx(0.68)
    at = light_samples.grid_sample(np.arange(4**9), 9)
    assert shape_samples.shape_holds(3, at[:, 0], at[:, 1]).mean() == pytest.approx(0.68, abs=1e-3)
    assert shape_samples.shape_holds(1, at[:, 0], at[:, 1]).mean() == pytest.approx(np.pi / 4, abs=1e-3)
    corners = area_light.outline_at(5, np.arange(5))
    for scale, inside in ((0.999, 1.0), (1.001, 0.0)):
        assert np.all(shape_samples.shape_holds(3, *(0.5 + scale * (corners - 0.5)).T) == inside)


def test_a_sphere_is_a_point_and_a_disk_is_one_at_five_times():
    radius, distance, theta = 0.5, 2.0, 0.7
    point = punctual.irradiance_positional(20.0 / (4 * np.pi), distance, theta, 1e-3)
    assert area_light.irradiance_lamp(20.0, radius, distance, theta) == pytest.approx(point, rel=1e-14)
    disk = area_light.irradiance_disk_light(1.0, 0.5, 5.0, 0.0)
    assert np.pi * 0.25 / 25.0 / disk - 1 == pytest.approx(0.01, abs=1e-3), "five diameters away: 1 %"


def test_the_emitters_cosine_is_easily_forgotten():
    """D15 of the optics reference: 1.42 times for a 2 x 2 panel at height 0.5."""
    right = light_shape.irradiance_light(**FLAT, position=(0.0, 0.0, 0.0))
    wrong = shape_samples.irradiance_light_without_cosine(**FLAT, position=(0.0, 0.0, 0.0), level=6)
    assert wrong / right == pytest.approx(1.42, abs=0.005)
    centre = shape_samples.irradiance_light_sampled(**FLAT, position=(0.0, 0.0, 0.0), sampling=0, level=0, seed=0)
    assert centre / right - 1 == pytest.approx(5.1, abs=0.05)


def test_the_cells_of_a_spherical_rectangle_are_equal():
    """Each of 8 x 8 cells in (s, t) takes a 64th of the solid angle: the area of its image on the sphere."""
    x0, x1, y0, y1, d = -0.3, 1.7, 0.2, 0.9, 0.4
    total = solid_angle_rectangle_off_axis(x0, x1, y0, y1, d)
    s, t = np.meshgrid((np.arange(8) + 0.5) / 8, (np.arange(8) + 0.5) / 8)
    step = 1e-5

    def unit(s, t):
        p = spherical_rectangle.spherical_rectangle_point(x0, x1, y0, y1, d, s, t)
        return p / np.linalg.norm(p, axis=-1, keepdims=True)

    along, across = ((unit(s + step * a, t + step * b) - unit(s - step * a, t - step * b)) / (2 * step)
                     for a, b in ((1, 0), (0, 1)))
    assert np.linalg.norm(np.cross(along, across), axis=-1) == pytest.approx(np.full((8, 8), total), rel=1e-7)
    ends = spherical_rectangle.spherical_rectangle_point(x0, x1, y0, y1, d, np.array([0.0, 1.0]), np.array([0.0, 1.0]))
    assert ends == pytest.approx(np.array([[x0, y0, d], [x1, y1, d]]))


@pytest.mark.parametrize("level", [1, 2, 3, 4])
def test_sobol_points_fill_every_cell(level):
    """A (0,2)-sequence: 4^level points, one to each of the rectangles of that area, whatever the seed."""
    index = np.arange(4**level)
    for seed in (0, 1, 12345):
        at = light_samples.sobol_sample(index, seed)
        for columns in (4**level, 2**level, 1):
            cells = (at * [columns, 4**level / columns]).astype(int)
            assert len({tuple(c) for c in cells.tolist()}) == 4**level


def test_random_numbers_are_even():
    x = light_samples.random_number(np.arange(40000), 3)
    counts = np.histogram(x, 64, (0, 1))[0]
    assert np.sum((counts - 625) ** 2 / 625) < 104, "chi-squared, 63 degrees of freedom, level 0.001"
    assert abs(np.corrcoef(x[:-1], x[1:])[0, 1]) < 0.02


@pytest.mark.parametrize("level", range(6))
def test_weights_of_a_rule_sum_to_one(level):
    assert np.sum(light_samples.gauss_sample(np.arange(4**level), level)[:, 2]) == pytest.approx(1.0, rel=1e-14)


def rms(kind: str, level: int, seeds: int = 24) -> float:
    exact = light_shape.irradiance_light(**PANEL, position=HERE)
    seed = 1000 + 17 * np.arange(seeds)
    found = shape_samples.irradiance_light_sampled(**PANEL, position=HERE, sampling=KINDS[kind], level=level, seed=seed)
    return float(np.sqrt(np.mean((found / exact - 1) ** 2)))


@pytest.mark.parametrize(("kind", "low", "high"), [
    ("random", 0.40, 0.60), ("stratified", 0.80, 1.2), ("Sobol", 0.8, 2.0), ("Sobol in solid angle", 0.8, 2.0),
    ("grid", 0.9, 1.1)])
def test_the_order_of_convergence(kind, low, high):
    """optics reference 4.3: the slope of log RMSE against log N, 24 seeds, N = 64 to 16384."""
    levels = np.arange(3, 8)
    order = -np.polyfit(levels * np.log(4), np.log([rms(kind, level) for level in levels]), 1)[0]
    assert low <= order <= high, order


def test_gauss_points_converge_faster_than_any_power():
    errors = [rms("Gauss in solid angle", level, 1) for level in range(4)]
    assert errors[3] < 1e-8, errors
    assert all(after <= before**1.4 for before, after in pairwise(errors) if after > 1e-12), errors


def test_every_kind_meets_the_closed_form():
    for kind in KINDS:
        assert rms(kind, 6, 4) < (0.02 if kind == "random" else 3e-3)


# --- the exercise ----------------------------------------------------------------------------------------------------
SPOT = next(x for loaded in catalog.chapters() if loaded.id == "lights" for x in loaded.chapter.exercises)
MISTAKES = {  # what it replaces and by what, in each language
    "no clamp": {"python": ("0.0, 1.0)\n", "-9.0, 9.0)\n"), "glsl": ("0.0, 1.0);", "-9.0, 9.0);")},
    "full angles": {"python": ("0.5 * (falloff - angle)", "0.25 * (falloff - angle)"),
                    "glsl": ("0.5 * (falloff - angle)", "0.25 * (falloff - angle)")},
    "no hard edge": {"python": ("hard = hotspot >= falloff", "hard = hotspot > falloff + 9"),
                     "glsl": ("if (hotspot >= falloff)", "if (hotspot > falloff + 9.0)")},
}


@pytest.mark.parametrize("language", ["python", "glsl"])
@pytest.mark.parametrize("mistake", MISTAKES)
@pytest.mark.filterwarnings("ignore:invalid value", "ignore:divide by zero")
def test_a_mistake_in_the_spot_is_found(mistake, language, ctx):
    old, new = MISTAKES[mistake][language]
    text = SPOT.solutions[language]
    assert text.count(old) == 1
    found = verdicts(f"lights/{SPOT.name}", language, text.replace(old, new))
    assert not found.ok and not found.said


def test_cosines_fail_for_a_narrow_beam_in_float32(ctx):
    """The slide's own differences, clamped: right on paper, and lost in seven digits."""
    text = """float spot_linear(float off_axis, float hotspot, float falloff) {
    if (hotspot >= falloff) return off_axis <= falloff ? 1.0 : 0.0;
    return clamp(1.0 - (cos(hotspot) - cos(off_axis)) / (cos(hotspot) - cos(falloff)), 0.0, 1.0);
}"""
    wide = {"off_axis": np.array([0.5, 0.625]), "hotspot": np.array([0.25, 0.375]), "falloff": np.array([0.75, 1.0])}
    narrow = {name: angle * 2.0**-12 for name, angle in wide.items()}
    far = [ratio("spot_linear", args, evaluate("spot_linear", args, text), "float32") for args in (narrow, wide)]
    assert far[0].min() > 1000 * FACTOR and far[1].max() < FACTOR


# --- filters ---------------------------------------------------------------------------------------------------------
def test_filters_at_their_ends():
    assert filters.toksvig_exponent([1.0, 0.0, 0.5], [50.0, 50.0, 0.0]).tolist() == [50, 0, 0]
    assert filters.toksvig_exponent(0.0, 0.0) == 0
    around = filters.vmf_mean_length(np.array([0.5 - 1e-12, 0.5 + 1e-12]))
    assert np.ptp(around) < 1e-12 and filters.vmf_mean_length(0.0) == 0 and filters.vmf_mean_length(1e300) == 1


# --- scenes ----------------------------------------------------------------------------------------------------------
AREA = {"sources", "area_units", "area_sampled", "area_exact", "area_work"}


@pytest.mark.parametrize("found", [f for f in catalog.steps() if f.id.startswith("lights/")], ids=lambda f: f.id)
def test_scenes_without_area_lights_compile_none_of_it(found):
    files = " ".join(inspect(found).files)
    area = found.step.name in AREA
    assert ("area_light" in files) == area
    sampled = found.step.name in {"area_sampled", "area_work"}
    assert ("shape_samples" in files) == ("light_samples" in files) == ("spherical_rectangle" in files) == sampled
    assert ("light_shape" in files) == (area and found.step.name != "sources")
