"""Why is a lake black at your feet and a mirror far away? Every boundary reflects a share of the light: the Fresnel term.

A facet of a rough surface is a small flat mirror. How much it reflects depends on what it is made of and on the angle
between the light and the facet's own normal, which is the halfway vector h. This chapter measures that share.
"""

from app.lesson import (
    Break,
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

PI = 3.141592653589793
FRESNEL = "Cook – Torrance – Fresnel Term ({})".format
CHANNELS = ("red", "green", "blue")
CHANNEL_COLOURS = ("#D9483B", "#2C9C55", "#3B7DD8")
METAL_NAMES = ("gold", "silver", "copper", "iron", "aluminium")
MATERIAL_NAMES = ("water", "glass", "plastic", "ruby", "diamond", *METAL_NAMES)
GOLD, IRON, GLASS = "#C99A1E", "#8C8F94", "#3E9E6E"

FLAT_MIRROR = Step(
    name="flat_mirror",
    title="A flat boundary divides the light",
    idea="A flat boundary sends a share F of the light into the mirror direction and lets 1 - F in; nothing is lost.",
    slides=(FRESNEL(1),),
    prose=r"""
Light comes along $\colour{l}{l}$ and meets smooth glass. A share $F$ leaves in the
$\colour{r}{\text{mirror direction}}$; the rest goes $\colour{estimate}{\text{in}}$, bent towards the normal:

$$\colour{r}{R} + \colour{estimate}{T} = 1, \qquad R = F(l\cdot h)$$

The beams are as wide as their [share of the light](code:f_dielectric). If the eye sits at the mirror direction, the halfway vector
$\colour{h}{h}$ is the facet's normal: the angle that counts is the one between $l$ and $h$.

Come in [head on](?theta=0), [at 60°](?theta=60), [at a glancing angle](?theta=86). Try [water](?eta=1.333) and
[diamond](?eta=2.4175). Set $\eta$ to [1](?eta=1): the boundary is gone.
""",
    scene=Scene(
        glsl="""
#include "optics/interface.glsl"
#include "display/look.glsl"
uniform float theta;
uniform float eta;

const float WIDE = 0.5; // of the incoming beam

vec3 along(int beam) {
    float t = min(theta, 0.5 * PI);
    if (beam == 0) return vec3(-sin(t), 0.0, cos(t));
    if (beam == 1) return vec3(sin(t), 0.0, cos(t));
    float inside = refracted_angle(t, eta);
    return vec3(sin(inside), 0.0, -cos(inside));
}

float share(int beam) {
    return beam == 0 ? 1.0 : beam == 1 ? reflected_share(theta, eta) : transmitted_share(theta, eta);
}

vec3 surface_point(int surface, vec2 s) {
    if (surface < 3) {
        vec3 d = along(surface), across = vec3(d.z, 0.0, -d.x);
        return d * (1.9 * s.x - 0.3) + across * (s.y - 0.5) * WIDE * share(surface) - vec3(0.0, 0.01 * float(3 - surface), 0.0);
    }
    if (surface == 3) return vec3(2.35 + 0.3 * s.x, -0.01, -1.4 + 2.6 * s.y);
    if (surface == 4) return vec3(-2.0 + 4.0 * s.x, 0.0, -1.5 * s.y);
    return vec3(-2.0 + 4.0 * s.x, 1.6 * s.y, 0.0);
}

vec3 shade(Surface s) {
    if (s.id < 3 && (s.id == 2 ? s.position.z > 0.0 : s.position.z < 0.0)) discard;
    if (s.id == 0) return palette[COLOUR_L];
    if (s.id == 1) return palette[COLOUR_R];
    if (s.id == 2) return palette[COLOUR_ESTIMATE];
    if (s.id == 3) return s.st.y < share(1) ? palette[COLOUR_R] : palette[COLOUR_ESTIMATE];
    vec3 tint = mix(palette[COLOUR_QUIET], palette[COLOUR_N], 0.35);
    if (s.id == 4) return tint * (1.0 - 0.5 * s.st.y);
    return mix(tint, palette[COLOUR_EXACT], 0.4 * grid_lines(s.st, vec2(16.0, 6.0)));
}

vec3 mark_point(int mark, float t) {
    vec3 lift = vec3(0.0, -0.05, 0.0);
    if (mark == 0) return vec3(0.0, 0.0, 1.5 * t) + lift;
    if (mark == 1) return 1.75 * t * along(0) + lift;
    if (mark == 2) return 1.6 * t * along(1) + lift;
    if (mark == 3) return 1.45 * t * along(2) + lift;
    if (mark == 4) return vec3(0.0, 0.0, 0.95 * t) + 2.0 * lift;
    return vec3(-2.0 + 4.0 * t, 0.0, 0.0) + lift;
}

vec4 probe(int i) {
    if (i == 0) return vec4(1.6 * along(0), 1.0);
    if (i == 1) return vec4(2.5, 0.0, 1.36, 1.0);
    if (i == 2) return vec4(2.5, 0.0, -1.62, 1.0);
    return vec4(-1.6, 0.0, -1.25, 1.0);
}
""",
        surfaces=(
            Surface("incoming beam", cells=(1, 1)), Surface("reflected beam", cells=(1, 1)),
            Surface("beam inside", cells=(1, 1)), Surface("shares", cells=(1, 1)),
            Surface("glass", cells=(1, 1), opacity=0.35), Surface("boundary", cells=(1, 1), opacity=0.3),
        ),
        marks=(
            Mark("normal", colour="n", tip="arrow", label="n"),
            Mark("to the light", colour="l", tip="sun", label="l"),
            Mark("mirror", colour="r", line="dotted", tip="arrow", label="r"),
            Mark("refracted", colour="estimate", tip="arrow"),
            Mark("halfway", colour="h", line="dashed", tip="arrow", label="h", label_at=0.9),
            Mark("edge", colour="quiet"),
        ),
        labels=(Label("T", 1, "estimate"), Label("R", 2, "r"), Label("η", 3)),
        handles=(Handle("the light", 0, ("theta",)),),
        legend=(("l", "incoming, 1"), ("r", "reflected, R"), ("estimate", "inside, T")),
        camera=Camera(azimuth=-90, elevation=4, distance=12.2, target=(0.32, 0.0, -0.15), field_of_view=24),
    ),
    plot=Curves(
        title="Where the light goes",
        sweep="theta",
        curves=(Curve("R + T", Term("both_shares")), Curve("T, goes in", Term("transmitted_share"), role="estimate"),
                Curve("R, reflected", Term("reflected_share"), role="printed")),
        y_label="share of the light",
    ),
    readouts=(
        Readout("reflected R", Term("reflected_share"), role="exact", unit=""),
        Readout("inside T", Term("transmitted_share"), role="exact", unit=""),
        Readout("R + T", Term("both_shares"), unit=""),
    ),
    ask=Prediction(
        question="You look straight through a clean window pane of glass, η = 1.5. What share of the light does its first "
                 "face send back?",
        truth=Term("reflected_share", {"theta": 0.0, "eta": 1.5}),
        unit="of it",
        low=0.0,
        high=0.5,
        sets={"theta": 0.0, "eta": 1.5},
        told="0.04: four per cent. Two faces with so little each make the mirror image of you in a shop window.",
    ),
    notes="""
Hold up a sheet of glass, or use the window. Everyone sees the mirror image, four per cent from each face. Drag the light
down to the boundary: the reflected beam grows from a thread to all of it, mostly in the last fifteen degrees. Ask what the
beam inside does meanwhile: its direction hardly moves any more, its width goes. Common wrong answer: a third, because
the image is so clear; a dark background makes that little visible. 5 minutes.
""",
    sources=("Deck, slide Fresnel Term (1)", "Fresnel 1823", "Snell's law"),
    honesty="Exact for unpolarised light and a smooth, clear boundary. Beam widths show flux: a real beam changes its width "
            "when it is bent. What happens deeper inside is left out.",
    values=(Value("theta", 76.0, low=0.0, high=90.0), Value("eta", 1.5, low=1.0, high=3.0)),
    minutes=5,
)

ANGLE = Step(
    name="angle",
    title="The lake at your feet, and far away",
    idea="F hardly changes up to 60°, then shoots up to 1: every smooth surface is a mirror at a glancing angle.",
    slides=(FRESNEL(2), FRESNEL(3)),
    prose=r"""
Stand at a lake. At your feet you see stones; far out you see mountains, upside down. The water is the same, the angle
$\colour{l}{\theta}$ is not: it grows from 20° at your feet towards 90° at the horizon.

The share is a mean of two. Light that swings [*across*](code:f_dielectric_s) the plane of incidence ($\colour{estimate}{s}$) is reflected
more than light that swings [*along*](code:f_dielectric_p) it ($\colour{printed}{p}$), and at **Brewster's angle**, $\tan\theta = \eta$, no $p$ is
reflected at all. A polariser picks one: [s only](?polariser=0), [both](?polariser=45), [p only](?polariser=90).

With $p$ only the mirror goes out along the dashed line, and you see the ground there. Photographers know. Walk the
$\colour{l}{\text{ring}}$ to [the near stones](?theta=36), [Brewster](?theta=53.1), [far out](?theta=87).
""",
    scene=Scene(
        glsl="""
#include "optics/fresnel.glsl"
uniform float theta;
uniform float eta;
uniform float polariser;

const vec3 EYE = vec3(0.0, 0.0, 1.7);
const float FAR = 40.0;

// A sine for scenery, of parabolas: off by 0.06, and a tenth of the price.
vec2 wave(vec2 x) {
    vec2 t = 2.0 * fract(x / (2.0 * PI)) - 1.0;
    return 4.0 * t * (abs(t) - 1.0);
}

vec3 scenery(vec3 d) {
    float up = d.z / max(length(d.xy), 1e-4), a = d.x / max(d.y, 1e-4);
    vec2 broad = wave(vec2(5.0 * a + 1.0, 13.0 * a)), near = wave(vec2(9.0 * a + 3.0, 41.0 * a));
    float ridge = 0.13 + 0.05 * broad.x + 0.03 * broad.y + 0.012 * wave(vec2(37.0 * a + 2.0)).x;
    float hills = 0.045 + 0.02 * near.x + 0.008 * near.y;
    vec3 sky = mix(vec3(1.0, 0.62, 0.30), vec3(0.16, 0.34, 0.68), smoothstep(0.02, 0.6, up));
    if (up < hills) return vec3(0.03, 0.06, 0.035);
    if (up < ridge) return mix(vec3(0.20, 0.15, 0.22), vec3(0.75, 0.72, 0.78), smoothstep(0.11, 0.19, up));
    return sky;
}

vec3 ground(vec2 p) {
    vec2 cell = floor(p * 5.0), best = vec2(81.0, 0.0);
    for (int i = 0; i < 9; i++) {
        vec2 at = cell + vec2(float(i % 3 - 1), float(i / 3 - 1));
        vec2 jitter = fract(437.5 * wave(vec2(dot(at, vec2(12.7, 31.1)), dot(at, vec2(26.9, 18.3)))));
        vec2 off = (p * 5.0 - at - jitter) / (0.6 + 0.8 * fract(7.0 * jitter.y));
        float d2 = dot(off, off);
        if (d2 < best.x) best = vec2(d2, jitter.x);
    }
    vec3 stone = mix(vec3(0.05, 0.08, 0.07), vec3(0.24, 0.22, 0.15), best.y);
    vec3 near = stone * (1.0 - 0.9 * smoothstep(0.25, 0.75, sqrt(best.x)));
    return mix(near, vec3(0.02, 0.07, 0.08), smoothstep(2.0, 9.0, length(p)));
}

vec3 ring(float angle, float turn) {
    float r = 1.7 * tan(min(angle, 1.53));
    return vec3(r * sin(turn), r * cos(turn), 0.01);
}

// The view as a picture of a size of its own: where the ray through (x, y) of it meets the lake, or beyond the shore the
// sky; the shore lies where the rays are FAR metres long.
vec3 surface_point(int surface, vec2 s) {
    float x = 1.44 * (s.x - 0.5), shore = (0.4067 - EYE.z / FAR * sqrt(1.19 + x * x)) / 0.9135;
    float y = surface == 0 ? mix(-0.68, shore, s.y) : mix(shore, 0.68, s.y);
    vec3 d = vec3(x, 0.9135 + 0.4067 * y, -0.4067 + 0.9135 * y);
    return EYE + d * (surface == 0 ? -EYE.z / d.z : FAR / length(d));
}

vec3 shade(Surface s) {
    vec3 off = s.position - EYE;
    float far = length(off), calm = 0.012 / (1.0 + 0.5 * far);
    vec3 d = off / far;
    if (s.id == 1) return scenery(d);
    vec2 p = s.position.xy * 7.0;
    vec2 ripple = wave(vec2(p.x, 1.3 * p.y) + vec2(2.0, 1.5) * wave(vec2(0.7, 0.6) * p.yx));
    vec3 n = normalize(vec3(calm * ripple, 1.0));
    float c = clamp(dot(n, -d), 0.0, 1.0), turn = cos(polariser) * cos(polariser);
    float f = f_dielectric_s(c, eta) * turn + f_dielectric_p(c, eta) * (1.0 - turn);
    vec3 r = reflect(d, n);
    r.z = abs(r.z);
    return mix(ground(s.position.xy - 0.25 * d.xy / max(-d.z, 0.2)), scenery(r), f);
}

vec3 mark_point(int mark, float t) {
    float turn = 1.2 * (t - 0.5);
    if (mark == 0) return ring(theta, turn);
    return ring(brewster_angle(eta), turn);
}

vec4 probe(int i) {
    return vec4(ring(theta, 0.0), 1.0);
}
""",
        surfaces=(Surface("lake", cells=(24, 1)), Surface("shore and sky", cells=(24, 1))),
        marks=(
            Mark("ring", colour="l", segments=24, width=2.0, label="θ", label_at=0.2),
            Mark("Brewster", colour="printed", line="dashed", segments=24, label="Brewster", label_at=0.75),
        ),
        handles=(Handle("the ring", 0, ("theta",)),),
        camera=Camera(azimuth=-90, elevation=24, distance=1.0, target=(0.0, 0.9135, 1.2933), field_of_view=74),
    ),
    plot=Curves(
        title="Reflected share against the angle",
        sweep="theta",
        curves=(Curve("unpolarised", Term("reflected_share")), Curve("s, across", Term("reflected_share_s"), role="estimate"),
                Curve("p, along", Term("reflected_share_p"), role="printed")),
        y_label="share reflected",
    ),
    readouts=(
        Readout("unpolarised F", Term("reflected_share"), role="exact", unit=""),
        Readout("through the polariser", Term("polarised_share"), role="exact", unit=""),
        Readout("s, across", Term("reflected_share_s"), unit=""),
        Readout("p, along", Term("reflected_share_p"), unit=""),
    ),
    ask=Prediction(
        question="Straight down, water reflects 2 %. At what angle from the vertical does it reflect half of the light?",
        truth=Term("angle_of_half", {"eta": 1.333}),
        unit="°",
        low=0.0,
        high=90.0,
        sets={"theta": 83.5, "eta": 1.333},
        told="83.5°: almost level with the water. Up to 60° it is still 6 %; the whole climb is at the end.",
    ),
    notes="""
Everyone has stood at a lake; nobody has measured it. Take guesses before the slider moves: 45° and 60° are usual, because
half way feels like half. Then walk the ring out: 2 % at the feet, 6 % at 60°, half at 83.5°. Turn the polariser to p only:
the stones appear beyond the feet, as with sunglasses. Ask why sunglasses are built to stop s: glare from roads and water
lies near Brewster's angle. Ripples tilt the normal a little, so the far mirror is broken into strips. 7 minutes.
""",
    sources=("Deck, slides Fresnel Term (2) and (3)", "Fresnel 1823", "Brewster 1815", "Malus 1809"),
    honesty="The share is exact for each pixel's angle. Ripples, stones and evening are made up; the light of the ground is "
            "taken as unpolarised, and its loss on the way up through the water is left out.",
    values=(Value("theta", 70.0, low=15.0, high=87.5), Value("polariser", 45.0), Value("eta", 1.333, low=1.1, high=3.0, more=True)),
    minutes=7,
)

INSIDE = Step(
    name="inside",
    title="From inside: total reflection",
    idea="From the denser side nothing gets out beyond the critical angle: the boundary is a perfect mirror.",
    slides=(FRESNEL(2),),
    prose=r"""
Now the lamp is **inside** the glass and the air is above: $\eta = 1/1.5$. Rays bend *away* from the normal, and at the
**critical angle** the outgoing one lies flat:

$$\sin\theta_c = \eta$$

Beyond it there is no ray to go out. All light is $\colour{r}{\text{reflected}}$, not nearly all: $F = 1$ [exactly](code:f_dielectric). No metal
mirror does as well.

Drag the $\colour{l}{\text{ray}}$ from [straight up](?theta=0) to [just before](?theta=41) and
[just beyond](?theta=43). Then change the glass: from [diamond](?eta=0.4137) only rays within 24° get out. Light that gets
in through the top stays in until it finds that window. That is the sparkle.
""",
    scene=Scene(
        glsl="""
#include "optics/interface.glsl"
#include "display/palette.glsl"
uniform float theta;
uniform float eta;

const int RAYS = 35;
const float DEEP = 1.25; // of the lamp under the boundary

float ray_angle(float i) {
    return radians(64.0 * (2.0 * i / float(RAYS - 1) - 1.0));
}

// Three legs of a ray at an angle: up from the lamp, out, back down. t along, from 0 to 1.
vec3 leg(int part, float angle, float t) {
    vec3 top = vec3(DEEP * tan(angle), 0.0, 0.0);
    if (part == 0) return vec3(0.0, 0.0, -DEEP) + t * (top + vec3(0.0, 0.0, DEEP));
    float turned = sign(angle) * refracted_angle(abs(angle), eta);
    if (part == 1) return top + 1.15 * t * vec3(sin(turned), 0.0, cos(turned));
    return top + 0.8 * t * vec3(sin(angle), 0.0, -cos(angle));
}

float share(int part, float angle) {
    return part == 0 ? 1.0 : part == 1 ? transmitted_share(abs(angle), eta) : reflected_share(abs(angle), eta);
}

vec3 surface_point(int surface, vec2 s) {
    if (surface == 3) return vec3(-3.3 + 6.6 * s.x, 0.03, -1.5 * s.y);
    int column = int(s.x * float(2 * RAYS - 1) + 0.5);
    vec3 from = leg(surface, ray_angle(float(column / 2)), 0.0), to = leg(surface, ray_angle(float(column / 2)), 1.0);
    vec3 d = normalize(to - from);
    return mix(from, to, s.y) + vec3(d.z, 0.0, -d.x) * 0.014 * (float(column % 2) * 2.0 - 1.0);
}

vec3 shade(Surface s) {
    vec3 tint = mix(palette[COLOUR_QUIET], palette[COLOUR_N], 0.35);
    if (s.id == 3) return tint * (1.0 - 0.4 * s.st.y);
    int column = int(floor(s.st.x * float(2 * RAYS - 1)));
    if (column % 2 == 1) discard;
    vec3 full = s.id == 0 ? palette[COLOUR_L] : s.id == 1 ? palette[COLOUR_ESTIMATE] : palette[COLOUR_R];
    vec3 behind = s.id == 1 ? background : mix(background, tint, 0.3);
    float much = share(s.id, ray_angle(float(column / 2)));
    if (much < 0.002) discard;
    return mix(behind, full, s.id == 0 ? 0.55 : 0.06 + 0.94 * much);
}

vec3 mark_point(int mark, float t) {
    vec3 lift = vec3(0.0, -0.04, 0.0);
    if (mark == 1 && share(1, theta) <= 0.0) return vec3(0.0, 0.0, -99.0); // out of the picture: there is none
    if (mark < 3) return leg(mark, theta, t) + lift;
    if (mark == 3) return vec3(-3.3 + 6.6 * t, 0.0, 0.0) + lift;
    float top = DEEP * tan(min(theta, 1.2));
    if (mark == 4) return vec3(top, 0.0, -0.75 + 1.9 * t) + lift;
    return vec3(DEEP * tan(critical_angle(eta)) * (mark == 5 ? 1.0 : -1.0), 0.0, 0.32 * t - 0.16) + lift;
}

vec4 probe(int i) {
    if (i == 0) return vec4(leg(0, theta, 1.0), 1.0);
    if (i == 1) return vec4(-2.75, 0.0, 1.0, 1.0);
    if (i == 2) return vec4(-2.75, 0.0, -1.2, 1.0);
    return vec4(0.0, 0.0, -1.68, 1.0);
}
""",
        surfaces=(Surface("up", cells=(69, 1)), Surface("out", cells=(69, 1)), Surface("back", cells=(69, 1)),
                  Surface("glass", cells=(1, 1), opacity=0.3)),
        marks=(
            Mark("the ray", colour="l", width=1.8), Mark("out", colour="estimate", tip="arrow", width=1.8),
            Mark("back", colour="r", tip="arrow", width=1.8), Mark("boundary", colour="quiet", width=1.4),
            Mark("normal", colour="n", tip="arrow", label="n"),
            Mark("critical right", colour="exact", width=1.4, label="critical", label_at=1.0),
            Mark("critical left", colour="exact", width=1.4),
        ),
        labels=(Label("outside", 1), Label("inside", 2), Label("lamp", 3, "l")),
        handles=(Handle("the ray", 0, ("theta",)),),
        legend=(("l", "from the lamp"), ("estimate", "gets out"), ("r", "is sent back")),
        camera=Camera(azimuth=-90, elevation=4, distance=10.5, target=(0.0, 0.0, -0.2)),
    ),
    plot=Curves(
        title="Reflected from inside",
        sweep="theta",
        curves=(Curve("unpolarised", Term("reflected_share")), Curve("s, across", Term("reflected_share_s"), role="estimate"),
                Curve("p, along", Term("reflected_share_p"), role="printed"),
                Curve("glass, outside", Term("reflected_share", {"eta": 1.5}))),
        y_label="share reflected",
    ),
    readouts=(
        Readout("reflected R", Term("reflected_share"), role="exact", unit=""),
        Readout("gets out T", Term("transmitted_share"), role="exact", unit=""),
        Readout("diffuse light sent back", Term("f_average_dielectric"), unit=""),
    ),
    ask=Prediction(
        question="Light runs around evenly inside a diamond, index 2.4. What share of it does the boundary send back "
                 "inside?",
        truth=Term("f_average_dielectric", {"eta": 0.4137}),
        unit="of it",
        low=0.0,
        high=1.0,
        sets={"theta": 25.0, "eta": 0.4137},
        told="0.87; glass keeps 0.60. From outside diamond sends back 0.21: getting in is easy, getting out is not.",
    ),
    notes="""
Look up from under water: the whole sky in a round window, and around it the pool's floor. Let someone find the critical
angle by dragging; it is 41.8° for glass. The curve has a corner there, not a bend: ask what the slope is just before it
(infinite). Prediction: many say 10 or 20 per cent, because that comes back from outside. Fibres, cat's eyes and prisms
in binoculars live from this; paint and skin keep light the same way. 5 minutes.
""",
    sources=("Deck, slide Fresnel Term (2)", "Snell's law; Fresnel 1823", "Walsh 1926, d'Eon 2021: the mean over the hemisphere"),
    honesty="Exact. Only the first meeting with the boundary is drawn; the light sent back would meet the other walls.",
    values=(Value("theta", 30.0, low=0.0, high=64.0), Value("eta", 1 / 1.5, low=0.4, high=0.95)),
    minutes=5,
    beyond=True,
    breaks=(Break("Snell's root in total reflection", {"f_dielectric": "f_dielectric_naive"}, {"theta": 60.0, "eta": 0.667},
                  "Outside there is no angle any more, and the textbook form takes the root of a negative number. It is not a number, and neither is anything it touches. Ask before the root: total reflection is a case of its own, F = 1.",
                  "F at 60°", Term("f_dielectric", {"l_dot_h": 0.5})),),
)

# A row of the tables as a polished ball: a metal, or an insulator with a colour of its own under the clear surface
METAL_GLSL = """
#include "optics/materials.glsl"
#include "display/balls.glsl"
#include "display/studio.glsl"

vec3 lit_metal(int i, vec3 n, vec3 v) {
    return max(f_material(max(dot(n, v), 0.0), i), 0.0) * studio(reflect(-v, n));
}
"""
INSULATOR_GLSL = """
#include "optics/materials.glsl"
#include "display/balls.glsl"
#include "display/studio.glsl"
#include "display/look.glsl"

vec3 body(int i) {
    if (i == 0) return vec3(0.01, 0.05, 0.09);
    if (i == 1) return vec3(0.03, 0.30, 0.10);
    if (i == 2) return vec3(0.55, 0.05, 0.04);
    if (i == 3) return vec3(0.30, 0.005, 0.03);
    return vec3(0.10, 0.12, 0.15);
}

vec3 lit_insulator(int i, vec3 n, vec3 v) {
    float f = f_dielectric(max(dot(n, v), 0.0), material_eta(i));
    return f * studio(reflect(-v, n)) + (1.0 - f) * soft_light(body(i), n, v);
}
"""

MATERIALS = Step(
    name="materials",
    title="Rows of materials",
    idea="Insulators mirror little of the light, and white; metals more than half, and have their colour; all end at 1.",
    slides=(FRESNEL(4), FRESNEL(5)),
    prose=r"""
Ten materials, one law. **Insulators** have a real index $\eta$ and reflect little head-on, the same in all colours. What
you see in the middle of the red ball is light that went in and came out again.

**Metals** have a complex index $\eta + ik$. Light that enters is swallowed within a thousandth of a hair, so nothing comes
back from within: a metal has *no diffuse part*, and its mirror is its colour.

Both agree at the rim: there every material is a white mirror. Choose [water](?material=water), [diamond](?material=diamond),
[gold](?material=gold), [iron](?material=iron) and compare head-on with [the rim](?theta=85).
""",
    scene=Scene(
        glsl=METAL_GLSL + INSULATOR_GLSL + """
#include "stage/camera.glsl"
uniform int material;
uniform float theta;

vec3 ball_centre(int i) {
    return vec3(2.25 * float(i % 5 - 2), 0.0, i < INSULATORS ? -1.2 : 1.2);
}

vec3 surface_point(int surface, vec2 s) {
    return ball_point(s, 5, ball_centre(ball_number(s, 5) + surface * INSULATORS), 1.0);
}

vec3 shade(Surface s) {
    int i = ball_number(s.st, 5) + s.id * INSULATORS;
    vec3 n = ball_normal(s.position - ball_centre(i), s.v);
    return s.id == 0 ? lit_insulator(i, n, s.v) : lit_metal(i, n, s.v);
}

// The place of the chosen ball whose normal is theta from the eye's direction
vec3 place(float turn) {
    vec3 c = ball_centre(material), v = normalize(camera_position - c);
    vec3 side = normalize(cross(v, vec3(0.0, 0.0, 1.0))), up = cross(side, v);
    return c + 1.01 * (cos(theta) * v + sin(theta) * (cos(turn) * side + sin(turn) * up));
}

vec3 mark_point(int mark, float t) {
    if (mark == 0) return place(6.2831853 * t);
    vec3 c = ball_centre(material);
    return c + 1.07 * vec3(cos(6.2831853 * t), 0.0, sin(6.2831853 * t));
}

vec4 probe(int i) {
    if (i == 0) return vec4(place(0.8), 1.0);
    return vec4(ball_centre(i - 1) + vec3(0.0, 0.0, i > INSULATORS ? 1.32 : -1.32), 1.0);
}
""",
        surfaces=(Surface("insulators", cells=(164, 2)), Surface("metals", cells=(164, 2))),
        marks=(Mark("angle", colour="v", segments=64, width=1.3), Mark("chosen", colour="exact", line="dashed", segments=64)),
        labels=tuple(Label(name, i + 1) for i, name in enumerate(MATERIAL_NAMES)),
        handles=(Handle("the angle", 0, ("theta",)),),
        camera=Camera(azimuth=-90, elevation=3, distance=30, target=(0.0, 0.0, 0.0), field_of_view=22),
    ),
    plot=Curves(
        title="Exact, against the angle",
        sweep="theta",
        curves=(
            Curve("the chosen one", Term("material_share")),
            Curve("gold, red", Term("material_share", {"material": 5, "channel": 0}), role="printed", colour=GOLD),
            Curve("gold, blue", Term("material_share", {"material": 5, "channel": 2}), role="printed", colour=GOLD),
            Curve("iron, green", Term("material_share", {"material": 8, "channel": 1}), colour=IRON),
            Curve("glass", Term("material_share", {"material": 1, "channel": 1}), role="estimate", colour=GLASS),
        ),
        y_label="share reflected, one channel",
    ),
    readouts=(
        Readout("here, this channel", Term("material_share"), role="exact", unit=""),
        Readout("head-on", Term("material_share", {"theta": 0.0}), unit=""),
        Readout("its index η (1: a metal)", Term("material_eta"), unit=""),
    ),
    ask=Prediction(
        question="Diamond sparkles as no other stone. What share of the light does its surface reflect head-on?",
        truth=Term("material_share", {"theta": 0.0, "material": 4, "channel": 1}),
        unit="of it",
        low=0.0,
        high=1.0,
        sets={"material": 4, "theta": 0.0},
        told="0.172. Silver does 0.98; the best mirror among these insulators is a worse one than the dullest of the metals.",
    ),
    notes="""
Let the class sort the ten balls by what the middle reflects, before any number: the gap between 17 % and 51 % is the gap
between insulators and metals, and few materials live in it (semiconductors do). Then cover the middles with your hand and
look at the rims only: all alike. Ask where the red of the red ball comes from, and the red of copper: two different
physics. That is why one has a diffuse term and the other must not. 6 minutes.
""",
    sources=("Deck, slides Fresnel Term (4) and (5)", "Johnson & Christy 1972, 1974; Rakic 1995: n, k of metals",
             "CIE 015:2004: D65 and the 1931 observer"),
    honesty="The Fresnel term is exact from measured indices, over twelve wavelengths for metals and one for insulators. "
            "The room that is mirrored and the colour inside the insulators are made up.",
    values=(Value("material", 5, choices=MATERIAL_NAMES), Value("theta", 50.0), Value("channel", 1, choices=CHANNELS)),
    minutes=6,
    breaks=(Break("metals without their k", {"f_conductor": "f_conductor_naive"}, {"material": 9, "channel": 1, "theta": 0.0},
                  "With the real part of the index alone a metal is a strange glass. Aluminium's n lies near 1, so it turns dark; gold's and silver's are below 1, and mirror almost all beyond a few degrees. It is k, how fast light dies inside, that makes a metal bright. Half of a complex number is not an approximation.",
                  "aluminium, 550 nm, head-on", Term("f_conductor", {"l_dot_h": 1.0, "eta": 0.958, "k": 6.69})),),
)

METALS = Step(
    name="metals",
    title="The table of metals, checked",
    idea="A metal's share at normal incidence is its only colour; the printed table is close to the measured indices.",
    slides=(FRESNEL(6),),
    prose=r"""
The deck prints two numbers a metal and channel: $F(0°)$ in **linear** light, and the same for the screen, in **sRGB**. Light
is computed with the first; the second is only for looking.

The balls are made from [measured](code:f_conductor) $n$ and $k$. Under them, three plates: the linear column, the sRGB column, and the
colour computed from the measurements, at the ring's angle. Gold's red comes out at [1.03](?material=gold&channel=red): more than all the red there
is. That is no error: gold's yellow is purer than sRGB can show. The stripes mark it.

[Iron](?material=iron&channel=blue) is printed bluish; these data make it slightly warm. [Aluminium's](?material=aluminium&channel=blue)
two columns differ by a rounding.
""",
    scene=Scene(
        glsl=METAL_GLSL + """
#include "stage/camera.glsl"
uniform int material;
uniform float theta;

vec3 plate_centre(int i) {
    return vec3(2.25 * float(i - 2), 0.0, 0.0);
}

vec3 ball_centre(int i) {
    return plate_centre(i) + vec3(0.0, 0.0, 1.3);
}

vec3 surface_point(int surface, vec2 s) {
    if (surface == 0) return ball_point(s, 5, ball_centre(ball_number(s, 5)), 1.0);
    return vec3(-5.6 + 11.2 * s.x, 0.0, -1.7 * (float(surface) - s.y));
}

vec3 decoded(vec3 c) {
    return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c));
}

vec3 plate(int surface, int i) {
    if (surface == 1) return material_f0(i + INSULATORS);
    if (surface == 2) return decoded(material_srgb(i + INSULATORS));
    vec3 f = f_material(max(0.0, cos(theta)), i + INSULATORS);
    bool out_of_gamut = max(f.r, max(f.g, f.b)) > 1.0;
    if (out_of_gamut && mod(gl_FragCoord.x + gl_FragCoord.y, 14.0) < 2.0) return vec3(0.0);
    return f;
}

vec3 shade(Surface s) {
    if (s.id == 0) {
        int ball = ball_number(s.st, 5);
        return lit_metal(ball + INSULATORS, ball_normal(s.position - ball_centre(ball), s.v), s.v);
    }
    int i = clamp(int(floor((s.position.x + 5.625) / 2.25)), 0, 4);
    vec2 at = vec2(s.position.x - plate_centre(i).x, s.st.y - 0.5), wide = fwidth(vec2(s.position.x, s.st.y));
    vec2 inside = clamp((vec2(1.0, 0.44) - abs(at)) / wide + 0.5, 0.0, 1.0);
    return mix(vec3(0.03), plate(s.id, i), inside.x * inside.y); // on a dark card, so that silver shows on white
}

// The place of the chosen ball whose normal is theta from the eye's direction
vec3 place(float turn) {
    vec3 c = ball_centre(material - INSULATORS), v = normalize(camera_position - c);
    vec3 side = normalize(cross(v, vec3(0.0, 0.0, 1.0))), up = cross(side, v);
    return c + 1.01 * (cos(theta) * v + sin(theta) * (cos(turn) * side + sin(turn) * up));
}

vec3 mark_point(int mark, float t) {
    if (mark == 1) return place(2.0 * PI * t);
    vec3 c = plate_centre(material - INSULATORS);
    float side = t < 0.25 ? 4.0 * t : t < 0.5 ? 1.0 : t < 0.75 ? 3.0 - 4.0 * t : 0.0;
    float up = t < 0.25 ? 0.0 : t < 0.5 ? 4.0 * t - 1.0 : t < 0.75 ? 1.0 : 4.0 - 4.0 * t;
    return c + vec3(2.16 * side - 1.08, -0.02, -5.2 + 7.57 * up);
}

vec4 probe(int i) {
    if (i < 5) return vec4(plate_centre(i) + vec3(0.0, 0.0, 2.66), 1.0);
    if (i == 8) return vec4(place(0.8), 1.0);
    return vec4(-6.65, 0.0, i == 5 ? -0.85 : i == 6 ? -2.55 : -4.25, 1.0);
}
""",
        surfaces=(Surface("balls", cells=(164, 2)), Surface("linear, printed", cells=(1, 1)),
                  Surface("sRGB, printed", cells=(1, 1)), Surface("from n, k", cells=(1, 1))),
        marks=(Mark("chosen", colour="exact", line="dashed", segments=64),
               Mark("angle", colour="v", segments=64, width=1.3)),
        labels=(*(Label(name, i) for i, name in enumerate(METAL_NAMES)),
                Label("linear", 5, "printed"), Label("sRGB", 6, "printed"), Label("n, k", 7)),
        handles=(Handle("the angle", 8, ("theta",)),),
        camera=Camera(azimuth=-90, elevation=2, distance=34, target=(-0.7, 0.0, -1.2), field_of_view=21),
    ),
    plot=Curves(
        title="The chosen metal, red, green, blue",
        sweep="theta",
        curves=tuple(Curve(name, Term("material_share", {"channel": i}), colour=CHANNEL_COLOURS[i])
                     for i, name in enumerate(CHANNELS)),
        y_label="share reflected",
    ),
    readouts=(
        Readout("from n, k", Term("material_share", {"theta": 0.0}), role="exact", unit=""),
        Readout("linear, printed", Term("material_f0_printed"), role="printed", unit="", against="from n, k"),
        Readout("its sRGB", Term("material_srgb_of_printed"), unit=""),
        Readout("sRGB, printed", Term("material_srgb_printed"), role="number", unit=""),
    ),
    ask=Prediction(
        question="Gold reflects all of the red and 0.71 of the green. What share of the blue does it reflect head-on?",
        truth=Term("material_share", {"theta": 0.0, "material": 5, "channel": 2}),
        unit="of it",
        low=0.0,
        high=1.0,
        sets={"material": 5, "channel": 2, "theta": 0.0},
        told="0.37 from the measured indices; the table prints 0.29. Gold lacks blue, and has no other colour than that lack.",
    ),
    notes="""
Ask for gold's three numbers as a colour picker would have them; people give (255, 215, 0), with no blue at all. Then show
that the table is a share of light and no paint: no number may pass 1, and yet the red does, because sRGB's red, green and
blue cannot mix so pure a yellow. Let them find the entries whose sRGB is not the sRGB of the linear column: iron's blue
(0.78 printed, 0.786 computed) and aluminium's (0.97, 0.964). Each column was rounded by itself. 5 minutes.
""",
    sources=("Deck, slide Fresnel Term (6), from Physically Based Shading, SIGGRAPH course 2010", "Johnson & Christy 1972, "
             "1974; Rakic 1995", "IEC 61966-2-1: sRGB", "CIE 015:2004: D65 and the 1931 observer"),
    honesty="From n, k: thin films in vacuum, twelve wavelengths, daylight. Other films of the same metal differ by several "
            "hundredths. On the screen what lies beyond 1 is cut off; the stripes say where.",
    values=(Value("material", 7, low=5, choices=MATERIAL_NAMES), Value("channel", 0, choices=CHANNELS), Value("theta", 30.0)),
    minutes=5,
)

DIELECTRICS = Step(
    name="dielectrics",
    title="Insulators: a thin mirror over a body",
    idea="One number, the index, gives an insulator's mirror; what is not mirrored goes in and makes the body's colour.",
    slides=(FRESNEL(7),),
    prose=r"""
For an insulator $F_0$ and the index are one thing told twice:

$$F_0 = \left(\frac{\eta-1}{\eta+1}\right)^2, \qquad \eta = \frac{1+\sqrt{F_0}}{1-\sqrt{F_0}}$$

Water is 0.02, nearly everything else 0.03 to 0.05, stones up to 0.17. Most programs set 0.04 and are done. Check the
deck's table, row by row: [low glass](?material=glass), 0.03, is printed as 0.21 for the screen, and is 0.19.

The light not reflected goes in; some comes back as the **diffuse** body colour. So the body must be darker where the
mirror is brighter. On the large ball the left half does that, $\colour{exact}{(1-F)}$; the right half
$\colour{printed}{\text{adds them up}}$, and its rim gives more than it got. Try [water](?eta=1.333),
[diamond](?eta=2.4175), [no boundary](?eta=1).
""",
    scene=Scene(
        glsl=INSULATOR_GLSL + """
uniform float eta;
uniform int material;

const vec3 LARGE = vec3(0.0, 0.0, 1.75);
const float SIZE = 2.5;

vec3 small(int i) {
    return vec3(2.25 * float(i - 2), 0.0, -2.3);
}

vec3 surface_point(int surface, vec2 s) {
    if (surface == 0) return cap_to_eye(s, LARGE, SIZE);
    return ball_point(s, 5, small(ball_number(s, 5)), 1.0);
}

vec3 shade(Surface s) {
    if (s.id == 1) {
        int i = ball_number(s.st, 5);
        return lit_insulator(i, ball_normal(s.position - small(i), s.v), s.v);
    }
    vec3 n = ball_normal((s.position - LARGE) / SIZE, s.v), paint = vec3(0.26, 0.52, 0.90);
    float f = f_dielectric(max(dot(n, s.v), 0.0), eta);
    vec3 inside = soft_light(paint, n, s.v) * (s.position.x < 0.0 ? 1.0 - f : 1.0);
    return inside + f * studio(reflect(-s.v, n));
}

vec3 mark_point(int mark, float t) {
    if (mark == 1) return small(material) + 1.08 * vec3(cos(2.0 * PI * t), 0.0, sin(2.0 * PI * t));
    return LARGE + (SIZE + 0.02) * vec3(0.0, -sin(PI * t), cos(PI * t));
}

vec4 probe(int i) {
    if (i < 5) return vec4(small(i) + vec3(0.0, 0.0, -1.35), 1.0);
    if (i == 5) return vec4(-3.6, 0.0, 3.6, 1.0);
    if (i == 6) return vec4(3.6, 0.0, 3.6, 1.0);
    return vec4(LARGE + vec3(SIZE * (eta - 1.0) / 2.0, -0.4, -SIZE), 1.0);
}
""",
        surfaces=(Surface("large ball", cells=(64, 4)), Surface("balls", cells=(164, 2))),
        marks=(Mark("divide", colour="quiet", segments=48),
               Mark("chosen", colour="exact", line="dashed", segments=64)),
        labels=(*(Label(name, i) for i, name in enumerate(MATERIAL_NAMES[:5])),
                Label("(1 − F) body", 5), Label("body + F", 6, "printed")),
        handles=(Handle("the index", 7, ("eta",)),),
        camera=Camera(azimuth=-90, elevation=3, distance=32, target=(0.0, 0.0, 0.3), field_of_view=20),
    ),
    plot=Curves(
        title="The index and its mirror",
        sweep="eta",
        curves=(Curve("head-on, F0", Term("f0_from_eta")),
                Curve("diffuse light", Term("f_average_dielectric"), role="estimate"),
                Curve("diffuse light, by Schlick", Term("f_average_schlick_eta"), role="printed")),
        y_label="share reflected",
    ),
    readouts=(
        Readout("head-on F0", Term("f0_from_eta"), role="exact", unit=""),
        Readout("the table's F0", Term("material_f0_printed", {"channel": 0}), role="printed", unit=""),
        Readout("its sRGB", Term("material_srgb_of_printed", {"channel": 0}), role="exact", unit=""),
        Readout("sRGB, printed", Term("material_srgb_printed", {"channel": 0}), role="printed", unit="", against="its sRGB"),
    ),
    ask=Prediction(
        question="A stone reflects 17 % head-on: the table's diamond. What is its index?",
        truth=Term("eta_from_f0", {"f0": 0.17}),
        unit="",
        low=1.0,
        high=4.0,
        sets={"eta": 2.4},
        told="2.40; measured is 2.4175. Two decimals of F0 give two digits of the index.",
    ),
    notes="""
Write both formulas, then let them guess the index of diamond: 17 % feels small, and the index is huge. Slide η to 1: the
mirror goes and the paint stays, a chalk ball. Then to 3 and look at the two rims. The right half is what most shaders of
the last century did, and it is the white furnace's first victim; a full cure also counts the way out (chapter 8). Four
entries of the tables' sRGB columns are not the sRGB of the linear ones: 0.21 for 0.190 is the largest. 5 minutes.
""",
    sources=("Deck, slide Fresnel Term (7)", "Fresnel 1823", "Malitson 1965, Malitson & Dodge 1972, Sultanova 2009, "
             "Phillip & Taft 1964: indices", "Walsh 1926: the mean over the hemisphere"),
    honesty="F0 and the mean are exact for a clear, smooth boundary. (1 − F) once is a first step: light also meets the "
            "boundary on its way out. The small balls use measured indices, not the printed shares.",
    values=(Value("eta", 1.5, low=1.0, high=3.0), Value("material", 0, high=4, choices=MATERIAL_NAMES)),
    minutes=5,
)

SCHLICK = Step(
    name="schlick",
    title="Schlick's fit, and where it fails",
    idea="One power of (1 - l·h) replaces the Fresnel equations to within 0.08, but not for iron and aluminium.",
    slides=(FRESNEL(8),),
    prose=r"""
Schlick keeps the start and the end and joins them by a [fifth power](code:f_schlick):

$$\colour{printed}{F} = c_0 + (1-c_0)(1 - l\cdot h)^5$$

Good for glass, plastics, silver, gold. But [iron](?material=iron) and [aluminium](?material=aluminium) *dip* before they rise, and the
fit does not. One more number mends it: $F$ at 82°, the $\colour{estimate}{\text{F82}}$ [form](code:f_f82). The rows show the error of
both; the scale ends at 0.2.

Mind the angle. It is $l\cdot h$, the facet's, and **not** $n\cdot v$. Below, a rough plastic ball with its lamp
$2\theta$ away from the eye, both ways. With $n\cdot v$ the rim glows even with [the lamp behind you](?theta=5).
""",
    scene=Scene(
        glsl="""
#include "optics/materials.glsl"
#include "display/balls.glsl"
#include "display/studio.glsl"
#include "display/palette.glsl"
uniform int material;
uniform float theta;

const float SIZE = 1.95;
// f_material of each metal at l_dot_h = 1 and 1/7: what Schlick's fit and F82's start from
const vec3 F0[5] = vec3[5](
    vec3(1.034603, 0.7279725, 0.3653369),
    vec3(0.9893262, 0.9839215, 0.9778442),
    vec3(0.9287197, 0.6231506, 0.5223334),
    vec3(0.5296919, 0.5132438, 0.4942676),
    vec3(0.9072824, 0.9158066, 0.9223137));
const vec3 F82[5] = vec3[5](
    vec3(0.9903208, 0.8574775, 0.6465084),
    vec3(0.9875533, 0.9859803, 0.9870678),
    vec3(0.9460601, 0.7552153, 0.7023742),
    vec3(0.5716098, 0.5666232, 0.5837063),
    vec3(0.8301127, 0.8621128, 0.8937931));

vec3 place(int i) {
    return vec3(2.3 * float(i % 5 - 2), 0.0, 4.4 - 2.85 * float(i / 5));
}

vec3 rough(int surface) {
    return vec3(surface == 3 ? -3.0 : 3.0, 0.0, -6.1);
}

vec3 surface_point(int surface, vec2 s) {
    if (surface < 3) return ball_point(s, 5, place(ball_number(s, 5) + 5 * surface), 1.0);
    return cap_to_eye(s, rough(surface), SIZE);
}

vec3 shade(Surface s) {
    if (s.id < 3) {
        int i = ball_number(s.st, 5);
        vec3 n = ball_normal(s.position - place(i + 5 * s.id), s.v);
        float c = max(dot(n, s.v), 0.0);
        vec3 f = f_material(c, i + INSULATORS), f0 = F0[i], off = vec3(0.0);
        if (s.id == 0) return max(f, 0.0) * studio(reflect(-s.v, n));
        for (int k = 0; k < 3; k++) off[k] = abs((s.id == 1 ? f_schlick(c, f0[k]) : f_f82(c, f0[k], F82[i][k])) - f[k]);
        return colormap(max(off.r, max(off.g, off.b)) / 0.2);
    }
    vec3 n = ball_normal((s.position - rough(s.id)) / SIZE, s.v), v = s.v;
    vec3 side = normalize(cross(vec3(0.0, 0.0, 1.0), v)), l = cos(2.0 * theta) * v - sin(2.0 * theta) * side;
    vec3 sum = l + v, h = sum / max(length(sum), 1e-6);
    float n_dot_l = max(dot(n, l), 0.0), n_dot_v = max(dot(n, v), 0.0);
    float f = f_dielectric(s.id == 3 ? max(dot(l, h), 0.0) : n_dot_v, 1.5), on_h = max(dot(n, h), 0.0);
    return vec3(0.12, 0.012, 0.02) * (0.15 + n_dot_l) + f * (3.5 * on_h) * smoothstep(0.0, 0.06, n_dot_l);
}

vec3 mark_point(int mark, float t) {
    return place(material - INSULATORS + 5 * mark) + 1.1 * vec3(cos(2.0 * PI * t), 0.0, sin(2.0 * PI * t));
}

vec4 probe(int i) {
    if (i < 3) return vec4(0.0, 0.0, 5.72 - 2.85 * float(i), 1.0);
    if (i < 5) return vec4(rough(i) + vec3(0.0, 0.0, SIZE + 0.3), 1.0);
    if (i > 5) return vec4(place(i + 4) + vec3(i == 10 ? 0.45 : i == 9 ? -0.2 : 0.0, 0.0, -1.4), 1.0); // room for long names
    return vec4(rough(3) + (SIZE + 0.3) * vec3(-sin(2.0 * theta), -cos(2.0 * theta), 0.0), 1.0);
}
""",
        surfaces=(*(Surface(name, cells=(164, 2)) for name in ("exact", "Schlick's error", "F82's error")),
                  Surface("with l.h", cells=(48, 3)), Surface("with n.v", cells=(48, 3))),
        marks=(*(Mark(f"chosen {i}", colour="exact", line="dashed", segments=48) for i in range(3)),),
        labels=(Label("exact", 0), Label("Schlick's error", 1, "printed"), Label("F82's error", 2, "estimate"),
                Label("F(l·h)", 3), Label("F(n·v)", 4, "printed"),
                *(Label(name, i + 6) for i, name in enumerate(METAL_NAMES))),
        handles=(Handle("the lamp", 5, ("theta",)),),
        camera=Camera(azimuth=-90, elevation=2, distance=40, target=(0.0, 0.0, -1.3), field_of_view=22),
    ),
    plot=Curves(
        title="Exact, Schlick, F82",
        sweep="theta",
        curves=(Curve("exact", Term("material_share")),
                Curve("F82", Term("material_share_f82"), role="estimate"),
                Curve("Schlick", Term("material_share_schlick"), role="printed")),
        y_label="share reflected, one channel",
    ),
    readouts=(
        Readout("exact", Term("material_share"), role="exact", unit=""),
        Readout("Schlick", Term("material_share_schlick"), role="printed", unit="", against="exact"),
        Readout("F82", Term("material_share_f82"), role="estimate", unit="", against="exact"),
        Readout("Schlick at worst", Term("schlick_worst"), unit=""),
    ),
    ask=Prediction(
        question="Iron reflects about half. By how much is Schlick's share off, at the worst angle?",
        truth=Term("schlick_worst", {"material": 8}),
        unit="of the light",
        low=0.0,
        high=0.4,
        sets={"material": 8, "theta": 83.0},
        told="0.18, near 83°. For silver it is 0.007. The dip before the rise is what the fifth power cannot do.",
    ),
    notes="""
Draw the curve of iron by hand first: flat, dip, up; then Schlick over it. It is a fit to insulators, and it was never meant
for iron. Show the two rough balls with the lamp behind the class (θ small): light and eye agree, every facet that
shows anything is seen head-on, l·h = 1, so nothing may be brighter at the rim. With n·v it is. This mistake has shipped
in more than one game. What F82 costs: one number more a material, and a sixth power. 6 minutes.
""",
    sources=("Deck, slide Fresnel Term (8)", "Schlick 1994", "Hoffman 2019: Fresnel Equations Considered Harmful",
             "Kutz et al. 2021: the F82 tint", "Johnson & Christy 1972, 1974; Rakic 1995"),
    honesty="Errors are against the exact term of measured indices, the largest of the three channels. The rough balls "
            "use a plain glow by n·h, no BRDF: those come with chapters 4 and 5.",
    values=(Value("material", 5, low=5, choices=MATERIAL_NAMES), Value("theta", 18.0, low=0.0, high=90.0),
            Value("channel", 1, choices=CHANNELS)),
    minutes=6,
)

PYTHON_STUB = '''import numpy as np


def f_schlick(l_dot_h, f0):
    """The share reflected. l_dot_h, f0: (...), from 0 to 1."""
    return np.zeros(np.broadcast_shapes(np.shape(l_dot_h), np.shape(f0)))
'''
PYTHON_SOLUTION = '''import numpy as np


def f_schlick(l_dot_h, f0):
    """Schlick 1994."""
    x = np.maximum(0.0, 1 - l_dot_h)
    return f0 + (1 - f0) * x**5
'''
GLSL_STUB = """float f_schlick(float l_dot_h, float f0) {
    return 0.0;
}
"""
GLSL_SOLUTION = """float f_schlick(float l_dot_h, float f0) {
    float x = max(0.0, 1.0 - l_dot_h), x2 = x * x; // pow(x, 5.0) is slower and loses digits
    return f0 + (1.0 - f0) * x2 * x2 * x;
}
"""

CHAPTER = Chapter(
    title="Fresnel",
    idea="Every boundary mirrors a share of the light that depends on its index and on the angle at the facet.",
    steps=(FLAT_MIRROR, ANGLE, INSIDE, MATERIALS, METALS, DIELECTRICS, SCHLICK),
    exercises=(
        Exercise(
            name="schlick",
            function="f_schlick",
            task="Write Schlick's fit of the Fresnel term. It is evaluated for every pixel and lamp: use products.",
            slide=FRESNEL(8),
            stubs={"python": PYTHON_STUB, "glsl": GLSL_STUB},
            solutions={"python": PYTHON_SOLUTION, "glsl": GLSL_SOLUTION},
            checks=(
                Check({"l_dot_h": (1.0, 1.0, 1.0), "f0": (0.02, 0.04, 0.95)}, "head-on it is f0"),
                Check({"l_dot_h": (0.0, 0.0), "f0": (0.04, 0.56)}, "at grazing it is 1"),
                Check({"l_dot_h": (0.1, 0.25, 0.5, 0.75), "f0": (0.04, 0.17, 0.56, 0.91)}, "in between"),
                Check({"l_dot_h": (0.0001, 0.003, 0.142857, 0.97), "f0": (0.02, 0.08, 0.95, 0.29)},
                      "close to both ends", hidden=True),
            ),
        ),
    ),
    terms={
        "Fresnel term": "the share of light that a flat boundary reflects, by index and angle",
        "index of refraction": "how much slower light is in a medium; of a metal it is complex",
        "Brewster's angle": "where light polarised along the plane of incidence is not reflected: tan θ = η",
        "critical angle": "beyond it light inside a denser medium is reflected wholly: sin θ = η",
        "polarisation": "the direction in which light swings: s across, p along the plane of incidence",
        "F0": "the share reflected head-on",
        "F82": "the share reflected at 82°, a second number for a better fit",
    },
)
