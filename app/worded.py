"""What the parts of a lesson have in common: numbers, twins by their names, and words that are known or refused."""

from dataclasses import dataclass, field, fields
from functools import cache
from typing import Literal, get_args, get_origin

Number = float | tuple[float, ...]


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


@dataclass(frozen=True)
class Term:
    """A twin by its name; an argument not named in `args` is the value of its own name, text names another value."""

    function: str
    args: dict[str, str | Number] = field(default_factory=dict)
