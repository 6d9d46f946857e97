"""A user's own texts under a name, in the data folder: a `.brdf` file that any BRDF explorer opens, or GLSL as it is.

    NAME.brdf   the edited functions are part of a reflectance: all of its GLSL, its parameters at their present values
    NAME.glsl   they are not (a scene's `shade`): the functions alone

Either has one line with the step and the texts, from which the editor opens it again.
"""

import json
import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from app import files, optics, shader
from app.catalog import LoadedStep
from app.edit import EDITED, among_values, follows, functions, overrides, source_of
from app.lesson import Model, Term
from app.problem import Problem, Usage
from app.progress import data_folder
from app.quantities import TABLE
from app.terms import bound

NAME = re.compile(r"[A-Za-z]\w{0,39}")
KEPT = re.compile(r'^(?:// )?(\{"halfway": .*\})\s*$', re.M)
OWN = re.compile(r"^::begin halfway$.*?^::end halfway$\n?", re.M | re.S)
BRDF, GLSL = ".brdf", ".glsl"
GIVEN = {"n": "N", "l": "L", "v": "V", "radiance": "1.0"}
FIRST = "brdf_cook_torrance"  # of several models made of the texts


@dataclass(frozen=True)
class Saved:
    name: str
    path: Path
    step: str
    texts: dict[str, str]


def folder() -> Path:
    return data_folder() / "models"


def path_of(name: str) -> Path | None:
    """The file of a saved model of this name, if there is one."""
    if not NAME.fullmatch(name):
        return None
    return next((path for path in (folder() / f"{name}{ending}" for ending in (BRDF, GLSL)) if path.is_file()), None)


def saved() -> list[Saved]:
    """Every saved text that can be opened again, by name."""
    found = []
    for path in sorted(folder().glob("*")) if folder().is_dir() else ():
        if path.suffix in (BRDF, GLSL) and (one := opened(path)):
            found.append(one)
    return found


def opened(path: Path) -> Saved | None:
    try:
        match = KEPT.search(path.read_text(encoding="utf-8"))
        about = json.loads(match[1])["halfway"] if match else {}
        texts = {name: text for name, text in about["texts"].items() if isinstance(text, str)}
        return Saved(path.stem, path, str(about["step"]), texts)
    except (OSError, ValueError, KeyError, TypeError, AttributeError):  # not ours, or damaged: left alone
        return None


def save(name: str, found: LoadedStep, texts: Mapping[str, str], values: dict) -> Path:
    """Texts that run, under a name."""
    if not NAME.fullmatch(name):
        raise Usage(f"{name or 'nothing'} is no name; take a letter, then letters, digits and _, as in my_model.")
    if not texts:
        raise Usage("nothing is edited in this step; there is only the course's text to save.")
    there = path_of(name)
    before = opened(there) if there else None
    if there and (before is None or before.step != found.id):
        raise Usage(f"{there} is there already{f', of {before.step}' if before else ''}; take another name.")
    about = json.dumps({"halfway": {"step": found.id, "texts": dict(texts)}}, ensure_ascii=False)
    model = reflectance(found, texts)
    judged = of_file(found, texts, about) or (brdf(model, found, texts, values, about) if model else "")
    whole = judged or alone(found, texts, about)
    path = folder() / f"{name}{BRDF if judged else GLSL}"
    try:
        folder().mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise Problem(f"the folder {folder()} cannot be made: {files.reason(error)}.") from None
    files.write(path, whole.encode())
    if there and there != path:
        there.unlink(missing_ok=True)
    return path


def reflectance(found: LoadedStep, texts: Mapping[str, str]) -> Model | None:
    """The model that the texts are part of: the step's first, else one of the course."""
    edits = among_values(texts, functions(found), source_of(found)).get(EDITED, ())
    named = [model for model in found.step.models if follows(model.term.function, edits)]
    others = [name for name in optics.names() if name.startswith(("brdf_", "shading_")) and follows(name, edits)]
    others.sort(key=lambda name: (name != FIRST, name))
    named = [model for model in named if ":" not in model.term.function]  # the board's are among the others
    candidates = [*named, *(Model(name, Term(name)) for name in others)]
    return next((model for model in candidates if parameters(model) is not None), None)


