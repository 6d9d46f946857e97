#include "core/constants.glsl"
#include "optics/solid_angle.glsl"

vec3 outline_corner(vec2 corner_a, vec2 corner_b, vec2 corner_c, vec2 corner_d, vec2 corner_e, int corner_count, float size, float distance, int index) {
    // Solid Angles: a corner of the outline in the plane z = distance, counted around
    int i = index % corner_count;
    vec2 corner = i == 0 ? corner_a : i == 1 ? corner_b : i == 2 ? corner_c : i == 3 ? corner_d : corner_e;
    return vec3(size * corner, distance);
}

float solid_angle_outline(vec2 corner_a, vec2 corner_b, vec2 corner_c, vec2 corner_d, vec2 corner_e, int corner_count, float size, float distance, float x, float y) {
    // Solid Angles: the outline seen from (x, y, 0), a fan of triangles by their edges
    vec3 a = vec3(size * corner_a - vec2(x, y), distance);
    vec3 ab = vec3(size * (corner_b - corner_a), 0.0), ac = vec3(size * (corner_c - corner_a), 0.0);
    vec3 ad = vec3(size * (corner_d - corner_a), 0.0), ae = vec3(size * (corner_e - corner_a), 0.0);
    float sum = solid_angle_triangle_edges(a, ab, ac);
    if (corner_count > 3) sum += solid_angle_triangle_edges(a, ac, ad);
    if (corner_count > 4) sum += solid_angle_triangle_edges(a, ad, ae);
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
