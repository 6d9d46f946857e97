"""A BRDF of the course by its short name (`cook_torrance` for `brdf_cook_torrance`), like a file's model."""

from dataclasses import dataclass

import numpy as np

from app import optics
from app.badges import Badge, check
from app.board.brdf_file import Default, Parameter
from app.quantities import quantity

PREFIX = "brdf_"
VECTORS = ("n", "l", "v")


def names() -> list[str]:
    return sorted(name.removeprefix(PREFIX) for name in optics.names() if name.startswith(PREFIX))


@dataclass(frozen=True)
class CourseModel:
    name: str  # without the prefix

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """From the table of quantities, in the units of the formula (angles in radians)."""
        found = []
        for name in optics.arguments(PREFIX + self.name):
            if name not in VECTORS:
                q = quantity(name)
                found.append(Parameter(name, "float", q.low, q.high, float(q.default), 0))  # type: ignore[arg-type]
        return tuple(found)

    def value(self, n, l, v, values: dict[str, Default] | None = None) -> np.ndarray:
        """float64 values in 1/sr at unit vectors (..., 3)."""
        given = {p.name: p.default for p in self.parameters} | (values or {})
        return np.asarray(optics.twin(PREFIX + self.name)(n=n, l=l, v=v, **given))

    def badges(self, values: dict[str, Default] | None = None) -> dict[str, Badge]:
        return check(lambda n, l, v: self.value(n, l, v, values))
