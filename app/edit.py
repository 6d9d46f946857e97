"""GLSL edited live: the functions of a step that may be, what a text of one's own puts in their place, whether it fits.

Pure text, no GL. A text stands in the place of one function; all else of its file stays, with its line numbers. Texts
travel among a step's values (`values[EDITED]`) to whatever evaluates a twin: readouts, badges, the plots' process.
"""

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, fields, replace
from functools import cache, lru_cache
from importlib import import_module

from app import shader
from app.catalog import LoadedStep, terms
from app.gpu.stage_text import Source, programs
from app.lesson import Plot, Term
from app.problem import Problem
from app.prose import links
from app.shader import WIDTH, Overrides, Signature

EDITED = "edited"  # among a step's values: Overrides
YOURS = "your "  # how a text is named to a person, before its function's name
CODE = "code:"  # how a link of the prose leads to a function
SCENE = "scene"  # the include of a scene's own text
COURSE = ("optics/", "core/", "display/")  # of glsl/: formulas and their helpers; glsl/stage is machinery
MESSAGE = re.compile(rf"^{YOURS}(\w+), line (\d+): (.*)$", re.M)
LONGEST = 20_000  # characters of a text


@dataclass(frozen=True)
class Function:
    """A function as it stands in the course, with the remarks before it."""

    name: str
    include: str  # what #include names: optics/beckmann.glsl, or scene
    file: str  # as a person is told
    first: int  # its first line there
    text: str

    @property
    def signature(self) -> Signature:
        return shader.signatures(self.text)[self.name]


@lru_cache(256)
def functions(found: LoadedStep) -> dict[str, Function]:
    """What may be edited: the scene's own functions, then those of glsl/ that the scene, a model or a number needs."""
    return functions_of(source_of(found), (term.function for _, term, _ in terms(found.step)))


def source_of(found: LoadedStep) -> Source:
    choices = tuple(name for name, value in found.values.items() if value.choices)
    return Source(found.step.scene, found.file_name, found.glsl_line, choices=choices)


def functions_of(source: Source, called: Iterable[str] = ()) -> dict[str, Function]:
    own = [shader.Line(text, source.file, i) for i, text in enumerate(source.scene.glsl.split("\n"), source.first)]
    made = [part for pair in programs(source.scene, source.file, source.first).values() for part in pair if part]
    made += [alone(name) for name in dict.fromkeys(called) if name in shader.catalogue()]
    compiled = {name for one in made for name in one.kept}
    files = dict.fromkeys(file for one in made for file in one.files)
    found = written(own, SCENE, compiled)
    for one in source.scene.texts:  # a user's model on the board
        lines = [shader.Line(line, one.file, i) for i, line in enumerate(one.text.split("\n"), one.first)]
        found |= written(lines, one.name, compiled)
    for include in (file.removeprefix("glsl/") for file in files):
        if include.startswith(COURSE):
            text = shader.read(include).split("\n")
            lines = [shader.Line(line, f"glsl/{include}", i) for i, line in enumerate(text, 1)]
            found = written(lines, include, compiled) | found
    with_body = [name for name, one in found.items() if name in shader.signatures(one.text)]  # a break leaves a head
    return {name: found[name] for name in sorted(with_body, key=lambda name: found[name].include != SCENE)}


def written(lines: list[shader.Line], include: str, wanted: set[str]) -> dict[str, Function]:
    """The wanted functions among the lines of one text."""
    found = {}
    for part in shader.blocks(lines):
        name = part.name
        if part.is_function and name in wanted:
            kept = list(part.lines)
            while not kept[0].text.strip():
                kept.pop(0)
            found[name] = Function(name, include, kept[0].file, kept[0].number, "\n".join(line.text for line in kept))
    return found


@cache
def alone(function: str) -> shader.Assembled:
    """A twin with all it calls."""
    include, _ = shader.catalogue()[function]
    return shader.assemble(f'#include "{include}"', function, entry=(function,))


def spoken_of(found: LoadedStep) -> list[str]:
    """The functions that the prose leads to, then those of the step's models."""
    linked = [link.target.removeprefix(CODE) for link in links(found.step.prose) if link.target.startswith(CODE)]
    return list(dict.fromkeys([*linked, *(model.term.function for model in found.step.models)]))


