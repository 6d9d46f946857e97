"""A GLSL function as a picture: one value of it at every place of a rectangle of the floor, drawn as a frame."""

from typing import Any, cast

import moderngl
import numpy as np

from app import shader
from app.gpu.context import context, program
from app.gpu.evaluate import find

CORNERS = "void main() { gl_Position = vec4(4.0 * vec2(gl_VertexID & 1, gl_VertexID >> 1) - 1.0, 0.0, 1.0); }"


class Frame:
    """`place` is the argument (vec3) that is the pixel's place; with `seed` every pixel has a pattern of its own."""

    def __init__(self, function: str, place: str, size: tuple[int, int], low: tuple[float, float],
                 high: tuple[float, float], seed: bool = False):
        include, signature = find(function, None)
        self.size, self.low, self.high, self.ctx = size, low, high, context()
        self.others = [a for a in signature.args if a.name != place]
        call = ", ".join("place()" if a.name == place else "in_seed + own()" if seed and a.name == "seed" else
                         f"in_{a.name}" for a in signature.args)
        text = "\n".join([
            f'#include "{include}"', "uniform vec4 frame_window;",
            *(f"uniform {a.type} in_{a.name};" for a in self.others), "out float value;",
            "vec3 place() { return vec3(frame_window.xy + frame_window.zw * gl_FragCoord.xy, 0.0); }",
            "int own() { return int(gl_FragCoord.x) + 8192 * int(gl_FragCoord.y); }" if seed else "",
            f"void main() {{ value = {function}({call}); }}"])
        with self.ctx:
            self.program = program(self.ctx, shader.assemble(CORNERS, "frame.vert", header=shader.DESKTOP),
                                   shader.assemble(text, function, header=shader.DESKTOP))
            self.texture = self.ctx.texture(size, 1, dtype="f4")
            self.target = self.ctx.framebuffer([self.texture])
            self.array = self.ctx.vertex_array(self.program, [])

    @property
    def places(self) -> np.ndarray:
        """The middles of the pixels, (height, width, 3)."""
        axes = [low + (high - low) * (np.arange(n) + 0.5) / n
                for low, high, n in zip(self.low, self.high, self.size, strict=True)]
        x, y = np.meshgrid(*axes)
        return np.stack([x, y, 0 * x], -1)

    def draw(self, values: dict) -> None:
        """One frame, and the wait until it is there."""
        with self.ctx:
            step = [(high - low) / n for low, high, n in zip(self.low, self.high, self.size, strict=True)]
            given: dict[str, Any] = {"frame_window": (*self.low, *step)}
            given |= {f"in_{a.name}": values[a.name] for a in self.others}
            for name in given.keys() & set(self.program):
                cast(Any, self.program[name]).value = given[name]
            before = self.ctx.fbo
            self.target.use()
            self.array.render(moderngl.TRIANGLES, 3)
            self.ctx.finish()
            before.use()

    def read(self) -> np.ndarray:
        """(height, width) float32."""
        with self.ctx:
            return np.frombuffer(self.target.read(components=1, dtype="f4"), "f4").reshape(self.size[::-1])

    def release(self) -> None:
        with self.ctx:
            for thing in (self.array, self.target, self.texture):
                thing.release()
