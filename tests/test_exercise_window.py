"""An exercise in the window: a wrong answer is drawn and told, the right one is green, and nothing typed is lost."""

import numpy as np
import pytest
from imgui_bundle import imgui
from imgui_bundle import imgui_color_text_edit as edit

from app.__main__ import main
from app.practice import Practice
from app.progress import Progress
from tests.window import drive, frames, on_gl, until

STEP = EXERCISE = "brdfs/lambert"
RIGHT = "dot(n, l) > 0.0 && dot(n, v) > 0.0 ? rho / 3.14159265358979 : 0.0; //"
NO_PI = RIGHT.replace(" / 3.14159265358979", "")


@pytest.fixture(autouse=True)
def own_data(tmp_path, monkeypatch):
    monkeypatch.setenv("HALFWAY_DATA", str(tmp_path / "data"))


class Hand:
    """What a person does with the panel and sees of it."""

    def __init__(self, engine, window):
        self.engine, self.window, self.panel = engine, window, window.exercise

    @property
    def text(self) -> str:
        return self.panel.widget.text

    def until(self, true) -> None:
        until(self.engine, self.window, true)

    def picture(self) -> np.ndarray:
        self.until(lambda: self.window.scene.is_fine)
        return on_gl(self.engine, self.window, self.window.scene.stage.picture.pixels).astype(int)

    def course(self) -> np.ndarray:
        """The scene without one's text: as it is beside a text in Python."""
        visit = self.window.session.visit
        self.engine.item_click("//Text/Python")
        self.until(lambda: not visit.running)
        picture = self.picture()
        self.engine.item_click("//Text/GLSL")
        self.until(lambda: bool(visit.running))
        return picture

    def write(self, words: str) -> None:
        """Behind `return`."""
        line = next(i for i, text in enumerate(self.text.split("\n")) if "return " in text)
        at = edit.TextEditor.DocPos(line, self.text.split("\n")[line].index("return ") + 7)
        on_gl(self.engine, self.window, lambda: self.panel.widget.widget.set_cursor(at))
        frames(self.engine, 2)
        self.engine.key_chars(words)
        self.until(lambda: words in self.text)

    def control_r(self) -> None:
        self.engine.key_down(imgui.Key.mod_ctrl)
        self.engine.key_press(imgui.Key.r)
        self.engine.key_up(imgui.Key.mod_ctrl)
        frames(self.engine, 3)

    def checked(self):
        """The verdicts of what stands there."""
        self.until(lambda: (shown := self.panel.checker.shown) and shown.text == self.text
                   and not self.panel.checker.busy)
        return self.panel.checker.shown


def changed(a: np.ndarray, b: np.ndarray) -> int:
    return int(np.abs(a - b).max())


def solve(hand: Hand) -> None:
    """A wrong answer, then the right one: the scene and the verdicts follow."""
    hand.engine.key_press(imgui.Key.x)
    hand.until(lambda: hand.panel.is_shown)
    course = hand.course()
    assert hand.window.session.visit.running.keys() == {"brdf_lambert"}
    frames(hand.engine, 5)
    stub, black = hand.text, hand.picture()
    assert hand.panel.is_drawn and "return 0.0" in stub and changed(black, course) > 30
    assert not hand.checked().ok and not hand.panel.practice.solved(EXERCISE)

    hand.write(NO_PI)
    wrong = hand.checked()
    assert [name for name, _ in wrong.suspects] == ["lambert_no_pi"] and wrong.plot is not None
    bright, mine = hand.picture(), hand.text
    assert changed(bright, black) > 30 and changed(bright, course) > 20
    assert on_gl(hand.engine, hand.window, hand.window.numbers)[-1].whose == "yours"
    hand.control_r()
    assert hand.text == stub
    hand.control_r()
    assert hand.text == mine and hand.checked().text == mine

    hand.write(RIGHT)
    right = hand.checked()
    assert right.ok and all(good for good, _ in right.checks) and right.suspects == []
    assert changed(hand.picture(), course) <= 2
    hand.until(lambda: hand.panel.practice.solved(EXERCISE))


def leave_and_come_back(hand: Hand) -> None:
    window, mine, session = hand.window, hand.text, hand.window.session
    window.move(1)  # its chapter's other steps have it too
    frames(hand.engine, 3)
    window.move(-1)
    hand.until(lambda: hand.text == mine and bool(session.visit.running))
    hand.engine.key_press(imgui.Key.escape)
    hand.until(lambda: not session.visit.running)  # the scene is the course's again
    assert not hand.panel.is_open
    hand.window.do("x")
    hand.until(lambda: hand.panel.is_shown and bool(session.visit.running) and hand.text == mine)


def test_an_exercise_is_drawn_checked_solved_and_handed_in(tmp_path):
    def test(engine, window):
        hand = Hand(engine, window)
        solve(hand)
        leave_and_come_back(hand)
        window.progress.put_setting("hand_in_folder", str(tmp_path / "mine"))
        engine.item_click("//Text/Hand in")
        engine.item_click("//$FOCUSED/Write the file")
        hand.until(lambda: bool(hand.panel.handed[1]))
        assert hand.panel.handed[1].startswith(f"Written: {tmp_path / 'mine' / 'brdfs' / 'submission.glsl'}. 1 of its ")

    drive(test, start=STEP)
    kept = Practice(Progress())
    assert RIGHT in kept.kept(EXERCISE, "texts")["glsl"] and kept.solved(EXERCISE)
    assert main(["check", str(tmp_path / "mine" / "brdfs" / "submission.glsl")]) == 1  # another function is a stub
