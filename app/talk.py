"""A talk that is on: where it is, and every stop as it was left, so that paging back restores it exactly."""

from dataclasses import dataclass

from app.cues import Stop
from app.motion import Sweep, moved, sweep, there_and_back
from app.prediction import Answer
from app.problem import Usage
from app.session import Session
from app.show_of_hands import Hands
from app.state import View, parse


@dataclass(frozen=True)
class Left:
    """A stop as it was left."""

    values: dict
    view: View
    plot: int
    answer: Answer
    hands: Hands | None


class Talk:
    def __init__(self, session: Session, stops: tuple[Stop, ...], begin: int = 0):
        self.session, self.stops, self.place = session, stops, begin
        self.left: dict[int, Left] = {}
        self.hands: Hands | None = None  # while a question is on
        self.is_black = False
        self.playing = False
        self.phase = 0.0  # of the sweep: 1 is there and back
        self.touched = ""  # the value that was moved last
        self.enter()

    @property
    def stop(self) -> Stop:
        return self.stops[self.place]

    @property
    def has_scene(self) -> bool:
        return bool(self.stop.state)

    def title(self, place: int) -> str:
        """What a stop shows, in words."""
        if not 0 <= place < len(self.stops):
            return ""
        stop = self.stops[place]
        found = stop.found(self.session.folder)
        slide = f"page {stop.page}" if stop.page else ""
        return ": ".join(filter(None, (slide, found.step.title if found else "")))

    @property
    def notes(self) -> str:
        """The cue's own, then the step's."""
        own = self.session.current.step.notes if self.has_scene else ""
        return "\n\n".join(filter(None, (" ".join(self.stop.notes.split()), " ".join(own.split()))))

    # --- from stop to stop -------------------------------------------------------------------------------------------
    def move(self, by: int) -> bool:
        """A stop on or back; a black picture comes back first. False at the ends."""
        if self.is_black:
            self.is_black = False
            return True
        return self.go(self.place + by)

    def go(self, place: int) -> bool:
        if not 0 <= place < len(self.stops):
            return False
        self.leave()
        self.place = place
        self.enter()
        return True

    def leave(self) -> None:
        self.pause()
        if self.has_scene:
            visit = self.session.visit
            self.session.freeze(False)
            self.session.mend()
            self.left[self.place] = Left(dict(visit.values), visit.view, visit.plot, visit.answer, self.hands)
        self.hands = None

    def enter(self) -> None:
        """As it was left, or as its cue says."""
        self.phase, self.touched = 0.0, ""
        if not self.has_scene:
            return
        state = parse(self.stop.state, self.session.folder)
        self.session.go(state.step)
        was = self.left.get(self.place) or Left(state.values, state.view, self.stop.plot - 1, Answer(), None)
        visit = self.session.visit
        visit.past.clear()
        visit.future.clear()
        visit.put(dict(was.values), was.view)
        visit.plot, visit.answer, self.hands = was.plot, was.answer, was.hands
        self.session.freeze(self.hands is not None and was.answer.stage != "revealed")
        self.session.revision += 1

    def reset(self) -> None:
        """This stop as its cue says."""
        self.pause()
        self.left.pop(self.place, None)
        self.hands = None
        self.session.mend()
        self.enter()

    # --- a value that moves ------------------------------------------------------------------------------------------
    def sweep(self) -> Sweep | None:
        """What the cue says, else the value that was touched last, else the step's first."""
        found = self.session.current
        if self.stop.sweep:
            return sweep(self.stop.sweep, found)
        can = [spec.name for spec in found.below if spec.quantity.width == 1 and not spec.choices]
        name = self.touched if self.touched in can else next(iter(can), "")
        return sweep(name, found) if name else None

    def play(self) -> None:
        """Play or pause; it goes on where it stood."""
        if self.playing:
            return self.pause()
        if self.has_scene and not self.session.frozen and self.sweep():
            self.playing = True
            self.session.begin_change()
        return None

    def pause(self) -> None:
        if self.playing:
            self.playing = False
            self.session.end_change()

    def tick(self, seconds: float) -> None:
        """Time passes."""
        way = self.sweep() if self.playing else None
        if way is None or self.session.frozen:
            return self.pause()
        self.phase += seconds / (2 * self.stop.seconds)
        try:
            self.session.change({**self.session.values, **moved([way], there_and_back(self.phase))}, self.session.view)
        except Usage:
            self.pause()
        return None

    # --- a question to the class -------------------------------------------------------------------------------------
    def ask(self) -> None:
        """The question is shown, the picture waits, numbers and plot are hidden; again: the question goes."""
        if not self.has_scene:
            return
        if self.hands is not None:
            self.hands = None
            self.session.freeze(False)
            return
        self.pause()
        self.session.ask_again()
        self.hands = Hands(self.session.current.step.ask)
        self.session.freeze()

    @property
    def is_told(self) -> bool:
        return self.session.answer.stage == "revealed"
