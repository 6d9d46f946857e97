"""Frames of 512 x 512 of every scene, ended with glFinish: without it llvmpipe has not drawn anything yet."""

from app import catalog
from app.export.still import data
from app.gpu.context import context
from app.gpu.stage import Stage
from app.gpu.stage_text import Source
from app.lesson import Camera, Scene, Surface
from app.state import defaults
from app.theme import THEMES
from tests.bench.rows import Job, Row, in_turn, timed

SIZE = (512, 512)
ASKED = 3.0
LIT, LIT_ASKED = "a sphere lit by Cook-Torrance", 2.0
SPHERE = Scene("""
#include "optics/cook_torrance.glsl"
#include "display/facing_ball.glsl"
uniform float m;
vec3 surface_point(int surface, vec2 s) { return facing_ball(s, vec3(0.0), 1.0); }
vec3 shade(Surface s) {
    vec3 n = s.position, l = vec3(-0.48, -0.6, 0.64), f0 = vec3(0.95, 0.64, 0.54);
    float n_dot_l = dot(n, l), x = 1.0 - 0.5 * length(l + s.v), x2 = x * x;
    return max(n_dot_l, 0.0) * cook_torrance_dg(n, l, s.v, m) * (f0 + (1.0 - f0) * x2 * x2 * x);
}
""", (Surface("sphere", cells=(48, 10)),), camera=Camera(azimuth=-90, elevation=0, distance=12, field_of_view=12))


def jobs() -> dict[str, Job]:
    ctx, theme = context(), THEMES["dark"]
    empty = Stage(ctx, Source(Scene("")))
    found = {"an empty frame": timed(lambda: (empty.draw({}, Camera(), SIZE, theme, False, False), ctx.finish()))}
    sphere = Stage(ctx, Source(SPHERE))
    found[LIT] = timed(lambda: (sphere.draw({"m": 0.3}, SPHERE.camera, SIZE, theme, False, False), ctx.finish()))
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
    return in_turn(made, rounds, asked={LIT: LIT_ASKED} | {name: ASKED for name in made if name.endswith("moving")})
