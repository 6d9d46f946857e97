"""The words on a scene: each at its point, inside the picture, beside the others and where there is least to cover."""

import math
from dataclasses import dataclass

import numpy as np
from PIL import Image, ImageDraw

from app.camera import project
from app.export.ink import Ink, length, write
from app.gpu.stage import Stage

Box = tuple[float, float, float, float]  # left, top, right, bottom
GREY = (0.299, 0.587, 0.114)
UNLIKE = 110  # of 255: colours that far apart can be read on each other
COARSE = 2  # px that clutter is looked at in
AROUND = [(math.cos(a), math.sin(a)) for a in np.arange(16) * math.pi / 8]


@dataclass(frozen=True)
class Word:
    text: str
    at: tuple[float, float]  # px
    colour: str
    ways: tuple[tuple[float, float], ...] = ()  # directions it would rather stand in; none: on its point
    gap: float = 0.55  # from its point, in text sizes


@dataclass(frozen=True)
class Placed:
    word: Word
    box: Box


class Clutter:
    """How much there is to see in a box of a picture: contrasts, and what is not background; 0 on the background."""

    def __init__(self, picture: Image.Image, background: tuple[int, int, int]):
        pixels = np.asarray(picture.reduce(COARSE), np.float32)
        grey = pixels @ np.array(GREY, np.float32)
        contrast = 0.12 * np.abs(grey - np.dot(background, GREY))
        contrast[:, 1:] += np.abs(np.diff(grey, axis=1))
        contrast[1:] += np.abs(np.diff(grey, axis=0))
        self.height, self.width = grey.shape
        self.sums = np.zeros((self.height + 1, self.width + 1, 4))
        np.cumsum(np.dstack([contrast, pixels]).cumsum(0), axis=1, out=self.sums[1:, 1:])

    def __call__(self, box: Box, ink: tuple[int, int, int] | None = None) -> float:
        """With the colour of what will stand there, it costs to be written on the like."""
        x0, x1 = (min(max(round(x / COARSE), 0), self.width) for x in (box[0], box[2]))
        y0, y1 = (min(max(round(y / COARSE), 0), self.height) for y in (box[1], box[3]))
        total = self.sums[y1, x1] - self.sums[y0, x1] - self.sums[y1, x0] + self.sums[y0, x0]
        mean = total / max(1, (x1 - x0) * (y1 - y0))
        like = max(0.0, 1 - np.abs(mean[1:] - ink).max() / UNLIKE) if ink else 0.0
        return float(mean[0]) + 40 * like


def words(stage: Stage, values: dict) -> list[Word]:
    """The labels of a scene and of its marks, in pixels of the stage's last picture; what lies outside has none."""
    found = []
    probes = stage.probes(values)
    for label in stage.scene.labels:
        if at := on_picture(stage, probes[label.probe, :3]):
            found.append(Word(label.text, at, label.colour))
    for i, mark in enumerate(stage.scene.marks):
        if not mark.label:
            continue
        ts = (mark.label_at, max(0.0, mark.label_at - 0.03), min(1.0, mark.label_at + 0.03))
        here, before, after = (on_picture(stage, point(stage, i, t, values)) for t in ts)
        if here:
            aside = ways(before or here, after or here, mark.label_at >= 1)
            found.append(Word(mark.label, here, mark.colour, aside, 0.55 if mark.tip == "none" else 0.9))
    return found


def point(stage: Stage, mark: int, t: float, values: dict) -> np.ndarray:
    given = {name: value for name, value in values.items() if not isinstance(value, np.ndarray)}
    return stage.transform("anchor", 1, mark=mark, mark_t=t, **given)[0, :3]


def on_picture(stage: Stage, world: np.ndarray) -> tuple[float, float] | None:
    x, y, w = project(np.asarray(world, float), stage.matrix)
    if not (np.isfinite([x, y, w]).all() and w > 0 and -0.02 <= x <= 1.02 and -0.02 <= y <= 1.02):
        return None
    return float(x) * stage.picture.size[0], float(y) * stage.picture.size[1]


