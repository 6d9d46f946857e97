"""Energy, flux, intensity, radiance, irradiance, exitance: what each is of the others.

Irradiance is counted on the side of the normal: light from below the horizon gives 0, never less.
"""

import numpy as np
from numpy import pi

from app.optics.projected_solid_angle import (
    projected_solid_angle_cone,
    projected_solid_angle_disk,
    projected_solid_angle_disk_naive,
    projected_solid_angle_sphere,
)
from app.optics.solid_angle import solid_angle_cone
from app.optics.square_patch import projected_solid_angle_patch


def _cosine(theta):
    return np.maximum(0, np.cos(np.asarray(theta, float)))


def radiant_flux_mean(radiant_energy, duration):
    """The flux of a source that sends out an energy evenly over a time.

    radiant_energy / duration

    radiant_energy (...) J, duration > 0 (...) s. Returns (...) W. Errors: none.
    Source: deck, Basic Radiometric Quantities (1).
    """
    return np.asarray(radiant_energy, float) / np.asarray(duration, float)


def radiant_energy_emitted(radiant_energy, duration, time):
    """The energy that has left by some time, of a source that sends it out evenly from time 0 on.

    radiant_energy min(1, max(0, time) / duration): the integral of the flux

    radiant_energy (...) J, duration > 0, time (...) s. Returns (...) J. Errors: none.
    Source: deck, Basic Radiometric Quantities (1).
    """
    share = np.maximum(0, np.asarray(time, float)) / np.asarray(duration, float)
    return np.asarray(radiant_energy, float) * np.minimum(1, share)


def radiant_intensity_isotropic(radiant_flux):
    """The intensity of a source that shines evenly in all directions.

    radiant_flux / (4 pi)

    radiant_flux (...) W. Returns (...) W/sr. Errors: none. Source: deck, Plausible Shading - Measuring Light.
    """
    return np.asarray(radiant_flux, float) / (4 * pi)


def radiant_intensity_cone(radiant_flux, half_angle):
    """The mean intensity of a flux that goes out through a cone of directions.

    radiant_flux / (4 pi sin^2(half_angle / 2))

    radiant_flux (...) W, half_angle > 0 (...) rad. Returns (...) W/sr. Errors: none.
    Source: deck, Basic Radiometric Quantities (1).
    """
    return np.asarray(radiant_flux, float) / solid_angle_cone(half_angle)


def radiant_intensity_lambert(radiant_flux, theta):
    """The intensity of a small flat source that radiates by the cosine law to one side.

    radiant_flux / pi max(0, cos theta)

    radiant_flux (...) W, theta (...) rad from its normal. Returns (...) W/sr. Errors: none.
    Source: Lambert 1760, Photometria.
    """
    return np.asarray(radiant_flux, float) / pi * _cosine(theta)


def radiant_flux_lambert_cone(radiant_flux, half_angle):
    """The flux that a small flat source sends into a cone about its normal.

    radiant_flux sin^2(half_angle), all of it from pi/2 on

    radiant_flux (...) W, half_angle (...) rad. Returns (...) W. Errors: none. Source: Lambert 1760, Photometria.
    """
    return np.asarray(radiant_flux, float) / pi * projected_solid_angle_cone(half_angle)


def radiant_intensity_lambert_cone(radiant_flux, half_angle):
    """The mean intensity of a small flat source over a cone about its normal: its flux over its solid angle.

    radiant_flux_lambert_cone / (4 pi sin^2(half_angle / 2)); up to pi/2 that is radiant_flux / pi cos^2(half_angle / 2)

    radiant_flux (...) W, half_angle (...) rad. Returns (...) W/sr; at 0 the intensity on the axis. Errors: none.
    Source: deck, Basic Radiometric Quantities (1).
    """
    half_angle, flux = np.asarray(half_angle, float), np.asarray(radiant_flux, float)
    beyond = flux / solid_angle_cone(np.maximum(half_angle, 0.5 * pi))
    return np.where(half_angle <= 0.5 * pi, flux / pi * np.cos(0.5 * half_angle) ** 2, beyond)[()]