def of_file(found: LoadedStep, texts: Mapping[str, str], about: str) -> str:
    """On the board, a user's file with the texts in it, its names without the prefix they have in the scene."""
    known, changed = functions(found), dict(overrides(texts, functions(found), source_of(found)))
    for one in found.step.scene.texts:
        if one.name not in changed:
            continue
        prefix = one.name.removesuffix("text")
        mine = {name: text for name, text in texts.items() if known[name].include == one.name}
        glsl = one.text
        for name, text in mine.items():
            glsl = glsl.replace(known[name].text, text)
        lines = Path(one.file).read_text("utf-8").split("\n")
        begin, end = one.first - 1, one.first + one.text.count("\n")
        plain = re.sub(rf"\b{prefix}(?=\w)", "", glsl)
        whole = OWN.sub("", "\n".join([*lines[:begin], plain, *lines[end:]])).strip()
        return f"{whole}\n::begin halfway\n{about}\n::end halfway\n"
    return ""


def parameters(model: Model) -> list[shader.Argument] | None:
    """What a `.brdf` has sliders for; None where one cannot be a slider, or the model is no function of n, l, v."""
    args = shader.catalogue()[model.term.function][1].args
    rest = [a for a in args if a.name not in (*GIVEN, "channel")]
    fits = {"n", "l", "v"} <= {a.name for a in args} and all(a.type in ("float", "int") and not a.size for a in rest)
    return rest if fits and all(a.name in TABLE for a in rest) else None


def brdf(model: Model, found: LoadedStep, texts: Mapping[str, str], values: dict, about: str) -> str:
    edits = dict(among_values(texts, functions(found), source_of(found))[EDITED])
    function = model.term.function
    include, signature = shader.catalogue()[function]
    typed = {name: replace(one, is_own=False) for name, one in edits.items()}  # as typed, without the count of loops
    glsl = shader.assemble(f'#include "{include}"', function, header=(), entry=(function,), overrides=typed)
    defaults = {a.name: TABLE[a.name].default for a in parameters(model) or ()}
    now = defaults | bound(model.term, {**defaults, "channel": 0, **values}, n=0, l=0, v=0, radiance=1.0)
    lines = ["analytic", f"# {', '.join(sorted(texts))} of {found.id}, edited; the model is {function}",
             "::begin parameters"]
    for a in parameters(model) or ():
        q = TABLE[a.name]
        lines.append(f"float {a.name} {q.low:.9g} {q.high:.9g} {float(now[a.name]):.9g}  # {q.words}")
    value = "vec3({})".format(", ".join(call(signature, channel, model.is_shading) for channel in range(3))
                              if any(a.name == "channel" for a in signature.args)
                              else call(signature, 0, model.is_shading))
    lines += ["::end parameters", "::begin shader", glsl.text.strip(), "",
              "vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {", f"    return {value};", "}", "::end shader",
              "::begin halfway", about, "::end halfway"]
    return "\n".join(lines) + "\n"


def call(signature: shader.Signature, channel: int, is_shading: bool) -> str:
    """The function at BRDF's arguments; a shading formula over n.l is the reflectance it stands for."""
    given = {**GIVEN, "channel": str(channel)}
    words = [given.get(a.name, f"int({a.name} + 0.5)" if a.type == "int" else a.name) for a in signature.args]
    return f"{signature.name}({', '.join(words)})" + (" / max(dot(N, L), 1e-7)" if is_shading else "")


def alone(found: LoadedStep, texts: Mapping[str, str], about: str) -> str:
    return "\n\n".join([f"// {', '.join(sorted(texts))} of {found.id}, edited\n// {about}", *texts.values()]) + "\n"
