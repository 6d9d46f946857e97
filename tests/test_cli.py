"""The command line: jobs, exit codes, and one sentence for whatever goes wrong."""

import json
import os
import subprocess
import sys
from types import SimpleNamespace

import pytest

from app import __main__ as cli
from app.catalog import steps
from app.paths import ROOT
from app.problem import Problem


@pytest.fixture
def job(monkeypatch):
    """A stand-in for a job's module: what it was called with, and what it does."""
    def stand_in(module: str, does=lambda options: 0) -> list:
        calls: list = []

        def run(options):
            calls.append(options)
            return does(options)

        monkeypatch.setitem(sys.modules, module, SimpleNamespace(run=run, add_arguments=lambda parser: None))
        return calls
    return stand_in


def raises(error: BaseException):
    def run(options):
        raise error
    return run


def said(capsys, *arguments: str) -> tuple[int, str, str]:
    code = cli.main(list(arguments))
    out, err = capsys.readouterr()
    return code, out, err


def test_list_names_every_step_and_its_slides(capsys):
    code, out, err = said(capsys, "list")
    assert (code, err) == (0, "")
    for found in steps():
        assert any(found.id in line and found.step.title in line and found.step.slides[0] in line
                   for line in out.splitlines())


def test_list_as_json(capsys):
    code, out, _ = said(capsys, "list", "--json")
    chapters = json.loads(out)
    assert code == 0 and [step["step"] for c in chapters for step in c["steps"]] == [found.id for found in steps()]
    assert chapters[0]["chapter"] == "solid_angle" and chapters[0]["steps"][0]["slides"] == ["Basic Concepts"]


def test_inspect(capsys):
    code, out, _ = said(capsys, "inspect", "solid_angle/patch?samples=100")
    assert code == 0 and "solid_angle/patch: " in out and "dots 100" in out
    code, out, _ = said(capsys, "inspect", "solid_angle/patch", "--json")
    assert code == 0 and json.loads(out)["uniforms"]["tilt"] == "float"


def test_version_and_help(capsys):
    assert said(capsys, "--version")[:2] == (0, "halfway 0.1.0\n")
    for arguments in (["--help"], ["render", "-h"], ["list", "-h"]):
        with pytest.raises(SystemExit) as end:
            cli.main(arguments)
        assert end.value.code == 0
    assert "doctor" in capsys.readouterr().out


@pytest.mark.parametrize(("arguments", "sentence"), [
    (["lst"], "there is no command lst. Did you mean list"),
    (["rendr", "a/b"], "there is no command rendr. Did you mean render"),
    (["solid_angle/patch"], "there is no command solid_angle/patch. Did you mean halfway show solid_angle/patch?"),
    (["list", "--jsn"], "halfway list takes no --jsn. Did you mean --json?"),
    (["list", "patch"], "halfway list takes no patch. See halfway list --help."),
    (["--them", "dark"], "halfway takes no --them. Did you mean --theme"),
    (["--theme"], "argument --theme: expected one argument. See halfway --help."),
    (["--theme", "drak"], "there is no theme drak. Did you mean dark?"),
    (["inspect"], "halfway inspect wants a step, or --all for all of them."),
    (["inspect", "solid_angle/pach"], "there is no step solid_angle/pach. Did you mean solid_angle/patch"),
    (["show", "solid_angle/patch?tilt=91"], "tilt=91: solid_angle/patch takes tilt from -90 to 90°."),
    (["render", "solid_angle/patch"], "the following arguments are required: -o/--output."),
])
def test_what_is_mistyped_is_told_in_one_line(capsys, arguments, sentence):
    code, out, err = said(capsys, *arguments)
    assert (code, out) == (2, "") and err.startswith(f"halfway: {sentence}") and err.count("\n") == 1


def test_the_window_opens_where_there_is_a_display(capsys, monkeypatch, job):
    monkeypatch.setattr(cli, "has_display", lambda: True)
    calls = job("app.viewer")
    assert said(capsys) == (0, "", "")
    assert said(capsys, "show", "solid_angle/patch?tilt=30", "--theme", "light", "--mesh", "a.stl") == (0, "", "")
    assert [(o.state, o.theme, o.mesh) for o in calls] == [
        ("", "", None), ("solid_angle/patch?tilt=30", "light", "a.stl")]


