"""Every function of glsl/optics has a twin in app/optics with the same arguments and, within the rule, the same values."""

import numpy as np
import pytest

from app import optics, shader
from app.gpu.context import program
from app.gpu.evaluate import MAX_CORNERS, WIDTH, evaluate
from app.quantities import TABLE
from app.tolerance import FACTOR, ratio

CATALOGUE = shader.catalogue()
POINTS = 400
NAIVE = [name for name in CATALOGUE if name.endswith("_naive")]
COUNTED = {"solid_angle_patch_counted", "meets_patch"}  # steps: a ray at the rim may fall on either side


def cube(half: float = 1.0) -> np.ndarray:
    """(12, 3, 3), counter-clockwise from outside."""
    faces = []
    for axis in range(3):
        for side in (-1.0, 1.0):
            square = np.full((4, 3), side)
            square[:, (axis + 1) % 3], square[:, (axis + 2) % 3] = (-1, 1, 1, -1), (-1, -1, 1, 1)
            square = square if side > 0 else square[::-1]
            faces += [square[[0, 1, 2]], square[[0, 2, 3]]]
    return half * np.array(faces)


def draw(name: str, rng: np.random.Generator, count: int = POINTS) -> np.ndarray:
    """Values of a quantity as float32 keeps them: half linear, half logarithmic, the ends and the default included."""
    q = TABLE[name]
    shape = (count,) if q.width == 1 else (count, q.width)
    low, high = q.extreme or (q.low, q.high)
    linear = rng.uniform(q.low, q.high, shape)
    largest = max(abs(low), abs(high))
    smallest = low if low > 0 else min(1e-6, largest) if q.kind != "int" else 1
    logarithmic = np.exp(rng.uniform(np.log(smallest), np.log(largest), shape))
    if low < 0:
        logarithmic *= rng.choice((-1, 1), shape)
    value = np.where(rng.random(shape) < 0.5, linear, np.clip(logarithmic, low, high))
    for i, end in enumerate((q.low, q.high, low, high, q.default)):
        value[i] = end
    value = rng.permutation(value)
    return np.rint(value).astype(int) if q.kind == "int" else value.astype(np.float32).astype(float)


def planar(rng: np.random.Generator) -> np.ndarray:
    """(5, 3): a convex polygon, off the axis, of a size between 1e-3 and 3 at a distance near 1."""
    around = np.sort(rng.uniform(0, 2 * np.pi, 5))
    axes, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    flat = 10 ** rng.uniform(-3, 0.5) * np.stack([np.cos(around), np.sin(around), np.zeros(5)], -1)
    return (flat @ axes.T + 1.5 * axes[2]).astype(np.float32).astype(float)


JOINT = {  # arguments that belong together
    "fibonacci_direction": lambda a, rng: a | {"index": a["index"] % a["samples"]},
    "solid_angle_cell": lambda a, rng: a | {"d_theta": f32(np.minimum(a["d_theta"], 2 * np.minimum(a["theta"], np.pi - a["theta"])))},
    "solid_angle_rectangle_off_axis": lambda a, rng: in_order(a),
    "projected_solid_angle_rectangle": lambda a, rng: in_order(a),
    # beyond, the patch's edge at the horizon passes the eye closer than its corners are known
    "projected_solid_angle_patch": lambda a, rng: a | {"width": f32(np.minimum(a["width"], 1e3 * a["distance"]))},
    "solid_angle_rectangle_beside": lambda a, rng: beside(a),
    "solid_angle_triangle_edges": lambda a, rng: nearest(a),
    "solid_angle_triangle": lambda a, rng: shrunk(a, rng),
    "solid_angle_triangle_signed": lambda a, rng: shrunk(a, rng),
    "meets_patch": lambda a, rng: a | {"towards": f32(a["towards"] / np.linalg.norm(a["towards"], axis=-1, keepdims=True))},
}


def f32(x):
    return np.asarray(x, np.float32).astype(float)


