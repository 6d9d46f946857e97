"""A running course, without a window: where one is, what one has changed, what one has guessed.

The window draws this and calls it; a test does the same. Every step keeps its values, its view, its history of changes
and its answer while others are looked at.
"""

import math
from dataclasses import dataclass
from pathlib import Path

from app import prediction
from app.breaking import broken, values_of
from app.catalog import BOARD, LoadedStep, chapters, step, steps
from app.edit import Function, among_values, functions, source_of
from app.exercises import of_step, taught
from app.lesson import Break, Number, Plot
from app.paths import LESSONS
from app.prediction import Answer
from app.problem import Problem, Usage, near
from app.progress import Progress
from app.shader import Overrides
from app.state import State, View, defaults, parse, parse_query, write
from app.typed import checked
from app.visit import Visit


@dataclass(frozen=True)
class Entry:
    """A line of the outline: a step, or a chapter that could not be read (its `fault`)."""

    id: str
    title: str
    number: int
    chapter: str
    current: bool = False
    visited: bool = False
    answered: bool = False
    minutes: float = 0.0
    beyond: bool = False
    fault: str = ""
    exercises: tuple[str, ...] = ()  # chapter/name of those the step teaches


class Session:
    def __init__(self, start: str = "", progress: Progress | None = None, folder: Path = LESSONS):
        """Begins at the state string `start`, else where the course was left, else at its first step."""
        self.folder, self.progress = folder, progress
        self.message = ""  # one sentence for the person
        self.told = progress.message if progress else ""  # of the progress file
        self.frozen = False  # the picture waits for the guess: values stay as they are
        self.sound: tuple[LoadedStep, dict[str, Number], int] | None = None  # while a step is broken: it, as it was
        self.revision = 0  # grows when anything changes that a picture shows
        self.visits: dict[str, Visit] = {}
        self.steps = steps(folder)
        if not self.steps:
            faults = [found.fault for found in chapters(folder) if found.fault]
            raise Problem(faults[0] if faults else f"there is no lesson in {folder}.")
        last = progress.setting("last_step") if progress else None
        known = {found.id for found in self.steps}
        self.current = self.found(start.partition("?")[0] or (last if last in known else self.steps[0].id))
        self.visit = self.enter(self.current)
        if "?" in start:
            self.visit.put(*unpacked(parse(start, folder)))

    # --- where one is ------------------------------------------------------------------------------------------------
    @property
    def values(self) -> dict[str, Number]:
        return self.visit.values

    @property
    def view(self) -> View:
        return self.visit.view

    @property
    def plot(self) -> Plot:
        """Which of the step's plots is shown."""
        return self.current.step.plots[self.visit.plot]

    def show_plot(self, number: int) -> None:
        """Another of the step's plots; after the last comes the first."""
        self.visit.plot = number % len(self.current.step.plots)

    @property
    def state(self) -> str:
        """The state string, to copy."""
        return write(self.current, self.values, self.view)

    @property
    def place(self) -> int:
        """The number of the step in the course, from 0."""
        return next(i for i, found in enumerate(self.steps) if found.id == self.current.id)

    def go(self, text: str) -> None:
        """To a step as it was left, or to a state string: then its values can be undone."""
        state = parse(text, self.folder)
        self.end_change()
        self.save()
        self.mend()
        self.current = self.found(state.step)
        self.visit = self.enter(self.current)
        if "?" in text:
            self.change(*unpacked(state))

    def found(self, id: str) -> LoadedStep:
        """The step of that name; one that is made when it is asked for stands behind the course's, one at a time."""
        found = step(id, self.folder)
        if id.startswith(BOARD):
            self.steps = (*(one for one in self.steps if not one.id.startswith(BOARD)), found)
        return found

    def examine(self, id: str) -> None:
        """The board of other models: what was set there stays set."""
        found = step(id, self.folder)
        kept = found.carried(self.current, self.values)
        self.go(id)
        self.change({**self.values, **kept}, self.view)

    def next(self) -> bool:
        return self.move(1)

    def previous(self) -> bool:
        return self.move(-1)

    def move(self, by: int) -> bool:
        """Some steps on or back; False at the course's ends."""
        place = self.place + by
        if not 0 <= place < len(self.steps):
            return False
        self.go(self.steps[place].id)
        return True

    def enter(self, found: LoadedStep) -> Visit:
        self.frozen = False
        self.revision += 1
        if found.id not in self.visits:
            self.visits[found.id] = self.remembered(found)
        return self.visits[found.id]

    def remembered(self, found: LoadedStep) -> Visit:
        """The step as an earlier day left it."""
        visit = Visit(defaults(found), View.of(found.step.scene.camera))
        if self.progress is None:
            return visit
        try:
            state = self.progress.state(found.id)
            if state is not None:
                visit.put(*unpacked(parse(state, self.folder)))
            visit.answer = answer_of(found, self.progress.answer(found.id))
            visit.texts, visit.aside = self.progress.texts(found.id)
        except Usage:
            self.message = f"What you left in {found.id} no longer fits the lesson; it starts afresh."
        return visit

    def save(self) -> None:
        """Remember this step on disk: when it is left, when a truth is told, and now and then; a broken one as it was
        before. The board is no step of the course."""
        if self.progress and not self.current.id.startswith(BOARD):
            found, values, _ = self.sound or (self.current, self.values, 0)
            self.progress.put_state(found.id, write(found, values, self.view))
            self.progress.put_texts(self.current.id, self.visit.texts, self.visit.aside)
            self.progress.save()
            if self.progress.message not in ("", self.told):  # once is enough
                self.message = self.told = self.progress.message

    def outline(self) -> tuple[Entry, ...]:
        entries = []
        for found in chapters(self.folder):
            if found.fault:
                entries.append(Entry("", found.id, found.number, found.chapter.title, fault=found.fault))
        for found_step in self.steps:
            loaded, the = found_step.loaded, found_step.step
            visit, kept = self.visits.get(found_step.id), self.progress
            entries.append(Entry(
                found_step.id, the.title, loaded.number, loaded.chapter.title, found_step.id == self.current.id,
                visit is not None or bool(kept and kept.visited(found_step.id)),
                visit.answer.stage == "revealed" if visit else bool(kept and kept.answer(found_step.id)),
                the.minutes, the.beyond,
                exercises=tuple(name for name, one in of_step(found_step).items() if taught(found_step, one))))
        return tuple(sorted(entries, key=lambda entry: entry.number))

    # --- what one changes --------------------------------------------------------------------------------------------
    def set(self, name: str, value: Number) -> None:
        """One value, internal units. Out of range, unknown or while the picture is frozen: a Usage."""
        if name not in self.values:
            raise Usage(f"there is no value {name} in {self.current.id}.{near(name, self.values)}")
        spec = self.current.values[name]
        self.change({**self.values, name: checked(value, spec, f"{self.current.id}: {name}")}, self.view)

    def stand(self, at: dict[str, float]) -> None:
        """The angles (rad) that the step has become these, or as near as their ranges allow."""
        new = dict(self.values)
        for name in at.keys() & self.current.values.keys():
            spec, angle = self.current.values[name], at[name]
            same = (angle, angle + math.tau, angle - math.tau, -angle) if name == "phi" else (angle,)
            fits = [x for x in same if spec.low <= x <= spec.high]
            new[name] = fits[0] if fits else min(max(angle, spec.low), spec.high)
        self.change(new, self.view)

    def apply(self, target: str) -> None:
        """A link of the prose: `?tilt=80&distance=1` sets values here, `solid_angle/cone?half_angle=1` goes there."""
        if not target.startswith("?"):
            return self.go(target)
        values, view = parse_query(target[1:], self.current)
        return self.change({**self.values, **values}, view or self.view)

    def look(self, view: View) -> None:
        self.change(self.values, view)

    def reset(self, name: str = "") -> None:
        """One value to its default, or (without a name) the whole step with its view."""
        own = defaults(self.current)
        if name and name not in own:
            raise Usage(f"there is no value {name} in {self.current.id}.{near(name, own)}")
        if name:
            self.change({**self.values, name: own[name]}, self.view)
        else:
            self.mend()
            self.change(own, View.of(self.current.step.scene.camera))

    def change(self, values: dict[str, Number], view: View) -> None:
        """Values and view become these; one entry of the history, or part of the drag that is on."""
        if self.frozen and values != self.values:
            raise Usage("the picture waits for your guess; unfreeze it to change it.")
        self.revision += self.visit.change(values, view)

    def begin_change(self) -> None:
        """A drag begins: what follows is one entry of the history."""
        self.visit.begin()

    def end_change(self) -> None:
        self.visit.end()

    def undo(self) -> bool:
        return not self.frozen and self.moved(self.visit.travel(self.visit.past, self.visit.future))

    def redo(self) -> bool:
        return not self.frozen and self.moved(self.visit.travel(self.visit.future, self.visit.past))

    def moved(self, done: bool) -> bool:
        self.revision += done
        return done

    # --- what one leaves out -----------------------------------------------------------------------------------------
    def decide(self, label: str, is_out: bool | None) -> None:
        """Leave something out, or keep it, whatever the scene thinks; None: as the scene thinks."""
        if is_out is None:
            self.visit.decided.pop(label, None)
        else:
            self.visit.decided[label] = is_out
        self.revision += 1

    # --- what one breaks ---------------------------------------------------------------------------------------------
    @property
    def broken(self) -> Break | None:
        """What is broken now."""
        return self.sound[0].step.breaks[self.sound[2]] if self.sound else None

    def break_it(self, which: int = 0) -> None:
        """Naive forms at the values where they fail; the same again mends it, another breaks that instead."""
        again = self.sound is not None and self.sound[2] == which
        self.mend()
        if again:
            return
        if which >= len(self.current.step.breaks):
            raise Usage(f"there is nothing to break in {self.current.id}.")
        before = dict(self.values)
        self.change({**self.values, **values_of(self.current, self.current.step.breaks[which])}, self.view)
        self.sound = self.current, before, which
        self.current = broken(self.current, which)
        self.revision += 1

    def mend(self) -> None:
        """The stable forms again, at the values from before; nothing where nothing is broken."""
        if self.sound:
            (self.current, before, _), self.sound = self.sound, None
            self.change(before, self.view)
            self.revision += 1

    # --- what one types ----------------------------------------------------------------------------------------------
    @property
    def functions(self) -> dict[str, Function]:
        """What may be edited in this step."""
        return functions(self.current)

    @property
    def edited(self) -> dict[str, Overrides]:
        """What values carry of the texts that run."""
        known = self.functions if self.visit.running else {}  # a break leaves out what it puts another in the place of
        running = {name: text for name, text in self.visit.running.items() if name in known}
        return among_values(running, known, source_of(self.current))

    def text(self, name: str) -> str:
        """A function as it was typed last, or the course's."""
        return self.visit.texts.get(name, self.function(name).text)

    def function(self, name: str) -> Function:
        if name not in self.functions:
            raise Usage(f"{self.current.id} compiles no function {name}.{near(name, self.functions)}")
        return self.functions[name]

    def type(self, name: str, text: str) -> None:
        """A text in a function's place; it runs once it compiles (`run`). The course's own is no edit."""
        if text == self.function(name).text:
            self.visit.texts.pop(name, None)
        else:
            self.visit.texts[name] = text
        self.revision += 1

    def try_out(self, texts: dict[str, str]) -> None:
        """The texts of an exercise stand before all others while it is open; those that this step does not compile are
        left out."""
        wanted = {name: text for name, text in texts.items() if name in self.functions} if texts else {}
        if wanted != self.visit.tried:
            self.visit.tried = wanted
            self.revision += 1

    @property
    def texts(self) -> dict[str, str]:
        """What is to stand in the place of functions: what was typed in this step, before it an open exercise."""
        return {**self.visit.texts, **self.visit.tried}

    def run(self, texts: dict[str, str]) -> None:
        """These compile: numbers, plots and badges follow them."""
        if texts != self.visit.running:
            self.visit.running = dict(texts)
            self.revision += 1

    def restore(self, name: str) -> None:
        """The course's text again; what was typed can be brought back."""
        self.put_aside(name)
        self.type(name, self.function(name).text)

    def put_aside(self, name: str) -> None:
        """What was typed is kept, to be brought back."""
        if name in self.visit.texts:
            self.visit.aside[name] = self.visit.texts[name]

    def bring_back(self, name: str) -> None:
        self.type(name, self.visit.aside.pop(name, self.text(name)))

    # --- what one guesses --------------------------------------------------------------------------------------------
    @property
    def answer(self) -> Answer:
        return self.visit.answer

    @property
    def verdict(self) -> str:
        """How the guess did, in words; empty before the reveal."""
        return prediction.words(self.current.step.ask, self.answer)

    def freeze(self, on: bool = True) -> None:
        """Hold the picture still while the class makes up its mind; the reveal lets it go."""
        self.end_change()
        self.frozen = on

    def guess(self, guess: float) -> None:
        """A number in the question's unit, or the number of a choice; it can be changed until the reveal."""
        if self.answer.stage == "revealed":
            raise Usage("the answer is already told; ask again to guess again.")
        self.visit.answer = prediction.guessed(self.current.step.ask, guess)
        self.revision += 1

    def reveal(self, **data) -> Answer:
        """Tell the truth and show its state; without a guess it is told all the same. `data`: a mesh's triangles."""
        truth = prediction.truth(self.current, **data)
        self.freeze(False)
        self.visit.answer = prediction.revealed(self.answer, truth)
        if self.current.step.ask.sets:
            self.change(prediction.truth_values(self.current), self.view)
        self.revision += 1
        if self.progress and not self.current.id.startswith(BOARD):
            self.progress.put_answer(self.current.id, self.answer.guess, self.answer.choice, truth)
        self.save()
        return self.answer

    def ask_again(self) -> None:
        self.visit.answer = Answer()
        self.revision += 1


def unpacked(state: State) -> tuple[dict[str, Number], View]:
    return dict(state.values), state.view


def answer_of(found: LoadedStep, kept: dict | None) -> Answer:
    """An answer as the progress file has it, if it still fits the question."""
    if not kept or not isinstance(kept.get("truth"), int | float):
        return Answer()
    given = kept.get("choice") if found.step.ask.choices else kept.get("guess")
    answer = prediction.guessed(found.step.ask, given) if isinstance(given, int | float) else Answer()
    return prediction.revealed(answer, float(kept["truth"]))
