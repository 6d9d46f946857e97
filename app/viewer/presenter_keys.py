"""The keys of a talk: those that a clicker sends, and the lecturer's; see KEYS."""

from imgui_bundle import imgui

from app.viewer.keys import turned

KEYS = (
    ("Page Down, Page Up, arrows", "the next stop, the one before, each as it was left; a clicker sends these"),
    ("B or .", "black; again, or the next key of a clicker: the picture"),
    ("Space", "the value moves; again: it stands"),
    ("H", "ask the class: picture and numbers wait; again: the question goes"),
    ("V", "the truth, and the hands beside it"),
    ("W", "words: none, numbers and sliders, all"),
    ("P", "the next plot of a step that has several"),
    ("R", "this stop as its cue says"),
    ("L", "the lecturer's window"),
    ("T", "theme: dark, light, projector"),
    ("F11", "full screen; Esc: back"),
    ("Shift and arrows, + or -", "turn the picture, zoom"),
    ("?", "these keys"),
)
ON = imgui.Key.page_down, imgui.Key.right_arrow, imgui.Key.down_arrow
BACK = imgui.Key.page_up, imgui.Key.left_arrow, imgui.Key.up_arrow
BLACK = imgui.Key.b, imgui.Key.period, imgui.Key.keypad_decimal
OTHERS = {imgui.Key.space: "play", imgui.Key.h: "ask", imgui.Key.v: "reveal", imgui.Key.w: "words", imgui.Key.p: "plot",
          imgui.Key.r: "reset", imgui.Key.l: "lecturer", imgui.Key.t: "theme", imgui.Key.f11: "full screen"}


def press(app) -> None:
    io = imgui.get_io()
    if imgui.is_key_pressed(imgui.Key.escape, False):
        app.escape()
    elif io.want_text_input or io.key_ctrl or io.key_alt or (io.key_shift and turned(app)):
        return
    elif any(imgui.is_key_pressed(key, False) for key in ON):
        app.step(1)
    elif any(imgui.is_key_pressed(key, False) for key in BACK):
        app.step(-1)
    elif any(imgui.is_key_pressed(key, False) for key in BLACK):
        app.talk.is_black = not app.talk.is_black
    elif io.key_shift and imgui.is_key_pressed(imgui.Key.slash, False):
        app.show_help = not app.show_help
    else:
        for key, name in OTHERS.items():
            if imgui.is_key_pressed(key, False):
                app.act(name)
