#include "optics/smith.glsl"
#include "optics/spherical.glsl"
#include "optics/vgroove.glsl"

vec4 half_cosines(float theta_l, float theta_v, float phi) {
    // n.h, n.v, n.l and l.h of directions given by angles
    vec3 s = light_and_view(theta_l, theta_v, phi);
    float size = length(s);
    return vec4(size > 0.0 ? max(s.z, 0.0) / size : 1.0, max(cos(theta_v), 0.0), max(cos(theta_l), 0.0), 0.5 * size);
}

float masking_at(float theta_l, float theta_v, float phi) {
    // Torrance & Sparrow 1967
    vec4 c = half_cosines(theta_l, theta_v, phi);
    return g_masking(c.x, c.y, c.w);
}

float shadowing_at(float theta_l, float theta_v, float phi) {
    // Torrance & Sparrow 1967
    vec4 c = half_cosines(theta_l, theta_v, phi);
    return g_shadowing(c.x, c.z, c.w);
}

float vgroove_at(float theta_l, float theta_v, float phi) {
    // Torrance & Sparrow 1967
    vec4 c = half_cosines(theta_l, theta_v, phi);
    return g_vgroove(c.x, c.y, c.z, c.w);
}

float branch_at(float theta_l, float theta_v, float phi) {
    // Which of 1 (0), masking (1) and shadowing (2) is the least
    vec4 c = half_cosines(theta_l, theta_v, phi);
    return g_branch(c.x, c.y, c.z, c.w);
}

float crease_gap(float theta_l, float theta_v, float phi) {
    // Geometric Term (3): the next of the three terms less the least; 0 on a crease
    vec4 c = half_cosines(theta_l, theta_v, phi);
    if (c.w <= 0.0) return 1.0;
    float low = 2.0 * c.x * min(c.y, c.z) / c.w, high = 2.0 * c.x * max(c.y, c.z) / c.w;
    return low < 1.0 ? min(high, 1.0) - low : low - 1.0;
}

float lambda_beckmann_at(float theta_v, float m) {
    // Smith 1967
    return lambda_beckmann_slope(m * sin(theta_v) / max(cos(theta_v), 1e-30));
}

float lambda_ggx_at(float theta_v, float alpha) {
    // Walter et al. 2007
    return lambda_ggx_slope(alpha * sin(theta_v) / max(cos(theta_v), 1e-30));
}

float g1_beckmann_at(float theta_v, float m) {
    // Smith 1967
    return 1.0 / (1.0 + lambda_beckmann_at(theta_v, m));
}

float smith_separable_at(float theta_l, float theta_v, float m) {
    // Smith 1967
    return g1_beckmann_at(theta_v, m) * g1_beckmann_at(theta_l, m);
}

float smith_correlated_at(float theta_l, float theta_v, float m) {
    // Heitz 2014
    return 1.0 / (1.0 + lambda_beckmann_at(theta_v, m) + lambda_beckmann_at(theta_l, m));
}
