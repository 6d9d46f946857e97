"""One process of a student's, from start to certain death: what it was sent, what came back, and how it ended.

The parent reads what it knows the size of, under a deadline, kills without a condition, then waits under a deadline.
"""

import os
import selectors
import signal
import subprocess
import tempfile
import time
from contextlib import suppress

from app.grade import sandbox
from app.grade.answers import NOISE, Call, Ending, Frames, Ours, printable, write

FLOOD = 16 << 20  # bytes printed after which it is stopped
ASLEEP = 0.1  # share of the time below which a process sleeps: so none lasts longer than 10 times its processor time
NEARLY = 0.75  # of the limit: on a busy machine the kernel counts whole ticks, and kills a tenth early by its own clock
LONGEST_WAIT = 30.0  # s for a killed process to be gone


def converse(worker: str, text: str, calls: list[Call], layers: tuple[str, ...], limits: sandbox.Limits,
             dtype: str = "<f8") -> Ending:
    """Ask all calls of a fresh process."""
    ending, out = Ending(), -1
    try:
        with tempfile.TemporaryFile() as questions:
            write(questions, text, calls, dtype)
            inner, out = os.pipe()
            try:
                child = sandbox.start(worker, layers, limits, questions.fileno(), out)
            except BaseException:
                os.close(inner)
                raise
            finally:
                os.close(out)
        listener = Listener(child, inner, calls, ending, limits)
    except OSError as error:
        raise Ours(f"a process for the submission could not be started: {error}") from None
    try:
        listener.listen()
    finally:
        listener.end()
    return ending


class Listener:
    """Reads what a process says on its three pipes, and stops it."""

    def __init__(self, child: subprocess.Popen, inner: int, calls: list[Call], ending: Ending,
                 limits: sandbox.Limits) -> None:
        self.child, self.inner, self.calls, self.ending, self.limits = child, inner, calls, ending, limits
        self.started = time.monotonic()
        self.frames = Frames(calls, ending, self.clock)
        self.status: int | None = None
        self.noise = {stream.fileno(): bytearray() for stream in (child.stdout, child.stderr) if stream}
        self.printed = 0

    def listen(self) -> None:
        with selectors.DefaultSelector() as watch:
            for descriptor in (self.inner, *self.noise):
                os.set_blocking(descriptor, False)
                watch.register(descriptor, selectors.EVENT_READ)
            while watch.get_map():
                for key, _ in watch.select(0.1):
                    if not self.read(key.fd):
                        watch.unregister(key.fd)
                open_still = self.inner in {key.fd for key in watch.get_map().values()}
                if self.frames.complete() or self.overdue() or (not open_still and self.child_ended()):
                    return

    def overdue(self) -> bool:
        """Asleep past the backstop, or over its time where no limit of the kernel stops it (L0). One that is only slow,
        on a busy machine, is judged by its processor time."""
        elapsed, spent = time.monotonic() - self.started, self.clock() or 0.0
        if spent > self.limits.cpu + 0.5:
            self.ending.word, self.ending.said = "timeout_cpu", too_long(self.limits)
        elif elapsed > self.limits.wall * self.limits.cpu and spent < ASLEEP * elapsed:
            self.ending.word = "timeout_wall"
            self.ending.said = f"it did nothing, and was stopped after {elapsed:.0f} s"
        return bool(self.ending.word)

    def child_ended(self) -> bool:
        """It closed its way out; whether it is dead, sleeps or spins is seen in time."""
        while not self.gone():
            if self.overdue():
                return True
            time.sleep(0.01)
        return True

    def gone(self) -> bool:
        """Whether it is dead; then it is waited for, and what it used is known."""
        if self.status is None:
            pid, status, usage = os.wait4(self.child.pid, os.WNOHANG)
            if pid:
                self.status, self.child.returncode = status, os.waitstatus_to_exitcode(status)
                self.ending.cpu = usage.ru_utime + usage.ru_stime
                import resource  # not on Windows, where plain.py talks

                own = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss  # which a child begins with, before its exec
                self.ending.memory = usage.ru_maxrss * 1024 if usage.ru_maxrss > own else 0
        return self.status is not None

    def read(self, descriptor: int) -> bool:
        """Take what is there; False at its end."""
        try:
            data = os.read(descriptor, 1 << 20 if descriptor == self.inner else 1 << 16)
        except BlockingIOError:
            return True
        except OSError:
            return False
        if descriptor == self.inner:
            self.frames.feed(data)
        else:
            kept = self.noise[descriptor]
            kept += data[:NOISE - len(kept)]
            self.printed += len(data)
            if self.printed > FLOOD:
                self.ending.word, self.ending.said = "output_limit", "it prints without end"
        return bool(data)

    def clock(self) -> float | None:
        """Processor time of the child as the kernel counts it: another process's clock, clock_getcpuclockid(3)."""
        try:
            return time.clock_gettime((~self.child.pid << 3) | 2)
        except (OSError, AttributeError):  # not on this system
            return None

    def end(self) -> None:
        """Kill it, whatever it did; wait for it; say how it ended."""
        ending, child = self.ending, self.child
        done = self.frames.complete() or bool(ending.word)
        deadline = time.monotonic() + LONGEST_WAIT
        while not self.gone():
            with suppress(ProcessLookupError):
                os.kill(child.pid, signal.SIGKILL)
            if time.monotonic() > deadline:
                raise Ours("a killed process does not end: the machine is in trouble")
            time.sleep(0.001)
        for stream in (child.stdout, child.stderr):
            if stream:
                stream.close()
        os.close(self.inner)
        ending.wall = time.monotonic() - self.started
        ending.printed = printable(b"".join(self.noise.values()))
        if not ending.started:
            lines = ending.printed.strip().splitlines() or [f"it ended with {child.returncode}"]
            raise Ours(f"the sandbox could not be set up: {lines[-1][:300]}")
        if not done:
            ending.word, ending.said = ended(child.returncode, ending, self.limits)


def ended(code: int, ending: Ending, limits: sandbox.Limits) -> tuple[str, str]:
    """The word for a process that ended before it had answered everything."""
    if ending.cpu > NEARLY * limits.cpu and code in (-signal.SIGKILL, -signal.SIGXCPU):
        return "timeout_cpu", too_long(limits)
    noise = ending.printed
    if code < 0 and (ending.memory > 0.5 * limits.memory or "bad_alloc" in noise or "out of memory" in noise.lower()):
        return "memory", f"it needed more than the {limits.memory >> 20} MB there are"
    if code < 0:
        return "crash", f"the process died by {signal.Signals(-code).name}"
    return "crash", f"the process ended by itself (exit code {code})"


def too_long(limits: sandbox.Limits) -> str:
    return f"stopped after {limits.cpu} s of processor time"
