"""Results as they lie in a folder: class.json, and a result.json for each student. Reports are made of them alone."""

import hashlib
import json
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from app.grade.assignment import Assignment
from app.grade.report.words import NO_VALUES, points, told
from app.problem import Problem, Usage

SCHEMA = "halfway-class-1"


def folder_of(student: str) -> str:
    """A folder's name for a student, safe on every system; the name itself where it is plain."""
    plain = "".join(c if c.isalnum() or c in " -_.@+" else "_" for c in student).rstrip(". ")
    return plain if plain == student else f"{plain[:80]}-{hashlib.sha256(student.encode()).hexdigest()[:8]}"


def class_facts(assignment: Assignment, grader: dict, students: Iterable[str]) -> dict:
    """class.json: what was asked of whom, and by which grader."""
    return {"schema": SCHEMA, "grader": grader, "students": sorted(students), "assignment": {
        "id": assignment.id, "hash": assignment.digest, "title": assignment.title, "points": assignment.points,
        "due": assignment.due.isoformat() if assignment.due else None,
        "tasks": [{"function": task.function, "points": task.points, "text": task.text, "slide": task.slide}
                  for task in assignment.tasks]}}


def read(path: Path) -> dict:
    try:
        return sound(json.loads(path.read_bytes()))
    except FileNotFoundError:
        raise Usage(f"there is no {path}; name a folder that `halfway grade -o` wrote.") from None
    except (OSError, ValueError):
        raise Problem(f"{path} cannot be read; grade with --resume, then it is written anew.") from None


def sound(value):
    """Without half characters, which no format can hold."""
    if isinstance(value, dict):
        return {key: sound(inner) for key, inner in value.items()}
    if isinstance(value, list):
        return [sound(inner) for inner in value]
    return value.encode("utf-8", "replace").decode("utf-8") if isinstance(value, str) else value


@dataclass(frozen=True)
class Results:
    """A folder of results."""

    folder: Path

    @cached_property
    def facts(self) -> dict:
        return read(self.folder / "class.json")

    @property
    def students(self) -> list[str]:
        return self.facts["students"]

    def place(self, student: str) -> Path:
        return self.folder / "students" / folder_of(student)

    def sheet(self, student: str) -> "Sheet":
        return Sheet(self.facts, read(self.place(student) / "result.json"))


@dataclass(frozen=True)
class Sheet:
    """One student's result, beside what was asked."""

    facts: dict  # class.json
    result: dict

    @property
    def student(self) -> str:
        return self.result["submission"]["student_id"]

    @property
    def assignment(self) -> dict:
        return self.facts["assignment"]

    @property
    def most(self) -> float:
        return self.assignment["points"]

    @property
    def override(self) -> dict | None:
        return next(iter(self.result["overrides"]), None)

    @property
    def mark(self) -> float | None:
        """What counts: by hand, else as graded; None where it is ungraded."""
        return self.override["points"] if self.override else self.result.get("score")

    @property
    def graded(self) -> bool:
        return self.mark is not None

    @property
    def visible(self) -> str:
        """'3.1 of 5', of the visible points; '' where nothing was graded."""
        score, most = self.result["visible_score"], self.result["visible_max"]
        return "" if score is None or most is None else f"{points(score)} of {points(most)}"

    @property
    def hidden(self) -> str:
        """The same of the hidden points; '' where there are none."""
        rest = [self.result[name] - self.result[f"visible_{name}"] for name in ("score", "max")]
        return f"{points(rest[0])} of {points(rest[1])}" if rest[1] > 0 else ""

    @cached_property
    def items(self) -> list["Item"]:
        def named(key: str, function: str) -> list[dict]:
            return [one for one in self.result.get(key, ()) if one["function"] == function]

        return [Item(task, *(named(key, task["function"]) for key in ("tests", "misconceptions", "curves")))
                for task in self.assignment["tasks"]]

    @property
    def first(self) -> "Item | None":
        """What to fix first: where most points are lost."""
        lost = [item for item in self.items if item.lost > 0]
        return max(lost, key=lambda item: item.lost, default=None)

    @property
    def at_once(self) -> str:
        """What was said of everything alike: a text that does not compile, nothing handed in."""
        said = {item.said for item in self.items}
        return said.pop() if len(said) == 1 and len(self.items) > 1 else ""


@dataclass(frozen=True)
class Item:
    """One function of one student."""

    task: dict
    tests: list[dict]
    suspects: list[dict]
    curves: list[dict]

    @property
    def function(self) -> str:
        return self.task["function"]

    def total(self, what: str, visibility: str = "") -> float:
        return sum(test[what] for test in self.tests if visibility in ("", test["visibility"]))

    @property
    def lost(self) -> float:
        return self.total("max") - self.total("score")

    @property
    def failed(self) -> list[dict]:
        """The tests that are not passed; the costly ones first."""
        return sorted((test for test in self.tests if test["verdict"] != "pass"),
                      key=lambda test: test["score"] - test["max"])

    @property
    def worst(self) -> dict | None:
        return next((test for test in self.failed if test["worst"]), None)

    @property
    def said(self) -> str:
        """Why there are no values at all: what the compiler or the function said."""
        silent = {(test["verdict"], test["message"]) for test in self.tests if test["group"] != "runtime"}
        verdict, message = silent.pop() if len(silent) == 1 else ("", "")
        return told(verdict, message) if verdict in NO_VALUES else ""
