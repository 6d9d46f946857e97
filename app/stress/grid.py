"""Every argument at its extremes, from `quantities` by its name: the ends and their neighbours, 0 and denormals, the
places where a formula changes its branch, and steps of equal ratio between."""

from functools import cache

import numpy as np

from app.hemisphere import apart
from app.optics.spherical import direction
from app.quantities import FROM_ANGLES, PI, TABLE
from app.stress.domain import COUNTED, DIRECTIONS, JOINT, arguments, f32, facing

POINTS, SLOW_POINTS = 320, 24
STEPS = 5  # of equal ratio between the smallest and the largest
DENORMAL = 1e-40  # a float32 too small for all its digits
TURNS = {  # where formulas change their branch, inside the range
    "eta": (1.0, 1 - 2.0**-24, 1 + 2.0**-23, 1.0001), "theta": (PI / 2, PI / 2 - 1e-4, PI / 2 + 1e-4),
    "half_angle": (PI / 2,), "cosine": (0.0,), "exponent": (1.0, 2.0), "l_dot_h": (1 / 7,), "slope2": (1.0,),
    "linear": (0.0031308,), "encoded": (0.04045,), "theta_h": (PI / 4,), "normal_length": (0.999999,),
}
# Sums of thousands of terms
SLOW = {"sun_share", "reflected_radiance_sum", "albedo_ggx", "reflected_radiance", "facet_area", "albedo_geometry",
        "hemisphere_meter", "schlick_worst", "paint_measured",
        "albedo_smith", "irradiance_light_sampled", "weak_furnace", "weak_furnace_rational"}


@cache
def ladder(name: str) -> tuple:
    """The values of a quantity that are tried, in order, as float32 keeps them."""
    q = TABLE[name]
    low, high = q.extreme or (q.low, q.high)
    usual = q.default if not isinstance(q.default, tuple) else q.low
    if q.kind == "int":
        few = range(int(low), int(high) + 1) if high - low < 12 else (low, q.low, q.high, high, usual, 2 * q.low)
        return tuple(sorted({int(x) for x in few if low <= x <= high}))
    top = max(abs(low), abs(high))
    bottom = low if low > 0 else min(abs(q.low) or top, top, 1.0) * 1e-7
    found = {low, high, q.low, q.high, usual, *TURNS.get(name, ())}
    found |= {float(np.nextafter(np.float32(end), np.float32(to))) for end, to in ((low, high), (high, low))}
    steps = np.geomspace(bottom, top, STEPS + 2)[1:-1]
    found |= {*steps, *(-steps if low < 0 else ())}
    if low <= 0:
        found |= {0.0, DENORMAL} | ({-DENORMAL} if low < 0 else set())
    found = {float(np.nextafter(np.float32(x), np.float32(0))) if x in (PI, 2 * PI) else x for x in found}
    kept = {float(np.float32(x)) for x in found if low <= np.float32(x) <= high or x in (low, high)}
    return tuple(sorted(kept))


def draw(name: str, rng: np.random.Generator, count: int) -> np.ndarray:
    """A quantity's ladder, evenly and in random order; a vector's components each on their own."""
    q = TABLE[name]
    if name in DIRECTIONS:
        theta, phi = rng.choice((0, 1e-7, 1e-3, 0.5, 1.0, PI / 2 - 1e-6), count), rng.choice((0, 1e-6, 2.0, PI), count)
        return f32(direction(theta, phi))
    rungs = np.array(ladder(name))
    columns = [rng.permutation(np.resize(rungs, count)) for _ in range(q.width)]
    return columns[0] if q.width == 1 else np.stack(columns, -1)


def pairs(a: dict, rng: np.random.Generator) -> dict:
    """Unit vectors as they meet: along n, grazing, mirrored, l = v, l = -v, and h about m from n."""
    count = len(next(iter(a.values())))
    a = facing(a, rng)
    if not {"l", "v"} <= a.keys():
        return a
    theta = rng.choice((0, 1e-7, 1e-3, 0.7, 1.5, PI / 2 - 1e-6, PI / 2), (2, count))
    phi = rng.choice((0, 1e-6, PI), count)
    v, l = direction(theta[0], 0 * phi), direction(theta[1], phi)
    kind = rng.integers(0, 4, (count, 1))
    l = np.where(kind == 1, v * (-1, -1, 1), np.where(kind == 2, -v, l))
    extreme = rng.random((count, 1)) < 0.5
    n = np.array([0.0, 0.0, 1.0])
    found = {"n": n, "v": v, "l": l}
    return a | {name: f32(np.where(extreme, found[name], a[name])) for name in found.keys() & a.keys()}


def points(name: str, count: int = 0) -> dict:
    """The arguments of a twin over its extremes: the same every time."""
    rng = np.random.default_rng(sum(map(ord, name)))
    a = arguments(name, rng, count or (SLOW_POINTS if name in SLOW or name in COUNTED else POINTS), draw)
    return pairs(a, rng) if JOINT.get(name) is facing else a


def varying(args: dict) -> dict[str, np.ndarray]:
    """The axes of a heat map: arguments that differ from point to point; of unit vectors their angles from n, or of
    the first two where there is no n, of other vectors their lengths."""
    single = {name: np.asarray(x, float) for name, x in args.items() if name in TABLE and TABLE[name].width == 1}
    count = max((len(x) for x in single.values() if x.ndim), default=0)
    vectors = {name: np.asarray(x, float) for name, x in args.items() if name in TABLE and TABLE[name].width > 1}
    count = count or max(map(len, vectors.values()), default=0)
    found = {name: x for name, x in single.items() if x.shape == (count,)}
    for name, x in vectors.items():
        if name not in FROM_ANGLES:
            found[f"|{name}|"] = np.linalg.norm(x, axis=-1)
        elif name != "n" and "n" in vectors:
            found[f"angle of {name}"] = apart(x, vectors["n"])
    if {"l", "v"} <= vectors.keys():
        found["angle of l and v"] = apart(vectors["l"], vectors["v"])
    return {name: np.broadcast_to(x, (count,)) for name, x in found.items()}
