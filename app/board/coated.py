"""Lambert under Cook-Torrance, each of three channels: the model that measurements are fitted with."""

from dataclasses import dataclass
from functools import cache

import numpy as np

from app import shader
from app.badges import SAME, SAME_FLOAT32, Badge
from app.board.brdf_file import Default, Parameter
from app.board.fit import Fit
from app.board.verdict import worst_of
from app.optics.cook_torrance import brdf_cook_torrance
from app.optics.lambert import brdf_lambert
from app.shader import Overrides

PARAMETERS = (Parameter("m", "float", 0.005, 2.0, 0.3, 0), Parameter("rho", "color", 0, 1, (0.5, 0.5, 0.5), 0),
              Parameter("f0", "color", 0, 1, (0.04, 0.04, 0.04), 0))


def declared(prefix: str) -> str:
    return (f"uniform float {prefix}m; uniform vec3 {prefix}rho, {prefix}f0;\n"
            '#include "core/constants.glsl"\n#include "optics/cook_torrance.glsl"')


def value(prefix: str) -> str:
    """The model as an expression of n, l and v; the three channels have D and G in common."""
    share = ", ".join(f"f_schlick(0.5 * length(l + v), {prefix}f0.{c})" for c in "rgb")
    return f"{prefix}rho / PI + cook_torrance_dg(n, l, v, {prefix}m) * vec3({share})"


TEXT = f"{declared('')}\nvec3 coated(vec3 n, vec3 l, vec3 v) {{ return {value('')}; }}"


@cache
def made_of() -> frozenset[str]:
    """The functions of the course in it."""
    return frozenset(shader.assemble(TEXT, "coated", entry=("coated",)).kept)


@dataclass(frozen=True)
class Coated:
    name: str = "coated"
    of: Fit | None = None
    warnings: tuple[str, ...] = ()
    edits: Overrides = ()  # the user's texts, where the GLSL is made of them
    is_anisotropic = False

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """A fit's values are the defaults."""
        found = self.of.values if self.of else {}
        return tuple(Parameter(p.name, p.type, p.low, p.high, found.get(p.name, p.default), 0) for p in PARAMETERS)

    def rgb(self, n, l, v, values: dict[str, Default] | None = None, x=None) -> np.ndarray:
        """float64 values (..., 3) in 1/sr at unit vectors (..., 3); float32 of the user's texts."""
        given = {p.name: p.default for p in self.parameters} | (values or {})
        if self.edits:
            from app.gpu.evaluate import evaluate

            return evaluate("coated", {"n": n, "l": l, "v": v}, TEXT, overrides=dict(self.edits), uniforms=given)
        n, l, v = (np.asarray(x, float)[..., None, :] for x in (n, l, v))
        return (brdf_lambert(n, l, v, np.asarray(given["rho"]))
                + brdf_cook_torrance(n, l, v, given["m"], np.asarray(given["f0"])))

    def is_grey(self, values: dict[str, Default] | None = None) -> bool:
        given = {p.name: p.default for p in self.parameters} | (values or {})
        return all(len(set(given[name])) == 1 for name in ("rho", "f0"))  # type: ignore[arg-type]

    def badges(self, values: dict[str, Default] | None = None) -> dict[str, Badge]:
        return worst_of(lambda n, l, v, channel: self.rgb(n, l, v, values)[..., channel],
                        1 if self.is_grey(values) else 3, SAME_FLOAT32 if self.edits else SAME)
