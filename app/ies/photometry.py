"""A luminaire as it was measured, and the same as one grid of the whole sphere: the table a scene samples.

Table rows: 0 the header [axis, vertical angles, planes, declared lm or NaN, peak cd, integrated lm]; 1 the angles from
the pole; 2 the azimuths of the planes, from -180 to 180; then one row of candela for each plane. Degrees and cd. The
pole is straight down (axis 0: types C and A) or horizontal, 90 degrees clockwise from the luminaire's front (axis 1:
type B).
"""

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from app.ies.angles import SAME, near

TYPES = {1: "C", 2: "B", 3: "A"}
HEADER = 6


@dataclass(frozen=True, eq=False)
class Photometry:
    name: str
    year: int  # of the standard
    keywords: dict[str, str]
    labels: tuple[str, ...]
    tilt: str
    kind: str  # C, B or A
    symmetry: str
    lamps: int
    lumens_per_lamp: float  # -1: absolute photometry
    factor: float  # that the file's numbers were multiplied by
    units: int
    size: tuple[float, float, float]  # width, length, height of the luminous opening
    watts: float
    vertical: np.ndarray  # degrees, as in the file
    horizontal: np.ndarray
    candela: np.ndarray  # (planes, vertical), factors applied
    warnings: tuple[str, ...]

    @property
    def standard(self) -> str:
        return f"LM-63-{self.year}"

    @property
    def declared_lumens(self) -> float | None:
        """What the lamps are said to emit; None for absolute photometry, where -1 is a sign and no flux."""
        return None if self.lumens_per_lamp == -1 else self.lamps * self.lumens_per_lamp

    @property
    def title(self) -> str:
        """What the file calls the luminaire, on one line."""
        said = self.keywords.get("LUMINAIRE") or next((s for s in self.labels if s.strip() and s.strip()[0] != "["), "")
        return " ".join(said.split()) or Path(self.name).name

    @property
    def summary(self) -> str:
        """What a person should know at once, short enough for the window's bottom line."""
        declared = "none" if self.declared_lumens is None else f"{self.declared_lumens:g}"
        more = f"; {len(self.warnings)} remarks, see halfway ies" if self.warnings else ""
        return (f"{Path(self.name).name}: {self.standard}, type {self.kind}, {self.symmetry}; lm declared {declared}, "
                f"integrated {self.integrated_lumens:.5g}{more}")

    @property
    def max_candela(self) -> float:
        return float(self.candela.max())

    @cached_property
    def integrated_lumens(self) -> float:
        """The flux of the intensities interpolated linearly between the angles: exact for that, not for the lamp."""
        return float(self.table[0, HEADER - 1])

    @cached_property
    def table(self) -> np.ndarray:
        from app.optics.ies import ies_flux

        polar, azimuth, candela = self.whole()
        for row, pole in ((0, 0.0), (-1, 180.0)):
            if near(polar[row], pole):  # one direction: all planes agree, and the flux stays as it is
                candela[:, row] = np.trapezoid(candela[:, row], azimuth) / (azimuth[-1] - azimuth[0])
        table = np.zeros((3 + len(azimuth), max(HEADER, len(polar), len(azimuth))))
        declared = np.nan if self.declared_lumens is None else self.declared_lumens
        table[0, :HEADER - 1] = self.kind == "B", len(polar), len(azimuth), declared, self.max_candela
        table[1, :len(polar)], table[2, :len(azimuth)] = polar, azimuth
        table[3:, :len(polar)] = candela
        table[0, HEADER - 1] = ies_flux(table)
        table.flags.writeable = False
        return table

    def whole(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Angles from the pole, azimuths from -180 to 180, candela (azimuths, angles): symmetry written out."""
        if self.kind == "C":
            return (self.vertical.copy(), *around(self.horizontal, self.candela, self.symmetry))
        side, candela = self.horizontal, self.candela
        if self.symmetry == "bilateral":
            side, candela = np.concatenate([-side[:0:-1], side]), np.concatenate([candela[:0:-1], candela])
        if self.kind == "A":  # vertical -90 is straight down; horizontal runs clockwise
            return self.vertical + 90.0, -side[::-1], candela[::-1].copy()
        return 90.0 - side[::-1], self.vertical.copy(), candela[::-1].T.copy()


def around(planes: np.ndarray, candela: np.ndarray, symmetry: str) -> tuple[np.ndarray, np.ndarray]:
    """Planes of type C and their mirror images from -180 to 180, each azimuth once."""
    if symmetry == "axial":
        return np.array([-180.0, 180.0]), np.repeat(candela[:1], 2, 0)
    if symmetry == "none" and near(planes[-1], 360.0):  # 0 and 360 are one plane
        candela = np.concatenate([(candela[:1] + candela[-1:]) / 2, candela[1:-1]])
        planes = planes[:-1]
    found = [planes]
    if symmetry == "quadrant":
        found = [planes, 180.0 - planes, -planes, planes - 180.0]
    elif symmetry == "bilateral":
        found = [planes, -planes]
    elif symmetry == "bilateral 90-270":
        found = [planes, 180.0 - planes]
    azimuth = np.concatenate(found)
    azimuth = np.where(azimuth > 180.0 + SAME, azimuth - 360.0, azimuth)
    azimuth = np.where(azimuth <= -180.0 + SAME, azimuth + 360.0, azimuth)  # in (-180, 180]
    order = np.argsort(azimuth, kind="stable")
    azimuth, rows = azimuth[order], np.concatenate([candela] * len(found))[order]
    first = np.concatenate([[True], np.diff(azimuth) > SAME])
    azimuth, rows = azimuth[first], rows[first]
    if near(azimuth[-1], 180.0):
        behind = rows[-1:]
        azimuth, rows = azimuth[:-1], rows[:-1]
    else:  # no plane at 180: between its neighbours, as everywhere
        gap = azimuth[0] + 360.0 - azimuth[-1]
        share = (180.0 - azimuth[-1]) / gap
        behind = rows[-1:] * (1 - share) + rows[:1] * share
    return np.concatenate([[-180.0], azimuth, [180.0]]), np.concatenate([behind, rows, behind])
