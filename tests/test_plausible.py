"""Plausible shading: a body under a coat by second ways, and the numbers of the optics reference."""

import numpy as np
import pytest
from scipy.integrate import dblquad

from app.badges import check
from app.furnace import albedo
from app.optics import twin
from app.optics.spherical import direction

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


def test_only_the_coupling_in_and_out_passes_all_badges():
    def failed(coupling):
        badges = check(lambda n, l, v: twin("brdf_coated")(n, l, v, 1.0, 0.02, 0.04, coupling))
        return {name for name, badge in badges.items() if not badge.ok}

    assert [failed(k) for k in range(4)] == [{"energy"}, {"energy"}, {"energy", "reciprocal"}, set()]


def test_the_share_let_through_keeps_its_digits_at_grazing():
    assert float(twin("passed_share")(1e-9, 0.04)) == pytest.approx(0.96 * 5e-9, rel=1e-7)
    c = np.linspace(0, 1, 50)
    assert np.allclose(twin("passed_share")(c, 0.2), 1 - twin("f_schlick")(c, 0.2), atol=1e-15)
