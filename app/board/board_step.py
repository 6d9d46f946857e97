"""The board as a step that is made when it is asked for: `board/cook_torrance+my/file.brdf`, the words of its models
with a plus between them, those that are off behind a minus. Window, stills and state strings know it like any other.
"""

import math
import os
from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache
from pathlib import Path
from urllib.parse import quote, unquote

import numpy as np

from app.board import settings
from app.board.board_values import specs
from app.board.brdf_file import Default
from app.board.course_model import CourseModel
from app.board.factors import factors, labels
from app.board.models import BoardModel, opened
from app.board.scene_text import scene
from app.board.terms import LUMINANCE, channel_of, packed
from app.brush import tangent_azimuth
from app.catalog import BOARD, Loaded, LoadedStep, ValueSpec
from app.hemisphere import NORMAL, apart
from app.lesson import (
    Chapter,
    Colour,
    Curve,
    Curves,
    ImageSlice,
    Lobes,
    Model,
    Plot,
    Prediction,
    Readout,
    Slice,
    Step,
    Term,
)
from app.needs import of_term
from app.optics.spherical import direction, light_direction, view_direction
from app.problem import Problem, Usage
from app.state import write
from app.terms import evaluate

COLOURS: tuple[Colour, ...] = ("estimate", "f", "g", "exact")  # none of a direction's
ROLES = ("exact", "exact", "printed", "exact")  # drawn solid, dashed, dash-dotted, dotted, as slices are
MOST = len(COLOURS)  # models that are on
FIRST = "cook_torrance"
ANGLES = {"theta_l": math.radians(45), "theta_v": math.radians(30), "phi": math.pi}
SPREAD = 8  # peaks that differ by more than this are shown on a logarithmic scale
CHANNEL = "board_channel"
VALUES, OF_H = "_values", "_half_values"  # behind a model's prefix: no parameter of a file begins with _


@dataclass(frozen=True, eq=False)
class Entry:
    """A line of the board's list: a model, or why it is none."""

    word: str
    label: str
    on: bool
    model: BoardModel | None
    fault: str = ""
    colour: Colour = "quiet"
    prefix: str = ""

    def term(self, kind: str = "board") -> Term:
        ending = OF_H if kind == "half" else VALUES
        return Term(f"{kind}:{self.word}", {"values": self.prefix + ending, "channel": CHANNEL})

    @property
    def factors(self) -> tuple[Readout, ...]:
        """D, G, F and the denominator of a model of the course that is made of them."""
        if not isinstance(self.model, CourseModel):
            return ()
        terms = zip(labels(self.model.name), factors(self.model.name, self.prefix), strict=True)
        return tuple(Readout(label, term, unit="1/sr" if label == "D" else "") for label, term in terms)


