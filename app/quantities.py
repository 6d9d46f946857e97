"""One table by parameter name: symbol, unit, ranges, scale, default and meaning of every argument a twin can have.

It drives slider limits and labels, test grids, stability grids, axis titles and tool-tips. Angles are radians inside
and degrees on screen; `shown` and `entered` convert.
"""

import math
from dataclasses import dataclass
from typing import Literal

from app.lesson import Number
from app.problem import Usage, near


@dataclass(frozen=True)
class Quantity:
    symbol: str  # LaTeX
    unit: str
    low: float
    high: float
    default: Number
    words: str
    extreme: tuple[float, float] | None = None  # beyond the ordinary range; None: the same
    scale: Literal["linear", "log"] = "linear"
    kind: Literal["float", "int", "vec2", "vec3"] = "float"

    @property
    def is_angle(self) -> bool:
        return self.unit == "rad"

    @property
    def screen_unit(self) -> str:
        return "°" if self.is_angle else self.unit

    @property
    def width(self) -> int:
        return {"vec2": 2, "vec3": 3}.get(self.kind, 1)


TAU, PI = 2 * math.pi, math.pi

TABLE: dict[str, Quantity] = {
    # directions and cones
    "half_angle": Quantity(r"\theta", "rad", 0.0, PI, 0.6, "half the opening angle of a cone", extreme=(1e-12, PI)),
    "theta": Quantity(r"\theta", "rad", 0.0, PI / 2, 0.6, "polar angle from the normal", extreme=(0.0, PI)),
    "phi": Quantity(r"\varphi", "rad", -PI, PI, 0.4, "azimuth around the normal"),
    "d_theta": Quantity(r"\Delta\theta", "rad", 0.01, 1.0, 0.2, "height of a cell in polar angle", extreme=(1e-8, PI)),
    "d_phi": Quantity(r"\Delta\varphi", "rad", 0.01, 1.0, 0.2, "width of a cell in azimuth", extreme=(1e-8, TAU)),
    # the patch
    "distance": Quantity("r", "m", 0.5, 5.0, 2.0, "distance from the eye point", extreme=(1e-6, 1e8), scale="log"),
    "tilt": Quantity(r"\beta", "rad", -PI / 2, PI / 2, 0.0, "angle between the patch's normal and the line of sight"),
    "width": Quantity("w", "m", 0.05, 2.0, 0.8, "side of the square patch", extreme=(1e-6, 1e4), scale="log"),
    "samples": Quantity("N", "", 64, 16384, 2048, "number of counted points", extreme=(1, 60000), scale="log", kind="int"),
    "s": Quantity("s", "", 0.0, 1.0, 0.5, "first coordinate in the unit square"),
    "t": Quantity("t", "", 0.0, 1.0, 0.5, "second coordinate in the unit square"),
}


def quantity(name: str) -> Quantity:
    if name not in TABLE:
        raise Usage(f"there is no quantity {name}.{near(name, TABLE)}")
    return TABLE[name]


def shown(name: str, value: Number) -> Number:
    """A value as the screen shows it: angles in degrees."""
    return scaled(value, 180 / PI) if quantity(name).is_angle else value


def entered(name: str, value: Number) -> Number:
    """A value typed in screen units, as the formulas want it."""
    return scaled(value, PI / 180) if quantity(name).is_angle else value


def scaled(value: Number, factor: float) -> Number:
    return tuple(x * factor for x in value) if isinstance(value, tuple) else value * factor
