"""`halfway grade`: a folder of submissions against an assignment; marks.csv, and a result.json a student."""

import argparse
import csv
import hashlib
import io
import os
import sys
from collections import Counter
from datetime import datetime
from pathlib import Path

from app import VERSION
from app.console import Tell, progress
from app.grade import intake, late, overrides, work
from app.grade.assignment import Assignment, load
from app.grade.executor import DaskExecutor, Executor, LocalExecutor
from app.grade.level import LEVELS, MEANING
from app.grade.report import everything
from app.grade.report.stored import Results, class_facts, folder_of
from app.grade.report.table import cell
from app.grade.result import SCHEMA
from app.grade.store import Store, as_bytes, durable, key_of
from app.problem import Problem, Usage

ATTEMPTS = 3
NOT_YET = {"verdict": "ungraded", "why": "not graded yet", "tests": []}
COLUMNS = ("student", "points", "max_points", "status")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("assignment", metavar="ASSIGNMENT", nargs="?", help="its name, or its TOML file")
    parser.add_argument("submissions", metavar="SUBMISSIONS", nargs="?",
                        help="a folder of files, folders, zip or tar archives")
    parser.add_argument("-o", "--output", metavar="RESULTS", help="the folder for marks.csv and the reports")
    parser.add_argument("--jobs", metavar="N", type=int, default=0, help="submissions at a time; one a processor core")
    parser.add_argument("--scheduler", metavar="ADDRESS", default="", help="a Dask cluster: tcp://HOST:8786")
    parser.add_argument("--seed", metavar="S", default="", help="of the hidden points; else a secret of its own")
    parser.add_argument("--handed-in", metavar="FILE.csv", default="", help="student,time: for the late rule")
    parser.add_argument("--report", metavar="RESULTS", help="the reports again, from results that stand")
    parser.add_argument("--resume", action="store_true", help="go on in RESULTS: what is graded stays")
    parser.add_argument("--level", metavar="L1", default="", help=f"of isolation, not the highest: {', '.join(LEVELS)}")


def run(options: argparse.Namespace) -> int:
    if options.report:
        return report(Path(options.report).expanduser())
    if not (options.assignment and options.submissions and options.output):
        raise Usage("name what is graded and where to: halfway grade ASSIGNMENT SUBMISSIONS -o RESULTS.")
    assignment = load(options.assignment)
    if options.level and options.level not in LEVELS:
        raise Usage(f"there is no level {options.level}; there are {', '.join(LEVELS)}.")
    if options.jobs < 0:
        raise Usage(f"--jobs {options.jobs}: at least one submission at a time.")
    work.timed_texts(assignment)
    handed_in = intake.students(options.submissions)
    times = late.read(options.handed_in, assignment, handed_in)
    results = Path(options.output).expanduser()
    executor: Executor = DaskExecutor(options.scheduler) if options.scheduler else LocalExecutor(
        options.jobs or cores())
    try:
        machine = the_machine(executor, options.level)
        store = Store(results, options.resume, options.seed)
        try:
            return Class(assignment, handed_in, executor, store, machine, results, options.level, times).grade()
        finally:
            store.close()
    finally:
        executor.close()


def report(results: Path) -> int:
    everything.write(Results(results))
    print(f"The reports are in {results}: index.html for the class, students/NAME/report.html for each.")
    return 0


def cores() -> int:
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def the_machine(executor: Executor, named: str) -> dict:
    """What the workers are, found by their own self-test; below L2 only by name."""
    executor.submit(work.described, {"named": named})
    _, facts = next(executor.as_completed())
    if facts is None:
        raise Problem("no worker could say what it is; is the cluster running?")
    if "error" in facts:
        raise Problem(facts["error"])
    if not facts["safe"] and not named:
        raise Problem(f"submissions are isolated at {facts['level']} only here ({MEANING[facts['level']]}), because "
                      f"{facts['why']}. For texts you trust, say --level {facts['level']}.")
    return facts


