"""All of it together: lamps in lumens, matter that keeps its balance, and a picture that a camera could have taken.

This chapter sets the two models of the course side by side, follows one number from the lamp to the pixel, measures
light in a room, balances body and mirror, and asks what happens to a surface seen from far away.
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
    LeaveOut,
    Ledger,
    LedgerRow,
    Lobes,
    Mark,
    Model,
    Prediction,
    Readout,
    Scene,
    Slice,
    Step,
    Surface,
    Table,
    Term,
    Value,
)

PI = 3.141592653589793
PLAUSIBLE = "Plausible Shading – {}".format
COUPLINGS = ("added up", "1 − F(l·h)", "1 − F(n·l)", "in and out")

MATERIAL_NAMES = ("water", "plastic", "plastic, high", "ruby", "diamond", "gold", "silver", "copper", "iron", "aluminium")
RED = {"material": 2, "channel": 0}

COMPARE = Step(
    name="compare",
    title="Which is the photograph?",
    idea="Head-on both highlights look alike; with the lamp behind, only Cook-Torrance does what real things do.",
    slides=("Cook Torrance – Comparison (1)", "Cook Torrance – Comparison (2)"),
    prose=r"""
A metal vase, twice, and a plastic one, twice. Both models give it the same colour, and with the lamp
[beside the camera](?theta_d=5) highlights of the same width and peak. Now walk the $\colour{l}{\text{lamp}}$ [behind them](?theta_d=70).

**Blinn-Phong** keeps its colour and fades with $n\cdot l$. **Cook-Torrance** goes [the other way](code:brdf_matter): at the angle
$\theta$ its highlight is

$$\frac{\colour{f}{F}(\theta)}{\colour{f}{F_0}\,\cos\theta}$$

times the one head-on. Insulators win most: their $F$ has farthest to rise, so plastic in back light wears a bright white
edge. Metals whiten: [gold](?material=gold&theta_d=75), [copper](?material=copper&theta_d=75).

Cook and Torrance drew copper vases in 1982; until then copper came out as brown plastic. [Rougher ones](?m=0.4) part as
far: the quotient has no $m$.
""",
    scene=Scene(
        glsl="""
#include "optics/bounces.glsl"
#include "optics/matter.glsl"
#include "display/look.glsl"
#include "display/rough_room.glsl"
#include "display/vase.glsl"
uniform int material;
uniform float m;
uniform float theta_d;

const int PLASTIC = 2;

int row_of(int vase) { return vase % 2 == 0 ? material : PLASTIC; }
vec2 axis(int vase) { return vec2(1.28 * (float(vase) - 1.5) + (vase < 2 ? -0.06 : 0.06), 0.0); }

vec3 surface_point(int surface, vec2 s) {
    if (surface == 4) return vec3(6.2 * (s.x - 0.5), 1.7, 4.0 * s.y - 0.47);
    if (surface > 4) return vec3(5.6 * (s.x - 0.5), surface == 5 ? 1.4 * (s.y - 0.5) : -0.7, surface == 5 ? -0.002 : -0.12 * s.y);
    return vase_point(axis(surface), s);
}

const vec3 FRONT = vec3(0.0, -0.98768834, 0.15643447); // the eye, 9 degrees up
const vec3 ASIDE = vec3(-0.90630779, 0.06611152, 0.41741543); // at right angles to it: left, and 25 degrees up

vec3 lamp() { return cos(2.0 * theta_d) * FRONT + sin(2.0 * theta_d) * ASIDE; } // halfway it is theta_d from both

vec4 surface_value(int surface, vec2 s) {
    if (surface > 3) return vec4(0.0);
    vec3 n = vase_normal(axis(surface), s), v = normalize(camera_position - vase_point(axis(surface), s));
    vec3 f = f_material(surface < 2 ? 1.0 : clamp(dot(n, v), 0.02, 1.0), row_of(surface));
    vec3 light = clamp(f, 0.0, 1.0) * rough_room(n, v, m, surface > 1);
    if (surface > 1) light += bounced_light(dot(n, lamp()), dot(n, v), m, row_of(surface), 8.0 * PI * m * m, 0.38); // the room's mean
    return vec4(light, 1.0);
}

vec3 shade(Surface s) {
    if (s.id == 4) return 0.55 * studio(-s.v);
    if (s.id > 4) return vec3(0.16, 0.13, 0.11) * (s.id == 5 ? 1.0 : 0.6);
    int row = row_of(s.id);
    vec3 n = vase_normal(axis(s.id), s.st), l = normalize(lamp()), light = max(s.value.rgb, 0.0);
    float n_dot_v = dot(n, s.v), n_dot_l = dot(n, l), f0 = f_dielectric(1.0, material_eta(row));
    bool cook = s.id > 1, lit = n_dot_l > 0.0;
    if (n_dot_v <= 0.0) return light;
    if (row < INSULATORS) {
        float left = cook ? 1.0 - f_dielectric(n_dot_v, material_eta(row)) : 1.0 - f0, in_out = 1.0 - f0;
        if (cook && lit) in_out = PI * body_coupled(n_dot_l, n_dot_v, 1.0, f0);
        light += left * 0.6 * soft_light(RED_BODY, n, s.v) + RED_BODY * (8.0 * m * m * in_out * max(n_dot_l, 0.0));
    }
    if (!lit) return light;
    float lobe = cook ? cook_torrance_dg(n, l, s.v, m)
                      : normalisation_blinn_phong(exponent_from_m(m)) * lobe_blinn(n, l, s.v, exponent_from_m(m));
    float u = cook ? 0.5 * length(l + s.v) : 1.0;
    return light + clamp(f_material(u, row), 0.0, 1.0) * (n_dot_l * lobe * 8.0 * PI * m * m); // 8 pi m^2 lx: a mirror's peak is 2
}

const vec3 TRACK = vec3(0.0, 0.0, 2.42);

vec3 mark_point(int mark, float t) { // the lamp goes around the vases
    if (mark == 0) return TRACK + 1.4 * t * lamp();
    if (mark == 1) return TRACK + 1.4 * t * FRONT;
    return TRACK + 1.4 * (cos(0.88888889 * PI * t) * FRONT + sin(0.88888889 * PI * t) * ASIDE); // theta_d up to 80 degrees
}

vec4 probe(int i) {
    if (i == 0) return vec4(mark_point(0, 1.0), 1.0);
    return vec4(i == 1 ? -1.75 : 0.85, -0.72, -0.36, 1.0);
}
""",
        surfaces=(*(Surface(name, cells=(20, 24)) for name in ("metal, Blinn-Phong", "plastic, Blinn-Phong",
                                                             "metal, Cook-Torrance", "plastic, Cook-Torrance")),
                  Surface("room", cells=(1, 1)), Surface("board", cells=(1, 1)), Surface("board's edge", cells=(1, 1))),
        marks=(Mark("to the lamp", colour="l", tip="sun", label="l"), Mark("to the eye", colour="v", tip="eye", label="v"),
               Mark("the lamp's way", colour="quiet", line="dotted", segments=48)),
        labels=(Label("Blinn-Phong", 1), Label("Cook-Torrance", 2)),
        handles=(Handle("the lamp", 0, ("theta_d",)),),
        camera=Camera(azimuth=-90, elevation=9, distance=16, target=(0.0, 0.0, 1.2), field_of_view=21),
    ),
    plot=Curves(
        title="The highlight, head-on being 1", sweep="theta_d",
        curves=(Curve("plastic, Cook-Torrance", Term("gain_cook_torrance", RED)),
                Curve("gold, blue", Term("gain_cook_torrance", {"material": 5, "channel": 2}), role="estimate"),
                Curve("gold, red", Term("gain_cook_torrance", {"material": 5, "channel": 0}), role="estimate", colour="#D55E00"),
                Curve("Blinn-Phong, any", Term("gain_blinn_phong"), role="printed")),
        y_label="times", y_scale="log",
    ),
    readouts=(
        Readout("plastic, gain", Term("gain_cook_torrance", RED), role="exact", unit=""),
        Readout("Blinn-Phong", Term("gain_blinn_phong"), role="printed", unit="", against="plastic, gain"),
        Readout("metal, red", Term("gain_cook_torrance", {"channel": 0}), unit=""),
        Readout("metal, blue", Term("gain_cook_torrance", {"channel": 2}), unit=""),
    ),
    models=(Model("Cook-Torrance", Term("brdf_matter", {"channel": 0}), "exact"),
            Model("Blinn-Phong", Term("brdf_matter_blinn", {"channel": 0}), "printed")),
    ask=Prediction(
        question="You photograph the red plastic vase, the lamp beside the camera, then behind the vase: light and eye stand 75° from "
                 "the highlight's normal. How bright is the highlight now?",
        truth=Term("gain_cook_torrance", RED | {"theta_d": 75 * PI / 180}),
        unit="times",
        choices=(Choice("a quarter: the light comes at a slant", 0.0, 0.6), Choice("as bright as before", 0.6, 2.0),
                 Choice("about four times as bright", 2.0, 8.0), Choice("about twenty times as bright", 8.0, 60.0)),
        sets={"theta_d": 75.0},
        told="20 times. The mirror's share rises from 0.05 to 0.27, and cos θ divides once more. Blinn-Phong: a quarter.",
    ),
    notes="""
Lamp beside the camera: by the highlights alone nobody can tell the pairs apart; what gives Blinn-Phong away is the room at the
metal's rims, too dark. Walk the lamp behind and ask which vase of each pair they have seen in real life. Then the plot: at 75° two models with the same coefficients differ 77 times. Ask why
insulators gain more than metals (a metal already reflects all it can), and why gold turns paler (blue
gains more than red). The tempting answer is a quarter: the cosine is right, but the same cosine makes the facets look denser, twice: by
n.l and n.v. Blinn-Phong can be tuned for one photograph, not for two. 6 minutes.
""",
    sources=("Deck, slides Cook Torrance - Comparison (1) and (2)", "Cook & Torrance 1982: the vases", "Johnson & Christy 1972, 1974; "
             "Rakic 1995; Sultanova 2009: indices"),
    honesty="The lamp's light is exact per pixel: measured F, V-grooves, the body coupled in and out; Blinn-Phong has the same "
            "F₀, the exponent 2/m² - 2. The rougher, the stronger the lamp: peaks stay alike. The room is a look, mirrored in 20 "
            "facets per corner. θ is meant for the first view. Second bounces: a fit, with an even room. No shadows.",
    values=(Value("theta_d", 62.0, low=0.0, high=80.0), Value("m", 0.2, low=0.08, high=0.5), Value("material", 7, choices=MATERIAL_NAMES, more=True)),
    leave_outs=(LeaveOut("the twelve wavelengths of F", Term("schlick_worst"), 0.05, "Schlick's fit",
                         without={"f_material": "f_material_schlick"}, of="of the light"),
                LeaveOut("G in the lamp's light", Term("cook_torrance_open_error"), 1e-3, "All facets open",
                         without={"cook_torrance_dg": "cook_torrance_open"}, of="of the highlight"),
                LeaveOut("second bounces", Term("bounced_light_error"), 1e-2, "One bounce",
                         without={"bounced_light": "bounced_light_none"}, of="of the light")),
    minutes=6,
)

CURVES = ("cut at 1", "Reinhard", "ACES fit")
HALVED = {"luminous_flux": 400.0, "distance": 0.8, "ev100": 4.4, "curve": 0}

QUANTITIES = Step(
    name="quantities",
    title="One number, from the lamp to the pixel",
    idea="From the lamp's lumens to the number in a file a value is converted six times; up to the sensor its unit says by what.",
    slides=("Working with Shading Models",),
    prose=r"""
