"""What a worker is asked, and how it answers: raw little-endian numbers, of sizes the supervisor knows beforehand.

Input, on descriptor 0, a file: 8 bytes with the length of a JSON header, the header, then the arguments of each call,
one after the other. Output, on a pipe of its own: one frame a call, in the order of the calls. A frame is magic, index
of the call, what it holds, and the number of bytes that follow: float64 numbers, or a reason.
"""

import json
import os
import struct

MAGIC = b"HALF"
HEAD = struct.Struct("<4sIIQ")
READY, VALUES = 0, 1
REASONS = {2: "runtime_error", 3: "missing", 4: "memory", 5: "forbidden", 6: "compile_error", 7: "unwritten",
           8: "wrong"}
STARTED, LOADED = 0xFFFFFFFE, 0xFFFFFFFF  # indices of two frames: all is ready for the student's text; it has been read
WORDS = 2000  # bytes of a reason at most


class Pipe:
    """The way out. The functions of os are held here, so that what a student does to os changes nothing."""

    def __init__(self, descriptor: int) -> None:
        self.descriptor, self.os_write = descriptor, os.write

    def send(self, index: int, kind: int, data=b"") -> None:
        rest = memoryview(HEAD.pack(MAGIC, index, kind, len(data)) + data)
        while rest:
            rest = rest[self.os_write(self.descriptor, rest):]

    def refuse(self, index: int, word: str, why: str) -> None:
        kind = next(number for number, name in REASONS.items() if name == word)
        self.send(index, kind, why.encode("utf-8", "backslashreplace")[:WORDS])


def seek_and_read(descriptor: int, size: int, offset: int) -> bytes:
    os.lseek(descriptor, offset, os.SEEK_SET)
    return os.read(descriptor, size)


class Questions:
    """The header, and the arguments of a call when it is its turn."""

    def __init__(self) -> None:
        self.os_pread = getattr(os, "pread", seek_and_read)
        size = struct.unpack("<Q", self.read(8, 0))[0]
        self.header = json.loads(self.read(size, 8))
        self.start = 8 + size

    def read(self, size: int, offset: int) -> bytes:
        parts = []
        while size:
            part = self.os_pread(0, min(size, 1 << 24), offset)
            if not part:
                raise EOFError("the questions end early")
            parts.append(part)
            size, offset = size - len(part), offset + len(part)
        return b"".join(parts)
