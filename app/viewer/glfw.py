"""The GLFW library inside imgui-bundle: its null platform, our moderngl context over its window, files dropped on it.

Two copies of GLFW in one process would not share windows, so nothing here may come from another package.
"""

import ctypes
import os
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path

import imgui_bundle
import moderngl

from app.problem import Problem

PLATFORM, PLATFORM_NULL = 0x00050003, 0x00060005
DEPTH_BITS, STENCIL_BITS = 0x00021005, 0x00021006
CONTEXT_CREATION_API, EGL_CONTEXT_API = 0x0002200B, 0x00036002
FLOATING, YES = 0x00020007, 1
Pointer = ctypes.c_void_p
Rect = tuple[int, int, int, int]  # x, y, width, height
DropCallback = ctypes.CFUNCTYPE(None, Pointer, ctypes.c_int, ctypes.POINTER(ctypes.c_char_p))


@cache
def library() -> ctypes.CDLL:
    name = {"darwin": "libglfw.3.dylib", "win32": "glfw3.dll"}.get(sys.platform, "libglfw.so.3")
    lib = ctypes.CDLL(str(Path(imgui_bundle.__file__).parent / name))
    for function in ("glfwGetProcAddress", "glfwGetCurrentContext", "glfwSetDropCallback"):
        getattr(lib, function).restype = Pointer
    lib.glfwGetProcAddress.argtypes = [ctypes.c_char_p]
    lib.glfwMakeContextCurrent.argtypes = [Pointer]
    lib.glfwSetWindowSizeLimits.argtypes = [Pointer, *[ctypes.c_int] * 4]
    lib.glfwSetDropCallback.argtypes = [Pointer, DropCallback]
    return lib


def has_display() -> bool:
    """Whether a window can open here: GLFW starts on the display there is (this GLFW speaks X11, no Wayland)."""
    if sys.platform.startswith("linux") and not os.environ.get("DISPLAY"):
        return False
    return bool(library().glfwInit())


def without_display() -> None:
    """Let the next window open on GLFW's null platform with EGL; call before every run: its end forgets this."""
    lib = library()
    lib.glfwInitHint(PLATFORM, PLATFORM_NULL)
    if not lib.glfwInit():
        raise Problem("GLFW did not start on its null platform; run `halfway doctor`.")
    lib.glfwWindowHint(CONTEXT_CREATION_API, EGL_CONTEXT_API)


def without_depth() -> None:
    """The interface needs no depth and no stencil buffer; scenes have their own."""
    library().glfwWindowHint(DEPTH_BITS, 0)
    library().glfwWindowHint(STENCIL_BITS, 0)


class VideoMode(ctypes.Structure):
    _fields_ = [(name, ctypes.c_int) for name in ("width", "height", "red", "green", "blue", "rate")]


def screen() -> tuple[int | None, Rect]:
    """The first monitor, and its rectangle; without one (the null platform) none."""
    lib = library()
    lib.glfwGetPrimaryMonitor.restype = Pointer
    lib.glfwGetVideoMode.restype, lib.glfwGetVideoMode.argtypes = ctypes.POINTER(VideoMode), [Pointer]
    monitor = lib.glfwGetPrimaryMonitor()
    mode = lib.glfwGetVideoMode(monitor) if monitor else None
    return (monitor, (0, 0, mode[0].width, mode[0].height)) if mode else (None, (0, 0, 0, 0))


def rect(window) -> Rect:
    lib, found = library(), [ctypes.c_int() for _ in range(4)]
    for name, pair in (("glfwGetWindowPos", found[:2]), ("glfwGetWindowSize", found[2:])):
        getattr(lib, name).argtypes = [Pointer, *[ctypes.POINTER(ctypes.c_int)] * 2]
        getattr(lib, name)(window, *map(ctypes.byref, pair))
    return tuple(one.value for one in found)  # type: ignore[return-value]


def move(window, to: Rect, monitor: int | None = None) -> None:
    """The window to this rectangle, or to fill this monitor."""
    lib = library()
    lib.glfwSetWindowMonitor.argtypes = [Pointer, Pointer, *[ctypes.c_int] * 5]
    lib.glfwSetWindowMonitor(window, monitor, *to, -1)


def on_top(window) -> None:
    """Above the other programs' windows."""
    library().glfwSetWindowAttrib.argtypes = [Pointer, ctypes.c_int, ctypes.c_int]
    library().glfwSetWindowAttrib(window, FLOATING, YES)


class WindowContext:
    """What moderngl.create_context(context=...) asks for, over the window that is current (GLX, EGL, WGL, NSGL)."""

    def __init__(self) -> None:
        self.window = library().glfwGetCurrentContext()
        self.outer: list = []
        if not self.window:
            raise Problem("no window is current: the context is made in post_init.")

    def load_opengl_function(self, name: str) -> int:
        return library().glfwGetProcAddress(name.encode()) or 0

    load = load_opengl_function

    def __enter__(self) -> None:
        # GLFW remembers what it made current last, so the window's own context is found without a call to GL
        outer = library().glfwGetCurrentContext()
        self.outer.append(outer)
        if outer != self.window:
            library().glfwMakeContextCurrent(self.window)

    def __exit__(self, *exc) -> None:
        outer = self.outer.pop()
        if outer and outer != self.window:
            library().glfwMakeContextCurrent(outer)

    def release(self) -> None:
        """The window owns its context."""


def create_context() -> moderngl.Context:
    return moderngl.create_context(require=330, context=WindowContext())  # type: ignore[arg-type]


def least_size(width: int, height: int) -> None:
    """The current window gets no smaller than its columns need. (GLFW's null platform takes the least for the size.)"""
    if has_display():
        library().glfwSetWindowSizeLimits(library().glfwGetCurrentContext(), width, height, -1, -1)


def on_drop(take: Callable[[list[str]], None]) -> object:
    """Call `take` with the paths of files dropped on the current window; keep the returned object alive."""

    def dropped(window, count, paths) -> None:
        take([os.fsdecode(paths[i]) for i in range(count)])

    callback = DropCallback(dropped)
    library().glfwSetDropCallback(library().glfwGetCurrentContext(), callback)
    return callback


def wake() -> None:
    """End the wait for events, from any thread."""
    library().glfwPostEmptyEvent()


def finish() -> None:
    """glFinish of the current context: a frame rate without it means nothing on the null platform."""
    ctypes.CFUNCTYPE(None)(library().glfwGetProcAddress(b"glFinish"))()
