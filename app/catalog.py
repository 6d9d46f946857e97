"""Finds and orders the chapters, lessons/ch*.py; a broken lesson stays in the list with the sentence that says why.

`chapters` and `step` are cheap (no numpy); `values_of` looks at the twins a step names.
"""

import re
from dataclasses import dataclass, replace
from functools import cache, cached_property
from importlib import import_module
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType

from app import shader
from app.lesson import Chapter, Curves, Faces, Figure, Ledger, ModelPlot, Number, Scene, Step, Study, Term, Value
from app.paths import LESSONS
from app.problem import Problem, Usage, near
from app.quantities import FROM_ANGLES, TABLE, Quantity, entered, quantity
from app.study.names import swept
from app.study.names import terms as terms_of

BOARD = "board/"  # steps that are made when they are asked for: see app/board/board_step.py
FILE = re.compile(r"ch(\d+)_([a-z]\w*)")
# what belongs to a mesh, and what a sheet sweeps: arguments that are no values
DATA = frozenset({"triangles", "texture_coordinates", "s", "t"})
SWEPT = frozenset({"s", "t"})
MODELLED = frozenset({"n", "l", "v", "channel", "radiance"})  # what a model's lobe and badges sweep


@dataclass(frozen=True, eq=False)
class Loaded:
    """A chapter as it was found. With a `fault` (one sentence with file and line) it has no steps."""

    id: str
    number: int
    file: Path
    intro: str  # the module's docstring
    chapter: Chapter
    fault: str = ""

    @property
    def file_name(self) -> str:
        return shader.file_name(self.file)

    @cached_property
    def source(self) -> str:
        return self.file.read_text(encoding="utf-8")


@dataclass(frozen=True, eq=False)
class LoadedStep:
    loaded: Loaded
    step: Step
    index: int  # in its chapter

    @property
    def id(self) -> str:
        return f"{self.loaded.id}/{self.step.name}"

    @property
    def chapter(self) -> Chapter:
        return self.loaded.chapter

    @property
    def file(self) -> Path:
        return self.loaded.file

    @property
    def file_name(self) -> str:
        return self.loaded.file_name

    @cached_property
    def glsl_line(self) -> int:
        """The line of the lesson's file at which the scene's GLSL text begins."""
        at = self.loaded.source.find(self.step.scene.glsl)
        return self.loaded.source.count("\n", 0, at) + 1 if at >= 0 else 1

    @cached_property
    def values(self) -> dict[str, "ValueSpec"]:
        try:
            return values_of(self.step)
        except Problem as problem:
            place = f"{self.file_name}, line {self.line(str(problem))}"
            raise Problem(f"{place}: step {self.step.name}: {problem}") from None

    @property
    def below(self) -> tuple["ValueSpec", ...]:
        """The values whose controls stand below the scene."""
        return tuple(self.values.values())

    def derived(self, values: dict) -> dict:
        """What the terms of this step need beside its values."""
        return {}

    def carried(self, other: "LoadedStep", values: dict) -> dict:
        """Of another step's values those that mean the same here."""
        return {}

    def line(self, sentence: str) -> int:
        """The line of the lesson's file with the word that, as a sentence says, there is not."""
        source, glsl = self.loaded.source, self.step.scene.glsl
        word = found[1] if (found := re.search(r"there is no \w+ (\w+)", sentence)) else ""
        if declared := re.search(rf"\buniform\b[^;\n]*\b{word}\b" if word else r"(?!)", glsl):
            return self.glsl_line + glsl.count("\n", 0, declared.start())
        begin = max(source.find(f'name="{self.step.name}"'), 0)
        return source.count("\n", 0, max(source.find(f'"{word}"', begin), begin)) + 1


@dataclass(frozen=True)
class ValueSpec:
    """A value a student can change, in internal units (radians)."""

    name: str
    quantity: Quantity
    default: Number
    low: float  # of each number of a vector
    high: float
    scale: str = "linear"  # of its slider
    more: bool = False  # behind "more"
    choices: tuple[str, ...] = ()  # the words of the numbers 0, 1, 2, ...
    label: str = ""  # what it is called, where that is not what the table says
    unfolds: bool = False  # its choices stand in a list that unfolds


