"""Where an axis has its ticks and what they say: round numbers, decades, degrees."""

import math
from dataclasses import dataclass

import numpy as np

SUPERSCRIPTS = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")


@dataclass(frozen=True)
class Axis:
    """A range of shown values; a logarithmic axis is drawn over log10 of them, as VTK's own has no powers of ten."""

    low: float
    high: float
    log: bool = False
    degrees: bool = False
    whole: bool = False  # only whole numbers

    def place(self, values) -> np.ndarray:
        """Where values lie on the axis; NaN where they cannot."""
        values = np.asarray(values, float)
        if not self.log:
            return np.where(np.isfinite(values), values, np.nan)
        return np.log10(values, out=np.full(values.shape, np.nan), where=np.isfinite(values) & (values > 0))

    @property
    def ends(self) -> tuple[float, float]:
        low, high = self.place([self.low, self.high])
        return float(low), float(high)

    def ticks(self, most: int) -> tuple[list[float], list[str]]:
        """At most about `most` positions on the axis, and their labels."""
        if not self.log:
            values = linear_ticks(self.low, self.high, most, self.degrees, self.whole)
            return values, [number(v) for v in values]
        low, high = self.ends
        if high - low < 1.8:
            values = [m * 10.0**k for k in range(math.floor(low), math.ceil(high) + 1) for m in (1, 2, 5)]
            values = [v for v in values if self.low * (1 - 1e-9) <= v <= self.high * (1 + 1e-9)]
            if 2 <= len(values) <= most + 1:
                return [math.log10(v) for v in values], [number(v) for v in values]
        if high - low < 0.8:
            values = [v for v in linear_ticks(self.low, self.high, most) if v > 0]
            return [math.log10(v) for v in values], [number(v) for v in values]
        first, last = math.ceil(low - 1e-9), math.floor(high + 1e-9)
        stride = max(1, math.ceil((last - first + 1) / most))
        powers = [k for k in range(first, last + 1) if k % stride == 0]
        plain = first >= -3 and last <= 4
        return [float(k) for k in powers], [number(10.0**k) if plain else power(k) for k in powers]


def linear_ticks(low: float, high: float, most: int, degrees: bool = False, whole: bool = False) -> list[float]:
    span = high - low
    if not span > 0:
        return [low]
    rough = span / most
    scale = 10.0 ** math.floor(math.log10(rough))
    steps = [scale * m for m in (1, 2, 5, 10, 20)]
    if degrees and span >= 40:
        steps = [10, 15, 30, 45, 90, 180]
    if whole:
        steps = [max(1.0, s) for s in steps]
    step = next((s for s in steps if s >= rough * 0.999), steps[-1])
    first, last = math.ceil(low / step - 1e-6), math.floor(high / step + 1e-6)
    return [round(k * step, 15) + 0.0 for k in range(first, last + 1)]


def nice(value: float) -> float:
    """The next round number upwards."""
    scale = 10.0 ** math.floor(math.log10(value))
    return next(m * scale for m in (1, 1.2, 1.5, 2, 3, 4, 5, 6, 8, 10, 20) if m * scale >= value * (1 - 1e-12))


def number(value: float) -> str:
    if value == 0:
        return "0"
    exponent = math.floor(math.log10(abs(value)) + 1e-9)
    if -4 < exponent < 5:
        return f"{value:.6g}".replace("-", "−")
    mantissa = f"{value / 10.0**exponent:.4g}".replace("-", "−")
    return f"{mantissa}·{power(exponent)}" if mantissa not in ("1", "−1") else mantissa[:-1] + power(exponent)


def power(exponent: int) -> str:
    return "10" + str(exponent).translate(SUPERSCRIPTS)
