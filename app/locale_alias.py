"""The locale that LaTeX formulas need, on Linux systems that do not have it.

MicroTeX, which draws the formulas in imgui-bundle, makes std::locale("en_US.UTF-8") once in a process, at the first
formula that needs it. Where only C.UTF-8 is installed (minimal Debian, containers) that fails, and the formula becomes
red source text. `ensure` gives C.UTF-8 that name through LOCPATH for as long as one formula takes to draw, two
milliseconds: MicroTeX keeps the locale. So LOCPATH never reaches a child process, where it would hide the system's
other locales (locale(7)); a child that draws formulas calls `ensure` itself.
"""

import ctypes
import os
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import Literal

NEEDED = "en_US.UTF-8"
SOURCES = tuple(Path("/usr/lib/locale") / name for name in ("C.utf8", "C.UTF-8", "en_GB.utf8"))
ALL = 8127  # LC_ALL_MASK of glibc: the twelve categories
Outcome = Literal["not needed", "present", "aliased", "missing"]


@cache
def ensure() -> Outcome:
    """Call it before the first formula of the process. With 'missing' formulas will fail: say so (`halfway doctor`)."""
    if not sys.platform.startswith("linux"):
        return "not needed"
    if present():
        return "present"
    for source in SOURCES:
        if source.is_dir():
            with named(source):
                if present() and draws():
                    return "aliased"
    return "missing"


def present() -> bool:
    """Can this process have the locale now?"""
    libc = ctypes.CDLL(None)
    libc.newlocale.restype, libc.newlocale.argtypes = ctypes.c_void_p, [ctypes.c_int, ctypes.c_char_p, ctypes.c_void_p]
    libc.freelocale.argtypes = [ctypes.c_void_p]
    found = libc.newlocale(ALL, NEEDED.encode(), None)
    if found:
        libc.freelocale(found)
    return bool(found)


@contextmanager
def named(source: Path) -> Iterator[None]:
    """LOCPATH leads to a folder where `source` is called NEEDED; afterwards all is as before."""
    before = os.environ.get("LOCPATH")
    with tempfile.TemporaryDirectory(prefix="halfway-locale-") as folder:
        (Path(folder) / NEEDED).symlink_to(source)
        os.environ["LOCPATH"] = f"{folder}:{before or '/usr/lib/locale'}"
        try:
            yield
        finally:
            if before is None:
                del os.environ["LOCPATH"]
            else:
                os.environ["LOCPATH"] = before


def draws(formula: str = r"a = b") -> bool:
    """Draw a formula without a window, and see whether there is ink; the first one fixes MicroTeX's locale."""
    import imgui_bundle  # noqa: TID251 - only its formulas, no window
    import numpy as np
    from imgui_bundle import imgui_microtex  # noqa: TID251

    fonts = Path(imgui_bundle.__file__).parent / "assets" / "fonts" / "latex" / "latinmodern-math"
    imgui_microtex.init(f"{fonts}.clm1", f"{fonts}.otf")
    try:
        picture = imgui_microtex.render(formula, 24.0, 0xFF000000, imgui_microtex.TexStyle.display)
    except RuntimeError:
        return False
    return int(np.asarray(picture.pixels_as_array()).astype(int)[..., 3].max(initial=0)) > 128
