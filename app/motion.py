"""A value that moves: from one end to the other, evenly on the scale of its slider, and back if one likes."""

import math
from collections.abc import Iterable
from dataclasses import dataclass

from app.catalog import LoadedStep, ValueSpec
from app.lesson import Number
from app.problem import Usage, near
from app.spoken import words
from app.typed import digits, on_screen, read


@dataclass(frozen=True)
class Sweep:
    """One value on its way, internal units."""

    spec: ValueSpec
    first: float
    last: float

    def at(self, share: float) -> float:
        """The value after this share (0 to 1) of the way; the ends are met exactly."""
        a, b = self.first, self.last
        if share in (0.0, 1.0):
            return b if share else a
        even = math.exp(math.log(a) + (math.log(b) - math.log(a)) * share) if self.is_log else a + (b - a) * share
        return round(even) if self.spec.quantity.kind == "int" else even

    @property
    def is_log(self) -> bool:
        return self.spec.scale == "log" and self.first > 0 and self.last > 0

    def told(self, value: float) -> str:
        """'roughness m 0.30', with as many digits at every place of the way."""
        q, spec = self.spec.quantity, self.spec
        name = spec.label or words(spec.name)
        if spec.choices:
            return f"{name}: {spec.choices[int(value)]}"
        now, span = on_screen(spec, value), abs(on_screen(spec, self.last) - on_screen(spec, self.first))
        if q.kind == "int":
            return f"{name} = {now:.0f}"
        ends = [abs(on_screen(spec, end)) for end in (self.first, self.last)]
        finest = min(ends) / 10 if self.is_log else min([span / 50, *(end for end in ends if end)])
        places = min(max(0, -math.floor(math.log10(finest))), 5) if finest > 0 else 2
        unit = q.screen_unit
        return f"{name} = {now:.{places}f}".replace("-", "−") + (unit if unit in ("", "°") else f" {unit}")


def sweep(text: str, found: LoadedStep, option: str = "--sweep") -> Sweep:
    """`m=0.05..1` in screen units, as a sweep of the step's value; `m` alone goes over its whole range."""
    name, equals, ends = (part.strip() for part in text.partition("="))
    if name not in found.values:
        raise Usage(f"{option} {text}: there is no value {name} in {found.id}.{near(name, found.values)}")
    spec = found.values[name]
    if spec.quantity.width > 1:
        raise Usage(f"{option} {text}: {name} has {spec.quantity.width} numbers, and a sweep moves one.")
    if not equals:
        return Sweep(spec, spec.low, spec.high)
    first, dots, last = ends.partition("..")
    if not (first and dots and last):
        at = f"{digits(on_screen(spec, spec.low))}..{digits(on_screen(spec, spec.high))}"
        raise Usage(f"{option} {text} is no sweep; write where it begins and ends, like {name}={at}.")
    a, b = (float(number(read(end, spec, f"{option} {text}"))) for end in (first, last))
    return Sweep(spec, a, b)


def number(value: Number) -> float:
    assert not isinstance(value, tuple)
    return value


def moved(sweeps: Iterable[Sweep], share: float) -> dict[str, Number]:
    """The values of all sweeps after this share of the way."""
    return {one.spec.name: one.at(share) for one in sweeps}


def there_and_back(phase: float) -> float:
    """0 to 1 and back to 0 while the phase goes from 0 to 1; then again."""
    phase %= 1.0
    return 2 * phase if phase <= 0.5 else 2 * (1 - phase)
