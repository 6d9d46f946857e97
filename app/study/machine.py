"""What a study ran on: times mean nothing without it."""

import os
import platform
import sys
from pathlib import Path


def machine(gpu: bool = False) -> dict:
    """Processor, cores, system, versions; the GPU's renderer where frames were drawn."""
    import numpy
    import scipy

    from app import VERSION

    found = {"processor": processor(), "cores": os.cpu_count(), "system": platform.platform(),
             "python": sys.version.split()[0], "numpy": numpy.__version__, "scipy": scipy.__version__,
             "halfway": VERSION}
    if gpu:
        from app.gpu.context import context

        found["renderer"] = context().info["GL_RENDERER"]
    return found


def processor() -> str:
    try:
        for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    except OSError:
        pass
    return platform.processor() or platform.machine()
