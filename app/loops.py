"""Loops of a text that is not the course's: each turn is counted, and after too many the loop is left.

An endless loop stops a machine's graphics for all its windows. So `guarded` puts a count into the condition of every
loop (glsl/stage/turns.glsl), on the line where it stands; whoever runs the text asks which loop was left, and tells it.
"""

import re

from app.problem import Problem

COUNTED = "stage/turns.glsl"
COUNT = "halfway_goes_on(__LINE__)"  # of the whole text that is compiled: `shader.translate` knows whose line it is
MOST = 30_000  # turns of all loops together, of a point or of a pixel; llvmpipe leaves a loop itself after 65 535
COMMENT = re.compile(r"//[^\n]*|/\*.*?(?:\*/|\Z)", re.S)
LOOP = re.compile(r"\b(for|while)\b[ \t\r\n\\]*(\(?)")
DECLARED = re.compile(r"\s*(?:const\s+)?[A-Za-z_]\w*\s+[A-Za-z_]\w*\s*=(?!=)")  # while (bool more = ...)
NEVER = f"this loop never ends; it was left after {MOST} turns"


def guarded(text: str, file: str, first: int = 1) -> str:
    """The same lines, each loop's condition with the count; a loop that hides in macros is a Problem."""
    code = COMMENT.sub(lambda m: re.sub(r"[^\n]", " ", m[0]), text)
    put: list[tuple[int, str]] = []  # place, what is put there
    for loop in LOOP.finditer(code):
        parts = within(code, loop.end()) if loop[2] else []
        if len(parts) != (3 if loop[1] == "for" else 1):
            line = first + code.count("\n", 0, loop.start())
            form = "for (start; condition; step)" if loop[1] == "for" else "while (condition)"
            raise Problem(f"{file}, line {line}: a loop is written out in one place, as {form}.")
        begin, end = parts[1 if loop[1] == "for" else 0]
        if not code[begin:end].strip():
            put.append((end, COUNT))
            continue
        declared = DECLARED.match(code, begin, end)
        put += [(declared.end() if declared else begin, "("), (end, f") && {COUNT}")]
    made, last = [], 0
    for place, what in sorted(put, key=lambda one: one[0]):
        made += [text[last:place], what]
        last = place
    return "".join((*made, text[last:]))


def within(code: str, begin: int) -> list[tuple[int, int]]:
    """What stands between a bracket and its end, cut at semicolons: from, up to; [] where it has no end."""
    found: list[tuple[int, int]] = []
    depth, start = 0, begin
    for match in re.compile(r"[;()\[\]{}]").finditer(code, begin):
        c = match[0]
        if c == ")" and depth == 0:
            return [*found, (start, match.start())]
        if c == ";" and depth == 0:
            found.append((start, match.start()))
            start = match.end()
        depth += (c in "([{") - (c in ")]}")
        if depth < 0:
            break
    return []
