"""What must hold for any answer: light and eye swapped, no negative value, no value above 1, no more light than came.

A property is judged on the answers themselves; the judge pays it as far as the answers agree with the reference, so
that `return 0`, which breaks none, earns nothing.
"""

import numpy as np

from app.grade.points import tilted
from app.quadrature import gauss_legendre

SWAPS = (("l", "v"), ("n_dot_l", "n_dot_v"), ("theta_l", "theta_v"), ("lean_l", "lean_v"))
GRIDS = ((12, 24), (16, 32))  # polar angles x azimuths, of the two sums over the hemisphere
SETTINGS = 6  # of the other arguments
EDGE = 0.02  # a sum that is above 1 by less may owe it to the sum itself


def swapped(arguments: tuple[str, ...]) -> dict[str, str]:
    """Which argument takes the place of which, when light and eye are swapped."""
    return {one: other for pair in SWAPS if set(pair) <= set(arguments)
            for one, other in (pair, pair[::-1])}


def swap(args: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    partner = swapped(tuple(args))
    return {name: args[partner.get(name, name)] for name in args}


def hemisphere(args: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    """For each of SETTINGS rows, both grids of directions l over the hemisphere of n, one behind the other."""
    first = {name: x[:SETTINGS] for name, x in args.items()}
    polar, turn, _ = grid()
    count = len(polar)
    found = {name: np.repeat(x, count, 0) for name, x in first.items()}
    rows = len(first["n"])
    found["l"] = tilted(found["n"], np.tile(polar, rows), np.tile(turn, rows)).astype(np.float32).astype(float)
    return found


def grid() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Angles from n, azimuths and weights (cosine included) of both grids."""
    parts = []
    for polar, around in GRIDS:
        x, w = gauss_legendre(polar)  # of sin^2 theta: the cosine is in the measure
        turn = 2 * np.pi * (np.arange(around) + 0.5) / around
        parts.append((np.repeat(np.arcsin(np.sqrt(x)), around), np.tile(turn, polar),
                      np.repeat(w * np.pi / around, around)))
    return tuple(np.concatenate(part) for part in zip(*parts, strict=True))  # type: ignore[return-value]


def albedo(values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The sum of f n.l over the hemisphere for every setting, by the finer grid, and how far the coarser lies off."""
    weight = grid()[2]
    first = GRIDS[0][0] * GRIDS[0][1]
    each = values.reshape(-1, len(weight), *values.shape[1:])
    parts = np.moveaxis(each, 1, -1) * weight
    coarse, fine = parts[..., :first].sum(-1), parts[..., first:].sum(-1)
    return fine, np.abs(fine - coarse)


def holds_energy(values: np.ndarray) -> np.ndarray:
    """Whether every setting sends on no more than came; one that the two sums do not agree on is not held against."""
    fine, apart = albedo(values)
    good = fine <= 1 + EDGE + apart
    return good if good.ndim == 1 else np.all(good, -1)


def same(one: np.ndarray, other: np.ndarray, allowed: np.ndarray) -> np.ndarray:
    """Whether two answers are the same, within what both may be wrong by."""
    with np.errstate(invalid="ignore"):
        apart = np.abs(one - other)
    apart = apart if apart.ndim == 1 else np.sqrt(np.sum(apart * apart, -1))
    return apart <= 2 * allowed


def between(values: np.ndarray, low: float, high: float, edge: np.ndarray) -> np.ndarray:
    edge = edge if values.ndim == 1 else edge[:, None]
    good = (values >= low - edge) & (values <= high + edge)
    return good if good.ndim == 1 else np.all(good, -1)
