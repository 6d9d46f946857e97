"""Why does paper look alike from every side, and a plate of steel not? A BRDF says where a surface sends its light.

It is one function of two directions: how much of the light from here goes there. This chapter takes the equation apart
in which it stands, asks what such a function must never do, and builds the two that have shaded screens for decades.
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
PI = 3.141592653589793
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
const float TALL = 2.1;    // of the bar
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
    if (surface == 1) return vec3(BAR + 0.36 * s.x, -0.01, -1.25 + TALL * 2.0 * s.y);
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
        float u = s.st.y * 2.0 / max(cos(theta_l), 0.02); // of what arrives
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
        question="100 W/m² arrive: 20 % are reflected, 50 % scattered, and nothing shines through. How much leaves the patch?",
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
With [fewer tiles](?tile_rows=3&theta_v=55&phi=180&theta_l=55) it slips between their middles.
""",
    scene=Scene(
        glsl="""
#include "optics/sky.glsl"
#include "display/look.glsl"
#include "stage/camera.glsl"
uniform float theta_l, phi, theta_v, sun_radiance, exponent, k_s;
uniform int tile_rows, layer;

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

vec4 surface_value(int surface, vec2 s) { return vec4(light_direction(theta_l, phi), sin(theta_v)); }

vec3 shade(Surface s) {
    if (s.id == 1) return mix(background, palette[COLOUR_QUIET], 0.32 * (1.0 - smoothstep(0.7, 1.0, s.st.y)));
    if (s.id == 2) return palette[COLOUR_EXACT];
    vec3 l = tile_middle(s.st);
    if (dot(l, normalize(camera_position)) > 0.35) discard; // cut open towards the reader
    vec3 to_sun = s.value.xyz, v = vec3(s.value.w, 0.0, sqrt(max(1.0 - s.value.w * s.value.w, 0.0)));
    vec3 light = vec3(1.0), weight = vec3(1.0);
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
        surfaces=(Surface("sky", cells=(48, 10)), Surface("floor", cells=(48, 1)), Surface("patch", cells=(1, 1))),
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
        question="A low sun, 80° from the normal, has 25 times the radiance of the blue overhead. The eye looks from 30°, aside. "
                 "Which part of the sky matters most to it?",
        truth=Term("sun_share", UNDER_SKY),
        unit="of the light is the sun's",
        choices=(Choice("the sun, by far", 0.5, 1.0), Choice("the sun and the blue, about half each", 0.3, 0.5),
                 Choice("the blue where the eye is mirrored", 0.0, 0.3)),
        sets={"theta_l": 80.0, "phi": 90.0, "theta_v": 30.0, "sun_radiance": 25.0, "k_s": 0.7, "exponent": 40.0},
        told="The blue. The sun gives 0.03 of it: it is strong, but low (cosine 0.17), and this eye's BRDF looks elsewhere. Seven "
             "tenths come by the highlight, from the small blue spot where the eye is mirrored.",
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
uniform float theta_l, theta_v, phi, exponent, half_angle;
uniform int channel;

const vec3 UP = vec3(0.0, 0.0, 1.0);
const float K_S = 0.15;
const float SCALE = 1.45; // metres per 1/sr

float spread(vec3 l, vec3 d, int c) { return brdf_paint(UP, l, d, c, K_S, exponent); }

vec4 surface_value(int surface, vec2 s) { return vec4(light_direction(theta_l, phi), 0.0); }

vec3 surface_point(int surface, vec2 s) {
    vec3 l = light_direction(theta_l, phi);
    if (surface == 0) {
        vec3 d = lobe_direction(s, reflection_vector(UP, l), 0.25);
        return SCALE * lobe_radius(spread(l, d, channel), 1.0, 0.0) * d;
    }
    if (surface == 1) return SCALE * cap_point(0.5 * PI, s.x, s.y);
    if (surface == 2) return vec3(1.9 * (2.0 * s - 1.0) * vec2(1.0, 0.8), -0.012);
    vec3 rim = cos(2.0 * PI * s.x) * direction_theta(theta_l, phi) + sin(2.0 * PI * s.x) * direction_phi(phi);
    return 1.9 * s.y * (cos(half_angle) * l + sin(half_angle) * rim); // the beam
}

vec3 shade(Surface s) {
    if (s.id == 0) { // in the colour that the eye sees from there
        vec3 d = normalize(s.position), l = s.value.xyz, f = vec3(spread(l, d, 0), spread(l, d, 1), spread(l, d, 2));
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
    return SCALE * spread(light_direction(theta_l, phi), view_direction(theta_v), channel) * t * view_direction(theta_v);
}

vec4 probe(int i) {
    return vec4(2.0 * (i == 0 ? light_direction(theta_l, phi) : view_direction(theta_v)), 1.0);
}
""",
        surfaces=(Surface("lobe", cells=(40, 20)), Surface("f = 1", cells=(48, 12), opacity=0.14),
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
    return ratio_flawed(UP, from, to, radiance, flaw, 0.6, 0.3, exponent);
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
        Slice("Cut by the plane of n and l", (Model("this surface, L = 1", Term("brdf_flawed", BROKEN | {"radiance": 1.0})),)),
    ),
    readouts=(
        Readout("f(l,v)", Term("ratio_flawed", BROKEN), role="exact", unit="1/sr", absent="0/0, not a number"),
        Readout("f(v,l)", Term("ratio_flawed", BROKEN | {"l": "v", "v": "l"}), role="estimate", unit="1/sr", against="f(l,v)",
                absent="0/0, not a number"),
        Readout("∫ f cos θ dω", Term("hemisphere_meter", BROKEN | {"weight": 1}), unit="", absent="0/0, not a number"),
        Readout("∫ f dω", Term("hemisphere_meter", BROKEN | {"weight": 0}), role="printed", unit="", absent="0/0, not a number"),
    ),
    models=(Model("this surface", Term("brdf_flawed", BROKEN)),),
    ask=Prediction(
        question="A glossy plate, lamp at 70°, camera at 40°. In the photograph its radiance is 0.086 per unit of the lamp's "
                 "light. Lamp and camera change places. And now?",
        truth=Term("highlight_share", {"model": 1, "theta_l": "theta_v", "theta_v": "theta_l", "k_d": 0.6, "k_s": 0.3}),
        unit="1/sr",
        choices=(Choice("less", 0.0, 0.085), Choice("the same: f(l,v) = f(v,l)", 0.085, 0.087), Choice("more", 0.087, 10.0)),
        sets={"flaw": 0, "theta_l": 70.0, "theta_v": 40.0, "phi": 180.0, "exponent": 20.0, "radiance": 1.0},
        told="More: 0.19, over twice as much. f is 0.25 both ways, but the lamp now stands higher, and its light is spread over "
             "less of the plate. That is the cosine's doing, and the cosine is no part of f.",
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
            Value("theta_l", 65.0, low=0.0, high=88.0), Value("theta_v", 45.0, low=0.0, high=88.0),
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

[Which constant](code:brdf_lambert)? White means that all the light comes back:

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
#include "display/balls.glsl"
#include "display/look.glsl"
uniform float half_angle, rho;
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
    if (surface == 3) return cap_to_eye(s, CHALK, 0.42);
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
        vec3 n = ball_normal((s.position - CHALK) / 0.42, s.v);
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
                  Surface("floor", cells=(64, 1)), Surface("chalk", cells=(40, 3)),
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
        question="The cap up to 60° from the normal is half of the sky: π of its 2π steradians. Dropped, how much of the floor's π "
                 "does it cover?",
        truth=Term("projected_solid_angle_cone", {"half_angle": PI / 3}),
        unit="sr",
        choices=(Choice("half of it: 1.57", 1.5, 1.6), Choice("three quarters: 2.36", 2.3, 2.4),
                 Choice("all of it: 3.14", 3.1, 3.2)),
        sets={"half_angle": 60.0},
        told="Three quarters: π sin² 60°. The other half of the sky, low down, has the last quarter: its light comes at a "
             "slant and is spread thin. So 2π steradians of sky count as π only.",
    ),
    notes="""
The π of every diffuse shader, lost in many a renderer. Let the class vote on the constant before this page is up: 1, 1/π or
1/2π? The last is the clever wrong answer: it divides by the sky and forgets that the floor does not see all of it alike. Then
drop the tiles; the usual wrong answer to the question is half. Six rows give
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

# --- highlights: Phong, Blinn, and what they lack ---------------------------------------------------------------------
HIGHLIGHTS = ("Phong, as printed", "Phong, as a BRDF", "Blinn, as printed", "Blinn, as a BRDF")
SWAPPED = {"theta_l": "theta_v", "theta_v": "theta_l"}

PHONG = Step(
    name="phong",
    title="Phong: a highlight around the mirror direction",
    idea="Phong's highlight is a power of the cosine between the eye and the mirror direction; as printed it is no BRDF.",
    slides=("Specular BRDF – A Simple Model", "The Phong Model for Specular BRDF (1)",
            "The Phong Model for Specular BRDF (2)", "The Phong Model for Specular BRDF (3)",
            "Phong Model: The Reflection Vector"),
    prose=r"""
Varnish mirrors, but not sharply: it sends light *near* the $\colour{r}{\text{mirror direction}}$

$$\colour{r}{r} = 2\,\colour{n}{n}\,(\colour{n}{n}\cdot\colour{l}{l}) - \colour{l}{l}$$

Phong's guess of 1975: let it fall off as a [power of a cosine](code:lobe_phong). The exponent is the tightness.

$$L_o = \left(k_d\,\colour{n}{n}\cdot\colour{l}{l} + k_s\,(\colour{r}{r}\cdot\colour{v}{v})^n\right) L_i$$

Try [wide](?exponent=5), [tight](?exponent=200). The body shows $f = L_o/(L_i\,n\cdot l)$, the BRDF behind the formula.

Now [low light](?theta_l=80&theta_v=80). The highlight was printed without $n\cdot l$, so $f$ grows as $1/(n\cdot l)$, beyond all
bounds, and [swapping](?theta_l=60&theta_v=80) light and eye changes it. The cure puts the cosine back:
[as a BRDF](?model=1), $k_d/\pi + k_s\frac{n+2}{2\pi}(r\cdot v)^n$.
""",
    scene=Scene(
        glsl="""
#include "optics/highlight.glsl"
#include "display/balls.glsl"
#include "display/lobe.glsl"
#include "display/look.glsl"
uniform int model;
uniform float theta_l, theta_v, phi, k_d, k_s, exponent;

const float TALL = 1.6;                      // the lobe for light from above
const float LONGEST = 2.75;                  // where it is cut off
const vec3 BALL = vec3(0.0, 0.0, -1.75);
const vec3 UP = vec3(0.0, 0.0, 1.0);

vec3 mirrored() {
    return reflection_vector(UP, light_direction(theta_l, phi));
}

float length_along(vec3 d) {
    vec3 l = light_direction(theta_l, phi);
    float f = model == 0 ? brdf_phong_printed(UP, l, d, k_d, k_s, exponent) : brdf_phong(UP, l, d, k_d, k_s, exponent);
    return TALL * lobe_radius(f, highlight_peak(model, k_d, k_s, exponent), 0.0);
}

vec3 surface_point(int surface, vec2 s) {
    if (surface == 0) {
        vec3 d = lobe_direction(s, mirrored(), half_width_phong(exponent));
        return d * min(length_along(d), LONGEST);
    }
    if (surface == 1) return vec3(1.6 * s.y * cos(2.0 * PI * s.x), 1.6 * s.y * sin(2.0 * PI * s.x), -0.01);
    return cap_to_eye(s, BALL, 1.25);
}

vec4 surface_value(int surface, vec2 s) { return vec4(light_direction(theta_l, phi), 0.0); }

vec3 shade(Surface s) {
    if (s.id == 0) {
        bool cut = length(s.position) > LONGEST - 0.01;
        vec3 body = soft_light(palette[cut ? COLOUR_PRINTED : COLOUR_ESTIMATE], s.normal, s.v);
        return mix(body, background, 0.35 * grid_lines(s.st, vec2(24.0, 12.0)));
    }
    if (s.id == 1) return mix(background, palette[COLOUR_QUIET], 0.28 + 0.25 * grid_lines(s.st, vec2(24.0, 4.0)));
    vec3 n = ball_normal((s.position - BALL) / 1.25, s.v), l = s.value.xyz;
    float lit = max(dot(n, l), 0.0), gloss = model == 0 ? shading_phong(n, l, s.v, 0.0, k_s, exponent)
        : PI * lit * brdf_phong(n, l, s.v, 0.0, k_s, exponent);
    vec3 paint = vec3(0.85, 0.16, 0.10) * (k_d * lit + 0.02) + vec3(gloss);
    return paint / (1.0 + 0.35 * paint);
}

vec3 mark_point(int mark, float t) {
    vec3 l = light_direction(theta_l, phi);
    if (mark == 0) return 1.9 * t * UP;
    if (mark == 1) return 2.5 * t * l;
    if (mark == 2) return 2.5 * t * mirrored();
    if (mark == 3) return 2.5 * t * view_direction(theta_v);
    if (mark == 4) return BALL + (1.3 + 0.9 * (1.0 - t)) * l;
    float angle = theta_l * (2.0 * t - 1.0);
    vec3 flat_l = vec3(cos(phi), sin(phi), 0.0);
    return 0.75 * (cos(angle) * UP + sin(angle) * flat_l);
}

vec4 probe(int i) {
    if (i == 0) return vec4(2.5 * light_direction(theta_l, phi), 1.0);
    return vec4(2.5 * view_direction(theta_v), 1.0);
}
""",
        surfaces=(Surface("lobe", cells=(48, 36), opacity=0.92), Surface("floor", cells=(96, 1)),
                  Surface("ball", cells=(64, 3))),
        marks=(
            Mark("normal", colour="n", tip="arrow", label="n"), Mark("to the light", colour="l", tip="sun", label="l"),
            Mark("mirror", colour="r", line="dotted", tip="arrow", label="r"),
            Mark("to the eye", colour="v", tip="eye", label="v"), Mark("light on the ball", colour="l", tip="arrow"),
            Mark("angles", segments=32, width=0.8),
        ),
        handles=(Handle("the light", 0, ("theta_l", "phi")), Handle("the eye", 1, ("theta_v",))),
        legend=(("estimate", "f for this light"), ("printed", "cut off: it goes on")),
        camera=Camera(azimuth=-82, elevation=12, distance=12.8, target=(0.0, 0.0, -0.35), field_of_view=26),
    ),
    plot=(
        Curves("Leaves, over what arrives", "theta_l", (
            Curve("as a BRDF", Term("highlight_flux", {"model": 1})),
            Curve("as printed", Term("highlight_flux", {"model": 0}), role="printed")), y_label="share of what arrives"),
        Slice("f in the plane of n and l", kind="angle"),
        Lobes("f over all directions of the eye"),
    ),
    readouts=(
        Readout("f, l to v", Term("highlight_brdf"), unit="1/sr"),
        Readout("f, v to l", Term("highlight_brdf", SWAPPED), unit="1/sr"),
        Readout("leaves, of what arrives", Term("highlight_flux"), unit=""),
    ),
    ask=Prediction(
        question="The formula as printed, k_d = 0, k_s = 1, exponent 5, and light 85° from the normal. How much light leaves, "
                 "over what arrives?",
        truth=Term("highlight_flux", {"model": 0, "k_d": 0.0, "k_s": 1.0, "exponent": 5.0}),
        unit="of it",
        low=0.0,
        high=4.0,
        sets={"model": 0, "theta_l": 85.0, "exponent": 5.0, "k_d": 0.0, "k_s": 1.0},
        told="2.23: more than twice what arrives. At 90° nothing arrives, and the highlight is as strong as ever.",
    ),
    notes="""
Let the class build r with two pencils before the formula: project l on n, go there twice, come back. Then turn the exponent
and name it: a knob, no physics. The prediction is the turn of the step: most say 1 at the most. Drag the light down and the
body shoots out of the picture. Put the light behind the ball at a low exponent: its highlight ends on the shadow line as if
cut with a knife. Ask which sides of the equation the missing cosine was on. Swapped at 0.3 and
1.2 rad, azimuth 2.5, exponent 20: 1.2e-5 against 3.2e-5. So the energy badge, a sum over l, and the number here, a sum over
v, differ. 6 minutes.
""",
    sources=("Deck, slides Specular BRDF - A Simple Model to Phong Model: The Reflection Vector", "Phong 1975, Illumination for "
             "computer generated pictures", "Lewis 1994, Making shaders more physically plausible",
             "Lafortune and Willems 1994, Using the modified Phong reflectance model"),
    honesty="The two formulas are exact, and so are their fluxes. Each body is drawn to its own scale, the same length for light "
            "from above. The ball has one lamp and no room; its highlights are compressed to fit the screen.",
    values=(Value("model", 0, low=0, high=1, choices=HIGHLIGHTS[:2]), Value("exponent", 20.0, low=1.0, high=1000.0, scale="log"),
            Value("theta_l", 50.0, low=0.0, high=89.0), Value("theta_v", 35.0, low=0.0, high=89.0),
            Value("phi", 180.0, more=True), Value("k_d", 0.25, more=True), Value("k_s", 0.6, more=True)),
    models=(Model("as printed", Term("brdf_phong_printed"), "printed"), Model("as a BRDF", Term("brdf_phong"))),
    minutes=6, breaks=(Break("(r·v)ⁿ without asking for its sign", {"lobe_phong": "lobe_phong_naive"}, {"model": 0, "exponent": 20.0, "theta_l": 50.0, "theta_v": 60.0, "phi": 0.0}, "Where the eye is more than a right angle from r, the cosine is negative. On most cards a power of that is no number, and all that it touches is lost; on some, as with an even exponent multiplied out, a second highlight shines behind. Stop the cosine at 0 first, and only then take the power.", "(r·v)ⁿ", Term("lobe_phong")),),
)

BLINN = Step(
    name="blinn",
    title="Blinn: a highlight around the halfway vector",
    idea="Blinn compares the halfway vector with the normal; at grazing angles its highlights stretch, as real ones do.",
    slides=("The Blinn Model (1)", "The Blinn Model (2)", "The Blinn Model (3)"),
    prose=r"""
A small mirror sends light from $\colour{l}{l}$ to $\colour{v}{v}$ if its normal lies halfway between them:

$$\colour{h}{h} = \frac{\colour{v}{v} + \colour{l}{l}}{|\colour{v}{v} + \colour{l}{l}|}, \qquad
k_s\,(\colour{n}{n}\cdot\colour{h}{h})^{n'}$$

So $(n\cdot h)$ asks [how far the facets must tilt](code:lobe_blinn). Move the eye by an angle: $\colour{r}{r}$ is off by all of it,
$\colour{h}{h}$ by half. For equal width Blinn's exponent is four times Phong's, and the two halves of the picture have that.

Out of the plane it is different. [High over the road](?theta_v=50&theta_l=50) they are still alike. Now [at eye level](?theta_v=80&theta_l=80): Phong
mirrors round spots, Blinn draws streaks. Every photo of a wet road at night has streaks. Try a
[smoother film](?exponent=600), a [drier road](?exponent=25).
""",
    scene=Scene(
        glsl="""
#include "optics/blinn_phong.glsl"
#include "core/chance.glsl"
#include "display/palette.glsl"
uniform float theta_v, exponent;

const float LAMP_DISTANCE = 30.0, LAMP_HEIGHT = 4.0; // of the nearest lamp, which mirrors at theta_v
const float HALF_VIEW = 0.45;                        // tangent of half the field of view
const float OFF = 0.35;                              // how far the drawn eye is off the mirror direction
const float SHOWN = 0.78;                            // of the view, from below: a strip of night is left out
const vec3 DRAWING = vec3(0.0, -0.1, 1.62);

// The picture is a card; behind it a road along +y, mirrored at its middle. Left: Phong, right: Blinn. The drawing is above.
vec3 surface_point(int surface, vec2 s) {
    float top = 4.4 * SHOWN - 2.2, horizon = clamp(2.2 / HALF_VIEW * tan(0.5 * PI - theta_v - 0.064), -2.2, top);
    if (surface == 0) return vec3(4.4 * s.x - 2.2, 0.0, mix(horizon, top, s.y));
    return vec3(2.2 * (surface == 1 ? s.x - 1.0 : s.x), 0.0, mix(-2.2, horizon, s.y));
}

vec4 surface_value(int surface, vec2 s) { // height of the eye, exponent, exposure, tangent of how far it looks down
    float tight = blinn_exponent(exponent), high = max(LAMP_DISTANCE / tan(theta_v) - LAMP_HEIGHT, 0.3), exposure = 1.3 / cos(theta_v);
    if (surface == 2) exposure *= normalisation_blinn_phong(tight) / normalisation_phong(exponent);
    return vec4(high, surface == 1 ? exponent : tight, exposure, tan(0.5 * PI - theta_v - 0.06));
}

vec3 city(vec3 d) {
    float a = 26.0 * abs(d.x) / d.y + 3.0, up = 26.0 * d.z / d.y, block = floor(a);
    float roof = 0.35 + 1.7 * chance(int(block), 0) * chance(int(block), 1);
    vec3 night = mix(vec3(0.045, 0.05, 0.085), vec3(0.006, 0.008, 0.02), smoothstep(0.0, 4.0, up));
    if (up > roof) return night;
    vec2 pane = vec2(fract(a) * 6.0, up * 8.0);
    bool lit = chance(128 * int(block) + 6 * int(pane.y) + int(pane.x), 2) > 0.72 && up > 0.12;
    vec2 at = abs(fract(pane) - 0.5);
    return lit && max(at.x, at.y) < 0.3 ? vec3(0.50, 0.36, 0.17) : vec3(0.010, 0.011, 0.016);
}

vec3 lamp_position(int i) {
    if (i == 0) return vec3(2.3, LAMP_DISTANCE, LAMP_HEIGHT);
    return i == 1 ? vec3(9.6, 1.7 * LAMP_DISTANCE, 1.25 * LAMP_HEIGHT) : vec3(1.3, 2.6 * LAMP_DISTANCE, 0.8 * LAMP_HEIGHT);
}

vec3 lamp_colour(int i) {
    return i == 0 ? vec3(1.0, 0.62, 0.25) : i == 1 ? vec3(0.55, 0.75, 1.0) : vec3(1.0, 0.10, 0.06);
}

vec3 shade(Surface s) {
    float high = s.value.x, down = s.value.w;
    vec2 at = HALF_VIEW / 2.2 * vec2(abs(s.position.x), s.position.z);
    vec3 d = normalize(vec3(at.x * sqrt(1.0 + down * down), 1.0 + at.y * down, at.y - down));
    vec3 eye = vec3(0.0, 0.0, high), glow = vec3(0.0);
    for (int i = 0; i < 3; i++) {
        vec3 to = lamp_position(i) - eye;
        float off = length(cross(d, to)) / 0.45;
        glow += lamp_colour(i) * (off < 1.0 && dot(d, to) > 0.0 ? 1.7 : 0.10 / (off * off + 1.0));
    }
    if (s.id == 0) return min(city(d) + glow, 1.0);
    vec3 p = eye - d * (high / min(d.z, -0.002)), n = vec3(0.0, 0.0, 1.0), light = vec3(0.0);
    for (int i = 0; i < 3; i++) {
        vec3 to = lamp_position(i) - p, l = normalize(to);
        float lobe = s.id == 1 ? lobe_phong(n, l, -d, s.value.y) : lobe_blinn(n, l, -d, s.value.y);
        light += lamp_colour(i) * (lobe * l.z * s.value.z);
    }
    float far = length(p - eye), line = step(abs(p.x - 5.0), 0.10) + step(abs(p.x - 1.1), 0.06) * step(fract(p.y / 6.0), 0.5);
    light += vec3(0.10) * line / (1.0 + 0.02 * far) + vec3(0.006, 0.007, 0.010) + glow * 0.2;
    return light / (1.0 + light);
}

vec3 drawn(float angle) { return vec3(sin(angle), 0.0, cos(angle)); }

vec3 mark_point(int mark, float t) {
    if (mark == 0) return vec3(0.0, -0.05, 4.4 * SHOWN * t - 2.2);
    if (mark == 1) return DRAWING + 0.62 * t * drawn(0.0);
    if (mark == 2) return DRAWING + 1.25 * t * drawn(-theta_v);
    if (mark == 3) return DRAWING + 1.25 * t * drawn(theta_v - OFF);
    if (mark == 4) return DRAWING + 0.62 * t * drawn(-0.5 * OFF);
    if (mark == 5) return DRAWING + 1.05 * t * drawn(theta_v);
    if (mark == 6) return DRAWING + 0.85 * drawn(theta_v - OFF * t);
    if (mark == 7) return DRAWING + 0.45 * drawn(-0.5 * OFF * t);
    return DRAWING + vec3(2.4 * t - 1.2, 0.0, 0.0);
}

vec4 probe(int i) {
    if (i == 0) return vec4(DRAWING + 1.25 * drawn(-theta_v), 1.0);
    return vec4(i == 1 ? -1.8 : 1.8, -0.1, 1.44, 1.0);
}
""",
        surfaces=(Surface("city", cells=(1, 1)), Surface("wet road, Phong", cells=(1, 1)), Surface("wet road, Blinn", cells=(1, 1))),
        marks=(
            Mark("middle", colour="quiet", line="dashed", width=0.7),
            Mark("normal", colour="n", tip="arrow", label="n"), Mark("to the light", colour="l", tip="sun", label="l"),
            Mark("to the eye", colour="v", tip="eye", label="v"),
            Mark("halfway", colour="h", line="dashed", tip="arrow", label="h"),
            Mark("mirror", colour="r", line="dotted", tip="arrow", label="r"),
            Mark("off r", colour="r", segments=12), Mark("off n", colour="h", segments=8), Mark("surface", colour="quiet"),
        ),
        labels=(Label("Phong", 1), Label("Blinn", 2)),
        handles=(Handle("the light", 0, ("theta_v",)),),
        legend=(("r", "v off r"), ("h", "h off n: half of it")),
        camera=Camera(azimuth=-90, elevation=0, distance=12.0, target=(0.0, 0.0, 0.31), field_of_view=23.8),
    ),
    plot=(
        Curves("Length of the highlight over its width", "theta_v", (
            Curve("Blinn", Term("highlight_stretch")),
            Curve("Phong", Term("highlight_stretch", {"theta_v": 0.0}), role="estimate")), y_label="times"),
        Slice("f in the plane of n and l", kind="angle"),
        Lobes("f, equally wide in the plane of l and n",
              camera=Camera(azimuth=24, elevation=30, distance=4.3, target=(0.1, 0.0, 0.25))),
    ),
    readouts=(
        Readout("Blinn's exponent n'", Term("blinn_exponent"), role="exact", unit=""),
        Readout("4 n", Term("blinn_exponent_short"), role="estimate", unit="", against="Blinn's exponent n'"),
        Readout("Blinn: length / width", Term("highlight_stretch"), unit=""),
    ),
    ask=Prediction(
        question="Lamp and eye stand opposite, both 80° from the normal, so h is n. The eye steps aside, 10° around the normal. "
                 "How far does h tip?",
        truth=Term("halfway_angle", {"theta_l": 4 * PI / 9, "theta_v": 4 * PI / 9, "phi": 17 * PI / 18}),
        unit="rad from n",
        choices=(Choice("5°: half as far, as before", 0.08, 0.095), Choice("10°: as far as the eye", 0.17, 0.18),
                 Choice("26°: far more", 0.44, 0.48)),
        sets={"theta_v": 80.0, "theta_l": 80.0, "phi": 170.0},
        told="26°. Up and down h turns half as far as the eye; aside, at a glancing angle, nearly three times as far. So the "
             "highlight is 5.8 times as long as wide: 1/cos 80°.",
    ),
    notes="""
Ask for a photo of a wet street at night; someone has one. Which half of the picture is it? Then why: lay two pencils nearly
flat, l and v, and turn v sideways by a little: their bisector swings wildly. Turn it up by as much: half. "Faster to compute",
says the slide. Count: r.v = 2 (n.l)(n.v) - l.v needs no root; h needs one. Only with the sun and a far eye is h constant
and Blinn the faster one. Ngan and others fitted a hundred measured materials: half vectors win. 6 minutes.
""",
    sources=("Deck, slides The Blinn Model (1) to (3)", "Blinn 1977, Models of light reflection for computer synthesized pictures",
             "Fisher and Woo 1994, R.E versus N.H specular highlights", "Ngan, Durand and Matusik 2005, Experimental analysis "
             "of BRDF models"),
    honesty="Both halves are normalised BRDFs, evaluated for each pixel; the lamps' light does not fall off with distance, and the "
            "exposure follows the exponent. The road is flat, the city painted, bright spots are compressed. 1/cos is the limit for tight highlights.",
    values=(Value("theta_v", 79.0, low=45.0, high=81.0), Value("exponent", 150.0, low=8.0, high=1000.0, scale="log"),
            Value("theta_l", 79.0, low=0.0, high=89.0, more=True), Value("phi", 180.0, more=True)),
    models=(Model("Phong", Term("brdf_phong", {"k_d": 0.0, "k_s": 1.0})),
            Model("Blinn, equally wide", Term("brdf_blinn_phong_as_wide", {"k_d": 0.0, "k_s": 1.0}), "h")),
    minutes=6,
)

NORMALISATION = Step(
    name="normalisation",
    title="The importance of being normalised",
    idea="A tighter highlight must be a brighter one: only a factor that grows with the exponent keeps its flux.",
    slides=("Is the Phong-Blinn Model Realistic?", "The Importance of Being Normalized (1)",
            "The Importance of Being Normalized (2)", "Normalized Blinn-Phong Model"),
    prose=r"""
Polish a ball. Its highlight shrinks, and all the light that was spread over a wide spot now goes into a small one: it
must become brighter.

In the $\colour{printed}{\text{upper row}}$ it does not. Its peak is $k_s$ whatever the exponent, so the flux under it, the bar,
goes with the width:

$$\colour{printed}{\int_\Omega (n\cdot h)^n \cos\theta\,d\omega} = \frac{8\pi\,(n + 2^{-n/2})}{(n+2)(n+4)}$$

With $k_s = 1$ [exponent 5](?exponent=5&k_s=1) gives twice what arrives, [exponent 1000](?exponent=1000&k_s=1) a fortieth. An artist then turns $k_s$ up
by hand, after every polish again.

The $\colour{exact}{\text{lower row}}$ [divides by the integral](code:normalisation_blinn_phong). Now the exponent changes the shape alone, and $k_s$ is what it
says: the share sent back.
""",
    scene=Scene(
        glsl="""
#include "optics/highlight.glsl"
#include "display/balls.glsl"
#include "display/palette.glsl"
uniform float exponent;
uniform float k_s;

const vec3 LAMP = vec3(-0.42, -0.68, 0.60);
const float METER = 1.15; // length of a bar that shows 1

bool below(int i) { return i % 2 == 1; } // the normalised row

float exponent_of(int i) {
    return i < 2 ? exponent : 5.0 * pow(8.0, float((i - 2) / 2)); // 5, 40, 320
}

vec3 ball_centre(int i) {
    float z = below(i) ? -1.42 : 1.42;
    return i < 2 ? vec3(-2.2, 0.0, z) : vec3(-0.35 + 1.4 * float((i - 2) / 2), 0.0, z);
}

float ball_radius(int i) { return i < 2 ? 0.95 : 0.56; }

float share(int i) {
    return highlight_flux(below(i) ? 3 : 2, 0.0, 0.0, k_s, exponent_of(i));
}

vec3 meter_foot(int i) {
    return ball_centre(i) + vec3(i < 2 ? 1.03 : 0.64, -0.05, -0.62);
}

vec3 surface_point(int surface, vec2 s) {
    if (surface == 0) {
        int i = ball_number(s, 8);
        return ball_point(s, 8, ball_centre(i), ball_radius(i));
    }
    int i = surface - 1;
    return meter_foot(i) + vec3(0.14 * s.x, 0.0, METER * min(share(i), 2.15) * s.y);
}

vec3 shade(Surface s) {
    if (s.id > 0) {
        vec3 bar = palette[below(s.id - 1) ? COLOUR_EXACT : COLOUR_PRINTED];
        return s.position.z > meter_foot(s.id - 1).z + METER + 0.001 ? 0.6 * bar : bar;
    }
    int i = ball_number(s.st, 8);
    vec3 n = ball_normal((s.position - ball_centre(i)) / ball_radius(i), s.v);
    float e = exponent_of(i), lit = max(dot(n, LAMP), 0.0);
    float gloss = below(i) ? brdf_blinn_phong(n, LAMP, s.v, 0.0, k_s, e) * lit : shading_blinn_phong(n, LAMP, s.v, 0.0, k_s, e);
    return vec3(1.0) - exp(-1.3 * (vec3(0.10, 0.20, 0.42) * (0.5 * lit + 0.10) + gloss));
}

vec3 mark_point(int mark, float t) {
    return meter_foot(mark) + vec3(0.26 * t - 0.06, -0.02, METER);
}

vec4 probe(int i) {
    if (i == 0) return vec4(meter_foot(0) + vec3(0.07, 0.0, METER * min(share(0), 2.15)), 1.0);
    if (i == 1) return vec4(meter_foot(1) + vec3(0.07, 0.0, METER * share(1)), 1.0);
    if (i < 6) return vec4(ball_centre(2 * (i - 2)).x, 0.0, 0.10, 1.0);
    return vec4(-2.2, 0.0, i == 6 ? 2.72 : -2.72, 1.0);
}
""",
        surfaces=(Surface("balls", cells=(263, 2)), *(Surface(f"flux meter {i}", cells=(1, 1)) for i in range(8))),
        marks=tuple(Mark(f"what arrives {i}", colour="quiet") for i in range(8)),
        labels=(Label("n: yours", 2), Label("5", 3), Label("40", 4), Label("320", 5), Label("as printed", 6, "printed"),
                Label("normalised", 7)),
        handles=(Handle("the exponent", 0, ("exponent",)), Handle("the share", 1, ("k_s",))),
        camera=Camera(azimuth=-90, elevation=0, distance=15.5, target=(0.03, 0.0, 0.0), field_of_view=27),
        legend=(("quiet", "bars: flux; line: what arrives"),),
    ),
    plot=Curves("Flux under the highlight, light from above", "exponent", (
        Curve("normalised", Term("highlight_flux", {"model": 3, "theta_l": 0.0, "k_d": 0.0})),
        Curve("as printed", Term("highlight_flux", {"model": 2, "theta_l": 0.0, "k_d": 0.0}), role="printed")),
        y_label="share of the flux that arrives", y_scale="log", x_scale="log"),
    readouts=(
        Readout("as printed, leaves", Term("highlight_flux", {"model": 2, "theta_l": 0.0, "k_d": 0.0}), unit=""),
        Readout("normalised, leaves", Term("highlight_flux", {"model": 3, "theta_l": 0.0, "k_d": 0.0}), role="exact", unit=""),
        Readout("the factor", Term("normalisation_blinn_phong"), unit="1/sr"),
    ),
    ask=Prediction(
        question="As printed, k_s = 1, light from above. At exponent 10 the surface sends back 1.5 times what arrives. You raise "
                 "the exponent to 100. How much now?",
        truth=Term("highlight_flux", {"model": 2, "theta_l": 0.0, "k_d": 0.0, "k_s": 1.0, "exponent": 100.0}),
        unit="of it",
        low=0.0,
        high=2.0,
        sets={"exponent": 100.0, "k_s": 1.0},
        told="0.24. The peak stayed and the spot shrank: six times less light, from the same lamp on the same varnish.",
    ),
    notes="""
Ask first: raise the exponent, brighter peak, same flux? Nearly all say yes, because polish does that; the formula does
not. Cover the upper row and let them judge the lower: the small highlight hurts the eye, as on chrome. Then the bars. Point
out that at exponent 5 the printed formula makes light; a room of such walls would explode. "Must be constant", says the
slide: it means with the exponent. In a white furnace the middle of a normalised ball shows the same number as its bar, by
reciprocity; the printed formula is not reciprocal, and its energy badge, a sum over l, shows another one. 5 minutes.
""",
    sources=("Deck, slides Is the Phong-Blinn Model Realistic? to Normalized Blinn-Phong Model",
             "Giesen 2009, Derivation of Phong and Blinn-Phong BRDF normalization factors"),
    honesty="Bars and numbers are exact, for light along the normal; bars longer than 2.15 are cut off. The balls' brightness is "
            "compressed to fit the screen, the same in both rows; their blue is a look.",
    values=(Value("exponent", 30.0, low=1.0, high=1000.0, scale="log"), Value("k_s", 0.7, low=0.05, high=1.0)),
    models=(Model("as printed", Term("brdf_blinn_phong_printed", {"k_d": 0.0}), "printed"),
            Model("normalised", Term("brdf_blinn_phong", {"k_d": 0.0}))),
    minutes=5,
)

BLINN_PHONG_BRDF = Step(
    name="blinn_phong_brdf",
    title="The complete Blinn-Phong BRDF, in a furnace",
    idea="The factor is exact seen along the normal; at a slant Blinn-Phong loses light, down to the cosine squared.",
    slides=("Converting the Blinn-Phong Model to BRDF", "Blinn-Phong BRDF (1)", "Blinn-Phong BRDF (2)"),
    prose=r"""
From shading formula [to BRDF](code:brdf_blinn_phong) in three moves: take out the cosine, divide the diffuse part by $\pi$, multiply the highlight by
$f_n$.

$$f = \frac{k_d}{\pi} + k_s\,\frac{(n+2)(n+4)}{8\pi(n+2^{-n/2})}\,(\colour{n}{n}\cdot\colour{h}{h})^n, \qquad k_d + k_s \le 1$$

To test it, heat a furnace until all glows alike and put the ball in. A ball that gives back all it gets
[cannot be seen](?k_d=1&k_s=0). Now [highlight only](?k_d=0&k_s=1): the middle is exact, the rim goes dark. The slide demands
the integral for $v = n$; walk the $\colour{v}{\text{ring}}$ out, and for high exponents $\cos^2\theta$ is left.

[Promise too much](?k_d=0.7&k_s=0.6), and the ball outshines the furnace. Below, the exact factor and three common
short cuts.
""",
    scene=Scene(
        glsl="""
#include "optics/blinn_phong.glsl"
#include "display/palette.glsl"
#include "display/rings.glsl"
uniform float theta_v, exponent, k_d, k_s;

const vec3 LARGE = vec3(0.0, 0.0, 0.72);
const float SIZE = 1.5, SMALL = 0.55;
const float WIDER = 1.0353; // 1 / cos(pi / 12): the edges of a ball's twelve columns stay outside of it

vec3 small(int i) {
    return vec3(1.32 * (float(i) - 1.5), 0.0, -1.72);
}

float factor(int i) { // of the small balls, over the exact one
    if (i == 0) return 1.0;
    return normalisation_short_share(exponent, i == 1 ? 8.0 : i == 2 ? 6.0 : 2.0);
}

vec3 middle(int surface) { return surface == 1 ? LARGE : small(surface - 2); }

// Balls seen from far away: discs, whose share of the light is worked out at the corners
vec3 surface_point(int surface, vec2 s) {
    if (surface == 0) return vec3(5.6 * s.x - 2.8, 0.1, 5.3 * s.y - 2.9);
    float turn = 2.0 * PI * s.x, r = (surface == 1 ? SIZE : SMALL) * sin(0.5 * PI * s.y);
    return middle(surface) + WIDER * r * vec3(cos(turn), 0.0, sin(turn));
}

vec4 surface_value(int surface, vec2 s) {
    if (surface == 0) return vec4(0.0);
    float share = albedo_blinn_phong(0.5 * PI * s.y, exponent);
    return vec4(surface == 1 ? k_d + k_s * share : factor(surface - 2) * share, sin(0.5 * PI * s.y), 0.0, 0.0);
}

vec3 shade(Surface s) {
    vec3 heat = vec3(0.50, 0.47, 0.43);
    if (s.id == 0) return heat;
    float r = length(s.position - middle(s.id)) / (s.id == 1 ? SIZE : SMALL);
    float share = max(round_value(s.value.x, s.value.y, r), 0.0);
    bool stripe = mod(gl_FragCoord.x + gl_FragCoord.y, 12.0) < 3.0;
    vec3 colour = share > 1.0005 && stripe ? palette[COLOUR_PRINTED] : heat * share;
    return mix(colour, heat, clamp(0.5 + (r - 1.0) / max(fwidth(r), 1e-6), 0.0, 1.0));
}

vec3 place(float turn) {
    return LARGE + vec3(SIZE * sin(theta_v) * cos(turn), -0.1, SIZE * sin(theta_v) * sin(turn));
}

vec3 mark_point(int mark, float t) {
    if (mark == 0) return place(2.0 * PI * t);
    if (mark == 1) return LARGE + 1.005 * SIZE * vec3(cos(2.0 * PI * t), -0.08, sin(2.0 * PI * t));
    return small(mark - 2) + 0.555 * vec3(cos(2.0 * PI * t), -0.16, sin(2.0 * PI * t));
}

vec4 probe(int i) {
    if (i == 0) return vec4(place(0.7), 1.0);
    return vec4(small(i - 1) + vec3(0.0, -0.1, -0.7), 1.0);
}
""",
        surfaces=(Surface("furnace", cells=(1, 1)), Surface("ball", cells=(12, 24)),
                  *(Surface(name, cells=(12, 14)) for name in ("exact factor", "n + 8", "n + 6", "n + 2"))),
        marks=(Mark("angle", colour="v", segments=64, width=1.3), Mark("outline", colour="quiet", line="dotted", segments=96),
               *(Mark(f"outline {i}", colour="quiet", line="dotted", segments=64) for i in range(4))),
        labels=(Label("exact", 1), Label("n + 8", 2), Label("n + 6", 3), Label("n + 2", 4)),
        handles=(Handle("the ring", 0, ("theta_v",)),),
        legend=(("printed", "more than it gets"),),
        camera=Camera(azimuth=-90, elevation=0, distance=40.0, target=(0.0, 0.0, -0.22), field_of_view=8.2),
    ),
    plot=(
        Curves("Share given back, against the angle", "theta_v", (
            Curve("the ball", Term("highlight_flux", {"model": 3, "theta_l": "theta_v"})),
            Curve("highlight alone, k_s = 1", Term("albedo_blinn_phong"), role="estimate"),
            Curve("cos² θ", Term("albedo_blinn_phong_limit"), role="printed")), y_label="share of the light"),
        Curves("Short cuts: what comes back along the normal", "exponent", (
            Curve("exact", Term("albedo_blinn_phong", {"theta_v": 0.0})),
            Curve("n + 8", Term("normalisation_short_share", {"summand": 8.0}), role="estimate"),
            Curve("n + 6", Term("normalisation_short_share", {"summand": 6.0}), role="printed"),
            Curve("n + 2", Term("normalisation_short_share", {"summand": 2.0}))),
            y_label="share of the light", x_scale="log"),
    ),
    readouts=(
        Readout("gives back at the ring", Term("highlight_flux", {"model": 3, "theta_l": "theta_v"}), unit=""),
        Readout("seen along the normal", Term("highlight_flux", {"model": 3, "theta_l": 0.0}), unit=""),
        Readout("f_n, exact", Term("normalisation_blinn_phong"), role="exact", unit="1/sr"),
        Readout("(n + 8) / 8π", Term("normalisation_short", {"summand": 8.0}), role="estimate", unit="1/sr",
                against="f_n, exact"),
    ),
    ask=Prediction(
        question="A white, wide highlight, k_s = 1 and exponent 5. Along the normal it gives back all the light. What share at 60°?",
        truth=Term("albedo_blinn_phong", {"theta_v": PI / 3, "exponent": 5.0}),
        unit="of it",
        low=0.0,
        high=1.0,
        sets={"theta_v": 60.0, "exponent": 5.0, "k_d": 0.0, "k_s": 1.0},
        told="0.515. Nothing was absorbed; the model lost it. At exponent 100 it is 0.265, near cos² 60°. A white rough surface "
             "would give back all of it.",
    ),
    notes="""
The furnace is the sharpest test of a BRDF and needs no lamp: what differs from the wall is an error, or paint. Let them guess
what a perfect mirror ball looks like in it: nothing at all. The slide's integral is printed without f_n; as it stands it is
3.14 at exponent 0 and 0.24 at 100. Why is v = n the right place to normalise? It is where most comes back, so k_s + k_d ≤ 1 is
safe everywhere. Short cuts: n + 8 makes up to 7.5 % too much near 10, n + 2 loses two thirds at 1. 6 minutes.
""",
    sources=("Deck, slides Converting the Blinn-Phong Model to BRDF, Blinn-Phong BRDF (1) and (2)",
             "Giesen 2009, Derivation of Phong and Blinn-Phong BRDF normalization factors",
             "Akenine-Moller, Haines and Hoffman 2008, Real-Time Rendering: n + 8"),
    honesty="Shares are exact at 25 angles a ball and interpolated between, for an eye far away. The walls show half the "
            "screen's white, so that more than all can be seen; the stripes mark it.",
    values=(Value("k_d", 0.3), Value("k_s", 0.7), Value("exponent", 60.0, low=1.0, high=1000.0, scale="log"),
            Value("theta_v", 55.0, low=0.0, high=90.0)),
    models=(Model("Blinn-Phong", Term("brdf_blinn_phong")),),
    minutes=6, breaks=(Break("Phong's factor on Blinn's lobe", {"normalisation_blinn_phong": "normalisation_phong"}, {"exponent": 60.0, "k_d": 0.0, "k_s": 1.0, "theta_v": 0.0}, "(n + 2)/2π is right, for r·v. The halfway vector moves half as fast as the light, so its lobe is twice as wide each way, holds four times the light, and the ball sends back nearly four times what it gets. A factor belongs to its lobe: integrate before you believe one.", "factor f_n", Term("normalisation_blinn_phong"), "1/sr"),),
)

COMPLAINTS = ("coefficients are guessed", "they change with the angle", "metals", "the exponent", "light is lost")

WHY_PHYSICAL = Step(
    name="why_physical",
    title="Why a physical model is needed",
    idea="Blinn-Phong has knobs and no material: what it must be told by hand, the physics of a surface knows.",
    slides=("Need for a Physically-based Reflectance Model",),
    prose=r"""
Five balls. Each left half is Blinn-Phong, each right half what the surface does.

[Guessed](?complaint=0): 0.8 red and 0.5 gloss looked fine on the screen. It is 1.3 times the light. Plastic is told by one
number, its index.

[Angle](?complaint=1): the mirror of plastic goes from 0.04 to 1 towards the rim; $k_s$ stays.

[Metal](?complaint=2): gold is yellow straight on and white at the rim. A colour $k_s$ cannot do both.

[Exponent](?complaint=3): sectors in equal steps. From 10 to 910 nearly all the change is in the first: the width goes with
$1/\sqrt n$, and twice $n$ leaves 0.71 of it. Half the slope $m$ leaves half.

[Lost](?complaint=4): in a furnace the rim goes dark, though nothing absorbs.

The next chapters mend all five.
""",
    scene=Scene(
        glsl="""
#include "optics/blinn_phong.glsl"
#include "optics/materials.glsl"
#include "display/balls.glsl"
#include "display/studio.glsl"
#include "display/look.glsl"
#include "stage/camera.glsl"
uniform int complaint;
uniform float theta;

const vec3 RED = vec3(0.80, 0.06, 0.05);

vec3 ball_centre(int i) {
    return i < 3 ? vec3(2.5 * float(i - 1), 0.0, 1.4) : vec3(2.9 * (float(i) - 3.5), 0.0, -1.4);
}

vec3 surface_point(int surface, vec2 s) {
    if (surface == 1) return ball_centre(4) + vec3(2.6 * s.x - 1.3, 1.3, 2.5 * s.y - 1.25);
    return ball_point(s, 5, ball_centre(ball_number(s, 5)), 1.0);
}

// Equal steps on a half pie: of the exponent on the left, of the facets' slope on the right
float exponent_here(vec3 p, bool model) {
    float sector = floor(4.0 * arctan2(abs(p.x), -p.z) / PI), m = 0.45 - 0.125 * sector;
    return model ? 10.0 + 300.0 * sector : 2.0 / (m * m) - 2.0;
}

vec3 shade(Surface s) {
    vec3 furnace = vec3(0.62, 0.58, 0.53);
    if (s.id == 1) return furnace;
    int i = ball_number(s.st, 5);
    vec3 n = ball_normal(s.position - ball_centre(i), s.v), p = n, mirrored = max(studio(reflect(-s.v, n)), 0.0);
    bool model = p.x < 0.0;
    float c = max(dot(n, s.v), 0.0), f = f_dielectric(c, 1.5);
    if (abs(p.x) < 0.012) return background;
    if (i == 0) return model ? soft_light(RED, n, s.v) + 0.5 * mirrored : soft_light(RED * (1.0 - f), n, s.v) + f * mirrored;
    if (i == 1) return soft_light(vec3(0.02, 0.05, 0.10) * (1.0 - f), n, s.v) + (model ? f0_from_eta(1.5) : f) * mirrored;
    if (i == 2) return max(f_material(model ? 1.0 : c, 5), 0.0) * mirrored;
    if (i == 4) return furnace * (model ? albedo_blinn_phong_limit(arctan2(length(cross(n, s.v)), c)) : 1.0);
    float e = exponent_here(p, model);
    return soft_light(vec3(0.10, 0.13, 0.19), n, s.v) + vec3(lobe_blinn(n, s.v, s.v, e));
}

vec3 place(float turn) {
    vec3 c = ball_centre(complaint), v = normalize(camera_position - c);
    vec3 side = normalize(cross(v, vec3(0.0, 0.0, 1.0))), up = cross(side, v);
    return c + 1.01 * (cos(theta) * v + sin(theta) * (cos(turn) * side + sin(turn) * up));
}

vec3 mark_point(int mark, float t) {
    if (mark == 1) return place(2.0 * PI * t);
    return ball_centre(complaint) + 1.1 * vec3(cos(2.0 * PI * t), 0.0, sin(2.0 * PI * t));
}

vec4 probe(int i) {
    if (i == 0) return vec4(place(0.7), 1.0);
    if (i > 5) return vec4(i == 6 ? -2.0 : 2.0, 0.0, 2.72, 1.0);
    return vec4(ball_centre(i - 1) + vec3(0.0, 0.0, -1.28), 1.0);
}
""",
        surfaces=(Surface("balls", cells=(164, 2)), Surface("furnace", cells=(1, 1))),
        marks=(Mark("chosen", colour="exact", line="dashed", segments=64), Mark("angle", colour="v", segments=64, width=1.3)),
        labels=(Label("guessed", 1), Label("angle", 2), Label("metal", 3), Label("exponent", 4), Label("lost", 5),
                Label("left: Blinn-Phong", 6, "printed"), Label("right: the surface", 7)),
        handles=(Handle("the angle", 0, ("theta",)),),
        camera=Camera(azimuth=-90, elevation=2, distance=32, target=(0.0, 0.0, 0.0), field_of_view=14),
    ),
    plot=Curves("The chosen complaint", "theta", (
        Curve("the surface", Term("complaint_truth")),
        Curve("Blinn-Phong", Term("complaint_model"), role="printed")), y_label="share of the light; of the width"),
    readouts=(
        Readout("the surface", Term("complaint_truth"), role="exact", unit=""),
        Readout("Blinn-Phong", Term("complaint_model"), role="printed", unit="", against="the surface"),
    ),
    ask=Prediction(
        question="Straight on gold reflects 0.37 of the blue; that is why it is yellow. How much of the blue at 85°?",
        truth=Term("complaint_truth", {"complaint": 2, "theta": 1.4835298641951802}),
        unit="of it",
        low=0.0,
        high=1.0,
        sets={"complaint": 2, "theta": 85.0},
        told="0.75, and all of it at 90°: towards the rim gold turns white, like every metal. A constant k_s keeps it yellow.",
    ),
    notes="""
Go ball by ball and let them say what is wrong with the left half before you do. The first one gives most trouble: it looks good.
That is the point, a look is all that guessing can be checked against, until a second lamp comes on. For the exponent, ask
who has ever typed 910; then show that the slope of the facets is a length over a length and can be measured. The deck's slide has
four complaints; the fifth is from the step before. 4 minutes.
""",
    sources=("Deck, slide Need for a Physically-based Reflectance Model", "Fresnel 1823", "Johnson and Christy 1972: n, k of gold"),
    honesty="Shares are exact for a smooth plastic of index 1.5 and for gold; that 0.8 of what enters the plastic comes out is "
            "set. The room is painted; reflections in it are sharp. The furnace shows the limit of a high exponent.",
    values=(Value("complaint", 1, choices=COMPLAINTS), Value("theta", 70.0, low=0.0, high=89.0)),
    minutes=4,
)

# --- exercises --------------------------------------------------------------------------------------------------------
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

NEAR_RIGHT = (0.5, 0.1, 0.860232526704)  # a little beside the mirror direction of LEFT

BLINN_PHONG_EXERCISE = Exercise(
    name="blinn_phong",
    function="brdf_blinn_phong",
    task="Write the complete Blinn-Phong BRDF, normalised. It has no cosine, its diffuse part has a π, and light or eye below "
         "the surface give 0.",
    slide="Blinn-Phong BRDF (2)",
    stubs={"python": '''import numpy as np


def brdf_blinn_phong(n, l, v, k_d, k_s, exponent):
    """The BRDF in 1/sr. n, l, v: (..., 3), unit vectors; k_d, k_s, exponent: (...)."""
    return np.zeros(np.shape(n)[:-1])
''', "glsl": '''float brdf_blinn_phong(vec3 n, vec3 l, vec3 v, float k_d, float k_s, float exponent) {
    return 0.0;
}
'''},
    solutions={"python": '''import numpy as np


def dot(a, b):
    return np.sum(a * b, -1)


def brdf_blinn_phong(n, l, v, k_d, k_s, exponent):
    """Diffuse over pi, and the highlight times the factor that makes it 1 along the normal."""
    h = l + v
    size = np.sqrt(dot(h, h))
    h = h / np.where(size > 0, size, 1)[..., None]
    below = 0.5 * dot(n - h, n - h)  # 1 - n.h, without losing digits
    lobe = np.exp(exponent * np.log1p(-np.minimum(below, 1 - 1e-12)))
    factor = (exponent + 2) * (exponent + 4) / (8 * np.pi * (exponent + np.exp2(-exponent / 2)))
    above = (dot(n, l) > 0) & (dot(n, v) > 0)
    return np.where(above, k_d / np.pi + k_s * factor * lobe, 0.0)
''', "glsl": '''float brdf_blinn_phong(vec3 n, vec3 l, vec3 v, float k_d, float k_s, float exponent) {
    if (dot(n, l) <= 0.0 || dot(n, v) <= 0.0) return 0.0;
    vec3 h = normalize(l + v);
    float e = exponent, factor = (e + 2.0) * (e + 4.0) / (8.0 * 3.14159265358979 * (e + exp2(-0.5 * e)));
    return k_d / 3.14159265358979 + k_s * factor * pow(max(dot(n, h), 0.0), e);
}
'''},
    checks=(
        Check({"n": (UP, UP), "l": (UP, LEFT), "v": (UP, NEAR_RIGHT), "k_d": (1.0, 0.5), "k_s": (0.0, 0.0),
               "exponent": (20.0, 20.0)}, "diffuse alone: k_d/π"),
        Check({"n": (UP, UP, UP), "l": (UP, UP, UP), "v": (UP, UP, UP), "k_d": (0.0, 0.0, 0.0), "k_s": (1.0, 1.0, 1.0),
               "exponent": (0.0, 1.0, 10.0)}, "along the normal: the factor, and exponent 0 is white and matt"),
        Check({"n": (UP, UP, UP), "l": (LEFT, LEFT, FLAT), "v": (NEAR_RIGHT, UP, RIGHT), "k_d": (0.3, 0.1, 0.0),
               "k_s": (0.6, 0.9, 1.0), "exponent": (30.0, 5.0, 2.0)}, "from several sides"),
        Check({"n": (UP, UP, UP), "l": (BELOW, LEFT, LEFT), "v": (RIGHT, BELOW, NEAR_RIGHT), "k_d": (0.5, 0.5, 0.5),
               "k_s": (0.5, 0.5, 0.5), "exponent": (10.0, 10.0, 10.0)}, "light or eye below: 0"),
        Check({"n": (UP, LEFT, FLAT), "l": (LEFT, UP, UP), "v": (NEAR_RIGHT, LEFT, FLAT), "k_d": (0.2, 0.0, 0.4),
               "k_s": (0.7, 1.0, 0.3), "exponent": (300.0, 40.0, 7.0)}, "a tighter highlight, a tilted surface", hidden=True),
    ),
)

CHAPTER = Chapter(
    title="BRDFs",
    idea="A BRDF says how much of the light from one direction a surface sends into another.",
    steps=(BALANCE, REFLECTANCE_EQUATION, DEFINITION, PROPERTIES, LAMBERT,
           PHONG, BLINN, NORMALISATION, BLINN_PHONG_BRDF, WHY_PHYSICAL),
    exercises=(LAMBERT_EXERCISE, BLINN_PHONG_EXERCISE),
    terms={
        "BRDF": "outgoing radiance in one direction over irradiance from another, per steradian",
        "albedo": "the share of the arriving light that a surface sends back",
        "halfway vector": "h, the unit vector halfway between light and eye: a facet with this normal mirrors one to the other",
        "normalised": "of a highlight: with the factor that makes it give back all the light, seen along the normal",
        "white furnace": "the same radiance from everywhere; a surface that gives back all of it cannot be seen in it",
    },
)
