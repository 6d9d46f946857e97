"""float64 twins of glsl/optics: same file names, function names, argument names and order.

`twin` finds a function by its name and imports only its file. A name with a colon is a model of the board: board:MODEL.
"""

import inspect
import re
from collections.abc import Callable
from functools import cache
from importlib import import_module
from pathlib import Path

from app.problem import Usage, near

DEFINITION = re.compile(r"^def ([a-z]\w*)\(", re.M)


@cache
def names() -> dict[str, str]:
    """Every twin's name and the file (without suffix) it is in."""
    found: dict[str, str] = {}
    for path in sorted(Path(__file__).parent.glob("[a-z]*.py")):
        found |= dict.fromkeys(DEFINITION.findall(path.read_text(encoding="utf-8")), path.stem)
    return found


def twin(name: str) -> Callable:
    if ":" in name:  # not one of ours, and a user's file may change
        return import_module("app.board.terms").function(name)
    return own(name)


@cache
def own(name: str) -> Callable:
    if name not in names():
        raise Usage(f"there is no function {name}.{near(name, names())}")
    return getattr(import_module(f"app.optics.{names()[name]}"), name)


@cache
def arguments(name: str) -> tuple[str, ...]:
    return tuple(inspect.signature(twin(name)).parameters)
