"""What was graded, kept so that a killed run goes on where it was: one JSON file a key, and a journal.

A key is a hash of everything that decides a result; the same key always has the same bytes. Times and hosts are in the
journal alone, so that what students see does not depend on them.
"""

import hashlib
import json
import os
import secrets
import time
from pathlib import Path

from app.problem import Problem, Usage

FOLDER = "store"


def key_of(**parts: str) -> str:
    return hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()


def durable(path: Path, data: bytes) -> None:
    """The file with this content, on the disk: a temporary file, then a rename; after a power cut whole or absent."""
    path.parent.mkdir(parents=True, exist_ok=True)
    other = path.with_name(f".{path.name}.{os.getpid()}-{secrets.token_hex(4)}")
    try:
        with open(other, "xb") as out:
            out.write(data)
            out.flush()
            os.fsync(out.fileno())
        os.replace(other, path)
        settle(path.parent)
    except OSError as error:
        raise Problem(f"{path} cannot be written: {(error.strerror or type(error).__name__).lower()}.") from None
    finally:
        other.unlink(missing_ok=True)


def settle(folder: Path) -> None:
    """A folder's own entries on the disk, where the system has that."""
    if hasattr(os, "O_DIRECTORY"):
        handle = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)


def as_bytes(value: dict) -> bytes:
    return (json.dumps(value, allow_nan=False, sort_keys=True, indent=1) + "\n").encode()


class Store:
    """Of one folder of results."""

    def __init__(self, results: Path, resume: bool, seed: str = "") -> None:
        self.folder = results / FOLDER
        if self.folder.exists() and not resume:
            raise Usage(f"{results} holds results already; go on with --resume, or name another folder.")
        self.folder.mkdir(parents=True, exist_ok=True)
        self.seed = self.kept_seed(seed)
        for left in self.folder.glob("*/.*"):  # of a run that was killed while it wrote
            left.unlink(missing_ok=True)
        self.journal = open(self.folder / "journal.jsonl", "a", encoding="utf-8")  # noqa: SIM115 - closed by close

    def kept_seed(self, seed: str) -> str:
        """The seed of the hidden points: one for the class, the same after a resume."""
        path = self.folder / "seed"
        if path.exists():
            kept = path.read_text("utf-8").strip()
            if seed and seed != kept:
                raise Usage(f"--seed {seed} is not the seed that {path} began with; name another folder of results.")
            return kept
        seed = seed or secrets.token_hex(16)
        durable(path, f"{seed}\n".encode())
        path.chmod(0o600)
        return seed

    def path(self, key: str) -> Path:
        return self.folder / key[:2] / f"{key}.json"

    def get(self, key: str) -> dict | None:
        try:
            return json.loads(self.path(key).read_bytes())
        except FileNotFoundError:
            return None
        except ValueError:
            raise Problem(f"{self.path(key)} is damaged; delete it, then it is graded anew.") from None

    def put(self, key: str, body: dict, side: dict) -> None:
        """`ungraded` is not kept: the next run tries again."""
        if body["verdict"] != "ungraded":
            durable(self.path(key), as_bytes(body))
        self.note(key=key, verdict=body["verdict"], finished=time.time(), **side)

    def note(self, **what) -> None:
        self.journal.write(json.dumps(what) + "\n")
        self.journal.flush()

    def close(self) -> None:
        self.journal.close()
