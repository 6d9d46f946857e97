"""Built-in meshes: outward, closed where they say so, of the right size. A user's file: a mesh or one sentence."""

import logging
import re
import struct
import subprocess
import sys

import numpy as np
import pytest
import trimesh
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from app import mesh_files, meshes
from app.problem import Problem, Usage

PLY = """ply
format ascii 1.0
element vertex 3
property float x
property float y
property float z
element face 1
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
0 1 0
"""
CORNERS = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"


def solid_angle(triangles, eye=(0.0, 0.0, 0.0)):
    """Van Oosterom and Strackee (1983), summed."""
    a, b, c = np.moveaxis(triangles - np.asarray(eye), 1, 0)
    la, lb, lc = (np.linalg.norm(x, axis=1) for x in (a, b, c))
    dot = lambda x, y: (x * y).sum(axis=1)  # noqa: E731
    below = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb
    return 2 * np.arctan2(dot(a, np.cross(b, c)), below).sum()


def volume(triangles):
    return np.einsum("fi,fi", triangles[:, 0], np.cross(triangles[:, 1], triangles[:, 2])) / 6


@pytest.fixture
def save(tmp_path):
    def write(name, content):
        path = tmp_path / name
        path.write_bytes(content.encode() if isinstance(content, str) else content)
        return path

    return write


def refused(path):
    """The one sentence of a refusal."""
    with pytest.raises(Problem) as caught:
        meshes.load(path)
    words = str(caught.value)
    assert "\n" not in words and str(path) in words and words.endswith(".")
    return words


# the built-in ones


@pytest.mark.parametrize("name", meshes.BUILT_IN)
def test_built_in(name):
    mesh = meshes.built_in(name)
    area = np.linalg.norm(np.cross(mesh.triangles[:, 1] - mesh.triangles[:, 0],
                                   mesh.triangles[:, 2] - mesh.triangles[:, 0]), axis=1) / 2
    assert mesh.triangles.shape[1:] == (3, 3) and mesh.triangles.dtype == np.float64
    assert not mesh.triangles.flags.writeable
    assert area.min() > 1e-6 and volume(mesh.triangles) > 0
    assert np.linalg.norm(mesh.triangles, axis=-1).max() <= 1.3
    check = trimesh.Trimesh(mesh.triangles.reshape(-1, 3), np.arange(3 * len(mesh.triangles)).reshape(-1, 3))
    check.merge_vertices()
    assert check.is_winding_consistent and check.is_watertight == mesh.closed == (name != "bowl")


def test_sizes():
    assert volume(meshes.built_in("cube").triangles) == pytest.approx(1.5**3, rel=1e-14)
    assert volume(meshes.built_in("sphere").triangles) == pytest.approx(4 * np.pi / 3, rel=3e-3)
    assert np.linalg.norm(meshes.built_in("sphere").triangles, axis=-1) == pytest.approx(1.0, abs=1e-15)
    assert 4000 <= len(meshes.built_in("knot").triangles) <= 8000
    assert np.linalg.norm(meshes.built_in("knot").triangles, axis=-1).max() == pytest.approx(1.19)


def test_knot_is_one_tube_of_genus_one():
    faces = meshes.shared_corners(meshes.built_in("knot").triangles)
    assert faces.max() + 1 - len(faces) * 3 // 2 + len(faces) == 0  # Euler


