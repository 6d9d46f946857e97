"""The sizes, colours and font of a plot: a theme at a picture's size."""

from dataclasses import dataclass

import numpy as np

from app.fonts import font_files
from app.theme import Theme, colour, rgb

REFERENCE = 420  # px of a plot's shorter side in a window of 1280x720, for which a theme's sizes are meant
SAME = 0.85  # of a size of the window's font: there the small letters are as high
DIVERGING = {"dark": "#3A414C", "light": "#DEDED8", "projector": "#E4E4E4"}  # where a diverging map is 0
REACH = 1.22  # how long a lobe plot's arrows are; a lobe's longest is 1
SLICE_DECADES = 4  # of an image slice, from its darkest to its brightest
TICKS_H = (0, 2, 5, 10, 20, 30, 45, 60, 90)  # degrees, of an image slice; small angles take more room
TICKS_D = (0, 30, 60, 90)

Rgb = tuple[float, float, float]


@dataclass(frozen=True)
class Look:
    theme: Theme
    size: tuple[int, int]

    @property
    def scale(self) -> float:
        """A larger plot is the same plot enlarged; a smaller one keeps its text readable."""
        return max(1.0, min(self.size) / REFERENCE)

    @property
    def letters(self) -> float:
        """px of the theme's text in the font of plots, whose letters are larger than those of the window's."""
        return max(16.0, SAME * self.theme.text)

    @property
    def text(self) -> int:
        return round(self.letters * self.scale)

    @property
    def small(self) -> int:
        """Tick labels and notices."""
        return round(max(14.0, 0.88 * self.letters) * self.scale)

    @property
    def line(self) -> float:
        return self.theme.line * self.scale

    @property
    def background(self) -> Rgb:
        return rgb(self.theme.background)

    @property
    def foreground(self) -> Rgb:
        return rgb(self.theme.foreground)

    @property
    def quiet(self) -> Rgb:
        return rgb(self.theme.quiet)

    @property
    def grid(self) -> Rgb:
        """Grid lines: a fifth of the way from the background to the quiet colour."""
        return self.mixed(self.background, self.quiet, 0.28)

    def colour(self, name: str) -> Rgb:
        return colour(name, self.theme)

    @staticmethod
    def mixed(a: Rgb, b: Rgb, share: float) -> Rgb:
        return tuple(x + (y - x) * share for x, y in zip(a, b, strict=True))  # type: ignore[return-value]

    @property
    def font(self) -> str:
        """The file of the one font of pictures and plots; "" leaves VTK its own."""
        files = font_files()
        return str(files[0]) if files else ""

    def long(self, text: str) -> float:
        """px that a tick's label takes."""
        from app.plots.words import font

        return font(self, self.small).getlength(text)

    def sequential(self) -> np.ndarray:
        """(256, 3) colours from low to high, 0 to 1."""
        from app.colormaps import STOPS

        return between(np.array(STOPS[self.theme.colormap]))

    def diverging(self) -> np.ndarray:
        """(256, 3) colours from minus (blue) over 0 to plus (orange)."""
        return between(np.array([self.colour("n"), rgb(DIVERGING[self.theme.name]), self.colour("l")]))


def between(stops: np.ndarray) -> np.ndarray:
    at = np.linspace(0, len(stops) - 1, 256)
    return np.stack([np.interp(at, np.arange(len(stops)), channel) for channel in stops.T], -1)


def bytes3(colour: Rgb) -> tuple[int, int, int]:
    return tuple(round(255 * c) for c in colour)  # type: ignore[return-value]
