"""A user's maps: read or refused in one sentence, kept as they are stored, and read by scene and twins alike."""

import numpy as np
import pytest
from PIL import Image

from app import maps, meshes, tables
from app.__main__ import main
from app.catalog import step
from app.export.shooting import shot
from app.export.still import data
from app.gpu.context import context
from app.gpu.evaluate import evaluate
from app.optics.colour import linear_to_srgb, srgb_to_linear
from app.optics.maps import stored_roughness
from app.problem import Problem
from app.readouts import numbers
from app.state import defaults
from app.theme import THEMES

PLATE = step("plausible_shading/texturing")
STEPS = np.repeat(np.repeat(np.array([[0, 80], [160, 255]], np.uint8), 8, 0), 8, 1)  # the first row is the upper one


def saved(path, texels, **how):
    Image.fromarray(np.asarray(texels, np.uint8)).save(path, **how)
    return path


def test_a_map_is_the_numbers_of_its_file(tmp_path):
    found = maps.read("roughness", saved(tmp_path / "r.png", STEPS))
    assert found.texels.shape == (16, 16, 4) and found.texels[0, 0].tolist() == [160, 160, 160, 255]  # the lowest row
    assert found.texels[-1, -1, 0] == 80 and found.note == "r.png, 16 x 16, as roughness, a number: read as it is"
    colour = maps.read("albedo", saved(tmp_path / "a.png", np.full((4, 4, 3), (200, 100, 50))))
    assert (colour.texels[..., :3] == (200, 100, 50)).all() and "a colour: decoded from sRGB" in colour.note


def test_16_bits_and_transparency_and_packed_channels(tmp_path):
    Image.fromarray(np.full((4, 4), 32768, np.uint16)).save(tmp_path / "deep.png")
    assert set(maps.read("roughness", tmp_path / "deep.png").texels[..., 0].ravel().tolist()) == {128}
    glass = maps.read("f0", saved(tmp_path / "g.png", np.full((4, 4, 4), (10, 20, 30, 40))))
    assert glass.texels[0, 0].tolist() == [10, 20, 30, 255] and "its transparency is left out" in glass.note
    packed = maps.read("roughness", saved(tmp_path / "orm.png", np.full((4, 4, 3), (255, 90, 0))))
    assert (packed.texels[..., :3] == 90).all() and "its green is taken, where glTF keeps roughness" in packed.note


def test_what_looks_like_another_kind_is_said(tmp_path):
    blue = saved(tmp_path / "n.png", np.full((8, 8, 3), (128, 128, 255)))
    assert "--map normal=FILE" in maps.read("albedo", blue).note
    assert "look like" not in maps.read("normal", blue).note
    assert "it does not look like a map of normals" in maps.read("normal", saved(tmp_path / "r.png", STEPS)).note


def test_a_large_colour_is_averaged_as_light(tmp_path):
    """Black and white in turn: half of the light is stored as 188, half of a roughness as 128."""
    board = np.zeros((2, 2 * maps.MOST), np.uint8)
    board[:, ::2] = 255
    path = saved(tmp_path / "b.png", board)
    colour, number = maps.read("albedo", path), maps.read("roughness", path)
    assert colour.texels.shape == (1, maps.MOST, 4) and "averaged to 1024 x 1" in colour.note
    assert (colour.texels[..., 0] == round(255 * float(linear_to_srgb(0.5)))).all()
    assert (number.texels[..., 0] == 128).all()


