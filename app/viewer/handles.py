"""Dragging what the scene marks as draggable: find the values for which the handle's point follows the hand.

A handle says which values move its point; the point itself is the scene's own GLSL `probe`. A drag is a small damped
least-squares problem (Levenberg 1944; Marquardt 1963), solved in the picture's pixels, so that no handle needs a
mapping of its own and a page can do the same with the same few lines.
"""

import math
from collections.abc import Callable

import numpy as np

from app.quantities import TABLE

Limits = tuple[float, float, bool]  # low, high, on a log scale
STEPS, DAMPING, NEAR, LONGEST = 12, 1e-3, 0.25, 0.25  # near: pixels; longest step: of a slider


def to_slider(value: float, limits: Limits) -> float:
    """0 at the low end of the range, 1 at the high end, as the slider runs."""
    low, high, log = limits
    if log:
        return math.log(max(value, low) / low) / math.log(high / low)
    return (value - low) / (high - low)


def from_slider(place: float, limits: Limits) -> float:
    low, high, log = limits
    place = min(max(place, 0.0), 1.0)
    return low * (high / low) ** place if log else low + place * (high - low)


def flatten(values: dict, names: tuple[str, ...]) -> list[float]:
    flat: list[float] = []
    for name in names:
        value = values[name]
        flat += list(value) if isinstance(value, tuple) else [value]
    return flat


def rebuild(values: dict, names: tuple[str, ...], flat: list[float]) -> dict:
    """A copy of `values` with the named ones replaced by the flat numbers."""
    found, at = dict(values), 0
    for name in names:
        width = TABLE[name].width
        found[name] = tuple(flat[at : at + width]) if width > 1 else flat[at]
        at += width
    return found


def drag(
    values: dict,
    names: tuple[str, ...],
    limits: dict[str, Limits],
    to: np.ndarray,
    on_screen: Callable[[dict], np.ndarray],
) -> dict:
    """The values for which the handle lies nearest to the pixel `to`, within their ranges.

    on_screen(values) -> pixel (2,) of the handle's point. Starts from the present values, so the answer never jumps to
    another branch; where the point does not move on screen (seen end on), the damping holds the value still.
    """
    ranges = [limits[name] for name in names for _ in range(TABLE[name].width)]
    place = np.array([to_slider(v, r) for v, r in zip(flatten(values, names), ranges, strict=True)])

    def at(p: np.ndarray) -> dict:
        return rebuild(values, names, [from_slider(float(x), r) for x, r in zip(p, ranges, strict=True)])

    here, damping = on_screen(at(place)), DAMPING
    for _ in range(STEPS):
        miss = np.asarray(to) - here
        if np.hypot(*miss) < NEAR:
            break
        nudge = np.where(place > 0.5, -1e-3, 1e-3)
        slopes = np.stack(
            [(on_screen(at(place + np.eye(len(place))[i] * nudge[i])) - here) / nudge[i] for i in range(len(place))], -1
        )
        normal = slopes.T @ slopes
        while damping < 1e3:
            weight = damping * np.trace(normal) / len(place) + 1e-9
            step = np.linalg.solve(normal + weight * np.eye(len(place)), slopes.T @ miss)
            trial = np.clip(place + step * min(1.0, LONGEST / max(np.abs(step).max(), 1e-12)), 0, 1)
            there = on_screen(at(trial))
            if np.all(np.isfinite(there)) and np.hypot(*(to - there)) < np.hypot(*miss):
                place, here, damping = trial, there, damping / 10
                break
            damping *= 10  # too bold: a shorter step, more along the steepest descent
        else:
            break
    return at(place)