@dataclass(frozen=True, eq=False)
class BoardStep(LoadedStep):
    entries: tuple[Entry, ...] = field(default=())
    top: float = 1.0  # 1/sr, of the longest lobe at first
    is_log: bool = False

    @property
    def file_name(self) -> str:
        return "the board"

    glsl_line = 1  # type: ignore[assignment]

    @property
    def shown(self) -> tuple[Entry, ...]:
        return tuple(one for one in self.entries if one.on and one.model)

    @cached_property
    def values(self) -> dict[str, ValueSpec]:
        own = [(p, one.prefix, one.label) for one in self.shown if one.model for p in one.model.parameters]
        return specs([one.label for one in self.shown], own, ANGLES, self.top, self.is_log)

    @property
    def below(self) -> tuple[ValueSpec, ...]:
        return tuple(self.values[name] for name in ("theta_l", "theta_v", "phi", "lobe_scale"))

    def derived(self, values: dict) -> dict:
        """The cosines, the angles of the halfway vector, and each model's parameters as one tuple."""
        l, v = light_direction(values["theta_l"], values["phi"]), view_direction(values["theta_v"])
        h = l + v
        length = float(np.linalg.norm(h))
        h = h / length if length > 1e-12 else NORMAL
        found: dict = dict(zip(("n_dot_l", "n_dot_v", "n_dot_h", "l_dot_h"), map(float, (l[2], v[2], h[2], l @ h)),
                               strict=True))
        found |= {"theta_h": float(apart(h, NORMAL)), "theta_d": float(apart(l, h)), "phi_d": turn_of(l, h)}
        tangent = tangent_azimuth(values["theta_v"], values["turned"])
        of_h = tangent - (math.atan2(h[1], h[0]) if math.hypot(h[0], h[1]) >= 1e-9 else 0.0)
        for one in self.shown:
            assert one.model
            given: dict[str, Default] = {p.name: values[one.prefix + p.name] for p in one.model.parameters}
            for ending, azimuth in ((VALUES, tangent), (OF_H, of_h)):
                turned = (azimuth,) if one.model.is_anisotropic else ()
                found[one.prefix + ending] = packed(one.model.parameters, given, *turned)
        return found

    def carried(self, other: LoadedStep, values: dict) -> dict:
        """Directions and views, and the parameters of the models that are on both boards."""
        if not isinstance(other, BoardStep):
            return {}
        before = {one.word: one.prefix for one in other.shown}
        named = {name: name for name in self.values if name not in ("model", "lobe_top", "lobe_scale")}
        for one in self.shown:
            for p in one.model.parameters if one.model else ():
                named[one.prefix + p.name] = before.get(one.word, "?") + p.name
        return {name: values[was] for name, was in named.items() if was in values}

    @cached_property
    def peak_needs(self) -> frozenset[str]:
        """The values that `peak` depends on."""
        names = frozenset[str]().union(*(of_term(one.term()) for one in self.shown))
        return (names | {"lobe_scale", "theta_l"}) - {"theta_v", "phi"}

    def peak(self, values: dict) -> float:
        """The largest value of the lobes, in the plane of incidence."""
        given = {**values, **self.derived(values)}
        d = direction(np.linspace(-1.55, 1.55, 301), 0.0)
        with np.errstate(all="ignore"):
            l = light_direction(values["theta_l"], math.pi)
            found = [evaluate(one.term(), given, v=d, l=l) for one in self.shown]
        most = float(np.nan_to_num(np.array(found), nan=0, posinf=0).max())
        return most * math.cos(values["theta_l"]) if values["lobe_scale"] == 1 else most


def turn_of(l: np.ndarray, h: np.ndarray) -> float:
    """phi_d of `half:`: the light's turn about the halfway vector, which leans towards +x."""
    sine = math.hypot(h[0], h[1])
    if sine < 1e-9:
        return math.atan2(l[1], l[0])
    x, y = h[0] / sine, h[1] / sine
    return math.atan2(float(l[1] * x - l[0] * y), float((l[0] * x + l[1] * y) * h[2] - l[2] * sine))


# --- words -----------------------------------------------------------------------------------------------------------
def name_of(words: list[tuple[str, bool]]) -> str:
    """The step's name: words of models, and which are on."""
    def coded(word: str) -> str:
        text = quote(word, safe="/._~:\\")
        return "%2D" + text[1:] if text.startswith("-") else text

    return "+".join(("" if on else "-") + coded(word) for word, on in words)


def words_of(name: str) -> list[tuple[str, bool]]:
    return [(unquote(part.removeprefix("-")), not part.startswith("-")) for part in name.split("+") if part]


def id_of(words: list[str]) -> str:
    """The board of these models: the first MOST that can be drawn are on."""
    return BOARD + name_of([(word, True) for word in dict.fromkeys(words)] or [(FIRST, True)])


def started(id: str, given: list[str]) -> str:
    """The state string of a board with parameters `name=value` of its models."""
    found = step(id.removeprefix(BOARD))
    settings.checked([one.model for one in found.shown if one.model], given)
    values = {one.prefix + name: value for one in found.shown if one.model
              for name, value in settings.of_model(one.model, given).items()}
    return write(found, values)


def step(name: str) -> BoardStep:
    words = words_of(name)
    stamps = tuple((about.st_mtime_ns, about.st_size) if (about := stat(word)) else () for word, _ in words)
    return made(tuple(words), stamps)


def stat(word: str) -> os.stat_result | None:
    try:
        return os.stat(word)
    except (OSError, ValueError):
        return None


@lru_cache(8)
def made(words: tuple[tuple[str, bool], ...], stamps: tuple) -> BoardStep:
    if not words:
        raise Usage("a board without a model; write one behind board/, as in board/cook_torrance.")
    entries: list[Entry] = []
    problems: list[Problem] = []
    peaks: dict[str, float] = {}
    on = 0
    for i, (word, wanted) in enumerate(words):
        try:
            model = opened(word)
            if wanted and on < MOST:
                peaks[word] = peak(model)
                entries.append(Entry(word, model.name, True, model, "", COLOURS[on], f"model{i}_"))
                on += 1
            else:
                entries.append(Entry(word, model.name, False, model, prefix=f"model{i}_"))
        except Problem as problem:
            problems.append(problem)
            entries.append(Entry(word, Path(word).stem, False, None, str(problem)))
    if not on:
        raise problems[0] if problems else Usage("every model of the board is off; one without a minus is on.")
    return assembled(name_of(list(words)), tuple(entries), peaks)


