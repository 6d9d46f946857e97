"""How much light? Seven quantities, each the one before per something: per second, per direction, per area.

They are few, and their names are mixed up everywhere. Whoever can tell radiance from irradiance and lumens from candela
has understood half of shading; the rest of this course multiplies them.
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
    Ledger,
    LedgerRow,
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
ONE = "Basic Radiometric Quantities (1)"
TWO = "Basic Radiometric Quantities (2)"
THREE = "Basic Radiometric Quantities (3)"

ENERGY_FLUX = Step(
    name="energy_flux",
    title="Energy and flux",
    idea="Energy Q is how much light has left the lamp; flux Φ is how fast it leaves.",
    slides=(ONE,),
    prose=r"""
Both lamps give away the same **radiant energy** $\colour{l}{Q}$, in joules. The bulb takes a second for it, the flash a
moment. The dots are the light on its way; the tanks count what has left.

How fast a tank fills is the **radiant flux**, in watts:

$$\Phi = \frac{dQ}{dt}$$

Drag the level of the bulb's tank: that is time. The flash's tank is full [after a twentieth of it](?time=0.05), and its light
is a thin shell from then on, running ahead. [A flash of 1 ms](?duration=0.001) needs a thousand times the bulb's flux.

A picture needs energy, so the flash can light it. An eye, and every formula from here on, asks for flux.
""",
    scene=Scene(
        glsl="""
#include "optics/spherical.glsl"
#include "optics/radiometry.glsl"
#include "display/look.glsl"
#include "stage/camera.glsl"
uniform float duration;
uniform float time;

const int EACH = 700;        // dots of a lamp
const float SPEED = 1.3;     // of the drawn light, metres a second
const float REACH = 1.25;
const float TANK = 1.1;

vec3 lamp_at(int k) {
    return vec3(k == 0 ? -1.55 : 1.55, 0.0, 0.9);
}

float lasts(int k) {
    return k == 0 ? duration : 1.0;
}

vec3 surface_point(int surface, vec2 s) {
    int k = surface % 2;
    if (surface < 2) return lamp_at(k) + 0.17 * sphere_point(s.x, s.y);
    float level = surface < 4 ? radiant_energy_emitted(1.0, lasts(k), time) : 1.0;
    float wide = surface < 4 ? 0.315 : 0.33;
    vec3 foot = vec3(lamp_at(k).x, 0.0, -1.75);
    float up = min(2.0 * s.y, 1.0), out_to = min(2.0 - 2.0 * s.y, 1.0);
    return foot + vec3(wide * out_to * cos(2.0 * PI * s.x), wide * out_to * sin(2.0 * PI * s.x), TANK * level * up);
}

vec3 shade(Surface s) {
    int k = s.id % 2;
    if (s.id < 2) {
        float on = time < lasts(k) ? 1.0 : 0.0;
        return soft_light(mix(palette[COLOUR_QUIET] * 0.6, palette[COLOUR_L], on), s.normal, s.v) * (1.0 + 0.6 * on);
    }
    if (s.id < 4) return soft_light(palette[COLOUR_L], s.normal, s.v);
    return glass(s.st, vec2(12.0, 10.0));
}

vec3 dot_point(int i) {
    int k = i < EACH ? 0 : 1, j = i - k * EACH;
    uint h = uint(j) * 747796405u + 2891336453u;           // O'Neill 2014, PCG: neighbours leave in any two directions
    h = ((h >> ((h >> 28u) + 4u)) ^ h) * 277803737u;
    int mixed = int(((h >> 22u) ^ h) % uint(EACH));
    float left = lasts(k) * (float(j) + 0.5) / float(EACH); // when this one left
    float r = 0.17 + SPEED * max(0.0, time - left);
    return lamp_at(k) + min(r, 2.0 * REACH) * fibonacci_direction(mixed, EACH);
}

vec4 dot_colour(int i) {
    int k = i < EACH ? 0 : 1;
    float left = lasts(k) * (float(i - k * EACH) + 0.5) / float(EACH), r = length(dot_point(i) - lamp_at(k));
    float shown = time > left && r < REACH ? 1.0 - 0.75 * smoothstep(0.6 * REACH, REACH, r) : 0.0;
    bool front = dot(dot_point(i) - lamp_at(k), camera_position - lamp_at(k)) > 0.0;
    return vec4(palette[COLOUR_L], shown * (front ? 1.0 : 0.45));
}

vec3 mark_point(int mark, float t) {
    vec3 lamp = lamp_at(mark);
    return mix(lamp - vec3(0.0, 0.0, 0.17), vec3(lamp.x, 0.0, -1.75 + TANK + 0.04), t);
}

vec4 probe(int i) {
    if (i == 0) return vec4(1.55, 0.0, -1.75 + TANK * radiant_energy_emitted(1.0, 1.0, time), 1.0);
    if (i < 3) return vec4(lamp_at(i - 1) - vec3(0.0, 0.0, 2.85), 1.0);
    return vec4(0.0, 0.0, -1.2, 1.0);
}
""",
        surfaces=(
            Surface("flash", cells=(24, 12)), Surface("bulb", cells=(24, 12)), Surface("flash's energy", cells=(48, 2)),
            Surface("bulb's energy", cells=(48, 2)), Surface("flash's tank", cells=(48, 2), opacity=0.22),
            Surface("bulb's tank", cells=(48, 2), opacity=0.22),
        ),
        marks=(Mark("to the flash's tank", colour="quiet", line="dotted"),
               Mark("to the bulb's tank", colour="quiet", line="dotted")),
        dots=Dots(1400, size=0.9),
        labels=(Label("the flash", 1), Label("the bulb, 1 s", 2), Label("Q so far", 3, "l")),
        handles=(Handle("the bulb's level", 0, ("time",)),),
        camera=Camera(azimuth=-90, elevation=10, distance=10.6, target=(0.0, 0.0, 0.1)),
    ),
    plot=Curves(
        title="Energy that has left, against time",
        sweep="time",
        curves=(Curve("flash", Term("radiant_energy_emitted")),
                Curve("bulb, 1 s", Term("radiant_energy_emitted", {"duration": 1.0}), role="estimate")),
        y_label="J",
    ),
    readouts=(
        Readout("Φ of the flash", Term("radiant_flux_mean"), unit="W"),
        Readout("Φ of the bulb", Term("radiant_flux_mean", {"duration": 1.0}), unit="W"),
        Readout("Q, flash, so far", Term("radiant_energy_emitted"), unit="J"),
        Readout("Q, bulb, so far", Term("radiant_energy_emitted", {"duration": 1.0}), unit="J"),
    ),
    ask=Prediction(
        question="A bulb sends out 60 J of light in a second: 60 W. A flash sends out the same 60 J in a thousandth of a second. "
                 "What is its flux?",
        truth=Term("radiant_flux_mean", {"radiant_energy": 60.0, "duration": 0.001}),
        unit="W", low=1.0, high=1e6, scale="log",
        sets={"radiant_energy": 60.0, "duration": 0.001},
        told="60 000 W, as much as a street of houses draws; for a thousandth of a second.",
    ),
    notes="""
Ask what a watt is before the word flux appears: joules per second, so the bulb's label is a speed, not an amount. The
common wrong answer is 60 W for both, "because it is the same light". Drag the level slowly: dQ/dt is the slope in the plot,
and the flash's slope is nearly a wall. The shell of dots is what a flash is in space: light is on its way and stays thin.
4 minutes.
""",
    sources=("Deck, slide Basic Radiometric Quantities (1)", "ISO 80000-7: radiant energy, radiant flux"),
    honesty="Exact, for a flux that is even while it lasts. The drawn light runs at 1.3 m/s, not at 300 000 km/s, and thins "
            "out at the edge of the picture.",
    values=(Value("duration", 0.05, low=5e-4, high=1.0), Value("time", 0.62), Value("radiant_energy", 60.0)),
    minutes=4,
)

RADIANT_INTENSITY = Step(
    name="radiant_intensity",
    title="Radiant intensity",
    idea="Intensity is the flux in a cone over the cone's solid angle, as the cone shrinks to a direction.",
    slides=(ONE,),
    prose=r"""
A lamp does not shine alike to all sides. So take a **cone** of directions, catch the flux in it, divide by its solid angle:

$$I = \frac{d\Phi}{d\omega}\qquad \text{W/sr}$$

This flat lamp shines upward by the cosine law; the $\colour{quiet}{\text{balloon}}$ shows its intensity in every direction. Over a
[wide cone](?half_angle=80) the quotient is a mean, and too small for the middle. Close the $\colour{l}{\text{cone}}$
[to 20°](?half_angle=20), [to 2°](?half_angle=2): the flux goes to nothing, the quotient stays, at $\Phi/\pi$.

