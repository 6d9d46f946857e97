"""A point of the grid as a command: what `halfway eval` takes, to be pasted into a shell."""

import json
import shlex

import numpy as np

from app.optics import arguments
from app.tables import FOLDER

LUMINAIRE = "corner"


def line(function: str, args: dict, i: int, count: int) -> str:
    """The command that computes the function at point i of `count`. Angles are radians."""
    at = {name: np.asarray(args[name]) for name in arguments(function)}
    at = {name: x[i] if x.shape[:1] == (count,) and name not in ("corners", "triangles", "table") else x
          for name, x in at.items()}
    if "triangles" in at:
        case = [{"function": function, "args": {name: x.tolist() for name, x in at.items()}}]
        return f"echo {shlex.quote(json.dumps(case))} | halfway eval --json"
    return shlex.join(["halfway", "eval", function, *(f"{name}={written(name, x)}" for name, x in at.items())])


def written(name: str, x: np.ndarray) -> str:
    if name == "table":
        return str(FOLDER / f"{LUMINAIRE}.ies")
    if x.ndim == 2:
        return ";".join(written(name, row) for row in x)
    return ",".join(str(int(v)) if x.dtype.kind in "iu" else repr(float(v)) for v in np.ravel(x))
