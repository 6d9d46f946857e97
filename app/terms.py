"""A lesson's `Term` at given values: the Python twin in float64, or the GLSL twin in float32.

Where a text of the user's own is part of the twin (`edit.EDITED` among the values), its GLSL is what is evaluated.

The unit vectors n, l, v and h are no values: they follow from the angles theta_l, theta_v and phi, n being +z.
"""

from importlib import import_module

import numpy as np

from app.edit import EDITED, follows
from app.lesson import Term
from app.optics import arguments, twin
from app.quantities import FROM_ANGLES


def bound(term: Term, values: dict, **swept) -> dict:
    """The arguments of a term: swept ones first, then what the term names, then the value of the same name."""
    found = {}
    for name in arguments(term.function):
        given = term.args.get(name, name)
        key = given if isinstance(given, str) else None
        if key is not None and key in swept:
            found[name] = swept[key]
        elif key in FROM_ANGLES and key not in values:
            found[name] = vector(key, {**values, **swept})
        elif key is not None:
            found[name] = values[key]
        else:
            found[name] = given
    return found


def vector(name: str, values: dict) -> np.ndarray:
    """n, l, v or h from the angles."""
    if name == "n":
        return np.array([0.0, 0.0, 1.0])
    if name != "h":
        return twin("light_direction" if name == "l" else "view_direction")(*(values[a] for a in FROM_ANGLES[name]))
    both = vector("l", values) + vector("v", values)
    return both / np.linalg.norm(both, axis=-1, keepdims=True)


def evaluate(term: Term, values: dict, precision: str = "float64", ctx=None, **swept) -> np.ndarray:
    """The term's value; `precision` "float32" is the GLSL twin on the GPU.

    A mesh step carries its triangles (faces, 3, 3) as the value `triangles`.
    """
    args = bound(term, values, **swept)
    edits = values.get(EDITED, ())
    yours = follows(term.function, edits)
    if precision == "float64" and not yours:
        return np.asarray(twin(term.function)(**args))
    if ":" in term.function:
        return np.asarray(import_module("app.board.terms").function(term.function, edits)(**args))
    from app.gpu.evaluate import evaluate as on_gpu

    return on_gpu(term.function, args, ctx=ctx, overrides=dict(edits) if yours else None)


def is_yours(term: Term, values: dict) -> bool:
    """Whether the value is made of the user's own text."""
    return follows(term.function, values.get(EDITED, ()))


def whose(term: Term, values: dict) -> str:
    """Whose value it is, while something is edited: a table of measurements has no text, and so it stays."""
    if EDITED not in values:
        return ""
    if is_yours(term, values):
        return "yours"
    _, _, word = term.function.partition(":")
    return "measured" if word and import_module("app.board.edited").is_measured(word) else "the course's"
