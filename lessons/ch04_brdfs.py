"""Why does paper look alike from every side, and a plate of steel not? A BRDF says where a surface sends its light.

It is one function of two directions: how much of the light from here goes there. This chapter takes the equation apart
in which it stands, asks what such a function must never do, and builds the two that have shaded screens for decades.
"""

from app.lesson import (
    Camera,
    Chapter,
    Check,
    Choice,
    Curve,
    Curves,
    Dots,
    Exercise,
    Handle,
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

EQUATION = "BRDF – The Reflectance Equation ({})".format
BRDF = "The BRDF ({})".format
UP = (0.0, 0.0, 1.0)
BROKEN = {"k_d": 0.6, "k_s": 0.3}
UNDER_SKY = {"k_d": 0.2, "zenith_radiance": 1.0}

BALANCE = Step(
    name="balance",
    title="Where the light goes",
    idea="What arrives at a patch is reflected, scattered or absorbed; only the first two leave it.",
    slides=(EQUATION(1), EQUATION(2)),
    prose=r"""
Thirty-two rays fall on a patch $dA$. Some are $\colour{r}{\text{reflected}}$ at once, all to the mirror side. Some go in, are
$\colour{v}{\text{scattered}}$ from grain to grain and come out again, a little beside, to anywhere. The rest is
$\colour{quiet}{\text{absorbed}}$ and warms the body.

$$\colour{l}{E} = \colour{r}{k_s E} + \colour{v}{k_d E} + \text{absorbed}$$

The deck lists all three under "energy leaving". Absorbed energy stays: what leaves is $(k_s + k_d)\,E$.

Pull the marks on the bar. Try [snow](?k_s=0.05&k_d=0.85), [soot](?k_s=0.02&k_d=0.03), [steel](?k_s=0.6&k_d=0). Now
[promise too much](?k_s=0.6&k_d=0.8): the extra rays come from nowhere. Lower [the light](?theta_l=75): the patch
gets less, and the shares stay.
""",
    scene=Scene(
        glsl="""
#include "core/chance.glsl"
#include "display/palette.glsl"
uniform float theta_l;
uniform float k_s;
uniform float k_d;

const int RAYS = 32;       // that arrive; twice as many can leave where k_s + k_d is beyond 1
const float PATCH = 0.9;   // width of dA
const float TALL = 3.0;    // of the bar
const float BAR = 2.1;

int fate(int ray) { // 0 reflected, 1 scattered, 2 absorbed, 3 there is no such ray
    float u = (float(ray) + 0.5) / float(RAYS);
    return u < k_s ? 0 : u < k_s + k_d ? 1 : u < 1.0 ? 2 : 3;
}

// The way of a ray: 0 far out, 1 on the patch, 2 to 5 in the body, 6 back on the surface, 7 far out again.
vec2 way(int ray, int node) {
    float x = PATCH * ((float((ray * 13) % RAYS) + 0.5) / float(RAYS) - 0.5), far = 2.7;
    if (node < 2) return vec2(x, 0.0) + far * float(1 - node) * vec2(-sin(theta_l), cos(theta_l));
    if (fate(ray) == 0) return vec2(x, 0.0) + far * float(node - 1) / 6.0 * vec2(sin(theta_l), cos(theta_l));
    float beside = 1.3 * (chance(ray, 9) - 0.5);
    if (node < 6) {
        float a = float(node - 1) / 5.0, deep = node == 2 || node == 5 ? 0.4 : 1.0;
        return vec2(x + beside * a + 0.35 * (chance(ray, node) - 0.5), -0.1 - deep * chance(ray, node + 5));
    }
    if (node == 6) return vec2(x + beside, 0.0);
    float s = 2.0 * chance(ray, 12) - 1.0; // Lambert's law in the plane: even in the sine
    return vec2(x + beside, 0.0) + 1.9 * vec2(s, sqrt(max(0.0, 1.0 - s * s)));
}

vec3 surface_point(int surface, vec2 s) {
    if (surface == 0) { // one ribbon along all rays, ten cells each, of no width where it goes on to the next
        int cell = int(s.x * float(20 * RAYS - 1) + 0.5), ray = cell / 10, place = cell % 10, kind = fate(ray);
        int first = ray < RAYS ? 0 : 6, last = kind == 2 ? 5 : kind == 3 ? first : 7, node = clamp(place - 1, first, last);
        vec2 along = normalize(way(ray, min(node + 1, last)) - way(ray, max(node - 1, first)) + vec2(1e-6, 0.0));
        float wide = place % 9 == 0 ? 0.0 : PATCH / float(RAYS) * max(cos(theta_l), 0.1) * 1.04;
        vec2 p = way(ray, node) + wide * (s.y - 0.5) * vec2(-along.y, along.x);
        return vec3(p.x, -0.02 - 0.0005 * float(ray), p.y);
    }
    if (surface == 1) return vec3(BAR + 0.36 * s.x, -0.01, -1.25 + TALL * 1.42 * s.y);
    if (surface == 2) return vec3(-2.0 + 3.8 * s.x, 0.12, -1.25 * s.y);
    return vec3(PATCH * (s.x - 0.5), -0.04, 0.035 * (s.y - 0.5));
}

vec3 shade(Surface s) {
    if (s.id == 0) {
        float cell = s.st.x * float(20 * RAYS - 1), at = mod(cell, 10.0) - 1.0;
        int ray = int(cell) / 10, kind = fate(ray);
        if (ray >= RAYS || at < 1.0) return palette[ray < RAYS ? COLOUR_L : COLOUR_EXACT];
        if (kind == 0) return palette[COLOUR_R];
        vec3 inside = mix(palette[COLOUR_L], kind == 1 ? palette[COLOUR_V] : palette[COLOUR_LOST], smoothstep(1.0, 5.0, at));
        return at < 6.0 ? inside * 0.75 : palette[COLOUR_V];
    }
    if (s.id == 1) {
        float u = s.st.y * 1.42 * TALL / (TALL * max(cos(theta_l), 0.02)); // of what arrives
        if (u > max(1.0, k_s + k_d)) discard;
        vec3 kind = u < k_s ? palette[COLOUR_R] : u < k_s + k_d ? palette[COLOUR_V] : palette[COLOUR_LOST];
        return u < 1.0 || s.st.x > 0.5 ? kind : palette[COLOUR_EXACT];
    }
    return s.id == 3 ? palette[COLOUR_EXACT]
        : mix(mix(palette[COLOUR_QUIET], palette[COLOUR_N], 0.3) * 0.75, background, 0.35 + 0.5 * s.st.y);
}

vec3 dot_point(int i) {
    vec2 p = way(i, 5);
    return vec3(p.x, -0.08, p.y);
}

vec4 dot_colour(int i) {
    return vec4(palette[COLOUR_LOST], fate(i) == 2 ? 1.0 : 0.0);
}

vec3 mark_point(int mark, float t) {
    if (mark == 0) return vec3(0.0, -0.1, 2.3 * t);
    return mark == 1 ? vec3(0.75 * sin(-theta_l * t), -0.1, 0.75 * cos(theta_l * t)) : vec3(-2.0 + 3.8 * t, 0.1, 0.0);
}

vec4 on_bar(float share) {
    return vec4(BAR + 0.18, -0.1, min(-1.25 + TALL * max(cos(theta_l), 0.02) * share, 3.0), 1.0);
}

vec4 probe(int i) {
    if (i == 0) return vec4(2.7 * vec3(-sin(theta_l), 0.0, cos(theta_l)), 1.0);
    if (i < 3) return on_bar(i == 1 ? k_s : k_s + k_d);
    return i == 3 ? vec4(-1.45, -0.1, -0.95, 1.0) : vec4(-0.75, -0.1, -0.16, 1.0);
}
""",
        surfaces=(Surface("rays", cells=(639, 1)), Surface("bar", cells=(1, 1)), Surface("body", cells=(1, 1)),
                  Surface("patch", cells=(1, 1))),
        marks=(Mark("normal", colour="n", tip="arrow", label="n"),
               Mark("angle", colour="exact", segments=24, label="θ", label_at=0.5), Mark("surface", colour="quiet")),
        dots=Dots(32, size=1.4),
        labels=(Label("the body", 3), Label("dA", 4)),
        handles=(Handle("the light", 0, ("theta_l",)), Handle("reflected share", 1, ("k_s",)),
                 Handle("scattered share", 2, ("k_d",))),
        legend=(("l", "arrives, E"), ("r", "reflected, k_s E"), ("v", "scattered, k_d E"), ("lost", "absorbed")),
        camera=Camera(azimuth=-90, elevation=3, distance=10.8, target=(0.2, 0.0, 0.75), field_of_view=24),
    ),
    plot=Curves(
        title="By the angle of the light", sweep="theta_l",
        curves=(Curve("arrives", Term("irradiance_directional", {"theta": "theta_l"})),
                Curve("leaves", Term("exitance_leaving"), role="estimate"),
                Curve("reflected alone", Term("exitance_reflected"), role="printed")),
        y_label="W/m²",
    ),
    readouts=(
        Readout("arrives, E", Term("irradiance_directional", {"theta": "theta_l"}), role="exact", unit="W/m²"),
        Readout("reflected", Term("exitance_reflected"), unit="W/m²"),
        Readout("scattered", Term("exitance_scattered"), unit="W/m²"),
        Readout("absorbed", Term("irradiance_absorbed"), unit="W/m²"),
    ),
    ask=Prediction(
        question="100 W/m² arrive. A fifth is reflected, half of it is scattered, and nothing shines through. How much leaves "
                 "the patch?",
        truth=Term("exitance_leaving", {"k_s": 0.2, "k_d": 0.5, "irradiance_facing": 100.0, "theta_l": 0.0}),
        unit="W/m²", low=0.0, high=100.0,
        sets={"k_s": 0.2, "k_d": 0.5, "theta_l": 0.0},
        told="70 W/m². The other 30 are absorbed: that leaves later, as heat, and the shading of this course does not count it.",
    ),
    notes="""
Ask where the light of the lecture room goes: in a few nanoseconds all of it is heat. Then the three fates. The slide lists
absorbed energy as leaving; say it kindly: the balance has three terms, the exitance has two. Let someone set both shares
beyond 1 together: the rays out of nothing are the point of the rule k_s + k_d ≤ 1, which returns with Blinn-Phong. Usual wrong
answer to the question: 100, since energy is conserved; it is, and 30 of it are warm now. 4 minutes.
""",
    sources=("Deck, slides BRDF - The Reflectance Equation (1) and (2)",),
    honesty="The shares are exact, for an opaque patch that emits nothing. The wandering of the scattered rays is drawn by "
            "chance, in a plane, and far too wide: in paper it is a fraction of a millimetre. The shares of real "
            "surfaces change with the angle: chapter 6.",
    values=(Value("k_s", 0.3), Value("k_d", 0.45), Value("theta_l", 40.0, low=0.0, high=80.0),
            Value("irradiance_facing", 100.0, low=1.0, high=1000.0, more=True)),
    minutes=4,
)

REFLECTANCE_EQUATION = Step(
    name="reflectance_equation",
    title="The sum over the sky",
    idea="What goes to the eye is a sum over all directions: incoming radiance times BRDF times cosine.",
    slides=(EQUATION(3),),
    prose=r"""
A patch of glossy plastic lies under a whole sky. Every $\colour{estimate}{\text{tile}}$ of it sends light down, and a bit of
each goes to the $\colour{v}{\text{eye}}$:

$$\colour{v}{L_o} = \int_\Omega f\; \colour{l}{L_i}\, \cos\theta_i\, d\omega_i \;\approx\; \sum f\, L_i \cos\theta_i\, \Delta\Omega$$

Look at the three factors one by one: the [incoming light](?layer=0), the [BRDF](?layer=1), bright where this eye is served
well, and the [cosine](?layer=2). Only their [product](?layer=3) counts: a tile matters if all three agree.

Grab $\colour{l}{\text{the sun}}$, grab $\colour{v}{\text{the eye}}$. Let [the eye meet the mirrored sun](?theta_v=55&phi=180&theta_l=55).
Take [fewer tiles](?tile_rows=3): the sun slips between their middles.
""",
    scene=Scene(
        glsl="""
#include "optics/sky.glsl"
#include "display/look.glsl"
#include "stage/camera.glsl"
uniform float theta_l;
uniform float phi;
uniform float theta_v;
uniform float sun_radiance;
uniform float exponent;
uniform float k_s;
uniform int tile_rows;
uniform int layer;

const float K_D = 0.2;
const vec3 BLUE = vec3(0.14, 0.38, 1.0), WARM = vec3(1.0, 0.66, 0.26);

vec3 tile_middle(vec2 s) {
    float n = float(tile_rows);
    vec2 middle = (floor(min(s, 0.9999) * vec2(4.0 * n, n)) + 0.5) / n;
    return direction(0.5 * PI * middle.y, 0.5 * PI * middle.x);
}

vec3 surface_point(int surface, vec2 s) {
    if (surface == 0) return cap_point(0.5 * PI, s.x, s.y);
    if (surface == 1) return vec3(1.25 * cap_point(0.5 * PI, s.x, s.y).xy * s.y, -0.005);
    return vec3(0.16 * (2.0 * s - 1.0), 0.0);
}

vec3 shade(Surface s) {
    if (s.id == 1) return mix(background, palette[COLOUR_QUIET], 0.32 * (1.0 - smoothstep(0.7, 1.0, s.st.y)));
    if (s.id == 2) return palette[COLOUR_EXACT];
    vec3 l = tile_middle(s.st);
    if (dot(l, normalize(camera_position)) > 0.35) discard; // cut open towards the reader
    vec3 to_sun = light_direction(theta_l, phi), v = view_direction(theta_v), light = vec3(1.0), weight = vec3(1.0);
    if (layer == 0 || layer == 3) {
        float sky = sky_radiance(l, to_sun, 1.0, 0.0), sun = sky_radiance(l, to_sun, 0.0, sun_radiance);
        light = sky * BLUE + sun * WARM;
    }
    if (layer == 1 || layer == 3) weight *= PI * brdf_phong(vec3(0.0, 0.0, 1.0), l, v, K_D, k_s, exponent);
    if (layer == 2 || layer == 3) weight *= l.z;
    vec3 shown = light * weight * (layer == 1 ? 0.5 : 1.2);
    shown = layer == 2 ? weight * weight : shown / (shown + 1.0); // no screen has a range of a hundred to one
    return mix(shown, background, 0.55 * grid_lines(s.st, vec2(4.0, 1.0) * float(tile_rows)));
}

vec3 mark_point(int mark, float t) {
    if (mark == 0) return vec3(0.0, 0.0, 1.3 * t);
    if (mark == 1) return 0.94 * t * light_direction(theta_l, phi);
    if (mark == 2) return 1.3 * t * view_direction(theta_v);
    if (mark == 3) return 0.97 * t * light_direction(theta_v, PI);
    return cap_point(0.5 * PI, t, 1.0);
}

vec4 probe(int i) {
    if (i == 0) return vec4(0.94 * light_direction(theta_l, phi), 1.0);
    return i == 1 ? vec4(1.3 * view_direction(theta_v), 1.0) : vec4(0.0, -0.3, -0.04, 1.0);
}
""",
        surfaces=(Surface("sky", cells=(64, 12)), Surface("floor", cells=(48, 1)), Surface("patch", cells=(1, 1))),
        marks=(Mark("normal", colour="n", tip="arrow", label="n"), Mark("to the sun", colour="l", tip="sun", label="sun"),
               Mark("to the eye", colour="v", tip="eye", label="v"),
               Mark("mirror of the eye", colour="r", line="dotted", tip="arrow"), Mark("horizon", colour="quiet", segments=96)),
        labels=(Label("dA", 2),),
        handles=(Handle("the sun", 0, ("theta_l", "phi")), Handle("the eye", 1, ("theta_v",))),
        legend=(("l", "to the sun"), ("v", "to the eye"), ("r", "mirror of the eye")),
        camera=Camera(azimuth=-42, elevation=16, distance=5.2, target=(0.05, 0.0, 0.5)),
    ),
    plot=Curves(
        title="The sum, by rows of tiles", sweep="tile_rows",
        curves=(Curve("the integral", Term("reflected_radiance", UNDER_SKY)),
                Curve("sum over the tiles", Term("reflected_radiance_sum", UNDER_SKY), role="estimate")),
        y_label="L_o, W/(m² sr)",
    ),
    readouts=(
        Readout("L_o, the integral", Term("reflected_radiance", UNDER_SKY), role="exact", unit="W/(m² sr)"),
        Readout("Σ over the tiles", Term("reflected_radiance_sum", UNDER_SKY), role="estimate", unit="W/(m² sr)",
                against="L_o, the integral"),
        Readout("from the sun", Term("sun_share", UNDER_SKY), unit="of it"),
    ),
    ask=Prediction(
        question="A low sun, 80° from the normal, is 25 times as bright as the blue overhead. The eye looks from 30°, aside. "
                 "Which part of the sky matters most to it?",
        truth=Term("sun_share", UNDER_SKY),
        unit="of the light is the sun's",
        choices=(Choice("the sun, by far", 0.5, 1.0), Choice("the sun and the blue, about half each", 0.3, 0.5),
                 Choice("the blue where the eye is mirrored", 0.0, 0.3)),
        sets={"theta_l": 80.0, "phi": 90.0, "theta_v": 30.0, "sun_radiance": 25.0, "k_s": 0.7, "exponent": 40.0},
        told="The blue. The sun gives 0.03 of it: it is bright, but low (cosine 0.17), and this eye's BRDF looks elsewhere. Seven "
             "tenths come from the small blue spot where the eye is mirrored.",
    ),
    notes="""
Go through the layers in order and let the class say where the product will be bright before it is shown. The common
wrong answer to the question is the sun, because it is the brightest thing there; a product of three is as small as its
smallest factor. Then let the eye meet the mirrored sun: 0.84 of the light is the sun's, as on a wet road. With three rows of tiles
the sun slips between the middles and two thirds of the light are gone: sampling, as with area lights in chapter 3, comes
from here. 6 minutes.
""",
    sources=("Deck, slide BRDF - The Reflectance Equation (3)", "Nicodemus et al. 1977: the reflectance equation",
             "Lafortune & Willems 1994: the BRDF used"),
    honesty="The integral is exact to ten digits (a Gauss rule), for this sky, which is made up: a hazy sun 17° "
            "across at half its height, a tree. The BRDF is one that comes later in this chapter, of k_d = 0.2.",
    values=(Value("layer", 3, choices=("incoming radiance", "BRDF", "cosine", "product")), Value("tile_rows", 12, low=2),
            Value("theta_l", 55.0), Value("theta_v", 35.0, low=0.0, high=85.0), Value("phi", 150.0, more=True),
            Value("sun_radiance", 25.0, more=True), Value("k_s", 0.7, more=True),
            Value("exponent", 40.0, low=5.0, high=100.0, more=True)),
    minutes=6,
)

DEFINITION = Step(
    name="definition",
    title="A function of two directions",
    idea="A BRDF is the radiance that goes one way per irradiance that comes from another: per steradian, for each colour.",
    slides=(BRDF(1), BRDF(2), BRDF(4)),
    prose=r"""
Let a thin beam from $\colour{l}{\omega_i}$ fall on red, varnished wood. It brings the irradiance $L_i\cos\theta_i\,d\omega_i$,
and every $\colour{v}{\omega_o}$ gets some radiance of it. Their ratio is the **BRDF**:

$$f(\colour{l}{\omega_i}, \colour{v}{\omega_o}) = \frac{dL_o(\colour{v}{\omega_o})}{\colour{l}{L_i \cos\theta_i\, d\omega_i}}$$

For one $\omega_i$ it is a lobe over all $\omega_o$: how the light of the beam is spread. Drag the $\colour{l}{\text{lamp}}$, and the
lobe turns; [straight down](?theta_l=0), [low](?theta_l=75). Each channel has its own: the body sends back red, hardly any
[green](?channel=1) or [blue](?channel=2), the varnish all alike.

Its unit is 1/sr; the glass dome is $f = 1$. [Polish the varnish](?exponent=60).

A real lamp has some size and measures a mean; [open it](?half_angle=20), [close it](?half_angle=1).
""",
    scene=Scene(
        glsl="""
#include "optics/specimen.glsl"
#include "display/lobe.glsl"
#include "display/look.glsl"
uniform float theta_l;
uniform float theta_v;
uniform float phi;
uniform float exponent;
uniform float half_angle;
uniform int channel;

const vec3 UP = vec3(0.0, 0.0, 1.0);
const float K_S = 0.15;
const float SCALE = 1.45; // metres per 1/sr

float spread(vec3 d, int c) {
    return brdf_paint(UP, light_direction(theta_l, phi), d, c, K_S, exponent);
}

vec3 surface_point(int surface, vec2 s) {
    vec3 l = light_direction(theta_l, phi);
    if (surface == 0) {
        vec3 d = lobe_direction(s, reflection_vector(UP, l), 0.25);
        return SCALE * lobe_radius(spread(d, channel), 1.0, 0.0) * d;
    }
    if (surface == 1) return SCALE * cap_point(0.5 * PI, s.x, s.y);
    if (surface == 2) return vec3(1.9 * (2.0 * s - 1.0) * vec2(1.0, 0.8), -0.012);
    vec3 rim = cos(2.0 * PI * s.x) * direction_theta(theta_l, phi) + sin(2.0 * PI * s.x) * direction_phi(phi);
    return 1.9 * s.y * (cos(half_angle) * l + sin(half_angle) * rim); // the beam
}

vec3 shade(Surface s) {
    if (s.id == 0) { // in the colour that the eye sees from there
        vec3 d = normalize(s.position), f = vec3(spread(d, 0), spread(d, 1), spread(d, 2));
        return soft_light(f / max(f.r, 1e-4), s.normal, s.v);
    }
    if (s.id == 1) return glass(s.st, vec2(24.0, 6.0));
    if (s.id == 2) {
        float grain = 0.5 + 0.5 * sin(22.0 * s.position.y + 2.5 * sin(1.7 * s.position.x + 0.6 * s.position.y));
        return mix(vec3(0.16, 0.022, 0.012), vec3(0.30, 0.05, 0.025), grain) * (1.0 - 0.6 * smoothstep(0.5, 2.3, length(s.position.xy)));
    }
    return palette[COLOUR_L];
}

vec3 mark_point(int mark, float t) {
    if (mark == 0) return vec3(0.0, 0.0, 1.95 * t);
    if (mark == 1) return 2.0 * t * light_direction(theta_l, phi);
    if (mark == 2) return 2.0 * t * view_direction(theta_v);
    return SCALE * spread(view_direction(theta_v), channel) * t * view_direction(theta_v);
}

vec4 probe(int i) {
    return vec4(2.0 * (i == 0 ? light_direction(theta_l, phi) : view_direction(theta_v)), 1.0);
}
""",
        surfaces=(Surface("lobe", cells=(40, 24)), Surface("f = 1", cells=(48, 12), opacity=0.14),
                  Surface("wood", cells=(1, 1)),
                  Surface("beam", cells=(32, 1), opacity=0.45)),
        marks=(Mark("normal", colour="n", tip="arrow", label="n"), Mark("to the lamp", colour="l", tip="sun", label="ωi"),
               Mark("to the eye", colour="v", tip="eye", label="ωo"), Mark("f there", colour="v", tip="dot", width=2.2)),
        handles=(Handle("the lamp", 0, ("theta_l", "phi")), Handle("the eye", 1, ("theta_v",))),
        legend=(("l", "the beam, ωi"), ("v", "to the eye, ωo"), ("quiet", "f = 1 per sr")),
        camera=Camera(azimuth=-72, elevation=13, distance=7.2, target=(0.0, 0.0, 0.72)),
    ),
    plot=(
        Curves(
            title="The same beam from other sides", sweep="theta_v",
            curves=(Curve("red", Term("brdf_paint", {"channel": 0, "k_s": 0.15}), role="printed"),
                    Curve("green", Term("brdf_paint", {"channel": 1, "k_s": 0.15})),
                    Curve("blue", Term("brdf_paint", {"channel": 2, "k_s": 0.15}), role="estimate")),
            y_label="f, 1/sr",
        ),
        Lobes("Where the light of the lamp goes"),
    ),
    models=(Model("varnished wood", Term("brdf_paint", {"k_s": 0.15})),),
    readouts=(
        Readout("f", Term("brdf_paint", {"k_s": 0.15}), role="exact", unit="1/sr"),
        Readout("dL/dE with this lamp", Term("paint_measured", {"k_s": 0.15}), role="estimate", unit="1/sr", against="f"),
    ),
    ask=Prediction(
        question="No surface gives back more than it gets, and this varnish reflects 15 %. Can its BRDF be larger than 1?",
        truth=Term("brdf_paint", {"k_s": 0.15}),
        unit="1/sr",
        choices=(Choice("no, at most 0.15", 0.0, 0.15), Choice("no, at most 1", 0.15, 1.0),
                 Choice("yes: it grows as the highlight shrinks", 1.0, 1e6)),
        sets={"theta_l": 45.0, "theta_v": 45.0, "phi": 180.0, "exponent": 60.0, "channel": 0},
        told="1.65 per steradian at exponent 60, and without end for a mirror. It is a density: 15 % of the light in few "
             "steradians.",
    ),
    notes="""
Say it as a sentence: radiance out, per irradiance in. Not radiance per radiance, which would count a wide sky for no more than
a narrow lamp; hence the unit. Ask how many numbers a measured BRDF is: two angles in, two out, three colours; one
sample a degree makes billions, and that is why there are models. Let someone turn the lamp around: only the azimuth
between lamp and eye counts here, the wood is isotropic. Common wrong answer: f is a share, so at most 1. 5 minutes.
""",
    sources=("Deck, slides The BRDF (1), (2) and (4)", "Nicodemus et al. 1977, Geometrical considerations and nomenclature "
             "for reflectance", "Lafortune & Willems 1994: the highlight"),
    honesty="Exact for this paint, which is made up: matt red and a white highlight of 15 %, with no Fresnel term. Real varnish "
            "reflects more at a slant. The grain of the wood is painted on.",
    values=(Value("theta_l", 45.0, low=0.0, high=85.0), Value("theta_v", 32.0, low=0.0, high=89.0),
            Value("channel", 0, choices=("red", "green", "blue")), Value("half_angle", 4.0, low=0.5, high=25.0),
            Value("exponent", 36.0, low=2.0, high=60.0, more=True), Value("phi", 160.0, more=True)),
    minutes=5,
)

PROPERTIES = Step(
    name="properties",
    title="What a BRDF must not do",
    idea="A BRDF is never negative, is the same when light and eye change places, and gives no more than it gets.",
    slides=(BRDF(3),),
    prose=r"""
The $\colour{v}{\text{solid lobe}}$ is where the light of the lamp goes; the $\colour{l}{\text{other}}$, where it would go if lamp and eye
changed places. Both dots lie on one arc: $f(l,v) = f(v,l)$. Now break the rules:

* [below zero](?flaw=1): a fit that undershoots takes light away;
* [one way](?flaw=2): loss counted going in, not coming out: **Helmholtz reciprocity** is gone;
* [too much](?flaw=3): the $1/\pi$ forgotten;
* [clamped](?flaw=4): not linear, see it with [ten times the light](?flaw=4&radiance=10);
* [0/0](?flaw=5&theta_l=0): the azimuth of a direction that has none.

The badges find each. For energy mind the slide: it prints $\int f\,d\omega \le 1$. The sound surface here has 1.51. What is
bounded is the light, and light has the cosine: $\int f \cos\theta\, d\omega \le 1$, from every side.
""",
    scene=Scene(
        glsl="""
#include "optics/specimen.glsl"
#include "display/lobe.glsl"
#include "display/look.glsl"
#include "display/faults.glsl"
uniform float theta_l;
uniform float theta_v;
uniform float phi;
uniform float radiance;
uniform float exponent;
uniform int flaw;

const vec3 UP = vec3(0.0, 0.0, 1.0);
const float SIZE = 1.35; // metres per 1/sr

float brdf(vec3 from, vec3 to) {
    return brdf_flawed(UP, from, to, radiance, flaw, 0.6, 0.3, exponent) / radiance;
}

vec3 lit_from(int lobe) { // lobe 1: lamp and eye have changed places
    return lobe == 0 ? light_direction(theta_l, phi) : view_direction(theta_v);
}

float drawn(float f) { // NaN as a ball
    return isnan(f) ? 0.7 : SIZE * min(abs(f), 1.8);
}

vec3 surface_point(int surface, vec2 s) {
    if (surface == 2) return vec3(1.75 * cap_point(0.5 * PI, s.x, s.y).xy * s.y, -0.01);
    vec3 from = lit_from(surface), d = lobe_direction(s, reflection_vector(UP, from), 0.3);
    return drawn(brdf(from, d)) * d;
}

vec3 shade(Surface s) {
    if (s.id == 2) return mix(background, palette[COLOUR_QUIET], 0.45 - 0.3 * s.st.y);
    float f = brdf(lit_from(s.id), normalize(s.position));
    if (isnan(f)) return fault_colour(vec3(1.0, 0.0, 0.0), gl_FragCoord.xy);
    if (f < 0.0) return fault_colour(vec3(0.0, 0.0, 1.0), gl_FragCoord.xy);
    return soft_light(s.id == 0 ? palette[COLOUR_V] : palette[COLOUR_L], s.normal, s.v);
}

vec3 mark_point(int mark, float t) {
    vec3 l = light_direction(theta_l, phi), v = view_direction(theta_v);
    if (mark == 0) return 1.5 * t * UP;
    if (mark == 1) return 2.1 * t * l;
    if (mark == 2) return 2.1 * t * v;
    float there = drawn(brdf(l, v)), back = drawn(brdf(v, l));
    if (mark == 3) return there * t * v;
    if (mark == 4) return back * t * l;
    return there * normalize(mix(v, l, t) + vec3(0.0, 0.0, 1e-3)); // as long as f(l,v), around to l
}

vec4 probe(int i) {
    return vec4(2.1 * lit_from(i), 1.0);
}
""",
        surfaces=(Surface("light from l", cells=(40, 24)), Surface("light from v", cells=(40, 24), opacity=0.4),
                  Surface("patch", cells=(48, 1))),
        marks=(Mark("normal", colour="n", tip="arrow", label="n"), Mark("lamp", colour="l", tip="sun", label="l"),
               Mark("eye", colour="v", tip="eye", label="v"), Mark("f(l,v)", colour="v", tip="dot", width=2.0),
               Mark("f(v,l)", colour="l", tip="dot", width=2.0), Mark("as long", colour="exact", line="dashed", segments=32)),
        handles=(Handle("the lamp", 0, ("theta_l", "phi")), Handle("the eye", 1, ("theta_v",))),
        camera=Camera(azimuth=-84, elevation=13, distance=7.0, target=(0.0, 0.0, 0.62)),
        legend=(("v", "light from l, to everywhere"), ("l", "light from v, swapped"), ("exact", "as long as f(l,v)")),
    ),
    plot=(
        Curves(
            title="Two integrals of the lobe", sweep="theta_v",
            curves=(Curve("∫ f cos θ dω, must be ≤ 1", Term("hemisphere_meter", BROKEN | {"weight": 1})),
                    Curve("∫ f dω, as printed", Term("hemisphere_meter", BROKEN | {"weight": 0}), role="printed")),
            y_label="over all directions of the light",
        ),
        Slice("The lobe, cut by the plane of n and l"),
    ),
    readouts=(
        Readout("f(l,v)", Term("brdf_flawed", BROKEN), role="exact", unit="1/sr", absent="0/0, not a number"),
        Readout("f(v,l)", Term("brdf_flawed", BROKEN | {"l": "v", "v": "l"}), role="estimate", unit="1/sr", against="f(l,v)",
                absent="0/0, not a number"),
        Readout("∫ f cos θ dω", Term("hemisphere_meter", BROKEN | {"weight": 1}), unit="", absent="0/0, not a number"),
        Readout("∫ f dω", Term("hemisphere_meter", BROKEN | {"weight": 0}), role="printed", unit="", absent="0/0, not a number"),
    ),
    models=(Model("this surface", Term("brdf_flawed", BROKEN)),),
    ask=Prediction(
        question="A glossy plate, lamp at 70°, camera at 40°: its BRDF there is 0.25 per steradian. Lamp and camera change "
                 "places. What is it now?",
        truth=Term("brdf_flawed", BROKEN | {"l": "v", "v": "l"}),
        unit="1/sr",
        choices=(Choice("less", 0.0, 0.245), Choice("the same", 0.245, 0.255), Choice("more", 0.255, 10.0)),
        sets={"flaw": 0, "theta_l": 70.0, "theta_v": 40.0, "phi": 180.0, "exponent": 20.0, "radiance": 1.0},
        told="The same: light finds its way back. The photograph does get brighter, for the lamp now stands higher; that is the "
             "cosine's doing, and the cosine is no part of f.",
    ),
    notes="""
Five flaws, five badges, and each breaks one only: let the class name the rule before the badge is read. "One way" is the most
common in shipped code, from weighting the diffuse part by the Fresnel loss of the way in alone. "No number" is too: the
azimuth is found by dividing by a length that is 0 when the lamp stands on the normal; a click on the badge goes there.
Then the slide's integral: white paper, f = 1/π, gives 2 without the cosine. Nothing is wrong with paper. 6 minutes.
""",
    sources=("Deck, slide The BRDF (3)", "Helmholtz 1856: reciprocity", "Lewis 1994, Making "
             "shaders more physically plausible"),
    honesty="The surface is made up, k_d = 0.6 and k_s = 0.3. The integrals are exact to ten digits, to three where the clamp "
            "cuts. A badge is a search: it tries some thousand pairs of directions, and can miss a flaw between them.",
    values=(Value("flaw", 0, choices=("sound", "below zero", "one way", "too much", "clamped", "no number")),
            Value("theta_l", 65.0, low=0.0, high=88.0), Value("theta_v", 22.0, low=0.0, high=88.0),
            Value("radiance", 1.0, low=0.1, high=100.0), Value("exponent", 20.0, low=5.0, high=60.0, more=True),
            Value("phi", 180.0, more=True)),
    minutes=6,
)

LAMBERT = Step(
    name="lambert",
    title="Matt: one number, and why π",
    idea="A matt surface has the same BRDF for all directions, ρ/π, because a white one must send back all it gets.",
    slides=("Specular and Diffuse BRDFs", "Diffuse BRDF", "Diffuse BRDF – Lambertian Surfaces (1)",
            "Diffuse BRDF – Lambertian Surfaces (2)"),
    prose=r"""
Reflected and scattered light are modelled apart and added: a **specular** and a **diffuse** BRDF. The simplest diffuse one
is a constant: scattered light has forgotten where it came from.

Which constant? White means that all the light comes back:

$$1 = \int_\Omega f_d \cos\theta\,d\omega = f_d \sum \colour{v}{\cos\theta\,\Delta\Omega} \quad\Rightarrow\quad f_d = \frac{1}{\pi}$$

Let the $\colour{estimate}{\text{tiles}}$ of the sky drop onto the floor: that is the cosine. Dropped, a tile at the rim is
a sliver. Pull the $\colour{l}{\text{rim}}$ down and add: [a cap](?half_angle=45), [all](?half_angle=90). The dome has
$2\pi$, its floor $\pi$.

A surface that keeps some has $f_d = \rho/\pi$, with the **albedo** $\rho$: [snow](?rho=0.9), [soot](?rho=0.04).
""",
    scene=Scene(
        glsl="""
#include "optics/spherical.glsl"
#include "optics/lambert.glsl"
#include "display/look.glsl"
uniform float half_angle;
uniform float rho;
uniform int tile_rows;

const float LIFT = 0.75;                    // of the dome over its floor
const vec3 CHALK = vec3(1.75, -0.55, 0.42);
const vec3 LAMP = vec3(-0.55, -0.50, 0.67);

float tile_cosine(vec2 s) {
    return cos((floor(min(s.y, 0.9999) * float(tile_rows)) + 0.5) * half_angle / float(tile_rows));
}

vec3 surface_point(int surface, vec2 s) {
    vec3 d = cap_point(half_angle, s.x, s.y);
    if (surface == 0) return d + vec3(0.0, 0.0, LIFT);
    if (surface == 1) return vec3(d.xy, 0.004);
    if (surface == 2) return vec3(cap_point(0.5 * PI, s.x, s.y).xy * (1.0 + 0.02 * s.y), 0.0);
    if (surface == 3) return CHALK + 0.42 * sphere_point(s.x, s.y);
    return cap_point(0.5 * PI, s.x, s.y) + vec3(0.0, 0.0, LIFT);
}

vec3 shade(Surface s) {
    vec2 tiles = vec2(float(4 * tile_rows), float(tile_rows));
    float line = grid_lines(s.st, tiles), c = tile_cosine(s.st);
    if (s.id == 0) {
        bool front = dot(s.normal, normalize(s.position - vec3(0.0, 0.0, LIFT))) > 0.0;
        return mix(palette[COLOUR_ESTIMATE] * (front ? 1.0 : 0.6), background, 0.75 * line);
    }
    if (s.id == 1) return mix(palette[COLOUR_V] * (0.45 + 0.55 * c), background, 0.75 * line);
    if (s.id == 2) return mix(background, palette[COLOUR_QUIET], 0.3);
    if (s.id == 3) { // radiance pi f cos, with a lamp that gives a facing white ball radiance 1
        vec3 n = normalize(s.position - CHALK);
        return vec3(PI * brdf_lambert(n, LAMP, s.v, rho) * max(dot(n, LAMP), 0.0) + 0.03 * rho);
    }
    return glass(s.st, tiles);
}

vec3 mark_point(int mark, float t) {
    if (mark == 0) return vec3(0.0, 0.0, (LIFT + 1.3) * t);
    if (mark == 1) return 1.004 * cap_point(half_angle, t, 1.0) + vec3(0.0, 0.0, LIFT);
    if (mark == 2) return vec3(cap_point(half_angle, t, 1.0).xy, 0.01);
    if (mark == 3) return vec3(cap_point(0.5 * PI, t, 1.0).xy, 0.005);
    vec3 d = cap_point(half_angle, 0.125 * float(mark) + 0.08, 1.0);
    return vec3(d.xy, mix(d.z + LIFT, 0.0, t));
}

vec4 probe(int i) {
    if (i == 0) return vec4(cap_point(half_angle, 0.9, 1.0) + vec3(0.0, 0.0, LIFT), 1.0);
    if (i == 1) return vec4(CHALK + vec3(0.0, 0.0, 0.42 * (2.0 * rho - 1.0)), 1.0);
    if (i == 2) return vec4(-0.95, -0.6, LIFT + 0.75, 1.0);
    return i == 3 ? vec4(-0.55, -1.05, -0.1, 1.0) : vec4(CHALK + vec3(0.0, 0.0, -0.62), 1.0);
}
""",
        surfaces=(Surface("tiles", cells=(64, 12), opacity=0.86), Surface("dropped tiles", cells=(64, 12)),
                  Surface("floor", cells=(64, 1)), Surface("chalk", cells=(32, 16)),
                  Surface("dome", cells=(48, 12), opacity=0.16)),
        marks=(Mark("normal", colour="n", tip="arrow", label="n"), Mark("rim", colour="l", segments=96, width=1.5),
               Mark("dropped rim", colour="v", segments=96), Mark("edge", colour="quiet", segments=96),
               *(Mark(f"drop {i}", colour="v", line="dotted", width=0.8) for i in range(8))),
        labels=(Label("ΔΩ", 2, "estimate"), Label("cos θ ΔΩ", 3, "v"), Label("albedo ρ", 4)),
        handles=(Handle("the rim", 0, ("half_angle",)), Handle("the albedo", 1, ("rho",))),
        legend=(("estimate", "tiles of the sky"), ("v", "dropped: times cos θ")),
        camera=Camera(azimuth=-62, elevation=24, distance=7.6, target=(0.3, 0.0, 0.72)),
    ),
    plot=Curves(
        title="From the pole to the horizon", sweep="half_angle",
        curves=(Curve("dropped, ∫ cos θ dω", Term("projected_solid_angle_cone")),
                Curve("sum over the tiles", Term("cosine_sum"), role="estimate"),
                Curve("the tiles themselves, ∫ dω", Term("solid_angle_cone"), role="printed")),
        y_label="sr",
    ),
    readouts=(
        Readout("tiles ∫ dω", Term("solid_angle_cone")),
        Readout("dropped ∫ cos θ dω", Term("projected_solid_angle_cone"), role="exact"),
        Readout("Σ cos θ ΔΩ", Term("cosine_sum"), role="estimate", against="dropped ∫ cos θ dω"),
        Readout("f = ρ/π", Term("brdf_lambert", {"n": UP, "l": UP, "v": UP}), role="exact", unit="1/sr"),
    ),
    models=(Model("matt", Term("brdf_lambert")),),
    ask=Prediction(
        question="A white, matt surface sends back all it gets, evenly. Its BRDF is one number. Which?",
        truth=Term("brdf_lambert", {"n": UP, "l": UP, "v": UP, "rho": 1.0}),
        unit="1/sr",
        choices=(Choice("1: it sends back everything", 0.9, 1.1), Choice("1/π: the floor of the dome", 0.3, 0.34),
                 Choice("1/2π: there are 2π sr of sky", 0.15, 0.17)),
        sets={"rho": 0.95, "half_angle": 90.0},
        told="1/π = 0.318. Light at a slant is spread over more floor, so 2π steradians of sky count as π only.",
    ),
    notes="""
The π of every diffuse shader, and half of all renderers have lost it once. Let the class vote first; 1/2π is the clever wrong
answer: it divides by the sky and forgets that the floor does not see all of it alike. Then drop the tiles. Six rows give
π to one percent, because the cosine is taken in a tile's middle; twelve rows to a quarter of that. Ask for the albedo of fresh
snow, 0.9, of charcoal, 0.04, and why a grey card is 18 %: it looks half as bright. 5 minutes.
""",
    sources=("Deck, slides Specular and Diffuse BRDFs to Lambertian Surfaces (2)", "Lambert 1760, Photometria",
             "Nusselt 1928: graphic form factor"),
    honesty="Exact for an ideally matt surface. Real ones are only nearly so: chapter 5 shows the Moon. The ball has a single "
            "lamp, at the upper left, and a little light from everywhere, so that its dark side can be seen.",
    values=(Value("half_angle", 70.0, low=2.0, high=90.0), Value("rho", 0.8), Value("tile_rows", 6)),
    minutes=5,
)

LEFT, RIGHT, BELOW, FLAT = (-0.6, 0.0, 0.8), (0.6, 0.0, 0.8), (0.6, 0.0, -0.8), (0.0, -0.96, 0.28)

LAMBERT_EXERCISE = Exercise(
    name="lambert",
    function="brdf_lambert",
    task="Write the BRDF of an ideally diffuse surface. It is no light, only the factor: the cosine is not in it. Light or "
         "eye below the surface: 0.",
    slide="Diffuse BRDF – Lambertian Surfaces (2)",
    stubs={"python": '''import numpy as np


def brdf_lambert(n, l, v, rho):
    """The BRDF in 1/sr. n, l, v: (..., 3), unit vectors; rho: (...), the albedo."""
    return np.zeros(np.shape(n)[:-1])
''', "glsl": '''float brdf_lambert(vec3 n, vec3 l, vec3 v, float rho) {
    return 0.0;
}
'''},
    solutions={"python": '''import numpy as np


def brdf_lambert(n, l, v, rho):
    """The same in every direction; light and eye must both be above the surface."""
    above = (np.sum(n * l, -1) > 0) & (np.sum(n * v, -1) > 0)
    return np.where(above, rho / np.pi, 0.0)
''', "glsl": '''float brdf_lambert(vec3 n, vec3 l, vec3 v, float rho) {
    return dot(n, l) > 0.0 && dot(n, v) > 0.0 ? rho / 3.14159265358979 : 0.0; // no cosine: that is the equation's
}
'''},
    checks=(
        Check({"n": (UP, UP), "l": (UP, LEFT), "v": (UP, RIGHT), "rho": (1.0, 1.0)}, "white: 1/π, and not 1/2π"),
        Check({"n": (UP, UP, UP), "l": (LEFT, RIGHT, FLAT), "v": (RIGHT, FLAT, UP), "rho": (0.5, 0.18, 0.8)},
              "grey, from several sides: no cosine"),
        Check({"n": (UP, UP, UP), "l": (BELOW, LEFT, LEFT), "v": (RIGHT, BELOW, FLAT), "rho": (0.5, 0.5, 0.5)},
              "light or eye below: 0"),
        Check({"n": (LEFT, BELOW, FLAT), "l": (UP, BELOW, FLAT), "v": (FLAT, RIGHT, UP), "rho": (0.3, 0.9, 0.05)},
              "a surface that is tilted, or looks down", hidden=True),
    ),
)

CHAPTER = Chapter(
    title="BRDFs",
    idea="A BRDF says how much of the light from one direction a surface sends into another.",
    steps=(BALANCE, REFLECTANCE_EQUATION, DEFINITION, PROPERTIES, LAMBERT),
    exercises=(LAMBERT_EXERCISE,),
    terms={
        "BRDF": "outgoing radiance in one direction over irradiance from another, per steradian",
        "albedo": "the share of the arriving light that a surface sends back",
    },
)
