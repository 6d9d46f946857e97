"""What the plots of models share: values over directions, the direction that is picked, a legend with its numbers."""

import math
from dataclasses import dataclass

import numpy as np
from PIL import Image, ImageDraw

from app.badges import key
from app.furnace import grid
from app.hemisphere import NORMAL, apart, around, frame
from app.lesson import Model
from app.optics import arguments
from app.optics.spherical import light_direction, view_direction
from app.plots.look import Look, Rgb, bytes3
from app.plots.ticks import nice, number
from app.plots.words import Entry, dot_size, font, mark, paste
from app.readouts import three
from app.terms import evaluate

SCALES = ("f", "f n·l", "log f")  # of the value lobe_scale
CHANNELS = ((0.86, 0.20, 0.18), (0.20, 0.66, 0.25), (0.25, 0.42, 0.95))
DECADES = 4, 8  # from the outermost ring to the middle on a logarithmic scale: as few as show all lobes
LEAST = 1e-3  # how far above the horizon the rim of a lobe is looked at


@dataclass(frozen=True)
class Lit:
    """A model at present values, in one channel of colour."""

    model: Model
    values: dict
    over: str  # the direction that is swept: v or l
    channel: int | None = None

    @property
    def still(self) -> np.ndarray:
        """The other direction."""
        v = self.values
        return light_direction(v["theta_l"], v["phi"]) if self.over == "v" else view_direction(v["theta_v"])

    @property
    def picked(self) -> np.ndarray:
        """The swept direction at the present values."""
        v = self.values
        return view_direction(v["theta_v"]) if self.over == "v" else light_direction(v["theta_l"], v["phi"])

    def __call__(self, swept: np.ndarray) -> np.ndarray:
        """Values (...) over directions (..., 3); times n.l where the step asks for it."""
        return self.pairs(self.still, swept) if self.over == "v" else self.pairs(swept, self.still)

    def pairs(self, l: np.ndarray, v: np.ndarray) -> np.ndarray:
        values = self.values if self.channel is None else {**self.values, "channel": self.channel}
        with np.errstate(all="ignore"):  # what is not finite is counted and shown
            found = evaluate(self.model.term, values, n=NORMAL, l=l, v=v, radiance=1.0)
        found = np.broadcast_to(np.asarray(found, float), np.broadcast_shapes(l.shape, v.shape)[:-1])
        times = self.values.get("lobe_scale", 0) == 1 and not self.model.is_shading
        return found * np.maximum(l[..., 2], 0) if times else found

    @property
    def number(self) -> float:
        """At the picked direction: what a readout of the same twin says."""
        return float(self(self.picked[None])[0])

    @property
    def unit(self) -> str:
        return "" if self.model.is_shading or self.values.get("lobe_scale", 0) == 1 else " /sr"

    def colour(self, look: Look) -> Rgb:
        return look.colour(self.model.colour) if self.channel is None else CHANNELS[self.channel]

    @property
    def label(self) -> str:
        return self.model.label + ("" if self.channel is None else f", {('red', 'green', 'blue')[self.channel]}")

    @property
    def key(self) -> tuple:
        """Changes when the lobe does."""
        scale = self.values.get("lobe_scale", 0)
        return self.channel, self.over, scale, tuple(self.still), key(self.model, self.values)

    def peak(self) -> tuple[np.ndarray, float]:
        """The direction of the largest value, a little above the horizon, and how wide (rad) the lobe is there."""
        still = self.still
        turned = np.arctan2(still[1], still[0])
        looks = [grid(pole, np.array([np.arccos(min(still[2], 1.0))]), 2e-4, (24, 16))[1][0]
                 for pole in ("mirror", "halfway", "eye")]
        c, s = np.cos(turned), np.sin(turned)
        tried = np.concatenate([NORMAL[None], still[None] * (-1, -1, 1), still[None],
                                np.concatenate(looks) @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])])
        found = np.nan_to_num(self(tried), nan=0, posinf=0, neginf=0)
        found[tried[:, 2] < LEAST] = 0
        best = tried[int(np.argmax(found))]
        pole = best * (1, 1, 0) + NORMAL * max(best[2], 0.03)
        pole = pole / np.linalg.norm(pole)
        away = np.geomspace(1e-5, 1.0, 41)
        across, along = frame(best)
        ways = np.stack([across, -across, along, -along])[:, None]
        near = self(best * np.cos(away)[:, None] + ways * np.sin(away)[:, None])
        low = np.nan_to_num(near) < 0.5 * found.max()
        first = np.where(low.any(-1), np.argmax(low, -1), len(away) - 1)
        width = float(away[first.min()])
        return (best, width) if best[2] >= 0.03 or width < 0.05 else (pole, max(width, float(apart(best, pole))))

    def lobe(self, rows: int, columns: int) -> tuple[np.ndarray, np.ndarray]:
        """Directions (rows + 1, columns + 1, 3) from the peak to the horizon, and the values there."""
        pole, width = self.peak()
        t, s = np.meshgrid(np.linspace(0, 1, rows + 1), np.linspace(0, 1, columns + 1), indexing="ij")
        d = around(pole, s, t, min(width, 3.0) if width < 0.4 else 10.0)[0]
        d = np.concatenate([d[..., :2], np.maximum(d[..., 2:], LEAST)], -1)
        return d, self(d)


