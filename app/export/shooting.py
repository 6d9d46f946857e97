"""A scene before the camera: one picture, or the many of an animation, drawn on one stage."""

import math
from dataclasses import replace

import numpy as np
from PIL import Image

from app.catalog import LoadedStep
from app.export.corners import entries, legend, notice
from app.export.ink import Ink, bytes3
from app.export.labels import COARSE, Box, Clutter, Placed, Word, draw_words, inside, place, words
from app.gpu.context import context
from app.gpu.stage import Stage
from app.gpu.stage_text import Source
from app.gpu.watch import watch
from app.leaving import decisions, lean
from app.lesson import Camera
from app.state import View
from app.theme import Theme, rgb

FILLED, CUT_OFF, MOST_ZOOM = 0.86, 0.985, 1.7  # how much of a picture a scene fills, and what is done for that


def shot(found: LoadedStep, values: dict, view: View | None, size: tuple[int, int], theme: Theme,
         ink: Ink | None = None, small: bool = False) -> Image.Image:
    """The scene with its labels, its legend and a notice of its faults; a small one has no words but the notice."""
    with Shooting(found, size, theme, ink, small) as one:
        return one.picture(values, one.camera([values], view))


class Shooting:
    """A scene that stays on the stage for one picture or for many: words and legend keep the places they got first."""

    def __init__(self, found: LoadedStep, size: tuple[int, int], theme: Theme, ink: Ink | None = None,
                 small: bool = False):
        self.found, self.size, self.theme, self.small = found, size, theme, small
        self.ink = ink or Ink(theme, size)
        self.on_stage: tuple[LoadedStep, Stage] | None = None
        self.clutter: Clutter | None = None  # of the first picture
        self.kept: dict[tuple[str, int], Box] = {}  # a word, the how manyth of its text: its box, from its point
        self.corner: list[Box] = []  # taken in the first picture

    def stage(self, values: dict) -> Stage:
        """The stage with what the scene needs at these values."""
        found, triangles = lean(self.found, decisions(self.found, values)), values.get("triangles")
        if self.on_stage is None or self.on_stage[0] is not found:
            self.release()
            source = Source(found.step.scene, found.file_name, found.glsl_line)
            made = Stage(context(), source, triangles, values)
            self.on_stage, self.triangles = (found, made), triangles
        stage = self.on_stage[1]
        if triangles is not self.triangles:
            stage.place(triangles)
            self.triangles = triangles
        return stage

    def camera(self, shown: list[dict], view: View | None) -> Camera:
        """The view's camera, or the scene's with the lens in which all that will be shown has room."""
        if view not in (None, View.of(self.found.step.scene.camera)):
            return view.camera(self.found.step.scene.camera)  # type: ignore[union-attr]
        return max((framed(self.stage(values), values, self.size, self.theme) for values in shown),
                   key=lambda camera: camera.field_of_view)

    def picture(self, values: dict, camera: Camera) -> Image.Image:
        stage, ink = self.stage(values), self.ink
        watch(stage, values, camera)
        stage.draw(values, camera, self.size, self.theme)
        picture, faults = Image.fromarray(np.ascontiguousarray(stage.picture.pixels())), stage.picture.faults()
        taken = notice(picture, faults, ink)
        if self.small:
            return picture
        said = words(stage, values)
        if self.clutter is None:
            self.clutter = Clutter(picture, ink.colour("background"))
            self.corner = taken + [(w.at[0] - ink.text, w.at[1] - ink.text, w.at[0] + ink.text, w.at[1] + ink.text)
                                   for w in said]
        taken += legend(picture, entries(stage.scene), self.clutter, ink, self.corner)
        draw_words(picture, self.placed(said, taken), ink)
        return picture

    def placed(self, said: list[Word], taken: list[Box]) -> list[Placed]:
        """Each word where it stood before, seen from its point; a new one where there is room."""
        assert self.clutter
        names = [(word.text, sum(other.text == word.text for other in said[:i])) for i, word in enumerate(said)]
        new = [i for i, name in enumerate(names) if name not in self.kept]
        fresh = place([said[i] for i in new], self.clutter, self.ink, self.size, taken)
        found = {id(one.word): one.box for one in fresh}
        for i in new:
            x, y = said[i].at
            self.kept[names[i]] = moved(found[id(said[i])], (-x, -y))
        return [Placed(word, inside(moved(self.kept[name], word.at), self.size, 0.35 * self.ink.text))
                for word, name in zip(said, names, strict=True)]

    def release(self) -> None:
        if self.on_stage is not None:
            self.on_stage[1].release()
            self.on_stage = None

    def __enter__(self) -> "Shooting":
        return self

    def __exit__(self, *exc) -> None:
        self.release()


def moved(box: Box, by: tuple[float, float]) -> Box:
    return box[0] + by[0], box[1] + by[1], box[2] + by[0], box[3] + by[1]


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
    seen = np.abs(stage.picture.pixels().astype(np.int16) - background).max(-1) > 24
    ends = [(found, len(line)) for line in (seen.any(0), seen.any(1)) if len(found := np.flatnonzero(line))]
    return max((abs(2 * edge / n - 1) for found, n in ends for edge in (found[0], found[-1] + 1)), default=FILLED)
