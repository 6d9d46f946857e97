"""Where a picture goes and how large it is: what was typed, checked, and files that are whole or not there."""

import re
from pathlib import Path

from app.files import reason, write
from app.problem import Problem, Usage

__all__ = ["make_folder", "path_of", "picture_path", "size_of", "write"]

SMALLEST, LARGEST = 64, 8192  # px of a side


def size_of(text: str) -> tuple[int, int]:
    """1280x720 as (1280, 720)."""
    match = re.fullmatch(r"\s*(\d{1,9})\s*[x×*,]\s*(\d{1,9})\s*", text)
    if not match:
        raise Usage(f"--size {text} is no size; write width and height in pixels, like 1280x720.")
    width, height = int(match[1]), int(match[2])
    if not (SMALLEST <= width <= LARGEST and SMALLEST <= height <= LARGEST):
        raise Usage(f"--size {width}x{height}: each side has {SMALLEST} to {LARGEST} pixels.")
    return width, height


def picture_path(text: str | Path) -> Path:
    """A file to write a PNG to, in a folder that exists."""
    return path_of(text, (".png",), "stills are PNG files")


def path_of(text: str | Path, endings: tuple[str, ...], why: str) -> Path:
    """A file to write to, with one of the endings, in a folder that exists."""
    path = Path(text).expanduser()
    if path.suffix.lower() not in endings:
        raise Usage(f"{path} does not end in {' or '.join(endings)}; {why}.")
    if path.is_dir():
        raise Usage(f"{path} is a folder; name a file in it.")
    if not path.parent.is_dir():
        raise Usage(f"there is no folder {path.parent}; make it first, or write somewhere else.")
    return path


def make_folder(text: str | Path) -> Path:
    path = Path(text).expanduser()
    try:
        path.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise Problem(f"the folder {path} cannot be made: {reason(error)}.") from None
    return path
