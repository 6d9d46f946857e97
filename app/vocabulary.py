"""The words that the fields of a lesson's data know."""

from dataclasses import fields
from functools import cache
from typing import Literal, get_args, get_origin

Number = float | tuple[float, ...]
Colour = Literal["n", "l", "v", "h", "r", "exact", "estimate", "printed", "lost", "d", "g", "f", "quiet"]


class Worded:
    """Refuses a word that a field does not know, there where the lesson says it."""

    def __post_init__(self) -> None:
        for name, words in vocabulary(type(self)):  # type: ignore[arg-type]
            if (given := getattr(self, name)) not in words:
                raise ValueError(f"{name}={given!r}; it can be {', '.join(map(repr, words))}")


@cache
def vocabulary(kind: type) -> tuple[tuple[str, tuple], ...]:
    """The fields of a class that take one of some words."""
    return tuple((f.name, get_args(f.type)) for f in fields(kind) if get_origin(f.type) is Literal)
