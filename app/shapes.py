"""The built-in shapes as vertices (V, 3) and faces (F, 3), made with numpy alone, counter-clockwise from outside."""

import numpy as np

RIM = np.radians(50.0)  # the half angle of the bowl's opening


def icosphere(splits: int) -> tuple[np.ndarray, np.ndarray]:
    """An icosahedron, each face split into four `splits` times, pushed onto the unit sphere."""
    golden = (1 + 5**0.5) / 2
    vertices = np.array([[-1, golden, 0], [1, golden, 0], [-1, -golden, 0], [1, -golden, 0],
                         [0, -1, golden], [0, 1, golden], [0, -1, -golden], [0, 1, -golden],
                         [golden, 0, -1], [golden, 0, 1], [-golden, 0, -1], [-golden, 0, 1]])
    faces = np.array([[0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11], [1, 5, 9], [5, 11, 4],
                      [11, 10, 2], [10, 7, 6], [7, 1, 8], [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8],
                      [3, 8, 9], [4, 9, 5], [2, 4, 11], [6, 2, 10], [8, 6, 7], [9, 8, 1]])
    for _ in range(splits):
        sides = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
        edges, place = np.unique(sides, axis=0, return_inverse=True)
        ab, bc, ca = (place.ravel() + len(vertices)).reshape(3, -1)
        vertices = np.concatenate([vertices, vertices[edges].mean(axis=1)])
        a, b, c = faces.T
        faces = np.stack([a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca], axis=1).reshape(-1, 3)
    return vertices / np.linalg.norm(vertices, axis=1, keepdims=True), faces


def trefoil(along: int = 168, around: int = 20) -> tuple[np.ndarray, np.ndarray]:
    """A tube of radius 0.19 along the (2, 3) torus knot; the torus's own normal is a frame that closes by itself."""
    fine = np.linspace(0, 2 * np.pi, 4001)
    path = np.linalg.norm(np.diff(torus_knot(fine)[0], axis=0), axis=1).cumsum()
    t = np.interp(np.arange(along) / along * path[-1], np.concatenate([[0.0], path]), fine)  # equal steps of length
    centre, tangent, normal = torus_knot(t)
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    side = np.cross(normal, tangent)
    angle = 2 * np.pi * np.arange(around) / around
    ring = np.cos(angle)[:, None] * normal[:, None] + np.sin(angle)[:, None] * side[:, None]
    vertices = (centre[:, None] + 0.19 * ring).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(along), np.arange(around), indexing="ij")
    return vertices, quads(i * around + j, (i + 1) % along * around + j,
                           (i + 1) % along * around + (j + 1) % around, i * around + (j + 1) % around)


def torus_knot(t: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Points of the knot, its derivative, and the unit normal of the torus (radii 0.64 and 0.36) it lies on."""
    big, small = 0.64, 0.36
    zero = np.zeros_like(t)
    out, turn = np.stack([np.cos(2 * t), np.sin(2 * t), zero], 1), np.stack([-np.sin(2 * t), np.cos(2 * t), zero], 1)
    cos, sin, up = np.cos(3 * t)[:, None], np.sin(3 * t)[:, None], np.array([0.0, 0.0, 1.0])
    normal = cos * out + sin * up
    return (big * out + small * normal, 2 * (big + small * cos) * turn + 3 * small * (cos * up - sin * out), normal)


def bowl(bands: int = 40, around: int = 96) -> tuple[np.ndarray, np.ndarray]:
    """The unit sphere from the polar angle RIM down to the south pole; the rim is a regular polygon on its circle."""
    theta = np.linspace(RIM, np.pi, bands + 1)[:-1, None]
    phi = 2 * np.pi * np.arange(around) / around
    rows = np.stack(np.broadcast_arrays(np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)), -1)
    vertices = np.concatenate([rows.reshape(-1, 3), [[0.0, 0.0, -1.0]]])
    i, j = np.meshgrid(np.arange(bands - 1), np.arange(around), indexing="ij")
    k = (j + 1) % around
    last, here = (bands - 1) * around, np.arange(around)
    pole = np.stack([last + here, np.full(around, bands * around), last + (here + 1) % around], axis=1)
    return vertices, np.concatenate([quads(i * around + j, (i + 1) * around + j, (i + 1) * around + k,
                                           i * around + k), pole])


def cube(side: float) -> tuple[np.ndarray, np.ndarray]:
    vertices = (np.indices((2, 2, 2)).reshape(3, 8).T - 0.5) * side  # vertex 4x + 2y + z
    corners = np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])
    return vertices, quads(*corners.T)


def quads(a: np.ndarray, b: np.ndarray, c: np.ndarray, d: np.ndarray) -> np.ndarray:
    """Two triangles for each quadrilateral a b c d."""
    return np.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3)
