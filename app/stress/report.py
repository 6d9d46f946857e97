"""A stress run as one page that needs no network: what fails, what naive forms lose, heat maps, every worst point."""

import base64
from collections.abc import Sequence
from html import escape
from io import BytesIO
from pathlib import Path

from app.document import document
from app.export import target
from app.export.page import CSS
from app.stress.heat import heat_map
from app.stress.judge import GLSL, NUMPY32, NUMPY64, Finding
from app.stress.scenes import Played
from app.stress.words import numbers, remarks, scene_lines, short, summary, times

STYLE = """
.find { margin: 1.6rem 0 0; padding-top: 1rem; border-top: 1px solid var(--line); }
.find img { max-width: 100%; height: auto; border-radius: 8px; box-shadow: 0 0 0 1px var(--line); }
.find code { font-size: 0.82rem; overflow-wrap: anywhere; }
.find table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: 0.9rem; }
.find th, .find td { padding: 0.15rem 0.8rem 0.15rem 0; text-align: left; }
.fails h3 { color: #D5008F; }
summary { cursor: pointer; padding: 0.5rem 0; }
"""
KINDS = (("fails", "Stable forms that fail"), ("naive", "Naive forms, and what they lose"),
         ("printed", "As printed, or with flaws on purpose"), ("stable", "Stable forms that hold"))


def save(findings: Sequence[Finding], scenes: Sequence[Played], folder: Path) -> Path:
    """index.html, and a PNG for each function that has an argument."""
    parts: dict[str, list[str]] = {kind: [] for kind, _ in KINDS}
    for one in findings:
        shot = file_of(one, folder)
        parts["fails" if one.fails else "printed" if one.kind == "meant" else one.kind].append(section(one, shot))
    index = folder / "index.html"
    target.write(index, page(parts, findings, scenes).encode())
    return index


def file_of(one: Finding, folder: Path) -> bytes:
    picture = heat_map(one)
    if picture is None:
        return b""
    out = BytesIO()
    picture.quantize(64).save(out, "PNG", optimize=True)
    target.write(folder / f"{one.function}.png", out.getvalue())
    return out.getvalue()


def section(one: Finding, shot: bytes) -> str:
    forms = {form.name: form for form in one.forms}
    rows = "".join(f"<tr><th>{name}</th><td>{escape(short(forms.get(name)).strip())}</td>"
                   f"<td>{escape(forms[name].judge) if name in forms else ''}</td></tr>"
                   for name in (GLSL, NUMPY32, NUMPY64))
    worst = "".join(f"<p>{escape(times(e.error))} ({escape(e.form)}): {escape(numbers(e.got))} for "
                    f"{escape(numbers(e.true))}<br><code>{escape(e.paste)}</code></p>" for e in one.examples)
    alt = escape(f"{one.function}: the worst error at each pair of its arguments")
    image = f'<img alt="{alt}" src="data:image/png;base64,{base64.b64encode(shot).decode()}">' if shot else ""
    said = escape(remarks(one).removeprefix("; "))
    return f"""<section class="find{' fails' if one.fails else ''}" id="{one.function}">
<h3>{one.function}</h3><p class="idea">{escape(one.file)}, {one.points} points. {said}</p>
<table><tbody><tr><th></th><td>worst</td><td>judge</td></tr>{rows}</tbody></table>
{worst}{image}</section>
"""


def page(parts: dict[str, list[str]], findings: Sequence[Finding], scenes: Sequence[Played]) -> str:
    told = "".join(f"<p>{escape(line)}</p>" for line in (summary(list(findings)).split("\n") if findings else ()))
    body = "".join(f"<details{' open' if kind != 'stable' else ''}><summary><strong>{title}</strong> "
                   f"({len(parts[kind])})</summary>{''.join(parts[kind])}</details>"
                   for kind, title in KINDS if parts[kind])
    played = "".join(f"<p>{escape(line)}</p>" for line in (scene_lines(list(scenes)) if scenes else ()))
    whole = f"""<header class="top">
<h1>Formulas at their extremes</h1>
<p class="lead">Each function over the extremes of its arguments, in float32 on the GPU and in float64. Errors are in
units of the tolerance's u (1 + cond + kappa); up to 8 is rounding. In a map the colour is the worst error of a cell,
from dark to bright on a logarithmic scale; a dot is beyond 8, a crossed cell holds a value that is no number, infinite,
negative or out of range, and a grey one was not tried.</p>
{told}{played}
</header>
<main>{body}</main>"""
    return document("Halfway: formulas at their extremes", CSS.read_text(encoding="utf-8") + STYLE, whole)
