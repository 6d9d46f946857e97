"""What must hold whatever the formula: identities, limits and two routes to one number."""

import numpy as np
import pytest

from app.gpu.evaluate import evaluate
from app.optics import projected_solid_angle as projected
from app.optics import solid_angle as solid
from app.optics import solid_angle_flat as flat
from app.optics import spherical, square_patch
from app.shader import read
from app.stress.domain import cube

RNG = np.random.default_rng(7)


def test_whole_and_half():
    assert solid.solid_angle_cone(np.pi) == pytest.approx(4 * np.pi, rel=1e-15)
    assert solid.solid_angle_cone(np.pi / 2) == pytest.approx(2 * np.pi, rel=1e-15)
    assert solid.solid_angle_sphere(1.0, 1.0) == pytest.approx(2 * np.pi)
    assert solid.solid_angle_sphere(1.0, 0.5) == pytest.approx(4 * np.pi)
    assert solid.solid_angle_disk_on_axis(1.0, 0.0) == pytest.approx(2 * np.pi)
    assert solid.solid_angle_disk(1.0, 0.0, [0.5, 1.0, 1.5]) == pytest.approx([2 * np.pi, np.pi, 0])
    assert projected.projected_solid_angle_cone([np.pi / 2, 2.0]) == pytest.approx([np.pi, np.pi])


def test_octants_fill_the_sphere():
    x, y, z = np.eye(3)
    signs = [1 - 2 * np.array(s) for s in np.ndindex(2, 2, 2)]
    assert sum(flat.solid_angle_triangle(s * x, s * y, s * z) for s in signs) == pytest.approx(4 * np.pi)


def test_disk_off_axis_meets_the_axis_and_the_rim():
    height = 10.0 ** np.linspace(-6, 6, 49)
    on_axis = solid.solid_angle_disk_on_axis(1.0, height)
    assert np.max(np.abs(solid.solid_angle_disk(1.0, height, 0.0) / on_axis - 1)) < 1e-14
    beside = solid.solid_angle_disk(1.0, 0.3, [1 - 1e-9, 1.0, 1 + 1e-9])
    assert np.ptp(beside) < 1e-7


def test_disk_is_a_polygon_of_many_corners():
    around = np.linspace(0, 2 * np.pi, 2000, endpoint=False)
    for offset, height in ((0.3, 0.4), (1.4, 0.2), (3.0, 0.5), (0.5, 4.0)):
        corners = np.stack([np.cos(around) + offset, np.sin(around), np.full(2000, height)], -1)
        assert flat.solid_angle_polygon(corners, 2000) == pytest.approx(
            solid.solid_angle_disk(1, height, offset), rel=1e-5)
        assert projected.projected_solid_angle_polygon(corners, 2000) == pytest.approx(
            projected.projected_solid_angle_disk(1, height, offset), rel=1e-5)


def test_polygon_is_the_sum_of_its_triangles_also_when_it_is_hollow():
    arrow = np.array([[0, 0, 1], [2, -1, 1], [0.5, 0, 1], [2, 1, 1]], float)
    halves = flat.solid_angle_triangle(*arrow[[0, 1, 2]]) + flat.solid_angle_triangle(*arrow[[0, 2, 3]])
    assert flat.solid_angle_polygon(arrow, 4) == pytest.approx(halves)
    assert flat.solid_angle_polygon(np.roll(arrow, 1, 0), 4) == pytest.approx(halves)


def test_rectangle_by_three_routes():
    for x0, x1, y0, y1, d in ((-1, 2, -0.5, 1, 0.7), (0.2, 3, -1, 2, 0.1), (-3, -1, 0.5, 2, 1), (1, 1.5, -4, -2, 0.3)):
        corners = np.array([[x0, y0, d], [x1, y0, d], [x1, y1, d], [x0, y1, d]])
        assert flat.solid_angle_rectangle_off_axis(x0, x1, y0, y1, d) == pytest.approx(
            flat.solid_angle_polygon(corners, 4), rel=1e-13)
        assert projected.projected_solid_angle_rectangle(x0, x1, y0, y1, d) == pytest.approx(
            projected.projected_solid_angle_polygon(corners, 4), rel=1e-13)


def test_mesh_inside_outside_and_on_it():
    eyes = np.array([[0, 0, 0], [0.9, 0.5, -0.3], [3, 0, 0], [1, 0.2, 0.1], [1, 1, 0.2], [1, 1, 1]], float)
    parts = np.array([1, 1, 0, 1 / 2, 1 / 4, 1 / 8])
    assert flat.solid_angle_mesh(cube(), eyes) == pytest.approx(4 * np.pi * parts, abs=1e-14)
    in_float32 = evaluate("solid_angle_mesh", {"triangles": cube(), "eye": eyes})
    assert in_float32 == pytest.approx(4 * np.pi * parts, abs=1e-5)


