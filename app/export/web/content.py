"""What a step's page carries, as plain data: its scene as texts for WebGL2, its values, twins, plots and question."""

import math

import numpy as np

from app import badges as judge
from app import furnace, tables
from app.badges import SHORT, of_model, told
from app.breaking import broken, values_of
from app.catalog import LoadedStep, ValueSpec
from app.export.web.figures import plot
from app.export.web.texts import Data, Twins, packed, scene
from app.gpu.stage_text import COLOURS, look
from app.lesson import Model, Readout
from app.optics import arguments
from app.prediction import truth_values
from app.quadrature import gauss_legendre
from app.quantities import FROM_ANGLES, shown
from app.readouts import ROUNDING, SUMS
from app.spoken import said, words
from app.state import defaults
from app.theme import THEMES, Theme, colour, rgb

SAME = 3e-6  # in pages: two ways around one of our float32 twins differ by up to 3e-7, other formulas by more
QUIET = "#5D6574"  # small words on the light theme's panel: 4.5 to 1


def content(found: LoadedStep) -> Data:
    """All of a step that the player plays; what needs OpenGL (its poster) is not here."""
    step, twins = found.step, Twins()
    data: Data = {
        "step": found.id, "title": step.title,
        "values": [value(spec) for spec in found.values.values()],
        "scene": scene(step.scene, found.file_name, found.glsl_line),
        "readouts": [readout(one, twins) for one in step.readouts],
        "plots": [plot(one, found, twins) for one in step.plots],
        "ask": question(found, twins),
        "badges": [badges(model, defaults(found), twins) for model in step.models],
        "themes": {name: themed(theme) for name, theme in THEMES.items()},
    }
    if step.models:
        data["rules"] = rules()
    data["breaks"] = [breakage(found, i, twins) for i in range(len(step.breaks))]
    return data | {"twins": twins.found} | constants(found)


def breakage(found: LoadedStep, which: int, twins: Twins) -> Data:
    """The step with naive forms in the place of stable ones, and the values at which that shows."""
    one, changed = found.step.breaks[which], broken(found, which)
    return {"label": one.label, "told": one.told, "sets": values_of(found, one),
            "scene": scene(changed.step.scene, found.file_name, found.glsl_line),
            "readouts": [readout(one, twins) for one in changed.step.readouts],
            "plots": [plot(one, changed, twins) for one in changed.step.plots]}


def readout(one: Readout, twins: Twins) -> Data:
    """`nothing`: of that size a signed sum is 0, but for rounding in float32."""
    nothing = 8 * ROUNDING["float32"] * SUMS.get(one.term.function, 0.0)
    return {"label": one.label, "term": twins.term(one.term), "role": one.role, "unit": one.unit,
            "against": one.against, "absent": one.absent, "nothing": nothing}


def value(spec: ValueSpec) -> Data:
    low, high = shown(spec.name, spec.low), shown(spec.name, spec.high)
    return {"name": spec.name, "label": said(spec.name) if spec.choices else words(spec.name),
            "words": spec.quantity.words, "unit": spec.quantity.screen_unit, "angle": spec.quantity.is_angle,
            "whole": spec.quantity.kind == "int", "default": spec.default, "low": spec.low, "high": spec.high,
            "shown": [low, high], "log": spec.scale == "log", "more": spec.more, "choices": spec.choices}


def question(found: LoadedStep, twins: Twins) -> Data:
    ask = found.step.ask
    choices = [{"text": c.text, "low": bounded(c.low), "high": bounded(c.high)} for c in ask.choices]
    return {"question": ask.question, "unit": ask.unit, "told": ask.told, "low": ask.low, "high": ask.high,
            "log": ask.scale == "log", "choices": choices, "truth": twins.term(ask.truth),
            "values": truth_values(found), "sets": bool(ask.sets)}


def bounded(x: float) -> float:
    """JSON has no infinity."""
    return x if math.isfinite(x) else math.copysign(1e300, x)


def badges(model: Model, values: dict, twins: Twins) -> Data:
    """A model's badges at these values (float64), and what the page needs to find them at others."""
    used = [name for name in model_values(model) if name in values]
    return {"label": model.label, "ink": model.colour, "depends": used, "term": twins.term(model.term),
            "shading": model.is_shading, "linear": "radiance" in arguments(model.term.function),
            "found": [{"name": name, "short": SHORT[name], "ok": badge.ok, "told": told(name, badge)}
                      for name, badge in of_model(model, values).items()]}


def rules() -> Data:
    """The directions at which badges look, their limits and their words: one source for desktop and page."""
    return {"views": judge.VIEWS.tolist(), "extremes": judge.EXTREMES.tolist(), "turns": judge.AROUND.tolist(),
            "seen": judge.SEEN, "same": SAME, "limit": judge.MOST, "radiances": judge.RADIANCES,
            "along": list(zip(*map(list, gauss_legendre(furnace.FIRST[0])), strict=True)),
            "around": furnace.FIRST[1], "tile": list(zip(*map(list, gauss_legendre(furnace.ORDER)), strict=True)),
            "narrowest": furnace.NARROWEST, "part": furnace.PART,
            "told": judge.TOLD, "unknown": judge.UNKNOWN, "names": judge.PLACES}


def model_values(model: Model) -> list[str]:
    term = model.term
    named = [term.args.get(name, name) for name in arguments(term.function)]
    return [name for name in named if isinstance(name, str) and name not in FROM_ANGLES]


def themed(theme: Theme) -> Data:
    """The theme for the shaders (linear light) and for the page (sRGB)."""
    seen = look(theme)
    names = (*COLOURS, "background", "panel", "foreground")
    css = {name: "#" + "".join(f"{round(255 * x):02X}" for x in colour(name, theme)) for name in names}
    return {"line": theme.line, "linear": rounded(seen["background"]), "srgb": rgb(theme.background),
            "palette": rounded(np.frombuffer(seen["palette"], "f4")),
            "stops": rounded(np.frombuffer(seen["colormap_stops"], "f4")),
            "css": css | ({"quiet": QUIET} if theme.name == "light" else {})}


def rounded(numbers) -> list[float]:
    """float32 numbers in as many digits as they need."""
    return [float(f"{x:.9g}") for x in np.asarray(numbers, float).ravel()]


def constants(found: LoadedStep) -> Data:
    """The names of the step's meshes, which the page makes itself, and its tables: rows and columns, base64."""
    one = found.step.scene
    carried: Data = {"meshes": [], "tables": []}
    if any(surface.mesh for surface in one.surfaces):
        carried["meshes"] = list(one.meshes)
    for table in one.tables:
        if table.map:  # a student's own picture, which a page has none of
            none = np.asarray(tables.texels(table.map, None))
            carried["tables"].append({"uniform": table.uniform, "choice": "", "files": [
                {"rows": none.shape[0], "columns": none.shape[1], "picture": packed(none.astype("u1"))}]})
            continue
        files = [np.ascontiguousarray(tables.built_in(name).table, "f4") for name in table.files]
        carried["tables"].append({"uniform": table.uniform, "choice": table.choice, "files": [
            {"rows": t.shape[0], "columns": t.shape[1], "numbers": packed(t)} for t in files]})
    return carried

