"""Three globe lamps over a floor: flux, intensity, luminance and the illuminance they add up to.

The floor is z = 0; from_wall is x, along_wall is y. Lamp 0 has the flux `luminous_flux`, the others 600 and 250 lm; all
are globes of one radius, as bright from every side. No shadows, no light from walls.
"""

import numpy as np
from numpy import pi

from app.optics.photometry import luminous_intensity_isotropic
from app.optics.radiometry import irradiance_sphere

LAMPS = np.array([(1.2, 0.0, 1.15), (0.45, -0.75, 1.5), (2.0, 0.7, 1.0)])
FLUXES = np.array([0.0, 600.0, 250.0])
COUNT = 3


def lamp_flux(globe, luminous_flux):
    """The luminous flux of one of the lamps.

    luminous_flux, 600, 250

    globe (...) 0 .. 2, luminous_flux (...) lm. Returns (...) lm. Errors: none. Source: ours.
    """
    globe = np.asarray(globe)
    return np.where(globe == 0, luminous_flux, FLUXES[globe])[()]


def lamp_intensity(globe, luminous_flux):
    """The luminous intensity of one of the lamps.

    lamp_flux / (4 pi)

    globe (...) 0 .. 2, luminous_flux (...) lm. Returns (...) cd. Errors: none. Source: deck, Plausible Shading -
    Measuring Light.
    """
    return luminous_intensity_isotropic(lamp_flux(globe, luminous_flux))


def lamp_luminance(globe, luminous_flux, source_radius):
    """The luminance of one of the globes, the same from any distance.

    lamp_intensity / (pi source_radius^2)

    globe (...) 0 .. 2, luminous_flux (...) lm, source_radius > 0 (...) m. Returns (...) cd/m^2. Errors: none.
    Source: Lambert 1760; optics reference, D5.
    """
    return lamp_intensity(globe, luminous_flux) / (pi * np.asarray(source_radius, float) ** 2)


def _way(globe, from_wall, along_wall):
    """The distance to a lamp, and its height."""
    globe, x, y = np.broadcast_arrays(np.asarray(globe), np.asarray(from_wall, float), np.asarray(along_wall, float))
    at = LAMPS[globe]
    return np.hypot(np.hypot(at[..., 0] - x, at[..., 1] - y), at[..., 2]), at[..., 2]


def lamp_inverse_square(globe, luminous_flux, from_wall, along_wall):
    """The illuminance of a card that faces one of the lamps, from a point of the floor: what slides call L_i.

    lamp_intensity / r^2

    globe (...) 0 .. 2, luminous_flux (...) lm, from_wall, along_wall (...) m. Returns (...) lx. Errors: none.
    Source: deck, Plausible Shading - Measuring Light.
    """
    return lamp_intensity(globe, luminous_flux) / _way(globe, from_wall, along_wall)[0] ** 2


def lamp_illuminance(globe, luminous_flux, from_wall, along_wall):
    """The illuminance of the floor by one of the lamps.

    lamp_intensity z / r^3, z its height

    globe (...) 0 .. 2, luminous_flux (...) lm, from_wall, along_wall (...) m. Returns (...) lx. Errors: none: a globe
    above the floor is exactly a point. Source: deck, Plausible Shading - Measuring Light.
    """
    r, z = _way(globe, from_wall, along_wall)
    return lamp_intensity(globe, luminous_flux) * z / r**3


def lamps_illuminance(luminous_flux, from_wall, along_wall):
    """The illuminance of the floor by all three lamps: what they give adds up.

    sum of lamp_illuminance

    luminous_flux (...) lm, from_wall, along_wall (...) m. Returns (...) lx. Errors: none. Source: deck, Plausible
    Shading - Measuring Light.
    """
    return sum(lamp_illuminance(k, luminous_flux, from_wall, along_wall) for k in range(COUNT))


def lamps_illuminance_by_area(luminous_flux, source_radius, from_wall, along_wall):
    """The same from what is seen: the luminance of each globe times the projected solid angle it takes up.

    sum of L pi s^2 cos, s = source_radius / r, L = lamp_luminance

    luminous_flux (...) lm, source_radius (...) m, below the lamps' heights; from_wall, along_wall (...) m. Returns
    (...) lx. Errors: none. Source: deck, Plausible Shading - Measuring Light; Light Contribution of Area Lights (1).
    """
    total = 0.0
    for k in range(COUNT):
        r, z = _way(k, from_wall, along_wall)
        slant = np.arctan2(np.sqrt(np.maximum(r * r - z * z, 0)), z)
        total = total + irradiance_sphere(lamp_luminance(k, luminous_flux, source_radius), source_radius, r, slant)
    return total


def luminance_over_inverse_square(source_radius, distance):
    """How many times larger a globe's luminance is than the I / r^2 taken for it.

    distance^2 / (pi source_radius^2): one over the solid angle of the globe's disk

    source_radius > 0 (...) m, distance (...) m. Returns (...) 1/sr. Errors: none. Source: optics reference, D5.
    """
    return np.asarray(distance, float) ** 2 / (pi * np.asarray(source_radius, float) ** 2)
