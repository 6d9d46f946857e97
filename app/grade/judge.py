"""The judge: an assignment, what was asked, what came back; it starts no process and knows no file.

A region pays the share of its points that are right, so that ten grazing ones are not drowned by a thousand easy ones.
What a constant or an echoed argument gets right, and every property, pays only as far as the other points are right.
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from app.grade import misconceptions, picture, properties
from app.grade.agree import MEMORY, Truth, agrees, off_by
from app.grade.assignment import PROPERTIES, Assignment, Task
from app.grade.question import Question, Reply
from app.grade.questions import PART, Rows, layout
from app.grade.result import Result, Suspect, Test, Worst, number


def judge(assignment: Assignment, questions: Sequence[Question], replies: Sequence[Reply],
          times: Mapping[str, float] | None = None) -> Result:
    """The tests and marks of one submission.

    replies: in any order; a question without one is ungraded. times: the processor seconds of the solution at the same
    questions, for what speed pays.
    """
    asked = {question.id: question for question in questions}
    first = {reply.id: reply for reply in replies}
    tests: list[Test] = []
    suspects: list[Suspect] = []
    for task in assignment.tasks:
        ways = []
        for language in dict.fromkeys(question.language for question in questions):
            sheet = Sheet(task, language, asked, first, times or {})
            if sheet.found:
                ways.append((sheet.tests(), sheet.suspects, language))
        if ways:  # of several languages the better one counts
            best = max(ways, key=lambda way: (sum(test.score for test in way[0]), not missing(way[0])))
            if any(test.verdict != "pass" for test in best[0]):  # what the machine lost might have been better
                best = next((way for way in ways if any(test.verdict == "ungraded" for test in way[0])), best)
            tests += best[0]
            suspects += best[1]
    visible = [test for test in tests if test.visibility == "visible"]
    score, most = total(tests)
    seen, seen_most = total(visible)
    return Result(assignment.id, assignment.digest, score, most, seen, seen_most, overall(tests), tuple(tests),
                  tuple(suspects))


def held_to_drawn(task: Task, tests: list[Test]) -> list[Test]:
    """What a table of known points gets right pays little: a visible test at most twice what its hidden twin earns,
    the exercise's own points, which are printed, at most twice what the drawn ones earn."""
    share = {(test.id, test.group): test.score / test.max for test in tests if test.visibility == "hidden" and test.max}
    held = [at_most(test, 2 * share.get((test.id, test.group), 1.0), "its hidden points")
            if test.visibility == "visible" else test for test in tests]
    drawn = {region.name for region in task.regions if region.at is None}
    score, most = total([test for test in held if test.group == "points" and test.region in drawn])
    return [at_most(test, 2 * score / most, "the drawn points") if most and test.group == "points"
            and test.region not in drawn else test for test in held]


def at_most(test: Test, share: float, held_to: str) -> Test:
    if test.score <= share * test.max:
        return test
    return replace(test, score=share * test.max, rationale=f"it counts at most twice what {held_to} earn")


def total(tests: Sequence[Test]) -> tuple[float, float]:
    return number(sum(test.score for test in tests)), number(sum(test.max for test in tests))


def missing(tests: Sequence[Test]) -> bool:
    return all(test.verdict == "missing" for test in tests)


def overall(tests: Sequence[Test]) -> str:
    """One word for a submission; whatever could not be graded makes it ungraded."""
    verdicts = {test.verdict for test in tests}
    if "ungraded" in verdicts or not tests:
        return "ungraded"
    if verdicts <= {"pass"}:
        return "pass"
    if sum(test.score for test in tests) > 0:
        return "partial"
    others = sorted(verdicts - {"pass", "partial", "skipped"})
    return others[0] if len(others) == 1 else "wrong"


