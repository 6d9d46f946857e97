"""Solid angles of what is flat: rectangles, triangles, polygons, and the faces of a mesh."""

import numpy as np


def solid_angle_rectangle(width, depth, distance):
    """The solid angle of a rectangle that faces the eye, its centre on the axis.

    4 atan(width depth / (2 distance sqrt(4 distance^2 + width^2 + depth^2)))

    width, depth (full sides), distance (...) m. Returns (...) sr. Errors: none. Source: deck, Solid Angles.
    """
    width, depth, distance = (np.asarray(x, float) for x in (width, depth, distance))
    diagonal = np.hypot(2 * distance, np.hypot(width, depth))
    return 4 * np.arctan2(width * depth, 2 * distance * diagonal)


def solid_angle_rectangle_naive(width, depth, distance):
    """The solid angle of a centred rectangle in the arccosine form, which cancels for a far rectangle.

    a = width / (2 distance), b = depth / (2 distance): 4 acos(sqrt((1 + a^2 + b^2) / ((1 + a^2) (1 + b^2))))

    width, depth, distance (...) m. Returns (...) sr. Errors: float32 100 % at distance 100 width.
    Source: deck, Solid Angles; the form found on the web most often.
    """
    width, depth, distance = (np.asarray(x, float) for x in (width, depth, distance))
    a, b = width / (2 * distance), depth / (2 * distance)
    return 4 * np.arccos(np.minimum(1, np.sqrt((1 + a * a + b * b) / ((1 + a * a) * (1 + b * b)))))


def solid_angle_rectangle_beside(x0, x1, width, depth, distance):
    """The solid angle of the rectangle x0 .. x1, 0 .. depth in the plane z = distance, to one side of the origin.

    p^2 = depth^2 + distance^2, r^2 = x^2 + p^2: atan2(depth distance width (x0 + x1) p^2 / (x1 r0 + x0 r1),
    distance^2 r0 r1 + x0 x1 depth^2), the difference of two corners' angles in one arctangent

    0 <= x0 < x1, width = x1 - x0 as the caller knows it, depth, distance >= 0 (...) m. Returns (...) sr. Errors: none.
    Source: deck, Solid Angles; the corner sum rearranged here.
    """
    x0, x1, width, depth, distance = (np.asarray(x, float) for x in (x0, x1, width, depth, distance))
    p = np.hypot(depth, distance)
    r0, r1 = np.hypot(x0, p), np.hypot(x1, p)
    rise = width * (x0 + x1) * p / (x1 * r0 + x0 * r1) * p
    return np.arctan2(depth * distance * rise, distance * distance * r0 * r1 + x0 * x1 * depth * depth)


def solid_angle_rectangle_off_axis(x0, x1, y0, y1, distance):
    """The solid angle of the rectangle x0 .. x1, y0 .. y1 in the plane z = distance, seen from the origin.

    Where the axis meets it the four corners add up, sum of atan(|x y| / (distance sqrt(x^2 + y^2 + distance^2))); the
    sum cancels elsewhere: beside one axis two of solid_angle_rectangle_beside, beside both two triangles by edges.

    x0 < x1, y0 < y1, distance >= 0 (...) m. Returns (...) sr. Errors: none.
    Sources: deck, Solid Angles; van Oosterom and Strackee 1983.
    """
    x0, x1, y0, y1, d = np.broadcast_arrays(*(np.asarray(x, float) for x in (x0, x1, y0, y1, distance)))
    w, h, zero = x1 - x0, y1 - y0, np.zeros(d.shape)
    (x0, x1), (y0, y1) = (np.where(high <= 0, (-high, -low), (low, high)) for low, high in ((x0, x1), (y0, y1)))
    over = sum(np.arctan2(np.abs(x * y), d * np.hypot(d, np.hypot(x, y))) for x in (x0, x1) for y in (y0, y1))
    right = sum(solid_angle_rectangle_beside(np.maximum(x0, 0), x1, w, np.abs(y), d) for y in (y0, y1))
    above = sum(solid_angle_rectangle_beside(np.maximum(y0, 0), y1, h, np.abs(x), d) for x in (x0, x1))
    corner, ab, ac, ad = (np.stack(v, -1) for v in ((x0, y0, d), (w, zero, zero), (w, h, zero), (zero, h, zero)))
    off = np.abs(solid_angle_triangle_edges(corner, ab, ac)) + np.abs(solid_angle_triangle_edges(corner, ac, ad))
    return np.select([(x0 > 0) & (y0 > 0), x0 > 0, y0 > 0], [off, right, above], over)[()]


