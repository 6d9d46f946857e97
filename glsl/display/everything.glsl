#include "optics/area_light.glsl"
#include "optics/beckmann.glsl"
#include "optics/coat.glsl"
#include "optics/eon.glsl"
#include "optics/exposure.glsl"
#include "optics/light_samples.glsl"
#include "optics/maps.glsl"
#include "optics/materials.glsl"
#include "optics/punctual.glsl"
#include "optics/smith.glsl"
#include "optics/spot.glsl"

uniform sampler2D roughness_map;

// What one shader for all scenes computes, whether a scene needs it or not: the yardstick of `halfway inspect --all`.

vec3 everything_reflects(vec3 n, vec3 l, vec3 v, float m, float mask) {
    // A metal and a rough coated body, mixed by the mask
    vec3 h = l + v, f0 = material_f0(7);
    float n_dot_l = max(dot(n, l), 0.0), n_dot_v = max(dot(n, v), 1e-4), l_dot_h = min(0.5 * length(h), 1.0);
    float facets = d_beckmann(n, h, m) * g_smith_correlated(n_dot_v, max(n_dot_l, 1e-4), m) / (4.0 * n_dot_v);
    vec3 metal = facets * vec3(f_f82(l_dot_h, f0.r, 0.9), f_f82(l_dot_h, f0.g, 0.6), f_f82(l_dot_h, f0.b, 0.5));
    float coat = brdf_cook_torrance(n, l, v, 0.05, 0.04) * n_dot_l;
    float body = brdf_eon(n, l, v, 0.6, m) * body_share(n_dot_l, n_dot_v, l_dot_h, 0.04, 3) * n_dot_l;
    return mix(vec3(coat + body), metal, mask);
}

vec3 everything(vec3 position, vec3 n, vec3 v) {
    // A point light, a spotlight, an area light of 16 samples; maps of roughness and metal; exposure and tone curve
    vec2 place = fract(position.xy + position.z);
    float m = 0.1 + 0.5 * stored_roughness(roughness_map, place.x, place.y), mask = map_pattern(place.x, place.y);
    vec3 sum = vec3(0.0), lamp = vec3(2.0, -2.0, 3.0), spot = vec3(-2.0, -1.0, 4.0);
    sum += irradiance_at(position, n, lamp, 20.0, 0.05) * everything_reflects(n, direction_to_light(position, lamp), v, m, mask);
    vec3 to_spot = direction_to_light(position, spot);
    float cone = spot_smooth(arccos(clamp(dot(to_spot, normalize(spot)), -1.0, 1.0)), 0.3, 0.6);
    sum += cone * irradiance_at(position, n, spot, 30.0, 0.05) * everything_reflects(n, to_spot, v, m, mask);
    for (int i = 0; i < 16; i++) {
        vec2 st = stratified_sample(i, 2, int(gl_FragCoord.x));
        vec3 away = panel_point(0.5, 0.5, 2.5, 1.0, 1.0, 0.3, st.x, st.y) - position, l = normalize(away);
        sum += everything_reflects(n, l, v, m, mask) * (0.5 / dot(away, away));
    }
    return vec3(tone_curve(sum.r, 2), tone_curve(sum.g, 2), tone_curve(sum.b, 2));
}
