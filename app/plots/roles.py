"""How a Curves plot tells its curves apart, and what it says about them; no drawing."""

from app.lesson import Curve, Curves
from app.plots.look import Look, Rgb
from app.plots.sweep import Sweep, Swept
from app.plots.ticks import number

COLOUR = {"exact": "exact", "estimate": "estimate", "printed": "printed"}
LINES = {"exact": ("solid", "dashed", "dotted"), "printed": ("dashdot", "dotted", "dashed"),
         "estimate": ("circle", "cross", "diamond", "square")}  # the second of a role still differs without colour


def colour_of(curve: Curve, look: Look) -> Rgb:
    return look.colour(curve.colour or COLOUR[curve.role])


def samples(plot: Curves, left_out: int | None) -> list[str]:
    """How each curve is drawn; "" for the exact one that errors are taken against."""
    found, used = [], dict.fromkeys(LINES, 0)
    for i, curve in enumerate(plot.curves):
        if i == left_out:
            found.append("")
            continue
        kinds = LINES[curve.role]
        found.append(kinds[used[curve.role] % len(kinds)])
        used[curve.role] += 1
    return found


def nothing_in(curves: list[Swept]) -> list[str]:
    """One short sentence for all curves of which a logarithmic axis has nothing to show."""
    labels = [f"“{c.curve.label}”" for c in curves if c.not_positive and c.not_positive == len(c.y)]
    if not labels:
        return []
    which = f"{labels[0]} is" if len(labels) == 1 else f"{len(labels)} of {len(curves)} curves are"
    return [f"{which} 0 everywhere"]


def notices_of(curve: Swept) -> list[str]:
    found = []
    count = int(curve.not_finite.sum())
    if count:
        found.append(f"“{curve.curve.label}”: {count} {'point is' if count == 1 else 'points are'} not finite")
    if curve.cut:
        found.append(f"“{curve.curve.label}” goes up to {curve.cut:.3g} and is cut")
    if 0 < curve.not_positive < len(curve.y):
        found.append(f"“{curve.curve.label}”: {curve.not_positive} not above 0, off a logarithmic axis")
    return found


def y_title(plot: Curves, sweep: Sweep) -> str:
    if not plot.error or sweep.exact is None:
        return plot.y_label
    return f"{plot.y_label} against {plot.curves[sweep.exact].label}; 0 drawn at {number(sweep.floor)}"
