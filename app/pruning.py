"""GLSL text without the branches that are decided before it is compiled. Pure text; lines keep their numbers.

`if` and `? :` whose condition is made of known numbers (app/propagation.py) are decided; what follows a `return` that
is always taken goes too.
"""

import re
from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache

from app.brackets import closing, colon, level, opening, parts, upto
from app.propagation import (
    BUILT_IN,
    SURFACE,
    Known,
    Numbers,
    called,
    constants,
    gives_away,
    has_one_number,
    macros,
    masked,
    own,
    parameters,
    possible,
)
from app.shader import Block, block

ENDS = re.compile(r"\s*(?:return\b|discard\b|continue\b|break\b)")
HEAD = re.compile(r"\s*(if|for|while|switch|do|else)\b")
Given = tuple[Numbers | None, ...]


def decide(found: list[Block], known: Mapping[str, int | Numbers]) -> list[Block]:
    """The declarations with `const int NAME = VALUE;` for a `uniform int NAME;` of one known number, and without what
    is never run; `known` is a number, or those it may be.

    Functions are gone through from the last to the first, as each stands behind those it calls: when it is its turn,
    all that calls it has been shortened already, and what its parameters may be is known."""
    numbers = {name: one if isinstance(one, frozenset) else frozenset((one,)) for name, one in known.items()}
    made = [part if part.is_function else constant(part, numbers) for part in found]
    codes = {i: code for i, part in enumerate(made) if part.is_function and "{" in (code := masked(part))}
    names = {i: parameters(code)[0] for i, code in codes.items()}
    others = [part for i, part in enumerate(made) if i not in codes]
    loose = frozenset[str]().union(*(part.words for part in others))  # macros, or ahead: no call is looked for there
    outer = frozenset[str]().union(*(part.names for part in others))
    numbers = {name: numbers[name] for name in numbers.keys() - macros(others)}
    has_one = has_one_number([code for i, code in codes.items() if SURFACE in made[i].words])
    of_surface = numbers.get("surface") if has_one else None
    numbers = constants(made, numbers)
    lends = BUILT_IN | {names[i] for i in codes if gives_away(codes[i])}
    entries = {"main"} if "main" in names.values() else set(names.values()) - {
        name for code in codes.values() for name, _ in called(code)}
    asked = entries | loose  # by who knows what
    given: dict[str, Given] = {}
    for i in reversed(codes):
        name = names[i]
        if name not in given and name not in asked:
            continue  # nothing calls it
        has = own(made[i], () if name in asked else given[name], numbers, of_surface, lends, outer)
        made[i], handed = followed(made[i], tuple(has.items()))
        for callee, values in handed:
            given[callee] = either(given[callee], values) if callee in given else values
    return made


def either(one: Given, other: Given) -> Given:
    """What parameters may be when one call gives them this and another that."""
    return tuple(a and b and a | b for a, b in zip(one, other, strict=True)) if len(one) == len(other) else ()


@lru_cache(8192)
def followed(part: Block, known: tuple[tuple[str, Numbers], ...]) -> tuple[Block, tuple[tuple[str, Given], ...]]:
    """A function without what is not run, and its calls with what it gives them."""
    made, numbers = pruned(part, known), dict(known)
    return made, tuple((name, tuple(possible(one, numbers) for one in given)) for name, given in called(masked(made)))


def constant(part: Block, known: Known) -> Block:
    """A uniform on a line of its own as a constant."""
    for i, line in enumerate(part.lines):
        for name in part.names & known.keys():
            if len(known[name]) == 1 and line.text.startswith(f"uniform int {name};"):
                text = line.text.replace(f"uniform int {name};", f"const int {name} = {min(known[name])};", 1)
                return replace(part, lines=(*part.lines[:i], replace(line, text=text), *part.lines[i + 1:]))
    return part


