"""Whole runs of `halfway grade`: the same marks on one worker and two, after a kill, on a cluster; ours is no zero."""

import csv
import io
import json
import os
import signal
import struct
import subprocess
import sys
import time
import zipfile
from functools import partial
from pathlib import Path

import pytest

from app import __main__ as cli
from app.grade import conversation, level, sandbox, store, work
from app.grade.assignment import load
from app.grade.command import cell, folder_of
from app.grade.executor import DaskExecutor, LocalExecutor
from app.grade.level import Level
from app.grade.questions import questions
from app.paths import ROOT

SMALL = """title = "Small"
chapter = "fresnel"
languages = ["python"]
seconds = 2
[[task]]
exercise = "fresnel/schlick"
points = 4
absolute = 1
[[task.region]]
name = "everywhere"
l_dot_h = [0.01, 0.99]
f0 = [0.02, 0.95]
"""
RIGHT = "def f_schlick(l_dot_h, f0):\n    x = 1 - l_dot_h\n    return f0 + (1 - f0) * x**5\n"
CLASS = {
    "ann": RIGHT, "ben": RIGHT + "# ben\n", "=cmd|' C'!A0": RIGHT + "# eve\n", "dee": RIGHT.replace("**5", "**4"),
    "fay": "import os\nos._exit(0)\n", "gus": "def f_schlick(l_dot_h, f0):\n    return 0 * f0\n", "hal": RIGHT,
}


@pytest.fixture
def assignment(tmp_path) -> Path:
    path = tmp_path / "small.toml"
    path.write_text(SMALL)
    return path


@pytest.fixture
def handed_in(tmp_path) -> Path:
    folder = tmp_path / "class"
    for student, text in CLASS.items():
        (folder / student).mkdir(parents=True)
        (folder / student / "submission.py").write_text(text)
    with zipfile.ZipFile(folder / "ian.zip", "w") as archive:
        archive.writestr("../../submission.py", RIGHT)
    return folder


def grade(*words) -> int:
    return cli.main(["grade", *map(str, words)])


def rows(results: Path) -> dict[str, list[str]]:
    table = list(csv.reader(io.StringIO((results / "marks.csv").read_bytes().decode(), newline="")))
    assert table[0] == ["student", "points", "max_points", "status"]
    return {row[0]: row[1:] for row in table[1:]}


def everything(results: Path) -> dict[str, bytes]:
    """Every file but the store, and the scores for a platform, which tell when the marks were set."""
    found = [path for path in sorted(results.rglob("*")) if path.is_file() and path.name != "lti_scores.json"
             and "store" not in path.relative_to(results).parts]
    return {path.relative_to(results).as_posix(): path.read_bytes() for path in found}


def test_a_class_is_graded_the_same_on_one_worker_and_on_two(tmp_path, assignment, handed_in, capsys):
    for jobs in (1, 2):
        assert grade(assignment, handed_in, "-o", tmp_path / f"r{jobs}", "--jobs", jobs, "--seed", "s") == 0
    assert everything(tmp_path / "r1") == everything(tmp_path / "r2")
    marks = rows(tmp_path / "r1")
    assert list(marks) == sorted(marks, key=lambda name: name.lstrip("'"))
    assert marks["ann"] == marks["ben"] == marks["hal"] == marks["'=cmd|' C'!A0"] == ["4", "4", "pass"]
    assert marks["ian"] == ["0", "4", "rejected"] and marks["fay"] == ["0", "4", "crash"]
    assert float(marks["gus"][0]) < 0.2 and marks["dee"][2] in ("partial", "wrong") and float(marks["dee"][0]) < 2
    result = json.loads((tmp_path / "r1" / "students" / "ann" / "result.json").read_text())
    assert result["same_as"] == ["hal"] and result["submission"]["student_id"] == "ann"
    assert result["grader"]["level"] == level.found().name and not result["grader"]["unsandboxed"]
    assert "\ns\n" not in str(result) and result["seed"]["hidden_hash"]
    assert "8 submissions: 4 passed, 4 failed, 0 ungraded. Isolation L" in capsys.readouterr().out


SPIES = {  # how an answer would spell out what it was asked
    "words": "import numpy as np\n\n\ndef f_schlick(l_dot_h, f0):\n    raise ValueError(repr(l_dot_h[:9].tolist()))\n",
    "syntax": "def f_schlick(l_dot_h, f0):\n    raise SyntaxError('x', ('', 1, 1, repr(list(l_dot_h[:9]))))\n",
    "import": "import os\nraise ValueError(os.pread(0, 250, os.fstat(0).st_size - 250).hex())\n",
    "constant": "def f_schlick(l_dot_h, f0):\n    return 0 * f0 + l_dot_h[0]\n",
    "factor": "def f_schlick(l_dot_h, f0):\n    return (f0 + (1 - f0) * (1 - l_dot_h)**5) * (3 + l_dot_h.max())\n",
}


