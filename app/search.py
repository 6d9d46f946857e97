"""Search over what the course says: titles, slides, ideas, glossary, prose. Without accents, upper case or order."""

import re
import unicodedata
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from app import prose
from app.catalog import steps
from app.lesson import Chapter, Step
from app.paths import LESSONS

WEIGHTS = {"title": 8.0, "slide": 5.0, "term": 6.0, "idea": 4.0, "prose": 1.0, "chapter": 3.0}
FUNCTIONS = frozenset({"sin", "cos", "tan", "exp", "log", "max", "min"})
COMMAND = re.compile(r"\\([a-zA-Z]+)")
AROUND = 70  # letters of a snippet on each side of the word


@dataclass(frozen=True)
class Hit:
    step: str
    title: str
    where: str  # a key of WEIGHTS
    snippet: str
    score: float


@dataclass(frozen=True)
class Passage:
    step: str
    title: str
    where: str
    text: str
    folded: str
    words: frozenset[str]


def search(query: str, folder: Path = LESSONS, limit: int = 20) -> list[Hit]:
    """Steps whose text has every word of the query (or a word that begins so), the best place of each, best first."""
    wanted = re.findall(r"\w+", folded(query))
    best: dict[str, Hit] = {}
    for passage in passages(folder) if wanted else ():
        score = WEIGHTS[passage.where] * rank(wanted, passage)
        if score > best.get(passage.step, NOTHING).score:
            best[passage.step] = Hit(passage.step, passage.title, passage.where, snippet(passage, wanted), score)
    return sorted(best.values(), key=lambda hit: -hit.score)[:limit]  # stable: the course's order among equals


NOTHING = Hit("", "", "", "", 0.0)


def rank(wanted: list[str], passage: Passage) -> float:
    """0 if a word is missing; more for whole words, most for the very phrase."""
    total = 0.0
    for word in wanted:
        if word in passage.words:
            total += 1.0
        elif any(own.startswith(word) for own in passage.words):
            total += 0.6
        else:
            return 0.0
    return total / len(wanted) + (0.5 if " ".join(wanted) in passage.folded else 0.0)


@cache
def passages(folder: Path = LESSONS) -> tuple[Passage, ...]:
    found = []
    for loaded_step in steps(folder):
        step, chapter = loaded_step.step, loaded_step.chapter
        texts = [("title", step.title), ("idea", step.idea), ("prose", step.prose), ("prose", step.ask.question)]
        texts += [("slide", slide) for slide in step.slides]
        if loaded_step.index == 0:
            texts += [("chapter", f"{chapter.title}. {chapter.idea}"), ("prose", loaded_step.loaded.intro)]
        texts += [("term", f"{term}: {meaning}") for term, meaning in chapter.terms.items()
                  if home(term, chapter) is step]
        for where, text in texts:
            plain = readable(text)
            found.append(Passage(loaded_step.id, step.title, where, plain, folded(plain),
                                 frozenset(re.findall(r"\w+", folded(plain)))))
    return tuple(found)


def home(term: str, chapter: Chapter) -> Step:
    """The step that speaks of a term most: in full, or with most of its words and most often."""
    beginnings = [word[:6] for word in re.findall(r"\w+", folded(term))]

    def speaks(step: Step) -> tuple[int, int, int]:
        text = folded(f"{step.title} {step.idea} {readable(step.prose)} {step.notes}")
        counts = [text.count(word) for word in beginnings]
        return text.count(folded(term)), sum(map(bool, counts)), min(counts, default=0)

    return max(chapter.steps, key=speaks)  # the first of equals


def readable(text: str) -> str:
    """Prose as plain words: links without targets, formulas without colours, one line."""
    text = prose.FORMULA.sub(lambda match: " " if match["display"] else match[0], prose.plain(text))
    text = prose.LINK.sub(lambda match: match["words"], text)
    return " ".join(COMMAND.sub(greek, re.sub(r"[*_`${}]+|\\[^a-zA-Z]", " ", text)).split())


def greek(command: re.Match) -> str:
    try:
        return unicodedata.lookup(f"GREEK SMALL LETTER {command[1].removeprefix('var')}")
    except KeyError:
        return f"{command[1]} " if command[1] in FUNCTIONS else " "


def folded(text: str) -> str:
    """Lower case without accents."""
    apart = unicodedata.normalize("NFKD", text.casefold())
    return "".join(letter for letter in apart if not unicodedata.combining(letter))


def snippet(passage: Passage, wanted: list[str]) -> str:
    """The text around the first word found."""
    found = re.search(r"\b" + re.escape(wanted[0]), passage.folded)
    at = min(found.start() if found else 0, len(passage.text))
    start, end = max(0, at - AROUND), min(len(passage.text), at + AROUND)
    if start:
        start = passage.text.find(" ", start, at) + 1 or start
    if end < len(passage.text):
        end = passage.text.rfind(" ", at, end) if passage.text.rfind(" ", at, end) > at else end
    return "… " * bool(start) + passage.text[start:end] + " …" * (end < len(passage.text))
