"""report.html of one student: the mark, what to fix first, then every function with its worst point and a curve."""

import re

from app.grade.report import curve
from app.grade.report.frame import bar, clean, foot, page, stamp
from app.grade.report.stored import Item, Sheet
from app.grade.report.words import HIDDEN, NOT_YOURS, at, counted, hint, numbers, points, region, sentence

BASE64 = re.compile(r"[A-Za-z0-9+/=]+")


def report(sheet: Sheet) -> bytes:
    whole = sheet.result["tests"] and not sheet.at_once  # else there is nothing to say of each function
    body = (f'<header>{stamp(sheet.facts["grader"])}<p class="over">{clean(sheet.assignment["title"])}</p>'
            f'<h1>{clean(sheet.student)}</h1>{mark(sheet)}</header>\n<main>\n{first(sheet)}'
            f'{outline(sheet.items) + "".join(map(section, sheet.items)) if whole else ""}</main>\n{foot(sheet.facts)}')
    return page(f"{sheet.student}: {sheet.assignment['title']}", body)


def mark(sheet: Sheet) -> str:
    if sheet.mark is None:
        return (f'<p class="mark">Not graded yet</p><p class="lead">{clean(NOT_YOURS)}</p>'
                f'<p class="note">{clean(sheet.result.get("why", ""))}</p>')
    said = [f"Visible points: {sheet.visible}" + (f"; hidden ones: {sheet.hidden}." if sheet.hidden else ".")
            ] if sheet.visible else []
    late, override = sheet.result["late_share"], sheet.override
    if override:
        graded = sheet.result.get("score")
        said.append(f"The mark was given by hand{'' if graded is None else f' (the grader: {points(graded)})'}: "
                    f"{override['reason']}")
    if late < 1:
        said.append(f"Handed in late: {late:.0%} of the points count.")
    return (f'<p class="mark"><b>{points(sheet.mark)}</b> of {points(sheet.most)} points'
            f'{bar(sheet.mark / sheet.most)}</p><p class="lead">{clean(" ".join(said))}</p>')


def first(sheet: Sheet) -> str:
    """What to do first, in two lines."""
    item, said = sheet.first, sheet.at_once
    if sheet.result["verdict"] == "ungraded" or item is None:
        return "" if sheet.result["verdict"] == "ungraded" else (
            '<section class="first right"><h2>All is right</h2><p>Every visible and hidden point, every property.</p>'
            "</section>\n")
    if said:
        return (f'<section class="first"><p class="over">Fix this first</p><h2>Nothing could be judged</h2>'
                f'<pre class="said">{clean(said)}</pre></section>\n')
    pays = f"worth {points(item.lost)} points more"
    others = [one for one in sheet.items if one.lost > 0 and one is not item]
    then = f'<p class="then">Then {", ".join(link(one) for one in others)}.</p>' if others else ""
    return (f'<section class="first"><p class="over">Fix this first · {clean(pays)}</p>'
            f'<h2>{link(item)}</h2><p class="hint">{clean(hint(item))}</p>{then}</section>\n')


def anchor(item: Item) -> str:
    return f"f-{clean(item.function)}"


def link(item: Item) -> str:
    return f'<a href="#{anchor(item)}"><code>{clean(item.function)}</code></a>'


def outline(items: list[Item]) -> str:
    if len(items) < 2:
        return ""
    rows = "".join(f'<a href="#{anchor(item)}"><code>{clean(item.function)}</code>'
                   f'<span>{points(item.total("score"))} of {points(item.total("max"))}</span>'
                   f'{bar(item.total("score") / max(item.total("max"), 1e-9))}</a>' for item in items)
    return f'<nav aria-label="Functions">{rows}</nav>\n'


def section(item: Item) -> str:
    right = item.lost <= 0
    head = (f'<h2><code>{clean(item.function)}</code><span class="pill {"right" if right else "wrong"}">'
            f'{points(item.total("score"))} of {points(item.total("max"))}</span></h2>')
    slide = f'<p class="slide">Slide: {clean(item.task["slide"])}</p>' if item.task["slide"] else ""
    asked = f'<p class="asked">{clean(item.task["text"])}</p>{slide}'
    if right:
        inner = f'<p class="good">✓ {len(item.tests)} checks passed.</p>'
    elif item.said:
        inner = f'<pre class="said">{clean(item.said)}</pre>'
    else:
        inner = f"{suspects(item)}{worst(item)}{pictures(item)}{checks(item)}"
    return f'<section class="item" id="{anchor(item)}">{head}{asked}{inner}</section>\n'


def suspects(item: Item) -> str:
    return "".join(f'<p class="suspect"><b>{clean(one["id"].replace("_", " "))}</b> {clean(one["message"])}</p>'
                   for one in item.suspects)


def worst(item: Item) -> str:
    test = item.worst
    if test is None:
        return ""
    point = test["worst"]
    args = "<br>".join(map(clean, at(point)))
    drawn = "".join(curve.svg(one) for one in item.curves[:1])
    key = ('<p class="key"><span class="right">right</span><span class="yours">yours</span>'
           '<span class="here">the worst point</span></p>') if drawn else ""
    return (f'<div class="worst"><div><h3>The worst visible point<small>{clean(region(test))}</small></h3>'
            f'<dl><dt>at</dt><dd>{args}</dd>'
            f'<dt>expected</dt><dd class="right">{clean(numbers(point["expected"]))}</dd>'
            f'<dt>got</dt><dd class="yours">{clean(numbers(point["got"]))}</dd></dl></div>'
            f'{f"<figure>{drawn}{key}</figure>" if drawn else ""}</div>')


def pictures(item: Item) -> str:
    """Expected, yours, the signed error, FLIP."""
    found = [figure for test in item.tests for figure in test["figures"] if BASE64.fullmatch(figure["png"])]
    cells = "".join(f'<figure><img src="data:image/png;base64,{figure["png"]}" alt="{clean(figure["label"])}">'
                    f'<figcaption>{clean(figure["label"])}</figcaption></figure>' for figure in found)
    note = ('<p class="note">Signed error: grey is right, red too bright, blue too dark. FLIP: what the eye sees of it.'
            "</p>")
    return f'<div class="pictures">{cells}</div>{note}' if found else ""


def checks(item: Item) -> str:
    rows = "".join(row(test) for test in item.failed)
    passed = len(item.tests) - len(item.failed)
    more = f'<p class="good">✓ {passed} other checks passed.</p>' if passed else ""
    note = (f'<p class="note">{HIDDEN[0].upper()}{HIDDEN[1:]}.</p>'
            if any(test["visibility"] == "hidden" for test in item.failed) else "")
    heads = "".join(f"<th>{word}</th>" for word in ("Check", "Points", "Wrong", "Why"))
    return (f'<div class="wide"><table class="checks"><thead><tr>{heads}</tr></thead><tbody>{rows}</tbody></table>'
            f"</div>{more}{note}")


def row(test: dict) -> str:
    return (f'<tr><td>{clean(region(test))}</td><td>{points(test["score"])} of {points(test["max"])}</td>'
            f"<td>{counted(test)}</td><td>{clean(sentence(test))}</td></tr>")
