"""Live numbers: values, errors, words, digits."""

import math
from dataclasses import replace

import numpy as np
import pytest

from app.catalog import step, steps
from app.export.still import data
from app.lesson import Readout, Step, Term
from app.meshes import built_in
from app.problem import Problem
from app.readouts import ROUNDING, duration, error_words, numbers, raised, written
from app.state import defaults, parse

PATCH = step("solid_angle/patch")


def with_readouts(*readouts: Readout) -> Step:
    return replace(PATCH.step, readouts=readouts)


@pytest.mark.parametrize("found", steps(), ids=lambda found: found.id)
def test_every_step_has_numbers_with_units_and_digits(found, ctx):
    values = defaults(found)
    values |= data(found, values)
    shown = numbers(found.step, values, ctx)
    assert [n.label for n in shown] == [r.label for r in found.step.readouts]
    for number, readout in zip(shown, found.step.readouts, strict=True):
        assert math.isfinite(number.value) and number.text.endswith(readout.unit)
        assert bool(number.error_text) == bool(readout.against) == (number.cost_ms is not None)


def test_the_error_is_taken_against_the_named_exact():
    exact, counted, small = numbers(PATCH.step, parse("solid_angle/patch?distance=0.5&width=2&tilt=0").values)
    assert small.error == (small.value - exact.value) / exact.value > 2
    assert small.error_text.startswith("+") and small.error_text.endswith(" %")
    assert abs(counted.error) < 0.01
    assert float(exact.full_text.split()[0]) == exact.value and exact.full_text.endswith("sr (float64)")


def test_float32_is_the_number_of_the_gpu(ctx):
    found = step("solid_angle/cone")
    _, stable, printed = numbers(found.step, parse("solid_angle/cone?half_angle=0.01").values, ctx)
    assert abs(stable.error) < 1e-6 < abs(printed.error)
    assert np.float32(stable.full_text.split()[0]) == np.float32(stable.value)
    assert "float32" in stable.full_text


def test_an_exact_nothing_is_not_divided_by(ctx):
    found = step("solid_angle/mesh")
    values = defaults(found) | {"triangles": built_in("cube").triangles, "eye": (1.3, 0.4, 1.2)}
    exact, single, around = numbers(found.step, values, ctx)
    assert (exact.value, exact.text, around.text) == (0.0, "0 sr", "0")
    assert single.error in (None, 0.0) and ("off by" in single.error_text or single.value == 0)


def test_what_is_not_finite_is_said_in_words():
    naked = with_readouts(Readout("a", Term("solid_angle_patch_small", {"distance": 0.0, "width": 0.0}), "exact"),
                          Readout("b", Term("solid_angle_patch_small", {"distance": 0.0, "width": 1.0}), against="a"))
    first, second = numbers(naked, defaults(PATCH))
    assert first.text == "not a number" and second.text == "infinite"
    assert second.error is None and second.error_text == ""


def test_a_missing_value_is_named():
    with pytest.raises(Problem, match=r"mesh.*triangles"):
        numbers(with_readouts(Readout("mesh", Term("solid_angle_mesh"))), defaults(PATCH) | {"eye": (0, 0, 0)})


@pytest.mark.parametrize(("value", "text"), [
    (0.0, "0 sr"), (-0.0, "0 sr"), (0.68249, "0.682 sr"), (12.566, "12.6 sr"), (0.0249, "0.0249 sr"),
    (9.9999, "10.0 sr"), (6.8e-5, "6.80e-5 sr"), (184789.0, "185 000 sr"), (999999.0, "1.00e6 sr"),
    (1e-300, "1.00e-300 sr"), (-0.5, "−0.500 sr"), (0.00099999, "0.00100 sr"), (1234.0, "1230 sr"),
    (math.inf, "infinite"), (-math.inf, "minus infinite"), (math.nan, "not a number"),
])
def test_three_significant_digits(value, text):
    assert written(value, "sr").replace("\u202f", " ") == text


@pytest.mark.parametrize(("error", "text"), [
    (0.0, "exact to rounding"), (2e-16, "exact to rounding"), (-0.24, "−24 %"), (0.0031, "+0.31 %"), (0.052, "+5.2 %"),
    (3e-7, "3e-7"), (-3e-7, "−3e-7"), (1e-4, "1e-4"), (-1.0, "−100 %"), (500.0, "500 times too much"),
    (math.inf, "beyond measure"), (math.nan, ""),
])
def test_errors_in_words(error, text):
    assert error_words(error) == text


def test_rounding_depends_on_the_precision():
    assert error_words(1e-7, ROUNDING["float32"]) == "exact to rounding" != error_words(1e-7)


def test_powers_are_raised_and_nothing_else():
    assert raised("6.80e-5 sr") == [("6.80·10", False), ("−5", True), (" sr", False)]
    assert raised("with edges 2e3") == [("with edges 2·10", False), ("3", True)]
    assert raised("exact, 12.6 sr") == [("exact, 12.6 sr", False)]


def test_units_stand_where_they_belong():
    assert (written(55.0, "°"), written(1.0)) == ("55.0°", "1.00")
    assert (duration(0.0051), duration(12.3)) == ("5.1 µs", "12 ms")
