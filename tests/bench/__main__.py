"""`python -m tests.bench [NAME ...] [--json]`."""

import argparse
import json
import sys

from tests.bench.rows import HEAD


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m tests.bench", description="Figures beside what is asked.")
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"of {', '.join(GROUPS)}; all without one")
    parser.add_argument("--json", action="store_true", help="print them as JSON")
    options = parser.parse_args()
    unknown = [name for name in options.names if name not in GROUPS]
    if unknown:
        parser.error(f"there is no group {unknown[0]}; there are {', '.join(GROUPS)}")
    found = {}
    for name in options.names or GROUPS:
        rows = GROUPS[name]()
        found[name] = [row.as_dict() for row in rows]
        if not options.json:
            print(f"\n{name}\n{HEAD}", *(row.words() for row in rows), sep="\n", flush=True)
    if options.json:
        json.dump(found, sys.stdout, indent=1)
        print()
    return 0


def commands():
    from tests.bench.processes import commands as measure

    return measure()


def frames():
    from tests.bench.frames import frames as measure

    return measure()


def plots():
    from tests.bench.plots import plots as measure

    return measure()


def points():
    from tests.bench.numbers import points as measure

    return measure()


def badges():
    from tests.bench.numbers import badges as measure

    return measure()


def albedos():
    from tests.bench.numbers import albedos as measure

    return measure()


def digits():
    from tests.bench.numbers import digits as measure

    return measure()


def studies():
    from tests.bench.studies import studies as measure

    return measure()


def window():
    from tests.bench.window import window as measure

    return measure()


def pages():
    from tests.bench.pages import pages as measure

    return measure()


def grading():
    from tests.bench.grading import grading as measure

    return measure()


def board():
    from tests.bench.board import board as measure

    return measure()


GROUPS = {measure.__name__: measure
          for measure in (commands, frames, plots, window, board, pages, points, badges, albedos, digits,
                         studies, grading)}

if __name__ == "__main__":
    sys.exit(main())
