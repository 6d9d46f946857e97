"""Shader text: a scene's includes and functions put together, without what nothing calls. Pure text, no GL.

`assemble` follows `#include "optics/cone.glsl"` lines depth first, each file once, keeps only the declarations that can
be reached from the entry points, and remembers the (file, line) of every line so that `translate` can turn a compiler's
message back to what a person wrote.
"""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache, lru_cache
from itertools import groupby
from pathlib import Path

from app.paths import GLSL
from app.problem import Problem, near

DESKTOP = ("#version 330 core",)
WEB = ("#version 300 es", "precision highp float;", "precision highp int;", "precision highp sampler2D;")
INCLUDE = re.compile(r'^\s*#include\s+"([^"]+)"\s*$')
SIGNATURE = re.compile(r"^(?:(?:highp|mediump|lowp)\s+)?(?!else\b|return\b)(\w+)(?:\s*\[\w*\])?\s+(\w+)\s*"
                       r"\(([^)]*)\)\s*(\{|;)", re.M)
PARAMETER = re.compile(r"(?:(?:const|in|out|inout|highp|mediump|lowp)\s+)*(\w+)\s*(?:\[\s*(\w+)\s*\])?\s+"
                       r"(\w+)\s*(?:\[\s*(\w+)\s*\])?")
WORD = re.compile(r"[A-Za-z_]\w*")
MESSAGE = re.compile(r"^\s*(?:ERROR:\s*)?\d+[:(](\d+)\)?(?:\((\d+)\))?\s*:?\s*(.*)$")
WIDTH = {"float": 1, "int": 1, "vec2": 2, "vec3": 3, "vec4": 4}  # numbers of what is evaluated point by point
ALWAYS = "#"  # what #if, #else and #endif count as: they are never left out
COMMENT = re.compile(r"/\*.*?\*/|//[^\n]*", re.S)


@dataclass(frozen=True)
class Line:
    text: str
    file: str
    number: int


@dataclass(frozen=True)
class Include:
    name: str
    number: int  # of its line


@dataclass(frozen=True)
class Source:
    """A text a person wrote somewhere else than below glsl/: a lesson's scene, a student's file."""

    text: str
    file: str
    first: int = 1


Overrides = tuple[tuple[str, Source], ...]  # (what #include names, what is read in its place), in order of names


@dataclass(frozen=True)
class Block:
    """A top-level declaration: its lines, what it names and which words it uses."""

    lines: tuple[Line, ...]
    names: frozenset[str]
    words: frozenset[str]
    is_function: bool


@dataclass(frozen=True)
class Assembled:
    text: str
    lines: tuple[Line, ...]  # of the text after the header
    header: int  # lines of the header
    files: tuple[str, ...]  # included files of which something was kept
    idle: tuple[str, ...]  # included files of which nothing is used
    kept: tuple[str, ...]  # functions
    left_out: tuple[str, ...]  # functions of the included files that nothing calls


@dataclass(frozen=True)
class Argument:
    type: str
    name: str
    size: str = ""  # of an array


@dataclass(frozen=True)
class Signature:
    name: str
    returns: str
    args: tuple[Argument, ...]


@cache
def read(name: str) -> str:
    """The text of an included file below glsl/."""
    path = GLSL / name
    if not path.resolve().is_relative_to(GLSL) or not path.is_file():
        known = [p.relative_to(GLSL).as_posix() for p in GLSL.rglob("*.*")]
        raise Problem(f'there is no glsl/{name}.{near(name, known)}')
    return path.read_text(encoding="utf-8")


def resolve(text: str, file: str, first: int = 1, overrides: dict[str, Source] | None = None) -> list[Line]:
    """The lines of a text with its includes put in, depth first, each file once."""
    done: set[str] = set()

    def walk(text: str, file: str, first: int, path: tuple[str, ...]) -> list[Line]:
        lines: list[Line] = []
        for piece in pieces(text, file, first):
            if not isinstance(piece, Include):
                lines += piece
                continue
            name, where = piece.name, f"{file}, line {piece.number}"
            if name in path:
                raise Problem(f"{where}: a circle of includes: {' -> '.join((*path, name))}.")
            if name in done:
                continue
            try:
                inner = (overrides or {}).get(name) or Source(read(name), f"glsl/{name}")
            except Problem as problem:
                raise Problem(f"{where}: {problem}") from None
            lines += walk(inner.text, inner.file, inner.first, (*path, name))
            done.add(name)
        return lines

    return walk(text, file, first, ())


