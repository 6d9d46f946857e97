"""What light is worth to the eye: V(lambda), lumens, candela, lux, and the spectra of a few lamps.

Two constants are kept apart. 683 lm/W belongs, by definition of the candela, to light of 540 THz (555.17 nm in vacuum);
K_M = 683.002 lm/W belongs to the peak of V, tabulated at 555 nm in air. And two efficacies: lumens over watts radiated
(of radiation), and lumens over watts drawn from the mains (of a source).
"""

import numpy as np
from numpy import pi

from app.optics.radiometry import irradiance_point

K_CD = 683.0  # lm/W at 540 THz, exact: SI brochure 2019, section 2.3.1
K_M = 683.002  # lm/W at 555 nm in air: CIE 018:2019
C_1 = 1.1910429723971884e20  # 2 h c^2 in W nm^4 / (m^2 sr): CODATA 2018, exact; radiance per nm, wavelengths in nm
C_2 = 14387768.775039337  # h c / k in nm K: CODATA 2018, exact
STEFAN = 5.670374419184429e-08  # W / (m^2 K^4): 2 pi^5 k^4 / (15 h^3 c^2), CODATA 2018, exact
WIEN = 2897771.955185172  # nm K: CODATA 2018, exact

# CIE 1924 photopic V(lambda), 380 to 780 nm every 5 nm: CIE 018:2019 (the values of the CIE 1931 y-bar). Compared with
# the table at 1 nm of the package colour-science: the same within 2e-7, which is the rounding of this one.
V_LAMBDA = np.array([
    0.000039, 0.000064, 0.00012, 0.000217, 0.000396, 0.00064, 0.00121, 0.00218, 0.004, 0.0073,
    0.0116, 0.01684, 0.023, 0.0298, 0.038, 0.048, 0.06, 0.0739, 0.09098, 0.1126,
    0.13902, 0.1693, 0.20802, 0.2586, 0.323, 0.4073, 0.503, 0.6082, 0.71, 0.7932,
    0.862, 0.91485, 0.954, 0.9803, 0.99495, 1.0, 0.995, 0.9786, 0.952, 0.9154,
    0.87, 0.8163, 0.757, 0.6949, 0.631, 0.5668, 0.503, 0.4412, 0.381, 0.321,
    0.265, 0.217, 0.175, 0.1382, 0.107, 0.0816, 0.061, 0.04458, 0.032, 0.0232,
    0.017, 0.01192, 0.00821, 0.005723, 0.004102, 0.002929, 0.002091, 0.001484, 0.001047, 0.00074,
    0.00052, 0.000361, 0.000249, 0.000172, 0.00012, 0.0000848, 0.00006, 0.0000424, 0.00003, 0.0000212,
    0.00001499,
])
_NM = np.arange(380.0, 785.0, 5.0)


def luminous_efficiency(wavelength):
    """How much of its power light of one wavelength is worth to the eye, by day: V(lambda), 1 at 555 nm.

    the CIE 1924 table every 5 nm, linear in between; 0 outside 380 .. 780 nm

    wavelength (...) nm, in air. Returns (...). Errors: of the linear interpolation up to 2.2e-3, at 498 nm.
    Source: CIE 018:2019.
    """
    return np.interp(np.asarray(wavelength, float), _NM, V_LAMBDA, 0.0, 0.0)


def luminous_efficacy_monochromatic(wavelength):
    """Lumens per radiated watt of light of one wavelength.

    683.002 V(wavelength)

    wavelength (...) nm. Returns (...) lm/W. Errors: those of luminous_efficiency.
    Source: deck, Units for Lighting - Lumen.
    """
    return K_M * luminous_efficiency(wavelength)


def luminous_flux_radiated(radiant_flux, radiation_efficacy):
    """The lumens of a radiated flux.

    radiant_flux radiation_efficacy

    radiant_flux (...) W of light, radiation_efficacy (...) lm/W radiated. Returns (...) lm. Errors: none.
    Source: deck, Units for Lighting - Lumen.
    """
    return np.asarray(radiant_flux, float) * np.asarray(radiation_efficacy, float)


