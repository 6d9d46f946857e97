"""Values as a program's uniforms."""

from typing import Any, cast

import moderngl
import numpy as np

from app.lesson import Scene


def give(use: moderngl.Program, **values) -> None:
    """Set the uniforms a program has among the given ones."""
    for name, value in values.items():
        if name not in use:
            continue
        uniform = cast(Any, use[name])
        if isinstance(value, bytes):
            uniform.write(value[:uniform.element_size * uniform.array_length])
        else:
            uniform.value = value


def on_gpu(scene: Scene, values: dict) -> dict:
    """The step's values as uniforms, and which maps are the user's; data that is no uniform (a mesh) stays behind."""
    found = {name: value for name, value in values.items() if not isinstance(value, np.ndarray)}
    return found | {table.given: int(values[table.uniform][0, 0, 3] > 0) for table in scene.tables
                    if table.given and table.uniform in values}