def _dot(a, b):
    return np.sum(a * b, -1)


def solid_angle_corners(a, b, c, area):
    """The signed solid angle of a triangle whose corners and area vector are known, each to its own precision.

    2 atan2(n . area / (|a||b||c|), 1 + A.B + B.C + C.A), n the nearest corner, A, B, C the directions of the corners;
    1 + A.B + B.C + C.A = (A + B).(A + C) at any corner, and cancels least at the one most opposite to the others

    a, b, c (..., 3) m from the eye, area = (b - a) x (c - a) (..., 3) m^2. Returns (...) sr, -2 pi .. 2 pi, positive
    where a, b, c run clockwise; 0 in the triangle's own plane, the mean of its two sides. Errors: none.
    Source: van Oosterom and Strackee 1983, The Solid Angle of a Plane Triangle, rearranged.
    """
    a, b, c, area = np.broadcast_arrays(*(np.asarray(v, float) for v in (a, b, c, area)))
    x, y, z = (np.sqrt(_dot(v, v)) for v in (a, b, c))
    nearest = np.where(((x <= y) & (x <= z))[..., None], a, np.where((y <= z)[..., None], b, c))
    volume, size = _dot(nearest, area), x * y * z
    a, b, c = (v / np.where(length > 0, length, 1)[..., None] for v, length in ((a, x), (b, y), (c, z)))
    p, q, r = a + b, b + c, c + a
    pp, qq, rr = (_dot(v, v) for v in (p, q, r))
    spread = np.where(pp >= np.maximum(qq, rr), _dot(q, r), np.where(qq >= rr, _dot(p, r), _dot(p, q)))
    flat = (volume == 0) | (size == 0)
    return np.where(flat, 0.0, 2 * np.arctan2(volume / np.where(flat, 1, size), spread))[()]


def solid_angle_triangle_edges(a, ab, ac):
    """The signed solid angle of a triangle given by a corner and its two edges, for one small beside its distance.

    solid_angle_corners(a, a + ab, a + ac, ab x ac)

    a, ab, ac (..., 3) m, a from the eye. Returns (...) sr, -2 pi .. 2 pi; 0 in the triangle's own plane.
    Errors: none if no corner is much nearer to the eye than a.
    Source: van Oosterom and Strackee 1983, The Solid Angle of a Plane Triangle.
    """
    a, ab, ac = (np.asarray(v, float) for v in (a, ab, ac))
    return solid_angle_corners(a, a + ab, a + ac, np.cross(ab, ac))


def solid_angle_face(a, b, c, eye):
    """The solid angle of a triangle seen from the eye, with a sign: positive where the eye sees a, b, c run clockwise.

    solid_angle_corners, the area from the two shortest edges

    a, b, c, eye (..., 3) m. Returns (...) sr, -2 pi .. 2 pi; 0 in the triangle's own plane. A closed mesh, its faces
    counter-clockwise from outside, sums to +4 pi inside. Errors: none.
    Source: van Oosterom and Strackee 1983, The Solid Angle of a Plane Triangle.
    """
    a, b, c, eye = (np.asarray(v, float) for v in (a, b, c, eye))
    ab, bc, ca = b - a, c - b, a - c
    x, y, z = (_dot(v, v)[..., None] for v in (bc, ca, ab))
    area = np.where(x >= np.maximum(y, z), np.cross(ca, ab), np.where(y >= z, np.cross(ab, bc), np.cross(bc, ca)))
    return solid_angle_corners(a - eye, b - eye, c - eye, area)


def solid_angle_triangle_signed(a, b, c):
    """The solid angle of a triangle seen from the origin, positive where a, b, c run clockwise.

    solid_angle_face(a, b, c, 0)

    a, b, c (..., 3) m. Returns (...) sr, -2 pi .. 2 pi; 0 in the triangle's own plane. Errors: none.
    Source: van Oosterom and Strackee 1983, The Solid Angle of a Plane Triangle.
    """
    return solid_angle_face(a, b, c, np.zeros(3))


