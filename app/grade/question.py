"""What is asked of a student's text, and what came back: numbers only, and nothing that would tell the right answer.

`answer` (in the supervisor) turns questions into replies in a sandbox; the judge alone knows references and weights.
A picture is a question too: its points are the pixels of the scene.
"""

from dataclasses import dataclass, field
from typing import Literal

import numpy as np

Language = Literal["python", "glsl"]
FILES: dict[Language, str] = {"python": "submission.py", "glsl": "submission.glsl"}


@dataclass(frozen=True)
class Question:
    """Points at which one function is called: every argument has N rows, of shape (N,) or (N, k) with k 2 to 4."""

    id: str
    function: str
    language: Language
    args: dict[str, np.ndarray] = field(hash=False)  # in the order of the signature; GLSL sees float32 of them
    width: int = 1  # numbers a value has: 1 for a float, 3 for a colour

    @property
    def count(self) -> int:
        return len(next(iter(self.args.values())))

    @property
    def hidden(self) -> bool:
        """Whether its points are never told; the id is function/part/language."""
        return "/hidden" in self.id


@dataclass(frozen=True)
class Reply:
    """The values, (N,) or (N, width) in float64, or why there are none."""

    id: str
    values: np.ndarray | None = field(default=None, hash=False)
    verdict: str = ""  # "" where there are values; else a word of VERDICTS
    said: str = ""  # what the compiler or the function said, of the student's own lines, cut and printable
    seconds: float = 0.0  # of processor time


VERDICTS = ("pass", "partial", "wrong", "nonfinite", "unwritten", "missing", "rejected", "compile_error",
            "runtime_error", "timeout_cpu", "timeout_wall", "memory", "crash", "output_limit", "forbidden", "skipped",
            "ungraded")
