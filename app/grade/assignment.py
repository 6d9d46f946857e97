"""An assignment as a lecturer writes it: a TOML file in lessons/homework, read whole and refused with a clear sentence.

A task is a function of the course by its name, an exercise of a chapter, or a function of a reference of one's own, a
Python file beside the TOML. Its regions say where it is asked, its properties what must hold, its points what it pays.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from datetime import datetime
from functools import cache, cached_property
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

from app.grade.points import Domain
from app.lesson import Exercise
from app.optics import twin
from app.paths import LESSONS
from app.problem import Problem, Usage, near

FOLDER = LESSONS / "homework"
LANGUAGES = ("python", "glsl")
TEXTS = ("solutions", "mutants")  # files beside them that are no assignments
PROPERTIES = {"reciprocity": "light and eye swapped give the same", "positivity": "never below 0",
              "bound": "never above 1", "energy": "no more light leaves than arrives"}


@dataclass(frozen=True)
class Region:
    """Where a task is asked: drawn from domains, or at the points of an exercise's check."""

    name: str
    domains: dict[str, Domain] = field(default_factory=dict, hash=False)
    visible: int = 64
    hidden: int = 192
    weight: float = 1.0
    at: dict[str, tuple] | None = field(default=None, hash=False)


@dataclass(frozen=True)
class Property:
    name: str
    weight: float = 1.0


@dataclass(frozen=True)
class Picture:
    """A sphere drawn by the task's function: n varies over the pixels, l is the picture's, v looks along the axis."""

    size: int = 96
    weight: float = 2.0
    args: dict[str, Domain] = field(default_factory=dict, hash=False)


@dataclass(frozen=True)
class Task:
    """One function to write."""

    function: str
    points: float
    text: str  # what is asked
    slide: str
    arguments: tuple[str, ...]
    regions: tuple[Region, ...]
    properties: tuple[Property, ...] = ()
    picture: Picture | None = None
    exercise: Exercise | None = None
    own: Path | None = None  # the reference, where it is not a twin
    width: int = 1
    widths: tuple[int, ...] = ()  # of the arguments
    absolute: float = 0.0  # the size of numbers that a sound answer may add and subtract on the way
    powers: tuple[str, ...] = ()  # exponents that a rounded number may be raised to
    runtime: float = 0.0  # the share of the points that speed pays
    gross: float = 10.0  # how many times the solution's time is too slow

    @cached_property
    def reference(self) -> Callable:
        return getattr(own_module(self.own), self.function) if self.own else twin(self.function)


@dataclass(frozen=True)
class Assignment:
    id: str
    title: str
    chapter: str
    file: Path
    tasks: tuple[Task, ...]
    languages: tuple[str, ...] = LANGUAGES  # any of them; of both the better one counts
    due: datetime | None = None
    late_per_day: float = 0.0  # share of the points
    late_days: int = 0  # after these nothing counts
    seconds: float = 10.0  # of processor time for a file
    digest: str = ""  # of everything that decides a score

    @property
    def points(self) -> float:
        return sum(task.points for task in self.tasks)

    def share_when(self, handed_in: datetime | None) -> float:
        """What is left of the points, by the late rule: each day begun costs its share, after the last it is 0."""
        if self.due is None or handed_in is None or handed_in <= self.due:
            return 1.0
        late = (handed_in - self.due).total_seconds() / 86400
        days = int(late) + (late > int(late))
        return 0.0 if days > self.late_days else max(0.0, 1.0 - days * self.late_per_day)

    def task(self, function: str) -> Task:
        found = [task for task in self.tasks if task.function == function]
        if not found:
            known = [task.function for task in self.tasks]
            raise Usage(f"{self.id} has no function {function}.{near(function, known)}")
        return found[0]


def assignments(folder: Path = FOLDER) -> list[str]:
    return [path.stem for path in sorted(folder.glob("*.toml")) if path.stem not in TEXTS]


def load(name: str | Path) -> Assignment:
    """An assignment by its name in lessons/homework, or by the path of its TOML file."""
    path = Path(name)
    if path.suffix != ".toml":
        known = assignments()
        if str(name) not in known:
            raise Usage(f"there is no assignment {name}.{near(str(name), known)}")
        path = FOLDER / f"{name}.toml"
    if not path.is_file():
        raise Usage(f"there is no file {path}; an assignment is a .toml file or a name of: {', '.join(assignments())}.")
    from app.grade.assignment_file import parsed

    return parsed(path, path.read_bytes())


@cache
def own_module(path: Path):
    """A lecturer's own reference; whoever writes an assignment is trusted."""
    spec = spec_from_file_location(f"halfway_reference_{path.stem}", path)
    assert spec is not None and spec.loader is not None
    module = module_from_spec(spec)
    try:
        spec.loader.exec_module(module)
    except Exception as error:
        raise Problem(f"{path.name} does not run: {type(error).__name__}: {error}.") from error
    return module
