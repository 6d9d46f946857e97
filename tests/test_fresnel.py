"""The Fresnel term against complex arithmetic, limits and identities; the tables against CIE's and against the deck."""

import math
import re

import numpy as np
import pytest
from scipy.integrate import quad

from app.optics import fresnel as f
from app.optics import interface, materials
from lessons.ch06_fresnel import SCHLICK

C = np.linspace(0.0, 1.0, 101)
ETAS = np.array([0.4, 0.6667, 1.0001, 1.333, 1.5, 2.4175, 9.0])
FACE = np.meshgrid(C, ETAS)
ROWS = range(10)


def amplitudes(c, index):
    """Fresnel 1823 in complex numbers, with Snell's law: the second way to every share."""
    s2 = (1 - c) * (1 + c) + 0j
    inside = np.sqrt(index * index - s2)  # index times the cosine on the far side
    return (c - inside) / (c + inside), (index * index * c - inside) / (index * index * c + inside)


def shares(c, index):
    return [np.abs(r) ** 2 for r in amplitudes(c, index)]


def test_dielectrics_are_fresnels_equations():
    s, p = shares(*FACE)
    assert f.f_dielectric_s(*FACE) == pytest.approx(s, abs=2e-12)
    assert f.f_dielectric_p(*FACE) == pytest.approx(p, abs=2e-12)
    assert f.f_dielectric(*FACE) == pytest.approx((s + p) / 2, abs=2e-12)


def test_metals_are_fresnels_equations():
    c, eta, k = np.meshgrid(C, (0.05, 0.3, 1.0, 2.9), (0.5, 2.0, 3.0, 8.0))
    s, p = shares(c, eta + 1j * k)
    assert f.f_conductor(c, eta, k) == pytest.approx((s + p) / 2, abs=1e-13)


def test_a_metal_without_extinction_is_a_dielectric():
    assert f.f_conductor(*FACE, 0.0) == pytest.approx(f.f_dielectric(*FACE), abs=1e-13)
    assert np.all(np.isfinite(f.f_conductor(0.0, 1.0, 0.0))) and f.f_conductor(0.0, 1.0, 0.0) == 1


def test_nothing_is_lost():
    assert f.f_dielectric(*FACE) + f.t_dielectric(*FACE) == pytest.approx(1, abs=4e-15)
    assert interface.both_shares(np.linspace(0, 3, 50)[:, None], ETAS) == pytest.approx(1, abs=4e-15)


def test_a_share_is_a_share_and_ends_at_one():
    value = f.f_dielectric(*FACE)
    assert np.all((value >= 0) & (value <= 1)) and np.all(value[:, 0] == 1)
    assert np.all(f.f_dielectric(C[1:], 1.0) == 0) and f.f_dielectric(0.0, 1.0) == 1


def test_both_sides_of_a_boundary_agree():
    """Light that goes back the way it came: the same share from the other side."""
    c, eta = np.meshgrid(C[1:], (1.2, 1.5, 2.4))
    assert f.f_dielectric(f.refracted_cosine(c, eta), 1 / eta) == pytest.approx(f.f_dielectric(c, eta), abs=1e-12)


def test_brewster_and_the_critical_angle():
    eta = np.array([1.333, 1.5, 2.4175])
    assert np.max(f.f_dielectric_p(np.cos(f.brewster_angle(eta)), eta)) < 1e-30
    critical = f.critical_angle(1 / eta)
    assert np.all(f.f_dielectric(np.cos(critical + 1e-9), 1 / eta) == 1)
    assert np.all(f.f_dielectric(np.cos(critical - 1e-6), 1 / eta) < 1)
    assert np.sin(critical) == pytest.approx(1 / eta) and f.critical_angle(1.5) == pytest.approx(math.pi / 2)
    assert interface.refracted_angle(np.radians(30), 1.5) == pytest.approx(math.asin(0.5 / 1.5))
    assert interface.refracted_angle(np.radians(60), 1 / 1.5) == pytest.approx(math.pi / 2)


def test_normal_incidence_there_and_back():
    eta = np.linspace(1, 6, 50)
    assert f.eta_from_f0(f.f0_from_eta(eta)) == pytest.approx(eta, rel=1e-14)
    assert f.f0_from_eta(eta) == pytest.approx(f.f_dielectric(1.0, eta), rel=1e-14)


@pytest.mark.parametrize("eta", [0.4, 1 / 1.5, 1.001, 1.333, 2.4175, 9.0])
def test_the_average_is_the_integral(eta):
    outside = [math.sqrt(abs(eta * eta - 1)), 0.1 / eta, 1 / eta]
    bends = [float(np.cos(f.critical_angle(eta)))] if eta < 1 else [b for b in outside if b < 1]
    value, _ = quad(lambda c: 2 * c * float(f.f_dielectric(c, eta)), 0, 1, points=bends, epsabs=1e-13, epsrel=1e-13,
                    limit=400)
    assert f.f_average_dielectric(eta) == pytest.approx(value, rel=1e-10)
    schlick, _ = quad(lambda c: 2 * c * float(f.f_schlick(c, 0.17)), 0, 1)
    assert f.f_average_schlick(0.17) == pytest.approx(schlick, rel=1e-12)


