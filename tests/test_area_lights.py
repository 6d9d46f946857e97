"""Area lights of four shapes: closed form, samples and weights, each found a second way without its formula."""

import numpy as np
import pytest

from app.gpu.evaluate import evaluate
from app.optics import area_light, light_samples, light_shape, shape_samples, solid_angle, solid_angle_flat

SHAPES = {"panel": 0, "disk": 1, "sphere": 2, "polygon": 3}
KINDS = {"grid": 0, "random": 1, "stratified": 2, "Sobol": 3, "Sobol in solid angle": 4, "Gauss in solid angle": 5}
PLACE = {"light_x": 0.2, "light_y": 0.1, "light_height": 0.8, "panel_width": 1.4, "panel_depth": 0.9,
         "panel_tilt": -0.3}
LAMP = {"radiance": 10.0} | PLACE
MIDDLE = np.array([0.2, 0.1, 0.8])
HERE = (0.1, -0.4, 0.0)
PLACES = [HERE, (1.1, 0.9, 0.0), (0.2, 0.1, 0.0)]
CUT = {"light_height": 0.15, "panel_tilt": -0.9}  # half in the floor


def closed(kind, position=HERE, **more):
    return light_shape.irradiance_light(kind, **LAMP | more, position=position)


def estimate(kind, sampling, level, seed=1, position=HERE, **more):
    return shape_samples.irradiance_light_sampled(kind, **LAMP | more, position=position, sampling=sampling,
                                                  level=level, seed=seed)


def meets(kind: int, position, way):
    """Whether a ray in the directions `way` (..., 3) meets the lamp: geometry, without any formula."""
    to = MIDDLE - position
    if kind == 2:
        along = way @ to
        return (along > 0) & (to @ to - along**2 < (LAMP["panel_width"] / 2) ** 2)
    tilt, depth = (0.0, LAMP["panel_width"]) if kind == 1 else (LAMP["panel_tilt"], LAMP["panel_depth"])
    back = np.array([0.0, -np.sin(tilt), np.cos(tilt)])
    r = (to @ back) / (way @ back)
    hit = way * r[..., None] - to
    s, t = hit[..., 0] / LAMP["panel_width"], (hit[..., 1] * np.cos(tilt) + hit[..., 2] * np.sin(tilt)) / depth
    inside = (np.abs(s) < 0.5) & (np.abs(t) < 0.5) & (r > 0) & (way @ back > 0)
    return inside & (shape_samples.shape_holds(kind, s + 0.5, t + 0.5) > 0)


@pytest.mark.parametrize("position", PLACES)
@pytest.mark.parametrize("name", SHAPES)
def test_the_closed_form_by_counting_rays(name, position):
    """Rays even in projected solid angle (Malley): pi times the share that meets the lamp."""
    kind = SHAPES[name]
    at = light_samples.grid_sample(np.arange(4**10), 10)
    disk = light_samples.concentric_disk(at[:, 0], at[:, 1])
    way = np.concatenate([disk, np.sqrt(1 - np.sum(disk * disk, -1, keepdims=True))], -1)
    counted = np.pi * LAMP["radiance"] * np.mean(meets(kind, position, way))
    assert closed(kind, position) == pytest.approx(counted, rel=2e-3)


