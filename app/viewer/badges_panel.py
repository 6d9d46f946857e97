"""Badges below the numbers, a line for each model: what it keeps and what it breaks. A click goes to the worst place.

They are computed in a thread of their own, always for the latest values; what is shown meanwhile is marked as old.
"""

from collections import OrderedDict
from concurrent.futures import Future, ThreadPoolExecutor

from imgui_bundle import ImVec2, imgui

from app.badges import ASKED, NAMES, SHORT, Badge, key, of_model, told
from app.lesson import Model
from app.terms import whose
from app.theme import colour
from app.viewer import glfw, style
from app.viewer.cut import PIECE, wrapped
from app.viewer.marks import mark

SMALL = 0.9  # of the text on a projector, where the column is narrow for it
CUT = 7  # em of a word that is longer, a file's name
KEPT = 64  # results, so that a slider's way back costs nothing


class BadgesPanel:
    def __init__(self, app) -> None:
        self.app = app
        self.thread = ThreadPoolExecutor(1, "badges")
        self.known: OrderedDict[tuple, dict[str, Badge] | str] = OrderedDict()
        self.job: Future | None = None
        self.seen = -1  # the revision of the last look
        self.last: dict[tuple, dict[str, Badge] | str] = {}  # of the model of a step, as it was shown last

    @property
    def waiting(self) -> bool:
        return self.job is not None

    def draw(self, values: dict) -> None:
        found = self.app.session.current
        if not found.step.models:
            return
        self.take()
        hidden = self.app.session.frozen
        if not hidden:
            self.ask(found.step.models, values)
        imgui.spacing()
        large = self.app.theme.name == "projector"
        imgui.push_font(None, (SMALL if large else 1.0) * imgui.get_style().font_size_base)
        (self.beside if fits(found.step.models) else self.stacked)(found.step.models, values, hidden)
        imgui.pop_font()

    def beside(self, models: tuple[Model, ...], values: dict, hidden: bool) -> None:
        """The name in the first column, badges behind it."""
        flags = imgui.TableFlags_.sizing_fixed_fit | imgui.TableFlags_.pad_outer_x
        if not imgui.begin_table("badges", 1 + len(NAMES), flags):
            return
        imgui.table_setup_column("model", imgui.TableColumnFlags_.width_stretch)
        for name in NAMES:
            imgui.table_setup_column(name)
        imgui.table_next_row()
        imgui.table_next_column()
        self.heads()
        for model in models:
            imgui.table_next_row()
            imgui.table_next_column()
            self.name(model, values)
            self.badges(model, values, hidden)
        imgui.end_table()

    def stacked(self, models: tuple[Model, ...], values: dict, hidden: bool) -> None:
        """For large letters in a narrow column: a name on a line of its own, all badges below it, in equal columns."""
        for i, model in enumerate((None, *models)):
            if model:
                self.name(model, values)
            if imgui.begin_table(f"badges {i}", len(NAMES), imgui.TableFlags_.sizing_stretch_prop):
                for name in NAMES:  # as wide as their heads, in every table
                    wide = imgui.calc_text_size(SHORT[name]).x
                    imgui.table_setup_column(name, imgui.TableColumnFlags_.width_stretch, wide)
                imgui.table_next_row()
                if model:
                    self.badges(model, values, hidden)
                else:
                    self.heads()
                imgui.end_table()

    def heads(self) -> None:
        for name in NAMES:
            imgui.table_next_column()
            imgui.text_disabled(SHORT[name])
            if imgui.is_item_hovered():
                imgui.set_tooltip(ASKED[name])

    def name(self, model: Model, values: dict) -> None:
        size, at = imgui.get_font_size(), imgui.get_cursor_screen_pos()
        ink = style.u32(colour(model.colour, self.app.theme))
        imgui.get_window_draw_list().add_circle_filled(ImVec2(at.x + 0.35 * size, at.y + 0.5 * size), 0.28 * size, ink)
        imgui.set_cursor_pos_x(imgui.get_cursor_pos_x() + 0.95 * size)
        owner = whose(model.term, values)
        wrapped(model.label + (f", {owner}" if owner else ""))
        if owner == "measured" and imgui.is_item_hovered():
            imgui.set_tooltip("A measurement is a table, with no text that could be edited: it stays.")

    def badges(self, model: Model, values: dict, hidden: bool) -> None:
        """A cell of the table for each."""
        step, now = self.app.session.current.id, self.known.get(key(model, values))
        if now is not None:
            self.last[step, model.label] = now
        shown = now or self.last.get((step, model.label))
        for name in NAMES:
            imgui.table_next_column()
            badge = shown[name] if isinstance(shown, dict) and not hidden else None
            middle(imgui.calc_text_size(SHORT[name]).x)
            self.badge(f"{model.label}{name}", badge, faded=now is None)
            if not imgui.is_item_hovered() or hidden:
                continue
            if badge is None:
                imgui.set_tooltip(shown if isinstance(shown, str) else "on its way")
            else:
                goes = badge.at.keys() & values.keys()  # a step without these angles has no such place
                imgui.set_tooltip(told(name, badge) + ("\nClick to go there." if goes else ""))

    def badge(self, id: str, badge: Badge | None, faded: bool) -> None:
        """Its mark, that can be clicked."""
        size, at = imgui.get_font_size(), imgui.get_cursor_screen_pos()
        if imgui.invisible_button(id, ImVec2(1.05 * size, 1.05 * size)) and badge is not None and badge.at:
            self.app.stand(badge.at)
        x, y = at.x + 0.5 * size, at.y + 0.5 * size
        mark(x, y, None if badge is None else badge.ok, self.app.theme, 0.45 if faded and badge else 1.0)
        if badge is None:
            return
        if imgui.is_item_hovered() or imgui.is_item_focused():
            ring = style.u32(colour("foreground", self.app.theme))
            imgui.get_window_draw_list().add_circle(ImVec2(x, y), 0.62 * size, ring, 0, 0.06 * size)

    def ask(self, models: tuple[Model, ...], values: dict) -> None:
        """One job at a time, for the first model whose badges are not known. Models of the board are dear, and wait
        until nothing moves."""
        moving, self.seen = self.app.session.revision != self.seen, self.app.session.revision
        of_board = any(":" in model.term.function for model in models)
        if self.job is not None or self.app.text_is_new or (moving and of_board):
            return
        for model in models:
            wanted = key(model, values)
            if wanted not in self.known:
                self.job = self.thread.submit(job, wanted, model, dict(values))
                self.job.add_done_callback(lambda _: glfw.wake())
                return

    def take(self) -> None:
        if self.job is None or not self.job.done():
            return
        done, self.job = self.job, None
        wanted, found = done.result()
        self.known[wanted] = found
        while len(self.known) > KEPT:
            self.known.popitem(last=False)

    def close(self) -> None:
        self.thread.shutdown(wait=True, cancel_futures=True)


def job(wanted: tuple, model: Model, values: dict) -> tuple[tuple, dict[str, Badge] | str]:
    try:
        return wanted, of_model(model, values)
    except Exception as error:  # whatever a twin does, the window goes on
        return wanted, f"{type(error).__name__}: {error}"


def fits(models: tuple[Model, ...]) -> bool:
    """Whether the longest word of the names, or as much of it as is left when it is cut, has room before the badges."""
    room = imgui.get_window_width() - 2 * imgui.get_style().window_padding.x  # whether or not there is a scroll bar
    cells = sum(imgui.calc_text_size(SHORT[name]).x + 2 * imgui.get_style().cell_padding.x for name in NAMES)
    words = [word for model in models for word in PIECE.findall(model.label)]
    longest = min(max(imgui.calc_text_size(word).x for word in words), CUT * imgui.get_font_size())
    return cells + longest + 1.5 * imgui.get_font_size() <= room


def middle(width: float) -> None:
    """The cursor where a badge stands in the middle of this width."""
    imgui.set_cursor_pos_x(imgui.get_cursor_pos_x() + max(0.0, 0.5 * (width - imgui.get_font_size())))
