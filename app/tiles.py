"""Tiles of the hemisphere above a surface, in the angles about its normal +z, for sums over directions.

A tile is a rectangle in the unit square (s, t) of one of the parts that meet at the mirror direction of an eye, or at
the eye: theta below or above the eye's, phi on that side. Steps grow with the distance from there, as in
app/hemisphere.py, and the parts end exactly at the horizon.
"""

from dataclasses import dataclass, fields
from itertools import product

import numpy as np

STEEPER = 0.2  # a side is cut where its difference is more than this share of the other's


@dataclass(frozen=True)
class Tiles:
    """Arrays (tiles,): of which angle, which part of the hemisphere, the lower corner and the sides in (s, t)."""

    at: np.ndarray
    above: np.ndarray  # -1: theta below the eye's, 1: above it
    eye: np.ndarray  # 0: about the mirror direction, 1: about the eye
    hand: np.ndarray  # 1 or -1: the sign of phi
    s: np.ndarray
    t: np.ndarray
    wide: np.ndarray  # along s, which is phi
    high: np.ndarray  # along t, which is theta

    def __getitem__(self, which: np.ndarray) -> "Tiles":
        return Tiles(*(getattr(self, f.name)[which] for f in fields(self)))

    def cut(self, off: np.ndarray) -> "Tiles":
        """Halves along the sides whose differences `off` (2, tiles), of t and of s, are not small beside the other."""
        of_t, of_s = off[0] > STEEPER * off[1], off[1] > STEEPER * off[0]
        wide, high = np.where(of_s, 0.5, 1.0) * self.wide, np.where(of_t, 0.5, 1.0) * self.high
        parts = []
        for i, j in product((0, 1), (0, 1)):
            moved = Tiles(self.at, self.above, self.eye, self.hand, self.s + i * wide, self.t + j * high, wide, high)
            parts.append(moved[(of_s | (i == 0)) & (of_t | (j == 0))])
        return Tiles(*(np.concatenate([getattr(part, f.name) for part in parts]) for f in fields(self)))

    def directions(self, theta: np.ndarray, width: np.ndarray, nodes: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Directions l (tiles, nodes^2, 3), along theta first, and the solid angle of each per unit of its tile.

        `theta` (angles,) of the eye, `width` (2, angles) of the lobes about the mirror direction and the eye."""
        middle, narrow = theta[self.at], width[self.eye, self.at]
        room = np.where(self.above > 0, 0.5 * np.pi - middle, middle)
        away, per_t = stretched(self.t, self.high, room, narrow, nodes)
        aside, per_s = stretched(self.s, self.wide, 0.5 * np.pi + 0 * room,
                                 np.minimum(narrow / np.maximum(np.sin(middle), 1e-9), 2.0), nodes)
        away = self.above[:, None] * away
        sine, cosine = np.sin(middle[:, None] + away), np.sin(0.5 * np.pi - middle[:, None] - away)
        x, y = np.cos(aside) * (2 * self.eye - 1)[:, None], np.sin(aside) * self.hand[:, None]
        l = np.empty((len(self.at), len(nodes), len(nodes), 3))
        l[..., 0], l[..., 1] = sine[:, :, None] * x[:, None, :], sine[:, :, None] * y[:, None, :]
        l[..., 2] = cosine[:, :, None]
        weight = (sine * per_t)[:, :, None] * per_s[:, None, :]
        return l.reshape(len(self.at), -1, 3), weight.reshape(len(self.at), -1)


def stretched(low: np.ndarray, side: np.ndarray, length: np.ndarray, width: np.ndarray,
              nodes: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Distances (tiles, nodes) from 0 to `length`, dense towards 0 by `width`; their change per unit of the tile."""
    grow = np.arcsinh(length / width)
    away = width[:, None] * np.sinh(grow[:, None] * (low[:, None] + side[:, None] * nodes))
    return away, (grow * side)[:, None] * np.hypot(width[:, None], away)


def first_tiles(theta: np.ndarray, both_sides: bool, across: int = 2) -> Tiles:
    """The hemisphere at every angle of the eye in `across` x `across` tiles a part; of one hand or both."""
    corners = np.arange(across) / across
    found = np.array([one for one in product(range(len(theta)), (-1, 1), (0, 1), (1, -1)[:1 + both_sides], corners,
                                             corners) if one[1] > 0 or theta[one[0]] > 0])
    at, above, eye, hand = found[:, :4].astype(int).T
    side = np.full(len(found), 1 / across)
    return Tiles(at, above, eye, hand, found[:, 4], found[:, 5], side, side)
