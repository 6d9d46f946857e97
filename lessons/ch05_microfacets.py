"""What does a rough surface look like from close by? Thousands of small mirrors, each leaning its own way.

Torrance and Sparrow model a surface that is too rough to be a mirror as many flat facets. This chapter zooms in on them,
counts the ones that send light to the eye and those that stand in each other's way, and puts them into one formula.
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
    Prediction,
    Readout,
    Scene,
    Step,
    Surface,
    Term,
    Value,
)

TORRANCE_SPARROW = "The Torrance – Sparrow Microfacet Model ({})".format

GROOVES = Step(
    name="grooves",
    title="A brushed plate from close by",
    idea="A rough surface is a crowd of small flat mirrors; the eye sees only what they do together.",
    slides=(TORRANCE_SPARROW(1),),
    prose=r"""
A brushed plate of steel shines, but it shows no image: the light is drawn out into a streak *across* the scratches. Pull
the end of the scale bar and come closer: [×10](?zoom=10), [×100](?zoom=100).

There is no roughness any more. There are **V-shaped grooves** with flat sides, and every side, a **facet**, is a clean
mirror that shows another part of the room. Roughness is what their mirror images look like when the eye cannot part them.
That happens soon: it resolves one arc minute.

One number says how steep they are: $m$, the root of the mean square of their slopes. Make the plate
[smooth](?m=0.03) and [rough](?m=0.5), and watch the mirror image of the window dissolve.
""",
    scene=Scene(
        glsl="""
#include "optics/brushed.glsl"
#include "optics/facets.glsl"
uniform float zoom;
uniform float m;

const float GROOVE = 20.0; // micrometres
const float DEEP = 0.55;
const int COLUMNS = 260;
const int SAMPLES = 16;

// The slope of the sides of a groove: any of ten thousand, the same each time.
float slope_of(float groove) {
    return facet_slope(int(facet_index(int(groove) + 4000, 10000)), m, 10000);
}

// Height of the plate at a place counted in grooves; ridges are at 0.
float height(float at) {
    float groove = floor(at), f = at - groove;
    return -slope_of(groove) * min(f, 1.0 - f) * 2.0 / grooves_shown(zoom, GROOVE);
}

vec2 profile(float s) {
    float shown = grooves_shown(zoom, GROOVE), half_shown = 0.5 * shown;
    float at = (s - 0.5) * shown;
    if (shown > 0.45 * float(COLUMNS)) return vec2(2.0 * s - 1.0, 0.0);
    at = clamp(floor(-half_shown) + 0.5 * floor(s * float(COLUMNS) + 0.5), -half_shown, half_shown);
    return vec2(at / half_shown, height(at));
}

vec3 surface_point(int surface, vec2 s) {
    vec2 p = profile(s.x);
    if (surface == 0) return vec3(p.x, 2.0 * s.y - 1.0, p.y);
    if (surface == 1) return vec3(p.x, -1.0, mix(-DEEP, p.y, s.y));
    return vec3(1.0, 2.0 * s.x - 1.0, mix(-DEEP, profile(1.0).y, s.y));
}

// The room on the far side: a window in the evening and a lamp on a dark wall.
vec3 room(vec3 d) {
    vec2 p = d.xz / max(d.y, 0.02);
    vec3 wall = mix(vec3(0.05, 0.07, 0.10), vec3(0.16, 0.20, 0.27), smoothstep(0.2, 1.3, p.y));
    vec2 q = abs(p - vec2(-0.32, 0.71));
    if (q.x < 0.15 && q.y < 0.13 && q.x > 0.008 && q.y > 0.008) return mix(vec3(1.4, 0.85, 0.42), vec3(0.85, 1.05, 1.3), smoothstep(0.6, 0.82, p.y));
    return wall + vec3(1.6, 0.75, 0.25) * smoothstep(0.055, 0.035, length(p - vec2(-0.06, 0.62)));
}

vec3 mirrored(vec3 facet, vec3 v) {
    vec3 r = reflect(-v, facet), steel = vec3(0.78, 0.79, 0.80);
    return r.z > 0.0 ? steel * room(r) : steel * steel * room(vec3(r.xy, -r.z));
}

vec3 shade(Surface s) {
    if (s.id > 0) {
        vec3 cut = mix(vec3(0.10, 0.11, 0.12), vec3(0.20, 0.21, 0.23), s.st.y);
        return s.id == 1 ? cut : 0.6 * cut;
    }
    float at = 0.5 * s.position.x * grooves_shown(zoom, GROOVE), wide = fwidth(at), sum = 0.0;
    vec3 light = vec3(0.0);
    for (int k = 0; k < SAMPLES; k++) {
        float x = at + wide * ((float(k) + 0.5) / float(SAMPLES) - 0.5), groove = floor(x);
        float side = wide > 2.0 ? float(k % 2) : x - groove;
        vec3 facet = normalize(vec3(slope_of(groove) * (side < 0.5 ? 1.0 : -1.0), 0.0, 1.0));
        float seen = max(dot(facet, s.v), 0.0) / facet.z;
        light += seen * mirrored(facet, s.v);
        sum += seen;
    }
    return light / max(sum, 1e-6);
}

float bar_end() {
    return -1.0 + 0.02 * zoom;
}

vec3 mark_point(int mark, float t) {
    if (mark == 0) return vec3(mix(-1.0, bar_end(), t), -1.02, -DEEP - 0.12);
    float x = mark == 1 ? -1.0 : bar_end();
    return vec3(x, -1.02, -DEEP - 0.19 + 0.14 * t);
}