def irradiance_point(radiant_intensity, distance, theta):
    """The irradiance that a point source gives to a surface turned away from it by an angle.

    radiant_intensity max(0, cos theta) / distance^2, divided twice so that distance^2 cannot leave the range of numbers

    radiant_intensity (...) W/sr, distance (...) m, theta (...) rad. Returns (...) W/m^2; infinite at distance 0 (a real
    lamp has a size and gives at most pi L: irradiance_sphere). Errors: none. Source: deck, Measuring Light.
    """
    distance = np.asarray(distance, float)
    with np.errstate(divide="ignore"):
        return np.asarray(radiant_intensity, float) * _cosine(theta) / distance / distance


def irradiance_isotropic(radiant_flux, distance):
    """The irradiance that a point source of a flux, even in all directions, gives to a surface that faces it.

    radiant_flux / (4 pi distance^2)

    radiant_flux (...) W, distance > 0 (...) m. Returns (...) W/m^2. Errors: none. Source: deck, Measuring Light.
    """
    return irradiance_point(radiant_intensity_isotropic(radiant_flux), distance, 0.0)


def irradiance_cap(radiance, half_angle):
    """The irradiance of a cap of even sky about the normal.

    pi radiance sin^2(half_angle); pi radiance for the whole sky

    radiance (...) W/(m^2 sr), half_angle (...) rad. Returns (...) W/m^2. Errors: none.
    Source: deck, Basic Radiometric Quantities (3).
    """
    return np.asarray(radiance, float) * projected_solid_angle_cone(half_angle)


def irradiance_without_cosine(radiance, half_angle):
    """What one gets for the irradiance of a cap of sky when the cosine is forgotten.

    radiance 4 pi sin^2(half_angle / 2); 2 pi radiance for the whole sky, twice the truth

    radiance (...) W/(m^2 sr), half_angle (...) rad. Returns (...) W/m^2. Errors: on purpose. Source: a common mistake.
    """
    return np.asarray(radiance, float) * solid_angle_cone(half_angle)


def irradiance_sphere(radiance, radius, distance, theta):
    """The irradiance of a glowing sphere, the horizon cut off.

    radiance projected_solid_angle_sphere(radius, distance, theta): above the horizon exactly that of a point source of
    the intensity pi radius^2 radiance

    radiance (...) W/(m^2 sr), radius, distance (...) m, theta (...) rad. Returns (...) W/m^2, at most pi radiance.
    Errors: those of projected_solid_angle_sphere. Source: Snyder 1969.
    """
    return np.asarray(radiance, float) * projected_solid_angle_sphere(radius, distance, theta)


def irradiance_disk(radiance, radius, height, offset):
    """The irradiance of a glowing disk on a surface parallel to it.

    radiance projected_solid_angle_disk(radius, height, offset)

    radiance (...) W/(m^2 sr), radius, height > 0, offset (...) m. Returns (...) W/m^2, at most pi radiance.
    Errors: none. Source: Howell, catalogue of configuration factors, B-12.
    """
    return np.asarray(radiance, float) * projected_solid_angle_disk(radius, height, offset)


def irradiance_disk_naive(radiance, radius, height, offset):
    """irradiance_disk with the configuration factor as it is printed, 1 less almost 1.

    radiance projected_solid_angle_disk_naive(radius, height, offset)

    radiance (...) W/(m^2 sr), radius > 0, height > 0, offset >= 0 (...) m. Returns (...) W/m^2. Errors: cancels for a
    far disk. Source: Howell, A Catalog of Radiation Heat Transfer Configuration Factors, B-12.
    """
    return np.asarray(radiance, float) * projected_solid_angle_disk_naive(radius, height, offset)


def irradiance_round_far(radiance, radius, distance):
    """The irradiance of a round source, disk or sphere, by the inverse square law: as if it were a point.

    pi radius^2 radiance / distance^2

    radiance (...) W/(m^2 sr), radius, distance > 0 (...) m. Returns (...) W/m^2. Errors: exact for a sphere; for a disk
    too large by (radius / distance)^2 of itself. Source: deck, Measuring Light.
    """
    seen = np.asarray(radius, float) / np.asarray(distance, float)
    return pi * np.asarray(radiance, float) * seen * seen