def test_without_a_display_the_lessons_become_pictures(capsys, monkeypatch, job):
    monkeypatch.setattr(cli, "has_display", lambda: False)
    calls = job("app.export.gallery", lambda options: 3)
    code, out, err = said(capsys)
    assert (code, err, len(calls)) == (3, "", 1) and out.count("\n") == 1 and "no display" in out


def test_a_folder_makes_them_pictures_whether_or_not_there_is_a_display(capsys, monkeypatch, job):
    monkeypatch.setattr(cli, "has_display", lambda: True)
    calls = job("app.export.gallery", lambda options: 0)
    assert said(capsys, "--output", "here", "--theme", "light") == (0, "", "")
    assert [(o.output, o.theme) for o in calls] == [("here", "light")]


@pytest.mark.skipif(sys.platform != "linux", reason="elsewhere there is a desktop")
@pytest.mark.parametrize("display", ["", ":7777"])
def test_a_display_is_one_that_opens(display):
    """In a process of its own: a window test may have started GLFW here. This GLFW speaks X11, no Wayland."""
    env = {**os.environ, "WAYLAND_DISPLAY": "wayland-0", "DISPLAY": display}
    code = "from app.display import has_display; raise SystemExit(int(has_display()))"
    ended = subprocess.run([sys.executable, "-c", code], env=env, cwd=ROOT, check=False)
    assert ended.returncode == 0, "no server answers"


def test_render_hands_its_options_over(capsys, job):
    calls = job("app.export.still")
    words = ["a/b?x=1", "-o", "x.png", "--set", "tilt=30", "width=1", "--set", "phi=2", "--size", "64x64",
             "--view", "both", "--theme", "light", "--mesh", "m.obj"]
    assert said(capsys, "render", *words) == (0, "", "")
    o = calls[0]
    assert (o.step, o.output, o.set, o.size) == ("a/b?x=1", "x.png", ["tilt=30", "width=1", "phi=2"], "64x64")
    assert (o.view, o.theme, o.mesh) == ("both", "light", "m.obj")


@pytest.mark.parametrize(("error", "code", "sentence"), [
    (Problem("lessons/ch01.py, line 3: no."), 1, "halfway: lessons/ch01.py, line 3: no.\n"),
    (RuntimeError("two\nlines"), 1, "halfway: RuntimeError: two lines; run it with --debug to see where.\n"),
    (FileNotFoundError(2, "No such file", "x.stl"), 1,
     "halfway: x.stl: No such file; run it with --debug to see where.\n"),
    (KeyboardInterrupt(), 130, ""),
])
def test_an_error_is_one_sentence(capsys, job, error, code, sentence):
    job("app.doctor", raises(error))
    assert said(capsys, "doctor") == (code, "", sentence)


@pytest.mark.parametrize("arguments", [["--debug", "doctor"], ["doctor", "--debug"]])
def test_debug_shows_where(capsys, job, arguments):
    job("app.doctor", raises(Problem("no.")))
    code, _, err = said(capsys, *arguments)
    assert code == 1 and "Traceback" in err and err.endswith("halfway: no.\n")


def test_a_closed_pipe_is_no_error():
    read, write = os.pipe()
    os.close(read)
    child = subprocess.run([sys.executable, "-m", "app", "list"], cwd=ROOT, stdout=write, stderr=subprocess.PIPE,
                           check=False)
    os.close(write)
    assert (child.returncode, child.stderr) == (141, b"")


def test_a_broken_lesson_is_listed_and_told(capsys, monkeypatch, tmp_path):
    from app import catalog
    from tests import small_lesson

    small_lesson.write(tmp_path, name="ch02_fine.py")
    folder = small_lesson.write(tmp_path, ("CHAPTER =", "CAPTER ="))
    broken = catalog.chapters(folder)
    monkeypatch.setattr(catalog, "chapters", lambda: broken)
    code, out, err = said(capsys, "list")
    assert code == 1 and "fine/open" in out
    assert err == "halfway: lessons/ch01_small.py, line 1: a lesson ends with CHAPTER = Chapter(...).\n"


def test_the_readme_names_each_command_once():
    rows = [line for line in (ROOT / "README.md").read_text("utf-8").splitlines() if line.startswith("| `halfway ")]
    assert sorted(row.split("`")[1].split()[1] for row in rows) == sorted(cli.JOBS)
