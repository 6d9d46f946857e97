"""How far a computed value may lie from the true one: |x - x_ref| <= 8 u (1 + cond + kappa) |x_ref|.

u is half the distance of 1 to the next number of the type. cond is the relative condition number: inputs off by u each
move the value by up to cond u, so rounding the inputs alone costs that much. kappa is how many times larger the terms
of a sum are than the sum itself, or what it costs to round a step on the way; only the functions of TERMS have one.
"""

from collections.abc import Callable
from functools import partial

import numpy as np

from app.optics import twin
from app.optics.blinn_phong import _flux as _blinn_flux
from app.optics.bounces import _bounced_terms, _lost_terms
from app.optics.cook_torrance import _l_dot_h
from app.optics.ies import _aimed, _falloff, _meter
from app.optics.leave_out import _FLOOR
from app.optics.ndf import _rings, d_at
from app.optics.outline import _fan as _outline_fan
from app.optics.projected_solid_angle import _above_horizon
from app.optics.scale_effect import _variances
from app.optics.solid_angle_flat import _dot, _fan
from app.optics.spherical import direction
from app.quantities import TABLE

U = {"float64": 2.0**-53, "float32": 2.0**-24}
FACTOR = 8.0
STEP = 2.0**-24  # of the differences: the change that rounding to float32 makes
CONSTANT = ("triangles", "table", "roughness_map")  # data, not inputs: they are given as they are
SMALLEST = {"float64": 1000 * 2.0**-1022, "float32": 1000 * 2.0**-126}  # below: compared absolutely
LARGEST = {"float64": 2.0**1023, "float32": 2.0**127}  # beyond: the type has no number for it, and infinite is right


def norm(value: np.ndarray, is_vector: bool) -> np.ndarray:
    value = np.asarray(value, float)
    return np.sqrt(np.sum(value * value, -1)) if is_vector else np.abs(value)


def moved(function: str | Callable, args: dict, is_vector: bool = False) -> np.ndarray:
    """cond |f|: by how much f moves, in units of the change, when every input moves; central differences in float64.

    A scalar moves by its own size, a component of a vector by the size of the vector: which axis is x does not matter.
    """
    f = twin(function) if isinstance(function, str) else function
    total = np.zeros_like(norm(f(**args), is_vector))
    for name, given in args.items():
        x = np.asarray(given)
        if x.dtype.kind != "f" or name in CONSTANT:
            continue
        for step in steps(name, x):
            with np.errstate(invalid="ignore"):  # an infinite value
                change = f(**args | {name: x + step}) - f(**args | {name: x - step})
            total = total + norm(change, is_vector) / (2 * STEP)
    return total


def steps(name: str, x: np.ndarray):
    """The changes of an argument to try: of a scalar at once, of a vector or of corners component by component."""
    axes = 2 if name == "corners" else 1 if name in TABLE and TABLE[name].width > 1 else 0
    if axes == 0:
        yield STEP * x
        return
    size = np.sqrt(np.sum(x * x, -1, keepdims=True))
    for place in np.ndindex(x.shape[x.ndim - axes:]):
        mask = np.zeros(x.shape[x.ndim - axes:])
        mask[place] = 1.0
        yield STEP * size * mask


def _contour_terms(corners, corner_count):
    p = _above_horizon(corners, corner_count)
    q = np.roll(p, -1, -2)
    c = np.cross(p, q - p)
    size = np.sqrt(_dot(c, c))
    return np.sum(np.abs(c[..., 2]) / np.where(size > 0, size, 1) * np.arctan2(size, _dot(p, q)), -1) / 2


def _rectangle_terms(x0, x1, y0, y1, distance):
    x0, x1, y0, y1, d = np.broadcast_arrays(x0, x1, y0, y1, distance)
    corners = ((x0, y0), (x1, y0), (x1, y1), (x0, y1))
    return _contour_terms(np.stack([np.stack([x, y, d], -1) for x, y in corners], -2), 4)


