"""Light that meets a second facet: what is lost is what the albedo lacks, and with all of it back nothing is lost."""

import numpy as np
import pytest

from app.optics.bounces import (
    bounced_light,
    bounced_light_error,
    bounced_share,
    f_material_average,
    facets_lost,
    facets_lost_average,
)
from app.optics.cook_torrance import albedo_cook_torrance
from app.quadrature import gauss_legendre

MU, WEIGHTS = gauss_legendre(48)
SILVER, PLASTIC = 6, 2


def kept(m):
    return albedo_cook_torrance(np.arccos(MU), m, 1.0)


@pytest.mark.parametrize(("m", "most"), [(0.08, 0.0025), (0.3, 0.0026), (0.5, 0.0045), (1.0, 0.006)])
def test_what_is_lost_is_what_the_albedo_lacks(m, most):
    """By another way: int D (G1 - G) u, which is positive all over, against 1 - int D G u."""
    assert np.max(np.abs(facets_lost(MU, m) - (1 - kept(m)))[MU > 0.01]) < most
    assert np.all(facets_lost(MU, m) >= 0)


@pytest.mark.parametrize("m", [0.05, 0.2, 0.5, 0.8, 1.0])
def test_its_average_is_the_mean_over_the_cosines(m):
    assert abs(facets_lost_average(m) - 2 * np.sum(WEIGHTS * MU * (1 - kept(m)))) < 1.5e-4


@pytest.mark.parametrize("m", [0.1, 0.3, 0.5, 1.0])
@pytest.mark.parametrize("n_dot_v", [0.1, 0.5, 1.0])
def test_in_a_furnace_facets_that_mirror_all_lose_nothing(m, n_dot_v):
    """One bounce and all others make 1 for F = 1, where one alone has lost up to half."""
    lobe = facets_lost(n_dot_v, m) * facets_lost(MU, m) / (np.pi * facets_lost_average(m))
    again = bounced_share(1.0, m) * 2 * np.pi * np.sum(WEIGHTS * MU * lobe)
    assert bounced_share(1.0, m) == 1
    assert abs(albedo_cook_torrance(np.arccos(n_dot_v), m, 1.0) + again - 1) < 0.007


@pytest.mark.parametrize("material", range(10))
def test_no_material_sends_back_more_than_it_gets(material):
    light = bounced_light(0.0, MU, 0.7, material, 0.0, 1.0)
    assert np.all(light >= 0) and np.all(light <= (1 - kept(0.7) + 0.006)[:, None])


def test_lamp_and_eye_may_change_places():
    """f = L / (E n.l) is the same both ways."""
    f = [bounced_light(a, b, 0.5, SILVER, 1.0, 0.0) / a for a, b in ((0.3, 0.9), (0.9, 0.3))]
    assert np.allclose(*f, rtol=1e-12) and np.all(f[0] > 0)
    assert np.all(bounced_light(-0.2, 0.5, 0.5, SILVER, 1.0, 0.0) == 0)


def test_an_insulator_mirrors_little_twice():
    """Optics reference 9: F0 = 0.04, m = 1 gains 0.003; silver nearly all that is lost."""
    assert f_material_average(PLASTIC).max() < 0.11
    assert 0.001 < bounced_light_error(PLASTIC, 1.0) < 0.005 and bounced_light_error(SILVER, 1.0) > 0.5
