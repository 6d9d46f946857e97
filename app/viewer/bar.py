"""The quiet line below: steps back and on, a message, what has a key."""

from imgui_bundle import imgui

from app.viewer import controls, style
from app.viewer.cut import cut, whole

BUTTONS = (("Outline", "o"), ("Notes", "n"), ("Edit", "e"), ("Exercise", "x"), ("Reset", "r"),
           ("Copy state", "c"), ("Theme", "t"), ("Keys", "?"))


def breaks(app) -> bool:
    """Whether the step can be broken: its own buttons stand below the prose, out of sight where that is long."""
    return bool(app.session.broken or app.session.current.step.breaks)


def draw(app) -> None:
    session, step = app.session, app.session.current
    imgui.begin_disabled(session.place == 0)
    if imgui.button("Previous"):
        app.move(-1)
    imgui.end_disabled()
    imgui.same_line()
    imgui.begin_disabled(session.place == len(session.steps) - 1)
    if imgui.button("Next"):
        app.move(1)
    imgui.end_disabled()
    imgui.same_line()
    buttons = [*([("Put it right" if app.session.broken else "Break it", "b")] if breaks(app) else []),
               *(one for one in BUTTONS if one[1] != "x" or app.exercise.own)]
    padding = 2 * imgui.get_style().frame_padding.x + imgui.get_style().item_spacing.x
    right = imgui.get_window_width() - sum(imgui.calc_text_size(b).x + padding for b, _ in buttons) - 8
    imgui.align_text_to_frame_padding()
    place = (f"step {step.index + 1} of {len(step.chapter.steps)}, {step.step.minutes:g} min" if step.chapter.steps
             else step.chapter.title.lower())
    imgui.text_disabled(cut(place, right - imgui.get_cursor_pos_x() - padding))
    if app.message:
        imgui.same_line()
        shown = cut(app.message, right - imgui.get_cursor_pos_x() - padding)
        controls.badge(shown, style.ink("printed", app.theme))
        if imgui.is_item_clicked():
            app.message = ""
        elif shown != app.message and imgui.is_item_hovered():
            whole(app.message)
    imgui.same_line(right)
    for label, key in buttons:
        if imgui.button(label):
            app.do(key)
        imgui.same_line()
