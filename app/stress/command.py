"""`halfway stress [FUNCTION ...]`: every twin over its extremes, every scene over the corners of its sliders."""

import argparse
import json
import sys
from collections.abc import Callable, Iterable
from typing import Any

from app.catalog import steps
from app.console import progress
from app.optics import names
from app.problem import Usage, near
from app.stress.judge import Finding, judged
from app.stress.scenes import Played, played
from app.stress.words import as_data, told

INTERRUPTED = 130


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("functions", metavar="FUNCTION", nargs="*",
                        help="functions of the course (d_beckmann); without one, all of them and all scenes")
    parser.add_argument("--scenes", action="store_true", help="the scenes alone")
    parser.add_argument("-o", "--output", metavar="DIR", help="a page (index.html) with heat maps, and PNGs, to here")
    parser.add_argument("--json", action="store_true", help="print it as JSON")


def run(options: argparse.Namespace) -> int:
    """The code is 1 where a stable form or a scene fails; what a naive form loses is told."""
    if options.scenes and options.functions:
        raise Usage(f"--scenes tries the scenes alone; leave it out, or leave out {options.functions[0]}.")
    known = names()
    for name in options.functions:
        if name not in known:
            raise Usage(f"there is no function {name}.{near(name, known)}")
    folder = None
    if options.output:
        from app.export.target import make_folder

        folder = make_folder(options.output)
    wanted = () if options.scenes else tuple(dict.fromkeys(options.functions)) or tuple(sorted(known))
    findings: list[Finding] = []
    scenes: list[Played] = []
    code = tried(wanted, judged, findings, str)
    if not code and not options.functions:
        code = tried([found.id for found in steps()], played, scenes, str)
    print(json.dumps(as_data(findings, scenes), indent=1, ensure_ascii=False, allow_nan=False) if options.json
          else told(findings, scenes, bool(options.functions)))
    if folder is not None:
        from app.stress.report import save

        print(save(findings, scenes, folder), file=sys.stderr)
    return code or int(any(one.fails for one in findings) or any(one.faults for one in scenes))


def tried(subjects: Iterable, test: Callable, results: list, name: Callable[[Any], str]) -> int:
    """Each subject tested, with a bar on a terminal; an interruption keeps what is done."""
    todo = list(subjects)
    try:
        with progress(len(todo)) as tell:
            for subject in todo:
                tell(len(results), name(subject))
                results.append(test(subject))
    except KeyboardInterrupt:
        print(f"halfway: interrupted after {len(results)} of {len(todo)}; what is done is told.", file=sys.stderr)
        return INTERRUPTED
    return 0
