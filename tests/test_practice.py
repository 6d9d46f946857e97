"""What a student writes for the exercises: kept, tried in the scene, handed in as one file."""

import threading

import pytest

from app import exercises
from app.catalog import chapters, step
from app.exercises import Checker, Verdicts, hand_in, of_step, verdicts
from app.practice import TABLE, Practice
from app.problem import Problem
from app.progress import Progress
from app.session import Session
from app.viewer.exercise_panel import drawn_in

LAMBERT, BLINN = "brdfs/lambert", "brdfs/blinn_phong"
EXERCISES = {f"{one.id}/{exercise.name}": exercise for one in chapters() for exercise in one.chapter.exercises}
WRONG = "float brdf_lambert(vec3 n, vec3 l, vec3 v, float rho) {\n" \
        "    return dot(n, l) > 0.0 && dot(n, v) > 0.0 ? rho : 0.0; // mine\n}"


@pytest.fixture
def practice(tmp_path):
    return Practice(Progress(tmp_path / "data"))


def test_what_is_typed_is_there_on_another_day(practice):
    exercise = EXERCISES[LAMBERT]
    assert practice.text(LAMBERT, exercise, "glsl") == exercise.stubs["glsl"].strip("\n")
    practice.type(LAMBERT, exercise, "glsl", WRONG)
    practice.type(LAMBERT, exercise, "python", "# later")
    practice.write_in(LAMBERT, "python")
    practice.progress.save()
    again = Practice(Progress(practice.progress.folder))
    assert [again.text(LAMBERT, exercise, one) for one in ("glsl", "python")] == [WRONG, "# later"]
    assert again.language(LAMBERT) == "python" and again.language(BLINN) == "glsl" and not again.typed(BLINN, "glsl")
    assert not again.solved(LAMBERT)
    again.solve(LAMBERT)
    assert again.solved(LAMBERT) and not again.solved(BLINN)


def test_to_start_again_loses_nothing(practice):
    exercise = EXERCISES[LAMBERT]
    practice.start_again(LAMBERT, "glsl")  # nothing was typed: nothing happens
    assert not practice.can_go_back(LAMBERT, "glsl")
    practice.type(LAMBERT, exercise, "glsl", WRONG)
    practice.start_again(LAMBERT, "glsl")
    assert practice.text(LAMBERT, exercise, "glsl") == exercise.stubs["glsl"].strip("\n")
    assert practice.can_go_back(LAMBERT, "glsl") and not practice.can_go_back(LAMBERT, "python")
    practice.bring_back(LAMBERT, "glsl")
    assert practice.text(LAMBERT, exercise, "glsl") == WRONG and not practice.can_go_back(LAMBERT, "glsl")


@pytest.mark.parametrize("entry", [{"texts": [1], "aside": "x", "language": 3, "solved": "yes"},
                                   {"texts": {"glsl": 5}}, {}])
def test_a_damaged_entry_is_as_if_nothing_was_typed(practice, entry):
    practice.progress.put(TABLE, LAMBERT, **entry)
    assert not practice.typed(LAMBERT, "glsl") and not practice.solved(LAMBERT)
    assert practice.language(LAMBERT) == "glsl" and not practice.can_go_back(LAMBERT, "glsl")


def test_a_text_that_is_tried_stands_before_what_was_edited_and_goes_again():
    session = Session("brdfs/lambert")
    session.type("brdf_lambert", "an edit")
    before = session.revision
    session.try_out({"brdf_lambert": WRONG, "no_function_of_this_scene": "x"})
    assert session.texts == {"brdf_lambert": WRONG} and session.revision == before + 1
    session.try_out({"brdf_lambert": WRONG})
    assert session.revision == before + 1, "nothing has changed"
    session.try_out({})
    assert session.texts == {"brdf_lambert": "an edit"} and session.revision == before + 2


def test_the_outline_says_which_steps_have_exercises():
    found = {entry.id: entry.exercises for entry in Session().outline()}
    assert found["brdfs/lambert"] == (LAMBERT,) and found["brdfs/phong"] == ()
    assert {name for names in found.values() for name in names} == set(EXERCISES), "every exercise is in a step"
    assert of_step(step("brdfs/phong")).keys() == {LAMBERT, BLINN}, "and can be opened in all of its chapter"


def test_a_step_that_draws_an_exercise_is_found():
    session = Session("geometry_term/shadowing")
    assert drawn_in("geometry_term/smith_ggx", session.steps) == "geometry_term/smith"
    assert drawn_in("solid_angle/triangle", session.steps) == "", "no scene is made of it"


