"""The live numbers of a step: values with units, errors against the exact one, and what an estimate costs.

The same list is shown by the window, stills and pages. Powers of ten are written 6.80e-5 in plain text, because the
fonts at hand have no raised digits; `raised` cuts a text into pieces for those who can draw or mark up an exponent.
"""

import math
import re
import time
from dataclasses import dataclass, replace

import numpy as np

from app.lesson import Readout, Step
from app.needs import key, of_term
from app.problem import Problem
from app.terms import evaluate, is_yours, whose

ROUNDING = {"float64": 2.0**-52, "float32": 2.0**-23}  # one unit in the last place
DIGITS = {"float64": 17, "float32": 9}  # enough to tell any two neighbours apart
SUMS = {"solid_angle_mesh": 4 * math.pi, "winding_number": 1.0}  # signed sums of terms of this size: they cancel
NOTHING = 1e-12  # of that size is 0, but for rounding
Known = dict[str, tuple[tuple, tuple[float, float]]]  # a readout's label -> the values it needs, what it was and cost
_warm: set[tuple[str, str]] = set()  # what has been evaluated once: compiling is no part of a number's cost


@dataclass(frozen=True)
class Number:
    label: str
    role: str
    value: float  # 0 where a sum cancels but for rounding
    unit: str
    error: float | None  # relative, with its sign; None where there is none or the exact value is 0
    text: str  # three significant digits and the unit
    error_text: str
    full_text: str  # all digits, for the tool-tip
    cost_ms: float | None  # of evaluating an estimate once, with the way to the GPU and back in float32
    cost_text: str = ""
    whose: str = ""  # "yours", "the course's" or "measured", while something is edited


def numbers(step: Step, values: dict, ctx=None, known: Known | None = None) -> list[Number]:
    """The step's readouts at these values (radians inside; a mesh step carries its `triangles`). What is `known` and
    does not depend on a value that has changed is not computed again."""
    found = {readout.label: remembered(readout, values, ctx, {} if known is None else known)
             for readout in step.readouts}
    shown = {readout.label: without_rounding(readout, found[readout.label][0]) for readout in step.readouts}
    made = [number_of(evaluated(readout, values), *found[readout.label], shown.get(readout.against))
            for readout in step.readouts]
    return [replace(number, whose=whose(readout.term, values))
            for readout, number in zip(step.readouts, made, strict=True)]


def evaluated(readout: Readout, values: dict) -> Readout:
    """The readout in the precision it is evaluated in: a text of the user's is GLSL."""
    return replace(readout, precision="float32") if is_yours(readout.term, values) else readout


def remembered(readout: Readout, values: dict, ctx, known: Known) -> tuple[float, float]:
    now = key(values, of_term(readout.term))
    if known.get(readout.label, ((None,),))[0] != now:
        known[readout.label] = now, measured(readout, values, ctx)
    return known[readout.label][1]


def without_rounding(readout: Readout, value: float) -> float:
    return 0.0 if abs(value) <= NOTHING * SUMS.get(readout.term.function, 0.0) else value


def number_of(readout: Readout, value: float, cost: float, exact: float | None) -> Number:
    shown = without_rounding(readout, value)
    error, error_text = against(readout, shown, exact)
    estimate = bool(readout.against)
    words = readout.absent if readout.absent and math.isnan(shown) else written(shown, readout.unit)
    return Number(readout.label, readout.role, shown, readout.unit, error, words, error_text, full(value, readout),
                  cost if estimate else None, duration(cost) if estimate else "")


def measured(readout: Readout, values: dict, ctx=None) -> tuple[float, float]:
    """A readout's value and the milliseconds it took: the best of a few, as long as they are short."""
    key = readout.term.function, readout.precision
    best, left = math.inf, 1.5
    repeats = 3 if readout.against else 1
    if repeats > 1 and key not in _warm:
        once(readout, values, ctx)
        _warm.add(key)
    for _ in range(repeats):
        start = time.perf_counter()
        value = once(readout, values, ctx)
        best = min(best, 1e3 * (time.perf_counter() - start))
        left -= best
        if left <= 0:
            break
    return value, best


