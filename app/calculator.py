"""`halfway eval`: any twin as a calculator, in float64 (Python) and float32 (GLSL).

halfway eval solid_angle_cone half_angle=0.1,30deg
halfway eval solid_angle_triangle a=0,0,1 b=1,0,1 c="0,1,1;0,2,1"
halfway eval --json < cases.json
"""

import argparse
import json
import math
import re
import sys
from functools import cache
from pathlib import Path
from typing import TextIO

import numpy as np

from app import optics, shader
from app.problem import Problem, Usage, near
from app.quantities import TABLE

MAX_CORNERS = 8  # as in glsl/core/constants.glsl
COLUMNS = {"float": 1, "int": 1, "vec2": 2, "vec3": 3, "vec4": 4}
NUMBER = re.compile(r"([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)\s*(deg|rad|°)?", re.I)
UNITS = {"sr", "m", "rad", "m^2", "W", "W/sr", "W/m^2", "lm", "cd", "lx", "1/sr"}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("function", nargs="?", help="name of a function; without one, cases are read as JSON")
    parser.add_argument("arguments", nargs="*", metavar="name=value[,value...]",
                        help="radians, or 30deg; vectors as 0,0,1 and several of them as 0,0,1;1,0,1")
    parser.add_argument("--backend", choices=("python", "glsl", "both"), default="both")
    parser.add_argument("--json", action="store_true", help="answer in JSON")


def run(options: argparse.Namespace, out: TextIO = sys.stdout) -> int:
    if options.function is None:
        if not options.json:
            raise Usage("Name a function, as in `halfway eval solid_angle_cone half_angle=30deg`, "
                        "or give cases with `halfway eval --json < cases.json`.")
        answers = [answer(number, case, options.backend) for number, case in enumerate(read_cases(sys.stdin.read()))]
        print(json.dumps(answers, indent=1, allow_nan=False), file=out)
        return 0
    given: dict[str, str] = {}
    for name, value in map(split, options.arguments):
        if name in given:
            raise Usage(f"{name} is given twice, as {given[name]} and {value}; for several values write {name}="
                        f"{given[name]},{value}.")
        given[name] = value
    args = bound(options.function, given)
    values = results(options.function, args, options.backend)
    if options.json:
        case = {"function": options.function, "args": {k: np.asarray(v).tolist() for k, v in args.items()}}
        print(json.dumps(case | strict(values), indent=1, allow_nan=False), file=out)
    else:
        print(table(options.function, args, values), file=out)
    return 0


def split(word: str) -> tuple[str, str]:
    name, equals, value = word.partition("=")
    if not equals or not value:
        raise Usage(f"{word!r} is not of the form name=value.")
    return name, value


def read_cases(text: str) -> list[dict]:
    try:
        cases = json.loads(text)
    except ValueError as error:
        raise Usage(f"the cases are not JSON: {error}.") from None
    if not isinstance(cases, list):
        raise Usage('the cases are a list of {"function": ..., "args": {...}}.')
    for number, case in enumerate(cases):
        has = isinstance(case, dict) and isinstance(case.get("function"), str) and isinstance(case.get("args"), dict)
        if not has:
            raise Usage(f'case {number} is not of the form {{"function": name, "args": {{name: number or list}}}}.')
    return cases


def answer(number: int, case: dict, backend: str) -> dict:
    try:
        args = bound(case["function"], case["args"])
    except Usage as problem:
        raise Usage(f"case {number}: {problem}") from None
    return case | strict(results(case["function"], args, backend))


def bound(function: str, given: dict) -> dict[str, np.ndarray]:
    """The arguments of a function as arrays, from words or from JSON numbers and lists."""
    known = optics.arguments(function)
    for name in given:
        if name not in known:
            raise Usage(f"{function} has no argument {name}; it takes {', '.join(known)}.{near(name, known)}")
    if "corner_count" in known and "corners" in given and "corner_count" not in given:
        given = given | {"corner_count": len(np.atleast_1d(array(function, "corners", given["corners"])))}
    given = {**{name: "" for name in known if name.endswith("_map")}, **given}  # none: the pattern made here
    missing = [name for name in known if name not in given]
    if missing:
        raise Usage(f"{function} needs {', '.join(missing)} too; it takes {', '.join(known)}.")
    args = {name: array(function, name, given[name]) for name in known}
    if "corners" in args and np.any(args["corner_count"] > args["corners"].shape[-2]):
        raise Usage(f"corner_count is more than the {args['corners'].shape[-2]} corners given.")
    check_shapes(function, args)
    return args


def picture(name: str, given) -> np.ndarray:
    """A map by its file, or none."""
    from app import maps

    if not isinstance(given, str):
        raise Usage(f"{name} is a picture: name a PNG or JPEG file.")
    return maps.read(name.removesuffix("_map"), given).texels if given else maps.NONE