@lru_cache(1024)
def pieces(text: str, file: str, first: int) -> tuple[tuple[Line, ...] | Include, ...]:
    """A text's lines, with the includes between them; kept, because a scene's programs read the same texts."""
    found: list[tuple[Line, ...] | Include] = []
    lines: list[Line] = []
    written = text.split("\n")
    for number, (line, code) in enumerate(zip(written, strip_comments(written), strict=True), first):
        if match := INCLUDE.match(code):
            found += [tuple(lines), Include(match[1], number)]
            lines = []
        elif code.lstrip().startswith("#include"):
            raise Problem(f'{file}, line {number}: {code.strip()} is not like #include "optics/cone.glsl".')
        else:
            lines.append(Line(line, file, number))
    return (*found, tuple(lines))


def blocks(lines: list[Line]) -> list[Block]:
    """Cut lines into top-level declarations: each ends where a ';' or '}' stands outside all braces."""
    found: list[Block] = []
    rest: tuple[Line, ...] = ()
    for _, run in groupby(lines, lambda line: line.file):
        made, rest = cut(tuple(run))
        if has_code(rest):  # it goes on in an included file
            whole, rest = cut(tuple(lines))
            found = [*whole]
            break
        found += made
    if has_code(rest):
        found.append(closed(rest))
    return found


@lru_cache(4096)
def cut(lines: tuple[Line, ...]) -> tuple[tuple[Block, ...], tuple[Line, ...]]:
    """The whole declarations, and the lines after the last of them."""
    found: list[Block] = []
    open_lines: list[Line] = []
    depth = 0
    for line, code in zip(lines, strip_comments([line.text for line in lines]), strict=True):
        if open_lines and line.file != open_lines[-1].file and not has_code(open_lines):
            open_lines = []  # remarks at the end of a file belong to nothing in the next
        open_lines.append(line)
        depth += code.count("{") - code.count("}")
        if depth < 0:
            raise Problem(f"{line.file}, line {line.number}: a }} that closes nothing.")
        whole = code.rstrip()
        directive = whole.lstrip().startswith("#") or (bool(open_lines[:-1]) and open_lines[-2].text.endswith("\\"))
        if depth == 0 and (whole.endswith((";", "}")) or directive) and not whole.endswith("\\"):
            found.append(block(open_lines))
            open_lines = []
    return tuple(found), tuple(open_lines)


def closed(lines: Sequence[Line]) -> Block:
    """What a text ends with, which no ';' or '}' needs to end."""
    depth, brace = 0, lines[0]
    for line, code in zip(lines, strip_comments([line.text for line in lines]), strict=True):
        if depth == 0 and "{" in code:
            brace = line
        depth += code.count("{") - code.count("}")
    if depth:
        raise Problem(f"{brace.file}, line {brace.number}: a {{ that is never closed.")
    return block(lines)


def has_code(lines: Sequence[Line]) -> bool:
    return any(code.strip() for code in strip_comments([line.text for line in lines]))


def strip_comments(lines: list[str]) -> list[str]:
    text = COMMENT.sub(lambda m: "\n" * m[0].count("\n"), "\n".join(lines))
    return text.split("\n")


def block(lines: Sequence[Line]) -> Block:
    code = "\n".join(strip_comments([line.text for line in lines])).strip()
    words = frozenset(WORD.findall(code))
    function = SIGNATURE.search(code)
    if function:
        return Block(tuple(lines), frozenset({function[2]}), words, True)
    if code.startswith("struct"):
        behind = WORD.findall(code.rpartition("}")[2])
        return Block(tuple(lines), frozenset([*WORD.findall(code)[1:2], *behind]), words, False)
    if code.startswith("#"):
        names = WORD.findall(code)[1:2] if code[1:].lstrip().startswith("define") else [ALWAYS]
        return Block(tuple(lines), frozenset(names), words, False)
    return Block(tuple(lines), declared(code), words, False)