Now pull the cap [away from the lamp](?distance=3). The cone holds the same flux at any distance. Intensity belongs to the
lamp and a direction; **distance is not in it**.
""",
    scene=Scene(
        glsl="""
#include "optics/spherical.glsl"
#include "optics/radiometry.glsl"
#include "display/look.glsl"
uniform float half_angle;
uniform float distance;

vec3 balloon(vec2 s) {
    vec3 d = cap_point(0.5 * PI, s.x, s.y);
    return 1.1 * PI * radiant_intensity_lambert(1.0, acos(clamp(d.z, 0.0, 1.0))) * d;
}

vec3 surface_point(int surface, vec2 s) {
    if (surface == 0) return vec3(0.3 * s.y * cos(2.0 * PI * s.x), 0.3 * s.y * sin(2.0 * PI * s.x), 0.0);
    if (surface == 1) return distance * cap_point(half_angle, s.x, s.y);
    if (surface == 2) return distance * s.y * cap_point(half_angle, s.x, 1.0);
    return balloon(s);
}

vec3 shade(Surface s) {
    vec3 light = palette[COLOUR_L];
    if (s.id == 0) return light;
    if (s.id == 1) {
        float there = max(0.0, normalize(s.position).z); // the cosine law again, on the cap
        return soft_light(mix(light * (0.25 + 0.75 * there), light * 0.3, grid_lines(s.st, vec2(24.0, 8.0))), s.normal, s.v);
    }
    if (s.id == 2) return soft_light(light, s.normal, s.v);
    return glass(s.st, vec2(24.0, 12.0));
}

vec3 mark_point(int mark, float t) {
    if (mark == 0) return vec3(0.0, 0.0, (distance + 0.5) * t);
    if (mark == 1) return 1.003 * distance * cap_point(half_angle, t, 1.0);
    float a = radians(15.0 * float(mark - 5) ); // rays of the lamp, as long as its intensity
    return 1.1 * max(0.0, cos(a)) * t * vec3(sin(a), 0.0, cos(a));
}

vec4 probe(int i) {
    if (i == 0) return vec4(distance * cap_point(half_angle, 0.0, 1.0), 1.0);
    if (i == 1) return vec4(0.0, 0.0, distance, 1.0);
    return vec4(0.62, 0.0, -0.12, 1.0);
}
""",
        surfaces=(Surface("lamp", cells=(48, 1)), Surface("cap", cells=(64, 12)),
                  Surface("cone", cells=(64, 1), opacity=0.35), Surface("balloon", cells=(48, 12), opacity=0.2)),
        marks=(Mark("axis", colour="n", tip="arrow", label="n"), Mark("rim", colour="l", segments=96, width=1.5),
               *(Mark(f"ray {i}", colour="l", tip="arrow", width=0.8) for i in (-3, -2, -1, 0, 1, 2, 3))),
        labels=(Label("the lamp", 2),), handles=(Handle("the cone's rim", 0, ("half_angle",)), Handle("the cap", 1, ("distance",))),
        camera=Camera(azimuth=-90, elevation=16, distance=7.4, target=(0.0, 0.0, 0.9)),
        legend=(("l", "the cone's flux"), ("quiet", "intensity in every direction")),
    ),
    plot=Curves(
        title="Flux in the cone over its solid angle",
        sweep="half_angle",
        curves=(Curve("on the axis, Φ/π", Term("radiant_intensity_lambert", {"theta": 0.0})),
                Curve("mean over the cone", Term("radiant_intensity_lambert_cone"), role="estimate")),
        y_label="W/sr",
    ),
    readouts=(
        Readout("flux in the cone", Term("radiant_flux_lambert_cone"), unit="W"),
        Readout("I on the axis", Term("radiant_intensity_lambert", {"theta": 0.0}), role="exact", unit="W/sr"),
        Readout("flux / solid angle", Term("radiant_intensity_lambert_cone"), role="estimate", unit="W/sr",
                against="I on the axis"),
    ),
    ask=Prediction(
        question="A bare bulb sends 10 W of light evenly in all directions. What is its radiant intensity for someone two "
                 "metres away?",
        truth=Term("radiant_intensity_isotropic", {"radiant_flux": 10.0}),
        unit="W/sr",
        low=0.0,
        high=3.0,
        sets={"radiant_flux": 10.0, "distance": 2.0},
        told="10 W / 4π sr = 0.80 W/sr, at two metres and at any other distance. Who divided by 2² had irradiance in mind.",
    ),
    notes="""
The two metres in the question are a trap, and a fair one: half the class divides by four. Say what each catches: the cone
widens exactly as the light thins. Then close the cone and read flux and quotient together: 0/0 with a limit, the first
derivative of the course. The deck calls it "perceived light": the eye enters only with lumens and candela, later; and what an
eye perceives is radiance, in the next step. 5 minutes.
""",
    sources=("Deck, slide Basic Radiometric Quantities (1)", "Lambert 1760, Photometria: the cosine law of a flat source",
             "optics reference, D18: intensity is radiometric"),
    honesty="Exact, for a lamp that is small and obeys the cosine law. Beyond 90° the lamp gives nothing, and the mean falls.",
    values=(Value("half_angle", 35.0, low=0.5, high=120.0), Value("distance", 2.0, low=1.3, high=3.0, scale="linear"),
            Value("radiant_flux", 10.0)),
    minutes=5,
)

RADIANCE = Step(
    name="radiance",
    title="Radiance, and all the others at once",
    idea="Radiance is flux per area seen and per solid angle, and along a ray it does not change.",
    slides=(TWO,),
    prose=r"""
A sensor of area $A$ looks through a round opening at a glowing $\colour{l}{\text{wall}}$. Turn it by $\theta$: of its area
only $A\cos\theta$ faces the opening. What it reports is

$$L = \frac{\Phi}{A\,\cos\theta\;\omega}\qquad \frac{\text{W}}{\text{m}^2\,\text{sr}}$$

Drag $\colour{n}{n}$: the flux falls with the cosine, the radiance does not. Drag the rim: a [wide opening](?half_angle=30)
reads too little, as its outer light comes at a slant; a [narrow one](?half_angle=3) is right.

Drag the wall [twice as far](?distance=3.2). The spot that is seen grows as $r^2$, each part of it gives $1/r^2$. **Nothing
changes.** That is why a wall looks no darker from afar, and why a picture stores radiance.
""",
    scene=Scene(
        glsl="""
#include "optics/spherical.glsl"
#include "display/look.glsl"
uniform float theta;
uniform float half_angle;
uniform float distance;
uniform float radiance;

// The axis of the opening is +x, which is z of the formulas; the sensor turns about y.
vec3 along(vec3 p) {
    return vec3(p.z, p.y, p.x);
}

float reach() {
    return distance * tan(half_angle);
}

vec3 surface_point(int surface, vec2 s) {
    vec2 around = vec2(cos(2.0 * PI * s.x), sin(2.0 * PI * s.x));
    if (surface == 0) return vec3(distance, max(1.3, 1.15 * reach()) * (2.0 * s - 1.0));
    if (surface == 1) { // the sensor, enlarged
        vec2 p = 0.34 * (2.0 * s - 1.0);
        return vec3(-p.y * sin(theta), p.x, p.y * cos(theta));
    }
    if (surface == 2) return vec3(1.0, around * mix(tan(half_angle), 0.72, s.y));
    if (surface == 3) return distance * s.y * vec3(1.0, around * tan(half_angle));
    return vec3(distance - 0.006, around * s.y * reach());
}

vec3 shade(Surface s) {
    vec3 light = palette[COLOUR_L];
    float level = clamp(0.35 + 0.2 * log(radiance) / log(10.0), 0.2, 1.0);
    if (s.id == 0) return light * level * (1.0 - 0.35 * grid_lines(s.st, vec2(13.0)));
    if (s.id == 1) return soft_light(palette[COLOUR_V], s.normal, s.v) * (1.0 - 0.5 * grid_lines(s.st, vec2(6.0)));
    if (s.id == 2) return soft_light(mix(palette[COLOUR_QUIET], background, 0.25), s.normal, s.v);
    if (s.id == 3) return light * level;
    return light * (0.3 + level);
}

vec3 mark_point(int mark, float t) {
    if (mark == 0) return 0.85 * t * vec3(cos(theta), 0.0, sin(theta));
    if (mark == 1) return vec3(distance * t, 0.0, 0.0);
    if (mark == 2) return vec3(1.0, tan(half_angle) * cos(2.0 * PI * t), tan(half_angle) * sin(2.0 * PI * t));
    if (mark == 3) return vec3(distance - 0.01, reach() * cos(2.0 * PI * t), reach() * sin(2.0 * PI * t));
    return 0.5 * along(direction(theta * t, 0.0));
}

