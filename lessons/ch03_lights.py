"""Where does the light come from? From bodies; a point or a direction is what is left of them far away.

A shader asks every light two things: which way is it, and how much of it arrives here? This chapter answers both, for
points, directions, lamps that prefer some directions, spotlights, and lights with an area.
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
    Figure,
    Handle,
    Label,
    LeaveOut,
    Ledger,
    LedgerRow,
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

PI = 3.141592653589793

SOURCES = Step(
    name="sources",
    title="From a lamp to a point",
    idea="Shrink a lamp at constant flux: its intensity stays, its radiance grows without end, and a point has none.",
    slides=("Light Sources", "Punctual Lights"),
    prose=r"""
Lamps are bodies. A shader wants less: a **punctual light**, a point that stands for the body.

Here a $\colour{l}{\text{sphere}}$ radiates the flux $\Phi$, evenly. Its intensity is $I = \Phi/4\pi$, its radiance

$$L = \frac{\Phi}{4\pi^2 r_0^2}$$

Make it [large](?radius=0.6), [a bulb](?radius=0.05), [a pinhead](?radius=0.005). The floor does not care: a sphere above
the horizon lights it exactly as a point in its middle would. The radiance does, and goes to infinity. So a point light
has an intensity and no radiance; the slide's "infinite power density" is that.

Let the lamp [sink into the floor](?radius=0.6&light_height=0.3) and the point is wrong: what is below the horizon gives
nothing.
""",
    scene=Scene(
        glsl="""
#include "optics/area_light.glsl"
#include "optics/spherical.glsl"
#include "display/scale.glsl"
#include "display/line_label.glsl"
uniform float radius;
uniform float radiant_flux;
uniform float light_height;

vec3 lamp() {
    return vec3(0.0, 0.0, light_height);
}

vec3 surface_point(int surface, vec2 s) {
    if (surface == 0) return vec3(4.0 * s - 2.0, 0.0);
    if (surface == 1) return vec3(3.2 * s.x - 1.6, -2.36 + 0.16 * s.y, 0.0);
    return lamp() + radius * sphere_point(s.x, s.y);
}

float shown_value(vec3 p) {
    return irradiance_lamp(radiant_flux, radius, length(vec3(p.xy, light_height)), arctan2(length(p.xy), light_height));
}

vec3 shade(Surface s) {
    if (s.id == 1) return decades(pow(10.0, 3.0 * s.st.x - 1.0), -1.0, 2.0);
    if (s.id == 2) {
        float glow = clamp(0.25 * log(radiance_sphere(radiant_flux, radius)) / log(10.0), 0.0, 1.0);
        return mix(mix(palette[COLOUR_L] * 0.5, palette[COLOUR_L], min(2.0 * glow, 1.0)), vec3(1.0), max(0.0, 1.6 * glow - 0.6));
    }
    return decades(shown_value(s.position), -1.0, 2.0);
}

vec3 mark_point(int mark, float t) {
    float turn = 6.2831853 * float(mark % 6) / 6.0, fall = mark < 6 ? 1.2 : 2.3;
    return lamp() + (radius + 0.42 * t) * direction(fall, turn);
}

vec4 probe(int i) {
    if (i == 0) return vec4(lamp() + vec3(radius, 0.0, 0.0), 1.0);
    if (i == 1) return vec4(lamp(), 1.0);
    if (i == 2) return vec4(-1.6, -2.6, 0.0, 1.0);
    if (i == 3) return vec4(-0.5333, -2.6, 0.0, 1.0);
    if (i == 4) return vec4(0.5333, -2.6, 0.0, 1.0);
    if (i == 5) return vec4(1.5, -2.6, 0.0, 1.0);
    return line_label(i == 6 ? 1.0 : i == 7 ? 10.0 : 100.0, vec3(0.0), vec3(-1.9, -1.9, 0.0));
}
""",
        surfaces=(Surface("floor", cells=(2, 2)), Surface("scale", cells=(2, 1)), Surface("lamp", cells=(32, 16))),
        marks=tuple(Mark(f"intensity {i}", colour="l", tip="arrow", width=0.9) for i in range(12)),
        labels=(Label("0.1", 2), Label("1", 3), Label("10", 4), Label("100 W/m²", 5),
                Label("1", 6), Label("10", 7), Label("100", 8)),
        handles=(Handle("the lamp's rim", 0, ("radius",)), Handle("the lamp", 1, ("light_height",))),
        camera=Camera(azimuth=-80, elevation=36, distance=9.4, target=(0.0, -0.4, 0.05)),
        legend=(("l", "arrows: intensity"),),
    ),
    plot=Curves(
        title="The same flux from a smaller lamp",
        sweep="radius",
        curves=(
            Curve("radiance, W/(m² sr)", Term("radiance_sphere")),
            Curve("intensity, W/sr", Term("radiant_intensity_of", {"distribution": 0, "exponent": 1.0, "theta": 0.0}),
                  role="estimate"),
        ),
        y_label="W/(m² sr), W/sr", y_scale="log",
    ),
    readouts=(
        Readout("radiance", Term("radiance_sphere"), unit="W/(m² sr)"),
        Readout("intensity", Term("radiant_intensity_of", {"distribution": 0, "exponent": 1.0, "theta": 0.0}), unit="W/sr"),
        Readout("floor below, sphere", Term("irradiance_lamp", {"distance": "light_height", "theta": 0.0}), role="exact",
                unit="W/m²"),
        Readout("floor below, point", Term("irradiance_distribution", {
            "distribution": 0, "exponent": 1.0, "height": "light_height", "offset": 0.0}), role="estimate", unit="W/m²",
            against="floor below, sphere"),
    ),
    ask=Prediction(
        question="A sphere of 1 m radius has a radiance of 1 W/(m² sr). Shrink it to 10 cm at the same flux. Its radiance?",
        truth=Term("radiance_sphere", {"radiant_flux": 4 * PI * PI, "radius": 0.1}),
        unit="W/(m² sr)", low=0.5, high=2000.0,
        scale="log",
        sets={"radius": 0.1},
        told="100: the area is a hundredth, and the same power has to leave through it. At no size at all it is infinite.",
    ),
    notes="""
Start large and shrink slowly; ask what changes on the floor. Nothing, and half the class will not believe it: a bigger
lamp feels brighter. Then ask what you would see looking into it. Common wrong answer: the radiance of a point is its
intensity. The units already differ. End with the lamp in the floor: the exception that shows what the rule needs. 4 minutes.
""",
    sources=("Deck, slides Light Sources and Punctual Lights", "optics reference 2.3: sphere; D5: a point has no radiance"),
    honesty="Exact, for a Lambert sphere. The lamp's own colour only hints at its radiance. No shadows: local shading.",
    values=(Value("radius", 0.25, low=0.005, high=0.6), Value("radiant_flux", 150.0),
            Value("light_height", 0.8, low=0.1, high=2.0)), minutes=4,
)

POSITIONAL = Step(
    name="positional",
    title="Positional lights",
    idea="A positional light arrives along l = (p - x)/|p - x| and gives I cos θ / r².",
    slides=("Punctual Lights - Positional",),
    prose=r"""
The light has a position $p_L$. Every shaded point $x$ looks for it anew:

$$\colour{l}{l} = \frac{p_L - x}{|p_L - x|}, \qquad E = I\,\frac{\colour{n}{n}\cdot\colour{l}{l}}{r^2}$$

Drag the light. The colours are the floor's irradiance; each line is a factor of ten.

Bring it [close](?distance=0.1&theta=20), then [closer](?distance=0.03&theta=20). At $r \to 0$ the formula goes to infinity,
and no lamp does: inside its own radius $r_0$ it is no point. So we stop there, with $\max(r, r_0)$. Game engines add a
window instead, which ends the light at a [reach](?reach=1.5) and saves the work beyond.

[Below the floor](?theta=120) $n\cdot l$ is negative. The light still arrives (hatched), but from behind: nothing.
""",
    scene=Scene(
        glsl="""
#include "optics/punctual.glsl"
#include "optics/spherical.glsl"
#include "display/scale.glsl"
#include "display/line_label.glsl"
uniform float distance;
uniform float theta;
uniform float phi;
uniform float radiant_intensity;
uniform float source_radius;

vec3 light() {
    return distance * direction(theta, phi);
}

vec3 surface_point(int surface, vec2 s) {
    if (surface == 0) return vec3(4.0 * s - 2.0, 0.0);
    if (surface == 1) return vec3(4.0 * s.x - 2.0, 2.0, 1.6 * s.y);
    return vec3(3.2 * s.x - 1.6, -2.36 + 0.16 * s.y, 0.0);
}

float shown_value(vec3 p) {
    return irradiance_at(p, vec3(0.0, 0.0, 1.0), light(), radiant_intensity, source_radius);
}

vec3 shade(Surface s) {
    if (s.id == 2) return decades(pow(10.0, 4.0 * s.st.x - 1.0), -1.0, 3.0);
    vec3 n = s.id == 0 ? vec3(0.0, 0.0, 1.0) : vec3(0.0, -1.0, 0.0), way = light() - s.position;
    float found = irradiance_at(s.position, n, light(), radiant_intensity, source_radius);
    if (!(found >= 0.0)) return vec3(found); // the stage draws and counts it
    vec3 lit = decades(found, -1.0, 3.0);
    // Hatched: light arrives from behind. The stripes have the colour of what a surface would get that faced it.
    float at = 6.0 * (s.position.x + s.position.y + s.position.z), wide = fwidth(at);
    float stripe = dot(n, way) < 0.0 ? 1.0 - smoothstep(0.2, 0.2 + wide, abs(fract(at) - 0.5)) : 0.0;
    return mix(lit, decades(radiant_intensity / max(dot(way, way), source_radius * source_radius), -1.0, 3.0), 0.75 * stripe);
}

