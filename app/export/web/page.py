"""A step's page: one HTML file that asks the network for nothing."""

import base64
import hashlib
import json
from functools import cache
from html import escape
from pathlib import Path

from app.catalog import LoadedStep
from app.document import document
from app.export.corners import entries
from app.export.markup import anchor, html
from app.export.web import math
from app.export.web.content import inks
from app.export.web.controls import ask, breaks, grips, numbers, rows
from app.export.web.drawings import figures
from app.export.web.texts import Data, shared
from app.lesson import Scene, Step
from app.theme import THEMES

PLAYER = Path(__file__).with_name("player")
CORE = ("values.js", "written.js", "gpu.js", "twins.js", "camera.js", "stage.js", "labels.js", "hand.js", "page.js",
        "controls.js", "frame.js")  # then what only some steps have, and what draws the kinds of plots
KINDS = {"curves": ("CurvesPlot", ("scale.js", "svg.js", "curves.js")), "ledger": ("LedgerPlot", ("ledger.js",)),
         "slice": ("SlicePlot", ("scale.js", "svg.js", "models.js", "slices.js")),
         "space": ("SpacePlot", ("scale.js", "models.js", "space.js"))}

WORDS = ":is(.words,.badges,.prose)"  # coloured words; lines and areas keep the picture's colours


def file_of(id: str) -> str:
    return f"{anchor(id)}.html"


@cache
def text_of(name: str) -> str:
    return (PLAYER / name).read_text("utf-8")


def script(content: Data) -> str:
    """The player, with what this step uses and no more."""
    kinds = {plot["kind"]: KINDS[plot["kind"]] for plot in content["plots"] if plot["kind"] in KINDS}
    some = {"grips.js": content["scene"]["handles"], "breaking.js": content["breaks"], "shapes.js": content["meshes"]}
    judged = ("models.js", "furnace.js", "badges.js") if content["badges"] else ()
    files = dict.fromkeys((*CORE, *(name for name, used in some.items() if used),
                           *(name for _, names in kinds.values() for name in names), *judged))
    table = ", ".join(f"{kind}: {made}" for kind, (made, _) in kinds.items())
    return f'"use strict";\n{"".join(map(text_of, files))}const KINDS = {{{table}}};\n{text_of("start.js")}'


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
    scripts = [script(content)] + [math.script() + text_of("typeset.js")] * with_math
    style = (math.style(math.fonts(step.prose + step.notes)) if with_math else "") + text_of("page.css")
    style += "".join(themed(name, inks(theme)) for name, theme in THEMES.items())
    note = f"\n<!-- KaTeX 0.19.1\n{math.licence()}\n-->" if with_math else ""
    where = f"{found.chapter.title} · {found.index + 1} of {len(found.chapter.steps)}"
    still = f'<img src="{uri(poster, "webp")}" alt="The scene of this step, still" class="poster">' if poster else ""
    few, more = ([spec for spec in found.values.values() if spec.more == late] for late in (False, True))
    shown = {i: uri(data, "webp") for i, data in stills.items()}
    whole = f"""<header><p class="where">{escape(where)}</p>
<h1>{escape(step.title)}</h1><p class="idea">{escape(step.idea)}</p></header>
<main>
<section id="scene" aria-label="Scene">
<div class="stage">
<canvas id="picture" tabindex="0" role="img"
aria-label="{escape(f"{step.title}: drag to turn, Ctrl and wheel to zoom")}"></canvas>
<div id="words" class="words" aria-hidden="true"></div>
<div id="grips" aria-hidden="true">{grips(step.scene.handles)}</div>
{legend(step.scene)}{still}
<p class="lost-note">The picture was lost by the graphics driver and will be drawn again.</p>
<p class="still-note">This browser draws no WebGL2, so the picture stands still here.</p>
</div>
<p id="faults" role="alert"></p>
<div class="bar">{breaks(found)}<button id="copy" type="button">Copy link</button>
<button id="reset" type="button">Reset</button><button id="theme" type="button">Theme</button></div>
<p id="broken" class="about" role="status"></p>
<div id="few" class="rows">{rows(few)}</div>
<details id="more" class="rows"{"" if more else " hidden"}><summary>more</summary>{rows(more)}</details>
</section>
<section class="side" aria-label="Numbers">
<dl id="numbers">{numbers(found)}</dl>
{badges(content)}
{figures(content["plots"], len(step.plots), shown)}
{ask(step.ask)}
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


def link(target: str) -> str:
    """A link of the prose: a state of this step, or the page of another."""
    if target.startswith("?"):
        return target
    id, mark, query = target.partition("?")
    return f"{file_of(id)}{mark}{query}" if "/" in id and "://" not in target else ""


def legend(scene: Scene) -> str:
    lines = "".join(f'<li class="ink-{e.mark.colour if e.mark else e.colour}"><span>{escape(e.words)}</span></li>'
                    for e in entries(scene))
    return f'<ul class="key">{lines}</ul>' if lines else ""


def themed(name: str, colours: dict[str, str]) -> str:
    """A theme's colours as variables; the dark ones are everybody's who has no other."""
    variables = "".join(f"--{ink}:{colour};" for ink, colour in colours.items())
    classes = "".join(f".ink-{ink}{{color:var(--{ink})}}" for ink in colours if not ink.endswith("-text"))
    classes += "".join(f"{WORDS} .ink-{ink.removesuffix('-text')}{{color:var(--{ink})}}"
                       for ink in colours if ink.endswith("-text"))
    return f":root{{{variables}}}{classes}" if name == "dark" else f"[data-theme={name}]{{{variables}}}"


def badges(content: Data) -> str:
    def one(model: Data) -> str:
        words = " ".join(f'<span class="{"kept" if b["ok"] else "broken"}" title="{escape(b["told"])}">'
                        f'{"✓" if b["ok"] else "✗"} {escape(b["short"])}</span>' for b in model["found"])
        return (f'<p class="badges"><b class="ink-{model["ink"]}">{escape(model["label"])}</b> {words}'
                '<small> at other values</small></p>')

    return "".join(map(one, content["badges"]))
