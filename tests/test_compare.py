"""A second opinion: pyrender's pixels are what our twin of its model says, and it says where the models differ."""

import json

import numpy as np
import pytest
from PIL import Image

from app import meshes
from app.__main__ import main
from app.badges import check
from app.catalog import step, steps
from app.compare.definitions import at_45, table
from app.compare.material import material, unlike
from app.compare.pictures import BOUND, compare, difference, off_silhouettes
from app.lesson import Camera
from app.optics.gltf import alpha_gltf, brdf_gltf, g_gltf, roughness_gltf, shading_gltf
from app.optics.smith import g_smith_correlated_ggx
from app.problem import Usage
from app.reference import Picture, radiance
from app.state import defaults

BOARD = step("plausible_shading/board")
SIZE = 256, 256


def compared(found, shape, **values):
    values = defaults(found) | values
    return compare(material(found, values), meshes.built_in(shape).triangles, values, size=SIZE)


# --- the twin --------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize(("found", "shape", "values"), [
    (BOARD, "knot", {}),
    (BOARD, "sphere", {"f0": 0.9, "rho": 0.0, "m": 0.04}),  # a metal, its roughness 0.2
    (BOARD, "bowl", {"m": 1.0, "theta_l": 1.3, "theta_v": 0.2}),
    (step("plausible_shading/compare"), "knot", {}),
], ids=["plastic knot", "polished metal", "rough, low light", "copper knot"])
def test_aligned_models_agree_at_every_pixel(found, shape, values):
    """Off silhouettes our GLSL of glTF's model is pyrender's radiance to 0.7 % and 1e-4: what its 8 bits round."""
    both = compared(found, shape, **values)
    apart, allowed = np.abs(both.aligned - both.theirs), BOUND[0] * both.theirs + BOUND[1]
    assert BOUND == (0.007, 1e-4) and both.inside.sum() > 10_000
    assert (apart <= allowed)[both.inside].all() and both.within
    assert both.theirs[both.inside].max() > 0.3
    own = np.abs(both.ours - both.theirs)[both.inside]
    assert (own > allowed[both.inside]).mean() > 0.2, "and our own model is another one"
    assert both.difference.rmse > 5 * both.agreement.rmse


def test_another_geometry_term_would_be_seen():
    """GGX's own k = alpha / 2 in the place of pyrender's breaks the bound."""
    k = alpha_gltf(0.5) / 2
    other = 0.8 / (0.8 * (1 - k) + k) * (0.6 / (0.6 * (1 - k) + k))
    assert abs(other / g_gltf(0.8, 0.6, 0.5) - 1) > 10 * BOUND[0]


def test_its_geometry_term_is_neither_smiths():
    """A mirror's G is not 1, and it is not the height-correlated one of GGX."""
    assert g_gltf(0.5, 0.5, 0.0) < 0.8
    assert g_gltf(1.0, 1.0, 0.7) == pytest.approx(1.0)
    assert abs(g_gltf(0.3, 0.3, 0.7) / g_smith_correlated_ggx(0.3, 0.3, float(alpha_gltf(0.7))) - 1) > 0.02


def test_roughness_is_the_root_of_m():
    m = np.geomspace(0.0016, 1, 9)
    np.testing.assert_allclose(alpha_gltf(roughness_gltf(m)), m, rtol=1e-12)
    assert alpha_gltf(0.0) == pytest.approx(0.04**2) and alpha_gltf(0.5) == 0.25


def test_the_brdf_keeps_its_badges_and_the_shading_is_never_black():
    """Reciprocal, positive; energy is kept by a metal; below the horizon the shading shows a thousandth."""
    found = check(lambda n, l, v: brdf_gltf(n, l, v, 0.9, 1.0, 0.6))
    assert all(found[name].ok for name in ("non_negative", "reciprocal", "energy", "finite"))
    n, l, v = np.array([0, 0, 1.0]), np.array([0.6, 0, -0.8]), np.array([0, 0.6, 0.8])
    assert brdf_gltf(n, l, v, 0.9, 0.0, 0.6) == 0 and 0 < shading_gltf(n, l, v, 0.9, 0.0, 0.6) < 0.01


# --- what is measured ------------------------------------------------------------------------------------------------
def test_many_exposures_are_one_radiance():
    exact = np.geomspace(1e-4, 3.0, 3000).reshape(10, 100, 3)
    exposures = tuple(0.3 * 2.0**k for k in range(16))
    shots = [np.round(255 * np.minimum(exact * e, 1) ** (1 / 2.2)).astype(np.uint8) for e in exposures]
    found = radiance(Picture(shots[0], np.ones((10, 100)), np.stack(shots)), exposures)
    assert np.abs(found / exact - 1).max() < 0.0062
    alone = radiance(Picture(shots[0], np.ones((10, 100)), shots[0][None]), exposures[:1])
    assert np.abs(alone / exact - 1).max() > 0.05


