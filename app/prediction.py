"""A question asked before the answer: the guess, the truth, and how far apart they are, said kindly."""

import math
from dataclasses import dataclass, replace
from typing import Literal

from app.catalog import LoadedStep
from app.lesson import Number, Prediction
from app.problem import Usage
from app.quantities import entered
from app.state import defaults
from app.typed import checked, digits

CLOSE, GOOD, FAR = 0.02, 0.1, 0.5  # relative distances: there, close, on the way


@dataclass(frozen=True)
class Answer:
    """asked -> guessed -> revealed. A guess is a number in the question's unit, or the number of a choice."""

    stage: Literal["asked", "guessed", "revealed"] = "asked"
    guess: float | None = None
    choice: int | None = None
    truth: float | None = None

    @property
    def distance(self) -> float | None:
        """The guess less the truth, in the question's unit; None for a choice or before the reveal."""
        return None if self.guess is None or self.truth is None else self.guess - self.truth


def truth_values(found: LoadedStep) -> dict[str, Number]:
    """The state in which the truth is computed and shown: the step's own values with what the question sets."""
    sets = {}
    for name, value in found.step.ask.sets.items():
        if name not in found.values:
            raise Usage(f"{found.file_name}: the question of {found.id} sets {name}, which is no value of the step.")
        sets[name] = checked(entered(name, value), found.values[name], f"the question of {found.id}: {name}")
    return defaults(found) | sets


def truth(found: LoadedStep, **data) -> float:
    """The true answer; `data` is what is no value (a mesh's `triangles`)."""
    from app.terms import evaluate

    return float(evaluate(found.step.ask.truth, {**truth_values(found), **data}))


def guessed(ask: Prediction, guess: float) -> Answer:
    """An answer with this guess: a number on the slider, or the number of a choice."""
    if ask.choices:
        if guess != round(guess) or not 0 <= guess < len(ask.choices):
            raise Usage(f"the question has the choices 0 to {len(ask.choices) - 1}, and {guess:g} is none of them.")
        return Answer("guessed", choice=round(guess))
    if not ask.low <= guess <= ask.high:
        raise Usage(f"a guess goes from {ask.low:g} to {ask.high:g} {ask.unit}".rstrip() + f", and {guess:g} does not.")
    return Answer("guessed", guess=float(guess))


def revealed(answer: Answer, truth: float) -> Answer:
    return replace(answer, stage="revealed", truth=truth)


def is_right(ask: Prediction, answer: Answer) -> bool:
    """The right choice, or a guess within ten per cent."""
    if answer.truth is None:
        return False
    if answer.choice is not None:
        choice = ask.choices[answer.choice]
        return choice.low <= answer.truth <= choice.high
    return answer.guess is not None and share(ask, answer.guess, answer.truth) <= GOOD


def share(ask: Prediction, guess: float, truth: float) -> float:
    """The distance in parts of the truth, or of the slider where the truth is nothing."""
    return abs(guess - truth) / (abs(truth) or ask.high - ask.low or 1.0)


def words(ask: Prediction, answer: Answer) -> str:
    """How the guess did, in a sentence; empty before the reveal or without a guess."""
    if answer.truth is None or (answer.guess is None and answer.choice is None):
        return ""
    true = quantity(answer.truth, ask.unit)
    if answer.guess is not None:
        return f"{kindly(ask, answer.guess, answer.truth)}: {quantity(answer.guess, ask.unit)} guessed, {true} true."
    if ask.unit.startswith("rad "):  # "rad from the pole": on screen, degrees
        true = quantity(math.degrees(answer.truth), ask.unit.replace("rad", "°", 1))
    right = next((c.text for c in ask.choices if c.low <= answer.truth <= c.high), "")
    return f"That is it: {true}." if is_right(ask, answer) else f"It is {true}" + (f": “{right}”." if right else ".")


def kindly(ask: Prediction, guess: float, truth: float) -> str:
    off, by = share(ask, guess, truth), "high" if guess > truth else "low"
    if off <= CLOSE:
        return "You are there"
    if off <= FAR:
        of = f"{off:.0%} of the slider" if truth == 0 else f"{off:.0%}"
        return f"{'Very close' if off <= GOOD else 'On the way'}, {of} too {by}"
    if truth == 0 or guess / truth <= 0:
        return "Worth a second look"
    times, way = (guess / truth, "large") if abs(guess) > abs(truth) else (truth / guess, "small")
    return f"Worth a second look, {three(times)} times too {way}"


def quantity(value: float, unit: str) -> str:
    return f"{three(value)}{'' if unit[:1] in ('', '°', '%') else ' '}{unit}"


def three(value: float) -> str:
    """Three significant digits."""
    return digits(float(f"{value:.3g}"))
