"""Bumps that turn into roughness, by a second method: integrals by scipy and mpmath, counts, filtered waves."""

import itertools
from dataclasses import replace

import mpmath
import numpy as np
import pytest
from scipy import integrate, special

from app import camera
from app.catalog import step
from app.gpu.evaluate import evaluate
from app.gpu.pick import raw
from app.gpu.stage import Stage
from app.gpu.stage_text import Source
from app.maps import NONE
from app.mesh_edges import corner_normals
from app.meshes import built_in
from app.optics import bumpy_ball
from app.optics.beckmann import d_beckmann_slope
from app.optics.board import dgf_at, mirror_gain
from app.optics.bumpy_ball import ball_error
from app.optics.cook_torrance import cook_torrance_at
from app.optics.filter import toksvig_exponent
from app.optics.maps import map_pattern, peak_gain, peak_gain_at, roughness_as_srgb, srgb_gap, stored_roughness
from app.optics.scale_effect import (
    aliasing_error,
    bump_kept,
    d_bumps,
    d_bumps_counted,
    d_filtered,
    d_toksvig,
    d_unfiltered,
    filter_error,
    m_effective,
    m_pixel,
    normal_shortfall,
    samples_worth,
    sampling_error,
)
from app.state import defaults
from app.theme import THEMES

PAIRS = [(0.1, 0.2), (0.3, 0.05), (0.05, 0.4), (1.0, 1.0), (0.7, 0.3)]
pairs = pytest.mark.parametrize(("m", "sigma"), PAIRS)


def test_the_example_of_the_reference():
    """m = 0.1, sigma = 0.2 at h = n: unfiltered 31.8, LEAN 3.54, Toksvig 4.08; the truth is 3.60 by its integral."""
    assert d_unfiltered(0.0, 0.1) == pytest.approx(31.8, abs=0.05)
    assert d_filtered(0.0, 0.1, 0.2) == pytest.approx(3.54, abs=0.005)
    assert d_toksvig(0.0, 0.1, 0.2) == pytest.approx(4.08, abs=0.005)
    assert d_bumps(0.1, 0.2) == pytest.approx(3.6002, abs=5e-5)
    assert m_effective(0.1, 0.2) == pytest.approx(0.3, abs=1e-15)
    assert 1 / (np.pi * m_effective(0.1, 0.2) ** 2) == pytest.approx(d_filtered(0.0, 0.1, 0.2), rel=1e-14)


def moment(m, sigma, power):
    """E[D^power] over two normal slopes, as a plane integral in mpmath."""
    with mpmath.workdps(30):
        m, s = mpmath.mpf(m), 2 * mpmath.mpf(sigma) ** 2

        def weighted(t):
            d = mpmath.exp(-t / m**2) * (1 + t) ** 2 / (mpmath.pi * m**2)
            return d**power * mpmath.exp(-t / s) / s

        scale = 1 / (power / m**2 + 1 / s)
        return mpmath.quad(weighted, [0, scale, 4 * scale, 16 * scale, 64 * scale, mpmath.inf])


@pairs
def test_the_mean_and_its_spread_are_their_integrals(m, sigma):
    mean, square = moment(m, sigma, 1), moment(m, sigma, 2)
    assert d_bumps(m, sigma) == pytest.approx(float(mean), rel=1e-12)
    assert aliasing_error(m, sigma) == pytest.approx(float(mpmath.sqrt(square / mean**2 - 1)), rel=1e-9)


@pairs
def test_counted_bumps_come_to_the_mean(m, sigma):
    off = [abs(d_bumps_counted(0.0, m, sigma, n) / d_bumps(m, sigma) - 1) for n in (100, 10000)]
    assert off[1] < 2e-4 and off[1] < 0.1 * off[0] + 1e-12


def test_counted_bumps_aside_of_the_middle():
    """A plane integral over both slopes, by scipy."""
    m, sigma, angle = 0.1, 0.2, 0.3
    h = np.array([np.sin(angle), 0.0, np.cos(angle)])

    def weighted(y, x):
        n = np.array([-x, -y, 1.0]) / np.sqrt(1 + x * x + y * y)
        c = n @ h
        d = d_beckmann_slope((1 - c * c) / (c * c), m) if c > 0 else 0.0
        return d * np.exp(-(x * x + y * y) / (2 * sigma**2)) / (2 * np.pi * sigma**2)

    exact, _ = integrate.dblquad(weighted, -1.1, 0.5, -0.8, 0.8, epsabs=1e-7)
    assert d_bumps_counted(angle, m, sigma, 10000) == pytest.approx(exact, rel=2e-3)


