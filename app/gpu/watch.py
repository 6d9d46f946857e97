"""Whether the loops of a user's texts end at given values: a small picture is drawn, and its pixels tell."""

from typing import Any, cast

import moderngl
import numpy as np

from app import camera as orbit
from app.gpu.context import endless
from app.gpu.stage import Stage
from app.gpu.uniforms import give, on_gpu
from app.lesson import Camera
from app.shader import Assembled

SIZE = 48, 27


def watch(stage: Stage, values: dict, camera: Camera) -> None:
    """A Problem at the user's line where a loop was left; nothing where no text has a loop."""
    ctx, scene = stage.ctx, stage.scene
    with ctx:
        stage.decide(values)
    if not stage.own.made.watched:
        return
    given = {"view_projection": orbit.view_projection(camera, SIZE[0] / SIZE[1]).T.astype("f4").tobytes(),
             "viewport": SIZE, "camera_position": tuple(orbit.position(camera)), "dot_size": 1.0}
    with ctx:
        stage.take_tables(values)
        for use in stage.programs.values():
            give(use, **on_gpu(stage.scene, values), **given)
        parts = [ctx.renderbuffer(SIZE, 4, dtype=kind) for kind in ("f1", "f1", "f4")]
        target, before = ctx.framebuffer(parts), ctx.fbo
        target.use()
        ctx.enable_only(moderngl.BLEND | moderngl.PROGRAM_POINT_SIZE)
        ctx.blend_equation = cast(Any, moderngl.MAX)  # the picture is of one program: the last line in its text is told
        try:
            for name, pair in stage.own.made.watched.items():
                target.clear()
                for i, called in stage.own.made.drawn_by.items():
                    if called == name:
                        stage.paint_surface(i)
                if name == "dots":
                    stage.paint_dots(values)
                for i, mark in enumerate(scene.marks if name == "mark" else ()):
                    stage.paint_mark(i, mark)
                told(np.frombuffer(target.read(components=4, attachment=2, dtype="f4"), "f4"), pair)
            if "probe" in stage.own.made.watched:
                stage.probes(values)
            if "anchor" in stage.own.made.watched:
                stage.anchors(values)
        finally:
            ctx.blend_equation = cast(Any, moderngl.FUNC_ADD)
            ctx.enable_only(moderngl.NOTHING)
            before.use()
            target.release()
            for part in parts:
                part.release()


def told(pixels: np.ndarray, pair: tuple[Assembled, Assembled | None]) -> None:
    in_fragment, in_vertex = pixels.reshape(-1, 4)[:, :2].max(0).astype(int).tolist()
    if in_vertex:
        raise endless(in_vertex, pair[0])
    if in_fragment and pair[1]:
        raise endless(in_fragment, pair[1])
