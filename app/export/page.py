"""The gallery's index.html: every step of the course on one page, without a script and without the network."""

from dataclasses import dataclass, field
from html import escape
from pathlib import Path

from app import prose
from app.badges import SHORT, Badge, told
from app.catalog import Loaded, LoadedStep
from app.document import document
from app.export.markup import Formulas, anchor, html, number
from app.prediction import quantity
from app.readouts import Number

POLICY = "default-src 'none'; img-src 'self' data: file:; style-src 'unsafe-inline'"
CSS = Path(__file__).with_name("gallery.css")


@dataclass(frozen=True)
class Try:
    """A link of the prose as a picture: what it says, the state it sets, the file."""

    target: str
    words: str
    state: str
    picture: str


@dataclass
class Shown:
    """A step as it came out; with a fault, what there is of it."""

    found: LoadedStep
    state: str = ""
    scene: str = ""  # files, relative to the page
    plots: list[str] = field(default_factory=list)
    badges: dict[str, dict[str, Badge]] = field(default_factory=dict)  # of each model
    numbers: list[Number] = field(default_factory=list)
    tries: list[Try] = field(default_factory=list)
    truth: float | None = None
    fault: str = ""


def page(chapters: list[tuple[Loaded, list[Shown]]], note: str = "") -> str:
    steps = [one.found.step for _, shown in chapters for one in shown]
    formulas = Formulas([text for step in steps for text in (step.prose, step.notes)])
    outline = "".join(f"<p>{escape(c.chapter.title)}</p><ol>{''.join(map(entry, shown))}</ol>" for c, shown in chapters)
    body = "".join(chapter(loaded, shown, formulas) for loaded, shown in chapters)
    whole = f"""<header class="top">
<h1>Halfway</h1>
<p class="lead">The course in local shading that you can touch. Here it stands still: each step as a picture, with its
question, its numbers and its sources.</p>
<nav aria-label="Steps">{outline}</nav>
</header>
<main>
{body}</main>
<footer class="end"><p class="small">{escape(note)} Where there is a display, <code>halfway</code> opens the window, and
<code>halfway show STATE</code> any picture of this page.</p></footer>"""
    style = CSS.read_text(encoding="utf-8")
    return document("Halfway: the course in local shading that you can touch", style, whole, POLICY)


def entry(one: Shown) -> str:
    return f'<li><a href="#{anchor(one.found.id)}">{escape(one.found.step.title)}</a></li>'


def chapter(loaded: Loaded, shown: list[Shown], formulas: Formulas) -> str:
    intro = "".join(f"<p>{escape(' '.join(part.split()))}</p>" for part in loaded.intro.split("\n\n") if part.strip())
    fault = f'<p class="fault">{escape(loaded.fault)}</p>' if loaded.fault else ""
    steps = "".join(section(one, len(loaded.chapter.steps), formulas) for one in shown)
    return (f'<h2 id="{anchor(loaded.id)}">{escape(loaded.chapter.title)}</h2>\n'
            f'<p class="lead">{escape(loaded.chapter.idea)}</p>\n<div class="intro">{intro}</div>\n{fault}{steps}')


def section(one: Shown, of: int, formulas: Formulas) -> str:
    step, id = one.found.step, anchor(one.found.id)
    beyond = " · beyond the deck" if step.beyond else ""
    where = f"{one.found.chapter.title} · {one.found.index + 1} of {of} · {step.minutes:g} minutes{beyond}"
    places = {t.target: f"#{place(one, i)}" for i, t in enumerate(one.tries)}
    fault = f'<p class="fault">This step is not complete: {escape(one.fault)}</p>\n' if one.fault else ""
    return f"""<section class="step" id="{id}">
<p class="where">{escape(where)}</p>
<h3>{escape(step.title)}</h3>
<p class="idea">{escape(step.idea)}</p>
{fault}{figures(one)}<div class="columns">
<div class="prose">{html(step.prose, formulas, lambda target: places.get(target, ""))}</div>
<div>{numbers(one.numbers)}{badges(one.badges)}{ask(one)}
<details class="notes"><summary>For the lecturer</summary>{html(step.notes, formulas)}</details></div>
</div>
{tries(one)}<div class="about">
<p><b>Slides</b> {escape("; ".join(step.slides))}</p>
<p><b>Sources</b> {escape("; ".join(step.sources))}</p>
<p><b>Honesty</b> {escape(step.honesty)}</p>
<p><b>State</b> <code>{escape(one.state or one.found.id)}</code></p>
</div>
</section>
"""


