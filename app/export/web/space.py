"""Plots that stand in space, as scenes: their GLSL is written from the very twins, so that the page's stage plays them.

What a scale depends on (the longest lobe, the highest value) is a uniform that the player finds with the same twins.
"""

from dataclasses import dataclass, field

from app.gpu.stage_text import COLOURS
from app.lesson import Camera, Faces, Figure, Label, Lobes, Mark, Model, Number, Scene, Sheet, Surface, Term
from app.optics.colour import srgb_to_linear
from app.plots.look import REACH, SLICE_DECADES, TICKS_D, TICKS_H
from app.plots.models import CHANNELS
from app.quantities import FROM_ANGLES
from app.shader import catalogue

LIFT = 1.004  # what lies on the sphere is drawn a little above it
Lobe = tuple[Term, int | None]  # with its channel


@dataclass
class Writer:
    """Collects the includes and uniforms of the calls it writes."""

    includes: list[str] = field(default_factory=lambda: ["display/look.glsl"])
    uniforms: dict[str, str] = field(default_factory=dict)

    def call(self, term: Term, **swept: str) -> str:
        include, signature = catalogue()[term.function]
        if include not in self.includes:
            self.includes.append(include)
        return f"{term.function}({', '.join(self.argument(term, a.name, a.type, swept) for a in signature.args)})"

    def argument(self, term: Term, name: str, kind: str, swept: dict[str, str]) -> str:
        key = term.args.get(name, name)
        if not isinstance(key, str):
            return literal(key, kind)
        if key in swept:
            return swept[key]
        self.uniforms[f"towards_{key}" if key in FROM_ANGLES else key] = kind
        return f"towards_{key}" if key in FROM_ANGLES else key

    def scene(self, body: str, **parts) -> Scene:
        lines = [f'#include "{name}"' for name in self.includes]
        lines += [f"uniform {kind} {name};" for name, kind in self.uniforms.items()]
        return Scene(glsl="\n".join([*lines, body]), **parts)


def literal(value: Number, kind: str) -> str:
    if isinstance(value, tuple):
        return f"{kind}({', '.join(repr(float(x)) for x in value)})"
    return str(int(value)) if kind == "int" else repr(float(value))


def pick(name: str, answers: list[str], otherwise: str) -> str:
    """if (surface == 0) return ...; for each answer."""
    lines = [f"    if ({name} == {i}) return {answer};" for i, answer in enumerate(answers)]
    return "\n".join([*lines, f"    return {otherwise};"])


def ink(name: str) -> str:
    return f"palette[{COLOURS.index(name)}]"


# --- sheets ----------------------------------------------------------------------------------------------------------
SHEETS = """
vec3 on_sphere(vec3 p) { return 1.004 * normalize(p); }
vec3 on_disk(vec3 p) {
    vec3 d = normalize(p);
    return vec3(d.z < 0.0 ? normalize(d.xy) : d.xy, 0.004);
}
"""


def figure(plot: Figure) -> Scene:
    """Sheets, their shadows with the rays that make them, the dome and the disk."""
    writer, sheets = Writer(), plot.sheets
    points = [wrapped(sheet, writer.call(sheet.term, s="s.x", t="s.y")) for sheet in sheets]
    heights = [writer.call(s.height, s="s.x", t="s.y") if s.height else "0.0" for s in sheets]
    shadows = any(sheet.onto for sheet in sheets)
    surfaces = [Surface(sheet.label, (sheet.cells[0], sheet.cells[1]), sheet.opacity) for sheet in sheets]
    places, colours = list(points), [shaded(sheet) for sheet in sheets]
    if plot.disk:
        surfaces.append(Surface("disk", (96, 1)))
        places.append("vec3(s.y * cos(6.2831853 * s.x), s.y * sin(6.2831853 * s.x), 0.0)")
        colours.append("mix(palette[COLOUR_QUIET], background, 0.72)")
    if plot.dome:
        surfaces.append(Surface("dome", (96, 24), 0.2))
        writer.includes.append("optics/spherical.glsl")
        half = "0.5 * " if plot.dome == "hemisphere" else ""
        places.append(f"direction(3.14159265 * {half}s.y, 6.2831853 * s.x)")
        colours.append("glass(s.st, vec2(24.0, 12.0))")
    body = ["uniform vec2 figure_range;" if any(s.height for s in sheets) else "", SHEETS if shadows else "",
            f"vec3 surface_point(int surface, vec2 s) {{\n{pick('surface', places[:-1], places[-1])}\n}}"]
    if any(s.height for s in sheets):
        body.append("vec4 surface_value(int surface, vec2 s) {\n"
                    + pick("surface", [f"vec4({h}, 0.0, 0.0, 0.0)" for h in heights], "vec4(0.0)") + "\n}")
    body.append(f"vec3 shade(Surface s) {{\n{pick('s.id', colours[:-1], colours[-1])}\n}}")
    marks: list[Mark] = []
    if shadows:
        marks = [Mark(f"edge {s.label}", s.colour, segments=64) for s in sheets]
        marks += [Mark(f"ray {i}", "quiet", "dotted", width=0.7) for i in range(4)]
        body.append(RAYS.format(sheets=len(sheets)))
    if plot.disk or plot.dome == "hemisphere":
        marks.append(Mark("n", "n", tip="arrow", label="n"))
    if marks:
        rays = [f"surface_point({i}, around(t))" for i in range(len(sheets))] if shadows else []
        rays += [f"t * surface_point(0, corner({i}))" for i in range(4)] if shadows else []
        body.append(f"vec3 mark_point(int mark, float t) {{\n{pick('mark', rays, 'vec3(0.0, 0.0, 1.3 * t)')}\n}}")
    return writer.scene("\n".join(body), surfaces=tuple(surfaces), marks=tuple(marks), camera=plot.camera)


