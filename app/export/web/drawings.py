"""The figures around a page's plots: tabs, titles, legends and notes; what is drawn in them is the player's."""

from html import escape

from app.export.web.texts import Data

FACES = (("from outside, −", "var(--n)"), ("from inside, +", "var(--r)"))


def figures(plots: list[Data], tabs: int, stills: dict[int, str]) -> str:
    """`tabs` of the plots can be chosen; the others stand in their places while something is broken."""
    buttons = "".join(f'<button type="button">{escape(plot["title"])}</button>' for plot in plots[:tabs])
    shown = "".join(figure(i, plot, stills.get(i, "")) for i, plot in enumerate(plots))
    return f'<div id="plots"><div id="tabs"{"" if tabs > 1 else " hidden"}>{buttons}</div>{shown}</div>'


def figure(i: int, plot: Data, still: str) -> str:
    title = escape(plot["title"])
    inside = {"still": f'<img class="still" src="{still}" alt="{title}, still">' if still else "",
              "ledger": ledger(plot) if plot["kind"] == "ledger" else "",
              "space": f'<canvas role="img" aria-label="{title}"></canvas><div class="words"></div>'}
    lines = "".join(map(sample, legend(plot)))
    return (f'<figure id="plot-{i}"{" hidden" if i else ""}><h2>{title}</h2><ul class="legend">{lines}</ul>'
            f'<div class="drawing {plot["kind"]}">{inside.get(plot["kind"], "")}</div>'
            f'<figcaption>{escape(note(plot))}<span></span></figcaption></figure>')


def legend(plot: Data) -> list[tuple[str, str, str]]:
    """The words, the style of a line or the colour of an area, and where the number of a lobe will stand."""
    number = " <output></output>"
    if plot["kind"] == "curves":
        return [(one["label"], one["style"], "") for i, one in enumerate(plot["curves"])
                if not plot["error"] or i != plot["exact"]]
    if plot["kind"] == "slice":
        return [(one["label"], one["style"], number) for one in plot["lobes"]]
    areas = {"lobes": [(one["label"], one["colour"], number) for one in plot.get("lobes", ())],
             "figure": [(one["label"], f"var(--{one['ink']})", "") for one in plot.get("areas", ())],
             "faces": [(*face, "") for face in FACES]}
    return areas.get(plot.get("what", ""), [])


def sample(line: tuple[str, str, str]) -> str:
    words, style, number = line
    drawn = (f'<path d="M2 5H28" fill="none" style="{style}"/>' if style.startswith("stroke") else
             f'<circle cx="15" cy="5" r="4.5" style="fill:{style}"/>')
    return f'<li><svg viewBox="0 0 30 10" aria-hidden="true">{drawn}</svg>{escape(words)}{number}</li>'


def note(plot: Data) -> str:
    """What is always said below; the player adds what depends on the values."""
    if plot["kind"] != "curves":
        return plot.get("note", "")
    floor = ", 0 drawn at 10⁻⁸" * plot["error"]
    return " · ".join(filter(None, (plot["y_label"] + floor, plot.get("note", ""))))


def ledger(plot: Data) -> str:
    def line(row: Data, first: bool) -> str:
        factor = "" if first else f'<span class="factor"><output></output> {escape(row["how"])}</span>'
        return f'<li>{factor}<span>{escape(row["label"])}</span><b><output></output></b></li>'

    columns = "".join(f'<ol>{"".join(line(row, not i) for i, row in enumerate(column))}</ol>'
                      for column in plot["columns"])
    return f'<div class="columns">{columns}</div>' + '<div class="balance"><i></i></div>' * bool(plot["balance"])
