"""What a study found: points of (N, error, time), and what follows from them: orders, times to a tolerance, winners."""

import math
from dataclasses import dataclass, field
from itertools import takewhile

import numpy as np

LEAST = 1e-16  # errors below are drawn there: no number in float64 can show less
ENOUGH = 3e-15  # errors below are nothing
TOLERANCES = (1e-2, 1e-3, 1e-6)
TOO_SURE = 10.0  # an error this many times above what a method says of itself is a silent failure

FEW = 256  # samples; fewer that all miss surprise nobody


def unnoticed(error: float, claim: float | None, said: str, samples: int) -> bool:
    """Whether one estimate is wrong and does not know: it says converged, or that its error is nothing."""
    if claim is None or said == "not_converged" or error <= 1e-3:
        return False
    return error > TOO_SURE * claim and (bool(said) or (claim < 1e-9 and samples >= FEW))


@dataclass
class Point:
    """A method at one rung of its ladder. The error is relative: RMS over the seeds, the worst of the angles."""

    rung: int
    samples: int
    error: float
    times: list[float] = field(default_factory=list)  # s, one evaluation each
    claim: float | None = None  # the error the method says it has
    said: str = ""
    off: float | None = None  # of the estimate that says so, where one of several fails silently
    at: str = ""  # the angle of that estimate, where there are several

    @property
    def time(self) -> float:
        return float(np.median(self.times))

    @property
    def spread(self) -> tuple[float, float]:
        """The quartiles of the time."""
        low, high = np.percentile(self.times, (25, 75))
        return float(low), float(high)

    @property
    def silent(self) -> bool:
        """Wrong, and it does not know. One estimate of several is enough: the others do not make it right."""
        return unnoticed(self.wrong, self.claim, self.said, self.samples)

    @property
    def wrong(self) -> float:
        return self.error if self.off is None else self.off

    @property
    def words(self) -> str:
        """How it fails, in a few words."""
        how = self.said.replace("_", " ") or "standard error 0"
        return f"{how}, but {percent(self.wrong)} off" + (f" at {self.at}" if self.at else "")


@dataclass
class Line:
    """A method's points, in the order of their cost. The reference is the exact value itself, of error 0."""

    label: str
    points: list[Point] = field(default_factory=list)
    reference: bool = False
    random: bool = False
    stopped: str = ""  # why it did not climb on

    def reach(self, tolerance: float) -> Point | None:
        """The fastest rung of those from which on every error is at most the tolerance; None where it did not reach.

        Times waver: of two rungs that both are there the dearer may have been measured as the faster."""
        kept = takewhile(lambda point: point.error <= tolerance, reversed(self.points))
        return min(kept, key=lambda point: point.time, default=None)

    @property
    def order(self) -> tuple[float, float] | None:
        """p of error ~ N^-p, and its standard error: the fit of log error, above rounding."""
        seen = [(p.samples, p.error) for p in self.points if 1e-13 < p.error < 0.9 and p.samples >= 16]
        if len(seen) < 3 or self.reference:
            return None
        return slope(*np.log(np.array(seen)).T)

    @property
    def exponential(self) -> bool:
        """Whether the error falls as r^sqrt(N), N being k x k, rather than as a power: that line lies nearer."""
        seen = [(p.samples, p.error) for p in self.points if 1e-13 < p.error < 0.9]
        if len(seen) < 4 or self.random or self.order is None or self.order[0] < 2:
            return False
        n, error = np.array(seen, float).T
        (_, as_power), (_, as_exponent) = slope(np.log(n), np.log(error)), slope(np.sqrt(n), np.log(error))
        return bool(as_exponent * np.std(np.sqrt(n)) < as_power * np.std(np.log(n)))

    @property
    def silent(self) -> list[Point]:
        return [point for point in self.points if point.silent]


@dataclass
class Record:
    """A study at one of its cases."""

    step: str
    title: str
    case: str
    values: dict
    exact: dict[str, float]  # at each of the angles the error is the worst of
    lines: list[Line]
    seconds: float = 0.0
    seeds: int = 1
    where: str = "CPU"
    why: str = ""
    without: dict[str, str] = field(default_factory=dict)  # methods that are left out, and why

    def winner(self, tolerance: float) -> tuple[Line, Point] | None:
        """The method that is there first; the reference does not compete, it is what the others are measured by."""
        there = [(line, point) for line in self.lines if not line.reference and (point := line.reach(tolerance))]
        return min(there, key=lambda found: found[1].time, default=None)

    def beside(self, tolerance: float) -> list[Line]:
        """The methods that may be as fast: their quartiles overlap with the winner's."""
        winner = self.winner(tolerance)
        if winner is None:
            return []
        first, at = winner
        return [line for line in self.lines if line is not first and not line.reference
                and (point := line.reach(tolerance)) and point.spread[0] <= at.spread[1]]

    @property
    def name(self) -> str:
        return ", ".join(filter(None, (self.step, self.case, "" if self.where == "CPU" else self.where)))


def slope(x: np.ndarray, y: np.ndarray) -> tuple[float, float]:
    """-dy/dx of a straight line through the points, and its standard error."""
    across = x - x.mean()
    p = float(across @ y / (across @ across))
    rest = y - y.mean() - p * across
    return -p, math.sqrt(float(rest @ rest) / max(1, len(x) - 2) / float(across @ across))


def percent(error: float) -> str:
    if not math.isfinite(error):
        return "not a number"
    return f"{100 * error:.3g} %" if error < 100 else f"{error:.3g} times"
