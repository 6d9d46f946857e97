"""How much of what you see does a thing take up? Before light can be measured we must measure directions.

A radian counts how much of a circle an arc takes; a steradian counts how much of a sphere a patch takes. Everything in
local shading is an integral over such patches of directions: get them right, and the rest of the course is bookkeeping.
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
    Faces,
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
    Term,
    Value,
)

PI = 3.141592653589793

ANGLE = Step(
    name="angle",
    title="From angle to solid angle",
    idea="A radian is an arc over its radius; a steradian is a patch of the sphere over its radius squared.",
    slides=("Basic Concepts",),
    prose=r"""
Light goes out in all directions. To say how much goes where, we count directions.

On a **circle** we count arc: an angle in radians is $\colour{l}{\text{arc}} / r$. On a **sphere** we count area:

$$\omega = \frac{\colour{l}{A'}}{r^2}$$

in *steradians*. The radius cancels both times, so it can be 1. Both figures here open by the same half angle $\theta$.
The dashed marks are one radian and one steradian.

Try [a narrow beam](?half_angle=10), [one steradian](?half_angle=32.77), [half of everything](?half_angle=90),
[everything](?half_angle=180). At small angles the arc grows as $\theta$ and the cap as $\theta^2$: half the angle,
a quarter of the directions.
""",
    scene=Scene(
        glsl="""
#include "optics/spherical.glsl"
#include "display/look.glsl"
uniform float half_angle;

const vec3 CIRCLE = vec3(-1.35, 0.0, 0.0);
const vec3 SPHERE = vec3(1.35, 0.0, 0.0);
const float ONE_RADIAN = 0.5;       // half angles
const float ONE_STERADIAN = 0.5719; // acos(1 - 1 / (2 pi))

vec3 on_circle(float angle, float radius) {
    return CIRCLE + radius * vec3(sin(angle), 0.0, cos(angle));
}

vec3 surface_point(int surface, vec2 s) {
    if (surface == 0) return on_circle((2.0 * s.x - 1.0) * half_angle, s.y);
    if (surface == 1) return SPHERE + 1.004 * cap_point(half_angle, s.x, s.y);
    if (surface == 2) return SPHERE + s.y * cap_point(half_angle, s.x, 1.0);
    return SPHERE + sphere_point(s.x, s.y);
}

vec3 shade(Surface s) {
    vec3 light = palette[COLOUR_L];
    if (s.id == 0) return light * 0.55;
    vec3 n = s.id == 2 ? s.normal : normalize(s.position - SPHERE);
    if (s.id == 1) return soft_light(mix(light, light * 0.45, grid_lines(s.st, vec2(24.0, 8.0))), n, s.v);
    if (s.id == 2) return soft_light(light, n, s.v);
    return glass(s.st, vec2(24.0, 12.0));
}

vec3 mark_point(int mark, float t) {
    float side = 2.0 * t - 1.0;
    if (mark == 0) return on_circle(6.2831853 * t, 1.0);
    if (mark == 1) return on_circle(side * half_angle, 1.0);
    if (mark == 2) return on_circle(-half_angle, 1.0 - t);
    if (mark == 3) return on_circle(half_angle, t);
    if (mark == 4) return on_circle(side * ONE_RADIAN, 1.12);
    if (mark == 5) return SPHERE + 1.02 * cap_point(ONE_STERADIAN, t, 1.0);
    return SPHERE + 1.01 * cap_point(half_angle, t, 1.0);
}

vec4 probe(int i) {
    if (i == 0) return vec4(on_circle(half_angle, 1.0), 1.0);
    if (i == 1) return vec4(SPHERE + cap_point(half_angle, 0.0, 1.0), 1.0);
    if (i == 2) return vec4(CIRCLE + vec3(0.0, 0.0, -1.3), 1.0);
    return vec4(SPHERE + vec3(0.0, 0.0, -1.3), 1.0);
}
""",
        surfaces=(
            Surface("sector", cells=(64, 1)),
            Surface("cap", cells=(64, 16)),
            Surface("cone", cells=(64, 1), opacity=0.35),
            Surface("sphere", cells=(48, 24), opacity=0.16),
        ),
        marks=(
            Mark("circle", colour="quiet", segments=96),
            Mark("arc", colour="l", segments=64, width=2.2),
            Mark("radius left", colour="exact"),
            Mark("radius right", colour="exact", label="r = 1", label_at=0.5),
            Mark("one radian", colour="exact", line="dashed", segments=24, label="1 rad", label_at=0.5),
            Mark("one steradian", colour="exact", line="dashed", segments=96, label="1 sr", label_at=0.875),
            Mark("rim", colour="l", segments=96, width=1.6),
        ),
        labels=(Label("angle: arc / r", 2), Label("solid angle: A′ / r²", 3)),
        handles=(Handle("the arc's end", 0, ("half_angle",)), Handle("the cap's rim", 1, ("half_angle",))),
        camera=Camera(azimuth=-90, elevation=14, distance=10.4, target=(0.0, 0.0, -0.1)),
    ),
    plot=Curves(
        title="The same opening, twice",
        sweep="half_angle",
        curves=(
            Curve("solid angle (sr)", Term("solid_angle_cone")),
            Curve("angle (rad)", Term("plane_angle"), role="estimate"),
        ),
        y_label="rad, sr",
    ),
    readouts=(
        Readout("angle", Term("plane_angle"), unit="rad"),
        Readout("solid angle", Term("solid_angle_cone"), role="exact"),
    ),
    ask=Prediction(
        question="A full circle has 2π ≈ 6.28 radians. How many steradians has everything around you?",
        truth=Term("solid_angle_cone", {"half_angle": PI}),
        unit="sr",
        low=0.0,
        high=20.0,
        sets={"half_angle": 180.0},
        told="4π ≈ 12.57: the area of a sphere of radius 1. Twice as much as the circle's number, by luck.",
    ),
    notes="""
Start with an outstretched arm: one radian is as wide as the arm is long. Then draw a square metre on a sphere of one metre.
Ask for the number of radians first, everyone knows it; the steradians nobody does. Common guess: 2π (that is half of
everything) or (2π)² (angles do not multiply on a sphere). Drag the cap to 90° and ask what is left. 4 minutes.
""",
    sources=("Deck, slides Basic Concepts and Solid Angles", "Archimedes, On the Sphere and Cylinder: the area of a cap"),
    honesty="Exact. The marks of one radian and one steradian are drawn at half angles of 0.5 and arccos(1 - 1/2π) rad.",
    minutes=4,
)

PATCH_GLSL = """
#include "optics/square_patch.glsl"
#include "display/look.glsl"
#include "stage/camera.glsl"
uniform float theta;
uniform float phi;
uniform float distance;
uniform float tilt;
uniform float width;
uniform int samples;

vec3 at(vec2 s) {
    return patch_point(theta, phi, distance, tilt, width, s.x, s.y);
}

vec3 corner(int i) {
    return at(vec2(i == 1 || i == 2 ? 1.0 : 0.0, i >= 2 ? 1.0 : 0.0));
}

vec3 surface_point(int surface, vec2 s) {
    if (surface == 0) return at(s);
    if (surface == 1) return 1.004 * normalize(at(s));
    return sphere_point(s.x, s.y);
}

vec3 shade(Surface s) {
    float line = grid_lines(s.st, vec2(8.0));
    if (s.id == 0) return soft_light(mix(palette[COLOUR_L], palette[COLOUR_L] * 0.4, line), s.normal, s.v);
    if (s.id == 1) return mix(palette[COLOUR_ESTIMATE], palette[COLOUR_ESTIMATE] * 0.4, line);
    return glass(s.st, vec2(24.0, 12.0));
}

vec3 dot_point(int i) {
    return 1.012 * fibonacci_direction(i, samples);
}

vec4 dot_colour(int i) {
    vec3 d = fibonacci_direction(i, samples);
    if (meets_patch(d, theta, phi, distance, tilt, width) > 0.5) return vec4(palette[COLOUR_L], 1.0);
    return vec4(palette[COLOUR_QUIET], dot(d, camera_position - d) > 0.0 ? 0.5 : 0.0);
}

vec3 mark_point(int mark, float t) {
    vec3 centre = at(vec2(0.5));
    if (mark < 4) return corner(mark) * t;
    if (mark == 4) return centre * t;
    return centre + 0.55 * t * patch_normal(theta, phi, tilt);
}

vec4 probe(int i) {
    vec3 centre = at(vec2(0.5));
    if (i == 0) return vec4(centre, 1.0);
    if (i == 1) return vec4(centre + 0.55 * patch_normal(theta, phi, tilt), 1.0);
    if (i == 2) return vec4(centre * 0.75, 1.0);
    if (i == 3) return vec4(corner(1), 1.0);
    return vec4(1.02 * normalize(corner(3)), 1.0);
}
"""

PATCH = Step(
    name="patch",
    title="What a patch takes up",
    idea="The solid angle of a patch is its shadow on the unit sphere; far away that is dA cos β / r².",
    slides=("Solid Angles",),
    prose=r"""
Hold a square in front of the eye, which sits in the middle of the unit sphere. Rays from the eye through the
$\colour{l}{\text{patch}}$ cut a $\colour{estimate}{\text{shadow}}$ out of the sphere. Its area is the solid angle.

If the patch is small and far, there is a short cut with the angle $\beta$ between its normal $\colour{n}{n}$ and the line of
sight:

$$\omega \approx \frac{dA\,\cos\beta}{r^2}$$

Drag the patch, its normal, its distance. Or count: of $N$ points spread evenly over the sphere, take the share the patch
covers.

[Twice as far](?distance=3.2), [edge on](?tilt=88), [close by](?distance=0.5&width=2): close by the short cut is wrong by
half and more, and nothing warns you.
""",
    scene=Scene(
        glsl=PATCH_GLSL,
        surfaces=(
            Surface("patch", cells=(8, 8)),
            Surface("shadow", cells=(24, 24)),
            Surface("sphere", cells=(48, 24), opacity=0.14),
        ),
        marks=(
            *(Mark(f"ray {i}", colour="quiet", line="dashed", width=0.8) for i in range(4)),
            Mark("line of sight", colour="v", label="r", label_at=0.82),
            Mark("normal", colour="n", tip="arrow", label="n"),
        ),
        dots=Dots("samples", size=0.8),
        labels=(Label("A", 3, "l"), Label("A′", 4, "estimate")),
        handles=(
            Handle("the patch", 0, ("theta", "phi")),
            Handle("its normal", 1, ("tilt",)),
            Handle("its distance", 2, ("distance",)),
        ),
        legend=(("l", "the patch A, and the points that meet it"), ("estimate", "its shadow A′ on the unit sphere")),
        camera=Camera(azimuth=-62, elevation=20, distance=8.8, target=(0.9, 0.3, 0.55)),
    ),
    plot=Curves(
        title="Solid angle against distance",
        sweep="distance",
        curves=(
            Curve("exact", Term("solid_angle_patch")),
            Curve("dA cos β / r²", Term("solid_angle_patch_small"), role="estimate"),
        ),
        y_label="sr",
        y_scale="log",
    ),
    readouts=(
        Readout("exact", Term("solid_angle_patch"), role="exact"),
        Readout("counted", Term("solid_angle_patch_counted"), role="estimate", against="exact"),
        Readout("dA cos β / r²", Term("solid_angle_patch_small"), role="estimate", against="exact"),
    ),
    ask=Prediction(
        question="The patch is 1 m wide and 1 m away, facing you. Push it twice as far: what share of its solid angle is left?",
        truth=Term("solid_angle_patch_ratio", {"distance": 1.0, "tilt": 0.0, "width": 1.0}),
        unit="of it",
        low=0.0,
        high=1.0,
        sets={"distance": 2.0, "tilt": 0.0, "width": 1.0},
        told="0.29, not 0.25. The r² rule holds for small patches only: a near one is partly seen at a slant already.",
    ),
    notes="""
Let someone drag the patch towards the eye until it fills half the sphere: 2π, and no plane patch ever gets more. Ask the
prediction before; a quarter is the common answer, and tempting because it is right for lamps in the next room. Then open
"close by" and read the error aloud. The counted number jumps as points fall in and out: that is what sampling means, and
its error falls only as the points grow. Edge on, the shadow closes: β = 90° has no area whatever r is. 6 minutes.
""",
    sources=("Deck, slide Solid Angles", "van Oosterom & Strackee 1983: triangles of the square",
             "Swinbank and Purser 2006: Fibonacci grid"),
    honesty="Exact: closed form. dA cos β / r² is the first order in w/r. Counted: the share of N evenly spread directions.",
    values=(Value("theta", 55.0, more=True), Value("phi", 20.0, more=True), Value("distance", 1.6), Value("tilt", 25.0),
            Value("width", 1.2), Value("samples", 2048, more=True)),
    minutes=6,
    breaks=(Break("equal steps of θ, without sin θ", {"fibonacci_direction": "fibonacci_direction_naive", "solid_angle_patch_counted": "solid_angle_patch_counted_naive"}, {"theta": 6.0, "samples": 4096},
                  "Equal steps in θ put as many points on the small rings at the pole as on the equator, so a patch up there catches several times its share. More points do not help: the count settles on the wrong number. dω = sin θ dθ dφ; with equal steps in height, cos θ, the sine is paid.",
                  "counted solid angle", Term("solid_angle_patch_counted"), "sr"),),
)

CONE = Step(
    name="cone",
    title="Cones, caps, the Sun and the Moon",
    idea="A cone of half angle θ takes 4π sin²(θ/2); the textbook's 2π(1 - cos θ) is the same and loses small cones.",
    slides=("Solid Angles",),
    prose=r"""
A round thing far away fills a **cone**. Its cap on the unit sphere has

$$\omega = 2\pi(1-\cos\theta) = 4\pi\sin^2\!\frac{\theta}{2}$$

Open it to [the hemisphere](?half_angle=90), $2\pi$, and on to [everything](?half_angle=180), $4\pi$. Then close it to
[the Sun](?half_angle=0.2666), [the Moon](?half_angle=0.2591) and [Jupiter](?half_angle=0.0061).

Both formulas are equal on paper. On a graphics card, which carries seven digits, $\cos\theta$ of a small cone rounds to 1
and the difference to nothing. The lens shows the cap enlarged: left from the
$\colour{estimate}{\text{stable form}}$, right $\colour{printed}{\text{as printed}}$, both in the card's own arithmetic.
[See it go](?half_angle=0.01).
""",
    scene=Scene(
        glsl="""
#include "optics/spherical.glsl"
#include "optics/solid_angle.glsl"
#include "display/look.glsl"
uniform float half_angle;

const vec3 LENS = vec3(2.05, 0.0, 0.35);

// The lens enlarges the cap to radius 0.62; its right half has the area the printed formula gives.
float lens_radius(float side) {
    float right = solid_angle_cone(half_angle);
    float shown = side < 0.0 ? right : solid_angle_cone_naive(half_angle);
    return 0.62 * sqrt(max(shown, 0.0) / max(right, 1e-30));
}

vec3 lens_point(float turn, float radius) {
    return LENS + radius * vec3(sin(turn), 0.0, cos(turn));
}

vec3 surface_point(int surface, vec2 s) {
    if (surface == 0) return 1.004 * cap_point(half_angle, s.x, s.y);
    if (surface == 1) return s.y * cap_point(half_angle, s.x, 1.0);
    if (surface == 2) return lens_point(-PI * s.x, s.y * lens_radius(-1.0));
    if (surface == 3) return lens_point(PI * s.x, s.y * lens_radius(1.0));
    return sphere_point(s.x, s.y);
}

vec3 shade(Surface s) {
    vec3 light = palette[COLOUR_L];
    if (s.id == 2) return palette[COLOUR_ESTIMATE];
    if (s.id == 3) return palette[COLOUR_PRINTED];
    if (s.id == 0) return soft_light(light, normalize(s.position), s.v);
    if (s.id == 1) return soft_light(light, s.normal, s.v);
    return glass(s.st, vec2(24.0, 12.0));
}

vec3 mark_point(int mark, float t) {
    if (mark == 0) return lens_point(2.0 * PI * t, 0.86);
    if (mark == 1) return mix(LENS - vec3(0.86 * 0.9, 0.0, -0.86 * 0.42), vec3(0.03, 0.0, 1.0), t);
    if (mark == 2) return vec3(0.0, 0.0, 1.5 * t);
    if (mark == 3) return lens_point(0.0, 0.86 - 1.72 * t);
    return 1.01 * cap_point(half_angle, t, 1.0);
}

vec4 probe(int i) {
    if (i == 0) return vec4(cap_point(half_angle, 0.0, 1.0), 1.0);
    if (i == 1) return vec4(LENS + vec3(-0.45, 0.0, -1.08), 1.0);
    return vec4(LENS + vec3(0.45, 0.0, -1.08), 1.0);
}
""",
        surfaces=(
            Surface("cap", cells=(64, 12)),
            Surface("cone", cells=(64, 1), opacity=0.45),
            Surface("lens: stable", cells=(48, 1)),
            Surface("lens: as printed", cells=(48, 1)),
            Surface("sphere", cells=(48, 24), opacity=0.14),
        ),
        marks=(
            Mark("lens rim", colour="quiet", segments=96),
            Mark("lens handle", colour="quiet", line="dashed"),
            Mark("axis", colour="exact", tip="arrow"),
            Mark("lens divide", colour="quiet", width=0.7),
            Mark("rim", colour="l", segments=96, width=1.5),
        ),
        labels=(Label("stable", 1, "estimate"), Label("as printed", 2, "printed")),
        handles=(Handle("the cap's rim", 0, ("half_angle",)),),
        camera=Camera(azimuth=-90, elevation=16, distance=9.2, target=(0.95, 0.0, 0.15)),
    ),
    plot=Curves(
        title="Relative error in float32",
        sweep="half_angle",
        x_scale="log",
        curves=(
            Curve("exact (float64)", Term("solid_angle_cone")),
            Curve("4π sin²(θ/2)", Term("solid_angle_cone"), role="estimate", precision="float32"),
            Curve("2π(1 - cos θ)", Term("solid_angle_cone_naive"), role="printed", precision="float32"),
        ),
        y_label="relative error",
        y_scale="log",
        error=True,
    ),
    readouts=(
        Readout("exact", Term("solid_angle_cone"), role="exact"),
        Readout("4π sin²(θ/2), float32", Term("solid_angle_cone"), role="estimate", precision="float32", against="exact"),
        Readout("2π(1 - cos θ), float32", Term("solid_angle_cone_naive"), role="printed", precision="float32",
                against="exact"),
    ),
    ask=Prediction(
        question="The Sun is half a degree wide. How many Suns would it take to fill the whole sky above and below you?",
        truth=Term("cones_in_the_sphere", {"half_angle": 0.2666 * PI / 180}),
        unit="Suns",
        low=1e2,
        high=1e7,
        scale="log",
        sets={"half_angle": 0.2666},
        told="About 185 000. The Sun takes 6.8e-5 sr of 12.57; all daylight comes through that keyhole.",
    ),
    notes="""
Let them guess the Sun before showing the number; a factor of 100 too few is usual, because we remember its light and not
its size. Then the Moon: as large as the Sun, or there would be no eclipses. Close the cone slowly below 0.05° and watch
the right half of the lens: it first trembles, then jumps, then is gone. Ask why the plot of the printed form has steps:
near 1 the float32 numbers are 6e-8 apart. The remedy is algebra, not more digits. 6 minutes.
""",
    sources=("Deck, slide Solid Angles", "Kahan 2006: 1 - cos θ = 2 sin²(θ/2) against cancellation", "Sun 0.2666°, Moon 0.2591°: mean angular radii, IAU 2015 "
             "nominal solar radius and mean distances"),
    honesty="Exact to rounding. The lens enlarges; its two areas are in the true proportion of the two float32 results.",
    values=(Value("half_angle", 35.0, low=1e-4, high=180.0, scale="log"),),
    minutes=6,
)

DIFFERENTIAL = Step(
    name="differential",
    title="Cells of the sphere",
    idea="A cell dθ by dφ has the solid angle sin θ dθ dφ: the same steps cover less of the sphere near the pole.",
    slides=("Basic Concepts",),
    prose=r"""
To integrate over directions we cut the sphere into cells: $\theta$ from the pole, $\varphi$ around it, equal steps in both.
The cells are **not** equal. One is $d\theta$ high and $\sin\theta\,d\varphi$ wide, so

$$d\omega = \sin\theta\;d\theta\,d\varphi$$

Colour shows the size. Drag the $\colour{l}{\text{bright cell}}$ from [the equator](?theta=90) to [the pole](?theta=2): it
never gets lower, only narrower, until nothing is left of it.

Added up, all cells must give $4\pi$. With [few rows](?rows=4) the sum is a little too large; double the rows and the error
falls to a quarter. Forget the $\sin\theta$ in an integral and every pole shines.
""",
    scene=Scene(
        glsl="""
#include "optics/sphere_grid.glsl"
#include "display/look.glsl"
uniform float theta;
uniform float phi;
uniform int rows;

float step_angle() {
    return PI / float(rows);
}

vec3 cell_point(vec2 s, float radius) {
    float t = clamp(theta + (s.y - 0.5) * step_angle(), 0.0, PI);
    return radius * direction(t, phi + (s.x - 0.5) * step_angle());
}

vec3 surface_point(int surface, vec2 s) {
    if (surface == 0) return sphere_point(s.x, s.y);
    return cell_point(s, 1.07);
}

vec3 shade(Surface s) {
    vec3 n = normalize(s.position);
    if (s.id == 1) return soft_light(palette[COLOUR_L], n, s.v);
    vec2 cells = vec2(2.0 * float(rows), float(rows));
    float row = (floor(s.st.y * cells.y) + 0.5) * step_angle();
    float share = grid_cell(row, rows) / grid_cell(0.5 * PI, rows);
    return soft_light(mix(colormap(share), background, grid_lines(s.st, cells) * 0.8), n, s.v);
}

vec3 mark_point(int mark, float t) {
    if (mark == 0) return vec3(0.0, 0.0, 1.0 + 0.45 * t);
    if (mark == 1) return cell_point(vec2(1.0, t), 1.09);
    if (mark == 2) return cell_point(vec2(t, 1.0), 1.09);
    return 1.012 * direction(theta * t, phi);
}

vec4 probe(int i) {
    return vec4(cell_point(vec2(0.5), 1.07), 1.0);
}
""",
        surfaces=(Surface("sphere", cells=(48, 32)), Surface("cell", cells=(16, 16))),
        marks=(
            Mark("axis", colour="n", tip="arrow", label="n"),
            Mark("height", colour="exact", segments=12, width=1.6, label="dθ", label_at=0.5),
            Mark("breadth", colour="exact", segments=12, width=1.6, label="sin θ dφ", label_at=0.5),
            Mark("meridian", colour="exact", line="dashed", segments=32, label="θ", label_at=0.45),
        ),
        handles=(Handle("the cell", 0, ("theta", "phi")),),
        camera=Camera(azimuth=-40, elevation=28, distance=5.6, target=(0.0, 0.0, 0.2)),
        legend=(("n", "axis"), ("l", "one cell")),
    ),
    plot=Curves(
        title="One cell, from pole to pole",
        sweep="theta",
        curves=(
            Curve("exact", Term("grid_cell")),
            Curve("sin θ dθ dφ", Term("grid_cell_differential"), role="estimate"),
        ),
        y_label="sr",
    ),
    readouts=(
        Readout("this cell, exact", Term("grid_cell"), role="exact"),
        Readout("sin θ dθ dφ", Term("grid_cell_differential"), role="estimate", against="this cell, exact"),
        Readout("4π", Term("solid_angle_cone", {"half_angle": PI}), role="exact"),
        Readout("sum of all cells", Term("solid_angle_cells"), role="estimate", against="4π"),
    ),
    ask=Prediction(
        question="Which cell takes up most of the sphere?",
        truth=Term("grid_cell_widest", {"rows": 18}),
        unit="rad from the pole",
        choices=(Choice("the one at the pole", 0.0, 0.3), Choice("the one half way down, at 45°", 0.6, 1.0),
                 Choice("one at the equator", 1.4, 1.75), Choice("all are equal", -1.0, -1.0)),
        sets={"theta": 90.0, "rows": 18},
        told="At the equator, where sin θ = 1. Equal steps in θ and φ are not equal steps on the sphere.",
    ),
    notes="""
The globe on the desk: the degree squares of Norway are slim, those of Kenya nearly square. "All are equal" is the tempting
answer, because the table of θ and φ looks like squared paper. Write sin θ dθ dφ only after the cell has been dragged to
the pole. The sum with four rows is 2.6 % too large: ask which way it errs, and why (the midpoint of a sine's arch lies
above its mean). 5 minutes.
""",
    sources=("Deck, slide Basic Concepts", "Abramowitz & Stegun 1964, 25.4.2: the midpoint rule and its error"),
    honesty="The cell is exact: 2 sin θ sin(dθ/2) dφ. The sum is the midpoint rule on purpose, so that it has an error to see.",
    values=(Value("theta", 55.0, low=0.0, high=180.0), Value("phi", -15.0, more=True), Value("rows", 18)),
    minutes=5,
)

PROJECTED_GLSL = """
#include "optics/square_patch.glsl"
#include "display/look.glsl"
uniform float theta;
uniform float phi;
uniform float distance;
uniform float tilt;
uniform float width;

vec3 at(vec2 s) {
    return patch_point(theta, phi, distance, tilt, width, s.x, s.y);
}

vec3 on_dome(vec2 s) {
    vec3 d = normalize(at(s));
    return d.z > 0.0 ? d : vec3(normalize(d.xy + vec2(1e-9)), 0.0);
}

vec3 corner(int i) {
    return at(vec2(i == 1 || i == 2 ? 1.0 : 0.0, i >= 2 ? 1.0 : 0.0));
}

vec3 dome_corner(int i) {
    return on_dome(vec2(i == 1 || i == 2 ? 1.0 : 0.0, i >= 2 ? 1.0 : 0.0));
}

vec3 surface_point(int surface, vec2 s) {
    if (surface == 0) return at(s);
    if (surface == 1) return 1.004 * on_dome(s);
    if (surface == 2) return vec3(on_dome(s).xy, 0.006);
    if (surface == 3) return vec3(s.y * cos(2.0 * PI * s.x), s.y * sin(2.0 * PI * s.x), 0.0);
    return cap_point(0.5 * PI, s.x, s.y);
}

vec3 shade(Surface s) {
    float line = grid_lines(s.st, vec2(8.0));
    if (s.id == 0) return soft_light(mix(palette[COLOUR_L], palette[COLOUR_L] * 0.4, line), s.normal, s.v);
    if (s.id == 1) return mix(palette[COLOUR_ESTIMATE], palette[COLOUR_ESTIMATE] * 0.4, line);
    if (s.id == 2) return mix(palette[COLOUR_V], palette[COLOUR_V] * 0.4, line);
    if (s.id == 3) return mix(mix(background, palette[COLOUR_QUIET], 0.25), palette[COLOUR_QUIET], grid_lines(s.st, vec2(24.0, 6.0)) * 0.5);
    return glass(s.st, vec2(24.0, 6.0));
}

vec3 mark_point(int mark, float t) {
    if (mark < 4) return corner(mark) * t;
    if (mark < 8) return mix(dome_corner(mark - 4), vec3(dome_corner(mark - 4).xy, 0.0), t);
    if (mark == 8) return vec3(0.0, 0.0, 1.45 * t);
    if (mark == 9) return direction(theta * t, phi) * 0.42;
    return vec3(cos(2.0 * PI * t), sin(2.0 * PI * t), 0.0);
}

vec4 probe(int i) {
    if (i == 0) return vec4(at(vec2(0.5)), 1.0);
    if (i == 1) return vec4(on_dome(vec2(0.5)) * 1.05, 1.0);
    return vec4(1.25 * on_dome(vec2(0.5)).xy + 0.25 * normalize(on_dome(vec2(0.5)).xy + vec2(1e-6)), 0.02, 1.0);
}
"""

PROJECTED = Step(
    name="projected",
    title="What the floor gets",
    idea="Light that comes in at a slant is spread out: the floor counts the shadow of the shadow, on its own plane.",
    slides=("Basic Concepts",),
    prose=r"""
A floor with normal $\colour{n}{n}$ lies in the base of the dome. Light from the $\colour{l}{\text{patch}}$ reaches it at the
angle $\theta$; a beam at a slant covers $1/\cos\theta$ more floor, so each direction counts with its cosine:

$$\Omega_\perp = \int \cos\theta \; d\omega$$

There is a picture for that, by Nusselt. Project the patch onto the $\colour{estimate}{\text{dome}}$: that is $\omega$. Drop
that shadow straight down onto the $\colour{v}{\text{base disk}}$: its area **is** the integral. The whole dome gives the
whole disk, $\pi$, and not $2\pi$.

Bring the patch [overhead](?theta=0), [half way down](?theta=60), [to the horizon](?theta=90).
""",
    scene=Scene(
        glsl=PROJECTED_GLSL,
        surfaces=(
            Surface("patch", cells=(8, 8)),
            Surface("shadow on the dome", cells=(24, 24)),
            Surface("shadow on the disk", cells=(24, 24)),
            Surface("base disk", cells=(48, 6)),
            Surface("dome", cells=(48, 12), opacity=0.14),
        ),
        marks=(
            *(Mark(f"ray {i}", colour="quiet", line="dashed", width=0.8) for i in range(4)),
            *(Mark(f"drop {i}", colour="v", line="dotted", width=0.9) for i in range(4)),
            Mark("normal", colour="n", tip="arrow", label="n"),
            Mark("polar angle", colour="exact", segments=24, label="θ", label_at=0.5),
            Mark("rim", colour="quiet", segments=96),
        ),
        labels=(Label("ω", 1, "estimate"), Label("Ω⊥", 2, "v")),
        legend=(("l", "the patch"), ("estimate", "its shadow ω on the dome"), ("v", "and Ω⊥ on the base disk")),
        handles=(Handle("the patch", 0, ("theta", "phi")),),
        camera=Camera(azimuth=-58, elevation=24, distance=7.2, target=(0.3, 0.25, 0.55)),
    ),
    plot=Figure(
        title="The Nusselt analogue",
        sheets=(
            Sheet("patch", Term("patch_point"), colour="l", cells=(12, 12)),
            Sheet("its shadow on the dome: ω", Term("patch_point"), onto="sphere", colour="estimate"),
            Sheet("and on the disk: Ω⊥", Term("patch_point"), onto="disk", colour="v"),
        ),
        dome="hemisphere",
        disk=True,
        camera=Camera(azimuth=-58, elevation=38, distance=6.8, target=(0.2, 0.15, 0.45)),
    ),
    readouts=(
        Readout("solid angle ω", Term("solid_angle_patch"), role="exact"),
        Readout("projected Ω⊥", Term("projected_solid_angle_patch"), role="exact"),
        Readout("cos θ dA cos β / r²", Term("projected_solid_angle_patch_small"), role="estimate", against="projected Ω⊥"),
    ),
    ask=Prediction(
        question="Half of the patch stands above the horizon, straight across. It takes 0.33 sr. What does the floor get of it?",
        truth=Term("projected_solid_angle_patch", {"theta": PI / 2, "distance": 2.0, "tilt": 0.0, "width": 1.2}),
        unit="sr",
        low=0.0,
        high=0.35,
        sets={"theta": 90.0, "distance": 2.0, "tilt": 0.0, "width": 1.2},
        told="About 0.02 sr: next to nothing. What is at the horizon grazes the floor; and half of it is below.",
    ),
    notes="""
Hold a torch over the desk, then lay it nearly flat: same torch, longer spot, less light per area. Then the picture by
Nusselt: no formula is needed to see that a shadow near the rim falls on a sliver. Ask what the whole sky gives: most say
2π; the disk says π. This is the π under every Lambert surface, chapter 4 comes back to it. 5 minutes.
""",
    sources=("Deck, slide Basic Concepts (the differential solid angle)", "Nusselt 1928: graphic form factor",
             "Lambert 1760: polygon contour"),
    honesty="Exact: the contour of the polygon, cut at the horizon. The estimate is first order in w/r.",
    values=(Value("theta", 40.0, low=0.0, high=90.0), Value("phi", 25.0, more=True), Value("distance", 2.0),
            Value("tilt", 0.0, more=True), Value("width", 1.2)),
    minutes=5,
    beyond=True,
)

POLYGON = Step(
    name="polygon",
    title="Triangles, and how formulas break",
    idea="One formula serves every triangle; written with the edges it holds at every size, as printed it does not.",
    slides=("Solid Angles",),
    prose=r"""
Any flat outline is a fan of triangles, and for a triangle with corners $a, b, c$ seen from the origin

$$\tan\frac{\omega}{2} = \frac{|a\cdot(b\times c)|}{abc + (a\cdot b)c + (a\cdot c)b + (b\cdot c)a}$$

Below is the floor, coloured by what each point of it sees of the outline: left with the edges,
$a\cdot\big((b-a)\times(c-a)\big)$, right $\colour{printed}{\text{as printed}}$. On paper the two are one.

Drag the corners; the outline is shown enlarged. Then shrink it: [a metre](?size=1), [a centimetre](?size=0.01),
[a millimetre](?size=0.001), [a hair](?size=0.0001). The right half dissolves: nearly equal products are subtracted, and
seven digits are soon used up.
""",
    scene=Scene(
        glsl="""
#include "optics/outline.glsl"
#include "display/look.glsl"
uniform vec2 corner_a;
uniform vec2 corner_b;
uniform vec2 corner_c;
uniform vec2 corner_d;
uniform vec2 corner_e;
uniform int corner_count;
uniform float size;
uniform float distance;
uniform float x;
uniform float y;

const float HEIGHT = 1.5; // at which the outline is shown, enlarged to this many metres across:
const float ENLARGED = 0.9;

vec3 shown(int i) {
    vec3 corner = outline_corner(corner_a, corner_b, corner_c, corner_d, corner_e, corner_count, ENLARGED, HEIGHT, i);
    return corner;
}

vec2 middle() {
    vec2 sum = vec2(0.0);
    for (int i = 0; i < corner_count; i++) sum += shown(i).xy;
    return sum / float(corner_count);
}

vec3 surface_point(int surface, vec2 s) {
    if (surface != 1) return vec3(1.8 * (surface == 0 ? s.x - 1.0 : s.x), 2.6 * s.y - 1.3, 0.0);
    float at = s.x * float(corner_count);
    vec3 rim = mix(shown(int(at)), shown(int(at) + 1), fract(at));
    return vec3(mix(middle(), rim.xy, s.y), HEIGHT);
}

vec4 surface_value(int surface, vec2 s) { // what the middle of the floor sees
    return vec4(solid_angle_outline(corner_a, corner_b, corner_c, corner_d, corner_e, corner_count, size, distance, 0.0, 0.0));
}

vec3 shade(Surface s) {
    if (s.id == 1) return soft_light(palette[COLOUR_L], s.normal, s.v);
    float left = -abs(s.position.x), most = s.value.x;
    float seen = s.id == 0
        ? solid_angle_outline(corner_a, corner_b, corner_c, corner_d, corner_e, corner_count, size, distance, left, s.position.y)
        : solid_angle_outline_naive(corner_a, corner_b, corner_c, corner_d, corner_e, corner_count, size, distance, left, s.position.y);
    return colormap(seen / max(most, 1e-30));
}

vec3 mark_point(int mark, float t) {
    if (mark == 0) return vec3(0.0, -1.3 + 2.6 * t, 0.004);
    int i = min(mark - 1, corner_count - 1);
    if (mark < 6) return mix(shown(i), shown(i + 1), t);
    i = min(mark - 6, corner_count - 1);
    if (mark < 11) return mix(vec3(x, y, 0.0), shown(i), t);
    return vec3(x, y, 0.01);
}

vec4 probe(int i) {
    if (i < 5) return vec4(shown(min(i, corner_count - 1)), 1.0);
    if (i == 7) return vec4(x, y, 0.0, 1.0);
    return vec4(i == 5 ? -0.95 : 0.95, -1.45, 0.0, 1.0);
}
""",
        surfaces=(Surface("floor, with edges", cells=(1, 1)), Surface("outline", cells=(120, 1), opacity=0.55),
                  Surface("floor, as printed", cells=(1, 1))),
        marks=(
            Mark("divide", colour="exact", width=0.8),
            *(Mark(f"edge {i}", colour="l", width=1.2) for i in "abcde"),
            *(Mark(f"ray {i}", colour="quiet", line="dashed", width=0.7) for i in "abcde"),
            Mark("eye", colour="v", tip="eye", width=1.3, label="eye"),
        ),
        labels=(Label("with edges", 5, "estimate"), Label("as printed", 6, "printed")),
        handles=(*(Handle(f"corner {letter}", i, (f"corner_{letter}",)) for i, letter in enumerate("abcde")),
                 Handle("the eye", 7, ("x", "y"))),
        camera=Camera(azimuth=-90, elevation=34, distance=7.6, target=(0.0, 0.0, 0.42)),
    ),
    plot=Curves(
        title="Relative error in float32",
        sweep="size",
        curves=(
            Curve("exact (float64)", Term("solid_angle_outline")),
            Curve("with edges", Term("solid_angle_outline"), role="estimate", precision="float32"),
            Curve("as printed", Term("solid_angle_outline_naive"), role="printed",
                  precision="float32"),
        ),
        y_label="relative error",
        y_scale="log",
        error=True,
    ),
    readouts=(
        Readout("exact", Term("solid_angle_outline"), role="exact"),
        Readout("with edges, float32", Term("solid_angle_outline"), role="estimate",
                precision="float32", against="exact"),
        Readout("as printed, float32", Term("solid_angle_outline_naive"), role="printed",
                precision="float32", against="exact"),
    ),
    ask=Prediction(
        question="float32 carries 7 digits. The triangle is one thousandth of the distance wide. How many digits of the "
                 "printed form are still right, at worst?",
        truth=Term("digits_after_cancellation", {"size": 1e-3, "distance": 1.0}),
        unit="digits",
        choices=(Choice("7: all of them", 6.0, 9.0), Choice("about 4", 3.0, 5.0), Choice("1 or none", -1.0, 1.99)),
        sets={"size": 0.001},
        told="One or none. The products agree in six digits, and the answer is their difference.",
    ),
    notes="""
Shrink the outline slowly and say nothing; the class will. Then ask what happened to the numbers: products of size 1 are
subtracted to give 1e-6, and float32 keeps 7 digits. The remedy is to subtract first, while the numbers are still exact:
edges, then products. Make a needle by dragging two corners together. Why it matters: a lamp at ten metres, tessellated
finely, is a thousand such triangles. 7 minutes.
""",
    sources=("van Oosterom & Strackee 1983, eq. 8", "Deck, slide Solid Angles", "Goldberg 1991: cancellation in float32"),
    honesty="Exact to rounding, for flat outlines without self-crossings. The floor's colours are relative to its centre.",
    values=(
        Value("size", 0.6, low=1e-5, high=1.0), Value("distance", 1.0, low=0.5, high=4.0),
        Value("corner_count", 3, low=3, high=5),
        Value("x", -0.9, low=-1.7, high=1.7, more=True), Value("y", -0.5, low=-1.2, high=1.2, more=True),
        Value("corner_a", (-0.55, -0.45), more=True), Value("corner_b", (0.65, -0.3), more=True),
        Value("corner_c", (0.1, 0.65), more=True), Value("corner_d", (-0.4, 0.6), more=True),
        Value("corner_e", (-0.7, 0.2), more=True),
    ),
    minutes=7,
    beyond=True,
)

MESH = Step(
    name="mesh",
    title="Any shape: inside or outside?",
    idea="Add the signed solid angles of all faces: 4π inside a closed surface, 0 outside, and in between it is open.",
    slides=("Solid Angles",),
    prose=r"""
A mesh is many triangles, and solid angles add up, each with a sign: $+$ for a face that shows you its
$\colour{l}{\text{inside}}$, $-$ for one that shows its $\colour{n}{\text{outside}}$.

$$\omega = \sum_{\text{faces}} \pm\,\omega_i$$

From **inside** a closed surface every direction meets it once: $4\pi$. From **outside** each direction that goes in comes
out again: $0$. Nothing in between, however knotted the shape.

Drag the eye [through the wall](?shape=0&eye=0.92,0,0) and watch the sum jump. A shape [with a hole](?shape=1&eye=0,0,0) has every value: the
closed one's, less the hole. This sum is how modelling programs decide what is inside. Drop a mesh of your own on the window.
""",
    scene=Scene(
        glsl="""
#include "optics/solid_angle_flat.glsl"
#include "display/look.glsl"
uniform sampler2D triangles;
uniform vec3 eye;

vec3 mesh_point(int surface, vec3 p) {
    return p;
}

vec3 corner(int face, int c) {
    return texelFetch(triangles, ivec2(3 * (face % 256) + c, face / 256), 0).xyz - eye;
}

vec4 mesh_value(int surface, vec3 p, int face) {
    return vec4(solid_angle_triangle_signed(corner(face, 0), corner(face, 1), corner(face, 2)));
}

vec3 shade(Surface s) {
    // what stands between the camera and the eye point is cut away
    vec3 to_camera = normalize(camera_position - eye);
    if (dot(s.position - eye, to_camera) > 0.12) discard;
    float seen = s.value.x;
    float share = clamp(0.35 + 0.09 * log2(abs(seen) * 4000.0 + 1.0), 0.35, 1.0);
    vec3 tint = seen > 0.0 ? palette[COLOUR_L] : palette[COLOUR_N];
    return soft_light(mix(palette[COLOUR_QUIET], tint, share), s.normal, s.v);
}

vec3 mark_point(int mark, float t) {
    vec3 way = mark == 0 ? vec3(1.0, 0.0, 0.0) : mark == 1 ? vec3(0.0, 1.0, 0.0) : vec3(0.0, 0.0, 1.0);
    return mark == 3 ? eye : eye + way * (0.36 * t - 0.18);
}

vec4 probe(int i) {
    return vec4(eye, 1.0);
}
""",
        surfaces=(Surface("mesh", mesh=True),),
        marks=(
            Mark("eye x", colour="v"), Mark("eye y", colour="v"), Mark("eye z", colour="v"),
            Mark("eye", colour="v", tip="eye", width=1.6, label="eye"),
        ),
        handles=(Handle("the eye", 0, ("eye",)),),
        camera=Camera(azimuth=-60, elevation=24, distance=5.4),
        meshes=("knot", "bowl", "sphere", "cube"),
        legend=(("l", "shows its inside, +"), ("n", "shows its outside, -")),
    ),
    plot=Faces(title="Each face as the eye sees it"),
    readouts=(
        Readout("sum of all faces", Term("solid_angle_mesh"), role="exact"),
        Readout("the same in float32", Term("solid_angle_mesh"), role="estimate", precision="float32",
                against="sum of all faces"),
        Readout("times around the eye", Term("winding_number"), unit=""),
    ),
    ask=Prediction(
        question="The bowl is a sphere with a round hole of 50° half angle. What does it take up, seen from its centre?",
        truth=Term("sphere_less_cone", {"half_angle": 50 * PI / 180}),
        unit="sr",
        low=0.0,
        high=12.57,
        sets={"shape": 1, "eye": (0.0, 0.0, 0.0)},
        told="10.3 sr: all of 4π, less the hole's 2π(1 - cos 50°) = 2.24.",
    ),
    notes="""
Ask first: is a point inside a trefoil knot's tube or outside, and how would a program know? Then drag the eye through the
wall: the sum jumps by 4π and never stops in between. Move it to the hole of the bowl: there it does. A student's own mesh
with a flipped or missing face gives neither 0 nor 4π; that is a test of meshes, and one they can use. 6 minutes.
""",
    sources=("van Oosterom & Strackee 1983", "Jacobson, Kavan & Sorkine-Hornung 2013: generalized winding numbers",
             "Deck, slide Solid Angles"),
    honesty="Exact for the mesh as given; a sphere of triangles is a polyhedron. With the eye on a face the sum is half way.",
    values=(Value("shape", 0, choices=("knot", "bowl", "sphere", "cube")), Value("eye", (0.0, 0.0, 0.0))),
    minutes=6,
    beyond=True,
)

PYTHON_STUB = '''import numpy as np


def solid_angle_triangle(a, b, c):
    """Solid angle in sr of the triangle a, b, c seen from the origin. a, b, c: (..., 3), any length but 0."""
    return np.zeros(np.broadcast_shapes(a.shape, b.shape, c.shape)[:-1])
'''
PYTHON_SOLUTION = '''import numpy as np


def solid_angle_triangle(a, b, c):
    """van Oosterom and Strackee 1983, with edges: subtract while the numbers are exact, then multiply."""
    def dot(p, q):
        return np.sum(p * q, axis=-1)

    length_a, length_b, length_c = (np.sqrt(dot(p, p)) for p in (a, b, c))
    volume = np.abs(dot(a, np.cross(b - a, c - a)))
    below = length_a * length_b * length_c + dot(a, b) * length_c + dot(a, c) * length_b + dot(b, c) * length_a
    return 2 * np.arctan2(volume, below)
'''
GLSL_STUB = """#include "core/angle.glsl" // arctan2(y, x); the built-in atan errs by up to 2e-5

float solid_angle_triangle(vec3 a, vec3 b, vec3 c) {
    return 0.0;
}
"""
GLSL_SOLUTION = """#include "core/angle.glsl"

float solid_angle_triangle(vec3 a, vec3 b, vec3 c) {
    float x = length(a), y = length(b), z = length(c);
    float volume = abs(dot(a, cross(b - a, c - a)));
    return 2.0 * arctan2(volume, x * y * z + dot(a, b) * z + dot(a, c) * y + dot(b, c) * x);
}
"""

CHAPTER = Chapter(
    title="Solid angle",
    idea="Directions can be measured: in steradians, as areas on the unit sphere.",
    steps=(ANGLE, PATCH, CONE, DIFFERENTIAL, PROJECTED, POLYGON, MESH),
    exercises=(
        Exercise(
            name="triangle",
            function="solid_angle_triangle",
            task="Write the solid angle of a triangle seen from the origin, so that it still holds for one a millimetre "
                 "wide at a metre's distance, in float32.",
            slide="Solid Angles",
            stubs={"python": PYTHON_STUB, "glsl": GLSL_STUB},
            solutions={"python": PYTHON_SOLUTION, "glsl": GLSL_SOLUTION},
            checks=(
                Check({"a": ((1.0, 0.0, 0.0),), "b": ((0.0, 1.0, 0.0),), "c": ((0.0, 0.0, 1.0),)},
                      "an octant of the sphere: π/2"),
                Check({"a": ((0.3, -0.2, 1.5), (2.0, 1.0, 0.5)), "b": ((1.25, 0.75, 2.0), (-1.0, 2.0, 0.75)),
                       "c": ((-0.5, 1.0, 1.75), (0.5, -1.5, 1.25))}, "triangles of ordinary size"),
                Check({"a": ((-1.0, -1.0, 0.001),), "b": ((1.0, -1.0, 0.001),), "c": ((0.0, 1.0, 0.001),)},
                      "nearly half of everything: 2π, where atan without a second argument goes wrong"),
                Check({"a": ((0.0, 0.0, 1.0), (-0.548, 0.399, 1.103), (0.548, 0.516, 0.843)),
                       "b": ((0.001, 0.0, 1.0), (-0.5478, 0.3987, 1.1027), (0.5481, 0.5161, 0.8429)),
                       "c": ((0.0, 0.001, 1.0), (-0.548, 0.3988, 1.1029), (0.5472, 0.516, 0.8422))},
                      "a millimetre at a metre"),
                Check({"a": ((0.313, -0.271, 0.97),), "b": ((0.313012, -0.270997, 0.970003),),
                       "c": ((0.312995, -0.27099, 0.969992),)},
                      "a hundredth of a millimetre at a metre", hidden=True),
            ),
        ),
    ),
    terms={
        "radian": "arc over radius; a full circle has 2π",
        "steradian": "area on a sphere over its radius squared; everything has 4π",
        "solid angle": "how much of all directions a thing takes up, in steradians",
        "projected solid angle": "solid angle with every direction counted by its cosine to a normal, in steradians",
        "Nusselt analogue": "the shadow of the shadow: onto the unit sphere, then down onto the base disk",
        "winding number": "the signed solid angle of a mesh over 4π: how often it goes around a point",
        "cancellation": "digits lost when nearly equal numbers are subtracted",
    },
)
