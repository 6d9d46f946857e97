"""What a stage draws into: a picture of four samples a pixel or one, its depth, and a count of its faulty pixels."""

from dataclasses import dataclass
from typing import Any

import moderngl
import numpy as np

from app.problem import Problem

SAMPLES = 4  # a picture at rest; while something moves it is drawn with one


@dataclass(frozen=True)
class Faults:
    """Pixels whose radiance is not a number, infinite or negative."""

    nan: int = 0
    inf: int = 0
    negative: int = 0

    def __bool__(self) -> bool:
        return bool(self.nan or self.inf or self.negative)


class Picture:
    def __init__(self, ctx: moderngl.Context):
        self.ctx, self.size = ctx, (0, 0)
        self.parts: dict[tuple[str, bool], Any] = {}  # by (name, fine)
        self.targets: dict[tuple[tuple[str, ...], bool], moderngl.Framebuffer] = {}

    def resize(self, size: tuple[int, int]) -> None:
        size = max(1, int(size[0])), max(1, int(size[1]))
        if size == self.size:
            return
        limit = self.ctx.info["GL_MAX_TEXTURE_SIZE"]
        if max(size) > limit:
            raise Problem(f"a picture of {size[0]} x {size[1]} pixels is larger than this OpenGL can draw ({limit}).")
        self.release()
        self.size = size

    def target(self, names: tuple[str, ...], fine: bool) -> moderngl.Framebuffer:
        """A framebuffer of these parts, with depth where there is a picture; made when it is first wanted."""
        if (names, fine) not in self.targets:
            depth = self.part("depth", fine) if "picture" in names else None
            self.targets[names, fine] = self.ctx.framebuffer([self.part(name, fine) for name in names], depth)
        return self.targets[names, fine]

    def part(self, name: str, fine: bool) -> Any:
        if (name, fine) not in self.parts:
            samples = SAMPLES if fine else 0
            self.parts[name, fine] = (
                self.ctx.depth_renderbuffer(self.size, samples=samples) if name == "depth" else
                self.ctx.texture(self.size, 4) if name == "picture" and not fine else
                self.ctx.renderbuffer(self.size, 4, samples=samples))
        return self.parts[name, fine]

    @property
    def texture(self) -> moderngl.Texture:
        """With one sample a pixel, as it is shown."""
        return self.part("picture", False)

    def faults(self) -> Faults:
        """The faulty pixels of the last picture that was counted."""
        with self.ctx:
            counted = self.target(("picture", "faults"), False)
            found = np.frombuffer(counted.read(components=4, attachment=1), "u1").reshape(-1, 4)
        if not np.count_nonzero(found.view("<u4") & 0xFFFFFF):
            return Faults()
        return Faults(*(int(np.count_nonzero(found[:, i])) for i in range(3)))

    def pixels(self) -> np.ndarray:
        """uint8 (height, width, 3), the top row first."""
        with self.ctx:
            data = np.frombuffer(self.target(("picture",), False).read(components=3, alignment=1), "u1")
        return data.reshape(self.size[1], self.size[0], 3)[::-1]

    def release(self) -> None:
        for thing in (*self.targets.values(), *self.parts.values()):
            thing.release()
        self.targets, self.parts, self.size = {}, {}, (0, 0)
