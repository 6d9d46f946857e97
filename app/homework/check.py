"""`halfway check FILE`: the visible checks of one's own answer, in seconds, with what to look at."""

import argparse
import json
import re
import textwrap
from pathlib import Path

from app.grade.assignment import Assignment, assignments, load
from app.grade.live import Finding, findings
from app.grade.question import Language
from app.grade.report.words import numbers, spoken
from app.grade.result import Test, plain
from app.homework.plot import drawn
from app.problem import Problem, Usage

LANGUAGE: dict[str, Language] = {".py": "python", ".glsl": "glsl"}
MARK = re.compile(r"halfway homework: *([\w./-]+)")
LARGEST = 1 << 20


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", metavar="FILE", help="your answer: a .py or a .glsl file")
    parser.add_argument("--assignment", metavar="NAME", default="", help="where the file itself does not say it")
    parser.add_argument("--json", action="store_true", help="print it as JSON")
    parser.add_argument("-o", "--output", metavar="FILE.png", help="the picture: right, yours, the error, FLIP")


def run(options: argparse.Namespace) -> int:
    path = Path(options.file).expanduser()
    language = LANGUAGE.get(path.suffix)
    if language is None:
        raise Usage(f"{path} is neither a .py nor a .glsl file; an answer is one of them.")
    if not path.is_file():
        raise Usage(f"there is no file {path}.")
    if path.stat().st_size > LARGEST:
        raise Usage(f"{path} has more than a megabyte; an answer is a short text.")
    try:
        text = path.read_bytes().decode("utf-8-sig").replace("\r\n", "\n")
    except UnicodeDecodeError as error:
        raise Problem(f"{path}, byte {error.start}: it is not UTF-8; save it as UTF-8.") from None
    assignment = asked_by(path, text, options.assignment)
    if language not in assignment.languages:
        raise Usage(f"{assignment.id} is answered in {' or '.join(assignment.languages)}, not in {language}.")
    found = findings(assignment, language, text)
    if options.output:
        save_picture(found, options.output)
    if options.json:
        print(json.dumps([as_json(one) for one in found], indent=1, ensure_ascii=False, allow_nan=False))
    else:
        print("\n".join(report(assignment, language, found)))
    return 0 if all(one.ok for one in found) else 1


def asked_by(path: Path, text: str, named: str) -> Assignment:
    """The assignment that a file answers: named, or as its first lines say, or as its folder is called."""
    mark = MARK.search("\n".join(text.splitlines()[:5]))
    name = named or (mark[1] if mark else path.resolve().parent.name)
    if not named and not mark and name not in assignments():
        raise Usage(f"{path} does not say which assignment it answers; write --assignment NAME, of: "
                    f"{', '.join(assignments())}.")
    return load(name)


def report(assignment: Assignment, language: str, found: list[Finding]) -> list[str]:
    lines = [f"{assignment.title} · {language} · the visible points", ""]
    for one in found:
        score, most = (sum(getattr(test, key) for test in one.tests) for key in ("score", "max"))
        lines.append(f"{'✓' if one.ok else '✗'} {one.task.function:26s}{score:6.2f} of {most:.2f} points")
        if not one.ok:
            lines += ["", *(f"    {line}" for line in wrong(one)), ""]
    score, most = (sum(getattr(test, key) for one in found for test in one.tests) for key in ("score", "max"))
    return [*lines, "", f"{score:.2f} of {most:.2f} visible points; {assignment.points:g} with the hidden ones."]


def wrong(one: Finding) -> list[str]:
    """Why a function is not right: what was asked, where it is wrong, a plot, and what it looks like."""
    lines = wrapped("Asked: " + one.task.text)
    if one.task.slide:
        lines.append(f"Slide: {one.task.slide}")
    if one.said:
        return [*lines, "", *wrapped(one.said)]
    lines.append("")
    for test in one.tests:
        if test.verdict != "pass" and test.message:
            lines += wrapped(f"{test.region}: {test.message}")
    if one.worst and one.worst.worst:
        lines += ["", *worst(one.worst)]
    if one.plot:
        lines += ["", *drawn(one.plot)]
    for suspect in one.suspects:
        lines += ["", *wrapped(f"It looks like {suspect.id}: {suspect.message}")]
    return lines


def worst(test: Test) -> list[str]:
    """The point that lies off farthest, in units of the screen."""
    assert test.worst is not None
    at = ", ".join(f"{name} = {spoken(name, value)}" for name, value in test.worst.args.items())
    return [*wrapped(f"The worst point ({test.region}): {at}"),
            f"expected  {numbers(test.worst.expected)}", f"got       {numbers(test.worst.got)}"]


def wrapped(text: str) -> list[str]:
    return textwrap.wrap(text, 92, subsequent_indent="  ") or [""]


def as_json(one: Finding) -> dict:
    from dataclasses import asdict

    return {"function": one.task.function, "language": one.language, "ok": one.ok, "said": one.said,
            "asked": one.task.text, "slide": one.task.slide,
            "checks": [{"region": test.region, "verdict": test.verdict, "points": test.points, "wrong": test.wrong,
                        "score": test.score, "max": test.max, "message": test.message,
                        "worst": plain(asdict(test.worst)) if test.worst else None} for test in one.tests],
            "misconceptions": [asdict(suspect) for suspect in one.suspects]}


def save_picture(found: list[Finding], output: str) -> None:
    import io

    import numpy as np
    from PIL import Image

    from app.export.target import picture_path, write

    figures = [figure for one in found for test in one.tests for figure in test.figures]
    path = picture_path(output)
    if not figures:
        asked = any(one.task.picture for one in found)
        raise Problem(f"there is no picture to write: {'it is right' if asked else 'this assignment draws none'}.")
    strip = np.concatenate([np.pad(figure.pixels, ((8, 8), (8, 8), (0, 0)), constant_values=40)
                            for figure in figures], 1)
    out = io.BytesIO()
    Image.fromarray(strip.repeat(3, 0).repeat(3, 1)).save(out, "PNG")
    write(path, out.getvalue())
    print(f"{path}: {', '.join(figure.label for figure in figures)}, from left to right.")
