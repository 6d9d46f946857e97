"""What every reflectance must be: five checks, one function, for lessons, tests and homework.

A BRDF f(n, l, v) is per steradian and without the cosine. A shading formula is L_o / L_i; it is judged as the BRDF it
stands for, itself over n.l. With `of_radiance` the callable takes the incoming radiance as a fourth argument and gives
L_o; only then can it fail to be linear, and all else is checked at radiance 1.

    non_negative  the smallest value of f anywhere below is not below 0
    reciprocal    f(l, v) = f(v, l): the largest relative difference, among pairs that reflect something
    energy        int f n.l dw <= 1 for every v, and where f is not reciprocal int f n.v dw <= 1 for every l: the
                  largest of these albedos (with the limits of app/furnace.py; 1/1000 more passes)
    finite        no NaN and no infinity, also at grazing angles, l = v, l = -v, and below the horizon: the largest |f|
    linear        L_o / L_i does not depend on L_i, from 1/1000 to 1000: the largest relative change. A tone curve or a
                  clamp fails. For one light this is all of linearity: f L_i is the only such formula; several lights
                  are summed outside of f

Of what is no number nothing is promised: where f is not finite one way round, over a part of the dome, or for one
radiance, that badge is not kept either, and its worst value is None.
"""

import math
from collections.abc import Callable
from dataclasses import asdict, dataclass
from importlib import import_module

import numpy as np

from app.edit import EDITED
from app.furnace import PART, POLES, albedo, first_look
from app.hemisphere import NORMAL
from app.lesson import Model
from app.optics import arguments, twin
from app.optics.spherical import direction
from app.readouts import three
from app.terms import bound, evaluate, is_yours

NAMES = ("non_negative", "reciprocal", "energy", "finite", "linear")
SHORT = dict(zip(NAMES, ("≥ 0", "swap", "≤ 1", "finite", "linear"), strict=True))  # where there is little room
ASKED = dict(zip(NAMES, ("Is it nowhere negative?", "Can light and eye be swapped?",
                         "Does it send on at most what comes, for every angle?",
                         "Is it finite, also where it is extreme?", "Is it in proportion to the light?"), strict=True))
TOLD = {  # kept, and not
    "non_negative": ("It is nowhere negative.", "It is negative: {worst}{at}."),
    "reciprocal": ("Light and eye can be swapped.", "Swap light and eye, and {percent} % of it goes{at}."),
    "energy": ("It sends on at most {worst} of the light that comes{at}.",
               "It sends on {worst} times the light that comes{at}."),
    "finite": ("It is finite, also at grazing angles.", "It is no number, or infinite{at}."),
    "linear": ("Twice the light gives twice the answer.",
               "It is not in proportion to the light: off by {percent} %{at}.")}
PLACES = {"theta_l": "θ of the light", "theta_v": "θ of the eye", "phi": "φ"}
UNKNOWN = {"non_negative": "It is no number, or endlessly negative", "reciprocal": "One way round it is no number",
           "energy": "What it sends on is no number, or endless", "linear": "For some light it is no number"}
SAME, MOST = 1e-6, 1 + 1e-3  # a relative difference, an albedo that still pass
SAME_FLOAT32 = 1e-4  # two ways around a float32 formula may differ by this much; a different formula differs by more
VIEWS = np.radians([0, 15, 30, 45, 60, 70, 78, 84, 88, 89.5])  # at which light is summed over l
SEEN = math.cos(math.radians(88.01))  # pairs that are swapped stand higher than this: nearer to the floor is extreme
RADIANCES = 1e-3, 0.03, 1.0, 30.0, 1e3
EXTREMES = np.radians([0, 1e-7, 1e-3, 30, 89.9, 89.9999999, 90, 90.0000001, 120, 180])
AROUND = np.radians([0, 1e-6, 90, 179.9999, 180, -90])


@dataclass(frozen=True)
class Badge:
    ok: bool
    worst: float | None  # None: not a number, or infinite
    at: dict[str, float]  # rad: theta_l, theta_v, phi; of an albedo theta_v alone, or theta_l