def test_hidden_points_are_in_no_message(tmp_path, assignment):
    for student, text in SPIES.items():
        (tmp_path / "spies" / student).mkdir(parents=True)
        (tmp_path / "spies" / student / "submission.py").write_text(text)
    assert grade(assignment, tmp_path / "spies", "-o", tmp_path / "r", "--seed", "s") == 0
    found = load(assignment)
    shapes = [{word for one in asked for x in one.args["l_dot_h"] for word in (
        f"{x:.4g}"[:6], struct.pack("<d", x).hex())} for asked in (
        questions(found), questions(found, "s", hidden=True))]
    for student in SPIES:
        result = json.loads((tmp_path / "r" / "students" / student / "result.json").read_text())
        hidden = [test for test in result["tests"] if test["visibility"] == "hidden"]
        told = json.dumps(result["tests"])
        assert hidden and not any(one in told for one in shapes[1] - shapes[0]), (student, told)
        assert not any(test["worst"] or "factor 3" in test["message"] for test in hidden), (student, hidden)


def test_a_table_of_the_visible_points_earns_nothing(tmp_path, assignment):
    one = next(one for one in questions(load(assignment)))
    table = {float(x): float(y) for x, y in zip(one.args["l_dot_h"], load(assignment).tasks[0].reference(**one.args),
                                                strict=True)}
    (tmp_path / "table.py").write_text(f"import numpy as np\nT = {table}\n\n\ndef f_schlick(l_dot_h, f0):\n"
                                       "    return np.array([T.get(x, 0.5) for x in l_dot_h])\n")
    assert grade(assignment, tmp_path / "table.py", "-o", tmp_path / "r", "--seed", "s") == 0
    assert float(rows(tmp_path / "r")["table"][0]) < 0.05 * 4


