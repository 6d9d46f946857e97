"""Polar curves of a luminaire's main planes: intensity as the distance from the middle, straight down below it."""

import math

import numpy as np
from PIL import Image, ImageDraw

from app.export.ink import FINE, Ink, length, sample, write
from app.ies import Photometry
from app.lesson import Mark
from app.optics.ies import ies_plane
from app.plots.ticks import nice
from app.readouts import three

PLANES = ((0.0, "l", "solid", "C0 - C180"), (math.pi / 2, "v", "dashed", "C90 - C270"))
POINTS = 721
BESIDE = 3  # degrees: a peak farther than this from the two planes gets a third one


def polar(picture: Image.Image, box: tuple[int, int, int, int], found: Photometry, ink: Ink) -> None:
    """Draws the curves into the box: rings of candela, rays of 30 degrees, and a legend below."""
    left, top, right, bottom = box
    foot = round(2.2 * ink.small)
    middle = ((left + right) / 2, (top + bottom - foot) / 2)
    radius = 0.5 * min(right - left, bottom - top - foot) - 1.9 * ink.small
    theta = np.linspace(-math.pi, math.pi, POINTS)
    planes = main_planes(found)
    curves = [ies_plane(found.table, theta, plane) for plane, *_ in planes]
    most = nice(max(float(max(curve.max() for curve in curves)), 1e-9))
    big = Image.new("RGB", (FINE * (right - left), FINE * (bottom - top - foot)), ink.colour("background"))
    draw = ImageDraw.Draw(big)
    centre = FINE * (middle[0] - left), FINE * (middle[1] - top)
    grid, thin = mixed(ink, 0.45), max(1, round(FINE * ink.line / 3))
    for share in (0.25, 0.5, 0.75, 1.0):
        r = FINE * radius * share
        draw.ellipse((centre[0] - r, centre[1] - r, centre[0] + r, centre[1] + r), outline=grid, width=thin)
    for degrees in range(0, 360, 30):
        draw.line((*centre, *around(centre, FINE * radius, math.radians(degrees))), grid, thin)
    for (_, colour, line, _), curve in zip(planes, curves, strict=True):
        points = [around(centre, FINE * radius * value / most, angle)
                  for angle, value in zip(theta, curve, strict=True)]
        for piece in pieces(points, line, FINE * ink.line):
            draw.line(piece, ink.colour(colour), round(FINE * ink.line), joint="curve")
    picture.paste(big.resize((right - left, bottom - top - foot), Image.Resampling.BOX), (left, top))
    words(picture, (middle[0], middle[1]), radius, most, ink)
    x: float = left + ink.text
    for _, colour, line, label in planes:
        sample(picture, (x, bottom - 0.9 * ink.small), 2.4 * ink.small, Mark("", colour=colour, line=line), ink)  # type: ignore[arg-type]
        x = write(ImageDraw.Draw(picture), (x + 2.9 * ink.small, bottom - 0.55 * ink.small), label, ink.small,
                  ink.colour("foreground")) + 1.5 * ink.text


def main_planes(found: Photometry) -> tuple[tuple[float, str, str, str], ...]:
    """C0 and C90, and the plane of the peak where that is another."""
    c, theta = np.meshgrid(np.radians(np.arange(180)), np.radians(np.arange(-180, 181)))
    there = ies_plane(found.table, theta, c)
    beside = [there[:, max(0, i - BESIDE):i + BESIDE + 1].max() for i in (0, 90)] + [there[:, -BESIDE:].max()]
    if max(beside) >= 0.98 * there.max():
        return PLANES
    peak = int(np.argmax(there.max(0)))
    return (*PLANES, (math.radians(peak), "h", "solid", f"C{peak} - C{peak + 180}, the peak"))


def words(picture: Image.Image, middle: tuple[float, float], radius: float, most: float, ink: Ink) -> None:
    """The angles at the rim and the candela of two rings."""
    draw, back, quiet = ImageDraw.Draw(picture), ink.colour("background"), ink.colour("quiet")
    for degrees in (0, 30, 60, 90, 120, 150, 180):
        for side in {1, -1} if degrees % 180 else {1}:
            x, y = around(middle, radius + 0.95 * ink.small, side * math.radians(degrees))
            said = f"{degrees}°"
            write(draw, (x - length(said, ink.small) / 2, y + 0.36 * ink.small), said, ink.small, quiet)
    for share in (0.5, 1.0):
        x, y = around(middle, radius * share, math.radians(-105))
        said = f"{three(most * share)} cd"
        write(draw, (x - length(said, ink.small) / 2, y + 0.36 * ink.small), said, ink.small,
              ink.colour("foreground"), halo=back)


def around(middle: tuple[float, float], r: float, theta: float) -> tuple[float, float]:
    """theta from straight down, positive to the right."""
    return middle[0] + r * math.sin(theta), middle[1] + r * math.cos(theta)


def pieces(points: list[tuple[float, float]], line: str, width: float) -> list[list[tuple[float, float]]]:
    """A polyline as it is, or cut into dashes."""
    if line == "solid":
        return [points]
    steps = np.hypot(*np.diff(np.array(points), axis=0).T)
    at = np.concatenate([[0.0], np.cumsum(steps)])
    on = (at % (9 * width)) < 5 * width
    found: list[list[tuple[float, float]]] = []
    for i, point in enumerate(points):
        if on[i]:
            if i == 0 or not on[i - 1]:
                found.append([])
            found[-1].append(point)
    return [piece for piece in found if len(piece) > 1]


def mixed(ink: Ink, share: float) -> tuple[int, int, int]:
    a, b = ink.colour("background"), ink.colour("quiet")
    return tuple(round(p + (q - p) * share) for p, q in zip(a, b, strict=True))  # type: ignore[return-value]
