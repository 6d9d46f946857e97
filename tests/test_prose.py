"""Prose: colours in formulas, links, what is unbalanced, how long it is; every formula of the course draws."""

import json
import subprocess
import sys

import pytest

from app import prose
from app.catalog import steps
from app.theme import THEMES

DARK, LIGHT = THEMES["dark"], THEMES["light"]
ALL = pytest.mark.parametrize("step", [found.step for found in steps()], ids=[found.id for found in steps()])


def test_colours_become_hex_of_the_theme_in_formulas_only():
    text = r"A $\colour{l}{\text{patch}} + \colour{n}{n}$ and $$\frac{\colour{l}{A'}}{r^2}$$ but not `\colour{l}{x}`."
    light = prose.for_screen(text, LIGHT, prose.KATEX)
    assert prose.for_screen(text, LIGHT) == light.replace(r"\textcolor", r"\fgcolor")
    assert light == (r"A $\textcolor{#E69F00}{\text{patch}} + \textcolor{#0072B2}{n}$ and "
                     r"$$\frac{\textcolor{#E69F00}{A'}}{r^2}$$ but not `\colour{l}{x}`.")
    assert prose.for_screen(text, DARK, prose.KATEX) != light


def test_formulas_in_order_with_their_kind():
    text = "one $a_1$, a price of \\$5, code `$x$`,\n\n$$\nb\n= c\n$$\n\nlast $d$."
    found = [(formula.text, formula.display) for formula in prose.formulas(text)]
    assert found == [("a_1", False), ("b\n= c", True), ("d", False)]


def test_plain_formulas_keep_everything_but_the_colour():
    text = r"\frac{\colour{l}{\text{arc}}}{r} + \colour{n}{n_{\colour{h}{1}}} \}"
    assert prose.plain(text) == r"\frac{{\text{arc}}}{r} + {n_{{1}}} \}"


def test_links_and_what_they_lead_to():
    text = ("Try [a narrow\nbeam](?half_angle=10), [both](?distance=0.5&width=2), [there](solid_angle/patch?tilt=30), "
            "[a page](https://example.org/a_(b)), ![not](picture.png), $[a](b)$.")
    found = prose.links(text)
    assert [(link.words, link.target, link.sets_values) for link in found] == [
        ("a narrow beam", "?half_angle=10", True), ("both", "?distance=0.5&width=2", True),
        ("there", "solid_angle/patch?tilt=30", True), ("a page", "https://example.org/a_(b)", False)]


@pytest.mark.parametrize(("text", "words"), [
    ("a $x", "opened"), ("$a}$", "} without"), (r"$\frac{a$", "{ without"), (r"$\left( a$", r"\left"),
    (r"$\begin{aligned} a \end{cases}$", r"\end"), (r"$\colour{red}{a}$", "red"), (r"$\right)$", r"\right"),
])
def test_what_is_wrong_is_said_with_the_formula(text, words):
    assert words in prose.balanced(text)


@pytest.mark.parametrize("text", ["", r"\$5 and \$6", r"$\left\{ a \right\}$", r"$\{a\}$ `$`", "$$\na\n$$"])
def test_balanced_prose(text):
    assert prose.balanced(text) is None


def test_words_count_what_is_read():
    assert prose.words("Two words, $x + y$ is one.\n\n$$a = b$$\n\n[three more words](?tilt=80) **bold** - end.") == 10


@ALL
def test_every_step_is_short_balanced_and_shows_its_links(step):
    assert prose.balanced(step.prose) is None
    assert 60 <= prose.words(step.prose) <= 150
    assert any(link.sets_values for link in prose.links(step.prose))


def test_every_formula_of_the_course_draws():
    """In a child: the formulas' own macros only (an unknown one is drawn in red), and ink in each."""
    texts = sorted({prose.coloured(f.text, LIGHT) for found in steps() for f in prose.formulas(found.step.prose)})
    child = subprocess.run([sys.executable, "-m", "app.export.formulas"], input=json.dumps(
        {"size": 20, "colour": "#000000", "formulas": [[text, True] for text in texts]}),
        capture_output=True, text=True, timeout=60, check=True)
    answers = json.loads(child.stdout)
    assert [text for text, answer in zip(texts, answers, strict=True) if answer.get("fault")] == []
