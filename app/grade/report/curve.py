"""A curve through the worst point as SVG: the right values, the student's, and where they part."""

from html import escape
from itertools import groupby

import numpy as np

from app.grade.report.words import numbers
from app.grade.sweep import ends

WIDTH, HEIGHT = 560.0, 220.0  # of the part where values are
EDGE = 10.0  # of it above the highest and below the lowest
LEFT, TOP, BOTTOM, RIGHT = 92.0, 8.0, 50.0, 8.0


def svg(curve: dict) -> str:
    """'' where nothing can be drawn."""
    at, expected, got = (np.asarray(curve[name], float) for name in ("at", "expected", "got"))
    axis = ends(expected, got)
    if axis is None:
        return ""
    low, high, log = axis
    x = scaled(at, at[0], at[-1], curve["log"]) * WIDTH
    here = float(scaled(np.array([float(curve["here"])]), at[0], at[-1], curve["log"])[0] * WIDTH)
    worst = f'<path class="here" d="M{here:.1f} 0V{HEIGHT:g}"/>' if np.isfinite(here) else ""
    lines = dots = ""
    for name, values in (("right", expected), ("yours", got)):
        y = EDGE + (1 - scaled(values, low, high, log)) * (HEIGHT - 2 * EDGE)
        lines += f'<path class="{name}" d="{path(x, y)}"/>'
        level = float(np.interp(here, x, y))
        dots += f'<circle class="{name}" cx="{here:.1f}" cy="{level:.1f}" r="5"/>' if np.isfinite(level) else ""
    marks = "".join(text(-10, y + 5, "end", numbers(value, 3)) for y, value in ((EDGE, high), (HEIGHT - EDGE, low)))
    below = text(0, HEIGHT + 22, "start", numbers(float(at[0]), 3)) + text(
        WIDTH, HEIGHT + 22, "end", numbers(float(at[-1]), 3)) + text(
        WIDTH / 2, HEIGHT + 42, "middle", curve["label"] + (" (log)" if curve["log"] else ""), "title")
    box = f"{-LEFT:g} {-TOP:g} {LEFT + WIDTH + RIGHT:g} {TOP + HEIGHT + BOTTOM:g}"
    said = escape(f"The right values and yours against {curve['label']}, from {numbers(float(at[0]), 3)} to "
                  f"{numbers(float(at[-1]), 3)}")
    return (f'<svg class="curve" viewBox="{box}" role="img" aria-label="{said}">'
            f'<rect class="box" width="{WIDTH:g}" height="{HEIGHT:g}"/>'
            f'{worst}<svg width="{WIDTH:g}" height="{HEIGHT:g}">{lines}{dots}</svg>{marks}{below}</svg>')


def scaled(values: np.ndarray, low: float, high: float, log: bool) -> np.ndarray:
    """0 to 1 from low to high, a little beyond it outside; what has no place there is NaN."""
    with np.errstate(all="ignore"):
        share = np.log(values / low) / np.log(high / low) if log else (values - low) / (high - low)
    return np.where(np.isfinite(values), np.clip(share, -0.5, 1.5), np.nan)


def path(x: np.ndarray, y: np.ndarray) -> str:
    """The line, with gaps where there are no numbers; a number alone is a dot."""
    parts = []
    for drawn, run in groupby(zip(x, y, strict=True), lambda point: bool(np.isfinite(point[1]))):
        places = [f"{a:.1f} {b:.1f}" for a, b in run]
        if drawn:
            parts.append(f"M{places[0]}L{'L'.join(places[1:] or places)}")
    return "".join(parts)


def text(x: float, y: float, anchor: str, words: str, kind: str = "tick") -> str:
    return f'<text class="{kind}" x="{x:g}" y="{y:g}" text-anchor="{anchor}">{escape(words)}</text>'
