#include "core/constants.glsl"
#include "optics/beckmann.glsl"

float d_ggx_slope(float slope2, float alpha) {
    // Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces; Trowbridge and Reitz 1975
    alpha = max(alpha, SMOOTHEST);
    float k = (1.0 + slope2) / (alpha + slope2 / alpha);
    return k * k / PI;
}

float d_ggx(vec3 n, vec3 h, float alpha) {
    // Walter et al. 2007; h of any length
    return dot(n, h) > 0.0 ? d_ggx_slope(slope_squared(n, h), alpha) : 0.0;
}

vec3 sample_ggx(float xi_1, float xi_2, float alpha) {
    // Walter et al. 2007: tan^2 a = alpha^2 xi_1 / (1 - xi_1)
    float t = min(xi_1, 0.99999994);
    float rise = max(alpha, SMOOTHEST) * sqrt(t), run = sqrt(1.0 - t);
    return vec3(rise * cos(2.0 * PI * xi_2), rise * sin(2.0 * PI * xi_2), run) / sqrt(rise * rise + run * run);
}

float pdf_ggx(vec3 n, vec3 l, vec3 v, float alpha) {
    // Walter et al. 2007: D (n.h) / (4 l.h), both from l + v
    vec3 both = l + v;
    float along = dot(n, both);
    return along > 0.0 ? d_ggx(n, both, alpha) * along / (2.0 * dot(both, both)) : 0.0;
}
