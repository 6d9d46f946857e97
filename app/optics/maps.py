"""Maps of a lacquered plate with a gilded ornament: numbers a file stores, and what reading them wrongly does.

A colour is stored as sRGB and must be decoded; a roughness or a normal is stored as it is and must not be.
`map_s`, `map_t` from 0 to 1 are the place on the map.
"""

import numpy as np
from numpy import pi

from app.optics.colour import srgb_to_linear


def map_pattern(map_s, map_t):
    """Where the plate is gilded: 1 on the ornament, 0 on the lacquer.

    1/2 + 5 (||q| - 1| - 2/3) cut to [0, 1], q = cos(6 pi s) + cos(6 pi t): a lattice with studs in its meshes

    map_s, map_t (...) 0 .. 1. Returns (...) 0 .. 1. Errors: none. Source: made up for this course.
    """
    q = np.cos(6 * pi * np.asarray(map_s, float)) + np.cos(6 * pi * np.asarray(map_t, float))
    return np.clip(0.5 + 5 * (np.abs(np.abs(q) - 1) - 2 / 3), 0.0, 1.0)


def _sampled(texels, map_s, map_t):
    """The first channel of a map (rows, columns, 4) of bytes, bilinear between the middles of texels, repeated."""
    rows, columns = texels.shape[:2]
    x, y = np.asarray(map_s, float) * columns - 0.5, np.asarray(map_t, float) * rows - 0.5
    i, j = np.floor(x), np.floor(y)
    a, b = x - i, y - j

    def at(i, j):
        return texels[np.mod(j, rows).astype(int), np.mod(i, columns).astype(int), 0] / 255.0

    return (1 - b) * ((1 - a) * at(i, j) + a * at(i + 1, j)) + b * ((1 - a) * at(i, j + 1) + a * at(i + 1, j + 1))


def plate_roughness(map_s, map_t):
    """The roughness of the plate, which has been wiped, and its gold is worn.

    (0.30 + 0.12 p) + (0.13 + 0.07 p) w, p = map_pattern, w = sin(2 pi (3 s + 2 t) + 2 sin(4 pi t)), the strokes

    map_s, map_t (...) 0 .. 1. Returns (...) 0.17 .. 0.62. Errors: none. Source: made up for this course.
    """
    s, t = np.asarray(map_s, float), np.asarray(map_t, float)
    strokes = np.sin(2 * pi * (3 * s + 2 * t) + 2 * np.sin(4 * pi * t))
    p = map_pattern(s, t)
    return 0.30 + 0.12 * p + (0.13 + 0.07 * p) * strokes


def stored_roughness(roughness_map, map_s, map_t):
    """What the roughness map stores: a user's, or that of the plate.

    a map: its first channel, bilinear; without one (its fourth channel is 0) plate_roughness

    roughness_map (rows, columns, 4) bytes, the lowest row first, map_s, map_t (...) 0 .. 1. Returns (...) 0 .. 1.
    Errors: none. Source: made up for this course.
    """
    if roughness_map[0, 0, 3]:
        return _sampled(roughness_map, map_s, map_t)
    return plate_roughness(map_s, map_t)


def roughness_as_srgb(roughness_map, map_s, map_t):
    """What a program makes of it that takes the roughness map for a colour.

    srgb_to_linear(stored_roughness)

    roughness_map (rows, columns, 4), map_s, map_t (...) 0 .. 1. Returns (...). Errors: none. Source: IEC 61966-2-1,
    where it does not belong.
    """
    return srgb_to_linear(stored_roughness(roughness_map, map_s, map_t))


def srgb_gap(encoded):
    """How many times larger a stored number is than what decoding makes of it: a colour that is not decoded is so much
    too bright.

    x / srgb_to_linear(x); 12.92 up to 0.04045

    encoded (...) 0 .. 1. Returns (...) 1 .. 12.92. Errors: none. Source: IEC 61966-2-1.
    """
    x = np.asarray(encoded, float)
    bright = np.maximum(x, 0.04045)
    return np.where(x <= 0.04045, 12.92, bright / srgb_to_linear(bright))[()]


def peak_gain(encoded):
    """How many times higher a highlight's peak gets when its roughness is decoded as if it were a colour.

    (x / srgb_to_linear(x))^2: D(0) is 1 / (pi m^2)

    encoded (...) 0 .. 1. Returns (...) 1 .. 167. Errors: none. Source: deck, Distribution Term (2); IEC 61966-2-1.
    """
    return srgb_gap(encoded) ** 2


def peak_gain_at(roughness_map, map_s, map_t):
    """The same at a place of the plate.

    peak_gain(stored_roughness)

    roughness_map (rows, columns, 4), map_s, map_t (...) 0 .. 1. Returns (...). Errors: none. Source: as peak_gain.
    """
    return peak_gain(stored_roughness(roughness_map, map_s, map_t))
