"""A scene as programs (text) and constant arrays: what the window, a still and a page all play. No GL here."""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache, partial
from typing import get_args

import numpy as np

from app import loops, shader
from app.colormaps import STOPS
from app.lesson import Colour, Mark, Scene
from app.optics.colour import srgb_to_linear
from app.pruning import decide
from app.theme import Theme, colour, rgb

COLOURS: tuple[str, ...] = get_args(Colour)  # in the order of glsl/display/palette.glsl
LINES = ("solid", "dashed", "dotted", "dashdot")
TIPS = ("none", "arrow", "sun", "eye", "dot")
TIP_SIZE = {"none": 0.0, "arrow": 7.0, "sun": 6.5, "eye": 6.5, "dot": 4.0}  # times the line's width
SHADED = ("", "stage/surface.vert"), ("stage/surface.glsl", "stage/shade.frag")
VALUES = ("", "stage/surface.vert"), ("stage/surface.glsl", "stage/values.frag")
PARTS = {  # program -> (its vertex text, its fragment text) around the scene's own text
    "surface": SHADED, "mesh": SHADED, "either": SHADED, "surface values": VALUES, "mesh values": VALUES,
    "dots": (("", "stage/dots.vert"), ("", "stage/dots.frag")),
    "mark": (("", "stage/mark.vert"), ("", "stage/mark.frag")),
    "probe": (("", "stage/probe.vert"), None),
    "anchor": (("", "stage/anchor.vert"), None),
}
KINDS = {"surface": 0, "mesh": 1}  # of surfaces -> is_mesh in their programs; "either" draws both
OPTIONAL = {  # what a scene may define: text -> the functions, and what stands in for them
    "stage/surface.vert": {
        "vec3 surface_point": "(int surface, vec2 s) { return vec3(s, 0.0); }",
        "vec4 surface_value": "(int surface, vec2 s) { return vec4(0.0); }",
        "vec3 mesh_point": "(int surface, vec3 p) { return p; }",
        "vec4 mesh_value": "(int surface, vec3 p, int face) { return vec4(0.0); }",
    },
    "stage/values.frag": {"vec3 shading_normal": "(Surface s) { return s.normal; }"},
}
FORMULAS = ("optics/", "core/")  # below glsl/: each file is whole without a scene
Pair = tuple[shader.Assembled, shader.Assembled | None]
Programs = dict[str, Pair]


@dataclass(frozen=True)
class Source:
    """A scene with the place its GLSL was written: for messages that name the lesson's own line."""

    scene: Scene
    file: str = "scene"
    first: int = 1
    overrides: shader.Overrides = ()  # what is included in place of the course's texts
    choices: tuple[str, ...] = ()  # of the step


def needed(scene: Scene) -> tuple[str, ...]:
    """The programs a scene has work for."""
    kinds = {s.mesh for s in scene.surfaces}
    wanted = [name for name, mesh in (("surface", False), ("mesh", True)) if mesh in kinds]
    wanted += ["dots"] * bool(scene.dots) + ["mark"] * bool(scene.marks)
    wanted += ["probe"] * bool(scene.labels or scene.handles) + ["anchor"] * any(m.label for m in scene.marks)
    return tuple(wanted)


def programs(scene: Scene, file: str = "scene", first: int = 1, header: tuple[str, ...] = shader.DESKTOP,
             names: tuple[str, ...] | None = None, overrides: shader.Overrides = (),
             known: Mapping[str, int | frozenset[int]] | None = None, watched: bool = False) -> Programs:
    """name -> (vertex, fragment or None) for every program the scene needs (or the named ones); `watched` ones tell
    which loop of a user's text was left.

    Whole values that are `known` are no uniforms but constants, and what is not chosen is left out; of one that may
    be several numbers they are known."""
    own = included(scene, file, first, overrides)

    def text(part: tuple[str, str], known: dict, watch: str = "") -> shader.Assembled:
        before, after = part
        lines = [f'#include "{before}"' if before else "", '#include "scene"', f'#include "{after}"']
        lines[1:1] = [function + otherwise for function, otherwise in OPTIONAL.get(after, {}).items()
                      if not re.search(rf"^{function}\(", scene.glsl, re.MULTILINE)]
        if watch:
            lines = ["#define main stage_main", *lines, "#undef main", f'#include "stage/watched.{watch}"']
        return shader.assemble("\n".join(lines), "the stage", header=header, overrides=own,
                               shorten=partial(decide, known=known) if known else None)

    found: Programs = {}
    for name in needed(scene) if names is None else names:
        vertex, fragment = PARTS[name]
        kind = {"is_mesh": KINDS[name.split()[0]]} if name.split()[0] in KINDS else {}
        fixed = {**(known or {}), **kind}
        found[name] = text(vertex, fixed), text(fragment, fixed) if fragment else None
        if watched and not name.endswith("values") and any(part and loops.COUNT in part.text for part in found[name]):
            found[name] = text(vertex, fixed, "vert"), text(fragment, fixed, "frag") if fragment else None
    return found


def included(scene: Scene, file: str, first: int, overrides: shader.Overrides) -> dict[str, shader.Source]:
    """What #include names beside the files below glsl/."""
    own = {"scene": shader.Source(scene.glsl, file, first)}
    own |= {one.name: shader.Source(one.text, one.file, one.first, is_own=True) for one in scene.texts}
    return own | dict(overrides)


