#include "core/constants.glsl"
#include "core/angle.glsl"
#include "core/gauss.glsl"
#include "optics/beckmann.glsl"
#include "optics/fresnel.glsl"
#include "optics/spherical.glsl"

float cook_torrance_dg(vec3 n, vec3 l, vec3 v, float m) {
    // The Cook - Torrance Model (2), with 1/4: D G / (4 n.l n.v) by s = l + v, and n.s = n.l + n.v; nothing small divides
    vec3 s = l + v;
    float n_dot_l = dot(n, l), n_dot_v = dot(n, v), low = min(n_dot_l, n_dot_v), high = max(n_dot_l, n_dot_v);
    if (low <= 0.0) return 0.0;
    return d_beckmann(n, s, m) / (4.0 * high * max(low, 0.25 * dot(s, s) / (low + high)));
}

float brdf_cook_torrance(vec3 n, vec3 l, vec3 v, float m, float f0) {
    // The Cook - Torrance Model (2), with 1/4; Cook and Torrance 1982
    return cook_torrance_dg(n, l, v, m) * f_schlick(0.5 * length(l + v), f0);
}

float brdf_cook_torrance_printed(vec3 n, vec3 l, vec3 v, float m, float f0) {
    // The Cook - Torrance Model (2), as printed, with 1/pi
    return 4.0 / PI * brdf_cook_torrance(n, l, v, m, f0);
}

float cook_torrance_at(float theta_l, float theta_v, float phi, float m, float f0) {
    // The Cook - Torrance Model (2), from angles, the eye in the xz-plane
    return brdf_cook_torrance(vec3(0.0, 0.0, 1.0), direction(theta_l, phi), direction(theta_v, 0.0), m, f0);
}

float cook_torrance_printed_at(float theta_l, float theta_v, float phi, float m, float f0) {
    // The Cook - Torrance Model (2), as printed, from angles
    return brdf_cook_torrance_printed(vec3(0.0, 0.0, 1.0), direction(theta_l, phi), direction(theta_v, 0.0), m, f0);
}

float albedo_cook_torrance(float theta_v, float m, float f0) {
    // Half-vector quadrature: x = tan a / m in pieces between its bends, and the facet's azimuth between those of G;
    // G u <= 2 c n.v keeps all terms positive, u = l.h
    m = max(m, SMOOTHEST);
    float t = theta_v, q = 0.25 * PI, n_dot_v = max(cos(t), 1e-7), sine = sin(t), sum = 0.0;
    float bend[7] = float[7](q - 0.5 * t, q + 0.5 * t, 2.0 * q - t, t, (2.0 * q - t) / 3.0, (2.0 * q + t) / 3.0, q);
    float low = 0.0, high = 0.0;
    for (int piece = 0; piece < 10 && high < 6.5; piece++) {
        low = high;
        high = low < 1.5 ? 1.5 : low < 3.0 ? 3.0 : 6.5;
        for (int i = 0; i < 7; i++) {
            float cut = bend[i] < 1.5707 ? sin(bend[i]) / (cos(bend[i]) * m) : 6.5;
            if (cut > low) high = min(high, cut);
        }
        float wide = high - low;
        int count = wide > 0.0 ? 12 : 0; // no constant: a compiler would write out all rounds
        for (int i = 0; i < count; i++) {
            float psi = 0.5 * PI * GAUSS_X[i], x = low + wide * sin(psi) * sin(psi);
            float c = 1.0 / sqrt(1.0 + m * x * (m * x)), s = m * x * c, a = c * n_dot_v, b = max(s * sine, 1e-30);
            bool flat_one = 2.0 * c * c > 1.0;
            float rises = flat_one ? 2.0 * a / (4.0 * c * c - 1.0) : n_dot_v / c, falls = flat_one ? 2.0 * a : rises;
            float end[4] = float[4](arccos(clamp((0.5 * n_dot_v / c - a) / b, -1.0, 1.0)),
                arccos(clamp((rises - a) / b, -1.0, 1.0)), arccos(clamp((falls - a) / b, -1.0, 1.0)), 0.0);
            float turned = 0.0;
            for (int part = 0; part < 3; part++) {
                float span = end[part] - end[part + 1];
                for (int k = 0; k < 12 && span > 0.0; k++) {
                    float u = a + b * cos(end[part + 1] + span * GAUSS_X[k]);
                    float g_u = part == 0 ? max(0.0, 4.0 * c * c * u - 2.0 * a) : part == 1 ? u : 2.0 * a;
                    turned += GAUSS_W[k] * span * g_u * f_schlick(u, f0);
                }
            }
            sum += 0.5 * PI * GAUSS_W[i] * wide * sin(2.0 * psi) * 2.0 * x * exp(-x * x) * turned / (PI * c * n_dot_v);
        }
    }
    return sum;
}

float albedo_cook_torrance_printed(float theta_v, float m, float f0) {
    // The Cook - Torrance Model (2), as printed, with 1/pi
    return 4.0 / PI * albedo_cook_torrance(theta_v, m, f0);
}
