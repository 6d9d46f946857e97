"""`halfway study [TOPIC ...]`: what a digit costs, by every method, on this machine."""

import argparse
import json
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from importlib import import_module
from time import perf_counter
from typing import TYPE_CHECKING

from app.catalog import LoadedStep, steps
from app.console import progress
from app.lesson import Study
from app.problem import Problem, Usage, near
from app.study.measure import cases, measure
from app.study.record import Record

if TYPE_CHECKING:
    from app.study.report import Report

BUDGET, LEAST_BUDGET = 100.0, 2.0  # s
STARTING, ENDING = 1.2, 1.2  # s before the first line of this runs, and for the page
INTERRUPTED = 130


@dataclass(frozen=True, eq=False)
class Job:
    found: LoadedStep
    study: Study
    case: str
    values: dict
    where: str = "CPU"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("topics", metavar="TOPIC", nargs="*",
                        help="chapters, steps, or words of a study's title (albedo, irradiance); all without one")
    parser.add_argument("-o", "--output", metavar="DIR", help="a page (index.html), PNG plots and study.json, to here")
    parser.add_argument("--budget", metavar="SECONDS", type=float, default=BUDGET,
                        help=f"the time it may take in all; {BUDGET:.0f}")
    parser.add_argument("--json", action="store_true", help="print every point as JSON")


def run(options: argparse.Namespace) -> int:
    begin = perf_counter() - STARTING
    if not options.budget >= LEAST_BUDGET:
        raise Usage(f"--budget {options.budget:g}: a study needs at least {LEAST_BUDGET:g} seconds.")
    chosen = list(jobs(options.topics))
    report = None
    if options.output:
        from app.export.target import make_folder
        from app.study.report import Report

        report = Report(make_folder(options.output))
    from app.study.machine import machine

    done, problems, code = measured(chosen, begin + options.budget - ENDING, report)
    ran = machine(any(record.where != "CPU" for _, record in done))
    tell([record for _, record in done], ran, options.json)
    for problem in problems:
        print(f"halfway: {problem}", file=sys.stderr)
    if report is not None and done:
        print(report.save(ran, text([record for _, record in done], ran)), file=sys.stderr)
    return code or (1 if problems else 0)


def jobs(topics: list[str]) -> Iterator[Job]:
    """What is to be measured, in the order of the course."""
    studied = [(found, study) for found in steps() for study in found.step.studies]
    wanted: set[tuple[str, str]] = set()
    for topic in topics:
        here = {(found.id, study.title) for found, study in studied if topic in (found.id, found.loaded.id,
                found.step.name) or topic.lower() in study.title.lower()}
        if not here:
            known = {word for found, _ in studied for word in (found.id, found.loaded.id)}
            raise Usage(f"there is no study of {topic}.{near(topic, known)}")
        wanted |= here
    for found, study in studied:
        if topics and (found.id, study.title) not in wanted:
            continue
        base = {name: spec.default for name, spec in found.values.items()}
        named = {name: spec.choices for name, spec in found.values.items() if spec.choices}
        for case, given in cases(study, named):
            values = base | given
            if found.step.scene.tables:
                from app import tables

                values |= tables.chosen(found.step.scene, values)
            yield Job(found, study, case, values)
        if study.pixels:
            case, given = next(cases(study, named))
            yield Job(found, study, case, base | given, "GPU")


def measured(chosen: list[Job], end: float, report: "Report | None" = None
             ) -> tuple[list[tuple[Study, Record]], list[Problem], int]:
    """Each job with its share of what time is left; an interruption keeps what is done."""
    warm()

    done: list[tuple[Study, Record]] = []
    beyond = 0.3 if report else 0.0  # s that a job takes beyond its share: first rungs that are dear, pictures
    problems: list[Problem] = []
    try:
        with progress(len(chosen)) as tell:
            for i, job in enumerate(chosen):
                words = ", ".join(filter(None, (job.found.id, job.case, "" if job.where == "CPU" else job.where)))
                tell(i, words)
                start = perf_counter()
                left = end - start
                if i and left <= beyond:
                    skipped = len(chosen) - i
                    problems.append(Problem(f"the budget was up before {skipped} of {len(chosen)} studies began, from "
                                            f"{words} on; name topics, or give more with --budget."))
                    break
                share = max(left / (len(chosen) - i) - beyond, 0.0)
                try:
                    record = record_of(job, share)
                except Problem as problem:
                    problems.append(problem)
                    continue
                if report:
                    report.add(job.study, record)
                beyond = 0.5 * (beyond + max(perf_counter() - start - share, 0.0))
                done.append((job.study, record))
    except KeyboardInterrupt:
        problems.append(Problem(f"interrupted: {len(done)} of {len(chosen)} studies are done, and kept."))
        return done, problems, INTERRUPTED
    return done, problems, 0


def warm() -> None:
    """Load scipy first: the second that takes belongs to no method."""
    for name in ("integrate", "special", "stats.qmc"):
        import_module(f"scipy.{name}")


def record_of(job: Job, budget: float) -> Record:
    if job.where == "CPU":
        return measure(job.study, job.values, budget, step=job.found.id, case=job.case)
    from app.study.pixels import measure_pixels

    return measure_pixels(job.study, job.values, budget, step=job.found.id, case=job.case)


def tell(records: list[Record], machine: dict, as_json: bool) -> None:
    from app.study.table import table, width

    if as_json:
        print(text(records, machine))
    else:
        print("\n\n".join(table(record, width()) for record in records))


def text(records: list[Record], machine: dict) -> str:
    from app.study.table import as_data

    whole = {"machine": machine, "studies": [as_data(record) for record in records]}
    return json.dumps(whole, indent=1, ensure_ascii=False, allow_nan=False)