def inverse_square_excess(radius, distance):
    """By what share of the true irradiance the inverse square law is too large for a disk on its axis.

    (radius / distance)^2: 1 % at five diameters

    radius, distance > 0 (...) m. Returns (...). Errors: none. Source: irradiance_round_far / irradiance_disk - 1.
    """
    seen = np.asarray(radius, float) / np.asarray(distance, float)
    return seen * seen


def irradiance_piece(sky_piece, radiance, opening, theta):
    """The irradiance of one piece of sky of an even radiance: a cap overhead, a round sun or a square window.

    sky_piece 0: a cap of half angle `opening` about the normal, pi L sin^2; 1: a disk of that half angle whose centre
    is theta from the normal; 2: a square facing the point at 1 m, of half side sin(opening), its centre at theta

    sky_piece (...) 0, 1, 2, radiance (...) W/(m^2 sr), opening (...) 0 .. pi/2, theta (...) rad. Returns (...) W/m^2.
    Errors: those of the projected solid angles. Source: deck, Basic Radiometric Quantities (3).
    """
    size = np.sin(np.asarray(opening, float))
    disk = projected_solid_angle_sphere(size, 1.0, theta)
    window = projected_solid_angle_patch(theta, 1.0, 0.0, 2 * size)
    seen = np.select([np.asarray(sky_piece) == 0, np.asarray(sky_piece) == 1], [pi * size * size, disk], window)
    return (np.asarray(radiance, float) * seen)[()]


def irradiance_sensor(radiance, half_angle, theta):
    """The irradiance of a surface that sees an even radiance through a round opening, its normal turned from the axis.

    radiance pi sin^2(half_angle) cos theta while all of the opening is above the surface's horizon

    radiance (...) W/(m^2 sr), half_angle (...) 0 .. pi/2, theta (...) rad. Returns (...) W/m^2.
    Errors: those of projected_solid_angle_sphere. Source: deck, Basic Radiometric Quantities (3).
    """
    return irradiance_sphere(radiance, np.sin(half_angle), 1.0, theta)


def radiant_flux_sensor(radiance, patch_area, half_angle, theta):
    """The flux on a small sensor that sees an even radiance through a round opening, its normal turned from the axis.

    radiance patch_area pi sin^2(half_angle) cos theta while all of the opening is above the sensor's horizon

    radiance (...) W/(m^2 sr), patch_area (...) m^2, half_angle (...) 0 .. pi/2, theta (...) rad. Returns (...) W.
    Errors: those of projected_solid_angle_sphere. Source: deck, Basic Radiometric Quantities (2).
    """
    return np.asarray(patch_area, float) * irradiance_sensor(radiance, half_angle, theta)


def radiant_energy_sensor(radiance, patch_area, half_angle, theta, duration):
    """The energy that falls on such a sensor in a time.

    radiant_flux_sensor duration

    radiance (...) W/(m^2 sr), patch_area (...) m^2, half_angle (...), theta (...) rad, duration (...) s. Returns (...)
    J. Errors: those of the flux. Source: deck, Basic Radiometric Quantities (1).
    """
    return radiant_flux_sensor(radiance, patch_area, half_angle, theta) * np.asarray(duration, float)


def radiance_sensor(radiance, patch_area, half_angle, theta):
    """The radiance a sensor reports: its flux over area, solid angle and cosine.

    radiant_flux_sensor / (patch_area 4 pi sin^2(half_angle / 2) cos theta); radiance cos^2(half_angle / 2) above the
    horizon, so right in the limit of a small opening

    radiance (...) W/(m^2 sr), patch_area (...) m^2, half_angle > 0, theta (...) rad. Returns (...) W/(m^2 sr); without
    limit as theta -> pi/2, where the cosine that is divided by vanishes and a part of the opening still shines in.
    Errors: none beyond those of the flux. Source: deck, Basic Radiometric Quantities (2).
    """
    flux = radiant_flux_sensor(radiance, patch_area, half_angle, theta)
    return flux / np.asarray(patch_area, float) / solid_angle_cone(half_angle) / np.abs(np.cos(theta))