vec4 probe(int i) {
    if (i == 0) return vec4(mark_point(0, 1.0), 1.0);
    if (i == 1) return vec4(1.0, 0.0, tan(half_angle), 1.0);
    if (i == 2) return vec4(distance, 1.3, 0.0, 1.0);
    if (i == 3) return vec4(0.0, -0.1, -0.55, 1.0);
    if (i == 4) return vec4(1.0, 0.0, -0.9, 1.0);
    return vec4(distance, 0.0, 1.5, 1.0);
}
""",
        surfaces=(Surface("wall", cells=(2, 2)), Surface("sensor", cells=(6, 6)),
                  Surface("aperture", cells=(64, 2), opacity=0.8), Surface("seen", cells=(64, 1), opacity=0.28),
                  Surface("spot", cells=(64, 1))),
        marks=(Mark("normal", colour="n", tip="arrow", label="n"), Mark("axis", colour="l", tip="sun", line="dashed"),
               Mark("rim", colour="exact", segments=64, width=1.3), Mark("spot's rim", colour="l", segments=64),
               Mark("turned", colour="exact", segments=24, label="θ", label_at=0.5)),
        labels=(Label("sensor A", 3, "v"), Label("opening ω", 4), Label("wall L", 5, "l")),
        handles=(Handle("the sensor's normal", 0, ("theta",)), Handle("the opening's rim", 1, ("half_angle",)),
                 Handle("the wall", 2, ("distance",))),
        camera=Camera(azimuth=-142, elevation=24, distance=7.6, target=(1.25, 0.0, 0.05)),
    ),
    plot=Ledger(
        title="All six quantities",
        columns=(
            (
                LedgerRow("exitance B, wall", Term("radiant_exitance_lambert"), "W/m^2"),
                LedgerRow("radiance L", Term("radiance_sensor_projected"), "W/(m^2 sr)", "1/sr", "cosine law"),
                LedgerRow("intensity I, spot", Term("radiant_intensity_spot"), "W/sr", "m^2", "spot"),
            ),
            (
                LedgerRow("irradiance E, sensor", Term("irradiance_sensor"), "W/m^2"),
                LedgerRow("flux Φ, sensor", Term("radiant_flux_sensor"), "W", "m^2", "its area"),
                LedgerRow("energy Q in 1 s", Term("radiant_energy_sensor", {"duration": 1.0}), "J", "s", "time"),
            ),
        ),
    ),
    readouts=(
        Readout("flux Φ on the sensor", Term("radiant_flux_sensor"), unit="W"),
        Readout("radiance L of the wall", Term("radiance_sensor_projected"), role="exact", unit="W/(m² sr)"),
        Readout("Φ / (A cos θ ω)", Term("radiance_sensor"), role="estimate", unit="W/(m² sr)",
                against="radiance L of the wall"),
    ),
    ask=Prediction(
        question="You step back until the wall is twice as far away. How much of its radiance is left?",
        truth=Term("radiance_twice_as_far", {"half_angle": 0.2, "distance": 1.6}),
        unit="of it",
        choices=(Choice("a quarter: 1/r²", 0.2, 0.3), Choice("half of it", 0.4, 0.6), Choice("all of it", 0.9, 1.1)),
        sets={"distance": 3.2},
        told="All of it. Through the same opening you see four times the wall, and each part of it gives a quarter.",
    ),
    notes="""
The wall of the lecture hall is the demonstration: has it become darker for those in the last row? A quarter is the
tempting answer; it is right for the irradiance of a lamp and wrong for a thing one can see the edges of. Then tilt the
sensor to 80°: flux and cosine fall together, their quotient stays. The Moon: a ball lit from the front should darken to the
rim if it were matt (n·l falls); it looks flat because its rough dust is not Lambertian, chapter 5 explains it. 7 minutes.
""",
    sources=("Deck, slide Basic Radiometric Quantities (2)", "Nicodemus 1963: radiance is invariant along a ray",
             "Snyder 1969: disk seen from a tilted surface"),
    honesty="Exact: a large wall of one radiance, the sensor small beside the opening, which is 1 m away. The quotient is "
            "cos²(half the opening) of L; past the sensor's own horizon it means nothing. The sensor is drawn enlarged.",
    values=(Value("theta", 35.0, low=0.0, high=85.0), Value("half_angle", 17.0, low=1.0, high=32.0),
            Value("distance", 1.6, low=1.2, high=3.2, scale="linear"), Value("radiance", 100.0, low=1.0),
            Value("patch_area", 1e-4, more=True)),
    minutes=7,
)

IRRADIANCE = Step(
    name="irradiance",
    title="Irradiance",
    idea="Irradiance is all the radiance that arrives at a patch, every direction counted with its cosine.",
    slides=(THREE,),
    prose=r"""
A patch of floor cannot ask where light comes from. It adds up:

$$E = \int_\Omega L(\omega)\,\cos\theta\;d\omega\qquad \frac{\text{W}}{\text{m}^2}$$

Left is the $\colour{l}{\text{radiance}}$ of the sky as the patch sees it. Right is the same sky after the **cosine**: what
counts. The same light fades towards the horizon, where it only grazes.

Open the sky overhead [to all of it](?sky_piece=0&opening=90). Without the cosine it would give $2\pi L$. Try
[a low sun](?sky_piece=1&opening=8&theta=75), [a high one](?sky_piece=1&opening=8&theta=10),
[a window](?sky_piece=2&opening=35&theta=60). Drag it down to the horizon: half of it sets, and what is left hardly counts.
""",
    scene=Scene(
        glsl="""
#include "optics/square_patch.glsl"
#include "display/look.glsl"
uniform int sky_piece;
uniform float radiance;
uniform float opening;
uniform float theta;

vec3 dome_at(int k) {
    return vec3(k == 0 ? -1.2 : 1.2, 0.0, 0.0);
}

vec3 piece(vec2 s) {
    if (sky_piece == 2) return normalize(patch_point(theta, 0.0, 1.0, 0.0, 2.0 * sin(opening), s.x, s.y));
    float to_pole = sky_piece == 0 ? 0.0 : theta;
    vec3 d = cap_point(opening, s.x, s.y);
    return d.x * direction_theta(to_pole, 0.0) + d.y * direction_phi(0.0) + d.z * direction(to_pole, 0.0);
}

vec3 surface_point(int surface, vec2 s) {
    int k = surface % 2;
    if (surface < 2) return dome_at(k) + cap_point(0.5 * PI, s.x, s.y);
    if (surface > 5) return dome_at(k) + 0.995 * piece(s);
    if (surface < 4) return dome_at(k) + vec3(s.y * cos(2.0 * PI * s.x), s.y * sin(2.0 * PI * s.x), 0.0);
    return dome_at(k) + vec3(0.24 * s - 0.12, 0.03);
}

vec3 shade(Surface s) {
    int k = s.id % 2;
    vec3 off = s.position - dome_at(k);
    if (s.id < 2) return glass(s.st, vec2(24.0, 6.0));
    if (s.id < 4) return mix(mix(background, palette[COLOUR_QUIET], 0.3), palette[COLOUR_QUIET], grid_lines(s.st, vec2(24.0, 6.0)) * 0.5);
    if (s.id < 6) return palette[COLOUR_N];
    vec3 d = normalize(off);
    if (d.z < 0.0) discard;
    vec2 st = vec2(arctan2(d.y, d.x) / (2.0 * PI), arccos(d.z) / (0.5 * PI));
    float glow = (k == 0 ? 1.0 : max(0.0, d.z)) * (0.5 + 0.5 * clamp(log(radiance + 1.0) / 7.0, 0.0, 1.0));
    return mix(mix(background, palette[COLOUR_QUIET], 0.12), palette[COLOUR_L], glow) * (1.0 - 0.25 * grid_lines(st, vec2(24.0, 6.0)));
}

vec3 mark_point(int mark, float t) {
    if (mark < 2) return dome_at(mark) + vec3(0.0, 0.0, 1.32 * t);
    vec3 d = sky_piece == 0 ? direction(opening, 0.0) : direction(theta, 0.0);
    return dome_at(mark - 2) + (1.0 - t) * d * 0.98;
}

