"""Break it: a step with naive forms in the place of stable ones, in its scene and in what it tells."""

from dataclasses import replace
from functools import cache

from app.catalog import LoadedStep
from app.lesson import Break, Curves, Number, Plot, Readout, Term
from app.problem import Usage
from app.swapping import swap_faults, swapped_scene
from app.typed import read


@cache
def broken(found: LoadedStep, which: int) -> LoadedStep:
    """The step as its break number `which` leaves it; asked twice, the same object."""
    step, one = found.step, found.step.breaks[which]
    shown = tuple(plot_of(plot, one) for plot in step.plots)
    return replace(found, step=replace(step, scene=swapped_scene(step.scene, one.functions), plot=shown, studies=(),
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


def faults(step: LoadedStep) -> list[tuple[str, str]]:
    """What is wrong with a step's breaks: (a word to find the line by, the sentence)."""
    found = []
    for one in step.step.breaks:
        try:
            values_of(step, one)
        except Usage as problem:
            found.append((one.label, f"break {one.label!r}: {problem}"))
        except KeyError as missing:
            found.append((one.label, f"break {one.label!r}: the step has no value {missing}."))
        found += swap_faults(f"break {one.label!r}", one.functions)
    return found
