"""The unit ledger as a picture: quantities below each other, the factor between them, and the balance as a bar."""

import numpy as np
from PIL import Image, ImageDraw

from app.ledger import Line, balance, factor_words, lines, pretty
from app.lesson import Camera, Ledger
from app.plots.look import Look, bytes3
from app.plots.words import Entry, font
from app.readouts import three, written


class LedgerPart:
    def __init__(self, plot: Ledger, look: Look):
        self.plot, self.look, self.values = plot, look, {}

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
        """The scene of the plotter is empty: all is written here."""
        image = Image.fromarray(picture)
        draw = ImageDraw.Draw(image)
        gap = round(0.5 * self.look.text)
        found = balance(self.plot, self.values)
        foot = 4 * round(1.4 * self.look.small) if found else 0
        wide = (image.width - gap) / len(self.plot.columns)
        for i, column in enumerate(self.plot.columns):
            self.column(draw, lines(column, self.values), (gap + i * wide, 0, gap + (i + 1) * wide - gap,
                                                           image.height - foot - gap))
        if found:
            look, low = self.look, round(1.4 * self.look.small)
            top = image.height - foot
            left, right = gap, image.width - gap
            share = min(1.0, max(0.0, found.received / found.emitted)) if found.emitted else 0.0
            cut = left + share * (right - left)
            draw.text((left, top + low / 2), "balance by integration", bytes3(look.quiet), font(look, look.small), "lm")
            draw.rectangle((left, top + low, right, top + 1.8 * low), bytes3(look.mixed(look.background, look.quiet, 0.5)))
            draw.rectangle((left, top + low, cut, top + 1.8 * low), bytes3(look.colour("l")))
            words = (f"received {three(found.received)}", f"escaped {three(found.escaped)} {pretty(found.unit)}")
            for x, text, anchor in ((left, words[0], "lm"), (right, words[1], "rm")):
                draw.text((x, top + 2.4 * low), text, bytes3(look.foreground), font(look, look.small), anchor)
            off = "to rounding" if abs(found.off) < 1e-13 else f"but for {found.off:.0e}"
            draw.text((left, top + 3.4 * low), f"= emitted {three(found.emitted)}, {off}", bytes3(look.foreground),
                      font(look, look.small), "lm")
        return np.array(image)

    def column(self, draw: ImageDraw.ImageDraw, rows: list[Line], box: tuple[float, float, float, float]) -> None:
        """Cells with a value and its name; the arrow between them carries the factor."""
        look = self.look
        left, top, right, bottom = box
        step = min((bottom - top) / len(rows), 7.0 * look.small)
        cell = min(3.2 * look.small, 0.68 * step)
        ground, frame = look.mixed(look.background, look.quiet, 0.14), look.mixed(look.background, look.quiet, 0.6)
        for i, line in enumerate(rows):
            y = top + i * step
            draw.rounded_rectangle((left, y, right, y + cell), 0.4 * look.small, bytes3(ground), bytes3(frame))
            draw.text((left + 0.5 * look.small, y + 0.3 * cell), line.label, bytes3(look.quiet),
                      font(look, fitted(look, line.label, right - left - look.small)), "lm")
            value = written(line.value, pretty(line.unit))
            draw.text((left + 0.5 * look.small, y + 0.72 * cell), value, bytes3(look.foreground),
                      font(look, fitted(look, value, right - left - look.small, look.text if cell > 3 * look.small else look.small)), "lm")
            if i:
                words, middle, x = factor_words(line), y - 0.5 * (step - cell), left + look.small
                reach = 0.42 * (step - cell)
                ink = bytes3(look.colour("l"))
                draw.line((x, middle - reach, x, middle + reach), ink, round(look.line))
                draw.polygon([(x - 0.25 * look.small, middle + 0.2 * reach), (x + 0.25 * look.small, middle + 0.2 * reach),
                              (x, middle + reach)], ink)
                whole = f"{words}  {line.how}" if line.how else words
                draw.text((x + 0.6 * look.small, middle), whole, bytes3(look.foreground),
                          font(look, fitted(look, whole, right - x - 0.6 * look.small)), "lm")


def fitted(look: Look, text: str, width: float, most: int = 0) -> int:
    """The size, at most the theme's small one or `most`, at which a text is no wider."""
    size = most or look.small
    while size > 8 and font(look, size).getlength(text) > width:
        size -= 1
    return size