def place(one: Shown, i: int) -> str:
    return anchor(one.found.id, "try", str(i + 1))


def figures(one: Shown) -> str:
    step = one.found.step
    words = {one.scene: f"{step.title}. {step.idea}"} | {
        file: f"Plot: {plot.title}" for file, plot in zip(one.plots, step.plots, strict=False)}
    found = [f'<figure><img src="{escape(file)}" alt="{escape(words[file])}" loading="lazy"></figure>'
             for file in (one.scene, *one.plots) if file]
    kind = {1: " one", 2: ""}.get(len(found), " many")
    return f'<div class="pictures{kind}">{"".join(found)}</div>\n' if found else ""


def numbers(shown: list[Number]) -> str:
    """The live numbers, at rest: value, error, cost; all digits as a tool-tip."""
    def one(n: Number) -> str:
        error = f"<small>{number(n.error_text)}</small>" if n.error_text else ""
        cost = f"<small>{escape(n.cost_text)} to compute</small>" if n.cost_text else ""
        return (f'<div class="{escape(n.role)}"><dt>{escape(n.label)}</dt>'
                f'<dd title="{escape(n.full_text)}">{number(n.text)}{error}{cost}</dd></div>')

    return f'<dl class="numbers">{"".join(map(one, shown))}</dl>' if shown else ""


def badges(shown: dict[str, dict[str, Badge]]) -> str:
    """What each model keeps and breaks; the worst value and its angles as a tool-tip."""
    def one(name: str, badge: Badge) -> str:
        mark, kind = ("✓", "kept") if badge.ok else ("✗", "broken")
        return f'<span class="{kind}" title="{escape(told(name, badge))}">{mark} {escape(SHORT[name])}</span>'

    return "".join(f'<p class="badges">{escape(label)} {"".join(one(*each) for each in found.items())}</p>'
                   for label, found in shown.items())


def ask(one: Shown) -> str:
    """The question first, the answer when it is asked for."""
    question = one.found.step.ask
    choices = "".join(f'<span class="choice">{escape(choice.text)}</span>' for choice in question.choices)
    answer = ""
    if one.truth is not None:
        right = [c.text for c in question.choices if c.low <= one.truth <= c.high]
        answer = f'<p class="truth">{escape(right[0] if right else quantity(one.truth, question.unit))}</p>'
    return (f'<details class="ask"><summary>{escape(question.question)}{choices}'
            f'<span class="reveal">Take a guess, then look</span></summary>'
            f"{answer}<p>{escape(question.told)}</p></details>")


def tries(one: Shown) -> str:
    found = [f'<figure id="{place(one, i)}"><img src="{escape(t.picture)}" alt="{escape(t.words)}" loading="lazy">'
             f"<figcaption>{escape(t.words)}<br><code>{escape(t.state.partition('?')[2] or 'as it starts')}</code>"
             f"</figcaption></figure>" for i, t in enumerate(one.tries)]
    return f'<div class="tries">{"".join(found)}</div>\n' if found else ""


def state_links(found: LoadedStep) -> list[prose.Link]:
    """The prose's links that set this step's values, each once."""
    seen = {link.target: link for link in prose.links(found.step.prose) if link.target.startswith("?")}
    return list(seen.values())
