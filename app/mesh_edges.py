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