vec3 mark_point(int mark, float t) {
    if (mark == 0) return light() * t;
    if (mark == 1) return vec3(0.0, 0.0, 0.9 * t);
    if (mark == 2) return direction_to_light(vec3(0.0), light()) * 0.8 * t;
    if (mark == 3) return vec3(light().xy, light().z * (1.0 - t));
    return light() + source_radius * vec3(cos(6.2831853 * t), sin(6.2831853 * t), 0.0);
}

vec4 probe(int i) {
    if (i == 0) return vec4(light(), 1.0);
    if (i == 1) return vec4(0.6 * light(), 1.0);
    if (i == 2) return vec4(-1.6, -2.6, 0.0, 1.0);
    if (i == 3) return vec4(-0.8, -2.6, 0.0, 1.0);
    if (i == 4) return vec4(0.0, -2.6, 0.0, 1.0);
    if (i == 5) return vec4(0.8, -2.6, 0.0, 1.0);
    if (i == 6) return vec4(1.5, -2.6, 0.0, 1.0);
    vec3 foot = vec3(clamp(light().xy, vec2(-1.9), vec2(1.9)), 0.0);
    return line_label(i == 7 ? 1.0 : i == 8 ? 10.0 : i == 9 ? 100.0 : 1000.0, foot, vec3(-1.9, -1.9, 0.0));
}
""",
        surfaces=(Surface("floor", cells=(2, 2)), Surface("wall", cells=(2, 2)), Surface("scale", cells=(2, 1))),
        marks=(
            Mark("way", colour="quiet", line="dashed", label="r", label_at=0.62),
            Mark("normal", colour="n", tip="arrow", label="n"),
            Mark("to the light", colour="l", tip="arrow", width=1.4, label="l"),
            Mark("plumb line", colour="quiet", line="dotted", width=0.7),
            Mark("the light", colour="l", tip="sun", segments=32, width=1.2),
        ),
        labels=(Label("0.1", 2), Label("1", 3), Label("10", 4), Label("100", 5), Label("1000 W/m²", 6),
                Label("1", 7), Label("10", 8), Label("100", 9), Label("1000", 10)),
        handles=(Handle("the light", 0, ("theta", "phi")), Handle("its distance", 1, ("distance",))),
        camera=Camera(azimuth=-78, elevation=34, distance=10.0, target=(0.0, -0.2, 0.3)),
    ),
    plot=Curves(
        title="Irradiance at x against distance",
        sweep="distance",
        curves=(
            Curve("I cos θ / r²", Term("irradiance_positional", {"source_radius": 0.0})),
            Curve("facing the light", Term("irradiance_positional", {"source_radius": 0.0, "theta": 0.0})),
            Curve("r not below r₀", Term("irradiance_positional"), role="estimate"),
            Curve("windowed (Karis)", Term("irradiance_windowed"), role="printed"),
        ),
        y_label="W/m²", y_scale="log",
    ),
    readouts=(
        Readout("I cos θ / r²", Term("irradiance_positional", {"source_radius": 0.0}), role="exact", unit="W/m²"),
        Readout("stopped at radius", Term("irradiance_positional"), role="estimate", unit="W/m²", against="I cos θ / r²"),
        Readout("windowed", Term("irradiance_windowed"), role="printed", unit="W/m²", against="I cos θ / r²"),
    ),
    ask=Prediction(
        question="A lamp of 1 W/sr hangs 1 m over the table, which gets 1 W/m². Lower it to 10 cm. What does it get now?",
        truth=Term("irradiance_positional", {"radiant_intensity": 1.0, "distance": 0.1, "theta": 0.0, "source_radius": 0.001}),
        unit="W/m²", low=0.5, high=2000.0,
        scale="log",
        sets={"distance": 0.1, "theta": 0.0},
        told="100. At 1 cm 10 000, at 0 infinite, and that is where the point stops being a model of the lamp.",
    ),
    notes="""
Ask for the brightest place on the floor before you drag: below the light, since a point has no front and cannot be tilted;
a spot can, that comes later. Then lower the light: the lines of ten crowd. Ask what a shader does with 1/0, and show the
stop at the radius. The window is a lie with a purpose: at 1 m it already gives half. 5 minutes.
""",
    sources=("Deck, slide Punctual Lights - Positional", "Deck, slide Plausible Shading - Measuring Light",
             "Karis 2013, Real Shading in Unreal Engine 4", "optics reference 2.7"),
    honesty="I cos θ / r² is exact for a point; inside r₀ the value is a stop, no model. The window's 1 is one square metre.",
    values=(Value("distance", 1.5, low=0.02, high=4.0), Value("theta", 40.0, low=0.0, high=150.0),
            Value("phi", 20.0, more=True), Value("radiant_intensity", 60.0), Value("source_radius", 0.06, low=0.01, high=0.5),
            Value("reach", 6.0, low=0.5, high=10.0, more=True)), minutes=5, breaks=(Break("no stop at 0, the lamp below the floor", {"irradiance_at": "irradiance_at_naive", "irradiance_positional": "irradiance_positional_naive"}, {"theta": 140.0, "distance": 1.2}, "The cosine of a light behind the surface is negative, and so is its light: the floor turns red for less than nothing. Alone it would only be black on the screen; beside a second lamp it takes that lamp's light away. Take max(0, n·l): less light than none there is not.", "irradiance at x", Term("irradiance_positional"), "W/m²"),),
)

DIRECTIONAL = Step(
    name="directional",
    title="Directional lights",
    idea="Far away only a direction is left; the error of saying so falls with the square of the distance.",
    slides=("Punctual Lights - Directional",),
    prose=r"""
Move the $\colour{l}{\text{light}}$ away and turn it up, so that the middle of the floor keeps its irradiance. The rays
become parallel and the pattern even. At the end only a direction $\colour{l}{l}$ is left, and an irradiance $E_\perp$:

$$E = E_\perp\,\max(0,\;\colour{n}{n}\cdot\colour{l}{l})$$

What does that neglect? The floor's edge, $\rho$ aside, gets less than the middle by

$$1 - \Bigl(1+\tfrac{\rho^2}{r^2}\Bigr)^{-3/2} \approx \frac{3\rho^2}{2 r^2}$$

Try [near](?distance=0.7), [five times the half width](?distance=10), [a hundred metres](?distance=100). The Sun is
30 000 000 000 rooms of five metres away; in this room it is a direction to 21 digits.
""",
    scene=Scene(
        glsl="""
#include "optics/punctual.glsl"
#include "display/palette.glsl"
uniform float distance;
uniform float offset;

// The lamp where it is, as far as the picture reaches; then ever nearer to its upper edge.
float drawn() {
    return distance < 1.2 ? distance : 1.2 + 1.2 * (1.0 - 1.2 / distance);
}

vec3 foot(int i) {
    return vec3(0.95 * float(i) - 1.9, -0.9, 0.0);
}

vec3 surface_point(int surface, vec2 s) {
    if (surface == 0) return vec3(4.0 * s - 2.0, 0.0);
    return vec3(3.2 * s.x - 1.6, -2.36 + 0.16 * s.y, 0.0);
}

vec3 steps(float share) {
    float line = abs(fract(10.0 * share - 0.5) - 0.5) / max(fwidth(10.0 * share), 1e-6);
    return mix(colormap(share) * 0.3, colormap(share), smoothstep(0.3, 1.3, line));
}

vec3 shade(Surface s) {
    if (s.id == 1) return steps(s.st.x * 0.9999);
    return steps(min(1.0 - falloff_error(distance, length(s.position.xy)), 0.9999));
}

vec3 mark_point(int mark, float t) {
    if (mark < 5) return foot(mark) + (0.2 + 0.6 * t) * direction_to_light(foot(mark), vec3(0.0, 0.0, distance));
    if (mark == 5) return vec3(0.0, 0.0, drawn() * t);
    if (mark == 6) return vec3(offset * t, 0.0, 0.004);
    return vec3(0.0, 0.0, drawn());
}

vec4 probe(int i) {
    if (i == 0) return vec4(0.0, 0.0, drawn(), 1.0);
    if (i == 1) return vec4(offset, 0.0, 0.0, 1.0);
    if (i == 2) return vec4(-1.6, -2.6, 0.0, 1.0);
    if (i == 3) return vec4(0.0, -2.6, 0.0, 1.0);
    return vec4(1.5, -2.6, 0.0, 1.0);
}
""",
        surfaces=(Surface("floor", cells=(2, 2)), Surface("scale", cells=(2, 1))),
        marks=(
            *(Mark(f"ray {i}", colour="l", tip="arrow", width=1.2) for i in range(5)),
            Mark("way", colour="quiet", line="dashed", label="r", label_at=0.5),
            Mark("aside", colour="exact", tip="dot", label="ρ", label_at=0.5),
            Mark("the light", colour="l", tip="sun", width=1.2),
        ),
        labels=(Label("none", 2), Label("half", 3), Label("as the middle", 4)),
        handles=(Handle("the light", 0, ("distance",)), Handle("the place aside", 1, ("offset",))),
        camera=Camera(azimuth=-82, elevation=33, distance=9.4, target=(0.0, -0.2, 0.45)),
    ),
    plot=Curves(
        title="How much less at ρ than in the middle",
        sweep="distance",
        curves=(
            Curve("1 - cos³", Term("falloff_error")),
            Curve("3/2 (ρ/r)²", Term("falloff_error_far"), role="estimate"),
        ),
        y_label="share lost", y_scale="log",
    ),
    readouts=(
        Readout("less at ρ", Term("falloff_error"), role="exact", unit=""),
        Readout("3/2 (ρ/r)²", Term("falloff_error_far"), role="estimate", unit="", against="less at ρ"),
    ),
    ask=Prediction(
        question="A lamp 5 m over the middle of a floor. By which share is it darker 2 m to the side?",
        truth=Term("falloff_error", {"distance": 5.0, "offset": 2.0}),
        unit="of it", low=0.0, high=0.6,
        sets={"distance": 5.0, "offset": 2.0},
        told="0.20: a fifth. Two thirds of that come from the longer way, one third from the slant.",
    ),
    notes="""