def _patch_terms(theta, distance, tilt, width):
    around = ((0, 0), (1, 0), (1, 1), (0, 1))
    corners = [twin("patch_point")(theta, 0, distance, tilt, width, s, t) for s, t in around]
    return _contour_terms(np.stack(corners, -2), 4)


def _sphere_terms(radius, distance, theta):
    s, mu = radius / distance, np.cos(theta)
    cut = (np.abs(mu) < s) & (s < 1)
    z = np.sqrt(np.where(cut, (s - mu) * (s + mu) / ((1 - s) * (1 + s)), 0))
    return np.where(cut, s * s * z + np.abs(z - np.arctan(z)) + np.abs(mu) * s * s * np.arctan2(z, -mu), 0)


def _disk_terms(radius, height, offset):
    return np.where((np.hypot(height, offset) <= 2 * radius) & (offset <= radius), 2 * np.pi, 0)


def _polygon_terms(corners, corner_count):
    return np.sum(np.abs(twin("solid_angle_triangle_signed")(*_fan(corners, corner_count))), -1)


def _mesh_terms(triangles, eye):
    a, b, c = np.moveaxis(np.asarray(triangles, float), 1, 0)
    faces = {"a": a, "b": b, "c": c, "eye": np.asarray(eye, float)[..., None, :]}
    return np.sum(np.abs(twin("solid_angle_face")(**faces)) + moved("solid_angle_face", faces), -1)


def _outline_terms(corner_count, size, distance, x, y, **corners):
    faces, used = _outline_fan(tuple(corners.values()), corner_count, size, distance, x, y)
    return np.sum(np.where(used, np.abs(twin("solid_angle_face")(**faces)) + moved("solid_angle_face", faces), 0), -1)


def _ratio_terms(distance, tilt, width):
    near, far = ({"distance": x, "tilt": tilt, "width": width} for x in (distance, 2 * distance))
    f, value = twin("solid_angle_patch"), twin("solid_angle_patch_ratio")(distance, tilt, width)
    return value * sum(1 + moved("solid_angle_patch", args) / f(**args) for args in (near, far))


def _towards_terms(table, way, turn, aim):
    """The direction passes through its angles: at the end of a beam rounding them costs more than rounding the way."""
    theta, phi = _aimed(way, turn, aim)
    return moved("ies_candela", {"table": table, "theta": theta, "phi": phi})


def _illuminance_terms(table, way, normal, turn, aim):
    return _towards_terms(table, way, turn, aim) * _falloff(way, normal)


def _room_terms(table, height, setback, turn, aim, meter_x, meter_s):
    return _illuminance_terms(table, *_meter(height, setback, meter_x, meter_s), turn, aim)


def _piece_terms(sky_piece, radiance, opening, theta):
    size, piece = np.sin(opening), np.asarray(sky_piece)
    disk, window = _sphere_terms(size, 1.0, theta), _patch_terms(theta, 1.0, 0.0, 2 * size)
    return radiance * np.select([piece == 1, piece == 2], [disk, window], 0.0)


def _panel_terms(corner_count, radiance, position, **panel):
    """Its corners are rounded before their sum is taken: beside a long, thin panel that costs more than the sum."""
    count = np.asarray(corner_count)
    at = [twin("outline_at")(count, np.minimum(i, count - 1)) for i in range(5)]
    corners = [twin("panel_point")(**panel, s=s, t=t) - position for s, t in (np.moveaxis(p, -1, 0) for p in at)]
    args = {"corners": np.stack(np.broadcast_arrays(*corners), -2), "corner_count": count}
    return radiance * (_contour_terms(**args) + moved("projected_solid_angle_polygon", args))


