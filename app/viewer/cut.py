"""Words that have no room: cut with dots, and a tool-tip has all of them."""

import re
from collections.abc import Callable

from imgui_bundle import imgui

PIECE = re.compile(r"[^\s_-]*[_-]+|[^\s_-]+\s*|\s+")  # of a text that may be broken behind each


def cut(text: str, room: float, width: Callable[[str], float] = lambda text: imgui.calc_text_size(text).x) -> str:
    """As much of the first line as the room takes, with dots where something is left out."""
    line = text.partition("\n")[0]
    if line == text and width(text) <= room:
        return text
    while line and width(line + "…") > room:
        line = line[:-1]
    return line.rstrip() + "…"


def folded(text: str, room: float, width: Callable[[str], float] = lambda text: imgui.calc_text_size(text).x) -> str:
    """All of a text, on as many lines as the room takes, broken between words, behind hyphens and in names_of_files; a
    piece that is too long for a line by itself is cut."""
    lines = [""]
    for piece in PIECE.findall(text):
        if lines[-1] and width((lines[-1] + piece).rstrip()) > room:
            lines.append("")
        lines[-1] += piece
    return "\n".join(cut(line.rstrip(), room, width) for line in lines)


def whole(text: str) -> None:
    """All of a text that was cut, in a tool-tip above the line."""
    imgui.begin_tooltip()
    imgui.push_text_wrap_pos(34 * imgui.get_font_size())
    imgui.text(text)
    imgui.pop_text_wrap_pos()
    imgui.end_tooltip()


def wrapped(text: str) -> None:
    """Text on as many lines as its room takes."""
    short = folded(text, imgui.get_content_region_avail().x)
    imgui.text(short)
    if "…" in short and imgui.is_item_hovered():
        whole(text)


def on_a_line(text: str, room: float, tip: str = "") -> None:
    """Text on one line of this width, with a tip where there is one or where it was cut."""
    short = cut(text, room)
    imgui.text(short)
    if (tip or short != text) and imgui.is_item_hovered():
        whole(text if not tip or tip == text else f"{text}\n{tip}")
