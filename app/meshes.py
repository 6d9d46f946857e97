"""Meshes: the four that every lesson can ask for, and the one a student brings. The only trimesh, and only in `load`.

A mesh is its triangles, counter-clockwise seen from outside; nothing here reaches farther than 1.3 from the origin.
"""

import logging
import re
import warnings
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import cache
from io import BytesIO
from pathlib import Path

import numpy as np

from app import mesh_files, shapes
from app.mesh_edges import is_closed, shared_corners, winding
from app.problem import Problem, Usage, near

BUILT_IN = {
    "sphere": (lambda: shapes.icosphere(4), "an icosahedron split four times, on the unit sphere"),
    "knot": (shapes.trefoil, "a tube along a trefoil knot"),
    "bowl": (shapes.bowl, "the unit sphere without a cap of half angle 50 degrees, open towards +z"),
    "cube": (lambda: shapes.cube(1.5), "a cube of side 1.5"),
}
FARTHEST = 1e30  # larger coordinates are damage: in nanometres this is more than the width of the universe
SAME = 1e-6  # corners nearer than this (radius 1) may be one corner when an edge looks open


@dataclass(frozen=True, eq=False)
class Mesh:
    name: str
    triangles: np.ndarray  # (F, 3, 3) float64, read only
    closed: bool  # each edge is run through as often one way as the other: 4 pi from inside, 0 from outside
    note: str  # what a person should know about it, in words
    texture_coordinates: np.ndarray | None = None  # (F, 3, 3): s, t and 1 of each corner; None: the file has none

    @property
    def data(self) -> dict[str, np.ndarray]:
        """What values carry of it."""
        own = self.texture_coordinates
        return {"triangles": self.triangles} | ({} if own is None else {"texture_coordinates": own})


@cache
def built_in(name: str) -> Mesh:
    """One of BUILT_IN, made with numpy alone."""
    if name not in BUILT_IN:
        raise Usage(f"There is no mesh {name!r}; there are {', '.join(BUILT_IN)}.{near(name, BUILT_IN)}")
    make, words = BUILT_IN[name]
    vertices, faces = make()
    return Mesh(name, frozen(vertices[faces]), is_closed(faces), f"{words}; {len(faces)} triangles")


def load(path: str | Path) -> Mesh:
    """A mesh of the user (STL, OBJ, PLY, GLB), moved and scaled to fit radius 1; else a Problem in one sentence."""
    path = Path(path)
    kind, data = mesh_files.read(path)
    try:
        with hushed():
            parts, left_out = parse(path, data, kind)
    except Problem:
        raise
    except Exception as error:  # whatever a damaged file does to the parser
        mesh_files.explain(path, kind, data)
        raise Problem(f"{path}: this is not a whole {kind.upper()} file ({mesh_files.plain(error)}); "
                      "export the mesh again, or open it in Blender or MeshLab to see what is left of it.") from None
    for vertices, faces, _ in parts:
        wrong = int(((faces < 0) | (faces >= len(vertices))).any(axis=1).sum())
        if wrong:
            mesh_files.explain(path, kind, data)
            raise Problem(f"{path}: {wrong} of its {len(faces)} faces use a corner that does not exist "
                          f"(there are {len(vertices)}); export the mesh again.")
    missing = mesh_files.promised(kind, data) - sum(len(faces) for _, faces, _ in parts)
    if missing > 0:
        left_out.append(f"{missing} damaged face{'s' if missing > 1 else ''}")
    triangles = np.concatenate([np.zeros((0, 3, 3)), *(vertices[faces] for vertices, faces, _ in parts)])
    flat = [np.pad(uv[faces], ((0, 0), (0, 0), (0, 1)), constant_values=1) for _, faces, uv in parts if uv is not None]
    whole = len(flat) == len(parts) and np.isfinite(np.concatenate([np.zeros((0, 3, 3)), *flat])).all()
    return tidy(path, triangles, kind, left_out, np.concatenate(flat) if flat and whole else None)


@contextmanager
def hushed() -> Iterator[None]:
    """trimesh and numpy say nothing; numbers that numpy cannot read are an error instead of a shorter array."""
    log = logging.getLogger("trimesh")
    before = log.disabled
    log.disabled = True
    try:
        with warnings.catch_warnings(), np.errstate(all="ignore"):
            warnings.simplefilter("ignore")
            warnings.filterwarnings("error", message="string or file could not be read")
            yield
    finally:
        log.disabled = before


Parts = list[tuple[np.ndarray, np.ndarray, np.ndarray | None]]  # vertices (V, 3), faces (F, 3), coordinates (V, 2)


