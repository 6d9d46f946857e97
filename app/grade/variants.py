"""Wrong variants of the course's functions, as students write them: what each would return at the points asked.

VARIANTS[misconception][function] is one callable, or several ways to make the same mistake. All take the arguments of
the twin. A lecturer's own reference file may bring more: MISCONCEPTIONS = {"id": {"function": variant}}.
"""

import numpy as np
from numpy import pi

from app.optics import twin
from app.optics.colour import linear_to_srgb
from app.optics.phong import _dot
from app.quantities import TABLE


def scaled(function: str, by):
    """The twin times a factor, a number or a function of the arguments."""
    return lambda **a: times(twin(function)(**a), by(**a) if callable(by) else by)


def times(value, factor):
    return value * (factor[..., None] if np.ndim(factor) and np.ndim(value) > np.ndim(factor) else factor)


def changed(function: str, **new):
    """The twin with some arguments computed from all of them."""
    return lambda **a: twin(function)(**a | {name: compute(**a) for name, compute in new.items()})


# --- lobes -----------------------------------------------------------------------------------------------------------
def upper(n, l, v):
    return (_dot(n, l) > 0) & (_dot(n, v) > 0)


def blinn(lobe=None, factor=None, diffuse=1 / pi):
    """brdf_blinn_phong with another lobe, factor or diffuse part."""
    def variant(n, l, v, k_d, k_s, exponent):
        shape = lobe(n, l, v, exponent) if lobe else twin("lobe_blinn")(n, l, v, exponent)
        size = factor(exponent) if factor else twin("normalisation_blinn_phong")(exponent)
        return np.where(upper(n, l, v), k_d * diffuse + k_s * size * shape, 0.0)

    return variant


def phong_lobe(n, l, v, exponent):
    return twin("lobe_phong")(n, l, v, exponent)


def long_lobe(n, l, v, exponent):
    """h = l + v, not normalised: up to 2^exponent."""
    return np.maximum(_dot(n, np.asarray(l) + np.asarray(v)), 0.0) ** exponent


def reflected(l, n):
    """reflect(l, n) of GLSL: -r."""
    return -twin("reflection_vector")(n, l)


def wrong_side_lobe(n, l, v, exponent):
    return np.maximum(_dot(reflected(l, n), v), 0.0) ** exponent


def open_lobe(n, l, v, exponent):
    with np.errstate(invalid="ignore"):
        return _dot(twin("reflection_vector")(n, l), v) ** exponent


# --- facets ----------------------------------------------------------------------------------------------------------
def beckmann(exponent, norm=lambda m: pi * m * m):
    """exp(exponent(tan^2, sin^2, m)) / (norm c^4), 0 below the horizon."""
    def variant(n, h, m):
        c = _dot(n, h)
        across = np.cross(n, h)
        s2 = _dot(across, across)
        c2 = np.where(c > 0, c, 1.0) ** 2
        return np.where(c > 0, np.exp(np.minimum(exponent(s2 / c2, s2, m), 80.0)) / (norm(m) * c2 * c2), 0.0)

    return variant


def groove(shape):
    """shape(masking, shadowing) of g_vgroove, each a share without a bound."""
    def variant(n_dot_h, n_dot_v, n_dot_l, l_dot_h):
        with np.errstate(divide="ignore", invalid="ignore"):
            return shape(2 * n_dot_h * n_dot_v / l_dot_h, 2 * n_dot_h * n_dot_l / l_dot_h)

    return variant


def open_groove(shape):
    """shape(shown to the light, shown to the eye) of groove_open, each a share without a bound, 0 turned away."""
    def variant(facet, lean_l, lean_v):
        def shown(lean):
            facing = np.cos(facet - lean)
            return np.where(facing > 0, 2 * np.cos(facet) * np.cos(lean) / np.where(facing > 0, facing, 1), 0.0)

        return shape(shown(lean_v), shown(lean_l))

    return variant


