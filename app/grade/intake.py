"""What a student handed in: a folder, a file or an archive, read into memory and never unpacked onto the disk.

Only `submission.py` and `submission.glsl` are looked at; what cannot be read without doubt is refused with a reason.
"""

import hashlib
import os
import re
import stat
import unicodedata
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

from app.grade import archives
from app.grade.archives import MOST_BYTES, Refused
from app.grade.question import FILES
from app.problem import Usage

SUFFIXES = {Path(name).suffix: name for name in FILES.values()}
NOISE = {"__MACOSX", "__pycache__", ".DS_Store", "Thumbs.db", "desktop.ini"}
NOT_SOURCE = {".pyc": "compiled Python", ".pyo": "compiled Python", ".so": "a library", ".pyd": "a library",
              ".dll": "a library", ".pth": "a path file", ".pyi": "a file of types", ".ipynb": "a notebook",
              ".spv": "compiled GLSL"}
COOKIE = re.compile(r"^[ \t\f]*#.*?coding[:=][ \t]*([-\w.]+)")
BIDI = "\u202a-\u202e\u2066-\u2069\u200e\u200f\u061c"  # marks that turn the direction of writing
UNSEEN = re.compile(f"[\x00-\x08\x0b\r\x0e-\x1f\x7f-\x9f\u2028\u2029\ufeff{BIDI}]")


@dataclass(frozen=True)
class Submission:
    """The files as they came, and why the whole was refused, if it was."""

    student: str
    files: dict[str, bytes] = field(default_factory=dict, hash=False)
    refused: str = ""

    @cached_property
    def hash(self) -> str:
        """Of names and contents alone, so that the same text has the same hash whoever hands it in."""
        whole = hashlib.sha256(self.refused.encode())
        for name, data in sorted(self.files.items()):
            whole.update(f"{name} {len(data)} ".encode() + data)
        return whole.hexdigest()

    @cached_property
    def texts(self) -> dict[str, str]:
        """Decoded, without a byte order mark, lines ending in LF; only where `faults` has nothing."""
        return {name: data.decode("utf-8-sig").replace("\r\n", "\n") for name, data in self.files.items()
                if name not in self.faults}

    @cached_property
    def faults(self) -> dict[str, str]:
        """File -> why it is refused as a text."""
        found = {name: text_fault(name, data) for name, data in self.files.items()}
        return {name: why for name, why in found.items() if why}


def text_fault(name: str, data: bytes) -> str:
    """Why these bytes are no source text, or ''."""
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        place = data.count(b"\n", 0, error.start) + 1
        return f"{name}, line {place}: it is not written in UTF-8; save it as UTF-8."
    text = text.replace("\r\n", "\n")
    unseen = UNSEEN.search(text)
    if unseen:
        what = "a carriage return within the line" if unseen[0] == "\r" else "a character that cannot be seen"
        number = text.count("\n", 0, unseen.start()) + 1
        return f"{name}, line {number}: {what} (U+{ord(unseen[0]):04X}); type the line anew."
    for number, line in enumerate(text.split("\n", 2)[:2] if name.endswith(".py") else (), 1):
        cookie = COOKIE.match(line)
        if cookie and cookie[1].lower().replace("_", "-") not in ("utf-8", "utf8", "ascii", "us-ascii", "utf-8-sig"):
            return f"{name}, line {number}: it claims the encoding {cookie[1][:40]}; source is read as UTF-8."
    return ""


# --- where submissions lie -------------------------------------------------------------------------------------------
def students(place: str | Path) -> dict[str, list[Path]]:
    """Student -> what he handed in: every entry of a folder, by its name without the ending; or one file alone."""
    root = Path(place).expanduser()
    if not root.exists():
        raise Usage(f"there is nothing at {root}; name a folder of submissions.")
    if not root.is_dir():
        return {student_of(root): [root]}
    found: dict[str, list[Path]] = {}
    for entry in sorted(root.iterdir()):
        if entry.name not in NOISE and not entry.name.startswith("."):
            found.setdefault(student_of(entry), []).append(entry)
    if any(entry.name in FILES.values() for entries in found.values() for entry in entries):
        return {printable(root.resolve().name): [root]}  # the folder of one student
    if not found:
        raise Usage(f"the folder {root} is empty; it should hold a file, folder or archive for each student.")
    return found


