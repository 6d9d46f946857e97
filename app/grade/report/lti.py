"""Scores as a learning platform takes them (LTI 1.3, Assignment and Grade Services), as a file to send on.

The specification wants a time, and that it grows: it is when these marks first stood in marks.csv, kept beside the
store and nowhere else.
"""

import hashlib
import json
from datetime import UTC, datetime
from pathlib import Path

from app.grade.report.stored import Sheet
from app.grade.report.words import NOT_YOURS, hint
from app.grade.store import FOLDER, as_bytes, durable


def score(sheet: Sheet, timestamp: str) -> dict:
    """An ungraded one has no scoreGiven: a platform would show it as a mark."""
    found: dict = {"userId": sheet.student, "scoreMaximum": float(sheet.most), "comment": comment(sheet),
                   "timestamp": timestamp, "activityProgress": "Completed"}
    if sheet.result["handed_in"]:
        found["submission"] = {"submittedAt": sheet.result["handed_in"]}
    if sheet.mark is None:
        waiting = sheet.result.get("why") == "not graded yet"
        return found | {"gradingProgress": "Pending" if waiting else "Failed"}
    return found | {"scoreGiven": max(0.0, float(sheet.mark)), "gradingProgress": "FullyGraded"}


def comment(sheet: Sheet) -> str:
    if sheet.override:
        return sheet.override["reason"]
    if not sheet.graded:
        return NOT_YOURS
    first, result = sheet.first, sheet.result
    late = f"Late: {result['late_share']:.0%} of the points count. " if result["late_share"] < 1 else ""
    seen = f"Visible points {sheet.visible}."
    return late + seen + (f" Fix first {first.function}: {hint(first)}" if first else "")


def marked_at(results: Path) -> str:
    """When the marks became what they are: the only time in all reports."""
    path = results / FOLDER / "marked.json"
    marks = hashlib.sha256((results / "marks.csv").read_bytes()).hexdigest()
    try:
        kept = json.loads(path.read_bytes())
    except (OSError, ValueError):
        kept = {}
    if kept.get("marks") != marks:
        kept = {"marks": marks, "at": datetime.now(UTC).isoformat(timespec="milliseconds")}
        durable(path, as_bytes(kept))
    return kept["at"]
