"""A plot of a lesson as pixels, drawn by pyvista without a window. Imported in the plots' own process only."""

import os
import sys
from dataclasses import replace
from typing import Any

if sys.platform.startswith("linux"):  # beside a display VTK would take GLX, which ends a process that also uses EGL
    os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")
    os.environ.setdefault("ALLOW_PLOTTING", "true")  # or pyvista asks xset, which may take its time

import numpy as np
import pyvista as pv

from app.lesson import Camera, Curves, Faces, Figure, ImageSlice, Ledger, Lobes, Plot, Slice, Study
from app.plots.curves import CurvesPart
from app.plots.efforts import EffortsPart
from app.plots.faces import FacesPart
from app.plots.figure import FigurePart
from app.plots.image_slice import ImageSlicePart
from app.plots.ledger import LedgerPart
from app.plots.lobes import LobesPart
from app.plots.look import Look
from app.plots.slices import SlicePart
from app.plots.wire import Spot
from app.plots.words import header, line_of_words, noticed
from app.theme import Theme

SMALLEST = 120  # px; below this nothing can be read
ROOM = 11  # times the size of its text: below this a plot has no place between its words


class Drawing:
    """One plot at one size: the plotter and its actors stay, an update changes points and colours only."""

    def __init__(self, plot: Plot, size: tuple[int, int], theme: Theme, mesh_triangles: np.ndarray | None = None,
                 ranges: dict | None = None):
        least = max(SMALLEST, round(ROOM * Look(theme, (SMALLEST, SMALLEST)).text))
        self.size = max(least, int(size[0])), max(least, int(size[1]))
        self.plot, self.look = plot, Look(theme, self.size)
        self.part = part(plot, self.look, mesh_triangles, ranges or {})
        self.head = header(self.look, plot.title, self.part.entries)
        if isinstance(self.part, CurvesPart):
            self.head = np.concatenate([self.head, line_of_words(self.look, self.part.y_title)])
        self.head = self.head[:int(0.6 * self.size[1])]  # words that leave no room for the plot itself are cut
        self.plotter: pv.Plotter | None = None
        self.samples = -1

    def update(self, values: dict, camera: Camera | None = None, fine: bool = True) -> np.ndarray:
        """The picture (height, width, 3); `fine` smooths edges and costs about twice the time."""
        if self.plotter is None:
            self.open(values)
        plotter = self.plotter
        assert plotter is not None
        if isinstance(self.part, EffortsPart):
            self.part.measure(values, fine)
        notices = self.part.update(values, camera)
        self.smooth(fine)
        plotter.reset_camera_clipping_range()
        plotter.render()
        drawn = self.part.overlay(np.asarray(plotter.screenshot(return_img=True))[..., :3])
        foot = self.part.footer()
        picture = np.concatenate([self.head, drawn, *([foot] if foot is not None else [])])
        bottom = self.size[1] - (len(foot) if foot is not None else 0) - self.look.text
        if isinstance(self.plot, Curves | Slice | ImageSlice):  # a slice is blank, if at all, at its top
            bottom = len(self.head) + round((0.24 if isinstance(self.plot, ImageSlice) else 0.7) * len(drawn))
        return np.ascontiguousarray(noticed(self.look, picture, notices, bottom))

    @property
    def spots(self) -> tuple[Spot, ...]:
        """The points of the last picture that can be pointed at."""
        if not isinstance(self.part, EffortsPart):
            return ()
        return tuple(replace(spot, y=spot.y + len(self.head)) for spot in self.part.spots)

    def open(self, values: dict) -> None:
        if isinstance(self.part, LobesPart | SlicePart | ImageSlicePart):
            self.part.prepare(values)
        foot = self.part.footer()
        tall = self.size[1] - len(self.head) - (len(foot) if foot is not None else 0)
        self.plotter = pv.Plotter(off_screen=True, window_size=[self.size[0], tall], lighting="none")
        self.plotter.renderer.SetBackground(*self.look.background)
        self.part.build(self.plotter, values)
        self.plotter.show(auto_close=False, interactive=False)

    def smooth(self, fine: bool) -> None:
        lines = isinstance(self.plot, Curves)  # without it they are torn, and with it they cost little more
        samples = 8 if fine or lines else 0
        if samples != self.samples and self.plotter is not None and self.plotter.render_window is not None:
            self.plotter.render_window.SetMultiSamples(samples)
            self.samples = samples

    def close(self) -> None:
        if self.plotter is not None:
            self.plotter.close()
            self.plotter = None


def part(plot: Plot, look: Look, triangles: np.ndarray | None, ranges: dict) -> Any:
    if isinstance(plot, Curves):
        return CurvesPart(plot, look, ranges)
    if isinstance(plot, Faces):
        return FacesPart(plot, look, triangles)
    kinds: dict[type, Any] = {Figure: FigurePart, Ledger: LedgerPart, Lobes: LobesPart, Slice: SlicePart,
                              ImageSlice: ImageSlicePart, Study: EffortsPart}
    return kinds[type(plot)](plot, look)


def failed(plot: Plot, size: tuple[int, int], theme: Theme, words: str) -> np.ndarray:
    """The picture of a plot that could not be drawn: its title and the reason."""
    look = Look(theme, (max(SMALLEST, int(size[0])), max(SMALLEST, int(size[1]))))
    width, height = look.size
    picture = np.full((height, width, 3), np.round(255 * np.array(look.background)), np.uint8)
    head = header(look, plot.title, [])[:height]
    picture[:len(head)] = head
    return noticed(look, picture, ["This plot could not be drawn.", *words.splitlines()[:6]], round(0.7 * height))
