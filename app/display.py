"""Whether a window can open; without DISPLAY nothing of the window is imported."""

import os
import sys
from importlib import import_module


def has_display() -> bool:
    if sys.platform.startswith("linux") and not os.environ.get("DISPLAY"):
        return False
    return bool(import_module("app.viewer.glfw").has_display())
