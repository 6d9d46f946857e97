"""Stubs fail, solutions pass, every catalogued mutant is caught and told its name, no right answer loses a point."""

import tomllib

import pytest

from app import catalog
from app.grade import texts
from app.grade.assignment import assignments, load
from app.homework.selftest import Case, cases, outcomes
from app.paths import ROOT

EXERCISES = {f"{loaded.id}/{exercise.name}": exercise for loaded in catalog.chapters()
             for exercise in loaded.chapter.exercises}
TASKS = {task.function: task for name in assignments() for task in load(name).tasks}
ANSWERS = tomllib.loads((ROOT / "tests" / "answers" / "answers.toml").read_text("utf-8"))["answer"]


def answers() -> list[Case]:
    return [Case("answer", f"answer {i}", one["function"], language, one[language])
            for i, one in enumerate(ANSWERS) for language in ("python", "glsl") if language in one]


@pytest.fixture(scope="module")
def found():
    """Every text in its process, through the supervisor and the judge: what became of it."""
    return list(outcomes(cases() + answers()))


def of_kind(found, kind):
    return [one for one in found if one.case.kind == kind]


def faults(found) -> list[str]:
    return [f"{one.case.function}, {one.case.language}, {one.case.name}: {one.fault}" for one in found if one.fault]


@pytest.mark.parametrize(("kind", "least"), [("stub", 2 * len(TASKS)), ("solution", 2 * len(TASKS)), ("mutant", 190)])
def test_the_tests_tell_right_from_wrong(found, kind, least):
    """The kill rate is 100 %, and what has a name is told it."""
    asked = of_kind(found, kind)
    assert len(asked) >= least and faults(asked) == []


def test_right_answers_lose_nothing(found):
    asked = of_kind(found, "answer")
    assert len(asked) >= 40 and faults(asked) == []
    assert {one.case.function for one in asked} == set(TASKS), "every function is answered differently at least once"


def test_a_right_text_is_told_no_misconception(found):
    assert [one.case for one in found if one.case.kind in ("solution", "answer") and one.suspects] == []


def test_every_exercise_is_asked_by_an_assignment():
    asked = {id(task.exercise) for task in TASKS.values() if task.exercise}
    assert {name for name, exercise in EXERCISES.items() if id(exercise) not in asked} == set()


def test_every_function_has_mutants_in_both_languages():
    known = {(one.function, one.language) for one in texts.mutants()}
    assert known == {(function, language) for function in TASKS for language in ("python", "glsl")}


@pytest.mark.parametrize("name", EXERCISES)
def test_an_exercise_is_whole(name):
    exercise = EXERCISES[name]
    assert set(exercise.stubs) == set(exercise.solutions) == {"python", "glsl"}
    assert len(exercise.checks) >= 3 and any(check.hidden for check in exercise.checks)
    assert len({check.words for check in exercise.checks}) == len(exercise.checks)


def regions(found, function: str, language: str, name: str) -> dict[str, str]:
    one = next(one for one in found if (one.case.function, one.case.language, one.case.name)
               == (function, language, name))
    return {test.region: test.verdict for test in one.tests if test.group == "points"}


def test_the_printed_triangle_fails_where_it_is_float32_that_breaks_it(found):
    """a . (b x c) is right on paper, and float32 loses a millimetre."""
    verdicts = regions(found, "solid_angle_triangle", "glsl", "the volume as printed")
    assert verdicts["an octant of the sphere: π/2"] == "pass" and verdicts["triangles of ordinary size"] == "pass"
    assert verdicts["a millimetre at a metre"] != "pass" and verdicts["small beside its distance"] != "pass"


def test_one_argument_of_atan_goes_wrong_at_half_of_everything(found):
    verdicts = regions(found, "solid_angle_triangle", "python", "atan of one argument")
    assert verdicts["nearly half of everything: 2π, where atan without a second argument goes wrong"] == "wrong"
    assert verdicts["triangles of ordinary size"] == "pass"


def test_the_decks_fast_beckmann_fails_where_it_must(found):
    verdicts = regions(found, "d_beckmann", "glsl", "1 - cos²")
    assert verdicts["the peak is 1 / (π m²)"] == "pass" and verdicts["ordinary angles and roughness"] == "pass"
    assert verdicts["polished"] != "pass" and verdicts["polished and tilted"] == "wrong"
