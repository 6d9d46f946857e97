"""Grooves: the closed forms against counted rays and against Blinn's formula in three dimensions."""

import numpy as np
import pytest

from app.optics import twin

RNG = np.random.default_rng(5)


def directions(count: int) -> np.ndarray:
    """(count, 3): unit vectors of the upper hemisphere."""
    d = RNG.normal(size=(count, 3))
    d[:, 2] = np.abs(d[:, 2])
    return d / np.linalg.norm(d, axis=-1, keepdims=True)


# --- one groove ------------------------------------------------------------------------------------------------------
def test_what_is_hidden_is_what_rays_count():
    facet, lean, other = RNG.uniform(-1.4, 1.4, (3, 300))
    samples = 500
    hidden, counted = twin("groove_hidden")(facet, lean), twin("groove_hidden_counted")(facet, lean, samples)
    assert np.max(np.abs(hidden - counted)) <= 1 / samples and np.ptp(counted) == 1
    part = (hidden > 0.1) & (hidden < 0.9)
    assert np.count_nonzero(part) > 20, "the comparison would say nothing"
    opened, both = twin("groove_open")(facet, lean, other), twin("groove_open_counted")(facet, lean, other, samples)
    assert np.max(np.abs(opened - both)) <= 1 / samples


def test_both_hidden_parts_begin_in_the_valley():
    facet, light, eye = RNG.uniform(-1.4, 1.4, (3, 300))
    hidden = twin("groove_hidden")
    assert np.allclose(twin("groove_open")(facet, light, eye), 1 - np.maximum(hidden(facet, light), hidden(facet, eye)))
    assert np.array_equal(twin("groove_open")(facet, light, eye), twin("groove_open")(facet, eye, light))
    assert np.allclose(hidden(facet, light), hidden(-facet, -light), atol=1e-15)


@pytest.mark.parametrize("count", [500])
def test_directions_off_the_groove_are_seen_along_it(count):
    """The closed form in the plane is Blinn's formula with three-dimensional vectors; rays say so too."""
    n, light, v = np.array([0.0, 0.0, 1.0]), directions(count), directions(count)
    h = (light + v) / np.linalg.norm(light + v, axis=-1, keepdims=True)
    formula = np.minimum(1, 2 * h[:, 2] * np.minimum(light[:, 2], v[:, 2]) / np.sum(v * h, -1))
    facet = twin("facet_lean")(n, h)
    lean_l, lean_v = (twin("groove_lean")(n, h, d) for d in (light, v))
    assert np.allclose(twin("groove_open")(facet, lean_l, lean_v), formula, rtol=1e-10, atol=1e-12)
    assert np.max(np.abs(twin("groove_open_counted")(facet, lean_l, lean_v, 400) - formula)) <= 1 / 400
    assert np.count_nonzero(formula < 0.9) > count // 10


def test_a_flat_plate_hides_nothing():
    up = np.array([0.0, 0.0, 1.0])
    assert twin("facet_lean")(up, up) == 0 and twin("groove_lean")(up, up, directions(1)[0]) == 0
    assert np.all(twin("groove_hidden")(0.0, np.linspace(-1.57, 1.57, 9)) == 0)
    assert np.all(twin("groove_hidden_counted")(0.0, np.linspace(-1.57, 1.57, 9), 50) == 0)


@pytest.mark.parametrize("facet", [0.2, 0.785, 1.3])
def test_what_a_diffuse_facet_sends_to_the_other(facet):
    """Rays from points of the facet, even in the sine of the angle: what a diffuse facet shines, along the groove."""
    t, u = np.meshgrid((np.arange(400) + 0.5) / 400, 2 * (np.arange(400) + 0.5) / 400 - 1)
    blocked = twin("groove_blocked")(facet, t, np.arcsin(u) + facet)
    assert np.mean(blocked) == pytest.approx(twin("groove_exchange")(facet), abs=4e-3)
