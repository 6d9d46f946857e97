"""All of it together: lamps in lumens, matter that keeps its balance, and a picture that a camera could have taken.

This chapter sets the two models of the course side by side, follows one number from the lamp to the pixel, measures
light in a room, balances body and mirror, and asks what happens to a surface seen from far away.
"""

from app.lesson import (
    Camera,
    Chapter,
    Check,
    Curve,
    Curves,
    Exercise,
    Handle,
    Label,
    Mark,
    Model,
    Prediction,
    Readout,
    Scene,
    Step,
    Surface,
    Term,
    Value,
)

PI = 3.141592653589793
PLAUSIBLE = "Plausible Shading – {}".format
COUPLINGS = ("added up", "1 − F(l·h)", "1 − F(n·l)", "in and out")

ENERGY = Step(
    name="energy",
    title="Body and mirror must share the light",
    idea="What the coat mirrors never reaches the body, and the coat is passed twice: 1 - F on the way in, and on the way out.",
    slides=(PLAUSIBLE("BRDFs"),),
    prose=r"""
Paint, skin, plastic, wood: a matt **body** under a clear **coat**. The coat mirrors the share $\colour{f}{F}$; only the
rest goes in. White paint in a white furnace gives back all it gets, so each upper ball ought to vanish. Stripes: it
$\colour{printed}{\text{makes light}}$.

Adding body and mirror is the old way. One factor, $1-\colour{f}{F}(l\cdot h)$ or $1-\colour{f}{F}(n\cdot l)$, is **not
enough**: the light must come *out* through the coat as well.

$$f_d = \frac{\rho\,(1-\colour{f}{F}(n\cdot l))\,(1-\colour{f}{F}(n\cdot v))}{\pi\,(1-\colour{f}{F_\text{avg}})}$$

It is reciprocal, and its ball cannot be seen. Walk the $\colour{v}{\text{rings}}$ [to the rim](?theta_v=85). Try
[no coat](?f0=0), [diamond](?f0=0.17), [red paint's](?rho=0.6) share. In a **metal** all that enters is lost:
[no body](?rho=0&f0=0.9).
""",
    scene=Scene(
        glsl="""
#include "optics/coat.glsl"
#include "display/balls.glsl"
#include "display/look.glsl"
#include "display/studio.glsl"
uniform float theta_v;
uniform float rho;
uniform float f0;

const float SIZE = 1.12;

vec3 centre(int i) { // 0 .. 3 in the furnace, 4 .. 7 in a room
    return vec3(2.5 * (float(i % 4) - 1.5), 0.0, i < 4 ? 1.55 : -1.6);
}

vec3 surface_point(int surface, vec2 s) {
    if (surface == 2) return vec3(10.6 * s.x - 5.3, 1.6, 3.3 * s.y - 0.1);
    return ball_point(s, 4, centre(ball_number(s, 4) + 4 * surface), SIZE);
}

vec4 surface_value(int surface, vec2 s) { // the body's share by 1 - F(l.h), an integral
    if (surface == 2 || ball_number(s, 4) != 1) return vec4(0.0);
    return vec4(albedo_body(0.5 * PI * min(s.y, 1.0), rho, f0, 1));
}

vec3 shade(Surface s) {
    vec3 heat = vec3(0.50, 0.47, 0.43);
    if (s.id == 2) return heat;
    int i = ball_number(s.st, 4);
    vec3 n = ball_normal((s.position - centre(i + 4 * s.id)) / SIZE, s.v);
    float n_dot_v = clamp(dot(n, s.v), 0.0, 1.0), mirror = f_schlick(n_dot_v, f0);
    float body = i == 1 ? s.value.x : i == 3 ? rho * passed_share(n_dot_v, f0) : rho * (i == 0 ? 1.0 : 1.0 - f_average_schlick(f0));
    if (s.id == 1) return body * soft_light(vec3(0.80, 0.10, 0.06), n, s.v) + mirror * studio(reflect(-s.v, n));
    bool stripe = mod(gl_FragCoord.x + gl_FragCoord.y, 12.0) < 4.0;
    return body + mirror > 1.002 && stripe ? palette[COLOUR_PRINTED] : heat * (body + mirror);
}

vec3 ring(int i, float size, float turn) {
    vec3 v = normalize(camera_position - centre(i)), side = normalize(cross(v, vec3(0.0, 0.0, 1.0)));
    return centre(i) + size * (cos(turn) * side + sin(turn) * cross(side, v)) + 0.6 * v;
}

vec3 mark_point(int mark, float t) {
    if (mark < 4) return ring(mark, SIZE * sin(theta_v), 2.0 * PI * t);
    return ring(mark - 4, SIZE, 2.0 * PI * t);
}

vec4 probe(int i) {
    if (i == 0) return vec4(ring(0, SIZE * sin(theta_v), 0.7), 1.0);
    if (i < 5) return vec4(centre(i + 3) + vec3(0.0, 0.0, 1.33), 1.0);
    return vec4(i == 5 ? -4.4 : -4.6, 1.5, i == 5 ? 3.0 : -3.1, 1.0);
}
""",
        surfaces=(Surface("in the furnace", cells=(131, 16)), Surface("in a room", cells=(131, 16)),
                  Surface("furnace", cells=(1, 1))),
        marks=(*(Mark(f"angle {i}", colour="v", segments=64, width=1.2) for i in range(4)),
               *(Mark(f"outline {i}", colour="quiet", line="dotted", segments=64) for i in range(4))),
        labels=tuple(Label(words, i + 1, "exact" if i == 3 else "printed") for i, words in enumerate(COUPLINGS)),
        handles=(Handle("the rings", 0, ("theta_v",)),),
        legend=(("v", "seen at the angle θ"), ("printed", "more than it gets")),
        camera=Camera(azimuth=-90, elevation=0, distance=60, target=(0.0, 0.0, 0.1), field_of_view=6.6),
    ),
    plot=Curves(
        title="Body and mirror: share of the light sent back",
        sweep="theta_v",
        curves=(Curve("in and out", Term("albedo_coated", {"coupling": 3})),
                Curve("1 − F(n·l)", Term("albedo_coated", {"coupling": 2}), role="estimate"),
                Curve("1 − F(l·h)", Term("albedo_coated", {"coupling": 1}), role="estimate", colour="#CC79A7"),
                Curve("added up", Term("albedo_coated", {"coupling": 0}), role="printed")),
        y_label="share of the light",
    ),
    readouts=(
        Readout("in and out", Term("albedo_coated", {"coupling": 3}), role="exact", unit=""),
        Readout("1 − F(n·l)", Term("albedo_coated", {"coupling": 2}), role="estimate", unit="", against="in and out"),
        Readout("1 − F(l·h)", Term("albedo_coated", {"coupling": 1}), role="estimate", unit="", against="in and out"),
        Readout("added up", Term("albedo_coated", {"coupling": 0}), role="printed", unit="", against="in and out"),
    ),
    models=tuple(Model(words, Term("brdf_coated", {"coupling": i, "m": 0.02}), "exact" if i == 3 else "printed")
                 for i, words in enumerate(COUPLINGS)),
    ask=Prediction(
        question="White paint under a coat with F₀ = 0.04, seen at 85° in even light. A program takes 1 − F(n·l) for the "
                 "body. How many times the light that came in goes out?",
        truth=Term("albedo_coated", {"theta_v": 85 * PI / 180, "rho": 1.0, "f0": 0.04, "coupling": 2}),
        unit="times",
        low=0.0,
        high=2.0,
        sets={"theta_v": 85.0, "rho": 1.0, "f0": 0.04},
        told="1.563 times. Without any factor it is 1.648, with 1 − F(l·h) 1.588: one factor hardly helps. In and out: 1.000.",
    ),
    notes="""
Point at the lower row first: which red ball is wrong? The class will not agree; that is why the furnace is there. Then the
upper row: three rims glow. Ask where the light comes from. At 85° the coat mirrors 0.65, so at most 0.35 may come out of the
body; the factors in use leave it 0.91 and more, for they look at the light's angle, and light comes from everywhere. Why
divide by 1 - F_avg? Light thrown back by the coat from within meets the white body again and gets another chance. Set F₀
to 0.9 with ρ = 1: a metal with a body, 1.9 times the light. Metals swallow what enters, so ρ = 0. 6 minutes.
""",
    sources=("Deck, slide Plausible Shading - BRDFs", "Shirley et al. 1997", "Kelemen & Szirmay-Kalos 2001",
             "optics reference, D13"),
    honesty="Shares are exact for a smooth coat with Schlick's F. Under a rough one, up to 1.003 comes back at 60°, and "
            "less at grazing. ρ counts all bounces under the coat together. The badges judge m = 0.02. The room is a look.",
    values=(Value("theta_v", 75.0, low=0.0, high=88.0), Value("rho", 1.0, low=0.0, high=1.0),
            Value("f0", 0.04, low=0.0, high=0.9)),
    minutes=6,
)

