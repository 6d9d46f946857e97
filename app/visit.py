"""What a step of a running course keeps while one is elsewhere: values, view, answer and the history of changes."""

from dataclasses import dataclass, field

from app.lesson import Number
from app.prediction import Answer
from app.state import View

Snapshot = tuple[dict[str, Number], View]


@dataclass
class Visit:
    values: dict[str, Number]  # internal units; the same dictionary for the whole visit
    view: View
    answer: Answer = field(default_factory=Answer)
    plot: int = 0  # which of the step's plots is shown
    texts: dict[str, str] = field(default_factory=dict)  # function -> what was typed in its place, right or wrong
    aside: dict[str, str] = field(default_factory=dict)  # what was typed before the course's text was restored
    tried: dict[str, str] = field(default_factory=dict)  # of an exercise that is open: they stand before `texts`
    running: dict[str, str] = field(default_factory=dict)  # the last texts that compiled: what is shown
    decided: dict[str, bool] = field(default_factory=dict)  # in or out by hand, not by the scene
    past: list[Snapshot] = field(default_factory=list)
    future: list[Snapshot] = field(default_factory=list)
    before: Snapshot | None = None  # while a drag is on

    def snapshot(self) -> Snapshot:
        return dict(self.values), self.view

    def put(self, values: dict[str, Number], view: View) -> None:
        self.values.update(values)
        self.view = view

    def change(self, values: dict[str, Number], view: View) -> bool:
        """Values and view become these: an entry of the history, or part of the drag that is on. False: as before."""
        if self.snapshot() == (values, view):
            return False
        if self.before is None:
            self.remember(self.snapshot())
        self.put(values, view)
        return True

    def begin(self) -> None:
        """A drag begins; a second one does not nest."""
        self.before = self.before or self.snapshot()

    def end(self) -> None:
        before, self.before = self.before, None
        if before is not None and before != self.snapshot():
            self.remember(before)

    def remember(self, before: Snapshot) -> None:
        self.past.append(before)
        self.future.clear()

    def travel(self, back: list[Snapshot], forth: list[Snapshot]) -> bool:
        """One entry along the history; False at its end."""
        self.end()
        if not back:
            return False
        forth.append(self.snapshot())
        self.put(*back.pop())
        return True
