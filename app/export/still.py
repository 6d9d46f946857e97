"""One picture of one step: `halfway render`. Loads neither the window nor VTK unless the plot is asked for."""

import math
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Literal

import numpy as np
from PIL import Image

from app import VERSION
from app.badges import of_model
from app.breaking import broken, values_of
from app.catalog import LoadedStep, step
from app.export import target
from app.export.corners import entries, legend, notice
from app.export.ink import Ink, bytes3
from app.export.labels import COARSE, Clutter, draw_words, place, words
from app.export.png import png
from app.export.strip import Block, Judged, strip
from app.gpu.context import context
from app.gpu.stage import Stage
from app.gpu.stage_text import Source
from app.leaving import decisions, lean
from app.lesson import Camera
from app.problem import Usage, near
from app.readouts import numbers
from app.state import View, parse, parse_set, write
from app.theme import THEMES, Theme, rgb

Part = Literal["scene", "plot", "both"]
PARTS: tuple[Part, ...] = ("scene", "plot", "both")
MESH = "triangles", "texture_coordinates"  # what plots have no use for as values
FILLED, CUT_OFF, MOST_ZOOM = 0.86, 0.985, 1.7  # how much of a picture a scene fills, and what is done for that


def run(options) -> int:
    """options: step (a state string), output, size, set (name=value, ...), view, plot, theme, mesh, ies."""
    path, size = target.picture_path(options.output), target.size_of(options.size or "1280x720")
    theme = THEMES[known("--theme", options.theme or "dark", tuple(THEMES))]
    part: Part = known("--view", options.view or "scene", PARTS)  # type: ignore[assignment]
    state = parse(options.step)
    found = step(state.step)
    values = dict(state.values)
    if getattr(options, "broken", None):
        found, values = break_it(found, values, options.broken)
    for text in options.set or ():
        values |= parse_set(text, found)
    values |= data(found, values, options.mesh, getattr(options, "ies", None), getattr(options, "map", None))
    plot = plot_number(found, getattr(options, "plot", None) or "1")
    picture = still(found, values, state.view, size, theme, part, plot)
    target.write(path, file_of(picture, found, write(found, values, state.view)))
    return 0


def break_it(found: LoadedStep, values: dict, text: str) -> tuple[LoadedStep, dict]:
    """The step with naive forms, and the values at which they fail: its break number `text`, from 1."""
    labels = [one.label for one in found.step.breaks]
    if not text.isdecimal() or not 1 <= int(text) <= len(labels):
        known = ", ".join(f"{i} ({name})" for i, name in enumerate(labels, 1))
        raise Usage(f"--broken {text}: {found.id} has {known or 'nothing to break'}.")
    one = found.step.breaks[int(text) - 1]
    return broken(found, int(text) - 1), values | values_of(found, one)


def known(option: str, name: str, names: tuple[str, ...]) -> str:
    if name not in names:
        raise Usage(f"{option} {name}: there are {', '.join(names)}.{near(name, names)}")
    return name


def plot_number(found: LoadedStep, text: str) -> int:
    """Which of the step's plots: counted from 1, or by its title."""
    titles = [plot.title for plot in found.step.plots]
    if text in titles:
        return titles.index(text)
    if not text.isdecimal() or not 1 <= int(text) <= len(titles):
        raise Usage(f"--plot {text}: {found.id} has {', '.join(f'{i} ({t})' for i, t in enumerate(titles, 1))}.")
    return int(text) - 1


def data(found: LoadedStep, values: dict, mesh: str | Path | None = None, ies: str | Path | None = None,
         maps: list[str] | None = None) -> dict:
    """What a step needs besides its sliders: the triangles of its mesh and its tables, its own or the user's."""
    return triangles(found, values, mesh) | constant(found, values, ies, maps) | found.derived(values)


def constant(found: LoadedStep, values: dict, ies: str | Path | None = None, maps: list[str] | None = None) -> dict:
    """The tables of measured luminaires, and the user's maps (kind=FILE), each told on stderr."""
    scene = found.step.scene
    if ies and not any(table.files for table in scene.tables):
        raise Usage(f"{found.id} has no luminaire that {ies} could replace; lights/ies has one.")
    if maps and not any(table.map for table in scene.tables):
        raise Usage(f"{found.id} has no maps that {maps[0]} could replace; plausible_shading/texturing has them.")
    if not scene.tables:
        return {}
    from app import tables
    from app.ies import read

    return tables.chosen(scene, values, read(ies) if ies else None, own_maps(maps or []))


def own_maps(given: list[str]) -> dict:
    if not given:
        return {}
    from app import maps

    found = {kind: maps.read(kind, path) for kind, path in map(maps.named, given)}
    for one in found.values():
        print(f"halfway: {one.note}.", file=sys.stderr)
    return found


def triangles(found: LoadedStep, values: dict, mesh: str | Path | None = None) -> dict:
    scene = found.step.scene
    if not any(surface.mesh for surface in scene.surfaces):
        if mesh:
            raise Usage(f"{found.id} has no mesh that {mesh} could replace.")
        return {}
    from app import meshes

    if mesh:
        own = meshes.load(mesh)
        if any(table.map for table in scene.tables):
            print(f"halfway: {own.name}: {own.note}.", file=sys.stderr)
        return own.data
    return meshes.built_in(scene.meshes[int(values.get("shape", 0))]).data


