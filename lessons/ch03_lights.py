"""Lights: where the light of a local shading model comes from.

A real lamp is a body; a shading model wants to know only what arrives at one point, from which direction. Between the
two stands a description of the emission, and here it is a measured one.
"""

from app.lesson import (
    Camera,
    Chapter,
    Check,
    Exercise,
    Figure,
    Handle,
    Label,
    Mark,
    Prediction,
    Readout,
    Scene,
    Sheet,
    Step,
    Surface,
    Table,
    Term,
    Value,
)

IES_LAMPS = ("down", "wall", "street", "flood", "up", "bare")
IES_FILES = ("downlight", "wall_washer", "street_light", "flood", "uplight", "bare")

IES_GLSL = """
#include "optics/ies.glsl"
#include "display/look.glsl"
uniform sampler2D table;
uniform float height;
uniform float setback;
uniform float turn;
uniform float aim;
uniform float meter_x;
uniform float meter_s;

const float WIDE = 2.6, DEEP = 3.2, HIGH = 3.0; // of the room, m; the wall is y = 0, the floor z = 0
const float DECADES = 3.5;                      // of the scale, from 1 lx
const float SIZE = 1.1;                         // of the solid, m

vec3 luminaire() {
    return vec3(0.0, -setback, height);
}

// The luminaire's own frame (front, left, up) in the room; at turn 0 its front faces the wall.
vec3 placed(vec3 p) {
    vec3 q = vec3(p.x * cos(aim) - p.z * sin(aim), p.y, p.z * cos(aim) + p.x * sin(aim));
    return luminaire() + vec3(-q.x * sin(turn) - q.y * cos(turn), q.x * cos(turn) - q.y * sin(turn), q.z);
}

// A photometric plane from the zenith over the nadir and back, as a polar curve.
vec3 polar(float plane, float t) {
    float theta = PI * (2.0 * t - 1.0);
    float r = SIZE * ies_plane(table, theta, plane) / ies_peak(table);
    return placed(r * vec3(sin(theta) * cos(plane), sin(theta) * sin(plane), -cos(theta)));
}

vec3 meter() {
    return vec3(meter_x, min(meter_s, 0.0), max(meter_s, 0.0));
}

vec3 surface_point(int surface, vec2 s) {
    float x = WIDE * (2.0 * s.x - 1.0);
    if (surface == 0) return vec3(x, -DEEP * s.y, 0.0);
    if (surface == 1) return vec3(x, 0.0, HIGH * s.y);
    if (surface == 2) return vec3(WIDE + 0.28 + 0.22 * s.x, 0.0, HIGH * s.y);
    return placed(SIZE * ies_solid(table, s.x, s.y));
}

// The colour of an illuminance on a logarithmic scale, with lines at 1, 2, 5, 10, ... lx.
vec3 lux_colour(float lux) {
    float g = log(max(lux, 1e-3)) / log(10.0), f = fract(g), wide = max(fwidth(g), 1e-6);
    float off = min(min(f, 1.0 - f), min(abs(f - 0.30103), abs(f - 0.69897)));
    float line = g < -0.01 ? 0.0 : (1.0 - smoothstep(0.5, 1.5, off / wide)) * clamp(0.08 / wide, 0.0, 1.0);
    float strong = min(f, 1.0 - f) < 0.1 ? 0.85 : 0.4;
    return mix(colormap(g / DECADES), background, line * strong);
}

vec3 shade(Surface s) {
    if (s.id == 3) return soft_light(palette[COLOUR_L], s.normal, s.v);
    if (s.id == 2) return lux_colour(pow(10.0, DECADES * s.st.y));
    float along = s.id == 0 ? min(s.position.y, 0.0) : max(s.position.z, 1e-6);
    return lux_colour(ies_room_illuminance(table, height, setback, turn, aim, s.position.x, along));
}

vec3 mark_point(int mark, float t) {
    if (mark == 0) return polar(0.0, t);
    if (mark == 1) return polar(0.5 * PI, t);
    if (mark == 2) return luminaire();
    if (mark == 3) return mix(luminaire(), meter(), t);
    if (mark == 4) return meter() + 0.65 * t * (meter_s > 0.0 ? vec3(0.0, -1.0, 0.0) : vec3(0.0, 0.0, 1.0));
    return mix(luminaire(), vec3(0.0, -setback, 0.0), t);
}

vec4 probe(int i) {
    if (i == 0) return vec4(luminaire(), 1.0);
    if (i == 1) return vec4(meter(), 1.0);
    return vec4(WIDE + 1.12, 0.0, HIGH * float(i - 2) / DECADES, 1.0);
}
"""