def declared(code: str) -> frozenset[str]:
    """The names a declaration of variables makes: each stands before '=', '[', ',' or ';', outside all brackets."""
    code = re.sub(r"^layout\s*\([^)]*\)", "", code)
    if "{" in code and "=" not in code:  # an interface block: it is wanted for any of its members
        return frozenset(re.findall(r"(\w+)\s*(?:\[[^\]]*\])?\s*[;,]", code))
    before = None
    while before != code:  # what stands in brackets declares nothing
        before, code = code, re.sub(r"\([^()]*\)|\[[^\[\]]*\]|\{[^{}]*\}", "", code)
    parts = (part.partition("=")[0].split() for part in re.split("[,;]", code))
    return frozenset(words[-1] for words in parts if words)


def assemble(text: str, file: str, *, first: int = 1, header: tuple[str, ...] = DESKTOP,
             entry: tuple[str, ...] = ("main",), overrides: dict[str, Source] | None = None) -> Assembled:
    """The text to compile: header, then every declaration that `entry` can reach, in the order written."""
    parts = blocks(resolve(text, file, first, overrides))
    wanted, queue = {*entry, ALWAYS}, [*entry, ALWAYS]
    by_name: dict[str, list[Block]] = {}
    for part in parts:
        for name in part.names:
            by_name.setdefault(name, []).append(part)
    while queue:
        for part in by_name.get(queue.pop(), ()):
            for word in part.words - wanted:
                wanted.add(word)
                queue.append(word)
    kept = [part for part in parts if part.names & wanted]
    lines = tuple(line for part in kept for line in part.lines)
    used = {line.file for line in lines}
    named = {line.file for part in parts for line in part.lines}
    names = [next(iter(p.names)) for p in kept if p.is_function]
    out = [next(iter(p.names)) for p in parts if p.is_function and not p.names & wanted and p.lines[-1].file != file]
    return Assembled("\n".join((*header, *(line.text for line in lines))) + "\n", lines, len(header),
                     tuple(sorted(used - {file})), tuple(sorted(named - used - {file})),
                     tuple(dict.fromkeys(names)), tuple(dict.fromkeys(out)))


def translate(message: str, assembled: Assembled) -> str:
    """A compiler's message with its line numbers turned back into the file and line a person wrote."""
    found = []
    for raw in message.splitlines():
        match = MESSAGE.match(raw)
        if not match:
            continue
        number = int(match[1]) - assembled.header - 1
        if number >= 0 and assembled.lines:
            line = assembled.lines[min(number, len(assembled.lines) - 1)]  # the end of the text is behind its last line
            found.append(f"{line.file}, line {line.number}: {match[3]}")
    return "\n".join(dict.fromkeys(found)) or message.strip()


def signatures(text: str) -> dict[str, Signature]:
    """The functions a GLSL text defines, by name."""
    code = "\n".join(strip_comments(text.split("\n")))
    found = {}
    for returns, name, inside, end in SIGNATURE.findall(code):
        matches = (PARAMETER.fullmatch(part.strip()) for part in inside.split(","))
        args = tuple(Argument(m[1], m[3], m[2] or m[4] or "") for m in matches if m)
        if end == "{":
            found[name] = Signature(name, returns, args)
    return found


@cache
def catalogue() -> dict[str, tuple[str, Signature]]:
    """Every function of glsl/optics: name -> (include, signature)."""
    found: dict[str, tuple[str, Signature]] = {}
    for path in sorted((GLSL / "optics").glob("*.glsl")):
        include = path.relative_to(GLSL).as_posix()
        for name, signature in signatures(path.read_text(encoding="utf-8")).items():
            found[name] = include, signature
    return found


def uniforms(text: str) -> dict[str, str]:
    """The uniforms a text declares: name -> type."""
    code = "\n".join(strip_comments(text.split("\n")))
    found = re.findall(r"^\s*uniform\s+(?:(?:highp|mediump|lowp)\s+)?(\w+)\s+([^;{]*);", code, re.M)
    return {part.split("[")[0].strip(): kind for kind, names in found for part in names.split(",")}


def file_name(path: Path) -> str:
    """How a lesson's file is named to a person: lessons/ch01_solid_angle.py."""
    return f"{path.parent.name}/{path.name}"
