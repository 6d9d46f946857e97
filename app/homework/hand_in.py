"""The file to hand in, made of the texts that a student has written one by one."""

import time
from collections.abc import Mapping
from pathlib import Path

from app.export.target import make_folder, write
from app.files import reason
from app.grade.assignment import Assignment, Task
from app.grade.live import Finding, findings
from app.grade.question import FILES, Language
from app.grade.texts import declares, standalone
from app.homework.command import starter
from app.problem import Problem, Usage


def hand_in(
    assignment: Assignment, language: Language, texts: Mapping[str, str], folder: Path
) -> tuple[Path, list[Finding]]:
    """FOLDER/assignment/submission.glsl or .py of these texts, chapter/name -> text; stubs where there is none. Another
    text that was there is kept in FOLDER/earlier. Returns the file, and what `halfway check` says of it."""
    whole = submission(assignment, language, texts)
    path = make_folder(folder / assignment.id) / FILES[language]
    keep_earlier(path, whole.encode(), folder / "earlier")
    write(path, whole.encode())
    return path, findings(assignment, language, whole, plot=False)


def submission(assignment: Assignment, language: Language, texts: Mapping[str, str]) -> str:
    """One text of all, each able to stand alone; what would spoil the others is a Problem."""
    if language not in assignment.languages:
        raise Usage(f"{assignment.id} is answered in {' or '.join(assignment.languages)}, not in {language}.")
    own = {task.function: alone(task, language, texts[name]) for task in assignment.tasks
           if task.exercise and (name := f"{assignment.chapter}/{task.exercise.name}") in texts}
    known: dict[str, tuple[str, str]] = {}  # a name -> the function whose text declares it, and how
    for function, text in own.items():
        for name, words in declares(text, language).items():
            first, before = known.setdefault(name, (function, words))
            if before != words:
                raise Problem(f"your texts of {first} and {function} both declare {name}, each its own way; one file "
                              f"can have only one. Rename one.")
    return starter(assignment, language, own)


def alone(task: Task, language: Language, text: str) -> str:
    """A text without includes, in which the function is defined."""
    if language == "python":
        try:
            defined = declares(text, language)
        except SyntaxError as error:
            raise Problem(f"your {task.function}, line {error.lineno}: {error.msg}; in one file it would spoil the "
                          f"others too.") from None
        found = text
    else:
        found = standalone(text, task.function)
        defined = declares(found, language)
    if task.function not in defined:
        raise Problem(f"your text of {task.function} does not define it.")
    return found


def keep_earlier(path: Path, new: bytes, earlier: Path) -> None:
    try:
        old = path.read_bytes()
    except FileNotFoundError:
        return
    except OSError as error:
        raise Problem(f"{path} cannot be read: {reason(error)}.") from None
    if old != new:
        name = f"{path.parent.name}-{time.strftime('%Y%m%d-%H%M%S')}{path.suffix}"
        write(make_folder(earlier) / name, old)
