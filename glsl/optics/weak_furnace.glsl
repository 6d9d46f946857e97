#include "core/angle.glsl"
#include "core/tilts.glsl"
#include "optics/smith.glsl"

float capped_tangent(float theta) {
    // of an angle whose cosine is at least 1e-7
    return sin(theta) / max(cos(theta), 1e-7);
}

float all_azimuths(float steep) {
    // int max(0, v.h) dphi / (2 pi cos a cos theta_v), steep = tan a tan theta_v
    float s = max(steep, 1.0), k = 1.0 / s, side = sqrt((1.0 - k) * (1.0 + k));
    return 1.0 - arctan2(side, k) / PI + s * side / PI;
}

float furnace_ring(float theta_h, float theta_v, float m, int geometry) {
    // Heitz 2014: what the facets of one tilt show, over their share of what the plate shows; in V-grooves always 1
    if (geometry == 1) return 1.0;
    float every = all_azimuths(capped_tangent(theta_h) * capped_tangent(theta_v));
    return geometry == 0 ? every : every / (1.0 + lambda_beckmann_slope(m * capped_tangent(theta_v)));
}

float weak_furnace(float theta_v, float m, int geometry) {
    // Heitz 2014, the weak white furnace: int D G1 max(0, v.h) dw_h / n.v
    float slope = m * capped_tangent(theta_v), piece = 0.0, sum = 0.0;
    for (int i = 0; i < TILTS; i++) {
        vec2 x = tilt_node(i, 1.0 / max(slope, 1e-30), 6.5);
        piece += x.y * 2.0 * x.x * exp(-x.x * x.x) * (geometry == 1 ? 1.0 : all_azimuths(slope * x.x));
        if (i % 12 == 11) sum += piece, piece = 0.0; // rounding stays small
    }
    return geometry < 2 ? sum : sum / (1.0 + lambda_beckmann_slope(slope));
}

float weak_furnace_rational(float theta_v, float m) {
    // Walter et al. 2007, the fit in Smith's place
    return g1_beckmann_rational(max(cos(theta_v), 1e-7), m) * weak_furnace(theta_v, m, 0);
}

vec2 sinking_azimuth(float steep, float tangent) {
    // From which azimuth of h on l is below the horizon, and its sine; steep = tan a, tangent = tan theta_v
    float top = (steep - 1.0) * (steep + 1.0), below = 2.0 * steep * tangent;
    float k = below > 0.0 ? clamp(top / below, -1.0, 1.0) : sign(top), side = sqrt((1.0 - k) * (1.0 + k));
    return vec2(arctan2(side, k), side);
}

float albedo_without_g(float theta_v, float m) {
    // Cook & Torrance 1982 with 1/4 for 1/pi, F = 1 and G = 1: int D / (4 n.v) dw_l over the hemisphere
    float t = capped_tangent(theta_v), half_way = t + sqrt(1.0 + t * t), piece = 0.0, sum = 0.0;
    for (int i = 0; i < TILTS; i++) {
        vec2 x = tilt_node(i, 1.0 / (half_way * max(m, 1e-30)), half_way / max(m, 1e-30));
        vec2 turned = sinking_azimuth(m * x.x, t);
        piece += x.y * 2.0 * x.x * exp(-x.x * x.x) * (turned.x + m * x.x * t * turned.y);
        if (i % 12 == 11) sum += piece, piece = 0.0; // rounding stays small
    }
    return sum / PI;
}

float albedo_smith(float theta_v, float m, int geometry) {
    // Walter et al. 2007, Heitz 2014: the same with Smith's G, 3 correlated, else separable
    float t = capped_tangent(theta_v), half_way = t + sqrt(1.0 + t * t), n_dot_v = max(cos(theta_v), 1e-7), piece = 0.0, sum = 0.0;
    for (int i = 0; i < TILTS; i++) {
        vec2 x = tilt_node(i, 1.0 / (half_way * max(m, 1e-30)), half_way / max(m, 1e-30));
        float steep = m * x.x, phi = sinking_azimuth(steep, t).x, ring = 0.0;
        for (int j = 0; j < 12; j++) {
            float lit = 1.0 + steep * t * cos(phi * GAUSS_X[j]);
            float n_dot_l = clamp(n_dot_v * (2.0 * lit / (1.0 + steep * steep) - 1.0), 0.0, 1.0);
            ring += GAUSS_W[j] * lit * (geometry == 3 ? g_smith_correlated(n_dot_v, n_dot_l, m) : g_smith_separable(n_dot_v, n_dot_l, m));
        }
        piece += x.y * 2.0 * x.x * exp(-x.x * x.x) * phi * ring;
        if (i % 12 == 11) sum += piece, piece = 0.0; // rounding stays small
    }
    return sum / PI;
}