def test_mesh_of_many_faces_keeps_its_digits():
    """20 480 faces: a plain float32 sum would lose 1e-4."""
    theta, phi = np.linspace(0, np.pi, 81), np.linspace(0, 2 * np.pi, 129)
    p = spherical.direction(theta[:, None], phi[None])
    a, b, c, d = p[:-1, :-1], p[1:, :-1], p[1:, 1:], p[:-1, 1:]
    triangles = np.concatenate([np.stack(t, 2).reshape(-1, 3, 3) for t in ((a, b, c), (a, c, d))])
    found = evaluate("solid_angle_mesh", {"triangles": triangles, "eye": np.array([0.2, -0.1, 0.3])})
    assert found == pytest.approx(4 * np.pi, rel=2e-6)


def test_patch_does_not_care_where_it_is():
    theta, phi = RNG.uniform(0, np.pi, 20), RNG.uniform(-np.pi, np.pi, 20)
    around = ((0, 0), (1, 0), (1, 1), (0, 1))
    corners = np.stack([square_patch.patch_point(theta, phi, 1.3, 0.7, 0.9, s, t) for s, t in around], -2)
    exact = square_patch.solid_angle_patch(1.3, 0.7, 0.9)
    assert flat.solid_angle_polygon(corners, 4) == pytest.approx(np.full(20, exact), rel=1e-13)
    shadow = square_patch.projected_solid_angle_patch(theta, 1.3, 0.7, 0.9)
    assert projected.projected_solid_angle_polygon(corners, 4) == pytest.approx(shadow, rel=1e-12, abs=1e-15)
    normal = square_patch.patch_normal(theta, phi, 0.7)
    assert np.abs(np.sum(normal * (corners[:, 1] - corners[:, 3]), -1)).max() < 1e-15
    assert np.all(square_patch.patch_normal(theta, phi, 0.0) == -spherical.direction(theta, phi))


def test_counting_converges():
    exact = square_patch.solid_angle_patch(1.0, 0.4, 0.8)
    off = [abs(square_patch.solid_angle_patch_counted(0.6, np.linspace(0, 1, 16), 1.0, 0.4, 0.8, n) / exact - 1).mean()
           for n in (100, 1000, 10000, 60000)]
    assert off[-1] < 2e-3
    assert off[0] > off[1] > off[2] > off[3]


def test_fibonacci_directions_stay_even_in_float32():
    index = np.arange(60000)
    found = evaluate("fibonacci_direction", {"index": index, "samples": 60000})
    assert np.abs(found - spherical.fibonacci_direction(index, 60000)).max() < 1e-6


def test_cells_add_up():
    rows = 12
    theta = (np.arange(rows) + 0.5) * np.pi / rows
    exact = solid.solid_angle_cell(theta, np.pi / rows, np.pi / rows).sum() * 2 * rows
    midpoint = solid.solid_angle_cell_differential(theta, np.pi / rows, np.pi / rows).sum() * 2 * rows
    assert exact == pytest.approx(4 * np.pi, rel=1e-14)
    assert midpoint == pytest.approx(solid.solid_angle_cells(rows), rel=1e-14)


def test_small_triangles_keep_float32():
    """Sizes 1 to 1e-5 at distance 1 in any direction, facing the eye: measured 4e-7 at worst, 6e-8 in the middle."""
    count = 100000
    theta, phi, size = RNG.uniform(0, np.pi, count), RNG.uniform(-np.pi, np.pi, count), 10 ** RNG.uniform(-5, 0, count)
    corners = [square_patch.patch_point(theta, phi, 1.0, 0.0, size, s, t) for s, t in ((0, 0), (1, 0), (0.4, 1))]
    corners = [c.astype(np.float32).astype(float) for c in corners]
    got = evaluate("solid_angle_triangle", dict(zip("abc", corners, strict=True)))
    assert np.max(np.abs(got / flat.solid_angle_triangle(*corners) - 1)) < 1e-6


@pytest.mark.parametrize(("y", "x"), [(0, 0), (0, 1), (0, -1), (1, 0), (-1, 0), (1e-30, -1e-30), (3e-20, 1)])
def test_core_arctangent_at_its_corners(y, x, ctx):
    text = read("core/constants.glsl") + read("core/angle.glsl").split("\n", 1)[1]
    got = evaluate("arctan2", {"y": y, "x": x}, text=text, ctx=ctx)
    assert got == pytest.approx(np.arctan2(np.float32(y), np.float32(x)), rel=2e-7)


def test_core_arctangent_everywhere(ctx):
    text = read("core/constants.glsl") + read("core/angle.glsl").split("\n", 1)[1]
    y, x = (RNG.choice([-1, 1], 100000) * 10 ** RNG.uniform(-6, 6, 100000) for _ in "yx")
    y, x = y.astype(np.float32), x.astype(np.float32)
    got = evaluate("arctan2", {"y": y, "x": x}, text=text, ctx=ctx)
    assert np.max(np.abs(got / np.arctan2(y.astype(float), x.astype(float)) - 1)) < 3e-7


def test_complete_elliptic_against_scipy():
    from scipy.special import ellipk

    m = np.linspace(0, 0.999, 50)
    one = np.ones_like(m)
    assert solid._complete_elliptic(np.sqrt(1 - m), one, one, one) == pytest.approx(ellipk(m), rel=1e-14)