def test_bowl_rim_is_a_circle_and_its_solid_angle_is_the_rim_s():
    triangles = meshes.built_in("bowl").triangles
    faces = meshes.shared_corners(triangles)
    points = np.zeros((faces.max() + 1, 3))
    points[faces] = triangles
    directed = {(a, b) for face in faces for a, b in zip(face, np.roll(face, -1), strict=True)}
    rim = points[[a for a, b in directed if (b, a) not in directed]]
    assert rim[:, 2] == pytest.approx(np.cos(np.radians(50)), abs=1e-15)
    assert np.linalg.norm(rim, axis=1) == pytest.approx(1.0, abs=1e-15)
    rim = rim[np.argsort(np.arctan2(rim[:, 1], rim[:, 0]))]
    lid = np.stack([np.tile([0.0, 0.0, 1.0], (len(rim), 1)), rim, np.roll(rim, -1, axis=0)], axis=1)
    assert solid_angle(triangles) + solid_angle(lid) == pytest.approx(4 * np.pi, rel=1e-12)
    assert solid_angle(triangles) == pytest.approx(2 * np.pi * (1 + np.cos(np.radians(50))), rel=2e-3)


@pytest.mark.parametrize("name", ["sphere", "knot", "cube"])
def test_closed_meshes_subtend_all_or_nothing(name):
    triangles = meshes.built_in(name).triangles
    inside = (0.64 + 0.36, 0.0, 0.0) if name == "knot" else (0.1, -0.2, 0.3)
    assert solid_angle(triangles, inside) == pytest.approx(4 * np.pi, rel=1e-12)
    assert solid_angle(triangles, (3.0, 1.0, 0.5)) == pytest.approx(0.0, abs=1e-12)


def test_unknown_name():
    with pytest.raises(Usage, match="Did you mean sphere"):
        meshes.built_in("spere")


def test_built_in_meshes_need_no_trimesh():
    code = "import sys\nfrom app import meshes\nmeshes.built_in('knot')\nsys.exit('trimesh' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


# a user's


@pytest.mark.parametrize("ending", ["stl", "obj", "ply", "glb", "stl_ascii"])
def test_every_format_gives_the_same_mesh(save, ending):
    box = trimesh.creation.box((2.0, 4.0, 4.0))
    box.apply_translation([10.0, 0.0, 0.0])
    mesh = meshes.load(save(f"box.{ending[:3]}", box.export(file_type=ending)))
    assert mesh.closed and mesh.name == f"box.{ending[:3]}" and len(mesh.triangles) == 12
    assert volume(mesh.triangles) == pytest.approx(32 / 27, rel=1e-6)
    assert mesh.triangles.max(axis=(0, 1)) == pytest.approx([1 / 3, 2 / 3, 2 / 3], rel=1e-6)
    assert "scaled by 0.333" in mesh.note and "closed" in mesh.note


def test_a_scene_is_put_together(save):
    scene = trimesh.Scene()
    scene.add_geometry(trimesh.creation.box())
    scene.add_geometry(trimesh.creation.box(), transform=trimesh.transformations.translation_matrix([0, 3, 0]))
    mirror = np.diag([1.0, 1.0, -1.0, 1.0])
    mirror[0, 3] = 3
    scene.add_geometry(trimesh.creation.box(), transform=mirror)
    scene.add_geometry(trimesh.PointCloud(np.eye(3)))
    mesh = meshes.load(save("scene.glb", scene.export(file_type="glb")))
    assert len(mesh.triangles) == 36 and mesh.closed
    assert "a set of points left out" in mesh.note and "+y" in mesh.note
    assert np.ptp(mesh.triangles[..., 2]) == pytest.approx(np.ptp(mesh.triangles[..., 0]))  # y went up
    assert np.ptp(mesh.triangles[..., 1]) == pytest.approx(np.ptp(mesh.triangles[..., 0]) / 4)


def test_inside_out_is_turned_and_mixed_winding_is_said(save):
    ball = trimesh.creation.icosphere(2)
    turned = trimesh.Trimesh(ball.vertices, ball.faces[:, ::-1], process=False)
    mesh = meshes.load(save("turned.stl", turned.export(file_type="stl")))
    assert volume(mesh.triangles) > 0 and mesh.closed and "inside out" in mesh.note
    faces = ball.faces.copy()
    faces[3] = faces[3, ::-1]
    mesh = meshes.load(save("mixed.stl", trimesh.Trimesh(ball.vertices, faces, process=False).export(file_type="stl")))
    assert not mesh.closed and "disagree at 3 edges" in mesh.note


