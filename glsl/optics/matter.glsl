#include "optics/beckmann.glsl"
#include "optics/blinn_phong.glsl"
#include "optics/coat.glsl"
#include "optics/cook_torrance.glsl"
#include "optics/materials.glsl"

const vec3 RED_BODY = vec3(0.55, 0.05, 0.04);

float matter_body(int material, int channel) {
    // Plausible Shading - BRDFs: metals have none
    return material < INSULATORS ? RED_BODY[channel] : 0.0;
}

float brdf_matter(vec3 n, vec3 l, vec3 v, float m, int material, int channel) {
    // Comparison (1), (2): Cook-Torrance with the measured F
    if (min(dot(n, l), dot(n, v)) <= 0.0) return 0.0;
    float f = clamp(f_material(min(0.5 * length(l + v), 1.0), material)[channel], 0.0, 1.0);
    float f0 = clamp(f_material(1.0, material)[channel], 0.0, 1.0);
    return cook_torrance_dg(n, l, v, m) * f + body_coupled(dot(n, l), dot(n, v), matter_body(material, channel), f0);
}

float brdf_matter_blinn(vec3 n, vec3 l, vec3 v, float m, int material, int channel) {
    // Comparison (1), (2): Blinn-Phong, as wide, and as bright head-on
    float k_s = clamp(f_material(1.0, material)[channel], 0.0, 1.0);
    return brdf_blinn_phong(n, l, v, matter_body(material, channel) * (1.0 - k_s), k_s, exponent_from_m(min(m, 1.0)));
}

float gain_cook_torrance(float theta_d, int material, int channel) {
    // The Cook - Torrance Model (2): F / (F0 cos), by D's peak and G = 1
    float c = cos(theta_d), f0 = clamp(f_material(1.0, material)[channel], 0.0, 1.0);
    return clamp(f_material(c, material)[channel], 0.0, 1.0) / (f0 * c);
}

float gain_blinn_phong(float theta_d) {
    // Blinn-Phong BRDF (2): n.l is all that changes
    return cos(theta_d);
}