vec4 probe(int i) {
    vec3 d = sky_piece == 0 ? direction(opening, 0.0) : direction(theta, 0.0);
    if (i == 0) return vec4(dome_at(0) + direction(theta, 0.0), 1.0);
    if (i == 1) return vec4(dome_at(1) + d, 1.0);
    return vec4(dome_at(i - 2) + vec3(0.0, -0.6, -0.62), 1.0);
}
""",
        surfaces=(
            Surface("dome left", cells=(48, 12), opacity=0.14), Surface("dome right", cells=(48, 12), opacity=0.14),
            Surface("floor left", cells=(48, 6)), Surface("floor right", cells=(48, 6)),
            Surface("patch left", cells=(1, 1)), Surface("patch right", cells=(1, 1)),
            Surface("sky", cells=(48, 16)), Surface("sky with cosine", cells=(48, 16)),
        ),
        marks=(
            Mark("normal", colour="n", tip="arrow", label="n"), Mark("normal right", colour="n", tip="arrow"),
            Mark("ray left", colour="l", tip="arrow", width=1.4), Mark("ray right", colour="l", tip="arrow", width=1.4),
        ),
        labels=(Label("L: seen", 2), Label("L cos θ: counts", 3)),
        handles=(Handle("the piece of sky", 0, ("theta",)),),
        camera=Camera(azimuth=-90, elevation=30, distance=9.6, target=(0.0, 0.0, 0.3)),
    ),
    plot=Curves(
        title="A cap of sky overhead, opened",
        sweep="opening",
        curves=(Curve("with the cosine, πL sin²", Term("irradiance_cap", {"half_angle": "opening"})),
                Curve("without, L ω", Term("irradiance_without_cosine", {"half_angle": "opening"}), role="printed")),
        y_label="W/m²",
    ),
    readouts=(
        Readout("E of this piece", Term("irradiance_piece"), role="exact", unit="W/m²"),
        Readout("E of the whole sky, πL", Term("irradiance_cap", {"half_angle": PI / 2}), unit="W/m²"),
        Readout("without the cosine, 2πL", Term("irradiance_without_cosine", {"half_angle": PI / 2}), unit="W/m²"),
    ),
    ask=Prediction(
        question="An overcast sky has the radiance 1 W/(m² sr) in every direction. What is the irradiance of the ground?",
        truth=Term("irradiance_cap", {"radiance": 1.0, "half_angle": PI / 2}),
        unit="W/m²",
        low=0.0,
        high=8.0,
        sets={"sky_piece": 0, "opening": 90.0, "radiance": 1.0},
        told="π = 3.14, not 2π. The sky has 2π steradians, and the mean of the cosine over them is one half.",
    ),
    notes="""
Everyone says 2π, and chapter 1 has earned it for them: that is the solid angle. Open the sky slowly and watch the two
curves part only beyond 40°: near the normal the cosine is 1. Then the sun at 75°: same disk, same radiance, a quarter of
the irradiance; that is winter. The deck says "from all directions" and means the hemisphere over the patch: light from
below does not count, the window that sets at the horizon shows it. 6 minutes.
""",
    sources=("Deck, slide Basic Radiometric Quantities (3)", "optics reference 2.3: projected solid angles",
             "optics reference, D18: irradiance is flux per area"),
    honesty="Exact: each piece has one radiance. The sun is shown and computed as large as you set it; the real one is "
            "0.27°. The window is a square at 1 m that faces the patch.",
    values=(Value("sky_piece", 2, choices=("overhead", "sun", "window")), Value("opening", 28.0, low=0.3, high=90.0),
            Value("theta", 42.0, low=0.0, high=100.0), Value("radiance", 100.0)),
    minutes=6,
)

RADIOSITY = Step(
    name="radiosity",
    title="Radiosity: what leaves",
    idea="Radiosity B is all that leaves a patch per area; a matt one sends it out as the same radiance B/π everywhere.",
    slides=(THREE,),
    prose=r"""
What arrives must go somewhere. A share $\rho$ of the $\colour{l}{\text{irradiance}}$ is sent back, the rest is kept as heat:

$$B = \rho\,E$$

$\colour{v}{\text{Radiosity}}$, also called radiant exitance, has the unit of irradiance and the other direction. It says
how much leaves, not where to. A **matt** surface answers that in the simplest way: the same radiance in all directions,

$$L = \frac{B}{\pi}$$

Drag the eye: the $\colour{v}{\text{dome}}$ is round, $L$ stays. The $\colour{estimate}{\text{ball}}$ inside is what each
direction carries off, $L\cos\theta$; a slanted patch looks smaller. Try [snow](?rho=0.9), [asphalt](?rho=0.08),
[the eye low](?theta=80).
""",
    scene=Scene(
        glsl="""
#include "optics/radiometry.glsl"
#include "display/look.glsl"
uniform float rho;
uniform float irradiance;
uniform float theta;

const float FULL = 1.5; // radius of the dome when all is sent back

float dome() {
    return FULL * PI * radiance_lambert(rho, 1.0);
}

vec3 surface_point(int surface, vec2 s) {
    if (surface == 0) return dome() * cap_point(0.5 * PI, s.x, s.y);
    if (surface == 1) {
        vec3 d = cap_point(0.5 * PI, s.x, s.y);
        return dome() * max(0.0, d.z) * d;
    }
    if (surface == 2) return vec3(1.0 * (2.0 * s - 1.0), -0.012);
    float wide = 0.075, x = surface == 3 ? -2.05 : surface == 4 ? 2.05 : 2.4;
    float high = surface == 3 ? 1.0 : surface == 4 ? radiant_exitance_reflected(rho, 1.0) : radiant_exitance_absorbed(rho, 1.0);
    return vec3(x + wide * (2.0 * s.x - 1.0) * 1.6, -0.3, 1.7 * s.y * high);
}

vec3 shade(Surface s) {
    if (s.id == 0) return mix(glass(s.st, vec2(24.0, 6.0)), palette[COLOUR_V], 0.55);
    if (s.id == 1) return soft_light(palette[COLOUR_ESTIMATE], s.normal, s.v);
    if (s.id == 2) {
        vec3 matt = vec3(rho) * (0.35 + 0.65 * clamp(log(irradiance) / 7.0, 0.0, 1.0));
        return mix(matt, palette[COLOUR_QUIET], 0.4 * grid_lines(s.st, vec2(8.0)));
    }
    if (s.id == 3) return palette[COLOUR_L];
    return s.id == 4 ? palette[COLOUR_V] : palette[COLOUR_LOST];
}

vec3 mark_point(int mark, float t) {
    if (mark < 5) { // light that comes in, from the left
        vec3 foot = vec3(0.3 * float(mark - 2), 0.0, 0.0);
        return foot + (1.0 - t) * 1.9 * direction(0.7, PI) * (0.9 + 0.05 * float(mark));
    }
    if (mark == 5) return (dome() + 0.65) * t * direction(theta, 0.0);
    if (mark == 6) return 1.95 * t * vec3(0.0, 0.0, 1.0);
    return 0.42 * direction(theta * t, 0.0);
}

vec4 probe(int i) {
    if (i == 0) return vec4((dome() + 0.65) * direction(theta, 0.0), 1.0);
    if (i == 1) return vec4(2.05, -0.3, 1.7 * rho, 1.0);
    return vec4(i == 2 ? -2.05 : i == 3 ? 1.98 : 2.5, -0.3, -0.14, 1.0);
}
""",
        surfaces=(Surface("radiance", cells=(48, 12), opacity=0.32),
                  Surface("flux by direction", cells=(48, 16), opacity=0.85), Surface("patch", cells=(1, 1)),
                  Surface("E", cells=(1, 1)), Surface("B", cells=(1, 1)), Surface("kept", cells=(1, 1))),
        marks=(*(Mark(f"light {i}", colour="l", tip="arrow", width=0.9) for i in range(5)),
               Mark("to the eye", colour="v", tip="eye", width=1.4), Mark("normal", colour="n", tip="arrow", label="n"),
               Mark("angle", colour="exact", segments=24, label="θ", label_at=0.5)),
        labels=(Label("E", 2, "l"), Label("B", 3, "v"), Label("kept", 4)),
        handles=(Handle("the eye", 0, ("theta",)), Handle("what is sent back", 1, ("rho",))),
        camera=Camera(azimuth=-90, elevation=14, distance=9.6, target=(0.2, 0.0, 0.75)),
        legend=(("v", "radiance L, every direction"), ("estimate", "flux by direction, L cos θ")),
    ),
    plot=Curves(
        title="A matt surface from every side",
        sweep="theta",
        curves=(Curve("radiance L, W/(m² sr)", Term("radiance_lambert")),
                Curve("L cos θ, W/(m² sr)", Term("intensity_per_area_lambert"), role="estimate")),
        y_label="W/(m² sr)",
    ),
    readouts=(
        Readout("B = ρE", Term("radiant_exitance_reflected"), unit="W/m²"),
        Readout("kept, (1 - ρ)E", Term("radiant_exitance_absorbed"), unit="W/m²"),
        Readout("L = B/π", Term("radiance_lambert"), role="exact", unit="W/(m² sr)"),
        Readout("B/2π", Term("radiance_lambert_over_hemisphere"), role="printed", unit="W/(m² sr)", against="L = B/π"),
    ),
    ask=Prediction(
        question="A white wall, ρ = 0.8, gets 500 W/m². It is matt. What is its radiance?",
        truth=Term("radiance_lambert", {"rho": 0.8, "irradiance": 500.0}),
        unit="W/(m² sr)",
        low=0.0,
        high=500.0,
        sets={"rho": 0.8, "irradiance": 500.0},
        told="400/π = 127. Not 400: that is all directions together. Not 400/2π = 64: the slanted ones count less.",
    ),
    notes="""
