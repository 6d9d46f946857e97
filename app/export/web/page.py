"""A step's page: one HTML file that asks the network for nothing."""

import base64
import hashlib
import json
from functools import cache
from html import escape
from pathlib import Path

from app.catalog import LoadedStep
from app.document import document
from app.export.markup import anchor, html
from app.export.web import math
from app.export.web.texts import Data, shared
from app.lesson import Step

PLAYER = Path(__file__).with_name("player")
CORE = ("gpu.js", "stage.js", "words.js", "plots.js")  # then what draws the kinds of plots a step has, then the page
KINDS = {"curves": ("curves.js",), "ledger": ("ledger.js",), "slice": ("models.js", "slices.js"),
         "space": ("models.js", "space.js"), "still": ()}


def file_of(id: str) -> str:
    return f"{anchor(id)}.html"


@cache
def text_of(name: str) -> str:
    return (PLAYER / name).read_text("utf-8")


def script(content: Data) -> str:
    """The player, with what draws this step's plots and no other."""
    kinds = [name for plot in content["plots"] for name in KINDS[plot["kind"]]]
    shapes = ("shapes.js",) if content["meshes"] else ()
    judged = ("models.js", "furnace.js", "badges.js") if content["badges"] else ()
    own = "".join(text_of(name) for name in (*CORE, *shapes, *dict.fromkeys((*kinds, *judged))))
    ours = {name for plot in content["plots"] for name in (plot["kind"],)}
    names = {"curves": "CurvesPlot", "slice": "SlicePlot", "ledger": "LedgerPlot", "space": "SpacePlot"}
    table = ", ".join(f"{kind}: {names[kind]}" for kind in names if kind in ours)
    return f'"use strict";\n{own}const KINDS = {{{table}}};\n{text_of("player.js")}'


def policy(scripts: list[str]) -> str:
    """Nothing from anywhere, and no script but the page's own, each named by its hash."""
    hashes = " ".join("'sha256-" + base64.b64encode(hashlib.sha256(one.encode()).digest()).decode() + "'"
                      for one in scripts)
    return (f"default-src 'none'; script-src {hashes}; style-src 'unsafe-inline'; img-src data:; font-src data:; "
            "base-uri 'none'; form-action 'none'")


def as_json(content: Data) -> str:
    return json.dumps(content, separators=(",", ":"), ensure_ascii=False, allow_nan=False).replace("</", r"<\/")


def uri(data: bytes, kind: str) -> str:
    return f"data:image/{kind};base64,{base64.b64encode(data).decode()}"


def page(found: LoadedStep, content: Data, poster: bytes | None, stills: dict[int, bytes]) -> str:
    """The file's text; `poster` and `stills` (of plots that are pictures) are WebP."""
    step = found.step
    prose_html = html(step.prose, math.Formulas(), link)
    notes = html(step.notes, math.Formulas(), link)
    with_math = 'class="tex"' in prose_html + notes
    scripts = [script(content)] + [math.script()] * with_math
    style = (math.style(math.fonts(step.prose + step.notes)) if with_math else "") + text_of("page.css")
    style += "".join(f".ink-{name}{{color:var(--{name})}}" for name in content["themes"]["dark"]["css"])
    note = f"\n<!-- KaTeX 0.19.1\n{math.licence()}\n-->" if with_math else ""
    where = f"{found.chapter.title} · {found.index + 1} of {len(found.chapter.steps)}"
    still = f'<img src="{uri(poster, "webp")}" alt="The scene of this step, still" class="poster">' if poster else ""
    more = "" if any(value["more"] for value in content["values"]) else " hidden"
    whole = f"""<header><p class="where">{escape(where)}</p>
<h1>{escape(step.title)}</h1><p class="idea">{escape(step.idea)}</p></header>
<main>
<section id="scene" aria-label="Scene">
<div class="stage">
<canvas id="picture" tabindex="0" role="img"
aria-label="{escape(f"{step.title}: drag to turn, Ctrl and wheel to zoom")}"></canvas>
<div id="words" class="words" aria-hidden="true"></div><div id="grips" aria-hidden="true"></div>
{legend(content)}{still}
<p class="lost-note">The picture was lost by the graphics driver and will be drawn again.</p>
<p class="still-note">This browser draws no WebGL2, so the picture stands still here.</p>
</div>
<p id="faults" role="alert"></p>
<div class="bar">{breaks(content)}<button id="copy" type="button">Copy link</button>
<button id="reset" type="button">Reset</button><button id="theme" type="button">Theme</button></div>
<p id="broken" class="about" role="status"></p>
<div id="few" class="rows"></div><details id="more" class="rows"{more}><summary>more</summary></details>
</section>
<section class="side" aria-label="Numbers">
<dl id="numbers"></dl>
{badges(content)}
{plots(content, stills)}
{ask(content)}
</section>
<article>
<div class="prose">{prose_html}</div>
<details><summary>For the lecturer</summary>{notes}</details>
<p class="about"><b>Slides</b> {escape("; ".join(step.slides))}</p>
<p class="about"><b>Sources</b> {escape("; ".join(step.sources))}</p>
<p class="about"><b>Honesty</b> {escape(step.honesty)} {escape(honesty(step))}</p>
</article>
</main>
<p id="said" class="unseen" role="status"></p>
<noscript><p class="about">This page draws with a script of its own, and scripts are switched off.</p></noscript>
<script type="application/json" id="content">{as_json(shared(content))}</script>
{"".join(f"<script>{one}</script>" for one in scripts)}"""
    return document(f"{step.title} - Halfway", style, whole, policy(scripts), note)


