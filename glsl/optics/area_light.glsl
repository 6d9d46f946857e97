#include "core/constants.glsl"
#include "core/angle.glsl"
#include "optics/projected_solid_angle.glsl"

// Gauss-Legendre, 4 points on [-1, 1], the weights for an interval of length 1
const float SMALL_AT[4] = float[4](-0.8611363116, -0.3399810436, 0.3399810436, 0.8611363116);
const float SMALL_WEIGHT[4] = float[4](0.1739274226, 0.3260725774, 0.3260725774, 0.1739274226);

float radiance_sphere(float radiant_flux, float radius) {
    // Area Lights: Phi = pi L times the area 4 pi r^2
    return radiant_flux / (2.0 * PI * radius) / (2.0 * PI * radius);
}

float radiance_disk(float radiant_flux, float radius) {
    // Area Lights: Phi = pi L times the area pi r^2, one side
    return radiant_flux / (PI * radius) / (PI * radius);
}

float radiance_panel(float radiant_flux, float panel_width, float panel_depth) {
    // Area Lights: Phi = pi L times the area w d, one side
    return radiant_flux / (PI * panel_width) / panel_depth;
}

float radiant_exitance_panel(float radiant_flux, float panel_width, float panel_depth) {
    // Area Lights: flux per area that leaves, M = pi L
    return radiant_flux / panel_width / panel_depth;
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

float irradiance_panel(float radiance, float light_x, float light_y, float light_height, float panel_width, float panel_depth, float panel_tilt, vec3 position) {
    // Lambert 1760, Photometria, cut at the horizon edge by edge; a small panel above it by 4 x 4 Gauss points
    vec3 seen = panel_view(light_x, light_y, light_height, panel_tilt, position);
    if (seen.z <= 0.0) return 0.0;
    vec3 way = vec3(light_x, light_y, light_height) - position;
    vec3 side = vec3(0.5 * panel_width, 0.0, 0.0), up = 0.5 * panel_depth * vec3(0.0, cos(panel_tilt), sin(panel_tilt));
    float reach = length(vec2(panel_width, panel_depth));
    if (way.z > up.z && way.z > -up.z && reach < 0.1 * length(way)) {
        float sum = 0.0;
        for (int i = 0; i < 16; i++) {
            float s = SMALL_AT[i / 4], t = SMALL_AT[i % 4];
            vec3 p = way + s * side + t * up;
            float r2 = dot(p, p);
            sum += SMALL_WEIGHT[i / 4] * SMALL_WEIGHT[i % 4] * p.z / r2 / r2;
        }
        return radiance * panel_width * panel_depth * seen.z * sum;
    }
    vec3 p = way - side - up, along = 2.0 * side;
    float sum = 0.0;
    vec2 enters = vec2(0.0), leaves = vec2(0.0); // where the outline crosses the horizon
    for (int i = 0; i < 4; i++) {
        vec3 q = p + along;
        if (p.z >= 0.0 || q.z >= 0.0) {
            vec3 a = p, b = q;
            if (p.z < 0.0) {
                a = vec3((p.xy * q.z - q.xy * p.z) / (q.z - p.z), 0.0);
            } else if (q.z < 0.0) {
                b = vec3((p.xy * q.z - q.xy * p.z) / (q.z - p.z), 0.0);
            }
            vec3 c = cross(a, b - a);
            float size = length(c);
            if (size > 0.0) sum += 0.5 * c.z / size * arctan2(size, dot(a, b));
            if (p.z < 0.0) enters = a.xy;
            if (q.z < 0.0) leaves = b.xy;
        }
        p = q;
        along = i == 0 ? 2.0 * up : i == 1 ? -2.0 * side : -2.0 * up;
    }
    float turn = arctan2(leaves.x * enters.y - leaves.y * enters.x, dot(leaves, enters)); // along the horizon
    return radiance * abs(sum + 0.5 * turn);
}

float irradiance_panel_centre(float radiance, float light_x, float light_y, float light_height, float panel_width, float panel_depth, float panel_tilt, vec3 position) {
    // Light Contribution of Area Lights (1): the whole panel as one punctual light in its middle
    vec3 way = vec3(light_x, light_y, light_height) - position;
    float facing = panel_view(light_x, light_y, light_height, panel_tilt, position).z, r2 = dot(way, way);
    if (facing <= 0.0 || way.z <= 0.0) return 0.0;
    return radiance * panel_width * panel_depth * facing / r2 * way.z / r2;
}