# --- a text in the place of a function -------------------------------------------------------------------------------
def overrides(texts: Mapping[str, str], known: Mapping[str, Function], source: Source) -> Overrides:
    """What `assemble` reads in place of the course's files. A file's other lines keep their numbers."""
    found: dict[str, shader.Source] = {}
    for name, text in sorted(texts.items()):
        function = known[name]
        whole = found.get(function.include) or included(function, source)
        lines = whole.text.split("\n")
        at, count = function.first - whole.first, function.text.count("\n") + 1
        lines[at:at + count] = [f'#include "{YOURS}{name}"', *[""] * (count - 1)]
        found[function.include] = replace(whole, text="\n".join(lines))
        found[YOURS + name] = shader.Source(text, YOURS + name, is_own=True)
    return tuple(sorted(found.items()))


def included(function: Function, source: Source) -> shader.Source:
    """The whole text that a function stands in."""
    for one in source.scene.texts:
        if one.name == function.include:
            return shader.Source(one.text, one.file, one.first, is_own=True)
    if function.include == SCENE:
        return shader.Source(source.scene.glsl, source.file, source.first)
    return shader.Source(shader.read(function.include), function.file)


def among_values(texts: Mapping[str, str], known: Mapping[str, Function], source: Source) -> dict[str, Overrides]:
    """What values carry: the texts of glsl/; a scene's own functions are nothing that a number is made of."""
    twins = {name: text for name, text in texts.items() if known[name].include != SCENE}
    return {EDITED: overrides(twins, known, source)} if texts else {}


def check(text: str, function: Function) -> None:
    """What the compiler would say late or at another's line: a Problem at the user's own."""
    where = YOURS + function.name
    if len(text) > LONGEST:
        raise Problem(f"{where}, line 1: {len(text)} characters; {LONGEST} is the most.")
    lines = [shader.Line(line, where, i) for i, line in enumerate(text.split("\n"), 1)]
    for line, code in zip(lines, shader.strip_comments(text.split("\n")), strict=True):
        if "/*" in code:
            raise Problem(f"{where}, line {line.number}: a remark that is never closed.")
    parts = shader.blocks(lines)
    for part in parts:
        if part.words >= {"uniform"}:
            raise Problem(f"{where}, line {part.lines[-1].number}: a uniform of one's own; nothing would set it.")
    given, wanted = shader.signatures(text).get(function.name), function.signature
    if given is None:
        raise Problem(f"{where}, line 1: {function.name} is not defined any more; it is {declared(wanted)}.")
    if kinds(given) != kinds(wanted):
        at = next(line.number for line, code in zip(lines, shader.strip_comments(text.split("\n")), strict=True)
                  if re.search(rf"\b{function.name}\s*\(", code))
        raise Problem(f"{where}, line {at}: others call {declared(wanted)}; its types must stay.")


def kinds(signature: Signature) -> tuple:
    return signature.returns, *((a.type, a.size) for a in signature.args)


def declared(signature: Signature) -> str:
    args = ", ".join(f"{a.type} {a.name}{f'[{a.size}]' if a.size else ''}" for a in signature.args)
    return f"{signature.returns} {signature.name}({args})"


def first_complaint(problem: str, function: str) -> str:
    """What a compiler says of a function's text first, without its words around it: the rest follows from that."""
    found = complaints(problem, function)
    return f"line {found[0][0]}: {found[0][1]}" if found else problem


def complaints(problem: str, function: str) -> list[tuple[int, str]]:
    """(line, sentence) of what is said of this function's text."""
    return [(int(line), words.removeprefix("error: ")) for name, line, words in MESSAGE.findall(problem)
            if name == function]


def marked(plot: Plot, edits: Overrides) -> Plot:
    """The plot, "yours" behind the labels of what is made of the texts; the same where nothing is."""

    def one(part):
        if isinstance(part, tuple):
            return tuple(map(one, part))
        mine = isinstance(getattr(part, "term", None), Term) and follows(part.term.function, edits)
        return replace(part, label=f"{part.label}, yours") if mine else part

    parts = {f.name: getattr(plot, f.name) for f in fields(plot)}
    return replace(plot, **{name: one(part) for name, part in parts.items() if isinstance(part, tuple)})


# --- who follows -----------------------------------------------------------------------------------------------------
@lru_cache(1024)
def follows(function: str, edits: Overrides) -> bool:
    """Whether a twin is made of one of the texts: then its GLSL is evaluated, in float32."""
    if ":" in function:  # a model of the board
        return bool(edits) and import_module("app.board.edited").is_edited(function.partition(":")[2], edits)
    if not edits or function not in shader.catalogue():
        return False
    signature, mine = shader.catalogue()[function][1], {name.removeprefix(YOURS) for name, _ in edits}
    can_be = signature.returns in WIDTH and all(a.type in (*WIDTH, "sampler2D") for a in signature.args)
    return can_be and not mine.isdisjoint(alone(function).kept)