BODY_PYTHON = """import numpy as np

def body_coupled(n_dot_l, n_dot_v, rho, f0):
    # A matt body under a coat, in 1/sr. n_dot_l, n_dot_v, rho, f0: (...); F is Schlick's.
    return np.zeros(np.broadcast_shapes(*map(np.shape, (n_dot_l, n_dot_v, rho, f0))))
"""
BODY_PYTHON_SOLVED = """import numpy as np

def body_coupled(n_dot_l, n_dot_v, rho, f0):
    def through(c):  # 1 - F
        x = 1 - c
        return (1 - f0) * c * (1 + x + x**2 + x**3 + x**4)

    return rho * through(n_dot_l) * through(n_dot_v) / (np.pi * (1 - f0) * 20 / 21)
"""
BODY_GLSL_HEAD = "float body_coupled(float n_dot_l, float n_dot_v, float rho, float f0) {\n"
BODY_GLSL_STUB = BODY_GLSL_HEAD + "    return 0.0;\n}\n"
BODY_GLSL_SOLVED = """float entered(float c, float f0) {
    float x = 1.0 - c;
    return (1.0 - f0) * c * (1.0 + x + x * x + x * x * x + x * x * x * x); // 1 - F
}

""" + BODY_GLSL_HEAD + """    float f_avg = f0 + (1.0 - f0) / 21.0;
    return rho * entered(n_dot_l, f0) * entered(n_dot_v, f0) / (3.14159265 * (1.0 - f_avg));
}
"""

