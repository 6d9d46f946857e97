"""A floor, a wall, a black ball and a point lamp: what local shading counts of their light, and what it leaves out.

The floor is z = 0, x > 0; the wall x = 0, |y| <= 1, 0 <= z <= 2; the ball has its centre at (1.1, 0, 0.5) and a radius
of 0.3 m; the lamp hangs at (lamp_x, 0, lamp_height). The wall is matt.
"""

import numpy as np
from numpy import pi

BALL, BALL_RADIUS = np.array([1.1, 0.0, 0.5]), 0.3
CELLS = 10


def _seen(p, q):
    """1 where nothing stands between two points, 0 where the ball does."""
    along = q - p
    share = np.clip(np.sum((BALL - p) * along, -1) / np.sum(along * along, -1), 0, 1)
    off = p + share[..., None] * along - BALL
    return np.where(np.sum(off * off, -1) >= BALL_RADIUS**2, 1.0, 0.0)


def _points(*axes):
    return np.stack(np.broadcast_arrays(*(np.asarray(x, float) for x in axes)), -1)


def irradiance_floor_local(from_wall, along_wall, lamp_x, lamp_height, radiant_intensity):
    """The irradiance of a point of the floor as local shading counts it: the lamp alone, as if nothing were in the way.

    radiant_intensity lamp_height / r^3

    from_wall, along_wall, lamp_x, lamp_height > 0 (...) m, radiant_intensity (...) W/sr. Returns (...) W/m^2.
    Errors: none. Source: deck, Local Shading Models.
    """
    way = _points(from_wall - np.asarray(lamp_x, float), along_wall, lamp_height)
    return np.asarray(radiant_intensity, float) * way[..., 2] / np.sum(way * way, -1) ** 1.5


def irradiance_floor_shadowed(from_wall, along_wall, lamp_x, lamp_height, radiant_intensity):
    """The irradiance of a point of the floor from the lamp, where the ball lets it through.

    irradiance_floor_local, 0 where the line to the lamp meets the ball

    from_wall, along_wall, lamp_x, lamp_height > 0 (...) m, radiant_intensity (...) W/sr. Returns (...) W/m^2.
    Errors: none but on the edge of the shadow. Source: deck, Local Shading Models.
    """
    point, lamp = _points(from_wall, along_wall, 0.0), _points(lamp_x, 0.0, lamp_height)
    return irradiance_floor_local(from_wall, along_wall, lamp_x, lamp_height, radiant_intensity) * _seen(point, lamp)


def irradiance_floor_bounced(from_wall, along_wall, lamp_x, lamp_height, radiant_intensity, rho):
    """The irradiance of a point of the floor by light that came from the lamp to the wall and from there to the floor.

    sum over 10 x 10 cells of the wall of rho E / pi cos_floor cos_wall A / (r^2 + A / pi), where the ball lets it
    through both times: each cell counts as a disk that faces the point, so that it stays finite in the corner

    from_wall, along_wall, lamp_x, lamp_height > 0 (...) m, radiant_intensity (...) W/sr, rho (...). Returns (...)
    W/m^2. Errors: from a cell's width (0.2 m) on within 2 % of irradiance_floor_local, then more: 7 % at 0.1 m.
    Source: Wallace, Elmquist and Haines 1989.
    """
    point, lamp = _points(from_wall, along_wall, 0.0), _points(lamp_x, 0.0, lamp_height)
    area, total = (2 / CELLS) ** 2, 0.0
    for i in range(CELLS):
        for j in range(CELLS):
            cell = np.array([0.0, 2 * (i + 0.5) / CELLS - 1, 2 * (j + 0.5) / CELLS])
            to_lamp, to_cell = lamp - cell, cell - point
            light = to_lamp[..., 0] / np.sum(to_lamp * to_lamp, -1) ** 1.5 * _seen(cell, lamp)
            r2 = np.sum(to_cell * to_cell, -1)
            total = total + light * _seen(point, cell) * to_cell[..., 2] * point[..., 0] / (r2 * (r2 + area / pi))
    return np.asarray(rho, float) / pi * np.asarray(radiant_intensity, float) * area * total


def irradiance_floor(from_wall, along_wall, lamp_x, lamp_height, radiant_intensity, rho):
    """The irradiance of a point of the floor with the ball's shadow and one reflection by the wall.

    irradiance_floor_shadowed + irradiance_floor_bounced

    from_wall, along_wall, lamp_x, lamp_height > 0 (...) m, radiant_intensity (...) W/sr, rho (...). Returns (...)
    W/m^2. Errors: those of its parts; light reflected twice and more is left out.
    Source: Wallace, Elmquist and Haines 1989.
    """
    direct = irradiance_floor_shadowed(from_wall, along_wall, lamp_x, lamp_height, radiant_intensity)
    return direct + irradiance_floor_bounced(from_wall, along_wall, lamp_x, lamp_height, radiant_intensity, rho)


def interreflection_gain(rho):
    """How many times the lamp's own light there is, on the mean, in a closed matt room of one reflectance.

    1 + rho + rho^2 + ... = 1 / (1 - rho)

    rho < 1 (...). Returns (...). Errors: none; exact everywhere in a sphere. Source: Ulbricht 1900, integrating sphere.
    """
    return 1 / (1 - np.asarray(rho, float))