class Class:
    """All submissions of one run."""

    def __init__(self, assignment: Assignment, handed_in: dict[str, list[Path]], executor: Executor, store: Store,
                 machine: dict, results: Path, named: str, times: dict[str, datetime]) -> None:
        self.assignment, self.handed_in, self.executor, self.store = assignment, handed_in, executor, store
        self.machine, self.results, self.named = machine, results, named
        self.by_hand, self.times = overrides.read(results), times
        self.keys: dict[str, str] = {}
        self.facts: dict[str, dict] = {}  # student -> the submission's part of result.json
        self.bodies: dict[str, dict] = {}
        self.students: Counter[str] = Counter()  # how many handed in the text of a key
        self.counts = {"passed": 0, "failed": 0, "ungraded": 0}

    def grade(self) -> int:
        jobs: dict[str, dict] = {}
        for student, entries in self.handed_in.items():
            job = self.job(student, entries)
            self.keys[student] = job["key"]
            jobs.setdefault(job["key"], job)
        self.students = Counter(self.keys.values())
        for key, job in jobs.items():
            body = self.store.get(key)
            if body is None:
                self.executor.submit(work.grade, job)
            else:
                self.know(key, body)
        with progress(len(jobs)) as tell:
            tell(len(self.bodies), self.words())
            try:
                self.collect(work.grade, tell)
            except KeyboardInterrupt:
                self.executor.cancel()
                print("halfway: what is running is brought to its end; --resume goes on from there.", file=sys.stderr)
                self.collect(None, tell)
                self.write()
                raise
        self.write()
        everything.write(Results(self.results))
        self.tell()
        return 1 if self.counts["ungraded"] else 0

    def job(self, student: str, entries: list[Path]) -> dict:
        submission = intake.read(student, entries)
        self.facts[student] = {"hash": submission.hash, "student_id": student, "files": [
            {"name": name, "bytes": len(data), "sha256": hashlib.sha256(data).hexdigest()}
            for name, data in sorted(submission.files.items())]}
        same = {"hash": submission.hash, "digest": self.assignment.digest, "level": self.machine["level"],
                "fingerprint": self.machine["fingerprint"], "seed": self.store.seed}
        return {"key": key_of(**same, grader=VERSION), "student": student, "named": self.named, **same,
                "entries": [str(entry.resolve()) for entry in entries], "assignment": str(self.assignment.file)}

    def collect(self, again, tell: Tell) -> None:
        """Results as they come; what could not be graded is tried again, twice."""
        for job, answer in self.executor.as_completed():
            body = answer["body"] if answer else {"verdict": "ungraded", "why": "the worker was lost", "tests": []}
            tried = job.get("tried", 0) + 1
            self.store.put(job["key"], body, {"attempt": tried, **(answer["side"] if answer else {})})
            if body["verdict"] == "ungraded" and tried < ATTEMPTS and again:
                self.executor.submit(again, {**job, "tried": tried})
                continue
            self.know(job["key"], body)
            tell(len(self.bodies), self.words())

    def know(self, key: str, body: dict) -> None:
        """Counted are students, not texts: the same text may have been handed in twice."""
        self.bodies[key] = body
        self.counts[{"pass": "passed", "ungraded": "ungraded"}.get(body["verdict"], "failed")] += self.students[key]

    def words(self) -> str:
        return ", ".join(f"{count} {name}" for name, count in self.counts.items())

    def write(self) -> None:
        """marks.csv and every result.json, from what is known; the same bytes whatever way it became known."""
        blank: dict = {"schema": SCHEMA, "assignment": {"id": self.assignment.id, "hash": self.assignment.digest},
                       "score": None, "max": self.assignment.points, "visible_score": None, "visible_max": None,
                       "misconceptions": [], "curves": []}
        bodies = {student: blank | late.applied(self.bodies.get(key, NOT_YET), self.assignment, self.times.get(student))
                  for student, key in self.keys.items()}
        sharing: dict[str, list[str]] = {}
        for student, key in self.keys.items():
            sharing.setdefault(key, []).append(student)
        grader = {"version": VERSION, **{name: self.machine[name] for name in ("fingerprint", "level", "renderer")},
                  "unsandboxed": not self.machine["safe"], "self_test": self.machine["self_test"]}
        seed = hashlib.sha256(self.store.seed.encode()).hexdigest()[:16]
        for student, body in bodies.items():
            whole = {**body, "submission": self.facts[student], "grader": grader,
                     "seed": {"public": "public", "hidden_hash": seed},
                     "overrides": [self.by_hand[student]] if student in self.by_hand else [],
                     "same_as": [other for other in sorted(sharing[self.keys[student]]) if other != student]}
            durable(self.results / "students" / folder_of(student) / "result.json", as_bytes(whole))
        durable(self.results / "class.json", as_bytes(class_facts(self.assignment, grader, bodies)))
        durable(self.results / "marks.csv", marks(bodies, self.assignment.points, self.by_hand))

    def tell(self) -> None:
        level = self.machine["level"]
        print(f"{len(self.keys)} submissions: {self.words()}. Isolation {level}: {MEANING[level]}."
              + ("" if self.machine["safe"] else " UNSANDBOXED."))
        if self.assignment.due and not self.times:
            print("Nobody counts as late: when each handed in is said by --handed-in FILE.csv.")
        print(f"Marks are in {self.results / 'marks.csv'}, the class in {self.results / 'index.html'}, each student's "
              f"report below {self.results / 'students'}.")


def marks(bodies: dict[str, dict], most: float, by_hand: dict[str, dict]) -> bytes:
    """RFC 4180, and no cell that a spreadsheet would take for a formula."""
    out = io.StringIO()
    table = csv.writer(out, lineterminator="\r\n")
    table.writerow(COLUMNS)
    for student in sorted(bodies):
        body = bodies[student]
        if student in by_hand:
            body = {"score": by_hand[student]["points"], "verdict": "override"}
        score = "" if body.get("score") is None else f"{body['score']:.6g}"
        table.writerow([cell(student), score, f"{most:.6g}", body["verdict"]])
    return out.getvalue().encode()