def least(*x):
    return np.minimum.reduce([np.ones_like(x[0]), *x])


# --- lights ----------------------------------------------------------------------------------------------------------
def spot(off_axis, hotspot, falloff):
    """Without its clamp."""
    with np.errstate(divide="ignore", invalid="ignore"):
        return (np.cos(off_axis) - np.cos(falloff)) / (np.cos(hotspot) - np.cos(falloff))


def spot_backwards(off_axis, hotspot, falloff):
    return twin("spot_linear")(pi - np.asarray(off_axis), hotspot, falloff)


def point_light(flux_to_intensity, name):
    """Without the clamp of its cosine."""
    return lambda distance, theta, **a: flux_to_intensity(a[name]) * np.cos(theta) / distance**2


# --- unstable forms: right on paper ----------------------------------------------------------------------------------
def triangle_printed(a, b, c):
    """a . (b x c), in which small triangles cancel."""
    def dot(p, q):
        return np.sum(p * q, -1)

    x, y, z = (np.sqrt(dot(p, p)) for p in (a, b, c))
    volume = np.abs(dot(a, np.cross(b, c)))
    return 2 * np.arctan2(volume, x * y * z + dot(a, b) * z + dot(a, c) * y + dot(b, c) * x)


def lambda_printed(slope):
    return (np.sqrt(1 + slope * slope) - 1) / 2


def disk_printed(radius, height):
    return 2 * pi * (1 - height / np.sqrt(height * height + radius * radius))


def ring_printed(theta, d_theta, candela_below, candela_above):
    """The integral's ends subtracted."""
    low, high = theta - d_theta / 2, theta + d_theta / 2
    q = (candela_above - candela_below) / d_theta
    p = candela_below - q * low
    return 2 * pi * (p * (np.cos(low) - np.cos(high)) + q * (np.sin(high) - high * np.cos(high)
                                                             - np.sin(low) + low * np.cos(low)))


UNSTABLE = {  # judged by where it is wrong, not by its digits
    "d_beckmann": twin("d_beckmann_naive"),
    "solid_angle_triangle": triangle_printed,
    "solid_angle_cone": lambda half_angle: 2 * pi * (1 - np.cos(half_angle)),
    "solid_angle_sphere": lambda radius, distance: 2 * pi * (1 - np.sqrt(1 - (radius / distance) ** 2)),
    "solid_angle_disk_on_axis": disk_printed,
    "lambda_ggx_slope": lambda_printed,
    "ies_ring_flux": ring_printed,
    "spot_linear": lambda **a: np.where(a["hotspot"] >= a["falloff"], (a["off_axis"] <= a["falloff"]) * 1.0,
                                        np.clip(np.nan_to_num(spot(**a)), 0, 1)),
}


def in_degrees(function: str):
    """Angles taken for degrees, or turned into them."""
    def angles(a):
        return {name: x for name, x in a.items() if name in TABLE and TABLE[name].is_angle}

    def smaller(**a):
        return twin(function)(**a | {name: np.radians(x) for name, x in angles(a).items()})

    def larger(**a):
        return twin(function)(**a | {name: np.degrees(x) for name, x in angles(a).items()})

    def result(**a):
        return np.degrees(twin(function)(**a))

    return {"solid_angle_triangle": (result,), "solid_angle_cone": (smaller, larger, result), "groove_open": (larger,),
            "solid_angle_patch_small": (larger,)}.get(function, (smaller, larger))  # what has a look of its own


def encoded(function: str):
    return lambda **a: np.maximum(twin(function)(**a), 0.0) ** (1 / 2.2)


WITH_ANGLES = ("illuminance_isotropic", "illuminance_point", "spot_linear", "ies_ring_flux", "groove_open",
               "solid_angle_cone", "solid_angle_patch_small", "solid_angle_triangle", "irradiance_cap")