def parse(path: Path, data: bytes, kind: str) -> tuple[Parts, list[str]]:
    """(vertices, faces) of every part where the scene puts it, and what is no mesh. Nothing but `data` is read."""
    import trimesh

    if kind == "obj":
        data = re.sub(rb"#[^\n]*", b"", data)  # trimesh stumbles over a remark behind a corner
    scene = trimesh.load_scene(BytesIO(data), file_type=kind, process=False, skip_materials=True)
    if kind == "glb" and b"TEXCOORD_0" in data:  # trimesh drops them with the materials
        with suppress(Exception):  # whatever a picture in the file does to its reader
            scene = trimesh.load_scene(BytesIO(data), file_type=kind, process=False)
    parts, left_out = [], []
    for node in scene.graph.nodes_geometry:
        place, name = scene.graph[node]
        shape = scene.geometry[name]
        if isinstance(shape, trimesh.Trimesh):
            vertices = np.asarray(shape.vertices, dtype=np.float64)
            faces = np.asarray(shape.faces, dtype=np.int64).reshape(-1, 3)
            if vertices.ndim != 2 or vertices.shape[1] != 3:
                raise ValueError("its corners are not three numbers each")
            if not np.array_equal(place, np.eye(4)):
                vertices = vertices @ place[:3, :3].T + place[:3, 3]
            uv = getattr(shape.visual, "uv", None)
            uv = None if uv is None or np.shape(uv) != (len(vertices), 2) else np.asarray(uv, float)
            parts.append((vertices, faces[:, ::-1] if np.linalg.det(place[:3, :3]) < 0 else faces, uv))
            mesh_files.limit(path, sum(len(faces) for _, faces, _ in parts))
        else:
            left_out.append("a set of points" if isinstance(shape, trimesh.PointCloud) else "a set of lines")
    return parts, left_out


def tidy(path: Path, triangles: np.ndarray, kind: str, left_out: list[str], uv: np.ndarray | None = None) -> Mesh:
    """Check the numbers, fit the mesh to radius 1, and say in words what was done to it."""
    if not len(triangles):
        only = f", only {' and '.join(dict.fromkeys(left_out))}" if left_out else ""
        raise Problem(f"{path}: there is no triangle in it{only}; export a surface made of faces.")
    bad = int((~np.isfinite(triangles)).any(axis=2).sum())
    if bad:
        raise Problem(f"{path}: {bad} of the {3 * len(triangles)} corners of its triangles are NaN or infinite; "
                      "remove them (in MeshLab: Filters, Cleaning and Repairing) and export again.")
    reach = float(np.abs(triangles).max())
    if reach > FARTHEST:
        raise Problem(f"{path}: its coordinates reach {reach:.0e}, which no unit of length explains (the limit is "
                      f"{FARTHEST:.0e}); scale the mesh down, or export it again if it is damaged.")
    notes = [counted(len(triangles), "triangle"), *(f"{what} left out" for what in dict.fromkeys(left_out))]
    if kind == "glb":  # +y is up in glTF, +z here
        triangles = triangles[..., [0, 2, 1]] * [1.0, -1.0, 1.0]
        notes.append("turned so that its +y is our +z")
    low, high = triangles.min(axis=(0, 1)), triangles.max(axis=(0, 1))
    triangles = triangles - (low + high) / 2
    radius = float(np.linalg.norm(triangles, axis=-1).max())
    if radius <= max(1e-12 * reach, 1e-150):
        raise Problem(f"{path}: all its corners lie at one point ({', '.join(f'{x:g}' for x in low)}); "
                      "a mesh needs an extent, so check the unit and the scale of the export.")
    triangles /= radius
    notes.append(f"centred and scaled by {1 / radius:.3g}")
    faces = shared_corners(triangles)
    if not is_closed(faces):
        rounded = shared_corners(np.round(triangles / SAME))
        faces = rounded if is_closed(rounded) else faces
    closed = is_closed(faces)
    notes.append(winding(faces))
    doubled = np.linalg.norm(np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]), axis=1)
    flat = doubled <= 1e-15
    if flat.all():
        raise Problem(f"{path}: none of its {len(flat)} triangles has an area; export a surface made of faces.")
    if flat.any():
        notes.append(f"{counted(int(flat.sum()), 'triangle')} without area left out")
        triangles, uv = triangles[~flat], None if uv is None else uv[~flat]
    if closed and np.einsum("fi,fi", triangles[:, 0], np.cross(triangles[:, 1], triangles[:, 2])) < 0:
        triangles, uv = triangles[:, ::-1], None if uv is None else uv[:, ::-1]
        notes.append("it was inside out and has been turned")
    notes.append("no texture coordinates: maps are laid on from the six sides of a cube" if uv is None else
                 "with texture coordinates")
    return Mesh(path.name, frozen(triangles), closed, "; ".join(notes), None if uv is None else frozen(uv))


def counted(count: int, what: str) -> str:
    return f"{count} {what}{'s' * (count != 1)}"


def frozen(triangles: np.ndarray) -> np.ndarray:
    triangles = np.ascontiguousarray(triangles, dtype=np.float64)
    triangles.flags.writeable = False
    return triangles
