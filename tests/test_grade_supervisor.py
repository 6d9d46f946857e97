"""Questions to a text in the sandbox: values to the last bit, a crash that costs one function, and our own failures."""

import os
import signal
import subprocess
import sys
import time

import numpy as np
import psutil
import pytest

from app.grade import answers, conversation, level, plain, sandbox
from app.grade.intake import Submission
from app.grade.question import Question
from app.grade.sandbox import LAYERS, Limits
from app.grade.supervisor import answer
from app.paths import ROOT

LIMITS = Limits(cpu=2, wall=3.0)
RANDOM = np.random.default_rng(7)
POINTS = {"n": RANDOM.normal(size=(9000, 3)).astype(np.float32).astype(float),
          "x": RANDOM.uniform(0.1, 1.0, 9000).astype(np.float32).astype(float)}
PYTHON = """import numpy as np

def tilted(n, x):
    return n * x[:, None] + 1

def squared(n, x):
    return x * x
"""
GLSL = """vec3 tilted(vec3 n, float x) { return n * x; }
float squared(vec3 n, float x) { return x * x; }
"""


def questions(language: str, count: int = 9000) -> list[Question]:
    args = {name: x[:count] for name, x in POINTS.items()}
    return [Question(f"{name}/{language}", name, language, args, width)  # type: ignore[arg-type]
            for name, width in (("tilted", 3), ("squared", 1))]


def python(text: str, *names: str, limits: Limits = LIMITS) -> dict[str, object]:
    asked = [Question(name, name, "python", {"x": POINTS["x"][:50]}) for name in names]
    return {reply.id: reply for reply in answer(Submission("a", {"submission.py": text.encode()}), asked, limits)}


@pytest.mark.parametrize("count", [1, 2, 4095, 4096, 4097, 9000])
def test_values_come_back_in_their_order_to_the_last_bit(count):
    n, x = POINTS["n"][:count], POINTS["x"][:count]
    both = Submission("a", {"submission.py": PYTHON.encode(), "submission.glsl": GLSL.encode()})
    replies = answer(both, [*questions("python", count), *questions("glsl", count)], LIMITS)
    assert [reply.id for reply in replies] == ["tilted/python", "squared/python", "tilted/glsl", "squared/glsl"]
    assert np.array_equal(replies[0].values, n * x[:, None] + 1) and np.array_equal(replies[1].values, x * x)
    single = n.astype(np.float32) * x.astype(np.float32)[:, None]
    assert replies[2].values.dtype == float and np.array_equal(replies[2].values, single.astype(float))
    assert np.array_equal(replies[3].values, (x.astype(np.float32) ** 2).astype(float))
    assert all(reply.seconds >= 0 for reply in replies)


@pytest.mark.parametrize("death", ["os._exit(3)", "ctypes.string_at(0)", "os.kill(os.getpid(), 9)"])
def test_a_crash_costs_only_its_own_function(death):
    text = f"import ctypes, os\ndef good(x): return x\ndef bad(x): {death}\ndef fine(x): return 2 * x\n"
    replies = python(text, "good", "bad", "fine", "absent")
    assert replies["bad"].verdict == "crash" and replies["bad"].said and replies["absent"].verdict == "missing"
    assert np.array_equal(replies["good"].values, POINTS["x"][:50]) and replies["fine"].verdict == ""


def test_a_broken_glsl_function_leaves_the_others():
    text = "float good(float x) { return x; }\nfloat bad(float x) { while (true) { x += 0.0; } return x; }\n"
    asked = [Question(name, name, "glsl", {"x": POINTS["x"][:50]}) for name in ("good", "bad", "absent")]
    replies = answer(Submission("a", {"submission.glsl": text.encode()}), asked, LIMITS)
    assert [reply.verdict for reply in replies] == ["", "compile_error", "missing"]


def test_the_time_of_a_submission_has_an_end():
    names = [f"f{i}" for i in range(8)]
    text = "".join(f"def {name}(x):\n    while True: pass\n" for name in names)
    before = os.times()
    replies = python(text, *names, limits=Limits(cpu=1, wall=5.0, total=2.0))
    after = os.times()
    assert {reply.verdict for reply in replies.values()} == {"timeout_cpu"}
    assert sum("whole submission" in reply.said for reply in replies.values()) >= 5
    assert after.children_user - before.children_user < 4.5


