"""Marks that a person gave by hand: RESULTS/overrides.csv with student, points and reason; the grader only reads it."""

import csv
import math
from pathlib import Path

from app.problem import Problem

NAME = "overrides.csv"
COLUMNS = ["student", "points", "reason"]


def read(results: Path) -> dict[str, dict]:
    """Student -> points and reason; none where there is no such file."""
    path = results / NAME
    if not path.exists():
        return {}
    found: dict[str, dict] = {}
    with open(path, encoding="utf-8-sig", newline="") as file:
        table = csv.reader(file)
        if next(table, None) != COLUMNS:
            raise Problem(f"{path}, line 1: the columns are {','.join(COLUMNS)}.")
        for row in filter(None, table):
            try:
                points = float(row[1])
            except (ValueError, IndexError):
                points = math.nan
            if not math.isfinite(points) or len(row) != len(COLUMNS):
                raise Problem(f"{path}, line {table.line_num}: {','.join(row)} is no student, points and reason.")
            found[row[0]] = {"points": points, "reason": row[2]}
    return found
