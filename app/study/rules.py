"""The ways to a number that a lesson names: points and a map, quadratures of the sphere, adaptive, semi-analytic."""

import math
from dataclasses import dataclass

import numpy as np

from app.lesson import Method, Study, Term
from app.problem import Problem, near
from app.study.integrals import Integral
from app.study.pieces import by_pieces
from app.study.points import LINE, RANDOM, SQUARE
from app.terms import evaluate

LEBEDEV = (3, 5, 7, 9, 11, 13, 15, 17, 19, 21, 23, 25, 27, 29, 31, 35, 41, 47, 53, 59, 65, 71, 77, 83, 89, 95, 101, 107,
           113, 119, 125, 131)  # the orders there are
POWERS = tuple(4**k for k in range(1, 10))
SPECIAL = {"lebedev": (5, 9, 15, 23, 35, 53, 83, 131), "cubature": (2, 3, 4, 6, 8, 10, 12),
           "semi-analytic": (2, 3, 4, 6, 8, 12, 16, 20), "pieces": (1, 2, 3, 4, 6, 8, 12, 16),
           "segments": (80, 160, 240, 320),
           "gauss": (16, 64, 256, 1024, 4096, 16384, 65536), "laguerre": (8, 16, 32, 128, 512, 2048)}
MOST_PIECES = 120  # that the adaptive rule may cut; each costs up to 441 evaluations in two dimensions


@dataclass(frozen=True)
class Estimate:
    value: float
    samples: int
    claim: float | None = None  # the error it says it has, relative; None where it says nothing
    said: str = ""  # what an adaptive rule says of itself: converged, not_converged


def ladder(method: Method, line: bool = False) -> tuple[int, ...]:
    """The rungs a method climbs: how many samples, or what its own cost is."""
    if method.ladder:
        return method.ladder
    if method.term is not None:
        return tuple(range(9)) if method.cost == "level" else POWERS if method.cost else (1,)
    word = method.rule.split()[0]
    if line and word == "gauss":
        return 2, 4, 8, 16, 32, 64, 128
    return SPECIAL.get(word, POWERS)


def is_random(method: Method) -> bool:
    """Whether another seed gives another number."""
    if method.term is not None:
        from app.optics import arguments

        return "seed" in arguments(method.term.function) and method.term.args.get("sampling") not in (0, 5)
    return method.rule.split()[0] in RANDOM


def estimate(study: Study, method: Method, values: dict, rung: int, seed: int) -> Estimate:
    """The quantity by one method at one rung."""
    if method.term is not None:
        return by_twin(method, values, rung, seed)
    kind, _, way = method.rule.partition(" ")
    if kind == "semi-analytic":
        return semi_analytic(values, rung)
    integral = Integral(study, values)
    if kind == "lebedev":
        return lebedev(integral, rung)
    if kind == "pieces":
        return Estimate(by_pieces(integral, rung), integral.evaluations)
    known = integral.maps
    if way not in known:
        raise Problem(f"the study {study.title!r}: {method.rule!r} has no map {way or '(none)'}.{near(way, known)}")
    if kind == "cubature":
        return cubature(integral, way, rung)
    kinds = LINE if way == "line" else SQUARE
    if kind not in kinds:
        raise Problem(f"the study {study.title!r}: there are no points {kind}.{near(kind, kinds)}")
    points, weights = kinds[kind](rung, seed)
    found = known[way](points[:, 0], points[:, 1])
    value = float(weights @ found)
    claim = None
    if kind == "random":  # the standard error of the mean
        spread = float(np.std(found)) / math.sqrt(max(1, len(found) - 1))
        claim = spread / abs(value) if value else spread
    return Estimate(value, len(weights), claim)


def by_twin(method: Method, values: dict, rung: int, seed: int) -> Estimate:
    """The twin, its cost and its seed swept: they are what the method spends, not values of the step."""
    assert method.term is not None
    given = {**method.term.args} | ({method.cost: rung} if method.cost else {})
    if is_random(method):
        given["seed"] = 1 + 7919 * seed
    value = float(evaluate(Term(method.term.function, given), values))
    return Estimate(value, 4**rung if method.cost == "level" else rung)


def semi_analytic(values: dict, nodes: int) -> Estimate:
    from app.optics.cook_torrance import _albedo

    value, used = _albedo(values["theta_v"], values["m"], values["f0"], nodes)
    return Estimate(float(value), int(used))


def lebedev(integral: Integral, order: int) -> Estimate:
    """Lebedev's rule of the whole sphere; what lies below the horizon is spent in vain."""
    from scipy.integrate import lebedev_rule

    points, weights = lebedev_rule(order)
    up = np.maximum(points[2], 0)
    return Estimate(float(weights @ (integral.above(points.T) * up)), len(weights))


def cubature(integral: Integral, way: str, digits: int) -> Estimate:
    """scipy's adaptive cubature, asked for a relative error of 10^-digits."""
    from scipy import integrate

    line = way == "line"

    def summed(x):
        return integral.maps[way](x[:, 0], x[:, 0] if line else x[:, 1])

    before = integral.evaluations
    found = integrate.cubature(summed, [0.0] if line else [0.0, 0.0], [1.0] if line else [1.0, 1.0],
                               rtol=10.0**-digits, atol=0.0, max_subdivisions=MOST_PIECES)
    value = float(found.estimate)
    return Estimate(value, integral.evaluations - before, 10.0**-digits, found.status)