def radiance_sensor_projected(radiance, patch_area, half_angle, theta):
    """The radiance a sensor reports when its flux is divided by area and projected solid angle.

    radiant_flux_sensor / (patch_area projected solid angle): the radiance itself, at any opening

    radiance (...) W/(m^2 sr), patch_area (...) m^2, half_angle > 0, theta (...) rad. Returns (...) W/(m^2 sr); 0 where
    all of the opening is below the sensor's horizon. Errors: none. Source: Nicodemus 1963, Radiance.
    """
    flux, seen = radiant_flux_sensor(radiance, patch_area, half_angle, theta), irradiance_sensor(1.0, half_angle, theta)
    return np.where(seen > 0, flux / np.asarray(patch_area, float) / np.where(seen > 0, seen, 1), 0.0)[()]


def radiant_intensity_spot(radiance, half_angle, distance):
    """The intensity, towards the sensor, of the part of a wall of an even radiance that it sees through the opening.

    radiance pi (distance tan half_angle)^2

    radiance (...) W/(m^2 sr), half_angle < pi/2 (...) rad, distance (...) m. Returns (...) W/sr. Errors: none.
    Source: deck, Basic Radiometric Quantities (2).
    """
    reach = np.asarray(distance, float) * np.tan(np.asarray(half_angle, float))
    return np.asarray(radiance, float) * pi * reach * reach


def radiance_twice_as_far(half_angle, distance):
    """The radiance through an opening when the wall stands twice as far, over the one before.

    projected_solid_angle_disk(2 d tan a, 2 d, 0) / projected_solid_angle_disk(d tan a, d, 0): the seen spot grows as
    the square of the distance, each part of it gives that much less

    half_angle < pi/2 (...) rad, distance (...) m. Returns (...): 1. Errors: none.
    Source: deck, Basic Radiometric Quantities (2).
    """
    distance = np.asarray(distance, float)
    reach = distance * np.tan(np.asarray(half_angle, float))
    return projected_solid_angle_disk(2 * reach, 2 * distance, 0.0) / projected_solid_angle_disk(reach, distance, 0.0)


def radiant_exitance_reflected(rho, irradiance):
    """The exitance, or radiosity, of a surface that sends back a share of what it gets.

    rho irradiance

    rho (...) 0 .. 1, irradiance (...) W/m^2. Returns (...) W/m^2. Errors: none.
    Source: deck, Basic Radiometric Quantities (3).
    """
    return np.asarray(rho, float) * np.asarray(irradiance, float)


def radiant_exitance_absorbed(rho, irradiance):
    """What a surface keeps of what it gets.

    (1 - rho) irradiance

    rho (...) 0 .. 1, irradiance (...) W/m^2. Returns (...) W/m^2. Errors: none. Source: the balance of energy.
    """
    return (1 - np.asarray(rho, float)) * np.asarray(irradiance, float)


def radiance_lambert(rho, irradiance):
    """The radiance of a matt surface: the same in all directions.

    rho irradiance / pi

    rho (...) 0 .. 1, irradiance (...) W/m^2. Returns (...) W/(m^2 sr). Errors: none. Source: Lambert 1760, Photometria.
    """
    return radiant_exitance_reflected(rho, irradiance) / pi


def intensity_per_area_lambert(rho, irradiance, theta):
    """The intensity of a matt surface per area of it: what a direction carries off.

    rho irradiance / pi max(0, cos theta)

    rho (...) 0 .. 1, irradiance (...) W/m^2, theta (...) rad. Returns (...) W/(m^2 sr). Errors: none.
    Source: Lambert 1760, Photometria.
    """
    return radiance_lambert(rho, irradiance) * _cosine(theta)


def radiance_lambert_over_hemisphere(rho, irradiance):
    """What one gets for the radiance of a matt surface when the cosine is forgotten: the exitance over 2 pi.

    rho irradiance / (2 pi), half of the truth

    rho (...) 0 .. 1, irradiance (...) W/m^2. Returns (...) W/(m^2 sr). Errors: a factor of 2, on purpose.
    Source: a common mistake.
    """
    return radiant_exitance_reflected(rho, irradiance) / (2 * pi)


def radiant_exitance_lambert(radiance):
    """The exitance of a surface that sends out the same radiance in all directions.

    pi radiance

    radiance (...) W/(m^2 sr). Returns (...) W/m^2. Errors: none. Source: Lambert 1760, Photometria.
    """
    return pi * np.asarray(radiance, float)
