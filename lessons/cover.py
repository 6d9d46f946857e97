"""The first picture of the course: five squares in space, and what each of them takes up of the sphere."""

from app.lesson import Camera, Scene, Surface

SQUARES = 5

COVER = Scene(
    glsl="""
#include "optics/square_patch.glsl"
#include "display/look.glsl"

const float TURNS[5] = float[5](0.3, 1.55, 2.9, 4.15, 5.35);
const float FALLS[5] = float[5](0.95, 0.55, 1.1, 0.7, 1.2);
const float AWAYS[5] = float[5](2.1, 1.6, 1.75, 2.3, 1.9);
const float TILTS[5] = float[5](0.3, -0.5, 0.7, 0.1, -0.35);
const float SIDES[5] = float[5](1.0, 0.75, 0.95, 1.1, 0.7);

vec3 at(int i, vec2 s) {
    return patch_point(FALLS[i], TURNS[i], AWAYS[i], TILTS[i], SIDES[i], s.x, s.y);
}

vec3 tint(int i) {
    if (i == 0) return palette[COLOUR_L];
    if (i == 1) return palette[COLOUR_V];
    if (i == 2) return palette[COLOUR_R];
    if (i == 3) return palette[COLOUR_N];
    return palette[COLOUR_H];
}

vec3 surface_point(int surface, vec2 s) {
    if (surface < 5) return at(surface, s);
    if (surface < 10) return 1.004 * normalize(at(surface - 5, s));
    if (surface < 15) return vec3(normalize(at(surface - 10, s)).xy, 0.004);
    if (surface == 15) return vec3(s.y * cos(2.0 * PI * s.x), s.y * sin(2.0 * PI * s.x), 0.0);
    return cap_point(0.5 * PI, s.x, s.y);
}

vec3 shade(Surface s) {
    float line = grid_lines(s.st, vec2(6.0));
    if (s.id < 5) return soft_light(mix(tint(s.id), tint(s.id) * 0.45, line), s.normal, s.v);
    if (s.id < 10) return soft_light(mix(tint(s.id - 5), tint(s.id - 5) * 0.45, line), normalize(s.position), s.v);
    if (s.id < 15) return tint(s.id - 10) * 0.6;
    if (s.id == 15) return mix(mix(background, palette[COLOUR_QUIET], 0.15), palette[COLOUR_QUIET], grid_lines(s.st, vec2(24.0, 6.0)) * 0.4);
    return glass(s.st, vec2(24.0, 6.0));
}
""",
    surfaces=(
        *(Surface(f"square {i}", cells=(6, 6)) for i in range(SQUARES)),
        *(Surface(f"shadow {i}", cells=(20, 20)) for i in range(SQUARES)),
        *(Surface(f"floor shadow {i}", cells=(20, 20)) for i in range(SQUARES)),
        Surface("disk", cells=(96, 6)),
        Surface("dome", cells=(64, 24), opacity=0.16),
    ),
    camera=Camera(azimuth=-60, elevation=24, distance=7.6, target=(0.0, 0.0, 0.5)),
)
