"""The late rule: when each student handed in, as the course team says in a CSV file. Times of files are not asked: they
change with every copy and every archive. Marks follow from what was graded, so a corrected time costs no new grading.
"""

import csv
from collections.abc import Iterable
from datetime import datetime
from pathlib import Path

from app.grade.assignment import Assignment
from app.grade.result import number
from app.problem import Usage

COLUMNS = ["student", "time"]
EXAMPLE = "2026-12-01T23:59:00+01:00"


def read(file: str, assignment: Assignment, students: Iterable[str]) -> dict[str, datetime]:
    """Student -> when; everyone who handed in must be there, others may be (with an empty time)."""
    if not file:
        return {}
    if assignment.due is None:
        raise Usage(f"{assignment.file.name} has no due date, so nothing is late; write due = {EXAMPLE} into it.")
    found: dict[str, datetime] = {}
    try:
        with open(Path(file).expanduser(), encoding="utf-8-sig", newline="") as lines:
            table = csv.reader(lines)
            if next(table, None) != COLUMNS:
                raise Usage(f"{file}, line 1: the columns are {','.join(COLUMNS)}.")
            for row in filter(None, table):
                place = f"{file}, line {table.line_num}"
                if len(row) != len(COLUMNS):
                    raise Usage(f"{place}: {','.join(row)} is no student and time.")
                if row[0] in found:
                    raise Usage(f"{place}: {row[0]} is there twice.")
                if row[1].strip():
                    found[row[0]] = time_of(row[1].strip(), place)
    except (OSError, UnicodeDecodeError) as error:
        raise Usage(f"{file} cannot be read: {getattr(error, 'strerror', None) or 'it is not UTF-8'}.") from None
    absent = [student for student in students if student not in found]
    if absent:
        more = f" and {len(absent) - 3} more" if len(absent) > 3 else ""
        raise Usage(f"{file} has no time for {', '.join(absent[:3])}{more}; everyone who handed in needs one.")
    return found


def time_of(text: str, place: str) -> datetime:
    try:
        when = datetime.fromisoformat(text)
    except ValueError:
        raise Usage(f"{place}: {text} is no time; right is one like {EXAMPLE}.") from None
    if when.tzinfo is None:
        raise Usage(f"{place}: {text} has no zone; right is one like {EXAMPLE}.")
    return when


def applied(body: dict, assignment: Assignment, handed_in: datetime | None) -> dict:
    """What was graded, with the share of the points that the late rule leaves."""
    share = assignment.share_when(handed_in)
    scores = {name: number(body[name] * share) for name in ("score", "visible_score") if body.get(name) is not None}
    return {**body, **scores, "late_share": share, "handed_in": handed_in.isoformat() if handed_in else None}
