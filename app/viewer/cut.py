"""Words that have no room: cut with dots, and a tool-tip has all of them."""

from collections.abc import Callable

from imgui_bundle import imgui


def cut(text: str, room: float, width: Callable[[str], float] = lambda text: imgui.calc_text_size(text).x) -> str:
    """As much of the first line as the room takes, with dots where something is left out."""
    line = text.partition("\n")[0]
    if line == text and width(text) <= room:
        return text
    while line and width(line + "…") > room:
        line = line[:-1]
    return line.rstrip() + "…"


def whole(text: str) -> None:
    """All of a text that was cut, in a tool-tip above the line."""
    imgui.begin_tooltip()
    imgui.push_text_wrap_pos(34 * imgui.get_font_size())
    imgui.text(text)
    imgui.pop_text_wrap_pos()
    imgui.end_tooltip()


def wrapped(text: str) -> None:
    """Text that breaks between words only: a single one that is too long for a line, a file's name, is cut."""
    room = imgui.get_content_region_avail().x
    short = " ".join(cut(word, room) for word in text.split(" "))
    imgui.text_wrapped(short)
    if short != text and imgui.is_item_hovered():
        whole(text)


def on_a_line(text: str, room: float, tip: str = "") -> None:
    """Text on one line of this width, with a tip where there is one or where it was cut."""
    short = cut(text, room)
    imgui.text(short)
    if (tip or short != text) and imgui.is_item_hovered():
        whole(text if not tip or tip == text else f"{text}\n{tip}")
