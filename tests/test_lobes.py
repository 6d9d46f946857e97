"""Lobes: the grid they stand on, the same in scenes, plots and sums."""

import numpy as np
import pytest

from app import shader
from app.gpu.evaluate import evaluate
from app.hemisphere import apart, around, frame
from app.optics.spherical import direction

LOBE = shader.read("display/lobe.glsl")
ST = np.stack(np.meshgrid(np.linspace(0, 1, 25), np.linspace(0, 1, 17)), -1)
PEAKS = [direction(theta, phi) for theta, phi in ((0, 0), (0.7, 0.4), (1.2, np.pi), (1.56, -2.0))]


@pytest.mark.parametrize("peak", PEAKS, ids=lambda p: f"{np.degrees(np.arccos(p[2])):.0f}°")
@pytest.mark.parametrize("width", [1e-3, 0.1, 20.0])
def test_a_grid_covers_the_hemisphere_from_its_pole_to_the_horizon(peak, width):
    d, _ = around(peak, ST[..., 0], ST[..., 1], width)
    assert np.abs(np.linalg.norm(d, axis=-1) - 1).max() < 1e-14
    assert d[..., 2].min() > -1e-14
    assert np.abs(d[0] - peak).max() < 1e-14
    assert np.abs(d[-1, :, 2]).max() < 1e-14, "the rim is the horizon"
    if width < 1:
        assert np.median(apart(d[8], peak)) < 0.4, "half of the cells are near the pole"
    x, w = np.polynomial.legendre.leggauss(120)
    s, t = (np.arange(256) + 0.5) / 256, 0.5 * (x[:, None] + 1)
    d, size = around(peak, *np.broadcast_arrays(s, t), width)
    if peak[2] > 0.1:  # else the rim turns too fast for so few cells
        assert 0.5 * np.sum(w[:, None] * size) / 256 == pytest.approx(2 * np.pi, rel=1e-5)
        assert 0.5 * np.sum(w[:, None] * size * d[..., 2]) / 256 == pytest.approx(np.pi, rel=1e-5)


@pytest.mark.parametrize("peak", PEAKS, ids=lambda p: f"{np.degrees(np.arccos(p[2])):.0f}°")
def test_scenes_have_the_same_grid(peak, ctx):
    for width in (0.02, 10.0):
        got = evaluate("lobe_direction", {"st": ST, "peak": peak, "width": width}, text=LOBE, ctx=ctx)
        assert np.abs(got - around(peak, ST[..., 0], ST[..., 1], width)[0]).max() < 2e-4


def test_the_length_of_a_lobe_is_linear_or_counts_powers_of_ten(ctx):
    args = {"value": np.array([0.0, 1e-3, 0.5, 5.0, -1.0]), "largest": 5.0}
    linear = evaluate("lobe_radius", args | {"powers": 0.0}, text=LOBE, ctx=ctx)
    assert linear == pytest.approx([0, 2e-4, 0.1, 1, 0])
    logarithmic = evaluate("lobe_radius", args | {"powers": 4.0}, text=LOBE, ctx=ctx)
    assert logarithmic == pytest.approx([0, 1 - np.log10(5e3) / 4, 0.75, 1, 0], abs=1e-6)


def test_a_frame_stands_across_its_pole():
    for pole in PEAKS:
        axes = np.stack([*frame(pole), pole])
        assert np.abs(axes @ axes.T - np.eye(3)).max() < 1e-15
