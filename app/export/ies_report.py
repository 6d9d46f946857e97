"""A luminaire's file on one page: polar curves, photometric solid, the room it lights, declared and emitted lumens."""

from pathlib import Path

from PIL import Image, ImageDraw

from app import plots
from app.catalog import LoadedStep, steps
from app.export import target
from app.export.ink import Ink, fitted, length, write
from app.export.png import png
from app.export.polar import polar
from app.export.shooting import shot
from app.export.still import known
from app.ies import Photometry
from app.lesson import Figure
from app.problem import Problem
from app.readouts import written
from app.state import defaults
from app.theme import THEMES, Theme


def save(found: Photometry, output: str | Path, theme: str = "dark", size: str = "1600x1000") -> None:
    path, pixels = target.picture_path(output), target.size_of(size)
    picture = report(found, pixels, THEMES[known("--theme", theme, tuple(THEMES))])
    target.write(path, png(picture))


def report(found: Photometry, size: tuple[int, int], theme: Theme) -> Image.Image:
    """Above the solid beside the polar curves; below the room beside the numbers."""
    ink = Ink(theme, (size[0], round(0.72 * size[1])))
    picture = Image.new("RGB", size, ink.colour("background"))
    head = heading(picture, found, ink)
    left, upper = round(0.56 * size[0]), head + round(0.52 * (size[1] - head))
    step, table = the_step(), found.table
    values = defaults(step) | {"table": table, "meter_s": -1.0}
    room = shot(step, values, None, (left, size[1] - upper), theme, Ink(theme, (left, size[1] - upper)))
    picture.paste(room, (0, upper))
    figure = step.step.plots[0]
    assert isinstance(figure, Figure)
    solid = plots.picture(figure, values, (left, upper - head), theme)
    picture.paste(Image.fromarray(solid), (0, head))
    polar(picture, (left, head, size[0], upper), found, ink)
    numbers(picture, (left, upper, size[0], size[1]), found, ink)
    return picture


def the_step() -> LoadedStep:
    """The step whose room and plot are shown: the first with a table of a luminaire."""
    for found in steps():
        if any(table.files for table in found.step.scene.tables) and isinstance(found.step.plots[0], Figure):
            return found
    raise Problem("no lesson shows a measured luminaire, so there is no room to light.")


def heading(picture: Image.Image, found: Photometry, ink: Ink) -> int:
    """Title and what kind of file it is; returns where it ends."""
    draw, gap = ImageDraw.Draw(picture), ink.text
    room = picture.width - 2 * gap
    large = round(1.4 * ink.text)
    write(draw, (gap, gap + 0.8 * large), fitted(found.title, large, room, True), large, ink.colour("foreground"),
          bold=True)
    about = (f"{Path(found.name).name}: {found.standard}, type {found.kind}, symmetry {found.symmetry}, "
             f"{len(found.vertical)} vertical x {len(found.horizontal)} horizontal angles")
    write(draw, (gap, gap + 0.8 * large + 1.6 * ink.small), fitted(about, ink.small, room), ink.small,
          ink.colour("quiet"))
    return round(1.8 * gap + 0.8 * large + 1.6 * ink.small)


def numbers(picture: Image.Image, box: tuple[int, int, int, int], found: Photometry, ink: Ink) -> None:
    """Declared and integrated lumens as bars of one scale, then the peak and the warnings."""
    draw, left, right = ImageDraw.Draw(picture), box[0] + ink.text, box[2] - 2 * ink.text
    y, front, quiet = box[1] + 1.5 * ink.text, ink.colour("foreground"), ink.colour("quiet")
    most = max(found.integrated_lumens, found.declared_lumens or 0.0)
    rows = [("integrated from the candela", found.integrated_lumens, "exact"),
            ("declared by the file", found.declared_lumens, "printed")]
    for label, value, colour in rows:
        write(draw, (left, y), label, ink.small, quiet)
        said = "none: absolute photometry" if value is None else written(value, "lm")
        write(draw, (right - length(said, ink.text, True), y), said, ink.text, front, bold=True)
        y += 0.5 * ink.text
        wide = 0.0 if value is None else (right - left) * value / most
        draw.rectangle((left, y, left + max(1.0, wide), y + 0.9 * ink.text), ink.colour(colour))
        y += 2.6 * ink.text
    declared = found.declared_lumens
    facts = [f"peak {written(found.max_candela, 'cd')}, {found.watts:g} W"]
    if declared:
        facts.append(f"{found.integrated_lumens / declared:.1%} of the declared lumens are emitted")
    facts += [f"! {warning.partition(', ')[2]}" for warning in found.warnings]
    for fact in facts:
        for line in wrapped(fact, ink.small, right - left):
            if y > box[3] - 0.6 * ink.text:
                return
            write(draw, (left, y), line, ink.small, ink.colour("printed") if fact[0] == "!" else front)
            y += 1.4 * ink.small


def wrapped(text: str, size: int, width: float) -> list[str]:
    lines = [""]
    for word in text.split():
        if lines[-1] and length(f"{lines[-1]} {word}", size) > width:
            lines.append(word)
        else:
            lines[-1] = f"{lines[-1]} {word}".strip()
    return lines