def omega(kind: int, position) -> float:
    """The lamp's solid angle, by chapter 1."""
    x, y, z = MIDDLE - position
    if kind == 1:
        return solid_angle.solid_angle_disk(LAMP["panel_width"] / 2, z, np.hypot(x, y))
    if kind == 2:
        return solid_angle.solid_angle_sphere(LAMP["panel_width"] / 2, np.sqrt(x * x + y * y + z * z))
    corners = area_light.outline_at(4 + kind // 3, np.arange(4 + kind // 3))
    points = area_light.panel_point(**PLACE, s=corners[:, 0], t=corners[:, 1])
    return solid_angle_flat.solid_angle_polygon(points - position, len(corners))


@pytest.mark.parametrize("position", PLACES)
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("name", SHAPES)
def test_weights_sum_to_the_solid_angle_and_samples_lie_on_the_light(name, kind, position):
    shape, sampling = SHAPES[name], KINDS[kind]
    piece = shape_samples.light_piece(shape, **PLACE, position=position, sampling=sampling, level=6, seed=5,
                                      index=np.arange(4**6))
    assert np.mean(piece[:, 3]) == pytest.approx(omega(shape, position), rel=0.03 if kind == "random" else 6e-3)
    used = piece[piece[:, 3] > 0, :3]
    length = np.sqrt(np.sum(used * used, -1, keepdims=True))
    assert np.all(meets(shape, position, used / length)), "each sample is seen on the lamp"
    if shape == 2:
        off = np.sqrt(np.sum((used + position - MIDDLE) ** 2, -1))
        assert off == pytest.approx(np.full(len(off), LAMP["panel_width"] / 2))
        assert np.all(length < np.linalg.norm(MIDDLE - position)), "on the near side"


@pytest.mark.parametrize("more", [{}, CUT], ids=["above", "cut"])
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("name", SHAPES)
def test_every_shape_and_kind_meets_the_closed_form(name, kind, more):
    exact = closed(SHAPES[name], **more)
    found = estimate(SHAPES[name], KINDS[kind], 6, 1000 + 17 * np.arange(16), **more)
    assert exact > 1 and np.sqrt(np.mean((found / exact - 1) ** 2)) < (0.06 if kind == "random" else 5e-3)


@pytest.mark.parametrize(("kind", "low", "high"), [
    ("random", 0.40, 0.60), ("stratified", 0.80, 1.2), ("Sobol", 0.6, 2.0)])
@pytest.mark.parametrize("name", ["disk", "sphere", "polygon"])
def test_the_order_of_convergence_of_the_other_shapes(name, kind, low, high):
    levels, seed = np.arange(3, 7), 1000 + 17 * np.arange(24)
    off = [estimate(SHAPES[name], KINDS[kind], level, seed) / closed(SHAPES[name]) - 1 for level in levels]
    order = -np.polyfit(levels * np.log(4), np.log([np.sqrt(np.mean(e**2)) for e in off]), 1)[0]
    assert low <= order <= high, order


def test_gauss_points_are_for_smooth_lights():
    """Six digits and more of a panel and a sphere from 64 points; a disk in its square keeps two."""
    error = {name: abs(estimate(kind, 5, 3) / closed(kind) - 1) for name, kind in SHAPES.items()}
    assert error["panel"] < 1e-6 and error["sphere"] < 1e-6 and error["disk"] > 1e-4 and error["polygon"] > 1e-4, error


@pytest.mark.parametrize("even", ["fan", "disk", "cap", "cone"])
def test_samples_are_even(even):
    """Chi-squared over 64 cells of equal area or solid angle, found apart from the map: level 0.001."""
    s, t = light_samples.random_sample(np.arange(40000), 11).T
    if even == "fan":
        p = shape_samples.fan_point(s, t) + 0.5  # cells: a grid over the part of the pentagon below its widest corners
        inside = (np.abs(p[:, 0] - 0.5) < 0.3) & (p[:, 1] > 0.4) & (p[:, 1] < 1.0)
        cells, edges = np.stack([(p[inside, 0] - 0.2) / 0.6, (p[inside, 1] - 0.4) / 0.6]), 0.36 / 0.68
        assert inside.mean() == pytest.approx(edges, abs=0.01)
    elif even == "disk":
        x, y = light_samples.concentric_disk(s, t).T
        cells = np.stack([x * x + y * y, (np.arctan2(y, x) / (2 * np.pi)) % 1])
    else:
        axis, radius = np.array([0.6, 0.0, 0.8]) * 1.3, 0.7
        piece = shape_samples.sphere_piece(axis, radius, 0 if even == "cap" else 4, s, t)[:, :3]
        way = piece - axis if even == "cap" else piece / np.linalg.norm(piece, axis=-1, keepdims=True)
        pole = -axis / 1.3 if even == "cap" else axis / 1.3
        rim = radius / 1.3 if even == "cap" else np.sqrt(1 - (radius / 1.3) ** 2)
        height = (way @ pole) / (radius if even == "cap" else 1.0)
        side = np.array([0.8, 0.0, -0.6])
        cells = np.stack([(1 - height) / (1 - rim), (np.arctan2(way[:, 1], way @ side) / (2 * np.pi)) % 1])
    counts = np.histogram2d(*cells, bins=8, range=((0, 1), (0, 1)))[0]
    mean = counts.sum() / 64
    assert counts.sum() == cells.shape[1] and np.sum((counts - mean) ** 2) / mean < 104


def test_lights_inside_geometry():
    """Inside a sphere it is light all round; on a flat light's plane, behind it, below the floor: nothing."""
    ball = {"light_height": 0.1, "light_x": 0.0, "light_y": 0.0, "position": (0.1, 0.0, 0.0)}
    assert closed(2, **ball) == pytest.approx(10 * np.pi)
    for kind in KINDS.values():
        assert estimate(2, kind, 6, **ball) == pytest.approx(10 * np.pi, rel=0.05 if kind == 1 else 5e-3)
        for shape in range(4):
            below = {"light_height": -1.0, "position": (1.5, 1.5, 0.0)}
            assert closed(shape, **below) == estimate(shape, kind, 3, **below) == 0.0
            sunk = {"light_height": 0.0, "panel_tilt": 0.0, "panel_width": 0.4, "position": (1.5, 1.5, 0.0)}
            found = closed(shape, **sunk), estimate(shape, kind, 3, **sunk)
            assert (min(found) > 0) if shape == 2 else found == (0.0, 0.0)


@pytest.mark.parametrize("kind", ["Sobol in solid angle", "Gauss in solid angle"])
@pytest.mark.parametrize("name", ["disk", "polygon"])
def test_float32_differs_by_samples_on_the_rim_only(name, kind, ctx):
    rng, count = np.random.default_rng(5), 300
    args = {"light_shape": np.full(count, SHAPES[name]), "radiance": np.ones(count),
            "position": rng.uniform(-1, 1, (count, 3)) * [1, 1, 0], "sampling": np.full(count, KINDS[kind]),
            "level": np.full(count, 3), "seed": rng.integers(0, 1000, count)}
    for key, low, high in (("light_x", -1, 1), ("light_y", -1, 1), ("light_height", 0.3, 1.5), ("panel_width", 0.3, 2),
                           ("panel_depth", 0.3, 2), ("panel_tilt", -0.6, 0.6)):
        args[key] = rng.uniform(low, high, count)
    args = {k: v.astype(np.float32).astype(float) if v.dtype.kind == "f" else v for k, v in args.items()}
    exact = shape_samples.irradiance_light_sampled(**args)
    off = np.abs(evaluate("irradiance_light_sampled", args, ctx=ctx) - exact)
    assert np.count_nonzero(off > 1e-4 * exact + 1e-6) <= 6, "a sample on the rim may fall on either side, one in 64"
    assert np.all(off <= 2 * 4 * np.pi / 64)
