"""The Cook-Torrance model that comes nearest to a measurement: rho / pi + D G F / (4 n.l n.v), F Schlick's.

For one m the model is linear in rho and f0 of each channel, f = rho / pi + D G x + f0 D G (1 - x) over 4 n.l n.v, with
x = (1 - l.h)^5. So the best of them in [0, 1] is a problem of two unknowns, solved exactly, inside a search for
log m (the idea: Yu, Seo and Lee, Global optimization for estimating a BRDF with multiple specular lobes). "Nearest" is
in the least squares over pairs of light and eye, each weighted by its projected solid angle:

    int int (f - f_measured)^2 n.l n.v dw_l dw_v,   dw_l dw_v = 4 cos theta_d dw_h dw_d

Pairs beyond 80 degrees from the normal are left out, our choice: there the model grows fastest, a measurement is least
sure, and together they would decide everything. The residual is the root of this over the root of the same for
f_measured alone: 0 fits, 1 says nothing.
"""

from dataclasses import dataclass

import numpy as np

from app.board.brdf_file import Default
from app.board.merl import SCALES, Merl, directions, middles
from app.hemisphere import NORMAL
from app.optics.cook_torrance import cook_torrance_dg
from app.problem import Problem

STRIDE = 1, 3, 10  # of the cells in theta_h, theta_d, phi_d that are looked at
TRIED = np.geomspace(0.005, 2.0, 33)  # m, before the search between the best one's neighbours
LOWEST = np.cos(np.radians(80))
GOLDEN, STEPS = 0.5 * (5**0.5 - 1), 32  # each step leaves 0.618 of the range: 4e-8 in log m
Rgb = tuple[float, float, float]


@dataclass(frozen=True)
class Fit:
    m: float
    rho: Rgb
    f0: Rgb
    residual: float  # of the three channels together
    residuals: Rgb

    @property
    def values(self) -> dict[str, Default]:
        return {"m": self.m, "rho": self.rho, "f0": self.f0}


@dataclass(frozen=True)
class Cells:
    """What a measurement says at some pairs of light and eye, and what each pair counts."""

    l: np.ndarray  # (pairs, 3)
    v: np.ndarray
    grazing: np.ndarray  # x = (1 - l.h)^5, (pairs,)
    f: np.ndarray  # (3, pairs) 1/sr
    weight: np.ndarray  # (3, pairs), 0 where nothing was measured


def cells(measured: Merl) -> Cells:
    theta_h, theta_d, phi_d = middles(STRIDE)
    l, v = directions(theta_h, theta_d, phi_d)
    size = np.sin(theta_h) * np.sqrt(theta_h) * np.sin(theta_d) * np.cos(theta_d)  # d theta_h goes with its root
    weight = size * l[..., 2] * v[..., 2]
    stored = measured.cells[(slice(None), *(slice(step // 2, None, step) for step in STRIDE))]
    here = np.minimum(l[..., 2], v[..., 2]) > LOWEST
    stored = stored[:, here]
    return Cells(l[here], v[here], ((1 - np.cos(theta_d)) ** 5)[here], stored * np.array(SCALES)[:, None],
                 np.where(stored < 0, 0.0, weight[here]))


def fit(measured: Merl) -> Fit:
    """Deterministic; half a second."""
    data = cells(measured)
    power = np.sum(data.weight * data.f**2, -1)
    if not power.sum() > 0:
        raise Problem(f"{measured.path}: nothing was measured that a model could be fitted to.")
    errors = [at(m, data)[0].sum() for m in TRIED]
    best = int(np.argmin(errors))
    low, high = (float(np.log(TRIED[min(max(i, 0), len(TRIED) - 1)])) for i in (best - 1, best + 1))
    log_m = narrowed(lambda x: at(np.exp(x), data)[0].sum(), low, high)
    m = float(np.exp(log_m))
    error, rho, f0 = at(m, data)
    each = np.sqrt(error / np.where(power > 0, power, 1.0))
    return Fit(m, three(rho), three(f0), float(np.sqrt(error.sum() / power.sum())), three(each))


def three(x) -> Rgb:
    return float(x[0]), float(x[1]), float(x[2])


def narrowed(f, low: float, high: float) -> float:
    """Where f is least, by the golden section."""
    a, b = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
    at_a, at_b = f(a), f(b)
    for _ in range(STEPS):
        if at_a < at_b:
            high, b, at_b = b, a, at_a
            a = high - GOLDEN * (high - low)
            at_a = f(a)
        else:
            low, a, at_a = a, b, at_b
            b = low + GOLDEN * (high - low)
            at_b = f(b)
    return a if at_a < at_b else b


def at(m: float, data: Cells) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The error, rho and f0 (3,) of the best fit with this m."""
    dg = cook_torrance_dg(NORMAL, data.l, data.v, m)
    flat, rising = np.full(dg.shape, 1 / np.pi), dg * (1 - data.grazing)
    error, rho, f0 = np.zeros(3), np.zeros(3), np.zeros(3)
    for channel in range(3):
        rest = data.f[channel] - dg * data.grazing
        rho[channel], f0[channel] = in_square(flat, rising, rest, data.weight[channel])
        left = rest - rho[channel] * flat - f0[channel] * rising
        error[channel] = np.sum(data.weight[channel] * left**2)
    return error, rho, f0


def in_square(a, b, y, weight) -> tuple[float, float]:
    """p and q in [0, 1] with the least sum of weight (p a + q b - y)^2: inside, or on one of the four sides."""
    aa, ab, bb, ay, by = (float(np.sum(weight * p * q)) for p, q in ((a, a), (a, b), (b, b), (a, y), (b, y)))
    det = aa * bb - ab * ab
    if det > 1e-12 * aa * bb:
        p, q = (ay * bb - by * ab) / det, (by * aa - ay * ab) / det
        if 0 <= p <= 1 and 0 <= q <= 1:
            return p, q
    sides = [(p, float(np.clip((by - p * ab) / bb, 0, 1)) if bb > 0 else 0.0) for p in (0.0, 1.0)]
    sides += [(float(np.clip((ay - q * ab) / aa, 0, 1)) if aa > 0 else 0.0, q) for q in (0.0, 1.0)]

    def error(side: tuple[float, float]) -> float:
        p, q = side
        return p * p * aa + 2 * p * q * ab + q * q * bb - 2 * (p * ay + q * by)

    return min(sides, key=error)