# --- handed in -------------------------------------------------------------------------------------------------------
def test_a_wrong_text_and_a_right_one_are_handed_in_as_one_file(tmp_path):
    right = EXERCISES[BLINN].solutions["glsl"]
    done = hand_in(LAMBERT, "glsl", {LAMBERT: WRONG, BLINN: right}, tmp_path)
    text = done.path.read_text("utf-8")
    assert done.path == tmp_path / "brdfs" / "submission.glsl" and done.good == 1 and done.count >= 2 and not done.said
    assert "// mine" in text and "// halfway homework: brdfs" in text
    assert not any(line.startswith("#") for line in text.split("\n"))
    hand_in(LAMBERT, "glsl", {LAMBERT: WRONG, BLINN: right}, tmp_path)
    assert not (tmp_path / "earlier").exists(), "the same text again is no other"
    assert hand_in(LAMBERT, "glsl", {BLINN: right, LAMBERT: EXERCISES[LAMBERT].solutions["glsl"]}, tmp_path).good == 2
    kept = list((tmp_path / "earlier").iterdir())
    assert len(kept) == 1 and kept[0].read_text("utf-8") == text
    broken = hand_in(LAMBERT, "glsl", {LAMBERT: WRONG.replace("; //", "//"), BLINN: right}, tmp_path)
    assert broken.good == 0 and "compile error" in broken.said, "one file: what does not compile spoils the rest"


@pytest.mark.parametrize("language", ["glsl", "python"])
def test_all_solutions_together_pass_every_visible_check(language, tmp_path):
    """Those that include the same constants too."""
    for chapter in ("geometry_term", "microfacets"):
        texts = {name: one.solutions[language] for name, one in EXERCISES.items() if name.startswith(chapter)}
        assert hand_in(next(iter(texts)), language, texts, tmp_path).good >= len(texts)


@pytest.mark.parametrize(("language", "texts", "words"), [
    ("python", {LAMBERT: "def brdf_lambert(n, l, v, rho)\n    return 1"}, "your brdf_lambert, line 1: "),
    ("python", {LAMBERT: "def lambert(n, l, v, rho):\n    return 1"}, "your text of brdf_lambert does not define it."),
    ("glsl", {LAMBERT: "float lambert() { return 1.0; }"}, "your text of brdf_lambert does not define it."),
    ("glsl", {LAMBERT: '#include "core/nothing.glsl"\n' + WRONG}, "there is no glsl/core/nothing.glsl"),
    ("python", {LAMBERT: "def half(x):\n    return x / 2\n\ndef brdf_lambert(n, l, v, rho):\n    return half(rho)",
                BLINN: "def half(x):\n    return 0.5 * x\n\ndef brdf_blinn_phong(n, l, v, k_d, k_s, exponent):\n    "
                       "return half(k_d)"}, "brdf_lambert and brdf_blinn_phong both declare half"),
])
def test_what_would_spoil_the_file_is_told_and_nothing_is_written(language, texts, words, tmp_path):
    with pytest.raises(Problem) as told:
        hand_in(LAMBERT, language, texts, tmp_path)
    assert words in str(told.value) and not list(tmp_path.rglob("submission*"))


# --- what the panel shows --------------------------------------------------------------------------------------------
def test_verdicts_name_the_misconception_the_worst_point_and_a_plot():
    found = verdicts(LAMBERT, WRONG)
    assert not found.ok and [name for name, _ in found.suspects] == ["lambert_no_pi"] and found.suspects[0][1]
    place, expected, got = found.worst
    assert "rho = " in place and float(got) == pytest.approx(3.14159265 * float(expected), rel=1e-5)
    assert found.plot is not None and found.plot.ends is not None
    python = EXERCISES[LAMBERT].solutions["python"].replace("rho / np.pi", "rho")
    assert [name for name, _ in verdicts(LAMBERT, python, "python").suspects] == ["lambert_no_pi"]
    broken = verdicts(LAMBERT, WRONG.replace(";", ""))
    assert broken.worst is None and broken.plot is None and "line 3" in broken.checks[0][1]


def test_a_text_that_is_asked_again_and_again_is_checked_once(monkeypatch):
    """A window asks every frame; what was typed meanwhile is checked next, and what fails is told."""
    begun, go_on, asked = threading.Event(), threading.Event(), []

    def slowly(exercise, text, language):
        asked.append(text)
        begun.set()
        assert go_on.wait(10)
        if text == "b":
            raise OSError("no process")
        return Verdicts(exercise, language, text)

    monkeypatch.setattr(exercises, "verdicts", slowly)
    told = []
    checker = Checker(on_verdicts=lambda: told.append(checker.shown.text))
    for text in "aaa":
        checker.ask(LAMBERT, text)
        assert begun.wait(10)
    for text in "cbbb":
        checker.ask(LAMBERT, text)
    go_on.set()
    assert checker.wait(10).checks == [(False, "OSError: no process")]
    checker.ask(LAMBERT, "b")
    assert asked == told == ["a", "b"] and not checker.busy
    checker.ask(LAMBERT, "d")
    assert checker.wait(10).text == "d"