def luminous_flux_source(electrical_power, source_efficacy):
    """The lumens of a lamp that draws a power from the mains.

    electrical_power source_efficacy: the deck's 100 W at 30 lm/W are 3000 lm

    electrical_power (...) W drawn, source_efficacy (...) lm/W drawn. Returns (...) lm. Errors: none.
    Source: deck, Units for Lighting - Lumen.
    """
    return np.asarray(electrical_power, float) * np.asarray(source_efficacy, float)


def luminous_intensity_isotropic(luminous_flux):
    """The candela of a lamp that shines evenly in all directions.

    luminous_flux / (4 pi)

    luminous_flux (...) lm. Returns (...) cd. Errors: none. Source: deck, Units for Lighting - Candela.
    """
    return np.asarray(luminous_flux, float) / (4 * pi)


def radiant_intensity_540thz(luminous_intensity):
    """The radiant intensity of a source at 540 THz, by the definition of the candela.

    luminous_intensity / 683

    luminous_intensity (...) cd. Returns (...) W/sr. Errors: none. Source: SI brochure 2019, section 2.3.1.
    """
    return np.asarray(luminous_intensity, float) / K_CD


def illuminance_point(luminous_intensity, distance, theta):
    """The illuminance that a point source gives to a surface turned away from it by an angle.

    luminous_intensity max(0, cos theta) / distance^2

    luminous_intensity (...) cd, distance (...) m, theta (...) rad. Returns (...) lx; infinite at distance 0.
    Errors: none. Source: deck, Units for Lighting - Candela.
    """
    return irradiance_point(luminous_intensity, distance, theta)


def illuminance_isotropic(luminous_flux, distance, theta):
    """The illuminance of a point source of a luminous flux, even in all directions.

    luminous_flux max(0, cos theta) / (4 pi distance^2)

    luminous_flux (...) lm, distance > 0 (...) m, theta (...) rad. Returns (...) lx. Errors: none.
    Source: deck, Units for Lighting - Candela.
    """
    return illuminance_point(luminous_intensity_isotropic(luminous_flux), distance, theta)


def luminance_lambert(rho, illuminance):
    """The luminance of a matt surface.

    rho illuminance / pi

    rho (...) 0 .. 1, illuminance (...) lx. Returns (...) cd/m^2. Errors: none. Source: Lambert 1760, Photometria.
    """
    return np.asarray(rho, float) * np.asarray(illuminance, float) / pi


def planck_radiance(wavelength, temperature):
    """The spectral radiance of a black body.

    C_1 / wavelength^5 e^-x / (1 - e^-x), x = C_2 / (wavelength temperature), 1 - e^-x as expm1: nothing overflows for
    large x nor cancels for small x

    wavelength (...) nm, temperature > 0 (...) K. Returns (...) W / (m^2 sr nm). Errors: none.
    Source: Planck 1901; constants CODATA 2018.
    """
    wavelength = np.asarray(wavelength, float)
    x = C_2 / (wavelength * np.asarray(temperature, float))
    return C_1 / wavelength**5 * np.exp(-x) / -np.expm1(-x)


def planck_radiance_naive(wavelength, temperature):
    """The spectral radiance of a black body as printed, which loses digits of long waves from hot bodies.

    C_1 / wavelength^5 / (e^x - 1), x = C_2 / (wavelength temperature)

    wavelength (...) nm, temperature > 0 (...) K. Returns (...) W / (m^2 sr nm). Errors: float32 1e-5 at x = 0.01;
    from x = 89 on e^x overflows. Source: Planck 1901.
    """
    wavelength = np.asarray(wavelength, float)
    x = C_2 / (wavelength * np.asarray(temperature, float))
    return C_1 / wavelength**5 / (np.exp(x) - 1)


def planck_relative(wavelength, wavelength_high, temperature):
    """The spectral radiance of a black body at one wavelength, as a share of that at another.

    planck_radiance(wavelength) / planck_radiance(wavelength_high), the two exponents subtracted as
    C_2 (wavelength - wavelength_high) / (wavelength wavelength_high temperature), which does not cancel

    wavelength, wavelength_high (...) nm, temperature > 0 (...) K. Returns (...). Errors: none.
    Source: Planck 1901; constants CODATA 2018.
    """
    wavelength, wavelength_high = np.asarray(wavelength, float), np.asarray(wavelength_high, float)
    x, x_high = (C_2 / (nm * np.asarray(temperature, float)) for nm in (wavelength, wavelength_high))
    step = x_high * ((wavelength - wavelength_high) / wavelength)
    return (wavelength_high / wavelength) ** 5 * np.exp(step) * np.expm1(-x_high) / np.expm1(-x)


