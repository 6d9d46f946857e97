"""Prose as HTML: Markdown, formulas as pictures in two colours, links that lead to pictures of their state."""

import base64
import re
from collections.abc import Callable
from html import escape
from typing import Protocol

from markdown_it import MarkdownIt
from mdit_py_plugins.dollarmath import dollarmath_plugin

from app import prose
from app.export.formulas import Picture, pictures
from app.readouts import raised
from app.theme import THEMES

Key = tuple[str, bool]  # a formula and whether it stands on a line of its own
LARGER = 1.13  # than the text: Latin Modern's small letters are lower
SCHEMES = {"dark": THEMES["dark"], "light": THEMES["light"]}


class Typesetter(Protocol):
    def html(self, latex: str, display: bool) -> str: ...


class Formulas:
    """Every formula of a page, drawn at once; each is shown with its LaTeX as its alternative text."""

    def __init__(self, texts: list[str]):
        self.keys: list[Key] = list(dict.fromkeys((f.text, f.display) for text in texts for f in prose.formulas(text)))
        self.drawn: dict[str, dict[Key, Picture | None]] = {}
        for scheme, theme in SCHEMES.items():
            wanted = [(prose.coloured(text, theme), display) for text, display in self.keys]
            self.drawn[scheme] = dict(zip(self.keys, pictures(wanted, theme.foreground), strict=True))

    def html(self, latex: str, display: bool) -> str:
        """A <picture> that follows the colour scheme; the LaTeX itself where it could not be drawn."""
        key = latex.strip(), display
        dark, light = (self.drawn[scheme].get(key) for scheme in ("dark", "light"))
        words = escape(prose.plain(key[0]))
        if dark is None or light is None:
            return f"<code>{words}</code>"
        width, height, depth = (LARGER * part for part in (light.width, light.height, light.depth))
        place = f"width:{width:.3f}em;height:{height:.3f}em;vertical-align:{-depth:.3f}em"
        return (f'<picture><source media="(prefers-color-scheme: dark)" srcset="{uri(dark.png)}">'
                f'<img src="{uri(light.png)}" alt="{words}" style="{place}"></picture>')


def uri(png: bytes) -> str:
    return "data:image/png;base64," + base64.b64encode(png).decode()


def html(text: str, formulas: Typesetter, link: Callable[[str], str] = lambda target: "") -> str:
    """Markdown as HTML; `link` gives the place a state leads to. Other links are words: nothing is fetched."""
    reader = MarkdownIt("commonmark", {"html": False}).disable("image")
    dollarmath_plugin(reader, double_inline=True, allow_labels=False,
                      renderer=lambda latex, how: formulas.html(latex, how["display_mode"]))
    ends: list[str] = []

    def opened(self, tokens, i, options, env) -> str:
        place = link(str(tokens[i].attrs.get("href", "")))
        ends.append("</a>" if place else "</em>")
        return f'<a href="{escape(place)}">' if place else "<em>"

    reader.add_render_rule("link_open", opened)
    reader.add_render_rule("link_close", lambda self, tokens, i, options, env: ends.pop())
    return reader.render(text.strip())


def number(text: str) -> str:
    """6.80e-5 sr with a raised exponent."""
    return "".join(f"<sup>{escape(part)}</sup>" if up else escape(part) for part, up in raised(text))


def anchor(*parts: str) -> str:
    return re.sub(r"[^A-Za-z0-9_-]+", "-", "-".join(parts))
