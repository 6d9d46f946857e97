"""The corpus of hostile submissions, each run in the sandbox amid a class of good ones: a verdict, and nothing left."""

import re
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import psutil
import pytest

from app.grade import level
from app.grade.intake import Submission
from app.grade.question import FILES, VERDICTS, Question, Reply
from app.grade.sandbox import Limits
from app.grade.supervisor import answer
from tests.hostile_at_length import TEXTS

HERE = Path(__file__).parent / "hostile"
KEPT = [*(HERE / "python").glob("*.py"), *(HERE / "glsl").glob("*.glsl")]
CASES = {path.relative_to(HERE).as_posix(): path.read_bytes() for path in KEPT}
CASES |= {place: text.encode() for place, text in TEXTS.items()}
HEADER = re.compile(r"(?:#|//) \d+: ([a-z_|]+): [^\[\n]*(?:\[line (\d+)\])?\n")
LIMITS = Limits(cpu=1, wall=3.0)
X = np.random.default_rng(5).uniform(0.1, 1.0, 200).astype(np.float32).astype(float)
GOOD = Submission("good", {"submission.py": b"def asked(x):\n    return 2 * x\n",
                           "submission.glsl": b"float asked(float x) { return 2.0 * x; }\n"})
TRACES = "halfway-hostile*"


def question(language: str) -> Question:
    return Question(f"asked/{language}", "asked", language, {"x": X})  # type: ignore[arg-type]


def verdict(reply: Reply) -> str:
    """What a judge would say of a function that doubles."""
    if reply.verdict:
        return reply.verdict
    assert reply.values is not None and reply.values.shape == X.shape
    if not np.all(np.isfinite(reply.values)):
        return "nonfinite"
    return "pass" if np.all(np.abs(reply.values - 2 * X) <= 1e-6) else "wrong"


def graded(case: str | None) -> Reply:
    if case is None:
        return answer(GOOD, [question("python")], LIMITS)[0]
    language = case.split("/")[0]
    submission = Submission(Path(case).stem, {FILES[language]: CASES[case]})  # type: ignore[index]
    return answer(submission, [question(language)], LIMITS)[0]


def left_behind() -> dict:
    """What a submission could leave on this machine."""
    me = psutil.Process()
    places = [Path(tempfile.gettempdir()), Path("/tmp"), Path("/dev/shm"), Path.cwd()]
    shared = Path("/proc/sysvipc/shm").read_text() if Path("/proc/sysvipc/shm").exists() else ""
    return {"traces": sorted({str(path) for place in places if place.is_dir() for path in place.glob(TRACES)}),
            "children": sorted(child.pid for child in me.children(recursive=True)), "descriptors": me.num_fds(),
            "sockets": len(me.net_connections()), "shared memory": shared.count("1212238918"),
            "orphans": sorted(p.pid for p in psutil.process_iter(["cmdline", "ppid"])
                              if p.info["ppid"] == 1 and "launch.py" in " ".join(p.info["cmdline"] or ()))}


@pytest.fixture(scope="module")
def school() -> dict:
    """Everybody, two at a time, a good submission after every eighth hostile one; and what was left behind."""
    assert level.found().safe, level.found().why
    baseline = {name: answer(GOOD, [question(name)], LIMITS)[0] for name in FILES}
    before = left_behind()
    with ThreadPoolExecutor(2) as pool:
        class_of = [one for n, case in enumerate(sorted(CASES)) for one in ((case, None) if n % 8 == 0 else (case,))]
        replies = list(zip(class_of, pool.map(graded, class_of), strict=True))
    return {"replies": {case: reply for case, reply in replies if case}, "baseline": baseline, "before": before,
            "neighbours": [reply for case, reply in replies if case is None], "after": left_behind()}


@pytest.mark.parametrize("case", sorted(CASES))
def test_a_hostile_submission_gets_its_verdict(case, school):
    header = HEADER.match(CASES[case].decode())
    assert header, f"{case} needs a first line like # 17: crash: leaves without a word"
    wanted, reply = header[1].split("|"), school["replies"][case]
    assert set(wanted) <= set(VERDICTS)
    assert verdict(reply) in wanted, f"{verdict(reply)}: {reply.said}"
    assert len(reply.said) < 2500 and all(c.isprintable() or c == "\n" for c in reply.said)
    assert bool(reply.said) == (reply.values is None), "a person is told why"
    if header[2]:
        assert f"line {header[2]}:" in reply.said, reply.said


def test_loops_cut_off_by_the_renderer_are_told(school):
    for name in ("47_endless_with_effect", "47_two_loops", "48_too_many_steps", "48_some_points"):
        assert "its loops were cut off" in school["replies"][f"glsl/{name}.glsl"].said


def test_the_neighbours_keep_their_marks(school):
    for reply in school["neighbours"]:
        assert reply.verdict == "" and np.array_equal(reply.values, school["baseline"]["python"].values)


def test_nothing_is_left_of_them(school):
    """Other tests' children, as the process that draws plots, may have been there before."""
    assert school["after"] == school["before"]
    assert not school["before"]["traces"]


def test_every_python_and_glsl_case_of_the_design_is_there():
    numbers = {int(Path(case).name[:2]) for case in CASES}
    assert numbers >= {*range(1, 35), *range(39, 51)} - {35, 36, 37, 38}