def ways(before: tuple[float, float], after: tuple[float, float], at_end: bool) -> tuple[tuple[float, float], ...]:
    """Where a mark's label would rather stand: beyond its end, or on either side of it."""
    x, y = after[0] - before[0], after[1] - before[1]
    norm = math.hypot(x, y)
    if norm < 1e-3:
        return ((0.7, -0.7), (-0.7, -0.7), (0.7, 0.7), (-0.7, 0.7))
    x, y = x / norm, y / norm
    return ((x, y),) if at_end else ((y, -x), (-y, x))


def place(found: list[Word], clutter: Clutter, ink: Ink, frame: tuple[int, int], taken: list[Box]) -> list[Placed]:
    """A box for each word, the fixed ones first: inside the frame, off the taken boxes and off each other."""
    size = ink.text
    placed: list[Placed] = []
    points = [(w.at[0] - 4, w.at[1] - 4, w.at[0] + 4, w.at[1] + 4) for w in found]
    for i, word in sorted(enumerate(found), key=lambda pair: bool(pair[1].ways)):
        wide, high = length(word.text, size), 1.05 * size
        rest = [*taken, *(grown(p.box, 0.4 * size) for p in placed)]
        others = [p for j, p in enumerate(points) if j != i]
        best: tuple[float, Box] | None = None
        for first, x, y in candidates(word, wide, high, size):
            box = inside((x - wide / 2, y - high / 2, x + wide / 2, y + high / 2), frame, 0.35 * size)
            moved = math.hypot((box[0] + box[2]) / 2 - x, (box[1] + box[3]) / 2 - y) / size
            cost = first + 6 * moved + 1.5 * clutter(box, ink.colour(word.colour))
            cost += sum(400 * share(box, other) for other in rest) + sum(25 * share(box, other) for other in others)
            if best is None or cost < best[0]:
                best = cost, box
        assert best
        placed.append(Placed(word, best[1]))
    return placed


def candidates(word: Word, wide: float, high: float, size: int):
    """(cost, x, y of the middle): on the point for a word that is fixed, and around it."""
    x, y = word.at
    if not word.ways:
        yield 0.0, x, y
    for ring, gap in enumerate((word.gap, 2 * word.gap, 3.5 * word.gap)):
        for ax, ay in AROUND:
            turn = 1 - max((ax * wx + ay * wy for wx, wy in word.ways), default=0.0)
            cost = (10 * turn if word.ways else 12) + 8 * ring
            yield cost, x + ax * (wide / 2 + gap * size), y + ay * (high / 2 + gap * size)


def inside(box: Box, size: tuple[int, int], margin: float) -> Box:
    dx = max(0.0, margin - box[0]) - max(0.0, box[2] - size[0] + margin)
    dy = max(0.0, margin - box[1]) - max(0.0, box[3] - size[1] + margin)
    return box[0] + dx, box[1] + dy, box[2] + dx, box[3] + dy


def grown(box: Box, by: float) -> Box:
    return box[0] - by, box[1] - by / 2, box[2] + by, box[3] + by / 2


def share(a: Box, b: Box) -> float:
    """How much of the smaller box the other covers."""
    x, y = min(a[2], b[2]) - max(a[0], b[0]), min(a[3], b[3]) - max(a[1], b[1])
    if x <= 0 or y <= 0:
        return 0.0
    return x * y / max(1.0, min((a[2] - a[0]) * (a[3] - a[1]), (b[2] - b[0]) * (b[3] - b[1])))


def draw_words(picture: Image.Image, placed: list[Placed], ink: Ink) -> None:
    draw = ImageDraw.Draw(picture)
    for one in placed:
        left, _, _, bottom = one.box
        write(draw, (left, bottom - 0.24 * ink.text), one.word.text, ink.text, ink.colour(one.word.colour),
              halo=ink.colour("background"))
