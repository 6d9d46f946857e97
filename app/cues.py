"""A talk as a list of stops: what is shown at each, from a cue file, a deck's pages or the course's own order.

A cue file is TOML:

    [[cue]]
    page = 12                              # of the deck; cues of the same page follow each other
    state = "fresnel/schlick?theta=60"
    plot = 2                               # of a step that has several
    sweep = "theta=0..89"                  # what Space plays, there and back in twice the seconds
    seconds = 6
    notes = "Ask before you move it."
"""

import tomllib
from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from pathlib import Path

from app.catalog import LoadedStep, step, steps
from app.motion import sweep
from app.paths import LESSONS
from app.problem import Problem, Usage, near
from app.state import parse


@dataclass(frozen=True)
class Stop:
    """Something to show: a state, a page of the deck, or both side by side."""

    state: str = ""  # "": the slide alone
    page: int = 0  # of the deck, from 1; 0: none
    plot: int = 1
    sweep: str = ""
    seconds: float = 4.0
    notes: str = ""

    def found(self, folder: Path = LESSONS) -> LoadedStep | None:
        return step(parse(self.state, folder).step, folder) if self.state else None


TYPES = {"state": str, "page": int, "plot": int, "sweep": str, "seconds": (int, float), "notes": str}


def read(path: str | Path, folder: Path = LESSONS) -> tuple[Stop, ...]:
    """The cues of a file, each tried out: what is wrong is told with its number before the talk, not in it."""
    path = Path(path).expanduser()
    try:
        data = tomllib.loads(path.read_text("utf-8"))
    except OSError as error:
        raise Usage(f"{path} cannot be read: {(error.strerror or 'an error').lower()}.") from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise Problem(f"{path} is no TOML: {error}.") from None
    cues = data.get("cue", [])
    if unknown := set(data) - {"cue"}:
        raise Problem(f"{path}: there is no {min(unknown)} in a cue file; it has [[cue]] tables.")
    if not isinstance(cues, list) or not cues or not all(isinstance(cue, dict) for cue in cues):
        raise Problem(f'{path} has no cues; write [[cue]] and state = "fresnel/schlick" for each.')
    return tuple(checked(cue, f"{path}, cue {i}", folder) for i, cue in enumerate(cues, 1))


def checked(cue: dict, where: str, folder: Path) -> Stop:
    known = [field.name for field in fields(Stop)]
    for name, value in cue.items():
        if name not in known:
            raise Problem(f"{where}: a cue has no {name}.{near(name, known)}")
        if not isinstance(value, TYPES[name]) or isinstance(value, bool):  # type: ignore[arg-type]
            raise Problem(f"{where}: {name} = {value!r} is not what a cue has there; see the head of app/cues.py.")
    stop = Stop(**cue)
    if not stop.state:
        raise Problem(f'{where} has no state; write one, like state = "fresnel/schlick".')
    if stop.page < 0 or not 0.2 <= stop.seconds <= 600:
        raise Problem(f"{where}: pages count from 1, and a sweep takes 0.2 to 600 seconds.")
    try:
        found = stop.found(folder)
        assert found
        if stop.sweep:
            sweep(stop.sweep, found, "sweep")
        if not 1 <= stop.plot <= len(found.step.plots):
            raise Problem(f"{found.id} has {len(found.step.plots)} plots, and {stop.plot} is none of them.")
    except Problem as problem:
        raise Problem(f"{where}: {problem}") from None
    return stop


def of_deck(cues: Sequence[Stop], pages: int) -> tuple[Stop, ...]:
    """Every page of a deck in order, with its cues; a page without one is shown alone."""
    beyond = [cue.page for cue in cues if cue.page > pages]
    if beyond:
        raise Problem(f"a cue is for page {beyond[0]}, and the deck has {pages} pages.")
    if cues and not any(cue.page for cue in cues):
        raise Problem("no cue names a page of the deck; write page = 12 in each, or leave --slides away.")
    return tuple(stop for page in range(1, pages + 1)
                 for stop in ([cue for cue in cues if cue.page == page] or [Stop(page=page)]))


def by_title(lines: Sequence[Sequence[str]], folder: Path = LESSONS) -> tuple[Stop, ...]:
    """Cues for a deck that has none: a page whose title a step of the course teaches gets that step, its first page
    only."""
    taught: dict[str, str] = {}
    for found in steps(folder):
        for title in found.step.slides:
            taught.setdefault(plain(title), found.id)
    cues: list[Stop] = []
    for page, text in enumerate(lines, 1):
        id = next((taught[plain(line)] for line in text[:3] if plain(line) in taught), "")
        if id and id not in {cue.state for cue in cues}:
            cues.append(Stop(id, page))
    return tuple(cues)


def plain(title: str) -> str:
    return "".join(c for c in title.casefold() if c.isalnum())


def beside(state: str, pages: int) -> tuple[Stop, ...]:
    """One state beside every page."""
    return tuple(Stop(state, page) for page in range(1, pages + 1))


def of_course(state: str, folder: Path = LESSONS) -> tuple[tuple[Stop, ...], int]:
    """The course's steps, and which of them to begin at, in that state."""
    all_steps = steps(folder)
    id = parse(state, folder).step if state else all_steps[0].id
    stops = [Stop(found.id) for found in all_steps]
    at = next((i for i, found in enumerate(all_steps) if found.id == id), None)
    if at is None:  # a board: no step of the course
        return (Stop(state),), 0
    stops[at] = replace(stops[at], state=state or id)
    return tuple(stops), at
