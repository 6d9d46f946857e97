"""What stands in for a full formula where the values allow it, and the error that this costs."""

import numpy as np

from app.optics.area_light import panel_view
from app.optics.beckmann import _dot, d_beckmann, d_beckmann_slope
from app.optics.fresnel import f0_from_eta, f_schlick
from app.optics.light_shape import DISK, SPHERE, irradiance_light, light_area
from app.optics.materials import INSULATORS, f_material, material_eta
from app.optics.shape_samples import irradiance_light_sampled


def irradiance_light_point(light_shape, radiance, light_x, light_y, light_height, panel_width, panel_depth, panel_tilt,
                           position):
    """The irradiance on the floor from an area light, as if all of it were in its middle.

    L A max(0, cos at the light) max(0, n.l) / r^2; a sphere shows a disk, A / 4, from everywhere

    light_shape (...) int, radiance (...) W/(m^2 sr), light_x, light_y, light_height, panel_width, panel_depth (...) m,
    panel_tilt (...) rad, position (..., 3) m. Returns (...) W/m^2; not a number at the middle itself. Errors: exact for
    a sphere above the horizon; else about (width / r)^2, see point_light_error. Source: deck, Punctual Lights.
    """
    shape, position = np.asarray(light_shape), np.asarray(position, float)
    middle = np.stack(np.broadcast_arrays(*(np.asarray(x, float) for x in (light_x, light_y, light_height))), -1)
    way = middle - position
    square = np.sum(way * way, -1)
    tilt = np.where(shape == DISK, 0.0, panel_tilt)
    facing = panel_view(light_x, light_y, light_height, tilt, position)[..., 2]
    with np.errstate(invalid="ignore", divide="ignore"):
        r = np.sqrt(square)
        share = np.where(shape == SPHERE, 0.25, np.maximum(facing, 0) / r)
        seen = light_area(light_shape, panel_width, panel_depth) * share
        return (radiance * seen * np.maximum(way[..., 2], 0) / (square * r))[()]


def irradiance_light_64(light_shape, radiance, light_x, light_y, light_height, panel_width, panel_depth, panel_tilt,
                        position):
    """The irradiance on the floor from an area light by 64 samples, though there is a formula for it.

    irradiance_light_sampled, sampling 2 (stratified by area), level 3, seed 1

    The arguments of irradiance_light_point. Returns (...) W/m^2. Errors: about 1 %, random.
    Source: deck, Light Contribution of Area Lights (1).
    """
    return irradiance_light_sampled(light_shape, radiance, light_x, light_y, light_height, panel_width, panel_depth,
                                    panel_tilt, position, 2, 3, 1)


_FLOOR = np.array([(0.3 * (i % 3), 0.5 * (i // 3 - 3), 0.0) for i in range(21)])


def point_light_error(light_shape, light_height, panel_width, panel_tilt):
    """The largest error on a floor of 1.2 m x 3 m when a light as deep as wide is taken as a point in its middle.

    max |irradiance_light_point - irradiance_light| / max irradiance_light over 21 places, one of them below the middle

    light_shape (...) int, light_height, panel_width (...) m, panel_tilt (...) rad. Returns (...); 0 where no light
    comes. Errors: 21 places, so a place between them may be off a little more. Source: measured here.
    """
    shape, height, width, tilt = (np.asarray(x)[..., None]
                                  for x in (light_shape, light_height, panel_width, panel_tilt))
    light = (shape, 1.0, 0.0, 0.0, height, width, width, tilt, _FLOOR)
    exact = irradiance_light(*light)
    brightest = np.max(exact, -1)
    worst = np.max(np.abs(irradiance_light_point(*light) - exact), -1)
    return np.where(brightest > 0, worst / np.where(brightest > 0, brightest, 1), 0.0)[()]


def point_lights_error(light_height, panel_width, panel_tilt):
    """The same of the worst of the four shapes, for a scene that shows them all.

    max point_light_error over light_shape 0 .. 3

    light_height, panel_width (...) m, panel_tilt (...) rad. Returns (...). Errors: those of point_light_error.
    Source: measured here.
    """
    each = [point_light_error(shape, light_height, panel_width, panel_tilt) for shape in range(4)]
    return np.max(np.stack(np.broadcast_arrays(*each)), 0)[()]


def f_material_schlick(l_dot_h, material):
    """The share a material reflects in red, green and blue by Schlick's fit: no wavelengths, one power.

    f_schlick(l_dot_h, f0) of the exact share head-on, for insulators of their index

    l_dot_h (...) 0 .. 1, material (...) int. Returns (..., 3). Errors: schlick_worst(material), 0.007 for silver, 0.043
    for copper, 0.18 for iron. Source: Schlick 1994.
    """
    l_dot_h, material = np.broadcast_arrays(np.asarray(l_dot_h, float), material)
    clear = f0_from_eta(material_eta(np.minimum(material, INSULATORS - 1)))
    f0 = np.where((material < INSULATORS)[..., None], np.asarray(clear)[..., None], f_material(1.0, material))
    return f_schlick(l_dot_h[..., None], f0)


def cook_torrance_open(n, l, v, m):
    """The Cook-Torrance BRDF of facets that mirror all and stand in nobody's way: G = 1.

    D / (4 n.l n.v); 0 unless n.l > 0 and n.v > 0

    n, l, v (..., 3) unit, m (...) RMS slope. Returns (...) 1/sr, unbounded at grazing angles. Errors: without G;
    cook_torrance_open_error says by how much. Source: deck, The Cook - Torrance Model (2), with 1/4 for 1/pi.
    """
    n_dot_l, n_dot_v = _dot(n, l), _dot(n, v)
    lit = np.minimum(n_dot_l, n_dot_v) > 0
    h = np.asarray(l, float) + np.asarray(v, float)
    return np.where(lit, d_beckmann(n, h, m) / np.where(lit, 4 * n_dot_l * n_dot_v, 1), 0.0)[()]


def cook_torrance_open_error(theta_d, m):
    """The most light that G = 1 adds on any normal under one lamp, over the peak of the highlight.

    max D (1 - G) / n.v over max D G / n.v, over normals at a from h in the plane of l and v, where G is least, as far
    as n.v = 0.01; theta_d + 4 degrees, at most 88.3, in the place of theta_d, as the lines of sight are not parallel

    theta_d (...) rad, the angle of l and of v from h; m (...) RMS slope. Returns (...) 0 .. 10, and 10 for more.
    Errors: 257 normals; at the very rim, beyond n.v = 0.01, it may be more. Source: measured here.
    """
    reach, i = np.maximum(1.4907963 - np.asarray(theta_d, float), 0.02)[..., None], np.arange(-128, 129)
    n_dot_v, n_dot_l = (np.sin(0.01 + reach * (128 + k) / 128) for k in (-i, i))
    open_ = d_beckmann_slope(np.tan(reach * i / 128) ** 2, np.asarray(m, float)[..., None]) / n_dot_v
    g = np.minimum(1, 2 * np.cos(reach * i / 128) * np.minimum(n_dot_v, n_dot_l) / np.sin(0.01 + reach))
    worst, peak = np.max(open_ * (1 - g), -1), np.max(open_ * g, -1)
    return np.where(peak > 0, np.minimum(worst / np.where(peak > 0, peak, 1), 10), 0.0)[()]
