#include "optics/area_light.glsl"
#include "optics/light_samples.glsl"
#include "optics/spherical_rectangle.glsl"

vec3 light_sample(int sampling, int level, int seed, int index) {
    // Light Contribution of Area Lights (1): (s, t, weight) of a sample; weights sum to the number of samples.
    // 0 fixed, 1 random, 2 stratified, 3 and 4 Sobol, 5 Gauss-Legendre
    if (sampling == 5) return gauss_sample(index, level) * vec3(1.0, 1.0, float(1 << (2 * level)));
    vec2 at = sampling == 0 ? grid_sample(index, level) : sampling == 1 ? random_sample(index, seed)
        : sampling == 2 ? stratified_sample(index, level, seed) : sobol_sample(index, seed);
    return vec3(at, 1.0);
}

float even_in_angle(float panel_width, float panel_depth, vec3 seen) {
    // Pharr 2023, pbrt-v4: 1 where samples even in solid angle are worth it, 0 for a panel far or thin, and behind it
    return seen.z > 0.0 && min(panel_width, panel_depth) > 0.03 * length(seen) ? 1.0 : 0.0;
}

vec3 panel_sample(float light_x, float light_y, float light_height, float panel_width, float panel_depth, float panel_tilt, vec3 position, int sampling, int level, int seed, int index) {
    // Light Contribution of Area Lights (1): where a sample lies on the panel; 4 and 5 are even in solid angle
    vec2 at = light_sample(sampling, level, seed, index).xy;
    vec3 seen = panel_view(light_x, light_y, light_height, panel_tilt, position);
    if (sampling < 4 || even_in_angle(panel_width, panel_depth, seen) < 0.5) return panel_point(light_x, light_y, light_height, panel_width, panel_depth, panel_tilt, at.x, at.y);
    float w = 0.5 * panel_width, d = 0.5 * panel_depth, c = cos(panel_tilt), s = sin(panel_tilt);
    vec3 p = spherical_rectangle_point(seen.x - w, seen.x + w, seen.y - d, seen.y + d, seen.z, at.x, at.y);
    return position + vec3(p.x, p.y * c - p.z * s, p.y * s + p.z * c);
}

float sample_flux(float radiance, float panel_width, float panel_depth, int level) {
    // Light Contribution of Area Lights (1): the flux of each of the punctual lights the panel is cut into, pi L A / N
    return PI * radiance * panel_width * panel_depth / float(1 << (2 * level));
}

float sample_share(vec3 to_sample) {
    // Light Contribution of Area Lights (1): n.l / r^3, what a sample gives per area, radiance and distance to its plane
    float r2 = dot(to_sample, to_sample);
    return max(to_sample.z, 0.0) / r2 / r2;
}

float irradiance_panel_sampled(float radiance, float light_x, float light_y, float light_height, float panel_width, float panel_depth, float panel_tilt, vec3 position, int sampling, int level, int seed) {
    // Light Contribution of Area Lights (1): the mean of L cos cos_light A / r^2, or of L cos Omega even in solid angle.
    // A loop for each kind: a processor that runs both sides of a branch leaves a loop of no rounds out
    vec3 seen = panel_view(light_x, light_y, light_height, panel_tilt, position);
    if (seen.z <= 0.0) return 0.0;
    int count = 1 << (2 * level), angles = sampling > 3 && even_in_angle(panel_width, panel_depth, seen) > 0.5 ? count : 0;
    float c = cos(panel_tilt), s = sin(panel_tilt), w = 0.5 * panel_width, d = 0.5 * panel_depth, sum = 0.0;
    vec3 side = vec3(panel_width, 0.0, 0.0), up = panel_depth * vec3(0.0, c, s);
    vec3 way = vec3(light_x, light_y, light_height) - position;
    for (int i = 0; i < (sampling == 0 ? count : 0); i++) {
        vec2 at = grid_sample(i, level);
        sum += sample_share(way + (at.x - 0.5) * side + (at.y - 0.5) * up);
    }
    for (int i = 0; i < (sampling == 1 ? count : 0); i++) {
        vec2 at = random_sample(i, seed);
        sum += sample_share(way + (at.x - 0.5) * side + (at.y - 0.5) * up);
    }
    for (int i = 0; i < (sampling == 2 ? count : 0); i++) {
        vec2 at = stratified_sample(i, level, seed);
        sum += sample_share(way + (at.x - 0.5) * side + (at.y - 0.5) * up);
    }
    for (int i = 0; i < (sampling == 3 ? count : 0); i++) {
        vec2 at = sobol_sample(i, seed);
        sum += sample_share(way + (at.x - 0.5) * side + (at.y - 0.5) * up);
    }
    for (int i = 0; i < (sampling > 3 && angles == 0 ? count : 0); i++) {
        vec3 at = sampling == 5 ? gauss_sample(i, level) * vec3(1.0, 1.0, float(count)) : vec3(sobol_sample(i, seed), 1.0);
        sum += at.z * sample_share(way + (at.x - 0.5) * side + (at.y - 0.5) * up);
    }
    if (angles == 0) return radiance * panel_width * panel_depth * seen.z * sum / float(count);
    vec2 x = vec2(seen.x - w, seen.x + w), y = vec2(seen.y - d, seen.y + d);
    vec2 strips = vec2(strip_angle(x.x, y.x, y.y, seen.z), strip_angle(x.y, y.x, y.y, seen.z));
    for (int i = 0; i < angles; i++) {
        vec3 at = sampling == 5 ? gauss_sample(i, level) * vec3(1.0, 1.0, float(count)) : vec3(sobol_sample(i, seed), 1.0);
        float px = clamp(strip_end(mix(strips.x, strips.y, at.x), y.x, y.y, seen.z), x.x, x.y);
        float py = strip_across(px, y.x, y.y, seen.z, at.y);
        sum += at.z * max(py * s + seen.z * c, 0.0) / length(vec3(px, py, seen.z));
    }
    return radiance * solid_angle_rectangle_off_axis(x.x, x.y, y.x, y.y, seen.z) * sum / float(count);
}

float irradiance_panel_without_cosine(float radiance, float light_x, float light_y, float light_height, float panel_width, float panel_depth, float panel_tilt, vec3 position, int level) {
    // Light Contribution of Area Lights (1), misread: samples that shine alike in every direction, without cos_light
    vec3 seen = panel_view(light_x, light_y, light_height, panel_tilt, position);
    if (seen.z <= 0.0) return 0.0;
    vec3 side = vec3(panel_width, 0.0, 0.0), up = panel_depth * vec3(0.0, cos(panel_tilt), sin(panel_tilt));
    vec3 way = vec3(light_x, light_y, light_height) - position;
    float sum = 0.0;
    int count = 1 << (2 * level);
    for (int i = 0; i < count; i++) {
        vec2 at = grid_sample(i, level);
        vec3 p = way + (at.x - 0.5) * side + (at.y - 0.5) * up;
        sum += length(p) * sample_share(p);
    }
    return radiance * panel_width * panel_depth * sum / float(count);
}
