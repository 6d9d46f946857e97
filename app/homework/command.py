"""`halfway homework`: which assignments there are, a file to start from, and the test of the tests."""

import argparse
from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType

from app.grade.assignment import Assignment, Task, assignments, load
from app.grade.question import FILES
from app.problem import Problem, Usage, near

WHAT = ("list", "new", "selftest")
COMMENT = {"python": "#", "glsl": "//"}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("what", metavar="WHAT", help="list; new NAME, a file to start from; selftest")
    parser.add_argument("name", metavar="NAME", nargs="?", default="", help="of an assignment")
    parser.add_argument("--lang", metavar="LANGUAGE", default="python", help="python or glsl")


def run(options: argparse.Namespace) -> int:
    if options.what not in WHAT:
        raise Usage(f"halfway homework knows no {options.what}; it knows {', '.join(WHAT)}.{near(options.what, WHAT)}")
    if options.what == "selftest":
        from app.homework.selftest import run as selftest

        return selftest()
    if options.what == "list":
        return listed()
    if not options.name:
        raise Usage(f"name an assignment: halfway homework new NAME, of {', '.join(assignments())}.")
    return new(load(options.name), options.lang)


def listed() -> int:
    for name in assignments():
        found = load(name)
        due = f", due {found.due:%Y-%m-%d %H:%M}" if found.due else ""
        print(f"{name:20s}{found.title}, {found.points:g} points{due}")
        for task in found.tasks:
            print(f"    {task.points:4g}  {task.function:26s}{first_sentence(task.text)}")
    print("\nhalfway homework new NAME writes a file to start from; --lang glsl for a shader.")
    return 0


def first_sentence(text: str) -> str:
    head = text.partition(". ")[0].rstrip(".")
    return head if len(head) <= 90 else head[:88].rsplit(" ", 1)[0] + " …"


def new(assignment: Assignment, language: str) -> int:
    """A folder with the file to hand in: every function's stub, which the check fails."""
    if language not in assignment.languages:
        raise Usage(f"{assignment.id} is answered in {' or '.join(assignment.languages)}, not in {language}.")
    from app.export.target import make_folder, write

    folder = make_folder(Path(assignment.id))
    path = folder / FILES[language]  # type: ignore[index]
    if path.exists():
        raise Problem(f"{path} exists already; it is yours, and stays as it is.")
    write(path, starter(assignment, language).encode())
    print(f"{path} is yours to fill. Check it as often as you like: halfway check {path}\n"
          f"When it is done, hand in the folder {folder}, or the file.")
    return 0


def starter(assignment: Assignment, language: str, texts: Mapping[str, str] = MappingProxyType({})) -> str:
    """The file to hand in: a text for each function, the stub where there is none."""
    from app.grade.texts import imported, joined, stub

    mark = COMMENT[language]
    head = [f"{mark} halfway homework: {assignment.id}", f"{mark} {assignment.title}",
            f"{mark} Check it: halfway check {assignment.id}/{FILES[language]}"]  # type: ignore[index]
    if language == "python":
        head.append("# Every argument is an array of numpy, one row a point; so is what you return.")
    else:
        head.append("// Functions only: no #include, no uniforms. Every function is called once a point, in float32.")
    parts = []
    for task in assignment.tasks:
        lines = texts.get(task.function, stub(task, language)).split("\n")
        code = "\n".join(line for line in lines if not imported(line)).lstrip("\n")
        first = [line for line in lines if imported(line)] if language == "python" else []
        parts.append((task.function, "\n".join([*first, *intended(task, language), code])))
    return "\n".join(head) + "\n\n" + joined(parts, language)


def intended(task: Task, language: str) -> list[str]:
    """What is asked, above a stub."""
    from app.grade.texts import units, wrapped

    before = f"{COMMENT[language]} "
    lines = [*wrapped(task.text, before), *wrapped(units(task), before)]
    if task.slide:
        lines.append(f"{before}Slide: {task.slide}")
    return lines
