"""GLSL and numbers as a page carries them: a scene's programs, the twins it calls, arrays as base64. Pure text."""

import base64
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from app import shader
from app.gpu.evaluate import find, point_program
from app.gpu.stage_text import TIP_SIZE, mark_uniforms, programs
from app.lesson import Scene, Term
from app.optics import arguments

Data = dict[str, Any]
CAREFUL = {"careful": shader.Source(Path(__file__).with_name("careful.glsl").read_text("utf-8"), "careful.glsl")}


@dataclass
class Twins:
    """The GLSL functions a page calls, each once."""

    found: dict[str, Data] = field(default_factory=dict)

    def term(self, term: Term) -> Data:
        """A term with its arguments in order: the name of a value, or numbers."""
        self.add(term.function)
        return {"function": term.function, "args": [term.args.get(name, name) for name in arguments(term.function)]}

    def add(self, function: str) -> None:
        if function in self.found:
            return
        include, signature = find(function, None)
        source, _, fixed = point_program(signature, include, None)
        text = shader.assemble(f'#include "careful"\n{source}', function, header=shader.WEB, overrides=CAREFUL).text
        self.found[function] = {"text": squeezed(text), "returns": signature.returns, "args": [
            {"name": arg.name, "type": arg.type, "fixed": arg in fixed} for arg in signature.args]}


def squeezed(text: str) -> str:
    """Without empty lines; the remarks stay, because a student reads the page's source too."""
    return "\n".join(line for line in text.split("\n") if line.strip()) + "\n"


def shared(content: Data) -> Data:
    """The content with each declaration of its GLSL once: programs and twins are the numbers of theirs, in order."""
    known: dict[str, int] = {}

    def numbered(text: str) -> list[int]:
        return [known.setdefault(part, len(known)) for part in declarations(text)]

    def scene_of(one: Data) -> Data:
        return one | {"programs": {name: [numbered(text) for text in pair] for name, pair in one["programs"].items()}}

    def step_of(one: Data) -> Data:
        plots = [plot | ({"scene": scene_of(plot["scene"])} if "scene" in plot else {}) for plot in one["plots"]]
        return one | {"scene": scene_of(one["scene"]), "plots": plots}

    twins = {name: twin | {"text": numbered(twin["text"])} for name, twin in content["twins"].items()}
    broken = [one | {"scene": scene_of(one["scene"])} for one in content["breaks"]]
    found = step_of(content) | {"twins": twins, "breaks": broken}
    return found | {"glsl": list(known)}


def declarations(text: str) -> list[str]:
    """A text cut after each line that stands outside all braces."""
    parts, depth = [""], 0
    for line in text.splitlines(keepends=True):
        parts[-1] += line
        depth += line.count("{") - line.count("}")
        if depth <= 0:
            parts.append("")
    return [part for part in parts if part]


def scene(one: Scene, file: str = "scene", first: int = 1) -> Data:
    """A scene as the stage of a page plays it; colours, lines and tips by their numbers, as the shaders know them."""
    none = {name: 0 for name in one.decided if name in one.of_the_user}  # a page has no files of a user's
    texts = programs(one, file, first, shader.WEB, known=none)
    named = [(i, mark) for i, mark in enumerate(one.marks) if mark.label]  # their points come first, then the probes
    words = [{"text": label.text, "ink": label.colour, "at": len(named) + label.probe, "gap": 0}
             for label in one.labels]
    words += [{"text": mark.label, "ink": mark.colour, "at": at, "gap": 6 if mark.tip == "none" else 14}
              for at, (_, mark) in enumerate(named)]
    return {
        "programs": {name: [squeezed(part.text) for part in pair if part] for name, pair in texts.items()},
        "decided": [name for name in one.decided if name not in none],  # whole values a program is compiled for
        "surfaces": [{"cells": s.cells, "opacity": s.opacity, "mesh": s.mesh, "surface": i}
                     for i, s in enumerate(one.surfaces)],
        "marks": [mark_uniforms(i, m) | {"tip_size": TIP_SIZE[m.tip], "segments": m.segments, "width": m.width}
                  for i, m in enumerate(one.marks)],
        "dots": asdict(one.dots) if one.dots else None,
        "named": [{"mark": i, "mark_t": mark.label_at} for i, mark in named], "words": words,
        "probes": 1 + max([*(label.probe for label in one.labels), *(handle.probe for handle in one.handles)],
                          default=-1),
        "handles": [asdict(handle) | {"at": len(named) + handle.probe} for handle in one.handles],
        "camera": asdict(one.camera),
    }


def packed(numbers: np.ndarray) -> str:
    return base64.b64encode(np.ascontiguousarray(numbers).tobytes()).decode()

