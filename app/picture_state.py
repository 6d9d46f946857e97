"""The state that a picture of ours carries: what was drawn, to open it again. Standard library only."""

import struct
from pathlib import Path

from app.problem import Usage

KEY = "halfway:state"
HEAD = b"\x89PNG\r\n\x1a\n"


def state_in(path: str | Path) -> str:
    """The state string in a PNG's text; "" where there is none, or where the file is no PNG."""
    try:
        data = Path(path).expanduser().read_bytes()
    except OSError as error:
        raise Usage(f"{path} cannot be read: {(error.strerror or 'an error').lower()}.") from None
    at = len(HEAD)
    while data.startswith(HEAD) and at + 8 <= len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body, at = data[at + 8:at + 8 + size], at + 12 + size
        name, _, rest = body.partition(b"\0")
        if kind == b"iTXt" and name.decode("latin-1") == KEY and rest[:1] == b"\0":  # not compressed
            return rest[2:].split(b"\0", 2)[2].decode(errors="replace")
        if kind == b"tEXt" and name.decode("latin-1") == KEY:
            return rest.decode("latin-1")
    return ""


def is_picture(text: str) -> bool:
    """Whether a person named a picture where a state is wanted."""
    return text.lower().endswith((".png", ".jpg", ".jpeg", ".webp", ".gif", ".avif"))


def state_of(text: str) -> str:
    """The state in a picture that must have one."""
    found = state_in(text)
    if not found:
        raise Usage(f"{text} carries no state; a PNG of `halfway render` or of an exported page does.")
    return found