def led_spectrum(wavelength):
    """The relative spectrum of a white LED: a blue line and the broad glow of a phosphor.

    0.9 exp(-((wavelength - 452) / 10)^2 / 2) + exp(-((wavelength - 585) / 58)^2 / 2)

    wavelength (...) nm. Returns (...), about 1 at most. Errors: a fit by eye to the usual shape, no lamp's measurement.
    Source: ours.
    """
    wavelength = np.asarray(wavelength, float)
    return 0.9 * np.exp(-0.5 * ((wavelength - 452) / 10) ** 2) + np.exp(-0.5 * ((wavelength - 585) / 58) ** 2)


def lamp_spectrum(lamp, wavelength, temperature):
    """The relative spectrum of a lamp, about 1 where it is largest between 380 and 780 nm.

    lamp 0: a black body of the temperature; 1: led_spectrum; 2: equal energy, 1 everywhere

    lamp (...) 0, 1, 2, wavelength (...) nm, temperature (...) K. Returns (...). Errors: those of led_spectrum.
    Source: deck, Units for Lighting - Lumen.
    """
    lamp, top = np.asarray(lamp), np.clip(WIEN / np.asarray(temperature, float), 380, 780)
    black = planck_relative(wavelength, top, temperature)
    return np.select([lamp == 0, lamp == 1], [black, led_spectrum(wavelength)], 1.0)[()]


def luminous_efficacy_planck(temperature):
    """Lumens per radiated watt of a black body, all of its spectrum counted.

    683.002 int V L d lambda / (sigma T^4 / pi), the integral as the sum over the table of V every 5 nm

    temperature (...) K. Returns (...) lm/W, at most about 95, near 6600 K. Errors: of the sum below 1e-4.
    Sources: deck, Units for Lighting - Watts; Stefan 1879, Boltzmann 1884 for the whole.
    """
    temperature = np.asarray(temperature, float)
    seen = 5 * np.sum(V_LAMBDA * planck_radiance(_NM, temperature[..., None]), -1)
    return K_M * seen / (STEFAN / pi * temperature**4)


def luminous_efficacy_band(temperature, wavelength_low, wavelength_high):
    """Lumens per radiated watt of a lamp that sends out a black body's light between two wavelengths and none beyond.

    683.002 int V L d lambda / int L d lambda, both by the midpoint rule with 400 steps

    temperature (...) K, wavelength_low < wavelength_high (...) nm. Returns (...) lm/W: 251 for 5800 K, 400 .. 700 nm.
    Errors: of the rule below 1e-4. Source: Murphy 2012, Maximum spectral luminous efficacy of white light.
    """
    temperature, low, high = (np.asarray(x, float)[..., None] for x in (temperature, wavelength_low, wavelength_high))
    at = low + (high - low) * (np.arange(400) + 0.5) / 400
    light = planck_radiance(at, temperature)
    return K_M * np.sum(luminous_efficiency(at) * light, -1) / np.sum(light, -1)


def luminous_efficacy_lamp(lamp, temperature):
    """Lumens per radiated watt of a lamp.

    lamp 0: a black body, all of its spectrum; 1: the LED; 2: equal energy from 380 to 780 nm;
    683.002 sum V S / sum S over the table every 5 nm, half of S at both ends

    lamp (...) 0, 1, 2, temperature (...) K. Returns (...) lm/W. Errors: of the sums below 1e-4, those of led_spectrum.
    Source: deck, Units for Lighting - Lumen.
    """
    lamp, ends = np.asarray(lamp), np.where((_NM == 380) | (_NM == 780), 0.5, 1.0)
    led, even = (K_M * np.sum(ends * V_LAMBDA * s) / np.sum(ends * s) for s in (led_spectrum(_NM), np.ones(81)))
    return np.select([lamp == 0, lamp == 1], [luminous_efficacy_planck(temperature), led], even)[()]
