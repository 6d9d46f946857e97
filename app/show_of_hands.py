"""A show of hands as numbers: how many chose what, or what was guessed, and how a class did."""

import math
import re
from dataclasses import dataclass, field

from app.classroom import Prediction
from app.prediction import GOOD, quantity, share
from app.problem import Usage
from app.typed import digits

MOST = 1000  # hands
BINS = 12
ONE = re.compile(r"([-+.\deE]+)(?:[x×*](\d{1,4}))?")


@dataclass
class Hands:
    ask: Prediction
    counts: list[int] = field(default_factory=list)  # of each choice
    guesses: list[float] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.counts = self.counts or [0] * len(self.ask.choices)

    @property
    def total(self) -> int:
        return sum(self.counts) if self.ask.choices else len(self.guesses)

    def count(self, choice: int, hands: int) -> None:
        self.counts[choice] = min(max(hands, 0), MOST)

    def take(self, text: str) -> None:
        """`0.3 0.5x4 0.7`: one of 0.3, four of 0.5, one of 0.7. What is no guess is a Usage, and nothing changes."""
        found: list[float] = []
        for word in re.split(r"[\s;]+|,(?=\s)", text.strip()):
            if not word:
                continue
            match = ONE.fullmatch(word)
            try:
                value = float(match[1]) if match else math.nan
            except ValueError:
                value = math.nan
            if not math.isfinite(value):
                raise Usage(f"{word} is no guess; write numbers, and 0.5x4 for four hands at 0.5.")
            if not self.ask.low <= value <= self.ask.high:
                raise Usage(f"{word}: guesses go from {digits(self.ask.low)} to {digits(self.ask.high)}.")
            found += [value] * int(match[2] or 1 if match else 1)
        if len(found) > MOST:
            raise Usage(f"{len(found)} hands are more than {MOST}.")
        self.guesses = sorted(found)

    def bars(self) -> list[tuple[str, int]]:
        """The distribution: each choice, or each part of the slider's range, and its hands."""
        if self.ask.choices:
            return [(choice.text, hands) for choice, hands in zip(self.ask.choices, self.counts, strict=True)]
        hands = [0] * BINS
        for guess in self.guesses:
            hands[self.bin(guess)] += 1
        return [(quantity(self.middle(i), self.ask.unit), n) for i, n in enumerate(hands)]

    def bin(self, value: float) -> int:
        return min(max(int(self.along(value) * BINS), 0), BINS - 1)

    def along(self, value: float) -> float:
        """Where a value lies on the slider, 0 to 1."""
        low, high = self.ask.low, self.ask.high
        if self.ask.scale == "log":
            low, high, value = (math.log(max(x, 1e-300)) for x in (low, high, value))
        return min(max((value - low) / (high - low), 0.0), 1.0)

    def middle(self, i: int) -> float:
        low, high, at = self.ask.low, self.ask.high, (i + 0.5) / BINS
        return math.exp(math.log(low) + (math.log(high) - math.log(low)) * at) if self.ask.scale == "log" else (
            low + (high - low) * at)

    def right(self, truth: float) -> int | None:
        """The number of the choice that is right; None for a guess."""
        return next((i for i, c in enumerate(self.ask.choices) if c.low <= truth <= c.high), None)

    def words(self, truth: float) -> str:
        """How the class did, in a sentence."""
        if not self.total:
            return ""
        if self.ask.choices:
            right = self.right(truth)
            good = self.counts[right] if right is not None else 0
            return f"{good} of {self.total} hands had it."
        close = sum(share(self.ask, guess, truth) <= GOOD for guess in self.guesses)
        middle = self.guesses[len(self.guesses) // 2]
        return f"{close} of {self.total} within {GOOD:.0%}; the middle guess was {quantity(middle, self.ask.unit)}."
