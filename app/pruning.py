"""GLSL text without the branches that are decided before it is compiled. Pure text; lines keep their numbers.

Known are whole numbers by name: a choice of the scene, the number of the surface. `if` and `? :` whose condition is
made of them alone are decided; what follows a `return` that is always taken goes too. A function whose parameter has
such a name knows it where every call hands it on under that name, and a Surface knows its `id`.
"""

import re
from collections import Counter
from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache

from app.shader import PARAMETER, SIGNATURE, Block, block

TOKEN = re.compile(r"\s*(?:(\w+(?:\.\w+)*)|(&&|\|\||[=!<>]=|[-+*%<>!()]))")
ENDS = re.compile(r"\s*(?:return\b|discard\b|continue\b|break\b)")
HEAD = re.compile(r"\s*(if|for|while|switch|do|else)\b")
WORDS = ("if", "for", "while", "switch", "return", "vec2", "vec3", "vec4", "float", "int")  # no functions
SURFACE = "Surface"  # the struct whose first member, id, is the number of the surface
PAIRS = {"(": ")", "[": "]", "{": "}"}
Known = Mapping[str, int]


def decide(found: list[Block], known: Known) -> list[Block]:
    """The declarations with `const int NAME = VALUE;` for `uniform int NAME;`, and without what is never run."""
    within, made = who_knows(tuple(found), frozenset(known)), []
    for part in found:
        names = within.get(part, ())
        values = tuple((name, known["surface" if "." in name else name]) for name in names)
        made.append(pruned(part, values) if values else part if part.is_function else constant(part, known))
    return made


def constant(part: Block, known: Known) -> Block:
    """A uniform on a line of its own as a constant."""
    for i, line in enumerate(part.lines):
        for name in part.names & known.keys():
            if line.text.startswith(f"uniform int {name};"):
                text = line.text.replace(f"uniform int {name};", f"const int {name} = {known[name]};", 1)
                return replace(part, lines=(*part.lines[:i], replace(line, text=text), *part.lines[i + 1:]))
    return part


# --- who knows what --------------------------------------------------------------------------------------------------
@lru_cache(256)
def who_knows(found: tuple[Block, ...], known: frozenset[str]) -> dict[Block, tuple[str, ...]]:
    """Of each function the known names it uses: those it has as parameters only where all calls hand them on."""
    codes = {part: masked(part) for part in found if part.is_function and "{" in masked(part)}
    loose = frozenset[str]().union(*(part.words for part in found if part not in codes))  # no call is looked for there
    once = {name for name, count in Counter(parameters(code)[0] for code in codes.values()).items() if count == 1}
    at = {parameters(code)[0]: [arg for _, arg in parameters(code)[1]] for code in codes.values()}
    taken = {(name, arg) for name in once - loose for arg in at[name] if arg in known}

    def own(code: str) -> set[str]:
        """What no parameter and no variable of its own hides."""
        name = parameters(code)[0]
        return {one for one in known if ((name, one) in taken if one in at[name] else not hides(one, code))}

    hopes = {name for name, _ in taken}
    calls = [(code, name, given) for code in codes.values() for name, given in called(code) if name in hopes]
    before: set = set()
    while before != taken:
        before = set(taken)
        for code, name, given in calls:
            for one in [arg for arg in at[name] if (name, arg) in taken]:
                value = given[at[name].index(one)] if len(given) == len(at[name]) else ""
                if value != one or one not in own(code):
                    taken.discard((name, one))
    is_own = "surface" in known and not any(re.search(r"\.id\s*=[^=]", code) for code in codes.values()) and all(
        given[0] == "surface" for code in codes.values() for name, given in called(code) if name == SURFACE)
    ids = {part: [f"{arg}.id" for kind, arg in parameters(code)[1] if kind == SURFACE and is_own]
           for part, code in codes.items()}
    return {part: (*sorted(own(code) & part.words), *ids[part]) for part, code in codes.items()}


