"""Curves as a picture: pyvista's Chart2D in the grammar of line and colour."""

import math

import numpy as np
import pyvista as pv
from PIL import Image, ImageDraw

from app.lesson import Camera, Curves
from app.plots.dashes import along, dashed
from app.plots.dots import rimmed, stamp
from app.plots.look import Look, bytes3
from app.plots.roles import colour_of, nothing_in, notices_of, samples, y_title
from app.plots.sweep import Sweep, widened
from app.plots.ticks import number
from app.plots.words import SHAPES, Entry, dot_size, font, line_of_words
from app.spoken import axis_title

NOT_FINITE = 1.0, 0.18, 0.82  # magenta, as in the scene


class CurvesPart:
    def __init__(self, plot: Curves, look: Look, ranges: dict):
        self.plot, self.look = plot, look
        self.sweep = Sweep(plot, ranges)
        self.x_ticks: tuple[list[float], list[str]] = ([], [])
        self.y_ticks: tuple[list[float], list[str]] = ([], [])
        self.samples = samples(plot, self.sweep.exact if plot.error else None)
        self.y_title = y_title(plot, self.sweep)

    @property
    def entries(self) -> list[Entry]:
        return [Entry(sample, colour_of(curve, self.look), curve.label)
                for curve, sample in zip(self.plot.curves, self.samples, strict=True) if sample]

    def footer(self) -> np.ndarray:
        return line_of_words(self.look, axis_title(self.plot.sweep), "middle")

    def build(self, plotter: pv.Plotter, values: dict) -> None:
        look, self.size = self.look, tuple(plotter.window_size)
        self.chart = chart = pv.Chart2D(size=(1, 1), loc=(0, 0), grid=True)
        chart.background_color = self.look.background
        chart.border_color, chart.legend_visible = look.background, False
        self.drawn = self.sweep.run(values)
        self.line_now = chart.line([0, 0], [0, 0], color=(*look.quiet, 0.8), width=max(1.0, look.line / 2))
        self.drawn_as = [s for s in self.samples if s]
        self.colours = [colour_of(s.curve, look) for s in self.drawn]
        self.lines = [chart.line([0, 1], [0, 0], color=colour, width=look.line) if sample not in SHAPES else None
                      for sample, colour in zip(self.drawn_as, self.colours, strict=True)]
        for axis in (chart.x_axis, chart.y_axis):
            self.style(axis)
        chart.x_label = chart.y_label = ""
        chart.SetLayoutStrategy(chart.AXES_TO_RECT)  # the frame is placed by us, and stays where it is
        low, high = widened(self.sweep.axis, 0.03)
        chart.x_range = [low, high]
        self.x_ticks = self.sweep.axis.ticks(max(2, round(self.size[0] / (4.6 * look.small))))
        set_ticks(chart.x_axis, *self.x_ticks)
        plotter.add_chart(chart)

    def style(self, axis) -> None:
        look = self.look
        axis.tick_labels_visible = False  # VTK's words leave their shadows at some sizes; we write them
        axis.pen.color, axis.pen.width = look.quiet, max(1.0, look.line / 2)
        axis.GetGridPen().SetColorF(*look.grid)
        axis.GetGridPen().SetWidth(max(1.0, look.line / 2))

    def place(self, widest: float) -> None:
        """The frame: as large as the labels of its ticks leave room for."""
        (width, height), em = self.size, self.look.small
        left, right, top, bottom = widest + 1.1 * em, 1.4 * em, 0.6 * em, 2.0 * em
        self.corner = round(left), round(bottom)
        self.extent = max(20, round(width - left - right)), max(20, round(height - top - bottom))
        self.chart.loc = self.corner[0] / width, self.corner[1] / height
        self.chart.size = self.extent[0] / width, self.extent[1] / height

    def update(self, values: dict, camera: Camera | None) -> list[str]:
        self.drawn = self.sweep.run(values)
        axis = self.axis = self.sweep.framed(self.drawn)
        self.ends = widened(axis, 0.03)
        self.chart.y_range = list(self.ends)
        self.y_ticks = positions, labels = axis.ticks(max(2, round(self.size[1] / (3.2 * self.look.small))))
        set_ticks(self.chart.y_axis, positions, labels)
        self.place(max((self.look.long(label) for label in labels), default=0.0))
        self.x, self.y = self.sweep.axis.place(self.shown(self.sweep.x)), [axis.place(s.y) for s in self.drawn]
        for line, sample, y in zip(self.lines, self.drawn_as, self.y, strict=True):
            if line is not None and np.isfinite(y).any():
                at, ends = dashed(self.pixels(self.x, y), sample, self.look.line)
                line.update(along(self.x, at, ends), along(y, at, ends))  # VTK leaves a gap where a line is NaN
            if line is not None:
                line.visible = bool(np.isfinite(y).any())
        notices = [*nothing_in(self.drawn), *(words for curve in self.drawn for words in notices_of(curve))]
        low, high = self.sweep.axis.ends
        slack = 1e-9 * (high - low)
        now = float(self.sweep.axis.place(self.shown(values[self.plot.sweep])))
        self.now = now if low - slack <= now <= high + slack else math.nan
        self.line_now.visible = math.isfinite(self.now)
        if self.line_now.visible:
            self.line_now.update([now, now], self.ends)
        else:
            what = number(float(f"{float(self.shown(values[self.plot.sweep])):.4g}"))
            notices.append(f"{axis_title(self.plot.sweep).split(' in ')[0]} = {what} lies outside this plot")
        return notices

    def overlay(self, picture: np.ndarray) -> np.ndarray:
        """Dots of the estimates, crosses where a curve is not finite, and a large dot at the present value."""
        picture, look, across = self.with_ticks(picture), self.look, dot_size(self.look)
        for sample, colour, y in zip(self.drawn_as, self.colours, self.y, strict=True):
            if sample in SHAPES:
                places = self.pixels(self.x, y)
                if not self.plot.error:  # errors are noise: all of them are drawn, and smaller
                    places = spaced(places, 1.8 * across)
                stamp(picture, places, across * (0.75 if self.plot.error else 1.0), colour, sample)
        bad = np.any([s.not_finite for s in self.drawn], axis=0)
        if bad.any():
            foot = spaced(self.pixels(self.x[bad], np.full(bad.sum(), self.axis.ends[0])), across)
            stamp(picture, foot, 1.6 * across, NOT_FINITE, "cross")
        for curve, colour in zip(self.drawn, self.colours, strict=True):
            place = self.pixels(np.array([self.now]), self.axis.place([curve.now]))
            rimmed(picture, place, 2.0 * across, colour, look.background, 1.5 * look.scale)
        return picture

    def with_ticks(self, picture: np.ndarray) -> np.ndarray:
        """The picture with the words at the ticks of both axes."""
        image, look, below = Image.fromarray(picture), self.look, self.size[1] - self.corner[1] + 0.45 * self.look.small
        draw, ink, letters = ImageDraw.Draw(image), bytes3(look.foreground), font(look, look.small)
        (x, x_words), (y, y_words) = self.x_ticks, self.y_ticks
        for (at, _), word in zip(self.pixels(np.array(x), np.full(len(x), self.ends[0])), x_words, strict=True):
            draw.text((at, below), word, ink, letters, anchor="ma")
        for (_, at), word in zip(self.pixels(np.zeros(len(y)), np.array(y)), y_words, strict=True):
            draw.text((self.corner[0] - 0.5 * look.small, at), word, ink, letters, anchor="rm")
        return np.array(image)

    def pixels(self, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        """Points of the chart in the picture, px from its top left."""
        low, high = widened(self.sweep.axis, 0.03)
        across, up = (x - low) / (high - low), (y - self.ends[0]) / (self.ends[1] - self.ends[0])
        return np.column_stack([self.corner[0] + across * self.extent[0],
                                self.size[1] - self.corner[1] - up * self.extent[1]])

    def shown(self, values):
        return np.degrees(values) if self.sweep.q.is_angle else np.asarray(values, float)


def spaced(places: np.ndarray, apart: float) -> np.ndarray:
    """Those of the places (n, 2) that are far enough from the one before, so that dots stay dots."""
    kept: list[np.ndarray] = []
    for place in places[np.isfinite(places).all(-1)]:
        if not kept or np.hypot(*(place - kept[-1])) >= apart:
            kept.append(place)
    return np.reshape(kept, (-1, 2))


def set_ticks(axis, positions: list[float], labels: list[str]) -> None:
    axis.tick_locations = positions
    axis.tick_labels = labels
