"""`halfway board MODEL|FILE.brdf ...`: models in the window, or judged in words, as JSON or as a picture."""

import argparse
import json
import math
import sys
from collections.abc import Sequence
from dataclasses import asdict

from app.badges import NAMES, Badge
from app.board import course_model, settings
from app.board.brdf_file import Default, Parameter
from app.board.fit import fit
from app.board.merl import Merl
from app.board.models import BoardModel, listed, opened
from app.display import has_display
from app.export import target
from app.problem import Problem, Usage

JUDGED = tuple(name for name in NAMES if name != "linear")  # a BRDF is linear by what it is


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("models", metavar="MODEL|FILE", nargs="*",
                        help="models of the course (cook_torrance, oren_nayar ...), files of the BRDF explorer "
                             "(.brdf), measurements in MERL's format (.binary), or folders of such files")
    parser.add_argument("--text", action="store_true", help="print it for a person, without the window")
    parser.add_argument("--json", action="store_true", help="print it as JSON")
    parser.add_argument("-o", "--output", metavar="REPORT.png", help="the board as a picture, of up to four models")
    parser.add_argument("--set", metavar="name=value", nargs="+", action="extend", default=[],
                        help="parameters, for every model that has them; a colour is r,g,b")
    parser.add_argument("--theme", metavar="NAME", help="dark, light or projector")
    parser.add_argument("--size", metavar="WxH", help="of the picture, in pixels; 1920x1200")


def run(options: argparse.Namespace) -> int:
    """The window, where one is not asked for anything else and there is a display. A file that cannot be read is told,
    and the others go on; with none left the code is its own."""
    in_window = not (options.text or options.json or options.output) and has_display()
    if not options.models and not in_window:
        raise Usage(f"halfway board wants a model or a file; models are {', '.join(course_model.names())}.")
    asked = listed(options.models)
    if in_window:
        return window(asked, options)
    if options.output:
        target.picture_path(options.output)
    models: dict[str, BoardModel] = {}
    found: dict[str, dict] = {}
    problems: list[Problem] = []
    for word in asked:
        try:
            models[word] = opened(word)
        except Problem as problem:
            problems.append(problem)
    if models:
        settings.checked(list(models.values()), options.set)
    for word, model in models.items():
        try:
            found[word] = facts(model, settings.of_model(model, options.set))
        except Usage:
            raise
        except Problem as problem:
            problems.append(problem)
    if not found:
        *others, last = problems
        told(others)
        raise last
    if options.output:
        from app.export.board_report import MOST, SIZE, save

        save(list(found)[:MOST], options.output, options.theme or "dark", options.size or SIZE, options.set)
        if len(found) > MOST:
            told([f"{options.output} shows the first {MOST} of {len(found)} models; name others for another picture."])
    tell(list(found.values()), problems, options.json)
    return 0


def window(asked: list[str], options: argparse.Namespace) -> int:
    """The window at a board of these models; None of them: the course's Cook-Torrance."""
    from app.board.board_step import id_of, started
    from app.viewer import run as show

    state = started(id_of(asked), options.set)
    return show(argparse.Namespace(state=state, theme=options.theme))


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


def facts(model: BoardModel, values: dict[str, Default] | None = None) -> dict:
    """What `--json` prints of one model, at its own values or these; angles are in degrees."""
    badges = model.badges(values)
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
