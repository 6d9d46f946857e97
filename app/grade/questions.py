"""An assignment's questions: the same points for every student, drawn from a seed, a task's rows one behind the other.

The rows of a question follow from the assignment alone: its regions in their order, the swapped rows of reciprocity,
the directions of the energy's sum. So the judge knows what each row is for, and whoever answers does not.
"""

import hashlib
from dataclasses import dataclass

import numpy as np

from app.grade.assignment import Assignment, Picture, Region, Task
from app.grade.points import DIRECTIONS, as_float32, draw, length
from app.grade.properties import GRIDS, SETTINGS, hemisphere, swap
from app.grade.question import Question

PART = {"visible": False, "hidden": True}
PUBLIC = "public"  # the seed of the visible points
SUN = ((0.36, 0.48, 0.8), (-0.8, 0.36, 0.48))  # where the light of a picture is, of the visible and the hidden one


@dataclass(frozen=True)
class Rows:
    """What some rows of a question are for: a region, a property or the picture."""

    kind: str  # region, swapped, energy
    name: str
    first: int
    count: int

    @property
    def slice(self) -> slice:
        return slice(self.first, self.first + self.count)


def rng_of(*words: object) -> np.random.Generator:
    """The same numbers for the same words, on every machine."""
    seed = hashlib.sha256("/".join(map(str, words)).encode()).digest()
    return np.random.default_rng(int.from_bytes(seed[:16], "little"))


def count_of(region: Region, hidden: bool) -> int:
    return region.hidden if hidden else region.visible


def layout(task: Task, hidden: bool) -> list[Rows]:
    """What the rows of a task's question are for."""
    found, at = [], 0

    def add(kind: str, name: str, count: int) -> None:
        nonlocal at
        if count:
            found.append(Rows(kind, name, at, count))
            at += count

    for region in task.regions:
        add("region", region.name, count_of(region, hidden))
    drawn = main_region(task)
    if drawn is not None:
        names = {one.name for one in task.properties}
        if "reciprocity" in names:
            add("swapped", drawn.name, count_of(drawn, hidden))
        if "energy" in names:
            settings = min(SETTINGS, count_of(drawn, hidden))
            add("energy", drawn.name, settings * sum(polar * around for polar, around in GRIDS))
    return found


def main_region(task: Task) -> Region | None:
    """The first region whose points are drawn: properties are judged there."""
    return next((region for region in task.regions if region.at is None), None)


def rows_of(task: Task, region: Region, assignment: str, seed: str, hidden: bool) -> dict[str, np.ndarray]:
    count = count_of(region, hidden)
    if region.at is not None:
        return {name: np.asarray(x, float) for name, x in region.at.items()}
    rng = rng_of(assignment, task.function, region.name, seed)
    return draw({name: region.domains[name] for name in task.arguments}, rng, count)


def unit(args: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    """Directions of length 1 to float64's last digits: float32's are off by 6e-8, which is not the student's fault."""
    return {name: x / length(x) if name in DIRECTIONS else x for name, x in args.items()}


def args_of(task: Task, assignment: str, seed: str, hidden: bool, language: str) -> dict[str, np.ndarray]:
    """Every row of a task's question, as the language sees it."""
    regions = {region.name: region for region in task.regions}
    blocks, by_name = [], {}
    for rows in layout(task, hidden):
        if rows.kind == "region":
            block = rows_of(task, regions[rows.name], assignment, seed, hidden)
            if language == "glsl":
                block = {name: as_float32(x) for name, x in block.items()}
            elif regions[rows.name].at is None:
                block = unit(block)
            by_name[rows.name] = block
        else:
            block = (swap if rows.kind == "swapped" else hemisphere)(by_name[rows.name])
        blocks.append(block)
    return {name: np.concatenate([block[name] for block in blocks]) for name in task.arguments} if blocks else {}


def places(picture: Picture) -> list[np.ndarray]:
    """x and y of every pixel; the sphere has the radius 1."""
    ticks = 2 * (np.arange(picture.size) + 0.5) / picture.size - 1
    return list(np.meshgrid(1.05 * ticks, -1.05 * ticks))


def mask_of(picture: Picture) -> np.ndarray:
    """(size, size), where the sphere is."""
    x, y = places(picture)
    return x * x + y * y < 1


def pixels(picture: Picture, arguments: tuple[str, ...], hidden: bool) -> tuple[dict[str, np.ndarray], np.ndarray]:
    """The arguments at the pixels of a sphere seen from +z, and the mask (size, size) of those on it."""
    mask = mask_of(picture)
    x, y = places(picture)
    n = np.stack([x[mask], y[mask], np.sqrt(1 - x[mask] ** 2 - y[mask] ** 2)], -1)
    count = len(n)
    rng = rng_of("picture", hidden)
    given = {"n": n, "v": np.repeat([[0.0, 0.0, 1.0]], count, 0), "l": np.repeat([SUN[hidden]], count, 0)}
    for name, domain in picture.args.items():
        one = draw({name: domain}, rng, 1)[name]
        given[name] = np.repeat(one, count, 0)
    return {name: as_float32(given[name]) for name in arguments}, mask


def questions(assignment: Assignment, seed: str = PUBLIC, hidden: bool = False,
              languages: tuple[str, ...] | None = None) -> list[Question]:
    """Every question in every language of the assignment, or in some of them; `seed` is a secret where `hidden`."""
    found = []
    part = "hidden" if hidden else "visible"
    for task in assignment.tasks:
        shown = pixels(task.picture, task.arguments, hidden)[0] if task.picture else None
        for language in languages or assignment.languages:
            args = args_of(task, assignment.id, seed, hidden, language)
            if args:
                found.append(Question(f"{task.function}/{part}/{language}", task.function, language,  # type: ignore
                                      args, task.width))
            if shown:
                found.append(Question(f"{task.function}/{part}-picture/{language}", task.function,
                                      language, shown, task.width))  # type: ignore[arg-type]
    return found
