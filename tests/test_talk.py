"""A talk without a window: cue files, decks, stops as they were left, values that move, hands, and the layout."""

import math
from itertools import combinations

import numpy as np
import pytest

from app import __main__ as cli
from app import cues, present
from app.catalog import step, steps
from app.cues import Stop
from app.deck import Deck
from app.problem import Problem, Usage
from app.session import Session
from app.show_of_hands import Hands
from app.state import View
from app.talk import Talk
from app.viewer.areas import Rect, areas

FILE = """
[[cue]]
page = 2
state = "solid_angle/patch?distance=2.5&tilt=30"
plot = 1
sweep = "tilt=-60..60"
seconds = 2
notes = "Ask first."

[[cue]]
page = 4
state = "fresnel/schlick"
"""
TITLES = ("Appearance: Local Shading", "Solid Angles", "Solid Angles", "The Blinn Model (1)", "Questions")


@pytest.fixture(scope="module")
def deck(tmp_path_factory):
    path = tmp_path_factory.mktemp("deck") / "deck.pdf"
    from matplotlib.backends.backend_pdf import PdfPages
    from matplotlib.figure import Figure

    with PdfPages(path) as pages:
        for i, title in enumerate(TITLES):
            page = Figure(figsize=(8, 4.5), facecolor=(i / 8, 0.5, 1.0))
            page.text(0.1, 0.85, title, fontsize=20)
            pages.savefig(page, facecolor=page.get_facecolor())
    return path


def written(folder, text: str = FILE):
    path = folder / "cues.toml"
    path.write_text(text, "utf-8")
    return path


# --- what is shown when ----------------------------------------------------------------------------------------------
def test_a_cue_file_is_read(tmp_path):
    first, second = cues.read(written(tmp_path))
    assert (first.page, first.seconds, first.notes, second.state) == (2, 2, "Ask first.", "fresnel/schlick")


@pytest.mark.parametrize(("old", "new", "sentence"), [
    ("fresnel/schlick", "fresnel/schlik", "cue 2: there is no step fresnel/schlik. Did you mean fresnel/schlick"),
    ("seconds", "second", "cue 1: a cue has no second. Did you mean seconds?"),
    ("plot = 1", "plot = 7", "cue 1: solid_angle/patch has 2 plots, and 7 is none of them."),
    ("page = 4", 'page = "four"', "cue 2: page = 'four' is not what a cue has there"),
    ("tilt=-60..60", "tilt=-60", "cue 1: sweep tilt=-60 is no sweep"),
    ('state = "fresnel/schlick"', "", "cue 2 has no state"),
    ("[[cue]]", "[[cue]", "is no TOML"),
    (FILE, "", "has no cues"),
])
def test_a_wrong_cue_is_told_before_the_talk(tmp_path, old, new, sentence):
    with pytest.raises(Problem) as said:
        cues.read(written(tmp_path, FILE.replace(old, new)))
    assert sentence in str(said.value) and "cues.toml" in str(said.value)


def test_a_decks_pages_have_their_cues(tmp_path):
    found = cues.of_deck(cues.read(written(tmp_path)), 5)
    assert [(stop.page, bool(stop.state)) for stop in found] == [(1, False), (2, True), (3, False), (4, True),
                                                                 (5, False)]
    with pytest.raises(Problem, match="a cue is for page 4, and the deck has 3 pages"):
        cues.of_deck(cues.read(written(tmp_path)), 3)
    with pytest.raises(Problem, match="no cue names a page"):
        cues.of_deck((Stop("fresnel/schlick"),), 3)