FLUX, CANDELA = "luminous_flux", "luminous_intensity"
VARIANTS: dict[str, dict] = {
    "lambert_no_pi": {
        "brdf_lambert": scaled("brdf_lambert", pi), "radiance_lambert": scaled("radiance_lambert", pi),
        "luminance_lambert": scaled("luminance_lambert", pi), "brdf_blinn_phong": blinn(diffuse=1.0),
        "body_coupled": scaled("body_coupled", pi)},
    "brdf_has_cosine": {name: scaled(name, lambda n, l, **a: np.maximum(_dot(n, l), 0.0))
                        for name in ("brdf_lambert", "brdf_blinn_phong", "brdf_cook_torrance")},
    "cosine_missing": {
        "illuminance_isotropic": lambda luminous_flux, distance, theta: (
            luminous_flux / (4 * pi * distance**2) + 0 * theta),
        "illuminance_point": lambda luminous_intensity, distance, theta: luminous_intensity / distance**2 + 0 * theta,
        "irradiance_at": lambda position, normal, light_position, radiant_intensity, source_radius: (
            radiant_intensity / np.maximum(np.sum((light_position - position) ** 2, -1), source_radius**2))},
    "no_horizon_clamp": {
        "illuminance_isotropic": point_light(lambda x: x / (4 * pi), FLUX),
        "illuminance_point": point_light(lambda x: x, CANDELA),
        "brdf_lambert": lambda n, l, v, rho: rho / pi},
    "kd_plus_ks": {"body_coupled": lambda n_dot_l, n_dot_v, rho, f0: rho / pi + 0 * n_dot_l},
    "reflect_sign": {"reflection_vector": lambda n, l: reflected(l, n), "lobe_phong": wrong_side_lobe},
    "rv_not_clamped": {"lobe_phong": open_lobe},
    "phong_for_blinn": {"lobe_blinn": phong_lobe, "brdf_blinn_phong": blinn(phong_lobe)},
    "h_not_normalised": {"lobe_blinn": long_lobe, "brdf_blinn_phong": blinn(long_lobe),
                         "halfway": lambda l, v: np.asarray(l) + np.asarray(v)},
    "ndf_as_brdf": {"normalisation_blinn_phong": lambda exponent: (exponent + 2) / (2 * pi),
                    "brdf_blinn_phong": blinn(factor=lambda e: (e + 2) / (2 * pi))},
    "lobe_shortcut": {"normalisation_blinn_phong": lambda exponent: (exponent + 8) / (8 * pi),
                      "brdf_blinn_phong": blinn(factor=lambda e: (e + 8) / (8 * pi))},
    "beckmann_no_pi": {"d_beckmann": scaled("d_beckmann", pi)},
    "beckmann_quarter": {"d_beckmann": scaled("d_beckmann", pi / 4)},
    "beckmann_plus": {"d_beckmann": beckmann(lambda t2, s2, m: t2 / m**2)},
    "beckmann_sin": {"d_beckmann": beckmann(lambda t2, s2, m: -s2 / m**2)},
    "m_not_squared": {"d_beckmann": beckmann(lambda t2, s2, m: -t2 / m)},
    "m_as_roughness": {"d_beckmann": changed("d_beckmann", m=lambda m, **a: m * m)},
    "alpha_is_roughness": {"d_ggx": (changed("d_ggx", alpha=lambda alpha, **a: np.sqrt(alpha)),
                                     changed("d_ggx", alpha=lambda alpha, **a: alpha**2)),
                           "lambda_ggx": (changed("lambda_ggx", alpha=lambda alpha, **a: np.sqrt(alpha)),
                                          changed("lambda_ggx", alpha=lambda alpha, **a: alpha**2))},
    "degrees": {name: in_degrees(name) for name in WITH_ANGLES},
    "unstable_form": UNSTABLE,
    "schlick_macro": {
        "brdf_cook_torrance": tuple((lambda n, l, v, m, f0, w=which: twin("cook_torrance_dg")(n, l, v, m)
                                     * twin("f_schlick")(_dot(n, (l, v)[w]), f0)) for which in (1, 0))},
    "schlick_no_complement": {"f_schlick": lambda l_dot_h, f0: f0 + (1 - l_dot_h) ** 5},
    "schlick_inverted": {"f_schlick": lambda l_dot_h, f0: f0 + (1 - f0) * l_dot_h**5},
    "f0_not_squared": {"f0_from_eta": lambda eta: (eta - 1) / (eta + 1)},
    "f0_srgb": {"f_schlick": changed("f_schlick", f0=lambda f0, **a: linear_to_srgb(f0))},
    "eta_inverted": {"f_dielectric": changed("f_dielectric", eta=lambda eta, **a: 1 / eta),
                     "brewster_angle": changed("brewster_angle", eta=lambda eta: 1 / eta)},
    "g_inverted": {"g_vgroove": groove(lambda a, b: least(1 / a, 1 / b))},
    "g_max": {"g_vgroove": groove(lambda a, b: np.maximum(1, np.maximum(a, b))),
              "groove_open": open_groove(lambda a, b: np.maximum(1, np.maximum(a, b)))},
    "g_unbounded": {"g_vgroove": groove(np.minimum), "groove_open": open_groove(np.minimum)},
    "g_one_sided": {"g_vgroove": (groove(lambda a, b: least(a)), groove(lambda a, b: least(b))),
                    "groove_open": (open_groove(lambda a, b: least(a)), open_groove(lambda a, b: least(b)))},
    "ct_one_over_pi": {"brdf_cook_torrance": scaled("brdf_cook_torrance", 4 / pi)},
    "ct_no_denominator": {"brdf_cook_torrance": scaled(
        "brdf_cook_torrance", lambda n, l, v, **a: np.maximum(_dot(n, l), 0) * np.maximum(_dot(n, v), 0))},
    "no_inverse_square": {name: scaled(name, lambda distance, **a: distance**2)
                          for name in ("illuminance_isotropic", "illuminance_point")},
    "light_reversed": {"direction_to_light": scaled("direction_to_light", -1.0),
                       "irradiance_at": lambda position, light_position, **a: twin("irradiance_at")(
                           position=light_position, light_position=position, **a)},
    "lm_as_cd": {"illuminance_isotropic": scaled("illuminance_isotropic", 4 * pi),
                 "luminous_intensity_isotropic": lambda luminous_flux: luminous_flux * 1.0},
    "cd_as_lm": {"illuminance_point": scaled("illuminance_point", 1 / (4 * pi))},
    "watt_as_lumen": {"luminous_flux_radiated": lambda radiant_flux, radiation_efficacy: radiant_flux
                      + 0 * radiation_efficacy,
                      "bulb_luminous_intensity": lambda electrical_power, source_efficacy: electrical_power / (4 * pi)},
    "candela_squared": {
        "illuminance_point": changed("illuminance_point", luminous_intensity=lambda luminous_intensity, **a: (
            luminous_intensity**2)),
        "ies_ring_flux": changed("ies_ring_flux", candela_below=lambda candela_below, **a: candela_below**2,
                                 candela_above=lambda candela_above, **a: candela_above**2)},
    "spot_full_angle": {"spot_linear": changed("spot_linear", hotspot=lambda hotspot, **a: hotspot / 2,
                                               falloff=lambda falloff, **a: falloff / 2)},
    "spot_sign": {"spot_linear": spot_backwards},
    "spot_no_clamp": {"spot_linear": spot},
    "cone_full_angle": {"solid_angle_cone": lambda half_angle: 2 * pi * (1 - np.cos(2 * half_angle))},
    "patch_no_cosine": {"solid_angle_patch_small": lambda distance, tilt, width: (width / distance) ** 2 + 0 * tilt},
    "sphere_area": {"solid_angle_sphere": lambda radius, distance: 4 * pi * (radius / distance) ** 2},
    "encoded": {name: encoded(name) for name in ("radiance_lambert", "brdf_lambert")},
}