def _light_terms(light_shape, radiance, position, **panel):
    shape, way = np.asarray(light_shape), -np.asarray(position, float)
    way = way + np.stack([panel[k] for k in ("light_x", "light_y", "light_height")], -1)
    aside = np.hypot(way[..., 0], way[..., 1])
    sphere = _sphere_terms(0.5 * panel["panel_width"], np.hypot(aside, way[..., 2]), np.arctan2(aside, way[..., 2]))
    flat = _panel_terms(np.where(shape == 3, 5, 4), radiance, position, **panel)
    return np.choose(shape, [flat, np.zeros_like(flat), radiance * sphere, flat])


def _point_error_terms(light_shape, light_height, panel_width, panel_tilt):
    """A difference of two lights over the brightest place: as large as what is rounded in them."""
    shape, height, width, tilt = (np.repeat(np.asarray(x)[..., None], len(_FLOOR), -1)
                                  for x in (light_shape, light_height, panel_width, panel_tilt))
    zero = np.zeros(width.shape)
    light = {"light_shape": shape, "radiance": 1.0, "light_x": zero, "light_y": zero, "light_height": height,
             "panel_width": width, "panel_depth": width, "panel_tilt": tilt, "position": _FLOOR}
    value = twin("irradiance_light")(**light)
    terms = value + moved("irradiance_light", light) + _light_terms(**light)
    brightest = np.max(value, -1)
    return 2 * np.max(terms, -1) / np.where(brightest > 0, brightest, 1)


def _spherical_rectangle_terms(**args):
    """1 - w^2 of a point far to the side: its terms, 1 and w^2, over what is left."""
    point = twin("spherical_rectangle_point")(**args)
    return norm(point, True) * 2 * (1 + (point[..., 0] / point[..., 2]) ** 2)


def _strip_terms(strip, y0, y1, distance):
    x = twin("strip_end")(strip, y0, y1, distance)
    return np.abs(x) * 2 * (1 + (x / distance) ** 2)


def _f82_terms(l_dot_h, f0, f82):
    schlick = twin("f_schlick")
    bend = 7 * (7 / 6) ** 6 * (schlick(1 / 7, f0) + f82) * l_dot_h * (1 - l_dot_h) ** 6
    return schlick(l_dot_h, f0) + bend


def _below_terms(given, amount, light_shape, light_height, panel_width, panel_depth, panel_tilt):
    radiance = twin("light_radiance")(given, amount, light_shape, panel_width, panel_depth)
    zero = np.zeros_like(light_height)
    return _light_terms(light_shape, radiance, np.zeros(3), light_x=zero, light_y=zero, light_height=light_height,
                        panel_width=panel_width, panel_depth=panel_depth, panel_tilt=panel_tilt)


def _shifted_terms(function, position, **args):
    """A sample's place on the panel is rounded: as far as the panel is wide, however near the point is."""
    size, total = STEP * np.maximum(args["panel_width"], args["panel_depth"]), 0.0
    for axis in np.eye(3):
        near, far = (twin(function)(position=position + way * size[..., None] * axis, **args) for way in (-1, 1))
        total = total + np.abs(far - near) / (2 * STEP)
    return total


def _albedo_terms(theta_v, m, f0):
    """l.h is rounded, and with it 1 - l.h: 5 int (1 - l.h)^4, which Hölder's inequality bounds by the integrals with no
    power and with the fifth."""
    white, edge = (twin("albedo_cook_torrance")(theta_v, m, x) for x in (1.0, 0.0))
    return f0 * white + (1 - f0) * (edge + 5 * white**0.2 * np.maximum(edge, 0) ** 0.8)


def _index_terms(theta, material, channel):
    """The index that a table has is rounded: what that moves, of an insulator near an index of 1."""
    eta, c = twin("material_eta")(material), np.maximum(0.0, np.cos(theta))
    near, far = (twin("f_dielectric")(c, eta * (1 + step)) for step in (-STEP, STEP))
    return np.abs(far - near) / (2 * STEP)


