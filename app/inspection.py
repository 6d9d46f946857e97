"""`halfway inspect STEP`: what a step brings along, what it leaves out and why. Pure text; no OpenGL is needed."""

import argparse
import json
import re
from dataclasses import asdict, dataclass, field

from app import shader
from app.badges import as_json, of_model
from app.catalog import LoadedStep, step
from app.gpu.stage_text import Programs, programs, vertices
from app.leaving import decisions, lean
from app.lesson import Scene
from app.problem import Usage
from app.state import parse

ATTRIBUTE = re.compile(r"^\s*(?:flat\s+)?in\s+(\w+)\s+(\w+)\s*;", re.M)
VARYING = re.compile(r"^\s*(?:flat\s+)?out\s+\w+\s+(\w+)\s*;", re.M)
DRAWN = {"surface": "surfaces", "mesh": "meshes", "dots": "clouds of dots", "mark": "marks",
         "probe": "points asked for", "anchor": "labels placed"}


@dataclass(frozen=True)
class Pass:
    """One program and what it is drawn for."""

    name: str
    draws: int
    uniforms: dict[str, str]  # name -> type
    attributes: dict[str, str]
    functions: tuple[str, ...]


@dataclass(frozen=True)
class Inspection:
    step: str
    title: str
    files: tuple[str, ...]  # of glsl/, of which something is compiled
    functions: tuple[str, ...]  # compiled, without the scene's own
    uniforms: dict[str, str]
    attributes: dict[str, str]
    passes: tuple[Pass, ...]
    vertices: dict[str, int]
    tables: dict[str, tuple[int, int]]  # uniform -> rows and columns of its numbers
    packages: dict[str, str]  # Python package -> what for
    processes: tuple[str, ...]
    functions_left_out: tuple[str, ...]  # of the included files: nothing calls them
    left_out: tuple[str, ...]  # sentences
    faults: tuple[str, ...]  # what a test refuses
    badges: dict[str, dict]  # of its models at these values: label -> badge -> ok, worst, at
    decisions: tuple[str, ...] = ()  # what it does without at these values, and what that costs
    decided: dict[str, str] = field(default_factory=dict)  # choices, constants of its programs


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("step", metavar="STEP", nargs="?", default="", help="chapter/step, or a state string")
    parser.add_argument("--all", action="store_true",
                        help="every step: what it compiles, what lies about, and its cost beside everything on")
    parser.add_argument("--json", action="store_true", help="print it as JSON")


def run(options: argparse.Namespace) -> int:
    if options.all == bool(options.step):
        raise Usage("halfway inspect wants a step, or --all for all of them.")
    if options.all:
        from app.inspect_all import run as run_all

        return run_all(options)
    state = parse(options.step)
    found = inspect(step(state.step), state.values)
    print(json.dumps(asdict(found), indent=1, ensure_ascii=False) if options.json else words(found))
    return 0


def inspect(found: LoadedStep, values: dict | None = None) -> Inspection:
    values = values or {name: spec.default for name, spec in found.values.items()}
    made = decisions(found, values)
    found = lean(found, made)
    scene = found.step.scene
    whole, known = programs(scene, found.file_name, found.glsl_line), choices(scene, values)
    texts = programs(scene, found.file_name, found.glsl_line, known=known)
    own = set(shader.signatures(scene.glsl))
    kept = {name for pair in texts.values() for part in pair if part for name in part.kept}
    out = {name for pair in texts.values() for part in pair if part for name in part.left_out} - kept
    passes = tuple(one_pass(name, pair, scene) for name, pair in texts.items())
    files = {file for pair in texts.values() for part in pair if part for file in part.files}
    return Inspection(
        found.id, found.step.title,
        tuple(sorted(file for file in files if file.startswith("glsl/"))),
        tuple(sorted(kept - own - {"main"})),
        {name: kind for one in passes for name, kind in one.uniforms.items()},
        {name: kind for one in passes for name, kind in one.attributes.items()},
        passes, vertices(scene, triangles(scene, values), values), table_sizes(scene, values), packages(found),
        ("window", "plot (pyvista and VTK, on its own)"),
        tuple(sorted(out)), left_out(found, out, idle_files(texts)), faults(found, whole),
        {model.label: as_json(of_model(model, values)) for model in found.step.models},
        tuple(one.words for one in made), {name: chosen_words(found, name, number) for name, number in known.items()})