def check(reflect: Callable, *, shading: bool = False, of_radiance: bool = False, same: float = SAME
          ) -> dict[str, Badge]:
    """All badges of reflect(n, l, v), arrays (..., 3), unit; n is +z. Deterministic; about 0.1 s for a cheap one.

    `same` is the relative difference of two ways that still counts as none: more than SAME for float32."""

    def f(n, l, v):
        with np.errstate(all="ignore"):
            found = np.asarray(reflect(n, l, v, 1.0) if of_radiance else reflect(n, l, v), float)
            found = np.broadcast_to(found, np.broadcast_shapes(l.shape, v.shape)[:-1])
            lit = l[..., 2] > 0
            return np.where(lit, found / np.where(lit, l[..., 2], 1.0), 0 * found) if shading else found

    l, v = samples()
    value, swapped = f(NORMAL, l, v), f(NORMAL, v, l)
    corner_l, corner_v = corners()
    corner = f(NORMAL, corner_l, corner_v)
    every = np.concatenate([value, corner]), np.concatenate([l, corner_l]), np.concatenate([v, corner_v])
    swap = reciprocal(value, swapped, l, v, same)
    sent = energy(f, swap.ok) if np.isfinite(value).all() else dark(f) or energy(f, swap.ok)
    return {"non_negative": non_negative(*every), "reciprocal": swap, "energy": sent,
            "finite": finite(*every), "linear": linear(reflect, l, v) if of_radiance else Badge(True, 0.0, {})}


def of_model(model: Model, values: dict) -> dict[str, Badge]:
    """The badges of a step's model at the step's values. A model of the board judges itself, in every channel."""
    if ":" in model.term.function:
        packed = bound(model.term, {"channel": 0, **values}, n=0, l=0, v=0)["values"]
        return import_module("app.board.terms").badges(model.term.function, packed, values.get(EDITED, ()))

    def reflect(n, l, v, radiance=1.0):
        return evaluate(model.term, values, n=n, l=l, v=v, radiance=radiance)

    return check(reflect, shading=model.is_shading, of_radiance="radiance" in arguments(model.term.function),
                 same=SAME_FLOAT32 if is_yours(model.term, values) else SAME)


def samples() -> tuple[np.ndarray, np.ndarray]:
    """Pairs l, v (pairs, 3): the directions of the first look, dense towards the mirror, the eye, and h = n."""
    looks = [first_look(tuple(VIEWS.tolist()))[pole] for pole in POLES]
    l = np.concatenate([l.reshape(-1, 3) for _, l, _ in looks])
    v = np.concatenate([np.broadcast_to(v, l.shape).reshape(-1, 3) for v, l, _ in looks])
    above = l[:, 2] > 0
    return l[above], v[above]


def corners() -> tuple[np.ndarray, np.ndarray]:
    """Pairs at which formulas break: along n, grazing, on and below the horizon, l = v and l = -v."""
    theta_l, theta_v, phi = (x.ravel() for x in np.meshgrid(EXTREMES, EXTREMES, AROUND))
    l, v = direction(theta_l, phi), direction(theta_v, 0 * phi)
    flat = direction(np.pi / 2, AROUND) * (1, 1, 0)  # on the horizon to the last digit
    l = np.concatenate([l, v, -v, flat, flat, np.broadcast_to(NORMAL, flat.shape)])
    return l, np.concatenate([v, v, v, flat, np.broadcast_to(NORMAL, flat.shape), flat])


def angles(l: np.ndarray, v: np.ndarray) -> dict[str, float]:
    """theta_l, theta_v, phi (rad) of one pair."""
    theta_l, theta_v = (float(np.arctan2(np.hypot(d[0], d[1]), d[2])) for d in (l, v))
    phi = float(np.arctan2(l[1], l[0]) - np.arctan2(v[1], v[0])) if theta_l and theta_v else 0.0
    return {"theta_l": theta_l, "theta_v": theta_v, "phi": math.remainder(phi, 2 * math.pi)}


def non_negative(value: np.ndarray, l: np.ndarray, v: np.ndarray) -> Badge:
    i = int(np.argmin(np.nan_to_num(value, nan=np.inf)))
    least = float(value[i])
    return Badge(least >= 0, least if math.isfinite(least) else None, angles(l[i], v[i]))


def reciprocal(value: np.ndarray, swapped: np.ndarray, l: np.ndarray, v: np.ndarray, same: float) -> Badge:
    """The pair is looked for where something is reflected: a thousandth of the largest value weighs as much."""
    with np.errstate(all="ignore"):
        most, off = np.maximum(abs(value), abs(swapped)), abs(value - swapped)
    seen = (l[:, 2] > SEEN) & (v[:, 2] > SEEN)
    good, odd = seen & np.isfinite(most), seen & (np.isfinite(value) != np.isfinite(swapped))
    if odd.any() or not good.any():
        i = int(np.argmax(odd))
        return Badge(False, None, angles(l[i], v[i]))
    if not most[good].any():
        return Badge(True, 0.0, {})
    weighed = np.where(good, off, 0) / (np.where(good, most, 1) + 1e-3 * most[good].max())
    i = int(np.argmax(weighed))
    worst = float(off[i] / most[i]) if weighed[i] else 0.0
    return Badge(bool(weighed[i] <= same), worst, angles(l[i], v[i]))


