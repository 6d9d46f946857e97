"""The twins in another precision: the same text, run with `float` and numpy's own floats replaced.

float32 shows what the formula loses where it is not on the GPU; 80-bit numbers judge the float64 twin's rounding. A
wrong formula they do not find, and a constant that is typed with 16 digits keeps them: golden values and identities do.
Numbers made from counts (np.arange(n) / n) and math.erfc stay float64.
"""

import builtins
import importlib
from collections.abc import Callable
from functools import cache
from importlib.util import find_spec
from types import ModuleType
from typing import Any

import numpy as np

from app.optics import names

PI = "3.14159265358979323846264338327950288"
SHARED = ("app.problem", "app.quantities", "app.tables", "app.paths", "app.lesson")  # nothing is computed there
EXTENDED = np.longdouble if np.finfo(np.longdouble).eps < 2.0**-60 else None  # where the machine has such numbers


class Numpy:
    """numpy, but arrays made of nothing are of the copy's kind."""

    def __init__(self, kind: type) -> None:
        self.pi, self.float64, self.kind = kind(PI), kind, kind

    def __getattr__(self, name: str) -> Any:
        return getattr(np, name)

    def zeros(self, shape, dtype=None):
        return np.zeros(shape, dtype or self.kind)

    def ones(self, shape, dtype=None):
        return np.ones(shape, dtype or self.kind)

    def linspace(self, *args, **named):
        return np.linspace(*args, **{"dtype": self.kind, **named})

    def array(self, given, dtype=None, **named):
        found = np.array(given, dtype, **named)
        return found.astype(self.kind) if dtype is None and found.dtype == np.float64 else found

    def interp(self, x, at, values, left=None, right=None):
        at, values = np.asarray(at, self.kind), np.asarray(values, self.kind)
        i = np.clip(np.searchsorted(at, x) - 1, 0, len(at) - 2)
        share = np.clip((x - at[i]) / (at[i + 1] - at[i]), 0, 1)
        found = values[i] + share * (values[i + 1] - values[i])
        found = found if left is None else np.where(x < at[0], self.kind(left), found)
        return found if right is None else np.where(x > at[-1], self.kind(right), found)

    def bincount(self, places, weights, size):
        found = np.zeros(size, self.kind)
        np.add.at(found, places, weights)
        return found


class Copy:
    """The modules of the course that the twins need, each run once for this kind of number."""

    def __init__(self, kind: type) -> None:
        self.numpy = Numpy(kind)
        self.modules: dict[str, ModuleType] = {}
        self.builtins = {**vars(builtins), "float": kind, "__import__": self.find}

    def find(self, name: str, globals=None, locals=None, fromlist=(), level: int = 0):
        if name == "numpy":
            return self.numpy
        if name.startswith("app.") and name not in SHARED and fromlist:
            return self.module(name)
        return builtins.__import__(name, globals, locals, fromlist, level)

    def module(self, name: str) -> ModuleType:
        if name not in self.modules:
            importlib.import_module(name)  # its classes look for it by its name
            spec = find_spec(name)
            code = spec.loader.get_code(name)  # type: ignore[union-attr]
            made = self.modules[name] = ModuleType(name)
            made.__dict__.update(__builtins__=self.builtins, __file__=spec.origin)  # type: ignore[union-attr]
            exec(code, made.__dict__)
        return self.modules[name]


@cache
def copy(kind: type) -> Copy:
    return Copy(kind)


def twin_of(function: str, kind: type) -> Callable:
    """The twin computed with numbers of another kind; its arguments are taken as they are given."""
    return getattr(copy(kind).module(f"app.optics.{names()[function]}"), function)