def choices(scene: Scene, values: dict) -> dict[str, int]:
    """What a scene decides, at these values; no map is the user's."""
    return {name: int(values.get(name, 0)) for name in scene.decided}


def chosen_words(found: LoadedStep, name: str, number: int) -> str:
    return found.values[name].choices[number] if name in found.values else "none of yours"


def one_pass(name: str, pair: tuple[shader.Assembled, shader.Assembled | None], scene: Scene) -> Pass:
    vertex, fragment = pair
    parts = [part for part in (vertex, fragment) if part]
    uniforms = {n: kind for part in parts for n, kind in shader.uniforms(part.text).items()}
    functions = dict.fromkeys(n for part in parts for n in part.kept if n != "main")
    return Pass(name, drawn(scene)[name], uniforms, {n: kind for kind, n in ATTRIBUTE.findall(vertex.text)},
                tuple(functions))


def drawn(scene: Scene) -> dict[str, int]:
    """How often each program is used in a picture."""
    probes = [label.probe for label in scene.labels] + [handle.probe for handle in scene.handles]
    return {"surface": sum(not s.mesh for s in scene.surfaces), "mesh": sum(s.mesh for s in scene.surfaces),
            "dots": int(scene.dots is not None), "mark": len(scene.marks), "probe": max(probes, default=-1) + 1,
            "anchor": sum(bool(mark.label) for mark in scene.marks)}


def triangles(scene: Scene, values: dict):
    if not scene.meshes or not any(surface.mesh for surface in scene.surfaces):
        return None
    from app.meshes import built_in

    return built_in(scene.meshes[int(values.get("shape", 0))]).triangles


def table_sizes(scene: Scene, values: dict) -> dict[str, tuple[int, int]]:
    if not scene.tables:
        return {}
    from app.tables import chosen

    return {name: (len(table), len(table[0])) for name, table in chosen(scene, values).items()}


def packages(found: LoadedStep) -> dict[str, str]:
    step = found.step
    needs = {"numpy": "numbers", "moderngl": "the scene", "imgui_bundle": "the window",
             "pyvista": "the plot " + ", ".join(repr(plot.title) for plot in step.plots)}
    if any(surface.mesh for surface in step.scene.surfaces):
        needs["trimesh"] = "a mesh of your own; the built-in ones need none"
    return needs


def left_out(found: LoadedStep, functions: set[str], files: set[str]) -> tuple[str, ...]:
    """What this step does not need, and so does not load."""
    scene = found.step.scene
    count = f"{len(functions)} functions" if len(functions) != 1 else "1 function"
    said = [f"{count} of the included files: nothing here calls them."] * bool(functions)
    if files:
        said.append(f"{', '.join(sorted(files))}: included by others, and nothing of it is used.")
    if scene.decided:
        said.append(f"what another choice of {', '.join(scene.decided)} needs: programs are compiled when it is made. "
                    "Branches that the text does not show to be decided stay in it, for the compiler to drop.")
    if not any(surface.mesh for surface in scene.surfaces):
        said.append("trimesh: the scene has no mesh.")
    if not any(table.files for table in scene.tables):
        said.append("the reader of IES files: the scene has no measured luminaire.")
    said += [f"the program for {DRAWN[name]}: the scene has none." for name, n in drawn(scene).items() if not n]
    said.append("pyrender: no second renderer is compared here.")
    said.append("PIL: only stills are written with it.")
    return tuple(said)


