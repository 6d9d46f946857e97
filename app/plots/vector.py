"""Curves and slices as SVG or PDF, for handouts: matplotlib draws the numbers of the picture, text stays text."""

from io import BytesIO

import numpy as np
from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.font_manager import FontProperties

from app.lesson import Curves, Plot, Slice
from app.plots.dashes import PATTERN
from app.plots.look import Look
from app.plots.models import unit_of
from app.plots.roles import colour_of, nothing_in, notices_of, samples, y_title
from app.plots.slices import LINES, SlicePart
from app.plots.sweep import Sweep, widened
from app.plots.words import SHAPES
from app.problem import Usage
from app.readouts import three
from app.spoken import axis_title
from app.theme import Theme

DPI = 96  # a pixel of the picture is a pixel of CSS
MARKER = {"circle": "o", "cross": "x", "diamond": "D", "square": "s"}
PLAIN: dict = {"svg.fonttype": "none", "svg.hashsalt": "halfway", "pdf.fonttype": 42, "font.family": "sans-serif",
         "path.simplify": False, "figure.constrained_layout.w_pad": 0.14, "figure.constrained_layout.h_pad": 0.12}


def drawing(plot: Plot, values: dict, size: tuple[int, int], theme: Theme, ranges: dict, kind: str,
            state: str = "") -> bytes:
    """The file's content, the same every time; `kind` is svg or pdf. A plot that is a picture is a Usage."""
    if not isinstance(plot, Curves | Slice):
        raise Usage(f"the plot {plot.title!r} is a picture in space, and SVG and PDF are for curves; write a .png.")
    look = Look(theme, size)
    with rc_context(PLAIN):
        figure = Figure(figsize=(size[0] / DPI, size[1] / DPI), dpi=DPI, facecolor=look.background,
                        layout="constrained")
        axes = figure.add_subplot()
        axes.set_facecolor(look.background)
        notes = curves(axes, plot, values, look, ranges) if isinstance(plot, Curves) else sliced(
            axes, plot, values, look)
        axes.set_title(plot.title, loc="left", color=look.foreground, fontproperties=letters(look, look.text), pad=10)
        if notes:
            axes.text(0.5, 0.5, "\n".join(notes), transform=axes.transAxes, ha="center", va="center",
                      color=look.foreground, fontproperties=letters(look, look.small),
                      bbox={"facecolor": look.background, "edgecolor": look.foreground})
        out = BytesIO()
        words: dict = {"Title": plot.title, "Creator": "Halfway"}
        words |= {"Date": None, "Description": state} if kind == "svg" else {"CreationDate": None, "Subject": state}
        figure.savefig(out, format=kind, metadata=words, facecolor=look.background)
    return out.getvalue()


def letters(look: Look, px: float) -> FontProperties:
    """By the font's name in an SVG, so that its words stay words: it is shown in what a reader has."""
    return FontProperties(family=["DejaVu Sans", "sans-serif"], size=px * 72 / DPI)


def points(look: Look, share: float = 1.0) -> float:
    return max(1.0, look.line * share) * 72 / DPI


def dash(sample: str) -> str | tuple:
    return (0, PATTERN[sample]) if sample in PATTERN else "-"


def framed(axes: Axes, look: Look) -> None:
    axes.grid(True, color=look.grid, linewidth=points(look, 0.5))
    axes.set_axisbelow(True)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    for spine in axes.spines.values():
        spine.set_color(look.quiet)
    axes.tick_params(length=0, labelcolor=look.foreground)
    for label in (*axes.get_xticklabels(), *axes.get_yticklabels()):
        label.set_fontproperties(letters(look, look.small))


def legend(axes: Axes, look: Look, columns: int) -> None:
    """Above the axes and below the title, where it covers no curve."""
    handles, labels = axes.get_legend_handles_labels()
    if handles:
        axes.figure.legend(handles, labels, loc="outside lower center", ncols=columns, frameon=False,
                           labelcolor=look.foreground, prop=letters(look, look.small), handlelength=2.6)


