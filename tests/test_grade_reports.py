"""Reports: their forms by their rules, no markup of a student's in them, and nothing of the hidden points."""

import csv
import io
import json
import os
import shutil
from html.parser import HTMLParser
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from markdown_it import MarkdownIt

from app import __main__ as cli
from app.document import STILL
from app.grade import assignment as assignments
from app.grade import texts
from app.grade.questions import questions
from app.grade.report import everything
from app.grade.report.curve import svg
from app.grade.report.stored import Results, folder_of
from app.grade.report.table import COLUMNS
from app.grade.report.words import points, spoken
from tests.browser import CHROMIUM, chromium, opened

ASSIGNMENT = """title = "Small <b>&amp;"
chapter = "fresnel"
languages = ["python"]
seconds = 2
due = 2026-12-01T12:00:00+00:00
late = { per_day = 0.25, days = 2 }
[[task]]
exercise = "fresnel/schlick"
points = 4
absolute = 1
[[task.region]]
name = "everywhere"
l_dot_h = [0.01, 0.99]
f0 = [0.02, 0.95]
[[task]]
function = "brdf_blinn_phong"
text = "Write the <i>lobe</i>."
points = 4
powers = ["exponent"]
[[task.region]]
name = "lit"
visible = 16
hidden = 48
n = [0, 40]
l = [0, 40]
v = [0, 40]
k_d = [0.1, 0.4]
k_s = [0.1, 0.4]
exponent = [2, 30]
[[task.property]]
name = "reciprocity"
[task.picture]
size = 24
k_d = 0.3
k_s = 0.3
exponent = 20
"""
SCHLICK = "def f_schlick(l_dot_h, f0):\n    return f0 + (1 - f0) * (1 - l_dot_h)**5\n"
SEED = "the secret of the class"
NASTY = "<script>alert(2)</script><img src=x onerror=alert(3)> ](javascript:alert(4)) `````` |\x1b[31m\x00]]>&=cmd()"
SCRIPT, FORMULA = "<script>alert(1)", "=cmd|' C'!A0"


@pytest.fixture(scope="module")
def graded(tmp_path_factory) -> Path:
    """A class of six, graded."""
    root = tmp_path_factory.mktemp("class")
    assignment = root / "small.toml"
    assignment.write_text(ASSIGNMENT)
    right = texts.solution(assignments.load("brdfs").task("brdf_blinn_phong"), "python") + "\n\n" + SCHLICK
    handed_in = {
        "ann": right, "ben": right, "nan": right + "\n_f = f_schlick\ndef f_schlick(l_dot_h, f0):\n"
                                           "    return np.where(l_dot_h < 0.5, np.nan, _f(l_dot_h, f0))\n",
        "dim": right.replace("(1 - f0) * ", "") + "\n_b = brdf_blinn_phong\n"
               "def brdf_blinn_phong(*all):\n    return 1.5 * _b(*all)\n",
        SCRIPT: right + f"\nraise ValueError({NASTY!r})\n", FORMULA: right + "\nx = = 1\n"}
    for student, text in handed_in.items():
        (root / "class" / student).mkdir(parents=True)
        (root / "class" / student / "submission.py").write_text(text)
    words = ["grade", str(assignment), str(root / "class"), "-o", str(root / "r"), "--seed", SEED]
    assert cli.main(words) == 0
    return root


@pytest.fixture
def results(graded, tmp_path) -> Path:
    shutil.copytree(graded / "r", tmp_path / "r")
    return tmp_path / "r"


def place(results: Path, student: str) -> Path:
    return results / "students" / folder_of(student)


def strict(path: Path) -> dict:
    def never(word):
        raise ValueError(word)

    return json.loads(path.read_bytes(), parse_constant=never)


def change(results: Path, student: str, **what) -> None:
    path = place(results, student) / "result.json"
    path.write_text(json.dumps(json.loads(path.read_text()) | what))


# --- nothing of a student's is markup --------------------------------------------------------------------------------
class Tags(HTMLParser):
    def __init__(self, page: str):
        super().__init__()
        self.seen: list[tuple[str, dict]] = []
        self.words = ""
        self.feed(page)

    def handle_starttag(self, tag, attrs):
        self.seen.append((tag, dict(attrs)))

    def handle_data(self, data):
        self.words += data + " "


