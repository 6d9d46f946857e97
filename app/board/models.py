"""What the board takes: the word for a model, on the command line or in a plot's term, and the model it means."""

from pathlib import Path
from typing import Protocol

import numpy as np

from app import own_models
from app.badges import Badge
from app.board import course_model, merl
from app.board.brdf_file import Default, Parameter, read
from app.board.brdf_model import BrdfModel
from app.board.coated import Coated
from app.board.course_model import CourseModel
from app.board.fit import fit
from app.problem import Problem, Usage, near

FILES = ".brdf", ".binary"
FIT = "fit:"


class BoardModel(Protocol):
    @property
    def name(self) -> str: ...

    @property
    def parameters(self) -> tuple[Parameter, ...]: ...

    @property
    def warnings(self) -> tuple[str, ...]: ...

    @property
    def is_anisotropic(self) -> bool:
        """Whether it asks how the surface is turned about its normal."""

    def rgb(self, n, l, v, values: dict[str, Default] | None = None, x=None) -> np.ndarray:
        """(..., 3) in 1/sr at unit vectors (..., 3); n.z is not below 0. `x` is what a file calls X: only files ask."""

    def is_grey(self, values: dict[str, Default] | None = None) -> bool: ...

    def badges(self, values: dict[str, Default] | None = None) -> dict[str, Badge]: ...


def opened(word: str) -> BoardModel:
    """The model of a file, the course's of that name, or fit:FILE, the one of the course nearest to a measurement."""
    if word.startswith(FIT):
        measured = merl.read(word.removeprefix(FIT))
        return Coated(f"fit of {measured.name}", fit(measured))
    if word.endswith(FILES) or Path(word).is_file():
        return merl.read(word) if merl.is_one(word) else BrdfModel(read(word))
    if word == Coated.name:
        return Coated()
    if own := own_models.path_of(word):
        if own.suffix != own_models.BRDF:
            raise Usage(f"{own} is a text for the editor, and no part of a reflectance that the board could show.")
        return BrdfModel(read(own))
    name = word.removeprefix(course_model.PREFIX)
    if name not in course_model.names():
        known = [*course_model.names(), Coated.name, *(one.name for one in own_models.saved())]
        raise Usage(f"there is no model {word}, and no such file.{near(name, known)}")
    return CourseModel(name)


def listed(words: list[str]) -> list[str]:
    """The words, a folder replaced by the models' files in it."""
    found: list[str] = []
    for word in words:
        if not Path(word).is_dir():
            found.append(word)
            continue
        inside = sorted(str(path) for path in Path(word).iterdir() if path.suffix.lower() in FILES)
        if not inside:
            raise Problem(f"{word} holds no file that ends in {' or '.join(FILES)}.")
        found += inside
    return found