def in_order(a: dict) -> dict:
    low, high = (f32(f(a["x0"], a["x1"])) for f in (np.minimum, np.maximum))
    bottom, top = (f32(f(a["y0"], a["y1"])) for f in (np.minimum, np.maximum))
    return a | {"x0": low, "x1": high, "y0": bottom, "y1": top}


def beside(a: dict) -> dict:
    low = f32(np.abs(a["x0"]))
    high = f32(np.nextafter(low + a["width"], np.inf, dtype=np.float32) + 0 * low)
    return a | {"x0": low, "x1": high, "width": f32(high - low)}


def nearest(a: dict) -> dict:
    """a is the corner nearest to the eye: otherwise the sum of a and an edge may cancel."""
    size = np.linalg.norm(a["a"], axis=-1)
    kept = np.minimum(*(np.linalg.norm(a["a"] + a[e], axis=-1) for e in ("ab", "ac"))) >= size
    return a | {e: np.where(kept[:, None], a[e], 2 * a["a"]) for e in ("ab",)} | {"ac": np.where(kept[:, None], a["ac"], a["a"][:, ::-1])}


def shrunk(a: dict, rng) -> dict:
    """Half of the triangles are small beside their distance."""
    scale = np.where(rng.random(len(a["a"])) < 0.5, 1.0, 10 ** rng.uniform(-5, 0, len(a["a"])))[:, None]
    return a | {name: f32(a["a"] + scale * (a[name] - a["a"])) for name in ("b", "c")}


def arguments(name: str, rng: np.random.Generator, count: int = POINTS) -> dict:
    signature = CATALOGUE[name][1]
    args = {}
    for arg in signature.args:
        if arg.type == "sampler2D":
            args[arg.name] = f32(cube() + 0.25)
        elif arg.size:
            args[arg.name] = planar(rng)
        else:
            args[arg.name] = draw(arg.name, rng, count)
    return JOINT.get(name, lambda a, rng: a)(args, rng)


def worst(name: str, args: dict, found: np.ndarray, got: np.ndarray) -> str:
    """The points a person wants to see when a twin fails."""
    lines = [f"{name}: {np.count_nonzero(found > FACTOR)} of {found.size} points beyond {FACTOR}"]
    value = np.asarray(optics.twin(name)(**args))
    for i in np.argsort(-found.ravel())[:5]:
        at = {k: v[i].tolist() if np.ndim(v) and len(v) == found.size and k != "triangles" else "as given" for k, v in args.items()}
        lines.append(f"  {found.ravel()[i]:.3g}: {at} float64 {value[i]} GLSL {got[i]}")
    return "\n".join(lines)


def test_every_function_has_its_twin():
    python, glsl = set(optics.names()), set(CATALOGUE)
    assert not glsl - python, f"in glsl/optics, but not in app/optics: {sorted(glsl - python)}"
    assert not python - glsl, f"in app/optics, but not in glsl/optics (helpers start with _): {sorted(python - glsl)}"


@pytest.mark.parametrize("name", CATALOGUE)
def test_same_file_and_arguments(name):
    include, signature = CATALOGUE[name]
    assert include == f"optics/{optics.names()[name]}.glsl"
    assert tuple(a.name for a in signature.args) == optics.arguments(name)
    for arg in signature.args:
        assert arg.type == "sampler2D" or arg.size or arg.name in TABLE, f"{arg.name} is not in quantities"
        if arg.name in TABLE and not arg.size:
            assert arg.type == TABLE[arg.name].kind


@pytest.mark.parametrize("name", sorted(set(CATALOGUE) - set(NAIVE) - COUNTED))
def test_same_values(name, ctx, record_property):
    rng = np.random.default_rng(sum(map(ord, name)))
    is_vector = WIDTH[CATALOGUE[name][1].returns] > 1
    rounds = 40 if "corners" in optics.arguments(name) else 1
    top = 0.0
    for _ in range(rounds):
        args = arguments(name, rng)
        got = evaluate(name, args, ctx=ctx)
        found = ratio(name, args, got, "float32", is_vector)
        top = max(top, float(found.max()))
        assert found.max() <= FACTOR, worst(name, args, found, got)
    record_property("ratio", top)
