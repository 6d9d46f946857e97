#include "core/constants.glsl"
#include "core/angle.glsl"
#include "optics/beckmann.glsl"
#include "optics/fresnel.glsl"
#include "optics/ggx.glsl"
#include "optics/smith.glsl"
#include "optics/spherical.glsl"

float brdf_cook_torrance_smith(vec3 n, vec3 l, vec3 v, float m, float f0) {
    // Heitz 2014, Understanding the Masking-Shadowing Function: G = 1 / (1 + Lambda_l + Lambda_v)
    float n_dot_l = dot(n, l), n_dot_v = dot(n, v);
    if (min(n_dot_l, n_dot_v) <= 0.0) return 0.0;
    m = max(m, SMOOTHEST);
    float open_ = 1.0 + lambda_beckmann(n_dot_l, m) + lambda_beckmann(n_dot_v, m);
    return d_beckmann(n, l + v, m) / (4.0 * n_dot_l * open_ * n_dot_v) * f_schlick(0.5 * length(l + v), f0);
}

float brdf_ggx(vec3 n, vec3 l, vec3 v, float alpha, float f0) {
    // Walter et al. 2007; Heitz 2014: G = 1 / (1 + Lambda_l + Lambda_v)
    float n_dot_l = dot(n, l), n_dot_v = dot(n, v);
    if (min(n_dot_l, n_dot_v) <= 0.0) return 0.0;
    alpha = max(alpha, SMOOTHEST);
    float open_ = 1.0 + lambda_ggx(n_dot_l, alpha) + lambda_ggx(n_dot_v, alpha);
    return d_ggx(n, l + v, alpha) / (4.0 * n_dot_l * open_ * n_dot_v) * f_schlick(0.5 * length(l + v), f0);
}

float cook_torrance_smith_at(float theta_l, float theta_v, float phi, float m, float f0) {
    // Heitz 2014, from angles, the eye in the xz-plane
    return brdf_cook_torrance_smith(vec3(0.0, 0.0, 1.0), direction(theta_l, phi), direction(theta_v, 0.0), m, f0);
}

float albedo_ggx(float theta_v, float alpha, float f0) {
    // Half-vector quadrature: x = tan a / alpha in pieces, each three times as far out, the azimuth up to the horizon
    alpha = max(alpha, SMOOTHEST);
    float t = theta_v, n_dot_v = max(cos(t), 1e-7), sine = sin(t), seen = lambda_ggx_slope(alpha * sine / n_dot_v);
    vec2 bend = vec2(0.25 * PI - 0.5 * t, 0.25 * PI + 0.5 * t);
    bend = min(vec2(sin(bend.x) / cos(bend.x), bend.y < 1.5707 ? sin(bend.y) / cos(bend.y) : 1e4) / alpha, 1e9);
    float low = 0.0, high = 0.0, next = 1.0 / 3.0, sum = 0.0;
    for (int piece = 0; piece < 14 && high < bend.y; piece++) {
        low = high;
        if (low >= next) next *= 3.0;
        high = next > 7000.0 ? bend.y : min(next, bend.y);
        if (bend.x > low) high = min(high, bend.x);
        float wide = high - low;
        for (int i = 0; i < 24; i++) {
            float psi = 0.5 * PI * LEGENDRE_X[i], x = low + wide * sin(psi) * sin(psi), part = 0.0;
            float c = 1.0 / sqrt(1.0 + alpha * x * (alpha * x)), a = c * n_dot_v, b = max(alpha * x * c * sine, 1e-30);
            float end = arccos(clamp((0.5 * n_dot_v / c - a) / b, -1.0, 1.0));
            for (int k = 0; k < 24; k++) {
                float turn = 0.5 * PI * LEGENDRE_X[k], u = a + b * cos(end * sin(turn) * sin(turn));
                float hidden = seen + lambda_ggx(clamp(2.0 * u * c - n_dot_v, 1e-30, 1.0), alpha);
                part += LEGENDRE_W[k] * sin(2.0 * turn) * max(u, 0.0) * f_schlick(u, f0) / (1.0 + hidden);
            }
            float d = 2.0 * x / (PI * (1.0 + x * x) * (1.0 + x * x)); // D cos a
            sum += LEGENDRE_W[i] * wide * sin(2.0 * psi) * d * part * end / (c * n_dot_v) * (0.25 * PI * PI);
        }
    }
    return sum;
}