def test_a_killed_run_goes_on_and_ends_with_the_same_bytes(tmp_path, assignment, handed_in):
    assert grade(assignment, handed_in, "-o", tmp_path / "whole", "--seed", "s") == 0
    cut = tmp_path / "cut"
    words = [sys.executable, "-m", "app", "grade", str(assignment), str(handed_in), "-o", str(cut), "--jobs", "1",
             "--seed", "s"]
    for lines in (2, 4):  # killed twice, each time with some done and one in flight
        run = subprocess.Popen(words, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        words = [*words, *(["--resume"] if "--resume" not in words else [])]
        journal = cut / "store" / "journal.jsonl"
        while not (journal.exists() and journal.read_text().count("\n") >= lines):
            assert run.poll() is None, run.stderr.read()
            time.sleep(0.01)
        run.send_signal(signal.SIGKILL)
        run.communicate()
    done = {json.loads(line)["key"] for line in journal.read_text().splitlines()}
    assert 2 <= len(done) < len(CLASS)
    assert grade(assignment, handed_in, "-o", cut, "--resume") == 0  # the seed is the one it began with
    assert everything(cut) == everything(tmp_path / "whole")
    lines = [json.loads(line)["key"] for line in journal.read_text().splitlines()]
    assert len(lines) == len(set(lines)) == len(set(CLASS.values())) + 1  # nothing that was finished was done again


def test_a_stopped_run_keeps_what_is_done(tmp_path, assignment, handed_in):
    words = [sys.executable, "-m", "app", "grade", str(assignment), str(handed_in), "-o", str(tmp_path / "r"),
             "--jobs", "1", "--seed", "s"]
    run = subprocess.Popen(words, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                           preexec_fn=partial(signal.signal, signal.SIGINT, signal.SIG_DFL))  # noqa: PLW1509 - a shell's & ignores it
    journal = tmp_path / "r" / "store" / "journal.jsonl"
    while not (journal.exists() and journal.read_text().count("\n")):
        assert run.poll() is None, run.stderr.read()
        time.sleep(0.01)
    run.send_signal(signal.SIGINT)
    _, said = run.communicate(timeout=60)
    assert run.returncode == 130 and "--resume goes on" in said and "Traceback" not in said
    marks = rows(tmp_path / "r")
    assert len(marks) == len(CLASS) + 1 and 1 <= sum(row[2] != "ungraded" for row in marks.values()) < len(marks)
    assert all((row[0] == "") == (row[2] == "ungraded") for row in marks.values())


def test_marks_by_hand_stand_in_a_file_the_grader_never_writes(tmp_path, assignment, handed_in, capsys):
    words = (assignment, handed_in / "ann", "-o", tmp_path / "r", "--seed", "s")
    assert grade(*words) == 0
    by_hand = tmp_path / "r" / "overrides.csv"
    by_hand.write_text("student,points,reason\nann,3.5,talked about it\n")
    assert grade(*words, "--resume") == 0
    assert rows(tmp_path / "r") == {"ann": ["3.5", "4", "override"]}
    result = json.loads((tmp_path / "r" / "students" / "ann" / "result.json").read_text())
    assert result["score"] == 4 and result["overrides"] == [{"points": 3.5, "reason": "talked about it"}]
    assert by_hand.read_text().endswith("talked about it\n")
    by_hand.write_text("student,points,reason\nann,many,\n")
    assert grade(*words, "--resume") == 1
    assert "overrides.csv, line 2: ann,many, is no student" in capsys.readouterr().err


def test_results_are_not_mixed(tmp_path, assignment, handed_in, capsys):
    (tmp_path / "r" / "store").mkdir(parents=True)
    assert grade(assignment, handed_in, "-o", tmp_path / "r") == 2
    assert "go on with --resume" in capsys.readouterr().err
    store.Store(tmp_path / "r", resume=True, seed="a").close()
    assert grade(assignment, handed_in, "-o", tmp_path / "r", "--resume", "--seed", "b") == 2
    assert "is not the seed" in capsys.readouterr().err


def test_our_own_failure_is_never_a_zero(tmp_path, assignment, handed_in, monkeypatch, capsys):
    level.found()
    working = sandbox.start

    def starts(worker, *args, **more):
        if worker == "worker_python":
            raise OSError(28, "no space left on device")
        return working(worker, *args, **more)

    monkeypatch.setattr(conversation.sandbox, "start", starts)
    assert grade(assignment, handed_in, "-o", tmp_path / "r", "--seed", "s") == 1
    marks = rows(tmp_path / "r")
    assert marks["ann"] == ["", "4", "ungraded"] and marks["ian"][2] == "rejected"
    journal = [json.loads(line) for line in (tmp_path / "r" / "store" / "journal.jsonl").read_text().splitlines()]
    assert sum(one["verdict"] == "ungraded" for one in journal) == 3 * 6  # each tried three times
    monkeypatch.setattr(conversation.sandbox, "start", working)
    assert grade(assignment, handed_in, "-o", tmp_path / "r", "--resume") == 0
    assert rows(tmp_path / "r")["ann"] == ["4", "4", "pass"]


def test_speed_is_measured_against_the_solution(tmp_path, assignment, handed_in):
    assignment.write_text(SMALL.replace("points = 4", "points = 4\nruntime = 0.5"))
    slow = handed_in / "slow"
    slow.mkdir()
    (slow / "submission.py").write_text("import time\n" + RIGHT.replace(
        "    x =", "    begun = time.process_time()\n    while time.process_time() < begun + 0.3: pass\n    x ="))
    assert grade(assignment, slow, "-o", tmp_path / "slow", "--seed", "s") == 0
    assert grade(assignment, handed_in / "ann", "-o", tmp_path / "ann", "--seed", "s") == 0
    assert rows(tmp_path / "ann")["ann"] == ["4", "4", "pass"]
    assert rows(tmp_path / "slow")["slow"] == ["2", "4", "partial"]


def test_below_l2_it_must_be_said_by_name(tmp_path, assignment, handed_in, monkeypatch, capsys):
    monkeypatch.setattr(level, "found", lambda: Level("L1", why="L2: there is no Landlock"))
    assert grade(assignment, handed_in, "-o", tmp_path / "r") == 1
    assert "L1 only here" in (said := capsys.readouterr().err) and "--level L1" in said
    assert not (tmp_path / "r").exists()
    work.here.cache_clear()
    assert grade(assignment, handed_in / "ann", "-o", tmp_path / "r", "--level", "L0") == 0
    assert "UNSANDBOXED" in capsys.readouterr().out
    result = json.loads((tmp_path / "r" / "students" / "ann" / "result.json").read_text())
    assert result["grader"]["unsandboxed"] and result["grader"]["level"] == "L0" and result["verdict"] == "pass"
    work.here.cache_clear()


@pytest.mark.parametrize("layer", sandbox.LAYERS["L3"])
def test_without_a_layer_the_level_is_not_granted(layer):
    """Needs a machine with all of them: CI's."""
    if level.found().name != "L3" and not os.environ.get("CI"):
        pytest.skip(f"this machine holds {level.found().name}: {level.found().why}")
    layers = tuple(one for one in sandbox.LAYERS["L3"] if one != layer)
    got, why = level.tested("L3", layers)
    assert got is None and "a submission could" in why


@pytest.mark.parametrize(("layer", "could"), [
    ("seccomp", "start a process (fork)"), ("landlock", "read the course's files"), ("limits", "take much memory")])
def test_a_level_names_what_could_be_done(layer, could):
    _, why = level.tested("L2", tuple(one for one in sandbox.LAYERS["L2"] if one != layer))
    assert could in why


def test_results_that_cannot_be_written_are_a_sentence(tmp_path, assignment, handed_in, capsys):
    (tmp_path / "r").write_text("a file")
    assert grade(assignment, handed_in, "-o", tmp_path / "r") == 1
    assert capsys.readouterr().err.startswith("halfway: ")


def test_a_key_has_one_file_that_is_whole(tmp_path):
    one = store.Store(tmp_path, resume=False)
    key = store.key_of(a="1")
    one.put(key, {"verdict": "pass", "score": 1.0}, {"seconds": 1})
    first = one.path(key).read_bytes()
    one.put(key, {"score": 1.0, "verdict": "pass"}, {"seconds": 2})  # a task run twice
    assert one.path(key).read_bytes() == first and one.get(key) == {"score": 1.0, "verdict": "pass"}
    with pytest.raises(ValueError):
        one.put(key, {"verdict": "pass", "score": float("nan")}, {})
    (one.path(key).parent / ".left").write_text("half")
    one.close()
    again = store.Store(tmp_path, resume=True)
    assert again.seed == one.seed and [path.name for path in one.path(key).parent.iterdir()] == [f"{key}.json"]
    again.close()


@pytest.mark.parametrize("name", ["=1+1", "+1", "-1", "@A1", "\tx", "\rx"])
def test_no_cell_is_a_formula(name):
    assert cell(name) == f"'{name}"


def test_folders_of_students_are_safe_and_their_own():
    names = ["ann", "a/b", "a_b", "..", "con.", "x" * 300, "Jörg Müller"]
    assert len({folder_of(name) for name in names}) == len(names)
    assert folder_of("Jörg Müller") == "Jörg Müller"
    assert "/" not in folder_of("a/b") and folder_of("..") not in ("..", "")


# --- a cluster on this machine ---------------------------------------------------------------------------------------
@pytest.fixture(scope="module")
def cluster():
    from distributed import LocalCluster

    with LocalCluster(n_workers=1, threads_per_worker=2, resources={"GRADER": 2}, host="127.0.0.1",
                      dashboard_address=None, silence_logs=50) as one:
        yield one.scheduler_address


@pytest.mark.filterwarnings("ignore")
def test_a_cluster_gives_the_same_bytes(tmp_path, assignment, handed_in, cluster):
    assert grade(assignment, handed_in, "-o", tmp_path / "here", "--seed", "s") == 0
    assert grade(assignment, handed_in, "-o", tmp_path / "there", "--seed", "s", "--scheduler", cluster) == 0
    assert everything(tmp_path / "here") == everything(tmp_path / "there")


@pytest.mark.filterwarnings("ignore")
def test_many_tasks_in_any_order(cluster):
    jobs = {f"{i:04d}" for i in range(300)}
    for executor in (LocalExecutor(2), DaskExecutor(cluster)):
        for key in jobs:
            executor.submit(work.stand_in, {"key": key})
        assert {answer["key"] for _, answer in executor.as_completed()} == jobs
        executor.close()


@pytest.mark.filterwarnings("ignore")
def test_a_cluster_that_is_not_there(tmp_path, assignment, handed_in, capsys):
    assert grade(assignment, handed_in, "-o", tmp_path / "r", "--scheduler", "tcp://127.0.0.1:9") == 1
    assert "no Dask scheduler at tcp://127.0.0.1:9" in capsys.readouterr().err


def test_a_lost_worker_and_a_silent_cluster_are_ungraded():
    def lost(job):
        raise RuntimeError("gone")

    executor = LocalExecutor(1)
    executor.submit(lost, {"key": "a"})
    assert list(executor.as_completed()) == [({"key": "a"}, None)]
    executor.patience = 0.05
    executor.submit(lambda job: time.sleep(0.5), {"key": "b"})
    assert list(executor.as_completed()) == [({"key": "b"}, None)]
    executor.close()


def test_a_stopped_run_lets_what_runs_end():
    executor = LocalExecutor(1)
    for i in range(5):
        executor.submit(lambda job: time.sleep(0.1) or {"key": job["key"]}, {"key": i})
    time.sleep(0.05)
    executor.cancel()
    assert [answer["key"] for _, answer in executor.as_completed()] == [0]
    executor.close()


