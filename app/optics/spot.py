"""Spotlights: full inside the hotspot cone, nothing outside the falloff cone, dimming between. Both are half angles.

H >= F is a hard edge at F: nothing is lit outside the falloff cone, whatever the hotspot says.
"""

import numpy as np
from numpy import pi


def _wedge(hotspot, falloff):
    return np.sin(0.5 * (falloff - hotspot)) * np.sin(0.5 * (falloff + hotspot))


def spot_linear(off_axis, hotspot, falloff):
    """The deck's spotlight: linear in the cosine between the hotspot and the falloff cone.

    clamp((cos a - cos F) / (cos H - cos F), 0, 1); each difference cos p - cos q is 2 sin((q-p)/2) sin((q+p)/2)

    off_axis a, hotspot H, falloff F (...) rad, half angles. Returns (...), 0 .. 1; H >= F: 1 up to F, then 0.
    Errors: none. Source: deck, Light Sources - Spotlights (2), with cos F as its last threshold.
    """
    a, hotspot, falloff = (np.asarray(x, float) for x in (off_axis, hotspot, falloff))
    hard = hotspot >= falloff
    value = np.clip(_wedge(a, falloff) / np.where(hard, 1, _wedge(hotspot, falloff)), 0, 1)
    return np.where(hard, (a <= falloff).astype(float), value)[()]


def spot_linear_naive(off_axis, hotspot, falloff):
    """The deck's spotlight by its cosines: cancels for narrow cones, and is inside out where the hotspot is the wider.

    clamp((cos a - cos F) / (cos H - cos F), 0, 1)

    off_axis a, hotspot H, falloff F (...) rad, half angles. Returns (...), 0 .. 1; 0/0 at H = F = a. Errors: those.
    Source: deck, Light Sources - Spotlights (2), with cos F as its last threshold.
    """
    a, hotspot, falloff = (np.asarray(x, float) for x in (off_axis, hotspot, falloff))
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.clip((np.cos(a) - np.cos(falloff)) / (np.cos(hotspot) - np.cos(falloff)), 0, 1)[()]


def spot_smooth(off_axis, hotspot, falloff):
    """The same spotlight with a smoothstep between the zones: no crease at either edge, and the same flux.

    t^2 (3 - 2 t), t = spot_linear

    off_axis, hotspot, falloff (...) rad, half angles. Returns (...), 0 .. 1. Errors: none.
    Source: deck, Light Sources - Spotlights (2), smoothed as usual in real-time engines.
    """
    t = np.asarray(spot_linear(off_axis, hotspot, falloff))
    return t * t * (3 - 2 * t)


def spot_linear_cos(cosine, hotspot, falloff):
    """The deck's spotlight from the cosine of the angle to its axis, -l.d with l to the light and d along the beam.

    q = (1 - cosine) / 2 = sin^2(a/2): clamp((sin^2(F/2) - q) / (sin((F+H)/2) sin((F-H)/2)), 0, 1)

    cosine (...), hotspot, falloff (...) rad, half angles. Returns (...), 0 .. 1; H >= F: 1 up to F, then 0.
    Errors: none but what rounding the cosine has lost. Source: deck, Light Sources - Spotlights (2); optics 2.7.
    """
    cosine, hotspot, falloff = (np.asarray(x, float) for x in (cosine, hotspot, falloff))
    hard, edge, q = hotspot >= falloff, np.sin(0.5 * falloff) ** 2, 0.5 * (1 - cosine)
    value = np.clip((edge - q) / np.where(hard, 1, _wedge(hotspot, falloff)), 0, 1)
    return np.where(hard, (q <= edge).astype(float), value)[()]


