"""halfway homework and halfway check, as a student uses them."""

import json
import re

import numpy as np
import pytest

from app import __main__ as cli
from app import exercises
from app.catalog import chapters, step
from app.exercises import Checker
from app.grade import texts
from app.grade.assignment import assignments, load
from app.grade.live import asked_in, findings, verdicts
from app.grade.sweep import Sweep
from app.homework.plot import drawn


def exercises_of_all():
    return [exercise for loaded in chapters() for exercise in loaded.chapter.exercises]


TRIANGLE = next(one for one in exercises_of_all() if one.name == "triangle")
WRONG = """# halfway homework: fresnel
import numpy as np


def f_schlick(l_dot_h, f0):
    return f0 + (1 - l_dot_h) ** 5


def f0_from_eta(eta):
    return ((eta - 1) / (eta + 1)) ** 2
"""


def said(capsys, *arguments: str) -> tuple[int, str, str]:
    code = cli.main(list(arguments))
    out, err = capsys.readouterr()
    return code, out, err


def test_the_list_names_every_assignment_and_its_functions(capsys):
    code, out, err = said(capsys, "homework", "list")
    assert (code, err) == (0, "")
    for name in assignments():
        assert load(name).title in out and all(task.function in out for task in load(name).tasks)


@pytest.mark.parametrize("language", ["python", "glsl"])
def test_new_writes_a_file_that_the_check_fails(language, capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert said(capsys, "homework", "new", "brdfs", "--lang", language)[0] == 0
    file = tmp_path / "brdfs" / ("submission.py" if language == "python" else "submission.glsl")
    text = file.read_text("utf-8")
    for task in load("brdfs").tasks:
        assert task.function in text and task.slide in text
    assert "exponent of a cosine" in text
    assert language == "python" or not re.search("^#", text, re.M)
    code, out, err = said(capsys, "check", str(file))
    assert (code, err) == (1, "") and out.count("✗") == len(load("brdfs").tasks)
    assert "compile error" not in out and "missing" not in out and "\n0.00 of 5.76 visible points" in out
    code, _, err = said(capsys, "homework", "new", "brdfs", "--lang", language)
    assert code == 1 and "it is yours, and stays as it is" in err


def test_check_says_what_was_asked_what_is_wrong_and_what_it_looks_like(capsys, tmp_path):
    file = tmp_path / "mine.py"
    file.write_text(WRONG, "utf-8")
    code, out, err = said(capsys, "check", str(file))
    assert (code, err) == (1, "")
    assert "✗ f_schlick" in out and "✓ f0_from_eta" in out and "✗ f_dielectric" in out
    assert "Slide: Cook – Torrance – Fresnel Term (8)" in out
    assert "at grazing it is 1: 2 of 2 points are wrong." in out
    assert re.search(r"The worst point \(everywhere\): l_dot_h = 0\.\d+, f0 = 0\.\d+\n    expected  0\.\d+\n", out)
    assert "· right   × yours   ● both" in out
    assert "It looks like schlick_no_complement: The factor (1 - f0) is missing" in out
    assert "missing: there is no function f_dielectric" in " ".join(out.split())


def test_a_vector_is_plotted_by_the_component_that_is_wrong():
    text = "import numpy as np\ndef reflection_vector(n, l):\n    return l - 2 * np.sum(n * l, -1)[:, None] * n\n"
    plot = next(one for one in findings(load("brdfs"), "python", text) if one.task.function == "reflection_vector").plot
    assert " of the answer, by angle of l" in plot.label
    assert np.allclose(plot.got, -plot.expected, atol=1e-12) and np.max(np.abs(plot.expected)) > 0.1


@pytest.mark.parametrize(("line", "advice"), [
    ("return math.cos(l_dot_h)", "use numpy's, np.cos for math.cos"),
    ("return f0 if l_dot_h > 0 else 1", "use np.where"),
    ("return list(f0)", "np.array(...) makes one"),
])
def test_a_beginners_error_comes_with_advice(line, advice):
    text = f"import math\ndef f_schlick(l_dot_h, f0):\n    {line}\n"
    found = findings(load("fresnel"), "python", text, plot=False)[0]
    assert advice in found.said


def test_a_missing_semicolon_is_looked_for_a_line_above():
    text = "float f_schlick(float l_dot_h, float f0) {\n    float x = f0\n    return x;\n}\n"
    said = findings(load("fresnel"), "glsl", text, plot=False)[0].said
    assert "line 3" in said and "is one missing at the end of the line above?" in said


def test_check_in_json(capsys, tmp_path):
    file = tmp_path / "mine.py"
    file.write_text(WRONG, "utf-8")
    code, out, _ = said(capsys, "check", str(file), "--json")
    found = {one["function"]: one for one in json.loads(out)}
    assert code == 1 and found["f0_from_eta"]["ok"] and not found["f_schlick"]["ok"]
    assert found["f_schlick"]["misconceptions"][0]["id"] == "schlick_no_complement"


def test_a_right_answer_passes_and_says_so(capsys, tmp_path):
    file = tmp_path / "solid_angle.glsl"
    one = load("solid_angle")
    parts = [(task.function, texts.solution(task, "glsl")) for task in one.tasks]
    file.write_text(texts.joined(parts, "glsl"), "utf-8")
    code, out, err = said(capsys, "check", str(file), "--assignment", "solid_angle")
    assert (code, err) == (0, "") and out.count("✓") == 3


@pytest.mark.parametrize(("name", "text", "words"), [
    ("a.txt", "", "is neither a .py nor a .glsl file"), ("a.py", None, "there is no file"),
    ("a.py", "x = 1", "does not say which assignment it answers; write --assignment NAME, of: brdfs"),
    ("a.py", "# halfway homework: frensel", "there is no assignment frensel. Did you mean fresnel?"),
    ("a.py", b"\xff\xfe", "it is not UTF-8"),
])
def test_what_cannot_be_checked_is_told(name, text, words, capsys, tmp_path):
    if text is not None:
        (tmp_path / name).write_bytes(text if isinstance(text, bytes) else text.encode())
    code, out, err = said(capsys, "check", str(tmp_path / name))
    assert code in (1, 2) and out == "" and words in err and err.count("\n") == 1


@pytest.mark.parametrize(("text", "words"), [
    ("def solid_angle_triangle(a, b, c)\n    return 1", "line 1"),
    ("import numpy\n\ndef solid_angle_triangle(a, b, c):\n    return a.foo\n", "line 4"),
    ("def triangle(a, b, c): return 0", "solid_angle_triangle"),
    ("\nimport nothing_like_it", "line 2"),
    ("def solid_angle_triangle(a, b, c):\n    while True: pass\n", "time"),
])
def test_a_text_that_does_not_run_is_told(text, words, monkeypatch):
    monkeypatch.setattr("app.grade.live.limits", lambda assignment: __import__(
        "app.grade.sandbox", fromlist=["Limits"]).Limits(cpu=1, wall=3.0))
    finding = verdicts("solid_angle/triangle", "python", text)
    assert not finding.ok and words in finding.said, finding.said


@pytest.mark.parametrize(("text", "words"), [
    ("float solid_angle_triangle(vec3 a, vec3 b, vec3 c) {\n    return 2.0 * d;\n}", "line 2"),
    ("float triangle(vec3 a) { return 1.0; }", "solid_angle_triangle"),
    ("vec3 solid_angle_triangle(vec3 a, vec3 b, vec3 c) { return a; }", "float solid_angle_triangle"),
    ('#include "core/angle.glsl"\nfloat solid_angle_triangle(vec3 a, vec3 b, vec3 c) { return 1.; }', "no line with #"),
])
def test_a_shader_that_does_not_compile_is_told(text, words):
    finding = verdicts("solid_angle/triangle", "glsl", text)
    assert not finding.ok and words in finding.said, finding.said


def test_the_windows_verdicts_are_the_checks():
    """One exercise alone, as a panel asks it: the same tests as in the whole assignment."""
    assignment, task = asked_in("fresnel/schlick")
    alone = verdicts("fresnel/schlick", "python", WRONG, plot=True)
    among = next(one for one in findings(assignment, "python", WRONG) if one.task.function == task.function)
    assert alone.tests == among.tests and alone.suspects == among.suspects and alone.plot is not None


def test_a_plot_shows_both_and_counts_what_is_outside():
    at = np.linspace(0, 1, 97)
    expected = at * at
    got = np.where(at < 0.5, expected, np.nan)
    lines = drawn(Sweep("x", at, False, 0.7, expected, got))
    assert len(lines) == 14 and all(len(line) <= 80 for line in lines)
    assert "●" in "".join(lines[:11]) and "·" in lines[0] and "×" not in "".join(lines[:11])
    assert "(49 of yours lie outside or are no numbers)" in lines[-1]
    assert drawn(Sweep("x", at, False, 0.5, np.full(97, np.nan), got)) == []


# --- beside the scene ------------------------------------------------------------------------------------------------
def test_the_window_checks_what_is_typed_in_the_background():
    checker = Checker()
    found = step("solid_angle/polygon")
    assert next(iter(exercises.of_step(found))) == "solid_angle/triangle"
    checker.ask("solid_angle/triangle", TRIANGLE.stubs["glsl"])
    assert checker.busy
    checker.ask("solid_angle/triangle", TRIANGLE.solutions["glsl"])  # typed on while the first is checked
    shown = checker.wait(60)
    assert not checker.busy and shown.text == TRIANGLE.solutions["glsl"] and shown.ok
    assert all(good for good, _ in shown.checks) and len(shown.checks) >= 6
    checker.ask("solid_angle/triangle", TRIANGLE.solutions["glsl"])
    assert not checker.busy, "the same text is not asked again"


@pytest.mark.parametrize(("text", "words"), [
    ('#include "core/angle.glsl"\n\nfloat solid_angle_triangle(vec3 a, vec3 b, vec3 c) {\n    return d;\n}', "line 4"),
    ('#include "../secret"\n', "there is no glsl/../secret"),
    ("float solid_angle_triangle(vec3 a, vec3 b, vec3 c) {\n    while (true) {}\n    return 0.0;\n}", ""),
])
def test_what_is_typed_wrongly_is_told_at_its_own_line(text, words):
    shown = exercises.verdicts("solid_angle/triangle", text)
    assert not shown.ok and not shown.checks[0][0] and words in shown.checks[0][1], shown.checks


def test_included_text_leaves_the_other_lines_where_they_are():
    for exercise in exercises_of_all():
        text = exercise.solutions["glsl"]
        own, inner = text.split("\n"), texts.inlined(text).split("\n")
        assert len(own) == len(inner) and not any("#" in line.partition("//")[0] for line in inner)
        assert all(a == b for a, b in zip(own, inner, strict=True) if "#include" not in a)
