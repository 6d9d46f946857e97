"""Questions to a student's text, and the replies: the only way from a submission to numbers.

A fresh process for each language answers every question twice, in two orders, shuffled among repeated points. If it
dies, each function is asked again in a process of its own, so that a crash costs only its own points. Our own failure
is `ungraded`. No right answer, tolerance, weight or seed ever leaves this side.
"""

import hashlib
from dataclasses import dataclass

import numpy as np

from app.grade import glsl_text, level, plain
from app.grade.answers import Answer, Call, Ending, Ours
from app.grade.conversation import converse
from app.grade.intake import Submission
from app.grade.question import FILES, Language, Question, Reply
from app.grade.sandbox import LAYERS, Limits

SECOND = 4096  # points asked again at most
REPEATED = 32  # points that stand twice in the first order
WORKER = {"python": ("worker_python", "<f8"), "glsl": ("worker_glsl", "<f4")}


@dataclass(frozen=True)
class Order:
    """Which rows of a question are sent in its two calls: `first` has every row, some twice; `second` some again."""

    first: np.ndarray
    second: np.ndarray


def answer(submission: Submission, questions: list[Question], limits: Limits | None = None,
           granted: str = "") -> list[Reply]:
    """A reply to each question, in their order; `granted` is the level to run at, else what the self-test found."""
    limits = limits or Limits()
    if submission.refused:
        return [Reply(q.id, verdict="rejected", said=submission.refused) for q in questions]
    replies: dict[str, Reply] = {}
    for language in FILES:
        asked = [q for q in questions if q.language == language]
        if asked:
            replies |= {reply.id: reply for reply in in_language(submission, language, asked, limits, granted)}
    return [replies[q.id] for q in questions]


def in_language(submission: Submission, language: Language, questions: list[Question], limits: Limits,
                granted: str) -> list[Reply]:
    name = FILES[language]
    if name not in submission.files:
        return [Reply(q.id, verdict="missing", said=f"there is no {name}") for q in questions]
    if name in submission.faults:
        return [Reply(q.id, verdict="rejected", said=submission.faults[name]) for q in questions]
    text = submission.texts[name]
    if not text.strip():
        return [Reply(q.id, verdict="missing", said=f"{name} is empty") for q in questions]
    refused: dict[str, Reply] = {}
    if language == "glsl":
        word, said = glsl_text.fault(text)
        if word:
            return [Reply(q.id, verdict=word, said=said) for q in questions]
        for q in questions:
            word, said = glsl_text.signature_fault(text, q)
            if word:
                refused[q.id] = Reply(q.id, verdict=word, said=said)
        text = glsl_text.plain(text)
    asked = [q for q in questions if q.id not in refused]
    layers = LAYERS[granted or level.found().name]
    try:
        got = Asking(submission.hash, language, text, asked, limits, layers).replies() if asked else {}
    except Ours as ours:
        got = {q.id: Reply(q.id, verdict="ungraded", said=str(ours)) for q in asked}
    return [refused.get(q.id) or got[q.id] for q in questions]


class Asking:
    """One text and its questions: the process for all of them, and one for each function where that died."""

    def __init__(self, key: str, language: Language, text: str, questions: list[Question], limits: Limits,
                 layers: tuple[str, ...]) -> None:
        self.language, self.text, self.questions, self.limits, self.layers = language, text, questions, limits, layers
        self.random = np.random.default_rng(int(hashlib.sha256(f"{key} {language}".encode()).hexdigest()[:16], 16))
        self.spent = 0.0

    def replies(self) -> dict[str, Reply]:
        found, ending = self.ask(self.questions)
        if not ending.word:
            return found
        functions = list(dict.fromkeys(q.function for q in self.questions))
        if not ending.loaded or len(functions) == 1:
            return {q.id: found.get(q.id) or lost(q, ending) for q in self.questions}
        for function in functions:
            rest = [q for q in self.questions if q.function == function and q.id not in found]
            if not rest:
                continue
            if self.spent > self.limits.total * self.limits.cpu:
                found |= {q.id: Reply(q.id, verdict="timeout_cpu", said="the time for the whole submission is used up")
                          for q in rest}
                continue
            again, ending = self.ask(rest)
            found |= {q.id: again.get(q.id) or lost(q, ending) for q in rest}
        return found

    def ask(self, questions: list[Question]) -> tuple[dict[str, Reply], Ending]:
        """What one process answered in full, twice."""
        orders = {q.id: self.order(q) for q in questions}
        plan = [(questions[i], half) for half in (0, 1) for i in self.random.permutation(len(questions))]
        rows = [(orders[q.id].first, orders[q.id].second)[half] for q, half in plan]
        worker, dtype = WORKER[self.language]
        calls = [Call(q.function, tuple(np.asarray(a)[r] for a in q.args.values()), q.width)
                 for (q, _), r in zip(plan, rows, strict=True)]
        if plain.NEEDED:
            ending = plain.converse(worker, self.text, calls, self.limits, dtype)
        else:
            ending = converse(worker, self.text, calls, self.layers, self.limits, dtype)
        self.spent += max(ending.cpu, ending.wall / self.limits.wall)
        halves: dict[str, list[Answer]] = {}
        for (q, _), got in zip(plan, ending.answers, strict=False):
            halves.setdefault(q.id, []).append(got)
        return {q.id: together(q, orders[q.id], *halves[q.id]) for q in questions
                if len(halves.get(q.id, ())) == 2 or (q.id in halves and halves[q.id][0].values is None)}, ending

    def order(self, question: Question) -> Order:
        count = question.count
        again = self.random.integers(0, count, min(REPEATED, 1 + count // 4))
        first = np.concatenate([np.arange(count), again])
        self.random.shuffle(first)
        return Order(first, self.random.permutation(count)[:max(1, min(SECOND, (count + 1) // 2))])


def lost(question: Question, ending: Ending) -> Reply:
    return Reply(question.id, verdict=ending.word, said=ending.said)


def together(question: Question, order: Order, first: Answer, second: Answer | None = None) -> Reply:
    """The values in the order of the question, if the same point always got the same answer."""
    seconds = first.seconds
    for got in (first, second):
        if got is not None and got.values is None:
            return Reply(question.id, verdict=got.word, said=got.said, seconds=seconds)
    assert first.values is not None and second is not None and second.values is not None
    values = np.empty((question.count, *first.values.shape[1:]))
    values[order.first] = first.values
    if not (alike(values[order.first], first.values) and alike(values[order.second], second.values)):
        return Reply(question.id, verdict="wrong", seconds=seconds,
                     said="asked twice for the same point it gave two answers: it keeps a state, uses chance, "
                          "or lets one point depend on the others")
    return Reply(question.id, values, seconds=seconds)


def alike(a: np.ndarray, b: np.ndarray) -> bool:
    """The same but for rounding, which may differ between the lanes of a vector unit and grow in bad forms."""
    with np.errstate(all="ignore"):
        scale = float(np.max(np.abs(a), where=np.isfinite(a), initial=0.0))
        near = np.abs(a - b) <= 1e-3 * np.maximum(np.abs(a), np.abs(b)) + 1e-9 * scale
    return bool(np.all(near | (a == b) | (np.isnan(a) & np.isnan(b))))


