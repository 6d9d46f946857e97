"""A twin over its extremes: three forms of it, each against a better one, with what is wrong counted."""

from dataclasses import dataclass, field

import numpy as np

from app.optics import names, twin
from app.shader import catalogue
from app.stress import energy, golden
from app.stress.copies import EXTENDED, twin_of
from app.stress.domain import COUNTED
from app.stress.energy import Albedo
from app.stress.grid import points
from app.stress.paste import line
from app.stress.ranges import bounds, kind, right_of, stable_of
from app.tolerance import FACTOR, LARGEST, U, closed_form_terms, cost, off

GLSL, NUMPY32, NUMPY64 = "GLSL float32", "numpy float32", "numpy float64"
SHIPPED = (GLSL, NUMPY64)  # what the course computes with; float32 numpy shows what the formula alone is worth
SMALLEST32 = 2.0**-126  # below, float32 has fewer digits, and OpenGL may take it for 0
EXAMPLES = 3


@dataclass(frozen=True)
class Form:
    """One form of a twin against its judge; errors in units of u (1 + cond + kappa), 8 are allowed."""

    name: str
    judge: str
    nan: int
    infinite: int
    negative: int
    outside: int
    beyond: int
    worst: float
    errors: np.ndarray = field(repr=False, compare=False)  # infinite where a fault is counted
    got: np.ndarray = field(repr=False, compare=False)
    true: np.ndarray = field(repr=False, compare=False)

    @property
    def fails(self) -> bool:
        return bool(self.nan or self.infinite or self.negative or self.outside or self.beyond)


@dataclass(frozen=True)
class Example:
    """A point where a form is off, to be pasted."""

    form: str
    error: float
    got: list | float
    true: list | float
    paste: str


@dataclass(frozen=True)
class Finding:
    function: str
    file: str
    kind: str
    against: str  # the stable form of a naive or printed one
    points: int
    forms: tuple[Form, ...]
    stored: tuple[int, float, float] | None  # golden records, their worst errors in float64 and float32
    albedo: Albedo | None  # the largest of a BRDF
    differs: float | None  # a printed formula from the right one, relative
    args: dict = field(repr=False, compare=False)

    @property
    def fails(self) -> bool:
        """Whether it has a fault that it may not have."""
        stored = self.stored is not None and max(self.stored[1:]) > FACTOR
        shipped = any(form.fails for form in self.forms if form.name in SHIPPED)
        gains = self.albedo is not None and self.albedo.gains and not self.albedo.allowed
        return self.kind == "stable" and (stored or shipped or gains)

    @property
    def errors(self) -> np.ndarray:
        """The worse of the shipped forms at each point."""
        return np.max([form.errors for form in self.forms if form.name in SHIPPED], 0)

    @property
    def examples(self) -> tuple[Example, ...]:
        """The worst points, each different, of the forms that fail."""
        found: dict[str, Example] = {}
        for form in self.forms:
            for i in np.argsort(-form.errors, kind="stable")[:EXAMPLES] if form.fails and form.name in SHIPPED else ():
                if form.errors[i] > FACTOR:
                    text = line(self.function, self.args, int(i), len(form.errors))
                    found.setdefault(text, Example(form.name, float(form.errors[i]), form.got[i].tolist(),
                                                   form.true[i].astype(float).tolist(), text))
        return tuple(found.values())


def judged(function: str, ctx=None) -> Finding:
    """All forms of a twin over its extreme grid. A BRDF is put into the furnace too."""
    from app.gpu.evaluate import WIDTH, evaluate

    against, right = stable_of(function), right_of(function)
    args = points(against)
    is_vector = WIDTH[catalogue()[function][1].returns] > 1
    found = []
    with np.errstate(all="ignore"):
        truth, value = (np.asarray(twin(name)(**args), float) for name in (against, function))
        allowed = np.ones(np.shape(truth)) if function in COUNTED else np.atleast_1d(cost(against, args, is_vector))

        def form(name: str, judge: str, got, true, precision: str) -> None:
            found.append(compared(function, name, judge, got, true, allowed, args, precision, is_vector))

        form(GLSL, "float64", evaluate(function, args, ctx=ctx), truth, "float32")
        small = np.asarray(twin_of(function, np.float32)(**cast(args, np.float32)))
        if small.dtype == np.float32:
            form(NUMPY32, "float64", small, truth, "float32")
        if EXTENDED:
            best = np.asarray(twin_of(against, EXTENDED)(**cast(args, EXTENDED)))
            allowed = allowed + closed_form_terms(against, args)
            form(NUMPY64, "extended precision", value, best, "float64")
        differs = float(np.nanmax(np.abs(value / twin(right)(**args) - 1), initial=0.0)) if right else None
    return Finding(function, f"app/optics/{names()[function]}.py", kind(function), against, len(found[0].errors),
                   tuple(found), golden.of(function), energy.most(function), differs, args)


def cast(args: dict, kind: type) -> dict:
    """The same numbers, of another kind."""
    return {name: x.astype(kind) if x.dtype.kind == "f" else x for name, x in
            ((name, np.asarray(x)) for name, x in args.items())}


def compared(function: str, name: str, judge: str, got, true, allowed: np.ndarray, args: dict, precision: str,
             is_vector: bool) -> Form:
    """What is wrong, counted. float32 knows few digits of a denormal number, and OpenGL may take it for 0: where an
    input is one, no digits are asked for. Nor of a count, which jumps."""
    got, true = np.atleast_1d(got), np.atleast_1d(true)
    error = np.atleast_1d(off(true, got, allowed, precision, is_vector))
    if function in COUNTED:
        error, judge = np.zeros_like(error), "none: it counts"
    if precision == "float32":
        error = np.where(tiny(args, error.shape), 0.0, error)
    low, high = bounds(function)
    each = (lambda wrong: np.any(wrong, -1)) if is_vector else (lambda wrong: wrong)
    nan, infinite = each(np.isnan(got)), each(np.isinf(got) & ~(np.abs(true) > LARGEST[precision]))
    negative = outside = np.zeros(len(error), bool)
    if not is_vector:
        slack = FACTOR * U[precision] * allowed
        negative = (got < 0) & (low == 0)
        outside = (got > high + slack) | (got < low - slack) & ~negative
    error = np.where(nan | infinite | negative | outside, np.inf, error)
    counts = [int(np.count_nonzero(x)) for x in (nan, infinite, negative, outside, error > FACTOR)]
    return Form(name, judge, counts[0], counts[1], counts[2], counts[3], counts[4], float(error.max(initial=0.0)),
                error, got, true)


def tiny(args: dict, shape: tuple) -> np.ndarray:
    """The points with an input that is denormal in float32."""
    found = np.zeros(shape, bool)
    for x in map(np.asarray, args.values()):
        if x.dtype.kind == "f" and x.shape[:1] == shape:
            small = (x != 0) & (np.abs(x) < SMALLEST32)
            found |= small.reshape(len(small), -1).any(-1)
    return found
