"""Texts of an assignment's functions: the stub a student starts from, the solution, and the catalogued wrong ones."""

import ast
import textwrap
import tomllib
from dataclasses import dataclass
from functools import cache

from app import shader
from app.grade.assignment import FOLDER, Task
from app.grade.question import Language
from app.problem import Problem
from app.quantities import TABLE, quantity

KINDS = {1: "float", 2: "vec2", 3: "vec3", 4: "vec4"}


@dataclass(frozen=True)
class Mutant:
    """A wrong text of a function in one language."""

    function: str
    name: str
    language: Language
    text: str
    misconception: str = ""  # what the student must be told


@cache
def solutions() -> dict[str, dict[str, str]]:
    return tomllib.loads((FOLDER / "solutions.toml").read_text("utf-8"))


def solution(task: Task, language: str) -> str:
    """A text that passes; GLSL without includes."""
    known = task.exercise.solutions if task.exercise else solutions().get(task.function)
    if known is None:
        raise Problem(f"there is no solution of {task.function}; write one into {FOLDER.name}/solutions.toml.")
    return known[language] if language == "python" else standalone(known[language], task.function)


def stub(task: Task, language: str) -> str:
    """A text to begin with: it runs, and is wrong."""
    if task.exercise:
        given = task.exercise.stubs[language]
        return given if language == "python" else standalone(given, task.function, helpers=True)
    if language == "python":
        many = f"(len({task.arguments[0]}), {task.width})" if task.width > 1 else f"len({task.arguments[0]})"
        head = f"def {task.function}({', '.join(task.arguments)}):"
        return f"import numpy as np\n\n\n{head}\n    return np.zeros({many})\n"
    signature = ", ".join(f"{KINDS[width]} {name}" for name, width in zip(task.arguments, task.widths, strict=True))
    kind = KINDS[task.width]
    zero = "0.0" if task.width == 1 else f"{kind}(0.0)"
    return f"{kind} {task.function}({signature}) {{\n    return {zero};\n}}\n"


def units(task: Task) -> str:
    """What every argument is, and its unit."""
    return "; ".join(f"{name}: {meaning(name, width)}" for name, width
                     in zip(task.arguments, task.widths, strict=True)) + "."


def meaning(name: str, width: int) -> str:
    if name not in TABLE:
        return f"{width} numbers" if width > 1 else "a number"
    q = quantity(name)
    return q.words + (f", in {q.unit}" if q.unit else "")


def wrapped(text: str, before: str, after: str = "") -> list[str]:
    return textwrap.wrap(text, 110, initial_indent=before, subsequent_indent=after or before)


def joined(parts: list[tuple[str, str]], language: str) -> str:
    """Several functions' texts as one: imports once and first, what is the same in two of them only once."""
    kept: list[str] = []
    if language == "glsl":
        for _, text in parts:
            for one in blocks(text.rstrip()).values():
                if one not in kept:
                    kept.append(one)
        return "\n\n".join(kept) + "\n"
    imports: list[str] = []
    for _, text in parts:
        lines = text.strip("\n").split("\n")
        imports += [line for line in lines if imported(line) and line not in imports]
        kept.append("\n".join(line for line in lines if not imported(line)).strip("\n"))
    return "\n".join(imports) + "\n\n\n" + "\n\n\n".join(kept) + "\n"


def imported(line: str) -> bool:
    return line.startswith(("import ", "from "))


def declares(text: str, language: str) -> dict[str, str]:
    """The names a text declares at its top, each with its own text: two texts may share what is the same in both."""
    if language == "python":
        found: dict[str, str] = {}
        for node in ast.parse(text).body:
            names = [node.name] if isinstance(node, (ast.FunctionDef, ast.ClassDef)) else [
                one.id for target in getattr(node, "targets", ()) for one in ast.walk(target)
                if isinstance(one, ast.Name)]
            found |= dict.fromkeys(names, ast.unparse(node))
        return found
    return {name: one for names, one in blocks(text).items() for name in names}


def blocks(text: str) -> dict[frozenset[str], str]:
    """The top-level declarations of a GLSL text: what each names, and its own text."""
    lines = [shader.Line(line, "the text", i) for i, line in enumerate(text.split("\n"), 1)]
    return {block.names: "\n".join(line.text for line in block.lines).strip("\n") for block in shader.blocks(lines)}


def packed(texts: list[tuple[str, str]], language: str) -> list[list[int]]:
    """Which of many (function, text) go into one file together: no two of one function, no two of one name."""
    files: list[tuple[list[int], dict[str, str]]] = []
    for i, (function, text) in enumerate(texts):
        names = declares(text, language) | {function: f"{i}"}
        for inside, taken in files:
            if all(taken.get(name, words) == words for name, words in names.items()):
                inside.append(i)
                taken.update(names)
                break
        else:
            files.append(([i], dict(names)))
    return [inside for inside, _ in files]


def standalone(text: str, function: str, helpers: bool = False) -> str:
    """GLSL with what it includes put in, as it is handed in: no line begins with #. `helpers`: the unused ones too."""
    known = list(shader.signatures("\n".join(line.text for line in shader.resolve(text, "the text"))))
    entry = (function, *(known if helpers and "#include" in text else ()), *(["PI"] if helpers else []))
    return shader.assemble(text, "the text", header=(), entry=entry).text.strip() + "\n"


def inlined(text: str) -> str:
    """GLSL with what it includes put in where the #include stood, on that one line: all others keep their numbers."""
    if "#include" not in text:
        return text
    found = [""] * len(text.split("\n"))
    foreign: list[str] = []
    last = 0
    lines = shader.resolve(text, "yours")
    code = shader.strip_comments([line.text for line in lines])
    for line, bare in zip(lines, code, strict=True):
        if line.file != "yours":
            foreign.append(bare.strip())
            continue
        if foreign:
            found[last], foreign = " ".join(part for part in foreign if part), []
        found[line.number - 1], last = line.text, line.number
    return "\n".join(found)


@cache
def mutants() -> tuple[Mutant, ...]:
    """Every catalogued mutant of every language, its text made from the solution's."""
    from app.grade.assignment import assignments, load

    tasks = {task.function: task for name in assignments() for task in load(name).tasks}
    found = []
    for one in tomllib.loads((FOLDER / "mutants.toml").read_text("utf-8"))["mutant"]:
        task = tasks[one["function"]]
        for language in ("python", "glsl"):
            if language not in one:
                continue
            old, new = one[language]
            text = solution(task, language)
            if text.count(old) != 1:
                raise Problem(f"mutants.toml: {task.function}, {one['name']!r}, {language}: {old!r} is in the solution "
                              f"{text.count(old)} times; right is once.")
            found.append(Mutant(task.function, one["name"], language, text.replace(old, new),
                                one.get("misconception", "")))
    return tuple(found)
