"""One submission graded: the task that a thread here or a worker of a cluster does. Paths and hashes in, a dict out."""

import base64
import hashlib
import io
import os
import platform
import socket
import statistics
import time
from functools import lru_cache
from pathlib import Path

import numpy as np

from app import VERSION
from app.grade import assignment as assignments
from app.grade import intake, level, live, questions, sweep, texts
from app.grade.discretion import answered
from app.grade.judge import judge
from app.grade.question import FILES, Language, Question
from app.grade.result import Result, line, plain
from app.grade.sandbox import Limits
from app.grade.supervisor import answer
from app.problem import Problem


def machine(named: str = "") -> dict:
    """What a worker is: the level that holds there and everything else that could change a number."""
    here = level.asked(named) if named else level.found()
    facts = [here.renderer, np.__version__, platform.python_version(), platform.machine(), processor()]
    return {"level": here.name, "why": here.why, "safe": here.safe, "self_test": here.tested, "renderer": here.renderer,
            "fingerprint": hashlib.sha256("\n".join(facts).encode()).hexdigest()[:16], "host": socket.gethostname()}


def processor() -> str:
    try:
        words = Path("/proc/cpuinfo").read_text("utf-8")
        return next(line.partition(":")[2].strip() for line in words.splitlines() if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor()


@lru_cache(2)
def asked(path: str, digest: str, seed: str) -> tuple[assignments.Assignment, list[Question]]:
    """The assignment and all its questions; the same for every student."""
    found = assignments.load(path)
    if found.digest != digest:
        raise Problem(f"{path} is another file here than where the grading was started.")
    return found, questions.questions(found) + questions.questions(found, seed, hidden=True)


def timed_texts(assignment: assignments.Assignment) -> dict[Language, str]:
    """The solutions of the tasks that pay for speed; a Problem where there is none."""
    tasks = [task for task in assignment.tasks if task.runtime]
    return {language: texts.joined([(task.function, texts.solution(task, language)) for task in tasks], language)
            for language in FILES if tasks and language in assignment.languages}


@lru_cache(2)
def times(path: str, digest: str, seed: str, granted: str) -> dict[str, float]:
    """Question -> processor seconds of the solution on this machine, in the same sandbox: the median of five."""
    assignment, all_of = asked(path, digest, seed)
    paid = {task.function for task in assignment.tasks if task.runtime}
    found: dict[str, list[float]] = {}
    for language, text in timed_texts(assignment).items():
        solution = intake.Submission("the solution", {FILES[language]: text.encode()})
        some = [one for one in all_of if one.language == language and one.function in paid]
        for _ in range(5):
            for reply in answer(solution, some, granted=granted):
                if not reply.verdict:
                    found.setdefault(reply.id, []).append(reply.seconds)
    return {key: statistics.median(seconds) for key, seconds in found.items()}


@lru_cache(1)
def here(named: str) -> dict:
    return machine(named)


def grade(job: dict) -> dict:
    """key, the graded part of result.json, and beside it what may differ from run to run. Never an exception."""
    started = time.time()
    spent = os.times()
    facts: dict = {"level": job["level"]}
    try:
        facts = here(job["named"])
        if facts["fingerprint"] != job["fingerprint"] or facts["level"] != job["level"]:
            raise Problem("this machine is not like the one where the grading began; its numbers could differ.")
        submission = intake.read(job["student"], [Path(entry) for entry in job["entries"]])
        if submission.hash != job["hash"]:
            raise Problem("the submission is another one here than where the grading was started.")
        found, all_of = asked(job["assignment"], job["digest"], job["seed"])
        limits = Limits(cpu=max(1, round(found.seconds)))
        solution = times(job["assignment"], job["digest"], job["seed"], job["level"])
        result = judge(found, all_of, answered(submission, all_of, limits, job["level"]), solution)
        shown = live.with_plots(live.by_function(found, result), submission, limits, job["level"])
        body = as_json(result) | {"curves": [curve(one.task.function, one.plot) for one in shown if one.plot]}
    except Exception as error:  # ours, whatever it is: the student loses nothing by it
        body = {"verdict": "ungraded", "score": None, "tests": [], "why": f"{type(error).__name__}: {error}"[:500]}
    now = os.times()
    return {"key": job["key"], "body": body, "side": {
        "student": job["student"], "started": started, "seconds": round(time.time() - started, 3),
        "own_cpu": round(now.user + now.system - spent.user - spent.system, 3),
        "host": facts.get("host", socket.gethostname()), "grader": VERSION}}


def as_json(result: Result) -> dict:
    found = result.as_json()
    found["tests"] = [line(test) | {"figures": [
        {"label": figure.label, "png": png(figure.pixels)} for figure in test.figures]} for test in result.tests]
    if result.verdict == "ungraded":  # no number that somebody could take for a mark
        found["score"] = found["visible_score"] = None
    return found


def curve(function: str, plot: sweep.Sweep) -> dict:
    """Through a function's worst visible point, to the digits that a picture of it shows."""
    def rough(values: np.ndarray) -> list:
        return plain([float(f"{value:.5g}") for value in np.asarray(values, float)])

    return {"function": function, "label": plot.label, "log": plot.log, "here": plain(float(plot.here)),
            "at": rough(plot.at), "expected": rough(plot.expected), "got": rough(plot.got)}


def png(pixels: np.ndarray) -> str:
    from PIL import Image

    out = io.BytesIO()
    Image.fromarray(np.ascontiguousarray(pixels, np.uint8)).save(out, "PNG")
    return base64.b64encode(out.getvalue()).decode()


def stand_in(job: dict) -> dict:
    """As cheap as a task can be, for trying the scheduling of many."""
    return {"key": job["key"], "body": {"verdict": "pass", "score": 1.0, "max": 1.0, "tests": []}, "side": {}}


def described(job: dict) -> dict:
    """`machine`, as a task."""
    try:
        return machine(job["named"])
    except Problem as problem:
        return {"error": str(problem)}
