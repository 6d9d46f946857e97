#include "optics/cook_torrance.glsl"
#include "optics/geometry_term.glsl"
#include "optics/weak_furnace.glsl"

float geometry_term(float n_dot_h, float n_dot_v, float n_dot_l, float l_dot_h, float m, int geometry) {
    // 0 none; 1 Torrance & Sparrow 1967; 2 Smith 1967, separable; 3 Heitz 2014, height-correlated
    if (geometry == 0) return 1.0;
    if (geometry == 1) return g_vgroove(n_dot_h, n_dot_v, n_dot_l, l_dot_h);
    return geometry == 2 ? g_smith_separable(n_dot_v, n_dot_l, m) : g_smith_correlated(n_dot_v, n_dot_l, m);
}

float geometry_at(float theta_l, float theta_v, float phi, float m, int geometry) {
    // The same from angles
    vec4 c = half_cosines(theta_l, theta_v, phi);
    return geometry_term(c.x, c.y, c.z, c.w, m, geometry);
}

float brdf_geometry(vec3 n, vec3 l, vec3 v, float m, float f0, int geometry) {
    // Geometric Term (1), with 1/4: D G F / (4 n.l n.v)
    vec3 s = l + v;
    float n_dot_l = dot(n, l), n_dot_v = dot(n, v), size = length(s);
    if (min(n_dot_l, n_dot_v) <= 0.0) return 0.0;
    float g = geometry_term(dot(n, s) / size, n_dot_v, n_dot_l, 0.5 * size, m, geometry);
    return d_beckmann(n, s, m) * g / (4.0 * n_dot_l * n_dot_v) * f_schlick(0.5 * size, f0);
}

float albedo_geometry(float theta_v, float m, int geometry) {
    // int D G / (4 n.v) dw_l, F = 1
    if (geometry == 0) return albedo_without_g(theta_v, m);
    return geometry == 1 ? albedo_cook_torrance(theta_v, m, 1.0) : albedo_smith(theta_v, m, geometry);
}
