"""The house as it is drawn in the design: who imports whom, who loads what, and which slides are taught."""

import ast
import json
import re
import subprocess
import sys
from collections import Counter
from pathlib import Path

import pytest

from app.catalog import chapters, steps
from app.inspection import inspect
from app.paths import LESSONS, ROOT
from app.validation import plain
from tests import small_lesson

APP = ROOT / "app"
HEAVY = ("numpy", "moderngl", "imgui_bundle", "pyvista", "vtk", "vtkmodules", "trimesh", "pyrender", "PIL", "rich",
         "pint", "scipy", "platformdirs", "filelock", "markdown_it")
# One package, the places that may import it. An exception has its reason on its line, for the linter and for this test
PLACES = {"moderngl": ("gpu/", "viewer/"), "imgui_bundle": ("viewer/",), "pyvista": ("plots/",), "vtk": ("plots/",),
          "vtkmodules": ("plots/",), "trimesh": ("meshes.py",), "matplotlib": ("plots/vector.py",),
          "pypdfium2": ("deck.py",), "pyrender": ("reference.py",), "pint": ("ledger.py",),
          "scipy": ("study/",), "distributed": ("grade/executor.py",)}
EXCEPTION = re.compile(r"^\s*(?:import|from)\s+(\w+).*# noqa: TID251 - \w+", re.M)
LONGEST = {".py": 400, ".glsl": 320, ".vert": 80, ".frag": 80}  # lines; twins carry their formulas in docstrings
# A part and what of app it must not reach for
OTHERS = ("optics", "shader", "quantities", "gpu", "catalog", "viewer", "export", "plots", "session", "state", "meshes")
FORBIDDEN = {
    "problem.py": ("",), "paths.py": ("",), "worded.py": ("",),
    "classroom.py": ("lesson", *OTHERS), "lesson.py": OTHERS,
    "quantities.py": ("optics", "shader", "gpu", "catalog"),
    "optics/": ("lesson", "catalog", "shader", "gpu", "viewer", "export", "plots", "meshes"),
    "shader.py": ("gpu", "lesson", "catalog", "optics"),
    "catalog.py": ("gpu", "viewer", "export", "plots", "meshes", "session", "state"),
    "typed.py": ("gpu", "viewer", "export", "plots", "session", "state"),
    "state.py": ("gpu", "viewer", "export", "plots", "session"),
    "session.py": ("gpu", "viewer", "export", "plots", "meshes"),
    "progress.py": ("",), "deck.py": ("",), "picture_state.py": ("",),
    "motion.py": ("gpu", "viewer", "export", "plots", "session"),
    "cues.py": ("gpu", "viewer", "export", "plots", "session"),
    "show_of_hands.py": ("gpu", "viewer", "export", "plots", "session"),
    "talk.py": ("gpu", "viewer", "export", "plots"),
    "gpu/": ("viewer", "export", "grade", "plots", "catalog", "session", "state"),
    "plots/": ("viewer", "export", "grade", "gpu", "session"),
    "viewer/": ("export", "grade"), "export/": ("viewer", "grade", "session"), "grade/": ("viewer", "export"),
    "homework/": ("viewer",), "exercises.py": ("viewer", "export", "gpu", "plots", "session"),
    "grade/child/": ("",),
}
SLIDES = [title for title in (ROOT / "tests" / "reference" / "deck_slides.txt").read_text("utf-8").splitlines()
          if not title.startswith("#")]
NOTHING_TO_TEACH = {"Appearance: Local Shading", "Contributors"}
# The first slide of each part of the deck, and how many of its slides no step teaches yet: the numbers only go down
PARTS = {
    "Basic Concepts": 0, "Basic Radiometric Quantities (1)": 0, "Light Sources": 0, "Units for Lighting - Watts": 0,
    "BRDF – The Reflectance Equation (1)": 0, "The Torrance – Sparrow Microfacet Model (1)": 0,
    "Cook – Torrance – Fresnel Term (1)": 0, "Cook – Torrance – Geometric Term (1)": 0,
    "Cook Torrance – Comparison (1)": 0,
}


