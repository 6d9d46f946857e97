"""Runs a student's function on the points of an exercise and compares it with the float64 twin.

The text runs here, in this process, with all its rights: only for texts one trusts, as a lesson's own stub and
solution. A stranger's text belongs into the sandbox, which comes with the grader.
"""

import warnings
from dataclasses import dataclass, replace

import numpy as np

from app.lesson import Check, Exercise
from app.problem import Problem, Usage
from app.quantities import TABLE
from app.tolerance import FACTOR, ratio

PRECISION = {"python": "float64", "glsl": "float32"}


@dataclass(frozen=True)
class Finding:
    """What became of one check."""

    words: str  # of the check
    ok: bool
    worst: str = ""  # the arguments at the point with the largest error
    expected: float = 0.0
    got: float = 0.0
    error: float = 0.0  # in units of the tolerance: 1 is the limit
    said: str = ""  # why there is no value: what the compiler or the function said
    hidden: bool = False


def run(exercise: Exercise, language: str, text: str, file: str = "") -> list[Finding]:
    """One finding a check of the exercise, for a student's text in "python" or "glsl"."""
    if language not in PRECISION:
        raise Usage(f"there is no language {language}; an exercise is written in {' or '.join(PRECISION)}.")
    file = file or f"{exercise.name}.{'py' if language == 'python' else 'glsl'}"
    call = python(exercise.function, text, file) if language == "python" else glsl(exercise.function, text)
    return [one(exercise, check, PRECISION[language], call) for check in exercise.checks]


def one(exercise: Exercise, check: Check, precision: str, call) -> Finding:
    args = points(check, precision)
    try:
        got = np.asarray(call(args), float)
    except Exception as error:  # whatever a student's function does, the other checks go on
        said = str(error) if isinstance(error, Problem) else f"{type(error).__name__}: {error}"
        return Finding(check.words, False, error=np.inf, said=said, hidden=check.hidden)
    return replace(compare(exercise.function, args, got, precision), words=check.words, hidden=check.hidden)


def compare(function: str, args: dict, got: np.ndarray, precision: str) -> Finding:
    """The worst point of one check; the tolerance is that of the twins, from the condition of the question."""
    from app.optics import twin

    expected = np.asarray(twin(function)(**args), float)
    if got.shape != expected.shape:
        return Finding("", False, error=np.inf, said=f"gave the shape {got.shape}; the shape {expected.shape} is right")
    far = ratio(function, args, got, precision) / FACTOR
    at = int(np.argmax(far))
    where = ", ".join(f"{name} = {np.round(np.asarray(x)[at], 9).tolist()}" for name, x in args.items())
    return Finding("", bool(far[at] <= 1), where, float(expected[at]), float(got[at]), float(far[at]))


def points(check: Check, precision: str) -> dict[str, np.ndarray]:
    """The arguments of a check, as the language sees them: GLSL gets float32 numbers, and so does the twin."""
    found = {}
    for name, given in check.args.items():
        whole = name in TABLE and TABLE[name].kind == "int"
        numbers = np.asarray(given, int if whole else float)
        found[name] = numbers if whole or precision == "float64" else numbers.astype(np.float32).astype(float)
    return found


def python(function: str, text: str, file: str):
    """A student's Python function; a fault of the text is a fault of every check."""
    space: dict = {"__name__": "student"}
    try:
        exec(compile(text, file, "exec"), space)  # the sandbox comes with the grader
    except Exception as error:
        line = error.lineno if isinstance(error, SyntaxError) else line_in(error, file)
        return failing(f"{file}, line {line}: {type(error).__name__}: {getattr(error, 'msg', error)}")
    if not callable(space.get(function)):
        return failing(f"{file}: there is no function {function} in it")

    def call(args: dict):
        with warnings.catch_warnings(), np.errstate(all="ignore"):
            warnings.simplefilter("ignore")
            try:
                return space[function](**{name: x.copy() for name, x in args.items()})
            except Exception as error:
                raise Problem(f"{file}, line {line_in(error, file)}: {type(error).__name__}: {error}") from None

    return call


def line_in(error: Exception, file: str) -> int:
    """The innermost line of the student's file that ran."""
    line, trace = 1, error.__traceback__
    while trace:
        if trace.tb_frame.f_code.co_filename == file:
            line = trace.tb_lineno
        trace = trace.tb_next
    return line


def glsl(function: str, text: str):
    from app.gpu.evaluate import evaluate

    return lambda args: evaluate(function, args, text)


def failing(said: str):
    def call(args: dict):
        raise Problem(said)

    return call
