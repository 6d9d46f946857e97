"""The same conversation where there are no pipes of one's own and no limits (Windows): by files, trusted texts only."""

import os
import subprocess
import tempfile
import time
from pathlib import Path

from app.grade import sandbox
from app.grade.answers import NOISE, Call, Ending, Frames, Ours, printable, write

NEEDED = os.name == "nt"
BEGIN = 5.0  # s on the clock for the interpreter and numpy to be there


def converse(worker: str, text: str, calls: list[Call], limits: sandbox.Limits, dtype: str = "<f8") -> Ending:
    """Ask all calls of a fresh process; it is stopped after its processor time on the clock, then its file is read."""
    ending, started = Ending(), time.monotonic()
    with tempfile.TemporaryDirectory(prefix="halfway-", ignore_cleanup_errors=True) as folder:
        questions, answers, noise = (Path(folder) / name for name in ("questions", "answers", "printed"))
        with open(questions, "wb") as file:
            write(file, text, calls, dtype)
        answers.touch()
        with open(noise, "wb") as printed:
            child = subprocess.Popen(sandbox.command(worker, (), limits, {
                "questions": str(questions), "answers": str(answers)}), stdin=subprocess.DEVNULL, stdout=printed,
                stderr=printed, env=sandbox.environment())
            try:
                child.wait(limits.cpu + BEGIN)
            except subprocess.TimeoutExpired:
                ending.said = f"stopped after {limits.cpu} s"
                child.kill()
                child.wait()
        frames = Frames(calls, ending, lambda: None)
        most = sum(max(8 * call.count * call.width, 4096) + 64 for call in calls) + 4096
        with open(answers, "rb") as file:
            frames.feed(file.read(most))
        with open(noise, "rb") as file:
            ending.printed = printable(file.read(NOISE))
    ending.wall = time.monotonic() - started
    if not ending.started:
        raise Ours(f"a process for the text could not be started: {ending.printed.strip()[-300:]}")
    if not frames.complete() and not ending.word:
        ending.word = "timeout_wall" if ending.said else "crash"
        ending.said = ending.said or f"the process ended by itself (exit code {child.returncode})"
    return ending
