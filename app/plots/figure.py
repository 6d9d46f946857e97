"""Sheets in space: a patch, its shadow on the unit sphere and on the base disk."""

from typing import Any

import numpy as np
import pyvista as pv

from app.lesson import Camera, Figure, Sheet
from app.plots.look import Look
from app.plots.shell import Dome, base_disk
from app.plots.space import aim, fill, grid_faces, grid_normals, light, on_picture, polyline
from app.plots.sweep import linear_frame, span
from app.plots.ticks import Axis, number
from app.plots.words import Entry, colour_bar, labelled
from app.terms import evaluate

LIFT = 0.004  # what lies on the sphere or the disk is drawn this much nearer to the viewer's side


class FigurePart:
    def __init__(self, plot: Figure, look: Look):
        self.plot, self.look = plot, look
        self.bar: Axis | None = None
        self.strip: np.ndarray | None = None
        self.coloured = next((sheet for sheet in plot.sheets if sheet.height), None)

    @property
    def entries(self) -> list[Entry]:
        return [Entry("area", self.look.colour(s.colour), s.label) for s in self.plot.sheets if not s.height]

    def footer(self) -> np.ndarray | None:
        if self.coloured is None:
            return None
        axis = self.bar or Axis(0.0, 1.0)
        if self.strip is None:
            ends = [number(float(f"{v:.3g}")) for v in (axis.low, (axis.low + axis.high) / 2, axis.high)]
            title = self.coloured.height_label or self.coloured.label
            self.strip = colour_bar(self.look, self.look.sequential(), title, (ends[0], ends[1], ends[2]))
        return self.strip

    def build(self, plotter: pv.Plotter, values: dict) -> None:
        self.plotter = plotter
        light(plotter)
        self.sheets = [SheetPart(sheet, self.look, plotter) for sheet in self.plot.sheets]
        shadows = any(sheet.onto for sheet in self.plot.sheets)
        self.rays = polyline(np.zeros((8, 2, 3))) if shadows else None
        if self.rays is not None:
            plotter.add_mesh(self.rays, color=self.look.quiet, line_width=max(1.0, self.look.line * 0.6),
                             lighting=False, opacity=0.8)
        if self.plot.disk:
            base_disk(plotter, self.look)
        self.dome = Dome(self.plot.dome, self.look, plotter) if self.plot.dome else None
        if shadows or self.plot.dome or self.plot.disk:
            origin = pv.Sphere(radius=0.028, theta_resolution=16, phi_resolution=12)
            plotter.add_mesh(origin, color=self.look.foreground, lighting=False)
        self.up = self.plot.dome == "hemisphere" or self.plot.disk
        if self.up:
            arrow = pv.Arrow(direction=(0, 0, 1), scale=1.3, tip_length=0.09, tip_radius=0.026, shaft_radius=0.009,
                             tip_resolution=24, shaft_resolution=16)
            plotter.add_mesh(arrow, color=self.look.colour("n"), ambient=0.6, diffuse=0.5)

    def update(self, values: dict, camera: Camera | None) -> list[str]:
        aim(self.plotter, camera or self.plot.camera)
        eye = np.asarray(self.plotter.camera.position)
        notices = [note for sheet in self.sheets for note in sheet.update(values, eye)]
        self.rescale()
        if self.rays is not None:
            self.rays.points = rays(self.plot.sheets, [s.points for s in self.sheets])
        if self.dome:
            self.dome.seen_from(eye)
        return notices

    def rescale(self) -> None:
        """One scale of colours for all sheets with a height; it keeps still until a value leaves it."""
        seen = np.concatenate([s.height[np.isfinite(s.height)].ravel() for s in self.sheets if s.height is not None]
                              or [np.zeros(0)])
        if not seen.size:
            return
        fresh, bar = linear_frame(seen), self.bar
        if bar is None or seen.min() < bar.low or seen.max() > bar.high or span(fresh) < 0.3 * span(bar):
            self.bar, self.strip = fresh, None
        for sheet in self.sheets:
            if sheet.height is not None:
                sheet.actor.mapper.scalar_range = (self.bar or fresh).ends

    def overlay(self, picture: np.ndarray) -> np.ndarray:
        if not self.up:
            return picture
        x, y = on_picture(self.plotter, np.array([[0.0, 0.0, 1.42]]))[0]
        return labelled(self.look, picture, [(x, y, "n", self.look.colour("n"))])