def solid_angle_triangle(a, b, c):
    """The solid angle of a triangle seen from the origin.

    2 atan2(|a . ((b - a) x (c - a))|, |a||b||c| + (a.b)|c| + (a.c)|b| + (b.c)|a|), as solid_angle_corners computes it

    a, b, c (..., 3) m. Returns (...) sr, 0 .. 2 pi; 0 in the triangle's own plane. Errors: none.
    Source: van Oosterom and Strackee 1983, The Solid Angle of a Plane Triangle.
    """
    return np.abs(solid_angle_triangle_signed(a, b, c))


def _triangle_naive(a, b, c):
    a, b, c = (v / np.sqrt(_dot(v, v))[..., None] for v in (np.asarray(v, float) for v in (a, b, c)))
    return 2 * np.arctan2(_dot(a, np.cross(b, c)), 1 + _dot(a, b) + _dot(a, c) + _dot(b, c))


def solid_angle_triangle_naive(a, b, c):
    """The solid angle of a triangle in the textbook form: a . (b x c) on unit vectors, which cancels for a small one.

    2 atan2(|a . (b x c)|, 1 + a.b + a.c + b.c) with a, b, c normalised

    a, b, c (..., 3) m. Returns (...) sr. Errors: float32 2e-3 at size 0.01, 30 % at 1e-3.
    Source: van Oosterom and Strackee 1983 as printed.
    """
    return np.abs(_triangle_naive(a, b, c))


def _fan(corners, corner_count):
    """The triangles of a fan; corners from corner_count on repeat the last one, so that theirs have no area."""
    corners = np.asarray(corners, float)
    index = np.minimum(np.arange(corners.shape[-2]), np.asarray(corner_count)[..., None] - 1)
    corners, index = np.broadcast_arrays(corners, index[..., None])
    corners = np.take_along_axis(corners, index, -2)
    return corners[..., :1, :], corners[..., 1:-1, :], corners[..., 2:, :]


def solid_angle_polygon(corners, corner_count):
    """The solid angle of a plane polygon without crossings, convex or not, seen from the origin.

    |sum over i of the signed triangle (corner 0, corner i - 1, corner i)|

    corners (..., n, 3) m, corner_count (...) <= n. Returns (...) sr. Errors: none. Source: deck, Solid Angles; the
    triangles by van Oosterom and Strackee 1983.
    """
    return np.abs(np.sum(solid_angle_triangle_signed(*_fan(corners, corner_count)), -1))


def solid_angle_polygon_naive(corners, corner_count):
    """The solid angle of a plane polygon by textbook triangles, which cancel for a small one.

    |sum over i of the signed textbook triangle (corner 0, corner i - 1, corner i)|

    corners (..., n, 3) m, corner_count (...) <= n. Returns (...) sr. Errors: those of solid_angle_triangle_naive.
    Source: van Oosterom and Strackee 1983 as printed.
    """
    return np.abs(np.sum(_triangle_naive(*_fan(corners, corner_count)), -1))


def solid_angle_mesh(triangles, eye):
    """The signed solid angles of a mesh's faces, summed: 4 pi inside a closed mesh, 0 outside, between for an open one.

    sum over faces of solid_angle_face(a, b, c, eye)

    triangles (faces, 3, 3) m, counter-clockwise from outside; eye (..., 3) m. Returns (...) sr. A face whose plane the
    eye is in counts 0: on a face of a closed mesh the sum is 2 pi, on an edge or corner the angle of the solid there,
    if the plane is met without rounding; otherwise the value of one of the two sides. Errors: none.
    Sources: deck, Solid Angles; van Oosterom and Strackee 1983.
    """
    triangles, eye = np.asarray(triangles, float), np.asarray(eye, float)
    if eye.ndim == 1:
        a, b, c = np.moveaxis(triangles, 1, 0)
        return np.sum(solid_angle_face(a, b, c, eye))
    sums = [solid_angle_mesh(triangles, e) for e in eye.reshape(-1, 3)]
    return np.reshape(sums, eye.shape[:-1])