def dark(f: Callable) -> Badge | None:
    """An albedo that is no number: more than PART of an even light meets an f that is not finite."""
    v, l, weight = first_look(tuple(VIEWS.tolist()))["mirror"]
    share = weight * np.maximum(l[..., 2], 0)
    lost = np.sum(np.where(np.isfinite(f(NORMAL, l, v)), 0, share), -1) / np.sum(share, -1)
    i = int(np.argmax(lost))
    return Badge(False, None, {"theta_v": float(VIEWS[i])}) if lost[i] > PART else None


def energy(f: Callable, is_reciprocal: bool) -> Badge:
    """The largest albedo over all angles of the eye; of the light too, where that is another and nothing was found."""
    found = most(f, "theta_v")
    if is_reciprocal or not found.ok:
        return found
    other = most(lambda n, l, v: f(n, v, l), "theta_l")
    return found if other.ok else other


def most(f: Callable, name: str) -> Badge:
    """The largest albedo over the angles of VIEWS, then over some more beside it."""
    values, errors = albedo(f, VIEWS)
    i = int(np.argmax(values - errors))
    near = VIEWS[max(i - 1, 0)], VIEWS[min(i + 1, len(VIEWS) - 1)]
    theta = np.linspace(*near, 5)[1:-1] if 0 < i < len(VIEWS) - 1 else VIEWS[i:i + 1]
    more, off = albedo(f, theta)
    theta, values, errors = np.append(VIEWS, theta), np.append(values, more), np.append(errors, off)
    order = np.argsort(theta)
    sure = (values - errors)[order]
    i = order[int(np.argmax(sure >= sure.max() - 4e-4))]  # of equal ones the first
    worst = float(values[i])
    return Badge(bool(values[i] - errors[i] <= MOST), worst if math.isfinite(worst) else None, {name: float(theta[i])})


def finite(value: np.ndarray, l: np.ndarray, v: np.ndarray) -> Badge:
    bad = ~np.isfinite(value)
    i = int(np.argmax(bad)) if bad.any() else int(np.argmax(abs(value)))
    return Badge(not bad.any(), None if bad.any() else float(abs(value[i])), angles(l[i], v[i]))


def linear(reflect: Callable, l: np.ndarray, v: np.ndarray) -> Badge:
    l, v = l[::7], v[::7]
    with np.errstate(all="ignore"):
        found = [np.broadcast_to(reflect(NORMAL, l, v, x), len(l)) / x for x in RADIANCES]
        share = np.array(found)
        most, wide = np.max(abs(share), 0), np.ptp(share, 0)
    known = np.isfinite(share)
    odd = known.any(0) & ~known.all(0)
    if odd.any() or not known.any():
        i = int(np.argmax(odd))
        return Badge(False, None, angles(l[i], v[i]))
    off = np.where(known.all(0) & (most > 0), wide, 0) / np.where(known.all(0) & (most > 0), most, 1)
    i = int(np.argmax(off))
    return Badge(bool(off[i] <= SAME), float(off[i]), angles(l[i], v[i]))


def key(model: Model, values: dict) -> tuple:
    """What a model's badges depend on: the twin, another one once its file has changed, and its arguments, without the
    directions."""
    args = bound(model.term, {"channel": 0, **values}, n=0, l=0, v=0, radiance=0)
    edits = values.get(EDITED, ()) if is_yours(model.term, values) else ()
    return twin(model.term.function), tuple((name, str(value)) for name, value in args.items()), edits


def told(name: str, badge: Badge) -> str:
    """A sentence for a person, with the worst value and its angles."""
    worst, at = math.nan if badge.worst is None else badge.worst, place(badge)
    if badge.worst is None and not badge.ok and name in UNKNOWN:
        return f"{UNKNOWN[name]}{at}."
    return TOLD[name][not badge.ok].format(worst=three(worst), percent=f"{100 * worst:.0f}", at=at)


def place(badge: Badge) -> str:
    """', at θ_l = 59°, θ_v = 88°, φ = 173°'."""
    parts = [f"{PLACES[name]} {math.degrees(value):.4g}°" for name, value in badge.at.items() if name in PLACES]
    return f", at {', '.join(parts)}" if parts else ""


def as_json(badges: dict[str, Badge]) -> dict[str, dict]:
    return {name: asdict(badge) for name, badge in badges.items()}
