"""Our own OpenGL context without a window: one per thread, on an EGL display that nobody else closes.

VTK terminates the display of the first EGL device, pyrender the default one, which moderngl's own backend shares; the
surfaceless one is taken (else the first device's, else moderngl's own). `with context():` makes it current again after
somebody else took the thread. Only GLFW's null platform closes the surfaceless display; the window has its own context,
and tests that open windows ask for a new one afterwards.
"""

import ctypes
import os
import re
import sys
import threading
from functools import cache

import moderngl

from app import loops, shader
from app.problem import Problem

DEVICE, SURFACELESS, OPENGL_API, NONE = 0x313F, 0x31DD, 0x30A2, 0x3038
SURFACE_TYPE, PBUFFER_BIT, RENDERABLE_TYPE, OPENGL_BIT = 0x3033, 0x0001, 0x3040, 0x0008
MAJOR, MINOR, PROFILE_MASK, CORE_PROFILE_BIT = 0x3098, 0x30FB, 0x30FD, 0x0001
DRAW, READ = 0x3059, 0x305A
Pointer = ctypes.c_void_p


class EglContext:
    """What moderngl.create_context(context=...) asks for: EGL without a surface, on the display of a platform."""

    def __init__(self, platform: int) -> None:
        self.egl = egl = ctypes.CDLL("libEGL.so.1")
        for name in ("CurrentContext", "CurrentDisplay", "CurrentSurface", "ProcAddress"):
            getattr(egl, f"eglGet{name}").restype = Pointer
        egl.eglCreateContext.restype = Pointer
        egl.eglGetProcAddress.argtypes = [ctypes.c_char_p]
        entry = self.must(egl.eglGetProcAddress(b"eglGetPlatformDisplayEXT"), "eglGetPlatformDisplayEXT")
        platform_display = ctypes.CFUNCTYPE(Pointer, ctypes.c_uint, Pointer, Pointer)(entry)
        device = self.first_device() if platform == DEVICE else None
        self.display = Pointer(self.must(platform_display(platform, device, None), "eglGetPlatformDisplayEXT"))
        self.must(egl.eglInitialize(self.display, None, None), "eglInitialize")
        self.must(egl.eglBindAPI(OPENGL_API), "eglBindAPI")
        config, count = Pointer(), ctypes.c_int()
        wanted = self.ints(RENDERABLE_TYPE, OPENGL_BIT, SURFACE_TYPE, PBUFFER_BIT, NONE)
        egl.eglChooseConfig(self.display, wanted, ctypes.byref(config), 1, ctypes.byref(count))
        self.must(count.value, "eglChooseConfig")
        version = self.ints(MAJOR, 3, MINOR, 3, PROFILE_MASK, CORE_PROFILE_BIT, NONE)
        self.context = Pointer(self.must(egl.eglCreateContext(self.display, config, None, version), "eglCreateContext"))
        self.outer: list[tuple] = []
        self.make_current()

    def first_device(self) -> int:
        entry = self.must(self.egl.eglGetProcAddress(b"eglQueryDevicesEXT"), "eglQueryDevicesEXT")
        kind = ctypes.CFUNCTYPE(ctypes.c_uint, ctypes.c_int, ctypes.POINTER(Pointer), ctypes.POINTER(ctypes.c_int))
        devices, count = (Pointer * 1)(), ctypes.c_int()
        self.must(kind(entry)(1, devices, ctypes.byref(count)) and count.value, "eglQueryDevicesEXT")
        return int(devices[0] or 0)

    @staticmethod
    def ints(*values: int):
        return (ctypes.c_int * len(values))(*values)

    @staticmethod
    def must(value, what: str):
        if not value:
            raise OSError(f"EGL: {what} failed")
        return value

    def make_current(self) -> None:
        self.must(self.egl.eglMakeCurrent(self.display, None, None, self.context), "eglMakeCurrent")

    def load_opengl_function(self, name: str) -> int:
        return self.egl.eglGetProcAddress(name.encode()) or 0

    load = load_opengl_function

    def let_go(self) -> None:
        self.egl.eglMakeCurrent(self.display, None, None, None)

    def __enter__(self) -> None:
        egl = self.egl
        now = (egl.eglGetCurrentDisplay(), egl.eglGetCurrentSurface(DRAW), egl.eglGetCurrentSurface(READ),
               egl.eglGetCurrentContext())
        self.outer.append(tuple(Pointer(x) for x in now))
        self.make_current()

    def __exit__(self, *exc) -> None:
        display, draw, read, context = self.outer.pop()
        if context:
            self.egl.eglMakeCurrent(display, draw, read, context)

    def release(self) -> None:
        self.egl.eglDestroyContext(self.display, self.context)


def context() -> moderngl.Context:
    """The thread's own context for rendering: a context is current in one thread at a time. A window's is adopted."""
    thread = threading.get_ident()
    return adopted[thread] if thread in adopted else of_thread(thread)


