"""Stored high-precision values (tests/reference/golden.json, in a checkout) against the twins.

float64: the Python twin at the stored inputs against the stored value. float32: the GLSL twin at the inputs rounded to
float32, against the Python twin at the same. Both in units of u (1 + cond + kappa), 8 allowed.
"""

import json
from functools import cache
from pathlib import Path

import numpy as np

from app.optics import arguments
from app.optics import twin as function
from app.paths import ROOT
from app.problem import Usage
from app.stress.mapping import Twin, mapped
from app.tolerance import TERMS, U, moved, ratio

FILE = ROOT / "tests" / "reference" / "golden.json"


def read(path: Path) -> list[dict]:
    try:
        whole = json.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise Usage(f"{path} cannot be read: {error.strerror}.") from None
    except UnicodeDecodeError:
        raise Usage(f"{path} is not a file of stored values: it is no UTF-8 text.") from None
    except json.JSONDecodeError as error:
        raise Usage(f"{path} is not a file of stored values: line {error.lineno} is no JSON ({error.msg}).") from None
    records = whole.get("values") if isinstance(whole, dict) else None
    if not isinstance(records, list):
        raise Usage(f"{path} is not a file of stored values: it has no list `values`.")
    for number, record in enumerate(records):
        if not isinstance(record, dict) or not {"name", "inputs", "value"} <= record.keys():
            raise Usage(f"{path}, record {number}: it needs name, inputs and value.")
    return records


def numbers(record: dict, twin: Twin) -> tuple[dict, float, float]:
    """Arguments, value and condition number of a record."""
    try:
        args = {twin.inputs.get(k, k): np.array(v, float) * (np.pi / 180 if k in twin.degrees else 1)
                for k, v in record["inputs"].items()}
        value, cond = float(record["value"]), record.get("cond")
        cond = np.nan if cond is None else float(cond)
    except (ValueError, TypeError, AttributeError) as error:
        raise Usage(f"{record['name']}: {error}.") from None
    if not np.isfinite(value) or np.isinf(cond) or not all(np.all(np.isfinite(v)) for v in args.values()):
        raise Usage(f"{record['name']}: a number in it is not finite.")
    args |= {name: np.asarray(x, float) for name, x in twin.fixed.items()}
    if "corners" in args:
        args["corner_count"] = np.array(len(args["corners"]))
    return args, value, cond


def stored_ratio(twin: Twin, args: dict, value: float, cond: float) -> float:
    """How far the Python twin is from the stored value, in units of u (1 + cond + kappa)."""
    got = float(function(twin.function)(**args))
    terms = float(TERMS[twin.function](**args)) if twin.function in TERMS else 0.0
    change = float(moved(twin.function, args)) if np.isnan(cond) else cond * abs(value)  # not stored: measured here
    cost = U["float64"] * (abs(value) + change + terms)
    if got == value:
        return 0.0
    return abs(got - value) / cost if cost > 0 and np.isfinite(got) else np.inf


def check(record: dict, twin: Twin) -> tuple[float, float]:
    """The ratios of a record in float64 and in float32."""
    from app.gpu.evaluate import evaluate

    args, value, cond = numbers(record, twin)
    try:
        in_float64 = stored_ratio(twin, args, value, cond)
        rounded = {k: np.asarray(v, np.float32).astype(float) if v.dtype.kind == "f" else v for k, v in args.items()}
        in_float32 = float(ratio(twin.function, rounded, evaluate(twin.function, rounded)))
    except (TypeError, KeyError):
        given = ", ".join(record["inputs"]) or "none"
        raise Usage(f"{record['name']}: its inputs ({given}) do not fit {twin.function}, which takes "
                    f"{', '.join(arguments(twin.function))}.") from None
    return in_float64, in_float32


@cache
def records() -> dict[str, list[tuple[dict, Twin]]]:
    """The stored records of each function; an installed wheel has none."""
    found: dict[str, list[tuple[dict, Twin]]] = {}
    for record in read(FILE) if FILE.exists() else ():
        twin = mapped(record["name"])
        if twin:
            found.setdefault(twin.function, []).append((record, twin))
    return found


def of(name: str) -> tuple[int, float, float] | None:
    """How many records a function has, and their worst errors in float64 and in float32."""
    if name not in records():
        return None
    found = np.array([check(record, twin) for record, twin in records()[name]])
    in_float64, in_float32 = found.max(0)
    return len(found), float(in_float64), float(in_float32)
