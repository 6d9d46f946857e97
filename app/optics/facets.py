"""Thousands of facets of one plate, each with a normal of its own, so that one can count instead of integrate.

They are Beckmann's: the slopes of `facets` facets are even in the share of the plate that is less steep, their azimuths
in golden turns. Seen from above all are equally large.
"""

import numpy as np

from app.optics.beckmann import d_beckmann
from app.optics.spherical import light_and_view, light_direction, view_direction


def facet_slope(index, m, facets):
    """The slope of facet number `index`: at this quantile of Beckmann's distribution.

    m sqrt(-ln(1 - xi)), xi = (index + 1/2) / facets; beyond a half 1 - xi is (facets - index - 1/2) / facets

    index (...) 0 .. facets - 1, m (...) RMS slope, facets (...) >= 1. Returns (...). Errors: none.
    Source: Beckmann and Spizzichino 1963; Walter et al. 2007 sample so.
    """
    index, facets = np.asarray(index, float), np.asarray(facets, float)
    share, rest = (index + 0.5) / facets, (facets - index - 0.5) / facets
    return m * np.sqrt(-np.where(share < 0.5, np.log1p(-np.minimum(share, 0.5)), np.log(rest)))


def facet_normal(index, m, facets):
    """The normal of facet number `index`.

    (t cos phi, t sin phi, 1) / sqrt(1 + t^2), t = facet_slope, phi = 2 pi frac(index / 1.618...), as 2654435769 / 2^32

    index (...) 0 .. facets - 1, m (...) RMS slope, facets (...) >= 1. Returns (..., 3). Errors: none.
    Source: Beckmann and Spizzichino 1963; the spiral is Vogel's, 1979.
    """
    index, m, facets = np.broadcast_arrays(np.asarray(index, np.int64), np.asarray(m, float), np.asarray(facets))
    turn = 2 * np.pi * (((index * 2654435769 + 2**31) % 2**32 - 2**31) / 2**32)
    slope = facet_slope(index, m, facets)
    across = slope / np.hypot(1, slope)
    return np.stack([across * np.cos(turn), across * np.sin(turn), 1 / np.hypot(1, slope)], -1)


def facet_index(place, facets):
    """Which facet lies at a place of the plate: all of them once, in no order one sees.

    place * 16183 mod facets; 16183 is a prime above all that are asked, so each comes once

    place (...) 0 .. facets - 1, facets (...) >= 1, at most 16182. Returns (...). Errors: none.
    Source: a multiplicative shuffle.
    """
    return (np.asarray(place, np.int64) * 16183 % np.asarray(facets, np.int64)).astype(float)[()]


def facets_lit(theta_l, theta_v, phi, m, half_angle, facets):
    """How many facets mirror a round lamp into the eye: their normals lie within half_angle of h.

    count of |facet_normal - h| <= 2 sin(half_angle / 2), h = (l + v) / |l + v|

    theta_l, theta_v, phi (...) rad, m (...), half_angle (...) rad: half the angular radius of a lamp that shines back
    along l; across the plane of l and v it would be 1 / l.h wider. facets (...) >= 1. Returns (...). Errors: none.
    Source: deck, The Torrance - Sparrow Microfacet Model (2).
    """
    given = np.broadcast_arrays(*(np.asarray(x, float) for x in (theta_l, theta_v, phi, m, half_angle, facets)))
    counts = []
    for light, eye, turn, slope, angle, count in zip(*(g.ravel() for g in given), strict=True):
        h = light_direction(light, turn) + view_direction(eye)
        off = facet_normal(np.arange(int(count)), slope, int(count)) - h / max(np.linalg.norm(h), 1e-30)
        counts.append(np.count_nonzero(np.sum(off * off, -1) <= 4 * np.sin(0.5 * angle) ** 2))
    return np.reshape(np.array(counts, float), given[0].shape)[()]


def d_near(theta_l, theta_v, phi, m, half_angle, facets):
    """The distribution of facets at h by counting: those that mirror the lamp, over the size of their cone.

    facets_lit / (facets n.h pi sin^2 half_angle)

    theta_l, theta_v, phi (...) rad, m (...), half_angle (...) > 0 rad, facets (...) >= 1. Returns (...) 1/sr.
    Errors: relative, of order 1 / sqrt(count), and what D bends within the cone.
    Source: deck, Distribution Term (1): the share of facets towards h.
    """
    cone = np.pi * np.sin(half_angle) ** 2 * np.cos(halfway_angle(theta_l, theta_v, phi))
    return facets_lit(theta_l, theta_v, phi, m, half_angle, facets) / (np.asarray(facets, float) * cone)


def halfway_angle(theta_l, theta_v, phi):
    """The angle between n and h.

    atan2(|S x n|, S . n), S = l + v

    theta_l, theta_v, phi (...) rad. Returns (...) rad. Errors: none. Source: deck, The Blinn Model.
    """
    s = light_and_view(theta_l, theta_v, phi)
    return np.arctan2(np.hypot(s[..., 0], s[..., 1]), s[..., 2])


def d_halfway(theta_l, theta_v, phi, m):
    """Beckmann's distribution of facets at h: what d_near counts.

    d_beckmann(n, l + v, m)

    theta_l, theta_v, phi (...) rad, m (...). Returns (...) 1/sr. Errors: none. Source: deck, Distribution Term (2).
    """
    return d_beckmann(np.array([0.0, 0.0, 1.0]), light_and_view(theta_l, theta_v, phi), m)


def d_counted(theta_h, m, half_angle, facets):
    """The distribution of facets at an angle from the normal by counting: those of a ring, over its size.

    count of theta_h - half_angle <= angle < theta_h + half_angle, over facets times the ring's projected solid angle,
    pi (sin^2 b - sin^2 a), the ring's angles a and b cut at 0 and pi/2

    theta_h (...) rad, m (...), half_angle (...) > 0 rad, facets (...) >= 1. Returns (...) 1/sr.
    Errors: relative, of order 1 / sqrt(count), and what D bends within the ring.
    Source: deck, Distribution Term (1): the share of facets towards h.
    """
    given = np.broadcast_arrays(*(np.asarray(x, float) for x in (theta_h, m, half_angle, facets)))
    counts = []
    for at, slope, half, count in zip(*(g.ravel() for g in given), strict=True):
        angle = np.arctan(facet_slope(np.arange(int(count)), slope, count))
        counts.append(np.count_nonzero((angle >= at - half) & (angle < at + half)))
    return (np.reshape(counts, given[0].shape) / (given[3] * _ring(theta_h, half_angle)))[()]


def _ring(theta_h, half_angle):
    low, high = np.maximum(np.subtract(theta_h, half_angle), 0), np.minimum(np.add(theta_h, half_angle), np.pi / 2)
    return np.pi * np.sin(high - low) * np.sin(high + low)
