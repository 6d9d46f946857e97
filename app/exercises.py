"""An exercise beside its scene: which function of a step is one, and what the visible checks say of what is typed.

The way from the window to the grader: the window knows `Checker` and shows `Verdicts`; the grader is loaded in the
checker's own thread, when there is something to check, and runs the text in a process of its own.
"""

import threading
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from app.catalog import LoadedStep
from app.lesson import Exercise
from app.problem import Problem

if TYPE_CHECKING:
    from app.grade.live import Finding


@dataclass(frozen=True)
class Verdicts:
    """What is known of a text: `finding` has tests, misconceptions and a plot; without one, `said` tells why."""

    exercise: str
    text: str = field(repr=False)
    finding: "Finding | None" = None
    said: str = ""

    @property
    def ok(self) -> bool:
        return self.finding is not None and self.finding.ok

    @property
    def lines(self) -> list[tuple[bool, str]]:
        """(whether it holds, a sentence) for every check, then what it looks like: what a panel shows."""
        if self.finding is None:
            return [(False, self.said)]
        if self.finding.said:
            return [(False, self.finding.said)]
        return [(test.verdict == "pass", f"{test.region}{f': {test.message}' if test.message else ''}")
                for test in self.finding.tests] + [(False, f"It looks like {one.id}: {one.message}")
                                                   for one in self.finding.suspects]


def of_step(found: LoadedStep) -> dict[str, Exercise]:
    """The exercises of the step's chapter by their names, chapter/name; those of its slides first."""
    own = {f"{found.loaded.id}/{one.name}": one for one in found.chapter.exercises}
    return dict(sorted(own.items(), key=lambda pair: pair[1].slide not in found.step.slides))


class Checker:
    """Checks the last text it was given, in the background; what was typed meanwhile is checked next."""

    def __init__(self) -> None:
        self.lock = threading.Lock()
        self.wish: tuple[str, str] | None = None
        self.thread: threading.Thread | None = None
        self.shown: Verdicts | None = None

    def ask(self, exercise: str, text: str) -> None:
        """Wants the verdicts of a text; of one that is shown or wanted already it does nothing."""
        with self.lock:
            if self.shown and self.thread is None and (self.shown.exercise, self.shown.text) == (exercise, text):
                return
            self.wish = exercise, text
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
                wish, self.wish = self.wish, None
                if wish is None:
                    self.thread = None
                    return
            self.shown = verdicts(*wish)


def verdicts(exercise: str, text: str) -> Verdicts:
    """What the visible checks say of a GLSL text for an exercise, chapter/name; it may include what its stub does."""
    try:
        from app.grade import live, texts

        return Verdicts(exercise, text, live.verdicts(exercise, "glsl", texts.inlined(text), plot=True))
    except Problem as problem:
        return Verdicts(exercise, text, None, str(problem))
