"""pyvista in a process of its own: the window's thread never waits and never loads VTK.

A thread writes the latest wish to the child, reads its picture, and calls `on_picture`. Plain pipes instead of
multiprocessing: nothing imports the main module a second time (for `halfway`, pytest or a lecturer's script that has
no guard), no shared memory can be left behind, no size has to be agreed on, and a picture of 420x420 takes 0.3 ms.
"""

import os
import subprocess
import sys
import tempfile
import threading
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Any, BinaryIO, cast

import numpy as np

from app.lesson import Camera, Plot
from app.needs import only, plotted
from app.paths import ROOT
from app.plots.wire import Spot, receive, send
from app.problem import Problem
from app.theme import Theme

NICE = 5  # a window's picture goes before its plots, where both want the same core
LOW = getattr(subprocess, "BELOW_NORMAL_PRIORITY_CLASS", 0)  # the same on Windows


class PlotDied(Problem):
    """The plots' process has ended by itself."""


@dataclass(frozen=True, eq=False)
class Wish:
    plot: Plot
    values: dict
    size: tuple[int, int]
    theme: Theme
    ranges: dict = field(default_factory=dict)
    camera: Camera | None = None
    triangles: np.ndarray | None = None
    fine: bool = True
    fresh: bool = False  # a frame of its own, whatever was drawn before
    number: int = 0
    mesh_changed: bool = True  # set on the way: a mesh travels once


@dataclass(frozen=True, eq=False)
class Picture:
    image: np.ndarray  # (height, width, 3) uint8
    wish: Wish  # what it shows
    error: str = ""  # why the drawing failed; the image says it too
    spots: tuple[Spot, ...] = ()


class PlotProcess:
    """request() and poll() return at once. `on_picture` is called from a thread when a poll will bring something."""

    def __init__(self, size: tuple[int, int] | None = None, theme: Theme | None = None,
                 on_picture: Callable[[], None] | None = None):
        self.size, self.theme, self.on_picture = size, theme, on_picture
        self.lock = threading.Condition()
        self.count = 0
        self.last: Wish | None = None  # the latest wish
        self.closed = False
        self.start()

    def start(self) -> None:
        paths = [str(ROOT), *filter(None, [os.environ.get("PYTHONPATH")])]
        self.words = tempfile.TemporaryFile()  # noqa: SIM115  the child's last words, closed with it
        self.child = subprocess.Popen([sys.executable, "-P", "-m", "app.plots.child"], stdin=subprocess.PIPE,
                                      stdout=subprocess.PIPE, stderr=self.words,
                                      creationflags=LOW if self.on_picture else 0,
                                      env={**os.environ, "PYTHONPATH": os.pathsep.join(paths)})
        if self.on_picture and hasattr(os, "setpriority"):
            os.setpriority(os.PRIO_PROCESS, self.child.pid, os.getpriority(os.PRIO_PROCESS, 0) + NICE)
        self.wish: Wish | None = None  # the one to be drawn next
        self.busy = False
        self.picture: Picture | None = None
        self.dead = ""
        self.thread = threading.Thread(target=self.serve, name="plots", daemon=True, args=(self.child,))
        self.thread.start()

    def request(self, plot: Plot, values: dict, ranges: dict | None = None, camera: Camera | None = None,
                size: tuple[int, int] | None = None, theme: Theme | None = None, triangles: np.ndarray | None = None,
                fine: bool = True, fresh: bool = False) -> int:
        """Wish for a picture; a wish not yet begun is forgotten. Returns the wish's number. `triangles` must not be
        written to afterwards: a mesh is known by the object it is."""
        self.size, self.theme = size or self.size, theme or self.theme
        if self.size is None or self.theme is None:
            raise ValueError("a plot needs a size and a theme, here or when its process is started")
        self.count += 1
        size = int(self.size[0]), int(self.size[1])
        try:
            shown = only(values, plotted(plot))
        except Problem:  # a twin that does not exist: the process says so in the plot's place
            shown = dict(values)
        wish = Wish(plot, shown, size, self.theme, dict(ranges or {}), camera, triangles, fine,
                    fresh, self.count)
        with self.lock:
            self.wish = self.last = wish
            self.lock.notify_all()
        return self.count

    def poll(self) -> Picture | None:
        """The newest picture, once; raises PlotDied, once, when the process has ended by itself."""
        with self.lock:
            picture, self.picture = self.picture, None
            dead, self.dead = self.dead, ""
        if dead:
            raise PlotDied(dead)
        return picture

    @property
    def idle(self) -> bool:
        """Nothing is wished for and nothing is being drawn."""
        with self.lock:
            return self.wish is None and not self.busy

    def wait(self, timeout: float | None = None) -> Picture | None:
        """For jobs without a window: the picture of the latest wish, or None after the time."""
        with self.lock:
            self.lock.wait_for(lambda: self.dead or (self.wish is None and not self.busy), timeout)
            if not self.dead and (self.wish is not None or self.busy):
                return None
        return self.poll()

    def serve(self, child: subprocess.Popen) -> None:
        """The thread: the latest wish to the child, its picture back."""
        mesh: Any = self  # no mesh is this one, so that the first is sent
        try:
            while True:
                with self.lock:
                    self.busy = False
                    self.lock.notify_all()
                    self.lock.wait_for(lambda: self.wish is not None or self.closed or self.child is not child)
                    if self.closed or self.child is not child or self.wish is None:
                        return
                    wish, self.wish, self.busy = self.wish, None, True
                changed, mesh = wish.triangles is not mesh, wish.triangles
                sent = replace(wish, mesh_changed=changed, triangles=mesh if changed else None)
                send(cast(BinaryIO, child.stdin), sent)
                image, error, spots = receive(cast(BinaryIO, child.stdout))
                with self.lock:
                    self.picture = Picture(image, wish, error, spots)
                self.wake()
        except (EOFError, OSError, ValueError):  # ValueError: the pipe was closed under it
            with self.lock:
                if self.closed or self.child is not child:
                    return
                self.dead = self.epitaph(child)
                self.busy, self.wish = False, None
                self.lock.notify_all()
            self.wake()

    def wake(self) -> None:
        if self.on_picture is not None:
            self.on_picture()

    def epitaph(self, child: subprocess.Popen) -> str:
        try:
            code: int | None = child.wait(2)
        except subprocess.TimeoutExpired:
            code = None
        how = f"signal {-code}" if code is not None and code < 0 else f"exit code {code}"
        self.words.seek(0)
        lines = self.words.read()[-4000:].decode(errors="replace").strip().splitlines()
        said = f" It said: {lines[-1].strip()[:200]}" if lines else ""
        return f"The process that draws the plots has ended ({how}).{said}"

    def restart(self) -> None:
        """A new process, which draws the last wish again."""
        last = self.last
        self.stop()
        with self.lock:
            self.start()
            self.wish = last
            self.lock.notify_all()

    def stop(self) -> None:
        child, thread = self.child, self.thread
        with self.lock:
            self.child = None  # type: ignore[assignment]  # the thread sees that it is no longer wanted
            self.lock.notify_all()
        if self.busy:
            child.kill()
        thread.join(2)
        for pipe in (child.stdin, child.stdout):
            try:
                if pipe:
                    pipe.close()
            except OSError:  # what it had not read yet
                pass
        try:
            child.wait(2)
        except subprocess.TimeoutExpired:
            child.kill()
            child.wait()
        thread.join()
        self.words.close()

    def close(self) -> None:
        if not self.closed:
            self.closed = True
            self.stop()

    def __enter__(self) -> "PlotProcess":
        return self

    def __exit__(self, *exc) -> None:
        self.close()
