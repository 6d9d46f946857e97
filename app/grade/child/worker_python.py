"""Calls the functions of a student's Python text, in a process that is locked already, and sends what they return.

Whatever the text does to numpy, the builtins or this module changes its own answers: nothing here knows a right one.
"""

import builtins
import linecache
import sys
import types

from frames import LOADED, READY, STARTED, VALUES, Pipe, Questions

NAME = "submission.py"
PLAIN = tuple(kind for kind in vars(builtins).values() if isinstance(kind, type) and issubclass(kind, BaseException))
SIMPLE = (str, int, float)
ADVICE = {  # what numpy or Python says -> what a beginner does about it
    "can be converted to Python scalars": "math's functions take one number: use numpy's, np.cos for math.cos",
    "truth value of an array": "an if decides for one number: use np.where(condition, a, b), np.maximum or np.clip",
    "not aligned": "of rows of vectors the product is np.sum(a * b, axis=-1)",
    "could not be broadcast together": "an array of numbers times rows of vectors: s[:, None] * v",
    "can't start new thread": "functions of numbers start none here",
}
TRACEBACK = BaseException.__dict__["__traceback__"].__get__
ARGUMENTS = BaseException.__dict__["args"].__get__


class Refused(Exception):
    """The answer is no answer: the word for it, and why."""


def where(error: BaseException) -> str:
    """The last line of the student's that an error passed through."""
    line, trace = 0, TRACEBACK(error)
    while trace is not None:
        if trace.tb_frame.f_code.co_filename == NAME:
            line = trace.tb_lineno
        trace = trace.tb_next
    return f"line {line}: " if line else ""


def reason(error: BaseException) -> tuple[str, str]:
    """Verdict and words; no code of the student's runs for them (no __str__, no __name__ of a metaclass)."""
    kind = type(error)
    if kind is Refused:
        word, why = ARGUMENTS(error)
        return word, why
    name = str(type.__dict__["__name__"].__get__(kind))[:80]
    parts = [part for part in ARGUMENTS(error)[:4] if type(part) in SIMPLE]
    said = " ".join(str(part)[:300] for part in parts) if kind in PLAIN or len(parts) == 1 else ""
    word = "memory" if issubclass(kind, MemoryError) else "forbidden" if issubclass(kind, PermissionError) \
        else "runtime_error"
    if word == "memory":
        said = "it asks for more memory than there is here"
    if word == "forbidden":
        said = f"{said.lstrip('0123456789 ')}; functions of numbers open no files, processes or connections here"
    if kind is SyntaxError or kind is IndentationError or kind is TabError:
        return "compile_error", f"line {error.lineno}: {error.msg}"  # type: ignore[attr-defined]
    advice = "".join(f" - {more}" for what, more in ADVICE.items() if what in said)
    return word, f"{where(error)}{name}{': ' if said else ''}{said}{advice}"


def main(order: dict) -> None:
    import numpy
    from numpy import array, dtype, frombuffer, ndarray

    pipe, questions = Pipe(order["out"]), Questions()
    calls, double = questions.header["calls"], dtype("<f8")
    text = questions.header["text"]
    numpy.seterr(all="ignore")  # what is not finite is told by the judge, point by point

    def values(result, count: int, width: int) -> bytes:
        """The exact shape and a real number type, else a reason; nothing is stretched to fit."""
        shape = (count,) if width == 1 else (count, width)
        if type(result) is not ndarray:
            kind = str(type.__dict__["__name__"].__get__(type(result)))[:80]
            raise Refused("runtime_error", f"it returned {kind}, not a numpy array of {count} values"
                          f"{'; np.array(...) makes one' if kind in ('list', 'tuple') else ''}")
        if result.dtype.kind not in "fiu" or result.dtype.itemsize > 8:
            raise Refused("runtime_error", f"it returned an array of {result.dtype.name}, not of real numbers")
        if result.shape != shape:
            raise Refused("runtime_error", f"it returned an array of shape {result.shape[:4]} where {shape} is due")
        return array(result, dtype=double, order="C").tobytes()

    lines = text.splitlines(keepends=True)
    linecache.cache[NAME] = (len(text), None, lines, NAME)
    module = types.ModuleType("submission")
    module.__file__ = NAME
    sys.modules["submission"] = module
    names = vars(module)
    pipe.send(STARTED, READY)
    try:
        exec(compile(text, NAME, "exec", dont_inherit=True), names)
    except BaseException as error:
        pipe.refuse(LOADED, *reason(error))
        return
    pipe.send(LOADED, READY)
    place = questions.start
    for index, call in enumerate(calls):
        count, args = call["count"], []
        for columns in call["columns"]:
            raw = questions.read(8 * count * columns, place)
            place += len(raw)
            args.append(frombuffer(raw, double).reshape((count, columns) if columns > 1 else (count,)).copy())
        try:
            function = names.get(call["function"])
            if function is None:
                raise Refused("missing", missing(call["function"], names))
            if not callable(function):
                raise Refused("runtime_error", f"{call['function']} is not a function")
            data = values(function(*args), count, call["width"])
        except BaseException as error:
            pipe.refuse(index, *reason(error))
        else:
            pipe.send(index, VALUES, data)


def missing(name: str, names: dict) -> str:
    """What there is instead: another case, or letters of another alphabet that look the same."""
    for other in names:
        if type(other) is str and other.lower() == name.lower():
            return f"there is no function {name}; {other} is another name"
        if type(other) is str and len(other) == len(name) and not other.isascii() and all(
                a == b or not a.isascii() for a, b in zip(other, name, strict=True)):
            return f"there is no function {name}; one that looks like it has letters of another alphabet in its name"
    return f"there is no function {name}"