def honesty(step: Step) -> str:
    """What a page does otherwise than the desktop."""
    out = " and ".join(one.label for one in step.leave_outs)
    kept = f"The desktop leaves out {out} where that changes next to nothing; this page always computes them. "
    return kept * bool(out) + "Numbers in this page are computed in float32."


def breaks(content: Data) -> str:
    return "".join(f'<label class="break"><input type="checkbox" value="{i}"> break it: {escape(one["label"])}</label>'
                   for i, one in enumerate(content["breaks"]))


def link(target: str) -> str:
    """A link of the prose: a state of this step, or the page of another."""
    if target.startswith("?"):
        return target
    id, mark, query = target.partition("?")
    return f"{file_of(id)}{mark}{query}" if "/" in id and "://" not in target else ""


def legend(content: Data) -> str:
    lines = "".join(f'<li class="ink-{e["ink"]}"><span>{escape(e["words"])}</span></li>'
                    for e in content["scene"]["legend"])
    return f'<ul class="key">{lines}</ul>' if lines else ""


def badges(content: Data) -> str:
    def one(model: Data) -> str:
        words = " ".join(f'<span class="{"kept" if b["ok"] else "broken"}" title="{escape(b["told"])}">'
                        f'{"✓" if b["ok"] else "✗"} {escape(b["short"])}</span>' for b in model["found"])
        return (f'<p class="badges"><b class="ink-{model["ink"]}">{escape(model["label"])}</b> {words}'
                '<small> of other values</small></p>')

    return "".join(map(one, content["badges"]))


def plots(content: Data, stills: dict[int, bytes]) -> str:
    tabs = "".join(f'<button type="button" aria-pressed="{"false" if i else "true"}">{escape(plot["title"])}</button>'
                   for i, plot in enumerate(content["plots"]))
    tabs = f'<div id="tabs">{tabs}</div>' if len(content["plots"]) > 1 else '<div id="tabs" hidden></div>'
    pictures = "".join(f'<img id="still-{i}" class="still" hidden src="{uri(data, "webp")}" '
                       f'alt="{escape(content["plots"][i]["title"])}, still">' for i, data in stills.items())
    return (f'<figure>{tabs}<h2 id="plot-title"></h2><ul id="legend"></ul><div id="plot"></div>{pictures}'
            '<figcaption id="plot-note"></figcaption></figure>')


def ask(content: Data) -> str:
    question = content["ask"]
    if question["choices"]:
        answer = "".join(f'<label><input type="radio" name="guess" value="{i}"> {escape(c["text"])}</label>'
                         for i, c in enumerate(question["choices"]))
    else:
        answer = ('<input id="guess" type="range" min="0" max="1" step="0.005" value="0.5" aria-label="your guess">'
                  '<output id="guessed" for="guess"></output>')
    return (f'<div id="ask"><p>{escape(question["question"])}</p><div class="choices">{answer}'
            '</div><button id="reveal" type="button">Reveal</button><p id="verdict" role="status"></p>'
            f'<p id="told" hidden>{escape(question["told"])}</p></div>')
