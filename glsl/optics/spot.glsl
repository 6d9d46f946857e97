#include "core/constants.glsl"

float spot_linear(float off_axis, float hotspot, float falloff) {
    // Spotlights (2), clamped; both differences of cosines as products of sines. H >= F: a hard edge at F
    if (hotspot >= falloff) return off_axis <= falloff ? 1.0 : 0.0;
    float above = sin(0.5 * (falloff - off_axis)) * sin(0.5 * (falloff + off_axis));
    return clamp(above / (sin(0.5 * (falloff - hotspot)) * sin(0.5 * (falloff + hotspot))), 0.0, 1.0);
}

float spot_linear_naive(float off_axis, float hotspot, float falloff) {
    // Spotlights (2), clamped, by the cosines; nobody asks whether the hotspot is inside the falloff
    return clamp((cos(off_axis) - cos(falloff)) / (cos(hotspot) - cos(falloff)), 0.0, 1.0);
}

float spot_smooth(float off_axis, float hotspot, float falloff) {
    // Spotlights (2) with smoothstep: no crease where the zones meet, and the same flux
    float t = spot_linear(off_axis, hotspot, falloff);
    return t * t * (3.0 - 2.0 * t);
}

float spot_linear_cos(float cosine, float hotspot, float falloff) {
    // Spotlights (2) from the cosine -l.d itself
    float edge = sin(0.5 * falloff), q = 0.5 * (1.0 - cosine);
    if (hotspot >= falloff) return q <= edge * edge ? 1.0 : 0.0;
    return clamp((edge * edge - q) / (sin(0.5 * (falloff - hotspot)) * sin(0.5 * (falloff + hotspot))), 0.0, 1.0);
}

float spot_as_printed(float off_axis, float hotspot, float falloff, float threshold) {
    // Spotlights (2) as printed: the last threshold is another angle than the falloff, and nothing is clamped
    if (off_axis < hotspot) return 1.0;
    if (off_axis >= threshold) return 0.0;
    float above = sin(0.5 * (falloff - off_axis)) * sin(0.5 * (falloff + off_axis)); // 1 - (cos H - cos a) / (cos H - cos F)
    return above / (sin(0.5 * (falloff - hotspot)) * sin(0.5 * (falloff + hotspot)));
}

float spot_flux(float radiant_intensity, float hotspot, float falloff) {
    // Spotlights (2): 2 pi I ((1 - cos H) + (cos H - cos F) / 2), linear or smooth; H >= F: the cone of F
    float inner = sin(0.5 * min(hotspot, falloff)), outer = sin(0.5 * falloff);
    return 2.0 * PI * radiant_intensity * (inner * inner + outer * outer);
}

float spot_intensity(float radiant_flux, float hotspot, float falloff) {
    // Spotlights (2): the intensity in the hotspot that makes up a flux
    return radiant_flux / spot_flux(1.0, hotspot, falloff);
}

float spot_read(float off_axis, float hotspot, float falloff, float threshold, int edge, int reading) {
    // Spotlights (2), as a program may read it: 0 as meant, 1 full angles taken for half ones, 2 +l.d in place of -l.d
    float wide = reading == 1 ? 2.0 : 1.0, angle = reading == 2 ? PI - off_axis : off_axis;
    if (edge == 2) return spot_as_printed(angle, wide * hotspot, wide * falloff, threshold);
    float share = spot_linear(angle, wide * hotspot, wide * falloff);
    return edge == 1 ? share * share * (3.0 - 2.0 * share) : share;
}

float spot_read_flux(float radiant_intensity, float hotspot, float falloff, int reading) {
    // Spotlights (2): what such a program sends before the lamp; with the other sign all of it goes behind
    float wide = reading == 1 ? 2.0 : 1.0;
    return reading == 2 ? 0.0 : spot_flux(radiant_intensity, wide * hotspot, wide * falloff);
}
