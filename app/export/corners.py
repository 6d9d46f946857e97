"""What stands in the corners of a scene: the legend, and a notice where the picture has faults."""

from dataclasses import dataclass

from PIL import Image, ImageDraw

from app.export.ink import Ink, bytes3, fitted, length, sample, square, write
from app.export.labels import Box, Clutter, share
from app.gpu.picture import Faults
from app.lesson import Mark, Scene
from app.theme import rgb

FAULTS = {"nan": ("not a number", "#FF00FF"), "inf": ("infinite", "#00FFFF"), "negative": ("negative", "#FF0000")}


@dataclass(frozen=True)
class Entry:
    words: str
    mark: Mark | None = None  # its line; without one a square of the colour
    colour: str = "exact"


def entries(scene: Scene) -> list[Entry]:
    """The scene's own legend, or what its labelled marks are; a label that says it all has no entry."""
    if scene.legend:
        lines = {mark.colour: mark for mark in reversed(scene.marks) if mark.tip != "none"}
        return [Entry(words, lines.get(colour), colour) for colour, words in scene.legend]
    return [Entry(f"{mark.label}  {mark.name}", mark, mark.colour) for mark in scene.marks
            if mark.label and len(mark.label) <= 2 and mark.label != mark.name]


def legend(picture: Image.Image, shown: list[Entry], clutter: Clutter, ink: Ink, taken: list[Box]) -> list[Box]:
    """Draws the legend into the emptiest corner; returns the box it takes."""
    if not shown:
        return []
    size, gap, swatch = ink.small, 0.6 * ink.small, 2.0 * ink.small
    row = 1.5 * size
    room = 0.6 * picture.width - swatch - 3 * gap
    lines = [fitted(entry.words, size, room) for entry in shown]
    wide, high = swatch + 3 * gap + max(length(line, size) for line in lines), row * len(lines) + gap
    far_x, far_y = picture.width - wide - gap, picture.height - high - gap
    corners = [(x, y, x + wide, y + high) for x, y in ((far_x, gap), (gap, gap), (gap, far_y), (far_x, far_y))]
    box = min(corners, key=lambda c: clutter(c) + 100 * sum(share(c, other) for other in taken))
    ground(picture, box, ink)
    draw = ImageDraw.Draw(picture)
    for i, (entry, line) in enumerate(zip(shown, lines, strict=True)):
        x, y = box[0] + gap, box[1] + gap / 2 + (i + 0.5) * row
        if entry.mark:
            sample(picture, (x, y), swatch, entry.mark, ink)
        else:
            square(draw, (x + (swatch - 0.9 * size) / 2, y), 0.9 * size, ink.colour(entry.colour))
        write(draw, (x + swatch + gap, y + 0.36 * size), line, size, ink.colour("foreground"))
    return [box]


def notice(picture: Image.Image, faults: Faults, ink: Ink) -> list[Box]:
    """Says in the upper left corner how many pixels are faulty, each kind with its pattern; never by colour alone."""
    if not faults:
        return []
    size, gap = ink.small, 0.6 * ink.small
    kinds = [(f"{getattr(faults, name)} px {words}", rgb(code)) for name, (words, code) in FAULTS.items()
             if getattr(faults, name)]
    wide = 4 * gap + size + max(length(words, size) for words, _ in kinds)
    box = (gap, gap, min(picture.width - gap, gap + wide), 2 * gap + 1.5 * size * len(kinds))
    ground(picture, box, ink, rim=kinds[0][1], opacity=0.95)
    draw = ImageDraw.Draw(picture)
    for i, (words, code) in enumerate(kinds):
        x, y = box[0] + gap, box[1] + gap / 2 + (i + 0.5) * 1.5 * size
        side = size / 4
        for k in range(16):
            left, top = x + (k % 4) * side, y - 2 * side + (k // 4) * side
            dark = (k % 4 + k // 4) % 2
            draw.rectangle((left, top, left + side - 1, top + side - 1), (0, 0, 0) if dark else bytes3(code))
        write(draw, (x + size + gap, y + 0.36 * size), words, size, ink.colour("foreground"))
    return [box]


def ground(picture: Image.Image, box: Box, ink: Ink, rim=None, opacity: float = 0.78) -> None:
    """A soft ground in the panel's colour, so that words read on anything."""
    x, y, right, bottom = (round(side) for side in box)
    patch = Image.new("RGBA", (right - x, bottom - y), (0, 0, 0, 0))
    outline = (*bytes3(rim), 255) if rim else None
    ImageDraw.Draw(patch).rounded_rectangle(
        (0, 0, patch.width - 1, patch.height - 1), round(0.4 * ink.small), (*ink.colour("panel"), round(255 * opacity)),
        outline, max(1, round(ink.scale)))
    picture.paste(patch, (x, y), patch)
