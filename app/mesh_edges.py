"""How the triangles of a mesh hang together: shared corners, edges, whether it is closed."""

import numpy as np


def shared_corners(triangles: np.ndarray) -> np.ndarray:
    """(F, 3) numbers of the corners, the same number for the same point."""
    points = np.ascontiguousarray(triangles.reshape(-1, 3) + 0.0)  # + 0.0 makes one zero of two
    _, place = np.unique(points.view([("", points.dtype)] * 3).ravel(), return_inverse=True)
    return place.reshape(-1, 3)


def edges(faces: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """How often each edge is run through, from its lower corner to its higher one and back."""
    faces = faces[(faces != np.roll(faces, 1, axis=1)).all(axis=1)]
    start, end = faces.ravel(), np.roll(faces, -1, axis=1).ravel()
    low, high = np.minimum(start, end), np.maximum(start, end)
    kinds, place = np.unique(low * (int(faces.max(initial=0)) + 1) + high, return_inverse=True)
    up = start == low
    return np.bincount(place[up], minlength=len(kinds)), np.bincount(place[~up], minlength=len(kinds))


def is_closed(faces: np.ndarray) -> bool:
    """The boundary of the surface is nothing: 4 pi from inside, 0 from outside, whatever else it does."""
    there, back = edges(faces)
    return len(there) > 0 and bool((there == back).all())


def winding(faces: np.ndarray) -> str:
    there, back = edges(faces)
    rim, clash = int((there + back == 1).sum()), int(((there + back > 1) & (there != back)).sum())
    if clash:
        return f"its faces disagree at {clash} edges on which side is outside: do not trust its solid angle"
    return f"open: {rim} edges have a face on one side only" if rim else "closed"


CREASE = 0.7  # faces whose normals' cosine is below this meet in an edge that is meant to be sharp
AROUND = 256  # faces around a corner that are looked at


def corner_normals(triangles: np.ndarray) -> np.ndarray:
    """(F, 3, 3) a unit normal for each corner of each face: the mean of the faces there that are about as
    steep, each by its area. A face without area has +z."""
    flat = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    size = np.linalg.norm(flat, axis=-1, keepdims=True)
    unit = np.where(size > 0, flat / np.where(size > 0, size, 1), [0.0, 0.0, 1.0])
    place = shared_corners(triangles).ravel()
    order = np.argsort(place, kind="stable")
    count = np.bincount(place)
    start, many = (np.cumsum(count) - count)[place[order]], count[place[order]]
    at, face = np.arange(len(order)) - start, order // 3
    total = flat[face]
    for step in range(1, min(int(count.max(initial=1)), AROUND)):
        some = np.flatnonzero(many > step)  # few corners have many faces
        other = face[start[some] + (at[some] + step) % many[some]]
        near = np.einsum("ij,ij->i", unit[face[some]], unit[other]) > CREASE
        total[some] += np.where(near[:, None], flat[other], 0)
    length = np.linalg.norm(total, axis=-1, keepdims=True)
    found = np.empty((len(order), 3))
    found[order] = np.where(length > 0, total / np.where(length > 0, length, 1), unit[face])
    return found.reshape(-1, 3, 3)
