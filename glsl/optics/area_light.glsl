#include "core/constants.glsl"
#include "core/angle.glsl"
#include "optics/projected_solid_angle.glsl"

// Abramowitz and Stegun 25.4.30: Gauss-Legendre on [0, 1] with 4 points
const float SMALL_AT[4] = float[4](0.0694318442, 0.3300094782, 0.6699905218, 0.9305681558);
const float SMALL_WEIGHT[4] = float[4](0.1739274226, 0.3260725774, 0.3260725774, 0.1739274226);

float radiance_sphere(float radiant_flux, float radius) {
    // Area Lights: Phi = pi L times the area 4 pi r^2
    return radiant_flux / (2.0 * PI * radius) / (2.0 * PI * radius);
}

float irradiance_sphere_light(float radiance, float radius, float distance, float theta) {
    // Light Contribution of Area Lights (1): the radiance times the projected solid angle
    return radiance * projected_solid_angle_sphere(radius, distance, theta);
}

float irradiance_lamp(float radiant_flux, float radius, float distance, float theta) {
    // Punctual Lights: a sphere of a given flux; above the horizon the point light Phi / (4 pi r^2) cos, however large
    return irradiance_sphere_light(radiance_sphere(radiant_flux, radius), radius, distance, theta);
}

float irradiance_disk_light(float radiance, float radius, float height, float offset) {
    // Light Contribution of Area Lights (1): a disk parallel to the floor
    return radiance * projected_solid_angle_disk(radius, height, offset);
}

float irradiance_polygon_light(float radiance, vec3 corners[MAX_CORNERS], int corner_count) {
    // Light Contribution of Area Lights (1): a flat outline, cut at the horizon
    return radiance * projected_solid_angle_polygon(corners, corner_count);
}

vec3 panel_point(float light_x, float light_y, float light_height, float panel_width, float panel_depth, float panel_tilt, float s, float t) {
    // Area Lights: the panel over (s, t), its middle at 1/2, 1/2, turned about its own x axis
    float up = (t - 0.5) * panel_depth;
    return vec3(light_x + (s - 0.5) * panel_width, light_y + up * cos(panel_tilt), light_height + up * sin(panel_tilt));
}

vec3 panel_view(float light_x, float light_y, float light_height, float panel_tilt, vec3 position) {
    // Area Lights: the panel's middle from a point, along its width, its depth and its back; z <= 0 is behind it
    vec3 way = vec3(light_x, light_y, light_height) - position;
    float c = cos(panel_tilt), s = sin(panel_tilt);
    return vec3(way.x, way.y * c + way.z * s, way.z * c - way.y * s);
}

vec2 outline_at(int corner_count, int index) {
    // Area Lights: a corner of the outline in the unit square, after the last the first; 3 a triangle, 4 the whole, 5 a
    // pentagon
    int i = index < corner_count ? index : 0;
    if (corner_count == 4) return vec2(i == 1 || i == 2 ? 1.0 : 0.0, i >= 2 ? 1.0 : 0.0);
    if (corner_count == 3) return i == 0 ? vec2(0.5, 0.0) : vec2(i == 1 ? 1.0 : 0.0, 1.0);
    return i == 0 ? vec2(0.5, 0.0) : i == 1 ? vec2(1.0, 0.4) : i == 2 ? vec2(0.8, 1.0) : i == 3 ? vec2(0.2, 1.0) : vec2(0.0, 0.4);
}

float irradiance_outline(int corner_count, float radiance, float light_x, float light_y, float light_height, float panel_width, float panel_depth, float panel_tilt, vec3 position) {
    // Lambert 1760, Photometria, cut at the horizon edge by edge; a small outline above it by 4 x 4 Gauss points a triangle
    vec3 seen = panel_view(light_x, light_y, light_height, panel_tilt, position);
    if (seen.z <= 0.0) return 0.0;
    vec3 way = vec3(light_x, light_y, light_height) - position;
    vec3 side = vec3(panel_width, 0.0, 0.0), up = panel_depth * vec3(0.0, cos(panel_tilt), sin(panel_tilt));
    float sum = 0.0;
    if (way.z > 0.5 * abs(up.z) && length(vec2(panel_width, panel_depth)) < 0.1 * length(way)) {
        vec2 a = outline_at(corner_count, 0);
        for (int k = 2; k < 5; k++) { // of fewer corners the last are without area
            vec2 b = outline_at(corner_count, k - 1) - a, c = outline_at(corner_count, k) - a - b;
            float part = 0.0;
            for (int i = 0; i < 16; i++) {
                float u = SMALL_AT[i / 4];
                vec2 at = a + u * (b + SMALL_AT[i % 4] * c) - 0.5;
                vec3 p = way + at.x * side + at.y * up;
                float r2 = dot(p, p);
                part += SMALL_WEIGHT[i / 4] * SMALL_WEIGHT[i % 4] * u * p.z / r2 / r2;
            }
            sum += part * (b.x * c.y - b.y * c.x);
        }
        return radiance * panel_width * panel_depth * seen.z * sum;
    }
    vec2 at = outline_at(corner_count, 0) - 0.5;
    vec3 p = way + at.x * side + at.y * up;
    vec2 enters = vec2(0.0), leaves = vec2(0.0); // where the outline crosses the horizon
    for (int i = 1; i <= 5; i++) { // of fewer corners the last have no length; a fixed number is unrolled
        vec2 next = outline_at(corner_count, i) - 0.5, step = next - at;
        vec3 q = way + next.x * side + next.y * up;
        if (p.z >= 0.0 || q.z >= 0.0) {
            vec3 a = p, b = q, along = step.x * side + step.y * up;
            if (p.z < 0.0) {
                a = vec3((p.xy * q.z - q.xy * p.z) / (q.z - p.z), 0.0);
                along = b - a;
            } else if (q.z < 0.0) {
                b = vec3((p.xy * q.z - q.xy * p.z) / (q.z - p.z), 0.0);
                along = b - a;
            }
            vec3 c = cross(a, along);
            float size = length(c);
            if (size > 0.0) sum += 0.5 * c.z / size * arctan2(size, dot(a, b));
            if (p.z < 0.0) enters = a.xy;
            if (q.z < 0.0) leaves = b.xy;
        }
        p = q;
        at = next;
    }
    float turn = arctan2(leaves.x * enters.y - leaves.y * enters.x, dot(leaves, enters)); // along the horizon
    return radiance * abs(sum + 0.5 * turn);
}
