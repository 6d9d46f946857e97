"""A running course without a window: steps, values, history, guesses, outline, search."""

import math

import pytest

from app.catalog import step
from app.prediction import Answer, kindly, words
from app.problem import Problem, Usage
from app.progress import Progress
from app.search import folded, readable, search
from app.session import Session
from app.state import View
from tests import small_lesson


@pytest.fixture
def folder(tmp_path):
    return small_lesson.write(tmp_path)


@pytest.fixture
def session(folder):
    return Session(folder=folder)


def test_it_begins_where_it_is_told(folder):
    assert Session(folder=folder).current.id == "small/open"
    assert Session("small/shape", folder=folder).current.id == "small/shape"
    session = Session("small/shape?shape=bowl&view=1,2,3", folder=folder)
    assert (session.values["shape"], session.view) == (1, View(1.0, 2.0, 3.0))
    with pytest.raises(Usage, match="there is no step small/opne"):
        Session("small/opne", folder=folder)
    with pytest.raises(Usage, match="takes shape from 0 to 1"):
        Session("small/shape?shape=7", folder=folder)


def test_a_course_without_lessons_says_so(tmp_path):
    with pytest.raises(Problem, match="there is no lesson in"):
        Session(folder=tmp_path)
    folder = small_lesson.write(tmp_path, ("CHAPTER =", "CAPTER ="))
    with pytest.raises(Problem, match=r"ch01_small\.py, line 1"):
        Session(folder=folder)


def test_steps_keep_their_state_while_others_are_looked_at(session):
    session.set("half_angle", 1.0)
    session.look(View(10.0, 20.0, 3.0))
    left = session.state
    assert not session.previous() and session.next() and not session.next()
    assert session.current.id == "small/shape" and session.place == 1
    assert session.previous()
    assert session.state == left == "small/open?half_angle=57.2958&view=10,20,3"
    session.go("small/shape")
    session.go("small/open?half_angle=10")
    assert session.state == "small/open?half_angle=10"  # a state string says it all
    assert session.undo() and session.state == left


def test_set_refuses_what_is_out_of_range(session):
    with pytest.raises(Usage, match=r"half_angle takes half_angle from 0 to 120°|from 0 to 120°"):
        session.set("half_angle", math.pi)
    with pytest.raises(Usage, match="there is no value tilt in small/open"):
        session.set("tilt", 0.0)
    with pytest.raises(Usage, match="takes 2 numbers, not one"):
        session.set("corner_a", 0.5)
    with pytest.raises(Usage, match="takes 2 numbers, not 3"):
        session.set("corner_a", (0.1, 0.2, 0.3))
    with pytest.raises(Usage, match="takes a whole number"):
        session.set("samples", 100.5)
    assert session.state == "small/open" and session.revision == 1


def test_the_values_stay_one_dictionary(session):
    values = session.values
    session.set("half_angle", 1.0)
    session.undo()
    session.apply("?half_angle=90")
    session.reset()
    assert session.values is values


def test_reset_of_one_value_and_of_the_step(session):
    session.apply("?half_angle=90&corner_a=0,0&view=1,2,3")
    session.reset("corner_a")
    assert session.state == "small/open?half_angle=90&view=1,2,3"
    session.reset()
    assert session.state == "small/open"
    assert session.undo() and session.state == "small/open?half_angle=90&view=1,2,3"
    with pytest.raises(Usage, match="there is no value tilt"):
        session.reset("tilt")


def test_a_drag_is_one_entry_of_the_history(session):
    session.begin_change()
    for angle in (0.6, 0.7, 0.8):
        session.begin_change()  # each frame of the drag
        session.set("half_angle", angle)
    session.end_change()
    session.set("half_angle", 0.9)
    assert session.undo() and session.values["half_angle"] == 0.8
    assert session.undo() and session.state == "small/open"
    assert not session.undo()
    assert session.redo() and session.redo() and session.values["half_angle"] == 0.9
    assert not session.redo()


