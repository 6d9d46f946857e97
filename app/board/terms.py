"""A model of the board as a function that the term of a plot can name, also in the plots' own process.

    board:WORD     f(n, l, v, channel, values) in 1/sr
    half:WORD      f(theta_h, theta_d, phi_d, channel, values), the same in the angles of the halfway vector, 0 below
                   the horizon
    albedo:WORD    albedo(theta_v, channel, values), the share of the light that is sent on: to 1e-4 (app/furnace.py)

WORD is what `halfway board` takes: a model of the course or a path. `channel` is 0, 1 or 2, or LUMINANCE for what the
three weigh together; `values` are the model's parameters in their order, a colour as three numbers; of a model that
asks for X there follows X's azimuth in rad, from the eye's (board:, albedo:) or from h's (half:).
`app.optics.twin` comes here for every name with a colon. A file that has changed is read again.
"""

from collections.abc import Callable
from dataclasses import replace
from functools import cache, lru_cache
from pathlib import Path

import numpy as np

from app.badges import Badge
from app.board.brdf_file import Default, Parameter
from app.board.edited import edited
from app.board.merl import directions
from app.board.models import opened
from app.furnace import albedo
from app.hemisphere import NORMAL
from app.optics.spherical import direction
from app.problem import Usage
from app.shader import Overrides

LUMINANCE = 3
ACROSS = -0.5 * np.pi  # `turned` of the points of a ball where X is on the eye's side, as the badges take it
KINDS = "board", "half", "albedo"
WEIGHTS = np.array([0.2126, 0.7152, 0.0722])  # of linear sRGB (IEC 61966-2-1)
ANGLES = np.radians(np.append(90 * (1 - (1 - np.linspace(0, 1, 49)[:-5]) ** 2.75), 89.9))  # denser to the horizon


def packed(parameters: tuple[Parameter, ...], values: dict[str, Default], *azimuth: float) -> tuple[float, ...]:
    found = (float(x) for p in parameters for x in np.ravel(values.get(p.name, p.default)))  # type: ignore[arg-type]
    return *found, *azimuth


def unpacked(parameters: tuple[Parameter, ...], numbers: tuple[float, ...]) -> dict[str, Default]:
    found: dict[str, Default] = {}
    rest = list(numbers)
    for p in parameters:
        taken, rest = rest[:3 if p.type == "color" else 1], rest[3 if p.type == "color" else 1:]
        found[p.name] = tuple(taken) if p.type == "color" else bool(taken[0]) if p.type == "bool" else taken[0]  # type: ignore[assignment]
    return found


def function(name: str, edits: Overrides = ()) -> Callable:
    """What a name with a colon means, with the user's texts in it."""
    kind, _, word = name.partition(":")
    if kind not in KINDS:
        known = ", ".join(f"{one}:MODEL" for one in KINDS)
        raise Usage(f"there is no function {name}; with a colon there are {known}.")
    try:
        about = Path(word).stat()
        stamp: tuple = about.st_mtime_ns, about.st_size
    except OSError:
        stamp = ()
    return made(kind, word, stamp, edits)


@lru_cache(16)
def made(kind: str, word: str, stamp: tuple, edits: Overrides) -> Callable:
    model = edited(opened(word), edits) or opened(word)

    def value(n, l, v, channel, values):
        x = None
        if model.is_anisotropic and len(values) > len(packed(model.parameters, {})):
            x = direction(0.5 * np.pi, values[-1])
        return channel_of(model.rgb(n, l, v, unpacked(model.parameters, values), x), channel)

    @cache
    def at_angles(channel: int, values: tuple[float, ...]) -> np.ndarray:
        return albedo(lambda n, l, v: value(n, l, v, channel, values), ANGLES)[0]

    def share(theta_v, channel, values):
        return between(theta_v, at_angles(channel, values))

    def half(theta_h, theta_d, phi_d, channel, values):
        l, v = directions(theta_h, theta_d, phi_d)
        return np.where((l[..., 2] > 0) & (v[..., 2] > 0), value(NORMAL, l, v, channel, values), 0.0)

    meant: dict[str, Callable] = {"board": value, "half": half, "albedo": share}
    return meant[kind]


def badges(name: str, values: tuple[float, ...], edits: Overrides = ()) -> dict[str, Badge]:
    """Of the model that a name with a colon means."""
    word = name.partition(":")[2]
    model = edited(opened(word), edits) or opened(word)
    found = model.badges(unpacked(model.parameters, values))
    if not model.is_anisotropic:
        return found
    return {name: replace(one, at={**one.at, "turned": ACROSS} if one.at else {}) for name, one in found.items()}


def between(theta_v, y: np.ndarray) -> np.ndarray:
    """A smooth curve through the values at ANGLES: cubic pieces, their slopes by differences."""
    x = np.clip(np.asarray(theta_v, float), ANGLES[0], ANGLES[-1])
    i = np.clip(np.searchsorted(ANGLES, x) - 1, 0, len(ANGLES) - 2)
    with np.errstate(invalid="ignore", over="ignore"):
        slope, wide = np.gradient(y, ANGLES, edge_order=2), ANGLES[i + 1] - ANGLES[i]
        u = (x - ANGLES[i]) / wide
        return (y[i] * (1 + 2 * u) * (1 - u) ** 2 + y[i + 1] * u * u * (3 - 2 * u)
                + wide * u * (1 - u) * (slope[i] * (1 - u) - slope[i + 1] * u))


def channel_of(rgb: np.ndarray, channel: int) -> np.ndarray:
    return rgb @ WEIGHTS if channel == LUMINANCE else rgb[..., channel]