def test_pages_are_pictures_and_their_titles_find_the_steps(deck):
    pages = Deck(deck)
    assert len(pages) == 5 and math.isclose(pages.aspect(1), 16 / 9, rel_tol=1e-3)
    picture = pages.picture(3, 160)
    assert picture.shape == (90, 160, 3) and np.abs(picture[5, 5] - np.array([64, 128, 255])).max() <= 1
    assert pages.lines(2) == ["Solid Angles"]
    stops, begin = present.planned("", pages)
    assert begin == 0 and [stop.state for stop in stops] == ["", "solid_angle/patch", "", "brdfs/blinn", ""]
    stops, _ = present.planned("fresnel/schlick", pages)
    assert [(stop.page, stop.state) for stop in stops] == [(i, "fresnel/schlick") for i in range(1, 6)]
    pages.close()


def test_what_is_no_deck_is_said(tmp_path):
    with pytest.raises(Usage, match="there is no deck"):
        Deck(tmp_path / "none.pdf")
    (tmp_path / "bad.pdf").write_bytes(b"not a PDF")
    with pytest.raises(Problem, match=r"bad\.pdf is no PDF that can be shown"):
        Deck(tmp_path / "bad.pdf")


def test_without_cues_it_is_the_course():
    stops, begin = present.planned("solid_angle/cone?half_angle=30", None)
    assert len(stops) == len(steps()) and stops[begin].state == "solid_angle/cone?half_angle=30"
    assert stops[begin + 1].state == steps()[begin + 1].id


# --- as it was left --------------------------------------------------------------------------------------------------
def a_talk(*stops: Stop) -> Talk:
    return Talk(Session(), stops or (Stop("solid_angle/patch?tilt=30"), Stop(page=2),
                                     Stop("solid_angle/patch?tilt=-20"), Stop("fresnel/schlick", plot=1)))


def test_paging_back_restores_exactly_also_the_same_step_twice():
    talk = a_talk()
    session = talk.session
    assert math.isclose(session.values["tilt"], math.radians(30))
    odd = 2.123456789012345
    session.set("distance", odd)
    session.look(View(10.0, 20.0, 7.0))
    session.show_plot(1)
    left = dict(session.values), session.view, session.visit.plot
    assert talk.move(1) and not talk.has_scene
    assert talk.move(1) and math.isclose(session.values["tilt"], math.radians(-20))
    assert session.values["distance"] == 1.6 and session.visit.plot == 0, "a cue's own state, not the other's"
    session.set("tilt", 0.5)
    assert talk.move(1) and session.current.id == "fresnel/schlick" and not talk.move(1)
    talk.move(-1)
    assert session.values["tilt"] == 0.5
    talk.move(-2)
    assert (dict(session.values), session.view, session.visit.plot) == left and session.values["distance"] == odd
    assert not session.undo(), "what was done at another stop is no step back of this one"
    talk.reset()
    assert session.values["distance"] == 1.6 and math.isclose(session.values["tilt"], math.radians(30))


def test_black_comes_back_before_it_moves():
    talk = a_talk()
    talk.is_black = True
    assert talk.move(1) and (talk.place, talk.is_black) == (0, False)


def test_a_value_moves_there_and_back_and_is_one_entry_of_the_history():
    talk = a_talk(Stop("solid_angle/patch?tilt=30", sweep="tilt=-60..60", seconds=2))
    talk.play()
    seen = []
    for _ in range(8):
        talk.tick(0.5)
        seen.append(round(math.degrees(talk.session.values["tilt"])))
    assert seen == [-30, 0, 30, 60, 30, 0, -30, -60]
    talk.play()
    talk.tick(0.5)
    assert not talk.playing and round(math.degrees(talk.session.values["tilt"])) == -60
    assert talk.session.undo() and round(math.degrees(talk.session.values["tilt"])) == 30
    other = a_talk()
    other.touched = "distance"
    assert other.sweep().spec.name == "distance", "without a cue it is the value that was touched"