def peak(model: BoardModel) -> float:
    """The largest value in the plane of incidence, at the first angles; a file that does not compile is a Problem."""
    l, v = direction(ANGLES["theta_l"], ANGLES["phi"]), direction(np.linspace(-1.5, 1.5, 301), 0.0)
    with np.errstate(all="ignore"):
        found = channel_of(np.asarray(model.rgb(NORMAL, l, v), float), LUMINANCE)
    return float(np.nan_to_num(found, nan=0, posinf=0).max())


def assembled(name: str, entries: tuple[Entry, ...], peaks: dict[str, float]) -> BoardStep:
    labels = {one.word: label for one, label in zip(entries, told_apart([e.label for e in entries]), strict=True)}
    entries = tuple(replace(one, label=labels[one.word]) for one in entries)
    shown = [one for one in entries if one.on and one.model]
    most, least = max(peaks.values()), min(peaks.values())
    is_log = most > SPREAD * max(least, 1e-300)
    models = tuple(Model(one.label, one.term(), one.colour) for one in shown)
    readouts = tuple(Readout(f"f, {one.label}" if len(shown) > 1 else "f", one.term(), unit="1/sr") for one in shown)
    if len(shown) == 1:
        readouts = (*shown[0].factors, *readouts)
    made_of = Step(
        name=name, title=", ".join(one.label for one in shown),
        idea="A reflectance as an object to examine: what it sends where, and what it breaks.", slides=(), prose="",
        scene=scene([(one.label, one.model, one.colour, one.prefix) for one in shown if one.model]),
        plot=plots(shown), readouts=readouts, models=models,
        ask=Prediction(f"How much of the light does {shown[0].label} send on, seen from straight above?",
                       Term(f"albedo:{shown[0].word}", {
                           "theta_v": 0.0, "channel": LUMINANCE,
                           "values": packed(shown[0].model.parameters, {})}), "of 1",  # type: ignore[union-attr]
                       "Its directional albedo, by quadrature.", 0.0, 2.0),
        notes="Ask for a badge before you show it, then click it: it goes where the model is worst.",
        sources=("Walt Disney Animation Studios, BRDF Explorer: the files",
                 "Matusik, Pfister, Brand and McMillan 2003: measurements"),
        honesty="Light and eye are infinitely far, nothing throws a shadow, and what is brighter than 1 is cut. Where "
                "a file asks for X and Y, X runs along growing azimuth about the picture's upward direction, around "
                "balls and objects, and Y is N × X; lobes, curves and numbers have the X of the picked point, so "
                "that “turned” turns it against the light. Badges look at X on the eye's side.")
    intro = "Any reflectance model, of the course or of a file."
    chapter = Chapter("The board", "Models as objects to examine.", ())
    top = round_up(most) if most > 0 else 1.0
    return BoardStep(Loaded(BOARD.rstrip("/"), 9, Path("board"), intro, chapter), made_of, 0, entries, top, is_log)


def told_apart(labels: list[str]) -> list[str]:
    """The same, with a number behind those that are there twice."""
    return [label if labels.count(label) == 1 else f"{label} {labels[:i].count(label) + 1}"
            for i, label in enumerate(labels)]


def round_up(value: float) -> float:
    """1, 2 or 5 times a power of ten."""
    power = 10.0 ** math.floor(math.log10(value))
    return power * next(m for m in (1, 2, 5, 10) if m * power >= value * (1 - 1e-9))


def plots(shown: list[Entry]) -> tuple[Plot, ...]:
    def curves(title: str, sweep: str, kind: str, y_label: str, tab: str) -> Curves:
        lines = tuple(Curve(one.label, one.term(kind), role, colour=one.colour)  # type: ignore[arg-type]
                      for one, role in zip(shown, ROLES, strict=False))
        return Curves(title, sweep, lines, y_label, tab=tab)

    return (Slice("Plane of incidence"), Slice("By the eye's angle", kind="angle", tab="θv"),
            curves("By the angle of h", "theta_h", "half", "f in 1/sr", "θh"),
            curves("By the angle of l from h", "theta_d", "half", "f in 1/sr", "θd"),
            curves("Albedo, by the eye's angle", "theta_v", "albedo", "share of the light sent on", "albedo"),
            ImageSlice("In its own angles"), Lobes("Lobes"))
