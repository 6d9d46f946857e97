"""Phong and Blinn-Phong by second ways: quadrature in other variables, measured contours, identities, extremes."""

import math

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

from app import badges
from app.lesson import Model, Term
from app.optics import blinn_phong as b
from app.optics import complaint, highlight
from app.optics import phong as p
from app.optics.spherical import direction, light_direction, view_direction

UP = np.array([0.0, 0.0, 1.0])
EXPONENTS = np.array([0.0, 0.3, 1.0, 5.0, 20.0, 300.0, 1e4, 1e7])
ANGLES = np.array([0.0, 0.3, 0.8, 1.2, 1.5, math.pi / 2])
PAIRS = [direction(*np.meshgrid(np.linspace(0, 3, 9), np.linspace(-3, 3, 7))).reshape(-1, 3) for _ in range(2)]
L, V = (x.reshape(-1, 3) for x in (np.repeat(PAIRS[0][:, None], 63, 1), np.repeat(PAIRS[1][None], 63, 0)))


def over_the_sky(f, theta_v):
    """int f(n, l, v) n.l dw over all l, summed in l's own angles: not the variables of the twin."""
    theta, phi = np.meshgrid((np.arange(1500) + 0.5) * math.pi / 3000, (np.arange(600) + 0.5) * math.pi / 600)
    l = direction(theta, phi)
    return 2 * np.sum(f(UP, l, view_direction(theta_v)) * np.cos(theta) * np.sin(theta)) * math.pi**2 / 1.8e6


@pytest.mark.parametrize(("exponent", "theta"), [(1.0, 1.2), (3.0, 0.5), (20.0, 0.7), (20.0, 1.4), (400.0, 1.1)])
def test_the_flux_under_a_highlight_is_its_integral(exponent, theta):
    blinn, phong = (over_the_sky(lambda n, l, v, f=f: f(n, l, v, exponent), theta)
                    for f in (b.lobe_blinn, p.lobe_phong))
    assert b.lobe_flux_blinn(theta, exponent) == pytest.approx(blinn, rel=2e-5)
    assert p.lobe_flux_phong(theta, exponent) == pytest.approx(phong, rel=2e-5)


def test_stored_albedo_of_the_reference():
    assert b.albedo_blinn_phong(0.7, 20.0) == pytest.approx(0.628119765165, abs=1e-12)


@pytest.mark.parametrize("exponent", EXPONENTS)
def test_seen_along_the_normal_all_comes_back_and_never_more(exponent):
    for albedo in (b.albedo_blinn_phong, p.albedo_phong):
        share = albedo(ANGLES, exponent)
        assert share[0] == pytest.approx(1, abs=2e-13)
        assert np.all(np.diff(share) <= 1e-13) and np.all(share > 0)
    half = quad(lambda t: 2 * math.pi * math.cos(t / 2) ** exponent * math.cos(t) * math.sin(t), 0, math.pi / 2,
                points=[min(1.5, k / math.sqrt(exponent + 1)) for k in (1, 4, 12)])[0]
    assert b.normalisation_blinn_phong(exponent) * half == pytest.approx(1, rel=1e-7)


def test_the_table_of_the_reference_and_the_limits():
    """optics.md, D7 and D8."""
    at = np.radians([0, 30, 60, 85])
    table = {1: (1, 0.955, 0.819, 0.633), 10: (1, 0.805, 0.400, 0.135), 100: (1, 0.755, 0.265, 0.025)}
    for exponent, row in table.items():
        assert b.albedo_blinn_phong(at, exponent) == pytest.approx(row, abs=6e-4)
    assert b.lobe_flux_blinn(0.0, np.array([0, 10, 100])) == pytest.approx([3.142, 1.501, 0.2369], abs=5e-4)
    assert b.albedo_blinn_phong(ANGLES, 1e7) == pytest.approx(b.albedo_blinn_phong_limit(ANGLES), abs=2e-7)
    assert p.albedo_phong(ANGLES[:-1], 1e7) == pytest.approx(np.cos(ANGLES[:-1]), abs=2e-7)
    exact = b.normalisation_blinn_phong(np.array([1.0, 10.0, 100.0]))
    for summand, off in ((8, (2.4, 7.5, 1.8)), (6, (-20, -4.5, -0.1)), (2, (-66, -28, -3.8))):
        found = 100 * (b.normalisation_short(np.array([1.0, 10.0, 100.0]), summand) / exact - 1)
        assert found == pytest.approx(off, abs=0.5 if abs(off[0]) > 9 else 0.05)