def once(readout: Readout, values: dict, ctx=None) -> float:
    try:
        with np.errstate(all="ignore"):  # a number that is not finite is said in words
            found = evaluate(readout.term, values, readout.precision, ctx=ctx)
    except KeyError as missing:
        raise Problem(f"the number “{readout.label}” needs a value {missing.args[0]}, and the step has none.") from None
    if found.size != 1:
        raise Problem(f"the number “{readout.label}” is {found.size} numbers; {readout.term.function} must give one.")
    return float(found.reshape(()))


def against(readout: Readout, value: float, exact: float | None) -> tuple[float | None, str]:
    """The relative error and its words; an exact value of 0 has a difference only, and what is not finite has none."""
    if exact is None or not (math.isfinite(value) and math.isfinite(exact)):
        return None, ""
    if value == exact:
        return 0.0, "exact to rounding"
    if exact == 0:
        return None, f"off by {written(value, readout.unit)}"
    error = (value - exact) / exact
    return error, error_words(error, ROUNDING[readout.precision])


def error_words(error: float, rounding: float = ROUNDING["float64"]) -> str:
    """A relative error as one reads it: -24 %, +0.31 %, 3e-7, exact to rounding."""
    if math.isnan(error):
        return ""
    if math.isinf(error):
        return "beyond measure"
    if abs(error) <= rounding:
        return "exact to rounding"
    if abs(error) < 5e-4:
        return f"{error:.0e}".replace("e-0", "e-").replace("-", "−", error < 0)
    percent = 100 * error
    if abs(percent) >= 1e4:
        return f"{three(error)} times too {'much' if error > 0 else 'little'}".replace("−", "")
    digits = 0 if abs(percent) >= 9.95 else 1 if abs(percent) >= 0.995 else 2
    return f"{percent:+.{digits}f} %".replace("-", "−")


def written(value: float, unit: str = "") -> str:
    """Three significant digits with the unit; what is no number is said in words."""
    if not math.isfinite(value):
        return three(value)
    return three(value) + ("" if unit in ("", "°") else " ") + unit


def duration(ms: float) -> str:
    """What a number costs, in two digits: timings are no better than that."""
    size, unit = (ms, "ms") if ms >= 1 else (1e3 * ms, "µs")
    return f"{float(f'{size:.1e}'):g} {unit}"


def three(value: float) -> str:
    """Three significant digits: 0.682, 12.6, 185 000, 6.80e-5."""
    if math.isnan(value):
        return "not a number"
    if math.isinf(value):
        return "infinite" if value > 0 else "minus infinite"
    if value == 0:
        return "0"
    mantissa, exponent = f"{value:.2e}".split("e")
    power = int(exponent)
    if not -3 <= power < 6:
        return f"{mantissa}e{power}".replace("-", "−", value < 0)
    rounded = float(f"{value:.2e}")
    return f"{rounded:,.{max(0, 2 - power)}f}".replace(",", "\u202f" if power > 3 else "").replace("-", "−")


def full(value: float, readout: Readout) -> str:
    """Every digit the precision has, to be copied: 17 in float64, 9 in float32."""
    if not math.isfinite(value):
        return f"{three(value)} ({readout.precision})"
    return f"{value:.{DIGITS[readout.precision]}g} {readout.unit}".rstrip() + f" ({readout.precision})"


def raised(text: str) -> list[tuple[str, bool]]:
    """A text in pieces, exponents marked: '6.80e-5 sr' -> ('6.80·10', no), ('−5', yes), (' sr', no)."""
    pieces: list[tuple[str, bool]] = []
    at = 0
    for match in re.finditer(r"(?<=\d)e([-+]?\d+)", text):
        pieces += [(text[at:match.start()] + "·10", False), (match[1].replace("-", "−").lstrip("+"), True)]
        at = match.end()
    return [piece for piece in (*pieces, (text[at:], False)) if piece[0]]
