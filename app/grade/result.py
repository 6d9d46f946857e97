"""What the judge found, as data: the judge's part of result.json. Numbers that are none become words."""

import math
from dataclasses import asdict, dataclass, field

import numpy as np

SCHEMA = "halfway-result-1"


@dataclass(frozen=True)
class Worst:
    """The point that lies off farthest."""

    args: dict[str, float | list[float]]
    got: float | list[float]
    expected: float | list[float]
    off: float  # in units of what is allowed


@dataclass(frozen=True)
class Figure:
    """A picture as (height, width, 3) bytes; a report makes a PNG of it."""

    label: str
    pixels: np.ndarray = field(hash=False, compare=False)


@dataclass(frozen=True)
class Test:
    """One line of a report: a region, a property, a picture or the speed of one function."""

    id: str  # function/region
    group: str  # points, property, image, runtime
    function: str
    region: str
    language: str
    visibility: str  # visible or hidden
    weight: float  # its share of the assignment's points
    score: float
    max: float
    verdict: str
    points: int = 0
    wrong: int = 0
    worst: Worst | None = None
    message_key: str = ""
    message: str = ""  # a sentence for the student
    help: str = ""
    requires: tuple[str, ...] = ()
    rationale: str = ""  # how the score came about
    figures: tuple[Figure, ...] = ()


@dataclass(frozen=True)
class Suspect:
    """A known misconception that a function's answers match."""

    id: str
    function: str
    message: str
    match: float  # share of the points where it clearly differs from the right answer


@dataclass(frozen=True)
class Result:
    """Of one submission."""

    assignment: str
    assignment_hash: str
    score: float
    max: float
    visible_score: float
    visible_max: float
    verdict: str
    tests: tuple[Test, ...]
    suspects: tuple[Suspect, ...]

    def as_json(self) -> dict:
        """Strict JSON: json.dumps(..., allow_nan=False) takes it."""
        return {"schema": SCHEMA, "assignment": {"id": self.assignment, "hash": self.assignment_hash},
                "score": number(self.score), "max": number(self.max), "visible_score": number(self.visible_score),
                "visible_max": number(self.visible_max), "verdict": self.verdict,
                "tests": [line(test) for test in self.tests],
                "misconceptions": [asdict(one) for one in self.suspects]}


def line(test: Test) -> dict:
    found = {name: getattr(test, name) for name in test.__dataclass_fields__ if name not in ("worst", "figures")}
    found["requires"] = list(test.requires)
    found["score"], found["max"], found["weight"] = number(test.score), number(test.max), number(test.weight)
    found["worst"] = None if test.worst is None else plain(asdict(test.worst))
    found["figures"] = [figure.label for figure in test.figures]
    return found


def plain(value):
    """Numbers that JSON has no word for, as words: nan, inf, -inf."""
    if isinstance(value, dict):
        return {name: plain(inner) for name, inner in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(inner) for inner in value]
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    return value


def number(value: float) -> float:
    """Points, to a millionth: the same on every machine and in every order of summing."""
    return round(float(value), 6) + 0.0
