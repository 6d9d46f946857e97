"""The quiet strip below a still: the step's title, the state that opens it again, its live numbers and badges."""

from collections.abc import Sequence
from dataclasses import dataclass

from PIL import Image, ImageDraw

from app.badges import NAMES, SHORT, Badge
from app.export.ink import Ink, badge, fitted, length, sample, square, write
from app.lesson import Mark
from app.readouts import Number

LINES = {"estimate": "dotted", "printed": "dashdot"}
ROW, HEAD, GAP, EDGE = 2.95, 1.75, 1.4, 1.0  # in sizes of the text


@dataclass(frozen=True)
class Judged:
    """A model with its badges."""

    label: str
    colour: str
    badges: dict[str, Badge]


Block = Number | Judged


def strip(width: int, room: float, title: str, state: str, numbers: Sequence[Block], ink: Ink) -> Image.Image | None:
    """The strip, at most `room` high; without the badges, without the numbers, or not at all, where the picture has no
    room for it."""
    for shown in (numbers, [one for one in numbers if isinstance(one, Number)], []):
        one, rows = flow(width, title, shown, ink)
        height = round((ROW if one else HEAD + ROW * len(rows)) * ink.text + 0.55 * ink.text)
        if height <= room:
            return drawn((width, height), one, rows, title, state, ink)
    return None


def flow(width: int, title: str, numbers: Sequence[Block], ink: Ink) -> tuple[bool, list[list[Block]]]:
    """Title and numbers side by side where they fit; else the numbers in rows below the title."""
    most, gap = width - 2 * EDGE * ink.text, GAP * ink.text
    wide = {number.label: min(most, block(number, ink)) for number in numbers}
    head = max(length(title, large(ink), True), 11 * ink.text)
    if head + sum(w + gap for w in wide.values()) <= most:
        return True, [list(numbers)]
    rows: list[list[Block]] = [[]] if numbers else []
    for number in numbers:
        if rows[-1] and sum(wide[n.label] + gap for n in rows[-1]) + wide[number.label] > most:
            rows.append([])
        rows[-1].append(number)
    return False, rows


def large(ink: Ink) -> int:
    return round(1.15 * ink.text)


def block(number: Block, ink: Ink) -> float:
    """How wide a number stands with its label and its error, or a model with its badges."""
    below = value_width(number, ink) if isinstance(number, Number) else len(NAMES) * 1.9 * ink.small + sum(
        length(word, ink.small) for word in SHORT.values())
    return 1 + max(1.9 * ink.small + length(number.label, ink.small), below)


def value_width(number: Number, ink: Ink) -> float:
    error = length(number.error_text, ink.small) + 0.7 * ink.text if number.error_text else 0.0
    return length(number.text, large(ink), True) + error


def drawn(size: tuple[int, int], one: bool, rows: list[list[Block]], title: str, state: str, ink: Ink) -> Image.Image:
    picture = Image.new("RGB", size, ink.colour("panel"))
    draw = ImageDraw.Draw(picture)
    draw.line((0, 0, size[0], 0), ink.colour("quiet"), max(1, round(ink.scale / 2)))
    edge, gap, quiet, front = EDGE * ink.text, GAP * ink.text, ink.colour("quiet"), ink.colour("foreground")
    most = size[0] - 2 * edge
    spare = most - sum(block(n, ink) + gap for row in rows for n in row) if one else most
    words = fitted(title, large(ink), spare, True)
    end = write(draw, (edge, 1.5 * ink.text), words, large(ink), front, bold=True)
    at, room = ((edge, 2.9 * ink.text), spare) if one else ((end + gap, 1.5 * ink.text), size[0] - edge - end - gap)
    write(draw, at, fitted(state, ink.small, room), ink.small, quiet)
    for i, row in enumerate(rows):
        x = size[0] - edge - sum(block(n, ink) + gap for n in row) + gap if one else edge
        upper, lower = ((1.5 + ROW * i + (0 if one else HEAD)) * ink.text + shift for shift in (0.0, 1.4 * ink.text))
        for number in row:
            wide = min(most, block(number, ink))
            if isinstance(number, Number):
                sample(picture, (x, upper - 0.36 * ink.small), 1.4 * ink.small, line(number), ink)
            else:
                square(draw, (x + 0.3 * ink.small, upper - 0.36 * ink.small), 0.9 * ink.small,
                       ink.colour(number.colour))
            label = fitted(number.label, ink.small, wide - 1.9 * ink.small)
            write(draw, (x + 1.9 * ink.small, upper), label, ink.small, quiet)
            if isinstance(number, Number):
                end = write(draw, (x, lower), number.text, large(ink), front, bold=True)
                write(draw, (end + 0.7 * ink.text, lower), number.error_text, ink.small, front)
            else:
                judged(picture, (x, lower), number, ink)
            x += wide + gap
    return picture


def judged(picture: Image.Image, at: tuple[float, float], one: Judged, ink: Ink) -> None:
    """The badges in a row, each with its word."""
    x, y = at
    for name in NAMES:
        badge(picture, (x, y - 0.36 * ink.small), 1.1 * ink.small, one.badges[name].ok, ink)
        end = write(ImageDraw.Draw(picture), (x + 1.4 * ink.small, y), SHORT[name], ink.small, ink.colour("foreground"))
        x = end + 0.5 * ink.small


def line(number: Number) -> Mark:
    """The grammar's line of an exact value, an estimate, a formula as printed."""
    if number.role in LINES:
        return Mark("", colour=number.role, line=LINES[number.role])  # type: ignore[arg-type]
    return Mark("", colour="exact")