def test_a_new_change_forgets_what_was_undone(session):
    session.set("half_angle", 1.0)
    session.undo()
    session.set("half_angle", 1.1)
    assert not session.redo()


def test_what_changes_nothing_is_no_entry(session):
    session.set("half_angle", session.values["half_angle"])
    session.begin_change()
    session.end_change()
    assert not session.undo() and session.revision == 1


def test_undo_during_a_drag_ends_it(session):
    session.begin_change()
    session.set("half_angle", 1.0)
    assert session.undo() and session.state == "small/open"
    session.set("half_angle", 0.5)
    assert session.undo() and session.redo() and session.values["half_angle"] == 0.5


def test_every_step_has_its_own_history(session):
    session.set("half_angle", 1.0)
    session.next()
    assert not session.undo()
    session.previous()
    assert session.undo() and session.state == "small/open"


def test_a_link_sets_values_here_or_leads_elsewhere(session):
    session.apply("?half_angle=90")
    assert session.values["half_angle"] == pytest.approx(math.pi / 2)
    session.apply("small/shape?shape=1")
    assert session.state == "small/shape?shape=bowl"


def test_a_guess_is_asked_taken_and_revealed(session):
    assert session.answer == Answer("asked") and session.verdict == ""
    session.guess(3.0)
    session.guess(6.0)
    assert (session.answer.stage, session.answer.guess, session.answer.distance) == ("guessed", 6.0, None)
    answer = session.reveal()
    assert answer.stage == "revealed" and answer.truth == pytest.approx(2 * math.pi)
    assert answer.distance == pytest.approx(6.0 - 2 * math.pi)
    assert session.state == "small/open?half_angle=90"  # the truth is shown
    assert session.verdict == "Very close, 5% too low: 6 sr guessed, 6.28 sr true."
    with pytest.raises(Usage, match="already told"):
        session.guess(1.0)
    assert session.undo() and session.state == "small/open"
    session.ask_again()
    assert session.answer == Answer()


def test_guesses_have_a_range(session):
    with pytest.raises(Usage, match="a guess goes from 0 to 10 sr, and 11 does not"):
        session.guess(11.0)
    session.next()
    with pytest.raises(Usage, match="the choices 0 to 1, and 2 is none"):
        session.guess(2)


def test_a_choice_is_right_or_told(session):
    session.go("small/shape")
    session.guess(0)
    session.reveal()
    assert session.verdict == "It is 2.89 sr: “more”."
    session.ask_again()
    session.guess(1)
    assert session.reveal().choice == 1
    assert session.verdict == "That is it: 2.89 sr."


def test_an_angle_is_told_in_degrees():
    ask = step("solid_angle/differential").step.ask
    assert words(ask, Answer("revealed", choice=0, truth=math.pi / 2)).startswith("It is 90° from the pole: ")


def test_the_truth_is_told_without_a_guess_too(session):
    assert session.reveal().guess is None
    assert session.verdict == ""


def test_a_frozen_picture_waits_for_the_reveal(session):
    session.set("half_angle", 1.0)
    session.freeze()
    with pytest.raises(Usage, match="the picture waits for your guess"):
        session.set("half_angle", 0.5)
    assert not session.undo()
    session.look(View(1.0, 2.0, 3.0))  # one may walk around it
    session.guess(6.0)
    session.reveal()
    assert not session.frozen and session.values["half_angle"] == pytest.approx(math.pi / 2)


@pytest.mark.parametrize(("guess", "truth", "sentence"), [
    (5.0, 5.05, "You are there"), (4.6, 5.0, "Very close, 8% too low"), (6.0, 5.0, "On the way, 20% too high"),
    (10.0, 1.0, "Worth a second look, 10 times too large"), (1.0, 8.0, "Worth a second look, 8 times too small"),
    (0.0, 5.0, "Worth a second look"), (1.0, -1.0, "Worth a second look"), (0.1, 0.0, "You are there"),
    (2.0, 0.0, "On the way, 20% of the slider too high"), (9.0, 0.0, "Worth a second look"),
])
def test_distances_have_kind_words(session, guess, truth, sentence):
    assert kindly(session.current.step.ask, guess, truth) == sentence