Ask first: how far is the Sun, in rooms? Then move the lamp out and let the class say when it looks parallel; most say at
five metres, where the corner has lost a fifth and more. The eye forgives even light easily. A directional light has no
intensity: that would be infinite. It has what a facing surface gets. 4 minutes.
""",
    sources=("Deck, slide Punctual Lights - Directional", "Deck, slide Punctual Lights (distant compared to world scale)"),
    honesty="Exact. From 1.2 m on the lamp is drawn nearer than it is, so that it stays in the picture; its rays are true.",
    values=(Value("distance", 1.1, low=0.5, high=100.0), Value("offset", 1.8, low=0.1, high=2.0)), minutes=4,
)

DISTRIBUTION = Step(
    name="distribution",
    title="Not the same in all directions",
    idea="A lamp's distribution says which share of its flux goes where: with equal flux, narrower means stronger.",
    slides=("Lighting Distribution (1)", "Lighting Distribution (2)", "Lighting Distribution (3)"),
    prose=r"""
Real lamps prefer some directions. Their **distribution** $f_e(\omega)$ is the share of the flux that goes there, per
steradian:

$$I(\omega) = \Phi\, f_e(\omega), \qquad \int f_e \, d\omega = 1$$

The body around the lamp is its *photometric solid*: as far out as the intensity in that direction. Floor and wall show
what arrives.

[Constant](?distribution=0): $1/4\pi$ everywhere. [Cosine](?distribution=1), a flat lamp: $\cos\theta/\pi$. A
[reflector](?distribution=2&exponent=6): $\frac{n+1}{2\pi}\cos^n\theta$. The constants are the integrals, so the flux stays
while you turn the exponent: the solid grows longer as it grows thinner. Its volume is not the flux.

[No flux](?radiant_flux=0), no light. [Negative](?radiant_flux=-30) flux takes light away: red dots, never hidden.
""",
    scene=Scene(
        glsl="""
#include "optics/distribution.glsl"
#include "optics/punctual.glsl"
#include "core/angle.glsl"
#include "display/look.glsl"
#include "display/scale.glsl"
#include "display/line_label.glsl"
uniform int distribution;
uniform float exponent;
uniform float radiant_flux;
uniform float light_height;

vec3 lamp() {
    return vec3(0.0, 0.9, light_height);
}

vec3 surface_point(int surface, vec2 s) {
    if (surface == 0) return vec3(4.0 * s - 2.0, 0.0);
    if (surface == 1) return vec3(4.0 * s.x - 2.0, 2.0, 2.2 * s.y);
    if (surface == 2) return vec3(3.2 * s.x - 1.6, -2.36 + 0.16 * s.y, 0.0);
    return lamp() + 0.55 * photometric_solid(distribution, exponent, s.x, s.y);
}

float shown_value(vec3 p) {
    vec3 way = lamp() - p;
    float intensity = radiant_intensity_of(radiant_flux, distribution, exponent, arctan2(length(way.xy), way.z));
    return irradiance_at(p, p.y < 2.0 ? vec3(0.0, 0.0, 1.0) : vec3(0.0, -1.0, 0.0), lamp(), intensity, 1e-3);
}

vec3 shade(Surface s) {
    if (s.id == 2) return decades(pow(10.0, 3.0 * s.st.x - 1.0), -1.0, 2.0);
    if (s.id == 3) return soft_light(palette[COLOUR_L], s.normal, s.v);
    float found = shown_value(s.id == 0 ? vec3(s.position.xy, 0.0) - vec3(0.0, 1e-5, 0.0) : vec3(s.position.x, 2.0, s.position.z));
    return found < 0.0 ? vec3(-1.0) : decades(found, -1.0, 2.0); // the stage draws and counts what is negative
}

vec3 mark_point(int mark, float t) {
    return lamp() - vec3(0.0, 0.0, light_height * t);
}

vec4 probe(int i) {
    if (i == 0) return vec4(lamp(), 1.0);
    if (i == 1) return vec4(lamp() + 0.55 * photometric_solid(distribution, exponent, 0.0, 0.0), 1.0);
    if (i == 2) return vec4(-1.6, -2.6, 0.0, 1.0);
    if (i == 3) return vec4(-0.5333, -2.6, 0.0, 1.0);
    if (i == 4) return vec4(0.5333, -2.6, 0.0, 1.0);
    if (i == 5) return vec4(1.5, -2.6, 0.0, 1.0);
    return line_label(i == 6 ? 1.0 : 10.0, vec3(0.0, 0.9, 0.0), vec3(-1.9, -1.9, 0.0));
}
""",
        surfaces=(Surface("floor", cells=(2, 2)), Surface("wall", cells=(2, 2)), Surface("scale", cells=(2, 1)),
                  Surface("photometric solid", cells=(64, 96), opacity=0.8)),
        marks=(Mark("axis", colour="quiet", line="dashed"),),
        labels=(Label("0.1", 2), Label("1", 3), Label("10", 4), Label("100 W/m²", 5), Label("1", 6), Label("10", 7)),
        handles=(Handle("the lamp", 0, ("light_height",)), Handle("the peak", 1, ("exponent",))),
        negative={"radiant_flux": (-50.0, -1e-9)}, camera=Camera(azimuth=-76, elevation=27, distance=10.2, target=(0.0, -0.2, 0.5)),
    ),
    plot=Figure(
        title="Photometric solid, 2 m for 1/sr",
        sheets=(Sheet("the lamp's distribution", Term("photometric_solid"), colour="l", cells=(64, 128)),),
        camera=Camera(azimuth=-60, elevation=10, distance=5.6, target=(0.0, 0.0, -0.95)),
    ),
    readouts=(
        Readout("peak intensity", Term("radiant_intensity_of", {"theta": 0.0}), role="exact", unit="W/sr"),
        Readout("floor below", Term("irradiance_distribution", {"height": "light_height", "offset": 0.0}), role="exact",
                unit="W/m²"),
        Readout("1.5 m aside", Term("irradiance_distribution", {"height": "light_height", "offset": 1.5}), role="exact",
                unit="W/m²"),
    ),
    ask=Prediction(
        question="A flat lamp (cosine) has 1 W/sr on its axis. Narrow it to cos⁴ at the same flux. What is its peak?",
        truth=Term("radiant_intensity_of", {"radiant_flux": PI, "distribution": 2, "exponent": 4.0, "theta": 0.0}),
        unit="W/sr", low=0.2, high=6.0,
        sets={"distribution": 2, "exponent": 4.0},
        told="2.5 W/sr: (n + 1)/2 times as much. The flux of cosⁿ is 2π I/(n + 1).",
    ),
    notes="""
Show the constant lamp first: a small ball. Then the cosine, then the reflector. Ask what happens to the peak and to the
edge of the floor. Common wrong answer: the peak stays and the sides are cut off; that is a lamp with a hood, and it has
less flux. Ask why cos^n on a floor falls as cos^(n+3). Measured lamps are next. 5 minutes.
""",
    sources=("Deck, slides Lighting Distribution (1) to (3)", "Normalisation: integrals in closed form"),
    honesty="Exact; ideal lobes, no real lamp. In the room the solid is drawn at 1.1 m for 1/sr. Far field: a point.",
    values=(Value("distribution", 2, choices=("constant", "cosine", "cosⁿ")), Value("exponent", 3.0, low=1.0, high=6.0),
            Value("radiant_flux", 60.0, low=-50.0, high=200.0, scale="linear"), Value("light_height", 1.7, low=0.5, high=2.2)),
    minutes=5,
)

IES_LAMPS = ("down", "wall", "street", "flood", "up", "bare")
IES_FILES = ("downlight", "wall_washer", "street_light", "flood", "uplight", "bare")

IES_GLSL = """
#include "optics/ies.glsl"
#include "display/look.glsl"
#include "display/line_label.glsl"
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

float shown_value(vec3 p) {
    return ies_room_illuminance(table, height, setback, turn, aim, p.x, p.y < 0.0 ? p.y : max(p.z, 1e-6));
}

vec3 shade(Surface s) {
    if (s.id == 3) return soft_light(palette[COLOUR_L], s.normal, s.v);
    if (s.id == 2) return lux_colour(pow(10.0, DECADES * s.st.y));
    return lux_colour(shown_value(s.id == 0 ? s.position - vec3(0.0, 1e-6, 0.0) : vec3(s.position.x, 0.0, s.position.z)));
}

vec3 mark_point(int mark, float t) {
    if (mark < 2) return polar(mark == 0 ? 0.0 : 0.5 * PI, t);
    if (mark == 2) return luminaire();
    if (mark == 3) return mix(luminaire(), meter(), t);
    if (mark == 4) return meter() + 0.65 * t * (meter_s > 0.0 ? vec3(0.0, -1.0, 0.0) : vec3(0.0, 0.0, 1.0));
    return mix(luminaire(), vec3(0.0, -setback, 0.0), t);
}

vec4 probe(int i) {
    if (i == 0) return vec4(luminaire(), 1.0);
    if (i == 1) return vec4(meter(), 1.0);
    if (i < 6) return vec4(WIDE + 1.12, 0.0, HIGH * float(i - 2) / DECADES, 1.0);
    float lux = i == 6 ? 5.0 : i == 7 ? 10.0 : i == 8 ? 20.0 : i == 9 ? 50.0 : i == 10 ? 100.0 : i == 11 ? 200.0 : 500.0;
    return line_label(lux, vec3(0.0, -setback, 0.0), vec3(-0.95 * WIDE, -0.9 * DEEP, 0.0));
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
            Surface("photometric solid", cells=(72, 48), opacity=0.5),
        ),
        marks=(
            Mark("plane C0", colour="l", segments=144, width=1.2),
            Mark("plane C90", colour="l", line="dashed", segments=144),
            Mark("luminaire", colour="exact", tip="dot", width=1.4),
            Mark("to the meter", colour="l", line="dotted", width=0.9),
            Mark("normal of the meter", colour="n", tip="arrow", width=1.2, label="n"),
            Mark("drop", colour="quiet", line="dashed", width=0.7),
        ),
        labels=(Label("1 lx", 2), Label("10", 3), Label("100", 4), Label("1000", 5),
                *(Label(lux, 6 + i) for i, lux in enumerate(("5", "10", "20", "50", "100", "200", "500")))),
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
        unit="lm", low=0.0, high=6000.0,
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
    ), minutes=6,
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

