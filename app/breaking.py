"""Break it: a step with naive forms in the place of stable ones, in its scene and in what it tells."""

from dataclasses import replace
from functools import cache

from app.catalog import LoadedStep, ValueSpec
from app.lesson import Break, Curves, Number, Plot, Readout, Term, Value
from app.problem import Usage
from app.swapping import swap_faults, swapped_scene
from app.typed import on_screen, read


@cache
def broken(found: LoadedStep, which: int) -> LoadedStep:
    """The step as its break number `which` leaves it; asked twice, the same object."""
    step, one = found.step, found.step.breaks[which]
    shown = tuple(plot_of(plot, one) for plot in step.plots)
    return replace(found, step=replace(step, scene=swapped_scene(step.scene, one.functions), plot=shown, studies=(),
                                       readouts=numbers_of(one), values=reaching(found, one)))


def values_of(found: LoadedStep, one: Break) -> dict[str, Number]:
    """The extreme, in internal units, read as a person would type it; it may lie beyond the step's sliders."""
    return {name: read(show_screen(value), widest(found.values[name]), name) for name, value in one.sets.items()}


def widest(spec: ValueSpec) -> ValueSpec:
    """All that the quantity may be."""
    low, high = spec.quantity.extreme or (spec.low, spec.high)
    return replace(spec, low=min(spec.low, low), high=max(spec.high, high))


def reaching(found: LoadedStep, one: Break) -> tuple[Value, ...]:
    """All values of the step, of which the sliders reach to the extreme."""
    listed = {value.name: value for value in found.step.values}
    return tuple(reach(listed.get(name, Value(name)), spec, one.sets.get(name)) for name, spec in found.values.items())


def reach(value: Value, spec: ValueSpec, to: Number | None) -> Value:
    if to is None or isinstance(to, tuple):
        return value
    return replace(value, low=min(on_screen(spec, spec.low), to), high=max(on_screen(spec, spec.high), to))


def show_screen(value: Number) -> str:
    return ",".join(f"{x:.9g}" for x in value) if isinstance(value, tuple) else f"{value:.9g}"


def numbers_of(one: Break) -> tuple[Readout, ...]:
    """By how much it is off: the number as it is, and as the naive form has it."""
    return (Readout(one.number, one.term, role="exact", unit=one.unit),
            Readout(f"{one.number}, broken", naive(one.term, one), role="printed", precision="float32", unit=one.unit,
                    against=one.number))


def naive(term: Term, one: Break) -> Term:
    return replace(term, function=one.functions[term.function])


def plot_of(plot: Plot, one: Break) -> Plot:
    if not isinstance(plot, Curves):
        return plot
    return replace(plot, curves=tuple(
        curve if curve.role == "exact" or curve.term.function not in one.functions
        else replace(curve, term=naive(curve.term, one), precision="float32") for curve in plot.curves))


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
        if one.term.function not in one.functions:
            found.append((one.term.function, f"break {one.label!r}: {one.term.function}, its number, is not broken."))
    return found
