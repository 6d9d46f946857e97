"""What is wrong with a lesson, in sentences with its file and line. For a chapter's author and for the tests."""

import ast
import re
from collections.abc import Callable, Collection, Iterator
from typing import get_args

from app import breaking, edit, leaving, prose, shader
from app.catalog import Loaded, LoadedStep, spec_of, terms, undecidable, unknown_uniform, unknown_uniforms
from app.lesson import Colour, Curves, Faces, Ledger, ModelPlot, Number, Scene
from app.optics import arguments, names
from app.problem import Problem, near
from app.quantities import TABLE, entered
from app.state import parse, parse_query
from app.typed import checked

COLOURS: tuple[str, ...] = get_args(Colour)
PROSE = ("prose", "idea", "notes", "honesty")


def validate(loaded: Loaded, slides: Collection[str] = ()) -> list[str]:
    """Every fault of a chapter; `slides` are the deck's titles, when they are to be checked."""
    if loaded.fault:
        return [loaded.fault]
    chapter, where = loaded.chapter, Where(loaded)
    found = [where("Chapter", "", "the chapter has no steps.")] if not chapter.steps else []
    steps = [step.name for step in chapter.steps]
    found += [where("Step", name, f"the name {name} is used by {steps.count(name)} steps.", name)
              for name in dict.fromkeys(steps) if steps.count(name) > 1]
    for i, step in enumerate(chapter.steps):
        loaded_step = LoadedStep(loaded, step, i)
        for word, sentence in [*faults(loaded_step), *slide_faults(step.slides, slides)]:
            found.append(where("Step", step.name, f"step {step.name}: {sentence}", word))
    for exercise in chapter.exercises:
        told = [] if exercise.function in names() else [
            (exercise.function, f"there is no function {exercise.function}.{near(exercise.function, names())}")]
        for word, sentence in [*told, *slide_faults((exercise.slide,), slides)]:
            found.append(where("Exercise", exercise.name, f"exercise {exercise.name}: {sentence}", word))
    return found


class Where:
    """Puts file and line before a sentence."""

    def __init__(self, loaded: Loaded):
        self.file, self.lines = loaded.file_name, loaded.source.splitlines()
        self.calls: dict[tuple[str, str], tuple[int, int]] = {}  # (class, name) -> first and last line
        for node in ast.walk(ast.parse(loaded.source)):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
                given = [k.value for k in node.keywords if k.arg == "name"] + node.args[:1]
                name = given[0].value if given and isinstance(given[0], ast.Constant) else ""
                self.calls.setdefault((node.func.id, str(name)), (node.lineno, node.end_lineno or node.lineno))

    def __call__(self, kind: str, name: str, sentence: str, word: str = "") -> str:
        first, last = self.calls.get((kind, name), (1, 1))
        within = (i for i in range(first, last + 1) if word and word in self.lines[i - 1])
        return f"{self.file}, line {next(within, first)}: {sentence}"


Faults = Iterator[tuple[str, str]]  # (a word to find the line by, the sentence)


def slide_faults(claimed: Collection[str], slides: Collection[str]) -> Faults:
    known = {plain(title): title for title in slides}
    for title in claimed:
        if known and plain(title) not in known:
            yield title, f"the deck has no slide {title!r}.{near(title, slides)}"


def plain(title: str) -> str:
    """A slide's title whichever dash it is written with."""
    return " ".join(title.replace("–", "-").replace("—", "-").casefold().split())


def faults(found: LoadedStep) -> Faults:
    yield from value_faults(found)
    yield from term_faults(found)
    yield from scene_faults(found)
    yield from model_faults(found)
    yield from breaking.faults(found)
    yield from leaving.faults(found)
    step = found.step
    for kind in PROSE:
        if wrong := prose.balanced(getattr(step, kind)):
            yield "", f"{kind}: {wrong}."
    labels = {readout.label for readout in step.readouts}
    for readout in step.readouts:
        against = readout.against
        if against and against not in labels:
            yield against, f"there is no readout {against!r} to compare with.{near(against, labels)}"
    if not step.plots:
        yield "plot=", "the step has no plot."
    for word in [name for name, _ in step.scene.legend] + [curve.colour for plot in step.plots
                                                           if isinstance(plot, Curves) for curve in plot.curves]:
        if word and word not in COLOURS and not re.fullmatch("#[0-9A-Fa-f]{6}", word):
            yield f'"{word}"', f"{word} is no colour; there are {', '.join(COLOURS)} and #RRGGBB.{near(word, COLOURS)}"
    for plot in step.plots:
        if isinstance(plot, Faces) and not any(surface.mesh for surface in step.scene.surfaces):
            yield "Faces(", "the plot shows a mesh, and the scene has none."
        if isinstance(plot, ModelPlot) and not plot.models:
            yield plot.title, f"the plot {plot.title!r} shows models, and neither it nor the step has any."
        if isinstance(plot, Ledger):
            from app import ledger

            yield from ledger.faults(plot)


def model_faults(found: LoadedStep) -> Faults:
    for model in found.step.models:
        function = model.term.function
        if function in names():
            if not function.startswith(("brdf_", "shading_")):
                yield f'"{function}"', f"model {model.label!r}: {function} is neither a brdf_ nor a shading_."
            for name in {"n", "l", "v"} - set(arguments(function)):
                yield f'"{function}"', f"model {model.label!r}: {function} takes no {name}."