RAYS = """
vec2 corner(int i) {{ return vec2(i == 1 || i == 2 ? 1.0 : 0.0, i >= 2 ? 1.0 : 0.0); }}
vec2 around(float t) {{
    float side = min(floor(4.0 * t), 3.0);
    int i = int(side);
    return mix(corner(i), corner((i + 1) % 4), 4.0 * t - side);
}}
"""


def wrapped(sheet: Sheet, point: str) -> str:
    return f"on_{sheet.onto}({point})" if sheet.onto else point


def shaded(sheet: Sheet) -> str:
    if sheet.height:
        return ("soft_light(colormap((s.value.x - figure_range.x) / (figure_range.y - figure_range.x)), s.normal, s.v)")
    return ink(sheet.colour) if sheet.onto == "disk" else f"soft_light({ink(sheet.colour)}, s.normal, s.v)"


# --- a mesh ----------------------------------------------------------------------------------------------------------
FACES = """
#include "optics/solid_angle_flat.glsl"
#include "display/scale.glsl"
#include "display/look.glsl"
uniform sampler2D triangles;
uniform vec3 eye;
uniform float face_limit; // sr

vec3 mesh_point(int surface, vec3 p) {
    return p;
}

vec4 mesh_value(int surface, vec3 p, int face) {
    ivec2 at = ivec2(3 * (face % 256), face / 256);
    vec3 a = texelFetch(triangles, at, 0).xyz - eye;
    vec3 b = texelFetch(triangles, at + ivec2(1, 0), 0).xyz - eye;
    vec3 c = texelFetch(triangles, at + ivec2(2, 0), 0).xyz - eye;
    return vec4(solid_angle_triangle_signed(a, b, c) / face_limit, 0.0, 0.0, 0.0);
}

vec3 shade(Surface s) {
    return soft_light(diverging(s.value.x), s.normal, s.v);
}

vec3 mark_point(int mark, float t) {
    return eye;
}
"""


def faces(plot: Faces) -> Scene:
    return Scene(glsl=FACES, surfaces=(Surface("faces", mesh=True, opacity=0.62),),
                 marks=(Mark("eye", "v", tip="dot", width=1.4, label="eye"),), camera=plot.camera)


# --- lobes -----------------------------------------------------------------------------------------------------------
def lobes(plot: Lobes, shown: list[Lobe], models: list[Model], scaled: bool) -> Scene:
    """Each lobe on a grid dense at its own peak (glsl/display/lobe.glsl), the disk with its rings, the vectors."""
    writer, n = Writer(), len(shown)
    writer.includes.append("display/lobe.glsl")
    values = [scaled_call(writer, term, model, plot.over, scaled)
              for (term, _), model in zip(shown, models, strict=True)]
    colours = [f"soft_light({lobe_colour(model, channel)}, s.normal, s.v)"
               for (_, channel), model in zip(shown, models, strict=True)]
    writer.uniforms |= {"towards_l": "vec3", "towards_v": "vec3"}
    body = f"""
uniform vec3 lobe_peak[{n}];
uniform float lobe_width[{n}];
uniform float lobe_top;
uniform float lobe_decades;

float lobe_value(int lobe, vec3 d) {{
{pick("lobe", values[:-1], values[-1])}
}}

vec3 on_lobe(int lobe, vec3 d) {{
    return d * min(lobe_radius(lobe_value(lobe, d), lobe_top, lobe_decades), 4.0);
}}

vec3 surface_point(int surface, vec2 s) {{
    if (surface == {n}) return vec3(s.y * cos(6.2831853 * s.x), s.y * sin(6.2831853 * s.x), -0.002);
    return on_lobe(surface, lobe_direction(s, lobe_peak[surface], lobe_width[surface]));
}}

vec3 shade(Surface s) {{
{pick("s.id", colours, "mix(palette[COLOUR_QUIET], background, 0.72)")}
}}

vec3 ring(float radius, float t) {{
    return vec3(radius * cos(6.2831853 * t), radius * sin(6.2831853 * t), 0.0);
}}

vec3 mark_point(int mark, float t) {{
    vec3 still = towards_{"l" if plot.over == "v" else "v"};
    vec2 side = length(still.xy) > 1e-6 ? normalize(still.xy) : vec2(1.0, 0.0);
    float turn = 3.14159265 * (t - 0.5);
    if (mark < 4) return ring(0.25 * float(mark + 1), t);
    if (mark < 8) return 0.25 * float(mark - 3) * vec3(side * sin(turn), cos(turn));
    if (mark == 8) return vec3(0.0, 0.0, {REACH} * t);
    if (mark == 9) return {REACH} * t * towards_l;
    if (mark == 10) return {REACH} * t * towards_v;
    if (mark == 11) return {REACH} * t * vec3(-still.xy, still.z);
    return on_lobe(mark - 12, towards_{plot.over});
}}
"""
    opacity = 1.0 if n == 1 else 0.5
    marks = [Mark(f"ring {i}", "quiet", segments=96, width=0.5) for i in range(4)]
    marks += [Mark(f"arc {i}", "quiet", segments=64, width=0.5) for i in range(4)]
    marks += [Mark("n", "n", tip="arrow", label="n"), Mark("l", "l", tip="sun", label="l"),
              Mark("v", "v", tip="eye", label="v"), Mark("r", "r", "dotted")]
    marks += [Mark(f"value {i}", model.colour, tip="dot", width=1.3) for i, model in enumerate(models)]
    surfaces = (*(Surface(f"lobe {i}", (96, 64), opacity) for i in range(n)), Surface("disk", (96, 1), 0.6))
    return writer.scene(body, surfaces=surfaces, marks=tuple(marks), camera=plot.camera)


