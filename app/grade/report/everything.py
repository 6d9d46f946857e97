"""Writes every report of a class from the results that are stored, one student after the other; the same results give
the same bytes.
"""

from pathlib import Path

from app.console import progress
from app.files import write as written
from app.grade.report import gradescope, junit, lti, markdown, student
from app.grade.report.overview import Overview
from app.grade.report.stored import Results, Sheet
from app.grade.report.table import Table
from app.grade.store import as_bytes


def write(results: Results) -> None:
    table, overview, scores = Table(), Overview(results.facts), []
    marked = lti.marked_at(results.folder)
    with progress(len(results.students)) as tell:
        for i, name in enumerate(results.students):
            tell(i, "Reports")
            sheet = results.sheet(name)
            of_one(results.place(name), sheet)
            scores.append(lti.score(sheet, marked))
            table.add(sheet)
            overview.add(sheet)
    written(results.folder / "tests.csv", table.bytes())
    written(results.folder / "lti_scores.json", as_bytes({"scores": scores}))
    written(results.folder / "index.html", overview.bytes())


def of_one(place: Path, sheet: Sheet) -> None:
    written(place / "report.html", student.report(sheet))
    written(place / "report.md", markdown.report(sheet))
    written(place / "junit.xml", junit.junit(sheet))
    if sheet.graded:
        written(place / "gradescope.json", as_bytes(gradescope.results(sheet)))
    else:  # of an earlier run
        (place / "gradescope.json").unlink(missing_ok=True)
