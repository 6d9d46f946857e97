"""`halfway animate`: a step with a value on its way, as a film for slides that run nothing live."""

from argparse import ArgumentParser, Namespace
from dataclasses import dataclass

from PIL import Image, ImageDraw

from app import plots
from app.catalog import LoadedStep, step
from app.console import progress
from app.export import target
from app.export.film import ENDINGS, ffmpeg, film
from app.export.ink import Ink, fitted, length, write
from app.export.shooting import Shooting
from app.export.still import MESH, PARTS, Part, data, known, plot_number
from app.lesson import Study
from app.motion import Sweep, moved, sweep
from app.problem import Usage
from app.state import View, parse
from app.theme import THEMES, Theme

MOST = 1800  # frames
LOOKS = 0.0, 0.5, 1.0  # shares of the way at which the whole scene must be in the picture
WIDE = 1.5  # from this aspect on, scene and plot stand side by side


def add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument("step", metavar="STATE", help="chapter/step, with values if you like: ?distance=2.5&tilt=30")
    parser.add_argument("--sweep", metavar="NAME=FROM..TO", action="append", required=True,
                        help="the value that moves, screen units: m=0.05..1; several move together")
    parser.add_argument("--seconds", metavar="S", type=float, default=4.0, help="how long it takes; 4")
    parser.add_argument("--fps", metavar="N", type=int, default=24, help="frames a second; 24")
    parser.add_argument("--loop", action="store_true", help="there and back within the seconds")
    parser.add_argument("--size", metavar="WxH", default="512x512", help="pixels; 512x512")
    parser.add_argument("--view", metavar="PART", default="scene", help="scene, plot or both")
    parser.add_argument("--plot", metavar="N", default="1", help="which plot of a step that has several, or its title")
    parser.add_argument("--theme", metavar="NAME", default="dark", help="dark, light or projector")
    parser.add_argument("-o", "--output", metavar="FILE", required=True, help="a .webp, .gif, .avif or .mp4")


def run(options: Namespace) -> int:
    path = target.path_of(options.output, ENDINGS, "WebP runs everywhere")
    theme = THEMES[known("--theme", options.theme, tuple(THEMES))]
    part: Part = known("--view", options.view, PARTS)  # type: ignore[assignment]
    state = parse(options.step)
    found = step(state.step)
    shares = ways(options.seconds, options.fps, options.loop)
    sweeps = [sweep(text, found) for text in options.sweep]
    if len({one.spec.name for one in sweeps}) < len(sweeps):
        raise Usage("a value is swept twice; give each --sweep once.")
    number = plot_number(found, options.plot)
    if part != "scene" and isinstance(found.step.plots[number], Study):
        raise Usage(f"plot {number + 1} of {found.id} measures run times, which is nothing for an animation.")
    if path.suffix.lower() == ".mp4":
        ffmpeg()  # asked before the work
    with Filming(found, state.values, state.view, sweeps, target.size_of(options.size), theme, part, number) as one:
        made: dict[float, Image.Image] = {}
        with progress(len(set(shares))) as tell:
            for share in shares:  # on the way back the same pictures serve
                if share not in made:
                    tell(len(made), f"{share:.0%}")
                    made[share] = one.frame(share)
    target.write(path, film([made[share] for share in shares], path.suffix.lower(), options.fps))
    return 0


def ways(seconds: float, fps: int, back: bool) -> list[float]:
    """The share of the way at each frame; back again it ends where it can begin anew."""
    count = round(seconds * fps) if 0 < seconds < 1e4 and 0 < fps <= 120 else 0
    if not 2 <= count <= MOST:
        raise Usage(f"--seconds {seconds:g} --fps {fps} makes {max(count, 0)} frames; it takes 2 to {MOST}, "
                    "at 1 to 120 a second.")
    if not back:
        return [i / (count - 1) for i in range(count)]
    half = count // 2
    return [1 - abs(i - half) / half if i <= 2 * half else 0.0 for i in range(count)]


@dataclass
class Filming:
    """A step set up to be drawn along its way."""

    found: LoadedStep
    values: dict
    view: View | None
    sweeps: list[Sweep]
    size: tuple[int, int]
    theme: Theme
    part: Part
    plot: int

    def __post_init__(self) -> None:
        self.ink = Ink(self.theme, self.size)
        wide, high = self.size[0], self.size[1] - round(1.9 * self.ink.text)
        beside = wide >= WIDE * high
        both = (wide // 2, high) if beside else (wide, high // 2)
        self.room = both if self.part == "both" else (wide, high)
        self.second = (wide // 2, 0) if beside else (0, high // 2)
        self.carried: dict = {}
        self.camera = None
        self.scene = Shooting(self.found, self.room, self.theme, self.ink) if self.part != "plot" else None
        if self.scene:
            self.camera = self.scene.camera([self.at(share) for share in LOOKS], self.view)

    def at(self, share: float) -> dict:
        """The step's values on the way, with what they carry; a mesh stays the object it is."""
        values = {**self.values, **moved(self.sweeps, share)}
        key = values.get("shape"), values.get("luminaire")
        if key not in self.carried:
            self.carried[key] = data(self.found, values)
        return {**values, **self.carried[key], **self.found.derived(values)}

    def frame(self, share: float) -> Image.Image:
        values = self.at(share)
        picture = Image.new("RGB", self.size, self.ink.colour("background"))
        if self.scene and self.camera:
            picture.paste(self.scene.picture(values, self.camera), (0, 0))
        if self.part != "scene":
            size = (self.size[0] - self.second[0], self.room[1]) if self.part == "both" else self.room
            picture.paste(self.plotted(values, size), self.second if self.part == "both" else (0, 0))
        self.caption(picture, share)
        return picture

    def plotted(self, values: dict, size: tuple[int, int]) -> Image.Image:
        sliders = {name: value for name, value in values.items() if name not in MESH}
        ranges = {name: (spec.low, spec.high, spec.scale) for name, spec in self.found.values.items()}
        return Image.fromarray(plots.picture(self.found.step.plots[self.plot], sliders, size, self.theme, ranges,
                                             triangles=values.get("triangles"), steady=True))

    def caption(self, picture: Image.Image, share: float) -> None:
        """Below: what moves, and where it is now; then the step's title where there is room."""
        ink, draw = self.ink, ImageDraw.Draw(picture)
        line, edge = self.size[1] - 0.65 * ink.text, 0.8 * ink.text
        told = ",  ".join(one.told(one.at(share)) for one in self.sweeps)
        write(draw, (edge, line), fitted(told, ink.text, self.size[0] - 2 * edge, True), ink.text,
              ink.colour("foreground"), bold=True)
        widest = max(length(",  ".join(one.told(one.at(s)) for one in self.sweeps), ink.text, True) for s in LOOKS)
        title, room = self.found.step.title, self.size[0] - widest - 4 * edge
        if (wide := length(title, ink.small)) <= room:
            write(draw, (self.size[0] - edge - wide, line), title, ink.small, ink.colour("quiet"))

    def __enter__(self) -> "Filming":
        return self

    def __exit__(self, *exc) -> None:
        if self.scene:
            self.scene.release()
