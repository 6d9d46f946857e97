"""Facets stand in each other's way: some are not seen, some get no light. The geometry term counts those that are left.

Without it a rough surface sends back more light than it gets, and its rim glows. This chapter looks into one groove,
swaps the light and the eye, takes the smaller of two shares, and asks what a geometry term must never do.
"""

from app.lesson import (
    Break,
    Camera,
    Chapter,
    Check,
    Choice,
    Curve,
    Curves,
    Exercise,
    Handle,
    Label,
    Lobes,
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
GEOMETRIC = "Cook – Torrance – Geometric Term ({})".format
TERMS = ("none", "V-groove", "Smith", "Smith correlated")

EYE_GLSL = """
#include "stage/camera.glsl"
uniform float theta_v;

vec3 eye() { return normalize(camera_position); }
vec3 up() { return normalize(vec3(0.0, 0.0, 1.0) - eye().z * eye()); }
vec3 aside() { return cross(up(), eye()); }
"""
# A ball seen from far away. Its picked point is theta_v from the eye's direction, upwards; the light stands over that
# point as theta_l and phi say, and is as far away.
BALL_GLSL = EYE_GLSL + """
#include "display/balls.glsl"
uniform float theta_l, phi;

vec3 picked() { return cos(theta_v) * eye() + sin(theta_v) * up(); }

vec3 lamp() {
    vec3 along = sin(theta_v) * eye() - cos(theta_v) * up();
    return cos(theta_l) * picked() + sin(theta_l) * (cos(phi) * along - sin(phi) * aside());
}
vec4 surface_value(int surface, vec2 s) { return vec4(lamp(), 0.0); }
"""
GOLD_GLSL = """
#include "optics/fresnel.glsl"
#include "display/palette.glsl"
uniform float m;
const vec3 GOLD = vec3(1.0, 0.71, 0.29); // deck, Fresnel Term (6)

vec3 mirrored(vec3 s) {
    return vec3(f_schlick(0.5 * length(s), GOLD.r), f_schlick(0.5 * length(s), GOLD.g), f_schlick(0.5 * length(s), GOLD.b));
}

vec3 film(vec3 radiance) { return 1.0 - exp(-radiance); } // bright light turns white slowly
"""

WHY = Step(
    name="why",
    title="Take G away, and the rim glows",
    idea="Facets hide each other; a model that forgets it sends back more light than it gets, most of all at the rim.",
    slides=(GEOMETRIC(1),),
    prose=r"""
A ball of tiny perfect mirrors hangs in an even sky. Whatever a mirror shows, it shows sky: so no place of the ball may be
**brighter than the sky** behind it. The left half obeys. In the right half one factor is missing:

$$f_s = \frac{\colour{d}{D}\,\colour{g}{G}\,\colour{f}{F}}{4\,(\colour{n}{n}\cdot\colour{l}{l})(\colour{n}{n}\cdot\colour{v}{v})}$$

At the rim you see the surface edge-on, $n \cdot v$ goes to 0, and the formula divides by it. Only $\colour{g}{G}$ stands
against that: near the rim most facets are **hidden** behind others, or lie in their **shadow**.

Drag the $\colour{v}{\text{ring}}$ [to the middle](?theta_v=20) and [to the rim](?theta_v=85). Make the ball
[rougher](?m=1), [smoother](?m=0.2).
""",
    scene=Scene(
        glsl=EYE_GLSL + """
#include "optics/geometry_choice.glsl"
#include "display/rings.glsl"
uniform float m;
const float SIZE = 1.6, WIDER = 1.0125; // 1 / cos(pi / 20): the edges of twenty columns stay outside of the ball

vec3 around(float turn) { return cos(turn) * up() + sin(turn) * aside(); }
float ring(vec2 s) { return radians(89.5) * s.y * (2.0 - s.y); }

vec3 surface_point(int surface, vec2 s) {
    if (surface == 2) return 4.5 * (2.0 * s.x - 1.0) * aside() + 3.5 * (2.0 * s.y - 1.0) * up() - eye();
    return WIDER * SIZE * sin(ring(s)) * around(PI * (surface == 0 ? -s.x : s.x)); // a disk before the eye
}

vec4 surface_value(int surface, vec2 s) { // times the cosine, as a function of which it is smooth at the rim
    return cos(ring(s)) * vec4(albedo_geometry(ring(s), m, surface == 0 ? 1 : 0), 1.0, 0.0, 0.0);
}

vec3 shade(Surface s) {
    vec3 sky = vec3(0.20, 0.27, 0.36);
    if (s.id == 2) return sky;
    float r2 = dot(s.position, s.position) / (SIZE * SIZE), c = sqrt(max(1.0 - r2, 7.6e-5)); // at least cos 89.5 degrees
    float light = max(round_value(s.value.x, s.value.y, c) / c, 0.0);
    if (r2 > 1.0) return sky;
    return light < 1.005 ? sky * light : mix(sky, vec3(1.0, 0.55, 0.16), min(0.25 + 0.75 * (light - 1.0), 1.0)) * min(light, 2.0);
}

vec3 mark_point(int mark, float t) {
    if (mark == 0) return SIZE * sin(theta_v) * around(2.0 * PI * t) + 0.3 * eye();
    if (mark == 1) return SIZE * (2.0 * t - 1.0) * up() + 0.25 * eye();
    return SIZE * around(2.0 * PI * t) + 0.2 * eye();
}

vec4 probe(int i) {
    if (i == 0) return vec4(SIZE * sin(theta_v) * around(0.9) + 0.3 * eye(), 1.0);
    return vec4((i == 1 ? -1.25 : 1.25) * aside() - 1.9 * up(), 1.0);
}
""",
        surfaces=(Surface("with G", cells=(10, 18)), Surface("without G", cells=(10, 18)), Surface("sky", cells=(1, 1))),
        marks=(Mark("ring", colour="v", segments=72, width=1.2, label="θ", label_at=0.12),
               Mark("divide", colour="quiet", line="dotted"), Mark("outline", colour="quiet", segments=72)),
        labels=(Label("with G", 1), Label("without G", 2)),
        handles=(Handle("the ring", 0, ("theta_v",)),),
        legend=(("v", "seen at the angle θ"), ("printed", "brighter than the sky")),
        camera=Camera(azimuth=-90, elevation=0, distance=40, target=(0.0, 0.0, -0.1), field_of_view=6.6),
    ),
    plot=Curves(
        title="Light out over light in, F = 1",
        sweep="theta_v",
        curves=(Curve("with G", Term("albedo_geometry", {"geometry": 1})),
                Curve("without G", Term("albedo_geometry", {"geometry": 0}), role="printed")),
        y_label="share that comes back",
    ),
    readouts=(
        Readout("comes back, with G", Term("albedo_geometry", {"geometry": 1}), role="exact", unit=""),
        Readout("without G", Term("albedo_geometry", {"geometry": 0}), role="printed", unit="",
                against="comes back, with G"),
    ),
    ask=Prediction(
        question="Facets of slope 0.5, all perfect mirrors, seen at 85° in an even sky. Without G, how many times the light "
                 "that came in goes out?",
        truth=Term("albedo_geometry", {"theta_v": 85 * PI / 180, "m": 0.5, "geometry": 0}),
        unit="times",
        low=0.0,
        high=5.0,
        sets={"theta_v": 85.0, "m": 0.5},
        told="2.15 times. With G it is 0.98: the model may lose light, it must not make any.",
    ),
    notes="""
Cover the rim with your hand: both halves are darker than the sky, the left a little more so. Nothing looks wrong. Uncover it. Ask what is divided by, and let someone walk
the ring outwards while the class reads the second number aloud; the moment it passes 1 is the point. Common wrong answer:
1, because mirrors cannot make light. Mirrors cannot; the formula can, because it counts facets that nobody sees. Why are both
darker than the sky in the middle? Facets steeper than 45° throw light down, and with G some is blocked: it would bounce on,
the model drops it. The 4 is the consistent form
of the printed π (chapter 5). 5 minutes.
""",
    sources=("Deck, slide Geometric Term (1)", "Torrance & Sparrow 1967", "Cook & Torrance 1982"),
    honesty="Shares are exact to 1e-6 for Beckmann facets that mirror everything, with 1/4 for the printed 1/π. What is "
            "blocked, or thrown down into the surface, is dropped here, not passed on to the next facet.",
    values=(Value("theta_v", 78.0, low=0.0, high=85.0), Value("m", 0.8, low=0.1, high=1.0)),
    minutes=5,
)

# Three V-grooves side by side, cut open: the ridges at z = 0, the middle one's valley at x = 0, both sides equally steep.
# The side whose normal leans to the right is the facet in question.
GROOVE_GLSL = """
#include "optics/groove.glsl"
#include "display/look.glsl"
uniform float facet;

float wide() { return 2.0 * cos(facet); }

vec3 relief(float x, float y) {
    float u = fract(x / wide() + 0.5);
    return vec3(x, y, -sin(facet) * (1.0 - abs(2.0 * u - 1.0)));
}

// From the valley (0) to the ridge (1) on the sides in question, below 0 on the others
float height_on_facet(vec3 p) {
    return fract(p.x / wide() + 0.5) < 0.5 ? 1.0 + p.z / sin(facet) : -1.0;
}

vec3 stone(vec3 n, vec3 v) {
    return soft_light(mix(palette[COLOUR_QUIET], palette[COLOUR_N], 0.4), n, v);
}

// What is kept from the eye or the light: its colour in stripes
vec3 hatched(vec3 colour, vec3 ground, vec2 at) {
    return mix(ground, colour, 0.55 * step(0.62, fract(7.0 * (at.x + at.y))));
}
"""

MASKING = Step(
    name="masking",
    title="What the eye sees of a facet",
    idea="A facet is seen only down to the line of sight over the opposite ridge: a share 2 (n·h)(n·v) / (v·h) of it.",
    slides=(GEOMETRIC(2),),
    prose=r"""
One **V-groove**, cut open. Its left side is a facet with the normal $\colour{h}{h}$, which would mirror light to the eye.
But the opposite side [stands in between](code:g_masking): what lies below the line of sight over its ridge is **masked**. The strip before
the $\colour{v}{\text{eye}}$ is all that arrives.

$$\colour{v}{G_\text{intercept}} = \frac{2\,(n\cdot h)(n\cdot v)}{v\cdot h}$$

Check it by counting: every ray starts on the facet; $\colour{lost}{\text{grey}}$ ones run into the wall. Drag the
$\colour{v}{\text{eye}}$ [low](?lean_v=80) and [high](?lean_v=20), the ridge [steep](?facet=65) or [flat](?facet=25).

From high up the formula says $\colour{printed}{\text{more than 1}}$. No facet shows more than itself: take
$\min(1, G_\text{intercept})$.
""",
    scene=Scene(
        glsl=GROOVE_GLSL + """
uniform float lean_v;
uniform int samples;

const float FAR = 2.1; // from the middle of the groove to the strip before the eye
const int RAYS = 48;

vec3 way() { return vec3(sin(lean_v), 0.0, cos(lean_v)); }

vec3 start(int ray) { return groove_point(facet, (float(ray) + 0.5) / float(samples)); }

// Where the ray ends: on the strip before the eye, or on the opposite side
vec3 end(int ray) {
    vec3 p = start(ray), valley = groove_point(facet, 0.0), other = vec3(-sin(facet), 0.0, cos(facet));
    if (cos(facet - lean_v) <= 0.0) return p;
    bool stopped = groove_blocked(facet, (float(ray) + 0.5) / float(samples), lean_v) > 0.5;
    return p + way() * (stopped ? -dot(p - valley, other) / min(dot(way(), other), -1e-4) : FAR - dot(p, way()));
}

vec3 surface_point(int surface, vec2 s) {
    vec3 p = relief(1.5 * wide() * (2.0 * s.x - 1.0), 1.6 * s.y - 0.4);
    if (surface == 0) return p;
    if (surface == 1) return vec3(p.x, -0.4, mix(-1.35, p.z, s.y));
    if (surface == 2) {
        int column = int(s.x * float(2 * RAYS - 1) + 0.5), ray = min(column / 2, samples - 1);
        vec3 d = end(ray) - start(ray), across = length(d) > 1e-4 ? vec3(d.z, 0.0, -d.x) / length(d) : vec3(0.0);
        return start(ray) + s.y * d + across * 0.011 * (float(column % 2) * 2.0 - 1.0) + vec3(0.0, -0.41, 0.0);
    }
    vec3 q = groove_point(facet, s.x), d = way();
    return q + (FAR - dot(q, d)) * d + vec3(0.0, 1.6 * s.y - 0.4, 0.0);
}

vec3 shade(Surface s) {
    float t = s.id == 3 ? s.st.x : height_on_facet(s.position), hidden = groove_hidden(facet, lean_v);
    vec3 v = palette[COLOUR_V];
    if (s.id == 0) {
        vec3 ground = stone(s.normal, s.v);
        if (t < 0.0) return ground;
        return t < hidden ? hatched(palette[COLOUR_LOST], 0.5 * ground, s.position.yz) : mix(ground, v, 0.75);
    }
    if (s.id == 1) return mix(background, palette[COLOUR_QUIET], 0.35 + 0.25 * s.st.y);
    if (s.id == 2) {
        int column = int(floor(s.st.x * float(2 * RAYS - 1))), ray = column / 2;
        if (column % 2 == 1 || ray >= samples) discard;
        return groove_blocked(facet, (float(ray) + 0.5) / float(samples), lean_v) > 0.5 ? palette[COLOUR_LOST] : v;
    }
    if (cos(facet - lean_v) <= 0.0 || t < hidden) return mix(background, palette[COLOUR_LOST], 0.25);
    return v;
}

vec3 watch(float beyond) { // the eye, beyond the far edge of the strip
    vec3 q = groove_point(facet, 0.5);
    return q + (FAR + beyond - dot(q, way())) * way() + vec3(0.0, 1.2, 0.0);
}

vec3 mark_point(int mark, float t) {
    vec3 lift = vec3(0.0, -0.43, 0.0), middle = groove_point(facet, 0.5), ridge = groove_point(-facet, 1.0);
    if (mark == 0) return groove_point(facet, 1.0) + vec3(0.0, 0.0, 0.75 * t) + lift;
    if (mark == 1) return middle + 0.8 * t * vec3(sin(facet), 0.0, cos(facet)) + lift;
    if (mark == 2) return watch(0.55 * t);
    float open = clamp(groove_hidden(facet, lean_v), 0.0, 1.0);
    vec3 foot = groove_point(facet, open), over = cos(facet + lean_v) < 0.0 ? ridge : foot;
    return mix(foot, over + way() * (FAR - dot(over, way())), t) + 1.2 * lift;
}

vec4 probe(int i) {
    vec3 lift = vec3(0.0, -0.43, 0.0);
    if (i == 0) return vec4(watch(0.55), 1.0);
    return vec4(groove_point(-facet, 1.0) + lift, 1.0);
}
""",
        surfaces=(Surface("grooves", cells=(6, 1)), Surface("cut", cells=(6, 1)), Surface("rays", cells=(95, 1)),
                  Surface("before the eye", cells=(1, 1))),
        marks=(Mark("normal", colour="n", tip="arrow", label="n"),
               Mark("facet's normal", colour="h", line="dashed", tip="arrow", label="h"),
               Mark("to the eye", colour="v", tip="eye", label="v"),
               Mark("line of sight", colour="exact", line="dotted")),
        handles=(Handle("the eye", 0, ("lean_v",)), Handle("the ridge", 1, ("facet",))),
        legend=(("v", "seen"), ("lost", "masked")),
        camera=Camera(azimuth=-66, elevation=17, distance=14, target=(0.5, 0.2, 0.3), field_of_view=23),
    ),
    plot=Curves(
        title="Share of the facet that is seen",
        sweep="lean_v",
        curves=(Curve("min(1, G)", Term("groove_masking")),
                Curve("counted", Term("groove_open_counted", {"lean_l": "lean_v"}), role="estimate"),
                Curve("as printed", Term("groove_intercept_printed"), role="printed")),
        y_label="share",
    ),
    readouts=(
        Readout("seen, min(1, G)", Term("groove_masking"), role="exact", unit=""),
        Readout("counted", Term("groove_open_counted", {"lean_l": "lean_v"}), role="estimate", unit="",
                against="seen, min(1, G)"),
        Readout("G as printed", Term("groove_intercept_printed"), role="printed", unit="", against="seen, min(1, G)"),
    ),
    ask=Prediction(
        question="The sides of the groove stand at 45°, you look along a line 75° from the normal. What share of the facing "
                 "side do you see?",
        truth=Term("groove_masking", {"facet": PI / 4, "lean_v": 75 * PI / 180}),
        unit="of it",
        low=0.0,
        high=1.0,
        sets={"facet": 45.0, "lean_v": 75.0},
        told="0.42. The line of sight over the ridge meets the facet a bit above its middle.",
    ),
    notes="""
Let them count rays before the formula appears: green ones over all. Then one line on the board: the hidden share is
-(h'·v)/(h·v), h' being the other side's normal, and h + h' = 2 (n·h) n; so what is left is 2 (n·h)(n·v)/(v·h).
Ask what G is from straight above: 2. Is that a bug? The formula measures where the line of sight meets the facet's own
plane; beyond the valley there is no facet. Common wrong answer to the question: a sixth, as 15° are left of 90°. 6 minutes.
""",
    sources=("Deck, slide Geometric Term (2)", "Torrance & Sparrow 1967", "Blinn 1977"),
    honesty="Exact for endless symmetric grooves and a far eye in the plane across them; the formula also holds for other "
            "eyes. Counting with N rays is off by at most 1/N.",
    values=(Value("lean_v", 62.0, low=0.0, high=88.0), Value("facet", 48.0, low=15.0, high=72.0),
            Value("samples", 24, low=4, high=48, scale="linear")),
    minutes=6,
)

SHADOWING = Step(
    name="shadowing",
    title="Swap the light and the eye",
    idea="Shadowing is masking with the light in the eye's place: the same formula, with n·l for n·v.",
    slides=(GEOMETRIC(3),),
    prose=r"""
A ploughed field in low sun. In front it is as the $\colour{l}{\text{light}}$ finds it: below the ray over the ridge lies
**shadow**. At the back the same furrows as the $\colour{v}{\text{eye}}$ finds them: below its line of sight they are
masked. Put both [in the same place](?lean_l=62&lean_v=62): the two edges become one line.

So nothing new has to be derived. [Swap the roles](code:groove_shadowing):

$$\colour{l}{G_\text{shadow}} = \frac{2\,(n\cdot h)(n\cdot l)}{l\cdot h}, \qquad l\cdot h = v\cdot h$$

Both hidden parts begin in the valley. So they **overlap**, and the larger one decides. [Swap](?lean_l=40&lean_v=75) and
[swap back](?lean_l=75&lean_v=40), and look at the share that is lit *and* seen.
""",
    scene=Scene(
        glsl=GROOVE_GLSL + """
uniform float lean_l;
uniform float lean_v;

const float FAR = 2.0;

vec3 way(float lean) { return vec3(sin(lean), 0.0, cos(lean)); }

vec3 surface_point(int surface, vec2 s) {
    vec3 p = relief(2.5 * wide() * (2.0 * s.x - 1.0), 3.0 * s.y - 1.5);
    if (surface == 0) return p;
    return vec3(p.x, -1.5, mix(-1.35, p.z, s.y));
}

vec3 shade(Surface s) {
    if (s.id == 1) return mix(background, palette[COLOUR_QUIET], 0.25 + 0.3 * s.st.y);
    bool sun = s.position.y < 0.0;
    float t = height_on_facet(s.position), lean = sun ? lean_l : lean_v, own = t < 0.0 ? -facet : facet;
    float reached = cos(own - lean), hidden = groove_hidden(own, lean);
    vec3 ground = stone(s.normal, s.v), colour = palette[sun ? COLOUR_L : COLOUR_V];
    bool blocked = hidden >= 1.0 || 1.0 + s.position.z / sin(facet) < hidden;
    if (blocked) return hatched(palette[COLOUR_LOST], 0.45 * ground, s.position.yz);
    return mix(ground, colour, t < 0.0 ? 0.25 + 0.3 * reached : 0.45 + 0.45 * reached);
}

vec3 edge(float lean) { return groove_point(facet, clamp(groove_hidden(facet, lean), 0.0, 1.0)) + vec3(0.0, 0.0, 0.012); }

vec3 over(float lean, float y, float t) {
    vec3 foot = edge(lean) + vec3(0.0, y, 0.0), d = way(lean);
    return foot + t * d * (FAR - dot(foot, d));
}

vec3 mark_point(int mark, float t) {
    vec3 side = vec3(0.0, mark == 1 ? -0.75 : 0.75, 0.0);
    if (mark == 0) return vec3(-cos(facet), -1.5, 0.75 * t);
    if (mark < 3) return side + way(mark == 1 ? lean_l : lean_v) * FAR * (1.0 + 0.3 * t);
    if (mark == 3) return edge(lean_l) + vec3(0.0, -1.5 + 1.5 * t, 0.0);
    if (mark == 4) return edge(lean_v) + vec3(0.0, 1.5 * t, 0.0);
    if (mark < 8) return over(lean_l, -0.15 - 0.6 * float(mark - 5), t);
    return over(lean_v, 0.15 + 0.6 * float(mark - 8), t);
}

vec4 probe(int i) {
    if (i == 2) return vec4(cos(facet), -1.5, 0.0, 1.0);
    return vec4(way(i == 0 ? lean_l : lean_v) * FAR * 1.3 + vec3(0.0, i == 0 ? -0.75 : 0.75, 0.0), 1.0);
}
""",
        surfaces=(Surface("field", cells=(10, 2)), Surface("cut", cells=(10, 1))),
        marks=(Mark("normal", colour="n", tip="arrow", label="n"),
               Mark("to the light", colour="l", tip="sun", label="l", width=1.4),
               Mark("to the eye", colour="v", tip="eye", label="v", width=1.4),
               Mark("edge of the shadow", colour="exact", width=1.6), Mark("edge of the mask", colour="exact", width=1.6),
               *(Mark(f"ray {i}", colour="l") for i in range(3)),
               *(Mark(f"line of sight {i}", colour="v", line="dotted") for i in range(3))),
        handles=(Handle("the light", 0, ("lean_l",)), Handle("the eye", 1, ("lean_v",)), Handle("the ridge", 2, ("facet",))),
        legend=(("l", "reached by the light"), ("v", "seen by the eye"), ("lost", "kept from it")),
        camera=Camera(azimuth=-52, elevation=27, distance=16, target=(0.1, 0.0, 0.1), field_of_view=26),
    ),
    plot=Curves(
        title="Share of the facet, against the light",
        sweep="lean_l",
        curves=(Curve("lit", Term("groove_shadowing"), role="printed"),
                Curve("lit and seen", Term("groove_open")),
                Curve("light and eye swapped", Term("groove_open", {"lean_l": "lean_v", "lean_v": "lean_l"}),
                      role="estimate")),
        y_label="share",
    ),
    readouts=(
        Readout("lit, G shadow", Term("groove_shadowing"), unit=""),
        Readout("seen, G intercept", Term("groove_masking"), unit=""),
        Readout("lit and seen", Term("groove_open"), role="exact", unit=""),
        Readout("1000 rays counted", Term("groove_open_counted", {"samples": 1000}), role="estimate", unit="",
                against="lit and seen"),
    ),
    ask=Prediction(
        question="The sun stands 75° from the normal, you at 30°; sides of 45°. Of each facing side 0.42 is lit and seen. "
                 "Now you and the sun change places. How much is it?",
        truth=Term("groove_open", {"facet": PI / 4, "lean_l": 30 * PI / 180, "lean_v": 75 * PI / 180}),
        unit="",
        choices=(Choice("less: I look flat over the furrows", 0.0, 0.4), Choice("0.42 again", 0.42, 0.43),
                 Choice("all of it: a high sun throws no shadow", 0.9, 1.0)),
        sets={"facet": 45.0, "lean_l": 30.0, "lean_v": 75.0},
        told="0.42 again. What the sun did not reach before, the eye does not reach now: light takes the same way in both "
             "directions. That is reciprocity.",
    ),
    notes="""
Do it with two people and a corrugated card: one is the lamp, one the eye, then they change places. Then the screen: both at
62° and the seam vanishes; that is the whole derivation of G_shadow. Ask what happens to the part that is shadowed and
masked: it is lost once, not twice, which is why the next slide takes a minimum and no product. Common wrong answer: all of
it, because there are no shadows any more; but now the eye looks low, and masking costs the same. 5 minutes.
""",
    sources=("Deck, slide Geometric Term (3)", "Torrance & Sparrow 1967", "Blinn 1977", "Helmholtz 1856: reciprocity"),
    honesty="Exact in the plane across endless grooves, light and eye far away and on the same side. The colours say where "
            "light and sight reach, not how bright it is. Light that was blocked once is not followed further.",
    values=(Value("lean_l", 75.0, low=0.0, high=88.0), Value("lean_v", 58.0, low=0.0, high=88.0),
            Value("facet", 45.0, low=15.0, high=72.0)),
    minutes=5,
)

COMBINED = Step(
    name="combined",
    title="The least of three",
    idea="G is the least of 1, masking and shadowing; where another of the three becomes the least, G has a crease.",
    slides=(GEOMETRIC(3), "Combined G"),
    prose=r"""
Masked and shadowed parts of a facet overlap, so only [the larger counts](code:g_vgroove):

$$G = \min\left\{1,\ \colour{v}{\frac{2(n\cdot h)(n\cdot v)}{v\cdot h}},\ \colour{l}{\frac{2(n\cdot h)(n\cdot l)}{v\cdot h}}\right\}$$

The left ball is a map: which of the three is it? Round the rim $\colour{v}{\text{masking}}$, along the edge of the day
$\colour{l}{\text{shadowing}}$, and in between a broad band where **nothing** is blocked. The right ball shows $G$ itself.
It has no jumps, but it has **creases**.

Drag the $\colour{l}{\text{light}}$ [near the eye](?theta_l=55&phi=0), [to the side](?theta_l=60&phi=90) and
[far behind the ball](?theta_l=80&phi=180). With the light
[in the eye](?theta_l=74&phi=0), masking and shadowing are the same everywhere.
""",
    scene=Scene(
        glsl=BALL_GLSL + """
#include "optics/vgroove.glsl"
#include "display/palette.glsl"

const float SIZE = 1.5;

vec3 centre(int ball) {
    return ball == 0 ? -1.35 * aside() - 1.0 * up() : 1.4 * aside() + 1.15 * up();
}

vec3 surface_point(int surface, vec2 s) {
    if (surface < 2) return cap_to_eye(s, centre(surface), SIZE);
    return (1.6 + 0.2 * s.x) * aside() + (2.1 * s.y - 2.75) * up();
}

const float ALIKE = 2e-5; // masking and shadowing that are nearer are the same, all over: light and eye agree

// The next of the three terms less the least, over a pixel: below 1 on a crease
float off_crease(vec4 c) {
    float low = 2.0 * c.x * min(c.y, c.z) / c.w, apart = 2.0 * c.x * abs(c.y - c.z) / c.w, wide = fwidth(apart);
    float one = abs(low - 1.0) / max(fwidth(low), 1e-6), two = wide > ALIKE ? apart / wide : 9.0;
    return low < 1.0 ? min(one, two) : one;
}

vec3 shade(Surface s) {
    if (s.id == 2) return colormap(s.st.y);
    vec3 n = ball_normal((s.position - centre(s.id)) / SIZE, s.v), v = eye(), l = s.value.xyz, both = l + v;
    float size = length(both);
    vec4 c = vec4(dot(n, both) / size, dot(n, v), dot(n, l), 0.5 * size);
    float branch = g_branch(c.x, c.y, c.z, c.w), line = smoothstep(0.6, 1.8, off_crease(c));
    if (c.z <= 0.0 || c.y <= 0.0) return mix(background, palette[COLOUR_QUIET], 0.16 + 0.12 * max(dot(n, s.v), 0.0));
    if (s.id == 1) return mix(palette[COLOUR_EXACT], colormap(g_vgroove(c.x, c.y, c.z, c.w)), line);
    bool masked = branch < 1.5, stripe = mod(gl_FragCoord.x + gl_FragCoord.y, 16.0) < 8.0;
    if (abs(c.y - c.z) < ALIKE) masked = stripe;
    vec3 colour = branch < 0.5 ? mix(palette[COLOUR_QUIET], vec3(1.0), 0.25) : palette[masked ? COLOUR_V : COLOUR_L];
    return mix(palette[COLOUR_EXACT], colour * (0.55 + 0.45 * c.y), line);
}

vec3 mark_point(int mark, float t) {
    int ball = mark < 2 ? 0 : 1;
    vec3 p = centre(ball) + 1.01 * SIZE * picked();
    if (mark == 0) return p + 0.8 * t * picked();
    if (mark == 1) return p + 0.8 * t * lamp();
    float turn = 2.0 * PI * t;
    return p + 0.01 * eye() + 0.09 * (cos(turn) * aside() + sin(turn) * cross(picked(), aside()));
}

vec4 probe(int i) {
    if (i == 0) return vec4(centre(0) + 1.01 * SIZE * picked(), 1.0);
    if (i == 1) return vec4(centre(0) + 1.01 * SIZE * picked() + 0.8 * lamp(), 1.0);
    if (i == 2) return vec4(centre(0) - 1.8 * up(), 1.0);
    if (i == 3) return vec4(centre(1) + 1.55 * (aside() - 0.9 * up()), 1.0);
    return vec4(2.05 * aside() + (i == 4 ? -2.75 : -0.65) * up(), 1.0);
}
""",
        surfaces=(Surface("map", cells=(64, 3)), Surface("G", cells=(64, 3)), Surface("scale", cells=(1, 16))),
        marks=(Mark("normal", colour="n", tip="arrow", label="n"), Mark("to the light", colour="l", tip="sun", label="l"),
               Mark("the same place", colour="exact", segments=24, width=1.2)),
        labels=(Label("which is the least", 2), Label("G", 3), Label("0", 4), Label("1", 5)),
        handles=(Handle("the place", 0, ("theta_v",)), Handle("the light", 1, ("theta_l", "phi"))),
        legend=(("quiet", "1: nothing blocks"), ("v", "masking"), ("l", "shadowing")),
        camera=Camera(azimuth=-90, elevation=8, distance=40, target=(0.0, 0.0, -0.05), field_of_view=9),
    ),
    plot=Curves(
        title="At the picked place, against the light's angle",
        sweep="theta_l",
        curves=(Curve("masking", Term("masking_at"), role="estimate"),
                Curve("shadowing", Term("shadowing_at"), role="printed"),
                Curve("G, the least", Term("vgroove_at"))),
        y_label="share of the facets",
    ),
    readouts=(
        Readout("masking", Term("masking_at"), unit=""),
        Readout("shadowing", Term("shadowing_at"), unit=""),
        Readout("G", Term("vgroove_at"), role="exact", unit=""),
        Readout("gap to the next", Term("crease_gap"), unit=""),
    ),
    ask=Prediction(
        question="A light right behind your eye: you see no shadow. At 75° from the middle of the ball, what share of the facets "
                 "towards h is lit and seen?",
        truth=Term("vgroove_at", {"theta_l": 75 * PI / 180, "theta_v": 75 * PI / 180, "phi": 0.0}),
        unit="of them",
        low=0.0,
        high=1.0,
        sets={"theta_l": 75.0, "theta_v": 75.0, "phi": 0.0},
        told="0.13: 2 cos² 75°, as h is l. No shadow is seen, but the ridges hide what they shade. Up to 45° nothing is lost; "
             "there 2 cos² θ is 1, and a crease runs round the ball.",
    ),
    notes="""
Ask first what shape the regions have, then show the map. Move the light slowly from the eye to the far side: the coloured
bands grow inwards. A place that is never blocked is one whose h leans little. Let them find the place where all three are
equal; there is a corner. Why does it matter? Real surfaces have no such lines: they come from grooves all of one kind,
endless and symmetric. Seen on a smooth metal they never show, as there D is 0. Some will blame the
mesh: zoom in, the line stays. Common wrong answer to the question: 1, as there are no shadows. 6 minutes.
""",
    sources=("Deck, slides Geometric Term (3) and Combined G", "Torrance & Sparrow 1967", "Blinn 1977"),
    honesty="The map and G are exact for each pixel, for a far eye and a far light. The creases are exact too: a property "
            "of the V-groove model, not of surfaces.",
    values=(Value("theta_v", 74.0, low=0.0, high=88.0), Value("theta_l", 32.0, low=0.0, high=88.0),
            Value("phi", 130.0, low=0.0, high=180.0)),
    minutes=6,
)

WITH_WITHOUT = Step(
    name="with_without",
    title="With and without G at grazing light",
    idea="The product D·G·F is what one sees; without G every grazing view is too bright, and the rougher the more.",
    slides=("Without G", "With G"),
    prose=r"""
Three factors, three pictures below: $\colour{d}{D}$ says [how many facets](code:d_beckmann) mirror towards you, $\colour{f}{F}$ [how
much they mirror](code:f_schlick), and $\colour{g}{G}$ [how many are left](code:geometry_term) when the blocked ones are gone. Above, their product over $4 (n\cdot l)(n\cdot v)$
for gold, lit from behind: left **with** G, right **without**.

The light comes in low, so $n\cdot l$ is small all along the edge of the day, and $n\cdot v$ along the rim. Without G the
edge is cut as with a knife, and the rim burns out.

How much too bright? In even light at 85° a surface of [m = 0.3](?m=0.3&theta_v=85) sends back 1.53 times what it gets,
[m = 0.5](?m=0.5&theta_v=85) 2.15 times. And with [m = 1](?m=1&theta_v=85)?
""",
    scene=Scene(
        glsl=BALL_GLSL + GOLD_GLSL + """
#include "optics/cook_torrance.glsl"
#include "optics/vgroove.glsl"
const float SIZE = 1.55;
const float SMALL = 0.62;

vec3 centre(int ball) {
    return ball == 0 ? 0.75 * up() : 1.65 * float(ball - 2) * aside() - 2.45 * up();
}

vec3 surface_point(int surface, vec2 s) {
    if (surface < 4) return cap_to_eye(s, centre(surface), surface == 0 ? SIZE : SMALL);
    return -2.0 * eye() + 2.75 * (2.0 * s.x - 1.0) * aside() + (0.9 + 1.97 * (2.0 * s.y - 1.0)) * up();
}

vec3 shade(Surface s) {
    if (s.id == 4) return vec3(0.010, 0.013, 0.02) * (0.4 + 1.6 * s.st.y);
    vec3 n = ball_normal((s.position - centre(s.id)) / (s.id == 0 ? SIZE : SMALL), s.v), l = s.value.xyz, v = s.v, both = l + v;
    float n_dot_l = dot(n, l), n_dot_v = dot(n, v), size = length(both);
    vec3 dark = vec3(0.035, 0.03, 0.025) * (0.5 + 0.5 * max(n_dot_v, 0.0));
    if (min(n_dot_l, n_dot_v) <= 0.0) return dark;
    if (s.id == 1) return mix(dark, palette[COLOUR_D], film(vec3(3.0 * d_beckmann(n, both, m) * m * m)));
    if (s.id == 2) return mix(dark, palette[COLOUR_G], g_vgroove(dot(n, both) / size, n_dot_v, n_dot_l, 0.5 * size));
    if (s.id == 3) return mirrored(both);
    bool right = dot(s.position, aside()) > 0.0;
    float dg = right ? d_beckmann(n, both, m) / (4.0 * n_dot_l * n_dot_v) : cook_torrance_dg(n, l, v, m);
    return film(dark + 1.9 * dg * n_dot_l * mirrored(both));
}

vec3 mark_point(int mark, float t) {
    vec3 p = centre(0) + 1.01 * SIZE * picked();
    if (mark == 0) return p + 0.7 * t * picked();
    if (mark == 1) return p + 0.7 * t * lamp();
    return centre(0) + 1.02 * SIZE * (cos(PI * (t - 0.5)) * eye() + sin(PI * (t - 0.5)) * up());
}

vec4 probe(int i) {
    if (i == 0) return vec4(centre(0) + 1.01 * SIZE * picked(), 1.0);
    if (i == 1) return vec4(centre(0) + 1.01 * SIZE * picked() + 0.7 * lamp(), 1.0);
    if (i < 5) return vec4(centre(i - 1) - 0.88 * up(), 1.0);
    return vec4(centre(0) + (i == 5 ? -1.0 : 1.0) * 1.4 * aside() - 2.1 * up(), 1.0);
}
""",
        surfaces=(Surface("gold", cells=(64, 3)), Surface("D", cells=(40, 3)), Surface("G", cells=(40, 3)),
                  Surface("F", cells=(40, 3)), Surface("dark room", cells=(1, 1))),
        marks=(Mark("normal", colour="n", tip="arrow", label="n"), Mark("to the light", colour="l", tip="sun", label="l"),
               Mark("divide", colour="quiet", line="dotted", segments=32)),
        labels=(Label("D", 2, "d"), Label("G", 3, "g"), Label("F", 4, "f"), Label("with G", 5),
                Label("without G", 6, "printed")),
        handles=(Handle("the place", 0, ("theta_v",)), Handle("the light", 1, ("theta_l", "phi"))),
        camera=Camera(azimuth=-90, elevation=8, distance=40, target=(0.0, 0.0, -0.2), field_of_view=10.2),
    ),
    plot=(
        Curves(
            title="Light out over light in, F = 1",
            sweep="m",
            curves=(Curve("with G", Term("albedo_geometry", {"geometry": 1})),
                    Curve("without G", Term("albedo_geometry", {"geometry": 0}), role="printed")),
            y_label="share that comes back",
        ),
        Lobes("The lobe of this light"),
    ),
    readouts=(
        Readout("G for this light", Term("vgroove_at"), unit=""),
        Readout("even light, with G", Term("albedo_geometry", {"geometry": 1}), role="exact", unit=""),
        Readout("even light, without G", Term("albedo_geometry", {"geometry": 0}), role="printed", unit="",
                against="even light, with G"),
    ),
    models=(Model("with G", Term("brdf_geometry", {"f0": 1.0, "geometry": 1}), "exact"),
            Model("without G", Term("brdf_geometry", {"f0": 1.0, "geometry": 0}), "printed")),
    ask=Prediction(
        question="Facets with slopes near 1, all perfect mirrors, at 85°. How many times the light that came in goes out "
                 "without G?",
        truth=Term("albedo_geometry", {"theta_v": 85 * PI / 180, "m": 1.0, "geometry": 0}),
        unit="times",
        low=0.0,
        high=6.0,
        sets={"theta_v": 85.0, "m": 1.0},
        told="3.73 times. G keeps 0.97 of the light. A smooth surface hardly needs G; a rough one is nothing without it.",
    ),
    notes="""
Start with m = 0.1: the halves are the same ball. Slide m up and stop where the first student sees the seam. Then ask
which of the three small balls is to blame, and why F cannot help (it only grows towards the rim). Point at the knife edge
on the right: there n·l goes to 0 and cancels, so light switches on at full strength. Two badges: without G the energy one
is red, and a click takes you to its worst angle; reciprocity is green, as both cosines are below. 6 minutes.
""",
    sources=("Deck, slides Without G and With G", "Cook & Torrance 1982", "Torrance & Sparrow 1967"),
    honesty="The product is exact per pixel with Beckmann's D and Schlick's F for the deck's gold (1, 0.71, 0.29); the film "
            "turns strong light white, D is scaled to be seen, a little light of the room is added.",
    values=(Value("m", 0.6, low=0.1, high=1.0), Value("theta_v", 78.0, low=0.0, high=88.0),
            Value("theta_l", 26.0, low=0.0, high=88.0), Value("phi", 180.0, low=0.0, high=180.0, more=True),
            Value("lobe_scale", 2, choices=("f", "f n·l", "log f"), more=True)),
    minutes=6,
)

SMITH = Step(
    name="smith",
    title="Smith's G, and a test without loopholes",
    idea="What the facets show to the eye must add up to just the area of the plate; V-grooves and Smith's G pass.",
    slides=(GEOMETRIC(3),),
    prose=r"""
Grooves are one way to arrange facets. **Smith** throws them at random: then each facet has the same chance to be seen,
whichever way it faces, and no creases are left.

$$G_1 = \frac{1}{1 + \Lambda(v)}, \qquad G = \frac{1}{1 + \Lambda(v) + \Lambda(l)}$$

This $G$ [knows](code:g_smith_correlated) that a facet that lies **high** is both seen and lit. The [older product](code:g_smith_separable) $G_1(v)\,G_1(l)$ does not, and takes
too much.

The test: look at the plate. What its facets show you must fill it, no more, no less. The bars add up
$\int D\,G_1 \max(0, v\cdot h)\,d\omega_h$ over $n\cdot v$. Without $G$ they show [too much](?theta_v=85&m=1); every good
$G_1$ gives **1**, [rough](?m=1) or [smooth](?m=0.2).
""",
    scene=Scene(
        glsl=BALL_GLSL + GOLD_GLSL + """
#include "optics/geometry_choice.glsl"
const float SIZE = 1.1;
const float ONE = 1.2; // height of the bars at 1

vec3 centre(int ball) {
    return (ball % 2 == 0 ? -2.2 : 1.2) * aside() + (ball < 2 ? 1.55 : -1.6) * up();
}

vec3 surface_point(int surface, vec2 s) {
    if (surface < 4) return cap_to_eye(s, centre(surface), SIZE);
    if (surface == 8) { // a square behind each ball: its edges are columns 1 and 2 of its four, the others join them
        int column = int(15.0 * s.x + 0.5), k = column % 4;
        vec2 corner = vec2(k < 2 ? -1.0 : 1.0, k == 0 || k == 3 ? 1.0 : 2.0 * s.y - 1.0);
        return -1.2 * eye() + (centre(column / 4) + 1.2 * (corner.x * aside() + corner.y * up())) / 0.976; // seen as large
    }
    int bar = surface - 4;
    float tall = min(weak_furnace(theta_v, m, bar), 1.7);
    return centre(bar) + (1.45 + 0.45 * s.x) * aside() + (ONE * tall * s.y - SIZE) * up();
}

vec3 shade(Surface s) {
    if (s.id == 8) return vec3(0.014, 0.018, 0.028);
    if (s.id > 3) {
        float above = (dot(s.position - centre(s.id - 4), up()) + SIZE) / ONE;
        bool stripe = mod(gl_FragCoord.x + gl_FragCoord.y, 10.0) < 4.0;
        return above <= 1.001 ? palette[COLOUR_V] : stripe ? palette[COLOUR_PRINTED] : 0.4 * palette[COLOUR_PRINTED];
    }
    vec3 n = ball_normal((s.position - centre(s.id)) / SIZE, s.v), l = s.value.xyz, v = s.v, both = l + v;
    vec3 dark = vec3(0.035, 0.03, 0.025) * (0.5 + 0.5 * max(dot(n, v), 0.0));
    return film(dark + 2.2 * brdf_geometry(n, l, v, m, 1.0, s.id) * max(dot(n, l), 0.0) * mirrored(both));
}

vec3 mark_point(int mark, float t) {
    vec3 p = centre(1) + 1.01 * SIZE * picked();
    if (mark == 0) return p + 0.6 * t * picked();
    if (mark == 1) return p + 0.6 * t * lamp();
    return centre(mark - 2) + (1.3 + 0.75 * t) * aside() + (ONE - SIZE) * up() + 0.1 * eye();
}

vec4 probe(int i) {
    if (i == 0) return vec4(centre(1) + 1.01 * SIZE * picked(), 1.0);
    if (i == 1) return vec4(centre(1) + 1.01 * SIZE * picked() + 0.6 * lamp(), 1.0);
    if (i < 6) return vec4(centre(i - 2) - 1.4 * up(), 1.0);
    return vec4(centre(1) + 2.2 * aside() + (ONE - SIZE) * up(), 1.0);
}
""",
        surfaces=(*(Surface(name, cells=(64, 3)) for name in TERMS), *(Surface(f"{name}, sum", cells=(1, 1)) for name in TERMS),
                  Surface("dark room", cells=(15, 1))),
        marks=(Mark("normal", colour="n", tip="arrow", label="n"), Mark("to the light", colour="l", tip="sun", label="l"),
               *(Mark(f"one {i}", colour="exact", line="dashed") for i in range(4))),
        labels=(Label("none", 2, "printed"), Label("V-groove", 3), Label("product", 4), Label("heights", 5),
                Label("1", 6)),
        handles=(Handle("the place", 0, ("theta_v",)), Handle("the light", 1, ("theta_l", "phi"))),
        legend=(("v", "what the facets show"), ("printed", "more than there is")),
        camera=Camera(azimuth=-90, elevation=8, distance=50, target=(0.0, 0.0, -0.05), field_of_view=8.4),
    ),
    plot=(
        Curves(
            title="G at the picked place, against the light's angle",
            sweep="theta_l",
            curves=(Curve("V-groove", Term("geometry_at", {"geometry": 1})),
                    Curve("heights", Term("geometry_at", {"geometry": 3}), role="estimate"),
                    Curve("product", Term("geometry_at", {"geometry": 2}), role="printed")),
            y_label="share of the facets",
        ),
        Curves(
            title="What facets of one tilt show, over their share",
            sweep="theta_h",
            curves=(Curve("V-groove", Term("furnace_ring", {"geometry": 1})),
                    Curve("Smith", Term("furnace_ring", {"geometry": 3}), role="estimate"),
                    Curve("none", Term("furnace_ring", {"geometry": 0}), role="printed")),
            y_label="seen / share",
        ),
        Lobes("Three lobes of one surface"),
    ),
    readouts=(
        Readout("none", Term("weak_furnace", {"geometry": 0}), role="printed", unit="", against="Smith"),
        Readout("V-groove", Term("weak_furnace", {"geometry": 1}), unit=""),
        Readout("Smith", Term("weak_furnace", {"geometry": 3}), role="exact", unit=""),
        Readout("quick fit", Term("weak_furnace_rational"), role="estimate", unit="", against="Smith"),
    ),
    models=(Model("V-groove", Term("brdf_geometry", {"f0": 1.0, "geometry": 1}), "exact"),
            Model("product", Term("brdf_geometry", {"f0": 1.0, "geometry": 2}), "printed"),
            Model("heights", Term("brdf_geometry", {"f0": 1.0, "geometry": 3}), "estimate")),
    ask=Prediction(
        question="The product passes the test too, with mirrors for facets. At 85° and m = 1 in even light, how much of the light "
                 "does it send back?",
        truth=Term("albedo_geometry", {"theta_v": 85 * PI / 180, "m": 1.0, "geometry": 2}),
        unit="of it",
        choices=(Choice("all: it passed, and mirrors absorb nothing", 0.999, 1.001),
                 Choice("nine tenths", 0.85, 0.95),
                 Choice("half: what is seen may still be in shadow", 0.4, 0.6)),
        sets={"theta_v": 85.0, "m": 1.0},
        told="0.906. The test counts what you see, not whether it is lit: light that is blocked is dropped. Heights keep 0.959, "
             "V-grooves 0.969. Putting the rest back takes a second bounce.",
    ),
    notes="""
Ask what a plate full of holes may show you: as much as its outline, never more, as there is no way to see past it.
That is the whole test. The second plot shows how they pass: V-grooves tilt by tilt, Smith only in the sum, as it hides
each facet alike. Passing is not keeping all light: what is blocked still gets lost, so the usual wrong answer to the
question is all. Some will say that Smith is softer, so it must be less exact. It is what most programs use today. 7 minutes.
""",
    sources=("Smith 1967", "Walter et al. 2007: the quick fit", "Heitz 2014: heights, and the weak white furnace",
             "Deck, slide Geometric Term (3)"),
    honesty="Sums to 1e-6. Smith's terms are exact for heights that have nothing to do with their neighbours; real surfaces "
            "lie between. Beckmann's D, mirrors of gold, light that is blocked is dropped.",
    values=(Value("m", 0.8, low=0.1, high=1.0), Value("theta_v", 78.0, low=0.0, high=88.0),
            Value("theta_l", 30.0, low=0.0, high=88.0), Value("theta_h", 40.0, low=0.0, high=70.0, more=True),
            Value("phi", 180.0, low=0.0, high=180.0, more=True)),
    minutes=7, breaks=(Break("Smith's a upside down", {"lambda_beckmann_slope": "lambda_beckmann_slope_naive"}, {"m": 0.3, "theta_v": 40.0, "theta_l": 20.0, "phi": 3.0}, "a is 1 / (m tan θ). Upside down, Smith's G takes all light where eye or lamp look straight at the surface, where nothing can be in the way: two dark spots, and a picture that might still pass for some material. The bars do not: facets cannot show less than the plate. Test limits and sums before looks.", "Λ at m tan θ = 1/2", Term("lambda_beckmann_slope", {"slope": 0.5})),), beyond=True,
)

GROOVE_PYTHON = """import numpy as np

def g_vgroove(n_dot_h, n_dot_v, n_dot_l, l_dot_h):
    # The share of a facet that is lit and seen. All cosines: (...), from 0 to 1.
    return np.zeros(np.broadcast_shapes(*map(np.shape, (n_dot_h, n_dot_v, n_dot_l, l_dot_h))))
"""
GROOVE_PYTHON_SOLVED = """import numpy as np

def g_vgroove(n_dot_h, n_dot_v, n_dot_l, l_dot_h):
    return np.minimum(1.0, 2 * n_dot_h * np.minimum(n_dot_v, n_dot_l) / l_dot_h)
"""
GROOVE_GLSL_HEAD = "float g_vgroove(float n_dot_h, float n_dot_v, float n_dot_l, float l_dot_h) {\n"
GROOVE_GLSL_STUB = GROOVE_GLSL_HEAD + "    return 0.0;\n}\n"
GROOVE_GLSL_SOLVED = GROOVE_GLSL_HEAD + "    return min(1.0, 2.0 * n_dot_h * min(n_dot_v, n_dot_l) / l_dot_h);\n}\n"
SMITH_PYTHON = """import numpy as np

def lambda_ggx_slope(slope):
    # Hidden over seen; slope = alpha tan(theta): (...), from 0 up.
    return np.zeros(np.shape(slope))
"""
SMITH_PYTHON_SOLVED = """import numpy as np

def lambda_ggx_slope(slope):
    square = np.asarray(slope, float) ** 2
    return square / (2 * (1 + np.sqrt(1 + square)))
"""
SMITH_GLSL_STUB = "float lambda_ggx_slope(float slope) {\n    return 0.0;\n}\n"
SMITH_GLSL_SOLVED = """float lambda_ggx_slope(float slope) {
    float square = slope * slope;
    return square / (2.0 * (1.0 + sqrt(1.0 + square))); // sqrt(1 + square) - 1 loses its digits where slope is small
}
"""

CHAPTER = Chapter(
    title="The geometry term",
    idea="Facets hide each other from the eye and from the light; G is the share that is left.",
    steps=(WHY, MASKING, SHADOWING, COMBINED, WITH_WITHOUT, SMITH),
    exercises=(
        Exercise(
            name="vgroove",
            function="g_vgroove",
            task="Write the geometry term of V-grooves: the least of 1, masking and shadowing. One division is enough.",
            slide=GEOMETRIC(3),
            stubs={"python": GROOVE_PYTHON, "glsl": GROOVE_GLSL_STUB},
            solutions={"python": GROOVE_PYTHON_SOLVED, "glsl": GROOVE_GLSL_SOLVED},
            checks=(
                Check({"n_dot_h": (1.0, 0.95), "n_dot_v": (0.9, 0.8), "n_dot_l": (0.9, 0.7), "l_dot_h": (0.9, 0.8)},
                      "high up nothing is blocked"),
                Check({"n_dot_h": (0.8, 0.6), "n_dot_v": (0.1, 0.2), "n_dot_l": (0.7, 0.5), "l_dot_h": (0.5, 0.6)},
                      "a low eye: masking"),
                Check({"n_dot_h": (0.8, 0.6), "n_dot_v": (0.7, 0.5), "n_dot_l": (0.1, 0.2), "l_dot_h": (0.5, 0.6)},
                      "a low light: shadowing"),
                Check({"n_dot_h": (0.3, 0.71, 0.9), "n_dot_v": (0.02, 0.3, 0.003), "n_dot_l": (0.4, 0.3, 0.002),
                       "l_dot_h": (0.7, 0.9, 0.01)}, "grazing, and both alike", hidden=True),
            ),
        ),
        Exercise(
            name="smith_ggx",
            function="lambda_ggx_slope",
            task="Write Smith's Lambda of GGX, (sqrt(1 + slope²) - 1) / 2, so that it keeps its digits for small slopes.",
            slide=GEOMETRIC(3),
            stubs={"python": SMITH_PYTHON, "glsl": SMITH_GLSL_STUB},
            solutions={"python": SMITH_PYTHON_SOLVED, "glsl": SMITH_GLSL_SOLVED},
            checks=(
                Check({"slope": (0.5, 1.0, 3.0)}, "slopes near 1"),
                Check({"slope": (20.0, 1000.0)}, "grazing: about half the slope"),
                Check({"slope": (0.05, 0.01, 0.001)}, "smooth: a quarter of the square, to all digits"),
                Check({"slope": (0.0, 0.0001, 0.2, 7.0)}, "nothing, and in between", hidden=True),
            ),
        ),
    ),
    terms={
        "geometry term": "the share of the facets towards h that is both lit and seen",
        "masking": "what is hidden from the eye by other facets",
        "shadowing": "what the light does not reach because other facets stand before it",
        "V-groove": "two facets that lean to each other; Torrance and Sparrow's surface is made of them",
        "Smith's G": "masking and shadowing of facets at random heights; Lambda is hidden over seen",
        "weak white furnace": "the test that the facets one sees fill just the area of the plate",
        "reciprocity": "light takes the same way in both directions: light and eye may swap",
    },
)
