"""A study as a picture: error over time, both in powers of ten, a line of dots for each method. Pillow draws it alone.

Magenta crosses are silent failures: the method is wrong and says that it is right. Below stands why the winner wins.
"""

from dataclasses import replace

import numpy as np
from PIL import Image, ImageDraw

from app.lesson import Camera, Method, Number, Study
from app.plots.dots import rimmed, stamp
from app.plots.look import Look, Rgb, bytes3
from app.plots.ticks import Axis, power
from app.plots.wire import Spot
from app.plots.words import FINE, SHAPES, Entry, dot_size, font, header, line_of_words, wrapped
from app.study.measure import measure
from app.study.names import inputs
from app.study.record import ENOUGH, LEAST, TOLERANCES, Line, Point, Record, percent
from app.theme import Theme

INKS = ("estimate", "l", "v", "h", "r", "g", "n")
SILENT = 1.0, 0.18, 0.82  # magenta, as what is not finite
SILENT_BYTES = bytes3(SILENT)
HIGHEST = 100.0  # relative errors above are drawn there
LIVE = {False: 0.35, True: 2.0}  # s for a study beside a lesson: while something moves, and when the hand rests
KEPT: dict[tuple, tuple[float, Record]] = {}  # the latest studies, and the time they had
MOST_KEPT = 32


class EffortsPart:
    """A study in the plots' process: it measures and draws; `record` holds what was measured for these values."""

    def __init__(self, plot: Study, look: Look):
        self.plot, self.look = plot, look
        self.record: Record | None = None
        self.values: dict = {}
        self.spots: list[Spot] = []

    @property
    def entries(self) -> list[Entry]:
        return []  # a legend of its own, denser

    def footer(self) -> None:
        return None

    def measure(self, values: dict, fine: bool) -> None:
        """The study at the step's own values, at once or, while the hand rests, with more time; kept for both."""
        study = replace(self.plot, worst={})
        key = study.title, tuple(sorted((name, np.asarray(values[name]).tobytes()) for name in inputs(study)
                                         if name in values))
        known = KEPT.get(key)
        if known is None or (fine and known[0] < LIVE[fine]):
            known = KEPT[key] = LIVE[fine], measure(study, values, LIVE[fine])
            while len(KEPT) > MOST_KEPT:
                del KEPT[next(iter(KEPT))]
        self.record = known[1]

    def build(self, plotter, values: dict) -> None:
        pass

    def update(self, values: dict, camera: Camera | None) -> list[str]:
        self.values = values
        return []

    def overlay(self, picture: np.ndarray) -> np.ndarray:
        if self.record is None:
            return picture
        drawn, self.spots = chart(self.plot, self.record, self.look, picture.shape[:2], self.values)
        return drawn


def whole(study: Study, record: Record, size: tuple[int, int], theme: Theme) -> Image.Image:
    """The picture of a record by itself, with title and legend; loads no VTK."""
    look = Look(theme, size)
    title = f"{study.title}: {record.case}" if record.case else study.title
    head = header(look, title + (" (GPU)" if record.where != "CPU" else ""), [])
    drawn, _ = chart(study, record, look, (size[1] - len(head), size[0]), {})
    return Image.fromarray(np.concatenate([head, drawn]))


