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
    "samples": Quantity("N", "", 64, 16384, 2048, "number of counted points", (1, 60000), "log", "int"),
    "index": Quantity("i", "", 0, 63, 0, "number of a point, from 0", extreme=(0, 59999), kind="int"),
    "rows": Quantity("N", "", 2, 64, 8, "rows of cells from pole to pole", extreme=(1, 10000), scale="log", kind="int"),
    "towards": Quantity("d", "", -1.0, 1.0, (0.0, 0.0, 1.0), "unit vector of a ray from the eye", kind="vec3"),
    "s": Quantity("s", "", 0.0, 1.0, 0.5, "first coordinate in the unit square"),
    "t": Quantity("t", "", 0.0, 1.0, 0.5, "second coordinate in the unit square"),
    # disks, spheres, rectangles
    "radius": Quantity("r_0", "m", 0.05, 2.0, 0.5, "radius of a sphere or disk", extreme=(1e-6, 1e4), scale="log"),
    "height": Quantity("h", "m", 0.05, 5.0, 1.0, "height over a plane", extreme=(1e-6, 1e4), scale="log"),
    "offset": Quantity(r"\rho_0", "m", 0.0, 5.0, 0.5, "sideways distance from an axis", extreme=(0.0, 1e4)),
    "depth": Quantity("d_0", "m", 0.05, 2.0, 0.8, "the other side of a rectangle", extreme=(1e-6, 1e4), scale="log"),
    "x0": Quantity("x_0", "m", -2.0, 2.0, -0.5, "left edge of a rectangle", extreme=(-1e3, 1e3)),
    "x1": Quantity("x_1", "m", -2.0, 2.0, 0.5, "right edge of a rectangle", extreme=(-1e3, 1e3)),
    "y0": Quantity("y_0", "m", -2.0, 2.0, -0.5, "lower edge of a rectangle", extreme=(-1e3, 1e3)),
    "y1": Quantity("y_1", "m", -2.0, 2.0, 0.5, "upper edge of a rectangle", extreme=(-1e3, 1e3)),
    # triangles, polygons, meshes, seen from the origin or from the eye
    "a": Quantity("A", "m", -2.0, 2.0, (-0.5, -0.5, 1.0), "first corner of a triangle", kind="vec3"),
    "b": Quantity("B", "m", -2.0, 2.0, (0.5, -0.5, 1.0), "second corner of a triangle", kind="vec3"),
    "c": Quantity("C", "m", -2.0, 2.0, (0.0, 0.6, 1.0), "third corner of a triangle", kind="vec3"),
    "ab": Quantity("AB", "m", -2.0, 2.0, (1.0, 0.0, 0.0), "edge of a triangle, from A to B", kind="vec3"),
    "ac": Quantity("AC", "m", -2.0, 2.0, (0.5, 1.1, 0.0), "edge of a triangle, from A to C", kind="vec3"),
    "area": Quantity("N", "m^2", -4.0, 4.0, (0.0, 0.0, 1.1), "area vector of a triangle, AB x AC", kind="vec3"),
    "eye": Quantity("E", "m", -2.0, 2.0, (0.0, 0.0, 0.0), "the point from which it is seen", kind="vec3"),
    "corner_count": Quantity("n", "", 3, 5, 5, "corners of the polygon", kind="int"),
    "corner_a": Quantity("P_1", "", -1.0, 1.0, (-0.6, -0.5), "first corner of the outline", kind="vec2"),
    "corner_b": Quantity("P_2", "", -1.0, 1.0, (0.6, -0.5), "second corner of the outline", kind="vec2"),
    "corner_c": Quantity("P_3", "", -1.0, 1.0, (0.7, 0.3), "third corner of the outline", kind="vec2"),
    "corner_d": Quantity("P_4", "", -1.0, 1.0, (0.0, 0.8), "fourth corner of the outline", kind="vec2"),
    "corner_e": Quantity("P_5", "", -1.0, 1.0, (-0.7, 0.3), "fifth corner of the outline", kind="vec2"),
    "size": Quantity("S", "m", 1e-3, 2.0, 1.0, "scale of the outline", extreme=(1e-5, 1e3), scale="log"),
    "shape": Quantity("k", "", 0, 9, 0, "which of the scene's meshes", kind="int"),
    "x": Quantity("x", "m", -2.0, 2.0, 0.0, "the eye, sideways"),
    "y": Quantity("y", "m", -2.0, 2.0, 0.0, "the eye, up or down"),
    # the Fresnel term
    "l_dot_h": Quantity(r"l \cdot h", "", 0.0, 1.0, 0.7, "cosine between the light and the facet's normal"),
    "eta": Quantity(r"\eta", "", 1.0, 3.0, 1.5, "index of the far side over the near side's", (0.35, 10.0), "log"),
    "k": Quantity("k", "", 0.0, 10.0, 3.0, "extinction: the imaginary part of a metal's index", extreme=(0.0, 30.0)),
    "f0": Quantity("F_0", "", 0.0, 0.95, 0.04, "share reflected at normal incidence", extreme=(0.0, 0.99)),
    "f82": Quantity("F_{82}", "", 0.0, 1.0, 0.5, "share reflected at 82 degrees, l.h = 1/7"),
    "polariser": Quantity(r"\psi", "rad", 0.0, PI / 2, 0.0, "turn of the polariser before the eye"),
    "material": Quantity("i", "", 0, 9, 5, "which row of the tables of materials", kind="int"),
    "channel": Quantity("c", "", 0, 2, 0, "colour channel: red, green, blue", kind="int"),
    "wavelength_index": Quantity("j", "", 0, 11, 6, "which of twelve wavelengths", kind="int"),
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
