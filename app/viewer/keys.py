"""Everything the window does has a key; see overlays.KEYS."""

from imgui_bundle import imgui

from app.state import FARTHEST, NEAREST, View

LETTERS = {imgui.Key.o: "o", imgui.Key.n: "n", imgui.Key.r: "r", imgui.Key.c: "c", imgui.Key.t: "t", imgui.Key.f: "f",
           imgui.Key.p: "p", imgui.Key.b: "b", imgui.Key.e: "e", imgui.Key.x: "x"}

ARROWS = (  # key, degrees around, degrees up, times the distance
    (imgui.Key.left_arrow, -5.0, 0.0, 1.0), (imgui.Key.right_arrow, 5.0, 0.0, 1.0),
    (imgui.Key.up_arrow, 0.0, 5.0, 1.0), (imgui.Key.down_arrow, 0.0, -5.0, 1.0),
    (imgui.Key.equal, 0.0, 0.0, 0.9), (imgui.Key.keypad_add, 0.0, 0.0, 0.9),
    (imgui.Key.minus, 0.0, 0.0, 1 / 0.9), (imgui.Key.keypad_subtract, 0.0, 0.0, 1 / 0.9),
)


def press(window) -> None:
    io = imgui.get_io()
    if imgui.is_key_pressed(imgui.Key.escape, False):
        if not (window.show_outline or window.show_help):
            window.editor.is_open = window.exercise.is_open = False
        window.show_outline = window.show_help = False
        window.message = ""
        window.scene.picked = None
    elif io.key_ctrl and window.editor.is_open and imgui.is_key_pressed(imgui.Key.r, False):
        window.editor.restore()
    elif io.key_ctrl and window.exercise.is_shown and imgui.is_key_pressed(imgui.Key.r, False):
        window.exercise.restart()
    elif io.want_text_input:
        return
    elif not window.show_welcome:
        (with_control if io.key_ctrl else alone)(window, io.key_shift)


def with_control(window, shift: bool) -> None:
    if imgui.is_key_pressed(imgui.Key.z):
        (window.session.redo if shift else window.session.undo)()
    elif imgui.is_key_pressed(imgui.Key.y):
        window.session.redo()
    elif imgui.is_key_pressed(imgui.Key.f, False):
        window.do("o")


def turned(window) -> bool:
    """Shift and the arrows turn the picture, Shift and + or - zoom."""
    view = window.session.view
    for key, turn, lift, zoom in ARROWS:
        if imgui.is_key_pressed(key):
            lifted = min(max(view.elevation + lift, -89.0), 89.0)
            away = min(max(view.distance * zoom, 2 * NEAREST), FARTHEST)
            window.session.look(View((view.azimuth + turn + 180) % 360 - 180, lifted, away))
            return True
    return False


def alone(window, shift: bool) -> None:
    if shift and turned(window):
        return
    if imgui.is_key_pressed(imgui.Key.page_down):
        window.move(1)
    elif imgui.is_key_pressed(imgui.Key.page_up):
        window.move(-1)
    elif imgui.is_key_pressed(imgui.Key.slash, False):
        window.do("?" if shift else "o")
    else:
        for key, letter in LETTERS.items():
            if imgui.is_key_pressed(key, False):
                window.do(letter)