def curves(axes: Axes, plot: Curves, values: dict, look: Look, ranges: dict) -> list[str]:
    """The curves of a picture with the same ends, ticks, words and samples; what must be said about them."""
    sweep = Sweep(plot, ranges)
    drawn = sweep.run(values)
    frame, across = sweep.framed(drawn), sweep.axis
    kinds = [one for one in samples(plot, sweep.exact if plot.error else None) if one]
    shown = np.degrees if sweep.q.is_angle else np.asarray
    x, now = across.place(shown(sweep.x)), float(across.place(shown(values[plot.sweep])))
    axes.axvline(now, color=look.quiet, linewidth=points(look, 0.5))
    for curve, sample in zip(drawn, kinds, strict=True):
        y, colour = frame.place(curve.y), colour_of(curve.curve, look)
        if sample in SHAPES:
            axes.plot(x, y, MARKER[sample], color=colour, label=curve.curve.label, markersize=points(look, 2.4),
                      markevery=max(1, len(x) // 60))
        else:
            axes.plot(x, y, linestyle=dash(sample), color=colour, label=curve.curve.label, linewidth=points(look))
        axes.plot([now], frame.place([curve.now]), "o", color=colour, markersize=points(look, 3.6),
                  markeredgecolor=look.background, zorder=5)
    axes.set_xlim(*widened(across, 0.03))
    axes.set_ylim(*widened(frame, 0.03))
    axes.set_xticks(*across.ticks(max(2, round(look.size[0] / (4.6 * look.small)))))
    axes.set_yticks(*frame.ticks(max(2, round(look.size[1] / (3.2 * look.small)))))
    framed(axes, look)
    axes.set_xlabel(axis_title(plot.sweep), color=look.foreground, fontproperties=letters(look, look.small))
    axes.set_ylabel(y_title(plot, sweep), color=look.foreground, fontproperties=letters(look, look.small))
    legend(axes, look, 1 if max((len(one.curve.label) for one in drawn), default=0) > 36 else 2)
    return [*nothing_in(drawn), *(words for one in drawn for words in notices_of(one))]


def sliced(axes: Axes, plot: Slice, values: dict, look: Look) -> list[str]:
    """Lobes cut by a plane: the half circle of rings, or the value against the angle."""
    part = SlicePart(plot, look)
    part.prepare(values)
    notes = part.update(values, None)
    polar, scale, one = plot.kind == "polar", part.scale, "eye" if plot.over == "v" else "light"

    def at(angle, length) -> tuple[np.ndarray, np.ndarray]:
        angle, length = np.broadcast_arrays(angle, length)
        return (length * np.sin(angle), length * np.cos(angle)) if polar else (np.degrees(angle), length)

    for i, (model, (angle, f)) in enumerate(zip(part.shown, part.lines, strict=True)):
        colour = model.colour(look)
        axes.plot(*at(angle, scale.length(f)), linestyle=dash(LINES[i % len(LINES)]), color=colour,
                  linewidth=points(look, 1.2), label=f"{model.label}  {three(model.number)}{model.unit}")
        if part.now is not None:
            axes.plot(*at(np.array([part.now]), scale.length([model.number])), "o", color=colour,
                      markersize=points(look, 3.6), markeredgecolor=look.background, zorder=5)
    names = ("l", "v") if plot.over == "v" else ("v", "l")
    for name, ray in ((names[0], part.still), (names[1], part.now)):
        if ray is not None:
            axes.plot(*at(np.full(2, ray), np.array([0.0, 0.9])), color=look.colour(name), linewidth=points(look, 1.1))
            x, y = at(np.array([ray]), np.array([0.96]))
            axes.text(x[0], y[0], name, ha="center", color=look.colour(name), fontproperties=letters(look, look.text))
    rings(axes, look, at) if polar else graph(axes, look, part)
    note = scale.words(unit_of(part.shown)) if polar else f"angle of the {one}, mirror side > 0"
    axes.set_xlabel(note, color=look.quiet, fontproperties=letters(look, look.small))
    legend(axes, look, 2)
    return notes


def rings(axes: Axes, look: Look, at) -> None:
    arc = np.linspace(-np.pi / 2, np.pi / 2, 91)
    for ring in (0.25, 0.5, 0.75, 1.0):
        axes.plot(*at(arc, ring), color=look.quiet if ring == 1 else look.grid, linewidth=points(look, 0.5), zorder=0)
    for degrees in range(-90, 91, 30):
        angle = np.radians(degrees)
        axes.plot(*at(np.full(2, angle), np.array([0.0, 1.0])), color=look.grid, linewidth=points(look, 0.5), zorder=0)
        axes.text(1.08 * np.sin(angle), 1.08 * np.cos(angle), f"{abs(degrees)}°", ha="center", va="center",
                  color=look.quiet, fontproperties=letters(look, look.small))
    axes.set_aspect("equal")
    axes.set_xlim(-1.18, 1.18)
    axes.set_ylim(-0.05, 1.18)
    axes.set_xticks([])
    axes.set_yticks([])
    for spine in axes.spines.values():
        spine.set_visible(False)


def graph(axes: Axes, look: Look, part: SlicePart) -> None:
    from app.plots.ticks import Axis

    top, log = part.scale.top, part.scale.log
    low = top * 10.0 ** -part.scale.decades if log else 0.0
    ticks, words = Axis(low, top, log).ticks(max(2, round(look.size[1] / (3.2 * look.small))))
    axes.set_yticks([1 + (t - np.log10(top)) / part.scale.decades if log else t / top for t in ticks], words)
    degrees = range(-90, 91, 30)
    axes.set_xticks(list(degrees), [f"{d}°".replace("-", "−") for d in degrees])
    axes.set_ylim(-0.02, 1.02)
    axes.set_xlim(-92, 92)
    framed(axes, look)