def test_the_numbers_of_a_difference():
    a, inside = np.zeros((10, 200, 3)), np.ones((10, 200), bool)
    b = np.full_like(a, 0.5)
    b[0, 0], inside[0] = 9.0, False
    a[5, 5] = 1.5
    found = difference(a, b, inside)
    assert (found.pixels, found.most) == (1800, 1.0)
    assert found.rmse == pytest.approx(np.sqrt((1799 * 0.25 + 1) / 1800)) and found.p999 == pytest.approx(0.5)
    assert found.relative == pytest.approx(1.0)


def test_edges_are_left_out():
    points = np.stack([*np.meshgrid(np.linspace(-1, 1, 40), np.linspace(-1, 1, 40)), np.zeros((40, 40))], -1)
    normals = np.broadcast_to([0, 0, 1.0], points.shape).copy()
    view = Camera(elevation=90.0, distance=6.0, field_of_view=20.0)
    whole = off_silhouettes(points, normals, view, (40, 40))
    assert whole[2:-2, 2:-2].all() and not whole[:2].any() and not whole[:, -2:].any()
    normals[:, 20:] = [1.0, 0, 0]
    points[:10, :, 2] = -3.0
    cut = off_silhouettes(points, normals, view, (40, 40))
    assert not cut[:, 19:21].any() and not cut[8:12].any() and cut[14:-2, 2:18].all()


# --- materials and words ---------------------------------------------------------------------------------------------
def test_materials_in_gltfs_words():
    of = material(BOARD, defaults(BOARD) | {"m": 0.25, "rho": 0.6})
    assert (of.colour, of.metallic, of.roughness) == ((0.625,) * 3, 0.0, 0.5)
    of = material(BOARD, defaults(BOARD) | {"rho": 0.0, "f0": 0.9})
    assert (of.colour, of.metallic) == ((0.9,) * 3, 1.0)
    vases = step("plausible_shading/compare")
    gold, plastic = (material(vases, defaults(vases) | {"material": row}) for row in (5, 2))
    assert gold.metallic == 1 and gold.colour[0] > 0.9 and gold.colour[2] < 0.4
    assert plastic.metallic == 0 and plastic.colour[0] == pytest.approx(0.55 / 0.96)


def test_every_comparable_step_has_its_table():
    found = [one for one in steps() if not unlike(one)]
    names = {one.id for one in found}
    assert {"solid_angle/mesh", "geometry_term/with_without"} <= names
    assert {f"plausible_shading/{name}" for name in ("compare", "board")} <= names
    for one in found:
        of = material(one, defaults(one))
        assert 0.04 <= of.roughness <= 1 and len(table(of)) == 9 and all(all(row) for row in table(of))
    (_, *d), (_, *g) = at_45(material(BOARD, defaults(BOARD)))
    assert d == pytest.approx([16 / np.pi] * 2) and g == pytest.approx([1, 0.802], abs=1e-3)


@pytest.mark.parametrize(("name", "why"), [
    ("plausible_shading/quantities", "it has no model of matter. These can: solid_angle/mesh, "),
    ("brdfs/properties", "brdf_flawed depends on radiance, for which"),
    ("brdfs/definition", "brdf_paint depends on channel, for which"),
])
def test_a_step_that_cannot_says_why_and_which_can(name, why):
    found = step(name)
    with pytest.raises(Usage, match=f"{name} cannot be compared with pyrender: {why}"):
        material(found, defaults(found))


# --- the command -----------------------------------------------------------------------------------------------------
def test_the_command(tmp_path, capsys):
    words = ["compare", "plausible_shading/board", "--set", "m=0.5", "--aligned", "--json", "-o"]
    assert main([*words, str(tmp_path / "all")]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["state"] == "plausible_shading/board?m=0.5" and told["aligned"]["within"] is True
    assert told["difference"]["rmse"] == told["aligned"]["rmse"] and told["ours"]["function"] == "shading_gltf"
    assert sorted(path.name for path in (tmp_path / "all").iterdir()) == [
        "compare.png", "difference.png", "ours.png", "pyrender.png"]
    with Image.open(tmp_path / "all" / "compare.png") as page:
        assert page.size == (1600, 1040)
    ours, theirs = (np.asarray(Image.open(tmp_path / "all" / f"{name}.png")).astype(int)
                    for name in ("ours", "pyrender"))
    assert np.abs(ours - theirs).mean() < 0.5 < ours.std()


@pytest.mark.parametrize(("words", "sentence"), [
    (["-o", "a.jpg"], "a.jpg ends neither in .png nor is it a folder; write FILE.png or a folder's name."),
    (["--theme", "drak", "-o", "a.png"], "--theme drak: there are dark, light, projector. Did you mean dark?"),
    (["--set", "m=7"], "m=7: plausible_shading/board takes m from 0.05 to 1."),
])
def test_what_is_mistyped_is_told_before_the_work(capsys, words, sentence):
    assert main(["compare", "plausible_shading/board", *words]) == 2
    assert capsys.readouterr().err == f"halfway: {sentence}\n"
