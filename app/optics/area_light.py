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


def radiance_disk(radiant_flux, radius):
    """The radiance of a disk that radiates a flux evenly from one side.

    Phi / (pi pi radius^2)

    radiant_flux (...) W, radius (...) m. Returns (...) W/(m^2 sr); infinite for radius 0. Errors: none.
    Source: deck, Area Lights; M = pi L for a Lambert emitter.
    """
    return _over(radiant_flux, (pi * np.asarray(radius, float)) ** 2)


def radiance_panel(radiant_flux, panel_width, panel_depth):
    """The radiance of a rectangle that radiates a flux evenly from one side.

    Phi / (pi w d)

    radiant_flux (...) W, panel_width, panel_depth (...) m. Returns (...) W/(m^2 sr); infinite without area.
    Errors: none. Source: deck, Area Lights; M = pi L for a Lambert emitter.
    """
    return _over(radiant_flux, pi * np.asarray(panel_width, float) * np.asarray(panel_depth, float))


def radiant_exitance_panel(radiant_flux, panel_width, panel_depth):
    """The radiant exitance of a rectangle that radiates a flux evenly from one side: pi times its radiance.

    Phi / (w d)

    radiant_flux (...) W, panel_width, panel_depth (...) m. Returns (...) W/m^2; infinite without area. Errors: none.
    Source: deck, Area Lights.
    """
    return _over(radiant_flux, np.asarray(panel_width, float) * np.asarray(panel_depth, float))


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


def irradiance_panel(radiance, light_x, light_y, light_height, panel_width, panel_depth, panel_tilt, position):
    """The irradiance on the floor from the panel, exactly: what of it is above the floor, on its bright side.

    L projected_solid_angle_polygon of the four corners, 0 behind the panel

    radiance (...) W/(m^2 sr), light_x, light_y, light_height, panel_width, panel_depth (...) m, panel_tilt (...) rad,
    position (..., 3) m. Returns (...) W/m^2. Errors: those of projected_solid_angle_polygon; the GLSL twin takes Gauss
    points for a panel ten times as far as it is wide. Source: Lambert 1760, Photometria.
    """
    position = np.asarray(position, float)
    panel = light_x, light_y, light_height, panel_width, panel_depth, panel_tilt
    corners = np.stack([panel_point(*panel, s, t) - position for s, t in ((0, 0), (1, 0), (1, 1), (0, 1))], -2)
    value = np.asarray(radiance, float) * projected_solid_angle_polygon(corners, 4)
    return np.where(panel_view(light_x, light_y, light_height, panel_tilt, position)[..., 2] > 0, value, 0.0)[()]


def irradiance_panel_centre(radiance, light_x, light_y, light_height, panel_width, panel_depth, panel_tilt, position):
    """The irradiance on the floor from the whole panel as one punctual light in its middle.

    L w d cos_light cos / r^2

    The arguments of irradiance_panel. Returns (...) W/m^2. Errors: of order (size / r)^2; near a panel without bound.
    Source: deck, Light Contribution of Area Lights (1), with one sample.
    """
    position = np.asarray(position, float)
    way = np.stack(_floats(light_x, light_y, light_height), -1) - position
    facing = np.maximum(panel_view(light_x, light_y, light_height, panel_tilt, position)[..., 2], 0)
    r2 = np.sum(way * way, -1)
    lit = (facing > 0) & (way[..., 2] > 0)
    safe = np.where(lit, r2, 1)
    area = np.asarray(panel_width, float) * panel_depth
    return np.where(lit, radiance * area * facing / safe * way[..., 2] / safe, 0.0)[()]