@cache
def chapters(folder: Path = LESSONS) -> tuple[Loaded, ...]:
    return tuple(sorted(map(load, Path(folder).glob("ch*.py")), key=lambda loaded: (loaded.number, loaded.id)))


@cache
def steps(folder: Path = LESSONS) -> tuple[LoadedStep, ...]:
    """Every step of the course, in order."""
    return tuple(LoadedStep(found, step, i) for found in chapters(folder) for i, step in enumerate(found.chapter.steps))


@cache
def studies(folder: Path = LESSONS) -> dict[str, tuple[Study, ...]]:
    """The studies of error against run time, by the name of their step: studies.py beside the chapters."""
    file = Path(folder) / "studies.py"
    if not file.exists():
        return {}
    try:
        return module_of(file).STUDIES
    except Exception as error:
        place = f"{shader.file_name(file)}, line {line_of(error, file)}"
        raise Problem(f"{place}: {type(error).__name__}: {getattr(error, 'msg', error)}.") from None


def forget() -> None:
    """Read the lessons anew when they are asked for next: a lecturer has changed one."""
    chapters.cache_clear()
    steps.cache_clear()
    studies.cache_clear()


def step(id: str, folder: Path = LESSONS) -> LoadedStep:
    if id.startswith(BOARD):
        return import_module("app.board.board_step").step(id.removeprefix(BOARD))
    known = {found.id: found for found in steps(folder)}
    if id in known:
        return known[id]
    for loaded in chapters(folder):
        if loaded.fault and id.partition("/")[0] == loaded.id:
            raise Problem(loaded.fault)
    raise Usage(f"there is no step {id or 'without a name'}.{near(id, known)}")


def load(file: Path) -> Loaded:
    match = FILE.fullmatch(file.stem)
    number, id = (int(match[1]), match[2]) if match else (999, file.stem)
    name = shader.file_name(file)

    def broken(sentence: str, intro: str = "") -> Loaded:
        empty = Chapter(title=id, idea="This chapter could not be read.", steps=())
        return Loaded(id, number, file, intro, empty, f"{name}, {sentence}")

    if not match:
        return broken("line 1: a chapter's file is named like ch01_solid_angle.py.")
    try:
        module = module_of(file)
    except Exception as error:  # whatever a lesson does wrong, the other chapters go on
        return broken(f"line {line_of(error, file)}: {type(error).__name__}: {getattr(error, 'msg', error)}.")
    intro = (module.__doc__ or "").strip()
    chapter = getattr(module, "CHAPTER", None)
    if not isinstance(chapter, Chapter):
        return broken("line 1: a lesson ends with CHAPTER = Chapter(...).", intro)
    declared = studies(file.parent)
    studied = tuple(replace(step, studies=declared.get(f"{id}/{step.name}", ())) for step in chapter.steps)
    return Loaded(id, number, file, intro, replace(chapter, steps=studied))


def module_of(file: Path) -> ModuleType:
    spec = spec_from_file_location(f"lessons.{file.stem}", file)
    assert spec and spec.loader
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def line_of(error: Exception, file: Path) -> int:
    """Where in the file it went wrong: a syntax error's own line, else the innermost line of the file that ran."""
    if isinstance(error, SyntaxError) and error.filename == str(file):
        return error.lineno or 1
    line, trace = 1, error.__traceback__
    while trace:
        if trace.tb_frame.f_code.co_filename == str(file):
            line = trace.tb_lineno
        trace = trace.tb_next
    return line


