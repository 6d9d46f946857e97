"""A step's film beside its page, for slides that run nothing live: a GIF, which PowerPoint and Google Slides play."""

from app.catalog import LoadedStep, ValueSpec
from app.export.animate import Filming, ways
from app.export.film import film
from app.lesson import Curves
from app.motion import Sweep
from app.state import defaults
from app.theme import THEMES

SIZE, SECONDS, FPS = (640, 360), 4.0, 12


def moving(found: LoadedStep) -> bytes | None:
    """The scene while its main value goes over its range and back; None where there is none."""
    spec = main_value(found)
    if spec is None:
        return None
    shares = ways(SECONDS, FPS, True)
    way = [Sweep(spec, spec.low, spec.high)]
    with Filming(found, defaults(found), None, way, SIZE, THEMES["dark"], "scene", 0) as one:
        made = {share: one.frame(share) for share in sorted(set(shares))}
    return film([made[share] for share in shares], ".gif", FPS)


def main_value(found: LoadedStep) -> ValueSpec | None:
    """What the step's plot goes over, else what its first handle moves, else its first; a continuous one if any."""
    swept = [plot.sweep for plot in found.step.plots if isinstance(plot, Curves)]
    held = [name for handle in found.step.scene.handles for name in handle.values]
    specs = [found.values[name] for name in (*swept, *held, *found.values) if name in found.values]
    specs = sorted((spec for spec in specs if spec.quantity.width == 1), key=lambda spec: spec.quantity.kind == "int")
    return specs[0] if specs else None
