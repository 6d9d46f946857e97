"""The live numbers beside the scene: value, unit, error against the exact one, and what an estimate costs."""

import math
from collections.abc import Iterable

from imgui_bundle import ImVec2, imgui

from app.readouts import Number
from app.theme import Theme, colour
from app.viewer import style
from app.viewer.cut import wrapped

DOT = {"exact": "exact", "estimate": "estimate", "printed": "printed", "number": "quiet"}
WORDS, ERRORS = 0.3, 0.27  # shares of the line that are theirs at least
DOT_ROOM = 0.95  # em


def draw(app, numbers: list[Number], theme: Theme) -> None:
    flags = imgui.TableFlags_.sizing_fixed_fit | imgui.TableFlags_.pad_outer_x
    any_error = any(number.error_text or number.cost_text for number in numbers)
    if not numbers or not imgui.begin_table("numbers", 2 + any_error, flags):
        return
    fixed = imgui.TableColumnFlags_.width_fixed
    value, error, beside = widths(numbers, imgui.get_content_region_avail().x)
    imgui.table_setup_column("what", imgui.TableColumnFlags_.width_stretch)
    imgui.table_setup_column("value", fixed, value)
    if any_error:
        imgui.table_setup_column("error", fixed, error)
    for number in numbers:
        line(number, theme, app.session.frozen, beside if any_error else None)
    imgui.end_table()


def flow(app, numbers: list[Number], theme: Theme) -> None:
    """Short numbers without errors, as many on a line as it takes."""
    unit = imgui.get_font_size()
    left, room = imgui.get_cursor_pos_x(), imgui.get_content_region_avail().x
    x = 0.0
    for number in numbers:
        text = f"{number.label} = {'?' if app.session.frozen else number.text}"
        wide = imgui.calc_text_size(text).x + (DOT_ROOM + 1) * unit
        if x and x + wide - unit <= room:
            imgui.same_line(left + x)
        else:
            x = 0.0
        dot(number, theme)
        imgui.text(text)
        if imgui.is_item_hovered() and not app.session.frozen:
            imgui.set_tooltip(number.full_text)
        x += wide


def dot(number: Number, theme: Theme) -> None:
    """In the colour of its role, before it."""
    shade, size = colour(DOT[number.role], theme), imgui.get_font_size()
    at = imgui.get_cursor_screen_pos()
    imgui.get_window_draw_list().add_circle_filled(
        ImVec2(at.x + 0.35 * size, at.y + 0.5 * size), 0.28 * size, style.u32(shade)
    )
    imgui.set_cursor_pos_x(imgui.get_cursor_pos_x() + DOT_ROOM * size)


def widths(numbers: list[Number], room: float) -> tuple[float, float, bool]:
    """Of the values and of their errors, so that no unit is torn and the words keep their share; and whether error and
    time have one line. In steps of half an em: digits are not equally wide, and a column that trembles is hard to read.
    """
    step = 0.5 * imgui.get_font_size()
    room -= 6 * imgui.get_style().cell_padding.x + DOT_ROOM * imgui.get_font_size()

    def wide(texts: Iterable[str]) -> float:
        return step * math.ceil(max((imgui.calc_text_size(text).x for text in texts), default=0.0) / step)

    words = max(imgui.calc_text_size(said(one)).x for one in numbers)
    value, error, beside = (wide(texts) for texts in (
        (one.text for one in numbers), (text for one in numbers for text in (one.error_text, one.cost_text)),
        (errors(one, True) for one in numbers)))
    if words + value + beside <= room:
        return value, beside, True
    value = min(value, (1 - WORDS - ERRORS) * room)
    return value, min(error, max(room - value - words, ERRORS * room)), False


def said(number: Number) -> str:
    return number.label + (f", {number.whose}" if number.whose else "")


def errors(number: Number, beside: bool) -> str:
    return ("  " if beside else "\n").join(filter(None, (number.error_text, number.cost_text)))


def line(number: Number, theme: Theme, hidden: bool, beside: bool | None) -> None:
    """Error and time are beside or below each other; None: no number here has any."""
    imgui.table_next_row()
    imgui.table_next_column()
    dot(number, theme)
    wrapped(said(number))
    imgui.table_next_column()
    imgui.text_wrapped("?" if hidden else number.text)
    if imgui.is_item_hovered() and not hidden:
        imgui.set_tooltip(number.full_text)
    if hidden or beside is None:
        return
    imgui.table_next_column()
    imgui.push_style_color(imgui.Col_.text, style.vec(style.ink("printed" if bad(number) else "quiet", theme)))
    imgui.text_wrapped(errors(number, beside))
    imgui.pop_style_color()
    if imgui.is_item_hovered() and number.cost_text:
        imgui.set_tooltip("the error against the exact number, and the time one evaluation took")


def bad(number: Number) -> bool:
    """An error a person would see."""
    return number.error is not None and abs(number.error) > 0.01
