"""What grading costs: processor time of one good submission, 5 functions at 1e5 points and one picture of 256 x 256."""

import os
import resource

import numpy as np

from app.grade import level
from app.grade.intake import Submission
from app.grade.question import FILES, Language, Question
from app.grade.supervisor import answer
from tests.bench.rows import Row, in_turn

PYTHON = b"""import numpy as np

def f_schlick(c, f0):
    return f0 + (1 - f0) * (1 - c)**5

def d_beckmann(c, m):
    return np.exp(-(1 - c) * (1 + c) / (c * c * m * m)) / (np.pi * m * m * c**4)

def d_blinn(c, n):
    return (n + 2) / (2 * np.pi) * c**n

def g_vgroove(nh, nl, nv, lh):
    return np.minimum(1, np.minimum(2 * nh * nl / lh, 2 * nh * nv / lh))

def shade(n, l, v, m):
    h = l + v
    h = h / np.linalg.norm(h, axis=1, keepdims=True)
    return d_beckmann(np.clip((n * h).sum(1), 1e-4, 1), m)
"""
GLSL = b"""const float PI = 3.14159265;
float f_schlick(float c, float f0) { float x = 1.0 - c; return f0 + (1.0 - f0) * x * x * x * x * x; }
float d_beckmann(float c, float m) {
    float c2 = c * c, m2 = m * m;
    return exp(-(1.0 - c) * (1.0 + c) / (c2 * m2)) / (PI * m2 * c2 * c2);
}
float d_blinn(float c, float n) { return (n + 2.0) / (2.0 * PI) * pow(c, n); }
float g_vgroove(float nh, float nl, float nv, float lh) {
    return min(1.0, min(2.0 * nh * nl / lh, 2.0 * nh * nv / lh));
}
float shade(vec3 n, vec3 l, vec3 v, float m) { return d_beckmann(clamp(dot(n, normalize(l + v)), 1e-4, 1.0), m); }
"""
MOST, HOLDS = 800.0, 300.0  # ms of one core, MB of the supervisor
RANDOM = np.random.default_rng(1)


def numbers(count: int, *names: str) -> dict[str, np.ndarray]:
    return {name: RANDOM.uniform(0.1, 1.0, count) for name in names}


def asked(language: Language) -> list[Question]:
    def shade(name: str, count: int) -> Question:
        directions = {key: RANDOM.normal(size=(count, 3)) for key in "nlv"}
        return Question(name, "shade", language, {key: x / np.linalg.norm(x, axis=1, keepdims=True)
                                                  for key, x in directions.items()} | numbers(count, "m"))

    return [Question(name, name, language, numbers(100_000, *args)) for name, args in (
        ("f_schlick", ("c", "f0")), ("d_beckmann", ("c", "m")), ("d_blinn", ("c", "n")),
        ("g_vgroove", ("nh", "nl", "nv", "lh")))] + [shade("shade", 100_000), shade("picture", 256 * 256)]


def grading(rounds: int = 5) -> list[Row]:
    """Processor time of the supervisor and its children; the self-test of the sandbox is done before."""
    level.found()
    submission = Submission("good", {"submission.py": PYTHON, "submission.glsl": GLSL})

    def cost(language: Language):
        questions = asked(language)

        def run() -> float:
            before = os.times()
            replies = answer(submission, questions)
            after = os.times()
            assert not any(reply.verdict for reply in replies), replies
            return 1e3 * (sum(after[:4]) - sum(before[:4]))

        return run

    rows = in_turn({language: cost(language) for language in FILES}, rounds, asked=dict.fromkeys(FILES, MOST))
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    return [*rows, Row("supervisor's peak", "MB", [peak], HOLDS)]
