"""Two renderers side by side, their difference with its scale, the numbers, and the table of where they differ."""

from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw

from app.compare.command import verdict
from app.compare.pictures import Compared
from app.export import target
from app.export.ies_report import wrapped
from app.export.ink import Ink, bytes3, fitted, length, write
from app.export.png import png
from app.export.still import known
from app.optics.colour import linear_to_srgb
from app.plots.ticks import nice
from app.problem import Usage
from app.theme import THEMES, Theme, colour, rgb

SIZE, LEAST = "1600x1040", (1400, 960)
BRIGHT = 0.995  # the share of the pixels that is not cut off at white


def checked(output: str | Path, size: str | None, theme: str | None) -> None:
    """What can be said before the work is done."""
    known("--theme", theme or "dark", tuple(THEMES))
    target.size_of(size or SIZE)
    if Path(output).suffix.lower() == ".png":
        target.picture_path(output)
    elif Path(output).suffix:
        raise Usage(f"{output} ends neither in .png nor is it a folder; write FILE.png or a folder's name.")


def save(output: str | Path, told: dict, both: Compared, aligned: bool, size: str | None, theme: str | None
         ) -> list[str]:
    """A page in one file, or the page and its three pictures in a folder; the paths."""
    chosen, wanted = THEMES[theme or "dark"], target.size_of(size or SIZE)
    more = max(1.0, *(least / given for least, given in zip(LEAST, wanted, strict=True)))
    page = report(told, both, aligned, (round(more * wanted[0]), round(more * wanted[1])), chosen)
    page = page if more == 1 else page.resize(wanted, Image.Resampling.LANCZOS)
    if Path(output).suffix:
        files = {Path(output).expanduser(): page}
    else:
        folder = target.make_folder(output)
        names = [folder / f"{name}.png" for name in ("ours", "pyrender", "difference")]
        files = {folder / "compare.png": page, **dict(zip(names, pictures(both, aligned, chosen)[0], strict=True))}
    for path, picture in files.items():
        target.write(path, png(picture, {"Title": "A second opinion", "halfway:state": told["state"]}))
    return [str(path) for path in files]


def pictures(both: Compared, aligned: bool, theme: Theme) -> tuple[list[Image.Image], float, float]:
    """Ours, pyrender's and the difference; the exposure of the two, and the scale of the third."""
    ours = both.aligned if aligned else both.ours
    bright = max(float(np.quantile(p[both.inside].max(-1), BRIGHT)) for p in (ours, both.theirs))
    exposure = 1.0 if bright <= 1 else 1 / nice(bright)
    on = np.isfinite(ours).all(-1) & ((ours > 0) | (both.theirs > 0)).any(-1)
    shown = [display(p * exposure, on, theme) for p in (ours, both.theirs)]
    apart = np.where(both.inside, (ours - both.theirs).mean(-1), 0.0)
    scale = nice(max(float(np.quantile(np.abs(apart[both.inside]), 0.999)), 1e-4))
    return [*shown, signed(apart, both.inside, on, scale, theme)], exposure, scale


def display(radiance: np.ndarray, on: np.ndarray, theme: Theme) -> Image.Image:
    seen = np.where(on[..., None], linear_to_srgb(np.clip(np.nan_to_num(radiance), 0, 1)), rgb(theme.background))
    return Image.fromarray(np.round(255 * seen).astype(np.uint8))


def signed(apart: np.ndarray, inside: np.ndarray, on: np.ndarray, scale: float, theme: Theme) -> Image.Image:
    """Blue where ours is darker, orange where it is brighter; pixels at silhouettes are left out, and grey."""
    share = ramp(np.clip(apart / scale, -1, 1))
    quiet = 0.7 * np.array(rgb(theme.background)) + 0.3 * np.array(rgb(theme.quiet))
    seen = np.where(inside[..., None], share, np.where(on[..., None], quiet, rgb(theme.background)))
    return Image.fromarray(np.round(255 * seen).astype(np.uint8))


def ramp(share: np.ndarray) -> np.ndarray:
    """-1 to 1 as a colour; nothing is nearly white."""
    none = np.array([0.93, 0.93, 0.92])
    ends = np.where(share[..., None] < 0, colour("n", THEMES["light"]), colour("r", THEMES["light"]))
    return none + (ends - none) * np.sqrt(np.abs(share))[..., None]


