"""Whole numbers that are known before a GLSL text is compiled, carried through its functions. Pure text.

Known is a name by the numbers it may have: one of a choice that is made, some of the surfaces that share a program.
From there they go into constants, into variables that are set once, and into parameters, of which every call tells.
"""

import re
from collections.abc import Iterable, Mapping
from functools import lru_cache
from itertools import product
from math import prod
from types import CodeType

from app.brackets import closing, parts, upto
from app.shader import ALWAYS, PARAMETER, SIGNATURE, Block

Numbers = frozenset[int]
Known = Mapping[str, Numbers]
SURFACE = "Surface"  # the struct whose first member, id, is the number of the surface
MOST = 64  # combinations of numbers that are tried for one expression
BUILT_IN = frozenset(("frexp", "modf"))  # of GLSL, that set what they are handed
WORDS = ("if", "for", "while", "switch", "return", "vec2", "vec3", "vec4", "float", "int")  # no functions
TOKEN = re.compile(r"\s*(?:(\w+(?:\.\w+)*)|(&&|\|\||[=!<>]=|[-+*/%<>!()]))")
SPOKEN = {"!": "not", "&&": "and", "||": "or", "/": "//", "true": "True", "false": "False"}  # GLSL -> Python
WHOLE = re.compile(r"\b(?:int|bool)\s+(?=\w+\s*=[^=])")
SETS = r"(?:[-+*/%&|^]|<<|>>)?=(?!=)|\+\+|--"


# --- expressions -----------------------------------------------------------------------------------------------------
@lru_cache(8192)
def formula(text: str) -> tuple[CodeType, tuple[str, ...], bool] | None:
    """Of an expression of whole numbers, names and signs alone: its code, its names, whether it divides."""
    words: list[str] = []
    names: list[str] = []
    at, end = 0, len(text.rstrip())
    while at < end:
        token = TOKEN.match(text, at)
        if not token:
            return None
        word, at = token[1] or token[2], token.end()
        if token[1] and not word.isdecimal() and word not in SPOKEN:
            names += [word] * (word not in names)
            word = f"n{names.index(word)}"  # a name may be a word of Python
        words.append(SPOKEN.get(word, word))
    try:
        return compile(" ".join(words), "GLSL", "eval"), tuple(names), "//" in words or "%" in words
    except (SyntaxError, ValueError, RecursionError, MemoryError, OverflowError):
        return None  # the compiler's to judge


def possible(expression: str, known: Known) -> Numbers | None:
    """What an expression may be; None where that is not known."""
    made = formula(expression)
    if made is None or not known.keys() >= set(made[1]) or prod(len(known[name]) for name in made[1]) > MOST:
        return None
    code, names, divides = made
    found = set()
    for chosen in product(*(known[name] for name in names)):
        if divides and min(chosen, default=0) < 0:
            return None  # GLSL leaves open what comes out
        try:
            found.add(eval(code, {"__builtins__": {}}, {f"n{i}": number for i, number in enumerate(chosen)}))
        except (TypeError, ValueError, ArithmeticError, RecursionError, MemoryError):
            return None
    return frozenset(found) if all(isinstance(one, int) and abs(one) < 2**31 for one in found) else None


# --- a function's text -----------------------------------------------------------------------------------------------
@lru_cache(8192)
def masked(part: Block) -> str:
    """Its text, remarks as blanks of the same length."""
    code = "\n".join(line.text for line in part.lines)
    return re.sub(r"/\*.*?\*/|//[^\n]*", lambda m: re.sub(r"[^\n]", " ", m[0]), code, flags=re.S)


@lru_cache(8192)
def parameters(code: str) -> tuple[str, tuple[tuple[str, str], ...]]:
    """A function's name and its parameters: (type, name)."""
    match = SIGNATURE.search(code)
    assert match
    found = (PARAMETER.fullmatch(part.strip()) for part in match[3].split(","))
    return match[2], tuple((one[1], one[3]) for one in found if one)


@lru_cache(8192)
def gives_away(code: str) -> bool:
    """Whether a function may set what it is handed."""
    match = SIGNATURE.search(code)
    return match is not None and re.search(r"\b(?:in)?out\b", match[3]) is not None