def lit(models: tuple[Model, ...], values: dict, over: str) -> list[Lit]:
    """The models, one of colour once for each channel, unless the step has chosen a channel."""
    found = []
    for model in models:
        free = "channel" in arguments(model.term.function) and model.term.args.get("channel", "channel") == "channel"
        channels = (int(values["channel"]),) if free and "channel" in values else (0, 1, 2) if free else (None,)
        found += [Lit(model, values, over, channel) for channel in channels]
    return found


class Scale:
    """How long a value is drawn: 1 at the outermost ring, which keeps still until it is left or far too wide."""

    def __init__(self) -> None:
        self.top, self.kind, self.decades = 0.0, -1, DECADES[0]

    def fit(self, values: list[np.ndarray], kind: int) -> None:
        """To hold the largest of all values, and on a logarithmic scale the largest of each model's."""
        peaks = [float(np.nan_to_num(f, nan=0, posinf=0, neginf=0).max()) for f in values]
        most = max([*peaks, 0.0])
        if kind != self.kind or most > self.top or most < 0.3 * self.top:
            self.kind = kind
            if not 0 < most < 1e300:
                self.top = 1.0
            else:
                self.top = 10.0 ** math.ceil(math.log10(most) - 1e-9) if self.log else nice(most)
        least = min((peak for peak in peaks if peak > 0), default=self.top)
        self.decades = DECADES[int(least < self.top * 10.0 ** (1 - DECADES[0]))]

    @property
    def log(self) -> bool:
        return self.kind == 2

    def length(self, f) -> np.ndarray:
        share = np.maximum(np.nan_to_num(np.asarray(f, float), posinf=0, neginf=0), 0) / self.top
        return np.clip(1 + np.log10(np.maximum(share, 1e-30)) / self.decades, 0, 1) if self.log else share

    def words(self, unit: str) -> str:
        steps = "in quarters" if not self.log else "each a tenth" if self.decades == 4 else "each a hundredth"
        return f"outer ring {number(self.top)}{unit}, {steps}"


class Legend:
    """A strip with a sample, the name and the number of each model at the picked direction; its height is fixed."""

    def __init__(self, look: Look, models: list[Lit]):
        self.look, letters = look, font(look, look.small)
        self.swatch, self.gap, self.high = round(1.5 * look.small), round(0.5 * look.small), round(1.32 * look.small)
        self.wide = self.swatch + 3 * self.gap + max(
            (letters.getlength(one.label + "  0.000e-00 /sr") for one in models), default=0)
        self.columns = max(1, min(len(models), int((look.size[0] - 2 * self.gap) // self.wide)))
        self.rows = -(-len(models) // self.columns)

    def strip(self, models: list[Lit], note: str, samples: tuple[str, ...] = ("area",)) -> np.ndarray:
        look = self.look
        picture = Image.new("RGB", (look.size[0], (self.rows + 1) * self.high + self.gap), bytes3(look.background))
        draw = ImageDraw.Draw(picture)
        letters = fitting(look, note, look.size[0] - 2 * self.gap)
        draw.text((look.size[0] / 2, 0.5 * self.high), note, bytes3(look.quiet), letters, anchor="mm")
        wide = (look.size[0] - 2 * self.gap) / self.columns
        for i, one in enumerate(models):
            x, y = 2 * self.gap + (i % self.columns) * wide, (1.5 + i // self.columns) * self.high
            entry = Entry(samples[i % len(samples)], one.colour(look), one.label)
            paste(picture, mark(look, entry, self.swatch, self.high), x, y - self.high / 2)
            x += self.swatch + self.gap
            value, room = three(one.number) + one.unit, self.gap + (i % self.columns + 1) * wide - x
            letters = fitting(look, f"{one.label}  {value}", room, 0.75 * look.small)
            name = next((cut for count in range(len(one.label), 2, -1)
                         if letters.getlength(f"{(cut := shortened(one.label, count))}  {value}") <= room), "…")
            draw.text((x, y), name, bytes3(look.foreground), letters, anchor="lm")
            x += letters.getlength(name + "  ")
            draw.text((x, y), value, bytes3(look.foreground), letters, anchor="lm")
        return np.asarray(picture)


def shortened(name: str, count: int) -> str:
    """So many letters of a name, a file's, its middle left out."""
    return name if count >= len(name) else f"{name[:count // 2]}…{name[len(name) - (count - 1) // 2:]}"


def fitting(look: Look, text: str, room: float, least: float = 9):
    """The theme's small letters, or smaller ones with which the text has room."""
    size = look.small
    while size > least and font(look, size).getlength(text) > room:
        size -= 1
    return font(look, size)


def dot(look: Look) -> float:
    """px across of the mark of the picked direction."""
    return 1.7 * dot_size(look)


def unit_of(models: list[Lit]) -> str:
    """The unit they share."""
    units = {one.unit for one in models}
    return units.pop() if len(units) == 1 else ""


def notices(one: Lit, f: np.ndarray) -> list[str]:
    bad, below = int((~np.isfinite(f)).sum()), int((f < 0).sum())
    found = [f"“{one.label}”: {bad} {'point is' if bad == 1 else 'points are'} not finite"] if bad else []
    return found + ([f"“{one.label}” is negative at {below} points"] if below else [])
