"""The visible checks of a text while it is written: for `halfway check`, and for the window beside the scene.

The text runs in a process of its own, through the same supervisor and the same judge as when it is handed in; so an
endless loop ends, and the verdicts are the same. It is the student's own machine and text: isolation is not needed.
"""

from dataclasses import dataclass, replace

import numpy as np

from app.grade import sweep
from app.grade.assignment import Assignment, Task, assignments, load
from app.grade.intake import Submission
from app.grade.judge import judge
from app.grade.question import FILES, Language
from app.grade.questions import questions
from app.grade.result import Result, Suspect, Test
from app.grade.sandbox import Limits
from app.grade.supervisor import answer
from app.problem import Usage, near

OWN = "L0"  # no sandbox: nobody else's text, nobody else's machine


@dataclass(frozen=True)
class Finding:
    """What became of one function: its visible tests, what it looks like, and a plot through its worst point."""

    task: Task
    language: Language
    tests: tuple[Test, ...]
    suspects: tuple[Suspect, ...] = ()
    plot: sweep.Sweep | None = None

    @property
    def ok(self) -> bool:
        return all(test.verdict == "pass" for test in self.tests)

    @property
    def worst(self) -> Test | None:
        """The test that costs most."""
        lost = [test for test in self.tests if test.verdict != "pass" and test.worst]
        return max(lost, key=lambda test: test.max - test.score, default=None)

    @property
    def said(self) -> str:
        """Why there are no values: what the compiler or the function said."""
        return next((f"{test.verdict.replace('_', ' ')}: {test.message}" for test in self.tests
                     if test.verdict not in ("pass", "partial", "wrong", "nonfinite", "skipped") or
                     (test.verdict == "wrong" and test.worst is None and test.group == "points")), "")


def verdicts(exercise: str, language: Language, text: str, plot: bool = False) -> Finding:
    """What the visible checks say of a text for an exercise, chapter/name."""
    assignment, task = asked_in(exercise)
    return findings(alone(assignment, task), language, text, plot)[0]


def asked_in(exercise: str) -> tuple[Assignment, Task]:
    """The assignment that asks an exercise, and its task there."""
    known = {}
    for name in assignments():
        assignment = load(name)
        for task in assignment.tasks:
            if task.exercise:
                known[f"{assignment.chapter}/{task.exercise.name}"] = assignment, task
    if exercise not in known:
        raise Usage(f"no assignment asks an exercise {exercise}.{near(exercise, known)}")
    return known[exercise]


def alone(assignment: Assignment, task: Task) -> Assignment:
    return replace(assignment, tasks=(task,))


def findings(assignment: Assignment, language: Language, text: str, plot: bool = True) -> list[Finding]:
    """One a function of the assignment, in its order."""
    result, submission = graded(assignment, language, text)
    found = by_function(assignment, result)
    return with_plots(found, submission, limits(assignment)) if plot else found


def by_function(assignment: Assignment, result: Result) -> list[Finding]:
    found = []
    for task in assignment.tasks:
        tests = tuple(test for test in result.tests if test.function == task.function)
        suspects = tuple(one for one in result.suspects if one.function == task.function)
        if tests:
            language: Language = "glsl" if tests[0].language == "glsl" else "python"
            found.append(Finding(task, language, tests, suspects))
    return found


def graded(assignment: Assignment, language: Language, text: str) -> tuple[Result, Submission]:
    submission = Submission("you", {FILES[language]: text.encode()})
    asked = questions(without_speed(assignment), languages=(language,))
    replies = answer(submission, asked, limits(assignment), granted=OWN)
    return judge(without_speed(assignment), asked, replies), submission


def limits(assignment: Assignment) -> Limits:
    """Tighter than when it is handed in: a person waits, and here are a few hundred points."""
    return Limits(cpu=max(1, min(2, round(assignment.seconds))), wall=3.0)


def without_speed(assignment: Assignment) -> Assignment:
    """Speed is measured against the solution, which a student's machine does not ask."""
    return replace(assignment, tasks=tuple(replace(task, runtime=0.0) for task in assignment.tasks))


def with_plots(found: list[Finding], submission: Submission, limits: Limits, granted: str = OWN) -> list[Finding]:
    """A plot for every function that has values and is wrong, asked in one more process."""
    plans = {one.task.function: plan for one in found if one.worst and one.worst.worst
             and (plan := sweep.through(one.task, one.worst.worst.args, one.language))}
    if not plans:
        return found
    asked = [plan.question for plan in plans.values()]
    replies = {reply.id: reply for reply in answer(submission, asked, limits, granted)}
    return [replace(one, plot=sweep.plotted(plan, np.asarray(values)))
            if (plan := plans.get(one.task.function)) and (values := replies[plan.question.id].values) is not None
            else one for one in found]
