"""The board as a scene: the models' GLSL, each behind names of its own, around glsl/display/board.glsl."""

from dataclasses import dataclass

from app import optics, shader
from app.board import coated, factors
from app.board.brdf_model import BrdfModel, prefixed, uniforms
from app.board.coated import Coated
from app.board.course_model import PREFIX, CourseModel
from app.board.merl import Merl
from app.board.models import BoardModel
from app.lesson import Camera, Colour, Handle, Label, Mark, Scene, Surface, Text

ARROWS: tuple[tuple[str, Colour, str], ...] = (("normal", "n", "arrow"), ("light", "l", "sun"), ("eye", "v", "eye"),
                                               ("halfway", "h", "arrow"))
SHAPES = "sphere", "knot", "bowl", "cube"
ENTRIES = """
vec3 surface_point(int surface, vec2 s) { return board_point(surface, s); }
vec4 surface_value(int surface, vec2 s) { return board_value(surface, s); }
vec3 mesh_point(int surface, vec3 p) { return board_mesh(surface, p); }
vec4 mesh_value(int surface, vec3 p, int face) { return vec4(corner_normal(p, face), 0.0); }
vec3 shading_normal(Surface s) { return board_normal(s); }
vec3 shade(Surface s) { return board_colour(s); }
vec3 mark_point(int mark, float t) { return board_mark(mark, t); }
vec4 probe(int i) { return board_probe(i); }
"""


@dataclass(frozen=True)
class Piece:
    """One model: declarations with their includes, the value as an expression of n, l, v, x, y, its D, G, F."""

    declared: str
    value: str
    factors: str = ""
    texts: tuple[Text, ...] = ()
    measured: tuple[tuple[str, str], ...] = ()


def piece(model: BoardModel, prefix: str) -> Piece:
    """What a model brings along; its parameters are uniforms behind the prefix."""
    if isinstance(model, BrdfModel):
        source = prefixed(model.file, prefix)
        text = Text(f"{prefix}text", source.text, source.file, source.first)
        return Piece(f'{uniforms(model.file, prefix)}\n#include "{text.name}"', f"{prefix}BRDF(l, v, n, x, y)",
                     texts=(text,))
    if isinstance(model, CourseModel):
        return of_course(model, prefix)
    if isinstance(model, Merl):
        return Piece(f'uniform sampler2D {prefix}cells;\n#include "display/merl.glsl"',
                     f"merl_value({prefix}cells, n, l, v)", measured=((f"{prefix}cells", model.path),))
    assert isinstance(model, Coated)
    return Piece(coated.declared(prefix), coated.value(prefix))


def of_course(model: CourseModel, prefix: str) -> Piece:
    include, signature = shader.catalogue()[PREFIX + model.name]
    own = [a for a in signature.args if a.name in {p.name for p in model.parameters}]
    declared = [f"uniform {a.type} {prefix}{a.name};" for a in own] + [f'#include "{include}"']

    def value(channel: int) -> str:
        known = {"radiance": "1.0", "channel": str(channel)} | {a.name: prefix + a.name for a in own}
        return f"{signature.name}({', '.join(known.get(a.name, a.name) for a in signature.args)})"

    terms = factors.factors(model.name, prefix)
    declared += [f'#include "optics/{optics.names()[term.function]}.glsl"' for term in terms[:3]]
    rgb = f"vec3({value(0)})" if model.is_grey() else f"vec3({', '.join(map(value, range(3)))})"
    return Piece("\n".join(declared), rgb, f"vec3({', '.join(map(factors.call, terms[:3]))})" if terms else "")


def scene(models: list[tuple[str, BoardModel, Colour, str]]) -> Scene:
    """models: (label, model, colour, prefix)."""
    pieces = [piece(model, prefix) for _, model, _, prefix in models]
    text = ["// the board", *(line for one in pieces for line in one.declared.split("\n")),
            '#include "display/palette.glsl"', '#include "stage/corner_normal.glsl"',
            f"const int MODELS = {len(models)};", chosen(pieces), factored(pieces), coloured([m[2] for m in models]),
            '#include "display/board.glsl"', ENTRIES]
    count = len(models)
    surfaces = [Surface(f"ball: {m[0]}", cells=(48, 3)) for m in models]
    surfaces += [Surface(f"object: {m[0]}", mesh=True, where=("stands", 1)) for m in models]
    clear = 1.0 if count == 1 else 0.72
    surfaces += [Surface(f"lobe: {m[0]}", cells=(56, 36), opacity=clear, where=("stands", 0)) for m in models]
    surfaces += [Surface(f"standing: {m[0]}", cells=(40, 24), opacity=0.6) for m in models]
    marks = [Mark(name + where, colour, "dashed" if name == "halfway" else "solid", tip,  # type: ignore[arg-type]
                  label="" if where else colour) for where in (" on the ball", "") for name, colour, tip in ARROWS]
    handles = (Handle("the picked point", count, ("theta_v", "turned")),
               Handle("the light", count + 1, ("theta_l", "phi")),
               Handle("the light over the plate", count + 2, ("theta_l", "phi")))
    return Scene(
        "\n".join(text), (*surfaces, Surface("plate", cells=(48, 1), where=("stands", 0))), tuple(marks),
        labels=tuple(Label(m[0], i, m[2]) for i, m in enumerate(models)), handles=handles,
        camera=Camera(azimuth=-62, elevation=24, distance=40, field_of_view=5.3), meshes=SHAPES,
        texts=tuple(t for one in pieces for t in one.texts), measured=tuple(m for one in pieces for m in one.measured),
        brush=True)


def chosen(pieces: list[Piece]) -> str:
    """`reflected`: nothing from below the horizon."""
    cases = [f"    if (which == {i}) return {one.value};" for i, one in enumerate(pieces)]
    return "\n".join(["vec3 reflected(int which, vec3 n, vec3 l, vec3 v, vec3 x, vec3 y) {",
                      "    if (min(dot(n, l), dot(n, v)) <= 0.0) return vec3(0.0);", *cases,
                      "    return vec3(0.0);", "}"])


def factored(pieces: list[Piece]) -> str:
    cases = [f"    if (which == {i}) return {one.factors};" for i, one in enumerate(pieces) if one.factors]
    cosines = ["    vec3 s = l + v, h = s / max(length(s), 1e-6);",
               "    float n_dot_l = dot(n, l), n_dot_v = dot(n, v), n_dot_h = dot(n, h), l_dot_h = dot(l, h);"]
    return "\n".join(["vec3 factors(int which, vec3 n, vec3 l, vec3 v) {", *(cosines if cases else ()), *cases,
                      "    return vec3(-1.0);", "}"])


def coloured(colours: list[Colour]) -> str:
    cases = "".join(f"which == {i} ? COLOUR_{c.upper()} : " for i, c in enumerate(colours[:-1]))
    return f"int model_colour(int which) {{ return {cases}COLOUR_{colours[-1].upper()}; }}"
