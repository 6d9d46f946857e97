"""Which level of isolation holds on this machine: found by trying to break it from inside, never by version numbers.

Each level's layers are put on a process that then tries what a student's must not; one that succeeds, or one of the
things that must work and does not, and the next lower level is tried.
"""

import json
import os
import select
import signal
import socket
import subprocess
import sys
import tempfile
import time
from contextlib import ExitStack, suppress
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

from app.grade.sandbox import LAYERS, Limits, start
from app.paths import ROOT
from app.problem import Problem

LEVELS = ("L3", "L2", "L1", "L0")
SAFE = ("L3", "L2")
MEANING = {"L3": "namespaces, Landlock, seccomp and limits: fit for hostile work",
           "L2": "Landlock, seccomp and limits, no namespaces: fit for hostile work",
           "L1": "another user and limits: fit for accidents only",
           "L0": "a process that can be stopped: trusted work only"}
MUST_WORK = ("thread", "numpy", "picture")
AT_L3 = ("see the network",)  # what only L3 denies
AT_L1 = ("read a file beside the answers", "write a file", "change a file's mode", "signal the supervisor",
         "open many files", "take much memory", "spin without end")  # what even L1 denies
TRIAL = Limits(cpu=6, wall=5.0)
SPIN = Limits(cpu=1, wall=4.0)


@dataclass(frozen=True)
class Level:
    name: str
    tested: dict[str, str] = field(default_factory=dict, hash=False)
    why: str = ""  # why it is no higher
    renderer: str = ""

    @property
    def safe(self) -> bool:
        return self.name in SAFE


@cache
def found() -> Level:
    """The highest level that holds here."""
    why: list[str] = []
    for name in LEVELS:
        level, fault = tested(name, LAYERS[name])
        if level:
            return Level(name, level.tested, "; ".join(why), level.renderer)
        why.append(f"{name}: {fault}")
    raise Problem(f"students' texts cannot be run here: {'; '.join(why)}. `halfway doctor` may say more.")


def asked(name: str) -> Level:
    """A level named by the person, if it holds; everything that the named one asks for is tried."""
    if name not in LEVELS:
        raise Problem(f"there is no level {name}; there are {', '.join(LEVELS)}.")
    level, fault = tested(name, LAYERS[name])
    if not level:
        raise Problem(f"level {name} does not hold on this machine: {fault}.")
    return level


def tested(name: str, layers: tuple[str, ...]) -> tuple[Level | None, str]:
    """The level, or why these layers are not it."""
    if not sys.platform.startswith("linux") and name != "L0":
        return None, "only Linux has the layers"
    try:
        results = trial(layers)
    except (OSError, ValueError) as error:
        return None, str(error)[:300]
    for one in MUST_WORK:
        if not results.pop(one, "no answer").startswith("works"):
            return None, f"{one} does not work in the sandbox"
    renderer = results.pop("renderer")
    held = {"L3": set(results), "L2": set(results) - {*AT_L3}, "L1": {*AT_L1}, "L0": set()}[name]
    broken = sorted(one for one in held if results[one] != "denied")
    if broken:
        return None, f"a submission could {', '.join(broken)}"
    return Level(name, results, renderer=renderer), ""


def trial(layers: tuple[str, ...]) -> dict[str, str]:
    """What the probe found, beside listeners it could reach, a canary it could read and folders it could list."""
    with ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="halfway-probe-")))
        (folder / "canary").write_bytes(os.urandom(16))
        (folder / "canary").chmod(0o600)
        abstract = f"halfway-{os.urandom(8).hex()}"
        doors = [listener(stack, socket.AF_INET, ("127.0.0.1", 0))]
        if sys.platform.startswith("linux"):
            listener(stack, socket.AF_UNIX, str(folder / "door"))
            listener(stack, socket.AF_UNIX, "\0" + abstract)
        more = {"folder": str(folder), "port": doors[0].getsockname()[1], "unix": str(folder / "door"),
                "abstract": abstract, "source": str(ROOT / "app" / "tolerance.py"),
                "network": os.readlink("/proc/self/ns/net") if sys.platform.startswith("linux") else ""}
        spinning = begin(stack, layers, SPIN, {"spin": True}) if "limits" in layers else None
        data, noise = finish(*begin(stack, layers, TRIAL, more))
        try:
            results = json.loads(data)
        except ValueError:
            raise ValueError(noise.strip().splitlines()[-1] if noise.strip() else "the probe died") from None
        if spinning:
            finish(*spinning)
            results["spin without end"] = "denied" if spinning[0].returncode == -signal.SIGKILL else "it could"
        else:
            results["spin without end"] = "it could"
    results["renderer"] = results["picture"].removeprefix("works: ")
    return results


def listener(stack: ExitStack, family: int, address) -> socket.socket:
    door = stack.enter_context(socket.socket(family, socket.SOCK_STREAM))
    door.bind(address)
    door.listen(4)
    return door


def begin(stack: ExitStack, layers: tuple[str, ...], limits: Limits,
          more: dict) -> tuple[subprocess.Popen, int, Limits]:
    inner, out = os.pipe()
    stack.callback(os.close, inner)
    nothing = os.open(os.devnull, os.O_RDONLY)
    try:
        child = start("probe", layers, limits, nothing, out, more)
    finally:
        os.close(out)
        os.close(nothing)
    return child, inner, limits


def finish(child: subprocess.Popen, inner: int, limits: Limits) -> tuple[bytes, str]:
    """What it said on its pipe until it ended, or was ended."""
    deadline, data = time.monotonic() + limits.wall * limits.cpu, bytearray()
    while (left := deadline - time.monotonic()) > 0 and len(data) < 1 << 16:
        if select.select([inner], [], [], left)[0]:
            part = os.read(inner, 1 << 16)
            if not part:
                break
            data += part
    else:
        with suppress(ProcessLookupError):
            os.kill(child.pid, signal.SIGKILL)
    child.wait(timeout=30)
    assert child.stdout and child.stderr
    with child.stdout, child.stderr:
        noise = os.read(child.stderr.fileno(), 1 << 16).decode(errors="replace")
    return bytes(data), noise