Let them say where the 500 W go: 400 leave, 100 warm the wall. Then the division: 64 is the clever wrong answer, who gives it
remembers 2π steradians and forgets the cosine; the 1/π of every diffuse shader is decided here. Two names for one thing:
radiosity (heat engineering, the deck) and radiant exitance (ISO). Drag the eye to 80° and ask why the wall looks no darker:
it sends less there, and looks smaller by as much. 5 minutes.
""",
    sources=("Deck, slide Basic Radiometric Quantities (3)", "Lambert 1760, Photometria", "ISO 80000-7: radiant exitance"),
    honesty="Exact for a matt (Lambert) surface that emits nothing itself. Real walls are only nearly matt.",
    values=(Value("rho", 0.65), Value("irradiance", 500.0), Value("theta", 50.0, low=0.0, high=89.0)),
    minutes=5,
)

INVERSE_SQUARE = Step(
    name="inverse_square",
    title="Inverse square: when is far far?",
    idea="A point and a sphere obey 1/r² at any distance; a disk does so from about five diameters on, to one percent.",
    slides=("Plausible Shading - Measuring Light",),
    prose=r"""
Three lamps of the same radiance $L$ before three screens: a point, a $\colour{l}{\text{sphere}}$, a
$\colour{l}{\text{disk}}$. Seen from afar they are one, with the intensity $I = \pi R^2 L$, and the screen gets

$$E = \frac{I}{r^2}$$

Push the screens away and bring them [close](?distance=0.7). The **sphere** obeys $1/r^2$ exactly until you touch it. The
**disk** does not: near it $E$ stays below $\pi L$, while the rule runs away. Its excess is $(R/r)^2$.

The rule of thumb says five times the size: [at five diameters](?radius=0.3&distance=3) the excess is one percent; at
[half a diameter](?radius=0.7&distance=0.7) it is a hundred.

The $I/r^2$ of the slides is an **irradiance**, not a radiance.
""",
    scene=Scene(
        glsl="""
#include "optics/radiometry.glsl"
#include "optics/spherical.glsl"
#include "core/angle.glsl"
#include "display/palette.glsl"
uniform float radius;
uniform float distance;
uniform float radiance;

const float HALF = 0.72; // of a screen

float row(int k) {
    return 1.75 * float(1 - k); // point, sphere, disk
}

vec3 surface_point(int surface, vec2 s) {
    if (surface < 3) return vec3(distance, row(surface) + HALF * (2.0 * s.x - 1.0), HALF * (2.0 * s.y - 1.0));
    vec3 at = vec3(0.0, row(surface - 3), 0.0);
    if (surface == 3) return at + 0.035 * sphere_point(s.x, s.y);
    if (surface == 4) return at + radius * sphere_point(s.x, s.y);
    return at + radius * s.y * vec3(0.0, cos(2.0 * PI * s.x), sin(2.0 * PI * s.x));
}

vec3 shade(Surface s) {
    if (s.id > 2) return mix(palette[COLOUR_L], vec3(1.0), 0.25);
    vec2 off = s.position.yz - vec2(row(s.id), 0.0);
    float r = length(vec3(off, distance)), slant = arctan2(length(off), distance), got;
    if (s.id == 0) got = irradiance_point(PI * radius * radius * radiance, r, slant);
    else if (s.id == 1) got = irradiance_sphere(radiance, radius, r, slant);
    else got = irradiance_disk(radiance, radius, distance, length(off));
    float share = got * distance * distance / (PI * radius * radius * radiance); // 1: what the rule says of the middle
    float steps = abs(fract(10.0 * share + 0.5) - 0.5) / max(fwidth(10.0 * share), 1e-5);
    return mix(colormap(share), background, 0.5 * (1.0 - smoothstep(0.5, 1.5, steps)));
}

vec3 mark_point(int mark, float t) {
    int k = mark % 3;
    vec3 at = vec3(0.0, row(k), 0.0);
    if (mark < 3) return at + vec3(distance * t, 0.0, 0.0);
    float far = k == 0 ? 0.035 : radius; // the widest ray
    vec3 from = at + vec3(0.0, 0.0, far), to = at + vec3(distance, 0.0, HALF);
    return mix(from, to, t);
}

vec4 probe(int i) {
    if (i == 0) return vec4(distance, row(2), 0.0, 1.0);
    if (i == 1) return vec4(0.0, row(2), radius, 1.0);
    return vec4(0.0, row(i - 2), -0.78, 1.0);
}
""",
        surfaces=(Surface("screen of the point", cells=(2, 2)), Surface("screen of the sphere", cells=(2, 2)),
                  Surface("screen of the disk", cells=(2, 2)), Surface("point", cells=(24, 12)),
                  Surface("sphere", cells=(32, 16)), Surface("disk", cells=(64, 1))),
        marks=(Mark("r of the point", colour="l", line="dashed"), Mark("r of the sphere", colour="l", line="dashed"),
               Mark("r of the disk", colour="l", line="dashed", label="r", label_at=0.55),
               *(Mark(f"edge {k}", colour="quiet", line="dotted", width=0.8) for k in range(3))),
        labels=(Label("point", 2), Label("sphere", 3), Label("disk", 4)),
        handles=(Handle("the screens", 0, ("distance",)), Handle("the lamps' rim", 1, ("radius",))),
        camera=Camera(azimuth=-138, elevation=30, distance=9.6, target=(0.8, 0.0, -0.1)),
    ),
    plot=Curves(
        title="Irradiance against distance",
        sweep="distance",
        curves=(Curve("disk", Term("irradiance_disk", {"height": "distance", "offset": 0.0})),
                Curve("sphere, by its centre", Term("irradiance_sphere", {"theta": 0.0}), role="estimate"),
                Curve("I / r²", Term("irradiance_round_far"), role="printed")),
        y_label="W/m²", y_scale="log", x_scale="log",
    ),
    readouts=(
        Readout("sphere", Term("irradiance_sphere", {"theta": 0.0}), unit="W/m²"),
        Readout("disk", Term("irradiance_disk", {"height": "distance", "offset": 0.0}), role="exact", unit="W/m²"),
        Readout("I / r²", Term("irradiance_round_far"), role="printed", unit="W/m²", against="disk"),
    ),
    ask=Prediction(
        question="A round lamp is 20 cm wide. You measure one metre away, at five times its size. By what share is I/r² too "
                 "large?",
        truth=Term("inverse_square_excess", {"radius": 0.1, "distance": 1.0}),
        unit="of it",
        low=0.0,
        high=0.2,
        sets={"radius": 0.1, "distance": 1.0},
        told="By (R/r)² = 0.01: one percent. That is why photometric laboratories stand five sizes away, and no nearer.",
    ),
    notes="""
Bring the screens close: the disk's screen stays dark in the middle, the other two do not. Ask
which lamp the real-time engine has: always the point, and the artist moves it through a table and gets a white hole. That
the sphere is exact at every distance is Newton's theorem in another dress; nobody guesses it. Here "size" is the
diameter; who takes the radius gets four percent. 6 minutes.
""",
    sources=("Deck, slide Plausible Shading - Measuring Light", "optics reference 2.3 and D5", "CIE 121-1996: five-times rule"),
    honesty="Exact: closed forms of sphere and parallel disk on the axis and off it. The screens show E as a share of "
            "what I/r² says of their middle, with a line at every tenth.",
    values=(Value("distance", 1.5, low=0.45, high=5.0), Value("radius", 0.4, low=0.05, high=0.7), Value("radiance", 100.0)),
    minutes=6,
    breaks=(Break("the disk by 1 − almost 1, far away", {"irradiance_disk": "irradiance_disk_naive"}, {"distance": 1.0, "radius": 0.0006},
                  "Seen from 1700 radii the disk fills a millionth of the view, and the printed factor takes that from 1 less almost 1. Of the 24 bits of float32 two or three are left: the screen shows their steps. Right where the point light is as good as exact, the exact formula is noise. Multiply the difference out on paper first.",
                  "irradiance by the disk", Term("irradiance_disk", {"height": "distance", "offset": 0.3}), "W/m²"),),
)

LOCAL_ONLY = Step(
    name="local_only",
    title="What local shading leaves out",
    idea="Local shading knows a point and a lamp; what stands between them, and what other surfaces send, it leaves out.",
    slides=("Local Shading Models",),
    prose=r"""
