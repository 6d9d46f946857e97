"""Where a question is asked: what a lecturer writes about an argument, and numbers drawn from it.

Angles are in degrees, as on screen. A direction's range is its angle from the normal: [0, 75], grazing [88, 89.9], from
below [95, 180]. Every number is one that float32 can hold, so that both languages are asked the same.
"""

import math
from dataclasses import dataclass

import numpy as np

from app.problem import Usage, near
from app.quantities import TABLE, entered

DIRECTIONS = ("n", "l", "v", "h")
FORMS = {  # a table of one of these keys, besides a number, [low, high] and "any"
    "choose": "one of some numbers", "log": "[low, high], evenly in its logarithm",
    "times": "another argument times a number of `by` = [low, high]", "between": "between two other arguments",
    "near": "a vector that lies off another by a length of `by` = [low, high]",
    "mirror": "a direction [low, high] degrees off the mirror direction of l",
    "slopes": "a direction whose slope is `of` times a number of [low, high]",
    "lobe": "v such that h lies in the highlight of the exponent `of`, in units of its width",
}


@dataclass(frozen=True)
class Domain:
    """What an argument's numbers are drawn from."""

    form: str  # fixed, range, direction, or a word of FORMS
    numbers: tuple = ()
    other: tuple[str, ...] = ()  # arguments it depends on


def domain(name: str, given: object, arguments: tuple[str, ...], free: bool = False) -> Domain:
    """What was written for an argument, as a Domain; a Usage says what would be right. `free`: not only in the range
    of its quantity."""
    if isinstance(given, dict):
        return dependent(name, given, arguments, free)
    if isinstance(given, list) and given:
        return listed(name, given, free)
    if name in DIRECTIONS and given == "any":
        return Domain("direction", (0.0, 180.0))
    if is_number(given):
        return Domain("fixed", (inside(name, float(given), free),))  # type: ignore[arg-type]
    raise no_domain(name, given)


def listed(name: str, given: list, free: bool) -> Domain:
    """[low, high], of numbers or of vectors, or one vector."""
    if len(given) == 2 and all(isinstance(end, list) for end in given):
        return Domain("range", tuple(tuple(map(float, end)) for end in given))
    if not 2 <= len(given) <= 4 or not all(map(is_number, given)):
        raise no_domain(name, given)
    numbers = tuple(map(float, given))
    if len(given) > 2:
        return Domain("fixed", (numbers,))
    if name in DIRECTIONS:
        return Domain("direction", ordered(numbers, 0, 180))
    low, high = ordered(numbers)
    return Domain("range", (inside(name, low, free), inside(name, high, free)))


def no_domain(name: str, given: object) -> Usage:
    any_way = ', "any"' if name in DIRECTIONS else ""
    return Usage(f"{given!r} is no domain; right are a number, [low, high]{any_way} or a table of {', '.join(FORMS)}")


def dependent(name: str, given: dict, arguments: tuple[str, ...], free: bool) -> Domain:
    form = next((key for key in given if key in FORMS), "")
    unknown = [key for key in given if key not in (form, "by", "of")]
    if not form or unknown:
        word = (unknown or [*given, ""])[0]
        raise Usage(f"there is no form {word}; the forms are {', '.join(FORMS)}.{near(word, FORMS)}")
    value, by = given[form], given.get("by", [0.0, 1.0])
    other = {"times": [value], "near": [value], "between": value, "mirror": ["l"]}.get(form, [given.get("of", "")])
    if form in ("choose", "log"):
        other = []
    if form == "lobe":
        other = [*other, "l"]
    if not isinstance(other, list) or (form == "between" and len(other) != 2):
        raise Usage(f"{form} = {value!r}; right is a list of two arguments")
    for word in other:
        if word not in arguments or word == name:
            raise Usage(f"{form} speaks of {word!r}, which is no other argument.{near(str(word), arguments)}")
    numbers = by if form in ("times", "near") else [0.0, 1.0] if form == "between" else value
    if not isinstance(numbers, list) or not numbers or not all(map(is_number, numbers)) or (
            form != "choose" and len(numbers) != 2):
        raise Usage(f"{form} has {numbers!r}; right are two numbers, [low, high]")
    if form == "choose":
        return Domain(form, tuple(inside(name, float(x), free) for x in numbers))
    low, high = ordered(tuple(map(float, numbers)))
    if form == "log":
        low, high = inside(name, low, free), inside(name, high, free)
        if low <= 0:
            raise Usage(f"log goes from {low:g}; its ends are above 0")
    return Domain(form, (low, high), tuple(other))


def is_number(given: object) -> bool:
    return isinstance(given, (int, float)) and not isinstance(given, bool) and math.isfinite(given)


def ordered(numbers: tuple, low: float = -math.inf, high: float = math.inf) -> tuple:
    if not low <= numbers[0] <= numbers[1] <= high:
        limits = f", from {low:g} to {high:g}" if math.isfinite(high) else ""
        raise Usage(f"{list(numbers)} is no range; right is the smaller number first{limits}")
    return numbers