def test_the_average_of_nothing_is_nothing():
    assert f.f_average_dielectric(1.0) == 0
    assert np.all(np.diff(f.f_average_dielectric(np.linspace(1, 10, 200))) > 0)


def test_half_is_reflected_there():
    eta = np.array([1.1, 1.333, 1.5, 2.4175])
    angle = np.radians(interface.angle_of_half(eta))
    assert interface.reflected_share(angle, eta) == pytest.approx(0.5, abs=1e-7)
    assert interface.angle_of_half(1.333) == pytest.approx(83.5, abs=0.05)
    assert interface.reflected_share(np.radians(60), 1.333) == pytest.approx(0.06, abs=0.002)


def test_a_polariser_half_way_lets_through_both():
    theta = np.linspace(0, 1.5, 20)
    for turn, share in ((0, interface.reflected_share_s), (math.pi / 4, interface.reflected_share),
                        (math.pi / 2, interface.reflected_share_p)):
        assert interface.polarised_share(theta, 1.5, turn) == pytest.approx(share(theta, 1.5), abs=1e-15)


def test_the_fits_pass_through_their_points():
    f0, f82 = np.array([0.04, 0.56, 0.91]), np.array([0.4, 0.5, 0.85])
    assert f.f_schlick(1.0, f0) == pytest.approx(f0) and f.f_schlick(0.0, f0) == pytest.approx(1)
    assert f.f_f82(1.0, f0, f82) == pytest.approx(f0) and f.f_f82(0.0, f0, f82) == pytest.approx(1)
    assert f.f_f82(1 / 7, f0, f82) == pytest.approx(f82, abs=1e-15)
    assert f.f_f82(C[:, None], f0, f.f_schlick(1 / 7, f0)) == pytest.approx(f.f_schlick(C[:, None], f0), abs=1e-15)


# --- the tables ------------------------------------------------------------------------------------------------------
def column(text: str) -> np.ndarray:
    return np.array([float(x) for x in text.split()])


# CIE 015:2004, 380 .. 780 nm in steps of 10
D65 = column("""
    49.98 54.65 82.75 91.49 93.43 86.68 104.86 117.01 117.81 114.86 115.92 108.81 109.35 107.80 104.79 107.69
    104.41 104.05 100.00 96.33 95.79 88.69 90.01 89.60 87.70 83.29 83.70 80.03 80.21 82.28 78.28 69.72 71.61
    74.35 61.60 69.89 75.09 63.59 46.42 66.81 63.38""")
X_BAR = column("""
    .0014 .0042 .0143 .0435 .1344 .2839 .3483 .3362 .2908 .1954 .0956 .0320 .0049 .0093 .0633 .1655 .2904 .4334
    .5945 .7621 .9163 1.0263 1.0622 1.0026 .8544 .6424 .4479 .2835 .1649 .0874 .0468 .0227 .0114 .0058 .0029
    .0014 .0007 .0003 .0002 .0001 0""")
Y_BAR = column("""
    0 .0001 .0004 .0012 .0040 .0116 .0230 .0380 .0600 .0910 .1390 .2080 .3230 .5030 .7100 .8620 .9540 .9950
    .9950 .9520 .8700 .7570 .6310 .5030 .3810 .2650 .1750 .1070 .0610 .0320 .0170 .0082 .0041 .0021 .0010 .0005
    .0002 .0001 .0001 0 0""")
Z_BAR = np.pad(column("""
    .0065 .0201 .0679 .2074 .6456 1.3856 1.7471 1.7721 1.6692 1.2876 .8130 .4652 .2720 .1582 .0782 .0422 .0203
    .0087 .0039 .0021 .0017 .0011 .0008 .0003 .0002"""), (0, 16))
NANOMETRES = np.arange(380, 781, 10.0)
SRGB = np.array([[3.2404542, -1.5371385, -0.4985314], [-0.9692660, 1.8760108, 0.0415560],
                 [0.0556434, -0.2040259, 1.0572252]])


def daylight() -> np.ndarray:
    """(3, 41): what each wavelength adds to linear sRGB, white being 1."""
    xyz = np.stack([X_BAR, Y_BAR, Z_BAR]) * D65
    assert xyz.sum(1) / xyz[1].sum() == pytest.approx([0.9505, 1, 1.089], abs=2e-3), "D65"
    rgb = SRGB @ xyz
    return rgb / rgb.sum(1, keepdims=True)


def test_the_weights_are_cies():
    hats = [np.interp(NANOMETRES, materials._WAVELENGTH, np.eye(12)[i]) for i in range(12)]
    assert materials.wavelength_weight(np.arange(12)) == pytest.approx(np.array(hats) @ daylight().T, abs=3e-5)
    assert materials._WEIGHT.sum(0) == pytest.approx(1, abs=1e-12)


