"""A value as a person types and reads it: screen units in, internal values out, and one sentence when it cannot be.

Angles are in degrees (`30`, `30deg`, `30°`; `0.5rad` too), vectors `0.3,0.2`, named numbers a number or a word.
"""

import math
import re

from app.catalog import ValueSpec
from app.lesson import Number
from app.problem import Usage, near

SLACK = 5e-6  # relative: half a unit in the sixth digit
ANGLE = re.compile(r"(.*?)\s*(deg|rad|°)?", re.S)
AXES = ("x", "y", "z")


def read(text: str, spec: ValueSpec, where: str) -> Number:
    """A number (or several, with commas) in screen units as the internal value; out of range is a Usage."""
    text = unquoted(text)
    words = [slug(choice) for choice in spec.choices]
    if slug(text) in words and spec.low <= words.index(slug(text)) <= spec.high:
        return words.index(slug(text))
    parts, width = text.split(","), spec.quantity.width
    if len(parts) != width:
        wanted = f"{width} numbers ({', '.join(AXES[:width])})" if width > 1 else "one number"
        raise Usage(f"{where} takes {wanted}, not {len(parts)}.")
    numbers = [one(part, spec, where) for part in parts]
    return checked(tuple(numbers) if width > 1 else numbers[0], spec, where)


def one(text: str, spec: ValueSpec, where: str) -> float:
    unit = None
    if spec.quantity.is_angle:
        match = ANGLE.fullmatch(text)
        assert match
        text, unit = match[1], match[2]
    try:
        value = number(text, where)
    except Usage:
        if spec.choices:
            offered = spec.choices[int(spec.low):int(spec.high) + 1]
            raise Usage(f"{where} takes one of {', '.join(offered)}.{near(text, offered)}") from None
        raise
    if unit == "rad":
        return value
    inside = spec.quantity.entered(value)
    assert not isinstance(inside, tuple)
    return inside


def number(text: str, where: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value) or "_" in text:
        raise Usage(f"{where} takes a number, and {text.strip() or 'nothing'} is none.")
    return value


def checked(value: Number, spec: ValueSpec, where: str) -> Number:
    """The value, whole if it must be; a last digit beyond the range is put on it, more is a Usage."""
    if isinstance(value, tuple):
        if len(value) != spec.quantity.width:
            raise Usage(f"{where} takes {spec.quantity.width} numbers, not {len(value)}.")
        return tuple(within(x, spec, where) for x in value)
    if spec.quantity.width > 1:
        raise Usage(f"{where} takes {spec.quantity.width} numbers, not one.")
    return within(value, spec, where)


def within(value: float, spec: ValueSpec, where: str) -> float:
    if spec.quantity.kind == "int" and value != round(value):
        raise Usage(f"{where} takes a whole number {span(spec)}.")
    if not spec.low - SLACK * abs(spec.low) <= value <= spec.high + SLACK * abs(spec.high):
        raise Usage(f"{where} takes {spec.name} {span(spec)}.")
    value = min(max(value, spec.low), spec.high)
    return round(value) if spec.quantity.kind == "int" else value


def span(spec: ValueSpec) -> str:
    """'from 0.5 to 5 m': the range in screen units."""
    unit = spec.quantity.screen_unit
    low, high = (digits(on_screen(spec, bound)) for bound in (spec.low, spec.high))
    return f"from {low} to {high}{'' if unit in ('', '°') else ' '}{unit}"


def on_screen(spec: ValueSpec, value: Number) -> float:
    on = spec.quantity.shown(value)
    assert not isinstance(on, tuple)
    return on


def digits(value: float) -> str:
    """Six significant digits, in a form a link can carry (no plus sign, no leading zeros in the exponent)."""
    text = f"{value + 0.0:.6g}"  # + 0.0: no negative zero
    if "e" not in text:
        return text
    mantissa, _, exponent = text.partition("e")
    return f"{mantissa}e{int(exponent)}"


def places(spec: ValueSpec, now: Number) -> str:
    """The end of printf's format for a value on the screen, as a slider shows it: what its range asks for, and at least
    three significant digits of whatever is not 0."""
    low, high = on_screen(spec, spec.low), on_screen(spec, spec.high)
    if spec.scale == "log" and (high / low > 1e3 or low < 0.01):
        return f"{max(3, math.ceil(-math.log10(low)))}g"  # a logarithmic slider ends at 10^-digits, whatever its low is
    return finer(now, 0 if low >= 100 else 1 if spec.quantity.is_angle else 2 if high - low > 0.5 else 3)


def finer(now: Number, fewest: int) -> str:
    """So many digits behind the point, or more where what is not 0 would have fewer than three."""
    least = min((abs(x) for x in (now if isinstance(now, tuple) else (now,)) if x), default=1e3)
    return "3g" if least < 1e-4 else f"{max(fewest, 2 - math.floor(math.log10(least)))}f"


def show(spec: ValueSpec, value: Number | None = None) -> str:
    """A value (or the default) as the state string has it."""
    value = spec.default if value is None else value
    if spec.choices and not isinstance(value, tuple):
        words = [slug(choice) for choice in spec.choices]
        word = words[int(value)] if 0 <= value < len(words) else ""
        return word if word and words.count(word) == 1 else digits(value)
    if isinstance(value, tuple):
        return ",".join(digits(on_screen(spec, x)) for x in value)
    return digits(on_screen(spec, value))


def slug(words: str) -> str:
    """Words as a link can carry them: 'open box' is open-box."""
    return "-".join(re.findall(r"[a-z0-9]+", words.casefold())) if re.search("[a-z]", words.casefold()) else ""


def unquoted(text: str) -> str:
    """A browser writes ',' as %2C."""
    if "%" not in text:
        return text
    from urllib.parse import unquote

    return unquote(text)
