"""The clock of a study: every method climbs its ladder, in turns, within a budget of time.

First the methods go up, always the one whose next rung costs least, so that all come about as far in time; each climbs
at least one. Who is exact to the last digits or does not find the lobe at all stops, and leaves its time to others.
Each rung is run for every angle and, where it is random, for several seeds, which gives its error. What is left of the
budget goes into further times of all points in turn, so that what disturbs the machine disturbs all. The first run of
each method warms it up and does not count.
"""

import itertools
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from time import perf_counter

import numpy as np

from app.lesson import Method, Study, Term
from app.plots.ticks import number
from app.quantities import TABLE, entered
from app.spoken import plain
from app.study.record import ENOUGH, Line, Point, Record, unnoticed
from app.study.rules import estimate, is_random, ladder
from app.terms import evaluate

REPEATS = 5
ADAPTIVE = 0.03  # s that an adaptive rule may take before it says anything
CLIMB = 0.75  # of the budget; the rest is for more times of each point
ROUNDING = 1e-12  # a method need not climb on where three rungs are below this
LOST, MANY = 0.5, 16384  # nor where three are above, the last with so many samples
Report = Callable[[], None]


@dataclass
class Climber:
    """A method on its way up."""

    method: Method
    line: Line
    rungs: list[int]
    seeds: int
    names: list[str]  # of the angles, where there are several
    spent: float = 0.0
    points: list[Point] = field(default_factory=list)

    @property
    def alive(self) -> bool:
        return bool(self.rungs) and not self.line.stopped


