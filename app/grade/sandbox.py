"""A process for a student's text, locked in: its order, its limits, and what it was allowed to read.

`start` is the only place where such a process is made. Which layers hold on this machine is found by `app.grade.level`.
"""

import importlib.util
import json
import os
import subprocess
import sys
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from app.problem import Problem

CHILD = Path(__file__).parent / "child"
LAYERS = {  # level -> what is put on; a level is granted by the self-test alone
    "L3": ("limits", "namespaces", "landlock", "seccomp"),
    "L2": ("limits", "landlock", "seccomp"),
    "L1": ("limits", "user"),
    "L0": (),
}
PACKAGES = {"worker_python": ("numpy",), "worker_glsl": ("numpy", "moderngl", "_moderngl", "glcontext"),
            "probe": ("numpy", "moderngl", "_moderngl", "glcontext")}
SYSTEM = ("/lib", "/lib64", "/usr/lib", "/usr/lib64", "/usr/share/glvnd", "/usr/share/drirc.d", "/usr/share/zoneinfo",
          "/etc/ld.so.cache", "/etc/glvnd", "/etc/drirc", "/proc/self", "/proc/cpuinfo", "/proc/meminfo",
          "/sys/devices/system/cpu", "/dev/null", "/dev/urandom")
OURS = ("site-packages", "dist-packages", "test")  # of a folder of the standard library: not for students
ENVIRONMENT = {
    "LIBGL_ALWAYS_SOFTWARE": "1", "GALLIUM_DRIVER": "llvmpipe", "LP_NUM_THREADS": "0", "EGL_PLATFORM": "surfaceless",
    "MESA_SHADER_CACHE_DISABLE": "true", "EGL_LOG_LEVEL": "fatal", "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1",
    "MKL_NUM_THREADS": "1", "HOME": "/nonexistent", "PATH": "", "LANG": "C.UTF-8", "PYTHONUTF8": "1",
    "__EGL_VENDOR_LIBRARY_FILENAMES": "/usr/share/glvnd/egl_vendor.d/50_mesa.json",
}


@dataclass(frozen=True)
class Limits:
    """What one process of a submission may use."""

    cpu: int = 10  # s of processor time, compiling included
    wall: float = 5.0  # times cpu: the backstop for what sleeps
    memory: int = 1536 << 20  # bytes of address space; llvmpipe dies oddly below 1 GB
    total: float = 4.0  # times cpu: all processes of a submission together


@cache
def package_files(name: str) -> tuple[str, ...]:
    """Where a package lies: what to import, then what else it reads."""
    spec = importlib.util.find_spec(name)
    if spec is None or not spec.origin:
        raise Problem(f"the package {name} is missing; `halfway doctor` says how to install it.")
    place = Path(spec.origin)
    place = place.parent if place.name == "__init__.py" else place
    libraries = place.with_name(f"{name}.libs")
    return (str(place), *([str(libraries)] if libraries.is_dir() else []))


@cache
def standard_library() -> tuple[str, ...]:
    """Its files and folders by name: packages installed among them, ours perhaps, are not part of it."""
    folder = Path(os.__file__).parent
    entries = [str(entry) for entry in sorted(folder.iterdir()) if entry.name not in OURS]
    base = Path(sys.base_prefix) / "lib"
    return (*entries, *(str(path) for path in sorted(base.glob("libpython*"))))


def readable(worker: str) -> list[str]:
    packages = [path for name in PACKAGES[worker] for path in package_files(name)]
    return [*SYSTEM, *standard_library(), *packages]


def command(worker: str, layers: tuple[str, ...], limits: Limits, more: dict) -> list[str]:
    """The launcher's words: what to put on, what may be read, and the worker to go on with."""
    order = {"worker": worker, "layers": layers, "readable": readable(worker) if "landlock" in layers else [],
             "packages": {name: package_files(name)[0] for name in PACKAGES[worker]}, "cpu": limits.cpu,
             "memory": limits.memory, "threads": worker != "worker_python", "parent": os.getpid(), **more}
    return [os.path.realpath(sys.executable), "-I", "-S", "-B", str(CHILD / "launch.py"), json.dumps(order)]


def environment() -> dict[str, str]:
    """Nothing of the supervisor's own; elsewhere than on Linux a process cannot start without some of it."""
    here = {name: value for name, value in ENVIRONMENT.items() if not value.startswith("/usr/") or Path(value).exists()}
    return here if sys.platform.startswith("linux") else {**os.environ, "OPENBLAS_NUM_THREADS": "1"}


def start(worker: str, layers: tuple[str, ...], limits: Limits, questions: int, out: int,
          more: dict | None = None) -> subprocess.Popen:
    """The process, about to lock itself in: it reads the descriptor `questions` and answers on `out`."""
    return subprocess.Popen(command(worker, layers, limits, {"out": out, **(more or {})}), stdin=questions,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, pass_fds=(out,), env=environment(), cwd="/",
                            start_new_session=True)  # Ctrl-C is not for it
