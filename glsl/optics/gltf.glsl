#include "core/constants.glsl"
#include "optics/beckmann.glsl"
#include "optics/coat.glsl"
#include "optics/fresnel.glsl"
#include "optics/ggx.glsl"

float alpha_gltf(float roughness) {
    // pyrender, mesh.frag; glTF 2.0, appendix B
    float kept = clamp(roughness, 0.04, 1.0);
    return kept * kept;
}

float roughness_gltf(float m) {
    // Walter et al. 2007: alpha = m has the same peak of D
    return clamp(sqrt(m), 0.04, 1.0);
}

float g_gltf(float n_dot_l, float n_dot_v, float roughness) {
    // Karis 2013, Real Shading in Unreal Engine 4, as pyrender has it; Schlick 1994
    float nl = clamp(n_dot_l, 0.001, 1.0), nv = clamp(abs(n_dot_v), 0.001, 1.0), r = clamp(roughness, 0.04, 1.0) + 1.0;
    float k = r * r / 8.0;
    return nl / (nl * (1.0 - k) + k) * (nv / (nv * (1.0 - k) + k));
}

float shading_gltf(vec3 n, vec3 l, vec3 v, float base_colour, float metallic, float roughness) {
    // pyrender, mesh.frag, compute_brdf; D from l + v, where nothing cancels
    vec3 s = l + v;
    float n_dot_l = dot(n, l), n_dot_v = dot(n, v), alpha = alpha_gltf(roughness), metal = clamp(metallic, 0.0, 1.0);
    float nl = clamp(n_dot_l, 0.001, 1.0), nv = clamp(abs(n_dot_v), 0.001, 1.0);
    float fresnel = f_schlick(0.5 * length(s), 0.04 * (1.0 - metal) + base_colour * metal);
    float d = dot(n, s) > 0.0 ? d_ggx_slope(slope_squared(n, s), alpha) : alpha * alpha / PI;
    float body = (1.0 - fresnel) * 0.96 * (1.0 - metal) * base_colour / PI;
    return nl * (body + fresnel * g_gltf(n_dot_l, n_dot_v, roughness) * d / (4.0 * nl * nv + 0.001));
}

float brdf_gltf(vec3 n, vec3 l, vec3 v, float base_colour, float metallic, float roughness) {
    // pyrender, mesh.frag; without light from below
    float n_dot_l = dot(n, l);
    if (min(n_dot_l, dot(n, v)) <= 0.0) return 0.0;
    return shading_gltf(n, l, v, base_colour, metallic, roughness) / clamp(n_dot_l, 0.001, 1.0);
}

const vec3 COPPER = vec3(0.95, 0.50, 0.28);

float brdf_file(vec3 n, vec3 l, vec3 v, float metallic, float roughness, int mapped, int channel) {
    // Ours with m = roughness or its square, over a body coupled in and out; or glTF's own
    float colour = COPPER[channel], metal = clamp(metallic, 0.0, 1.0), alpha = alpha_gltf(roughness);
    if (mapped == 2) return brdf_gltf(n, l, v, colour, metal, roughness);
    float m = mapped == 0 ? sqrt(alpha) : alpha, f0 = 0.04 * (1.0 - metal) + colour * metal;
    return brdf_coated(n, l, v, 0.96 * (1.0 - metal) * colour, m, f0, 3);
}

float peak_lost(float roughness) {
    // Distribution Term (2): D(0) = 1 / (pi m^2); glTF 2.0: m = roughness^2
    return 1.0 / alpha_gltf(roughness);
}
