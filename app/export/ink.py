"""Words and samples of lines on a picture, at sizes that follow it, in one font for all stills."""

from dataclasses import dataclass
from functools import cache

from PIL import Image, ImageDraw, ImageFont

from app.fonts import font_files
from app.lesson import Mark
from app.readouts import raised
from app.theme import Theme, colour

PATTERNS = {"solid": ((0.0, 1.0),), "dashed": ((0.0, 0.4), (0.6, 1.0)), "dotted": tuple((x, x + 0.1) for x in
            (0.0, 0.225, 0.45, 0.675, 0.9)), "dashdot": ((0.0, 0.4), (0.52, 0.62), (0.74, 1.0))}
LEAST = 20  # px of text at 1280x720: a still is seen from farther away than a window
FINE = 4  # samples are drawn this much larger and reduced


@cache
def font(size: int, bold: bool = False) -> ImageFont.FreeTypeFont | ImageFont.ImageFont:
    files = font_files()
    return ImageFont.truetype(files[bold], size) if files else ImageFont.load_default(size)


@dataclass(frozen=True)
class Ink:
    """The sizes and colours of a theme on a picture; a large picture is a small one enlarged, text stays readable."""

    theme: Theme
    size: tuple[int, int]  # of the whole picture

    @property
    def scale(self) -> float:
        return max(1.0, max(1.0, LEAST / self.theme.text) * min(self.size[0] / 1280, self.size[1] / 720))

    @property
    def text(self) -> int:
        return round(self.theme.text * self.scale)

    @property
    def small(self) -> int:
        return round(max(14.0, 0.88 * self.theme.text) * self.scale)

    @property
    def line(self) -> float:
        return self.theme.line * self.scale

    def colour(self, name: str) -> tuple[int, int, int]:
        return bytes3(colour(name, self.theme))


def bytes3(rgb) -> tuple[int, int, int]:
    return tuple(round(255 * part) for part in rgb)  # type: ignore[return-value]


def pieces(text: str, size: int) -> list[tuple[str, int, float]]:
    """(text, size, lift): exponents are smaller and higher."""
    return [(part, round(0.72 * size) if up else size, 0.42 * size if up else 0.0) for part, up in raised(text)]


def length(text: str, size: int, bold: bool = False) -> float:
    return sum(font(s, bold).getlength(part) for part, s, _ in pieces(text, size))


def write(draw: ImageDraw.ImageDraw, at: tuple[float, float], text: str, size: int, ink: tuple[int, int, int], *,
          bold: bool = False, halo: tuple[int, int, int] | None = None) -> float:
    """Text from the left end of its base line, with a rim of the halo's colour; returns where it ends."""
    for rim in ((halo, ink) if halo else (ink,)):
        x = at[0]
        for part, s, lift in pieces(text, size):
            stroke = max(1, round(0.12 * size)) if halo and rim is halo else 0
            draw.text((x, at[1] - lift), part, rim, font(s, bold), anchor="ls", stroke_width=stroke, stroke_fill=rim)
            x += font(s, bold).getlength(part)
    return x


def fitted(text: str, size: int, width: float, bold: bool = False) -> str:
    """The text, or as much of its beginning as fits, with an ellipsis."""
    if length(text, size, bold) <= width:
        return text
    while text and length(text + "…", size, bold) > width:
        text = text[:-1]
    return text.rstrip() + "…" if text else ""


def sample(picture: Image.Image, at: tuple[float, float], width: float, mark: Mark, ink: Ink) -> None:
    """A piece of the mark's line, with its tip at the right end; `at` is the left end."""
    high = round(2.2 * ink.small)
    big = Image.new("RGBA", (FINE * round(width), FINE * high), (*ink.colour(mark.colour), 0))
    draw, full = ImageDraw.Draw(big), (*ink.colour(mark.colour), 255)
    middle, thick, right = big.height / 2, FINE * ink.line * min(1.6, mark.width), big.width
    if mark.tip == "arrow":
        draw.polygon([(right, middle), (right - 3.6 * thick, middle - 2.0 * thick),
                      (right - 3.6 * thick, middle + 2.0 * thick)], full)
        right -= round(3.2 * thick)
    elif mark.tip != "none":
        r = 1.9 * thick
        draw.ellipse((right - 2 * r, middle - r, right, middle + r), full)
        right -= round(r)
    for a, b in PATTERNS[mark.line]:
        draw.rectangle((a * right, middle - thick / 2, b * right, middle + thick / 2), full)
    small = big.resize((round(width), high), Image.Resampling.BOX)
    picture.paste(small, (round(at[0]), round(at[1] - high / 2)), small)


def square(draw: ImageDraw.ImageDraw, at: tuple[float, float], side: float, ink: tuple[int, int, int]) -> None:
    """A sample of a surface; `at` is the middle of its left side."""
    x, y = at
    draw.rounded_rectangle((x, y - side / 2, x + side, y + side / 2), side / 5, ink)


def badge(picture: Image.Image, at: tuple[float, float], side: float, ok: bool, ink: Ink) -> None:
    """A round one with a tick, a square one with a cross; `at` is the middle of its left side."""
    big = Image.new("RGBA", (FINE * round(side),) * 2, (0, 0, 0, 0))
    draw, n = ImageDraw.Draw(big), big.width
    ground = (*ink.colour("v" if ok else "r"), 255)
    if ok:
        draw.ellipse((0, 0, n - 1, n - 1), ground)
        strokes = [[(0.27, 0.52), (0.45, 0.70)], [(0.42, 0.70), (0.75, 0.32)]]
    else:
        draw.rounded_rectangle((0.04 * n, 0.04 * n, 0.96 * n, 0.96 * n), 0.1 * n, ground)
        strokes = [[(0.3, 0.3), (0.7, 0.7)], [(0.3, 0.7), (0.7, 0.3)]]
    for stroke in strokes:
        draw.line([(n * x, n * y) for x, y in stroke], (255, 255, 255, 255), round(0.13 * n))
    small = big.resize((round(side), round(side)), Image.Resampling.BOX)
    picture.paste(small, (round(at[0]), round(at[1] - side / 2)), small)