def scaled_call(writer: Writer, term: Term, model: Model, over: str, scaled: bool) -> str:
    call = writer.call(term, **{over: "d"})
    if not scaled or model.is_shading:
        return call
    writer.uniforms["lobe_scale"] = "int"
    writer.uniforms["towards_l"] = "vec3"
    return f"{call} * (lobe_scale == 1 ? max({'towards_l' if over == 'v' else 'd'}.z, 0.0) : 1.0)"


def lobe_colour(model: Model, channel: int | None) -> str:
    if channel is None:
        return ink(model.colour)
    return "vec3(" + ", ".join(f"{x:.6f}" for x in srgb_to_linear(CHANNELS[channel])) + ")"


# --- an image slice --------------------------------------------------------------------------------------------------
def image_slice(terms: list[Term], several: bool, scaled: bool, models: tuple[Model, ...]) -> Scene:
    """theta_h to the right (its square root), theta_d upwards, phi_d = 90 degrees, as app/plots/image_slice.py."""
    writer = Writer()
    writer.includes += ["optics/spherical.glsl", "display/scale.glsl"]
    values = [scaled_call(writer, term, model, "l", scaled).replace("towards_v", "v").replace("towards_l", "d")
              for term, model in zip(terms, models, strict=True)]
    writer.uniforms |= {"towards_l": "vec3", "towards_v": "vec3"}
    below = [f"vec4(sqrt({d / 90!r}), 0.0, -0.05, 1.0)" for d in TICKS_H]
    if several:
        writer.uniforms["model"] = "int"
    body = f"""
uniform float slice_top;

float slice_value(vec3 d, vec3 v) {{
{pick("model", values[:-1], values[-1]) if several else f"    return {values[0]};"}
}}

vec3 surface_point(int surface, vec2 s) {{
    return vec3(s.x, 0.0, s.y);
}}

vec3 shade(Surface s) {{
    vec3 h = direction(1.57079633 * s.st.x * s.st.x, 0.0);
    float theta_d = 1.57079633 * s.st.y;
    vec3 d = h * cos(theta_d) + vec3(0.0, sin(theta_d), 0.0);
    float top = log(slice_top) / log(10.0);
    return decade_colour(slice_value(d, d * vec3(1.0, -1.0, 1.0)), top - {SLICE_DECADES}.0, top);
}}

vec3 mark_point(int mark, float t) {{
    vec3 h = normalize(towards_l + towards_v);
    float theta_h = acos(clamp(h.z, -1.0, 1.0));
    float theta_d = acos(clamp(dot(towards_l, h), -1.0, 1.0));
    return vec3(sqrt(theta_h / 1.57079633), -0.01, theta_d / 1.57079633);
}}

vec4 probe(int i) {{
{pick("i", below, "vec4(-0.06, 0.0, float(i - " + str(len(TICKS_H)) + ") / " + repr(len(TICKS_D) - 1.0) + ", 1.0)")}
}}
"""
    labels = [Label(f"{d}°", i) for i, d in enumerate(TICKS_H) if d not in (2, 20)]
    labels += [Label(f"{d}°", len(TICKS_H) + i) for i, d in enumerate(TICKS_D)]
    return writer.scene(body, surfaces=(Surface("slice", (32, 32)),), labels=tuple(labels),
                        marks=(Mark("now", "exact", tip="dot", width=1.6),),
                        camera=Camera(-90, 0, 3.0, (0.47, 0.0, 0.47), 24.0))
