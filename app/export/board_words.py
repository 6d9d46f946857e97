"""What the board's picture says of a model: its name, its parameters, and its badges with their worst values."""

import math
from dataclasses import dataclass

from PIL import Image, ImageDraw

from app.badges import Badge
from app.export.ies_report import wrapped
from app.export.ink import Ink, badge, fitted, length, square, write
from app.readouts import three

STEP = 1.42  # from line to line, times the small text
ABOUT = 3  # lines at most
INDENT = 1.6
JUDGED = {  # what is said of a good one and of a bad one
    "non_negative": ("negative nowhere", "negative: {} /sr"), "reciprocal": ("swaps light and eye", "swapped, {} off"),
    "energy": ("albedo at most {}", "albedo {}, more than all"), "finite": ("finite everywhere", "not finite"),
}
NO_NUMBER = {"non_negative": "no number anywhere", "reciprocal": "swapped: no number", "energy": "albedo: no number",
             "finite": JUDGED["finite"][1]}
SIGNS = {"theta_l": "θ_l", "theta_v": "θ_v", "phi": "φ"}


@dataclass(frozen=True)
class Line:
    text: str
    colour: str = "quiet"
    bold: bool = False
    ok: bool | None = None  # with a badge
    square: str = ""  # with a sample of this colour
    indent: bool = False
    beside: str = ""  # quietly, behind the text

    def write(self, picture: Image.Image, draw: ImageDraw.ImageDraw, at: tuple[float, float], ink: Ink) -> None:
        x, y = at
        if self.ok is not None:
            badge(picture, (x, y - 0.36 * ink.small), 1.1 * ink.small, self.ok, ink)
        if self.square:
            square(draw, (x, y - 0.36 * ink.small), 0.95 * ink.small, ink.colour(self.square))
        x += INDENT * ink.small * (self.ok is not None or bool(self.square) or self.indent)
        size = ink.text if self.square else ink.small
        end = write(draw, (x, y), self.text, size, ink.colour(self.colour), bold=self.bold)
        if self.beside:
            write(draw, (end + ink.small, y), self.beside, ink.small, ink.colour("quiet"))


def lines(label: str, colour: str, about: str, badges: dict[str, Badge], room: float, ink: Ink) -> list[Line]:
    """As many as it takes at this width; angles of a bad one stand below it where there is no room beside."""
    small, inner = ink.small, room - INDENT * ink.small
    found = [Line(fitted(label, ink.text, inner, True), "foreground", True, square=colour)]
    whole = wrapped(about, small, room)
    if len(whole) > ABOUT:
        whole[ABOUT - 1:] = [fitted(" ".join(whole[ABOUT - 1:]), small, room)]
    found += [Line(line) for line in whole]
    for name, words in JUDGED.items():
        one = badges[name]
        said = words[not one.ok].format(worst(name, one)) if one.worst is not None else NO_NUMBER[name]
        at = place(one) if not one.ok or name == "energy" else ""
        here = length(said, small, not one.ok) + small + length(at, small) <= inner
        found.append(Line(fitted(said, small, inner, not one.ok), "foreground", not one.ok, one.ok,
                          beside=at if here else ""))
        if at and not here and not one.ok:
            found.append(Line(fitted(at, small, inner), indent=True))
    return found


def worst(name: str, found: Badge) -> str:
    assert found.worst is not None
    return f"{100 * found.worst:.3g} %" if name == "reciprocal" else three(found.worst)


def place(found: Badge) -> str:
    """'θ_l 59°  θ_v 88°  φ 173°'."""
    def said(angle: float) -> str:
        degrees = math.degrees(angle)
        return f"{degrees:.3g}°" if abs(degrees) >= 1e-3 or not degrees else "≈ 0°"

    return "  ".join(f"{SIGNS[name]} {said(angle)}" for name, angle in found.at.items())
