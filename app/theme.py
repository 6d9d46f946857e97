"""The grammar of colour (Okabe-Ito) and the three themes: the same in scenes, plots, formulas, pages."""

from dataclasses import dataclass

GRAMMAR = {  # what a thing is -> its colour; "exact", "quiet" and "g" follow the theme
    "n": "#0072B2", "l": "#E69F00", "v": "#009E73", "h": "#CC79A7", "r": "#D55E00",
    "estimate": "#56B4E9", "printed": "#D55E00", "lost": "#8C8C8C", "d": "#56B4E9", "f": "#CC79A7",
}


@dataclass(frozen=True)
class Theme:
    name: str
    background: str  # of scene and plot
    panel: str  # of prose and controls
    foreground: str  # text, exact curves
    quiet: str  # grids, secondary text
    g: str  # the yellow of the factor G
    colormap: str  # perceptually uniform
    text: float  # px at 1280x720
    line: float  # px at 1280x720
    lift: float  # what colours of the grammar are mixed with the foreground by, so that lines stay readable


THEMES = {
    "dark": Theme("dark", "#14171C", "#1B1F26", "#ECEFF4", "#8A93A3", "#F0E442", "viridis", 16, 2.0, 0.18),
    "light": Theme("light", "#FBFBF8", "#F1F1EC", "#1B1F26", "#687080", "#B8A800", "viridis", 16, 2.0, 0.0),
    "projector": Theme("projector", "#FFFFFF", "#FFFFFF", "#000000", "#505050", "#B8A800", "cividis", 24, 4.0, 0.12),
}


def colour(name: str, theme: Theme) -> tuple[float, float, float]:
    """The sRGB colour, 0 to 1, of a word of the grammar (or of #RRGGBB) in a theme."""
    if name in ("exact", "foreground"):
        return rgb(theme.foreground)
    if name in ("quiet", "background", "panel", "g"):
        return rgb(getattr(theme, name))
    base, front = rgb(GRAMMAR.get(name, name)), rgb(theme.foreground)
    return tuple(b + (f - b) * theme.lift for b, f in zip(base, front, strict=True))  # type: ignore[return-value]


def rgb(text: str) -> tuple[float, float, float]:
    return tuple(int(text[i:i + 2], 16) / 255 for i in (1, 3, 5))  # type: ignore[return-value]
