"""The constant tables of scenes by name: the luminaires of lessons/ies, or the file a user brings."""

from functools import cache

import numpy as np

from app.ies import Photometry, read
from app.lesson import Scene
from app.maps import NONE, OwnMap
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


def chosen(scene: Scene, values: dict, own: Photometry | None = None, maps: dict[str, OwnMap] | None = None
           ) -> dict[str, np.ndarray]:
    """Uniform -> table for each table of a scene, as its values choose it; `own` replaces the built-in luminaire,
    `maps` (by their kind) are the user's."""
    return {table.uniform: texels(table.map, maps) if table.map else
            (own or built_in(table.files[int(values.get(table.choice, 0))])).table for table in scene.tables}


def texels(kind: str, maps: dict[str, OwnMap] | None) -> np.ndarray:
    return maps[kind].texels if maps and kind in maps else NONE


def has_luminaire(scene: Scene) -> bool:
    return any(table.files for table in scene.tables)


def has_maps(scene: Scene) -> bool:
    return any(table.map for table in scene.tables)