# --- a function's text -----------------------------------------------------------------------------------------------
@lru_cache(8192)
def pruned(part: Block, known: tuple[tuple[str, Numbers], ...]) -> Block:
    """A function without what is not run at these numbers; what is no GLSL, or too deep, is left for the compiler."""
    code = masked(part)
    text = list(code)
    try:
        statement(text, code.index("{"), dict(known))
    except (ValueError, IndexError, RecursionError):
        return part
    if "".join(text) == code:
        return part
    written = "\n".join(line.text for line in part.lines)  # with its remarks
    kept = "".join(new if new != old else own for new, old, own in zip(text, code, written, strict=True))
    return block([replace(line, text=new.rstrip()) for new, line in zip(kept.split("\n"), part.lines, strict=True)])


def blank(text: list[str], begin: int, end: int) -> None:
    text[begin:end] = [c if c == "\n" else " " for c in text[begin:end]]


def statement(text: list[str], at: int, known: Known) -> tuple[int, bool]:
    """Prunes the statement that begins there: where it ends, and whether nothing after it is run."""
    code = "".join(text)
    at += len(code[at:]) - len(code[at:].lstrip())
    if code[at] == "{":
        end, at, done = closing(code, at), at + 1, False
        while "".join(text[at:end]).strip():
            if done:
                blank(text, at, end)
                break
            at, done = statement(text, at, known)
        return end + 1, done
    head = HEAD.match(code, at)
    if head and head[1] == "if":
        return choice(text, at, known)
    if head and head[1] in ("for", "while"):
        inside = closing(code, code.index("(", at)) + 1
        ternaries(text, at, inside, known)
        return statement(text, inside, known)[0], False
    if head:  # switch and do stay as they are
        inside = code.index("{", at)
        end = closing(code, inside) + 1
        return (code.index(";", end) + 1 if head[1] == "do" else end), False
    end = upto(code, at, ";") + 1
    ternaries(text, at, end, known)
    return end, ENDS.match(code, at) is not None


def choice(text: list[str], at: int, known: Known) -> tuple[int, bool]:
    """An `if` with its `else`, which may be decided."""
    code = "".join(text)
    opened = code.index("(", at)
    then = closing(code, opened) + 1
    is_true = truth(code[opened + 1:then - 1], known)
    if is_true is None:
        ternaries(text, opened, then, known)
    end, done = statement(text, then, known)
    other = re.compile(r"\s*else\b").match(code, end)
    last, also = statement(text, other.end(), known) if other else (end, False)
    if is_true is None:
        return last, bool(other) and done and also
    if is_true:
        blank(text, at, then)
        blank(text, end, last)
        return last, done
    blank(text, at, other.end() if other else end)
    if not other:
        text[at] = ";"
    return last, also


def ternaries(text: list[str], begin: int, end: int, known: Known) -> None:
    """`condition ? this : that` with a decided condition."""
    at = begin
    while (at := "".join(text).find("?", at, end)) >= 0:
        code = "".join(text)
        first = max((m.end() for m in re.finditer(r"(?<![=!<>])=(?!=)|\breturn\b|[;{}?:,]", code[begin:at])
                     if level(code[begin + m.end():at]) == 0), default=0) + begin
        opened = opening(code, at)
        first = max(first, opened + 1, begin)
        middle = colon(code, at + 1)
        last = upto(code, middle + 1, ",;:")
        is_true = truth(code[first:at], known)
        if is_true is not None:
            blank(text, first, at + 1)
            if is_true:
                blank(text, middle, last)
            else:
                blank(text, first, middle + 1)
        at += 1


def truth(condition: str, known: Known) -> bool | None:
    """Of a condition made of known numbers; of `a && b` and `a || b` one that is known may be enough."""
    if (found := possible(condition, known)) is not None:
        one = min(found)
        return one if len(found) == 1 and isinstance(one, bool) else None
    for sign, enough in (("||", True), ("&&", False)):
        if len(split := parts(condition, sign)) > 1:
            each = [truth(part, known) for part in split]
            return enough if enough in each else None if None in each else not enough
    return None