def value_faults(found: LoadedStep) -> Faults:
    for name in unknown_uniforms(found.step.scene):
        yield name, unknown_uniform(name)
    for value in found.step.values:
        if value.name not in TABLE:
            yield f'"{value.name}"', f"there is no quantity {value.name}.{near(value.name, TABLE)}"
            continue
        spec = spec_of(value.name, value, found.step.scene.meshes)
        if spec.low >= spec.high:
            yield f'"{value.name}"', f"{value.name} goes from {value.low} to {value.high}, which is no range."
        yield from told(f'"{value.name}"', checked, spec.default, spec, f"the default of {spec.name}")


def term_faults(found: LoadedStep) -> Faults:
    """Twins that do not exist, arguments that are neither given nor values; when all is known, what sets them."""
    step = found.step
    whole = all(value.name in TABLE for value in step.values) and not unknown_uniforms(step.scene)
    for where, term, swept in terms(step):
        if term.function not in names():
            whole = False
            yield f'"{term.function}"', f"{where}: there is no function {term.function}.{near(term.function, names())}"
            continue
        wanted = arguments(term.function)
        for name in set(term.args) - set(wanted):
            yield f'"{name}"', f"{where}: {term.function} takes no {name}; it takes {', '.join(wanted)}."
        for name in wanted:
            given = term.args.get(name, name)
            if isinstance(given, str) and given not in TABLE and given not in swept:
                yield f'"{term.function}"', f"{where}: {given} of {term.function} is neither given nor a value."
    for plot in step.plots:
        if isinstance(plot, Curves) and plot.sweep not in TABLE:
            whole = False
            yield "sweep=", f"the plot sweeps {plot.sweep}, which is no quantity.{near(plot.sweep, TABLE)}"
    if step.scene.dots and isinstance(step.scene.dots.count, str) and step.scene.dots.count not in TABLE:
        whole = False
        yield "Dots(", f"the dots are counted by {step.scene.dots.count}, which is no quantity."
    if wrong := undecidable(step):
        whole = False
        yield "decided=", wrong
    if whole:
        yield from setting_faults(found)


def setting_faults(found: LoadedStep) -> Faults:
    """Handles, questions and links that set what is no value, or set it out of range."""
    step = found.step
    for handle in step.scene.handles:
        for name in handle.values:
            if name not in found.values:
                yield f'"{name}"', f"the handle {handle.name!r} drags {name}, no value of it.{near(name, found.values)}"
    for name, value in step.ask.sets.items():
        if name not in found.values:
            yield f'"{name}"', f"the question sets {name}, no value of the step.{near(name, found.values)}"
        else:
            yield from told(f'"{name}"', in_range, found, name, value)
    for link in prose.links(step.prose):
        if link.target.startswith("?"):
            yield from told(link.target, parse_query, link.target[1:], found)
        elif link.target.startswith(edit.CODE):
            name, known = link.target.removeprefix(edit.CODE), edit.functions(found)
            if name not in known:
                yield link.target, f"a link leads to {name}, and the step compiles no such function.{near(name, known)}"
        elif link.sets_values:
            yield from told(link.target, parse, link.target, found.file.parent)


def in_range(found: LoadedStep, name: str, value: Number) -> None:
    checked(entered(name, value), found.values[name], f"the question sets {name}: it")


def told(word: str, job: Callable, *given: object) -> Faults:
    """The Problem that a job ends with."""
    try:
        job(*given)
    except Problem as problem:
        yield word, str(problem)


def scene_faults(found: LoadedStep) -> Faults:
    from app.meshes import BUILT_IN

    scene = found.step.scene
    try:
        lines = shader.resolve(scene.glsl, found.file_name, found.glsl_line)
    except Problem as problem:
        yield "#include", str(problem)
        return
    defined = shader.signatures("\n".join(line.text for line in lines))
    for function, reason in needed(scene):
        if function not in defined:
            yield "glsl", f"the scene has {reason} and its GLSL no function {function}."
    for probe in [label.probe for label in scene.labels] + [handle.probe for handle in scene.handles]:
        if probe < 0:
            yield "", f"a probe's number is 0 or more, not {probe}."
    for name in scene.meshes:
        if name not in BUILT_IN:
            yield f'"{name}"', f"there is no mesh {name}.{near(name, BUILT_IN)}"
    from app.tables import names as luminaires

    for table in scene.tables:
        for name in table.files:
            if name not in luminaires():
                yield f'"{name}"', f"there is no luminaire {name} in lessons/ies.{near(name, luminaires())}"
    if any(surface.mesh for surface in scene.surfaces) and not scene.meshes:
        yield "mesh=True", "a surface shows a mesh, and the scene names none in `meshes`."


def needed(scene: Scene) -> Iterator[tuple[str, str]]:
    """The functions a scene's data calls, each with the data that calls it."""
    if any(not surface.mesh for surface in scene.surfaces):
        yield "surface_point", "surfaces"
    if any(surface.mesh for surface in scene.surfaces):
        yield "mesh_point", "a mesh"
    if scene.surfaces:
        yield "shade", "surfaces"
    if scene.marks:
        yield "mark_point", "marks"
    if scene.dots:
        yield "dot_point", "dots"
        yield "dot_colour", "dots"
    if scene.labels or scene.handles:
        yield "probe", "labels or handles"
