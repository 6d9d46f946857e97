"""Messages between the window's process and the plots': the length in 8 bytes, then a pickle."""

import pickle
import struct
from dataclasses import dataclass
from typing import Any, BinaryIO

from app.lesson import Number


@dataclass(frozen=True)
class Spot:
    """A point of a picture that can be pointed at, px from the top left: what it is, and what a click on it sets."""

    x: float
    y: float
    words: str
    sets: dict[str, Number]


LENGTH = struct.Struct("<Q")


def send(stream: BinaryIO, message: Any) -> None:
    data = pickle.dumps(message, protocol=pickle.HIGHEST_PROTOCOL)
    stream.write(LENGTH.pack(len(data)))
    stream.write(data)
    stream.flush()


def receive(stream: BinaryIO) -> Any:
    """The next message; EOFError when the other side has gone."""
    head = stream.read(LENGTH.size)
    if len(head) < LENGTH.size:
        raise EOFError
    count = LENGTH.unpack(head)[0]
    data = stream.read(count)
    if len(data) < count:
        raise EOFError
    return pickle.loads(data)
