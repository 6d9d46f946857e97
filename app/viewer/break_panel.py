"""The button that breaks a step: naive forms where they fail, what a class should remember, and the way back."""

from imgui_bundle import imgui

from app.lesson import Break
from app.problem import Usage
from app.theme import colour
from app.viewer import style


def buttons(app) -> None:
    """A button for each break, below the prose of a sound step."""
    if app.session.broken is None:
        for i, one in enumerate(app.session.current.step.breaks):
            if imgui.button(f"Break it: {one.label}"):
                press(app, i)
            if imgui.is_item_hovered():
                imgui.set_tooltip(f"Draws this step with {', '.join(one.functions.values())} where it fails  (B)")


def told(app, broken: Break) -> None:
    """At the head of a broken step: what one sees, and the way back."""
    ground = style.mix(style.rgb(app.theme.panel), colour("printed", app.theme), 0.16)
    imgui.push_style_color(imgui.Col_.child_bg, style.vec(ground))
    imgui.begin_child(
        "broken", imgui.ImVec2(0, 0), imgui.ChildFlags_.auto_resize_y | imgui.ChildFlags_.always_use_window_padding
    )
    imgui.push_style_color(imgui.Col_.text, style.vec(style.ink("printed", app.theme)))
    imgui.text_wrapped(f"Broken: {broken.label}")
    imgui.pop_style_color()
    imgui.text_wrapped(broken.told)
    if imgui.button("Put it right"):
        app.session.mend()
    imgui.end_child()
    imgui.pop_style_color()


def press(app, which: int = 0) -> None:
    """Break it, or put it right."""
    try:
        app.session.break_it(which if app.session.sound is None else app.session.sound[2])
    except Usage as problem:
        app.message = str(problem)