def measure(study: Study, values: dict, budget: float, seeds: int = 0, step: str = "", case: str = "",
            report: Report = lambda: None) -> Record:
    """The record of a study at values (radians), in about `budget` seconds."""
    angles = [seen(values | given) for given in worst(study)]
    exact = [reference(study, given) for given in angles]
    named = {words(given): value for given, value in zip(worst(study), exact, strict=True)}
    names = list(named) if len(named) > 1 else [""] * len(angles)
    seeds = seeds or max(4, 8 // len(angles))
    climbers = [climber(study, method, seeds, names) for method in study.methods]
    record = Record(step, study.title, case, {k: v for k, v in values.items() if isinstance(v, int | float)}, named,
                    [one.line for one in climbers], seeds=seeds, why=study.why, without=study.without)
    for one in climbers:
        if not one.method.rule.startswith("cubature"):  # dear, and it calls what the others call
            estimate(study, one.method, angles[0], one.rungs[0], 0)
    begin = perf_counter()
    end, climbing = begin + budget, begin + CLIMB * budget
    while alive := [one for one in climbers if one.alive]:
        one = min(alive, key=lambda one: expected(one, len(angles)))
        if perf_counter() + expected(one, len(angles)) > climbing:
            for late in alive:
                if not late.points:
                    climb(late, study, angles, exact)
                late.line.stopped = late.line.stopped or "the time was up"
            break
        climb(one, study, angles, exact)
        report()
    again(climbers, study, angles, end, report)
    record.seconds = perf_counter() - begin
    return record


def climber(study: Study, method: Method, seeds: int, names: list[str]) -> Climber:
    own = is_random(method)
    same = isinstance(study.exact, Term) and method.term == study.exact and not method.cost
    line = Line(method.label, reference=same, random=own)
    return Climber(method, line, list(ladder(method, study.over == "wavelengths")), seeds if own else 1, names)


def expected(one: Climber, angles: int) -> float:
    """How long the next rung takes, by the last two."""
    if not one.points:  # each has one, however little time there is
        return ADAPTIVE * angles if "cubature" in one.method.rule else 0.0
    last = one.points[-1]
    grown = 4.0 if one.method.cost == "level" or "cubature" in one.method.rule else one.rungs[0] / max(last.rung, 1)
    if len(one.points) > 1 and "cubature" not in one.method.rule:
        grown = min(grown, max(1.0, last.time / max(one.points[-2].time, 1e-9)) * 1.5)
    return last.time * grown * angles * one.seeds


def climb(one: Climber, study: Study, angles: list[dict], exact: list[float]) -> None:
    """The next rung: its error over angles and seeds, and its times."""
    rung = one.rungs.pop(0)
    errors, times, told, samples = [], [], [], 0
    for given, right, name in zip(angles, exact, one.names, strict=True):
        off = []
        for seed in range(one.seeds):
            start = perf_counter()
            with np.errstate(all="ignore"):
                now = estimate(study, one.method, given, rung, seed)
            times.append(perf_counter() - start)
            off.append(abs(now.value / right - 1))
            samples = max(samples, now.samples)
            if now.claim is not None:
                told.append((off[-1], now.claim, now.said, name))
        errors.append(float(np.sqrt(np.mean(np.square(off)))))
    error = max(errors) if np.isfinite(errors).all() else np.inf
    if one.points and samples == one.points[-1].samples and told:  # it had stopped there, and would only claim more
        return
    point = Point(rung, samples, error, times, *said(told, samples))
    one.points.append(point)
    one.line.points.append(point)
    one.line.stopped = verdict(one)


def said(told: list[tuple], samples: int) -> tuple:
    """What a method says of itself at a rung: of its estimates the one that fails silently and is most wrong, else the
    most careful. Each is judged by itself: one angle's "not converged" does not excuse another's "converged"."""
    if not told:
        return ()
    failed = [one for one in told if unnoticed(one[0], one[1], one[2], samples)]
    if failed:
        off, claim, words, name = max(failed)
        return claim, words, off, name
    unsure = [words for _, _, words, _ in told if words == "not_converged"]
    return max(claim for _, claim, _, _ in told), unsure[0] if unsure else told[0][2]


def verdict(one: Climber) -> str:
    """Why there is no use in climbing on; nothing where there is."""
    errors = [point.error for point in one.points]
    if errors[-1] < ENOUGH:
        return "nothing left to gain"
    if not one.line.random and len(errors) > 2 and max(errors[-3:]) < ROUNDING:
        return "nothing left but rounding"
    if len(errors) > 2 and min(errors[-3:]) > LOST and one.points[-1].samples >= MANY:
        return "it does not find it"
    return ""


def again(climbers: list[Climber], study: Study, angles: list[dict], end: float, report: Report) -> None:
    """More times for the points that have few, while the budget lasts."""
    for count in range(1, REPEATS):
        for one in climbers:
            for point in one.points:
                if len(point.times) > count or perf_counter() + point.time > end:
                    continue
                start = perf_counter()
                with np.errstate(all="ignore"):
                    estimate(study, one.method, angles[len(point.times) % len(angles)], point.rung, 0)
                point.times.append(perf_counter() - start)
        report()


def seen(values: dict) -> dict:
    """The values, with the cosine of the eye's angle."""
    return values | ({"n_dot_v": float(np.cos(values["theta_v"]))} if "theta_v" in values else {})


def reference(study: Study, values: dict) -> float:
    if isinstance(study.exact, float):
        return study.exact
    if isinstance(study.exact, str):
        return float(values[study.exact])
    if isinstance(study.exact, tuple):
        return sum(float(evaluate(term, values)) for term in study.exact)
    if isinstance(study.exact, Method):
        return estimate(study, study.exact, values, study.exact.ladder[0], 0).value
    return float(evaluate(study.exact, values))


def worst(study: Study) -> list[dict]:
    """The values over which an error is the worst, in radians."""
    names = study.worst
    return [{name: entered(name, value) for name, value in zip(names, one, strict=True)}
            for one in itertools.product(*names.values())]


def cases(study: Study, choices: dict[str, tuple[str, ...]] | None = None) -> Iterator[tuple[str, dict]]:
    """Each case in words and in radians; `choices` are the words of values that choose."""
    for given in study.cases:
        inner = {name: entered(name, value) for name, value in given.items()}
        yield words(inner, choices or {}), inner


def words(given: dict, choices: dict[str, tuple[str, ...]] | None = None) -> str:
    """θv = 46°, m = 0.1, or the name of what is chosen."""
    def one(name, value):
        if choices and name in choices:
            return choices[name][int(value)]
        q = TABLE[name]
        shown = f"{np.degrees(value):.3g}°" if q.is_angle else f"{number(value)} {q.screen_unit}".strip()
        return f"{plain(q.symbol)} = {shown}"

    return ", ".join(one(name, value) for name, value in given.items())