def test_exponent_zero_is_lambert():
    assert b.albedo_blinn_phong(ANGLES, 0.0) == pytest.approx(1, abs=1e-12)
    assert b.brdf_blinn_phong(UP, direction(0.5, 1.0), direction(1.0, 0.0), 0.3, 0.7, 0.0) == pytest.approx(1 / math.pi)
    assert p.albedo_phong(ANGLES, 0.0) == pytest.approx((1 + np.cos(ANGLES)) / 2, abs=1e-12)


@pytest.mark.parametrize("brdf", [p.brdf_phong, b.brdf_blinn_phong])
@pytest.mark.parametrize("exponent", EXPONENTS)
def test_a_brdf_is_reciprocal_finite_and_not_below_zero(brdf, exponent):
    forth, back = brdf(UP, L, V, 0.3, 0.7, exponent), brdf(UP, V, L, 0.3, 0.7, exponent)
    size = np.maximum(np.abs(forth), 1e-300)
    assert np.all(np.abs(forth - back) <= 1e-12 * (1 + exponent) * size)
    assert np.all(np.isfinite(forth)) and np.all(forth >= 0)
    assert np.all(forth[(L[:, 2] <= 0) | (V[:, 2] <= 0)] == 0)


def test_the_printed_formulas_are_not_reciprocal():
    """optics.md, D6: at 0.3 and 1.2 rad, azimuth 2.5, exponent 20."""
    l, v = light_direction(0.3, 2.5), view_direction(1.2)
    for printed, forth, back in ((p.brdf_phong_printed, 1.23e-5, 3.24e-5),
                                 (b.brdf_blinn_phong_printed, 0.0780, 0.2058)):
        assert printed(UP, l, v, 0.0, 1.0, 20.0) == pytest.approx(forth, rel=3e-3)
        assert printed(UP, v, l, 0.0, 1.0, 20.0) == pytest.approx(back, rel=3e-3)
    low = light_direction(np.radians(89.999), math.pi)
    assert p.brdf_phong_printed(UP, low, p.reflection_vector(UP, low), 0.0, 1.0, 20.0) > 5e4, "unbounded"


def test_a_printed_formula_is_its_brdf_times_the_cosine():
    lit = (L[:, 2] > 0) & (V[:, 2] > 0)
    for shading, brdf in ((p.shading_phong, p.brdf_phong_printed), (b.shading_blinn_phong, b.brdf_blinn_phong_printed)):
        product = brdf(UP, L[lit], V[lit], 0.4, 0.6, 30.0) * L[lit][:, 2]
        assert shading(UP, L[lit], V[lit], 0.4, 0.6, 30.0) == pytest.approx(product, rel=1e-12, abs=1e-300)


def test_the_mirror_direction_and_the_halfway_vector():
    n = direction(0.4, 1.0)
    r = p.reflection_vector(n, L)
    assert np.sum(r * n, -1) == pytest.approx(np.sum(L * n, -1), abs=1e-14), "the same angle"
    assert np.sum(np.cross(L, n) * r, -1) == pytest.approx(0, abs=1e-14), "in one plane"
    assert p.reflection_vector(n, r) == pytest.approx(L, abs=1e-14), "and back"
    assert np.all(b.halfway(L, -L) == 0) and b.halfway_cosine(UP, L, -L) == pytest.approx(0, abs=1e-300)
    assert np.all(b.lobe_blinn(UP, L, -L, 5.0) == 0) and np.all(b.pdf_blinn_phong(UP, L, -L, 5.0) == 0)
    assert b.halfway(n, p.reflection_vector(UP, n)) == pytest.approx(UP, abs=1e-15)


