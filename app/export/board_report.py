"""The board on one page: lobes, polar curves and albedo of up to four models, and each in its own coordinates, as a lit
sphere, with its parameters and its badges."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw

from app import plots
from app.board.board_step import COLOURS, MOST, ROLES, SPREAD
from app.board.board_values import TURNED
from app.board.brdf_file import Default
from app.board.coated import Coated
from app.board.fit import fit
from app.board.merl import Merl
from app.board.models import BoardModel, opened
from app.board.settings import of_model
from app.board.terms import LUMINANCE, function, packed
from app.brush import tangent_azimuth
from app.export import target
from app.export.board_words import SIGNS, STEP, Line, lines
from app.export.ink import Ink, fitted, write
from app.export.lit_sphere import sphere
from app.export.png import png
from app.export.still import known
from app.hemisphere import NORMAL
from app.lesson import Camera, Colour, Curve, Curves, ImageSlice, Lobes, Model, Plot, Slice, Term
from app.optics.spherical import direction
from app.plots.look import REFERENCE
from app.theme import THEMES, Theme

CHANNELS = (("red", "#DB3330"), ("green", "#33A840"), ("blue", "#406BF2"))
SIZE, LEAST = "1920x1200", (1600, 1000)  # px
LETTERS = 14  # heights of its text that an image slice has room for
VALUES = {"theta_l": math.radians(45), "theta_v": math.radians(30), "phi": math.pi, "lobe_scale": 0}
TANGENT = tangent_azimuth(VALUES["theta_v"], TURNED)  # of X, for plots: that of the board's first picked point
RANGES = {"theta_v": (0.0, math.radians(89.9))}
MUCH = 2.0  # an albedo where its axis ends: a model that makes more light may not flatten the others
BESIDE = 1 / 3  # of the width, for the words of a model that is alone


@dataclass(frozen=True)
class Shown:
    """A model of the report."""

    label: str
    word: str  # as terms name it
    model: BoardModel
    values: dict[str, Default]
    about: str  # what stands below its name
    colour: Colour = "estimate"

    def term(self, kind: str = "board", channel: int | None = None) -> Term:
        turned = (TANGENT,) if self.model.is_anisotropic else ()
        given: dict = {"values": packed(self.model.parameters, self.values, *turned)}
        if channel is not None:
            given["channel"] = channel
        return Term(f"{kind}:{self.word}", given)


def save(words: list[str], output: str | Path, theme: str = "dark", size: str = SIZE,
         given: Sequence[str] = ()) -> None:
    """A picture smaller than LEAST is a larger one reduced, so that it is whole. given: parameters, as name=value."""
    path, pixels = target.picture_path(output), target.size_of(size)
    chosen_theme = THEMES[known("--theme", theme, tuple(THEMES))]
    more = max(1.0, *(least / given for least, given in zip(LEAST, pixels, strict=True)))
    picture = report(shown(words, given), (round(more * pixels[0]), round(more * pixels[1])), chosen_theme)
    target.write(path, png(picture if more == 1 else picture.resize(pixels, Image.Resampling.LANCZOS)))


def shown(words: list[str], given: Sequence[str] = ()) -> list[Shown]:
    """The models, and behind a measurement its fit, where there is room for that."""
    found, room = [], MOST - len(words)
    for word in words:
        model = opened(word)
        values = of_model(model, given)
        if not isinstance(model, Merl):
            found.append(Shown(model.name, word, model, values, listing(values)))
            continue
        missing = f", {100 * model.missing:.3g} % missing: its albedo is at least this" if model.missing else ""
        found.append(Shown(model.name, word, model, values, f"measured{missing}"))
        if room:
            near, room = fit(model), room - 1
            found.append(Shown(f"fit of {model.name}", Coated.name, Coated(f"fit of {model.name}", near), near.values,
                               f"ρ/π + Cook-Torrance: {listing(near.values)}, residual {near.residual:.3g}"))
    return [replace(one, colour=colour) for one, colour in zip(found, COLOURS, strict=False)]


def listing(values: dict[str, Default]) -> str:
    """'m 0.3, f0 0.9 0.6 0.2'."""
    def said(value: Default) -> str:
        if isinstance(value, bool):
            return "yes" if value else "no"
        return " ".join(f"{x:.3g}" for x in (value if isinstance(value, tuple) else (value,)))

    return ", ".join(f"{name} {said(value)}" for name, value in values.items()) or "no parameters"


def report(models: list[Shown], size: tuple[int, int], theme: Theme) -> Image.Image:
    """Above the three plots of all models, below a column for each."""
    ink = Ink(theme, (size[0], round(0.72 * size[1])))
    picture = Image.new("RGB", size, ink.colour("background"))
    head = heading(picture, models, ink)
    middle = head + round((0.48 if len(models) == 1 else 0.41) * (size[1] - head))
    margin = ink.text // 2
    wide = [margin + round(i * (size[0] - margin) / 3) for i in range(4)]
    for plot, left, right in zip(together(models), wide, wide[1:], strict=False):
        drawn = plots.picture(plot, chosen(models), (right - left, middle - head), theme, RANGES)
        picture.paste(Image.fromarray(drawn), (left, head))
    edges = [round(i * size[0] / len(models)) for i in range(len(models) + 1)]
    room = size[0] * (BESIDE if len(models) == 1 else 1 / len(models)) - 2 * ink.text
    told = [lines(one.label, one.colour, one.about, one.model.badges(one.values), room, ink) for one in models]
    high = size[1] - middle - round(0.3 * ink.text)
    if len(models) > 1:
        high -= round((STEP * max(map(len, told)) + 0.2) * ink.small)
    for one, words, left, right in zip(models, told, edges, edges[1:], strict=False):
        column(picture, (left, middle, right, size[1]), one, words, high, len(models) == 1, ink)
    return picture


def heading(picture: Image.Image, models: list[Shown], ink: Ink) -> int:
    """Title, and where light and eye stand; returns where it ends."""
    draw, gap, large = ImageDraw.Draw(picture), ink.text, round(1.3 * ink.text)
    room = picture.width - 2 * gap
    title = ", ".join(one.label for one in models)
    write(draw, (gap, 0.5 * gap + 0.9 * large), fitted(title, large, room, True), large, ink.colour("foreground"),
          bold=True)
    about = f"light at {angle('theta_l')}, eye at {angle('theta_v')} on the mirror's side; BRDF in 1/sr without cosine"
    if len(models) > 1 and not all(one.model.is_grey(one.values) for one in models):
        about += "; curves of coloured models: luminance"
    if any(one.model.is_anisotropic for one in models):
        about += f"; X at φ = {math.degrees(TANGENT):.3g}° from the eye's"
    write(draw, (gap, 0.5 * gap + 0.9 * large + 1.5 * ink.small), fitted(about, ink.small, room), ink.small,
          ink.colour("quiet"))
    return round(gap + 0.9 * large + 1.7 * ink.small)


def angle(name: str) -> str:
    return f"{SIGNS[name]} = {math.degrees(VALUES[name]):.3g}°"


def chosen(models: list[Shown]) -> dict:
    """VALUES, with a logarithmic scale where one lobe would hide the others."""
    l, v = direction(VALUES["theta_l"], VALUES["phi"]), direction(np.linspace(-1.5, 1.5, 301), 0.0)
    found = [function(one.term().function)(NORMAL, l, v, LUMINANCE, one.term().args["values"]) for one in models]
    peaks = [float(np.nan_to_num(f, nan=0, posinf=0).max()) for f in found]
    apart = max(peaks) > SPREAD * max(min(peaks), 1e-300)
    return VALUES | {"lobe_scale": 2 if apart else 0}


def together(models: list[Shown]) -> tuple[Plot, ...]:
    """The plots of all models; a model that is alone and has colour gets a lobe for each channel."""
    def channel(one: Shown) -> int | None:
        return 0 if one.model.is_grey(one.values) else None if len(models) == 1 else LUMINANCE

    lit = tuple(Model(one.label, one.term(channel=channel(one)), one.colour) for one in models)
    curves = []
    for one, role in zip(models, ROLES, strict=False):
        if channel(one) is None:
            curves += [Curve(name, one.term("albedo", i), role, colour=colour)  # type: ignore[arg-type]
                       for (i, (name, colour)), role in zip(enumerate(CHANNELS), ROLES, strict=False)]
        else:
            curves.append(Curve(one.label, one.term("albedo", channel(one)), role, colour=one.colour))  # type: ignore[arg-type]
    return (Lobes("Lobes", lit, camera=Camera(azimuth=-70, elevation=18, distance=4.3, target=(0.0, 0.0, 0.42))),
            Slice("Plane of incidence", lit),
            Curves("Albedo, by the eye's angle", "theta_v", tuple(curves), "share of the light sent on", most=MUCH))


def column(picture: Image.Image, box: tuple[int, int, int, int], one: Shown, told: list[Line], high: int, beside: bool,
           ink: Ink) -> None:
    """A sphere beside the image slice; the words below them, or to the right of them where it is alone."""
    left, top, right, _ = box
    gap, wide = ink.text, right - left
    below = left + gap, top + high + 1.2 * ink.small
    words = (right - BESIDE * wide + gap, top + 1.4 * ink.text) if beside else below
    side = min(high - gap, round(0.38 * wide) - gap)
    ball = sphere(one.model, one.values, side, ink.colour("background"))
    picture.paste(ball, (left + gap, top + (high - side) // 2))
    start = left + side + 2 * gap
    across = (round(words[0] - gap) if beside else min(right - gap // 2, start + round(1.7 * high))) - start
    theme = replace(ink.theme, text=letters(ink.theme.text, min(across, high)))
    alone = Model(one.label, one.term(channel=0 if one.model.is_grey(one.values) else LUMINANCE), one.colour)
    drawn = plots.picture(ImageSlice("In its own angles", (alone,)), VALUES, (across, high), theme)
    picture.paste(Image.fromarray(drawn), (start, top))
    draw, y = ImageDraw.Draw(picture), words[1]
    for line in told:
        line.write(picture, draw, (words[0], y), ink)
        y += STEP * ink.small


def letters(text: float, side: int) -> float:
    """The size of a theme's text with which a small plot has room for its words, and a large one does not shout."""
    return min(1.15 * text, side / LETTERS) / max(1.0, side / REFERENCE)
