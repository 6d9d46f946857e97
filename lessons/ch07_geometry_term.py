"""Facets stand in each other's way: some are not seen, some get no light. The geometry term counts those that are left.

Without it a rough surface sends back more light than it gets, and its rim glows. This chapter looks into one groove,
swaps the light and the eye, takes the smaller of two shares, and asks what a geometry term must never do.
"""

from app.lesson import (
    Camera,
    Chapter,
    Check,
    Choice,
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
GEOMETRIC = "Cook – Torrance – Geometric Term ({})".format
TERMS = ("none", "V-groove", "Smith", "Smith correlated")

# A ball seen from far away. Its picked point is theta_v from the eye's direction, upwards; the light stands over that
# point as theta_l and phi say, and is as far away.
BALL_GLSL = """
#include "stage/camera.glsl"
uniform float theta_l;
uniform float theta_v;
uniform float phi;

vec3 eye() {
    return normalize(camera_position);
}

vec3 picked() {
    vec3 v = eye(), up = normalize(vec3(0.0, 0.0, 1.0) - v.z * v);
    return cos(theta_v) * v + sin(theta_v) * up;
}

vec3 lamp() {
    vec3 v = eye(), up = normalize(vec3(0.0, 0.0, 1.0) - v.z * v), along = sin(theta_v) * v - cos(theta_v) * up;
    return cos(theta_l) * picked() + sin(theta_l) * (cos(phi) * along + sin(phi) * cross(v, up));
}
"""
GOLD_GLSL = """
const vec3 GOLD = vec3(1.0, 0.71, 0.29); // deck, Fresnel Term (6)

vec3 mirrored(vec3 s) {
    return vec3(f_schlick(0.5 * length(s), GOLD.r), f_schlick(0.5 * length(s), GOLD.g), f_schlick(0.5 * length(s), GOLD.b));
}

vec3 film(vec3 radiance) {
    return 1.0 - exp(-radiance); // bright light turns white slowly, as on film
}
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
        glsl="""
#include "optics/geometry_choice.glsl"
#include "display/look.glsl"
#include "stage/camera.glsl"
uniform float theta_v;
uniform float m;

const float SIZE = 1.6;
const float RELIEF = 0.02; // the ball is a disk before the eye; its depth carries the light, worked out at its corners

vec3 eye() {
    return normalize(camera_position);
}

vec3 up() {
    vec3 v = eye();
    return normalize(vec3(0.0, 0.0, 1.0) - v.z * v);
}

vec3 around(float turn) {
    return cos(turn) * up() + sin(turn) * cross(up(), eye());
}

vec3 surface_point(int surface, vec2 s) {
    vec3 v = eye();
    if (surface == 2) return -v + 2.6 * (2.0 * s.x - 1.0) * cross(up(), v) + 2.3 * (2.0 * s.y - 1.0) * up();
    float angle = radians(89.5) * s.y * (2.0 - s.y), light = albedo_geometry(angle, m, surface == 0 ? 1 : 0);
    return SIZE * sin(angle) * around(PI * (surface == 0 ? -s.x : s.x)) + RELIEF * light * v;
}

vec3 shade(Surface s) {
    vec3 sky = vec3(0.20, 0.27, 0.36);
    if (s.id == 2) return sky;
    float light = max(dot(s.position, eye()) / RELIEF, 0.0);
    return light <= 1.0 ? sky * light : mix(sky, vec3(1.0, 0.55, 0.16), min(0.25 + 0.75 * (light - 1.0), 1.0)) * min(light, 2.0);
}

vec3 mark_point(int mark, float t) {
    if (mark == 0) return SIZE * sin(theta_v) * around(2.0 * PI * t) + 0.3 * eye();
    if (mark == 1) return SIZE * (2.0 * t - 1.0) * up() + 0.25 * eye();
    return SIZE * around(2.0 * PI * t) + 0.2 * eye();
}

vec4 probe(int i) {
    if (i == 0) return vec4(SIZE * sin(theta_v) * around(0.9) + 0.3 * eye(), 1.0);
    return vec4((i == 1 ? -1.25 : 1.25) * cross(up(), eye()) - 1.9 * up(), 1.0);
}
""",
        surfaces=(Surface("with G", cells=(24, 48)), Surface("without G", cells=(24, 48)), Surface("sky", cells=(1, 1))),
        marks=(Mark("ring", colour="v", segments=72, width=1.2, label="θ", label_at=0.12),
               Mark("divide", colour="quiet", line="dotted"), Mark("outline", colour="quiet", segments=72)),
        labels=(Label("with G", 1), Label("without G", 2, "printed")),
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
Cover the rim with your hand: the two halves are hardly different. Uncover it. Ask what is divided by, and let someone walk
the ring outwards while the class reads the second number aloud; the moment it passes 1 is the point. Common wrong answer:
1, because mirrors cannot make light. Mirrors cannot; the formula can, because it counts facets that nobody sees. Why is
the left half darker than the sky? Light that is blocked would bounce on; the model drops it. The 4 is the consistent form
of the printed π (chapter 5). 5 minutes.
""",
    sources=("Deck, slide Geometric Term (1)", "Torrance & Sparrow 1967", "Cook & Torrance 1982"),
    honesty="Shares are exact to 1e-6 for Beckmann facets that mirror everything, with 1/4 for the printed 1/π. What is "
            "blocked is dropped here, not passed on to the next facet.",
    values=(Value("theta_v", 78.0, low=0.0, high=85.0), Value("m", 0.8, low=0.1, high=1.0)),
    minutes=5,
)

