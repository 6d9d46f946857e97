"""Every step drawn over the corners of its sliders: pixels that are no number, infinite or negative are counted."""

import itertools
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from app.catalog import LoadedStep, step
from app.gpu.context import context
from app.gpu.picture import Faults
from app.gpu.stage import Stage
from app.gpu.stage_text import Source
from app.lesson import Number
from app.state import defaults, write
from app.theme import THEMES

SIZE = (96, 96)
MIXED = 12  # corners of many sliders at once


@dataclass(frozen=True)
class Fault:
    """A state in which a scene has pixels that no scene may have, or places that are no number."""

    state: str  # as `halfway show` takes it
    pixels: Faults
    places: int = 0  # probes and labels

    @property
    def words(self) -> str:
        kinds = {"pixels not a number": self.pixels.nan, "infinite": self.pixels.inf, "negative": self.pixels.negative,
                 "places not a number": self.places}
        return ", ".join(f"{count} {kind}" for kind, count in kinds.items() if count)


@dataclass(frozen=True)
class Played:
    """A step drawn in many states."""

    step: str
    states: int
    meant: int  # states with negative light on purpose
    faults: tuple[Fault, ...]


def played(found: LoadedStep | str, mixed: int = MIXED, ctx=None) -> Played:
    """A step at its corners: what went wrong, state by state."""
    found = step(found) if isinstance(found, str) else found
    with Player(found, ctx) as player:
        tried = list(corners(found, mixed))
        faults = [fault for values in tried if (fault := player.fault(values))]
        meant = sum(is_meant(found, values) for values in tried)
    return Played(found.id, len(tried), meant, tuple(faults))


class Player:
    """A step's stage, kept while its values change."""

    def __init__(self, found: LoadedStep, ctx=None) -> None:
        self.found, self.ctx, self.mesh = found, ctx or context(), None
        self.stage: Stage | None = None

    def __enter__(self) -> "Player":
        return self

    def __exit__(self, *exc) -> None:
        if self.stage:
            self.stage.release()

    def fault(self, values: dict[str, Number]) -> Fault | None:
        """What is wrong with the picture of these values."""
        from app.export.still import data

        scene, more = self.found.step.scene, data(self.found, values)
        mesh, whole = more.get("triangles"), values | more
        if self.stage is None:
            source = Source(scene, self.found.file_name, self.found.glsl_line)
            self.stage = Stage(self.ctx, source, mesh, whole)
        elif mesh is not self.mesh:
            self.stage.place(mesh)
        self.mesh = mesh
        self.stage.draw(whole, scene.camera, SIZE, THEMES["dark"], fine=False)
        pixels = self.stage.picture.faults()
        if is_meant(self.found, values):
            pixels = Faults(pixels.nan, pixels.inf)
        places = [self.stage.probes(whole), *self.stage.anchors(whole).values()]
        lost = sum(int(np.count_nonzero(~np.isfinite(place))) for place in places)
        return Fault(write(self.found, values), pixels, lost) if pixels or lost else None


def is_meant(found: LoadedStep, values: dict[str, Number]) -> bool:
    """Whether the lesson shows negative light here on purpose."""
    ends = found.step.scene.negative.items()
    return any(low <= values[name] <= high for name, (low, high) in ends)  # type: ignore[operator]


def corners(found: LoadedStep, mixed: int) -> Iterator[dict[str, Number]]:
    """The defaults, every value at each end of its slider alone, and some mixed corners, the same every time."""
    first = defaults(found)
    yield first
    ends = {name: (end(found, name, "low"), end(found, name, "high")) for name in first}
    for name, both in ends.items():
        for value in both:
            yield first | {name: value}
    sides = list(itertools.islice(itertools.product((0, 1), repeat=len(ends)), 4096))
    for pick in np.random.default_rng(sum(map(ord, found.id))).permutation(len(sides))[:mixed]:
        yield {name: ends[name][side] for name, side in zip(ends, sides[pick], strict=True)}


def end(found: LoadedStep, name: str, side: str) -> Number:
    spec = found.values[name]
    number = getattr(spec, side)
    number = int(number) if spec.quantity.kind == "int" else float(number)
    return (number,) * spec.quantity.width if spec.quantity.width > 1 else number
