"""The prose of lessons: Markdown with $...$ and $$...$$, links that set values, our macro \\colour{l}{...}. Pure text.

The macro names a word of the grammar; a front end gets the colour in the words of its own LaTeX.
"""

import re
from dataclasses import dataclass

from app.lesson import Colour
from app.theme import GRAMMAR, Theme, colour

FORMULA = re.compile(r"(?P<code>`[^`]*`)|(?<!\\)\$\$(?P<display>.+?)(?<!\\)\$\$"
                     r"|(?<!\\)\$(?P<inline>[^$]+?)(?<!\\)\$", re.S)
LINK = re.compile(r"(?<!!)\[(?P<words>[^\]\n]+(?:\n[^\]\n]+)?)\]\((?P<target>[^()\s]+(?:\([^()\s]*\))?)\)")
STATE = re.compile(r"\?|[a-z]\w*/[a-z]\w*(\?|$)")  # ?tilt=80, or solid_angle/patch?tilt=80
MACRO = re.compile(r"\\colou?r\s*\{(?P<name>[^{}]*)\}\s*\{")
MICROTEX, KATEX = r"\fgcolor", r"\textcolor"  # MicroTeX's own \textcolor sets letters upright, KaTeX has no \fgcolor
NAMES = (*GRAMMAR, "exact", "quiet", "g")
PAIRS = re.compile(r"\\(left|right|begin|end)\b(?:\s*\{(\w+\*?)\})?")


@dataclass(frozen=True)
class Formula:
    text: str
    display: bool  # on a line of its own


@dataclass(frozen=True)
class Link:
    words: str
    target: str

    @property
    def sets_values(self) -> bool:
        """It leads to a state of a step: ?tilt=80 of this one, chapter/step?tilt=80 of any."""
        return bool(STATE.match(self.target))


def for_screen(prose: str, theme: Theme, macro: str = MICROTEX) -> str:
    """The prose with the grammar's colours of a theme in its formulas; all else as it is."""
    return FORMULA.sub(lambda match: match[0] if match["code"] else coloured(match[0], theme, macro),
                       prose.strip())


def coloured(formula: str, theme: Theme, macro: str = MICROTEX) -> str:
    """One formula with its \\colour{name}{...} as \\fgcolor{#RRGGBB}{...}."""
    return MACRO.sub(lambda match: f"{macro}{{{hex_colour(match['name'], theme)}}}{{", formula)


def hex_colour(name: Colour | str, theme: Theme) -> str:
    return "#" + "".join(f"{round(255 * part):02X}" for part in colour(name, theme))


def plain(formula: str) -> str:
    """A formula without its colours: what a reader's program says, and what is searched."""
    found, at = [], 0
    for match in MACRO.finditer(formula):
        if match.start() >= at:
            end = closing(formula, match.end())
            found += [formula[at:match.start()], "{", plain(formula[match.end():end]), "}"]
            at = end + 1
    return "".join([*found, formula[at:]])


def closing(text: str, start: int) -> int:
    """Where the brace that was opened before `start` is closed (the end of the text if it is not)."""
    depth = 1
    for match in re.compile(r"\\.|[{}]", re.S).finditer(text, start):
        depth += {"{": 1, "}": -1}.get(match[0], 0)
        if depth == 0:
            return match.start()
    return len(text)


def formulas(prose: str) -> list[Formula]:
    return [Formula((match["display"] or match["inline"]).strip(), bool(match["display"]))
            for match in FORMULA.finditer(prose) if not match["code"]]


def links(prose: str) -> list[Link]:
    """The links outside formulas, in the order of reading."""
    outside = FORMULA.sub(lambda match: match[0] if match["code"] else "$", prose)
    return [Link(" ".join(match["words"].split()), match["target"]) for match in LINK.finditer(outside)]


def words(prose: str) -> int:
    """Words to read: a formula in a line counts as one, a formula of its own as none."""
    text = FORMULA.sub(lambda match: " " if match["display"] else "x", prose)
    text = LINK.sub(lambda match: match["words"], text)
    return sum(any(letter.isalnum() for letter in word) for word in text.split())


def balanced(prose: str) -> str | None:
    """What is wrong with the formulas of a prose, in one sentence; None when all is well."""
    rest = FORMULA.sub("", prose)
    if stray := re.search(r"(?<!\\)\$", rest):
        line = rest[stray.start():].strip().splitlines()[0]
        return f"a $ is opened and not closed: {line[:60]}"
    for formula in formulas(prose):
        if wrong := fault(formula.text):
            return f"{wrong} in the formula {formula.text}"
    return None


def fault(formula: str) -> str | None:
    depth = 0
    for match in re.finditer(r"\\.|[{}]", formula, re.S):
        depth += {"{": 1, "}": -1}.get(match[0], 0)
        if depth < 0:
            return "a } without its {"
    if depth:
        return "a { without its }"
    opened: list[str] = []
    for match in PAIRS.finditer(formula):
        word = match[2] or ""
        if match[1] in ("left", "begin"):
            opened.append(word)
        elif not opened or opened.pop() != word:
            return rf"a \{match[1]} without its partner"
    if opened:
        return r"a \left or \begin without its partner"
    for match in MACRO.finditer(formula):
        if match["name"] not in NAMES:
            return rf"\colour{{{match['name']}}} (the colours are {', '.join(NAMES)})"
    return None
