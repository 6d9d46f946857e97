"""Whether a BRDF sends on more light than it gets, over the extremes of its parameters."""

import itertools
from dataclasses import dataclass
from functools import partial

import numpy as np

from app.furnace import albedo
from app.optics import arguments, twin
from app.quantities import TABLE, shown

VIEWS = np.radians([0, 30, 60, 80, 89])
MOST = 1 + 1e-3  # what app/furnace.py can tell from 1
STATES = 8
DIRECTIONS = {"n", "l", "v"}
RIGHT = {"coupling": 3, "geometry": 3}  # the others of these are shown because they gain light
AS_DEFINED = {"brdf_gltf", "brdf_file"}  # the format's own mixture, 1 - F(l.h) of the body, gains at grazing angles


@dataclass(frozen=True)
class Albedo:
    largest: float
    at: dict[str, float]
    allowed: bool = False  # what gains it is no fault of the twin

    @property
    def gains(self) -> bool:
        return not self.largest <= MOST

    @property
    def words(self) -> str:
        return ", ".join(f"{name} {shown(name, x):.4g}{TABLE[name].screen_unit}" for name, x in self.at.items())


def states(names: list[str]) -> list[dict]:
    """Corners of the parameters, the same every time; k_d and k_s are shares of one light."""
    ends = [sorted({TABLE[name].low, *(TABLE[name].extreme or ()), TABLE[name].high}) for name in names]
    ends = [[RIGHT[name]] if name in RIGHT else values for name, values in zip(names, ends, strict=True)]
    corners = list(itertools.islice(itertools.product(*ends), 4096))
    chosen = np.random.default_rng(len(names)).permutation(len(corners))[:STATES]
    found = [dict(zip(names, corners[i], strict=True)) for i in chosen]
    for state in found:
        if {"k_d", "k_s"} <= state.keys():
            state["k_d"] = 1 - state["k_s"]
    return found


def most(function: str) -> Albedo | None:
    """The largest albedo of a twin brdf_* of n, l, v; None for all other functions."""
    names = arguments(function)
    if not function.startswith("brdf_") or names[:3] != ("n", "l", "v"):
        return None
    f, found = twin(function), None
    for state in states([name for name in names if name not in DIRECTIONS]):
        values, errors = albedo(partial(f, **state), VIEWS)
        i = int(np.argmax(values - errors))
        if found is None or values[i] - errors[i] > found.largest:
            found = Albedo(float(values[i] - errors[i]), {**state, "theta_v": float(VIEWS[i])}, function in AS_DEFINED)
    return found
