"""A person edits a formula in the window: typed, wrong, restored, saved; what was typed is there on another day."""

import numpy as np
import pytest
from imgui_bundle import imgui
from imgui_bundle import imgui_color_text_edit as edit

from app import own_models
from app.progress import Progress
from tests.window import drive, frames, on_gl, until

STEP = "microfacets/cook_torrance"


@pytest.fixture(autouse=True)
def own_data(tmp_path, monkeypatch):
    monkeypatch.setenv("HALFWAY_DATA", str(tmp_path / "data"))


def test_a_formula_is_edited_broken_restored_and_saved():
    def test(engine, window):
        def picture() -> np.ndarray:
            until(engine, window, lambda: window.scene.is_fine)
            return on_gl(engine, window, window.scene.stage.picture.pixels).astype(int)

        def cursor(line: int, index: int) -> None:
            on_gl(engine, window, lambda: window.editor.widget.widget.set_cursor(edit.TextEditor.DocPos(line, index)))
            frames(engine, 2)

        window.open_link("code:d_beckmann")
        until(engine, window, lambda: window.editor.widget is not None)
        frames(engine, 5)
        course, number = picture(), on_gl(engine, window, window.numbers)[0].value
        text = window.editor.widget.text
        assert not window.session.visit.texts  # to open it is no edit
        line = next(i for i, part in enumerate(text.split("\n")) if "return" in part)
        cursor(line, text.split("\n")[line].index(", m)") + 2)
        engine.key_chars("2.0 * ")
        until(engine, window, lambda: "2.0 * m" in window.session.visit.running.get("d_beckmann", ""))
        mine = picture()
        assert np.abs(mine - course).max() > 30
        now = on_gl(engine, window, window.numbers)[0]
        assert now.whose == "yours" and abs(now.value - number) > 0.1 * number

        engine.key_chars("wrong ")  # the last good picture stays, the message stands at its line
        until(engine, window, lambda: bool(window.own.wrong))
        frames(engine, 3)
        assert window.editor.widget.markers[0][0] == line + 1
        assert not window.show_outline and not window.show_notes  # O and N were letters
        assert np.array_equal(picture(), mine)
        until(engine, window, lambda: window.editor.typed_at == 0.0)
        assert "wrong" in Progress().texts(STEP)[0]["d_beckmann"]  # on disk already

        engine.key_down(imgui.Key.mod_ctrl)
        engine.key_press(imgui.Key.r)
        engine.key_up(imgui.Key.mod_ctrl)
        until(engine, window, lambda: not window.session.visit.running)
        frames(engine, 3)
        assert window.editor.widget.text == text and not window.own.wrong
        assert np.array_equal(picture(), course)

        on_gl(engine, window, lambda: window.session.type("d_beckmann", text.replace(", m)", ", 2.0 * m)")))
        until(engine, window, lambda: bool(window.session.visit.running))
        engine.item_input_value("//Text/##name", "my_model")
        engine.item_click("//Text/Save")
        assert own_models.path_of("my_model").suffix == ".brdf" and "my_model" in window.message
        window.move(1)
        frames(engine, 3)
        assert window.own.tried == (window.session.current.id, {}) and not window.own.wrong

    drive(test, start=STEP)
    again = drive(lambda engine, window: until(engine, window, lambda: bool(window.session.visit.running)), start=STEP)
    assert "2.0 * m" in again.session.text("d_beckmann")


@pytest.mark.parametrize("step, function", [("plausible_shading/compare", "f_material"),
                                            ("lights/area_exact?light_height=3", "irradiance_light")])
def test_a_scene_that_does_without_something_is_edited_all_the_same(step, function):
    def test(engine, window):
        frames(engine, 4)
        session, own = window.session, window.own
        assert any(one.is_out for one in own.decided)

        def typed(name: str) -> None:
            mine = session.functions[name].text.replace("return ", "return 0.0 * ", 1)
            on_gl(engine, window, lambda: session.type(name, mine))
            until(engine, window, lambda: name in session.visit.running or bool(own.wrong))
            frames(engine, 3)
            assert not own.wrong and not own.fault and name in session.visit.running, own.wrong

        typed("shade")
        typed(function)
        assert not any(one.is_out and function in one.of.without for one in own.decided)

    drive(test, start=step)
