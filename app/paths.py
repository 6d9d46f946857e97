"""Where the parts of the course lie, in a checkout and in an installed wheel alike."""

from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
GLSL = ROOT / "glsl"
LESSONS = ROOT / "lessons"
