"""Exercises: a stub must fail, a solution must pass, and a typical mistake must be found, in both languages."""

import numpy as np
import pytest
from app.grade.checks import run

from app import catalog
from app.problem import Usage

EXERCISES = {f"{loaded.id}/{exercise.name}": exercise for loaded in catalog.chapters()
             for exercise in loaded.chapter.exercises}
both = pytest.mark.parametrize(("name", "language"), [(n, lang) for n in EXERCISES for lang in ("python", "glsl")])
TRIANGLE = EXERCISES["solid_angle/triangle"]


@both
def test_the_stub_fails(name, language):
    findings = run(EXERCISES[name], language, EXERCISES[name].stubs[language])
    assert not any(finding.ok for finding in findings)
    assert all(finding.error > 1 and not finding.said for finding in findings), "it runs, and is wrong"


@both
def test_the_solution_passes(name, language, ctx):
    findings = run(EXERCISES[name], language, EXERCISES[name].solutions[language])
    assert [f for f in findings if not f.ok] == []
    assert all(finding.error <= 1 and finding.worst for finding in findings)


@pytest.mark.parametrize("name", EXERCISES)
def test_an_exercise_is_whole(name):
    exercise = EXERCISES[name]
    assert set(exercise.stubs) == set(exercise.solutions) == {"python", "glsl"}
    assert len(exercise.checks) >= 3 and any(check.hidden for check in exercise.checks)
    assert len({check.words for check in exercise.checks}) == len(exercise.checks)


ONE_ARGUMENT = "float one_argument(float y, float x) { return atan(y / x); }\n"
MUTANTS = {  # a mistake: what it replaces and by what, in each language
    "the factor 2 is missing": {"python": ("return 2 * np", "return np"),
                                "glsl": ("return 2.0 * arctan2", "return arctan2")},
    "atan of one argument": {"python": ("np.arctan2(volume, below)", "np.arctan(volume / below)"),
                             "glsl": ("arctan2(volume, ", "one_argument(volume, ")},
    "degrees": {"python": ("return 2 * np.arctan2(volume, below)", "return np.degrees(2 * np.arctan2(volume, below))"),
                "glsl": ("return 2.0", "return degrees(1.0) * 2.0")},
    "the wrong length": {"python": ("+ dot(b, c) * length_a", "+ dot(b, c) * length_b"),
                         "glsl": ("dot(b, c) * x", "dot(b, c) * y")},
    "fewer digits": {"python": ("np.arctan2(volume, below)", "np.arctan2(np.float32(volume), below)"),
                     "glsl": ("2.0 * arctan2", "1.9999 * arctan2")},
    "a sign": {"python": ("volume = np.abs", "volume = -np.abs"),
               "glsl": ("float volume = abs", "float volume = -abs")},
}


@pytest.mark.parametrize("language", ["python", "glsl"])
@pytest.mark.parametrize("mistake", MUTANTS)
def test_a_mistake_is_found(mistake, language, ctx):
    old, new = MUTANTS[mistake][language]
    text = TRIANGLE.solutions[language]
    assert text.count(old) == 1
    text = ONE_ARGUMENT + text if "one_argument" in new else text
    findings = run(TRIANGLE, language, text.replace(old, new))
    assert not all(finding.ok for finding in findings)
    assert not any(finding.said for finding in findings), "wrong, but it runs"


def test_the_printed_form_fails_where_it_is_float32_that_breaks_it(ctx):
    """a . (b x c) is right on paper: float64 forgives it at ordinary sizes, float32 loses a millimetre."""
    text = TRIANGLE.solutions["glsl"].replace("cross(b - a, c - a)", "cross(b, c)")
    findings = {finding.words: finding for finding in run(TRIANGLE, "glsl", text)}
    small = [finding for words, finding in findings.items() if "millimetre" in words]
    assert len(small) == 2 and not any(finding.ok for finding in small)
    assert findings["an octant of the sphere: π/2"].ok and findings["triangles of ordinary size"].ok


