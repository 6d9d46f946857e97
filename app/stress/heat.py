"""A twin's errors over each pair of its arguments, as one picture: the worst error of all points in a cell."""

import itertools

import numpy as np
from PIL import Image, ImageDraw

from app.colormaps import STOPS
from app.export.ink import Ink, fitted, length, write
from app.stress.grid import varying
from app.stress.judge import Finding
from app.theme import THEMES
from app.tolerance import FACTOR

CELL, GAP, RUNGS = 9, 16, 18  # px; the most rungs of an axis: beyond, neighbours share one
LEAST, MOST = FACTOR / 1e3, FACTOR * 1e6  # ends of the colours
THEME = THEMES["light"]
EMPTY, FAULT = (232, 232, 228), (213, 0, 143)


def heat_map(one: Finding) -> Image.Image | None:
    """Every pair of arguments that vary, the second downwards; a cell beyond the tolerance has a dot, a fault is filled
    with a colour of its own and crossed. One argument alone is a strip. None without an argument."""
    axes = {name: rungs(x) for name, x in varying(one.args).items()}
    axes = {name: axis for name, axis in axes.items() if len(axis[0]) > 1}
    names = list(axes)
    if not names:
        return None
    pairs = list(itertools.combinations(range(len(names)), 2)) or [(0, 0)]
    ink = Ink(THEME, (640, 360))
    side = CELL * RUNGS
    margin = round(max(length(name, ink.small) for name in names)) + 2 * GAP
    columns, rows = sorted({i for i, _ in pairs}), sorted({j for _, j in pairs})
    high = side if len(names) > 1 else 2 * CELL
    size = margin + len(columns) * (side + GAP) + GAP, GAP + len(rows) * (high + GAP) + 3 * ink.small
    picture = Image.new("RGB", size, ink.colour("background"))
    draw = ImageDraw.Draw(picture)
    for i, j in pairs:
        x, y = margin + columns.index(i) * (side + GAP), GAP + rows.index(j) * (high + GAP)
        picture.paste(panel(one.errors, axes[names[i]], axes[names[j]] if i != j else None), (x, y))
    for i in columns:
        x = margin + columns.index(i) * (side + GAP)
        ends(draw, axes[names[i]][0], names[i], (x, size[1] - 3 * ink.small + 2), side, ink)
    for j in rows if len(names) > 1 else ():
        y = GAP + rows.index(j) * (high + GAP)
        write(draw, (GAP, y + 0.5 * high), names[j], ink.small, ink.colour("foreground"))
        low, top = (brief(axes[names[j]][0][k]) for k in (0, -1))
        for text, at in ((low, y + 0.8 * ink.small), (top, y + high)):
            write(draw, (margin - GAP / 2 - length(text, 11), at), text, 11, ink.colour("quiet"))
    return picture


def ends(draw: ImageDraw.ImageDraw, rung: np.ndarray, name: str, at: tuple[float, float], side: int, ink: Ink) -> None:
    """An argument's name under its panels, and the ends of its axis."""
    x, y = at
    low, top = brief(rung[0]), brief(rung[-1])
    write(draw, (x, y + 0.7 * ink.small), low, 11, ink.colour("quiet"))
    write(draw, (x + side - length(top, 11), y + 0.7 * ink.small), top, 11, ink.colour("quiet"))
    write(draw, (x, y + 1.9 * ink.small), fitted(name, ink.small, side), ink.small, ink.colour("foreground"))


def brief(x: float) -> str:
    return f"{x:.3g}".replace("e-0", "e-").replace("e+0", "e").replace("e+", "e")


def rungs(x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The values of an axis in order, and which of them each point has; many values share a few places."""
    values, place = np.unique(x, return_inverse=True)
    if len(values) > RUNGS:
        cut = np.linspace(0, len(values) - 1, RUNGS).round().astype(int)
        place = np.searchsorted(cut, place, side="right") - 1
        values = values[cut]
    return values, place


def panel(errors: np.ndarray, across: tuple, down: tuple | None) -> Image.Image:
    """The worst error of each cell in colour."""
    rows = len(down[0]) if down else 1
    worst = np.full((rows, len(across[0])), -1.0)
    np.maximum.at(worst, (down[1] if down else np.zeros(len(errors), int), across[1]), errors)
    high = CELL * RUNGS if down else 2 * CELL
    wide = np.floor(np.linspace(0, CELL * RUNGS, worst.shape[1] + 1)).astype(int)
    tall = np.floor(np.linspace(0, high, rows + 1)).astype(int)
    cells = np.repeat(np.repeat(colours(worst), np.diff(tall), 0), np.diff(wide), 1)
    image = Image.fromarray(cells)
    draw = ImageDraw.Draw(image)
    for row, column in zip(*np.nonzero(worst > FACTOR), strict=True):
        box = wide[column] + 1, tall[row] + 1, wide[column + 1] - 2, tall[row + 1] - 2
        if np.isinf(worst[row, column]):
            draw.line(box, (255, 255, 255))
            draw.line((box[0], box[3], box[2], box[1]), (255, 255, 255))
        else:
            x, y = (box[0] + box[2]) / 2, (box[1] + box[3]) / 2
            draw.ellipse((x - 1, y - 1, x + 1, y + 1), (0, 0, 0) if worst[row, column] > 1e3 * FACTOR else (255,) * 3)
    return image


def colours(worst: np.ndarray) -> np.ndarray:
    """uint8 (rows, columns, 3): the theme's colours on a logarithmic scale."""
    with np.errstate(divide="ignore", invalid="ignore"):
        share = np.log(np.maximum(worst, LEAST) / LEAST) / np.log(MOST / LEAST)
    stops = np.asarray(STOPS[THEME.colormap], float)
    at = np.clip(np.nan_to_num(share, posinf=1.0), 0, 1) * (len(stops) - 1)
    found = np.stack([np.interp(at, np.arange(len(stops)), stops[:, k]) for k in range(3)], -1)
    found = np.round(255 * found).astype(np.uint8)
    found[worst < 0], found[np.isinf(worst)] = EMPTY, FAULT
    return found
