"""The studies as one page that needs no network: figures in both themes, tables, and what they were measured on."""

import base64
from html import escape
from pathlib import Path

from app.document import document
from app.export import target
from app.export.page import CSS
from app.export.png import png
from app.lesson import Study
from app.plots.efforts import whole
from app.study.record import TOLERANCES, Record
from app.study.table import HEADS, row, wins
from app.theme import THEMES

SIZE = 960, 720  # px
STYLE = """
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: 0.9rem; }
th, td { padding: 0.2rem 0.7rem; text-align: right; border-bottom: 1px solid var(--line); white-space: nowrap; }
th:first-child, td:first-child { text-align: left; }
td.lost { color: var(--quiet); }
td.silent { color: #D5008F; text-align: left; white-space: normal; }
td.first { font-weight: 700; }
nav a { white-space: nowrap; }
.wide { overflow-x: auto; }
.study { margin: 2.2rem 0 0; padding-top: 1.4rem; border-top: 1px solid var(--line); }
.study img { max-width: 100%; height: auto; border-radius: 10px; box-shadow: 0 0 0 1px var(--line); }
"""


class Report:
    """A folder that fills while the studies are measured: a PNG for each record and theme, at the end the page."""

    def __init__(self, folder: Path):
        self.folder = folder
        self.parts: list[str] = []
        self.counts: dict[str, int] = {}  # of a step's records
        self.outline: dict[str, list[str]] = {}  # the links to its cases, by a study's title

    def add(self, study: Study, record: Record) -> None:
        links = self.outline.setdefault(record.title, [])
        self.counts[record.step] = self.counts.get(record.step, 0) + 1
        file, number, shots = f"{record.step.replace('/', '_')}-{self.counts[record.step]}", len(self.parts), {}
        for theme, tail in (("light", ""), ("dark", "-dark")):
            shots[theme] = png(whole(study, record, SIZE, THEMES[theme]))
            target.write(self.folder / f"{file}{tail}.png", shots[theme])
        where = "" if record.where == "CPU" else ", pixels on the GPU"
        links.append(f'<a href="#s{number}">{escape((record.case or record.step) + where)}</a>')
        self.parts.append(section(number, escape(record.title + where), record, shots))

    def save(self, machine: dict, data: str) -> Path:
        """study.json and index.html."""
        target.write(self.folder / "study.json", data.encode())
        index = self.folder / "index.html"
        target.write(index, page([
            f"<li>{escape(title.partition(': ')[2] or title)}: {', '.join(links)}</li>"
            for title, links in self.outline.items()], self.parts, machine).encode())
        return index


def section(number: int, title: str, record: Record, shots: dict[str, bytes]) -> str:
    uris = {theme: f"data:image/png;base64,{base64.b64encode(shot).decode()}" for theme, shot in shots.items()}
    alt = escape(f"{record.title}, {record.case}: relative error against time for each method. {wins(record)}")
    return f"""<section class="study" id="s{number}">
<p class="where">{escape(record.step)}</p><h3>{title}</h3>
<p class="idea">{escape(record.case)}</p>
<picture><source media="(prefers-color-scheme: dark)" srcset="{uris['dark']}">
<img src="{uris['light']}" width="{SIZE[0]}" height="{SIZE[1]}" alt="{alt}"></picture>
<p>{escape(wins(record)[0].upper() + wins(record)[1:])} {escape(record.why)}</p>
<div class="wide">{table(record)}</div>
{left_out(record)}
</section>
"""


def left_out(record: Record) -> str:
    """The methods of the course that are of no use here, by reason."""
    by_reason: dict[str, list[str]] = {}
    for kind, reason in record.without.items():
        by_reason.setdefault(reason, []).append(kind)
    words = "; ".join(f"{', '.join(kinds)}, since {reason}" for reason, kinds in by_reason.items())
    return f'<p class="small">Left out: {escape(words)}.</p>' if words else ""


def table(record: Record) -> str:
    first = [record.winner(tolerance) for tolerance in TOLERANCES]
    rows = []
    for line in record.lines:
        cells = row(line)
        parts = [f"<td>{escape(cells[0])}</td>"]
        for i, cell in enumerate(cells[1:4]):
            won = first[i] is not None and first[i][0] is line  # type: ignore[index]
            parts.append(f'<td class="{"lost" if "not" in cell else "first" if won else ""}">{escape(cell)}</td>')
        parts += [f"<td>{escape(cell)}</td>" for cell in cells[4:6]]
        rows.append(f'<tr>{"".join(parts)}<td class="silent">{escape(cells[6])}</td></tr>')
    heads = "".join(f"<th>{escape(head)}</th>" for head in HEADS)
    return f"<table><thead><tr>{heads}</tr></thead><tbody>{''.join(rows)}</tbody></table>"


def page(outline: list[str], parts: list[str], machine: dict) -> str:
    ran = ", ".join(f"{name} {value}" for name, value in machine.items())
    whole = f"""<header class="top">
<h1>What a digit costs</h1>
<p class="lead">Error against run time: each method's relative error and the time of one estimate. Times are medians,
the bars their quartiles; errors are RMS over the seeds, and the worst of the angles where there are several.</p>
<nav aria-label="Studies"><ol>{"".join(outline)}</ol></nav>
</header>
<main>
{"".join(parts)}</main>
<footer class="end"><p class="small">Measured on: {escape(ran)}.</p></footer>"""
    return document("Halfway: error against run time", CSS.read_text(encoding="utf-8") + STYLE, whole)