@pairs
def test_the_one_evaluation_misses_what_is_said(m, sigma):
    assert 1 - d_filtered(0.0, m, sigma) / d_bumps(m, sigma) == pytest.approx(filter_error(m, sigma), rel=1e-9)
    n = samples_worth(m, sigma)
    assert sampling_error(n, m, sigma) == pytest.approx(filter_error(m, sigma), rel=1e-12)


def test_random_samples_err_as_the_variance_says():
    rng = np.random.default_rng(5)
    slopes = 0.2 * rng.normal(size=(20000, 16, 2))
    means = d_beckmann_slope(np.sum(slopes**2, -1), 0.1).mean(1)
    assert np.std(means) / d_bumps(0.1, 0.2) == pytest.approx(sampling_error(16, 0.1, 0.2), rel=0.05)


@pytest.mark.parametrize("sigma", [1e-3, 0.05, 0.2, 0.5, 1.0])
def test_the_mean_normal(sigma):
    """int e^(-u) / sqrt(1 + S u) du = sqrt(pi) x erfcx(x), x = 1 / sqrt(S)."""
    x = 1 / (np.sqrt(2) * sigma)
    assert 1 - normal_shortfall(sigma) == pytest.approx(np.sqrt(np.pi) * x * special.erfcx(x), rel=1e-13)
    short = normal_shortfall(sigma)
    exponent = toksvig_exponent(1 - short, 2 / 0.1**2 - 2)
    assert d_toksvig(0.0, 0.1, sigma) == pytest.approx((exponent + 2) / (2 * np.pi), rel=1e-11)


def test_a_pixel_hides_what_it_does_not_show():
    bumps = np.array([1.0, 60.0, 600.0, 6000.0])
    assert np.all(np.diff(m_pixel(0.1, 0.2, bumps)) > 0)
    assert m_pixel(0.1, 0.2, bumps[0]) == pytest.approx(0.1, rel=1e-4)
    assert m_pixel(0.1, 0.2, bumps[-1]) == pytest.approx(m_effective(0.1, 0.2), rel=1e-12)
    assert m_pixel(0.1, 0.2, bumps) == pytest.approx(np.sqrt(0.01 + 0.08 * (1 - bump_kept(bumps) ** 2)), rel=1e-12)
    per_pixel = np.array([0.1, 0.3])
    square = np.sinc(per_pixel)  # of a square pixel: the same to the fourth order, pi^4 p^4 (1/72 - 1/120)
    assert bump_kept(600 * per_pixel) - square == pytest.approx(0.5412 * per_pixel**4, rel=0.2)


def test_the_forgotten_square_of_two_is_noticed():
    """A sum that took sigma for the slope along both axes would be off by half."""
    assert abs(1 / (np.pi * (0.1**2 + 0.2**2)) / d_bumps(0.1, 0.2) - 1) > 0.7


# --- the board -------------------------------------------------------------------------------------------------------
def test_the_factors_make_the_model():
    rng = np.random.default_rng(2)
    theta_l, theta_v, phi = rng.uniform(0, 1.4, (3, 50)) * [[1], [1], [2]]
    quotient = dgf_at(theta_l, theta_v, phi, 0.4, 0.04) / (4 * np.cos(theta_l) * np.cos(theta_v))
    assert quotient == pytest.approx(cook_torrance_at(theta_l, theta_v, phi, 0.4, 0.04), rel=1e-12)
    at = 1.1
    gain = cook_torrance_at(at, at, np.pi, 0.3, 0.04) / cook_torrance_at(0.0, 0.0, np.pi, 0.3, 0.04)
    assert mirror_gain(at, 0.04) == pytest.approx(gain, rel=1e-12)


@pytest.mark.parametrize(("shape", "off"), [("sphere", 0.003), ("cube", 0.0)])
def test_corner_normals(shape, off):
    triangles = built_in(shape).triangles
    found = corner_normals(triangles)
    assert np.linalg.norm(found, axis=-1) == pytest.approx(1.0, abs=1e-12)
    flat = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    flat = np.repeat((flat / np.linalg.norm(flat, axis=-1, keepdims=True))[:, None], 3, 1)
    exact = triangles if shape == "sphere" else flat
    assert np.abs(found - exact).max() <= off + 1e-12
    shuffled = np.random.default_rng(1).permutation(len(triangles))
    assert corner_normals(triangles[shuffled]) == pytest.approx(found[shuffled], abs=1e-12)


def test_the_shader_counts_the_same(ctx):
    args = {"theta_h": np.array([0.0, 0.2]), "m": 0.1, "bump_slope": 0.2, "facets": np.array([10000, 10000])}
    assert evaluate("d_bumps_counted", args, ctx=ctx) == pytest.approx(d_bumps_counted(**args), rel=1e-5)