def _halfway_terms(n, l, v):
    """The lengths of l and v are rounded, then what is common to l and -v goes: n.l |v| + n.v |l| over |s|."""
    n, l, v = (np.asarray(x, float) for x in (n, l, v))
    s = l * norm(v, True)[..., None] + v * norm(l, True)[..., None]
    parts = np.abs(np.sum(n * l, -1)) * norm(v, True) + np.abs(np.sum(n * v, -1)) * norm(l, True)
    return parts / np.maximum(norm(s, True), 1e-300)


def _blinn_albedo_terms(theta_v, exponent):
    return twin("normalisation_blinn_phong")(exponent) * _blinn_flux(theta_v, exponent, 1)


def _sky_terms(function, glow=64):
    """Directions are rounded on the way: the sun's glow, a power of 128 of half an angle's cosine, moves by 64 u."""
    return lambda exponent, **args: np.abs(twin(function)(exponent=exponent, **args)) * (glow + exponent)


def _ones(**args):
    return np.ones(np.broadcast_shapes(*map(np.shape, args.values())))


def _facet_area_terms(ndf, m, rows, cosines):
    """Every ring's angle is rounded, and a narrow D with it."""
    ndf, a, m, _, weight = _rings(ndf, m, rows, cosines)
    change = d_at(ndf, a * (1 + STEP), m) - d_at(ndf, a * (1 - STEP), m)
    return np.sum(np.abs(change) / (2 * STEP) * weight, -1)


def _facet_terms(function, m, f0, **angles):
    """The directions of l and v are rounded before h is; 1 - l.h is a difference, all there is where f0 is near 0."""
    l, v = direction(angles["theta_l"], angles["phi"]), direction(angles["theta_v"], 0.0)
    white = twin(function)(**angles, m=m, f0=1.0)
    rounded = moved(function, {**angles, "m": np.asarray(m), "f0": np.asarray(f0)})
    return rounded + white * 5 * (1 - f0) * np.maximum(STEP, 1 - _l_dot_h(l, v)) ** 4


def _intercept_terms(facet, lean_v):
    """A quotient of two cosines, each of a rounded angle; near 90 degrees that costs much, and cancels in the value."""
    apart = facet - lean_v
    cost = np.abs(lean_v * np.tan(lean_v)) + np.abs(apart * np.tan(apart))
    return np.abs(twin("groove_intercept_printed")(facet, lean_v)) * cost


def _crease_terms(theta_l, theta_v, phi):
    """The next of the three terms is the least plus the gap; both move with the cosines."""
    share = {"theta_l": theta_l, "theta_v": theta_v, "phi": phi}
    return twin("crease_gap")(**share) + 2 * twin("vgroove_at")(**share) + moved("vgroove_at", share)


def _bump_terms(m, bump_slope):
    """Of the variance, over twice the root of it: near m = 0.7 the spread of a bump's slope hardly changes D."""
    value, (facets, slopes) = twin("aliasing_error")(m, bump_slope), _variances(m, bump_slope)
    terms = slopes**2 / (facets * (facets + 2 * slopes)) + 4 * slopes * slopes / (facets + slopes)
    return terms / np.where(value > 0, 2 * value, 1)


def _worth_terms(m, bump_slope):
    """Each of the two errors is rounded: their condition numbers cancel in the quotient."""
    args = {"m": m, "bump_slope": bump_slope}
    single, one = twin("aliasing_error")(m, bump_slope), twin("filter_error")(m, bump_slope)
    either = (moved("aliasing_error", args) + _bump_terms(m, bump_slope)) / np.where(single > 0, single, 1)
    return 2 * twin("samples_worth")(m, bump_slope) * (either + moved("filter_error", args) / one)


def _stored_terms(power, function, roughness_map, map_s, map_t):
    """The roughness of a map is rounded, then decoded: what a power of 2.4 makes of that, `power` times."""
    return power * 3.4 * twin(function)(roughness_map, map_s, map_t)