SPOT = Step(
    name="spot",
    title="Spotlights",
    idea="Two cones: full inside the hotspot, nothing outside the falloff, and a clamp so that it stays nothing.",
    slides=("Light Sources - Spotlights (1)", "Light Sources - Spotlights (2)"),
    prose=r"""
A spotlight has an axis $d$ and two **half** angles: hotspot $H$, falloff $F$. With the angle $\alpha$ off its axis,
$\cos\alpha = -\colour{l}{l}\cdot d$ ($l$ goes to the lamp, $d$ away from it):

$$f = \operatorname{clamp}\Bigl(1-\frac{\cos H-\cos\alpha}{\cos H-\cos F},\,0,\,1\Bigr)$$

The slide prints three traps. It ends the falloff at a third angle, $\theta_L$, without a clamp: [as
printed](?edge=2&threshold=50&reading=0) the spot takes light away outside $F$; the dots are
$\colour{printed}{\text{negative}}$. It does not say *half*: with [full angles](?edge=0&hotspot=20&falloff=30&reading=1) in
the formula the lamp makes 3.8 times its flux. And with its sign, [$+l\cdot d$](?edge=0&reading=2), nothing before the lamp
is lit.

[Linear](?edge=0&reading=0) has a crease at both cones; [smoothstep](?edge=1&reading=0) none and, here, the same flux.
[H = F](?hotspot=30&falloff=30&edge=0) is a hard edge; [H > F](?hotspot=40&falloff=25&edge=0) too, at $F$. A
[measured downlight](?hotspot=18&falloff=30&edge=3) of the same flux has no cones.
""",
    scene=Scene(
        glsl="""
#include "optics/spot.glsl"
#include "optics/ies.glsl"
#include "optics/punctual.glsl"
#include "core/angle.glsl"
#include "display/scale.glsl"
uniform sampler2D table;
uniform float hotspot;
uniform float falloff;
uniform float threshold;
uniform float radiant_intensity;
uniform int edge;
uniform int reading;
uniform float off_axis;

const vec3 LAMP = vec3(0.0, -0.9, 1.8);
const vec3 AXIS = vec3(0.0, 0.6, -0.8);
const vec3 RIGHT = vec3(1.0, 0.0, 0.0);
const vec3 OVER = vec3(0.0, 0.8, 0.6);

vec3 ray(float angle, float turn) {
    return cos(angle) * AXIS + sin(angle) * (cos(turn) * RIGHT + sin(turn) * OVER);
}

// Floor and wall come twice, for the formula and for the measured lamp; those not chosen have no size and cost nothing.
vec3 surface_point(int surface, vec2 s) {
    if (surface < 2 && edge == 3 || surface > 4 && edge != 3) return vec3(0.0);
    if (surface == 0 || surface == 5) return vec3(4.0 * s - 2.0, 0.0);
    if (surface == 1 || surface == 6) return vec3(4.0 * s.x - 2.0, 2.0, 1.7 * s.y);
    if (surface == 2) return vec3(3.2 * s.x - 1.6, -2.36 + 0.16 * s.y, 0.0);
    return LAMP + 1.3 * s.y * ray(surface == 3 ? min(hotspot, falloff) : falloff, 6.2831853 * s.x);
}

float off_beam(vec3 p) {
    vec3 d = -direction_to_light(p, LAMP);
    return arctan2(length(cross(d, AXIS)), dot(d, AXIS));
}

vec3 shade(Surface s) {
    if (s.id == 2) return decades(pow(10.0, 3.0 * s.st.x - 1.0), -1.0, 2.0);
    if (s.id == 3) return palette[COLOUR_L];
    if (s.id == 4) return palette[COLOUR_QUIET];
    vec3 n = s.id == 0 || s.id == 5 ? vec3(0.0, 0.0, 1.0) : vec3(0.0, -1.0, 0.0);
    float angle = off_beam(s.position), share = 0.0;
    if (s.id > 4) share = ies_as_spot(table, angle, hotspot, falloff);
    else share = spot_read(angle, hotspot, falloff, threshold, edge, reading);
    if (!(share >= 0.0 && share < 1e6)) return vec3(share); // the stage draws and counts it
    return decades(irradiance_at(s.position, n, LAMP, radiant_intensity * share, 0.01), -1.0, 2.0);
}

vec3 mark_point(int mark, float t) {
    if (mark == 0) return LAMP + 1.6 * t * AXIS;
    if (mark == 1) return LAMP + 1.3 * ray(min(hotspot, falloff), 6.2831853 * t);
    if (mark == 2) return LAMP + 1.3 * ray(falloff, 6.2831853 * t);
    if (mark == 3) return LAMP + 1.5 * t * ray(off_axis, 3.14159);
    return LAMP;
}

vec4 probe(int i) {
    if (i == 0) return vec4(LAMP + 1.3 * ray(min(hotspot, falloff), 0.0), 1.0);
    if (i == 1) return vec4(LAMP + 1.3 * ray(falloff, 0.0), 1.0);
    if (i == 2) return vec4(-1.6, -2.6, 0.0, 1.0);
    if (i == 3) return vec4(-0.5333, -2.6, 0.0, 1.0);
    if (i == 4) return vec4(0.5333, -2.6, 0.0, 1.0);
    if (i == 5) return vec4(1.5, -2.6, 0.0, 1.0);
    return vec4(LAMP + 1.5 * ray(off_axis, 3.14159), 1.0);
}
""",
        surfaces=(Surface("floor", cells=(2, 2)), Surface("wall", cells=(2, 2)), Surface("scale", cells=(2, 1)),
                  Surface("hotspot", cells=(96, 1), opacity=0.4), Surface("falloff", cells=(96, 1), opacity=0.22),
                  Surface("floor, measured lamp", cells=(2, 2)), Surface("wall, measured lamp", cells=(2, 2))),
        marks=(
            Mark("axis", colour="exact", tip="arrow", label="d"),
            Mark("hotspot rim", colour="l", segments=64, width=1.4, label="H", label_at=0.0),
            Mark("falloff rim", colour="exact", line="dashed", segments=64, label="F", label_at=0.0),
            Mark("ray", colour="quiet", line="dotted", tip="dot", label="α"),
            Mark("the lamp", colour="l", tip="sun", width=1.1),
        ),
        labels=(Label("0.1", 2), Label("1", 3), Label("10", 4), Label("100 W/m²", 5)),
        handles=(Handle("the hotspot", 0, ("hotspot",)), Handle("the falloff", 1, ("falloff",)),
                 Handle("a ray", 6, ("off_axis",))),
        negative={"edge": (2, 2)}, camera=Camera(azimuth=-74, elevation=32, distance=10.0, target=(0.0, -0.2, 0.3)),
        legend=(("printed", "dots: negative light"),), tables=(Table("table", ("downlight",)),),
    ),
    plot=Curves(
        title="Across the beam",
        sweep="off_axis",
        curves=(
            Curve("linear, clamped", Term("spot_linear")),
            Curve("smoothstep", Term("spot_smooth"), role="estimate"),
            Curve("as printed", Term("spot_as_printed"), role="printed"),
            Curve("as read", Term("spot_read"), role="printed"),
            Curve("IES, same flux", Term("ies_as_spot"), role="estimate"),
        ),
        y_label="share of I",
    ),
    readouts=(
        Readout("flux", Term("spot_flux"), role="exact", unit="W"),
        Readout("flux as read", Term("spot_read_flux"), role="printed", unit="W", against="flux"),
        Readout("share at α", Term("spot_linear"), role="exact", unit=""),
        Readout("as read at α", Term("spot_read"), role="printed", unit="", against="share at α"),
    ),
    ask=Prediction(
        question="Hotspot 20°, falloff 30°, 100 W/sr: 61 W. A program reads the angles as full ones. What flux does it make?",
        truth=Term("spot_flux", {"radiant_intensity": 100.0, "hotspot": 10 * PI / 180, "falloff": 15 * PI / 180}),
        unit="W", low=0.0, high=122.0,
        sets={"hotspot": 20.0, "falloff": 30.0, "edge": 0, "reading": 0},
        told="15.5 W: a quarter. A cone grows with the square of its angle; file formats differ in which half they mean.",
    ),
    notes="""
Let the class read the slide's formula and find the undefined angle. Then switch to it: the ring of dots takes light away
from other lamps. Then full angles: 61 W become 231. Then the sign: l goes to the lamp and d away from it, so +l.d lights
what is behind the lamp, and nothing here. Drag falloff onto hotspot: 0/0 on the
slide, a hard edge here. The flux is closed: 2 pi I (sin²(H/2) + sin²(F/2)). Last, the downlight: the same watts, half the middle; ask
where the rest went. 6 minutes.
""",
    sources=("Deck, slides Light Sources - Spotlights (1) and (2)", "optics reference 2.7 and D4",
             "The downlight's file is made for this course (lessons/ies)"),
    honesty="Exact for the formula; no real lamp dims linearly in the cosine. In our copy θ_L may have been cos F.",
    values=(Value("hotspot", 18.0, low=1.0, high=58.0), Value("falloff", 30.0, low=2.0, high=60.0),
            Value("edge", 0, choices=("linear", "smooth", "printed", "IES")),
            Value("reading", 0, choices=("meant", "full", "sign")),
            Value("threshold", 50.0, low=2.0, high=80.0, more=True), Value("off_axis", 25.0, low=0.0, high=60.0, more=True),
            Value("radiant_intensity", 100.0, more=True)), minutes=6, breaks=(Break("a hotspot wider than its falloff", {"spot_linear": "spot_linear_naive"}, {"hotspot": 32.0, "falloff": 20.0, "edge": 0, "reading": 0, "off_axis": 10.0}, "Two sliders that may pass each other, and nobody asked. The divisor cos H − cos F changes its sign, and the lamp lights the whole room except its beam; where both are one it divides 0 by 0. A formula with an order in it has to check that order.", "share at α", Term("spot_linear")),),
)

