"""What does a rough surface look like from close by? Thousands of small mirrors, each leaning its own way.

Torrance and Sparrow model a surface that is too rough to be a mirror as many flat facets. This chapter zooms in on them,
counts the ones that send light to the eye and those that stand in each other's way, and puts them into one formula.
"""

from app.lesson import (
    Break,
    Camera,
    Chapter,
    Check,
    Choice,
    Curve,
    Curves,
    Dots,
    Exercise,
    Handle,
    ImageSlice,
    Label,
    Lobes,
    Mark,
    Model,
    Prediction,
    Readout,
    Scene,
    Slice,
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
uniform float zoom, m;

const float GROOVE = 20.0; // micrometres
const float DEEP = 0.34;
const int SAMPLES = 6;

// The slope of the sides of a groove: one of Beckmann's, by a number that looks random and is the same each time.
float slope_of(float groove) {
    float p = fract(groove * 0.1031);
    p *= p + 33.33;
    return m * sqrt(-log(1.0 - 0.999 * fract(p * (p + p))));
}

// Height of the plate at a place counted in grooves; ridges are at 0.
float height(float at) {
    float groove = floor(at), f = at - groove;
    return -slope_of(groove) * min(f, 1.0 - f) * 2.0 / grooves_shown(zoom, GROOVE);
}

vec2 profile(float s) {
    float most = 0.5 * grooves_shown(zoom, GROOVE), at = clamp(floor(-most) + 0.5 * floor(s * 260.0 + 0.5), -most, most);
    return most > 60.0 ? vec2(s < 0.5 ? -1.0 : 1.0, 0.0) : vec2(at / most, height(at)); // flat: one cell, the rest folded
}

vec3 surface_point(int surface, vec2 s) {
    vec2 p = profile(s.x);
    if (surface == 0) return vec3(p.x, 2.0 * s.y - 1.0, p.y);
    if (surface == 1) return vec3(p.x, -1.0, mix(-DEEP, p.y, s.y));
    return vec3(1.0, 2.0 * s.x - 1.0, mix(-DEEP, profile(1.0).y, s.y));
}

float side_at(float at) { return at - floor(at) < 0.5 ? slope_of(floor(at)) : -slope_of(floor(at)); }

// The room on the far side, by height and side over distance: a window in the evening and three lamps on a dark wall.
// Adds what a facet of this slope mirrors, by how much of it is seen; its normal is (slope, 0, 1). In lamps the three and
// the wall, in window its panes, how blue the wall is and how blue the panes are.
void mirror(float slope, vec3 v, float near, inout vec4 lamps, inout vec3 window) {
    float seen = max(slope * v.x + v.z, 0.0), turn = 2.0 * seen / (1.0 + slope * slope);
    vec2 p = vec2(turn * slope - v.x, abs(turn - v.z)) * near, q = abs(p - vec2(-0.30, 0.655));
    vec2 a = p - vec2(-0.06, 0.80), b = p - vec2(-0.52, 0.76), c = p - vec2(-0.16, 0.535);
    bool pane = q.x < 0.13 && q.y < 0.075 && min(q.x, q.y) > 0.007;
    float in_pane = pane ? seen : 0.0, on_wall = seen - in_pane;
    vec3 lit = max(1.0 - vec3(620.0 * dot(a, a), 900.0 * dot(b, b), 1500.0 * dot(c, c)), 0.0);
    lamps += on_wall * vec4(lit, 1.0);
    window += vec3(in_pane, on_wall * clamp(2.2 * p.y - 0.9, 0.0, 1.0), in_pane * clamp(8.0 * p.y - 4.7, 0.0, 1.0));
}

vec3 shade(Surface s) {
    if (s.id > 0) return mix(vec3(0.035, 0.04, 0.05), vec3(0.17, 0.18, 0.20), s.st.y * s.st.y) * (s.id == 1 ? 1.0 : 0.5);
    float at = 0.5 * s.position.x * grooves_shown(zoom, GROOVE), wide = fwidth(at), near = 1.0 / max(-s.v.y, 0.02);
    bool whole = wide > 2.0; // grooves, both sides of each
    vec4 lamps = vec4(0.0);
    vec3 window = vec3(0.0);
    for (int k = 0; k < SAMPLES; k += 2) { // two at a time, and one loop: a CPU runs both of two
        float x = at + wide * ((float(k) + (whole ? 1.0 : 0.5)) / float(SAMPLES) - 0.5), next = x + wide / float(SAMPLES);
        float one = side_at(x), two = whole ? -one : side_at(next);
        mirror(one, s.v, near, lamps, window);
        mirror(two, s.v, near, lamps, window);
    }
    vec3 light = vec3(17.0, 8.0, 2.6) * lamps.x + vec3(4.0, 8.0, 15.0) * lamps.y + vec3(15.0, 11.0, 7.0) * lamps.z;
    light += vec3(0.012, 0.018, 0.032) * lamps.w + vec3(0.078, 0.102, 0.148) * window.y;
    light += vec3(1.9, 0.95, 0.42) * window.x + vec3(-1.15, 0.15, 1.28) * window.z;
    return 0.79 * light / max(lamps.w + window.x, 1e-6);
}

float bar_end() { return -1.0 + 0.02 * zoom; }

vec3 mark_point(int mark, float t) {
    if (mark == 0) return vec3(mix(-1.0, bar_end(), t), -1.02, -DEEP - 0.12);
    return vec3(mark == 1 ? -1.0 : bar_end(), -1.02, -DEEP - 0.19 + 0.14 * t);
}

vec4 probe(int i) { return vec4(i == 0 ? bar_end() : -0.7, -1.02, -DEEP - (i == 0 ? 0.12 : 0.32), 1.0); }
""",
        surfaces=(Surface("plate", cells=(260, 1)), Surface("cut", cells=(260, 1)), Surface("side", cells=(1, 1))),
        marks=(Mark("scale bar", width=1.6), Mark("its start", width=1.6), Mark("its end", width=1.6)),
        labels=(Label("0.2 mm", 1),),
        handles=(Handle("the scale", 0, ("zoom",)),),
        camera=Camera(azimuth=-74, elevation=33, distance=5.7, target=(0.02, 0.0, -0.16)),
    ),
    plot=Curves(
        title="Where single grooves can still be seen", sweep="groove_width",
        curves=(Curve("by a sharp eye, up to", Term("resolved_distance")),), y_label="distance of the eye, cm", y_scale="log",
    ),
    readouts=(
        Readout("width of the picture", Term("plate_shown"), unit="mm"),
        Readout("grooves side by side", Term("grooves_shown", {"groove_width": 20.0}), unit=""),
        Readout("width w is seen up to", Term("resolved_distance"), unit="cm"),
    ),
    ask=Prediction(
        question="The grooves of this plate are 20 µm wide. From how far away can a sharp eye still see them singly?",
        truth=Term("resolved_distance", {"groove_width": 20.0}),
        unit="cm", low=1.0, high=1000.0, scale="log",
        sets={"zoom": 1.0, "groove_width": 20.0},
        told="6.9 cm, nearer than most eyes can focus. So nobody ever sees a facet: roughness is the word for their sum.",
    ),
    notes="""
Bring a ruler or a knife of brushed steel and a lamp: the streak runs across the scratches, and it turns when you turn the
plate. Ask why, and leave it open. Then zoom. The moment to wait for is about ×10, where noise turns into stripes and each
stripe into a clear image of a piece of the room. Ask what one stripe lacks to be a mirror: nothing. Common wrong answer:
rough means dull, every point scatters. Here no point does. 5 minutes.
""",
    sources=("Deck, slide The Torrance - Sparrow Microfacet Model (1)", "Torrance & Sparrow 1967",
             "Beckmann & Spizzichino 1963: the slopes"),
    honesty="Each pixel shows the mean of a few mirror images in its facets. Grooves of equal width with ridges of equal "
            "height are the model's; real scratches are not so tidy. The room is made up.",
    values=(Value("zoom", 1.0, low=1.0, high=100.0), Value("m", 0.2, low=0.02, high=0.8),
            Value("groove_width", 60.0, more=True)), minutes=5,
)

FACETS = Step(
    name="facets",
    title="Only facets with m = h",
    idea="Of all facets the eye sees light in those whose normal m is halfway between l and v, and their share is D.",
    slides=(TORRANCE_SPARROW(2), TORRANCE_SPARROW(3)),
    prose=r"""
Each square is one facet, a flat mirror with its own normal $m$. Over the plate, each dot is one of these normals. A mirror
sends light from $\colour{l}{l}$ to $\colour{v}{v}$ only if

$$m = \colour{h}{h} = \frac{\colour{l}{l} + \colour{v}{v}}{|\colour{l}{l} + \colour{v}{v}|}$$

so a facet is on or off. A lamp has a size; then $m$ may miss by a little, the $\colour{h}{\text{ring}}$. The facets in it
**light up**.

Count them. Their share, over the ring's size seen from above, is $\colour{d}{D(h)}$: so many [per steradian](code:d_beckmann). Move the
eye into the [mirror direction](?theta_v=35), then [off to the side](?phi=90): the ring leaves the crowd. Take a
[small lamp](?half_angle=0.5): the count starts to jump. Make the plate [smoother](?m=0.12).
""",
    scene=Scene(
        glsl="""
#include "optics/facets.glsl"
#include "display/palette.glsl"
uniform float theta_l, theta_v, phi, m, half_angle;
uniform int facets;

const float DOME = 0.95;

vec3 halfway() {
    vec3 s = light_direction(theta_l, phi) + view_direction(theta_v);
    return s / max(length(s), 1e-6);
}

bool is_lit(vec3 facet) { return distance(facet, halfway()) <= 2.0 * sin(0.5 * half_angle); }

vec3 surface_point(int surface, vec2 s) { return vec3(2.0 * s - 1.0, 0.0); }

vec3 shade(Surface s) {
    int side = int(ceil(sqrt(float(facets)) - 1e-3));
    vec2 at = s.st * float(side);
    int place = int(at.y) * side + min(int(at.x), side - 1);
    if (place >= facets) return mix(background, palette[COLOUR_QUIET], 0.2);
    vec3 facet = facet_normal(int(facet_index(place, facets)), m, facets);
    float gap = smoothstep(0.0, 0.12, min(min(fract(at.x), fract(at.y)), 1.0 - max(fract(at.x), fract(at.y))));
    vec3 off = vec3(0.055, 0.085, 0.12) * max(1.0 + 1.1 * facet.x - 0.9 * facet.y, 0.2);
    return is_lit(facet) ? mix(palette[COLOUR_L], vec3(1.0, 0.9, 0.6), 0.5) : off * (0.5 + 0.5 * gap);
}

vec3 dot_point(int i) { return DOME * facet_normal(i, m, facets); }

vec4 dot_colour(int i) {
    return is_lit(facet_normal(i, m, facets)) ? vec4(palette[COLOUR_L], 1.0) : vec4(palette[COLOUR_ESTIMATE], 0.6);
}

vec3 mark_point(int mark, float t) {
    vec3 h = halfway(), side = normalize(vec3(h.z, 0.0, -h.x)), up = cross(h, side);
    if (mark == 0) return vec3(0.0, 0.0, 1.25 * t);
    if (mark == 1) return 1.5 * t * light_direction(theta_l, phi);
    if (mark == 2) return 1.5 * t * view_direction(theta_v);
    if (mark == 3) return 1.3 * t * h;
    return DOME * 1.005 * (cos(half_angle) * h + sin(half_angle) * (cos(2.0 * PI * t) * side + sin(2.0 * PI * t) * up));
}

vec4 probe(int i) { return vec4(1.5 * (i == 0 ? light_direction(theta_l, phi) : view_direction(theta_v)), 1.0); }
""",
        surfaces=(Surface("facets", cells=(1, 1)),),
        marks=(Mark("normal", colour="n", tip="arrow", label="n"), Mark("to the light", colour="l", tip="sun", label="l"),
               Mark("to the eye", colour="v", tip="eye", label="v"),
               Mark("halfway", colour="h", line="dashed", tip="arrow", label="h"), Mark("the ring", colour="h", segments=48, width=1.4)),
        dots=Dots(count="facets", size=0.4),
        handles=(Handle("the light", 0, ("theta_l", "phi")), Handle("the eye", 1, ("theta_v",))),
        legend=(("estimate", "normals m, one a facet"), ("l", "facets that light up")),
        camera=Camera(azimuth=-68, elevation=27, distance=6.4, target=(0.0, 0.0, 0.36), field_of_view=25),
    ),
    plot=Curves(
        title="Counted facets become D", sweep="theta_v",
        curves=(Curve("Beckmann's D(h)", Term("d_halfway")),
                Curve("counted among 10 000", Term("d_near", {"facets": 10000}), role="estimate"),
                Curve("counted among 1000", Term("d_near", {"facets": 1000}), role="printed")),
        y_label="D, per steradian",
    ),
    readouts=(
        Readout("facets that light up", Term("facets_lit"), unit=""),
        Readout("D(h), Beckmann", Term("d_halfway"), role="exact", unit="1/sr"),
        Readout("D(h), counted", Term("d_near"), role="estimate", unit="1/sr", against="D(h), Beckmann"),
    ),
    ask=Prediction(
        question="You face a plate of 10 000 facets, m = 0.3, a lamp 4° wide right behind your head. In how many facets do you see it?",
        truth=Term("facets_lit"),
        unit="facets", low=1.0, high=10000.0, scale="log",
        sets={"theta_l": 0.0, "theta_v": 0.0, "phi": 180.0, "m": 0.3, "half_angle": 1.0, "facets": 10000},
        told="Far fewer than half: one in 300. But each of them shows the lamp at its full radiance, so the plate shines.",
    ),
    notes="""
Let the class guess, then drag the eye slowly through the mirror direction: facets go on and off like sequins. Ask why the
ring of a lamp 4° wide is only 2° wide: a mirror that turns by 1° turns its ray by 2°. Then the plot: 1000 facets scatter
about the curve, 10 000 lie on it; D is nothing but this count. Common wrong answer: half of them, since half lean towards
the light. The share alone is not D: divide by the solid angle, and D passes 1. 7 minutes.
""",
    sources=("Deck, slides The Torrance - Sparrow Microfacet Model (2) and (3)", "Torrance & Sparrow 1967",
             "Beckmann & Spizzichino 1963"),
    honesty="Each facet is a perfect mirror, counted with its area seen from above. The ring is round, as for a lamp straight "
            "above; at a slant it is wider across, by 1 / l·h. That facets hide each other comes in the next step.",
    values=(Value("theta_v", 58.0, low=0.0, high=85.0), Value("half_angle", 2.0, low=0.25, high=10.0),
            Value("m", 0.3, low=0.05, high=0.8), Value("theta_l", 35.0, low=0.0, high=85.0),
            Value("phi", 180.0, low=-180.0, high=180.0, more=True), Value("facets", 10000, low=100, high=10000, more=True)),
    minutes=7,
)

BLOCKING = Step(
    name="blocking",
    title="Facets in each other's way",
    idea="Of a facet in a groove, the eye misses one part and the light another; both begin in the valley.",
    slides=("Shadowing and Masking",),
    prose=r"""
One groove, cut open. Its left facet leans to the right by $\alpha$, and the other facet stands before it. From the eye a part
of it is $\colour{v}{\text{masked}}$; from the light a part is $\colour{l}{\text{shadowed}}$. What is left is $\colour{g}{\text{lit and seen}}$:

$$\colour{g}{G} = \min\left(1, \frac{2\,(n\cdot m)(\colour{v}{n\cdot v})}{\colour{v}{m\cdot v}}, \frac{2\,(n\cdot m)(\colour{l}{n\cdot l})}{\colour{l}{m\cdot l}}\right)$$

Why the smaller one, and not the product? Look: both parts begin in the valley, so one lies inside the other. The rays say
the same: each point asks whether eye and light are free.

Try [nothing hidden](?lean_l=-20&lean_v=40), [masked](?lean_l=20&lean_v=75), [shadowed](?lean_l=75&lean_v=20),
[turned away](?lean_v=-60), a [steep groove](?facet=70&lean_l=20&lean_v=40). At [m = h](?facet=45&lean_l=18&lean_v=72) the rest flashes.
""",
    scene=Scene(
        glsl="""
#include "optics/groove.glsl"
#include "display/palette.glsl"
uniform float facet, lean_l, lean_v;

const float LENGTH = 1.2;
const int RAYS = 10;
const float ARROW = 1.75;

vec3 along(float lean) { return vec3(sin(lean), 0.0, cos(lean)); }

// The profile: ridges 1 and 3 are those of the groove, 2 is its valley
vec3 corner(int k) { return vec3((float(k) - 2.0) * cos(facet), 0.0, k % 2 == 1 ? 0.0 : -sin(facet)); }

vec3 surface_point(int surface, vec2 s) {
    vec3 back = vec3(0.0, LENGTH * s.y, 0.0), top = corner(int(s.x * 4.0 + 0.5));
    if (surface == 0) return groove_point(facet, s.x) + back;
    if (surface == 1) return top + back;
    if (surface == 2) return vec3(top.x, 0.0, mix(-1.1, top.z, s.y));
    int column = int(s.x * float(2 * RAYS - 1) + 0.5);
    float t = (float(column / 2) + 0.5) / float(RAYS), lean = surface == 3 ? lean_v : lean_l;
    vec3 from = groove_point(facet, t), d = along(lean), across = vec3(d.z, 0.0, -d.x) * 0.008 * (float(column % 2) * 2.0 - 1.0);
    float far = min(groove_reach(facet, t, lean), min((0.45 - from.z) / max(d.z, 1e-3), 2.3));
    return from + d * far * s.y + across + vec3(0.0, surface == 3 ? -0.02 : -0.025, 0.0);
}

vec3 painted(float t, float y) {
    float masked = groove_hidden(facet, lean_v), shadowed = groove_hidden(facet, lean_l);
    bool mirrors = abs(facet - 0.5 * (lean_l + lean_v)) < 0.02; // m = h
    if (t < shadowed && fract(7.0 * (y - t)) < 0.4) return palette[COLOUR_L];
    if (t < masked && fract(7.0 * (y + t)) < 0.4) return palette[COLOUR_V];
    if (t < max(masked, shadowed)) return mix(background, palette[COLOUR_QUIET], 0.35);
    return mix(palette[COLOUR_G], vec3(1.0), mirrors ? 0.6 : 0.0);
}

vec3 shade(Surface s) {
    vec3 metal = mix(palette[COLOUR_QUIET], background, 0.45);
    if (s.id == 0) return painted(s.st.x, s.position.y);
    if (s.id == 1) {
        if (int(floor(4.0 * s.st.x)) == 1) discard; // the painted one
        return metal * (0.35 + 0.65 * abs(s.normal.z)) * (1.0 - 0.3 * s.st.y);
    }
    if (s.id == 2) return mix(background, metal, 0.35 + 0.15 * s.st.y);
    int column = int(floor(s.st.x * float(2 * RAYS - 1)));
    if (column % 2 == 1) discard;
    float t = (float(column / 2) + 0.5) / float(RAYS);
    vec3 colour = palette[s.id == 3 ? COLOUR_V : COLOUR_L];
    return mix(colour, background, 0.55 * groove_blocked(facet, t, s.id == 3 ? lean_v : lean_l));
}

vec3 mark_point(int mark, float t) {
    vec3 front = vec3(0.0, -0.04, 0.0), ridge = corner(1) + front;
    if (mark == 0) return ridge + vec3(0.0, 0.0, 1.1 * t);
    if (mark < 3) return ridge + ARROW * t * along(mark == 1 ? lean_l : lean_v);
    if (mark == 3) return groove_point(facet, 0.5) + 2.0 * front + 0.95 * t * along(facet);
    if (mark == 6) {
        int k = int(min(4.0 * t, 3.0));
        return mix(corner(k), corner(k + 1), 4.0 * t - float(k)) + 0.25 * front;
    }
    float hidden = groove_hidden(facet, mark == 4 ? lean_v : lean_l);
    return mix(corner(3), groove_point(facet, hidden), hidden > 0.0 && hidden < 1.0 ? t : 0.0) + 1.5 * front;
}

vec4 probe(int i) { return vec4(mark_point(i + 1, 1.0), 1.0); }
""",
        surfaces=(Surface("the facet", cells=(1, 1)), Surface("grooves", cells=(4, 1)), Surface("cut", cells=(4, 1)),
                  Surface("rays to the eye", cells=(19, 1)), Surface("rays to the light", cells=(19, 1))),
        marks=(Mark("normal", colour="n", tip="arrow", label="n"), Mark("to the light", colour="l", tip="sun", label="l", width=1.4),
               Mark("to the eye", colour="v", tip="eye", label="v", width=1.4),
               Mark("facet's normal", colour="h", line="dashed", tip="arrow", label="m", width=1.4),
               Mark("last line to the eye", colour="v", line="dashed", width=1.4),
               Mark("last line to the light", colour="l", line="dashed", width=1.4), Mark("profile", segments=4)),
        handles=(Handle("the light", 0, ("lean_l",)), Handle("the eye", 1, ("lean_v",)), Handle("the facet", 2, ("facet",))),
        legend=(("v", "masked"), ("l", "shadowed"), ("g", "lit and seen")),
        camera=Camera(azimuth=-66, elevation=22, distance=9.0, target=(0.1, 0.4, 0.05), field_of_view=22),
    ),
    plot=Curves(
        title="What is left of the facet", sweep="lean_v",
        curves=(Curve("G, lit and seen", Term("groove_open")),
                Curve("G, by rays", Term("groove_open_counted"), role="estimate"),
                Curve("masked", Term("groove_hidden", {"lean": "lean_v"}), role="printed")),
        y_label="share of the facet",
    ),
    readouts=(
        Readout("masked", Term("groove_hidden", {"lean": "lean_v"}), unit=""),
        Readout("shadowed", Term("groove_hidden", {"lean": "lean_l"}), unit=""),
        Readout("lit and seen G", Term("groove_open"), role="exact", unit=""),
        Readout("G by rays", Term("groove_open_counted"), role="estimate", unit="", against="lit and seen G"),
    ),
    ask=Prediction(
        question="A groove with sides of 45°; the eye looks in at 75° from n, from the side the facet faces. How much of the facet does it see?",
        truth=Term("groove_open", {"lean_l": 0.0}),
        unit="of it", low=0.0, high=1.0,
        sets={"facet": 45.0, "lean_v": 75.0, "lean_l": 0.0},
        told="0.42: the line over the other ridge meets the facet that far from its top. Up to 45° nothing is hidden.",
    ),
    notes="""
Fold a sheet of paper to a groove and look in from one side while a lamp lights it from the other. Then drag the eye down:
the green line over the opposite ridge climbs up the facet from the valley. Ask where the shadow begins: in the same
valley. So G is a minimum. Common wrong answer: multiply the two shares, as one does for independent things; Smith's model
in chapter 7 starts from that. Swap l and v: G stays the same, and this is reciprocity. The word on the slide, masking
(shadow), mixes the two. 7 minutes.
""",
    sources=("Deck, slide Shadowing and Masking", "Torrance & Sparrow 1967", "Blinn 1977"),
    honesty="Exact for symmetric grooves without end, ridges of one height, and light that bounces once. Directions that do "
            "not lie across the groove count as one sees them along it.",
    values=(Value("facet", 45.0, low=5.0, high=80.0), Value("lean_l", 58.0, low=-85.0, high=85.0),
            Value("lean_v", 72.0, low=-85.0, high=85.0), Value("samples", 200, low=16, high=4096)), minutes=7,
)

INTERREFLECTIONS = Step(
    name="interreflections",
    title="Blocked light is not lost",
    idea="Light that a facet sends to its neighbour comes back out, and mostly to where it came from: rough things look flat.",
    slides=("Inter-reflections",),
    prose=r"""
Now the facets are dull: each scatters light evenly. In the groove, a share $1 - \cos\alpha$ of what one facet sends out
meets $\colour{r}{\text{the other}}$, and goes on from there. Cook and Torrance drop it.

Oren and Nayar made a whole surface of such grooves. From the light's side the eye sees the facets that are well lit: at full
phase the ball is a flat disk, as the Moon is. Lambert's has a dark rim.

Their usual short form leaves the second bounce out, too. **EON** puts it back: with $\rho = 1$ no light is missing. Turn the
Moon to [nearly half](?phase=75), make it [smooth](?sigma=0&roughness=0), [very rough](?sigma=57&roughness=1), and the groove
[steep](?facet=70).
""",
    scene=Scene(
        glsl="""
#include "optics/groove.glsl"
#include "optics/lambert.glsl"
#include "optics/oren_nayar.glsl"
#include "optics/eon.glsl"
#include "display/balls.glsl"
#include "display/palette.glsl"
#include "stage/camera.glsl"
uniform float facet, disk_x, phase, rho, sigma, roughness;

const int FAN = 15;
const float HIT = 0.62; // where the light meets the facet
const vec3 GROOVE = vec3(0.0, 0.0, -1.05);
const float SCALE = 1.25;

vec3 centre(int i) { return vec3(2.35 * float(i - 1), 0.0, 1.25); }

// Of a ball: to the right, to the eye, up, as the eye sees it.
mat3 axes(int i) {
    vec3 v = normalize(camera_position - centre(i)), side = normalize(vec3(-v.y, v.x, 0.0));
    return mat3(side, v, cross(v, side));
}

// Each ray of the fan carries as much light as the next.
float lean_of(int ray) { return facet + asin((2.0 * float(ray) + 1.0) / float(FAN) - 1.0); }

bool goes_on(int ray) { return groove_blocked(facet, HIT, lean_of(ray)) > 0.5; }

vec3 surface_point(int surface, vec2 s) {
    if (surface == 0) return ball_point(s, 3, centre(ball_number(s, 3)), 1.0);
    if (surface == 1) {
        int k = int(s.x * 4.0 + 0.5);
        return GROOVE + SCALE * vec3((float(k) - 2.0) * cos(facet), 0.02, mix(-1.05, k % 2 == 0 ? -sin(facet) : 0.0, s.y));
    }
    if (surface == 4) return vec3(7.4 * s.x - 3.7, 1.2, 2.3 * s.y + 0.1);
    int column = int(s.x * float(2 * FAN - 1) + 0.5);
    float lean = lean_of(column / 2);
    vec3 from = groove_point(facet, HIT), d = vec3(sin(lean), 0.0, cos(lean));
    vec3 to = from + d * min(groove_reach(facet, HIT, lean), min((0.75 - from.z) / max(d.z, 1e-3), 2.3));
    if (surface == 3) {
        from = to;
        d = vec3(0.0, 0.0, 1.0);
        to.z = goes_on(column / 2) ? 0.75 : to.z;
    }
    vec3 across = vec3(d.z, 0.0, -d.x) * 0.012 * (float(column % 2) * 2.0 - 1.0);
    return GROOVE + SCALE * (mix(from, to, s.y) + across + vec3(0.0, -0.02, 0.0));
}

float speckle(vec3 p) {
    vec2 q = sin(vec2(3.1, 4.3) * p.xz + 1.7 * sin(vec2(5.3, 4.9) * p.zy));
    vec2 r = sin(11.0 * p.zx + 2.0 * q);
    return 1.0 - 0.16 * smoothstep(-0.3, 0.5, q.x * q.y + 0.3 * r.y) + 0.06 * r.x * r.y;
}

vec3 shade(Surface s) {
    if (s.id == 0) {
        int i = ball_number(s.st, 3);
        vec3 n = ball_normal(s.position - centre(i), s.v), v = axes(i)[1], l = axes(i) * vec3(sin(phase), cos(phase), 0.0);
        float albedo = min(rho * speckle(n), 0.99);
        float f = i == 0 ? brdf_lambert(n, l, v, albedo) : i == 1 ? brdf_oren_nayar(n, l, v, albedo, sigma) : brdf_eon(n, l, v, albedo, roughness);
        return vec3(1.0, 0.97, 0.92) * (PI * f * max(dot(n, l), 0.0));
    }
    if (s.id == 1) return mix(background, palette[COLOUR_QUIET], 0.3 + 0.25 * s.st.y);
    if (s.id == 4) return vec3(0.006, 0.008, 0.014);
    int column = int(floor(s.st.x * float(2 * FAN - 1)));
    if (column % 2 == 1 || (s.id == 3 && !goes_on(column / 2))) discard;
    if (s.id == 3) return palette[COLOUR_R];
    return goes_on(column / 2) ? palette[COLOUR_R] : palette[COLOUR_V];
}

vec3 mark_point(int mark, float t) {
    vec3 front = vec3(0.0, -0.05, 0.0), hit = groove_point(facet, HIT) + front;
    if (mark == 0) return GROOVE + SCALE * (hit + (1.0 - t) * vec3(0.7, 0.0, 1.15));
    return centre(mark - 1) + axes(mark - 1) * vec3(disk_x, 1.05, (2.0 * t - 1.0) * sqrt(max(1.0 - disk_x * disk_x, 0.0)));
}

vec4 probe(int i) {
    if (i < 3) return vec4(centre(i) + vec3(0.0, 0.0, 1.42), 1.0);
    if (i == 3) return vec4(mark_point(1, 0.5), 1.0);
    return vec4(GROOVE + SCALE * groove_point(facet, 1.0), 1.0);
}
""",
        surfaces=(Surface("three Moons", cells=(98, 2)), Surface("groove", cells=(4, 1)), Surface("first bounce", cells=(29, 1)),
                  Surface("second bounce", cells=(29, 1)), Surface("night", cells=(1, 1))),
        marks=(Mark("the light", colour="l", tip="arrow", width=1.6), *(Mark(f"place {i}", line="dashed") for i in range(3))),
        labels=(Label("Lambert", 0), Label("Oren–Nayar", 1), Label("EON", 2)),
        handles=(Handle("the place", 3, ("disk_x",)), Handle("the groove", 4, ("facet",))),
        legend=(("v", "gets out"), ("r", "meets the other facet")),
        camera=Camera(azimuth=-90, elevation=3, distance=30.0, target=(0.0, 0.0, 0.36), field_of_view=13.4),
    ),
    plot=(
        Curves(
            title="Radiance across the disk", sweep="disk_x", y_label="radiance, a white card being 1",
            curves=(Curve("Lambert", Term("disk_lambert")), Curve("EON", Term("disk_eon"), role="estimate"),
                    Curve("Oren–Nayar, short form", Term("disk_oren_nayar"), role="printed"))),
        Lobes("What one place sends where"),
    ),
    models=(Model("Lambert", Term("brdf_lambert"), "exact"), Model("EON", Term("brdf_eon")), Model("Oren–Nayar", Term("brdf_oren_nayar"), "printed")),
    readouts=(
        Readout("Lambert here", Term("disk_lambert"), unit=""), Readout("Oren–Nayar here", Term("disk_oren_nayar"), unit=""),
        Readout("EON here", Term("disk_eon"), unit=""), Readout("sent to the other facet", Term("groove_exchange"), unit=""),
    ),
    ask=Prediction(
        question="A Lambert ball at full phase: at 94 % of its radius it has 0.34 of the radiance of its middle. And Oren-Nayar's ball, σ = 40°?",
        truth=Term("rim_oren_nayar", {"disk_x": 0.94}),
        unit="of the middle", low=0.0, high=1.0,
        sets={"disk_x": 0.94, "phase": 0.0, "sigma": 40.0},
        told="0.82: nearly flat. At the rim a smooth ball turns away; of a rough one the facets that face you are left.",
    ),
    notes="""
Start with the Moon: who has seen a dark rim at full Moon? Nobody, and Lambert's ball has one. Ask for the reason before
you show the groove: at the rim you look along the surface and see only facets that lean to you, and with the Sun at your
back these are the lit ones. Then turn the phase: the advantage goes. EON against the short form is the second bounce; it
shows where the albedo is high. (Of white facets, σ = 0.2 rad, the short form sends out 1.015 of the light at the horizon.)
The slide sends the class to Oren-Nayar for inter-reflection; only their full model has it. 7 minutes.
""",
    sources=("Deck, slide Inter-reflections", "Oren & Nayar 1994: Generalization of Lambert's reflectance model",
             "Portsmouth, Kutz & Hill 2025: EON", "Hottel 1954: crossed strings"),
    honesty="Both formulas are exact as published; σ and r are different scales, so compare shapes. The real Moon also has a "
            "peak at full phase that neither has. The fan shows equal shares of light; the second bounce is one of many.",
    values=(Value("disk_x", 0.8, low=-0.98, high=0.98), Value("phase", 0.0, low=0.0, high=80.0),
            Value("sigma", 40.0, low=0.0, high=57.0), Value("roughness", 0.9), Value("rho", 0.85, low=0.05, high=0.9, more=True),
            Value("facet", 55.0, low=20.0, high=80.0, more=True), Value("theta_l", 60.0, more=True),
            Value("theta_v", 50.0, more=True), Value("phi", 0.0, more=True)), minutes=7,
)

COOK_TORRANCE_MODEL = "The Cook – Torrance Model ({})".format
DISTRIBUTION_TERM = "Cook – Torrance – Distribution Term ({})".format

COOK_TORRANCE = Step(
    name="cook_torrance",
    title="Three factors make the formula",
    idea="A rough mirror is a product: how many facets face h, how many of them are free, and how much each reflects.",
    slides=(COOK_TORRANCE_MODEL(1), COOK_TORRANCE_MODEL(2)),
    prose=r"""
Which facets send light from $\colour{l}{l}$ to $\colour{v}{v}$? Those that face $\colour{h}{h}$: $\colour{d}{D}$ says
[how many](code:d_beckmann). Of these a share $\colour{g}{G}$ [stands free](code:g_vgroove), and each
[reflects a share](code:f_schlick) $\colour{f}{F}$.

$$f = \frac{\colour{d}{D}\,\colour{g}{G}\,\colour{f}{F}}{4\,(n\cdot l)(n\cdot v)}$$

The small balls show one factor each, the large one the product. Only $F$ has a colour. Take the
$\colour{l}{\text{lamp}}$ [behind the ball](?theta_l=82&theta_v=82&phi=180): there $F$ climbs towards 1 in every colour, and gold
pales to *the lamp's colour*.

The deck writes $1/\pi$ for $1/4$, after Lambert. But the facets are counted around $h$, light around $l$, and
$d\omega_l = 4\,(l\cdot h)\,d\omega_h$: that is the 4. [As printed](?prefactor=1), the ball in the furnace shines
brighter than the furnace.
""",
    scene=Scene(
        glsl="""
#include "optics/cook_torrance.glsl"
#include "optics/vgroove.glsl"
#include "display/balls.glsl"
#include "display/furnace.glsl"
#include "display/palette.glsl"
uniform float theta_l, theta_v, phi, m, f0;
uniform int prefactor;

const float LARGE = 1.62;
const float SMALL = 0.52;
const vec3 GOLD = vec3(1.0, 0.71, 0.29); // its F0, in shares of red
// The marked point: its normal is theta_v from the eye, to the left; the light stands theta_l from that normal.
vec3 marked_normal() {
    return vec3(-sin(theta_v), -cos(theta_v), 0.0);
}

vec3 light() {
    vec3 to_eye = vec3(cos(theta_v), -sin(theta_v), 0.0);
    return cos(theta_l) * marked_normal() + sin(theta_l) * (cos(phi) * to_eye + vec3(0.0, 0.0, sin(phi)));
}

vec3 ball_centre(int surface) {
    return surface == 0 ? vec3(-0.62, 0.0, 0.0) : vec3(2.05, 0.0, 3.26 - 1.32 * float(surface));
}

vec3 surface_point(int surface, vec2 s) {
    if (surface == 5) return vec3(1.4 + 1.3 * s.x, 0.7, -2.67 + 1.3 * s.y);
    return cap_to_eye(s, ball_centre(surface), surface == 0 ? LARGE : SMALL);
}

vec4 surface_value(int surface, vec2 s) { return vec4(light(), 0.0); }

vec3 shade(Surface s) {
    float scale = prefactor == 1 ? 4.0 / PI : 1.0;
    if (s.id == 5) return vec3(0.42);
    vec3 n = ball_normal((s.position - ball_centre(s.id)) / (s.id == 0 ? LARGE : SMALL), s.v);
    float n_dot_v = max(dot(n, s.v), 1e-3);
    if (s.id == 4) return vec3(0.42 * scale * furnace_beckmann(n_dot_v, m));
    vec3 l = s.value.xyz, both = l + s.v, h = both / max(length(both), 1e-6);
    float n_dot_l = dot(n, l), l_dot_h = 0.5 * length(both);
    vec3 shadow = palette[COLOUR_QUIET] * (0.02 + 0.06 * n_dot_v); // to be seen, no light
    if (n_dot_l <= 0.0) return shadow;
    if (s.id == 1) return shadow + palette[COLOUR_D] * (d_beckmann(n, both, m) * PI * m * m);
    if (s.id == 2) return shadow + palette[COLOUR_G] * g_vgroove(max(dot(n, h), 0.0), n_dot_v, n_dot_l, l_dot_h);
    float x = max(0.0, 1.0 - l_dot_h), x5 = x * x * x * x * x;
    vec3 f = f0 * GOLD + (1.0 - f0 * GOLD) * x5;
    if (s.id == 3) return f;
    float exposure = 4.0 * PI * m * m / (1.0 + 1.5 * m * m * m * m); // a head-on highlight of a smooth ball shows F0
    return shadow + exposure * scale * cook_torrance_dg(n, l, s.v, m) * n_dot_l * f;
}

vec3 mark_point(int mark, float t) {
    vec3 n = marked_normal(), from = ball_centre(0) + LARGE * n, h = light() + vec3(0.0, -1.0, 0.0);
    if (mark == 0) return from + 0.75 * t * n;
    if (mark == 1) return from + 0.95 * t * light();
    if (mark == 2) return from + vec3(0.0, -0.9 * t, 0.0);
    return from + 0.75 * t * h / max(length(h), 1e-6);
}

vec4 probe(int i) {
    if (i < 2) return vec4(mark_point(1, 1.0 - float(i)), 1.0);
    return vec4(ball_centre(i - 1) + vec3(i == 5 ? -1.3 : -0.78, 0.0, 0.0), 1.0);
}
""",
        surfaces=(Surface("ball", cells=(64, 3)), *(Surface(name, cells=(40, 3)) for name in "DGF"),
                  Surface("in the furnace", cells=(40, 3)), Surface("furnace", cells=(1, 1))),
        marks=(
            Mark("normal", colour="n", tip="arrow", label="n"), Mark("to the light", colour="l", tip="sun", label="l"),
            Mark("to the eye", colour="v", tip="eye", label="v"), Mark("halfway", colour="h", line="dashed", tip="arrow", label="h"),
        ),
        labels=(Label("D", 2, "d"), Label("G", 3, "g"), Label("F", 4, "f"), Label("furnace", 5)),
        handles=(Handle("the lamp", 0, ("theta_l", "phi")), Handle("the point", 1, ("theta_v",))),
        camera=Camera(azimuth=-90, elevation=0, distance=30, target=(0.1, 0.0, -0.05), field_of_view=11),
    ),
    plot=(
        Curves(
            title="Share of the light sent back, F = 1",
            sweep="theta_v",
            curves=(Curve("1/4", Term("albedo_cook_torrance", {"f0": 1.0})),
                    Curve("1/π, as printed", Term("albedo_cook_torrance_printed", {"f0": 1.0}), role="printed")),
            y_label="albedo",
        ),
        Lobes(title="Where the light of l goes"),
        Slice(title="The same, in the plane of l and n", kind="angle"),
        ImageSlice(title="All pairs, by the angles of h and l"),
    ),
    models=(Model("1/4", Term("brdf_cook_torrance")),
            Model("1/π, as printed", Term("brdf_cook_torrance_printed"), colour="printed")),
    readouts=(
        Readout("f, with 1/4", Term("brdf_cook_torrance"), role="exact", unit="1/sr"),
        Readout("f, as printed", Term("brdf_cook_torrance_printed"), role="printed", unit="1/sr", against="f, with 1/4"),
        Readout("albedo, F = 1", Term("albedo_cook_torrance", {"f0": 1.0}), role="exact", unit=""),
        Readout("albedo as printed", Term("albedo_cook_torrance_printed", {"f0": 1.0}), role="printed", unit="",
                against="albedo, F = 1"),
    ),
    ask=Prediction(
        question="A very rough metal, m = 1, and facets that reflect all. The eye looks straight down. What share of the "
                 "light does the formula, with its 1/4, send back?",
        truth=Term("albedo_cook_torrance", {"theta_v": 0.0, "m": 1.0, "f0": 1.0}),
        unit="of it", low=0.0, high=2.0,
        sets={"m": 1.0, "theta_v": 0.0, "prefactor": 0},
        told="0.45. The rest meets a second facet, and the formula drops it. With 1/π it is 4/π times as much.",
    ),
    notes="""
Cover the large ball and build it from the three: D alone is the highlight, G alone a soft shadow at the rim, F alone the
only colour. Ask which factor m changes (D; a little G never) and which the metal changes (F). Then take the lamp round
to the back: the rim turns white on gold. The slip is old: Cook and Torrance print 1/π with a D that lacks its own π, so
theirs was four times too bright. A smooth plate, m = 0.1, gives 1.27 as printed and 1.000 with 1/4. At large m both lose
light, to second bounces. 6 minutes.
""",
    sources=("Deck, slides The Cook - Torrance Model (1) and (2)", "Cook & Torrance 1982", "Torrance & Sparrow 1967",
             "Walter et al. 2007: the half-vector's 4 l.h"),
    honesty="D is Beckmann's, G that of V-grooves, F Schlick's with gold's F0. The lamp is exposed for m, so that wide "
            "highlights show too. The ball in the furnace is summed over 72 facets, within 0.02; numbers are exact. Light "
            "that bounces twice is left out.",
    values=(Value("m", 0.3, low=0.05, high=1.0), Value("theta_l", 50.0, low=0.0, high=89.5),
            Value("theta_v", 30.0, low=0.0, high=89.5),
            Value("prefactor", 0, choices=("1/4, consistent", "as printed, 1/π")), Value("phi", 140.0, more=True),
            Value("f0", 0.95, more=True), Value("lobe_scale", 0, choices=("f", "f n·l", "log f"), more=True)),
    minutes=6,
)

DISTRIBUTION = Step(
    name="distribution",
    title="Counted facets become D",
    idea="D is how densely the facets' normals lie around a direction; it is normalised so that D times the cosine sums to 1.",
    slides=(DISTRIBUTION_TERM(1), DISTRIBUTION_TERM(2)),
    prose=r"""
Every dot is the normal of one of 2000 facets. Count those in the $\colour{l}{\text{ring}}$ at the angle $a$, divide by all,
and by the ring's size seen from above: that is $\colour{d}{D(a)}$, a **density per steradian**. The bars are counted, the
line is a [formula](code:d_at).

Seen from above, the facets cover the plate once, neither more nor less:

$$\int \colour{d}{D}\,\cos a\; d\omega = 1$$

Any bell may serve: [Gauss](?ndf=0), the [cosine lobe](?ndf=1), or, beyond the deck, [GGX](?ndf=3&m=0.15) with its long
tails. Each needs *its own* constant. The $f_n$ of the Blinn-Phong BRDF is another one; here it would lose most of the
plate. Make it [smooth](?m=0.1): the dashed line is $D = 1$.
""",
    scene=Scene(
        glsl="""
#include "optics/ndf.glsl"
#include "optics/facets.glsl"
#include "display/look.glsl"
uniform float m;
uniform float theta_h;
uniform int ndf;
uniform int rows;

const int FACETS = 2000;
const int MOST = 64; // bars
const float RADIUS = 1.3;
const vec3 DOME = vec3(0.75, 0.0, 0.2);
const float HALF = 0.0218166; // of the ring, 1.25 degrees
const vec3 CORNER = vec3(-2.1, 0.0, -2.15);
const vec2 BOX = vec2(4.2, 1.75);

vec3 in_box(float angle, float d) {
    return CORNER + vec3(BOX.x * angle / (0.5 * PI), -0.02, BOX.y * min(d * PI * m * m, 1.3) / 1.3);
}

// How many facets lean by less than an angle: they stand in order.
float counted_within(float angle) {
    return floor(float(FACETS) * beckmann_within(angle, m) + 0.5);
}

float counted_density(float low, float high) {
    return (counted_within(high) - counted_within(low)) / (float(FACETS) * PI * sin(high - low) * sin(high + low));
}

vec3 surface_point(int surface, vec2 s) {
    if (surface == 0) return DOME + RADIUS * vec3(sqrt(s.y) * cos(2.0 * PI * s.x), sqrt(s.y) * sin(2.0 * PI * s.x), 0.0);
    if (surface == 1) return DOME + RADIUS * direction(max(0.0, theta_h + HALF * (2.0 * s.y - 1.0)), 2.0 * PI * s.x);
    float high = min(theta_h + HALF, 0.5 * PI), low = max(0.0, theta_h - HALF);
    if (surface == 3) return in_box(mix(low, high, s.x), s.y * counted_density(low, high)) - vec3(0.0, 0.01, 0.0);
    int column = int(s.x * float(2 * MOST - 1) + 0.5), bar = min(column / 2, rows - 1), side = column / 2 < rows ? column % 2 : 1;
    float wide = 0.5 * PI / float(rows), from = float(bar) * wide;
    return in_box(from + wide * float(side), s.y * counted_density(from, from + wide));
}

vec3 shade(Surface s) {
    if (s.id == 0) return mix(background, palette[COLOUR_QUIET], 0.25 + 0.25 * grid_lines(s.st, vec2(24.0, 1.0)));
    if (s.id == 1 || s.id == 3) return palette[COLOUR_L];
    float bar = fract((s.position.x - CORNER.x) / BOX.x * float(rows)), edge = min(bar, 1.0 - bar);
    return palette[COLOUR_D] * mix(0.25, 0.75, smoothstep(0.02, 0.08, edge));
}

vec3 dot_point(int i) {
    return DOME + RADIUS * facet_normal(i, m, FACETS);
}

vec4 dot_colour(int i) {
    float off = abs(arctan2(facet_slope(i, m, FACETS), 1.0) - theta_h);
    return vec4(off <= HALF ? palette[COLOUR_L] : palette[COLOUR_D], 1.0);
}

vec3 mark_point(int mark, float t) {
    if (mark == 0) return DOME + (RADIUS + 0.35) * t * vec3(0.0, 0.0, 1.0);
    if (mark == 1) return DOME + (RADIUS + 0.3) * t * direction(theta_h, 0.0);
    if (mark == 2) return in_box(0.5 * PI * t, 1.0);
    if (mark == 3) return in_box(0.5 * PI * t, 0.0);
    if (mark == 8) return DOME + RADIUS * vec3(-cos(PI * t), 0.0, sin(PI * t));
    int which = mark == 4 ? ndf : (ndf + mark - 4) % 4;
    return in_box(0.5 * PI * t, d_at(which, 0.5 * PI * t, m)) - vec3(0.0, mark == 4 ? 0.02 : 0.01, 0.0);
}

vec4 probe(int i) {
    if (i == 0) return vec4(DOME + (RADIUS + 0.3) * direction(theta_h, 0.0), 1.0);
    if (i == 1) return vec4(in_box(theta_h, d_at(ndf, theta_h, m)), 1.0);
    if (i == 2) return vec4(CORNER + vec3(0.0, 0.0, -0.16), 1.0);
    return vec4(CORNER + vec3(BOX.x, 0.0, -0.16), 1.0);
}
""",
        surfaces=(Surface("plate", cells=(64, 1)), Surface("ring", cells=(96, 1), opacity=0.45),
                  Surface("bars", cells=(127, 1)), Surface("counted here", cells=(1, 1))),
        marks=(
            Mark("normal", colour="n", tip="arrow", label="n"),
            Mark("halfway", colour="h", line="dashed", tip="arrow", label="a", label_at=0.9),
            Mark("one", colour="exact", line="dashed", label="D = 1", label_at=1.0),
            Mark("floor", colour="quiet"), Mark("chosen", colour="exact", segments=160, width=1.6),
            *(Mark(f"other {i}", colour="quiet", line="dotted", segments=160) for i in range(3)),
            Mark("dome", colour="quiet", segments=64),
        ),
        dots=Dots(count=2000, size=0.75),
        labels=(Label("0°", 2), Label("a = 90°", 3)),
        handles=(Handle("the angle", 0, ("theta_h",)), Handle("the place on the curve", 1, ("theta_h",))),
        legend=(("d", "facets, counted"), ("l", "in the ring"), ("exact", "formula")),
        camera=Camera(azimuth=-90, elevation=12, distance=40, target=(0.1, 0.0, -0.25), field_of_view=7.4),
    ),
    plot=Curves(
        title="Sum of D cos a over the rings",
        sweep="rows",
        curves=(*(Curve(name, Term("facet_area", {"ndf": k, "cosines": 1}), role)
                  for name, k, role in (("Beckmann", 2, "exact"), ("Gauss", 0, "estimate"), ("GGX", 3, "estimate"))),
                Curve("cosine lobe with f_n", Term("facet_area_of_lobe"), role="printed")),
        y_label="facets found, over all",
    ),
    readouts=(
        Readout("D(a) by the formula", Term("d_at"), role="exact", unit="1/sr"),
        Readout("counted, ±1.25°", Term("d_counted", {"half_angle": 0.0218166, "facets": 2000}), role="estimate",
                unit="1/sr", against="D(a) by the formula"),
        Readout("sum of D cos a", Term("facet_area", {"cosines": 1}), unit=""),
        Readout("the lobe's sum with f_n", Term("facet_area_of_lobe"), role="printed", unit=""),
    ),
    ask=Prediction(
        question="D is called a probability. A plate has m = 0.1. How large is D for facets that do not lean at all?",
        truth=Term("d_at", {"ndf": 2, "theta_h": 0.0, "m": 0.1}),
        unit="1/sr",
        choices=(Choice("at most 1: it is a probability", 0.0, 1.0), Choice("a little more than 1", 1.0, 4.0),
                 Choice("about 30", 4.0, 100.0), Choice("infinite", 1e6, 1e30)),
        sets={"m": 0.1, "theta_h": 0.0, "ndf": 2},
        told="31.8 per steradian, 1/(π m²). A density may be as large as it likes where it is narrow; only its integral is 1.",
    ),
    notes="""
Start with the deck's example, three facets of 21, and ask what 3/21 is measured in. It is a share, and a share of which
range of angles? Only divided by the ring's size does it become D. Move the ring out: the dots get rarer, the ring longer.
Then the prediction. The common wrong answer is 1, because the slide says probability; it says normalised too, and that is
the cosine integral. Set the rings to 4 and watch the sum miss 1: a sum must know the scale of what it sums. With f_n at
exponent 10 (m = 0.408) only 0.349 of the plate is there. 7 minutes.
""",
    sources=("Deck, slides Distribution Term (1) and (2)", "Beckmann & Spizzichino 1963", "Blinn 1977",
             "Walter et al. 2007; Trowbridge & Reitz 1975: GGX"),
    honesty="The facets' slopes are Beckmann's: a surface of random Gaussian heights, so only that formula fits the bars. They "
            "are evenly drawn, not by chance; counting still errs where a ring holds few. Gauss's constant is a quadrature.",
    values=(Value("m", 0.35, low=0.08, high=0.65), Value("theta_h", 20.0, low=0.0, high=85.0),
            Value("ndf", 2, choices=("Gauss", "cosine lobe", "Beckmann", "GGX")), Value("rows", 36, low=2, high=64)),
    minutes=7,
)

BECKMANN = Step(
    name="beckmann",
    title="Caution with near zero values",
    idea="A formula can be right and still lose all its digits: the square of a tangent wants no 1 - cos².",
    slides=(DISTRIBUTION_TERM(3),),
    prose=r"""
Beckmann's $D$ in the deck's two ways, and a third, through a **magnifier**: each disk is a highlight from
$-3m$ to $3m$, computed by your graphics card in float32.

$$D = \frac{e^{-\tan^2 a/m^2}}{\pi m^2 \cos^4 a}$$

The $\colour{lost}{\text{expensive}}$ [way](code:d_beckmann_acos_naive) takes $a = \arccos(n\cdot h)$. The $\colour{printed}{\text{fast}}$ [one](code:d_beckmann_naive) takes
$\tan^2 a = (1-\cos^2 a)/\cos^2 a$. Both begin with a cosine near 1, and the angle sits in the digits that are not there.
Polish: [0.01](?m=0.01), [0.001](?m=0.001), [0.0002](?m=0.0002).

The $\colour{exact}{\text{stable}}$ [one](code:d_beckmann) never asks for the cosine: $\tan^2 a = |n\times h|^2/(n\cdot h)^2$.

Our copy of the slide also lacks the minus: the $\colour{r}{\text{dash-dotted}}$ line.
""",
    scene=Scene(
        glsl="""
#include "optics/beckmann.glsl"
#include "display/palette.glsl"
uniform float m;
uniform float slope_ratio;

const float APART = 2.15;
const float WIDE = 1.9; // of a box, six m
const float TALL = 1.62; // of the peak
const float FLOOR = -2.35;

// The middle of window 0 stable, 1 fast, 2 expensive
vec3 window(int i) {
    return vec3(APART * float(i - 1), 0.0, 1.35);
}

float density(int way, vec2 x) { // over its peak
    vec3 n = vec3(0.0, 0.0, 1.0), h = vec3(x * m, 1.0) * inversesqrt(1.0 + dot(x * m, x * m));
    float d = way == 0 ? d_beckmann(n, h, m) : way == 1 ? d_beckmann_naive(n, h, m) : d_beckmann_acos_naive(n, h, m);
    return d * PI * m * m;
}

vec3 in_box(int way, float x, float height) {
    return vec3(window(way).x + x * WIDE / 6.0, -0.02, FLOOR + TALL * clamp(height, 0.0, 1.5));
}

vec3 surface_point(int surface, vec2 s) {
    return window(surface) + vec3(1.0, 0.0, 0.0) * (2.0 * s.x - 1.0) + vec3(0.0, 0.0, 2.0 * s.y - 1.0);
}

vec3 shade(Surface s) {
    vec2 x = 2.0 * s.st - 1.0;
    float r = length(x);
    if (r > 1.0) discard;
    if (r > 0.96) return palette[COLOUR_QUIET];
    return colormap(density(s.id, 3.0 * x / 0.96));
}

vec3 mark_point(int mark, float t) {
    float x = 6.0 * t - 3.0;
    if (mark < 3) return in_box(mark, x, density(0, vec2(x, 0.0)));
    if (mark < 5) return in_box(mark - 2, x, density(mark - 2, vec2(x, 0.0))) - vec3(0.0, 0.02, 0.0);
    if (mark < 8) return in_box(mark - 5, x, 0.0);
    x *= 0.17;
    if (mark == 8) return in_box(1, x, exp(x * x) * (1.0 + x * x * m * m) * (1.0 + x * x * m * m));
    return mark == 9 ? in_box(0, slope_ratio, t * density(0, vec2(slope_ratio, 0.0))) : in_box(mark - 9, slope_ratio, t * 1.1);
}

vec4 probe(int i) {
    if (i == 0) return vec4(in_box(0, slope_ratio, density(0, vec2(slope_ratio, 0.0))), 1.0);
    if (i < 4) return vec4(window(i - 1) + vec3(0.0, 0.0, 1.2), 1.0);
    return vec4(in_box(1, 0.0, 0.0) - vec3(0.0, 0.0, 0.2), 1.0);
}
""",
        surfaces=(Surface("stable", cells=(1, 1)), Surface("fast", cells=(1, 1)), Surface("expensive", cells=(1, 1))),
        marks=(
            *(Mark(f"right {i}", colour="exact", segments=120, width=1.3) for i in range(3)),
            Mark("fast", colour="printed", segments=240, width=1.3), Mark("expensive", colour="lost", segments=240, width=1.3),
            *(Mark(f"floor {i}", colour="quiet") for i in range(3)),
            Mark("no minus", colour="r", line="dashdot", segments=60, label="no minus"),
            *(Mark(f"here {i}", colour="h", line="dashed") for i in range(3)),
        ),
        labels=(Label("stable", 1), Label("fast", 2, "printed"), Label("expensive", 3, "lost"),
                Label("slopes, −3m to 3m", 4)),
        handles=(Handle("the facet", 0, ("slope_ratio",)),),
        camera=Camera(azimuth=-90, elevation=0, distance=24, target=(0.0, 0.0, 0.0), field_of_view=15.5),
    ),
    plot=Curves(
        title="Error in float32 against m",
        sweep="m",
        curves=(Curve("exact", Term("d_beside")), Curve("stable", Term("d_beside"), role="estimate", precision="float32"),
                Curve("fast", Term("d_beside_naive"), role="printed", precision="float32"),
                Curve("expensive", Term("d_beside_acos_naive"), role="printed", precision="float32")),
        y_label="relative error", y_scale="log",
        error=True,
    ),
    readouts=(
        Readout("D, exact", Term("d_beside"), role="exact", unit="1/sr"),
        Readout("stable, float32", Term("d_beside"), role="estimate", precision="float32", unit="1/sr", against="D, exact"),
        Readout("fast, float32", Term("d_beside_naive"), role="printed", precision="float32", unit="1/sr",
                against="D, exact"),
        Readout("float32 numbers from cos a to 1", Term("cosine_steps"), unit=""),
    ),
    ask=Prediction(
        question="A polished metal, m = 0.001, and a facet that leans by m. How many float32 numbers are there between the "
                 "cosine of its angle and 1?",
        truth=Term("cosine_steps", {"slope_ratio": 1.0, "m": 0.001}),
        unit="numbers", low=1.0, high=1e7,
        scale="log",
        sets={"m": 0.001, "slope_ratio": 1.0},
        told="8. The whole highlight, out to one m, has eight cosines to choose from; you can count them as rings.",
    ),
    notes="""
Begin at m = 0.3, where all three agree, and let them bet on which will fail first. Then polish. At 0.01 the curves are
slightly torn, at 0.001 you count rings, at 0.0002 the fast one has one or two steps left. Nothing is wrong with the
algebra: it is the subtraction 1 - cos². The expensive form fails alike, for acos has the same eight numbers to start from.
The lesson carries over to Fresnel, solid angle and Smith. The lost minus: at m = 0.1 and 10° it turns 1.51 into 758 per
steradian, and the integral diverges; ask how one would notice in a picture. 6 minutes.
""",
    sources=("Deck, slide Distribution Term (3)", "Beckmann & Spizzichino 1963", "Kahan 2006; Guy & Agopian 2018 (Filament): "
             "the cross product", "IEEE 754-2019"),
    honesty="Disks and curves are the card's own float32, n = +z; with any other n all forms also carry the rounding of n and h "
            "themselves, 1e-4 of D at m = 0.0001. 'Exact' is float64 of the stable form. Exposure: each at its peak.",
    values=(Value("m", 0.0007, low=1e-5, high=1.0), Value("slope_ratio", 0.8, low=-3.0, high=3.0)),
    minutes=6,
)

BECKMANN_ONLY = Step(
    name="beckmann_only",
    title="Nothing but the highlight",
    idea="D alone already makes metal; m is its width in slope, and 2/m² - 2 the exponent of an equally wide cosine lobe.",
    slides=(DISTRIBUTION_TERM(4),),
    prose=r"""
The deck's picture: no $F$, no $G$, [only](code:d_lean) $n\cdot l$ and $\colour{d}{D}$. Yet it reads as metal. The row goes from polished to
rough; the large ball takes your $m$, its left half by Beckmann, its right half by the cosine lobe $\cos^n a$ of **equal
width**:

$$n = \frac{2}{m^2} - 2$$

Exponents are hard to feel: from [8](?m=0.4472) to [98](?m=0.1414) is the same step in the picture as from there to
[998](?m=0.04472), for $m$ is divided by the same. And $m$ has a meaning you can measure: the facets' RMS slope.

For small $m$ both halves agree. For [rough ones](?m=0.8) Beckmann bends: the seam shows. With
[one exposure for all](?exposed=1) you see what normalising does: the light that spreads gets dim.
""",
    scene=Scene(
        glsl="""
#include "optics/beckmann.glsl"
#include "optics/ndf.glsl"
#include "display/balls.glsl"
#include "display/palette.glsl"
uniform float m, theta_l;
uniform int exposed;

const vec3 MIDDLE = vec3(0.0, 0.0, 0.85); // of the large ball, number 0

vec3 centre(int ball) {
    return ball == 0 ? MIDDLE : vec3(1.25 * float(ball - 3), 0.0, -1.75);
}

float size(int ball) {
    return ball == 0 ? 1.75 : 0.56;
}

// From the eye, upwards
vec3 light() {
    return vec3(0.0, -cos(theta_l), sin(theta_l));
}

vec3 surface_point(int surface, vec2 s) {
    return cap_to_eye(s, centre(surface), size(surface));
}

vec4 surface_value(int surface, vec2 s) { // to the light; the width: 0.08 to 0.8
    return vec4(light(), surface == 0 ? m : 0.08 * exp(0.5756 * float(surface - 1)));
}

vec3 shade(Surface s) {
    vec3 n = ball_normal((s.position - centre(s.id)) / size(s.id), s.v), l = s.value.xyz, h = l + s.v;
    float width = s.value.w, n_dot_l = max(dot(n, l), 0.0);
    float peak = exposed == 1 ? 1.0 / (PI * 0.3 * 0.3) : 1.0 / (PI * width * width);
    float d = s.id == 0 && n.x > 0.0 ? d_blinn_phong(n, h, exponent_from_m(width)) : d_beckmann(n, h, width);
    return vec3(1.0, 0.93, 0.80) * (n_dot_l * d / peak) + palette[COLOUR_QUIET] * (0.02 + 0.06 * max(dot(n, s.v), 0.0));
}

vec3 mark_point(int mark, float t) {
    if (mark == 0) return MIDDLE + (size(0) + 0.01) * vec3(0.0, -sin(PI * t), cos(PI * t));
    return MIDDLE + size(0) * vec3(0.0, -1.0, 0.0) + 1.2 * t * light();
}

vec4 probe(int i) {
    if (i == 0) return vec4(MIDDLE + size(0) * vec3(0.0, -1.0, 0.0) + 1.2 * light(), 1.0);
    if (i == 1) return vec4(MIDDLE + vec3(-1.75, 0.0, 1.55), 1.0);
    if (i == 2) return vec4(MIDDLE + vec3(1.75, 0.0, 1.55), 1.0);
    return vec4(centre(i - 2) + vec3(0.0, 0.0, -0.78), 1.0);
}
""",
        surfaces=tuple(Surface(f"ball {i}", cells=(40, 3) if i else (64, 3)) for i in range(6)),
        marks=(Mark("seam", colour="quiet", segments=48), Mark("to the light", colour="l", tip="sun", label="l")),
        labels=(Label("Beckmann", 1, "d"), Label("cosine lobe", 2, "printed"),
                *(Label(m, i + 3) for i, m in enumerate(("m = 0.08", "0.14", "0.25", "0.45", "0.8")))),
        handles=(Handle("the lamp", 0, ("theta_l",)),),
        camera=Camera(azimuth=-90, elevation=0, distance=30, target=(0.0, 0.0, -0.05), field_of_view=12),
    ),
    plot=Curves(
        title="Equally wide: Beckmann and cosine lobe",
        sweep="slope_ratio",
        curves=(Curve("Beckmann", Term("d_lean", {"ndf": 2})),
                Curve("cosine lobe", Term("d_lean", {"ndf": 1}), role="printed")),
        y_label="D in 1/sr", y_scale="log",
    ),
    readouts=(
        Readout("exponent of equal width", Term("exponent_from_m"), role="exact", unit=""),
        Readout("D at the peak", Term("d_lean", {"ndf": 2, "slope_ratio": 0.0}), role="exact", unit="1/sr"),
        Readout("D at slope x m", Term("d_lean", {"ndf": 2}), role="exact", unit="1/sr"),
        Readout("the lobe there", Term("d_lean", {"ndf": 1}), role="printed", unit="1/sr", against="D at slope x m"),
    ),
    ask=Prediction(
        question="An RMS slope of m = 0.1 is a brushed metal. Which exponent gives a cosine lobe of the same width?",
        truth=Term("exponent_from_m", {"m": 0.1}),
        unit="",
        low=1.0,
        high=10000.0,
        scale="log",
        sets={"m": 0.1},
        told="198. A tenth in slope is two hundred in the exponent; a hundredth would be 19998.",
    ),
    notes="""
Show the row first and ask for the materials: chrome, brushed steel, dull lead. Nobody misses F and G yet; that is the
point of the deck's picture, D does most of the work. Then the seam: at m = 0.2 it is invisible, at 0.8 plain. Ask which
half is right for a surface of random heights. Let somebody guess exponents for the five balls (310, 100, 30, 8, 1);
guesses are usually linear. With one exposure the polished ball burns out: same light, less room. 4 minutes.
""",
    sources=("Deck, slide Distribution Term (4)", "Walter et al. 2007: n = 2/m² - 2", "Beckmann & Spizzichino 1963"),
    honesty="n.l times D, as the deck says: no BRDF, no units. Each ball is exposed to its own peak, or all as m = 0.3.",
    values=(Value("m", 0.3, low=0.03, high=1.0), Value("theta_l", 45.0, low=0.0, high=90.0),
            Value("exposed", 0, choices=("each at its peak", "all alike")),
            Value("slope_ratio", 2.0, low=0.0, high=3.0, more=True)),
    minutes=4, breaks=(Break("h = l + v, not made a unit vector", {"d_beckmann": "d_beckmann_naive"}, {"m": 0.3}, "The fast form reads cos a from n·h, and l + v is up to 2 long: the cosine passes 1, its tangent squared turns negative, and the exponential grows where it should fall. The cross product over the dot product does not ask how long h is. Know which of your formulas want unit vectors.", "D at the peak", Term("d_beckmann", {"n": (0.0, 0.0, 1.0), "h": (0.0, 0.0, 2.0)}), "1/sr"),),
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

D_PYTHON_STUB = '''import numpy as np


def d_beckmann(n, h, m):
    """Beckmann's distribution of facets. n, h: unit vectors (..., 3), m: (...)."""
    return np.zeros(np.broadcast_shapes(np.shape(n)[:-1], np.shape(h)[:-1], np.shape(m)))
'''
D_PYTHON_SOLUTION = '''import numpy as np


def d_beckmann(n, h, m):
    """tan^2 a by the cross product; half of the exponent twice, so that nothing leaves the range of floats."""
    n, h, m = (np.asarray(x, float) for x in (n, h, m))
    across, along = np.cross(n, h), np.sum(n * h, -1)
    towards = along > 0
    t = np.sum(across * across, -1) / np.where(towards, along, 1) ** 2
    root = np.exp(-0.5 * t / m**2) * (1 + t)
    return np.where(towards, root / (np.pi * m**2) * root, 0.0)
'''
D_GLSL_STUB = """float d_beckmann(vec3 n, vec3 h, float m) {
    return 0.0;
}
"""
D_GLSL_SOLUTION = """float d_beckmann(vec3 n, vec3 h, float m) {
    vec3 across = cross(n, h);
    float along = dot(n, h);
    if (along <= 0.0) return 0.0;
    float t = dot(across, across) / (along * along);
    float root = exp(-0.5 * t / m / m) * (1.0 + t);
    return root / (3.14159265 * m * m) * root;
}
"""
UP = (0.0, 0.0, 1.0)

CHAPTER = Chapter(
    title="Microfacets",
    idea="A rough surface is many small mirrors: count those that face h, take away those that are blocked.",
    steps=(GROOVES, FACETS, BLOCKING, INTERREFLECTIONS, COOK_TORRANCE, DISTRIBUTION, BECKMANN, BECKMANN_ONLY),
    exercises=(
        Exercise(
            name="groove",
            function="groove_open",
            task="Write the share of a facet that is both lit and seen, 2 n.m n.l / m.l and 2 n.m n.v / m.v, at most 1.",
            slide="Shadowing and Masking",
            stubs={"python": PYTHON_STUB, "glsl": GLSL_STUB},
            solutions={"python": PYTHON_SOLUTION, "glsl": GLSL_SOLUTION},
            checks=(
                Check({"facet": (0.0, 0.5, -0.4), "lean_l": (1.2, 0.1, 0.3), "lean_v": (-0.9, 0.2, 0.1)}, "nothing is in the way"),
                Check({"facet": (0.7, 0.7), "lean_l": (0.2, -0.1), "lean_v": (1.3, 1.4)}, "masked from the eye"),
                Check({"facet": (0.7, -0.9), "lean_l": (1.3, -1.2), "lean_v": (0.2, -0.3)}, "shadowed from the light"),
                Check({"facet": (0.8, 0.8), "lean_l": (1.2, 1.4), "lean_v": (1.4, 1.2)}, "both: one hides the other"),
                Check({"facet": (1.0, -1.0, 0.3), "lean_l": (-1.0, 0.2, -1.2), "lean_v": (0.1, 0.9, -1.0)}, "turned away", hidden=True),
            ),
        ),
        Exercise(
            name="beckmann",
            function="d_beckmann",
            task="Write Beckmann's distribution from n and h, so that it holds for m down to 0.0001. Do not use 1 - cos².",
            slide=DISTRIBUTION_TERM(3),
            stubs={"python": D_PYTHON_STUB, "glsl": D_GLSL_STUB},
            solutions={"python": D_PYTHON_SOLUTION, "glsl": D_GLSL_SOLUTION},
            checks=(
                Check({"n": (UP, UP, UP), "h": (UP, UP, UP), "m": (1.0, 0.3, 0.01)}, "the peak is 1 / (π m²)"),
                Check({"n": (UP, UP, UP), "h": ((0.6, 0.0, 0.8), (0.0, 0.28, 0.96), (0.48, -0.6, 0.64)),
                       "m": (0.5, 0.2, 0.8)}, "ordinary angles and roughness"),
                Check({"n": (UP, UP, UP), "h": (UP, (0.0, 0.6, -0.8), (1.0, 0.0, 0.0)), "m": (0.5, 0.5, 0.5)},
                      "0 for facets that look away or stand on edge"),
                Check({"n": (UP, UP, UP), "h": ((0.0009999995, 0.0, 0.9999995), (0.000699999325, -0.001199998842, 0.999999035001),
                                                (0.0002, 0.0001, 0.999999975)), "m": (0.001, 0.001, 0.0002)}, "polished"),
                Check({"n": ((0.6, 0.0, 0.8), (0.0, 0.28, 0.96)), "h": ((0.599903, 0.00015, 0.800073), (0.0001, 0.28, 0.96)),
                       "m": (0.0002, 0.0001)}, "polished and tilted", hidden=True),
            ),
        ),
    ),
    terms={
        "microfacet": "a flat piece of a rough surface, too small to be seen, that mirrors light one way only",
        "facet distribution D": "how densely the facets' normals lie around a direction, per steradian of them",
        "RMS slope m": "the root of the mean square of the facets' slopes: Beckmann's roughness",
        "V-groove": "two facets that lean to each other in a valley, the model of Torrance and Sparrow",
    },
)
