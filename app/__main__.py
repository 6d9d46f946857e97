"""The command line; it imports only the chosen job. A Problem is one sentence, its traceback only with --debug."""

import argparse
import os
import sys
from collections.abc import Callable
from importlib import import_module
from typing import NoReturn

from app import VERSION
from app.display import has_display
from app.problem import Problem, Usage, near

INTERRUPTED, CLOSED_PIPE = 130, 141  # as a shell counts signals
JOBS = {  # name -> (the module with add_arguments and run, or "" for this one, what it does)
    "show": ("", "open the window at a state: halfway show 'solid_angle/patch?distance=2.5&tilt=30'"),
    "present": ("app.present", "a talk: scenes beside a deck, a clicker, a window for the lecturer"),
    "list": ("", "chapters, steps and the slides they teach"),
    "inspect": ("app.inspection", "what a step brings along, and what it leaves out"),
    "render": ("", "one step as a picture"),
    "animate": ("app.export.animate", "a step with a value on its way, as WebP, GIF, AVIF or MP4"),
    "eval": ("app.calculator", "any function of the course as a calculator"),
    "ies": ("app.ies.command", "what a luminaire's IES file declares and what it emits, as words, JSON or a picture"),
    "board": ("app.board.command", "any reflectance model, the course's, a file or measured, judged and drawn"),
    "stress": ("app.stress.command", "stability: every function and every scene at its extremes"),
    "compare": ("app.compare.command", "a step's material by our GLSL and by pyrender, and why they differ"),
    "study": ("app.study.command", "error against run time: what a digit costs, by every method"),
    "homework": ("app.homework.command", "the assignments, a file to start from, and the test of their tests"),
    "check": ("app.homework.check", "your answer to an assignment: what is right, what is not, and what it looks like"),
    "grade": ("app.grade.command", "a folder of submissions against an assignment: marks, and a result a student"),
    "export": ("app.export.web.command", "steps as pages that open in any browser, with a still beside each"),
    "doctor": ("app.doctor", "which parts work on this machine, and what mends the others"),
}
INTRODUCTION = "Halfway, the course in local shading that you can touch. Without a command it opens the window."


class Parser(argparse.ArgumentParser):
    """Speaks like the rest of the course: one sentence, with the nearest option for a mistyped one."""

    def error(self, message: str) -> NoReturn:
        wrong = message.removeprefix("unrecognized arguments: ")
        if wrong == message:
            raise Usage(f"{message}. See {self.prog} --help.")
        known = [option for action in self._actions for option in action.option_strings]
        word = wrong.split()[0]
        close = near(word, known) if word.startswith("-") else ""
        raise Usage(f"{self.prog} takes no {word}.{close or f' See {self.prog} --help.'}")


def main(arguments: list[str] | None = None) -> int:
    words = list(sys.argv[1:] if arguments is None else arguments)
    debug = "--debug" in words
    words = [word for word in words if word != "--debug"]
    try:
        code = chosen(words)
        sys.stdout.flush()
        return code
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # the interpreter flushes once more
        return CLOSED_PIPE
    except KeyboardInterrupt:
        return INTERRUPTED
    except Exception as error:
        return told(error, debug)


def told(error: Exception, debug: bool) -> int:
    """One sentence on stderr, and the exit code."""
    if debug:
        import traceback

        traceback.print_exception(error)
    if isinstance(error, Problem):
        print(f"halfway: {str(error).strip()}", file=sys.stderr)
        return error.code
    name = getattr(error, "filename", None)
    words = f"{name}: {error.strerror}" if isinstance(error, OSError) and name else f"{type(error).__name__}: {error}"
    print(f"halfway: {' '.join(words.split())}; run it with --debug to see where.", file=sys.stderr)
    return 1


def chosen(words: list[str]) -> int:
    name = words[0] if words and not words[0].startswith("-") else ""
    if name and name not in JOBS:
        if "/" in name:
            raise Usage(f"there is no command {name}. Did you mean halfway show {name}?")
        raise Usage(f"there is no command {name}.{near(name, JOBS)}")
    if not name:
        return course(front(words))
    module, what = JOBS[name]
    parser = Parser(prog=f"halfway {name}", description=what, allow_abbrev=False)
    add_arguments: Callable[[argparse.ArgumentParser], None]
    if module:
        job = import_module(module)
        add_arguments, run = job.add_arguments, job.run
    else:
        add_arguments, run = OWN[name]
    add_arguments(parser)
    parser.add_argument("--debug", action="store_true", help="show where an error happened")
    return int(run(parser.parse_args(words[1:])) or 0)


