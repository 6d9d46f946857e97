"""The polygon of the lesson: up to five corners to drag, in a plane that faces the eye."""

import numpy as np

from app.optics.solid_angle import _dot, solid_angle_polygon_naive, solid_angle_triangle_edges


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
    """The solid angle of the outline seen from (x, y, 0), by a fan of triangles given by their edges.

    |sum of solid_angle_triangle_edges(a, size (P_i - P), size (P_i+1 - P))|, P the corner nearest to the eye,
    a = (size P - (x, y), distance)

    corner_a .. corner_e (..., 2), corner_count (...) 3 .. 5, size, distance, x, y (...) m. Returns (...) sr.
    Errors: none. Source: van Oosterom and Strackee 1983, The Solid Angle of a Plane Triangle.
    """
    fan, used = _fan((corner_a, corner_b, corner_c, corner_d, corner_e), corner_count, size, distance, x, y)
    return np.abs(np.sum(np.where(used, solid_angle_triangle_edges(*fan), 0), -1))


def _fan(around, corner_count, size, distance, x, y):
    """(..., 3) triangles of the outline from its nearest corner as (a, ab, ac), and which of them are used."""
    points = _corners(around, size, distance, x, y)
    count = np.broadcast_to(corner_count, points.shape[:-2])[..., None]
    away = np.where(np.arange(5) < count, _dot(points, points), np.inf)
    order = (np.argmin(away, -1)[..., None] + np.arange(5)) % count
    flat = np.stack(np.broadcast_arrays(*(np.asarray(corner, float) for corner in around)), -2)
    flat = np.take_along_axis(np.broadcast_to(flat, (*points.shape[:-1], 2)), order[..., None], -2)
    edges = _corners(np.moveaxis(flat - flat[..., :1, :], -2, 0), size, 0, 0, 0)
    nearest = np.take_along_axis(points, order[..., :1, None], -2)
    return (nearest, edges[..., 1:-1, :], edges[..., 2:, :]), np.arange(2, 5) < count


def solid_angle_outline_naive(corner_a, corner_b, corner_c, corner_d, corner_e, corner_count, size, distance, x, y):
    """The solid angle of the outline seen from (x, y, 0), by textbook triangles, which cancel for a small one.

    solid_angle_polygon_naive of the first corner_count corners (size corner - (x, y), distance)

    corner_a .. corner_e (..., 2), corner_count (...) 3 .. 5, size, distance, x, y (...) m. Returns (...) sr.
    Errors: those of solid_angle_triangle_naive. Source: van Oosterom and Strackee 1983 as printed.
    """
    corners = (corner_a, corner_b, corner_c, corner_d, corner_e)
    return solid_angle_polygon_naive(_corners(corners, size, distance, x, y), corner_count)
