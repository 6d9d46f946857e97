"""What a twin may be given: numbers within `quantities`, arguments that belong together, a mesh, a table.

Drawn at random here; app/stress/grid.py puts every argument to its extremes. Both keep to JOINT: a rectangle's left
edge is left of its right one, directions have length 1, what is divided by is not 0.
"""

from collections.abc import Callable

import numpy as np

from app import optics, shader
from app.optics.facets import _ring
from app.quantities import TABLE
from app.tables import built_in

POINTS = 400
DIRECTIONS = {"n", "l", "v", "h", "to_sun"}  # unit vectors
# Steps: a ray at the rim may fall on either side. How many rays are 1, of those that give not their number itself
COUNTED = {"solid_angle_patch_counted": lambda a: a["samples"] / (4 * np.pi), "meets_patch": None,
           "groove_blocked": None, "groove_hidden_counted": lambda a: a["samples"],
           "groove_open_counted": lambda a: a["samples"], "facets_lit": None,
           "d_near": lambda a: a["facets"] * np.pi * np.sin(a["half_angle"]) ** 2,
           "d_counted": lambda a: a["facets"] * _ring(a["theta_h"], a["half_angle"])}


def f32(x):
    return np.asarray(x, np.float32).astype(float)


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
    if name in DIRECTIONS:
        value = value / np.linalg.norm(value, axis=-1, keepdims=True)
    return np.rint(value).astype(int) if q.kind == "int" else value.astype(np.float32).astype(float)


def planar(rng: np.random.Generator) -> np.ndarray:
    """(5, 3): a convex polygon, off the axis, of a size between 1e-3 and 3 at a distance near 1."""
    around = np.sort(rng.uniform(0, 2 * np.pi, 5))
    axes, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    flat = 10 ** rng.uniform(-3, 0.5) * np.stack([np.cos(around), np.sin(around), np.zeros(5)], -1)
    return (flat @ axes.T + 1.5 * axes[2]).astype(np.float32).astype(float)


def in_order(a: dict, rng) -> dict:
    x, y = (np.sort([a[k + "0"], a[k + "1"]], 0) for k in "xy")
    return a | {"x0": x[0], "x1": x[1], "y0": y[0], "y1": y[1]}


def beside(a: dict, rng) -> dict:
    low = np.abs(a["x0"])
    high = np.nextafter(f32(low + a["width"]).astype(np.float32), np.float32(np.inf)).astype(float)
    return a | {"x0": low, "x1": high, "width": f32(high - low)}


def nearest_first(a: dict, rng) -> dict:
    """Edges shorter than the way to the corner: elsewhere their sum may cancel."""
    for edge in ("ab", "ac"):
        size, length = (np.linalg.norm(a[name], axis=-1) for name in ("a", edge))
        a = a | {edge: f32(a[edge] * np.minimum(1, 0.4 * size / np.maximum(length, 1e-30))[:, None])}
    return a


def shrunk(a: dict, rng) -> dict:
    """Half of the triangles are small beside their distance."""
    scale = np.where(rng.random(len(a["a"])) < 0.5, 1.0, 10 ** rng.uniform(-5, 0, len(a["a"])))[:, None]
    return a | {name: f32(a["a"] + scale * (a[name] - a["a"])) for name in ("b", "c")}


def between_the_poles(a: dict, rng) -> dict:
    return a | {"d_theta": f32(np.minimum(a["d_theta"], 2 * np.minimum(a["theta"], np.pi - a["theta"])))}


def with_its_area(a: dict, rng) -> dict:
    a = shrunk(a, rng)
    return a | {"area": f32(np.cross(a["b"] - a["a"], a["c"] - a["a"]))}


def below_samples(a: dict, rng) -> dict:
    return a | {"index": a["index"] % a["samples"]}


def unit(a: dict, rng) -> dict:
    return a | {"towards": f32(a["towards"] / np.linalg.norm(a["towards"], axis=-1, keepdims=True))}


def up_to_a_hemisphere(a: dict, rng) -> dict:
    """An opening no wider than what a surface sees."""
    return a | {"half_angle": f32(np.minimum(a["half_angle"], 1.57))}


def shares(a: dict, rng) -> dict:
    """What is scattered and what is mirrored come out of the same light."""
    return a | {"k_d": f32(np.minimum(a["k_d"], np.nextafter(f32(1 - a["k_s"]).astype("f4"), np.float32(0))))}


def in_front(a: dict, rng) -> dict:
    """A rectangle, its far end at most 30 distances to the side."""
    a = a | {name: a[name] + 1e-3 for name in ("x1", "y1") if name in a}
    used = set(a)
    a = in_order({"x0": a["y0"], "x1": a["y1"]} | a, rng)
    ends = [a[k] for k in ("x", "x0", "x1", "y0", "y1") if k in a]
    a = a | {"distance": f32(np.maximum(a["distance"], np.max(np.abs(ends), 0) / 30))}
    return {name: a[name] for name in a if name in used}