def mark(index: int, look: Look) -> tuple[str, Rgb]:
    """Shape and colour of the method of this number: no two have both in common."""
    return SHAPES[(index + 2 * (index // len(INKS))) % len(SHAPES)], look.colour(INKS[index % len(INKS)])


def chart(study: Study, record: Record, look: Look, size: tuple[int, int], values: dict
          ) -> tuple[np.ndarray, list[Spot]]:
    """(height, width) of it, and where its points are, from the top of this part."""
    height, width = size
    above, below, compact = around(study, record, look, height)
    tall = max(40, height - len(above) - len(below))
    canvas = np.full((tall, width, 3), np.round(255 * np.array(look.background)), np.uint8)
    across, up = axes(record)
    em = look.small
    left, right, top, bottom = round(3.4 * em), width - em, round(0.6 * em), tall - round(1.7 * em)

    def place(x, y) -> np.ndarray:
        (a, b), (c, d) = across.ends, up.ends
        return np.stack([left + (across.place(x) - a) / (b - a) * (right - left),
                         bottom - (up.place(np.clip(y, up.low, up.high)) - c) / (d - c) * (bottom - top)], -1)

    canvas = ground(canvas, look, across, up, (left, right, top, bottom))
    lines = [(line, *mark(index_of(study, line), look)) for line in record.lines if line.points]
    canvas = strokes(canvas, look, lines, place)
    if compact:  # below the points
        canvas = named(canvas, look, record, lines, place, (left, right, top, bottom))
    spots = []
    for line, shape, colour in lines:
        at = place([p.time for p in line.points], [shown(line, p) for p in line.points])
        stamp(canvas, at, dot_size(look) * 1.25, colour, shape)
        bad = np.array([p.silent for p in line.points])
        stamp(canvas, at[bad], dot_size(look) * 2.2, SILENT, "cross")
        for point, (x, y) in zip(line.points, at, strict=True):
            sets = chosen(study.methods[index_of(study, line)], point)
            if sets and all(values.get(name) == value for name, value in sets.items()):
                rimmed(canvas, np.array([[x, y]]), 1.9 * dot_size(look), colour, look.foreground, 1.5 * look.scale)
            spots.append(Spot(float(x), float(y) + len(above), told(line, point), sets))
    return np.concatenate([above, canvas, below])[:height], spots


def around(study: Study, record: Record, look: Look, height: int) -> tuple[np.ndarray, np.ndarray, bool]:
    """Words above and below. Where they leave too little room why the winner wins goes first, then the legend: then
    names stand at the lines that matter."""
    above, nothing = legend(study, record, look), np.zeros((0, look.size[0], 3), np.uint8)
    for below in (foot(study, record, look), foot(study, record, look, brief=True)):
        if height - len(above) - len(below) >= max(0.45 * height, 11 * look.small):
            return above, below, False
    return line_of_words(look, "relative error, over time"), nothing, True


def named(canvas: np.ndarray, look: Look, record: Record, lines: list, place, box: tuple[int, int, int, int]
          ) -> np.ndarray:
    """The names of the first at each tolerance, of the most exact, the exact value and what fails silently."""
    first = [found[0] for tolerance in TOLERANCES if (found := record.winner(tolerance))]
    first.append(min((found[0] for found in lines), key=lambda line: min(p.error for p in line.points)))
    kept = [found for found in lines if found[0] in first or found[0].reference or found[0].silent]
    kept += [found for found in lines if found not in kept][:max(0, 2 - len(kept))]
    image, letters = Image.fromarray(canvas), font(look, look.small)
    points = np.concatenate([place([p.time for p in line.points], [shown(line, p) for p in line.points])
                             for line, _, _ in lines])
    taken: list[tuple[float, float, float]] = []
    draw = ImageDraw.Draw(image)
    for line, _, colour in sorted(kept[:5], key=lambda found: found[0].points[-1].error):
        last = line.points[-1]
        at, = place([last.time], [shown(line, last)])
        wide = letters.getlength(line.label)
        x, y = clear(at, wide, look.small, box, points, taken)
        taken.append((x, x + wide, y))
        draw.text((x, y), line.label, SILENT_BYTES if line.silent else bytes3(colour), letters, "lm",
                  stroke_width=round(2 * look.scale), stroke_fill=bytes3(look.background))
    return np.array(image)


def clear(at: np.ndarray, wide: float, em: float, box: tuple[int, int, int, int], points: np.ndarray,
          taken: list[tuple[float, float, float]]) -> tuple[float, float]:
    """Where a name of a point stands, beside it: on as few points and names as may be, and near."""
    left, right, top, bottom = box
    high, gap = 1.05 * em, 0.7 * em

    def crowded(place: tuple[float, float]) -> float:
        x, y = place
        covered = (abs(points[:, 0] - x - wide / 2) < wide / 2 + 0.3 * em) & (abs(points[:, 1] - y) < 0.75 * high)
        names = sum(abs(y - v) < high and x < b and a < x + wide for a, b, v in taken)
        return float(covered.sum()) + 20 * names + 0.5 * abs(y - at[1]) / high

    sides = [x for x in (at[0] + gap, at[0] - gap - wide) if left < x < right - wide] or [right - wide]
    rows = (min(max(at[1] + k * high, top + 0.6 * high), bottom - 0.6 * high) for k in (0, -1, 1, -2, 2))
    return min(((x, y) for y in rows for x in sides), key=crowded)


def legend(study: Study, record: Record, look: Look) -> np.ndarray:
    """A mark and a name for each method, in rows; and what the axis upwards is."""
    gap, high, em = round(0.5 * look.text), round(1.25 * look.small), look.small
    letters = font(look, look.small)
    rows: list[list[tuple[float, int]]] = [[]]
    x = float(gap)
    for i, method in enumerate(study.methods):
        wide = 1.1 * em + letters.getlength(method.label) + 0.7 * em
        if rows[-1] and x + wide > look.size[0]:
            rows.append([])
            x = float(gap)
        rows[-1].append((x, i))
        x += wide
    picture = Image.new("RGB", (look.size[0], high * (len(rows) + 1) + gap // 2), bytes3(look.background))
    draw = ImageDraw.Draw(picture)
    for k, row in enumerate(rows):
        for x, i in row:
            draw.text((x + 1.1 * em, (k + 0.5) * high), study.methods[i].label, bytes3(look.foreground), letters, "lm")
    words = "relative error, the worst of " + ", ".join(record.exact) if len(record.exact) > 1 else "relative error"
    fits = wrapped(look, words, look.small, look.size[0] - 2 * gap)[:1]
    draw.text((gap, (len(rows) + 0.6) * high), fits[0], bytes3(look.quiet), letters, "lm")
    strip = np.array(picture)
    for k, row in enumerate(rows):
        for x, i in row:
            shape, colour = mark(i, look)
            stamp(strip, np.array([[x + 0.4 * em, (k + 0.5) * high]]), dot_size(look) * 1.25, colour, shape)
    return strip


def index_of(study: Study, line: Line) -> int:
    return [method.label for method in study.methods].index(line.label)


def shown(line: Line, point: Point) -> float:
    return max(point.error, LEAST) if np.isfinite(point.error) else HIGHEST


def axes(record: Record) -> tuple[Axis, Axis]:
    """Whole powers of ten around all points and tolerances."""
    times = [time for line in record.lines for p in line.points for time in p.spread] or [1e-4, 1e-2]
    errors = [min(shown(line, p), HIGHEST) for line in record.lines for p in line.points
              if not (line.reference and p.error < ENOUGH)]  # the exact value stands on the ground, wherever that is
    errors = [*errors, TOLERANCES[-1]] if errors else [1e-3, 1.0]

    def decades(low: float, high: float) -> Axis:
        first, last = np.floor(np.log10(low) - 0.05), np.ceil(np.log10(high) + 0.05)
        return Axis(10.0**first, 10.0 ** max(last, first + 1), log=True)

    return decades(min(times), max(times)), decades(min(errors), max(errors))


def ground(canvas: np.ndarray, look: Look, across: Axis, up: Axis, box: tuple[int, int, int, int]) -> np.ndarray:
    """Grid, ticks and their words; the tolerances a table asks for are drawn stronger."""
    left, right, top, bottom = box
    image = Image.fromarray(canvas)
    draw, letters, ink = ImageDraw.Draw(image), font(look, look.small), bytes3(look.foreground)
    thin = max(1, round(look.line / 2))
    (x0, x1), (y0, y1) = across.ends, up.ends
    free = 0.0  # where the last word ended
    for k in range(round(x0), round(x1) + 1):
        x = left + (k - x0) / (x1 - x0) * (right - left)
        draw.line((x, top, x, bottom), bytes3(look.grid), thin)
        wide = letters.getlength(lasting(k))
        begin = min(x - wide / 2, right + 0.8 * look.small - wide)
        if begin >= free:
            draw.text((begin, bottom + 0.35 * look.small), lasting(k), ink, letters, "la")
            free = begin + wide + 0.5 * look.small
    stride = max(1, round((y1 - y0) / max(2, (bottom - top) / (2.2 * look.small)) + 0.49))
    for k in range(round(y0), round(y1) + 1):
        y = bottom - (k - y0) / (y1 - y0) * (bottom - top)
        strong = 10.0**k in TOLERANCES
        if k % stride == 0 or strong:
            draw.line((left, y, right, y), bytes3(look.quiet if strong else look.grid), thin)
        if k % stride == 0:
            draw.text((left - 0.4 * look.small, y), power(k) if k else "1", ink, letters, anchor="rm")
    return np.array(image)


def lasting(k: int) -> str:
    """10^k s, in the unit one says it in."""
    unit, base = ("µs", -6) if k < -3 else ("ms", -3) if k < 0 else ("s", 0)
    return f"{10 ** (k - base)} {unit}" if k >= -6 else f"{10.0 ** (k + 6):g} µs"


def strokes(canvas: np.ndarray, look: Look, lines: list, place) -> np.ndarray:
    """The lines between a method's points, and the quartiles of each time; drawn large and reduced."""
    height, width = canvas.shape[:2]
    fine = FINE if height < 500 else FINE // 2  # a large picture has lines enough pixels wide
    big = Image.fromarray(canvas).resize((fine * width, fine * height), Image.Resampling.NEAREST)
    draw = ImageDraw.Draw(big)
    thick = max(1, round(0.55 * fine * look.line))
    for line, _, colour in lines:
        ink = bytes3(colour)
        errors = [shown(line, p) for p in line.points]
        at = fine * place([p.time for p in line.points], errors)
        if len(at) > 1:
            draw.line([tuple(p) for p in at], ink, thick, joint="curve")
        for point, error in zip(line.points, errors, strict=True):
            (x0, y), (x1, _) = fine * place(list(point.spread), [error, error])
            draw.line((x0, y, x1, y), ink, thick)
    return np.array(big.reduce(fine))


def foot(study: Study, record: Record, look: Look, brief: bool = False) -> np.ndarray:
    """What the axis is, what failed silently, and (unless brief) why the winner wins."""
    failed = silent_words(record)
    gap, high = round(0.5 * look.text), round(1.3 * look.small)
    room = look.size[0] - 2 * gap
    rows = [("time of one estimate" if record.where == "CPU" else "time of one frame", look.foreground)]
    rows += [(row, SILENT) for text in failed[:1 if brief else 2] for row in wrapped(look, text, look.small, room)]
    rows += [(row, look.quiet) for row in wrapped(look, study.why, look.small, room) if not brief]
    picture = Image.new("RGB", (look.size[0], high * len(rows) + gap), bytes3(look.background))
    draw = ImageDraw.Draw(picture)
    for i, (text, colour) in enumerate(rows):
        x, anchor = (look.size[0] / 2, "mm") if i == 0 else (gap, "lm")
        draw.text((x, (i + 0.5) * high), text, bytes3(colour), font(look, look.small), anchor=anchor)
    return np.asarray(picture)


def silent_words(record: Record) -> list[str]:
    """Which methods fail silently, and how: who says converged before who sees no spread."""
    found: dict[str, list[str]] = {}
    for line in record.lines:
        if line.silent:
            found.setdefault(max(line.silent, key=lambda point: point.wrong).words, []).append(line.label)
    told = sorted(found.items(), key=lambda one: not one[0].startswith("converged"))
    return [f"× {'; '.join(labels)}: {words}" for words, labels in told]


def chosen(method: Method, point: Point) -> dict[str, Number]:
    """What a click on a point sets: the numbers the method gives its twin, and its cost; or what the lesson says."""
    if method.term is not None and method.cost:
        given = {k: v for k, v in method.term.args.items() if not isinstance(v, str)}
        return {**given, method.cost: point.rung}
    spent: dict[Number | str, Number] = {"N": point.samples, "rung": point.rung}
    return {name: spent[value] if isinstance(value, str) else value for name, value in method.sets.items()}


def told(line: Line, point: Point) -> str:
    from app.readouts import duration

    what = "the exact value" if line.reference else f"{point.samples} samples, {percent(point.error)} off"
    wrong = f"\n{point.words}" if point.silent else ""
    return f"{line.label}: {what}\n{duration(1e3 * point.time)} an estimate{wrong}"