adopted: dict[int, moderngl.Context] = {}  # by thread


def adopt(ctx: moderngl.Context | None) -> None:
    """From now on this thread renders with a window's context; None: with its own again."""
    if ctx is None:
        adopted.pop(threading.get_ident(), None)
    else:
        adopted[threading.get_ident()] = ctx


def step_aside() -> None:
    """Leave nothing of ours current in this thread: a window is about to make a context of its own (GLX refuses one
    where EGL has another)."""
    if made := standing.pop(threading.get_ident(), None):
        made.let_go()


standing: dict[int, EglContext] = {}  # the last one made in a thread


@cache
def of_thread(thread: int) -> moderngl.Context:
    tried = []
    if sys.platform.startswith("linux"):
        os.environ.setdefault("EGL_LOG_LEVEL", "fatal")  # Mesa's own words say less than the sentence below
        for platform in (SURFACELESS, DEVICE, None):  # None: EGL's default display
            try:
                if not platform:
                    return moderngl.create_context(require=330, standalone=True, backend="egl")  # type: ignore[arg-type]
                standing[thread] = EglContext(platform)
                return moderngl.create_context(require=330, context=standing[thread])  # type: ignore[arg-type]
            except Exception as error:  # whatever a driver raises, the next way may work
                tried.append(str(error))
    try:
        return moderngl.create_context(require=330, standalone=True)
    except Exception as error:
        tried.append(str(error))
    raise Problem(f"OpenGL 3.3 without a window could not be started ({'; '.join(dict.fromkeys(tried))}). "
                  "Run `halfway doctor`: it prints the command that mends it.") from None


def kept(ctx: moderngl.Context) -> dict:
    """What a context keeps for its lifetime: programs by their text, and a framebuffer of one pixel."""
    if ctx.extra is None:
        ctx.extra = {}
    return ctx.extra


def pixel(ctx: moderngl.Context) -> moderngl.Framebuffer:
    """One pixel to stand on: a surfaceless context has no framebuffer, and without one nothing is drawn at all."""
    if "pixel" not in kept(ctx):
        kept(ctx)["pixel"] = ctx.simple_framebuffer((1, 1))
    return kept(ctx)["pixel"]


def program(ctx: moderngl.Context, vertex: shader.Assembled, fragment: shader.Assembled | None = None,
            varyings: tuple[str, ...] = (), passing: dict | None = None) -> moderngl.Program:
    """A program from assembled texts; kept by its text, so that the same text is compiled once in a context.

    Of a text that is being edited, the new ones are kept in `passing`, whose owner releases them."""
    programs = kept(ctx)
    key = vertex.text, fragment.text if fragment else "", varyings
    if key not in programs and passing is not None:
        programs = passing
    if key not in programs:
        try:
            programs[key] = ctx.program(vertex_shader=vertex.text, varyings=varyings,
                                         fragment_shader=fragment.text if fragment else None)
        except KeyError:  # moderngl has includes of its own, and sees them in remarks too
            lines = (line for part in (vertex, fragment) if part for line in part.lines if "#include" in line.text)
            at = next(lines)
            raise Problem(f"{at.file}, line {at.number}: an #include stands on a line of its own.") from None
        except moderngl.Error as error:
            raise Problem(compiler_message(str(error), vertex, fragment)) from None
    return programs[key]


def endless(line: int, text: shader.Assembled) -> Problem:
    """What is said of a loop that was left, at a line of the compiled text."""
    return Problem(shader.translate(f"0:{line}: {loops.NEVER}", text))


def compiler_message(message: str, vertex: shader.Assembled, fragment: shader.Assembled | None) -> str:
    """The compiler's words at the file and line a person wrote; what does not link has a file alone."""
    if "Linker" in message:
        files = [line.file for part in (vertex, fragment) if part for line in part.lines]
        own = [file for file in files if "." in file and not file.startswith("glsl/")] or files
        words = "; ".join(re.findall(r"error:\s*(.+?)\.?\s*$", message, re.M)) or " ".join(message.split())
        return (f"{max(set(own), key=own.count)}: it compiles, but does not link ({words}); "
                "a loop that never ends, or a function that has no body, does that.")
    circle = re.search(r"function `\w+ (\w+)\(.*has static recursion", message)
    if circle:
        head = re.compile(rf"^\s*\w+\s+{circle[1]}\s*\([^;]*$|^\s*\w+\s+{circle[1]}\s*\(.*\{{")
        heads = (line for part in (fragment, vertex) if part for line in part.lines if head.match(line.text))
        at = next(heads, None)
        where = f"{at.file}, line {at.number}: " if at else ""
        return f"{where}{circle[1]} calls itself, which GLSL does not allow."
    of_fragment = "fragment_shader" in message and fragment is not None
    lines = shader.translate(message, fragment if of_fragment and fragment else vertex).splitlines()
    more = f"\n(and {len(lines) - 3} more)" if len(lines) > 3 else ""
    return "\n".join(lines[:3]) + more
