"""Places in GLSL text by its brackets: where one is closed, what stands between signs outside all of them."""

import re

PAIRS = {"(": ")", "[": "]", "{": "}"}


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
