"""The window as a person uses it: clicked, typed, dragged, in the complete app on GLFW's null platform."""

import math
from functools import partial

import numpy as np
import pytest
from imgui_bundle import ImVec2, imgui

from app import camera as orbit
from app.catalog import chapters
from app.gpu.picture import Faults
from app.theme import THEMES
from app.viewer import style, text_panel
from tests.small_lesson import model_lesson
from tests.window import drive, frames, on_gl, until


@pytest.fixture(autouse=True)
def own_data(tmp_path, monkeypatch):
    monkeypatch.setenv("HALFWAY_DATA", str(tmp_path / "data"))


def place(window, point) -> ImVec2:
    """Where a point of the world stands in the window."""
    info = window.scene
    x, y, _ = orbit.project(np.asarray(point, float), info.stage.matrix)
    return ImVec2(info.corner.x + x * info.room.x, info.corner.y + y * info.room.y)


def test_steps_are_left_and_returned_to_with_the_same_state():
    def test(engine, window):
        engine.item_input_value("//Scene/##distance", 3.5)
        assert math.isclose(window.session.values["distance"], 3.5)
        engine.item_click("//Bar/Next")
        assert window.session.current.id == "solid_angle/cone"
        engine.key_press(imgui.Key.page_down)
        assert window.session.current.id == "solid_angle/differential"
        engine.key_press(imgui.Key.page_up, 2)
        assert window.session.current.id == "solid_angle/patch"
        assert math.isclose(window.session.values["distance"], 3.5)

    drive(test)
    again = drive(lambda engine, window: frames(engine), start="")  # another day: where it was left
    assert again.session.current.id == "solid_angle/patch" and math.isclose(again.session.values["distance"], 3.5)


def test_a_value_is_typed_reset_and_undone_and_the_picture_follows():
    def test(engine, window):
        frames(engine)
        before, drawn = on_gl(engine, window, window.scene.stage.picture.pixels), window.scene.frames_drawn
        engine.item_input_value("//Scene/##tilt", -40.0)
        frames(engine)
        assert math.isclose(window.session.values["tilt"], math.radians(-40), rel_tol=1e-6)
        assert (
            window.scene.frames_drawn > drawn
            and np.abs(on_gl(engine, window, window.scene.stage.picture.pixels).astype(int) - before).max() > 30
        )
        engine.key_down(imgui.Key.mod_ctrl)
        engine.key_press(imgui.Key.z)
        engine.key_up(imgui.Key.mod_ctrl)
        assert math.isclose(window.session.values["tilt"], math.radians(25))
        engine.item_input_value("//Scene/##tilt", 999.0)  # beyond the range: the range's end
        assert math.isclose(window.session.values["tilt"], math.pi / 2)
        engine.item_double_click("//Scene/##tilt")
        assert math.isclose(window.session.values["tilt"], math.radians(25))

    drive(test)


def test_nothing_is_drawn_again_while_nothing_changes():
    def test(engine, window):
        until(
            engine, window, lambda: window.scene.is_fine and window.plot.texture is not None and not window.plot.waiting
        )
        frames(engine, 5)
        drawn, wished = window.scene.frames_drawn, window.plot.process.count
        frames(engine, 40)
        assert (window.scene.frames_drawn, window.plot.process.count) == (drawn, wished)

    drive(test)


def test_handles_follow_the_hand():
    """Dragged to where its point would be for other values, a handle finds those values; a drag is one entry."""

    def test(engine, window):
        for name, goal in (
            ("the patch", {"theta": 0.8, "phi": 0.1}),
            ("its distance", {"distance": 1.5}),
            ("its normal", {"tilt": 0.1}),
        ):
            frames(engine)
            before, stage = dict(window.session.values), window.scene.stage
            handle = next(h for h in stage.scene.handles if h.name == name)
            there = on_gl(engine, window, partial(stage.probes, {**before, **goal}))[handle.probe, :3]
            at, to = place(window, window.scene.points[f"handle {name}"]), place(window, there)
            engine.mouse_teleport_to_pos(at)
            frames(engine)
            engine.mouse_down(0)
            for share in (0.25, 0.5, 0.75, 1.0):
                engine.mouse_teleport_to_pos(ImVec2(at.x + share * (to.x - at.x), at.y + share * (to.y - at.y)))
                frames(engine, 2)
            engine.mouse_up(0)
            frames(engine)
            values = window.session.values
            assert {n for n in values if values[n] != before[n]} == set(goal), name
            assert all(math.isclose(values[n], goal[n], abs_tol=0.02) for n in goal), (name, goal, values)
        window.session.undo()
        assert window.session.values["tilt"] == before["tilt"]

    drive(test)