def front(words: list[str]) -> argparse.Namespace:
    """`halfway` without a command."""
    jobs = "\n".join(f"  {name:10s}{what}" for name, (_, what) in JOBS.items())
    parser = Parser(prog="halfway", description=INTRODUCTION, epilog=f"commands:\n{jobs}", allow_abbrev=False,
                    usage="halfway [command] [options]", formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--version", action="store_true", help="print the version")
    parser.add_argument("--debug", action="store_true", help="show where an error happened")
    window_arguments(parser)
    options = parser.parse_args(words)
    options.state = ""
    return options


# --- the window ------------------------------------------------------------------------------------------------------
def window_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--theme", metavar="NAME", default="", help="dark, light or projector")
    parser.add_argument("--mesh", metavar="FILE", help="your mesh: STL, OBJ, PLY or GLB")
    parser.add_argument("--ies", metavar="FILE", help="your luminaire: an IES file (LM-63)")
    map_argument(parser)
    parser.add_argument("--output", metavar="FOLDER", help="no window: pictures and a page of all lessons, to here")


def show_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("state", metavar="STATE",
                        help="chapter/step, with values if you like: ?distance=2.5&tilt=30; or a PNG of ours")
    window_arguments(parser)


def course(options: argparse.Namespace) -> int:
    """The window, or the same lessons as pictures where there is no display or a folder for them is named."""
    if getattr(options, "version", False):
        print(f"halfway {VERSION}")
        return 0
    from app.theme import THEMES

    if options.theme and options.theme not in THEMES:
        raise Usage(f"there is no theme {options.theme}.{near(options.theme, THEMES)}")
    if options.state:
        from app.picture_state import is_picture, state_of
        from app.state import parse

        options.state = state_of(options.state) if is_picture(options.state) else options.state

        parse(options.state)
    if not options.output and has_display():
        return int(import_module("app.viewer").run(options) or 0)
    if not options.output:
        print("There is no display for a window here, so the lessons become pictures and a page to open in a browser.")
    return int(import_module("app.export.gallery").run(options) or 0)


# --- pictures --------------------------------------------------------------------------------------------------------
def render_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("step", metavar="STEP", help="chapter/step, or a state string")
    parser.add_argument("-o", "--output", metavar="FILE.png", required=True,
                        help="where the picture goes; of a plot of curves also .svg and .pdf")
    parser.add_argument("--size", metavar="WxH", help="pixels; 1280x720")
    parser.add_argument("--set", metavar="name=value", nargs="+", action="extend", default=[],
                        help="values of the step, angles in degrees")
    parser.add_argument("--view", metavar="PART", help="scene, plot or both")
    parser.add_argument("--plot", metavar="N", help="which plot of a step that has several, from 1, or its title")
    parser.add_argument("--broken", metavar="N", nargs="?", const="1",
                        help="with naive forms in place of stable ones, as its button N (1) breaks it")
    parser.add_argument("--theme", metavar="NAME", help="dark, light or projector")
    parser.add_argument("--mesh", metavar="FILE", help="your mesh in place of the scene's: STL, OBJ, PLY or GLB")
    parser.add_argument("--ies", metavar="FILE", help="your luminaire in place of the scene's: an IES file (LM-63)")
    map_argument(parser)


def map_argument(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--map", metavar="KIND=FILE", nargs="+", action="extend", default=[],
                        help="your maps in a step that has some: albedo, f0, roughness or normal, PNG or JPEG")


def render(options: argparse.Namespace) -> int:
    return int(import_module("app.export.still").run(options) or 0)


# --- the list --------------------------------------------------------------------------------------------------------
def list_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--json", action="store_true", help="print it as JSON")


def list_steps(options: argparse.Namespace) -> int:
    """Every chapter; one that cannot be read is told on stderr, and the code is 1."""
    from app.catalog import LoadedStep, chapters

    found = chapters()
    if options.json:
        import json

        print(json.dumps([{
            "chapter": loaded.id, "number": loaded.number, "title": loaded.chapter.title, "fault": loaded.fault,
            "steps": [{"step": f"{loaded.id}/{step.name}", "title": step.title, "slides": step.slides,
                       "minutes": step.minutes, "beyond": step.beyond} for step in loaded.chapter.steps],
        } for loaded in found], indent=1, ensure_ascii=False))
    else:
        for loaded in found:
            print(f"{loaded.number}  {loaded.chapter.title}")
            for i, step in enumerate(loaded.chapter.steps):
                plus = " +" if step.beyond else ""
                print(f"   {LoadedStep(loaded, step, i).id:28s}{step.title}{plus}  [{'; '.join(step.slides)}]")
    faults = [loaded.fault for loaded in found if loaded.fault]
    for fault in faults:
        print(f"halfway: {fault}", file=sys.stderr)
    return 1 if faults else 0


OWN = {"show": (show_arguments, course), "list": (list_arguments, list_steps), "render": (render_arguments, render)}

if __name__ == "__main__":
    sys.exit(main())
