"""The course where there is no display: every step as pictures, and a page to open in a browser."""

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from PIL import Image

from app import VERSION, prediction
from app.badges import of_model
from app.catalog import Loaded, LoadedStep, chapters
from app.console import progress
from app.export import target
from app.export.ink import Ink
from app.export.markup import anchor
from app.export.page import Shown, Try, page, state_links
from app.export.shooting import shot
from app.export.still import constant, data, file_of, known, plotted
from app.gpu.context import context
from app.problem import Problem
from app.readouts import numbers
from app.state import defaults, parse_query, write
from app.theme import THEMES, Theme

FOLDER, VARIABLE = "halfway-lessons", "HALFWAY_LESSONS"
PICTURES = "pictures"
SCENE, PLOT, SMALL = (1260, 840), (840, 840), (420, 280)
LARGER = 1.5  # words on a scene: on the page it is shown at half its size


def run(options) -> int:
    """options, all of them optional: output (a folder), theme, mesh, ies."""
    folder = target.make_folder(getattr(options, "output", None) or os.environ.get(VARIABLE) or FOLDER)
    theme = THEMES[known("--theme", getattr(options, "theme", None) or "dark", tuple(THEMES))]
    context()  # without OpenGL there is not one picture: said once, at once
    return gallery(folder, theme, mesh=getattr(options, "mesh", None), ies=getattr(options, "ies", None))


def gallery(folder: Path, theme: Theme = THEMES["dark"], found: tuple[Loaded, ...] | None = None,
            mesh: str | Path | None = None, scale: float = 1.0, ies: str | Path | None = None) -> int:
    """Renders the chapters into the folder; the code is 1 if a step is broken or the work was broken off."""
    found = chapters() if found is None else found
    todo = [LoadedStep(loaded, step, i) for loaded in found for i, step in enumerate(loaded.chapter.steps)]
    target.make_folder(folder / PICTURES)
    done: dict[str, Shown] = {}
    stopped = False
    try:
        with progress(len(todo)) as tell:
            for i, one in enumerate(todo):
                tell(i, one.step.title)
                done[one.id] = rendered(one, folder, theme, mesh, scale, ies)
    except KeyboardInterrupt:
        stopped = True
    listed = [(loaded, [done[f"{loaded.id}/{step.name}"] for step in loaded.chapter.steps
                        if f"{loaded.id}/{step.name}" in done]) for loaded in found]
    note = f"Made by Halfway {VERSION}; {len(done)} of {len(todo)} steps."
    index = folder / "index.html"
    target.write(index, page(listed, note).encode("utf-8"))
    faults = [loaded.fault for loaded in found if loaded.fault]
    faults += [f"{one.found.id}: {one.fault}" for one in done.values() if one.fault]
    for fault in faults:
        print(f"halfway: {fault}", file=sys.stderr)
    print(f"{'Stopped early. ' if stopped else ''}{note} Open {index.resolve()}")
    return 1 if faults or stopped else 0


def rendered(found: LoadedStep, folder: Path, theme: Theme, mesh: str | Path | None = None,
             scale: float = 1.0, ies: str | Path | None = None) -> Shown:
    """One step: its scene, its plot, its numbers, its answer, and a small picture for each link of its prose.

    What fails is said, and the rest is done all the same.
    """
    shown = Shown(found)

    def sized(size: tuple[int, int]) -> tuple[int, int]:
        return max(target.SMALLEST, round(size[0] * scale)), max(target.SMALLEST, round(size[1] * scale))

    def keep(picture: Image.Image, state: str, *words: str) -> str:
        name = f"{PICTURES}/{anchor(found.id, *words)}.png"
        target.write(folder / name, file_of(picture, found, state))
        return name

    def values() -> dict:
        first = defaults(found)
        own = mesh if any(surface.mesh for surface in found.step.scene.surfaces) else None
        return first | data(found, first, own, ies if any(table.files for table in found.step.scene.tables) else None)

    def scene() -> None:
        shown.state = write(found, start)
        size = sized(SCENE)
        ink = Ink(theme, (round(LARGER * size[0]), round(LARGER * size[1])))
        shown.scene = keep(shot(found, start, None, size, theme, ink), shown.state, "scene")

    def plot() -> None:
        for i in range(len(found.step.plots)):
            more = (str(i + 1),) if i else ()
            shown.plots.append(keep(plotted(found, start, sized(PLOT), theme, i), shown.state, "plot", *more))

    def figures() -> None:
        shown.numbers = numbers(found.step, start, context())
        shown.badges = {model.label: of_model(model, start) for model in found.step.models}
        shown.truth = prediction.truth(found, **{k: v for k, v in start.items() if k == "triangles"},
                                       **constant(found, prediction.truth_values(found)))

    def tries() -> None:
        for i, link in enumerate(state_links(found)):
            changed, view = parse_query(link.target[1:], found)
            there = defaults(found) | changed
            there |= data(found, there)
            state = write(found, there, view)
            file = keep(shot(found, there, view, sized(SMALL), theme, small=True), state, "try", str(i + 1))
            shown.tries.append(Try(link.target, link.words, state, file))

    start: dict = {}
    with said(shown):
        start = values()
        for part in (scene, plot, figures, tries):
            with said(shown):
                part()
    return shown


@contextmanager
def said(shown: Shown) -> Iterator[None]:
    """A part that fails leaves its sentence with the step."""
    try:
        yield
    except Problem as problem:
        note(shown, str(problem))
    except Exception as error:  # a broken lesson must not take the others with it
        note(shown, f"{type(error).__name__}: {error}")


def note(shown: Shown, sentence: str) -> None:
    if sentence not in shown.fault:
        shown.fault = f"{shown.fault} {sentence}".strip()
