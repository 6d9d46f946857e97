"""tests.csv: a row a student, a column a test; RFC 4180, and no cell that a spreadsheet would take for a formula."""

import csv
import io

from app.grade.report.stored import Sheet
from app.grade.report.words import region

COLUMNS = ("student_id", "submission_hash", "score", "max", "verdict", "ungraded", "flags", "level")


def cell(text: str) -> str:
    return f"'{text}" if text[:1] in ("=", "+", "-", "@", "\t", "\r") else text


def name(test: dict) -> str:
    """A test's column: 'f_schlick/grazing, hidden'."""
    return f"{test['function']}/{region(test)}"


class Table:
    """Rows are added one by one, so that nobody's pictures stay in memory."""

    def __init__(self) -> None:
        self.rows: list[tuple[list[str], dict[str, str]]] = []
        self.tests: dict[str, None] = {}

    def add(self, sheet: Sheet) -> None:
        result = sheet.result
        score = "" if sheet.mark is None else f"{sheet.mark:.6g}"
        head = [sheet.student, result["submission"]["hash"], score, f"{sheet.most:.6g}", result["verdict"],
                str(int(not sheet.graded)), "; ".join(flags(sheet)), result["grader"]["level"]]
        cells = {name(test): f"{test['score']:.6g}" for test in result["tests"] if test["verdict"] != "ungraded"}
        self.tests |= dict.fromkeys(map(name, result["tests"]))
        self.rows.append((head, cells))

    def bytes(self) -> bytes:
        out = io.StringIO()
        table = csv.writer(out, lineterminator="\r\n")
        table.writerow([cell(text) for text in (*COLUMNS, *self.tests)])
        for head, cells in self.rows:
            table.writerow([*map(cell, head), *(cells.get(test, "") for test in self.tests)])
        return out.getvalue().encode()


def flags(sheet: Sheet) -> list[str]:
    """What the course team may want to look at."""
    result, found = sheet.result, []
    if result["same_as"]:
        found.append(f"identical to {', '.join(result['same_as'])}")
    if sheet.override:
        found.append("marked by hand")
    if result["late_share"] < 1:
        found.append(f"late: {result['late_share']:.0%} of the points")
    if result["grader"]["unsandboxed"]:
        found.append("UNSANDBOXED")
    return found
