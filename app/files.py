"""Files that are whole or not there."""

import os
import tempfile
from pathlib import Path

from app.problem import Problem


def write(path: Path, data: bytes) -> None:
    """The file with this content, all at once: a reader sees the old file or the new one."""
    name = ""
    try:
        handle, name = tempfile.mkstemp(prefix=f".{path.name}.", dir=path.parent)
        with os.fdopen(handle, "wb") as out:
            out.write(data)
        os.chmod(name, 0o666 & ~umask())
        os.replace(name, path)
    except OSError as error:
        raise Problem(f"{path} cannot be written: {reason(error)}.") from None
    finally:
        if name and os.path.exists(name):
            os.unlink(name)


def umask() -> int:
    now = os.umask(0o022)
    os.umask(now)
    return now


def reason(error: OSError) -> str:
    return (error.strerror or type(error).__name__).lower()
