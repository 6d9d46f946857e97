"""`halfway compare STEP`: a step's material on its mesh by our GLSL and by pyrender, and where and why they differ."""

import argparse
import json
from dataclasses import asdict, replace
from pathlib import Path

import numpy as np

from app.catalog import step
from app.compare.definitions import at_45, table
from app.compare.material import Material, material
from app.compare.pictures import BOUND, Compared, compare
from app.lesson import Scene
from app.state import parse, parse_set, write


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("step", metavar="STEP", help="chapter/step, or a state string")
    parser.add_argument("-o", "--output", metavar="FILE.png|FOLDER", help="the pictures on a page, or each by itself")
    parser.add_argument("--json", action="store_true", help="print it as JSON")
    parser.add_argument("--aligned", action="store_true",
                        help="our GLSL evaluates pyrender's model; exit code 1 if they disagree")
    parser.add_argument("--set", metavar="name=value", nargs="+", action="extend", default=[],
                        help="values of the step, angles in degrees")
    parser.add_argument("--mesh", metavar="FILE", help="your mesh: STL, OBJ, PLY or GLB")
    parser.add_argument("--size", metavar="WxH", help="of the picture; 1600x1000")
    parser.add_argument("--theme", metavar="NAME", help="of the picture: dark, light or projector")


def run(options: argparse.Namespace) -> int:
    state = parse(options.step)
    found = step(state.step)
    values = dict(state.values)
    for text in options.set:
        values |= parse_set(text, found)
    of = material(found, values)
    if options.output:
        from app.export.compare_report import checked

        checked(options.output, options.size, options.theme)
    name, triangles = mesh(found.step.scene, values, options.mesh)
    seen = found.step.scene.camera
    if options.mesh is None and name == "sphere":
        seen = replace(seen, elevation=min(seen.elevation, 60.0))
    both = compare(of, triangles, values, state.view.camera(seen))
    told = facts(write(found, values), name, len(triangles), of, both, options.aligned)
    if options.output:
        from app.export.compare_report import save

        told["pictures"] = save(options.output, told, both, options.aligned, options.size, options.theme)
    print(json.dumps(told, indent=1, ensure_ascii=False) if options.json else words(told))
    return 0 if both.within or not options.aligned else 1


def mesh(scene: Scene, values: dict, own: str | Path | None) -> tuple[str, np.ndarray]:
    """The user's, the step's, or a sphere."""
    from app import meshes

    if own:
        loaded = meshes.load(own)
        return loaded.name, loaded.triangles
    name = scene.meshes[int(values.get("shape", 0))] if scene.meshes else "sphere"
    return name, meshes.built_in(name).triangles


def facts(state: str, name: str, faces: int, of: Material, both: Compared, aligned: bool) -> dict:
    """What `--json` prints."""
    ours = "shading_gltf" if aligned else of.model.term.function
    return {
        "state": state, "mesh": name, "triangles": faces, "light": [round(x, 6) for x in both.to_light.tolist()],
        "ours": {"function": ours, "model": "glTF's, as pyrender has it" if aligned else of.model.label,
                 "arguments": {k: (int(v) if isinstance(v, int) else float(v)) for k, v in of.arguments.items()}},
        "gltf": {"base_colour": list(of.colour), "metallic": of.metallic, "roughness": of.roughness},
        "difference": asdict(both.agreement if aligned else both.difference),
        "aligned": {**asdict(both.agreement), "bound": dict(zip(("relative", "absolute"), BOUND, strict=True)),
                    "within": both.within},
        "definitions": [{"term": term, "ours": a, "pyrender": b} for term, a, b in table(of)],
        "numbers": [{"term": term, "ours": a, "pyrender": b} for term, a, b in at_45(of)],
    }


def words(told: dict) -> str:
    """The same for a person."""
    apart, same, gltf = told["difference"], told["aligned"], told["gltf"]
    colour = " ".join(f"{x:.3g}" for x in gltf["base_colour"])
    lines = [f"{told['state']}: {told['ours']['function']} on {told['mesh']} ({told['triangles']} triangles)",
             f"  in glTF: base colour {colour}, metallic {gltf['metallic']:g}, roughness {gltf['roughness']:.4g}",
             f"  apart    {sentence(apart)}",
             f"  aligned  {sentence(same)}",
             f"  {verdict(same)}", ""]
    for row in told["definitions"]:
        lines += [f"  {row['term']:12s}ours      {row['ours']}", f"  {'':12s}pyrender  {row['pyrender']}"]
    lines += [f"  {row['term']:12s}ours {row['ours']:.4g}, pyrender {row['pyrender']:.4g}" for row in told["numbers"]]
    return "\n".join(lines)


def sentence(d: dict) -> str:
    """1 is white and matt, facing the lamp."""
    return (f"RMSE {d['rmse']:.3g}, 99.9 % of it within {d['p999']:.3g}, at most {d['most']:.3g} "
            f"({d['pixels']} pixels off silhouettes; 1 is a white matt surface that faces the lamp)")


def verdict(same: dict) -> str:
    bound = f"{100 * same['bound']['relative']:g} % and {same['bound']['absolute']:g}"
    if same["within"]:
        return f"With pyrender's model in our GLSL every pixel agrees to {bound}: the rest is its 8 bits."
    return (f"With pyrender's model in our GLSL some pixels differ by more than {bound}; "
            "below a roughness of 0.2 that is pyrender's float32.")
