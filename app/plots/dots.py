"""Dots with smooth rims at exact places: VTK's own are squares when they are small."""

import numpy as np

from app.plots.look import Rgb


def stamp(picture: np.ndarray, places: np.ndarray, across: float, colour: Rgb, shape: str = "circle") -> None:
    """Draw dots centred at places (n, 2), px from the top left, into a picture (h, w, 3) of bytes."""
    places = places[np.isfinite(places).all(-1)]
    height, width = picture.shape[:2]
    reach = int(np.ceil(across / 2 + 1))
    step = np.arange(-reach, reach + 1)
    inside = (np.abs(places - [width / 2, height / 2]) < [width / 2 + reach, height / 2 + reach]).all(-1)
    places = places[inside]
    if not len(places):
        return
    first = np.floor(places).astype(int)
    x = first[:, 0, None, None] + step[None, None, :]
    y = first[:, 1, None, None] + step[None, :, None]
    cover = covered(x + 0.5 - places[:, 0, None, None], y + 0.5 - places[:, 1, None, None], across / 2, shape)
    x, y = np.broadcast_arrays(x, y)
    seen = (x >= 0) & (x < width) & (y >= 0) & (y < height) & (cover > 0)
    layer = np.zeros((height, width))
    np.maximum.at(layer, (y[seen], x[seen]), cover[seen])
    top, bottom, left, right = y[seen].min(), y[seen].max() + 1, x[seen].min(), x[seen].max() + 1
    part, alpha = picture[top:bottom, left:right], layer[top:bottom, left:right, None]
    part[:] = np.round(part * (1 - alpha) + 255 * np.array(colour) * alpha)


def covered(x: np.ndarray, y: np.ndarray, radius: float, shape: str) -> np.ndarray:
    """The share of a pixel at (x, y) from the centre that a dot covers."""
    ax, ay = np.abs(x), np.abs(y)
    if shape == "circle":
        outside = np.hypot(x, y) - radius
    elif shape == "square":
        outside = np.maximum(ax, ay) - 0.85 * radius
    elif shape == "diamond":
        outside = (ax + ay - 1.25 * radius) / np.sqrt(2)
    else:  # a cross: near a diagonal, and not too far out
        outside = np.maximum(np.abs(ax - ay) / np.sqrt(2) - 0.28 * radius, np.maximum(ax, ay) - radius)
    return np.clip(0.5 - outside, 0, 1)


def rimmed(picture: np.ndarray, places: np.ndarray, across: float, colour: Rgb, rim: Rgb, width: float) -> None:
    """A large dot with a rim that sets it off from what it lies on."""
    stamp(picture, places, across + 2 * width, rim)
    stamp(picture, places, across, colour)
