"""The constant tables of scenes by name: the luminaires of lessons/ies, or the file a user brings."""

from functools import cache

import numpy as np

from app.ies import Photometry, read
from app.lesson import Scene
from app.paths import LESSONS
from app.problem import Usage, near

FOLDER = LESSONS / "ies"


def names() -> tuple[str, ...]:
    return tuple(sorted(path.stem for path in FOLDER.glob("*.ies")))


@cache
def built_in(name: str) -> Photometry:
    """One of the luminaires that come with the course."""
    if name not in names():
        raise Usage(f"There is no luminaire {name!r}.{near(name, names())}")
    return read(FOLDER / f"{name}.ies")


def chosen(scene: Scene, values: dict, own: Photometry | None = None) -> dict[str, np.ndarray]:
    """Uniform -> table for each table of a scene, as its values choose it; `own` replaces the built-in one."""
    return {table.uniform: (own or built_in(table.files[int(values.get(table.choice, 0))])).table
            for table in scene.tables}
