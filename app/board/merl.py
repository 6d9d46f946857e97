"""Measured reflectance in the format of the MERL database (Matusik, Pfister, Brand and McMillan 2003).

Three int32, the counts of theta_h, theta_d and phi_d (90, 90, 180), then that many float64 for red, as many for green
and for blue; little-endian. h is the halfway vector, d the light as h sees it (Rusinkiewicz 1998):

    cell of theta_h    90 sqrt(theta_h / (pi / 2)): finer towards the mirror direction
    cell of theta_d    90 theta_d / (pi / 2)
    cell of phi_d      180 phi_d / pi, in [0, pi): swapping light and eye adds pi, and is the same cell
    1/sr               the number times 1 / 1500, 1.15 / 1500 and 1.66 / 1500; below 0 nothing was measured

The database's own reader takes the cell a direction falls in. Here values go linearly from the middle of one cell to
the middle of the next, so a lobe has no steps; cells without a measurement are left out of it.
"""

from functools import cached_property
from pathlib import Path

import numpy as np

from app.badges import Badge
from app.board.brdf_file import Default, Parameter
from app.board.verdict import worst_of
from app.hemisphere import apart, frame
from app.problem import Problem

SHAPE = 90, 90, 180
SCALES = 1 / 1500, 1.15 / 1500, 1.66 / 1500
HEAD, CELLS = 12, 90 * 90 * 180  # bytes, numbers of a channel
SIZE = HEAD + 3 * 8 * CELLS
QUARTER = 0.5 * np.pi
TABLE_COLUMNS = 2160  # of all numbers as a texture


def is_one(path: str | Path) -> bool:
    """By what is in it: its first numbers are three counts."""
    path = Path(path)
    if path.suffix.lower() == ".binary":
        return True
    try:
        with path.open("rb") as file:
            return file.read(HEAD) == np.array(SHAPE, "<i4").tobytes()
    except OSError:
        return False


def read(path: str | Path) -> "Merl":
    """The measurement, mapped and not copied; a Problem where it is none."""
    path = Path(path)
    try:
        size = path.stat().st_size
        with path.open("rb") as file:
            head = file.read(HEAD)
    except OSError as error:
        raise Problem(f"{path}: {error.strerror}.") from None
    found = tuple(np.frombuffer(head, "<i4").tolist()) if len(head) == HEAD else ()
    if found != SHAPE:
        begins = f"begins with {' x '.join(map(str, found))}" if found else f"has {size} bytes"
        raise Problem(f"{path} {begins}; a measurement in MERL's format begins with the counts 90 x 90 x 180.")
    if size != SIZE:
        wrong = "is cut off" if size < SIZE else "goes on after its end"
        raise Problem(f"{path} {wrong}: it has {size} bytes, and 3 x {CELLS} numbers make {SIZE}.")
    cells = np.memmap(path, "<f8", "r", HEAD, (3, *SHAPE))
    for channel, colour in enumerate(("red", "green", "blue")):
        bad = ~np.isfinite(cells[channel].reshape(-1))
        if bad.any():
            raise Problem(f"{path}: number {int(np.argmax(bad)) + 1} of {colour} is no number, or infinite.")
    return Merl(str(path), cells)


def coordinates(n, l, v) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """theta_h, theta_d and phi_d (...) rad, phi_d from -pi to pi, of unit vectors (..., 3)."""
    n, l, v = np.broadcast_arrays(*(np.asarray(x, float) for x in (n, l, v)))
    both = l + v
    length = np.linalg.norm(both, axis=-1, keepdims=True)
    h = np.where(length > 0, both / np.where(length > 0, length, 1), n)
    up = np.sum(n * h, -1, keepdims=True)
    aside = h - up * n
    sine = np.linalg.norm(aside, axis=-1, keepdims=True)
    across = frame(np.where(n[..., 2:] < 0, -n, n))[0]
    radial = np.where(sine > 1e-12, aside / np.where(sine > 1e-12, sine, 1), across)
    turned = np.cross(n, radial)
    phi = np.arctan2(np.sum(l * turned, -1), np.sum(l * (up * radial - sine * n), -1))
    return np.arctan2(sine, up)[..., 0], apart(l, h), phi


