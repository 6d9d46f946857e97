"""Where a word stands in a picture: at its place, or some lines above or below it where another has that place."""

from collections.abc import Sequence
from dataclasses import dataclass

MOST = 3  # lines: farther away, nobody knows what it names


@dataclass(frozen=True)
class Box:
    """px in the window; y down."""

    x: float
    y: float
    width: float
    height: float

    def meets(self, other: "Box") -> bool:
        return (self.x < other.x + other.width and other.x < self.x + self.width
                and self.y < other.y + other.height and other.y < self.y + self.height)

    def moved(self, down: float) -> "Box":
        return Box(self.x, self.y + down, self.width, self.height)

    def within(self, room: "Box") -> "Box":
        """As near to its place as the room allows."""
        return Box(max(min(self.x, room.x + room.width - self.width), room.x),
                   max(min(self.y, room.y + room.height - self.height), room.y), self.width, self.height)


def free(box: Box, taken: Sequence[Box], room: Box, outwards: float) -> Box:
    """The nearest place of the box, in whole lines up and down, that meets none of those taken; first the way outwards
    (1 down, -1 up), off what it names. Where there is none, its own."""
    box = box.within(room)
    for lines in (0, *(sign * k for k in range(1, MOST + 1) for sign in (outwards, -outwards))):
        there = box.moved(lines * box.height)
        if there == there.within(room) and not any(there.meets(other) for other in taken):
            return there
    return box
