"""Drive the real window without a display: one run of the complete app around a test function."""

import signal
from collections.abc import Callable
from pathlib import Path

from imgui_bundle import hello_imgui, imgui

from app import locale_alias
from app.gpu.context import of_thread
from app.paths import LESSONS
from app.viewer import glfw
from app.viewer.parameters import parameters
from app.viewer.window import Window


def drive(
    test: Callable, start: str = "solid_angle/patch", size: tuple[int, int] = (1280, 720), folder: Path = LESSONS
) -> Window:
    """Open the window at a state, run test(engine, window), close it. A missing item or a failed assert raises."""
    from imgui_bundle.immapp import testing

    locale_alias.ensure()
    window = Window(start, size=size, folder=folder)
    params, add_ons = parameters(window)
    params.fps_idling.vsync_to_monitor = False
    params.callbacks.show_gui = lambda: (window.gui(), jobs_of(window))
    window.jobs = []
    glfw.without_display()
    glfw.without_depth()

    def patiently(engine) -> None:
        """Its watchdog ends a test after a minute, and a walk through the whole course takes longer."""
        io = imgui.test_engine.get_io(hello_imgui.get_imgui_test_engine())
        io.config_watchdog_warning = io.config_watchdog_kill_test = 3600.0
        test(engine, window)

    try:
        testing.run(test_function=patiently, runner_params=params, add_ons_params=add_ons)
    finally:
        ignore_broken_pipes()
        of_thread.cache_clear()  # the null platform has closed the display it shares with the surfaceless context
    return window


def ignore_broken_pipes() -> None:
    """The test engine's crash handler takes a pipe whose reader has gone for a crash; Python's own way is an error."""
    if hasattr(signal, "SIGPIPE"):
        signal.signal(signal.SIGPIPE, signal.SIG_IGN)


def jobs_of(window: Window) -> None:
    ignore_broken_pipes()
    io = imgui.get_io()  # seconds: a busy machine draws few frames between two clicks
    io.mouse_double_click_time, io.mouse_single_click_delay = 2.0, 2.5
    while window.jobs:
        window.jobs.pop(0)()


def on_gl(engine, window: Window, job: Callable):
    """The result of a job done in the window's own thread: the test runs in another, where no context is current."""
    found: list = []
    window.jobs.append(lambda: found.append(job()))
    until(engine, window, lambda: bool(found))
    return found[0]


def frames(engine, count: int = 3) -> None:
    engine.yield_(count)


def until(engine, window, true: Callable[[], bool], frames: int = 2000) -> None:
    """Let the window run until something has happened."""
    import time

    for _ in range(frames):
        if true():
            return
        window.jobs.append(lambda: time.sleep(0.01))  # leave the processor to the plots
        engine.yield_(1)
    raise AssertionError("it did not happen")