# --- maps ------------------------------------------------------------------------------------------------------------
def test_a_roughness_read_as_a_colour():
    """The peaks of D themselves, and the decoding once more in mpmath."""
    stored = np.array([0.02, 0.2, 0.5, 0.9])
    wrong = [float(mpmath.mpf(x) / 12.92 if x <= 0.04045 else ((mpmath.mpf(x) + 0.055) / 1.055) ** 2.4) for x in stored]
    peaks = [d_beckmann_slope(0.0, m) for m in (np.array(wrong), stored)]
    assert peak_gain(stored) == pytest.approx(peaks[0] / peaks[1], rel=1e-12)
    assert srgb_gap(stored) == pytest.approx(stored / wrong, rel=1e-12)
    assert srgb_gap(np.array([0.0, 1.0])) == pytest.approx([12.92, 1.0])


def test_the_maps_of_the_plate():
    s, t = np.meshgrid(np.linspace(0, 1, 301), np.linspace(0, 1, 301))
    gilt, stored = map_pattern(s, t), stored_roughness(NONE, s, t)
    assert 0.3 < gilt.mean() < 0.6 and gilt.min() == 0 and gilt.max() == 1
    assert 0.15 < stored.min() < 0.2 and 0.55 < stored.max() < 0.65
    assert np.all(roughness_as_srgb(NONE, s, t) < stored)
    here = NONE, 0.4, 0.6
    assert peak_gain_at(*here) == pytest.approx((stored_roughness(*here) / roughness_as_srgb(*here)) ** 2, rel=1e-12)


# --- the picture's own error -----------------------------------------------------------------------------------------
def test_the_truth_of_a_pixel_is_good_enough():
    """224 places of a pixel against 8192 others: what is shown differs by less than 1 % of white."""
    place = np.arange(bumpy_ball.PLACES)
    for bumps in (20.0, 300.0, 1500.0):
        few, many = (bumpy_ball._mean(n, bumps, 0.2, 0.1, place + k) for n, k in ((bumpy_ball.TRUTH, 0), (8192, 3)))
        assert np.sqrt(np.mean((np.exp(-bumpy_ball.LIGHT * few) - np.exp(-bumpy_ball.LIGHT * many)) ** 2)) < 0.01


def test_far_away_filtering_wins_and_near_by_nothing_is_wrong():
    one, some, filtered, toksvig = (float(ball_error(1500.0, 0.2, 0.1, 16, k)) for k in range(4))
    assert one > some > 1.5 * filtered and filtered < toksvig < 1.3 * filtered and one > 0.1
    assert all(ball_error(3.0, 0.2, 0.1, 16, k) < 2e-3 for k in range(4))
    assert all(ball_error(3.0, 0.0, 0.1, 16, k) == 0.0 for k in range(3)), "no bumps, no rounding told as an error"
    middle = [float(ball_error(300.0, 0.2, 0.1, 16, k)) for k in range(3)]
    assert middle[1] < 0.5 * middle[2] < 0.5 * middle[0], "at middle distance the filter blurs what it cannot know"


def test_more_places_err_less():
    errors = [float(ball_error(800.0, 0.2, 0.1, n, 1)) for n in (1, 4, 16, 64)]
    assert all(a > 1.4 * b for a, b in itertools.pairwise(errors))


def test_the_picture_errs_as_its_numbers_say(ctx):
    """The scene's own pixels: its part of one place and its filtered part against 64 pictures that are each shifted by
    a part of a pixel, which is a truth of another making."""
    found = step("plausible_shading/scale")
    values = defaults(found) | {"bumps": 1500.0}
    stage = Stage(ctx, Source(found.step.scene, found.file_name, found.glsl_line))
    view, size = replace(found.step.scene.camera, target=(0.0, 0.0, 0.0), field_of_view=2.866), (600, 600)
    shown = []
    for i in range(64):
        x, y = np.mod(0.5 + i * np.array([0.7548777, 0.5698403]), 1) - 0.5 if i else (0.0, 0.0)
        shift = np.eye(4)
        shift[0, 3], shift[1, 3] = 2 * x / 600, 2 * y / 600
        shown.append(raw(stage, values, view, THEMES["dark"], size, shift @ camera.view_projection(view, 1.0))[0])
    stage.release()
    light = -np.log(np.maximum(1 - np.stack(shown)[..., 0], 1e-6))
    number = shown[0][..., 3]
    inside = np.stack([one[..., 3] for one in shown]).min(0) == number
    one_place = np.sqrt(np.mean((np.exp(-light[0]) - np.exp(-light.mean(0)))[inside & (number == 3)] ** 2))
    assert one_place == pytest.approx(float(ball_error(1500.0, 0.2, 0.1, 16, 0)), rel=0.35)
