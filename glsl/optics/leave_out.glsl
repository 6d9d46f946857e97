#include "optics/cook_torrance.glsl"
#include "optics/materials.glsl"
#include "optics/shape_samples.glsl"

// What stands in for a full formula where the values allow it, and the error that this costs

float irradiance_light_point(int light_shape, float radiance, float light_x, float light_y, float light_height, float panel_width, float panel_depth, float panel_tilt, vec3 position) {
    // Punctual Lights: all of an area light in its middle, L A cos / r^2 times n.l
    vec3 way = vec3(light_x, light_y, light_height) - position;
    float r2 = dot(way, way), r = sqrt(r2), seen = light_area(light_shape, panel_width, panel_depth);
    if (light_shape == 2) seen *= 0.25;
    else seen *= max(panel_view(light_x, light_y, light_height, light_shape == 1 ? 0.0 : panel_tilt, position).z, 0.0) / r;
    return radiance * seen * max(way.z, 0.0) / (r2 * r);
}

float irradiance_light_64(int light_shape, float radiance, float light_x, float light_y, float light_height, float panel_width, float panel_depth, float panel_tilt, vec3 position) {
    // Light Contribution of Area Lights (1): 64 samples of its area, though there is one formula
    return irradiance_light_sampled(light_shape, radiance, light_x, light_y, light_height, panel_width, panel_depth, panel_tilt, position, 2, 3, 1);
}

float point_light_error(int light_shape, float light_height, float panel_width, float panel_tilt) {
    // Punctual Lights: the largest error of the point on a floor of 1.2 m x 3 m, over the brightest place of it
    float worst = 0.0, brightest = 0.0;
    for (int i = 0; i < 21; i++) {
        vec3 at = vec3(0.3 * float(i % 3), 0.5 * float(i / 3 - 3), 0.0);
        float exact = irradiance_light(light_shape, 1.0, 0.0, 0.0, light_height, panel_width, panel_width, panel_tilt, at);
        worst = max(worst, abs(irradiance_light_point(light_shape, 1.0, 0.0, 0.0, light_height, panel_width, panel_width, panel_tilt, at) - exact));
        brightest = max(brightest, exact);
    }
    return brightest > 0.0 ? worst / brightest : 0.0;
}

float point_lights_error(float light_height, float panel_width, float panel_tilt) {
    // Punctual Lights: the same of the worst of the four shapes
    float worst = 0.0;
    for (int i = 0; i < 4; i++) worst = max(worst, point_light_error(i, light_height, panel_width, panel_tilt));
    return worst;
}

// f_material(1, material) of the metals
const vec3 METAL_F0[5] = vec3[5](vec3(1.03460259, 0.72797254, 0.36533686), vec3(0.98932617, 0.98392153, 0.97784418), vec3(0.92871967, 0.62315060, 0.52233340), vec3(0.52969190, 0.51324382, 0.49426760), vec3(0.90728236, 0.91580660, 0.92231375));

vec3 f_material_schlick(float l_dot_h, int material) {
    // Schlick 1994, from the exact shares head-on, in place of twelve wavelengths
    if (material < INSULATORS) return vec3(f_schlick(l_dot_h, f0_from_eta(material_eta(material))));
    vec3 f0 = METAL_F0[clamp(material - INSULATORS, 0, 4)];
    return vec3(f_schlick(l_dot_h, f0.r), f_schlick(l_dot_h, f0.g), f_schlick(l_dot_h, f0.b));
}

float cook_torrance_open(vec3 n, vec3 l, vec3 v, float m) {
    // The Cook - Torrance Model (2), with 1/4 and G = 1: all facets are seen and lit
    float n_dot_l = dot(n, l), n_dot_v = dot(n, v);
    return min(n_dot_l, n_dot_v) > 0.0 ? d_beckmann(n, l + v, m) / (4.0 * n_dot_l * n_dot_v) : 0.0;
}

float cook_torrance_open_error(float theta_d, float m) {
    // The most that G = 1 adds to the light of a lamp on any normal up to n.v = 0.01, over the highlight's peak; at most
    // 10. Facets are hidden soonest in the plane of l and v; the line of sight may be 4 degrees off
    float reach = max(1.4907963 - theta_d, 0.02), worst = 0.0, peak = 0.0;
    for (int i = -128; i <= 128; i++) {
        float a = reach * float(i) / 128.0, c = cos(a), t = sin(a) / c;
        float n_dot_v = sin(0.01 + reach * float(128 - i) / 128.0), n_dot_l = sin(0.01 + reach * float(128 + i) / 128.0);
        float open = d_beckmann_slope(t * t, m) / n_dot_v;
        float g = min(1.0, 2.0 * c * min(n_dot_v, n_dot_l) / sin(0.01 + reach));
        worst = max(worst, open * (1.0 - g));
        peak = max(peak, open * g);
    }
    return peak > 0.0 ? min(worst / peak, 10.0) : 0.0;
}
