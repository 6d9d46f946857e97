"""A step of the course in a notebook: the very page that `halfway export` writes, in Jupyter, VS Code and marimo.

    from app.notebook import show
    show("fresnel/schlick?theta=60")

An iframe whose whole page stands in its `srcdoc`: every notebook shows HTML, none needs an extension, and a saved
notebook still runs where nothing of ours is installed.
"""

from html import escape

from app.catalog import step
from app.state import parse, write

HEIGHT = 640  # px


class Page:
    """What a notebook displays; `height` in px."""

    def __init__(self, state: str, height: int = HEIGHT):
        self.height = height
        found = parse(state)  # a sentence for what is no state, before anything is made
        self.step = step(found.step)
        self.state = write(self.step, found.values, found.view)

    @property
    def html(self) -> str:
        """The page; it is told its state from within, as a page in srcdoc has no address to carry it."""
        from app.export.web.content import content
        from app.export.web.page import page

        data = {**content(self.step), "begin": self.state.partition("?")[2]}
        return page(self.step, data, None, {})

    def _repr_html_(self) -> str:
        """What Jupyter, VS Code, marimo and nbviewer ask for."""
        return (f'<iframe srcdoc="{escape(self.html, quote=True)}" title="{escape(self.state, quote=True)}" '
                f'sandbox="allow-scripts" style="width: 100%; height: {self.height}px; border: 0"></iframe>')

    def _mime_(self) -> tuple[str, str]:
        """What marimo asks for first."""
        return "text/html", self._repr_html_()

    def __repr__(self) -> str:
        return f"show({self.state!r})"


def show(state: str, height: int = HEIGHT) -> Page:
    """The last expression of a cell: a state as a page to touch.

    `state` is a state string, `height` in px. Raises Usage, in one sentence, for a step or a value that is not there.
    """
    return Page(state, height)