def test_a_text_that_cannot_be_read_is_run_once():
    replies = python("import os\nos._exit(0)\n", "a", "b", "c")
    assert {reply.verdict for reply in replies.values()} == {"crash"}


def test_two_files_are_two_processes():
    both = Submission("a", {"submission.py": b"import os\nos._exit(0)\n", "submission.glsl": GLSL.encode()})
    replies = answer(both, [*questions("python", 5), *questions("glsl", 5)], LIMITS)
    assert [reply.verdict for reply in replies] == ["crash", "crash", "", ""]


def test_files_that_are_absent_empty_or_refused():
    asked = [*questions("python", 5), *questions("glsl", 5)]
    replies = answer(Submission("a", {"submission.py": b" \n"}), asked, LIMITS)
    assert [reply.verdict for reply in replies] == ["missing"] * 4 and "is empty" in replies[0].said
    assert {reply.verdict for reply in answer(Submission("a", refused="a bomb"), asked, LIMITS)} == {"rejected"}
    latin = Submission("a", {"submission.py": "ä".encode("latin-1"), "submission.glsl": GLSL.encode()})
    assert [reply.verdict for reply in answer(latin, asked, LIMITS)] == ["rejected", "rejected", "", ""]


def test_a_sandbox_that_cannot_be_set_up_is_our_failure(monkeypatch):
    level.found()
    monkeypatch.setattr(sandbox, "package_files", lambda name: (f"/nowhere/{name}",))
    replies = python("def good(x): return x\n", "good")
    assert replies["good"].verdict == "ungraded"


def spins(child: psutil.Process) -> bool:
    """A worker at its endless loop; one of the self-test may end while it is looked at."""
    try:
        return '"worker_python"' in " ".join(child.cmdline()) and child.cpu_times().user > 0.5
    except psutil.Error:
        return False


def test_a_child_dies_with_its_supervisor(tmp_path):
    """However the supervisor dies: the kernel ends what it left."""
    code = ("from tests.test_grade_supervisor import Limits, python\n"
            "python('def spin(x):\\n    while True: pass\\n', 'spin', limits=Limits(cpu=60))")
    parent = subprocess.Popen([sys.executable, "-c", code], cwd=ROOT)
    deadline, children = time.monotonic() + 60, []
    while not children and time.monotonic() < deadline:  # the worker, once the self-test is over
        children = [child for child in psutil.Process(parent.pid).children() if spins(child)]
        time.sleep(0.02)
    assert children
    parent.send_signal(signal.SIGKILL)
    parent.wait()
    gone, alive = psutil.wait_procs(children, timeout=5)
    assert gone and not alive


def test_the_same_without_pipes_of_ones_own(monkeypatch):
    """As on Windows, where a trusted text is checked by its author."""
    both = Submission("a", {"submission.py": PYTHON.encode(), "submission.glsl": GLSL.encode()})
    asked = [*questions("python", 5000), *questions("glsl", 5000)]
    here = answer(both, asked, LIMITS, granted="L0")
    monkeypatch.setattr(plain, "NEEDED", True)
    for one, other in zip(here, answer(both, asked, LIMITS, granted="L0"), strict=True):
        assert one.verdict == other.verdict == "" and np.array_equal(one.values, other.values)
    replies = python("import os\ndef good(x): return x\ndef bad(x): os._exit(1)\n", "good", "bad")
    assert [replies[name].verdict for name in ("good", "bad")] == ["", "crash"]
    assert python("while True: pass\n", "spin", limits=Limits(cpu=1))["spin"].verdict == "timeout_wall"


def test_what_is_printed_is_bounded_and_printable():
    noisy = "import sys\ndef f(x):\n    print('\\x1b[2J\\u202e' * 1000000)\n    return x\n"
    calls = [answers.Call("f", (POINTS["x"][:5],), 1)]
    ending = conversation.converse("worker_python", noisy, calls, LAYERS["L2"], LIMITS)
    assert not ending.word and len(ending.answers) == 1
    assert len(ending.printed) < 6 * answers.NOISE and all(c.isprintable() or c == "\n" for c in ending.printed)