IES = Step(
    name="ies",
    title="Measured light: IES files",
    idea="An IES file lists measured candela by direction; what it emits is their sum over the sphere.",
    slides=("IES Lights",),
    prose=r"""
A maker measures a luminaire in a dark room: so many candela in this direction, so many in that. The list is an
**IES file**. Directions are $\theta$ from straight down and *planes* $C$ around the vertical; between them we
interpolate, and where nothing was measured it is dark.

The $\colour{l}{\text{photometric solid}}$ reaches as far as the intensity; two of its planes are drawn, $C_0$ towards
the wall and $C_{90}$. Wall and floor show the illuminance

$$E = \frac{I(\theta, C)\,\cos\beta}{r^2}$$

with lines of equal lux. Drag the luminaire and the meter.

Try the [downlight](?luminaire=down), the [street light](?luminaire=street&height=3.6), the
[flood aimed up](?luminaire=flood&aim=70), the [uplight](?luminaire=up&height=1.6), the
[bare lamp](?luminaire=bare). One of these files does not emit what it declares. Drop your own on the window.
""",
    scene=Scene(
        glsl=IES_GLSL,
        surfaces=(
            Surface("floor", cells=(1, 1)),
            Surface("wall", cells=(1, 1)),
            Surface("scale", cells=(1, 1)),
            Surface("photometric solid", cells=(96, 64), opacity=0.5),
        ),
        marks=(
            Mark("plane C0", colour="l", segments=144, width=1.2),
            Mark("plane C90", colour="l", line="dashed", segments=144),
            Mark("luminaire", colour="exact", tip="dot", width=1.4),
            Mark("to the meter", colour="l", line="dotted", width=0.9),
            Mark("normal of the meter", colour="n", tip="arrow", width=1.2, label="n"),
            Mark("drop", colour="quiet", line="dashed", width=0.7),
        ),
        labels=(Label("1 lx", 2), Label("10", 3), Label("100", 4), Label("1000", 5)),
        handles=(Handle("the luminaire", 0, ("height", "setback")), Handle("the lux meter", 1, ("meter_x", "meter_s"))),
        camera=Camera(azimuth=-60, elevation=22, distance=13.6, target=(0.4, -1.0, 1.1)),
        legend=(("l", "photometric solid"), ("n", "normal of the meter")),
        tables=(Table("table", IES_FILES, "luminaire"),),
    ),
    plot=Figure(
        title="Photometric solid",
        sheets=(Sheet("intensity", Term("ies_solid"), colour="l", cells=(120, 90),
                      height=Term("ies_solid_candela"), height_label="luminous intensity in cd"),),
        dome="sphere",
        camera=Camera(azimuth=-60, elevation=16, distance=4.5),
    ),
    readouts=(
        Readout("integrated", Term("ies_flux"), role="exact", unit="lm"),
        Readout("declared", Term("ies_declared"), role="printed", unit="lm", against="integrated",
                absent="none: absolute"),
        Readout("peak", Term("ies_peak"), unit="cd"),
        Readout("at the meter", Term("ies_room_illuminance"), unit="lx"),
    ),
    ask=Prediction(
        question="The bare lamp's file declares 1000 lm and lists 1000 cos θ candela. How many lumens does it emit?",
        truth=Term("ies_flux"),
        unit="lm",
        low=0.0,
        high=6000.0,
        sets={"luminaire": 5},
        told="3140: about π times what it declares. Its author took the 1000 cd straight down for lumens.",
    ),
    notes="""
Show the downlight, then the wall washer, and ask which belongs in a museum. Pull the luminaire away from the wall:
twice as far, a quarter of the lux. Then the bare lamp. Common wrong answers: 1000 lm, because the file says so, and
12 566, because 4π is in the air; but a cosine lights half the sphere and its mean there is one half. The gap between
declared and integrated lumens of an honest file is the light that stays in the luminaire, here a fifth or so. The
street light keeps only the planes from 90° to 270°: the rest is their mirror image. Turn it, and see what turns.
6 minutes.
""",
    sources=("IES LM-63-1986 to LM-63-2019, by the rules of the optics reference, section 7",
             "Deck, slides IES Lights and Units for Lighting - Candela",
             "The files are made for this course (lessons/ies)"),
    honesty="Integrated: exact for intensities joined by straight lines, 3139.60 lm for the bare lamp; the smooth "
            "cosine has 1000π = 3141.59 lm. Far field, direct light only: no shadows, nothing reflected.",
    values=(
        Value("luminaire", 1, choices=IES_LAMPS),
        Value("height", 2.4, low=0.3, high=3.6, scale="linear"),
        Value("setback", 1.0, low=0.3, high=3.0),
        Value("turn", 0.0, low=-180.0, high=180.0),
        Value("aim", 0.0, low=0.0, high=90.0, more=True),
        Value("meter_x", 0.9, low=-2.6, high=2.6, more=True),
        Value("meter_s", -1.7, low=-3.2, high=3.0, more=True),
    ),
    minutes=6,
)

