"""The deck's light bulb, even in all directions, over the middle of a round table: every entry of the unit ledger."""

import numpy as np
from numpy import pi

from app.optics.photometry import illuminance_isotropic, luminance_lambert, luminous_flux_source
from app.optics.projected_solid_angle import _AT, _WEIGHT
from app.optics.radiometry import irradiance_isotropic, irradiance_point, radiance_lambert, radiant_intensity_isotropic

_PANELS = 4


def bulb_luminous_intensity(electrical_power, source_efficacy):
    """The candela of the bulb.

    electrical_power source_efficacy / (4 pi)

    electrical_power (...) W drawn, source_efficacy (...) lm/W. Returns (...) cd. Errors: none.
    Source: deck, Units for Lighting - Candela.
    """
    return luminous_flux_source(electrical_power, source_efficacy) / (4 * pi)


def bulb_illuminance(electrical_power, source_efficacy, distance):
    """The illuminance under the bulb.

    electrical_power source_efficacy / (4 pi distance^2)

    electrical_power (...) W, source_efficacy (...) lm/W, distance > 0 (...) m. Returns (...) lx. Errors: none.
    Source: deck, Units for Lighting - Candela.
    """
    return illuminance_isotropic(luminous_flux_source(electrical_power, source_efficacy), distance, 0.0)


def bulb_luminance(electrical_power, source_efficacy, distance, rho):
    """The luminance of a matt sheet under the bulb.

    rho bulb_illuminance / pi

    electrical_power (...) W, source_efficacy (...) lm/W, distance > 0 (...) m, rho (...). Returns (...) cd/m^2.
    Errors: none. Source: Lambert 1760, Photometria.
    """
    return luminance_lambert(rho, bulb_illuminance(electrical_power, source_efficacy, distance))


def bulb_radiant_flux(electrical_power, radiated_share):
    """The flux the bulb radiates: what it draws, less what it gives away as warm air.

    electrical_power radiated_share

    electrical_power (...) W drawn, radiated_share (...) 0 .. 1. Returns (...) W of radiation. Errors: none.
    Source: deck, Units for Lighting - Watts.
    """
    return np.asarray(electrical_power, float) * np.asarray(radiated_share, float)


def bulb_radiant_intensity(electrical_power, radiated_share):
    """The radiant intensity of the bulb.

    electrical_power radiated_share / (4 pi)

    electrical_power (...) W, radiated_share (...). Returns (...) W/sr. Errors: none. Source: deck, Measuring Light.
    """
    return radiant_intensity_isotropic(bulb_radiant_flux(electrical_power, radiated_share))


def bulb_irradiance(electrical_power, radiated_share, distance):
    """The irradiance under the bulb.

    electrical_power radiated_share / (4 pi distance^2)

    electrical_power (...) W, radiated_share (...), distance > 0 (...) m. Returns (...) W/m^2. Errors: none.
    Source: deck, Measuring Light.
    """
    return irradiance_isotropic(bulb_radiant_flux(electrical_power, radiated_share), distance)


def bulb_radiance(electrical_power, radiated_share, distance, rho):
    """The radiance of a matt sheet under the bulb, one that reflects all wavelengths alike.

    rho bulb_irradiance / pi

    electrical_power (...) W, radiated_share (...), distance > 0 (...) m, rho (...). Returns (...) W/(m^2 sr).
    Errors: none. Source: Lambert 1760, Photometria.
    """
    return radiance_lambert(rho, bulb_irradiance(electrical_power, radiated_share, distance))


def bulb_received(electrical_power, source_efficacy, radius, distance):
    """The lumens that the table under the bulb gets: its illuminance, integrated over its area.

    int_0^radius E(q) 2 pi q dq, E = I cos / r^2, at q = distance tan a, in 4 panels of 8 Gauss points

    electrical_power (...) W, source_efficacy (...) lm/W, radius, distance > 0 (...) m. Returns (...) lm. Errors: of the
    rule below 1e-15. Source: deck, Basic Radiometric Quantities (3).
    """
    radius, distance = np.asarray(radius, float), np.asarray(distance, float)
    intensity, rim = bulb_luminous_intensity(electrical_power, source_efficacy), np.arctan2(radius, distance)
    total = 0.0
    for panel in range(_PANELS):
        for at, weight in zip(_AT, _WEIGHT, strict=True):
            a = rim * (panel + at) / _PANELS
            q, dq = distance * np.tan(a), rim / _PANELS * weight * distance / np.cos(a) ** 2
            total = total + irradiance_point(intensity, np.hypot(q, distance), a) * 2 * pi * q * dq
    return total


def bulb_escaped(electrical_power, source_efficacy, radius, distance):
    """The lumens that miss the table: the intensity, integrated over all directions beyond its rim.

    int_rim^pi I 2 pi sin a da, rim = atan(radius / distance), in 4 panels of 8 Gauss points

    electrical_power (...) W, source_efficacy (...) lm/W, radius, distance > 0 (...) m. Returns (...) lm. Errors: of the
    rule below 1e-15. Source: deck, Units for Lighting - Candela.
    """
    rim = np.arctan2(np.asarray(radius, float), np.asarray(distance, float))
    total = 0.0
    for panel in range(_PANELS):
        for at, weight in zip(_AT, _WEIGHT, strict=True):
            a = rim + (pi - rim) * (panel + at) / _PANELS
            total = total + 2 * pi * np.sin(a) * weight * (pi - rim) / _PANELS
    return bulb_luminous_intensity(electrical_power, source_efficacy) * total