LIGHT_GLSL = """
uniform int light_shape;
uniform float light_x;
uniform float light_y;
uniform float light_height;
uniform float panel_width;
uniform float panel_depth;
uniform float panel_tilt;

vec3 middle() { return vec3(light_x, light_y, light_height); }
float tilt() { return light_shape == 1 ? 0.0 : panel_tilt; }

// Around the light with s.x; from its middle to its rim, of a sphere from pole to pole, with s.y.
vec3 lamp_point(vec2 s) {
    if (light_shape == 2) return middle() + 0.5 * panel_width * sphere_point(s.x, s.y);
    int corners = light_shape == 0 ? 4 : 5, i = int(floor(float(corners) * s.x * 0.99999));
    vec2 rim = mix(outline_at(corners, i), outline_at(corners, i + 1), float(corners) * s.x - float(i)) - 0.5;
    if (light_shape == 1) rim = 0.5 * vec2(cos(6.2831853 * s.x), sin(6.2831853 * s.x));
    rim = s.y * rim + 0.5;
    return panel_point(light_x, light_y, light_height, panel_width, light_shape == 1 ? panel_width : panel_depth, tilt(), rim.x, rim.y);
}

vec3 rim_point(float t) {
    return lamp_point(vec2(t, light_shape == 2 ? 0.5 : 1.0));
}

vec3 lamp_colour(Surface s) {
    if (light_shape == 2) return mix(palette[COLOUR_L], vec3(1.0), 0.2 + 0.5 * max(dot(s.v, s.normal), 0.0));
    return dot(s.v, vec3(0.0, sin(tilt()), -cos(tilt()))) > 0.0 ? mix(palette[COLOUR_L], vec3(1.0), 0.55) : palette[COLOUR_QUIET] * 0.6;
}
"""
SAMPLES_GLSL = LIGHT_GLSL + """
uniform float radiance;
uniform int sampling;
uniform int level;
uniform int seed;
uniform vec3 position;

float exact(vec3 p) {
    return irradiance_light(light_shape, radiance, light_x, light_y, light_height, panel_width, panel_depth, panel_tilt, p);
}

float sampled(vec3 p, int own) {
    return irradiance_light_sampled(light_shape, radiance, light_x, light_y, light_height, panel_width, panel_depth, panel_tilt, p, sampling, level, own);
}

vec4 piece(int i) {
    return light_piece(light_shape, light_x, light_y, light_height, panel_width, panel_depth, panel_tilt, position, sampling, level, seed, i);
}

vec3 dot_point(int i) {
    vec3 way = piece(i).xyz;
    return position + way * max(1.0 - 0.008 / length(way), 0.0); // a little before the light
}

vec4 dot_colour(int i) {
    return vec4(piece(i).w > 0.0 ? palette[COLOUR_R] : palette[COLOUR_QUIET], i < (1 << (2 * level)) ? 1.0 : 0.0);
}
"""
SHAPES = ("panel", "disk", "sphere", "polygon")
RIM = Mark("rim", colour="l", segments=60, width=1.2)
AT_POINT = {"position": (0.0, 0.0, 0.0)}

AREA_UNITS = Step(
    name="area_units",
    title="One light, three numbers",
    idea="An area light's flux, exitance and radiance follow from each other by its area and by π.",
    slides=("Area Lights",),
    prose=r"""
A data sheet gives a lamp's **flux** $\Phi$. What leaves each square metre is its **exitance** $M$. A renderer wants the
**radiance** $\colour{l}{L}$. For a light that looks alike from every side they are one number:

$$\Phi = M A, \qquad M = \pi L$$

$\pi$ is the cosine's doing, as in chapter 2. $A$ is what radiates: one side of a flat light, all around a sphere.

Which of the three is given decides what a resize means. Give the flux: [wide](?given=0&amount=60&panel_width=1.6) or
[small](?given=0&amount=60&panel_width=0.3), the far floor hardly notices, but the small one dazzles. Give the radiance:
[wide](?given=2&amount=20&panel_width=1.6) or [small](?given=2&amount=20&panel_width=0.3), it looks the same and its floor goes
dark. [No area](?given=0&amount=60&panel_width=0) at all has no radiance: a point light. A [sphere](?light_shape=2) shares its flux
among four times a disk's area.
""",
    scene=Scene(
        glsl="""
#include "optics/light_shape.glsl"
#include "optics/spherical.glsl"
#include "display/scale.glsl"
#include "display/line_label.glsl"
uniform int given;
uniform float amount;
""" + LIGHT_GLSL + """
vec3 surface_point(int surface, vec2 s) {
    if (surface == 0) return vec3(4.0 * s - 2.0, 0.0);
    if (surface == 1) return vec3(3.2 * s.x - 1.6, -2.36 + 0.16 * s.y, 0.0);
    return lamp_point(s);
}

float radiance() {
    return light_radiance(given, amount, light_shape, panel_width, panel_depth);
}

float shown_value(vec3 p) {
    if (panel_width * panel_depth == 0.0) return 0.0; // without an area there is no radiance: the floor stays dark
    return irradiance_light(light_shape, radiance(), light_x, light_y, light_height, panel_width, panel_depth, panel_tilt, p);
}

vec3 shade(Surface s) {
    if (s.id == 1) return decades(pow(10.0, 3.0 * s.st.x - 1.0), -1.0, 2.0);
    if (s.id == 2) {
        float glow = clamp(0.3 * log(max(radiance(), 1e-3)) / log(10.0), 0.0, 1.0);
        return lamp_colour(s) * mix(0.25, 1.0, min(2.0 * glow, 1.0)) + vec3(max(glow - 0.5, 0.0));
    }
    return decades(shown_value(s.position), -1.0, 2.0);
}

vec3 mark_point(int mark, float t) {
    if (mark == 0) return rim_point(t);
    return vec3(middle().xy, middle().z * (1.0 - t));
}

vec4 probe(int i) {
    if (i == 0) return vec4(middle(), 1.0);
    if (i == 1) return vec4(middle() + vec3(0.5 * panel_width, 0.0, 0.0), 1.0);
    if (i > 5) return line_label(i == 6 ? 1.0 : i == 7 ? 10.0 : 100.0, vec3(light_x, light_y - 0.3, 0.0), vec3(-1.9, -1.9, 0.0));
    return vec4(i == 2 ? -1.6 : i == 3 ? -0.5333 : i == 4 ? 0.5333 : 1.5, -2.6, 0.0, 1.0);
}
""",
        surfaces=(Surface("floor", cells=(2, 2)), Surface("scale", cells=(2, 1)), Surface("light", cells=(60, 16))),
        marks=(RIM, Mark("plumb line", colour="quiet", line="dotted", tip="dot", width=0.8)),
        labels=(Label("0.1", 2), Label("1", 3), Label("10", 4), Label("100 W/m²", 5),
                Label("1", 6), Label("10", 7), Label("100", 8)),
        handles=(Handle("the light", 0, ("light_height",)), Handle("its rim", 1, ("panel_width",))),
        camera=Camera(azimuth=-80, elevation=30, distance=8.9, target=(0.0, -0.3, 0.25)),
        decided=("light_shape",),
    ),
    plot=Ledger(
        title="Give one, get the others",
        columns=((
            LedgerRow("flux Φ", Term("light_flux"), "W"),
            LedgerRow("exitance M", Term("light_exitance"), "W/m^2", "1/m^2", "its area"),
            LedgerRow("radiance L", Term("light_radiance"), "W/(m^2 sr)", "1/sr", "π, by the cosine"),
            LedgerRow("irradiance E below", Term("light_irradiance_below"), "W/m^2", "sr", "its projected solid angle"),
        ),),
    ),
    readouts=(
        Readout("flux", Term("light_flux"), unit="W"),
        Readout("exitance", Term("light_exitance"), unit="W/m²"),
        Readout("radiance", Term("light_radiance"), unit="W/(m² sr)"),
        Readout("floor below", Term("light_irradiance_below"), role="exact", unit="W/m²", absent="no area, no number"),
    ),
    ask=Prediction(
        question="A panel of half a square metre radiates 50 W. What is its radiance?",
        truth=Term("light_radiance", {"given": 0, "amount": 50.0, "light_shape": 0, "panel_width": 1.0, "panel_depth": 0.5}),
        unit="W/(m² sr)", low=1.0, high=300.0,
        scale="log",
        sets={"given": 0, "amount": 50.0, "light_shape": 0, "panel_width": 1.0, "panel_depth": 0.5},
        told="31.8: each square metre sends out 100 W, and π times the radiance is what leaves it.",
    ),
    notes="""
Ask what a slider called "brightness" in a modeller should mean when the lamp is scaled; the class will split, and both
halves are right. Show it: given flux, then given radiance. Common wrong answers: 100, which is the exitance, and 15.9, half:
the hemisphere has 2π sr, but its cosine-weighted sum is π. Last, the sphere: four times a disk's area, and it lights in all
directions. 4 minutes.
""",
    sources=("Deck, slides Area Lights and Basic Radiometric Quantities (3)", "optics reference 2.3 and 5"),
    honesty="Exact for lights that look alike from everywhere (Lambert); real panels often do not. The lamp's colour only hints at "
            "its radiance. The disk always looks down.",
    values=(Value("given", 0, choices=("flux", "exitance", "radiance")), Value("amount", 60.0, low=1.0),
            Value("light_shape", 0, choices=SHAPES), Value("panel_width", 1.0, low=0.0, high=2.0, scale="linear"),
            Value("panel_depth", 0.8, low=0.1, high=2.0, more=True), Value("light_height", 0.9, low=0.3, high=2.0, more=True),
            Value("panel_tilt", -50.0, low=-60.0, high=60.0, more=True), Value("light_x", 0.0, low=-1.0, high=1.0, more=True),
            Value("light_y", 0.7, low=-1.0, high=1.0, more=True)),
    minutes=4, breaks=(Break("1 − almost 1, a lamp of 2 mm", {"projected_solid_angle_disk": "projected_solid_angle_disk_naive"}, {"light_shape": 1, "given": 0, "panel_width": 0.002, "light_height": 1.5}, "The lamp fills a millionth of the view, and the textbook takes that from 1 less almost 1. The rest is rounding, and a small, bright lamp multiplies it: black rings and sparks. A small lamp far away asks for a form without that difference.", "floor 0.8 m aside, L = 1", Term("projected_solid_angle_disk", {"radius": 0.001, "height": 1.5, "offset": 0.8}), "W/m²"),),
)