def terms(step: Step) -> list[tuple[str, Term, frozenset[str]]]:
    """Every twin a step calls: (where, term, the names swept there)."""
    data = DATA - SWEPT | {table.uniform for table in step.scene.tables}
    found = [(f"readout {r.label!r}", r.term, data) for r in step.readouts]
    found.append(("prediction", step.ask.truth, data))
    found += [(f"model {m.label!r}", m.term, data | MODELLED) for m in step.models]
    found += [(f"leave-out {one.label!r}", one.error, data) for one in step.leave_outs
              if isinstance(one.error, Term)]
    found += [(f"break {one.label!r}", one.term, data) for one in step.breaks]
    for plot in step.plots:
        if isinstance(plot, Curves):
            found += [(f"curve {c.label!r}", c.term, data | {plot.sweep}) for c in plot.curves]
        elif isinstance(plot, Figure):
            found += [(f"sheet {s.label!r}", term, data | SWEPT) for s in plot.sheets for term in (s.term, s.height)
                      if term]
        elif isinstance(plot, Ledger):
            found += [(f"row {r.label!r}", r.term, data) for column in plot.columns for r in column]
            found += [("balance", term, data) for term in plot.balance or ()]
        elif isinstance(plot, ModelPlot):
            found += [(f"model {m.label!r}", m.term, data | MODELLED) for m in plot.models]
        elif isinstance(plot, Study):
            found += [(f"study {plot.title!r}", term, data | swept(plot)) for term in terms_of(plot)]
    return found


def values_of(step: Step) -> dict[str, ValueSpec]:
    """The values of a step: those it lists, its scene's uniforms, what its mesh and its twins need, in this order."""
    from app.optics import arguments

    scene = step.scene
    for name in unknown_uniforms(scene):
        raise Problem(unknown_uniform(name))
    listed = {value.name: value for value in step.values}
    names = [*listed, *(name for name in shader.uniforms(scene.glsl) if name in TABLE)]
    if any(surface.mesh for surface in scene.surfaces):
        names += ["shape"] * (len(scene.meshes) > 1) + ["eye"] * any(isinstance(plot, Faces) for plot in step.plots)
    names += [table.choice for table in scene.tables if table.choice]
    if scene.dots and isinstance(scene.dots.count, str):
        names.append(scene.dots.count)
    for _, term, free in terms(step):
        given = [term.args.get(name, name) for name in arguments(term.function)]
        names += [name for name in given if isinstance(name, str) and name in TABLE and name not in free]
    for plot in step.plots:
        names += [plot.sweep] if isinstance(plot, Curves) else ["l", "v"] if isinstance(plot, ModelPlot) else []
        names += [plot.eye] if isinstance(plot, Study) and plot.sampler and plot.eye else []
    names = [angle for name in names for angle in FROM_ANGLES.get(name, (name,))]
    if wrong := undecidable(step):
        raise Problem(wrong)
    return {name: spec_of(name, listed.get(name, Value(name)), scene.meshes) for name in dict.fromkeys(names)
            if name not in DATA}


def undecidable(step: Step) -> str:
    """Why programs cannot be compiled for what the scene decides, in a sentence; "" where they can."""
    scene, choices = step.scene, [value.name for value in step.values if value.choices]
    for name in set(scene.decided) - set(scene.of_the_user):
        if name not in choices:
            return (f"the scene decides {name}, which is no choice of the step: programs are compiled for each value "
                    f"of one.{near(name, choices)}")
        if not re.search(rf"^uniform int {name};$", scene.glsl, re.M):
            return f"the scene decides {name}, and its GLSL has no line `uniform int {name};`."
    return ""


def unknown_uniforms(scene: Scene) -> list[str]:
    """Uniforms of a scene that are no quantity, no mesh and no table: nothing would set them."""
    known = {*TABLE, *DATA, *(table.uniform for table in scene.tables)} - set(FROM_ANGLES)
    return [name for name in shader.uniforms(scene.glsl) if name not in known]


def unknown_uniform(name: str) -> str:
    if name in FROM_ANGLES:
        return f"there is no uniform {name}: a scene has its angles, and light_direction(theta_l, phi) or the like."
    return f"there is no quantity {name}, which the scene has as a uniform; nothing would set it.{near(name, TABLE)}"


def spec_of(name: str, value: Value, meshes: tuple[str, ...]) -> ValueSpec:
    table = quantity(name)
    choices = value.choices or (meshes if name == "shape" else ())

    def inside(given: Number | None, otherwise: Number) -> Number:
        return otherwise if given is None else entered(name, given)

    low, high = inside(value.low, table.low), inside(value.high, len(choices) - 1 if choices else table.high)
    assert not isinstance(low, tuple) and not isinstance(high, tuple)
    return ValueSpec(name, table, inside(value.default, table.default), low, high, value.scale or table.scale,
                     value.more, choices)