def test_open_degenerate_and_damaged_faces_are_said(save):
    mesh = meshes.load(save("a.obj", CORNERS + "v 0.5 0 0\nf 1 2 3 # a remark\nf 2 1 4\nf 1 1 2\nf 1 2\n"))
    assert len(mesh.triangles) == 1 and not mesh.closed
    assert "2 triangles without area left out" in mesh.note and "open: " in mesh.note
    assert "1 damaged face left out" in mesh.note


def test_corners_that_nearly_meet_are_one(save):
    corners = meshes.built_in("cube").triangles + np.random.default_rng(1).normal(0, 1e-9, (12, 3, 3))
    lines = [f"v {x:.12f} {y:.12f} {z:.12f}" for x, y, z in corners.reshape(-1, 3)]
    faces = [f"f {3 * i + 1} {3 * i + 2} {3 * i + 3}" for i in range(12)]
    assert meshes.load(save("gaps.obj", "\n".join(lines + faces))).closed


def test_polygons_and_counting_from_the_end(save):
    mesh = meshes.load(save("a.obj", "mtllib none.mtl\n" + CORNERS + "v 1 1 0\nusemtl x\nf 1 2 4 3\nf -1 -2 -3\n"))
    assert len(mesh.triangles) == 3


@pytest.mark.parametrize(("name", "content", "words"), [
    ("a.xyz", "1 2 3", "ends in '.xyz'; a mesh can be .stl, .obj, .ply, .glb"),
    ("a", "1 2 3", "has no ending"),
    ("a.gltf", "{}", "Export a .gltf as .glb"),
    ("a.stl", "", "is empty"),
    ("a.obj", " \n", "is empty"),
    ("a.stl", "hello", "not an STL file"),
    ("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n", "cut short"),
    ("a.stl", "solid a\nendsolid a\n", "no triangle in it"),
    ("a.stl", b"\0" * 80 + struct.pack("<I", 9) + b"\0" * 100, "promises 9 triangles and holds 2"),
    ("a.stl", b"\0" * 80 + struct.pack("<I", 1) + b"\0" * 50, "all its corners lie at one point"),
    ("a.stl", b"\0" * 80 + struct.pack("<I", 2_000_000), "not fit|cut short"),
    ("a.stl", np.random.default_rng(1).bytes(4000), "not an STL file"),
    ("a.obj", np.random.default_rng(1).bytes(4000), "not an OBJ file"),
    ("a.obj", CORNERS, "no triangle in it, only a set of points"),
    ("a.obj", CORNERS + "f 1 2 9\n", "line 4: the face uses corner 9, .* 1 to 3"),
    ("a.obj", CORNERS + "f 1 2 x\n", "line 4: 'x' should be the number of a corner"),
    ("a.obj", "v 0 0 0\nv 1 zero 0\nv 0 1 0\nf 1 2 3\n", "line 2: 'v 1 zero 0' should be 'v' and three numbers"),
    ("a.obj", "v nan 0 0\nv 1 inf 0\nv 0 1 0\nf 1 2 3\n", "2 of the 3 corners of its triangles are NaN or infinite"),
    ("a.obj", "v 0 0 0\nv 1e300 0 0\nv 0 1e300 0\nf 1 2 3\n", r"coordinates reach 1e\+300"),
    ("a.obj", "v 1 2 3\nv 1 2 3\nv 1 2 3\nf 1 2 3\n", r"all its corners lie at one point \(1, 2, 3\)"),
    ("a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "none of its 1 triangles has an area"),
    ("a.ply", "plz", "first line has to be 'ply'"),
    ("a.ply", "ply\nformat ascii 1.0\n", "no 'end_header'"),
    ("a.ply", PLY, "cut short|not a whole"),
    ("a.ply", PLY + "3 0 1 7\n", "1 of its 1 faces use a corner that does not exist"),
    ("a.ply", PLY.replace("element face 1", "element face 99999999999"), "has 99999999999 triangles; the limit"),
    ("a.ply", PLY.replace("ascii", "binary_little_endian"), "not a whole PLY file"),
    ("a.glb", "glTX" + "x" * 30, "has to begin with 'glTF'"),
    ("a.glb", b"glTF" + struct.pack("<IIII", 1, 20, 0, 0), "version 1"),
    ("a.glb", b"glTF" + struct.pack("<IIII", 2, 999, 0, 0), "cut short"),
    ("a.glb", b"glTF" + struct.pack("<III", 2, 24, 4) + b"JSON[1] ", "damaged"),
])
def test_bad_files(save, name, content, words):
    path = save(name, content)
    assert re.search(words, refused(path)), refused(path)


@pytest.mark.parametrize(("header", "words"), [
    (b'{"extensionsRequired": ["KHR_draco_mesh_compression"]}', "is compressed .*without compression"),
    (b'{"buffers": [{"uri": "a.bin", "byteLength": 3}]}', r"in another file \(a.bin\); export all of it as one .glb"),
    (b'{"accessors": [{"count": 9000000}]}', "has 3000000 triangles; the limit"),
    (b'{"accessors": [{}]}', "damaged"),
    (b'{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}]}',
     "whole|triangle"),
])
def test_glb_headers(save, header, words):
    header += b" " * (-len(header) % 4)
    path = save("a.glb", b"glTF" + struct.pack("<III", 2, 20 + len(header), len(header)) + b"JSON" + header)
    assert re.search(words, refused(path)), refused(path)


def test_no_file_a_folder_and_no_right(tmp_path, save, monkeypatch):
    assert "There is no file" in refused(tmp_path / "none.stl")
    assert "is a folder" in refused(tmp_path)
    path = save("a.stl", "x")

    def forbidden(_):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr("pathlib.Path.read_bytes", forbidden)
    assert "may not be read" in refused(path)


def test_too_large(save, monkeypatch):
    monkeypatch.setattr(mesh_files, "TRIANGLES", 10)
    for ending in ("stl", "stl_ascii", "obj", "ply", "glb"):
        path = save(f"a.{ending[:3]}", trimesh.creation.box().export(file_type=ending))
        assert "has 12 triangles; the limit is 10." in refused(path) and "Decimate" in refused(path)
    monkeypatch.setattr(mesh_files, "BYTES", 1)
    assert "the limit is" in refused(path)


@pytest.mark.parametrize("ending", ["stl", "stl_ascii", "obj", "ply", "glb"])
@settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(data=st.data())
def test_damage_anywhere_is_a_mesh_or_a_sentence(save, ending, data):
    content = bytearray(content if isinstance(content := trimesh.creation.box().export(file_type=ending), bytes)
                        else content.encode())
    cut = data.draw(st.integers(0, len(content)))
    scratch = data.draw(st.binary(max_size=12))
    at = data.draw(st.integers(0, len(content)))
    content[at:at + len(scratch)] = scratch
    path = save(f"a.{ending[:3]}", bytes(content[:cut] if data.draw(st.booleans()) else content))
    try:
        mesh = meshes.load(path)
    except Problem as problem:
        assert str(path) in str(problem) and "\n" not in str(problem)
    else:
        assert np.isfinite(mesh.triangles).all() and len(mesh.triangles)
        assert np.linalg.norm(mesh.triangles, axis=-1).max() == pytest.approx(1.0)


def test_nothing_is_printed_and_the_log_is_as_before(save, capfd):
    refused(save("a.obj", CORNERS + "f 1 2 9\n"))
    refused(save("a.ply", PLY.replace("ascii", "binary_little_endian")))
    assert capfd.readouterr() == ("", "")
    assert not logging.getLogger("trimesh").disabled
