"""Reads a `.brdf` file as Disney's BRDF explorer writes them: parameters, and a GLSL function BRDF.

    analytic
    ::begin parameters
    float roughness 0.01 1 0.3      # name, least, most, default
    bool include_F 1
    color base .8 .6 .2
    ::end parameters
    ::begin shader
    vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { ... }
    ::end shader

A `#` begins a remark, but not inside the shader. Further blocks are let be. L and V go to light and eye, N is the
normal, X runs along growing azimuth about the picture's upward direction (app/brush.py), and Y is N x X.
"""

import math
import re
from dataclasses import dataclass
from pathlib import Path
from typing import Literal, NoReturn

from app import shader
from app.problem import Problem

LARGEST = 1 << 20  # bytes; the largest one known has 5000
NEEDED = "vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y)"
KINDS = {"float": 3, "bool": 1, "color": 3}  # numbers behind the name
NAME = re.compile(r"(?!gl_)[A-Za-z]\w*", re.A)
KEYWORDS = {  # of GLSL, the likely ones
    "bool", "int", "uint", "float", "double", "half", "void", "vec2", "vec3", "vec4", "ivec2", "ivec3", "ivec4",
    "mat2", "mat3", "mat4", "true", "false", "if", "else", "for", "while", "do", "switch", "case", "default",
    "break", "continue", "return", "discard", "struct", "const", "uniform", "attribute", "varying", "in", "out",
    "inout", "layout"}
REFUSED = re.compile(r"\s*#\s*(include|version|extension)\b")
WHY = {"include": "a .brdf file stands alone, with all its text in it", "version": "it is read as GLSL 3.30",
       "extension": "it is read as GLSL 3.30, which has to do without"}
Default = float | bool | tuple[float, float, float]


@dataclass(frozen=True)
class Parameter:
    name: str
    type: str  # "float", "bool" or "color"
    low: float
    high: float
    default: Default
    line: int  # of the file; 0: of no file
    scale: Literal["linear", "log"] = "linear"
    unit: str = ""
    whole: bool = False

    @property
    def glsl(self) -> str:
        return {"float": "float", "bool": "bool", "color": "vec3"}[self.type]


@dataclass(frozen=True)
class BrdfFile:
    path: str  # as the user gave it
    name: str
    parameters: tuple[Parameter, ...]
    shader: shader.Source
    warnings: tuple[str, ...] = ()

    @property
    def defaults(self) -> dict[str, Default]:
        return {p.name: p.default for p in self.parameters}


def read(path: str | Path) -> BrdfFile:
    """The file; what is wrong with it is a Problem that names its line."""
    path = Path(path)
    try:
        with path.open("rb") as file:
            raw = file.read(LARGEST + 1)
    except OSError as error:
        raise Problem(f"{path}: {error.strerror}.") from None
    if len(raw) > LARGEST:
        raise Problem(f"{path} is larger than a megabyte; a .brdf file is a page of text.")
    if b"\0" in raw:
        raise Problem(f"{path} is not text; a .brdf file is.")
    try:
        text = raw.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = raw.decode("latin-1")
    return parse(text, str(path))


def parse(text: str, path: str) -> BrdfFile:
    lines = text.replace("\r\n", "\n").replace("\r", "\n").split("\n")
    first = next((i for i, line in enumerate(lines) if bare(line)), None)
    if first is None:
        raise Problem(f"{path} is empty; a .brdf file begins with the word analytic.")
    if bare(lines[first]) != "analytic":
        raise Problem(f"{path}, line {first + 1}: “{shown(lines[first])}”; a .brdf file begins with the word analytic.")
    blocks = cut(lines, first + 1, path)
    if "shader" not in blocks:
        raise Problem(f"{path} has no ::begin shader; its GLSL stands between that line and ::end shader.")
    parameters, warnings = read_parameters(lines, *blocks.get("parameters", (0, 0)), path)
    begin, end = blocks["shader"]
    source = shader.Source("\n".join(lines[begin:end]), path, begin + 1)
    for number, line in enumerate(shader.strip_comments(source.text.split("\n")), source.first):
        if refused := REFUSED.match(line):
            raise Problem(f"{path}, line {number}: “{shown(line)}”; {WHY[refused[1]]}.")
    functions = shader.signatures(source.text)
    for p in parameters:
        if p.name in functions:
            raise Problem(f"{path}, line {p.line}: {p.name} is a function of its shader too; one of them needs "
                          "another name.")
    found = functions.get("BRDF")
    if not found or found.returns != "vec3" or [a.type for a in found.args] != ["vec3"] * 5:
        raise Problem(f"{path}, line {begin + 1}: the shader defines no {NEEDED}.")
    return BrdfFile(path, Path(path).stem, parameters, source, warnings)