@pytest.mark.parametrize("exponent", [1e5, 1e7])
def test_a_tight_highlight_keeps_its_digits(exponent):
    """(cos a)^e against exp(-e a^2 / 2 (1 + a^2 / 6)), to which it goes for small angles."""
    a = np.array([1e-5, 1e-4, 3e-4, 1e-3])
    near = np.exp(-0.5 * exponent * a * a * (1 + a * a / 6))
    l = direction(0.7, math.pi)
    assert p.cosine_lobe(a, exponent) == pytest.approx(near, rel=1e-8, abs=1e-200)
    assert p.lobe_phong(UP, l, direction(0.7 + a, 0.0), exponent) == pytest.approx(near, rel=1e-5, abs=1e-200)
    assert b.lobe_blinn(UP, l, direction(0.7 + 2 * a, 0.0), exponent) == pytest.approx(near, rel=1e-5, abs=1e-200)


@pytest.mark.parametrize("exponent", [1.0, 4.0, 60.0, 1e4])
def test_equal_widths(exponent):
    width, same = p.half_width_phong(exponent), b.blinn_exponent(exponent)
    assert p.cosine_lobe(width, exponent) == pytest.approx(0.5, rel=1e-12)
    assert b.half_width_blinn(same) == pytest.approx(width, rel=1e-12)
    assert same == pytest.approx(4 * exponent + math.log(2), rel=0.15 / exponent**2)


@pytest.mark.parametrize("theta", [0.0, 0.8, 1.2, 1.4])
def test_how_far_a_highlight_is_stretched(theta):
    """The half-height contour around the mirror direction, along and across, of a tight highlight."""
    l, exponent = direction(theta, math.pi), 1e6
    r, across = direction(theta, 0.0), np.array([0.0, 1.0, 0.0])
    along = np.cross(across, r)

    def width(lobe, way):
        return brentq(lambda a: float(lobe(UP, l, math.cos(a) * r + math.sin(a) * way, exponent)) - 0.5, 0, 0.01)

    blinn, phong = (width(lobe, along) / width(lobe, across) for lobe in (b.lobe_blinn, p.lobe_phong))
    assert blinn == pytest.approx(b.highlight_stretch(theta), rel=1e-3) and phong == pytest.approx(1, rel=1e-6)


def test_what_leaves_by_the_angles():
    args = np.radians(60.0), 0.2, 0.5, 12.0
    theta, phi = np.meshgrid((np.arange(1500) + 0.5) * math.pi / 3000, (np.arange(600) + 0.5) * math.pi / 600)
    for model in range(4):
        share = highlight.highlight_share(model, args[0], theta, phi, *args[1:])
        leaves = 2 * np.sum(share * np.cos(theta) * np.sin(theta)) * math.pi**2 / 1.8e6
        assert highlight.highlight_flux(model, *args) == pytest.approx(leaves / math.cos(args[0]), rel=1e-5)
        assert highlight.highlight_peak(model, *args[1:]) == pytest.approx(
            highlight.highlight_brdf(model, 0.0, 0.0, math.pi, *args[1:]), rel=1e-12)


def test_complaints():
    assert complaint.complaint_truth(0, ANGLES).max() <= 1 < complaint.complaint_model(0, 0.0)
    straight = [complaint.complaint_model(k, 0.0) - complaint.complaint_truth(k, 0.0) for k in (1, 2, 4)]
    assert straight == pytest.approx([0, 0, 0], abs=1e-14), "Blinn-Phong is right straight on"
    rim = complaint.complaint_truth(np.arange(3), math.pi / 2)
    assert rim == pytest.approx([1, 1, 1], abs=1e-9)
    assert complaint.complaint_model(3, 0.0) == pytest.approx(math.sqrt(0.5), abs=2e-3)