def test_the_picture_turns_zooms_and_is_read():
    def test(engine, window):
        frames(engine)
        view = window.session.view
        middle = ImVec2(window.scene.corner.x + 40, window.scene.corner.y + 40)
        engine.mouse_teleport_to_pos(middle)
        engine.mouse_drag_with_delta(ImVec2(60, 10))
        turned = window.session.view
        assert turned.azimuth < view.azimuth and turned.elevation > view.elevation and turned.distance == view.distance
        engine.mouse_wheel(ImVec2(0, 2))
        assert window.session.view.distance < view.distance
        engine.mouse_double_click(0)
        assert window.session.view == view
        engine.key_press(imgui.Key.mod_shift | imgui.Key.right_arrow, 2)
        engine.key_press(imgui.Key.mod_shift | imgui.Key.minus)
        assert window.session.view.azimuth == view.azimuth + 10 and window.session.view.distance > view.distance
        engine.key_press(imgui.Key.mod_ctrl | imgui.Key.z, 3)
        assert window.session.view == view
        frames(engine)
        inside = 0.4 * window.scene.points["handle the patch"] + 0.6 * window.scene.points["label 3"]
        engine.mouse_teleport_to_pos(place(window, inside))
        engine.mouse_click(0)
        frames(engine)
        found, _ = window.scene.picked
        assert (
            found.surface == "patch" and np.linalg.norm(np.subtract(found.position, inside)) < 0.04
        )  # the mouse stands on whole pixels

    drive(test)


def test_a_prediction_is_asked_guessed_and_told():
    def test(engine, window):
        assert window.session.answer.stage == "asked"
        engine.item_click("//Text/**/Let me think")
        assert window.session.frozen
        engine.item_input_value("//Text/**/##guess", 0.25)
        assert window.session.answer.guess == 0.25
        engine.item_click("//Text/**/Show the truth")
        answer = window.session.answer
        assert answer.stage == "revealed" and not window.session.frozen
        assert math.isclose(answer.truth, 0.2923, rel_tol=1e-3)
        assert math.isclose(window.session.values["distance"], 2.0) and window.session.values["width"] == 1.0
        engine.item_click("//Text/**/Ask me again")
        assert window.session.answer.stage == "asked"

    drive(test)


def test_first_start_outline_and_search():
    def test(engine, window):
        assert window.show_welcome and window.cover.stage is not None
        first = on_gl(engine, window, window.cover.stage.picture.pixels)
        frames(engine, 20)
        assert (on_gl(engine, window, window.cover.stage.picture.pixels) != first).any()  # it turns
        engine.item_click("//Welcome/**/Start")
        assert not window.show_welcome and window.session.current.id == "solid_angle/angle"
        engine.key_press(imgui.Key.o)
        assert window.show_outline
        engine.item_click("//Outline/##search")
        engine.key_press(imgui.Key.escape)  # also while one types
        frames(engine)
        assert not window.show_outline
        engine.key_press(imgui.Key.o)
        engine.item_click("//Outline/##search")
        engine.key_chars("nusselt")
        frames(engine)
        engine.item_click("//Outline/**/What the floor gets##0")
        assert window.session.current.id == "solid_angle/projected" and not window.show_outline

    drive(test, start="")


def test_themes_change_everything_and_are_kept():
    def test(engine, window):
        seen = {}
        for _ in range(3):
            frames(engine, 4)
            seen[window.theme.name] = tuple(on_gl(engine, window, window.scene.stage.picture.pixels)[5, 5].tolist())
            engine.key_press(imgui.Key.t)
        assert len(set(seen.values())) == 3, seen
        frames(engine)
        engine.item_click("//Bar/Theme")

    drive(test)
    assert drive(lambda engine, window: frames(engine)).theme.name == "light"


def test_the_plots_die_and_are_restarted():
    def test(engine, window):
        until(engine, window, lambda: window.plot.of == "solid_angle/patch")
        window.plot.process.child.kill()
        window.session.set("distance", 3.0)
        until(engine, window, lambda: bool(window.plot.fault))
        assert "ended" in window.plot.fault
        shown = window.plot.shown
        engine.item_click("//Plot/Restart the plots")
        until(engine, window, lambda: window.plot.shown > shown)
        assert not window.plot.fault

    drive(test)


