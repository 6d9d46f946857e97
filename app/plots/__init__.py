"""Plots by pyvista, in a process of their own. Importing this loads neither pyvista nor VTK, and nor does drawing."""

import atexit
from functools import cache

import numpy as np

from app.lesson import Camera, Plot
from app.plots.process import Picture, PlotDied, PlotProcess
from app.problem import Problem
from app.theme import Theme

__all__ = ["Picture", "PlotDied", "PlotProcess", "picture"]
PATIENCE = 120.0  # s; a mesh of a million faces on a slow machine takes a few


def picture(plot: Plot, values: dict, size: tuple[int, int], theme: Theme, ranges: dict | None = None,
            camera: Camera | None = None, triangles: np.ndarray | None = None, steady: bool = False) -> np.ndarray:
    """One picture (height, width, 3) for a still or an animation; waits for it. The process is kept for the next.

    A still's axes and scale of colours follow its own values only. `steady` is for an animation: they keep still from
    one picture to the next, as in the window.
    """
    process = kept()
    process.request(plot, values, ranges, camera, size, theme, triangles, fresh=not steady)
    found = process.wait(PATIENCE)
    if found is None:
        raise Problem(f"the plot {plot.title!r} was not drawn within {PATIENCE:.0f} s.")
    if found.error:
        raise Problem(f"the plot {plot.title!r} could not be drawn: {found.error}")
    return found.image


@cache
def kept() -> PlotProcess:
    process = PlotProcess()
    atexit.register(process.close)
    return process