def cut(lines: list[str], first: int, path: str) -> dict[str, tuple[int, int]]:
    """The blocks of the file: name -> its lines from, up to."""
    found: dict[str, tuple[int, int]] = {}
    open_name, begun = "", 0
    for i in range(first, len(lines)):
        words = lines[i].split()
        where = f"{path}, line {i + 1}"
        if words[:1] == ["::begin"]:
            if open_name:
                raise Problem(f"{where}: ::begin inside the block {open_name}, which line {begun} began.")
            if len(words) < 2:
                raise Problem(f"{where}: ::begin wants a name, as in ::begin shader.")
            open_name, begun = words[1], i + 1
            if open_name in found:
                raise Problem(f"{where}: the block {open_name} is there twice; line {found[open_name][0]} began it.")
        elif words[:1] == ["::end"]:
            if words[1:2] != [open_name]:
                raise Problem(f"{where}: “{shown(lines[i])}” ends no open block"
                              + (f"; ::end {open_name} would." if open_name else "."))
            found[open_name] = begun, i
            open_name = ""
        elif not open_name and bare(lines[i]):
            raise Problem(f"{where}: “{shown(lines[i])}” stands outside the blocks; a remark begins with #.")
    if open_name:
        raise Problem(f"{path}, line {begun}: the block {open_name} has no ::end {open_name}.")
    return found


def read_parameters(lines: list[str], begin: int, end: int, path: str) -> tuple[tuple[Parameter, ...], tuple[str, ...]]:
    found: dict[str, Parameter] = {}
    warnings: list[str] = []
    for i in range(begin, end):
        words = bare(lines[i]).split()
        if not words:
            continue
        one = read_parameter(words, i + 1, f"{path}, line {i + 1}", warnings)
        if one.name in found:
            raise Problem(f"{path}, line {i + 1}: {one.name} is there twice; line {found[one.name].line} has it too.")
        found[one.name] = one
    return tuple(found.values()), tuple(warnings)


def read_parameter(words: list[str], line: int, where: str, warnings: list[str]) -> Parameter:
    def wrong(what: str) -> NoReturn:
        raise Problem(f"{where}: {what}")

    kind = words[0]
    if kind not in KINDS:
        wrong(f"there is no type {kind}; it can be {', '.join(KINDS)}.")
    form = {"float": "float name least most default", "bool": "bool name 0 or 1", "color": "color name r g b"}[kind]
    if len(words) != 2 + KINDS[kind]:
        wrong(f"{len(words)} words; it is written {form}.")
    name = words[1]
    if not NAME.fullmatch(name) or "__" in name or name in KEYWORDS:
        wrong(f"{name} can be no name in GLSL.")
    numbers = []
    for word in words[2:]:
        try:
            number = float(word)
        except ValueError:
            number = math.nan
        if not math.isfinite(number):
            wrong(f"{word} is no number; it is written {form}.")
        numbers.append(number)
    if kind == "bool":
        return Parameter(name, kind, 0.0, 1.0, bool(numbers[0]), line)
    if kind == "color":
        return Parameter(name, kind, 0.0, 1.0, (numbers[0], numbers[1], numbers[2]), line)
    low, high, default = numbers
    if low > high:
        wrong(f"{name} runs from {low:g} to {high:g}; the least comes first.")
    if not low <= default <= high:
        warnings.append(f"{where}: the default {default:g} of {name} lies outside {low:g} to {high:g}; "
                        "the slider reaches it all the same.")
        low, high = min(low, default), max(high, default)
    return Parameter(name, kind, low, high, default, line)


def bare(line: str) -> str:
    """A line without its remark."""
    return line.partition("#")[0].strip()


def shown(line: str) -> str:
    """A line short enough for a sentence."""
    line = line.strip()
    return line if len(line) <= 40 else line[:39] + "…"
