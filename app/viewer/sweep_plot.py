"""A small plot through the worst point: the right values and the student's along one argument."""

import math
from typing import TYPE_CHECKING

import numpy as np
from imgui_bundle import ImVec2, imgui

from app.theme import Theme, colour, rgb
from app.viewer import style

if TYPE_CHECKING:
    from app.exercises import Sweep

HIGH = 9.0  # em


def draw(sweep: "Sweep", theme: Theme, width: float) -> None:
    """As wide as the column, with its legend above and the ends of its axes."""
    if sweep.ends is None:
        return
    low, high, log = sweep.ends
    em, line = imgui.get_font_size(), imgui.get_text_line_height()
    legend(theme)
    at, names = imgui.get_cursor_screen_pos(), (short(high), short(low))
    edge = max(imgui.calc_text_size(name).x for name in names) + 0.5 * em
    left, right = at.x + edge, at.x + width - 0.3 * em
    top, bottom = at.y + 0.2 * em, at.y + HIGH * em - 1.3 * line
    draw_list = imgui.get_window_draw_list()
    quiet = style.u32(rgb(theme.quiet))
    draw_list.add_rect_filled(ImVec2(left, top), ImVec2(right, bottom), style.u32(rgb(theme.background)), 3.0)
    draw_list.add_rect(ImVec2(left, top), ImVec2(right, bottom), style.u32(rgb(theme.quiet), 0.6), 3.0)

    def x(values):
        ends = sweep.at[0], sweep.at[-1]
        return left + (right - left) * np.clip(along(values, *ends, sweep.log), 0, 1)

    def y(values):  # what lies outside runs along the frame
        return bottom - (bottom - top) * np.clip(along(values, low, high, log), 0, 1)

    here = float(x(np.asarray(sweep.here)))
    for i in range(int((bottom - top) / (0.5 * em))):
        draw_list.add_line(ImVec2(here, top + 0.5 * i * em), ImVec2(here, top + (0.5 * i + 0.25) * em), quiet, 1.0)
    wide = theme.line
    for values, ink, thick in ((sweep.expected, "exact", wide), (sweep.got, "estimate", 1.6 * wide)):
        xs, ys = x(sweep.at), y(values)
        for piece in pieces(np.isfinite(values)):
            points: list = [ImVec2(float(a), float(b)) for a, b in zip(xs[piece], ys[piece], strict=True)]
            draw_list.add_polyline(points, style.u32(colour(ink, theme)), thick, 0)
    for values, ink in ((sweep.expected, "exact"), (sweep.got, "estimate")):
        at_worst = y(np.interp(sweep.here, sweep.at, values))
        if np.isfinite(at_worst):
            draw_list.add_circle_filled(ImVec2(here, float(at_worst)), 0.22 * em, style.u32(colour(ink, theme)))
    for name, height in zip(names, (top, bottom - line), strict=True):
        draw_list.add_text(ImVec2(left - 0.35 * em - imgui.calc_text_size(name).x, height), quiet, name)
    first, last = short(sweep.at[0]), short(sweep.at[-1])
    label = sweep.label + (" (log)" if sweep.log else "")
    below = bottom + 0.2 * line
    draw_list.add_text(ImVec2(left, below), quiet, first)
    draw_list.add_text(ImVec2(right - imgui.calc_text_size(last).x, below), quiet, last)
    draw_list.add_text(ImVec2(0.5 * (left + right - imgui.calc_text_size(label).x), below), quiet, label)
    imgui.dummy(ImVec2(width, HIGH * em))


def legend(theme: Theme) -> None:
    for i, (words, ink) in enumerate((("right", "exact"), ("yours", "estimate"), ("the worst point", "quiet"))):
        if i:
            imgui.same_line(0, 1.2 * imgui.get_font_size())
        imgui.push_style_color(imgui.Col_.text, style.vec(style.ink(ink, theme)))
        imgui.text({"exact": "— ", "estimate": "— ", "quiet": "¦ "}[ink] + words)
        imgui.pop_style_color()


def along(values, low: float, high: float, log: bool):
    """Where numbers lie between the ends, 0 to 1."""
    with np.errstate(all="ignore"):
        if log:
            return np.log(values / low) / math.log(high / low)
        return (values - low) / (high - low)


def pieces(sound: np.ndarray) -> list[slice]:
    """The runs of True of two or more."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], sound, [False]]).astype(int)))
    return [slice(a, b) for a, b in edges.reshape(-1, 2) if b - a > 1]


def short(value: float) -> str:
    return f"{float(value):.3g}"
