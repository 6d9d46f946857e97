"""index.html of the class: marks, which check fails for whom, misconceptions, what is ungraded, what is identical.

What it needs of each student is kept as they go by; the pages of thousands never are in memory together.
"""

from collections import Counter, defaultdict
from statistics import median
from urllib.parse import quote

from app.grade.level import MEANING
from app.grade.report.frame import bar, clean, foot, page, stamp
from app.grade.report.stored import Sheet, folder_of
from app.grade.report.table import flags
from app.grade.report.words import points, verdict

BINS, HIGHEST = 10, 88  # bars of the histogram; the highest one, in % of its room
NAMED = 400  # students behind one line; of the others the number

MADE = {"pass": "·", "partial": "▪", "skipped": "▫"}
LEGEND = ("Each sign is a check, in the order of tests.csv: · passed, ▪ partly, ■ failed, ▫ a property that counts "
          "when the values are right.")


class Overview:
    def __init__(self, facts: dict) -> None:
        self.facts = facts
        self.most = facts["assignment"]["points"]
        self.rows: list[str] = []
        self.marks: list[float] = []
        self.asked: Counter[tuple[str, str]] = Counter()  # function and region -> students
        self.failed: dict[tuple[str, str], dict[str, None]] = defaultdict(dict)
        self.suspects: dict[tuple[str, str, str], list[str]] = defaultdict(list)
        self.ungraded: list[tuple[str, str]] = []
        self.same: set[tuple[str, ...]] = set()
        self.verdicts: Counter[str] = Counter()

    def add(self, sheet: Sheet) -> None:
        result, student = sheet.result, sheet.student
        self.verdicts[result["verdict"]] += 1
        if sheet.mark is None:
            whys = [result.get("why", ""), *(test["message"] for test in result["tests"]
                                             if test["verdict"] == "ungraded")]
            self.ungraded.append((student, next(filter(None, whys), "")))
        else:
            self.marks.append(sheet.mark)
        for check in {(test["function"], test["region"]): None for test in result["tests"]}:
            self.asked[check] += 1
        for test in result["tests"]:
            if test["verdict"] != "pass":
                self.failed[test["function"], test["region"]][student] = None
        for one in result["misconceptions"]:
            self.suspects[one["function"], one["id"], one["message"]].append(student)
        if result["same_as"]:
            self.same.add(tuple(sorted([student, *result["same_as"]])))
        self.rows.append(row(sheet))

    def bytes(self) -> bytes:
        assignment, grader = self.facts["assignment"], self.facts["grader"]
        middle = median(self.marks) if self.marks else 0.0
        all_of = sum(mark >= self.most - 1e-9 for mark in self.marks)
        said = [f"{len(self.rows)} submissions", f"{all_of} with all {points(self.most)} points",
                f"median {points(middle)}", f"{len(self.ungraded)} ungraded"]
        body = (f'<header>{stamp(grader)}<p class="over">{clean(assignment["title"])}</p><h1>The class</h1>'
                f'<p class="lead">{clean(" · ".join(said))}</p></header>\n<main class="class">\n'
                f'<div class="two"><section><h2>Marks</h2>{self.histogram()}{self.missed()}'
                f'{self.identical()}</section>'
                f'<section><h2>Misconceptions</h2>{self.misconceptions()}</section></div>\n'
                f'<section><h2>Checks that fail</h2>{self.checks()}</section>\n'
                f'<section><h2>Students</h2>{self.students()}</section>\n'
                f'<p class="note">Isolation {clean(grader["level"])}: {clean(MEANING[grader["level"]])}. Numbers were '
                f'computed with {clean(grader["renderer"])}.</p></main>\n{foot(self.facts)}')
        return page(f"The class: {assignment['title']}", body)

    def histogram(self) -> str:
        """How many have 0 to 10 %, to 20 %, ...; all points is a bar of its own."""
        counts = Counter(BINS if mark >= self.most - 1e-9 else int(max(0.0, mark) / self.most * BINS)
                         for mark in self.marks)
        top = max(counts.values(), default=1)
        bars = "".join(
            f'<div class="{"all" if i == BINS else ""}"><p><b>{counts[i] or ""}</b>'
            f'<i style="height:{HIGHEST * counts[i] / top:.1f}%"></i></p>'
            f'<span>{100 * i // BINS}</span></div>' for i in range(BINS + 1))
        return (f'<div class="histogram">{bars}</div><p class="note">Share of the points in %; the last bar has all of '
                "them.</p>")

    def misconceptions(self) -> str:
        found = sorted(self.suspects.items(), key=lambda one: (-len(one[1]), one[0]))
        rows = "".join(f"<tr><td>{len(who)}</td><td><code>{clean(function)}</code><br><small>"
                       f"{clean(id.replace('_', ' '))}</small></td><td>{clean(message)}{names(who)}</td></tr>"
                       for (function, id, message), who in found)
        if not rows:
            return '<p class="quiet">No wrong answer matches a known one.</p>'
        return f'<table class="counts"><tbody>{rows}</tbody></table>'

    def missed(self) -> str:
        rows = "".join(f"<tr><td>{link(student)}</td><td>{clean(why)}</td></tr>" for student, why in self.ungraded)
        return "" if not rows else (
            f'<div class="alarm"><h2>Not graded</h2><p>The machine failed, not the students. The same command with '
            f'<code>--resume</code> tries again.</p><table><tbody>{rows}</tbody></table></div>\n')

    def identical(self) -> str:
        rows = "".join(f"<li>{', '.join(map(link, group[:NAMED]))}</li>" for group in sorted(self.same))
        return "" if not rows else f'<h2 class="next">Identical submissions</h2><ul>{rows}</ul>\n'

    def checks(self) -> str:
        """A row for a region or property, its visible and hidden part together; the one most fail at first."""
        order = {check: i for i, check in enumerate(self.asked)}
        rows = ""
        for check in sorted(self.asked, key=lambda one: (-len(self.failed[one]), order[one])):
            who, (function, where) = self.failed[check], check
            if who:
                share = len(who) / self.asked[check]
                rows += (f"<tr><td><code>{clean(function)}</code></td><td>{clean(where)}</td><td>{bar(share)}</td>"
                         f"<td>{names(list(who), self.asked[check])}</td></tr>")
        return f'<div class="wide"><table class="fails"><tbody>{rows}</tbody></table></div>' if rows else (
            '<p class="quiet">None.</p>')

    def students(self) -> str:
        heads = "".join(f"<th><code>{clean(task['function'])}</code></th>"
                        for task in self.facts["assignment"]["tasks"])
        return (f'<p class="note">{LEGEND}</p>'
                f'<div class="wide"><table class="students"><thead><tr><th>Student</th><th>Points</th><th></th>'
                f'{heads}<th>Notes</th></tr></thead><tbody>{"".join(self.rows)}</tbody></table></div>')


