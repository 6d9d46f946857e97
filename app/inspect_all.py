"""`halfway inspect --all`: for every step what is in, the proof that nothing else is, and what leaving out saves."""

import argparse
import json
import os
from dataclasses import asdict, dataclass

from app.catalog import LoadedStep, steps
from app.console import progress
from app.everything import FEATURES, features
from app.inspection import Inspection, inspect
from app.state import defaults

HEAD = ("step", "files", "functions", "uniforms", "vertices", "texels", "samples", "kB", "compile", "frame",
        "all on", "ratio", "left out")


@dataclass(frozen=True)
class Row:
    """One step; times in ms."""

    found: Inspection
    cost: dict
    has: tuple[str, ...]  # of FEATURES

    @property
    def left_out(self) -> tuple[str, ...]:
        return tuple(name for name in FEATURES if name not in self.has)

    @property
    def as_json(self) -> dict:
        return {**asdict(self.found), "cost": self.cost, "features": self.has, "features_left_out": self.left_out}

    @property
    def cells(self) -> tuple[str, ...]:
        one, cost = self.found, self.cost
        return (one.step, str(len(one.files)), str(len(one.functions)), str(len(one.uniforms)), str(cost["vertices"]),
                str(cost["texels"]), str(cost["samples"]), str(cost["memory_kb"]), f"{cost['compile_ms']:.0f}",
                f"{cost['frame_ms']:.1f}", f"{cost['everything_frame_ms']:.1f}", f"{cost['ratio']:.2f}",
                f"{len(self.left_out)} of {len(FEATURES)}")


def run(options: argparse.Namespace) -> int:
    """Prints what was measured, also after Ctrl-C; the code is 1 if anything lies about in a step."""
    os.environ.setdefault("MESA_SHADER_CACHE_DISABLE", "true")  # else a program of yesterday costs nothing
    rows: list[Row] = []
    todo = steps()
    try:
        with progress(len(todo)) as tell_how_far:
            for found in todo:
                tell_how_far(len(rows), found.step.title)
                rows.append(row(found))
    except KeyboardInterrupt:
        tell(rows, options.json, len(todo))
        raise
    tell(rows, options.json, len(todo))
    return int(any(one.found.faults for one in rows))


def row(found: LoadedStep) -> Row:
    from app.cost import cost
    from app.meshes import built_in
    from app.tables import chosen

    values: dict = defaults(found)
    scene = found.step.scene
    inspected = inspect(found, values)
    values = values | chosen(scene, values)
    if scene.meshes:
        values["triangles"] = built_in(scene.meshes[int(values.get("shape", 0))]).triangles
    measured = cost(found, values)
    return Row(inspected, {**asdict(measured), "ratio": measured.ratio}, features(scene))


def tell(rows: list[Row], as_json: bool, wanted: int) -> None:
    if as_json:
        print(json.dumps([one.as_json for one in rows], indent=1, ensure_ascii=False, allow_nan=False))
        return
    table = [HEAD, *(one.cells for one in rows)]
    wide = [max(len(cells[i]) for cells in table) for i in range(len(HEAD))]
    for cells in table:
        first, *others = (cell.ljust(width) for cell, width in zip(cells, wide, strict=True))
        print("  ".join((first, *(word.strip().rjust(len(word)) for word in others))))
    print()
    print("\n".join(summary(rows, wanted)))


def summary(rows: list[Row], wanted: int) -> list[str]:
    faults = [sentence for one in rows for sentence in one.found.faults]
    lines = [f"{len(rows)} of {wanted} steps. Times in ms: the compilation in the first frame, the median frame of "
             "512 x 512, and the same vertices and pixels coloured by one shader that has everything on:",
             f"  {', '.join(FEATURES)}."]
    if rows:
        worst = max(rows, key=lambda one: one.cost["ratio"])
        lines.append(f"A scene that carries only what it uses costs at most {100 * worst.cost['ratio']:.0f} % of that "
                     f"({worst.found.step}, which leaves out {len(worst.left_out)}).")
    decided = [f"{one.found.step} ({', '.join(one.found.decided)})" for one in rows if one.found.decided]
    if decided:
        lines.append(f"Compiled for what is chosen, and measured so: {', '.join(decided)}.")
    lines.append(f"{len(faults)} faults:" if faults else
                 "Nothing lies about: no function, uniform, attribute, varying, table, file or pass without use.")
    return lines + [f"  {sentence}" for sentence in faults]
