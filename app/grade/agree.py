"""When an answer is right: |y - f| <= a + 8 u (|f| + sum |x df/dx|), with what a sound way of computing may lose.

u is half the distance of 1 to the next number: 2^-53 in Python, 2^-24 in GLSL. Where the allowance passes a tenth of f
(a lobe of exponent 10^6), the answer may be off by that factor instead, has the right sign and is finite.
"""

from collections import OrderedDict
from collections.abc import Callable
from dataclasses import dataclass
from threading import Lock

import numpy as np

from app.grade.assignment import Task
from app.tolerance import FACTOR, TERMS, U, moved, norm

LANGUAGE = {"python": "float64", "glsl": "float32"}
WIDE = 0.1  # of f: beyond it the allowance is a factor
NOTHING = 1e-30  # below, float32 may have lost it on the way: finite and no larger is right
LARGEST = 2.0**127


@dataclass(frozen=True)
class Truth:
    """The right values of some rows, (N,) or (N, width), and how far an answer may lie off: absolutely, relatively."""

    value: np.ndarray
    absolute: np.ndarray  # (N,)
    relative: np.ndarray  # (N,)

    def part(self, rows) -> "Truth":
        return Truth(self.value[rows], self.absolute[rows], self.relative[rows])

    @property
    def size(self) -> np.ndarray:
        return norm(self.value, self.value.ndim > 1)

    @property
    def allowed(self) -> np.ndarray:
        return self.absolute + self.relative * self.size


class Memory:
    """What is right at the points of a question, kept: all students of a class are asked the same ones."""

    def __init__(self, most: int = 96):
        self.most, self.lock = most, Lock()
        self.kept: OrderedDict[tuple, tuple[dict, Truth, np.ndarray]] = OrderedDict()

    def known(self, task: Task, args: dict[str, np.ndarray], language: str) -> tuple[Truth, np.ndarray]:
        """`truth` and `trivial` at some rows."""
        key = id(args), task.function, task.own, task.absolute, task.powers, language
        with self.lock:
            if key in self.kept:
                self.kept.move_to_end(key)
                return self.kept[key][1:]
        right = truth(task, args, language)
        cheap = trivial(right, args)
        with self.lock:
            self.kept[key] = args, right, cheap  # the arguments too: as long as they live their id is theirs
            if len(self.kept) > self.most:
                self.kept.popitem(last=False)
        return right, cheap


MEMORY = Memory()


def truth(task: Task, args: dict[str, np.ndarray], language: str) -> Truth:
    """The reference at some rows, and what each is allowed."""
    f: Callable = task.reference
    u = U[LANGUAGE[language]]
    with np.errstate(all="ignore"):
        value = np.asarray(f(**args), float)
        vector = value.ndim > 1
        size = norm(value, vector)
        cost = size + np.nan_to_num(moved(f, args, vector), nan=0.0, posinf=LARGEST)
        if task.own is None and task.function in TERMS:
            cost = cost + TERMS[task.function](**args)
        for name in task.powers:
            cost = cost + np.abs(args[name]) * size
        relative = np.where(size > 0, FACTOR * u * cost / np.where(size > 0, size, 1), 0.0)
        absolute = FACTOR * u * (task.absolute + np.where(size > 0, 0.0, cost))
    return Truth(value, absolute, relative)


def agrees(known: Truth, given: np.ndarray) -> np.ndarray:
    """(N,) whether each answer is right. Written as accepting: a NaN agrees with nothing."""
    vector = known.value.ndim > 1
    size = known.size
    with np.errstate(all="ignore"):
        number = norm(given, vector)
        off = norm(given - known.value, vector)
        near = off <= known.allowed
        signed = np.sum(given * known.value, -1) if vector else given * known.value
        factor = np.abs(np.log(number) - np.log(size)) <= known.relative
        good = np.where(known.relative <= WIDE, near, (off <= known.absolute) | ((signed > 0) & factor))
        good = np.where(size < NOTHING, number <= np.maximum(NOTHING, known.absolute), good)
        finite = np.isfinite(given) if not vector else np.all(np.isfinite(given), -1)
        beyond = (size > LARGEST) & (signed > 0)
    return (good & finite) | beyond


def trivial(known: Truth, args: dict[str, np.ndarray]) -> np.ndarray:
    """(N,) the points that a constant or an argument handed back gets right, so that being right there says little."""
    value = known.value
    constants = [np.zeros_like(value), np.ones_like(value)]
    scalar = value if value.ndim == 1 else value[:, 0]
    common, counts = np.unique(scalar, return_counts=True)
    if len(common) and counts.max() > max(1, 0.02 * len(scalar)):
        constants.append(np.full_like(value, common[np.argmax(counts)]))
    echoes = [x for x in args.values() if np.shape(x) == value.shape]
    found = np.zeros(len(value), bool)
    for answer in (*constants, *echoes):
        found |= agrees(known, answer)
    return found


def off_by(known: Truth, given: np.ndarray) -> np.ndarray:
    """(N,) how far each answer lies off, in units of what it is allowed; infinite for what is no number."""
    vector = known.value.ndim > 1
    with np.errstate(all="ignore"):
        off = norm(given - known.value, vector)
        found = np.where(off == 0, 0.0, off / np.maximum(known.allowed, 1e-300))
    return np.where(np.isfinite(found), found, np.inf)