def _ball_terms(bumps, bump_slope, m, samples, filtering):
    """Differences of shares of white, each of them 1 at most; and a wave's turns, 0.63 bumps of them, are rounded: that
    moves a slope of twice bump_slope by 2 pi bump_slope a turn, and D by twice the slope over m^2."""
    return 1 + 0.37 * 2 * (2 * bump_slope) * (2 * np.pi * bump_slope) * 0.63 * bumps / m**2


TERMS: dict[str, Callable] = {  # the sum of the absolute values of the terms of functions whose terms can cancel
    "albedo_blinn_phong": _blinn_albedo_terms,
    "aliasing_error": _bump_terms,
    "ball_error": _ball_terms,
    # a power of 2.4 is rounded before it divides: its condition number cancels in the quotient
    "srgb_gap": lambda encoded: 3.4 * twin("srgb_gap")(encoded),
    "peak_gain": lambda encoded: 6.8 * twin("peak_gain")(encoded),
    "roughness_as_srgb": partial(_stored_terms, 1, "roughness_as_srgb"),
    "peak_gain_at": partial(_stored_terms, 2, "peak_gain_at"),
    "sampling_error": lambda samples, m, bump_slope: _bump_terms(m, bump_slope) / np.sqrt(samples),
    "samples_worth": _worth_terms,
    "halfway_cosine": _halfway_terms,
    "lobe_flux_blinn": lambda theta_v, exponent: _blinn_flux(theta_v, exponent, 1),
    "irradiance_lamp": lambda radiant_flux, radius, distance, theta: (
        radiant_flux / (2 * np.pi * radius) ** 2 * _sphere_terms(radius, distance, theta)),
    "irradiance_light": _light_terms,
    "irradiance_light_64": partial(_shifted_terms, "irradiance_light_64"),
    "point_light_error": _point_error_terms,
    "point_lights_error": lambda **lamp: np.max([
        _point_error_terms(np.full(np.shape(lamp["panel_width"]), kind), **lamp) for kind in range(4)], 0),
    "irradiance_outline": _panel_terms,
    "light_irradiance_below": _below_terms,
    "irradiance_polygon_light": lambda radiance, corners, corner_count: (
        radiance * _contour_terms(corners, corner_count)),
    "irradiance_sphere_light": lambda radiance, radius, distance, theta: (
        radiance * _sphere_terms(radius, distance, theta)),
    "projected_solid_angle_polygon": _contour_terms,
    "projected_solid_angle_rectangle": _rectangle_terms,
    "projected_solid_angle_patch": _patch_terms,
    "projected_solid_angle_sphere": _sphere_terms,
    "ies_towards": _towards_terms,
    "ies_illuminance": _illuminance_terms,
    "ies_room_illuminance": _room_terms,
    "solid_angle_disk": _disk_terms,
    "solid_angle_polygon": _polygon_terms,
    "solid_angle_outline": _outline_terms,
    "solid_angle_patch_ratio": _ratio_terms,
    "solid_angle_mesh": _mesh_terms,
    "irradiance_sphere": lambda radiance, radius, distance, theta: radiance * _sphere_terms(radius, distance, theta),
    "irradiance_piece": _piece_terms,
    "irradiance_sensor": lambda radiance, half_angle, theta: radiance * _sphere_terms(np.sin(half_angle), 1.0, theta),
    "radiant_energy_sensor": lambda radiance, patch_area, half_angle, theta, duration: (
        radiance * patch_area * duration * _sphere_terms(np.sin(half_angle), 1.0, theta)),
    "radiant_flux_sensor": lambda radiance, patch_area, half_angle, theta: (
        radiance * patch_area * _sphere_terms(np.sin(half_angle), 1.0, theta)),
    "radiance_sensor": lambda radiance, patch_area, half_angle, theta: (
        radiance * _sphere_terms(np.sin(half_angle), 1.0, theta)
        / np.abs(twin("solid_angle_cone")(half_angle) * np.cos(theta))),
    "spherical_rectangle_point": _spherical_rectangle_terms,
    "strip_end": _strip_terms,
    "hemisphere_meter": _sky_terms("hemisphere_meter", 0),
    **{name: _sky_terms(name) for name in ("reflected_radiance", "reflected_radiance_sum", "sun_share")},
    **{name: partial(_facet_terms, name) for name in (
        "cook_torrance_at", "cook_torrance_printed_at", "cook_torrance_smith_at")},
    "albedo_ggx": lambda **args: 8 * twin("albedo_ggx")(**args),  # 18000 terms, each at its own angles
    "albedo_cook_torrance": _albedo_terms,  # 1440 terms, each at its own angle
    "albedo_cook_torrance_printed": lambda **args: 4 / np.pi * _albedo_terms(**args),
    "irradiance_light_without_cosine": partial(_shifted_terms, "irradiance_light_without_cosine"),
    "material_share": _index_terms,
    "f_conductor": _ones, "bounced_light_error": _ones,  # r_s, r_p; pieces of the azimuth
    "f_f82": _f82_terms,
    "schlick_worst": lambda material: np.ones(np.shape(material)),  # the difference of two shares
    "facet_area": _facet_area_terms, "facets_lost": _lost_terms, "bounced_light": _bounced_terms,
    "groove_intercept_printed": _intercept_terms,
    "crease_gap": _crease_terms,
    # the seen area and Smith's share of it, each rounded: their condition numbers cancel in the product
    **dict.fromkeys(("weak_furnace", "weak_furnace_rational", "albedo_smith", "albedo_geometry"), _ones),
    "winding_number": lambda triangles, eye: _mesh_terms(triangles, eye) / (4 * np.pi),
}


