"""A plot through a point: one argument moves, the others stay; the right values and the student's."""

from dataclasses import dataclass

import numpy as np

from app.grade.assignment import Task
from app.grade.points import DIRECTIONS, as_float32
from app.grade.question import Language, Question
from app.quantities import TABLE, shown
from app.spoken import words

POINTS = 97


@dataclass(frozen=True)
class Plan:
    task: Task
    argument: str
    at: np.ndarray  # along the axis, in units of the screen
    label: str
    log: bool
    here: float  # where the worst point is
    question: Question


@dataclass(frozen=True)
class Sweep:
    """Values along an axis; of a colour or a vector the component that lies off farthest."""

    label: str
    at: np.ndarray
    log: bool  # the axis
    here: float
    expected: np.ndarray
    got: np.ndarray

    @property
    def ends(self) -> tuple[float, float, bool] | None:
        """The ends of the axis of values, and whether it is logarithmic; None where there is nothing to show."""
        return ends(self.expected, self.got)


def ends(right: np.ndarray, yours: np.ndarray) -> tuple[float, float, bool] | None:
    sound = right[np.isfinite(right)]
    if not len(sound):
        return None
    log = bool(np.all(sound > 0)) and float(np.percentile(sound, 90) / np.percentile(sound, 10)) > 1e3
    return *limits(sound, yours[np.isfinite(yours)], log), log


def limits(right: np.ndarray, yours: np.ndarray, log: bool) -> tuple[float, float]:
    """The ends of the axis: all right values, and the student's where they are not too far off."""
    low, high = float(right.min()), float(right.max())
    if log:
        low = max(low, high * 1e-12)
        near = yours[(yours >= low / 30) & (yours <= high * 30)]
    else:
        room = 4 * max(high - low, 0.25 * max(abs(high), abs(low)), 1e-300)
        near = yours[(yours >= low - room) & (yours <= high + room)]
    if len(near):
        low, high = min(low, float(near.min())), max(high, float(near.max()))
    return (low, high) if high > low else (low - 1.0, high + 1.0) if not log else (low / 2, low * 2)


def through(task: Task, args: dict, language: Language) -> Plan | None:
    """The sweep, of all arguments', along which the right value changes most."""
    plans = [plan for name in task.arguments if (plan := along(task, name, args, language))]
    if not plans:
        return None
    return max(plans, key=lambda plan: change(plan, task))


def change(plan: Plan, task: Task) -> float:
    with np.errstate(all="ignore"):
        value = flat(np.asarray(task.reference(**plan.question.args), float))
    value = value[np.isfinite(value)]
    size = np.max(np.abs(value), initial=0.0)
    # of a direction's sweep the shape is told at once; between equals the first argument wins
    return float(np.ptp(value) / size) if size > 0 else 0.0


def along(task: Task, name: str, args: dict, language: Language) -> Plan | None:
    here = np.asarray(args[name], float)
    if name in DIRECTIONS and name != "n" and "n" in args:
        return turned(task, name, args, language)
    if here.ndim or name not in TABLE:
        return None
    q, value = TABLE[name], float(here)
    low, high = min(q.low, value), max(q.high, value)
    log = (q.scale == "log" and low > 0) or (value > 0 and value < 0.02 * high and low >= 0)
    if log:
        low = min(low if low > 0 else value / 30, value / 3)
        at = np.geomspace(low, high, POINTS)
    else:
        at = np.linspace(low, high, POINTS)
    scale = float(shown(name, 1.0))  # type: ignore[arg-type]
    unit = q.screen_unit
    label = f"{words(name)}{f', {unit}' if unit else ''}"
    return plan(task, name, args, at, at * scale, label, log, value * scale, language)


def turned(task: Task, name: str, args: dict, language: Language) -> Plan | None:
    """A direction turned from the normal down to below the horizon, in its own plane."""
    n, d = (np.asarray(args[key], float) for key in ("n", name))
    n = n / np.sqrt(n @ n)
    side = d - (d @ n) * n
    if side @ side < 1e-12:
        side = np.cross(n, [1.0, 0.0, 0.0] if abs(n[0]) < 0.9 else [0.0, 1.0, 0.0])
    side = side / np.sqrt(side @ side)
    angle = np.radians(np.linspace(0, 110, POINTS))
    at = np.cos(angle)[:, None] * n + np.sin(angle)[:, None] * side
    here = float(np.degrees(np.arctan2(np.sqrt(max(d @ d - (d @ n) ** 2, 0)), d @ n)))
    return plan(task, name, args, at, np.degrees(angle), f"angle of {name} from n, °", False, here, language)


def plan(task: Task, name: str, args: dict, numbers, at, label: str, log: bool, here: float, language) -> Plan:
    full = {key: as_float32(numbers) if key == name else np.repeat(np.asarray([given], float), POINTS, 0)
            for key, given in args.items()}
    question = Question(f"{task.function}/sweep/{language}", task.function, language,
                        {key: full[key] for key in task.arguments}, task.width)
    return Plan(task, name, np.asarray(at), label, log, here, question)


def plotted(given: Plan, values: np.ndarray) -> Sweep:
    with np.errstate(all="ignore"):
        right = np.asarray(given.task.reference(**given.question.args), float)
    label, i = given.label, 0
    if right.ndim > 1:
        with np.errstate(all="ignore"):
            i = int(np.argmax(np.nanmax(np.where(np.isfinite(values), np.abs(values - right), -1.0), 0)))
        label = f"{'xyzw'[i]} of the answer, by {label}"
        right, values = right[:, i], values[:, i]
    return Sweep(label, given.at, given.log, given.here, right, values)


def flat(values: np.ndarray) -> np.ndarray:
    return values if values.ndim == 1 else np.sqrt(np.sum(values * values, -1))
