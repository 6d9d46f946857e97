"""What a class does with a step: it guesses, breaks it, leaves out, writes a function itself. Data of app/lesson.py."""

from dataclasses import dataclass, field
from typing import Literal

from app.worded import Number, Term, Worded


@dataclass(frozen=True)
class Choice:
    """An answer to choose; it is right when the truth lies in [low, high]."""

    text: str
    low: float
    high: float


@dataclass(frozen=True)
class Prediction(Worded):
    """Asked before it is told: a guess on a slider from `low` to `high`, or one of `choices`; the truth is a twin."""

    question: str
    truth: Term
    unit: str
    told: str  # what the reveal says
    low: float = 0.0
    high: float = 1.0
    scale: Literal["linear", "log"] = "linear"
    choices: tuple[Choice, ...] = ()
    sets: dict[str, Number] = field(default_factory=dict)  # the state in which the truth is shown, and computed


@dataclass(frozen=True)
class Break:
    """A button that puts naive forms in the place of stable ones, at the values where that shows; again mends it.

    The scene is compiled with them, in float32; numbers and curves that are not the exact ones show them too. An
    extreme may lie beyond what the step's own sliders reach; while it is broken, they reach so far."""

    label: str  # of the button
    functions: dict[str, str]  # a stable function of the scene -> its naive form, of the same arguments
    sets: dict[str, Number]  # the extreme, in screen units
    told: str  # what a class should remember
    number: str  # the name of a number that shows by how much: `term` exactly, and in float32 with the naive form
    term: Term
    unit: str = ""


@dataclass(frozen=True)
class LeaveOut:
    """Something the scene does without where its values allow it. The decision is the scene's, the error it accepts is
    shown, and a person can decide otherwise."""

    label: str  # what is left out
    error: Term | float  # what that costs, as a share: 0.01 is one percent
    limit: float  # it is left out where it costs less
    instead: str  # what stands in for it
    without: dict[str, str] = field(default_factory=dict)  # functions of the scene -> those instead, where it is out
    within: dict[str, str] = field(default_factory=dict)  # the same where it is in: the scene is written without it
    of: str = ""  # what the error is a share of: "of the light"; the value itself without a word


@dataclass(frozen=True)
class Check:
    """Points at which a student's function is compared with the twin: argument name to numbers."""

    args: dict[str, tuple]
    words: str
    hidden: bool = False


@dataclass(frozen=True)
class Exercise:
    """Write this twin. The stub must fail and the solution must pass in each language."""

    name: str
    function: str
    task: str
    slide: str
    stubs: dict[str, str]  # "python" and "glsl"
    solutions: dict[str, str]
    checks: tuple[Check, ...]
