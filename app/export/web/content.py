"""What a step's page carries, as plain data: its scene as texts for WebGL2, its values, twins, plots and question."""

import numpy as np

from app import tables
from app.breaking import broken, values_of
from app.catalog import LoadedStep, ValueSpec
from app.export.still import data as carried
from app.export.web.figures import plot
from app.export.web.judged import badges, rules
from app.export.web.texts import Data, Twins, packed, scene
from app.gpu.stage_text import COLOURS, look
from app.lesson import Prediction, Readout
from app.optics.colour import srgb_to_linear
from app.prediction import guessed, is_right, revealed, truth, truth_values, words
from app.readouts import ROUNDING, SUMS
from app.state import defaults
from app.theme import THEMES, Theme, colour, rgb
from app.typed import slug

PLACES = 200  # of the guess's slider
READABLE = 4.5  # contrast of words
QUIET = "#5D6574"  # small words on the light theme's panel: 4.5 to 1


def content(found: LoadedStep) -> Data:
    """All of a step that the player plays; what needs OpenGL (its poster) is not here."""
    step, twins = found.step, Twins()
    data: Data = {
        "step": found.id,
        "values": [value(spec) for spec in found.values.values()],
        "scene": scene(step.scene, found.file_name, found.glsl_line),
        "readouts": [readout(one, twins) for one in step.readouts],
        "plots": [plot(one, found, twins) for one in step.plots],
        "ask": question(found),
        "badges": [badges(model, defaults(found), twins) for model in step.models],
        "themes": {name: themed(theme) for name, theme in THEMES.items()},
    }
    if step.models:
        data["rules"] = rules()
    data["breaks"] = [breakage(found, i, twins, data["plots"]) for i in range(len(step.breaks))]
    return data | {"twins": twins.found} | constants(found)


def breakage(found: LoadedStep, which: int, twins: Twins, plots: list[Data]) -> Data:
    """The step with naive forms in the place of stable ones, and the values at which that shows; a plot that changes
    joins the others, and `put` says in whose place it stands."""
    one, changed = found.step.breaks[which], broken(found, which)
    put = {}
    for i, (before, now) in enumerate(zip(found.step.plots, changed.step.plots, strict=True)):
        made = plot(now, changed, twins) if now != before else {"kind": "still"}
        if made["kind"] != "still":
            put[i] = len(plots)
            plots.append(made)
    return {"told": one.told, "sets": values_of(found, one), "put": put,
            "scene": scene(changed.step.scene, found.file_name, found.glsl_line),
            "readouts": [readout(one, twins) for one in changed.step.readouts]}


def readout(one: Readout, twins: Twins) -> Data:
    """`nothing`: of that size a signed sum is 0, but for rounding in float32."""
    nothing = 8 * ROUNDING["float32"] * SUMS.get(one.term.function, 0.0)
    return {"label": one.label, "term": twins.term(one.term), "unit": one.unit, "against": one.against,
            "absent": one.absent, "nothing": nothing}


def value(spec: ValueSpec) -> Data:
    """What its controls and links need; `choices` are the words that a link may have."""
    words = [slug(choice) for choice in spec.choices]
    return {"name": spec.name, "unit": spec.quantity.screen_unit, "angle": spec.quantity.is_angle,
            "whole": spec.quantity.kind == "int", "default": spec.default, "low": spec.low, "high": spec.high,
            "log": spec.scale == "log", "choices": [word if words.count(word) == 1 else "" for word in words]}


def question(found: LoadedStep) -> Data:
    """The words for every guess: one for each place of the slider, or each choice and then for none."""
    ask = found.step.ask
    true = truth(found, **carried(found, truth_values(found)))
    guesses = range(len(ask.choices)) if ask.choices else [place(ask, i / PLACES) for i in range(PLACES + 1)]
    answers = [revealed(guessed(ask, guess), true) for guess in guesses]
    answers += [answer for answer in answers if ask.choices and not is_right(ask, answer)][:1]  # as for no choice
    verdicts = [words(ask, answer) for answer in answers]
    ending = verdicts[0]  # of all of them: written once, for there may be 201
    while not all(verdict.endswith(ending) for verdict in verdicts):
        ending = ending[1:]
    return {"unit": ask.unit, "low": ask.low, "high": ask.high, "log": ask.scale == "log", "ending": ending,
            "verdicts": [verdict.removesuffix(ending) for verdict in verdicts],
            "sets": truth_values(found) if ask.sets else {}}


def place(ask: Prediction, share: float) -> float:
    if share == 1:
        return ask.high
    return ask.low * (ask.high / ask.low) ** share if ask.scale == "log" else ask.low + share * (ask.high - ask.low)


def themed(theme: Theme) -> Data:
    """The theme for the shaders, in linear light but for what clears the picture."""
    seen = look(theme)
    return {"line": theme.line, "linear": rounded(seen["background"]), "srgb": rgb(theme.background),
            "palette": rounded(np.frombuffer(seen["palette"], "f4")),
            "stops": rounded(np.frombuffer(seen["colormap_stops"], "f4"))}


def inks(theme: Theme) -> dict[str, str]:
    """The theme's colours by name, for the page around the picture; `l-text` is the colour l for words."""
    names = (*COLOURS, "background", "panel", "foreground")
    found = {name: css(colour(name, theme)) for name in names} | ({"quiet": QUIET} if theme.name == "light" else {})
    return found | {f"{name}-text": readable(found[name], found) for name in COLOURS}


def css(found) -> str:
    return "#" + "".join(f"{round(255 * x):02X}" for x in found)


def readable(ink: str, page: dict[str, str]) -> str:
    """A colour moved towards the foreground until words in it can be read on page and panel (WCAG 2.2 AA)."""
    base, front = (np.array(rgb(text)) for text in (ink, page["foreground"]))
    mixed = (css(base + share * (front - base)) for share in np.linspace(0, 1, 51))
    return next(text for text in mixed if min(contrast(text, page[on]) for on in ("background", "panel")) >= READABLE)


def contrast(one: str, other: str) -> float:
    """(L + 0.05) / (L' + 0.05) of two sRGB colours' relative luminances, the lighter above: 1 to 21 (WCAG 2.2)."""
    seen = (srgb_to_linear(np.array(rgb(text))) for text in (one, other))
    dark, light = sorted(float(np.dot((0.2126, 0.7152, 0.0722), x)) for x in seen)
    return (light + 0.05) / (dark + 0.05)


def rounded(numbers) -> list[float]:
    """float32 numbers in as many digits as they need."""
    return [float(f"{x:.9g}") for x in np.asarray(numbers, float).ravel()]


def constants(found: LoadedStep) -> Data:
    """The names of the step's meshes, which the page makes itself, and its tables: rows and columns, base64."""
    one = found.step.scene
    found_: Data = {"meshes": [], "tables": []}
    if any(surface.mesh for surface in one.surfaces):
        found_["meshes"] = list(one.meshes)
    for table in one.tables:
        if table.map:  # a student's own picture, which a page has none of
            files, kind = [np.asarray(tables.texels(table.map, None)).astype("u1")], "RGBA8"
        else:
            files, kind = [np.asarray(tables.built_in(name).table, "f4") for name in table.files], "R32F"
        found_["tables"].append({"uniform": table.uniform, "choice": "" if table.map else table.choice, "files": [
            {"format": kind, "rows": t.shape[0], "columns": t.shape[1], "numbers": packed(t)} for t in files]})
    return found_

