"""pyrender draws where geometry says, lit as its formula says, and its death is one sentence."""

import sys

import numpy as np
import pytest

from app import camera, meshes, reference
from app.lesson import Camera
from app.problem import Problem
from app.reference import Light, Picture, Shot, linear, render

SIDE = Camera(azimuth=-90.0, elevation=0.0, distance=5.0)  # the eye on -y: +x is to the right, +z up
SPHERE = meshes.built_in("sphere").triangles
BOWL = meshes.built_in("bowl").triangles
ABOVE = {"light": Light(at=(0, 0, 1)), "camera": Camera(elevation=60.0)}
SIZE = (240, 180)
SHOTS = {
    "from the side": Shot(SPHERE, SPHERE, light=Light(at=(1, 0, 0)), camera=SIDE, size=SIZE),
    "from the eye": Shot(SPHERE, SPHERE, light=Light(at=(0, -1, 0)), camera=SIDE, size=SIZE, background=(0, 0, 1)),
    "point": Shot(SPHERE, SPHERE, light=Light("point", (0, -3, 0), 4 * np.pi), camera=SIDE, size=SIZE),
    "metal": Shot(SPHERE, SPHERE, colour=(0.9, 0.6, 0.3), metallic=1.0, roughness=0.5, light=Light(at=(1, -1, 0)),
                  camera=SIDE, size=SIZE),
    "off centre": Shot(np.add(SPHERE, (0.3, 0.2, -0.4)), SPHERE, camera=Camera(distance=4.0), size=(151, 250)),
    "bowl": Shot(BOWL, size=SIZE, **ABOVE),
    "one side": Shot(BOWL, size=SIZE, two_sided=False, **ABOVE),
}


@pytest.fixture(scope="module")
def pictures() -> dict[str, Picture]:
    return dict(zip(SHOTS, render(*SHOTS.values()), strict=True))


def rays(shot):
    """The eye and the unit directions through the pixels' middles, (height, width, 3)."""
    width, height = shot.size
    x, y = np.meshgrid((np.arange(width) + 0.5) / width * 2 - 1, 1 - (np.arange(height) + 0.5) / height * 2)
    back = np.linalg.inv(camera.view_projection(shot.camera, width / height))
    far = np.stack([x, y, np.ones_like(x), np.ones_like(x)], -1) @ back.T
    eye = camera.position(shot.camera)
    way = far[..., :3] / far[..., 3:] - eye
    return eye, way / np.linalg.norm(way, axis=-1, keepdims=True)


def hits(shot, centre=(0.0, 0.0, 0.0), radius=1.0):
    """Points where the rays meet a sphere, NaN where they miss."""
    eye, way = rays(shot)
    b = way @ (eye - centre)
    under = b * b - ((eye - centre) @ (eye - centre) - radius**2)
    return eye + way * (-b - np.sqrt(np.where(under >= 0, under, np.nan)))[..., None]


def inner(mask):
    """Pixels whose neighbours are inside too."""
    padded = np.pad(mask, 1)
    return np.all([padded[1 + i:1 + i + mask.shape[0], 1 + j:1 + j + mask.shape[1]]
                   for i in (-1, 0, 1) for j in (-1, 0, 1)], axis=0)


@pytest.mark.parametrize(("name", "centre"), [("from the side", (0, 0, 0)), ("off centre", (0.3, 0.2, -0.4))])
def test_silhouette_to_a_pixel(pictures, name, centre):
    drawn = pictures[name].depth > 0
    exact = ~np.isnan(hits(SHOTS[name], centre)[..., 0])
    assert exact.sum() > 2000
    assert not (drawn & inner(~exact)).any() and not (~drawn & inner(exact)).any()
    assert not pictures[name].rgb[inner(~exact)].any() and pictures[name].rgb[inner(exact)].all()


def test_depth(pictures):
    shot = SHOTS["from the side"]
    exact = hits(shot)[..., 1] + 5.0  # the eye is at y = -5 and looks along +y
    near, drawn = exact[1:-1, 1:-1], pictures["from the side"].depth[1:-1, 1:-1]
    around = np.stack([np.roll(exact, (i, j), (0, 1))[1:-1, 1:-1] for i in (-1, 0, 1) for j in (-1, 0, 1)])
    sure = near < 4.5  # the rim is at 4.8
    assert sure.sum() > 2000  # the depth is that of one sample of the pixel, not of its middle
    assert (drawn[sure] > around.min(axis=0)[sure] - 0.003).all()
    assert (drawn[sure] < around.max(axis=0)[sure] + 0.003).all()


