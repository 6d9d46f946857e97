"""Frames of 512 x 512 of every scene, ended with glFinish: without it llvmpipe has not drawn anything yet."""

from app import catalog
from app.export.still import data
from app.gpu.context import context
from app.gpu.stage import Stage
from app.gpu.stage_text import Source
from app.lesson import Camera, Scene
from app.state import defaults
from app.theme import THEMES
from tests.bench.rows import Job, Row, in_turn, timed

SIZE = (512, 512)
ASKED = 3.0


def jobs() -> dict[str, Job]:
    ctx, theme = context(), THEMES["dark"]
    empty = Stage(ctx, Source(Scene("")))
    found = {"an empty frame": timed(lambda: (empty.draw({}, Camera(), SIZE, theme, False, False), ctx.finish()))}
    for step in catalog.steps():
        values = defaults(step)
        values |= data(step, values)
        stage = Stage(ctx, Source(step.step.scene, step.file_name, step.glsl_line), values.get("triangles"))
        for fine in (False, True):
            def draw(stage=stage, values=values, camera=step.step.scene.camera, fine=fine) -> None:
                stage.draw(values, camera, SIZE, theme, fine, counted=fine)
                ctx.finish()

            found[f"{step.id}, {'at rest (4 samples)' if fine else 'moving'}"] = timed(draw)
    return found


def frames(rounds: int = 25) -> list[Row]:
    """An empty frame is the reference."""
    made = jobs()
    return in_turn(made, rounds, asked={name: ASKED for name in made if name.endswith("moving")})