def harmless(page: str) -> str:
    """The page's text, if nothing in it runs or leads elsewhere."""
    tags = Tags(page)
    for tag, attrs in tags.seen:
        assert tag not in ("script", "iframe", "object", "embed", "form", "base", "link"), tag
        assert not [name for name in attrs if name.startswith("on")], attrs
        for name in ("href", "src"):
            target = attrs.get(name, "")
            assert target.startswith(("#", "students/", "data:image/png;base64,")) or not target, target
    return tags.words


def test_pages_are_harmless(graded):
    pages = sorted((graded / "r").rglob("*.html"))
    assert len(pages) == 7
    for path in pages:
        page = path.read_text("utf-8")
        words = harmless(page)
        assert STILL in page and "Small <b>&amp;" in words
    assert SCRIPT in harmless((graded / "r" / "index.html").read_text("utf-8"))
    words = harmless((place(graded / "r", SCRIPT) / "report.html").read_text("utf-8"))
    assert "<script>alert(2)</script><img src=x onerror=alert(3)>" in words and "\x1b" not in words


def test_whatever_is_in_a_result_is_text(results):
    """Names, messages, reasons, regions: every string of a result.json, at once."""
    def spoil(value, key=""):
        if isinstance(value, dict):
            return {name: spoil(inner, name) for name, inner in value.items()}
        if isinstance(value, list):
            return [spoil(inner, key) for inner in value]
        kept = ("verdict", "visibility", "group", "png", "function", "level", "student_id")
        return NASTY + "\ud800" if isinstance(value, str) and key not in kept else value

    path = place(results, "dim") / "result.json"
    path.write_text(json.dumps(spoil(json.loads(path.read_text())) | {"overrides": [{"points": 1, "reason": NASTY}]}))
    everything.write(Results(results))
    assert "<script>alert(2)" in harmless((path.parent / "report.html").read_text("utf-8"))
    harmless((results / "index.html").read_text("utf-8"))
    rendered = MarkdownIt("commonmark", {"html": True}).enable("table").render((path.parent / "report.md").read_text(
        "utf-8"))
    assert "alert(2)" in harmless(rendered)
    root = ElementTree.fromstring((path.parent / "junit.xml").read_bytes())
    assert any("<script>alert(2)" in (one.get("message") or "") for one in root.iter("failure"))
    assert "\x1b" not in (path.parent / "junit.xml").read_text("utf-8")
    strict(path.parent / "gradescope.json")
    for name in ("gradescope.json", "../../lti_scores.json"):
        assert b"\\ud800" not in (path.parent / name).read_bytes()


def test_no_cell_is_a_formula(graded):
    table = list(csv.reader(io.StringIO((graded / "r" / "tests.csv").read_bytes().decode(), newline="")))
    assert tuple(table[0][:len(COLUMNS)]) == COLUMNS and len({len(row) for row in table}) == 1
    assert table[0][len(COLUMNS):][-2:] == ["brdf_blinn_phong/reciprocity, hidden", "brdf_blinn_phong/picture, hidden"]
    assert not [cell for row in table for cell in row if cell[:1] in "=+-@\t\r" and cell]
    rows = {row[0]: dict(zip(table[0], row, strict=True)) for row in table[1:]}
    assert f"'{FORMULA}" in rows and rows["ann"]["score"] == "8" and rows["ann"]["flags"] == "identical to ben"
    for row in rows.values():
        assert sum(float(x) for x in list(row.values())[len(COLUMNS):]) == pytest.approx(float(row["score"]), abs=1e-4)


