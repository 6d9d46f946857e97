"""Halfway: the course in local shading that you can touch."""

import os

VERSION = "0.1.0"  # as in pyproject.toml
# Mesa's OpenGL on a CPU (llvmpipe) compiles in half the time when LLVM does not optimise, and its frames take about a
# seventh longer. A text that is typed, a step that is opened and a choice that is made all wait for the compiler, most
# frames for nothing. Mesa reads it once in a process; a graphics card's driver does not. GALLIVM_PERF= undoes it.
os.environ.setdefault("GALLIVM_PERF", "nopt")
