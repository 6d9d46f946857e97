"""What the checks say, for a person: what it looks like, each check with its mark, the worst point, a plot."""

import re

from imgui_bundle import ImVec2, imgui

from app.exercises import Verdicts
from app.theme import Theme, colour
from app.viewer import style, sweep_plot
from app.viewer.marks import marked_line

LINE = re.compile(r"line (\d+): (.*)", re.S)
OLD = 0.5  # how much of its ink a verdict keeps once the text has changed


def faults(shown: Verdicts) -> list[tuple[int, str]]:
    """(line, sentence) of what does not run."""
    found = LINE.search(shown.checks[0][1]) if len(shown.checks) == 1 and not shown.checks[0][0] else None
    return [(int(found[1]), found[2])] if found else []


def draw(shown: Verdicts | None, theme: Theme, is_old: bool) -> None:
    """`is_old`: of a text that was typed before this one."""
    if shown is None:
        imgui.text_disabled("checking…")
        return
    imgui.push_style_var(imgui.StyleVar_.alpha, OLD if is_old else 1.0)
    checks = shown.checks
    good = sum(ok for ok, _ in checks)
    headline(shown.ok, "All visible checks hold." if shown.ok else "It does not run." if not shown.finding or
             shown.finding.said else f"{good} of {len(checks)} visible checks hold.", theme)
    if is_old:
        imgui.same_line()
        imgui.text_disabled("checking…")
    for name, hint in shown.suspects:
        suspect(name, hint, theme)
    for ok, words in checks:
        marked_line(words, ok, theme)
    if shown.ok:
        imgui.spacing()
        imgui.text_disabled("There are hidden points too, once it is handed in.")
    if shown.worst:
        worst(*shown.worst)
    if shown.plot:
        imgui.spacing()
        sweep_plot.draw(shown.plot, theme, imgui.get_content_region_avail().x)
    imgui.pop_style_var()


def headline(ok: bool, words: str, theme: Theme) -> None:
    imgui.push_style_color(imgui.Col_.text, style.vec(style.ink("v" if ok else "r", theme)))
    imgui.push_font(None, 1.1 * imgui.get_style().font_size_base)
    imgui.text(words)
    imgui.pop_font()
    imgui.pop_style_color()


def suspect(name: str, hint: str, theme: Theme) -> None:
    """A known misconception: its name and a hint."""
    imgui.push_style_color(imgui.Col_.child_bg, style.vec(style.mix(style.rgb(theme.panel), colour("l", theme), 0.14)))
    imgui.begin_child(name, ImVec2(0, 0), imgui.ChildFlags_.auto_resize_y | imgui.ChildFlags_.always_use_window_padding)
    imgui.text_wrapped(f"It looks like: {name.replace('_', ' ')}")
    imgui.text_wrapped(hint)
    imgui.end_child()
    imgui.pop_style_color()


def worst(place: str, expected: str, got: str) -> None:
    imgui.spacing()
    imgui.text_wrapped(f"The worst point: {place}")
    for words, value in (("expected", expected), ("got", got)):
        imgui.text_disabled(words)
        imgui.same_line(5 * imgui.get_font_size())
        imgui.text_wrapped(value)
