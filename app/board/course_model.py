"""A BRDF of the course by its short name (`cook_torrance` for `brdf_cook_torrance`), like a file's model."""

from dataclasses import dataclass

import numpy as np

from app import optics
from app.badges import SAME, SAME_FLOAT32, Badge
from app.board.brdf_file import Default, Parameter
from app.board.verdict import worst_of
from app.quantities import quantity
from app.shader import Overrides

PREFIX = "brdf_"
VECTORS, GIVEN = ("n", "l", "v"), ("channel", "radiance")


def names() -> list[str]:
    """Those that are functions of n, l and v."""
    return sorted(name.removeprefix(PREFIX) for name in optics.names()
                  if name.startswith(PREFIX) and optics.arguments(name)[:3] == VECTORS)


@dataclass(frozen=True)
class CourseModel:
    name: str  # without the prefix
    warnings: tuple[str, ...] = ()
    edits: Overrides = ()  # the user's texts, where the function is made of them
    is_anisotropic = False

    @property
    def function(self) -> str:
        return PREFIX + self.name

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """From the table of quantities, in the units of the formula (angles in radians)."""
        found = []
        for name in optics.arguments(self.function):
            if name not in (*VECTORS, *GIVEN):
                q = quantity(name)
                found.append(Parameter(name, "float", q.low, q.high, float(q.default), 0,  # type: ignore[arg-type]
                                       q.scale, q.unit, q.kind == "int"))
        return tuple(found)

    def is_grey(self, values: dict[str, Default] | None = None) -> bool:
        return "channel" not in optics.arguments(self.function)

    def value(self, n, l, v, values: dict[str, Default] | None = None, channel: int = 0) -> np.ndarray:
        """float64 values in 1/sr at unit vectors (..., 3)."""
        given: dict = {p.name: p.default for p in self.parameters} | (values or {})
        given |= {p.name: round(given[p.name]) for p in self.parameters if p.whole}
        given |= {name: value for name, value in (("channel", channel), ("radiance", 1.0)) if name in
                  optics.arguments(self.function)}
        if self.edits:
            from app.gpu.evaluate import evaluate

            return evaluate(self.function, {"n": n, "l": l, "v": v, **given}, overrides=dict(self.edits))
        return np.asarray(optics.twin(self.function)(n=n, l=l, v=v, **given))

    def rgb(self, n, l, v, values: dict[str, Default] | None = None, x=None) -> np.ndarray:
        """The three channels (..., 3); those of a grey model are the same."""
        found = [self.value(n, l, v, values, channel) for channel in range(1 if self.is_grey() else 3)]
        return np.stack((found * 3)[:3], -1)

    def badges(self, values: dict[str, Default] | None = None) -> dict[str, Badge]:
        return worst_of(lambda n, l, v, channel: self.value(n, l, v, values, channel), 1 if self.is_grey() else 3,
                        SAME_FLOAT32 if self.edits else SAME)
