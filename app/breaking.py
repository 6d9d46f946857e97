"""Break it: a step with naive forms in the place of stable ones, in its scene and in what it tells."""

import re
from dataclasses import replace
from functools import cache

from app import shader
from app.catalog import LoadedStep
from app.lesson import Break, Curves, Number, Plot, Readout, Term, Text
from app.problem import Problem, Usage
from app.typed import read


@cache
def broken(found: LoadedStep, which: int) -> LoadedStep:
    """The step as its break number `which` leaves it; asked twice, the same object."""
    step, one = found.step, found.step.breaks[which]
    scene = replace(step.scene, texts=step.scene.texts + texts(one))
    shown = tuple(plot_of(plot, one) for plot in step.plots)
    return replace(found, step=replace(step, scene=scene, plot=shown, study=None,
                                       readouts=tuple(readout_of(readout, one) for readout in step.readouts)))


def values_of(found: LoadedStep, one: Break) -> dict[str, Number]:
    """The extreme, in internal units, read as a person would type it."""
    return {name: read(show_screen(value), found.values[name], name) for name, value in one.sets.items()}


def show_screen(value: Number) -> str:
    return ",".join(f"{x:.9g}" for x in value) if isinstance(value, tuple) else f"{value:.9g}"


def term_of(term: Term, one: Break) -> Term:
    return replace(term, function=one.functions.get(term.function, term.function))


def readout_of(readout: Readout, one: Break) -> Readout:
    """What is called exact stays so: it shows how far off the others are."""
    term = readout.term if readout.role == "exact" else term_of(readout.term, one)
    return readout if term == readout.term else replace(readout, term=term, precision="float32")


def plot_of(plot: Plot, one: Break) -> Plot:
    if not isinstance(plot, Curves):
        return plot
    return replace(plot, curves=tuple(
        curve if curve.role == "exact" or curve.term.function not in one.functions
        else replace(curve, term=term_of(curve.term, one), precision="float32") for curve in plot.curves))


def texts(one: Break) -> tuple[Text, ...]:
    """The files of glsl/ that hold the stable functions, each calling its naive form instead; lines keep numbers."""
    files: dict[str, str] = {}
    for stable, naive in one.functions.items():
        include, signature = shader.catalogue()[stable]
        files[include] = swapped(files.get(include) or shader.read(include), signature, naive)
    return tuple(Text(include, text, f"glsl/{include}") for include, text in files.items())


def swapped(text: str, signature: shader.Signature, naive: str) -> str:
    """A function's body gone, its head left as a prototype, and at the end a body that calls the naive form."""
    lines, head = text.split("\n"), re.compile(rf"^{signature.returns}\s+{signature.name}\s*\(")
    first = next((i for i, line in enumerate(lines) if head.match(line)), None)
    if first is None:
        raise Problem(f"{signature.name} is not at the beginning of a line of its file.")
    last = next(i for i in range(first, len(lines)) if lines[i] == "}")
    given = ", ".join(f"{a.type} {a.name}{f'[{a.size}]' if a.size else ''}" for a in signature.args)
    call = ", ".join(a.name for a in signature.args)
    lines[first:last + 1] = [f"{signature.returns} {signature.name}({given});", *[""] * (last - first)]
    include = shader.catalogue()[naive][0]
    more = [] if include == shader.catalogue()[signature.name][0] else [f'#include "{include}"']
    body = f"{signature.returns} {signature.name}({given}) {{ return {naive}({call}); }}"
    return "\n".join([*lines, *more, body, ""])


def faults(step: LoadedStep) -> list[tuple[str, str]]:
    """What is wrong with a step's breaks: (a word to find the line by, the sentence)."""
    known, found = shader.catalogue(), []
    for one in step.step.breaks:
        try:
            values_of(step, one)
        except Usage as problem:
            found.append((one.label, f"break {one.label!r}: {problem}"))
        except KeyError as missing:
            found.append((one.label, f"break {one.label!r}: the step has no value {missing}."))
        for stable, naive in one.functions.items():
            for name in (stable, naive):
                if name not in known:
                    found.append((name, f"break {one.label!r}: there is no function {name}."))
            if stable in known and naive in known and known[stable][1].args != known[naive][1].args:
                found.append((naive, f"break {one.label!r}: {naive} does not take the arguments of {stable}."))
    return found
