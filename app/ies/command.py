"""`halfway ies FILE`: what a luminaire's file declares and what it emits; `--json` for programs, `-o` for a picture."""

import argparse
import json
import sys

from app.ies import Photometry, read


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", metavar="FILE.ies", help="an IES file, LM-63-1986 to LM-63-2019")
    parser.add_argument("--json", action="store_true", help="print it as JSON")
    parser.add_argument("-o", "--output", metavar="REPORT.png", help="polar curves, solid, wall and floor as a picture")
    parser.add_argument("--theme", metavar="NAME", help="of the picture: dark, light or projector")
    parser.add_argument("--size", metavar="WxH", help="of the picture, in pixels; 1600x1000")


def run(options: argparse.Namespace) -> int:
    found = read(options.file)
    if options.output:
        from app.export.ies_report import save

        save(found, options.output, options.theme or "dark", options.size or "1600x1000")
    if options.json:
        print(json.dumps(facts(found), indent=1, ensure_ascii=False, allow_nan=False))
    else:
        print(words(found))
        for warning in found.warnings:
            print(f"halfway: {warning}", file=sys.stderr)
    return 0


def facts(found: Photometry) -> dict:
    return {
        "file": found.name,
        "standard": found.standard,
        "photometric_type": found.kind,
        "symmetry": found.symmetry,
        "declared_lumens": found.declared_lumens,
        "integrated_lumens": found.integrated_lumens,
        "max_candela": found.max_candela,
        "vertical_angles": found.vertical.tolist(),
        "horizontal_angles": found.horizontal.tolist(),
        "tilt": found.tilt,
        "watts": found.watts,
        "keywords": found.keywords,
        "warnings": list(found.warnings),
    }


def words(found: Photometry) -> str:
    """The same for a person."""
    lines = [("luminaire", found.title), ("standard", f"{found.standard}, type {found.kind}, TILT={found.tilt}"),
             ("symmetry", found.symmetry),
             ("vertical", span(found.vertical.tolist())), ("horizontal", span(found.horizontal.tolist())),
             ("peak", f"{found.max_candela:.6g} cd"), ("declared", declared(found)),
             ("integrated", f"{found.integrated_lumens:.6g} lm, exact for candela joined by straight lines"),
             ("power", f"{found.watts:g} W" + (f", {found.integrated_lumens / found.watts:.3g} lm/W" if found.watts
                                               else ""))]
    return "\n".join(f"{name:12s}{text}" for name, text in lines)


def span(angles: list[float]) -> str:
    return f"{len(angles)} angle{'s' * (len(angles) > 1)}, {angles[0]:g}° to {angles[-1]:g}°"


def declared(found: Photometry) -> str:
    if found.declared_lumens is None:
        return "no lumens: absolute photometry, the candela stand for themselves"
    said = f"{found.declared_lumens:.6g} lm of {found.lamps} lamp{'s' * (found.lamps > 1)}"
    if not found.declared_lumens:
        return said
    return f"{said}; {found.integrated_lumens / found.declared_lumens:.1%} of them are emitted"
