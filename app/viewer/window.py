"""The window: three columns that breathe, a quiet line below, and what lies over them for a moment.

It draws a `Session` and calls it; what can be computed without a window is computed elsewhere.
"""

import os
import time
import webbrowser
from pathlib import Path

from imgui_bundle import ImVec2, hello_imgui, imgui

from app import tables
from app.catalog import BOARD
from app.edit import CODE, EDITED
from app.gpu.context import adopt, step_aside
from app.lesson import Number, Prediction
from app.paths import LESSONS
from app.prediction import truth_values
from app.problem import Problem, Usage
from app.progress import Progress
from app.readouts import Known, numbers
from app.session import Session
from app.theme import THEMES, Theme, rgb
from app.viewer import bar, break_panel, controls, glfw, leave_panel, numbers_panel, overlays, style, text_panel
from app.viewer.badges_panel import BadgesPanel
from app.viewer.belongings import Belongings
from app.viewer.board_panel import BoardPanel
from app.viewer.cover import Cover
from app.viewer.editor_panel import REST, EditorPanel
from app.viewer.exercise_panel import ExercisePanel
from app.viewer.keys import press
from app.viewer.lines_panel import LinesPanel
from app.viewer.plot_panel import PlotPanel
from app.viewer.scene_panel import ScenePanel

FIXED = (
    imgui.WindowFlags_.no_decoration
    | imgui.WindowFlags_.no_move
    | imgui.WindowFlags_.no_saved_settings
    | imgui.WindowFlags_.no_bring_to_front_on_focus
    | imgui.WindowFlags_.no_background  # what is behind them has their colour, and is not drawn twice
)
THEME_ORDER = tuple(THEMES)
LEAST = 960, 540  # pixels: below, the columns would overlap
SAVE_EVERY = 5.0  # seconds


