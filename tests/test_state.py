"""State strings: the same everywhere, short, and read back as they were written."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app import typed
from app.catalog import LoadedStep, ValueSpec, step, steps
from app.problem import Usage
from app.state import FARTHEST, NEAREST, State, View, defaults, parse, parse_set, write
from tests import small_lesson

STEPS = {found.id: found for found in steps()}


@st.composite
def states(draw) -> tuple[LoadedStep, State]:
    """Any step of the course, any values within its ranges, any view."""
    found = STEPS[draw(st.sampled_from(sorted(STEPS)))]
    values = defaults(found)
    for name in draw(st.sets(st.sampled_from(sorted(values)))):
        values[name] = draw(numbers(found.values[name]))
    view = View(draw(st.floats(-180, 180)), draw(st.floats(-90, 90)), draw(st.floats(NEAREST, FARTHEST)))
    return found, State(found.id, values, view)


def numbers(spec: ValueSpec):
    if spec.quantity.kind == "int":
        return st.integers(round(spec.low), round(spec.high))
    one = st.floats(spec.low, spec.high)
    return st.tuples(*[one] * spec.quantity.width) if spec.quantity.width > 1 else one


@settings(deadline=None)
@given(states())
def test_what_is_written_is_read(drawn):
    found, state = drawn
    text = write(found, state.values, state.view)
    again = parse(text)
    assert write(found, again.values, again.view) == text
    assert again.step == state.step and list(again.values) == list(state.values)
    for name, value in state.values.items():
        spec = found.values[name]
        read = again.values[name]
        assert read == pytest.approx(value, rel=5.1e-6, abs=1e-300), name
        for x in read if isinstance(read, tuple) else (read,):
            assert spec.low <= x <= spec.high
    assert again.view.distance == pytest.approx(state.view.distance, rel=5.1e-6)
    assert not set(text) - set("abcdefghijklmnopqrstuvwxyz_0123456789/?&=,.-"), text


def test_defaults_need_no_words():
    for found in STEPS.values():
        assert write(found, defaults(found), View.of(found.step.scene.camera)) == found.id == write(found, {})
        assert parse(found.id).values == defaults(found)


@pytest.fixture
def folder(tmp_path):
    return small_lesson.write(tmp_path)


@pytest.mark.parametrize(("text", "value"), [
    ("half_angle=45", math.pi / 4), ("half_angle=45deg", math.pi / 4), ("half_angle=45°", math.pi / 4),
    ("half_angle=0.5rad", 0.5), ("half_angle=120", 2 * math.pi / 3), ("samples=100", 100), ("samples=1e2", 100),
    ("corner_a=0.3,-0.25", (0.3, -0.25)), ("corner_a=0.3%2C-0.25", (0.3, -0.25)), ("corner_a= 1, -1", (1.0, -1.0)),
])
def test_the_ways_to_write_a_value(folder, text, value):
    found = step("small/open", folder)
    name = text.partition("=")[0]
    assert parse_set(text, found)[name] == pytest.approx(value)
    assert parse(f"small/open?{text}", folder).values[name] == pytest.approx(value)


def test_a_named_number_is_a_word_or_a_number(folder):
    found = step("small/shape", folder)
    for text in ("shape=bowl", "shape=1", "shape=Bowl"):
        assert parse_set(text, found) == {"shape": 1}
    assert write(found, {"shape": 1}) == "small/shape?shape=bowl"


def test_the_view_is_part_of_the_state(folder):
    state = parse("small/open?view=270,10,3.5&half_angle=45", folder)
    assert state.view == View(-90.0, 10.0, 3.5)
    assert write(step("small/open", folder), state.values, state.view) == "small/open?half_angle=45&view=-90,10,3.5"
    camera = step("small/open", folder).step.scene.camera
    assert (state.view.camera(camera).azimuth, state.view.camera(camera).target) == (-90.0, camera.target)


def test_a_string_is_as_short_as_it_can_be(folder):
    found = step("small/open", folder)
    assert write(found, {"half_angle": math.pi / 6 + 1e-12, "corner_a": (0.3, 0.2)}) == "small/open"
    assert write(found, {"half_angle": 1.0}) == "small/open?half_angle=57.2958"
    shown = {1e-5: "1e-5", 1.5e20: "1.5e20", -0.0: "0", 0.1 + 0.2: "0.3", 1234567.0: "1.23457e6"}
    assert [typed.digits(x) for x in shown] == list(shown.values())


@pytest.mark.parametrize(("text", "sentence"), [
    ("small/opne?half_angle=3", "there is no step small/opne. Did you mean small/open"),
    ("small/open?half_angel=3", "there is no value half_angel in small/open. Did you mean half_angle?"),
    ("small/open?half_angle=wide", "half_angle=wide: small/open takes a number, and wide is none."),
    ("small/open?half_angle=nan", "takes a number, and nan is none."),
    ("small/open?half_angle=1_0", "takes a number, and 1_0 is none."),
    ("small/open?half_angle=121", "half_angle=121: small/open takes half_angle from 0 to 120°."),
    ("small/open?half_angle=3rad", "from 0 to 120°."),
    ("small/open?samples=63", "samples=63: small/open takes samples from 64 to 16384."),
    ("small/open?samples=99.5", "takes a whole number from 64 to 16384."),
    ("small/open?corner_a=1", "corner_a=1: small/open takes 2 numbers (x, y), not 1."),
    ("small/open?half_angle=1,2", "takes one number, not 2."),
    ("small/open?half_angle=1&half_angle=2", "half_angle is given twice"),
    ("small/open?view=1,2,3&view=1,2,3", "view is given twice"),
    ("small/open?half_angle", "half_angle has no value; write half_angle=30."),
    ("small/open?view=1,2", "has 2 numbers, not azimuth, elevation and distance."),
    ("small/open?view=1,91,3", "is out of range: elevation goes from -90 to 90°"),
    ("small/open?view=1,2,0", "distance from 0.1 to 50."),
    ("small/shape?shape=cub", "takes one of cube, bowl. Did you mean cube?"),
    ("small/shape?shape=2", "takes shape from 0 to 1."),
    ("", "there is no step without a name."),
])
def test_a_wrong_string_is_told_in_a_sentence(folder, text, sentence):
    with pytest.raises(Usage) as told:
        parse(text, folder)
    assert sentence in str(told.value)


def test_a_step_offers_some_of_the_choices():
    """The metals are the last five of ten materials: by name or number, the others are none of them."""
    assert parse("fresnel/metals?material=iron").values == parse("fresnel/metals?material=8").values
    for text, sentence in (("water", "takes one of gold, silver, copper, iron, aluminium."), ("4", "from 5 to 9")):
        with pytest.raises(Usage, match=sentence):
            parse(f"fresnel/metals?material={text}")


def test_units_stand_in_the_sentence():
    with pytest.raises(Usage, match=r"takes distance from 0\.5 to 5 m"):
        parse("solid_angle/patch?distance=9")
