"""A mesh whose faces are coloured by the solid angle they subtend at the eye."""

import numpy as np
import pyvista as pv

from app.lesson import Camera, Faces
from app.plots.dots import rimmed
from app.plots.look import Look
from app.plots.space import aim, fill, light, on_picture
from app.plots.ticks import nice, number
from app.plots.words import Entry, colour_bar, dot_size, labelled
from app.problem import Problem

DRAWN_EDGES = 4000  # more faces than this are drawn without their edges


class FacesPart:
    def __init__(self, plot: Faces, look: Look, triangles: np.ndarray | None):
        if triangles is None:
            raise Problem(f"the plot {plot.title!r} needs a mesh; its step has none.")
        self.plot, self.look = plot, look
        self.triangles = np.asarray(triangles, float)
        self.limit = 0.0
        self.strip: np.ndarray | None = None

    @property
    def entries(self) -> list[Entry]:
        return []  # the eye has its name in the picture, and the scale its words

    def footer(self) -> np.ndarray:
        if self.strip is None:
            most = number(float(f"{self.limit:.3g}")) if self.limit else "1"
            self.strip = colour_bar(self.look, self.look.diverging(), "sr of a face: − from outside, + from inside",
                                    (f"≤ −{most}", "0", f"≥ {most}"))
        return self.strip

    def build(self, plotter: pv.Plotter, values: dict) -> None:
        self.plotter = plotter
        light(plotter)
        count = len(self.triangles)
        corners, place = np.unique(self.triangles.reshape(-1, 3), axis=0, return_inverse=True)
        faces = np.column_stack([np.full(count, 3), place.reshape(-1, 3)])
        self.mesh = pv.PolyData(corners.astype(np.float32), faces.ravel())
        self.mesh.cell_data["angle"] = np.zeros(count, np.float32)
        table = pv.LookupTable()
        table.values = np.column_stack([self.look.diverging() * 255, np.full(256, 255)]).round().astype(np.uint8)
        self.actors = [  # far sides first, so that what is behind shines through what is before it
            plotter.add_mesh(self.mesh, scalars="angle", cmap=table, show_scalar_bar=False, opacity=opacity,
                             culling=side,  # type: ignore[arg-type]
                             ambient=0.8, diffuse=0.3, interpolation="Flat", show_edges=count <= DRAWN_EDGES,
                             edge_color=self.look.background, line_width=max(1.0, self.look.scale), edge_opacity=0.35,
                             copy_mesh=False)
            for side, opacity in (("front", 1.0), ("back", 0.72))]

    def update(self, values: dict, camera: Camera | None) -> list[str]:
        from app.optics.solid_angle_flat import solid_angle_triangle_signed

        self.eye = np.asarray(values["eye"], float)
        with np.errstate(all="ignore"):  # what is not finite is counted and shown
            angles = solid_angle_triangle_signed(*np.moveaxis(self.triangles - self.eye, 1, 0))
        good = np.isfinite(angles)
        fill(self.mesh.cell_data["angle"], np.where(good, angles, 0))
        self.rescale(np.abs(angles[good]))
        aim(self.plotter, camera or self.plot.camera)
        bad = int((~good).sum())
        return [f"{bad} {'face is' if bad == 1 else 'faces are'} not finite"] if bad else []

    def rescale(self, sizes: np.ndarray) -> None:
        """The scale's end: what 9 in 10 faces stay below; it keeps still until that is outgrown or far away."""
        most = float(np.percentile(sizes, 90)) if sizes.size else 0.0
        if most > 0 and not 0.3 * self.limit <= most <= self.limit:
            self.limit, self.strip = nice(most), None
        for actor in self.actors:
            actor.mapper.scalar_range = -(self.limit or 1.0), self.limit or 1.0

    def overlay(self, picture: np.ndarray) -> np.ndarray:
        """The eye is drawn over everything: inside a mesh it would be lost."""
        place, look = on_picture(self.plotter, self.eye[None]), self.look
        picture = picture.copy()
        rimmed(picture, place, 2.4 * dot_size(look), look.colour("v"), look.background, 2 * look.scale)
        x, y = place[0] + [dot_size(look) + 1.6 * look.text, 0]
        return labelled(look, picture, [(x, y, "eye", look.colour("v"))])
