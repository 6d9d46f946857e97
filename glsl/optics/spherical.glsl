#include "core/constants.glsl"

vec3 direction(float theta, float phi) {
    // Solid Angles: spherical coordinates, theta from +z, phi from +x towards +y
    return vec3(sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta));
}

vec3 direction_theta(float theta, float phi) {
    // Solid Angles: the unit vector along which theta grows
    return vec3(cos(theta) * cos(phi), cos(theta) * sin(phi), -sin(theta));
}

vec3 direction_phi(float phi) {
    // Solid Angles: the unit vector along which phi grows
    return vec3(-sin(phi), cos(phi), 0.0);
}

vec3 light_direction(float theta_l, float phi) {
    // The BRDF (2): l, n being +z; phi = pi is the mirror side of the eye
    return direction(theta_l, phi);
}

vec3 view_direction(float theta_v) {
    // The BRDF (2): v, n being +z, in the half plane of +x
    return vec3(sin(theta_v), 0.0, cos(theta_v));
}

vec3 light_and_view(float theta_l, float theta_v, float phi) {
    // The Blinn Model: l + v along h; sums of sines as products, for l and v on opposite sides
    float turn = cos(0.5 * phi), aside = cos(0.5 * (theta_v + theta_l)) * sin(0.5 * (theta_v - theta_l));
    return vec3(2.0 * (aside + sin(theta_l) * turn * turn), sin(theta_l) * sin(phi), cos(theta_l) + cos(theta_v));
}

vec3 fibonacci_direction(int index, int samples) {
    // Swinbank and Purser 2006, Fibonacci grids; the golden turn in 32-bit integers, where it cannot round
    float turn = float(int(uint(index) * 2654435769u)) / 4294967296.0; // -1/2 .. 1/2
    float above = float(2 * index + 1), below = float(2 * (samples - index) - 1), n = float(samples);
    float r = sqrt(above * below) / n, phi = 2.0 * PI * turn; // above = n (1 - z), below = n (1 + z)
    return vec3(r * cos(phi), r * sin(phi), 0.5 * (below - above) / n);
}

vec3 fibonacci_direction_naive(int index, int samples) {
    // The same turns, in equal steps of the polar angle: too many near the poles, where the rings are small
    float turn = float(int(uint(index) * 2654435769u)) / 4294967296.0, theta = PI * float(2 * index + 1) / float(2 * samples);
    return direction(theta, 2.0 * PI * turn);
}

vec3 sphere_point(float s, float t) {
    // Solid Angles: the unit sphere over the unit square
    return direction(PI * t, 2.0 * PI * s);
}

vec3 cap_point(float half_angle, float s, float t) {
    // Solid Angles: the cap a cone about +z cuts out of the unit sphere
    return direction(half_angle * t, 2.0 * PI * s);
}
