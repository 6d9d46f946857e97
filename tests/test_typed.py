"""Values as sliders show them: nothing that is not 0 is shown as 0, in no step and at no value a lesson leads to."""

import math

import pytest

from app.breaking import values_of
from app.catalog import LoadedStep, ValueSpec, step, steps
from app.lesson import Number
from app.prose import links
from app.quantities import quantity
from app.state import parse_query
from app.typed import finer, places

LENGTHS = {"m", "mm", "cm", "µm", "nm"}


def reached(found: LoadedStep) -> dict[str, set[Number]]:
    """What a step's values are at first, at their ends, behind its links, where it breaks and in its question."""
    led = [parse_query(link.target[1:], found)[0] for link in links(found.step.prose) if link.target.startswith("?")]
    led += [values_of(found, one) for one in found.step.breaks]
    return {name: {spec.default, *(values[name] for values in led if name in values),
                   *((spec.low, spec.high) if spec.quantity.width == 1 else ())}
            for name, spec in found.values.items() if not spec.choices and spec.quantity.kind != "int"}


def shown(spec: ValueSpec, value: Number) -> list[tuple[float, str]]:
    """Each number of a value, and its letters at the slider."""
    now = spec.quantity.shown(value)
    form = f"%.{places(spec, now)}"
    return [(x, form % x) for x in (now if isinstance(now, tuple) else (now,))]


@pytest.mark.parametrize("found", steps(), ids=lambda found: found.id)
def test_nothing_is_shown_as_0_that_is_not(found):
    for name, values in reached(found).items():
        for value in values:
            for number, letters in shown(found.values[name], value):
                assert (float(letters) == 0) == (number == 0), (name, number, letters)
                if found.values[name].quantity.screen_unit in LENGTHS and not isinstance(value, tuple):
                    assert math.isclose(float(letters), number, rel_tol=5.01e-3), (name, number, letters)


def test_a_lamp_of_two_millimetres_is_no_lamp_of_none():
    found = step("lights/area_units")
    broken = next(values_of(found, one) for one in found.step.breaks if "panel_width" in one.sets)
    assert shown(found.values["panel_width"], broken["panel_width"]) == [(0.002, "0.00200")]


@pytest.mark.parametrize(("value", "fewest", "letters"), [(0.0, 2, "0.00"), (1.25, 2, "1.25"), (0.123456, 2, "0.123"),
                                                          (-0.05, 2, "-0.0500"), (123.4, 0, "123"), (2e-7, 3, "2e-07")])
def test_at_least_three_digits(value, fewest, letters):
    assert f"%.{finer(value, fewest)}" % value == letters


def test_an_angle_keeps_its_tenths():
    assert quantity("tilt").is_angle
    spec = step("solid_angle/patch").values["tilt"]
    assert [letters for _, letters in shown(spec, math.radians(30))] == ["30.0"]
