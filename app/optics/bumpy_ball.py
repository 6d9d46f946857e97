"""The error of a picture of a bumpy mirror ball, against a truth that looks at 224 places of each pixel.

The ball is 600 pixels wide; its bumps are six waves along the axes of an icosahedron, as in the lesson's scene. Looked
at are 64 pixels spread over the disk, and in each the light of the lamp beside the eye as a screen shows it, 1 - e^-L.
"""

from functools import lru_cache

import numpy as np
from numpy import pi

from app.optics.beckmann import SMOOTHEST, d_beckmann_slope, exponent_from_m
from app.optics.ndf import d_blinn_phong_slope
from app.optics.scale_effect import PIXELS, bump_kept, normal_shortfall

PLACES, TRUTH = 64, 224
ROUNDING = 1e-15  # an error below is one of the sums
LIGHT = 0.19  # what D becomes in the scene before the screen bends it
_A, _B = 0.5257311121191336, 0.8506508083520399
_WAVES = np.array([[0, _A, _B], [0, -_A, _B], [_A, _B, 0], [-_A, _B, 0], [_B, 0, _A], [_B, 0, -_A]])
_RATES = np.array([1.0, 0.83, 1.17, 0.91, 1.09, 1.26])
_R2 = np.array([0.7548777, 0.5698403])


def _disk():
    """Normals (places, 3) and their steps to the next pixel, right and up; the eye is on +z."""
    u = np.mod(0.5 + np.arange(PLACES)[:, None] * _R2, 1)
    r, turn = 0.95 * np.sqrt(u[:, 0]), 2 * pi * u[:, 1]
    x, y = r * np.cos(turn), r * np.sin(turn)
    z = np.sqrt(1 - x * x - y * y)
    zero = 0 * x
    return np.stack([x, y, z], -1), np.stack([zero + 1, zero, -x / z], -1), np.stack([zero, zero + 1, -y / z], -1)


_N, _ACROSS, _DOWN = _disk()
_PHASE = _N @ _WAVES.T
_STEPS = np.stack([_ACROSS @ _WAVES.T, _DOWN @ _WAVES.T], -1) * 2 / PIXELS  # (places, waves, 2), for a rate of 1


def _offsets(count, place):
    """Places (count, 2) in a pixel, from -1/2 to 1/2, another pattern for each pixel."""
    start = np.mod(0.5 + place[:, None, None] * np.array([0.618034, 0.324718]), 1)
    return np.mod(start + np.arange(count)[:, None] * _R2, 1) - 0.5


def _squared(slope, n=_N):
    """tan^2 of the angle between the eye and the normal n - slope (..., 3), which is not of unit length."""
    slope = slope - n * np.sum(n * slope, -1, keepdims=True)
    bump = n - slope
    towards = np.maximum(bump[..., 2], 1e-9)
    return (bump[..., 0] ** 2 + bump[..., 1] ** 2) / towards**2


def _mean(count, bumps, bump_slope, m, place):
    """D, averaged over so many places of each pixel (places,)."""
    rate = 0.5 * bumps * _RATES
    steps = np.einsum("pkc,pwc->pkw", _offsets(count, place), _STEPS)
    turns = (_PHASE[:, None] + steps) * rate + 0.37 * np.arange(6)
    return d_beckmann_slope(_squared(bump_slope * (np.sin(2 * pi * turns) @ _WAVES), _N[:, None]), m).mean(1)


@lru_cache(64)
def _truth(bumps, bump_slope, m):
    return _mean(TRUTH, bumps, bump_slope, m, np.arange(PLACES))


@lru_cache(4096)
def _error(bumps, bump_slope, m, samples, filtering):
    place, truth = np.arange(PLACES), _truth(bumps, bump_slope, m)
    if filtering == 1:
        found = _mean(samples, bumps, bump_slope, m, place + 7)
    else:
        rate = 0.5 * bumps * _RATES
        kept = bump_kept(PIXELS * rate * np.linalg.norm(_STEPS, axis=-1)) if filtering > 1 else np.ones((PLACES, 6))
        slope = (kept * np.sin(2 * pi * (_PHASE * rate + 0.37 * np.arange(6)))) @ _WAVES
        hidden = bump_slope**2 * np.sum(0.5 * (1 - kept * kept) * (1 - _PHASE**2), -1)
        slope2 = _squared(bump_slope * slope)
        if filtering == 3:
            e, short = exponent_from_m(min(m, 1.0)), normal_shortfall(np.sqrt(0.5 * hidden))
            found = d_blinn_phong_slope(slope2, e * (1 - short) / (1 - short + e * short))
        else:
            found = d_beckmann_slope(slope2, np.sqrt(m * m + hidden))
    off = np.sqrt(np.mean((np.exp(-LIGHT * found) - np.exp(-LIGHT * truth)) ** 2))
    return off if off > ROUNDING else 0.0


def ball_error(bumps, bump_slope, m, samples, filtering):
    """How wrong the pixels of a bumpy mirror ball are shown: root mean square over its disk; 1 is the screen's white.

    sqrt(mean (e^-L_p - e^-T_p)^2) over 64 pixels p, L = 0.19 D; T_p from the mean of D over 224 places of the pixel,
    L_p by filtering 0: its middle alone; 1: the mean of `samples` places; 2: each wave as far as the pixel shows it,
    the rest as roughness, m^2 + S; 3: the same normal, the exponent lowered by Toksvig's rule for the rest

    bumps (...) across the ball, bump_slope (...) RMS slope along one axis, m (...) RMS slope of the facets, samples
    (...) >= 1, filtering (...) 0 .. 3. Returns (...). Errors: for m from 0.1 the truth's own is below 0.012 and the 64
    pixels stand for all to a quarter of the number. Source: Olano and Baker 2010; Toksvig 2005.
    """
    given = np.broadcast_arrays(*(np.asarray(x, float) for x in (bumps, bump_slope, m, samples, filtering)))
    rows = zip(*(g.ravel().tolist() for g in given), strict=True)
    found = [_error(b, s, max(r, SMOOTHEST), int(n), int(k)) for b, s, r, n, k in rows]
    return np.reshape(np.array(found), given[0].shape)[()]
