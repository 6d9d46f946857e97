"""Check a file of stored high-precision values against the twins: python -m tests.reference GOLDEN.json

float64: the Python twin at the stored inputs against the stored value. float32: the GLSL twin at the inputs rounded to
float32, against the Python twin at the same. Both in units of u (1 + cond + kappa), 8 allowed. Exit code 0: all within;
1: some beyond; 2: the file cannot be read or is garbled.
"""

import json
import sys
from collections import Counter
from pathlib import Path

import numpy as np

from app.gpu.evaluate import evaluate
from app.optics import arguments
from app.problem import Problem, Usage
from app.tolerance import FACTOR, TERMS, U, moved, ratio
from tests.reference.mapping import Twin, mapped


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
    from app.optics import twin as function

    got = float(function(twin.function)(**args))
    terms = float(TERMS[twin.function](**args)) if twin.function in TERMS else 0.0
    change = float(moved(twin.function, args)) if np.isnan(cond) else cond * abs(value)  # not stored: measured here
    cost = U["float64"] * (abs(value) + change + terms)
    if got == value:
        return 0.0
    return abs(got - value) / cost if cost > 0 and np.isfinite(got) else np.inf


def check(record: dict, twin: Twin) -> tuple[float, float]:
    """The ratios of a record in float64 and in float32."""
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


def main(argv: list[str]) -> int:
    if len(argv) != 1:
        raise Usage("usage: python -m tests.reference GOLDEN.json")
    found: dict[str, list[tuple[float, float]]] = {}
    left: Counter[str] = Counter()
    for record in read(Path(argv[0])):
        twin = mapped(record["name"])
        if twin is None:
            left[record["name"]] += 1
        else:
            found.setdefault(record["name"], []).append(check(record, twin))
    print(f"{'worst error in units of u (1 + cond + kappa)':<56}records   float64   float32")
    failed = 0
    for name, ratios in sorted(found.items()):
        worst = np.max(ratios, 0)
        beyond = bool(np.any(worst > FACTOR))
        failed += beyond
        print(f"{name:<56}{len(ratios):7d}{worst[0]:10.2f}{worst[1]:10.2f}{'   beyond 8' if beyond else ''}")
    if left:
        families = sorted({name.partition(".")[0] for name in left})
        print(f"not mapped yet: {len(left)} names, {left.total()} records, of {', '.join(families)}")
    if failed:
        print(f"{failed} names beyond the bound")
    return 1 if failed else 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except Problem as problem:
        print(problem, file=sys.stderr)
        sys.exit(problem.code)
