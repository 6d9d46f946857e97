"""Everything the window does has a key; see overlays.KEYS."""

from imgui_bundle import imgui

LETTERS = {imgui.Key.o: "o", imgui.Key.n: "n", imgui.Key.r: "r", imgui.Key.c: "c", imgui.Key.t: "t", imgui.Key.f: "f"}


def press(window) -> None:
    io = imgui.get_io()
    if io.want_text_input:
        return
    if imgui.is_key_pressed(imgui.Key.escape, False):
        window.show_outline = window.show_help = False
        window.message = ""
        window.scene.picked = None
    elif not window.show_welcome:
        (with_control if io.key_ctrl else alone)(window, io.key_shift)


def with_control(window, shift: bool) -> None:
    if imgui.is_key_pressed(imgui.Key.z):
        (window.session.redo if shift else window.session.undo)()
    elif imgui.is_key_pressed(imgui.Key.y):
        window.session.redo()
    elif imgui.is_key_pressed(imgui.Key.f, False):
        window.do("o")


def alone(window, shift: bool) -> None:
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
