"""`halfway doctor`: which parts of the course work on this machine, and the command that mends each that does not.

Every part is tried in a child process (`probes`) that may crash or hang without harm. The course can run when plots and
LaTeX work and OpenGL works in a window or without one. The reference renderer, a second opinion for comparisons from
chapter 2 on, and the grading of homework are not needed for that.
"""

import argparse
import importlib.metadata
import json
import os
import platform
import signal
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from contextlib import AbstractContextManager, nullcontext
from dataclasses import asdict, dataclass, field
from textwrap import shorten

from app import VERSION
from app.paths import ROOT
from app.remedies import SYSTEMS, XWAYLAND, first, mend, system

PARTS = {"reference": "reference renderer", "plots": "plots", "headless": "OpenGL without a window",
         "grading": "homework grading", "window": "window", "latex": "LaTeX"}  # the slow ones start first
SHOWN = ("headless", "window", "plots", "latex", "reference", "grading")
PACKAGES = ("numpy", "moderngl", "imgui-bundle", "pyvista", "vtk", "trimesh", "scikit-robot-pyrender", "pillow")
SOFTWARE = ("llvmpipe", "softpipe", "swrast", "swiftshader", "software", "gdi generic")
TIMEOUT = 30.0


@dataclass
class Part:
    """What became of one part."""

    name: str
    works: bool
    words: str
    seconds: float = 0.0
    facts: dict = field(default_factory=dict)
    mend: dict[str, str] = field(default_factory=dict)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--json", action="store_true", help="print the findings as JSON")


def run(options: argparse.Namespace) -> int:
    parts = try_all(progress=sys.stdout.isatty() and not options.json)
    fine = can_run(parts)
    print(json.dumps(report(parts), indent=1) if options.json else words(parts))
    return 0 if fine else 1


def try_all(progress: bool = False, timeout: float = TIMEOUT) -> dict[str, Part]:
    """All parts, side by side."""
    watch: AbstractContextManager = nullcontext()
    if progress:
        from rich.console import Console

        watch = Console().status("Trying each part of the course in a process of its own ...")
    running: list[subprocess.Popen] = []
    with watch, ThreadPoolExecutor(len(PARTS)) as pool:
        waiting = {name: pool.submit(try_part, name, [sys.executable, "-m", "app.probes", name], timeout, running)
                   for name in PARTS}
        try:
            return {name: waiting[name].result() for name in SHOWN}
        except KeyboardInterrupt:
            for child in running:
                stop(child)
            raise


def try_part(name: str, command: list[str], timeout: float, running: list | None = None) -> Part:
    """Run one probe; a crash, a hang and silence are findings like any other."""
    start = time.perf_counter()
    environment = dict(os.environ)
    environment["PYTHONPATH"] = os.pathsep.join(filter(None, [str(ROOT), environment.get("PYTHONPATH")]))
    child = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                             env=environment, start_new_session=True)
    if running is not None:
        running.append(child)
    try:
        out, noise = child.communicate(timeout=timeout)
    except subprocess.TimeoutExpired:
        stop(child)
        child.communicate()
        return Part(name, False, f"did not answer within {timeout:g} s and was stopped", timeout, mend=mend(name))
    seconds = round(time.perf_counter() - start, 2)
    try:
        facts = json.loads(out)
    except ValueError:
        why = died(child.returncode, noise.decode(errors="replace"))
        return Part(name, False, why, seconds, mend=mend(name, words=why))
    if "error" in facts:
        why = shorten(facts["error"].split(" Run `halfway doctor`")[0].rstrip("."), 220, placeholder=" …")
        return Part(name, False, why, seconds, mend=mend(name, facts["kind"], facts["package"], why))
    return Part(name, True, good(name, facts), seconds, facts, first(XWAYLAND) if facts.get("wayland") else {})


def stop(child: subprocess.Popen) -> None:
    """The probe and what it started."""
    if child.poll() is None:
        if hasattr(os, "killpg"):
            os.killpg(child.pid, signal.SIGKILL)
        else:
            child.kill()


def died(code: int, noise: str) -> str:
    if code < 0:
        return f"the driver or a library crashed ({signal.Signals(-code).name})"
    lines = [line for line in noise.splitlines() if line.strip()]
    return f"ended without an answer (exit code {code}{': ' + lines[-1].strip()[:160] if lines else ''})"


def good(name: str, facts: dict) -> str:
    if name == "window":
        why = "this Wayland session has no Xwayland" if facts.get("wayland") else "no display here"
        return "opens" if facts["display"] else f"{why}: `halfway` renders the lessons to files instead"
    if name == "latex":
        return {"aliased": "formulas are drawn (C.UTF-8 stands in for the missing locale en_US.UTF-8)"}.get(
            facts["locale"], "formulas are drawn")
    if name == "grading":
        lower = "" if facts["safe"] else f"; `halfway grade` wants --level {facts['level']} ({facts['why']})"
        return f"isolation {facts['level']}: {facts['meaning']}{lower}"
    return {"headless": "draws", "plots": "pyvista draws", "reference": "pyrender draws"}[name]


def can_run(parts: dict[str, Part]) -> bool:
    window = parts["window"].works and parts["window"].facts.get("display", False)
    return parts["plots"].works and parts["latex"].works and (parts["headless"].works or window)


def graphics(parts: dict[str, Part]) -> dict[str, str]:
    return parts["headless"].facts.get("graphics") or parts["window"].facts.get("graphics") or {}


def version(package: str) -> str:
    try:
        return importlib.metadata.version(package)
    except importlib.metadata.PackageNotFoundError:
        return "missing"


def machine() -> str:
    try:
        name = platform.freedesktop_os_release()["PRETTY_NAME"]
    except (OSError, KeyError):
        name = f"{platform.system()} {platform.release()}"
    return f"{name}, {platform.machine()}"


def report(parts: dict[str, Part]) -> dict:
    return {"halfway": VERSION, "system": machine(), "family": system(),
            "python": platform.python_version(), "packages": {name: version(name) for name in PACKAGES},
            "graphics": graphics(parts), "parts": [asdict(part) for part in parts.values()],
            "can_run": can_run(parts)}


def words(parts: dict[str, Part]) -> str:
    """All of it for a person."""
    facts = graphics(parts)
    lines = [f"Halfway {version('halfway')} on {machine()}, Python {platform.python_version()}",
             ", ".join(f"{name} {version(name)}" for name in PACKAGES)]
    if facts:
        lines.append(f"OpenGL {facts['version']}, {facts['renderer']}, by {facts['vendor']}")
        if any(word in facts["renderer"].lower() for word in SOFTWARE):
            lines.append("The processor draws, not a graphics card: the same pictures, only slower.")
    lines.append("")
    wide = max(map(len, PARTS.values()))
    for name, part in parts.items():
        lines.append(f"{'works ' if part.works else 'BROKEN'}  {PARTS[name]:{wide}}  {part.words}")
        if not part.works and name == "grading":
            lines.append(f"{'':{wide + 10}}(needed only to grade what others hand in)")
        if not part.works and name == "reference":
            lines.append(f"{'':{wide + 10}}(needed from chapter 2 on, only to compare with a second renderer)")
        lines += [f"{'':{wide + 10}}{SYSTEMS[key]}: {command}" for key, command in part.mend.items()]
    lines.append("")
    broken = any(not part.works for part in parts.values())
    if can_run(parts):
        lines.append("The course can run" + (", without what is broken above." if broken else "."))
    else:
        lines.append("The course cannot run yet: use the first command under each broken part, then `halfway doctor`.")
    return "\n".join(lines)
