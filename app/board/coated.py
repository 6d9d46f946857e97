"""Lambert under Cook-Torrance, each of three channels: the model that measurements are fitted with."""

from dataclasses import dataclass

import numpy as np

from app.badges import Badge
from app.board.brdf_file import Default, Parameter
from app.board.fit import Fit
from app.board.verdict import worst_of
from app.optics.cook_torrance import brdf_cook_torrance
from app.optics.lambert import brdf_lambert

PARAMETERS = (Parameter("m", "float", 0.005, 2.0, 0.3, 0), Parameter("rho", "color", 0, 1, (0.5, 0.5, 0.5), 0),
              Parameter("f0", "color", 0, 1, (0.04, 0.04, 0.04), 0))


@dataclass(frozen=True)
class Coated:
    name: str = "coated"
    of: Fit | None = None
    warnings: tuple[str, ...] = ()

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """A fit's values are the defaults."""
        found = self.of.values if self.of else {}
        return tuple(Parameter(p.name, p.type, p.low, p.high, found.get(p.name, p.default), 0) for p in PARAMETERS)

    def rgb(self, n, l, v, values: dict[str, Default] | None = None) -> np.ndarray:
        """float64 values (..., 3) in 1/sr at unit vectors (..., 3)."""
        given = {p.name: p.default for p in self.parameters} | (values or {})
        n, l, v = (np.asarray(x, float)[..., None, :] for x in (n, l, v))
        return (brdf_lambert(n, l, v, np.asarray(given["rho"]))
                + brdf_cook_torrance(n, l, v, given["m"], np.asarray(given["f0"])))

    def is_grey(self, values: dict[str, Default] | None = None) -> bool:
        given = {p.name: p.default for p in self.parameters} | (values or {})
        return all(len(set(given[name])) == 1 for name in ("rho", "f0"))  # type: ignore[arg-type]

    def badges(self, values: dict[str, Default] | None = None) -> dict[str, Badge]:
        return worst_of(lambda n, l, v, channel: self.rgb(n, l, v, values)[..., channel],
                        1 if self.is_grey(values) else 3)
