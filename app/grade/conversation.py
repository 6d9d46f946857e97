"""One process of a student's, from start to certain death: what it was sent, what came back, and how it ended.

Nothing that comes back is trusted: frames have sizes known beforehand, and one byte too many ends the conversation.
The parent reads under a deadline, kills without a condition, then waits under a deadline.
"""

import json
import os
import selectors
import signal
import struct
import subprocess
import tempfile
import time
from contextlib import suppress
from dataclasses import dataclass, field

import numpy as np

from app.grade import sandbox
from app.grade.child.frames import HEAD, LOADED, MAGIC, READY, REASONS, VALUES, WORDS

NOISE = 64 << 10  # bytes kept of what it prints, on each of its two streams
FLOOD = 16 << 20  # bytes printed after which it is stopped
ASLEEP = 0.1  # share of the time below which a process sleeps: so none lasts longer than 10 times its processor time
LONGEST_WAIT = 30.0  # s for a killed process to be gone


class Ours(Exception):
    """The machine, or we, failed: the submission is ungraded, and loses nothing by it."""


@dataclass(frozen=True)
class Call:
    """One call of one function: rows in the order in which they are sent."""

    function: str
    args: tuple[np.ndarray, ...]
    width: int

    @property
    def count(self) -> int:
        return len(self.args[0])


@dataclass
class Answer:
    values: np.ndarray | None
    word: str = ""
    said: str = ""
    seconds: float = 0.0


@dataclass
class Ending:
    """How far it came and how it ended: `word` is empty where every call was answered."""

    loaded: bool = False
    answers: list[Answer] = field(default_factory=list)
    word: str = ""
    said: str = ""
    cpu: float = 0.0
    wall: float = 0.0
    memory: int = 0  # bytes resident at most
    printed: str = ""


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


def write(file, text: str, calls: list[Call], dtype: str) -> None:
    header = json.dumps({"text": text, "sentinel": struct.unpack("<I", os.urandom(4))[0], "calls": [
        {"function": call.function, "columns": [1 if a.ndim == 1 else a.shape[1] for a in call.args],
         "count": call.count, "width": call.width} for call in calls]}).encode()
    file.write(struct.pack("<Q", len(header)) + header)
    for call in calls:
        for argument in call.args:
            file.write(np.ascontiguousarray(argument, dtype).data)
    file.flush()
    file.seek(0)