A local model asks at each point: where is the lamp, how far, how slanted? Then it is done. It runs on every pixel at once,
knowing nothing of the rest, and that is why shaders love it.

Here is what it omits. [Local](?sees=0): the ball floats, its shadow is missing. [With shadows](?sees=1): the lamp is
blocked, and the shadow is pitch black. [With the wall's light](?sees=2): what the $\colour{r}{\text{wall}}$ reflects
reaches into the shadow and tints the floor.

Drag the $\colour{v}{\text{dot}}$ into [the shadow](?from_wall=0.75) and read its irradiance three times:

$$E = E_{\text{lamp}}\,V + \int L_{\text{wall}}\cos\theta\,d\omega$$

In a closed white room the second part **is** most of the light.
""",
    scene=Scene(
        glsl="""
#include "optics/room.glsl"
#include "optics/spherical.glsl"
#include "display/look.glsl"
uniform int sees;
uniform float from_wall;
uniform float along_wall;
uniform float lamp_x;
uniform float lamp_height;
uniform float radiant_intensity;
uniform float rho;

const vec3 WALL = vec3(0.9, 0.32, 0.12); // tint of what it reflects

vec3 surface_point(int surface, vec2 s) {
    if (surface == 0) return vec3(2.5 * s.x, 2.0 * s.y - 1.0, 0.0);
    if (surface == 1) return vec3(0.0, 2.0 * s.x - 1.0, 2.0 * s.y);
    return BALL + BALL_RADIUS * sphere_point(s.x, s.y);
}

// What the wall sends to the floor: it changes slowly, and is dear.
vec4 surface_value(int surface, vec2 s) {
    if (surface > 0 || sees < 2) return vec4(0.0);
    vec3 p = surface_point(0, s);
    return vec4(irradiance_floor_bounced(max(p.x, 0.02), p.y, lamp_x, lamp_height, radiant_intensity, rho));
}

// A screen's white is 1: as bright as 6 W/m^2 on white paper.
vec3 shade(Surface s) {
    vec3 p = s.position, lamp = vec3(lamp_x, 0.0, lamp_height);
    float white = 6.0;
    if (s.id == 0) {
        float x = max(p.x, 0.02);
        float direct = sees == 0 ? irradiance_floor_local(x, p.y, lamp_x, lamp_height, radiant_intensity)
                                 : irradiance_floor_shadowed(x, p.y, lamp_x, lamp_height, radiant_intensity);
        vec3 light = vec3(direct);
        if (sees == 2) light += WALL / WALL.r * s.value.x;
        vec3 tiles = vec3(0.82) * (1.0 - 0.12 * grid_lines(s.st, vec2(10.0, 8.0)));
        return tiles * (1.0 - exp(-1.6 * light / white));
    }
    vec3 n = s.id == 1 ? vec3(1.0, 0.0, 0.0) : normalize(p - BALL), to_lamp = lamp - p;
    float r2 = dot(to_lamp, to_lamp), got = radiant_intensity * max(0.0, dot(n, to_lamp)) / (r2 * sqrt(r2));
    if (s.id == 1) {
        if (sees > 0) got *= seen_past_ball(p, lamp, BALL, BALL_RADIUS);
        return WALL * max(rho, 0.05) * (1.0 - exp(-1.6 * got / white));
    }
    return vec3(0.05) + 0.12 * vec3(1.0 - exp(-got / white)) + 0.05 * pow(max(0.0, dot(n, normalize(to_lamp + s.v * length(to_lamp)))), 60.0);
}

vec3 mark_point(int mark, float t) {
    vec3 lamp = vec3(lamp_x, 0.0, lamp_height), dot_at = vec3(from_wall, along_wall, 0.012);
    if (mark == 0) return mix(dot_at, lamp, t);
    if (mark == 1) return mix(vec3(0.0, 0.5 * along_wall, 0.6), dot_at, t);
    if (mark == 2) return mix(lamp, vec3(0.0, 0.5 * along_wall, 0.6), t);
    if (mark == 3) return lamp;
    return dot_at;
}

vec4 probe(int i) {
    if (i == 0) return vec4(from_wall, along_wall, 0.0, 1.0);
    if (i == 1) return vec4(lamp_x, 0.0, lamp_height, 1.0);
    return vec4(0.02, 0.72, 1.86, 1.0);
}
""",
        surfaces=(Surface("floor", cells=(50, 40)), Surface("wall", cells=(1, 1)), Surface("ball", cells=(32, 16))),
        marks=(Mark("to the lamp", colour="l", line="dashed", width=0.9),
               Mark("from the wall", colour="r", line="dotted", tip="arrow"),
               Mark("to the wall", colour="r", line="dotted"), Mark("lamp", colour="l", tip="sun", width=2.0),
               Mark("dot", colour="v", tip="dot", width=1.5)),
        labels=(Label("wall", 2, "r"),),
        handles=(Handle("the dot", 0, ("from_wall", "along_wall")), Handle("the lamp", 1, ("lamp_x", "lamp_height"))),
        camera=Camera(azimuth=-58, elevation=28, distance=7.2, target=(1.1, 0.0, 0.75)),
    ),
    plot=Curves(
        title="Irradiance along the floor",
        sweep="from_wall",
        curves=(Curve("with the wall's light", Term("irradiance_floor")),
                Curve("with shadows", Term("irradiance_floor_shadowed"), role="estimate"),
                Curve("local", Term("irradiance_floor_local"), role="printed")),
        y_label="W/m²",
    ),
    readouts=(
        Readout("with the wall's light", Term("irradiance_floor"), role="exact", unit="W/m²"),
        Readout("local", Term("irradiance_floor_local"), role="printed", unit="W/m²", against="with the wall's light"),
        Readout("with shadows", Term("irradiance_floor_shadowed"), role="estimate", unit="W/m²",
                against="with the wall's light"),
        Readout("closed room, times", Term("interreflection_gain"), unit=""),
    ),
    ask=Prediction(
        question="A closed room, every wall matt and white: ρ = 0.8. How many times the light that local shading counts is "
                 "really there, on the mean?",
        truth=Term("interreflection_gain", {"rho": 0.8}),
        unit="times",
        low=1.0,
        high=10.0,
        sets={"rho": 0.8, "sees": 2},
        told="Five: 1 + 0.8 + 0.64 + ... = 1/(1 - 0.8). Four fifths of the light in a white room are second hand.",
    ),
    notes="""
Show "local" first and ask what is odd: most see the ball float before they miss the shadow. Then ask what colour a shadow
has. Our second renderer, pyrender, is a shader too: it draws the first picture, and with a spot light and its shadow map
the second; tests compare both with ours, pixel by pixel. What the wall sends it cannot draw at all; that was checked by
following random rays. "Two times" is the usual guess for the white room. Why
then teach local shading? Because every other kind calls it at each bounce. 6 minutes.
""",
    sources=("Deck, slide Local Shading Models", "Wallace, Elmquist & Haines 1989: a cell as a disk",
             "Ulbricht 1900: the integrating sphere, 1/(1 - ρ)"),
    honesty="Lamp and shadow are exact for a point lamp. The wall's light: one reflection, the wall as 100 disks, within 2 % "
            "of the local value from 0.2 m on; the ball is black. 1/(1 - ρ) is exact in a sphere, a mean elsewhere. The second renderer has shadow maps for spot lights, none for points, and no "
            "inter-reflection. Colours pass a film curve.",
    values=(Value("sees", 2, choices=("local", "with shadows", "with the wall's light")), Value("rho", 0.8),
            Value("from_wall", 0.75, low=0.2), Value("along_wall", 0.0, more=True), Value("lamp_x", 1.75), Value("lamp_height", 1.6, more=True),
            Value("radiant_intensity", 20.0, low=1.0, high=100.0, more=True)),
    minutes=6,
)

BULB = {"electrical_power": 100.0, "source_efficacy": 30.0}

LEDGER = Step(
    name="ledger",
    title="The unit ledger",
    idea="Watts, lumens, candela, lux and candela per square metre are five things; each is the last times a factor with a unit.",
    slides=("Units for Lighting - Watts", "Units for Lighting - Lumen", "Units for Lighting - Candela"),
    prose=r"""
Follow the light of a bulb down the ledger. It **draws** $P$ watts and gives lumens by its efficacy: the deck's 100 W at
30 lm/W are 3000 lm. Spread over $4\pi$ steradians that is candela; on paper at distance $r$, lux; what the matt paper sends
on, candela per square metre:

$$\text{lm} \xrightarrow{\div\,\text{sr}} \text{cd} \xrightarrow{\div\,r^2} \text{lx} \xrightarrow{\times\,\rho/\pi} \text{cd/m}^2$$

The right column is the same without the eye, in watts. It starts with what is **produced**, not with what is consumed.

Drag the bulb. The table's rim splits the lumens: what it $\colour{l}{\text{receives}}$ and what escapes add up to all.
Change to [an LED](?electrical_power=25&source_efficacy=120): a quarter of the power, the same light.
""",
    scene=Scene(
        glsl="""
#include "optics/bulb.glsl"
#include "optics/spherical.glsl"
#include "core/angle.glsl"
#include "display/look.glsl"
uniform float electrical_power;
uniform float source_efficacy;
uniform float distance;
uniform float radius;
uniform float rho;

vec3 surface_point(int surface, vec2 s) {
    vec2 around = vec2(cos(2.0 * PI * s.x), sin(2.0 * PI * s.x));
    if (surface == 0) return vec3(radius * s.y * around, 0.0);
    if (surface == 1) return vec3(0.0, 0.0, distance) + 0.12 * sphere_point(s.x, s.y);
    if (surface == 2) return vec3((0.3 * s.x - 0.15) * 1.41, 0.3 * s.y - 0.15, 0.025);
    return mix(vec3(0.0, 0.0, distance), vec3(radius * around, 0.0), s.y);
}

vec3 shade(Surface s) {
    if (s.id == 1) return mix(palette[COLOUR_L], vec3(1.0), 0.35);
    if (s.id == 3) return palette[COLOUR_L];
    float r = length(vec3(s.position.xy, distance)), slant = arctan2(length(s.position.xy), distance);
    float got = illuminance_point(bulb_luminous_intensity(electrical_power, source_efficacy), r, slant);
    float level = clamp((log(got) / log(10.0) + 0.5) / 4.2, 0.0, 1.0); // 0.3 lx to 5000 lx
    if (s.id == 2) return vec3(sqrt(rho) * (0.25 + 0.75 * level));
    float share = got / bulb_illuminance(electrical_power, source_efficacy, distance); // of the middle's
    return mix(colormap(share * (0.6 + 0.4 * level)), background, 0.35 * grid_lines(s.st, vec2(24.0, 6.0)));
}

vec3 mark_point(int mark, float t) {
    vec3 lamp = vec3(0.0, 0.0, distance);
    if (mark == 0) return lamp * (1.0 - t);
    if (mark == 1) return vec3(radius * cos(2.0 * PI * t), radius * sin(2.0 * PI * t), 0.004);
    vec3 d = fibonacci_direction(mark - 2, 22);
    return lamp + d * (0.2 + 0.3 * t);
}

vec4 probe(int i) {
    if (i == 0) return vec4(0.0, 0.0, distance, 1.0);
    if (i == 1) return vec4(radius, 0.0, 0.0, 1.0);
    if (i == 2) return vec4(0.35, 0.0, distance + 0.3, 1.0);
    if (i == 3) return vec4(0.0, 0.0, 0.55 * distance, 1.0);
    if (i == 4) return vec4(0.42, -0.3, 0.0, 1.0);
    return vec4(-0.62 * radius, -0.62 * radius, 0.0, 1.0);
}
""",
        surfaces=(Surface("table", cells=(64, 12)), Surface("bulb", cells=(24, 12)), Surface("paper", cells=(1, 1)),
                  Surface("what the table gets", cells=(96, 1), opacity=0.13)),
        marks=(Mark("distance", colour="l", line="dashed", label="r", label_at=0.45),
               Mark("rim", colour="exact", segments=96),
               *(Mark(f"ray {i}", colour="l", width=0.9) for i in range(22))),
        labels=(Label("lm, cd", 2, "l"), Label("cd/m²", 4), Label("lx", 5)),
        handles=(Handle("the bulb", 0, ("distance",)), Handle("the table's rim", 1, ("radius",))),
        camera=Camera(azimuth=-60, elevation=22, distance=8.4, target=(0.0, 0.0, 1.1)),
    ),
    plot=Ledger(
        title="Each step with its unit",
        columns=(
            (
                LedgerRow("drawn from the mains", Term("bulb_radiant_flux", {"radiated_share": 1.0}), "W"),
                LedgerRow("luminous flux", Term("luminous_flux_source"), "lm", "lm/W", "efficacy"),
                LedgerRow("luminous intensity", Term("bulb_luminous_intensity"), "cd", "1/sr"),
                LedgerRow("illuminance", Term("bulb_illuminance"), "lx", "sr/m^2"),
                LedgerRow("luminance", Term("bulb_luminance"), "cd/m^2", "1/sr", "matt"),
            ),
            (
                LedgerRow("drawn from the mains", Term("bulb_radiant_flux", {"radiated_share": 1.0}), "W"),
                LedgerRow("radiant flux", Term("bulb_radiant_flux"), "W", "", "radiated"),
                LedgerRow("radiant intensity", Term("bulb_radiant_intensity"), "W/sr", "1/sr"),
                LedgerRow("irradiance", Term("bulb_irradiance"), "W/m^2", "sr/m^2"),
                LedgerRow("radiance", Term("bulb_radiance"), "W/(m^2 sr)", "1/sr", "matt"),
            ),
        ),
        balance=(Term("luminous_flux_source"), Term("bulb_received"), Term("bulb_escaped")),
        unit="lm",
    ),
    readouts=(
        Readout("luminous intensity", Term("bulb_luminous_intensity"), unit="cd"),
        Readout("illuminance", Term("bulb_illuminance"), unit="lx"),
        Readout("luminance", Term("bulb_luminance"), unit="cd/m²"),
        Readout("the table gets", Term("bulb_received"), unit="lm"),
    ),
    ask=Prediction(
        question="A bulb draws 100 W and gives 30 lm/W, evenly to all sides. How many candela has it?",
        truth=Term("bulb_luminous_intensity", BULB),
        unit="cd", low=10.0, high=10000.0, scale="log",
        sets=BULB,
        told="3000 lm / 4π sr = 239 cd. Lumens are not candela: lumens count all the light, candela the light one way.",
    ),
    notes="""
Write the five units on the board before opening the ledger and let the class draw the arrows. 3000 cd is the tempting
answer. Then the deck's example: 30 lm per watt drawn is no incandescent bulb (12 to 17) and no LED (80 to 200), it
is what compact lamps were before; say so. Check the deck's two sentences against each other: "not the consumed power" on one
slide, and 100 W of consumed power on the next. At 2.5 m the paper gets 38.2 lx, too little to read by. 7 minutes.
""",
    sources=("Deck, slides Units for Lighting - Watts, Lumen, Candela", "SI brochure 2019: lumen, candela, lux",
             "optics reference, D14", "pint: the dimension of every step"),
    honesty="Exact for a bulb that is even in all directions and a matt sheet; no reflections of the room. What the table "
            "gets is integrated over its area, what escapes over directions, by Gauss's rule, each by itself.",
    values=(Value("electrical_power", 100.0), Value("source_efficacy", 30.0, low=5.0, high=200.0),
            Value("distance", 2.5, low=0.5, high=3.0, scale="linear"), Value("radius", 1.5, low=0.3, high=2.0, scale="linear"),
            Value("rho", 0.8, more=True), Value("radiated_share", 0.9, more=True)),
    minutes=7,
)

EYE = Step(
    name="eye",
    title="What the eye makes of a watt",
    idea="A watt of light is worth up to 683 lumens, by its wavelength; white light can be worth half of that at most.",
    slides=("Units for Lighting - Lumen",),
    prose=r"""
The eye does not count watts. By day it weighs each wavelength with $\colour{v}{V(\lambda)}$: all of green, little of red
and blue, none of heat. Lumens are watts so weighed:

$$\Phi_v = 683\,\tfrac{\text{lm}}{\text{W}} \int V(\lambda)\,\Phi_\lambda\,d\lambda$$

The curtain is a lamp's spectrum, its bright part what the eye takes of it. [A filament](?lamp=0&temperature=2700) radiates
mostly heat. [Hotter](?lamp=0&temperature=6600) is best for a glowing body: 95 lm/W, never more. [An LED](?lamp=1) sends
nothing where nobody sees it. [Equal energy](?lamp=2) is neither.

Drag along the curve: at 555 nm a watt is worth 683 lm, of **green**. That is the ceiling, and no lamp to read by.
""",
    scene=Scene(
        glsl="""
#include "optics/photometry.glsl"
#include "display/palette.glsl"
uniform int lamp;
uniform float temperature;
uniform float wavelength;

float across(float nm) {
    return (nm - 580.0) / 200.0 * 1.9;
}

// A sketch of the colour of one wavelength, for the curtain only.
vec3 sketch(float nm) {
    vec3 centre = vec3(605.0, 545.0, 450.0), wide = vec3(52.0, 42.0, 30.0), off = (vec3(nm) - centre) / wide;
    vec3 c = exp(-0.5 * off * off);
    c.r += 0.3 * exp(-0.5 * pow((nm - 425.0) / 22.0, 2.0));
    return 0.08 + 0.92 * c;
}

vec3 surface_point(int surface, vec2 s) {
    float nm = mix(380.0, 780.0, s.x), high = lamp_spectrum(lamp, nm, temperature);
    if (surface == 0) return vec3(across(nm), 0.0, 1.9 * s.y * high);
    return vec3(across(nm), -0.02, 1.9 * s.y * high * luminous_efficiency(nm));
}

vec3 shade(Surface s) {
    float nm = mix(380.0, 780.0, s.st.x);
    return s.id == 0 ? mix(background, sketch(nm), 0.35) : sketch(nm);
}

vec3 mark_point(int mark, float t) {
    float nm = mix(380.0, 780.0, t);
    if (mark == 0) return vec3(across(nm), -0.04, 1.9 * luminous_efficiency(nm));
    if (mark == 1) return vec3(across(nm), -0.03, 1.9 * lamp_spectrum(lamp, nm, temperature));
    if (mark == 2) return vec3(across(nm), -0.03, 0.0);
    if (mark == 3) return vec3(across(wavelength), -0.05, 1.9 * t * luminous_efficiency(wavelength));
    return vec3(across(380.0 + 100.0 * float(mark - 4)), -0.03, -0.06 * t);
}

vec4 probe(int i) {
    if (i == 0) return vec4(across(wavelength), -0.05, 1.9 * luminous_efficiency(wavelength), 1.0);
    return vec4(across(280.0 + 100.0 * float(i)), -0.03, -0.2, 1.0);
}
""",
        surfaces=(Surface("spectrum", cells=(160, 1)), Surface("what the eye takes", cells=(160, 1))),
        marks=(Mark("V", colour="v", segments=160, width=1.5, label="V(λ)", label_at=0.58),
               Mark("spectrum", colour="exact", segments=160), Mark("axis", colour="quiet"),
               Mark("one wavelength", colour="v", tip="dot", line="dashed"),
               *(Mark(f"tick {nm}", colour="quiet") for nm in (380, 480, 580, 680, 780))),
        labels=tuple(Label(f"{nm} nm", i + 1) for i, nm in enumerate((380, 480, 580, 680, 780))),
        handles=(Handle("one wavelength", 0, ("wavelength",)),),
        camera=Camera(azimuth=-90, elevation=6, distance=8.6, target=(0.0, 0.0, 0.85)),
        legend=(("exact", "the lamp's spectrum"), ("v", "the eye")),
    ),
    plot=Curves(
        title="Lumens per watt of light, by temperature",
        sweep="temperature",
        curves=(Curve("black body, all it radiates", Term("luminous_efficacy_planck")),
                Curve("its light from 400 to 700 nm only", Term("luminous_efficacy_band", {"wavelength_low": 400.0,
                                                                                        "wavelength_high": 700.0}),
                      role="estimate")),
        y_label="lm/W",
    ),
    readouts=(
        Readout("this lamp, per watt of light", Term("luminous_efficacy_lamp"), unit="lm/W"),
        Readout("light of this wavelength", Term("luminous_efficacy_monochromatic"), unit="lm/W"),
        Readout("V(λ)", Term("luminous_efficiency"), unit=""),
    ),
    ask=Prediction(
        question="Engineers build the best white lamp they can: white like daylight, no ultraviolet, no heat. How many lumens can "
                 "it give for a watt of its light?",
        truth=Term("luminous_efficacy_band", {"temperature": 5800.0, "wavelength_low": 400.0, "wavelength_high": 700.0}),
        unit="lm/W",
        choices=(Choice("683", 600.0, 700.0), Choice("about 95", 80.0, 110.0), Choice("about 250, up to 370", 240.0, 370.0)),
        sets={"lamp": 0, "temperature": 5800.0},
        told="Daylight's colours from 400 to 700 nm: 251. If some colours may look a little wrong, up to 370. 683 is green only.",
    ),
    notes="""
Two efficacies are in every shop, and never kept apart: lumens per watt of light (here) and per watt drawn (the ledger).
A lamp of 150 lm/W drawn, its light worth 330, turns 45 % of the power into light. "683" is the tempting answer, it is the number on the
slide; ask what such a lamp's light looks like. The filament shows what the deck says: most is wasted outside the visible. At
6600 K a glowing body is at its best, at 95. 6 minutes.
""",
    sources=("Deck, slide Units for Lighting - Lumen", "CIE 018:2019: V(λ) of 1924, K_m = 683.002 lm/W",
             "Planck 1901, constants CODATA 2018", "Murphy 2012: 250 to 370 lm/W for white light", "optics reference, D14"),
    honesty="V is tabulated every 5 nm, linear in between. 683 belongs to 540 THz by definition, 683.002 to the table's "
            "peak. The LED is fitted by eye to the usual shape, no lamp's measurement. The curtain's colours are a sketch.",
    values=(Value("lamp", 0, choices=("black body", "LED", "equal energy")), Value("temperature", 4500.0),
            Value("wavelength", 520.0)),
    minutes=6,
)

PYTHON_STUB = '''import numpy as np


def illuminance_isotropic(luminous_flux, distance, theta):
    """Illuminance in lx, at a distance in m, of a point source of a flux in lm that is even in all directions.

    theta: angle in rad between the surface's normal and the direction to the source.
    """
    return luminous_flux + 0 * distance + 0 * theta
'''
PYTHON_SOLUTION = '''import numpy as np


def illuminance_isotropic(luminous_flux, distance, theta):
    """Lumens over 4 pi are candela; candela over r^2, times the cosine, are lux. From behind there comes nothing."""
    intensity = luminous_flux / (4 * np.pi)
    return intensity * np.maximum(0, np.cos(theta)) / distance**2
'''
GLSL_STUB = """#include "core/constants.glsl" // PI

float illuminance_isotropic(float luminous_flux, float distance, float theta) {
    return luminous_flux;
}
"""
GLSL_SOLUTION = """#include "core/constants.glsl"

float illuminance_isotropic(float luminous_flux, float distance, float theta) {
    float intensity = luminous_flux / (4.0 * PI);
    return intensity * max(0.0, cos(theta)) / (distance * distance);
}
"""

CHAPTER = Chapter(
    title="Radiometry",
    idea="Light is counted per second, per direction and per area; each count has its own name and unit.",
    steps=(ENERGY_FLUX, RADIANT_INTENSITY, RADIANCE, IRRADIANCE, RADIOSITY, INVERSE_SQUARE, LOCAL_ONLY, LEDGER, EYE),
    exercises=(
        Exercise(
            name="lux",
            function="illuminance_isotropic",
            task="A bulb gives a luminous flux evenly to all sides. Write the illuminance of a small surface at a distance, its "
                 "normal turned by theta from the direction to the bulb. Light from behind gives nothing, never less.",
            slide="Units for Lighting - Candela",
            stubs={"python": PYTHON_STUB, "glsl": GLSL_STUB},
            solutions={"python": PYTHON_SOLUTION, "glsl": GLSL_SOLUTION},
            checks=(
                Check({"luminous_flux": (3000.0,), "distance": (2.5,), "theta": (0.0,)},
                      "the deck's bulb at 2.5 m: 38.2 lx, of 239 cd and not of 3000"),
                Check({"luminous_flux": (800.0, 1500.0, 3000.0), "distance": (1.0, 2.0, 4.0), "theta": (0.5, 1.0, 1.25)},
                      "surfaces turned away from the bulb"),
                Check({"luminous_flux": (3000.0, 100.0), "distance": (0.01, 50.0), "theta": (0.25, 0.75)},
                      "a centimetre away, and fifty metres"),
                Check({"luminous_flux": (3000.0, 800.0), "distance": (1.0, 2.0), "theta": (2.0, 3.0)},
                      "light from behind the surface", hidden=True),
            ),
        ),
    ),
    terms={
        "radiant energy": "Q: how much light, in joules",
        "radiant flux": "Φ: energy per second, in watts; also called radiant power",
        "radiant intensity": "I: flux per solid angle, in W/sr; a lamp's property, without distance",
        "irradiance": "E: flux that arrives per area, in W/m²",
        "radiosity": "B: flux that leaves per area, in W/m²; also called radiant exitance",
        "radiance": "L: flux per area seen and per solid angle, in W/(m² sr); constant along a ray",
        "lumen": "luminous flux: watts weighed by the eye",
        "candela": "luminous intensity: lumens per steradian",
        "lux": "illuminance: lumens that arrive per square metre",
        "luminance": "candela per square metre: what the eye sees of a surface",
        "luminous efficacy": "lumens per watt; of radiation: per watt of light; of a source: per watt drawn from the mains",
        "inter-reflection": "light that other surfaces send on; local shading leaves it out",
    },
)
