"""The left column: what the step says, the question it asks first, where it comes from, and the lecturer's notes."""

import re
from functools import lru_cache

from imgui_bundle import imgui, imgui_microtex, rich_md

from app.lesson import Step
from app.prose import FORMULA, for_screen
from app.theme import THEMES, Theme, colour
from app.typed import finer
from app.viewer import break_panel, exercise_panel, style
from app.viewer.cut import folded

MARKDOWN = 16.0  # px: the size at which rich_md loads its fonts


@lru_cache(maxsize=64)
def prose(text: str, theme: str, size: float, width: float) -> str:
    """The prose for a column; a formula on a line of its own that is wider than the column is made smaller."""

    def fitted(match: re.Match) -> str:
        if not match["display"]:
            return match[0]
        needed = imgui_microtex.render(match["display"], size, style=imgui_microtex.TexStyle.display).width + size
        return match[0] if needed <= width else rf"$$\scalebox{{{width / needed:.2f}}}{{{match['display']}}}$$"

    shown = for_screen(text, THEMES[theme])
    return FORMULA.sub(fitted, shown) if imgui_microtex.is_initialized() else shown


def draw(app) -> None:
    found, theme = app.session.current, app.theme
    step = found.step
    heading(f"{found.loaded.number}.{found.index + 1}  {step.title}", 1.35)
    large = theme.name == "projector"  # fewer things, and what a class is asked first
    if app.session.broken:
        break_panel.told(app, app.session.broken)
    elif large:
        question(app, step, theme)
    else:
        imgui.push_style_color(imgui.Col_.text, style.vec(colour("quiet", theme)))
        imgui.text_wrapped(step.idea)
        imgui.pop_style_color()
    imgui.spacing()
    base = imgui.get_style().font_size_base
    text = prose(step.prose, theme.name, base, round(imgui.get_content_region_avail().x))
    imgui.push_font(None, base * base / MARKDOWN)  # it measures a pushed size against the base, and starts from its own
    rich_md.render_raw(text)
    imgui.pop_font()
    imgui.spacing()
    if not large or app.session.broken:
        question(app, step, theme)
        imgui.spacing()
    app.lines.draw()
    break_panel.buttons(app)
    exercise_panel.invitation(app)
    if app.show_notes:
        section("For the lecturer", f"{step.notes.strip()}\n\n{step.minutes:g} minutes.")
    elif imgui.tree_node("Where this comes from"):
        imgui.push_style_color(imgui.Col_.text, style.vec(colour("quiet", theme)))
        imgui.text_wrapped(
            "Slides: " + "; ".join(step.slides) + (" (this step goes beyond them)" if step.beyond else "") + "."
        )
        imgui.text_wrapped("Sources: " + "; ".join(step.sources) + ".")
        imgui.text_wrapped(step.honesty)
        imgui.pop_style_color()
        imgui.tree_pop()


def heading(text: str, size: float) -> None:
    imgui.push_font(None, imgui.get_style().font_size_base * size)
    imgui.text_wrapped(text)
    imgui.pop_font()


def section(title: str, text: str) -> None:
    imgui.separator()
    heading(title, 1.1)
    imgui.text_wrapped(" ".join(text.split()))


def question(app, step: Step, theme: Theme) -> None:
    """Ask before you tell: the question, the guess, then the truth and how far the guess was off."""
    session, ask = app.session, step.ask
    imgui.push_style_color(imgui.Col_.child_bg, style.vec(style.mix(style.rgb(theme.panel), colour("l", theme), 0.09)))
    imgui.begin_child(
        "question", imgui.ImVec2(0, 0), imgui.ChildFlags_.auto_resize_y | imgui.ChildFlags_.always_use_window_padding
    )
    imgui.text_wrapped(ask.question)
    answer = session.answer
    if answer.stage != "revealed":
        guess(app, step)
        imgui.begin_disabled(answer.stage == "asked")
        if imgui.button("Show the truth"):
            app.reveal()
        imgui.end_disabled()
        if answer.stage == "asked":
            imgui.same_line()
            if imgui.button("Let me think" if not session.frozen else "Go on"):
                session.freeze(not session.frozen)
            if imgui.is_item_hovered():
                imgui.set_tooltip("Freeze the picture and hide the numbers until the guess is made.")
    else:
        imgui.push_style_color(imgui.Col_.text, style.vec(style.ink("l", theme)))
        imgui.text_wrapped(session.verdict or "The truth:")
        imgui.pop_style_color()
        imgui.text_wrapped(ask.told)
        if session.visit.running:
            imgui.text_disabled("(told of the course's text, not of yours)")
        if imgui.button("Ask me again"):
            session.ask_again()
    imgui.end_child()
    imgui.pop_style_color()


def guess(app, step: Step) -> None:
    ask, answer = step.ask, app.session.answer
    if ask.choices:
        circle = imgui.get_frame_height() + imgui.get_style().item_inner_spacing.x
        room = imgui.get_content_region_avail().x - circle
        for i, choice in enumerate(ask.choices):
            if imgui.radio_button(folded(choice.text, room), answer.choice == i):
                app.session.guess(i)
        return
    now = answer.guess if answer.guess is not None else app.first_guess(ask)
    flags = imgui.SliderFlags_.always_clamp | (imgui.SliderFlags_.logarithmic if ask.scale == "log" else 0)
    imgui.set_next_item_width(-1)
    changed, new = imgui.slider_float(
        "##guess",
        now,
        ask.low,
        ask.high,
        f"%.{finer(now, 0 if ask.high >= 1e3 else 2 if ask.high > 0.5 else 3)} {ask.unit}",
        flags,
    )
    if changed:
        app.session.guess(min(max(new, ask.low), ask.high))
