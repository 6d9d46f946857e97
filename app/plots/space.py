"""What the plots in space share: camera, light, grids of points, words at points."""

import math
from typing import Any

import numpy as np
import pyvista as pv

from app.camera import position
from app.lesson import Camera


def aim(plotter: pv.Plotter, camera: Camera) -> None:
    """The lesson's camera; a picture taller than wide keeps the horizontal field of view, as the scene does."""
    width, height = plotter.window_size
    eye, target = position(camera), np.asarray(camera.target, float)
    a = math.radians(camera.azimuth)
    side = np.array([-math.sin(a), math.cos(a), 0.0])
    up = np.cross(side, (target - eye) / np.linalg.norm(target - eye))
    half = math.tan(math.radians(camera.field_of_view) / 2) / min(1.0, width / height)
    view = plotter.camera
    view.position, view.focal_point, view.up = tuple(eye), tuple(target), tuple(up)
    view.view_angle = math.degrees(2 * math.atan(half))


def light(plotter: pv.Plotter) -> None:
    """A soft key light over the viewer's left shoulder and a fill from the right; they turn with the camera."""
    for place, strength in (((-0.5, 0.7, 1.0), 0.8), ((0.8, 0.1, 0.6), 0.3)):
        plotter.add_light(pv.Light(position=place, light_type="camera light", intensity=strength))


def on_picture(plotter: pv.Plotter, points: np.ndarray) -> np.ndarray:
    """Where points (n, 3) are in the picture, px from its top left."""
    width, height = plotter.window_size
    matrix = plotter.camera.GetCompositeProjectionTransformMatrix(width / height, -1, 1)
    full = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
    clip = np.column_stack([points, np.ones(len(points))]) @ full.T
    flat = clip[:, :2] / clip[:, 3:]
    return np.column_stack([(0.5 + 0.5 * flat[:, 0]) * width, (0.5 - 0.5 * flat[:, 1]) * height])


def grid_faces(rows: int, columns: int) -> np.ndarray:
    """Two triangles for each cell of a grid of points (rows, columns), as VTK wants them."""
    i, j = np.meshgrid(np.arange(rows - 1), np.arange(columns - 1), indexing="ij")
    a, b = (i * columns + j).ravel(), (i * columns + j + 1).ravel()
    c, d = a + columns, b + columns
    three = np.full(len(a), 3)
    return np.stack([three, a, c, d, three, a, d, b], -1).reshape(-1, 4)


def grid_normals(points: np.ndarray) -> np.ndarray:
    """Unit normals of a grid (rows, columns, 3); 0 where it has none."""
    normals = np.cross(np.gradient(points, axis=0), np.gradient(points, axis=1))
    return normals / np.maximum(np.linalg.norm(normals, axis=-1, keepdims=True), 1e-30)


def fill(array: Any, values: np.ndarray) -> None:
    """New numbers into an array that VTK draws from."""
    array[...] = values


def polyline(points: np.ndarray) -> pv.PolyData:
    """Lines (count, points, 3) as one thing to draw."""
    count, each = points.shape[:2]
    index = np.arange(count * each).reshape(count, each)
    lines = np.column_stack([np.full(count, each), index]).ravel()
    return pv.PolyData(points.reshape(-1, 3).astype(np.float32), lines=lines)
