"""The index of exported pages: outline, search, and each step live where one looks. Pages are frames that come and go,
because a browser keeps at most 16 WebGL contexts alive."""

import json
from html import escape

from app import prose
from app.catalog import LoadedStep
from app.document import document
from app.export.markup import anchor
from app.export.web.page import file_of, policy, text_of


def page(done: list[LoadedStep], posters: bool) -> str:
    script = text_of("index.js")
    chapters = {found.loaded.id: found.chapter for found in done}
    body = "".join(section(id, chapter.title, chapter.idea, [f for f in done if f.loaded.id == id], posters)
                   for id, chapter in chapters.items())
    numbers = {found.loaded.id: found.loaded.number for found in done}
    outline = "".join(f'<li value="{numbers[id]}"><a href="#{anchor(id)}">{escape(chapter.title)}</a></li>'
                      for id, chapter in chapters.items())
    found = json.dumps({anchor(f.id): searched(f) for f in done}, ensure_ascii=False).replace("</", r"<\/")
    rules = policy([script]).replace("img-src data:", "img-src 'self' data: file:").replace(
        "base-uri", "frame-src 'self' file:; base-uri")
    whole = f"""<header><h1>Halfway</h1>
<p class="lead">The course in local shading that you can touch: {len(done)} steps, each a page of its own that needs no
network.</p>
<label class="search">Search
<input id="search" type="search" autocomplete="off" placeholder="solid angle, Fresnel, lux …"></label>
<p id="hits" role="status"></p><nav aria-label="Chapters"><ol>{outline}</ol></nav></header>
<main>{body}</main>
<footer>{SLIDES}</footer>
<script type="application/json" id="texts">{found}</script>
<script>{script}</script>"""
    return document("Halfway: the course in local shading that you can touch", text_of("index.css"), whole, rules)


def section(id: str, title: str, idea: str, steps: list[LoadedStep], posters: bool) -> str:
    cards = "".join(card(found, posters) for found in steps)
    return (f'<section id="{anchor(id)}"><h2>{escape(title)}</h2><p class="lead">{escape(idea)}</p>'
            f'<div class="cards">{cards}</div></section>')


def card(found: LoadedStep, posters: bool) -> str:
    name, step = anchor(found.id), found.step
    still = f'<img src="{name}.png" alt="" loading="lazy" width="1280" height="720">' if posters else ""
    return (f'<article id="card-{name}" data-page="{file_of(found.id)}"><div class="view">{still}</div>'
            f'<h3><a href="{file_of(found.id)}">{escape(step.title)}</a></h3><p>{escape(step.idea)}</p></article>')


def searched(found: LoadedStep) -> str:
    """What the search looks at: title, idea, slides, prose and the chapter's glossary word for this step."""
    step = found.step
    text = " ".join((step.title, step.idea, *step.slides, step.prose, step.ask.question, found.chapter.title))
    return " ".join(prose.FORMULA.sub(" ", text).split()).casefold()


SLIDES = """<details id="slides"><summary>Put a page beside your slides</summary>
<p>A page works in a frame, from a file, sandboxed too. Add a state after <code>?</code>, and <code>#scene</code> for
the scene with its sliders alone (also <code>#scene,light</code> or <code>#scene,projector</code>). The address of an
open page follows what you set; Copy link copies it.</p>
<ul><li>reveal.js: <code>&lt;iframe data-src="solid_angle-patch.html?tilt=30#scene"&gt;&lt;/iframe&gt;</code></li>
<li>Quarto: the same with <code>data-external="1"</code>, the pages beside the deck.</li>
<li>PowerPoint, Google Slides, PDF: the PNG and the film (GIF) of the same name.</li></ul>
<p>Page Down and Page Up, a clicker's keys, move the deck also while the scene has the keyboard; Escape gives it all
keys back. A slide that comes back shows what was set there.</p>
<p>A page in a frame can be spoken to with <code>postMessage</code>:</p>
<ul><li><code>{halfway: "set", state: "tilt=30&amp;view=-50,22,6"}</code> sets what is named and leaves the rest.</li>
<li><code>{halfway: "get"}</code> is answered with <code>{halfway: "state", step, state, values, numbers}</code>: values
in radians and metres, numbers by their labels.</li>
<li><code>{halfway: "snapshot"}</code> is answered with <code>{halfway: "snapshot", step, state, png}</code>, a data
URL.</li>
<li>Unasked it tells <code>{halfway: "ready", step}</code> once it is drawn, its state after each change, and
<code>{halfway: "escape"}</code>.</li></ul></details>"""
