"""The left column of the board: its models with their parameters, what is shown of them, and the picked point."""

from dataclasses import replace

from imgui_bundle import ImVec2, imgui

from app import needs
from app.board import course_model
from app.board.board_step import MOST, BoardStep, Entry, name_of, round_up
from app.board.coated import Coated
from app.board.merl import Merl
from app.board.models import FIT
from app.catalog import BOARD
from app.lesson import Slice
from app.problem import Problem
from app.readouts import Known, Number, numbers
from app.theme import colour
from app.viewer import controls, numbers_panel, style
from app.viewer.cut import cut
from app.viewer.text_panel import heading, question

VIEW = "shows", "board_channel", "stands", "shape", "model", "light", "turned"
FIT_LOBES, CLOSE = "Fit", (0.75, 0.5)  # of the usual space between lines
LONG = 1.3  # of the ring: longer lobes are cut


class BoardPanel:
    def __init__(self, app) -> None:
        self.app = app
        self.figures: tuple[tuple | None, list[Number]] = (None, [])  # (revision, the factors at the picked point)
        self.measured: Known = {}  # of one model
        self.peak: tuple[object, float] = (None, 0.0)

    @property
    def found(self) -> BoardStep:
        found = self.app.session.current
        assert isinstance(found, BoardStep)
        return found

    def draw(self, values: dict) -> None:
        """All of it in sight, so close together: closest on a projector, whose letters are large."""
        spacing, padding = imgui.get_style().item_spacing, imgui.get_style().frame_padding
        close = CLOSE[self.app.theme.name == "projector"]
        imgui.push_style_var(imgui.StyleVar_.item_spacing, ImVec2(spacing.x, close * spacing.y))
        imgui.push_style_var(imgui.StyleVar_.frame_padding, ImVec2(padding.x, close * padding.y))
        self.column(values)
        imgui.pop_style_var(2)

    def column(self, values: dict) -> None:
        heading("The board", 1.35)
        imgui.same_line(0, imgui.get_font_size())
        self.add()
        for i, entry in enumerate(self.found.entries):
            imgui.push_id(entry.word)
            self.row(i, entry)
            imgui.pop_id()
        imgui.separator()
        self.view(values)
        if imgui.tree_node("Ask the class"):
            question(self.app, self.found.step, self.app.theme)
            imgui.tree_pop()
        if imgui.tree_node("What is exact here"):
            imgui.text_wrapped(self.found.step.honesty)
            imgui.tree_pop()

    # --- the models --------------------------------------------------------------------------------------------------
    def row(self, i: int, entry: Entry) -> None:
        """On or off, its name, which folds its parameters away, alone, away; below it the parameters."""
        words = [(one.word, one.on) for one in self.found.entries]
        unit, right = imgui.get_font_size(), imgui.get_cursor_pos_x() + imgui.get_content_region_avail().x
        shade = style.vec(colour(entry.colour, self.app.theme))
        imgui.push_style_color(imgui.Col_.check_mark, shade)
        imgui.begin_disabled(entry.model is None)
        changed, on = imgui.checkbox("##on", entry.on)
        imgui.end_disabled()
        imgui.pop_style_color()
        if changed:
            self.change([(word, on if k == i else was) for k, (word, was) in enumerate(words)])
        imgui.same_line()
        own = [spec for name, spec in self.found.values.items() if entry.on and name.startswith(entry.prefix)]
        room = right - (5.4 * unit if len(words) > 1 else 0) - imgui.get_cursor_pos_x()
        imgui.push_style_color(imgui.Col_.text, style.vec(style.ink(entry.colour, self.app.theme)))
        if own:
            name = cut(entry.label, room - imgui.get_tree_node_to_label_spacing())
            flags = imgui.TreeNodeFlags_.default_open | imgui.TreeNodeFlags_.no_tree_push_on_open
            is_open = imgui.tree_node_ex("parameters", flags | imgui.TreeNodeFlags_.frame_padding, name)
        else:
            is_open = False
            imgui.text(cut(entry.label, room))
        imgui.pop_style_color()
        if imgui.is_item_hovered():
            imgui.set_tooltip(f"{entry.label}\n{entry.word}" if entry.word != entry.label else entry.word)
        if entry.model and len(words) > 1:
            imgui.same_line(right - 4.8 * unit)
            if imgui.small_button("alone"):
                self.change([(word, k == i) for k, (word, _) in enumerate(words)])
        if len(words) > 1:
            imgui.same_line(right - 1.4 * unit)
            if imgui.small_button("×"):
                self.change([pair for k, pair in enumerate(words) if k != i])
        fitted = FIT + entry.word
        if (isinstance(entry.model, Merl) and fitted not in [word for word, _ in words]
                and imgui.small_button("compare with a fitted Cook-Torrance")):
            self.change([*words, (fitted, sum(on for _, on in words) < MOST)])
        if is_open:
            controls.rows(self.app, own)
        if entry.fault:
            imgui.push_style_color(imgui.Col_.text, style.vec(style.ink("r", self.app.theme)))
            imgui.text_wrapped(entry.fault)
            imgui.pop_style_color()

    def change(self, words: list[tuple[str, bool]]) -> None:
        """Other models, or others of them on."""
        if sum(on for _, on in words) > MOST:
            self.app.message = f"The board shows {MOST} models at once; take one off first."
            return
        try:
            self.app.message = ""
            self.app.session.examine(BOARD + name_of(words))
        except Problem as problem:
            self.app.message = str(problem)

    def add(self) -> None:
        here = {entry.word for entry in self.found.entries}
        offered = [name for name in (*course_model.names(), Coated.name) if name not in here]
        imgui.set_next_item_width(-1)
        is_open = imgui.begin_combo("##add", "add a model")
        if imgui.is_item_hovered():
            imgui.set_tooltip("One of the course's; a .brdf file or a measurement (.binary) is dropped on the window.")
        if is_open:
            for name in offered:
                if imgui.selectable(name, False)[0]:
                    words = [(one.word, one.on) for one in self.found.entries]
                    self.change([*words, (name, sum(on for _, on in words) < MOST)])
            imgui.end_combo()

    # --- the picked point --------------------------------------------------------------------------------------------
    def point(self, values: dict) -> None:
        """D, G, F and the denominator of the large ball's model, where a single one has not told them already."""
        if len(self.found.shown) == 1 and self.found.shown[0].factors:
            return
        entry = self.found.shown[int(values["model"])]
        key = self.found.id, entry.word, self.app.session.revision
        if self.figures[0] != key and not self.app.text_is_new:
            if self.figures[0] is None or self.figures[0][:2] != key[:2]:
                self.measured.clear()
            factors = replace(self.found.step, readouts=entry.factors)
            self.figures = key, numbers(factors, values, self.app.ctx, self.measured)
            self.app.ctx.screen.use()
        imgui.text_disabled(entry.label + ("" if entry.factors else " has f only, no D, G and F"))
        numbers_panel.flow(self.app, self.figures[1], self.app.theme)

    @property
    def tells(self) -> bool:
        """Whether f of each model is to be said; on a projector not where the legend of the plot has said it."""
        large, plot = self.app.theme.name == "projector", self.app.session.plot
        return len(self.found.shown) == 1 or not (large and isinstance(plot, Slice))

    # --- what is shown -----------------------------------------------------------------------------------------------
    def view(self, values: dict) -> None:
        specs = self.found.values
        shown = [specs[name] for name in VIEW if name in specs]
        if values["stands"] == 0:
            shown = [spec for spec in shown if spec.name != "shape"]
        shown = [spec for spec in (*shown, specs["lobe_top"]) if self.matters(spec)]
        left, fit = controls.label_width(shown), imgui.calc_text_size(FIT_LOBES).x
        free = fit + 2 * imgui.get_style().frame_padding.x + imgui.get_style().item_inner_spacing.x
        imgui.begin_disabled(self.app.session.frozen)
        for spec in shown:
            controls.row(self.app, spec, left, free if spec.name == "lobe_top" else 1.0)
        imgui.end_disabled()
        imgui.same_line(0, imgui.get_style().item_inner_spacing.x)
        if imgui.button(FIT_LOBES):
            self.app.set_value("lobe_top", min(max(round_up(max(self.longest(), 1e-3)), 1e-3), 1e6))
        if imgui.is_item_hovered():
            imgui.set_tooltip("Let the ring stand for what the longest lobe needs.")
        if self.longest() > LONG * values["lobe_top"] and values["lobe_scale"] != 2:
            controls.badge("longer than they are drawn", style.ink("printed", self.app.theme))

    def matters(self, spec) -> bool:
        return not spec.choices or len(spec.choices) > 1

    def longest(self) -> float:
        values = self.app.values
        key = self.found.id, needs.key(values, self.found.peak_needs)
        if self.peak[0] != key and not (imgui.is_mouse_down(0) or self.app.editor.typed_at):
            try:
                self.peak = key, self.found.peak(values)
            except Problem:  # at these values it has none: the picture and the numbers tell why
                self.peak = key, 0.0
            self.app.ctx.screen.use()
        return self.peak[1]
