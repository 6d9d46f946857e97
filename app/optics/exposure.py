"""From luminance to the number in a file: exposure, tone curve, sRGB; and the way of one number from lamp to pixel.

The number is that of a matt card straight under a lamp that shines evenly in all directions. `curve` 0: cut at 1;
1: Reinhard's x / (1 + x); 2: Narkowicz's fit to the ACES film curve; another number counts as 2.
"""

import numpy as np

from app.optics.colour import linear_to_srgb
from app.optics.photometry import illuminance_isotropic, luminance_lambert

METER = 12.5  # cd s / m^2 at ISO 100: the constant K of reflected-light meters, ISO 2720:1974
SATURATION = 1.2  # 0.78 lx s saturate a sensor of ISO 100 (ISO 12232:2006); of a lens 0.65 arrives: 0.78 / 0.65


def exposure_value(luminance):
    """The exposure that a light meter chooses for a scene of a mean luminance, as EV at ISO 100.

    log2(100 luminance / 12.5)

    luminance > 0 (...) cd/m^2. Returns (...), 1 more for twice the light. Errors: none. Source: ISO 2720:1974.
    """
    return np.log2(100 / METER * np.asarray(luminance, float))


def luminance_white(ev100):
    """The luminance that just fills the sensor of a camera set to an exposure.

    1.2 2^ev100

    ev100 (...) EV at ISO 100. Returns (...) cd/m^2. Errors: none; lenses differ from 0.65. Source: ISO 12232:2006;
    Lagarde and de Rousiers 2014, Moving Frostbite to physically based rendering.
    """
    return SATURATION * np.exp2(np.asarray(ev100, float))


def exposed_luminance(luminance, ev100):
    """What a camera makes of a luminance: a linear number, 1 where the sensor is just full.

    luminance / luminance_white

    luminance (...) cd/m^2, ev100 (...). Returns (...). Errors: none. Source: see luminance_white.
    """
    return np.asarray(luminance, float) / luminance_white(ev100)


def tone_curve(scene_linear, curve):
    """The share of the screen's white for a linear number of any size.

    min(x, 1); x / (1 + x); min(1, x (2.51 x + 0.03) / (x (2.43 x + 0.59) + 0.14)), x = scene_linear

    scene_linear >= 0 (...), curve (...) 0 .. 2. Returns (...) 0 .. 1. Errors: a matter of taste. Source: Reinhard et
    al. 2002, Photographic tone reproduction; Narkowicz 2015, ACES filmic tone mapping curve.
    """
    x, curve = np.broadcast_arrays(np.asarray(scene_linear, float), np.asarray(curve))
    film = np.minimum(1.0, x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14))
    return np.select([curve == 0, curve == 1], [np.minimum(x, 1.0), x / (1 + x)], film)[()]


def stored_number(linear):
    """The number that a file with 8 bits keeps of a share of the screen's white, not yet rounded.

    255 linear_to_srgb(linear)

    linear (...) 0 .. 1. Returns (...) 0 .. 255. Errors: none. Source: IEC 61966-2-1.
    """
    return 255 * linear_to_srgb(linear)


def stops(gain):
    """By how many EV a camera is closed to make up for more light.

    log2(gain)

    gain (...) > 0, how many times more. Returns (...) EV. Errors: none. Source: ISO 2720:1974: 1 EV halves the light.
    """
    return np.log2(np.asarray(gain, float))


def card_luminance(luminous_flux, distance, rho):
    """The luminance of a matt card straight under the lamp.

    rho luminous_flux / (4 pi^2 distance^2)

    luminous_flux (...) lm, distance > 0 (...) m, rho (...). Returns (...) cd/m^2. Errors: none.
    Source: deck, Working with Shading Models; Lambert 1760.
    """
    return luminance_lambert(rho, illuminance_isotropic(luminous_flux, distance, 0.0))


def card_exposed(luminous_flux, distance, rho, ev100):
    """The card as the camera's sensor has it: 1 is just full.

    exposed_luminance of card_luminance

    luminous_flux (...) lm, distance > 0 (...) m, rho (...), ev100 (...). Returns (...). Errors: none.
    Source: see luminance_white.
    """
    return exposed_luminance(card_luminance(luminous_flux, distance, rho), ev100)


def card_toned(luminous_flux, distance, rho, ev100, curve):
    """The card as a share of the screen's white.

    tone_curve of card_exposed

    luminous_flux (...) lm, distance > 0 (...) m, rho (...), ev100 (...), curve (...) 0 .. 2. Returns (...) 0 .. 1.
    Errors: those of tone_curve. Source: see tone_curve.
    """
    return tone_curve(card_exposed(luminous_flux, distance, rho, ev100), curve)


def card_stored(luminous_flux, distance, rho, ev100, curve):
    """The card's number in the file, not yet rounded.

    stored_number of card_toned

    luminous_flux (...) lm, distance > 0 (...) m, rho (...), ev100 (...), curve (...) 0 .. 2. Returns (...) 0 .. 255.
    Errors: those of tone_curve. Source: IEC 61966-2-1.
    """
    return stored_number(card_toned(luminous_flux, distance, rho, ev100, curve))