def test_brighter_where_the_light_is(pictures):
    rgb = pictures["from the side"].rgb.astype(int)
    row = rgb[SIZE[1] // 2, :, 0]
    assert row[160] > row[140] > row[125] > 3 * row[100] and abs(row[100] - row[90]) <= 1
    assert rgb[60:80].mean() == pytest.approx(rgb[100:120].mean(), rel=0.01)  # above as below


def brdf(shot, points, to_light):
    """The docstring's formula, at points of the unit sphere."""
    n, l = points, to_light
    v = camera.position(shot.camera) - points
    v /= np.linalg.norm(v, axis=-1, keepdims=True)
    h = (l + v) / np.linalg.norm(l + v, axis=-1, keepdims=True)
    nl, nv = np.clip((n * l).sum(-1), 0.001, 1), np.clip((n * v).sum(-1), 0.001, 1)
    nh, vh = (n * h).sum(-1), (v * h).sum(-1)
    colour, a2, k = np.asarray(shot.colour), shot.roughness**4, (shot.roughness + 1) ** 2 / 8
    f0 = 0.04 * (1 - shot.metallic) + shot.metallic * colour
    f = f0 + (1 - f0) * ((1 - vh) ** 5)[..., None]
    g = nv / (nv * (1 - k) + k) * nl / (nl * (1 - k) + k)
    d = a2 / (np.pi * (nh**2 * (a2 - 1) + 1) ** 2)
    shine = f * (d * g / (4 * nl * nv + 0.001))[..., None]
    return ((1 - f) * 0.96 * (1 - shot.metallic) * colour / np.pi + shine) * nl[..., None]


@pytest.mark.parametrize("name", ["from the side", "from the eye", "point", "metal"])
def test_radiance_is_what_the_formula_says(pictures, name):
    shot = SHOTS[name]
    points = hits(shot)
    sure = inner(inner(~np.isnan(points[..., 0])))
    at = np.asarray(shot.light.at, dtype=float)
    away = at - points[sure] if shot.light.kind == "point" else np.broadcast_to(at, points[sure].shape)
    far = np.linalg.norm(away, axis=-1, keepdims=True)
    exact = shot.light.strength * brdf(shot, points[sure], away / far) / (far**2 if shot.light.kind == "point" else 1)
    lit = ((points[sure] * away).sum(-1) > 0.1)
    assert lit.sum() > 2000
    drawn = linear(pictures[name].rgb[sure])[lit]
    assert np.abs(drawn - np.minimum(exact, 1)[lit]).max() < 0.03
    assert np.abs(drawn - np.minimum(exact, 1)[lit]).mean() < 0.004


def test_background(pictures):
    assert (pictures["from the eye"].rgb[0, 0] == (0, 0, 255)).all()
    assert pictures["from the eye"].depth[0, 0] == 0


def test_inside_of_an_open_mesh(pictures):
    middle = SIZE[1] // 2 - 30, SIZE[0] // 2
    assert pictures["bowl"].rgb[middle].min() > 40 and pictures["bowl"].depth[middle] > 0
    assert (pictures["bowl"].depth > 0).sum() > (pictures["one side"].depth > 0).sum()


def test_wrong_triangles_are_refused():
    for triangles in (np.zeros((0, 3, 3)), np.zeros((4, 3)), np.full((1, 3, 3), np.nan)):
        with pytest.raises(Problem, match="finite triangles of shape"):
            render(Shot(triangles))


def test_death_and_hang_of_the_child_are_sentences(monkeypatch):
    shot = Shot(SPHERE, size=(8, 8))
    with monkeypatch.context() as patch:
        patch.setenv("EGL_DEVICE_ID", "999")
        with pytest.raises(Problem, match=r"without a picture \(ValueError: Invalid device ID \(999\)\). Run `halfway"):
            render(shot)
    with pytest.raises(Problem, match=r"did not answer within 0\.05 s"):
        render(shot, timeout=0.05)


@pytest.mark.skipif(sys.platform == "win32", reason="signals are of POSIX")
def test_a_crash_is_a_sentence(monkeypatch, tmp_path):
    crash = tmp_path / "python"
    crash.write_text("#!/bin/sh\nkill -SEGV $$\n")
    crash.chmod(0o755)
    monkeypatch.setattr(reference.sys, "executable", str(crash))
    with pytest.raises(Problem, match=r"without a picture \(signal 11\)"):
        render(Shot(SPHERE, size=(8, 8)))
