"""An assignment as a lecturer writes it: a TOML file in lessons/homework, read whole and refused with a clear sentence.

A task is a function of the course by its name, an exercise of a chapter, or a function of a reference of one's own, a
Python file beside the TOML. Its regions say where it is asked, its properties what must hold, its points what it pays.
"""

import hashlib
import inspect
import tomllib
from collections.abc import Callable
from dataclasses import dataclass, field
from datetime import datetime
from functools import cache, cached_property
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

from app import catalog
from app.grade.points import Domain, domain
from app.lesson import Exercise
from app.optics import names, twin
from app.paths import LESSONS
from app.problem import Problem, Usage, near
from app.quantities import TABLE
from app.tolerance import CONSTANT

FOLDER = LESSONS / "homework"
LANGUAGES = ("python", "glsl")
TEXTS = ("solutions", "mutants")  # files beside them that are no assignments
WIDTHS = {"vec2": 2, "vec3": 3, "vec4": 4}
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


class Reader:
    """Takes keys out of a table of the file; every complaint names the file, the key and the value."""

    def __init__(self, file: Path, place: str, table: object):
        self.file, self.place = file, place
        if not isinstance(table, dict):
            raise self.wrong("", table, "a table")
        self.table, self.known = dict(table), list[str]()

    def wrong(self, key: str, value: object, right: str) -> Usage:
        place = " ".join(part for part in (self.place, key) if part)
        return Usage(f"{self.file.name}: {place} is {value!r}; right is {right}.")

    def take(self, key: str, kind: type, right: str, default: object = None, low: float | None = None,
             high: float | None = None):
        self.known.append(key)
        if key not in self.table:
            if default is None:
                raise Usage(f"{self.file.name}: {self.place or 'the file'} has no {key}; right is {right}.")
            return default
        value = self.table.pop(key)
        number = kind is float and isinstance(value, int)
        if isinstance(value, bool) or not (isinstance(value, kind) or number):
            raise self.wrong(key, value, right)
        if (low is not None and value < low) or (high is not None and value > high):
            raise self.wrong(key, value, right)
        return float(value) if kind is float else value

    def done(self) -> None:
        for key in self.table:
            raise Usage(f"{self.file.name}: {self.place or 'the file'} has the key {key}, which says nothing here; "
                        f"there are {', '.join(self.known)}.{near(key, self.known)}")


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
    data = path.read_bytes()
    return parsed(path, data)


def parsed(path: Path, data: bytes) -> Assignment:
    try:
        table = tomllib.loads(data.decode("utf-8"))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise Usage(f"{path.name} is no TOML: {error}.") from None
    top = Reader(path, "", table)
    title = top.take("title", str, "a line of words")
    chapter = top.take("chapter", str, "the name of a chapter")
    chapters = {loaded.id: loaded for loaded in catalog.chapters()}
    if chapter not in chapters:
        raise Usage(f"{path.name}: chapter is {chapter!r}; there is no such chapter.{near(chapter, chapters)}")
    languages = tuple(top.take("languages", list, 'a list of "python" and "glsl"', list(LANGUAGES)))
    if not languages or any(word not in LANGUAGES for word in languages):
        raise top.wrong("languages", list(languages), 'a list of "python" and "glsl"')
    due = top.take("due", datetime, "a time with its zone, like 2026-12-01T23:59:00+01:00", False) or None
    if due and due.tzinfo is None:
        raise top.wrong("due", due.isoformat(), "a time with its zone, like 2026-12-01T23:59:00+01:00")
    late = Reader(path, "late", top.take("late", dict, "a table of per_day and days", {}))
    per_day = late.take("per_day", float, "a share of the points, 0 to 1", 0.0, 0, 1)
    days = late.take("days", int, "whole days, 0 or more", 0, 0)
    late.done()
    seconds = top.take("seconds", float, "seconds of processor time, 0.1 to 600", 10.0, 0.1, 600)
    given = top.take("task", list, "[[task]] tables")
    top.done()
    if not given:
        raise Usage(f"{path.name} has no [[task]]; an assignment asks for at least one function.")
    tasks = tuple(task_of(path, f"task {i}", one) for i, one in enumerate(given, 1))
    twice = [task.function for i, task in enumerate(tasks) if task.function in {t.function for t in tasks[:i]}]
    if twice:
        raise Usage(f"{path.name}: {twice[0]} is asked twice; a function is one task.")
    return Assignment(path.stem, title, chapter, path, tasks, languages, due, per_day, days, seconds,
                      digest(data, tasks))


