"""What a picture, a plot and a number need of a step's values: only that is handed to them, and so nothing is drawn
again, plotted again or integrated again because of a value that it does not read."""

from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass

import numpy as np

from app import shader
from app.edit import EDITED
from app.lesson import Curves, Faces, ImageSlice, ModelPlot, Plot, Scene, Study, Term
from app.optics import arguments
from app.quantities import FROM_ANGLES
from app.study.names import inputs

DIRECTIONS = frozenset(name for names in FROM_ANGLES.values() for name in names)


def of_term(term: Term) -> frozenset[str]:
    """The values a twin's arguments come from; a unit vector's are its angles, unless the step has it as a value."""
    given = [term.args.get(name, name) for name in arguments(term.function)]
    names = {name for name in given if isinstance(name, str)}
    return frozenset(names.union(*(FROM_ANGLES.get(name, ()) for name in names), {EDITED}))


def terms(thing: object) -> Iterator[Term]:
    """Every term within some lesson data."""
    if isinstance(thing, Term):
        yield thing
    elif isinstance(thing, tuple | list):
        for one in thing:
            yield from terms(one)
    elif is_dataclass(thing):
        for part in fields(thing):
            yield from terms(getattr(thing, part.name))


def plotted(plot: Plot) -> frozenset[str]:
    """Of a plot: its terms' values, the one it sweeps (it is marked), and what its kind reads beside them."""
    names = frozenset[str]().union(*map(of_term, terms(plot)))
    if isinstance(plot, Curves):
        return names | {plot.sweep}
    if isinstance(plot, Faces):
        return names | {"eye", "triangles"}
    if isinstance(plot, ImageSlice):
        return names | {"model", "channel", "lobe_scale"}
    if isinstance(plot, ModelPlot):
        return names | DIRECTIONS | {"channel", "lobe_scale"}
    if isinstance(plot, Study):
        sets = {name for one in plot.methods for name in (one.cost, *one.sets, *(one.term.args if one.term else ()))}
        return names | inputs(plot) | sets  # a point that the scene shows is marked
    return names


def drawn(scene: Scene, texts: Mapping[str, tuple[shader.Assembled, shader.Assembled | None]]) -> frozenset[str]:
    """Of a scene: the uniforms of its programs, how many dots there are, and which data it shows."""
    found = {name for pair in texts.values() for part in pair if part for name in shader.uniforms(part.text)}
    found |= {table.choice for table in scene.tables} | {table.uniform for table in scene.tables} | {EDITED}
    found |= {surface.where[0] for surface in scene.surfaces if surface.where}
    if scene.dots and isinstance(scene.dots.count, str):
        found.add(scene.dots.count)
    return frozenset(found)


def only(values: dict, names: frozenset[str]) -> dict:
    """The values that are needed."""
    return {name: value for name, value in values.items() if name in names}


def key(values: dict, names: frozenset[str]) -> tuple:
    """Of the needed values: the same until one of them changes; data counts by the object it is."""
    return tuple((name, id(value) if isinstance(value, np.ndarray) else value)
                 for name, value in sorted(only(values, names).items()))
