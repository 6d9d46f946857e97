"""The live numbers beside the scene: value, unit, error against the exact one, and what an estimate costs."""

from imgui_bundle import ImVec2, imgui

from app.readouts import Number
from app.theme import Theme, colour
from app.viewer import style
from app.viewer.cut import wrapped

DOT = {"exact": "exact", "estimate": "estimate", "printed": "printed", "number": "quiet"}


def draw(app, numbers: list[Number], theme: Theme) -> None:
    flags = imgui.TableFlags_.sizing_stretch_prop | imgui.TableFlags_.pad_outer_x
    errors = any(number.error_text or number.cost_text for number in numbers)
    if not imgui.begin_table("numbers", 2 + errors, flags):
        return
    imgui.table_setup_column("what", 0, 1.35)
    imgui.table_setup_column("value", 0, 1.0)
    if errors:
        imgui.table_setup_column("error", 0, 1.0)
    for number in numbers:
        line(number, theme, app.session.frozen, errors)
    imgui.end_table()


def line(number: Number, theme: Theme, hidden: bool, errors: bool) -> None:
    imgui.table_next_row()
    imgui.table_next_column()
    shade, size = colour(DOT[number.role], theme), imgui.get_font_size()
    at = imgui.get_cursor_screen_pos()
    imgui.get_window_draw_list().add_circle_filled(
        ImVec2(at.x + 0.35 * size, at.y + 0.5 * size), 0.28 * size, style.u32(shade)
    )
    imgui.set_cursor_pos_x(imgui.get_cursor_pos_x() + 0.95 * size)
    wrapped(number.label + (f", {number.whose}" if number.whose else ""))
    imgui.table_next_column()
    imgui.text_wrapped("?" if hidden else number.text)
    if imgui.is_item_hovered() and not hidden:
        imgui.set_tooltip(number.full_text)
    if hidden or not errors:
        return
    imgui.table_next_column()
    imgui.push_style_color(imgui.Col_.text, style.vec(style.ink("printed" if bad(number) else "quiet", theme)))
    imgui.text_wrapped("\n".join(filter(None, (number.error_text, number.cost_text))))
    imgui.pop_style_color()
    if imgui.is_item_hovered() and number.cost_text:
        imgui.set_tooltip("the error against the exact number, and the time one evaluation took")


def bad(number: Number) -> bool:
    """An error a person would see."""
    return number.error is not None and abs(number.error) > 0.01
