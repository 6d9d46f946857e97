#include "core/constants.glsl"
#include "core/power.glsl"
#include "optics/spherical.glsl"

float radiant_intensity_of(float radiant_flux, int distribution, float exponent, float theta) {
    // Lighting Distribution (1): I = Phi f_e; f_e is 0 constant, 1 cosine, 2 cos^n, all directions summing to 1
    if (distribution == 0) return radiant_flux * 0.25 / PI;
    float n = distribution == 1 ? 1.0 : exponent, s = sin(0.5 * theta);
    float root = theta < 0.5 * PI ? cosine_power(cos(theta), 2.0 * s * s, 0.5 * n) : 0.0; // its square may be too small
    return (n + 1.0) / (2.0 * PI) * root * (radiant_flux * root);
}

float emission(int distribution, float exponent, float theta) {
    // Lighting Distribution (1): f_e, the intensity of one watt
    return radiant_intensity_of(1.0, distribution, exponent, theta);
}

float radiant_flux_of(float radiant_intensity, float exponent) {
    // Lighting Distribution (1): the integral of I cos^n over the hemisphere
    return 2.0 * PI * radiant_intensity / (exponent + 1.0);
}

float irradiance_distribution(float radiant_flux, int distribution, float exponent, float height, float offset) {
    // Lighting Distribution (3): a lamp that looks straight down, on the floor
    float d = length(vec2(height, offset)), n = distribution == 0 ? 0.0 : distribution == 1 ? 1.0 : exponent;
    float root = cosine_power(height / d, offset / d * (offset / (d + height)), 0.5 * n);
    float scale = (distribution == 0 ? 0.5 : n + 1.0) / (2.0 * PI);
    return scale * root * (radiant_flux / d * root) * (height / d) / d;
}

vec3 photometric_solid(int distribution, float exponent, float s, float t) {
    // Lighting Distribution (2): each direction as far out as its intensity, 2 m for 1/sr, around a lamp looking down
    float theta = PI * t;
    vec3 out_there = direction(theta, 2.0 * PI * s);
    return 2.0 * emission(distribution, exponent, theta) * vec3(out_there.xy, -out_there.z);
}
