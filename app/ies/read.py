"""An LM-63 file as a Photometry: the numbers in the order of the standard, each checked where it stands."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from app.ies.angles import horizontal_rule, vertical_rule
from app.ies.photometry import TYPES, Photometry
from app.ies.text import Header, Numbers, decoded, load
from app.problem import Problem

MOST = 3601  # angles of a kind: a tenth of a degree around
CELLS = 2_000_000
TOO_MANY = 1.02  # times the declared lumens: more is no rounding
ORDINARY = 1e9  # cd, lm, W: more is damage


def read(path: str | Path) -> Photometry:
    """The luminaire of a file; Problem with file, line and rule where it cannot be trusted."""
    path = Path(path).expanduser()
    return parse(load(path), str(path), path.parent)


def parse(data: bytes, name: str, folder: Path | None = None) -> Photometry:
    lines = decoded(name, data)
    header = Header(name, lines, folder)
    numbers = Numbers(name, lines[header.at + 1:], header.at + 2)
    if header.tilt == "INCLUDE":
        tilt_table(numbers)
        header.warnings.append(f"{name}, line {header.at + 1}: TILT=INCLUDE gives factors for a tilted lamp; the "
                               "luminaire is shown as it was measured, so they are not applied.")
    warnings = header.warnings
    lamps = numbers.count("number of lamps", 1, 100_000)
    line = numbers.line(numbers.at)
    lumens = numbers.checked("lumens per lamp", lambda x: x == -1 or 0 <= x <= ORDINARY,
                             "lumens, or -1 for absolute photometry")
    multiplier = numbers.checked("candela multiplier", lambda x: 0 < x <= ORDINARY, "a factor above 0")
    n_vertical = numbers.count("number of vertical angles", 2, MOST)
    n_horizontal = numbers.count("number of horizontal angles", 1, MOST)
    if n_vertical * n_horizontal > CELLS:
        numbers.refuse(numbers.at - 1, f"{n_vertical} x {n_horizontal} angles are promised; at most {CELLS} "
                                       "values are read here, and LM-63 asks for counts that are true")
    kind = TYPES[numbers.count("photometric type", 1, 3)]
    units = numbers.count("units type (1 feet, 2 metres)", 1, 2)
    size = numbers.take(3, "luminous dimensions (width, length, height)")
    ballast = numbers.checked("ballast factor", lambda x: 0 < x <= ORDINARY, "a factor above 0")
    third = third_factor(numbers, header.year)
    watts = numbers.checked("input watts", lambda x: 0 <= x <= ORDINARY, "0 or more watts")
    if lumens == 0:
        warnings.append(f"{name}, line {line}: 0 lumens per lamp; LM-63 asks for the lumens "
                        "the candela refer to, or -1.")
    vertical = angles(numbers, n_vertical, "vertical angles")
    vertical_rule(numbers, numbers.at - n_vertical, vertical, kind, warnings)
    horizontal = angles(numbers, n_horizontal, "horizontal angles")
    symmetry = horizontal_rule(numbers, numbers.at - n_horizontal, horizontal, kind, header.year, warnings)
    candela = intensities(numbers, n_vertical * n_horizontal).reshape(n_horizontal, n_vertical)
    rest(numbers, n_vertical, n_horizontal, warnings)
    factor = multiplier * ballast * third
    if not candela.any():
        numbers.refuse(numbers.at - 1, "all candela are 0; LM-63 asks for the intensities of a luminaire that shines")
    if not float(candela.max()) * factor <= ORDINARY:
        numbers.refuse(numbers.at - 1, f"candela times multiplier and factors reach {candela.max() * factor:.1e} cd; "
                                       "LM-63 asks for factors that give candela")
    found = Photometry(
        name=name, year=header.year, keywords=header.keywords, labels=tuple(header.labels), tilt=header.tilt,
        kind=kind, symmetry=symmetry, lamps=lamps, lumens_per_lamp=lumens, factor=factor, units=units,
        size=(size[0], size[1], size[2]), watts=watts, vertical=vertical, horizontal=horizontal,
        candela=candela * factor, warnings=())
    emitted, declared = found.integrated_lumens, found.declared_lumens
    if declared and emitted > TOO_MANY * declared:
        warnings.append(f"{name}, line {line}: {declared:g} lm are declared, and the candela add up to {emitted:.5g} "
                        "lm; LM-63 asks for the candela of the declared lumens, and no luminaire emits more than its "
                        "lamps.")
    return replace(found, warnings=tuple(warnings))


def tilt_table(numbers: Numbers) -> None:
    """TILT=INCLUDE: the lamp's geometry, how many, the angles, the factors."""
    numbers.count("lamp-to-luminaire geometry", 1, 3)
    count = numbers.count("number of tilt angles", 1, MOST)
    angles(numbers, count, "tilt angles")
    at = numbers.at
    factors = np.array(numbers.take(count, "tilt factors"))
    if (factors < 0).any():
        numbers.refuse(at + int(np.argmax(factors < 0)), "a tilt factor is negative; LM-63 asks for factors of 0 or "
                                                         "more")


def third_factor(numbers: Numbers, year: int) -> float:
    """The number between ballast factor and watts: a factor until 1991, then kept for the future, in 2019 a type."""
    if year <= 1991:
        return numbers.checked("ballast-lamp factor", lambda x: 0 < x <= ORDINARY, "a factor above 0")
    numbers.take(1, "file generation type" if year >= 2019 else "number for future use")
    return 1.0


def angles(numbers: Numbers, count: int, what: str) -> np.ndarray:
    """Angles in degrees, each larger than the one before."""
    found = np.array(numbers.take(count, what))
    steps = np.diff(found)
    if count > 1 and not (steps > 0).all():
        i = int(np.argmax(~(steps > 0))) + 1
        fault = "repeats the one before" if found[i] == found[i - 1] else f"comes after {found[i - 1]:g}"
        numbers.refuse(numbers.at - count + i, f"the angle {found[i]:g} among the {what} {fault}; LM-63 asks for "
                                               "angles in ascending order")
    return found


def intensities(numbers: Numbers, count: int) -> np.ndarray:
    found = np.array(numbers.take(count, "candela values"))
    if (found < 0).any():
        i = int(np.argmax(found < 0))
        numbers.refuse(numbers.at - count + i, f"the candela value {found[i]:g} is negative; LM-63 asks for "
                                               "intensities, which are 0 or more")
    return found


def rest(numbers: Numbers, n_vertical: int, n_horizontal: int, warnings: list[str]) -> None:
    """Nothing follows the last candela; numbers there mean that a count is wrong, words are only remarked on."""
    more = numbers.words[numbers.at:]
    if not more:
        return
    words = (f"{numbers.name}, line {numbers.line(numbers.at)}: {more[0][:30]!r} stands behind the last of "
             f"{n_vertical} x {n_horizontal} candela values; LM-63 asks for nothing after them")
    try:
        float(more[0])
    except ValueError:
        warnings.append(words + ", and it is ignored.")
        return
    raise Problem(words + f", so a count is wrong ({len(more)} too many).")
