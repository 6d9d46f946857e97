"""What is written on a picture: title and legend above, the scale of colours below, labels and notices in it.

Pillow writes it, once a change, into strips of their own, so that a legend never covers a curve and nothing is clipped.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from app.plots.dots import stamp
from app.plots.look import Look, Rgb, bytes3

FINE = 4  # lines and areas are drawn this much larger and reduced, which smooths them
NOTICE = "#FF4FD8"  # the frame of a notice
SHAPES = ("circle", "cross", "diamond", "square")


@dataclass(frozen=True)
class Entry:
    """A word of the legend with its sample: solid, dashed, dashdot, dotted; one of SHAPES; dot (a large one); area."""

    sample: str
    colour: Rgb
    label: str


@cache
def font(look: Look, size: int) -> ImageFont.FreeTypeFont | ImageFont.ImageFont:
    return ImageFont.truetype(look.font, size) if look.font else ImageFont.load_default(size)


def wrapped(look: Look, text: str, size: int, width: float) -> list[str]:
    """Lines that fit into the width; a word that does not fit by itself is broken."""
    lines = [""]
    for word in text.split():
        longer = f"{lines[-1]} {word}".strip()
        if font(look, size).getlength(longer) <= width:
            lines[-1] = longer
            continue
        if lines[-1]:
            lines.append("")
        for letter in word:
            if lines[-1] and font(look, size).getlength(lines[-1] + letter) > width:
                lines.append("")
            lines[-1] += letter
    return [line for line in lines if line]


def header(look: Look, title: str, entries: Sequence[Entry]) -> np.ndarray:
    """The strip above a plot: its title and its legend."""
    width, gap = look.size[0], round(0.5 * look.text)
    room = width - 2 * gap
    sample = round(1.7 * look.text)
    rows: list[list[tuple[int, Entry, str]]] = [[]]
    x = 0
    for entry in entries:
        lines = wrapped(look, entry.label, look.small, room - sample - gap)
        length = sample + gap // 2 + math.ceil(max(font(look, look.small).getlength(line) for line in lines or [""]))
        if rows[-1] and x + length > room:
            rows.append([])
            x = 0
        rows[-1].append((x, entry, lines[0] if lines else ""))
        for line in lines[1:]:
            rows.append([(x, Entry("", entry.colour, ""), line)])
        x = room if len(lines) > 1 else x + length + round(1.2 * gap)
    titles = wrapped(look, title, look.text, room)
    high, low = round(1.3 * look.text), round(1.32 * look.small)
    rows = [row for row in rows if row]
    height = gap // 2 + len(titles) * high + gap // 3 + len(rows) * low + gap // 3
    picture = Image.new("RGB", (width, height), bytes3(look.background))
    draw = ImageDraw.Draw(picture)
    y = gap // 2
    for line in titles:
        draw.text((gap, y + high / 2), line, bytes3(look.foreground), font(look, look.text), anchor="lm")
        y += high
    y += gap // 3
    dots: list[tuple[Entry, float, float]] = []
    for row in rows:
        for at, entry, text in row:
            if entry.sample in SHAPES or entry.sample == "dot":
                dots.append((entry, gap + at, y + low / 2))
            elif entry.sample:
                paste(picture, mark(look, entry, sample, low), gap + at, y)
            draw.text((gap + at + sample + gap // 2, y + low / 2), text, bytes3(look.foreground),
                      font(look, look.small), anchor="lm")
        y += low
    strip = np.array(picture)
    for entry, left, middle in dots:
        if entry.sample == "dot":
            stamp(strip, np.array([[left + sample / 2, middle]]), 2.2 * dot_size(look), entry.colour)
        else:
            three = np.array([[left + f * sample, middle] for f in (0.15, 0.5, 0.85)])
            stamp(strip, three, dot_size(look), entry.colour, entry.sample)
    return strip


def line_of_words(look: Look, text: str, where: str = "left") -> np.ndarray:
    """A strip with the title of an axis; VTK's own titles leave their shadows, and turned words are hard to read."""
    gap, high, middle = round(0.5 * look.text), round(1.3 * look.small), where == "middle"
    lines = wrapped(look, text, look.small, look.size[0] - 2 * gap)
    picture = Image.new("RGB", (look.size[0], high * len(lines) + gap // 2), bytes3(look.background))
    draw = ImageDraw.Draw(picture)
    for i, line in enumerate(lines):
        draw.text((look.size[0] / 2 if middle else gap, (i + 0.5) * high), line, bytes3(look.foreground),
                  font(look, look.small), anchor="mm" if middle else "lm")
    return np.asarray(picture)


def mark(look: Look, entry: Entry, width: int, height: int) -> Image.Image:
    """The sample of a legend's entry, transparent around it."""
    big = Image.new("RGBA", (FINE * width, FINE * height), (*bytes3(entry.colour), 0))
    draw, ink = ImageDraw.Draw(big), (*bytes3(entry.colour), 255)
    middle, thick = FINE * height / 2, FINE * look.line
    pattern = {"solid": [1.0], "dashed": [0.42, -0.16, 0.42], "dotted": [0.1, -0.125] * 4 + [0.1],
               "dashdot": [0.36, -0.14, 0.1, -0.14, 0.26]}
    if entry.sample in pattern:
        x = 0.0
        for part in pattern[entry.sample]:
            if part > 0:
                draw.rectangle((x * big.width, middle - thick / 2, (x + part) * big.width, middle + thick / 2), ink)
            x += abs(part)
    elif entry.sample == "area":
        draw.rounded_rectangle((big.width * 0.2, middle - 1.4 * FINE * look.small / 4, big.width * 0.8,
                                middle + 1.4 * FINE * look.small / 4), FINE * 2, ink)
    return big.resize((width, height), Image.Resampling.LANCZOS)


def dot_size(look: Look) -> float:
    """px across of a dot of an estimate."""
    return 2.4 * look.line + 1.2 * look.scale


def paste(picture: Image.Image, small: Image.Image, x: float, y: float) -> None:
    picture.paste(small, (round(x), round(y)), small)


def colour_bar(look: Look, colours: np.ndarray, title: str, ends: tuple[str, str, str]) -> np.ndarray:
    """The strip below a plot: its colours from low to high, three numbers and what they measure."""
    width, gap = look.size[0], round(0.5 * look.text)
    low, thick = round(1.35 * look.small), round(0.8 * look.small)
    titles = wrapped(look, title, look.small, width - 2 * gap)
    picture = Image.new("RGB", (width, gap // 2 + thick + low * (1 + len(titles)) + gap // 3), bytes3(look.background))
    draw = ImageDraw.Draw(picture)
    left, right, y = 2 * gap, width - 2 * gap, gap // 2
    row = (colours[np.linspace(0, len(colours) - 1, right - left).round().astype(int)] * 255).round().astype(np.uint8)
    picture.paste(Image.fromarray(np.repeat(row[None], thick, 0)), (left, y))
    y += thick
    for x, text, anchor in ((left, ends[0], "lm"), ((left + right) / 2, ends[1], "mm"), (right, ends[2], "rm")):
        draw.text((x, y + low / 2), text, bytes3(look.foreground), font(look, look.small), anchor=anchor)
    for line in titles:
        y += low
        draw.text((width / 2, y + low / 2), line, bytes3(look.quiet), font(look, look.small), anchor="mm")
    return np.asarray(picture)


def labelled(look: Look, picture: np.ndarray, labels: Sequence[tuple[float, float, str, Rgb]]) -> np.ndarray:
    """Words in the picture, each on a soft ground of its own so that it is readable on anything."""
    image = Image.fromarray(picture)
    draw = ImageDraw.Draw(image)
    for x, y, text, colour in labels:
        if not (math.isfinite(x) and math.isfinite(y)):
            continue
        draw.text((x, y), text, bytes3(colour), font(look, look.text), anchor="mm", stroke_width=round(2 * look.scale),
                  stroke_fill=bytes3(look.background))
    return np.array(image)


def noticed(look: Look, picture: np.ndarray, notices: Sequence[str], bottom: int) -> np.ndarray:
    """A box over the picture that says what is not drawn; its lower edge lies at `bottom`."""
    if not notices:
        return picture
    gap = round(0.5 * look.small)
    lines = [line for text in notices for line in wrapped(look, text, look.small, look.size[0] - 6 * gap)]
    high = round(1.3 * look.small)
    wide = math.ceil(max(font(look, look.small).getlength(line) for line in lines)) + 2 * gap
    tall = len(lines) * high + gap
    image = Image.fromarray(picture)
    draw = ImageDraw.Draw(image)
    left, top = (look.size[0] - wide) // 2, max(0, bottom - tall)
    ground = bytes3(look.mixed(look.background, look.quiet, 0.12))
    draw.rounded_rectangle((left, top, left + wide, top + tall), gap, ground, NOTICE, max(1, round(look.scale)))
    for i, line in enumerate(lines):
        draw.text((look.size[0] / 2, top + gap / 2 + (i + 0.5) * high), line, bytes3(look.foreground),
                  font(look, look.small), anchor="mm")
    return np.array(image)