CHAPTER = Chapter(
    title="Plausible shading",
    idea="Right units, a balanced material and a camera make a picture one can believe.",
    steps=(ENERGY,),
    exercises=(
        Exercise(
            name="coated",
            function="body_coupled",
            task="Write the BRDF of a matt body under a coat: light passes it on the way in and on the way out.",
            slide=PLAUSIBLE("BRDFs"),
            stubs={"python": BODY_PYTHON, "glsl": BODY_GLSL_STUB},
            solutions={"python": BODY_PYTHON_SOLVED, "glsl": BODY_GLSL_SOLVED},
            checks=(
                Check({"n_dot_l": (1.0, 0.9), "n_dot_v": (1.0, 0.8), "rho": (1.0, 0.5), "f0": (0.0, 0.04)},
                      "nearly head-on"),
                Check({"n_dot_l": (0.2, 0.7), "n_dot_v": (0.7, 0.2), "rho": (0.8, 0.8), "f0": (0.04, 0.04)},
                      "light and eye swapped: the same"),
                Check({"n_dot_l": (0.5, 0.5), "n_dot_v": (0.5, 0.5), "rho": (0.8, 0.8), "f0": (0.02, 0.17)},
                      "water and diamond"),
                Check({"n_dot_l": (0.05, 0.9), "n_dot_v": (0.6, 0.01), "rho": (0.9, 0.3), "f0": (0.08, 0.5)},
                      "grazing", hidden=True),
            ),
        ),
    ),
    terms={
        "coat": "a clear layer that mirrors the share F and lets the rest through, in and out",
        "body": "what lies under the coat and sends light back evenly: paint, pigment, skin",
        "F_avg": "the share of even light that a coat mirrors: F₀ + (1 - F₀) / 21 by Schlick's fit",
    },
)
