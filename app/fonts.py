"""The font of pictures and plots, found without importing the packages it comes with."""

from functools import cache
from importlib.util import find_spec
from pathlib import Path

FONTS = (  # package, folder, (upright, bold): DejaVu has every sign the course writes, Greek letters and powers too
    ("matplotlib", "mpl-data/fonts/ttf", ("DejaVuSans.ttf", "DejaVuSans-Bold.ttf")),  # comes with pyvista
    ("imgui_bundle", "assets/fonts/Roboto", ("Roboto-Regular.ttf", "Roboto-Bold.ttf")),
)


@cache
def font_files() -> tuple[Path, Path] | None:
    """The upright and the bold font."""
    for package, folder, names in FONTS:
        spec = find_spec(package)
        for base in (spec.submodule_search_locations or []) if spec else []:
            upright, bold = (Path(base) / folder / name for name in names)
            if upright.is_file() and bold.is_file():
                return upright, bold
    return None