def report(told: dict, both: Compared, aligned: bool, size: tuple[int, int], theme: Theme) -> Image.Image:
    ink = Ink(theme, (size[0], round(0.6 * size[1])))
    picture = Image.new("RGB", size, ink.colour("background"))
    draw, gap = ImageDraw.Draw(picture), ink.text
    large = round(1.3 * ink.text)
    write(draw, (gap, gap + 0.7 * large), fitted(f"A second opinion: {told['state']}", large, size[0] - 2 * gap, True),
          large, ink.colour("foreground"), bold=True)
    gltf = told["gltf"]
    base = " ".join(f"{x:.3g}" for x in gltf["base_colour"])
    about = (f"{told['mesh']}, one far lamp; as glTF: base colour {base}, metallic {gltf['metallic']:g}, roughness "
             f"{gltf['roughness']:.3g}")
    y = gap + 0.7 * large + 1.5 * ink.small
    write(draw, (gap, y), fitted(about, ink.small, size[0] - 2 * gap), ink.small, ink.colour("quiet"))
    top, wide = round(y + 0.9 * ink.small), (size[0] - 4 * gap) // 3
    side = min(wide, round(0.47 * size[1]))
    drawn, exposure, scale = pictures(both, aligned, theme)
    exposed = "" if exposure == 1 else f", exposure x {exposure:.3g}"
    labels = f"ours: {told['ours']['function']}{exposed}", f"pyrender{exposed}", "ours - pyrender"
    for i, (one, label) in enumerate(zip(drawn, labels, strict=True)):
        left = gap + i * (wide + gap) + (wide - side) // 2
        picture.paste(one.resize((side, side), Image.Resampling.LANCZOS), (left, top))
        write(draw, (left, top + side + 1.3 * ink.small), fitted(label, ink.small, wide, True), ink.small,
              ink.colour("foreground"), bold=True)
    below = top + side
    bar(picture, (left + 0.42 * side, below + 0.45 * ink.small, left + side, below + 1.35 * ink.small), scale, ink)
    table(picture, (gap, top + side + round(3.0 * ink.small), size[0] - gap, size[1] - gap // 2), told, ink)
    return picture


def bar(picture: Image.Image, box: tuple[float, float, float, float], scale: float, ink: Ink) -> None:
    """The difference picture's colours with their ends."""
    draw, (low, high) = ImageDraw.Draw(picture), (f"-{scale:g}", f"+{scale:g}")
    left, right = box[0] + length(low, ink.small) + 6, box[2] - length(high, ink.small) - 6
    colours = ramp(np.linspace(-1, 1, max(2, round(right - left)))[None])
    strip = Image.fromarray(np.round(255 * colours).astype(np.uint8))
    strip = strip.resize((strip.width, round(box[3] - box[1])))
    picture.paste(strip, (round(left), round(box[1])))
    write(draw, (box[0], box[3] - 0.1 * ink.small), low, ink.small, ink.colour("quiet"))
    write(draw, (right + 6, box[3] - 0.1 * ink.small), high, ink.small, ink.colour("quiet"))


def table(picture: Image.Image, box: tuple[int, int, int, int], told: dict, ink: Ink) -> None:
    """The numbers, then a row for each term, as large as all of them have room."""
    apart, same = told["difference"], told["aligned"]
    facts = [f"Apart, with 1 a white matt surface that faces the lamp: RMSE {apart['rmse']:.3g}, 99.9 % within "
             f"{apart['p999']:.3g}, at most {apart['most']:.3g} ({apart['pixels']} pixels off silhouettes).",
             verdict(same)]
    numbers = ";  ".join(f"{row['term']}: {row['ours']:.3g} against {row['pyrender']:.3g}" for row in told["numbers"])
    rows = told["definitions"]
    for size in range(ink.small, 9, -1):
        first = box[0] + max(length(row["term"], size, True) for row in rows) + size
        middle = first + 0.40 * (box[2] - first)
        cells = [(wrapped(row["ours"], size, middle - first - size), wrapped(row["pyrender"], size, box[2] - middle))
                 for row in rows]
        lines = sum(len(wrapped(f, size, box[2] - box[0])) for f in [*facts, *filter(None, [numbers])])
        high = 1.28 * size * (lines + sum(max(map(len, pair)) for pair in cells) + 1.6) + 0.22 * size * len(rows)
        if high <= box[3] - box[1]:
            break
    draw, y, front, quiet = ImageDraw.Draw(picture), float(box[1]), ink.colour("foreground"), ink.colour("quiet")
    for fact in [*facts, *filter(None, [numbers])]:
        for line in wrapped(fact, size, box[2] - box[0]):
            write(draw, (box[0], y + size), line, size, front)
            y += 1.28 * size
    y += 0.5 * size
    write(draw, (first, y + size), "ours", size, quiet, bold=True)
    write(draw, (middle, y + size), "pyrender", size, quiet, bold=True)
    y += 1.4 * size
    for row, (left, right) in zip(rows, cells, strict=True):
        draw.line((box[0], y + 0.12 * size, box[2], y + 0.12 * size), bytes3(mixed(ink)), 1)
        write(draw, (box[0], y + 1.15 * size), row["term"], size, front, bold=True)
        for column, texts in ((first, left), (middle, right)):
            for i, line in enumerate(texts):
                write(draw, (column, y + (1.15 + 1.28 * i) * size), line, size, front)
        y += 1.28 * size * max(len(left), len(right)) + 0.22 * size


def mixed(ink: Ink) -> np.ndarray:
    return 0.75 * np.array(rgb(ink.theme.background)) + 0.25 * np.array(rgb(ink.theme.quiet))