def array(function: str, name: str, given) -> np.ndarray:
    argument = next(a for a in shader.catalogue()[function][1].args if a.name == name)
    if name.endswith("_map"):
        return picture(name, given)
    table = argument.type == "sampler2D" and name == "table"
    if table and isinstance(given, str):
        from app.ies import read

        return read(Path(given)).table
    if argument.type == "sampler2D" and isinstance(given, str):
        from app.meshes import load

        return load(Path(given)).triangles
    width = COLUMNS.get(argument.type, 3)
    if isinstance(given, str) and (width > 1 or argument.size):
        given = [[number(name, word) for word in part.split(",")] for part in given.split(";")]
        given = given if len(given) > 1 or argument.size else given[0]
    elif isinstance(given, str):
        words = [number(name, word) for word in given.split(",")]
        given = words if len(words) > 1 else words[0]
    try:
        value = np.array(worded(name, given), float)
    except (ValueError, TypeError):
        raise Usage(f"{name}: {given!r} is neither a number nor a list of numbers of one shape.") from None
    if not np.all(np.isfinite(value)):
        raise Usage(f"{name}: {given!r} holds a number that is not finite.")
    wide = () if table else (3, 3) if argument.type == "sampler2D" else (width,) if width > 1 else ()
    if wide and value.shape[value.ndim - len(wide):] != wide:
        raise Usage(f"{name} is a {argument.type}: give {' x '.join(map(str, wide))} numbers, as in 0,0,1.")
    least = 2 if table else 3 if argument.type == "sampler2D" else 2 if argument.size else 0
    if value.ndim < least or (argument.size and not 3 <= value.shape[-2] <= MAX_CORNERS):
        raise Usage(f"{name} is a list: of 3 to {MAX_CORNERS} corners x,y,z;x,y,z;... or of triangles.")
    if argument.type != "int":
        return value
    if np.any(value != np.rint(value)) or np.any(np.abs(value) > 2**31 - 1):
        raise Usage(f"{name} counts: {given!r} is not a whole number below 2^31.")
    return value.astype(int)


def worded(name: str, given):
    """Words inside JSON lists ("30deg") as numbers."""
    if isinstance(given, list):
        return [worded(name, item) for item in given]
    if isinstance(given, bool) or given is None:
        raise TypeError
    return number(name, given) if isinstance(given, str) else given


def number(name: str, word: str) -> float:
    match = NUMBER.fullmatch(word.strip())
    if not match:
        raise Usage(f"{name}: {word.strip()!r} is not a number; numbers look like 0.5, 1e-3 or, for angles, 30deg.")
    if match[2] and not (name in TABLE and TABLE[name].is_angle):
        raise Usage(f"{name} is not an angle: {word.strip()!r} has a unit it cannot have.")
    degrees = match[2] and match[2].lower() in ("deg", "°")
    return math.radians(float(match[1])) if degrees else float(match[1])


def check_shapes(function: str, args: dict) -> None:
    """How many points each argument has: one, or as many as the others."""
    counts = {}
    for argument in shader.catalogue()[function][1].args:
        if not argument.size and argument.type in COLUMNS:
            shape = np.shape(args[argument.name])
            counts[argument.name] = shape[:-1] if COLUMNS[argument.type] > 1 else shape
    try:
        np.broadcast_shapes(*counts.values())
    except ValueError:
        many = ", ".join(f"{name} {shape}" for name, shape in counts.items() if shape)
        raise Usage(f"the arguments have different numbers of values ({many}): give one, or as many of each.") from None


def results(function: str, args: dict, backend: str) -> dict[str, np.ndarray]:
    values = {}
    if backend != "glsl":
        with np.errstate(all="ignore"):
            values["value"] = np.asarray(optics.twin(function)(**args))
    if backend == "glsl" or (backend == "both" and opengl()):
        from app.gpu.evaluate import evaluate

        values["glsl"] = evaluate(function, args)
    return values


@cache
def opengl() -> bool:
    """Whether OpenGL can be had; if not, that is said once, and Python answers alone."""
    from app.gpu.context import context

    try:
        context()
    except Problem as problem:
        print(f"halfway: no float32 answers by GLSL: {problem}", file=sys.stderr)
        return False
    return True


def strict(values: dict[str, np.ndarray]) -> dict:
    """The values as JSON has them: null, and a note, where there is no number."""
    found: dict = {name: listed(value.tolist()) for name, value in values.items()}
    if not all(np.all(np.isfinite(value)) for value in values.values()):
        found["note"] = "null: the function has no finite value there"
    return found


def listed(value):
    if isinstance(value, list):
        return [listed(item) for item in value]
    return value if math.isfinite(value) else None


def unit(function: str) -> str:
    """The unit its docstring says it returns."""
    match = re.search(r"Returns(?: \([^)]*\))? ?([^\s.;,]*)", optics.twin(function).__doc__ or "")
    return match[1] if match and match[1] in UNITS else ""


def table(function: str, args: dict, values: dict[str, np.ndarray]) -> str:
    """Aligned columns: the arguments that vary, the values with all their digits, their relative difference."""
    width = COLUMNS[shader.catalogue()[function][1].returns]
    shape = next(iter(values.values())).shape
    points = shape[:-1] if width > 1 else shape
    columns: dict[str, list[str]] = {}
    for name, given in args.items():
        if given.dtype.kind in "fi" and given.shape == points:
            columns[name] = [f"{x:.9g}" for x in given.ravel()]
    for name, digits, title in (("value", 17, "python float64"), ("glsl", 9, "GLSL float32")):
        if name in values:
            rows = values[name].reshape(-1, width) if width > 1 else values[name].reshape(-1, 1)
            columns[title] = [", ".join(f"{x:.{digits}g}" for x in row) for row in rows.astype(float)]
    if len(values) == 2:
        python, glsl = (v.astype(float).reshape(-1, width) for v in (values["value"], values["glsl"]))
        with np.errstate(all="ignore"):
            size = np.linalg.norm(python, axis=-1)
            off = np.where(size > 0, np.linalg.norm(glsl - python, axis=-1) / size, 0)
        columns["relative difference"] = [f"{x:.1e}" for x in off]
    sizes = {title: max(len(title), *map(len, cells)) for title, cells in columns.items()}
    lines = ["  ".join(title.rjust(size) for title, size in sizes.items())]
    for row in zip(*columns.values(), strict=True):
        lines.append("  ".join(cell.rjust(size) for cell, size in zip(row, sizes.values(), strict=True)))
    said = unit(function)
    return "\n".join([f"{function}{f' in {said}' if said else ''}", *(line.rstrip() for line in lines)])