AREA_SAMPLED = Step(
    name="area_sampled",
    title="Area lights, sample by sample",
    idea="Cut the light into punctual pieces, give each its share with both cosines, and change the cut at every pixel.",
    slides=("Area Lights", "Light Contribution of Area Lights (1)", "Light Contribution of Area Lights (2)"),
    prose=r"""
There are no punctual lights. A light of radiance $L$ becomes $N$ points $\colour{l}{y_i}$, each a small lamp with a
piece of the area $A$:

$$E \approx \frac{A}{N}\sum_i L\,\frac{\cos\theta_i\,\cos\theta'_i}{r_i^2}$$

$\theta_i$ at the floor, $\theta'_i$ at the light, which shines less sideways: that second cosine is often forgotten.
[Panel](?light_shape=0), [disk](?light_shape=1), [sphere](?light_shape=2), [polygon](?light_shape=3): only the places of
the points differ. Of a sphere they share the cap that $x$ sees.

Left: the floor as sampled. Right: its error. [One sample](?level=0&sampling=0), [four](?level=1&sampling=2),
[sixty-four](?level=3&sampling=2). The [same samples everywhere](?pattern=1&sampling=2&level=1) make patterns; new ones
at each pixel make noise, which the eye forgives. [Random](?sampling=1&level=2&pattern=0) points clump;
[Sobol](?sampling=3&level=2&pattern=0) points keep apart.
""",
    scene=Scene(
        glsl="""
#include "optics/shape_samples.glsl"
#include "optics/spherical.glsl"
#include "display/scale.glsl"
""" + SAMPLES_GLSL + """
uniform int pattern;

vec3 surface_point(int surface, vec2 s) {
    if (surface == 0) return vec3(2.0 * s.x - 2.0, 4.0 * s.y - 2.0, 0.0);
    if (surface == 1) return vec3(2.0 * s.x, 4.0 * s.y - 2.0, 0.0);
    if (surface == 2) return vec3(1.8 * s.x - 1.95, -2.36 + 0.16 * s.y, 0.0);
    if (surface == 3) return vec3(1.8 * s.x + 0.15, -2.36 + 0.16 * s.y, 0.0);
    return lamp_point(s);
}

vec3 shade(Surface s) {
    if (s.id == 2) return decades(pow(10.0, 3.0 * s.st.x - 1.5), -1.5, 1.5);
    if (s.id == 3) return diverging(2.0 * s.st.x - 1.0);
    if (s.id == 4) return lamp_colour(s);
    int own = pattern == 0 ? int(gl_FragCoord.x) + 8192 * int(gl_FragCoord.y) : seed;
    float found = sampled(s.position, own);
    if (s.id == 0) return decade_colour(found, -1.5, 1.5);
    float right = exact(s.position);
    return diverging(right > 0.0 ? 2.0 * (found - right) / right : 0.0);
}

vec3 mark_point(int mark, float t) {
    if (mark == 0) return rim_point(t);
    if (mark == 1) return position + vec3(0.0, 0.0, 0.5 * t);
    return position + t * piece((mark - 2) % (1 << (2 * level))).xyz;
}

vec4 probe(int i) {
    if (i == 0) return vec4(middle(), 1.0);
    if (i == 1) return vec4(panel_point(light_x, light_y, light_height, panel_width, panel_depth, panel_tilt, 0.5, 1.0), 1.0);
    if (i == 2) return vec4(-1.86, -2.62, 0.0, 1.0);
    if (i == 3) return vec4(-0.5, -2.62, 0.0, 1.0);
    if (i == 4) return vec4(0.28, -2.62, 0.0, 1.0);
    if (i == 5) return vec4(1.05, -2.62, 0.0, 1.0);
    if (i == 6) return vec4(1.8, -2.62, 0.0, 1.0);
    return vec4(position, 1.0);
}
""",
        surfaces=(Surface("floor, sampled", cells=(2, 2)), Surface("floor, error", cells=(2, 2)),
                  Surface("scale", cells=(2, 1)), Surface("error scale", cells=(2, 1)), Surface("light", cells=(60, 16))),
        marks=(RIM, Mark("normal", colour="n", tip="arrow", label="n", label_at=0.6),
               *(Mark(f"sample {i}", colour="l", line="dashed", width=0.7) for i in range(4))),
        dots=Dots(256, size=0.9),
        decided=("light_shape", "sampling"),
        labels=(Label("0.03", 2), Label("10 W/m²", 3), Label("-50 %", 4), Label("0", 5), Label("+50 %", 6)),
        handles=(Handle("the light", 0, ("light_x", "light_height")), Handle("its tilt", 1, ("panel_tilt",)),
                 Handle("the point", 7, ("position",))),
        camera=Camera(azimuth=-84, elevation=38, distance=9.6, target=(0.0, -0.4, 0.0)),
    ),
    plot=Curves(
        title="Error at x against samples",
        sweep="level",
        curves=(
            Curve("exact", Term("irradiance_light")),
            Curve("these samples", Term("irradiance_light_sampled"), role="estimate", precision="float32"),
            Curve("without cos θ′", Term("irradiance_light_without_cosine"), role="printed", precision="float32"),
        ),
        y_label="relative error", y_scale="log",
        error=True,
    ),
    readouts=(
        Readout("flux of a sample", Term("sample_flux"), unit="W"),
        Readout("exact at x", Term("irradiance_light"), role="exact", unit="W/m²"),
        Readout("these samples", Term("irradiance_light_sampled"), role="estimate", unit="W/m²", against="exact at x"),
        Readout("without cos θ′", Term("irradiance_light_without_cosine"), role="printed", unit="W/m²",
                against="exact at x"),
    ),
    ask=Prediction(
        question="A panel of 2 m by 2 m hangs half a metre over the floor, which gets 26 W/m² in the middle. One sample in "
                 "the panel's centre says?",
        truth=Term("irradiance_light_sampled", {
            "light_shape": 0, "radiance": 10.0, "light_x": 0.0, "light_y": 0.0, "light_height": 0.5, "panel_width": 2.0,
            "panel_depth": 2.0, "panel_tilt": 0.0, "position": (0.0, 0.0, 0.0), "sampling": 0, "level": 0, "seed": 0}),
        unit="W/m²", low=0.0, high=250.0,
        sets={"light_shape": 0, "level": 0, "sampling": 0},
        told="160, six times too much: it puts the whole panel at the nearest place. Five times the panel's size away it is right.",
    ),
    notes="""
Begin with one sample: a hard bright spot near the panel. Four and sixty-four: ask how much better before you press. Random
samples halve the error for four times the work, stratified ones quarter it. Then "the same everywhere": the banding is
the slide's "to avoid patterns". Forget the emitter's cosine: 26 becomes 37 W/m² below the panel of the question. Then the sphere: ask why its far side
gets no samples. 7 minutes.
""",
    sources=("Deck, slides Area Lights, Light Contribution of Area Lights (1) and (2)", "Cook, Porter, Carpenter 1984",
             "Kollig and Keller 2002: (0,2)-sequence", "Jarzynski and Olano 2020: pcg hash",
             "Shirley and Chiu 1997: disk", "optics reference 5 and D15"),
    honesty="The estimate converges to the exact value; no shadows. The disk always looks down. Error colours grow with the root of "
            "the error, full at 50 %.",
    values=(Value("light_shape", 0, choices=SHAPES), Value("sampling", 2, low=0, high=3, choices=("grid", "random", "stratified", "Sobol")), Value("level", 1, high=4),
            Value("pattern", 0, choices=("new at every pixel", "the same everywhere")),
            Value("panel_tilt", -58.0, more=True), Value("light_height", 0.75, low=0.1, high=2.0, more=True),
            Value("light_x", 0.0, more=True), Value("light_y", 0.9, more=True),
            Value("panel_width", 1.8, low=0.1, more=True), Value("panel_depth", 0.9, low=0.1, high=2.0, more=True),
            Value("radiance", 10.0, low=1.0, high=30.0, more=True),
            Value("position", (0.0, -0.5, 0.0), low=-1.5, high=1.5, more=True), Value("seed", 3, more=True)),
    minutes=7,
)

BELOW = {"light_x": 0.0, "light_y": 0.0, "panel_depth": "panel_width", **AT_POINT}