class Listener:
    """Reads what a process says on its three pipes, and stops it."""

    def __init__(self, child: subprocess.Popen, inner: int, calls: list[Call], ending: Ending,
                 limits: sandbox.Limits) -> None:
        self.child, self.inner, self.calls, self.ending, self.limits = child, inner, calls, ending, limits
        self.started, self.before = time.monotonic(), 0.0
        self.buffer = bytearray()
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
                if self.complete() or self.overdue() or (not open_still and self.child_ended()):
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
        while os.waitid(os.P_PID, self.child.pid, os.WEXITED | os.WNOWAIT | os.WNOHANG) is None:
            if self.overdue():
                return True
            time.sleep(0.01)
        return True

    def complete(self) -> bool:
        return len(self.ending.answers) == len(self.calls) or (bool(self.ending.answers) and not self.ending.loaded)

    def read(self, descriptor: int) -> bool:
        """Take what is there; False at its end."""
        try:
            data = os.read(descriptor, 1 << 20 if descriptor == self.inner else 1 << 16)
        except BlockingIOError:
            return True
        except OSError:
            return False
        if descriptor == self.inner:
            self.buffer += data
            self.frames()
        else:
            kept = self.noise[descriptor]
            kept += data[:NOISE - len(kept)]
            self.printed += len(data)
            if self.printed > FLOOD:
                self.ending.word, self.ending.said = "output_limit", "it prints without end"
        return bool(data)

    def frames(self) -> None:
        """Every whole frame in the buffer; what is no frame of ours ends it."""
        while len(self.buffer) >= HEAD.size and not self.ending.word:
            magic, index, kind, size = HEAD.unpack_from(self.buffer)
            wanted = len(self.ending.answers) if self.ending.loaded else LOADED
            call = self.calls[wanted] if wanted < len(self.calls) else None
            fits = (kind in REASONS and size <= WORDS) or (
                kind == READY and size == 0 if call is None else
                kind == VALUES and size == 8 * call.count * call.width)
            if magic != MAGIC or index != wanted or not fits:
                self.ending.word, self.ending.said = "runtime_error", "it wrote on the pipe of the answers"
                return
            if len(self.buffer) < HEAD.size + size:
                return
            data = bytes(self.buffer[HEAD.size:HEAD.size + size])
            del self.buffer[:HEAD.size + size]
            if kind == READY:
                self.ending.loaded, self.before = True, self.clock() or 0.0
                continue
            self.take(kind, data, call)
        if len(self.ending.answers) == len(self.calls) and self.buffer and not self.ending.word:
            self.ending.word, self.ending.said = "runtime_error", "it wrote on the pipe of the answers"

    def take(self, kind: int, data: bytes, call: Call | None) -> None:
        if call is None:  # the text could not even be read
            self.ending.word, self.ending.said = REASONS[kind], printable(data)
            return
        now = self.clock() or 0.0
        spent, self.before = now - self.before, now
        if kind == VALUES:
            values = np.frombuffer(data, "<f8").reshape((call.count, call.width) if call.width > 1 else (call.count,))
            self.ending.answers.append(Answer(values, seconds=spent))
        else:
            self.ending.answers.append(Answer(None, REASONS[kind], printable(data), spent))

    def clock(self) -> float | None:
        """Processor time of the child as the kernel counts it: another process's clock, clock_getcpuclockid(3)."""
        try:
            return time.clock_gettime((~self.child.pid << 3) | 2)
        except (OSError, AttributeError):  # not on this system
            return None

    def end(self) -> None:
        """Kill it, whatever it did; wait for it; say how it ended."""
        ending, child = self.ending, self.child
        done = len(ending.answers) == len(self.calls) or bool(ending.word)
        with suppress(ProcessLookupError):
            os.kill(child.pid, signal.SIGKILL)
        status, usage = reaped(child)
        for stream in (child.stdout, child.stderr):
            if stream:
                stream.close()
        os.close(self.inner)
        ending.wall = time.monotonic() - self.started
        ending.cpu, ending.memory = usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024
        ending.printed = printable(b"".join(self.noise.values()))
        if not done:
            ending.word, ending.said = ended(status, ending, self.limits)


def reaped(child: subprocess.Popen):
    deadline = time.monotonic() + LONGEST_WAIT
    while True:
        pid, status, usage = os.wait4(child.pid, os.WNOHANG)
        if pid:
            child.returncode = os.waitstatus_to_exitcode(status)
            return status, usage
        if time.monotonic() > deadline:
            raise Ours("a killed process does not end: the machine is in trouble")
        time.sleep(0.001)


def ended(status: int, ending: Ending, limits: sandbox.Limits) -> tuple[str, str]:
    """The word for a process that ended before it had answered everything."""
    code = os.waitstatus_to_exitcode(status)
    if ending.cpu > limits.cpu - 0.25 and code in (-signal.SIGKILL, -signal.SIGXCPU):
        return "timeout_cpu", too_long(limits)
    noise = ending.printed
    if not ending.loaded and code > 0 and "launch.py" in noise:
        raise Ours(f"the sandbox could not be set up: {noise.strip().splitlines()[-1][:300]}")
    if code < 0 and (ending.memory > 0.5 * limits.memory or "bad_alloc" in noise or "out of memory" in noise.lower()):
        return "memory", f"it needed more than the {limits.memory >> 20} MB there are"
    if code < 0:
        return "crash", f"the process died by {signal.Signals(-code).name}"
    return "crash", f"the process ended by itself (exit code {code})"


def too_long(limits: sandbox.Limits) -> str:
    return f"stopped after {limits.cpu} s of processor time"


def printable(data: bytes) -> str:
    """Text of a student's process, safe to show: no control characters, no bidi marks, bounded."""
    text = data[:NOISE].decode("utf-8", "backslashreplace")
    return "".join(c if c.isprintable() or c == "\n" else f"\\x{ord(c):02x}" for c in text)
