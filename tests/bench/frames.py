"""Frames of 512 x 512 of every scene, ended with glFinish: without it llvmpipe has not drawn anything yet."""

import os
from dataclasses import replace
from itertools import count, cycle

from app import catalog, edit
from app.export.still import data
from app.gpu.context import context
from app.gpu.stage import Stage
from app.gpu.stage_text import Source
from app.lesson import Camera, Scene, Surface
from app.state import defaults
from app.theme import THEMES
from tests.bench.rows import Job, Row, in_turn, timed

SIZE = (512, 512)
EDITED = ("microfacets/cook_torrance", "d_beckmann"), ("microfacets/cook_torrance", "shade"), (
    "plausible_shading/board", "d_beckmann"), ("plausible_shading/everything", "d_beckmann"), (
    "board/cook_torrance", "d_beckmann"), ("board/cook_torrance+oren_nayar+phong", "d_beckmann")
TYPED = {"d_beckmann": "m *= 1.0 + {}e-5;", "shade": "s.v *= 1.0 + {}e-5;"}  # each time another formula
ASKED_OF_A_KEY = 100.0
FLIPPED = {"lights/area_sampled": "sampling", "lights/area_work": "sampling", "plausible_shading/board": "shows"}
ASKED, ASKED_OF_A_BALL = 3.0, 2.0
BALL = """
#include "display/balls.glsl"
#include "optics/cook_torrance.glsl"
uniform float m;

vec3 surface_point(int surface, vec2 s) {
    return cap_to_eye(s, vec3(0.0), 1.0);
}

vec3 shade(Surface s) {
    vec3 n = ball_normal(s.position, s.v), l = normalize(vec3(0.4, -0.5, 0.8));
    return PI * max(dot(n, l), 0.0) * (vec3(0.05, 0.01, 0.01) + brdf_cook_torrance(n, l, s.v, m, 0.9));
}
"""


def jobs() -> dict[str, Job]:
    empty, ball = Scene(""), Scene(BALL, surfaces=(Surface("ball", cells=(64, 3)),), camera=Camera(distance=4.6))
    found = {"an empty frame": frame(Stage(context(), Source(empty)), {}, empty.camera, False),
             "a Cook-Torrance ball, moving": frame(Stage(context(), Source(ball)), {"m": 0.25}, ball.camera, False)}
    for step in catalog.steps():
        values = defaults(step)
        values |= data(step, values)
        source = Source(step.step.scene, step.file_name, step.glsl_line)
        stage = Stage(context(), source, values.get("triangles"), values)
        for fine in (False, True):
            what = "at rest (4 samples)" if fine else "moving"
            found[f"{step.id}, {what}"] = frame(stage, values, step.step.scene.camera, fine)
    found |= {f"{id}, {name} chosen anew": flipped(catalog.step(id), name) for id, name in FLIPPED.items()}
    found |= {f"{id}, asked at every pixel": asking(catalog.step(id)) for id in FLIPPED}
    return found | {f"{id}, {name} typed": edited(catalog.step(id), name) for id, name in EDITED}


def flipped(step: catalog.LoadedStep, name: str) -> Job:
    """From a click on a choice that a scene decides to the picture: each time it is compiled."""
    values, scene = defaults(step), step.step.scene
    numbers = cycle([i for i in range(len(step.values[name].choices)) if i != values[name]])
    values |= data(step, values)
    stage = Stage(context(), Source(scene, step.file_name, step.glsl_line), values.get("triangles"), values)

    def click() -> None:
        stage.own.others.clear()
        stage.own.let_go()
        stage.draw(values | {name: next(numbers)}, scene.camera, SIZE, THEMES["dark"], False, counted=False)
        stage.ctx.finish()

    return timed(click)


def asking(step: catalog.LoadedStep) -> Job:
    """The same picture, moving, by programs that ask at every pixel what is chosen."""
    values, scene = defaults(step), replace(step.step.scene, decided=())
    values |= data(step, values)
    stage = Stage(context(), Source(scene, step.file_name, step.glsl_line), values.get("triangles"))
    return frame(stage, values, scene.camera, False)


def edited(step: catalog.LoadedStep, name: str) -> Job:
    """From a key to the picture: each time another text, checked, compiled and drawn; as at rest, when every surface
    has a program of its own."""
    known, source, values = edit.functions(step), edit.source_of(step), defaults(step)
    values |= step.derived(values)
    values |= data(step, values)
    stage, numbers = Stage(context(), source, values.get("triangles"), values), count(1)
    stage.draw(values, step.step.scene.camera, SIZE, THEMES["dark"], False, counted=False)
    while stage.settle(values, step.step.scene.camera, THEMES["dark"]):
        pass

    def key() -> None:
        text = known[name].text.replace("{", f"{{ {TYPED[name].format(next(numbers))}", 1)
        edit.check(text, known[name])
        stage.rewrite(edit.overrides({name: text}, known, source))
        stage.draw(values, step.step.scene.camera, SIZE, THEMES["dark"], False, counted=False)
        stage.ctx.finish()

    return timed(key)


def frame(stage: Stage, values: dict, camera: Camera, fine: bool) -> Job:
    """A picture as the window draws it: no faults are counted while something moves."""
    def draw() -> None:
        stage.draw(values, camera, SIZE, THEMES["dark"], fine, counted=fine)
        stage.ctx.finish()

    return timed(draw)


def frames(rounds: int = 25) -> list[Row]:
    """An empty frame is the reference. No program comes from a compilation of yesterday."""
    os.environ.setdefault("MESA_SHADER_CACHE_DISABLE", "true")
    made = jobs()
    asked = {name: ASKED_OF_A_BALL if "ball" in name else ASKED for name in made if name.endswith("moving")}
    asked |= {name: ASKED_OF_A_KEY for name in made if name.endswith("typed")}
    return in_turn(made, rounds, asked=asked)
