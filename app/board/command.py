"""`halfway board MODEL|FILE.brdf ...`: what a model reflects, judged; `--json` for programs."""

import argparse
import json
import math
import sys
from collections.abc import Sequence
from dataclasses import asdict

from app.badges import NAMES, Badge
from app.board import course_model
from app.board.brdf_file import Parameter
from app.board.fit import fit
from app.board.merl import Merl
from app.board.models import BoardModel, listed, opened
from app.problem import Problem, Usage

JUDGED = tuple(name for name in NAMES if name != "linear")  # a BRDF is linear by what it is


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("models", metavar="MODEL|FILE", nargs="*",
                        help="models of the course (cook_torrance, oren_nayar ...), files of the BRDF explorer "
                             "(.brdf), measurements in MERL's format (.binary), or folders of such files")
    parser.add_argument("--json", action="store_true", help="print it as JSON")
    parser.add_argument("-o", "--output", metavar="REPORT.png", help="the board as a picture, of up to four models")
    parser.add_argument("--theme", metavar="NAME", help="of the picture: dark, light or projector")
    parser.add_argument("--size", metavar="WxH", help="of the picture, in pixels; 1920x1200")


def run(options: argparse.Namespace) -> int:
    """A file that cannot be read is told, and the others go on; with none left the code is its own."""
    if not options.models:
        raise Usage(f"halfway board wants a model or a file; models are {', '.join(course_model.names())}.")
    asked = listed(options.models)
    if options.output:
        from app.export.board_report import SIZE, checked, save

        checked(asked, options.output)
    found: dict[str, dict] = {}
    problems: list[Problem] = []
    for word in asked:
        try:
            found[word] = facts(opened(word))
        except Problem as problem:
            problems.append(problem)
    if not found:
        *others, last = problems
        told(others)
        raise last
    if options.output:
        save(list(found), options.output, options.theme or "dark", options.size or SIZE)
    tell(list(found.values()), problems, options.json)
    return 0


def tell(found: list[dict], problems: list[Problem], as_json: bool) -> None:
    if as_json:
        whole = found[0] if len(found) + len(problems) == 1 else found
        print(json.dumps(whole, indent=1, ensure_ascii=False, allow_nan=False))
    else:
        print("\n\n".join(words(one) for one in found))
    told([*problems, *(w for one in found for w in one.get("warnings", ()))])


def told(sentences: Sequence[object]) -> None:
    for sentence in sentences:
        print(f"halfway: {sentence}", file=sys.stderr)


def facts(model: BoardModel) -> dict:
    """What `--json` prints of one model; angles are in degrees."""
    badges = model.badges()
    found: dict = {"name": model.name, "parameters": [parameter(p) for p in model.parameters],
                   "badges": {name: judged(badges[name]) for name in JUDGED}}
    if isinstance(model, Merl):
        found |= {"missing": model.missing, "fit": {"model": "rho / pi + Cook-Torrance", **asdict(fit(model))}}
    return found | ({"warnings": list(model.warnings)} if model.warnings else {})


def parameter(p: Parameter) -> dict:
    return {"name": p.name, "type": p.type, "min": p.low, "max": p.high, "default": p.default}


def judged(badge: Badge) -> dict:
    return {"ok": badge.ok, "worst": badge.worst, "at": {k: math.degrees(v) for k, v in badge.at.items()}}


def words(found: dict) -> str:
    """The same for a person."""
    lines = [found["name"], *(f"  {p['name']:16s}{p['min']:g} to {p['max']:g}, at {shown(p['default'])}"
                              for p in found["parameters"])]
    if "fit" in found:
        near = found["fit"]
        lines.append(f"  nearest {near['model']}: m {near['m']:.4g}, rho {shown(near['rho'])}, f0 {shown(near['f0'])}; "
                     f"{100 * near['residual']:.3g} % of it is left")
    for name, badge in found["badges"].items():
        at = ", ".join(f"{k} {v:.4g}°" for k, v in badge["at"].items())
        worst = "not finite" if badge["worst"] is None else f"{badge['worst']:.4g}"
        lines.append(f"  {'good' if badge['ok'] else 'BAD ':4s} {name.replace('_', '-'):14s}{worst:12s}{at}")
    return "\n".join(lines)


def shown(default) -> str:
    return " ".join(f"{x:.4g}" for x in (default if isinstance(default, tuple) else (float(default),)))
