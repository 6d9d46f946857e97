"""What `doctor` tries, each part in a child process: `python -m app.probes NAME` prints what it found, as JSON."""

import ctypes
import json
import os
import sys
from pathlib import Path

PLATFORM, NULL_PLATFORM, VISIBLE = 0x00050003, 0x00060005, 0x00020004
MAJOR, MINOR, PROFILE, CORE, FORWARD = 0x00022002, 0x00022003, 0x00022008, 0x00032001, 0x00022006
CREATION_API, EGL_API = 0x0002200B, 0x00036002
VENDOR, RENDERER, VERSION = 0x1F00, 0x1F01, 0x1F02


class NoPicture(Exception):
    """The part runs, but what it draws is not a picture."""


def must_show(picture, what: str) -> None:
    if picture.max() == picture.min():
        raise NoPicture(f"{what} draws one flat colour only")


def headless() -> dict:
    """OpenGL 3.3 without a window: clear a corner of a picture, read it back."""
    import numpy as np

    from app.gpu.context import context

    ctx = context()
    target = ctx.simple_framebuffer((8, 8))
    target.use()
    target.clear(0.0, 0.0, 0.0)
    target.clear(1.0, 0.5, 0.0, viewport=(0, 0, 4, 4))
    must_show(np.frombuffer(target.read(), np.uint8), "OpenGL without a window")
    return {"graphics": {"vendor": ctx.info["GL_VENDOR"], "renderer": ctx.info["GL_RENDERER"],
                         "version": ctx.info["GL_VERSION"]}}


def window() -> dict:
    """A hidden window of the library the viewer uses; without a display the same on a platform that shows nothing."""
    import imgui_bundle  # noqa: TID251 - for the GLFW inside it

    name = {"darwin": "libglfw.3.dylib", "win32": "glfw3.dll"}.get(sys.platform, "libglfw.so.3")
    glfw = ctypes.CDLL(str(Path(imgui_bundle.__file__).parent / name))
    display = not sys.platform.startswith("linux") or bool(os.environ.get("DISPLAY"))
    wayland = not display and bool(os.environ.get("WAYLAND_DISPLAY"))  # this GLFW speaks X11 only
    return {"display": display, "wayland": wayland, "graphics": open_window(glfw, display)}


def open_window(glfw: ctypes.CDLL, display: bool) -> dict[str, str]:
    glfw.glfwCreateWindow.restype = glfw.glfwGetProcAddress.restype = ctypes.c_void_p
    glfw.glfwGetProcAddress.argtypes = [ctypes.c_char_p]
    glfw.glfwMakeContextCurrent.argtypes = [ctypes.c_void_p]
    if not display:
        glfw.glfwInitHint(PLATFORM, NULL_PLATFORM)
    if not glfw.glfwInit():
        raise OSError(last_error(glfw))
    hints = {VISIBLE: 0, MAJOR: 3, MINOR: 3, PROFILE: CORE, FORWARD: 1} | ({} if display else {CREATION_API: EGL_API})
    for hint, value in hints.items():
        glfw.glfwWindowHint(hint, value)
    handle = glfw.glfwCreateWindow(64, 64, b"Halfway", None, None)
    if not handle:
        raise OSError(last_error(glfw))
    glfw.glfwMakeContextCurrent(handle)
    get_string = ctypes.CFUNCTYPE(ctypes.c_char_p, ctypes.c_uint)(glfw.glfwGetProcAddress(b"glGetString"))
    words = {"vendor": VENDOR, "renderer": RENDERER, "version": VERSION}
    return {word: (get_string(number) or b"").decode(errors="replace") for word, number in words.items()}


def last_error(glfw: ctypes.CDLL) -> str:
    words = ctypes.c_char_p()
    glfw.glfwGetError(ctypes.byref(words))
    return (words.value or b"no window").decode(errors="replace")


def plots() -> dict:
    """A picture by pyvista."""
    if sys.platform.startswith("linux"):
        os.environ["VTK_DEFAULT_OPENGL_WINDOW"] = "vtkEGLRenderWindow"
    import pyvista  # noqa: TID251 - the doctor looks at every part

    plotter = pyvista.Plotter(off_screen=True, window_size=[64, 64])
    plotter.add_mesh(pyvista.Sphere(), color="white")
    must_show(plotter.screenshot(return_img=True), "pyvista")
    return {}


def latex() -> dict:
    """A formula with letters and operators, drawn."""
    from app import locale_alias

    outcome = locale_alias.ensure()
    if not locale_alias.draws(r"f_r = \frac{D\,G\,F}{4\,(n \cdot l)(n \cdot v)}"):
        raise NoPicture(f"formulas are not drawn (the locale {locale_alias.NEEDED} is {outcome})")
    return {"locale": outcome}


def reference() -> dict:
    """A picture by pyrender, in its own process."""
    from app import meshes
    from app.reference import Shot, render

    picture, = render(Shot(meshes.built_in("cube").triangles, size=(64, 64)), timeout=25.0)
    must_show(picture.rgb, "pyrender")
    return {}


def grading() -> dict:
    """How well a stranger's homework is isolated: found by trying to break out."""
    from app.grade import level

    found = level.found()
    return {"level": found.name, "meaning": level.MEANING[found.name], "safe": found.safe, "why": found.why}


PROBES = {probe.__name__: probe for probe in (headless, window, plots, latex, reference, grading)}


def main(name: str) -> None:
    """The answer as the last line of standard output, then out past the clean-up of drivers, which may crash."""
    out = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    try:
        answer = PROBES[name]()
    except Exception as error:
        answer = {"error": " ".join(str(error).split()) or type(error).__name__,
                  "kind": type(error).__name__, "package": getattr(error, "name", None) or ""}
    out.write(json.dumps(answer))
    out.close()
    os._exit(0)


if __name__ == "__main__":
    main(sys.argv[1])