# --- the class -------------------------------------------------------------------------------------------------------
def test_a_question_freezes_counts_and_tells():
    talk = a_talk()
    talk.play()
    talk.ask()
    assert talk.session.frozen and not talk.playing and talk.hands.total == 0
    talk.play()
    assert not talk.playing, "nothing moves while the class thinks"
    talk.hands.take("0.3x3 0.5 0.5 0.9")
    talk.move(1)
    assert not talk.session.frozen
    talk.move(-1)
    assert talk.session.frozen and talk.hands.total == 6, "the question waits where it was left"
    truth = talk.session.reveal().truth
    assert math.isclose(truth, 0.2923, abs_tol=1e-3) and talk.is_told
    assert talk.hands.words(truth) == "3 of 6 within 10%; the middle guess was 0.5 of it." and not talk.session.frozen
    talk.ask()
    assert talk.hands is None


def test_guesses_are_numbers_and_their_bars_add_up():
    hands = Hands(step("solid_angle/patch").step.ask)
    hands.take("0.1, 0.3x4; 0.5*2")
    assert hands.guesses == [0.1, *[0.3] * 4, 0.5, 0.5] and sum(n for _, n in hands.bars()) == 7
    for wrong, sentence in (("0.3 x", "x is no guess"), ("7", "guesses go from 0 to 1"),
                            ("0.3x9999", "more than 1000")):
        with pytest.raises(Usage, match=sentence):
            hands.take(wrong)
    assert hands.total == 7
    log = next(found.step.ask for found in steps() if found.step.ask.scale == "log")
    on_log = Hands(log, guesses=[log.low, 1.01 * (log.low * log.high) ** 0.5, log.high])
    assert [n for _, n in on_log.bars()] == [1, *[0] * 5, 1, *[0] * 4, 1]


def test_choices_are_counted_and_the_right_one_found():
    found = next(found for found in steps() if found.step.ask.choices)
    hands = Hands(found.step.ask)
    right = found.step.ask.choices[1]
    hands.count(0, 5)
    hands.count(1, 3)
    hands.count(1, -2 + 5)
    hands.count(0, -1)
    assert hands.counts[:2] == [0, 3] and hands.right(0.5 * (right.low + right.high)) == 1
    assert hands.words(0.5 * (right.low + right.high)) == "3 of 3 hands had it."


# --- where things stand ----------------------------------------------------------------------------------------------
@pytest.mark.parametrize("size", [(1280, 690), (1920, 1040), (960, 1040), (640, 690), (1280, 400)])
@pytest.mark.parametrize("slide", [0.0, 4 / 3, 16 / 9])
@pytest.mark.parametrize("detail", [0, 1, 2])
def test_areas_are_inside_apart_and_the_scene_is_large(size, slide, detail):
    found = areas(Rect(0, 0, *size), slide, True, detail)
    assert set(found) == {"scene", "plot", *({"slide"} if slide else set()), *({"numbers"} if detail else set()),
                          *({"text"} if detail == 2 else set())}
    for one in found.values():
        assert one.x >= 0 and one.y >= 0 and one.x + one.width <= size[0] and one.y + one.height <= size[1] + 1e-6
        assert min(one.width, one.height) >= 90
    for a, b in combinations(found.values(), 2):
        across = min(a.x + a.width, b.x + b.width) - max(a.x, b.x)
        down = min(a.y + a.height, b.y + b.height) - max(a.y, b.y)
        assert min(across, down) <= 1e-6
    scene = found["scene"]
    assert scene.width * scene.height >= 0.2 * size[0] * size[1]
    assert sum(one.width * one.height for one in found.values()) > 0.9 * size[0] * size[1]
    assert areas(Rect(0, 0, *size), slide, False, detail) == {"slide": Rect(0, 0, *size)}


def test_what_cannot_be_presented_is_said(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(present, "has_display", lambda: False)
    for words, code, sentence in (((), 1, "there is no display to present on"),
                                  (("--theme", "drak"), 2, "there is no theme drak. Did you mean dark?"),
                                  (("none.toml",), 2, "none.toml cannot be read"),
                                  (("fresnel/schlik",), 2, "Did you mean fresnel/schlick"),
                                  (("--slides", "none.pdf"), 2, "there is no deck none.pdf")):
        assert cli.main(["present", *words]) == code
        assert sentence in capsys.readouterr().err
