"""Shader text: a scene's includes and functions put together, without what nothing calls. Pure text, no GL.

`assemble` follows `#include "optics/cone.glsl"` lines depth first, each file once, keeps only the declarations that can
be reached from the entry points, and remembers the (file, line) of every line so that `translate` can turn a compiler's
message back to what a person wrote.
"""

import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache, cached_property, lru_cache
from itertools import groupby
from pathlib import Path
from typing import Any

from app import loops
from app.paths import GLSL
from app.problem import Problem, near

DESKTOP = ("#version 330 core",)
WEB = ("#version 300 es", "precision highp float;", "precision highp int;", "precision highp sampler2D;")
INCLUDE = re.compile(r'^\s*#include\s+"([^"]+)"\s*$')
SIGNATURE = re.compile(r"^[ \t]*(?:(?:highp|mediump|lowp)\s+)?(?!else\b|return\b)(\w+)(?:\s*\[\w*\])?\s+(\w+)\s*"
                       r"\(([^)]*)\)\s*(\{|;)", re.M)
PARAMETER = re.compile(r"(?:(?:const|in|out|inout|highp|mediump|lowp)\s+)*(\w+)\s*(?:\[\s*(\w+)\s*\])?\s+"
                       r"(\w+)\s*(?:\[\s*(\w+)\s*\])?")
WORD = re.compile(r"[A-Za-z_]\w*")
MESSAGE = re.compile(r"^\s*(?:ERROR:\s*)?\d+[:(](\d+)\)?(?:\((\d+)\))?\s*:?\s*(.*)$")
CONDITION = re.compile(r"^\s*#\s*(if|ifdef|ifndef|endif)\b", re.M)
WIDTH = {"float": 1, "int": 1, "vec2": 2, "vec3": 3, "vec4": 4}  # numbers of what is evaluated point by point
ALWAYS = "#"  # what #if, #else and #endif count as: they are never left out
COMMENT = re.compile(r"/\*.*?\*/|//[^\n]*", re.S)


@dataclass(frozen=True)
class Line:
    text: str
    file: str
    number: int


@dataclass(frozen=True)
class Source:
    """A text a person wrote somewhere else than below glsl/: a lesson's scene, a student's file."""

    text: str
    file: str
    first: int = 1
    is_own: bool = False  # not the course's: its loops are counted, and left after too many turns


@dataclass(frozen=True)
class Include:
    name: str
    number: int  # its line


Overrides = tuple[tuple[str, Source], ...]  # (what #include names, what is read in its place), in order of names


@dataclass(frozen=True, eq=False)
class Block:
    """A top-level declaration: its lines, what it names and which words it uses. A file's are made once."""

    lines: tuple[Line, ...]
    names: frozenset[str]
    words: frozenset[str]
    is_function: bool

    @cached_property
    def name(self) -> str:
        """Of a function."""
        return min(self.names - {ALWAYS}, default="")


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
    return walk(lines_of, Source(text, file, first), overrides or {})


def declarations(text: str, file: str, first: int = 1, overrides: dict[str, Source] | None = None) -> list[Block]:
    """The same as top-level declarations; a file's own are cut once, however many programs include it."""
    return walk(blocks_of, Source(text, file, first), overrides or {})


def walk(read_in: Callable[[Source], tuple[Any, ...]], source: Source, overrides: dict[str, Source]) -> list[Any]:
    done: set[str] = set()
    found: list[Any] = []

    def inside(source: Source, path: tuple[str, ...]) -> None:
        for part in read_in(source):
            if not isinstance(part, Include):
                found.append(part)
                continue
            name, where = part.name, f"{source.file}, line {part.number}"
            if name in path:
                raise Problem(f"{where}: a circle of includes: {' -> '.join((*path, name))}.")
            if name in done:
                continue
            try:
                inner = overrides.get(name) or Source(read(name), f"glsl/{name}")
            except Problem as problem:
                raise Problem(f"{where}: {problem}") from None
            inside(inner, (*path, name))
            done.add(name)

    inside(source, ())
    return found


@lru_cache(512)
def lines_of(source: Source) -> tuple[Line | Include, ...]:
    found: list[Line | Include] = []
    text = loops.guarded(source.text, source.file, source.first) if source.is_own else source.text
    if text != source.text:
        found.append(Include(loops.COUNTED, source.first))
    written = text.split("\n")
    for number, (line, code) in enumerate(zip(written, strip_comments(written), strict=True), source.first):
        if match := INCLUDE.match(code):
            found.append(Include(match[1], number))
        elif code.lstrip().startswith("#include"):
            raise Problem(f'{source.file}, line {number}: {code.strip()} is not like #include "optics/cone.glsl".')
        else:
            found.append(Line(line, source.file, number))
    return tuple(found)


