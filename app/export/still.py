"""One picture of one step: `halfway render`. Loads neither the window nor VTK unless the plot is asked for."""

import sys
from pathlib import Path
from typing import Literal

from PIL import Image

from app import VERSION
from app.badges import of_model
from app.breaking import broken, values_of
from app.catalog import LoadedStep, step
from app.export import target
from app.export.ink import Ink
from app.export.png import png
from app.export.shooting import shot
from app.export.strip import Block, Judged, strip
from app.gpu.context import context
from app.picture_state import KEY
from app.problem import Usage, near
from app.readouts import numbers
from app.state import View, parse, parse_set, write
from app.theme import THEMES, Theme

Part = Literal["scene", "plot", "both"]
ENDINGS, WHY = (".png", ".svg", ".pdf"), "stills are PNG files, curves also SVG and PDF"
PARTS: tuple[Part, ...] = ("scene", "plot", "both")
MESH = "triangles", "texture_coordinates"  # what plots have no use for as values


def run(options) -> int:
    """options: step (a state string), output, size, set (name=value, ...), view, plot, theme, mesh, ies."""
    path, size = target.path_of(options.output, ENDINGS, WHY), target.size_of(options.size or "1280x720")
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
    if path.suffix.lower() != ".png":
        if part != "plot":
            raise Usage(f"{path.name} can hold curves only; add --view plot, or write a .png.")
        target.write(path, drawing(found, values, size, theme, plot, path.suffix.lower()[1:], state.view))
        return 0
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


def plotted(found: LoadedStep, values: dict, size: tuple[int, int], theme: Theme, plot: int = 0) -> Image.Image:
    """A plot of the step, drawn by the plots' own process."""
    from app import plots

    sliders = {name: value for name, value in values.items() if name not in MESH}
    ranges = {name: (spec.low, spec.high) for name, spec in found.values.items()}
    return Image.fromarray(plots.picture(found.step.plots[plot], sliders, size, theme, ranges,
                                         triangles=values.get("triangles")))


def drawing(found: LoadedStep, values: dict, size: tuple[int, int], theme: Theme, plot: int, kind: str,
            view: View | None) -> bytes:
    """A plot of curves as SVG or PDF."""
    from app.plots import vector

    ranges = {name: (spec.low, spec.high) for name, spec in found.values.items()}
    return vector.drawing(found.step.plots[plot], values, size, theme, ranges, kind, write(found, values, view))


def file_of(picture: Image.Image, found: LoadedStep, state: str) -> bytes:
    """A PNG file's bytes; what was drawn and how to open it again stand in its text chunks."""
    return png(picture, {"Title": found.step.title, "Software": f"Halfway {VERSION}", KEY: state})
