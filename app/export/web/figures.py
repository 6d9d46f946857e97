"""A step's plots as data for the page: curves, slices and ledgers by their terms, what stands in space as a scene.

What compares float32 with float64 cannot be computed where there is float32 alone: such a plot carries its exact curve
where that depends on the swept value only, and else is a still that says so.
"""

from dataclasses import replace
from typing import Any

from app.catalog import LoadedStep
from app.export.web import space
from app.export.web.texts import Data, Twins, packed, scene
from app.ledger import pretty
from app.lesson import (
    Curves,
    Faces,
    Figure,
    ImageSlice,
    Ledger,
    LedgerRow,
    Lobes,
    Model,
    Plot,
    Slice,
    Study,
    Term,
)
from app.optics import arguments
from app.plots.models import CHANNELS
from app.plots.sweep import Sweep
from app.spoken import axis_title
from app.state import defaults

PRECISIONS = ("This plot compares float32 with float64. A page computes in float32 alone, so here is the desktop's "
              "picture, at the first values of the step.")
TIMES = ("This plot measures times of the desktop's methods. Here is what the machine that made this page measured, "
         "at the first values of the step.")
FLOOR = 1e-8  # an error of 0 in float32 is drawn here
DASHES = {"exact": ("", "9 5", "2 5"), "printed": ("10 4 2 4", "2 5", "9 5"),
          "estimate": ("0 8", "5 5", "0 5", "9 4 0 4"), "lobe": ("", "9 5", "10 4 2 4", "2 5")}


def plot(one: Plot, found: LoadedStep, twins: Twins) -> Data:
    """A plot of a step; `kind` says who draws it in the player."""
    title = {"title": one.title}
    if isinstance(one, Curves):
        return title | (curves(one, found, twins) if carries(one, found) else {"kind": "still", "note": PRECISIONS})
    if isinstance(one, Study):
        return title | {"kind": "still", "note": TIMES}
    if isinstance(one, Ledger):
        return title | ledger(one, twins)
    if isinstance(one, Slice):
        axis = f"angle of the {'eye' if one.over == 'v' else 'light'} in °, mirror side > 0"
        return title | {"kind": "slice", "over": one.over, "polar": one.kind == "polar", "axis": axis,
                        "lobes": lobes(one.models, found, twins)}
    return title | in_space(one, found, twins)


def stroke(dash: str, colour: str) -> str:
    """A line's style in a drawing and its legend."""
    dotted = dash.startswith("0")
    return (f"stroke:{colour};stroke-width:{4.5 if dotted else 2.2};stroke-linecap:{'round' if dotted else 'butt'}"
            + (f";stroke-dasharray:{dash}" if dash else ""))


# --- curves ----------------------------------------------------------------------------------------------------------
def ranges(found: LoadedStep) -> dict:
    return {name: (spec.low, spec.high) for name, spec in found.values.items()}


def exact_of(one: Curves) -> Any:
    return next((c for c in one.curves if c.role == "exact"), None)


def compares_precisions(one: Curves) -> bool:
    """Whether a function is drawn against itself in the other precision."""
    exact = exact_of(one)
    return one.error and any(c.precision != exact.precision and c.term.function == exact.term.function
                             for c in one.curves)


def carries(one: Curves, found: LoadedStep) -> bool:
    """Whether the page can draw it: with its float64 curve along, if that changes with the swept value alone."""
    if not compares_precisions(one):
        return True
    args = exact_of(one).term
    return {args.args.get(name, name) for name in arguments(args.function)} == {one.sweep}


def curves(one: Curves, found: LoadedStep, twins: Twins) -> Data:
    sweep = Sweep(one, ranges(found))
    axis = sweep.axis
    data: Data = {
        "kind": "curves", "sweep": one.sweep, "x": packed(sweep.x.astype(float)),
        "axis": {"low": axis.low, "high": axis.high, "log": axis.log, "degrees": axis.degrees, "whole": axis.whole,
                 "title": axis_title(one.sweep)},
        "y_label": one.y_label, "log": sweep.log, "error": one.error, "floor": FLOOR, "exact": sweep.exact,
        "curves": [],
    }
    for c in one.curves:
        before = sum(other["role"] == c.role for other in data["curves"])
        colour, dashes = c.colour or f"var(--{c.role})", DASHES[c.role]
        data["curves"].append({"label": c.label, "role": c.role, "colour": colour, "term": twins.term(c.term),
                               "style": stroke(dashes[before % len(dashes)], colour)})
    if compares_precisions(one) and sweep.exact is not None:
        y = sweep.over(sweep.exact, one.curves[sweep.exact], defaults(found))
        data |= {"exact_values": packed(y), "note": "The exact curve was computed in float64 when the page was made."}
    elif one.error:
        data["note"] = "Computed in float32 here: errors below 1e-6 are its rounding."
    return data