def with_an_end(a: dict, rng) -> dict:
    """A solid angle that a part of the strip has."""
    a = in_front(a | {"x": draw("x", rng, len(a["distance"]))}, rng)
    return {"strip": f32(optics.twin("strip_angle")(**{k: a[k] for k in ("x", "y0", "y1", "distance")}))} | {
        k: a[k] for k in ("y0", "y1", "distance")}


def not_along_the_light(a: dict, rng) -> dict:
    """Even in solid angle only where no part of a flat light is seen more than ten times as far aside as in front, and
    none where a sample may fall on the rim of its shape: that is counted, below."""
    view = ("light_x", "light_y", "light_height", "panel_tilt", "position")
    seen = np.abs(optics.twin("panel_view")(**{k: a[k] for k in view}))
    aside = np.maximum(seen[:, 0] + a["panel_width"], seen[:, 1] + a["panel_depth"])
    by_area = (a["light_shape"] != 2) & ((aside > 10 * seen[:, 2]) | (a["light_shape"] > 0))
    a = a | {"sampling": np.where(by_area, a["sampling"] % 4, a["sampling"])}
    return a | {"index": a["index"] % 4 ** a["level"]} if "index" in a else a


def of_its_level(a: dict, rng) -> dict:
    return a | {"index": a["index"] % 4 ** a["level"]}


def of_its_rule(a: dict, rng) -> dict:
    return a | {"index": a["index"] % 2 ** a["level"]}


def with_a_normal(a: dict, rng) -> dict:
    return a | {"normal": f32(a["normal"] / np.linalg.norm(a["normal"], axis=-1, keepdims=True))}


def not_too_near(a: dict, rng) -> dict:
    """The corners of the square are known to u times its width: its plane may not pass the eye much closer."""
    return a | {"width": f32(np.minimum(a["width"], 1e3 * a["distance"] * np.abs(np.cos(a["tilt"]))))}


def opened(a: dict, rng) -> dict:
    """A cone that is neither shut nor flat: what is divided by its solid angle, or reaches to a wall."""
    return a | {"half_angle": f32(np.clip(a["half_angle"], 1e-4, 1.5))}


def half_reached(a: dict, rng) -> dict:
    """Indices with an angle at which half is reflected, and not of nearly nothing."""
    return a | {"eta": f32(np.clip(a["eta"], 1.01, 5.0))}


def not_along_the_surface(a: dict, rng) -> dict:
    """Light that arrives: what leaves is taken over it."""
    return a | {"theta_l": f32(np.minimum(a["theta_l"], 1.55))}


def no_narrower_than_the_nodes(a: dict, rng) -> dict:
    """A lobe that the nodes of a fixed quadrature can see."""
    return a | {"exponent": f32(np.minimum(a["exponent"], 200.0))}