IES_RING_STUB = '''import numpy as np


def ies_ring_flux(theta, d_theta, candela_below, candela_above):
    """Flux in lm of the ring from theta - d_theta / 2 to theta + d_theta / 2 (rad), its intensity linear in between."""
    return np.zeros(np.broadcast_shapes(*map(np.shape, (theta, d_theta, candela_below, candela_above))))
'''
IES_RING_SOLUTION = '''import numpy as np


def ies_ring_flux(theta, d_theta, candela_below, candela_above):
    """2 pi int (p + q t) sin t dt, as sums that do not cancel; sin h / h - cos h by its series."""
    h = 0.5 * d_theta
    x = h * h
    series = 1 - x / 10 * (1 - x / 28 * (1 - x / 54 * (1 - x / 88 * (1 - x / 130 * (1 - x / 180 * (1 - x / 238))))))
    even, odd = np.sin(theta) * np.sin(h), np.cos(theta) * x / 3 * series
    return 2 * np.pi * ((candela_below + candela_above) * even + (candela_above - candela_below) * odd)
'''
IES_RING_GLSL_STUB = """#include "core/constants.glsl"

float ies_ring_flux(float theta, float d_theta, float candela_below, float candela_above) {
    return 0.0 * PI;
}
"""
IES_RING_GLSL_SOLUTION = """#include "core/constants.glsl"

float ies_ring_flux(float theta, float d_theta, float candela_below, float candela_above) {
    float h = 0.5 * d_theta, x = h * h;
    float series = 1.0 - x / 10.0 * (1.0 - x / 28.0 * (1.0 - x / 54.0 * (1.0 - x / 88.0 * (1.0 - x / 130.0))));
    float even = sin(theta) * sin(h), odd = cos(theta) * (x / 3.0 * series);
    return 2.0 * PI * ((candela_below + candela_above) * even + (candela_above - candela_below) * odd);
}
"""
IES_EXERCISE = Exercise(
    name="ring",
    function="ies_ring_flux",
    task="Write the luminous flux in the ring between two angles, when the intensity runs linearly from one to the "
         "other, so that it still holds in float32 for a ring a tenth of a degree wide.",
    slide="IES Lights",
    stubs={"python": IES_RING_STUB, "glsl": IES_RING_GLSL_STUB},
    solutions={"python": IES_RING_SOLUTION, "glsl": IES_RING_GLSL_SOLUTION},
    checks=(
        Check({"theta": (1.5707963,), "d_theta": (3.1415926,), "candela_below": (1.0,), "candela_above": (1.0,)},
              "one candela everywhere: 4π lm"),
        Check({"theta": (0.7, 1.2, 2.3), "d_theta": (0.2, 0.5, 0.1), "candela_below": (100.0, 0.0, 40.0),
               "candela_above": (80.0, 30.0, 60.0)}, "rings of ordinary width"),
        Check({"theta": (0.001, 1.0, 2.0), "d_theta": (0.00175, 0.00175, 0.0001), "candela_below": (1000.0, 10.0, 3.0),
               "candela_above": (990.0, 20.0, 2.0)}, "narrow rings, one of them at the pole", hidden=True),
    ),
)

CHAPTER = Chapter(
    title="Lights",
    idea="A light source is what it sends in every direction.",
    steps=(IES,),
    exercises=(IES_EXERCISE,),
    terms={
        "IES file": "a list of measured luminous intensities by direction, in the format LM-63",
        "photometric solid": "a surface that lies in each direction as far out as the luminous intensity",
        "photometric plane": "a half plane of directions with one azimuth, C0, C90, ...",
        "absolute photometry": "candela as they are, with no lumens of the lamp they refer to; the file says -1",
    },
)