RED = {  # a model, k_d, k_s, exponent, and what theory makes red, with the worst value
    ("brdf_phong_printed", 0.0, 1.0, 5.0): {"reciprocal": 0.954, "energy": math.pi / 3},
    ("brdf_phong_printed", 0.25, 0.6, 20.0): {"reciprocal": 0.863, "energy": None},  # only for light that grazes
    ("shading_phong", 0.7, 0.6, 50.0): {"reciprocal": 0.761, "energy": 0.7 * math.pi + 0.6 * 2 * math.pi / 51},
    ("brdf_phong", 0.3, 0.7, 1e7): {},
    ("brdf_phong", 0.7, 0.6, 50.0): {"energy": 1.3},
    ("brdf_blinn_phong_printed", 0.0, 1.0, 5.0): {"reciprocal": 0.963, "energy": 3.273},
    ("shading_blinn_phong", 0.0, 1.0, 5.0): {"reciprocal": 0.963, "energy": 3.273},
    ("brdf_blinn_phong", 0.3, 0.7, 0.0): {},
    ("brdf_blinn_phong", 0.3, 0.7, 1e7): {},
    ("brdf_blinn_phong", 0.7, 0.6, 50.0): {"energy": 1.3},
    ("brdf_blinn_phong_as_wide", 0.0, 1.0, 150.0): {},
}


@pytest.mark.parametrize("case", RED, ids=str)
def test_badges_are_red_where_theory_says_so(case):
    """Phong's lobe as printed, along the normal: int cos^e dw = 2 pi / (e + 1). The other numbers are measured."""
    function, k_d, k_s, exponent = case
    found = badges.of_model(Model("", Term(function)), {"k_d": k_d, "k_s": k_s, "exponent": exponent})
    assert {name for name, badge in found.items() if not badge.ok} == set(RED[case])
    for name, worst in RED[case].items():
        assert worst is None or found[name].worst == pytest.approx(worst, rel=2e-3), name


# --- the sampler -----------------------------------------------------------------------------------------------------
@pytest.mark.parametrize(("exponent", "theta"), [(0.0, 0.4), (5.0, 1.2), (80.0, 0.8), (3000.0, 1.5)])
def test_importance_sampling_gives_the_albedo(exponent, theta):
    """f n.l / pdf over a Fibonacci lattice: the pdf as a density of l, its Jacobian included."""
    count = 40_000
    i = np.arange(count)
    v = view_direction(theta)
    h = b.sample_blinn_phong((i + 0.5) / count, (i / 1.618033988749895) % 1, exponent)
    l = 2 * np.sum(h * v, -1, keepdims=True) * h - v
    pdf = b.pdf_blinn_phong(UP, l, v, exponent)
    weight = b.brdf_blinn_phong(UP, l, v, 0.0, 1.0, exponent) * l[:, 2] / np.maximum(pdf, 1e-300)
    assert np.mean(np.where(l[:, 2] > 0, weight, 0)) == pytest.approx(b.albedo_blinn_phong(theta, exponent), rel=2e-3)


@pytest.mark.parametrize("mistake", [b.lobe_blinn_naive, p.lobe_phong_naive])
def test_the_naive_power_loses_its_digits_in_float32(mistake):
    """What the GLSL comparison shows on the GPU, here in numpy: at 1e7 a rounded cosine is no cosine."""
    cosine = np.float32(np.cos(3e-4))
    naive = float(cosine) ** 1e7
    assert abs(naive / float(p.cosine_lobe(3e-4, 1e7)) - 1) > 0.05
    assert mistake(UP, UP, UP, 1e7) == 1
