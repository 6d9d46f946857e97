"""A `.brdf` file as a function of directions, computed by the GLSL in it, and its badges.

Its names get a prefix, so that several files, and a scene, fit into one program; messages are told without it.
"""

import re
from functools import cached_property

import numpy as np

from app import shader
from app.badges import SAME_FLOAT32, Badge, samples
from app.board.brdf_file import BrdfFile, Default
from app.board.verdict import worst_of
from app.hemisphere import NORMAL, frame
from app.problem import Problem


def prefixed(file: BrdfFile, prefix: str) -> shader.Source:
    """The file's GLSL with its parameters as uniforms, every name of its top level behind the prefix."""
    text, first = file.shader.text, file.shader.first
    names = {name for block in shader.blocks(shader.resolve(text, file.path, first)) for name in block.names}
    names = (names | {p.name for p in file.parameters}) - {shader.ALWAYS}
    if not names:
        return file.shader
    word = re.compile(rf"(?<![.\w])({'|'.join(map(re.escape, sorted(names)))})(?!\w)")
    return shader.Source(word.sub(lambda m: prefix + m[1], text), file.path, first, is_own=True)


def uniforms(file: BrdfFile, prefix: str) -> str:
    """One line, so that line numbers stay as they are."""
    return " ".join(f"uniform {p.glsl} {prefix}{p.name};" for p in file.parameters)


class BrdfModel:
    def __init__(self, file: BrdfFile, prefix: str = "model0_", overrides: dict[str, shader.Source] | None = None):
        self.file, self.prefix = file, prefix
        self.name, self.parameters, self.warnings = file.name, file.parameters, file.warnings
        call = (f"vec3 value_of_model(vec3 n, vec3 l, vec3 v, vec3 x, vec3 y) "
                f"{{ return {self.prefix}BRDF(l, v, n, x, y); }}")
        self.text = "\n".join([uniforms(file, self.prefix), '#include "model"', call])
        self.overrides = overrides or {"model": prefixed(file, self.prefix)}

    @cached_property
    def is_anisotropic(self) -> bool:
        """Whether its GLSL makes use of X or Y."""
        code = "\n".join("\n".join(shader.strip_comments(one.text.split("\n"))) for one in self.overrides.values())
        signature = shader.signatures(self.file.shader.text)["BRDF"]
        return any(len(re.findall(rf"\b{a.name}\b", code)) > 1 for a in signature.args[3:])

    def rgb(self, n, l, v, values: dict[str, Default] | None = None, x=None) -> np.ndarray:
        """float32 values (..., 3) in 1/sr at unit vectors (..., 3); `x` is X, across n and, where it is left to us,
        as `frame` has it."""
        from app.gpu.evaluate import evaluate

        x = frame(n)[0] if x is None else x
        y = np.cross(n, x)
        given = {self.prefix + name: value for name, value in (self.file.defaults | (values or {})).items()}
        try:
            return evaluate("value_of_model", {"n": n, "l": l, "v": v, "x": x, "y": y}, self.text,
                            overrides=self.overrides, uniforms=given)
        except Problem as problem:
            lines = str(problem).replace(self.prefix, "").split("\n")
            of_file = [line for line in lines if not line.startswith("value_of_model,")]  # ours, which follows from it
            raise Problem("\n".join(of_file or lines)) from None

    def badges(self, values: dict[str, Default] | None = None) -> dict[str, Badge]:
        """The worst of the three channels; a grey model is asked once. Below the horizon a file's word counts nothing:
        the explorer never asks there."""
        def reflect(n, l, v, channel):
            return np.where(above(l, v), self.rgb(n, l, v, values), 0)[..., channel]

        return worst_of(reflect, 1 if self.is_grey(values) else 3, SAME_FLOAT32)

    def is_grey(self, values: dict[str, Default] | None = None) -> bool:
        """Whether its channels are the same, at the directions that badges look at."""
        rgb = self.rgb(NORMAL, *samples(), values)
        return bool(np.array_equal(rgb, np.broadcast_to(rgb[..., :1], rgb.shape), equal_nan=True))


def above(l, v) -> np.ndarray:
    return ((l[..., 2] > 0) & (v[..., 2] > 0))[..., None]