def still(found: LoadedStep, values: dict, view: View | None = None, size: tuple[int, int] = (1280, 720),
          theme: Theme = THEMES["dark"], part: Part = "scene", plot: int = 0) -> Image.Image:
    """The scene, a plot, or both side by side, above a strip with title, state and numbers; exactly `size`."""
    ink = Ink(theme, size)
    told: list[Block] = [*numbers(found.step, values, context())]
    told += [Judged(model.label, model.colour, of_model(model, values)) for model in found.step.models]
    below = strip(size[0], 0.34 * size[1], found.step.title, write(found, values, view), told, ink)
    height = size[1] - (below.height if below else 0)
    picture = Image.new("RGB", size, ink.colour("background"))
    left = size[0] if part == "scene" else 0 if part == "plot" else size[0] // 2
    if left:
        picture.paste(shot(found, values, view, (left, height), theme, ink), (0, 0))
    if left < size[0]:
        picture.paste(plotted(found, values, (size[0] - left, height), theme, plot), (left, 0))
    if below:
        picture.paste(below, (0, height))
    return picture


def shot(found: LoadedStep, values: dict, view: View | None, size: tuple[int, int], theme: Theme,
         ink: Ink | None = None, small: bool = False) -> Image.Image:
    """The scene with its labels, its legend and a notice of its faults; a small one has no words but the notice."""
    found = lean(found, decisions(found, values))
    with staged(found, values) as stage:
        camera = stage.scene.camera
        camera = framed(stage, values, size, theme) if view in (None, View.of(camera)) else view.camera(camera)
        return taken(stage, values, camera, size, theme, ink, small)


@contextmanager
def staged(found: LoadedStep, values: dict) -> Iterator[Stage]:
    stage = Stage(context(), Source(found.step.scene, found.file_name, found.glsl_line), values.get("triangles"))
    try:
        yield stage
    finally:
        stage.release()


def taken(stage: Stage, values: dict, camera: Camera, size: tuple[int, int], theme: Theme, ink: Ink | None = None,
          small: bool = False) -> Image.Image:
    """The picture a stage gives through a camera, with words."""
    ink = ink or Ink(theme, size)
    stage.draw(values, camera, size, theme)
    picture, faults = Image.fromarray(np.ascontiguousarray(stage.pixels())), stage.faults()
    used = notice(picture, faults, ink)
    if not small:
        said = words(stage, values)
        ends = [(w.at[0] - ink.text, w.at[1] - ink.text, w.at[0] + ink.text, w.at[1] + ink.text) for w in said]
        clutter = Clutter(picture, ink.colour("background"))
        used += legend(picture, entries(stage.scene), clutter, ink, used + ends)
        draw_words(picture, place(said, clutter, ink, size, used), ink)
    return picture


def framed(stage: Stage, values: dict, size: tuple[int, int], theme: Theme) -> Camera:
    """The scene's camera with the lens that lets it fill a picture of this size; tried out on a smaller one."""
    camera, zoom = stage.scene.camera, 1.0
    tangent = math.tan(math.radians(camera.field_of_view) / 2)
    for _ in range(3):
        stage.draw(values, camera, (size[0] // COARSE, size[1] // COARSE), theme, fine=False, counted=False)
        far = reach(stage, theme)
        wanted = zoom * min(MOST_ZOOM, FILLED / max(far, 1e-3))
        if far >= CUT_OFF:
            wanted = zoom / MOST_ZOOM  # how much more there is cannot be seen yet
        if abs(wanted / zoom - 1) < 0.03:
            break
        zoom = wanted
        camera = replace(camera, field_of_view=math.degrees(2 * math.atan(tangent / zoom)))
    return camera


def reach(stage: Stage, theme: Theme) -> float:
    """How far from its middle the stage's last picture is drawn on: 1 at an edge."""
    background = np.array(bytes3(rgb(theme.background)), np.int16)
    seen = np.abs(stage.pixels().astype(np.int16) - background).max(-1) > 24
    ends = [(found, len(line)) for line in (seen.any(0), seen.any(1)) if len(found := np.flatnonzero(line))]
    return max((abs(2 * edge / n - 1) for found, n in ends for edge in (found[0], found[-1] + 1)), default=FILLED)


def plotted(found: LoadedStep, values: dict, size: tuple[int, int], theme: Theme, plot: int = 0) -> Image.Image:
    """A plot of the step, drawn by the plots' own process."""
    from app import plots

    sliders = {name: value for name, value in values.items() if name not in MESH}
    ranges = {name: (spec.low, spec.high) for name, spec in found.values.items()}
    return Image.fromarray(plots.picture(found.step.plots[plot], sliders, size, theme, ranges,
                                         triangles=values.get("triangles")))


def file_of(picture: Image.Image, found: LoadedStep, state: str) -> bytes:
    """A PNG file's bytes; what was drawn and how to open it again stand in its text chunks."""
    return png(picture, {"Title": found.step.title, "Software": f"Halfway {VERSION}", "halfway:state": state})
