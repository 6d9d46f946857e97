"""Progress and answers on disk: one JSON file in the user's data folder, written whole or not at all.

Every entry carries its time, so two windows can write in turn: each reads, merges (the newest entry wins) and replaces
the file. A damaged file is kept aside; a folder that cannot be written leaves the course running, unsaved, and says so.
"""

import json
import os
import time
from pathlib import Path
from typing import Any

TABLES = ("steps", "answers", "settings", "exercises")
VERSION = 1
PATIENCE = 0.5  # seconds to wait for another window
Data = dict[str, Any]


class Damaged(Exception):
    """The file is there, but it is no progress."""


class Progress:
    """What is remembered. Nothing here raises: `message` has the sentence when something could not be read or kept."""

    def __init__(self, folder: Path | str | None = None):
        self.folder = Path(folder) if folder else data_folder()
        self.file = self.folder / "progress.json"
        self.message = ""
        self.data: Data = {}
        try:
            self.data = self.read()
        except (OSError, Damaged) as error:
            self.message = f"Your progress in {self.file} could not be read ({reason(error)}); it is not kept."

    # --- what is remembered ------------------------------------------------------------------------------------------
    def state(self, step: str) -> str | None:
        """The step's state string when it was left last."""
        state = self.entry("steps", step).get("state")
        return state if isinstance(state, str) else None

    def visited(self, step: str) -> bool:
        return bool(self.entry("steps", step))

    def texts(self, step: str) -> tuple[dict[str, str], dict[str, str]]:
        """What was typed in the place of the step's functions, and what was put aside of it: name -> text."""
        entry = self.entry("steps", step)
        tables = (entry.get(name, {}) for name in ("texts", "aside"))
        one, two = ({k: v for k, v in t.items() if isinstance(v, str)} if isinstance(t, dict) else {} for t in tables)
        return one, two

    def answer(self, step: str) -> Data | None:
        """{"guess": ..., "choice": ..., "truth": ..., "when": seconds}, or None."""
        return self.entry("answers", step) or None

    def setting(self, name: str, otherwise: Any = None) -> Any:
        """"theme", "last_step", ... as last kept."""
        return self.entry("settings", name).get("value", otherwise)

    @property
    def first_start(self) -> bool:
        return not self.data.get("steps")

    def entry(self, table: str, key: str) -> Data:
        return self.data.get(table, {}).get(key, {})

    # --- what changes it ---------------------------------------------------------------------------------------------
    def put_state(self, step: str, state: str) -> None:
        self.put("steps", step, state=state)
        self.put("settings", "last_step", value=step)

    def put_texts(self, step: str, texts: dict[str, str], aside: dict[str, str]) -> None:
        if (texts, aside) != self.texts(step):
            self.put("steps", step, texts=dict(texts), aside=dict(aside))

    def put_answer(self, step: str, guess: float | None, choice: int | None, truth: float | None) -> None:
        self.put("answers", step, guess=guess, choice=choice, truth=truth)

    def put_setting(self, name: str, value: Any) -> None:
        self.put("settings", name, value=value)

    def put(self, table: str, key: str, **fields: Any) -> None:
        old = self.entry(table, key)
        self.data.setdefault(table, {})[key] = {**old, **fields, "when": max(time.time(), when(old))}

    # --- the file ----------------------------------------------------------------------------------------------------
    def save(self) -> bool:
        """Merge with what another window has written, and replace the file; False when it could not be kept."""
        from filelock import FileLock, Timeout

        self.message = ""
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
            with FileLock(self.folder / "progress.lock", timeout=PATIENCE):
                self.data = merged(self.read(), self.data)
                self.write()
        except Timeout:
            self.message = f"Another window is holding {self.file}; this one's progress is kept at the next step."
            return False
        except (OSError, Damaged) as error:
            self.message = f"Progress cannot be kept in {self.folder} ({reason(error)}); the course goes on unsaved."
            return False
        return True

    def read(self) -> Data:
        """The file's entries. A damaged one is put aside and leaves none; if it cannot be put aside, it is Damaged."""
        try:
            data = json.loads(self.file.read_bytes())
            if not sound(data):
                raise Damaged("it is not a progress file")
            return data
        except (FileNotFoundError, NotADirectoryError):
            return {}
        except (ValueError, RecursionError, Damaged):
            self.put_aside()
            return {}

    def put_aside(self) -> None:
        stem = f"progress.corrupt-{time.strftime('%Y%m%d-%H%M%S')}"
        names = (self.folder / f"{stem}{tail}.json" for tail in ("", *(f"-{i}" for i in range(2, 99))))
        aside = next(name for name in names if not name.exists())
        try:
            os.replace(self.file, aside)
        except FileNotFoundError:  # another window has just done it
            return
        except OSError as error:
            raise Damaged(f"it is damaged, and {reason(error)}") from error
        self.message = f"Your progress file was damaged and is kept as {aside}; the course starts a new one."

    def write(self) -> None:
        new = self.folder / "progress.json.new"  # one writer at a time, so one name
        text = json.dumps({**self.data, "version": max(VERSION, self.data.get("version", 0))}, indent=1, sort_keys=True)
        try:
            with open(new, "w", encoding="utf-8") as file:
                file.write(text + "\n")
                file.flush()
                os.fsync(file.fileno())
            os.replace(new, self.file)
        except OSError:
            new.unlink(missing_ok=True)
            raise


def data_folder() -> Path:
    if os.environ.get("HALFWAY_DATA"):
        return Path(os.environ["HALFWAY_DATA"])
    from platformdirs import user_data_path

    return user_data_path("halfway", appauthor=False)


def sound(data: object) -> bool:
    """An object whose tables we know hold entries; what a newer version has added is none of our business."""
    return (isinstance(data, dict) and isinstance(data.get("version", 0), int)
            and all(isinstance(data.get(table, {}), dict) for table in TABLES)
            and all(isinstance(entry, dict) for table in TABLES for entry in data.get(table, {}).values()))


def merged(disk: Data, mine: Data) -> Data:
    """Both, entry by entry: the newest wins, and fields only the other one has are kept."""
    both = {**mine, **disk}
    for table in TABLES:
        entries = dict(disk.get(table, {}))
        for key, entry in mine.get(table, {}).items():
            older, newer = sorted((entries.get(key, {}), entry), key=when)  # stable: at the same time, mine
            entries[key] = {**older, **newer}
        both[table] = entries
    return both


def when(entry: Data) -> float:
    time = entry.get("when", 0.0)
    return float(time) if isinstance(time, int | float) else 0.0


def reason(error: Exception) -> str:
    return (getattr(error, "strerror", None) or str(error) or type(error).__name__).lower().rstrip(".")