class Sheet:
    """One task in one language: what was asked and answered, and the tests that follow."""

    def __init__(self, task: Task, language: str, asked: Mapping[str, Question], first: Mapping[str, Reply],
                 times: Mapping[str, float]):
        self.task, self.language, self.asked, self.first, self.times = task, language, asked, first, times
        self.parts = [part for part in PART if f"{task.function}/{part}/{language}" in asked
                      or f"{task.function}/{part}-picture/{language}" in asked]
        self.found = bool(self.parts)
        self.suspects: list[Suspect] = []

    def tests(self) -> list[Test]:
        found = []
        for part in self.parts:
            found += self.of_points(part)
            if self.task.picture is not None:
                found.append(self.of_picture(part))
            if self.task.runtime:
                found.append(self.of_time(part))
        if not self.suspects and not all(test.verdict == "pass" for test in found):
            self.suspects = self.matches()
        return held_to_drawn(self.task, found)

    # --- weights -----------------------------------------------------------------------------------------------------
    def worth(self, weight: float, regions: bool = False, name: str = "") -> float:
        """The points of a test of some weight: of each region, the visible and the hidden part get half each."""
        task = self.task
        most = (sum(region.weight for region in task.regions) + sum(one.weight for one in task.properties)
                + (task.picture.weight if task.picture else 0.0))
        alone = 1.0
        if regions:
            region = next(region for region in task.regions if region.name == name)
            alone = 1.0 if not (region.visible and region.hidden) else 0.5
        elif weight:
            alone = 0.5
        return task.points * (1 - task.runtime) * weight / most * alone

    # --- the answers -------------------------------------------------------------------------------------------------
    def values(self, key: str) -> tuple[np.ndarray | None, Reply]:
        """The answers to a question, if there are any, and the reply."""
        reply = self.first.get(key) or Reply(key, None, "ungraded", "no answer came back")
        if reply.verdict or reply.values is None:
            return None, reply
        question = self.asked[key]
        shape = (question.count,) if question.width == 1 else (question.count, question.width)
        values = np.asarray(reply.values, float)
        if values.shape != shape:
            said = f"gave the shape {values.shape}; the shape {shape} is right"
            return None, Reply(key, None, "runtime_error", said)
        return values, reply

    def precision(self, values: np.ndarray) -> str:
        """The language whose digits the answers have: Python's count as float32 where float32 holds every one."""
        with np.errstate(all="ignore"):
            single = np.array_equal(values, values.astype(np.float32), equal_nan=True)
        return "glsl" if single and np.any(values) else self.language

    def of_points(self, part: str) -> list[Test]:
        task, key = self.task, f"{self.task.function}/{part}/{self.language}"
        if key not in self.asked:
            return []
        rows = layout(task, PART[part])
        values, reply = self.values(key)
        if values is None:
            return [self.absent(part, "points", one.name, self.worth(self.weight_of(one.name), True, one.name), reply,
                                one.count) for one in rows if one.kind == "region"] + [
                self.absent(part, "property", one.name, self.worth(one.weight), reply) for one in task.properties]
        args = self.asked[key].args
        known, cheap = MEMORY.known(task, args, self.precision(values))
        right = agrees(known, values)
        asked = np.zeros(len(right), bool)
        for one in rows:
            asked[one.slice] = one.kind == "region"
        telling = asked & ~cheap
        agreement = float(np.mean(right[telling])) if np.any(telling) else 1.0
        found = [self.region(part, one, args, known, values, right, cheap, agreement)
                 for one in rows if one.kind == "region"]
        return found + self.properties(part, rows, known, values, agreement)

    def weight_of(self, name: str) -> float:
        return next(region.weight for region in self.task.regions if region.name == name)

    def absent(self, part: str, group: str, name: str, most: float, reply: Reply, points: int = 0) -> Test:
        function, verdict = self.task.function, reply.verdict or "runtime_error"
        return Test(f"{function}/{name}", group, function, name, self.language, part, most, 0.0, most, verdict, points,
                    points, message_key=verdict, message=reply.said)

    def region(self, part, rows: Rows, args, known: Truth, values, right, cheap, agreement) -> Test:
        task, at = self.task, rows.slice
        most = self.worth(self.weight_of(rows.name), True, rows.name)
        good, easy = right[at], cheap[at]
        share = (np.sum(good & ~easy) + agreement * np.sum(good & easy)) / rows.count
        finite = np.all(np.isfinite(values[at].reshape(rows.count, -1)), -1)
        wrong = int(np.sum(~good))
        verdict = ("pass" if not wrong else "nonfinite" if not np.any(good) and not np.all(finite)
                   else "partial" if np.any(good) else "wrong")
        worst = None
        if wrong and not PART[part]:  # hidden points are not sent back
            far = np.where(good, -1.0, np.where(finite, off_by(known.part(at), values[at]), np.inf))
            i = at.start + int(np.argmax(far))
            worst = Worst({name: tidy(x[i]) for name, x in args.items()}, tidy(values[i]), tidy(known.value[i]),
                          float(min(far.max(), 1e300)))
        message = self.sentence(known.part(at), values[at], good, finite, PART[part]) if wrong else ""
        return Test(f"{task.function}/{rows.name}", "points", task.function, rows.name, self.language, part, most,
                    most * share, most, verdict, rows.count, wrong, worst,
                    message_key="" if not wrong else "points_wrong", message=message,
                    rationale="" if agreement == 1 or not np.any(easy) else
                    f"{int(np.sum(easy))} points that a constant gets right count {agreement:.0%}")

    def sentence(self, known: Truth, values, good, finite, hidden: bool) -> str:
        """How many are wrong, and how; of hidden points without a number that the answer chose: it could be one."""
        wrong = int(np.sum(~good))
        if not np.all(finite):
            return f"{int(np.sum(~finite))} of {len(good)} values are no numbers."
        if wrong == len(values) > 1 and np.all(values == values[0]):
            one = "the same" if hidden else tidy(values[0])
            return f"{wrong} of {len(good)} points are wrong: every answer is {one}."
        factor = misconceptions.factor(known.value[~good], values[~good], hidden)
        return f"{wrong} of {len(good)} points are wrong{factor}."

    # --- properties --------------------------------------------------------------------------------------------------
    def properties(self, part: str, rows: list[Rows], known: Truth, values, agreement: float) -> list[Test]:
        task, found = self.task, []
        regions = [one for one in rows if one.kind == "region"]
        all_of = slice(0, regions[-1].first + regions[-1].count) if regions else slice(0, 0)
        for one in task.properties:
            most = self.worth(one.weight)
            extra = next((row for row in rows if row.kind == {"reciprocity": "swapped"}.get(one.name, one.name)), None)
            if one.name == "reciprocity" and extra is not None:
                base = next(row for row in regions if row.name == extra.name)
                holds = properties.same(values[base.slice], values[extra.slice], known.allowed[base.slice]
                                        + known.allowed[extra.slice])
            elif one.name == "energy" and extra is not None:
                holds = properties.holds_energy(values[extra.slice])
            elif one.name in ("positivity", "bound"):
                high = 1.0 if one.name == "bound" else np.inf
                holds = properties.between(values[all_of], 0.0, high, known.allowed[all_of])
            else:
                continue
            share, wrong = float(np.mean(holds)) * agreement, int(np.sum(~holds))
            verdict = "skipped" if agreement == 0 else "pass" if not wrong and agreement == 1 else (
                "partial" if share > 0 else "wrong")
            message = "" if not wrong else f"{PROPERTIES[one.name].capitalize()}: it does not hold at {wrong} of " \
                                           f"{len(holds)} places."
            found.append(Test(f"{task.function}/{one.name}", "property", task.function, one.name, self.language, part,
                              most, most * share, most, verdict, len(holds), wrong,
                              message_key="property" if wrong else "", message=message,
                              requires=tuple(f"{task.function}/{row.name}" for row in regions[:1]),
                              rationale="" if agreement == 1 else f"counts {agreement:.0%}, as the values agree"))
        return found

    def of_picture(self, part: str) -> Test:
        task, key = self.task, f"{self.task.function}/{part}-picture/{self.language}"
        assert task.picture is not None
        most = self.worth(task.picture.weight)
        values, reply = self.values(key)
        if values is None:
            return self.absent(part, "image", "picture", most, reply)
        return picture.test(task, self.language, part, most, values, self.asked[key].args)

    def of_time(self, part: str) -> Test:
        task, key = self.task, f"{self.task.function}/{part}/{self.language}"
        most = 0.5 * task.points * task.runtime
        reply = self.first.get(key) or Reply(key, None, "ungraded")
        if reply.verdict or reply.values is None:
            return self.absent(part, "runtime", "speed", most, reply)
        values = np.asarray(reply.values, float)
        known, _ = MEMORY.known(task, self.asked[key].args, self.precision(values))
        agreement = float(np.mean(agrees(known, values)))
        limit = task.gross * max(self.times.get(key, np.inf), 1e-3)
        fast = reply.seconds <= limit
        message = "" if fast else f"it takes more than {task.gross:g} times as long as the solution."
        return Test(f"{task.function}/speed", "runtime", task.function, "speed", self.language, part, most,
                    most * fast * agreement, most, "skipped" if not agreement else "pass" if fast else "wrong",
                    message=message,
                    requires=(f"{task.function}/{task.regions[0].name}",))

    # --- misconceptions ----------------------------------------------------------------------------------------------
    def matches(self) -> list[Suspect]:
        """What the wrong answers look like, of all points that were asked in regions."""
        parts = []
        for part in self.parts:
            key = f"{self.task.function}/{part}/{self.language}"
            if key in self.asked and (values := self.values(key)[0]) is not None:
                keep = np.concatenate([np.arange(one.first, one.first + one.count) for one in
                                       layout(self.task, PART[part]) if one.kind == "region"])
                parts.append(({name: x[keep] for name, x in self.asked[key].args.items()}, values[keep]))
        if not parts:
            return []
        args = {name: np.concatenate([one[name] for one, _ in parts]) for name in self.task.arguments}
        values = np.concatenate([v for _, v in parts])
        return misconceptions.suspects(self.task, self.precision(values), args, values)


def tidy(x) -> float | list[float]:
    return np.asarray(x, float).tolist()
