"""The recipes' own steps, run here: what they install is only noted, what they grade is graded."""

import json
import os
import shlex
import shutil
import stat
import subprocess
import sys
from pathlib import Path

import pytest

from app.paths import ROOT
from tests.test_grade_runs import RIGHT, SMALL

RECIPES = ROOT / "app" / "grade" / "recipes"
HALFWAY = f'#!/bin/sh\nPYTHONPATH={shlex.quote(str(ROOT))} exec {shlex.quote(sys.executable)} -m app "$@"\n'
GONE = "#!/bin/sh\necho 'halfway: the machine failed' >&2\nexit 1\n"


def executable(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
    path.chmod(0o755)


@pytest.fixture
def autograder(tmp_path) -> Path:
    """/autograder as Gradescope lays it out, with the zip of the course team unpacked."""
    source = tmp_path / "autograder" / "source"
    shutil.copytree(RECIPES / "gradescope", source)
    executable(source / "halfway" / ".venv" / "bin" / "halfway", HALFWAY)
    (source / "small.toml").write_text(SMALL)
    (source / "assignment").write_text("small.toml\n")
    (source / "seed").write_text("s\n")
    (tmp_path / "autograder" / "submission").mkdir()
    return tmp_path / "autograder"


def step(autograder: Path, name: str, path: str = "") -> subprocess.CompletedProcess:
    here = os.environ | {"AUTOGRADER": str(autograder), "PATH": path + os.environ["PATH"]}
    return subprocess.run([str(autograder / "source" / name)], env=here, capture_output=True, text=True, timeout=120,
                          check=False)


def test_gradescope_grades(autograder):
    (autograder / "submission" / "submission.py").write_text(RIGHT)
    (autograder / "submission" / "notes.txt").write_text("handed in too")
    ran = step(autograder, "run_autograder")
    assert ran.returncode == 0, ran.stderr
    found = json.loads((autograder / "results" / "results.json").read_text())
    assert found["score"] == 4.0 and len(found["tests"]) > 4
    (autograder / "submission" / "submission.py").write_text(RIGHT.replace("**5", "**4"))
    assert step(autograder, "run_autograder").returncode == 0
    assert json.loads((autograder / "results" / "results.json").read_text())["score"] < 2


def test_gradescope_gets_no_mark_of_a_failure_of_ours(autograder):
    (autograder / "submission" / "submission.py").write_text(RIGHT)
    (autograder / "results").mkdir()
    (autograder / "results" / "results.json").write_text('{"score": 4}')  # of the submission before
    executable(autograder / "source" / "halfway" / ".venv" / "bin" / "halfway", GONE)
    ran = step(autograder, "run_autograder")
    assert ran.returncode == 1 and "the machine failed" in ran.stderr
    assert not (autograder / "results" / "results.json").exists()


def test_gradescope_sets_up(autograder, tmp_path):
    noted = tmp_path / "noted"
    note = f'#!/bin/sh\necho "$(basename "$0") $*" >> {noted}\n'
    tools = autograder / "source" / "tools" / "bin"
    executable(tmp_path / "bin" / "apt-get", note)
    executable(tmp_path / "bin" / "python3", note)
    for tool in ("pip", "uv"):
        executable(tools / tool, note)
    ran = step(autograder, "setup.sh", f"{tmp_path / 'bin'}:")
    assert ran.returncode == 0, ran.stderr
    lines = noted.read_text().splitlines()
    assert [line.split()[0] for line in lines] == ["apt-get", "apt-get", "python3", "pip", "uv"]
    assert {"libegl1", "libgl1", "libgl1-mesa-dri"} <= set(lines[1].split())
    assert lines[-1] == f"uv sync -q --project {autograder}/source/halfway --no-dev --extra flip"
    assert stat.S_IMODE((autograder / "source" / "seed").stat().st_mode) == 0o600


def test_the_container_grades(tmp_path):
    """Its last line, with the words of its first lines, on folders of this machine."""
    text = (RECIPES / "container" / "Dockerfile").read_text()
    steps = [line.split(maxsplit=1) for line in text.splitlines() if line and not line.startswith("#")]
    assert [name for name, _ in steps] == ["FROM", "RUN", "COPY", "RUN", "WORKDIR", "ENTRYPOINT"]
    for name, words in steps:
        if name == "RUN":
            assert subprocess.run(["bash", "-n", "-c", words], check=False).returncode == 0
    entry = json.loads(steps[-1][1])
    assert entry[0] == "/halfway/.venv/bin/halfway" and "COPY . /halfway" in text
    (tmp_path / "class" / "ann").mkdir(parents=True)
    (tmp_path / "class" / "ann" / "submission.py").write_text(RIGHT)
    (tmp_path / "small.toml").write_text(SMALL)
    run = next(line for line in text.splitlines() if "docker run" in line).split()
    words = run[run.index("halfway") + 1:]
    assert words == ["fresnel", "/class", "-o", "/results"]
    here = {"fresnel": str(tmp_path / "small.toml"), "/class": str(tmp_path / "class"), "/results": str(tmp_path / "r")}
    executable(tmp_path / "halfway", HALFWAY)
    words = [str(tmp_path / "halfway"), *entry[1:], *(here.get(word, word) for word in words)]
    ran = subprocess.run(words, cwd=tmp_path, capture_output=True, text=True, timeout=120, check=False)
    assert ran.returncode == 0, ran.stderr
    assert (tmp_path / "r" / "marks.csv").read_text().splitlines()[1] == "ann,4,4,pass"
