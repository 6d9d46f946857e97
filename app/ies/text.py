"""The text of an LM-63 file: bytes to lines, the labels before TILT=, and the numbers after it with their lines."""

import re
from collections.abc import Callable
from pathlib import Path
from typing import NoReturn

from app.problem import Problem

BYTES = 32 << 20
LINE_END = re.compile("\r\n|\r|\n")
TILT = re.compile(r"^[ \t]*TILT[ \t]*=[ \t]*(.*?)[ \t]*$", re.I)
FIRST = re.compile(r"^\s*IES(?:NA)?\s*:?\s*(?:LM-?63-?)?\s*(\d{4}|\d{2})\s*$", re.I)
YEARS = {"86": 1986, "1986": 1986, "91": 1991, "1991": 1991, "95": 1995, "1995": 1995, "02": 2002, "2002": 2002,
         "19": 2019, "2019": 2019}
KEYWORD = re.compile(r"^\s*\[([^\]]*)\]\s?(.*)$")
REQUIRED = ("TEST", "TESTLAB", "ISSUEDATE", "MANUFAC")  # since 2002


def load(path: Path) -> bytes:
    """The bytes of a file a person named; Problem where there is none to read."""
    try:
        if path.is_dir():
            raise Problem(f"{path} is a folder; give one .ies file in it.")
        if not path.exists():
            raise Problem(f"There is no file {path}; give the path of an IES file (LM-63).")
        if not path.is_file():
            raise Problem(f"{path} is not a file on a disk; give the path of an IES file (LM-63).")
        if (size := path.stat().st_size) > BYTES:
            raise Problem(f"{path} has {size / 2**20:.0f} MB, and the limit is {BYTES >> 20} MB; "
                          "LM-63 data of 181 x 361 angles take less than one.")
        return path.read_bytes()
    except PermissionError:
        raise Problem(f"{path} may not be read; give yourself the right, for example with chmod u+r.") from None
    except (OSError, ValueError) as error:
        words = getattr(error, "strerror", None) or str(error)
        raise Problem(f"{path} could not be read ({words}); copy it to a local disk and try again.") from None


def decoded(name: str, data: bytes) -> list[str]:
    """The lines; a trailing Ctrl-Z of the days of DOS ends the text, accents may be UTF-8 or CP1252."""
    if data[:2] in (b"\xff\xfe", b"\xfe\xff"):
        data = data.decode("utf-16", errors="replace").encode()
    head, ctrl_z, tail = data.partition(b"\x1a")
    if ctrl_z and not tail.strip(b"\x1a\0 \r\n\t"):
        data = head
    if not data.strip():
        raise Problem(f"{name}, line 1: the file is empty; LM-63 asks for labels, a line TILT= and the numbers.")
    odd = re.search(rb"[\x00-\x08\x0e-\x1f]", data)
    if odd:
        line = len(LINE_END.findall(data[:odd.start()].decode("latin-1"))) + 1
        raise Problem(f"{name}, line {line}: the byte {odd[0][0]} is no text; LM-63 asks for a text file, and this one "
                      "is damaged or something else.")
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = data.decode("cp1252", errors="replace")
    return LINE_END.split(text)


