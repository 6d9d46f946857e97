"""Reads an assignment's TOML: a complaint is a sentence with the file, the key, the value and what would be right."""

import hashlib
import inspect
import math
import tomllib
from datetime import date, datetime
from functools import cache
from pathlib import Path

from app import catalog, shader
from app.grade.assignment import LANGUAGES, PROPERTIES, Assignment, Picture, Property, Region, Task, own_module
from app.grade.points import Domain, default_of, domain
from app.grade.properties import swapped
from app.lesson import Exercise
from app.optics import names, twin
from app.problem import Usage, near
from app.quantities import TABLE
from app.tolerance import CONSTANT


class Reader:
    """Takes keys out of a table of the file; every complaint names the file, the key and the value."""

    def __init__(self, file: Path, place: str, table: object):
        self.file, self.place = file, place
        if not isinstance(table, dict):
            raise self.wrong("", table, "a table")
        self.table, self.known = dict(table), list[str]()

    def wrong(self, key: str, value: object, right: str) -> Usage:
        place = " ".join(part for part in (self.place, key) if part)
        shown = value.isoformat() if isinstance(value, date) else repr(value)
        return Usage(f"{self.file.name}: {place} is {shown}; right is {right}.")

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
        if kind is float and not math.isfinite(value):
            raise self.wrong(key, value, right)
        if (low is not None and value < low) or (high is not None and value > high):
            raise self.wrong(key, value, right)
        return float(value) if kind is float else value

    def done(self) -> None:
        for key in self.table:
            raise Usage(f"{self.file.name}: {self.place or 'the file'} has the key {key}, which says nothing here; "
                        f"there are {', '.join(self.known)}.{near(key, self.known)}")


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


def width_returned(function: str, module: Path | None) -> int:
    known = shader.catalogue()
    return 1 if module or function not in known else shader.WIDTH.get(known[function][1].returns, 1)


def width_of(top: Reader, arguments: tuple[str, ...], widths: dict) -> tuple[int, ...]:
    for name, width in widths.items():
        if name not in arguments or width not in (1, 2, 3, 4):
            raise top.wrong(f"widths {name}", width, f"2, 3 or 4 for an argument: {', '.join(arguments)}")
    return tuple(widths.get(name, TABLE[name].width if name in TABLE else 1) for name in arguments)


def domains_of(top: Reader, arguments: tuple[str, ...], free: bool) -> dict[str, Domain]:
    """The domain of every argument: the written ones, elsewhere the ordinary range of the quantity."""
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
