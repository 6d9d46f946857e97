"""The project's reference: a varnished body, lit by one lamp. What a student's shader is compared with."""

import numpy as np

from app.optics.coat import body_coupled
from app.optics.cook_torrance import brdf_cook_torrance
from app.optics.phong import _dot


def _shaded(n, l, v, m, f0, irradiance_facing, body, mirror=brdf_cook_torrance):
    n_dot_l, n_dot_v = _dot(n, l), _dot(n, v)
    lit = (n_dot_l > 0) & (n_dot_v > 0)
    f = body(np.where(lit, n_dot_l, 1.0), np.where(lit, n_dot_v, 1.0)) + mirror(n, l, v, m, f0)[..., None]
    return np.where(lit[..., None], f * (irradiance_facing * n_dot_l)[..., None], 0.0)


def shade_coated(n, l, v, albedo, m, f0, irradiance_facing):
    """Radiance in W/(m^2 sr), (..., 3): (body_coupled + brdf_cook_torrance) E n.l; linear."""
    return _shaded(n, l, v, m, f0, irradiance_facing, lambda c_l, c_v: body_coupled(
        c_l[..., None], c_v[..., None], albedo, np.asarray(f0)[..., None]))


def _without_cosine(n, l, v, **others):
    n_dot_l = _dot(n, l)[..., None]
    return shade_coated(n, l, v, **others) / np.where(n_dot_l > 0, n_dot_l, 1.0)


def _added_up(n, l, v, albedo, m, f0, irradiance_facing):
    return _shaded(n, l, v, m, f0, irradiance_facing, lambda c_l, c_v: albedo / np.pi)


def _too_bright(n, l, v, albedo, m, f0, irradiance_facing):
    return _shaded(n, l, v, m, f0, irradiance_facing, lambda c_l, c_v: body_coupled(
        c_l[..., None], c_v[..., None], albedo, np.asarray(f0)[..., None]),
        lambda *given: 4 / np.pi * brdf_cook_torrance(*given))


MISCONCEPTIONS = {
    "cosine_missing": {"shade_coated": _without_cosine},
    "kd_plus_ks": {"shade_coated": _added_up},
    "ct_one_over_pi": {"shade_coated": _too_bright},
    "encoded": {"shade_coated": lambda **given: shade_coated(**given) ** (1 / 2.2)},
}