def closed_form_terms(function: str, args: dict) -> np.ndarray | float:
    """What the float64 twin's own form cancels by, where GLSL sums positive terms."""
    if not function.startswith("albedo_cook_torrance"):
        return 0.0
    return twin(function)(**args | {"f0": 1.0}) / np.maximum(np.cos(args["theta_v"]), 1e-7)


def cost(function: str, args: dict, is_vector: bool = False, cond=None) -> np.ndarray:
    """(1 + cond + kappa) |value|: by how many u a value may be off, once each."""
    size = norm(twin(function)(**args), is_vector)
    found = size + (moved(function, args, is_vector) if cond is None else cond * size)
    return found + TERMS[function](**args) if function in TERMS else found


def off(value, got, cost: np.ndarray, precision: str = "float32", is_vector: bool = False) -> np.ndarray:
    """|got - value| in units of u cost.

    A value too small for the type counts 0 when the other is as small, and infinite when it is not; where the value is
    too large for it, infinite of the same sign counts 0.
    """
    size, smallest = norm(value, is_vector), SMALLEST[precision]
    with np.errstate(all="ignore"):
        got = np.where((np.abs(value) > LARGEST[precision]) & np.isinf(got), np.sign(got) * np.abs(value), got)
        apart = norm(np.where(value == got, 0.0, got - value), is_vector)
        found = np.where(cost < smallest, np.where(apart <= 2 * smallest, 0.0, np.inf),
                         np.where(apart == 0, 0.0, apart / (U[precision] * cost)))
        found = np.where((size < smallest) & (apart < smallest), 0.0, found)
    return np.where(np.isnan(found), np.inf, found)


def ratio(function: str, args: dict, got, precision: str = "float32", is_vector: bool = False, cond=None) -> np.ndarray:
    """How far a value is from the float64 twin's at the same inputs, in units of u (1 + cond + kappa) |value|."""
    value = np.asarray(twin(function)(**args), float)
    return off(value, np.asarray(got, float), cost(function, args, is_vector, cond), precision, is_vector)
