"""A record as a table a person can read, and as JSON."""

from shutil import get_terminal_size
from textwrap import fill

from app.plots.ticks import number
from app.readouts import duration
from app.study.record import ENOUGH, TOLERANCES, Line, Record

HEADS = ("method", *(f"to {number(tolerance)}" for tolerance in TOLERANCES), "order in N", "best", "")
NARROW, WIDE = 80, 120  # letters of a terminal


def width() -> int:
    """How wide lines may be: the terminal's width, up to what one reads with ease; a file has no end."""
    return min(WIDE, max(NARROW, get_terminal_size((WIDE, 24)).columns))


def table(record: Record, wide: int = WIDE) -> str:
    """The times to reach each tolerance, the fitted order with its spread, the smallest error, what failed silently.

    In `wide` letters: a silent failure that finds no room beside its method stands below it."""
    rows = [HEADS, *(row(line) for line in record.lines)]
    if wide < 100:  # letters
        rows = [tuple(cell.replace("did not reach", "not reached") for cell in one) for one in rows]
    widths = [max(len(one[i]) for one in rows) for i in range(len(HEADS) - 1)]
    lines = []
    for one in rows:
        cells = zip(one[1:-1], widths[1:], strict=True)
        lines.append("  ".join([one[0].ljust(widths[0]), *(cell.rjust(most) for cell, most in cells)]).rstrip())
        if one[-1]:
            beside = f"{lines[-1].ljust(sum(widths) + 2 * len(widths) - 2)}  {one[-1]}"
            lines[-1:] = [beside] if len(beside) + 2 <= wide else [lines[-1], f"  {one[-1]}"]
    first = fill(wins(record), wide, initial_indent="  ", subsequent_indent="  ", break_on_hyphens=False)
    return "\n".join([f"{record.name}: {record.title}", *("  " + line for line in lines), first])


def row(line: Line) -> tuple[str, ...]:
    if not line.points:
        return line.label, *("-",) * (len(HEADS) - 2), line.stopped
    reached = [duration(1e3 * point.time) if (point := line.reach(t)) else "did not reach" for t in TOLERANCES]
    order = "exponential" if line.exponential else f"{line.order[0]:.2f} ± {line.order[1]:.2f}" if line.order else ""
    if line.order and line.order[1] > abs(line.order[0]):
        order = "none"  # points all over the place
    best = min(point.error for point in line.points)
    worst = max(line.silent, key=lambda point: point.wrong, default=None)
    shown = "exact" if line.reference and best < ENOUGH else number(float(f"{best:.0e}"))  # in float32 it has an error
    return line.label, *reached, order, shown, f"× silent: {worst.words}" if worst else ""


def wins(record: Record) -> str:
    """Who wins where, in a line."""
    found = []
    for tolerance in TOLERANCES:
        winner = record.winner(tolerance)
        words = f"{winner[0].label} ({duration(1e3 * winner[1].time)}, N = {winner[1].samples})" if winner else "nobody"
        close = [line.label for line in record.beside(tolerance)]
        if close:
            words += f", hardly before {close[0] if len(close) == 1 else f'{len(close)} others'}"
        found.append(f"{number(tolerance)}: {words}")
    exact = [line for line in record.lines if line.reference and line.points]
    also = f"; the closed form needs {duration(1e3 * exact[0].points[0].time)}" if exact else ""
    return "first to " + "; to ".join(found) + also + "."


def as_data(record: Record) -> dict:
    """Every point, for programs; times in seconds."""
    return {
        "step": record.step, "title": record.title, "case": record.case, "where": record.where,
        "values": record.values, "exact": record.exact, "seconds": record.seconds, "seeds": record.seeds,
        "why": record.why, "left_out": record.without, "methods": [method(line) for line in record.lines]}


def method(line: Line) -> dict:
    reached = {f"{t:g}": point.time if (point := line.reach(t)) else None for t in TOLERANCES}
    order = ({"order": line.order[0], "order_spread": line.order[1], "exponential": line.exponential}
             if line.order else {})
    return {
        "label": line.label, "reference": line.reference, "random": line.random, "stopped": line.stopped,
        "silent_failures": len(line.silent),
        "time_to": reached, **order,
        "points": [{"rung": p.rung, "samples": p.samples, "error": p.error if p.error < float("inf") else None,
                    "time": p.time, "quartiles": p.spread, "runs": len(p.times), "claimed_error": p.claim,
                    "said": p.said, "silent_failure": p.words if p.silent else ""}
                   for p in line.points]}