def directions(theta_h, theta_d, phi_d) -> tuple[np.ndarray, np.ndarray]:
    """l and v (..., 3) over n = +z with h in the xz-plane: what `coordinates` takes apart."""
    theta_h, theta_d, phi_d = np.broadcast_arrays(theta_h, theta_d, phi_d)
    x, y, z = np.sin(theta_d) * np.cos(phi_d), np.sin(theta_d) * np.sin(phi_d), np.cos(theta_d)
    c, s = np.cos(theta_h), np.sin(theta_h)
    return np.stack([c * x + s * z, y, c * z - s * x], -1), np.stack([s * z - c * x, -y, c * z + s * x], -1)


def middles(stride: tuple[int, int, int] = (1, 1, 1)) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """theta_h, theta_d, phi_d in the middle of every cell, or of every so many."""
    h, d, p = ((np.arange(step // 2, count, step) + 0.5) / count for count, step in zip(SHAPE, stride, strict=True))
    return tuple(np.meshgrid(QUARTER * h * h, QUARTER * d, np.pi * p, indexing="ij"))  # type: ignore[return-value]


class Merl:
    parameters: tuple[Parameter, ...] = ()
    is_anisotropic = False

    def __init__(self, path: str, cells: np.ndarray):
        self.path, self.cells, self.name = path, cells, Path(path).stem

    def value(self, n, l, v, channel: int) -> np.ndarray:
        """1/sr (...) of a channel; 0 below the horizon, NaN where nothing near was measured."""
        n, l, v = (np.asarray(x, float) for x in (n, l, v))
        theta_h, theta_d, phi_d = coordinates(n, l, v)
        lit = (np.sum(n * l, -1) > 0) & (np.sum(n * v, -1) > 0)
        at = [SHAPE[0] * np.sqrt(theta_h / QUARTER) - 0.5, SHAPE[1] * theta_d / QUARTER - 0.5]
        at = [np.clip(x, 0, count - 1) for x, count in zip(at, SHAPE, strict=False)]
        at.append((SHAPE[2] * phi_d / np.pi - 0.5) % SHAPE[2])
        low = [np.minimum(x.astype(int), count - 1) for x, count in zip(at, SHAPE, strict=True)]
        share = [x - i for x, i in zip(at, low, strict=True)]
        high = [np.minimum(low[0] + 1, 89), np.minimum(low[1] + 1, 89), (low[2] + 1) % SHAPE[2]]
        total, weight = np.zeros(lit.shape), np.zeros(lit.shape)
        for corner in range(8):
            ends = [corner >> axis & 1 for axis in range(3)]
            index = tuple(np.where(lit, (high if end else low)[axis], 0) for axis, end in enumerate(ends))
            w = np.prod([share[axis] if end else 1 - share[axis] for axis, end in enumerate(ends)], 0)
            f = self.cells[channel][index]
            w = np.where(f >= 0, w, 0.0)
            total, weight = total + w * f, weight + w
        found = np.where(weight > 0, total / np.where(weight > 0, weight, 1), np.nan)
        return np.where(lit, SCALES[channel] * found, 0.0)

    def rgb(self, n, l, v, values: dict[str, Default] | None = None, x=None) -> np.ndarray:
        return np.stack([self.value(n, l, v, channel) for channel in range(3)], -1)

    def is_grey(self, values: dict[str, Default] | None = None) -> bool:
        return False

    @cached_property
    def table(self) -> np.ndarray:
        """All numbers in their order, float32 in rows of 2160: what glsl/display/merl.glsl reads."""
        return np.asarray(self.cells, "f4").reshape(-1, TABLE_COLUMNS)

    @cached_property
    def missing(self) -> float:
        """The share of the cells above the horizon that hold no measurement in some channel."""
        l, v = directions(*middles())
        above = (l[..., 2] > 0) & (v[..., 2] > 0)
        return float(np.mean(np.min(self.cells, 0)[above] < 0))

    @property
    def warnings(self) -> tuple[str, ...]:
        if not self.missing:
            return ()
        return (f"{self.path}: {100 * self.missing:.3g} % of the cells above the horizon were not measured; "
                "the badges judge the others, and the albedo is at least what they say.",)

    def badges(self, values: dict[str, Default] | None = None) -> dict[str, Badge]:
        """Of what was measured: a missing value is no fault of the material, and counts as nothing."""
        return worst_of(lambda n, l, v, channel: np.nan_to_num(self.value(n, l, v, channel)))