AREA_EXACT = Step(
    name="area_exact",
    title="Area lights, in one formula",
    idea="Radiance times projected solid angle: polygon, disk and sphere have it in closed form, cut at the horizon.",
    slides=("Light Contribution of Area Lights (1)",),
    prose=r"""
For a diffuse floor no sample is needed. A light of one radiance gives

$$E = L\,\Omega_\perp$$

its radiance times its projected solid angle, chapter 1's shadow of the shadow. $\colour{l}{\text{Panel}}$ and polygon have
it by a sum over their edges (Lambert 1760), a disk and a sphere by formulas of their own. The four bays show them, with one
radiance. The numbers are for the underlined one: [panel](?light_shape=0), [disk](?light_shape=1),
[sphere](?light_shape=2), [polygon](?light_shape=3).

What is below the horizon must be cut off *first*. Lower the lamps [into the floor](?light_height=0.12): each is cut, none
breaks. Tilt them [upright](?panel_tilt=-85) and they light one side only.

[Far away](?light_height=3&panel_width=0.27) all are points: then only area and cosines count.
""",
    scene=Scene(
        glsl="""
#include "optics/light_shape.glsl"
#include "optics/spherical.glsl"
#include "display/look.glsl"
#include "display/scale.glsl"
uniform int light_shape;
uniform float radiance;
uniform float light_height;
uniform float panel_width;
uniform float panel_tilt;

const float BAY = 1.22; // from middle to middle

float bay(int i) {
    return BAY * (float(i) - 1.5);
}

vec3 flat_point(int shape, vec2 s) {
    int corners = shape == 0 ? 4 : 5, i = int(floor(float(corners) * s.x * 0.99999));
    vec2 rim = mix(outline_at(corners, i), outline_at(corners, i + 1), float(corners) * s.x - float(i)) - 0.5;
    if (shape == 1) rim = 0.5 * vec2(cos(6.2831853 * s.x), sin(6.2831853 * s.x));
    return panel_point(bay(shape), 0.0, light_height, panel_width, panel_width, shape == 1 ? 0.0 : panel_tilt, s.y * rim.x + 0.5, s.y * rim.y + 0.5);
}

vec3 surface_point(int surface, vec2 s) {
    if (surface == 0) return vec3(2.0 * BAY * (2.0 * s.x - 1.0), 3.2 * s.y - 1.6, 0.0);
    if (surface == 1) return vec3(3.2 * s.x - 1.6, -2.36 + 0.16 * s.y, 0.0);
    if (surface == 4) return vec3(bay(2), 0.0, light_height) + 0.5 * panel_width * sphere_point(s.x, s.y);
    return flat_point(surface - 2, s);
}

vec3 shade(Surface s) {
    if (s.id == 1) return decades(pow(10.0, 3.0 * s.st.x - 1.0), -1.0, 2.0);
    if (s.id >= 2) return soft_light(mix(palette[COLOUR_L], vec3(1.0), 0.5), s.normal, s.v);
    int k = clamp(int(floor(s.position.x / BAY + 2.0)), 0, 3);
    float found = irradiance_light(k, radiance, bay(k), 0.0, light_height, panel_width, panel_width, panel_tilt, s.position);
    float wall = (0.5 * BAY - abs(s.position.x - bay(k))) / max(fwidth(s.position.x), 1e-6);
    return mix(background, decades(found, -1.0, 2.0), smoothstep(1.0, 2.0, wall));
}

vec3 mark_point(int mark, float t) {
    if (mark < 4) return vec3(bay(mark), 0.0, light_height * (1.0 - t));
    return vec3(bay(light_shape) + 0.9 * BAY * (t - 0.5), -1.72, 0.0);
}

vec4 probe(int i) {
    if (i < 4) return vec4(bay(i), -1.95, 0.0, 1.0);
    if (i == 4) return vec4(bay(1), 0.0, light_height, 1.0);
    if (i == 5) return vec4(bay(2) + 0.5 * panel_width, 0.0, light_height, 1.0);
    if (i == 6) return vec4(panel_point(bay(0), 0.0, light_height, panel_width, panel_width, panel_tilt, 0.5, 0.0), 1.0);
    return vec4(i == 7 ? -1.55 : i == 8 ? -0.5333 : i == 9 ? 0.5333 : 1.45, -2.6, 0.0, 1.0);
}
""",
        surfaces=(Surface("floor", cells=(2, 2)), Surface("scale", cells=(2, 1)),
                  Surface("panel", cells=(4, 1), opacity=0.85), Surface("disk", cells=(64, 1), opacity=0.85),
                  Surface("sphere", cells=(32, 16), opacity=0.85), Surface("polygon", cells=(5, 1), opacity=0.85)),
        marks=(*(Mark(f"plumb line {name}", colour="quiet", line="dotted", tip="dot", width=0.8) for name in SHAPES),
               Mark("chosen", colour="l", width=1.8)),
        labels=(*(Label(name, i, "l") for i, name in enumerate(SHAPES)),
                Label("0.1", 7), Label("1", 8), Label("10", 9), Label("100 W/m²", 10)),
        handles=(Handle("the height", 4, ("light_height",)), Handle("the width", 5, ("panel_width",)),
                 Handle("the panel's edge", 6, ("panel_tilt",))),
        camera=Camera(azimuth=-84, elevation=34, distance=9.4, target=(0.0, -0.35, 0.1)),
    ),
    plot=Curves(
        title="Straight below, against height",
        sweep="light_height",
        curves=(
            Curve("chosen", Term("irradiance_light", BELOW)),
            *(Curve(name, Term("irradiance_light", {"light_shape": kind, **BELOW}), role="estimate")
              for kind, name in enumerate(SHAPES)),
        ),
        y_label="W/m²", y_scale="log",
    ),
    readouts=(
        Readout("below it", Term("irradiance_light", BELOW), role="exact", unit="W/m²"),
        Readout("64 samples by area", Term("irradiance_light_sampled", {"sampling": 2, "level": 3, "seed": 1, **BELOW}),
                role="estimate", unit="W/m²", against="below it"),
        Readout("64 in solid angle", Term("irradiance_light_sampled", {"sampling": 4, "level": 3, "seed": 1, **BELOW}),
                role="estimate", unit="W/m²", against="below it"),
    ),
    ask=Prediction(
        question="A sphere of radiance 1, two radii away and overhead, gives 0.79 W/m². With its centre on the horizon?",
        truth=Term("irradiance_sphere_light", {"radiance": 1.0, "radius": 0.5, "distance": 1.0, "theta": PI / 2}),
        unit="W/m²", low=0.0, high=0.8,
        sets={"light_shape": 2, "light_height": 0.12},
        told="0.091. Half of it is above the horizon and grazes. As a point it would give nothing: cos 90° is 0.",
    ),
    notes="""
Say what is equal in the four bays: the radiance, not the flux. Ask which floor is brightest below and why: the widest
light. Push the lamps down until they touch: each floor tends to pi L, the most one radiance can give. Past the floor the
formulas are cut at the horizon; a formula without the cut gives negative light there. The readouts show what 64 samples
make of the same number. 5 minutes.
""",
    sources=("Deck, slide Light Contribution of Area Lights (1)", "Lambert 1760: polygon contour",
             "Snyder 1969: sphere with horizon", "Howell: parallel disk, B-12", "optics reference 2.3"),
    honesty="Exact for diffuse receivers without shadows; a lamp half in the floor is cut by the horizon of each point. The disk "
            "always looks down.",
    values=(Value("light_shape", 2, choices=SHAPES), Value("light_height", 0.7, low=0.06, high=3.0),
            Value("panel_width", 0.8, low=0.1, high=1.2), Value("panel_tilt", 0.0, low=-88.0, high=88.0),
            Value("radiance", 10.0, low=1.0, high=30.0, more=True)),
    leave_outs=(
        LeaveOut("64 samples of a lamp", 0.0, 1e-6, "One formula", within={"irradiance_light": "irradiance_light_64"}),
        LeaveOut("the lamps' size", Term("point_lights_error"), 1e-2, "A point", without={"irradiance_light": "irradiance_light_point"})),
    minutes=5,
)

