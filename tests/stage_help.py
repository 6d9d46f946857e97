"""What the tests of the GPU share: a watch over what OpenGL made, small scenes, and a picture's numbers."""

import moderngl
import numpy as np

from app import camera as orbit
from app.gpu.context import context
from app.gpu.stage import Stage
from app.gpu.stage_text import Source
from app.lesson import Camera, Scene, Surface
from app.theme import THEMES, rgb

KINDS = ("buffer", "texture", "renderbuffer", "depth_renderbuffer", "framebuffer", "vertex_array")


def watch(monkeypatch) -> list:
    """Everything made on the GPU from now to the end of the test, in order."""
    found: list = []
    for kind in KINDS:
        original = getattr(moderngl.Context, kind)

        def watched(self, *args, original=original, **kwargs):
            found.append(original(self, *args, **kwargs))
            return found[-1]

        monkeypatch.setattr(moderngl.Context, kind, watched)
    return found


def is_alive(thing) -> bool:
    return type(thing.mglo).__name__ != "InvalidObject"


DARK = THEMES["dark"]
BACKGROUND = np.rint(255 * np.array(rgb(DARK.background))).astype(int)
ABOVE = Camera(azimuth=-90.0, elevation=90.0, distance=5.0)  # straight down: +x to the right, +y up
SQUARE = "vec3 surface_point(int surface, vec2 s) { return vec3(2.0 * s - 1.0, 0.0); }\n"  # [-1, 1] x [-1, 1], z = 0


def build(glsl: str, triangles=None, **parts) -> Stage:
    parts.setdefault("surfaces", (Surface("square", cells=(1, 1)),) if "surface_point" in glsl else ())
    return Stage(context(), Source(Scene(glsl, **parts), "lessons/test.py", 1), triangles)


def picture(stage: Stage, values=None, camera: Camera = ABOVE, size=(96, 96), fine: bool = False) -> np.ndarray:
    stage.draw(values or {}, camera, size, DARK, fine)
    return stage.picture.pixels().astype(int)


def drawn(pixels: np.ndarray) -> np.ndarray:
    """Where the picture is not the background."""
    return np.any(np.abs(pixels - BACKGROUND) > 2, axis=-1)


def rays(camera: Camera, size: tuple[int, int]) -> tuple[np.ndarray, np.ndarray]:
    """The eye, and the unit direction through the centre of each pixel, rows from the top: (3,), (height, width, 3)."""
    x = (np.arange(size[0]) + 0.5) / size[0] * 2 - 1
    y = 1 - (np.arange(size[1]) + 0.5) / size[1] * 2
    clip = np.stack([*np.meshgrid(x, y), np.zeros(size[::-1]), np.ones(size[::-1])], -1)
    world = clip @ np.linalg.inv(orbit.view_projection(camera, size[0] / size[1])).T
    eye = orbit.position(camera)
    way = world[..., :3] / world[..., 3:] - eye
    return eye, way / np.linalg.norm(way, axis=-1, keepdims=True)


def on_screen(point, camera: Camera, size: tuple[int, int]) -> np.ndarray:
    """A world point in pixels from the top left."""
    return orbit.project(np.asarray(point, float), orbit.view_projection(camera, size[0] / size[1]))[..., :2] * size