def test_one_argument_goes_wrong_at_half_of_everything(ctx):
    old, new = MUTANTS["atan of one argument"]["python"]
    wrong = [f.words for f in run(TRIANGLE, "python", TRIANGLE.solutions["python"].replace(old, new)) if not f.ok]
    assert len(wrong) == 1 and wrong[0].startswith("nearly half of everything")


def test_a_finding_names_the_worst_point():
    text = TRIANGLE.solutions["python"].replace("return 2 * ", "return 2.5 * ")
    octant = run(TRIANGLE, "python", text)[0]
    assert octant.worst == "a = [1.0, 0.0, 0.0], b = [0.0, 1.0, 0.0], c = [0.0, 0.0, 1.0]"
    assert octant.expected == pytest.approx(np.pi / 2) and octant.got == pytest.approx(1.25 * np.pi / 2)
    assert octant.error > 1e6 and not octant.ok


BROKEN = {
    "python does not parse": ("python", "def solid_angle_triangle(a, b, c)\n    return 1",
                              "triangle.py, line 1: SyntaxError"),
    "python stops": ("python", "import numpy\n\ndef solid_angle_triangle(a, b, c):\n    return a.foo\n",
                     "triangle.py, line 4: AttributeError"),
    "python has another name": ("python", "def triangle(a, b, c): return 0", "no function solid_angle_triangle"),
    "python imports what is not there": ("python", "\nimport nothing_like_it",
                                         "triangle.py, line 2: ModuleNotFoundError"),
    "python gives one number": ("python", "def solid_angle_triangle(a, b, c): return 0.0", r"gave the shape ()"),
    "glsl does not compile": ("glsl", "float solid_angle_triangle(vec3 a, vec3 b, vec3 c) {\n    return 2.0 * d;\n}",
                              "line 2"),
    "glsl has another name": ("glsl", "float triangle(vec3 a) { return 1.0; }", "no GLSL function solid_angle"),
    "glsl gives a vector": ("glsl", "vec3 solid_angle_triangle(vec3 a, vec3 b, vec3 c) { return a; }",
                            "gave the shape"),
    "glsl reads files": ("glsl", f'#include "/etc/hostname"\n{TRIANGLE.stubs["glsl"]}', "there is no glsl/"),
}


@pytest.mark.parametrize("case", BROKEN)
def test_a_text_that_does_not_run_is_told(case, ctx):
    language, text, words = BROKEN[case]
    findings = run(TRIANGLE, language, text)
    assert len(findings) == len(TRIANGLE.checks)
    assert all(not finding.ok and words in finding.said for finding in findings), findings[0].said


def test_nan_is_wrong():
    text = "import numpy as np\ndef solid_angle_triangle(a, b, c): return np.full(len(a), np.nan)"
    assert not any(finding.ok for finding in run(TRIANGLE, "python", text))


def test_an_unknown_language():
    with pytest.raises(Usage, match="no language rust"):
        run(TRIANGLE, "rust", "")


NAIVE_D = {
    "python": """import numpy as np


def d_beckmann(n, h, m):
    c2 = np.sum(np.asarray(n) * np.asarray(h), -1) ** 2
    return np.exp(-(1 - c2) / c2 / np.asarray(m) ** 2) / (np.pi * np.asarray(m) ** 2 * c2 * c2)
""",
    "glsl": """float d_beckmann(vec3 n, vec3 h, float m) {
    float c = dot(n, h), c2 = c * c;
    return exp(-(1.0 - c2) / c2 / (m * m)) / (3.14159265 * m * m * c2 * c2);
}
""",
}


@pytest.mark.parametrize("language", ["python", "glsl"])
def test_the_decks_fast_form_fails_where_it_must(language, ctx):
    found = {f.words: f.ok for f in run(EXERCISES["microfacets/beckmann"], language, NAIVE_D[language])}
    assert found["the peak is 1 / (π m²)"] and found["ordinary angles and roughness"]
    assert not found["polished"] and not found["polished and tilted"]
