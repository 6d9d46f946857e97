"""The window of a talk: slide, scene and plot large, words few; the lecturer's window beside it, one process."""

from pathlib import Path

import moderngl
from imgui_bundle import ImVec2, hello_imgui, imgui

from app.cues import Stop
from app.deck import Deck
from app.paths import LESSONS
from app.problem import Problem
from app.session import Session
from app.talk import Talk
from app.theme import THEMES, rgb
from app.viewer import glfw, numbers_panel, overlays, question_band, style
from app.viewer.areas import Rect, areas
from app.viewer.lecturer import Lecturer
from app.viewer.presenter_keys import KEYS, press
from app.viewer.window import FIXED, THEME_ORDER, Window

SMALLEST = 480, 420  # px
ALL_WORDS = 2


class Presenter(Window):
    def __init__(self, stops: tuple[Stop, ...], begin: int = 0, deck: Deck | None = None, theme: str = "projector",
                 size: tuple[int, int] = (1280, 720), folder: Path = LESSONS, on_top: bool = False,
                 half: bool = False, full: bool = False, two: bool = True):
        super().__init__("", theme=theme, size=size, folder=folder)
        self.session = Session("", None, folder)  # a talk is nobody's progress
        self.talk = Talk(self.session, stops, begin)
        self.deck, self.on_top, self.half, self.full = deck, on_top, half, full
        self.show_welcome, self.show_lecturer, self.detail = False, two, 1
        self.lecturer = Lecturer(self)
        self.slide: tuple[tuple, moderngl.Texture] | None = None
        self.rects: dict[str, Rect] = {}  # of the last frame
        self.before: glfw.Rect | None = None  # full screen: where the window was
        self.band = 0.0  # px, the question's height
        self.seen: dict = {}
        self.message = ""

    # --- the life of the window --------------------------------------------------------------------------------------
    def post_init(self) -> None:
        super().post_init()
        io = imgui.get_io()
        io.config_flags &= ~imgui.ConfigFlags_.nav_enable_keyboard  # Space and arrows are the clicker's
        io.config_viewports_no_decoration = io.config_viewports_no_task_bar_icon = False
        self.pane = glfw.library().glfwGetCurrentContext()
        glfw.least_size(*SMALLEST)
        _, (x, y, wide, high) = glfw.screen()
        if self.half and wide:
            glfw.move(self.pane, (x + wide - wide // 2, y, wide // 2, high))
        if self.on_top:
            glfw.on_top(self.pane)
        if self.full:
            self.full_screen()

    def before_exit(self) -> None:
        self.lecturer.release()
        if self.slide:
            self.slide[1].release()
        super().before_exit()
        if self.deck:
            self.deck.close()

    def before_swap(self) -> None:
        self.lecturer.look()

    def full_screen(self) -> None:
        """The whole of the first monitor, or back."""
        monitor, room = glfw.screen()
        if self.before is not None:
            glfw.move(self.pane, self.before)
            self.before = None
        elif monitor:
            self.before = glfw.rect(self.pane)
            glfw.move(self.pane, room, monitor)

    def gui(self) -> None:
        main, io = imgui.get_main_viewport(), imgui.get_io()
        tall = min(main.size.y, 0.62 * main.size.x)  # half a screen has room for smaller words
        if self.styled != (self.theme.name, tall):
            style.apply(self.theme, tall)
            self.styled = self.theme.name, tall
        self.frame += 1
        for path in self.dropped[:1]:
            self.own.take_file(path)
        self.dropped.clear()
        self.plot.take()
        press(self)
        self.talk.tick(min(io.delta_time, 0.1))
        self.watch()
        self.draw(main)
        if self.show_help:
            overlays.help_keys(self, main.size, KEYS)
        if self.show_lecturer:
            self.lecturer.draw()
        self.pace()
        if self.talk.playing:
            hello_imgui.get_runner_params().fps_idling.enable_idling = False

    def watch(self) -> None:
        """Which value a hand moved last: Space moves that."""
        values = dict(self.session.values)
        if not self.talk.playing and self.seen.keys() == values.keys():
            moved = [name for name in values if values[name] != self.seen[name]]
            self.talk.touched = moved[0] if len(moved) == 1 else self.talk.touched
        self.seen = values

    # --- what is asked of it -----------------------------------------------------------------------------------------
    def step(self, by: int) -> None:
        self.message = ""
        try:
            if not self.talk.move(by):
                self.message = "This is the last." if by > 0 else "This is the first."
        except Problem as problem:
            self.message = str(problem)

    def black(self) -> None:
        self.talk.is_black = not self.talk.is_black

    def act(self, name: str) -> None:
        talk = self.talk
        if name == "play":
            talk.play()
        elif name == "ask":
            talk.ask()
        elif name == "reveal" and talk.has_scene:
            if talk.hands is None:
                talk.ask()
            elif not talk.is_told:
                self.reveal()
        elif name == "words":
            self.detail = (self.detail + 1) % (ALL_WORDS + 1)
        elif name == "plot":
            self.session.show_plot(self.session.visit.plot + 1)
        elif name == "reset":
            talk.reset()
        elif name == "lecturer":
            self.show_lecturer = not self.show_lecturer
        elif name == "theme":
            self.theme = THEMES[THEME_ORDER[(THEME_ORDER.index(self.theme.name) + 1) % len(THEME_ORDER)]]
        elif name == "full screen":
            self.full_screen()

    def escape(self) -> None:
        """What lies over the picture goes, one thing at a time; then full screen ends."""
        if self.talk.is_black:
            self.talk.is_black = False
        elif self.show_help or self.message:
            self.show_help, self.message = False, ""
        elif self.talk.hands is not None:
            self.talk.ask()
        elif self.before is not None:
            self.full_screen()

    # --- what the class sees -----------------------------------------------------------------------------------------
    def draw(self, main: imgui.Viewport) -> None:
        if self.talk.is_black:
            corner = ImVec2(main.pos.x + main.size.x, main.pos.y + main.size.y)
            imgui.get_background_draw_list(main).add_rect_filled(main.pos, corner, style.u32((0.0, 0.0, 0.0)))
            return
        if self.talk.has_scene:
            self.own.place()
        unit, wide, high = imgui.get_font_size(), main.size.x, main.size.y
        foot = round(1.9 * unit)
        asked = self.talk.hands is not None
        band = round(min(self.band or 6 * unit, 0.6 * high)) if asked else 0
        page = self.talk.stop.page if self.deck else 0
        aspect = self.deck.aspect(page) if self.deck and page and not asked else 0.0
        room = Rect(0, 0, wide, high - foot - band)
        self.rects = areas(room, aspect, self.talk.has_scene, 0 if asked else self.detail,
                           not asked or self.talk.is_told)
        draws = {"slide": self.slide_area, "scene": self.scene_area, "plot": self.plot_area,
                 "numbers": self.numbers_area, "text": self.text_column}
        for name, rect in self.rects.items():
            self.pane_of(name.capitalize(), rect, draws[name], padded=name != "slide")
        if asked:
            self.pane_of("Question", Rect(0, high - foot - band, wide, band), self.question)
        else:
            self.band = 0.0
        imgui.push_style_var(imgui.StyleVar_.window_padding, ImVec2(0.7 * unit, 0.25 * unit))
        self.pane_of("Foot", Rect(0, high - foot, wide, foot), self.foot)
        imgui.pop_style_var()

    def pane_of(self, name: str, rect: Rect, draw, padded: bool = True) -> None:
        main = imgui.get_main_viewport()
        imgui.set_next_window_viewport(main.id_)
        imgui.set_next_window_pos(ImVec2(main.pos.x + rect.x, main.pos.y + rect.y))
        imgui.set_next_window_size(ImVec2(rect.width, rect.height))
        if not padded:
            imgui.push_style_var(imgui.StyleVar_.window_padding, ImVec2(0, 0))
        imgui.begin(name, None, FIXED & ~imgui.WindowFlags_.no_scrollbar if padded else FIXED)
        if not padded:
            imgui.pop_style_var()
        draw()
        imgui.end()

    def slide_area(self) -> None:
        """The page of the deck, sharp at its size."""
        if not self.deck:
            return
        page, room = self.talk.stop.page, imgui.get_content_region_avail()
        rect = Rect(0, 0, room.x, room.y).within(self.deck.aspect(page))
        wide = max(16, round(rect.width * imgui.get_io().display_framebuffer_scale.x))
        if self.slide is None or self.slide[0] != (page, wide):
            if self.slide:
                self.slide[1].release()
            pixels = self.deck.picture(page, wide)
            self.slide = (page, wide), self.ctx.texture(pixels.shape[1::-1], 3, pixels.tobytes(), alignment=1)
        imgui.set_cursor_pos(ImVec2(rect.x, rect.y))
        imgui.image(imgui.ImTextureRef(self.slide[1].glo), ImVec2(rect.width, rect.height))

    def scene_area(self) -> None:
        if self.detail and not self.talk.hands:
            self.scene_column()
        elif self.own.no_picture:
            imgui.text_wrapped(self.own.no_picture)
        else:
            self.scene.draw(self.values, self.session.view, self.theme, imgui.get_content_region_avail())

    def plot_area(self) -> None:
        self.plot.draw(self.values, imgui.get_content_region_avail())

    def numbers_area(self) -> None:
        try:
            numbers_panel.draw(self, self.numbers(), self.theme)
        except Problem as problem:
            imgui.text_wrapped(str(problem))

    def question(self) -> None:
        question_band.draw(self)
        self.band = imgui.get_cursor_pos_y() + imgui.get_style().window_padding.y

    def foot(self) -> None:
        """What this is, what moves, and how far the talk is."""
        talk, session = self.talk, self.session
        place = f"{talk.place + 1} / {len(talk.stops)}"
        if talk.has_scene:
            imgui.text(session.current.step.title)
            way = talk.sweep()
            if way and (talk.playing or talk.phase):
                imgui.same_line()
                value = session.values[way.spec.name]
                assert not isinstance(value, tuple)
                imgui.text("   " + way.told(float(value)))
        if self.message:
            imgui.same_line()
            imgui.text_disabled("   " + self.message)
        imgui.same_line(imgui.get_window_width() - imgui.calc_text_size(place).x - 0.8 * imgui.get_font_size())
        imgui.push_style_color(imgui.Col_.text, style.vec(rgb(self.theme.quiet)))
        imgui.text(place)
        imgui.pop_style_color()


def prepared(window: Presenter):
    """What the toolkit is told: the window's own, and that there may be several."""
    from app.viewer.parameters import parameters

    params, add_ons = parameters(window)
    params.imgui_window_params.enable_viewports = True
    params.callbacks.before_swap = window.before_swap
    return params, add_ons


def run(window: Presenter) -> int:
    """Open it, with a window more for the lecturer."""
    from app import locale_alias
    from app.viewer.parameters import open_window

    locale_alias.ensure()
    open_window(*prepared(window))
    return 0
