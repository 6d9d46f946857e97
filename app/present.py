"""`halfway present`: a talk from the course, a cue file or a deck, with a clicker and a window for the lecturer."""

from argparse import ArgumentParser, Namespace
from importlib import import_module

from app import cues
from app.display import has_display
from app.problem import Problem, Usage, near
from app.state import parse
from app.theme import THEMES


def add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument("what", nargs="?", default="", metavar="STATE|CUES.toml",
                        help="a state to begin at, or a file of cues; without it the course's first step")
    parser.add_argument("--slides", metavar="DECK.pdf", help="the deck's pages beside the scenes, one clicker for both")
    parser.add_argument("--half", action="store_true", help="the right half of the screen, beside other slides")
    parser.add_argument("--on-top", action="store_true", help="above the windows of other programs")
    parser.add_argument("--full", action="store_true", help="full screen from the start; F11 switches")
    parser.add_argument("--one-window", action="store_true", help="without the lecturer's window; L opens it")
    parser.add_argument("--theme", metavar="NAME", default="projector", help="dark, light or projector")


def run(options: Namespace) -> int:
    if options.theme not in THEMES:
        raise Usage(f"there is no theme {options.theme}.{near(options.theme, THEMES)}")
    if options.slides:
        from app.deck import Deck

        deck = Deck(options.slides)
    else:
        deck = None
    stops, begin = planned(options.what, deck)
    if not has_display():
        raise Problem("there is no display to present on; `halfway export --all -o DIR` writes pages for any browser.")
    presenter = import_module("app.viewer.presenter")
    window = presenter.Presenter(stops, begin, deck, options.theme, on_top=options.on_top, half=options.half,
                                 full=options.full, two=not options.one_window)
    return int(presenter.run(window))


def planned(what: str, deck) -> tuple[tuple[cues.Stop, ...], int]:
    """The stops, and the first of them."""
    if what.endswith(".toml"):
        found = cues.read(what)
        return (cues.of_deck(found, len(deck)) if deck else found), 0
    if what:
        parse(what)
        return (cues.beside(what, len(deck)), 0) if deck else cues.of_course(what)
    if deck:
        return cues.of_deck(cues.by_title([deck.lines(i + 1) for i in range(len(deck))]), len(deck)), 0
    return cues.of_course("")