def spot_as_printed(off_axis, hotspot, falloff, threshold):
    """The spotlight as it is printed: the zone ends at an angle theta_L which the slide defines nowhere.

    1 if a < H; else 1 - (cos H - cos a) / (cos H - cos F) if a < threshold; else 0

    off_axis a, hotspot, falloff, threshold (...) rad. Returns (...); below 0, negative light, between the falloff and a
    wider threshold; not finite at H = F. Errors: that. Source: deck, Light Sources - Spotlights (2).
    """
    a, hotspot, falloff, threshold = (np.asarray(x, float) for x in (off_axis, hotspot, falloff, threshold))
    with np.errstate(divide="ignore", invalid="ignore"):
        between = _wedge(a, falloff) / _wedge(hotspot, falloff)
    return np.where(a < hotspot, 1.0, np.where(a < threshold, between, 0.0))[()]


def spot_flux(radiant_intensity, hotspot, falloff):
    """The flux of a spotlight, the same for the linear and the smooth edge.

    2 pi I ((1 - cos H) + (cos H - cos F) / 2) = 2 pi I (sin^2(H/2) + sin^2(F/2))

    radiant_intensity (...) W/sr in the hotspot, hotspot, falloff (...) rad, half angles. Returns (...) W; H >= F: the
    cone of F. Errors: none. Source: the integral of the deck's formula, Light Sources - Spotlights (2).
    """
    falloff = np.asarray(falloff, float)
    inner = np.sin(0.5 * np.minimum(hotspot, falloff)) ** 2
    return 2 * pi * np.asarray(radiant_intensity, float) * (inner + np.sin(0.5 * falloff) ** 2)


def spot_intensity(radiant_flux, hotspot, falloff):
    """The radiant intensity in the hotspot of a spotlight of a given flux.

    Phi / (2 pi (sin^2(H/2) + sin^2(F/2)))

    radiant_flux (...) W, hotspot, falloff (...) rad, half angles, falloff > 0. Returns (...) W/sr; 0 for flux 0,
    negative for a negative flux. Errors: none. Source: deck, Light Sources - Spotlights (2), integrated.
    """
    return np.asarray(radiant_flux, float) / spot_flux(1.0, hotspot, falloff)


def spot_read(off_axis, hotspot, falloff, threshold, edge, reading):
    """The spotlight as a program draws it that reads the angles or the cosine in its own way.

    reading 0: as meant; 1: full angles are taken for half ones, spot(a, 2 H, 2 F); 2: +l.d for -l.d,
    spot(pi - a, H, F); spot: edge 1 spot_smooth, 2 spot_as_printed, else spot_linear

    off_axis, hotspot, falloff, threshold (...) rad, edge, reading (...) int. Returns (...), as these. Errors: of 1
    about 4 times the flux; of 2 no light on what the lamp faces. Source: deck, Light Sources - Spotlights (2); D4.
    """
    a, hotspot, falloff = (np.asarray(x, float) for x in (off_axis, hotspot, falloff))
    wide, angle = np.where(np.asarray(reading) == 1, 2.0, 1.0), np.where(np.asarray(reading) == 2, pi - a, a)
    linear, smooth = (f(angle, wide * hotspot, wide * falloff) for f in (spot_linear, spot_smooth))
    printed = spot_as_printed(angle, wide * hotspot, wide * falloff, threshold)
    return np.where(np.asarray(edge) == 2, printed, np.where(np.asarray(edge) == 1, smooth, linear))[()]


def spot_read_flux(radiant_intensity, hotspot, falloff, reading):
    """The flux that reaches the half space before the lamp when a program reads the spotlight in its own way.

    spot_flux(I, H, F); reading 1: spot_flux(I, 2 H, 2 F), with what goes behind the lamp; reading 2: 0, all is behind

    radiant_intensity (...) W/sr, hotspot, falloff (...) rad, falloff < pi/2, reading (...) int. Returns (...) W.
    Errors: none. Source: the integral of the deck's formula, Light Sources - Spotlights (2); optics D4.
    """
    reading = np.asarray(reading)
    wide = np.where(reading == 1, 2.0, 1.0)
    flux = spot_flux(radiant_intensity, wide * np.asarray(hotspot, float), wide * np.asarray(falloff, float))
    return np.where(reading == 2, 0.0, flux)[()]
