"""What can be set on the board: directions, what is shown of them, and the models' own parameters."""

import math

from app.board.brdf_file import Parameter
from app.catalog import ValueSpec
from app.lesson import Number
from app.quantities import Quantity, quantity
from app.spoken import words

VIEWS = ("lit", "n", "l", "v", "h", "n·l", "n·v", "n·h", "l·h", "D", "G", "F", "f", "f n·l")
SCALES = "f", "f n·l", "log f"
CHANNELS = "red", "green", "blue", "luminance"
TURNED = -0.7  # rad: the picked point lies to the upper left
STEEPEST = math.radians(89.9)


def choice(name: str, label: str, words: str, choices: tuple[str, ...], default: int = 0,
           unfolds: bool = True) -> ValueSpec:
    high = len(choices) - 1
    return ValueSpec(name, Quantity("k", "", 0, high, default, words, kind="int"), default, 0, high, choices=choices,
                     label=label, unfolds=unfolds)


def angle(name: str, default: float, label: str = "") -> ValueSpec:
    q = quantity(name)
    high = min(q.high, STEEPEST) if name.startswith("theta") else q.high
    return ValueSpec(name, q, default, q.low, high, label=label)


def number(name: str, label: str, words: str, low: float, high: float, default: float, unit: str = "") -> ValueSpec:
    return ValueSpec(name, Quantity(label, unit, low, high, default, words, scale="log"), default, low, high, "log",
                     label=label)


def of_parameter(p: Parameter, prefix: str, model: str) -> ValueSpec:
    """A parameter of a file, or of a model of the course as the table has it."""
    name, told = prefix + p.name, f"a parameter of {model}"
    label = p.name if p.line else words(p.name)
    if p.type == "bool":
        return choice(name, label, told, ("no", "yes"), int(bool(p.default)), False)
    if p.type == "color":
        default: Number = tuple(float(x) for x in p.default)  # type: ignore[union-attr]
        high = max(1.0, *default)  # type: ignore[misc]
        return ValueSpec(name, Quantity(p.name, "", 0.0, high, default, told, kind="color"), default, 0.0, high,
                         label=label)
    first = float(p.default)  # type: ignore[arg-type]
    q = Quantity(p.name, p.unit, p.low, p.high, first, told, scale=p.scale, kind="int" if p.whole else "float")
    return ValueSpec(name, q, round(first) if p.whole else first, p.low, p.high, p.scale, label=label)


def specs(models: list[str], own: list[tuple[Parameter, str, str]], angles: dict[str, float], top: float,
          is_log: bool) -> dict[str, ValueSpec]:
    """name -> what can be set; `own` are parameters with their prefix and the model they are of."""
    found = [angle("theta_l", angles["theta_l"]), angle("theta_v", angles["theta_v"]), angle("phi", angles["phi"]),
             angle("turned", TURNED),
             choice("lobe_scale", "lobes show", "the length of a lobe", SCALES, 2 * is_log, False),
             number("lobe_top", "ring stands for", "the value that a lobe of length 1 has", 1e-3, 1e6, top, "1/sr"),
             choice("model", "large", "the model of the large ball", tuple(models)),
             choice("stands", "beside it", "what stands beside the ball", ("lobes", "object"), unfolds=False),
             choice("shape", "object", "the shape of the object", ("sphere", "knot", "bowl", "cube"), 1),
             choice("shows", "balls show", "light, a vector, a cosine or a factor", VIEWS),
             choice("board_channel", "channel", "of lobes, curves and numbers", CHANNELS, 3),
             number("light", "light E", "what the light brings on what faces it", 0.05, 100.0, math.pi, "W/m²")]
    found += [of_parameter(p, prefix, model) for p, prefix, model in own]
    return {spec.name: spec for spec in found}
