"""The scene in the window: the picture, its words and handles, and the hand that turns, drags and picks."""

import numpy as np
from imgui_bundle import ImVec2, imgui

from app import camera as orbit
from app import needs
from app.brush import angles_of
from app.gpu.pick import Pick, pick
from app.gpu.picture import Faults
from app.gpu.stage import Stage
from app.lesson import Handle
from app.readouts import three
from app.state import FARTHEST, NEAREST, View
from app.theme import Theme, rgb
from app.viewer import handles, style
from app.viewer.scene_words import SceneWords

GRAB = 0.9  # em: how near a handle the hand must be
TURN = 0.35  # degrees a pixel at 720 pixels


class ScenePanel:
    def __init__(self, app) -> None:
        self.app = app
        self.stage: Stage | None = None
        self.drawn: tuple | None = None  # what the picture shows; nothing is drawn again until this changes
        self.is_fine = False
        self.is_settled = False  # every surface has a program of its own, which draws it faster
        self.faults: Faults | None = None  # None: not counted yet, something moves
        self.points: dict[str, np.ndarray] = {}  # where words and handles stand, in the world
        self.held: Handle | None = None
        self.turning = False
        self.moved = 0.0
        self.picked: tuple[Pick, ImVec2] | None = None
        self.frames_drawn = 0
        self.needed: tuple = (None, {}, frozenset())  # by the stage's source and choices
        self.corner, self.room = ImVec2(), ImVec2()  # where the picture lies in the window

    # --- the picture -----------------------------------------------------------------------------------------------
    def show(self, stage: Stage) -> None:
        """Another step: its stage takes the panel over."""
        if self.stage is not None:
            self.stage.release()
        self.stage, self.drawn, self.held, self.picked = stage, None, None, None
        self.is_settled = False

    def draw(self, values: dict, view: View, theme: Theme, room: ImVec2) -> None:
        """The picture, as large as the room; drawn again only when something it shows has changed."""
        assert self.stage is not None
        scale = imgui.get_io().display_framebuffer_scale
        size = max(16, int(room.x * scale.x)), max(16, int(room.y * scale.y))
        camera = view.camera(self.stage.scene.camera)
        wanted = self.shown(values, size, view, theme)
        changed = wanted != self.drawn
        # between two keys nothing rests: each kind of picture compiles a typed text once more
        rest = not (changed or self.is_fine or self.app.editor.typed_at or imgui.is_mouse_down(0))
        if changed:  # before anything is drawn, which an answer would wait for
            self.stage.aim(values, camera, size, theme)
            self.points, self.picked = self.find_points(values), None
        if changed or rest:
            # while something moves one sample a pixel; as soon as it rests edges are soft, and the faults are counted:
            # in a picture of their own, as soft edges of both take 16 bytes a pixel more
            self.is_fine, self.faults = rest, None
            if rest:
                self.stage.draw(values, camera, size, theme, fine=False)
                self.faults = self.stage.picture.faults()
            self.stage.draw(values, camera, size, theme, fine=rest, counted=False)
            self.frames_drawn += 1
            self.drawn = self.shown(values, size, view, theme)  # another choice has other needs
            self.app.ctx.screen.use()
        elif self.is_fine and not self.is_settled and not imgui.is_mouse_down(0):
            self.is_settled = not self.stage.settle(values, camera, theme)
            self.app.ctx.screen.use()
        corner = self.corner = imgui.get_cursor_screen_pos()
        self.room = room
        texture = self.stage.picture.texture
        imgui.image(imgui.ImTextureRef(texture.glo), room, uv0=ImVec2(0, 1), uv1=ImVec2(1, 0))
        imgui.set_cursor_screen_pos(corner)
        imgui.invisible_button(
            "picture", room, imgui.ButtonFlags_.mouse_button_left | imgui.ButtonFlags_.mouse_button_right
        )
        SceneWords(self.stage, self.points, corner, room, theme).draw(self.faults)
        if not self.app.session.frozen:
            self.hand(corner, room, values, view, theme)
        self.card(theme)

    def shown(self, values: dict, size: tuple[int, int], view: View, theme: Theme) -> tuple:
        """All that the picture shows: it is drawn again when this changes."""
        assert self.stage is not None
        own, source = self.stage.own, self.stage.source
        if self.needed[0] is not source:  # another step, or another text of it
            self.is_settled = False
        if self.needed[0] is not source or self.needed[1] != own.choice:
            self.needed = source, own.choice, needs.drawn(self.stage.scene, own.made.texts) | own.seen.keys()
        return size, needs.key(values, self.needed[2]), view, theme.name

    def find_points(self, values: dict) -> dict[str, np.ndarray]:
        assert self.stage is not None
        scene, found = self.stage.scene, {}
        probes = self.stage.probes(values)
        for label in scene.labels:
            found[f"label {label.probe}"] = probes[label.probe, :3]
        for handle in scene.handles:
            found[f"handle {handle.name}"] = probes[handle.probe, :3]
        for name, point in self.stage.anchors(values).items():
            found[f"mark {name}"] = point
        return found

    def on_screen(self, point: np.ndarray, corner: ImVec2, room: ImVec2) -> ImVec2:
        assert self.stage is not None
        x, y, _ = orbit.project(point, self.stage.matrix)
        return ImVec2(corner.x + x * room.x, corner.y + y * room.y)

    # --- the hand --------------------------------------------------------------------------------------------------
    def hand(self, corner: ImVec2, room: ImVec2, values: dict, view: View, theme: Theme) -> None:
        assert self.stage is not None
        io, mouse = imgui.get_io(), imgui.get_mouse_pos()
        near = self.held or (self.nearest(mouse, corner, room) if imgui.is_item_hovered() else None)
        self.rings(near, corner, room, theme)
        if imgui.is_item_activated():
            self.moved, self.held = 0.0, near
            self.turning = near is None
            self.app.session.begin_change()
        if imgui.is_item_active() and (io.mouse_delta.x or io.mouse_delta.y):
            self.moved += abs(io.mouse_delta.x) + abs(io.mouse_delta.y)
            if self.held:
                self.drag(mouse, corner, room, values)
            elif self.turning:
                turn = TURN * 720 / max(room.y, 1)
                self.app.session.look(
                    View(
                        wrap(view.azimuth - io.mouse_delta.x * turn),
                        min(max(view.elevation + io.mouse_delta.y * turn, -89.0), 89.0),
                        view.distance,
                    )
                )
        if imgui.is_item_deactivated():
            self.app.session.end_change()
            if self.held is None and self.moved < 4:
                self.pick_at(mouse, corner, room, values, view, theme)
            self.held, self.turning = None, False
        if imgui.is_item_hovered():
            if io.mouse_wheel:
                away = min(max(view.distance * 0.9**io.mouse_wheel, NEAREST * 2), FARTHEST)
                self.app.session.look(View(view.azimuth, view.elevation, away))
            if imgui.is_mouse_double_clicked(0) and near is None:
                self.app.session.look(View.of(self.stage.scene.camera))
        if near and not imgui.is_item_active():
            imgui.set_mouse_cursor(imgui.MouseCursor_.hand)
            imgui.set_tooltip(f"drag {near.name}")

    def nearest(self, mouse: ImVec2, corner: ImVec2, room: ImVec2) -> Handle | None:
        assert self.stage is not None
        best, least = None, GRAB * imgui.get_font_size()
        for handle in self.stage.scene.handles:
            at = self.on_screen(self.points[f"handle {handle.name}"], corner, room)
            away = float(np.hypot(at.x - mouse.x, at.y - mouse.y))
            if away < least:
                best, least = handle, away
        return best

    def rings(self, near: Handle | None, corner: ImVec2, room: ImVec2, theme: Theme) -> None:
        """A quiet ring on every handle while the hand is in the picture, a strong one on the nearest."""
        assert self.stage is not None
        if not (imgui.is_item_hovered() or self.held):
            return
        draw, size = imgui.get_window_draw_list(), imgui.get_font_size()
        for handle in self.stage.scene.handles:
            at, strong = self.on_screen(self.points[f"handle {handle.name}"], corner, room), handle is near
            draw.add_circle(
                at,
                (0.55 if strong else 0.4) * size,
                style.u32(rgb(theme.foreground), 1.0 if strong else 0.55),
                0,
                2.5 if strong else 1.5,
            )

    def drag(self, mouse: ImVec2, corner: ImVec2, room: ImVec2, values: dict) -> None:
        handle, stage = self.held, self.stage
        assert handle is not None and stage is not None
        specs = self.app.session.current.values
        limits = {n: (specs[n].low, specs[n].high, specs[n].scale == "log") for n in handle.values}

        def seen(at: dict) -> np.ndarray:
            point = self.on_screen(stage.probes(at)[handle.probe, :3], corner, room)
            return np.array([point.x, point.y])

        found = handles.drag(values, handle.values, limits, np.array([mouse.x, mouse.y]), seen)
        self.app.session.change(
            {**self.app.session.values, **{n: found[n] for n in handle.values}}, self.app.session.view
        )
        self.app.ctx.screen.use()

    def pick_at(self, mouse: ImVec2, corner: ImVec2, room: ImVec2, values: dict, view: View, theme: Theme) -> None:
        assert self.stage is not None
        at = (mouse.x - corner.x) / room.x, (mouse.y - corner.y) / room.y
        found = pick(self.stage, values, view.camera(self.stage.scene.camera), theme, at)
        self.app.ctx.screen.use()
        self.picked = (found, mouse) if found else None
        if found and self.stage.scene.brush:
            self.app.brush(angles_of(found.normal, view.camera(self.stage.scene.camera), values))

    def card(self, theme: Theme) -> None:
        """What was picked: raw values, before exposure and display."""
        if not self.picked:
            return
        found, at = self.picked
        imgui.set_next_window_pos(ImVec2(at.x + 14, at.y + 10))
        flags = (
            imgui.WindowFlags_.no_decoration
            | imgui.WindowFlags_.always_auto_resize
            | imgui.WindowFlags_.no_saved_settings
            | imgui.WindowFlags_.no_focus_on_appearing
            | imgui.WindowFlags_.no_nav
        )
        if imgui.begin("picked", None, flags)[0]:
            imgui.text(found.surface + (f", face {found.face}" if self.mesh_is(found.surface) else ""))
            imgui.text_disabled("point   " + "  ".join(three(x) for x in found.position) + " m")
            imgui.text_disabled("colour  " + "  ".join(three(x) for x in found.radiance) + "  (linear)")
        imgui.end()

    def mesh_is(self, name: str) -> bool:
        assert self.stage is not None
        return any(s.mesh and s.name == name for s in self.stage.scene.surfaces)


def wrap(degrees: float) -> float:
    return (degrees + 180) % 360 - 180