def test_a_mesh_is_dropped_and_a_bad_one_explained(tmp_path):
    import trimesh

    good, bad = tmp_path / "ball.stl", tmp_path / "rubbish.stl"
    trimesh.creation.icosphere(subdivisions=2).export(good)
    bad.write_bytes(b"\x00\xff" * 40)

    def test(engine, window):
        window.dropped.append(str(bad))
        frames(engine)
        assert "rubbish.stl" in window.message and window.session.current.id == "solid_angle/patch"
        window.dropped.append(str(good))
        frames(engine)
        assert window.session.current.id == "solid_angle/mesh" and len(window.own.triangles) == 320
        number = {n.label: n for n in window.numbers()}["sum of all faces"]
        assert math.isclose(number.value, 4 * math.pi, rel_tol=1e-12)
        engine.item_click("//Scene/bowl##shape")
        frames(engine)
        assert window.own.mesh is None and len(window.own.triangles) != 320

    drive(test)


def test_a_link_of_the_prose_sets_the_scene():
    def test(engine, window):
        window.open_link("?tilt=88")
        assert math.isclose(window.session.values["tilt"], math.radians(88))
        window.open_link("solid_angle/cone?half_angle=90")
        assert window.session.current.id == "solid_angle/cone"
        window.open_link("?half_angle=999")
        assert "out of range" in window.message or "to" in window.message

    drive(test)


@pytest.mark.parametrize("size", [(1280, 720), (1920, 1080)])
@pytest.mark.parametrize("theme", THEMES)
@pytest.mark.parametrize("chapter", chapters(), ids=lambda chapter: chapter.id)
def test_every_step_shows_in_every_theme(chapter, theme, size):
    def test(engine, window):
        window.set_theme(theme)
        for number in range(len(chapter.chapter.steps)):
            frames(engine, 3)
            assert not window.own.fault and window.scene.faults == Faults(), window.session.current.id
            for column in ("Text", "Scene", "Plot"):
                inside = on_gl(engine, window, lambda name=column: imgui.internal.find_window_by_name(name))
                assert inside.content_size.x <= inside.size.x, (window.session.current.id, column)
            if size == (1280, 720):
                until(engine, window, lambda: window.plot.of == window.session.current.id)
                assert not window.plot.fault
            if number + 1 < len(chapter.chapter.steps):
                engine.key_press(imgui.Key.page_down)
                frames(engine, 2)

    drive(test, start=f"{chapter.id}/{chapter.chapter.steps[0].name}", size=size)


def test_a_formula_wider_than_its_column_is_made_smaller():
    def test(engine, window):
        window.set_theme("projector")
        frames(engine)
        text, size = window.session.current.step.prose, imgui.get_style().font_size_base
        wide, narrow = (text_panel.prose(text, "projector", size, room) for room in (900, 380))
        assert "scalebox" not in wide and narrow.count(r"$$\scalebox{0.") == 1

    drive(test, start="solid_angle/polygon")


@pytest.mark.parametrize("theme", THEMES.values(), ids=lambda theme: theme.name)
@pytest.mark.parametrize("name", ["l", "printed", "quiet", "estimate"])
def test_words_in_a_colour_of_the_grammar_can_be_read(theme, name):
    light, ground = (style.luminance(c) for c in (style.ink(name, theme), style.rgb(theme.panel)))
    assert style.contrast(light, ground) >= 4.5