AREA_WORK = Step(
    name="area_work",
    title="What a digit costs",
    idea="For a near panel and a smooth answer, Gauss points even in solid angle win by orders of magnitude.",
    slides=("Light Contribution of Area Lights (2)",),
    prose=r"""
All methods reach the same number. What does each pay for a digit?

The floor's colours are the **error**, in powers of ten, of the method you choose; the curves are its error at the point
$x$. [Random](?sampling=1&level=3): a hundred times the samples for one more digit. [Stratified](?sampling=2&level=3): ten
times. [Sobol](?sampling=3&level=3) about as good, at any number.

Then place the samples where the light *looks* large: evenly in **solid angle**. The $1/r^2$ and one cosine are gone from
the sum. [Sobol there](?sampling=4&level=3), and [Gauss points there](?sampling=5&level=3): 64 of them give six digits,
nearly everywhere. For a [sphere](?light_shape=2&sampling=5&level=3) it is the cone it fills. A [disk](?light_shape=1&sampling=5&level=3)
and a [polygon](?light_shape=3&sampling=5&level=3) take the square around them; a sample beside the shape counts nothing, and that
step costs Gauss his digits. So does the horizon's crease in a light [half in the floor](?light_shape=0&light_height=0.2&sampling=5&level=3).
""",
    scene=Scene(
        glsl="""
#include "optics/shape_samples.glsl"
#include "optics/spherical.glsl"
#include "display/scale.glsl"
""" + SAMPLES_GLSL + """
vec3 surface_point(int surface, vec2 s) {
    if (surface == 0) return vec3(4.0 * s - 2.0, 0.0);
    if (surface == 1) return vec3(3.2 * s.x - 1.6, -2.36 + 0.16 * s.y, 0.0);
    return lamp_point(s);
}

vec3 shade(Surface s) {
    if (s.id == 1) return decades(pow(10.0, 6.0 * s.st.x - 6.0), -6.0, 0.0);
    if (s.id == 2) return lamp_colour(s);
    int own = int(gl_FragCoord.x) + 8192 * int(gl_FragCoord.y) + seed;
    float found = sampled(s.position, own);
    float right = exact(s.position);
    return decade_colour(right > 0.0 ? max(abs(found - right) / right, 1e-7) : 0.0, -6.0, 0.0);
}

vec3 mark_point(int mark, float t) {
    if (mark == 0) return rim_point(t);
    return position + vec3(0.0, 0.0, 0.5 * t);
}

vec4 probe(int i) {
    if (i == 0) return vec4(middle(), 1.0);
    if (i == 1) return vec4(panel_point(light_x, light_y, light_height, panel_width, panel_depth, panel_tilt, 0.5, 1.0), 1.0);
    if (i == 2) return vec4(position, 1.0);
    return vec4(i == 3 ? -1.5 : i == 4 ? -0.5333 : i == 5 ? 0.5333 : 1.5, -2.62, 0.0, 1.0);
}
""",
        surfaces=(Surface("floor", cells=(2, 2)), Surface("scale", cells=(2, 1)), Surface("light", cells=(60, 16))),
        marks=(RIM, Mark("normal", colour="n", tip="arrow", label="n", label_at=0.6)),
        dots=Dots(256, size=0.9),
        decided=("light_shape", "sampling"),
        labels=(Label("0.0001 %", 3), Label("0.01 %", 4), Label("1 %", 5), Label("100 %", 6)),
        handles=(Handle("the light", 0, ("light_x", "light_height")), Handle("its tilt", 1, ("panel_tilt",)),
                 Handle("the point", 2, ("position",))),
        camera=Camera(azimuth=-84, elevation=38, distance=9.6, target=(0.0, -0.4, 0.0)),
    ),
    plot=Curves(
        title="Error at x against samples",
        sweep="level",
        curves=(
            Curve("exact", Term("irradiance_light")),
            *(Curve(name, Term("irradiance_light_sampled", {"sampling": kind}), role="estimate")
              for kind, name in ((2, "stratified"), (3, "Sobol"), (4, "Sobol, angle"), (5, "Gauss, angle"))),
            Curve("random", Term("irradiance_light_sampled", {"sampling": 1}), role="printed"),
        ),
        y_label="relative error", y_scale="log",
        error=True,
    ),
    readouts=(
        Readout("exact at x", Term("irradiance_light"), role="exact", unit="W/m²"),
        Readout("random", Term("irradiance_light_sampled", {"sampling": 1}), role="estimate", unit="W/m²",
                against="exact at x"),
        Readout("Sobol in solid angle", Term("irradiance_light_sampled", {"sampling": 4}), role="estimate", unit="W/m²",
                against="exact at x"),
        Readout("Gauss in solid angle", Term("irradiance_light_sampled", {"sampling": 5}), role="estimate", unit="W/m²",
                against="exact at x"),
    ),
    ask=Prediction(
        question="The panel of 2 m by 2 m half a metre up gives 26.1 W/m². One sample in its centre says 160. What do four "
                 "Gauss points even in solid angle say?",
        truth=Term("irradiance_light_sampled", {
            "light_shape": 0, "radiance": 10.0, "light_x": 0.0, "light_y": 0.0, "light_height": 0.5, "panel_width": 2.0,
            "panel_depth": 2.0, "panel_tilt": 0.0, "position": (0.0, 0.0, 0.0), "sampling": 5, "level": 1, "seed": 0}),
        unit="W/m²",
        choices=(Choice("still half too much", 32.0, 80.0), Choice("20 % too little", 18.0, 24.0),
                 Choice("26, to 2 %", 25.6, 26.7)),
        sets={"light_shape": 0, "sampling": 5, "level": 1},
        told="26.5, or 1.5 % too much, from four samples. With 64 the error is 3 in a million.",
    ),
    notes="""
Ask which method wins for a near panel, and let them vote before the map turns dark. Read the costs beside the numbers: a
sample in solid angle costs a few times one by area, and is worth hundreds. Then the exceptions: a crease at the horizon, a
shadow, a mirror; Gauss needs smoothness, Sobol and stratified do not mind. Far away all agree. 6 minutes.
""",
    sources=("Urena, Fajardo, King 2013: spherical rectangles", "Gamito 2016: disks in the square around them",
             "Shirley, Wang, Zimmerman 1996: spheres", "Abramowitz and Stegun 1964, 25.4.30", "optics reference 5",
             "Deck, slide Light Contribution of Area Lights (2)"),
    honesty="Errors are against the closed form, in float32 on the floor (about 1e-6). Thin or far flat lights are sampled by area.",
    values=(Value("light_shape", 0, choices=SHAPES), Value("sampling", 2, choices=("grid", "random", "stratified", "Sobol", "Sobol, solid angle",
                                          "Gauss, solid angle")),
            Value("level", 2, high=4), Value("panel_tilt", -58.0, more=True), Value("light_height", 0.6, low=0.1, high=2.0),
            Value("light_x", 0.0, more=True), Value("light_y", 0.9, more=True),
            Value("panel_width", 1.8, low=0.3, more=True), Value("panel_depth", 0.9, low=0.3, high=2.0, more=True),
            Value("radiance", 10.0, low=1.0, high=30.0, more=True),
            Value("position", (0.0, -0.3, 0.0), low=-1.5, high=1.5, more=True), Value("seed", 3, more=True)),
    minutes=6,
    beyond=True,
)

PYTHON_STUB = '''import numpy as np


def spot_linear(off_axis, hotspot, falloff):
    """Share of the intensity at the angle off_axis from the beam's axis; hotspot and falloff are half angles, in rad."""
    return np.full(np.broadcast_shapes(off_axis.shape, hotspot.shape, falloff.shape), 0.37)
'''
PYTHON_SOLUTION = '''import numpy as np


def spot_linear(off_axis, hotspot, falloff):
    """Linear in the cosine; cos p - cos q = 2 sin((q - p) / 2) sin((q + p) / 2) keeps the digits of narrow beams."""
    def wedge(angle):
        return np.sin(0.5 * (falloff - angle)) * np.sin(0.5 * (falloff + angle))

    hard = hotspot >= falloff
    soft = np.clip(wedge(off_axis) / np.where(hard, 1.0, wedge(hotspot)), 0.0, 1.0)
    return np.where(hard, np.where(off_axis <= falloff, 1.0, 0.0), soft)
'''
GLSL_STUB = """float spot_linear(float off_axis, float hotspot, float falloff) {
    return 0.37;
}
"""
GLSL_SOLUTION = """float wedge(float angle, float falloff) {
    return sin(0.5 * (falloff - angle)) * sin(0.5 * (falloff + angle));
}

float spot_linear(float off_axis, float hotspot, float falloff) {
    if (hotspot >= falloff) return off_axis <= falloff ? 1.0 : 0.0;
    return clamp(wedge(off_axis, falloff) / wedge(hotspot, falloff), 0.0, 1.0);
}
"""

CHAPTER = Chapter(
    title="Lights",
    idea="Which way is the light, and how much of it arrives: for points, directions, spots and areas.",
    steps=(SOURCES, POSITIONAL, DIRECTIONAL, DISTRIBUTION, IES, SPOT, AREA_UNITS, AREA_SAMPLED, AREA_EXACT, AREA_WORK),
    exercises=(
        Exercise(
            name="spot",
            function="spot_linear",
            task="Write the spotlight of the slides with its clamp: full inside the hotspot, linear in the cosine, nothing "
                 "outside the falloff. Equal angles are a hard edge, and a beam of a hundredth of a degree still works.",
            slide="Light Sources - Spotlights (2)",
            stubs={"python": PYTHON_STUB, "glsl": GLSL_STUB},
            solutions={"python": PYTHON_SOLUTION, "glsl": GLSL_SOLUTION},
            checks=(
                Check({"off_axis": (0.45, 0.4, 0.55), "hotspot": (0.3, 0.35, 0.5), "falloff": (0.5, 0.6, 0.7)},
                      "between the cones"),
                Check({"off_axis": (0.1, 0.0), "hotspot": (0.3, 0.2), "falloff": (0.5, 0.21)}, "in the hotspot: 1"),
                Check({"off_axis": (0.6, 1.5, 3.0), "hotspot": (0.3, 0.35, 0.5), "falloff": (0.5, 0.6, 0.7)},
                      "outside the falloff: 0, and never negative"),
                Check({"off_axis": (0.2, 0.3, 0.25), "hotspot": (0.25, 0.25, 0.4), "falloff": (0.25, 0.25, 0.3)},
                      "equal angles, and a hotspot wider than the falloff: a hard edge"),
                Check({"off_axis": (1.1e-4, 1.5e-4), "hotspot": (1e-4, 1.2e-4), "falloff": (1.2e-4, 1.8e-4)},
                      "a beam of a hundredth of a degree", hidden=True),
            ),
        ),
        IES_EXERCISE,
    ),
    terms={
        "IES file": "a list of measured luminous intensities by direction, in the format LM-63",
        "photometric plane": "a half plane of directions with one azimuth, C0, C90, ...",
        "absolute photometry": "candela as they are, with no lumens of the lamp they refer to; the file says -1",
        "punctual light": "a light without size: a point with an intensity, or a direction with an irradiance",
        "positional light": "a point light: direction and distance are found anew at each shaded point",
        "directional light": "a light so far away that direction and irradiance are the same everywhere",
        "emission distribution": "share of a lamp's flux per steradian in each direction; all directions sum to 1",
        "photometric solid": "a body around a lamp, as far out in each direction as its intensity there",
        "hotspot": "the cone of a spotlight with full intensity, given by its half angle",
        "falloff": "the cone of a spotlight beyond which nothing is lit, given by its half angle",
        "stratified": "one random sample in each of many equal cells; also called jittered",
        "spherical rectangle": "what a rectangle covers on the unit sphere; samples even in it are even in solid angle",
    },
)