def faults(found: LoadedStep, texts: Programs) -> tuple[str, ...]:
    """Uniforms, functions and included files that no program of the scene uses."""
    parts = [part for pair in texts.values() for part in pair if part]
    own, where = found.step.scene.glsl, f"{found.file_name}, step {found.step.name}"
    used = {name for part in parts for name in shader.uniforms(part.text)}
    called = {name for part in parts for name in part.kept}
    direct = {f"glsl/{match[1]}" for line in own.split("\n") if (match := shader.INCLUDE.match(line))}
    return (
        *(f"{where}: the uniform {name} is declared and not used." for name in shader.uniforms(own)
          if name not in used),
        *(f"{where}: the function {name} is written and not called." for name in shader.signatures(own)
          if name not in called),
        *(f"{where}: the table {table.uniform} is named and not used." for table in found.step.scene.tables
          if table.uniform not in used),
        *(f"{where}: nothing of {file} is used." for file in sorted(direct & idle_files(texts))),
        *(f"{where}: the pass {name} is compiled and nothing is drawn with it." for name in texts
          if not drawn(found.step.scene)[name]),
        *(f"{where}: {sentence}" for name, pair in texts.items() for sentence in unread(name, *pair)))


def unread(name: str, vertex: shader.Assembled, fragment: shader.Assembled | None) -> tuple[str, ...]:
    """Attributes the vertex text does not read, and varyings the fragment text does not."""
    def idle(words: list[str], text: str) -> list[str]:
        return [word for word in words if len(re.findall(rf"\b{word}\b", text)) < 2]  # once where it is declared

    attributes = idle([word for _, word in ATTRIBUTE.findall(vertex.text)], vertex.text)
    varyings = idle(VARYING.findall(vertex.text), fragment.text) if fragment else []
    return (*(f"the attribute {word} of the pass {name} is not read." for word in attributes),
            *(f"the varying {word} of the pass {name} is not read." for word in varyings))


def idle_files(texts: Programs) -> set[str]:
    """Included files of which no program keeps anything."""
    parts = [part for pair in texts.values() for part in pair if part]
    return {file for part in parts for file in part.idle} - {file for part in parts for file in part.files}


def words(found: Inspection) -> str:
    def listed(names) -> str:
        return ", ".join(names) or "none"

    lines = [f"{found.step}: {found.title}", "",
             f"files       {listed(found.files)}", f"functions   {listed(found.functions)}",
             f"uniforms    {listed(f'{kind} {name}' for name, kind in found.uniforms.items())}",
             f"attributes  {listed(f'{kind} {name}' for name, kind in found.attributes.items())}"]
    chosen = [f"{name} = {word}" for name, word in found.decided.items()]
    lines += [f"decided     {listed(chosen)}"] * bool(chosen)
    lines += [f"pass        {one.name}: {one.draws} {DRAWN[one.name]}; {len(one.functions)} functions, "
              f"{len(one.uniforms)} uniforms" for one in found.passes]
    lines += [f"vertices    {sum(found.vertices.values())}: {listed(f'{n} {v}' for n, v in found.vertices.items())}"]
    lines += [f"table       {name}: {rows} x {columns} numbers" for name, (rows, columns) in found.tables.items()]
    lines += [f"package     {name}: {why}" for name, why in found.packages.items()]
    lines += [f"badges      {label}: {listed(name if one['ok'] else f'NOT {name}' for name, one in badges.items())}"
              for label, badges in found.badges.items()]
    lines += [f"process     {listed(found.processes)}", "", "left out"]
    lines += [f"  {sentence}" for sentence in (*found.decisions, *found.left_out)]
    lines += [f"  not called: {listed(found.functions_left_out)}"] * bool(found.functions_left_out)
    lines += ["", "faults", *(f"  {sentence}" for sentence in found.faults)] if found.faults else []
    return "\n".join(lines)