class Header:
    """The lines up to TILT=: the standard, the labels or keywords, and what TILT says."""

    def __init__(self, name: str, lines: list[str], folder: Path | None):
        self.warnings: list[str] = []
        self.at = next((i for i, line in enumerate(lines) if TILT.match(line)), -1)
        if self.at < 0:
            last = len(lines) - (not lines[-1].strip())
            raise Problem(f"{name}, line {max(last, 1)}: no line begins with TILT=; LM-63 asks for TILT=NONE or "
                          "TILT=INCLUDE after the labels, so this is no IES file or its end is missing.")
        match = TILT.match(lines[self.at])
        assert match
        self.tilt = match[1].upper()
        if self.tilt not in ("NONE", "INCLUDE"):
            there = folder is not None and match[1] != "" and is_there(folder, match[1])
            told = "which lies beside it" if there else "which does not exist beside it"
            what = f"the file {match[1]!r}, {told}" if match[1] else "nothing"
            raise Problem(f"{name}, line {self.at + 1}: TILT= names {what}; LM-63 also allows TILT=NONE and "
                          "TILT=INCLUDE, and only these two are read here.")
        first = FIRST.match(lines[0])
        year = YEARS.get(first[1]) if first else 1986
        if year is None:
            self.warnings.append(f"{name}, line 1: {lines[0].strip()[:40]!r} is no year of LM-63 (1986, 1991, 1995, "
                                 "2002, 2019); it is read as 2002.")
        self.year: int = year or 2002
        self.labels = lines[1 if first else 0:self.at]
        self.keywords = self.read_keywords(name, 2 if first else 1)

    def read_keywords(self, name: str, number: int) -> dict[str, str]:
        found: dict[str, str] = {}
        last = ""
        for i, line in enumerate(self.labels, number):
            match = KEYWORD.match(line)
            if match and match[1].upper() != "MORE":
                last = match[1].upper()
                found[last] = f"{found[last]}\n{match[2].strip()}" if last in found else match[2].strip()
            elif match and last:
                found[last] += "\n" + match[2].strip()
            elif match:
                self.warnings.append(f"{name}, line {i}: [MORE] continues no keyword; LM-63 asks for one before it.")
        missing = [word for word in REQUIRED if word not in found]
        if self.year >= 2002 and missing:
            self.warnings.append(f"{name}, line {self.at + 1}: {', '.join(f'[{word}]' for word in missing)} "
                                 f"missing before it; LM-63-{self.year} requires {', '.join(REQUIRED)}.")
        return found


def is_there(folder: Path, name: str) -> bool:
    try:
        return (folder / name).is_file()
    except (OSError, ValueError):
        return False


class Numbers:
    """The numbers after TILT=, separated by blanks, commas and line ends, taken in order; each knows its line."""

    def __init__(self, name: str, lines: list[str], first: int):
        self.name, self.lines, self.first = name, lines, first  # `first`: the number of the first line
        self.words = " ".join(lines).replace(",", " ").split()
        self.at = 0

    def take(self, count: int, what: str) -> list[float]:
        words = self.words[self.at:self.at + count]
        if len(words) < count:
            raise Problem(f"{self.name}, line {self.line(len(self.words) - 1)}: the file ends after {len(words)} of "
                          f"{count} {what}; LM-63 asks for all that its counts promise, so it is cut short or a "
                          "count is wrong.")
        try:
            values = list(map(float, words))
        except ValueError:
            values = []
        total = sum(values) if values else 0.0
        if not values or total - total != 0.0 or any("_" in word for word in words):  # not finite
            bad = next(i for i, word in enumerate(words) if not is_number(word))
            self.refuse(self.at + bad, f"{words[bad][:30]!r} among the {what} is no number; LM-63 asks for "
                                       "finite decimal numbers")
        self.at += count
        return values

    def count(self, what: str, least: int, most: int) -> int:
        (value,) = self.take(1, what)
        if value != int(value) or not least <= value <= most:
            self.refuse(self.at - 1, f"the {what} is {value:g}; LM-63 asks for a whole number, here from {least} "
                                     f"to {most}")
        return int(value)

    def checked(self, what: str, good: Callable[[float], bool], rule: str) -> float:
        (value,) = self.take(1, what)
        if not good(value):
            self.refuse(self.at - 1, f"the {what} is {value:g}; LM-63 asks for {rule}")
        return value

    def line(self, index: int) -> int:
        """The line of a number; the line of TILT= where there is none before it."""
        seen = 0
        for number, text in enumerate(self.lines, self.first):
            seen += len(text.replace(",", " ").split())
            if seen > index:
                return number if index >= 0 else self.first - 1
        return self.first - 1 + len(self.lines)

    def refuse(self, index: int, words: str) -> NoReturn:
        raise Problem(f"{self.name}, line {self.line(index)}: {words}.")


def is_number(word: str) -> bool:
    try:
        value = float(word)
    except ValueError:
        return False
    return value - value == 0.0 and "_" not in word
