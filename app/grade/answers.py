"""What a student's process answers, taken apart: frames whose sizes are known beforehand, and nothing else.

Nothing here is trusted: a wrong magic, index or size, or one byte too many, ends the conversation with a word.
"""

import json
import os
import struct
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from app.grade.child.frames import HEAD, LOADED, MAGIC, READY, REASONS, STARTED, VALUES, WORDS

NOISE = 64 << 10  # bytes kept of what it prints, on each of its two streams


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

    started: bool = False  # ours is done: what goes wrong from here on is the text's
    loaded: bool = False
    answers: list[Answer] = field(default_factory=list)
    word: str = ""
    said: str = ""
    cpu: float = 0.0
    wall: float = 0.0
    memory: int = 0  # bytes resident at most
    printed: str = ""


def write(file, text: str, calls: list[Call], dtype: str) -> None:
    """The input of a worker, as `app.grade.child.frames` describes it."""
    header = json.dumps({"text": text, "sentinel": struct.unpack("<I", os.urandom(4))[0], "calls": [
        {"function": call.function, "columns": [1 if a.ndim == 1 else a.shape[1] for a in call.args],
         "count": call.count, "width": call.width} for call in calls]}).encode()
    file.write(struct.pack("<Q", len(header)) + header)
    for call in calls:
        for argument in call.args:
            file.write(np.ascontiguousarray(argument, dtype).data)
    file.flush()
    file.seek(0)


class Frames:
    """The bytes of the pipe as answers; `clock` says the processor time of the process, or None."""

    def __init__(self, calls: list[Call], ending: Ending, clock: Callable[[], float | None]) -> None:
        self.calls, self.ending, self.clock = calls, ending, clock
        self.buffer, self.before = bytearray(), 0.0

    def complete(self) -> bool:
        return len(self.ending.answers) == len(self.calls)

    def feed(self, data: bytes) -> None:
        """Every whole frame; what is no frame of ours ends it."""
        self.buffer += data
        while len(self.buffer) >= HEAD.size and not self.ending.word:
            magic, index, kind, size = HEAD.unpack_from(self.buffer)
            place = len(self.ending.answers)
            wanted = place if self.ending.loaded else LOADED if self.ending.started else STARTED
            call = self.calls[place] if self.ending.loaded and place < len(self.calls) else None
            fits = (kind in REASONS and size <= WORDS and self.ending.started) or (
                kind == READY and size == 0 if call is None else
                kind == VALUES and size == 8 * call.count * call.width)
            if magic != MAGIC or index != wanted or not fits:
                self.ending.word, self.ending.said = "runtime_error", "it wrote on the pipe of the answers"
                return
            if len(self.buffer) < HEAD.size + size:
                return
            data = bytes(self.buffer[HEAD.size:HEAD.size + size])
            del self.buffer[:HEAD.size + size]
            self.take(kind, data, call)
        if self.complete() and self.buffer and not self.ending.word:
            self.ending.word, self.ending.said = "runtime_error", "it wrote on the pipe of the answers"

    def take(self, kind: int, data: bytes, call: Call | None) -> None:
        now = self.clock() or 0.0
        spent, self.before = now - self.before, now
        if call is None and kind == READY:
            self.ending.started, self.ending.loaded = True, self.ending.started
        elif call is None:  # the text could not even be read
            self.ending.word, self.ending.said = REASONS[kind], printable(data)
        elif kind == VALUES:
            values = np.frombuffer(data, "<f8").reshape((call.count, call.width) if call.width > 1 else (call.count,))
            self.ending.answers.append(Answer(values, seconds=spent))
        else:
            self.ending.answers.append(Answer(None, REASONS[kind], printable(data), spent))


def printable(data: bytes) -> str:
    """Text of a student's process, safe to show: no control characters, no bidi marks, bounded."""
    text = data[:NOISE].decode("utf-8", "backslashreplace")
    return "".join(c if c.isprintable() or c == "\n" else f"\\x{ord(c):02x}" for c in text)
