"""The unit ledger as a picture: quantities below each other, the factor between them, and the balance as a bar."""

import numpy as np
from PIL import Image, ImageDraw

from app.ledger import Balance, Line, balance, factor_words, lines, pretty
from app.lesson import Camera, Ledger
from app.plots.look import Look, Rgb, bytes3
from app.plots.words import Entry, font
from app.readouts import three, written

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
        found = balance(self.plot, self.values) if image.height > 20 * self.look.small else None  # or there is no room
        bottom = image.height - gap - (5.6 * self.look.small if found else 0)
        wide = (image.width - gap) / len(self.plot.columns)
        for i, column in enumerate(self.plot.columns):
            left = gap + i * wide
            self.column(lines(column, self.values), (left, 0, left + wide - gap, bottom))
        if found:
            self.bar(found, (gap, bottom + gap, image.width - gap, image.height))
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
            self.text(edge, y + 0.3 * cell, line.label, look.quiet, right)
            self.text(edge, y + 0.72 * cell, written(line.value, pretty(line.unit)), look.foreground, right)
            if i:
                x, middle, reach = left + small, y - 0.5 * (step - cell), 0.42 * (step - cell)
                ink, foot = bytes3(look.colour("l")), middle + reach
                self.pen.line((x, middle - reach, x, foot), ink, round(look.line))
                self.pen.polygon([(x - 0.25 * small, foot - 0.5 * small), (x + 0.25 * small, foot - 0.5 * small),
                                  (x, foot)], ink)
                self.text(x + 0.6 * small, middle, f"{factor_words(line)}  {line.how}".rstrip(), look.foreground, right)

    def bar(self, found: Balance, box: Box) -> None:
        look, (left, top, right, _) = self.look, box
        high = 1.3 * look.small
        share = min(1.0, max(0.0, found.received / found.emitted)) if found.emitted else 0.0
        off = "to rounding" if abs(found.off) < 1e-13 else f"but for {found.off:.0e}"
        y = top + 1.1 * high
        self.pen.rectangle((left, y, right, y + 0.8 * high), bytes3(look.mixed(look.background, look.quiet, 0.5)))
        self.pen.rectangle((left, y, left + share * (right - left), y + 0.8 * high), bytes3(look.colour("l")))
        self.text(left, top + 0.5 * high, "balance, by integration", look.quiet, right)
        received = f"received {three(found.received)} + escaped {three(found.escaped)}"
        self.text(left, y + 1.4 * high, received, look.foreground, right)
        self.text(left, y + 2.35 * high, f"= emitted {three(found.emitted)} {pretty(found.unit)}, {off}",
                  look.foreground, right)

    def text(self, x: float, y: float, words: str, colour: Rgb, right: float) -> None:
        """A line from x on, in the theme's small letters, or smaller where it would pass `right`."""
        size = self.look.small
        while size > 8 and font(self.look, size).getlength(words) > right - x - 0.2 * self.look.small:
            size -= 1
        self.pen.text((x, y), words, bytes3(colour), font(self.look, size), anchor="lm")