@pytest.mark.parametrize(("content", "name", "sentence"), [
    (None, "none.png", "there is no file .*none.png; give the path of a picture"),
    (b"GIF89a", "a.png", "a.png is no PNG or JPEG picture"),
    (b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR", "cut.png", "cut.png is (damaged|no PNG)"),
    ("folder", "f.png", "f.png is a folder"),
])
def test_what_is_no_map_is_one_sentence(tmp_path, content, name, sentence):
    path = tmp_path / name
    if content == "folder":
        path.mkdir()
    elif content is not None:
        path.write_bytes(content)
    with pytest.raises(Problem, match=sentence):
        maps.read("albedo", path)


def test_a_picture_cut_short(tmp_path):
    path = saved(tmp_path / "cut.png", np.random.default_rng(1).integers(0, 255, (64, 64, 3)))
    path.write_bytes(path.read_bytes()[:4000])
    with pytest.raises(Problem, match=r"cut\.png is damaged"):
        maps.read("albedo", path)


@pytest.mark.parametrize(("words", "sentence"), [
    (["texturing", "--map", "rough=a.png"], "there is no map rough. Did you mean roughness?"),
    (["texturing", "--map", "a.png"], "--map a.png: write a kind and a file, like --map roughness=FILE"),
    (["compare", "--map", "albedo=a.png"], "plausible_shading/compare has no maps that albedo=a.png"),
])
def test_what_is_mistyped_is_told(tmp_path, capsys, words, sentence):
    assert main(["render", f"plausible_shading/{words[0]}", *words[1:], "-o", str(tmp_path / "x.png")]) == 2
    assert sentence in capsys.readouterr().err


def test_the_kind_of_a_dropped_file():
    names = {"wood_normal_gl.png": "normal", "Rust-Roughness.jpg": "roughness", "metal_specular.png": "f0",
             "x.png": "albedo"}
    assert {name: maps.guessed(f"/a/{name}") for name in names} == names


def test_the_scene_and_the_numbers_read_the_users_map(tmp_path):
    """The plate's tile of albedo shows the file's own numbers; the readouts of roughness are the file's."""
    files = [f"albedo={saved(tmp_path / 'a.png', np.full((4, 4, 3), (40, 120, 200)))}",
             f"roughness={saved(tmp_path / 'r.png', STEPS)}"]
    values = defaults(PLATE)
    values |= data(PLATE, values, maps=files) | {"map_s": 0.25, "map_t": 0.25}
    figures = {f.label: f.value for f in numbers(PLATE.step, values, context())}
    assert figures["m at the point"] == pytest.approx(160 / 255)
    assert figures["m, read as sRGB"] == pytest.approx(float(srgb_to_linear(160 / 255)))
    size = 640, 480
    own = np.asarray(shot(PLATE, values, None, size, THEMES["dark"], small=True)).reshape(-1, 3).astype(int)
    without = defaults(PLATE) | data(PLATE, values)
    plain = np.asarray(shot(PLATE, without, None, size, THEMES["dark"], small=True)).reshape(-1, 3).astype(int)
    for rgb in ((40, 120, 200), (80, 80, 80), (160, 160, 160)):  # on the tiles, through decoding and display
        count, before = (int((np.abs(one - rgb).max(-1) <= 1).sum()) for one in (own, plain))
        assert count > 500 > before, rgb


def test_the_twin_is_bilinear_and_repeats():
    texels = np.zeros((2, 2, 4), np.uint8)
    texels[..., 3], texels[..., 0] = 255, [[0, 100], [200, 50]]
    s, t = np.array([0.25, 0.5, 0.0, 0.5, 1.25]), np.array([0.25, 0.25, 0.25, 0.5, 0.75])
    exact = np.array([0, 50, 50, 87.5, 200]) / 255
    np.testing.assert_allclose(stored_roughness(texels, s, t), exact, atol=1e-12)
    np.testing.assert_allclose(evaluate("stored_roughness", {"roughness_map": texels, "map_s": s, "map_t": t}), exact,
                               atol=1e-6)


def test_a_step_without_maps_carries_none():
    assert not tables.has_maps(step("plausible_shading/compare").step.scene) and tables.has_maps(PLATE.step.scene)
    assert all((one == maps.NONE).all() for one in tables.chosen(PLATE.step.scene, {}).values())


# --- a mesh of the user ----------------------------------------------------------------------------------------------
EVERYTHING = step("plausible_shading/everything")
OBJ = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0.1 0.2\nvt 0.7 0.2\nvt 0.1 0.9\nf 1/1 2/2 3/3\nf 1/1 2/3 4/2\n"


def test_texture_coordinates_come_with_their_corners(tmp_path):
    path = tmp_path / "a.obj"
    path.write_text(OBJ)
    mesh = meshes.load(path)
    assert mesh.texture_coordinates is not None and "with texture coordinates" in mesh.note
    assert mesh.texture_coordinates[0].tolist() == [[0.1, 0.2, 1], [0.7, 0.2, 1], [0.1, 0.9, 1]]
    assert mesh.texture_coordinates[1, :, :2].tolist() == [[0.1, 0.2], [0.1, 0.9], [0.7, 0.2]]
    assert set(mesh.data) == {"triangles", "texture_coordinates"}
    path.write_text(OBJ.replace("/1", "").replace("/2", "").replace("/3", ""))
    bare = meshes.load(path)
    assert bare.texture_coordinates is None and "maps are laid on from the six sides of a cube" in bare.note
    assert set(bare.data) == {"triangles"}


def test_texture_coordinates_of_a_glb(tmp_path):
    trimesh = pytest.importorskip("trimesh")
    box = trimesh.creation.box()
    box.visual = trimesh.visual.TextureVisuals(uv=np.linspace(0, 1, 2 * len(box.vertices)).reshape(-1, 2))
    (tmp_path / "b.glb").write_bytes(box.export(file_type="glb"))
    mesh = meshes.load(tmp_path / "b.glb")
    assert mesh.texture_coordinates is not None and mesh.texture_coordinates.shape == (12, 3, 3)
    assert np.ptp(mesh.texture_coordinates[..., 0]) > 0.9


def test_maps_lie_on_a_mesh_where_its_coordinates_say(tmp_path, capsys):
    """An albedo that is black but for one corner of the map: with all coordinates there the object is bright."""
    spot = np.zeros((64, 64, 3), np.uint8)
    spot[:16, :16] = 255  # the upper left corner: s small, t near 1
    files = [f"albedo={saved(tmp_path / 'a.png', spot)}", f"f0={saved(tmp_path / 'f.png', 0 * spot + 10)}",
             f"roughness={saved(tmp_path / 'r.png', 0 * spot + 200)}"]
    lights = []
    for s, t in ((0.1, 0.9), (0.1, 0.1), (0.9, 0.9)):
        path = tmp_path / "square.obj"
        path.write_text(f"v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nvt {s} {t}\nvt {s + 0.01} {t}\nvt {s} {t + 0.01}\n"
                        "f 1/1 2/2 3/3\nf 1/1 3/3 4/2\n")
        values = defaults(EVERYTHING)
        values |= data(EVERYTHING, values, mesh=path, maps=files)
        picture = np.asarray(shot(EVERYTHING, values, None, (320, 240), THEMES["dark"], small=True))
        lights.append(picture[100:150, 190:230].astype(float).mean())
    assert lights[0] > 2 * lights[1] and lights[0] > 2 * lights[2] and abs(lights[1] - lights[2]) < 3
    assert "square.obj: 2 triangles" in capsys.readouterr().err
