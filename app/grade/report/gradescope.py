"""Gradescope's results.json of one student (gradescope/autograder_samples: its own words for states and visibility).

Where one test is not visible Gradescope hides the total, so the visible points stand in the output. Of an ungraded
submission there is no file: whatever it said would be a mark.
"""

from app.grade.report.stored import Sheet
from app.grade.report.words import hint, point, points, region, sentence, verdict

LATER = "after_published"  # when the course team shows the marks, the regions and counts of the hidden points


def results(sheet: Sheet) -> dict:
    assert sheet.mark is not None
    return {"score": float(sheet.mark), "output": output(sheet), "output_format": "text", "test_output_format": "text",
            "test_name_format": "text", "visibility": "visible", "stdout_visibility": "hidden",
            "tests": [test_of(test, f"{i}") for i, test in enumerate(sheet.result["tests"], 1)],
            "extra_data": {"assignment": sheet.assignment["id"], "assignment_hash": sheet.assignment["hash"],
                           "level": sheet.result["grader"]["level"],
                           "fingerprint": sheet.result["grader"]["fingerprint"]}}


def output(sheet: Sheet) -> str:
    result, first = sheet.result, sheet.first
    lines = [f"Visible points: {sheet.visible}."] if sheet.visible else []
    if result["late_share"] < 1:
        lines.append(f"Handed in late: {result['late_share']:.0%} of the points count.")
    if sheet.override:
        lines.append(f"Marked by hand: {points(sheet.override['points'])}. {sheet.override['reason']}".strip())
    if first is not None:
        lines.append(f"Fix first {first.function}: {hint(first)}")
    lines += [f"{one['function']}: {one['message']}" for one in result["misconceptions"]
              if first is None or one["function"] != first.function]
    if result["grader"]["unsandboxed"]:
        lines.append(f"UNSANDBOXED: isolated at level {result['grader']['level']} only.")
    return "\n".join(lines)


def test_of(test: dict, number: str) -> dict:
    said = [] if test["verdict"] == "pass" else [f"{verdict(test['verdict'])}. {sentence(test)}"]
    if test["worst"]:
        said += ["the worst point:", point(test["worst"])]
    if test["rationale"]:
        said.append(test["rationale"])
    return {"name": f"{test['function']}: {region(test)}", "name_format": "text", "number": number,
            "score": float(test["score"]), "max_score": float(test["max"]),
            "status": "passed" if test["verdict"] == "pass" else "failed", "output": "\n".join(said),
            "output_format": "text", "tags": [test["group"], test["language"]],
            "visibility": "visible" if test["visibility"] == "visible" else LATER,
            "extra_data": {"verdict": test["verdict"], "points": test["points"], "wrong": test["wrong"]}}
