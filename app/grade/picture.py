"""A picture judged by numbers: inside the object's mask, the relative RMSE and the 99.9th percentile of the error.

The mean over all pixels would forgive a missing highlight; a single pixel at the silhouette should not decide, so there
the nearest of the 3 x 3 neighbours counts.
"""

import numpy as np

from app.grade.agree import MEMORY, agrees
from app.grade.assignment import Task
from app.grade.questions import mask_of
from app.grade.result import Figure, Test, Worst
from app.optics.colour import linear_to_srgb

RMSE, PEAK = 0.01, 0.05  # relative: below both the picture is right
WORST = 10.0  # times those it pays nothing


def test(task: Task, language: str, part: str, most: float, values: np.ndarray,
         args: dict[str, np.ndarray]) -> Test:
    """Full marks below RMSE and PEAK, nothing at WORST times either, in between evenly in the logarithm."""
    assert task.picture is not None
    mask = mask_of(task.picture)
    known, _ = MEMORY.known(task, args, language)
    finite = bool(np.all(np.isfinite(values)))
    images = {"expected": image(known.value, mask), "got": image(values, mask)}
    off, rmse, peak = np.zeros(mask.shape), np.inf, np.inf
    if finite:
        off, rmse, peak = errors(images["expected"], images["got"], mask)
    excess = max(rmse / RMSE, peak / PEAK)
    share = 0.0 if not finite else float(np.clip(1 - np.log(max(excess, 1)) / np.log(WORST), 0, 1))
    verdict = "nonfinite" if not finite else "pass" if share == 1 else "partial" if share > 0 else "wrong"
    right = agrees(known, values)
    seen = part == "visible"  # of the hidden picture nothing is sent back but how far it is off
    message = "" if verdict == "pass" else "there are pixels that are no numbers." if not finite else (
        f"the picture is off by {rmse:.1%} (RMSE) and {peak:.1%} (99.9th percentile); right are at most {RMSE:.0%} and "
        f"{PEAK:.0%}.")
    at = int(np.argmax(np.where(np.isfinite(values.reshape(len(values), -1)).all(-1), off[mask], np.inf)))
    worst = Worst({name: np.asarray(x[at]).tolist() for name, x in args.items()}, np.asarray(values[at]).tolist(),
                  np.asarray(known.value[at]).tolist(), float(min(excess, 1e300))) if message and seen else None
    return Test(f"{task.function}/picture", "image", task.function, "picture", language, part, most,
                most * share, most, verdict, len(values), int(np.sum(~right)), worst,
                message_key="picture" if message else "", message=message,
                figures=figures(images["expected"], images["got"], mask) if message and seen else ())


def image(values: np.ndarray, mask: np.ndarray) -> np.ndarray:
    """(size, size, 3) linear colours, 0 where the object is not."""
    found = np.zeros((*mask.shape, 3))
    found[mask] = values if values.ndim > 1 else values[:, None]
    return found


def errors(expected: np.ndarray, got: np.ndarray, mask: np.ndarray) -> tuple[np.ndarray, float, float]:
    """Each pixel's distance, the relative RMSE and the 99.9th percentile over the brightest right pixel's size."""
    off = distance(expected, got)
    rim = mask & ~inner(mask)
    nearest = off.copy()
    for dy in (-1, 0, 1):
        for dx in (-1, 0, 1):
            moved, there = (np.roll(one, (dy, dx), (0, 1)) for one in (expected, mask))
            nearest = np.minimum(nearest, np.where(there, distance(moved, got), np.inf))
    off = np.where(rim, nearest, off)
    size = np.sqrt(np.mean(np.sum(expected[mask] ** 2, -1)))
    top = np.percentile(np.sqrt(np.sum(expected[mask] ** 2, -1)), 99.9)
    rmse = np.sqrt(np.mean(off[mask] ** 2)) / max(size, 1e-30)
    return off, float(rmse), float(np.percentile(off[mask], 99.9) / max(top, 1e-30))


def distance(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    return np.sqrt(np.sum((one - other) ** 2, -1))


def inner(mask: np.ndarray) -> np.ndarray:
    found = mask.copy()
    for axis in (0, 1):
        for way in (-1, 1):
            found &= np.roll(mask, way, axis)
    return found


def figures(expected: np.ndarray, got: np.ndarray, mask: np.ndarray) -> tuple[Figure, ...]:
    """Expected, yours, the signed error (grey is right, red too bright, blue too dark) and FLIP, for the eye."""
    top = max(float(np.percentile(expected[mask], 99.5)), 1e-30)
    seen = [linear_to_srgb(np.clip(np.nan_to_num(one / top), 0, 1)) for one in (expected, got)]
    signed = np.clip(np.nan_to_num(np.mean(got - expected, -1) / top) * 2, -1, 1)
    error = np.full((*mask.shape, 3), 0.5)
    error[..., 0] += 0.5 * np.maximum(signed, 0) - 0.35 * np.maximum(-signed, 0)
    error[..., 1] -= 0.35 * np.abs(signed)
    error[..., 2] += 0.5 * np.maximum(-signed, 0) - 0.35 * np.maximum(signed, 0)
    named = {"expected": seen[0], "yours": seen[1], "signed error": error}
    flip = flip_map(*seen)
    if flip is not None:
        named["FLIP"] = flip
    return tuple(Figure(label, (255 * pixels + 0.5).astype(np.uint8)) for label, pixels in named.items())


def flip_map(expected: np.ndarray, got: np.ndarray) -> np.ndarray | None:
    """NVIDIA's FLIP, how an eye sees the difference between two sRGB pictures; without the package there is none."""
    try:
        import flip_evaluator
    except ImportError:
        return None
    found, _, _ = flip_evaluator.evaluate(expected.astype(np.float32), got.astype(np.float32), "LDR",
                                          inputsRGB=True, applyMagma=True)
    return np.clip(np.asarray(found, float), 0, 1)
