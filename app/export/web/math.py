"""KaTeX (katex/, MIT licence) for a page with formulas: its script, its style, and the fonts those formulas need."""

import base64
import re
from functools import cache
from html import escape
from pathlib import Path

from app import prose

KATEX = Path(__file__).with_name("katex")
FACE = re.compile(r"@font-face\{[^}]*?url\(fonts/([\w-]+)\.woff2\)[^}]*\}")
SOURCE = re.compile(r"src:url\(fonts/([\w-]+)\.woff2\)[^;}]*")
ALWAYS = ("KaTeX_Main-Regular", "KaTeX_Math-Italic")
NEEDED = {  # font -> the LaTeX that asks for it
    "KaTeX_Size1-Regular": r"\\(left|right|big|Big|sum|int|prod|sqrt|dfrac|xrightarrow|overbrace|underbrace)",
    "KaTeX_Size2-Regular": r"\\(left|right|big|Big|sum|int|prod|sqrt)",
    "KaTeX_Size3-Regular": r"\\(left|right|big|Big|sqrt)",
    "KaTeX_Size4-Regular": r"\\(left|right|Big|sqrt|begin|overbrace|underbrace|widehat)",
    "KaTeX_Main-Bold": r"\\(mathbf|textbf|bf)",
    "KaTeX_Math-BoldItalic": r"\\(boldsymbol|bm)",
    "KaTeX_Main-Italic": r"\\(mathit|textit|emph)",
    "KaTeX_Caligraphic-Regular": r"\\mathcal",
    "KaTeX_Script-Regular": r"\\mathscr",
    "KaTeX_Fraktur-Regular": r"\\mathfrak",
    "KaTeX_SansSerif-Regular": r"\\(mathsf|textsf)",
    "KaTeX_Typewriter-Regular": r"\\(mathtt|texttt)",
    "KaTeX_AMS-Regular": r"\\(mathbb|lesssim|gtrsim|leqslant|geqslant|ltimes|square|checkmark|therefore|because)",
}


def fonts(text: str) -> tuple[str, ...]:
    """The fonts that the formulas of a text need."""
    latex = " ".join(formula.text for formula in prose.formulas(text))
    return (*ALWAYS, *(font for font, words in NEEDED.items() if re.search(words, latex)))


@cache
def script() -> str:
    return (KATEX / "katex.min.js").read_text("utf-8").replace("</script", r"<\/script")


@cache
def style(wanted: tuple[str, ...]) -> str:
    """KaTeX's style with these fonts in it, the others left out."""
    css = (KATEX / "katex.min.css").read_text("utf-8")

    def face(match: re.Match) -> str:
        return SOURCE.sub(embedded, match[0]) if match[1] in wanted else ""

    return FACE.sub(face, css)


def embedded(match: re.Match) -> str:
    data = base64.b64encode((KATEX / "fonts" / f"{match[1]}.woff2").read_bytes()).decode()
    return f'src:url(data:font/woff2;base64,{data}) format("woff2")'


@cache
def licence() -> str:
    return (KATEX / "LICENSE").read_text("utf-8").strip()


class Formulas:
    """Leaves formulas to the page: their LaTeX in an element that the player has KaTeX set."""

    def html(self, latex: str, display: bool) -> str:
        kind, tag = ("yes", "div") if display else ("no", "span")
        return f'<{tag} class="tex" data-display="{kind}">{escape(classed(latex.strip()))}</{tag}>'


def classed(formula: str) -> str:
    r"""\colour{l}{...} as a class, so that it follows the page's theme."""
    return prose.MACRO.sub(lambda match: rf"\htmlClass{{ink-{match['name']}}}{{", formula)
