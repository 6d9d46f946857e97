"""Which angles LM-63 allows, and what symmetry the horizontal ones declare."""

import numpy as np

from app.ies.text import Numbers

ENDS = {90: "quadrant", 180: "bilateral", 360: "none"}  # the last horizontal angle of type C, from 0
SAME = 1e-3  # degrees: angles nearer than this are one


def near(angle: float, *others: float) -> bool:
    return any(abs(angle - other) <= SAME for other in others)


def vertical_rule(numbers: Numbers, at: int, found: np.ndarray, kind: str, warnings: list[str]) -> None:
    """`at`: the place of the first angle among the numbers."""
    first, last, end = float(found[0]), float(found[-1]), len(found) - 1
    low, high = (0, 180) if kind == "C" else (-90, 90)
    for angle, i in ((first, 0), (last, end)):
        if not low - SAME <= angle <= high + SAME:
            numbers.refuse(at + i, f"the vertical angle {angle:g} lies outside {low} to {high}; LM-63 asks for angles "
                                   f"in that range in type {kind} photometry")
    starts, ends = ((0, 90), (90, 180)) if kind == "C" else ((-90, 0), (90,))
    if not near(first, *starts) or not near(last, *ends):
        warnings.append(f"{numbers.name}, line {numbers.line(at)}: the vertical angles go from {first:g} to {last:g}; "
                        f"LM-63 asks in type {kind} for a first one of {words(starts)} and a last one of "
                        f"{words(ends)}. Outside them it is dark.")


def horizontal_rule(numbers: Numbers, at: int, found: np.ndarray, kind: str, year: int, warnings: list[str]) -> str:
    """The symmetry: axial, quadrant, bilateral, bilateral 90-270 or none."""
    first, last, end = float(found[0]), float(found[-1]), len(found) - 1
    line = f"{numbers.name}, line {numbers.line(at + end)}: "
    if kind != "C":
        if len(found) < 2 or not near(first, 0, -90) or not near(last, 90):
            numbers.refuse(at + end, f"the horizontal angles go from {first:g} to {last:g}; LM-63 asks in type {kind} "
                                     "for 0 to 90 (symmetric) or -90 to 90")
        return "bilateral" if near(first, 0) else "none"
    if len(found) == 1 and not near(first, 0):
        warnings.append(f"{line}the only horizontal angle is {first:g}; LM-63 asks for 0 in an axially symmetric "
                        "file, and it is read as one.")
    if len(found) == 1:
        return "axial"
    if near(first, 90) and near(last, 270):
        if year != 1995:
            warnings.append(f"{line}planes from 90 to 270 are of LM-63-1995; LM-63-{year} asks for a last angle of "
                            "0, 90, 180 or 360. They are read as symmetric to the plane 90-270.")
        return "bilateral 90-270"
    if not near(first, 0):
        numbers.refuse(at, f"the first horizontal angle is {first:g}; LM-63 asks for 0 in type C (or 90 to 270 in "
                           "1995)")
    for end_of_range, symmetry in ENDS.items():
        if near(last, end_of_range):
            return symmetry
    if 180 < last < 360 and near(last + (found[-1] - found[-2]), 360):
        warnings.append(f"{line}the horizontal angles end at {last:g}; LM-63 asks for a last plane at 360, which is "
                        "the plane 0 again, and it is closed so.")
        return "none"
    return numbers.refuse(at + end, f"the horizontal angles end at {last:g}; LM-63 asks for a last one of 0, 90, 180 "
                                    "or 360, and what lies beyond was never measured")


def words(angles: tuple[int, ...]) -> str:
    return " or ".join(map(str, angles))
