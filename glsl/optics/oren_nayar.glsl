#include "core/angle.glsl"
#include "optics/spherical.glsl"

float brdf_oren_nayar(vec3 n, vec3 l, vec3 v, float rho, float sigma) {
    // Oren and Nayar 1994, Generalization of Lambert's reflectance model: the qualitative model
    float n_dot_l = dot(n, l), n_dot_v = dot(n, v), s2 = sigma * sigma;
    if (n_dot_l <= 0.0 || n_dot_v <= 0.0) return 0.0;
    float s = dot(l - n_dot_l * n, v - n_dot_v * n);
    float a = (s2 + 0.66) / (2.0 * s2 + 0.66), b = 0.45 * s2 / (s2 + 0.09);
    return rho / PI * (a + b * max(0.0, s) / max(n_dot_l, n_dot_v));
}

float brdf_oren_nayar_at(float theta_l, float theta_v, float phi, float rho, float sigma) {
    // Oren and Nayar 1994, at angles
    return brdf_oren_nayar(vec3(0.0, 0.0, 1.0), light_direction(theta_l, phi), view_direction(theta_v), rho, sigma);
}

float albedo_oren_nayar(float n_dot_v, float rho, float sigma) {
    // Portsmouth, Kutz and Hill 2025 integrate the same term
    float mu = min(n_dot_v, 1.0), s = sqrt((1.0 - mu) * (1.0 + mu)), s2 = sigma * sigma;
    float q = s * (arctan2(s, mu) - s * mu) + 2.0 / 3.0 * s * mu * (1.0 + s + s * s) / (1.0 + s);
    float a = (s2 + 0.66) / (2.0 * s2 + 0.66), b = 0.45 * s2 / (s2 + 0.09);
    return rho * (a + b * q / PI);
}