def digest(data: bytes, tasks: tuple[Task, ...]) -> str:
    """A hash of everything that decides a score: the file, the references of one's own, the exercises' points."""
    found = hashlib.sha256(data)
    for task in tasks:
        found.update(task.own.read_bytes() if task.own else b"")
        found.update(repr([(r.name, r.at) for r in task.regions if r.at]).encode())
    return found.hexdigest()[:16]


def task_of(path: Path, place: str, table: object) -> Task:
    top = Reader(path, place, table)
    exercise = exercise_of(top)
    function = top.take("function", str, "the name of a function", exercise.function if exercise else None)
    top.place = f"{place} ({function})"
    own = top.take("reference", str, "a Python file beside this one", "")
    module = path.parent / own if own else None
    arguments = signature(top, function, module)
    widths = top.take("widths", dict, "a table of argument to 2, 3 or 4", {})
    points = top.take("points", float, "a number above 0", None, 1e-9)
    text = top.take("text", str, "what is asked, in a sentence", exercise.task if exercise else None)
    slide = top.take("slide", str, "a slide of the deck", exercise.slide if exercise else "")
    regions = checks(exercise) if exercise else []
    for i, one in enumerate(top.take("region", list, "[[task.region]] tables", []), 1):
        regions.append(region_of(path, f"{top.place}, region {i}", one, arguments, bool(own)))
    named = [region.name for region in regions]
    if twice := next((name for i, name in enumerate(named) if name in named[:i]), ""):
        raise Usage(f"{path.name}: {top.place} has two regions {twice!r}; a region's name is its own"
                    f"{', and the exercise has checks with names already' if exercise else ''}.")
    if not regions:
        raise Usage(f"{path.name}: {top.place} has no [[task.region]]; nothing would be asked.")
    properties = []
    for i, one in enumerate(top.take("property", list, "[[task.property]] tables", []), 1):
        properties.append(property_of(path, f"{top.place}, property {i}", one, arguments))
    drawn = top.take("picture", dict, "a table", {})
    picture = picture_of(path, f"{top.place}, picture", drawn, arguments, bool(own)) if drawn else None
    powers = tuple(top.take("powers", list, "a list of arguments", []))
    for word in powers:
        if word not in arguments:
            raise top.wrong("powers", word, f"an argument: {', '.join(arguments)}")
    task = Task(function, points, text, slide, arguments, tuple(regions), tuple(properties), picture, exercise, module,
                top.take("width", int, "numbers of a value, 1 to 4", width_returned(function, module), 1, 4),
                width_of(top, arguments, widths),
                top.take("absolute", float, "0 or a size", 0.0, 0), powers,
                top.take("runtime", float, "a share of the points, 0 to 0.5", 0.0, 0, 0.5),
                top.take("gross", float, "a factor, 2 or more", 10.0, 2))
    top.done()
    return task


def exercise_of(top: Reader) -> Exercise | None:
    name = top.take("exercise", str, "chapter/name of an exercise", "")
    known = exercises()
    if name and name not in known:
        raise Usage(f"{top.file.name}: {top.place} exercise is {name!r}; there is no such exercise.{near(name, known)}")
    return known[name] if name else None


@cache
def exercises() -> dict[str, Exercise]:
    return {f"{loaded.id}/{exercise.name}": exercise for loaded in catalog.chapters()
            for exercise in loaded.chapter.exercises}


def checks(exercise: Exercise) -> list[Region]:
    """The points that the exercise itself names."""
    sizes = [len(next(iter(check.args.values()))) for check in exercise.checks]
    return [Region(check.words, {}, 0 if check.hidden else size, size if check.hidden else 0, 1.0, check.args)
            for check, size in zip(exercise.checks, sizes, strict=True)]


