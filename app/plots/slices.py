"""Lobes cut by a plane: a half circle of rings, or the value against the angle. Written over an empty picture."""

import numpy as np
from PIL import Image, ImageDraw

from app.hemisphere import NORMAL
from app.lesson import Camera, Slice
from app.plots.dashes import dashed
from app.plots.dots import rimmed
from app.plots.look import Look, Rgb, bytes3
from app.plots.models import Legend, Lit, Scale, dot, lit, notices, unit_of
from app.plots.ticks import Axis
from app.plots.words import Entry, font, labelled

LINES = ("solid", "dashed", "dashdot", "dotted")
FINE = 3  # lines are drawn this much larger and reduced
IN_PLANE = np.sin(np.radians(0.5))


class SlicePart:
    def __init__(self, plot: Slice, look: Look):
        self.plot, self.look, self.scale = plot, look, Scale()
        self.shown: list[Lit] = []
        self.legend: Legend | None = None
        self.now: float | None = 0.0  # the picked direction's angle, if it is in the plane

    @property
    def entries(self) -> list[Entry]:
        return []

    def prepare(self, values: dict) -> None:
        self.shown = lit(self.plot.models, values, self.plot.over)
        self.legend = Legend(self.look, self.shown)

    def footer(self) -> np.ndarray | None:
        if self.legend is None:
            return None
        one = "eye" if self.plot.over == "v" else "light"
        note = f"angle of the {one}, mirror side > 0"
        if self.plot.kind == "polar":
            note = self.scale.words(unit_of(self.shown))
        if self.now is None:
            note = f"{note}; the {one} stands beside this plane"
        return self.legend.strip(self.shown, note, LINES)

    def build(self, plotter, values: dict) -> None:
        pass

    def update(self, values: dict, camera: Camera | None) -> list[str]:
        self.shown = lit(self.plot.models, values, self.plot.over)
        one = self.shown[0]
        side = one.still * (-1, -1, 0)
        if np.linalg.norm(side) < 1e-6:
            side = one.picked * (1, 1, 0)
        self.side = side / np.linalg.norm(side) if np.linalg.norm(side) > 1e-6 else np.array([1.0, 0, 0])
        self.lines = [self.line(one) for one in self.shown]
        self.scale.fit([f for _, f in self.lines], int(values.get("lobe_scale", 0)))
        self.still = self.angle(one.still)
        self.now = self.angle(one.picked)
        across = np.cross(NORMAL, self.side)
        found = [words for one, (_, f) in zip(self.shown, self.lines, strict=True) for words in notices(one, f)]
        if abs(one.picked @ across) > IN_PLANE:
            self.now = None
        return found

    def angle(self, d: np.ndarray) -> float:
        return float(np.arctan2(d @ self.side, d[2]))

    def line(self, one: Lit) -> tuple[np.ndarray, np.ndarray]:
        """Angles, dense at the peak, and the values there."""
        peak = self.angle(one.peak()[0])
        near = np.geomspace(1e-6, 1.0, 90)
        angle = np.concatenate([np.linspace(-np.pi / 2, np.pi / 2, 181), [peak], peak + near, peak - near])
        angle = np.unique(np.clip(angle, -np.pi / 2 + 1e-3, np.pi / 2 - 1e-3))
        return angle, one(self.side * np.sin(angle)[:, None] + NORMAL * np.cos(angle)[:, None])

    def overlay(self, picture: np.ndarray) -> np.ndarray:
        high, wide = picture.shape[:2]
        self.big = Image.fromarray(picture).resize((FINE * wide, FINE * high))
        self.pen = ImageDraw.Draw(self.big)
        words = self.polar(wide, high) if self.plot.kind == "polar" else self.graph(wide, high)
        for (angle, f), one, style in zip(self.lines, self.shown, LINES * len(self.shown), strict=False):
            self.stroke(self.at(angle, f), one.colour(self.look), 1.2 * self.look.line, style)
        picture = np.array(self.big.resize((wide, high), Image.Resampling.BOX))
        if self.now is not None:
            for one in self.shown:
                place = self.at(np.array([self.now]), np.array([one.number]))
                rimmed(picture, place, dot(self.look), one.colour(self.look), self.look.background, 2 * self.look.scale)
        return words(picture)

    def stroke(self, places: np.ndarray, colour: Rgb, width: float, style: str = "solid") -> None:
        at, ends = dashed(places, style, width)
        x, y = (np.interp(at, np.arange(len(places)), p) for p in places.T)
        for part in np.split(np.arange(len(at)), np.flatnonzero(ends) + 1):
            if len(part) > 1:
                line = [(FINE * a, FINE * b) for a, b in zip(x[part], y[part], strict=True)]
                self.pen.line(line, bytes3(colour), round(FINE * width), joint="curve")

    # --- a half circle -----------------------------------------------------------------------------------------------
    def polar(self, wide: int, high: int):
        look, em = self.look, self.look.small
        radius = min(0.5 * wide - 2.4 * em, high - 3.2 * em)
        x, y = 0.5 * wide, 0.5 * (high + radius) + 0.4 * em
        thin = max(1.0, look.line / 2)

        def place(angle, length):
            return np.column_stack([x + radius * length * np.sin(angle), y - radius * length * np.cos(angle)])

        self.at = lambda angle, f: place(angle, self.scale.length(f))
        arc = np.linspace(-np.pi / 2, np.pi / 2, 91)
        for ring in (0.25, 0.5, 0.75, 1.0):
            self.stroke(place(arc, ring), look.quiet if ring == 1 else look.grid, thin)
        letters = []
        for degrees in range(-90, 91, 30):
            angle = np.radians([degrees, degrees])
            self.stroke(place(angle, np.array([0.0, 1.0])), look.grid, thin)
            letters.append((place(angle[:1], 1 + 1.3 * em / radius)[0], f"{abs(degrees)}°"))
        self.stroke(place(np.array([-np.pi / 2, np.pi / 2]), np.ones(2)), look.quiet, thin)
        names = ("l", "v") if self.plot.over == "v" else ("v", "l")
        ends = {"n": 0.0, names[0]: self.still, "r": -self.still, names[1]: self.now}
        if self.now is not None and abs(self.now + self.still) < 0.1:
            del ends["r"]
        rays = []
        for name, end in ends.items():
            if end is not None:
                tip = place(np.full(2, end), np.array([0.0, 0.86]))
                self.stroke(tip, look.colour(name), 1.1 * look.line, "dotted" if name == "r" else "solid")
                rays.append((*place(np.array([end]), 0.93)[0], name, look.colour(name)))

        def words(picture: np.ndarray) -> np.ndarray:
            image = Image.fromarray(picture)
            draw = ImageDraw.Draw(image)
            for at, text in letters:
                draw.text(tuple(at), text, bytes3(look.quiet), font(look, look.small), anchor="mm")
            return labelled(look, np.array(image), rays)

        return words

    # --- against the angle -------------------------------------------------------------------------------------------
    def graph(self, wide: int, high: int):
        look, em, top = self.look, self.look.small, self.scale.top
        log, low = self.scale.log, top * 10.0 ** -self.scale.decades if self.scale.log else 0.0
        ticks, words_y = Axis(low, top, log).ticks(max(2, round(high / (3.2 * em))))
        left = 1.1 * em + max(look.long(word) for word in words_y)
        right, upper, lower = wide - 1.6 * em, 0.9 * em, high - 2.0 * em
        thin = max(1.0, look.line / 2)

        def place(angle, length):
            return np.column_stack([left + (right - left) * (np.asarray(angle) / np.pi + 0.5),
                                    lower - (lower - upper) * np.asarray(length)])

        self.at = lambda angle, f: place(angle, self.scale.length(f))
        degrees = range(-90, 91, 30 if wide > 21 * em else 45)
        flat = np.radians([-90, 90])
        for tick in ticks:
            share = 1 + (tick - np.log10(top)) / self.scale.decades if log else tick / top
            self.stroke(place(flat, np.full(2, share)), look.grid, thin)
        for d in degrees:
            self.stroke(place(np.radians([d, d]), np.array([0.0, 1.0])), look.grid, thin)
        self.stroke(place(flat, np.zeros(2)), look.quiet, thin)
        names = ("l", "v") if self.plot.over == "v" else ("v", "l")
        for name, angle in ((names[0], self.still), (names[1], self.now)):
            if angle is not None:
                self.stroke(place(np.full(2, angle), np.array([0.0, 1.0])), look.colour(name), look.line)

        def words(picture: np.ndarray) -> np.ndarray:
            image = Image.fromarray(picture)
            draw, letters = ImageDraw.Draw(image), font(look, look.small)
            for d in degrees:
                draw.text((place(np.radians([d]), 0.0)[0, 0], lower + 0.4 * em), f"{d}°".replace("-", "−"),
                          bytes3(look.foreground), letters, anchor="ma")
            for tick, word in zip(ticks, words_y, strict=True):
                share = 1 + (tick - np.log10(top)) / self.scale.decades if log else tick / top
                draw.text((left - 0.5 * em, place(0.0, share)[0, 1]), word, bytes3(look.foreground), letters,
                          anchor="rm")
            marks = [(place(angle, 0.93)[0, 0] + 0.8 * em, upper + 0.6 * em, name, look.colour(name))
                     for name, angle in ((names[0], self.still), (names[1], self.now)) if angle is not None]
            return labelled(look, np.array(image), marks)

        return words
