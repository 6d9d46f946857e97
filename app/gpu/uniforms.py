"""Values as a program's uniforms."""

from typing import Any, cast

import moderngl
import numpy as np

from app.lesson import Scene


def give(use: moderngl.Program, **values) -> None:
    """Set the uniforms a program has among the given ones."""
    known = use.extra = use.extra or {name: use[name] for name in use}  # `in` a program goes through all its names
    for name in known.keys() & values.keys():
        uniform, value = cast(Any, known[name]), values[name]
        if isinstance(value, bytes):
            uniform.write(value[:uniform.element_size * uniform.array_length])
        else:
            uniform.value = value


def on_gpu(scene: Scene, values: dict) -> dict:
    """The step's values as uniforms, and which maps are the user's; data that is no uniform (a mesh) stays behind."""
    found = {name: value for name, value in values.items() if not isinstance(value, np.ndarray)}
    found |= {table.given: int(values[table.uniform][0, 0, 3] > 0) for table in scene.tables
              if table.given and table.uniform in values}
    return found | {"own_coordinates": int("texture_coordinates" in values)}
