"""`halfway board MODEL|FILE.brdf ...`: what a model reflects, judged; `--json` for programs."""

import argparse
import json
import math
import sys
from pathlib import Path

from app.badges import NAMES, Badge
from app.board import course_model
from app.board.brdf_file import Parameter, read
from app.board.brdf_model import BrdfModel
from app.board.course_model import CourseModel
from app.problem import Usage, near

JUDGED = tuple(name for name in NAMES if name != "linear")  # a BRDF is linear by what it is


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("models", metavar="MODEL|FILE.brdf", nargs="*",
                        help="models of the course (cook_torrance, oren_nayar ...) or files of the BRDF explorer")
    parser.add_argument("--json", action="store_true", help="print it as JSON")


def run(options: argparse.Namespace) -> int:
    """1 when no model could be read at all; a file that cannot be read is told, and the others go on."""
    if not options.models:
        raise Usage(f"halfway board wants a model or a file; models are {', '.join(course_model.names())}.")
    found = [facts(opened(word)) for word in options.models]
    if options.json:
        whole = found[0] if len(found) == 1 else found
        print(json.dumps(whole, indent=1, ensure_ascii=False, allow_nan=False))
    else:
        print("\n\n".join(words(one) for one in found))
    for warning in (w for one in found for w in one.get("warnings", ())):
        print(f"halfway: {warning}", file=sys.stderr)
    return 0


def opened(word: str) -> BrdfModel | CourseModel:
    if word.endswith(".brdf") or Path(word).is_file():
        return BrdfModel(read(word))
    name = word.removeprefix(course_model.PREFIX)
    if name not in course_model.names():
        raise Usage(f"there is no model {word}, and no such file.{near(name, course_model.names())}")
    return CourseModel(name)


def facts(model: BrdfModel | CourseModel) -> dict:
    """What `--json` prints of one model; angles are in degrees."""
    warnings = list(model.file.warnings) if isinstance(model, BrdfModel) else []
    badges = model.badges()
    return {"name": model.name, "parameters": [parameter(p) for p in model.parameters],
            "badges": {name: judged(badges[name]) for name in JUDGED},
            **({"warnings": warnings} if warnings else {})}


def parameter(p: Parameter) -> dict:
    return {"name": p.name, "type": p.type, "min": p.low, "max": p.high, "default": p.default}


def judged(badge: Badge) -> dict:
    return {"ok": badge.ok, "worst": badge.worst, "at": {k: math.degrees(v) for k, v in badge.at.items()}}


def words(found: dict) -> str:
    """The same for a person."""
    lines = [found["name"], *(f"  {p['name']:16s}{p['min']:g} to {p['max']:g}, at {shown(p['default'])}"
                              for p in found["parameters"])]
    for name, badge in found["badges"].items():
        at = ", ".join(f"{k} {v:.4g}°" for k, v in badge["at"].items())
        worst = "not finite" if badge["worst"] is None else f"{badge['worst']:.4g}"
        lines.append(f"  {'good' if badge['ok'] else 'BAD ':4s} {name.replace('_', '-'):14s}{worst:12s}{at}")
    return "\n".join(lines)


def shown(default) -> str:
    return " ".join(f"{x:g}" for x in (default if isinstance(default, tuple) else (float(default),)))