def signature(top: Reader, function: str, module: Path | None) -> tuple[str, ...]:
    if module is None and function not in names():
        raise Usage(f"{top.file.name}: {top.place} names no function of the course.{near(function, names())}")
    if module is not None and not module.is_file():
        raise top.wrong("reference", module.name, "a Python file beside this one")
    known = vars(own_module(module)) if module else {}
    if module is not None and not callable(known.get(function)):
        raise Usage(f"{top.file.name}: {module.name} has no function {function}.{near(function, known)}")
    call = known[function] if module else twin(function)
    found = tuple(inspect.signature(call).parameters)
    odd = [name for name in found if name in CONSTANT or (name in TABLE and TABLE[name].kind == "int")]
    if odd:
        raise Usage(f"{top.file.name}: {top.place} has the argument {odd[0]}, which is no number that varies from "
                    "point to point; ask for a function of numbers and vectors.")
    return found


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


def width_returned(function: str, module: Path | None) -> int:
    from app.shader import catalogue

    return 1 if module or function not in catalogue() else WIDTHS.get(catalogue()[function][1].returns, 1)


def width_of(top: Reader, arguments: tuple[str, ...], widths: dict) -> tuple[int, ...]:
    for name, width in widths.items():
        if name not in arguments or width not in (1, 2, 3, 4):
            raise top.wrong(f"widths {name}", width, f"2, 3 or 4 for an argument: {', '.join(arguments)}")
    return tuple(widths.get(name, TABLE[name].width if name in TABLE else 1) for name in arguments)


def domains_of(top: Reader, arguments: tuple[str, ...], free: bool) -> dict[str, Domain]:
    """The domain of every argument: the written ones, elsewhere the ordinary range of the quantity."""
    from app.grade.points import default_of

    found = {}
    for name in arguments:
        top.known.append(name)
        if name in top.table:
            given = top.table.pop(name)
            try:
                found[name] = domain(name, given, arguments, free)
            except (Usage, TypeError, ValueError) as error:
                raise Usage(f"{top.file.name}: {top.place}, {name} = {given!r}: {error}.".replace("..", ".")) from None
        elif name in TABLE:
            found[name] = default_of(name)
        else:
            raise Usage(f"{top.file.name}: {top.place} says nothing of {name}, which is no quantity of the course; "
                        "right is a domain like [0.0, 1.0].")
    return found


def region_of(path: Path, place: str, table: object, arguments: tuple[str, ...], free: bool) -> Region:
    top = Reader(path, place, table)
    name = top.take("name", str, "a line of words")
    top.place = f"{place} ({name})"
    visible = top.take("visible", int, "how many points, 0 to 100000", 64, 0, 100000)
    hidden = top.take("hidden", int, "how many points, 0 to 100000", 192, 0, 100000)
    weight = top.take("weight", float, "a number above 0", 1.0, 1e-9)
    domains = domains_of(top, arguments, free)
    top.done()
    if visible + hidden == 0:
        raise Usage(f"{path.name}: {top.place} has no points; right is visible or hidden above 0.")
    return Region(name, domains, visible, hidden, weight)


def property_of(path: Path, place: str, table: object, arguments: tuple[str, ...]) -> Property:
    from app.grade.properties import swapped

    top = Reader(path, place, table)
    name = top.take("name", str, f"one of {', '.join(PROPERTIES)}")
    if name not in PROPERTIES:
        raise top.wrong("name", name, f"one of {', '.join(PROPERTIES)}")
    if name == "reciprocity" and not swapped(arguments):
        raise top.wrong("name", name, "a property of it: it has no light and eye to swap")
    if name == "energy" and not {"n", "l", "v"} <= set(arguments):
        raise top.wrong("name", name, "a property of it: energy is summed over l, for functions of n, l, v")
    weight = top.take("weight", float, "a number above 0", 1.0, 1e-9)
    top.done()
    return Property(name, weight)


def picture_of(path: Path, place: str, table: object, arguments: tuple[str, ...], free: bool) -> Picture:
    top = Reader(path, place, table)
    size = top.take("size", int, "pixels of a side, 16 to 512", 96, 16, 512)
    weight = top.take("weight", float, "a number above 0", 2.0, 1e-9)
    if not {"n", "v"} <= set(arguments):
        raise Usage(f"{path.name}: {place} needs a function of n and v; {', '.join(arguments)} are its arguments.")
    given = domains_of(top, tuple(name for name in arguments if name not in ("n", "v", "l")), free)
    top.done()
    return Picture(size, weight, given)
