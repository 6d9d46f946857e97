"""Lobes of models over the base disk, overlaid, each on a grid that is dense at its own peak."""

import numpy as np
import pyvista as pv

from app.lesson import Camera, Lobes
from app.plots.dots import rimmed
from app.plots.look import REACH, Look
from app.plots.models import Legend, Lit, Scale, dot, lit, notices, unit_of
from app.plots.shell import base_disk
from app.plots.space import aim, fill, grid_faces, grid_normals, light, on_picture, polyline
from app.plots.words import Entry, labelled

ROWS, COLUMNS = 64, 128


class LobesPart:
    def __init__(self, plot: Lobes, look: Look):
        self.plot, self.look = plot, look
        self.scale = Scale()
        self.shown: list[Lit] = []
        self.kept: list = []
        self.legend: Legend | None = None

    @property
    def entries(self) -> list[Entry]:
        return []  # the legend has their numbers, and so stands below

    def footer(self) -> np.ndarray | None:
        if self.legend is None:
            return None
        return self.legend.strip(self.shown, self.scale.words(unit_of(self.shown)))

    def prepare(self, values: dict) -> None:
        self.shown = lit(self.plot.models, values, self.plot.over)
        self.legend = Legend(self.look, self.shown)

    def build(self, plotter: pv.Plotter, values: dict) -> None:
        self.plotter, look = plotter, self.look
        light(plotter)
        base_disk(plotter, look)
        around = np.linspace(0, 2 * np.pi, 97)
        rings = np.stack([np.stack([r * np.cos(around), r * np.sin(around), 0 * around], -1)
                          for r in (0.25, 0.5, 0.75)])
        plotter.add_mesh(polyline(rings), color=look.quiet, line_width=max(1.0, look.line / 2), lighting=False,
                         opacity=0.5)
        self.arcs = polyline(np.zeros((4, 65, 3)))  # in the plane of incidence
        plotter.add_mesh(self.arcs, color=look.quiet, line_width=max(1.0, look.line / 2), lighting=False, opacity=0.45)
        self.faces = grid_faces(ROWS + 1, COLUMNS + 1)
        self.parts = [self.lobe(one) for one in self.shown]
        self.arrows = {}
        for name in ("n", "l", "r", "v"):
            arrow = polyline(np.zeros((1, 2, 3)) if name != "r" else np.zeros((13, 2, 3)))
            plotter.add_mesh(arrow, color=look.colour(name), line_width=1.4 * look.line, lighting=False)
            self.arrows[name] = arrow

    def lobe(self, one: Lit) -> tuple[pv.PolyData, pv.PolyData]:
        look, colour = self.look, one.colour(self.look)
        count = (ROWS + 1) * (COLUMNS + 1)
        mesh = pv.PolyData(np.zeros((count, 3), np.float32), self.faces.ravel())
        mesh.point_data["Normals"] = np.zeros((count, 3), np.float32)
        mesh.point_data.active_normals_name = "Normals"
        opacity = 0.92 if len(self.shown) == 1 else 0.42
        self.plotter.add_mesh(mesh, color=colour, opacity=opacity, ambient=0.38, diffuse=0.62, specular=0.0,
                              interpolation="Phong")
        outline = polyline(np.zeros((1, 2 * COLUMNS, 3)))
        ink = look.mixed(colour, look.foreground, 0.25)
        self.plotter.add_mesh(outline, color=ink, line_width=1.2 * look.line, lighting=False)
        return mesh, outline

    def update(self, values: dict, camera: Camera | None) -> list[str]:
        self.shown = lit(self.plot.models, values, self.plot.over)
        kept = self.kept if len(self.kept) == len(self.shown) else [(None, None, None)] * len(self.shown)
        self.kept = []
        for one, before in zip(self.shown, kept, strict=True):
            key = one.key
            self.kept.append(before if before[0] == key else (key, *one.lobe(ROWS, COLUMNS)))
        self.scale.fit([f for _, _, f in self.kept], int(values.get("lobe_scale", 0)))
        for (mesh, outline), (_, d, f) in zip(self.parts, self.kept, strict=True):
            self.place(mesh, outline, d, f)
        self.point()
        aim(self.plotter, camera or self.plot.camera)
        return [words for one, (_, _, f) in zip(self.shown, self.kept, strict=True) for words in notices(one, f)]

    def place(self, mesh: pv.PolyData, outline: pv.PolyData, d: np.ndarray, f: np.ndarray) -> None:
        points = d * self.scale.length(f)[..., None]
        mesh.points = points.reshape(-1, 3).astype(np.float32)
        normals = grid_normals(points)
        normals *= np.where(np.sum(normals * d, -1, keepdims=True) < 0, -1, 1)
        fill(mesh.point_data["Normals"], normals.reshape(-1, 3))
        outline.points = profile(d, points).astype(np.float32)

    def point(self) -> None:
        """Arrows, and the arcs of the plane they lie in."""
        one = self.shown[0]
        still, picked = one.still, one.picked
        l, v = (still, picked) if self.plot.over == "v" else (picked, still)
        ends = {"n": np.array([0, 0, 1.0]), "l": l, "v": v}
        for name, d in ends.items():
            self.arrows[name].points = np.stack([0 * d, REACH * d]).astype(np.float32)
        steps = np.linspace(0, REACH, 26)[:, None] * (still * (-1, -1, 1))
        self.arrows["r"].points = steps.astype(np.float32)
        self.ends = {**ends, "r": still * (-1, -1, 1)}
        side = still * (1, 1, 0)
        side = side / np.linalg.norm(side) if np.linalg.norm(side) > 1e-6 else np.array([1.0, 0, 0])
        angle = np.linspace(-np.pi / 2, np.pi / 2, 65)[:, None]
        arc = side * np.sin(angle) + np.array([0, 0, 1.0]) * np.cos(angle)
        self.arcs.points = np.concatenate([r * arc for r in (0.25, 0.5, 0.75, 1.0)]).astype(np.float32)

    def overlay(self, picture: np.ndarray) -> np.ndarray:
        """The picked direction on each lobe, and the letters of the arrows."""
        look, picture = self.look, picture.copy()
        for one in self.shown:
            place = on_picture(self.plotter, (self.scale.length(one.number) * one.picked)[None])
            rimmed(picture, place, dot(look), one.colour(look), look.background, 2 * look.scale)
        where = on_picture(self.plotter, np.array([(REACH + 0.1) * d for d in self.ends.values()]))
        same = np.linalg.norm(self.ends["r"] - self.ends["v" if self.plot.over == "v" else "l"]) < 0.12
        return labelled(look, picture, [(x, y, name, look.colour(name)) for (x, y), name
                                        in zip(where, self.ends, strict=True) if not (name == "r" and same)])


def profile(d: np.ndarray, points: np.ndarray) -> np.ndarray:
    """The outline of a lobe: the two lines from its peak along which most of it is seen from the side."""
    half = COLUMNS // 2
    first = int(np.argmax(np.abs(d[ROWS // 2, :half, 0])))
    line = np.concatenate([points[::-1, first], points[1:, first + half]])
    at = np.linspace(0, len(line) - 1, 2 * COLUMNS).round().astype(int)
    return line[at]