def files(part: str) -> list[Path]:
    return sorted((APP / part).rglob("*.py")) if part.endswith("/") else [p for p in (APP / part,) if p.exists()]


def imports(path: Path) -> set[str]:
    """Every module a file imports, at its top or inside a function."""
    found = set()
    for node in ast.walk(ast.parse(path.read_text("utf-8"))):
        if isinstance(node, ast.Import):
            found |= {name.name for name in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module:
            found |= {node.module} | {f"{node.module}.{name.name}" for name in node.names}
    return found


@pytest.mark.parametrize("part", FORBIDDEN)
def test_imports_run_one_way(part):
    for path in files(part):
        for module in imports(path):
            for other in FORBIDDEN[part]:
                reached = f"app.{other}".rstrip(".")
                if other == "" and (module == "app" or module.startswith(("app.problem", "app.worded"))):
                    continue  # anyone may speak of a problem, in words
                assert module != reached and not module.startswith(f"{reached}."), f"{path}: {module}"


@pytest.mark.parametrize("package", PLACES)
def test_a_package_has_one_place(package):
    allowed = {path for place in PLACES[package] for path in files(place)}
    for path in set(APP.rglob("*.py")) - allowed:
        if package not in EXCEPTION.findall(path.read_text("utf-8")):
            assert not {name for name in imports(path) if name.split(".")[0] == package}, path


def test_lessons_are_data():
    for path in LESSONS.glob("*.py"):
        reached = {name for name in imports(path) if name.startswith("app")}
        assert {".".join(name.split(".")[:2]) for name in reached} <= {"app.lesson", "app.optics"}, path


def test_files_stay_readable():
    for path in [*APP.rglob("*.py"), *(ROOT / "glsl").rglob("*.*")]:
        lines = len(path.read_text("utf-8").splitlines())
        assert lines <= LONGEST.get(path.suffix, 400), f"{path} has {lines} lines and wants to be two"
    for path in LESSONS.glob("ch*.py"):
        text = path.read_text("utf-8")
        assert len(text.splitlines()) <= 150 * text.count("= Step(\n"), f"{path}: more than 150 lines a step"


def loaded(code: str) -> set[str]:
    """The heavy packages a child process has loaded after some code."""
    end = f"\nimport sys, json\nprint(json.dumps([m for m in {HEAVY} if m in sys.modules]), file=sys.stderr)"
    child = subprocess.run([sys.executable, "-c", code + end], cwd=ROOT, capture_output=True, text=True, check=False)
    assert child.returncode == 0, child.stderr
    return set(json.loads(child.stderr.splitlines()[-1]))


def command(*words: str) -> str:
    return f"from app.__main__ import main\nassert main({list(words)}) == 0"


@pytest.mark.parametrize(("code", "allowed"), [
    (command("list"), set()),
    (command("list", "--json"), set()),
    (command("--version"), set()),
    (command("homework", "list"), {"numpy"}),
    (command("inspect", "solid_angle/patch"), {"numpy"}),
    (command("inspect", "solid_angle/mesh", "--json"), {"numpy"}),
    (command("eval", "solid_angle_cone", "half_angle=30deg", "--backend", "python"), {"numpy"}),
    ("from app.session import Session\ns = Session()\ns.next()\ns.reveal()", {"numpy"}),
    ("from app.state import parse\nparse('solid_angle/patch?tilt=3')", {"numpy"}),
    ("import app.doctor, app.progress, app.search", set()),
    ("import app.meshes\napp.meshes.built_in('knot')", {"numpy"}),
    ("import app.gpu.stage", {"numpy", "moderngl"}),
    (command("render", "solid_angle/cone", "-o", "FILE.png", "--size", "128x96"), {"numpy", "moderngl", "PIL"}),
    ("import app.study.command", {"numpy"}),
    ("import app.grade.command", {"numpy"}),
    ("import app.homework.check", {"numpy"}),
    ("import app.stress.command", {"numpy", "moderngl"}),
    ("import app.compare.command", {"numpy", "moderngl"}),
    (command("stress", "f_schlick", "--json"), {"numpy", "moderngl", "rich"}),
    (command("export", "solid_angle/cone", "--no-poster", "-o", "FOLDER"),
     {"numpy", "moderngl", "PIL", "markdown_it", "rich"}),
], ids=["list", "list --json", "--version", "homework list", "inspect", "inspect a mesh", "eval", "session", "state",
        "doctor, progress, search", "a built-in mesh", "the stage", "a still", "study", "grade",
        "check", "stress", "compare", "stress of a function", "a page"])
def test_a_job_loads_only_what_it_needs(tmp_path, code, allowed):
    code = code.replace("FILE.png", str(tmp_path / "a.png")).replace("FOLDER", str(tmp_path / "pages"))
    assert loaded(code) <= allowed


# --- scenes bring along only what they use ---------------------------------------------------------------------------
@pytest.mark.parametrize("found", steps(), ids=lambda found: found.id)
def test_a_step_leaves_nothing_lying_about(found):
    report = inspect(found)
    assert report.faults == ()
    assert set(report.attributes) <= {"stage_corner", "stage_position"}
    assert not set(report.functions) & set(report.functions_left_out)
    assert all(one.draws > 0 for one in report.passes)
    assert ("trimesh" in report.packages) == any(surface.mesh for surface in found.step.scene.surfaces)


@pytest.mark.parametrize(("old", "new", "sentence"), [
    ("uniform float half_angle;", "uniform float half_angle;\nuniform float tilt;",
     "lessons/ch01_small.py, step open: the uniform tilt is declared and not used."),
    ("uniform float half_angle;", "uniform float half_angle;\nfloat idle() { return 1.0; }",
     "lessons/ch01_small.py, step open: the function idle is written and not called."),
    ("uniform float half_angle;", 'uniform float half_angle;\n#include "optics/solid_angle.glsl"',
     "lessons/ch01_small.py, step open: nothing of glsl/optics/solid_angle.glsl is used."),
])
def test_what_lies_about_is_a_fault(tmp_path, old, new, sentence):
    found = steps(small_lesson.write(tmp_path, (old, new)))[0]
    assert inspect(found).faults == (sentence,)


def test_what_is_left_out_is_told(tmp_path):
    folder = small_lesson.write(tmp_path)
    flat, mesh = (inspect(found) for found in steps(folder))
    assert [one.name for one in flat.passes] == ["mark", "probe"] and [one.name for one in mesh.passes] == ["mesh"]
    assert flat.uniforms["half_angle"] == "float" and flat.vertices == {"ray": 4}
    assert "trimesh: the scene has no mesh." in flat.left_out
    assert mesh.vertices == {"mesh": 36} and "stage_position" in mesh.attributes


# --- slides ----------------------------------------------------------------------------------------------------------
def taught() -> Counter[str]:
    return Counter(plain(slide) for found in steps() for slide in found.step.slides)


def test_the_slides_are_the_decks():
    assert len(SLIDES) == 85 and SLIDES[0] == "Appearance: Local Shading" and SLIDES[-1] == "Contributors"
    assert {title for title, n in Counter(SLIDES).items() if n == 2} == {
        "Cook – Torrance – Distribution Term (2)", "Cook – Torrance – Geometric Term (3)"}


def test_every_slide_a_step_claims_is_in_the_deck():
    assert set(taught()) <= {plain(title) for title in SLIDES} - {plain(title) for title in NOTHING_TO_TEACH}


def test_the_slides_still_open_are_counted():
    """When a chapter teaches more of them, its number in PARTS goes down with it; at the end all are 0."""
    done, part, still = taught(), "", dict.fromkeys(PARTS, 0)
    for title in SLIDES:
        part = title if title in PARTS else part
        if title not in NOTHING_TO_TEACH and plain(title) not in done:
            still[part] += 1
    assert still == PARTS


def test_the_course_has_its_chapters():
    assert [found.id for found in chapters()][:1] == ["solid_angle"]
