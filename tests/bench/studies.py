"""What the albedo at m = 0.1 costs to 1e-6: the semi-analytic way beside scipy's adaptive cubature, in one run."""

from app.catalog import step
from app.lesson import Method
from app.study.measure import reference
from app.study.rules import estimate
from tests.bench.rows import Row, in_turn, timed

ANGLES = 0.0, 0.8, 1.4
WAYS = {"semi-analytic": range(1, 25), "cubature angles": range(1, 13), "cubature half": range(1, 13)}


def studies(rounds: int = 15) -> list[Row]:
    """Each with the least cost that leaves 1e-6 at every angle; the semi-analytic way is the reference of the ratios,
    and the fastest cubature is asked to take at least 20 times as long."""
    study, = step("microfacets/cook_torrance").step.studies
    cases = [{"m": 0.1, "f0": 1.0, "theta_v": theta} for theta in ANGLES]
    right = [reference(study, values) for values in cases]
    jobs = {}
    for rule, costs in WAYS.items():
        for cost in costs:
            found = [estimate(study, Method("", rule), values, cost, 0).value for values in cases]
            if all(abs(value / exact - 1) <= 1e-6 for value, exact in zip(found, right, strict=True)):
                jobs[f"albedo to 1e-6, m = 0.1: {rule}"] = timed(
                    lambda r=rule, c=cost: [estimate(study, Method("", r), values, c, 0) for values in cases])
                break
    return in_turn(jobs, rounds)
