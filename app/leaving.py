"""Leaving out: a scene does without what its values allow, tells the error it accepts, and lets a person decide."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from app.catalog import LoadedStep
from app.lesson import LeaveOut, Term
from app.readouts import error_words
from app.swapping import swap_faults, swapped_scene
from app.terms import evaluate

EXACT = 2.0**-40  # below it an error is rounding


@dataclass(frozen=True)
class Decision:
    """What became of one LeaveOut at some values."""

    of: LeaveOut
    is_out: bool
    error: float  # what leaving it out costs, or would
    by_hand: bool = False  # a person decided it

    @property
    def words(self) -> str:
        """One line: what is out or in, and why."""
        part = " ".join(filter(None, (share(self.error), self.of.of)))
        cost = f"at most {part} off" if self.error > EXACT else "exact to rounding"
        limit = share(self.of.limit)
        if self.is_out:
            why = f", above the {limit} it accepts" * (self.error > self.of.limit) if self.by_hand else ""
            return f"{self.of.label}: left out. {self.of.instead}, {cost}{why}."
        if self.by_hand and self.error <= self.of.limit:
            return f"{self.of.label}: kept by hand. {self.of.instead} would be {cost}."
        return f"{self.of.label}: needed. {self.of.instead} would be {cost}; the scene accepts {limit}."


def share(error: float) -> str:
    return error_words(error).lstrip("+")


def decisions(found: LoadedStep, values: Mapping, by_hand: Mapping[str, bool] | None = None) -> tuple[Decision, ...]:
    """Of every LeaveOut of a step: out where its error is below its limit, unless a person wants it otherwise."""
    made, given = [], by_hand or {}
    for one in found.step.leave_outs:
        with np.errstate(all="ignore"):
            error = float(evaluate(one.error, dict(values)) if isinstance(one.error, Term) else one.error)
        made.append(Decision(one, given.get(one.label, error <= one.limit), error, one.label in given))
    return tuple(made)


def edited(found: LoadedStep, texts: Collection[str]) -> dict[str, bool]:
    """Of every LeaveOut that would put something in the place of a function with the user's own text: in or out, so
    that this text runs."""
    return {one.label: not one.within.keys().isdisjoint(texts) for one in found.step.leave_outs
            if not (one.without.keys() | one.within.keys()).isdisjoint(texts)}


def lean(found: LoadedStep, made: tuple[Decision, ...]) -> LoadedStep:
    """The step with what was decided in its scene; the same object for the same decisions."""
    return as_decided(found, tuple(one.is_out for one in made)) if made else found


@lru_cache(256)
def as_decided(found: LoadedStep, out: tuple[bool, ...]) -> LoadedStep:
    functions: dict[str, str] = {}
    for one, is_out in zip(found.step.leave_outs, out, strict=True):
        functions |= one.without if is_out else one.within
    return replace(found, step=replace(found.step, scene=swapped_scene(found.step.scene, functions)))


def faults(found: LoadedStep) -> list[tuple[str, str]]:
    """What is wrong with a step's leave-outs: (a word to find the line by, the sentence)."""
    wrong = []
    for one in found.step.leave_outs:
        where = f"leave-out {one.label!r}"
        wrong += swap_faults(where, one.without) + swap_faults(where, one.within)
        if not (one.without or one.within):
            wrong.append((one.label, f"{where} changes no function of the scene."))
        if one.limit < 0:
            wrong.append((one.label, f"{where}: a limit of {one.limit} is below 0, where nothing is left out."))
    return wrong
