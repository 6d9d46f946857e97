"""The unit ledger: quantities in a chain, each the one before times a factor. The only pint.

pint checks that the factor's unit makes the one unit into the other. It counts the steradian as a dimension of its own
here (by its own rules sr is 1, and a lumen would be a candela).
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from itertools import pairwise

from app.lesson import Ledger, LedgerRow
from app.problem import Problem
from app.readouts import three
from app.terms import evaluate

DEFINITIONS = ("meter = [length] = m", "second = [time] = s", "steradian = [solid_angle] = sr", "watt = [power] = W",
               "joule = watt * second = J", "candela = [luminosity] = cd", "lumen = candela * steradian = lm",
               "lux = lumen / meter ** 2 = lx", "nit = candela / meter ** 2 = nt")


@dataclass(frozen=True)
class Line:
    """A row with its numbers."""

    label: str
    value: float
    unit: str
    factor: float | None  # what the value before was multiplied by, and its unit; None in the first row
    by: str
    how: str


@dataclass(frozen=True)
class Balance:
    emitted: float
    received: float
    escaped: float
    unit: str

    @property
    def off(self) -> float:
        """What is not accounted for, as a share of what is emitted."""
        return (self.received + self.escaped - self.emitted) / self.emitted if self.emitted else 0.0


@cache
def registry():
    import pint

    units = pint.UnitRegistry(None)
    units.load_definitions(list(DEFINITIONS))
    return units


def dimension(unit: str):
    """A unit's dimension: a power of length, time, solid angle, power and luminosity each."""
    try:
        return registry().Quantity(1, registry().parse_units(unit.replace(" ", "*"))).dimensionality
    except Exception as error:  # pint raises many kinds for a unit it cannot read
        raise Problem(f"{unit!r} is no unit of the ledger ({error}); it knows m, s, sr, W, J, cd, lm, lx.") from None


def faults(plot: Ledger) -> Iterator[tuple[str, str]]:
    """(a word to find the row by, what is wrong) for each row whose unit does not follow from the one before."""
    for column in plot.columns:
        for before, row in pairwise(column):
            try:
                follows = dimension(f"({before.unit}) ({row.by or '1'})" if row.by else before.unit)
                if follows != dimension(row.unit):
                    yield row.label, (f"{row.label}: {before.unit} times {row.by or 'a number'} has the dimension "
                                      f"{follows}, and {row.unit} has {dimension(row.unit)}.")
            except Problem as problem:
                yield row.label, f"{row.label}: {problem}"


def lines(column: tuple[LedgerRow, ...], values: dict) -> list[Line]:
    """A column's rows with their numbers; the factor of each is the quotient of the values, in the unit pint has
    checked."""
    found: list[Line] = []
    for row in column:
        value = float(evaluate(row.term, values))
        before = found[-1].value if found else 0.0
        factor = value / before if before else math.nan
        found.append(Line(row.label, value, row.unit, factor if math.isfinite(factor) else None, row.by, row.how))
    return found


def balance(plot: Ledger, values: dict) -> Balance | None:
    """What is emitted, what arrives and what goes past: three numbers found apart from each other."""
    if not plot.balance:
        return None
    emitted, received, escaped = (float(evaluate(term, values)) for term in plot.balance)
    return Balance(emitted, received, escaped, plot.unit)


def pretty(unit: str) -> str:
    return unit.replace("^2", "²").replace(" ", "·")


def factor_words(line: Line) -> str:
    """'× 30.0 lm/W', '÷ 12.6 sr'."""
    if line.factor is None:
        return ""
    if line.by.startswith("1/"):
        return f"÷ {three(1 / line.factor) if line.factor else 'infinite'} {pretty(line.by[2:])}"
    return f"× {three(line.factor)} {pretty(line.by)}".rstrip()
