"""Formulas as pictures, drawn by imgui-bundle's MicroTeX without a window; in a child process, because it may crash.

`python -m app.export.formulas` reads {"size", "colour", "formulas": [[latex, display], ...]} and answers a list of
{"png", "width", "height", "depth"} (base64, pixels) or {"fault"}.
"""

import base64
import json
import subprocess
import sys
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path

from app.paths import ROOT

RED = (255, 0, 0)  # MicroTeX draws a macro it does not know in this colour


@dataclass(frozen=True)
class Picture:
    """A formula's PNG with its size in parts of the font's size: what a page needs to put it on the line."""

    png: bytes
    width: float
    height: float
    depth: float  # below the base line


def pictures(formulas: list[tuple[str, bool]], colour: str, size: int = 48) -> list[Picture | None]:
    """A picture for each (latex, display); None for one that could not be drawn, or all when the child died."""
    if not formulas:
        return []
    wish = json.dumps({"size": size, "colour": colour, "formulas": formulas})
    try:
        child = subprocess.run([sys.executable, "-m", "app.export.formulas"], input=wish, capture_output=True,
                               text=True, encoding="utf-8", timeout=60, check=True, cwd=ROOT)
        answers = json.loads(child.stdout)
    except (subprocess.SubprocessError, OSError, ValueError):
        return [None] * len(formulas)
    return [None if "fault" in a else Picture(base64.b64decode(a["png"]), a["width"] / size, a["height"] / size,
                                              a["depth"] / size) for a in answers]


def draw(wish: dict) -> list[dict]:
    """The child's work."""
    import imgui_bundle  # noqa: TID251 - only its formulas, no window
    import numpy as np
    from imgui_bundle import imgui_microtex  # noqa: TID251
    from PIL import Image

    from app import locale_alias

    locale_alias.ensure()
    if not imgui_microtex.is_initialized():
        fonts = Path(imgui_bundle.__file__).parent / "assets" / "fonts" / "latex" / "latinmodern-math"
        imgui_microtex.init(f"{fonts}.clm1", f"{fonts}.otf")
    red, green, blue = (int(wish["colour"][i:i + 2], 16) for i in (1, 3, 5))
    answers: list[dict] = []
    for latex, display in wish["formulas"]:
        style = imgui_microtex.TexStyle.display if display else imgui_microtex.TexStyle.text
        try:
            drawn = imgui_microtex.render(latex, float(wish["size"]), 0xFF000000 | blue << 16 | green << 8 | red, style)
        except RuntimeError as error:
            answers.append({"fault": str(error)})
            continue
        pixels = np.array(drawn.pixels_as_array())
        solid = pixels[pixels[..., 3] > 128]
        if not len(solid):
            answers.append({"fault": "nothing is drawn"})
        elif (solid[:, :3] == RED).all(-1).any() and (red, green, blue) != RED:
            answers.append({"fault": "a macro is unknown"})
        else:
            out = BytesIO()
            Image.fromarray(pixels).save(out, "PNG")
            answers.append({"png": base64.b64encode(out.getvalue()).decode(), "width": drawn.width,
                            "height": drawn.height, "depth": drawn.depth})
    return answers


if __name__ == "__main__":
    sys.stdin.reconfigure(encoding="utf-8")  # type: ignore[union-attr]
    json.dump(draw(json.load(sys.stdin)), sys.stdout)
