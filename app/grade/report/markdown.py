"""report.md of one student: the same as the page, for a platform's comment or a terminal; nothing in it is markup."""

import re

from app.grade.report.stored import Item, Sheet
from app.grade.report.words import HIDDEN, ILLEGAL, NOT_YOURS, counted, hint, point, points, region, sentence

MARKUP = re.compile(r"[\\`*_{}\[\]<>#|!~&$]|(?<=\w)[:@](?=\S)|^(?=[-+=]|\d+[.)])")


def plain(text: object) -> str:
    """Text on one line that a renderer shows as it is."""
    return MARKUP.sub(lambda m: "\\" + m[0], " ".join(ILLEGAL.sub("", str(text)).split()))


def code(text: str) -> str:
    """Text as it is, on lines of its own; no run of ticks in it ends it early."""
    text = ILLEGAL.sub("", text)
    fence = "`" * max(3, 1 + max((len(run) for run in re.findall("`+", text)), default=0))
    return f"{fence}text\n{text}\n{fence}"


def report(sheet: Sheet) -> bytes:
    parts = [f"# {plain(sheet.student)}", plain(sheet.assignment["title"]), *head(sheet)]
    if sheet.result["tests"] and not sheet.at_once:
        for item in sheet.items:
            parts += section(item)
    grader = sheet.facts["grader"]
    parts.append(f"Isolation {grader['level']}, machine {grader['fingerprint']}, assignment "
                 f"{plain(sheet.assignment['id'])} {sheet.assignment['hash']}, Halfway {grader['version']}.")
    return ("\n\n".join(parts) + "\n").encode()


def head(sheet: Sheet) -> list[str]:
    found = [f"**UNSANDBOXED**: isolation {sheet.facts['grader']['level']}"] if sheet.facts["grader"][
        "unsandboxed"] else []
    if sheet.mark is None:
        return [*found, f"**Not graded yet.** {NOT_YOURS}", *([plain(sheet.result["why"])] if "why" in sheet.result
                                                              else [])]
    found.append(f"**{points(sheet.mark)} of {points(sheet.most)} points**"
                 + (f", of the visible ones {sheet.visible}" if sheet.visible else ""))
    if sheet.override:
        found.append(f"Marked by hand: {plain(sheet.override['reason'])}")
    if sheet.result["late_share"] < 1:
        found.append(f"Handed in late: {sheet.result['late_share']:.0%} of the points count.")
    if sheet.result["verdict"] == "ungraded":
        return found
    if sheet.at_once:
        return [*found, "**Fix this first:** nothing could be judged.", code(sheet.at_once)]
    first = sheet.first
    return [*found, f"**Fix this first:** `{first.function}`. {plain(hint(first))}" if first else "All is right."]


def section(item: Item) -> list[str]:
    found = [f"## `{item.function}`: {points(item.total('score'))} of {points(item.total('max'))}"]
    if item.lost <= 0:
        return found
    found.append(f"Asked: {plain(item.task['text'])}"
                 + (f" (slide: {plain(item.task['slide'])})" if item.task["slide"] else ""))
    if item.said:
        return [*found, code(item.said)]
    found += [f"**{plain(one['id'].replace('_', ' '))}**: {plain(one['message'])}" for one in item.suspects]
    if item.worst:
        found.append(f"The worst visible point ({plain(region(item.worst))}):")
        found.append(code(point(item.worst["worst"])))
    rows = [f"| {plain(region(test))} | {points(test['score'])} of {points(test['max'])} | {counted(test)} | "
            f"{plain(sentence(test))} |" for test in item.failed]
    found.append("\n".join(["| Check | Points | Wrong | Why |", "|---|---|---|---|", *rows]))
    if any(test["visibility"] == "hidden" for test in item.failed):
        found.append(f"{HIDDEN[0].upper()}{HIDDEN[1:]}.")
    return found
