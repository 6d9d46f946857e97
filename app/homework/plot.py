"""A small plot of characters, for a terminal: the right values, the student's, and where both are."""

import numpy as np

from app.grade.sweep import Sweep

RIGHT, YOURS, BOTH = "·", "×", "●"
WIDTH, HEIGHT = 64, 11


def drawn(sweep: Sweep, width: int = WIDTH, height: int = HEIGHT) -> list[str]:
    """Lines of text: the plot, its axes' ends and a legend. Values that are no numbers leave a gap, and are counted."""
    if sweep.ends is None:
        return []
    low, high, log = sweep.ends
    rows = [[" "] * width for _ in range(height)]
    outside = 0
    for values, glyph in ((sweep.expected, RIGHT), (sweep.got, YOURS)):
        for i, value in enumerate(values):
            column = round(i * (width - 1) / (len(values) - 1))
            if not np.isfinite(value) or (log and value <= 0):
                outside += glyph == YOURS
                continue
            level = (np.log(value / low) / np.log(high / low)) if log else (value - low) / (high - low)
            row = height - 1 - round(float(np.clip(level, 0, 1)) * (height - 1))
            outside += glyph == YOURS and not -1e-9 <= level <= 1 + 1e-9
            if glyph == RIGHT or rows[row][column] == " ":
                rows[row][column] = glyph
            elif rows[row][column] == RIGHT:
                rows[row][column] = BOTH
    edge = max(len(short(high)), len(short(low)))
    lines = []
    for i, cells in enumerate(rows):
        name = short(high) if i == 0 else short(low) if i == height - 1 else ""
        lines.append(f"{name:>{edge}} │{''.join(cells).rstrip()}")
    ends = short(sweep.at[0]), short(sweep.at[-1])
    lines.append(f"{'':>{edge}} └{'─' * width}")
    middle = f"{sweep.label}{' (log)' if sweep.log else ''}"
    lines.append(f"{'':>{edge}}  {ends[0]}{middle:^{width - len(ends[0]) - len(ends[1])}}{ends[1]}")
    legend = f"{RIGHT} right   {YOURS} yours   {BOTH} both"
    if outside:
        legend += f"   ({outside} of yours lie outside or are no numbers)"
    return [*lines, f"{'':>{edge}}  {legend}"]


def short(value: float) -> str:
    return f"{float(value):.3g}"
