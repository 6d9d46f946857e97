"""An exercise beside its scene: which function of a step is one, and what the visible checks say of what is typed.

The way from the window to the grader: the window knows `Checker` and shows `Verdicts`; the grader is loaded in the
checker's own thread, when there is something to check, and runs the text in a process of its own.
"""

import threading
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from app.catalog import LoadedStep
from app.lesson import Exercise
from app.problem import Problem

if TYPE_CHECKING:
    from app.grade.live import Finding
    from app.grade.sweep import Sweep

Language = Literal["glsl", "python"]


@dataclass(frozen=True)
class Verdicts:
    """What is known of a text: `finding` has tests, misconceptions and a plot; without one, `said` tells why."""

    exercise: str
    language: Language
    text: str = field(repr=False)
    finding: "Finding | None" = None
    said: str = ""

    @property
    def of(self) -> tuple[str, Language, str]:
        return self.exercise, self.language, self.text

    @property
    def ok(self) -> bool:
        return self.finding is not None and self.finding.ok

    @property
    def checks(self) -> list[tuple[bool, str]]:
        """(whether it holds, a sentence) for every check; one alone where there are no values, with the reason."""
        reason = self.finding.said if self.finding else self.said
        if self.finding is None or reason:
            return [(False, reason)]
        return [(test.verdict == "pass", f"{test.region}{f': {test.message}' if test.message else ''}")
                for test in self.finding.tests]

    @property
    def suspects(self) -> list[tuple[str, str]]:
        """(its name, a hint) for every known misconception that the answers match."""
        return [(one.id, one.message) for one in self.finding.suspects] if self.finding else []

    @property
    def worst(self) -> tuple[str, str, str] | None:
        """Where it is worst, what was expected there and what came, as `halfway check` says them."""
        from app.homework.check import numbers, spoken

        if self.finding is None or self.finding.worst is None or (at := self.finding.worst.worst) is None:
            return None
        place = ", ".join(f"{name} = {spoken(name, value)}" for name, value in at.args.items())
        return f"{self.finding.worst.region}, {place}", numbers(at.expected), numbers(at.got)

    @property
    def plot(self) -> "Sweep | None":
        return self.finding.plot if self.finding else None


def of_step(found: LoadedStep) -> dict[str, Exercise]:
    """The exercises of the step's chapter by their names, chapter/name; those of its slides first."""
    own = {f"{found.loaded.id}/{one.name}": one for one in found.chapter.exercises}
    return dict(sorted(own.items(), key=lambda pair: not taught(found, pair[1])))


def taught(found: LoadedStep, exercise: Exercise) -> bool:
    """Whether the step teaches the exercise's slide."""
    return exercise.slide in found.step.slides


class Checker:
    """Checks the last text it was given, in the background; what was typed meanwhile is checked next."""

    def __init__(self, on_verdicts: Callable[[], None] = lambda: None) -> None:
        self.on_verdicts = on_verdicts
        self.lock = threading.Lock()
        self.wish: tuple[str, Language, str] | None = None
        self.now: tuple[str, Language, str] | None = None  # what is being checked
        self.thread: threading.Thread | None = None
        self.shown: Verdicts | None = None

    def ask(self, exercise: str, text: str, language: Language = "glsl") -> None:
        """Wants the verdicts of a text; of one that is shown, checked or wanted already it does nothing."""
        with self.lock:
            last = self.wish or self.now or (self.shown.of if self.shown else None)
            if last == (exercise, language, text):
                return
            self.wish = exercise, language, text
            if self.thread is None:
                self.thread = threading.Thread(target=self.work, name="exercise", daemon=True)
                self.thread.start()

    @property
    def busy(self) -> bool:
        return self.thread is not None

    def wait(self, seconds: float = 30.0) -> Verdicts | None:
        """The verdicts once nothing is asked any more."""
        thread = self.thread
        if thread:
            thread.join(seconds)
        return self.shown

    def work(self) -> None:
        while True:
            with self.lock:
                self.now, self.wish = self.wish, None
                if self.now is None:
                    self.thread = None
                    return
            exercise, language, text = self.now
            try:
                self.shown = verdicts(exercise, text, language)
            except Exception as error:  # whatever the machine does, the next text is checked
                self.shown = Verdicts(exercise, language, text, None, f"{type(error).__name__}: {error}")
            self.on_verdicts()


def verdicts(exercise: str, text: str, language: Language = "glsl") -> Verdicts:
    """What the visible checks say of a text for an exercise, chapter/name; GLSL may include what its stub does."""
    try:
        from app.grade import live, texts

        whole = texts.inlined(text) if language == "glsl" else text
        return Verdicts(exercise, language, text, live.verdicts(exercise, language, whole, plot=True))
    except Problem as problem:
        return Verdicts(exercise, language, text, None, str(problem))


@dataclass(frozen=True)
class Handed:
    """A file to hand in: how many of its functions pass every visible check; `said`: why none of it runs."""

    path: Path
    good: int
    count: int
    said: str


def hand_in(exercise: str, language: Language, texts: Mapping[str, str], folder: Path) -> Handed:
    """Writes the file of the assignment that asks an exercise, of these texts (chapter/name -> text)."""
    from app.grade.live import asked_in
    from app.homework.hand_in import hand_in as write

    path, found = write(asked_in(exercise)[0], language, texts, folder)
    reasons = {one.said for one in found}
    return Handed(path, sum(one.ok for one in found), len(found), reasons.pop() if len(reasons) == 1 else "")