def typed_alone(source: Source) -> list[Pair]:
    """Programs of the functions that are being typed, with all they call, whatever is chosen now: to be compiled for
    their mistakes, and they draw nothing. A formula's is made of its file, as for a number; another's of the scene."""
    files = {name: include for name, text in source.overrides if text.is_own
             for include, whole in source.overrides if f'#include "{name}"' in whole.text}
    own, idle = included(source.scene, source.file, source.first, source.overrides), "void main() {}"
    found: list[Pair] = []
    for is_formula in (True, False):
        mine = {name: include for name, include in files.items() if include.startswith(FORMULAS) == is_formula}
        if not mine:
            continue
        needs = [*([] if is_formula else ["stage/surface.glsl", "scene"]), *mine.values()]
        text = "\n".join([*(f'#include "{one}"' for one in dict.fromkeys(needs)), idle])
        entry = "main", *(name.split()[-1] for name in mine)
        pair = (shader.assemble(text, "the stage", entry=entry, overrides=own), shader.assemble(idle, "the stage"))
        found.append(pair if is_formula else pair[::-1])
    return found


def reads(source: Source) -> tuple[str, ...]:
    """The step's choices that its scene's text has as uniforms."""
    lines = shader.resolve(source.scene.glsl, source.file, source.first,
                           included(source.scene, source.file, source.first, ())) if source.choices else []
    kinds = shader.uniforms("\n".join(line.text for line in lines))
    return tuple(name for name in source.choices if kinds.get(name) == "int")


def typed_in(pair: Pair, overrides: shader.Overrides) -> tuple[str, ...]:
    """Which of a program's texts one that is being edited is part of."""
    typed = {text.file for _, text in overrides if text.is_own}
    return tuple(name for name, part in zip(("vertices", "pixels"), pair, strict=True)
                 if part and not typed.isdisjoint(part.files))


@cache
def look(theme: Theme) -> dict:
    """What a theme gives to a scene."""
    return {"background": tuple(srgb_to_linear(rgb(theme.background))),
            "palette": srgb_to_linear([colour(name, theme) for name in COLOURS]).astype("f4").tobytes(),
            "colormap_stops": srgb_to_linear(STOPS[theme.colormap]).astype("f4").tobytes()}


def mark_uniforms(which: int, mark: Mark) -> dict[str, int]:
    """What a mark's program is given but for widths; `steps` pieces measure a length, for dashes and an arrow's tip."""
    steps = 0 if mark.line == "solid" and mark.tip != "arrow" else 1 if mark.segments == 1 else 16
    return {"mark": which, "measure_steps": steps, "length_steps": steps if mark.tip == "arrow" else 0,
            "mark_colour": COLOURS.index(mark.colour), "dash": LINES.index(mark.line), "tip": TIPS.index(mark.tip)}


def grid(cells: tuple[int, int]) -> tuple[np.ndarray, np.ndarray]:
    """Corners (n, 3) of a grid over the unit square of the plane z = 0, float32, and triangle indices, int32."""
    s, t = np.meshgrid(np.linspace(0, 1, cells[0] + 1), np.linspace(0, 1, cells[1] + 1))
    at = np.arange(s.size, dtype=np.int32).reshape(s.shape)
    a, b, c, d = at[:-1, :-1], at[:-1, 1:], at[1:, 1:], at[1:, :-1]
    return np.stack([s, t, 0 * s], -1).reshape(-1, 3).astype("f4"), np.stack([a, b, c, a, c, d], -1).reshape(-1)


def pen(segments: int, tip: bool) -> tuple[np.ndarray, np.ndarray]:
    """Corners (n, 3) of a line of `segments` pieces, and of the square its tip is drawn in; triangle indices."""
    t = np.linspace(0, 1, segments + 1)
    corners = [np.stack([np.repeat(t, 2), np.tile([-1.0, 1.0], len(t)), np.zeros(2 * len(t))], -1)]
    i = np.arange(segments, dtype=np.int32)[:, None] * 2
    indices = [(i + np.array([0, 1, 3, 0, 3, 2])).reshape(-1)]
    if tip:
        corners.append(np.array([[0, -1, 1], [1, -1, 1], [1, 1, 1], [0, 1, 1]], float))
        indices.append(2 * len(t) + np.array([0, 1, 2, 0, 2, 3]))
    return np.concatenate(corners).astype("f4"), np.concatenate(indices).astype("i4")


def vertices(scene: Scene, mesh_triangles: np.ndarray | None = None, values: dict | None = None) -> dict[str, int]:
    """How many vertices each part of a scene sends through its vertex shader."""
    found: dict[str, int] = {}
    for surface in scene.surfaces:
        found[surface.name] = (3 * len(mesh_triangles) if mesh_triangles is not None else 0) if surface.mesh else (
            (surface.cells[0] + 1) * (surface.cells[1] + 1))
    for mark in scene.marks:
        found[mark.name] = 2 * (mark.segments + 1) + 4 * (mark.tip != "none")
    if scene.dots:
        count = scene.dots.count
        found["dots"] = int((values or {}).get(count, 0)) if isinstance(count, str) else count
    return found
