"""Rows of figures: repeats of several things taken in turn, so that a busy moment hits all of them alike."""

import time
from collections.abc import Callable
from dataclasses import dataclass, field
from statistics import median

Job = Callable[[], float]


@dataclass
class Row:
    name: str
    unit: str
    samples: list[float] = field(default_factory=list)
    asked: float | None = None  # at most this
    ratio: float | None = None  # to the group's reference, the median of the rounds

    @property
    def middle(self) -> float:
        return median(self.samples)

    def as_dict(self) -> dict:
        return {"name": self.name, "unit": self.unit, "median": self.middle, "least": min(self.samples),
                "most": max(self.samples), "asked": self.asked, "ratio": self.ratio, "samples": len(self.samples)}

    def words(self) -> str:
        asked = "" if self.asked is None else f"{self.asked:g}"
        ratio = "" if self.ratio is None else f"{self.ratio:.2f}"
        spread = f"{min(self.samples):.3g} - {max(self.samples):.3g}"
        return f"{self.name:44s}{self.middle:10.3g} {self.unit:4s}{spread:>18s}{ratio:>9s}{asked:>8s}"


HEAD = f"{'':44s}{'median':>10s} {'':4s}{'least - most':>18s}{'ratio':>9s}{'asked':>8s}"


def in_turn(jobs: dict[str, Job], rounds: int, unit: str = "ms", asked: dict[str, float] | None = None) -> list[Row]:
    """Each job once a round; the first job is the reference of the ratios. A first round, not counted, warms up."""
    rows = {name: Row(name, unit, asked=(asked or {}).get(name)) for name in jobs}
    for counted in (False, *[True] * rounds):
        for name, job in jobs.items():
            sample = job()
            if counted:
                rows[name].samples.append(sample)
    reference = rows[next(iter(jobs))].samples
    for row in rows.values():
        row.ratio = median(sample / base for sample, base in zip(row.samples, reference, strict=True))
    return list(rows.values())


def timed(job: Callable[[], object]) -> Job:
    def run() -> float:
        start = time.perf_counter()
        job()
        return 1e3 * (time.perf_counter() - start)

    return run