class Window:
    def __init__(
        self,
        start: str = "",
        mesh: str | None = None,
        theme: str = "",
        size: tuple[int, int] = (1280, 720),
        folder: Path = LESSONS,
        ies: str | None = None,
        maps: tuple[str, ...] = (),
    ):
        self.progress = Progress()
        self.session = Session(start, self.progress, folder)
        self.size = size
        kept = self.progress.setting("theme", "dark")
        self.theme: Theme = THEMES[theme or (kept if kept in THEMES else "dark")]
        self.styled: tuple | None = None
        self.show_welcome = not start and mesh is None and ies is None and not maps
        self.show_outline = self.show_help = self.show_notes = False
        self.query = ""
        self.message = self.progress.message or self.session.message
        self.scene, self.plot, self.cover = ScenePanel(self), PlotPanel(self), Cover(self)
        self.badges, self.board = BadgesPanel(self), BoardPanel(self)
        self.own = Belongings(self)
        self.editor, self.lines, self.exercise = EditorPanel(self), LinesPanel(self), ExercisePanel(self)
        self.figures: tuple = (None, [])  # (revision, numbers)
        self.measured: Known = {}  # of this step
        self.typed: tuple = (None, 0)  # the text that runs, the frame it was first drawn in
        self.more = False  # whether the rest of the controls is shown: the picture makes room for them
        self.below: tuple = (None, 0.0)  # what the plot is of, px that the numbers below it take
        self.derived: tuple = (None, {})  # (revision, what follows from the values)
        self.dropped: list[str] = []
        self.saved, self.saved_at = self.session.revision, time.monotonic()
        self.frame = 0
        for path in filter(None, (mesh, ies)):
            self.own.take_file(path)
        self.own.take_maps(maps)
        step_aside()

    # --- the life of the window --------------------------------------------------------------------------------------
    def post_init(self) -> None:
        self.ctx = glfw.create_context()
        adopt(self.ctx)
        self.is_software = "llvmpipe" in self.ctx.info["GL_RENDERER"] or "softpipe" in self.ctx.info["GL_RENDERER"]
        glfw.least_size(*LEAST)
        self.drop_callback = glfw.on_drop(self.dropped.extend)
        imgui.get_io().config_flags |= imgui.ConfigFlags_.nav_enable_keyboard

    def before_exit(self) -> None:
        self.session.end_change()
        self.session.save()
        self.plot.close()
        self.badges.close()
        self.exercise.close()
        if self.scene.stage:
            self.scene.stage.release()
        self.cover.release()
        adopt(None)

    def after_swap(self) -> None:
        """Software GL queues frames it has not drawn yet, and its memory grows with them: wait for each."""
        if self.is_software:
            self.ctx.finish()

    def gui(self) -> None:
        size = imgui.get_main_viewport().size
        if self.styled != (self.theme.name, size.y):
            style.apply(self.theme, size.y)
            self.styled = self.theme.name, size.y
        self.frame += 1
        for path in self.dropped[:1]:
            self.own.take_file(path)
        self.dropped.clear()
        self.plot.take()  # before anything is drawn: a texture is written once that is done
        press(self)
        if self.show_welcome:
            overlays.welcome(self, size)
        else:
            self.lesson(size)
        if self.show_outline:
            overlays.outline(self, size)
        if self.show_help:
            overlays.help_keys(self, size)
        self.pace()

    def pace(self) -> None:
        """Full speed while something moves, else one look a second: an idle window costs next to nothing. A plot that
        comes wakes it."""
        if self.session.revision != self.saved and time.monotonic() - self.saved_at > SAVE_EVERY:
            self.saved, self.saved_at = self.session.revision, time.monotonic()
            self.session.save()  # a crash loses seconds, not a lesson
        if self.editor.typed_at and time.monotonic() - self.editor.typed_at > REST:
            self.editor.typed_at = 0.0
            self.session.save()  # a text is drawn first: one that hangs the graphics is not what the next start opens
        self.exercise.rest()
        idling = hello_imgui.get_runner_params().fps_idling
        idling.enable_idling = not (self.show_welcome or (self.scene.stage and not self.scene.is_settled))
        last = int(os.environ.get("HALFWAY_EXIT_AFTER_FRAMES", "0"))
        if last and self.frame >= last:
            hello_imgui.get_runner_params().app_shall_exit = True

    # --- the lesson --------------------------------------------------------------------------------------------------
    def lesson(self, size: ImVec2) -> None:
        self.exercise.place()
        self.own.place()
        unit = imgui.get_font_size()
        line = round(2.6 * unit)
        left = round(min(max(0.29 * size.x, 22 * unit), 0.34 * size.x))
        right = round(min(max(0.27 * size.x, 19 * unit), 0.31 * size.x))
        if self.on_board and self.theme.name == "projector":  # its numbers say more than its sliders
            left, right = right, left
        text = self.exercise.draw if self.exercise.is_shown else self.editor.draw if self.editor.is_open else None
        if text:
            left = round(min(0.42 * size.x, size.x - right - 17.5 * unit))
        middle, height = size.x - left - right, size.y - line
        self.column("Text", 0, left, height, text or self.text_column)
        self.column("Scene", left, middle, height, self.scene_column)
        self.column("Plot", left + middle, right, height, self.plot_column)
        imgui.set_next_window_pos(ImVec2(0, height))
        imgui.set_next_window_size(ImVec2(size.x, line))
        imgui.push_style_var(imgui.StyleVar_.window_padding, ImVec2(0.9 * unit, 0.35 * unit))
        imgui.begin("Bar", None, FIXED | imgui.WindowFlags_.no_scrollbar)
        imgui.pop_style_var()
        bar.draw(self)
        imgui.end()

    def column(self, name: str, x: float, width: float, height: float, draw) -> None:
        imgui.set_next_window_pos(ImVec2(x, 0))
        imgui.set_next_window_size(ImVec2(width, height))
        imgui.begin(name, None, FIXED & ~imgui.WindowFlags_.no_scrollbar)
        draw()
        imgui.end()

    @property
    def on_board(self) -> bool:
        return self.session.current.id.startswith(BOARD)

    def text_column(self) -> None:
        if self.on_board:
            self.board.draw(self.values)
        else:
            text_panel.draw(self)

    def scene_column(self) -> None:
        room = imgui.get_content_region_avail()
        below = controls.height(self.session.current.below, room.x, self.more)
        picture = ImVec2(room.x, max(room.y - below, 0.35 * room.y))
        if self.own.no_picture:
            imgui.push_style_color(imgui.Col_.child_bg, style.vec(rgb(self.theme.background)))
            imgui.begin_child("fault", picture, imgui.ChildFlags_.always_use_window_padding)
            imgui.dummy(ImVec2(0, 0.3 * picture.y))
            imgui.text_wrapped("This picture cannot be drawn.\n" + self.own.no_picture)
            imgui.end_child()
            imgui.pop_style_color()
        else:
            self.scene.draw(self.values, self.session.view, self.theme, picture)
        self.more = controls.draw(self)

    def plot_column(self) -> None:
        room = imgui.get_content_region_avail()
        of = self.session.current, self.session.visit.plot, self.theme.name, *imgui.get_window_size()
        if self.below[0] != of:
            self.below = of, 0.0
        if EDITED in self.values and not self.plot.follows:
            imgui.text_disabled("This plot is of the course, not of your text.")
        # the width without a scroll bar: else the bar would take room from the plot, go, come back, for ever
        width = imgui.get_window_width() - 2 * imgui.get_style().window_padding.x
        self.plot.draw(self.values, ImVec2(room.x, self.plot.height(room.y, width, self.below[1])))
        imgui.spacing()
        top = imgui.get_cursor_pos_y()
        try:
            if self.on_board:
                self.board.point(self.values)
            if not self.on_board or self.board.tells:
                numbers_panel.draw(self, self.numbers(), self.theme)
            self.badges.draw(self.values)
            leave_panel.draw(self)
        except Problem as problem:
            imgui.text_wrapped(str(problem))
        self.below = of, max(self.below[1], imgui.get_cursor_pos_y() - top, 1.0)

    # --- what is asked of it -----------------------------------------------------------------------------------------
    def do(self, key: str) -> None:
        if key == "o":
            self.show_outline, self.query = not self.show_outline, ""
        elif key == "n":
            self.show_notes = not self.show_notes
        elif key == "r":
            self.session.reset()
        elif key == "c":
            imgui.set_clipboard_text(self.session.state)
            self.message = f"copied: {self.session.state}"
        elif key == "t":
            self.set_theme(THEME_ORDER[(THEME_ORDER.index(self.theme.name) + 1) % len(THEME_ORDER)])
        elif key == "b":
            break_panel.press(self)
        elif key == "f":
            self.session.freeze(not self.session.frozen)
        elif key == "p":
            self.session.show_plot(self.session.visit.plot + 1)
        elif key == "e":
            self.editor.toggle()
        elif key == "x":
            self.exercise.toggle()
        elif key == "?":
            self.show_help = not self.show_help

    def set_theme(self, name: str) -> None:
        self.theme = THEMES[name]
        self.progress.put_setting("theme", name)

    def go(self, state: str) -> None:
        self.message = ""
        try:
            self.session.go(state)
        except Problem as problem:
            self.message = str(problem)

    def move(self, by: int) -> None:
        self.message = ""
        self.session.move(by)
        self.message = self.session.message

    def start(self, first: bool) -> None:
        self.show_welcome = False
        if first:
            self.go(self.session.steps[0].id)

    def reveal(self) -> None:
        self.session.freeze(False)
        found = self.session.current
        truth = found.step.ask.sets.get("shape")
        mesh = self.own.mesh_named(int(truth)) if isinstance(truth, int | float) else self.own.triangles
        data = tables.chosen(found.step.scene, truth_values(found))
        try:
            self.session.reveal(**data, **({} if mesh is None else {"triangles": mesh}))
        except Problem as problem:  # a file of the user's on the board
            self.message = str(problem)

    def set_value(self, name: str, value: Number) -> None:
        try:
            self.session.set(name, value)
        except Usage as problem:
            self.message = str(problem)

    def stand(self, at: dict[str, float]) -> None:
        """To the place that a badge tells of."""
        try:
            self.session.stand(at)
        except Usage as problem:
            self.message = str(problem)

    def brush(self, at: dict[str, float] | None) -> None:
        """Another point is picked: these angles make its normal the picked one."""
        if at is None:
            self.message = "No light reaches that point, so there is nothing to take apart."
        else:
            self.message = ""
            self.stand(at)

    def open_link(self, target: str) -> None:
        """A link of the prose: it sets values, leads to a step, or opens in the browser."""
        try:
            if target.startswith("?"):
                self.session.apply(target)
            elif target.startswith(CODE):
                self.editor.open(target.removeprefix(CODE))
            elif target.startswith(("http://", "https://")):
                webbrowser.open(target)
            else:
                self.session.go(target)
        except Problem as problem:
            self.message = str(problem)

    def first_guess(self, ask: Prediction) -> float:
        return (ask.low * ask.high) ** 0.5 if ask.scale == "log" else 0.5 * (ask.low + ask.high)

    # --- what is shown -----------------------------------------------------------------------------------------------
    @property
    def values(self) -> dict:
        """The step's values; a mesh step's also carry its triangles, those with measured luminaires their tables."""
        key = self.session.current.id, self.session.revision
        if self.derived[0] != key:
            self.derived = key, self.session.current.derived(self.session.values)
        return {**self.session.values, **self.derived[1], **self.own.data, **self.session.edited}

    @property
    def text_is_new(self) -> bool:
        """Whether this frame is the first with a typed text: its picture is shown before anything else follows it."""
        text = self.session.current.id, *self.session.visit.running.items()
        if self.typed[0] != text:
            is_here = self.typed[0] is not None and self.typed[0][0] == text[0]
            self.typed = text, self.frame if is_here else 0
        return self.typed[1] == self.frame

    def numbers(self) -> list:
        key = self.session.current.id, self.session.revision, *map(id, self.own.data.values())
        if self.figures[0] != key and not self.text_is_new:
            if self.figures[0] is None or self.figures[0][0] != self.session.current.id:
                self.measured.clear()
            self.figures = key, numbers(self.session.current.step, self.values, self.ctx, self.measured)
            self.ctx.screen.use()
        return self.figures[1]

    def cover_picture(self, size: ImVec2) -> None:
        self.cover.draw(size)