# Three V-grooves side by side, cut open: the ridges at z = 0, the middle one's valley at x = 0, both sides equally steep.
# The side whose normal leans to the right is the facet in question.
GROOVE_GLSL = """
#include "optics/groove.glsl"
#include "display/look.glsl"
uniform float facet;

float wide() {
    return 2.0 * cos(facet);
}

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
But the opposite side stands in between: what lies below the line of sight over its ridge is **masked**. The strip before
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

vec3 way() {
    return vec3(sin(lean_v), 0.0, cos(lean_v));
}

vec3 start(int ray) {
    return groove_point(facet, (float(ray) + 0.5) / float(samples));
}

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

vec3 mark_point(int mark, float t) {
    vec3 lift = vec3(0.0, -0.43, 0.0), middle = groove_point(facet, 0.5), ridge = groove_point(-facet, 1.0);
    if (mark == 0) return groove_point(facet, 1.0) + vec3(0.0, 0.0, 0.75 * t) + lift;
    if (mark == 1) return middle + 0.8 * t * vec3(sin(facet), 0.0, cos(facet)) + lift;
    if (mark == 2) return way() * (FAR + 0.6 * t) + 1.9 * lift;
    float open = clamp(groove_hidden(facet, lean_v), 0.0, 1.0);
    vec3 foot = groove_point(facet, open), over = cos(facet + lean_v) < 0.0 ? ridge : foot;
    return mix(foot, over + way() * (FAR - dot(over, way())), t) + 1.2 * lift;
}

vec4 probe(int i) {
    vec3 lift = vec3(0.0, -0.43, 0.0);
    if (i == 0) return vec4(way() * (FAR + 0.6) + 1.9 * lift, 1.0);
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
        camera=Camera(azimuth=-66, elevation=17, distance=14, target=(0.2, 0.2, 0.3), field_of_view=22),
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
Let them count rays before the formula appears: green ones over all. Then prove it on the board: the line over the ridge
cuts the facet where the mirror image of the facet in the valley's vertical plane would be met, and two products remain.
Ask what G is from straight above: 2. Is that a bug? The formula measures where the line of sight meets the facet's own
plane; beyond the valley there is no facet. Common wrong answer to the question: a third, from 75 over 90. 6 minutes.
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

So nothing new has to be derived. Swap the roles:

$$\colour{l}{G_\text{shadow}} = \frac{2\,(n\cdot h)(n\cdot l)}{l\cdot h}, \qquad l\cdot h = v\cdot h$$

Both hidden parts begin in the valley. So they **overlap**, and the larger one decides. [Swap](?lean_l=40&lean_v=75) and
[swap back](?lean_l=75&lean_v=40): the share that is lit *and* seen stays. Light takes the same way in both directions:
**reciprocity**.
""",
    scene=Scene(
        glsl=GROOVE_GLSL + """
uniform float lean_l;
uniform float lean_v;

const float FAR = 2.0;

vec3 way(float lean) {
    return vec3(sin(lean), 0.0, cos(lean));
}

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

vec3 edge(float lean) {
    return groove_point(facet, clamp(groove_hidden(facet, lean), 0.0, 1.0)) + vec3(0.0, 0.0, 0.012);
}

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
        camera=Camera(azimuth=-52, elevation=27, distance=16, target=(0.3, 0.0, 0.2), field_of_view=23),
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
        told="0.42 again. What the sun did not reach before, the eye does not reach now.",
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
    values=(Value("lean_l", 75.0, low=0.0, high=88.0), Value("lean_v", 40.0, low=0.0, high=88.0),
            Value("facet", 45.0, low=15.0, high=72.0)),
    minutes=5,
)

CHAPTER = Chapter(
    title="The geometry term",
    idea="Facets hide each other from the eye and from the light; G is the share that is left.",
    steps=(WHY, MASKING, SHADOWING),
    exercises=(),
)
