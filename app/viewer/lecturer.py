"""The lecturer's own window: notes, the next stop, the clock, what the class sees, and the hands to count."""

import time

import moderngl
import numpy as np
from imgui_bundle import ImVec2, imgui

from app.problem import Usage
from app.viewer import style

SIZE, LETTERS = (1000.0, 680.0), 19.0  # px
LOOK_EVERY = 0.15  # seconds
NAME = "Halfway: the lecturer's window###Lecturer"


class Lecturer:
    def __init__(self, app) -> None:
        self.app = app
        self.begun = time.monotonic()
        self.looked = 0.0
        self.texture: moderngl.Texture | None = None
        self.typed, self.typed_for = "", None
        self.wrong = ""

    def look(self) -> None:
        """Take the class's picture, as it stands in the window before it is shown."""
        if not self.app.show_lecturer or time.monotonic() - self.looked < LOOK_EVERY:
            return
        self.looked = time.monotonic()
        view, scale = imgui.get_main_viewport().size, imgui.get_io().display_framebuffer_scale
        size = int(view.x * scale.x), int(view.y * scale.y)
        pixels = np.frombuffer(self.app.ctx.screen.read(viewport=(0, 0, *size), components=3, alignment=1), np.uint8)
        if self.texture is None or self.texture.size != size:
            self.release()
            self.texture = self.app.ctx.texture(size, 3, alignment=1)
        self.texture.write(pixels.tobytes(), alignment=1)

    def release(self) -> None:
        if self.texture is not None:
            self.texture.release()
            self.texture = None

    def draw(self) -> None:
        app, main = self.app, imgui.get_main_viewport()
        monitors = imgui.get_platform_io().monitors
        edge = max((one.main_pos.x + one.main_size.x for one in monitors), default=1e6) - SIZE[0]
        beside = main.pos.x - SIZE[0] - 20 if main.pos.x > SIZE[0] / 2 else min(main.pos.x + main.size.x + 20, edge)
        at = ImVec2(max(beside, 0.0), main.pos.y)
        if len(monitors) > 1:
            other = monitors[1]
            at = ImVec2(other.work_pos.x + 40, other.work_pos.y + 40)
        kind = imgui.WindowClass()
        kind.viewport_flags_override_set = imgui.ViewportFlags_.no_auto_merge
        kind.viewport_flags_override_clear = imgui.ViewportFlags_.no_decoration | imgui.ViewportFlags_.no_task_bar_icon
        imgui.set_next_window_class(kind)
        imgui.set_next_window_pos(at, imgui.Cond_.appearing)
        imgui.set_next_window_size(ImVec2(*SIZE), imgui.Cond_.appearing)
        imgui.push_font(None, LETTERS)
        flags = imgui.WindowFlags_.no_collapse | imgui.WindowFlags_.no_saved_settings | imgui.WindowFlags_.no_title_bar
        shown, app.show_lecturer = imgui.begin(NAME, True, flags)
        if shown:
            self.clock()
            if imgui.begin_table("lecturer", 2, imgui.TableFlags_.sizing_stretch_prop):
                imgui.table_setup_column("class", 0, 1.0)
                imgui.table_setup_column("notes", 0, 1.0)
                imgui.table_next_row()
                imgui.table_next_column()
                self.view()
                self.hands()
                imgui.table_next_column()
                self.notes()
                imgui.end_table()
        imgui.end()
        imgui.pop_font()

    def clock(self) -> None:
        app, gone = self.app, int(time.monotonic() - self.begun)
        imgui.push_font(None, 1.5 * LETTERS)
        imgui.text(time.strftime("%H:%M"))
        imgui.same_line()
        imgui.text_disabled(f"{gone // 60}:{gone % 60:02d}")
        if imgui.is_item_clicked():
            self.begun = time.monotonic()
        if imgui.is_item_hovered():
            imgui.set_tooltip("since the talk began; a click: from now on")
        imgui.same_line()
        imgui.text(f"   {app.talk.place + 1} of {len(app.talk.stops)}")
        imgui.pop_font()
        for words, does in (("Back", lambda: app.step(-1)), ("On", lambda: app.step(1)), ("Black", app.black),
                            ("Move", app.talk.play), ("Ask", app.talk.ask), ("Words", lambda: app.act("words"))):
            imgui.same_line()
            if imgui.button(words):
                does()

    def view(self) -> None:
        """What the class sees."""
        wide = imgui.get_content_region_avail().x
        if self.texture is not None:
            high = wide * self.texture.height / self.texture.width
            most = 0.5 * imgui.get_window_height()
            wide, high = min(wide, wide * most / high), min(high, most)
            imgui.image(imgui.ImTextureRef(self.texture.glo), ImVec2(wide, high), uv0=ImVec2(0, 1), uv1=ImVec2(1, 0))
        app = self.app
        imgui.text_disabled("black" if app.talk.is_black else "what the class sees")
        following = app.talk.title(app.talk.place + 1)
        imgui.text_wrapped(f"Next: {following}" if following else "This is the last.")

    def notes(self) -> None:
        talk = self.app.talk
        imgui.push_font(None, 1.2 * LETTERS)
        imgui.text_wrapped(talk.title(talk.place))
        imgui.pop_font()
        imgui.spacing()
        imgui.text_wrapped(talk.notes or "No notes for this page.")

    # --- hands -------------------------------------------------------------------------------------------------------
    def hands(self) -> None:
        app, hands = self.app, self.app.talk.hands
        imgui.separator()
        if hands is None:
            if app.talk.has_scene and imgui.button("Ask the class  (H)"):
                app.talk.ask()
            return
        if self.typed_for is not hands:
            self.typed, self.typed_for, self.wrong = " ".join(f"{x:g}" for x in hands.guesses), hands, ""
        if hands.ask.choices:
            for i, choice in enumerate(hands.ask.choices):
                imgui.set_next_item_width(7 * LETTERS)
                changed, count = imgui.input_int(f"##hands{i}", hands.counts[i])
                if changed:
                    hands.count(i, count)
                imgui.same_line()
                imgui.text_wrapped(choice.text)
        else:
            unit = f" ({hands.ask.unit})" if hands.ask.unit else ""
            imgui.text_wrapped(f"The guesses{unit}; 0.5x4 for four hands:")
            imgui.set_next_item_width(-1)
            changed, self.typed = imgui.input_text("##guesses", self.typed)
            if changed:
                self.take(hands)
            if self.wrong:
                imgui.push_style_color(imgui.Col_.text, style.vec(style.ink("r", app.theme)))
                imgui.text_wrapped(self.wrong)
                imgui.pop_style_color()
        imgui.text_disabled(f"{hands.total} hands")
        if imgui.button("The question goes  (H)" if app.talk.is_told else "Show the truth  (V)"):
            app.act("ask" if app.talk.is_told else "reveal")

    def take(self, hands) -> None:
        try:
            hands.take(self.typed)
            self.wrong = ""
        except Usage as problem:
            self.wrong = str(problem)