def student_of(path: Path) -> str:
    name = path.name
    if not path.is_dir():
        for ending in (*archives.ENDINGS, *SUFFIXES, *NOT_SOURCE):
            if name.lower().endswith(ending) and len(name) > len(ending):
                name = name[:-len(ending)]
                break
    return printable(name)


def printable(name: str) -> str:
    """A name that can stand in a table: NFC, without what cannot be printed."""
    name = unicodedata.normalize("NFC", name.encode("utf-8", "replace").decode("utf-8"))
    return "".join(c if c.isprintable() else "?" for c in name)[:200]


def read(student: str, entries: list[Path]) -> Submission:
    """What one student handed in; nothing that is wrong with it is an exception."""
    try:
        files: dict[str, bytes] = {}
        for entry in entries:
            for name, data in of_entry(entry).items():
                if name in files:
                    raise Refused(f"{name} was handed in twice, in {' and '.join(e.name for e in entries)}.")
                files[name] = data
        return Submission(student, files)
    except Refused as refused:
        return Submission(student, refused=printable(str(refused))[:500])
    except OSError as error:
        return Submission(student, refused=f"it cannot be read: {(error.strerror or 'no reason given').lower()}.")


def of_entry(entry: Path) -> dict[str, bytes]:
    if stat.S_ISDIR(os.lstat(entry).st_mode):
        return of_folder(entry)
    if entry.name.lower().endswith(archives.ENDINGS):
        return chosen(archives.members(entry.name, regular(entry, MOST_BYTES)))
    suffix = entry.suffix.lower()
    if suffix in SUFFIXES:
        return {SUFFIXES[suffix]: regular(entry, archives.MOST_OF_ONE)}
    raise Refused(f"{entry.name} is {NOT_SOURCE.get(suffix, 'neither a source text nor an archive')}; hand in "
                  f"{' or '.join(FILES.values())}.")


def of_folder(folder: Path) -> dict[str, bytes]:
    """The names looked for, at most three folders down; links are not followed."""
    found: dict[str, Path] = {}
    for here, below, names in os.walk(folder):
        depth = len(Path(here).relative_to(folder).parts)
        below[:] = sorted(name for name in below if name not in NOISE and depth < 3)
        for name in sorted(names):
            if name not in NOISE:
                found[(Path(here) / name).relative_to(folder).as_posix()] = Path(here) / name
        if len(found) > archives.MOST_MEMBERS:
            raise Refused(f"it holds more than {archives.MOST_MEMBERS} files.")
    if not any(Path(name).name in FILES.values() for name in found):
        packed = [path for name, path in found.items() if name.lower().endswith(archives.ENDINGS)]
        if len(packed) == 1:
            return of_entry(packed[0])
    wanted = {name: path for name, path in found.items() if Path(name).name in FILES.values()}
    return chosen({name: regular(path, archives.MOST_OF_ONE) if name in wanted else b""
                   for name, path in found.items()})


def chosen(members: dict[str, bytes]) -> dict[str, bytes]:
    """The files looked for among all: each once; if there is none, what was handed in instead is told."""
    found: dict[str, bytes] = {}
    for path, data in members.items():
        name = path.rpartition("/")[2]
        if name in FILES.values():
            if name in found:
                raise Refused(f"it holds two files {name}.")
            found[name] = data
    if not found:
        for path in members:
            what = NOT_SOURCE.get(Path(path).suffix.lower())
            if what:
                raise Refused(f"{path} is {what}; hand in {' or '.join(FILES.values())}.")
    return found


def regular(path: Path, most: int) -> bytes:
    """A regular file's bytes, not through a link."""
    try:
        handle = os.open(path, os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0))
    except OSError as error:
        raise Refused(f"{path.name} cannot be read: {(error.strerror or '').lower()}.") from None
    with os.fdopen(handle, "rb") as file:
        facts = os.fstat(handle)
        if not stat.S_ISREG(facts.st_mode):
            raise Refused(f"{path.name} is no ordinary file.")
        data = file.read(most + 1)
    if len(data) > most:
        raise Refused(f"{path.name} is larger than {most >> 20} MB.")
    return data