def inside(name: str, value: float, free: bool) -> float:
    """A number as the formulas want it; an angle comes in degrees. It lies in the widest range of its quantity."""
    if name not in TABLE or TABLE[name].width > 1:
        return value
    q = TABLE[name]
    low, high = (q.low, q.high) if q.extreme is None else (min(q.low, q.extreme[0]), max(q.high, q.extreme[1]))
    inner = float(entered(name, value))  # type: ignore[arg-type]
    if not free and not low * (1 - 1e-6) - 1e-12 <= inner <= high * (1 + 1e-6) + 1e-12:
        shown = [round(math.degrees(x), 6) if q.is_angle else x for x in (low, high)]
        unit = q.screen_unit
        raise Usage(f"{value:g} is outside what {name} can be, {shown[0]:g} to {shown[1]:g} {unit}".rstrip())
    return inner


def default_of(name: str) -> Domain:
    """Where an argument is asked when nothing is said: the ordinary range of its quantity."""
    if name in DIRECTIONS:
        return Domain("fixed", ((0.0, 0.0, 1.0),)) if name == "n" else Domain("direction", (0.0, 80.0))
    q = TABLE[name]
    if q.width > 1:
        return Domain("range", ((q.low,) * q.width, (q.high,) * q.width))
    return Domain("log" if q.scale == "log" and q.low > 0 else "range", (q.low, q.high))


def draw(domains: dict[str, Domain], rng: np.random.Generator, count: int) -> dict[str, np.ndarray]:
    """`count` rows of every argument."""
    found: dict[str, np.ndarray] = {}

    def get(name: str) -> np.ndarray:
        if name not in found:
            found[name] = as_float32(drawn(name, domains.get(name) or default_of(name), rng, count, get))
        return found[name]

    for name in domains:
        get(name)
    return {name: found[name] for name in domains}


def drawn(name: str, given: Domain, rng: np.random.Generator, count: int, get) -> np.ndarray:  # noqa: PLR0911
    numbers, share = np.asarray(given.numbers, float), rng.random(count)
    if given.form in ("fixed", "choose"):
        return np.repeat(numbers, count, 0) if given.form == "fixed" else rng.choice(numbers, count)
    low, high = numbers
    if given.form == "range":
        return low + (high - low) * (rng.random((count, *numbers.shape[1:])) if numbers.ndim > 1 else share)
    if given.form == "between":
        first, second = map(get, given.other)
        return first + (second - first) * share
    if given.form == "times":
        return get(given.other[0]) * (low + (high - low) * share)
    if given.form in ("log", "near"):
        size = np.exp(np.log(low) + (np.log(high) - np.log(low)) * share)
        if given.form == "log":
            return size
        way = rng.normal(size=(count, 3))
        return get(given.other[0]) + way / length(way) * size[:, None]
    return direction(name, given, rng, count, get, low + (high - low) * share)


def direction(name: str, given: Domain, rng, count: int, get, amount: np.ndarray) -> np.ndarray:
    turn = rng.uniform(-np.pi, np.pi, count)
    if given.form == "slopes":
        return tilted(get("n"), np.arctan(amount * get(given.other[0])), turn)
    if given.form == "lobe":
        h = tilted(get("n"), np.minimum(amount * np.sqrt(2 / (get(given.other[0]) + 2)), 1.2), turn)
        l = get("l")
        return 2 * np.sum(h * l, -1, keepdims=True) * h - l
    if given.form == "mirror":
        n, l = get("n"), get("l")
        return tilted(2 * np.sum(n * l, -1, keepdims=True) * n - l, np.radians(amount), turn)
    low, high = np.cos(np.radians(given.numbers))  # evenly over the sphere's area
    cosine = low + (high - low) * rng.random(count)
    axis = np.repeat([[0.0, 0.0, 1.0]], count, 0) if name == "n" else get("n")
    return tilted(axis, np.arccos(np.clip(cosine, -1, 1)), turn)


def tilted(axis: np.ndarray, angle: np.ndarray, turn: np.ndarray) -> np.ndarray:
    """Unit vectors at an angle from an axis."""
    axis = axis / length(axis)
    side = np.where(np.abs(axis[:, 2:]) < 0.9, [[0.0, 0.0, 1.0]], [[1.0, 0.0, 0.0]])
    first = np.cross(axis, side)
    first = first / length(first)
    around = np.cos(turn)[:, None] * first + np.sin(turn)[:, None] * np.cross(axis, first)
    return np.cos(angle)[:, None] * axis + np.sin(angle)[:, None] * around


def length(x: np.ndarray) -> np.ndarray:
    return np.sqrt(np.sum(x * x, -1, keepdims=True))


def as_float32(x: np.ndarray) -> np.ndarray:
    return np.asarray(x, float).astype(np.float32).astype(float)
