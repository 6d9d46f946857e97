"""An area light of one of four shapes: its area, what of flux, exitance and radiance it has, its light in closed form.

light_shape 0 panel, 1 disk, 2 sphere, 3 polygon (the pentagon of outline_at). All have the middle of the panel; its
width is the diameter of the disk and of the sphere. The disk looks straight down, panel and polygon are tilted.
"""

import numpy as np

from app.optics.area_light import _over, irradiance_disk_light, irradiance_outline, irradiance_sphere_light

PANEL, DISK, SPHERE, POLYGON = range(4)


def light_area(light_shape, panel_width, panel_depth):
    """The area that radiates: one side of a flat light, all around a sphere.

    w d; pi w^2 / 4; pi w^2; 0.68 w d

    light_shape (...) int, panel_width, panel_depth (...) m. Returns (...) m^2. Errors: none.
    Source: deck, Area Lights; elementary geometry.
    """
    width, depth = np.asarray(panel_width, float), np.asarray(panel_depth, float)
    return np.choose(light_shape, [width * depth, np.pi / 4 * width**2, np.pi * width**2, 0.68 * width * depth])


def light_exitance(given, amount, light_shape, panel_width, panel_depth):
    """The radiant exitance of a light of which one number is given: what leaves per area.

    given 0, flux: Phi / A; given 1, exitance: M; given 2, radiance: pi L

    given (...) int, amount (...) W, W/m^2 or W/(m^2 sr), light_shape (...) int, panel_width, panel_depth (...) m.
    Returns (...) W/m^2; infinite for a flux without area. Errors: none. Source: deck, Area Lights; M = pi L (Lambert).
    """
    amount = np.asarray(amount, float)
    return np.choose(given, [_over(amount, light_area(light_shape, panel_width, panel_depth)), amount, np.pi * amount])


def light_radiance(given, amount, light_shape, panel_width, panel_depth):
    """The radiance of a light of which one number is given.

    given 0, flux: Phi / (pi A); given 1, exitance: M / pi; given 2, radiance: L

    The arguments of light_exitance. Returns (...) W/(m^2 sr); infinite for a flux without area. Errors: none.
    Source: deck, Area Lights; M = pi L for a Lambert emitter.
    """
    exitance = light_exitance(given, amount, light_shape, panel_width, panel_depth)
    return np.where(np.asarray(given) == 2, np.asarray(amount, float), exitance / np.pi)[()]


def light_flux(given, amount, light_shape, panel_width, panel_depth):
    """The flux of a light of which one number is given.

    given 0, flux: Phi; given 1, exitance: M A; given 2, radiance: pi L A

    The arguments of light_exitance. Returns (...) W. Errors: none. Source: deck, Area Lights.
    """
    amount, area = np.asarray(amount, float), light_area(light_shape, panel_width, panel_depth)
    return np.choose(given, [amount, amount * area, np.pi * amount * area])


def irradiance_light(light_shape, radiance, light_x, light_y, light_height, panel_width, panel_depth, panel_tilt,
                     position):
    """The irradiance on the floor from an area light, exactly: its radiance times its projected solid angle.

    irradiance_outline of 4 or 5 corners; irradiance_disk_light, 0 on or above the disk; irradiance_sphere_light

    light_shape (...) int, radiance (...) W/(m^2 sr), light_x, light_y, light_height, panel_width, panel_depth (...) m,
    panel_tilt (...) rad, position (..., 3) m. Returns (...) W/m^2. Errors: those of the three.
    Source: deck, Light Contribution of Area Lights (1); Lambert 1760; Howell B-12; Snyder 1969.
    """
    shape, radius = np.asarray(light_shape), 0.5 * np.asarray(panel_width, float)
    middle = np.stack(np.broadcast_arrays(*(np.asarray(v, float) for v in (light_x, light_y, light_height))), -1)
    x, y, z = np.moveaxis(middle - np.asarray(position, float), -1, 0)
    aside = np.hypot(x, y)
    outline = irradiance_outline(np.where(shape == POLYGON, 5, 4), radiance, light_x, light_y, light_height,
                                 panel_width, panel_depth, panel_tilt, position)
    disk = np.where(z > 0, irradiance_disk_light(radiance, radius, np.where(z > 0, z, 1.0), aside), 0.0)
    with np.errstate(invalid="ignore"):  # a sphere of radius 0 at the point itself
        sphere = irradiance_sphere_light(radiance, radius, np.hypot(aside, z), np.arctan2(aside, z))
    return np.choose(shape, [outline, disk, sphere, outline])[()]


def light_irradiance_below(given, amount, light_shape, light_height, panel_width, panel_depth, panel_tilt):
    """The irradiance of the floor straight below the middle of a light of which one number is given.

    irradiance_light of light_radiance, at (0, 0, 0)

    given (...) int, amount (...) W, W/m^2 or W/(m^2 sr), light_shape (...) int, light_height, panel_width, panel_depth
    (...) m, panel_tilt (...) rad. Returns (...) W/m^2. Errors: those of irradiance_light. Source: deck, Area Lights.
    """
    radiance = light_radiance(given, amount, light_shape, panel_width, panel_depth)
    return irradiance_light(light_shape, radiance, 0.0, 0.0, light_height, panel_width, panel_depth, panel_tilt,
                            (0.0, 0.0, 0.0))
