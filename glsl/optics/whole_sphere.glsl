#include "core/constants.glsl"
#include "optics/solid_angle.glsl"
#include "optics/solid_angle_flat.glsl"

float plane_angle(float half_angle) {
    // Basic Concepts: an angle of the circle, opened to both sides
    return 2.0 * half_angle;
}

float cones_in_the_sphere(float half_angle) {
    // Solid Angles: omega_sphere = 4 pi
    return 4.0 * PI / solid_angle_cone(half_angle);
}

float sphere_less_cone(float half_angle) {
    // Solid Angles: what a round hole leaves of the sphere around one
    return solid_angle_cone(PI - half_angle);
}

float digits_after_cancellation(float size, float distance) {
    // Goldberg 1991: float32's 24 bits, less those that terms of size 1 share when their difference is (size / distance)^2
    return max(0.0, log2(16777216.0 * size * size / (distance * distance)) * 0.30103);
}

float winding_number(sampler2D triangles, vec3 eye) {
    // Jacobson, Kavan and Sorkine-Hornung 2013, generalized winding numbers
    return solid_angle_mesh(triangles, eye) / (4.0 * PI);
}