class SheetPart:
    def __init__(self, sheet: Sheet, look: Look, plotter: pv.Plotter):
        self.sheet, (rows, columns) = sheet, sheet.cells
        self.s, self.t = np.meshgrid(np.linspace(0, 1, rows + 1), np.linspace(0, 1, columns + 1), indexing="ij")
        self.faces = grid_faces(rows + 1, columns + 1)
        self.points = np.zeros((*self.s.shape, 3))
        self.height: np.ndarray | None = None
        self.mesh = pv.PolyData(np.zeros((self.s.size, 3), np.float32), self.faces.ravel())
        self.mesh.point_data["Normals"] = np.zeros((self.s.size, 3), np.float32)
        self.mesh.point_data.active_normals_name = "Normals"
        style: dict = {"color": look.colour(sheet.colour)}
        if sheet.height:
            self.mesh.point_data["height"] = np.zeros(self.s.size, np.float32)
            table = pv.LookupTable()
            table.values = np.column_stack([look.sequential() * 255, np.full(256, 255)]).round().astype(np.uint8)
            style = {"scalars": "height", "cmap": table, "show_scalar_bar": False}
        flat = sheet.onto == "disk"
        self.actor = plotter.add_mesh(self.mesh, **style, opacity=sheet.opacity, ambient=0.85 if flat else 0.42,
                                      diffuse=0.2 if flat else 0.62, specular=0.0, interpolation="Phong")
        # the edges are drawn a little nearer to the eye, or the sheet's own surface would tear them
        longest = max(rows, columns) + 1
        self.edges = polyline(np.zeros((4, longest, 3)))
        edge = look.mixed(look.colour(sheet.colour), look.foreground, 0.55)
        plotter.add_mesh(self.edges, color=edge, line_width=look.line, lighting=False)
        self.longest = longest

    def update(self, values: dict, eye: np.ndarray) -> list[str]:
        swept: dict[str, Any] = {"s": self.s, "t": self.t}
        with np.errstate(all="ignore"):  # what is not finite is counted and shown
            points = projected(evaluate(self.sheet.term, values, **swept), self.sheet.onto)
            self.points = np.array(np.broadcast_to(points, (*self.s.shape, 3)), float)
            if self.sheet.height:
                height = evaluate(self.sheet.height, values, **swept).astype(float)
                self.height = np.broadcast_to(height, self.s.shape)
        good = np.asarray(np.isfinite(self.points).all(-1))
        if self.height is not None:
            fill(self.mesh.point_data["height"], np.nan_to_num(self.height, posinf=0, neginf=0).ravel())
            good = np.asarray(good & np.isfinite(self.height))
        self.points[~good] = 0
        faces = self.faces[good.ravel()[self.faces[:, 1:]].all(-1)]
        if self.mesh.n_cells != len(faces) or not good.all():
            self.mesh.faces = faces.ravel()
        self.mesh.points = self.points.reshape(-1, 3).astype(np.float32)
        fill(self.mesh.point_data["Normals"], grid_normals(self.points).reshape(-1, 3))
        edges = border(self.points, good, self.longest)
        self.edges.points = edges + 0.01 * (eye - edges) / np.linalg.norm(eye - edges, axis=-1, keepdims=True)
        bad = int((~good).sum())
        return [f"“{self.sheet.label}”: {bad} {'point is' if bad == 1 else 'points are'} not finite"] if bad else []


def projected(points: np.ndarray, onto: str) -> np.ndarray:
    """Points as they are, or from the origin onto the unit sphere, or on down to the disk, cut at the horizon."""
    if not onto:
        return points
    on_sphere = points / np.linalg.norm(points, axis=-1, keepdims=True)
    if onto == "sphere":
        return on_sphere * (1 + LIFT)
    side = np.hypot(on_sphere[..., :1], on_sphere[..., 1:2])
    below = on_sphere[..., 2:] < 0
    flat = np.where(below, on_sphere[..., :2] / np.where(below, side, 1.0), on_sphere[..., :2])
    return np.concatenate([flat, np.full_like(flat[..., :1], LIFT)], -1)


def border(points: np.ndarray, good: np.ndarray, longest: int) -> np.ndarray:
    """The four sides of a grid as lines of equal length; a seam, where two sides meet, is no side."""
    sides = []
    for a, b, ok in ((points[0], points[-1], good[[0, -1]]), (points[:, 0], points[:, -1], good[:, [0, -1]])):
        seam = np.allclose(a, b, atol=1e-9) or not ok.all()
        for side in (a, b):
            along = np.linspace(0, 0 if seam else len(side) - 1, longest).round().astype(int)
            sides.append(side[along])
    return np.concatenate(sides).astype(np.float32)


def rays(sheets: tuple[Sheet, ...], points: list[np.ndarray]) -> np.ndarray:
    """From the origin through the corners of the plain sheet, and from its shadow on the sphere down to the disk."""
    by = {sheet.onto: p for sheet, p in zip(sheets, points, strict=True)}
    lines = np.zeros((8, 2, 3), np.float32)
    corners = {onto: p[[0, 0, -1, -1], [0, -1, -1, 0]] for onto, p in by.items()}
    ends = corners.get("", corners.get("sphere"))
    if ends is not None:
        lines[:4, 1] = ends
    if "sphere" in corners and "disk" in corners:
        lines[4:, 0], lines[4:, 1] = corners["sphere"], corners["disk"]
        lines[4:][corners["sphere"][:, 2] < 0] = 0
    return lines.reshape(-1, 3)
