"""The parts of a page that a hand works: rows of sliders and choices, handles, numbers, breaks and the question."""

from html import escape

from app.breaking import broken
from app.catalog import LoadedStep, ValueSpec
from app.export.web.content import PLACES
from app.lesson import Handle, Prediction, Readout
from app.spoken import said, words
from app.typed import show


def rows(specs: list[ValueSpec]) -> str:
    return "".join(choices(spec) if spec.choices else sliders(spec) for spec in specs)


def row(spec: ValueSpec, controls: str) -> str:
    told = f"{spec.quantity.words}; at first {show(spec)} {spec.quantity.screen_unit}".strip()
    return f'<div class="row" title="{escape(told)}">{controls}</div>'


def choices(spec: ValueSpec) -> str:
    named = f"value-{spec.name}"
    offered = "".join(f'<label><input type="radio" name="{spec.name}" value="{i}">{escape(spec.choices[i])}</label>'
                      for i in range(int(spec.low), int(spec.high) + 1))
    return row(spec, f'<span id="{named}">{escape(said(spec.name))}</span>'
                     f'<div class="choices" role="radiogroup" aria-labelledby="{named}">{offered}</div>')


def sliders(spec: ValueSpec) -> str:
    """A slider for each part of the value, from 0 to 1, and one field for all of them."""
    label, unit = words(spec.name), spec.quantity.screen_unit
    parts = spec.default if isinstance(spec.default, tuple) else (spec.default,)
    step = 1 / (spec.high - spec.low) if spec.quantity.kind == "int" and spec.scale != "log" else 0.001
    ranges = ""
    for k in range(len(parts)):
        id, named = f"{spec.name}-{k}" if k else spec.name, f"{label} {'xyz'[k]}" if len(parts) > 1 else label
        ranges += (f'<input type="range" min="0" max="1" step="{step:.6g}" name="{spec.name}" id="value-{id}" '
                   f'aria-label="{escape(named)}">')
    field = (f'<input type="text" inputmode="decimal" size="7" name="{spec.name}" '
             f'aria-label="{escape(label)} in {escape(unit or "numbers")}">')
    return row(spec, f'<label for="value-{spec.name}">{escape(label)}</label><div class="sliders">{ranges}</div>'
                     f'<span class="typed">{field}{escape(unit)}</span>')


def grips(handles: tuple[Handle, ...]) -> str:
    return "".join(f'<i class="grip" title="{escape(handle.name)}"></i>' for handle in handles)


def numbers(found: LoadedStep) -> str:
    """The rows of the step's numbers, then those that stand in their place while something is broken."""
    def row(one: Readout, which: str, hidden: str) -> str:
        return (f'<div class="{one.role}" data-broken="{which}"{hidden}><dt>{escape(one.label)}</dt>'
                '<dd><span></span><small></small></dd></div>')

    rows = [row(one, "", "") for one in found.step.readouts]
    rows += [row(one, str(i), " hidden") for i in range(len(found.step.breaks))
             for one in broken(found, i).step.readouts]
    return "".join(rows)


def breaks(found: LoadedStep) -> str:
    return "".join(f'<label class="break"><input type="checkbox" value="{i}"> break it: {escape(one.label)}</label>'
                   for i, one in enumerate(found.step.breaks))


def ask(question: Prediction) -> str:
    if question.choices:
        answer = "".join(f'<label><input type="radio" name="guess" value="{i}"> {escape(choice.text)}</label>'
                         for i, choice in enumerate(question.choices))
    else:
        answer = (f'<input id="guess" type="range" min="0" max="{PLACES}" value="{PLACES // 2}" '
                  'aria-label="your guess"><output id="guessed" for="guess"></output>')
    return (f'<div id="ask"><p>{escape(question.question)}</p><div class="choices">{answer}'
            '</div><button id="reveal" type="button">Reveal</button><p id="verdict" role="status"></p>'
            f'<p id="told" hidden>{escape(question.told)}</p></div>')
