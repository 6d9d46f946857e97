"""One function of a scene in another's place: what calls the one then runs the other. Pure text; lines keep numbers."""

import re
from collections.abc import Mapping
from dataclasses import replace

from app import shader
from app.lesson import Scene, Text
from app.problem import Problem


def swapped_scene(scene: Scene, functions: Mapping[str, str]) -> Scene:
    """The scene with functions of glsl/ -> those of the same arguments that run in their place.

    A file that holds one keeps its head, as a prototype; its body, which calls the other, stands behind the scene.
    """
    files: dict[str, str] = {}
    behind: list[str] = []
    for name, other in functions.items():
        include, signature = shader.catalogue()[name]
        files[include] = without_body(files.get(include) or shader.read(include), signature)
        behind += [f'#include "{shader.catalogue()[other][0]}"', calling(signature, other)]
    if not functions:
        return scene
    texts = [Text(include, text, f"glsl/{include}") for include, text in files.items()]
    return replace(scene, glsl="\n".join([scene.glsl.rstrip("\n"), *behind, ""]), texts=(*scene.texts, *texts))


def without_body(text: str, signature: shader.Signature) -> str:
    """A file's text in which a function is declared only."""
    lines, head = text.split("\n"), re.compile(rf"^{signature.returns}\s+{signature.name}\s*\(")
    first = next((i for i, line in enumerate(lines) if head.match(line)), None)
    if first is None:
        raise Problem(f"{signature.name} is not at the beginning of a line of its file.")
    last = next(i for i in range(first, len(lines)) if lines[i] == "}")
    lines[first:last + 1] = [f"{declared(signature)};", *[""] * (last - first)]
    return "\n".join(lines)


def declared(signature: shader.Signature) -> str:
    given = ", ".join(f"{a.type} {a.name}{f'[{a.size}]' if a.size else ''}" for a in signature.args)
    return f"{signature.returns} {signature.name}({given})"


def calling(signature: shader.Signature, other: str) -> str:
    return f"{declared(signature)} {{ return {other}({', '.join(a.name for a in signature.args)}); }}"


def swap_faults(where: str, functions: Mapping[str, str]) -> list[tuple[str, str]]:
    """Functions that do not exist, or of which one cannot stand in the other's place."""
    known, found = shader.catalogue(), []
    for name, other in functions.items():
        for one in (name, other):
            if one not in known:
                found.append((one, f"{where}: there is no function {one}."))
        if name in known and other in known and known[name][1].args != known[other][1].args:
            found.append((other, f"{where}: {other} does not take the arguments of {name}."))
    return found
