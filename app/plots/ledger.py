"""The unit ledger as a picture: quantities below each other, the factor between them, and the balance as a bar."""

import numpy as np
from PIL import Image, ImageDraw

from app.ledger import Balance, Line, balance, factor_words, lines, pretty
from app.lesson import Camera, Ledger
from app.plots.look import Look, Rgb, bytes3
from app.plots.words import Entry, font
from app.readouts import written

Box = tuple[float, float, float, float]  # left, top, right, bottom
CELL, STEP = 3.2, 7.0  # at most, in heights of the small letters: of a cell, and from one to the next


class LedgerPart:
    """All is written over the plotter's empty picture."""

    def __init__(self, plot: Ledger, look: Look):
        self.plot, self.look = plot, look
        self.values: dict = {}

    @property
    def entries(self) -> list[Entry]:
        return []

    def footer(self) -> np.ndarray | None:
        return None

    def build(self, plotter, values: dict) -> None:
        self.values = dict(values)

    def update(self, values: dict, camera: Camera | None) -> list[str]:
        self.values = dict(values)
        return []

    def overlay(self, picture: np.ndarray) -> np.ndarray:
        image = Image.fromarray(picture)
        self.pen, gap = ImageDraw.Draw(image), 0.5 * self.look.text
        found = balance(self.plot, self.values) if image.height > 14 * self.look.small else None  # or there is no room
        bottom = image.height - (2.6 * self.look.small if found else 0) - 0.5 * gap
        wide = (image.width - gap) / len(self.plot.columns)
        for i, column in enumerate(self.plot.columns):
            left = gap + i * wide
            self.column(lines(column, self.values), (left, 0, left + wide - gap, bottom))
        if found:
            self.bar(found, (gap, bottom, image.width - gap, image.height))
        return np.array(image)

    def column(self, rows: list[Line], box: Box) -> None:
        """Cells with a name and a value; the arrow between them carries the factor."""
        look, (left, top, right, bottom) = self.look, box
        small, edge = look.small, left + 0.5 * look.small
        step = min(max(2.0, (bottom - top) / len(rows)), STEP * small)
        cell = min(CELL * small, 0.68 * step)
        ground, frame = (bytes3(look.mixed(look.background, look.quiet, share)) for share in (0.14, 0.6))
        for i, line in enumerate(rows):
            y = top + i * step
            self.pen.rounded_rectangle((left, y, right, y + cell), 0.4 * small, ground, frame)
            self.text(edge, y + 0.29 * cell, line.label, look.quiet, right, 0.44 * cell)
            value = written(line.value, pretty(line.unit))
            self.text(edge, y + 0.72 * cell, value, look.foreground, right, 0.44 * cell)
            if i:
                x, middle, reach = left + small, y - 0.5 * (step - cell), 0.42 * (step - cell)
                ink, foot = bytes3(look.colour("l")), middle + reach
                self.pen.line((x, middle - reach, x, foot), ink, round(look.line))
                self.pen.polygon([(x - 0.25 * small, foot - 0.5 * small), (x + 0.25 * small, foot - 0.5 * small),
                                  (x, foot)], ink)
                words = f"{factor_words(line)}  {line.how}".rstrip()
                self.text(x + 0.6 * small, middle, words, look.foreground, right, 0.85 * (step - cell))

    def bar(self, found: Balance, box: Box) -> None:
        """A bar of all that is emitted, the part received in the light's colour; and the sum below it."""
        look, (left, top, right, _) = self.look, box
        share = min(1.0, max(0.0, found.received / found.emitted)) if found.emitted else 0.0
        words = f"received {found.received:.5g} + escaped {found.escaped:.5g} = {found.emitted:.5g}"
        off = "" if abs(found.off) < 1e-13 else f", off by {found.off:.0e}"
        low = top + 0.8 * look.small
        self.pen.rectangle((left, top, right, low), bytes3(look.mixed(look.background, look.quiet, 0.5)))
        self.pen.rectangle((left, top, left + share * (right - left), low), bytes3(look.colour("l")))
        self.text(left, low + 0.9 * look.small, f"{words} {pretty(found.unit)}{off}", look.foreground, right)

    def text(self, x: float, y: float, words: str, colour: Rgb, right: float, high: float = 1e9) -> None:
        """A line from x on, in the theme's small letters, or smaller where it would pass `right` or be higher."""
        size = min(self.look.small, round(high))
        while size > 8 and font(self.look, size).getlength(words) > right - x - 0.2 * self.look.small:
            size -= 1
        self.pen.text((x, y), words, bytes3(colour), font(self.look, size), anchor="lm")