@lru_cache(8192)
def hides(name: str, code: str) -> bool:
    """Whether a function declares a variable of that name."""
    body = code[code.index("{"):]
    return times_set(name, body) > 0 or re.search(rf"\b(?!return\b)\w+\s+{name}\s*[=;,\[](?!=)", body) is not None


@lru_cache(8192)
def called(code: str) -> tuple[tuple[str, tuple[str, ...]], ...]:
    """A function's calls with their arguments as they are written."""
    found = []
    for match in re.compile(r"\b(\w+)\s*\(").finditer(code, code.index("{")):
        if match[1] not in WORDS:
            inside = code[match.end():closing(code, match.end() - 1)]
            found.append((match[1], tuple(part.strip() for part in parts(inside, ","))))
    return tuple(found)


@lru_cache(8192)
def variables(code: str) -> tuple[tuple[str, str], ...]:
    """A function's whole numbers, true and false, that are set once, where they are declared: (name, expression)."""
    body, found = code[code.index("{"):], []
    for match in WHOLE.finditer(body):
        for one in parts(body[match.end():upto(body, match.end(), ";")], ","):
            name, is_set, expression = one.partition("=")
            if is_set and times_set(name.strip(), body) == 1:
                found.append((name.strip(), expression))
    return tuple(found)


@lru_cache(8192)
def times_set(name: str, body: str) -> int:
    """How often it is set, or declared without a value."""
    bare = re.findall(rf"\b(?!return\b|else\b)\w+\s+{name}\s*[;,\[)]", body)
    return len(bare) + len(re.findall(rf"\b{name}\s*(?:{SETS})|(?:\+\+|--)\s*{name}\b", body))


@lru_cache(8192)
def lent(code: str, lends: frozenset[str]) -> frozenset[str]:
    """The names it hands to functions that may set them."""
    return frozenset(one for name, given in called(code) if name in lends for one in given)


# --- who knows what --------------------------------------------------------------------------------------------------
def constants(found: Iterable[Block], numbers: Known) -> dict[str, Numbers]:
    """The text's own constants, `const int A = 1, B = A + 1;`, beside what is known."""
    known = dict(numbers)
    for part in found:
        for name, expression in () if part.is_function or ALWAYS in part.names else declared(part):
            if name not in known and (value := possible(expression, known)):
                known[name] = value
    return known


@lru_cache(8192)
def declared(part: Block) -> tuple[tuple[str, str], ...]:
    match = re.match(r"\s*const\s+int\s+([^;{]*);", masked(part)) if {"const", "int"} <= part.words else None
    split = (one.partition("=") for one in parts(match[1], ",")) if match else ()
    return tuple((name.strip(), expression) for name, is_set, expression in split if is_set)


def macros(found: Iterable[Block]) -> frozenset[str]:
    """Names that may stand for anything."""
    return frozenset(name for part in found if masked(part).lstrip().startswith("#define") for name in part.names)


def has_one_number(codes: list[str]) -> bool:
    """Whether every Surface is made with the number `surface`, and keeps it."""
    return not any(re.search(r"\.id\s*=[^=]", code) for code in codes) and all(
        given[0] == "surface" for code in codes for name, given in called(code) if name == SURFACE)


def own(part: Block, given: tuple[Numbers | None, ...], numbers: Known, of_surface: Numbers | None,
        lends: frozenset[str], outer: frozenset[str]) -> dict[str, Numbers]:
    """What a function knows of the names it uses, when its calls give it these; `of_surface` is the number of a
    Surface, `lends` are the functions that may set what they are handed, `outer` what is declared outside functions."""
    code = masked(part)
    _, taken = parameters(code)
    inside, away = {name for _, name in taken}, lent(code, lends)
    found = {name: numbers[name] for name in sorted(numbers.keys() & part.words - inside) if not hides(name, code)}
    for (_, name), value in zip(taken, given, strict=False):
        if value and name not in away and not times_set(name, code[code.index("{"):]):
            found[name] = value
    if of_surface:
        found |= {f"{name}.id": of_surface for kind, name in taken if kind == SURFACE}
    for name, expression in variables(code):
        if name not in numbers and name not in inside | away | outer and (value := possible(expression, found)):
            found[name] = value
    return found