vec4 probe(int i) {
    return vec4(i == 0 ? bar_end() : -0.7, -1.02, -DEEP - (i == 0 ? 0.12 : 0.32), 1.0);
}
""",
        surfaces=(Surface("plate", cells=(260, 1)), Surface("cut", cells=(260, 1)), Surface("side", cells=(1, 1))),
        marks=(Mark("scale bar", colour="exact", width=1.6), Mark("its start", colour="exact", width=1.6),
               Mark("its end", colour="exact", width=1.6)),
        labels=(Label("0.2 mm", 1),),
        handles=(Handle("the scale", 0, ("zoom",)),),
        camera=Camera(azimuth=-74, elevation=33, distance=5.3, target=(0.0, 0.0, -0.28)),
    ),
    plot=Curves(
        title="Where single grooves can still be seen",
        sweep="groove_width",
        curves=(Curve("by a sharp eye, up to", Term("resolved_distance")),),
        y_label="distance of the eye, cm",
        y_scale="log",
    ),
    readouts=(
        Readout("width of the picture", Term("plate_shown"), unit="mm"),
        Readout("grooves side by side", Term("grooves_shown", {"groove_width": 20.0}), unit=""),
        Readout("seen singly up to", Term("resolved_distance", {"groove_width": 20.0}), unit="cm"),
    ),
    ask=Prediction(
        question="The grooves of this plate are 20 µm wide. From how far away can a sharp eye still see them singly?",
        truth=Term("resolved_distance", {"groove_width": 20.0}),
        unit="cm",
        low=1.0,
        high=1000.0,
        scale="log",
        sets={"zoom": 1.0},
        told="6.9 cm, nearer than most eyes can focus. So nobody ever sees a facet: roughness is the word for their sum.",
    ),
    notes="""
Bring a ruler or a knife of brushed steel and a lamp: the streak runs across the scratches, and it turns when you turn the
plate. Ask why, and leave it open. Then zoom. The moment to wait for is about ×30, where noise turns into stripes and each
stripe into a clear image of a piece of the room. Ask what one stripe lacks to be a mirror: nothing. Common wrong answer:
rough means dull, every point scatters. Here no point does. 5 minutes.
""",
    sources=("Deck, slide The Torrance - Sparrow Microfacet Model (1)", "Torrance & Sparrow 1967",
             "Beckmann & Spizzichino 1963: the slopes"),
    honesty="Each pixel shows the mean of sixteen mirror images in its facets. Grooves of equal width with ridges of equal "
            "height are the model's; real scratches are not so tidy. The room is made up.",
    values=(Value("zoom", 1.0, low=1.0, high=100.0), Value("m", 0.2, low=0.02, high=0.8),
            Value("groove_width", 20.0, more=True)),
    minutes=5,
)

PYTHON_STUB = '''import numpy as np


def groove_open(facet, lean_l, lean_v):
    """The share of a facet that is lit and seen. facet, lean_l, lean_v: (...), angles from n in rad, with their sign."""
    return np.zeros(np.broadcast_shapes(np.shape(facet), np.shape(lean_l), np.shape(lean_v)))
'''
PYTHON_SOLUTION = '''import numpy as np


def groove_open(facet, lean_l, lean_v):
    """Both hidden parts begin in the valley: the smaller share counts, not their product."""
    def shown(lean):
        facing = np.cos(facet - lean)
        share = 2 * np.cos(facet) * np.cos(lean) / np.where(facing > 0, facing, 1)
        return np.where(facing > 0, np.minimum(share, 1), 0)

    return np.minimum(shown(lean_l), shown(lean_v))
'''
GLSL_STUB = """float groove_open(float facet, float lean_l, float lean_v) {
    return 0.0;
}
"""
GLSL_SOLUTION = """float shown(float facet, float lean) {
    float facing = cos(facet - lean); // m.l or m.v
    return facing > 0.0 ? min(1.0, 2.0 * cos(facet) * cos(lean) / facing) : 0.0;
}

float groove_open(float facet, float lean_l, float lean_v) {
    return min(shown(facet, lean_l), shown(facet, lean_v)); // both hidden parts begin in the valley
}
"""

CHAPTER = Chapter(
    title="Microfacets",
    idea="A rough surface is many small mirrors: count those that face h, take away those that are blocked.",
    steps=(GROOVES,),
    exercises=(
        Exercise(
            name="groove",
            function="groove_open",
            task="Write the share of a facet that is both lit and seen, 2 n.m n.l / m.l and 2 n.m n.v / m.v, at most 1.",
            slide="Shadowing and Masking",
            stubs={"python": PYTHON_STUB, "glsl": GLSL_STUB},
            solutions={"python": PYTHON_SOLUTION, "glsl": GLSL_SOLUTION},
            checks=(
                Check({"facet": (0.0, 0.5, -0.4), "lean_l": (1.2, 0.1, 0.3), "lean_v": (-0.9, 0.2, 0.1)},
                      "nothing is in the way"),
                Check({"facet": (0.7, 0.7), "lean_l": (0.2, -0.1), "lean_v": (1.3, 1.4)}, "masked from the eye"),
                Check({"facet": (0.7, -0.9), "lean_l": (1.3, -1.2), "lean_v": (0.2, -0.3)}, "shadowed from the light"),
                Check({"facet": (0.8, 0.8), "lean_l": (1.2, 1.4), "lean_v": (1.4, 1.2)}, "both: one hides the other"),
                Check({"facet": (1.0, -1.0, 0.3), "lean_l": (-1.0, 0.2, -1.2), "lean_v": (0.1, 0.9, -1.0)},
                      "turned away", hidden=True),
            ),
        ),
    ),
    terms={
        "microfacet": "a flat piece of a rough surface, too small to be seen, that mirrors light one way only",
        "V-groove": "two facets that lean to each other in a valley, the model of Torrance and Sparrow",
    },
)
