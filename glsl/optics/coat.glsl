#include "core/constants.glsl"
#include "core/angle.glsl"
#include "core/gauss.glsl"
#include "optics/cook_torrance.glsl"
#include "optics/fresnel.glsl"

// coupling 0: none; 1: 1 - F(l.h); 2: 1 - F(n.l); 3: on the way in and on the way out

float passed_share(float l_dot_h, float f0) {
    // Schlick 1994: 1 - F, without a difference of near numbers
    float c = max(l_dot_h, 0.0), x = 1.0 - c;
    return (1.0 - f0) * c * (1.0 + x * (1.0 + x * (1.0 + x * (1.0 + x))));
}

float body_coupled(float n_dot_l, float n_dot_v, float rho, float f0) {
    // Shirley et al. 1997; Kelemen and Szirmay-Kalos 2001: in, out, and 1 - F_avg = 20/21 (1 - f0) below
    return rho * passed_share(n_dot_l, f0) * passed_share(n_dot_v, 0.0) * (1.05 / PI);
}

float body_share(float n_dot_l, float n_dot_v, float l_dot_h, float f0, int coupling) {
    // Plausible Shading - BRDFs: what is left of rho / pi
    if (coupling == 0) return 1.0;
    if (coupling == 1) return passed_share(l_dot_h, f0);
    if (coupling == 2) return passed_share(n_dot_l, f0);
    return PI * body_coupled(n_dot_l, n_dot_v, 1.0, f0);
}

float brdf_coated(vec3 n, vec3 l, vec3 v, float rho, float m, float f0, int coupling) {
    // Plausible Shading - BRDFs: Cook-Torrance over a matt body
    float n_dot_l = dot(n, l), n_dot_v = dot(n, v);
    if (min(n_dot_l, n_dot_v) <= 0.0) return 0.0;
    float share = body_share(n_dot_l, n_dot_v, 0.5 * length(l + v), f0, coupling);
    return brdf_cook_torrance(n, l, v, m, f0) + rho / PI * share;
}

float albedo_body(float theta_v, float rho, float f0, int coupling) {
    // By the angle g between light and eye, l.h = cos(g / 2), the azimuth in closed form
    if (coupling == 0) return rho;
    if (coupling == 2) return rho * (1.0 - f_average_schlick(f0));
    if (coupling != 1) return rho * passed_share(cos(theta_v), f0);
    float sum = 0.0, n_dot_v = cos(theta_v), sine = sin(theta_v);
    for (int piece = 0; piece < 3; piece++) {
        float low = piece == 0 ? 0.0 : piece == 1 ? 0.5 * PI - theta_v : 0.5 * PI;
        float wide = piece == 0 ? 0.5 * PI - theta_v : theta_v;
        for (int i = 0; i < 12; i++) {
            float turn = 0.5 * PI * GAUSS_X[i], g = low + wide * sin(turn) * sin(turn);
            float a = cos(g) * n_dot_v, b = max(sin(g) * sine, 1e-30), psi = arccos(clamp(-a / b, -1.0, 1.0));
            float got = 2.0 * (a * psi + b * sin(psi));
            sum += 0.5 * PI * GAUSS_W[i] * wide * sin(2.0 * turn) * passed_share(cos(0.5 * g), f0) * got * sin(g);
        }
    }
    return rho * sum / PI;
}

float albedo_coated(float theta_v, float rho, float f0, int coupling) {
    // D13 of the optics reference: the mirror of a smooth coat, and the body
    float s = sin(0.5 * theta_v), less = min(2.0 * s * s, 1.0), x2 = less * less; // 1 - n.v
    return f0 + (1.0 - f0) * x2 * x2 * less + albedo_body(theta_v, rho, f0, coupling);
}
