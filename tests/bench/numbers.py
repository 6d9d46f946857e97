"""Twins over many points, the digits that float32 keeps of a small triangle, and the badges of models."""

import numpy as np

from app import catalog, optics
from app.badges import of_model
from app.board.terms import ANGLES
from app.furnace import albedo
from app.gpu.evaluate import evaluate
from app.state import defaults
from tests.bench.rows import Row, in_turn, timed

MILLION = 10**6


def points(rounds: int = 9) -> list[Row]:
    """A million numbers to the GPU and back; adding two numpy arrays of that length is the reference."""
    rng = np.random.default_rng(1)
    x, corners = rng.uniform(0.1, 1.0, MILLION), rng.normal(size=(3, MILLION, 3))
    found = in_turn({
        "numpy: x + x": timed(lambda: x + x),
        "solid_angle_cone, 10^6 points": timed(lambda: evaluate("solid_angle_cone", {"half_angle": x})),
        "solid_angle_patch, 10^6 points": timed(
            lambda: evaluate("solid_angle_patch", {"distance": x, "tilt": 0.3, "width": x})),
        "solid_angle_triangle, 10^6 points": timed(
            lambda: evaluate("solid_angle_triangle", dict(zip("abc", corners, strict=True)))),
    }, rounds)
    for row in found[1:3]:
        row.asked = 120.0
    return found


def badges(rounds: int = 9) -> list[Row]:
    """All badges of each model of the course, at its step's first values; adding two arrays is the reference."""
    x = np.random.default_rng(1).uniform(0.1, 1.0, MILLION)
    jobs = {"numpy: x + x": timed(lambda: x + x)}
    for step in catalog.steps():
        values = defaults(step)
        jobs |= {f"badges of {step.id}, {model.label}": timed(lambda m=model, v=values: of_model(m, v))
                 for model in step.step.models}
    return in_turn(jobs, rounds, asked=dict.fromkeys(list(jobs)[1:], 150.0))


ALBEDOS = {  # twin -> its parameters
    "brdf_lambert": [(0.8,)], "brdf_oren_nayar": [(0.8, 0.5)], "brdf_phong": [(0.0, 1.0, n) for n in (1.0, 1e2, 1e5)],
    "brdf_blinn_phong": [(0.0, 1.0, 10.0)], "brdf_cook_torrance": [(m, 0.95) for m in (0.01, 0.05, 0.3, 1.0)],
    "brdf_cook_torrance_printed": [(1.0, 0.95)], "brdf_cook_torrance_smith": [(m, 0.95) for m in (0.05, 0.3, 1.0)],
    "brdf_ggx": [(a, 0.95) for a in (0.01, 0.3, 1.0)], "brdf_flawed": [(1.0, 4, 0.5, 0.5, 4.0)],
}


def albedos(rounds: int = 7) -> list[Row]:
    """An albedo curve as the board draws it, of 45 angles to 1e-4; adding two arrays is the reference."""
    x = np.random.default_rng(1).uniform(0.1, 1.0, MILLION)
    jobs = {"numpy: x + x": timed(lambda: x + x)}
    for name, given in ALBEDOS.items():
        for args in given:
            def model(n, l, v, name=name, args=args):
                return optics.twin(name)(n, l, v, *args)

            jobs[f"albedo of {name}, {args}"] = timed(lambda model=model: albedo(model, ANGLES))
    return in_turn(jobs, rounds, asked=dict.fromkeys(list(jobs)[1:], 200.0))


def digits() -> list[Row]:
    """The worst relative error of a float32 triangle of the sizes 1 to 1e-5 at distance 1, of the truth."""
    rng, count = np.random.default_rng(2), 20000
    names = {"with edges": "solid_angle_triangle_edges", "corners, subtracted": "solid_angle_triangle",
             "as printed": "solid_angle_triangle_naive"}
    worst: dict[str, list[float]] = {name: [] for name in names}
    for size in 10.0 ** np.arange(0, -5.5, -0.5):
        a, ab, ac = (f32(v) for v in triangles(rng, count, size))
        b, c = f32(a + ab), f32(a + ac)
        for name, function in names.items():
            args = {"a": a, "ab": ab, "ac": ac} if name == "with edges" else {"a": a, "b": b, "c": c}
            exact = optics.twin(function.removesuffix("_naive"))(**args)
            worst[name].append(float(np.max(np.abs(evaluate(function, args) / exact - 1))))
    return [Row(f"float32 triangle, {name}", "", [max(errors)], None if "printed" in name else 1e-6)
            for name, errors in worst.items()]


def triangles(rng: np.random.Generator, count: int, size: float):
    """Corner and edges of well shaped triangles, their middle at distance 1, turned anyhow."""
    away = rng.normal(size=(count, 3))
    away /= np.linalg.norm(away, axis=-1, keepdims=True)
    side = np.cross(away, rng.normal(size=(count, 3)))
    side /= np.linalg.norm(side, axis=-1, keepdims=True)
    up = np.cross(away, side) * rng.uniform(0.5, 1.0, (count, 1)) + away * rng.uniform(-0.5, 0.5, (count, 1))
    return away, size * side, size * (0.5 * side + up)


def f32(x: np.ndarray) -> np.ndarray:
    return x.astype(np.float32).astype(float)
