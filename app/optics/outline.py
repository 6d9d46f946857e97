"""The polygon of the lesson: up to five corners to drag, in a plane that faces the eye."""

import numpy as np

from app.optics.solid_angle_flat import solid_angle_face, solid_angle_polygon_naive


def _corners(corners, size, distance, x, y):
    """(..., 5, 3) m, from the eye at (x, y, 0)."""
    size, distance, x, y = np.broadcast_arrays(*(np.asarray(v, float) for v in (size, distance, x, y)))
    points = [np.asarray(corner, float) * size[..., None] - np.stack([x, y], -1) for corner in corners]
    plane = np.stack(np.broadcast_arrays(*points), -2)
    height = np.broadcast_to(distance[..., None, None], (*plane.shape[:-1], 1))
    return np.concatenate([plane, height], -1)


def outline_corner(corner_a, corner_b, corner_c, corner_d, corner_e, corner_count, size, distance, index):
    """A corner of the outline, counted around: index corner_count is corner 0 again.

    (size corner, distance)

    corner_a .. corner_e (..., 2), corner_count (...) 3 .. 5, size, distance (...) m, index (...) >= 0.
    Returns (..., 3) m. Errors: none. Source: deck, Solid Angles.
    """
    corners = _corners((corner_a, corner_b, corner_c, corner_d, corner_e), size, distance, 0, 0)
    index = np.asarray(index) % np.asarray(corner_count)
    shape = np.broadcast_shapes(corners.shape[:-2], index.shape)
    corners = np.broadcast_to(corners, (*shape, 5, 3))
    return np.take_along_axis(corners, np.broadcast_to(index, shape)[..., None, None], -2)[..., 0, :]


def solid_angle_outline(corner_a, corner_b, corner_c, corner_d, corner_e, corner_count, size, distance, x, y):
    """The solid angle of the outline seen from (x, y, 0), by a fan of faces from its first corner.

    |sum over i of solid_angle_face(P_1, P_i, P_i+1, (x, y, 0))|, P_i = (size corner_i, distance)

    corner_a .. corner_e (..., 2), corner_count (...) 3 .. 5, size, distance, x, y (...) m. Returns (...) sr.
    Errors: none. Source: van Oosterom and Strackee 1983, The Solid Angle of a Plane Triangle.
    """
    faces, used = _fan((corner_a, corner_b, corner_c, corner_d, corner_e), corner_count, size, distance, x, y)
    return np.abs(np.sum(np.where(used, solid_angle_face(**faces), 0), -1))


def _fan(around, corner_count, size, distance, x, y):
    """The faces of the fan as arguments of solid_angle_face, (..., 3) of them, and which of them are used."""
    corners = _corners(around, size, distance, 0, 0)
    x, y = np.broadcast_arrays(np.asarray(x, float), np.asarray(y, float))
    eye = np.stack([x, y, np.zeros(x.shape)], -1)[..., None, :]
    faces = {"a": corners[..., :1, :], "b": corners[..., 1:-1, :], "c": corners[..., 2:, :], "eye": eye}
    return faces, np.arange(2, 5) < np.asarray(corner_count)[..., None]


def solid_angle_outline_naive(corner_a, corner_b, corner_c, corner_d, corner_e, corner_count, size, distance, x, y):
    """The solid angle of the outline seen from (x, y, 0), by textbook triangles, which cancel for a small one.

    solid_angle_polygon_naive of the first corner_count corners (size corner - (x, y), distance)

    corner_a .. corner_e (..., 2), corner_count (...) 3 .. 5, size, distance, x, y (...) m. Returns (...) sr.
    Errors: those of solid_angle_triangle_naive. Source: van Oosterom and Strackee 1983 as printed.
    """
    corners = (corner_a, corner_b, corner_c, corner_d, corner_e)
    return solid_angle_polygon_naive(_corners(corners, size, distance, x, y), corner_count)
