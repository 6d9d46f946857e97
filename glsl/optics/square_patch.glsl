#include "core/constants.glsl"
#include "optics/spherical.glsl"
#include "optics/solid_angle.glsl"
#include "optics/projected_solid_angle.glsl"

vec3 patch_point(float theta, float phi, float distance, float tilt, float width, float s, float t) {
    // Solid Angles: the square over (s, t), its centre in the direction (theta, phi), turned about a horizontal axis
    vec3 outward = direction(theta, phi), down = direction_theta(theta, phi), side = direction_phi(phi);
    return distance * outward + width * ((s - 0.5) * side + (t - 0.5) * (cos(tilt) * down + sin(tilt) * outward));
}

vec3 patch_normal(float theta, float phi, float tilt) {
    // Solid Angles: towards the eye at tilt 0, down to the base plane at tilt pi/2
    return sin(tilt) * direction_theta(theta, phi) - cos(tilt) * direction(theta, phi);
}

float solid_angle_patch(float distance, float tilt, float width) {
    // Solid Angles: the square is a rectangle off the axis of its own plane
    float slide = distance * sin(tilt), h = 0.5 * width;
    return solid_angle_rectangle_off_axis(-h, h, slide - h, slide + h, abs(distance * cos(tilt)));
}

float solid_angle_patch_small(float distance, float tilt, float width) {
    // Solid Angles: dA cos / r^2
    float seen = width / distance;
    return seen * seen * abs(cos(tilt));
}

float solid_angle_patch_counted(float theta, float phi, float distance, float tilt, float width, int samples) {
    // Solid Angles: 4 pi times the share of evenly spread directions that meet the square
    vec3 outward = direction(theta, phi), down = direction_theta(theta, phi), side = direction_phi(phi);
    int hits = 0;
    for (int i = 0; i < samples; i++) {
        vec3 d = fibonacci_direction(i, samples);
        float along = dot(d, outward), fall = dot(d, down);
        float way = distance * cos(tilt) / (along * cos(tilt) - fall * sin(tilt)); // to the square's plane
        float x = way * dot(d, side), y = way * (fall * cos(tilt) + along * sin(tilt)) - distance * sin(tilt);
        if (way > 0.0 && max(abs(x), abs(y)) <= 0.5 * width) hits++;
    }
    return 4.0 * PI * float(hits) / float(samples);
}

float projected_solid_angle_patch(float theta, float distance, float tilt, float width) {
    // Basic Concepts: the square's shadow on the base disk, cut at the horizon
    vec3 corners[MAX_CORNERS];
    corners[0] = patch_point(theta, 0.0, distance, tilt, width, 0.0, 0.0);
    corners[1] = patch_point(theta, 0.0, distance, tilt, width, 1.0, 0.0);
    corners[2] = patch_point(theta, 0.0, distance, tilt, width, 1.0, 1.0);
    corners[3] = patch_point(theta, 0.0, distance, tilt, width, 0.0, 1.0);
    return projected_solid_angle_polygon(corners, 4);
}

float projected_solid_angle_patch_small(float theta, float distance, float tilt, float width) {
    // Basic Concepts: dA cos / r^2 times the cosine at the surface
    return solid_angle_patch_small(distance, tilt, width) * max(0.0, cos(theta));
}
