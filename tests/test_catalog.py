"""Finding, ordering and checking lessons; a broken one names its file and line, and the others go on."""

import math
from pathlib import Path

import pytest

from app import catalog
from app.problem import Problem, Usage
from app.validation import validate
from tests import small_lesson

SLIDES = [title for title in (Path(__file__).parent / "reference" / "deck_slides.txt").read_text("utf-8").splitlines()
          if not title.startswith("#")]


def test_chapters_are_found_in_the_order_of_their_numbers(tmp_path):
    small_lesson.write(tmp_path, name="ch10_late.py")
    small_lesson.write(tmp_path, name="ch02_early.py")
    folder = small_lesson.write(tmp_path, ('Chapter("Small"', 'Chapter("Middle"'), name="ch03_middle.py")
    (folder / "cover.py").write_text("no chapter")
    assert [found.id for found in catalog.chapters(folder)] == ["early", "middle", "late"]
    middle = catalog.chapters(folder)[1]
    assert (middle.number, middle.chapter.title, middle.fault) == (3, "Middle", "")
    assert middle.intro == "A chapter about little."
    assert [found.id for found in catalog.steps(folder)][:3] == ["early/open", "early/shape", "middle/open"]


def test_a_step_knows_its_place(tmp_path):
    folder = small_lesson.write(tmp_path)
    found = catalog.step("small/shape", folder)
    assert (found.index, found.step.title, found.chapter.title) == (1, "Café of shapes", "Small")
    assert found.file_name == "lessons/ch01_small.py"
    assert found.glsl_line == small_lesson.line(folder, "uniform vec3 eye;") - 1  # the text begins after the quotes


def test_an_unknown_step_has_near_names(tmp_path):
    folder = small_lesson.write(tmp_path)
    with pytest.raises(Usage, match=r"there is no step small/opne\. Did you mean small/open"):
        catalog.step("small/opne", folder)


def test_values_come_from_list_scene_mesh_and_twins(tmp_path):
    folder = small_lesson.write(tmp_path)
    values = catalog.step("small/open", folder).values
    assert list(values) == ["half_angle", "corner_a", "samples"]
    angle = values["half_angle"]
    assert (angle.default, angle.low, angle.high) == pytest.approx((math.pi / 6, 0.0, 2 * math.pi / 3))
    assert values["corner_a"].default == (0.3, 0.2) and values["corner_a"].more
    assert values["samples"].default == values["samples"].quantity.default
    shapes = catalog.step("small/shape", folder).values
    assert list(shapes) == ["eye", "shape"]  # a mesh's triangles are data
    assert (shapes["shape"].high, shapes["shape"].choices) == (1, ("cube", "bowl"))


@pytest.mark.parametrize(("change", "words", "sentence"), [
    (('title="Opening a cone"', 'title=Opening a cone"'), "title=Opening", "SyntaxError: "),
    (('Mark("ray")', 'Mrak("ray")'), "Mrak", "NameError: name 'Mrak' is not defined."),
    (('Mark("ray")', 'Mark("ray", colour="nn")'), '"nn"', "ValueError: colour='nn'; it can be 'n', 'l', "),
    (("CHAPTER =", "CAPTER ="), '"""A chapter', "a lesson ends with CHAPTER = Chapter(...)."),
], ids=lambda x: str(x)[:20])
def test_a_lesson_that_cannot_be_read_leaves_the_others(tmp_path, change, words, sentence):
    small_lesson.write(tmp_path, name="ch02_fine.py")
    folder = small_lesson.write(tmp_path, change)
    broken, fine = catalog.chapters(folder)
    start = f"lessons/ch01_small.py, line {small_lesson.line(folder, words)}: {sentence}"
    assert broken.fault.startswith(start) and broken.fault.count("\n") == 0
    assert validate(broken) == [broken.fault]
    assert not broken.chapter.steps and not fine.fault
    with pytest.raises(Problem, match=r"ch01_small\.py, line"):
        catalog.step("small/open", folder)


def test_a_file_with_an_odd_name_is_told(tmp_path):
    folder = small_lesson.write(tmp_path, name="chapter.py")
    assert "named like ch01_solid_angle.py" in catalog.chapters(folder)[0].fault