def few_and_not_too_many(a: dict, rng) -> dict:
    """Forty pictures, each ten times: each looks at 25 thousand places. No facets as steep as the rim."""
    a = a | {"m": np.clip(a["m"], f32(0.05), f32(0.5)), "samples": np.minimum(a["samples"], 64)}
    a = a | {"bumps": np.minimum(a["bumps"], 300.0)}
    return {name: np.tile(given[:POINTS // 10], 10) for name, given in a.items()}


def facing(a: dict, rng) -> dict:
    """Unit vectors on the same side, three in four so that h is about m from n, where the lobe is."""
    count = len(next(iter(a.values())))
    width = np.clip(a.get("m", a.get("alpha", np.ones(count))), 1e-5, 1.0)[:, None]
    flat = rng.random((count, 1)) < 0.25

    def towards(n, spread):
        x = n + np.where(flat, rng.uniform(-1, 1, (count, 3)), spread * rng.normal(size=(count, 3)))
        return x / np.linalg.norm(x, axis=-1, keepdims=True)

    n = towards(np.array([0.0, 0.0, 1.0]), 0.5)
    v = towards(n, 1.0)
    h = towards(n, width)
    found = {"n": n, "v": v, "h": h, "l": 2 * np.sum(h * v, -1, keepdims=True) * h - v}
    return a | {name: f32(found[name]) for name in a if name in found}


def mirrored(a: dict, rng) -> dict:
    """Half of the lights near the mirror direction, none behind the surface."""
    near = rng.random(len(a["theta_v"])) < 0.5
    theta = np.clip(a["theta_v"] + a["m"] * rng.normal(size=len(near)), 0, np.pi / 2)
    return a | {"theta_l": f32(np.where(near, theta, a["theta_l"])), "phi": f32(np.where(near, np.pi, a["phi"]))}


def of_a_ring(a: dict, rng) -> dict:
    return a | {"half_angle": f32(np.clip(a["half_angle"], 0.003, 0.5))}


def of_the_facets(a: dict, rng) -> dict:
    return a | {"index": a["index"] % a["facets"]}


def a_lamp_above(a: dict, rng) -> dict:
    """A cone of some width that the horizon does not cut."""
    half = np.clip(a["half_angle"], 1e-3, 1.2)
    return a | {"half_angle": f32(half), "theta_l": f32(np.minimum(a["theta_l"], 1.5 - half))}


def above_the_floor(a: dict, rng) -> dict:
    """Globes that hang free, seen from within a room: from afar the cosine of their slant is rounding."""
    near = {name: f32(np.clip(a[name], -4, 4)) for name in ("from_wall", "along_wall")}
    return a | near | {"source_radius": f32(np.minimum(a["source_radius"], 0.5))}


def mirrored_by_some(a: dict, rng) -> dict:
    """Facets that mirror something head-on: else F is 1 - l.h to the fifth, and that is rounded before."""
    spread = mirrored({"m": draw("m", rng, len(a["phi"]))} | a, rng)
    return {name: spread[name] for name in a} | {"f0": f32(np.maximum(a["f0"], 1e-3))}


def off_the_horizon(a: dict, rng) -> dict:
    """An angle below 90 degrees, and a share mirrored head-on: both are divided by."""
    return a | {"theta": f32(np.minimum(np.abs(a["theta"]), 1.5)), "f0": f32(np.maximum(a["f0"], 1e-3))}


def wider_than_a_step(a: dict, rng) -> dict:
    """Facets wide enough that float32 knows where in their lobe a bump lies."""
    return a | {"m": f32(np.maximum(a["m"], 0.05)), "facets": np.minimum(a["facets"], 3000)}


JOINT = {  # arguments that belong together
    "ball_error": few_and_not_too_many,
    "d_bumps_counted": wider_than_a_step,
    "dg_at": mirrored,
    "dgf_at": mirrored_by_some,
    "schlick_at": mirrored_by_some,
    "mirror_gain": off_the_horizon,
    "brdf_geometry": facing,
    **dict.fromkeys(("brdf_cook_torrance", "brdf_cook_torrance_printed", "brdf_cook_torrance_smith", "brdf_ggx",
                     "brdf_file", "brdf_gltf", "cook_torrance_dg", "d_beckmann", "d_blinn_phong", "d_gauss", "d_ggx",
                     "pdf_beckmann", "pdf_ggx", "shading_gltf", "slope_squared"), facing),
    **dict.fromkeys(("cook_torrance_at", "cook_torrance_printed_at", "cook_torrance_smith_at"), mirrored),
    "angle_of_half": half_reached,
    "irradiance_absorbed": shares,
    **dict.fromkeys(("irradiance_sensor", "radiant_flux_sensor", "radiant_energy_sensor"), up_to_a_hemisphere),
    "d_counted": of_a_ring,
    "d_halfway": mirrored,
    "d_near": of_a_ring,
    "facet_normal": of_the_facets,
    "facet_slope": of_the_facets,
    "fibonacci_direction": below_samples,
    "hemisphere_meter": no_narrower_than_the_nodes,
    "ies_ring_flux": between_the_poles,
    "gauss_node": of_its_rule,
    "gauss_sample": of_its_level,
    "highlight_flux": not_along_the_surface,
    "grid_sample": of_its_level,
    "irradiance_at": with_a_normal,
    "irradiance_light_sampled": not_along_the_light,
    "light_piece": not_along_the_light,
    "light_sample": of_its_level,
    "paint_measured": a_lamp_above,
    "stratified_sample": of_its_level,
    "lamps_illuminance_by_area": above_the_floor,
    "meets_patch": unit,
    "radiance_sensor": opened,
    "radiance_sensor_projected": opened,
    "radiance_twice_as_far": opened,
    "radiant_intensity_cone": opened,
    "projected_solid_angle_patch": not_too_near,
    "projected_solid_angle_rectangle": in_order,
    "reflected_radiance": no_narrower_than_the_nodes,
    "solid_angle_cell": between_the_poles,
    "solid_angle_corners": with_its_area,
    "solid_angle_face": shrunk,
    "solid_angle_rectangle_beside": beside,
    "solid_angle_rectangle_off_axis": in_order,
    "solid_angle_triangle": shrunk,
    "spherical_rectangle_point": in_front,
    "strip_across": in_front,
    "sun_share": no_narrower_than_the_nodes,
    "strip_angle": in_front,
    "strip_end": with_an_end,
    "solid_angle_triangle_edges": nearest_first,
    "solid_angle_triangle_signed": shrunk,
}


def arguments(name: str, rng: np.random.Generator, count: int = POINTS, values: Callable = draw) -> dict:
    """Arguments of a twin at `count` points; `values` (quantity, rng, count) gives those of one argument."""
    signature = shader.catalogue()[name][1]
    args = {}
    for arg in signature.args:
        if arg.name == "table":
            args[arg.name] = f32(built_in("corner").table)
        elif arg.name.endswith("_map"):
            args[arg.name] = rng.integers(60, 256, (7, 5, 4)).astype(np.uint8)
        elif arg.type == "sampler2D":
            args[arg.name] = f32(cube() + 0.25)
        elif arg.size:
            args[arg.name] = planar(rng)
        else:
            args[arg.name] = values(arg.name, rng, count)
    return JOINT.get(name.removesuffix("_naive"), lambda a, rng: a)(args, rng)
