"""Parameters of the board's models as a person writes them: `--set roughness=0.3`, for every model that has one."""

import math
from collections.abc import Sequence

from app.board.brdf_file import Default, Parameter
from app.board.models import BoardModel
from app.problem import Usage, near

YES, NO = ("1", "yes", "true", "on"), ("0", "no", "false", "off")


def of_model(model: BoardModel, texts: Sequence[str]) -> dict[str, Default]:
    """The model's parameters: its own values, but where a text `name=value` says another."""
    found = {p.name: p.default for p in model.parameters}
    for text in texts:
        name, _, value = (part.strip() for part in text.partition("="))
        found |= {p.name: read(value, p, text) for p in model.parameters if p.name == name}
    return found


def checked(models: Sequence[BoardModel], texts: Sequence[str]) -> None:
    """Every name is one that some model has; a mistyped one is a Usage."""
    known = {p.name for model in models for p in model.parameters}
    for text in texts:
        name = text.partition("=")[0].strip()
        if "=" not in text:
            raise Usage(f"--set {text} has no value; it is written name=value.")
        if name not in known:
            raise Usage(f"--set {text}: no model here has a parameter {name}.{near(name, known)}")


def read(text: str, p: Parameter, whole: str) -> Default:
    """A value of this parameter, in the units of the file."""
    if p.type == "bool":
        if text.lower() not in YES + NO:
            raise Usage(f"--set {whole}: {p.name} is yes or no.")
        return text.lower() in YES
    parts = text.replace(",", " ").split()
    wanted = 3 if p.type == "color" else 1
    try:
        numbers = [float(part) for part in parts]
    except ValueError:
        numbers = []
    if len(numbers) != wanted or not all(map(math.isfinite, numbers)):
        wants = "three numbers, as in 0.9,0.6,0.2" if wanted == 3 else "a number"
        raise Usage(f"--set {whole}: {p.name} takes {wants}.")
    if not all(p.low <= x <= p.high for x in numbers) and p.type != "color":
        raise Usage(f"--set {whole}: {p.name} goes from {p.low:g} to {p.high:g}.")
    if p.type == "color" and min(numbers) < 0:
        raise Usage(f"--set {whole}: a colour is not below 0.")
    return (numbers[0], numbers[1], numbers[2]) if wanted == 3 else numbers[0]
