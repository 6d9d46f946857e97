#include "core/constants.glsl"
#include "optics/solid_angle_flat.glsl"

vec3 outline_corner(vec2 corner_a, vec2 corner_b, vec2 corner_c, vec2 corner_d, vec2 corner_e, int corner_count, float size, float distance, int index) {
    // Solid Angles: a corner of the outline in the plane z = distance, counted around
    int i = index % corner_count;
    vec2 corner = i == 0 ? corner_a : i == 1 ? corner_b : i == 2 ? corner_c : i == 3 ? corner_d : corner_e;
    return vec3(size * corner, distance);
}

float solid_angle_outline(vec2 corner_a, vec2 corner_b, vec2 corner_c, vec2 corner_d, vec2 corner_e, int corner_count, float size, float distance, float x, float y) {
    // Solid Angles: the outline seen from (x, y, 0), a fan of faces from its first corner
    vec2 corners[5] = vec2[5](corner_a, corner_b, corner_c, corner_d, corner_e);
    vec3 eye = vec3(x, y, 0.0), a = vec3(size * corner_a, distance);
    float sum = 0.0;
    for (int i = 2; i < corner_count; i++) {
        sum += solid_angle_face(a, vec3(size * corners[i - 1], distance), vec3(size * corners[i], distance), eye);
    }
    return abs(sum);
}

float solid_angle_outline_naive(vec2 corner_a, vec2 corner_b, vec2 corner_c, vec2 corner_d, vec2 corner_e, int corner_count, float size, float distance, float x, float y) {
    // Solid Angles: the same with van Oosterom and Strackee 1983 as printed
    vec3 corners[MAX_CORNERS], eye = vec3(x, y, 0.0);
    corners[0] = vec3(size * corner_a, distance) - eye;
    corners[1] = vec3(size * corner_b, distance) - eye;
    corners[2] = vec3(size * corner_c, distance) - eye;
    corners[3] = vec3(size * corner_d, distance) - eye;
    corners[4] = vec3(size * corner_e, distance) - eye;
    return solid_angle_polygon_naive(corners, corner_count);
}
