"""Whole commands, from process start to their end; the window's peak of memory, without its plots' process."""

import os
import subprocess
import sys
import tempfile
import time
from contextlib import contextmanager
from pathlib import Path

from app.paths import ROOT
from tests.bench.rows import Row, in_turn

WINDOW = ("-m", "app", "show", "solid_angle/patch")
RENDER = ("-m", "app", "render", "solid_angle/patch", "-o")


@contextmanager
def display():
    """The environment of a window: the display there is, or one of our own that nobody sees."""
    folder = tempfile.TemporaryDirectory()
    environment = {**os.environ, "HALFWAY_DATA": folder.name}
    server = None
    if "DISPLAY" not in environment and sys.platform.startswith("linux"):
        reader, writer = os.pipe()
        server = subprocess.Popen(["Xvfb", "-displayfd", str(writer), "-screen", "0", "1600x1000x24", "-noreset"],
                                  pass_fds=(writer,), stderr=subprocess.DEVNULL)
        os.close(writer)
        with os.fdopen(reader) as number:
            environment["DISPLAY"] = f":{number.readline().strip()}"
    try:
        yield environment
    finally:
        if server:
            server.terminate()
            server.wait()
        folder.cleanup()


def child(*words: str, environment: dict | None = None) -> tuple[float, float]:
    """Milliseconds from start to end, and the peak of memory in MB of this process alone."""
    start = time.perf_counter()
    process = subprocess.Popen([sys.executable, *words], cwd=ROOT, env=environment, stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE)
    said = process.stderr.read() if process.stderr else b""
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    took = 1e3 * (time.perf_counter() - start)
    if process.returncode:
        raise SystemExit(f"{' '.join(words)} ended with {process.returncode}: {said.decode(errors='replace')[-500:]}")
    return took, used.ru_maxrss / (2**20 if sys.platform == "darwin" else 2**10)


def commands(rounds: int = 7) -> list[Row]:
    """python -c pass is the reference."""
    with display() as environment, tempfile.TemporaryDirectory() as folder:
        first = {**environment, "HALFWAY_EXIT_AFTER_FRAMES": "1"}
        picture = str(Path(folder) / "step.png")
        peaks: list[float] = []

        def window() -> float:
            took, peak = child(*WINDOW, environment=first)
            peaks.append(peak)
            return took

        rows = in_turn({
            "python -c pass": lambda: child("-c", "pass")[0],
            "the window's first frame, and out": window,
            "halfway list": lambda: child("-m", "app", "list")[0],
            "halfway render, the scene": lambda: child(*RENDER, picture, "--view", "scene")[0],
            "halfway render, scene and plot": lambda: child(*RENDER, picture, "--view", "both")[0],
        }, rounds, asked={"the window's first frame, and out": 900, "halfway list": 250,
                          "halfway render, the scene": 600})
        later = {**environment, "HALFWAY_EXIT_AFTER_FRAMES": "120"}
        longer = [child(*WINDOW, environment=later)[1] for _ in range(3)]
        return [*rows, Row("peak memory at the first frame", "MB", peaks[1:], 180),
                Row("peak memory after 120 frames", "MB", longer, 180)]
