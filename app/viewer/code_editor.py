"""A text of GLSL or Python in the window: highlighted, typed, marked at its faulty lines. Knows nothing of lessons."""

from collections.abc import Callable, Iterable
from typing import Literal

from imgui_bundle import ImVec2, imgui
from imgui_bundle import imgui_color_text_edit as edit

from app.theme import Theme
from app.viewer import style

Language = Literal["glsl", "python"]
Marker = tuple[int, str]  # a line, from 1, and what is wrong there
MARGIN = 8  # letters that line numbers and the scroll bar take
START = edit.TextEditor.DocPos(0, 0)


class CodeEditor:
    """`on_change(text)` is called in the frame in which something was typed; `set` calls nothing."""

    def __init__(self, text: str = "", language: Language = "glsl", on_change: Callable[[str], None] | None = None,
                 read_only: bool = False):
        self.on_change, self.text = on_change, text.rstrip("\n")
        self.markers: tuple[Marker, ...] = ()
        self.theme = ""
        self.widget = edit.TextEditor()
        languages = edit.TextEditor.Language
        self.widget.set_language(languages.python() if language == "python" else languages.glsl())
        self.widget.set_tab_size(4)
        self.widget.set_insert_spaces_on_tabs(True)
        self.widget.set_show_whitespaces_enabled(False)
        self.widget.set_show_scrollbar_mini_map_enabled(False)
        self.widget.set_line_folding_enabled(False)
        self.widget.set_word_wrap_enabled(True)
        self.widget.set_show_line_numbers_enabled(not read_only)
        self.widget.set_read_only_enabled(read_only)
        self.widget.set_text(self.text)

    def set(self, text: str) -> None:
        """Another text in place of this one; Ctrl+Z goes back to what was there."""
        text = text.rstrip("\n")
        if text != self.text:
            last = self.widget.get_line_count() - 1
            end = edit.TextEditor.DocPos(last, len(self.widget.get_line_text(last)))
            self.widget.replace_section_text(START, end, text)
            self.text = text

    def mark(self, markers: Iterable[Marker], theme: Theme) -> None:
        """Lines that are wrong, and why: their numbers are coloured, a tool-tip has the sentence."""
        markers = tuple(markers)
        if markers == self.markers:
            return
        self.markers = markers
        self.widget.clear_markers()
        ink, ground = style.u32(style.ink("r", theme)), style.u32(style.ink("r", theme), 0.22)
        for line, words in markers:
            at = min(max(line, 1), self.widget.get_line_count()) - 1
            self.widget.add_marker(at, ink, ground, words, words)

    def show_line(self, line: int) -> None:
        """The cursor at the start of a line, from 1, and the line in sight."""
        self.widget.set_cursor(edit.TextEditor.DocPos(line - 1, 0))
        self.widget.scroll_to_line(line - 1)

    def focus(self) -> None:
        self.widget.set_focus()

    def height(self, width: float) -> float:
        """What its lines need in a column of this width, and one more to type into."""
        imgui.push_font(style.code_font(), text_size())
        letter, line = imgui.calc_text_size("m").x, imgui.get_text_line_height()
        imgui.pop_font()
        columns = max(int(width / letter) - MARGIN, 8)
        rows = sum(1 + len(text) // columns for text in self.text.split("\n"))
        return (rows + 2) * line

    def draw(self, name: str, size: ImVec2, theme: Theme) -> None:
        if theme.name != self.theme:
            self.theme = theme.name
            dark, light = edit.TextEditor.get_dark_palette(), edit.TextEditor.get_light_palette()
            self.widget.set_palette(dark if theme.name == "dark" else light)
        imgui.push_font(style.code_font(), text_size())
        self.widget.render(name, size, imgui.ChildFlags_.borders, imgui.WindowFlags_.no_move)
        imgui.pop_font()
        if self.widget.is_read_only_enabled():
            return
        now = self.widget.get_text().rstrip("\n")  # it ends the last line too
        if now != self.text:
            self.text = now
            if self.on_change:
                self.on_change(now)


def text_size() -> float:
    """Its letters are narrow: a little larger than the text's, where that is not large already."""
    base = imgui.get_style().font_size_base
    return max(base, min(1.12 * base, 22.0))
