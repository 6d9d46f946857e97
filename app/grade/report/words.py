"""What reports say of verdicts and numbers, in words of a person; numbers that are none are words already."""

import re

from app.quantities import TABLE, shown

VERDICTS = {
    "pass": "right", "partial": "partly right", "wrong": "wrong", "nonfinite": "not numbers",
    "unwritten": "not written", "missing": "missing", "rejected": "not accepted", "compile_error": "does not compile",
    "runtime_error": "stopped with an error", "timeout_cpu": "took too long", "timeout_wall": "took too long",
    "memory": "took too much memory", "crash": "crashed", "output_limit": "printed too much",
    "forbidden": "did what is not allowed", "skipped": "does not count yet", "ungraded": "not graded",
    "override": "marked by hand",
}
ILLEGAL = re.compile("[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")  # what XML 1.0 cannot hold at all
NO_VALUES = set(VERDICTS) - {"pass", "partial", "wrong", "nonfinite", "skipped", "override"}
NOT_YOURS = "The machine failed, not your text. This is no zero: it is graded again."
HIDDEN = "of the hidden points only the region and the counts are told"


def verdict(word: str) -> str:
    return VERDICTS.get(word, word.replace("_", " "))


def told(word: str, message: str) -> str:
    """The verdict and what the compiler or the function said."""
    return f"{verdict(word)}: {message}" if message else verdict(word)


def points(value: float) -> str:
    """Points, to a hundredth; what is not all is never rounded up to it."""
    return f"{int(value * 100 + 1e-6) / 100:g}"


def spoken(name: str, value) -> str:
    """An argument in the unit of the screen."""
    if isinstance(value, (list, str)) or name not in TABLE:
        return numbers(value, 6)
    unit = TABLE[name].screen_unit
    return f"{numbers(shown(name, value), 6)}{unit if unit == '°' else f' {unit}' if unit else ''}"


def numbers(value, digits: int = 9) -> str:
    if isinstance(value, (list, tuple)):
        return "(" + ", ".join(numbers(one, digits) for one in value) + ")"
    return value if isinstance(value, str) else f"{value:.{digits}g}"


def at(worst: dict) -> list[str]:
    """The arguments of a point."""
    return [f"{name} = {spoken(name, value)}" for name, value in worst["args"].items()]


def point(worst: dict) -> str:
    """A point on lines of plain text."""
    return "\n".join([*at(worst), f"expected  {numbers(worst['expected'])}", f"got       {numbers(worst['got'])}"])


def region(test: dict) -> str:
    """What a test is about: 'grazing, hidden'."""
    return test["region"] + (", hidden" if test["visibility"] == "hidden" else "")


def counted(test: dict) -> str:
    return f"{test['wrong']} of {test['points']}" if test["points"] else ""


def sentence(test: dict) -> str:
    """What is to say of a test that is not passed."""
    if test["verdict"] == "skipped":
        return "Counts when the values are right." if not test["wrong"] else test["message"]
    message = test["message"] or told(test["verdict"], test["rationale"])
    return message[0].upper() + message[1:]


def hint(item) -> str:
    """What to look at, of one function, in a sentence: the misconception, else what the costliest test says."""
    if item.suspects:
        return item.suspects[0]["message"]
    if item.said:
        return item.said[0].upper() + item.said[1:]
    costly = [test for test in item.failed if test["verdict"] != "skipped"] or item.failed
    return f"{region(costly[0])}: {sentence(costly[0])}" if costly else ""
