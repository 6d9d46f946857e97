"""Punctual lights: a point with an intensity (positional), or a direction with an irradiance (directional)."""

import numpy as np

from app.optics.solid_angle_flat import _dot


def direction_to_light(position, light_position):
    """The direction from a surface point to the light, the deck's l.

    l = (p_L - x) / |p_L - x|

    position, light_position (..., 3) m. Returns (..., 3) unit vector; 0 where the two meet, where there is none.
    Errors: none. Source: deck, Punctual Lights - Positional.
    """
    way = np.asarray(light_position, float) - np.asarray(position, float)
    r = np.sqrt(_dot(way, way))[..., None]
    return way / np.where(r > 0, r, 1)


def irradiance_positional(radiant_intensity, distance, theta, source_radius):
    """The irradiance a point light gives at a distance, its direction at the angle theta from the normal.

    I max(0, cos theta) / max(distance, source_radius)^2

    radiant_intensity (...) W/sr, distance, source_radius (...) m, theta (...) rad. Returns (...) W/m^2; infinite at
    distance 0 with source_radius 0, where no real source is; negative for a negative intensity, which is shown as a
    fault. Errors: none beyond source_radius; within it the true source, a sphere, gives at most pi L = I / radius^2.
    Sources: deck, Plausible Shading - Measuring Light; optics reference 2.7.
    """
    intensity, distance, theta, radius = (np.asarray(x, float) for x in (
        radiant_intensity, distance, theta, source_radius))
    r = np.maximum(distance, radius)
    with np.errstate(divide="ignore", invalid="ignore"):
        return intensity / r * np.maximum(np.cos(theta), 0) / r


def irradiance_positional_naive(radiant_intensity, distance, theta, source_radius):
    """irradiance_positional with the cosine as it comes: negative for a light behind the surface.

    I cos theta / max(distance, source_radius)^2

    The arguments of irradiance_positional. Returns (...) W/m^2, negative beyond a right angle. Errors: that. Source:
    deck, Plausible Shading - Measuring Light, without its condition.
    """
    intensity, distance, theta, radius = (np.asarray(x, float) for x in (
        radiant_intensity, distance, theta, source_radius))
    r = np.maximum(distance, radius)
    with np.errstate(divide="ignore", invalid="ignore"):
        return intensity / r * np.cos(theta) / r


def irradiance_at(position, normal, light_position, radiant_intensity, source_radius):
    """The irradiance a point light gives at a surface point.

    I max(0, n.l) / max(r, source_radius)^2, r = |p_L - x|

    position, light_position (..., 3) m, normal (..., 3) unit vector, radiant_intensity (...) W/sr, source_radius (...)
    m. Returns (...) W/m^2; 0 for a light behind the surface, and where the two meet. Errors: none beyond source_radius.
    Sources: deck, Plausible Shading - Measuring Light; optics reference 2.7.
    """
    way = np.asarray(light_position, float) - np.asarray(position, float)
    d = np.sqrt(_dot(way, way))
    r = np.maximum(d, source_radius)
    facing = np.maximum(_dot(np.asarray(normal, float), way), 0)
    meets = d == 0
    value = radiant_intensity / np.where(meets, 1, r) * (facing / np.where(meets, 1, d)) / np.where(meets, 1, r)
    return np.where(meets, 0.0, value)[()]


def irradiance_at_naive(position, normal, light_position, radiant_intensity, source_radius):
    """irradiance_at with the cosine as it comes: negative for a light behind the surface.

    I n.l / max(r, source_radius)^2, r = |p_L - x|

    The arguments of irradiance_at. Returns (...) W/m^2, negative behind the surface. Errors: that. Source: deck,
    Plausible Shading - Measuring Light, without its condition.
    """
    way = np.asarray(light_position, float) - np.asarray(position, float)
    d = np.sqrt(_dot(way, way))
    facing = _dot(np.asarray(normal, float), way)
    r, meets = np.maximum(d, source_radius), d == 0
    value = radiant_intensity / np.where(meets, 1, r) * (facing / np.where(meets, 1, d)) / np.where(meets, 1, r)
    return np.where(meets, 0.0, value)[()]


def irradiance_directional(irradiance_facing, theta):
    """The irradiance of a directional light, which has a direction and an irradiance on what faces it, no distance.

    E max(0, cos theta)

    irradiance_facing (...) W/m^2, theta (...) rad. Returns (...) W/m^2. Errors: none.
    Source: deck, Punctual Lights - Directional.
    """
    return np.asarray(irradiance_facing, float) * np.maximum(np.cos(np.asarray(theta, float)), 0)


def falloff_error(distance, offset):
    """How much less a floor gets at an offset than straight below a point light; a directional light says 0.

    1 - (1 + (offset / distance)^2)^(-3/2) = 1 - cos^3, about 3/2 (offset / distance)^2

    distance > 0, offset >= 0 (...) m. Returns (...), 0 .. 1. Errors: none.
    Source: deck, Punctual Lights - Directional ("distant compared to world scale"), the scale put in numbers.
    """
    x = np.asarray(offset, float) / np.asarray(distance, float)
    s = np.sqrt(1 + x * x)
    return x / s * (x / (1 + s)) * (1 + 1 / s + 1 / s**2)


def windowed_falloff(distance, reach):
    """1 / distance^2 as game engines use it: finite at the light, and zero from a reach on.

    (1 - (distance / reach)^4)^2 / (distance^2 + 1), 0 beyond the reach; the 1 is one square metre

    distance, reach > 0 (...) m. Returns (...) 1/m^2. Errors: against 1 / distance^2: half of it at 1 m, 1 % less
    at 10 m within a far larger reach; it depends on the unit of length.
    Source: Karis 2013, Real Shading in Unreal Engine 4.
    """
    distance, reach = np.asarray(distance, float), np.asarray(reach, float)
    x = distance / reach
    window = np.maximum(reach - distance, 0) / reach * (1 + x) * (1 + x * x)
    return np.where(distance < reach, window * window / (distance * distance + 1), 0.0)[()]


def irradiance_windowed(radiant_intensity, distance, theta, reach):
    """The irradiance of a point light as game engines take it.

    I windowed_falloff(distance, reach) max(0, cos theta)

    radiant_intensity (...) W/sr, distance, reach (...) m, theta (...) rad. Returns (...) W/m^2. Errors: those of
    windowed_falloff. Source: Karis 2013, Real Shading in Unreal Engine 4.
    """
    facing = np.maximum(np.cos(np.asarray(theta, float)), 0)
    return np.asarray(radiant_intensity, float) * windowed_falloff(distance, reach) * facing


def falloff_error_far(distance, offset):
    """falloff_error to first order: twice as far, a quarter of the error.

    3/2 (offset / distance)^2

    distance > 0, offset (...) m. Returns (...). Errors: of order (offset / distance)^4.
    Source: deck, Punctual Lights - Directional.
    """
    return 1.5 * (np.asarray(offset, float) / np.asarray(distance, float)) ** 2