# --- what is hidden --------------------------------------------------------------------------------------------------
def test_hidden_points_are_nowhere(graded):
    """Neither their inputs nor the right values, in no file, in any way that numbers are written."""
    found = assignments.load(graded / "small.toml")
    secret: set[str] = set()
    for question in questions(found, SEED, hidden=True):
        if "picture" in question.id:
            continue
        value = np.asarray(found.task(question.function).reference(**question.args), float)
        for name, x in [*question.args.items(), ("", value)]:
            for number in np.unique(x):
                if len(repr(float(number))) > 12:
                    secret |= {repr(float(number)), f"{number:.9g}"}
                    secret |= {f"{name} = {spoken(name, float(number))}"} if name else set()
    for question in questions(found):
        for name, x in question.args.items():
            secret -= {text for number in np.unique(x) for text in (
                repr(float(number)), f"{number:.9g}", f"{name} = {spoken(name, float(number))}")}
    assert len(secret) > 500
    files = [path for path in (graded / "r").rglob("*") if path.is_file() and path.name != "seed"]
    assert len(files) > 30
    for path in files:
        data = path.read_text("utf-8")
        assert SEED not in data, path
        assert not [text for text in secret if text in data], path
    shown = strict(place(graded / "r", "dim") / "result.json")
    assert any(test["worst"] for test in shown["tests"]) and all(
        test["worst"] is None and not test["figures"] for test in shown["tests"] if test["visibility"] == "hidden")


# --- the forms --------------------------------------------------------------------------------------------------------
TOP = {"score": float, "output": str, "output_format": str, "test_output_format": str, "test_name_format": str,
       "visibility": str, "stdout_visibility": str, "tests": list, "extra_data": dict}
TEST = {"name": str, "name_format": str, "number": str, "score": float, "max_score": float, "status": str,
        "output": str, "output_format": str, "tags": list, "visibility": str, "extra_data": dict}


def test_gradescope(graded):
    for student in ("ann", "dim", "nan", SCRIPT):
        found = strict(place(graded / "r", student) / "gradescope.json")
        assert {key: type(value) for key, value in found.items()} == TOP
        assert found["visibility"] == "visible" and found["stdout_visibility"] == "hidden"
        for test in found["tests"]:
            assert {key: type(value) for key, value in test.items()} == TEST
            assert test["status"] in ("passed", "failed") and 0 <= test["score"] <= test["max_score"]
            assert test["visibility"] in ("visible", "after_published") and all(type(t) is str for t in test["tags"])
        assert {test["visibility"] for test in found["tests"]} == {"visible", "after_published"}
        assert found["score"] == pytest.approx(sum(test["score"] for test in found["tests"]), abs=1e-4)
        seen = [test for test in found["tests"] if test["visibility"] == "visible"]
        total = [points(round(sum(test[key] for test in seen), 6)) for key in ("score", "max_score")]
        assert found["output"].startswith(f"Visible points: {total[0]} of {total[1]}.")


def test_junit(graded):
    for student in ("ann", "dim", SCRIPT, FORMULA):
        root = ElementTree.fromstring((place(graded / "r", student) / "junit.xml").read_bytes())
        suite = root.find("testsuite")
        assert root.tag == "testsuites" and suite is not None
        cases = suite.findall("testcase")
        counts = {"tests": len(cases), "failures": len(suite.findall("testcase/failure")),
                  "errors": len(suite.findall("testcase/error")), "skipped": len(suite.findall("testcase/skipped"))}
        assert {name: int(suite.get(name, -1)) for name in counts} == counts and counts["tests"] > 5
        assert all(case.get("name") and case.get("classname") and len(case) <= 1 for case in cases)
        assert (counts["failures"] > 0) == (student == "dim")
        assert (counts["errors"] > 0) == (student in (SCRIPT, FORMULA))


def test_scores_for_a_learning_platform(graded):
    scores = strict(graded / "r" / "lti_scores.json")["scores"]
    assert [score["userId"] for score in scores] == sorted(["ann", "ben", "dim", "nan", SCRIPT, FORMULA])
    for score in scores:
        assert type(score["scoreGiven"]) is float and score["scoreMaximum"] == 8.0 and score["scoreGiven"] >= 0
        assert (score["activityProgress"], score["gradingProgress"]) == ("Completed", "FullyGraded")
        assert len(score["timestamp"]) == len("2026-12-01T12:00:00.000+00:00") and score["timestamp"].endswith("+00:00")


