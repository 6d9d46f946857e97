"""The numbers of a Curves plot: twins over a swept value, their errors, and a frame that keeps still. No drawing."""

import math
from dataclasses import dataclass, replace

import numpy as np

from app.edit import EDITED
from app.lesson import Curve, Curves
from app.plots.ticks import Axis, nice
from app.problem import Problem
from app.quantities import quantity, shown
from app.terms import bound, evaluate, is_yours

POINTS = 241
FLOOR = {"float64": 1e-17, "float32": 1e-10}  # where an error of 0 is drawn: below every rounding error


@dataclass
class Swept:
    """One curve: its values over the sweep and at the present value, in the units of the picture."""

    curve: Curve
    y: np.ndarray
    now: float
    not_finite: np.ndarray  # of the sweep
    not_positive: int = 0  # that a logarithmic axis cannot show
    cut: float = 0.0  # the largest value, where the plot's axis ends below it


class Sweep:
    def __init__(self, plot: Curves, ranges: dict):
        self.plot, self.q = plot, quantity(plot.sweep)
        low, high = ranges.get(plot.sweep, (self.q.low, self.q.high))[:2]
        log = (plot.x_scale or self.q.scale) == "log"
        if log and not low > 0:
            low = high * 1e-6
        x = np.geomspace(low, high, POINTS) if log else np.linspace(low, high, POINTS)
        x[0], x[-1] = low, high
        self.x = np.unique(np.round(x)).astype(int) if self.q.kind == "int" else x
        self.axis = Axis(float(shown(plot.sweep, low)), float(shown(plot.sweep, high)), log,  # type: ignore[arg-type]
                         degrees=self.q.is_angle, whole=self.q.kind == "int")
        self.exact = next((i for i, c in enumerate(plot.curves) if c.role == "exact"), None)
        if plot.error and self.exact is None:
            raise Problem(f"the plot {plot.title!r} shows errors and has no exact curve to take them against.")
        drawn = [c for c in plot.curves if c.precision == "float64"]
        if plot.error:
            drawn = [c for i, c in enumerate(plot.curves) if i != self.exact and c.precision == "float64"]
        self.floor = FLOOR["float64" if drawn else "float32"]
        self.frame: Axis | None = None
        self.kept: dict = {}

    def run(self, values: dict) -> list[Swept]:
        """The drawn curves at the present values of everything else."""
        raw = [self.over(i, curve, values) for i, curve in enumerate(self.plot.curves)]
        present = self.x.dtype.type(values[self.plot.sweep])
        now = [float(self.at(curve, values, np.array([present]))[0]) for curve in self.plot.curves]
        drawn = []
        for i, curve in enumerate(self.plot.curves):
            y, here = raw[i], now[i]
            if self.plot.error and self.exact is not None:
                if i == self.exact:
                    continue
                y, here = error(y, raw[self.exact]), float(error(np.array([here]), np.array([now[self.exact]]))[0])
                y, here = np.fmax(y, self.floor, where=np.isfinite(y), out=y), max(here, self.floor)
            bad = ~np.isfinite(y)
            drawn.append(Swept(curve, y, here, bad, int(np.sum(y[~bad] <= 0)) if self.log else 0))
        return [cut(one, self.plot.most) for one in drawn] if self.plot.most and not self.log else drawn

    def over(self, index: int, curve: Curve, values: dict) -> np.ndarray:
        """A curve over the whole sweep; kept while only the swept value moves."""
        args = bound(curve.term, {**values, self.plot.sweep: None})
        key = {k: v.tobytes() if isinstance(v, np.ndarray) else v for k, v in args.items()}
        if is_yours(curve.term, values):
            key[EDITED] = values[EDITED]
        if index not in self.kept or self.kept[index][0] != key:
            self.kept[index] = key, self.at(curve, values, self.x)
        return self.kept[index][1]

    def at(self, curve: Curve, values: dict, x: np.ndarray) -> np.ndarray:
        with np.errstate(all="ignore"):  # what is not finite is counted and shown
            y = evaluate(curve.term, values, curve.precision, **{self.plot.sweep: x})
        return np.broadcast_to(np.asarray(y, float), x.shape).copy()

    @property
    def log(self) -> bool:
        return self.plot.error or self.plot.y_scale == "log"

    def framed(self, drawn: list[Swept]) -> Axis:
        """The vertical axis: as it is, unless a curve leaves it or has shrunk to a fraction of it."""
        seen = np.concatenate([s.y[np.isfinite(s.y)] for s in drawn] or [np.zeros(0)])
        if self.log:
            seen = seen[seen > 0]
        fresh = self.log_frame(seen) if self.log else linear_frame(seen)
        if self.frame is None or not self.holds(seen) or span(fresh) < 0.3 * span(self.frame):
            self.frame = fresh
        return self.frame

    def holds(self, seen: np.ndarray) -> bool:
        if self.frame is None or not seen.size:
            return self.frame is not None
        slack = 0.0 if self.log else 1e-9 * span(self.frame)
        return bool(seen.min() >= self.frame.low - slack and seen.max() <= self.frame.high + slack)

    def log_frame(self, seen: np.ndarray) -> Axis:
        if not seen.size:
            return Axis(0.1, 10.0, log=True)
        high = math.ceil(math.log10(seen.max()))
        low = math.floor(math.log10(seen.min()))
        if self.plot.error:
            low, high = max(round(math.log10(self.floor)), low), max(0, high)
        return Axis(10.0 ** max(low, -300), 10.0 ** min(max(high, low + 1), 300), log=True)


def cut(one: Swept, most: float) -> Swept:
    """The curve without what is above the end of the axis; its first points beyond are drawn at the end."""
    above = one.y > most
    if not above.any():
        return one
    below = np.isfinite(one.y) & ~above
    beside = above & (np.pad(below, (1, 0))[:-1] | np.pad(below, (0, 1))[1:])
    y = np.where(beside, most, np.where(above, np.nan, one.y))
    return replace(one, y=y, now=one.now if one.now <= most else math.nan, cut=float(one.y[above & ~one.not_finite].max(
        initial=most)))


def error(y: np.ndarray, exact: np.ndarray) -> np.ndarray:
    """|f / f_exact - 1|, as a difference, which does not round again; equal values have no error, also 0 and 0."""
    with np.errstate(all="ignore"):
        return np.where(y == exact, 0.0, np.abs((y - exact) / exact))


def linear_frame(seen: np.ndarray) -> Axis:
    if not seen.size:
        return Axis(0.0, 1.0)
    low, high = float(seen.min()), float(seen.max())
    if low < 0 < high:
        return Axis(-nice(-low), nice(high))
    if low >= 0:
        return Axis(0.0, nice(high) if high > 0 else 1.0)
    return Axis(-nice(-low), 0.0)


def span(axis: Axis) -> float:
    low, high = axis.ends
    return high - low


def widened(axis: Axis, share: float) -> tuple[float, float]:
    """The ends of an axis with room for a whole dot beyond them."""
    low, high = axis.ends
    return low - share * (high - low), high + share * (high - low)