def row(sheet: Sheet) -> str:
    cells = ""
    for item in sheet.items:
        most = item.total("max")
        share = item.total("score") / most if most else 0.0
        level = "x" if not item.tests else str(min(4, int(share * 4 + 1e-9)))
        made = "".join(MADE.get(test["verdict"], "■") for test in item.tests)
        cells += (f'<td class="cell s{level}">{points(item.total("score")) if item.tests else ""}'
                  f'<span class="made">{made}</span></td>')
    mark = "–" if sheet.mark is None else points(sheet.mark)
    return (f"<tr><td>{link(sheet.student)}</td><td><b>{mark}</b></td>"
            f'<td>{clean(verdict("override" if sheet.override else sheet.result["verdict"]))}</td>{cells}'
            f"<td><small>{clean('; '.join(flags(sheet)))}</small></td></tr>")


def link(student: str) -> str:
    return f'<a href="students/{quote(folder_of(student))}/report.html">{clean(student)}</a>'


def names(who: list[str], of: int = 0) -> str:
    more = f" and {len(who) - NAMED} more" if len(who) > NAMED else ""
    return (f'<details><summary>{len(who)}{f" of {of}" if of else ""} student{"s" if (of or len(who)) > 1 else ""}'
            f'</summary>'
            f'{", ".join(map(link, who[:NAMED]))}{more}</details>')