def test_result_json(graded):
    found = strict(place(graded / "r", "nan") / "result.json")
    assert {"schema", "submission", "assignment", "grader", "seed", "score", "max", "visible_score", "visible_max",
            "verdict", "tests", "overrides"} <= set(found)
    worst = next(test["worst"] for test in found["tests"] if test["worst"])
    assert worst["got"] == "nan" and "nan" in found["curves"][0]["got"]
    page = harmless((place(graded / "r", "nan") / "report.html").read_text("utf-8"))
    assert "values are no numbers" in page and "NaN" not in page


# --- what the student is told -----------------------------------------------------------------------------------------
def test_a_student_is_told_what_to_fix_first(graded):
    page = (place(graded / "r", "dim") / "report.html").read_text("utf-8")
    words = " ".join(harmless(page).split())
    first = [words.index(part) for part in ("Fix this first · worth 4 points more", "f_schlick",
                                            "The factor (1 - f0) is missing", "Then brdf_blinn_phong")]
    assert first == sorted(first) and "all by the factor 1.5" in words
    assert words.count("The worst visible point") == 2 and page.count('<svg class="curve"') == 2
    labels = [attrs["alt"] for tag, attrs in Tags(page).seen if tag == "img"]
    assert labels == ["expected", "yours", "signed error", "FLIP"]
    assert "All is right" in harmless((place(graded / "r", "ann") / "report.html").read_text("utf-8"))
    assert "ben" not in (place(graded / "r", "ann") / "report.html").read_text("utf-8").replace("ann: ", "")


def test_the_class(graded):
    words = " ".join(harmless((graded / "r" / "index.html").read_text("utf-8")).split())
    assert "6 submissions · 2 with all 8 points" in words and "Identical submissions ann , ben" in words
    assert "schlick no complement" in words and "UNSANDBOXED" not in words and "Not graded" not in words


def test_a_lowered_level_is_stamped(results):
    facts = json.loads((results / "class.json").read_text())
    facts["grader"] |= {"unsandboxed": True, "level": "L1"}
    (results / "class.json").write_text(json.dumps(facts))
    for path in (results / "students").glob("*/result.json"):
        path.write_text(json.dumps(json.loads(path.read_text()) | {"grader": facts["grader"]}))
    everything.write(Results(results))
    for name in ("report.html", "report.md", "gradescope.json"):
        assert all("UNSANDBOXED" in path.read_text("utf-8") for path in (results / "students").glob(f"*/{name}"))
    assert "UNSANDBOXED" in (results / "index.html").read_text("utf-8")
    assert 'name="unsandboxed" value="True"' in (place(results, "ann") / "junit.xml").read_text("utf-8")


def test_ungraded_is_no_mark_anywhere(results):
    change(results, "ann", verdict="ungraded", score=None, visible_score=None, visible_max=None, tests=[],
           misconceptions=[], curves=[], why="no space left on device")
    everything.write(Results(results))
    here = place(results, "ann")
    assert not (here / "gradescope.json").exists()
    words = harmless((here / "report.html").read_text("utf-8"))
    assert "Not graded yet" in words and "This is no zero" in words and "Fix this first" not in words
    suite = ElementTree.fromstring((here / "junit.xml").read_bytes())
    assert suite.get("errors") == "1" and suite.get("tests") == "1"
    score = next(one for one in strict(results / "lti_scores.json")["scores"] if one["userId"] == "ann")
    assert "scoreGiven" not in score and score["gradingProgress"] == "Failed"
    row = next(line for line in (results / "tests.csv").read_text().splitlines() if line.startswith("ann,"))
    assert ",,8,ungraded,1," in row and row.endswith(",,,,")
    assert "no space left on device" in harmless((results / "index.html").read_text("utf-8"))


def test_a_mark_by_hand_is_the_mark(results):
    change(results, "dim", overrides=[{"points": 7.5, "reason": "talked about it"}])
    everything.write(Results(results))
    assert strict(place(results, "dim") / "gradescope.json")["score"] == 7.5
    score = next(one for one in strict(results / "lti_scores.json")["scores"] if one["userId"] == "dim")
    assert score["scoreGiven"] == 7.5 and score["comment"] == "talked about it"
    assert "talked about it" in (place(results, "dim") / "report.md").read_text("utf-8")


