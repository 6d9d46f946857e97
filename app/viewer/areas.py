"""Where slide, scene, plot and numbers stand while presenting: beside each other, or on top of each other in half a
screen. No drawing."""

from dataclasses import dataclass

NARROW = 1.15  # width over height below which all stand on top of each other


@dataclass(frozen=True)
class Rect:
    x: float
    y: float
    width: float
    height: float

    def cut(self, share: float) -> tuple["Rect", "Rect"]:
        """The left part and the rest."""
        left = round(share * self.width)
        return (Rect(self.x, self.y, left, self.height),
                Rect(self.x + left, self.y, self.width - left, self.height))

    def split(self, share: float) -> tuple["Rect", "Rect"]:
        """The upper part and the rest."""
        top = round(share * self.height)
        return (Rect(self.x, self.y, self.width, top), Rect(self.x, self.y + top, self.width, self.height - top))

    def within(self, aspect: float) -> "Rect":
        """The largest of this aspect in its middle."""
        wide = min(self.width, self.height * aspect)
        high = wide / aspect
        return Rect(self.x + (self.width - wide) / 2, self.y + (self.height - high) / 2, wide, high)


def areas(room: Rect, slide: float, scene: bool, detail: int, plot: bool = True) -> dict[str, Rect]:
    """`slide` is the page's aspect, 0 without one; `detail` 0: scene and plot alone, 1: with numbers, 2: with prose.
    Without `plot` the scene is alone."""
    if not scene:
        return {"slide": room}
    found: dict[str, Rect] = {}
    if not plot:  # a question is on: what would tell the answer is away
        return {"scene": room}
    if room.width < NARROW * room.height:
        return stacked(room, slide, detail)
    if detail == 2:
        found["text"], room = room.cut(0.3)
    if slide:
        left, found["scene"] = room.cut(0.54)
        found["slide"], room = left.split(min(left.width / slide / left.height, 0.62))
        if detail:
            found["plot"], found["numbers"] = room.cut(0.6)
        else:
            found["plot"] = room
        return found
    found["scene"], room = room.cut(0.6)
    if detail:
        found["plot"], found["numbers"] = room.split(0.64)
    else:
        found["plot"] = room
    return found


def stacked(room: Rect, slide: float, detail: int) -> dict[str, Rect]:
    """Half a screen: on top of each other."""
    found: dict[str, Rect] = {}
    if slide:
        found["slide"], room = room.split(min(room.width / slide / room.height, 0.36))
    if detail == 2:
        room, found["text"] = room.split(0.68)
    found["scene"], room = room.split(0.6)
    if detail:
        found["plot"], found["numbers"] = room.cut(0.58)
    else:
        found["plot"] = room
    return found
