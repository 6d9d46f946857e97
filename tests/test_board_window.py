"""The board in the window: opened by a drop, models on and off, a point picked, its numbers and badges."""

import math
import time

import numpy as np
import pytest
from imgui_bundle import ImVec2, imgui

from app import camera as orbit
from app.brush import picked_frame
from tests.test_board_report import TINTED
from tests.test_board_step import write_file
from tests.window import drive, frames, on_gl, until


@pytest.fixture(autouse=True)
def own_data(tmp_path, monkeypatch):
    monkeypatch.setenv("HALFWAY_DATA", str(tmp_path / "data"))


def a_click_picks(engine, window) -> dict:
    """The point under the hand becomes the picked one; the values after it."""
    session, scene = window.session, window.scene
    view, before = session.view.camera(session.current.step.scene.camera), dict(session.values)
    frame = picked_frame(view, before["theta_v"], before["turned"])
    foot = np.asarray(on_gl(engine, window, lambda: scene.points["handle the picked point"]))
    n = frame @ np.array([-0.35, 0.2, 0.9]) / np.linalg.norm((-0.35, 0.2, 0.9))
    x, y, _ = orbit.project(foot + 0.84 * (n - frame[:, 2]), scene.stage.matrix)
    engine.mouse_move_to_pos(ImVec2(scene.corner.x + x * scene.room.x, scene.corner.y + y * scene.room.y))
    engine.mouse_click(0)
    frames(engine, 4)
    at = dict(session.values)
    assert at["theta_v"] != before["theta_v"], window.message
    assert picked_frame(view, at["theta_v"], at["turned"])[:, 2] @ n > 0.995
    return at


@pytest.mark.parametrize("theme", ["dark", "light", "projector"])
def test_three_models_have_room_on_a_projector(tmp_path, theme):
    """All that is set and chosen is in sight without scrolling, and a long name takes no more than others."""
    long = write_file(tmp_path, "a_very_long_name_of_a_measured_and_fitted_plate_of_brushed_steel.brdf")

    def test(engine, window):
        window.set_theme(theme)
        frames(engine, 4)
        hidden = on_gl(engine, window, lambda: imgui.internal.find_window_by_name("Text").scroll_max)
        assert (hidden.x, hidden.y) == (0, 0)

    drive(test, start=f"board/cook_torrance+{long}+ggx")


def test_a_file_is_dropped_examined_and_left(tmp_path):
    good, bad = write_file(tmp_path, "tinted.brdf"), write_file(tmp_path, "bad.brdf", TINTED.replace("tint /", "tnt /"))

    def test(engine, window):
        frames(engine)
        window.dropped.append(bad)
        frames(engine, 4)
        assert window.session.current.id == "solid_angle/patch" and "line 8" in window.message
        window.dropped.append(good)
        frames(engine, 4)
        session = window.session
        assert session.current.id.startswith("board/") and session.current.step.title == "tinted"
        assert not window.own.fault and window.scene.stage
        session.set("model0_n", 2.0)
        frames(engine)
        [f] = on_gl(engine, window, window.numbers)
        assert f.value == pytest.approx(2 * (0.2126 + 0.7152 * 0.5 + 0.0722 * 0.25) / math.pi, rel=1e-5)
        until(engine, window, lambda: len(window.badges.known) > 0 and not window.badges.waiting)
        judged = list(window.badges.known.values())[-1]
        assert not judged["energy"].ok and judged["reciprocal"].ok
        assert judged["energy"].worst == pytest.approx(2, rel=1e-3)

        window.dropped.append(bad)  # beside a good one it stays on the list, with its fault
        frames(engine, 4)
        assert [one.label for one in session.current.entries] == ["tinted", "bad"]
        assert "line 8" in session.current.entries[1].fault and session.values["model0_n"] == 2.0
        mesh = tmp_path / "one.obj"
        mesh.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        window.dropped.append(str(mesh))
        frames(engine, 4)
        assert session.values["stands"] == 1 and window.message.startswith("one.obj: 1 triangle;"), "and is seen"
        on_gl(engine, window, lambda: window.board.change([(good, True), ("cook_torrance", True)]))
        frames(engine, 4)
        assert session.current.step.title == "tinted, cook_torrance" and session.values["model0_n"] == 2.0
        assert [n.label for n in on_gl(engine, window, window.numbers)] == ["f, tinted", "f, cook_torrance"]
        session.set("model", 1)
        frames(engine, 3)
        assert [n.label for n in window.board.figures[1]] == ["D", "G", "F", "4 (n·l)(n·v)"]

        at = a_click_picks(engine, window)

        window.move(-1)
        frames(engine, 3)
        assert not session.current.id.startswith("board/")
        window.move(1)
        frames(engine, 3)
        assert session.current.id.startswith("board/") and session.values["theta_v"] == at["theta_v"]
        window.go("solid_angle/patch")
        frames(engine)

    window = drive(test)
    assert not any(key.startswith("board") for key in window.progress.data.get("steps", {}))


def test_the_board_of_a_folder_lists_what_is_broken(tmp_path, monkeypatch):
    from app.board.board_step import id_of

    words = [write_file(tmp_path, f"m{i}.brdf") for i in range(6)] + [write_file(tmp_path, "x.brdf", "analytic")]

    def test(engine, window):
        frames(engine, 4)
        assert [one.on for one in window.session.current.entries] == [True] * 4 + [False] * 3
        on_gl(engine, window, lambda: window.board.change([(w, i < 5) for i, w in enumerate(words)]))
        assert "4 models at once" in window.message
        begun = time.monotonic()
        on_gl(engine, window, lambda: window.board.change([(w, i == 5) for i, w in enumerate(words)]))
        frames(engine, 3)
        assert window.session.current.step.title == "m5" and time.monotonic() - begun < 60

    drive(test, start=id_of(words))
