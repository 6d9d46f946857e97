"""The polygon of the lesson: up to five corners to drag, in a plane that faces the eye."""

import numpy as np

from app.optics.solid_angle import solid_angle_polygon_naive, solid_angle_triangle_edges


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

    |sum of solid_angle_triangle_edges(a, size (P_i - P_1), size (P_i+1 - P_1))|, a = (size P_1 - (x, y), distance)

    corner_a .. corner_e (..., 2), corner_count (...) 3 .. 5, size, distance, x, y (...) m. Returns (...) sr.
    Errors: none. Source: van Oosterom and Strackee 1983, The Solid Angle of a Plane Triangle.
    """
    first, others = np.asarray(corner_a, float), (corner_b, corner_c, corner_d, corner_e)
    a = _corners((first,), size, distance, x, y)[..., 0, :]
    b, c, d, e = (_corners((np.asarray(corner, float) - first,), size, 0, 0, 0)[..., 0, :] for corner in others)
    fourth, fifth = np.asarray(corner_count) > 3, np.asarray(corner_count) > 4
    return np.abs(solid_angle_triangle_edges(a, b, c) + fourth * solid_angle_triangle_edges(a, c, d)
                  + fifth * solid_angle_triangle_edges(a, d, e))


def solid_angle_outline_naive(corner_a, corner_b, corner_c, corner_d, corner_e, corner_count, size, distance, x, y):
    """The solid angle of the outline seen from (x, y, 0), by textbook triangles, which cancel for a small one.

    solid_angle_polygon_naive of the first corner_count corners (size corner - (x, y), distance)

    corner_a .. corner_e (..., 2), corner_count (...) 3 .. 5, size, distance, x, y (...) m. Returns (...) sr.
    Errors: those of solid_angle_triangle_naive. Source: van Oosterom and Strackee 1983 as printed.
    """
    corners = (corner_a, corner_b, corner_c, corner_d, corner_e)
    return solid_angle_polygon_naive(_corners(corners, size, distance, x, y), corner_count)