# --- again ------------------------------------------------------------------------------------------------------------
def everywhere(results: Path) -> dict[str, bytes]:
    return {path.relative_to(results).as_posix(): path.read_bytes() for path in results.rglob("*") if path.is_file()}


def test_the_same_results_give_the_same_bytes(results, capsys):
    before = everywhere(results)
    for path in [*results.rglob("*.html"), *results.rglob("*.md"), *results.rglob("*.xml"), results / "tests.csv"]:
        path.unlink()
    assert cli.main(["grade", "--report", str(results)]) == 0
    assert everywhere(results) == before
    assert "index.html" in capsys.readouterr().out


def test_where_no_results_are(tmp_path, capsys):
    assert cli.main(["grade", "--report", str(tmp_path)]) == 2
    assert "class.json; name a folder" in capsys.readouterr().err
    assert cli.main(["grade", "fresnel"]) == 2
    assert "halfway grade ASSIGNMENT SUBMISSIONS -o RESULTS" in capsys.readouterr().err


def test_late_is_who_the_list_says(graded, results, tmp_path, capsys):
    """No text runs again: marks follow from what was graded and the list."""
    times = tmp_path / "times.csv"
    on_time = "".join(f"{name},2026-12-01T11:59:00+00:00\n" for name in ("ben", "nan", "dim", SCRIPT, FORMULA))
    words = ["grade", str(graded / "small.toml"), str(graded / "class"), "-o", str(results), "--resume",
             "--handed-in", str(times)]
    journal = (results / "store" / "journal.jsonl").read_bytes()
    before = strict(results / "lti_scores.json")["scores"][0]["timestamp"]
    times.write_text(f"student,time\nann,2026-12-02T13:00:00+01:00\n{on_time}absent,\n")
    assert cli.main(words) == 0
    assert "ann,6,8,pass" in (results / "marks.csv").read_text().splitlines()  # 24 hours, one day begun
    assert "ben,8,8,pass" in (results / "marks.csv").read_text().splitlines()
    assert (results / "store" / "journal.jsonl").read_bytes() == journal
    score = next(one for one in strict(results / "lti_scores.json")["scores"] if one["userId"] == "ann")
    assert score["scoreGiven"] == 6 and score["timestamp"] > before
    assert score["submission"] == {"submittedAt": "2026-12-02T13:00:00+01:00"}
    assert "75% of the points count" in (place(results, "ann") / "report.html").read_text("utf-8")
    for text, said in (("ann,2026-12-02T13:00:00\n" + on_time, "line 2: 2026-12-02T13:00:00 has no zone"),
                       ("ann,soon\n" + on_time, "line 2: soon is no time"), (on_time, "has no time for ann;"),
                       (on_time + on_time, "line 7: ben is there twice")):
        times.write_text("student,time\n" + text)
        assert cli.main(words) == 2 and said in capsys.readouterr().err
    assert cli.main(["grade", "fresnel", *words[2:]]) == 2 and "fresnel.toml has no due date" in capsys.readouterr().err


# --- on a screen ------------------------------------------------------------------------------------------------------
def test_a_curve_of_anything_is_drawn():
    curve = {"label": "<m>", "log": True, "here": 0.1, "at": [0.01, 0.1, 1.0], "expected": [1e-9, 1.0, 1e9],
             "got": ["nan", "-inf", -3.0]}
    drawn = svg(curve)
    assert "nan" not in drawn and "&lt;m&gt; (log)" in drawn and "<m>" not in drawn
    ElementTree.fromstring(drawn)
    assert svg(curve | {"expected": ["nan", "inf", "nan"]}) == ""


@pytest.mark.skipif(not CHROMIUM and not os.environ.get("CI"), reason="needs Chromium")
def test_pages_fit_their_screens(graded):
    pages = [graded / "r" / "index.html", *(place(graded / "r", name) / "report.html" for name in ("dim", SCRIPT))]
    with chromium() as browser:
        for path in pages:
            for size in ((1280, 720), (360, 740)):
                with opened(browser, path, size) as (tab, heard):
                    assert tab.evaluate("document.documentElement.scrollWidth") <= size[0], path
                    assert heard.said == [] and len(heard.asked) == 1