@lru_cache(4096)
def parameters(code: str) -> tuple[str, tuple[tuple[str, str], ...]]:
    """A function's name and its parameters: (type, name)."""
    match = SIGNATURE.search(code)
    assert match
    found = (PARAMETER.fullmatch(part.strip()) for part in match[3].split(","))
    return match[2], tuple((one[1], one[3]) for one in found if one)


@lru_cache(4096)
def hides(name: str, code: str) -> bool:
    """Whether a function declares a variable of that name."""
    body = re.sub(r"\breturn\b", "", code[code.index("{"):])
    return re.search(rf"\b\w+\s+{name}\s*[=;,\[](?!=)|,\s*{name}\s*=(?!=)", body) is not None


@lru_cache(4096)
def called(code: str) -> tuple[tuple[str, list[str]], ...]:
    """A function's calls with their arguments as they are written."""
    begin = code.index("{")
    return tuple((match[1], [part.strip() for part in parts(code[match.end():closing(code, match.end() - 1)], ",")])
                 for match in re.compile(r"\b(\w+)\s*\(").finditer(code, begin) if match[1] not in WORDS)


# --- a function's text -----------------------------------------------------------------------------------------------
@lru_cache(2048)
def masked(part: Block) -> str:
    """Its text, remarks as blanks of the same length."""
    lines = [line.text for line in part.lines]
    code = "\n".join(lines)
    return re.sub(r"/\*.*?\*/|//[^\n]*", lambda m: re.sub(r"[^\n]", " ", m[0]), code, flags=re.S)


@lru_cache(2048)
def pruned(part: Block, known: tuple[tuple[str, int], ...]) -> Block:
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
    for sign, enough in (("||", True), ("&&", False)):
        found = [truth(part, known) for part in split] if len(split := parts(condition, sign)) > 1 else []
        if found:
            return enough if enough in found else None if None in found else not enough
    words, at = [], 0
    while at < len(condition.rstrip()):
        token = TOKEN.match(condition, at)
        if not token:
            return None
        word, at = token[1] or token[2], token.end()
        if token[1] and not word.isdecimal():
            if word not in known:
                return None
            word = str(known[word])
        words.append({"!": "not", "&&": "and", "||": "or"}.get(word, word))
    try:
        found_value = eval(" ".join(words), {"__builtins__": {}}) if words else None  # numbers and signs alone
    except (SyntaxError, TypeError, ValueError, ArithmeticError, RecursionError, MemoryError):
        return None  # the compiler's to judge
    return found_value if isinstance(found_value, bool) else None


# --- brackets --------------------------------------------------------------------------------------------------------
def closing(code: str, at: int) -> int:
    """Where the bracket that opens there is closed."""
    depth = 0
    for match in re.compile(r"[()\[\]{}]").finditer(code, at):
        depth += 1 if match[0] in PAIRS else -1
        if depth == 0:
            return match.start()
    return len(code)


def opening(code: str, at: int) -> int:
    """Where the innermost bracket around a place was opened."""
    depth = 0
    for i in range(at - 1, -1, -1):
        depth += 1 if code[i] in PAIRS.values() else -1 if code[i] in PAIRS else 0
        if depth < 0:
            return i
    return -1


def level(code: str) -> int:
    return sum(code.count(a) - code.count(b) for a, b in PAIRS.items())


def upto(code: str, at: int, signs: str) -> int:
    """The first of these signs outside brackets, or the bracket that ends it all; `? :` are brackets too."""
    asked = 0
    while at < len(code):
        if code[at] in PAIRS:
            at = closing(code, at)
        elif code[at] in PAIRS.values() or (code[at] in signs and not (code[at] == ":" and asked)):
            return at
        asked += {"?": 1, ":": -1}.get(code[at], 0)
        at += 1
    return at


def colon(code: str, at: int) -> int:
    """The colon of the `?` before a place."""
    return upto(code, at, ":")


def parts(code: str, sign: str) -> list[str]:
    """The text between such signs outside brackets."""
    found, begin, at = [], 0, 0
    while at < len(code):
        if code[at] in PAIRS:
            at = closing(code, at)
        elif code.startswith(sign, at):
            found.append(code[begin:at])
            at += len(sign) - 1
            begin = at + 1
        at += 1
    return [*found, code[begin:]]
