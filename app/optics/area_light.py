"""Area lights of one radiance: what flux makes of it, and the irradiance they give in closed form.

The panel of the lessons: panel_width along x, panel_depth turned by panel_tilt about x, its middle at (light_x,
light_y, light_height) over the floor z = 0. It shines on one side, downwards at tilt 0, in every
direction as Lambert says.
A size of 0 leaves a flux no area: the radiance is then infinite, and the stage marks it.
"""

import numpy as np
from numpy import pi

from app.optics.projected_solid_angle import (
    projected_solid_angle_disk,
    projected_solid_angle_polygon,
    projected_solid_angle_sphere,
)


def _over(radiant_flux, area):
    with np.errstate(divide="ignore", invalid="ignore"):
        return (np.asarray(radiant_flux, float) / area)[()]


def radiance_sphere(radiant_flux, radius):
    """The radiance of a sphere that radiates a flux evenly.

    Phi / (pi 4 pi radius^2)

    radiant_flux (...) W, radius (...) m. Returns (...) W/(m^2 sr); infinite for radius 0. Errors: none.
    Source: deck, Area Lights; M = pi L for a Lambert emitter.
    """
    return _over(radiant_flux, (2 * pi * np.asarray(radius, float)) ** 2)


def irradiance_sphere_light(radiance, radius, distance, theta):
    """The irradiance from a sphere whose centre is at a distance and an angle theta from the normal.

    L projected_solid_angle_sphere; above the horizon exactly pi L (radius / distance)^2 cos theta, as a point light

    radiance (...) W/(m^2 sr), radius, distance (...) m, theta (...) rad. Returns (...) W/m^2; pi L from inside.
    Errors: those of projected_solid_angle_sphere. Source: deck, Light Contribution of Area Lights (1).
    """
    return np.asarray(radiance, float) * projected_solid_angle_sphere(radius, distance, theta)


def irradiance_lamp(radiant_flux, radius, distance, theta):
    """The irradiance from a sphere of a given flux.

    irradiance_sphere_light of radiance_sphere; above the horizon Phi / (4 pi distance^2) cos theta, whatever the radius

    radiant_flux (...) W, radius > 0, distance (...) m, theta (...) rad. Returns (...) W/m^2. Errors: those of
    projected_solid_angle_sphere. Source: deck, Punctual Lights; Light Contribution of Area Lights (1).
    """
    return irradiance_sphere_light(radiance_sphere(radiant_flux, radius), radius, distance, theta)


def irradiance_disk_light(radiance, radius, height, offset):
    """The irradiance on the floor from a disk parallel to it.

    L projected_solid_angle_disk

    radiance (...) W/(m^2 sr), radius, height, offset (...) m. Returns (...) W/m^2. Errors: none.
    Source: deck, Light Contribution of Area Lights (1).
    """
    return np.asarray(radiance, float) * projected_solid_angle_disk(radius, height, offset)


def irradiance_polygon_light(radiance, corners, corner_count):
    """The irradiance from a flat outline without crossings, seen from the origin, the normal +z; cut at the horizon.

    L projected_solid_angle_polygon

    radiance (...) W/(m^2 sr), corners (..., n, 3) m, corner_count (...) <= n. Returns (...) W/m^2.
    Errors: those of projected_solid_angle_polygon. Source: Lambert 1760, Photometria.
    """
    return np.asarray(radiance, float) * projected_solid_angle_polygon(corners, corner_count)


def _floats(*given):
    return np.broadcast_arrays(*(np.asarray(x, float) for x in given))


def panel_point(light_x, light_y, light_height, panel_width, panel_depth, panel_tilt, s, t):
    """A point of the panel: s along its width, t along its depth, the middle at 1/2, 1/2.

    (x + (s - 1/2) w, y + (t - 1/2) d cos tilt, h + (t - 1/2) d sin tilt)

    light_x, light_y, light_height, panel_width, panel_depth (...) m, panel_tilt (...) rad, s, t (...) in [0, 1].
    Returns (..., 3) m. Errors: none. Source: deck, Area Lights.
    """
    x, y, height, width, depth, tilt, s, t = _floats(
        light_x, light_y, light_height, panel_width, panel_depth, panel_tilt, s, t)
    up = (t - 0.5) * depth
    return np.stack([x + (s - 0.5) * width, y + up * np.cos(tilt), height + up * np.sin(tilt)], -1)


def panel_view(light_x, light_y, light_height, panel_tilt, position):
    """The panel's middle seen from a point, in the panel's own axes: its width, its depth, its back.

    way = middle - position: (way.x, way.y cos tilt + way.z sin tilt, way.z cos tilt - way.y sin tilt)

    light_x, light_y, light_height (...) m, panel_tilt (...) rad, position (..., 3) m. Returns (..., 3) m; z is the
    distance to the panel's plane, <= 0 behind the panel. Errors: none. Source: deck, Area Lights.
    """
    tilt = np.asarray(panel_tilt, float)
    x, y, z = np.moveaxis(np.stack(_floats(light_x, light_y, light_height), -1) - np.asarray(position, float), -1, 0)
    return np.stack(_floats(x, y * np.cos(tilt) + z * np.sin(tilt), z * np.cos(tilt) - y * np.sin(tilt)), -1)


_OUTLINES = np.array([
    [[0.5, 0.0], [1.0, 1.0], [0.0, 1.0], [0.5, 0.0], [0.5, 0.0]],
    [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.0]],
    [[0.5, 0.0], [1.0, 0.4], [0.8, 1.0], [0.2, 1.0], [0.0, 0.4]],
])


def outline_at(corner_count, index):
    """A corner of the outline of a flat light in the unit square: 3 a triangle, 4 the whole square, 5 a pentagon.

    from index corner_count on corner 0 again. The pentagon takes 0.68 of the square, its triangles from
    corner 0 0.19, 0.30 and 0.19

    corner_count (...) 3 .. 5, index (...) >= 0. Returns (..., 2). Errors: none. Source: deck, Area Lights; the
    pentagon is this course's own, with a narrow and a wide end.
    """
    corner_count, index = np.asarray(corner_count), np.asarray(index)
    return _OUTLINES[corner_count - 3, np.where(index < corner_count, index, 0)]


def irradiance_outline(corner_count, radiance, light_x, light_y, light_height, panel_width, panel_depth, panel_tilt,
                       position):
    """The irradiance on the floor from a flat light, exactly: what of it is above the floor, on its bright side.

    L projected_solid_angle_polygon of the outline's corners, 0 behind the light

    corner_count (...) 3 .. 5 as outline_at, radiance (...) W/(m^2 sr), light_x, light_y, light_height, panel_width,
    panel_depth (...) m, panel_tilt (...) rad, position (..., 3) m. Returns (...) W/m^2. Errors: those of
    projected_solid_angle_polygon; the GLSL twin takes Gauss points for a light ten times as far as it is wide.
    Source: Lambert 1760, Photometria.
    """
    count = np.asarray(corner_count)
    at = outline_at(count[..., None], np.minimum(np.arange(5), count[..., None] - 1))
    panel = light_x, light_y, light_height, panel_width, panel_depth, panel_tilt
    parts = [np.asarray(v, float)[..., None] for v in panel]
    corners = panel_point(*parts, at[..., 0], at[..., 1]) - np.asarray(position, float)[..., None, :]
    value = np.asarray(radiance, float) * projected_solid_angle_polygon(corners, count)
    return np.where(panel_view(light_x, light_y, light_height, panel_tilt, position)[..., 2] > 0, value, 0.0)[()]