# --- ledgers ---------------------------------------------------------------------------------------------------------
def ledger(one: Ledger, twins: Twins) -> Data:
    def row(line: LedgerRow) -> Data:
        return {"label": line.label, "term": twins.term(line.term), "unit": pretty(line.unit), "how": line.how,
                "by": pretty(line.by.removeprefix("1/")), "over": line.by.startswith("1/")}

    return {"kind": "ledger", "columns": [[row(line) for line in column] for column in one.columns],
            "balance": [twins.term(term) for term in one.balance or ()], "unit": pretty(one.unit)}


# --- models ----------------------------------------------------------------------------------------------------------
def lobes(models: tuple[Model, ...], found: LoadedStep, twins: Twins) -> list[Data]:
    """The lobes of models, one of colour once for each channel unless the step has chosen one; n and radiance set."""
    shown: list[Data] = []
    for model in models:
        for term, channel in channels(model, found):
            name = "" if channel is None else f", {('red', 'green', 'blue')[channel]}"
            colour = f"var(--{model.colour})" if channel is None else (
                "#" + "".join(f"{round(255 * x):02X}" for x in CHANNELS[channel]))
            dash = DASHES["lobe"][len(shown) % len(DASHES["lobe"])]
            shown.append({"label": model.label + name, "colour": colour, "style": stroke(dash, colour),
                          "term": twins.term(term), "shading": model.is_shading})
    return shown


def channels(model: Model, found: LoadedStep) -> list[tuple[Term, int | None]]:
    names = arguments(model.term.function)
    free = "channel" in names and model.term.args.get("channel", "channel") == "channel"
    args = {**model.term.args, "n": (0.0, 0.0, 1.0)} | ({"radiance": 1.0} if "radiance" in names else {})
    term = replace(model.term, args={name: value for name, value in args.items() if name in names})
    if not free or "channel" in found.values:
        return [(term, None)]
    return [(replace(term, args={**term.args, "channel": channel}), channel) for channel in range(3)]


# --- in space --------------------------------------------------------------------------------------------------------
def in_space(one: Figure | Faces | Lobes | ImageSlice, found: LoadedStep, twins: Twins) -> Data:
    data: Data = {"kind": "space"}
    if isinstance(one, Figure):
        heights = [{"term": twins.term(s.height), "cells": s.cells} for s in one.sheets if s.height]
        label = next((s.height_label or s.label for s in one.sheets if s.height), "")
        return data | {"what": "figure", "scene": scene(space.figure(one)), "heights": heights, "label": label,
                       "areas": [{"label": s.label, "ink": s.colour} for s in one.sheets if not s.height]}
    if isinstance(one, Faces):
        twins.add("solid_angle_triangle_signed")
        return data | {"what": "faces", "scene": scene(space.faces(one))}
    shown = lobes(one.models, found, twins)
    terms = [term for model in one.models for term in channels(model, found)]
    scaled = "lobe_scale" in found.values
    if isinstance(one, Lobes):
        made = space.lobes(one, terms, [m for m in one.models for _ in channels(m, found)], scaled)
        return data | {"what": "lobes", "over": one.over, "lobes": shown, "scene": scene(made)}
    firsts = [channels(model, found)[0][0] for model in one.models]
    several = "model" in found.values and len(firsts) > 1
    labels = [(shown[i]["label"], channels(m, found)[0]) for i, m in enumerate(one.models)]
    return data | {"what": "slice", "lobes": [s for s, _ in zip(shown, labels, strict=False)],
                   "scene": scene(space.image_slice(firsts, several, scaled, one.models))}

