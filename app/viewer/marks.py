"""A round mark with a tick, a square one with a cross, or an empty ring: never by colour alone."""

from imgui_bundle import ImVec2, imgui

from app.theme import Theme, colour
from app.viewer import style

TICK = ((-0.45, 0.02, -0.1, 0.4), (-0.16, 0.4, 0.5, -0.4))
CROSS = ((-0.42, -0.42, 0.42, 0.42), (-0.42, 0.42, 0.42, -0.42))


def mark(x: float, y: float, ok: bool | None, theme: Theme, shade: float = 1.0) -> None:
    """At its middle, as high as a line of text; None: not known."""
    size, draw = imgui.get_font_size(), imgui.get_window_draw_list()
    r, wide = 0.46 * size, 0.12 * size
    if ok is None:
        draw.add_circle(ImVec2(x, y), 0.8 * r, style.u32(colour("quiet", theme), shade), 0, 0.6 * wide)
        return
    ground = style.u32(colour("v" if ok else "r", theme), shade)
    if ok:
        draw.add_circle_filled(ImVec2(x, y), r, ground)
    else:
        side = 0.92 * r
        draw.add_rect_filled(ImVec2(x - side, y - side), ImVec2(x + side, y + side), ground, 0.2 * r)
    ink = style.u32((1.0, 1.0, 1.0), shade)
    for x0, y0, x1, y1 in TICK if ok else CROSS:
        draw.add_line(ImVec2(x + x0 * r, y + y0 * r), ImVec2(x + x1 * r, y + y1 * r), ink, wide)


def marked_line(words: str, ok: bool | None, theme: Theme) -> None:
    """A sentence behind its mark; what wraps stays behind it."""
    size, at = imgui.get_font_size(), imgui.get_cursor_screen_pos()
    mark(at.x + 0.5 * size, at.y + 0.5 * imgui.get_text_line_height(), ok, theme)
    imgui.indent(1.35 * size)
    imgui.text_wrapped(words)
    imgui.unindent(1.35 * size)
