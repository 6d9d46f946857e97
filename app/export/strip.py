"""The quiet strip below a still: the step's title, the state that opens it again, and its live numbers."""

from PIL import Image, ImageDraw

from app.export.ink import Ink, fitted, length, sample, write
from app.lesson import Mark
from app.readouts import Number

LINES = {"estimate": "dotted", "printed": "dashdot"}
Block = tuple[Number | None, float]  # a number, or the title, and its width


def strip(width: int, room: float, title: str, state: str, numbers: list[Number], ink: Ink) -> Image.Image | None:
    """The strip, at most `room` high; without the numbers, or not at all, where the picture has no room for it."""
    for shown in (numbers, []):
        rows = flow(width, title, shown, ink)
        height = round((len(rows) * 2.95 + 0.55) * ink.text)
        if height <= room:
            return drawn(width, height, rows, title, state, ink)
    return None


def flow(width: int, title: str, numbers: list[Number], ink: Ink) -> list[list[Block]]:
    """Blocks in rows: the title first, numbers after it as they fit."""
    gap, most = 1.4 * ink.text, width - 2 * ink.text
    head = min(most, max(length(title, round(1.15 * ink.text), True), 11 * ink.text))
    rows: list[list[Block]] = [[(None, head)]]
    for number in numbers:
        wide = min(most, max(1.9 * ink.small + length(number.label, ink.small), value_width(number, ink)))
        if sum(w + gap for _, w in rows[-1]) + wide > most:
            rows.append([])
        rows[-1].append((number, wide))
    return rows


def value_width(number: Number, ink: Ink) -> float:
    error = length(number.error_text, ink.small) + 0.7 * ink.text if number.error_text else 0.0
    return length(number.text, round(1.15 * ink.text), True) + error


def drawn(width: int, height: int, rows: list[list[Block]], title: str, state: str, ink: Ink) -> Image.Image:
    picture = Image.new("RGB", (width, height), ink.colour("panel"))
    draw = ImageDraw.Draw(picture)
    draw.line((0, 0, width, 0), ink.colour("quiet"), max(1, round(ink.scale / 2)))
    large, gap, edge = round(1.15 * ink.text), 1.4 * ink.text, ink.text
    for i, row in enumerate(rows):
        spare = width - 2 * edge - sum(w for _, w in row) - gap * (len(row) - 1)
        x = float(edge)
        upper, lower = (0.55 + 2.95 * i + 0.95) * ink.text, (0.55 + 2.95 * i + 2.35) * ink.text
        for number, wide in row:
            if number is None:
                write(draw, (x, upper), fitted(title, large, wide, True), large, ink.colour("foreground"), bold=True)
                write(draw, (x, lower), fitted(state, ink.small, wide + max(0.0, spare), False), ink.small,
                      ink.colour("quiet"))
                x += max(0.0, spare) if len(row) > 1 else 0.0  # the numbers stand to the right
            else:
                sample(picture, (x, upper - 0.36 * ink.small), 1.4 * ink.small, line(number), ink)
                write(draw, (x + 1.9 * ink.small, upper), fitted(number.label, ink.small, wide - 1.9 * ink.small),
                      ink.small, ink.colour("quiet"))
                end = write(draw, (x, lower), number.text, large, ink.colour("foreground"), bold=True)
                write(draw, (end + 0.7 * ink.text, lower), number.error_text, ink.small, ink.colour("foreground"))
            x += wide + gap
    return picture


def line(number: Number) -> Mark:
    """The grammar's line of an exact value, an estimate, a formula as printed."""
    if number.role in LINES:
        return Mark("", colour=number.role, line=LINES[number.role])  # type: ignore[arg-type]
    return Mark("", colour="exact")