@lru_cache(512)
def blocks_of(source: Source) -> tuple[Block | Include, ...]:
    """Includes stand between declarations."""
    found: list[Block | Include] = []
    for included, group in groupby(lines_of(source), lambda part: isinstance(part, Include)):
        run = list(group)
        found += run if included else blocks(run)  # type: ignore[arg-type]
    return tuple(found)


def blocks(lines: list[Line]) -> list[Block]:
    """Cut lines into top-level declarations: each ends where a ';' or '}' stands outside all braces."""
    found: list[Block] = []
    open_lines: list[Line] = []
    depth, brace = 0, None
    for line, code in zip(lines, strip_comments([line.text for line in lines]), strict=True):
        open_lines.append(line)
        if depth == 0 and "{" in code:
            brace = line
        depth += code.count("{") - code.count("}")
        if depth < 0:
            raise Problem(f"{line.file}, line {line.number}: a }} that closes nothing.")
        whole = code.rstrip()
        directive = whole.lstrip().startswith("#") or (bool(open_lines[:-1]) and open_lines[-2].text.endswith("\\"))
        if depth == 0 and (whole.endswith((";", "}")) or directive) and not whole.endswith("\\"):
            found.append(block(open_lines))
            open_lines = []
    if depth and brace:
        raise Problem(f"{brace.file}, line {brace.number}: a {{ that is never closed.")
    if has_code(open_lines):
        found.append(block(open_lines))
    return conditional(found)


def conditional(found: list[Block]) -> list[Block]:
    """The same; what stands between #if and #endif, outside functions, is never left out: no one knows what is needed
    of it, and where its declarations end."""
    kept, depth = [], 0
    for part in found:
        was, starts = depth, CONDITION.findall("\n".join(line.text for line in part.lines))
        depth += sum(1 if start.startswith("if") else -1 if start == "endif" else 0 for start in starts)
        inside = max(was, depth) > 0
        kept.append(replace(part, names=part.names | {ALWAYS}) if inside else part)
    return kept


def has_code(lines: list[Line]) -> bool:
    return any(code.strip() for code in strip_comments([line.text for line in lines]))


def strip_comments(lines: list[str]) -> list[str]:
    text = COMMENT.sub(lambda m: "\n" * m[0].count("\n"), "\n".join(lines))
    return text.split("\n")


def block(lines: list[Line]) -> Block:
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
             entry: tuple[str, ...] = ("main",), overrides: dict[str, Source] | None = None,
             shorten: Callable[[list[Block]], list[Block]] | None = None) -> Assembled:
    """The text to compile: header, then every declaration that `entry` can reach, in the order written; of what
    `shorten` leaves of them."""
    found = declarations(text, file, first, overrides)
    found = shorten(found) if shorten else found
    wanted, queue = {*entry, ALWAYS}, [*entry, ALWAYS]
    by_name: dict[str, list[Block]] = {}
    for part in found:
        for name in part.names:
            by_name.setdefault(name, []).append(part)
    while queue:
        for part in by_name.get(queue.pop(), ()):
            for word in part.words - wanted:
                wanted.add(word)
                queue.append(word)
    kept = [part for part in found if part.names & wanted]
    lines = tuple(line for part in kept for line in part.lines)
    used = {line.file for line in lines}
    named = {line.file for part in found for line in part.lines}
    names = [p.name for p in kept if p.is_function]
    out = [p.name for p in found if p.is_function and not p.names & wanted and p.lines[-1].file != file]
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


@lru_cache(256)
def uniforms(text: str) -> dict[str, str]:
    """The uniforms a text declares: name -> type."""
    code = "\n".join(strip_comments(text.split("\n")))
    found = re.findall(r"^\s*uniform\s+(?:(?:highp|mediump|lowp)\s+)?(\w+)\s+([^;{]*);", code, re.M)
    return {part.split("[")[0].strip(): kind for kind, names in found for part in names.split(",")}


def file_name(path: Path) -> str:
    """How a lesson's file is named to a person: lessons/ch01_solid_angle.py."""
    return f"{path.parent.name}/{path.name}"
