"""What a lecturer shows: nothing clipped, nothing on top of something else, nothing to scroll for, in large letters."""

import pytest
from imgui_bundle import imgui

from app.progress import Progress
from app.session import Session
from app.viewer import numbers_panel
from app.viewer.cut import folded
from app.viewer.placing import Box, free
from tests.window import drive, frames, on_gl, until

ROOM = Box(0, 0, 400, 300)


@pytest.fixture(autouse=True)
def own_data(tmp_path, monkeypatch):
    monkeypatch.setenv("HALFWAY_DATA", str(tmp_path / "data"))


def scroll(window, name: str) -> float:
    """px that a column of the window has too little."""
    imgui.begin(name)
    found = imgui.get_scroll_max_y()
    imgui.end()
    return found


def settled(engine, window) -> None:
    until(engine, window, lambda: window.plot.fine and not window.plot.waiting and not window.badges.waiting)
    frames(engine, 4)


def test_a_word_goes_where_no_other_stands():
    first, second = Box(50, 200, 60, 20), Box(90, 205, 60, 20)
    assert free(first, [], ROOM, 1) == first
    below = free(second, [first], ROOM, 1)
    assert below.x == second.x and below.y == 225 and not below.meets(first), "it keeps its place across: a tick's word"
    above = free(Box(90, 195, 60, 20), [first], ROOM, -1)
    assert above.y == 175 and not above.meets(first)
    corner = Box(350, 290, 100, 20)
    assert free(corner, [], ROOM, 1) == Box(300, 280, 100, 20), "inside the picture"
    full = [Box(0, 0, 400, 300)]
    assert free(second, full, ROOM, 1) == second, "where nothing is free, it is written all the same"


def test_a_text_is_folded_between_words_hyphens_and_parts_of_a_name():
    for text, lines in (("half: what is seen", ["half: what", "is seen"]), ("Cook-Torrance", ["Cook-", "Torrance"]),
                        ("cook_torrance", ["cook_", "torrance"]), ("abcdefghijklmn", ["abcdefghi…"]), ("", [""]),
                        ("1 − F(n·l)", ["1 − F(n·l)"])):
        assert folded(text, 10, len).split("\n") == lines
    assert folded("no room  at all", 100, len) == "no room  at all"


def test_large_letters_fit_where_most_is_shown(monkeypatch):
    """The step with the longest answers and the most badges, then three models on the board."""
    seen, radio = [], imgui.radio_button

    def spy(label, active):
        result = radio(label, active)
        right = imgui.get_window_pos().x + imgui.get_window_width() - imgui.get_style().window_padding.x
        seen.append((label, imgui.get_item_rect_max().x <= right + 1))
        return result

    monkeypatch.setattr(imgui, "radio_button", spy)

    def test(engine, window):
        window.set_theme("projector")
        frames(engine, 4)
        seen.clear()
        frames(engine, 2)
        assert any("\n" in label for label, _ in seen) and all(fits for _, fits in seen), seen
        settled(engine, window)
        assert on_gl(engine, window, lambda: scroll(window, "Plot")) == 0
        window.go("board/cook_torrance+oren_nayar+phong")
        frames(engine, 4)
        settled(engine, window)
        assert on_gl(engine, window, lambda: scroll(window, "Plot")) == 0
        assert window.plot.texture.size[1] > 0.4 * 720, "and the plot is no stamp"

    drive(test, start="geometry_term/smith")


def test_the_picture_makes_room_for_the_rest_of_the_controls():
    def test(engine, window):
        window.set_theme("projector")
        frames(engine, 4)
        before = window.scene.room.y
        engine.item_click("//Scene/more")
        frames(engine, 4)
        assert window.scene.room.y < before and on_gl(engine, window, lambda: scroll(window, "Scene")) == 0
        engine.item_click("//Scene/more")
        frames(engine, 4)
        assert window.scene.room.y == before

    drive(test, start="geometry_term/smith")


def test_no_unit_is_torn_where_there_is_room():
    def test(engine, window):
        frames(engine, 4)
        found = window.numbers()
        longest = max((number.text for number in found), key=len)
        assert "W/(m² sr)" in longest

        def look():
            needed = imgui.calc_text_size(longest).x
            return needed, numbers_panel.widths(found, 22 * imgui.get_font_size())[0]

        needed, given = on_gl(engine, window, look)
        assert given >= needed

    drive(test, start="radiometry/radiance")


def test_what_can_be_broken_says_so_in_the_line_below():
    def test(engine, window):
        frames(engine, 4)
        engine.item_click("//Bar/Break it")
        frames(engine, 2)
        assert window.session.broken
        window.session.save()
        engine.item_click("//Bar/Put it right")
        assert window.session.broken is None
        window.go("solid_angle/cone")
        frames(engine, 2)
        assert engine.item_exists("//Bar/Theme") and not engine.item_exists("//Bar/Break it")

    drive(test, start="lights/spot")


def test_a_broken_step_is_kept_as_it_was_before():
    progress = Progress()
    session = Session("lights/spot?hotspot=10", progress)
    session.break_it()
    session.save()
    assert progress.state("lights/spot") == "lights/spot?hotspot=10"