READOUT = 'Readout("cone", Term("solid_angle_cone")'
FAULTS = {
    "unknown quantity": (('Value("half_angle", 30.0', 'Value("half_angel", 30.0'), "there is no quantity half_angel"),
    "default": (('Value("half_angle", 30.0', 'Value("half_angle", 130.0'), "from 0 to 120°"),
    "no range": (("low=0.0, high=120.0", "low=120.0, high=0.0"), "which is no range"),
    "unknown uniform": (("uniform float half_angle", "uniform float half_angel"),
                        "there is no quantity half_angel, which the scene has as a uniform"),
    "unknown twin": ((READOUT, 'Readout("cone", Term("solid_angle_con")'),
                     "there is no function solid_angle_con. Did you mean solid_angle_cone"),
    "unknown argument": ((READOUT, READOUT[:-1] + ', {"wide": 1.0})'),
                         "solid_angle_cone takes no wide; it takes half_angle"),
    "argument": ((READOUT, READOUT[:-1] + ', {"half_angle": "wide"})'),
                 "wide of solid_angle_cone is neither given nor a value"),
    "handle": (('0, ("half_angle",)', '0, ("tilt",)'), "drags tilt, no value of it"),
    "question": (('sets={"half_angle": 90.0}', 'sets={"tilt": 90.0}'), "the question sets tilt, no value"),
    "question's range": (('sets={"half_angle": 90.0}', 'sets={"half_angle": 190.0}'), "from 0 to 120°"),
    "sweep": (('"Cone", "half_angle"', '"Cone", "half_angel"'), "the plot sweeps half_angel, which is no quantity"),
    "against": (('role="exact")', 'role="estimate", against="con")'), "there is no readout 'con' to compare with"),
    "slide": (('slides=("Basic Concepts"', 'slides=("Basic Concept"'),
              "the deck has no slide 'Basic Concept'. Did you mean Basic Concepts"),
    "link": (("?half_angle=90", "?half_angle=150"), "half_angle=150: small/open takes half_angle from 0 to 120°"),
    "link's value": (("?half_angle=90", "?tilt=90"), "there is no value tilt in small/open"),
    "link elsewhere": (("small/shape?", "small/shapes?"), "there is no step small/shapes"),
    "formula": (("$\\theta$", "$\\theta"), "a $ is opened and not closed"),
    "two of a name": (('name="shape"', 'name="open"'), "the name open is used by 2 steps"),
    "no marks": (("vec3 mark_point", "vec3 make_point"), "the scene has marks and its GLSL no function mark_point"),
    "no probe": (("vec4 probe", "vec4 prob"), "the scene has labels or handles and its GLSL no function probe"),
    "no shade": (("vec3 shade", "vec3 shad"), "the scene has surfaces and its GLSL no function shade"),
    "no mesh": (("vec3 mesh_point", "vec3 mash_point"), "the scene has a mesh and its GLSL no function mesh_point"),
    "probe": (('"the rim", 0', '"the rim", -1'), "a probe's number is 0 or more, not -1"),
    "curve's colour": (('(Curve("cone", ', '(Curve(colour="gold", label="cone", term='),
                       "gold is no colour; there are n, l,"),
    "legend's colour": (('handles=(Handle("the rim"', 'legend=(("lamp", "a lamp"),), handles=(Handle("the rim"'),
                        "lamp is no colour; there are n, l,"),
    "unknown mesh": (('("cube", "bowl")', '("cube", "bowel")'), "there is no mesh bowel. Did you mean bowl"),
    "include": (("uniform float half_angle;", '#include "optics/con.glsl"\nuniform float half_angle;'),
                "optics/con.glsl"),
    "exercise": (('terms={"radian"', 'exercises=(Exercise("e", "solid_angle_con", "", "Solid Angles", {}, {}, ()),), '
                  'terms={"radian"'), "exercise e: there is no function solid_angle_con"),
}


def test_the_small_lesson_has_no_fault(tmp_path):
    assert validate(catalog.chapters(small_lesson.write(tmp_path))[0], SLIDES) == []


@pytest.mark.parametrize("name", FAULTS)
def test_every_fault_names_file_and_line(tmp_path, name):
    (old, new), sentence = FAULTS[name]
    folder = small_lesson.write(tmp_path, (old, new))
    told = validate(catalog.chapters(folder)[0], SLIDES)
    assert any(sentence in fault for fault in told), told
    assert all(fault.startswith("lessons/ch01_small.py, line ") for fault in told)
    fault = next(fault for fault in told if sentence in fault)
    number = int(fault.split("line ")[1].split(":")[0])
    exact = {"unknown quantity", "handle", "slide", "link", "unknown mesh", "unknown twin", "exercise"}
    if name in exact:
        assert number == small_lesson.line(folder, new.splitlines()[-1]), fault


def test_a_value_that_cannot_be_is_told_at_its_line_when_the_step_is_opened(tmp_path):
    for name in ("unknown quantity", "unknown twin", "unknown uniform"):
        (old, new), sentence = FAULTS[name]
        folder = small_lesson.write(tmp_path, (old, new))
        with pytest.raises(Problem, match=sentence) as told:
            assert catalog.step("small/open", folder).values
        assert told.value.code == 1
        assert str(told.value).startswith(f"lessons/ch01_small.py, line {small_lesson.line(folder, new)}: ")


def test_slides_may_be_written_with_either_dash(tmp_path):
    folder = small_lesson.write(tmp_path, ('"Basic Concepts"', '"BRDF - The Reflectance Equation (1)"'))
    assert validate(catalog.chapters(folder)[0], SLIDES) == []


@pytest.mark.parametrize("loaded", catalog.chapters(), ids=lambda loaded: loaded.id)
def test_every_chapter_of_the_course_is_sound(loaded):
    assert validate(loaded, SLIDES) == []