def test_the_window_loads_neither_vtk_nor_trimesh_nor_pillow():
    import subprocess
    import sys

    code = (
        "import sys; from tests.window import drive, frames; drive(lambda e, w: frames(e, 5));"
        "heavy = ('vtkmodules', 'pyvista', 'trimesh', 'PIL', 'scipy', 'matplotlib', 'OpenGL');"
        "print([m for m in heavy if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip().endswith("[]"), done.stdout


def test_a_luminaire_is_dropped_and_a_bad_one_explained(tmp_path):
    from app.tables import FOLDER, built_in

    good, bad = tmp_path / "mine.IES", tmp_path / "short.ies"
    text = (FOLDER / "flood.ies").read_bytes()
    good.write_bytes(text)
    bad.write_bytes(text[:-300])

    def test(engine, window):
        window.dropped.append(str(bad))
        frames(engine)
        assert "short.ies, line" in window.message and window.session.current.id == "solid_angle/patch"
        window.dropped.append(str(good))
        frames(engine, 4)
        assert window.session.current.id == "lights/ies" and "mine.IES: LM-63-2002" in window.message
        assert not window.own.fault and np.array_equal(window.values["table"], built_in("flood").table)
        shown = {n.label: n for n in window.numbers()}
        assert math.isclose(shown["integrated"].value, built_in("flood").integrated_lumens)
        until(engine, window, lambda: window.plot.of == "lights/ies")
        assert not window.plot.fault
        before = on_gl(engine, window, window.scene.stage.picture.pixels)
        engine.item_click("//Scene/up##luminaire")
        frames(engine, 4)
        assert window.own.ies is None and window.values["table"] is built_in("uplight").table
        assert (on_gl(engine, window, window.scene.stage.picture.pixels) != before).any()
        window.reveal()
        assert math.isclose(window.session.answer.truth, built_in("bare").integrated_lumens)

    drive(test)


def test_an_absolute_luminaire_declares_nothing(tmp_path):
    from app.tables import FOLDER

    def test(engine, window):
        window.own.take_file(str(FOLDER / "headlamp.ies"))
        frames(engine, 4)
        shown = {n.label: n for n in on_gl(engine, window, window.numbers)}
        assert shown["declared"].text == "none: absolute" and not shown["declared"].error_text

    drive(test)


def test_badges_come_by_themselves_and_a_click_goes_where_they_point(tmp_path):
    def test(engine, window):
        until(engine, window, lambda: len(window.badges.known) == 2)
        frames(engine)
        red = window.badges.last["small/open", "printed"]["reciprocal"]
        assert not red.ok
        engine.item_click("//Plot/badges/printedreciprocal")
        frames(engine)
        assert window.session.values["theta_v"] == red.at["theta_v"]
        engine.item_input_value("//Scene/##exponent", 5.0)
        until(engine, window, lambda: len(window.badges.known) == 4)
        engine.key_press(imgui.Key.f)  # frozen: they would tell
        before = dict(window.session.values)
        engine.item_click("//Plot/badges/printedenergy")
        frames(engine)
        assert window.session.values == before

    drive(test, start="small/open", folder=model_lesson(tmp_path))


def test_a_step_s_plots_have_tabs_and_a_key(tmp_path):
    def test(engine, window):
        until(engine, window, lambda: window.plot.showing is not None)
        assert window.plot.showing.title == "Two lobes"
        engine.item_click("//Plot/curves##plot1")
        until(engine, window, lambda: window.plot.showing.title == "Cone")
        engine.key_press(imgui.Key.p)
        until(engine, window, lambda: window.plot.showing.title == "Two lobes")

    drive(test, start="small/open", folder=model_lesson(tmp_path))


def test_a_step_is_broken_by_its_button_and_mended_by_a_key():
    def test(engine, window):
        frames(engine, 4)
        sound = on_gl(engine, window, window.scene.stage.picture.pixels).astype(int)
        engine.item_click("//Text/Break it: Snell's root in total reflection")
        frames(engine, 4)
        assert window.session.broken and window.scene.faults.nan > 0
        bad = on_gl(engine, window, window.scene.stage.picture.pixels).astype(int)
        assert np.abs(bad - sound).max() > 100
        engine.key_press(imgui.Key.b)
        frames(engine, 4)
        assert window.session.broken is None and not window.scene.faults
        assert np.array_equal(on_gl(engine, window, window.scene.stage.picture.pixels), sound)

    drive(test, start="fresnel/inside")


def test_a_click_on_a_point_of_a_study_sets_the_scene():
    def test(engine, window):
        window.session.reveal()
        window.session.show_plot(1)
        until(engine, window, lambda: bool(window.plot.spots))
        until(engine, window, lambda: window.plot.fine and window.plot.process.idle)  # the last picture has come
        frames(engine)
        now = window.session.values["sampling"]
        for _ in range(5):  # points move while the study measures: who misses one clicks again
            spots = window.plot.spots
            others = (spot for spot in spots if spot.sets and spot.sets["sampling"] != now
                      and window.plot.study.possible(spot) == spot.sets)  # as many samples as the sliders reach
            # where times are alike points lie on each other, and the nearest one hears the click
            spot = max(others, key=lambda a: min(math.hypot(a.x - b.x, a.y - b.y) for b in spots if b is not a))
            wanted = spot.sets
            place = on_gl(engine, window, lambda: window.plot.at)
            engine.mouse_move_to_pos(ImVec2(place.x + spot.x, place.y + spot.y))
            engine.mouse_click(0)
            frames(engine, 20)
            if {name: window.session.values[name] for name in wanted} == wanted:
                return
        raise AssertionError("no click on a point was heard")

    drive(test, start="lights/area_work")
