"""Raw values: the scene's opaque surfaces drawn once more in floats, a whole picture or one pixel."""

from dataclasses import dataclass

import moderngl
import numpy as np

from app import camera as orbit
from app.gpu.scene_programs import program_of
from app.gpu.stage import Stage
from app.gpu.stage_text import look
from app.gpu.uniforms import give, on_gpu
from app.lesson import Camera
from app.theme import Theme


@dataclass(frozen=True)
class Pick:
    """Raw radiance, before exposure and display, the point, the surface, a mesh's face, the normal it is lit by."""

    surface: str
    radiance: tuple[float, float, float]
    position: tuple[float, float, float]
    face: int
    normal: tuple[float, float, float]


def pick(stage: Stage, values: dict, camera: Camera, theme: Theme, at: tuple[float, float]) -> Pick | None:
    """What lies at a point of the stage's last picture (x, y in [0, 1] from the top left); None on the background."""
    width, height = stage.picture.size
    zoom = np.diag([width, height, 1.0, 1.0])  # the picked pixel fills the picture of one pixel
    zoom[0, 3], zoom[1, 3] = (1 - 2 * at[0]) * width, (2 * at[1] - 1) * height
    matrix = zoom @ orbit.view_projection(camera, width / height)
    radiance, position, normal = raw(stage, values, camera, theme, (1, 1), matrix)
    if radiance[0, 0, 3] < 0.5:
        return None
    name = stage.scene.surfaces[int(radiance[0, 0, 3]) - 1].name
    (r, g, b, _), (x, y, z, face) = radiance[0, 0].tolist(), position[0, 0].tolist()
    n_x, n_y, n_z, _ = normal[0, 0].tolist()
    return Pick(name, (r, g, b), (x, y, z), int(face), (n_x, n_y, n_z))


def raw(stage: Stage, values: dict, camera: Camera, theme: Theme, size: tuple[int, int],
        matrix: np.ndarray | None = None) -> tuple[np.ndarray, ...]:
    """Three float32 pictures (height, width, 4), the top row first: radiance and the surface's number from 1, 0 where
    there is none; position and face; normal. `matrix` takes the camera's place."""
    surfaces = [i for i, s in enumerate(stage.scene.surfaces) if s.opacity >= 1]
    names = tuple({f"{program_of(stage.scene.surfaces[i])} values" for i in surfaces})
    matrix = orbit.view_projection(camera, size[0] / size[1]) if matrix is None else matrix
    ctx = stage.ctx
    with ctx:
        stage.decide(values)
        for name in names:
            stage.own.add(name)
        parts = [ctx.renderbuffer(size, 4, dtype="f4") for _ in range(3)]
        parts.append(ctx.depth_renderbuffer(size))
        target, before = ctx.framebuffer(parts[:3], parts[3]), ctx.fbo
        for name in names:
            give(stage.programs[name], view_projection=matrix.T.astype("f4").tobytes(),
                 camera_position=tuple(orbit.position(camera)), **on_gpu(stage.scene, values), **look(theme))
        target.use()
        target.clear()
        ctx.enable_only(moderngl.DEPTH_TEST)
        for i in surfaces:
            stage.paint_surface(i, "values")
        ctx.enable_only(moderngl.NOTHING)
        found = [np.frombuffer(target.read(components=4, attachment=i, dtype="f4"), "f4") for i in range(3)]
        before.use()
        target.release()
        for part in parts:
            part.release()
    return tuple(one.reshape(size[1], size[0], 4)[::-1] for one in found)