MEASURED = {5: (1.038, 0.728, 0.365), 6: (0.989, 0.984, 0.978), 8: (0.530, 0.513, 0.494)}


@pytest.mark.parametrize("row", MEASURED)
def test_twelve_wavelengths_are_enough(row):
    """Against the integral in steps of 10 nm over interpolated n and k, and against figures computed elsewhere."""
    index = materials.metal_index(row, np.arange(12)).T
    n, k = (np.interp(NANOMETRES, materials._WAVELENGTH, x) for x in index)
    fine = daylight() @ f.f_conductor(1.0, n, k)
    assert materials.f_material(1.0, row) == pytest.approx(fine, abs=0.004)
    assert materials.f_material(1.0, row) == pytest.approx(MEASURED[row], abs=0.005)


def test_the_printed_shares_are_near_the_measured():
    off = np.abs(materials.material_f0(np.arange(10)) - materials.f_material(1.0, np.arange(10)))
    assert np.max(off[:5]) <= 0.0055, "insulators: two decimals"
    assert np.all(np.max(off[5:], 1) < (0.08, 0.1, 0.03, 0.09, 0.01))


def test_the_columns_of_the_deck_and_their_slips():
    """Each sRGB entry is the linear one's to two decimals, but for four, which both columns' rounding explains."""
    rows, channels = np.meshgrid(ROWS, range(3), indexing="ij")
    off = np.abs(materials.material_srgb_printed(rows, channels) - materials.material_srgb_of_printed(rows, channels))
    assert np.max(off) < 0.0203
    slips = {(int(r), int(c)) for r, c in np.argwhere(off > 0.00505)}
    assert slips == {(1, 0), (1, 1), (1, 2), (2, 0), (2, 1), (2, 2), (8, 2), (9, 2)}


WORST = {0: 0.060, 1: 0.039, 2: 0.032, 3: 0.034, 4: 0.074, 5: 0.032, 6: 0.007, 7: 0.043, 8: 0.178, 9: 0.126}
PRINTED = {0.02: 0.060, 0.03: 0.043, 0.05: 0.032, 0.08: 0.034, 0.17: 0.074}  # F(0) of the deck's insulators


@pytest.mark.parametrize("row", WORST)
def test_where_schlick_fails(row):
    assert materials.schlick_worst(row) == pytest.approx(WORST[row], abs=0.0025)


@pytest.mark.parametrize("f0", PRINTED)
def test_where_schlick_fails_for_the_printed_insulators(f0):
    c = np.cos(np.radians(np.linspace(0, 90, 901)))
    off = np.abs(f.f_schlick(c, f0) - f.f_dielectric(c, f.eta_from_f0(f0)))
    assert np.max(off) == pytest.approx(PRINTED[f0], abs=0.001)


def test_f82_mends_it():
    theta, rows, channels = np.meshgrid(np.radians(np.arange(91)), range(5, 10), range(3), indexing="ij")
    args = theta, rows, channels
    off = np.abs(materials.material_share_f82(*args) - materials.material_share(*args))
    assert np.max(off) < 0.021
    assert materials.schlick_worst(np.arange(10)).argmax() == 8, "iron"


def test_every_material_ends_at_one():
    assert materials.f_material(0.0, np.arange(10)) == pytest.approx(1, abs=1e-12)


def test_the_numbers_in_the_words():
    assert materials.material_share(0.0, 5, 0) == pytest.approx(1.03, abs=0.005)
    assert materials.material_share(0.0, 5, 2) == pytest.approx(0.37, abs=0.005)
    assert f.f_average_dielectric(1 / 1.5) == pytest.approx(0.60, abs=0.005)
    assert f.f_average_dielectric(1.5) == pytest.approx(0.09, abs=0.005)
    assert np.degrees(f.critical_angle(1 / 2.4175)) == pytest.approx(24, abs=0.5)
    assert np.degrees(f.critical_angle(1 / 1.5)) == pytest.approx(41.8, abs=0.05)
    assert f.eta_from_f0(0.17) == pytest.approx(2.40, abs=0.005)
    assert np.degrees(f.brewster_angle(1.333)) == pytest.approx(53.1, abs=0.05)


def test_the_scenes_numbers_of_the_metals_are_the_twins():
    """Schlick's scene has F at 1 and 1/7 as numbers: to compute them at each pixel takes longer than all else."""
    for name, cosine in (("F0", 1.0), ("F82", 1 / 7)):
        rows = re.search(rf"const vec3 {name}\[5\] = vec3\[5\]\((.*?)\);", SCHLICK.scene.glsl, re.DOTALL)
        assert rows
        written = np.array(re.findall(r"[\d.]{4,}", rows[1]), float).reshape(5, 3)
        assert np.allclose(written, materials.f_material(cosine, np.arange(5, 10)), rtol=5e-7, atol=0)