def test_no_words_before_the_reveal(session):
    assert words(session.current.step.ask, Answer("guessed", guess=1.0)) == ""


def test_the_outline_tells_where_one_has_been(session, folder):
    small_lesson.write(folder.parent, ("CHAPTER =", "CAPTER ="), name="ch02_broken.py")
    session = Session(folder=folder)
    session.reveal()
    session.next()
    here = [(e.id, e.current, e.visited, e.answered) for e in session.outline()]
    assert here == [("small/open", False, True, True), ("small/shape", True, True, False), ("", False, False, False)]
    assert "ch02_broken.py, line 1" in session.outline()[-1].fault


def test_another_day_goes_on_where_this_one_ended(folder, tmp_path):
    first = Session(progress=Progress(tmp_path / "data"), folder=folder)
    first.set("half_angle", 1.0)
    first.guess(6.0)
    first.reveal()
    first.next()
    first.set("shape", 1)
    first.save()
    second = Session(progress=Progress(tmp_path / "data"), folder=folder)
    assert second.state == "small/shape?shape=bowl" and second.message == ""
    assert [e.visited for e in second.outline()] == [True, True]
    assert [e.answered for e in second.outline()] == [True, False]
    second.previous()
    assert second.state == "small/open?half_angle=90"
    assert (second.answer.stage, second.answer.guess) == ("revealed", 6.0)


def test_what_no_longer_fits_starts_afresh(folder, tmp_path):
    progress = Progress(tmp_path / "data")
    progress.put_state("small/open", "small/open?width=3")
    session = Session(progress=progress, folder=folder)
    assert session.state == "small/open"
    assert session.message == "What you left in small/open no longer fits the lesson; it starts afresh."


def test_a_step_that_is_gone_is_no_place_to_start(folder, tmp_path):
    progress = Progress(tmp_path / "data")
    progress.put_state("large/gone", "large/gone")
    assert Session(progress=progress, folder=folder).current.id == "small/open"


def test_a_course_goes_on_when_nothing_can_be_kept(folder, tmp_path):
    (tmp_path / "file").write_text("")
    session = Session(progress=Progress(tmp_path / "file"), folder=folder)
    session.next()
    assert "the course goes on unsaved" in session.message
    assert session.current.id == "small/shape"
    session.message = ""
    session.previous()
    assert session.message == ""  # said once


# --- search ----------------------------------------------------------------------------------------------------------
def test_search_finds_titles_slides_terms_and_prose(folder):
    assert [(hit.step, hit.where) for hit in search("cafe", folder)] == [("small/shape", "title")]
    assert [(hit.step, hit.where) for hit in search("BASIC concepts", folder)] == [("small/open", "slide")]
    assert search("radian", folder)[0].snippet == "radian: an arc over its radius"
    assert search("θ", folder)[0].snippet.startswith("The angle is θ . Make it wide, or read the other.")
    assert search("trian", folder)[0].where == "idea"


def test_every_word_of_a_search_counts(folder):
    assert search("cone nowhere", folder) == search("", folder) == search(" ?", folder) == []
    hits = search("small", folder)
    assert [hit.where for hit in hits] == ["chapter"] and hits[0].step == "small/open"


def test_the_best_place_comes_first(folder):
    hits = search("cone", folder)
    assert hits[0].where == "title" and len({hit.step for hit in hits}) == len(hits)
    assert search("angle", folder)[0].step == "small/open" and len(search("a", folder, limit=1)) == 1


def test_folding_forgets_accents_and_case():
    assert folded("ÉCLAIRAGE Ångström") == "eclairage angstrom"


def test_a_function_in_a_formula_stays_in_the_snippet():
    assert "1 / cos θ more" in readable(r"covers $1 \,/ \cos\theta$ more")


def test_the_course_is_found():
    assert search("nusselt")[0].step == "solid_angle/projected"
    assert {hit.step for hit in search("steradian")} >= {"solid_angle/angle"}
