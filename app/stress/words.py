"""What a stress run found, for a person and for a program."""

import math
from collections import Counter
from dataclasses import asdict

from app.readouts import three
from app.stress.judge import GLSL, NUMPY32, NUMPY64, SHIPPED, Finding, Form
from app.stress.ranges import ON_PURPOSE, right_of
from app.stress.scenes import Played
from app.tolerance import FACTOR

KINDS = {"nan": "not a number", "infinite": "infinite", "negative": "negative", "outside": "out of range",
         "beyond": f"beyond {FACTOR:g}"}


def told(findings: list[Finding], scenes: list[Played], each: bool) -> str:
    """A table a person can read: what fails first, then what naive and printed forms teach, then how many passed."""
    stable = [one for one in findings if one.kind == "stable"]
    parts = []
    for title, chosen in (("fails", [one for one in stable if one.fails]),
                          ("stable", [one for one in stable if each and not one.fails]),
                          ("naive: what it loses", [one for one in findings if one.kind == "naive"]),
                          ("as printed, or with flaws on purpose",
                           [one for one in findings if one.kind in ("printed", "meant")])):
        if chosen:
            parts.append("\n".join([title, *(line for one in chosen for line in lines(one, title == "fails" or each))]))
    if findings:
        parts.append(summary(findings))
    if scenes:
        parts.append("\n".join(scene_lines(scenes)))
    return "\n\n".join(parts) if parts else "Nothing was tried."


def lines(one: Finding, with_points: bool) -> list[str]:
    """A finding in one line, and its worst points below."""
    forms = {form.name: form for form in one.forms}
    errors = "  ".join(f"{name} {short(forms.get(name))}" for name in (GLSL, NUMPY32, NUMPY64))
    found = [f"  {one.function:34s}{errors}{remarks(one)}"]
    if with_points or one.kind == "naive":
        for example in one.examples[:None if with_points else 1]:
            found.append(f"      {times(example.error)} ({example.form}): {numbers(example.got)} for "
                         f"{numbers(example.true)}")
            found.append(f"      {example.paste}")
    return found


def remarks(one: Finding) -> str:
    """Counts of the shipped forms, and what else there is to say."""
    total = Counter({kind: max((getattr(form, kind) for form in one.forms if form.name in SHIPPED), default=0)
                     for kind in KINDS})
    said = [f"{count} of {one.points} {KINDS[kind]}" for kind, count in total.items() if count]
    if one.albedo and one.albedo.gains:
        said.append(f"sends on {three(one.albedo.largest)} times the light at {one.albedo.words}")
    if one.differs:
        said.append(f"up to {three(1 + one.differs)} times {right_of(one.function)}")
    if one.function in ON_PURPOSE:
        said.append(ON_PURPOSE[one.function])
    return "; " + "; ".join(said) if said else ""


def short(form: Form | None) -> str:
    """The worst error in units of the tolerance's u (1 + cond + kappa): '1.2', '3e+06', 'fault', or no such form."""
    if form is None:
        return f"{'-':>7s}"
    return f"{'fault' if math.isinf(form.worst) else f'{form.worst:.2g}':>7s}"


def times(error: float) -> str:
    return "a fault" if math.isinf(error) else f"{error:.2g} u (1 + cond)"


def numbers(value) -> str:
    return ", ".join(f"{x:.9g}" for x in (value if isinstance(value, list) else [value]))


def summary(findings: list[Finding]) -> str:
    kinds = Counter(one.kind for one in findings)
    failed = sum(one.fails for one in findings)
    stored = [one.stored for one in findings if one.stored]
    judges = Counter(form.judge for one in findings for form in one.forms if form.name == NUMPY64)
    points = sum(one.points for one in findings)
    words = [f"{len(findings)} functions at {points} points: {kinds['stable']} stable, of which {failed} fail; "
             f"{kinds['naive']} naive, {kinds['printed']} printed, {kinds['meant']} with flaws on purpose.",
             f"Errors are in u (1 + cond + kappa), {FACTOR:g} pass. GLSL and float32 numpy are judged by float64; "
             "float64 by " + (", ".join(f"{name} ({n})" for name, n in judges.items())
                              or "nothing: this machine has no longer numbers") + "."]
    if stored:
        words.append(f"Stored 20-digit values judge {len(stored)} functions at {sum(s[0] for s in stored)} points too: "
                     f"worst {max(s[1] for s in stored):.2g} in float64, {max(s[2] for s in stored):.2g} in float32.")
    return "\n".join(words)


def scene_lines(scenes: list[Played]) -> list[str]:
    drawn, meant = sum(one.states for one in scenes), sum(one.meant for one in scenes)
    faults = [fault for one in scenes for fault in one.faults]
    words = [f"{len(scenes)} steps in {drawn} states at the corners of their sliders: {len(faults)} with a fault"
             + (f" ({meant} show negative light on purpose)." if meant else ".")]
    return words + [f"  {fault.words}\n      halfway show {fault.state!r}" for fault in faults]


def as_data(findings: list[Finding], scenes: list[Played]) -> dict:
    """The same for `--json`: no NaN and no infinity, which JSON has not."""
    return {"functions": [finding_data(one) for one in findings],
            "scenes": [{"step": one.step, "states": one.states, "meant": one.meant,
                        "faults": [{"state": f.state, **asdict(f.pixels), "places": f.places} for f in one.faults]}
                       for one in scenes]}


def finding_data(one: Finding) -> dict:
    found = {"function": one.function, "file": one.file, "kind": one.kind, "against": one.against,
             "fails": one.fails, "points": one.points, "forms": [form_data(form) for form in one.forms],
             "worst": [{"form": e.form, "error": finite(e.error), "got": finite(e.got), "true": finite(e.true),
                        "paste": e.paste} for e in one.examples]}
    if one.stored:
        found["stored"] = dict(zip(("records", "float64", "float32"), one.stored, strict=True))
    if one.albedo:
        found["albedo"] = {"largest": finite(one.albedo.largest), "at": one.albedo.at}
    if one.differs is not None:
        found["differs"] = finite(one.differs)
    return found


def form_data(form: Form) -> dict:
    return {"form": form.name, "judge": form.judge, **{kind: getattr(form, kind) for kind in KINDS},
            "worst": finite(form.worst)}


def finite(value):
    if isinstance(value, list):
        return [finite(x) for x in value]
    return value if math.isfinite(value) else None