A renderer carries one number a long way. Here the lamp is in **lumens**, the picture is what a camera makes of the room,
and the ledger shows every stop:

$$\text{lm} \to \text{cd} \to \text{lx} \xrightarrow{\times f_s} \text{cd/m}^2 \xrightarrow{\div 1.2\cdot 2^{EV}}
\text{sensor} \to \text{screen} \to 0\dots255$$

Up to cd/m² it is **physics**, and your BRDF is one factor in it. Then the camera: its *exposure* says which luminance fills
the sensor. One [EV more](?ev100=6) halves the light.

The evening outside is far brighter than the desk. [Cut at 1](?curve=0&ev100=4) loses it; a **tone curve** like
[Reinhard's](?curve=1&ev100=4) or the [ACES fit](?curve=2&ev100=4) bends instead. Last, sRGB stores about the square root: dark
steps get more numbers. Never light with stored numbers: decode first.
""",
    scene=Scene(
        glsl="""
#include "optics/exposure.glsl"
#include "display/balls.glsl"
uniform float luminous_flux;
uniform float distance;
uniform float ev100;
uniform int curve;
uniform float rho;

const vec3 UNDER = vec3(-0.25, 0.0, 0.0); // the card's middle, straight under the lamp
const vec3 BALL = vec3(0.62, 0.02, 0.2);
const float GLOBE = 0.05;

vec3 lamp() { return UNDER + vec3(0.0, 0.0, distance); }

vec3 surface_point(int surface, vec2 s) {
    if (surface == 0) return vec3(2.8 * s.x - 1.4, 1.4 * s.y - 0.5, 0.0);
    if (surface == 1) return vec3(2.8 * s.x - 1.4, 0.9, 1.85 * s.y);
    if (surface == 2) return UNDER + vec3(0.93 * s.x - 0.465, 0.5 * s.y - 0.25, 0.004);
    if (surface == 3) return cap_to_eye(s, BALL, 0.2);
    return cap_to_eye(s, lamp(), GLOBE);
}

vec3 evening(float up) { // cd/m^2, set: hills below a sky that gets darker upwards
    vec3 sky = mix(vec3(130.0, 72.0, 34.0), vec3(15.0, 28.0, 62.0), smoothstep(0.2, 0.8, up));
    return up < 0.27 ? vec3(2.0, 3.0, 2.8) : sky;
}

vec3 luminance(Surface s) { // of each channel, white having the same in all
    float candela = luminous_intensity_isotropic(luminous_flux);
    if (s.id == 4) return vec3(1.0, 0.86, 0.66) * candela / (PI * GLOBE * GLOBE);
    vec3 n = vec3(0.0, s.id == 1 ? -1.0 : 0.0, s.id == 1 ? 0.0 : 1.0);
    if (s.id == 3) n = ball_normal((s.position - BALL) / 0.2, s.v);
    vec3 matt = s.id == 0 ? vec3(0.42, 0.26, 0.15) : s.id == 1 ? vec3(0.42, 0.44, 0.40) : vec3(0.62, 0.09, 0.06);
    if (s.id == 1) {
        vec2 at = (s.position.xz - vec2(0.35, 0.75)) / vec2(0.85, 0.95), pane = abs(at - 0.5);
        if (min(pane.x, pane.y) > 0.015 && max(pane.x, pane.y) < 0.475) return evening(at.y);
        if (max(pane.x, pane.y) < 0.5) matt = vec3(0.7);
    }
    if (s.id == 2) matt = vec3(s.st.x < 0.333 ? 0.18 : s.st.x > 0.667 ? 0.04 : rho);
    vec3 to_lamp = lamp() - s.position;
    float r2 = dot(to_lamp, to_lamp), lux = candela * max(dot(n, to_lamp), 0.0) / (r2 * sqrt(r2));
    return matt * (lux / PI);
}

vec3 shade(Surface s) {
    vec3 x = luminance(s) / luminance_white(ev100);
    return vec3(tone_curve(x.r, curve), tone_curve(x.g, curve), tone_curve(x.b, curve));
}

vec3 mark_point(int mark, float t) {
    if (mark == 0) return lamp() + vec3(0.0, 0.0, GLOBE + (1.8 - distance) * t);
    vec3 card = UNDER + vec3(0.0, 0.0, 0.01);
    if (mark == 1) return mix(card, lamp(), 0.93 * t);
    return card + 0.62 * t * vec3(0.55, -0.52, 0.65);
}

vec4 probe(int i) {
    if (i == 0) return vec4(lamp(), 1.0);
    if (i == 1) return vec4(lamp() + vec3(-0.3, 0.0, 0.02), 1.0);
    if (i == 2) return vec4(UNDER + vec3(-0.2, 0.0, 0.55 * distance), 1.0);
    if (i == 3) return vec4(UNDER + vec3(-0.72, -0.1, 0.02), 1.0);
    return vec4(UNDER + vec3(0.42, -0.33, 0.56), 1.0);
}
""",
        surfaces=(Surface("desk", cells=(1, 1)), Surface("wall", cells=(1, 1)), Surface("card", cells=(1, 1)),
                  Surface("ball", cells=(40, 2)), Surface("lamp", cells=(24, 2))),
        marks=(Mark("cable", colour="quiet"), Mark("light", colour="l", line="dashed", tip="sun"),
               Mark("to the camera", colour="v", tip="eye")),
        labels=(Label("lm", 1, "l"), Label("cd", 2, "l"), Label("lx", 3), Label("cd/m²", 4, "v")),
        handles=(Handle("the lamp", 0, ("distance",)),),
        camera=Camera(azimuth=-90, elevation=19, distance=6.2, target=(0.0, 0.0, 0.77), field_of_view=20),
    ),
    plot=(
        Ledger(
            title="White card and grey card",
            columns=tuple((
                LedgerRow("lamp", Term("lamp_flux", {"globe": 0}), "lm"),
                LedgerRow("intensity", Term("luminous_intensity_isotropic"), "cd", "1/sr"),
                LedgerRow("illuminance", Term("illuminance_isotropic", {"theta": 0.0}), "lx", "sr/m^2"),
                LedgerRow(name, Term("card_luminance", {"rho": share}), "cd/m^2", "1/sr", "BRDF"),
                LedgerRow("on the sensor", Term("card_exposed", {"rho": share}), "", "m^2/cd", "exposure"),
                LedgerRow("of the screen's white", Term("card_toned", {"rho": share}), "", "", "tone curve"),
                LedgerRow("stored", Term("card_stored", {"rho": share}), "", "", "sRGB, 8 bits"),
            ) for name, share in (("white card", "rho"), ("grey card", 0.18))),
        ),
        Curves(
            title="The white card's number against the lamp", sweep="luminous_flux",
            curves=(Curve("cut at 1", Term("card_stored", {"curve": 0})),
                    Curve("Reinhard", Term("card_stored", {"curve": 1}), role="estimate"),
                    Curve("ACES fit", Term("card_stored", {"curve": 2}), role="estimate", colour="#CC79A7")),
            y_label="stored, of 255",
        ),
    ),
    readouts=(
        Readout("white card", Term("card_luminance"), unit="cd/m²"),
        Readout("fills the sensor", Term("luminance_white"), unit="cd/m²"),
        Readout("white card, stored", Term("card_stored"), unit="of 255"),
        Readout("grey card, stored", Term("card_stored", {"rho": 0.18}), unit="of 255"),
    ),
    ask=Prediction(
        question="A lamp of 800 lm just fills the sensor with the white card: the file says 255. You take one of 400 lm, and "
                 "no tone curve. What does the file say?",
        truth=Term("card_stored", HALVED | {"rho": 0.8}),
        unit="of 255", low=0.0, high=255.0,
        sets=HALVED,
        told="188. Half the light is three quarters of the number: sRGB stores nearly the square root of the light.",
    ),
    notes="""
Walk the ledger with a pointer, one cell at a time, and ask at each arrow who decides: the lamp's maker, geometry, the
material, the photographer, taste, a standard. The common fault in programs is one factor too few: 4π forgotten (lumens as
candela), π forgotten (lux as cd/m²), or textures and pixels multiplied as they are stored. Common wrong answer: 128. Then
set EV 4 and go through the three curves: the window, the lamp, the card. A tone curve is no physics; it may not touch
the numbers before it. EV of a lit room at night: 4 to 7; of sunlight: 15. 7 minutes.
""",
    sources=("Deck, slide Working with Shading Models", "ISO 12232:2006 and ISO 2720:1974: 78, 0.65 and 12.5",
             "Lagarde & de Rousiers 2014: 1.2 · 2^EV", "Reinhard et al. 2002", "Narkowicz 2015: the fit to ACES", "IEC 61966-2-1"),
    honesty="The lamp's light on matt things is exact; no shadows, no light from the walls or the window. The evening's "
            "luminances are set, and colours are three numbers of one luminance. Tone curves act on each channel.",
    values=(Value("luminous_flux", 800.0, low=50.0, high=10000.0), Value("distance", 0.8, low=0.35, high=1.5, scale="linear"),
            Value("ev100", 5.0, low=0.0, high=10.0), Value("curve", 2, choices=CURVES), Value("rho", 0.8, more=True)), minutes=7,
)

MEASURING = Step(
    name="measuring",
    title="Three lamps, and what I/r² is",
    idea="Of a lamp one knows the flux; its intensity over r² is the irradiance it gives, and irradiances add up.",
    slides=(PLAUSIBLE("Measuring Light"),),
    prose=r"""
Lamps are sold in lumens. These three send them out evenly, so

$$I = \frac{\Phi}{4\pi}, \qquad E = \sum_k \frac{I_k}{r_k^2}\;(\colour{n}{n}\cdot\colour{l}{l_k})$$

Each $\colour{l}{\text{arrow}}$ at the meter is one term of the sum. Push the meter under [the low lamp](?from_wall=2&along_wall=0.7):
250 lm win against 600.

The slides write $L_i \approx I/r^2$. But that is an **irradiance**, in lux. The radiance of a globe is
$I/(\pi r_0^2)$, in cd/m², *the same from any distance*. Feed the mirror ball [I/r² as L](?taken=1), and its lamps go
out.

For matt floors both ways agree: luminance times projected solid angle is $I\cos/r^2$, for a globe exactly.
[Large](?source_radius=0.2), [small](?source_radius=0.03): the floor does not change, the mirror does.
""",
    scene=Scene(
        glsl="""
#include "optics/three_lamps.glsl"
#include "display/balls.glsl"
#include "display/palette.glsl"
uniform float luminous_flux;
uniform float from_wall;
uniform float along_wall;
uniform float source_radius;
uniform int taken;

const float MIRROR = 0.34;

vec3 meter() { return vec3(from_wall, along_wall, 0.0); }
vec3 mirror() { return meter() + vec3(0.0, 0.0, MIRROR + 0.02); }

vec3 surface_point(int surface, vec2 s) {
    if (surface == 0) return vec3(2.5 * s.x, 2.4 * s.y - 1.2, 0.0);
    if (surface == 1) return cap_to_eye(s, mirror(), MIRROR);
    return cap_to_eye(s, LAMPS[surface - 2], source_radius);
}

float twofold(vec2 at) { return log2(max(lamps_illuminance(luminous_flux, at.x, at.y), 1.0)); } // 8: 256 lx

vec3 glow(float luminance) { return vec3(1.0, 0.87, 0.66) * (1.25 * luminance / (luminance + 500.0)); }

vec3 shade(Surface s) {
    if (s.id == 0) {
        float lux = twofold(s.position.xy), line = abs(fract(lux - 0.5) - 0.5) / max(fwidth(lux), 1e-5);
        return colormap(lux / 8.0) * mix(0.35, 1.0, smoothstep(0.4, 1.4, line));
    }
    if (s.id > 1) {
        float facing = dot(ball_normal((s.position - LAMPS[s.id - 2]) / source_radius, s.v), s.v);
        return facing < 0.3 ? palette[COLOUR_L] : glow(lamp_luminance(s.id - 2, luminous_flux, source_radius));
    }
    vec3 n = ball_normal((s.position - mirror()) / MIRROR, s.v), from = mirror() + MIRROR * n, d = reflect(-s.v, n);
    vec3 colour = vec3(0.06, 0.07, 0.09) * (1.0 + d.z);
    vec2 at = from.xy - d.xy * from.z / min(d.z, -1e-3);
    if (d.z < -1e-3 && at.x > 0.0 && at.x < 2.5 && abs(at.y) < 1.2) colour = colormap(twofold(at) / 8.0) * 0.8;
    for (int k = 0; k < 3; k++) {
        vec3 way = LAMPS[k] - from;
        float along = dot(way, d), off = length(way - along * d);
        float luminance = taken == 0 ? lamp_luminance(k, luminous_flux, source_radius)
                                     : lamp_inverse_square(k, luminous_flux, from_wall, along_wall);
        if (along > 0.0 && off < source_radius) colour = glow(luminance);
    }
    return colour;
}

vec3 mark_point(int mark, float t) {
    if (mark < 3) { // as long as its part of the lux
        vec3 l = normalize(LAMPS[mark] - mirror());
        float part = lamp_illuminance(mark, luminous_flux, from_wall, along_wall);
        return mirror() + (MIRROR + 0.02 + t * (0.1 + part / (part + 60.0))) * l;
    }
    if (mark < 6) return mix(mirror(), LAMPS[mark - 3], t);
    if (mark == 6) return meter() + vec3(0.46 * cos(2.0 * PI * t), 0.46 * sin(2.0 * PI * t), 0.006);
    return LAMPS[mark - 7] * vec3(1.0, 1.0, t);
}

vec4 probe(int i) {
    if (i == 0) return vec4(meter(), 1.0);
    if (i == 1) return vec4(LAMPS[0] + vec3(0.0, 0.0, source_radius), 1.0);
    return vec4(LAMPS[i - 2] + vec3(0.08, 0.0, source_radius + 0.1), 1.0);
}
""",
        surfaces=(Surface("floor", cells=(1, 1)), Surface("mirror ball", cells=(40, 2)), *(Surface(f"lamp {k}", cells=(30, 2)) for k in range(3))),
        marks=(*(Mark(f"part {k}", colour="l", tip="arrow", width=1.6) for k in range(3)),
               *(Mark(f"way {k}", colour="l", line="dotted", width=0.7) for k in range(3)),
               Mark("meter", colour="exact", segments=48),
               *(Mark(f"height {k}", colour="quiet", line="dashed", width=0.7) for k in range(3))),
        labels=(Label("Φ", 2, "l"), Label("600 lm", 3, "l"), Label("250 lm", 4, "l")),
        handles=(Handle("the meter", 0, ("from_wall", "along_wall")),),
        legend=(("l", "a lamp's part of the lux"),),
        camera=Camera(azimuth=-62, elevation=27, distance=7.4, target=(1.22, -0.05, 0.55), field_of_view=24.5),
    ),
    plot=(
        Curves(
            title="Illuminance of the floor, out from the wall", sweep="from_wall",
            curves=(Curve("all three", Term("lamps_illuminance")),
                    Curve("by luminance and solid angle", Term("lamps_illuminance_by_area"), role="estimate"),
                    Curve("the first alone", Term("lamp_illuminance", {"globe": 0}), role="printed")),
            y_label="lx",
        ),
        Ledger(
            title="The first lamp, seen from the meter",
            columns=((
                LedgerRow("flux", Term("lamp_flux", {"globe": 0}), "lm"),
                LedgerRow("intensity", Term("lamp_intensity", {"globe": 0}), "cd", "1/sr", "even to all sides"),
                LedgerRow("I/r², facing the lamp", Term("lamp_inverse_square", {"globe": 0}), "lx", "sr/m^2"),
                LedgerRow("on the floor", Term("lamp_illuminance", {"globe": 0}), "lx", "", "cosine"),
            ), (
                LedgerRow("flux", Term("lamp_flux", {"globe": 0}), "lm"),
                LedgerRow("intensity", Term("lamp_intensity", {"globe": 0}), "cd", "1/sr", "even to all sides"),
                LedgerRow("luminance of the globe", Term("lamp_luminance", {"globe": 0}), "cd/m^2", "1/m^2", "its disk"),
                LedgerRow("on the floor", Term("lamp_illuminance", {"globe": 0}), "lx", "sr", "projected angle"),
            )),
        ),
    ),
    readouts=(
        Readout("E, from intensities", Term("lamps_illuminance"), role="exact", unit="lx"),
        Readout("E, from luminances", Term("lamps_illuminance_by_area"), role="estimate", unit="lx", against="E, from intensities"),
        Readout("first lamp, luminance", Term("lamp_luminance", {"globe": 0}), unit="cd/m²"),
        Readout("first lamp, I/r²", Term("lamp_inverse_square", {"globe": 0}), role="printed", unit="lx"),
    ),
    ask=Prediction(
        question="A globe lamp of radius 10 cm hangs 1 m away. A program takes I/r² for its radiance L. How many times "
                 "larger is the true one?",
        truth=Term("luminance_over_inverse_square", {"source_radius": 0.1, "distance": 1.0}),
        unit="times", low=1.0, high=10000.0, scale="log",
        sets={"source_radius": 0.1, "taken": 1},
        told="31.8 times: one over the solid angle of its disk, 0.0314 sr. A smaller lamp makes it worse, without end.",
    ),
    notes="""
Ask for the unit of I/r² before anything else: cd/m² is the tempting answer, as m² stands below; but the r² is no
lamp's area, it carries sr: cd · sr/m² = lx. Move the meter and let the class name the lamp with the longest arrow; nearness
beats lumens. Then the mirror ball: a mirror shows radiance, so here the slip can be seen. Why do renderers get away with
it? For a point lamp there is no L, and f n.l I/r² is right: only the name is wrong. The distance from which a lamp counts
as a point was chapter 2; a globe is one at any distance. 6 minutes.
""",
    sources=("Deck, slide Plausible Shading - Measuring Light", "optics reference, D5 and 2.3", "Lambert 1760"),
    honesty="Exact for globes that shine evenly; no shadows, nothing comes back from floor or wall. The floor shows lux by "
            "powers of two; an arrow grows as E / (E + 60 lx), lamps shine as L / (L + 500 cd/m²). What else is in the mirror is a look.",
    values=(Value("luminous_flux", 800.0, low=50.0, high=3000.0), Value("source_radius", 0.1, low=0.03, high=0.2),
            Value("taken", 0, choices=("L, as it is", "I/r² as L")), Value("from_wall", 1.25), Value("along_wall", -0.45, more=True)), minutes=6,
)

ENERGY = Step(
    name="energy",
    title="Body and mirror must share the light",
    idea="What the coat mirrors never reaches the body, and the coat is passed twice: 1 - F on the way in, and on the way out.",
    slides=(PLAUSIBLE("BRDFs"),),
    prose=r"""
Paint, skin, plastic, wood: a matt **body** under a clear **coat**. The coat mirrors the share $\colour{f}{F}$; only the
rest goes in. White paint in a white furnace gives back all it gets: each ball's left half ought to vanish. Stripes: it
$\colour{printed}{\text{makes light}}$.

Adding body and mirror is the old way. One factor, $1-\colour{f}{F}(l\cdot h)$ or $1-\colour{f}{F}(n\cdot l)$, is **not
enough**: the light must come *out* through the coat as well.

$$f_d = \frac{\rho\,(1-\colour{f}{F}(n\cdot l))\,(1-\colour{f}{F}(n\cdot v))}{\pi\,(1-\colour{f}{F_\text{avg}})}$$

[It](code:body_coupled) is reciprocal, and its ball cannot be seen. Walk the $\colour{v}{\text{rings}}$ [to the rim](?theta_v=85). Try
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

const float SIZE = 1.5;

vec3 centre(int i) { return vec3(i % 2 == 0 ? -2.05 : 2.05, 0.0, i < 2 ? 1.95 : -1.95); }

vec3 surface_point(int surface, vec2 s) { // a ball's left half hangs before the furnace's wall, its right half in a room
    if (surface > 0) return vec3((surface == 1 ? -2.05 : 2.05) - 1.85 * s.x, 1.8, 7.8 * (s.y - 0.5));
    return ball_point(s, 4, centre(ball_number(s, 4)), SIZE);
}

float halfway_lost(float c) { return 0.028005 - c * (0.07682 - c * (0.073584 - c * 0.02474)); } // 1 - albedo_body(1, 0, 1), fit

vec3 shade(Surface s) {
    vec3 heat = vec3(0.50, 0.47, 0.43);
    if (s.id > 0) return heat;
    int i = ball_number(s.st, 4);
    vec3 n = ball_normal((s.position - centre(i)) / SIZE, s.v);
    float n_dot_v = clamp(dot(n, s.v), 0.0, 1.0), mirror = f_schlick(n_dot_v, f0);
    float body = i == 1 ? rho * (1.0 - f0) * (1.0 - halfway_lost(n_dot_v)) : i == 3 ? rho * passed_share(n_dot_v, f0)
                                              : rho * (i == 0 ? 1.0 : 1.0 - f_average_schlick(f0));
    if (s.position.x > centre(i).x)
        return body * soft_light(vec3(0.80, 0.10, 0.06), n, s.v) + mirror * studio(reflect(-s.v, n));
    bool stripe = mod(gl_FragCoord.x + gl_FragCoord.y, 12.0) < 4.0;
    return body + mirror > 1.002 && stripe ? palette[COLOUR_PRINTED] : heat * (body + mirror);
}

vec3 ring(int i, float size, float turn) {
    vec3 v = normalize(camera_position - centre(i)), side = normalize(cross(v, vec3(0.0, 0.0, 1.0)));
    return centre(i) + size * (cos(turn) * side + sin(turn) * cross(side, v)) + 0.6 * v;
}

vec3 mark_point(int mark, float t) { return ring(mark % 4, mark < 4 ? SIZE * sin(theta_v) : SIZE, 2.0 * PI * t); }

vec4 probe(int i) {
    if (i == 0) return vec4(ring(0, SIZE * sin(theta_v), 0.7), 1.0);
    return vec4(centre(i - 1) + vec3(1.0, 0.0, 1.72), 1.0);
}
""",
        surfaces=(Surface("balls", cells=(131, 5)), Surface("furnace, left", cells=(1, 1)), Surface("furnace, right", cells=(1, 1))),
        marks=(*(Mark(f"angle {i}", colour="v", segments=64, width=1.2) for i in range(4)),
               *(Mark(f"outline {i}", colour="quiet", line="dotted", segments=64) for i in range(4))),
        labels=tuple(Label(words, i + 1, "exact" if i == 3 else "printed") for i, words in enumerate(COUPLINGS)),
        handles=(Handle("the rings", 0, ("theta_v",)),),
        legend=(("printed", "more than it gets"),),
        camera=Camera(azimuth=-90, elevation=0, distance=60, target=(0.0, 0.0, 0.1), field_of_view=8.2),
    ),
    plot=Curves(
        title="Body and mirror: share of the light sent back", sweep="theta_v",
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
        unit="times", low=0.0, high=2.0,
        sets={"theta_v": 85.0, "rho": 1.0, "f0": 0.04},
        told="1.563 times. Without any factor it is 1.648, with 1 − F(l·h) 1.588: one factor hardly helps. In and out: 1.000.",
    ),
    notes="""
Cover the left halves first: which red ball is wrong? The class will not agree; that is why the furnace is there. Then
the left halves: three rims glow. Ask where the light comes from. At 85° the coat mirrors 0.65, so at most 0.35 may come out of the
body; the factors in use leave it 0.91 and more, for they look at the light's angle, and light comes from everywhere. Why
divide by 1 - F_avg? Light thrown back by the coat from within meets the white body again and gets another chance. Set F₀
to 0.9 with ρ = 1: a metal with a body, added up 1.9 times the light. Metals swallow what enters, so ρ = 0. 6 minutes.
""",
    sources=("Deck, slide Plausible Shading - BRDFs", "Shirley et al. 1997", "Kelemen & Szirmay-Kalos 2001", "optics reference, D13"),
    honesty="Shares are exact for a smooth coat with Schlick's F. Under a rough one up to 1.005 comes back, near 55°, and "
            "less at grazing; the second ball is a fit to 2e-4. ρ counts all bounces under the coat together. The badges judge m = 0.02. The room is a look.",
    values=(Value("theta_v", 75.0, low=0.0, high=88.0), Value("rho", 1.0, low=0.0, high=1.0),
            Value("f0", 0.04, low=0.0, high=0.9)), minutes=6,
)

BOARD = Step(
    name="board",
    title="The board: everything on",
    idea="Under a far light the colour of a place is D, G, F and a denominator of its normal alone, and what the body adds.",
    slides=("Cook – Torrance – Distribution Term (1)", "Cook – Torrance – Fresnel Term (1)",
            "Cook – Torrance – Geometric Term (1)"),
    prose=r"""
All that the course has built, on one object. The ball holds every normal, so it is the object's dictionary: light and eye
are far away, and what has the $\colour{n}{\text{normal}}$ of the picked point **has its colour**. The rings say where.

$$f = \frac{\colour{d}{D}\,\colour{g}{G}\,\colour{f}{F}}{4\,(n\cdot l)(n\cdot v)} + f_d$$

Take it apart: [D](?shows=1), [G](?shows=2), [F](?shows=3), [the quotient](?shows=4), the [body](?shows=5),
[n](?shows=6), [h](?shows=7), and [put it together](?shows=0).

$F$ is **one colour all over**. A fault? No: light and eye are far away, so $\colour{h}{h}$ is the same everywhere, and $F$
[asks only](code:f_schlick) for $l\cdot h$. $D$ alone [draws the highlight](code:d_beckmann). **Click** any place of ball or
object to pick it, or move the $\colour{l}{\text{light}}$: a
[low sun](?theta_v=70&theta_l=70&phi=180) is where $F$ soars. Try [metal](?f0=0.9&rho=0), [rubber](?m=0.7), another shape, or
drop a mesh of your own on the window.
""",
    scene=Scene(
        glsl="""
#include "optics/coat.glsl"
#include "optics/vgroove.glsl"
#include "stage/corner_normal.glsl"
#include "display/balls.glsl"
#include "display/brush.glsl"
#include "display/scale.glsl"
uniform float theta_l, theta_v, phi, turned, m, f0, rho;
uniform int shows;

const float SIZE = 0.92;

vec3 picked() { return picked_frame(theta_v, turned)[2]; }

vec3 lamp() { return picked_light(theta_l, theta_v, phi, turned); }

vec3 ball() { return -0.86 * aside() - 0.58 * up(); }

vec3 surface_point(int surface, vec2 s) { return cap_to_eye(s, ball(), SIZE); }

vec3 mesh_point(int surface, vec3 p) { return SIZE * p + 0.88 * aside() + 0.44 * up(); }

vec4 surface_value(int surface, vec2 s) { return vec4(lamp(), 0.0); }

vec4 mesh_value(int surface, vec3 p, int face) { return vec4(corner_normal(p, face), 0.0); }

vec3 factor(vec3 n, vec3 l, vec3 v) {
    float n_dot_l = dot(n, l), n_dot_v = dot(n, v);
    vec3 s = l + v, h = s / max(length(s), 1e-6), paint = rho * vec3(1.0, 0.30, 0.16);
    if (shows >= 6) {
        vec3 w = shows == 6 ? n : h, c = 0.5 + 0.5 * vec3(dot(w, aside()), dot(w, up()), dot(w, v));
        return c * (0.0125 + c * (0.6822 + c * 0.3053)); // about the power 2.2, which is dear on a CPU
    }
    if (min(n_dot_l, n_dot_v) <= 0.0) return shows == 0 ? 0.06 * (0.2 + paint + f0) : 0.35 * background;
    if (shows == 2) return mix(0.15 * background, palette[COLOUR_G], g_vgroove(dot(n, h), n_dot_v, n_dot_l, dot(l, h)));
    if (shows == 3) return mix(0.15 * background, palette[COLOUR_F], sqrt(f_schlick(dot(l, h), f0)));
    float value = shows == 1 ? d_beckmann(n, s, m) : brdf_cook_torrance(n, l, v, m, f0);
    if (shows == 1 || shows == 4) return decades(value, -3.0, 2.0);
    vec3 body = paint * body_coupled(n_dot_l, n_dot_v, 1.0, f0);
    return shows == 5 ? PI * body : 1.0 - exp(-(value + body) * n_dot_l * 4.5 - 0.06 * (0.2 + paint + f0));
}

vec3 shading_normal(Surface s) {
    if (s.id == 0) return ball_normal((s.position - ball()) / SIZE, s.v);
    return normalize(s.value.xyz) * (dot(s.value.xyz, s.normal) < 0.0 ? -1.0 : 1.0);
}

vec3 shade(Surface s) {
    vec3 v = eye(), l = s.id == 0 ? s.value.xyz : lamp(), n = shading_normal(s);
    vec3 colour = factor(n, l, v);
    float off = distance(n, picked()), ring = s.id == 1 ? abs(off - 0.13) : 1.0;
    return mix(palette[COLOUR_N], colour, smoothstep(0.022, 0.035, ring));
}

vec3 mark_point(int mark, float t) {
    vec3 foot = ball() + SIZE * picked(), l = lamp(), v = eye(), h = normalize(l + v + 1e-6 * picked());
    if (mark == 0) return foot + 0.62 * t * picked();
    if (mark == 1) return foot + 0.95 * t * l;
    if (mark == 2) return foot + 0.75 * t * v;
    return foot + 0.8 * t * h;
}

vec4 probe(int i) {
    if (i == 0) return vec4(ball() + SIZE * picked() + 0.8 * eye(), 1.0);
    return vec4(ball() + SIZE * picked() + 0.95 * lamp(), 1.0);
}
""",
        surfaces=(Surface("ball", cells=(60, 3)), Surface("object", mesh=True)),
        marks=(Mark("normal", colour="n", tip="arrow", label="n"), Mark("to the light", colour="l", tip="sun", label="l"),
               Mark("to the eye", colour="v", tip="eye", label="v"),
               Mark("halfway", colour="h", line="dashed", tip="arrow", label="h")),
        handles=(Handle("the picked point", 0, ("theta_v", "turned")), Handle("the light", 1, ("theta_l", "phi"))),
        legend=(("n", "the same normal"),),
        camera=Camera(azimuth=-62, elevation=24, distance=40, field_of_view=5.3),
        meshes=("knot", "bowl", "sphere", "cube"),
        brush=True,
        decided=("shows",),
    ),
    plot=(
        Ledger("Factor by factor, at the point", ((
            LedgerRow("D(h)", Term("d_halfway"), "1/sr"),
            LedgerRow("D G", Term("dg_at"), "1/sr", "", "G: lit and seen"),
            LedgerRow("D G F", Term("dgf_at"), "1/sr", "", "F: mirrored"),
            LedgerRow("mirror part", Term("brdf_cook_torrance"), "1/sr", "", "1 / 4 (n·l)(n·v)"),
        ),)),
        Lobes(title="The lobe at the point"),
    ),
    models=(Model("mirror and body", Term("brdf_coated", {"coupling": 3})),),
    readouts=(
        Readout("D", Term("d_halfway"), unit="1/sr"), Readout("G", Term("vgroove_at"), unit=""),
        Readout("F", Term("schlick_at"), unit=""), Readout("f, all together", Term("brdf_coated", {"coupling": 3}), unit="1/sr"),
    ),
    ask=Prediction(
        question="Plastic, F(0) = 0.04. You look straight at the highlight's middle, then light and eye sink to 60° on opposite "
                 "sides. How many times larger is D G F / 4 (n·l)(n·v) now?",
        truth=Term("mirror_gain", {"theta": PI / 3, "f0": 0.04}),
        unit="times", low=1.0, high=20.0, scale="log",
        sets={"theta_l": 60.0, "theta_v": 60.0, "phi": 180.0, "f0": 0.04},
        told="7.0 times. D and G have not changed; F gives 1.75, and the denominator 1 / cos² 60° = 4.",
    ),
    notes="""
Let the class name a factor before you show it: who draws the highlight, who the rim, who nothing at all? Show F and wait:
it is flat. Someone will say it is broken; ask where h points at the left of the ball, and at the right. A lamp near by, or an
eye near by, would tilt it. G is 1 nearly everywhere. Then pick a point at the rim and read the ledger from top to bottom. Common wrong answer to the question: about two, from F alone. The denominator is geometry: seen at a slant the same
facets crowd into less projected area. Then change the shape: the rings wander, the numbers stay. 8 minutes.
""",
    sources=("Deck, slides Distribution Term (1), Fresnel Term (1), Geometric Term (1)", "Cook & Torrance 1982",
             "Shirley et al. 1997; Kelemen & Szirmay-Kalos 2001: the body", "Schlick 1994"),
    honesty="1/4 stands for the printed 1/π. Numbers are for red light; light and eye are infinitely far; a click leaves the "
            "light where it is, a dragged point takes it along. The object throws no shadow on itself, has a trace of even light, and F is drawn as its root.",
    values=(Value("shows", 0, choices=("shaded", "D", "G", "F", "quotient", "body", "n", "h")),
            Value("shape", 0, choices=("knot", "bowl", "sphere", "cube"), more=True),
            Value("m", 0.25, low=0.05, high=1.0), Value("f0", 0.04, low=0.02, high=0.95),
            Value("theta_v", 38.0, low=0.0, high=85.0, more=True), Value("theta_l", 38.0, low=0.0, high=85.0, more=True),
            Value("phi", -132.0, more=True), Value("turned", 0.0, more=True), Value("rho", 0.6, more=True)),
    minutes=8,
)

SCALE = Step(
    name="scale",
    title="A bumpy mirror, seen from afar",
    idea="Bumps too small for a pixel turn into roughness: the mean squares of their slopes add to m squared.",
    slides=(PLAUSIBLE("The Scale Effect"),),
    prose=r"""
A mirror ball, hammered all over, its lamp beside your eye. [Near by](?bumps=5) each bump shows a highlight of its own. Drag
the knob on the bar: [farther](?bumps=60), [far away](?bumps=1500). The bumps pass the size of a pixel, and no normal of one place
can stand for a pixel any more.

On the left one bump speaks for all: the picture **sparkles**, and crawls when anything moves. Below, the pixel asks
$N$ places: better, never calm. On the right what it cannot show is moved into the roughness:

$$m_\text{eff}^2 = m^2 + 2\sigma^2$$

$m$ counts both axes, the bumps' slope $\sigma$ one, hence the 2. Facets, bumps, roughness: the same slopes at **three scales**.
At the highlight's [middle](?theta_h=0) this one evaluation misses 2 %; random places need 12 000 for that.
""",
    scene=Scene(
        glsl="""
#include "display/balls.glsl"
#include "display/bumps.glsl"
#include "display/facing.glsl"
uniform float m, bump_slope, bumps, theta_h;
uniform int samples;

vec3 surface_point(int surface, vec2 s) {
    float a = s.y * acos(1.0 / length(camera_position)), turn = 2.0 * PI / 3.0 * (float(surface) + s.x);
    return cos(a) * eye() + sin(a) * around(turn);
}

// What is mirrored: the lamp, and an evening with a horizon as blurred as the roughness makes it
vec3 seen(vec3 bump, float roughness, vec3 v) {
    float height = 2.0 * dot(bump, v) * bump.z / dot(bump, bump) - v.z, wide = 2.0 * roughness;
    vec3 room = mix(vec3(0.045, 0.034, 0.028), vec3(0.11, 0.19, 0.36) - 0.06 * height, smoothstep(-wide, wide, height));
    return room + vec3(0.19, 0.155, 0.10) * d_beckmann(bump, v, roughness);
}

vec3 shade(Surface s) {
    vec3 n = ball_normal(s.position, s.v), across = dFdx(n), down = dFdy(n), light = vec3(0.0), v = eye();
    if (s.id == 0) {
        vec4 bump = bumpy(n, n, across, down, bumps, bump_slope, true);
        light = seen(bump.xyz, sqrt(m * m + bump.w), v);
    } else if (s.id == 2) {
        light = seen(bumpy(n, n, across, down, bumps, bump_slope, false).xyz, m, v);
    } else {
        vec2 at = fract(gl_FragCoord.xy * vec2(0.754878, 0.569840) + 0.5 * gl_FragCoord.yx * vec2(0.618034, 0.324718));
        Waves near = waves(n, across, down, bumps);
        for (int i = 0; i < samples; i++) {
            vec2 off = fract(at + float(i) * vec2(0.7548777, 0.5698403)) - 0.5;
            light += seen(bumpy_near(near, n, off, bump_slope), m, v);
        }
        light /= float(samples);
    }
    return 1.0 - exp(-light);
}

float reached() { return log(bumps / 3.0) / log(500.0); }

vec3 knob() { return 0.12 * eye() - 1.3 * up() + (2.0 * reached() - 1.0) * 0.8 * aside(); }

vec3 mark_point(int mark, float t) {
    if (mark < 3) return 1.02 * t * around(2.0 * PI / 3.0 * float(mark)) + 1.02 * eye();
    if (mark == 3) return sin(theta_h) * around(2.0 * PI * t) + 1.02 * eye();
    if (mark == 4) return 0.12 * eye() - 1.3 * up() + (2.0 * t - 1.0) * 0.8 * aside();
    return knob();
}

vec4 probe(int i) {
    if (i == 0) return vec4(knob(), 1.0);
    if (i == 1) return vec4(sin(theta_h) * around(2.6) + 1.02 * eye(), 1.0);
    if (i < 4) return vec4(-1.3 * up() + (i == 2 ? -1.08 : 1.0) * aside(), 1.0);
    return vec4(i == 4 ? 1.0 * aside() + 0.72 * up() : i == 5 ? -1.12 * up() : -1.08 * aside() + 0.72 * up(), 1.0);
}
""",
        surfaces=(Surface("filtered", cells=(24, 6)), Surface("N places", cells=(24, 6)), Surface("one place", cells=(24, 6))),
        marks=(*(Mark(f"border {i}", colour="quiet") for i in range(3)),
               Mark("ring", colour="h", line="dashed", segments=48, width=1.5),
               Mark("near to far", colour="quiet", width=1.5), Mark("how far", colour="v", tip="dot", width=2.0)),
        labels=(Label("near", 2), Label("far", 3), Label("filtered", 4, "estimate"), Label("N places", 5), Label("one place", 6, "printed")),
        handles=(Handle("the distance", 0, ("bumps",)), Handle("the ring", 1, ("theta_h",))),
        camera=Camera(azimuth=-90, elevation=0, distance=40, target=(0.0, 0.0, -0.2), field_of_view=4.2),
    ),
    plot=(
        Curves(
            title="The roughness a pixel must use", sweep="bumps", y_label="roughness m", tab="m",
            curves=(Curve("what it hides, added", Term("m_pixel"), role="estimate"),
                    Curve("the facets alone", Term("m_effective", {"bump_slope": 0.0}), role="printed")),
        ),
        Curves(
            title="The highlight from afar", sweep="theta_h", y_label="D in 1/sr", tab="D",
            curves=(Curve("counted, 2000 bumps", Term("d_bumps_counted", {"facets": 2000})),
                    Curve("m_eff", Term("d_filtered"), role="estimate"), Curve("Toksvig", Term("d_toksvig"), role="printed")),
        ),
        Curves(
            title="Error at the highlight's middle", sweep="samples", y_label="relative error", y_scale="log", tab="error",
            curves=(Curve("N random places, RMS", Term("sampling_error")),
                    Curve("m_eff, one evaluation", Term("filter_error"), role="estimate")),
        ),
    ),
    readouts=(
        Readout("off, one place", Term("ball_error", {"filtering": 0}), role="printed", unit="of white"),
        Readout("off, N places", Term("ball_error", {"filtering": 1}), unit="of white"),
        Readout("off, m_eff", Term("ball_error", {"filtering": 2}), role="estimate", unit="of white"),
        Readout("off, Toksvig", Term("ball_error", {"filtering": 3}), role="estimate", unit="of white"),
    ),
    ask=Prediction(
        question="A bumpy mirror seen from afar: is it a mirror? Polished to m = 0.1, with bumps of slope 0.2, it will look as if it "
                 "had which m?",
        truth=Term("m_effective", {"m": 0.1, "bump_slope": 0.2}),
        unit="", low=0.0, high=1.0,
        sets={"m": 0.1, "bump_slope": 0.2, "bumps": 1500.0},
        told="0.30: no mirror at all. Its polish, 0.01 of 0.09 in m², hardly counts any more.",
    ),
    notes="""
Pull the knob slowly to the right and stop where the three parts begin to differ, at about 100 bumps. Move the camera a
little: the left part crawls, the right one rests. The numbers say how far off each is: at middle distance the filter only blurs what
it cannot know, and N places win; far away it beats them. Ask which of the three is right, and how one would know: by
counting, the white curve of the second plot. Ten thousand bumps give D = 3.60 in the middle; forgotten bumps 31.8, nine times too much, Toksvig 4.08, m_eff
3.54. Common wrong answer: it stays a mirror, each bump is one. Each is; the pixel is not. The deck's sentence
"introduce macro-scale irregularities into the BRDF roughness" is this formula. 7 minutes.
""",
    sources=("Deck, slide Plausible Shading - The Scale Effect", "Olano & Baker 2010, LEAN Mapping",
             "Toksvig 2005, Mipmapping Normal Maps"),
    honesty="Numbers: bumps of normal slopes, equally large from above, the mean of D; G, F and hidden bumps are left out. The "
            "picture's bumps are six waves, and its light is bent to the screen. How far off it is: root mean square over the ball, "
            "600 pixels wide, from 224 places of each of 64 pixels, good to a quarter of the number.",
    values=(Value("bumps", 300.0, low=3.0, high=1500.0), Value("bump_slope", 0.2, low=0.0, high=0.4),
            Value("m", 0.1, low=0.05, high=0.4), Value("samples", 16, low=1, high=64),
            Value("theta_h", 12.0, low=0.0, high=60.0, more=True)),
    minutes=7, breaks=(Break("a bumpy normal that is not one long", {"d_beckmann": "d_beckmann_naive"}, {"bumps": 3.0, "bump_slope": 0.4}, "A bump adds its slope to n, and the sum is longer than 1. The fast form takes n·h for a cosine: above 1 it finds no angle, and the lamp's highlight explodes over the whole ball. Interpolation and filtering change the length of a normal as well. Normalise, or use a form that does not care.", "D at a normal 2 % too long", Term("d_beckmann", {"n": (0.0, 0.0, 1.02), "h": (0.0, 0.0, 1.0)}), "1/sr"),),
)

MAPS = tuple(Table(f"{name}_map", map=name, given=f"own_{name}") for name in ("albedo", "f0", "roughness", "normal"))

TEXTURING = Step(
    name="texturing",
    title="Four maps, two kinds",
    idea="A map of a colour is decoded from sRGB; a map of a number is not, or each highlight comes out wrong.",
    slides=("Plausible Shading - Texturing",),
    prose=r"""
No surface is the same all over. Lay on one map after the other: [none](?map_layers=0), [albedo](?map_layers=1),
[F(0)](?map_layers=2), which turns the ornament into gold, [roughness](?map_layers=3), the wiping of a cloth, and
[normals](?map_layers=4), its relief.

A file stores numbers from 0 to 1. Which light do they mean? Albedo and $F_0$ are $\colour{l}{\text{colours}}$, stored as sRGB
close to what the eye sees; **decode** them. Roughness and normals are $\colour{v}{\text{numbers}}$: read them **as they are**.

The trap: read the [roughness as sRGB](?map_trap=1). Decoding makes every number smaller, and $D(0) = 1/\pi m^2$ grows. Nothing
fails, the plate only looks wet. Or the [normals](?map_trap=2): all lean the same way. Or leave the
[colours](?map_trap=3) encoded: pale. [All as meant](?map_trap=0).
""",
    scene=Scene(
        glsl="""
#include "optics/coat.glsl"
#include "display/plate.glsl"
uniform float map_s, map_t, light_x, light_y;
uniform int map_layers, map_trap;

vec3 surface_point(int surface, vec2 s) {
    vec2 p = 2.0 * s - 1.0;
    if (surface == 4) return vec3(0.42 + 1.02 * p.x, 1.02 * p.y, 0.0);
    return vec3(-1.02 + 0.25 * p.x, 0.86 - 0.55 * float(surface) + 0.19 * p.y, 0.0);
}

vec3 shade(Surface s) {
    if (s.id < 4) return decoded(stored(s.id, s.st)) * (s.id < map_layers ? 1.0 : 0.25); // as a screen shows the file
    vec3 albedo = stored(0, s.st), f0 = stored(1, s.st), n = vec3(0.0, 0.0, 1.0);
    if (map_trap != 3) albedo = decoded(albedo), f0 = decoded(f0);
    if (map_layers < 1) albedo = vec3(0.25);
    if (map_layers < 2) f0 = vec3(0.04);
    float m = 0.35;
    if (map_layers > 2) m = max(map_trap == 1 ? decoded(stored(2, s.st)).r : stored(2, s.st).r, 0.02);
    if (map_layers > 3) n = normalize(2.0 * (map_trap == 2 ? decoded(stored(3, s.st)) : stored(3, s.st)) - 1.0);
    vec3 to_lamp = vec3(light_x, light_y, 1.1) - s.position, l = normalize(to_lamp), v = s.v, r = 2.0 * dot(n, v) * n - v;
    float n_dot_l = max(dot(n, l), 0.0), x = 1.0 - 0.5 * length(l + v), x5 = x * x * x * x * x;
    vec3 fresnel = f0 + (1.0 - f0) * x5;
    vec3 f = cook_torrance_dg(n, l, v, m) * fresnel + albedo * body_coupled(n_dot_l, dot(n, v), 1.0, 0.04);
    float even = mix(0.10, 0.30, smoothstep(-2.0 * m, 2.0 * m, r.y - 0.35)); // a dim room, lighter at its far end
    vec3 light = f * n_dot_l * 5.0 / dot(to_lamp, to_lamp) + even * (0.9 * f0 + 0.5 * albedo);
    return 1.0 - exp(-light);
}

vec3 lamp() { return vec3(light_x, light_y, 1.1); }

vec3 here() { return surface_point(4, vec2(map_s, map_t)); }

vec3 mark_point(int mark, float t) {
    if (mark == 0) return mix(vec3(light_x, light_y, 0.0), lamp(), t);
    if (mark == 1) return here() + 0.055 * vec3(cos(2.0 * PI * t), sin(2.0 * PI * t), 0.05);
    vec2 at = vec2(cos(2.0 * PI * t), sin(2.0 * PI * t)) * 0.02;
    return surface_point(2, vec2(map_s, map_t)) + vec3(at, 0.01);
}

vec4 probe(int i) {
    if (i == 0) return vec4(lamp(), 1.0);
    if (i == 1) return vec4(here(), 1.0);
    return vec4(surface_point(i - 2, vec2(0.5, 0.0)) + vec3(0.0, -0.08, 0.0), 1.0);
}
""",
        surfaces=(*(Surface(f"{name} map", cells=(1, 1)) for name in ("albedo", "F0", "roughness", "normal")),
                  Surface("plate", cells=(1, 1))),
        marks=(Mark("lamp", colour="l", line="dotted", tip="sun"), Mark("point", colour="exact", segments=32, width=1.4),
               Mark("point on the map", colour="exact", segments=24)),
        labels=(Label("albedo", 2, "l"), Label("F(0)", 3, "l"), Label("roughness", 4, "v"), Label("normals", 5, "v")),
        handles=(Handle("the lamp", 0, ("light_x", "light_y")), Handle("the point", 1, ("map_s", "map_t"))),
        legend=(("l", "colour: decode"), ("v", "number: as it is")),
        tables=MAPS,
        decided=tuple(table.given for table in MAPS),
        camera=Camera(azimuth=-90, elevation=66, distance=12, target=(0.06, -0.02, 0.1), field_of_view=15.2),
    ),
    plot=(
        Curves(
            title="Roughness along the row of the point", sweep="map_s", y_label="roughness m", tab="row",
            curves=(Curve("as stored", Term("stored_roughness")),
                    Curve("read as sRGB", Term("roughness_as_srgb"), role="printed")),
        ),
        Curves(
            title="What a stored number costs, read wrongly", sweep="encoded", y_label="times too large", y_scale="log", tab="cost",
            curves=(Curve("highlight of a roughness, decoded", Term("peak_gain"), role="printed"),
                    Curve("a colour, not decoded", Term("srgb_gap"), role="estimate")),
        ),
    ),
    readouts=(
        Readout("m at the point", Term("stored_roughness"), role="exact", unit=""),
        Readout("m, read as sRGB", Term("roughness_as_srgb"), role="printed", unit="", against="m at the point"),
        Readout("the highlight's peak then", Term("peak_gain_at"), unit="times"),
    ),
    ask=Prediction(
        question="A roughness map stores 0.5, and the program decodes it as if it were an sRGB colour. How many times too bright is the "
                 "middle of the highlight?",
        truth=Term("peak_gain", {"encoded": 0.5}),
        unit="times", low=1.0, high=100.0, scale="log",
        sets={"map_trap": 1, "map_s": 0.3560, "map_t": 0.55},  # where the map stores 0.5
        told="5.5 times: 0.5 is decoded to 0.21, and the peak goes with 1 / m².",
    ),
    notes="""
Switch the maps on one by one and let the class say what each one changed before you name it; roughness is the one they
miss until the lamp moves. Then choose a trap without telling which, and ask what is wrong with the plate. Common wrong
answer: nothing, it is just wetter; that is why the mistake lives for years in projects. Rule to take home: if a person would
pick it in a colour picker, decode it; if it enters a formula as it is, do not. Half a grey ramp is another proof: mean the
stored values, mean the light, compare. 6 minutes.
""",
    sources=("Deck, slide Plausible Shading - Texturing", "IEC 61966-2-1", "Deck, slide Distribution Term (2): the peak of D"),
    honesty="The maps are formulas of this page, not scans, unless you bring yours (--map roughness=FILE, or drop a picture): those "
            "are filtered as they are stored. Numbers are exact. The picture has one point light, an even room in place "
            "of mirror images, V-groove masking of the mean normal, no shadows in the relief, and light bent to the screen.",
    values=(Value("map_layers", 4, choices=("none", "albedo", "F(0)", "rough", "normal")),
            Value("map_trap", 0, choices=("nothing", "roughness", "normals", "colours")),
            Value("light_x", 0.55, low=-0.8, high=1.6, more=True), Value("light_y", 0.45, low=-1.2, high=1.4, more=True),
            Value("map_s", 0.42, more=True), Value("map_t", 0.55, more=True), Value("encoded", 0.5, low=0.02, more=True)),
    minutes=6,
)

MAPPED = ("m = r", "m = r²", "glTF's model")

SECOND = Step(
    name="second_opinion",
    title="A second opinion",
    idea="Two renderers agree only when the numbers in a file mean the same to both: name the model, not only the value.",
    slides=("Cook Torrance – Comparison (1)", "Cook Torrance – Comparison (2)"),
    prose=r"""
A file says: base colour copper, $\colour{d}{r} = 0.5$. Left of the line **we** draw it, right of it another renderer's model
does: glTF's, as *pyrender* computes it. Drag the line.

What is $\colour{d}{r}$? [Take it for m](?mapped=0), and our highlight is far too wide: glTF squares it first,

$$\colour{d}{\alpha} = \colour{d}{r}^2,$$

so that sliders feel even. [m = r²](?mapped=1): now the peaks agree. The rest are the models' own ways: GGX has longer
tails than Beckmann; its $\colour{g}{G}$ is Schlick's fit with $k = (r+1)^2/8$, which darkens even a mirror, where V-grooves
leave 1; paint loses $1-\colour{f}{F}$ once, not in and out.

[Let us evaluate glTF's model](?mapped=2), and the line cannot be found: pixel by pixel. See the
[difference](?mapped=1&shows=1), as [paint](?metallic=0), [rough](?roughness=0.9), [polished](?roughness=0.3).
""",
    scene=Scene(
        glsl="""
#include "optics/gltf.glsl"
#include "stage/corner_normal.glsl"
#include "display/facing.glsl"
#include "display/scale.glsl"
uniform float theta_l, phi, metallic, roughness, wipe;
uniform int mapped, shows;

vec3 lamp() { return cos(theta_l) * eye() + sin(theta_l) * around(phi + 2.2); } // 180 degrees: up and to the left

vec3 mesh_point(int surface, vec3 p) { return 1.25 * p; }

vec4 mesh_value(int surface, vec3 p, int face) { return vec4(corner_normal(p, face), 0.0); }

vec3 lit(vec3 n, vec3 v, int read) { // an irradiance of pi: white and matt is 1
    vec3 l = lamp(), f;
    for (int c = 0; c < 3; c++) f[c] = brdf_file(n, l, v, metallic, roughness, read, c);
    return PI * max(dot(n, l), 0.0) * f;
}

vec3 shade(Surface s) {
    vec3 n = normalize(s.value.xyz);
    if (dot(n, s.normal) < 0.0) n = -n;
    vec3 ours = lit(n, s.v, mapped), theirs = lit(n, s.v, 2);
    if (shows == 1) return diverging(dot(ours - theirs, vec3(2.0 / 3.0)));
    vec3 light = dot(s.position, aside()) < 1.4 * wipe ? ours : theirs;
    return 1.0 - exp(-1.3 * light - 0.02 * COPPER); // a little even light
}

vec3 mark_point(int mark, float t) {
    if (mark == 0) return 1.5 * eye() + 1.4 * wipe * aside() + (shows == 1 ? 1e4 : 2.9 * t - 1.4) * up();
    return (1.35 + 0.5 * t) * lamp();
}

vec4 probe(int i) {
    if (i == 0) return vec4(mark_point(0, 0.0), 1.0);
    if (i == 1) return vec4(mark_point(1, 1.0), 1.0);
    return vec4(mark_point(0, 1.0) + (i == 2 ? -0.42 : 0.42) * aside() - 0.06 * up(), 1.0);
}
""",
        surfaces=(Surface("object", mesh=True),),
        marks=(Mark("where the other begins", colour="exact", tip="none", width=0.8),
               Mark("to the light", colour="l", tip="sun", label="l")),
        labels=(Label("we", 2, "estimate"), Label("glTF", 3)),
        handles=(Handle("the line", 0, ("wipe",)), Handle("the light", 1, ("theta_l", "phi"))),
        camera=Camera(azimuth=-62, elevation=20, distance=40, field_of_view=4.6),
        meshes=("knot", "sphere", "bowl", "cube"),
    ),
    plot=(
        Slice("Both at the highlight", kind="angle"),
        Curves(
            title="If r is taken for m", sweep="roughness", y_label="times too dim", y_scale="log",
            curves=(Curve("middle of the highlight", Term("peak_lost"), role="printed"),),
        ),
    ),
    models=(Model("ours, as chosen", Term("brdf_file", {"channel": 0})),
            Model("glTF, pyrender's", Term("brdf_file", {"channel": 0, "mapped": 2}), "exact")),
    readouts=(
        Readout("glTF, red", Term("brdf_file", {"channel": 0, "mapped": 2}), role="exact", unit="1/sr"),
        Readout("ours, red", Term("brdf_file", {"channel": 0}), role="estimate", unit="1/sr", against="glTF, red"),
        Readout("α of the file's r", Term("alpha_gltf"), unit=""),
        Readout("G of glTF at 45°", Term("g_gltf", {"n_dot_l": 0.7071, "n_dot_v": 0.7071}), unit=""),
    ),
    ask=Prediction(
        question="A file says roughness 0.5, and a program puts it into Beckmann's formula as m. How many times too dim is the "
                 "middle of the highlight?",
        truth=Term("peak_lost", {"roughness": 0.5}),
        unit="times", low=1.0, high=20.0, scale="log",
        sets={"roughness": 0.5, "mapped": 0},
        told="4 times: the file means α = 0.25, and D(0) goes with 1 / m².",
    ),
    notes="""
Start with m = r and ask which half is right. Neither: the file is ambiguous until one knows its model. Then m = r², and let
them look for what is left: tails, then the dark side of G. Show the difference picture, and at last glTF's own model: the
line vanishes. In a terminal, `halfway compare plausible_shading/second_opinion -o both.png` runs the real pyrender in a
process of its own, beside our GLSL, with numbers; with `--aligned` it is a test. Common wrong answer to the question: 2 times.
Roughness has at least four meanings in the wild: r, r², Beckmann's m, an exponent. 5 minutes.
""",
    sources=("Khronos, glTF 2.0, appendix B", "pyrender, mesh.frag", "Karis 2013, Real Shading in Unreal Engine 4", "Schlick 1994"),
    honesty="The right half is a formula, glTF's as pyrender has it; that it equals pyrender's own pixels to 0.7 % (its 8 bits) is "
            "tested for roughness from 0.2 on. Numbers are for the angles of the plot. The difference is full blue or orange where "
            "ours lacks or exceeds half of white. Light is bent to the screen; no shadows.",
    values=(Value("mapped", 0, choices=MAPPED), Value("roughness", 0.5, low=0.2, high=1.0),
            Value("metallic", 1.0, low=0.0, high=1.0), Value("shows", 0, choices=("both", "difference")),
            Value("wipe", 0.0, more=True), Value("shape", 0, choices=("knot", "sphere", "bowl", "cube"), more=True),
            Value("theta_l", 45.0, low=0.0, high=85.0, more=True), Value("theta_v", 45.0, low=0.0, high=85.0, more=True),
            Value("phi", 180.0, more=True)),
    minutes=5,
)

MISTAKES = ("none", "4π forgotten", "body added up", "colours encoded", "no tone curve")

EVERYTHING = Step(
    name="everything",
    title="Everything in one picture",
    idea="Lamps in lumens, measured reflection, maps, a balanced body, a camera: leave out one, and the picture tells.",
    slides=("Working with Shading Models", PLAUSIBLE("BRDFs"), PLAUSIBLE("Texturing")),
    prose=r"""
All that the course has built, at once. A globe of $\colour{l}{\Phi}$ lumens hangs over the table, a spotlight of 400 lm shines
from the left. Every pixel is

$$L = \sum_k \Big(\frac{\colour{d}{D}\,\colour{g}{G}\,\colour{f}{F}}{4\,(n\cdot l_k)(n\cdot v)} + f_d\Big)\,E_k\,(n\cdot l_k)$$

in cd/m². $E_k$ is $I/r^2$ in lux; $\colour{d}{m}$, $\colour{f}{F_0}$, the albedo and $n$ come from maps; $f_d$ gets what the mirror
leaves, in and out. A camera at [EV 6](?ev100=6) or [EV 3](?ev100=3) turns it into numbers.

Now make **one** mistake. [Forget 4π](?mistake=1): lumens as candela. [Add the body up](?mistake=2): the rims glow. [Read
the colours as they are stored](?mistake=3): pale. [Cut at 1](?mistake=4). [None](?mistake=0). Bring a mesh of your own, and maps.
""",
    scene=Scene(
        glsl="""
#include "optics/coat.glsl"
#include "optics/exposure.glsl"
#include "optics/spot.glsl"
#include "stage/corner_normal.glsl"
#include "stage/texture_coordinate.glsl"
#include "display/plate.glsl"
#include "display/vase.glsl"
uniform float luminous_flux, distance, ev100;
uniform int mistake;

const vec2 AXIS = vec2(-0.92, 0.1);
const vec3 MIDDLE = vec3(0.72, 0.05, 0.88); // of the object
const vec3 SPOT = vec3(-3.0, -2.4, 2.4), AXLE = vec3(-0.71548, -0.57239, 0.40068); // and the way back to it

vec3 lamp() { return vec3(-0.12, -0.8, distance); }

vec3 surface_point(int surface, vec2 s) {
    if (surface == 0) return vase_point(AXIS, s);
    if (surface == 1) return vec3(4.4 * s.x - 2.1, 2.3 * s.y - 1.25, 0.0);
    if (surface == 4) return vec3(4.4 * s.x - 2.1, 1.05, 2.7 * s.y);
    float a = PI * s.y, turn = 2.0 * PI * s.x;
    return lamp() + 0.09 * vec3(sin(a) * vec2(cos(turn), sin(turn)), cos(a));
}

vec3 mesh_point(int surface, vec3 p) { return 0.82 * p + MIDDLE; }

vec4 mesh_value(int surface, vec3 p, int face) { return vec4(corner_normal(p, face), 0.0); }

vec3 tangent(vec3 n) { return normalize(abs(n.z) < 0.95 ? vec3(-n.y, n.x, 0.0) : vec3(n.z, 0.0, -n.x)); }

vec3 luminance(Surface s) { // of each channel, white having the same in all
    float candela = luminous_flux * (mistake == 1 ? 1.0 : luminous_intensity_isotropic(1.0));
    if (s.id == 2) return vec3(1.0, 0.86, 0.66) * candela / (PI * 0.0081);
    vec3 n = vec3(0.0, 0.0, 1.0), v = s.v;
    vec2 at = vec2(1.2, 1.0) * s.st;
    if (s.id == 0) n = vase_normal(AXIS, s.st);
    if (s.id == 3) {
        n = normalize(s.value.xyz);
        if (dot(n, s.normal) < 0.0) n = -n;
        at = texture_coordinate((s.position - MIDDLE) / 0.82, n, s.face);
    }
    vec3 albedo = vec3(0.20, 0.13, 0.09), f0 = vec3(0.04);
    float m = 0.3;
    if (s.id == 4) n = vec3(0.0, -1.0, 0.0), albedo = vec3(0.10, 0.11, 0.13);
    if (s.id % 3 == 0) {
        vec3 x = tangent(n), file = 2.0 * stored(3, at) - 1.0;
        n = normalize(file.x * x + file.y * cross(n, x) + file.z * n);
        albedo = stored(0, at), f0 = stored(1, at), m = max(stored(2, at).r, 0.02);
        if (mistake != 3) albedo = decoded(albedo), f0 = decoded(f0);
    }
    float n_dot_v = max(dot(n, v), 0.01);
    float spot = spot_intensity(400.0, 0.3, 0.42), height = 2.0 * dot(n, v) * n.z - v.z; // of what is mirrored: a dim room, its ceiling lighter
    vec3 room = mix(vec3(0.3, 0.26, 0.22), vec3(1.3, 1.5, 1.8), smoothstep(-2.0 * m, 2.0 * m, height - 0.1));
    vec3 light = s.id % 3 > 0 ? 0.3 * albedo : room * (f0 + albedo * (mistake == 2 ? 1.0 : passed_share(n_dot_v, 0.04)));
    for (int k = 0; k < 2; k++) {
        vec3 way = (k == 0 ? lamp() : SPOT) - s.position, l = normalize(way);
        float n_dot_l = max(dot(n, l), 0.0), lux = candela / dot(way, way);
        if (k == 1) lux = spot * spot_linear_cos(dot(l, AXLE), 0.3, 0.42) / dot(way, way);
        vec3 f = albedo / PI; // table and wall are matt
        if (s.id % 3 == 0) {
            if (mistake != 2) f = albedo * body_coupled(n_dot_l, n_dot_v, 1.0, 0.04);
            f += cook_torrance_dg(n, l, v, m) * (f0 + (1.0 - f0) * (1.0 - passed_share(0.5 * length(l + v), 0.0)));
        }
        light += f * lux * n_dot_l;
    }
    return light;
}

vec3 shade(Surface s) {
    vec3 x = luminance(s) / luminance_white(ev100);
    int curve = mistake == 4 ? 0 : 2;
    return vec3(tone_curve(x.r, curve), tone_curve(x.g, curve), tone_curve(x.b, curve));
}

vec3 mark_point(int mark, float t) {
    return mark == 0 ? lamp() + vec3(0.0, 0.0, 0.09 + 0.35 * t) : mix(lamp() * vec3(1.0, 1.0, 0.0), lamp(), t);
}

vec4 probe(int i) { return vec4(lamp() + vec3(i == 0 ? 0.0 : 0.22, 0.0, 0.0), 1.0); }
""",
        surfaces=(Surface("vase", cells=(40, 48)), Surface("table", cells=(1, 1)), Surface("globe", cells=(24, 12)),
                  Surface("object", mesh=True), Surface("wall", cells=(1, 1))),
        marks=(Mark("cable", colour="quiet"), Mark("height", colour="l", line="dotted", width=0.8)),
        labels=(Label("Φ", 1, "l"),),
        handles=(Handle("the lamp", 0, ("distance",)),),
        camera=Camera(azimuth=-90, elevation=18, distance=9.4, target=(0.03, 0.0, 0.95), field_of_view=20),
        meshes=("knot", "sphere", "bowl", "cube"),
        tables=MAPS,
        decided=(*(table.given for table in MAPS), "own_coordinates"),
    ),
    plot=(
        Ledger("A white card under the globe", ((
            LedgerRow("lamp", Term("lamp_flux", {"globe": 0}), "lm"),
            LedgerRow("intensity", Term("luminous_intensity_isotropic"), "cd", "1/sr"),
            LedgerRow("illuminance", Term("illuminance_isotropic", {"theta": 0.0}), "lx", "sr/m^2"),
            LedgerRow("white card", Term("card_luminance", {"rho": 0.8}), "cd/m^2", "1/sr", "BRDF"),
            LedgerRow("on the sensor", Term("card_exposed", {"rho": 0.8}), "", "m^2/cd", "exposure"),
            LedgerRow("of the screen's white", Term("card_toned", {"rho": 0.8, "curve": 2}), "", "", "tone curve"),
            LedgerRow("stored", Term("card_stored", {"rho": 0.8, "curve": 2}), "", "", "sRGB, 8 bits"),
        ),)),
        Curves(
            title="What lacquer sends back in even light", sweep="theta_v", y_label="share of the light",
            curves=(Curve("in and out", Term("albedo_coated", {"rho": 0.8, "f0": 0.04, "coupling": 3})),
                    Curve("added up", Term("albedo_coated", {"rho": 0.8, "f0": 0.04, "coupling": 0}), role="printed")),
        ),
    ),
    readouts=(
        Readout("intensity of the globe", Term("luminous_intensity_isotropic"), unit="cd"),
        Readout("on the table below it", Term("illuminance_isotropic", {"theta": 0.0}), unit="lx"),
        Readout("a white card there", Term("card_luminance", {"rho": 0.8}), unit="cd/m²"),
        Readout("fills the sensor", Term("luminance_white"), unit="cd/m²"),
    ),
    ask=Prediction(
        question="A program takes lumens for candela. By how many EV must its camera be closed so that the picture looks right again?",
        truth=Term("stops", {"gain": 4 * PI}),
        unit="EV", low=0.0, high=12.0,
        sets={"mistake": 1},
        told="3.65 EV: 4π is 12.6, and each EV halves the light. The picture looks right then, and every number in it is wrong.",
    ),
    notes="""
This is the deck's demo with everything on. Let one student make a mistake behind your back, and the class find it: 4π is the
easiest, encoded colours the hardest, for a wrong exposure can hide either. Ask which of them a photograph beside the screen
would reveal (all), and which an artist would repair with a slider (all, one by one, for ever). Then drop a mesh and a map of
their own. Common wrong answer to the question: 4 EV, which is 16. 8 minutes.
""",
    sources=("Deck, slides Working with Shading Models and Plausible Shading", "Lagarde & de Rousiers 2014: 1.2 · 2^EV",
             "Cook & Torrance 1982", "Kelemen & Szirmay-Kalos 2001", "Narkowicz 2015"),
    honesty="Lamps are points of their lumens, their light exact per pixel, with V-grooves, Schlick's F and the balanced body; no "
            "shadows, nothing is reflected twice. The room is a look of 1 cd/m². A mesh without texture coordinates gets its maps "
            "from the six sides of a cube. Maps are filtered as they are stored.",
    values=(Value("mistake", 0, choices=MISTAKES), Value("luminous_flux", 800.0, low=50.0, high=5000.0),
            Value("ev100", 4.0, low=0.0, high=10.0), Value("distance", 1.9, low=1.4, high=2.6, scale="linear"),
            Value("theta_v", 60.0, low=0.0, high=88.0, more=True),
            Value("shape", 0, choices=("knot", "sphere", "bowl", "cube"), more=True)),
    minutes=8,
)

BODY_PYTHON = """import numpy as np

def body_coupled(n_dot_l, n_dot_v, rho, f0):
    # A matt body under a coat, in 1/sr. n_dot_l, n_dot_v, rho, f0: (...); F is Schlick's.
    return np.zeros(np.broadcast_shapes(*map(np.shape, (n_dot_l, n_dot_v, rho, f0))))
"""
BODY_PYTHON_SOLVED = """import numpy as np

def body_coupled(n_dot_l, n_dot_v, rho, f0):
    through_l, through_v = ((1 - f0) * (1 - (1 - c)**5) for c in (n_dot_l, n_dot_v))
    return rho * through_l * through_v / (np.pi * (1 - f0) * 20 / 21)  # 1 - F_avg
"""
BODY_GLSL_HEAD = "float body_coupled(float n_dot_l, float n_dot_v, float rho, float f0) {\n"
BODY_GLSL_STUB = BODY_GLSL_HEAD + "    return 0.0;\n}\n"
BODY_GLSL_SOLVED = BODY_GLSL_HEAD + """    vec2 c = vec2(n_dot_l, n_dot_v), x = 1.0 - c;
    vec2 entered = (1.0 - f0) * c * (1.0 + x + x * x + x * x * x + x * x * x * x); // 1 - F, where nothing cancels
    return rho * entered.x * entered.y / (3.14159265 * (1.0 - f0) * 20.0 / 21.0);
}
"""

SCALE_HEAD_PYTHON = """import numpy as np

def m_effective(m, bump_slope):
    # The roughness m of a bumpy surface from afar; bump_slope is the bumps' RMS slope along one axis. Arrays (...).
"""
SCALE_HEAD_GLSL = "float m_effective(float m, float bump_slope) {\n"

CHAPTER = Chapter(
    title="Plausible shading",
    idea="Right units, a balanced material and a camera make a picture one can believe.",
    steps=(COMPARE, QUANTITIES, MEASURING, ENERGY, BOARD, SCALE, TEXTURING, EVERYTHING, SECOND),
    exercises=(
        Exercise(
            name="coated",
            function="body_coupled",
            task="Write the BRDF of a matt body under a coat: light passes it on the way in and on the way out.",
            slide=PLAUSIBLE("BRDFs"),
            stubs={"python": BODY_PYTHON, "glsl": BODY_GLSL_STUB},
            solutions={"python": BODY_PYTHON_SOLVED, "glsl": BODY_GLSL_SOLVED},
            checks=(
                Check({"n_dot_l": (1.0, 0.9), "n_dot_v": (1.0, 0.8), "rho": (1.0, 0.5), "f0": (0.0, 0.04)}, "nearly head-on"),
                Check({"n_dot_l": (0.2, 0.7), "n_dot_v": (0.7, 0.2), "rho": (0.8, 0.8), "f0": (0.04, 0.04)}, "light and eye swapped: the same"),
                Check({"n_dot_l": (0.5, 0.5), "n_dot_v": (0.5, 0.5), "rho": (0.8, 0.8), "f0": (0.02, 0.17)}, "water and diamond"),
                Check({"n_dot_l": (0.05, 0.9), "n_dot_v": (0.6, 0.01), "rho": (0.9, 0.3), "f0": (0.08, 0.5)}, "grazing", hidden=True),
            ),
        ),
        Exercise(
            name="from_afar",
            function="m_effective",
            task="Bumps too small to be seen become roughness: write m_eff. Mind along how many axes each slope is counted.",
            slide=PLAUSIBLE("The Scale Effect"),
            stubs={"python": SCALE_HEAD_PYTHON + "    return m + 0 * bump_slope\n",
                   "glsl": SCALE_HEAD_GLSL + "    return m;\n}\n"},
            solutions={"python": SCALE_HEAD_PYTHON + "    return np.sqrt(m**2 + 2 * bump_slope**2)\n",
                       "glsl": SCALE_HEAD_GLSL + "    return sqrt(m * m + 2.0 * bump_slope * bump_slope);\n}\n"},
            checks=(
                Check({"m": (0.1, 0.1), "bump_slope": (0.2, 0.05)}, "a polished mirror with bumps"),
                Check({"m": (0.3, 0.3), "bump_slope": (0.0, 0.01)}, "no bumps, and hardly any"),
                Check({"m": (0.5, 0.02), "bump_slope": (0.4, 0.3)}, "rough, and nearly smooth", hidden=True),
            ),
        ),
    ),
    terms={
        "coat": "a clear layer that mirrors the share F and lets the rest through, in and out",
        "body": "what lies under the coat and sends light back evenly: paint, pigment, skin",
        "slope variance": "the mean square of slopes along one axis; those of facets and bumps add when a pixel hides both",
        "aliasing": "what a pixel shows that looks at one place for all of its own: sparkle, moiré, crawling",
        "sRGB": "how colours are stored: close to what the eye tells apart, not proportional to light",
        "F_avg": "the share of even light that a coat mirrors: F₀ + (1 - F₀) / 21 by Schlick's fit",
    },
)
