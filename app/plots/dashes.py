"""Lines cut into dashes of a length in pixels: VTK's own are too short to tell dash-dot from dotted."""

import numpy as np

PATTERN = {"dashed": (6.0, 4.0), "dashdot": (7.0, 3.0, 1.3, 3.0), "dotted": (1.3, 2.7)}  # on, off, ... in line widths


def dashed(places: np.ndarray, style: str, width: float) -> tuple[np.ndarray, np.ndarray]:
    """A polyline (n, 2) in pixels as (indices into it with fractions, True where a dash ends), to be interpolated.

    NaN in the places is a gap. A solid line is all its points, each gap an end.
    """
    good = np.isfinite(places).all(-1)
    runs = np.split(np.arange(len(places)), np.flatnonzero(np.diff(good.astype(int))) + 1)
    at, ends = [np.zeros(0)], [np.zeros(0, bool)]
    for run in runs:
        if not good[run[0]]:
            continue
        length = np.concatenate([[0.0], np.hypot(*np.diff(places[run], axis=0).T).cumsum()])
        if style not in PATTERN or len(run) < 2 or length[-1] == 0:
            at.append(run.astype(float))
            ends.append(run == run[-1])
            continue
        turns = np.cumsum(np.array(PATTERN[style]) * width)
        period = turns[-1]
        cuts = (np.arange(np.ceil(length[-1] / period))[:, None] * period + np.concatenate([[0.0], turns[:-1]])).ravel()
        starts, stops = cuts[::2], np.minimum(cuts[1::2], length[-1])
        starts, stops = starts[starts < length[-1]], stops[:(starts < length[-1]).sum()]
        inner = length[np.searchsorted(starts, length, "right") > np.searchsorted(stops, length, "left")]
        where = np.concatenate([starts, inner, stops])
        kind = np.repeat([0, 1, 2], [len(starts), len(inner), len(stops)])
        order = np.lexsort((kind, where))
        at.append(run[0] + np.interp(where[order], length, np.arange(len(run))))
        ends.append(kind[order] == 2)
    return np.concatenate(at), np.concatenate(ends)


def along(values: np.ndarray, at: np.ndarray, ends: np.ndarray) -> np.ndarray:
    """Values of a polyline's points at those indices, with NaN after each end."""
    low = np.floor(at).astype(int)
    high = np.minimum(low + 1, len(values) - 1)
    share = at - low
    found = np.where(share > 0, values[low] + share * (values[high] - values[low]), values[low])
    return np.insert(found, np.flatnonzero(ends) + 1, np.nan)
