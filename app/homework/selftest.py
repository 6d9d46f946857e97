"""`halfway homework selftest`: the test of the tests. Stubs fail, solutions pass, every catalogued mutant is caught.

Many texts go into one file, one a function, so that a few processes ask hundreds of them.
"""

from collections.abc import Iterable
from dataclasses import dataclass, replace

from app.console import progress
from app.grade import texts
from app.grade.assignment import LANGUAGES, Assignment, Task, assignments, load
from app.grade.intake import Submission
from app.grade.judge import judge
from app.grade.live import OWN, without_speed
from app.grade.question import FILES, Language
from app.grade.questions import questions
from app.grade.result import Suspect, Test
from app.grade.sandbox import Limits
from app.grade.supervisor import answer

STUB_MOST = 0.05  # of its points, for what is no answer


@dataclass(frozen=True)
class Case:
    """A text of one function, and what must become of it."""

    kind: str  # stub, solution, mutant or answer
    name: str
    function: str
    language: Language
    text: str
    misconception: str = ""


@dataclass(frozen=True)
class Outcome:
    case: Case
    tests: tuple[Test, ...]
    suspects: tuple[Suspect, ...]

    @property
    def share(self) -> float:
        return sum(test.score for test in self.tests) / sum(test.max for test in self.tests)

    @property
    def ran(self) -> bool:
        return all(test.verdict in ("pass", "partial", "wrong", "nonfinite", "skipped") for test in self.tests)

    @property
    def said(self) -> str:
        return next((f"{test.verdict}: {test.message}" for test in self.tests if test.verdict not in
                     ("pass", "partial", "wrong", "nonfinite", "skipped")), "")

    @property
    def fault(self) -> str:
        """What is wrong with the tests, if they let a wrong text pass or a right one fail."""
        if not self.ran:
            return self.said
        passed = all(test.verdict == "pass" for test in self.tests)
        told = [suspect.id for suspect in self.suspects]
        if self.case.kind in ("solution", "answer"):
            lost = next((f"{test.region}: {test.message}" for test in self.tests if test.verdict != "pass"), "")
            return "" if passed else f"a right answer loses points ({lost})"
        if self.case.kind == "stub":
            return "" if self.share < STUB_MOST else f"it earns {self.share:.0%}"
        if passed:
            return "it is not caught"
        if self.case.misconception and told[:1] != [self.case.misconception]:
            return f"{self.case.misconception} is not told, but {', '.join(told) or 'nothing'}"
        return ""


def everything() -> Assignment:
    """All functions of all assignments as one."""
    loaded = [load(name) for name in assignments()]
    tasks = {task.function: task for one in loaded for task in one.tasks}
    return without_speed(replace(loaded[0], id="selftest", tasks=tuple(tasks.values()), languages=LANGUAGES,
                                 seconds=60.0))


def cases() -> list[Case]:
    found = []
    for task in everything().tasks:
        for language in languages_of(task):
            found.append(Case("stub", "the stub", task.function, language, texts.stub(task, language)))
            found.append(Case("solution", "the solution", task.function, language, texts.solution(task, language)))
    return found + [Case("mutant", one.name, one.function, one.language, one.text, one.misconception)
                    for one in texts.mutants()]


def languages_of(task: Task) -> tuple[Language, ...]:
    known = {one for name in assignments() for one in load(name).languages
             if any(other.function == task.function for other in load(name).tasks)}
    return tuple(language for language in FILES if language in known)


def outcomes(given: list[Case]) -> Iterable[Outcome]:
    """What becomes of every text, as it is known: visible and hidden points."""
    whole = everything()
    for language in FILES:
        own = [case for case in given if case.language == language]
        asked = {task.function: questions(replace(whole, tasks=(task,)), languages=(language,))
                 + questions(replace(whole, tasks=(task,)), "selftest", True, (language,)) for task in whole.tasks}
        for inside in texts.packed([(case.function, case.text) for case in own], language):
            together = [own[i] for i in inside]
            yield from of_file(whole, language, together, asked)


def of_file(whole: Assignment, language: Language, together: list[Case], asked: dict) -> list[Outcome]:
    text = texts.joined([(case.function, case.text) for case in together], language)
    submission = Submission("selftest", {FILES[language]: text.encode()})
    questioned = [question for case in together for question in asked[case.function]]
    replies = answer(submission, questioned, Limits(cpu=round(whole.seconds)), granted=OWN)
    found = []
    for case in together:
        one = replace(whole, tasks=(whole.task(case.function),))
        result = judge(one, asked[case.function], [reply for reply in replies if reply.id.startswith(
            f"{case.function}/")])
        found.append(Outcome(case, result.tests, result.suspects))
    return found


def run() -> int:
    given = cases()
    found = []
    with progress(len(given)) as tell:
        for one in outcomes(given):
            found.append(one)
            tell(len(found), one.case.function)
    bad = [one for one in found if one.fault]
    for kind, words in {"stub": "stubs fail", "solution": "solutions pass", "mutant": "mutants are caught"}.items():
        of_kind = [one for one in found if one.case.kind == kind]
        good = sum(not one.fault for one in of_kind)
        print(f"{good} of {len(of_kind)} {words}{f' ({good / len(of_kind):.0%})' if kind == 'mutant' else ''}")
    told = [one for one in found if one.case.misconception]
    print(f"{sum(not one.fault for one in told)} of {len(told)} that have a name are told it")
    for one in bad:
        print(f"  {one.case.function}, {one.case.language}, {one.case.name}: {one.fault}")
    return 1 if bad else 0
