"""A model of the board as the user's texts make it: its GLSL is evaluated, in float32."""

from dataclasses import replace
from functools import cache

from app.board.brdf_model import BrdfModel
from app.board.coated import Coated, made_of
from app.board.course_model import CourseModel
from app.board.merl import Merl
from app.board.models import BoardModel, opened
from app.edit import YOURS, follows
from app.shader import Overrides

TEXT = "text"  # how the scene's include of a file's GLSL ends, behind the model's prefix


def edited(model: BoardModel, edits: Overrides) -> BoardModel | None:
    """The model with the texts in it; None where none of them is part of it, or it is no GLSL."""
    if isinstance(model, CourseModel) and follows(model.function, edits):
        return replace(model, edits=edits)
    if isinstance(model, Coated) and not made_of().isdisjoint(name.removeprefix(YOURS) for name, _ in edits):
        return replace(model, edits=edits)
    if isinstance(model, BrdfModel):
        for name, source in edits:
            if source.file == model.file.path and name.endswith(TEXT):
                others = {other: text for other, text in edits if other != name}
                return BrdfModel(model.file, name.removesuffix(TEXT), {**others, "model": source})
    return None


def is_edited(word: str, edits: Overrides) -> bool:
    return bool(edits) and edited(opened(word), edits) is not None


@cache
def is_measured(word: str) -> bool:
    """Whether it is a table, which no text is part of."""
    return isinstance(opened(word), Merl)
