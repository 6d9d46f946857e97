"""A model over the halfway vector's angle and the difference angle, in colours of powers of ten."""

import math
from typing import cast

import numpy as np
from PIL import Image, ImageDraw

from app.hemisphere import NORMAL, apart
from app.lesson import Camera, ImageSlice
from app.optics.spherical import direction
from app.plots.dots import rimmed
from app.plots.look import SLICE_DECADES, TICKS_D, TICKS_H, Look, bytes3
from app.plots.models import Legend, Lit, dot, lit, notices
from app.plots.ticks import number
from app.plots.words import Entry, colour_bar, font

CELLS = 160
STEADY = 0.8  # of theta_d: nearer to grazing a model may grow without end, which must not darken all else


class ImageSlicePart:
    def __init__(self, plot: ImageSlice, look: Look):
        self.plot, self.look = plot, look
        self.shown: list[Lit] = []
        self.legend: Legend | None = None
        self.top, self.kept = 1.0, cast(tuple, ())

    @property
    def entries(self) -> list[Entry]:
        return []

    def choose(self, values: dict) -> None:
        models = self.plot.models
        one = models[min(int(values.get("model", 0)), len(models) - 1)]
        self.shown = lit((one,), values, "v")[:1]

    def prepare(self, values: dict) -> None:
        self.choose(values)
        self.legend = Legend(self.look, self.shown)

    def footer(self) -> np.ndarray | None:
        if self.legend is None:
            return None
        unit = self.shown[0].unit
        ends = [number(self.top * 10.0**-k) for k in (SLICE_DECADES, SLICE_DECADES / 2, 0)]
        bar = colour_bar(self.look, self.look.sequential(), "θ_h right, θ_d up, φ_d = 90°",
                         (f"≤ {ends[0]}", ends[1], f"{ends[2]}{unit}"))
        return np.concatenate([bar, self.legend.strip(self.shown, "")[self.legend.high:]])

    def build(self, plotter, values: dict) -> None:
        pass

    def update(self, values: dict, camera: Camera | None) -> list[str]:
        self.choose(values)
        one = self.shown[0]
        key = *one.key[:3], one.key[-1]  # without the light
        if self.kept != key:  # the picture keeps still while light and eye move
            self.kept, self.f = key, image(one)
        most = np.nan_to_num(self.f[:round(STEADY * CELLS)], nan=0, posinf=0).max()
        self.top = 10.0 ** math.ceil(math.log10(most) - 1e-9) if 0 < most < 1e300 else 1.0
        h = one.still + one.picked
        length = np.linalg.norm(h)
        h = h / length if length > 1e-12 else NORMAL
        self.now = float(apart(h, NORMAL)), float(apart(one.still, h))
        blank = ["blank: no finite number"] if not np.isfinite(self.f).all() else []
        return blank + [words for words in notices(one, self.f) if "not finite" not in words]

    def overlay(self, picture: np.ndarray) -> np.ndarray:
        look, em, (high, wide) = self.look, self.look.small, picture.shape[:2]
        left, right, upper, lower = 2.8 * em, wide - 1.4 * em, 0.8 * em, high - 1.9 * em
        with np.errstate(divide="ignore"):
            share = 1 + np.log10(np.maximum(np.nan_to_num(self.f, nan=0, posinf=0), 1e-300) / self.top) / SLICE_DECADES
        colours = look.sequential()[np.clip(share * 255, 0, 255).astype(int)]
        size = max(2, round(right - left)), max(2, round(lower - upper))
        painted = Image.fromarray(np.round(255 * colours[::-1]).astype(np.uint8))
        painted = painted.resize(size, Image.Resampling.BILINEAR)
        there = Image.fromarray(np.where(np.isfinite(self.f[::-1]), 255, 0).astype(np.uint8))
        sheet = Image.fromarray(picture)
        sheet.paste(painted, (round(left), round(upper)), there.resize(size, Image.Resampling.NEAREST))
        draw, letters, ink = ImageDraw.Draw(sheet), font(look, look.small), bytes3(look.foreground)
        end = -math.inf
        for degrees in TICKS_H:
            x = left + (right - left) * math.sqrt(degrees / 90)
            wide_word = look.long(f"{degrees}°")
            if x - wide_word / 2 > end:
                draw.text((x, lower + 0.35 * em), f"{degrees}°", ink, letters, anchor="ma")
                end = x + wide_word / 2 + 0.4 * em
        for degrees in TICKS_D:
            y = lower - (lower - upper) * degrees / 90
            draw.text((left - 0.4 * em, y), f"{degrees}°", ink, letters, anchor="rm")
        picture = np.array(sheet)
        theta_h, theta_d = self.now
        place = np.array([[left + (right - left) * math.sqrt(min(1.0, theta_h / (0.5 * math.pi))),
                           lower - (lower - upper) * theta_d / (0.5 * math.pi)]])
        rimmed(picture, place, dot(look), self.shown[0].colour(look), look.background, 2 * look.scale)
        return picture


def image(one: Lit) -> np.ndarray:
    """Values (theta_d, theta_h), rows upwards; theta_h grows with the square of the column."""
    at = (np.arange(CELLS) + 0.5) / CELLS
    theta_h, theta_d = np.meshgrid(0.5 * np.pi * at**2, 0.5 * np.pi * at)
    h = direction(theta_h, 0.0)
    l = h * np.cos(theta_d)[..., None] + np.array([0.0, 1.0, 0.0]) * np.sin(theta_d)[..., None]
    v = l * (1, -1, 1)
    return one.pairs(l, v)
