"""The frame of a report's page: one file, no script, nothing from elsewhere, light and dark and on paper."""

from html import escape
from pathlib import Path

from app.document import document
from app.grade.report.words import ILLEGAL

CSS = Path(__file__).with_name("style.css")


def page(title: str, body: str) -> bytes:
    """`body` is HTML; the title is text."""
    return document(ILLEGAL.sub("", title), CSS.read_text("utf-8"), body).encode()


def clean(text: object) -> str:
    """Text that cannot be anything else."""
    return escape(ILLEGAL.sub("", str(text)))


def bar(share: float, words: str = "") -> str:
    """A share as a bar; `words` for those who do not see it."""
    kind = "full" if share >= 1 - 1e-9 else "none" if share <= 1e-9 else "part"
    width = 100 * min(max(share, 0.0), 1.0)
    return (f'<span class="bar {kind}" role="img" aria-label="{clean(words or f"{share:.0%}")}">'
            f'<i style="width:{width:.1f}%"></i></span>')


def stamp(grader: dict) -> str:
    """Seen in every report of a run whose isolation was lowered."""
    if not grader["unsandboxed"]:
        return ""
    return (f'<p class="stamp">UNSANDBOXED <span>isolation {clean(grader["level"])}: these texts ran with less '
            "protection than strangers' texts need</span></p>")


def foot(facts: dict) -> str:
    grader, assignment = facts["grader"], facts["assignment"]
    return (f'<footer><p>Isolation {clean(grader["level"])} · machine {clean(grader["fingerprint"])} · assignment '
            f'{clean(assignment["id"])} {clean(assignment["hash"])} · Halfway {clean(grader["version"])}. The same '
            "text on such a machine has the same mark.</p></footer>")
