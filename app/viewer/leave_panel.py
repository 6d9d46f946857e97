"""What the scene does without at these values, the error that costs, and a button for who wants it otherwise."""

from imgui_bundle import imgui

from app.leaving import Decision
from app.theme import colour
from app.viewer import style


def draw(app) -> None:
    if not app.own.decided or app.session.frozen:
        return
    imgui.spacing()
    imgui.text_disabled("Left out, or not")
    for one in app.own.decided:
        line(app, one)


def line(app, one: Decision) -> None:
    ink = "printed" if one.is_out and one.error > one.of.limit else "quiet"
    imgui.push_style_color(imgui.Col_.text, style.vec(style.ink(ink, app.theme) if ink == "printed" else
                                                      colour(ink, app.theme)))
    imgui.text_wrapped(one.words)
    imgui.pop_style_color()
    if imgui.small_button(f"{'keep it' if one.is_out else 'leave it out'}##{one.of.label}"):
        app.session.decide(one.of.label, not one.is_out)
    if one.by_hand:
        imgui.same_line()
        if imgui.small_button(f"let the scene decide##{one.of.label}"):
            app.session.decide(one.of.label, None)
